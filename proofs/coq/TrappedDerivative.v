(** * The matrices by which displacements change are derivatives of what an impact does

    Let k be the gap after the impact and tau times that before it, of either motion as if it were free. The
    difference of the two k is a free motion, and it is known at the contact of the second. *)
From Coq Require Import Reals ZArith Lra.
From Grazing Require Import Derivatives Finite StatementOscillator.
From Grazing Require Import StatementTrapped TrappedFlow.
Open Scope R_scope.

Lemma v_flow M : 0 < a M < b M -> forall x v, free (a M + b M) (a M * b M) x v -> forall s t,
  v t = phi21 M (t - s) * x s + phi22 M (t - s) * v s.
Proof.
  intros Hab x v F s t; pose proof (zet_flow M x v F s t) as Z; rewrite <- (Rplus_minus (a M * x t) (v t)).
  replace (a M * x t + (v t - a M * x t)) with (zet M x v t - a M * x t) by (unfold zet; ring).
  rewrite Z, (x_flow M Hab x v F s t); unfold phi11, phi12, phi21, phi22, phi12, zet; field; lra.
Qed.

Section Near.
Variables (M : machine) (lo hi t V : R) (x v X U : R -> R).
Hypothesis H : hump M lo hi.
Hypothesis T : through M t x v X U.
Hypothesis HV : V = v t - Q1 M t.
Hypothesis NV : V < 0.
Let Hab := overdamped _ _ _ H.
Notation J := (jump M t V).
Let g s := x s - Q M s.
Let k s := (X s - Q M s) + tau M * (x s - Q M s).
Let k1 s := (U s - Q1 M s) + tau M * (v s - Q1 M s).
Lemma small_o f l : derivable_pt_lim f t l -> forall e, 0 < e -> exists r, 0 < r /\ forall s, Rabs (s - t) <= r ->
  Rabs (f s - f t - l * (s - t)) <= e * Rabs (s - t).
Proof.
  intros D e He; destruct (D e He) as ([r Hr] & K); cbn in K; exists (r / 2); split; [lra|]; intros s Hs.
  destruct (Req_dec (s - t) 0) as [Z|N]; [replace s with t by lra; rewrite !Rminus_eq_0, Rmult_0_r, Rminus_0_r,
    Rabs_R0; lra|]. specialize (K (s - t) N ltac:(lra)); replace (t + (s - t)) with s in K by ring.
  replace (f s - f t - l * (s - t)) with (((f s - f t) / (s - t) - l) * (s - t)) by (field; exact N); rewrite
    Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos|lra].
Qed.
(** The matrix of a short flight, to and fro, is nearly 1. *)
Lemma near_1 e : 0 < e -> exists r, 0 < r /\ forall h, Rabs h <= r -> Rabs (phi11 M h - 1) <= e /\ Rabs (phi12 M h)
  <= e /\ Rabs (phi21 M h) <= e /\ Rabs (phi22 M h - 1) <= e.
