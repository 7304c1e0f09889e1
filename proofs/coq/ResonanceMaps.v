(** * The curve of orbits with one impact, and its signs in the plane at resonance *)
From Coq Require Import Reals FunctionalExtensionality Lra Lia Arith.
From Grazing Require Import Defs Statement StatementOrbits StatementOrbitsPlane StatementResonance Derivatives Finite.
From Grazing Require Import Algebra OrbitVectors OrbitRemainder OrbitFixedPoint Orbits PlaneLinear Polar.
From Grazing Require Import Contraction ResonanceSigns ResonanceCurve.
From Grazing Require ResonanceExact.
Open Scope R_scope.

Section Orbits.
Variables (M : Map.t) (w : vec) (e : R) (n : nat) (V : vec).
Hypothesis HM : smooth M.
Notation N := (Map.N M).
Notation pow k x := (Nat.iter k (mult N (Map.A M)) x).
Hypothesis Hw : forall i, (i < N)%nat -> w i = mult N (Map.A M) w i + Map.phi M i.
Hypothesis He : e = dot N (Map.C M) w + Map.eta M.
Hypothesis Ne : e <> 0.
Hypothesis Hn : (1 <= n)%nat.
Hypothesis Hdet : forall x, (forall i, (i < N)%nat -> x i = pow n x i) -> forall i, (i < N)%nat -> x i = 0.
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
  { apply (zero_orbit M (z O) unit (fun j => j) (fun _ => n) (fun _ => Hn) d x (fun _ => y)); [intros ?;
    exact Hd | |].
    - apply zero_meaning; intros ?; exact Hs.
    - intros ?; split; [exact Hy | intros k Hkn; apply Hk; lia]. }
  split; [exact Ho|]; destruct (Ho tt) as (_ & Hf & _); unfold speed_of.
  rewrite (heights M (z O) (x tt) n Hf) by lia; replace (S (n - 1)) with n by lia; unfold x; rewrite (proj1 Hs),
    Ropp_involutive. apply sqrt_square; lra.
Qed.

Lemma orbit_inside W : 0 <= W -> within N W w -> exists l dl, 1 <= l /\ 0 < dl /\ forall d0 d h mu x, 0 < d <= dl ->
  (1 + W) * d <= d0 -> 0 < h -> l * d <= h * h -> Rabs mu <= d -> single M n mu d x -> let y := speed_of M n mu x in
  0 < y <= h /\ within (S N) d0 (of w mu (x tt)) /\ solves y (of w mu (x tt)) /\
  forall k, (0 < k < n)%nat -> 0 < hit k mu (x tt).
Proof.
  intros HW Wb; destruct (Lipschitz_fly M w e HM Hw He n) as (l & dl & Hl & Hdl & Lip); exists l, dl; split; [exact Hl |
    split; [exact Hdl|]]; intros d0 d h mu x Hd D1 Hh D2 Hmu Ho y.
  destruct (orbit_solution mu d x Ho) as (Hy & Hs & Hk); fold y in Hy, Hs; destruct (Ho tt) as (Hx & _).
  split; [split; [exact Hy|] | split; [|auto]].
  - destruct (Lip n (x tt) zero mu 0 d (Nat.le_refl n)) as [_ B]; rewrite ?Rminus_0_r, ?Rabs_R0; try lra;
      try (apply within_zero; lra); [apply within_le with d; [lra | exact Hx] | intros i Hi; unfold minus, zero;
      rewrite Rminus_0_r; apply Hx, Hi|].
    apply (proj1 (solves_is M w e n y _ (Rlt_le _ _ Hy))) in Hs; rewrite point_of in Hs; destruct Hs as [Hs _];
      change (of w mu (x tt) O) with mu in Hs; rewrite Hs, (height_zero M w e HM Hw He n), Rminus_0_r, Rabs_Ropp,
      Rabs_pos_eq in B by nra. apply Rsqr_incr_0_var; unfold Rsqr; lra.
  - apply within_S; unfold of; split; [cbn [rows]; assert (0 <= W * d) by (apply Rmult_le_pos; lra); lra|]; intros i Hi;
      unfold hat, rows, Rminus. apply (Rle_trans _ (d + d * W)); [|lra]; apply triangle2; [apply Hx, Hi|].
    rewrite Rabs_Ropp; apply Rabs_mult_le; [exact Hmu | apply Wb, Hi].
Qed.

