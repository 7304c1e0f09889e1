(** * For all c and k every free motion of q'' = - c q' - k q comes from one solution S, V with S 0 = 0, V 0 = 1 *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import Derivatives StatementOscillator.
Open Scope R_scope.

(** The flow is (e11 S; e21 V). *)
Record flow (c k : R) (S V : R -> R) : Prop := { flow_free : free c k S V; flow_S : S 0 = 0; flow_V : V 0 = 1 }.

Section Flow.
Variables (c k : R) (S V : R -> R).
Hypothesis HS : flow c k S V.
Definition e11 t := V t + c * S t.
Definition e21 t := - k * S t.
Definition moved t0 x w t := e11 (t - t0) * x + S (t - t0) * w.
Definition moving t0 x w t := e21 (t - t0) * x + V (t - t0) * w.

Lemma D_S x : derivable_pt_lim S x (V x). Proof. apply HS. Qed.
Lemma D_V x : derivable_pt_lim V x (- c * V x - k * S x). Proof. apply HS. Qed.
Lemma D_e11 x : derivable_pt_lim e11 x (e21 x).
Proof. unfold e11; derive_by ltac:(first [apply D_S | apply D_V]); unfold e21; ring. Qed.
Lemma D_e21 x : derivable_pt_lim e21 x (- k * V x). Proof. apply D_scale, D_S. Qed.
Lemma D_at f l t0 t : derivable_pt_lim f (t - t0) l -> derivable_pt_lim (fun y => f (y - t0)) t l.
Proof. intros H; eapply D_ext; [apply (D_of (fun y => y - t0) f); [apply D_shift | exact H] | reflexivity | ring]. Qed.
Lemma moved_free t0 x w : free c k (moved t0 x w) (moving t0 x w).
Proof.
  intros t; unfold moved, moving; split.
  - derive_by ltac:(first [apply D_at, D_e11 | apply D_at, D_S]); ring.
  - derive_by ltac:(first [apply D_at, D_e21 | apply D_at, D_V]); unfold e11, e21; ring.
Qed.
Lemma moved_start t0 x w : moved t0 x w t0 = x /\ moving t0 x w t0 = w.
Proof. unfold moved, moving, e11, e21; rewrite Rminus_eq_0, (flow_S _ _ _ _ HS), (flow_V _ _ _ _ HS); lra. Qed.

(** There is no other free motion. *)
Lemma free_moved q v t0 t : free c k q v -> q t = moved t0 (q t0) (v t0) t /\ v t = moving t0 (q t0) (v t0) t.
Proof.
  intros H; assert (Dq := fun y => proj1 (H y)); assert (Dv := fun y => proj2 (H y)).
  assert (A : e11 (t - t0) * q t0 + S (t - t0) * v t0 = e11 (t - t) * q t + S (t - t) * v t).
  { apply (constant_function (fun y => e11 (t - y) * q y + S (t - y) * v y)); intros y.
    derive_by ltac:(first [apply D_back, D_e11 | apply D_back, D_S | apply Dq | apply Dv]); unfold e11, e21; ring. }
  assert (B : e21 (t - t0) * q t0 + V (t - t0) * v t0 = e21 (t - t) * q t + V (t - t) * v t).
  { apply (constant_function (fun y => e21 (t - y) * q y + V (t - y) * v y)); intros y.
    derive_by ltac:(first [apply D_back, D_e21 | apply D_back, D_V | apply Dq | apply Dv]); unfold e11, e21; ring. }
  unfold moved, moving; rewrite Rminus_eq_0 in A, B; unfold e11 at 2 in A; unfold e21 at 2 in B.
  rewrite (flow_S _ _ _ _ HS), (flow_V _ _ _ _ HS) in A, B; lra.
Qed.
Lemma flow_plus t t' : S (t + t') = e11 t * S t' + S t * V t' /\ V (t + t') = e21 t * S t' + V t * V t'.
Proof.
  destruct (free_moved S V t' (t + t') (flow_free _ _ _ _ HS)) as [E F]; unfold moved, moving in E, F.
  replace (t + t' - t') with t in E, F by ring; auto.
Qed.
End Flow.

(** ** All cases at once: o' = w, w' = - D o, o 0 = 0, w 0 = 1, where k = c^2/4 + D *)
Record undamped (D : R) (o w : R -> R) : Prop := {
  undamped_o : forall t, derivable_pt_lim o t (w t);
  undamped_w : forall t, derivable_pt_lim w t (- D * o t);
  undamped_0 : o 0 = 0 /\ w 0 = 1 }.
