(** * The map of section 3.1 is a smooth grazing map of the plane, whatever strictly differentiable map
      carries a state from the touch once around to the next one *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import StatementOrbits StatementOrbitsPlane OrbitRemainder PlaneOrbits Contraction Derivatives.
From Grazing Require Import NonlinearGronwall NonlinearStrict NonlinearFlow NonlinearTouch NonlinearSpeed NonlinearKick.
Open Scope R_scope.
Section Map.
Context {the_force : force} {the_touch : touch the_force} {the_window : near the_touch} {the_impact : impact the_touch}.
Let HT := HT. Let HL := HL. Let HtG := HtG. Let Hg := Hg. Let Hd0 := Hd0.
Notation lin := (solves kk cc ll).
Definition pair (p q : R) : vec := fun i => match i with O => p | _ => q end.
Lemma low_rest : low zero 0 = tG.
Proof.
  destruct zero_box as (B0 & _ & _ & V0); pose proof (proj1 Hwin) as Hr; destruct (low_spec zero 0 B0) as (_ & _ & U);
    symmetry; apply U; [rewrite Rminus_eq_0, Rabs_R0; lra | exact V0].
Qed.
(** The difference of two solutions is nearly this solution of the linearized equation. *)
Definition dz (x x' : vec) mu mu' s := (x 0%nat - x' 0%nat) * p1 s + (x 1%nat - x' 1%nat) * p2 s + (mu - mu') * p3 s.
Definition dw (x x' : vec) mu mu' s := (x 0%nat - x' 0%nat) * q1 s + (x 1%nat - x' 1%nat) * q2 s + (mu - mu') * q3 s.
Lemma differences eps : 0 < eps -> exists d, 0 < d <= d0 /\ forall x x' mu mu' t, within 2 d x -> within 2 d x' ->
  Rabs mu <= d -> Rabs mu' <= d -> within 2 t (minus x x') -> Rabs (mu - mu') <= t -> (forall s, 0 <= s <= T ->
  derivable_pt_lim (dz x x' mu mu') s (dw x x' mu mu' s) /\ Rabs (dw x x' mu mu' s) <= M * t) /\ forall s,
  0 <= s <= T -> Rabs (Y x mu s - Y x' mu' s - dz x x' mu mu' s) <= eps * t /\ Rabs (V x mu s - V x' mu' s - dw x x' mu
  mu' s) <= eps * t.
Proof.
  intros He; destruct Hfund as ((F1 & I1 & J1) & (F2 & I2 & J2) & (F3 & I3 & J3)).
  destruct (S.flow_strict a T L y0 v0 kk cc ll HL Hlip Hbound Hstrict (sol_in 0 y0 v0 Horb) (eps / 3) ltac:(here; lra))
    as (d1 & Hd1 & Fs). assert (Hd0' : 0 < d0) by apply Hwin; destruct (two_least d1 d0 Hd1 Hd0') as (d & Hd & L1 & L2);
    exists d; split; [lra|]. intros x x' mu mu' t Hx Hx' Hm Hm' Ht Htm; set (z := dz x x' mu mu');
    set (w := dw x x' mu mu'); destruct (flow x mu) as (S1 & E1 & E2), (flow x' mu') as (S2 & E3 & E4).
  assert (Z : S.linearized T kk cc ll (mu - mu') z w).
  { intros s _; destruct (F1 s) as [A1 B1], (F2 s) as [A2 B2], (F3 s) as [A3 B3]; unfold z, w, dz, dw; split.
    - apply D_plus; [apply D_plus|]; apply D_scale; assumption.
    - eapply D_value; [apply D_plus; [apply D_plus|]; apply D_scale; eassumption | ring]. }
  pose proof (Hx 0%nat ltac:(lia)); pose proof (Hx 1%nat ltac:(lia)); pose proof (Hx' 0%nat ltac:(lia));
    pose proof (Hx' 1%nat ltac:(lia)). pose proof (Ht 0%nat ltac:(lia)) as T0; pose proof (Ht 1%nat ltac:(lia)) as T1;
    unfold minus in T0, T1. assert (R0 : forall u v, u + v - u = v) by (intros; ring);
    assert (R1 : forall u v w, u + v - (u + w) = v - w) by (intros; ring).
  assert (Ez : z 0 = x 0%nat - x' 0%nat) by (unfold z, dz; rewrite I1, I2, I3; ring);
    assert (Ew : w 0 = x 1%nat - x' 1%nat) by (unfold w, dw; rewrite J1, J2, J3; ring). split.
  - intros s Hs; split; [apply Z, Hs|]; pose proof (S.linear_bound T L kk cc ll HL Hbound _ z w Z s Hs) as B;
      rewrite Ez, Ew in B; pose proof (Rabs_pos (z s)); pose proof M_large; unfold M in *.
    set (k := 2 * (1 + L) * exp ((2 * L + 1) * T)) in *.
    assert (k * (Rabs (x 0%nat - x' 0%nat) + Rabs (x 1%nat - x' 1%nat) + Rabs (mu - mu')) <= k * (3 * t))
      by (apply Rmult_le_compat_l; lra); lra.
  - intros s Hs; pose proof (Fs mu mu' _ _ _ _ z w (sol_in _ _ _ S1) (sol_in _ _ _ S2) Z) as Q;
      rewrite E1, E2, E3, E4, !R0, !R1 in Q.
    specialize (Q Ez Ew ltac:(here; lra) ltac:(here; lra) ltac:(here; lra) ltac:(here; lra) ltac:(here; lra) ltac:(here;
      lra) s Hs); cbv beta in Q.
    assert (eps / 3 * (Rabs (x 0%nat - x' 0%nat) + Rabs (x 1%nat - x' 1%nat) + Rabs (mu - mu')) <= eps / 3 * (3 * t))
      by (apply Rmult_le_compat_l; lra). pose proof (Rabs_pos (Y x mu s - Y x' mu' s - z s));
      pose proof (Rabs_pos (V x mu s - V x' mu' s - w s)); split; lra.
Qed.
Lemma low_strict : strict 2 (fun x mu => Y x mu (low x mu)) (dot 2 (pair (p1 tG) (p2 tG))) (p3 tG).
Proof.
  pose proof Hwin as (Hr & R1 & R2 & Hd & _); destruct zero_box as (B0 & _); pose proof M_large as LM.
  assert (Z0 : forall t, Y zero 0 t = y0 t /\ V zero 0 t = v0 t) by apply at_rest.
  split; [cbn; rewrite low_rest, (proj1 (Z0 tG)); apply Htouch|]; intros e He.
    destruct (differences (e / 2) ltac:(here; lra)) as (d1 & Hd1 & H); set (r := e / (2 * M));
      assert (Pr : 0 < r) by (apply Rdiv_lt_0_compat; lra).
    destruct (two_least d1 (3 * g * r / (4 * M)) ltac:(here; lra)) as (d & Hd2 & L1 & L2);
      [apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra|]; exists d; split; [exact Hd2|].
    intros x x' mu mu' t Hx Hx' Hm Hm' Ht Htm; pose proof (Rabs_pos (mu - mu')) as Pm.
    assert (Low : forall x mu, within 2 d x -> Rabs mu <= d -> box x mu /\ Rabs (low x mu - tG) <= r).
    { intros u m Hu Hm0; assert (Bx : box u m) by (split; [intros i Hi; specialize (Hu i Hi)|]; lra); split;
        [exact Bx|].
      pose proof (low_lip u m zero 0 d Bx B0 ltac:(here; intros i Hi; unfold minus, zero; rewrite Rminus_0_r;
        apply Hu, Hi) ltac:(here; rewrite Rminus_0_r; lra)) as A; rewrite low_rest in A.
      assert (4 * (M * d) <= 3 * g * r) by (apply Rle_trans with (4 * (M * (3 * g * r / (4 * M))));
        [apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra | right; field; lra]).
      apply Rmult_le_reg_l with (3 * g); lra. }
    destruct (Low x mu Hx Hm) as [Bx Lx], (Low x' mu' Hx' Hm') as [Bx' Lx'];
      destruct (low_spec x mu Bx) as (P1 & _), (low_spec x' mu' Bx') as (P2 & _).
    assert (W : forall u, within 2 d u -> within 2 d1 u) by (intros u Hu i Hi; specialize (Hu i Hi); lra).
    destruct (H x x' mu mu' t (W x Hx) (W x' Hx') ltac:(here; lra) ltac:(here; lra) Ht Htm) as (Dz & D).
    set (zz := dz x x' mu mu') in *; set (ww := dw x x' mu mu') in *.
    assert (Near : forall m, Rabs (m - tG) <= r -> Rabs (m - tG) <= r0 / 2 -> Rabs (Y x mu m - Y x' mu' m - zz tG) <=
      e * t).
    { intros m Hmr Hm2; assert (Im : 0 <= m <= T) by (apply (in_period r0); lra); destruct (D m Im) as [Q _].
      pose proof (mvt_on T zz ww (M * t) m tG Im ltac:(here; lra) Dz) as Q'.
      assert (M * t * Rabs (m - tG) <= M * t * r) by (apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra).
      assert (M * t * r = e / 2 * t) by (unfold r; field; lra).
      replace (Y x mu m - Y x' mu' m - zz tG) with ((Y x mu m - Y x' mu' m - zz m) + (zz m - zz tG)) by ring;
        eapply Rle_trans; [apply Rabs_triang | lra]. }
    pose proof (le_abs _ _ (Near _ Lx P1)) as N1; pose proof (le_abs _ _ (Near _ Lx' P2)) as N2.
    pose proof (Y_above x mu (low x' mu') Bx ltac:(here; lra)) as U1;
      pose proof (Y_above x' mu' (low x mu) Bx' ltac:(here; lra)) as U2; cbv zeta in U1, U2.
    assert (Sq : forall s, 0 <= 3 / 8 * g * (s * s)) by (intros s; apply Rmult_le_pos; [lra | apply Rle_0_sqr]).
    pose proof (Sq (low x' mu' - low x mu)); pose proof (Sq (low x mu - low x' mu')); cbn; unfold minus.
    match goal with |- Rabs ?u <= _ => replace u with (Y x mu (low x mu) - Y x' mu' (low x' mu') - zz tG)
      by (unfold zz, dz; ring) end; apply Rabs_le; lra.
Qed.
Lemma lin_comb m z w s : lin m z w -> 0 <= s <= T -> z s = z 0 * p1 s + w 0 * p2 s + m * p3 s /\
  w s = z 0 * q1 s + w 0 * q2 s + m * q3 s.
Proof.
  intros H Hs; destruct Hfund as ((F1 & I1 & J1) & (F2 & I2 & J2) & (F3 & I3 & J3)).
  set (u t := z t - (z 0 * p1 t + w 0 * p2 t + m * p3 t)); set (v t := w t - (z 0 * q1 t + w 0 * q2 t + m * q3 t)).
  assert (Hu : S.linearized T kk cc ll 0 u v).
  { intros t _; destruct (H t) as [A A'], (F1 t) as [X1 X1'], (F2 t) as [X2 X2'], (F3 t) as [X3 X3']; split;
      unfold u, v.
    - apply D_minus; [exact A | apply D_plus; [apply D_plus|]; apply D_scale; assumption].
    - eapply D_value; [apply D_minus; [exact A' | apply D_plus; [apply D_plus|]; apply D_scale; eassumption] | ring]. }
  pose proof (S.linear_bound T L kk cc ll HL Hbound 0 u v Hu s Hs) as Q.
  assert (U0 : u 0 = 0) by (unfold u; rewrite I1, I2, I3; ring); assert (V0 : v 0 = 0) by (unfold v; rewrite J1, J2, J3;
    ring). rewrite U0, V0, Rabs_R0 in Q; pose proof (Rabs_pos (u s)); pose proof (Rabs_pos (v s)). split; apply
    Rminus_diag_uniq, Rabs_zero; [change (Rabs (u s) <= 0) | change (Rabs (v s) <= 0)]; lra.
Qed.
(** (11) to (14): trace and determinant do not depend on the section. *)
Lemma similar P11 P12 P21 P22 A11 A12 A21 A22 B11 B12 B21 B22 : P11 * P22 - P12 * P21 <> 0 ->
  P11 * B11 + P12 * B21 = A11 * P11 + A12 * P21 -> P11 * B12 + P12 * B22 = A11 * P12 + A12 * P22 ->
  P21 * B11 + P22 * B21 = A21 * P11 + A22 * P21 -> P21 * B12 + P22 * B22 = A21 * P12 + A22 * P22 ->
  A11 + A22 = B11 + B22 /\ A11 * A22 - A12 * A21 = B11 * B22 - B12 * B21.
Proof.
  intros N E1 E2 E3 E4; split; apply (Rmult_eq_reg_l (P11 * P22 - P12 * P21)); trivial.
  - transitivity (P22 * (A11 * P11 + A12 * P21) - P12 * (A21 * P11 + A22 * P21) + (P11 * (A21 * P12 + A22 * P22) - P21 *
      (A11 * P12 + A12 * P22))); [ring|]. rewrite <- E1, <- E2, <- E3, <- E4; ring.
  - transitivity ((A11 * P11 + A12 * P21) * (A21 * P12 + A22 * P22) - (A11 * P12 + A12 * P22) *
      (A21 * P11 + A22 * P21)); [ring|]. rewrite <- E1, <- E2, <- E3, <- E4; ring.
Qed.
Lemma regular v1 v2 : v1 * p1 tG + v2 * p2 tG = 0 -> v1 * q1 tG + v2 * q2 tG = 0 -> v1 = 0 /\ v2 = 0.
Proof.
  intros E1 E2; destruct Hfund as ((F1 & I1 & J1) & (F2 & I2 & J2) & _).
  assert (Hu : S.linearized T kk cc ll 0 (fun t => v1 * p1 t + v2 * p2 t) (fun t => v1 * q1 t + v2 * q2 t)).
  { intros t _; destruct (F1 t) as [X1 X1'], (F2 t) as [X2 X2']; split.
    - apply D_plus; apply D_scale; assumption.
    - eapply D_value; [apply D_plus; apply D_scale; eassumption | ring]. }
  pose proof (S.linear_back T L kk cc ll HL Hbound _ _ Hu tG ltac:(here; lra)) as Q; cbv beta in Q;
    rewrite E1, E2, I1, I2, J1, J2, Rabs_R0 in Q. pose proof (Rabs_pos (v1 * 1 + v2 * 0));
    pose proof (Rabs_pos (v1 * 0 + v2 * 1)). assert (Z1 : v1 * 1 + v2 * 0 = 0) by (apply Rabs_zero; lra);
    assert (Z2 : v1 * 0 + v2 * 1 = 0) by (apply Rabs_zero; lra); lra.
Qed.
Lemma det_flow : p1 tG * q2 tG - p2 tG * q1 tG <> 0.
Proof.
  intros E; destruct (regular (p2 tG) (- p1 tG) ltac:(here; ring) ltac:(here; lra)) as [A A'].
  destruct (regular (q2 tG) (- q1 tG) ltac:(here; lra) ltac:(here; ring)) as [A1 A1']. destruct (regular 1 0);
    [lra | lra | lra].
Qed.

End Map.

(** Once around: f, with the derivative FA in the state and Fphi in mu; K is a Lipschitz constant of f, and of
    the flow. *)
Class turn (F : force) := { f : vec -> R -> vec; K : R; FA : nat -> vec; Fphi : vec; HK : M <= K;
  f_lip : forall x x' mu mu' r, within 2 r (minus x x') -> Rabs (mu - mu') <= r ->
    within 2 (K * r) (minus (f x mu) (f x' mu'));
  f_strict : forall i, (i < 2)%nat -> strict 2 (fun x mu => f x mu i) (dot 2 (FA i)) (Fphi i) }.
Section Turn.
Context {the_force : force} {the_touch : touch the_force} {the_window : near the_touch} {the_impact : impact the_touch}
  {the_turn : turn the_force}.
Let HT := HT. Let HL := HL. Let HtG := HtG. Let Hg := Hg. Let Hd0 := Hd0.
Notation lin := (solves kk cc ll).
Definition map : Map.t := {| Map.N := 2; Map.f := f; Map.h := fun x mu => Y x mu (low x mu); Map.kick := kick;
  Map.A := FA; Map.phi := Fphi; Map.C := pair (p1 tG) (p2 tG); Map.eta := p3 tG; Map.B := B |}.
Lemma map_smooth : smooth map.
Proof.
  split; [exact f_strict | split; [exact low_strict|]].
  intros e He; destruct (kick_strict e He) as (d & Hd1 & K1); exists d; split; [lra|]; exact K1.
Qed.

(** (z, w), a solution for a change m of mu, is (z', w') once around. *)
Definition carried (m : R) (z w z' w' : R -> R) : Prop := lin m z' w' /\
  z' 0 = FA 0%nat 0%nat * z 0 + FA 0%nat 1%nat * w 0 + m * Fphi 0%nat /\
  w' 0 = FA 1%nat 0%nat * z 0 + FA 1%nat 1%nat * w 0 + m * Fphi 1%nat.
Theorem map_planar A11 A21 A22 gamma z w : (forall z w, lin 0 z w -> exists z' w', carried 0 z w z' w' /\
  z' tG = A11 * z tG + gamma * w tG /\ w' tG = A21 * z tG + A22 * w tG) -> gamma <> 0 -> lin 1 z w ->
  carried 1 z w z w -> z tG <> 0 ->
  planar map (A11 + A22) (A11 * A22 - gamma * A21) ((1 + tau) * cg * gamma) (z tG) (pair (z 0) (w 0)).
Proof.
  intros HA Hgam Hz (_ & Ez & Ew) Hr; assert (TG : 0 <= tG <= T) by lra; pose proof cg_pos as Hc; assert (Ht0 := proj1
    Hreb). pose proof Hfund as ((F1 & I1 & J1) & (F2 & I2 & J2) & _); destruct Hzb as (Zb & Zb1 & Zb2).
  assert (Sh : forall z w, lin 0 z w -> let x := FA 0%nat 0%nat * z 0 + FA 0%nat 1%nat * w 0 in
    let y := FA 1%nat 0%nat * z 0 + FA 1%nat 1%nat * w 0 in
    x * p1 tG + y * p2 tG = A11 * z tG + gamma * w tG /\ x * q1 tG + y * q2 tG = A21 * z tG + A22 * w tG).
  { intros u v Hu; destruct (HA u v Hu) as (u' & v' & (Hu' & E1 & E2) & E3 & E4);
      destruct (lin_comb 0 _ _ tG Hu' TG) as [E5 E6]; rewrite E1, E2 in E5, E6; cbv zeta; lra. }
  destruct (Sh _ _ F1) as [M1 M2], (Sh _ _ F2) as [M3 M4]; rewrite I1, J1 in M1, M2; rewrite I2, J2 in M3, M4.
  destruct (similar (p1 tG) (p2 tG) (q1 tG) (q2 tG) A11 gamma A21 A22 (FA 0%nat 0%nat) (FA 0%nat 1%nat) (FA 1%nat 0%nat)
    (FA 1%nat 1%nat) det_flow) as [Tr Dt]; [lra | lra | lra | lra|]. destruct (lin_comb 0 zb wb tG Zb TG) as [C1 C2];
    destruct (Sh _ _ Zb) as [S5 _]. destruct (lin_comb 1 z w tG Hz TG) as [C5 _]. constructor; cbn -[mult].
  - exact map_smooth.
  - reflexivity.
  - exact Tr.
  - exact Dt.
  - unfold B; replace (0 + p1 tG * ((1 + tau) * cg * zb 0) + p2 tG * ((1 + tau) * cg * wb 0)) with ((1 + tau) * cg * (zb
      0 * p1 tG + wb 0 * p2 tG + 0 * p3 tG)) by ring. rewrite <- C1, Zb1; ring.
  - split; [|apply Rmult_integral_contrapositive; split; [apply Rgt_not_eq, Rmult_lt_0_compat; lra | exact Hgam]].
    unfold mult; cbn; unfold B; rewrite Zb1, Zb2 in S5; cbv zeta in S5.
    replace gamma with ((FA 0%nat 0%nat * zb 0 + FA 0%nat 1%nat * wb 0) * p1 tG + (FA 1%nat 0%nat * zb 0 + FA 1%nat
      1%nat * wb 0) * p2 tG) by (rewrite S5; ring). ring.
  - intros i Hi; unfold mult; destruct i as [|[|i]]; [| |lia]; cbn; lra.
  - split; [rewrite C5; ring | exact Hr].
Qed.
End Turn.
