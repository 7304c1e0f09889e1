(** * The curve of orbits with one impact, and its signs in the plane at resonance *)
From Coq Require Import Reals FunctionalExtensionality Lra Lia Arith.
From Grazing Require Import Defs Statement StatementOrbits StatementOrbitsPlane StatementResonance StatementFold
  Derivatives Finite.
From Grazing Require Import Algebra OrbitVectors OrbitRemainder OrbitFixedPoint Orbits PlaneLinear Polar.
From Grazing Require Import Contraction ResonanceSigns OrbitsNear ResonanceCurve.
From Grazing Require ResonanceExact.
Open Scope R_scope.

Section Orbits.
Variables (M : Map.t) (w : vec) (e : R) (n : nat) (V : vec).
Notation N := (Map.N M).
Notation pow k x := (Nat.iter k (mult N (Map.A M)) x).
Hypothesis Z0 : forall k, Map.h M (fly M 0 k zero) 0 = 0 /\ forall i, (i < N)%nat -> fly M 0 k zero i = 0.
Hypothesis Ne : e <> 0.
Hypothesis Hn : (1 <= n)%nat.
Hypothesis HV : forall i, (i < N)%nat -> V i = pow n V i + Map.B M i.
Notation hit k mu x := (Map.h M (fly M mu k x) mu).
Notation point := (point w).
Notation solves := (solves M w e n).
Notation P K beta := (2 * K * beta + 2).

(** An orbit is a solution with the right signs, and such a solution is an orbit. *)
Lemma orbit_solution mu d x : single M n mu d x -> let y := speed_of M n mu x in
  0 < y /\ solves y (of w mu (x tt)) /\ forall k, (0 < k < n)%nat -> 0 < hit k mu (x tt).
Proof.
  intros Ho y; destruct (orbit_zero M mu unit (fun j => j) (fun _ => n) (fun _ => Hn) d x Ho) as [Ze Sg].
  destruct (Sg tt) as [Hy Hk]; change (speed M mu unit (fun _ => n) x tt) with y in Hy; split; [exact Hy|].
  pose proof (proj1 (zero_meaning M mu unit (fun j => j) (fun _ => n) x _) Ze tt) as Z.
  split; [|intros k Hkn; apply Hk; lia].
  apply (proj2 (solves_is M w e n y _ (Rlt_le _ _ Hy))); rewrite point_of; exact Z.
Qed.
Lemma solution_orbit z y d : 0 < y -> solves y z -> within N d (point z) ->
  (forall k, (0 < k < n)%nat -> 0 < hit k (z O) (point z)) ->
  let x := fun _ : unit => point z in single M n (z O) d x /\ speed_of M n (z O) x = y.
Proof.
  intros Hy Hs Hd Hk x; apply (proj1 (solves_is M w e n y z (Rlt_le _ _ Hy))) in Hs.
  assert (Ho : single M n (z O) d x).
  { apply (zero_orbit M (z O) unit (fun j => j) (fun _ => n) (fun _ => Hn) d x (fun _ => y)); [intros ?; exact Hd | |].
    - apply zero_meaning; intros ?; exact Hs.
    - intros ?; split; [exact Hy | intros k Hkn; apply Hk; lia]. }
  split; [exact Ho|]; destruct (Ho tt) as (_ & Hf & _); unfold speed_of.
  rewrite (heights M (z O) (x tt) n Hf) by lia; replace (S (n - 1)) with n by lia; unfold x; rewrite (proj1 Hs),
    Ropp_involutive. apply sqrt_square; lra.
Qed.

(** Orbits in small balls, one for each speed or none, where (19) is nearly linear. *)
Section Parts.
Variables (K W eps0 d0 beta l dl h d : R).
Hypothesis HK : inverse_bound M e n K.
Hypothesis HW : 0 <= W /\ within N W w.
Hypothesis Hbeta : 0 <= beta /\ within N beta (Map.B M).
Hypothesis Hd0 : 0 < d0.
Hypothesis He0 : 0 < eps0 /\ K * eps0 <= 1 / 2.
Hypothesis Sm : small M w e n W eps0 d0.
Hypothesis Lip : 1 <= l /\ forall mu x d, 0 <= d <= dl -> Rabs mu <= d -> within N d x -> Rabs (hit n mu x) <= l * d.
Hypothesis Hd : 0 < d <= dl /\ (1 + W) * d <= d0.
Hypothesis Hh : 0 < h /\ l * d <= h * h.
Lemma orbit_inside mu x : Rabs mu <= d -> single M n mu d x -> let y := speed_of M n mu x in
  0 < y <= h /\ within (S N) d0 (of w mu (x tt)) /\ solves y (of w mu (x tt)) /\
  forall k, (0 < k < n)%nat -> 0 < hit k mu (x tt).
