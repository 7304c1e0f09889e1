(** * For |a1| < a2 + 1, regions 2, 3 and 4, det (I - A^n) > 0

    From it the sign of the large eigenvalue (section 3.6) and the record form. *)

From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import Defs Statement StatementPlane Algebra RealEigenvalues Cases AppendixA Region4.
Open Scope R_scope.

Lemma square_below y z : 0 <= z -> y ^ 2 < z ^ 2 -> y < z.
Proof. intros; apply Rnot_le_lt; intros ?; nra. Qed.
Lemma pow_at_most_1 p n : 0 < p <= 1 -> 0 < p ^ n <= 1.
Proof. intros Hp; split; [apply pow_lt; lra|]. rewrite <- (pow1 n); apply pow_incr; lra. Qed.

(** Complex eigenvalues: v_n^2 = 4 a2^n + (a1^2 - 4 a2) u_n^2 < (1 + a2^n)^2. *)
Lemma detIA_complex a1 a2 n : 0 < a2 <= 1 -> a1 ^ 2 < 4 * a2 -> (1 <= n)%nat ->
  a2 < 1 \/ u a1 a2 n <> 0 -> 0 < detIA a1 a2 n.
Proof.
  intros H2 H1 Hn H; unfold detIA. enough (v a1 a2 n < 1 + a2 ^ n) by lra. pose proof (pow_at_most_1 a2 n H2).
  apply square_below; [lra | rewrite v_discriminant]. destruct H as [H|H].
  - pose proof (pow_below_1 a2 n ltac:(lra) Hn). pose proof (pow2_ge_0 (u a1 a2 n)); nra.
  - assert (0 < u a1 a2 n ^ 2) by nra. assert (0 < (4 * a2 - a1 ^ 2) * u a1 a2 n ^ 2) by (apply Rmult_lt_0_compat; lra).
    nra.
Qed.

(** Real eigenvalues, both of modulus below 1. *)
Lemma real_inside a1 a2 : 0 < a2 <= 1 -> Rabs a1 < a2 + 1 -> 4 * a2 <= a1 ^ 2 ->
  a2 < 1 /\ (2 * sqrt a2 <= a1 < a2 + 1 \/ 2 * sqrt a2 <= - a1 < a2 + 1).
Proof.
  intros H2 H1 H; apply Rabs_def2 in H1. assert (Es : sqrt a2 * sqrt a2 = a2) by (apply sqrt_sqrt; lra).
  assert (0 < sqrt a2) by (apply sqrt_lt_R0; lra). split; [apply Rnot_le_lt; intros ?; nra|].
  destruct (Rle_lt_dec 0 a1); [left | right]; (split; [|lra]).
  - apply Rnot_lt_le; intros ?; nra.
  - apply Rnot_lt_le; intros ?; nra.
Qed.

Lemma detIA_inside a1 a2 n : 0 < a2 <= 1 -> Rabs a1 < a2 + 1 -> (1 <= n)%nat ->
  a2 < 1 \/ u a1 a2 n <> 0 -> 0 < detIA a1 a2 n.
Proof.
  intros H2 H1 Hn H; destruct (Rlt_le_dec (a1 ^ 2) (4 * a2)) as [Hc|Hc].
  - apply detIA_complex; assumption.
  - destruct (real_inside a1 a2 H2 H1 Hc) as [Hlt [Hs|Hs]]; destruct (eigenvalues_region2 _ a2 ltac:(lra) Hs)
      as (p & q & E & -> & Hq & Hp).
    + rewrite E, detIA_eigenvalues. pose proof (pow_below_1 p n Hp Hn); pose proof (pow_below_1 q n Hq Hn).
      apply Rmult_lt_0_compat; lra.
    + assert (a1 = - (p + q)) as -> by lra; apply detIA_region4; assumption.
Qed.

(** ** The sign of the large eigenvalue *)

Lemma large_sign K gamma emu a1 a2 n : K <> 0 -> gamma <> 0 -> emu <> 0 -> u a1 a2 n <> 0 -> detIA a1 a2 n <> 0 ->
  exists m, 0 < m /\ large K gamma emu a1 a2 n * emu = m * detIA a1 a2 n.
