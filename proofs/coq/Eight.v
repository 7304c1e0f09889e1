(** * The paper's worked instance: n = 8 has exactly five intervals *)

From Coq Require Import Reals Lra Lia Arith List.
From Grazing Require Import Defs Statement StatementB.
Import ListNotations.
Open Scope R_scope.

Lemma next_to_1_8 : neighbours 1 8 0 1 1 7.
Proof. repeat split; lia. Qed.

Lemma next_to_3_8 : neighbours 3 8 1 3 2 5.
Proof. repeat split; lia. Qed.

Lemma only_next_to_1_8 mp np mm nm : neighbours 1 8 mp np mm nm ->
  (mp, np, mm, nm) = (0, 1, 1, 7)%nat.
Proof.
  intros (H1 & H2 & H3 & H4).
  assert (np = 1 /\ mp = 0 /\ mm = 1 /\ nm = 7)%nat as (-> & -> & -> & ->) by lia; reflexivity.
Qed.

Lemma only_next_to_3_8 mp np mm nm : neighbours 3 8 mp np mm nm ->
  (mp, np, mm, nm) = (1, 3, 2, 5)%nat.
Proof.
  intros (H1 & H2 & H3 & H4).
  assert (np = 3 /\ mp = 1 /\ mm = 2 /\ nm = 5)%nat as (-> & -> & -> & ->) by lia; reflexivity.
Qed.

(** 2 is not coprime to 8. *)
Lemma no_neighbours_of_2_8 mp np mm nm : ~ neighbours 2 8 mp np mm nm.
Proof. intros (H1 & H2 & H3 & H4); lia. Qed.

Lemma cases_8 m mp np mm nm : (0 < 2 * m < 8)%nat -> neighbours m 8 mp np mm nm ->
  m = 1%nat /\ (mp, np, mm, nm) = (0, 1, 1, 7)%nat \/
  m = 3%nat /\ (mp, np, mm, nm) = (1, 3, 2, 5)%nat.
Proof.
  intros Hm Hn; assert (m = 1 \/ m = 2 \/ m = 3)%nat as [-> | [-> | ->]] by lia.
  - left; split; [reflexivity | apply only_next_to_1_8, Hn].
  - destruct (no_neighbours_of_2_8 _ _ _ _ Hn).
  - right; split; [reflexivity | apply only_next_to_3_8, Hn].
Qed.

Lemma interval_eq e g lo hi lo' hi' : interval 8 e g lo hi -> lo = lo' -> hi = hi' ->
  interval 8 e g lo' hi'.
Proof. intros H <- <-; exact H. Qed.

Theorem Eight : Eight_statement.
Proof.
  intros e g lo hi; split; intros H.
  - destruct H as [| m mp np mm nm Hm Hn | m mp np mm nm Hm Hn];
      [| destruct (cases_8 m mp np mm nm Hm Hn) as [[-> E]|[-> E]];
         injection E as -> -> -> -> .. ]; cbn [Nat.eqb INR]; clear.
    + left; repeat f_equal; lra.
    + right; left; repeat f_equal; lra.
    + right; right; right; left; repeat f_equal; lra.
    + right; right; left; repeat f_equal; lra.
    + right; right; right; right; left; repeat f_equal; lra.
  - destruct H as [E|[E|[E|[E|[E|[]]]]]]; injection E as <- <- <- <-.
    + apply (interval_eq _ _ _ _ _ _ (first 8)); cbn [INR]; lra.
    + apply (interval_eq _ _ _ _ _ _ (left_of 8 1 0 1 1 7 ltac:(lia) next_to_1_8)); cbn; lra.
    + apply (interval_eq _ _ _ _ _ _ (right_of 8 1 0 1 1 7 ltac:(lia) next_to_1_8)); cbn; lra.
    + apply (interval_eq _ _ _ _ _ _ (left_of 8 3 1 3 2 5 ltac:(lia) next_to_3_8)); cbn; lra.
    + apply (interval_eq _ _ _ _ _ _ (right_of 8 3 1 3 2 5 ltac:(lia) next_to_3_8)); cbn; lra.
Qed.
