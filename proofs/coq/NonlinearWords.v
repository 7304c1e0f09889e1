(** * Theorem 1 for motions of the equation: which words are motions, and that these are unstable *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane StatementWords StatementUnstable Headline
  PlaneOrbits Orbits OrbitsUnstable Derivatives.
From Grazing Require Import NonlinearGronwall NonlinearFlow NonlinearTouch NonlinearSpeed NonlinearKick NonlinearMap.
From Grazing Require Import NonlinearMotions NonlinearUnstable.
Open Scope R_scope.
Section Words.
Context {the_force : force} {the_touch : touch the_force} {the_window : near the_touch} {the_impact : impact the_touch}.
Let HT := HT. Let HL := HL. Let HtG := HtG. Let Hg := Hg. Let Hd0 := Hd0.
Notation lin := (solves kk cc ll).

Lemma far_from_touch : exists ym, 0 < ym /\ forall t, 0 <= t <= T -> r0 <= Rabs (t - tG) -> ym <= y0 t.
Proof.
  pose proof Hwin as (Hr & R1 & R2 & _).
  assert (C : forall t, continuity_pt y0 t) by (intros t; apply (D_continuous _ _ _ (proj1 (Horb t)))).
  destruct (continuity_ab_min y0 0 (tG - r0) ltac:(here; lra) (fun t _ => C t)) as (u1 & U1 & I1).
  destruct (continuity_ab_min y0 (tG + r0) T ltac:(here; lra) (fun t _ => C t)) as (u2 & U2 & I2).
  destruct (two_least (y0 u1) (y0 u2)) as (ym & P & L1 & L2); [apply Hopen; lra | apply Hopen; lra|]. exists ym; split;
    [exact P|]; intros t Ht Far; unfold Rabs in Far; destruct (Rcase_abs (t - tG)).
  - specialize (U1 t ltac:(here; lra)); lra.
  - specialize (U2 t ltac:(here; lra)); lra.
Qed.
Lemma small_dd n_max D b : 0 < D <= r0 / 4 -> 0 < b -> exists dd, 0 < dd <= b /\ far n_max * dd <= d0 /\
  32 * (far n_max * dd) < 3 * g * (r0 * r0) /\
  (forall t, 0 <= t <= T -> r0 <= Rabs (t - tG) -> far n_max * dd < y0 t) /\ 16 * (far n_max * dd) <= 3 * g * r0 /\
  8 * (far n_max * dd) <= 3 * g * (D * D) /\ far n_max * dd <= D /\ D <= r0 / 4.
Proof.
  intros HD Hb; destruct far_from_touch as (ym & Hy & Ym); pose proof Hwin as (Hr & _ & _ & Hd0' & _); pose proof
    M_large as LM.
  assert (F1 : 1 <= far n_max) by (unfold far; pose proof (pow_R1_Rle M n_max LM); rewrite <- (Rmult_1_l 1); apply
    Rmult_le_compat; lra).
  assert (P1 : 0 < g * (r0 * r0)) by (apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]); assert (P2 : 0 < g
    * r0) by (apply Rmult_lt_0_compat; lra).
  assert (P3 : 0 < g * (D * D)) by (apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]).
  destruct (two_least d0 (g * (r0 * r0) / 32) Hd0' ltac:(here; lra)) as (e1 & E1 & A1 & B1), (two_least e1 (ym / 2) E1
    ltac:(here; lra)) as (e2 & E2 & A2 & B2).
  destruct (two_least e2 (g * r0 / 16) E2 ltac:(here; lra)) as (e3 & E3 & A3 & B3), (two_least e3 (g * (D * D) / 8) E3
    ltac:(here; lra)) as (e4 & E4 & A4 & B4).
  destruct (two_least e4 D E4 ltac:(here; lra)) as (e5 & E5 & A5 & B5), (two_least b (e5 / far n_max) Hb ltac:(here;
    apply Rdiv_lt_0_compat; lra)) as (dd & Hdd & A6 & B6).
  assert (Q : far n_max * dd <= e5) by (apply Rle_trans with (far n_max * (e5 / far n_max)); [apply Rmult_le_compat_l;
    lra | right; field; lra]). exists dd; repeat (split; [lra|]); split; [intros t Ht Far; specialize (Ym t Ht Far); lra
    | repeat (split; [lra|]); lra].
Qed.

