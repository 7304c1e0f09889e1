(** * An oscillator between two stops, told arc by arc and each arc as seen from a stop, is one of [StatementBouncing] *)
From Coq Require Import Reals ZArith Lra Lia FunctionalExtensionality.
From Grazing Require Import Defs Contraction Derivatives StatementNonlinear StatementUnstable StatementBouncing
  NonlinearSmooth NonlinearChain NonlinearArc NonlinearTube NonlinearStops NonlinearRound NonlinearBounces StatementRattling.
Import Rattling.
Open Scope R_scope.

Lemma C1_same D f f1 f2 f3 f4 g g1 g2 g3 g4 : C1 D f f1 f2 f3 f4 -> (forall t y v m, f t y v m = g t y v m /\ f1 t y v m
  = g1 t y v m /\ f2 t y v m = g2 t y v m /\ f3 t y v m = g3 t y v m /\ f4 t y v m = g4 t y v m) -> C1 D g g1 g2 g3 g4.
Proof.
  intros H E; replace g with f by (do 4 (apply functional_extensionality; intros); apply E); replace g1 with f1 by (do 4
    (apply functional_extensionality; intros); apply E); replace g2 with f2 by (do 4 (apply functional_extensionality;
    intros); apply E); replace g3 with f3 by (do 4 (apply functional_extensionality; intros); apply E); replace g4 with f4
    by (do 4 (apply functional_extensionality; intros); apply E); exact H.
Qed.
Lemma C1_sub (D D' : R -> R -> R -> R -> Prop) f f1 f2 f3 f4 : C1 D f f1 f2 f3 f4 -> (forall t y v m, D' t y v m -> D t y v m) -> C1 D' f f1 f2 f3 f4.
Proof.
  intros [A1 A2 A3 A4 (K1 & K2 & K3 & K4)] Sub; constructor; [auto | auto | auto | auto|]; repeat split; intros t y v m Hd;
    [apply K1 | apply K2 | apply K3 | apply K4]; auto.
Qed.

Section Rattling.
Variable P : Rattling.t.
Hypothesis HP : rattles P.
Notation O := (seen_from P). Notation kz := (Z.of_nat (k P)).
Notation C1_stop r z n := (C1 (fun _ _ _ mu => Rabs mu <= r) (fun t _ _ mu => Q P z n t mu) (fun t _ _ mu => Q P z (S n) t
  mu) (fun _ _ _ _ => 0) (fun _ _ _ _ => 0) (fun t _ _ mu => Q_mu P z n t mu)).
Lemma sgn_image z : sgn (image P z) = sgn (mirror P) * sgn z.
Proof. unfold image; destruct (mirror P), z; cbn; ring. Qed.
Lemma twice x : sgn (mirror P) * (sgn (mirror P) * x) = x. Proof. destruct (mirror P); cbn; ring. Qed.
Lemma Q_turned z n t mu : Q P (image P z) n (t + T P) mu = turned P (Q P z n t mu).
Proof. destruct (all_turned P HP) as (_ & _ & H); destruct (H 0%Z t) as (_ & _ & _ & _ & _ & E); apply (E z n 0 0 mu). Qed.
Lemma off_turned z mu t q : off P (image P z) mu (t + T P) (turned P q) = off P z mu t q.
Proof. unfold off; rewrite Q_turned, sgn_image; unfold turned; rewrite <- (twice (sgn z * (q - _))); ring. Qed.
Lemma rel_turned z mu t u : rel P (image P z) mu (t + T P) (turned P u) = rel P z mu t u.
Proof. unfold rel; rewrite Q_turned, sgn_image; unfold turned; rewrite <- (twice (sgn z * (u - _))); ring. Qed.
Lemma Q_twice z n t mu : Q P z n (t + 2 * T P) mu = Q P z n t mu.
Proof.
  replace z with (image P (image P z)) at 1 by (unfold image; destruct (mirror P), z; reflexivity); replace (t + 2 * T P)
    with (t + T P + T P) by ring; rewrite !Q_turned; apply twice.
