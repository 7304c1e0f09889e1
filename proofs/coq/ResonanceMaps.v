(** * Maps of the plane where u_n = 0: no orbit with one impact in n steps, if gamma u_k < 0 for some k < n

    The equations (19) leave mu small beside the speed y of the impact; so the height k steps after it has the sign
    of gamma u_k. *)
From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import Defs Statement StatementOrbits StatementOrbitsPlane StatementOscillator
  StatementResonance.
From Grazing Require Import Derivatives Algebra OrbitVectors OrbitRemainder OrbitFixedPoint Orbits PlaneLinear Polar
  ResonanceSigns.
From Grazing Require ResonanceExact.
Open Scope R_scope.

Section Plane.
Variables (M : Map.t) (a1 a2 gamma e : R) (w : vec) (n : nat).
Hypothesis HP : planar M a1 a2 gamma e w.
Hypothesis Hn : (1 <= n)%nat.
Notation u := (u a1 a2).
Hypothesis Hu : u n = 0.
Hypothesis Hz : u (S n) < 1.
Notation row := (row M).
Notation s := (1 - u (S n)).

(** An orbit: up to eps t, where t bounds x, mu and y. *)
Record nearly_solves (eps t mu y : R) (x : vec) : Prop := {
  small_0 : Rabs (s * row 0 (comb 1 (- mu) x w)) <= eps * t;
  small_1 : Rabs (s * row 1 (comb 1 (- mu) x w) - y * gamma) <= eps * t;
  small_mu : Rabs (row n (comb 1 (- mu) x w) + mu * e) <= eps * t;
  small_h : forall k, (0 < k < n)%nat -> 0 < row k (comb 1 (- mu) x w) + mu * e + eps * t }.

Lemma orbit_solves eps : 0 < eps -> exists d, 0 < d /\ forall mu x, Rabs mu <= d ->
  orbit_near M unit (fun j => j) (fun _ => n) mu d x -> exists y, 0 < y /\
  nearly_solves eps (Rabs (x tt 0%nat) + Rabs (x tt 1%nat) + Rabs mu + y) mu y (x tt).
