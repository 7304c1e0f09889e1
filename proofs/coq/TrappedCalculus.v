(** Taylor inequalities, the first zero, and signs of a derivative at a one-sided zero. *)
From Coq Require Import Reals Lra.
From Grazing Require Import Derivatives.
Open Scope R_scope.

Lemma Rmult_le_0_r x y : x <= 0 -> 0 <= y -> x * y <= 0. Proof. intros; nra. Qed.

Section Taylor.
Variables g g1 g2 : R -> R.
Hypothesis D1 : forall t, derivable_pt_lim g t (g1 t).
Hypothesis D2 : forall t, derivable_pt_lim g1 t (g2 t).

Lemma slope_right m s e : s <= e -> (forall y, s <= y <= e -> m <= g2 y) -> g1 s + m * (e - s) <= g1 e.
Proof.
  intros L H; destruct (Req_dec s e) as [->|Ne]; [lra|]. destruct (MVT_cor2 g1 g2 s e) as (y & E & Hy);
    [lra|auto|]; specialize (H y ltac:(lra)); nra.
Qed.
Lemma above_right m s e : s <= e -> (forall y, s <= y <= e -> m <= g2 y) ->
  g s + g1 s * (e - s) + m / 2 * (e - s) ^ 2 <= g e.
Proof.
  intros L H; destruct (Req_dec s e) as [->|Ne]; [lra|]. destruct (MVT_cor2 (fun t => g t - (g1 s * (t - s) + m / 2 *
    (t - s) ^ 2)) (fun t => g1 t - (g1 s + m * (t - s))) s e) as (y & E & Hy); [lra| |].
  - intros t _; apply (D_ext (fun t => g t - (g1 s * (t - s) + m / 2 * ((t - s) * (t - s)))) _ _ (g1 t - (g1 s * 1 + m
      / 2 * (1 * (t - s) + (t - s) * 1)))); [|intros; simpl; ring|field]. apply D_minus;
      [apply D1|apply D_plus; [apply D_scale, D_shift|apply D_scale; apply (D_times (fun t => t - s) (fun t => t -
      s)); apply D_shift]].
  - pose proof (slope_right m s y ltac:(lra) ltac:(intros; apply H; lra)); cbn in E; nra.
Qed.
Lemma above_left m s e : e <= s -> (forall y, e <= y <= s -> m <= g2 y) ->
  g s + g1 s * (e - s) + m / 2 * (e - s) ^ 2 <= g e.
Proof.
  intros L H; destruct (Req_dec s e) as [->|Ne]; [lra|]. destruct (MVT_cor2 (fun t => g t - (g1 s * (t - s) + m / 2 *
    (t - s) ^ 2)) (fun t => g1 t - (g1 s + m * (t - s))) e s) as (y & E & Hy); [lra| |].
  - intros t _; apply (D_ext (fun t => g t - (g1 s * (t - s) + m / 2 * ((t - s) * (t - s)))) _ _ (g1 t - (g1 s * 1 + m
      / 2 * (1 * (t - s) + (t - s) * 1)))); [|intros; simpl; ring|field]. apply D_minus;
      [apply D1|apply D_plus; [apply D_scale, D_shift|apply D_scale; apply (D_times (fun t => t - s) (fun t => t -
      s)); apply D_shift]].
  - destruct (Req_dec y s) as [->|Ny]; [lra|]. destruct (MVT_cor2 g1 g2 y s) as (w & Ew & Hw); [lra|auto|];
      specialize (H w ltac:(lra)); cbn in E. assert (K : g1 y - (g1 s + m * (y - s)) <= 0) by nra.
    assert ((g1 y - (g1 s + m * (y
      - s))) * (s - e) <= 0) by (apply Rmult_le_0_r; lra); nra.
Qed.
End Taylor.

(** A function that is positive just before a zero does not rise there; one that is not negative after it,
    not fall. *)
Lemma slope_at g l t s : derivable_pt_lim g t l -> s < t -> (forall y, s < y < t -> 0 < g y) -> g t = 0 ->
  l <= 0.
