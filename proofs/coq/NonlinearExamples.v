(** * Proof that the forced oscillators of [StatementNonlinearExamples] graze, and that region 3 has all of them *)
From Coq Require Import Reals Lra.
From Grazing Require Import Defs Derivatives StatementOscillator StatementNonlinear StatementNonlinearExamples
  OscillatorUses.
Open Scope R_scope.

(** ** Sums and products of continuous functions of four variables *)
Section Continuous.
Variable D : R -> R -> R -> R -> Prop.
Notation C := (continuous D).
Lemma C_const x : C (fun _ _ _ _ => x).
Proof. intros t y v m _ e He; exists 1; split; [lra|]; intros; rewrite Rminus_eq_0, Rabs_R0; lra. Qed.
Lemma C_t f : (forall t, continuity_pt f t) -> C (fun t _ _ _ => f t).
Proof. intros H t y v m _ e He; destruct (continuous_near f t e (H t) He) as (d & Hd & N); exists d; split; [exact Hd|];
  intros; apply N; assumption. Qed.
Lemma C_v f : (forall t, continuity_pt f t) -> C (fun _ _ v _ => f v).
Proof. intros H t y v m _ e He; destruct (continuous_near f v e (H v) He) as (d & Hd & N); exists d; split; [exact Hd|];
  intros; apply N; assumption. Qed.
Lemma C_f f : (forall t, continuity_pt f t) -> C (fun _ y _ _ => f y).
Proof.
  intros H t y v m _ e He; destruct (continuous_near f y e (H y) He) as (d & Hd & N); exists d; split; [exact Hd|];
    intros;
    apply N; assumption.
Qed.
Lemma C_y : C (fun _ y _ _ => y). Proof. intros t y v m _ e He; exists e; auto. Qed.
Lemma C_plus f g : C f -> C g -> C (fun t y v m => f t y v m + g t y v m).
Proof.
  intros F G t y v m HD e He;
    destruct (F t y v m HD (e / 2) ltac:(lra)) as (d1 & D1 & N1), (G t y v m HD (e / 2) ltac:(lra)) as (d2 & D2 & N2).
  destruct (two_least d1 d2 D1 D2) as (d & Hd & L1 & L2); exists d; split; [exact Hd|]; intros t' y' v' m' A1 A2 A3 A4.
  specialize (N1 t' y' v' m' ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra));
    specialize (N2 t' y' v' m' ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). apply le_abs in N1, N2; apply Rabs_le; lra.
Qed.
Lemma C_times f g : C f -> C g -> C (fun t y v m => f t y v m * g t y v m).
Proof.
  intros F G t y v m HD e He; set (a := f t y v m); set (b := g t y v m); pose proof (Rabs_pos a);
    pose proof (Rabs_pos b).
  destruct (two_least 1 (e / (Rabs a + Rabs b + 1)) ltac:(lra) ltac:(apply Rdiv_lt_0_compat; lra))
    as (q & Hq & Q1 & Q2). destruct (F t y v m HD q Hq) as (d1 & D1 & N1), (G t y v m HD q Hq) as (d2 & D2 & N2).
  destruct (two_least d1 d2 D1 D2) as (d & Hd & L1 & L2); exists d; split; [exact Hd|]; intros t' y' v' m' A1 A2 A3 A4.
  specialize (N1 t' y' v' m' ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra));
    specialize (N2 t' y' v' m' ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). fold a in N1 |- *; fold b in N2 |- *;
    set (a' := f t' y' v' m') in *; set (b' := g t' y' v' m') in *.
  replace (a' * b' - a * b) with (a * (b' - b) + (b * (a' - a) + (a' - a) * (b' - b))) by ring.
  pose proof (product a (b' - b) _ _ (Rle_refl _) N2) as P1; pose proof (product b (a' - a) _ _ (Rle_refl _) N1) as P2.
  pose proof (product (a' - a) (b' - b) _ _ N1 N2) as P3; assert (q * q <= 1 * q) by (apply Rmult_le_compat_r; lra).
  assert ((Rabs a + Rabs b + 1) * q <= e).
  { apply Rle_trans with ((Rabs a + Rabs b + 1) * (e / (Rabs a + Rabs b + 1)));
      [apply Rmult_le_compat_l; lra | right; field; lra]. }
  apply le_abs in P1, P2, P3; apply Rabs_le; lra.