Proof.
  intros He; pose proof (is_smooth _ _ _ _ _ _ HP) as HM; pose proof (is_plane _ _ _ _ _ _ HP) as N2.
  pose proof (is_w _ _ _ _ _ _ HP) as Hw; destruct (is_rate _ _ _ _ _ _ HP) as [Er _].
  assert (Hw' : forall i, (i < Map.N M)%nat -> w i = mult (Map.N M) (Map.A M) w i + Map.phi M i) by (rewrite N2;
    exact Hw).
  assert (Er' : e = dot (Map.N M) (Map.C M) w + Map.eta M) by (rewrite N2; exact Er).
  destruct (row_bound M 0) as (m0 & P0 & R0), (row_bound M 1) as (m1 & P1 & R1).
  set (m := m0 + m1 + 1); assert (Hm : 1 <= m) by (unfold m; lra).
  destruct (remainder_exists M w e HM Hw' Er' n (eps / m)) as (d1 & Hd1 & Rem); [apply Rdiv_lt_0_compat; lra|].
  destruct (Lipschitz_fly M w e HM Hw' Er' n) as (l & d2 & Hl & Hd2 & Lip).
  destruct (two_least d1 d2 Hd1 Hd2) as (d3 & Hd3 & L1 & L2).
  destruct (two_least d3 (d1 * d1 / l) Hd3) as (d & Hd & L3 & L4).
  { apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra. }
  exists d; split; [exact Hd|]; intros mu x Hmu Ho.
  destruct (orbit_zero M mu unit (fun j => j) (fun _ => n) (fun _ => Hn) d x Ho) as [Ze Sg].
  destruct (proj1 (zero_meaning M mu unit (fun j => j) (fun _ => n) x _) Ze tt) as [H1 H2], (Sg tt) as [Hy Hk].
  destruct (Ho tt) as (Hx & _); set (y := speed M mu unit (fun _ => n) x tt) in *; set (z := x tt) in *.
  exists y; split; [exact Hy|]; set (t := Rabs (z 0%nat) + Rabs (z 1%nat) + Rabs mu + y).
  pose proof (Rabs_pos (z 0%nat)) as A0; pose proof (Rabs_pos (z 1%nat)) as A1; pose proof (Rabs_pos mu) as Am.
  assert (Ht : 0 <= t) by (unfold t; lra).
  assert (Wt : within (Map.N M) t (minus z zero)).
  { rewrite N2; intros i Hi; unfold minus, zero, t; rewrite Rminus_0_r; destruct i as [|[|i]]; [lra | lra | lia]. }
  assert (W0 : forall r, 0 < r -> within (Map.N M) r zero) by (intros r Hr; apply within_zero; lra).
  assert (Hyd : y <= d1).
  { destruct (Lip n z zero mu 0 d (Nat.le_refl n)) as [_ B]; rewrite ?Rminus_0_r, ?Rabs_R0; try lra; try (apply W0;
    lra).
    - apply within_le with d; [lra | exact Hx].
    - intros i Hi; unfold minus, zero; rewrite Rminus_0_r; apply Hx, Hi.
    - rewrite H1, (height_zero M w e HM Hw' Er' n), Rminus_0_r, Rabs_Ropp, Rabs_pos_eq in B by nra.
      assert (l * d <= d1 * d1) by (apply (Rle_trans _ (l * (d1 * d1 / l))); [apply Rmult_le_compat_l; lra | right;
        field; lra]).
      apply Rsqr_incr_0_var; unfold Rsqr; lra. }
  assert (Use : forall k, (k <= n)%nat -> _) by (intros k Hkn; exact (Rem k z zero y 0 mu 0 t Hkn
    (within_le _ d d1 z ltac:(lra) Hx) (W0 d1 Hd1) ltac:(rewrite Rabs_pos_eq; lra) ltac:(rewrite Rabs_R0; lra)
    ltac:(lra) ltac:(rewrite Rabs_R0; lra) Wt ltac:(rewrite Rminus_0_r, Rabs_pos_eq; unfold t; lra)
    ltac:(rewrite Rminus_0_r; unfold t; lra))).
  assert (Em : eps / m * t <= eps * t) by (apply Rmult_le_compat_r; [exact Ht|]; apply (Rmult_le_reg_r m); [lra|];
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; rewrite <- (Rmult_1_r eps) at 1; apply
    Rmult_le_compat_l; lra).
  (* what remains of (19) *)
  set (v := comb 1 (- mu) z w); pose proof (fun k => row_comb M k 1 (- mu) z w) as Ev; fold v in Ev.
  set (X := comb 1 (- y) (comb 1 (-1) v (Nat.iter n (mult 2 (Map.A M)) v)) (Map.B M)).
  assert (HX : within 2 (eps / m * t) X).
  { intros i Hi; destruct (Use n (Nat.le_refl n)) as (U & _ & _); rewrite N2 in U; specialize (U i Hi).
    replace (X i) with (rest1 M mu n z y i - rest1 M 0 n zero 0 i - (mu - 0) * (w i - power M n w i)); [exact U|].
    unfold rest1; rewrite (fly_zero M w HM Hw' n i) by (rewrite N2; exact Hi); unfold StatementOrbits.power; rewrite
      power_zero, N2; specialize (H2 i ltac:(rewrite N2; exact Hi)); fold z in H2.
    unfold X, v; rewrite power_comb; unfold comb, zero; rewrite (Rabs_pos_eq y) in * by lra; lra. }
  assert (Bd : forall k mk, (forall t x, 0 <= t -> within 2 t x -> Rabs (row k x) <= mk * t) -> 0 <= mk <= m ->
    Rabs (row k X) <= eps * t).
  { intros k mk R Hmk; assert (0 <= eps / m * t) by (apply Rmult_le_pos; [|exact Ht]; left; apply Rdiv_lt_0_compat;
    lra).
    eapply Rle_trans; [apply R; [exact H | exact HX]|]; apply (Rle_trans _ (m * (eps / m * t))).
    - apply Rmult_le_compat_r; lra.
    - right; field; lra. }
  pose proof (row_u M a1 a2 gamma e w HP) as Ru; destruct (row_B M a1 a2 gamma e w HP) as (B0 & B1 & _).
  assert (EX : forall k, row k X = row k v - row (k + n) v - y * row k (Map.B M)).
  { intros k; unfold X; rewrite !row_comb, row_power; ring. }
  assert (E0 : row 0 X = s * row 0 v) by (rewrite EX, B0, Nat.add_0_l, (Ru n v), Hu; ring).
  assert (E1 : row 1 X = s * row 1 v - y * gamma) by (rewrite EX, B1; cbn [Nat.add]; rewrite (Ru (S n) v), u_SS, Hu;
    ring).
  constructor; fold v.
  - rewrite <- E0; apply (Bd 0%nat m0 R0); unfold m; lra.
  - rewrite <- E1; apply (Bd 1%nat m1 R1); unfold m; lra.
  - destruct (Use n (Nat.le_refl n)) as (_ & U & _); eapply Rle_trans; [|exact Em]; eapply Rle_trans; [|exact U].
    right; f_equal; unfold rest2; rewrite H1, (height_zero M w e HM Hw' Er' n); unfold StatementOrbits.power; rewrite
      power_zero, dot_zero, Ev, N2; unfold PlaneLinear.row; ring.
  - intros k Hkn; destruct (Use k ltac:(lia)) as (_ & _ & U); specialize (Hk k ltac:(lia)).
    rewrite (height_zero M w e HM Hw' Er' k) in U; unfold StatementOrbits.power in U; rewrite power_minus, power_zero,
      dot_minus, dot_zero, N2 in U; rewrite Ev; unfold PlaneLinear.row; apply le_abs in U; lra.
Qed.

Theorem no_orbit : (exists k, (0 < k < n)%nat /\ gamma * u k < 0) -> exists d, 0 < d /\ forall mu x, Rabs mu <= d ->
  ~ orbit_near M unit (fun j => j) (fun _ => n) mu d x.
Proof.
  intros (k & Hk & Neg); destruct (vector_bound M) as (mv & Hmv & Vb).
  destruct (within_exists 2 w) as (W & HW & Wb); pose proof (proj2 (is_rate _ _ _ _ _ _ HP)) as Ne.
  assert (Pe : 0 < Rabs e) by (apply Rabs_pos_lt, Ne); pose proof (Rabs_pos gamma) as Pg.
  set (z := u (S n)) in *; set (U := u (S k) - a1 * u k); pose proof (Rabs_pos z) as Pz;
    pose proof (Rabs_pos U) as PU.
  pose proof (Rabs_pos (u k)) as Pk; set (g := - (gamma * u k)) in *; assert (Hg : 0 < g) by (unfold g; lra).
  assert (Hs : 0 < (1 - z) * Rabs e) by (apply Rmult_lt_0_compat; lra).
  set (P := 2 * mv * (Rabs e * Rabs gamma) + (1 - z) * Rabs e);
    set (R := 4 * mv * Rabs e + (2 * W + 1) * (1 - z + Rabs z)).
  set (H := Rabs (u k) + Rabs U + 2 * (1 - z) + Rabs z).
  assert (HP0 : 0 < P) by (unfold P; assert (0 <= mv * (Rabs e * Rabs gamma)) by (repeat apply Rmult_le_pos; lra);
    lra).
  assert (HR : 0 <= R) by (unfold R; assert (0 <= mv * Rabs e) by (apply Rmult_le_pos; lra);
    assert (0 <= (2 * W + 1) *
    (1 - z + Rabs z)) by (apply Rmult_le_pos; lra); lra).
  assert (HH : 0 < H) by (unfold H; lra); assert (HPH : 0 < P * H) by (apply Rmult_lt_0_compat; assumption).
  destruct (two_least ((1 - z) * Rabs e / (2 * (R + 1))) (g * ((1 - z) * Rabs e) / (4 * (P * H)))) as (eps & He & L1
    & L2).
  { apply Rdiv_lt_0_compat; lra. } { apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra. }
  destruct (orbit_solves eps He) as (d & Hd & Sol); exists d; split; [exact Hd|]; intros mu x Hmu Ho.
  destruct (Sol mu x Hmu Ho) as (y & Hy & [S0 S1 Sm Sh]); specialize (Sh k Hk); set (X := x tt) in *.
  set (t := Rabs (X 0%nat) + Rabs (X 1%nat) + Rabs mu + y) in *; pose proof (Rabs_pos (X 0%nat)) as P0.
  pose proof (Rabs_pos (X 1%nat)) as P1; pose proof (Rabs_pos mu) as Pm; assert (Ht : 0 < t) by (unfold t; lra).
  rewrite (row_u M a1 a2 gamma e w HP k) in Sh; rewrite (row_u M a1 a2 gamma e w HP n), Hu in Sm;
    fold z in Sm, S0, S1; fold U in Sh.
  set (v := comb 1 (- mu) X w) in *; set (a := row 0 v) in *; set (b := row 1 v) in *; set (E := eps * t) in *.
  replace (0 * b + (z - a1 * 0) * a) with (z * a) in Sm by ring.
  rewrite Rabs_mult, (Rabs_pos_eq (1 - z)) in S0 by lra; pose proof (Rabs_pos a) as Pa; pose proof (Rabs_pos b) as Pb.
  assert (Bb : (1 - z) * Rabs b <= y * Rabs gamma + E).
  { rewrite <- (Rabs_pos_eq (1 - z)), <- Rabs_mult by lra; apply from in S1;
    rewrite (Rabs_mult y), (Rabs_pos_eq y) in S1; lra. }
  assert (Bm : Rabs mu * Rabs e <= E + Rabs z * Rabs a).
  { rewrite <- !Rabs_mult; replace (mu * e) with (z * a + mu * e - z * a) by ring; eapply Rle_trans;
    [apply apart | lra]. }
  assert (Bx : forall i, (i < 2)%nat -> Rabs (X i) <= mv * (Rabs a + Rabs b) + Rabs mu * W).
  { intros i Hi; replace (X i) with (v i + mu * w i) by (unfold v, comb; ring).
    destruct (vector_spec M a1 a2 gamma e w HP a b) as [V0 V1].
    rewrite (coordinates M a1 a2 gamma e w HP v (vector M a b)) by (auto; fold a; fold b; congruence).
    eapply Rle_trans; [apply Rabs_triang|]; apply Rplus_le_compat; [apply Vb; try apply Rle_refl; exact Hi|].
    apply product; [apply Rle_refl | apply Wb, Hi]. }
  assert (HE : 0 <= E) by (unfold E; apply Rmult_le_pos; lra).
  assert (Za : (1 - z) * (Rabs z * Rabs a) <= Rabs z * E) by (replace ((1 - z) * (Rabs z * Rabs a)) with (Rabs z *
    ((1 - z) * Rabs a)) by ring; apply Rmult_le_compat_l; lra).
  (* t is at most a multiple of y *)
  assert (T1 : (1 - z) * Rabs e * t <= P * y + R * E).
  { assert (X1 : (1 - z) * Rabs e * (mv * (Rabs a + Rabs b)) <= mv * Rabs e * (2 * E + y * Rabs gamma)).
    { replace ((1 - z) * Rabs e * (mv * (Rabs a + Rabs b))) with (mv * Rabs e * ((1 - z) * Rabs a + (1 - z) * Rabs
      b)) by
        ring; apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra. }
    assert (X2 : (1 - z) * Rabs e * ((2 * W + 1) * Rabs mu) <= (2 * W + 1) * ((1 - z + Rabs z) * E)).
    { replace ((1 - z) * Rabs e * ((2 * W + 1) * Rabs mu)) with ((2 * W + 1) * ((1 - z) * (Rabs mu * Rabs e))) by
      ring.
      apply Rmult_le_compat_l; [lra|]; apply (Rle_trans _ ((1 - z) * (E + Rabs z * Rabs a)));
        [apply Rmult_le_compat_l|]; lra. }
    pose proof (Bx 0%nat ltac:(lia)) as Y0; pose proof (Bx 1%nat ltac:(lia)) as Y1.
    apply (Rle_trans _ ((1 - z) * Rabs e * (2 * (mv * (Rabs a + Rabs b)) + (2 * W + 1) * Rabs mu + y))).
    - apply Rmult_le_compat_l; unfold t; lra.
    - unfold P, R; lra. }
  assert (T2 : R * E <= (1 - z) * Rabs e / 2 * t).
  { unfold E; rewrite <- Rmult_assoc; apply Rmult_le_compat_r; [lra|]; apply (Rle_trans _ ((R + 1) * eps)); [apply
      Rmult_le_compat_r; lra|]; apply (Rle_trans _ ((R + 1) * ((1 - z) * Rabs e / (2 * (R + 1))))); [apply
      Rmult_le_compat_l; lra | right; field; lra]. }
  (* the height after k steps *)
  assert (T3 : g * y < H * E).
  { apply (Rmult_lt_compat_l (1 - z)) in Sh; [|lra].
    pose proof (product (u k) _ _ _ (Rle_refl _) S1) as X1; pose proof (product U a _ _ (Rle_refl _) (Rle_refl _)) as
      X2.
    assert (X3 : (1 - z) * (Rabs U * Rabs a) <= Rabs U * E) by (replace ((1 - z) * (Rabs U * Rabs a)) with (Rabs U *
      ((1 - z) * Rabs a)) by ring; apply Rmult_le_compat_l; lra).
    assert (X4 : (1 - z) * (mu * e) <= (1 - z) * E + Rabs z * E).
    { pose proof (Rle_abs (mu * e)); rewrite Rabs_mult in *; apply (Rle_trans _ ((1 - z) * (E + Rabs z * Rabs a)));
        [apply Rmult_le_compat_l|]; lra. }
    apply le_abs in X1, X2; assert (X5 : (1 - z) * (U * a) <= (1 - z) * (Rabs U * Rabs a)) by (apply
      Rmult_le_compat_l;
      lra).
    unfold g, H; lra. }
  assert (T4 : H * E * ((1 - z) * Rabs e) <= H * eps * (2 * (P * y))).
  { unfold E; replace (H * (eps * t) * ((1 - z) * Rabs e)) with (H * eps * ((1 - z) * Rabs e * t)) by ring.
    apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra. }
  assert (T5 : H * eps * (2 * (P * y)) <= g * ((1 - z) * Rabs e) / 2 * y).
  { replace (H * eps * (2 * (P * y))) with (2 * (P * H) * eps * y) by ring; apply Rmult_le_compat_r; [lra|].
    apply (Rle_trans _ (2 * (P * H) * (g * ((1 - z) * Rabs e) / (4 * (P * H))))); [apply Rmult_le_compat_l;
      lra | right;
      field; lra]. }
  apply (Rmult_lt_compat_r ((1 - z) * Rabs e)) in T3; [|exact Hs].
  assert (0 < g * ((1 - z) * Rabs e) * y) by (repeat apply Rmult_lt_0_compat; lra); lra.
Qed.
End Plane.

Theorem Maps : Maps_statement.
Proof.
  intros M r s n m gamma e w Hr Hs Hn Hm HP Hc; pose proof PI_RGT_0 as HPI; set (th := 2 * PI * s).
  assert (Hth : sin th > 0).
  { apply sin_gt_0; unfold th; [apply Rmult_lt_0_compat; lra|].
    apply (Rlt_le_trans _ (2 * PI * (1 / 2))); [apply Rmult_lt_compat_l|]; lra. }
  pose proof (is_gamma _ _ _ _ _ _ HP) as [_ Ng]; assert (N0 : 1 <= INR n) by (apply (le_INR 1), Hn).
  assert (Is : 0 < INR n * s < INR n * (1 / 2)) by (split; [apply Rmult_lt_0_compat | apply Rmult_lt_compat_l]; lra).
  assert (Hmn : (0 < m < n)%nat) by (split; apply INR_lt; [change (INR 0) with 0|]; lra).
  assert (Ang : forall k, INR k * th = PI * (INR k * INR m / INR n)).
  { intros k; unfold th; replace (INR m) with (2 * (INR n * s)) by lra; field; lra. }
  assert (Ek : forall k, u (trace r s) (r ^ 2) k * (r * sin th) = r ^ k * sin (PI * (INR k * INR m / INR n))).
  { intros k; rewrite <- Ang; apply (u_polar r th); lra. }
  assert (Hrs : 0 < r * sin th) by (apply Rmult_lt_0_compat; lra).
  assert (Un : u (trace r s) (r ^ 2) n = 0).
  { apply (Rmult_eq_reg_r (r * sin th)); [|lra]; rewrite Ek, Rmult_0_l.
    replace (PI * (INR n * INR m / INR n)) with (INR m * PI + 0) by (field; lra).
    destruct (ResonanceExact.half_turns m 0) as [-> _]; rewrite sin_0; ring. }
  apply (no_orbit M _ _ gamma e w n HP Hn Un).
  - pose proof (v_polar r th (proj1 Hr) Hth n) as Ev; change (2 * r * cos th) with (trace r s) in Ev.
    unfold v in Ev; rewrite Un in Ev; pose proof (COS_bound (INR n * th)).
    assert (r ^ n < 1) by (apply pow_lt_1_compat; [lra | lia]); pose proof (pow_lt r n (proj1 Hr)).
    assert (r ^ n * cos (INR n * th) <= r ^ n * 1) by (apply Rmult_le_compat_l; lra); lra.
  - assert (Pr : forall k, 0 < r ^ k) by (intros k; apply pow_lt, Hr).
    assert (Low : forall k, sin (PI * (INR k * INR m / INR n)) < 0 -> u (trace r s) (r ^ 2) k < 0).
    { intros k Z; apply (Rmult_lt_reg_r (r * sin th)); [exact Hrs|]; rewrite Ek, Rmult_0_l.
      assert (0 < r ^ k * - sin (PI * (INR k * INR m / INR n))) by (apply Rmult_lt_0_compat; [apply Pr | lra]); lra. }
    destruct (Rtotal_order gamma 0) as [G|[G|G]]; [|contradiction|].
    + exists 1%nat; split; [lia|]; rewrite u_1; lra.
    + destruct Hc as [Hc|Hc]; [|lra].
      destruct (signs n m Hn) as [_ S]; destruct S as [Z|(k & Hk & Z)]; [lia | rewrite Nat.mod_small by lia; lia | |].
      * exfalso; pose proof (Ek 1%nat) as E; change (INR 1) with 1 in E; rewrite (Rmult_1_l (INR m)), Z, u_1 in E;
        lra.
      * exists k; split; [exact Hk|]; pose proof (Low k Z); nra.
Qed.
