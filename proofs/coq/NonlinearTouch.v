(** * Near the touch: the lowest point of a solution, and how long before it the gap is y^2 above its lowest value *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import StatementOrbits Contraction Derivatives NonlinearCrossing NonlinearGronwall NonlinearFlow.
From Grazing Require NonlinearCrossing.
Module X := NonlinearCrossing.
Open Scope R_scope.

(** The orbit touches at tG, where its acceleration is g > 0. *)
Class touch (F : force) := { tG : R; g : R; HtG : 0 < tG < T; Htouch : y0 tG = 0 /\ v0 tG = 0;
  Hg : 0 < g /\ g = a tG 0 0 0 }.
Section Window.
Context {the_force : force} {the_touch : touch the_force}.
Let HT := HT. Let HL := HL. Let HtG := HtG. Let Hg := Hg.

(** For states and mu within d of the orbit the acceleration is within e of aG, up to r before and after tG. *)
Definition window e r d := 0 < r /\ r <= tG /\ r <= T - tG /\ 0 < d /\ forall x mu t, within 2 d x -> Rabs mu <= d ->
  Rabs (t - tG) <= r -> Rabs (a t (Y x mu t) (V x mu t) mu - g) <= e.
Lemma in_period r t : r <= tG -> r <= T - tG -> Rabs (t - tG) <= r -> 0 <= t <= T.
Proof. intros A B H; apply le_abs in H; lra. Qed.
Lemma window_exists e : 0 < e -> exists r d, window e r d.
Proof.
  intros He; set (q := e / (8 * L)); assert (Hq : 0 < q) by (apply Rdiv_lt_0_compat; lra);
    assert (Lq : L * q = e / 8) by (unfold q; field; lra). destruct (Horb tG) as [D1 D2]; pose proof M_large as LM.
  destruct (continuous_near y0 tG q (D_continuous _ _ _ D1) Hq) as (r1 & R1 & C1),
    (continuous_near v0 tG q (D_continuous _ _ _ D2) Hq) as (r2 & R2 & C2).
  destruct (two_least r1 r2 R1 R2) as (r3 & R3 & L1 & L2), (two_least r3 q R3 Hq) as (r4 & R4 & L3 & L4).
  destruct (two_least r4 (Rmin tG (T - tG)) R4 ltac:(here; apply Rmin_glb_lt; lra)) as (r & Hr & L5 & L6).
  pose proof (Rmin_l tG (T - tG)); pose proof (Rmin_r tG (T - tG)). exists r, (q / M);
    assert (Hd : 0 < q / M) by (apply Rdiv_lt_0_compat; lra); assert (Md : M * (q / M) = q) by (field; lra).
  assert (dq : q / M <= q) by (rewrite <- Md at 2; set (z := q / M) in *; rewrite <- (Rmult_1_l z) at 1;
    apply Rmult_le_compat_r; lra). repeat (split; [lra|]); intros x mu t Hx Hm Ht;
    assert (It : 0 <= t <= T) by (apply (in_period r); lra). destruct (near_y0 x mu _ t Hx Hm It) as [A B];
    rewrite Md in A, B; destruct Hg as [_ ->]. pose proof (C1 t ltac:(here; lra)) as E1;
    pose proof (C2 t ltac:(here; lra)) as E2; destruct Htouch as [Z1 Z2]; rewrite Z1 in E1; rewrite Z2 in E2.
  pose proof (Ha t (Y x mu t) (V x mu t) mu tG 0 0 0) as H1; eapply Rle_trans; [exact H1|].
  assert (Rabs (Y x mu t - 0) <= 2 * q) by (replace (Y x mu t - 0) with ((Y x mu t - y0 t) + (y0 t - 0)) by ring;
    eapply Rle_trans; [apply Rabs_triang | lra]).
  assert (Rabs (V x mu t - 0) <= 2 * q) by (replace (V x mu t - 0) with ((V x mu t - v0 t) + (v0 t - 0)) by ring;
    eapply Rle_trans; [apply Rabs_triang | lra]). rewrite !Rminus_0_r in *; apply Rle_trans with (L * (8 * q));
    [apply Rmult_le_compat_l; lra | lra].
Qed.
Lemma window_down e r d r' d' : window e r d -> 0 < r' <= r -> 0 < d' <= d -> window e r' d'.
Proof.
  intros (A & B & C & D & H) Hr Hd; repeat (split; [lra|]); intros x mu t Hx Hm Ht; apply H; [|lra|lra]. intros i Hi;
    specialize (Hx i Hi); lra.
Qed.
End Window.

(** A window in which the acceleration is between 3/4 g and 5/4 g. *)
Class near {F : force} (P : touch F) := { r0 : R; d0 : R; Hwin : window (g / 4) r0 d0; Hd0 : 8 * (M * d0) <= g * r0 }.
Section Touch.
Context {the_force : force} {the_touch : touch the_force} {the_window : near the_touch}.
Let HT := HT. Let HL := HL. Let HtG := HtG. Let Hg := Hg. Let Hd0 := Hd0.
Definition box (x : vec) mu := within 2 d0 x /\ Rabs mu <= d0.

Lemma V_rises x mu s t : box x mu -> Rabs (s - tG) <= r0 -> Rabs (t - tG) <= r0 -> s <= t ->
  3 / 4 * g * (t - s) <= V x mu t - V x mu s <= 5 / 4 * g * (t - s).
Proof.
  intros [Bx Bm] Hs Ht [O| ->]; [|lra]; destruct (flow x mu) as (A & _).
  destruct (MVT_cor2 (V x mu) (fun s => a s (Y x mu s) (V x mu s) mu) s t O) as (z & E & Hz); [intros z _; apply A|].
  destruct Hwin as (_ & _ & _ & _ & W); apply le_abs in Hs, Ht; pose proof (W x mu z Bx Bm ltac:(here; apply Rabs_le;
    lra)) as B; apply le_abs in B. rewrite E; split; apply Rmult_le_compat_r; lra.
Qed.
Lemma bottom x mu : box x mu -> exists m, Rabs (m - tG) <= r0 / 2 /\ V x mu m = 0.
Proof.
  intros B; pose proof Hwin as (Hr & R1 & R2 & Hd & _); destruct Htouch as [_ Z].
  assert (C : continuity (V x mu)) by (intros t; destruct (flow x mu) as (A & _);
    apply (D_continuous _ _ _ (proj2 (A t)))).
  destruct (near_y0 x mu d0 tG (proj1 B) (proj2 B) ltac:(here; lra)) as [_ N]; rewrite Z in N; apply le_abs in N.
  pose proof (V_rises x mu tG (tG + r0 / 2) B ltac:(here; apply Rabs_le; lra) ltac:(here; apply Rabs_le;
    lra) ltac:(here; lra)) as U.
  pose proof (V_rises x mu (tG - r0 / 2) tG B ltac:(here; apply Rabs_le; lra) ltac:(here; apply Rabs_le;
    lra) ltac:(here; lra)) as W. assert (0 < g * r0) by (apply Rmult_lt_0_compat; lra).
  destruct (IVT (V x mu) (tG - r0 / 2) (tG + r0 / 2) C) as (m & Hm & E); [lra | lra | lra|]. exists m; split;
    [apply Rabs_le; lra | exact E].
Qed.
Definition low (x : vec) mu := the (fun m => Rabs (m - tG) <= r0 /\ V x mu m = 0).
Lemma low_spec x mu : box x mu -> Rabs (low x mu - tG) <= r0 / 2 /\ V x mu (low x mu) = 0 /\
  forall m, Rabs (m - tG) <= r0 -> V x mu m = 0 -> m = low x mu.
Proof.
  intros B; destruct (bottom x mu B) as (m & Hm & E); pose proof (proj1 Hwin) as Hr.
  assert (U : forall m', Rabs (m' - tG) <= r0 -> V x mu m' = 0 -> m' = m).
  { intros m' Hm' E'; destruct (Rle_dec m m') as [O|O].
    - pose proof (V_rises x mu m m' B ltac:(here; lra) Hm' O) as Q; assert (m' - m <= 0); [|lra]; apply Rnot_lt_le;
        intros P. assert (0 < 3 / 4 * g * (m' - m)) by (apply Rmult_lt_0_compat; lra); lra.
    - pose proof (V_rises x mu m' m B Hm' ltac:(here; lra) ltac:(here; lra)) as Q;
        assert (0 < 3 / 4 * g * (m - m')) by (apply Rmult_lt_0_compat; lra); lra. }
  replace (low x mu) with m; [auto|]; symmetry; apply the_spec; [split; [lra | exact E]|]; intros m' [P Q]; auto.
Qed.
Lemma low_lip x mu x' mu' r : box x mu -> box x' mu' -> within 2 r (minus x x') -> Rabs (mu - mu') <= r ->
  3 * g * Rabs (low x mu - low x' mu') <= 4 * (M * r).
Proof.
  intros B B' Hx Hm; destruct (low_spec x mu B) as (P & E & _), (low_spec x' mu' B') as (P' & E' & _);
    pose proof Hwin as (Hr & R1 & R2 & _). assert (I' : 0 <= low x' mu' <= T) by (apply (in_period r0); lra).
  destruct (nearby x x' mu mu' r (low x' mu') Hx Hm I') as [_ N]; rewrite E', Rminus_0_r in N; apply le_abs in N.
  destruct (Rle_dec (low x mu) (low x' mu')) as [O|O].
  - pose proof (V_rises x mu (low x mu) (low x' mu') B ltac:(here; lra) ltac:(here; lra) O) as Q;
      rewrite Rabs_minus_sym, Rabs_pos_eq by lra; lra.
  - pose proof (V_rises x mu (low x' mu') (low x mu) B ltac:(here; lra) ltac:(here; lra) ltac:(here; lra)) as Q;
      rewrite Rabs_pos_eq by lra; lra.
Qed.

Definition side (sg : R) := sg = 1 \/ sg = -1.
Lemma bowls e r d x mu sg rho : window e r d -> d <= d0 -> within 2 d x -> Rabs mu <= d -> side sg ->
  (forall s, 0 <= s <= rho -> Rabs (low x mu + sg * s - tG) <= r) -> let m := low x mu in
  X.bowl g e rho (fun s => Y x mu (m + sg * s) - Y x mu m) (fun s => sg * V x mu (m + sg * s))
    (fun s => a (m + sg * s) (Y x mu (m + sg * s)) (V x mu (m + sg * s)) mu).
Proof.
  intros W Hd Hx Hm Hsg Hin m; assert (B : box x mu) by (split; [intros i Hi; specialize (Hx i Hi); lra | lra]).
  destruct (low_spec x mu B) as (_ & E & _), (flow x mu) as (A & _); fold m in E, Hin. unfold X.bowl;
    rewrite Rmult_0_r, Rplus_0_r, E; split; [ring | split; [ring|]]; intros s Hs; destruct (A (m + sg * s)) as [D1 D2].
  assert (Dl : derivable_pt_lim (fun s => m + sg * s) s sg) by (eapply D_value;
    [apply D_plus; [apply D_const | apply D_scale, D_id] | ring]).
  assert (Sq : sg * sg = 1) by (destruct Hsg as [-> | ->]; ring). split; [|split].
  - eapply D_value; [apply D_minus; [apply (D_of (fun s => m + sg * s) (Y x mu) s _ _ Dl D1) | apply D_const] | ring].
  - eapply D_value; [apply D_scale, (D_of (fun s => m + sg * s) (V x mu) s _ _ Dl D2)|];
      rewrite (Rmult_comm _ sg), <- Rmult_assoc, Sq; ring.
  - apply W; auto.
Qed.
Lemma box_window x mu : box x mu -> within 2 d0 x /\ Rabs mu <= d0 /\ d0 <= d0.
Proof. intros [A B]; repeat split; trivial; lra. Qed.
(** The lowest point is the lowest, in all of the window. *)
Lemma Y_above x mu t : box x mu -> Rabs (t - tG) <= r0 -> let m := low x mu in
  3 / 8 * g * ((t - m) * (t - m)) <= Y x mu t - Y x mu m.
Proof.
  intros B Ht m; destruct (low_spec x mu B) as (P & _); fold m in P; destruct (box_window x mu B) as (B1 & B2 & _).
  set (sg := if Rle_dec m t then 1 else -1); assert (Hsg : side sg) by (unfold sg, side; destruct Rle_dec; auto).
  assert (E : sg * Rabs (t - m) = t - m) by (unfold sg; destruct Rle_dec; [rewrite Rabs_pos_eq | rewrite Rabs_left];
    lra). pose proof (bowls (g / 4) r0 d0 x mu sg (Rabs (t - m)) Hwin ltac:(here; lra) B1 B2 Hsg) as W; cbv zeta in W;
    fold m in W.
  specialize (W ltac:(here; intros s Hs; apply le_abs in P, Ht; revert E Hs; destruct Hsg as [-> | ->]; intros E Hs;
    apply Rabs_le; pose proof (proj1 Hwin); lra)).
  pose proof (X.height g (g / 4) _ ltac:(here; lra) _ _ _ W (Rabs (t - m)) ltac:(here; pose proof (Rabs_pos (t - m));
    lra)) as H; cbv beta in H. rewrite E in H; replace (m + (t - m)) with t in H by ring.
  replace (Rabs (t - m) * Rabs (t - m)) with ((t - m) * (t - m)) in H by (rewrite <- Rabs_mult, Rabs_pos_eq;
    [reflexivity | apply Rle_0_sqr]); lra.
Qed.

(** How long before the lowest point the gap is y^2 above its lowest value. *)
Definition ybox y := 0 <= y /\ 32 * (y * y) < 3 * g * (r0 * r0).
Definition off (x : vec) y mu := the (fun s => 0 <= s <= r0 / 2 /\ Y x mu (low x mu + -1 * s) - Y x mu (low x mu) = y *
  y).
Lemma off_spec x y mu : box x mu -> ybox y -> let s := off x y mu in 0 <= s <= r0 / 2 /\
  Y x mu (low x mu + -1 * s) - Y x mu (low x mu) = y * y /\ (y <> 0 -> 0 < s) /\ forall s', 0 <= s' <= r0 / 2 ->
  Y x mu (low x mu + -1 * s') - Y x mu (low x mu) = y * y -> s' = s.
Proof.
  intros B [Hy0 Hy]; destruct (low_spec x mu B) as (P & _); pose proof (proj1 Hwin) as Hr;
    destruct (box_window x mu B) as (B1 & B2 & _). set (m := low x mu) in *; apply le_abs in P.
  pose proof (bowls (g / 4) r0 d0 x mu (-1) (r0 / 2) Hwin ltac:(here; lra) B1 B2 ltac:(here; right;
    reflexivity) ltac:(here; intros s Hs; fold m; apply Rabs_le; lra)) as W; cbv zeta in W; fold m in W;
    set (p := fun s => Y x mu (m + -1 * s) - Y x mu m) in W.
  pose proof (X.height g (g / 4) _ ltac:(here; lra) _ _ _ W) as H.
  assert (Ex : exists s, 0 <= s <= r0 / 2 /\ p s = y * y).
  { destruct (Req_dec y 0) as [->|N].
    - exists 0; split; [lra|]; unfold p; rewrite Rmult_0_r, Rplus_0_r; ring.
    - assert (Py : 0 < y * y) by nra. assert (C : continuity (fun s => p s - y * y)).
      { intros s; destruct (flow x mu) as (A & _); destruct (A (m + -1 * s)) as [D _].
        assert (Dl : derivable_pt_lim (fun s => m + -1 * s) s (-1)) by (eapply D_value;
          [apply D_plus; [apply D_const | apply D_scale, D_id] | ring]). eapply D_continuous; apply D_minus;
          [apply D_minus; [apply (D_of (fun s => m + -1 * s) (Y x mu) s _ _ Dl D) | apply D_const] | apply D_const]. }
      destruct (IVT (fun s => p s - y * y) 0 (r0 / 2) C) as (s & Hs & E); [lra | | |exists s; split; [exact Hs | lra]].
      + unfold p; rewrite Rmult_0_r, Rplus_0_r; lra.
      + pose proof (H (r0 / 2) ltac:(here; lra));
          replace ((g - g / 4) * (r0 / 2 * (r0 / 2)) / 2) with (3 * g * (r0 * r0) / 32) in * by field; lra. }
  destruct Ex as (s & Hs & E); assert (U : forall s', 0 <= s' <= r0 / 2 -> p s' = y * y -> s' = s).
  { intros s' Hs' E'; pose proof (X.offsets g (g / 4) (r0 / 2) ltac:(here; lra) ltac:(here; lra) _ _ _ _ _ _ 0 W W
      ltac:(here; lra) ltac:(here; intros z Hz; rewrite Rminus_eq_0, Rabs_R0; lra) s' s Hs' Hs) as O; fold p in O;
      rewrite E, E', Rminus_eq_0, Rabs_R0 in O. apply Rminus_diag_uniq, Rabs_zero; pose proof (Rabs_pos (s' - s)); apply
      Rmult_le_reg_l with (g - 3 * (g / 4)); lra. }
  assert (Eo : off x y mu = s) by (apply the_spec; [split; [exact Hs | exact E] | intros s' [Q Q']; apply U;
    assumption]). cbv zeta; rewrite Eo; split; [exact Hs | split; [exact E | split; [|exact U]]]. intros N;
    destruct Hs as [[Hs|<-] _]; [exact Hs|]; exfalso; unfold p in E; rewrite Rmult_0_r, Rplus_0_r in E;
    assert (0 < y * y) by nra; lra.
Qed.
End Touch.