Proof.
  intros D L H Z; destruct (Rle_or_lt l 0) as [|P]; [trivial|exfalso]. destruct (D (l / 2) ltac:(lra)) as ([d Hd]
    & B); cbn in B. set (h := - (Rmin (d / 2) ((t - s) / 2))). assert (Hh : - d < h < 0 /\ s < t + h < t) by (unfold
    h, Rmin; destruct Rle_dec; lra). specialize (B h ltac:(lra) ltac:(apply Rabs_def1; lra));
    apply Rabs_def2 in B; specialize (H (t + h) ltac:(lra)). rewrite Z in B; assert ((g (t + h) - 0) / h < 0);
    [|lra]. apply Ropp_lt_cancel; replace (- ((g (t + h) - 0) / h)) with (g (t + h) * / - h) by (field; lra).
  rewrite Ropp_0; apply Rmult_lt_0_compat; [lra|apply Rinv_0_lt_compat; lra].
Qed.
Lemma slope_after g l t s : derivable_pt_lim g t l -> t < s -> (forall y, t < y < s -> 0 <= g y) -> g t = 0 ->
  0 <= l.
Proof.
  intros D L H Z; destruct (Rle_or_lt 0 l) as [|P]; [trivial|exfalso]. destruct (D (- l / 2) ltac:(lra)) as ([d Hd]
    & B); cbn in B. set (h := Rmin (d / 2) ((s - t) / 2)). assert (Hh : 0 < h < d /\ t < t + h < s) by (unfold h,
    Rmin; destruct Rle_dec; lra). specialize (B h ltac:(lra) ltac:(apply Rabs_def1; lra));
    apply Rabs_def2 in B; specialize (H (t + h) ltac:(lra)). rewrite Z in B; assert (0 <= (g (t + h) - 0) / h);
    [|lra]. apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; lra].
Qed.

(** The first zero after s. *)
Lemma first_zero g s e : (forall t, continuity_pt g t) -> s < e -> 0 < g s -> g e <= 0 ->
  exists t, s < t <= e /\ g t = 0 /\ forall y, s <= y < t -> 0 < g y.
Proof.
  intros C L P N. set (good := fun t => s <= t <= e /\ forall y, s <= y <= t -> 0 < g y).
  assert (G0 : good s) by (split; [lra|intros y Hy; replace y with s by lra; trivial]).
  destruct (completeness good) as (m & Up & Least); [exists e; intros t [H _]; lra|exists s; trivial|].
  assert (Hs : s <= m) by (apply Up, G0); assert (He : m <= e) by (apply Least; intros t [H _]; lra).
  assert (Before : forall y, s <= y < m -> 0 < g y).
  { intros y Hy; destruct (Rlt_or_le 0 (g y)) as [|B]; [trivial|exfalso]. assert (m <= y); [|lra]; apply Least;
      intros t [Ht Hp]; apply Rnot_lt_le; intros Hty. specialize (Hp y ltac:(lra)); lra. }
  assert (Z : g m = 0).
  { destruct (Rtotal_order (g m) 0) as [Neg|[E|Pos]]; [exfalso|trivial|exfalso].
    - destruct (continuous_near g m (- g m / 2) (C m) ltac:(lra)) as (d & Hd & B). destruct (Req_dec s m) as [<-|Ne];
        [lra|]. set (y := Rmax s (m - d / 2)); assert (s <= y < m /\ m - d < y) by (unfold y, Rmax;
        destruct Rle_dec; lra). specialize (B y ltac:(apply Rabs_le; lra)); specialize (Before y ltac:(lra)).
      apply le_abs in B; lra.
    - destruct (continuous_near g m (g m / 2) (C m) ltac:(lra)) as (d & Hd & B). destruct (Req_dec m e) as [->|Ne];
        [lra|]. set (y := Rmin e (m + d / 2)); assert (m < y <= e /\ y < m + d) by (unfold y, Rmin;
        destruct Rle_dec; lra). assert (y <= m); [apply Up; split; [lra|]|lra]. intros w Hw;
        destruct (Rlt_or_le w m) as [Lw|Lw]; [apply Before; lra|]. specialize (B w ltac:(apply Rabs_le; lra));
        apply le_abs in B; lra. }
  exists m; split; [|split; trivial]; split; [|trivial]. destruct (Req_dec s m) as [<-|Ne]; lra.
Qed.
