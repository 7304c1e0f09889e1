(** * With damping the word ends: V is finite if a2 < 1

    The p_n of V are bounded by W1, while (u_{n+1} - 1) / u_n is not, as u_n tends to 0. *)

From Coq Require Import Reals List Arith Lra Lia Classical.
From Grazing Require Import Defs Statement StatementPlane StatementWords Algebra Polar Coordinates RealEigenvalues
  AppendixA InsideTriangle WordAlgebra WordPath WordGraph WordPatterns WordPlane.
Import ListNotations. Open Scope R_scope.

Lemma decay_real p q : 0 < p < 1 -> 0 < q < 1 ->
  exists C t, 0 < C /\ 0 < t < 1 /\ forall n, Rabs (u (- (p + q)) (p * q) n) <= C * t ^ n.
Proof.
  intros Hp Hq; set (m := Rmax p q); set (t := (1 + m) / 2).
  assert (Hm : p <= m /\ q <= m /\ m < 1) by (unfold m, Rmax; destruct Rle_dec; lra).
  assert (Ht : m < t < 1) by (unfold t; lra). assert (HC : 0 < / (t - p)) by (apply Rinv_0_lt_compat; lra).
  exists (/ (t - p)), t; split; [assumption | split; [lra|]].
  assert (E : forall n, Rabs (u (- (p + q)) (p * q) n) = u (p + q) (p * q) n).
  { intros [|n]; [rewrite !u_0; apply Rabs_R0|].
    pose proof (u_pos p q (S n) ltac:(lra) ltac:(lra) ltac:(lia)); rewrite u_mirror, Rabs_mult, Rabs_Ropp.
    rewrite (Rabs_right (u (p + q) (p * q) (S n))) by lra.
    destruct (sign_pow (S n)) as [-> | ->]; [rewrite Rabs_R1 | rewrite Rabs_left by lra]; ring. }
  intros n; rewrite E; induction n as [|n IH]; [rewrite u_0; cbn [pow]; lra|].
  rewrite u_step; cbn [pow]; pose proof (pow_lt t n ltac:(lra)). assert (q ^ n <= t ^ n) by (apply pow_incr; lra).
  assert (p * u (p + q) (p * q) n <= p * (/ (t - p) * t ^ n)) by (apply Rmult_le_compat_l; lra).
  assert (Ec : / (t - p) * (t - p) = 1) by (field; lra).
  replace (/ (t - p) * (t * t ^ n)) with (p * (/ (t - p) * t ^ n) + / (t - p) * (t - p) * t ^ n) by ring.
  rewrite Ec; lra.
Qed.

Lemma decay_complex r s : 0 < r < 1 -> 0 < s < 1 / 2 ->
  exists C t, 0 < C /\ 0 < t < 1 /\ forall n, Rabs (u (trace r s) (r ^ 2) n) <= C * t ^ n.
Proof.
  intros Hr Hs; pose proof (two_pi_s s Hs) as Hth. assert (Hsin : 0 < sin (2 * PI * s)) by (apply sin_gt_0; lra).
  assert (Hd : 0 < r * sin (2 * PI * s)) by (apply Rmult_lt_0_compat; lra).
  exists (/ (r * sin (2 * PI * s))), r; split; [apply Rinv_0_lt_compat; assumption | split; [assumption|]].
  intros n; pose proof (u_polar r (2 * PI * s) n) as E; fold (trace r s) in E.
  pose proof (pow_lt r n ltac:(lra)); pose proof (SIN_bound (INR n * (2 * PI * s))) as Hb.
  set (d := r * sin (2 * PI * s)) in *; apply Rmult_le_reg_r with d; [assumption|].
  replace (/ d * r ^ n * d) with (r ^ n) by (field; lra).
  rewrite <- (Rabs_right d) at 1 by lra; rewrite <- Rabs_mult, E, Rabs_mult, (Rabs_right (r ^ n)) by lra.
  assert (Rabs (sin (INR n * (2 * PI * s))) <= 1) by (apply Rabs_le; lra); nra.
Qed.

Section Finite.
Variables (a1 a2 : R) (K : nat).
Hypothesis first : first_upper a1 a2 K.
Hypothesis damped : a2 < 1.
Notation u := (u a1 a2).
Notation p := (p a1 a2).