Definition damped_S c (o : R -> R) t := exp (- c / 2 * t) * o t.
Definition damped_V c (o w : R -> R) t := exp (- c / 2 * t) * (w t - c / 2 * o t).

Lemma damped c D o w : undamped D o w -> flow c (c * c / 4 + D) (damped_S c o) (damped_V c o w).
Proof.
  intros [Ho Hw [E1 E2]]; unfold damped_S, damped_V; constructor.
  - intros t; split; [derive_by ltac:(apply Ho); field|]. derive_by ltac:(first [apply Ho | apply Hw]); field.
  - rewrite E1; ring.
  - rewrite Rmult_0_r, exp_0, E1, E2; ring.
Qed.
Lemma undamped_energy D o w t : undamped D o w -> w t * w t + D * (o t * o t) = 1.
Proof.
  intros [Ho Hw [E1 E2]]; transitivity (w 0 * w 0 + D * (o 0 * o 0)); [|rewrite E1, E2; ring].
  apply (constant_function (fun t => w t * w t + D * (o t * o t))); intros y.
  derive_by ltac:(first [apply Ho | apply Hw]); ring.
Qed.
Lemma undamped_circular o : o <> 0 -> undamped (o * o) (fun t => / o * sin (o * t)) (fun t => cos (o * t)).
Proof.
  intros Ho; constructor.
  - intros t; derive_by fail; field; exact Ho.
  - intros t; derive_by fail; field; exact Ho.
  - rewrite !Rmult_0_r, sin_0, cos_0; lra.
Qed.
Lemma undamped_straight : undamped 0 (fun t => t) (fun _ => 1).
Proof. constructor; [intros t; apply D_id | intros t; derive_by fail; ring | lra]. Qed.
Lemma undamped_hyperbolic o : o <> 0 -> undamped (- (o * o))
  (fun t => / (2 * o) * (exp (o * t) - exp (- o * t))) (fun t => / 2 * (exp (o * t) + exp (- o * t))).
Proof.
  intros Ho; constructor.
  - intros t; derive_by fail; field; exact Ho.
  - intros t; derive_by fail; field; exact Ho.
  - rewrite !Rmult_0_r, exp_0; lra.
Qed.

(** For D <= 0 both stay positive. *)
Lemma undamped_exists D : exists o w, undamped D o w /\ (D <= 0 -> forall t, 0 < t -> 0 < o t /\ 1 <= w t).
Proof.
  destruct (Rtotal_order D 0) as [H|[->|H]].
  - pose proof (sqrt_lt_R0 (- D) ltac:(lra)) as Hr; pose proof (sqrt_sqrt (- D) ltac:(lra)) as E.
    set (r := sqrt (- D)) in *; pose proof (undamped_hyperbolic r ltac:(lra)) as U.
    replace (- (r * r)) with D in U by lra; eexists _, _; split; [exact U|]; intros _ t Ht; cbv beta.
    assert (Hx : 0 < r * t) by (apply Rmult_lt_0_compat; lra).
    replace (- r * t) with (- (r * t)) by ring; set (x := r * t) in *.
    pose proof (exp_increasing (- x) x ltac:(lra)); pose proof (exp_pos x) as P; split.
    + apply Rmult_lt_0_compat; [apply Rinv_0_lt_compat|]; lra.
    + rewrite exp_Ropp; assert (0 <= (exp x - 1) * (exp x - 1) * / exp x).
      { apply Rmult_le_pos; [apply Rle_0_sqr | left; apply Rinv_0_lt_compat, P]. }
      replace (exp x + / exp x) with ((exp x - 1) * (exp x - 1) * / exp x + 2) by (field; lra); lra.
  - exists (fun t => t), (fun _ => 1); split; [apply undamped_straight | intros; lra].
  - pose proof (sqrt_lt_R0 D H) as Hr; pose proof (undamped_circular (sqrt D) ltac:(lra)) as U.
    rewrite sqrt_sqrt in U by lra; eexists _, _; split; [exact U | lra].
Qed.
Lemma flow_exists c k : exists S V, flow c k S V.
Proof.
  destruct (undamped_exists (k - c * c / 4)) as (o & w & H & _).
  exists (damped_S c o), (damped_V c o w); pose proof (damped c _ o w H) as F.
  replace (c * c / 4 + (k - c * c / 4)) with k in F by ring; exact F.
Qed.
