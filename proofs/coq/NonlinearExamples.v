(** * Proof that the oscillators of [StatementNonlinearExamples] graze, that region 3 has all of them, and that those
      driven gently are near linear ones *)
From Coq Require Import Reals Lra Lia FunctionalExtensionality.
From Grazing Require Import Defs Derivatives Finite Algebra Headline Systems StatementOscillator StatementNonlinear
  StatementStops StatementNonlinearExamples OscillatorUses NonlinearChain NonlinearStops NonlinearGeneric
    NonlinearSmooth NonlinearTube.
Open Scope R_scope.

Section Driven.
Variables (M : nat -> R -> R) (W : sign -> nat -> R -> R) (t0 : R) (s : sign).
Hypothesis H : shapes M W t0 s.
Lemma D_M A n t : (n <= 2)%nat -> derivable_pt_lim (fun t => A * M n t) t (A * M (S n) t).
Proof. intros Hn; apply D_scale, (shape_slope _ _ _ _ H n t Hn). Qed.
Lemma continuous_shapes n t : (n <= 3)%nat -> continuity_pt (M n) t /\ forall z, continuity_pt (W z n) t.
Proof.
  intros Hn; destruct (Nat.eq_dec n 3) as [->|Ne]; [apply (shape_C3 _ _ _ _ H)|].
  destruct (shape_slope _ _ _ _ H n t ltac:(lia)) as [A B]; split; [|intros z]; eapply D_continuous; [exact A | apply
    B].
Qed.
Section One.
Variables (A c k b h e x tau : R).
Notation P := (driven M W t0 A c k b h e x tau).
Lemma C_shape D n : (n <= 3)%nat -> continuous D (fun t _ _ _ => A * M n t) /\ forall z, continuous D (fun t _ _ _ => A
  * W z n t).
Proof.
  intros Hn; split; [|intros z]; (apply (C_times D (fun _ _ _ _ => A)); [apply C_const | apply (C_t D (M n)) ||
    apply (C_t D (W z n)); intros t; apply (continuous_shapes n t Hn)]).
Qed.
Lemma driven_C1 D : C1 D (Stops.a P) (Stops.a_t P) (Stops.a_q P) (Stops.a_u P) (Stops.a_mu P).
Proof.
  assert (Cc : forall t, continuity_pt cos t) by (intros t; apply (D_continuous _ _ _ (derivable_pt_lim_cos t))).
  assert (Cm : forall t, continuity_pt (fun t => cos (A * M 0%nat t)) t) by (intros t; eapply D_continuous; apply D_cos,
    D_M; lia). constructor; cbn; [intros t y v m _ .. |].
  - derive_by ltac:(apply D_M; lia); ring.
  - derive_by fail; ring.
  - derive_by fail; ring.
  - derive_by fail; ring.
  - pose proof (fun n Hn => proj1 (C_shape D n Hn)) as Cs; repeat split; repeat first [apply C_const | apply (C_f _ cos
      Cc) | apply (C_t _ (fun t => cos (A * M 0%nat t)) Cm) | apply Cs; lia | apply C_y | apply C_minus | apply C_plus |
      apply C_times].
