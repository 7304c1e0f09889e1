(** * Strictly differentiable maps of the plane: they are Lipschitz, and can be composed *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import StatementOrbits OrbitVectors Contraction Derivatives NonlinearGronwall.
Open Scope R_scope.

Definition smooth_map (G : vec -> R -> vec) (A : nat -> vec) (phi : vec) : Prop := forall i, (i < 2)%nat ->
  strict 2 (fun x mu => G x mu i) (dot 2 (A i)) (phi i).
Lemma smooth_lip G A phi : smooth_map G A phi -> exists d C, 0 < d /\ 1 <= C /\ forall x x' mu mu' t, within 2 d x ->
  within 2 d x' -> Rabs mu <= d -> Rabs mu' <= d -> within 2 t (minus x x') -> Rabs (mu - mu') <= t ->
  within 2 (C * t) (minus (G x mu) (G x' mu')).
Proof.
  intros HG; destruct (HG 0%nat ltac:(lia)) as [_ H0], (HG 1%nat ltac:(lia)) as [_ H1], (H0 1 ltac:(lra)) as (d0 & D0 &
    K0), (H1 1 ltac:(lra)) as (d1 & D1 & K1), (two_least d0 d1 D0 D1) as (d & Hd & L0 & L1).
  set (C := 1 + Rabs (A 0%nat 0%nat) + Rabs (A 0%nat 1%nat) + Rabs (phi 0%nat) + (Rabs (A 1%nat 0%nat) + Rabs (A 1%nat
    1%nat) + Rabs (phi 1%nat))).
  pose proof (Rabs_pos (A 0%nat 0%nat)); pose proof (Rabs_pos (A 0%nat 1%nat)); pose proof (Rabs_pos (phi 0%nat)); pose
    proof (Rabs_pos (A 1%nat 0%nat)); pose proof (Rabs_pos (A 1%nat 1%nat)); pose proof (Rabs_pos (phi 1%nat)).
  exists d, C; split; [exact Hd | split; [unfold C; lra|]]; intros x x' mu mu' t Hx Hx' Hm Hm' Ht Htm.
  assert (Wi : forall y r, within 2 d y -> d <= r -> within 2 r y) by (intros y r Hy Hr i Hi; specialize (Hy i Hi);
      lra).
  specialize (K0 x x' mu mu' t (Wi _ _ Hx L0) (Wi _ _ Hx' L0) ltac:(lra) ltac:(lra) Ht Htm); specialize (K1 x x' mu mu'
    t (Wi _ _ Hx L1) (Wi _ _ Hx' L1) ltac:(lra) ltac:(lra) Ht Htm); cbn in K0, K1.
  pose proof (Ht 0%nat ltac:(lia)) as T0; pose proof (Ht 1%nat ltac:(lia)) as T1; assert (t0 : 0 <= t) by (pose proof
    (Rabs_pos (mu - mu')); lra).
  assert (Q : forall p a b c, Rabs (p - (0 + a * minus x x' 0%nat + b * minus x x' 1%nat) - (mu - mu') * c) <= 1 * t ->
    Rabs p <= (1 + Rabs a + Rabs b + Rabs c) * t).
  { intros p a b c Hp; pose proof (product a _ _ _ (Rle_refl _) T0); pose proof (product b _ _ _ (Rle_refl _) T1); pose
      proof (product c _ _ _ (Rle_refl _) Htm). replace p with ((p - (0 + a * minus x x' 0%nat + b * minus x x' 1%nat) -
      (mu - mu') * c) + (a * minus x x' 0%nat + b * minus x x' 1%nat + c * (mu - mu'))) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; pose proof (Rabs_triang (a * minus x x' 0%nat + b * minus x x' 1%nat) (c *
        (mu - mu'))); pose proof (Rabs_triang (a * minus x x' 0%nat) (b * minus x x' 1%nat)); lra. }
  apply Q in K0; apply Q in K1; intros i Hi; destruct i as [|[|i]]; [| |lia]; unfold minus; (eapply Rle_trans;
    [eassumption | apply Rmult_le_compat_r; [exact t0 | unfold C; lra]]).
Qed.
Definition times (A2 A1 : nat -> vec) : nat -> vec := fun i j => A2 i 0%nat * A1 0%nat j + A2 i 1%nat * A1 1%nat j.
Definition applied (A : nat -> vec) (phi : vec) (x : vec) (m : R) : vec := fun i => A i 0%nat * x 0%nat + A i 1%nat * x
  1%nat + m * phi i.
Lemma smooth_zero G A phi x : smooth_map G A phi -> (forall i, (i < 2)%nat -> x i = 0) -> forall i, (i < 2)%nat ->
  G x 0 i = 0.
Proof.
  intros HG Hx i Hi; destruct (HG i Hi) as [E H], (H 1 ltac:(lra)) as (d & Hd & K).
  assert (Z : Rabs 0 <= 0) by (rewrite Rabs_R0; lra).
  specialize (K x zero 0 0 0 ltac:(intros j Hj; rewrite (Hx j Hj), Rabs_R0; lra) ltac:(intros j _; unfold zero; rewrite
    Rabs_R0; lra) ltac:(lra) ltac:(lra) ltac:(intros j Hj; unfold minus, zero; rewrite (Hx j Hj), Rminus_0_r; exact Z)
    ltac:(rewrite Rminus_0_r; exact Z)).
  cbn in K; unfold minus, zero in K; rewrite !Hx in K by lia; cbv beta in E; unfold zero in E; rewrite E in K; apply
    Rabs_zero; match type of K with Rabs ?u <= _ => replace u with (G x 0 i) in K by ring end; lra.
Qed.
Lemma smooth_compose G1 A1 phi1 G2 A2 phi2 : smooth_map G1 A1 phi1 -> smooth_map G2 A2 phi2 ->
  smooth_map (fun x mu => G2 (G1 x mu) mu) (times A2 A1) (applied A2 phi2 phi1 1).
Proof.
  intros S1 S2 i Hi; split; [apply (smooth_zero G2 A2 phi2); [exact S2 | intros j Hj; apply (proj1 (S1 j Hj)) | exact
      Hi]|].
  intros eps He; destruct (smooth_lip G1 A1 phi1 S1) as (d0 & C & Hd0 & HC & Lip), (S2 i Hi) as [_ H2].
  set (B := Rabs (A2 i 0%nat) + Rabs (A2 i 1%nat) + 1); pose proof (Rabs_pos (A2 i 0%nat)) as P0; pose proof (Rabs_pos
    (A2 i 1%nat)) as P1. destruct (H2 (eps / (2 * C)) ltac:(apply Rdiv_lt_0_compat; lra)) as (d2 & Hd2 & K2).
  assert (Pe : 0 < eps / (2 * B)) by (apply Rdiv_lt_0_compat; unfold B; lra).
  destruct (proj2 (S1 0%nat ltac:(lia)) _ Pe) as (d3 & Hd3 & K3), (proj2 (S1 1%nat ltac:(lia)) _ Pe) as (d4 & Hd4 & K4).
  destruct (two_least d0 (d2 / C) Hd0 ltac:(apply Rdiv_lt_0_compat; lra)) as (q1 & Hq1 & L1 & L2), (two_least q1 d3 Hq1
    Hd3) as (q2 & Hq2 & L3 & L4), (two_least q2 d4 Hq2 Hd4) as (q3 & Hq3 & L5 & L6), (two_least q3 d2 Hq3 Hd2) as (d &
    Hd & L7 & L8). assert (Cd : C * d <= d2) by (apply Rle_trans with (C * (d2 / C)); [apply Rmult_le_compat_l; lra |
    right; field; lra]). exists d; split; [exact Hd|]; intros x x' mu mu' t Hx Hx' Hm Hm' Ht Htm.
  assert (Wi : forall y r, within 2 d y -> d <= r -> within 2 r y) by (intros y r Hy Hr j Hj; specialize (Hy j Hj);
      lra).
  assert (In : forall y m, within 2 d y -> Rabs m <= d -> within 2 d2 (G1 y m)).
  { intros y m Hy Hm0; pose proof (Lip y zero m 0 d (Wi y d0 Hy ltac:(lra)) ltac:(intros j _; unfold zero; rewrite
      Rabs_R0; lra) ltac:(lra) ltac:(rewrite Rabs_R0; lra) ltac:(intros j Hj; unfold minus, zero; rewrite Rminus_0_r;
      apply Hy, Hj) ltac:(rewrite Rminus_0_r; lra)) as Q. intros j Hj; specialize (Q j Hj); unfold minus in Q; rewrite
      (proj1 (S1 j Hj)), Rminus_0_r in Q; lra. }
  assert (t0 : 0 <= t) by (pose proof (Rabs_pos (mu - mu')); lra); assert (Ct : t <= C * t) by (rewrite <- (Rmult_1_l t)
    at 1; apply Rmult_le_compat_r; lra).
  pose proof (Lip x x' mu mu' t (Wi x d0 Hx ltac:(lra)) (Wi x' d0 Hx' ltac:(lra)) ltac:(lra) ltac:(lra) Ht Htm) as D1.
  specialize (K2 (G1 x mu) (G1 x' mu') mu mu' (C * t) (In x mu Hx Hm) (In x' mu' Hx' Hm') ltac:(lra) ltac:(lra) D1
    ltac:(lra)). replace (eps / (2 * C) * (C * t)) with (eps / 2 * t) in K2 by (field; lra).
  specialize (K3 x x' mu mu' t (Wi x d3 Hx ltac:(lra)) (Wi x' d3 Hx' ltac:(lra)) ltac:(lra) ltac:(lra) Ht Htm);
    specialize (K4 x x' mu mu' t (Wi x d4 Hx ltac:(lra)) (Wi x' d4 Hx' ltac:(lra)) ltac:(lra) ltac:(lra) Ht Htm).
  cbn in K2, K3, K4 |- *; unfold times, applied, minus in *.
  pose proof (product (A2 i 0%nat) _ _ _ (Rle_refl _) K3) as M1; pose proof (product (A2 i 1%nat) _ _ _ (Rle_refl _) K4)
    as M2. assert (M3 : (Rabs (A2 i 0%nat) + Rabs (A2 i 1%nat)) * (eps / (2 * B) * t) <= eps / 2 * t).
  { apply Rle_trans with (B * (eps / (2 * B) * t)); [|right; field; unfold B; lra]; apply Rmult_le_compat_r; [apply
      Rmult_le_pos; lra | unfold B; lra]. }
  match type of K2 with Rabs ?u <= _ => match type of M1 with Rabs ?v <= _ => match type of M2 with Rabs ?w <= _ =>
    match goal with |- Rabs ?g <= _ => replace g with (u + (v + w)) by ring end end end end.
  eapply Rle_trans; [apply Rabs_triang|]; match type of M1 with Rabs ?v <= _ => match type of M2 with Rabs ?w <= _ =>
    pose proof (Rabs_triang v w) end end; lra.
Qed.