Qed.
End Continuous.
Lemma C_minus D f g : continuous D f -> continuous D g -> continuous D (fun t y v m => f t y v m - g t y v m).
Proof.
  intros F G; pose proof (C_plus D _ _ F (C_times D _ _ (C_const D (-1)) G)) as H; intros t y v m HD e He;
    destruct (H t y v m HD e He) as (d & Hd & N). exists d; split; [exact Hd|]; intros t' y' v' m' A1 A2 A3 A4;
    specialize (N t' y' v' m' A1 A2 A3 A4);
    match goal with |- Rabs ?u <= _ => match type of N with Rabs ?w <= _ => replace u with w by ring end end; exact N.
Qed.

Section Forced.
Variables (c k b h e s tau : R).
Lemma D_Y t : derivable_pt_lim Y t (- sin t).
Proof. unfold Y; eapply D_value; [apply (D_plus (fun _ => 1) cos); [apply D_const | apply derivable_pt_lim_cos] | ring].
Qed.
Lemma forced_C1 D : C1 D (Nonlinear.a (forced c k b h e s tau)) (Nonlinear.a_t (forced c k b h e s tau)) (Nonlinear.a_y
  (forced c k b h e s tau)) (Nonlinear.a_v (forced c k b h e s tau)) (Nonlinear.a_mu (forced c k b h e s tau)).
Proof.
  assert (Cs : forall t, continuity_pt sin t) by (intros t; apply (D_continuous _ _ _ (derivable_pt_lim_sin t))).
  assert (Cc : forall t, continuity_pt cos t) by (intros t; apply (D_continuous _ _ _ (derivable_pt_lim_cos t))).
  assert (CY : forall t, continuity_pt Y t) by (intros t; apply (D_continuous _ _ _ (D_Y t))).
  assert (CcY : forall t, continuity_pt (fun t => cos (Y t)) t) by (intros t; eapply D_continuous; apply D_cos, D_Y).
  constructor; cbn;
    [intros t y v m _ .. |].
  - derive_by ltac:(apply D_Y); ring.
  - derive_by fail; ring.
  - derive_by fail; ring.
  - derive_by fail; ring.
  - repeat split;
      repeat first [apply C_const | apply (C_t _ sin Cs) | apply (C_t _ cos Cc) | apply (C_t _ Y CY) |
        apply (C_t _ (fun t => cos (Y t)) CcY) | apply (C_f _ cos Cc) | apply C_y |
        apply C_minus | apply C_plus | apply C_times].
Qed.
Theorem forced_grazes : 0 <= tau -> grazing_orbit (forced c k b h e s tau).
Proof.
  intros Ht; pose proof PI_RGT_0 as HP;
    assert (Pc : forall t, cos (t + 2 * PI) = cos t) by (intros t; rewrite <- (cos_period t 1); f_equal; cbn; ring).
  assert (Ps : forall t, sin (t + 2 * PI) = sin t) by (intros t; rewrite <- (sin_period t 1); f_equal; cbn; ring).
  constructor.
  - cbn; split; [lra|]; intros t; unfold Y; rewrite Pc, Ps; repeat split.
  - intros t; split; [apply D_Y|]; cbn; eapply D_value; [apply (derivable_pt_lim_opp sin), derivable_pt_lim_sin|]; ring.
  - cbn; split; [lra|]; unfold Y; rewrite cos_PI; ring.
  - cbn; intros t Ht2 Ne; unfold Y; assert (-1 < cos t); [|lra]; destruct (Rlt_le_dec t PI) as [Q|Q].
    + rewrite <- cos_PI; apply cos_decreasing_1; lra.
    + rewrite <- cos_PI; apply cos_increasing_1; lra.
  - cbn; replace (Y PI) with 0 by (unfold Y; rewrite cos_PI; ring). rewrite cos_PI, sin_PI, sin_0; lra.
  - exists 1; split; [lra | apply forced_C1].
  - cbn; split; [exact Ht | split; [intros; ring|]]; intros mu t v Hv; pose proof (exp_pos (s * v)).
    assert (0 <= tau * (- v * exp (s * v))) by (apply Rmult_le_pos; [exact Ht | apply Rmult_le_pos; lra]); lra.
  - exists 1, (fun _ _ _ _ => 0), (fun _ _ _ _ => 0), (fun _ _ v _ => - tau * ((1 + s * v) * exp (s * v))),
      (fun _ _ _ _ => 0); cbn. split; [lra | split; [rewrite !Rmult_0_r, exp_0; ring|]].
    assert (Ce : forall v, continuity_pt (fun v => exp (s * v)) v) by (intros v; eapply D_continuous;
      apply D_exp, D_scale, D_id).
    assert (Cv : forall v, continuity_pt (fun v => v) v) by (intros v; apply (D_continuous _ _ _ (D_id v))).
    constructor; [intros t y v m _ .. |].
    + apply D_const.
    + apply D_const.
    + derive_by fail; ring.
    + apply D_const.
    + repeat split;
        repeat first [apply C_const | apply (C_v _ _ Ce) | apply (C_v _ _ Cv) | apply C_plus | apply C_times].