Theorem core A11 A21 A22 gamma z w : (forall z w, lin 0 z w -> z (tG + T) = A11 * z tG + gamma * w tG /\
  w (tG + T) = A21 * z tG + A22 * w tG) -> gamma <> 0 -> lin 1 z w -> z T = z 0 -> w T = w 0 -> z tG <> 0 -> let a1 :=
  A11 + A22 in let a2 := A11 * A22 - gamma * A21 in forall n_max, exists d, d > 0 /\ forall eps, 0 < eps <= d ->
  exists mu0, mu0 > 0 /\ forall (n : Z -> nat) (N : Z -> Z) e s mu, (forall i, (1 <= n i <= n_max)%nat /\
  u a1 a2 (n i) <> 0) -> (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z -> sgn s * gamma > 0 ->
  0 < sgn e * (z tG * mu) < mu0 -> ((forall i, member a1 a2 e (n i) /\ edge a1 a2 e s (n i) (n (i + 1)%Z)) ->
  exists t y v, motion mu eps N t y v /\ unstable_motion (leg_is mu eps N) t v /\ forall t' y' v', motion mu eps N t'
    y' v' -> forall i, t' i = t i /\ forall x,
  t i <= x <= t (i + 1)%Z -> y' i x = y i x /\ v' i x = v i x) /\ ((exists i, breaks a1 a2 e s (n i) (n (i + 1)%Z)) ->
  forall t y v, ~ motion mu d N t y v).
Proof.
  intros HA Hgam Hz Ez Ew Hr a1 a2 n_max; pose proof (map_planar A11 A21 A22 gamma z w HA Hgam Hz Ez Ew Hr) as HP; fold
    a1 a2 in HP. pose proof cg_pos as Hc; assert (Ht0 := proj1 Hreb); pose proof M_large as LM; pose proof (proj1 Hwin)
    as Hr0.
  destruct (Theorem1_plane map a1 a2 _ _ _ HP n_max) as (dT & muT & HdT & HmT & W & Tends), (plane_leave map a1 a2 _ _ _
    HP n_max) as (dL & HdL & Leave). destruct (two_least dT dL HdT HdL) as (dS & HdS & LT & LL).
  destruct (small_dd n_max (r0 / 4) dS ltac:(here; lra) HdS) as (dd & Hdd & S1 & S2 & S3 & S4 & _).
  destruct (two_least (dd / M) (r0 / 4) ltac:(here; apply Rdiv_lt_0_compat; lra) ltac:(here; lra)) as (d & Hd & L1 &
    L2).
  assert (Md : M * d <= dd) by (apply Rle_trans with (M * (dd / M)); [apply Rmult_le_compat_l; lra | right; field;
    lra]). assert (d <= M * d) by (rewrite <- (Rmult_1_l d) at 1; apply Rmult_le_compat_r; lra). exists d; split; [exact
    Hd|]; intros eps Heps.
  destruct (small_dd n_max eps dd ltac:(here; lra) (proj1 Hdd)) as (de & Hde & E1 & E2 & E3 & E4 & E5 & E6).
  destruct (Tends (de / 2) ltac:(here; lra)) as (mu1 & Hm1 & Near); assert (Pr : 0 < Rabs (z tG)) by (apply Rabs_pos_lt,
    Hr).
  destruct (two_least mu1 de Hm1 (proj1 Hde)) as (m2 & M2 & N1 & N2), (two_least m2 eps M2 (proj1 Heps)) as (m3 & M3 &
    N3 & N4).
  destruct (two_least muT (Rabs (z tG) * m3) HmT ltac:(here; apply Rmult_lt_0_compat; assumption)) as (mu0 & Hmu0 & N5 &
    N6). exists mu0; split; [exact Hmu0|]; intros n N e s mu Hn HN Hs Hmu.
  assert (Sm : 0 < Rabs mu < m3) by (apply (small_mu (z tG) e); [exact Hr | lra]).
  assert (Hn' : forall i, (1 <= n i <= n_max)%nat) by (intros i; apply Hn).
  assert (Hg' : sgn s * ((1 + tau) * cg * gamma) > 0).
  { replace (sgn s * ((1 + tau) * cg * gamma)) with ((1 + tau) * cg * (sgn s * gamma)) by ring; apply Rmult_lt_0_compat;
      [apply Rmult_lt_0_compat|]; lra. }
  assert (Hnext : forall j : Z, (j + 1 - 1 = j /\ j - 1 + 1 = j)%Z) by (intros; lia).
  destruct (W Z (fun i => i + 1)%Z (fun i => i - 1)%Z n e s mu Hnext Hn Hg' ltac:(here; lra)) as [Hex Hno].
  assert (Closer : forall r r' x, r <= r' -> orbit_near map Z (fun i => i + 1)%Z n mu r x -> orbit_near map Z (fun i =>
    i + 1)%Z n mu r' x).
  { intros r r' x Hrr H1 i; destruct (H1 i) as [P Q]; split; [|exact Q]; intros k Hk; specialize (P k Hk); lra. }
  (* what a motion gives *)
  assert (Orb : forall r t y v, motion mu r N t y v -> eps <= r <= d -> exists x yy, facts dd mu n x yy /\ (forall i x0,
    t i <= x0 <= t (i + 1)%Z -> y i x0 = Y (x i) mu (x0 - T * IZR (N i)) /\ v i x0 = V (x i) mu (x0 - T * IZR (N i))) /\
    orbit_near map Z (fun i => i + 1)%Z n mu dT x).
  { intros r t y v HM Hrd; destruct (motion_orbit n_max dd mu n N Hn' HN ltac:(here; lra) (proj1 Hdd) S1 S2 S4 t y v r
      HM) as (x & yy & F & Lg); try lra.
    { apply Rle_trans with (2 := Md), Rmult_le_compat_l; lra. }
    exists x, yy; split; [exact F | split; [exact Lg|]]; apply (Closer dd); [lra|].
    apply (facts_orbit n_max dd mu n Hn' ltac:(here; lra) (proj1 Hdd) S1 S2 S4 x yy F). }
  split.
  - intros Hall; destruct Hex as (x & Hx & Only); [intros i; exact (conj (proj2 (proj1 (Hall i))) (proj2 (Hall i)))|].
    assert (Hx2 : forall i, within 2 (de / 2) (x i)) by (intros i; exact (Near Z (fun i => i + 1)%Z (fun i => i - 1)%Z n
      mu x Hnext Hn ltac:(here; lra) Hx i)).
    assert (Hxe : orbit_near map Z (fun i => i + 1)%Z n mu de x).
    { intros i; split; [intros q Hq; specialize (Hx2 i q Hq); lra | apply (Hx i)]. }
    destruct (orbit_facts n_max de mu n Hn' ltac:(here; lra) (proj1 Hde) E1 E2 E4 x Hxe) as (yy & F). assert (HM :
      motion mu eps N (at_ mu n N x yy) (leg mu N x) (legv mu N x)) by (intros i j ->; apply (orbit_leg n_max de mu n N
      Hn' HN ltac:(here; lra) (proj1 Hde) E1 E2 E3 E4 eps E5 E6 x yy i (F _) (F _))).
    destruct (proj2 (Only x Hx)) as (low0 & Hlow & Cl).
    destruct (Leave Z (fun i => i + 1)%Z n mu x low0 Hn ltac:(here; lra) (Closer de dL x ltac:(here; lra) Hxe) Hlow Cl)
      as [_ Lv].
    eexists; eexists; eexists; split; [exact HM|]; split; [exact (motion_left n_max de mu n N Hn' HN ltac:(here; lra)
      (proj1 Hde) E1 E2 E3 E4 eps E5 E6 x yy F Hx2 Lv)|]; intros t' y' v' HM'.
    destruct (Orb eps _ _ _ HM ltac:(here; lra)) as (x1 & yy1 & F1 & Lg1 & O1), (Orb eps _ _ _ HM' ltac:(here; lra)) as
      (x2 & yy2 & F2 & Lg2 & O2).
    apply (same_motion n_max dd mu n N Hn' HN ltac:(here; lra) (proj1 Hdd) S1 S4 _ _ _ _ _ _ eps x1 yy1 x2 yy2 HM HM'
      ltac:(here; lra) F1 F2 Lg1 Lg2). intros j i Hi; rewrite (proj1 (Only x1 O1) j i Hi), (proj1 (Only x2 O2) j i Hi);
      reflexivity.
  - intros [i Hi] t y v HM; destruct (Orb d _ _ _ HM ltac:(here; lra)) as (x & yy & F & Lg & O); exact (Hno i Hi x O).
Qed.
End Words.
