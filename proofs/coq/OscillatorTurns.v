(** * The flow over n turns: (59) and (64) are limits of a leg, which depends on its ends in a Lipschitz way *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs Algebra StatementOrbitsPlane StatementOscillator Derivatives Flow PlaneLinear.
Open Scope R_scope.

Lemma facing_plus m y z : facing m (y + z) = facing m y * facing m z.
Proof.
  destruct m; cbn [facing]; [ring|]; rewrite Z.even_add; destruct (Z.even y), (Z.even z); cbn; ring.
Qed.
Lemma side_square m z : facing m z * facing m z = 1.
Proof. destruct m; cbn [facing]; [|destruct (Z.even z)]; ring. Qed.
Lemma side_twice m y z x : facing m y * facing m z * (facing m y * x) = facing m z * x.
Proof. transitivity (facing m y * facing m y * (facing m z * x)); [ring | rewrite side_square; ring]. Qed.
Lemma side_abs m z : Rabs (facing m z) = 1.
Proof. destruct m; cbn [facing]; [|destruct (Z.even z)]; unfold Rabs; destruct Rcase_abs; lra. Qed.
Lemma side_0 m : facing m 0 = 1.
Proof. destruct m; reflexivity. Qed.
Lemma turn_large m : 3 <= turn m.
Proof. pose proof PI2_3_2; destruct m; cbn [turn]; lra. Qed.

(** A leg of given flow f11, f12, f21, f22 from the place x to y: its velocities after and before the impacts. *)
Definition aft_of f11 f12 x y : R := (y - f11 * x) / f12.
Definition bef_of f11 f12 f21 f22 x y : R := f21 * x + f22 * aft_of f11 f12 x y.

Lemma leg_bounds K d w x y f11 f12 f21 f22 g11 g12 g21 g22 : 1 <= K -> 0 <= d -> Rabs x <= w -> Rabs y <= w ->
  (forall f g, f = f11 /\ g = g11 \/ f = f12 /\ g = g12 \/ f = f21 /\ g = g21 \/ f = f22 /\ g = g22 ->
   Rabs f <= K /\ Rabs g <= K /\ Rabs (f - g) <= K * d) -> / K <= Rabs f12 -> / K <= Rabs g12 ->
  let L := 6 * K ^ 5 in Rabs (aft_of f11 f12 x y) <= L * w /\ Rabs (bef_of f11 f12 f21 f22 x y) <= L * w /\
  Rabs (aft_of f11 f12 x y - aft_of g11 g12 x y) <= L * w * d /\
  Rabs (bef_of f11 f12 f21 f22 x y - bef_of g11 g12 g21 g22 x y) <= L * w * d.
Proof.
  intros HK Hd Hx Hy HF H1 H2 L.
  destruct (HF f11 g11 ltac:(auto)) as (F11 & G11 & D11), (HF f12 g12 ltac:(auto)) as (F12 & G12 & D12),
    (HF f21 g21 ltac:(auto)) as (F21 & G21 & D21), (HF f22 g22 ltac:(auto 6)) as (F22 & G22 & D22).
  assert (IK : 0 < / K) by (apply Rinv_0_lt_compat; lra).
  assert (N1 : f12 <> 0) by (intros E; rewrite E, Rabs_R0 in H1; lra).
  assert (N2 : g12 <> 0) by (intros E; rewrite E, Rabs_R0 in H2; lra).
  assert (inv : forall f, / K <= Rabs f -> Rabs (/ f) <= K).
  { intros f H; rewrite Rabs_inv, <- (Rinv_inv K); apply Rinv_le_contravar; assumption. }
  apply inv in H1; apply inv in H2.
  assert (Hw : 0 <= w) by (eapply Rle_trans; [apply Rabs_pos | exact Hx]).
  assert (up : forall z, 0 <= z -> z <= K * z) by (intros z Hz; rewrite <- (Rmult_1_l z) at 1;
    apply Rmult_le_compat_r; lra).
  assert (pos : forall z, 0 <= z -> 0 <= K * z) by (intros; apply Rmult_le_pos; lra).
  set (a := aft_of f11 f12 x y); set (a' := aft_of g11 g12 x y).
  assert (A : Rabs a <= 2 * (K * (K * w))).
  { unfold a, aft_of, Rdiv; pose proof (product _ _ _ _ F11 Hx) as P; pose proof (apart y (f11 * x)).
    pose proof (up w Hw); assert (Q : Rabs (y - f11 * x) <= 2 * (K * w)) by lra.
    pose proof (product _ _ _ _ Q H1); lra. }
  assert (DA : Rabs (a - a') <= 3 * (K * (K * (K * (K * (w * d)))))).
  { replace (a - a') with ((a * (g12 - f12) - (f11 - g11) * x) * / g12) by (unfold a, a', aft_of; field; auto).
    rewrite Rabs_minus_sym in D12; pose proof (product _ _ _ _ A D12) as P; pose proof (product _ _ _ _ D11 Hx) as P'.
    pose proof (apart (a * (g12 - f12)) ((f11 - g11) * x)).
    assert (0 <= w * d) by (apply Rmult_le_pos; lra); pose proof (up (K * (w * d)) ltac:(auto)).
    pose proof (up (K * (K * (w * d))) ltac:(auto)).
    assert (Q : Rabs (a * (g12 - f12) - (f11 - g11) * x) <= 3 * (K * (K * (K * (w * d))))) by lra.
    pose proof (product _ _ _ _ Q H2); lra. }
  assert (0 <= w * d) by (apply Rmult_le_pos; lra).
  assert (chain : forall z, 0 <= z -> z <= K * z /\ K * z <= K * (K * z) /\ K * (K * z) <= K * (K * (K * z)) /\
    K * (K * (K * z)) <= K * (K * (K * (K * z))) /\ K * (K * (K * (K * z))) <= K * (K * (K * (K * (K * z))))).
  { intros z Hz; repeat split; apply up; auto 6. }
  assert (EL : forall z, L * z = 6 * (K * (K * (K * (K * (K * z)))))) by (intros; unfold L; ring).
  pose proof (chain w Hw); pose proof (chain (w * d) ltac:(assumption)).
  rewrite !Rmult_assoc; fold L; rewrite !EL; split; [|split; [|split]].
  - lra.
  - unfold bef_of; fold a; pose proof (product _ _ _ _ F21 Hx); pose proof (product _ _ _ _ F22 A).
    eapply Rle_trans; [apply Rabs_triang | lra].
  - lra.
  - unfold bef_of; fold a a'.
    replace (f21 * x + f22 * a - (g21 * x + g22 * a')) with ((f21 - g21) * x + (f22 - g22) * a + g22 * (a - a'))
      by ring.
    pose proof (product _ _ _ _ D21 Hx); pose proof (product _ _ _ _ D22 A); pose proof (product _ _ _ _ G22 DA).
    eapply Rle_trans; [apply Rabs_triang|]; eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang | lra].
Qed.

Section Turns.
Variables (c k : R) (m : sign) (S V : R -> R).
Hypothesis HS : flow c k S V.
Notation e11 := (e11 c S V).
Notation e21 := (e21 k S).
Notation T := (turn m).
(** The flow over n turns and the time t more, reflected if n is odd and there are two stops. *)
Definition turned (f : R -> R) (n : nat) (t : R) : R := facing m (Z.of_nat n) * f (T * INR n + t).
Definition aft0 n := aft_of (turned e11 n 0) (turned S n 0) (-1) (-1).
Definition bef0 n := bef_of (turned e11 n 0) (turned S n 0) (turned e21 n 0) (turned V n 0) (-1) (-1).

Section Periods.
Variables a1 a2 gamma : R.
Hypothesis HA : matrix c k m a1 a2 gamma.
Notation u := (u a1 a2).

(** The powers of A. *)
Lemma powers : exists A11 A21 A22, a1 = A11 + A22 /\ a2 = A11 * A22 - gamma * A21 /\ forall n,
  turned S n 0 = gamma * u n /\ turned V n 0 = u (1 + n) - A11 * u n /\ turned e11 n 0 = u (1 + n) - A22 * u n /\
  turned e21 n 0 = A21 * u n.
Proof.
  destruct HA as (A11 & A21 & A22 & E1 & E2 & H); exists A11, A21, A22; split; [exact E1 | split; [exact E2|]].
  destruct (H _ _ (flow_free _ _ _ _ HS)) as [HS1 HV1]; rewrite (flow_S _ _ _ _ HS), (flow_V _ _ _ _ HS) in HS1, HV1.
  destruct (H _ _ (moved_free c k S V HS 0 1 0)) as [H1 H2].
  destruct (moved_start c k S V HS 0 1 0) as [Z1 Z2]; rewrite Z1, Z2 in H1, H2.
  unfold moved, moving in H1, H2; rewrite Rminus_0_r in H1, H2.
  assert (SV : forall n, turned S n 0 = gamma * u n /\ turned V n 0 = u (1 + n) - A11 * u n).
  { unfold turned; induction n as [|n [IH1 IH2]].
    - cbn [Z.of_nat INR Nat.add]; rewrite side_0, Rmult_0_r, Rplus_0_r, (flow_S _ _ _ _ HS), (flow_V _ _ _ _ HS),
        u_0, u_1; lra.
    - rewrite Nat2Z.inj_succ, <- Z.add_1_l, facing_plus, S_INR.
      replace (T * (INR n + 1) + 0) with (T + (T * INR n + 0)) by ring.
      destruct (flow_plus c k S V HS T (T * INR n + 0)) as [-> ->]; set (t := T * INR n + 0) in *.
      set (j := facing m (Z.of_nat n)) in *; set (i := facing m 1) in *.
      replace (i * j * (e11 T * S t + S T * V t)) with (i * e11 T * (j * S t) + i * S T * (j * V t)) by ring.
      replace (i * j * (e21 T * S t + V T * V t)) with (i * e21 T * (j * S t) + i * V T * (j * V t)) by ring.
      rewrite IH1, IH2; replace (i * e11 T) with A11 by lra; replace (i * S T) with gamma by lra.
      replace (i * e21 T) with A21 by lra; replace (i * V T) with A22 by lra.
      cbn [Nat.add]; rewrite u_SS, E1, E2; split; ring. }
  intros n; destruct (SV n) as [E3 E4]; split; [exact E3 | split; [exact E4|]].
  assert (X : turned e11 n 0 = turned V n 0 + c * turned S n 0 /\ turned e21 n 0 = - k * turned S n 0).
  { unfold turned, Flow.e11, Flow.e21; split; ring. }
  destruct X as [-> ->]; rewrite E4, E3.
  assert (c * gamma = A11 - A22 /\ - k * gamma = A21) as [F1 F2].
  { unfold Flow.e11, Flow.e21 in H1, H2; split; [replace gamma with (facing m 1 * S T) by lra|
      replace gamma with (facing m 1 * S T) by lra]; lra. }
  split; [replace (c * (gamma * u n)) with (c * gamma * u n) by ring; rewrite F1; ring|].
  replace (- k * (gamma * u n)) with (- k * gamma * u n) by ring; rewrite F2; ring.
Qed.

Lemma turned_S n : turned S n 0 = gamma * u n.
Proof. destruct powers as (A11 & A21 & A22 & _ & _ & H); apply H. Qed.

Lemma limit_b n j : gamma <> 0 -> u n <> 0 -> (j <= n)%nat ->
  turned e11 j 0 * -1 + turned S j 0 * aft0 n + 1 = b a1 a2 n j.
Proof.
  intros Hg Hn Hj; destruct powers as (A11 & A21 & A22 & E1 & E2 & H); unfold aft0, aft_of, b.
  destruct (H n) as (-> & _ & -> & _), (H j) as (-> & _ & -> & _).
  pose proof (u_addition a1 a2 (n - j) j) as P; replace (n - j + j)%nat with n in P by lia; rewrite P.
  cbn [Nat.add]; field; auto.
Qed.

Lemma limit_follows i j : gamma <> 0 -> u i <> 0 -> u j <> 0 -> (1 <= i)%nat ->
  aft0 j - bef0 i = follows a1 a2 i j / gamma.
Proof.
  intros Hg Hi Hj H1; destruct powers as (A11 & A21 & A22 & E1 & E2 & H); unfold bef0, aft0, bef_of, aft_of, follows.
  destruct (H i) as (-> & -> & -> & ->), (H j) as (-> & _ & -> & _).
  pose proof (u_Cassini a1 a2 i) as C.
  replace (a2 ^ i) with (u (Datatypes.S i) ^ 2 - a1 * u (Datatypes.S i) * u i + a2 * u i ^ 2) by exact C.
  destruct i as [|i]; [lia|]; replace (Datatypes.S i - 1)%nat with i by lia.
  replace (a2 * u i) with (a1 * u (Datatypes.S i) - u (Datatypes.S (Datatypes.S i))) by (rewrite u_SS; ring).
  clear C H; cbn [Nat.add]; generalize dependent (u (Datatypes.S (Datatypes.S i)));
    generalize dependent (u (Datatypes.S i)).
  generalize dependent (u (Datatypes.S j)); generalize dependent (u j); intros uj Hj uj' ui Hi ui'.
  rewrite E1, E2; field; auto.
Qed.
End Periods.

(** ** Bounds on compact times *)
Definition entry (f : R -> R) : Prop := f = e11 \/ f = S \/ f = e21 \/ f = V.
Definition bounds (n_max : nat) (K : R) : Prop := 1 <= K /\
  (forall f, entry f -> forall t t', Rabs t <= T * INR n_max + 2 -> Rabs t' <= T * INR n_max + 2 ->
   Rabs (f t) <= K /\ Rabs (f t - f t') <= K * Rabs (t - t')) /\
  forall n t, (n <= n_max)%nat -> turned S n 0 <> 0 -> Rabs t <= / K -> / K <= Rabs (turned S n t).

Lemma turns_in n n_max t : (n <= n_max)%nat -> Rabs t <= 2 -> Rabs (T * INR n + t) <= T * INR n_max + 2.
Proof.
  intros Hn Ht; apply le_abs in Ht; pose proof (turn_large m); pose proof (pos_INR n); pose proof (le_INR n n_max Hn).
  assert (0 <= T * INR n <= T * INR n_max) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_l]; lra).
  apply Rabs_le; lra.
Qed.

Lemma turned_abs f n t : Rabs (turned f n t) = Rabs (f (T * INR n + t)).
Proof. unfold turned; rewrite Rabs_mult, side_abs; ring. Qed.

Lemma bounded n_max : exists K, bounds n_max K.
Proof.
  set (X := T * INR n_max + 2); assert (HX : 2 <= X).
  { unfold X; pose proof (turn_large m); pose proof (pos_INR n_max);
      assert (0 <= T * INR n_max) by (apply Rmult_le_pos; lra); lra. }
  destruct (continuous_bounded S X ltac:(lra)) as (B1 & P1 & H1); [intros; eapply D_continuous, (D_S c k S V HS)|].
  destruct (continuous_bounded V X ltac:(lra)) as (B2 & P2 & H2); [intros; eapply D_continuous, (D_V c k S V HS)|].
  destruct (margin (fun n _ => turned S n 0) (1 + n_max)) as (g & Hg & Mg).
  set (B := B1 + B2); set (K0 := (1 + Rabs c + Rabs k) * B).
  pose proof (Rabs_pos c) as Pc; pose proof (Rabs_pos k) as Pk.
  assert (Q1 : 0 <= Rabs c * B) by (apply Rmult_le_pos; unfold B; lra).
  assert (Q2 : 0 <= Rabs k * B) by (apply Rmult_le_pos; unfold B; lra).
  assert (PB : 0 <= B) by (unfold B; lra).
  assert (E0 : K0 = B + Rabs c * B + Rabs k * B) by (unfold K0; ring).
  assert (bS : forall t, Rabs t <= X -> Rabs (S t) <= B) by (intros t Ht; specialize (H1 t Ht); unfold B; lra).
  assert (bV : forall t, Rabs t <= X -> Rabs (V t) <= B) by (intros t Ht; specialize (H2 t Ht); unfold B; lra).
  assert (bc : forall a t f, (forall t, Rabs t <= X -> Rabs (f t) <= B) -> Rabs t <= X ->
    Rabs (a * f t) <= Rabs a * B).
  { intros a t f Hf Ht; apply product; [lra | auto]. }
  assert (all : forall f, entry f -> exists f', (forall t, derivable_pt_lim f t (f' t)) /\
    forall t, Rabs t <= X -> Rabs (f t) <= K0 /\ Rabs (f' t) <= K0).
  { intros f [->|[->|[->| ->]]].
    - exists e21; split; [apply (D_e11 c k S V HS)|]; intros t Ht; unfold Flow.e11, Flow.e21.
      pose proof (bc c t S bS Ht); pose proof (bc (- k) t S bS Ht); rewrite Rabs_Ropp in *.
      pose proof (Rabs_triang (V t) (c * S t)); specialize (bV t Ht); split; lra.
    - exists V; split; [apply (D_S c k S V HS)|]; intros t Ht; specialize (bS t Ht); specialize (bV t Ht); split; lra.
    - exists (fun t => - k * V t); split; [apply (D_e21 c k S V HS)|]; intros t Ht; unfold Flow.e21.
      pose proof (bc (- k) t S bS Ht); pose proof (bc (- k) t V bV Ht); rewrite Rabs_Ropp in *; split; lra.
    - exists (fun t => - c * V t - k * S t); split; [apply (D_V c k S V HS)|]; intros t Ht.
      pose proof (bc k t S bS Ht); pose proof (bc (- c) t V bV Ht); rewrite Rabs_Ropp in *.
      pose proof (apart (- c * V t) (k * S t)); specialize (bV t Ht); split; lra. }
  assert (K0p : 0 <= K0) by lra.
  assert (G1 : 0 < / g) by (apply Rinv_0_lt_compat, Hg); assert (G2 : 0 <= K0 * / g) by (apply Rmult_le_pos; lra).
  set (K := 1 + K0 + 2 * / g + 2 * (K0 * / g)); assert (HK : 1 <= K) by (unfold K; lra).
  exists K; split; [exact HK | split].
  - intros f Hf t t' Ht Ht'; destruct (all f Hf) as (f' & D & Bd); split.
    + destruct (Bd t Ht); unfold K; lra.
    + apply (Rle_trans _ (K0 * Rabs (t - t'))); [|apply Rmult_le_compat_r; [apply Rabs_pos | unfold K; lra]].
      apply (mvt_ball f f' X); trivial; intros; apply Bd; assumption.
  - intros n t Hn HSn Ht; assert (IK : 0 < / K) by (apply Rinv_0_lt_compat; lra).
    assert (IK1 : / K <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
    assert (Eg : K * g >= 2 + 2 * K0).
    { replace (K * g) with (g + K0 * g + 2 + 2 * K0) by (unfold K; field; lra).
      assert (0 <= K0 * g) by (apply Rmult_le_pos; lra); lra. }
    assert (Hgk : (1 + K0) * / K <= g / 2).
    { apply (Rmult_le_reg_r K); [lra|]; rewrite Rmult_assoc, Rinv_l; lra. }
    destruct (all S ltac:(right; left; reflexivity)) as (f' & D & Bd).
    pose proof (mvt_ball S f' X K0 (T * INR n + 0) (T * INR n + t) D (fun x Hx => proj2 (Bd x Hx))
      (turns_in n n_max 0 Hn ltac:(rewrite Rabs_R0; lra)) (turns_in n n_max t Hn ltac:(lra))) as L.
    apply from in L; rewrite <- (turned_abs S n 0), <- (turned_abs S n t) in L.
    replace (T * INR n + 0 - (T * INR n + t)) with (- t) in L by ring; rewrite Rabs_Ropp in L.
    pose proof (Mg n 0%nat ltac:(lia) ltac:(lia) HSn).
    assert (K0 * Rabs t <= K0 * / K) by (apply Rmult_le_compat_l; lra); lra.
Qed.

(** A leg of n turns and the time t, from the place x to y. *)
Definition aft_leg n t x y := aft_of (turned e11 n t) (turned S n t) x y.
Definition bef_leg n t x y := bef_of (turned e11 n t) (turned S n t) (turned e21 n t) (turned V n t) x y.

Section Bounded.
Variables (n_max : nat) (K : R).
Hypothesis HK : bounds n_max K.

Lemma turned_bounds f n t t' : entry f -> (n <= n_max)%nat -> Rabs t <= 2 -> Rabs t' <= 2 ->
  Rabs (turned f n t) <= K /\ Rabs (turned f n t') <= K /\ Rabs (turned f n t - turned f n t') <= K * Rabs (t - t').
Proof.
  destruct HK as (_ & B & _); intros Hf Hn Ht Ht'; pose proof (turns_in n n_max t Hn Ht) as I;
    pose proof (turns_in n n_max t' Hn Ht') as I'.
  rewrite (turned_abs f n t), (turned_abs f n t'); destruct (B f Hf _ _ I I') as [B1 B2]; split; [exact B1|];
    split; [apply (B f Hf _ _ I' I)|].
  unfold turned; rewrite <- Rmult_minus_distr_l, Rabs_mult, side_abs, Rmult_1_l.
  replace (t - t') with (T * INR n + t - (T * INR n + t')) by ring; exact B2.
Qed.

Lemma one_leg n t t' w x y : (n <= n_max)%nat -> turned S n 0 <> 0 -> Rabs t <= / K -> Rabs t' <= / K ->
  Rabs x <= w -> Rabs y <= w -> let L := 6 * K ^ 5 in turned S n t <> 0 /\
  Rabs (aft_leg n t x y) <= L * w /\ Rabs (bef_leg n t x y) <= L * w /\
  Rabs (aft_leg n t x y - aft_leg n t' x y) <= L * w * Rabs (t - t') /\
  Rabs (bef_leg n t x y - bef_leg n t' x y) <= L * w * Rabs (t - t').
Proof.
  intros Hn HSn Ht Ht' Hx Hy L; destruct HK as (K1 & _ & B).
  assert (IK1 : 0 < / K <= 1) by (split; [apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1; apply Rinv_le_contravar;
    lra]).
  split; [intros E; specialize (B n t Hn HSn Ht); rewrite E, Rabs_R0 in B; lra|].
  apply leg_bounds; auto using Rabs_pos.
  intros f g [[-> ->]|[[-> ->]|[[-> ->]|[-> ->]]]]; apply turned_bounds; unfold entry; auto; lra.
Qed.

(** Two legs near each other, in all of their data. *)
Lemma two_legs n t t' x y x' y' d : (n <= n_max)%nat -> turned S n 0 <> 0 -> Rabs t <= / K -> Rabs t' <= / K ->
  Rabs x <= 2 -> Rabs y <= 2 -> Rabs (t - t') <= d -> Rabs (x - x') <= d -> Rabs (y - y') <= d ->
  let L := 18 * K ^ 5 in turned S n t <> 0 /\ Rabs (aft_leg n t x y - aft_leg n t' x' y') <= L * d /\
  Rabs (bef_leg n t x y - bef_leg n t' x' y') <= L * d.
Proof.
  intros Hn HSn Ht Ht' Hx Hy Dt Dx Dy L.
  destruct (one_leg n t t' 2 x y Hn HSn Ht Ht' Hx Hy) as (N & _ & _ & A & B).
  destruct (one_leg n t' t' d (x - x') (y - y') Hn HSn Ht' Ht' Dx Dy) as (N' & A' & B' & _).
  assert (P : 0 <= 6 * K ^ 5) by (apply Rmult_le_pos; [lra | apply pow_le; destruct HK; lra]).
  assert (6 * K ^ 5 * 2 * Rabs (t - t') <= 6 * K ^ 5 * 2 * d) by (apply Rmult_le_compat_l; lra).
  split; [exact N|]; split.
  - replace (aft_leg n t x y - aft_leg n t' x' y') with
      ((aft_leg n t x y - aft_leg n t' x y) + aft_leg n t' (x - x') (y - y'))
      by (unfold aft_leg, aft_of; field; auto).
    eapply Rle_trans; [apply Rabs_triang | unfold L; lra].
  - replace (bef_leg n t x y - bef_leg n t' x' y') with
      ((bef_leg n t x y - bef_leg n t' x y) + bef_leg n t' (x - x') (y - y'))
      by (unfold bef_leg, bef_of, aft_of; field; auto).
    eapply Rle_trans; [apply Rabs_triang | unfold L; lra].
Qed.
End Bounded.
End Turns.
