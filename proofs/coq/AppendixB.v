(** * On r = 1 the functions b_{n,k}(s) have the values, zeros and poles of appendix B

    With A = k pi s and C = (n-k) pi s, (B1) is -2 sin A sin C / cos (A + C)
    = 1 - cos (A - C) / cos (A + C); the rest is addition formulas and sin h / h. *)

From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs Statement StatementB Polar Algebra.
Open Scope R_scope.

Lemma split_n n k s : (k <= n)%nat -> INR n * PI * s = INR k * PI * s + INR (n - k) * PI * s.
Proof. intros Hk; rewrite minus_INR by assumption; ring. Qed.

Lemma B_difference n k s : (k <= n)%nat -> cos (INR n * PI * s) <> 0 ->
  B n k s = 1 - cos ((INR n - 2 * INR k) * PI * s) / cos (INR n * PI * s).
Proof.
  intros Hk; unfold B; rewrite (split_n n k s Hk).
  replace ((INR n - 2 * INR k) * PI * s) with (INR (n - k) * PI * s - INR k * PI * s)
    by (rewrite minus_INR by assumption; ring).
  rewrite cos_minus; intros Hc; rewrite cos_plus in *; field; exact Hc.
Qed.

(** ** (B1), (B2) *)
Theorem B_formulas : B_formulas_statement.
Proof.
  intros s n k Hs Hk Hu; pose proof PI_RGT_0. assert (Hth : sin (2 * PI * s) > 0) by (apply sin_gt_0; nra).
  unfold b_at, c_at, trace in *. pose proof (b_polar 1 (2 * PI * s) n k Hk Hu) as Eb.
  pose proof (c_polar 1 (2 * PI * s) Rlt_0_1 Hth n Hu) as Ec. apply u_zero in Hu; [|lra | assumption].
  set (beta := b _ _ n k) in *; set (gamma := c _ _ n) in *; clearbody beta gamma. rewrite !pow1, !Rmult_1_l in *.
  set (P := INR n * PI * s); set (M := (INR n - 2 * INR k) * PI * s).
  replace (INR n * (2 * PI * s)) with (2 * P) in * by (unfold P; ring).
  replace (INR k * (2 * PI * s)) with (P - M) in * by (unfold P, M; ring).
  replace (INR (n - k) * (2 * PI * s)) with (P + M) in * by (unfold P, M; rewrite minus_INR by assumption; ring).
  rewrite sin_2a in *; rewrite cos_2a_sin in Ec; rewrite sin_minus, sin_plus in Eb.
  assert (Hc : cos P <> 0) by (intros E; rewrite E in Hu; lra).
  assert (Hn : sin P <> 0) by (intros E; rewrite E in Hu; lra). split.
  - rewrite B_difference by assumption; fold P M.
    apply Rmult_eq_reg_r with (2 * sin P * cos P); [rewrite Eb|assumption]. field; assumption.
  - apply Rmult_eq_reg_r with (2 * sin P * cos P); [rewrite Ec | assumption]. fold P; unfold tan; field; assumption.
Qed.

(** ** Zeros *)
Lemma sin_zero x : sin x = 0 <-> exists m : Z, x = IZR m * PI.
Proof. split; [apply sin_eq_0_0 | intros [m ->]; apply sin_eq_0_1; exists m; reflexivity]. Qed.

Lemma sin_zero_turns a s : sin (a * PI * s) = 0 <-> exists m : Z, a * s = IZR m.
Proof.
  pose proof PI_RGT_0; rewrite sin_zero; split; intros [m E]; exists m; [|nra]. apply Rmult_eq_reg_r with PI; lra.
Qed.

Theorem B_zeros : B_zeros_statement.
Proof.
  intros n k s Hc; unfold B. transitivity (sin (INR k * PI * s) = 0 \/ sin (INR (n - k) * PI * s) = 0).
  - split; intros E.
    + apply Rmult_integral; apply Rmult_eq_reg_r with (- 2 / cos (INR n * PI * s));
        [lra | unfold Rdiv; apply Rmult_integral_contrapositive_currified; [lra | apply Rinv_neq_0_compat; assumption]].
    + destruct E as [-> | ->]; unfold Rdiv; ring.
  - rewrite !sin_zero_turns; split.
    + intros [[m E]|[m E]]; exists m; tauto.
    + intros (m & [E|E]); [left | right]; exists m; assumption.