Proof.
  intros HK Hg He Hu Hd. exists ((K * gamma * u a1 a2 n / detIA a1 a2 n) ^ 2 / 2); split.
  - enough (K * gamma * u a1 a2 n / detIA a1 a2 n <> 0) by nra.
    unfold Rdiv; repeat apply Rmult_integral_contrapositive_currified; try assumption; apply Rinv_neq_0_compat;
      assumption.
  - unfold large; fold (detIA a1 a2 n); field; split; assumption.
Qed.

Lemma detIA_region1 a1 a2 n : 0 < a2 -> a2 + 1 < a1 -> (1 <= n)%nat -> detIA a1 a2 n < 0.
Proof.
  intros H2 H1 Hn; destruct (eigenvalues_region1 a1 a2 H2 H1) as (p & q & -> & -> & Hq & Hp). rewrite detIA_eigenvalues.
  pose proof (pow_below_1 q n Hq Hn); pose proof (pow_above_1 p n Hp Hn); nra.
Qed.

Lemma detIA_region5 a1 a2 n : 0 < a2 -> a1 < - (a2 + 1) -> (1 <= n)%nat -> 0 < (-1) ^ (n + 1) * detIA a1 a2 n.
Proof.
  intros H2 H1 Hn; destruct (region5_signs a1 a2 n H2 Hn (or_introl H1)) as (Hu & _ & Hc & _). rewrite pow_add, pow_1.
  pose proof (detIA_mirror (- a1) a2 n) as E; rewrite Ropp_involutive in E; rewrite E.
  destruct (eigenvalues_region1 (- a1) a2) as (p & q & E1 & -> & Hq & Hp); try lra.
  rewrite E1, v_eigenvalues, Rpow_mult_distr. pose proof (pow_below_1 q n Hq Hn); pose proof (pow_above_1 p n Hp Hn).
  destruct (sign_pow n) as [-> | ->]; nra.
Qed.

(** On the line a1 = -(a2+1) the eigenvalues are -1 and -a2. *)
Lemma detIA_line_left a2 n : 0 < a2 -> Nat.Odd n -> 0 < detIA (- (a2 + 1)) a2 n.
Proof.
  intros H2 Ho; rewrite detIA_mirror, sign_pow_odd by assumption.
  pose proof (v_eigenvalues 1 a2 n) as E; rewrite Rmult_1_l, (Rplus_comm 1), pow1 in E.
  rewrite E; pose proof (pow_lt a2 n H2); lra.
Qed.

Theorem Large : Large_statement.
Proof.
  intros K gamma emu a1 a2 n HK Hg He H2 Hn Hu.
  assert (L := large_sign K gamma emu a1 a2 n HK Hg He Hu); split; [|split; [|split]]; intros H1.
  - pose proof (detIA_region1 a1 a2 n ltac:(lra) H1 Hn). destruct L as (m & Hm & ->); [lra | nra].
  - pose proof (detIA_inside a1 a2 n H2 H1 Hn (or_intror Hu)). destruct L as (m & Hm & ->); [lra | nra].
  - pose proof (detIA_region5 a1 a2 n ltac:(lra) H1 Hn) as Hd.
    destruct L as (m & Hm & E); [intros E; rewrite E in Hd; lra|]. rewrite Rmult_assoc, E; nra.
  - intros Ho; subst a1; pose proof (detIA_line_left a2 n ltac:(lra) Ho). destruct L as (m & Hm & ->); [lra | nra].
Qed.

(** ** The record form *)

Theorem Record_identity : Record_identity_statement.
Proof.
  intros a1 a2 n k Hk; pose proof (u_v_cross a1 a2 (n - k) k) as H. replace (n - k + k)%nat with n in H by lia; lra.
Qed.

Section RecordForm.
Variables a1 a2 : R.
Hypothesis a2_in : 0 < a2 <= 1.
Hypothesis a1_in : Rabs a1 < a2 + 1.
Notation u := (u a1 a2).
Notation v := (v a1 a2).
Notation f := (f a1 a2).

Lemma v_below_2 j : (1 <= j)%nat -> a2 < 1 \/ u j <> 0 -> 0 < 2 - v j.
Proof.
  intros Hj H; pose proof (detIA_inside a1 a2 j a2_in a1_in Hj H) as Hd.
  pose proof (pow_at_most_1 a2 j a2_in); unfold detIA in Hd; lra.
