(** * Periodic words are periodic motions; and which (a1, a2) oscillators have *)
From Coq Require Import Reals ZArith Lra Lia List.
From Grazing Require Import Defs StatementOscillator Derivatives Flow OscillatorTurns.
Open Scope R_scope.

(** ** The motion P turns later *)
Section Later.
Variables (O : Oscillator.t) (m : sign) (P : Z).
Let T := turn m * IZR P.
Definition later (f : R -> R) (x : R) : R := facing m P * f (x + T).

Lemma D_later f f' x : derivable_pt_lim f (x + T) (f' (x + T)) -> derivable_pt_lim (later f) x (later f' x).
Proof.
  intros H; unfold later; apply D_scale; apply (D_value _ _ (f' (x + T) * 1)); [|ring].
  apply (D_of (fun x => x + T) f); [derive_by fail; ring | exact H].
Qed.
Lemma gap_later mu z q x : gap O m mu z (later q) x = gap O m mu (z + P) q (x + T) /\
  speed O m mu z (later q) x = speed O m mu (z + P) q (x + T).
Proof.
  unfold gap, speed, later; rewrite facing_plus, plus_IZR.
  replace (x + T - turn m * (IZR z + IZR P)) with (x - turn m * IZR z) by (unfold T; ring); split; ring.
Qed.
End Later.

Lemma motion_later O m mu d N t q v r P : motion O m mu d N t q v -> (forall i, N (i + r) = N i + P)%Z ->
  motion O m mu d N (fun i => t (i + r)%Z - turn m * IZR P) (fun i => later m P (q (i + r)%Z))
    (fun i => later m P (v (i + r)%Z)).
Proof.
  intros HM HN l j ->; set (T := turn m * IZR P); destruct (HM (l + r)%Z (l + 1 + r)%Z ltac:(lia))
    as [F D L Q0 Q1 A V1 V2].
  rewrite !HN in *; assert (back : forall y, y - T + turn m * IZR P = y) by (intros; unfold T; ring); constructor.
  - intros y; destruct (F (y + T)) as [F1 F2]; split; [apply D_later, F1|].
    eapply D_value;
      [apply (D_later m P (v (l + r)%Z) (fun y => - Oscillator.c O * v (l + r)%Z y - Oscillator.k O * q (l + r)%Z y)),
      F2|]; unfold later; ring.
  - eapply Rle_trans; [|exact D]; right; f_equal; unfold T; rewrite plus_IZR; ring.
  - lra.
  - rewrite (proj1 (gap_later _ _ _ _ _ _ _)), back; exact Q0.
  - rewrite (proj1 (gap_later _ _ _ _ _ _ _)), back; exact Q1.
  - intros z y Hy; rewrite (proj1 (gap_later _ _ _ _ _ _ _)); apply A; fold T; lra.
  - rewrite (proj2 (gap_later _ _ _ _ _ _ _)), back; exact V1.
  - rewrite !(proj2 (gap_later _ _ _ _ _ _ _)), back; exact V2.
Qed.

Theorem Periodic_oscillator : Periodic_oscillator_statement.
Proof.
  intros O m mu d N t q v r P _ (t0 & q0 & v0 & _ & Only) HM HN i x; pose proof (motion_later _ _ _ _ _ _ _ _ _ _ HM HN)
    as HM'.
  destruct (Only _ _ _ HM i x) as (E1 & E2 & E3), (Only _ _ _ HM' i x) as (F1 & F2 & F3); cbv beta in F1.
  unfold later in F2, F3; rewrite F2, F3, E2, E3; split; [lra | auto].
Qed.

(** ** The matrix in terms of the undamped solution *)
Lemma matrix_damped c D m o w : undamped D o w -> let E := exp (- c / 2 * turn m) in
  matrix c (c * c / 4 + D) m (2 * E * (facing m 1 * w (turn m))) (E * E) (E * (facing m 1 * o (turn m))).
Proof.
  intros H E; pose proof (damped c D o w H) as HS; set (S := damped_S c o) in *; set (V := damped_V c o w) in *.
  set (k := c * c / 4 + D) in *; set (T := turn m) in *; pose proof (undamped_energy D o w T H) as En;
    pose proof (side_square m 1) as Sq.
  exists (facing m 1 * e11 c S V T), (facing m 1 * e21 k S T), (facing m 1 * V T); split; [|split].
  - unfold e11, S, V, damped_S, damped_V; fold E; field.
  - transitivity (E * E * (facing m 1 * facing m 1) * (w T * w T + D * (o T * o T))); [rewrite Sq, En; ring|].
    unfold e11, e21, S, V, damped_S, damped_V, k; fold E; field.
  - intros q v Hq; fold T; destruct (free_moved c k S V HS q v 0 T Hq) as [-> ->]; unfold moved, moving;
      rewrite Rminus_0_r.
    replace (E * (facing m 1 * o T)) with (facing m 1 * S T) by (unfold S, damped_S; fold E; ring); split; ring.
Qed.

Lemma matrix_unique c k m a1 a2 gamma a1' a2' gamma' : matrix c k m a1 a2 gamma -> matrix c k m a1' a2' gamma' ->
  a1 = a1' /\ a2 = a2' /\ gamma = gamma'.
Proof.
  destruct (flow_exists c k) as (S & V & HS); intros H H'.
  destruct (powers c k m S V HS a1 a2 gamma H) as (A11 & A21 & A22 & E1 & E2 & P).
  destruct (powers c k m S V HS a1' a2' gamma' H') as (B11 & B21 & B22 & F1 & F2 & Q).
  destruct (P 1%nat) as (P1 & P2 & P3 & P4), (Q 1%nat) as (Q1 & Q2 & Q3 & Q4).
  rewrite P1 in Q1; rewrite P2 in Q2; rewrite P3 in Q3; rewrite P4 in Q4; cbn in Q1, Q2, Q3, Q4.
  assert (A22 = B22) by lra; assert (A11 = B11) by lra; assert (A21 = B21) by lra; assert (gamma = gamma') by lra.
  subst; auto.
Qed.

Lemma undamped_reaches T y : 0 < T -> 1 <= y -> exists D o w, undamped D o w /\ w T = y /\ 0 < o T.
Proof.
  intros HT Hy; destruct (Req_dec y 1) as [->|Hne].
  { exists 0, (fun t => t), (fun _ => 1); split; [apply undamped_straight | lra]. }
  assert (H1 : 0 < y * y - 1) by (assert (1 * 1 < y * y) by (apply Rmult_le_0_lt_compat; lra); lra).
  set (z := y + sqrt (y * y - 1)); pose proof (sqrt_lt_R0 _ H1) as Hs; assert (Hz : 1 < z) by (unfold z; lra).
  pose proof (ln_increasing 1 z ltac:(lra) Hz) as Hl; rewrite ln_1 in Hl; set (r := ln z / T).
  assert (Hr : 0 < r) by (apply Rdiv_lt_0_compat; lra).
  assert (Er : exp (r * T) = z) by (replace (r * T) with (ln z) by (unfold r; field; lra); apply exp_ln; lra).
  assert (Em : exp (- r * T) = / z) by (rewrite <- Er, <- exp_Ropp; f_equal; ring).
  eexists _, _, _; split; [apply (undamped_hyperbolic r); lra|]; cbv beta; rewrite Er, Em; split.
  - assert (Ez : / z = y - sqrt (y * y - 1)).
    { apply (Rmult_eq_reg_l z); [|lra]; rewrite Rinv_r by lra; unfold z; pose proof (sqrt_sqrt (y * y - 1) ltac:(lra));
        lra. }
    rewrite Ez; unfold z; field.
  - assert (/ z < 1) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra).
    apply Rmult_lt_0_compat; [apply Rinv_0_lt_compat|]; lra.
Qed.

Lemma damping_of r T : 0 < r -> 0 < T -> exp (- (- (2 * ln r / T)) / 2 * T) = r.
Proof. intros Hr HT; replace (- _ / 2 * T) with (ln r) by (field; lra); apply exp_ln, Hr. Qed.

Lemma reached m a1 a2 : 0 < a2 -> 2 * sqrt a2 <= facing m 1 * a1 -> exists c k gamma, matrix c k m a1 a2 gamma /\
  0 < facing m 1 * gamma.
Proof.
  intros H2 H1; pose proof (sqrt_lt_R0 a2 H2) as Hr; pose proof (sqrt_sqrt a2 ltac:(lra)) as E2;
    set (r := sqrt a2) in *.
  pose proof (turn_large m) as HT; pose proof (side_square m 1) as Sq; set (f := facing m 1) in *.
  destruct (undamped_reaches (turn m) (f * a1 / (2 * r)) ltac:(lra)) as (D & o & w & H & Ew & Po).
  { apply (Rmult_le_reg_r (2 * r)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
  pose proof (matrix_damped (- (2 * ln r / turn m)) D m o w H) as M; cbv zeta in M.
  rewrite (damping_of r (turn m) Hr ltac:(lra)), Ew, E2 in M; fold f in M.
  replace (2 * r * (f * (f * a1 / (2 * r)))) with (f * f * a1) in M by (field; lra); rewrite Sq, Rmult_1_l in M.
  eexists _, _, _; split; [exact M|]; replace (f * (r * (f * o (turn m)))) with (f * f * (r * o (turn m))) by ring.
  rewrite Sq, Rmult_1_l; apply Rmult_lt_0_compat; assumption.
Qed.

Theorem Reach : Reach_statement.
Proof.
  pose proof PI_RGT_0 as HP; constructor.
  - intros c k; destruct (undamped_exists (k - c * c / 4)) as (o & w & H & _).
    pose proof (matrix_damped c _ Plus o w H) as M; cbv zeta in M; replace (c * c / 4 + (k - c * c / 4)) with k in M
      by ring; eauto.
  - intros r s g Hr Hs; assert (Hsin : 0 < sin (2 * PI * s)).
    { apply sin_gt_0; [apply Rmult_lt_0_compat; lra|].
      apply (Rlt_le_trans _ (2 * PI * (1 / 2))); [apply Rmult_lt_compat_l|]; lra. }
    set (f := match g with Plus => s | Minus => 1 - s end); assert (Hf : 0 < f) by (destruct g; unfold f; lra).
    assert (E : cos (f * (2 * PI)) = cos (2 * PI * s) /\ sin (f * (2 * PI)) = sgn g * sin (2 * PI * s)).
    { destruct g; unfold f; cbn [sgn]; [replace (s * (2 * PI)) with (2 * PI * s) by ring; lra|].
      replace ((1 - s) * (2 * PI)) with (- (2 * PI * s) + 2 * INR 1 * PI) by (cbn; ring).
      rewrite cos_period, cos_neg, sin_period, sin_neg; lra. }
    pose proof (matrix_damped (- (2 * ln r / (2 * PI))) _ Plus _ _ (undamped_circular f ltac:(lra))) as M.
    cbv zeta in M; cbn [turn facing] in M; rewrite (damping_of r (2 * PI) Hr ltac:(lra)), (proj1 E), (proj2 E) in M.
    eexists _, _, _; split; [replace (r ^ 2) with (r * r) by ring; rewrite <- (Rmult_1_l (cos _)); exact M|].
    replace (sgn g * _) with (r * (/ f * sin (2 * PI * s))) by (destruct g; cbn [sgn]; ring).
    apply Rmult_lt_0_compat; [exact Hr|]; apply Rmult_lt_0_compat; [apply Rinv_0_lt_compat, Hf | exact Hsin].
  - intros a1 a2 H2 H1; destruct (reached Plus a1 a2 H2) as (c & k & gamma & M & P); cbn [facing] in *; [lra|].
    rewrite Rmult_1_l in P; eauto.
  - intros c k a1 a2 gamma HM Hg; destruct (undamped_exists (k - c * c / 4)) as (o & w & H & Pos).
    pose proof (matrix_damped c _ Plus o w H) as M; cbv zeta in M; replace (c * c / 4 + (k - c * c / 4)) with k in M
      by ring.
    destruct (matrix_unique _ _ _ _ _ _ _ _ _ HM M) as (-> & -> & Eg); pose proof (undamped_energy _ o w (2 * PI) H)
      as En.
    set (E := exp (- c / 2 * turn Plus)) in *; assert (P : 0 < E) by apply exp_pos; cbn [turn facing] in *.
    rewrite (sqrt_square E) by lra; assert (P2 : 0 < E * E) by (apply Rmult_lt_0_compat; lra).
    split; [exact P2|]; destruct (Rle_lt_dec (k - c * c / 4) 0) as [L|L].
    + destruct (Pos L (2 * PI) ltac:(lra)) as [Po Pw]; pose proof (Rmult_le_compat_l E _ _ ltac:(lra) Pw).
      split; [lra|]; intros _; rewrite Eg, Rmult_1_l; apply Rmult_lt_0_compat; assumption.
    + assert (No : o (2 * PI) <> 0) by (intros Z; apply Hg; rewrite Eg, Z; ring).
      assert (0 < (k - c * c / 4) * (o (2 * PI) * o (2 * PI))) by (apply Rmult_lt_0_compat;
        [exact L | apply Rsqr_pos_lt, No]).
      assert (W : -1 < w (2 * PI) < 1) by (split; apply Rnot_le_lt; intros Z; nra).
      assert (E * -1 < E * w (2 * PI) < E * 1) by (split; apply Rmult_lt_compat_l; lra); split; [lra | intros; lra].
  - intros a1 a2 H2 H1; destruct (reached Minus a1 a2 H2) as (c & k & gamma & M & P); cbn in *; [lra|].
    exists c, k, gamma; split; [exact M | lra].
Qed.