Qed.

(** ** Limits *)
Lemma tends_const l : tends (fun _ => l) l. Proof. apply (limit_free (fun _ => l) _ 0 0). Qed.

Lemma tends_near f g l z : 0 < z -> (forall h, h <> 0 -> Rabs h < z -> f h = g h) -> tends f l -> tends g l.
Proof.
  intros Hz E H eps He; destruct (H eps He) as (d & Hd & Hl).
  exists (Rmin d z); split; [apply Rmin_glb_lt; assumption|]. intros h [Hh Hhd]; cbn in Hhd; unfold R_dist in Hhd.
  pose proof (Rmin_l d z); pose proof (Rmin_r d z). rewrite <- E; [|assumption | rewrite Rminus_0_r in Hhd; lra].
  apply Hl; split; [assumption | cbn; unfold R_dist; lra].
Qed.

Lemma tends_ext f g l : (forall h, h <> 0 -> f h = g h) -> tends f l -> tends g l.
Proof. intros E; apply tends_near with 1; [lra | intros; apply E; assumption]. Qed.

Lemma tends_continuous f l : continuity_pt f 0 -> f 0 = l -> tends f l.
Proof.
  intros H <- eps He; destruct (H eps He) as (d & Hd & Hl); exists d; split; [assumption|].
  intros h [Hh Hhd]; apply Hl; split; [|assumption]. split; [exact I | intros E; apply Hh; symmetry; exact E].
Qed.

Lemma tends_sin a b : tends (fun h => sin (b + a * h)) (sin b).
Proof. apply tends_continuous; [|f_equal; ring]. reg. Qed.
Lemma tends_cos a b : tends (fun h => cos (b + a * h)) (cos b).
Proof. apply tends_continuous; [reg | f_equal; ring]. Qed.

Lemma tends_sin_over a : tends (fun h => sin (a * h) / h) a.
Proof.
  assert (D : derivable_pt_lim (fun h => sin (a * h)) 0 (cos (a * 0) * (a * 1))).
  { apply (derivable_pt_lim_comp (fun h => a * h) sin).
    - apply (derivable_pt_lim_scal id), derivable_pt_lim_id.
    - apply derivable_pt_lim_sin. }
  rewrite Rmult_0_r, cos_0 in D; intros eps He; destruct (D eps He) as (d & Hd).
  exists d; split; [apply cond_pos|]; intros h [Hh Hhd].
  unfold dist in *; cbn in *; unfold R_dist in *; rewrite Rminus_0_r in Hhd.
  specialize (Hd h Hh Hhd); rewrite Rmult_0_r, sin_0, Rplus_0_l in Hd.
  replace (sin (a * h) / h - a) with ((sin (a * h) - 0) / h - 1 * (a * 1)) by (unfold Rdiv; ring). exact Hd.
Qed.

Lemma tends_mul f g l l' : tends f l -> tends g l' -> tends (fun h => f h * g h) (l * l').
Proof. apply limit_mul. Qed.
Lemma tends_div f g l l' : tends f l -> tends g l' -> l' <> 0 -> tends (fun h => f h / g h) (l / l').
Proof. intros; apply limit_mul; [assumption|]; apply limit_inv; assumption. Qed.

Lemma tends_sin_ratio a b : b <> 0 -> tends (fun h => sin (a * h) / sin (b * h)) (a / b).
Proof.
  intros Hb; apply tends_ext with (fun h => sin (a * h) / h / (sin (b * h) / h)).
  - intros h Hh; unfold Rdiv; rewrite Rinv_mult, Rinv_inv. generalize (/ sin (b * h)); intros y; field; assumption.
  - apply tends_div; [apply tends_sin_over.. | assumption].
Qed.

(** ** Zeros of one kind are simple, of both kinds double *)
Lemma sin_shift a s h m : a * s = IZR m -> sin (a * PI * (s + h)) = cos (IZR m * PI) * sin (a * PI * h).
Proof.
  intros E; replace (a * PI * (s + h)) with (IZR m * PI + a * PI * h) by (rewrite <- E; ring).
  rewrite sin_plus, (sin_eq_0_1 (IZR m * PI)) by (exists m; reflexivity); ring.
Qed.

