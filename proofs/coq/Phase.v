(** * b_{n,k} <= 0 iff V contains a point at time k with the phase al + k th, mod 2 pi

    Section 1 of ../conjecture1.md. x_k = C A^k X, a solution of the recurrence with
    x_0 = x_n = -1, is written -r^k cos (al + k th) / cos al. *)

From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs Derivatives Polar LnCos Convex Lattice.
Open Scope R_scope.

(** ** Periodicity over Z *)

Lemma periods_Z x l : cos (x - IZR l * (2 * PI)) = cos x /\ sin (x - IZR l * (2 * PI)) = sin x.
Proof. rewrite <- (cos_periods (- l) x), <- (sin_periods (- l) x), opp_IZR; split; f_equal; ring. Qed.
Lemma periods_nat x k : cos (x - INR k * (2 * PI)) = cos x /\ sin (x - INR k * (2 * PI)) = sin x.
Proof. rewrite INR_IZR_INZ; apply periods_Z. Qed.

Lemma cos_pos_window x : - (3 * (PI / 2)) <= x <= 3 * (PI / 2) -> 0 < cos x -> window x.
Proof.
  intros Hx Hc; unfold window; split; apply Rnot_le_lt; intros H.
  - rewrite <- cos_neg in Hc; apply Rlt_not_le in Hc; apply Hc, cos_le_0; lra.
  - apply Rlt_not_le in Hc; apply Hc, cos_le_0; lra.
Qed.

Lemma cos_pos_window_mod x : 0 < cos x -> exists l : Z, window (x - IZR l * (2 * PI)).
Proof.
  intros Hc; pose proof PI_RGT_0. destruct (archimed (x / (2 * PI) - 1 / 2)) as [H1 H2].
  set (l := up (x / (2 * PI) - 1 / 2)) in *; exists l. assert (E : x = x / (2 * PI) * (2 * PI)) by (field; lra).
  apply cos_pos_window; [rewrite E; split; nra|]. now destruct (periods_Z x l) as [-> _].
Qed.

(** ** The phases of a point (r, th), r <= 1, where sin (n th) <> 0 *)

Definition regular (r th : R) (n m : nat) : Prop :=
  0 < r <= 1 /\ 0 < th < PI /\ (1 <= n)%nat /\ sin (INR n * th) <> 0 /\
  Rabs (INR n * th - INR m * (2 * PI)) < PI.

Section Phase.

Variables r th : R.
Variables n m : nat.
Hypothesis H : regular r th n m.
Let Hr : 0 < r <= 1 := proj1 H.
Let Hsin : sin (INR n * th) <> 0 := proj1 (proj2 (proj2 (proj2 H))).
Let Hm : Rabs (INR n * th - INR m * (2 * PI)) < PI := proj2 (proj2 (proj2 (proj2 H))).

Let Hn : 0 < INR n.
Proof. apply lt_0_INR, H. Qed.

Let L := ln r.
Let b := b (2 * r * cos th) (r ^ 2) n.

Definition alpha : R := atan ((cos (INR n * th) - / r ^ n) / sin (INR n * th)).
Definition beta : R := alpha + INR n * th - INR m * (2 * PI).

(** The phase at time k, less l turns. *)
Definition phase (k : nat) (l : Z) : R := alpha + INR k * th - IZR l * (2 * PI).

Lemma r_pow_pos k : 0 < r ^ k. Proof. apply pow_lt; lra. Qed.
Lemma window_alpha : window alpha.
Proof. destruct (atan_bound ((cos (INR n * th) - / r ^ n) / sin (INR n * th))). unfold window, alpha; lra. Qed.
Lemma cos_alpha_pos : 0 < cos alpha. Proof. apply window_cos, window_alpha. Qed.

Lemma sin_alpha : sin alpha * (r ^ n * sin (INR n * th)) = cos alpha * (r ^ n * cos (INR n * th) - 1).
Proof.
  pose proof cos_alpha_pos; pose proof (r_pow_pos n).
  assert (E : sin alpha = cos alpha * tan alpha) by (unfold tan; field; lra).
  rewrite E; unfold alpha at 2; rewrite tan_atan; field; split; [lra|assumption].
