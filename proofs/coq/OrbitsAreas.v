(** * Proof that S1-S5, Conjecture 1, the summary and the record form hold for orbits of maps

    Each is the theorem about signs followed by Theorem 1. *)

From Coq Require Import Reals Arith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementAffine StatementOrbits
  StatementOrbitsPlane StatementOrbitsAreas PlaneOrbits Disc Radius Above Region4 AppendixA Summary
  InsideTriangle.
Open Scope R_scope.

Lemma orbit_exactly a1 a2 n s g : (2 <= n)%nat -> orbit a1 a2 n s g -> exactly_in a1 a2 n s g.
Proof. intros Hn H M gamma e w HP; apply (Meaning M a1 a2 gamma e w n HP Hn), H. Qed.

Lemma no_orbit_none a1 a2 n : (2 <= n)%nat -> no_orbit a1 a2 n -> in_none a1 a2 n.
Proof. intros Hn H M gamma e w HP; apply (Meaning M a1 a2 gamma e w n HP Hn), H. Qed.

Lemma decides_decides a1 a2 n d g : (2 <= n)%nat -> decides a1 a2 n d g -> decides_orbits a1 a2 n d g.
Proof.
  intros Hn (_ & _ & H1 & H2 & _); split; intros H; [apply orbit_exactly | apply no_orbit_none]; auto.
Qed.

Theorem S1_S3_orbits : S1_S3_statement_orbits.
Proof.
  intros r s n m Hn Hc; split; [|split].
  - intros ->; apply orbit_exactly, S1_stated; assumption.
  - intros Hm Hg; apply no_orbit_none; [exact Hn|]; apply (S2_proof r s n m Hn Hm Hc), Hg.
  - intros Hm F; destruct (S3_stated r s n m F Hn Hm Hc) as [H1 H2].
    split; intros H; apply decides_decides; auto.
Qed.

Theorem Theorem2_orbits : Theorem2_statement_orbits.
Proof.
  intros n s Hn Hs; destruct (Theorem2_stated n s Hn Hs) as [H1 H2]; split.
  - intros e g lo hi HI Hin; apply orbit_exactly; [lia|]; apply H1; exists lo, hi; auto.
  - intros Hout Hu; apply no_orbit_none; [lia | apply H2; assumption].
Qed.

Theorem Conjecture1_orbits : Conjecture1_statement_orbits.
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

Lemma decided_not_born M a1 a2 gamma e w n s g : planar M a1 a2 gamma e w -> (1 <= n)%nat ->
  sgn g * gamma > 0 -> no_zeros a1 a2 n -> ~ orbit a1 a2 n s g -> not_born M e n s.
Proof.
  intros HP Hn Hg Hd Hno; apply (Theorem1_single M a1 a2 gamma e w n s g HP Hn (proj1 Hd) Hg).
  apply decided_fails; assumption.
Qed.

Lemma u_one a1 a2 : u a1 a2 1 <> 0.
Proof. cbn; lra. Qed.

Lemma c_one a1 a2 : c a1 a2 1 = a1 - (a2 + 1).
Proof. unfold c, v, u; cbn; field. Qed.

Theorem Summary_orbits : Summary_statement_orbits.
Proof.
  intros M a1 a2 gamma e w n s g HP Hg Ha2.
  assert (H1 := Theorem1_single M a1 a2 gamma e w 1%nat s g HP (le_n 1) (u_one a1 a2) Hg).
  assert (Hl : (2 <= n)%nat -> (listed a1 a2 n s g <-> orbit a1 a2 n s g)).
  { intros Hn; unfold listed; destruct (Nat.eq_dec n 2) as [->|Hne].
    - rewrite (Period2 a1 a2 s g (proj1 Ha2)).
      split; [intros [[_ H]|[H _]]; [exact H | lia] | intros H; left; split; [reflexivity | exact H]].
    - rewrite (Summary a1 a2 n s g Ha2 ltac:(lia)).
      split; [intros [[H _]|[_ H]]; [contradiction | exact H] | intros H; right; split; [lia | exact H]]. }
  split; [|split; [|split]].
  - intros H; apply H1; apply Period1, H.
  - intros H; apply H1; right; rewrite c_one; exact H.
  - intros H; assert (Hn : (2 <= n)%nat) by (destruct H as [[-> _]|[H _]]; lia).
    apply (Meaning M a1 a2 gamma e w n HP Hn) with (g := g); [apply Hl; assumption | exact Hg].
  - intros Hn Hd H; apply (decided_not_born M a1 a2 gamma e w n s g); trivial; [lia|].
    intros Ho; apply H, Hl; assumption.
Qed.

Theorem Record_orbits : Record_statement_orbits.
Proof.
  intros a1 a2 n Ha2 Ha1 Hn; destruct (Record_form a1 a2 n Ha2 Ha1 Hn) as (_ & H1 & H2 & H3 & H4).
  split; [|split; [|split]]; try (intros; apply orbit_exactly; tauto).
  intros Hh Hl Hd M gamma e w HP s; destruct (is_gamma _ _ _ _ _ _ HP) as [_ Hg0].
  assert (Hsign : exists g, sgn g * gamma > 0).
  { destruct (Rlt_le_dec gamma 0) as [Hneg|Hpos]; [exists Minus | exists Plus]; cbn [sgn]; lra. }
  destruct Hsign as [g Hg]; apply (decided_not_born M a1 a2 gamma e w n s g); trivial; [lia|].
  intros Ho; destruct s, g; tauto.
Qed.
