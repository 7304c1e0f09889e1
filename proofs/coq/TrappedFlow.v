(** The flow of the overdamped oscillator: zeta = a x + x' decays like exp (- b t), eta = b x + x' like exp (-
    a t). *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Derivatives StatementOscillator.
From Grazing Require Import StatementTrapped TrappedCalculus.
Open Scope R_scope.

Section Flow.
Variable M : machine.
Hypothesis Hab : 0 < a M < b M.
Notation a := (a M). Notation b := (b M). Notation D := (StatementTrapped.b M - StatementTrapped.a M).
Notation motion_free := (free (a + b) (a * b)).

Definition zet (x v : R -> R) (t : R) : R := a * x t + v t.
Definition eta (x v : R -> R) (t : R) : R := b * x t + v t.

Lemma decay (f : R -> R) c s t : (forall t, derivable_pt_lim f t (- c * f t)) -> f t = f s * exp (- c * (t -
  s)).
Proof.
  intros H; pose proof (constant_function (fun t => f t * exp (c * (t - s))) t s) as K; cbv beta in K. replace (c * (s
    - s)) with 0 in K by ring; rewrite exp_0, Rmult_1_r in K. rewrite <- K.
  - rewrite Rmult_assoc, <- exp_plus; replace (c * (t - s) + - c * (t - s)) with 0 by ring; rewrite exp_0; ring.
  - intros y; eapply D_value; [apply D_times; [apply H|apply (D_exp (fun t => c * (t - s))), D_scale, D_shift]|].
    cbv beta; ring.
Qed.

Section Of_motion.
Variables x v : R -> R.
Hypothesis F : motion_free x v.
Lemma D_x t : derivable_pt_lim x t (v t). Proof. apply F. Qed.
Lemma D_v t : derivable_pt_lim v t (- (a + b) * v t - a * b * x t). Proof. apply F. Qed.
Lemma zet_flow s t : zet x v t = zet x v s * exp (- b * (t - s)).
Proof.
  apply decay; intros y; eapply D_value; [apply (D_plus (fun t => a * x t) v); [apply D_scale, D_x|apply D_v]|].
  unfold zet; ring.
Qed.
Lemma eta_flow s t : eta x v t = eta x v s * exp (- a * (t - s)).
Proof.
  apply decay; intros y; eapply D_value; [apply (D_plus (fun t => b * x t) v); [apply D_scale, D_x|apply D_v]|].
  unfold eta; ring.
Qed.
Lemma x_of t : x t = (eta x v t - zet x v t) / D. Proof. unfold eta, zet; field; lra. Qed.
Lemma x_flow s t : x t = phi11 M (t - s) * x s + phi12 M (t - s) * v s.
Proof. rewrite (x_of t), (zet_flow s), (eta_flow s); unfold phi11, phi12, eta, zet; field; lra. Qed.
Lemma x_flow' s t : x t = exp (- a * (t - s)) * x s + phi12 M (t - s) * zet x v s.
Proof. rewrite (x_of t), (zet_flow s), (eta_flow s); unfold phi12, eta, zet; field; lra. Qed.
Lemma acc_of t : - (a + b) * v t - a * b * x t = a ^ 2 * eta x v t / D - b ^ 2 * zet x v t / D.
Proof. unfold eta, zet; field; lra. Qed.
Lemma eta_zet t : eta x v t = zet x v t + D * x t. Proof. unfold eta, zet; ring. Qed.
End Of_motion.

Lemma exp_down c s t : 0 <= c -> s <= t -> exp (- c * t) <= exp (- c * s).
Proof.
  intros Hc L; destruct (Req_dec (c * (t - s)) 0) as [E|E]; [right; f_equal; nra|]. left; apply exp_increasing; nra.
Qed.
Lemma phi12_pos T : 0 <= T -> 0 <= phi12 M T.
Proof.
  intros H; apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat; lra]. destruct (Req_dec T 0) as [->|N];
    [rewrite !Rmult_0_r; lra|]. assert (exp (- b * T) < exp (- a * T)); [apply exp_increasing; nra|lra].
