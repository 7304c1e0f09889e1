(** * The paper's stop (65)-(67) is a hump; with d = 3/2, w = 8, tau = 4/5 every return separates,
    to mu = 1/10 *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Derivatives StatementTrapped.
Open Scope R_scope.

Theorem Paper : Paper_statement.
Proof.
  intros d w tau mu Z S Hd Hw Ht Hm; set (h := acos (/ (1 + mu))). assert (R1 : sqrt (d ^ 2 - 1) * sqrt (d ^ 2 - 1) =
    d ^
    2 - 1) by (apply sqrt_sqrt; nra). assert (R0 : 0 < sqrt (d ^ 2 - 1) < d). { split; [apply sqrt_lt_R0; nra|];
    pose proof (sqrt_pos (d ^ 2 - 1)); nra. } assert (Iw : 0 < / w) by (apply Rinv_0_lt_compat; lra). cbv zeta;
    split; [cbn; field; lra|split; [cbn; set (r := sqrt _) in *; transitivity ((d * d - r * r) / w ^ 2);
    [field; lra|rewrite R1; field; lra]|]]. assert (I : 0 < / (1 + mu) < 1).
  { split; [apply Rinv_0_lt_compat; lra|rewrite <- Rinv_1 at 2; apply Rinv_lt_contravar; lra]. }
  assert (C : cos h = / (1 + mu)) by (apply cos_acos; lra). destruct (acos_bound (/ (1 + mu))) as [b1 b2];
    fold h in b1, b2; pose proof PI_RGT_0 as Pp. assert (b3 : h < PI) by (destruct (Req_dec h PI) as [E|E];
    [rewrite E, cos_PI in C; lra|lra]). assert (E1 : (1 + mu) * cos h = 1) by (rewrite C; field; lra).
  assert (Less : forall t, h < t <= PI -> (1 + mu) * cos t < 1).
  { intros t Ht'; assert ((1 + mu) * cos t < (1 + mu) * cos h); [apply Rmult_lt_compat_l; [lra|];
      apply cos_decreasing_1; lra|lra]. }
  assert (More : forall t, 0 <= t <= h -> 1 <= (1 + mu) * cos t).
  { intros t Ht'; assert ((1 + mu) * cos h <= (1 + mu) * cos t); [apply Rmult_le_compat_l; [lra|];
      apply cos_decr_1; lra|lra]. }
  assert (Hab : 0 < (d - sqrt (d ^ 2 - 1)) / w < (d + sqrt (d ^ 2 - 1)) / w).
  { split; [apply Rdiv_lt_0_compat; lra|apply Rmult_lt_compat_r; lra]. }
  split; cbn [a b StatementTrapped.tau p W StatementTrapped.mu al0 al1 Q Q1 Q2 paper]; fold h; trivial; try lra.
  - intros t; replace (cos (t + 2 * PI)) with (cos t) by (symmetry; apply (cos_period t 1) || (rewrite cos_plus,
      cos_2PI, sin_2PI; ring)); ring.
  - intros t; apply (D_ext (fun t => (1 + mu) * cos t - 1) _ _ ((1 + mu) * - sin t - 0)); [|reflexivity|ring].
    apply D_minus; [apply D_scale, derivable_pt_lim_cos|apply D_const].
  - intros t; eapply D_value; [apply (D_scale sin), derivable_pt_lim_sin|ring].
  - intros t Ht'; destruct (Rle_or_lt t PI) as [L|L]; [specialize (Less t ltac:(lra)); lra|]. specialize (Less (2 * PI
      - t) ltac:(lra)); rewrite cos_minus, cos_2PI, sin_2PI in Less; lra.
  - intros t Ht'; pose proof (COS_bound t) as [_ c1]; assert (1 <= (1 + mu) * cos t).
    { destruct (Rle_or_lt 0 t) as [L|L]; [apply More; lra|rewrite <- cos_neg; apply More; lra]. }
    assert ((1 + mu) * cos t <= (1 + mu) * 1) by (apply Rmult_le_compat_l; lra); lra.
  - intros t; pose proof (COS_bound t) as [_ c1]; assert ((1 + mu) * cos t <= (1 + mu) * 1) by (apply
      Rmult_le_compat_l; lra); lra.
  - exists 0; rewrite cos_0; ring.
Qed.
