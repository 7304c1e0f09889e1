(** * Proof of S1-S5, Theorem 2, Conjecture 1, the summary and the record form about orbits

    Each is the theorem about signs, followed by what [orbit] and [no_orbit] mean for the orbits in question. *)

From Coq Require Import Reals Arith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementAffine StatementOrbits
  StatementOrbitsPlane StatementOrbitsAreas PlaneOrbits Disc Radius Above Region4 AppendixA Summary
  InsideTriangle.
Open Scope R_scope.

(** With no zero among the signs, what does not hold fails. *)
Lemma decided_fails a1 a2 n s g : no_zeros a1 a2 n -> ~ orbit a1 a2 n s g -> fails a1 a2 n s g.
Proof.
  intros (Hu & Hc & Hb) Hno; destruct (Classical_Prop.classic (fails a1 a2 n s g)) as [H|H]; [exact H|].
  exfalso; apply Hno; split; [exact Hu | split].
  - intros k Hk; destruct (Rtotal_order (sgn s * b a1 a2 n k) 0) as [Hlt|[Heq|Hgt]]; [|exfalso|exact Hgt].
    + exfalso; apply H; left; exists k; auto.
    + apply (Hb k Hk); destruct s; cbn [sgn] in Heq; lra.
  - destruct (Rtotal_order (sgn s * sgn g * c a1 a2 n) 0) as [Hlt|[Heq|Hgt]]; [|exfalso|exact Hgt].
    + exfalso; apply H; right; exact Hlt.
    + apply Hc; destruct s, g; cbn [sgn] in Heq; lra.
Qed.

Section About.
Variables (exactly : R -> R -> nat -> sign -> sign -> Prop) (none : R -> R -> nat -> Prop).
Hypothesis orbit_exactly : forall a1 a2 n s g, (2 <= n)%nat -> orbit a1 a2 n s g -> exactly a1 a2 n s g.
Hypothesis no_orbit_none : forall a1 a2 n, (2 <= n)%nat -> no_orbit a1 a2 n -> none a1 a2 n.
Hypothesis decided_none : forall a1 a2 n, (2 <= n)%nat -> u a1 a2 n <> 0 -> (forall s g, fails a1 a2 n s g) ->
  none a1 a2 n.

Lemma decides_decides a1 a2 n d g : (2 <= n)%nat -> decides a1 a2 n d g -> decides_about exactly none a1 a2 n d g.
Proof.
  intros Hn (_ & _ & H1 & H2 & _); split; intros H; [apply orbit_exactly | apply no_orbit_none]; auto.
Qed.

Theorem S1_S3_for : S1_S3_about exactly none.
Proof.
  intros r s n m Hn Hc; split; [|split].
  - intros ->; apply orbit_exactly, S1_stated; assumption.
  - intros Hm Hg; apply no_orbit_none; [exact Hn|]; apply (S2_proof r s n m Hn Hm Hc), Hg.
  - intros Hm F; destruct (S3_stated r s n m F Hn Hm Hc) as [H1 H2].
    split; intros H; apply decides_decides; auto.
Qed.

Theorem Theorem2_for : Theorem2_about exactly none.
Proof.
  intros n s Hn Hs; destruct (Theorem2_stated n s Hn Hs) as [H1 H2]; split.
  - intros e g lo hi HI Hin; apply orbit_exactly; [lia|]; apply H1; exists lo, hi; auto.
  - intros Hout Hu; apply no_orbit_none; [lia | apply H2; assumption].
Qed.

Theorem Conjecture1_for : Conjecture1_about exactly none.
Proof.
  intros n Hn; assert (Hn2 : (2 <= n)%nat) by lia.
  destruct (S4_stated n Hn) as (H1 & H2 & H3); split; [|split; [|split]].
  - intros r s Hr Hs; apply orbit_exactly, H1; assumption.
  - intros k g lo hi HI; destruct (H2 k g lo hi HI) as (Rad & HR); exists Rad; split; [exact HR|].
    intros r s Hr Hs; destruct (HR s Hs) as (_ & _ & Hall); destruct (Hall r Hr) as (_ & Habove & _ & _ & Hbelow & _).
    split; intros H; [apply orbit_exactly, Habove | apply no_orbit_none, Hbelow]; assumption.
  - intros r s Hr Hs Hu Hout Hout'; apply no_orbit_none, H3; assumption.
  - intros a1 a2 Ha2 Ha1; destruct (S5 a1 a2 n Ha2 Ha1) as (_ & Heven & Hodd); split.
    + intros H; apply no_orbit_none; [exact Hn2|]; apply Heven; [|exact H].
      destruct H as [p ->]; lia.
    + intros H; apply decides_decides; [exact Hn2 | apply Hodd; assumption].
Qed.

