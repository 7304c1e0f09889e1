(** * S5 holds: region 4 and the line a1 = -2 sqrt a2

    y_k = (-1)^k x_k has the positive eigenvalues p, q of the mirror image, y_0 = -1
    and y_n = -(-1)^n: an arch below -1 for even n, a climb from -1 to 1 for odd n. *)

From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import Defs Statement Algebra RealEigenvalues Cases AppendixA.
Open Scope R_scope.

Section Region4.
Variables p q : R.
Hypothesis p_in : 0 < p < 1.
Hypothesis q_in : 0 < q < 1.
Variable n : nat.
Hypothesis n_pos : (1 <= n)%nat.
Notation u4 := (u (- (p + q)) (p * q)).
Notation b := (b (- (p + q)) (p * q) n).
Notation c := (c (- (p + q)) (p * q) n).

Let y (k : nat) : R := (-1) ^ k * orbit_x (- (p + q)) (p * q) n k.

Lemma y_recurrence k : y (S (S k)) = (p + q) * y (S k) - p * q * y k.
Proof. unfold y; rewrite x_SS; cbn; ring. Qed.
Lemma y_0 : y 0 = -1. Proof. unfold y; rewrite x_0; cbn; ring. Qed.

Lemma u_region4 : u4 n <> 0.
Proof.
  rewrite u_mirror; pose proof (u_pos p q n ltac:(lra) ltac:(lra) n_pos). destruct (sign_pow n) as [-> | ->]; lra.
Qed.

Lemma y_n : y n = - (-1) ^ n. Proof. unfold y; rewrite x_n by exact u_region4; ring. Qed.

Lemma b_y k : (k <= n)%nat -> b k = 1 + (-1) ^ k * y k.
Proof.
  intros Hk; rewrite b_is_1_plus_x by (exact u_region4 || assumption); unfold y.
  rewrite <- Rmult_assoc, sign_pow_square; ring.
Qed.

Lemma detIA_region4 : 0 < detIA (- (p + q)) (p * q) n.
Proof.
  replace (- (p + q)) with (- p + - q) by ring. replace (p * q) with (- p * - q) by ring; rewrite detIA_eigenvalues.
  replace (- p) with (-1 * p) by ring; replace (- q) with (-1 * q) by ring. rewrite !Rpow_mult_distr.
  pose proof (pow_below_1 p n p_in n_pos); pose proof (pow_below_1 q n q_in n_pos).
  destruct (sign_pow n) as [-> | ->]; apply Rmult_lt_0_compat; lra.
Qed.

(** Even n: y < -1 strictly between the ends. *)
Lemma y_even k : Nat.Even n -> (1 <= k <= n - 1)%nat -> y k < -1.
Proof.
  intros He Hk. pose proof (arch p q (fun k => - y k) n k p_in q_in) as H; cbn beta in H.
  rewrite y_0, y_n, sign_pow_even in H by assumption. enough (- -1 < - y k) by lra; apply H; try lra; [|lia].
  intros j; rewrite y_recurrence; ring.
Qed.

Lemma b_even k : Nat.Even n -> (1 <= k <= n - 1)%nat -> (Nat.Even k -> b k < 0) /\ (Nat.Odd k -> b k > 0).
Proof.
  intros He Hk; pose proof (y_even k He Hk); rewrite b_y by lia.
  split; intros H'; [rewrite sign_pow_even | rewrite sign_pow_odd]; assumption || lra.
Qed.

Lemma c_even : Nat.Even n -> c > 0.
Proof.
  intros He; apply c_pos; rewrite u_mirror, sign_pow_even by assumption.
  pose proof (u_pos p q n ltac:(lra) ltac:(lra) n_pos); pose proof detIA_region4; nra.
Qed.

(** Odd n: even k are harmless, and n - 2 decides for odd k. *)
Lemma b_odd_even k : Nat.Odd n -> Nat.Even k -> (1 <= k <= n - 1)%nat -> b k > 0.
Proof.
  intros Ho He Hk; rewrite b_y, sign_pow_even by (assumption || lia). enough (-1 < y k) by lra.
  apply (climb_above p q y n); try assumption; [exact y_recurrence | exact y_0 | | lia].
  rewrite y_n, sign_pow_odd by assumption; ring.
Qed.

