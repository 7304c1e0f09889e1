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
  exists d; split; [exact Hd|]; intros mu t v mu' t' v' A1 A2 A3 A4 A5 A6; assert (Z : Rabs (0 - 0) <= d) by (rewrite
    Rminus_0_r, Rabs_R0; lra). specialize (H t 0 v mu t' 0 v' mu'); rewrite !Rminus_0_r, Rabs_R0, E1, E3, E4 in H.
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
  intros HT; destruct (archimed (t / T)) as [A1 A2]; exists (up (t / T) - 1)%Z; rewrite minus_IZR; set (u := IZR (up (t
    / T))) in *. assert (Et : t = T * (t / T)) by (field; lra); set (q := t / T) in *; rewrite Et; split; nra.
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
  intros He; destruct (orbit_continuous t) as [A B], (continuous_near _ t e A He) as (d1 & D1 & N1), (continuous_near _
    t e B He) as (d2 & D2 & N2).
  destruct (two_least d1 d2 D1 D2) as (d3 & D3 & L1 & L2), (two_least d3 e D3 He) as (d & Hd & L3 & L4); exists d;
    split; [exact Hd | split; [exact L4|]]. intros s Hs; split; [apply N1 | apply N2]; lra.
Qed.
Lemma along_continuous r f t : 0 < r -> continuous (fun t y v mu => tube O r t y v /\ Rabs mu <= r) f ->
  continuity_pt (along O f) t.
Proof.
  intros Hr C e He; destruct (C t (y0 O t) (v0 O t) 0) with (eps := e / 2) as (d & Hd & H); [|lra|].
  { unfold tube; rewrite !Rminus_eq_0, Rabs_R0; lra. }
  destruct (steady t d Hd) as (q & Hq & L & N); exists q; split; [exact Hq|]; intros s [_ Hs]; cbn in *; unfold R_dist
    in *. destruct (N s ltac:(lra)) as [N1 N2]; unfold along; specialize (H s (y0 O s) (v0 O s) 0 ltac:(lra) N1 N2).
    rewrite Rminus_eq_0, Rabs_R0 in H; specialize (H ltac:(lra)); lra.
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



End Orbit.