Lemma cos_shift a s h m : a * s = IZR m -> cos (a * PI * (s + h)) = cos (IZR m * PI) * cos (a * PI * h).
Proof.
  intros E; replace (a * PI * (s + h)) with (IZR m * PI + a * PI * h) by (rewrite <- E; ring).
  rewrite cos_plus, (sin_eq_0_1 (IZR m * PI)) by (exists m; reflexivity); ring.
Qed.

Lemma cos_turns_square m : cos (IZR m * PI) * cos (IZR m * PI) = 1.
Proof.
  pose proof (sin2_cos2 (IZR m * PI)) as H; unfold Rsqr in H.
  rewrite (sin_eq_0_1 (IZR m * PI)) in H by (exists m; reflexivity); lra.
Qed.

Lemma cos_turns_nonzero m : cos (IZR m * PI) <> 0.
Proof. intros E; pose proof (cos_turns_square m); rewrite E in *; lra. Qed.

(** One factor vanishes at s, the other and the cosine do not. *)
Lemma simple_zero a c n s m : a <> 0 -> a * s = IZR m -> sin (c * PI * s) <> 0 -> cos (n * PI * s) <> 0 -> exists d,
  d <> 0 /\ tends (fun h => - 2 * sin (a * PI * (s + h)) * sin (c * PI * (s + h)) / cos (n * PI * (s + h)) / h) d.
Proof.
  intros Ha Em Hc Hn; pose proof PI_RGT_0; pose proof (cos_turns_nonzero m).
  exists (- 2 * cos (IZR m * PI) * (a * PI) * (sin (c * PI * s) / cos (n * PI * s))). split.
  - assert (a * PI <> 0) by (apply Rmult_integral_contrapositive_currified; lra). pose proof (Rinv_neq_0_compat _ Hn).
    unfold Rdiv; apply Rmult_integral_contrapositive_currified; apply Rmult_integral_contrapositive_currified;
      try assumption.
    apply Rmult_integral_contrapositive_currified; lra || assumption.
  - apply tends_ext with (fun h => - 2 * cos (IZR m * PI) * (sin (a * PI * h) / h) * (sin (c * PI * s + c * PI * h)
      / cos (n * PI * s + n * PI * h))).
    + intros h Hh; rewrite (sin_shift a s h m Em), !Rmult_plus_distr_l; unfold Rdiv; ring.
    + apply tends_mul; [apply tends_mul; [apply tends_const | apply tends_sin_over] |].
      apply tends_div; [apply tends_sin | apply tends_cos | assumption].
Qed.

Theorem B_simple_zero : B_simple_zero_statement.
Proof.
  intros n k s m Hk Hc; assert (0 < INR k) by (apply lt_0_INR; lia).
  assert (0 < INR (n - k)) by (apply lt_0_INR; lia); split; intros Em Hs; unfold B.
  - apply simple_zero with m; lra || assumption.
  - destruct (simple_zero (INR (n - k)) (INR k) (INR n) s m) as (d & Hd & Ht); try lra; try assumption.
    exists d; split; [assumption|]; apply tends_ext with (2 := Ht). intros h _; unfold Rdiv; ring.
Qed.

Lemma cos_turns_plus m l : cos (IZR (m + l) * PI) = cos (IZR m * PI) * cos (IZR l * PI).
Proof. rewrite plus_IZR, Rmult_plus_distr_r, cos_plus, (sin_eq_0_1 (IZR m * PI)); [ring | exists m; reflexivity]. Qed.

Theorem B_double_zero : B_double_zero_statement.
Proof.
  intros n k s m l Hk Em El.
  assert (En : INR n * s = IZR (m + l)) by (rewrite plus_IZR, <- Em, <- El, minus_INR by lia; ring).
  assert (Eq : forall h, B n k (s + h) = - 2 * sin (INR k * PI * h) * sin (INR (n - k) * PI * h) / cos
    (INR n * PI * h)).
  { intros h; unfold B; rewrite (sin_shift _ s h m Em), (sin_shift _ s h l El).
    rewrite (cos_shift _ s h _ En), cos_turns_plus; unfold Rdiv; rewrite !Rinv_mult.
    pose proof (cos_turns_nonzero m); pose proof (cos_turns_nonzero l).
    generalize (/ cos (INR n * PI * h)); intros y; field; split; assumption. }
  refine (conj En (conj Eq _)).
  apply tends_ext with (fun h => - 2 * (sin (INR k * PI * h) / h) * (sin (INR (n - k) * PI * h) / h) / cos
    (0 + INR n * PI * h)).
  - intros h Hh; rewrite Eq, Rplus_0_l; unfold Rdiv. generalize (/ cos (INR n * PI * h)); intros y; field; assumption.
  - replace (- 2 * PI ^ 2 * INR k * INR (n - k)) with (- 2 * (INR k * PI) * (INR (n - k) * PI) / cos 0)
      by (rewrite cos_0; field).
    apply tends_div; [|apply tends_cos | rewrite cos_0; lra].
    apply tends_mul; [apply tends_mul; [apply tends_const|] |]; apply tends_sin_over.
