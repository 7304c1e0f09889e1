(** * The definitions over the rationals, and proofs that they are the same

    [Defs] speaks of real numbers, which do not compute. Here u, v, b and c are given
    once more over Q; the lemmas say that Q2R maps each to the real one. *)

From Coq Require Import Reals QArith Qreals List Bool Lra Lia.
From Grazing Require Import Defs.
Open Scope Q_scope.

(** [Qred] keeps fractions in lowest terms. *)
Fixpoint pairQ (a1 a2 : Q) (k : nat) : Q * Q :=
  match k with
  | O => (0, 1)
  | S j => let (p, q) := pairQ a1 a2 j in (q, Qred (a1 * q - a2 * p))
  end.

Fixpoint powQ (a : Q) (k : nat) : Q :=
  match k with O => 1 | S j => Qred (a * powQ a j) end.

Definition uQ (a1 a2 : Q) (k : nat) : Q := fst (pairQ a1 a2 k).
Definition vQ (a1 a2 : Q) (n : nat) : Q := Qred (2 * uQ a1 a2 (S n) - a1 * uQ a1 a2 n).
Definition bQ (a1 a2 : Q) (n k : nat) : Q :=
  Qred ((uQ a1 a2 n - uQ a1 a2 k - powQ a2 k * uQ a1 a2 (n - k)) / uQ a1 a2 n).
Definition cQ (a1 a2 : Q) (n : nat) : Q :=
  Qred (- (1 - vQ a1 a2 n + powQ a2 n) / uQ a1 a2 n).

Lemma Q2R_Qred x : Q2R (Qred x) = Q2R x.
Proof. apply Qeq_eqR, Qred_correct. Qed.

Lemma Q2R_1 : Q2R 1 = 1%R.
Proof. exact RMicromega.Q2R_1. Qed.

Lemma Q2R_2 : Q2R 2 = 2%R.
Proof. unfold Q2R; cbn; lra. Qed.

Lemma pairQ_pair a1 a2 k :
  pair (Q2R a1) (Q2R a2) k = (Q2R (fst (pairQ a1 a2 k)), Q2R (snd (pairQ a1 a2 k))).
Proof.
  induction k as [|k IH]; cbn [pair pairQ].
  - cbn [fst snd]; rewrite RMicromega.Q2R_0, Q2R_1; reflexivity.
  - rewrite IH; destruct (pairQ a1 a2 k) as [p q]; cbn [fst snd].
    rewrite Q2R_Qred, Q2R_minus, !Q2R_mult; reflexivity.
Qed.

Theorem uQ_u a1 a2 k : Q2R (uQ a1 a2 k) = u (Q2R a1) (Q2R a2) k.
Proof. unfold u; rewrite pairQ_pair; reflexivity. Qed.

Lemma powQ_pow a k : Q2R (powQ a k) = (Q2R a ^ k)%R.
Proof.
  induction k as [|k IH]; cbn [powQ pow]; [exact Q2R_1|].
  rewrite Q2R_Qred, Q2R_mult, IH; reflexivity.
Qed.

Theorem vQ_v a1 a2 n : Q2R (vQ a1 a2 n) = v (Q2R a1) (Q2R a2) n.
Proof.
  unfold vQ, v; rewrite Q2R_Qred, Q2R_minus, !Q2R_mult, !uQ_u, Q2R_2; reflexivity.
Qed.

(** u_n = 0 is the same over Q. *)
Lemma uQ_zero a1 a2 n : uQ a1 a2 n == 0 <-> u (Q2R a1) (Q2R a2) n = 0%R.
Proof.
  rewrite <- uQ_u, <- RMicromega.Q2R_0; split; [apply Qeq_eqR | apply eqR_Qeq].
Qed.

Theorem bQ_b a1 a2 n k : ~ uQ a1 a2 n == 0 ->
  Q2R (bQ a1 a2 n k) = b (Q2R a1) (Q2R a2) n k.
Proof.
  intros Hu; unfold bQ, b; rewrite Q2R_Qred, Q2R_div by assumption.
  rewrite !Q2R_minus, Q2R_mult, powQ_pow, !uQ_u; reflexivity.
Qed.

Theorem cQ_c a1 a2 n : ~ uQ a1 a2 n == 0 ->
  Q2R (cQ a1 a2 n) = c (Q2R a1) (Q2R a2) n.
Proof.
  intros Hu; unfold cQ, c; rewrite Q2R_Qred, Q2R_div by assumption.
  rewrite Q2R_opp, Q2R_plus, Q2R_minus, powQ_pow, vQ_v, uQ_u, Q2R_1; reflexivity.
Qed.

(** ** The conditions of [orbit] are decided over Q *)

Definition positiveQ (x : Q) : bool := negb (Qle_bool x 0).
Definition sgnQ (x : sign) : Q := match x with Plus => 1 | Minus => -1 end.

Definition orbitQ (a1 a2 : Q) (n : nat) (emu gamma : sign) : bool :=
  negb (Qeq_bool (uQ a1 a2 n) 0) &&
  forallb (fun k => positiveQ (sgnQ emu * bQ a1 a2 n k)) (seq 1 (n - 1)) &&
  positiveQ (sgnQ emu * sgnQ gamma * cQ a1 a2 n).

Lemma positiveQ_pos x : positiveQ x = true <-> (0 < Q2R x)%R.
Proof.
  unfold positiveQ; rewrite negb_true_iff, <- not_true_iff_false, Qle_bool_iff.
  rewrite <- RMicromega.Q2R_0; split; intros H.
  - apply Qlt_Rlt, Qnot_le_lt, H.
  - apply Qlt_not_le, Rlt_Qlt, H.
Qed.

Lemma sgnQ_sgn e : Q2R (sgnQ e) = sgn e.
Proof. destruct e; unfold Q2R; cbn; lra. Qed.

Lemma nonzeroQ x : negb (Qeq_bool x 0) = true <-> ~ x == 0.
Proof. rewrite negb_true_iff, <- not_true_iff_false, Qeq_bool_iff; reflexivity. Qed.

Lemma and_iff_compat_l_dep (P Q R : Prop) : (P -> (Q <-> R)) -> (P /\ Q <-> P /\ R).
Proof. tauto. Qed.

Theorem orbitQ_orbit a1 a2 n emu gamma :
  orbitQ a1 a2 n emu gamma = true <-> orbit (Q2R a1) (Q2R a2) n emu gamma.
Proof.
  unfold orbitQ, orbit; rewrite !andb_true_iff, forallb_forall, positiveQ_pos, nonzeroQ.
  rewrite <- uQ_zero, and_assoc; apply and_iff_compat_l_dep; intros Hu.
  rewrite !Q2R_mult, !sgnQ_sgn, cQ_c by assumption; apply and_iff_compat_r.
  split; intros H k Hk.
  - specialize (H k); rewrite in_seq, positiveQ_pos, Q2R_mult, sgnQ_sgn, bQ_b in H by assumption.
    apply Rlt_gt, H; lia.
  - apply in_seq in Hk; rewrite positiveQ_pos, Q2R_mult, sgnQ_sgn, bQ_b by assumption.
    apply Rgt_lt, H; lia.
Qed.