Proof.
  intros He; assert (E : forall c, derivable_pt_lim (fun T => exp (- c * T)) 0 (- c * exp (- c * 0))) by (intros c;
    eapply D_value; [apply (D_exp (fun T => - c * T)), D_scale, D_id|ring]).
  assert (All : forall f, continuity_pt f 0 -> exists r, 0 < r /\ forall h, Rabs h <= r -> Rabs (f h - f 0) <= e).
  { intros f C; destruct (continuous_near f 0 e C He) as (r & Hr & K); exists r; split; [exact Hr|]; intros h Hh;
      apply K; rewrite Rminus_0_r; exact Hh. } assert (C : forall p q, continuity_pt (fun h => (p * exp (- a M * h) -
  q * exp (- b M * h)) * / (b M - a M)) 0).
  { intros p q; eapply D_continuous, (D_times (fun h => p * exp (- a M * h) - q * exp (- b M * h)) (fun _ => _));
      [apply D_minus; apply D_scale, E|apply D_const]. } destruct (All _ (C (b M) (a M))) as (r1 & R1 & K1), (All _ (C
  1 1)) as (r2 & R2 & K2), (All _ (C (- (a M * b M)) (- (a M
    * b M)))) as (r3 & R3 & K3), (All _ (C (- a M) (- b M))) as (r4 & R4 & K4); destruct (two_least r1 r2 R1 R2) as
      (r5 & R5 & ? & ?), (two_least r3 r4 R3 R4) as (r6 & R6 & ? & ?), (two_least r5 r6 R5 R6) as (r & Hr & ? & ?);
    exists r; split; [exact Hr|]; intros h Hh; specialize (K1 h ltac:(lra)); specialize (K2 h ltac:(lra)); specialize
    (K3 h ltac:(lra)); specialize (K4 h ltac:(lra)). rewrite !Rmult_0_r, exp_0 in *.
  replace (phi11 M h - 1) with ((b M * exp (- a M * h) - a M * exp (- b M * h)) * / (b M - a M) - (b M * 1 - a M * 1)
    * / (b M - a M)) by (unfold phi11; field; lra). replace (phi12 M h) with ((1 * exp (- a M * h) - 1 * exp (- b M *
    h))
      * / (b M - a M) - (1 * 1 - 1 * 1) * / (b M - a M)) by (unfold phi12; field; lra).
  replace (phi21 M h) with ((- (a M * b M) * exp (- a M * h) - - (a M * b M) * exp (- b M * h)) * / (b M - a M) - (-
    (a M
    * b M) * 1 - - (a M * b M) * 1) * / (b M - a M)) by (unfold phi21, phi12; field; lra).
  replace (phi22 M h - 1) with ((- a M * exp (- a M * h) - - b M * exp (- b M * h)) * / (b M - a M) - (- a M * 1 - - b
    M * 1) * / (b M - a M)) by (unfold phi22; field; lra). auto.
Qed.
Theorem impact_derivative eps : 0 < eps -> exists r, 0 < r /\ forall t1 y u Y W, through M t1 y u Y W ->
  Rabs (t1 - t) <= r -> let d := y t - x t in let w := u t - v t in Rabs (Y t - X t - - tau M * d) <= eps * (Rabs d +
  Rabs w) /\ Rabs (W t - U t - (- tau M * w + J * d / V)) <= eps * (Rabs d + Rabs w).