Qed.
Lemma D_phi12 T : derivable_pt_lim (phi12 M) T (phi22 M T).
Proof.
  assert (E : forall c, derivable_pt_lim (fun T => exp (- c * T)) T (- c * exp (- c * T))).
  { intros c; eapply D_value; [apply (D_exp (fun T => - c * T)), D_scale, D_id|ring]. }
  apply (D_ext (fun T => / D * (exp (- a * T) - exp (- b * T))) _ _ (/ D * (- a * exp (- a * T) - - b * exp (- b *
    T)))); [|intros; unfold phi12; field; lra|unfold phi22; field; lra]. apply D_scale, D_minus; apply E.
Qed.
Lemma phi12_between A B T : A <= T <= B -> Rmin (phi12 M A) (phi12 M B) <= phi12 M T.
Proof.
  intros H; apply Rnot_lt_le; intros L. assert (LA : phi12 M T < phi12 M A) by (eapply Rlt_le_trans;
    [exact L|apply Rmin_l]). assert (LB : phi12 M T < phi12 M B) by (eapply Rlt_le_trans;
    [exact L|apply Rmin_r]). assert (NA : A <> T) by (intros ->; lra); assert (NB : T <> B) by (intros ->;
    lra). destruct (MVT_cor2 (phi12 M) (phi22 M) A T ltac:(lra) ltac:(intros; apply D_phi12)) as (y & Ey & Hy).
  destruct (MVT_cor2 (phi12 M) (phi22 M) T B ltac:(lra) ltac:(intros; apply D_phi12)) as (z & Ez & Hz).
  assert (Ny : phi22 M y < 0) by nra; assert (Pz : 0 < phi22 M z) by nra. assert (S : forall w, phi22 M w = exp (- a *
    w) * ((b * exp (- D * w) - a) / D)).
  { intros w; unfold phi22; replace (- b * w) with (- a * w + - D * w) by ring; rewrite exp_plus; field; lra.
    }
  assert (I : forall e c, 0 < e -> 0 < e * (c / D) -> 0 < c).
  { intros e c He Hc; apply Rmult_lt_reg_l with (e / D); [apply Rdiv_lt_0_compat; lra|].
    replace (e / D * c) with (e * (c / D)) by (field; lra); lra. }
  pose proof (exp_pos (- a * y)); pose proof (exp_pos (- a * z)); rewrite S in Ny, Pz. assert (H2 : 0 < b * exp (- D *
    z) - a) by (eapply I; [exact H1|exact Pz]). assert (H3 : 0 < - (b * exp (- D * y) - a)).
  { eapply I; [exact H0|]; replace (exp (- a * y) * (- (b * exp (- D * y) - a) / D)) with (- (exp (- a * y) * ((b *
      exp (- D * y) - a) / D))) by (field; lra); lra. }
  pose proof (exp_down D y z ltac:(lra) ltac:(lra)); nra.
Qed.
Lemma phi11_down S T : 0 <= S <= T -> phi11 M T <= phi11 M S /\ 0 < phi11 M T.
Proof.
  intros H; split.
  - assert (E : forall c U, derivable_pt_lim (fun T => exp (- c * T)) U (- c * exp (- c * U))).
    { intros c U; eapply D_value; [apply (D_exp (fun T => - c * T)), D_scale, D_id|ring]. }
    destruct (Req_dec S T) as [->|N]; [lra|]. destruct (MVT_cor2 (phi11 M) (phi21 M) S T) as (y & Ey & Hy); [lra| |].
    + intros U _; apply (D_ext (fun T => / D * (b * exp (- a * T) - a * exp (- b * T))) _ _ (/ D * (b * (- a * exp (-
        a * U)) - a * (- b * exp (- b * U))))); [|intros; unfold phi11; field; lra|unfold phi21, phi12; field;
        lra]. apply D_scale, D_minus; apply D_scale, E.
    + pose proof (phi12_pos y ltac:(lra)); unfold phi21 in Ey. assert (0 <= a * b * (phi12 M y * (T - S))) by (apply
        Rmult_le_pos; [|apply Rmult_le_pos; lra]; apply Rmult_le_pos; lra); lra.
  - pose proof (phi12_pos T ltac:(lra)); pose proof (exp_pos (- a * T)). replace (phi11 M T) with (exp (- a * T) + a *
      phi12 M T) by (unfold phi11, phi12; field; lra). assert (0 <= a * phi12 M T) by (apply Rmult_le_pos; lra); lra.
Qed.
End Flow.