Qed.

Lemma cos_beta : r ^ n * cos beta = cos alpha.
Proof.
  unfold beta; destruct (periods_nat (alpha + INR n * th) m) as [-> _]. rewrite cos_plus; pose proof sin_alpha; lra.
Qed.

Lemma window_beta : window beta.
Proof.
  apply cos_pos_window.
  - pose proof window_alpha; pose proof (Rabs_def2 _ _ Hm); unfold window, beta in *; lra.
  - pose proof cos_beta; pose proof cos_alpha_pos; pose proof (r_pow_pos n); nra.
Qed.

Lemma L_nonpos : L <= 0.
Proof. unfold L; rewrite <- ln_1; destruct (Req_dec r 1) as [->|]; [lra|]. apply Rlt_le, ln_increasing; lra. Qed.

Lemma ln_pow_r k : ln (r ^ k) = INR k * L.
Proof.
  unfold L; induction k as [|k IH]; [simpl; rewrite ln_1; ring|].
  rewrite S_INR; simpl; rewrite ln_mult, IH; [ring|lra|apply r_pow_pos].
Qed.

Lemma cos_n_lt_1 : cos (INR n * th) < 1.
Proof. pose proof (sin2_cos2 (INR n * th)) as E; unfold Rsqr in E; nra. Qed.

Lemma sin_sin_alpha : sin (INR n * th) * sin alpha < 0.
Proof.
  pose proof sin_alpha; pose proof cos_alpha_pos; pose proof (r_pow_pos n).
  assert (r ^ n <= 1) by (rewrite <- (pow1 n); apply pow_incr; lra). pose proof cos_n_lt_1.
  assert (r ^ n * cos (INR n * th) < 1) by nra. apply (Rmult_lt_reg_l (r ^ n)); [assumption|].
  replace (r ^ n * (sin (INR n * th) * sin alpha)) with (cos alpha * (r ^ n * cos (INR n * th) - 1)) by lra; nra.
Qed.

(** alpha has the sign of 2 pi m - n th. *)
Lemma alpha_pos : INR n * th < INR m * (2 * PI) -> sin (INR n * th) < 0 /\ alpha > 0.
Proof.
  intros Hlt; pose proof (Rabs_def2 _ _ Hm).
  assert (Hs : sin (INR n * th) < 0).
  { destruct (periods_nat (INR n * th) m) as [_ <-]; apply sin_lt_0_var; lra. }
  split; [assumption|]; pose proof sin_sin_alpha. pose proof window_alpha as Hw; unfold window in Hw.
  apply Rnot_le_gt; intros Hle; assert (sin alpha <= 0); [|nra].
  rewrite <- (Ropp_involutive alpha), sin_neg; pose proof (sin_ge_0 (- alpha)); lra.
Qed.

Lemma alpha_neg : INR m * (2 * PI) < INR n * th -> sin (INR n * th) > 0 /\ alpha < 0.
Proof.
  intros Hlt; pose proof (Rabs_def2 _ _ Hm).
  assert (Hs : sin (INR n * th) > 0).
  { destruct (periods_nat (INR n * th) m) as [_ <-]; apply sin_gt_0; lra. }
  split; [assumption|]; pose proof sin_sin_alpha. pose proof window_alpha as Hw; unfold window in Hw.
  apply Rnot_le_gt; intros Hle; assert (sin alpha >= 0); [|nra]. pose proof (sin_ge_0 alpha); lra.
Qed.

Lemma phases_chord : chord alpha beta L (INR n).
Proof.
  pose proof window_alpha; pose proof window_beta; pose proof L_nonpos.
  assert (alpha <> beta).
  { unfold beta; intros E; apply Hsin; destruct (periods_nat (INR n * th) m) as [_ <-].
    replace (INR n * th - INR m * (2 * PI)) with 0 by lra; apply sin_0. }
  refine (conj _ (conj _ (conj _ (conj _ (conj _ _))))); trivial.
  unfold lncos; rewrite <- cos_beta, ln_mult, ln_pow_r; [ring|apply r_pow_pos|now apply window_cos].