Qed.
End Forced.

Lemma forced_generic c k e s tau a1 a2 gamma : matrix c k Plus a1 a2 gamma -> gamma <> 0 -> k <> 0 ->
  generic (forced c k 0 0 e s tau) a1 a2 gamma (1 / k).
Proof.
  intros (A11 & A21 & A22 & E1 & E2 & H) Hg Hk; constructor.
  - exists A11, A21, A22; split; [exact E1 | split; [rewrite (Rmult_comm A21); exact E2|]]; intros z w Hz.
    assert (Sh : forall f l t, derivable_pt_lim f (PI + t) l -> derivable_pt_lim (fun t => f (PI + t)) t l).
    { intros f l t D; eapply D_value;
        [apply (D_of (fun t => PI + t) f); [apply D_plus; [apply D_const | apply D_id] | exact D] | ring]. }
    destruct (H (fun t => z (PI + t)) (fun t => w (PI + t))) as [F1 F2].
    + intros t; destruct (Hz (PI + t)) as [D1 D2]; unfold along in D2; cbn in D1, D2; split; [apply Sh, D1|].
      eapply D_value; [apply Sh, D2 | ring].
    + cbn in *; rewrite !Rplus_0_r in F1, F2; lra.
  - exact Hg.
  - exists (fun _ => 1 / k), (fun _ => 0); split; [|split; [intros; auto | reflexivity]]; intros t; split;
      [apply D_const|]. unfold along; cbn; eapply D_value; [apply D_const | field; exact Hk].
  - apply Rmult_integral_contrapositive; split; [lra | apply Rinv_neq_0_compat, Hk].
Qed.
Theorem Forced : Forced_statement.
Proof.
  intros e s tau Ht; split;
    [intros c k b h; apply forced_grazes, Ht | split; [intros; apply forced_generic; assumption|]]. intros r x g Hr Hx;
    destruct (reach_3 Reach r x g Hr Hx) as (c & k & gamma & Hm & Hg); exists c, k, gamma. split; [|exact Hg];
    apply forced_generic; [exact Hm | intros ->; lra | intros ->].
  (* with k = 0 constants are free motions, and 1 is an eigenvalue *)
  destruct Hm as (A11 & A21 & A22 & E1 & E2 & H); destruct (H (fun _ => 1) (fun _ => 0)) as [F1 F2].
  { intros t; split; [apply D_const | eapply D_value; [apply D_const | ring]]. }
  cbn in F1, F2; assert (A11 = 1) by lra; assert (A21 = 0) by lra; subst A11 A21. pose proof PI_RGT_0 as HP;
    assert (Sp : 0 < sin (2 * PI * x)) by (apply sin_gt_0; nra). pose proof (sin2_cos2 (2 * PI * x)) as Q;
    unfold Rsqr in Q; set (p := cos (2 * PI * x)) in *; set (q := sin (2 * PI * x)) in *.
  assert (E3 : A22 = r * r) by lra; assert (E4 : 2 * r * p = 1 + r * r) by lra;
    assert (P1 : 0 < r * r * (q * q)) by (apply Rmult_lt_0_compat; apply Rmult_lt_0_compat; assumption).
  assert (E5 : (2 * r * p) * (2 * r * p) = 4 * (r * r) - 4 * (r * r * (q * q))) by (replace (q * q) with (1 - p * p)
    by lra; ring). rewrite E4 in E5; pose proof (Rle_0_sqr (1 - r * r)) as U; unfold Rsqr in U; lra.
Qed.
