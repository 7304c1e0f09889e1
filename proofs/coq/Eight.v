(** * Theorem 2 gives n = 8 the five intervals of the paper's figure 5 *)

From Coq Require Import Reals Arith Lra Lia.
From Grazing Require Import Defs Statement StatementExamples Farey.
Open Scope R_scope.

Lemma neighbours_1_8 : neighbours 1 8 0 1 1 7. Proof. unfold neighbours; lia. Qed.
Lemma neighbours_3_8 : neighbours 3 8 1 3 2 5. Proof. unfold neighbours; lia. Qed.

Lemma numerators_8 m mp np mm nm : (0 < 2 * m < 8)%nat -> neighbours m 8 mp np mm nm -> m = 1%nat \/ m = 3%nat.
Proof.
  intros Hm HF; apply neighbours_coprime in HF.
  assert (m = 1 \/ m = 2 \/ m = 3)%nat as [|[->|]] by lia; auto; discriminate.
Qed.

Lemma INR_8 : INR 8 = 8. Proof. simpl; lra. Qed.

Lemma intervals_8 e g lo hi : interval 8 e g lo hi -> forall s, lo < s < hi -> period_8_interval e g s.
Proof.
  intros HI s Hs; pose proof (view _ _ _ _ _ HI) as HV; inversion HV as [|m mp np mm nm Hm HF|m mp np mm nm Hm HF];
    subst.
  - rewrite INR_8 in Hs; simpl; lra.
  - destruct (numerators_8 m mp np mm nm Hm HF) as [-> | ->].
    + rewrite INR_8 in Hs; simpl in *; lra.
    + apply (neighbours_unique _ _ _ _ _ _ neighbours_3_8) in HF; inversion HF; subst.
      rewrite INR_8 in Hs; simpl in *; lra.
  - destruct (numerators_8 m mp np mm nm Hm HF) as [-> | ->].
    + apply (neighbours_unique _ _ _ _ _ _ neighbours_1_8) in HF; inversion HF; subst.
      rewrite INR_8 in Hs; simpl in *; lra.
    + apply (neighbours_unique _ _ _ _ _ _ neighbours_3_8) in HF; inversion HF; subst.
      rewrite INR_8 in Hs; simpl in *; lra.
Qed.

Lemma period_8_from_Theorem2 : Theorem2_statement -> Period_8_statement.
Proof.
  intros T s e g Hs; rewrite (proj1 (T 8%nat s ltac:(lia) Hs) e g); split.
  - intros (lo & hi & HI & Hlo); now apply (intervals_8 e g lo hi).
  - assert (H1 : (0 < 2 * 1 < 8)%nat) by lia; assert (H3 : (0 < 2 * 3 < 8)%nat) by lia.
    pose proof (first 8%nat) as I0; pose proof (left_of _ _ _ _ _ _ H1 neighbours_1_8) as I1.
    pose proof (right_of _ _ _ _ _ _ H1 neighbours_1_8) as I2. pose proof (left_of _ _ _ _ _ _ H3 neighbours_3_8) as I3.
    pose proof (right_of _ _ _ _ _ _ H3 neighbours_3_8) as I4.
    rewrite INR_8 in *; destruct e, g; simpl in *; intros Hi; [| | |tauto].
    + destruct Hi; [exists (1 / (2 * 8)), (1 / 8)|eexists _, _; split; [exact I3|lra]]. split; [exact I1|lra].
    + destruct Hi; eexists _, _; split; [exact I2|lra|exact I4|lra].
    + eexists _, _; split; [exact I0|lra].
Qed.
