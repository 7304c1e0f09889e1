(** * Time and speed of the crossing, as functions of the state, of y and of mu *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import StatementOrbits Contraction Derivatives NonlinearFlow NonlinearTouch.
Open Scope R_scope.
Section Speed.
Context {the_force : force} {the_touch : touch the_force} {the_window : near the_touch}.
Let HT := HT. Let HL := HL. Let HtG := HtG. Let Hg := Hg. Let Hd0 := Hd0.

Lemma Y_lip x mu s t : box x mu -> Rabs (s - tG) <= r0 -> Rabs (t - tG) <= r0 ->
  Rabs (Y x mu s - Y x mu t) <= 5 / 2 * g * r0 * Rabs (s - t) /\ Rabs (V x mu s - V x mu t) <= 5 / 4 * g * Rabs (s - t).
Proof.
  intros B; destruct (low_spec x mu B) as (P & E & _); pose proof (proj1 Hwin) as Hr; destruct (flow x mu) as (A & _).
  assert (Vb : forall z, Rabs (z - tG) <= r0 -> Rabs (V x mu z) <= 5 / 2 * g * r0).
  { intros z Hz; assert (G0 : 0 <= 5 / 4 * g * (2 * r0 - Rabs (z - low x mu))).
    { apply Rmult_le_pos; [lra|]; replace (z - low x mu) with ((z - tG) - (low x mu - tG)) by ring;
        pose proof (apart (z - tG) (low x mu - tG)); lra. }
    destruct (Rle_dec (low x mu) z) as [O|O].
    - pose proof (V_rises x mu (low x mu) z B ltac:(here; lra) Hz O) as Q; rewrite E in Q;
        rewrite (Rabs_pos_eq (z - _)) in G0 by lra.
      assert (0 <= 3 / 4 * g * (z - low x mu)) by (apply Rmult_le_pos; lra); rewrite Rabs_pos_eq; lra.
    - pose proof (V_rises x mu z (low x mu) B Hz ltac:(here; lra) ltac:(here; lra)) as Q; rewrite E in Q;
        rewrite (Rabs_left (z - _)) in G0 by lra. assert (0 <= 3 / 4 * g * (low x mu - z)) by (apply Rmult_le_pos; lra);
        rewrite Rabs_left1; lra. }
  assert (W : forall s t, Rabs (s - tG) <= r0 -> Rabs (t - tG) <= r0 -> s <= t -> Rabs (Y x mu s - Y x mu t) <=
    5 / 2 * g * r0 * (t - s) /\ Rabs (V x mu s - V x mu t) <= 5 / 4 * g * (t - s)).
  { intros z y Hz Hy [O| ->]; [|rewrite !Rminus_eq_0, Rabs_R0; lra]; split.
    - destruct (MVT_cor2 (Y x mu) (V x mu) z y O) as (q & Eq & Hq); [intros q _; apply A|].
      rewrite Rabs_minus_sym, Eq, Rabs_mult, (Rabs_pos_eq (y - z)) by lra; apply Rmult_le_compat_r; [lra|]; apply Vb.
      apply le_abs in Hz, Hy; apply Rabs_le; lra.
    - pose proof (V_rises x mu z y B Hz Hy ltac:(here; lra));
        assert (0 <= 3 / 4 * g * (y - z)) by (apply Rmult_le_pos; lra); rewrite Rabs_minus_sym, Rabs_pos_eq; lra. }
  intros Hs Ht; destruct (Rle_dec s t) as [O|O].
  - destruct (W s t Hs Ht O); rewrite (Rabs_minus_sym s t), (Rabs_pos_eq (t - s)) by lra; auto.
  - destruct (W t s Ht Hs ltac:(here; lra));
      rewrite (Rabs_minus_sym (Y x mu s)), (Rabs_minus_sym (V x mu s)), (Rabs_pos_eq (s - t)) by lra; auto.
Qed.

Definition acc x mu s := a (low x mu + -1 * s) (Y x mu (low x mu + -1 * s)) (V x mu (low x mu + -1 * s)) mu.
Lemma acc_lip : exists C, 0 < C /\ forall x mu x' mu' t s, box x mu -> box x' mu' -> within 2 t (minus x x') ->
  Rabs (mu - mu') <= t ->
  0 <= s <= r0 / 2 -> Rabs (low x mu - low x' mu') <= C * t /\ Rabs (acc x mu s - acc x' mu' s) <= C * t.
Proof.
  pose proof M_large as LM; pose proof Hwin as (Hr & R1 & R2 & _). set (C1 := 4 * M / (3 * g));
    assert (HC1 : 0 < C1) by (apply Rdiv_lt_0_compat; lra). set (C2 := 5 / 2 * g * r0);
    assert (HC2 : 0 < C2) by (unfold C2; apply Rmult_lt_0_compat; lra).
  set (D := C1 + (M + C2 * C1) + (M + 5 / 4 * g * C1) + 1); assert (HD : C1 <= D /\ 0 < D).
  { assert (0 < C2 * C1) by (apply Rmult_lt_0_compat; lra); assert (0 < g * C1) by (apply Rmult_lt_0_compat; lra);
      unfold D; lra. }
  assert (LD : D <= L * D) by (rewrite <- (Rmult_1_l D) at 1; apply Rmult_le_compat_r; lra). exists (L * D); split;
    [lra|]; intros x mu x' mu' t s B B' Hx Hm Hs. pose proof (Rabs_pos (mu - mu')) as Pm;
    destruct (low_spec x mu B) as (P & _), (low_spec x' mu' B') as (P' & _).
  assert (Low : Rabs (low x mu - low x' mu') <= C1 * t).
  { pose proof (low_lip x mu x' mu' t B B' Hx Hm) as H; apply Rmult_le_reg_l with (3 * g); [lra|];
      replace (3 * g * (C1 * t)) with (4 * (M * t)) by (unfold C1; field; lra); lra. }
  set (m := low x mu) in *; set (m' := low x' mu') in *.
  assert (I : Rabs (m + -1 * s - tG) <= r0) by (apply le_abs in P; apply Rabs_le; lra).
  assert (I' : Rabs (m' + -1 * s - tG) <= r0) by (apply le_abs in P'; apply Rabs_le; lra).
  assert (E : m + -1 * s - (m' + -1 * s) = m - m') by ring.
  destruct (nearby x x' mu mu' t (m + -1 * s) Hx Hm ltac:(here; apply (in_period r0); lra)) as [N1 N2].
  destruct (Y_lip x' mu' _ _ B' I I') as [N3 N4]; rewrite E in N3, N4; fold C2 in N3.
  assert (Q1 : C2 * Rabs (m - m') <= C2 * (C1 * t)) by (apply Rmult_le_compat_l; lra).
  assert (Q2 : 5 / 4 * g * Rabs (m - m') <= 5 / 4 * g * (C1 * t)) by (apply Rmult_le_compat_l; lra). split.
  - apply Rle_trans with (1 := Low); apply Rmult_le_compat_r; lra.
  - unfold acc; fold m m'; eapply Rle_trans; [apply Ha|]; rewrite E, Rmult_assoc; apply Rmult_le_compat_l; [lra|].
    assert (Rabs (Y x mu (m + -1 * s) - Y x' mu' (m' + -1 * s)) <= (M + C2 * C1) * t).
    { replace (Y x mu (m + -1 * s) - Y x' mu' (m' + -1 * s))
        with ((Y x mu (m + -1 * s) - Y x' mu' (m + -1 * s)) + (Y x' mu' (m + -1 * s) - Y x' mu' (m' + -1 * s))) by ring.
      eapply Rle_trans; [apply Rabs_triang | lra]. }
    assert (Rabs (V x mu (m + -1 * s) - V x' mu' (m' + -1 * s)) <= (M + 5 / 4 * g * C1) * t).
    { replace (V x mu (m + -1 * s) - V x' mu' (m' + -1 * s))
        with ((V x mu (m + -1 * s) - V x' mu' (m + -1 * s)) + (V x' mu' (m + -1 * s) - V x' mu' (m' + -1 * s))) by ring.
      eapply Rle_trans; [apply Rabs_triang | lra]. }
    unfold D; lra.
Qed.

Lemma ybox_exists : exists dy, 0 < dy /\ forall y, 0 <= y <= dy -> ybox y.
Proof.
  pose proof (proj1 Hwin) as Hr;
    assert (P : 0 < g * (r0 * r0)) by (apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]).
  destruct (two_least 1 (g * (r0 * r0) / 32) ltac:(here; lra) ltac:(here; lra)) as (dy & D & L1 & L2); exists dy; split;
    [exact D|]. intros y Hy; split; [lra|]; assert (y * y <= 1 * dy) by (apply Rmult_le_compat; lra); lra.
Qed.
Definition tc (x : vec) y mu := low x mu + -1 * off x y mu.
Definition cg := sqrt (2 * g).
Lemma cg_pos : 0 < cg.
Proof. apply sqrt_lt_R0; lra. Qed.
Definition falls x mu := fun s => Y x mu (low x mu + -1 * s) - Y x mu (low x mu).
Lemma off_root x y mu : box x mu -> ybox y -> sqrt (falls x mu (off x y mu)) = y.
Proof. intros B Hy; destruct (off_spec x y mu B Hy) as (_ & E & _); unfold falls; rewrite E; apply sqrt_square, Hy. Qed.

(** The time is Lipschitz; the velocity is - cg y, strictly. *)
Lemma bowl_here x mu : box x mu -> X.bowl g (g / 4) (r0 / 2) (falls x mu) (fun s => -1 * V x mu (low x mu + -1 * s))
  (acc x mu).
Proof.
  intros B; destruct (box_window x mu B) as (B1 & B2 & _), (low_spec x mu B) as (P & _); apply le_abs in P.
  apply (bowls (g / 4) r0 d0 x mu (-1) (r0 / 2) Hwin ltac:(here; lra) B1 B2 ltac:(here; right; reflexivity));
    intros s Hs; apply Rabs_le; lra.
Qed.
Lemma off_small x y mu : box x mu -> ybox y -> g * off x y mu <= 4 * (cg * y).
Proof.
  intros B Hy; destruct (off_spec x y mu B Hy) as (Hs & _).
  destruct (X.root g (g / 4) (r0 / 2) ltac:(here; lra) ltac:(here; lra) _ _ _ _ (bowl_here x mu B) Hs) as [_ R];
    rewrite off_root in R by assumption; fold cg in R; lra.
Qed.
Lemma tc_lip : exists C, 1 <= C /\ forall x y mu x' y' mu' t, box x mu -> box x' mu' -> ybox y -> ybox y' ->
  within 2 t (minus x x') -> Rabs (y - y') <= t -> Rabs (mu - mu') <= t -> Rabs (tc x y mu - tc x' y' mu') <= C * t.
Proof.
  destruct acc_lip as (C & HC & H); pose proof cg_pos as Hc; pose proof (proj1 Hwin) as Hr.
  set (D := 4 * (3 * (C * r0) + cg) / g);
    assert (HD : 0 < D) by (apply Rdiv_lt_0_compat; [assert (0 < C * r0) by (apply Rmult_lt_0_compat; lra); lra | lra]).
  exists (1 + C + D); split; [lra|]; intros x y mu x' y' mu' t B B' Hy Hy' Hx Hyt Hm;
    pose proof (Rabs_pos (mu - mu')) as Pm.
  destruct (off_spec x y mu B Hy) as (Hs & _), (off_spec x' y' mu' B' Hy') as (Hs' & _).
  destruct (H x mu x' mu' t 0 B B' Hx Hm ltac:(here; lra)) as [Lo _].
  pose proof (X.offsets g (g / 4) (r0 / 2) ltac:(here; lra) ltac:(here; lra) _ _ _ _ _ _ (C * t) (bowl_here x mu B)
    (bowl_here x' mu' B') ltac:(here; apply Rmult_le_pos; lra) ltac:(here; intros s Hs0;
    apply (H x mu x' mu' t s B B' Hx Hm Hs0)) _ _ Hs Hs') as O. rewrite !off_root in O by assumption; fold cg in O.
  assert (A1 : cg * Rabs (y - y') <= cg * t) by (apply Rmult_le_compat_l; lra).
  assert (Ct : 0 <= C * t) by (apply Rmult_le_pos; lra).
  assert (A2 : C * t * off x y mu <= C * t * r0) by (apply Rmult_le_compat_l; lra).
  assert (A3 : Rabs (off x y mu - off x' y' mu') <= D * t).
  { apply Rmult_le_reg_l with (g / 4); [lra|];
      replace (g / 4 * (D * t)) with (3 * (C * t * r0) + cg * t) by (unfold D; field; lra); lra. }
  unfold tc; replace (low x mu + -1 * off x y mu - (low x' mu' + -1 * off x' y' mu')) with ((low x mu - low x' mu') -
    (off x y mu - off x' y' mu')) by ring. eapply Rle_trans; [apply apart|]; lra.
Qed.
Lemma tc_speed : forall eps, 0 < eps -> exists d, 0 < d <= d0 /\ forall x y mu x' y' mu' t, within 2 d x ->
  within 2 d x' -> 0 <= y <= d -> 0 <= y' <= d -> Rabs mu <= d -> Rabs mu' <= d -> within 2 t (minus x x') ->
  Rabs (y - y') <= t -> Rabs (mu - mu') <= t -> ybox y /\ ybox y' /\ box x mu /\ box x' mu' /\
  Rabs (V x mu (tc x y mu) + cg * y - (V x' mu' (tc x' y' mu') + cg * y')) <= eps * t.
Proof.
  intros eps He; destruct acc_lip as (C & HC & H), ybox_exists as (dy & Hdy & Yb); pose proof cg_pos as Hc;
    pose proof (proj1 Hwin) as Hr. pose proof M_large as LM; assert (Hd00 : 0 < d0) by apply Hwin.
  destruct (two_least (g / 4) (eps * g / (32 * cg)) ltac:(here; lra) ltac:(here; apply Rdiv_lt_0_compat;
    [apply Rmult_lt_0_compat|]; lra)) as (e & E0 & E1 & E2). destruct (window_exists e E0) as (r & d1 & W).
  assert (Hr1 : 0 < r) by apply W; assert (Hd1 : 0 < d1) by apply W.
  destruct (two_least r r0 Hr1 Hr) as (r2 & R2 & L1 & L2), (two_least (r2 / 2) (eps / (32 * C)) ltac:(here;
    lra) ltac:(here; apply Rdiv_lt_0_compat; lra)) as (rho & P0 & P1 & P2).
  destruct (two_least d1 d0 Hd1 Hd00) as (d2 & D2 & L3 & L4), (two_least d2 dy D2 Hdy) as (d3 & D3 & L5 & L6).
  destruct (two_least d3 (3 * g * r2 / (8 * M)) D3) as (d4 & D4 & L7 & L8);
    [apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra|].
  destruct (two_least d4 (g * rho / (4 * cg)) D4) as (d & D5 & L9 & L10);
    [apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra|]. assert (Md : 8 * (M * d) <= 3 * g * r2).
  { apply Rle_trans with (8 * (M * (3 * g * r2 / (8 * M)))); [|right; field; lra]; apply Rmult_le_compat_l; [lra|];
      apply Rmult_le_compat_l; lra. }
  assert (Cd : 4 * (cg * d) <= g * rho).
  { apply Rle_trans with (4 * (cg * (g * rho / (4 * cg)))); [|right; field; lra]; apply Rmult_le_compat_l; [lra|];
      apply Rmult_le_compat_l; lra. }
  exists d; split; [lra|]; intros x y mu x' y' mu' t Hx Hx' Hy Hy' Hm Hm' Hxt Hyt Hmt;
    pose proof (Rabs_pos (mu - mu')) as Pm.
  assert (Bx : forall x mu, within 2 d x -> Rabs mu <= d -> box x mu) by (intros z q Hz Hq; split;
    [intros i Hi; specialize (Hz i Hi)|]; lra). assert (B := Bx x mu Hx Hm); assert (B' := Bx x' mu' Hx' Hm');
    assert (Yy : ybox y) by (apply Yb; lra); assert (Yy' : ybox y') by (apply Yb; lra). split;
    [exact Yy | split; [exact Yy' | split; [exact B | split; [exact B'|]]]].
  assert (Bo : forall x mu, within 2 d x -> Rabs mu <= d ->
    X.bowl g e rho (falls x mu) (fun s => -1 * V x mu (low x mu + -1 * s)) (acc x mu)).
  { intros z q Hz Hq; apply (bowls e r d z q (-1) rho (window_down e r d1 r d W ltac:(here; lra) ltac:(here; lra)));
      trivial; try lra; [right; reflexivity|]. intros s Hs; assert (Hrest : Rabs (low z q - tG) <= r2 / 2).
    { assert (B0 : box zero 0) by (split; [intros i _; unfold zero; rewrite Rabs_R0; lra | rewrite Rabs_R0; lra]).
      assert (E : low zero 0 = tG).
      { destruct (low_spec zero 0 B0) as (_ & _ & U); symmetry; apply U; [rewrite Rminus_eq_0, Rabs_R0; lra|];
          rewrite (proj2 (at_rest tG)); apply Htouch. }
      pose proof (low_lip z q zero 0 d (Bx z q Hz Hq) B0 ltac:(here; intros i Hi; unfold minus, zero;
        rewrite Rminus_0_r; apply Hz, Hi) ltac:(here; rewrite Rminus_0_r; exact Hq)) as A. rewrite E in A;
        apply Rmult_le_reg_l with (3 * g); lra. }
    apply le_abs in Hrest; apply Rabs_le; lra. }
  assert (So : forall x y mu, box x mu -> ybox y -> y <= d -> 0 <= off x y mu <= rho).
  { intros z q n Bz Hq Hqd; pose proof (off_small z q n Bz Hq) as A; destruct (off_spec z q n Bz Hq) as ([A0 _] & _);
      split; [exact A0|]. apply Rmult_le_reg_l with g; [lra|];
      assert (cg * q <= cg * d) by (apply Rmult_le_compat_l; lra); lra. }
  pose proof (So x y mu B Yy ltac:(here; lra)) as S1; pose proof (So x' y' mu' B' Yy' ltac:(here; lra)) as S1'.
  assert (Ct : 0 <= C * t) by (apply Rmult_le_pos; lra).
  pose proof (X.crossing' g e rho ltac:(here; lra) ltac:(here; lra) _ _ _ _ _ _ (C * t) (Bo x mu Hx Hm)
    (Bo x' mu' Hx' Hm') Ct ltac:(here; intros s Hs; apply (H x mu x' mu' t s B B' Hxt Hmt); lra) _ _ S1 S1') as Q.
  rewrite !off_root in Q by assumption; fold cg in Q; fold (tc x y mu) (tc x' y' mu') in Q.
  replace (V x mu (tc x y mu) + cg * y - (V x' mu' (tc x' y' mu') + cg * y'))
    with (- (-1 * V x mu (tc x y mu) - cg * y - (-1 * V x' mu' (tc x' y' mu') - cg * y'))) by ring. rewrite Rabs_Ropp;
    apply Rle_trans with (1 := Q). assert (A1 : 16 * (C * t) * off x y mu <= eps / 2 * t).
  { apply Rle_trans with (16 * (C * t) * (eps / (32 * C))); [apply Rmult_le_compat_l; lra | right; field; lra]. }
  assert (A2 : 4 * e * cg / (g - 3 * e) <= eps / 2).
  { apply Rmult_le_reg_r with (g - 3 * e); [lra|]; unfold Rdiv;
      rewrite (Rmult_assoc (4 * e * cg)), Rinv_l, Rmult_1_r by lra.
    assert (e * (32 * cg) <= eps * g) by (apply Rle_trans with (eps * g / (32 * cg) * (32 * cg));
      [apply Rmult_le_compat_r; lra | right; field; lra]).
    assert (eps * (g - 3 * e) >= eps * (g / 4)) by (apply Rle_ge, Rmult_le_compat_l; lra); lra. }
  assert (A3 : 4 * e * cg / (g - 3 * e) * Rabs (y - y') <= eps / 2 * t).
  { apply Rmult_le_compat; [|apply Rabs_pos | exact A2 | exact Hyt]; apply Rmult_le_pos;
      [apply Rmult_le_pos; lra | left; apply Rinv_0_lt_compat; lra]. }
  lra.
Qed.
End Speed.
