(** * The free motion of the paper's oscillator, explicitly, and legs from one impact to the next

    E(T) is the flow: E11, E12 in the first row. All lengths and velocities of legs are divided by mu. *)

From Coq Require Import Reals Lra Lia.
From Grazing Require Import StatementChaos.
Open Scope R_scope.

Definition E11 T := exp (- (6 / 49) * T) * (cos (8 / 49 * T) + 3 / 4 * sin (8 / 49 * T)).
Definition E12 T := exp (- (6 / 49) * T) * (49 / 8 * sin (8 / 49 * T)).
Definition E21 T := - (100 / 2401) * E12 T.
Definition E22 T := exp (- (6 / 49) * T) * (cos (8 / 49 * T) - 3 / 4 * sin (8 / 49 * T)).

(** ** Derivatives along a curve of times *)

Lemma D_ext f f' x l l' : derivable_pt_lim f x l -> (forall y, f y = f' y) -> l = l' ->
  derivable_pt_lim f' x l'.
Proof.
  intros H E <- eps Heps; destruct (H eps Heps) as [d Hd]; exists d; intros h H0 Hh.
  rewrite <- !E; auto.
Qed.

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
Lemma D_const c x : derivable_pt_lim (fun _ => c) x 0.
Proof. apply derivable_pt_lim_const. Qed.
Lemma D_id x : derivable_pt_lim (fun y => y) x 1.
Proof. apply derivable_pt_lim_id. Qed.

Section Curve.
Variables (T : R -> R) (x l : R).
Hypothesis HT : derivable_pt_lim T x l.

Lemma D_e : derivable_pt_lim (fun y => exp (- (6 / 49) * T y)) x (exp (- (6 / 49) * T x) * (- (6 / 49) * l)).
Proof. apply (D_of (fun y => - (6 / 49) * T y)); [apply D_scale, HT | apply derivable_pt_lim_exp]. Qed.
Lemma D_c : derivable_pt_lim (fun y => cos (8 / 49 * T y)) x (- sin (8 / 49 * T x) * (8 / 49 * l)).
Proof. apply (D_of (fun y => 8 / 49 * T y)); [apply D_scale, HT | apply derivable_pt_lim_cos]. Qed.
Lemma D_s : derivable_pt_lim (fun y => sin (8 / 49 * T y)) x (cos (8 / 49 * T x) * (8 / 49 * l)).
Proof. apply (D_of (fun y => 8 / 49 * T y)); [apply D_scale, HT | apply derivable_pt_lim_sin]. Qed.

Lemma D_E11 : derivable_pt_lim (fun y => E11 (T y)) x (E21 (T x) * l).
Proof.
  eapply D_ext; [apply (D_times _ _ _ _ _ D_e (D_plus _ _ _ _ _ D_c (D_scale _ _ _ (3 / 4) D_s)))|
    reflexivity|]; unfold E21, E12; field.
Qed.
Lemma D_E12 : derivable_pt_lim (fun y => E12 (T y)) x (E22 (T x) * l).
Proof.
  eapply D_ext; [apply (D_times _ _ _ _ _ D_e (D_scale _ _ _ (49 / 8) D_s))| reflexivity|];
    unfold E22; field.
Qed.
Lemma D_E21 : derivable_pt_lim (fun y => E21 (T y)) x (- (100 / 2401) * (E22 (T x) * l)).
Proof. apply (D_scale _ _ _ _ D_E12). Qed.
Lemma D_E22 : derivable_pt_lim (fun y => E22 (T y)) x ((E21 (T x) - 12 / 49 * E22 (T x)) * l).
Proof.
  eapply D_ext; [apply (D_times _ _ _ _ _ D_e (D_minus _ _ _ _ _ D_c (D_scale _ _ _ (3 / 4) D_s)))|
    reflexivity|]; unfold E21, E12, E22; field.
Qed.
End Curve.

Lemma E_0 : E11 0 = 1 /\ E12 0 = 0 /\ E21 0 = 0 /\ E22 0 = 1.
Proof.
  unfold E21, E11, E12, E22; rewrite !Rmult_0_r, exp_0, cos_0, sin_0; repeat split; ring.
Qed.

Lemma E22_E11 T : E22 T = E11 T - 12 / 49 * E12 T.
Proof. unfold E22, E11, E12; field. Qed.

Lemma E_det T : E11 T * E22 T - E12 T * E21 T = exp (- (6 / 49) * T) * exp (- (6 / 49) * T).
Proof.
  unfold E21, E11, E12, E22; pose proof (sin2_cos2 (8 / 49 * T)) as H; unfold Rsqr in H.
  set (c := cos _) in *; set (s := sin _) in *; set (e := exp _).
  replace (e * e) with (e * e * (s * s + c * c)) by (rewrite H; ring); field.
Qed.

(** ** The free motion from a place x with velocity u at time t0, and there is no other *)

Definition moved t0 x u t := E11 (t - t0) * x + E12 (t - t0) * u.
Definition moving t0 x u t := E21 (t - t0) * x + E22 (t - t0) * u.

Lemma D_shift t0 t : derivable_pt_lim (fun t => t - t0) t 1.
Proof. eapply D_ext; [apply D_minus; [apply D_id | apply (D_const t0)] | reflexivity | ring]. Qed.

Lemma moved_free t0 x u : free (moved t0 x u) (moving t0 x u).
Proof.
  intros t; pose proof (D_shift t0 t) as HT; unfold moved, moving; split.
  - eapply D_ext; [apply D_plus; (eapply D_times; [|apply D_const]); [apply D_E11 | apply D_E12]; exact HT
      | reflexivity | cbn beta; ring].
  - eapply D_ext; [apply D_plus; (eapply D_times; [|apply D_const]); [apply D_E21 | apply D_E22]; exact HT
      | reflexivity | cbn beta; unfold E21; rewrite E22_E11; ring].
Qed.

Lemma moved_start t0 x u : moved t0 x u t0 = x /\ moving t0 x u t0 = u.
Proof.
  unfold moved, moving; replace (t0 - t0) with 0 by ring; destruct E_0 as (-> & -> & -> & ->); lra.
Qed.

Lemma constant_function f a b : (forall x, derivable_pt_lim f x 0) -> f a = f b.
Proof.
  intros H; destruct (Rtotal_order a b) as [L|[->|L]]; [|reflexivity|].
  - destruct (MVT_cor2 f (fun _ => 0) a b L) as (c & E & _); [auto|lra].
  - destruct (MVT_cor2 f (fun _ => 0) b a L) as (c & E & _); [auto|lra].
Qed.

Lemma free_moved q v t0 t : free q v -> q t = moved t0 (q t0) (v t0) t /\ v t = moving t0 (q t0) (v t0) t.
Proof.
  intros H.
  assert (D : forall y, derivable_pt_lim (fun y => t - y) y (-1)).
  { intros y; eapply D_ext; [apply D_minus; [apply (D_const t) | apply D_id] | reflexivity | ring]. }
  destruct E_0 as (Z1 & Z2 & Z3 & Z4).
  assert (A : E11 (t - t0) * q t0 + E12 (t - t0) * v t0 = E11 (t - t) * q t + E12 (t - t) * v t).
  { apply (constant_function (fun y => E11 (t - y) * q y + E12 (t - y) * v y)); intros y;
    destruct (H y) as [Hq Hv].
    eapply D_ext; [apply D_plus; eapply D_times; [apply D_E11, D | exact Hq | apply D_E12, D | exact Hv]
      | reflexivity | cbn beta; unfold E21; rewrite E22_E11; ring]. }
  assert (B : E21 (t - t0) * q t0 + E22 (t - t0) * v t0 = E21 (t - t) * q t + E22 (t - t) * v t).
  { apply (constant_function (fun y => E21 (t - y) * q y + E22 (t - y) * v y)); intros y;
    destruct (H y) as [Hq Hv].
    eapply D_ext; [apply D_plus; eapply D_times; [apply D_E21, D | exact Hq | apply D_E22, D | exact Hv]
      | reflexivity | cbn beta; unfold E21; rewrite E22_E11; ring]. }
  replace (t - t) with 0 in A, B by ring; rewrite Z1, Z2 in A; rewrite Z3, Z4 in B.
  unfold moved, moving; lra.
Qed.

(** ** Legs, in units of mu: nu = mu/(1 + mu), phases t and t' of the impacts, n periods between *)

Definition place nu t := 1 - (1 - cos t) / nu.
Definition time (n : Z) t t' := 2 * PI * IZR n + t' - t.
Definition after n nu t t' :=
  (place nu t' - E11 (time n t t') * place nu t) / E12 (time n t t').
Definition before n nu t t' := E21 (time n t t') * place nu t + E22 (time n t t') * after n nu t t'.

(** The derivatives when t and t' move with velocities l, l'; the places move with - sin t/nu. *)
Definition after_slope n nu t t' l l' := ((l * (before n nu t t' - E11 (time n t t') * (- sin t / nu)) +
  l' * (- sin t' / nu - before n nu t t')) / E12 (time n t t')).
Definition before_slope n nu t t' l l' :=
  let acc := - (12 / 49) * before n nu t t' - 100 / 2401 * place nu t' in
  E21 (time n t t') * (- sin t / nu) * l + E22 (time n t t') * after_slope n nu t t' l l' + acc * (l' - l).

Section Leg.
Variables (n : Z) (nu : R) (t t' : R -> R) (x l l' : R).
Hypothesis Hnu : nu <> 0.
Hypothesis Ht : derivable_pt_lim t x l.
Hypothesis Ht' : derivable_pt_lim t' x l'.
Hypothesis HE : E12 (time n (t x) (t' x)) <> 0.

Lemma D_place f m : derivable_pt_lim f x m ->
  derivable_pt_lim (fun y => place nu (f y)) x (- sin (f x) / nu * m).
Proof.
  intros Hf; unfold place; eapply D_ext.
  - apply (D_minus (fun _ => 1)); [apply D_const|].
    eapply (D_scale (fun y => 1 - cos (f y)) x _ (/ nu)).
    apply (D_minus (fun _ => 1)); [apply D_const|].
    apply (D_of f cos); [exact Hf | apply derivable_pt_lim_cos].
  - intros y; cbn beta; field; exact Hnu.
  - field; exact Hnu.
Qed.

Lemma D_time : derivable_pt_lim (fun y => time n (t y) (t' y)) x (l' - l).
Proof.
  unfold time; eapply D_ext.
  - apply D_minus; [|exact Ht]; apply D_plus; [apply (D_const (2 * PI * IZR n)) | exact Ht'].
  - reflexivity.
  - ring.
Qed.

Lemma D_after : derivable_pt_lim (fun y => after n nu (t y) (t' y)) x (after_slope n nu (t x) (t' x) l l').
Proof.
  unfold after; eapply D_ext.
  - apply (D_over (fun y => place nu (t' y) - E11 (time n (t y) (t' y)) * place nu (t y))
      (fun y => E12 (time n (t y) (t' y)))); [exact HE| |apply D_E12, D_time].
    apply D_minus; [apply D_place, Ht'|].
    apply D_times; [apply D_E11, D_time | apply D_place, Ht].
  - reflexivity.
  - unfold after_slope, before, after; cbn beta.
    set (T := time _ _ _) in *; field; split; assumption.
Qed.

Lemma D_before : derivable_pt_lim (fun y => before n nu (t y) (t' y)) x (before_slope n nu (t x) (t' x) l l').
Proof.
  unfold before; eapply D_ext.
  - apply D_plus; apply D_times.
    + apply D_E21, D_time.
    + apply D_place, Ht.
    + apply D_E22, D_time.
    + apply D_after.
  - reflexivity.
  - unfold before_slope, before; cbn beta; set (d := after_slope _ _ _ _ _ _).
    unfold after; set (T := time _ _ _) in *; rewrite E22_E11; unfold E21; field; split; assumption.
Qed.

(** The leg hits the second place, with velocity [before]. *)
Lemma leg_hits n0 t0 t1 : E12 (time n0 t0 t1) <> 0 ->
  E11 (time n0 t0 t1) * place nu t0 + E12 (time n0 t0 t1) * after n0 nu t0 t1 = place nu t1.
Proof. intros H; unfold after; field; exact H. Qed.
End Leg.
