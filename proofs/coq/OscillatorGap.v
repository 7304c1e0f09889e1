(** * The gaps are open strictly between two impacts: any q with |q|, |q'|, |q''| <= K |mu|, off the stops
      that it passes by kappa |mu| *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOscillator Derivatives Flow OscillatorTurns OscillatorStop.
Open Scope R_scope.

Section Gap.
Variable O : Oscillator.t.
Hypothesis HO : touching O.
Variable m : sign.
Notation G := (Oscillator.G O).
Notation G2 := (Oscillator.G2 O).
Notation T := (turn m).

Lemma whole_turns z : exists y, facing m (y + 0) = 1 /\ turn m * IZR y = 2 * PI * IZR z.
Proof.
  destruct m; [exists z; cbn; split; [reflexivity | ring] | exists (2 * z)%Z; rewrite Z.add_0_r, mult_IZR;
    cbn [facing turn]].
  rewrite Z.even_mul; cbn; split; ring.
Qed.

(** Of the stops that are at the same place at all times, one touches within half a period of t. *)
Lemma near_stop t z : exists y, facing m y = facing m z /\ (forall mu x, G mu (x - T * IZR y) = G mu (x - T * IZR z)) /\
  Rabs (t - T * IZR y) <= PI.
Proof.
  destruct (nearest (t - T * IZR z)) as [i Hi], (whole_turns i) as (j & E1 & E2); exists (z + j)%Z.
  rewrite Z.add_0_r in E1; rewrite facing_plus, E1, plus_IZR, Rmult_plus_distr_l, E2; split; [ring | split].
  - intros mu x; rewrite <- (whole_periods (G mu) i (x - _) (period _ HO mu)); f_equal; ring.
  - replace (t - (T * IZR z + 2 * PI * IZR i)) with (t - T * IZR z - 2 * PI * IZR i) by ring; exact Hi.
Qed.
Lemma D_gap mu z q v t : derivable_pt_lim q t (v t) -> derivable_pt_lim (gap O m mu z q) t (speed O m mu z v t).
Proof. intros H; unfold gap, speed; derive_by ltac:(first [exact H | apply D_at, (slope _ HO)]); ring. Qed.
Lemma D_speed mu z v w t : derivable_pt_lim v t (w t) ->
  derivable_pt_lim (speed O m mu z v) t (facing m z * w t + G2 mu (t - T * IZR z)).
Proof. intros H; unfold speed; derive_by ltac:(first [exact H | apply D_at, (bend _ HO)]); ring. Qed.
Lemma side_bounds z x B : Rabs x <= B -> - B <= facing m z * x <= B.
Proof. intros H; apply le_abs; rewrite Rabs_mult, side_abs; lra. Qed.

(** Every gap is open strictly between two impacts at the phases phi and psi. *)
Definition opens (h K kappa mu : R) : Prop := forall n q v w phi psi, (1 <= n)%nat ->
  (forall t, derivable_pt_lim q t (v t)) -> (forall t, derivable_pt_lim v t (w t)) ->
  (forall t, -1 <= t <= T * INR n + 1 -> Rabs (q t) <= K * Rabs mu /\ Rabs (v t) <= K * Rabs mu /\
    Rabs (w t) <= K * Rabs mu) ->
  Rabs phi <= h * Rabs mu -> Rabs psi <= h * Rabs mu ->
  gap O m mu 0 q phi = 0 -> gap O m mu (Z.of_nat n) q (T * INR n + psi) = 0 ->
  0 <= speed O m mu 0 v phi -> speed O m mu (Z.of_nat n) v (T * INR n + psi) <= 0 ->
  (forall j, (1 <= j <= n - 1)%nat -> kappa * Rabs mu <= facing m (Z.of_nat j) * q (T * INR j) + mu) ->
  forall z t, phi < t < T * INR n + psi -> 0 < gap O m mu z q t.

Lemma gap_open h K kappa : 0 <= h -> 0 < K -> 0 < kappa -> exists mu0, 0 < mu0 /\
  forall mu, 0 < Rabs mu < mu0 -> opens h K kappa mu.
Proof.
  intros Hh HK Hkap; pose proof (turn_large m) as HT; pose proof PI2_3_2 as HP; pose proof (g_pos O HO) as Pg.
  destruct (curved O HO) as (r1 & Hr1 & Cv), (steady_with O HO) as (B & HB & St).
  destruct (two_least r1 (kappa / (2 * (K + B))) ltac:(lra) ltac:(apply Rdiv_lt_0_compat; lra)) as (r & Hr & Hrr & Hrk).
  assert (Hrk' : (K + B) * r <= kappa / 2).
  { apply (Rle_trans _ ((K + B) * (kappa / (2 * (K + B))))); [apply Rmult_le_compat_l; lra | right; field; lra]. }
  destruct (low O HO r ltac:(lra)) as (g & Hg & Low).
  (* mu0: each of these bounds times |mu| *)
  set (g2 := G2 0 0) in *; destruct (two_least (g / 2) (g2 / 4) ltac:(lra) ltac:(lra)) as (e1 & E1 & E2 & E3).
  destruct (two_least e1 (r / 2) E1 ltac:(lra)) as (e & Ee & F1 & F2).
  set (X := h + K + B + 1); assert (HX : 1 <= X) by (unfold X; lra).
  destruct (two_least 1 (e / X) ltac:(lra) ltac:(apply Rdiv_lt_0_compat; lra)) as (mu0 & M0 & M1 & M2).
  exists mu0; split; [exact M0|]; intros mu Hmu n q v w phi psi' Hn Dq Dv Bd Hphi Hpsi Ep Es Vp Vs Mid z t Ht.
  set (a := Rabs mu) in *.
  assert (Xa : X * a <= e) by (apply (Rle_trans _ (X * (e / X))); [apply Rmult_le_compat_l; lra | right; field; lra]).
  assert (0 <= h * a /\ 0 <= K * a /\ 0 <= B * a) as (P1 & P2 & P3) by (repeat split; apply Rmult_le_pos; lra).
  assert (Sum : h * a + K * a + B * a + a <= e) by (replace (_ + a) with (X * a) by (unfold X; ring); exact Xa).
  assert (Hm : - a <= mu <= a) by (apply le_abs; unfold a; lra).
  apply le_abs in Hphi, Hpsi; remember (T * INR n + psi') as psi eqn:Hp.
  assert (Inside : forall y, phi <= y <= psi \/ Rabs y <= r \/ Rabs (y - T * INR n) <= r -> -1 <= y <= T * INR n + 1).
  { assert (0 <= T * INR n) by (apply Rmult_le_pos; [lra | apply pos_INR]).
    intros y [Hy|[Hy|Hy]]; try apply le_abs in Hy; lra. }
  destruct (near_stop t z) as (y & Sy & Gy & Hy).
  replace (gap O m mu z q t) with (gap O m mu y q t) by (unfold gap; rewrite Sy, Gy; reflexivity); clear z Sy Gy.
  pose proof (side_bounds y _ _ (proj1 (Bd t ltac:(apply Inside; lra)))) as Bq.
  destruct (St mu (t - T * IZR y) ltac:(fold a; lra)) as (Sg & _); fold a in Sg; apply le_abs in Sg.
  destruct (Rle_lt_dec r (Rabs (t - T * IZR y))) as [L|L].
  { specialize (Low _ (conj L Hy)); unfold gap; lra. }
  (* t is near the touch of stop y, which is on the way from 0 to n *)
  assert (Ly : - r <= t - T * IZR y <= r) by (apply le_abs; lra).
  assert (HG0 : 0 <= G 0 (t - T * IZR y)) by (apply (G_low O HO), Hy).
  assert (Hn' : INR n = IZR (Z.of_nat n)) by apply INR_IZR_INZ; rewrite Hn' in *.
  assert (Hy0 : (0 <= y <= Z.of_nat n)%Z).
  { split; apply Z.lt_succ_r; apply lt_IZR; rewrite succ_IZR; apply Rnot_le_lt; intros Y.
    - assert (T * IZR y <= T * -1) by (apply Rmult_le_compat_l; lra); lra.
    - assert (T * 1 <= T * (IZR y - IZR (Z.of_nat n))) by (apply Rmult_le_compat_l; lra); lra. }
  assert (Curv : forall i x, -1 <= x <= T * IZR (Z.of_nat n) + 1 -> Rabs (x - T * IZR i) <= r -> 0 < facing m i * w x
    + G2 mu (x - T * IZR i)).
  { intros i x Hx Hi; destruct (Bd x Hx) as (_ & _ & Bw); apply (side_bounds i) in Bw.
    destruct (St mu (x - T * IZR i) ltac:(fold a; lra)) as (_ & _ & S2); fold a in S2; apply le_abs in S2.
    specialize (Cv (x - T * IZR i) ltac:(lra)); lra. }
  destruct (Z.eq_dec y 0) as [->|Hy1]; [|destruct (Z.eq_dec y (Z.of_nat n)) as [->|Hy2]].
  - apply (convex_right (gap O m mu 0 q) _ _ (fun x => D_gap mu 0 q v x (Dq x)) (fun x => D_speed mu 0 v w x (Dv x)) phi
      r); [lra | exact Vp | | lra].
    intros x Hx; assert (Rabs x <= r) by (apply Rabs_le; lra).
    apply Curv; [apply Inside; auto | rewrite Rmult_0_r, Rminus_0_r; assumption].
  - apply (convex_left (gap O m mu (Z.of_nat n) q) _ _ (fun x => D_gap mu _ q v x (Dq x)) (fun x =>
      D_speed mu _ v w x (Dv x)) (T * IZR (Z.of_nat n) - r) psi); [lra | exact Vs | | lra].
    intros x Hx; assert (Rabs (x - T * IZR (Z.of_nat n)) <= r) by (apply Rabs_le; lra).
    apply Curv; [apply Inside|]; auto.
  - set (j := Z.to_nat y); assert (Ej : Z.of_nat j = y) by (unfold j; lia).
    specialize (Mid j ltac:(lia)); rewrite INR_IZR_INZ, Ej in Mid.
    assert (1 <= IZR y <= IZR (Z.of_nat n) - 1) by (rewrite <- minus_IZR; split; apply IZR_le; lia).
    assert (T * 1 <= T * IZR y <= T * (IZR (Z.of_nat n) - 1)) by (split; apply Rmult_le_compat_l; lra).
    assert (Lq : Rabs (q t - q (T * IZR y)) <= K * a * Rabs (t - T * IZR y)).
    { apply (mvt q v _ _ _ Dq); intros x Hx; apply Bd.
      revert Hx; unfold Rmin, Rmax; destruct (Rle_dec _ _); intros; lra. }
    assert (Bq' := side_bounds y _ _ Lq); rewrite Rmult_minus_distr_l in Bq'.
    pose proof (steady_near O HO B mu (t - T * IZR y) (fun x => proj1 (proj2 (St mu x ltac:(fold a; lra))))) as Sn.
    fold a in Sn; apply le_abs in Sn; set (b := Rabs (t - T * IZR y)) in *.
    assert (Y : K * a * b + B * a * b <= kappa / 2 * a).
    { replace (_ + _) with ((K + B) * b * a) by ring; apply Rmult_le_compat_r; [lra|].
      apply (Rle_trans _ ((K + B) * r)); [apply Rmult_le_compat_l; lra | lra]. }
    assert (0 < kappa * a) by (apply Rmult_lt_0_compat; lra). unfold gap; lra.
Qed.
End Gap.