Qed.
Theorem driven_grazes : 0 < A -> 0 <= tau -> grazing_at P s.
Proof.
  intros HA Ht; destruct (shape_touch _ _ _ _ H) as (Hi & E0 & E1); pose proof PI_RGT_0 as HP; constructor.
  - split; [cbn; lra|]; intros t; pose proof (fun n => shape_period _ _ _ _ H n t) as Per; cbn; rewrite !(proj1 (Per
      _)); split; [reflexivity | split; [reflexivity|]]; intros z n q u mu; rewrite ?(proj1 (Per _)), !(proj2 (Per _));
        auto.
  - intros t; split; cbn; [apply D_M; lia|]; eapply D_value; [apply D_M; lia | cbn; ring].
  - cbn; rewrite E0, E1; auto.
  - intros t z Hin Ne; unfold off; cbn in *; replace (sgn z * (A * M 0%nat t - A * W z 0%nat t)) with (A * (sgn z * (M
      0%nat t - W z 0%nat t))) by ring; apply Rmult_lt_0_compat; [exact HA | apply (shape_open _ _ _ _ H); assumption].
  - cbn; match goal with |- 0 < ?u => replace u with (A * (sgn s * (M 2%nat t0 - W s 2%nat t0))) by ring end;
      apply Rmult_lt_0_compat; [exact HA | apply (shape_bend _ _ _ _ H)].
  - exists 1; split; [lra | apply driven_C1].
  - exists 1; split; [lra|]; intros z n Hn; constructor; cbn; [intros t q u mu _ .. | repeat split; try apply C_const;
      apply (C_shape _ (S n) ltac:(lia))]; try apply D_const. apply D_scale, (shape_slope _ _ _ _ H n t Hn).
  - cbn; split; [exact Ht | split; [intros; ring|]]; intros mu t u; unfold rel; cbn; set (v := sgn s * (u - A * W s
    1%nat t)). intros Hv; pose proof (exp_pos (x * v)); match goal with |- 0 <= ?r => replace r with (tau * (- v * exp
      (x * v))) by (unfold v; ring) end; apply Rmult_le_pos; [exact Ht | apply Rmult_le_pos; lra].
  - pose (v t u := sgn s * (u - A * W s 1%nat t)); pose (F3 := fun t u => - tau * ((1 + x * v t u) * exp (x * v t u))).
    exists 1, (fun t _ u _ => (A * W s 2%nat t) * (1 - F3 t u)), (fun _ _ _ _ => 0), (fun t _ u _ => F3 t u), (fun _ _ _
      _ => 0). split; [lra | split; [unfold F3, v; cbn; rewrite E1, Rminus_eq_0, !Rmult_0_r, exp_0; ring|]].
    assert (DW : forall t, derivable_pt_lim (fun t => A * W s 1%nat t) t (A * W s 2%nat t)) by (intros t; apply D_scale,
      (shape_slope _ _ _ _ H 1%nat t ltac:(lia))).
    set (D := fun t (_ : R) u mu => _); assert (Cw : forall n, (n <= 3)%nat -> continuous D (fun t _ _ _ => A * W s n
      t)) by (intros n Hn; apply (C_shape D n Hn)).
    assert (Cv : continuous D (fun t _ u _ => v t u)) by (apply (C_times D (fun _ _ _ _ => sgn s)); [apply C_const |
      apply (C_minus D (fun _ _ u _ => u)); [apply (C_v D (fun u => u)); intros u; apply (D_continuous _ _ _ (D_id u)) |
      apply Cw; lia]]).
    assert (CF : continuous D (fun t _ u _ => F3 t u)).
    { apply (C_times D (fun _ _ _ _ => - tau)); [apply C_const|]; apply (C_times D (fun t _ u _ => 1 + x * v t u)).
      - apply (C_plus D (fun _ _ _ _ => 1)); [apply C_const | apply (C_times D (fun _ _ _ _ => x)); [apply C_const |
        exact Cv]].
      - intros t y u mu HD eps He; destruct (continuous_near (fun r => exp (x * r)) (v t u) eps) as (d & Hd & K);
          [eapply D_continuous; apply D_exp, D_scale, D_id | exact He|]. destruct (Cv t y u mu HD d Hd) as (d' & Hd' &
          K'); exists d'; split; [exact Hd'|]; intros; apply K, (K' t' y' v' mu'); assumption. }
    constructor; cbn; [intros t q u mu _ .. |].
    + derive_by ltac:(apply DW); unfold F3, v; destruct s; cbn; ring.
    + apply D_const.
    + derive_by fail; unfold F3, v; destruct s; cbn; ring.
    + apply D_const.
    + split; [|split; [apply C_const | split; [exact CF | apply C_const]]]. apply (C_times D (fun t _ _ _ => A * W s
        2%nat t)); [apply Cw; lia | apply (C_minus D (fun _ _ _ _ => 1)); [apply C_const | exact CF]].
Qed.
(** Its linearized equation. *)
Lemma driven_along t : let O := measured P s in along O (Nonlinear.a_y O) t = - (k + 3 * b * (A * M 0%nat t * (A * M
  0%nat t)) + h * cos (A * M 0%nat t)) /\ along O (Nonlinear.a_v O) t = - c /\ along O (Nonlinear.a_mu O) t = sgn s.
Proof.
  unfold along, off; cbn; unfold off, rel; cbn; rewrite there; split; [ring | split; ring].
Qed.
End One.

Lemma driven_linear A c k e x tau a1 a2 gamma : matrix c k Plus a1 a2 gamma -> gamma <> 0 -> k <> 0 ->
  generic (measured (driven M W t0 A c k 0 0 e x tau) s) a1 a2 gamma (sgn s / k).
Proof.
  intros (A11 & A21 & A22 & E1 & E2 & HA) Hg Hk; pose proof (driven_along A c k 0 0 e x tau) as Al; cbv zeta in Al;
    constructor.
  - exists A11, A21, A22; split; [exact E1 | split; [rewrite (Rmult_comm A21); exact E2|]]; intros z w Hz.
    destruct (HA (fun t => z (t0 + t)) (fun t => w (t0 + t))) as [F1 F2].
    + intros t; destruct (Hz (t0 + t)) as [D1 D2], (Al (t0 + t)) as (K1 & K2 & K3); rewrite K1, K2, K3 in D2; split;
        [apply D_on, D1|]. eapply D_value; [apply D_on, D2 | ring].
    + cbn in *; rewrite !Rplus_0_r in F1, F2; lra.
  - exact Hg.
  - exists (fun _ => sgn s / k), (fun _ => 0); split; [|split; [intros; auto | reflexivity]]; intros t; split;
      [apply D_const|]. destruct (Al t) as (K1 & K2 & K3); rewrite K1, K2, K3; eapply D_value; [apply D_const | field;
        exact Hk].
  - apply Rmult_integral_contrapositive; split; [destruct s; cbn; lra | apply Rinv_neq_0_compat, Hk].
Qed.
End Driven.
(** The signs of (52), (53) are the same near (a1, a2). *)
Lemma orbit_open a1 a2 n i g : orbit a1 a2 n i g -> exists d, 0 < d /\ forall a1' a2', Rabs (a1' - a1) <= d ->
  Rabs (a2' - a2) <= d -> orbit a1' a2' n i g.
Proof.
  intros (Hu & Hb & Hc); set (D := fun _ _ _ _ : R => True); assert (Ct : continuous D (fun t _ _ _ => t)) by (apply
    (C_t D (fun t => t)); intros t; apply (D_continuous _ _ _ (D_id t))). pose proof (C_y D) as Cy; pose proof (C_const
      D) as Cc.
  assert (Cu : forall k, continuous D (fun t y _ _ => u t y k)).
  { assert (Two : forall k, continuous D (fun t y _ _ => u t y k) /\ continuous D (fun t y _ _ => u t y (S k))); [|apply
    Two]. induction k as [|k [A B]]; [exact (conj (Cc 0) (Cc 1)) | split; [exact B|]]; intros t y v m HD e He.
    destruct (C_minus D _ _ (C_times D _ _ Ct B) (C_times D _ _ Cy A) t y v m HD e He) as (d & Hd & N); exists d; split;
      [exact Hd|]; intros t' y' v' m' A1 A2 A3 A4; rewrite !u_SS; exact (N t' y' v' m' A1 A2 A3 A4). }
  assert (Cp : forall k, continuous D (fun _ y _ _ => y ^ k)) by (induction k as [|k IH]; [exact (Cc 1) | apply (C_times
    D (fun _ y _ _ => y)); assumption]).
  assert (Open : forall f, continuous D f -> 0 < f a1 a2 0 0 -> exists d, 0 < d /\ forall a1' a2', Rabs (a1' - a1) <= d
    -> Rabs (a2' - a2) <= d -> 0 < f a1' a2' 0 0).
  { intros f Cf Pf; destruct (Cf a1 a2 0 0 I (f a1 a2 0 0 / 2) ltac:(lra)) as (d & Hd & N); exists d; split; [exact
      Hd|]; intros a1' a2' A B; specialize (N a1' a2' 0 0 A B); rewrite Rminus_eq_0, Rabs_R0 in N; specialize (N
      ltac:(lra) ltac:(lra)); apply le_abs in N; lra. }
  (* the numerators, times u_n *)
  assert (Sign : forall q p w, w <> 0 -> (q * (p / w) > 0 <-> 0 < q * (p * w))).
  { intros q p w Hw; assert (0 < w * w) by (apply Rsqr_pos_lt in Hw; exact Hw); replace (q * (p * w)) with (q * (p / w)
      * (w * w)) by (field; exact Hw); split; intros P; [apply Rmult_lt_0_compat; assumption | apply Rmult_lt_reg_r with
        (w * w); lra]. }
  destruct (Open (fun t y _ _ => u t y n * u t y n)) as (d1 & D1 & N1); [apply C_times; apply Cu | apply Rsqr_pos_lt in
    Hu; exact Hu|].
  destruct (Open (fun t y _ _ => sgn i * sgn g * (- (1 - v t y n + y ^ n) * u t y n))) as (d2 & D2 & N2); [|apply Sign;
    assumption|].
  { apply (C_times D (fun _ _ _ _ => sgn i * sgn g)); [apply Cc|]; apply (C_times D (fun t y _ _ => - (1 - v t y n + y ^
      n))); [|apply Cu]. assert (Cv : continuous D (fun t y _ _ => v t y n)) by (apply (C_minus D (fun t y _ _ => 2 * u
      t y (S n))); [apply (C_times D (fun _ _ _ _ => 2)); [apply Cc | apply Cu] | apply (C_times D (fun t _ _ _ => t));
      [exact Ct | apply Cu]]).
    intros t y w m HD e He; destruct (C_plus D _ _ (C_minus D _ _ (Cc 1) Cv) (Cp n) t y w m HD e He) as (d & Hd & N);
      exists d; split; [exact Hd|]; intros t' y' v' m' A1 A2 A3 A4; specialize (N t' y' v' m' A1 A2 A3 A4); apply le_abs
        in N; apply Rabs_le; lra. }
  destruct (common_bound (fun k d => (1 <= k <= n - 1)%nat -> forall a1' a2', Rabs (a1' - a1) <= d -> Rabs (a2' - a2) <=
    d -> 0 < sgn i * ((u a1' a2' n - u a1' a2' k - a2' ^ k * u a1' a2' (n - k)) * u a1' a2' n)) n) as (d3 & D3 & N3).
  - intros k d d' H Hd Hk a1' a2' A B; apply H; lra || exact Hk.
  - intros k Hk; destruct (Nat.eq_dec k 0) as [->|K0]; [exists 1; split; [lra | intros [L _]; inversion L]|].
    destruct (Open (fun t y _ _ => sgn i * ((u t y n - u t y k - y ^ k * u t y (n - k)) * u t y n))) as (d & Hd & N).
    + repeat first [apply Cc | apply Cu | apply Cp | apply (C_times D (fun _ _ _ _ => sgn i)) | apply C_minus | apply
      C_times].
    + apply Sign; [exact Hu | apply Hb; lia].
    + exists d; split; [exact Hd | intros _; exact N].
  - destruct (two_least d1 d2 D1 D2) as (d4 & D4 & L1 & L2), (two_least d3 d4 D3 D4) as (d & Hd & L3 & L4); exists d;
      split; [exact Hd|]; intros a1' a2' A B. assert (Hu' : u a1' a2' n <> 0) by (intros Z; pose proof (N1 a1' a2'
      ltac:(lra) ltac:(lra)) as P; cbv beta in P; rewrite Z in P; lra).
    split; [exact Hu' | split]; [intros k Hk; apply Sign; [exact Hu' | apply N3; lia || lra] | apply Sign; [exact Hu' |
      apply N2; lra]].
Qed.

Theorem Driven : Driven_statement.
Proof.
  intros M W t0 s H; assert (Near : forall c k b h e x tau a1 a2 gamma eps, 0 <= tau -> matrix c (k + h) Plus a1 a2
    gamma -> gamma <> 0 -> k + h <> 0 -> a1 <> a2 + 1 -> 0 < eps -> exists A0, 0 < A0 /\ forall A, 0 < A <= A0 -> exists
    a1' a2' gamma' rate, generic (measured (driven M W t0 A c k b h e x tau) s) a1' a2' gamma' rate /\ Rabs (a1' - a1)
    <= eps /\ Rabs (a2' - a2) <= eps /\ Rabs (gamma' - gamma) <= eps /\ Rabs (rate - sgn s / (k + h)) <= eps).
  { intros c k b h e x tau a1 a2 gamma eps Ht HM Hg Hk H1 He; destruct (near_linear c (k + h) a1 a2 gamma eps HM Hg Hk
      H1 He) as (d & Hd & Near); pose proof PI_RGT_0 as HP.
    destruct (periodic_bounded (M 0%nat) (2 * PI) ltac:(lra) (fun t => proj1 (continuous_shapes M W t0 s H 0 t
      ltac:(lia))) (fun t => proj1 (shape_period _ _ _ _ H 0%nat t))) as (B & HB & Bd).
    pose proof (Rabs_pos b); pose proof (Rabs_pos h); set (S := 3 * Rabs b * (B * B) + Rabs h * B + 1).
    assert (P1 : 0 <= 3 * Rabs b * (B * B)) by (repeat apply Rmult_le_pos; lra); assert (P2 : 0 <= Rabs h * B)
      by (apply Rmult_le_pos; lra). assert (HS : 1 <= S) by (unfold S; lra).
    destruct (two_least 1 (d / S) ltac:(lra) ltac:(apply Rdiv_lt_0_compat; lra)) as (A0 & HA & L1 & L2); exists A0;
      split; [exact HA|]; intros A [A1 A2]; apply Near.
    - exact (measured_grazes _ s (driven_grazes M W t0 s H A c k b h e x tau A1 Ht)).
    - reflexivity.
    - destruct s; cbn; unfold Rabs; destruct Rcase_abs; lra.
    - intros t; destruct (driven_along M W t0 s A c k b h e x tau t) as (K1 & K2 & K3); cbv zeta in *; rewrite K1;
      split; [|split; assumption]. set (m := A * M 0%nat t); assert (Bm : Rabs m <= A * B) by (unfold m; apply product;
        [rewrite Rabs_pos_eq; lra | apply Bd]).
      assert (Cm : Rabs (cos m - 1) <= A * B).
      { pose proof (mvt cos (fun y => - sin y) m 0 1 derivable_pt_lim_cos) as K; rewrite cos_0, Rminus_0_r in K; eapply
          Rle_trans; [apply K; intros y _; rewrite Rabs_Ropp; pose proof (SIN_bound y); apply Rabs_le; lra | lra]. }
      pose proof (product _ _ _ _ (Rle_refl (Rabs h)) Cm) as Q1; pose proof (product _ _ _ _ Bm Bm) as Q2; pose proof
        (product _ _ _ _ (Rle_refl (Rabs (3 * b))) Q2) as Q3. rewrite (Rabs_mult 3), (Rabs_pos_eq 3) in Q3 by lra.
      assert (Q4 : 3 * Rabs b * (A * B * (A * B)) <= A * (3 * Rabs b * (B * B))).
      { replace (3 * Rabs b * (A * B * (A * B))) with (A * (A * (3 * Rabs b * (B * B)))) by ring; apply
          Rmult_le_compat_l; [lra|]; rewrite <- (Rmult_1_l (3 * Rabs b * (B * B))) at 2; apply Rmult_le_compat_r; lra. }
      assert (Q5 : A * S <= d) by (apply Rle_trans with (d / S * S); [apply Rmult_le_compat_r; lra | right; field;
        lra]).
      unfold S in Q5; apply le_abs in Q1, Q3; apply Rabs_le; lra. }
  constructor; [intros; apply driven_grazes; assumption | intros; apply driven_linear; assumption | | | exact Near].
  - intros A e x tau r y g Hr Hx; destruct (reach_3 Reach r y g Hr Hx) as (c & k & gamma & Hm & Hg); exists c, k, gamma.
    split; [exact Hg|]; apply driven_linear; [exact H | exact Hm | intros ->; lra | intros ->].
    (* with k = 0 constants are free motions, and 1 is an eigenvalue *)
    destruct Hm as (A11 & A21 & A22 & E1 & E2 & HA); destruct (HA (fun _ => 1) (fun _ => 0)) as [F1 F2].
    { intros t; split; [apply D_const | eapply D_value; [apply D_const | ring]]. }
    cbn in F1, F2; assert (A11 = 1) by lra; assert (A21 = 0) by lra; subst A11 A21. pose proof PI_RGT_0 as HP;
      assert (Sp : 0 < sin (2 * PI * y)) by (apply sin_gt_0; nra). pose proof (sin2_cos2 (2 * PI * y)) as Q;
      unfold Rsqr in Q; set (p := cos (2 * PI * y)) in *; set (q := sin (2 * PI * y)) in *.
    assert (E3 : A22 = r * r) by lra; assert (E4 : 2 * r * p = 1 + r * r) by lra;
      assert (P1 : 0 < r * r * (q * q)) by (apply Rmult_lt_0_compat; apply Rmult_lt_0_compat; assumption).
    assert (E5 : (2 * r * p) * (2 * r * p) = 4 * (r * r) - 4 * (r * r * (q * q))) by (replace (q * q) with (1 - p * p)
      by lra; ring). rewrite E4 in E5; pose proof (Rle_0_sqr (1 - r * r)) as U; unfold Rsqr in U; lra.
  - intros c k b h e x tau a1 a2 gamma n i g Ht HM Hk H1 Hn Ho Hg; destruct (orbit_open a1 a2 n i g Ho) as (d & Hd &
      Open); assert (G0 : gamma <> 0) by (intros Z; rewrite Z in Hg; lra); assert (Pg : 0 < Rabs gamma) by (apply
      Rabs_pos_lt, G0); assert (Pk : 0 < Rabs (k + h)) by (apply Rabs_pos_lt, Hk).
    destruct (two_least d (Rabs gamma / 2) Hd ltac:(lra)) as (e1 & E1 & L1 & L2), (two_least e1 (/ Rabs (k + h) / 2) E1
      ltac:(apply Rinv_0_lt_compat in Pk; lra)) as (eps & He & L3 & L4).
    destruct (Near c k b h e x tau a1 a2 gamma eps Ht HM G0 Hk H1 He) as (A0 & HA & K); exists A0; split; [exact HA|];
      intros A HA'. destruct (K A HA') as (a1' & a2' & gamma' & rate & HG & K1 & K2 & K3 & K4); exists rate; split.
    + set (q := k + h) in *; replace (rate * (sgn s * q)) with (1 + (rate - sgn s / q) * (sgn s * q)) by (destruct s;
        cbn [sgn]; field; exact Hk). assert (B : Rabs ((rate - sgn s / q) * (sgn s * q)) <= / 2); [|apply le_abs in B;
          lra].
      rewrite Rabs_mult, sgn_abs; apply Rle_trans with (/ Rabs q / 2 * Rabs q); [apply Rmult_le_compat_r; lra | right;
        field; lra].
    + assert (Ho' := Open a1' a2' ltac:(lra) ltac:(lra)); apply (Single (Moves (measured (driven M W t0 A c k b h e x
        tau) s) rate) a1' a2' gamma' n i g); trivial; [split; [apply measured_grazes, driven_grazes; tauto || assumption
          | exact HG] | apply Ho'|].
      apply le_abs in K3; destruct g; cbn [sgn] in *; unfold Rabs in *; destruct (Rcase_abs gamma); lra.
Qed.
