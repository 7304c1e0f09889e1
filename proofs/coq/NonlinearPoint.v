(** * At one time of an arc: the flow is strictly differentiable in state, mu and time; and what is nearly done to
      differences of states as the linearized equation says has a matrix *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import StatementOrbits Contraction Derivatives NonlinearGronwall NonlinearFlow NonlinearKick.
From Grazing Require Import NonlinearMap NonlinearArc.
Open Scope R_scope.

Section Point.
Context {F : force}.
Variables (kk cc ll : R -> R).
Hypothesis HA : along_arc F kk cc ll.
Notation lin := (solves kk cc ll).
Let HT := HT. Let HL := HL.
Let Hbound := proj1 HA. Let Hstrict := proj1 (proj2 HA). Let Hexist := proj2 (proj2 HA).
Lemma lin_on m z w : lin m z w -> S.linearized T kk cc ll m z w. Proof. intros H x _; apply H. Qed.
Lemma lin_size m z w t : lin m z w -> Rabs (z 0) <= t -> Rabs (w 0) <= t -> Rabs m <= t -> forall s, 0 <= s <= T ->
  Rabs (z s) <= M * t /\ Rabs (w s) <= M * t /\ Rabs (kk s * z s + cc s * w s + ll s * m) <= 3 * L * (M * t).
Proof.
  intros Z H0 H1 Hm s Hs; pose proof (S.linear_bound T L kk cc ll HL Hbound m z w (lin_on m z w Z) s Hs) as B; pose
    proof M_large as LM; unfold M in *; set (k := 2 * (1 + L) * exp ((2 * L + 1) * T)) in *.
  assert (k * (Rabs (z 0) + Rabs (w 0) + Rabs m) <= k * (3 * t)) by (apply Rmult_le_compat_l; lra).
  pose proof (Rabs_pos (z s)); pose proof (Rabs_pos (w s)); pose proof (Rabs_pos m).
  assert (Q : Rabs (z s) <= 3 * k * t /\ Rabs (w s) <= 3 * k * t) by lra; split; [lra | split; [lra|]].
  destruct (Hbound s Hs) as (B1 & B2 & B3); pose proof (product _ _ _ _ B1 (proj1 Q)); pose proof (product _ _ _ _ B2
    (proj2 Q)); pose proof (product _ _ _ _ B3 Hm). assert (1 * t <= 3 * k * t) by (apply Rmult_le_compat_r; lra).
  assert (L * t <= L * (3 * k * t)) by (apply Rmult_le_compat_l; lra). eapply Rle_trans; [apply Rabs_triang|];
    eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang|]; lra.
Qed.
Lemma lin_same m z w z' w' s : lin m z w -> lin m z' w' -> 0 <= s <= T -> z s = z' s -> w s = w' s -> z 0 = z' 0 /\
  w 0 = w' 0.
