(** * A change of chart: at a fixed time place and velocity begin to be measured otherwise; the state of the arc in the
      new chart is strictly differentiable in that of the old *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import StatementOrbits Contraction Derivatives NonlinearGronwall NonlinearFlow NonlinearKick.
From Grazing Require Import NonlinearMap NonlinearArc NonlinearPoint.
Open Scope R_scope.

Section Change.
(** The arc of F is left at its time e for that of F' at its time rho: the place y becomes jy mu y, and the velocity v
    law mu 0 v. *)
Variables (F F' : force) (kk cc ll kk' cc' ll' : R -> R) (e rho Jm Jy Rm Rt Rv : R) (jy : R -> R -> R).
Variable law : R -> R -> R -> R.
Notation lin := (solves kk cc ll). Notation lin' := (solves kk' cc' ll').
Hypothesis HA : @along_arc F kk cc ll.
Hypothesis HA' : @along_arc F' kk' cc' ll'.
Hypothesis He : 0 < rho /\ 0 <= e - rho /\ e + rho <= @T F.
Hypothesis HT' : rho + rho <= @T F'.
Hypothesis Hen : @y0 F' rho = jy 0 (@y0 F e) /\ @v0 F' rho = law 0 0 (@v0 F e).
Hypothesis Hjy : forall eps, 0 < eps -> exists d, 0 < d /\ forall mu y mu' y', Rabs mu <= d -> Rabs mu' <= d ->
  Rabs (y - @y0 F e) <= d -> Rabs (y' - @y0 F e) <= d ->
  Rabs (jy mu y - jy mu' y' - (Jm * (mu - mu') + Jy * (y - y'))) <= eps * (Rabs (mu - mu') + Rabs (y - y')).
Hypothesis Hlaw : forall eps, 0 < eps -> exists d, 0 < d /\ forall mu s v mu' s' v', Rabs mu <= d -> Rabs s <= d ->
  Rabs (v - @v0 F e) <= d -> Rabs mu' <= d -> Rabs s' <= d -> Rabs (v' - @v0 F e) <= d ->
  Rabs (law mu s v - law mu' s' v' - (Rm * (mu - mu') + Rt * (s - s') + Rv * (v - v'))) <=
  eps * (Rabs (mu - mu') + Rabs (s - s') + Rabs (v - v')).
Let M_F := @M_large F. Let M_F' := @M_large F'.

Definition pass (x : vec) mu : vec := @origin F' mu rho (jy mu (@Y F x mu e)) (law mu 0 (@V F x mu e)).
Definition turnover (m : R) (z w z' w' : R -> R) : Prop := z' rho = Jm * m + Jy * z e /\ w' rho = Rm * m + Rv * w e.
Lemma pass_rest i : (i < 2)%nat -> pass zero 0 i = 0.
Proof.
  intros Hi; unfold pass; rewrite (proj1 (@at_rest F e)), (proj2 (@at_rest F e)), <- (proj1 Hen), <- (proj2 Hen).
  rewrite <- (proj1 (@at_rest F' rho)), <- (proj2 (@at_rest F' rho)); apply (@origin_same F' zero 0 rho i Hi).
Qed.
(** What the change does to differences, z and w being those of the linearized equation. *)
Lemma pass_differs eps : 0 < eps -> exists d, 0 < d /\ forall x x' mu mu' t z w, small d x mu -> small d x' mu' ->
  within 2 t (minus x x') -> Rabs (mu - mu') <= t -> lin (mu - mu') z w -> z 0 = x 0%nat - x' 0%nat ->
  w 0 = x 1%nat - x' 1%nat -> Rabs (jy mu (@Y F x mu e) - jy mu' (@Y F x' mu' e) - (Jm * (mu - mu') + Jy * z e)) <= eps
  * t /\ Rabs (law mu 0 (@V F x mu e) - law mu' 0 (@V F x' mu' e) - (Rm * (mu - mu') + Rv * w e)) <= eps * t.
Proof.
  intros Hp; set (K := 3 + @M F + Rabs Jy + Rabs Rv); pose proof (Rabs_pos Jy) as P1; pose proof (Rabs_pos Rv) as P2.
  assert (PK : 0 < K) by (unfold K; lra); destruct (two_least 1 (eps / K) ltac:(lra) ltac:(apply Rdiv_lt_0_compat; lra))
    as (e1 & He1 & L1 & L2). assert (Ke : K * e1 <= eps) by (apply Rle_trans with (K * (eps / K)); [apply
    Rmult_le_compat_l; lra | right; field; lra]).
  destruct (@flow_point F kk cc ll HA e rho He e1 He1) as (d1 & Hd1 & Pt), (Hjy e1 He1) as (d2 & Hd2 & Jp), (Hlaw e1
    He1) as (d3 & Hd3 & Lp), (two_least d2 d3 Hd2 Hd3) as (d4 & Hd4 & L3 & L4), (two_least d1 (d4 / @M F) ltac:(lra)
    ltac:(apply Rdiv_lt_0_compat; lra)) as (d & Hd & L5 & L6).
  assert (Md : @M F * d <= d4) by (apply Rle_trans with (@M F * (d4 / @M F)); [apply Rmult_le_compat_l; lra | right;
    field; lra]). assert (dM : d <= @M F * d) by (rewrite <- (Rmult_1_l d) at 1; apply Rmult_le_compat_r; lra).
  exists d; split; [exact Hd|]; intros x x' mu mu' t z w [Hx Hm] [Hx' Hm'] Ht Htm Z Ez Ew.
  assert (t0 : 0 <= t) by (pose proof (Rabs_pos (mu - mu')); lra); assert (Ze : Rabs 0 <= d4) by (rewrite Rabs_R0; lra).
  assert (Zd : Rabs (e - e) <= d1) by (rewrite Rminus_eq_0, Rabs_R0; lra).
  destruct (@near_y0 F x mu d e Hx Hm ltac:(lra)) as [N1 N2], (@near_y0 F x' mu' d e Hx' Hm' ltac:(lra)) as [N3 N4].
  destruct (Pt x x' mu mu' t e e z w) as [A1 A2]; trivial; try lra; try (intros i Hi; first [specialize (Hx i Hi); lra |
    specialize (Hx' i Hi); lra]).
  rewrite Rminus_eq_0, Rabs_R0, !Rmult_0_r, !Rplus_0_r in A1, A2.
  pose proof (Jp mu (@Y F x mu e) mu' (@Y F x' mu' e) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as B1; pose proof (Lp
    mu 0 (@V F x mu e) mu' 0 (@V F x' mu' e) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as B2.
  rewrite Rminus_eq_0, Rabs_R0, Rmult_0_r, !Rplus_0_r in B2.
  destruct (@nearby F x x' mu mu' t e Ht Htm ltac:(lra)) as [C1 C2].
  assert (Q : forall D c z p, Rabs (D - z) <= e1 * t -> Rabs D <= @M F * t -> Rabs c <= Rabs Jy + Rabs Rv -> Rabs p <= e1
    * (Rabs (mu - mu') + Rabs D) -> Rabs (p + c * (D - z)) <= eps * t).
  { intros D c q p H1 H2 H3 H4; pose proof (product c (D - q) _ _ H3 H1) as H5; assert (H6 : e1 * (Rabs (mu - mu') + Rabs
      D) <= e1 * (t + @M F * t)) by (apply Rmult_le_compat_l; lra). eapply Rle_trans; [apply Rabs_triang|]; apply
      Rle_trans with (K * e1 * t); [|apply Rmult_le_compat_r; lra]. assert (0 <= e1 * t) by (apply Rmult_le_pos; lra);
      unfold K; lra. }
  split; [replace (jy mu (@Y F x mu e) - jy mu' (@Y F x' mu' e) - (Jm * (mu - mu') + Jy * z e)) with (jy mu (@Y F x mu e)
    - jy mu' (@Y F x' mu' e) - (Jm * (mu - mu') + Jy * (@Y F x mu e - @Y F x' mu' e)) + Jy * (@Y F x mu e - @Y F x' mu' e
    - z e)) by ring | replace (law mu 0 (@V F x mu e) - law mu' 0 (@V F x' mu' e) - (Rm * (mu - mu') + Rv * w e)) with
    (law mu 0 (@V F x mu e) - law mu' 0 (@V F x' mu' e) - (Rm * (mu - mu') + Rv * (@V F x mu e - @V F x' mu' e)) + Rv *
    (@V F x mu e - @V F x' mu' e - w e)) by ring]; apply Q; trivial; lra.
Qed.
Theorem pass_strict eps : 0 < eps -> exists d, 0 < d /\ forall x x' mu mu' t z w z' w', small d x mu ->
  small d x' mu' -> within 2 t (minus x x') -> Rabs (mu - mu') <= t -> lin (mu - mu') z w ->
  z 0 = x 0%nat - x' 0%nat -> w 0 = x 1%nat - x' 1%nat -> lin' (mu - mu') z' w' -> turnover (mu - mu') z w z' w' ->
  Rabs (pass x mu 0%nat - pass x' mu' 0%nat - z' 0) <= eps * t /\
  Rabs (pass x mu 1%nat - pass x' mu' 1%nat - w' 0) <= eps * t.
Proof.
  intros Hp; set (B := Rabs Jm + Rabs Rm + (Rabs Jy + Rabs Rv) * @M F + 1).
  assert (PB : 1 <= B) by (pose proof (Rabs_pos Jm); pose proof (Rabs_pos Rm); pose proof (Rabs_pos Jy); pose proof
    (Rabs_pos Rv); assert (0 <= (Rabs Jy + Rabs Rv) * @M F) by (apply Rmult_le_pos; lra); unfold B; lra).
  set (K := @M F' * (2 * (@M F' * B + 1))); assert (PMB : 0 <= @M F' * B) by (apply Rmult_le_pos; lra); assert (PK : 0 <
    K) by (apply Rmult_lt_0_compat; lra).
  destruct (two_least 1 (eps / K) ltac:(lra) ltac:(apply Rdiv_lt_0_compat; lra)) as (e1 & He1 & L1 & L2).
  assert (Ke : K * e1 <= eps) by (apply Rle_trans with (K * (eps / K)); [apply Rmult_le_compat_l; lra | right; field;
    lra]).
  destruct (@flow_point F' kk' cc' ll' HA' rho rho ltac:(lra) e1 He1) as (d1 & Hd1 & Pt), (pass_differs e1 He1) as (d2 &
    Hd2 & Df), (two_least d2 (d1 / (@M F' * B)) Hd2) as (d & Hd & L3 & L4); [apply Rdiv_lt_0_compat; [lra | apply
    Rmult_lt_0_compat; lra]|].
  assert (Md : @M F' * B * d <= d1) by (apply Rle_trans with (@M F' * B * (d1 / (@M F' * B))); [apply Rmult_le_compat_l;
    lra | right; field; split; lra]).
  assert (Near : forall x x' mu mu' t, small d x mu -> small d x' mu' -> within 2 t (minus x x') -> Rabs (mu - mu') <= t
    -> within 2 (@M F' * (B * t)) (minus (pass x mu) (pass x' mu'))).
  { intros x x' mu mu' t S S' Ht Htm; assert (t0 : 0 <= t) by (pose proof (Rabs_pos (mu - mu')); lra).
    destruct (proj2 (proj2 HA) (mu - mu') 0 (x 0%nat - x' 0%nat) (x 1%nat - x' 1%nat)) as (z & w & Z & Ez & Ew).
    destruct (Df x x' mu mu' t z w (small_less d d2 x mu S L3) (small_less d d2 x' mu' S' L3) Ht Htm Z Ez Ew) as [A1 A2].
    destruct (lin_size kk cc ll HA (mu - mu') z w t Z) with (s := e) as (B1 & B2 & _); try lra; [rewrite Ez; apply (Ht
      0%nat); lia | rewrite Ew; apply (Ht 1%nat); lia|].
    assert (Q : forall D c c' q, Rabs (D - (c * (mu - mu') + c' * q)) <= e1 * t -> Rabs q <= @M F * t -> Rabs c <= Rabs
      Jm + Rabs Rm -> Rabs c' <= Rabs Jy + Rabs Rv -> Rabs D <= B * t).
    { intros D c c' q H1 H2 H3 H4; pose proof (product c _ _ _ H3 Htm); pose proof (product c' q _ _ H4 H2); replace D
        with (D - (c * (mu - mu') + c' * q) + (c * (mu - mu') + c' * q)) by ring; eapply Rle_trans; [apply
        Rabs_triang|]; pose proof (Rabs_triang (c * (mu - mu')) (c' * q)); assert (e1 * t <= 1 * t) by (apply
        Rmult_le_compat_r; lra); unfold B; lra. }
    pose proof (Rabs_pos Jm); pose proof (Rabs_pos Rm); pose proof (Rabs_pos Jy); pose proof (Rabs_pos Rv).
    destruct (@origin_flow F' mu rho (jy mu (@Y F x mu e)) (law mu 0 (@V F x mu e))) as [E1 E2], (@origin_flow F' mu' rho
      (jy mu' (@Y F x' mu' e)) (law mu' 0 (@V F x' mu' e))) as [E3 E4]; fold (pass x mu) in E1, E2; fold (pass x' mu') in
      E3, E4. apply (@nearby_back F' (pass x mu) (pass x' mu') mu mu' (B * t) rho); rewrite ?E1, ?E2, ?E3, ?E4; [apply (Q
      _ Jm Jy (z e)); trivial; lra | apply (Q _ Rm Rv (w e)); trivial; lra | | lra]. apply Rle_trans with (1 * t); [lra |
      apply Rmult_le_compat_r; lra]. }
  assert (S0 : small d zero 0) by (apply small_zero; lra); assert (In : forall x mu, small d x mu -> within 2 d1 (pass x
    mu)).
  { intros x mu S; pose proof (Near x zero mu 0 d S S0 ltac:(intros i Hi; unfold minus, zero; rewrite Rminus_0_r; apply S,
      Hi) ltac:(rewrite Rminus_0_r; apply S)) as N; intros i Hi; specialize (N i Hi); unfold minus in N; rewrite
      (pass_rest i Hi), Rminus_0_r in N; lra. }
  assert (dB : d <= @M F' * B * d) by (rewrite <- (Rmult_1_l d) at 1; apply Rmult_le_compat_r; [lra|]; rewrite <-
    (Rmult_1_l 1); apply Rmult_le_compat; lra).
  exists d; split; [exact Hd|]; intros x x' mu mu' t z w z' w' S S' Ht Htm Z Ez Ew Z' [T1 T2].
  assert (t0 : 0 <= t) by (pose proof (Rabs_pos (mu - mu')); lra).
  destruct (Df x x' mu mu' t z w (small_less d d2 x mu S L3) (small_less d d2 x' mu' S' L3) Ht Htm Z Ez Ew) as [A1 A2];
    rewrite <- T1 in A1; rewrite <- T2 in A2; pose proof (Near x x' mu mu' t S S' Ht Htm) as XX.
  destruct (@origin_flow F' mu rho (jy mu (@Y F x mu e)) (law mu 0 (@V F x mu e))) as [E1 E2], (@origin_flow F' mu' rho
    (jy mu' (@Y F x' mu' e)) (law mu' 0 (@V F x' mu' e))) as [E3 E4]; fold (pass x mu) in E1, E2; fold (pass x' mu') in
    E3, E4.
  destruct (proj2 (proj2 HA') (mu - mu') 0 (pass x mu 0%nat - pass x' mu' 0%nat) (pass x mu 1%nat - pass x' mu' 1%nat))
    as (z3 & w3 & Z3 & I3 & I4). assert (Zd : Rabs (rho - rho) <= d1) by (rewrite Rminus_eq_0, Rabs_R0; lra).
  assert (tB : t <= @M F' * (B * t)) by (rewrite <- Rmult_assoc, <- (Rmult_1_l t) at 1; apply Rmult_le_compat_r; [lra|];
    rewrite <- (Rmult_1_l 1); apply Rmult_le_compat; lra).
  destruct (Pt (pass x mu) (pass x' mu') mu mu' (@M F' * (B * t)) rho rho z3 w3) as [B1 B2]; trivial; try (apply In;
    assumption); try (destruct S, S'; lra).
  rewrite Rminus_eq_0, Rabs_R0, !Rmult_0_r, !Rplus_0_r in B1, B2; rewrite E1, E3 in B1; rewrite E2, E4 in B2.
  assert (Hu : S.linearized (@T F') kk' cc' ll' 0 (fun t => z3 t - z' t) (fun t => w3 t - w' t)).
  { intros u _; destruct (Z3 u) as [D1 D2], (Z' u) as [D3 D4]; split; [apply D_minus; assumption|]; eapply D_value;
    [apply D_minus; eassumption | ring]. }
  pose proof (S.linear_back (@T F') (@L F') kk' cc' ll' (@HL F') (proj1 HA') _ _ Hu rho ltac:(lra)) as Fin; cbv beta in
    Fin. set (kb := 2 * (1 + @L F') * exp ((2 * @L F' + 1) * @T F')) in *; assert (Mk : @M F' = 3 * kb) by reflexivity.
  set (b := (@M F' * B + 1) * (e1 * t)); assert (F1 : Rabs (z3 rho - z' rho) <= b).
  { match type of A1 with Rabs (?D - _) <= _ => replace (z3 rho - z' rho) with ((D - z' rho) - (D - z3 rho)) by ring
      end; eapply Rle_trans; [apply apart|]; unfold b; lra. }
  assert (F2 : Rabs (w3 rho - w' rho) <= b).
  { match type of A2 with Rabs (?D - _) <= _ => replace (w3 rho - w' rho) with ((D - w' rho) - (D - w3 rho)) by ring
      end; eapply Rle_trans; [apply apart|]; unfold b; lra. }
  assert (Kb : @M F' * (2 * b) <= eps * t) by (apply Rle_trans with (K * e1 * t); [right; unfold K, b; ring | apply
    Rmult_le_compat_r; lra]).
  assert (Sum : kb * (Rabs (z3 rho - z' rho) + Rabs (w3 rho - w' rho)) <= @M F' * (2 * b)) by (pose proof (Rabs_pos (z3
    rho - z' rho)); pose proof (Rabs_pos (w3 rho - w' rho)); apply Rmult_le_compat; lra).
  pose proof (Rabs_pos (z3 0 - z' 0)); pose proof (Rabs_pos (w3 0 - w' 0)); rewrite <- I3, <- I4; split; lra.
Qed.
Lemma turnover_exists m z w : exists z' w', lin' m z' w' /\ turnover m z w z' w'.
Proof.
  destruct (proj2 (proj2 HA') m rho (Jm * m + Jy * z e) (Rm * m + Rv * w e)) as (z' & w' & Z & E1 & E2); exists z', w';
    split; [exact Z | split; assumption].
Qed.
Theorem pass_matrix : exists (A : nat -> vec) (phi : vec), (forall i, (i < 2)%nat -> strict 2 (fun x mu => pass x mu i)
  (dot 2 (A i)) (phi i)) /\ forall m z w z' w', lin m z w -> lin' m z' w' -> turnover m z w z' w' ->
  z' 0 = A 0%nat 0%nat * z 0 + A 0%nat 1%nat * w 0 + m * phi 0%nat /\
  w' 0 = A 1%nat 0%nat * z 0 + A 1%nat 1%nat * w 0 + m * phi 1%nat.
Proof.
  apply (matrix_exists F kk cc ll kk' cc' ll' HA pass turnover pass_rest pass_strict turnover_exists).
  - intros m x y p1 q1 p2 q2 p3 q3 z1 w1 z2 w2 z3 w3 [X1 X2] [X3 X4] [X5 X6]; split; rewrite ?X1, ?X2, ?X3, ?X4, ?X5,
      ?X6; ring.
  - intros m z w z2 w2 z' w' z2' w2' L L2 E1 E2 [Y1 Y2] [Y3 Y4] Z Z'; destruct (lin_forward F kk cc ll HA m z w z2 w2 e
      L L2 ltac:(lra) E1 E2) as [E3 E4]; rewrite E3 in Y1; rewrite E4 in Y2. apply (@lin_same F' kk' cc' ll' HA' m z' w'
      z2' w2' rho Z Z'); lra.
Qed.
End Change.