Proof.
  intros Hmu Ho y; destruct Hd as [D0 D1], Hh as [Hh0 D2], HW as [W0 Wb], Lip as [Hl HLip].
  destruct (orbit_solution mu d x Ho) as (Hy & Hs & Hk); fold y in Hy, Hs; destruct (Ho tt) as (Hx & _).
  split; [split; [exact Hy|] | split; [|auto]].
  - pose proof (HLip mu (x tt) d ltac:(lra) Hmu Hx) as B.
    apply (proj1 (solves_is M w e n y _ (Rlt_le _ _ Hy))) in Hs; rewrite point_of in Hs; destruct Hs as [Hs _];
      change (of w mu (x tt) O) with mu in Hs; rewrite Hs, Rabs_Ropp, Rabs_pos_eq in B by nra.
    apply Rsqr_incr_0_var; unfold Rsqr; lra.
  - apply within_S; unfold of; split; [cbn [rows]; assert (0 <= W * d) by (apply Rmult_le_pos; lra); lra|]; intros i Hi;
      unfold hat, rows, Rminus. apply (Rle_trans _ (d + d * W)); [|lra]; apply triangle2; [apply Hx, Hi|].
    rewrite Rabs_Ropp; apply Rabs_mult_le; [exact Hmu | apply Wb, Hi].
Qed.

(** Heights within g y / 2 of the linear ones. *)
Variables (g r0 r : R).
Hypothesis Near0 : forall y z, 0 <= y < r0 -> within (S N) d0 z -> solves y z -> forall k, (k <= n)%nat ->
  Rabs (hit k (z O) (point z) - (across M V k - across M V n) * y) <= g / 2 * y.
Hypothesis Mg : 0 < g /\ forall k, (k < n)%nat -> across M V k - across M V n <> 0 -> g <= Rabs (across M V k - across M
  V n).
Hypothesis Hr : 0 < r <= h /\ h < r0 /\ h <= d0 /\ 2 * (K * (beta + eps0)) * r <= d0 /\ (1 + W) * P K beta * r <= d.
Lemma part_none mu x : (exists k, (0 < k < n)%nat /\ across M V k < across M V n) -> Rabs mu <= d -> ~ single M n mu d
  x.
Proof.
  intros (k & Hk & Neg) Hmu Ho; destruct (orbit_inside mu x Hmu Ho) as (Hy & Hz & Hs & Pos); specialize (Pos k Hk).
  destruct Mg as [Hg HMg]; set (y := speed_of M n mu x) in *; pose proof (Near0 y _ ltac:(lra) Hz Hs k ltac:(lia)) as B.
  rewrite point_of in B; change (of w mu (x tt) O) with mu in B.
  specialize (HMg k ltac:(lia) ltac:(lra)); rewrite Rabs_left in HMg by lra; apply le_abs in B.
  assert (g * y <= (across M V n - across M V k) * y) by (apply Rmult_le_compat_r; lra).
  assert (0 < g * y) by (apply Rmult_lt_0_compat; lra); lra.
Qed.
Lemma part_one : (forall k, (0 < k < n)%nat -> across M V n < across M V k) -> forall y, 0 < y < r -> exists mu x, Rabs
  mu <= d /\ single M n mu d x /\ speed_of M n mu x = y /\ forall mu' x', Rabs mu' <= d -> single M n mu' d x' ->
  speed_of M n mu' x' = y -> mu' = mu /\ forall i, (i < N)%nat -> x' tt i = x tt i.
