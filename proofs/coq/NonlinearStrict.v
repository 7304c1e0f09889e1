(** * At a known solution the flow of y'' = a (t, y, y', mu) is strictly differentiable, its derivative the flow of the
      linearized equation; so is a jump of velocity, carried back to the time 0. Three solutions are compared. *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import Derivatives NonlinearGronwall.
Open Scope R_scope.

Section Oscillator.
(** The reference solution y0, v0 at mu = 0 on [0, T]; near it a is strictly differentiable in (y, v, mu), uniformly in
    time, with derivatives k, c, l: so for C1 functions. L bounds them and is a Lipschitz constant of a. *)
Variables (a : R -> R -> R -> R -> R) (T L : R) (y0 v0 k c l : R -> R).
Definition solution mu y v := forall x, 0 <= x <= T -> derivable_pt_lim y x (v x) /\
  derivable_pt_lim v x (a x (y x) (v x) mu).
Definition linearized m z w := forall x, 0 <= x <= T -> derivable_pt_lim z x (w x) /\
  derivable_pt_lim w x (k x * z x + c x * w x + l x * m).
Hypothesis HL : 1 <= L.
Hypothesis Hlip : forall x y v mu y' v' mu', 0 <= x <= T ->
  Rabs (a x y v mu - a x y' v' mu') <= L * (Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu')).
Hypothesis Hbound : forall x, 0 <= x <= T -> Rabs (k x) <= L /\ Rabs (c x) <= L /\ Rabs (l x) <= L.
Hypothesis Hstrict : forall eps, 0 < eps -> exists d, 0 < d /\ forall x y v mu y' v' mu', 0 <= x <= T ->
  Rabs (y - y0 x) <= d -> Rabs (v - v0 x) <= d -> Rabs mu <= d ->
  Rabs (y' - y0 x) <= d -> Rabs (v' - v0 x) <= d -> Rabs mu' <= d ->
  Rabs (a x y v mu - a x y' v' mu' - (k x * (y - y') + c x * (v - v') + l x * (mu - mu'))) <=
  eps * (Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu')).
Hypothesis Href : solution 0 y0 v0.
Let K := 2 * (1 + L) * exp ((2 * L + 1) * T).

Lemma both_ways mu mu' y v y' v' : solution mu y v -> solution mu' y' v' -> forall x, 0 <= x <= T ->
  Rabs (y x - y' x) + Rabs (v x - v' x) <= K * (Rabs (y 0 - y' 0) + Rabs (v 0 - v' 0) + Rabs (mu - mu')) /\
  Rabs (y 0 - y' 0) + Rabs (v 0 - v' 0) <= K * (Rabs (y x - y' x) + Rabs (v x - v' x) + Rabs (mu - mu')).
Proof.
  intros S S' x Hx; apply (bound L T (fun x => y x - y' x) (fun x => v x - v' x) (fun x => a x (y x) (v x) mu - a x (y'
    x) (v' x) mu')); trivial; [apply Rabs_pos|]. intros z Hz; destruct (S z Hz), (S' z Hz); split; [|split; [|apply
    Hlip, Hz]]; apply derivable_pt_lim_minus; assumption.
Qed.
Definition close mu mu' y v y' v' S S' x Hx := proj1 (both_ways mu mu' y v y' v' S S' x Hx).
Definition close_back mu mu' y v y' v' S S' x Hx := proj2 (both_ways mu mu' y v y' v' S S' x Hx).

(** The flow over every time up to T is strictly differentiable, its derivative the linearized flow: as [strict] in
    StatementOrbits has it. *)