Lemma decay : exists C t, 0 < C /\ 0 < t < 1 /\ forall n, Rabs (u n) <= C * t ^ n.
Proof.
  pose proof (WordPath.a2_in a1 a2 K first) as H2; destruct (Rlt_le_dec (a1 ^ 2) (4 * a2)) as [H4|H4].
  - destruct (Coordinates a1 a2 H4) as (r & s & Hr & Hs & -> & -> & _).
    apply decay_complex; [split; [|apply Rnot_le_lt; intros ?]; nra | assumption].
  - destruct (real_is_region4 a1 a2 K first ltac:(lra)) as [H2' H1].
    destruct (eigenvalues_region2 (- a1) a2) as (x & y & E1 & -> & Hq & Hp); try lra.
    replace a1 with (- (x + y)) by lra; apply decay_real; assumption.
Qed.

Lemma V_finite : exists L, forall n, (L <= n)%nat -> ~ member a1 a2 Plus n.
Proof.
  destruct decay as (C & t & HC & Ht & Hu); set (P := Rabs (p 1) + Rabs (p K) + 1).
  assert (HP : 0 < P) by (unfold P; pose proof (Rabs_pos (p 1)); pose proof (Rabs_pos (p K)); lra).
  assert (Hy : 0 < / (C * (2 * P + 2))) by (apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra).
  destruct (pow_lt_1_zero t ltac:(rewrite Rabs_right; lra) _ Hy) as [L HL].
  assert (Hsmall : forall n, (L <= n)%nat -> Rabs (u n) * (2 * P + 2) < 1).
  { intros n Hn; specialize (HL n Hn); rewrite Rabs_right in HL by (pose proof (pow_lt t n ltac:(lra)); lra).
    apply (Rmult_lt_compat_l (C * (2 * P + 2))) in HL; [|apply Rmult_lt_0_compat; lra].
    rewrite Rinv_r in HL by (apply Rgt_not_eq, Rmult_lt_0_compat; lra).
    specialize (Hu n); assert (Rabs (u n) * (2 * P + 2) <= C * t ^ n * (2 * P + 2)) by (apply Rmult_le_compat_r; lra);
      lra. }
  exists (L + K + 2)%nat; intros n Hn HV; pose proof HV as [Hne _]. assert (a2_pos : 0 < a2) by apply first.
  destruct (nested a1 a2 Plus a2_pos 1 n ltac:(lia) HV) as [H1 _].
  destruct (nested a1 a2 Plus a2_pos K n ltac:(lia) HV) as [_ H2].
  pose proof (on_one a1 a2) as D1; pose proof (K_upper a1 a2 K first) as UK; cbn [on sgn] in *.
  destruct H1 as [H1 _]; [lra|]; destruct H2 as [H2 _]; [lra|].
  pose proof (Hsmall n ltac:(lia)) as S1; pose proof (Hsmall (S n) ltac:(lia)) as S2.
  assert (E : p n * u n = u (S n) - 1) by (unfold StatementWords.p; field; assumption).
  assert (Hpn : Rabs (p n) <= P).
  { unfold P; pose proof (Rle_abs (p K)); pose proof (Rle_abs (- p 1)) as Hm; rewrite Rabs_Ropp in Hm.
    pose proof (Rabs_pos (p 1)); pose proof (Rabs_pos (p K)); apply Rabs_le; lra. }
  assert (Rabs (p n * u n) <= P * Rabs (u n)) by (rewrite Rabs_mult; apply Rmult_le_compat_r;
    [apply Rabs_pos | assumption]).
  rewrite E in *; pose proof (Rle_abs (- (u (S n) - 1))) as Hm; rewrite Rabs_Ropp in Hm.
  pose proof (Rle_abs (u (S n))); pose proof (Rabs_pos (u n)); pose proof (Rabs_pos (u (S n))).
  assert (0 <= Rabs (u (S n)) * P) by (apply Rmult_le_pos; lra); lra.
Qed.

Lemma word_ends : exists w i j, path a1 a2 K w i j /\
  Forall (fun x => member a1 a2 Plus (fst x)) (vertices K w) /\ ~ member a1 a2 Plus (i + j).
Proof.
  destruct V_finite as [L HL]; apply NNPP; intros Hno.
  assert (Hlong : forall k, exists w i j, path a1 a2 K w i j /\ (k <= i + j)%nat /\
    Forall (fun x => member a1 a2 Plus (fst x)) (vertices K w)).
  { induction k as [|k (w & i & j & Hp & Hk & HF)].
    - exists [], 1%nat, K; split; [constructor | split; [lia|]]; unfold vertices; cbn [periods].
      rewrite !Forall_cons_iff; cbn [fst]. split; [apply member_one | split; [apply member_K, first | constructor]].
    - assert (HV : member a1 a2 Plus (i + j)) by (apply NNPP; intros Hn; apply Hno; eauto 6).
      pose proof (path_pos a1 a2 K w i j Hp); pose proof (K_ge_2 a1 a2 K first).
      assert (HF' : forall x, Forall (fun x => member a1 a2 Plus (fst x)) (vertices K (w ++ [x]))).
      { intros x; rewrite (vertices_snoc a1 a2 K w i j x Hp), Forall_app, Forall_cons_iff.
        split; [assumption | split; [assumption | constructor]]. }
      destruct (Rdichotomy _ _ (proj1 HV)) as [Hs|Hs].
      + exists (w ++ [U]), i, (i + j)%nat; split; [constructor; assumption | split; [lia | apply HF']].
      + exists (w ++ [D]), (i + j)%nat, j; split; [constructor; assumption | split; [lia | apply HF']]. }
  destruct (Hlong L) as (w & i & j & Hp & Hk & HF); apply Hno; exists w, i, j.
  split; [assumption | split; [assumption | apply HL, Hk]].
Qed.
End Finite.
