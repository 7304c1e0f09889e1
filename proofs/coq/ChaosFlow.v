(** * The paper's oscillator moves freely by an explicit flow, and this gives its legs between impacts

    E(T) is the flow: E11, E12 in the first row. All lengths and velocities of legs are divided by mu. *)

From Coq Require Import Reals Lra Lia.
From Grazing Require Import StatementChaos.
From Grazing Require Export Derivatives.
From Grazing Require StatementOscillator Flow.
Open Scope R_scope.

Definition E12 T := exp (- (6 / 49) * T) * (49 / 8 * sin (8 / 49 * T)).
Definition E22 T := exp (- (6 / 49) * T) * (cos (8 / 49 * T) - 3 / 4 * sin (8 / 49 * T)).
Definition E11 := Flow.e11 (12 / 49) E12 E22.
Definition E21 := Flow.e21 (100 / 2401) E12.
Lemma E11_is T : E11 T = exp (- (6 / 49) * T) * (cos (8 / 49 * T) + 3 / 4 * sin (8 / 49 * T)).
Proof. unfold E11, Flow.e11, E12, E22; field. Qed.

(** ** Derivatives along a curve of times *)

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
    intros; symmetry; apply E11_is|]; unfold E21, Flow.e21, E12; field.
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
    reflexivity|]; unfold E21, Flow.e21, E12, E22; field.
Qed.
End Curve.

Lemma E_0 : E11 0 = 1 /\ E12 0 = 0 /\ E21 0 = 0 /\ E22 0 = 1.
Proof.
  rewrite E11_is; unfold E21, Flow.e21, E12, E22; rewrite !Rmult_0_r, exp_0, cos_0, sin_0; repeat split; ring.
Qed.

Lemma E22_E11 T : E22 T = E11 T - 12 / 49 * E12 T.
Proof. unfold E11, Flow.e11; ring. Qed.

Lemma E_det T : E11 T * E22 T - E12 T * E21 T = exp (- (6 / 49) * T) * exp (- (6 / 49) * T).
Proof.
  rewrite E11_is; unfold E21, Flow.e21, E12, E22; pose proof (sin2_cos2 (8 / 49 * T)) as H; unfold Rsqr in H.
  set (c := cos _) in *; set (s := sin _) in *; set (e := exp _).
  replace (e * e) with (e * e * (s * s + c * c)) by (rewrite H; ring); field.
Qed.

(** ** The free motion from a place x with velocity u at time t0, and there is no other *)

Lemma E_flow : Flow.flow (12 / 49) (100 / 2401) E12 E22.
Proof.
  destruct E_0 as (_ & Z2 & _ & Z4); constructor; trivial; intros t; split.
  - apply (D_value _ _ _ _ (D_E12 _ _ _ (D_id t))); ring.
  - apply (D_value _ _ _ _ (D_E22 _ _ _ (D_id t))); unfold E21, Flow.e21; ring.
Qed.

Definition moved t0 x u t := E11 (t - t0) * x + E12 (t - t0) * u.
Definition moving t0 x u t := E21 (t - t0) * x + E22 (t - t0) * u.

Definition moved_free : forall t0 x u, free (moved t0 x u) (moving t0 x u) := Flow.moved_free _ _ _ _ E_flow.
Definition moved_start : forall t0 x u, moved t0 x u t0 = x /\ moving t0 x u t0 = u := Flow.moved_start _ _ _ _ E_flow.
Definition free_moved : forall q v t0 t, free q v -> q t = moved t0 (q t0) (v t0) t /\ v t = moving t0 (q t0) (v t0) t :=
  Flow.free_moved _ _ _ _ E_flow.

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
    unfold after; set (T := time _ _ _) in *; rewrite E22_E11; unfold E21, Flow.e21; field; split; assumption.
Qed.

(** The leg hits the second place, with velocity [before]. *)
Lemma leg_hits n0 t0 t1 : E12 (time n0 t0 t1) <> 0 ->
  E11 (time n0 t0 t1) * place nu t0 + E12 (time n0 t0 t1) * after n0 nu t0 t1 = place nu t1.
Proof. intros H; unfold after; field; exact H. Qed.
End Leg.
