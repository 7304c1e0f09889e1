(** * Near an impact that comes again, from one impact to the next: a map, and its derivative *)
From Coq Require Import Reals Lra.
From Grazing Require Import Defs StatementPlane StatementAttractor StatementOscillator Derivatives Flow.
From Grazing Require Import Contraction AttractorDerivative ResonanceHop ResonanceLimits.
Open Scope R_scope.

Section Return.
Variables (c k : R) (S V : R -> R).
Hypothesis HS : flow c k S V.
Variables (Q Q1 Q2 : R -> R) (T q tau : R).
Hypothesis HT : 0 < T.
Hypothesis HQ : forall x, Q (x + T) = Q x.
Hypothesis D1 : forall x, derivable_pt_lim Q x (Q1 x).
Hypothesis D2 : forall x, derivable_pt_lim Q1 x (Q2 x).
Hypothesis Hq : forall x, S (T + x) = q * S x /\ V (T + x) = q * V x.
Hypothesis Hq1 : -1 <= q <= 1.
Notation place := (place c S V Q).
Notation velocity := (velocity k S V Q).
Notation hop := (hop c k S V Q Q1 T tau).

(** The impact (s0, w0) comes again; it is not touched on the way. *)
Variables s0 w0 : R.
Hypothesis Z0 : Q s0 = 0.
Hypothesis B0 : 0 < Q1 s0 - q * w0.
Hypothesis A0 : 0 < w0 - Q1 s0.
Hypothesis W0 : w0 = (1 + tau) * Q1 s0 - tau * (q * w0).
Hypothesis C0 : forall x, 0 < x < T -> Q (s0 + x) < S x * w0.
Notation b := (Q1 s0 - q * w0).

(** The stop above the motion about n periods later; it is 0 at the next impact. *)
Definition depth s w x : R := Q (s + x) - q * place s w x.
Lemma D_depth s w x : derivable_pt_lim (depth s w) x (Q1 (s + x) - q * velocity s w x).
Proof. apply D_minus; [apply D_on, D1 | apply D_scale, (D_place c k S V HS)]. Qed.
Definition root (h s w : R) : R := the (fun x => - h <= x <= h /\ depth s w x = 0).

(** ** Near (s0, w0) *)
Definition size3 (z : R * R * R) : R := Rabs (fst (fst z)) + Rabs (snd (fst z) - s0) + Rabs (snd z - w0).
Definition size2 (z : R * R) : R := norm (sub z (s0, w0)).
Lemma size2_le s w d : size2 (s, w) <= d <-> Rabs (s - s0) <= d /\ Rabs (w - w0) <= d.
Proof. apply (norm_le (s - s0, w - w0)). Qed.
Lemma continuous_at f f' x : (forall x, derivable_pt_lim f x (f' x)) -> continuity_pt f x.
Proof. intros H; exact (D_continuous _ _ _ (H x)). Qed.
Let cQ := continuous_at _ _ s0 D1.
Let cQ1 := continuous_at _ _ s0 D2.

Lemma joint : tends _ size3 (fun z => velocity (snd (fst z)) (snd z) (fst (fst z))) w0 /\
  tends _ size3 (fun z => Q1 (snd (fst z) + fst (fst z))) (Q1 s0).