Proof.
  intros He; destruct T as (Fx & FX & xt & Xt & Ut). set (j := Rabs J); set (c := 4 / - V); set (C := (j + 3) * c + j
    / - V
    * (c + 1)). assert (j0 : 0 <= j) by apply Rabs_pos; assert (i0 : 0 < / - V) by (apply Rinv_0_lt_compat; lra).
  assert (c0 : 0 < c) by (apply Rmult_lt_0_compat; lra). assert (C0 : 0 < C).
  { assert (0 < (j + 3) * c) by (apply Rmult_lt_0_compat; lra); assert (0 <= j / - V * (c + 1)) by (apply
      Rmult_le_pos; [apply Rmult_le_pos|]; lra); unfold C; lra. } assert (Eta : exists e, 0 < e /\ e <= 1 /\ e <= - V
  / 2 /\ C * e <= eps).
  { destruct (two_least 1 (- V / 2) ltac:(lra) ltac:(lra)) as (e1 & p1 & l1 & l2); assert (q1 : 0 < eps / C) by (apply
      Rdiv_lt_0_compat; lra). destruct (two_least e1 (eps / C) p1 q1) as (e & p & l3 & l4); exists e; repeat (split;
      [lra|]). apply (Rmult_le_compat_l C) in l4; [|lra]; replace (C * (eps / C)) with eps in l4 by (field; lra); lra.
        } destruct Eta as (e & e0 & e1 & eV & eC).
  assert (Dg : derivable_pt_lim g t V) by (rewrite HV; apply D_minus; [apply Fx|apply (slope _ _ _ H)]).
  assert (Dk : derivable_pt_lim k t 0).
  { eapply D_value; [apply D_plus; [apply D_minus; [apply FX|apply (slope _ _ _ H)]|apply D_scale, D_minus; [apply
      Fx|apply (slope _ _ _ H)]]|rewrite Ut; ring]. } assert (Dk1 : derivable_pt_lim k1 t J).
  { eapply D_value; [apply D_plus; [apply D_minus; [apply FX|apply (bend _ _ _ H)]|apply D_scale, D_minus; [apply
      Fx|apply (bend _ _ _ H)]]|unfold jump, acc; rewrite Ut, xt, Xt; replace (v t) with (Q1 M t + V) by lra; ring]. }
  destruct (small_o g V Dg e e0) as (r1 & R1 & G1), (small_o k 0 Dk e e0) as (r2 & R2 & G2), (small_o k1 J Dk1 e e0)
    as (r3 & R3 & G3), (near_1 e e0) as (r4 & R4 & G4); destruct (two_least r1 r2 R1 R2) as (r5 & R5 & ? & ?),
    (two_least r3 r4 R3 R4) as (r6 & R6 & ? & ?), (two_least r5 r6 R5 R6) as (r & Hr & ? & ?). exists r; split; [exact
    Hr|]; intros t1 y u Y W (Fy & FY & yt & Yt & Wt) Ht d w; set (h := t1 - t) in *.
  specialize (G1 t1 ltac:(fold h; lra)); specialize (G2 t1 ltac:(fold h; lra)); specialize (G3 t1 ltac:(fold h; lra));
    fold h in G1, G2, G3. replace (g t) with 0 in G1 by (unfold g; lra); replace (k t) with 0 in G2 by (unfold k;
    rewrite xt, Xt; ring). replace (k1 t) with 0 in G3 by (unfold k1; rewrite Ut; ring).
  destruct (G4 h ltac:(lra)) as (A1 & A2 & _); destruct (G4 (- h) ltac:(rewrite Rabs_Ropp; lra)) as (B1 & B2 & B3 &
    B4).
  set (n := Rabs d + Rabs w); pose proof (Rabs_pos d) as d0; pose proof (Rabs_pos w) as w0; pose proof (Rabs_pos h) as
    h0.
  assert (Prod : forall p q P Q0, Rabs p <= P -> Rabs q <= Q0 -> Rabs (p * q) <= P * Q0) by (intros; rewrite
    Rabs_mult; apply Rmult_le_compat; trivial; apply Rabs_pos).
  (** When the second hits. *)
  assert (Hit : Rabs (V * h + d) <= e * (Rabs h + n)).
  { assert (Eg : g t1 + phi11 M h * d + phi12 M h * w = 0).
    { unfold g, d, w; rewrite <- yt, (x_flow M Hab x v Fx t t1), (x_flow M Hab y u Fy t t1); fold h; ring. } pose
    proof (Prod _ _ _ _ A1 (Rle_refl (Rabs d))) as P1; pose proof (Prod _ _ _ _ A2 (Rle_refl (Rabs w))) as P2; replace
      (V * h + d) with (- (g t1 - 0 - V * h) - (phi11 M h - 1) * d - phi12 M h * w) by lra; apply le_abs in G1, P1,
      P2; apply Rabs_le; unfold n; lra. } assert (Hn : Rabs h <= c * n).
  { assert (L : - V * Rabs h <= e * (Rabs h + n) + Rabs d).
    { replace (- V * Rabs h) with (Rabs (V * h)) by (rewrite Rabs_mult, (Rabs_left V) by lra; ring). replace (V * h)
        with ((V * h + d) + - d) by ring; eapply Rle_trans; [apply Rabs_triang|rewrite Rabs_Ropp; lra]. } assert (e *
    Rabs h <= - V / 2 * Rabs h) by (apply Rmult_le_compat_r; lra); assert (e * n <= 1 * n) by (apply
      Rmult_le_compat_r; unfold n; lra). apply (Rmult_le_reg_l (- V / 2)); [lra|]; replace (- V / 2 * (c * n)) with (2
        * n) by (unfold c; field; lra); unfold n in *; lra. }
  (** The difference of the two k, at t1 and at t. *)
  assert (K : Rabs (k t1) <= e * Rabs h) by (replace (k t1) with (k t1 - 0 - 0 * h) by ring; exact G2).
  assert (K1 : Rabs (k1 t1) <= (j + 1) * Rabs h).
  { replace (k1 t1) with ((k1 t1 - 0 - J * h) + J * h) by ring; eapply Rle_trans; [apply Rabs_triang|]; rewrite
      (Rabs_mult J); fold j; assert (e * Rabs h <= 1 * Rabs h) by (apply Rmult_le_compat_r; lra); lra. } assert (P : Y
  t - X t - - tau M * d = - (phi11 M (- h) * k t1 + phi12 M (- h) * k1 t1)).
  { unfold d, k, k1; rewrite (x_flow M Hab x v Fx t1 t), (x_flow M Hab y u Fy t1 t), (x_flow M Hab X U FX t1 t),
      (x_flow M Hab Y W FY t1 t), yt, Yt, Wt; replace (t - t1) with (- h) by (unfold h; ring); ring. } assert (P' : W
  t - U t + tau M * w = - (phi21 M (- h) * k t1 + phi22 M (- h) * k1 t1)).
  { unfold w, k, k1; rewrite (v_flow M Hab x v Fx t1 t), (v_flow M Hab y u Fy t1 t), (v_flow M Hab X U FX t1 t),
      (v_flow M Hab Y W FY t1 t), yt, Yt, Wt; replace (t - t1) with (- h) by (unfold h; ring); ring. } assert (n0 : 0
  <= n) by (unfold n; lra); assert (hj : (j + 3) * (e * Rabs h) <= (j + 3) * (e * (c * n))) by (apply
    Rmult_le_compat_l; [lra|apply Rmult_le_compat_l; lra]). assert (ee : e * (e * Rabs h) <= 1 * (e * Rabs h)) by
      (apply Rmult_le_compat_r; [apply Rmult_le_pos; lra|lra]). assert (Ce : C * e * n <= eps * n) by (apply
    Rmult_le_compat_r; lra). assert (Hj : j / - V * (Rabs (V * h + d)) <= j / - V * (e * (c * n + n))).
  { apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|]; apply Rle_trans with (1 := Hit); apply Rmult_le_compat_l;
      lra. } assert (Jp : 0 <= j / - V * (e * (c * n + n))) by (eapply Rle_trans; [|exact Hj]; apply Rmult_le_pos;
  [apply Rmult_le_pos; lra|apply Rabs_pos]). split.
  - rewrite P; pose proof (Prod _ _ _ _ B1 K) as Q1; pose proof (Prod _ _ _ _ B2 K1) as Q2; replace (- (phi11 M (- h)
      * k t1
      + phi12 M (- h) * k1 t1)) with (- k t1 - (phi11 M (- h) - 1) * k t1 - phi12 M (- h) * k1 t1) by ring.
    apply le_abs in K, Q1, Q2; apply Rabs_le; unfold C in Ce; lra.
  - replace (W t - U t - (- tau M * w + J * d / V)) with (- (phi21 M (- h) * k t1) - (phi22 M (- h) - 1) * k1 t1 - (k1
      t1 - 0
      - J * h) - J / V * (V * h + d)) by (replace (W t - U t) with (W t - U t + tau M * w - tau M * w) by ring;
          rewrite P'; field; lra). pose proof (Prod _ _ _ _ B3 K) as Q1; pose proof (Prod _ _ _ _ B4 K1) as Q2; assert
      (Q3 : Rabs (J / V * (V * h + d)) <= j / - V * (e * (c * n + n))).
    { rewrite Rabs_mult; replace (Rabs (J / V)) with (j / - V); [exact Hj|]; unfold Rdiv; rewrite Rabs_mult; fold j;
        f_equal; rewrite Rabs_left by (apply Rinv_lt_0_compat, NV); field; lra. } apply le_abs in G3, Q1, Q2, Q3;
    apply Rabs_le; unfold C in Ce; lra.
Qed.
End Near.

Theorem Derivative : Derivative_statement.
Proof. intros M lo hi t V x v X U H T HV NV eps; apply (impact_derivative M lo hi t V x v X U H T HV NV). Qed.
