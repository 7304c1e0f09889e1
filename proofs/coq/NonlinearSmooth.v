(** * What C1 gives near the orbit: the force is Lipschitz in a tube and strictly differentiable along the
      orbit, at one distance for all times; the law of impact is strictly differentiable at the touch *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Derivatives StatementNonlinear.
Import Nonlinear.
Open Scope R_scope.

Lemma near_line f f' B e c d x y : (forall s, Rabs (s - c) <= d -> derivable_pt_lim f s (f' s) /\
  Rabs (f' s - B) <= e) -> Rabs (x - c) <= d -> Rabs (y - c) <= d -> Rabs (f x - f y - B * (x - y)) <= e * Rabs (x - y).
Proof.
  intros H Hx Hy; pose proof (Rabs_pos (f' c - B)) as P; apply le_abs in Hx, Hy.
  assert (W : forall x y, - d <= x - c <= d -> - d <= y - c <= d -> x < y -> Rabs (f y - f x - B * (y - x)) <=
    e * Rabs (y - x)).
  { intros p q Hp Hq O; destruct (MVT_cor2 f f' p q O) as (s & E & Hs); [intros s Hs; apply H, Rabs_le; lra|].
    rewrite E; replace (f' s * (q - p) - B * (q - p)) with ((f' s - B) * (q - p)) by ring; rewrite Rabs_mult.
    apply Rmult_le_compat_r; [apply Rabs_pos | apply H, Rabs_le; lra]. }
  destruct (Rtotal_order x y) as [O|[->|O]];
    [|rewrite !Rminus_eq_0, Rmult_0_r, Rminus_0_r, Rabs_R0; lra | apply W; assumption].
  replace (f x - f y - B * (x - y)) with (- (f y - f x - B * (y - x))) by ring; rewrite Rabs_Ropp, (Rabs_minus_sym x);
    apply W; assumption.
Qed.
(** A C1 function is strictly differentiable. *)
Lemma strictly D f f1 f2 f3 f4 t y v m q : C1 D f f1 f2 f3 f4 -> 0 < q -> (forall t' y' v' m', Rabs (t' - t) <= q ->
  Rabs (y' - y) <= q -> Rabs (v' - v) <= q -> Rabs (m' - m) <= q -> D t' y' v' m') -> forall eps, 0 < eps -> exists d,
  0 < d /\ forall t1 y1 v1 m1 t2 y2 v2 m2, Rabs (t1 - t) <= d -> Rabs (y1 - y) <= d -> Rabs (v1 - v) <= d ->
  Rabs (m1 - m) <= d -> Rabs (t2 - t) <= d -> Rabs (y2 - y) <= d -> Rabs (v2 - v) <= d -> Rabs (m2 - m) <= d ->
  Rabs (f t1 y1 v1 m1 - f t2 y2 v2 m2 - (f1 t y v m * (t1 - t2) + f2 t y v m * (y1 - y2) + f3 t y v m * (v1 - v2) + f4 t
  y v m * (m1 - m2))) <= eps * (Rabs (t1 - t2) + Rabs (y1 - y2) + Rabs (v1 - v2) + Rabs (m1 - m2)).
Proof.
  intros [C1t C1y C1v C1m (K1 & K2 & K3 & K4)] Hq HD eps He.
  assert (HP : D t y v m) by (apply HD; rewrite Rminus_eq_0, Rabs_R0; lra).
  destruct (K1 _ _ _ _ HP eps He) as (e1 & E1 & Q1), (K2 _ _ _ _ HP eps He) as (e2 & E2 & Q2), (K3 _ _ _ _ HP eps He)
    as (e3 & E3 & Q3), (K4 _ _ _ _ HP eps He) as (e4 & E4 & Q4).
  destruct (two_least e1 e2 E1 E2) as (a1 & A1 & L1 & L2), (two_least e3 e4 E3 E4) as (a2 & A2 & L3 & L4),
    (two_least a1 a2 A1 A2) as (a3 & A3 & L5 & L6), (two_least a3 q A3 Hq) as (d & Hd & L7 & L8). exists d; split;
    [exact Hd|]; intros t1 y1 v1 m1 t2 y2 v2 m2 T1 Y1 V1 M1 T2 Y2 V2 M2.
  pose proof (near_line (fun x => f x y1 v1 m1) (fun x => f1 x y1 v1 m1) (f1 t y v m) eps t d t1 t2 ltac:(intros s Hs;
    split; [apply C1t, HD | apply Q1]; lra) T1 T2) as B1.
  pose proof (near_line (fun x => f t2 x v1 m1) (fun x => f2 t2 x v1 m1) (f2 t y v m) eps y d y1 y2 ltac:(intros s Hs;
    split; [apply C1y, HD | apply Q2]; lra) Y1 Y2) as B2.
  pose proof (near_line (fun x => f t2 y2 x m1) (fun x => f3 t2 y2 x m1) (f3 t y v m) eps v d v1 v2 ltac:(intros s Hs;
    split; [apply C1v, HD | apply Q3]; lra) V1 V2) as B3.
  pose proof (near_line (fun x => f t2 y2 v2 x) (fun x => f4 t2 y2 v2 x) (f4 t y v m) eps m d m1 m2 ltac:(intros s Hs;
    split; [apply C1m, HD | apply Q4]; lra) M1 M2) as B4. cbv beta in *; apply le_abs in B1, B2, B3, B4; apply Rabs_le;
    lra.
Qed.
(** The law of impact at the touch. *)
Lemma law_strict (reb : R -> R -> R -> R) (ta tg : R) f1 f2 f3 f4 r : (forall mu t, reb mu t 0 = 0) -> 0 < r -> f3 tg 0
    0 0 =
  - ta -> C1 (fun t y v mu => Rabs (t - tg) <= r /\ Rabs v <= r /\ Rabs mu <= r) (fun t y v mu => reb mu t v) f1 f2 f3
      f4 ->
  forall eps, 0 < eps -> exists d, 0 < d /\ forall mu t v mu' t' v', Rabs mu <= d -> Rabs (t - tg) <= d ->
  Rabs v <= d -> Rabs mu' <= d -> Rabs (t' - tg) <= d -> Rabs v' <= d -> Rabs (reb mu t v - reb mu' t' v' + ta * (v -
      v')) <=
  eps * (Rabs (mu - mu') + Rabs (t - t') + Rabs (v - v')).
Proof.
  intros R0 Hr E3 HC eps He.
  assert (D0 : Rabs (tg - tg) <= r /\ Rabs 0 <= r /\ Rabs 0 <= r) by (rewrite Rminus_eq_0, Rabs_R0; lra).
  assert (E1 : f1 tg 0 0 0 = 0).
  { apply (uniqueness_limite (fun t => reb 0 t 0) tg); [apply (in_t _ _ _ _ _ _ HC), D0|]; eapply D_ext;
      [apply (D_const 0) | intros; symmetry; apply R0 | reflexivity]. }
  assert (E4 : f4 tg 0 0 0 = 0).
  { apply (uniqueness_limite (fun mu => reb mu tg 0) 0); [apply (in_mu _ _ _ _ _ _ HC), D0|]; eapply D_ext;
      [apply (D_const 0) | intros; symmetry; apply R0 | reflexivity]. }
  destruct (strictly _ _ _ _ _ _ tg 0 0 0 r HC Hr) with (eps := eps) as (d & Hd & H); [|exact He|].
  { intros t' y' v' m' A _ B C; rewrite Rminus_0_r in B, C; auto. }
  exists d; split; [exact Hd|]; intros mu t v mu' t' v' A1 A2 A3 A4 A5 A6;
    assert (Z : Rabs (0 - 0) <= d) by (rewrite Rminus_0_r, Rabs_R0; lra). specialize (H t 0 v mu t' 0 v' mu');
    rewrite !Rminus_0_r, Rabs_R0, E1, E3, E4 in H.
  match type of H with _ -> _ -> _ -> _ -> _ -> _ -> _ -> _ -> Rabs ?u <= _ => match goal with |- Rabs ?w <=
    _ => replace w with u by ring end end. eapply Rle_trans; [apply H; rewrite ?Rabs_R0; lra | right; ring].
Qed.
(** What holds near each time, holds at one distance on [0, T]. *)
Lemma everywhere (P : R -> R -> Prop) T : 0 <= T -> (forall s d d', P s d -> 0 < d' <= d -> P s d') -> (forall t,
  exists d, 0 < d /\ forall s, Rabs (s - t) <= d -> P s d) -> exists d, 0 < d /\ forall s, 0 <= s <= T -> P s d.
Proof.
  intros HT Down Near; set (E x := 0 <= x <= T /\ exists d, 0 < d /\ forall s, 0 <= s <= x -> P s d). assert (E0 : E 0).
  { split; [lra|]; destruct (Near 0) as (d & Hd & H); exists d; split; [exact Hd|]; intros s Hs; apply H, Rabs_le; lra.
    }
  destruct (completeness E) as [m [Up Least]]; [exists T; intros x [Hx _]; lra | exists 0; exact E0|].
  pose proof (Up 0 E0) as M0; assert (MT : m <= T) by (apply Least; intros x [Hx _]; lra);
    destruct (Near m) as (dm & Hdm & Hm). assert (X : exists x, E x /\ m - dm < x).
  { apply Classical_Prop.NNPP; intros N; assert (m <= m - dm); [|lra]; apply Least; intros x Ex; apply Rnot_lt_le;
      intros O; apply N; exists x; auto. }
  destruct X as (x & [Hx (d & Hd & H)] & Lx), (two_least d dm Hd Hdm) as (d' & Hd' & L1 & L2).
  assert (R : forall s, 0 <= s <= Rmin (m + dm) T -> P s d').
  { intros s [S0 S1]; pose proof (Rmin_l (m + dm) T); destruct (Rle_dec s x) as [O|O];
      [apply (Down s d); [apply H; lra | lra]|]. apply (Down s dm); [apply Hm, Rabs_le; lra | lra]. }
  assert (Em : E (Rmin (m + dm) T)).
  { split; [split; [apply Rmin_glb; lra | apply Rmin_r] | exists d'; split; assumption]. }
  apply Up in Em; assert (T <= m) by (revert Em; unfold Rmin; destruct Rle_dec; lra). exists d'; split; [exact Hd'|];
    intros s Hs; apply R; split; [lra | apply Rmin_glb; lra].
Qed.
Lemma in_one_period T t : 0 < T -> exists z, 0 <= t - T * IZR z <= T.
Proof.
  intros HT; destruct (archimed (t / T)) as [A1 A2]; exists (up (t / T) - 1)%Z; rewrite minus_IZR;
    set (u := IZR (up (t / T))) in *. assert (Et : t = T * (t / T)) by (field; lra); set (q := t / T) in *; rewrite Et;
    split; nra.
Qed.

Section Orbit.
Variable O : Nonlinear.t.
Hypothesis HO : grazing_orbit O.
Definition k := along O (a_y O).
Definition c := along O (a_v O).
Definition l := along O (a_mu O).
Lemma orbit_continuous t : continuity_pt (y0 O) t /\ continuity_pt (v0 O) t.
Proof. destruct (orbit_moves O HO t) as [A B]; split; [apply (D_continuous _ _ _ A) | apply (D_continuous _ _ _ B)].
Qed.
Lemma steady t e : 0 < e -> exists d, 0 < d /\ d <= e /\ forall s, Rabs (s - t) <= d -> Rabs (y0 O s - y0 O t) <= e /\
  Rabs (v0 O s - v0 O t) <= e.
Proof.
  intros He;
    destruct (orbit_continuous t) as [A B], (continuous_near _ t e A He) as (d1 & D1 & N1), (continuous_near _ t e B He)
      as (d2 & D2 & N2).
  destruct (two_least d1 d2 D1 D2) as (d3 & D3 & L1 & L2), (two_least d3 e D3 He) as (d & Hd & L3 & L4); exists d;
    split; [exact Hd | split; [exact L4|]]. intros s Hs; split; [apply N1 | apply N2]; lra.
Qed.
Lemma along_continuous r f t : 0 < r -> continuous (fun t y v mu => tube O r t y v /\ Rabs mu <= r) f ->
  continuity_pt (along O f) t.
Proof.
  intros Hr C e He; destruct (C t (y0 O t) (v0 O t) 0) with (eps := e / 2) as (d & Hd & H); [|lra|].
  { unfold tube; rewrite !Rminus_eq_0, Rabs_R0; lra. }
  destruct (steady t d Hd) as (q & Hq & L & N); exists q; split; [exact Hq|]; intros s [_ Hs]; cbn in *;
    unfold R_dist in *. destruct (N s ltac:(lra)) as [N1 N2]; unfold along;
    specialize (H s (y0 O s) (v0 O s) 0 ltac:(lra) N1 N2). rewrite Rminus_eq_0, Rabs_R0 in H; specialize (H ltac:(lra));
    lra.
Qed.
Lemma along_continuous_all : forall t, continuity_pt k t /\ continuity_pt c t /\ continuity_pt l t.
Proof. destruct (force_C1 O HO) as (r & Hr & [_ _ _ _ (_ & C2 & C3 & C4)]); intros t; repeat split;
  apply (along_continuous r); assumption. Qed.
Lemma along_periodic t : k (t + T O) = k t /\ c (t + T O) = c t /\ l (t + T O) = l t.
Proof.
  destruct (force_C1 O HO) as (r & Hr & [_ Cy Cv Cm _]), (has_period O HO) as [_ HP]; destruct (HP t) as (E1 & E2 & Ea).
  assert (P : forall s, tube O r s (y0 O s) (v0 O s) /\ Rabs 0 <= r) by (intros s; unfold tube; rewrite !Rminus_eq_0,
    Rabs_R0; lra). pose proof (P t) as P0; pose proof (P (t + T O)) as P1; unfold k, c, l, along; rewrite E1, E2 in *;
    split; [|split].
  - apply (uniqueness_limite (fun x => a O t x (v0 O t) 0) (y0 O t)); [|apply Cy, P0]; eapply D_ext;
      [apply Cy, P1 | intros x; apply Ea | reflexivity].
  - apply (uniqueness_limite (fun x => a O t (y0 O t) x 0) (v0 O t)); [|apply Cv, P0]; eapply D_ext;
      [apply Cv, P1 | intros x; apply Ea | reflexivity].
  - apply (uniqueness_limite (fun x => a O t (y0 O t) (v0 O t) x) 0); [|apply Cm, P0]; eapply D_ext;
      [apply Cm, P1 | intros x; apply Ea | reflexivity].
Qed.
Lemma along_facts t : continuity_pt k t /\ continuity_pt c t /\ continuity_pt l t /\ k (t + T O) = k t /\
  c (t + T O) = c t /\ l (t + T O) = l t.
Proof. destruct (along_continuous_all t) as (A & B & C); exact (conj A (conj B (conj C (along_periodic t)))). Qed.
Lemma period : 0 < T O /\ (forall t y v mu, a O (t + T O) y v mu = a O t y v mu) /\ (forall t mu v,
  rebound O mu (t + T O) v = rebound O mu t v) /\ forall t, y0 O (t + T O) = y0 O t /\ v0 O (t + T O) = v0 O t.
Proof.
  destruct (has_period O HO) as [HT H]; split; [exact HT | split; [|split]].
  - intros t y v mu; apply (H t).
  - intros t mu v; apply (H t); exact 0.
  - intros t; destruct (H t) as (A & B & _); auto.
Qed.
(** [strictly], in the tube near the time t. *)
Lemma strictly_near t eps : 0 < eps -> exists d, 0 < d /\ d <= 1 /\ forall t1 y1 v1 m1 t2 y2 v2 m2,
  Rabs (t1 - t) <= d -> Rabs (t2 - t) <= d -> tube O d t1 y1 v1 -> tube O d t2 y2 v2 -> Rabs m1 <= d -> Rabs m2 <= d ->
  Rabs (y1 - y0 O t) <= 1 /\ Rabs (v1 - v0 O t) <= 1 /\ Rabs (a O t1 y1 v1 m1 - a O t2 y2 v2 m2 - (along O (a_t O) t *
  (t1 - t2) + k t * (y1 - y2) + c t * (v1 - v2) + l t * (m1 - m2))) <= eps * (Rabs (t1 - t2) + Rabs (y1 - y2) + Rabs (v1
  - v2) + Rabs (m1 - m2)).
Proof.
  intros He; destruct (force_C1 O HO) as (r & Hr & HC), (steady t (r / 2) ltac:(lra)) as (q & Hq & Lq & Nq).
  assert (Far : forall x y z e e', Rabs (x - y) <= e -> Rabs (y - z) <= e' -> Rabs (x - z) <= e + e').
  { intros x y z e e' A B; replace (x - z) with ((x - y) + (y - z)) by ring; eapply Rle_trans;
      [apply Rabs_triang | lra]. }
  destruct (strictly _ _ _ _ _ _ t (y0 O t) (v0 O t) 0 q HC Hq) with (eps := eps) as (d & Hd & H); [|exact He|].
  { intros t' y v m Ht Hy Hv Hm; destruct (Nq t' Ht) as [N1 N2]; rewrite Rminus_0_r in Hm;
      rewrite Rabs_minus_sym in N1, N2. split; [split|]; [| |lra]; (eapply Rle_trans; [eapply Far; eassumption | lra]).
    }
  destruct (two_least d 1 Hd ltac:(lra)) as (d1 & D1 & L1 & L2), (steady t (d1 / 2) ltac:(lra)) as (e & He' & Le & Ne).
  exists e; split; [exact He' | split; [lra|]]; intros t1 y1 v1 m1 t2 y2 v2 m2 T1 T2 [Y1 V1] [Y2 V2] M1 M2.
  destruct (Ne t1 T1) as [N1 N2], (Ne t2 T2) as [N3 N4]. pose proof (Far _ _ _ _ _ Y1 N1);
    pose proof (Far _ _ _ _ _ V1 N2); pose proof (Far _ _ _ _ _ Y2 N3); pose proof (Far _ _ _ _ _ V2 N4). split;
    [lra | split; [lra|]]; unfold k, c, l, along; apply H; rewrite ?Rminus_0_r; lra.
Qed.

Lemma derivatives eps : 0 < eps -> exists d, 0 < d /\ forall t, 0 <= t <= T O -> forall y v mu y' v' mu',
  tube O d t y v -> tube O d t y' v' -> Rabs mu <= d -> Rabs mu' <= d -> Rabs (a O t y v mu - a O t y' v' mu' - (k t *
  (y - y') + c t * (v - v') + l t * (mu - mu'))) <= eps * (Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu')).
Proof.
  intros He;
    apply (everywhere (fun t d => forall y v mu y' v' mu', tube O d t y v -> tube O d t y' v' -> Rabs mu <= d ->
      Rabs mu' <= d -> Rabs (a O t y v mu - a O t y' v' mu' - (k t * (y - y') + c t * (v - v') + l t * (mu - mu'))) <=
      eps * (Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu')))).
  - pose proof (proj1 (has_period O HO)); lra.
  - intros s d d' H Hd y v mu y' v' mu' [A B] [A' B'] M M'; apply H; try split; lra.
  - intros t;
      destruct (strictly_near t (eps / 2) ltac:(lra)) as (d & Hd & _ & H), (along_continuous_all t) as (C1 & C2 & C3).
    destruct (continuous_near _ t (eps / 2) C1 ltac:(lra)) as (e1 & E1 & N1),
      (continuous_near _ t (eps / 2) C2 ltac:(lra)) as (e2 & E2 & N2), (continuous_near _ t (eps / 2) C3 ltac:(lra))
      as (e3 & E3 & N3).
    destruct (two_least e1 e2 E1 E2) as (e4 & E4 & L1 & L2), (two_least e4 e3 E4 E3) as (e5 & E5 & L3 & L4),
      (two_least e5 d E5 Hd) as (q & Hq & L5 & L6); exists q; split; [exact Hq|].
    intros s Hs y v mu y' v' mu' [A B] [A' B'] M M'; destruct (H s y v mu s y' v' mu') as (_ & _ & Q); try split;
      try lra. pose proof (product _ _ _ _ (N1 s ltac:(lra)) (Rle_refl (Rabs (y - y')))) as P1;
      pose proof (product _ _ _ _ (N2 s ltac:(lra)) (Rle_refl (Rabs (v - v')))) as P2.
    pose proof (product _ _ _ _ (N3 s ltac:(lra)) (Rle_refl (Rabs (mu - mu')))) as P3;
      rewrite Rminus_eq_0, Rabs_R0 in Q. apply le_abs in Q, P1, P2, P3; apply Rabs_le; lra.
Qed.

Lemma Lipschitz : exists L r, 0 < r /\ forall t y v mu t' y' v' mu', tube O r t y v -> tube O r t' y' v' -> Rabs mu <=
  r -> Rabs mu' <= r ->
  Rabs (a O t y v mu - a O t' y' v' mu') <= L * (Rabs (t - t') + Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu')).
Proof.
  set (P s d := forall t y v mu t' y' v' mu', Rabs (t - s) <= d -> Rabs (t' - s) <= d -> tube O d t y v ->
    tube O d t' y' v' -> Rabs mu <= d -> Rabs mu' <= d -> Rabs (a O t y v mu) <= / d /\
    Rabs (a O t y v mu - a O t' y' v' mu') <= / d * (Rabs (t - t') + Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu'))).
  assert (Pos : forall x y z w : R, 0 <= Rabs x + Rabs y + Rabs z + Rabs w)
    by (intros; repeat apply Rplus_le_le_0_compat; apply Rabs_pos). destruct (has_period O HO) as [HT HP];
    destruct (everywhere P (T O)) as (d & Hd & H).
  - lra.
  - intros s d d' H Hd t y v mu t' y' v' mu' H1 H2 [A B] [A' B'] M M';
      assert (I : / d <= / d') by (apply Rinv_le_contravar; lra). destruct (H t y v mu t' y' v' mu') as [Q Q'];
      try split; try lra. eapply Rle_trans; [exact Q'|]; apply Rmult_le_compat_r; [apply Pos | exact I].
  - intros t; destruct (strictly_near t 1 ltac:(lra)) as (d & Hd & Hd1 & H); set (p := a O t (y0 O t) (v0 O t) 0).
    set (L := 1 + Rabs (along O (a_t O) t) + Rabs (k t) + Rabs (c t) + Rabs (l t)).
    assert (HL : 1 <= L) by (unfold L; pose proof (Pos (along O (a_t O) t) (k t) (c t) (l t)); lra).
    assert (Lip : forall t1 y1 v1 m1 t2 y2 v2 m2, Rabs (t1 - t) <= d -> Rabs (t2 - t) <= d -> tube O d t1 y1 v1 ->
      tube O d t2 y2 v2 -> Rabs m1 <= d -> Rabs m2 <= d -> Rabs (a O t1 y1 v1 m1 - a O t2 y2 v2 m2) <=
      L * (Rabs (t1 - t2) + Rabs (y1 - y2) + Rabs (v1 - v2) + Rabs (m1 - m2))).
    { intros t1 y1 v1 m1 t2 y2 v2 m2 X1 X2 X3 X4 X5 X6; destruct (H _ _ _ _ _ _ _ _ X1 X2 X3 X4 X5 X6) as (_ & _ & Q).
      set (S := Rabs (t1 - t2) + Rabs (y1 - y2) + Rabs (v1 - v2) + Rabs (m1 - m2)) in *.
      assert (B : forall u w : R, Rabs w <= S -> Rabs (u * w) <= Rabs u * S) by (intros u w Hw; apply product;
        [lra | exact Hw]). pose proof (Rabs_pos (t1 - t2)); pose proof (Rabs_pos (y1 - y2));
        pose proof (Rabs_pos (v1 - v2)); pose proof (Rabs_pos (m1 - m2)).
      pose proof (B (along O (a_t O) t) (t1 - t2) ltac:(unfold S; lra)) as B1;
        pose proof (B (k t) (y1 - y2) ltac:(unfold S; lra)) as B2.
      pose proof (B (c t) (v1 - v2) ltac:(unfold S; lra)) as B3;
        pose proof (B (l t) (m1 - m2) ltac:(unfold S; lra)) as B4. apply le_abs in Q, B1, B2, B3, B4; apply Rabs_le;
        unfold L; lra. }
    set (K := L * 4 + Rabs p); assert (HK : 4 <= K) by (unfold K; pose proof (Rabs_pos p); lra).
    destruct (two_least (d / 2) (/ K) ltac:(lra) ltac:(apply Rinv_0_lt_compat; lra)) as (q & Hq & L1 & L2); exists q;
      split; [exact Hq|]. assert (Kq : K <= / q) by (rewrite <- (Rinv_inv K); apply Rinv_le_contravar; assumption).
    assert (Sh : forall u s, Rabs (s - t) <= q -> Rabs (u - s) <= q -> Rabs (u - t) <= d).
    { intros u s A B; replace (u - t) with ((u - s) + (s - t)) by ring; eapply Rle_trans; [apply Rabs_triang | lra]. }
    intros s Hs t1 y1 v1 m1 t2 y2 v2 m2 X1 X2 [X3 X4] [X5 X6] X7 X8; pose proof (Sh t1 s Hs X1) as S1;
      pose proof (Sh t2 s Hs X2) as S2. assert (T1 : tube O d t1 y1 v1) by (split; lra);
      assert (T2 : tube O d t2 y2 v2) by (split; lra); split.
    + assert (Tz : tube O d t (y0 O t) (v0 O t)) by (split; rewrite Rminus_eq_0, Rabs_R0; lra);
        assert (Z : Rabs (t - t) <= d) by (rewrite Rminus_eq_0, Rabs_R0; lra).
      assert (Z0 : Rabs 0 <= d) by (rewrite Rabs_R0; lra); assert (M1 : Rabs m1 <= d) by lra.
      pose proof (Lip t1 y1 v1 m1 t (y0 O t) (v0 O t) 0 S1 Z T1 Tz M1 Z0) as Q; fold p in Q;
        destruct (H t1 y1 v1 m1 t (y0 O t) (v0 O t) 0 S1 Z T1 Tz M1 Z0) as (Q1 & Q2 & _). rewrite Rminus_0_r in Q;
        replace (a O t1 y1 v1 m1) with ((a O t1 y1 v1 m1 - p) + p) by ring; eapply Rle_trans; [apply Rabs_triang|].
      assert (L * (Rabs (t1 - t) + Rabs (y1 - y0 O t) + Rabs (v1 - v0 O t) + Rabs m1) <= L * 4)
        by (apply Rmult_le_compat_l; lra); unfold K in *; lra.
    + eapply Rle_trans; [apply Lip; trivial; lra|]; apply Rmult_le_compat_r; [apply Pos|]; unfold K in *;
        pose proof (Rabs_pos p); lra.
  - assert (Per : forall z t, y0 O (t + T O * IZR z) = y0 O t /\ v0 O (t + T O * IZR z) = v0 O t /\ forall y v mu,
      a O (t + T O * IZR z) y v mu = a O t y v mu).
    { intros z t; split; [|split; [|intros y v mu]];
        [apply (whole (y0 O)) | apply (whole (v0 O)) | apply (whole (fun t => a O t y v mu))]; intros s; apply HP.
      }
    assert (All : forall s, P s d).
    { intros s; destruct (in_one_period (T O) s HT) as (z & Hz); specialize (H _ Hz);
        intros t y v mu t' y' v' mu' A B C C' M M'.
      destruct (Per z (t - T O * IZR z)) as (Y1 & V1 & A1), (Per z (t' - T O * IZR z)) as (Y2 & V2 & A2).
      replace (t - T O * IZR z + T O * IZR z) with t in * by ring;
        replace (t' - T O * IZR z + T O * IZR z) with t' in * by ring. unfold tube in C, C'; rewrite Y1, V1 in C;
        rewrite Y2, V2 in C'; rewrite A1, A2; replace (t - t') with (t - T O * IZR z - (t' - T O * IZR z)) by ring.
      apply H; trivial;
        match goal with |- Rabs ?e <= _ => first [replace e with (t - s) by ring; exact A | replace e with (t' - s)
          by ring; exact B] end. }
    pose proof (Rinv_0_lt_compat d Hd) as I; exists (/ d + 2 * / d * / d), d; split; [exact Hd|];
      intros t y v mu t' y' v' mu' X X' M M'.
    set (S := Rabs (t - t') + Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu')); assert (S0 : 0 <= S) by apply Pos.
    assert (Z : forall u, Rabs (u - u) <= d) by (intros u; rewrite Rminus_eq_0, Rabs_R0; lra).
    assert (I2 : 0 <= 2 * / d * / d * S) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | exact S0]);
      destruct (Rle_dec (Rabs (t' - t)) d) as [N|N].
    + destruct (All t t y v mu t' y' v' mu' (Z t) N X X' M M') as [_ Q]; fold S in Q; lra.
    + destruct (All t t y v mu t y v mu (Z t) (Z t) X X M M)
        as [Q _], (All t' t' y' v' mu' t' y' v' mu' (Z t') (Z t') X' X' M' M') as [Q' _]. eapply Rle_trans;
        [apply apart|]; assert (d <= S).
      { rewrite Rabs_minus_sym in N; unfold S; pose proof (Rabs_pos (y - y')); pose proof (Rabs_pos (v - v'));
          pose proof (Rabs_pos (mu - mu')); lra. }
      assert (/ d * d = 1) by (apply Rinv_l; lra); assert (/ d * d <= / d * S) by (apply Rmult_le_compat_l; lra).
      assert (2 * / d * 1 <= 2 * / d * (/ d * S)) by (apply Rmult_le_compat_l; lra);
        assert (0 <= / d * S) by (apply Rmult_le_pos; lra); lra.
Qed.

Lemma impact : 0 <= tau O /\ (forall mu t, rebound O mu t 0 = 0) /\ (forall mu t v, v < 0 -> 0 <= rebound O mu t v) /\
  forall eps, 0 < eps -> exists d, 0 < d /\ forall mu t v mu' t' v', Rabs mu <= d -> Rabs (t - tG O) <= d ->
  Rabs v <= d -> Rabs mu' <= d -> Rabs (t' - tG O) <= d -> Rabs v' <= d -> Rabs (rebound O mu t v - rebound O mu' t' v'
  + tau O * (v - v')) <= eps * (Rabs (mu - mu') + Rabs (t - t') + Rabs (v - v')).
Proof.
  destruct (law O HO) as (Ht & R0 & Rp); split; [exact Ht | split; [exact R0 | split; [exact Rp|]]].
  destruct (law_C1 O HO) as (r & f1 & f2 & f3 & f4 & Hr & E3 & HC); exact (law_strict (rebound O) (tau O) (tG O) f1 f2
    f3 f4 r R0 Hr E3 HC).
Qed.
End Orbit.
