(** * Functions of four variables that are continuous, and C1: sums, products, and in moving coordinates *)
From Coq Require Import Reals Lra Lia FunctionalExtensionality.
From Grazing Require Import Derivatives StatementNonlinear NonlinearSmooth.
Open Scope R_scope.

(** ** Sums and products of continuous functions of four variables *)
Section Continuous.
Variable D : R -> R -> R -> R -> Prop.
Notation C := (continuous D).
Lemma C_const x : C (fun _ _ _ _ => x).
Proof. intros t y v m _ e He; exists 1; split; [lra|]; intros; rewrite Rminus_eq_0, Rabs_R0; lra. Qed.
Lemma C_t f : (forall t, continuity_pt f t) -> C (fun t _ _ _ => f t).
Proof. intros H t y v m _ e He; destruct (continuous_near f t e (H t) He) as (d & Hd & N); exists d; split; [exact Hd|];
  intros; apply N; assumption. Qed.
Lemma C_v f : (forall t, continuity_pt f t) -> C (fun _ _ v _ => f v).
Proof. intros H t y v m _ e He; destruct (continuous_near f v e (H v) He) as (d & Hd & N); exists d; split; [exact Hd|];
  intros; apply N; assumption. Qed.
Lemma C_f f : (forall t, continuity_pt f t) -> C (fun _ y _ _ => f y).
Proof.
  intros H t y v m _ e He; destruct (continuous_near f y e (H y) He) as (d & Hd & N); exists d; split; [exact Hd|];
    intros; apply N; assumption.
Qed.
Lemma C_y : C (fun _ y _ _ => y). Proof. intros t y v m _ e He; exists e; auto. Qed.
Lemma C_plus f g : C f -> C g -> C (fun t y v m => f t y v m + g t y v m).
Proof.
  intros F G t y v m HD e He;
    destruct (F t y v m HD (e / 2) ltac:(lra)) as (d1 & D1 & N1), (G t y v m HD (e / 2) ltac:(lra)) as (d2 & D2 & N2).
  destruct (two_least d1 d2 D1 D2) as (d & Hd & L1 & L2); exists d; split; [exact Hd|]; intros t' y' v' m' A1 A2 A3 A4.
  specialize (N1 t' y' v' m' ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra));
    specialize (N2 t' y' v' m' ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). apply le_abs in N1, N2; apply Rabs_le; lra.
Qed.
Lemma C_times f g : C f -> C g -> C (fun t y v m => f t y v m * g t y v m).
Proof.
  intros F G t y v m HD e He; set (a := f t y v m); set (b := g t y v m); pose proof (Rabs_pos a);
    pose proof (Rabs_pos b).
  destruct (two_least 1 (e / (Rabs a + Rabs b + 1)) ltac:(lra) ltac:(apply Rdiv_lt_0_compat; lra))
    as (q & Hq & Q1 & Q2). destruct (F t y v m HD q Hq) as (d1 & D1 & N1), (G t y v m HD q Hq) as (d2 & D2 & N2).
  destruct (two_least d1 d2 D1 D2) as (d & Hd & L1 & L2); exists d; split; [exact Hd|]; intros t' y' v' m' A1 A2 A3 A4.
  specialize (N1 t' y' v' m' ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra));
    specialize (N2 t' y' v' m' ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). fold a in N1 |- *; fold b in N2 |- *;
    set (a' := f t' y' v' m') in *; set (b' := g t' y' v' m') in *.
  replace (a' * b' - a * b) with (a * (b' - b) + (b * (a' - a) + (a' - a) * (b' - b))) by ring.
  pose proof (product a (b' - b) _ _ (Rle_refl _) N2) as P1; pose proof (product b (a' - a) _ _ (Rle_refl _) N1) as P2.
  pose proof (product (a' - a) (b' - b) _ _ N1 N2) as P3; assert (q * q <= 1 * q) by (apply Rmult_le_compat_r; lra).
  assert ((Rabs a + Rabs b + 1) * q <= e).
  { apply Rle_trans with ((Rabs a + Rabs b + 1) * (e / (Rabs a + Rabs b + 1)));
      [apply Rmult_le_compat_l; lra | right; field; lra]. }
  apply le_abs in P1, P2, P3; apply Rabs_le; lra.