Qed.
Lemma stop_D r z n t mu : C1_stop r z n -> Rabs mu <= r -> derivable_pt_lim (fun t => Q P z n t mu) t (Q P z (S n) t mu).
Proof. intros H Hm; apply (in_t _ _ _ _ _ _ H t 0 0 mu Hm). Qed.
Lemma stops_steady e : 0 < e -> exists d, 0 < d /\ forall z n t t' mu, (n <= 1)%nat -> Rabs (t' - t) <= d -> Rabs mu <= d
  -> Rabs (Q P z n t' mu - Q P z n t 0) <= e.
Proof.
  intros He; destruct (Q_C3 P HP) as (r & Hr & HC), (all_turned P HP) as (HT & _).
  assert (One : forall z n, (n <= 1)%nat -> exists d, 0 < d /\ forall t, 0 <= t <= 2 * T P -> forall t' mu, Rabs (t' - t)
    <= d -> Rabs mu <= d -> Rabs (Q P z n t' mu - Q P z n t 0) <= e).
  { intros z n Hn; apply (everywhere (fun t d => forall t' mu, Rabs (t' - t) <= d -> Rabs mu <= d -> Rabs (Q P z n t' mu -
      Q P z n t 0) <= e) (2 * T P)); [lra | intros t d d' H Hd t' mu H1 H2; apply H; lra|].
    intros t; destruct (C1_continuous _ _ _ _ _ _ r t 0 0 0 (HC z n ltac:(lia)) Hr ltac:(intros t' y' v' m' _ _ _ A;
      rewrite Rminus_0_r in A; exact A) (e / 2) ltac:(lra)) as (d & Hd & K); exists (d / 2); split; [lra|]; intros x Hx t'
      mu Ht Hm. pose proof (sum_apart _ _ _ _ _ Ht Hx) as Ht2; assert (Z : Rabs 0 <= d) by (rewrite Rabs_R0; lra).
    pose proof (K t' 0 0 mu ltac:(lra) ltac:(rewrite Rminus_0_r; exact Z) ltac:(rewrite Rminus_0_r; exact Z)
      ltac:(rewrite Rminus_0_r; lra)) as K1; pose proof (K x 0 0 0 ltac:(lra) ltac:(rewrite Rminus_0_r; exact Z)
      ltac:(rewrite Rminus_0_r; exact Z) ltac:(rewrite Rminus_0_r; exact Z)) as K2; apply le_abs in K1, K2; apply Rabs_le;
      lra. }
  destruct (One Plus 0%nat ltac:(lia)) as (d1 & D1 & N1), (One Plus 1%nat ltac:(lia)) as (d2 & D2 & N2), (One Minus
    0%nat ltac:(lia)) as (d3 & D3 & N3), (One Minus 1%nat ltac:(lia)) as (d4 & D4 & N4).
  destruct (two_least d1 d2 D1 D2) as (c1 & E1 & L1 & L2), (two_least d3 d4 D3 D4) as (c2 & E2 & L3 & L4), (two_least c1
    c2 E1 E2) as (d & Hd & L5 & L6); exists d; split; [exact Hd|]; intros z n t t' mu Hn Ht Hm.
  destruct (in_one_period (2 * T P) t ltac:(lra)) as (j & Hj); set (x := t - 2 * T P * IZR j) in *; set (x' := t' - 2 * T P
    * IZR j). assert (Hx : Rabs (x' - x) <= d) by (replace (x' - x) with (t' - t) by (unfold x, x'; ring); exact Ht).
  pose proof (whole (fun t => Q P z n t mu) (2 * T P) ltac:(intros; apply Q_twice) j x') as W1; pose proof (whole (fun t
    => Q P z n t 0) (2 * T P) ltac:(intros; apply Q_twice) j x) as W2; cbv beta in W1, W2.
  replace (x' + 2 * T P * IZR j) with t' in W1 by (unfold x'; ring); replace (x + 2 * T P * IZR j) with t in W2 by (unfold
    x; ring); rewrite W1, W2. destruct z, n as [|[|n]]; try lia; [apply N1 | apply N2 | apply N3 | apply N4]; trivial; lra.
Qed.
(** One number for all arcs. *)
Lemma all_arcs (R0 : Z -> R -> Prop) : (forall c d d', R0 c d -> 0 < d' <= d -> R0 c d') -> (forall c d, R0 c d <-> R0 (c +
  kz)%Z d) -> (forall c, exists d, 0 < d /\ R0 c d) -> exists d, 0 < d /\ forall c, R0 c d.
