(** * In units of mu the stop is flat at its top, and Newton's step towards it contracts; elsewhere it is low *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOscillator Derivatives.
Open Scope R_scope.

(** f mu (mu x)/mu for f of slope f' that tends to 0. *)
Lemma scaled_small f f' h eps : 0 <= h -> 0 < eps -> (forall mu x, derivable_pt_lim (f mu) x (f' mu x)) ->
  (forall e, 0 < e -> exists d, 0 < d /\ forall mu x, Rabs mu <= d -> Rabs x <= d -> Rabs (f' mu x) <= e) ->
  exists d, 0 < d /\ forall mu x x', 0 < Rabs mu <= d -> Rabs x <= h -> Rabs x' <= h ->
  Rabs (f mu (mu * x) / mu - f mu (mu * x') / mu) <= eps * Rabs (x - x').
Proof.
  intros Hh He D H; destruct (H eps He) as (d & Hd & P).
  assert (Hd' : 0 < d / (h + 1)) by (apply Rdiv_lt_0_compat; lra).
  assert (E : d / (h + 1) * (h + 1) = d) by (field; lra).
  exists (d / (h + 1)); split; [exact Hd'|]; intros mu x x' Hmu Hx Hx'.
  assert (N : mu <> 0) by (intros ->; rewrite Rabs_R0 in Hmu; lra).
  assert (Le : forall z, Rabs z <= h -> Rabs (mu * z) <= d).
  { intros z Hz; pose proof (product _ _ _ _ (proj2 Hmu) Hz); assert (d / (h + 1) * h <= d) by lra; lra. }
  replace (f mu (mu * x) / mu - f mu (mu * x') / mu) with ((f mu (mu * x) - f mu (mu * x')) * / mu) by (field;
    exact N).
  rewrite Rabs_mult, Rabs_inv; apply (Rmult_le_reg_r (Rabs mu)); [lra|];
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  eapply Rle_trans; [apply (mvt_ball (f mu) (f' mu) d eps); auto|].
  - intros z Hz; apply P; [|exact Hz]; assert (d / (h + 1) <= d); [|lra].
    assert (0 <= d / (h + 1) * h) by (apply Rmult_le_pos; lra); lra.
  - rewrite <- Rmult_minus_distr_l, Rabs_mult; lra.
Qed.

Lemma nearest t : exists z, Rabs (t - 2 * PI * IZR z) <= PI.
Proof.
  pose proof PI_RGT_0 as HP; set (y := t / (2 * PI) + 1 / 2).
  destruct (archimed y) as [A B]; exists (up y - 1)%Z; rewrite minus_IZR.
  assert (E : t = 2 * PI * (y - 1 / 2)) by (unfold y; field; lra).
  set (z := IZR (up y)) in *; apply Rabs_le; split; nra.
Qed.

Section Stop.
Variable O : Oscillator.t.
Hypothesis HO : touching O.
Notation G := (Oscillator.G O).
Notation G1 := (Oscillator.G1 O).
Notation G2 := (Oscillator.G2 O).

Lemma G_turn z mu t : G mu (t + 2 * PI * IZR z) = G mu t.
Proof.
  assert (P : forall j t, G mu (t + 2 * PI * INR j) = G mu t).
  { induction j as [|j IH]; intros y; [cbn; f_equal; ring|].
    rewrite <- (IH y), <- (period _ HO mu (y + 2 * PI * INR j)), S_INR; f_equal; ring. }
  destruct (Z_le_gt_dec 0 z) as [L|L].
  - replace (IZR z) with (INR (Z.to_nat z)) by (rewrite INR_IZR_INZ, Z2Nat.id by lia; reflexivity); apply P.
  - rewrite <- (P (Z.to_nat (- z)) (t + 2 * PI * IZR z)), INR_IZR_INZ, Z2Nat.id, opp_IZR by lia; f_equal; ring.
Qed.

Lemma G_low t : Rabs t <= PI -> 0 <= G 0 t.
Proof.
  intros Ht; apply le_abs in Ht; pose proof PI_RGT_0; destruct (Rtotal_order t 0) as [L|[->|L]].
  - rewrite <- (period _ HO 0 t); left; apply (below _ HO); lra.
  - rewrite (touch _ HO); lra.
  - left; apply (below _ HO); lra.
Qed.

Lemma G1_0 : G1 0 0 = 0.
Proof.
  pose proof PI_RGT_0 as HP; pose (D := (exist _ (G1 0 0) (slope _ HO 0 0)) : derivable_pt (G 0) 0).
  change (derive_pt (G 0) 0 D = 0); apply (deriv_minimum (G 0) (- PI) PI); try lra; intros x H1 H2.
  rewrite (touch _ HO); apply G_low, Rabs_le; lra.
Qed.

Lemma g_pos : 0 < G2 0 0.
Proof. apply (sharp _ HO). Qed.

Lemma steady_with : exists K, 0 <= K /\ forall mu t, Rabs mu <= 1 -> Rabs (G mu t - G 0 t) <= K * Rabs mu /\
  Rabs (G1 mu t - G1 0 t) <= K * Rabs mu /\ Rabs (G2 mu t - G2 0 t) <= K * Rabs mu.
Proof.
  destruct (steady _ HO) as [K H]; exists K; split; [|exact H].
  destruct (H 1 0 ltac:(rewrite Rabs_R1; lra)) as [P _]; rewrite Rabs_R1 in P;
    pose proof (Rabs_pos (G 1 0 - G 0 0)); lra.
Qed.

Lemma steady_near K mu t : (forall t, Rabs (G1 mu t - G1 0 t) <= K * Rabs mu) ->
  Rabs (G mu t - G 0 t) <= K * Rabs mu * Rabs t.
Proof.
  intros H; pose proof (mvt_ball (fun t => G mu t - G 0 t) (fun t => G1 mu t - G1 0 t) (Rabs t) (K * Rabs mu) t 0)
    as L.
  cbv beta in L; rewrite !(touch _ HO), !Rminus_0_r in L; apply L; auto; try lra.
  - intros x; apply D_minus; apply (slope _ HO).
  - rewrite Rabs_R0; apply Rabs_pos.
Qed.

(** What is continuous and 0 at mu = 0, x = 0 is small near there. *)
Lemma jointly_small F (F0 : R -> R) K e : 0 <= K -> 0 < e -> F0 0 = 0 -> continuity_pt F0 0 ->
  (forall mu x, Rabs mu <= 1 -> Rabs (F mu x - F0 x) <= K * Rabs mu) ->
  exists d, 0 < d /\ forall mu x, Rabs mu <= d -> Rabs x <= d -> Rabs (F mu x) <= e.
Proof.
  intros HK He Z C H; destruct (continuous_near F0 0 (e / 2) C ltac:(lra)) as (d & Hd & P); rewrite Z in P.
  destruct (two_least d 1 Hd ltac:(lra)) as (d1 & A1 & A2 & A3).
  destruct (two_least d1 (e / (2 * (K + 1))) A1 ltac:(apply Rdiv_lt_0_compat; lra)) as (d2 & B1 & B2 & B3).
  exists d2; split; [exact B1|]; intros mu x Hmu Hx; specialize (H mu x ltac:(lra)).
  specialize (P x); rewrite !Rminus_0_r in P; specialize (P ltac:(lra)); apply from in H.
  assert (K * Rabs mu <= e / 2); [|lra].
  assert (E : (K + 1) * (e / (2 * (K + 1))) = e / 2) by (field; lra); rewrite <- E.
  apply Rmult_le_compat; try lra; apply Rabs_pos.
Qed.

(** The place of an impact at the time mu x, and a step of Newton's method towards G1 = 0. *)
Definition place mu x : R := -1 - G mu (mu * x) / mu.
Definition chord mu x : R := x - G1 mu (mu * x) / mu / G2 0 0.

Lemma place_mu mu x : mu <> 0 -> mu * place mu x = - mu - G mu (mu * x).
Proof. intros N; unfold place; field; exact N. Qed.

Lemma places : exists B, 0 <= B /\ forall h eps, 0 <= h -> 0 < eps -> exists d, 0 < d <= 1 /\
  forall mu x x', 0 < Rabs mu <= d -> Rabs x <= h -> Rabs x' <= h ->
  Rabs (place mu x - place mu x') <= eps * Rabs (x - x') /\ Rabs (place mu x + 1) <= eps * h /\
  Rabs (chord mu x - chord mu x') <= eps * Rabs (x - x') /\ Rabs (chord mu x) <= B + eps * h.
Proof.
  pose proof g_pos as Pg; destruct steady_with as (K & HK & St).
  assert (Pi : 0 < / G2 0 0) by (apply Rinv_0_lt_compat, Pg).
  exists (K / G2 0 0); split; [apply Rmult_le_pos; lra|]; intros h eps Hh He.
  destruct (scaled_small G G1 h eps Hh He (slope _ HO)) as (d1 & D1 & P1).
  { intros e Pe; apply (jointly_small G1 (G1 0) K e HK Pe G1_0); [|intros; apply St; assumption].
    apply (D_continuous _ (G2 0 0)), (bend _ HO). }
  destruct (scaled_small (fun mu x => x - / G2 0 0 * G1 mu x) (fun mu x => 1 - / G2 0 0 * G2 mu x) h eps Hh He)
    as (d2 & D2 & P2).
  { intros mu x; apply D_minus; [apply D_id | apply D_scale, (bend _ HO)]. }
  { intros e Pe; apply (jointly_small _ (fun x => 1 - / G2 0 0 * G2 0 x) (/ G2 0 0 * K) e); trivial.
    - apply Rmult_le_pos; lra.
    - field; lra.
    - apply continuity_pt_minus; [apply continuity_pt_const; intros ? ?; reflexivity|].
      apply continuity_pt_scal, (sharp _ HO).
    - intros mu x Hmu; replace (_ - _) with (- (/ G2 0 0 * (G2 mu x - G2 0 x))) by ring.
      rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq (/ G2 0 0)), Rmult_assoc by lra; apply Rmult_le_compat_l; [lra|].
      apply St, Hmu. }
  destruct (two_least d1 d2 D1 D2) as (d3 & E1 & E2 & E3); destruct (two_least d3 1 E1 ltac:(lra))
    as (d & F1 & F2 & F3).
  exists d; split; [lra|]; intros mu x x' Hmu Hx Hx'.
  assert (N : mu <> 0) by (intros ->; rewrite Rabs_R0 in Hmu; lra).
  assert (Q1 : forall y z, Rabs y <= h -> Rabs z <= h -> Rabs (place mu y - place mu z) <= eps * Rabs (y - z)).
  { intros y z Hy Hz; specialize (P1 mu y z ltac:(lra) Hy Hz); rewrite Rabs_minus_sym in P1.
    unfold place; replace (_ - _) with (G mu (mu * z) / mu - G mu (mu * y) / mu) by ring; exact P1. }
  assert (Q2 : forall y z, Rabs y <= h -> Rabs z <= h -> Rabs (chord mu y - chord mu z) <= eps * Rabs (y - z)).
  { intros y z Hy Hz; specialize (P2 mu y z ltac:(lra) Hy Hz); cbv beta in P2.
    unfold chord; replace (_ - _) with ((mu * y - / G2 0 0 * G1 mu (mu * y))
      / mu - (mu * z - / G2 0 0 * G1 mu (mu * z)) / mu)
      by (field; lra); exact P2. }
  assert (Z : Rabs 0 <= h) by (rewrite Rabs_R0; exact Hh).
  assert (Hxe : eps * Rabs (x - 0) <= eps * h) by (rewrite Rminus_0_r; apply Rmult_le_compat_l; lra).
  split; [auto|]; split; [|split; [auto|]].
  - pose proof (Q1 x 0 Hx Z) as Q; replace (place mu 0) with (-1) in Q; [|unfold place;
      rewrite Rmult_0_r, (touch _ HO); field; exact N].
    replace (place mu x + 1) with (place mu x - -1) by ring; lra.
  - pose proof (from _ _ _ (Q2 x 0 Hx Z)) as Q; assert (Rabs (chord mu 0) <= K / G2 0 0); [|lra].
    unfold chord; rewrite Rmult_0_r; destruct (St mu 0 ltac:(lra)) as (_ & S1 & _); rewrite G1_0, Rminus_0_r in S1.
    replace (0 - G1 mu 0 / mu / G2 0 0) with (- (G1 mu 0 * / mu * / G2 0 0)) by (unfold Rdiv; ring).
    rewrite Rabs_Ropp, !Rabs_mult, Rabs_inv, (Rabs_pos_eq (/ G2 0 0)) by lra; apply Rmult_le_compat_r; [lra|].
    apply (Rmult_le_reg_r (Rabs mu)); [lra|]; rewrite Rmult_assoc, Rinv_l; lra.
Qed.

(** The stop is flat at its top and turns away from it. *)
Lemma near_top eta : 0 < eta -> exists d, 0 < d /\ forall x, Rabs x <= d ->
  Rabs (G 0 x) <= eta * Rabs x /\ Rabs x <= 2 / G2 0 0 * Rabs (G1 0 x).
Proof.
  intros He; pose proof g_pos as P; assert (Pi : 0 < / G2 0 0) by (apply Rinv_0_lt_compat, P).
  destruct (continuous_near (G1 0) 0 eta) as (d1 & H1 & P1); [eapply D_continuous, (bend _ HO) | exact He|].
  destruct (continuous_near (G2 0) 0 (G2 0 0 / 2)) as (d2 & H2 & P2); [apply (sharp _ HO) | lra|].
  destruct (two_least d1 d2 H1 H2) as (d & Hd & L1 & L2); exists d; split; [exact Hd|]; intros x Hx.
  assert (Z : Rabs 0 <= d) by (rewrite Rabs_R0; lra); rewrite G1_0 in P1; split.
  - pose proof (mvt_ball (G 0) (G1 0) d eta x 0 (slope _ HO 0)) as L; rewrite (touch _ HO), !Rminus_0_r in L.
    apply L; trivial; intros y Hy; specialize (P1 y); rewrite !Rminus_0_r in P1; apply P1; lra.
  - pose proof (mvt_ball (fun x => x - / G2 0 0 * G1 0 x) (fun x => 1 - / G2 0 0 * G2 0 x) d (1 / 2) x 0) as L.
    cbv beta in L; rewrite G1_0, Rmult_0_r, !Rminus_0_r in L; apply from in L; trivial.
    + rewrite Rabs_mult, (Rabs_pos_eq (/ G2 0 0)) in L by lra; unfold Rdiv; lra.
    + intros y; apply D_minus; [apply D_id | apply D_scale, (bend _ HO)].
    + intros y Hy; specialize (P2 y); rewrite Rminus_0_r in P2; specialize (P2 ltac:(lra)).
      replace (1 - / G2 0 0 * G2 0 y) with (- (/ G2 0 0 * (G2 0 y - G2 0 0))) by (field; lra).
      rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq (/ G2 0 0)) by lra.
      apply (Rle_trans _ (/ G2 0 0 * (G2 0 0 / 2))); [apply Rmult_le_compat_l; lra | right; field; lra].
Qed.

(** Away from its top the stop is low; near it, it is curved. *)
Lemma low r : 0 < r <= PI -> exists g, 0 < g /\ forall t, r <= Rabs t <= PI -> g <= G 0 t.
Proof.
  intros Hr; pose proof PI_RGT_0 as HP.
  destruct (continuity_ab_min (G 0) r (2 * PI - r)) as (a & A & Ha); [lra| |].
  { intros x _; apply (D_continuous _ (G1 0 x)), (slope _ HO). }
  exists (G 0 a); split; [apply (below _ HO); lra|]; intros t Ht; unfold Rabs in Ht; destruct (Rcase_abs t).
  - rewrite <- (period _ HO 0 t); apply A; lra.
  - apply A; lra.
Qed.

Lemma curved : exists r, 0 < r <= 1 /\ forall t, Rabs t <= r -> G2 0 0 / 2 <= G2 0 t.
Proof.
  destruct (sharp _ HO) as [C P]; destruct (continuous_near (G2 0) 0 (G2 0 0 / 2) C ltac:(lra)) as (d & Hd & H).
  destruct (two_least 1 d ltac:(lra) Hd) as (r & Hr & L1 & L2); exists r; split; [lra|].
  intros t Ht; specialize (H t ltac:(rewrite Rminus_0_r; lra)); apply le_abs in H; lra.
Qed.
End Stop.