Proof.
  assert (ok : forall z, Rabs (fst (fst z) - 0) <= size3 z /\ Rabs (snd (fst z) - s0) <= size3 z /\
    Rabs (snd z - w0) <= size3 z).
  { intros z; unfold size3; rewrite Rminus_0_r; pose proof (Rabs_pos (fst (fst z)));
    pose proof (Rabs_pos (snd (fst z) - s0)). pose proof (Rabs_pos (snd z - w0)); lra. }
  pose proof (tends_size _ size3 _ _ (fun z => proj1 (ok z))) as tx; pose proof (tends_size _ size3 _ _ (fun z =>
    proj1 (proj2 (ok z)))) as ts; pose proof (tends_size _ size3 _ _ (fun z => proj2 (proj2 (ok z)))) as tw; split.
  - pose proof (tends_of _ _ _ _ _ (continuous_at _ _ 0 (D_e21 c k S V HS)) tx) as A.
    pose proof (tends_of _ _ _ _ _ (continuous_at _ _ 0 (D_V c k S V HS)) tx) as B.
    refine (tends_at _ _ _ _ _ (tends_plus _ _ _ _ _ _ (tends_mult _ _ _ _ _ _ A (tends_of _ _ _ _ _ cQ ts))
      (tends_mult _ _ _ _ _ _ B tw)) _); rewrite Z0, (flow_V _ _ _ _ HS); ring.
  - pose proof (tends_plus _ _ _ _ _ _ ts tx) as H; rewrite Rplus_0_r in H; exact (tends_of _ _ _ _ _ cQ1 H).
Qed.

(** A neighbourhood in which the motion leaves and comes back at speeds of at least a/2 and b/2. *)
Record close (h B : R) : Prop := {
  close_h : 0 < h <= T / 2;
  close_B : 0 < B;
  close_slope : forall x, Rabs x <= h -> Rabs (Q1 (s0 + x)) <= B;
  close_out : forall s w x, Rabs (s - s0) <= h -> Rabs (w - w0) <= h -> Rabs x <= h ->
    (w0 - Q1 s0) / 2 <= velocity s w x - Q1 (s + x);
  close_in : forall s w x, Rabs (s - s0) <= h -> Rabs (w - w0) <= h -> Rabs x <= h ->
    b / 2 <= Q1 (s + x) - q * velocity s w x }.