Proof.
  intros Down Turn H; destruct (all_turned P HP) as (_ & Hk & _); destruct (least (k P) Hk (fun m d => R0 (Z.of_nat m) d)
    (k P) (fun m => Down (Z.of_nat m)) (fun m _ => H (Z.of_nat m))) as (d & Hd & A); exists d; split; [exact Hd|].
  assert (Many : forall n c, R0 c d <-> R0 (c + kz * Z.of_nat n)%Z d).
  { intros n; induction n as [|n IH]; intros c; [cbn [Z.of_nat]; rewrite Z.mul_0_r, Z.add_0_r; reflexivity|]. rewrite (IH
      c), (Turn (c + kz * Z.of_nat n)%Z); replace (c + kz * Z.of_nat n + kz)%Z with (c + kz * Z.of_nat (S n))%Z by lia;
      reflexivity. }
  intros c; pose proof (Z.div_mod c kz ltac:(lia)) as E; pose proof (Z.mod_pos_bound c kz ltac:(lia)) as B; pose proof (A
    (Z.to_nat (c mod kz)) ltac:(lia)) as Q0; rewrite Z2Nat.id in Q0 by lia; destruct (Z_le_gt_dec 0 (c / kz)) as [L|L].
  - apply (Many (Z.to_nat (c / kz))) in Q0; rewrite Z2Nat.id in Q0 by exact L; replace c with (c mod kz + kz * (c / kz))%Z
      by lia; exact Q0.
  - apply (Many (Z.to_nat (- (c / kz)))); rewrite Z2Nat.id by lia; replace (c + kz * - (c / kz))%Z with (c mod kz)%Z by lia;
      exact Q0.
Qed.
Lemma orbit_near c t e r0 : 0 < e -> (forall t, s P c - r0 <= t <= s P (c + 1)%Z + r0 -> derivable_pt_lim (q0 P c) t (u0 P
  c t) /\ derivable_pt_lim (u0 P c) t (a P t (q0 P c t) (u0 P c t) 0)) -> s P c - r0 <= t <= s P (c + 1)%Z + r0 -> exists d,
  0 < d /\ forall x, Rabs (x - t) <= d -> Rabs (q0 P c x - q0 P c t) <= e /\ Rabs (u0 P c x - u0 P c t) <= e.
