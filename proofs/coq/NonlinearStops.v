(** * Proof that an oscillator between two stops is, as seen from the one that is touched, one of [StatementNonlinear]
  *)
From Coq Require Import Reals ZArith Lra Lia FunctionalExtensionality.
From Grazing Require Import Defs Derivatives StatementNonlinear StatementUnstable StatementStops NonlinearSmooth
  NonlinearChain NonlinearTube.
Import Stops.
Open Scope R_scope.

Lemma sgn_abs s x : Rabs (sgn s * x) = Rabs x.
Proof. destruct s; cbn [sgn]; [f_equal; ring | replace (-1 * x) with (- x) by ring; apply Rabs_Ropp]. Qed.
Lemma there s x y : x + sgn s * (sgn s * (y - x)) = y. Proof. destruct s; cbn; ring. Qed.
Lemma here s x y : sgn s * (x + sgn s * y - x) = y. Proof. destruct s; cbn; ring. Qed.

Section Stops.
Variables (P : Stops.t) (s : sign).
Hypothesis HP : grazing_at P s.
Notation O := (measured P s).
Notation B r := (fun _ _ _ mu : R => Rabs mu <= r).
Notation C1_stop r z k := (C1 (B r) (fun t _ _ mu => Q P z k t mu) (fun t _ _ mu => Q P z (S k) t mu) (fun _ _ _ _ => 0)
  (fun _ _ _ _ => 0) (fun t _ _ mu => Q_mu P z k t mu)).
Lemma stop_D r z k t mu : C1_stop r z k -> Rabs mu <= r -> derivable_pt_lim (fun t => Q P z k t mu) t (Q P z (S k) t
  mu).