Proof.
  intros Above y Hy; pose proof (P_pos M e n K beta HK Hbeta) as P2; destruct Mg as [Hg HMg], HW as [W0 Wb], Hbeta as
    [Hb Bb], Hr as (Hr1 & Hr2 & Hr3 & Hr4 & Hr5); pose proof (proj1 HK) as K1.
    set (B := K * (beta + eps0)) in *; assert (HB : 0 < B) by (apply Rmult_lt_0_compat; lra).
    assert (Y : P K beta * y * (1 + W) <= d).
    { apply (Rle_trans _ ((1 + W) * P K beta * r)); [|exact Hr5].
      replace (P K beta * y * (1 + W)) with ((1 + W) * P K beta * y) by ring; apply Rmult_le_compat_l; [apply
        Rmult_le_pos|]; lra. }
    assert (Hyd : 0 <= y <= d0) by lra; pose proof (small_two _ _ _ _ _ _ _ Sm) as Two.
    pose proof (small_one _ _ _ _ _ _ _ Sm) as One; destruct HK as (_ & KB & KS).
    set (T := fun z => solved M e n (right M w e n y z)); assert (TL : forall z, (forall i, (i < S N)%nat -> left M e n
      (T z) i = right M w e n y z i)) by (intros z; apply KS; reflexivity).
    destruct (contraction nat (fun i => (i < S N)%nat) T d0) as (z & Hz & Fz & _); [lra| | |].
    + intros t z z' Hz Hz' Hzz; assert (Ht : 0 <= t) by (eapply Rle_trans; [apply Rabs_pos | apply (Hzz O); lia]).
      assert (B1 : forall u, near nat (fun i => (i < S N)%nat) d0 u (fun _ => 0) -> within (S N) d0 u) by (intros u Hu i
        Hi; specialize (Hu i Hi); rewrite Rminus_0_r in Hu; exact Hu).
      intros i Hi; change (T z i - T z' i) with (minus (T z) (T z') i); apply (Rle_trans _ (K * (eps0 * t))).
      * revert i Hi; apply KB; [apply Rmult_le_pos; lra|]; intros i Hi; rewrite minus_comb, left_comb, !TL by exact Hi.
        pose proof (Two y y z z' t Hyd Hyd (B1 z Hz) (B1 z' Hz') Ht Hzz ltac:(rewrite Rminus_eq_0, Rabs_R0; exact Ht) i
          Hi) as B2; unfold minus in B2; same_as B2.
      * assert (K * eps0 * t <= 1 / 2 * t) by (apply Rmult_le_compat_r; lra); lra.
    + intros i Hi; rewrite Rminus_0_r; apply (Rle_trans _ (K * (beta * y + eps0 * y))).
      * revert i Hi; apply KB; [apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra|]; intros i Hi;
        rewrite TL by exact Hi.
        destruct (One y zero y Hyd) as [B1 _]; [apply within_zero; lra | apply within_zero; lra | lra|].
        change (fun _ : nat => 0) with zero; replace (right M w e n y zero i) with (kicked M y i + minus (right M w e n
          y zero) (kicked M y) i) by (unfold minus; ring); apply triangle2; [apply (kicked_within M beta Hbeta); [lra |
          exact Hi] | apply B1, Hi].
      * replace (K * (beta * y + eps0 * y)) with (B * y) by (unfold B; ring).
        apply (Rle_trans _ (B * r)); [apply Rmult_le_compat_l; lra | lra].
    + assert (Wz : within (S N) d0 z) by (intros i Hi; specialize (Hz i Hi); rewrite Rminus_0_r in Hz; exact Hz).
      assert (Hs : solves y z) by (intros i Hi; rewrite <- (TL z i Hi); apply left_ext; [|exact Hi]; intros j Hj;
        symmetry; apply Fz, Hj).
      assert (HK' : inverse_bound M e n K) by (split; [exact K1 | split; [exact KB | exact KS]]).
      pose proof (size M w e n Z0 K W eps0 d0 beta HK' Hd0 He0 Sm Hbeta y z Hyd Wz Hs) as Sz.
      pose proof (point_within M w W z _ Wb Sz) as Pz; replace ((1 + W) * (P K beta * y)) with (P K beta * y * (1 + W))
        in Pz by ring. assert (Zd : Rabs (z O) <= d).
      { assert (0 <= P K beta * y * W) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
        eapply Rle_trans; [apply (Sz O); lia | lra]. }
      destruct (solution_orbit z y d ltac:(lra) Hs (within_le _ _ _ _ Y Pz)) as [Ho Ey].
      { intros k Hk; pose proof (Near0 y z ltac:(lra) Wz Hs k ltac:(lia)) as B1.
        specialize (Above k Hk); specialize (HMg k ltac:(lia) ltac:(lra)); rewrite Rabs_pos_eq in HMg by lra; apply
          le_abs in B1.
        assert (g * y <= (across M V k - across M V n) * y) by (apply Rmult_le_compat_r; lra).
        assert (0 < g * y) by (apply Rmult_lt_0_compat; lra); lra. }
      exists (z O), (fun _ => point z); split; [exact Zd|]; split; [exact Ho|]; split; [exact Ey|].
      intros mu' x' Hmu' Ho' E'; destruct (orbit_inside mu' x' Hmu' Ho') as (_ & Hz' & Hs' & _); rewrite E' in Hs'.
      pose proof (unique M w e n K W eps0 d0 beta HK' Hd0 He0 Sm Hbeta y _ _ Hyd Hz' Wz Hs' Hs) as U; split; [apply (U
        O); lia|].
      assert (E : forall i, (i < N)%nat -> point (of w mu' (x' tt)) i = point z i); [|rewrite point_of in E; exact E].
      intros i Hi; unfold ResonanceCurve.point, comb, hat; rewrite (U O), (U (S i)) by lia; reflexivity.