Qed.
End Continuous.
Lemma C_minus D f g : continuous D f -> continuous D g -> continuous D (fun t y v m => f t y v m - g t y v m).
Proof.
  intros F G; pose proof (C_plus D _ _ F (C_times D _ _ (C_const D (-1)) G)) as H; intros t y v m HD e He;
    destruct (H t y v m HD e He) as (d & Hd & N). exists d; split; [exact Hd|]; intros t' y' v' m' A1 A2 A3 A4;
    specialize (N t' y' v' m' A1 A2 A3 A4);
    match goal with |- Rabs ?u <= _ => match type of N with Rabs ?w <= _ => replace u with w by ring end end; exact N.
Qed.

(** ** The chain rule *)
Lemma D_step f x l e : derivable_pt_lim f x l -> 0 < e -> exists d, 0 < d /\ forall h, h <> 0 -> Rabs h < d ->
  Rabs (f (x + h) - f x - l * h) <= e * Rabs h.
Proof.
  intros H He; destruct (H e He) as (d & Hd); exists d; split; [apply cond_pos|]; intros h H0 Hh; specialize (Hd h H0
    Hh).
  replace (f (x + h) - f x - l * h) with (((f (x + h) - f x) / h - l) * h) by (field; exact H0).
  rewrite Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos | lra].
Qed.
Lemma D_four D f f1 f2 f3 f4 q t y v m pt py pv pm x : C1 D f f1 f2 f3 f4 -> 0 < q -> (forall t' y' v' m',
  Rabs (t' - t x) <= q -> Rabs (y' - y x) <= q -> Rabs (v' - v x) <= q -> Rabs (m' - m x) <= q -> D t' y' v' m') ->
  derivable_pt_lim t x pt -> derivable_pt_lim y x py -> derivable_pt_lim v x pv -> derivable_pt_lim m x pm ->
  derivable_pt_lim (fun x => f (t x) (y x) (v x) (m x)) x (f1 (t x) (y x) (v x) (m x) * pt + f2 (t x) (y x) (v x) (m x)
    * py + f3 (t x) (y x) (v x) (m x) * pv + f4 (t x) (y x) (v x) (m x) * pm).