Qed.

Lemma phase_W k l : phase k l = W alpha beta (INR n) (INR k) (INR k * INR m - IZR l * INR n).
Proof. unfold phase, W, beta; field; lra. Qed.

(** The key identity. *)
Lemma b_phase k : (k <= n)%nat -> b k * cos alpha = cos alpha - r ^ k * cos (alpha + INR k * th).
Proof.
  intros Hk; pose proof (r_pow_pos n). assert (Hs : sin th > 0) by (apply sin_gt_0; apply H).
  assert (Hd : r ^ n * sin (INR n * th) <> 0) by (apply Rmult_integral_contrapositive_currified; [lra|assumption]).
  assert (Hu : u (2 * r * cos th) (r ^ 2) n <> 0) by (apply u_zero; trivial; lra).
  apply (Rmult_eq_reg_r (r ^ n * sin (INR n * th))); [|assumption].
  replace (b k * cos alpha * (r ^ n * sin (INR n * th))) with (cos alpha * (b k * (r ^ n * sin (INR n * th)))) by ring.
  unfold b; rewrite b_polar by (trivial; lra).
  rewrite minus_INR, Rmult_minus_distr_r, sin_minus, cos_plus, pow_add by lia.
  pose proof sin_alpha as E; apply (f_equal (Rmult (r ^ k * sin (INR k * th)))) in E. nra.
Qed.

Lemma gap_phase k l : window (phase k l) -> (k <= n)%nat -> (0 <= gap alpha L (INR k) (phase k l) <-> b k <= 0) /\
  (0 < gap alpha L (INR k) (phase k l) <-> b k < 0).
Proof.
  intros Hw Hk; pose proof (b_phase k Hk) as E; pose proof cos_alpha_pos.
  pose proof (window_cos _ Hw) as Hc; pose proof (r_pow_pos k).
  assert (Eg : gap alpha L (INR k) (phase k l) = ln (r ^ k * cos (phase k l)) - ln (cos alpha)).
  { rewrite ln_mult, ln_pow_r by assumption; unfold gap, lncos; ring. }
  unfold phase in *; destruct (periods_Z (alpha + INR k * th) l) as [Ep _].
  rewrite Ep in *; set (x := r ^ k * cos (alpha + INR k * th)) in *. assert (0 < x) by (unfold x; nra).
  rewrite Eg; split; split; intros Hg.
  - apply Rmult_le_reg_r with (cos alpha); [lra|]. enough (~ x < cos alpha) by lra.
    intros Hlt; apply ln_increasing in Hlt; lra.
  - assert (Hle : cos alpha <= x) by nra. destruct Hle as [Hlt| ->]; [apply ln_increasing in Hlt|]; lra.
  - apply Rmult_lt_reg_r with (cos alpha); [lra|]. enough (cos alpha < x) by lra. apply ln_lt_inv; trivial; lra.
  - assert (Hlt : cos alpha < x) by nra; apply ln_increasing in Hlt; lra.
Qed.

Lemma b_nonpos k : (k <= n)%nat -> (b k <= 0 <-> exists l, V alpha L (INR k) (phase k l)).
Proof.
  intros Hk; split.
  - intros Hb; destruct (cos_pos_window_mod (alpha + INR k * th)) as [l Hl].
    { pose proof (b_phase k Hk); pose proof cos_alpha_pos; pose proof (r_pow_pos k); nra. }
    exists l; split; [exact Hl|]; now apply gap_phase.
  - intros (l & Hw & Hg); now apply (gap_phase k l).
Qed.

Lemma b_neg k l : (k <= n)%nat -> inside alpha L (INR k) (phase k l) -> b k < 0.
Proof. intros Hk [Hw Hg]; now apply (gap_phase k l). Qed.

End Phase.
