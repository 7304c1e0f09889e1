(** * The signs of sin (k m pi / n), 0 < k < n: all positive for m = 1 alone, up to 2 n *)
From Coq Require Import Reals Lra Lia Arith.
Open Scope R_scope.

Lemma sine_turns j m n x : (1 <= n)%nat -> (m = x + 2 * n * j)%nat -> forall k,
  sin (PI * (INR k * INR m / INR n)) = sin (PI * (INR (k * x) / INR n)).
Proof.
  intros Hn -> k; assert (0 < INR n) by (apply lt_0_INR; lia).
  rewrite <- (sin_period (PI * (INR (k * x) / INR n)) (k * j)); f_equal.
  rewrite plus_INR, !mult_INR; change (INR 2) with 2; field; lra.
Qed.
Lemma sine_sign n x : (1 <= n)%nat ->
  ((0 < x < n)%nat -> 0 < sin (PI * (INR x / INR n))) /\ ((n < x < 2 * n)%nat -> sin (PI * (INR x / INR n)) < 0) /\
  (x = 0%nat \/ x = n -> sin (PI * (INR x / INR n)) = 0).
Proof.
  intros Hn; pose proof PI_RGT_0 as HP; assert (N : 0 < INR n) by (apply lt_0_INR; lia).
  assert (Up : forall a b, (a < b)%nat -> PI * (INR a / INR n) < PI * (INR b / INR n)).
  { intros a b L; apply Rmult_lt_compat_l; [lra|]; apply Rmult_lt_compat_r;
    [apply Rinv_0_lt_compat, N | apply lt_INR, L]. }
  assert (E0 : PI * (INR 0 / INR n) = 0) by (cbn; field; lra); assert (E1 : PI * (INR n / INR n) = PI) by (field; lra).
  assert (E2 : PI * (INR (2 * n) / INR n) = 2 * PI) by (rewrite mult_INR; change (INR 2) with 2; field; lra).
  split; [|split].
  - intros [A B]; apply Up in A, B; rewrite E0 in A; rewrite E1 in B; apply sin_gt_0; assumption.
  - intros [A B]; apply Up in A, B; rewrite E1 in A; rewrite E2 in B; apply sin_lt_0; assumption.
  - intros [-> | ->]; [rewrite E0; apply sin_0 | rewrite E1; apply sin_PI].
Qed.

(** If m is not 1 up to 2 n, then one multiple is over the half turn, or m itself is a multiple of it. *)
Lemma over_half n x : (2 <= n)%nat -> (x < 2 * n)%nat -> x <> 1%nat ->
  x = 0%nat \/ x = n \/ exists k, (0 < k < n)%nat /\ (n < k * x < 2 * n)%nat.
Proof.
  intros Hn Hx N1; destruct (Nat.eq_dec x 0) as [|N0]; [auto|]; destruct (Nat.eq_dec x n) as [|Nn]; [auto|right;
    right]. destruct (Nat.lt_ge_cases n x) as [L|L]; [exists 1%nat; lia|].
  exists (S (n / x)); pose proof (Nat.div_mod n x N0) as E; pose proof (Nat.mod_upper_bound n x N0) as U.
  set (y := (n / x)%nat) in *; set (z := (n mod x)%nat) in *; assert (Hy : (2 * y <= x * y)%nat) by (apply
    Nat.mul_le_mono_r; lia); split; [|lia]; split; [lia|]. destruct (Nat.le_gt_cases y 1) as [Ly|Ly]; [lia|]; lia.
Qed.

(** For n theta = m pi: the signs of sin (k theta). *)
Lemma signs n m : (1 <= n)%nat ->
  ((m mod (2 * n) = 1)%nat -> forall k, (0 < k < n)%nat -> 0 < sin (PI * (INR k * INR m / INR n))) /\
  ((2 <= n)%nat -> (m mod (2 * n) <> 1)%nat -> sin (PI * (INR m / INR n)) = 0 \/
    exists k, (0 < k < n)%nat /\ sin (PI * (INR k * INR m / INR n)) < 0).
Proof.
  intros Hn; assert (E : (m = m mod (2 * n) + 2 * n * (m / (2 * n)))%nat).
  { pose proof (Nat.div_mod m (2 * n) ltac:(lia)); lia. }
  pose proof (Nat.mod_upper_bound m (2 * n) ltac:(lia)) as U; set (x := (m mod (2 * n))%nat) in *.
  pose proof (sine_turns _ m n x Hn E) as P; split.
  - intros E1 k Hk; rewrite P, E1, Nat.mul_1_r; apply sine_sign; assumption.
  - intros H2 N1; destruct (over_half n x H2 U N1) as [Z|[Z|(k & Hk & L)]]; [left|left|right].
    1, 2: specialize (P 1%nat); rewrite Rmult_1_l, Nat.mul_1_l in P; rewrite P; apply sine_sign; auto.
    exists k; split; [exact Hk|]; rewrite P; apply sine_sign; assumption.
Qed.