Qed.
End Parts.
End Orbits.

(** Numbers as [Parts] asks for. *)
Lemma sizes W B P l d0 dl r0 : 0 <= W -> 0 < B -> 0 < P -> 1 <= l -> 0 < d0 -> 0 < dl -> 0 < r0 -> exists h d r,
  (0 < d <= dl /\ (1 + W) * d <= d0) /\ (0 < h /\ l * d <= h * h) /\
  0 < r <= h /\ h < r0 /\ h <= d0 /\ 2 * B * r <= d0 /\ (1 + W) * P * r <= d.
Proof.
  intros; destruct (two_least d0 (r0 / 2)) as (h & Hh & L1 & L2); try lra; assert (0 < h * h) by (apply
    Rmult_lt_0_compat; exact Hh). destruct (small_enough d0 (1 + W)) as (a & Ha & A), (small_enough (h * h) l) as (b &
    Hb & B1); try lra. destruct (two_least a b) as (c & Hc & C1 & C2); try lra; destruct (two_least c dl Hc) as (d & Hd
    & D1 & D2); trivial.
  assert (0 < (1 + W) * P) by (apply Rmult_lt_0_compat; lra); destruct (small_enough d0 (2 * B)) as (a' & Ha' & A'),
    (small_enough d ((1 + W) * P)) as (b' & Hb' & B'); try lra.
  destruct (two_least a' b') as (c' & Hc' & C1' & C2'); try lra; destruct (two_least c' h Hc' Hh) as (r & Hr & R1 & R2).
  assert (Up : forall q s t u, 0 <= q -> q * t <= u -> s <= t -> q * s <= u) by (intros q s t u Hq Ht Hs; apply
    Rle_trans with (2 := Ht), Rmult_le_compat_l; assumption).
  exists h, d, r; repeat split; trivial; try lra; [apply (Up _ _ a) | apply (Up _ _ b) | apply (Up _ _ a') | apply (Up _
    _ b')]; lra.
Qed.

Section Smooth.
Variables (M : Map.t) (w : vec) (e : R) (n : nat) (V : vec).
Hypothesis HM : smooth M.
Notation N := (Map.N M).
Notation P K beta := (2 * K * beta + 2).
Hypothesis Hw : forall i, (i < N)%nat -> w i = mult N (Map.A M) w i + Map.phi M i.
Hypothesis He : e = dot N (Map.C M) w + Map.eta M.
Lemma hit_bound : exists l dl, 0 < dl /\ 1 <= l /\ forall mu x d, 0 <= d <= dl -> Rabs mu <= d -> within N d x ->
  Rabs (Map.h M (fly M mu n x) mu) <= l * d.
Proof.
  destruct (Lipschitz_fly M w e HM Hw He n) as (l & dl & Hl & Hdl & Lip); exists l, dl; split; [exact Hdl | split;
    [exact Hl|]]; intros mu x d Hd Hmu Hx; destruct (Lip n x zero mu 0 d (Nat.le_refl n)) as [_ B]; rewrite ?Rminus_0_r,
    ?Rabs_R0; try lra; try (apply within_zero; lra); [apply within_le with d; [lra | exact Hx] | intros i Hi; unfold
    minus, zero; rewrite Rminus_0_r; apply Hx, Hi | rewrite (height_zero M w e HM Hw He n), Rminus_0_r in B; exact B].
Qed.
Hypothesis Ne : e <> 0.
Hypothesis Hn : (1 <= n)%nat.
Hypothesis Hdet : forall x, (forall i, (i < N)%nat -> x i = power M n x i) -> forall i, (i < N)%nat -> x i = 0.
Hypothesis HV : forall i, (i < N)%nat -> V i = power M n V i + Map.B M i.
Theorem curves : exists d, 0 < d /\ curve M w V e n d.
Proof.
  destruct (inverse_exists M e n Ne Hdet) as (K & HK), (within_exists N w) as (W & HW & Wb), (within_exists N (Map.B M))
    as (beta & Hb & Bb), (bounds_exist M n) as (mc & m & Bds); pose proof (proj1 HK) as K1; pose proof (zeros M w e HM
    Hw He) as Z0; assert (Wd : 0 <= W /\ within N W w) by auto; assert (Bd : 0 <= beta /\ within N beta (Map.B M)) by
    auto. pose proof (P_pos M e n K beta HK Bd) as P2; assert (PH : 0 < gain e K beta mc m).
  { destruct Bds as (B1 & _ & B2 & _); pose proof (Rabs_pos e); assert (0 <= mc * m) by (apply Rmult_le_pos; lra).
    unfold gain; lra. }
  set (eps0 := / (2 * K)); assert (He0 : 0 < eps0 /\ K * eps0 <= 1 / 2).
  { unfold eps0; split; [apply Rinv_0_lt_compat; lra | right; field; lra]. }
  destruct (small_exists M w e HM Hw He n W HW Wb eps0 (proj1 He0)) as (d0 & Hd0 & Sm0).
  pose proof (Sm0 d0 (conj Hd0 (Rle_refl _))) as Sm; destruct hit_bound as (l & dl & Hdl & Hl & Lip).
  assert (Near : forall eps, 0 < eps -> exists r, 0 < r /\ forall y z, 0 <= y < r -> within (S N) d0 z ->
    ResonanceCurve.solves M w e n y z -> within (S N) (eps * y) (minus z (line M e n V y)) /\ forall k, (k <= n)%nat ->
    Rabs (Map.h M (fly M (z O) k (point w z)) (z O) - (across M V k - across M V n) * y) <= eps * y).
  { intros eps Heps; destruct (small_exists M w e HM Hw He n W HW Wb (eps / gain e K beta mc m / (P K beta * K))) as (d1
      & Hd1 & S1); [repeat apply Rdiv_lt_0_compat; try apply Rmult_lt_0_compat; lra|].
    destruct (small_exists M w e HM Hw He n W HW Wb (eps / gain e K beta mc m)) as (d2 & Hd2 & S2); [apply
      Rdiv_lt_0_compat; lra|]. destruct (two_least d1 d2 Hd1 Hd2) as (d3 & Hd3 & A1 & A2), (two_least d0 d3 Hd0 Hd3) as
      (d' & Hd' & A3 & A4). exists (d' / P K beta); split; [apply Rdiv_lt_0_compat; lra|]; intros y z [Y0 Y1] Hz HS.
    apply (Rmult_lt_compat_l (P K beta)) in Y1; [|lra]; replace (P K beta * (d' / P K beta)) with d' in Y1 by (field;
      lra). exact (near_line M w e n V Z0 Ne HV K W eps0 d0 beta HK Hd0 He0 Sm Bd mc m eps d' Bds Heps (conj Hd' A3)
      (S1 d' ltac:(lra)) (S2 d' ltac:(lra)) y z Y0 ltac:(lra) Hz HS). }
  destruct (margin (fun k _ => across M V k - across M V n) n) as (g & Hg & Mg).
  destruct (Near (g / 2) ltac:(lra)) as (r0 & Hr0 & Near0).
  destruct (sizes W (K * (beta + eps0)) (P K beta) l d0 dl r0) as (h & d & r & Hd & Hh & Hr); try lra; [apply
    Rmult_lt_0_compat; lra|].
  assert (N0 : forall y z, 0 <= y < r0 -> within (S N) d0 z -> ResonanceCurve.solves M w e n y z -> forall k, (k <=
    n)%nat -> Rabs (Map.h M (fly M (z O) k (point w z)) (z O) - (across M V k - across M V n) * y) <= g / 2 * y) by
    (intros y z Hy Hz HS; apply (Near0 y z Hy Hz HS)).
  assert (Mg' : 0 < g /\ forall k, (k < n)%nat -> across M V k - across M V n <> 0 -> g <= Rabs (across M V k - across M
    V n)) by (split; [exact Hg | intros k Hk; apply (Mg k 0%nat); lia]).
  exists d; split; [apply Hd|]; constructor.
  - intros Neg mu x; apply (part_none M w e n V Hn) with (K := K) (W := W) (eps0 := eps0) (d0 := d0) (beta := beta) (l
      := l) (dl := dl) (h := h) (d := d) (g := g) (r0 := r0) (r := r); auto.
  - intros Above; exists r; split; [apply Hr|]; intros y Hy.
    apply (part_one M w e n V Z0 Hn) with (K := K) (W := W) (eps0 := eps0) (d0 := d0) (beta := beta) (l := l)
      (dl := dl) (h := h) (d := d) (g := g) (r0 := r0) (r := r); auto.
  - intros eps Heps; destruct (Near eps Heps) as (r' & Hr1' & Nr); exists r'; split; [exact Hr1'|]; intros mu x Hmu Ho y
      Hy. destruct (orbit_inside M w e n Hn W d0 l dl h d Wd (conj Hl Lip) Hd Hh mu x Hmu Ho) as (Hy0 & Hz & Hs & _);
        fold y in Hy0, Hz, Hs.
    destruct (Nr y _ ltac:(lra) Hz Hs) as [B _]; apply within_S in B; destruct B as [B1 B2]; split.
    + unfold minus, of, line, rows in B1; change (dot N (Map.C M) (Nat.iter n (mult N (Map.A M)) V)) with (across
      M V n) in B1; same_as B1.
    + intros i Hi; specialize (B2 i Hi); unfold hat, minus, of, line, rows in B2; same_as B2.
Qed.
End Smooth.

Theorem Curve : Curve_statement.
Proof. intros M w V e n HM N Hw He Ne Hn Hdet HV; exact (curves M w e n V HM Hw He Ne Hn Hdet HV). Qed.

Theorem Plane : Plane_statement.
Proof.
  intros M r s n m gamma e w Hr Hs Hn Hm HP; pose proof PI_RGT_0 as HPI; set (th := 2 * PI * s).
  assert (Hth : sin th > 0).
  { apply sin_gt_0; unfold th; [apply Rmult_lt_0_compat; lra|].
    apply (Rlt_le_trans _ (2 * PI * (1 / 2))); [apply Rmult_lt_compat_l|]; lra. }
  destruct (row_B M _ _ gamma e w HP) as (B0 & B1 & Ng); pose proof (is_plane _ _ _ _ _ _ HP) as N2.
  assert (N0 : 1 <= INR n) by (apply (le_INR 1), Hn).
  assert (Is : 0 < INR n * s < INR n * (1 / 2)) by (split; [apply Rmult_lt_0_compat | apply Rmult_lt_compat_l]; lra).
  assert (Hmn : (0 < m < n)%nat) by (split; apply INR_lt; [change (INR 0) with 0|]; lra).
  assert (Ang : forall k, INR k * th = PI * (INR k * INR m / INR n)).
  { intros k; unfold th; replace (INR m) with (2 * (INR n * s)) by lra; field; lra. }
  set (uu := u (trace r s) (r ^ 2)); assert (Hrs : 0 < r * sin th) by (apply Rmult_lt_0_compat; lra).
  assert (Ek : forall k, uu k * (r * sin th) = r ^ k * sin (PI * (INR k * INR m / INR n))).
  { intros k; rewrite <- Ang; apply (u_polar r th); lra. }
  assert (Sg : forall k, (0 < sin (PI * (INR k * INR m / INR n)) -> 0 < uu k) /\ (sin (PI * (INR k * INR m / INR n)) < 0
    -> uu k < 0)).
  { intros k; assert (Pr : 0 < r ^ k) by (apply pow_lt, Hr); specialize (Ek k); set (x := sin (PI * _)) in *.
    split; intros X; apply (Rmult_lt_reg_r (r * sin th)); trivial; rewrite Ek, Rmult_0_l; nra. }
  assert (Un : uu n = 0).
  { apply (Rmult_eq_reg_r (r * sin th)); [|lra]; rewrite Ek, Rmult_0_l.
    replace (PI * (INR n * INR m / INR n)) with (INR m * PI + 0) by (field; lra).
    destruct (ResonanceExact.half_turns m 0) as [-> _]; rewrite sin_0; ring. } assert (Uz : 0 < 1 - uu (S n)).
  { pose proof (v_polar r th (proj1 Hr) Hth n) as Ev; change (2 * r * cos th) with (trace r s) in Ev.
    unfold v in Ev; fold uu in Ev; rewrite Un in Ev; pose proof (COS_bound (INR n * th)).
    assert (r ^ n < 1) by (apply pow_lt_1_compat; [lra | lia]); pose proof (pow_lt r n (proj1 Hr)).
    assert (r ^ n * cos (INR n * th) <= r ^ n * 1) by (apply Rmult_le_compat_l; lra); lra. }
  (* A^n is a multiple of the identity *)
  pose proof (row_u M _ _ gamma e w HP) as Ru; fold uu in Ru; set (z := uu (S n)) in *.
  assert (An : forall x i, (i < 2)%nat -> Nat.iter n (mult 2 (Map.A M)) x i = z * x i).
  { intros x i Hi; replace (z * x i) with (comb z 0 x x i) by (unfold comb; ring); revert i Hi.
    apply (coordinates M _ _ gamma e w HP); rewrite row_power, row_comb.
    - rewrite (Ru n), Un; fold z; ring.
    - rewrite (Ru (1 + n)%nat); cbn [Nat.add]; fold z; unfold uu; rewrite u_SS; fold uu z; rewrite Un; ring. }
  set (V := comb (/ (1 - z)) 0 (Map.B M) (Map.B M)).
  assert (Ac : forall k, across M V k = / (1 - z) * (gamma * uu k)).
  { intros k; unfold across, power, V; rewrite N2, power_comb, dot_comb; pose proof (Ru k (Map.B M)) as E;
    rewrite B0, B1 in E. unfold row in E; rewrite E; ring. }
  assert (Pz : 0 < / (1 - z)) by (apply Rinv_0_lt_compat, Uz). destruct (is_rate _ _ _ _ _ _ HP) as [Er Er0].
  destruct (Curve M w V e n (is_smooth _ _ _ _ _ _ HP)) as (d & Hd & Cv); trivial.
  - rewrite N2; apply (is_w _ _ _ _ _ _ HP).
  - rewrite N2; exact Er.
  - unfold power; rewrite N2; intros x Hx i Hi; specialize (Hx i Hi); rewrite (An x i Hi) in Hx.
    apply (Rmult_eq_reg_l (1 - z)); lra.
  - unfold power; rewrite N2; intros i Hi; rewrite (An V i Hi); unfold V, comb; field; lra.
  - exists V, d; split; [exact Hd|]; split; [exact Cv|]; split; [rewrite Ac, Un; ring|].
    destruct (signs n m Hn) as [Pos Neg]; split.
    + intros -> Hg k Hk; rewrite Ac; repeat apply Rmult_lt_0_compat; trivial; apply Sg, Pos; [apply Nat.mod_small;
      lia | exact Hk].
    + intros Hc; apply (curve_none _ _ _ _ _ _ Cv); rewrite (Ac n), Un, !Rmult_0_r.
      assert (Low : forall k, gamma * uu k < 0 -> across M V k < 0) by (intros k X; rewrite Ac; nra).
      destruct (Rtotal_order gamma 0) as [G|[G|G]]; [|contradiction|].
      * exists 1%nat; split; [lia|]; apply Low; unfold uu; rewrite u_1; lra.
      * destruct Hc as [Hc|Hc]; [|lra]; destruct Neg as [X|(k & Hk & X)]; [lia | rewrite Nat.mod_small by lia; lia | |].
        -- exfalso; pose proof (Ek 1%nat) as E; change (INR 1) with 1 in E; rewrite (Rmult_1_l (INR m)), X in E.
           unfold uu in E; rewrite u_1 in E; lra.
        -- exists k; split; [exact Hk|]; apply Low; pose proof (proj2 (Sg k) X); nra.
Qed.