Proof.
  intros HC Hq HD Ht Hy Hv Hm eps He; set (F i := match i with 0 => f1 | 1 => f2 | 2 => f3 | _ => f4 end (t x) (y x) (v
    x) (m x)). set (S := Rabs pt + Rabs py + Rabs pv + Rabs pm + 4).
  set (B := Rabs (F 0%nat) + Rabs (F 1%nat) + Rabs (F 2%nat) + Rabs (F 3%nat) + 1).
  pose proof (fun i => Rabs_pos (F i)) as PF; pose proof (PF 0%nat); pose proof (PF 1%nat); pose proof (PF 2%nat);
    pose proof (PF 3%nat). pose proof (Rabs_pos pt); pose proof (Rabs_pos py); pose proof (Rabs_pos pv);
    pose proof (Rabs_pos pm). assert (HS : 4 <= S) by (unfold S; lra); assert (HB : 1 <= B) by (unfold B; lra).
  destruct (strictly D f f1 f2 f3 f4 (t x) (y x) (v x) (m x) q HC Hq HD (eps / (4 * S))) as (d & Hd & K);
    [apply Rdiv_lt_0_compat; lra|].
  destruct (two_least 1 (eps / (4 * B)) ltac:(lra) ltac:(apply Rdiv_lt_0_compat; lra)) as (e & E0 & E1 & E2).
  destruct (D_step t x pt e Ht E0) as (d1 & D1 & K1), (D_step y x py e Hy E0) as (d2 & D2 & K2), (D_step v x pv e Hv E0)
    as (d3 & D3 & K3), (D_step m x pm e Hm E0) as (d4 & D4 & K4).
  destruct (two_least d1 d2 D1 D2) as (c1 & C1' & L1 & L2), (two_least d3 d4 D3 D4) as (c2 & C2' & L3 & L4),
    (two_least c1 c2 C1' C2') as (c3 & C3' & L5 & L6), (two_least c3 (d / S) C3' ltac:(apply Rdiv_lt_0_compat; lra))
    as (c & Hc & L7 & L8). exists (mkposreal c Hc); intros h Nz Hh; cbn in Hh; pose proof (Rabs_pos_lt h Nz) as Ph.
  specialize (K1 h Nz ltac:(lra)); specialize (K2 h Nz ltac:(lra)); specialize (K3 h Nz ltac:(lra));
    specialize (K4 h Nz ltac:(lra)).
  assert (Sh : S * Rabs h <= d) by (apply Rle_trans with (S * (d / S)); [apply Rmult_le_compat_l; lra | right; field;
    lra]).
  assert (One : forall g p, Rabs (g - p * h) <= e * Rabs h -> Rabs g <= (Rabs p + 1) * Rabs h).
  { intros g p G; apply from in G; rewrite Rabs_mult in G; assert (e * Rabs h <= 1 * Rabs h)
      by (apply Rmult_le_compat_r; lra); lra. }
  pose proof (One _ _ K1) as G1; pose proof (One _ _ K2) as G2; pose proof (One _ _ K3) as G3; pose proof (One _ _ K4)
    as G4.
  assert (Le : forall p, Rabs p + 1 <= S -> (Rabs p + 1) * Rabs h <= d) by (intros p Hp; apply Rle_trans with (2 := Sh),
    Rmult_le_compat_r; lra).
  pose proof (Le pt ltac:(unfold S; lra)); pose proof (Le py ltac:(unfold S; lra)); pose proof (Le pv ltac:(unfold S;
    lra)); pose proof (Le pm ltac:(unfold S; lra)).
  specialize (K (t (x + h)) (y (x + h)) (v (x + h)) (m (x + h)) (t x) (y x) (v x) (m x)); rewrite !Rminus_eq_0, Rabs_R0
    in K.
  specialize (K ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
  change (f1 (t x) (y x) (v x) (m x)) with (F 0%nat) in *; change (f2 (t x) (y x) (v x) (m x)) with (F 1%nat) in *;
    change (f3 (t x) (y x) (v x) (m x)) with (F 2%nat) in *; change (f4 (t x) (y x) (v x) (m x)) with (F 3%nat) in *.
  set (ft := t (x + h) - t x) in *; set (fy := y (x + h) - y x) in *; set (fv := v (x + h) - v x) in *;
    set (fm := m (x + h) - m x) in *.
  apply Rmult_lt_reg_r with (Rabs h); [exact Ph|]; rewrite <- Rabs_mult.
  pose proof (product (F 0%nat) _ _ _ (Rle_refl _) K1) as P1; pose proof (product (F 1%nat) _ _ _ (Rle_refl _) K2) as
    P2; pose proof (product (F 2%nat) _ _ _ (Rle_refl _) K3) as P3; pose proof (product (F 3%nat) _ _ _ (Rle_refl _) K4)
      as P4.
  assert (Q1 : eps / (4 * S) * (Rabs ft + Rabs fy + Rabs fv + Rabs fm) <= eps / 4 * Rabs h).
  { apply Rle_trans with (eps / (4 * S) * (S * Rabs h)); [apply Rmult_le_compat_l;
      [left; apply Rdiv_lt_0_compat; lra | unfold S; lra] | right; field; lra]. }
  assert (Q2 : B * (e * Rabs h) <= eps / 4 * Rabs h).
  { rewrite <- Rmult_assoc; apply Rmult_le_compat_r; [lra|]; apply Rle_trans with (B * (eps / (4 * B)));
      [apply Rmult_le_compat_l; lra | right; field; lra]. }
  assert (Pe : 0 < e * Rabs h) by (apply Rmult_lt_0_compat; lra); assert (Pq : 0 < eps * Rabs h) by (apply
    Rmult_lt_0_compat; lra). unfold B in Q2; apply le_abs in K, P1, P2, P3, P4; apply Rabs_def1; match goal with |-
    context [(?u / h - ?w) * h] => replace ((u / h - w) * h) with (u - w * h) by (field; exact Nz) end; lra.
Qed.
Lemma C1_continuous D f f1 f2 f3 f4 q t y v m : C1 D f f1 f2 f3 f4 -> 0 < q -> (forall t' y' v' m', Rabs (t' - t) <= q
  -> Rabs (y' - y) <= q -> Rabs (v' - v) <= q -> Rabs (m' - m) <= q -> D t' y' v' m') -> forall eps, 0 < eps -> exists
    d,
  0 < d /\ forall t' y' v' m', Rabs (t' - t) <= d -> Rabs (y' - y) <= d -> Rabs (v' - v) <= d -> Rabs (m' - m) <= d ->
  Rabs (f t' y' v' m' - f t y v m) <= eps.
Proof.
  intros HC Hq HD eps He; destruct (strictly _ _ _ _ _ _ t y v m q HC Hq HD 1 ltac:(lra)) as (d & Hd & K).
  set (S := 4 + Rabs (f1 t y v m) + Rabs (f2 t y v m) + Rabs (f3 t y v m) + Rabs (f4 t y v m)).
  pose proof (Rabs_pos (f1 t y v m)); pose proof (Rabs_pos (f2 t y v m)); pose proof (Rabs_pos (f3 t y v m));
    pose proof (Rabs_pos (f4 t y v m)); assert (HS : 4 <= S) by (unfold S; lra).
  destruct (two_least d (eps / S) Hd ltac:(apply Rdiv_lt_0_compat; lra)) as (e & E0 & E1 & E2); exists e; split;
    [exact E0|]; intros t' y' v' m' A1 A2 A3 A4.
  specialize (K t' y' v' m' t y v m); rewrite !Rminus_eq_0, Rabs_R0 in K;
    specialize (K ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
  pose proof (product (f1 t y v m) _ _ _ (Rle_refl _) A1) as P1; pose proof (product (f2 t y v m) _ _ _ (Rle_refl _) A2)
    as P2; pose proof (product (f3 t y v m) _ _ _ (Rle_refl _) A3) as P3;
    pose proof (product (f4 t y v m) _ _ _ (Rle_refl _) A4) as P4.
  assert (S * e <= eps) by (apply Rle_trans with (S * (eps / S)); [apply Rmult_le_compat_l; lra | right; field; lra]).
  unfold S in *; apply le_abs in K, P1, P2, P3, P4; apply Rabs_le; lra.
Qed.

(** In coordinates that move as G, H of t and mu, on a scale s. *)
Section Moved.
Variables (D D' : R -> R -> R -> R -> Prop) (r s : R) (f f1 f2 f3 f4 : R -> R -> R -> R -> R) (G G1 Gm H H1 Hm : R -> R
  -> R).
Hypothesis Cf : C1 D f f1 f2 f3 f4.
Hypothesis CG : C1 (fun _ _ _ m => Rabs m <= r) (fun t _ _ m => G t m) (fun t _ _ m => G1 t m) (fun _ _ _ _ => 0)
  (fun _ _ _ _ => 0) (fun t _ _ m => Gm t m).
Hypothesis CH : C1 (fun _ _ _ m => Rabs m <= r) (fun t _ _ m => H t m) (fun t _ _ m => H1 t m) (fun _ _ _ _ => 0)
  (fun _ _ _ _ => 0) (fun t _ _ m => Hm t m).
Hypothesis In : forall t y v m, D' t y v m -> Rabs m < r /\ exists q, 0 < q /\ forall t' y' v' m', Rabs (t' - t) <= q ->
  Rabs (y' - (G t m + s * y)) <= q -> Rabs (v' - (H t m + s * v)) <= q -> Rabs (m' - m) <= q -> D t' y' v' m'.
Definition seen (f : R -> R -> R -> R -> R) t y v m := f t (G t m + s * y) (H t m + s * v) m.
Lemma room m : Rabs m < r -> exists q, 0 < q /\ forall m', Rabs (m' - m) <= q -> Rabs m' <= r.
Proof. intros L; exists (r - Rabs m); split; [lra|]; intros m' A; apply from in A; lra. Qed.
Lemma shift_continuous F F1 Fm : C1 (fun _ _ _ m => Rabs m <= r) (fun t _ _ m => F t m) (fun t _ _ m => F1 t m)
  (fun _ _ _ _ => 0) (fun _ _ _ _ => 0) (fun t _ _ m => Fm t m) -> continuous D' (fun t _ _ m => F t m).
Proof.
  intros C t y v m HD e He; destruct (In t y v m HD) as [L _], (room m L) as (q & Hq & Rq);
    destruct (C1_continuous _ _ _ _ _ _ q t 0 0 m C Hq (fun _ _ _ m' _ _ _ A => Rq m' A) e He) as (d & Hd & K).
  exists d; split; [exact Hd|]; intros t' y' v' m' A1 _ _ A4; apply (K t' 0 0 m'); rewrite ?Rminus_0_r, ?Rabs_R0; lra.
Qed.
Lemma C_seen g : continuous D g -> continuous D' (seen g).
Proof.
  intros Cg t y v m HD e He; destruct (In t y v m HD) as (L & q & Hq & Box).
  destruct (Cg t (G t m + s * y) (H t m + s * v) m) with (eps := e) as (d & Hd & K); [apply Box; rewrite Rminus_eq_0,
    Rabs_R0; lra | exact He|].
  assert (Cy : continuous D' (fun t y v m => G t m + s * y)) by (apply (C_plus D' (fun t _ _ m => G t m) (fun _ y _ _ =>
    s * y)); [apply (shift_continuous _ _ _ CG) | apply (C_times D' (fun _ _ _ _ => s)); [apply C_const | apply C_y]]).
  assert (Cv : continuous D' (fun t y v m => H t m + s * v)) by (apply (C_plus D' (fun t _ _ m => H t m) (fun _ _ v _ =>
    s * v)); [apply (shift_continuous _ _ _ CH) | apply (C_times D' (fun _ _ _ _ => s)); [apply C_const | apply (C_v D'
    (fun v => v)); intros x; apply (D_continuous _ _ _ (D_id x))]]).
  destruct (Cy t y v m HD d Hd) as (d1 & D1 & K1), (Cv t y v m HD d Hd) as (d2 & D2 & K2).
  destruct (two_least d1 d2 D1 D2) as (d3 & D3 & L1 & L2), (two_least d3 d D3 Hd) as (d4 & D4 & L3 & L4); exists d4;
    split; [exact D4|]; intros t' y' v' m' A1 A2 A3 A4.
  apply K; [lra | apply (K1 t' y' v' m'); lra | apply (K2 t' y' v' m'); lra | lra].
Qed.
Lemma C1_seen : C1 D' (seen f) (fun t y v m => seen f1 t y v m + seen f2 t y v m * G1 t m + seen f3 t y v m * H1 t m)
  (fun t y v m => seen f2 t y v m * s) (fun t y v m => seen f3 t y v m * s)
  (fun t y v m => seen f4 t y v m + seen f2 t y v m * Gm t m + seen f3 t y v m * Hm t m).
Proof.
  pose proof Cf as [_ _ _ _ (K1 & K2 & K3 & K4)]; pose proof CG as [Gt _ _ Gmu (C1' & _ & _ & C2')]; pose proof CH as
    [Ht _ _ Hmu (C3' & _ & _ & C4')]. constructor; try (intros t y v m HD; destruct (In t y v m HD) as (L & q & Hq &
    Box)).
  - eapply D_value; [apply (D_four D f f1 f2 f3 f4 q (fun t => t) (fun t => G t m + s * y) (fun t => H t m + s * v) (fun
      _ => m) 1 (G1 t m + 0) (H1 t m + 0) 0); trivial; [apply D_id | apply D_plus; [apply (Gt t 0 0 m); lra | apply
      D_const] | apply D_plus; [apply (Ht t 0 0 m); lra | apply D_const] | apply D_const] | unfold seen; ring].
  - eapply D_value; [apply (D_four D f f1 f2 f3 f4 q (fun _ => t) (fun y => G t m + s * y) (fun _ => H t m + s * v) (fun
      _ => m) 0 (0 + s * 1) 0 0); trivial; [apply D_const | apply D_plus; [apply D_const | apply D_scale, D_id] | apply
      D_const | apply D_const] | unfold seen; ring].
  - eapply D_value; [apply (D_four D f f1 f2 f3 f4 q (fun _ => t) (fun _ => G t m + s * y) (fun v => H t m + s * v) (fun
      _ => m) 0 0 (0 + s * 1) 0); trivial; [apply D_const | apply D_const | apply D_plus; [apply D_const | apply
      D_scale, D_id] | apply D_const] | unfold seen; ring].
  - eapply D_value; [apply (D_four D f f1 f2 f3 f4 q (fun _ => t) (fun m => G t m + s * y) (fun m => H t m + s * v) (fun
      m => m) 0 (Gm t m + 0) (Hm t m + 0) 1); trivial; [apply D_const | apply D_plus; [apply (Gmu t 0 0 m); lra | apply
      D_const] | apply D_plus; [apply (Hmu t 0 0 m); lra | apply D_const] | apply D_id] | unfold seen; ring].
  - assert (Sub : forall g, continuous (fun _ _ _ m => Rabs m <= r) g -> continuous D' g) by (intros g C t y v m HD;
      apply C; destruct (In t y v m HD); lra). repeat split; repeat first [apply C_plus | apply C_times]; try (apply
      C_seen; assumption); try apply C_const; apply Sub; assumption.
Qed.
End Moved.
Lemma C1_less D D' s f f1 f2 f3 f4 g g1 g2 g3 g4 : C1 D f f1 f2 f3 f4 -> C1 D' g g1 g2 g3 g4 -> (forall t y v m, D t y v
  m -> D' t y v m) -> C1 D (fun t y v m => s * (f t y v m - g t y v m)) (fun t y v m => s * (f1 t y v m - g1 t y v m))
    (fun t y v
  m => s * (f2 t y v m - g2 t y v m)) (fun t y v m => s * (f3 t y v m - g3 t y v m)) (fun t y v m => s * (f4 t y v m -
    g4 t y v
  m)).
Proof.
  intros [A1 A2 A3 A4 (K1 & K2 & K3 & K4)] [B1 B2 B3 B4 (L1 & L2 & L3 & L4)] Sub; constructor; try (intros t y v m HD;
    apply (D_scale (fun _ => _ - _)), D_minus; auto).
  assert (Sub' : forall h, continuous D' h -> continuous D h) by (intros h C t y v m HD; apply C, Sub, HD).
  repeat split; apply (C_times D (fun _ _ _ _ => s)); try apply C_const; apply C_minus; auto.
Qed.