Theorem curves : exists d, 0 < d /\ curve M w V e n d.
Proof.
  destruct (inverse_exists M e n Ne Hdet) as (K & HK), (within_exists N w) as (W & HW & Wb), (within_exists N (Map.B M))
    as (beta & Hb & Bb); pose proof (proj1 HK) as K1.
  set (eps0 := / (2 * K)); assert (He0 : 0 < eps0 /\ K * eps0 <= 1 / 2).
  { unfold eps0; split; [apply Rinv_0_lt_compat; lra | right; field; lra]. }
  destruct (small_exists M w e n HM Hw He W HW Wb eps0 (proj1 He0)) as (d0 & Hd0 & Sm).
  destruct (orbit_inside W HW Wb) as (l & d2 & Hl & Hd2 & Inside). assert (Wd : 0 <= W /\ within N W w) by auto;
    assert (Bd : 0 <= beta /\ within N beta (Map.B M)) by auto.
  specialize (Sm d0 (conj Hd0 (Rle_refl _))).
  pose proof (near_line M w e n V HM Hw He Ne HV K W eps0 d0 beta HK Wd Hd0 He0 Sm Bd) as Near.
  destruct (margin (fun k _ => across M V k - across M V n) n) as (g & Hg & Mg).
  destruct (Near (g / 2) ltac:(lra)) as (r0 & Hr0 & Near0); destruct (two_least d0 (r0 / 2) Hd0 ltac:(lra)) as (h & Hh &
    L1 & L2).
  destruct (two_least (d0 / (1 + W)) (h * h / l)) as (d1 & Hd1 & L5 & L6); [apply Rdiv_lt_0_compat; lra | apply
    Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra|].
  destruct (two_least d1 d2 Hd1 Hd2) as (d & Hd & L3 & L4).
  assert (D1 : (1 + W) * d <= d0) by (apply (Rle_trans _ ((1 + W) * (d0 / (1 + W)))); [apply Rmult_le_compat_l; lra |
    right; field; lra]).
  assert (D2 : l * d <= h * h) by (apply (Rle_trans _ (l * (h * h / l))); [apply Rmult_le_compat_l; lra | right; field;
    lra]). assert (Dd : d <= d0) by (assert (0 <= W * d) by (apply Rmult_le_pos; lra); lra).
  assert (Orb := fun mu x => Inside d0 d h mu x (conj Hd L4) D1 Hh D2).
  exists d; split; [exact Hd|]; constructor.
  - intros (k & Hk & Neg) mu x Hmu Ho; destruct (Orb mu x Hmu Ho) as (Hy & Hz & Hs & Pos); specialize (Pos k Hk).
    set (y := speed_of M n mu x) in *; destruct (Near0 y _ ltac:(lra) ltac:(lra) Hz Hs) as [_ B]; specialize (B k
      ltac:(lia)). rewrite point_of in B; change (of w mu (x tt) O) with mu in B.
    change (dot N (Map.C M) (pow k V)) with (across M V k) in B; change (dot N (Map.C M) (pow n V)) with (across M V n)
      in B.
    specialize (Mg k 0%nat ltac:(lia) ltac:(lia) ltac:(lra)); rewrite Rabs_left in Mg by lra; apply le_abs in B.
    assert (g * y <= (across M V n - across M V k) * y) by (apply Rmult_le_compat_r; lra).
    assert (0 < g * y) by (apply Rmult_lt_0_compat; lra); lra.
  - intros Above; pose proof (P_pos M e n K beta HK Bd) as P2.
    set (B := K * (beta + eps0)); assert (HB : 0 < B) by (apply Rmult_lt_0_compat; lra).
    destruct (two_least h (d0 / (2 * B)) Hh) as (r1 & Hr1 & M1 & M2); [apply Rdiv_lt_0_compat; lra|].
    destruct (two_least r1 (d / ((1 + W) * P K beta)) Hr1) as (r & Hr & M3 & M4).
    { apply Rdiv_lt_0_compat; [|apply Rmult_lt_0_compat]; lra. } exists r; split; [exact Hr|]; intros y Hy.
    assert (Y : P K beta * y * (1 + W) <= d).
    { apply (Rle_trans _ ((1 + W) * P K beta * (d / ((1 + W) * P K beta)))); [|right; field; lra].
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
      * revert i Hi; apply KB; [apply Rmult_le_pos; lra|]; intros i Hi;
        rewrite minus_comb, left_comb, !TL by exact Hi.
        pose proof (Two y y z z' t Hyd Hyd (B1 z Hz) (B1 z' Hz') Ht Hzz ltac:(rewrite Rminus_eq_0, Rabs_R0; exact Ht) i
          Hi) as B2; unfold minus in B2; same_as B2.
      * assert (K * eps0 * t <= 1 / 2 * t) by (apply Rmult_le_compat_r; lra); lra.
    + intros i Hi; rewrite Rminus_0_r; apply (Rle_trans _ (K * (beta * y + eps0 * y))).
      * revert i Hi; apply KB; [apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra|]; intros i Hi;
        rewrite TL by exact Hi.
        destruct (One y zero y Hyd) as [B1 _]; [apply within_zero; lra | apply within_zero; lra | lra|].
        change (fun _ : nat => 0) with zero; replace (right M w e n y zero i) with (kicked M y i + minus (right M w e n
          y zero) (kicked M y) i) by (unfold minus; ring); apply triangle2; [apply (kicked_within M beta Bd); [lra |
          exact Hi] | apply B1, Hi].
      * replace (K * (beta * y + eps0 * y)) with (B * y) by (unfold B; ring).
        apply (Rle_trans _ (B * (d0 / (2 * B)))); [apply Rmult_le_compat_l; lra | right; field; lra].
    + assert (Wz : within (S N) d0 z) by (intros i Hi; specialize (Hz i Hi); rewrite Rminus_0_r in Hz; exact Hz).
      assert (Hs : solves y z) by (intros i Hi; rewrite <- (TL z i Hi); apply left_ext; [|exact Hi]; intros j Hj;
        symmetry; apply Fz, Hj).
      assert (HK' : inverse_bound M e n K) by (split; [exact K1 | split; [exact KB | exact KS]]).
      pose proof (size M w e n HM Hw He K W eps0 d0 beta HK' Hd0 He0 Sm Bd y z Hyd Wz Hs) as Sz.
      pose proof (point_within M w W z _ Wb Sz) as Pz; replace ((1 + W) * (P K beta * y)) with (P K beta * y * (1 + W))
        in Pz by ring. assert (Z0 : Rabs (z O) <= d).
      { assert (0 <= P K beta * y * W) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
        eapply Rle_trans; [apply (Sz O); lia | lra]. }
      destruct (solution_orbit z y d ltac:(lra) Hs (within_le _ _ _ _ Y Pz)) as [Ho Ey].
      { intros k Hk; destruct (Near0 y z ltac:(lra) ltac:(lra) Wz Hs) as [_ B1]; specialize (B1 k ltac:(lia)).
        change (dot N (Map.C M) (pow k V)) with (across M V k) in B1; change (dot N (Map.C M) (pow n V)) with (across M
          V n) in B1; specialize (Above k Hk); specialize (Mg k 0%nat ltac:(lia) ltac:(lia) ltac:(lra)).
        rewrite Rabs_pos_eq in Mg by lra; apply le_abs in B1.
        assert (g * y <= (across M V k - across M V n) * y) by (apply Rmult_le_compat_r; lra).
        assert (0 < g * y) by (apply Rmult_lt_0_compat; lra); lra. }
      exists (z O), (fun _ => point z); split; [exact Z0|]; split; [exact Ho|]; split; [exact Ey|].
      intros mu' x' Hmu' Ho' E'; destruct (Orb mu' x' Hmu' Ho') as (_ & Hz' & Hs' & _); rewrite E' in Hs'.
      pose proof (unique M w e n K W eps0 d0 beta HK' Hd0 He0 Sm Bd y _ _ Hyd Hz' Wz Hs' Hs) as U; split; [apply (U O);
        lia|].
      assert (E : forall i, (i < N)%nat -> point (of w mu' (x' tt)) i = point z i); [|rewrite point_of in E; exact E].
      intros i Hi; unfold ResonanceCurve.point, comb, hat; rewrite (U O), (U (S i)) by lia; reflexivity.
  - intros eps Heps; destruct (Near eps Heps) as (r & Hr & Nr); exists r; split; [exact Hr|]; intros mu x Hmu Ho y Hy.
    destruct (Orb mu x Hmu Ho) as (Hy0 & Hz & Hs & _); fold y in Hy0, Hz, Hs.
    destruct (Nr y _ ltac:(lra) ltac:(lra) Hz Hs) as [B _]; apply within_S in B; destruct B as [B1 B2]; split.
    + unfold minus, of, line, rows in B1; change (dot N (Map.C M) (pow n V)) with (across M V n) in B1; same_as B1.
    + intros i Hi; specialize (B2 i Hi); unfold hat, minus, of, line, rows in B2; same_as B2.
Qed.
End Orbits.

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
      * destruct Hc as [Hc|Hc]; [|lra]; destruct Neg as [X|(k & Hk & X)]; [lia | rewrite Nat.mod_small by lia;
        lia | |].
        -- exfalso; pose proof (Ek 1%nat) as E; change (INR 1) with 1 in E; rewrite (Rmult_1_l (INR m)), X in E.
           unfold uu in E; rewrite u_1 in E; lra.
        -- exists k; split; [exact Hk|]; apply Low; pose proof (proj2 (Sg k) X); nra.
Qed.
