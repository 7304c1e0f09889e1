(** * Proof of S1-S3, Theorem 2, the summary and the record form about motions and orbits

    Each is the theorem about signs, followed by what [orbit] and [no_orbit] mean. *)

From Coq Require Import Reals Arith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane Headline StatementSystems Systems Disc Radius Above AppendixA
  Summary InsideTriangle.
Open Scope R_scope.

Theorem S1_S3 : S1_S3_statement.
Proof.
  intros r s n m Hn Hc; split; [|split].
  - intros ->; apply (born_exactly _ _ _ _ _ Hn), S1_stated; assumption.
  - intros Hm Hg; apply (no_orbit_never _ _ _ Hn), (S2_proof r s n m Hn Hm Hc), Hg.
  - intros Hm F; destruct (S3_stated r s n m F Hn Hm Hc) as [H1 H2]; split; intros H.
    + destruct (H1 H) as [_ _ Hp Hm' _]; split; intros Hb; [apply born_exactly | apply no_orbit_never]; auto.
    + destruct (H2 H) as [_ _ Hp Hm' _]; split; intros Hb; [apply born_exactly | apply no_orbit_never]; auto.
Qed.

Theorem Theorem_2 : Theorem_2_statement.
Proof.
  intros n s Hn Hs; destruct (Theorem2_stated n s Hn Hs) as [H1 H2]; unfold orbit_at, no_orbit_at, u_at, trace in *.
  replace (2 * 1 * cos (2 * PI * s)) with (2 * cos (2 * PI * s)) in * by ring; rewrite pow1 in *; split.
  - intros e g lo hi HI Hin; apply born_exactly; [lia|]; apply H1; exists lo, hi; auto.
  - intros Hout Hu; apply no_orbit_never; [lia | apply H2; assumption].
Qed.

(** With no zero among the signs, what does not hold fails. *)
Lemma decided_fails a1 a2 n e g : no_zeros a1 a2 n -> ~ orbit a1 a2 n e g -> fails a1 a2 n e g.
Proof.
  intros (Hu & Hc & Hb) Hno; destruct (Classical_Prop.classic (fails a1 a2 n e g)) as [H|H]; [exact H|].
  exfalso; apply Hno; split; [exact Hu | split].
  - intros k Hk; destruct (Rtotal_order (sgn e * b a1 a2 n k) 0) as [Hlt|[Heq|Hgt]]; [|exfalso|exact Hgt].
    + exfalso; apply H; left; exists k; auto.
    + apply (Hb k Hk); destruct e; cbn [sgn] in Heq; lra.
  - destruct (Rtotal_order (sgn e * sgn g * c a1 a2 n) 0) as [Hlt|[Heq|Hgt]]; [|exfalso|exact Hgt].
    + exfalso; apply H; right; exact Hlt.
    + apply Hc; destruct e, g; cbn [sgn] in Heq; lra.
Qed.

Theorem Record_systems : Record_systems_statement.
Proof.
  intros a1 a2 n Ha2 Ha1 Hn; destruct (Record_form a1 a2 n Ha2 Ha1 Hn) as (_ & H1 & H2 & H3 & H4).
  split; [|split; [|split]]; try (intros; apply (born_exactly _ _ _ _ _ Hn); tauto).
  intros Hh Hl Hd; apply all_fail_never; [exact Hn | apply Hd|]; intros e g; apply decided_fails; [exact Hd|].
  intros Ho; destruct e, g; tauto.
Qed.

Lemma u_one a1 a2 : u a1 a2 1 <> 0. Proof. cbn; lra. Qed.
Lemma c_one a1 a2 : c a1 a2 1 = a1 - (a2 + 1). Proof. unfold c, v, u; cbn; field. Qed.

Theorem Summary_systems : Summary_systems_statement.
Proof.
  intros S a1 a2 gamma n e g HS Ha2 Hg; pose proof (Single S a1 a2 gamma) as Hone.
  assert (Hl : (2 <= n)%nat -> (listed a1 a2 n e g <-> orbit a1 a2 n e g)).
  { intros Hn; unfold listed; destruct (Nat.eq_dec n 2) as [->|Hne].
    - rewrite (Period2 a1 a2 e g (proj1 Ha2)).
      split; [intros [[_ H]|[H _]]; [exact H | lia] | intros H; left; split; [reflexivity | exact H]].
    - rewrite (Summary a1 a2 n e g Ha2 ltac:(lia)).
      split; [intros [[H _]|[_ H]]; [contradiction | exact H] | intros H; right; split; [lia | exact H]]. }
  split; [|split; [|split]].
  - intros H; apply (Hone 1%nat e g HS (le_n 1) (u_one a1 a2) Hg), Period1, H.
  - intros H; apply (Hone 1%nat e g HS (le_n 1) (u_one a1 a2) Hg); right; rewrite c_one; exact H.
  - intros H; assert (Hn : (2 <= n)%nat) by (destruct H as [[-> _]|[H _]]; lia).
    apply Hl in H; [|exact Hn]; apply (Hone n e g HS ltac:(lia) (proj1 H) Hg), H.
  - intros Hn Hd H; apply (Hone n e g HS ltac:(lia) (proj1 Hd) Hg), decided_fails; [exact Hd|].
    intros Ho; apply H, Hl; assumption.
Qed.