Qed.

(** 2 - v_j vanishes only on the circle, with u_j. *)
Lemma v_cases j : (1 <= j)%nat -> 0 < 2 - v j \/ a2 = 1 /\ 2 - v j = 0 /\ u j = 0.
Proof.
  intros Hj; destruct (Req_dec a2 1) as [E|]; [|left; apply v_below_2; [assumption | left; lra]].
  destruct (Req_dec (u j) 0) as [E0|]; [|left; apply v_below_2; tauto].
  pose proof (v_discriminant a1 a2 j) as D; rewrite E0, E, pow1 in D; rewrite E in *.
  assert (F : (Defs.v a1 1 j - 2) * (Defs.v a1 1 j + 2) = 0) by lra.
  destruct (Rmult_integral _ _ F); [right; repeat split | left]; lra.
Qed.

Lemma f_u j : (1 <= j)%nat -> u j = f j * (2 - v j).
Proof. intros Hj; destruct (v_cases j Hj) as [H|(_ & -> & ->)]; [|ring]. unfold StatementPlane.f; field; lra. Qed.
Lemma f_zero j : u j = 0 -> f j = 0. Proof. unfold StatementPlane.f, Rdiv; intros ->; ring. Qed.

(** Where v_k = 2 the sequence u has the period k, and b_{n,k} = 0. *)
Lemma closed_turn n k : (1 <= k <= n - 1)%nat -> 2 - v k = 0 -> u k = 0 -> a2 = 1 -> f n = f (n - k) /\ b a1 a2 n k = 0.
Proof.
  intros Hk Hv Hu E.
  assert (H : forall j, u (j + k) = u j).
  { intros j; pose proof (u_v_cross a1 a2 j k) as C; rewrite Hu, E, pow1 in C; rewrite E.
    rewrite E in Hv; replace (Defs.v a1 1 k) with 2 in C by lra; lra. }
  assert (En : u n = u (n - k)) by (rewrite <- (H (n - k)%nat); f_equal; lia).
  assert (ESn : u (S n) = u (S (n - k))) by (rewrite <- (H (S (n - k))); f_equal; lia).
  split; [unfold StatementPlane.f, Defs.v; rewrite En, ESn; reflexivity|].
  unfold b; rewrite Hu, <- En, E, pow1; unfold Rdiv; ring.
Qed.

Lemma b_records n k : (1 <= k <= n - 1)%nat -> u n <> 0 -> 0 < 2 - v k ->
  exists m, 0 < m /\ u n * b a1 a2 n k = m * (f n - f k).
Proof.
  intros Hk Hu Hv; exists ((2 - v n) * (2 - v k) / 2). pose proof (v_below_2 n ltac:(lia) ltac:(tauto)).
  split; [apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra|].
  pose proof (Record_identity a1 a2 n k ltac:(lia)) as E.
  unfold b; replace (u n * (_ / u n)) with (u n - u k - a2 ^ k * u (n - k)) by (field; assumption).
  rewrite (f_u n), (f_u k) in * by lia; lra.
Qed.

Lemma c_u n : (1 <= n)%nat -> u n <> 0 -> (0 < u n -> c a1 a2 n < 0) /\ (u n < 0 -> c a1 a2 n > 0).
Proof.
  intros Hn Hu; pose proof (detIA_inside a1 a2 n a2_in a1_in Hn ltac:(tauto)).
  split; intros; [apply c_neg | apply c_pos]; nra.
Qed.

(** The orbit in terms of the signs of u_n and of u_n b_{n,k} only. *)
Lemma orbit_signs n e g : (1 <= n)%nat -> orbit a1 a2 n e g <-> sgn e * sgn g * u n < 0 /\ forall k,
  (1 <= k <= n - 1)%nat -> 0 < sgn e * u n * (u n * b a1 a2 n k).
