(** * The flow over n turns: (59) and (64) are limits of a leg, which depends on its ends in a Lipschitz way *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs Algebra StatementOrbitsPlane StatementOscillator Derivatives Flow PlaneLinear.
Open Scope R_scope.

Lemma facing_plus m y z : facing m (y + z) = facing m y * facing m z.
Proof. destruct m; cbn [facing]; [ring|]; rewrite Z.even_add; destruct (Z.even y), (Z.even z); cbn; ring. Qed.
Lemma side_square m z : facing m z * facing m z = 1.
Proof. destruct m; cbn [facing]; [|destruct (Z.even z)]; ring. Qed.
Lemma side_twice m y z x : facing m y * facing m z * (facing m y * x) = facing m z * x.
Proof. transitivity (facing m y * facing m y * (facing m z * x)); [ring | rewrite side_square; ring]. Qed.
Lemma side_abs m z : Rabs (facing m z) = 1.
Proof. destruct m; cbn [facing]; [|destruct (Z.even z)]; unfold Rabs; destruct Rcase_abs; lra. Qed.
Lemma side_0 m : facing m 0 = 1. Proof. destruct m; reflexivity. Qed.
Lemma turn_large m : 3 <= turn m. Proof. pose proof PI2_3_2; destruct m; cbn [turn]; lra. Qed.

(** A leg of given flow f11, f12, f21, f22 from the place x to y: its velocities after and before the impacts. *)
Definition aft_of f11 f12 x y : R := (y - f11 * x) / f12.
Definition bef_of f11 f12 f21 f22 x y : R := f21 * x + f22 * aft_of f11 f12 x y.

(** |f|, |g| <= B and |f - g| <= e. *)
Definition beside (B e f g : R) : Prop := Rabs f <= B /\ Rabs g <= B /\ Rabs (f - g) <= e.
Lemma beside_plus B e f g B' e' f' g' : beside B e f g -> beside B' e' f' g' ->
  beside (B + B') (e + e') (f + f') (g + g').
Proof.
  intros (F & G & D) (F' & G' & D'); unfold beside; replace (f + f' - (g + g')) with (f - g + (f' - g')) by ring.
  repeat split; (eapply Rle_trans; [apply Rabs_triang | lra]).
Qed.
Lemma beside_times B e f g B' e' f' g' : beside B e f g -> beside B' e' f' g' ->
  beside (B * B') (B * e' + e * B') (f * f') (g * g').
Proof.
  intros (F & G & D) (F' & G' & D'); repeat split; [apply product; assumption..|].
  replace (f * f' - g * g') with (f * (f' - g') + (f - g) * g') by ring.
  eapply Rle_trans; [apply Rabs_triang | apply Rplus_le_compat; apply product; assumption].
Qed.
Lemma beside_over K e f g : 0 < K -> / K <= Rabs f -> / K <= Rabs g -> Rabs (f - g) <= e ->
  beside K (K * K * e) (/ f) (/ g).
Proof.
  intros HK Hf Hg D; pose proof (Rinv_0_lt_compat K HK) as IK.
  assert (inv : forall f, / K <= Rabs f -> f <> 0 /\ Rabs (/ f) <= K).
  { intros y H; rewrite Rabs_inv, <- (Rinv_inv K); split; [intros ->; rewrite Rabs_R0 in H; lra|].
    apply Rinv_le_contravar; assumption. }
  destruct (inv f Hf) as [Nf If], (inv g Hg) as [Ng Ig]; repeat split; [exact If | exact Ig|].
  replace (/ f - / g) with (/ f * / g * (g - f)) by (field; auto); rewrite Rabs_minus_sym in D.
  apply product; [apply product|]; assumption.
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
Lemma powers : exists A11 A21 A22, a1 = A11 + A22 /\ a2 = A11 * A22 - gamma * A21 /\ forall n, turned S n 0 = gamma * u
  n /\ turned V n 0 = u (1 + n) - A11 * u n /\ turned e11 n 0 = u (1 + n) - A22 * u n /\ turned e21 n 0 = A21 * u n.
Proof.
  destruct HA as (A11 & A21 & A22 & E1 & E2 & H); exists A11, A21, A22; split; [exact E1 | split; [exact E2|]].
  destruct (H _ _ (flow_free _ _ _ _ HS)) as [HS1 HV1]; rewrite (flow_S _ _ _ _ HS), (flow_V _ _ _ _ HS) in HS1, HV1.
  destruct (H _ _ (moved_free c k S V HS 0 1 0)) as [H1 H2].
  destruct (moved_start c k S V HS 0 1 0) as [Z1 Z2]; rewrite Z1, Z2 in H1, H2.
  unfold moved, moving in H1, H2; rewrite Rminus_0_r in H1, H2.
  assert (SV : forall n, turned S n 0 = gamma * u n /\ turned V n 0 = u (1 + n) - A11 * u n).
  { unfold turned; induction n as [|n [IH1 IH2]].
    - cbn [Z.of_nat INR Nat.add]; rewrite side_0, Rmult_0_r, Rplus_0_r, (flow_S _ _ _ _ HS), (flow_V _ _ _ _ HS), u_0,
        u_1; lra.
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
  destruct (H i) as (-> & -> & -> & ->), (H j) as (-> & _ & -> & _). pose proof (u_Cassini a1 a2 i) as C.
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
  { unfold X; pose proof (turn_large m); pose proof (pos_INR n_max); assert (0 <= T * INR n_max) by (apply Rmult_le_pos;
      lra); lra. }
  assert (one : forall f f' f'', (forall t, derivable_pt_lim f t (f' t)) -> (forall t, derivable_pt_lim f' t (f'' t)) ->
    exists B, 0 <= B /\ forall t, Rabs t <= X -> Rabs (f t) <= B /\ Rabs (f' t) <= B).
  { intros f f' f'' D D'.
    destruct (continuous_bounded f X ltac:(lra) (fun t => D_continuous _ _ _ (D t))) as (B & P & H).
    destruct (continuous_bounded f' X ltac:(lra) (fun t => D_continuous _ _ _ (D' t))) as (B' & P' & H').
    exists (B + B'); split; [lra|]; intros t Ht; specialize (H t Ht); specialize (H' t Ht); lra. }
  pose proof (D_S c k S V HS) as DS; pose proof (D_V c k S V HS) as DV; pose proof (D_e11 c k S V HS) as D1;
    pose proof (D_e21 c k S V HS) as D2.
  destruct (one _ _ _ D1 D2) as (B1 & P1 & H1), (one _ _ _ DS DV) as (B2 & P2 & H2).
  destruct (one _ _ _ D2 (fun t => D_scale V t _ (- k) (DV t))) as (B3 & P3 & H3).
  destruct (one _ _ _ DV (fun t => D_minus _ _ t _ _ (D_scale V t _ (- c) (DV t)) (D_scale S t _ k (DS t))))
    as (B4 & P4 & H4).
  set (B := B1 + B2 + B3 + B4); assert (all : forall f, entry f -> exists f', (forall t, derivable_pt_lim f t (f' t)) /\
    forall t, Rabs t <= X -> Rabs (f t) <= B /\ Rabs (f' t) <= B).
  { intros f [->|[->|[->| ->]]]; eexists; (split; [first [exact D1 | exact DS | exact D2 | exact DV]|]); intros t Ht;
      specialize (H1 t Ht); specialize (H2 t Ht); specialize (H3 t Ht); specialize (H4 t Ht); unfold B; lra. }
  destruct (margin (fun n _ => turned S n 0) (1 + n_max)) as (g & Hg & Mg); pose proof (Rinv_0_lt_compat g Hg) as G1.
  assert (HB : 0 <= B * / g) by (apply Rmult_le_pos; unfold B; lra).
  set (K := 1 + B + 2 * / g + 2 * (B * / g)); assert (HK : 1 <= K /\ 0 <= B <= K) by (unfold K, B in *; lra).
  exists K; split; [apply HK | split].
  - intros f Hf t t' Ht Ht'; destruct (all f Hf) as (f' & D & Bd); split; [destruct (Bd t Ht); lra|].
    apply (Rle_trans _ (B * Rabs (t - t'))); [|apply Rmult_le_compat_r; [apply Rabs_pos | lra]].
    apply (mvt_ball f f' X); trivial; intros; apply Bd; assumption.
  - intros n t Hn HSn Ht; assert (IK1 : / K <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
    assert (Eg : K * g >= 2 + 2 * B).
    { replace (K * g) with (g + B * g + 2 + 2 * B) by (unfold K; field; lra).
      assert (0 <= B * g) by (apply Rmult_le_pos; lra); lra. }
    assert (Hgk : (1 + B) * / K <= g / 2).
    { apply (Rmult_le_reg_r K); [lra|]; rewrite Rmult_assoc, Rinv_l; lra. }
    destruct (all S ltac:(right; left; reflexivity)) as (f' & D & Bd).
    pose proof (mvt_ball S f' X B (T * INR n + 0) (T * INR n + t) D (fun x Hx => proj2 (Bd x Hx))
      (turns_in n n_max 0 Hn ltac:(rewrite Rabs_R0; lra)) (turns_in n n_max t Hn ltac:(lra))) as L.
    apply from in L; rewrite <- (turned_abs S n 0), <- (turned_abs S n t) in L.
    replace (T * INR n + 0 - (T * INR n + t)) with (- t) in L by ring; rewrite Rabs_Ropp in L.
    pose proof (Mg n 0%nat ltac:(lia) ltac:(lia) HSn).
    assert (B * Rabs t <= B * / K) by (apply Rmult_le_compat_l; lra); lra.
Qed.

(** A leg of n turns and the time t, from the place x to y. *)
Definition aft_leg n t x y := aft_of (turned e11 n t) (turned S n t) x y.
Definition bef_leg n t x y := bef_of (turned e11 n t) (turned S n t) (turned e21 n t) (turned V n t) x y.

Section Bounded.
Variables (n_max : nat) (K : R).
Hypothesis HK : bounds n_max K.

Lemma inverse_K : 0 < / K <= 1.
Proof. destruct HK; split; [apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1; apply Rinv_le_contravar; lra]. Qed.
Lemma turned_beside f n t t' e : entry f -> (n <= n_max)%nat -> Rabs t <= 2 -> Rabs t' <= 2 -> Rabs (t - t') <= e ->
  beside K (K * e) (turned f n t) (turned f n t').
Proof.
  destruct HK as (K1 & B & _); intros Hf Hn Ht Ht' He; pose proof (turns_in n n_max t Hn Ht) as I;
    pose proof (turns_in n n_max t' Hn Ht') as I'; unfold beside.
  rewrite (turned_abs f n t), (turned_abs f n t'); destruct (B f Hf _ _ I I') as [B1 B2]; split; [exact B1|]; split;
    [apply (B f Hf _ _ I' I)|].
  unfold turned; rewrite <- Rmult_minus_distr_l, Rabs_mult, side_abs, Rmult_1_l; eapply Rle_trans; [exact B2|].
  replace (T * INR n + t - (T * INR n + t')) with (t - t') by ring; apply Rmult_le_compat_l; lra.
Qed.

(** Two legs near each other, in all of their data. *)
Lemma legs n t t' x y x' y' w e r : (n <= n_max)%nat -> turned S n 0 <> 0 -> Rabs t <= / K -> Rabs t' <= / K ->
  Rabs (t - t') <= r -> beside w e x x' -> beside w e y y' -> let L := 6 * K ^ 5 in turned S n t <> 0 /\
  beside (L * w) (L * (w * r + e)) (aft_leg n t x y) (aft_leg n t' x' y') /\
  beside (L * w) (L * (w * r + e)) (bef_leg n t x y) (bef_leg n t' x' y').
Proof.
  intros Hn HSn Ht Ht' Hr Hx Hy L; pose proof inverse_K as IK; destruct HK as (K1 & _ & low).
  pose proof (low n t Hn HSn Ht) as N; pose proof (low n t' Hn HSn Ht') as N'.
  assert (F : forall f, entry f -> beside K (K * r) (turned f n t) (turned f n t')) by (intros f Hf;
    apply turned_beside; trivial; lra).
  pose proof (beside_over K _ _ _ ltac:(lra) N N' (proj2 (proj2 (F S ltac:(unfold entry; auto))))) as Q.
  pose proof (beside_times _ _ _ _ _ _ _ _ (F e11 ltac:(unfold entry; auto)) Hx) as P.
  assert (P' : beside (K * w) (K * e + K * r * w) (- (turned e11 n t * x)) (- (turned e11 n t' * x'))).
  { destruct P as (A & B & D); unfold beside; rewrite !Rabs_Ropp; repeat split; trivial.
    replace (_ - _) with (turned e11 n t' * x' - turned e11 n t * x) by ring; rewrite Rabs_minus_sym; exact D. }
  pose proof (beside_times _ _ _ _ _ _ _ _ (beside_plus _ _ _ _ _ _ _ _ Hy P') Q) as A.
  pose proof (beside_plus _ _ _ _ _ _ _ _ (beside_times _ _ _ _ _ _ _ _ (F e21 ltac:(unfold entry; auto)) Hx)
    (beside_times _ _ _ _ _ _ _ _ (F V ltac:(unfold entry; auto 6)) A)) as B.
  assert (up : forall z, 0 <= z -> z <= K * z) by (intros z Hz; rewrite <- (Rmult_1_l z) at 1; apply Rmult_le_compat_r;
    lra).
  assert (pos : forall z, 0 <= z -> 0 <= K * z) by (intros; apply Rmult_le_pos; lra).
  assert (chain : forall z, 0 <= z -> z <= K * z /\ K * z <= K * (K * z) /\ K * (K * z) <= K * (K * (K * z)) /\
    K * (K * (K * z)) <= K * (K * (K * (K * z))) /\ K * (K * (K * (K * z))) <= K * (K * (K * (K * (K * z))))).
  { intros z Hz; repeat split; apply up; auto 6. }
  assert (Pw : 0 <= w) by (eapply Rle_trans; [apply Rabs_pos | apply Hx]).
  assert (Pe : 0 <= e) by (eapply Rle_trans; [apply Rabs_pos | apply Hx]).
  assert (Pr : 0 <= w * r) by (apply Rmult_le_pos; [exact Pw | eapply Rle_trans; [apply Rabs_pos | exact Hr]]).
  pose proof (chain _ Pw); pose proof (chain _ Pe); pose proof (chain _ Pr); split; [intros E; rewrite E, Rabs_R0 in N;
    lra|].
  unfold aft_leg, bef_leg, bef_of, aft_of, Rdiv, Rminus; fold L.
  destruct A as (A1 & A2 & A3), B as (B1 & B2 & B3); unfold beside, L; repeat split;
    (eapply Rle_trans; [eassumption | lra]).
Qed.
End Bounded.
End Turns.