Theorem flow_strict : forall eps, 0 < eps -> exists d, 0 < d /\ forall mu mu' y v y' v' z w,
  solution mu y v -> solution mu' y' v' -> linearized (mu - mu') z w -> z 0 = y 0 - y' 0 -> w 0 = v 0 - v' 0 ->
  Rabs (y 0 - y0 0) <= d -> Rabs (v 0 - v0 0) <= d -> Rabs (y' 0 - y0 0) <= d -> Rabs (v' 0 - v0 0) <= d ->
  Rabs mu <= d -> Rabs mu' <= d -> forall x, 0 <= x <= T ->
  Rabs (y x - y' x - z x) + Rabs (v x - v' x - w x) <= eps * (Rabs (y 0 - y' 0) + Rabs (v 0 - v' 0) + Rabs (mu - mu')).
Proof.
  intros eps He; set (Q := exp ((2 * L + 1) * T)); assert (HQ : 0 < Q) by apply exp_pos.
  assert (HK : 0 < K) by (unfold K; fold Q; nra). destruct (Hstrict (eps / (2 * (K + 1) * Q))) as (d1 & Hd1 & H1).
  { apply Rdiv_lt_0_compat; [exact He | nra]. }
  exists (Rmin d1 (d1 / (3 * K))); assert (Hd : 0 < d1 / (3 * K)) by (apply Rdiv_lt_0_compat; lra). split;
    [apply Rmin_glb_lt; assumption|]. intros mu mu' y v y' v' z w S S' Z Ez Ew B1 B2 B3 B4 B5 B6 x Hx.
  pose proof (Rmin_l d1 (d1 / (3 * K))) as M1; pose proof (Rmin_r d1 (d1 / (3 * K))) as M2;
    set (d := Rmin d1 (d1 / (3 * K))) in *.
  assert (Near : forall m Y V, solution m Y V -> Rabs (Y 0 - y0 0) <= d -> Rabs (V 0 - v0 0) <= d -> Rabs m <= d ->
    forall s, 0 <= s <= T -> Rabs (Y s - y0 s) <= d1 /\ Rabs (V s - v0 s) <= d1).
  { intros m Y V SY A1 A2 A3 s Hs; pose proof (close _ _ _ _ _ _ SY Href s Hs) as C; rewrite Rminus_0_r in C.
    assert (X : K * (3 * (d1 / (3 * K))) = d1) by (field; lra).
    assert (K * (Rabs (Y 0 - y0 0) + Rabs (V 0 - v0 0) + Rabs m) <= K * (3 * (d1 / (3 * K))))
      by (apply Rmult_le_compat_l; lra). pose proof (Rabs_pos (Y s - y0 s)); pose proof (Rabs_pos (V s - v0 s)); lra. }
  set (D := Rabs (y 0 - y' 0) + Rabs (v 0 - v' 0) + Rabs (mu - mu')).
  assert (HD : 0 <= D) by (unfold D; pose proof (Rabs_pos (y 0 - y' 0)); pose proof (Rabs_pos (v 0 - v' 0));
    pose proof (Rabs_pos (mu - mu')); lra). set (e := eps / (2 * (K + 1) * Q) * ((K + 1) * D)).
  assert (Ee : 2 * e * Q = eps * D) by (unfold e; field; lra).
  assert (He0 : 0 <= e) by (unfold e; apply Rmult_le_pos; [left; apply Rdiv_lt_0_compat; nra | nra]). eapply Rle_trans;
    [apply (gronwall2 (fun x => y x - y' x - z x) (fun x => v x - v' x - w x) (fun x => v x - v' x - w x) (fun x => a x
    (y x) (v x) mu - a x (y' x) (v' x) mu' - (k x * z x + c x * w x + l x * (mu - mu'))) L e T) with (5 := Hx)|].
  - lra.
  - exact He0.
  - intros s Hs; destruct (S s Hs), (S' s Hs), (Z s Hs); split; apply derivable_pt_lim_minus; try assumption;
      apply derivable_pt_lim_minus; assumption.
  - intros s Hs; destruct (Near _ _ _ S B1 B2 B5 s Hs) as [N1 N2]; destruct (Near _ _ _ S' B3 B4 B6 s Hs) as [N3 N4].
    pose proof (H1 s _ _ mu _ _ mu' Hs N1 N2 ltac:(lra) N3 N4 ltac:(lra)) as A.
    pose proof (close _ _ _ _ _ _ S S' s Hs) as C; fold D in C; destruct (Hbound s Hs) as (Bk & Bc & _).
    set (P := Rabs (y s - y' s - z s)); set (R := Rabs (v s - v' s - w s)). assert (0 <= P) by apply Rabs_pos;
      assert (0 <= R) by apply Rabs_pos. split; [nra|].
    replace (a s (y s) (v s) mu - a s (y' s) (v' s) mu' - (k s * z s + c s * w s + l s * (mu - mu')))
      with ((a s (y s) (v s) mu - a s (y' s) (v' s) mu' - (k s * (y s - y' s) + c s * (v s - v' s) + l s * (mu - mu')))
      + (k s * (y s - y' s - z s) + c s * (v s - v' s - w s))) by ring. eapply Rle_trans; [apply Rabs_triang|].
    assert (X1 : Rabs (k s * (y s - y' s - z s) + c s * (v s - v' s - w s)) <= L * (P + R)).
    { eapply Rle_trans; [apply Rabs_triang|]; rewrite !Rabs_mult; fold P R; nra. }
    assert (X2 : eps / (2 * (K + 1) * Q) * (Rabs (y s - y' s) + Rabs (v s - v' s) + Rabs (mu - mu')) <= e).
    { unfold e; apply Rmult_le_compat_l; [left; apply Rdiv_lt_0_compat; nra|].
      assert (Rabs (mu - mu') <= D) by (unfold D; pose proof (Rabs_pos (y 0 - y' 0));
        pose proof (Rabs_pos (v 0 - v' 0)); lra). lra. }
    lra.
  - rewrite Ez, Ew, !Rminus_diag_eq, !Rabs_R0 by reflexivity; fold Q D; lra.
Qed.
Lemma linear_bounds m z w : linearized m z w -> forall x, 0 <= x <= T -> Rabs (z x) + Rabs (w x) <=
  K * (Rabs (z 0) + Rabs (w 0) + Rabs m) /\
  Rabs (z 0) + Rabs (w 0) <= K * (Rabs (z x) + Rabs (w x) + Rabs m).
Proof.
  intros Z x Hx; apply (bound L T z w (fun x => k x * z x + c x * w x + l x * m)); trivial; [apply Rabs_pos|];
    intros s Hs. destruct (Z s Hs), (Hbound s Hs) as (B1 & B2 & B3); split; [assumption | split; [assumption|]].
  pose proof (Rabs_triang (k s * z s + c s * w s) (l s * m)); pose proof (Rabs_triang (k s * z s) (c s * w s));
    rewrite !Rabs_mult in *. pose proof (Rmult_le_compat_r _ _ _ (Rabs_pos (z s)) B1);
    pose proof (Rmult_le_compat_r _ _ _ (Rabs_pos (w s)) B2); pose proof (Rmult_le_compat_r _ _ _ (Rabs_pos m) B3); lra.
Qed.
Lemma linear_bound m z w : linearized m z w -> forall x, 0 <= x <= T -> Rabs (z x) + Rabs (w x) <=
  K * (Rabs (z 0) + Rabs (w 0) + Rabs m).
Proof. intros Z x Hx; apply (linear_bounds m z w Z x Hx). Qed.
Lemma linear_back z w : linearized 0 z w -> forall x, 0 <= x <= T -> Rabs (z 0) + Rabs (w 0) <=
  K * (Rabs (z x) + Rabs (w x)).
Proof. intros Z x Hx; destruct (linear_bounds 0 z w Z x Hx) as [_ H]; rewrite Rabs_R0, Rplus_0_r in H; exact H. Qed.
(** A solution of the linearized equation with any initial values. *)
Variables (tG : R) (p1 q1 p2 q2 p3 q3 : R -> R).
Hypothesis HtG : 0 <= tG <= T.
Hypothesis Hfund : (linearized 0 p1 q1 /\ p1 0 = 1 /\ q1 0 = 0) /\ (linearized 0 p2 q2 /\ p2 0 = 0 /\ q2 0 = 1) /\
  (linearized 1 p3 q3 /\ p3 0 = 0 /\ q3 0 = 0).
Lemma linear_exists z0 w0 m : exists z w, linearized m z w /\ z 0 = z0 /\ w 0 = w0.
Proof.
  destruct Hfund as ((L1 & I1 & J1) & (L2 & I2 & J2) & (L3 & I3 & J3)).
  exists (fun s => z0 * p1 s + w0 * p2 s + m * p3 s), (fun s => z0 * q1 s + w0 * q2 s + m * q3 s). split;
    [|cbv beta; rewrite I1, J1, I2, J2, I3, J3; lra]. intros s Hs; destruct (L1 s Hs) as [D1 F1];
    destruct (L2 s Hs) as [D2 F2]; destruct (L3 s Hs) as [D3 F3]; split.
  - apply (derivable_pt_lim_plus (fun s => z0 * p1 s + w0 * p2 s));
      [apply (derivable_pt_lim_plus (fun s => z0 * p1 s))|]; apply derivable_pt_lim_scal; assumption.
  - replace (k s * (z0 * p1 s + w0 * p2 s + m * p3 s) + c s * (z0 * q1 s + w0 * q2 s + m * q3 s) + l s * m)
      with (z0 * (k s * p1 s + c s * q1 s + l s * 0) + w0 * (k s * p2 s + c s * q2 s + l s * 0) + m *
      (k s * p3 s + c s * q3 s + l s * 1)) by ring. apply (derivable_pt_lim_plus (fun s => z0 * q1 s + w0 * q2 s));
      [apply (derivable_pt_lim_plus (fun s => z0 * q1 s))|]; apply derivable_pt_lim_scal; assumption.
Qed.
(** Before impact the oscillator moves as y1, after it as y2, meeting at t with a jump J of velocity. Backwards in time
    to the section the jump is J times the solution zb, wb of the linearized equation that is (0, 1) at tG: B of (43).
    *)
Theorem kick_strict zb wb : linearized 0 zb wb -> zb tG = 0 -> wb tG = 1 -> forall eps, 0 < eps -> exists d, 0 < d /\
  forall mu mu' y1 v1 y2 v2 y1' v1' y2' v2' t t' r, solution mu y1 v1 -> solution mu y2 v2 -> solution mu' y1' v1' ->
  solution mu' y2' v2' -> Rabs mu <= d -> Rabs mu' <= d -> Rabs (y1 0 - y0 0) <= d -> Rabs (v1 0 - v0 0) <= d ->
  Rabs (y2 0 - y0 0) <= d -> Rabs (v2 0 - v0 0) <= d -> Rabs (y1' 0 - y0 0) <= d -> Rabs (v1' 0 - v0 0) <= d ->
  Rabs (y2' 0 - y0 0) <= d -> Rabs (v2' 0 - v0 0) <= d -> 0 <= t <= T -> 0 <= t' <= T -> Rabs (t - tG) <= d ->
  Rabs (t' - tG) <= d -> y2 t = y1 t -> y2' t' = y1' t' -> let J := v2 t - v1 t in let J' :=
  v2' t' - v1' t' in Rabs (y1 0 - y1' 0) <= r -> Rabs (v1 0 - v1' 0) <= r -> Rabs (mu - mu') <= r ->
  Rabs (J - J') <= r -> Rabs (t - t') <= r -> Rabs (y2 0 - y1 0 - (y2' 0 - y1' 0) - (J - J') * zb 0) + Rabs (v2 0 - v1 0
  - (v2' 0 - v1' 0) - (J - J') * wb 0) <= eps * r.
Proof.
  intros Zb Eb Ewb eps He; assert (Ke : 0 < K) by (unfold K; pose proof (exp_pos ((2 * L + 1) * T)); nra).
  assert (TG := HtG). set (nb := K * (Rabs (zb 0) + Rabs (wb 0))); assert (Nb : 0 <= nb).
  { unfold nb; apply Rmult_le_pos; [lra|]; pose proof (Rabs_pos (zb 0)); pose proof (Rabs_pos (wb 0)); lra. }
  set (C := K * (6 * K + 2 + 4 * (1 + L) * K) + 1);
    assert (HC : 0 < C) by (unfold C; assert (0 <= L * K) by (apply Rmult_le_pos; lra); assert (0 <= K * K)
      by (apply Rmult_le_pos; lra); assert (0 <= K * (L * K)) by (apply Rmult_le_pos; lra); nra).
  destruct (flow_strict (eps / (2 * K * (3 + C)))) as (d1 & Hd1 & F);
    [apply Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]|]. set (G := 4 * (1 + L) * K + (1 + 2 * L) * nb + 1).
  assert (HG : 0 < G) by (unfold G; assert (0 <= L * K) by (apply Rmult_le_pos; lra); assert (0 <= L * nb)
    by (apply Rmult_le_pos; lra); lra). assert (HD : exists d, 0 < d /\ d <= d1 /\ d <= 1 /\ 2 * K * (G * d) <= eps).
  { exists (Rmin d1 (Rmin 1 (eps / (2 * K * G))));
      assert (P : 0 < eps / (2 * K * G)) by (apply Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]).
    pose proof (Rmin_l d1 (Rmin 1 (eps / (2 * K * G)))); pose proof (Rmin_r d1 (Rmin 1 (eps / (2 * K * G)))).
    pose proof (Rmin_l 1 (eps / (2 * K * G))); pose proof (Rmin_r 1 (eps / (2 * K * G)));
      set (d := Rmin d1 (Rmin 1 (eps / (2 * K * G)))) in *. split; [repeat apply Rmin_glb_lt; lra|]; split; [lra|];
      split; [lra|]. apply Rle_trans with (2 * K * (G * (eps / (2 * K * G)))); [|right; field; lra].
    apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra. }
  destruct HD as (d & Hd & L1 & L2 & L3); exists d; split; [exact Hd|].
  intros mu mu' y1 v1 y2 v2 y1' v1' y2' v2' t t' r S1 S2 S1' S2' M M' B1 B2 B3 B4 B5 B6 B7 B8 Ht Ht' Tt Tt' X X' J J' Q1
    Q2 Q3 Q4 Q5. assert (Hr0 : 0 <= r) by (pose proof (Rabs_pos (mu - mu')); lra).
  (* y2' - y1' and its velocity are small on [0, T]. *)
  assert (Sm : forall s, 0 <= s <= T -> Rabs (y2' s - y1' s) + Rabs (v2' s - v1' s) <= 4 * K * d).
  { intros s Hs; pose proof (close _ _ _ _ _ _ S2' S1' s Hs) as A; replace (mu' - mu') with 0 in A by ring;
      rewrite Rabs_R0 in A.
    assert (A1 : Rabs (y2' 0 - y1' 0) <= 2 * d) by (replace (y2' 0 - y1' 0) with ((y2' 0 - y0 0) + - (y1' 0 - y0 0))
      by ring; eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_Ropp; lra).
    assert (A2 : Rabs (v2' 0 - v1' 0) <= 2 * d) by (replace (v2' 0 - v1' 0) with ((v2' 0 - v0 0) + - (v1' 0 - v0 0))
      by ring; eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_Ropp; lra). apply Rle_trans with (1 := A);
      replace (4 * K * d) with (K * (2 * d + 2 * d + 0)) by ring; apply Rmult_le_compat_l; lra. }
  assert (Kd : 0 <= K * d) by (apply Rmult_le_pos; lra). assert (Yt : Rabs (y2' t - y1' t) <= 4 * K * d * r).
  { replace (y2' t - y1' t) with ((y2' t - y1' t) - (y2' t' - y1' t')) by (rewrite X'; ring). eapply Rle_trans;
      [apply (mvt_on T (fun s => y2' s - y1' s) (fun s => v2' s - v1' s) (4 * K * d) t t' Ht Ht')|].
    - intros s Hs; destruct (S2' s Hs), (S1' s Hs); split; [apply derivable_pt_lim_minus; assumption|].
      pose proof (Sm s Hs); pose proof (Rabs_pos (y2' s - y1' s)); lra.
    - apply Rmult_le_compat_l; lra. }
  assert (Vt : Rabs ((v2' t - v1' t) - J') <= 4 * L * K * d * r).
  { unfold J'; eapply Rle_trans; [apply (mvt_on T (fun s => v2' s - v1' s) (fun s => a s (y2' s) (v2' s) mu' - a s (y1'
      s) (v1' s) mu') (4 * L * K * d) t t' Ht Ht')|].
    - intros s Hs; destruct (S2' s Hs), (S1' s Hs); split; [apply derivable_pt_lim_minus; assumption|].
      pose proof (Hlip s (y2' s) (v2' s) mu' (y1' s) (v1' s) mu' Hs) as A; replace (mu' - mu') with 0 in A by ring;
        rewrite Rabs_R0 in A. apply Rle_trans with (1 := A); replace (4 * L * K * d) with (L * (4 * K * d)) by ring;
        apply Rmult_le_compat_l; [lra|]. pose proof (Sm s Hs); lra.
    - apply Rmult_le_compat_l; [|lra]; replace (4 * L * K * d) with (4 * L * (K * d)) by ring; apply Rmult_le_pos; lra.
      }
  set (D1 := Rabs (y1 0 - y1' 0) + Rabs (v1 0 - v1' 0) + Rabs (mu - mu')).
  set (D2 := Rabs (y2 0 - y2' 0) + Rabs (v2 0 - v2' 0) + Rabs (mu - mu')).
  assert (HD1 : D1 <= 3 * r) by (unfold D1; lra). assert (HD2 : D2 <= C * r).
  { pose proof (close_back _ _ _ _ _ _ S2 S2' t Ht) as A; pose proof (close _ _ _ _ _ _ S1 S1' t Ht) as A';
      fold D1 in A'. assert (A1 : K * D1 <= K * (3 * r)) by (apply Rmult_le_compat_l; lra).
    assert (Kr : 0 <= K * r) by (apply Rmult_le_pos; lra).
    assert (Kdr : K * d * r <= K * r) by (replace (K * d * r) with (d * (K * r)) by ring; replace (K * r)
      with (1 * (K * r)) at 2 by ring; apply Rmult_le_compat_r; lra).
    assert (LKdr : L * K * d * r <= L * (K * r)) by (replace (L * K * d * r) with (L * (K * d * r)) by ring;
      apply Rmult_le_compat_l; lra). assert (A2 : Rabs (y2 t - y2' t) <= Rabs (y1 t - y1' t) + 4 * (K * r)).
    { replace (y2 t - y2' t) with ((y1 t - y1' t) + - (y2' t - y1' t)) by (rewrite X; ring). eapply Rle_trans;
        [apply Rabs_triang|]; rewrite Rabs_Ropp; lra. }
    assert (A3 : Rabs (v2 t - v2' t) <= Rabs (v1 t - v1' t) + r + 4 * (L * (K * r))).
    { replace (v2 t - v2' t) with ((v1 t - v1' t) + ((J - J') + - ((v2' t - v1' t) - J'))) by (unfold J; ring).
      eapply Rle_trans; [apply Rabs_triang|]; assert (Rabs (J - J' + - (v2' t - v1' t - J')) <= r + 4 * (L * (K * r)));
        [|lra]. eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_Ropp; lra. }
    assert (A4 : Rabs (y2 t - y2' t) + Rabs (v2 t - v2' t) + Rabs (mu - mu') <= (6 * K + 2 + 4 * (1 + L) * K) * r)
      by lra.
    assert (A5 : K * (Rabs (y2 t - y2' t) + Rabs (v2 t - v2' t) + Rabs (mu - mu')) <=
      K * ((6 * K + 2 + 4 * (1 + L) * K) * r)) by (apply Rmult_le_compat_l; lra). unfold D2, C; lra. }
  destruct (linear_exists (y1 0 - y1' 0) (v1 0 - v1' 0) (mu - mu')) as (z1 & w1 & Z1 & E1 & E1').
  destruct (linear_exists (y2 0 - y2' 0) (v2 0 - v2' 0) (mu - mu')) as (z2 & w2 & Z2 & E2 & E2').
  pose proof (F _ _ _ _ _ _ _ _ S1 S1' Z1 E1 E1' ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) t Ht)
    as G1.
  pose proof (F _ _ _ _ _ _ _ _ S2 S2' Z2 E2 E2' ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) t Ht)
    as G2. fold D1 in G1; fold D2 in G2; set (e1 := eps / (2 * K * (3 + C))) in *.
  assert (He1 : 0 < e1) by (unfold e1; apply Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]).
  assert (G1' : e1 * D1 <= e1 * (3 * r)) by (apply Rmult_le_compat_l; lra).
  assert (G2' : e1 * D2 <= e1 * (C * r)) by (apply Rmult_le_compat_l; lra).
  (* zb, wb at t. *)
  assert (Lb : forall s, 0 <= s <= T -> Rabs (zb s) + Rabs (wb s) <= nb).
  { intros s Hs; pose proof (linear_bound _ _ _ Zb s Hs) as A; rewrite Rabs_R0, Rplus_0_r in A; exact A. }
  assert (Zt : Rabs (zb t) <= nb * d).
  { replace (zb t) with (zb t - zb tG) by (rewrite Eb; ring); eapply Rle_trans; [apply (mvt_on T zb wb nb t tG Ht TG)|].
    - intros s Hs; split; [apply Zb, Hs|]; pose proof (Lb s Hs); pose proof (Rabs_pos (zb s)); lra.
    - apply Rmult_le_compat_l; lra. }
  assert (Wt : Rabs (wb t - 1) <= 2 * L * nb * d).
  { replace (wb t - 1) with (wb t - wb tG) by (rewrite Ewb; ring); eapply Rle_trans;
      [apply (mvt_on T wb (fun s => k s * zb s + c s * wb s + l s * 0) (2 * L * nb) t tG Ht TG)|].
    - intros s Hs; split; [apply Zb, Hs|]; destruct (Hbound s Hs) as (K1 & K2 & _); pose proof (Lb s Hs) as A;
        rewrite Rmult_0_r, Rplus_0_r. eapply Rle_trans; [apply Rabs_triang|]; rewrite !Rabs_mult;
        pose proof (Rabs_pos (zb s)); pose proof (Rabs_pos (wb s)).
      assert (Rabs (k s) * Rabs (zb s) <= L * nb) by (apply Rmult_le_compat; try apply Rabs_pos; lra).
      assert (Rabs (c s) * Rabs (wb s) <= L * nb) by (apply Rmult_le_compat; try apply Rabs_pos; lra); lra.
    - apply Rmult_le_compat_l; [|lra]; replace (2 * L * nb) with (2 * (L * nb)) by ring;
        assert (0 <= L * nb) by (apply Rmult_le_pos; lra); lra. }
  set (z s := z2 s - z1 s - (J - J') * zb s); set (w s := w2 s - w1 s - (J - J') * wb s). assert (Z : linearized 0 z w).
  { intros s Hs; destruct (Z1 s Hs) as [P1 P2]; destruct (Z2 s Hs) as [P3 P4]; destruct (Zb s Hs) as [P5 P6]; split.
    - apply (derivable_pt_lim_minus (fun s => z2 s - z1 s));
        [apply derivable_pt_lim_minus; assumption | apply derivable_pt_lim_scal, P5].
    - replace (k s * z s + c s * w s + l s * 0) with ((k s * z2 s + c s * w2 s + l s * (mu - mu')) - (k s * z1 s + c s *
        w1 s + l s * (mu - mu')) - (J - J') * (k s * zb s + c s * wb s + l s * 0)) by (unfold z, w; ring).
      apply (derivable_pt_lim_minus (fun s => w2 s - w1 s));
        [apply derivable_pt_lim_minus; assumption | apply derivable_pt_lim_scal, P6]. }
  pose proof (linear_back z w Z t Ht) as Fin.
  assert (N1 : Rabs (z t) <= Rabs (y1 t - y1' t - z1 t) + Rabs (y2 t - y2' t - z2 t) + 4 * K * d * r + r * (nb * d)).
  { replace (z t) with ((y1 t - y1' t - z1 t) + (- (y2 t - y2' t - z2 t) + (- (y2' t - y1' t) + - ((J - J') * zb t))))
      by (unfold z; rewrite X; ring).
    assert (Rabs (- ((J - J') * zb t)) <= r * (nb * d)) by (rewrite Rabs_Ropp, Rabs_mult; apply Rmult_le_compat; try
      apply Rabs_pos; assumption). eapply Rle_trans; [apply Rabs_triang|]; eapply Rle_trans; [apply Rplus_le_compat_l,
      Rabs_triang|]. eapply Rle_trans; [apply Rplus_le_compat_l, Rplus_le_compat_l, Rabs_triang|]; rewrite (Rabs_Ropp
      (y2 t - y2' t - z2 t)), (Rabs_Ropp (y2' t - y1' t)); lra. }
  assert (N2 : Rabs (w t) <= Rabs (v1 t - v1' t - w1 t) + Rabs (v2 t - v2' t - w2 t) + 4 * L * K * d * r + r *
    (2 * L * nb * d)).
  { replace (w t) with ((v1 t - v1' t - w1 t) + (- (v2 t - v2' t - w2 t) + (- ((v2' t - v1' t) - J') + - ((J - J') * (wb
      t - 1))))) by (unfold w, J; ring).
    assert (Rabs (- ((J - J') * (wb t - 1))) <= r * (2 * L * nb * d)) by (rewrite Rabs_Ropp, Rabs_mult; apply
      Rmult_le_compat; try apply Rabs_pos; assumption). eapply Rle_trans; [apply Rabs_triang|]; eapply Rle_trans; [apply
      Rplus_le_compat_l, Rabs_triang|]. eapply Rle_trans; [apply Rplus_le_compat_l, Rplus_le_compat_l, Rabs_triang|];
      rewrite (Rabs_Ropp (v2 t - v2' t - w2 t)), (Rabs_Ropp (v2' t - v1' t - J')); lra. }
  assert (N : Rabs (z t) + Rabs (w t) <= e1 * (3 + C) * r + (G - 1) * d * r) by (unfold G; lra).
  assert (E3 : z 0 = y2 0 - y1 0 - (y2' 0 - y1' 0) - (J - J') * zb 0) by (unfold z; rewrite E1, E2; ring).
  assert (E4 : w 0 = v2 0 - v1 0 - (v2' 0 - v1' 0) - (J - J') * wb 0) by (unfold w; rewrite E1', E2'; ring).
  rewrite <- E3, <- E4; apply Rle_trans with (1 := Fin);
    apply Rle_trans with (K * (e1 * (3 + C) * r + (G - 1) * d * r)); [apply Rmult_le_compat_l; lra|].
  assert (V1 : K * (e1 * (3 + C) * r) = eps * r / 2) by (unfold e1; field; lra).
  assert (dr : 0 <= d * r) by (apply Rmult_le_pos; lra). assert (V2 : K * ((G - 1) * d * r) <= eps * r / 2).
  { apply Rle_trans with (K * (G * d) * r); [|apply Rle_trans with (eps / 2 * r); [apply Rmult_le_compat_r; lra | lra]].
    replace (K * ((G - 1) * d * r)) with (K * (G * d) * r - K * (d * r)) by ring;
      assert (0 <= K * (d * r)) by (apply Rmult_le_pos; lra); lra. }
  lra.
Qed.
End Oscillator.