Proof. intros H Hm; apply (in_t _ _ _ _ _ _ H t 0 0 mu Hm). Qed.
Lemma stop_near r z k t e : C1_stop r z k -> 0 < r -> 0 < e -> exists d, 0 < d /\ d <= r /\ forall t' mu, Rabs (t' - t)
  <= d -> Rabs mu <= d -> Rabs (Q P z k t' mu - Q P z k t 0) <= e.
Proof.
  intros H Hr He; destruct (C1_continuous _ _ _ _ _ _ r t 0 0 0 H Hr ltac:(intros t' y' v' m' _ _ _ A; rewrite
    Rminus_0_r in A; exact A) e He) as (d & Hd & K). destruct (two_least d r Hd Hr) as (d' & Hd' & L1 & L2); exists d';
    split; [exact Hd' | split; [exact L2|]]; intros t' mu A1 A2; apply (K t' 0 0 mu); rewrite ?Rminus_0_r, ?Rabs_R0;
    lra.
Qed.
Lemma periodic : 0 < T P /\ (forall t, q0 P (t + T P) = q0 P t) /\ forall z k t mu, Q P z k (t + T P) mu = Q P z k t mu.
Proof. destruct (all_periodic P s HP) as [HT H]; split; [exact HT | split; [intros t; apply H | intros z k t mu; apply
  (H t); exact 0]]. Qed.
(** For all times. *)
Lemma stops_near e : 0 < e -> exists d, 0 < d /\ forall z k t mu, (k <= 1)%nat -> Rabs mu <= d ->
  Rabs (Q P z k t mu - Q P z k t 0) <= e.
Proof.
  intros He; destruct (C3_stops P s HP) as (r & Hr & HC), periodic as (HT & _ & HQ).
  assert (One : forall z k, (k <= 1)%nat -> exists d, 0 < d /\ forall t, 0 <= t <= T P -> forall mu, Rabs mu <= d ->
    Rabs (Q P z k t mu - Q P z k t 0) <= e).
  { intros z k Hk; apply (everywhere (fun t d => forall mu, Rabs mu <= d -> Rabs (Q P z k t mu - Q P z k t 0) <= e) (T
      P)); [lra | intros t d d' H Hd mu Hm; apply H; lra|]. intros t; destruct (stop_near r z k t (e / 2) (HC z k
      ltac:(lia)) Hr ltac:(lra)) as (d & Hd & _ & K); exists d; split; [exact Hd|]; intros x Hx mu Hm. pose proof (K x
      mu Hx Hm) as K1; pose proof (K x 0 Hx ltac:(rewrite Rabs_R0; lra)) as K2.
    apply le_abs in K1, K2; apply Rabs_le; lra. }
  destruct (One Plus 0%nat ltac:(lia)) as (d1 & D1 & N1), (One Plus 1%nat ltac:(lia)) as (d2 & D2 & N2), (One Minus
    0%nat ltac:(lia)) as (d3 & D3 & N3), (One Minus 1%nat ltac:(lia)) as (d4 & D4 & N4).
  destruct (two_least d1 d2 D1 D2) as (c1 & E1 & L1 & L2), (two_least d3 d4 D3 D4) as (c2 & E2 & L3 & L4), (two_least c1
    c2 E1 E2) as (d & Hd & L5 & L6); exists d; split; [exact Hd|]; intros z k t mu Hk Hm.
  destruct (in_one_period (T P) t HT) as (j & Hj); pose proof (whole (fun t => Q P z k t mu) (T P) ltac:(intros; apply
    HQ) j (t - T P * IZR j)) as W1; pose proof (whole (fun t => Q P z k t 0) (T P) ltac:(intros; apply HQ) j (t - T P *
    IZR j)) as W2.
  cbv beta in W1, W2; replace (t - T P * IZR j + T P * IZR j) with t in W1, W2 by ring; rewrite W1, W2.
  destruct z, k as [|[|k]]; try lia; [apply N1 | apply N2 | apply N3 | apply N4]; trivial; lra.
Qed.
Lemma orbit_near t e : 0 < e -> exists d, 0 < d /\ forall x, Rabs (x - t) <= d -> Rabs (q0 P x - q0 P t) <= e /\
  Rabs (u0 P x - u0 P t) <= e.
Proof.
  intros He; destruct (orbit_runs P s HP t) as [A A'], (continuous_near _ t e (D_continuous _ _ _ A) He) as (d1 & D1 &
    N1), (continuous_near _ t e (D_continuous _ _ _ A') He) as (d2 & D2 & N2), (two_least d1 d2 D1 D2) as (d & Hd & L1 &
    L2).
  exists d; split; [exact Hd|]; intros x Hx; split; [apply N1 | apply N2]; lra.
Qed.

Lemma measured_force : exists r, 0 < r /\ C1 (fun t y v mu => tube O r t y v /\ Rabs mu <= r) (Nonlinear.a O)
  (Nonlinear.a_t O) (Nonlinear.a_y O) (Nonlinear.a_v O) (Nonlinear.a_mu O).
Proof.
  destruct (C1_force P s HP) as (r1 & R1 & HF), (C3_stops P s HP) as (r2 & R2 & HC), (stops_near (r1 / 4) ltac:(lra)) as
    (d & Hd & N). destruct (two_least (r1 / 4) d ltac:(lra) Hd) as (r3 & R3 & L1 & L2), (two_least r3 (r2 / 2) R3
    ltac:(lra)) as (r & Hr & L3 & L4); exists r; split; [exact Hr|].
  set (D' := fun t y v mu => tube O r t y v /\ Rabs mu <= r).
  assert (In : forall t y v m, D' t y v m -> Rabs m < r2 /\ exists q, 0 < q /\ forall t' y' v' m', Rabs (t' - t) <= q ->
    Rabs (y' - (Q P s 0 t m + sgn s * y)) <= q -> Rabs (v' - (Q P s 1 t m + sgn s * v)) <= q -> Rabs (m' - m) <= q ->
    Rabs (y' - q0 P t') <= r1 /\ Rabs (v' - u0 P t') <= r1 /\ Rabs m' <= r1).
  { intros t y v m [[Ty Tv] Tm]; split; [lra|]; destruct (orbit_near t (r1 / 4) ltac:(lra)) as (e & He & K), (two_least
      e (r1 / 4) He ltac:(lra)) as (q & Hq & Q1 & Q2). exists q; split; [exact Hq|]; intros t' y' v' m' X1 X2 X3 X4.
    destruct (K t' ltac:(lra)) as [K1 K2]; pose proof (N s 0%nat t m ltac:(lia) ltac:(lra)) as N0; pose proof (N s 1%nat
      t m ltac:(lia) ltac:(lra)) as N1. cbn in Ty, Tv; unfold off, rel in Ty, Tv.
    replace (y - sgn s * (q0 P t - Q P s 0 t 0)) with (sgn s * (sgn s * y - (q0 P t - Q P s 0 t 0))) in Ty by (destruct
      s; cbn; ring). replace (v - sgn s * (u0 P t - Q P s 1 t 0)) with (sgn s * (sgn s * v - (u0 P t - Q P s 1 t 0))) in
      Tv by (destruct s; cbn; ring). rewrite sgn_abs in Ty, Tv.
    apply le_abs in X2, X3, K1, K2, N0, N1, Ty, Tv; apply from in X4; repeat split; [apply Rabs_le; lra | apply Rabs_le;
      lra | lra]. }
  pose proof (C1_less D' _ (sgn s) _ _ _ _ _ _ _ _ _ _ (C1_seen _ D' r2 (sgn s) _ _ _ _ _ _ _ _ _ _ _ HF (HC s 0%nat
    ltac:(lia)) (HC s 1%nat ltac:(lia)) In) (HC s 2%nat ltac:(lia)) (fun t y v m H => Rlt_le _ _ (proj1 (In t y v m
    H)))) as K.
  assert (E : forall g : R -> R -> R -> R -> R, (fun t y v m => sgn s * (g t y v m * sgn s - 0)) = g) by (intros g; do 4
    (apply functional_extensionality; intros); destruct s; cbn; ring).
  cbv beta in K; rewrite (E (seen (sgn s) _ _ (a_q P))), (E (seen (sgn s) _ _ (a_u P))) in K; exact K.
Qed.
Lemma measured_law : exists r f1 f2 f3 f4, 0 < r /\ f3 (tG P) 0 0 0 = - tau P /\
  C1 (fun t y v mu => Rabs (t - tG P) <= r /\ Rabs v <= r /\ Rabs mu <= r) (fun t y v mu => Nonlinear.rebound O mu t v)
  f1 f2 f3 f4.
Proof.
  destruct (C1_law P s HP) as (r1 & f1 & f2 & f3 & f4 & R1 & E3 & HF), (C3_stops P s HP) as (r2 & R2 & HC), (at_tG P s
    HP) as (_ & Eq & Eu). destruct (stop_near r2 s 1%nat (tG P) (r1 / 4) (HC s 1%nat ltac:(lia)) R2 ltac:(lra)) as (d &
    Hd & Ld & N). destruct (two_least (r1 / 4) d ltac:(lra) Hd) as (r3 & R3 & L1 & L2), (two_least r3 (r2 / 2) R3
    ltac:(lra)) as (r & Hr & L3 & L4). set (D' := fun t y v mu : R => Rabs (t - tG P) <= r /\ Rabs v <= r /\ Rabs mu <=
    r).
  assert (In : forall t y v m, D' t y v m -> Rabs m < r2 /\ exists q, 0 < q /\ forall t' y' v' m', Rabs (t' - t) <= q ->
    Rabs (y' - (Q P s 0 t m + sgn s * y)) <= q -> Rabs (v' - (Q P s 1 t m + sgn s * v)) <= q -> Rabs (m' - m) <= q ->
    Rabs (t' - tG P) <= r1 /\ Rabs (v' - u0 P (tG P)) <= r1 /\ Rabs m' <= r1).
  { intros t y v m (Tt & Tv & Tm); split; [lra|]; exists (r1 / 4); split; [lra|]; intros t' y' v' m' X1 _ X3 X4.
    pose proof (N t m ltac:(lra) ltac:(lra)) as N1; rewrite Eu; rewrite <- (sgn_abs s) in Tv; apply from in X4; apply
      le_abs in X1, X3, Tv, N1, Tt; repeat split; [apply Rabs_le; lra | apply Rabs_le; lra | lra]. }
  pose proof (C1_less D' _ (sgn s) _ _ _ _ _ _ _ _ _ _ (C1_seen _ D' r2 (sgn s) _ _ _ _ _ _ _ _ _ _ _ HF (HC s 0%nat
    ltac:(lia)) (HC s 1%nat ltac:(lia)) In) (HC s 1%nat ltac:(lia)) (fun t y v m H => Rlt_le _ _ (proj1 (In t y v m
    H)))) as K.
  eexists r, _, _, _, _; split; [exact Hr | split; [|exact K]]; unfold seen; rewrite !Rmult_0_r, !Rplus_0_r, <- Eq, <-
    Eu, E3.
  destruct s; cbn; ring.
Qed.
Theorem measured_grazes : grazing_orbit O.
Proof.
  destruct (all_periodic P s HP) as [HT Per], (C3_stops P s HP) as (r & Hr & HC), (at_tG P s HP) as (Ht & Eq & Eu).
  destruct (law_at P s HP) as (T0 & Z0 & Pos); constructor.
  - split; [exact HT|]; intros t; destruct (Per t) as (E1 & E2 & E3); cbn; unfold off, rel.
    assert (EQ : forall k mu, Q P s k (t + T P) mu = Q P s k t mu) by (intros k mu; apply (E3 s k 0 0 mu)). rewrite E1,
      E2, !EQ; split; [reflexivity | split; [reflexivity|]]; intros y v mu; rewrite !EQ.
    split; do 2 f_equal; [apply (E3 s 0%nat) | apply (E3 s 0%nat 0)].
  - intros t; destruct (orbit_runs P s HP t) as [A A']; assert (R0 : Rabs 0 <= r) by (rewrite Rabs_R0; lra); split; cbn;
      unfold off, rel. { apply D_scale, D_minus; [exact A | exact (stop_D r s 0 t 0 (HC s 0%nat ltac:(lia)) R0)]. }
    rewrite !there; apply D_scale, D_minus; [exact A' | exact (stop_D r s 1 t 0 (HC s 1%nat ltac:(lia)) R0)].
  - cbn; split; [exact Ht|]; unfold off; rewrite Eq; ring.
  - cbn; intros t Hin Ne; apply (else_between P s HP t s Hin); intros [E _]; exact (Ne E).
  - cbn; rewrite !Rmult_0_r, !Rplus_0_r, <- Eq, <- Eu; exact (a_G P s HP).
  - exact measured_force.
  - cbn; split; [exact T0 | split]; intros mu t; [rewrite Rmult_0_r, Rplus_0_r, Z0; unfold rel; ring|]; intros v Hv;
      apply Pos; unfold rel; rewrite here; exact Hv.
  - exact measured_law.
Qed.

(** The other stop is clear. *)
Lemma other_clear : exists m, 0 < m /\ forall t z, z <> s -> m <= off P z 0 t (q0 P t).
Proof.
  destruct periodic as (HT & Pq & PQ), (C3_stops P s HP) as (r & Hr & HC); set (z' := match s with Plus => Minus | Minus
    => Plus end). set (F t := off P z' 0 t (q0 P t)). assert (CF : forall t, 0 <= t <= T P -> continuity_pt F t).
  { intros t _; eapply D_continuous; apply D_scale, D_minus; [apply (orbit_runs P s HP)|]; apply (stop_D r z' 0 t 0 (HC
      z' 0%nat ltac:(lia))); rewrite Rabs_R0; lra. }
  destruct (continuity_ab_min F 0 (T P) ltac:(lra) CF) as (x & Mx & Hx); exists (F x); split.
  { apply (else_between P s HP x z' Hx); unfold z'; destruct s; intros [_ E]; discriminate. }
  intros t z Hz; replace z with z' by (unfold z'; destruct s, z; congruence).
  destruct (in_one_period (T P) t HT) as (j & Hj); apply Rle_trans with (1 := Mx _ Hj); right; unfold F, off.
  rewrite <- (whole (q0 P) (T P) Pq j (t - T P * IZR j)), <- (whole (fun t => Q P z' 0 t 0) (T P) (fun t => PQ z' 0%nat
    t 0) j (t - T P * IZR j)). replace (t - T P * IZR j + T P * IZR j) with t by ring; reflexivity.
Qed.
(** The motions. *)
Lemma same_legs : exists r, 0 < r /\ forall mu d N t i j, Rabs mu <= r -> d <= r ->
  (forall q u, flight P s mu d N t q u i j -> leg O mu d N t (fun i x => off P s mu x (q i x))
    (fun i x => rel P s mu x (u i x)) i j) /\ forall y v, leg O mu d N t y v i j ->
  flight P s mu d N t (fun i x => Q P s 0 x mu + sgn s * y i x) (fun i x => Q P s 1 x mu + sgn s * v i x) i j.
Proof.
  destruct (C3_stops P s HP) as (r1 & R1 & HC), other_clear as (m & Hm & Clear), (stops_near (m / 4) ltac:(lra)) as (d1
    & D1 & N1). destruct (two_least r1 d1 R1 D1) as (r2 & R2 & L1 & L2), (two_least r2 (m / 4) R2 ltac:(lra)) as (r & Hr
    & L3 & L4); exists r; split; [exact Hr|]; intros mu d N t i j Hmu Hd.
  assert (DQ : forall k x, (k <= 1)%nat -> derivable_pt_lim (fun x => Q P s k x mu) x (Q P s (S k) x mu)) by (intros k x
    Hk; apply (stop_D r1 s k x mu (HC s k ltac:(lia))); lra). split.
  - intros q u [A1 A2 A3 A4 A5 A6 A7 A8 A9]; constructor; cbn; trivial.
    + intros x Hx; destruct (A3 x Hx) as [B1 B2]; split; cbn; unfold off, rel.
      * apply D_scale, D_minus; [exact B1 | apply (DQ 0%nat); lia].
      * rewrite !there; apply D_scale, D_minus; [exact B2 | apply (DQ 1%nat); lia].
    + unfold off; rewrite A5; ring.
    + unfold off; rewrite A6; ring.
    + intros x Hx; specialize (A7 x Hx); unfold off; destruct s; cbn; lra.
    + rewrite A9; unfold rel; rewrite there; reflexivity.
  - intros y v [A1 A2 A3 A4 A5 A6 A7 A8 A9]; constructor; cbn in *; trivial.
    + intros x Hx; destruct (A3 x Hx) as [B1 B2]; split.
      * eapply D_value; [apply D_plus; [apply (DQ 0%nat); lia | apply D_scale, B1] | reflexivity].
      * eapply D_value; [apply D_plus; [apply (DQ 1%nat); lia | apply D_scale, B2] | cbn; destruct s; cbn; ring].
    + intros x Hx; destruct (A4 x Hx) as [B1 B2]; cbn in B1, B2; unfold off, rel in *; rewrite !here; split; assumption.
    + rewrite A5; ring.
    + rewrite A6; ring.
    + intros x Hx; specialize (A7 x Hx); destruct (A4 x ltac:(lra)) as [B1 _]; cbn in B1; unfold off in B1.
      pose proof (N1 Plus 0%nat x mu ltac:(lia) ltac:(lra)) as N2; pose proof (N1 Minus 0%nat x mu ltac:(lia)
        ltac:(lra)) as N3; apply le_abs in B1, N2, N3. pose proof (Clear x Plus) as K1; pose proof (Clear x Minus) as
        K2; unfold off in K1, K2.
      destruct s; cbn in *; [specialize (K2 ltac:(discriminate)) | specialize (K1 ltac:(discriminate))]; lra.
    + unfold rel; rewrite here; exact A8.
    + unfold rel in A9; rewrite A9, there; reflexivity.
Qed.
(** The velocity of the stop is Lipschitz in time. *)
Lemma stop_Lipschitz : exists r, 0 < r /\ forall mu, Rabs mu <= r -> exists B, 0 <= B /\ forall t t',
  Rabs (Q P s 1 t' mu - Q P s 1 t mu) <= B * Rabs (t' - t).
Proof.
  destruct (C3_stops P s HP) as (r & Hr & HC), periodic as (HT & _ & HQ); exists r; split; [exact Hr|]; intros mu Hmu.
  assert (D : forall k t, (k <= 2)%nat -> derivable_pt_lim (fun t => Q P s k t mu) t (Q P s (S k) t mu)) by (intros k t
    Hk; exact (stop_D r s k t mu (HC s k Hk) Hmu)).
  destruct (periodic_bounded (fun t => Q P s 2 t mu) (T P) HT) as (B & HB & H); [intros t; exact (D_continuous _ _ _ (D
    2%nat t ltac:(lia))) | intros t; apply HQ|]. exists B; split; [exact HB|]; intros t t'.
  apply (mvt (fun t => Q P s 1 t mu) (fun t => Q P s 2 t mu)); [intros x; apply D; lia | intros x _; apply H].
Qed.
(** What leaves a motion of O leaves that of P. *)
Lemma unstable_between : exists r, 0 < r /\ forall mu d N t u, Rabs mu <= r -> d <= r ->
  unstable_motion (leg O mu d N) t (fun i x => rel P s mu x (u i x)) -> unstable_motion (flight P s mu d N) t u.
Proof.
  destruct same_legs as (r1 & R1 & HL), stop_Lipschitz as (r2 & R2 & HQ), (two_least r1 r2 R1 R2) as (r & Hr & L1 & L2).
  exists r; split; [exact Hr|]; intros mu d N t u Hmu Hd (r0 & Hr0 & H); destruct (HQ mu ltac:(lra)) as (B & HB & Lip).
  assert (Weigh : forall e a b, Rabs a <= e / (1 + B) -> Rabs b <= e / (1 + B) -> Rabs a <= e /\ B * Rabs a + Rabs b <=
    e).
  { intros e a b Ha Hb; pose proof (Rmult_le_compat_l B _ _ HB Ha) as C; pose proof (Rabs_pos a).
    assert (E : e / (1 + B) + B * (e / (1 + B)) = e) by (field; lra); assert (0 <= B * (e / (1 + B))) by (apply
      Rmult_le_pos; lra); lra. }
  exists (r0 / (1 + B)); split; [apply Rdiv_lt_0_compat; lra|]; intros j eps He.
  destruct (H j (eps / (1 + B)) ltac:(apply Rdiv_lt_0_compat; lra)) as (l & t' & y' & v' & Hl & Lg & [N1 N2] & Out).
  exists l, t', (fun i x => Q P s 0 x mu + sgn s * y' i x), (fun i x => Q P s 1 x mu + sgn s * v' i x).
  split; [exact Hl|]; split; [intros i Hi; apply (HL mu d N t' i (i + 1)%Z ltac:(lra) ltac:(lra)), Lg, Hi|]; split.
  - destruct (Weigh eps _ _ N1 N2) as [W1 W2]; split; [exact W1|]; pose proof (Lip (t j) (t' j)) as Q1.
    replace (Q P s 1 (t' j) mu + sgn s * v' j (t' j) - u j (t j)) with ((Q P s 1 (t' j) mu - Q P s 1 (t j) mu) + sgn s *
      (v' j (t' j) - rel P s mu (t j) (u j (t j)))) by (rewrite <- (there s (Q P s 1 (t j) mu) (u j (t j))) at 2; unfold
      rel; ring). eapply Rle_trans; [apply Rabs_triang|]; rewrite sgn_abs; lra.
  - intros [F1 F2]; apply Out; destruct (Weigh r0 _ _ F1 F2) as [W1 W2]; split; [exact W1|]; pose proof (Lip (t l) (t'
    l)) as Q1. rewrite <- (sgn_abs s); replace (sgn s * (v' l (t' l) - rel P s mu (t l) (u l (t l)))) with ((Q P s 1 (t'
    l) mu + sgn s * v' l (t' l) - u l (t l)) - (Q P s 1 (t' l) mu - Q P s 1 (t l) mu)) by (rewrite <- (there s (Q P s 1
    (t l) mu) (u l (t l))) at 1; unfold rel; ring). eapply Rle_trans; [apply apart|]; lra.
Qed.
End Stops.

Theorem Two_stops : Stops_statement.
Proof.
  intros P s HP; split; [exact (measured_grazes P s HP)|]; destruct (same_legs P s HP) as (r1 & R1 & H),
    (unstable_between P s HP) as (r2 & R2 & U), (two_least r1 r2 R1 R2) as (r & Hr & L1 & L2); exists r; split; [exact
    Hr|]; intros mu d N Hmu Hd.
  assert (K1 : forall t q u, motion_between P s mu d N t q u -> nonlinear_motion (measured P s) mu d N t (fun i x => off
    P s mu x (q i x)) (fun i x => rel P s mu x (u i x))) by (intros t q u HM i j Hj; apply H; [lra | lra | exact (HM i j
    Hj)]).
  assert (K2 : forall t y v, nonlinear_motion (measured P s) mu d N t y v -> motion_between P s mu d N t (fun i x => Q P
    s 0 x mu + sgn s * y i x) (fun i x => Q P s 1 x mu + sgn s * v i x)) by (intros t y v HM i j Hj; apply H; [lra | lra
    | exact (HM i j Hj)]). split; [split | split; [split|]].
  - intros (t & q & u & HM & Only); exists t, (fun i x => off P s mu x (q i x)), (fun i x => rel P s mu x (u i x)).
    split; [apply K1, HM|]; intros t' y' v' HM' i; destruct (Only _ _ _ (K2 _ _ _ HM') i) as [E F]; split; [exact E|];
      intros x Hx; destruct (F x Hx) as [F1 F2].
    unfold off, rel; rewrite <- F1, <- F2, !here; auto.
  - intros (t & y & v & HM & Only); exists t, (fun i x => Q P s 0 x mu + sgn s * y i x), (fun i x => Q P s 1 x mu + sgn
      s * v i x). split; [apply K2, HM|]; intros t' q' u' HM' i; destruct (Only _ _ _ (K1 _ _ _ HM') i) as [E F]; split;
      [exact E|]; intros x Hx; destruct (F x Hx) as [F1 F2].
    rewrite <- F1, <- F2; unfold off, rel; rewrite !there; auto.
  - intros (t & q & u & HM); do 3 eexists; apply (K1 t q u HM).
  - intros (t & y & v & HM); do 3 eexists; apply (K2 t y v HM).
  - intros Un t q u HM; apply (U mu d N t u ltac:(lra) ltac:(lra)), (Un _ _ _ (K1 t q u HM)).
Qed.
