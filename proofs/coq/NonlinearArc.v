(** * Near an arc of a motion: the force is changed away from it into a Lipschitz one, which no motion near
      the arc notices, and is strictly differentiable along the arc, at one distance for all times *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Derivatives StatementNonlinear NonlinearGronwall NonlinearPicard NonlinearSmooth
    NonlinearTube.
From Grazing Require NonlinearFlow NonlinearKick.
Open Scope R_scope.

(** The linearized equation of coefficients kk, cc, ll along the orbit of F, on [0, T]. *)
Definition along_arc (F : NonlinearFlow.force) (kk cc ll : R -> R) : Prop :=
  (forall x, 0 <= x <= @NonlinearFlow.T F -> Rabs (kk x) <= @NonlinearFlow.L F /\ Rabs (cc x) <= @NonlinearFlow.L F /\
    Rabs (ll x) <= @NonlinearFlow.L F) /\
  (forall eps, 0 < eps -> exists d, 0 < d /\ forall x y v mu y' v' mu', 0 <= x <= @NonlinearFlow.T F ->
    Rabs (y - @NonlinearFlow.y0 F x) <= d -> Rabs (v - @NonlinearFlow.v0 F x) <= d -> Rabs mu <= d ->
    Rabs (y' - @NonlinearFlow.y0 F x) <= d -> Rabs (v' - @NonlinearFlow.v0 F x) <= d -> Rabs mu' <= d ->
    Rabs (@NonlinearFlow.a F x y v mu - @NonlinearFlow.a F x y' v' mu' - (kk x * (y - y') + cc x * (v - v') +
      ll x * (mu - mu'))) <= eps * (Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu'))) /\
  forall m s p q, exists z w, NonlinearKick.solves kk cc ll m z w /\ z s = p /\ w s = q.

Section Arc.
Variables (a a_t a_y a_v a_mu : R -> R -> R -> R -> R) (T r : R) (yy vv : R -> R).
Hypothesis HT : 0 < T.
Hypothesis Hr : 0 < r.
Definition inside (d t y v mu : R) : Prop := Rabs (y - yy t) <= d /\ Rabs (v - vv t) <= d /\ Rabs mu <= d.
Hypothesis Hmv : forall t, - r <= t <= T + r -> derivable_pt_lim yy t (vv t) /\
  derivable_pt_lim vv t (a t (yy t) (vv t) 0).
Hypothesis HC : C1 (fun t y v mu => - r <= t <= T + r /\ inside r t y v mu) a a_t a_y a_v a_mu.
Definition arc_at (f : R -> R -> R -> R -> R) (t : R) : R := f t (yy t) (vv t) 0.

Lemma here_inside d t : 0 < d -> inside d t (yy t) (vv t) 0.
Proof. intros Hd; unfold inside; rewrite !Rminus_eq_0, Rabs_R0; lra. Qed.
Lemma arc_steady t e : 0 <= t <= T -> 0 < e -> exists d, 0 < d /\ d <= e /\ d <= r /\ forall s, Rabs (s - t) <= d ->
  Rabs (yy s - yy t) <= e /\ Rabs (vv s - vv t) <= e.
Proof.
  intros Ht He; destruct (Hmv t ltac:(lra)) as [A B].
  destruct (continuous_near _ t e (D_continuous _ _ _ A) He) as (d1 & D1 & N1), (continuous_near _ t e (D_continuous _ _
    _ B) He) as (d2 & D2 & N2).
  destruct (two_least d1 d2 D1 D2) as (d3 & D3 & L1 & L2), (two_least d3 e D3 He) as (d4 & D4 & L3 & L4), (two_least d4
    r D4 Hr) as (d & Hd & L5 & L6); exists d; split; [exact Hd | split; [lra | split; [lra|]]].
  intros s Hs; split; [apply N1 | apply N2]; lra.
Qed.
Lemma sum_apart x y z e e' : Rabs (x - y) <= e -> Rabs (y - z) <= e' -> Rabs (x - z) <= e + e'.
Proof. intros A B; replace (x - z) with ((x - y) + (y - z)) by ring; eapply Rle_trans; [apply Rabs_triang | lra]. Qed.
(** [strictly], near the arc at the time t. *)
Lemma arc_strictly t eps : 0 <= t <= T -> 0 < eps -> exists d, 0 < d /\ d <= 1 /\ forall t1 y1 v1 m1 t2 y2 v2 m2,
  Rabs (t1 - t) <= d -> Rabs (t2 - t) <= d -> inside d t1 y1 v1 m1 -> inside d t2 y2 v2 m2 ->
  Rabs (y1 - yy t) <= 1 /\ Rabs (v1 - vv t) <= 1 /\ Rabs (a t1 y1 v1 m1 - a t2 y2 v2 m2 - (arc_at a_t t * (t1 - t2) +
  arc_at a_y t * (y1 - y2) + arc_at a_v t * (v1 - v2) + arc_at a_mu t * (m1 - m2))) <=
  eps * (Rabs (t1 - t2) + Rabs (y1 - y2) + Rabs (v1 - v2) + Rabs (m1 - m2)).
Proof.
  intros Ht He; destruct (arc_steady t (r / 2) Ht ltac:(lra)) as (q & Hq & Lq & Lq' & Nq).
  destruct (strictly _ _ _ _ _ _ t (yy t) (vv t) 0 q HC Hq) with (eps := eps) as (d & Hd & H); [|exact He|].
  { intros t' y v m Ht' Hy Hv Hm; destruct (Nq t' Ht') as [N1 N2]; rewrite Rminus_0_r in Hm; rewrite Rabs_minus_sym in
      N1, N2. split; [apply le_abs in Ht'; lra|]. split; [|split; [|lra]]; (eapply Rle_trans; [eapply sum_apart;
      eassumption | lra]). }
  destruct (two_least d 1 Hd ltac:(lra)) as (d1 & D1 & L1 & L2), (arc_steady t (d1 / 2) Ht ltac:(lra)) as (e & He' & Le
    & _ & Ne). exists e; split; [exact He' | split; [lra|]]; intros t1 y1 v1 m1 t2 y2 v2 m2 T1 T2 (Y1 & V1 & M1) (Y2 &
    V2 & M2). destruct (Ne t1 T1) as [N1 N2], (Ne t2 T2) as [N3 N4]. pose proof (sum_apart _ _ _ _ _ Y1 N1);
    pose proof (sum_apart _ _ _ _ _ V1 N2); pose proof (sum_apart _ _ _ _ _ Y2 N3); pose proof (sum_apart _ _ _ _ _ V2
    N4). split; [lra | split; [lra|]]; apply H; rewrite ?Rminus_0_r; lra.
Qed.
(** [everywhere], asking for it only near the times of the arc. *)
Lemma arc_everywhere (P : R -> R -> Prop) : (forall s d d', P s d -> 0 < d' <= d -> P s d') -> (forall t, 0 <= t <= T ->
  exists d, 0 < d /\ forall s, 0 <= s <= T -> Rabs (s - t) <= d -> P s d) -> exists d, 0 < d /\ forall s, 0 <= s <= T ->
  P s d.
Proof.
  intros Down Near; destruct (everywhere (fun s d => 0 <= s <= T -> P s d) T ltac:(lra)) as (d & Hd & H).
  - intros s d d' H Hd Hs; apply (Down s d); auto.
  - intros t; destruct (Rle_dec 0 t) as [A|A]; [destruct (Rle_dec t T) as [B|B]|].
    + destruct (Near t (conj A B)) as (d & Hd & H); exists d; split; [exact Hd|]; intros s Hs Hi; apply H; assumption.
    + exists ((t - T) / 2); split; [lra|]; intros s Hs Hi; apply le_abs in Hs; lra.
    + exists (- t / 2); split; [lra|]; intros s Hs Hi; apply le_abs in Hs; lra.
  - exists d; split; [exact Hd|]; intros s Hs; apply H; exact Hs.
Qed.
Definition froz (t : R) : R := Rmax 0 (Rmin T t).
Lemma froz_in t : 0 <= froz t <= T.
Proof. unfold froz, Rmax, Rmin; repeat destruct Rle_dec; lra. Qed.
Lemma froz_id t : 0 <= t <= T -> froz t = t.
Proof. intros H; unfold froz, Rmax, Rmin; repeat destruct Rle_dec; lra. Qed.
Lemma froz_lip t s : Rabs (froz t - froz s) <= Rabs (t - s).
Proof. unfold froz, Rmax, Rmin, Rabs; repeat destruct Rle_dec; repeat destruct Rcase_abs; lra. Qed.
Lemma froz_continuous f t : (forall s, 0 <= s <= T -> forall e, 0 < e -> exists d, 0 < d /\ forall s', 0 <= s' <= T ->
  Rabs (s' - s) <= d -> Rabs (f s' - f s) <= e) -> continuity_pt (fun t => f (froz t)) t.
Proof.
  intros H e He; destruct (H (froz t) (froz_in t) (e / 2) ltac:(lra)) as (d & Hd & N); exists d; split; [exact Hd|].
  intros s [_ Hs]; cbn in *; unfold R_dist in *; pose proof (froz_lip s t); specialize (N (froz s) (froz_in s)
    ltac:(lra)); lra.
Qed.
Lemma froz_bounded f : (forall t, continuity_pt (fun t => f (froz t)) t) -> exists B, 0 <= B /\ forall t,
  Rabs (f (froz t)) <= B.
Proof.
  intros C; destruct (continuous_bounded (fun t => f (froz t)) T HT C) as (B & HB & H); exists B; split; [exact HB|];
    intros t. rewrite <- (froz_id (froz t) (froz_in t)); apply H; destruct (froz_in t); rewrite Rabs_pos_eq; lra.
Qed.
Lemma along_continuous f : continuous (fun t y v mu => - r <= t <= T + r /\ inside r t y v mu) f -> forall t,
  continuity_pt (fun t => arc_at f (froz t)) t.
Proof.
  intros C t; apply (froz_continuous (fun t => arc_at f t)); intros s Hs e He.
  assert (I : - r <= s <= T + r) by lra; destruct (C s (yy s) (vv s) 0 (conj I (here_inside r s Hr)) e He) as (d & Hd &
      H).
  destruct (arc_steady s d Hs Hd) as (q & Hq & L1 & _ & N); exists q; split; [exact Hq|]; intros s' _ Hs'; destruct (N
    s' Hs'); apply H; try lra. rewrite Rminus_eq_0, Rabs_R0; lra.
Qed.
Definition k t := arc_at a_y (froz t). Definition c t := arc_at a_v (froz t). Definition l t := arc_at a_mu (froz t).
Lemma coefficients t : continuity_pt k t /\ continuity_pt c t /\ continuity_pt l t.
Proof. destruct HC as [_ _ _ _ (_ & C2 & C3 & C4)]; repeat split; apply along_continuous; assumption. Qed.

Lemma arc_derivatives eps : 0 < eps -> exists d, 0 < d /\ forall t, 0 <= t <= T -> forall y v mu y' v' mu',
  inside d t y v mu -> inside d t y' v' mu' -> Rabs (a t y v mu - a t y' v' mu' - (k t * (y - y') + c t * (v - v') +
  l t * (mu - mu'))) <= eps * (Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu')).
Proof.
  intros He; apply (arc_everywhere (fun t d => forall y v mu y' v' mu', inside d t y v mu -> inside d t y' v' mu' ->
    Rabs (a t y v mu - a t y' v' mu' - (k t * (y - y') + c t * (v - v') + l t * (mu - mu'))) <= eps * (Rabs (y - y') +
    Rabs (v - v') + Rabs (mu - mu')))).
  - intros s d d' H Hd y v mu y' v' mu' (A & B & C) (A' & B' & C'); apply H; unfold inside; repeat split; lra.
  - intros t Ht; destruct (arc_strictly t (eps / 2) Ht ltac:(lra)) as (d & Hd & _ & H), (coefficients t) as (C1 & C2 &
      C3).
    destruct (continuous_near _ t (eps / 2) C1 ltac:(lra)) as (e1 & E1 & N1), (continuous_near _ t (eps / 2) C2
      ltac:(lra)) as (e2 & E2 & N2), (continuous_near _ t (eps / 2) C3 ltac:(lra)) as (e3 & E3 & N3).
    destruct (two_least e1 e2 E1 E2) as (e4 & E4 & L1 & L2), (two_least e4 e3 E4 E3) as (e5 & E5 & L3 & L4), (two_least
      e5 d E5 Hd) as (q & Hq & L5 & L6); exists q; split; [exact Hq|].
    intros s Hi Hs y v mu y' v' mu' (A & B & C) (A' & B' & C'); destruct (H s y v mu s y' v' mu') as (_ & _ & Q);
      unfold inside; repeat split; try lra. pose proof (product _ _ _ _ (N1 s ltac:(lra)) (Rle_refl (Rabs (y - y')))) as
      P1; pose proof (product _ _ _ _ (N2 s ltac:(lra)) (Rle_refl (Rabs (v - v')))) as P2.
    pose proof (product _ _ _ _ (N3 s ltac:(lra)) (Rle_refl (Rabs (mu - mu')))) as P3; rewrite Rminus_eq_0, Rabs_R0 in
      Q. unfold k, c, l in P1, P2, P3; rewrite !(froz_id t Ht) in P1, P2, P3; fold (k s) (c s) (l s) in P1, P2, P3.
    apply le_abs in Q, P1, P2, P3; apply Rabs_le; lra.
Qed.
Lemma arc_Lipschitz : exists L q, 0 <= L /\ 0 < q <= r /\ forall t y v mu t' y' v' mu', 0 <= t <= T -> 0 <= t' <= T ->
  inside q t y v mu -> inside q t' y' v' mu' -> Rabs (a t y v mu) <= L /\
  Rabs (a t y v mu - a t' y' v' mu') <= L * (Rabs (t - t') + Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu')).
Proof.
  set (P s d := forall t y v mu t' y' v' mu', Rabs (t - s) <= d -> Rabs (t' - s) <= d -> inside d t y v mu ->
    inside d t' y' v' mu' -> Rabs (a t y v mu) <= / d /\
    Rabs (a t y v mu - a t' y' v' mu') <= / d * (Rabs (t - t') + Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu'))).
  assert (Pos : forall x y z w : R, 0 <= Rabs x + Rabs y + Rabs z + Rabs w)
    by (intros; repeat apply Rplus_le_le_0_compat; apply Rabs_pos). destruct (arc_everywhere P) as (d & Hd & H).
  - intros s d d' H Hd t y v mu t' y' v' mu' H1 H2 (A & B & C) (A' & B' & C'); assert (I : / d <= / d') by (apply
      Rinv_le_contravar; lra). destruct (H t y v mu t' y' v' mu') as [Q Q']; unfold inside; repeat split; try lra.
      eapply Rle_trans; [exact Q'|]; apply Rmult_le_compat_r; [apply Pos | exact I].
  - intros t Ht; destruct (arc_strictly t 1 Ht ltac:(lra)) as (d & Hd & Hd1 & H); set (p := a t (yy t) (vv t) 0).
    set (L := 1 + Rabs (arc_at a_t t) + Rabs (arc_at a_y t) + Rabs (arc_at a_v t) + Rabs (arc_at a_mu t)).
    assert (HL : 1 <= L) by (unfold L; pose proof (Pos (arc_at a_t t) (arc_at a_y t) (arc_at a_v t) (arc_at a_mu t));
        lra).
    assert (Lip : forall t1 y1 v1 m1 t2 y2 v2 m2, Rabs (t1 - t) <= d -> Rabs (t2 - t) <= d -> inside d t1 y1 v1 m1 ->
      inside d t2 y2 v2 m2 -> Rabs (a t1 y1 v1 m1 - a t2 y2 v2 m2) <=
      L * (Rabs (t1 - t2) + Rabs (y1 - y2) + Rabs (v1 - v2) + Rabs (m1 - m2))).
    { intros t1 y1 v1 m1 t2 y2 v2 m2 X1 X2 X3 X4; destruct (H _ _ _ _ _ _ _ _ X1 X2 X3 X4) as (_ & _ & Q).
      set (S := Rabs (t1 - t2) + Rabs (y1 - y2) + Rabs (v1 - v2) + Rabs (m1 - m2)) in *.
      assert (B : forall u w : R, Rabs w <= S -> Rabs (u * w) <= Rabs u * S) by (intros u w Hw; apply product;
        [lra | exact Hw]). pose proof (Rabs_pos (t1 - t2)); pose proof (Rabs_pos (y1 - y2));
        pose proof (Rabs_pos (v1 - v2)); pose proof (Rabs_pos (m1 - m2)).
      pose proof (B (arc_at a_t t) (t1 - t2) ltac:(unfold S; lra)) as B1;
        pose proof (B (arc_at a_y t) (y1 - y2) ltac:(unfold S; lra)) as B2.
      pose proof (B (arc_at a_v t) (v1 - v2) ltac:(unfold S; lra)) as B3; pose proof (B (arc_at a_mu t) (m1 - m2)
        ltac:(unfold S; lra)) as B4. apply le_abs in Q, B1, B2, B3, B4; apply Rabs_le; unfold L; lra. }
    set (K := L * 4 + Rabs p); assert (HK : 4 <= K) by (unfold K; pose proof (Rabs_pos p); lra).
    destruct (two_least (d / 2) (/ K) ltac:(lra) ltac:(apply Rinv_0_lt_compat; lra)) as (q & Hq & L1 & L2); exists q;
      split; [exact Hq|]. assert (Kq : K <= / q) by (rewrite <- (Rinv_inv K); apply Rinv_le_contravar; assumption).
    assert (Sh : forall u s, Rabs (s - t) <= q -> Rabs (u - s) <= q -> Rabs (u - t) <= d).
    { intros u s A B; replace (u - t) with ((u - s) + (s - t)) by ring; eapply Rle_trans; [apply Rabs_triang | lra]. }
    intros s _ Hs t1 y1 v1 m1 t2 y2 v2 m2 X1 X2 (X3 & X4 & X7) (X5 & X6 & X8); pose proof (Sh t1 s Hs X1) as S1;
      pose proof (Sh t2 s Hs X2) as S2. assert (T1 : inside d t1 y1 v1 m1) by (unfold inside; repeat split; lra);
      assert (T2 : inside d t2 y2 v2 m2) by (unfold inside; repeat split; lra); split.
    + assert (Z : Rabs (t - t) <= d) by (rewrite Rminus_eq_0, Rabs_R0; lra).
      pose proof (Lip t1 y1 v1 m1 t (yy t) (vv t) 0 S1 Z T1 (here_inside d t Hd)) as Q; fold p in Q;
        destruct (H t1 y1 v1 m1 t (yy t) (vv t) 0 S1 Z T1 (here_inside d t Hd)) as (Q1 & Q2 & _). rewrite Rminus_0_r in
        Q; replace (a t1 y1 v1 m1) with ((a t1 y1 v1 m1 - p) + p) by ring; eapply Rle_trans; [apply Rabs_triang|].
      assert (L * (Rabs (t1 - t) + Rabs (y1 - yy t) + Rabs (v1 - vv t) + Rabs m1) <= L * 4)
        by (apply Rmult_le_compat_l; lra); unfold K in *; lra.
    + eapply Rle_trans; [apply Lip; trivial; lra|]; apply Rmult_le_compat_r; [apply Pos|]; unfold K in *;
        pose proof (Rabs_pos p); lra.
  - destruct (two_least d r Hd Hr) as (q & Hq & L1 & L2); pose proof (Rinv_0_lt_compat d Hd) as I; exists (/ d + 2 * / d
      * / d), q; assert (I3 : 0 <= / d * / d) by (apply Rmult_le_pos; lra). split; [lra | split; [lra|]];
      intros t y v mu t' y' v' mu' Ht Ht' (X1 & X2 & X3) (X4 & X5 & X6).
    assert (X : inside d t y v mu) by (unfold inside; repeat split; lra);
      assert (X' : inside d t' y' v' mu') by (unfold inside; repeat split; lra).
    set (S := Rabs (t - t') + Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu')); assert (S0 : 0 <= S) by apply Pos.
    assert (Z : forall u, Rabs (u - u) <= d) by (intros u; rewrite Rminus_eq_0, Rabs_R0; lra).
    assert (I2 : 0 <= 2 * / d * / d * S) by (apply Rmult_le_pos; [lra | exact S0]).
    destruct (H t Ht t y v mu t y v mu (Z t) (Z t) X X) as [Q _]; split; [lra|].
    destruct (Rle_dec (Rabs (t' - t)) d) as [N|N].
    + destruct (H t Ht t y v mu t' y' v' mu' (Z t) N X X') as [_ Q']; fold S in Q'; lra.
    + destruct (H t' Ht' t' y' v' mu' t' y' v' mu' (Z t') (Z t') X' X') as [Q' _]. eapply Rle_trans;
        [apply apart|]; assert (d <= S).
      { rewrite Rabs_minus_sym in N; unfold S; pose proof (Rabs_pos (y - y')); pose proof (Rabs_pos (v - v'));
          pose proof (Rabs_pos (mu - mu')); lra. }
      assert (/ d * d = 1) by (apply Rinv_l; lra); assert (/ d * d <= / d * S) by (apply Rmult_le_compat_l; lra).
      assert (2 * / d * 1 <= 2 * / d * (/ d * S)) by (apply Rmult_le_compat_l; lra);
        assert (0 <= / d * S) by (apply Rmult_le_pos; lra); lra.
Qed.

(** The force near the arc, for all times, places and velocities. *)
Lemma vv_continuous t : continuity_pt (fun t => vv (froz t)) t.
Proof.
  apply (froz_continuous vv); intros s Hs e He; destruct (arc_steady s e Hs He) as (d & Hd & _ & _ & N); exists d;
    split; [exact Hd|]; intros s' _ Hs'; apply N, Hs'.
Qed.
Theorem arc_force : exists (F : NonlinearFlow.force) q, 0 < q <= r /\ @NonlinearFlow.T F = T /\
  (forall t, 0 <= t <= T -> @NonlinearFlow.y0 F t = yy t /\ @NonlinearFlow.v0 F t = vv t) /\
  (forall t y v mu, 0 <= t <= T -> inside q t y v mu -> @NonlinearFlow.a F t y v mu = a t y v mu) /\
  along_arc F k c l.
Proof.
  destruct arc_Lipschitz as (L0 & q & HL0 & Hq & Lip); assert (Hq0 : 0 < q) by lra.
  destruct (froz_bounded vv vv_continuous) as (Bv & HBv & Hv).
  destruct (froz_bounded (arc_at a_y) (fun t => proj1 (coefficients t))) as (B1 & P1 & H1), (froz_bounded (arc_at a_v)
    (fun t => proj1 (proj2 (coefficients t)))) as (B2 & P2 & H2), (froz_bounded (arc_at a_mu) (fun t => proj2 (proj2
    (coefficients t)))) as (B3 & P3 & H3).
  set (B := Bv + L0); assert (HB : 0 <= B) by (unfold B; lra).
  assert (Yl : forall t t', Rabs (yy (froz t) - yy (froz t')) <= B * Rabs (t - t')).
  { intros t t'; eapply Rle_trans; [apply (mvt_on T yy vv B (froz t) (froz t') (froz_in t) (froz_in t'))|].
    - intros s Hs; split; [apply Hmv; lra|]; specialize (Hv s); rewrite (froz_id s Hs) in Hv; unfold B; lra.
    - apply Rmult_le_compat_l; [exact HB | apply froz_lip]. }
  assert (Vl : forall t t', Rabs (vv (froz t) - vv (froz t')) <= B * Rabs (t - t')).
  { intros t t'; eapply Rle_trans; [apply (mvt_on T vv (fun s => a s (yy s) (vv s) 0) B (froz t) (froz t') (froz_in t)
      (froz_in t'))|].
    - intros s Hs; split; [apply Hmv; lra|]; destruct (Lip s (yy s) (vv s) 0 s (yy s) (vv s) 0 Hs Hs (here_inside q s
        Hq0) (here_inside q s Hq0)) as [Q _]; unfold B; lra.
    - apply Rmult_le_compat_l; [exact HB | apply froz_lip]. }
  set (a1 := fun t y v mu => a (froz t) (yy (froz t) + cl q (y - yy (froz t))) (vv (froz t) + cl q (v - vv (froz t)))
    (cl q mu)).
  assert (In : forall t y v mu, inside q (froz t) (yy (froz t) + cl q (y - yy (froz t))) (vv (froz t) + cl q (v - vv
    (froz t))) (cl q mu)).
  { intros t y v mu; unfold inside; repeat split; try (match goal with |- Rabs (?u + ?w - ?u) <= _ => replace (u + w -
      u) with w by ring end); apply cl_in, Hq0. }
  assert (Agree : forall t y v mu, 0 <= t <= T -> inside q t y v mu -> a1 t y v mu = a t y v mu).
  { intros t y v mu Ht (A & A' & A''); unfold a1; rewrite (froz_id t Ht), !cl_id by assumption; f_equal; ring. }
  set (L := 1 + L0 * (1 + 4 * B) + B1 + B2 + B3); assert (0 <= L0 * (1 + 4 * B)) by (apply Rmult_le_pos; lra).
  assert (HL : 1 <= L) by (unfold L; lra).
  assert (Lip1 : forall t y v mu t' y' v' mu', Rabs (a1 t y v mu - a1 t' y' v' mu') <= L * (Rabs (t - t') + Rabs (y -
    y') + Rabs (v - v') + Rabs (mu - mu'))).
  { intros t y v mu t' y' v' mu'; destruct (Lip _ _ _ _ _ _ _ _ (froz_in t) (froz_in t') (In t y v mu) (In t' y' v'
      mu')) as [_ Q]; apply Rle_trans with (1 := Q); pose proof (froz_lip t t') as Q0; pose proof (cl_lip q Hq0 mu mu')
      as Q3. pose proof (Rabs_pos (t - t')) as A1; pose proof (Rabs_pos (y - y')) as A2; pose proof (Rabs_pos (v - v'))
      as A3; pose proof (Rabs_pos (mu - mu')) as A4.
    assert (One : forall f u u', Rabs (f (froz t) - f (froz t')) <= B * Rabs (t - t') -> Rabs (f (froz t) + cl q (u - f
      (froz t)) - (f (froz t') + cl q (u' - f (froz t')))) <= 2 * B * Rabs (t - t') + Rabs (u - u')).
    { intros f u u' Hf; pose proof (cl_lip q Hq0 (u - f (froz t)) (u' - f (froz t'))) as Z; replace (u - f (froz t) -
        (u' - f (froz t'))) with ((u - u') - (f (froz t) - f (froz t'))) in Z by ring.
      pose proof (apart (u - u') (f (froz t) - f (froz t'))); match goal with |- Rabs ?e <= _ => replace e with ((f
        (froz t) - f (froz t')) + (cl q (u - f (froz t)) - cl q (u' - f (froz t')))) by ring end.
      eapply Rle_trans; [apply Rabs_triang | lra]. }
    pose proof (One yy y y' (Yl t t')) as Q1; pose proof (One vv v v' (Vl t t')) as Q2.
    set (S := Rabs (t - t') + Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu')); assert (S0 : 0 <= S) by (unfold S; lra).
    apply Rle_trans with (L0 * ((1 + 4 * B) * S)).
    - apply Rmult_le_compat_l; [exact HL0|]; assert (0 <= B * Rabs (y - y')) by (apply Rmult_le_pos; lra); assert (0 <=
        B * Rabs (v - v')) by (apply Rmult_le_pos; lra); assert (0 <= B * Rabs (mu - mu')) by (apply Rmult_le_pos; lra);
        unfold S; lra.
    - rewrite <- Rmult_assoc; apply Rmult_le_compat_r; [exact S0 | unfold L; lra]. }
  assert (Flow : forall mu s p p', exists y v, NonlinearFlow.runs a1 mu y v /\ y s = p /\ v s = p').
  { intros mu s p p'; apply (picard (fun t y v => a1 t y v mu) L); [lra | | |].
    - intros t y v y' v'; pose proof (Lip1 t y v mu t y' v' mu) as Q; rewrite !Rminus_eq_0, Rabs_R0 in Q; lra.
    - intros t y v x Hx; exists (x / (2 * L)); split; [apply Rdiv_lt_0_compat; lra|]; intros s' [_ Hs]; cbn in *; unfold
        R_dist in *. pose proof (Lip1 s' y v mu t y v mu) as Q; rewrite !Rminus_eq_0, Rabs_R0 in Q; eapply Rle_lt_trans;
        [exact Q|]. apply Rle_lt_trans with (L * (x / (2 * L))); [apply Rmult_le_compat_l; lra | replace (L * (x / (2 *
        L))) with (x / 2) by (field; lra); lra].
    - intros y v; exists L0; intros t; apply (Lip _ _ _ _ _ _ _ _ (froz_in t) (froz_in t) (In t y v mu) (In t y v mu)).
    }
  destruct (Flow 0 0 (yy 0) (vv 0)) as (y0 & v0 & Orb & E1 & E2).
  assert (Same : forall t, 0 <= t <= T -> y0 t = yy t /\ v0 t = vv t).
  { intros t Ht; destruct (bound L T (fun t => y0 t - yy t) (fun t => v0 t - vv t) (fun t => a1 t (y0 t) (v0 t) 0 - a1 t
      (yy t) (vv t) 0) 0 HL ltac:(lra)) with (x := t) as [Q _]; [|exact Ht|].
    - intros s Hs; destruct (Orb s) as [D1 D2], (Hmv s ltac:(lra)) as [D3 D4]; split; [apply D_minus; assumption |
        split]. { rewrite (Agree s _ _ _ Hs (here_inside q s Hq0)); apply D_minus; assumption. }
      pose proof (Lip1 s (y0 s) (v0 s) 0 s (yy s) (vv s) 0) as Q; rewrite !Rminus_eq_0, Rabs_R0 in Q; lra.
    - cbv beta in Q; rewrite E1, E2, !Rminus_eq_0, Rabs_R0 in Q; pose proof (Rabs_pos (y0 t - yy t)); pose proof
        (Rabs_pos (v0 t - vv t)); split; apply Rminus_diag_uniq, Contraction.Rabs_zero; lra. }
  exists (NonlinearFlow.Build_force a1 T L y0 v0 HT HL Lip1 Orb Flow), q; split; [lra | split; [reflexivity | split;
    [exact Same | split; [exact Agree|]]]]. split; [|split]; cbn.
  - intros x Hx; specialize (H1 x); specialize (H2 x); specialize (H3 x); unfold k, c, l, L; lra.
  - intros eps He; destruct (arc_derivatives eps He) as (d1 & Hd1 & H4), (two_least d1 q Hd1 Hq0) as (d & Hd & Q1 & Q2);
      exists d; split; [exact Hd|]. intros x y v mu y' v' mu' Hx; destruct (Same x Hx) as [-> ->]; intros X1 X2 X3 X4 X5
      X6; rewrite !Agree by (first [exact Hx | unfold inside; lra]); apply H4; first [exact Hx | unfold inside; lra].
  - apply (linear_picard k c l (B1 + B2 + B3)); intros t; [apply coefficients|]; specialize (H1 t); specialize (H2 t);
      specialize (H3 t); unfold k, c, l; lra.
Qed.
End Arc.
