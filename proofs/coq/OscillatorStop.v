(** * Near its top the stop is flat, and Newton's step towards the top contracts; elsewhere it is low *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOscillator Derivatives.
Open Scope R_scope.

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

Lemma g_pos : 0 < G2 0 0. Proof. apply (sharp _ HO). Qed.

Lemma steady_with : exists K, 0 <= K /\ forall mu t, Rabs mu <= 1 -> Rabs (G mu t - G 0 t) <= K * Rabs mu /\
  Rabs (G1 mu t - G1 0 t) <= K * Rabs mu /\ Rabs (G2 mu t - G2 0 t) <= K * Rabs mu.
Proof.
  destruct (steady _ HO) as [K H]; exists K; split; [|exact H].
  destruct (H 1 0 ltac:(rewrite Rabs_R1; lra)) as [P _]; rewrite Rabs_R1 in P; pose proof (Rabs_pos (G 1 0 - G 0 0));
    lra.
Qed.

Lemma steady_near K mu t : (forall t, Rabs (G1 mu t - G1 0 t) <= K * Rabs mu) ->
  Rabs (G mu t - G 0 t) <= K * Rabs mu * Rabs t.
Proof.
  intros H; pose proof (mvt_ball (fun t => G mu t - G 0 t) (fun t => G1 mu t - G1 0 t) (Rabs t) (K * Rabs mu) t 0) as L.
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

(** A step of Newton's method towards G1 = 0. *)
Definition newton mu x : R := x - / G2 0 0 * G1 mu x.

Lemma flat e : 0 < e -> exists d, 0 < d <= 1 /\ forall mu x x', Rabs mu <= d -> Rabs x <= d -> Rabs x' <= d ->
  Rabs (G mu x - G mu x') <= e * Rabs (x - x') /\ Rabs (newton mu x - newton mu x') <= e * Rabs (x - x').
Proof.
  intros He; destruct steady_with as (K & HK & St); pose proof g_pos as P; pose proof (Rinv_0_lt_compat _ P) as Pi.
  destruct (jointly_small G1 (G1 0) K e HK He G1_0) as (d1 & D1 & P1); [|intros; apply St; assumption|].
  { apply (D_continuous _ (G2 0 0)), (bend _ HO). }
  destruct (jointly_small (fun mu x => 1 - / G2 0 0 * G2 mu x) (fun x => 1 - / G2 0 0 * G2 0 x) (/ G2 0 0 * K) e)
    as (d2 & D2 & P2); [apply Rmult_le_pos; lra | exact He | field; lra | | |].
  { apply continuity_pt_minus; [apply continuity_pt_const; intros ? ?; reflexivity|].
    apply continuity_pt_scal, (sharp _ HO). }
  { intros mu x Hmu; replace (_ - _) with (- / G2 0 0 * (G2 mu x - G2 0 x)) by ring.
    rewrite Rmult_assoc; apply product; [rewrite Rabs_Ropp, Rabs_pos_eq; lra | apply St, Hmu]. }
  destruct (two_least d1 d2 D1 D2) as (d3 & E1 & E2 & E3), (two_least d3 1 E1 ltac:(lra)) as (d & F1 & F2 & F3).
  exists d; split; [lra|]; intros mu x x' Hmu Hx Hx'; split.
  - apply (mvt_ball (G mu) (G1 mu) d); trivial; [apply (slope _ HO)|]; intros y Hy; apply P1; lra.
  - apply (mvt_ball (newton mu) (fun x => 1 - / G2 0 0 * G2 mu x) d); trivial.
    + intros y; apply D_minus; [apply D_id | apply D_scale, (bend _ HO)].
    + intros y Hy; apply P2; lra.
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
