(** * Proof of what one impact in n turns needs, for every mu *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs Algebra StatementOscillator StatementOneImpact Derivatives Flow OscillatorTurns.
Open Scope R_scope.

(** The places and velocities k turns after impact i, as seen from stop N i. *)
Lemma seen_later c k m S V y v z t n : flow c k S V -> free c k y v ->
  facing m (z + Z.of_nat n) * y (t + turn m * INR n) =
    turned m (e11 c S V) n 0 * (facing m z * y t) + turned m S n 0 * (facing m z * v t) /\
  facing m (z + Z.of_nat n) * v (t + turn m * INR n) =
    turned m (e21 k S) n 0 * (facing m z * y t) + turned m V n 0 * (facing m z * v t).
Proof.
  intros HS F; destruct (free_moved c k S V HS y v t (t + turn m * INR n) F) as [-> ->].
  unfold moved, moving, turned; rewrite facing_plus.
  replace (t + turn m * INR n - t) with (turn m * INR n + 0) by ring; split; ring.
Qed.

(** The same place after n turns, s faster: then so much higher after k turns. Here X is u_{n+1}, U u_n, x and u those
    of k. *)
Lemma higher A11 A21 A22 g z w U X u x s : U <> 0 -> (X - A22 * U) * z + g * U * w = z ->
  s = A21 * U * z + (X - A11 * U) * w - w -> let a1 := A11 + A22 in let a2 := A11 * A22 - g * A21 in
  - (1 - (2 * X - a1 * U) + (X ^ 2 - a1 * X * U + a2 * U ^ 2)) / U * ((x - A22 * u) * z + g * u * w - z) =
    - s * g * ((U - u - (U * x - X * u)) / U).
Proof.
  intros HU E -> a1 a2; assert (G : g * w = - (X - A22 * U - 1) * z / U).
  { apply (Rmult_eq_reg_l U); [|exact HU]; replace (U * (- (X - A22 * U - 1) * z / U)) with (- (X - A22 * U - 1) * z) by
      (field; exact HU). lra. }
  replace (g * u * w) with (u * (g * w)) by ring.
  replace (- (A21 * U * z + (X - A11 * U) * w - w) * g) with (- (A21 * U * z * g + (X - A11 * U - 1) * (g * w))) by ring.
  rewrite G; unfold a1, a2; field; exact HU.
Qed.

Theorem Gap : Gap_statement.
Proof.
  intros O m a1 a2 gamma n mu d N t y v i HA Hu [HW HN HP HV] V0 k Hk.
  destruct (flow_exists (Oscillator.c O) (Oscillator.k O)) as (S & V & HS).
  destruct HW as [F _ _ G0 G1 _ _ B]; fold V0 in B.
  destruct (seen_later _ _ m S V (y i) (v i) (N i) (t i) k HS F) as [Pk _].
  destruct (seen_later _ _ m S V (y i) (v i) (N i) (t i) n HS F) as [Pn Vn].
  set (z := facing m (N i) * y i (t i)) in *; set (w := facing m (N i) * v i (t i)) in *.
  assert (phase : forall j, t i + turn m * INR j - turn m * IZR (N i + Z.of_nat j) = t i - turn m * IZR (N i)).
  { intros j; rewrite plus_IZR, <- INR_IZR_INZ; ring. }
  assert (W : facing m (N i + Z.of_nat n) * v (i + 1)%Z (t (i + 1)%Z) = w).
  { unfold w; rewrite <- HV, facing_plus; ring. }
  unfold V0 in *; clear V0; rewrite HN, HP in *; unfold gap, speed in *; rewrite !phase in *; fold z in G0.
  rewrite Pk; rewrite Pn in G1; rewrite Vn in *; rewrite W in B.
  destruct (powers _ _ m S V HS a1 a2 gamma HA) as (A11 & A21 & A22 & E1 & E2 & H).
  destruct (H n) as (Sn & Vn' & En & Fn), (H k) as (Sk & _ & Ek & _); rewrite Sn, Vn', En, Fn in *; rewrite Sk, Ek.
  set (g := Oscillator.G O mu (t i - turn m * IZR (N i))) in *.
  set (h := Oscillator.G1 O mu (t i - turn m * IZR (N i))) in *; set (tau := Oscillator.tau O) in *.
  unfold b, Defs.c, Defs.v; cbn [Nat.add] in *.
  pose proof (u_addition a1 a2 (n - k) k) as P; replace (n - k + k)%nat with n in P by lia; rewrite P.
  rewrite <- (u_Cassini a1 a2 n).
  match type of B with _ = - tau * (?e + h) => set (p := e) in *; pose proof (higher A11 A21 A22 gamma z w (u a1 a2 n)
    (u a1 a2 (Datatypes.S n)) (u a1 a2 k) (u a1 a2 (Datatypes.S k)) (p - w) Hu ltac:(lra) eq_refl) as A end.
  cbv zeta in A; rewrite <- E1, <- E2 in A; replace (- (1 + tau) * (p + h)) with (- (p - w)) by lra.
  rewrite <- A; f_equal; lra.
Qed.

Theorem Every_mu : Every_mu_statement.
Proof.
  intros O m a1 a2 gamma n HA Ht Hu Hc k Hk Hs mu d N t y v i H.
  pose proof (Gap O m a1 a2 gamma n mu d N t y v i HA Hu H k ltac:(lia)) as E; destruct H as [W HN HP _].
  destruct W as [_ _ _ _ _ clear hits _]; specialize (clear (N i + Z.of_nat k)%Z (t i + turn m * INR k)); cbv zeta in E.
  pose proof (turn_large m); assert (K : 0 < INR k < INR n) by (split; [apply (lt_INR 0) | apply lt_INR]; lia).
  rewrite HP in clear; specialize (clear ltac:(split; [|apply Rplus_lt_compat_l, Rmult_lt_compat_l; lra]; rewrite <-
    (Rplus_0_r (t i)) at 1; apply Rplus_lt_compat_l, Rmult_lt_0_compat; lra)).
  set (f := gap _ _ _ _ _ _) in *; set (V := speed _ _ _ _ _ _) in *; set (C := c a1 a2 n) in *.
  assert (P : 0 < C * C * f) by (apply Rmult_lt_0_compat; [nra | exact clear]).
  replace (C * C * f) with (C * (C * f)) in P by ring; rewrite E in P.
  assert (Q : 0 <= (1 + Oscillator.tau O) * - V) by (apply Rmult_le_pos; lra); nra.
Qed.