Proof.
  intros H H' Hs E1 E2; assert (Hu : S.linearized T kk cc ll 0 (fun t => z t - z' t) (fun t => w t - w' t)).
  { intros t _; destruct (H t) as [A B], (H' t) as [A' B']; split; [apply D_minus; assumption|]; eapply D_value; [apply
    D_minus; eassumption | ring]. }
  pose proof (S.linear_back T L kk cc ll HL Hbound _ _ Hu s Hs) as Q; cbv beta in Q; rewrite E1, E2, !Rminus_eq_0,
    Rabs_R0 in Q. pose proof (Rabs_pos (z 0 - z' 0)); pose proof (Rabs_pos (w 0 - w' 0)); split; apply
    Rminus_diag_uniq, Rabs_zero; lra.
Qed.
(** The flow is strictly differentiable in state, mu and time. *)
Variables (s0 rho : R).
Hypothesis Hrho : 0 < rho /\ 0 <= s0 - rho /\ s0 + rho <= T.
Notation acc0 := (a s0 (y0 s0) (v0 s0) 0).
Lemma in_time s d : d <= rho -> Rabs (s - s0) <= d -> 0 <= s <= T.
Proof. intros Hd H; apply le_abs in H; lra. Qed.
Lemma steady_point eps : 0 < eps -> exists d, 0 < d <= rho /\ forall x mu s, within 2 d x -> Rabs mu <= d ->
  Rabs (s - s0) <= d -> Rabs (V x mu s - v0 s0) <= eps /\ Rabs (a s (Y x mu s) (V x mu s) mu - acc0) <= eps.
Proof.
  intros He; pose proof M_large as LM; set (q := eps / (8 * L)); assert (Hq : 0 < q) by (apply Rdiv_lt_0_compat; lra).
  assert (Lq : L * q = eps / 8) by (unfold q; field; lra). assert (q8 : 8 * q <= eps).
  { assert (1 * q <= L * q) by (apply Rmult_le_compat_r; lra); lra. }
  destruct (Horb s0) as [D1 D2]; destruct (continuous_near y0 s0 q (D_continuous _ _ _ D1) Hq) as (r1 & R1 & C1),
    (continuous_near v0 s0 q (D_continuous _ _ _ D2) Hq) as (r2 & R2 & C2).
  destruct (two_least r1 r2 R1 R2) as (r3 & R3 & L1 & L2), (two_least r3 q R3 Hq) as (r4 & R4 & L3 & L4), (two_least r4
    rho R4 ltac:(lra)) as (r5 & R5 & L5 & L6), (two_least r5 (q / M) R5 ltac:(apply Rdiv_lt_0_compat; lra)) as (d & Hd &
    L7 & L8). assert (Md : M * d <= q) by (apply Rle_trans with (M * (q / M)); [apply Rmult_le_compat_l; lra | right;
    field; lra]). exists d; split; [lra|]; intros x mu s Hx Hm Hs; assert (It : 0 <= s <= T) by (apply (in_time s d);
    lra). destruct (near_y0 x mu _ s Hx Hm It) as [A B]; pose proof (C1 s ltac:(lra)) as E1; pose proof (C2 s
    ltac:(lra)) as E2. pose proof (sum_apart _ _ _ _ _ A E1) as A'; pose proof (sum_apart _ _ _ _ _ B E2) as B'.
  split; [lra|]; eapply Rle_trans; [apply Ha|]; rewrite Rminus_0_r. apply Rle_trans with (L * (8 * q)); [apply
    Rmult_le_compat_l; lra | lra].
Qed.
Lemma flow_point eps : 0 < eps -> exists d, 0 < d <= rho /\ forall x x' mu mu' t s s' z w, within 2 d x -> within 2 d x'
  -> Rabs mu <= d -> Rabs mu' <= d -> Rabs (s - s0) <= d -> Rabs (s' - s0) <= d -> within 2 t (minus x x') ->
  Rabs (mu - mu') <= t -> lin (mu - mu') z w -> z 0 = x 0%nat - x' 0%nat -> w 0 = x 1%nat - x' 1%nat ->
  Rabs (Y x mu s - Y x' mu' s' - (z s0 + v0 s0 * (s - s'))) <= eps * (t + Rabs (s - s')) /\
  Rabs (V x mu s - V x' mu' s' - (w s0 + acc0 * (s - s'))) <= eps * (t + Rabs (s - s')).
Proof.
  intros He; pose proof M_large as LM; destruct (steady_point eps He) as (d1 & Hd1 & Hs1).
  destruct (S.flow_strict a T L y0 v0 kk cc ll HL Hlip Hbound Hstrict (sol_in 0 y0 v0 Horb) (eps / 6) ltac:(lra))
    as (d2 & Hd2 & Fs).
  destruct (two_least d1 d2 ltac:(lra) Hd2) as (d3 & Hd3 & L1 & L2), (two_least d3 (eps / (6 * L * M)) Hd3) as (d & Hd &
    L3 & L4); [apply Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]|].
  assert (Ld : 3 * L * M * d <= eps / 2).
  { apply Rle_trans with (3 * L * M * (eps / (6 * L * M))); [apply Rmult_le_compat_l; [|exact L4] | right; field; lra].
    apply Rmult_le_pos; lra. }
  assert (Md : M * d <= eps / 2) by (assert (0 <= M * d) by (apply Rmult_le_pos; lra); assert (1 * (M * d) <= L * (M *
    d)) by (apply Rmult_le_compat_r; lra); lra).
  exists d; split; [lra|]; intros x x' mu mu' t s s' z w Hx Hx' Hm Hm' Hs Hs' Ht Htm Z Ez Ew.
  assert (Is : 0 <= s <= T) by (apply (in_time s d); lra); assert (Is' : 0 <= s' <= T) by (apply (in_time s' d); lra).
  pose proof (Ht 0%nat ltac:(lia)) as T0; pose proof (Ht 1%nat ltac:(lia)) as T1; unfold minus in T0, T1.
  pose proof (Rabs_pos (mu - mu')) as Pm; assert (t0 : 0 <= t) by lra.
  destruct (flow x mu) as (S1 & E1 & E2), (flow x' mu') as (S2 & E3 & E4).
  pose proof (Hx 0%nat ltac:(lia)) as X0; pose proof (Hx 1%nat ltac:(lia)) as X1; pose proof (Hx' 0%nat ltac:(lia)) as
    X2; pose proof (Hx' 1%nat ltac:(lia)) as X3.
  assert (R0 : forall u v, u + v - u = v) by (intros; ring); assert (R1 : forall u v w, u + v - (u + w) = v - w) by
    (intros; ring).
  pose proof (Fs mu mu' _ _ _ _ z w (sol_in _ _ _ S1) (sol_in _ _ _ S2) (lin_on _ _ _ Z)) as Q; rewrite E1, E2, E3, E4,
    !R0, !R1 in Q. specialize (Q Ez Ew ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) s Is); cbv beta
    in Q. assert (Q' : eps / 6 * (Rabs (x 0%nat - x' 0%nat) + Rabs (x 1%nat - x' 1%nat) + Rabs (mu - mu')) <= eps / 6 *
    (3 * t)) by (apply Rmult_le_compat_l; lra).
  assert (Lz : forall s, 0 <= s <= T -> Rabs (w s) <= M * t /\ Rabs (kk s * z s + cc s * w s + ll s * (mu - mu')) <= 3 *
    L * (M * t)) by (intros u Hu; apply (lin_size (mu - mu') z w t Z); try lra; [rewrite Ez | rewrite Ew]; assumption).
  assert (I0 : 0 <= s0 <= T) by lra.
  pose proof (mvt_on T z w (M * t) s s0 Is I0 ltac:(intros u Hu; split; [apply Z | apply Lz, Hu])) as Z1.
  pose proof (mvt_on T w (fun u => kk u * z u + cc u * w u + ll u * (mu - mu')) (3 * L * (M * t)) s s0 Is I0
    ltac:(intros u Hu; split; [apply Z | apply Lz, Hu])) as Z2.
  assert (Z3 : M * t * Rabs (s - s0) <= eps / 2 * t).
  { apply Rle_trans with (M * t * d); [apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra|]. replace (M * t * d) with
    (M * d * t) by ring; apply Rmult_le_compat_r; lra. }
  assert (Z4 : 3 * L * (M * t) * Rabs (s - s0) <= eps / 2 * t).
  { apply Rle_trans with (3 * L * (M * t) * d); [apply Rmult_le_compat_l; [apply Rmult_le_pos; [|apply Rmult_le_pos];
    lra | lra]|]. replace (3 * L * (M * t) * d) with (3 * L * M * d * t) by ring; apply Rmult_le_compat_r; lra. }
  assert (Wi : forall u, within 2 d u -> within 2 d1 u) by (intros u Hu i Hi; specialize (Hu i Hi); lra).
  assert (N1 : Rabs (Y x' mu' s - Y x' mu' s' - v0 s0 * (s - s')) <= eps * Rabs (s - s')).
  { apply (NonlinearSmooth.near_line (Y x' mu') (V x' mu') (v0 s0) eps s0 d s s'); trivial; intros u Hu; split; [apply
      S2|]. apply Hs1; [apply Wi, Hx' | lra | lra]. }
  assert (N2 : Rabs (V x' mu' s - V x' mu' s' - acc0 * (s - s')) <= eps * Rabs (s - s')).
  { apply (NonlinearSmooth.near_line (V x' mu') (fun u => a u (Y x' mu' u) (V x' mu' u) mu') acc0 eps s0 d s s');
      trivial; intros u Hu; split; [apply S2|]. apply Hs1; [apply Wi, Hx' | lra | lra]. }
  pose proof (Rabs_pos (Y x mu s - Y x' mu' s - z s)); pose proof (Rabs_pos (V x mu s - V x' mu' s - w s)).
  rewrite Rmult_plus_distr_l; split.
  - replace (Y x mu s - Y x' mu' s' - (z s0 + v0 s0 * (s - s'))) with ((Y x mu s - Y x' mu' s - z s) + (z s - z s0) + (Y
      x' mu' s - Y x' mu' s' - v0 s0 * (s - s'))) by ring. eapply Rle_trans; [apply Rabs_triang|]; eapply Rle_trans;
      [apply Rplus_le_compat_r, Rabs_triang|]; lra.
  - replace (V x mu s - V x' mu' s' - (w s0 + acc0 * (s - s'))) with ((V x mu s - V x' mu' s - w s) + (w s - w s0) + (V
      x' mu' s - V x' mu' s' - acc0 * (s - s'))) by ring. eapply Rle_trans; [apply Rabs_triang|]; eapply Rle_trans;
      [apply Rplus_le_compat_r, Rabs_triang|]; lra.
Qed.
Lemma flow_lip : exists d C, 0 < d <= rho /\ 1 <= C /\ forall x x' mu mu' t s s', within 2 d x -> within 2 d x' ->
  Rabs mu <= d -> Rabs mu' <= d -> Rabs (s - s0) <= d -> Rabs (s' - s0) <= d -> within 2 t (minus x x') ->
  Rabs (mu - mu') <= t -> Rabs (Y x mu s - Y x' mu' s') <= C * (t + Rabs (s - s')) /\
  Rabs (V x mu s - V x' mu' s') <= C * (t + Rabs (s - s')).
Proof.
  destruct (flow_point 1 ltac:(lra)) as (d & Hd & H); pose proof M_large as LM; set (C := 1 + M + Rabs (v0 s0) + Rabs
    acc0). exists d, C; pose proof (Rabs_pos (v0 s0)) as P1; pose proof (Rabs_pos acc0) as P2; split; [exact Hd | split;
    [unfold C; lra|]]. intros x x' mu mu' t s s' Hx Hx' Hm Hm' Hs Hs' Ht Htm.
  destruct (Hexist (mu - mu') 0 (x 0%nat - x' 0%nat) (x 1%nat - x' 1%nat)) as (z & w & Z & Ez & Ew).
  destruct (H x x' mu mu' t s s' z w Hx Hx' Hm Hm' Hs Hs' Ht Htm Z Ez Ew) as [A B].
  destruct (lin_size (mu - mu') z w t Z) with (s := s0) as (B1 & B2 & _); try lra; [rewrite Ez; apply (Ht 0%nat); lia |
    rewrite Ew; apply (Ht 1%nat); lia|]. pose proof (Rabs_pos (mu - mu')); pose proof (Rabs_pos (s - s')) as P3.
  assert (Q : forall p q g, Rabs g <= Rabs (v0 s0) + Rabs acc0 -> Rabs q <= M * t -> Rabs (p - (q + g * (s - s'))) <= 1
    * (t + Rabs (s - s')) -> Rabs p <= C * (t + Rabs (s - s'))).
  { intros p q g G1 Hq Hp; replace p with ((p - (q + g * (s - s'))) + (q + g * (s - s'))) by ring; eapply Rle_trans;
      [apply Rabs_triang|]. pose proof (Rabs_triang q (g * (s - s'))); rewrite Rabs_mult in *.
    assert (Rabs g * Rabs (s - s') <= (Rabs (v0 s0) + Rabs acc0) * Rabs (s - s')) by (apply Rmult_le_compat_r; lra).
    assert (0 <= (Rabs (v0 s0) + Rabs acc0) * t) by (apply Rmult_le_pos; lra); assert (0 <= M * Rabs (s - s')) by (apply
      Rmult_le_pos; lra); unfold C; lra. }
  split; [apply (Q _ (z s0) (v0 s0)) | apply (Q _ (w s0) acc0)]; trivial; lra.
Qed.
End Point.

Definition small r (x : vec) mu := within 2 r x /\ Rabs mu <= r.
Lemma small_less r r' x mu : small r x mu -> r <= r' -> small r' x mu.
Proof. intros [A B] O; split; [intros i Hi; specialize (A i Hi)|]; lra. Qed.
Lemma small_zero r : 0 <= r -> small r zero 0.
Proof. intros Hr; split; [intros i _; unfold zero|]; rewrite Rabs_R0; lra. Qed.
Lemma lin_forward F kk cc ll (HA : @along_arc F kk cc ll) m z w z2 w2 s : solves kk cc ll m z w -> solves kk cc ll m z2
  w2 -> 0 <= s <= @T F -> z 0 = z2 0 -> w 0 = w2 0 -> z s = z2 s /\ w s = w2 s.
Proof.
  intros H H' Hs E1 E2; assert (Hu : S.linearized (@T F) kk cc ll 0 (fun t => z t - z2 t) (fun t => w t - w2 t)).
  { intros t _; destruct (H t) as [A B], (H' t) as [A' B']; split; [apply D_minus; assumption|]; eapply D_value; [apply
    D_minus; eassumption | ring]. }
  pose proof (S.linear_bound (@T F) (@L F) kk cc ll (@HL F) (proj1 HA) 0 _ _ Hu s Hs) as Q; cbv beta in Q; rewrite E1,
    E2, !Rminus_eq_0, Rabs_R0 in Q. pose proof (Rabs_pos (z s - z2 s)); pose proof (Rabs_pos (w s - w2 s)); split; apply
    Rminus_diag_uniq, Rabs_zero; lra.
Qed.
Lemma lin_three k c l m z1 w1 z2 w2 z3 w3 x y : solves k c l 0 z1 w1 -> solves k c l 0 z2 w2 -> solves k c l 1 z3 w3 ->
  solves k c l m (fun t => x * z1 t + y * z2 t + m * z3 t) (fun t => x * w1 t + y * w2 t + m * w3 t).
Proof.
  intros H1 H2 H3 t; destruct (H1 t) as [A1 B1], (H2 t) as [A2 B2], (H3 t) as [A3 B3]; split.
  - apply D_plus; [apply D_plus|]; apply D_scale; assumption.
  - eapply D_value; [apply D_plus; [apply D_plus|]; apply D_scale; eassumption | ring].
Qed.

(** A map G of states that nearly does what J, linear, does with solutions of the linearized equation has a matrix. *)
Section Matrix.
Variables (F : force) (kk cc ll kk' cc' ll' : R -> R).
Notation lin := (solves kk cc ll). Notation lin' := (solves kk' cc' ll').
Hypothesis HA : @along_arc F kk cc ll.
Variables (G : vec -> R -> vec) (J : R -> (R -> R) -> (R -> R) -> (R -> R) -> (R -> R) -> Prop).
Hypothesis Grest : forall i, (i < 2)%nat -> G zero 0 i = 0.
Hypothesis Gstrict : forall eps, 0 < eps -> exists d, 0 < d /\ forall x x' mu mu' t z w z' w', small d x mu ->
  small d x' mu' -> within 2 t (minus x x') -> Rabs (mu - mu') <= t -> lin (mu - mu') z w ->
  z 0 = x 0%nat - x' 0%nat -> w 0 = x 1%nat - x' 1%nat -> lin' (mu - mu') z' w' -> J (mu - mu') z w z' w' ->
  Rabs (G x mu 0%nat - G x' mu' 0%nat - z' 0) <= eps * t /\ Rabs (G x mu 1%nat - G x' mu' 1%nat - w' 0) <= eps * t.
Hypothesis Jexists : forall m z w, exists z' w', lin' m z' w' /\ J m z w z' w'.
Hypothesis Jthree : forall m x y p1 q1 p2 q2 p3 q3 z1 w1 z2 w2 z3 w3, J 0 p1 q1 z1 w1 -> J 0 p2 q2 z2 w2 ->
  J 1 p3 q3 z3 w3 -> J m (fun t => x * p1 t + y * p2 t + m * p3 t) (fun t => x * q1 t + y * q2 t + m * q3 t)
  (fun t => x * z1 t + y * z2 t + m * z3 t) (fun t => x * w1 t + y * w2 t + m * w3 t).
Hypothesis Jone : forall m z w z2 w2 z' w' z2' w2', lin m z w -> lin m z2 w2 -> z 0 = z2 0 -> w 0 = w2 0 ->
  J m z w z' w' -> J m z2 w2 z2' w2' -> lin' m z' w' -> lin' m z2' w2' -> z' 0 = z2' 0 /\ w' 0 = w2' 0.
Theorem matrix_exists : exists (A : nat -> vec) (phi : vec), (forall i, (i < 2)%nat -> strict 2 (fun x mu => G x mu i)
  (dot 2 (A i)) (phi i)) /\ forall m z w z' w', lin m z w -> lin' m z' w' -> J m z w z' w' ->
  z' 0 = A 0%nat 0%nat * z 0 + A 0%nat 1%nat * w 0 + m * phi 0%nat /\
  w' 0 = A 1%nat 0%nat * z 0 + A 1%nat 1%nat * w 0 + m * phi 1%nat.
Proof.
  destruct (proj2 (proj2 HA) 0 0 1 0) as (p1 & q1 & F1 & I1 & J1), (proj2 (proj2 HA) 0 0 0 1) as (p2 & q2 & F2 & I2 &
    J2), (proj2 (proj2 HA) 1 0 0 0) as (p3 & q3 & F3 & I3 & J3).
  destruct (Jexists 0 p1 q1) as (z1 & w1 & Z1 & X1), (Jexists 0 p2 q2) as (z2 & w2 & Z2 & X2), (Jexists 1 p3 q3) as (z3
    & w3 & Z3 & X3).
  exists (fun i : nat => match i with O => pair (z1 0) (z2 0) | _ => pair (w1 0) (w2 0) end), (pair (z3 0) (w3 0)).
  assert (E : forall m x y, x * p1 0 + y * p2 0 + m * p3 0 = x /\ x * q1 0 + y * q2 0 + m * q3 0 = y) by (intros; rewrite
    I1, I2, I3, J1, J2, J3; split; ring).
  split.
  - intros i Hi; split; [apply Grest, Hi|]; intros eps Hp; destruct (Gstrict eps Hp) as (d & Hd & H); exists
      d; split; [lra|]; intros x x' mu mu' t Hx Hx' Hm Hm' Hxt Hmt.
    set (a0 := x 0%nat - x' 0%nat); set (a1 := x 1%nat - x' 1%nat); destruct (E (mu - mu') a0 a1) as [E1 E2].
    destruct (H x x' mu mu' t _ _ _ _ (conj Hx Hm) (conj Hx' Hm') Hxt Hmt (lin_three kk cc ll (mu - mu') p1 q1 p2 q2 p3
      q3 a0 a1 F1 F2 F3) E1 E2 (lin_three kk' cc' ll' (mu - mu') z1 w1 z2 w2 z3 w3 a0 a1 Z1 Z2 Z3) (Jthree (mu - mu') a0
      a1 _ _ _ _ _ _ _ _ _ _ _ _ X1 X2 X3)) as [Q1 Q2]; cbv beta in Q1, Q2.
    destruct i as [|[|i]]; [| |lia]; cbn; unfold minus; fold a0 a1; [match goal with |- Rabs ?g <= _ => match type of Q1
      with Rabs ?u <= _ => replace g with u by ring end end; exact Q1 | match goal with |- Rabs ?g <= _ => match type of
      Q2 with Rabs ?u <= _ => replace g with u by ring end end; exact Q2].
  - intros m z w z' w' Z Z' Jz; destruct (E m (z 0) (w 0)) as [E1 E2].
    destruct (Jone m z w _ _ z' w' _ _ Z (lin_three kk cc ll m p1 q1 p2 q2 p3 q3 (z 0) (w 0) F1 F2 F3) (eq_sym E1)
      (eq_sym E2) Jz (Jthree m (z 0) (w 0) _ _ _ _ _ _ _ _ _ _ _ _ X1 X2 X3) Z' (lin_three kk' cc' ll' m z1 w1 z2 w2 z3
      w3 (z 0) (w 0) Z1 Z2 Z3)) as [E3 E4]; cbv beta in E3, E4; rewrite E3, E4; unfold pair; split; ring.
Qed.
End Matrix.
