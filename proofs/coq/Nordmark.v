(** * Proof that the paper's oscillator, and stops with any harmonics, are oscillators near grazing *)
From Coq Require Import Reals ZArith List Lra Lia.
From Grazing Require Import Defs StatementOscillator StatementNordmark Derivatives Flow OscillatorTurns OscillatorUses.
Import ListNotations.
Open Scope R_scope.

Lemma cos_below t : 0 < t < 2 * PI -> cos t < 1.
Proof.
  intros Ht; pose proof (COS_bound t) as B; destruct (Req_dec (cos t) 1) as [E|E]; [|lra].
  exfalso; pose proof PI_RGT_0; destruct (Rle_lt_dec t PI) as [L|L].
  - pose proof (cos_decreasing_1 0 t ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as D; rewrite cos_0 in D;
      lra.
  - pose proof (cos_increasing_1 t (2 * PI) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as D.
    rewrite cos_2PI in D; lra.
Qed.

Lemma periods_back z t : cos (t - 2 * PI * IZR z) = cos t /\ sin (t - 2 * PI * IZR z) = sin t.
Proof. rewrite <- (cos_periods (- z) t), <- (sin_periods (- z) t), opp_IZR; split; f_equal; ring. Qed.

Lemma Nordmark_touching d w tau : touching (Nordmark d w tau).
Proof.
  constructor; cbn.
  - intros mu t; destruct (periods_back (-1) t) as [E _]; replace (t + 2 * PI) with (t - 2 * PI * -1) by ring;
      rewrite E; reflexivity.
  - intros mu t; derive_by fail; ring.
  - intros mu t; derive_by fail; ring.
  - intros mu; rewrite cos_0; ring.
  - intros t Ht; pose proof (cos_below t Ht); lra.
  - rewrite cos_0, Rminus_0_r, Rmult_1_r; split; [|lra].
    apply (D_continuous _ (0 * cos 0 + 1 * (- sin 0 * 1))); derive_by fail; reflexivity.
  - exists 2; intros mu t _; pose proof (COS_bound t); pose proof (SIN_bound t); pose proof (Rabs_pos mu).
    assert (X : forall x, -2 <= x <= 2 -> Rabs ((1 - mu) * x - (1 - 0) * x) <= 2 * Rabs mu).
    { intros x Hx; replace (_ - _) with (- x * mu) by ring; rewrite Rabs_mult; apply Rmult_le_compat_r; [lra|].
      apply Rabs_le; lra. }
    repeat split; apply X; lra.
Qed.

(** (68): D is 1/w^2 - (d/w)^2. *)
Lemma Nordmark_grazing d w tau D o x : 0 < w -> 0 <= tau -> undamped D o x -> D = 1 / w ^ 2 - d * d / w ^ 2 ->
  o (2 * PI) <> 0 -> let E := exp (- 2 * PI * d / w) in
  grazing (Nordmark d w tau) Plus (2 * E * x (2 * PI)) (exp (- 4 * PI * d / w)) (E * o (2 * PI)).
Proof.
  intros Hw Ht HU ED Ho E; pose proof (matrix_damped (2 * d / w) D Plus o x HU) as M; cbv zeta in M;
    cbn [turn facing] in M.
  replace (2 * d / w * (2 * d / w) / 4 + D) with (1 / w ^ 2) in M by (rewrite ED; field; lra).
  replace (- (2 * d / w) / 2 * (2 * PI)) with (- 2 * PI * d / w) in M by (field; lra); fold E in M;
    rewrite !Rmult_1_l in M.
  constructor; [apply Nordmark_touching | exact Ht | | apply Rmult_integral_contrapositive_currified;
    [apply Rgt_not_eq, exp_pos | exact Ho]].
  replace (exp (- 4 * PI * d / w)) with (E * E) by (unfold E; rewrite <- exp_plus; f_equal; field; lra); exact M.
Qed.

Theorem Nordmark_oscillator : Nordmark_statement.
Proof.
  intros d w tau Hw Ht has; pose proof PI_RGT_0 as HP; assert (Hw2 : 0 < w ^ 2) by (apply pow_lt, Hw).
  pose proof (exp_pos (- 2 * PI * d / w)) as PE; split; [|split; [|split]].
  - intros sigma Hd Hd0 Es Hs; assert (P : 0 < 1 - d ^ 2) by nra.
    pose proof (sqrt_lt_R0 _ P) as Hq; pose proof (sqrt_sqrt (1 - d ^ 2) ltac:(lra)) as Eq; set (r := sqrt _) in *.
    assert (Ps : 0 < sigma) by (rewrite Es; apply Rdiv_lt_0_compat; lra); pose proof (Rinv_0_lt_compat _ Ps).
    pose proof (Nordmark_grazing d w tau _ _ _ Hw Ht (undamped_circular sigma ltac:(lra))) as M; cbv zeta beta in M.
    replace (sigma * (2 * PI)) with (2 * PI * sigma) in M by ring; set (si := sin (2 * PI * sigma)) in *.
    eexists; split; [apply M; [rewrite Es; replace (r / w * (r / w)) with (r * r / w ^ 2) by (field; lra); rewrite Eq;
      field; lra|]|].
    + apply Rmult_integral_contrapositive_currified; lra.
    + replace (_ * (/ sigma * si) * si) with (exp (- 2 * PI * d / w) * / sigma * (si * si)) by ring.
      apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra | nra].
  - intros Hd; assert (P : 0 < d ^ 2 - 1) by nra.
    pose proof (sqrt_lt_R0 _ P) as Hq; pose proof (sqrt_sqrt (d ^ 2 - 1) ltac:(lra)) as Eq; set (r := sqrt _) in *.
    assert (Po : 0 < r / w) by (apply Rdiv_lt_0_compat; lra).
    pose proof (Nordmark_grazing d w tau _ _ _ Hw Ht (undamped_hyperbolic (r / w) ltac:(lra))) as M; cbv zeta beta in M.
    assert (X : 0 < r / w * (2 * PI)) by (apply Rmult_lt_0_compat; lra).
    pose proof (exp_increasing (- (r / w) * (2 * PI)) (r / w * (2 * PI)) ltac:(lra)).
    assert (Z : 0 < / (2 * (r / w)) * (exp (r / w * (2 * PI)) - exp (- (r / w) * (2 * PI))))
      by (apply Rmult_lt_0_compat; [apply Rinv_0_lt_compat|]; lra).
    unfold cosh; replace (2 * PI * r / w) with (r / w * (2 * PI)) by (field; lra).
    replace (- (r / w * (2 * PI))) with (- (r / w) * (2 * PI)) by ring.
    rewrite (Rmult_comm (/ 2)) in M; eexists; split; [apply M; [|lra] | apply Rmult_lt_0_compat; assumption].
    replace (r / w * (r / w)) with (r * r / w ^ 2) by (field; lra); rewrite Eq; field; lra.
  - intros ->; pose proof (Nordmark_grazing 1 w tau _ _ _ Hw Ht undamped_straight) as M; cbv zeta beta in M.
    rewrite (Rmult_1_r (2 * _)) in M; eexists; split; [apply M; [field|]; lra | apply Rmult_lt_0_compat; lra].
  - intros mu r N t q v;     assert (E : forall z x f, gap (Nordmark d w tau) Plus (- mu) z f x = f x
      - ((1 + mu) * cos x - 1)) by (intros; unfold gap; cbn; rewrite (proj1 (periods_back _ _)); ring).
    assert (F : forall z x f, speed (Nordmark d w tau) Plus (- mu) z f x = f x + (1 + mu) * sin x) by (intros;
      unfold speed; cbn; rewrite (proj2 (periods_back _ _)); ring).
    split; intros H i j Hj.
    + destruct (H i j Hj) as [H1 H2 H3 H4 H5 H6 H7 H8]; rewrite E in H4, H5; rewrite F in H7; rewrite !F in H8;
        cbn in H8.
      split; [exact H1|]; split; [exact H2|]; split; [exact H3|]; split; [lra|]; split; [lra|].
      split; [intros x Hx; specialize (H6 0%Z x Hx); rewrite E in H6; lra | split; lra].
    + destruct (H i j Hj) as (H1 & H2 & H3 & H4 & H5 & H6 & H7 & H8); constructor; rewrite ?E, ?F; trivial; try lra.
      * intros z x Hx; rewrite E; specialize (H6 x Hx); lra.
      * cbn; lra.
Qed.

Fixpoint harmonics1 (j : nat) (l : list (R * R)) (t : R) : R := match l with [] => 0
  | (a, b) :: l => INR j * (a * sin (INR j * t) + b * cos (INR j * t)) + harmonics1 (S j) l t end.
Fixpoint harmonics2 (j : nat) (l : list (R * R)) (t : R) : R := match l with [] => 0
  | (a, b) :: l => INR j ^ 2 * (a * cos (INR j * t) - b * sin (INR j * t)) + harmonics2 (S j) l t end.
Fixpoint harmonics3 (j : nat) (l : list (R * R)) (t : R) : R := match l with [] => 0
  | (a, b) :: l => - INR j ^ 3 * (a * sin (INR j * t) + b * cos (INR j * t)) + harmonics3 (S j) l t end.

Lemma D_harmonics l : forall j t, derivable_pt_lim (harmonics j l) t (harmonics1 j l t) /\
  derivable_pt_lim (harmonics1 j l) t (harmonics2 j l t) /\ derivable_pt_lim (harmonics2 j l) t (harmonics3 j l t).
Proof.
  induction l as [|[a b] l IH]; intros j t; [split; [|split]; exact (D_const 0 t)|]; destruct (IH (S j) t)
    as (H1 & H2 & H3).
  split; [|split]; cbn [harmonics harmonics1 harmonics2 harmonics3];
    derive_by ltac:(first [exact H1 | exact H2 | exact H3]); ring.
Qed.

Lemma harmonics_period l : forall j t, harmonics j l (t + 2 * PI) = harmonics j l t.
Proof.
  induction l as [|[a b] l IH]; intros j t; [reflexivity|]; cbn [harmonics]; rewrite IH.
  destruct (periods_back (- Z.of_nat j) (INR j * t)) as [C D]; rewrite opp_IZR, <- INR_IZR_INZ in C, D.
  replace (INR j * (t + 2 * PI)) with (INR j * t - 2 * PI * - INR j) by ring; rewrite C, D; reflexivity.
Qed.

Lemma harmonics_0 l : forall j, harmonics j l 0 = 0 /\ harmonics2 j l 0 = weighted j l.
Proof.
  induction l as [|[a b] l IH]; intros j; [split; reflexivity|]; destruct (IH (S j)) as [E F].
  cbn [harmonics harmonics2 weighted]; rewrite E, F, Rmult_0_r, cos_0, sin_0; split; ring.
Qed.

Theorem Harmonics : Harmonics_statement.
Proof.
  intros c k tau l Hlow Hw; exists {| Oscillator.c := c; Oscillator.k := k; Oscillator.tau := tau; Oscillator.G :=
    fun _ => harmonics 1 l; Oscillator.G1 := fun _ => harmonics1 1 l; Oscillator.G2 := fun _ => harmonics2 1 l |}.
  split; [|auto]; constructor; cbn; intros.
  - apply harmonics_period.
  - apply D_harmonics.
  - apply D_harmonics.
  - apply harmonics_0.
  - apply Hlow; assumption.
  - split; [apply (D_continuous _ (harmonics3 1 l 0)), D_harmonics | rewrite (proj2 (harmonics_0 l 1)); exact Hw].
  - exists 0; intros; rewrite !Rminus_eq_0, Rabs_R0; lra.
Qed.