Proof.
  intros Hn; split.
  - intros (Hu & Hb & Hc); destruct (c_u n Hn Hu) as [Hp Hm]; assert (Hsq : 0 < u n * u n) by nra.
    split; [|intros k Hk; specialize (Hb k Hk); nra].
    destruct e, g, (Rdichotomy _ _ Hu) as [H|H]; cbn [sgn] in *; specialize (Hp H) || specialize (Hm H); lra.
  - intros (Hc & Hb). assert (Hu : u n <> 0) by (intros E; rewrite E in Hc; lra). destruct (c_u n Hn Hu) as [Hp Hm].
    assert (Hsq : 0 < u n * u n) by nra; split; [assumption | split].
    + intros k Hk; specialize (Hb k Hk); nra.
    + destruct e, g, (Rdichotomy _ _ Hu) as [H|H]; cbn [sgn] in *; specialize (Hp H) || specialize (Hm H); lra.
Qed.

Lemma record_case n e g : (2 <= n)%nat -> orbit a1 a2 n e g <-> sgn e * sgn g * f n < 0 /\ forall k,
  (1 <= k <= n - 1)%nat -> 0 < sgn e * f n * (f n - f k).
Proof.
  intros Hn; rewrite orbit_signs by lia.
  destruct (Req_dec (u n) 0) as [E0|Hu].
  { rewrite E0, (f_zero n E0), Rmult_0_r; split; intros [H _]; lra. }
  pose proof (v_below_2 n ltac:(lia) ltac:(tauto)) as Hv; pose proof (f_u n ltac:(lia)) as Eu.
  set (w := 2 - v n) in *; clearbody w.
  assert (H : sgn e * sgn g * u n < 0 <-> sgn e * sgn g * f n < 0).
  { rewrite Eu, <- Rmult_assoc; split; intros; nra. }
  rewrite H; split; intros [Hf Hk]; (split; [assumption|]); intros k Hkn; pose proof (Hk k Hkn) as Hkk;
    destruct (v_cases k ltac:(lia)) as [Hvk|(Ea & Hvk & Huk)].
  - destruct (b_records n k Hkn Hu Hvk) as (m & Hm & E).
    assert (Hwm : 0 < w * m) by (apply Rmult_lt_0_compat; assumption). apply Rmult_lt_reg_l with (w * m); [assumption|].
    rewrite E, Eu in Hkk; lra.
  - exfalso; destruct (closed_turn n k Hkn Hvk Huk Ea) as [_ E]; rewrite E in Hkk; lra.
  - destruct (b_records n k Hkn Hu Hvk) as (m & Hm & E).
    assert (Hwm : 0 < w * m) by (apply Rmult_lt_0_compat; assumption). rewrite E, Eu.
    replace (sgn e * (f n * w) * (m * (f n - f k))) with (w * m * (sgn e * f n * (f n - f k))) by ring.
    apply Rmult_lt_0_compat; assumption.
  - exfalso; destruct (closed_turn n k Hkn Hvk Huk Ea) as [E _].
    specialize (Hk (n - k)%nat ltac:(lia)); rewrite <- E in Hk; lra.
Qed.

Lemma f_1 : 0 < f 1.
Proof. apply Rabs_def2 in a1_in; unfold StatementPlane.f; rewrite u_1, v_1. apply Rdiv_lt_0_compat; lra. Qed.

End RecordForm.

Theorem Record_form : Record_statement.
Proof.
  intros a1 a2 n H2 H1 Hn; rewrite !record_case by assumption; unfold high, low.
  cbn [sgn]; refine (conj _ (conj _ (conj _ (conj _ _)))).
  - intros j Hj; destruct (v_cases a1 a2 H2 H1 j Hj); [left; lra | tauto].
  - split; intros [Hl Hr]; (split; [intros k Hk | lra]) || (split; [lra | intros k Hk]); specialize (Hl k Hk) ||
      specialize (Hr k Hk); nra.
  - split; intros [Hl Hr]; (split; [intros k Hk | lra]) || (split; [lra | intros k Hk]); specialize (Hl k Hk) ||
      specialize (Hr k Hk); nra.
  - split; intros [Hl Hr]; (split; [intros k Hk | lra]) || (split; [lra | intros k Hk]); specialize (Hl k Hk) ||
      specialize (Hr k Hk); nra.
  - intros [Hl Hr]; specialize (Hr 1%nat ltac:(lia)). pose proof (f_1 a1 a2 H2 H1); nra.
Qed.