Theorem Record_for : Record_about exactly none.
Proof.
  intros a1 a2 n Ha2 Ha1 Hn; destruct (Record_form a1 a2 n Ha2 Ha1 Hn) as (_ & H1 & H2 & H3 & H4).
  split; [|split; [|split]]; try (intros; apply orbit_exactly; tauto).
  intros Hh Hl Hd; apply decided_none; [exact Hn | apply Hd|]; intros s g; apply decided_fails; [exact Hd|].
  intros Ho; destruct s, g; tauto.
Qed.
End About.

Lemma u_one a1 a2 : u a1 a2 1 <> 0.
Proof. cbn; lra. Qed.

Lemma c_one a1 a2 : c a1 a2 1 = a1 - (a2 + 1).
Proof. unfold c, v, u; cbn; field. Qed.

Theorem Summary_for (some no : R -> R -> nat -> sign -> sign -> Prop) : (forall a1 a2 n s g,
  orbit a1 a2 n s g -> (1 <= n)%nat -> some a1 a2 n s g) ->
  (forall a1 a2 n s g, u a1 a2 n <> 0 -> fails a1 a2 n s g -> (1 <= n)%nat -> no a1 a2 n s g) ->
    Summary_about some no.
Proof.
  intros Hsome Hno a1 a2 n s g Ha2.
  assert (Hl : (2 <= n)%nat -> (listed a1 a2 n s g <-> orbit a1 a2 n s g)).
  { intros Hn; unfold listed; destruct (Nat.eq_dec n 2) as [->|Hne].
    - rewrite (Period2 a1 a2 s g (proj1 Ha2)).
      split; [intros [[_ H]|[H _]]; [exact H | lia] | intros H; left; split; [reflexivity | exact H]].
    - rewrite (Summary a1 a2 n s g Ha2 ltac:(lia)).
      split; [intros [[H _]|[_ H]]; [contradiction | exact H] | intros H; right; split; [lia | exact H]]. }
  split; [|split; [|split]].
  - intros H; apply Hsome; [apply Period1, H | lia].
  - intros H; apply Hno; [apply u_one | right; rewrite c_one; exact H | lia].
  - intros H; assert (Hn : (2 <= n)%nat) by (destruct H as [[-> _]|[H _]]; lia).
    apply Hsome; [apply Hl; assumption | lia].
  - intros Hn Hd H; apply Hno; [apply Hd | apply decided_fails; [exact Hd|] | lia]; intros Ho; apply H, Hl;
      assumption.
Qed.

(** ** Maps *)
Lemma orbit_exactly a1 a2 n s g : (2 <= n)%nat -> orbit a1 a2 n s g -> exactly_in a1 a2 n s g.
Proof. intros Hn H M gamma e w HP; apply (Meaning M a1 a2 gamma e w n HP Hn), H. Qed.

Lemma no_orbit_none a1 a2 n : (2 <= n)%nat -> no_orbit a1 a2 n -> in_none a1 a2 n.
Proof. intros Hn H M gamma e w HP; apply (Meaning M a1 a2 gamma e w n HP Hn), H. Qed.

Lemma sign_of gamma : gamma <> 0 -> exists g, sgn g * gamma > 0.
Proof. intros H; destruct (Rlt_le_dec gamma 0); [exists Minus | exists Plus]; cbn [sgn]; lra. Qed.

Lemma all_fail_none a1 a2 n : (2 <= n)%nat -> u a1 a2 n <> 0 -> (forall s g, fails a1 a2 n s g) -> in_none a1 a2 n.
Proof.
  intros Hn Hu Hf M gamma e w HP s; destruct (sign_of gamma (proj2 (is_gamma _ _ _ _ _ _ HP))) as [g Hg].
  apply (Theorem1_single M a1 a2 gamma e w n s g HP ltac:(lia) Hu Hg), Hf.
Qed.

Theorem S1_S3_orbits : S1_S3_statement_orbits.
Proof. exact (S1_S3_for _ _ orbit_exactly no_orbit_none). Qed.
Theorem Theorem2_orbits : Theorem2_statement_orbits.
Proof. exact (Theorem2_for _ _ orbit_exactly no_orbit_none). Qed.
Theorem Conjecture1_orbits : Conjecture1_statement_orbits.
Proof. exact (Conjecture1_for _ _ orbit_exactly no_orbit_none). Qed.
Theorem Record_orbits : Record_statement_orbits.
Proof. exact (Record_for _ _ orbit_exactly all_fail_none). Qed.
Theorem Summary_orbits : Summary_statement_orbits.
Proof.
  intros M gamma e w; apply Summary_for.
  - intros a1 a2 n s g H Hn HP Hg; apply (Theorem1_single M a1 a2 gamma e w n s g HP Hn (proj1 H) Hg), H.
  - intros a1 a2 n s g Hu H Hn HP Hg; apply (Theorem1_single M a1 a2 gamma e w n s g HP Hn Hu Hg), H.
Qed.