Lemma close_exists : exists h B, close h B.
Proof.
  destruct joint as [J1 J2]; destruct (two_least _ _ A0 B0) as (e & He & E1 & E2).
  destruct (J1 (e / 4) ltac:(lra)) as (d & Hd & P), (J2 (e / 4) ltac:(lra)) as (d' & Hd' & P').
  destruct (two_least d d' Hd Hd') as (h1 & H1 & L1 & L2), (two_least (h1 / 3) (T / 2) ltac:(lra) ltac:(lra))
    as (h & Hh & L3 & L4). assert (P1 : forall s w x, Rabs (s - s0) <= h -> Rabs (w - w0) <= h -> Rabs x <= h ->
    Rabs (velocity s w x - w0) <= e / 4 /\ Rabs (Q1 (s + x) - Q1 s0) <= e / 4).
  { intros s w x Hs Hw Hx; split; [apply (P (x, s, w)) | apply (P' (x, s, w))]; unfold size3; cbn [fst snd]; lra. }
  exists h, (Rabs (Q1 s0) + e); constructor; [lra | pose proof (Rabs_pos (Q1 s0)); lra | | |].
  - intros x Hx; destruct (P1 s0 w0 x) as [_ A]; rewrite ?Rminus_eq_0, ?Rabs_R0; try lra; apply from in A; lra.
  - intros s w x Hs Hw Hx; destruct (P1 s w x Hs Hw Hx) as [A B]; apply le_abs in A, B; lra.
  - intros s w x Hs Hw Hx; destruct (P1 s w x Hs Hw Hx) as [A B]; apply le_abs in B.
    pose proof (product q _ 1 _ ltac:(apply Rabs_le; lra) A) as A'; apply le_abs in A'; lra.
Qed.

Section Close.
Variables h B : R.
Hypothesis HC : close h B.
Notation sigma := (root h).
(** How near the impact must be for its root to lie within h. *)
Definition reach : R := Rmin h (b * h / (8 * B)).
Lemma reach_is : 0 < reach /\ reach <= h /\ 8 * B * reach <= b * h.
Proof.
  destruct HC as [[Hh _] HB _ _ _]; unfold reach; assert (P : 0 < b * h / (8 * B)).
  { apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra | lra]. }
  split; [apply Rmin_glb_lt; assumption|]; split; [apply Rmin_l|].
  apply (Rle_trans _ (8 * B * (b * h / (8 * B)))); [apply Rmult_le_compat_l; [lra | apply Rmin_r] | right; field; lra].
Qed.
Lemma rises s w x x' : Rabs (s - s0) <= h -> Rabs (w - w0) <= h -> - h <= x -> x < x' -> x' <= h ->
  b / 2 * (x' - x) <= depth s w x' - depth s w x.
Proof.
  intros Hs Hw L1 L2 L3; destruct (MVT_cor2 (depth s w) _ x x' L2 (fun y _ => D_depth s w y)) as (y & -> & Hy).
  apply Rmult_le_compat_r; [lra|]; apply (close_in _ _ HC); trivial; apply Rabs_le; lra.
Qed.
Lemma low s : Rabs (s - s0) <= h -> Rabs (Q s) <= B * Rabs (s - s0).
Proof.
  intros Hs; pose proof (mvt (fun x => Q (s0 + x)) (fun x => Q1 (s0 + x)) (s - s0) 0 B (fun x => D_on _ _ _ _ (D1
    _))) as L.
  cbv beta in L; rewrite Rplus_0_r, Z0, !Rminus_0_r in L; replace (s0 + (s - s0)) with s in L by ring; apply L.
  intros x Hx; apply (close_slope _ _ HC); apply le_abs in Hs; apply Rabs_le; revert Hx; unfold Rmin, Rmax.
  destruct (Rle_dec (s - s0) 0); lra.
Qed.
Lemma sigma_is s w : Rabs (s - s0) <= reach -> Rabs (w - w0) <= reach ->
  - h <= sigma s w <= h /\ depth s w (sigma s w) = 0 /\ b * Rabs (sigma s w) <= 4 * B * Rabs (s - s0).
Proof.
  intros Hs Hw; destruct reach_is as (R1 & R2 & R3), HC as [[Hh _] HB _ _ _].
  pose proof (low s ltac:(lra)) as L; assert (E : Rabs (depth s w 0) <= 2 * (B * Rabs (s - s0))).
  { unfold depth; rewrite Rplus_0_r, (proj1 (place_0 c k S V HS Q s w)).
    replace (Q s - q * Q s) with ((1 - q) * Q s) by ring; apply product; [apply Rabs_le; lra | exact L]. }
  assert (B * Rabs (s - s0) <= B * reach) by (apply Rmult_le_compat_l; lra).
  assert (F : Rabs (depth s w 0) < b * h / 2).
  { assert (0 < b * h) by (apply Rmult_lt_0_compat; lra); lra. } apply Rabs_def2 in F.
  pose proof (rises s w 0 h ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as U.
  pose proof (rises s w (- h) 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as U'.
  destruct (IVT (depth s w) (- h) h) as (x & I & Z); [intros x;
    exact (D_continuous _ _ _ (D_depth s w x)) | lra | lra | lra|].
  assert (E0 : sigma s w = x) by (apply the_spec; [auto|]; intros x' [I' Z']; destruct (Rtotal_order x' x) as [O|[O|O]];
    [pose proof (rises s w x' x) as X | exact O | pose proof (rises s w x x') as X]; specialize (X ltac:(lra) ltac:(lra)
    ltac:(lra) O ltac:(lra)); nra).
  rewrite <- E0 in I, Z; split; [exact I|]; split; [exact Z|].
  apply le_abs in E; unfold Rabs at 1; destruct (Rcase_abs (sigma s w)) as [N|N].
  - pose proof (rises s w (sigma s w) 0 ltac:(lra) ltac:(lra) ltac:(lra) N ltac:(lra)); lra.
  - destruct N as [N|N]; [|rewrite N, Rmult_0_r; pose proof (Rabs_pos (s - s0)); nra].
    pose proof (rises s w 0 (sigma s w) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)); lra.
Qed.

(** ** The map *)
Definition F (z : R * R) : R * R := let '(s, w) := z in
  (s + sigma s w, (1 + tau) * Q1 (s + sigma s w) - tau * (q * velocity s w (sigma s w))).
Lemma F_fixed : F (s0, w0) = (s0, w0).
Proof.
  destruct reach_is as (R1 & _); destruct (sigma_is s0 w0) as (_ & _ & E); rewrite ?Rminus_eq_0, ?Rabs_R0 in *;
    try lra. rewrite Rmult_0_r in E; pose proof (Rabs_pos (sigma s0 w0)).
  assert (Z : Rabs (sigma s0 w0) = 0) by nra; unfold F; assert (sigma s0 w0 = 0) as ->.
  { destruct (Req_dec (sigma s0 w0) 0) as [|N]; [assumption | exfalso; exact (Rabs_no_R0 _ N Z)]. }
  rewrite Rplus_0_r, (proj2 (place_0 c k S V HS Q s0 w0)), <- W0; reflexivity.
Qed.

(** The gap is open until then. *)
Lemma clear_near : exists r, 0 < r <= reach /\ forall s w, Rabs (s - s0) <= r -> Rabs (w - w0) <= r ->
  let (s', w') := F (s, w) in hop s w s' w'.
Proof.
  destruct reach_is as (R1 & R2 & R3), HC as [[Hh HhT] HB _ Hout Hin].
  destruct (continuous_bounded (e11 c S V) (T + 1) ltac:(lra) (fun x => continuous_at _ _ x (D_e11 c k S V HS)))
    as (K1 & P1 & H1).
  destruct (continuous_bounded S (T + 1) ltac:(lra) (fun x => continuous_at _ _ x (D_S c k S V HS))) as (K2 & P2 &
    H2). pose proof (Rabs_pos s0) as Ps; destruct (continuous_bounded Q1 (Rabs s0 + h + T + 1) ltac:(lra)
    (fun x => continuous_at _ _ x D2)) as (K3 & P3 & H3).
  assert (Mid : exists kap, 0 < kap /\ forall x, h <= x <= T - h -> kap <= S x * w0 - Q (s0 + x)).
  { destruct (Rle_lt_dec h (T - h)) as [L|L]; [|exists 1; split; [lra | intros; lra]].
    destruct (continuity_ab_min (fun x => S x * w0 - Q (s0 + x)) h (T - h) L) as (x & Hx & Ix).
    - intros x _; apply (continuous_at _ (fun x => V x * w0 - Q1 (s0 + x))); intros y.
      apply D_minus; [|apply D_on, D1]; derive_by ltac:(apply (D_S c k S V HS)); ring.
    - exists (S x * w0 - Q (s0 + x)); split; [specialize (C0 x ltac:(lra)); lra | intros; apply Hx; assumption]. }
  destruct Mid as (kap & Hk & Mid); set (K := K1 * B + K2 + K3 + 1).
  assert (HK : 1 <= K) by (unfold K; assert (0 <= K1 * B) by (apply Rmult_le_pos; lra); lra).
  destruct (two_least reach (kap / (2 * K)) R1 ltac:(apply Rdiv_lt_0_compat; lra)) as (r & Hr & L1 & L2).
  exists r; split; [lra|]; intros s w Hs Hw; destruct (sigma_is s w ltac:(lra) ltac:(lra)) as (I & Z & _).
  unfold F; set (g := sigma s w) in *; assert (Eg : T + (s + g) - s = T + g) by ring.
  destruct (place_0 c k S V HS Q s w) as [Y0 U0]; constructor; rewrite Eg.
  - lra.
  - intros x Hx; destruct (Rle_lt_dec x h) as [X1|X1]; [|destruct (Rle_lt_dec x (T - h)) as [X2|X2]].
    + destruct (MVT_cor2 (fun x => place s w x - Q (s + x)) (fun x => velocity s w x - Q1 (s + x)) 0 x) as (y & E &
      Hy); [lra | intros; apply D_minus; [apply (D_place c k S V HS) | apply D_on, D1]|]; cbv beta in E.
      rewrite Rplus_0_r, Y0, Rminus_eq_0, !Rminus_0_r in E; specialize (Hout s w y ltac:(lra) ltac:(lra)
        ltac:(apply Rabs_le; lra)).
      assert (0 < (velocity s w y - Q1 (s + y)) * x) by (apply Rmult_lt_0_compat; lra); lra.
    + specialize (Mid x ltac:(lra)); unfold place; pose proof (low s ltac:(lra)) as Lo.
      assert (Rabs x <= T + 1) by (apply Rabs_le; lra). assert (E1 : Rabs (e11 c S V x * Q s) <= K1 * (B * r)).
      { apply product; [apply H1; assumption|]; eapply Rle_trans; [exact Lo | apply Rmult_le_compat_l; lra]. }
      assert (E2 : Rabs (S x * (w - w0)) <= K2 * r) by (apply product; [apply H2|]; assumption).
      assert (E3 : Rabs (Q (s + x) - Q (s0 + x)) <= K3 * Rabs (s + x - (s0 + x))).
      { apply le_abs in Hs; pose proof (Rle_abs s0); pose proof (Rle_abs (- s0)) as A; rewrite Rabs_Ropp in A.
        apply (mvt_ball Q Q1 (Rabs s0 + h + T + 1)); trivial; apply Rabs_le; lra. }
      replace (s + x - (s0 + x)) with (s - s0) in E3 by ring.
      assert (E4 : K3 * Rabs (s - s0) <= K3 * r) by (apply Rmult_le_compat_l; lra).
      assert (E5 : K * r <= kap / 2) by (apply (Rle_trans _ (K * (kap / (2 * K)))); [apply Rmult_le_compat_l; lra |
        right; field; lra]). apply le_abs in E1, E2, E3; unfold K in E5; lra.
    + replace x with (T + (x - T)) by ring; rewrite (place_later c S V Q T q Hq).
      pose proof (rises s w (x - T) g ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as U.
      assert (0 < b / 2 * (g - (x - T))) by (apply Rmult_lt_0_compat; lra); rewrite Z in U; unfold depth in U.
      replace (s + (T + (x - T))) with (s + (x - T) + T) by ring; rewrite HQ; lra.
  - rewrite (place_later c S V Q T q Hq); unfold depth in Z; lra.
  - rewrite (velocity_later k S V Q T q Hq); specialize (Hin s w g ltac:(lra) ltac:(lra) ltac:(apply Rabs_le; lra));
    lra.
  - rewrite (velocity_later k S V Q T q Hq); reflexivity.
Qed.

(** ** Its derivative *)
Lemma F_derivative : exists e, derivative F (s0, w0) (Mat (- tau * q) 0 e (- tau * q)).
Proof.
  destruct reach_is as (R1 & R2 & R3), HC as [[Hh _] HB _ _ _].
  pose proof (flow_S _ _ _ _ HS) as S0; pose proof (flow_V _ _ _ _ HS) as V0.
  destruct (slope_of Q s0 _ (D1 s0)) as (Qd & Q0 & CQ & EQ), (slope_of Q1 s0 _ (D2 s0)) as (Pd & P0 & CP & EP).
  destruct (slope_of S 0 _ (D_S c k S V HS 0)) as (Sd & Sd0 & CS & ES).
  destruct (slope_of V 0 _ (D_V c k S V HS 0)) as (Vd & Vd0 & CV & EV).
  destruct (slope_of _ 0 _ (D_e11 c k S V HS 0)) as (Ed & Ed0 & CE & EE).
  rewrite Z0 in EQ; rewrite S0 in ES; rewrite V0 in EV, Sd0; unfold e11 at 2 in EE; unfold e21 in Ed0.
  rewrite S0, V0 in EE; rewrite S0 in Ed0.
  assert (ts : tends _ size2 fst s0) by (apply tends_size; intros [s w]; apply (proj1 (size2_le s w _) (Rle_refl _))).
  assert (tw : tends _ size2 snd w0) by (apply tends_size; intros [s w]; apply (proj1 (size2_le s w _) (Rle_refl _))).
  set (sg := fun z : R * R => sigma (fst z) (snd z)); assert (tg : tends _ size2 sg 0).
  { intros eps He; destruct (two_least reach (b * eps / (4 * B)) R1) as (d & Hd & L1 & L2).
    { apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra. }
    exists d; split; [exact Hd|]; intros [s w] Hz; apply size2_le in Hz; destruct (sigma_is s w) as (_ & _ & E);
      try lra. rewrite Rminus_0_r; unfold sg; cbn [fst snd]; apply (Rmult_le_reg_l b); [lra|].
    apply (Rle_trans _ (4 * B * (b * eps / (4 * B)))); [|right; field; lra].
    eapply Rle_trans; [exact E | apply Rmult_le_compat_l; lra]. }
  assert (tsg : tends _ size2 (fun z => fst z + sg z) s0) by (eapply tends_at; [apply (tends_plus _ _ _ _ _ _ ts tg) |
    ring]). pose proof (tends_of _ _ _ _ _ CQ ts) as tQ; pose proof (tends_of _ _ _ _ _ CQ tsg) as tQ'.
  pose proof (tends_of _ _ _ _ _ CP tsg) as tP; pose proof (tends_of _ _ _ _ _ CS tg) as tS.
  pose proof (tends_of _ _ _ _ _ CV tg) as tV; pose proof (tends_of _ _ _ _ _ CE tg) as tE.
  pose proof (tends_const (R * R) size2 q) as tq.
  assert (ta : tends _ size2 (fun z => fst z - s0) 0) by (eapply tends_at; [apply (tends_minus _ _ _ _ _ _ ts
    (tends_const _ _ s0)) | ring]).
  rewrite Q0 in tQ, tQ'; rewrite P0 in tP; rewrite Sd0 in tS; rewrite Vd0 in tV; rewrite Ed0 in tE.
  set (den := fun z : R * R => Qd (fst z + sg z) - q * (Ed (sg z) * ((fst z - s0) * Qd (fst z)) + Sd (sg z) * snd z)).
  assert (tden : tends _ size2 den b).
  { eapply tends_at; [apply (tends_minus _ _ _ _ _ _ tQ' (tends_mult _ _ _ _ _ _ tq (tends_plus _ _ _ _ _ _
      (tends_mult _ _ _ _ _ _ tE (tends_mult _ _ _ _ _ _ ta tQ)) (tends_mult _ _ _ _ _ _ tS tw)))) | ring]. }
  set (ra := fun z : R * R => (q * Qd (fst z) - Qd (fst z + sg z)) / den z).
  assert (tr : tends _ size2 ra (- tau * q - 1)).
  { eapply tends_at; [apply (tends_over _ _ _ _ _ _ (Rgt_not_eq _ _ B0) (tends_minus _ _ _ _ _ _
      (tends_mult _ _ _ _ _ _ tq tQ) tQ') tden)|].
    apply (Rmult_eq_reg_r b); [|lra]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra.
    assert (E : tau * b = w0 - Q1 s0) by (rewrite W0 at 2; ring).
    replace ((- tau * q - 1) * b) with (- q * (tau * b) - b) by ring; rewrite E; ring. }
  set (ee := fun z : R * R => (1 + tau) * ((1 + ra z) * Pd (fst z + sg z)) -
    tau * (q * (- k * (sg z * (Sd (sg z) * Qd (fst z))) + ra z * (Vd (sg z) * snd z)))).
  assert (te : exists e, tends _ size2 ee e).
  { pose proof (tends_const (R * R) size2) as tc; eexists; unfold ee.
    apply tends_minus; [apply tends_mult; [apply tc | apply tends_mult; [apply tends_plus; [apply tc | exact tr] |
      exact tP]]|]. apply tends_mult; [apply tc|]; apply tends_mult; [exact tq|]; apply tends_plus.
    - apply tends_mult; [apply tc | apply tends_mult; [exact tg | apply tends_mult; [exact tS | exact tQ]]].
    - apply tends_mult; [exact tr | apply tends_mult; [exact tV | exact tw]]. }
  destruct te as (e & te); exists e; intros eps He.
  destruct (tr eps He) as (d1 & Hd1 & T1), (te eps He) as (d2 & Hd2 & T2), (tden (b / 2) ltac:(lra)) as (d3 & Hd3 & T3).
  destruct (two_least d1 d2 Hd1 Hd2) as (d4 & Hd4 & L1 & L2), (two_least d3 d4 Hd3 Hd4) as (d5 & Hd5 & L3 & L4).
  destruct (two_least d5 reach Hd5 R1) as (d & Hd & L5 & L6); exists d; split; [exact Hd|]; intros [s w] Hz.
  change (norm (sub (s, w) (s0, w0))) with (size2 (s, w)) in *; specialize (T1 (s, w) ltac:(lra)).
  specialize (T2 (s, w) ltac:(lra)); specialize (T3 (s, w) ltac:(lra)); apply le_abs in T3.
  pose proof (proj1 (size2_le s w _) Hz) as [Ns Nw].
  destruct (sigma_is s w ltac:(lra) ltac:(lra)) as (_ & Z & _); set (t := size2 (s, w)) in *.
  assert (Ht : Rabs (s - s0) <= t) by (apply (proj1 (size2_le s w t) (Rle_refl _))).
  assert (Esg : sg (s, w) = (s - s0) * ra (s, w)).
  { unfold ra; apply (Rmult_eq_reg_r (den (s, w))); [|lra].
    replace ((s - s0) * (_ / den (s, w)) * den (s, w)) with ((s - s0) * (q * Qd s - Qd (s + sg (s, w)))) by
      (cbn [fst]; field; lra).
    unfold den; change (sigma s w) with (sg (s, w)) in Z; cbn [fst snd] in *; set (g := sg (s, w)) in *.
    unfold depth, ResonanceHop.place in Z; rewrite (EQ (s + g)), (EQ s), (EE g), (ES g), !Rminus_0_r in Z.
    apply Rminus_diag_uniq; rewrite <- Z; ring. }
  rewrite F_fixed; unfold F; change (sigma s w) with (sg (s, w)); pose proof (EP (s + sg (s, w))) as E1.
  replace (sub (sub _ (s0, w0)) _) with ((s - s0) * (ra (s, w) - (- tau * q - 1)), (s - s0) * (ee (s, w) - e)).
  { apply norm_le; cbn [fst snd]; rewrite (Rmult_comm eps t); split; apply product; assumption. }
  unfold sub, apply; cbn [fst snd m11 m12 m21 m22]; f_equal; [rewrite Esg; ring|].
  unfold ee; cbn [fst snd]; rewrite E1; unfold ResonanceHop.velocity, e21; rewrite (ES (sg _)), (EV (sg _)), (EQ s).
  rewrite !Rminus_0_r; replace (s + sg (s, w) - s0) with ((s - s0) * (1 + ra (s, w))) by (rewrite Esg; ring).
  set (P := Pd _); set (v := Vd _); set (S' := Sd _); set (p1 := Q1 s0) in *.
  apply Rminus_diag_uniq; transitivity (w0 - ((1 + tau) * p1 - tau * (q * w0))); [rewrite Esg; ring | lra].
Qed.
End Close.

Theorem returned : exists (G : R * R -> R * R) e, (exists r, 0 < r /\ forall s w, Rabs (s - s0) <= r ->
  Rabs (w - w0) <= r ->
  let (s', w') := G (s, w) in hop s w s' w') /\ G (s0, w0) = (s0, w0) /\
  derivative G (s0, w0) (Mat (- tau * q) 0 e (- tau * q)).
Proof.
  destruct close_exists as (h & B & HC); destruct (F_derivative h B HC) as (e & D); exists (F h), e.
  split; [|split; [apply (F_fixed h B HC) | exact D]].
  destruct (clear_near h B HC) as (r & Hr & H); exists r; split; [apply Hr | exact H].
Qed.
End Return.