Proof.
  intros He H Ht; destruct (H t Ht) as [A A'], (continuous_near _ t e (D_continuous _ _ _ A) He) as (d1 & D1 & N1),
    (continuous_near _ t e (D_continuous _ _ _ A') He) as (d2 & D2 & N2), (two_least d1 d2 D1 D2) as (d & Hd & L1 & L2).
  exists d; split; [exact Hd|]; intros x Hx; split; [apply N1 | apply N2]; lra.
Qed.

Lemma seen_force : exists r, 0 < r /\ (forall c t, s P c - r <= t <= s P (c + 1)%Z + r -> StatementBouncing.runs O c 0
  (Bouncing.y0 O c) (Bouncing.v0 O c) t) /\ forall c, C1 (fun t y v mu => beside O r c t y v /\ Rabs mu <= r) (Bouncing.a
  O c) (Bouncing.a_t O c) (Bouncing.a_y O c) (Bouncing.a_v O c) (Bouncing.a_mu O c).
Proof.
  destruct (a_C1 P HP) as (r1 & R1 & HF), (Q_C3 P HP) as (r2 & R2 & HC), (arcs_run P HP) as (r3 & R3 & HR), (stops_steady
    (r1 / 4) ltac:(lra)) as (d & Hd & N).
  destruct (two_least (r1 / 4) d ltac:(lra) Hd) as (c1 & D1 & L1 & L2), (two_least c1 (r2 / 2) D1 ltac:(lra)) as (c2 & D2 &
    L3 & L4), (two_least c2 (r3 / 2) D2 ltac:(lra)) as (r & Hr & L5 & L6); exists r; split; [exact Hr|]; split.
  - intros c t Ht; destruct (HR c t ltac:(lra)) as [A A']; assert (Z : Rabs 0 <= r2) by (rewrite Rabs_R0; lra); split; cbn;
      unfold off, rel. { apply D_scale, D_minus; [exact A | exact (stop_D r2 _ 0 t 0 (HC _ 0%nat ltac:(lia)) Z)]. }
    rewrite !there; apply D_scale, D_minus; [exact A' | exact (stop_D r2 _ 1 t 0 (HC _ 1%nat ltac:(lia)) Z)].
  - intros c; set (z := stop P c); set (D' := fun t y v mu => beside O r c t y v /\ Rabs mu <= r).
    assert (In : forall t y v m, D' t y v m -> Rabs m < r2 /\ exists q, 0 < q /\ forall t' y' v' m', Rabs (t' - t) <= q ->
      Rabs (y' - (Q P z 0 t m + sgn z * y)) <= q -> Rabs (v' - (Q P z 1 t m + sgn z * v)) <= q -> Rabs (m' - m) <= q ->
      s P c - r1 <= t' <= s P (c + 1)%Z + r1 /\ Rabs (y' - q0 P c t') <= r1 /\ Rabs (v' - u0 P c t') <= r1 /\ Rabs m' <=
      r1).
    { intros t y v m [(Tt & Ty & Tv) Tm]; cbn in Tt; split; [lra|]; destruct (orbit_near c t (r1 / 4) r3 ltac:(lra) (HR c)
        ltac:(lra)) as (e & He & K), (two_least e (r1 / 4) He ltac:(lra)) as (q & Hq & Q1 & Q2).
      exists q; split; [exact Hq|]; intros t' y' v' m' X1 X2 X3 X4. assert (Ztt : Rabs (t - t) <= d) by (rewrite
        Rminus_eq_0, Rabs_R0; lra).
      destruct (K t' ltac:(lra)) as [K1 K2]; pose proof (N z 0%nat t t m ltac:(lia) Ztt ltac:(lra)) as N0; pose proof (N z
        1%nat t t m ltac:(lia) Ztt ltac:(lra)) as N1. cbn in Ty, Tv; fold z in Ty, Tv; unfold off, rel in Ty, Tv.
      replace (y - sgn z * (q0 P c t - Q P z 0 t 0)) with (sgn z * (sgn z * y - (q0 P c t - Q P z 0 t 0))) in Ty by
        (destruct z; cbn; ring). replace (v - sgn z * (u0 P c t - Q P z 1 t 0)) with (sgn z * (sgn z * v - (u0 P c t - Q P
        z 1 t 0))) in Tv by (destruct z; cbn; ring). rewrite sgn_abs in Ty, Tv.
      apply le_abs in X1, X2, X3, K1, K2, N0, N1, Ty, Tv; apply from in X4; repeat split; first [lra | apply Rabs_le; lra]. }
    pose proof (C1_less D' _ (sgn z) _ _ _ _ _ _ _ _ _ _ (C1_seen _ D' r2 (sgn z) _ _ _ _ _ _ _ _ _ _ _ (HF c) (HC z
      0%nat ltac:(lia)) (HC z 1%nat ltac:(lia)) In) (HC z 2%nat ltac:(lia)) (fun t y v m H => Rlt_le _ _ (proj1 (In t y v m
      H)))) as K. apply (C1_same _ _ _ _ _ _ _ _ _ _ _ K); intros t y v m; unfold seen; cbn; fold z; repeat split;
      destruct z; cbn; ring.
Qed.
(** A law of impact of stop z, near the time t1 and the velocity u1. *)
Lemma seen_law z f1 f2 f3 f4 r r2 t1 u1 d : (forall n, (n <= 2)%nat -> C1_stop r2 z n) -> 0 < r -> 0 < d <= r / 4 -> d <= r2
  / 2 -> 0 < r2 -> C1 (fun t _ u mu => Rabs (t - t1) <= r /\ Rabs (u - u1) <= r /\ Rabs mu <= r) (fun t _ u mu => U P z mu
  t u) f1 f2 f3 f4 -> (forall t mu, Rabs (t - t1) <= d -> Rabs mu <= d -> Rabs (Q P z 1 t mu - Q P z 1 t1 0) <= r / 4) ->
  let sn (f : R -> R -> R -> R -> R) t y v mu := f t (Q P z 0 t mu + sgn z * y) (Q P z 1 t mu + sgn z * v) mu in
  C1 (fun t _ v mu => Rabs (t - t1) <= d /\ Rabs (v - rel P z 0 t1 u1) <= d /\ Rabs mu <= d)
  (fun t _ v mu => rel P z mu t (U P z mu t (Q P z 1 t mu + sgn z * v)))
  (fun t y v mu => sgn z * (sn f1 t y v mu + sn f2 t y v mu * Q P z 1 t mu + sn f3 t y v mu * Q P z 2 t mu - Q P z 2 t mu))
  (sn f2) (sn f3) (fun t y v mu => sgn z * (sn f4 t y v mu + sn f2 t y v mu * Q_mu P z 0 t mu + sn f3 t y v mu * Q_mu P z 1
  t mu - Q_mu P z 1 t mu)).
Proof.
  intros HC Hr Hd Hd2 Hr2 HF N sn; set (D' := fun t y v mu : R => Rabs (t - t1) <= d /\ Rabs (v - rel P z 0 t1 u1) <= d /\
    Rabs mu <= d).
  assert (In : forall t y v m, D' t y v m -> Rabs m < r2 /\ exists q, 0 < q /\ forall t' y' v' m', Rabs (t' - t) <= q ->
    Rabs (y' - (Q P z 0 t m + sgn z * y)) <= q -> Rabs (v' - (Q P z 1 t m + sgn z * v)) <= q -> Rabs (m' - m) <= q ->
    Rabs (t' - t1) <= r /\ Rabs (v' - u1) <= r /\ Rabs m' <= r).
  { intros t y v m (Tt & Tv & Tm); split; [lra|]; exists (r / 4); split; [lra|]; intros t' y' v' m' X1 _ X3 X4.
    pose proof (N t m Tt Tm) as N1; unfold rel in Tv; replace (v - sgn z * (u1 - Q P z 1 t1 0)) with (sgn z * (sgn z * v -
      (u1 - Q P z 1 t1 0))) in Tv by (destruct z; cbn; ring). rewrite sgn_abs in Tv; apply from in X4; apply le_abs in X1,
      X3, Tv, N1, Tt; repeat split; [apply Rabs_le; lra | apply Rabs_le; lra | lra]. }
  pose proof (C1_less D' _ (sgn z) _ _ _ _ _ _ _ _ _ _ (C1_seen _ D' r2 (sgn z) _ _ _ _ _ _ _ _ _ _ _ HF (HC 0%nat
    ltac:(lia)) (HC 1%nat ltac:(lia)) In) (HC 1%nat ltac:(lia)) (fun t y v m H => Rlt_le _ _ (proj1 (In t y v m
    H)))) as K. apply (C1_same _ _ _ _ _ _ _ _ _ _ _ K); intros t y v m; unfold sn, seen, rel; repeat split; destruct z;
    cbn; ring.
Qed.
(** At a fixed time. *)
Lemma at_time r z n t : C1_stop r z n -> C1 (fun _ _ _ mu => Rabs mu <= r) (fun _ _ _ mu => Q P z n t mu) (fun _ _ _ _ =>
  0) (fun _ _ _ _ => 0) (fun _ _ _ _ => 0) (fun _ _ _ mu => Q_mu P z n t mu).
Proof.
  intros [_ _ _ A (_ & B & _ & C)]; constructor; try (intros; apply D_const).
  - intros _ _ _ mu Hm; apply (A t 0 0 mu Hm).
  - repeat split; try exact B. intros t' y v mu Hm e He; destruct (C t 0 0 mu Hm e He) as (d & Hd & K); exists d; split;
      [exact Hd|]; intros t2 y2 v2 m2 _ _ _ A4; apply (K t 0 0 m2); rewrite ?Rminus_eq_0, ?Rabs_R0; trivial; lra.
Qed.
Lemma next_stop c : impact P c = true -> stop P (c + 1)%Z = stop P c.
Proof. intros I; destruct (arcs_end P HP c) as (_ & _ & E); rewrite I in E; apply E. Qed.
(** The change of chart at the end of arc c, at any time t. *)
Lemma shifted c t mu q : sgn (stop P (c + 1)%Z) * (q - Q P (stop P (c + 1)%Z) 0 t mu) = sgn (stop P (c + 1)%Z) * (Q P (stop
  P c) 0 t mu - Q P (stop P (c + 1)%Z) 0 t mu) + sgn (stop P (c + 1)%Z) * sgn (stop P c) * off P (stop P c) mu t q.
Proof. unfold off; destruct (stop P c); cbn; ring. Qed.
Lemma shifted' c t mu u : sgn (stop P (c + 1)%Z) * (u - Q P (stop P (c + 1)%Z) 1 t mu) = sgn (stop P (c + 1)%Z) * (Q P (stop
  P c) 1 t mu - Q P (stop P (c + 1)%Z) 1 t mu) + sgn (stop P (c + 1)%Z) * sgn (stop P c) * rel P (stop P c) mu t u.
Proof. unfold rel; destruct (stop P c); cbn; ring. Qed.
Theorem seen_orbit : bouncing_orbit O.
Proof.
  destruct (all_turned P HP) as (HT & Hk & Per), (Q_C3 P HP) as (r2 & R2 & HC), (arc_touches P HP) as (Ht & Eq & Eu & Ga),
    (U_law P HP) as (T0 & Z0 & Pos); constructor.
  - split; [exact HT | split; [exact Hk|]]; intros c t; cbv zeta; change (Bouncing.k O) with (k P); destruct (Per c t) as
      (E1 & E2 & E3 & E4 & E5 & E6), (Per (c + 1)%Z t) as (F1 & F2 & _); set (c' := (c + kz)%Z) in *; replace (c + 1 +
      kz)%Z with (c' + 1)%Z in F1, F2 by (unfold c'; ring); cbn; rewrite E2, E4, E5, off_turned, rel_turned.
    split; [exact E1 | split; [reflexivity | split; [reflexivity | split; [exact E3 | split]]]].
    { rewrite F2, !sgn_image; destruct (mirror P); cbn; ring. }
    intros y v mu; set (z := stop P c); assert (In : forall n x, Q P (image P z) n (t + T P) mu + sgn (image P z) * x =
      turned P (Q P z n t mu + sgn z * x)) by (intros n x; rewrite Q_turned, sgn_image; unfold turned; ring).
    split; [|split; [|split]].
    + rewrite !In, (proj1 (E6 z 0%nat _ _ mu)), Q_turned, sgn_image; unfold turned; rewrite <- (twice (sgn z * (a P t _ _ mu
        - _))); ring.
    + rewrite In, (proj2 (proj2 (E6 z 0%nat 0 _ mu))); apply rel_turned.
    + rewrite F1, F2, !Q_turned, sgn_image; unfold turned; rewrite <- (twice (sgn (stop P (c + 1)%Z) * (_ - _))); ring.
    + rewrite F1, F2, !Q_turned, sgn_image; unfold turned; rewrite <- (twice (sgn (stop P (c + 1)%Z) * (_ - _))); ring.
  - intros c; cbv zeta; destruct (arcs_end P HP c) as (E1 & [E2 E3] & E4); split; [exact E1|]; unfold StatementBouncing.follows;
      cbn; destruct (impact P c) eqn:I.
    + destruct E4 as (E4 & E5 & E6); rewrite E2, E4, E3, E5; split; [split; [reflexivity|]; unfold rel; rewrite there;
        reflexivity|]. rewrite E3 in E6; auto.
    + rewrite E2, E3; split; [split; [apply shifted | apply shifted']|]; split; [exact E4|]. assert (Dec : stop P (c + 1)%Z = stop P c \/
        stop P (c + 1)%Z <> stop P c) by (destruct (stop P (c + 1)%Z), (stop P c); auto; right; discriminate); destruct Dec
        as [->|Ne]; [exact E4|]; apply (off_the_other P HP c); [lra | exact Ne].
  - cbn; rewrite !Rmult_0_r, !Rplus_0_r, <- Eq, <- Eu; split; [exact Ht | split; [unfold off; rewrite Eq; ring | exact Ga]].
  - intros c t Hc Ne; exact (off_its_stop P HP c t Hc Ne).
  - exact seen_force.
  - cbn; split; [exact T0 | split]; intros mu t; [rewrite Rmult_0_r, Rplus_0_r, Z0; unfold rel; ring|]; intros v Hv;
      apply Pos; unfold rel; rewrite NonlinearStops.here; exact Hv.
  - destruct (U_C1_touch P HP) as (r & f1 & f2 & f3 & f4 & Hr & E3 & HF), (stops_steady (r / 4) ltac:(lra)) as (d1 & D1 &
      N), (two_least (r / 4) d1 ltac:(lra) D1) as (d2 & D2 & L1 & L2), (two_least d2 (r2 / 2) D2 ltac:(lra)) as (d & Hd &
      L3 & L4).
    pose proof (seen_law (stop P 0%Z) f1 f2 f3 f4 r r2 (tG P) (u0 P 0%Z (tG P)) d (HC _) Hr ltac:(lra) L4 R2 HF (fun t mu A
      B => N _ 1%nat (tG P) t mu (le_n _) ltac:(lra) ltac:(lra))) as K; cbv zeta in K.
    assert (Z : rel P (stop P 0%Z) 0 (tG P) (u0 P 0%Z (tG P)) = 0) by (unfold rel; rewrite Eu; ring).
    eexists d, _, _, _, _; split; [exact Hd | split; [|refine (C1_sub _ _ _ _ _ _ _ K _)]].
    2: { cbv beta; intros t y v mu (A1 & A2 & A3); rewrite Z, Rminus_0_r; auto. }
    cbn; rewrite !Rmult_0_r, !Rplus_0_r, <- Eu, <- Eq; exact E3.
  - destruct (U_C1 P HP) as (r & Hr & HF), (stops_steady (r / 4) ltac:(lra)) as (d1 & D1 & N), (two_least (r / 4) d1
      ltac:(lra) D1) as (d2 & D2 & L1 & L2), (two_least d2 (r2 / 2) D2 ltac:(lra)) as (d & Hd & L3 & L4); exists d; split;
      [exact Hd|]; intros c; cbn; destruct (impact P c) eqn:I.
    + pose proof (seen_law (stop P c) _ _ _ _ r r2 (s P (c + 1)%Z) (u0 P c (s P (c + 1)%Z)) d (HC _) Hr ltac:(lra) L4 R2 (HF
        c I) (fun t mu A B => N (stop P c) 1%nat (s P (c + 1)%Z) t mu (le_n _) ltac:(lra) ltac:(lra))) as K; cbv zeta in K.
      apply (C1_same _ _ _ _ _ _ _ _ _ _ _ K).
      intros t y v mu; repeat split; ring.
    + assert (Ap : forall n, (n <= 1)%nat -> C1 (fun _ _ _ mu => Rabs mu <= d) (fun _ _ _ mu => sgn (stop P (c + 1)%Z) * (Q
        P (stop P c) n (s P (c + 1)%Z) mu - Q P (stop P (c + 1)%Z) n (s P (c + 1)%Z) mu)) (fun _ _ _ _ => 0) (fun _ _ _ _ =>
        0) (fun _ _ _ _ => 0) (fun _ _ _ mu => sgn (stop P (c + 1)%Z) * (Q_mu P (stop P c) n (s P (c + 1)%Z) mu - Q_mu P
        (stop P (c + 1)%Z) n (s P (c + 1)%Z) mu))); [|split; apply Ap; lia].
      intros n Hn; assert (Sub : forall t y v m : R, Rabs m <= d -> Rabs m <= r2) by (intros; lra); pose proof (C1_less (fun
        _ _ _ mu => Rabs mu <= d) (fun _ _ _ mu => Rabs mu <= r2) (sgn (stop P (c + 1)%Z)) _ _ _ _ _ _ _ _ _ _ (C1_sub _
        (fun _ _ _ mu => Rabs mu <= d) _ _ _ _ _ (at_time r2 (stop P c) n (s P (c + 1)%Z) (HC _ n ltac:(lia))) Sub)
        (at_time r2 (stop P (c + 1)%Z) n (s P (c + 1)%Z) (HC _ n ltac:(lia))) Sub) as K; apply (C1_same _ _ _ _ _ _ _ _ _ _
        _ K); intros; repeat split; ring.
Qed.
End Rattling.
