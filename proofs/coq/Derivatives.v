(** * Derivatives, absolute values and the mean value theorem, as the files on differential equations use them *)
From Coq Require Import Reals ZArith Lra Lia.
Open Scope R_scope.

Lemma D_ext f f' x l l' : derivable_pt_lim f x l -> (forall y, f y = f' y) -> l = l' -> derivable_pt_lim f' x l'.
Proof. intros H E <- eps Heps; destruct (H eps Heps) as [d Hd]; exists d; intros h H0 Hh. rewrite <- !E; auto. Qed.
Lemma D_scale f x l k : derivable_pt_lim f x l -> derivable_pt_lim (fun y => k * f y) x (k * l).
Proof. apply derivable_pt_lim_scal. Qed.
Lemma D_plus f g x l m : derivable_pt_lim f x l -> derivable_pt_lim g x m ->
  derivable_pt_lim (fun y => f y + g y) x (l + m).
Proof. apply derivable_pt_lim_plus. Qed.
Lemma D_minus f g x l m : derivable_pt_lim f x l -> derivable_pt_lim g x m ->
  derivable_pt_lim (fun y => f y - g y) x (l - m).
Proof. apply derivable_pt_lim_minus. Qed.
Lemma D_times f g x l m : derivable_pt_lim f x l -> derivable_pt_lim g x m ->
  derivable_pt_lim (fun y => f y * g y) x (l * g x + f x * m).
Proof. apply derivable_pt_lim_mult. Qed.
Lemma D_over f g x l m : g x <> 0 -> derivable_pt_lim f x l -> derivable_pt_lim g x m ->
  derivable_pt_lim (fun y => f y / g y) x ((l * g x - m * f x) / (g x * g x)).
Proof. intros H Hf Hg; apply (derivable_pt_lim_div f g x l m Hf Hg H). Qed.
Lemma D_of f g x l m : derivable_pt_lim f x l -> derivable_pt_lim g (f x) m ->
  derivable_pt_lim (fun y => g (f y)) x (m * l).
Proof. intros Hf Hg; exact (derivable_pt_lim_comp f g x l m Hf Hg). Qed.
Lemma D_const c x : derivable_pt_lim (fun _ => c) x 0. Proof. apply derivable_pt_lim_const. Qed.
Lemma D_id x : derivable_pt_lim (fun y => y) x 1. Proof. apply derivable_pt_lim_id. Qed.
Lemma D_shift t0 t : derivable_pt_lim (fun t => t - t0) t 1.
Proof. eapply D_ext; [apply D_minus; [apply D_id | apply (D_const t0)] | reflexivity | ring]. Qed.
Lemma D_exp f x l : derivable_pt_lim f x l -> derivable_pt_lim (fun y => exp (f y)) x (exp (f x) * l).
Proof. intros H; apply (D_of f exp); [exact H | apply derivable_pt_lim_exp]. Qed.
Lemma D_sin f x l : derivable_pt_lim f x l -> derivable_pt_lim (fun y => sin (f y)) x (cos (f x) * l).
Proof. intros H; apply (D_of f sin); [exact H | apply derivable_pt_lim_sin]. Qed.
Lemma D_cos f x l : derivable_pt_lim f x l -> derivable_pt_lim (fun y => cos (f y)) x (- sin (f x) * l).
Proof. intros H; apply (D_of f cos); [exact H | apply derivable_pt_lim_cos]. Qed.
Lemma D_value f x l l' : derivable_pt_lim f x l -> l = l' -> derivable_pt_lim f x l'.
Proof. intros H <-; exact H. Qed.
Lemma D_back f f' s t : derivable_pt_lim f (s - t) f' -> derivable_pt_lim (fun t => f (s - t)) t (- f').
Proof. intros H; eapply D_value; [apply (D_of (fun t => s - t) f); [apply D_minus; [apply D_const | apply D_id] | exact
  H] | ring]. Qed.
Lemma D_later f f' s t : derivable_pt_lim f (t + s) f' -> derivable_pt_lim (fun t => f (t + s)) t f'.
Proof. intros H; eapply D_value; [apply (D_of (fun t => t + s) f); [apply D_plus; [apply D_id | apply D_const] | exact
  H] | ring]. Qed.
Lemma D_on f f' s t : derivable_pt_lim f (s + t) f' -> derivable_pt_lim (fun t => f (s + t)) t f'.
Proof. rewrite Rplus_comm; intros H; apply (D_ext _ _ _ _ _ (D_later f f' s t H)); [intros; f_equal; ring |
  reflexivity]. Qed.
(** The derivative of an expression, whose parts [close] knows; [ring] or [field] puts it in order. *)
Ltac derive_by close := eapply D_value;
  [repeat first [close | apply D_const | apply D_id | apply D_minus | apply D_plus
  | apply D_times | apply D_exp | apply D_sin | apply D_cos] | cbn beta].

Lemma constant_function f a b : (forall x, derivable_pt_lim f x 0) -> f a = f b.
Proof.
  intros H; destruct (Rtotal_order a b) as [L|[->|L]]; [|reflexivity|].
  - destruct (MVT_cor2 f (fun _ => 0) a b L) as (c & E & _); [auto|lra].
  - destruct (MVT_cor2 f (fun _ => 0) b a L) as (c & E & _); [auto|lra].
Qed.
Lemma le_abs a b : Rabs a <= b -> - b <= a <= b. Proof. unfold Rabs; destruct (Rcase_abs a); lra. Qed.
Lemma apart a b : Rabs (a - b) <= Rabs a + Rabs b.
Proof. unfold Rminus; rewrite <- (Rabs_Ropp b); apply Rabs_triang. Qed.
Lemma product a b A B : Rabs a <= A -> Rabs b <= B -> Rabs (a * b) <= A * B.
Proof. intros; rewrite Rabs_mult; apply Rmult_le_compat; trivial; apply Rabs_pos. Qed.
Lemma from a b e : Rabs (a - b) <= e -> Rabs a <= Rabs b + e.
Proof. intros H; replace a with (b + (a - b)) by ring; eapply Rle_trans; [apply Rabs_triang | lra]. Qed.
Lemma D_continuous f l x : derivable_pt_lim f x l -> continuity_pt f x.
Proof. intros H; exact (derivable_continuous_pt f x (exist _ l H)). Qed.
Lemma mvt f f' a b B : (forall x, derivable_pt_lim f x (f' x)) ->
  (forall x, Rmin a b <= x <= Rmax a b -> Rabs (f' x) <= B) -> Rabs (f a - f b) <= B * Rabs (a - b).
Proof.
  intros D H; destruct (Rtotal_order a b) as [L|[->|L]].
  - destruct (MVT_cor2 f f' a b L) as (x & E & Hx); [auto|].
    rewrite (Rabs_minus_sym (f a)), E, (Rabs_minus_sym a), Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos|].
    apply H; rewrite Rmin_left, Rmax_right; lra.
  - rewrite !Rminus_eq_0, Rabs_R0; lra.
  - destruct (MVT_cor2 f f' b a L) as (x & E & Hx); [auto|].
    rewrite E, Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos|]. apply H; rewrite Rmin_right, Rmax_left; lra.
Qed.

(** [mvt] on |x| <= r. *)
Lemma mvt_ball f f' r B a b : (forall x, derivable_pt_lim f x (f' x)) -> (forall x, Rabs x <= r -> Rabs (f' x) <= B) ->
  Rabs a <= r -> Rabs b <= r -> Rabs (f a - f b) <= B * Rabs (a - b).
Proof.
  intros D H Ha Hb; apply (mvt f f' a b B D); intros x Hx; apply H; apply Rabs_le; apply le_abs in Ha, Hb.
  revert Hx; unfold Rmin, Rmax; destruct (Rle_dec a b); lra.
Qed.
Lemma continuous_near f x eps : continuity_pt f x -> 0 < eps -> exists d, 0 < d /\
  forall y, Rabs (y - x) <= d -> Rabs (f y - f x) <= eps.
Proof.
  intros C He; destruct (C eps He) as (a & Ha & K); exists (a / 2); split; [lra|]; intros y Hy.
  destruct (Req_dec y x) as [->|H0]; [rewrite Rminus_eq_0, Rabs_R0; lra|].
  left; apply K; split; [split; [exact I | auto]|]; cbn; unfold R_dist; lra.
Qed.
Lemma continuous_bounded f r : 0 < r -> (forall x, continuity_pt f x) -> exists B, 0 <= B /\
  forall x, Rabs x <= r -> Rabs (f x) <= B.
Proof.
  intros Hr C. destruct (continuity_ab_maj f (- r) r ltac:(lra) (fun x _ => C x)) as (a & A & _).
  destruct (continuity_ab_min f (- r) r ltac:(lra) (fun x _ => C x)) as (b & B & _).
  exists (Rabs (f a) + Rabs (f b)); pose proof (Rabs_pos (f a)); pose proof (Rabs_pos (f b)); split; [lra|].
  intros x Hx; apply le_abs in Hx; specialize (A x Hx); specialize (B x Hx).
  pose proof (Rle_abs (f a)); pose proof (Rle_abs (- f b)) as Y; rewrite Rabs_Ropp in Y; apply Rabs_le; lra.
Qed.

(** A function of period p, any number of periods later; its derivative has the period, too. *)
Lemma whole (f : R -> R) p : (forall t, f (t + p) = f t) -> forall z t, f (t + p * IZR z) = f t.
Proof.
  intros H z t; assert (P : forall j t, f (t + p * INR j) = f t).
  { induction j as [|j IH]; intros y; [cbn; f_equal; ring|].
    rewrite <- (IH y), <- (H (y + p * INR j)), S_INR; f_equal; ring. }
  destruct (Z_le_gt_dec 0 z) as [L|L].
  - replace (IZR z) with (INR (Z.to_nat z)) by (rewrite INR_IZR_INZ, Z2Nat.id by lia; reflexivity); apply P.
  - rewrite <- (P (Z.to_nat (- z)) (t + p * IZR z)), INR_IZR_INZ, Z2Nat.id, opp_IZR by lia; f_equal; ring.
Qed.
Lemma periodic_slope (f f1 : R -> R) p : (forall t, f (t + p) = f t) -> (forall t, derivable_pt_lim f t (f1 t)) ->
  forall t, f1 (t + p) = f1 t.
Proof.
  intros P Df t; apply (uniqueness_limite f t); [|apply Df].
  apply (D_ext (fun y => f (y + p)) _ _ (f1 (t + p) * 1)); [|exact P|ring].
  apply (D_of (fun y => y + p) f); [derive_by fail; ring | apply Df].
Qed.
Lemma whole_periods f z t : (forall t, f (t + 2 * PI) = f t) -> f (t + 2 * PI * IZR z) = f t :> R.
Proof. intros H; apply whole, H. Qed.
Lemma cos_periods z t : cos (t + 2 * PI * IZR z) = cos t.
Proof. apply whole_periods; intros y; rewrite <- (cos_period y 1); f_equal; cbn; ring. Qed.
Lemma sin_periods z t : sin (t + 2 * PI * IZR z) = sin t.
Proof. apply whole_periods; intros y; rewrite <- (sin_period y 1); f_equal; cbn; ring. Qed.

(** A positive number that is at most two others. *)
Lemma two_least a b : 0 < a -> 0 < b -> exists m, 0 < m /\ m <= a /\ m <= b.
Proof. intros; exists (Rmin a b); split; [apply Rmin_glb_lt; assumption | split; [apply Rmin_l | apply Rmin_r]]. Qed.

(** A convex function that does not fall at one end is positive after it; and at the other end. *)
Section Convex.
Variables f f' f'' : R -> R.
Hypothesis D1 : forall x, derivable_pt_lim f x (f' x).
Hypothesis D2 : forall x, derivable_pt_lim f' x (f'' x).
Lemma convex_right a b x : 0 <= f a -> 0 <= f' a -> (forall y, a <= y <= b -> 0 < f'' y) -> a < x <= b -> 0 < f x.
Proof.
  intros H0 H1 H2 Hx.
  assert (P : forall y, a < y <= b -> 0 < f' y).
  { intros y Hy; destruct (MVT_cor2 f' f'' a y) as (c & E & Hc); [lra | auto|].
    assert (0 < f'' c * (y - a)) by (apply Rmult_lt_0_compat; [apply H2|]; lra); lra. }
  destruct (MVT_cor2 f f' a x) as (c & E & Hc); [lra | auto|].
  assert (0 < f' c * (x - a)) by (apply Rmult_lt_0_compat; [apply P|]; lra); lra.
Qed.
Lemma convex_left a b x : 0 <= f b -> f' b <= 0 -> (forall y, a <= y <= b -> 0 < f'' y) -> a <= x < b -> 0 < f x.
Proof.
  intros H0 H1 H2 Hx.
  assert (P : forall y, a <= y < b -> 0 < - f' y).
  { intros y Hy; destruct (MVT_cor2 f' f'' y b) as (c & E & Hc); [lra | auto|].
    assert (0 < f'' c * (b - y)) by (apply Rmult_lt_0_compat; [apply H2|]; lra); lra. }
  destruct (MVT_cor2 f f' x b) as (c & E & Hc); [lra | auto|].
  assert (0 < - f' c * (b - x)) by (apply Rmult_lt_0_compat; [apply P|]; lra); lra.
Qed.
End Convex.
