(** * Proof that the motions of an oscillator between two stops, told arc by arc, are those of [StatementBouncing] *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs Contraction Derivatives StatementNonlinear StatementUnstable StatementBouncing
  NonlinearSmooth NonlinearArc NonlinearTube NonlinearStops NonlinearRound NonlinearBounces StatementRattling NonlinearSeen.
Import Rattling.
Open Scope R_scope.

Section Rattling.
Variable P : Rattling.t.
Hypothesis HP : rattles P.
Notation O := (seen_from P). Notation kz := (Z.of_nat (k P)).
Let off_turned := off_turned P HP. Let Q_twice := Q_twice P HP. Let stop_D := stop_D P. Let next_stop := next_stop P HP.
Let shifted := shifted P. Let shifted' := shifted' P. Let seen_orbit := seen_orbit P HP.
(** ** Which stop a time is seen from *)
Lemma s_many z c : s P (c + kz * z)%Z = s P c + T P * IZR z. Proof. exact (proj1 (many O seen_orbit z c 0)). Qed.
Lemma s_grow c c' : (c < c')%Z -> s P c < s P c'.
Proof.
  intros L; replace c' with (c + 1 + Z.of_nat (Z.to_nat (c' - c - 1)))%Z by lia; generalize (Z.to_nat (c' - c - 1)) as n;
    intros n; induction n as [|n IH]; [rewrite Z.add_0_r; apply (arcs_end P HP)|]. apply Rlt_trans with (1 := IH); replace
    (c + 1 + Z.of_nat (S n))%Z with (c + 1 + Z.of_nat n + 1)%Z by lia; apply (arcs_end P HP).
Qed.
Definition view (x : R) : sign := if Rle_dec 0 (the (fun g => exists c, s P c <= x < s P (c + 1)%Z /\ g = sgn (stop P c)))
  then Plus else Minus.
Lemma view_is c x : s P c <= x < s P (c + 1)%Z -> view x = stop P c.
Proof.
  intros H; unfold view; replace (the _) with (sgn (stop P c)); [destruct (stop P c); cbn; destruct Rle_dec; trivial; lra|].
  symmetry; apply the_spec; [exists c; auto|]; intros g (c' & H' & ->); replace c' with c; [reflexivity|].
  destruct (Z.lt_trichotomy c c') as [L|[L|L]]; [|exact L|].
  - destruct (Z.eq_dec (c + 1) c') as [<-|Ne]; [lra|]; pose proof (s_grow (c + 1) c' ltac:(lia)); lra.
  - destruct (Z.eq_dec (c' + 1) c) as [<-|Ne]; [lra|]; pose proof (s_grow (c' + 1) c ltac:(lia)); lra.
Qed.
Definition gap (g : R) : Prop := 0 < g /\ (forall c, 4 * g <= s P (c + 1)%Z - s P c) /\ 4 * g <= tG P - s P 0%Z /\ 4 * g <=
  s P 1%Z - tG P.
Lemma gap_exists : exists g, gap g.
Proof.
  destruct (all_turned P HP) as (_ & _ & Per), (arc_touches P HP) as (Ht & _); destruct (all_arcs P HP (fun c d => 4 * d <= s P
    (c + 1)%Z - s P c)) as (g & Hg & H).
  - intros; lra.
  - intros c d; destruct (Per c 0) as (E1 & _), (Per (c + 1)%Z 0) as (E2 & _); replace (c + 1 + kz)%Z with (c + kz + 1)%Z in
      E2 by ring; rewrite E1, E2; split; lra.
  - intros c; destruct (arcs_end P HP c) as (L & _); exists ((s P (c + 1)%Z - s P c) / 4); split; lra.
  - destruct (two_least g ((tG P - s P 0%Z) / 4) Hg ltac:(lra)) as (g1 & G1 & L1 & L2), (two_least g1 ((s P 1%Z - tG P) / 4)
      G1 ltac:(lra)) as (g2 & G2 & L3 & L4); exists g2; split; [exact G2 | split; [intros c; specialize (H c) | split]];
      lra.
Qed.
(** The other stop is clear. *)
Lemma clear_other : exists m, 0 < m /\ forall c t z, s P c - m <= t <= s P (c + 1)%Z + m -> z <> stop P c -> m <= off P z 0
  t (q0 P c t).
Proof.
  destruct (all_turned P HP) as (HT & _ & Per), (Q_C3 P HP) as (r2 & R2 & HC), (arcs_run P HP) as (r & Hr & HR).
  apply (all_arcs P HP (fun c m => forall t z, s P c - m <= t <= s P (c + 1)%Z + m -> z <> stop P c -> m <= off P z 0 t (q0 P c
    t))).
  - intros c d d' H Hd t z Ht Hz; specialize (H t z ltac:(lra) Hz); lra.
  - intros c d; split; intros H t z Ht Hz.
    + destruct (Per c (t - T P)) as (E1 & E2 & _ & E4 & _), (Per (c + 1)%Z 0) as (F1 & _); replace (c + 1 + kz)%Z with (c +
        kz + 1)%Z in F1 by ring; rewrite E1, F1 in Ht; rewrite E2 in Hz; replace (t - T P + T P) with t in E4 by ring; rewrite
        E4. assert (Ez : z = image P (image P z)) by (unfold image; destruct (mirror P), z; reflexivity); rewrite Ez; pose
        proof (off_turned (image P z) 0 (t - T P) (q0 P c (t - T P))) as Q1; replace (t - T P + T P) with t in Q1 by ring;
        rewrite Q1; apply H; [lra|]; intros E; apply Hz; rewrite <- E; exact Ez.
    + destruct (Per c t) as (E1 & E2 & _ & E4 & _), (Per (c + 1)%Z 0) as (F1 & _); replace (c + 1 + kz)%Z with (c + kz + 1)%Z
        in F1 by ring; rewrite <- off_turned, <- E4; apply H; [rewrite E1, F1; lra|]; rewrite E2; intros E; apply Hz; unfold
        image in E; destruct (mirror P), z, (stop P c); congruence.
  - intros c; set (z' := match stop P c with Plus => Minus | Minus => Plus end); set (F t := off P z' 0 t (q0 P c t)).
    destruct (arcs_end P HP c) as (L & _); assert (CF : forall t, s P c - r <= t <= s P (c + 1)%Z + r -> continuity_pt F t).
    { intros t Ht; eapply D_continuous; apply D_scale, D_minus; [apply (HR c t Ht)|]; apply (stop_D r2 z' 0 t 0 (HC z' 0%nat
        ltac:(lia))); rewrite Rabs_R0; lra. }
    destruct (continuity_ab_min F (s P c) (s P (c + 1)%Z) ltac:(lra) (fun t Ht => CF t ltac:(lra))) as (x & Mx & Hx).
    assert (Pos : 0 < F x) by (apply (off_the_other P HP c x z' Hx); unfold z'; destruct (stop P c); discriminate).
    destruct (continuous_near F (s P c) (F x / 2) (CF (s P c) ltac:(lra)) ltac:(lra)) as (d1 & D1 & N1), (continuous_near F (s P (c
      + 1)%Z) (F x / 2) (CF (s P (c + 1)%Z) ltac:(lra)) ltac:(lra)) as (d2 & D2 & N2).
    destruct (two_least d1 d2 D1 D2) as (d3 & D3 & L1 & L2), (two_least d3 (F x / 2) D3 ltac:(lra)) as (d & Hd & L3 & L4);
      exists d; split; [exact Hd|]; intros t z Ht Hz; replace z with z' by (unfold z'; destruct (stop P c), z; congruence);
      change (d <= F t).
    destruct (Rlt_le_dec t (s P c)) as [O1|O1]; [|destruct (Rlt_le_dec (s P (c + 1)%Z) t) as [O2|O2]].
    + specialize (N1 t ltac:(apply Rabs_le; lra)); pose proof (Mx (s P c) ltac:(lra)); apply le_abs in N1; lra.
    + specialize (N2 t ltac:(apply Rabs_le; lra)); pose proof (Mx (s P (c + 1)%Z) ltac:(lra)); apply le_abs in N2; lra.
    + specialize (Mx t ltac:(lra)); lra.
Qed.

(** ** The motions *)
Section Frame.
Variables (d g : R) (N : Z -> Z) (t : Z -> R) (i j : Z) (r : nat -> R).
Notation n := (others O N i j). Notation on := (on P N).
Hypothesis Hg : gap g.
Hypothesis Hd : d <= g.
Hypothesis HN : (N i <= N j)%Z.
Hypothesis Hends : r 0%nat = t i /\ r (S n) = t j.
Hypothesis Hnear : forall l, l = i \/ l = j -> Rabs (t l - (tG P + T P * IZR (N l))) <= d.
Hypothesis Hothers : forall m, (1 <= m <= n)%nat -> Rabs (r m - s P (on i m)) <= d.
Hypothesis Hcuts : forall m, (m < n)%nat -> impact P (on i m) = true \/ r (S m) = s P (on i (S m)).
Lemma on_S m : on i (S m) = (on i m + 1)%Z. Proof. unfold StatementRattling.on, arc; lia. Qed.
Lemma on_last : on i n = on j 0.
Proof. unfold StatementRattling.on, arc, others; change (Bouncing.k O) with (k P); rewrite Nat2Z.inj_mul, Z2Nat.id by lia;
  change (Z.of_nat 0) with 0%Z; ring. Qed.
Lemma on_first l : s P (on l 0) = s P 0%Z + T P * IZR (N l) /\ s P (on l 0 + 1)%Z = s P 1%Z + T P * IZR (N l).
Proof.
  unfold StatementRattling.on, arc; change (Bouncing.k O) with (k P); split; [rewrite <- (s_many (N l) 0%Z) | rewrite <-
    (s_many (N l) 1%Z)]; f_equal; change (Z.of_nat 0) with 0%Z; ring.
Qed.
Lemma first_in l : l = i \/ l = j -> s P (on l 0) + g <= t l <= s P (on l 0 + 1)%Z - g.
Proof.
  intros Hl; destruct Hg as (G0 & _ & G2 & G3), (on_first l) as [-> ->]; pose proof (Hnear l Hl) as A; apply le_abs in A;
    lra.
Qed.
Lemma span m x : (m <= n)%nat -> r m <= x <= r (S m) -> s P (on i m) - d <= x <= s P (on i m + 1)%Z + d.
Proof.
  intros Hm Hx; destruct Hg as (G0 & _); assert (d0 : 0 <= d) by (pose proof (Hnear i ltac:(auto)) as A; pose proof (Rabs_pos
    (t i - (tG P + T P * IZR (N i)))); lra). split.
  - destruct m as [|m]; [pose proof (first_in i ltac:(auto)); destruct Hends as [E _]; rewrite E in Hx; lra|]; pose proof
      (Hothers (S m) ltac:(lia)) as A; apply le_abs in A; lra.
  - destruct (Nat.eq_dec m n) as [->|Ne]; [pose proof (first_in j ltac:(auto)) as A; rewrite on_last; destruct Hends as [_
      E]; rewrite E in Hx; lra|]. pose proof (Hothers (S m) ltac:(lia)) as A; rewrite on_S in A; apply le_abs in A; lra.
Qed.
Lemma view_on m x : (m <= n)%nat -> r m <= x <= r (S m) -> (x = r (S m) -> m = n) -> view x = stop P (on i m).
Proof.
  intros Hm Hx Hl; destruct (span m x Hm Hx) as [S1 S2], Hg as (G0 & G1 & _); pose proof (G1 (on i m)) as G2; destruct
    (Rlt_le_dec x (s P (on i m))) as [O1|O1]; [|destruct (Rlt_le_dec x (s P (on i m + 1)%Z)) as [O2|O2]].
  - destruct m as [|m]; [pose proof (first_in i ltac:(auto)); destruct Hends as [E _]; rewrite E in Hx; lra|]. rewrite on_S
      in *; destruct (Hcuts m ltac:(lia)) as [I|C]; [rewrite (next_stop _ I); apply view_is; pose proof (G1 (on i m)); lra |
      rewrite on_S in C; lra].
  - apply view_is; lra.
  - destruct (Nat.eq_dec m n) as [->|Ne]; [pose proof (first_in j ltac:(auto)) as A; rewrite on_last in *; destruct Hends as
      [_ E]; rewrite E in Hx; lra|]. destruct (Hcuts m ltac:(lia)) as [I|C]; [rewrite <- (next_stop _ I); apply view_is; pose
      proof (G1 (on i m + 1)%Z); lra|]. rewrite on_S in C; exfalso; apply Ne, Hl; lra.
Qed.
End Frame.
Lemma view_near d g N t l : gap g -> d <= g -> Rabs (t l - (tG P + T P * IZR (N l))) <= d -> view (t l) = stop P (on P N l
  0).
Proof.
  intros Hg Hd A; apply view_is; destruct (on_first N l) as [-> ->], Hg as (G0 & _ & G2 & G3); apply le_abs in A; lra.
Qed.
Lemma same_rides g : gap g -> exists r0, 0 < r0 <= g /\ forall mu d N t i j, Rabs mu <= r0 -> d <= r0 -> (N i <= N j)%Z ->
  (forall q u, rides P mu d N t q u i j -> bounces O mu d N t (fun i x => off P (view x) mu x (q i x)) (fun i x => rel P
  (view x) mu x (u i x)) i j) /\ forall y v, bounces O mu d N t y v i j -> rides P mu d N t (fun i x => Q P (view x) 0 x mu +
  sgn (view x) * y i x) (fun i x => Q P (view x) 1 x mu + sgn (view x) * v i x) i j.
Proof.
  intros Hg; destruct (Q_C3 P HP) as (r1 & R1 & HC), clear_other as (m0 & Hm0 & Clear), (stops_steady P HP (m0 / 4) ltac:(lra))
    as (d1 & D1 & N1). destruct (two_least r1 d1 R1 D1) as (r2 & R2 & L1 & L2), (two_least r2 (m0 / 4) R2 ltac:(lra)) as (r3
    & R3 & L3 & L4), (two_least r3 g R3 (proj1 Hg)) as (r0 & R0 & L5 & L6); exists r0; split; [lra|]; intros mu d N t i j Hmu
    Hd HN.
  assert (DQ : forall z n x, (n <= 1)%nat -> derivable_pt_lim (fun x => Q P z n x mu) x (Q P z (S n) x mu)) by (intros z n x
    Hn; apply (stop_D r1 z n x mu (HC z n ltac:(lia))); lra). split.
  - intros q u (r & p & w & [[A1 A2] (A3 & A4) B C D E F G H I J K]); cbv zeta in *.
    assert (Cut : forall m, (m < others O N i j)%nat -> impact P (on P N i m) = true \/ r (S m) = s P (on P N i (S m))) by
      (intros m Hm; specialize (E m Hm); destruct (impact P (on P N i m)); auto).
    exists r, (fun m x => off P (stop P (on P N i m)) mu x (p m x)), (fun m x => rel P (stop P (on P N i m)) mu x (w m x));
      constructor; try assumption.
    + split; assumption.
    + split; assumption.
    + intros m x Hm Hx; destruct (F m x Hm Hx) as [B1 B2]; split; cbn; unfold off, rel.
      * apply D_scale, D_minus; [exact B1 | apply DQ; lia].
      * unfold StatementRattling.on; rewrite !there; apply D_scale, D_minus; [exact B2 | apply (DQ _ 1%nat); lia].
    + intros m x Hm Hx; specialize (H m x Hm Hx); unfold off; destruct (stop P (on P N i m)); cbn; lra.
    + intros m Hm; cbv zeta; destruct (I m Hm) as [I1 I2]; specialize (E m Hm); rewrite on_S; unfold
        StatementBouncing.follows; cbn; change (arc O N i m) with (on P N i m); destruct (impact P (on P N i m)) eqn:Im.
      * rewrite (next_stop _ Im), I1, I2; split; [apply E | unfold rel; rewrite there; reflexivity].
      * rewrite I1, I2, E, on_S; split; [apply shifted | apply shifted'].
    + intros m x Hm Hx Hl; rewrite (view_on d g N t i j r Hg ltac:(lra) HN (conj A1 (proj1 (conj A3 A4))) B C Cut m x Hm Hx
        Hl); destruct (J m x Hm Hx Hl) as [-> ->]; auto.
    + rewrite (view_near d g N t j Hg ltac:(lra) (B j ltac:(auto))), K; cbn; change (arc O N j 0) with (on P N j 0); unfold rel;
        rewrite there; reflexivity.
  - intros y v (r & p & w & [[A1 A2] (A3 & A4 & A5) B C D E F G H I J K]); cbv zeta in *.
    assert (Cut : forall m, (m < others O N i j)%nat -> impact P (on P N i m) = true \/ r (S m) = s P (on P N i (S m))).
    { intros m Hm; specialize (E m Hm); cbn in E; unfold StatementRattling.on; destruct (impact P (arc O N i m)); auto. }
    exists r, (fun m x => Q P (stop P (on P N i m)) 0 x mu + sgn (stop P (on P N i m)) * p m x), (fun m x => Q P (stop P (on P
      N i m)) 1 x mu + sgn (stop P (on P N i m)) * w m x); constructor; try assumption; unfold off, rel; rewrite
      ?NonlinearStops.here; auto.
    + intros m Hm; specialize (E m Hm); cbv zeta; rewrite !NonlinearStops.here; exact E.
    + intros m x Hm Hx; destruct (F m x Hm Hx) as [B1 B2]; split.
      * eapply D_value; [apply D_plus; [apply (DQ _ 0%nat); lia | apply D_scale, B1] | reflexivity].
      * eapply D_value; [apply D_plus; [apply (DQ _ 1%nat); lia | apply D_scale, B2] | cbn; unfold StatementRattling.on;
          destruct (stop P (arc O N i m)); cbn; ring].
    + intros m x Hm Hx; cbv zeta; rewrite !NonlinearStops.here; exact (G m x Hm Hx).
    + intros m x Hm Hx; pose proof (H m x Hm Hx) as Op; destruct (G m x Hm ltac:(lra)) as [B1 _]; cbn in B1; change (arc O N i
        m) with (on P N i m) in B1; unfold off in B1. destruct (span d g N t i j r Hg ltac:(lra) HN (conj A1 A3) B C m x Hm
        ltac:(lra)) as [S1 S2]. assert (Zx : Rabs (x - x) <= d1) by (rewrite Rminus_eq_0, Rabs_R0; lra).
      pose proof (N1 Plus 0%nat x x mu ltac:(lia) Zx ltac:(lra)) as N2; pose proof (N1 Minus 0%nat x x mu ltac:(lia) Zx
        ltac:(lra)) as N3; apply le_abs in B1, N2, N3. pose proof (Clear (on P N i m) x Plus ltac:(lra)) as K1; pose proof
        (Clear (on P N i m) x Minus ltac:(lra)) as K2; unfold off in K1, K2.
      destruct (stop P (on P N i m)); cbn in *; [specialize (K2 ltac:(discriminate)) | specialize (K1 ltac:(discriminate))];
        lra.
    + intros m Hm; specialize (E m Hm); specialize (I m Hm); cbv zeta; unfold StatementBouncing.follows in I; cbn in E, I; change
        (arc O N i m) with (on P N i m) in *; unfold passes; rewrite on_S in *; destruct (impact P (on P N i m)) eqn:Im.
      * rewrite (next_stop _ Im), (proj1 I), (proj2 I), (proj1 E); split; [reflexivity | unfold rel; rewrite there; reflexivity].
      * change (arc O N i (S m)) with (on P N i (S m)) in E; rewrite on_S in E; rewrite (proj1 I), (proj2 I), E; split; destruct
          (stop P (on P N i m + 1)%Z); cbn; ring.
    + intros m x Hm Hx Hl; rewrite (view_on d g N t i j r Hg ltac:(lra) HN (conj A1 A3) B C Cut m x Hm Hx Hl); destruct (J m x
        Hm Hx Hl) as [-> ->]; auto.
    + rewrite (view_near d g N t j Hg ltac:(lra) (B j ltac:(auto))), K; cbn; change (arc O N j 0) with (on P N j 0); unfold rel;
        rewrite there; reflexivity.
Qed.
(** The velocities of the stops are Lipschitz in time. *)
Lemma stops_Lipschitz : exists r, 0 < r /\ forall mu, Rabs mu <= r -> exists B, 0 <= B /\ forall z t t', Rabs (Q P z 1 t' mu
  - Q P z 1 t mu) <= B * Rabs (t' - t).
Proof.
  destruct (Q_C3 P HP) as (r & Hr & HC), (all_turned P HP) as (HT & _); exists r; split; [exact Hr|]; intros mu Hmu.
  assert (D : forall z n t, (n <= 2)%nat -> derivable_pt_lim (fun t => Q P z n t mu) t (Q P z (S n) t mu)) by (intros z n t
    Hn; exact (stop_D r z n t mu (HC z n Hn) Hmu)).
  assert (One : forall z, exists B, 0 <= B /\ forall t, Rabs (Q P z 2 t mu) <= B) by (intros z; apply (periodic_bounded (fun t
    => Q P z 2 t mu) (2 * T P)); [lra | intros t; exact (D_continuous _ _ _ (D z 2%nat t ltac:(lia))) | intros t; apply
    Q_twice]).
  destruct (One Plus) as (B1 & P1 & H1), (One Minus) as (B2 & P2 & H2); exists (B1 + B2); split; [lra|]; intros z t t'.
  apply (mvt (fun t => Q P z 1 t mu) (fun t => Q P z 2 t mu)); [intros x; apply D; lia | intros x _; specialize (H1 x);
    specialize (H2 x); destruct z; lra].
Qed.
Lemma unstable_rattling g r1 : gap g -> 0 < r1 <= g -> (forall mu d N t i j, Rabs mu <= r1 -> d <= r1 -> (N i <= N j)%Z ->
  forall y v, bounces O mu d N t y v i j -> rides P mu d N t (fun i x => Q P (view x) 0 x mu + sgn (view x) * y i x) (fun i x
  => Q P (view x) 1 x mu + sgn (view x) * v i x) i j) -> exists r, 0 < r <= r1 /\ forall mu d N t q u, Rabs mu <= r -> d <= r
  -> (forall i, N i <= N (i + 1))%Z -> rattling_motion P mu d N t q u -> unstable_motion (bounces O mu d N) t (fun i x => rel
  P (view x) mu x (u i x)) -> unstable_motion (rides P mu d N) t u.
Proof.
  intros Hg Hr1 HL; destruct stops_Lipschitz as (r2 & R2 & HQ), (two_least r1 r2 (proj1 Hr1) R2) as (r & Hr & L1 & L2).
  exists r; split; [lra|]; intros mu d N t q u Hmu Hd HN HM (r0 & Hr0 & H); destruct (HQ mu ltac:(lra)) as (B & HB & Lip).
  assert (Weigh : forall e a b, Rabs a <= e / (1 + B) -> Rabs b <= e / (1 + B) -> Rabs a <= e /\ B * Rabs a + Rabs b <=
    e).
  { intros e a b Ha Hb; pose proof (Rmult_le_compat_l B _ _ HB Ha) as C; pose proof (Rabs_pos a).
    assert (E : e / (1 + B) + B * (e / (1 + B)) = e) by (field; lra); assert (0 <= B * (e / (1 + B))) by (apply
      Rmult_le_pos; lra); lra. }
  exists (r0 / (1 + B)); split; [apply Rdiv_lt_0_compat; lra|]; intros j eps He.
  destruct (H j (eps / (1 + B)) ltac:(apply Rdiv_lt_0_compat; lra)) as (l & t' & y' & v' & Hl & Lg & [N1 N2] & Out).
  exists l, t', (fun i x => Q P (view x) 0 x mu + sgn (view x) * y' i x), (fun i x => Q P (view x) 1 x mu + sgn (view x) * v'
    i x). split; [exact Hl|]; split; [intros i Hi; apply (HL mu d N t' i (i + 1)%Z ltac:(lra) ltac:(lra) (HN i)), Lg, Hi|].
  assert (W : forall i, view (t i) = stop P (on P N i 0)).
  { intros i; destruct (HM i _ eq_refl) as (rr & pp & ww & J); apply (view_near d g N t i Hg ltac:(lra)), (ride_near _ _ _ _ _
      _ _ _ _ _ _ _ _ J); auto. }
  assert (W' : forall i, (j <= i <= l)%Z -> view (t' i) = stop P (on P N i 0)).
  { intros i Hi; apply (view_near d g N t' i Hg ltac:(lra)); destruct (Z.eq_dec i l) as [->|Ne]; [destruct (Lg (l - 1)%Z
      ltac:(lia)) as (rr & pp & ww & J); replace (l - 1 + 1)%Z with l in J by lia | destruct (Lg i ltac:(lia)) as (rr & pp &
      ww & J)]; apply (journey_near _ _ _ _ _ _ _ _ _ _ _ _ _ J); auto. }
  unfold StatementUnstable.near in *; pose proof (W' j ltac:(lia)) as Wj; pose proof (W' l ltac:(lia)) as Wl; rewrite (W j) in
    N2; rewrite (W l) in Out; rewrite Wj, Wl; split.
  - set (z := stop P (on P N j 0)) in *; destruct (Weigh eps _ _ N1 N2) as [W1 W2]; split; [exact W1|]; pose proof (Lip z (t
      j) (t' j)) as Q1. replace (Q P z 1 (t' j) mu + sgn z * v' j (t' j) - u j (t j)) with ((Q P z 1 (t' j) mu - Q P z 1 (t j)
      mu) + sgn z * (v' j (t' j) - rel P z mu (t j) (u j (t j)))) by (unfold rel; destruct z; cbn; ring). eapply Rle_trans;
      [apply Rabs_triang|]; rewrite sgn_abs; lra.
  - set (z := stop P (on P N l 0)) in *; intros [F1 F2]; apply Out; destruct (Weigh r0 _ _ F1 F2) as [W1 W2]; split; [exact
      W1|]; pose proof (Lip z (t l) (t' l)) as Q1. rewrite <- (sgn_abs z); replace (sgn z * (v' l (t' l) - rel P z mu (t l) (u
      l (t l)))) with ((Q P z 1 (t' l) mu + sgn z * v' l (t' l) - u l (t l)) - (Q P z 1 (t' l) mu - Q P z 1 (t l) mu)) by
      (unfold rel; destruct z; cbn; ring). eapply Rle_trans; [apply apart|]; lra.
Qed.
End Rattling.

Theorem Rattling : Rattling_statement.
Proof.
  intros P HP; split; [exact (NonlinearSeen.seen_orbit P HP)|]; destruct (gap_exists P HP) as (g & Hg), (same_rides P HP g Hg) as (r1 & R1 &
    H), (unstable_rattling P HP g r1 Hg R1 (fun mu d N t i j A B C => proj2 (H mu d N t i j A B C))) as (r & Hr & U); exists
    r; split; [lra|]; intros mu d N Hmu Hd HN. set (vw := view P).
  assert (K1 : forall t q u, rattling_motion P mu d N t q u -> bouncing_motion (seen_from P) mu d N t (fun i x => off P (vw x)
    mu x (q i x)) (fun i x => rel P (vw x) mu x (u i x))) by (intros t q u HM i j ->; apply H; [lra | lra | apply HN | exact
    (HM i _ eq_refl)]).
  assert (K2 : forall t y v, bouncing_motion (seen_from P) mu d N t y v -> rattling_motion P mu d N t (fun i x => Q P (vw x) 0
    x mu + sgn (vw x) * y i x) (fun i x => Q P (vw x) 1 x mu + sgn (vw x) * v i x)) by (intros t y v HM i j ->; apply H; [lra
    | lra | apply HN | exact (HM i _ eq_refl)]). split; [split | split; [split|]].
  - intros (t & q & u & HM & Only); exists t, (fun i x => off P (vw x) mu x (q i x)), (fun i x => rel P (vw x) mu x (u i x)).
    split; [apply K1, HM|]; intros t' y' v' HM' i; destruct (Only _ _ _ (K2 _ _ _ HM') i) as [E F]; split; [exact E|];
      intros x Hx; destruct (F x Hx) as [F1 F2].
    unfold off, rel; rewrite <- F1, <- F2, !NonlinearStops.here; auto.
  - intros (t & y & v & HM & Only); exists t, (fun i x => Q P (vw x) 0 x mu + sgn (vw x) * y i x), (fun i x => Q P (vw x) 1 x
      mu + sgn (vw x) * v i x). split; [apply K2, HM|]; intros t' q' u' HM' i; destruct (Only _ _ _ (K1 _ _ _ HM') i) as [E
      F]; split; [exact E|]; intros x Hx; destruct (F x Hx) as [F1 F2].
    rewrite <- F1, <- F2; unfold off, rel; rewrite !there; auto.
  - intros (t & q & u & HM); do 3 eexists; apply (K1 t q u HM).
  - intros (t & y & v & HM); do 3 eexists; apply (K2 t y v HM).
  - intros Un t q u HM; apply (U mu d N t q u Hmu Hd HN HM), (Un _ _ _ (K1 t q u HM)).
Qed.