Qed.

(** ** Values at multiples of 1/n, poles and limits at odd multiples of 1/(2n) *)
Theorem B_at_multiples : B_at_multiples_statement.
Proof.
  intros n k m Hn Hk; assert (0 < INR n) by (apply lt_0_INR; lia).
  assert (E : INR n * PI * (IZR m / INR n) = IZR m * PI) by (field; lra).
  assert (Es : sin (IZR m * PI) = 0) by (apply sin_eq_0_1; exists m; reflexivity).
  rewrite B_difference by (rewrite ?E; apply cos_turns_nonzero || assumption); rewrite E.
  set (a := PI * INR k * IZR m / INR n).
  replace ((INR n - 2 * INR k) * PI * (IZR m / INR n)) with (IZR m * PI - 2 * a) by (unfold a; field; lra).
  rewrite cos_minus, Es, cos_2a_sin; field; apply cos_turns_nonzero.
Qed.

Lemma cos_odd_half m : cos (IZR (2 * m + 1) * (PI / 2)) = 0.
Proof. apply cos_eq_0_1; exists m; rewrite plus_IZR, mult_IZR; field. Qed.

(** nu is an odd multiple of pi/2: cos nu = 0, sin^2 nu = 1. *)
Lemma B_near_odd nu kappa d e : cos nu = 0 -> sin e <> 0 ->
  1 - cos (nu - kappa + d) / cos (nu + e) = 1 + sin (kappa - d) / sin e.
Proof.
  intros Hc He; replace (nu - kappa + d) with (nu - (kappa - d)) by ring.
  assert (Hs : sin nu <> 0).
  { intros Hs; pose proof (sin2_cos2 nu) as H; rewrite Hc, Hs in H; unfold Rsqr in H; lra. }
  rewrite cos_minus, cos_plus, Hc, !Rmult_0_l, Rplus_0_l, Rminus_0_l. field; split; assumption.
Qed.

Lemma turns_sin j : sin (IZR (2 * j) * PI) = 0. Proof. apply sin_eq_0_1; exists (2 * j)%Z; reflexivity. Qed.

Lemma turns_cos j : cos (IZR (2 * j) * PI) = 1.
Proof.
  replace (IZR (2 * j) * PI) with (2 * (IZR j * PI)) by (rewrite mult_IZR; ring).
  rewrite cos_2a_sin, (sin_eq_0_1 (IZR j * PI)) by (exists j; reflexivity); ring.
Qed.

Lemma sin_small_nonzero n h : 0 < n -> h <> 0 -> Rabs h < / n -> sin (n * PI * h) <> 0.
Proof.
  intros Hn Hh Hs; pose proof PI_RGT_0; apply Rabs_def2 in Hs.
  destruct Hs as [Hlt Hgt]; apply (Rmult_lt_compat_l n) in Hlt, Hgt; try assumption.
  rewrite Ropp_mult_distr_r_reverse in Hgt; rewrite Rinv_r in Hlt, Hgt by lra.
  replace (n * PI * h) with (PI * (n * h)) by ring.
  assert (n * h <> 0) by (apply Rmult_integral_contrapositive_currified; lra).
  destruct (Rdichotomy (n * h) 0 ltac:(assumption)) as [Hneg|Hpos].
  - apply Rlt_not_eq, sin_lt_0_var; nra.
  - apply Rgt_not_eq, sin_gt_0; nra.
Qed.