Lemma b_odd_odd k : Nat.Odd n -> Nat.Odd k -> (k < n - 2)%nat -> b (n - 2) >= 0 -> b k > 0.
Proof.
  intros Ho Hok Hk; assert (Nat.Odd (n - 2)).
  { destruct Ho as [h Hh]; exists (h - 1)%nat; lia. }
  rewrite !b_y, !sign_pow_odd by (assumption || lia); intros Hb. enough (y k < 1) by lra.
  apply (climb_below p q y n) with (n - 2)%nat; try assumption; [exact y_recurrence | exact y_0 | | lia | lra].
  rewrite y_n, sign_pow_odd by assumption; ring.
Qed.

Lemma b_odd k : Nat.Odd n -> (1 <= k <= n - 1)%nat -> k <> (n - 2)%nat -> b (n - 2) >= 0 -> b k > 0.
Proof.
  intros Ho Hk Hne Hb; destruct (Nat.Even_or_Odd k) as [He|Hok].
  - apply b_odd_even; assumption.
  - apply b_odd_odd; try assumption. destruct Ho as [h Hh], Hok as [l Hl]; lia.
Qed.

Lemma c_odd : Nat.Odd n -> c < 0. Proof. apply c_neg_odd; lra. Qed.

End Region4.

Lemma region4_signs a1 a2 n : 0 < a2 < 1 -> - (a2 + 1) < a1 <= - 2 * sqrt a2 ->
  (n = 2%nat -> exists_iff a1 a2 n Plus Plus True) /\ ((4 <= n)%nat -> Nat.Even n -> no_orbit a1 a2 n) /\
  ((3 <= n)%nat -> Nat.Odd n -> u a1 a2 n <> 0 /\ exists_iff a1 a2 n Plus Minus (b a1 a2 n (n - 2) > 0) /\
  c a1 a2 n < 0 /\ (b a1 a2 n (n - 2) < 0 -> no_orbit a1 a2 n) /\ (b a1 a2 n (n - 2) = 0 -> forall k,
  (1 <= k <= n - 1)%nat -> k <> (n - 2)%nat -> b a1 a2 n k > 0)).
Proof.
  intros H2 H1. destruct (eigenvalues_region2 (- a1) a2) as (p & q & E1 & E2 & Hq & Hp); try lra.
  assert (a1 = - (p + q)) as -> by lra; clear E1; subst a2.
  assert (Hu : (1 <= n)%nat -> u (- (p + q)) (p * q) n <> 0) by (intros; apply u_region4; assumption). split; [|split].
  - intros ->; apply exists_Plus; [apply Hu; lia | lia | | ].
    + intros k Hk; assert (k = 1)%nat as -> by lia.
      apply b_even; try assumption; [lia | exists 1%nat; reflexivity | exists 0%nat; reflexivity].
    + cbn [sgn]; rewrite Rmult_1_l; apply c_even; try assumption; [lia | exists 1%nat; reflexivity].
  - intros Hn He; split; [apply Hu; lia|].
    exists 2%nat, 1%nat; repeat split; try lia; apply b_even; try assumption; try lia; [exists 1%nat; reflexivity |
      exists 0%nat; reflexivity].
  - intros Hn Ho. assert (Hc : c (- (p + q)) (p * q) n < 0) by (apply c_odd; assumption).
    assert (H : b (- (p + q)) (p * q) n (n - 1) > 0).
    { apply b_odd_even; try assumption; try lia. destruct Ho as [h Hh]; exists h; lia. }
    refine (conj (Hu ltac:(lia)) (conj _ (conj Hc (conj _ _)))).
    + apply exists_iff_Plus; [apply Hu; lia | | cbn; lra |].
      * exists (n - 1)%nat; split; [lia | assumption].
      * split; [intros Hb; apply Hb; lia | intros Hb k Hk]. destruct (Nat.eq_dec k (n - 2)) as [->|]; [assumption|].
        apply b_odd; try assumption; lra || lia.
    + intros Hb; split; [apply Hu; lia|]. exists (n - 2)%nat, (n - 1)%nat; repeat split; try lia; assumption.
    + intros Hb k Hk Hne; apply b_odd; try assumption; lra || lia.
Qed.

Theorem S5 : S5_statement.
Proof.
  intros a1 a2 n H2 H1; destruct (region4_signs a1 a2 n H2 H1) as (HA & HB & HC).
  split; [intros En; apply (HA En); tauto|split; [assumption|]]; intros Hn Ho.
  destruct (HC Hn Ho) as (Hu & Hex & Hc & Hneg & Hz); split; [assumption|].
  constructor; [cbn [sgn]; lra | lia | intros Hb; apply Hex; tauto | assumption | auto].
Qed.
