(** * ln cos is strictly concave on (-pi/2, pi/2)

    Section 2 of ../conjecture1.md: one tangent inequality, by the mean value theorem.
    Every convexity argument that follows is a weighted sum of it. *)

From Coq Require Import Reals Lra.
Open Scope R_scope.

(** w lies in the window where cos is positive. *)
Definition window (w : R) : Prop := - (PI / 2) < w < PI / 2.
Definition lncos (w : R) : R := ln (cos w).

Lemma window_cos w : window w -> 0 < cos w. Proof. intros [? ?]; now apply cos_gt_0. Qed.
Lemma window_opp w : window w -> window (- w). Proof. unfold window; lra. Qed.
Lemma window_between v w z : window v -> window z -> v <= w <= z -> window w. Proof. unfold window; lra. Qed.
Lemma lncos_opp w : lncos (- w) = lncos w. Proof. unfold lncos; now rewrite cos_neg. Qed.
Lemma lncos_derivative w : window w -> derivable_pt_lim lncos w (- tan w).
Proof.
  intros Hw; pose proof (window_cos w Hw) as Hc. replace (- tan w) with (/ cos w * - sin w) by (unfold tan; field; lra).
  apply (derivable_pt_lim_comp cos ln w).
  - apply derivable_pt_lim_cos.
  - now apply derivable_pt_lim_ln.
Qed.
Lemma lncos_tangent_strict w0 w : window w0 -> window w -> w <> w0 -> lncos w < lncos w0 - tan w0 * (w - w0).
Proof.
  intros H0 H Hne; unfold window in *. destruct (Rlt_or_le w0 w) as [Hlt|Hle].
  - destruct (MVT_cor2 lncos (fun x => - tan x) w0 w Hlt) as (z & E & Hz).
    { intros z Hz; apply lncos_derivative; unfold window; lra. }
    assert (tan w0 < tan z) by (apply tan_increasing; lra). cbv beta in E; nra.
  - assert (Hlt : w < w0) by lra.
    destruct (MVT_cor2 lncos (fun x => - tan x) w w0 Hlt) as (z & E & Hz).
    { intros z Hz; apply lncos_derivative; unfold window; lra. }
    assert (tan z < tan w0) by (apply tan_increasing; lra). cbv beta in E; nra.
Qed.
Lemma lncos_tangent w0 w : window w0 -> window w -> lncos w <= lncos w0 - tan w0 * (w - w0).
Proof. intros H0 H; destruct (Req_dec w w0) as [->|Hne]; [lra|]. now apply Rlt_le, lncos_tangent_strict. Qed.
Lemma lncos_inj_le v w : window v -> window w -> lncos v <= lncos w -> Rabs w <= Rabs v.
Proof.
  intros Hv Hw Hle; apply Rnot_lt_le; intros Hlt; revert Hle.
  unfold window in *; apply Rlt_not_le, ln_increasing; [now apply window_cos|].
  replace (cos w) with (cos (Rabs w)) by (unfold Rabs; destruct Rcase_abs; now rewrite ?cos_neg).
  replace (cos v) with (cos (Rabs v)) by (unfold Rabs; destruct Rcase_abs; now rewrite ?cos_neg).
  pose proof (Rabs_pos v). assert (Rabs w < PI / 2) by (apply Rabs_def1; lra). apply cos_decreasing_1; lra.
Qed.
