(** * (vi): as mu -> 0 the least stretch tends to l / (2 (1 - l)), l = exp (- a p) *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require ChaosFunctions.
From Grazing Require Import Derivatives Finite Sine StatementTrapped TrappedFlow TrappedRange TrappedPaper.
Open Scope R_scope.

(** ** Limits at 0 from above *)
Definition tends (f : R -> R) (l : R) : Prop := forall eps, 0 < eps -> exists d, 0 < d /\
  forall t, 0 < t <= d -> Rabs (f t - l) <= eps.
Lemma tends_const c : tends (fun _ => c) c.
Proof. intros eps He; exists 1; split; [lra|]; intros; rewrite Rminus_eq_0, Rabs_R0; lra. Qed.
Lemma tends_id : tends (fun t => t) 0.
Proof. intros eps He; exists eps; split; [lra|]; intros t Ht; rewrite Rminus_0_r, Rabs_pos_eq; lra. Qed.
Lemma tends_of g f l : continuity_pt g l -> tends f l -> tends (fun t => g (f t)) (g l).
Proof.
  intros C H eps He; destruct (continuous_near g l eps C He) as (a & Ha & K); destruct (H a Ha) as (d & Hd & F).
  exists d; split; [exact Hd|]; intros t Ht; apply K, F, Ht.
Qed.
Lemma tends_plus f g l m : tends f l -> tends g m -> tends (fun t => f t + g t) (l + m).
Proof.
  intros F G eps He; destruct (F (eps / 2) ltac:(lra)) as (a & Ha & F1); destruct (G (eps / 2) ltac:(lra)) as (c & Hc
    & G1). destruct (two_least a c Ha Hc) as (d & Hd & d1 & d2); exists d; split; [exact Hd|]; intros t Ht.
  specialize (F1 t ltac:(lra)); specialize (G1 t ltac:(lra)); replace (f t + g t - (l + m)) with ((f t - l) + (g t -
    m)) by ring. eapply Rle_trans; [apply Rabs_triang|lra].
Qed.
Lemma tends_scale c f l : tends f l -> tends (fun t => c * f t) (c * l).
Proof. apply (tends_of (fun x => c * x)), (D_continuous _ (c * 1)), D_scale, D_id. Qed.
Lemma tends_ext f g l m : tends f l -> (forall t, f t = g t) -> l = m -> tends g m.
Proof. intros H E <- eps He; destruct (H eps He) as (d & Hd & F); exists d; split; [exact Hd|]; intros t Ht;
  rewrite <- E; auto. Qed.
Lemma tends_minus f g l m : tends f l -> tends g m -> tends (fun t => f t - g t) (l - m).
Proof. intros F G; eapply tends_ext; [apply tends_plus; [exact F|apply (tends_scale (-1)), G]| |]; intros; cbv beta;
  ring. Qed.
Lemma tends_times f g l m : tends f l -> tends g m -> tends (fun t => f t * g t) (l * m).
Proof.
  assert (S : forall f l, tends f l -> tends (fun t => f t * f t) (l * l)).
  { intros f0 l0; apply (tends_of (fun x => x * x)), (D_continuous _ (1 * l0 + l0 * 1)), (D_times (fun y => y) (fun y
      => y)); apply D_id. }
  intros F G; pose proof (tends_scale (/ 4) _ _ (tends_minus _ _ _ _ (S _ _ (tends_plus _ _ _ _ F G)) (S _ _
    (tends_minus _ _ _ _ F G)))) as H; cbv beta in H. eapply tends_ext; [exact H| |]; intros; cbv beta; field.
Qed.
Lemma tends_over f g l m : m <> 0 -> tends f l -> tends g m -> tends (fun t => f t / g t) (l / m).
Proof.
  intros Hm F G; apply tends_times; [exact F|]; apply (tends_of Rinv); [|exact G]. apply (continuity_pt_inv (fun x =>
    x)); [apply (D_continuous _ 1), D_id|exact Hm].
Qed.
Lemma tends_div c f l : c <> 0 -> tends f l -> tends (fun t => f t / c) (l / c).
Proof. intros Hc F; apply (tends_over f (fun _ => c) l c Hc F), tends_const. Qed.
Lemma tends_exp f l : tends f l -> tends (fun t => exp (f t)) (exp l).
Proof. apply (tends_of exp), (D_continuous _ (exp l)), derivable_pt_lim_exp. Qed.
Lemma tends_sqrt f l : 0 <= l -> tends f l -> tends (fun t => sqrt (f t)) (sqrt l).
Proof. intros Hl; apply (tends_of sqrt), continuity_pt_sqrt, Hl. Qed.
Lemma tends_pow2 f l : tends f l -> tends (fun t => f t ^ 2) (l ^ 2).
Proof. intros F; eapply tends_ext; [apply tends_times; exact F| |]; intros; cbv beta; ring. Qed.
Lemma tends_min f g l : tends f l -> tends g l -> tends (fun t => Rmin (f t) (g t)) l.
Proof.
  intros F G eps He; destruct (F eps He) as (a & Ha & F1); destruct (G eps He) as (c & Hc & G1).
  destruct (two_least a c Ha Hc) as (d & Hd & d1 & d2); exists d; split; [exact Hd|]; intros t Ht.
  unfold Rmin; destruct Rle_dec; [apply F1|apply G1]; lra.
Qed.
Lemma tends_max f g l m : m <= l -> tends f l -> tends g m -> tends (fun t => Rmax (f t) (g t)) l.
Proof.
  intros L F G eps He; destruct (F eps He) as (a & Ha & F1); destruct (G eps He) as (c & Hc & G1).
  destruct (two_least a c Ha Hc) as (d & Hd & d1 & d2); exists d; split; [exact Hd|]; intros t Ht.
  specialize (F1 t ltac:(lra)); specialize (G1 t ltac:(lra)); apply le_abs in F1, G1. unfold Rmax;
    destruct Rle_dec; apply Rabs_le; lra.
Qed.
Lemma tends_above f l c : tends f l -> c < l -> exists d, 0 < d /\ forall t, 0 < t <= d -> c < f t.
Proof.
  intros F L; destruct (F ((l - c) / 2) ltac:(lra)) as (d & Hd & F1); exists d; split; [exact Hd|];
    intros t Ht. specialize (F1 t Ht); apply le_abs in F1; lra.
Qed.

(** ** The numbers at mu = t^2, for a stop of width at most 5 t *)
Section Small.
Variables x y tau E Z S : R.
Hypothesis Hxy : 0 < x < y.
Hypothesis Htau : 0 <= tau.
Notation p := (2 * PI).
Notation D := (y - x).
Let l := exp (- x * p).
Hypothesis HE : 1 < E.
Hypothesis HZ : D / (exp (D * p) - 1) < Z.
Hypothesis HS : 0 < S.
Hypothesis Hl : 2 * (1 - l) < S * S.
Hypothesis HSE : (1 / 2 + E) * (S * S) < 1.
Definition at_ (t : R) : machine := {| a := x; b := y; StatementTrapped.tau := tau; StatementTrapped.p := p; W := 5 * t;
  mu := t ^ 2; al0 := 1; al1 := 1 + t ^ 2; zm := Z * t ^ 2; Vm := S * t; Q := fun _ => 0; Q1 := fun _ => 0; Q2 := fun
  _ => 0 |}.
Lemma p_6 : 6 < p. Proof. pose proof PI2_3_2; lra. Qed.
Lemma l_1 : 0 < l < 1.
Proof.
  split; [apply exp_pos|unfold l; rewrite <- exp_0; apply exp_increasing]; pose proof p_6.
  assert (0 < x * p) by (apply Rmult_lt_0_compat; lra); lra.
Qed.
Ltac tend := repeat first [eassumption | apply tends_const | apply tends_id | apply tends_exp | apply tends_pow2 |
  apply tends_over | apply tends_times | apply tends_minus | apply tends_plus].

Lemma T_phi12 f T : tends f T -> tends (fun t => phi12 (at_ t) (f t)) (phi12 (at_ 0) T).
Proof. intros F; unfold phi12; cbn [a b at_]; tend; lra. Qed.
Lemma T_phi11 f T : tends f T -> tends (fun t => phi11 (at_ t) (f t)) (phi11 (at_ 0) T).
Proof. intros F; unfold phi11; cbn [a b at_]; tend; lra. Qed.
Lemma phi12_at n : 1 <= n -> 0 < phi12 (at_ 0) (p * n).
Proof.
  intros Hn; pose proof p_6; unfold phi12; cbn [a b at_]; apply Rdiv_lt_0_compat; [|lra].
  assert (p * 1 <= p * n) by (apply Rmult_le_compat_l; lra). assert (0 < D * (p * n)) by (apply Rmult_lt_0_compat;
    lra); apply Rlt_Rminus, exp_increasing; lra.
Qed.
Lemma T_ell n : tends (fun t => ell (at_ t) n) (phi12 (at_ 0) (p * n)).
Proof.
  unfold ell; cbn [StatementTrapped.p W at_]; apply tends_min; apply T_phi12.
  - eapply tends_ext; [apply tends_minus; [apply (tends_const (p * n))|apply (tends_scale 5),
      tends_id]|reflexivity|ring].
  - eapply tends_ext; [apply tends_plus; [apply (tends_const (p * n))|apply (tends_scale 5),
      tends_id]|reflexivity|ring].
Qed.
Definition z0 := D / (exp (D * p) - 1).
Lemma exp_D : 0 < exp (D * p) - 1.
Proof.
  pose proof p_6; assert (0 < D * p) by (apply Rmult_lt_0_compat; lra); pose proof (exp_increasing 0 (D * p)
    ltac:(lra)). rewrite exp_0 in *; lra.
Qed.
Lemma T_zh : tends (fun t => zh (at_ t)) z0.
Proof.
  pose proof exp_D; unfold zh, z0; cbn [a b StatementTrapped.p W at_]; apply tends_over;
    [lra|apply tends_const|]. apply tends_minus; [|apply tends_const]; apply tends_exp, tends_times;
    [apply tends_const|]. eapply tends_ext; [apply tends_minus; [apply (tends_const p)|apply (tends_scale 5),
    tends_id]|reflexivity|ring].
Qed.
Definition v0 := / ((1 + tau) * phi12 (at_ 0) (p * 1)).
Lemma T_V1h : tends (fun t => V1h (at_ t)) v0.
Proof.
  pose proof (phi12_at 1 ltac:(lra)); unfold V1h, v0; cbn [StatementTrapped.tau at_].
  assert (N : (1 + tau) * phi12 (at_ 0) (p * 1) <> 0) by (apply Rmult_integral_contrapositive_currified; lra).
  eapply tends_ext; [apply (tends_over (fun _ => 1) (fun t => (1 + tau) * ell (at_ t) 1) 1 _ N (tends_const 1)
    (tends_scale (1 + tau) _ _ (T_ell 1)))| |]; intros; cbv beta; unfold Rdiv; ring.
Qed.
Lemma T_mu : tends (fun t => t ^ 2) 0.
Proof. eapply tends_ext; [apply tends_pow2, tends_id|reflexivity|ring]. Qed.
Lemma T_zm : tends (fun t => zm (at_ t)) 0.
Proof. eapply tends_ext; [apply (tends_scale Z), T_mu|reflexivity|ring]. Qed.
Lemma T_root : tends (fun t => sqrt (t ^ 2)) 0.
Proof. eapply tends_ext; [apply (tends_sqrt (fun t => t ^ 2) 0); [lra|apply T_mu]|reflexivity|apply sqrt_0]. Qed.
Lemma T_alM : tends (fun t => alM (at_ t)) 1.
Proof.
  assert (Y : tends (fun t => zm (at_ t) / D) (0 / D)) by (apply tends_div; [lra|apply T_zm]).
  pose proof (tends_plus _ _ _ _ (tends_plus _ _ _ _ (tends_const 1) T_mu) (tends_scale (x ^ 2) _ _ (tends_plus _ _ _
    _ T_mu Y))) as H; eapply tends_ext; [exact H|reflexivity|field; lra].
Qed.
Lemma T_alb : tends (fun t => alb (at_ t)) 1.
Proof.
  assert (V : tends (fun t => V1 (at_ t)) (0 * v0)) by (apply tends_times; [apply T_mu|apply T_V1h]).
  pose proof (tends_exp _ _ (tends_scale y _ _ (tends_scale 5 _ _ tends_id))) as X. pose proof (tends_times _ _ _ _
    (tends_scale (y ^ 2) _ _ X) (tends_plus _ _ _ _ T_zm (tends_scale (1 + tau) _ _ V))) as N.
  pose proof (tends_minus _ _ _ _ (tends_const 1) (tends_div D _ _ ltac:(lra) N)) as H. eapply tends_ext;
    [exact H|reflexivity|field; lra].
Qed.
Lemma T_deeph : tends (fun t => deeph (at_ t)) (1 - l).
Proof.
  pose proof (tends_times _ _ _ _ (tends_scale (tau ^ 2) _ _ (tends_pow2 _ _ T_V1h)) T_mu) as N.
  pose proof (tends_over _ (fun t => 2 * alb (at_ t)) _ (2 * 1) ltac:(lra) N (tends_scale 2 _ _ T_alb)) as Q.
  pose proof (tends_plus _ _ _ _ (tends_const (1 - l)) (tends_scale l _ _ Q)) as H. eapply tends_ext;
    [exact H|reflexivity|field].
Qed.
Lemma T_vh : tends (fun t => vh (at_ t)) (sqrt (2 * (1 - l))).
Proof.
  pose proof l_1; unfold vh; apply tends_sqrt; [lra|]; eapply tends_ext; [apply tends_times;
    [apply (tends_scale 2), T_alM| apply T_deeph]|reflexivity|ring].
Qed.
Lemma T_Vm : tends (fun t => Vm (at_ t)) 0.
Proof. eapply tends_ext; [apply (tends_scale S), tends_id|reflexivity|ring]. Qed.
Lemma T_alo : tends (fun t => alo (at_ t)) 1.
Proof.
  pose proof (tends_scale (y ^ 2) _ _ (tends_plus _ _ _ _ T_zm (tends_scale (1 + tau) _ _ T_Vm))) as N.
  pose proof (tends_minus _ _ _ _ (tends_const 1) (tends_div D _ _ ltac:(lra) N)) as H. eapply tends_ext;
    [exact H|reflexivity|field; lra].
Qed.
Lemma T_sigma : tends (fun t => sigma (at_ t)) (1 + tau).
Proof.
  pose proof (tends_minus _ _ _ _ (tends_const 1) (tends_div D _ _ ltac:(lra) (tends_scale (y ^ 2) _ _ T_zm))) as N.
  pose proof (tends_plus _ _ _ _ (tends_scale tau _ _ N) T_alo) as H; eapply tends_ext;
    [exact H|reflexivity|field; lra].
Qed.
Lemma T_topped : tends (fun t => topped (at_ t) Z S) (S * S / 2).
Proof.
  pose proof (tends_plus _ _ _ _ (tends_const S) (tends_times _ _ _ _ T_root (tends_const Z))) as N; pose proof
    (tends_scale x _ _ T_root) as K. pose proof (tends_max _ _ _ _ (ltac:(lra) : x * 0 <= S + 0 * Z) N K) as Mx.
  pose proof (tends_div (2 * 1) _ _ ltac:(lra) (tends_pow2 _ _ Mx)) as H; eapply tends_ext; [exact
    H|reflexivity|field].
Qed.
(** E Vm < sigma l(n) and B_m's numerator beyond E times its denominator, for small t. *)
Lemma T_A n : 1 <= n -> exists d, 0 < d /\ forall t, 0 < t <= d -> 0 < sigma (at_ t) * ell (at_ t) n - E * Vm (at_ t).
Proof.
  intros Hn; apply (tends_above _ ((1 + tau) * phi12 (at_ 0) (p * n) - E * 0)).
  - apply tends_minus; [apply tends_times; [apply T_sigma|apply T_ell]|apply tends_scale, T_Vm].
  - pose proof (phi12_at n Hn); assert (0 < (1 + tau) * phi12 (at_ 0) (p * n)) by (apply Rmult_lt_0_compat; lra); lra.
Qed.
Lemma T_B n : phi11 (at_ 0) (p * n) < 1 - (1 / 2 + E) * (S * S) -> exists d, 0 < d /\ forall t, 0 < t <= d -> 0 <
  sigma (at_ t) * (1 - topped (at_ t) Z S - phi11 (at_ t) (p * n - 5 * t)) - E * (((1 + tau) * S + sqrt (t ^ 2) * Z) *
  S).
Proof.
  intros Hn; apply (tends_above _ ((1 + tau) * (1 - S * S / 2 - phi11 (at_ 0) (p * n)) - E * (((1 + tau) * S + 0 * Z)
    * S))).
  - apply tends_minus; [apply tends_times; [apply T_sigma|apply tends_minus; [apply tends_minus;
      [apply tends_const|apply T_topped]|apply T_phi11]]|apply tends_scale, tends_times; [apply tends_plus;
      [apply tends_const|apply tends_times; [apply T_root|apply tends_const]]|apply tends_const]]. eapply tends_ext;
      [apply tends_minus; [apply (tends_const (p * n))|apply (tends_scale 5), tends_id]|reflexivity|ring].
  - assert (0 < (1 + tau) * (1 - S * S / 2 - phi11 (at_ 0) (p * n) - E * (S * S))) by (apply Rmult_lt_0_compat; lra);
      lra.
Qed.
Lemma late : exists m, (1 <= m)%Z /\ phi11 (at_ 0) (p * IZR m) < 1 - (1 / 2 + E) * (S * S).
Proof.
  pose proof l_1 as [l0 l1]; set (q := 1 - (1 / 2 + E) * (S * S)). assert (Hq : 0 < q * D / y) by (apply
    Rdiv_lt_0_compat;
    [apply Rmult_lt_0_compat; unfold q; lra|lra]). destruct (pow_lt_1_zero l ltac:(rewrite Rabs_pos_eq;
    lra) (q * D / y) Hq) as (N & HN); specialize (HN (Datatypes.S N) ltac:(lia)). exists (Z.of_nat (Datatypes.S N));
      split; [lia|]; rewrite <- INR_IZR_INZ, Rabs_pos_eq in * by (apply pow_le; lra). assert (El : exp (- x * (p * INR
      (Datatypes.S N))) = l ^ Datatypes.S N).
  { unfold l; generalize (Datatypes.S N) as k; induction k as [|k IH]; [cbn; rewrite <- exp_0; f_equal; ring|].
    rewrite S_INR; cbn [pow]; rewrite <- IH, <- exp_plus; f_equal; ring. }
  unfold phi11; cbn [a b at_]; rewrite El; pose proof (exp_pos (- y * (p * INR (Datatypes.S N)))).
  apply Rmult_lt_reg_r with D; [lra|]; replace ((y * l ^ Datatypes.S N - x * exp (- y * (p * INR (Datatypes.S N)))) /
    D * D) with (y * l ^ Datatypes.S N - x * exp (- y * (p * INR (Datatypes.S N)))) by (field; lra). apply
    (Rmult_lt_compat_l y) in HN; [|lra]; replace (y * (q * D / y)) with (q * D) in HN by (field; lra). assert (0 < x *
    exp (- y * (p * INR (Datatypes.S N)))) by
    (apply Rmult_lt_0_compat; lra); lra.
Qed.

Lemma small_checked : exists m d, 0 < d /\ forall t, 0 < t <= d -> checked (at_ t) E m.
Proof.
  destruct late as (m & Hm & Hlate); exists m; destruct (T_B (IZR m) Hlate) as (d1 & d10 & B).
  destruct (common_bound (fun n d => (1 <= n)%nat -> forall t, 0 < t <= d -> 0 < sigma (at_ t) * ell (at_ t) (INR n)
    - E
    * Vm (at_ t)) (Z.to_nat m)) as (d2 & d20 & A).
  { intros k d d' H Hd' Hk t Ht; apply (H Hk); lra. }
  { intros k _; destruct (le_lt_dec 1 k) as [K|K]; [|exists 1; split; [lra|intros; lia]].
    destruct (T_A (INR k)) as (d & Hd & F); [apply (le_INR 1), K|exists d; split; [exact Hd|intros _; exact F]]. }
  destruct (tends_above _ _ 0 T_alb ltac:(lra)) as (d3 & d30 & Lb); destruct (tends_above _ _ 0 T_alo ltac:(lra)) as
    (d4 & d40 & Lo). destruct (tends_above _ _ 0 (tends_minus _ _ _ _ (tends_const Z) T_zh)) as (d8 & d80 & Lz);
      [unfold z0; lra|]. destruct (tends_above _ _ 0 (tends_minus _ _ _ _ (tends_const S) T_vh)) as (d9 & d90 & Lv).
  { assert (sqrt (2 * (1 - l)) < S); [|lra]; rewrite <- (sqrt_square S) by lra; pose proof l_1; apply sqrt_lt_1_alt;
      lra. } destruct (two_least d1 d2 d10 d20) as (d5 & d50 & ? & ?); destruct (two_least d3 d4 d30 d40) as (d6 & d60
    & ? & ?). destruct (two_least d5 d6 d50 d60) as (d7 & d70 & ? & ?); destruct (two_least d8 d9 d80 d90) as (d10' &
    d11 & ? & ?); destruct (two_least d10' 1 d11 ltac:(lra)) as (d12 & d13 & ? & ?); destruct (two_least d7 d12 d70
    d13) as (d & Hd & ? & ?). exists d; split; [exact Hd|]; intros t Ht; pose proof p_6; specialize (Lb t ltac:(lra));
    specialize (Lo t ltac:(lra)); specialize (Lz t ltac:(lra)); specialize (Lv t ltac:(lra)). assert (Z0 : 0 <= Z) by
    (assert (0 < D / (exp (D * p) - 1)) by (apply Rdiv_lt_0_compat; [lra|apply exp_D]); lra).
  assert (U : usable (at_ t) Z).
  { split; cbn [a b StatementTrapped.tau mu W StatementTrapped.p al0 al1 zm at_]; try lra; [apply pow_lt; lra|].
    pose proof (pow2_ge_0 t); lra. }
  assert (St : sqrt (mu (at_ t)) = t) by (cbn [mu at_]; apply sqrt_pow2; lra); assert (Ev : Vm (at_ t) = S * sqrt (mu
    (at_ t))) by (rewrite St; reflexivity). pose proof (Vm_0 (at_ t) Z U S HS Ev) as V0.
  constructor; trivial; try (cbn [W StatementTrapped.p al0 at_]; lra).
  - split; [exact Lb|]; rewrite (slip_hat (at_ t) Z U), (speed_hat (at_ t) Z U Lb), St; cbn [zm Vm mu at_]; rewrite
      (Rmult_comm Z), (Rmult_comm S); split; apply Rmult_le_compat_l; try lra; apply pow2_ge_0.
  - intros n Hn; left; assert (Hk : (1 <= Z.to_nat n < Z.to_nat m)%nat) by lia. specialize (A (Z.to_nat n) ltac:(lia)
      ltac:(lia) t ltac:(lra)); rewrite INR_IZR_INZ, Z2Nat.id in A by lia.
      unfold A_; apply Rmult_le_reg_r with (Vm (at_ t)); [exact V0|]. replace (sigma (at_ t) * ell (at_ t) (IZR n) /
      Vm (at_ t) * Vm (at_ t)) with (sigma (at_ t) * ell (at_ t) (IZR n)) by (field; lra). lra.
  - specialize (B t ltac:(lra)); rewrite (B_hat (at_ t) Z U S HS Ev); cbn [StatementTrapped.tau StatementTrapped.p W
      mu at_] in *. set (c := ((1 + tau) * S + sqrt (t ^ 2) * Z) * S) in *. assert (C0 : 0 < c).
    { assert (0 <= tau * S) by (apply Rmult_le_pos; lra); assert (0 <= sqrt (t ^ 2) * Z) by (apply Rmult_le_pos;
        [apply sqrt_pos|exact Z0]). apply Rmult_lt_0_compat; lra. } apply Rmult_le_reg_r with c; [exact C0|]; set (q
    := sigma (at_ t) * _) in *; replace (q / c * c) with q by (field;
      lra); lra.
Qed.
End Small.

(** The paper's stop is at most 5 sqrt mu wide: sin h/2 >= h / pi. *)
Lemma width_5 mu : 0 < mu -> 2 * acos (/ (1 + mu)) <= 5 * sqrt mu.
Proof.
  intros Hm; set (h := acos (/ (1 + mu))). assert (I : 0 < / (1 + mu) < 1) by (split;
    [apply Rinv_0_lt_compat; lra|rewrite <- Rinv_1 at 2; apply Rinv_lt_contravar; lra]).
  assert (C : cos h = / (1 + mu)) by (apply cos_acos; lra); destruct (acos_bound (/ (1 + mu))) as [b1 b2];
    fold h in b1, b2. destruct (Req_dec h 0) as [->|N]; [pose proof (sqrt_pos mu); lra|].
  assert (S : h / 2 * sin (PI / 2) <= PI / 2 * sin (h / 2)) by (apply sin_ratio; lra); rewrite sin_PI2 in S.
  assert (E : cos h = 1 - 2 * (sin (h / 2) * sin (h / 2))).
  { replace h with (2 * (h / 2)) at 1 by field; rewrite cos_2a_sin; ring. }
  assert (M : sin (h / 2) * sin (h / 2) <= mu / 2).
  { assert (1 - / (1 + mu) <= mu); [|lra]; assert (/ (1 + mu) * (1 + mu) = 1) by (field; lra).
    assert (/ (1 + mu) * mu <= 1 * mu) by (apply Rmult_le_compat_r; lra); lra. }
  set (r := sqrt mu); assert (Hr : 0 < r /\ r * r = mu) by (split; [apply sqrt_lt_R0; lra|apply sqrt_sqrt;
    lra]). apply Rnot_lt_le; intros F; pose proof PI_4; pose proof PI_RGT_0; assert (P : 5 * r / 2 < h) by lra.
  assert (Q : PI <= 16 / 5) by (pose proof ChaosFunctions.mem_pi as X; unfold ChaosFunctions.pi, ChaosFunctions.join,
    ChaosInterval.constant, ChaosInterval.mem, ChaosInterval.one in X; cbn in X; lra).
  assert (sin (h / 2) >= 5 * r / 2 / (16 / 5)); [|nra]. apply Rle_ge; apply (Rmult_le_reg_l (16 / 5)); [lra|].
  assert (0 < sin (h / 2)) by (apply sin_gt_0; lra); assert (PI * sin (h / 2) <= 16 / 5 * sin (h / 2)) by (apply
    Rmult_le_compat_r; lra); lra.
Qed.

Theorem Small : Small_statement.
Proof.
  intros d w tau E Hd Hw Ht l [HE HE']; set (x := a (paper d w tau 1 1 1)) in *; set (y := b (paper d w tau 1 1 1)).
  destruct (Paper d w tau 1 1 1 Hd Hw Ht ltac:(lra)) as (_ & _ & P); assert (Hxy : 0 < x < y) by apply P.
  assert (L1 : 0 < l < 1) by exact (l_1 x y Hxy). assert (Hl : 2 * E * (1 - l) < l).
  { apply (Rmult_lt_compat_r (2 * (1 - l))) in HE'; [|lra]. replace (l / (2 * (1 - l)) * (2 * (1 - l))) with l in HE'
      by (field; lra); lra. }
  set (Z := (y - x) / (exp ((y - x) * (2 * PI)) - 1) + 1); set (q := 2 * (1 - l) + (l - 2 * E * (1 - l)) / (1 + 2 *
    E)).
  assert (Hq : 2 * (1 - l) < q /\ (1 / 2 + E) * q < 1).
  { assert (0 < (l - 2 * E * (1 - l)) / (1 + 2 * E)) by (apply Rdiv_lt_0_compat; lra); split; [unfold q; lra|].
    replace ((1 / 2 + E) * q) with (1 - (l - 2 * E * (1 - l)) / 2) by (unfold q; field; lra); lra. } assert (Sq : sqrt
  q * sqrt q = q) by (apply sqrt_sqrt; lra); assert (S0 : 0 < sqrt q) by (apply sqrt_lt_R0; lra).
  destruct (small_checked x y tau E Z (sqrt q) Hxy Ht HE) as (m & t1 & Ht1 & Ch); [unfold Z; lra|exact S0|rewrite Sq;
    apply Hq|rewrite Sq; apply Hq|]. exists Z, (sqrt q), (t1 ^ 2); split; [apply pow_lt, Ht1|]. intros mu [m0 m1]; set
    (t := sqrt mu); assert (Ht0 : 0 < t <= t1).
  { split; [apply sqrt_lt_R0, m0|]; rewrite <- (sqrt_pow2 t1) by lra; apply sqrt_le_1_alt, m1. }
  assert (Et : t ^ 2 = mu) by (unfold t; rewrite <- Rsqr_pow2; apply Rsqr_sqrt; lra).
  apply (Range (at_ x y tau Z (sqrt q) t) E m); [apply Ch, Ht0|apply Paper; lra|]. constructor;
    cbn [a b StatementTrapped.tau StatementTrapped.p W StatementTrapped.mu al0 al1 at_ paper];
    try (split; reflexivity); try lra; [exact (width_5 mu m0)|]. exists Z, (sqrt q); cbn; change (t * (t * 1)) with (t
      ^ 2); rewrite Et; repeat split.
Qed.
