(** * A sequence y_{k+2} = (p+q) y_{k+1} - p q y_k, p, q > 0, turns at most once

    The discrete form of "y = P p^t + Q q^t has at most one stationary point": once such
    a sequence fails to rise it falls for ever. Equal eigenvalues are no special case.
    Used for regions 1, 2 and (with y_k = (-1)^k x_k) 4. *)

From Coq Require Import Reals Lra Lia.
From Grazing Require Import Defs Algebra.
Open Scope R_scope.

Section Unimodal.
Variable y : nat -> R.
Hypothesis turns_once : forall k, y (S k) <= y k -> y (S (S k)) < y (S k).

Lemma falls_next i j : (i < j)%nat -> y j <= y i -> y (S j) < y j.
Proof.
  intros Hij; revert Hij; induction j as [|j IH]; intros Hij Hy; [lia|].
  destruct (Rle_lt_dec (y (S j)) (y j)) as [H|H]; [apply turns_once, H |]. assert (i <> j) by (intros ->; lra).
  enough (y (S j) < y j) by lra; apply IH; [lia | lra].
Qed.

Lemma falls_after i j k : (i < j < k)%nat -> y j <= y i -> y k < y j.
Proof.
  intros [Hij Hjk] Hy; induction Hjk as [|k Hjk IH].
  - apply falls_next with i; assumption.
  - assert (y (S k) < y k) by (apply falls_next with i; [lia | lra]); lra.
Qed.
End Unimodal.

Section Recurrence.
Variables (p q : R) (y : nat -> R).
Hypothesis p_pos : 0 < p.
Hypothesis q_pos : 0 < q.
Hypothesis recurrence : forall k, y (S (S k)) = (p + q) * y (S k) - p * q * y k.

Lemma drift k : y (S k) - p * y k = q ^ k * (y 1%nat - p * y 0%nat).
Proof.
  induction k as [|k IH]; [cbn; ring|]. rewrite recurrence; cbn [pow].
  transitivity (q * (y (S k) - p * y k)); [ring | rewrite IH; ring].
Qed.

Lemma turns_once k : 0 < (1 - q) * (y 1%nat - p * y 0%nat) -> y (S k) <= y k -> y (S (S k)) < y (S k).
Proof.
  intros Hz Hk.
  assert (0 < (1 - q) * (y (S k) - p * y k)).
  { rewrite drift; pose proof (pow_lt q k q_pos); nra. }
  rewrite recurrence; nra.
Qed.

(** If the drift is not positive, y stays below p^k y_0. *)
Lemma no_drift k : y 1%nat - p * y 0%nat <= 0 -> y k <= p ^ k * y 0%nat.
Proof.
  intros Hz; induction k as [|k IH]; [cbn; lra|]. pose proof (drift k); pose proof (pow_lt q k q_pos); cbn [pow]; nra.
Qed.
End Recurrence.

Lemma pow_below_1 p n : 0 < p < 1 -> (1 <= n)%nat -> 0 < p ^ n < 1.
Proof.
  intros Hp Hn; split; [apply pow_lt; lra |]. destruct n as [|n]; [lia|]; cbn.
  pose proof (pow_incr p 1 n); rewrite pow1 in *; nra.
Qed.

(** Both eigenvalues in (0,1): between two equal positive values y is larger. *)
Lemma arch p q y n k : 0 < p < 1 -> 0 < q < 1 -> (forall k, y (S (S k)) = (p + q) * y (S k) - p * q * y k) ->
  0 < y 0%nat -> y n = y 0%nat -> (0 < k < n)%nat -> y 0%nat < y k.
Proof.
  intros Hp Hq Hy H0 Hn Hk. destruct (Rle_lt_dec (y 1%nat - p * y 0%nat) 0) as [Hz|Hz].
  - pose proof (no_drift p q y ltac:(lra) ltac:(lra) Hy n Hz). pose proof (pow_below_1 p n Hp ltac:(lia)); nra.
  - apply Rnot_le_lt; intros Hle. enough (y n < y k) by lra. apply (falls_after y) with 0%nat; [|lia|assumption].
    intros j; apply (turns_once p q); try lra; [assumption | nra].
Qed.

(** One eigenvalue on each side of 1: between two equal positive values y is smaller. *)
Lemma sag p q y n k : 0 < p < 1 -> 1 < q -> (forall k, y (S (S k)) = (p + q) * y (S k) - p * q * y k) -> 0 < y 0%nat ->
  y n = y 0%nat -> (0 < k < n)%nat -> y k < y 0%nat.
Proof.
  intros Hp Hq Hy H0 Hn Hk; set (w k := - y k).
  assert (Hw : forall k, w (S (S k)) = (p + q) * w (S k) - p * q * w k) by (intros; unfold w; rewrite Hy; ring).
  destruct (Rle_lt_dec (y 1%nat - p * y 0%nat) 0) as [Hz|Hz].
  - pose proof (no_drift p q y ltac:(lra) ltac:(lra) Hy n Hz). pose proof (pow_below_1 p n Hp ltac:(lia)); nra.
  - apply Rnot_le_lt; intros Hle. enough (w n < w k) by (unfold w in *; lra).
    apply (falls_after w) with 0%nat; [|lia|unfold w; lra].
    intros j; apply (turns_once p q); try lra; [assumption | unfold w; nra].
Qed.

(** From -1 up to 1, both eigenvalues in (0,1): y stays above -1, and below 1 if it is
    so, or is 1, two steps before the end. *)
Section Climb.
Variables (p q : R) (y : nat -> R) (n : nat).
Hypothesis p_in : 0 < p < 1.
Hypothesis q_in : 0 < q < 1.
Hypothesis recurrence : forall k, y (S (S k)) = (p + q) * y (S k) - p * q * y k.
Hypothesis starts : y 0%nat = -1.
Hypothesis ends : y n = 1.

Lemma climb_falls_after i j k : (i < j < k)%nat -> y j <= y i -> y k < y j.
Proof.
  apply (falls_after y); intros l; apply (turns_once p q); try lra; [assumption|].
  destruct (Rle_lt_dec (y 1%nat - p * y 0%nat) 0) as [Hz|Hz]; [|nra].
  pose proof (no_drift p q y ltac:(lra) ltac:(lra) recurrence n Hz). pose proof (pow_lt p n ltac:(lra)); nra.
Qed.

Lemma climb_above k : (0 < k < n)%nat -> -1 < y k.
Proof. intros Hk; apply Rnot_le_lt; intros H. pose proof (climb_falls_after 0 k n ltac:(lia)); lra. Qed.
Lemma climb_below j k : (k < j < n)%nat -> y j <= 1 -> y k < 1.
Proof. intros Hk Hj; apply Rnot_le_lt; intros H. pose proof (climb_falls_after k j n ltac:(lia)); lra. Qed.
End Climb.