(** Limits from the exact form B(h) = 1 + sin (kappa - w h) / sin (n pi h). *)
Section OddMultiples.
Variables (f : R -> R) (n w kappa : R).
Hypothesis n_pos : 0 < n.
Hypothesis exact : forall h, sin (n * PI * h) <> 0 -> f h = 1 + sin (kappa - w * h) / sin (n * PI * h).

Lemma exact_near h : h <> 0 -> Rabs h < / n -> 1 + sin (kappa - w * h) / sin (n * PI * h) = f h.
Proof. intros; symmetry; apply exact, sin_small_nonzero; assumption. Qed.

Lemma pole_residue : tends (fun h => h * f h) (sin kappa / (PI * n)).
Proof.
  pose proof PI_RGT_0; pose proof (Rinv_0_lt_compat n n_pos) as Hi.
  apply tends_near with (f := fun h => h + sin (kappa + - w * h) / (sin (n * PI * h) / h)) (z := / n); [assumption | |].
  - intros h Hh Hs; rewrite <- exact_near by assumption. replace (kappa + - w * h) with (kappa - w * h) by ring.
    pose proof (sin_small_nonzero n h n_pos Hh Hs); field; split; assumption.
  - rewrite <- (Rplus_0_l (_ / _)), (Rmult_comm PI). apply limit_plus; [apply tends_continuous; [reg | reflexivity]|].
    apply tends_div; [apply tends_sin | apply tends_sin_over | nra].
Qed.

Lemma limit_at_turn sg : (forall h, sin (kappa - w * h) = sg * sin (w * h)) -> tends f (1 + sg * (w / (n * PI))).
Proof.
  intros Hs; pose proof PI_RGT_0; pose proof (Rinv_0_lt_compat n n_pos) as Hi.
  apply tends_near with (2 := fun h Hh Hz => exact_near h Hh Hz); [assumption|]. apply limit_plus; [apply tends_const|].
  apply tends_ext with (fun h => sg * (sin (w * h) / sin (n * PI * h))).
  - intros h _; rewrite Hs; unfold Rdiv; ring.
  - apply tends_mul; [apply tends_const | apply tends_sin_ratio; nra].
Qed.
End OddMultiples.

Theorem B_at_odd_multiples : B_at_odd_multiples_statement.
Proof.
  intros n k m Hk s q; pose proof PI_RGT_0; assert (HN : 0 < INR n) by (apply lt_0_INR; lia).
  set (nu := IZR (2 * m + 1) * (PI / 2)); set (w := (INR n - 2 * INR k) * PI).
  assert (Hnu : cos nu = 0) by apply cos_odd_half.
  assert (E : forall h, sin (INR n * PI * h) <> 0 -> B n k (s + h) = 1 + sin (PI * q - w * h) / sin (INR n * PI * h)).
  { intros h Hh. assert (En : INR n * PI * (s + h) = nu + INR n * PI * h) by (unfold s, nu; field; lra).
    rewrite <- (B_near_odd nu) by assumption; rewrite B_difference, En; try lia.
    - do 3 f_equal; unfold nu, w, s, q; field; lra.
    - rewrite En, cos_plus, Hnu, Rmult_0_l, Rminus_0_l.
      apply Ropp_neq_0_compat, Rmult_integral_contrapositive_currified; [|assumption].
      intros Hs; pose proof (sin2_cos2 nu) as H'; rewrite Hnu, Hs in H'; unfold Rsqr in H'; lra. }
  refine (conj E (conj _ (conj _ _))).
  - exact (pole_residue _ _ w (PI * q) HN E).
  - intros j Hj; rewrite minus_INR by lia.
    replace (2 * (INR n - INR k) / INR n) with (1 + 1 * (w / (INR n * PI))) by (unfold w; field; lra).
    apply (limit_at_turn _ _ w (PI * q) HN E); intros h.
    replace (PI * q) with (IZR (2 * j) * PI + PI) by (rewrite Hj, plus_IZR; ring).
    rewrite sin_minus, neg_sin, neg_cos, turns_sin, turns_cos; ring.
  - intros j Hj. replace (2 * INR k / INR n) with (1 + -1 * (w / (INR n * PI))) by (unfold w; field; lra).
    apply (limit_at_turn _ _ w (PI * q) HN E); intros h.
    rewrite Hj, (Rmult_comm PI), sin_minus, turns_sin, turns_cos; ring.
Qed.
