(** * The equation linearized along an orbit that grazes: its matrix, its periodic solution; and both are near those of
      a linear oscillator where the equation is *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs Derivatives Contraction StatementOscillator StatementNonlinear NonlinearGronwall
  NonlinearPicard NonlinearSmooth NonlinearTube.
Import Nonlinear.
Open Scope R_scope.

Definition forced_by (k c f z w : R -> R) : Prop := forall t, derivable_pt_lim z t (w t) /\
  derivable_pt_lim w t (k t * z t + c t * w t + f t).
Lemma combine k c f g z w z' w' p : forced_by k c f z w -> forced_by k c g z' w' ->
  forced_by k c (fun t => f t + p * g t) (fun t => z t + p * z' t) (fun t => w t + p * w' t).
Proof.
  intros H H' t; destruct (H t) as [A B], (H' t) as [A' B']; split; [apply D_plus; [exact A | apply D_scale, A']|].
  eapply D_value; [apply D_plus; [exact B | apply D_scale, B'] | ring].
Qed.
(** For a time T from s on. *)
Definition grow (L T : R) : R := 2 * (1 + L) * exp ((2 * L + 1) * T).
Lemma two_ways L T k c f m z w s : 1 <= L -> 0 <= m -> 0 <= T -> (forall t, Rabs (k t) <= L /\ Rabs (c t) <= L) ->
  forced_by k c f z w -> (forall t, s <= t <= s + T -> Rabs (f t) <= m) -> forall t, s <= t <= s + T ->
  Rabs (z t) + Rabs (w t) <= grow L T * (Rabs (z s) + Rabs (w s) + m) /\
  Rabs (z s) + Rabs (w s) <= grow L T * (Rabs (z t) + Rabs (w t) + m).
Proof.
  intros HL Hm HT Hkc H Hf t Ht; pose proof (bound L T (fun x => z (s + x)) (fun x => w (s + x)) (fun x => k (s + x) * z
    (s + x) + c (s + x) * w (s + x) + f (s + x)) m HL Hm) as G; cbv beta zeta in G; specialize (fun A => G A (t - s)
      ltac:(lra)).
  replace (s + (t - s)) with t in G by ring; rewrite Rplus_0_r in G; apply G; intros x Hx; destruct (H (s + x)) as [A
    B]; split; [apply D_on, A | split; [apply D_on, B|]].
  destruct (Hkc (s + x)) as [B1 B2]; pose proof (product _ _ _ _ B1 (Rle_refl (Rabs (z (s + x))))) as P1;
    pose proof (product _ _ _ _ B2 (Rle_refl (Rabs (w (s + x))))) as P2; specialize (Hf (s + x) ltac:(lra)).
  assert (1 * m <= L * m) by (apply Rmult_le_compat_r; assumption). apply le_abs in P1, P2, Hf; apply Rabs_le; lra.
Qed.
Lemma grow_large L T : 1 <= L -> 0 <= T -> 1 <= grow L T.
Proof.
  intros HL HT; assert (0 <= (2 * L + 1) * T) by (apply Rmult_le_pos; lra); pose proof (exp_ineq1_le ((2 * L + 1) * T)).
  unfold grow; replace 1 with (1 * 1) at 1 by ring; apply Rmult_le_compat; lra.
Qed.
Lemma alike L k c f z w z' w' s : 1 <= L -> (forall t, Rabs (k t) <= L /\ Rabs (c t) <= L) -> forced_by k c f z w ->
  forced_by k c f z' w' -> z s = z' s -> w s = w' s -> forall t, z t = z' t /\ w t = w' t.
Proof.
  intros HL Hkc H H' Ez Ew t; pose proof (combine _ _ _ _ _ _ _ _ (-1) H H') as D.
  assert (Zero : Rabs (z t + -1 * z' t) + Rabs (w t + -1 * w' t) <= 0).
  { assert (F0 : forall x, Rabs (f x + -1 * f x) <= 0) by (intros x; replace (f x + -1 * f x) with 0 by ring; rewrite
      Rabs_R0; lra). assert (Es : Rabs (z s + -1 * z' s) + Rabs (w s + -1 * w' s) + 0 = 0) by (rewrite Ez, Ew; replace
      (z' s + -1 * z' s) with 0 by ring; replace (w' s + -1 * w' s) with 0 by ring; rewrite Rabs_R0; ring). destruct
      (Rle_dec s t) as [O|O].
    - destruct (two_ways L (t - s) k c _ 0 _ _ s HL ltac:(lra) ltac:(lra) Hkc D (fun x _ => F0 x) t ltac:(lra)) as [B
      _]. rewrite Es, Rmult_0_r in B; exact B.
    - destruct (two_ways L (s - t) k c _ 0 _ _ t HL ltac:(lra) ltac:(lra) Hkc D (fun x _ => F0 x) s ltac:(lra)) as [_
      B]. rewrite Es, Rmult_0_r in B; exact B. }
  pose proof (Rabs_pos (z t + -1 * z' t)); pose proof (Rabs_pos (w t + -1 * w' t)); assert (z t + -1 * z' t = 0)
    by (apply Rabs_zero; lra); assert (w t + -1 * w' t = 0) by (apply Rabs_zero; lra); split; lra.
Qed.

(** ** The matrix from one touch to the next, and the periodic solution *)
Section Orbit.
Variables (O : Nonlinear.t) (L : R) (z1 w1 z2 w2 z3 w3 : R -> R).
Hypothesis HO : grazing_orbit O.
Hypothesis HL : 1 <= L.
Hypothesis Hkc : forall t, Rabs (along O (a_y O) t) <= L /\ Rabs (along O (a_v O) t) <= L.
Hypothesis H1 : linearized O 0 z1 w1 /\ z1 (tG O) = 1 /\ w1 (tG O) = 0.
Hypothesis H2 : linearized O 0 z2 w2 /\ z2 (tG O) = 0 /\ w2 (tG O) = 1.
Hypothesis H3 : linearized O 1 z3 w3 /\ z3 (tG O) = 0 /\ w3 (tG O) = 0.
Let t1 := tG O + T O.
Let a1 := z1 t1 + w2 t1.
Let a2 := z1 t1 * w2 t1 - w1 t1 * z2 t1.
Let rate := ((1 - w2 t1) * z3 t1 + z2 t1 * w3 t1) / (1 - a1 + a2).
Theorem generic_of : z2 t1 <> 0 -> 1 - a1 + a2 <> 0 -> rate <> 0 -> generic O a1 a2 (z2 t1) rate.
Proof.
  destruct H1 as (L1 & E1 & E1'), H2 as (L2 & E2 & E2'), H3 as (L3 & E3 & E3'); intros Hg HD Hr.
  assert (K : forall m z w, linearized O m z w <-> forced_by (along O (a_y O)) (along O (a_v O)) (fun t => along O (a_mu
    O) t * m) z w) by (intros m z w; split; intros H; exact H). constructor.
  - exists (z1 t1), (w1 t1), (w2 t1); split; [reflexivity | split; [unfold a2; ring|]]; intros z w Hz.
    assert (C : forced_by (along O (a_y O)) (along O (a_v O)) (fun t => along O (a_mu O) t * 0 + - z (tG O) * (along O
      (a_mu O) t * 0) + - w (tG O) * (along O (a_mu O) t * 0)) (fun t => z t + - z (tG O) * z1 t + - w (tG O) * z2 t)
      (fun t => w t + - z (tG O) * w1 t + - w (tG O) * w2 t)) by (apply (combine _ _ _ _ (fun t => z t + - z (tG O) * z1
      t) (fun t => w t + - z (tG O) * w1 t)); [apply combine|]; apply K; assumption).
    destruct (alike L _ _ _ _ _ (fun _ => 0) (fun _ => 0) (tG O) HL Hkc C) with (t := t1) as [A B].
    + intros t; split; (eapply D_value; [apply D_const | ring]).
    + rewrite E1, E2; ring.
    + rewrite E1', E2'; ring.
    + fold t1; split; lra.
  - exact Hg.
  - set (x0 := rate); set (x1 := (w1 t1 * z3 t1 + (1 - z1 t1) * w3 t1) / (1 - a1 + a2)).
    pose proof (combine _ _ _ _ _ _ _ _ x1 (combine _ _ _ _ _ _ _ _ x0 (proj1 (K _ _ _) L3) (proj1 (K _ _ _) L1)) (proj1
      (K _ _ _) L2)) as C. cbv beta in C; set (z := fun t => z3 t + x0 * z1 t + x1 * z2 t) in *; set (w := fun t => w3 t
      + x0 * w1 t + x1 * w2 t) in *.
    assert (Z : linearized O 1 z w) by (intros t; destruct (C t) as [A B]; split; [exact A | eapply D_value; [exact B |
      ring]]).
    exists z, w; split; [exact Z | split; [|unfold z, x0; rewrite E1, E2, E3; ring]].
    assert (Z' : linearized O 1 (fun t => z (t + T O)) (fun t => w (t + T O))).
    { intros t; destruct (Z (t + T O)) as [A B], (along_periodic O HO t) as (P1 & P2 & P3); unfold k, c, l in P1, P2,
        P3; rewrite P1, P2, P3 in B. split; apply (D_later z) || apply (D_later w); assumption. }
    apply (alike L _ _ _ (fun t => z (t + T O)) (fun t => w (t + T O)) z w (tG O) HL Hkc (proj1 (K _ _ _) Z') (proj1 (K
      _ _ _) Z)); fold t1; unfold z, w; rewrite ?E1, ?E2, ?E3, ?E1', ?E2', ?E3'; unfold x0, x1, rate, a1, a2 in *;
      field; assumption.
  - exact Hr.
Qed.
End Orbit.

(** ** Near a linear oscillator *)
Section Near.
Variables (c K A11 A21 A22 gamma eps : R).
Hypothesis HA : forall y v, free c K y v -> facing Plus 1 * y (turn Plus) = A11 * y 0 + gamma * v 0 /\
  facing Plus 1 * v (turn Plus) = A21 * y 0 + A22 * v 0.
Let a1 := A11 + A22.
Let a2 := A11 * A22 - gamma * A21.
Hypothesis Hg : gamma <> 0.
Hypothesis HK : K <> 0.
Hypothesis H1 : a1 <> a2 + 1.
Hypothesis He : 0 < eps.
Let L := 2 + Rabs K + Rabs c.
Let E := grow L (2 * PI).
Let D := Rabs (1 - a1 + a2).
Lemma bounds : 1 <= L /\ 1 <= E /\ 0 < D /\ 0 < Rabs K /\ 0 < Rabs gamma.
Proof.
  pose proof (Rabs_pos K); pose proof (Rabs_pos c); assert (HL : 1 <= L) by (unfold L; lra); pose proof PI_RGT_0.
  split; [exact HL | split; [apply grow_large; lra | split; [|split]]]; apply Rabs_pos_lt; [lra | exact HK | exact Hg].
Qed.
(** The free oscillator's two motions from the time s on, and the solution of an equation near. *)
Lemma close_by d k z w s : 0 <= d <= 1 -> (forall t, Rabs (k t + K) <= d) -> forced_by k (fun _ => - c) (fun _ => 0) z w
  -> (Rabs A11 <= E /\ Rabs A21 <= E /\ Rabs A22 <= E /\
  Rabs gamma <= E) /\ (Rabs (z s) + Rabs (w s) <= 1 -> Rabs (z (s + 2 * PI)) <= E /\ Rabs (w (s + 2 * PI)) <= E /\
  Rabs (z (s + 2 * PI) - (A11 * z s + gamma * w s)) <= E * E * d /\
  Rabs (w (s + 2 * PI) - (A21 * z s + A22 * w s)) <= E * E * d).
Proof.
  intros Hd Hk Hz; destruct bounds as (HL & HE & _); pose proof PI_RGT_0 as HP.
  assert (Free : forall p q, exists y v, forced_by (fun _ => - K) (fun _ => - c) (fun _ => 0) y v /\ y s = p /\ v s = q
    /\ y (s + 2 * PI) = A11 * p + gamma * q /\ v (s + 2 * PI) = A21 * p + A22 * q).
  { intros p q; destruct (picard (fun _ y v => - K * y + - c * v) L) with (s := s) (p := p) (r := q) as (y & v & H & Ey
    & Ev).
    - lra.
    - intros _ y v y' v'; replace (- K * y + - c * v - (- K * y' + - c * v')) with (- K * (y - y') + - c * (v - v')) by
      ring. eapply Rle_trans; [apply Rabs_triang|]; rewrite !Rabs_mult, !Rabs_Ropp; pose proof (Rabs_pos (y - y'));
        pose proof (Rabs_pos (v - v')); pose proof (Rabs_pos K); pose proof (Rabs_pos c).
      assert (Rabs K * Rabs (y - y') <= L * Rabs (y - y')) by (apply Rmult_le_compat_r; unfold L; lra);
        assert (Rabs c * Rabs (v - v') <= L * Rabs (v - v')) by (apply Rmult_le_compat_r; unfold L; lra); lra.
    - intros t y v; eapply D_continuous, D_const.
    - intros y v; exists (Rabs (- K * y + - c * v)); intros _; lra.
    - exists y, v; split; [intros t; destruct (H t) as [A B]; split; [exact A | eapply D_value; [exact B | ring]]|].
      split; [exact Ey | split; [exact Ev|]]; destruct (HA (fun t => y (s + t)) (fun t => v (s + t))) as [F1 F2].
      + intros t; destruct (H (s + t)) as [A B]; split; apply D_on; [exact A | eapply D_value; [exact B | ring]].
      + cbn in F1, F2; rewrite Rplus_0_r, Ey, Ev in F1, F2; lra. }
  assert (Kc : forall t : R, Rabs (- K) <= L /\ Rabs (- c) <= L) by (intros _; rewrite !Rabs_Ropp; pose proof (Rabs_pos
    K); pose proof (Rabs_pos c); unfold L; lra).
  assert (Kc' : forall t, Rabs (k t) <= L /\ Rabs (- c) <= L).
  { intros t; split; [|apply (Kc t)]; specialize (Hk t); pose proof (apart (k t + K) K) as A; replace (k t + K - K) with
      (k t) in A by ring; pose proof (Rabs_pos c); unfold L; lra. }
  assert (Z : forall t : R, s <= t <= s + 2 * PI -> Rabs 0 <= 0) by (intros; rewrite Rabs_R0; lra).
  split.
  - destruct (Free 1 0) as (y & v & F & Ey & Ev & G1 & G2), (Free 0 1) as (y' & v' & F' & Ey' & Ev' & G1' & G2').
    destruct (two_ways L (2 * PI) _ _ _ 0 _ _ s HL ltac:(lra) ltac:(lra) Kc F Z (s + 2 * PI) ltac:(lra)) as [B _],
      (two_ways L (2 * PI) _ _ _ 0 _ _ s HL ltac:(lra) ltac:(lra) Kc F' Z (s + 2 * PI) ltac:(lra)) as [B' _].
    fold E in B, B'; rewrite G1, G2, Ey, Ev, Rabs_R1, Rabs_R0 in B; rewrite G1', G2', Ey', Ev', Rabs_R1, Rabs_R0 in B'.
    replace (A11 * 1 + gamma * 0) with A11 in B by ring; replace (A21 * 1 + A22 * 0) with A21 in B by ring;
      replace (A11 * 0 + gamma * 1) with gamma in B' by ring; replace (A21 * 0 + A22 * 1) with A22 in B' by ring.
    pose proof (Rabs_pos A11); pose proof (Rabs_pos A21); pose proof (Rabs_pos A22); pose proof (Rabs_pos gamma).
    repeat split; lra.
  - intros Init; destruct (Free (z s) (w s)) as (y & v & F & Ey & Ev & G1 & G2).
    assert (Bz : forall t, s <= t <= s + 2 * PI -> Rabs (z t) + Rabs (w t) <= E).
    { intros t Ht; destruct (two_ways L (2 * PI) _ _ _ 0 _ _ s HL ltac:(lra) ltac:(lra) Kc' Hz Z t Ht) as [B _]; fold E
      in B. assert (E * (Rabs (z s) + Rabs (w s) + 0) <= E * 1) by (apply Rmult_le_compat_l; lra); lra. }
    assert (Fd : forced_by (fun _ => - K) (fun _ => - c) (fun t => (k t + K) * z t) (fun t => z t + -1 * y t)
      (fun t => w t + -1 * v t)).
    { intros t; destruct (Hz t) as [A B], (F t) as [A' B']; split; [apply D_plus; [exact A | apply D_scale, A']|].
      eapply D_value; [apply D_plus; [exact B | apply D_scale, B'] | cbv beta; ring]. }
    assert (Fb : forall t, s <= t <= s + 2 * PI -> Rabs ((k t + K) * z t) <= d * E).
    { intros t Ht; apply product; [apply Hk|]; specialize (Bz t Ht); pose proof (Rabs_pos (w t)); lra. }
    destruct (two_ways L (2 * PI) _ _ _ (d * E) _ _ s HL ltac:(apply Rmult_le_pos; lra) ltac:(lra) Kc Fd Fb (s + 2 * PI)
      ltac:(lra)) as [B _].
    fold E in B; rewrite G1, G2, Ey, Ev in B; replace (z s + -1 * z s) with 0 in B by ring;
      replace (w s + -1 * w s) with 0 in B by ring; rewrite Rabs_R0 in B; specialize (Bz (s + 2 * PI) ltac:(lra)).
    replace (z (s + 2 * PI) - (A11 * z s + gamma * w s)) with (z (s + 2 * PI) + -1 * (A11 * z s + gamma * w s)) by ring;
      replace (w (s + 2 * PI) - (A21 * z s + A22 * w s)) with (w (s + 2 * PI) + -1 * (A21 * z s + A22 * w s)) by ring.
    replace (E * (0 + 0 + d * E)) with (E * E * d) in B by ring; pose proof (Rabs_pos (z (s + 2 * PI)));
      pose proof (Rabs_pos (w (s + 2 * PI))); match type of B with Rabs ?u + Rabs ?x <= _ => pose proof (Rabs_pos u);
      pose proof (Rabs_pos x) end. repeat split; lra.
Qed.
Lemma small : exists d, 0 < d <= 1 /\ (6 * (E * (E * E * d)) <= eps /\ 6 * (E * (E * E * d)) <= Rabs gamma / 2 /\
  6 * (E * (E * E * d)) <= D / 2) /\ 4 * (E * E * d) <= eps * (Rabs K * D) /\ 8 * (E * E * d) <= D.
Proof.
  destruct bounds as (_ & HE & HD & Pk & Pg); destruct (two_least (eps / 6) (Rabs gamma / 12) ltac:(lra) ltac:(lra)) as
    (m1 & M1 & L1 & L2), (two_least m1 (D / 12) M1 ltac:(lra)) as (m2 & M2 & L3 & L4), (two_least (eps * (Rabs K * D) /
    4) (D / 8)) as (m3 & M3 & L5 & L6); [assert (0 < eps * (Rabs K * D)) by (repeat apply Rmult_lt_0_compat;
    assumption); lra | lra|]. destruct (two_least m2 m3 M2 M3) as (m4 & M4 & L7 & L8), (two_least m4 1 M4 ltac:(lra)) as
    (m & Hm & L9 & L10).
  assert (Up : forall x, 0 < x -> x <= E * x) by (intros x Hx; rewrite <- (Rmult_1_l x) at 1; apply Rmult_le_compat_r;
    lra).
  set (d := m / (E * (E * E))); assert (PE : 0 < E * E) by (apply Rmult_lt_0_compat; lra); assert (Pd : 0 < d) by (apply
    Rdiv_lt_0_compat; [exact Hm | apply Rmult_lt_0_compat; lra]). assert (Q : E * (E * E * d) = m) by (unfold d; field;
    lra). pose proof (Up d Pd); pose proof (Up (E * d) ltac:(lra)); pose proof (Up (E * E * d) ltac:(apply
    Rmult_lt_0_compat; lra)). exists d; rewrite Q; repeat split; lra.
Qed.
Lemma near : exists d, 0 < d /\ forall O sg, grazing_orbit O -> T O = 2 * PI -> Rabs sg = 1 -> (forall t,
  Rabs (along O (a_y O) t + K) <= d /\ along O (a_v O) t = - c /\ along O (a_mu O) t = sg) -> exists a1' a2' gamma'
    rate',
  generic O a1' a2' gamma' rate' /\ Rabs (a1' - a1) <= eps /\ Rabs (a2' - a2) <= eps /\ Rabs (gamma' - gamma) <= eps /\
  Rabs (rate' - sg / K) <= eps.
Proof.
  destruct small as (d & Hd & (N1 & N2 & N3) & N4 & N5), bounds as (HL & HE & HD & Pk & Pg); pose proof PI_RGT_0 as HP;
    exists d; split; [lra|]; intros O sg HO HT Hsg H.
  assert (Hk : forall t, Rabs (along O (a_y O) t + K) <= d) by (intros t; apply H).
  assert (Hkc : forall t, Rabs (along O (a_y O) t) <= L /\ Rabs (along O (a_v O) t) <= L).
  { intros t; destruct (H t) as (A1 & -> & _); pose proof (apart (along O (a_y O) t + K) K) as A; replace (along O (a_y
      O) t + K - K) with (along O (a_y O) t) in A by ring; rewrite Rabs_Ropp; pose proof (Rabs_pos c); pose proof
      (Rabs_pos K); unfold L; lra. }
  assert (Lin : forall m p q, exists z w, linearized O m z w /\ z (tG O) = p /\ w (tG O) = q) by (intros m p q;
    exact (linear_solutions O HO m (tG O) p q)).
  assert (F : forall m z w, linearized O m z w -> forced_by (along O (a_y O)) (fun _ => - c) (fun _ => sg * m) z w) by
    (intros m z w Hz t; destruct (Hz t) as [A B], (H t) as (_ & C1 & C2); rewrite C1, C2 in B; split; assumption).
  destruct (Lin 0 1 0) as (z1 & w1 & S1), (Lin 0 0 1) as (z2 & w2 & S2), (Lin 1 0 0) as (z3 & w3 & S3).
  pose proof (generic_of O L z1 w1 z2 w2 z3 w3 HO HL Hkc S1 S2 S3) as G; cbv zeta in G; rewrite HT in G.
  destruct S1 as (S1 & I1 & I1'), S2 as (S2 & I2 & I2'), S3 as (S3 & I3 & I3'); set (t1 := tG O + 2 * PI) in *.
  assert (F0 : forall z w, linearized O 0 z w -> forced_by (along O (a_y O)) (fun _ => - c) (fun _ => 0) z w) by
    (intros z w Hz t; destruct (F 0 z w Hz t) as [A B]; split; [exact A | eapply D_value; [exact B | ring]]).
  destruct (close_by d _ z1 w1 (tG O) ltac:(lra) Hk (F0 _ _ S1)) as ((B1 & B2 & B3 & B4) & N), (close_by d _ z2 w2 (tG
    O) ltac:(lra) Hk (F0 _ _ S2)) as [_ N']. fold t1 in N, N'; rewrite I1, I1', Rabs_R1, Rabs_R0 in N; rewrite I2, I2',
    Rabs_R1, Rabs_R0 in N'. destruct N as (M1 & M2 & P1 & P2), N' as (M3 & M4 & P3 & P4); try lra.
  replace (A11 * 1 + gamma * 0) with A11 in P1 by ring; replace (A21 * 1 + A22 * 0) with A21 in P2 by ring;
    replace (A11 * 0 + gamma * 1) with gamma in P3 by ring; replace (A21 * 0 + A22 * 1) with A22 in P4 by ring.
  (* the periodic solution, less that of the linear oscillator *)
  assert (Fu : forced_by (along O (a_y O)) (fun _ => - c) (fun t => sg / K * (along O (a_y O) t + K)) (fun t => z3 t -
    sg / K + sg / K * z1 t) (fun t => w3 t + sg / K * w1 t)).
  { intros t; destruct (F 1 _ _ S3 t) as [A B], (F0 _ _ S1 t) as [A' B']; split.
    - eapply D_value; [apply D_plus; [apply D_minus; [exact A | apply D_const] | apply D_scale, A'] | ring].
    - eapply D_value; [apply D_plus; [exact B | apply D_scale, B'] | field; exact HK]. }
  assert (SK : Rabs (sg / K) = / Rabs K) by (unfold Rdiv; rewrite Rabs_mult, Hsg, Rabs_inv; ring).
  assert (Kc : forall t, Rabs (along O (a_y O) t) <= L /\ Rabs (- c) <= L) by (intros t; split; [apply Hkc | rewrite
    Rabs_Ropp; pose proof (Rabs_pos K); unfold L; lra]). assert (Pi : 0 < / Rabs K) by (apply Rinv_0_lt_compat, Pk);
    destruct (two_ways L (2 * PI) _ _ _ (/ Rabs K * d) _ _ (tG O) HL ltac:(left; apply Rmult_lt_0_compat; lra)
    ltac:(lra) Kc Fu ltac:(intros t _; apply product; [rewrite SK; lra | apply Hk]) t1 ltac:(unfold t1; lra)) as [U _].
    cbv beta in U; rewrite I1, I1', I3, I3' in U; replace (0 - sg / K + sg / K * 1) with 0 in U by ring; replace (0 + sg
    / K * 0) with 0 in U by ring; rewrite Rabs_R0, !Rplus_0_l in U; fold E in U.
  set (x := z3 t1 - sg / K + sg / K * z1 t1) in *; set (y := w3 t1 + sg / K * w1 t1) in *; set (e := E * E * d) in *.
  assert (He0 : 0 < e) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra); assert (He1 : e <= E * e) by
    (rewrite <- (Rmult_1_l e) at 1; apply Rmult_le_compat_r; lra).
  (* trace, determinant, rate *)
  assert (Q1 : Rabs (z1 t1 * w2 t1 - A11 * A22) <= 2 * (E * e)).
  { replace (z1 t1 * w2 t1 - A11 * A22) with ((z1 t1 - A11) * w2 t1 + A11 * (w2 t1 - A22)) by ring; eapply Rle_trans;
      [apply Rabs_triang|]; pose proof (product _ _ _ _ P1 M4); pose proof (product _ _ _ _ B1 P4); lra. }
  assert (Q2 : Rabs (w1 t1 * z2 t1 - gamma * A21) <= 2 * (E * e)).
  { replace (w1 t1 * z2 t1 - gamma * A21) with ((w1 t1 - A21) * z2 t1 + A21 * (z2 t1 - gamma)) by ring; eapply
      Rle_trans; [apply Rabs_triang|]; pose proof (product _ _ _ _ P2 M3); pose proof (product _ _ _ _ B2 P3); lra. }
  set (b1 := z1 t1 + w2 t1) in *; set (b2 := z1 t1 * w2 t1 - w1 t1 * z2 t1) in *.
  assert (R1 : Rabs (b1 - a1) <= 2 * e) by (apply le_abs in P1, P4; unfold b1, a1; apply Rabs_le; lra).
  assert (R2 : Rabs (b2 - a2) <= 4 * (E * e)) by (apply le_abs in Q1, Q2; unfold b2, a2; apply Rabs_le; lra).
  assert (R3 : D / 2 <= Rabs (1 - b1 + b2)).
  { pose proof (from (1 - a1 + a2) (1 - b1 + b2) (D / 2)) as A; fold D in A; assert (Rabs (1 - a1 + a2 - (1 - b1 + b2))
      <= D / 2); [apply le_abs in R1, R2; apply Rabs_le; lra | specialize (A H0); lra]. }
  assert (D0 : 1 - b1 + b2 <> 0) by (intros Z; rewrite Z, Rabs_R0 in R3; lra).
  assert (G0 : z2 t1 <> 0) by (intros Z; rewrite Z, Rminus_0_l, Rabs_Ropp in P3; lra).
  set (rate := ((1 - w2 t1) * z3 t1 + z2 t1 * w3 t1) / (1 - b1 + b2)) in *.
  assert (Er : (rate - sg / K) * (1 - b1 + b2) = (1 - w2 t1) * x + z2 t1 * y).
  { unfold rate, x, y; assert (S : b2 = z1 t1 * w2 t1 - w1 t1 * z2 t1) by reflexivity; assert (S' : b1 = z1 t1 + w2 t1)
      by reflexivity; clearbody b1 b2; rewrite Rmult_minus_distr_r; unfold Rdiv at 1; rewrite Rmult_assoc, Rinv_l by
      exact D0; rewrite S, S'; ring. }
  assert (B : Rabs ((1 - w2 t1) * x + z2 t1 * y) <= 2 * (e * / Rabs K)).
  { pose proof (Rabs_pos x); pose proof (Rabs_pos y); assert (W : Rabs (1 - w2 t1) <= 2 * E) by (apply le_abs in M4;
      apply Rabs_le; lra). pose proof (product _ _ _ _ W (Rle_refl (Rabs x))) as X1; pose proof (product _ _ _ _ M3
        (Rle_refl
      (Rabs y))) as X2. eapply Rle_trans; [apply Rabs_triang|]; assert (0 <= E * Rabs y) by (apply Rmult_le_pos; lra).
    assert (E * (Rabs x + Rabs y) <= E * (E * (/ Rabs K * d))) by (apply Rmult_le_compat_l; lra);
      replace (E * (E * (/ Rabs K * d))) with (e * / Rabs K) in * by (unfold e; ring); lra. }
  assert (R4 : Rabs (rate - sg / K) * D <= 4 * (e * / Rabs K)).
  { pose proof (Rabs_pos (rate - sg / K)); assert (Rabs (rate - sg / K) * (D / 2) <= Rabs ((rate - sg / K) * (1 - b1 +
      b2))); [rewrite Rabs_mult; apply Rmult_le_compat_l; lra | rewrite Er in *; lra]. }
  assert (R5 : forall b, 0 < b -> 4 * e <= b * (Rabs K * D) -> Rabs (rate - sg / K) <= b).
  { intros b Hb HH; apply Rmult_le_reg_r with D; [exact HD|]; apply Rle_trans with (1 := R4), Rmult_le_reg_r with (Rabs
      K); [exact Pk|]; replace (4 * (e * / Rabs K) * Rabs K) with (4 * e) by (field; lra); lra. }
  exists b1, b2, (z2 t1), rate; split; [apply G; [exact G0 | exact D0|]|].
  - intros Z; pose proof (R5 (/ Rabs K / 2) ltac:(lra)) as R6; rewrite Z, Rminus_0_l, Rabs_Ropp, SK in R6.
    replace (/ Rabs K / 2 * (Rabs K * D)) with (D / 2) in R6 by (field; lra); specialize (R6 ltac:(lra)); lra.
  - split; [lra | split; [lra | split; [lra | apply R5; [exact He | exact N4]]]].
Qed.
End Near.
Theorem near_linear c K a1 a2 gamma eps : matrix c K Plus a1 a2 gamma -> gamma <> 0 -> K <> 0 -> a1 <> a2 + 1 -> 0 < eps
  -> exists d, 0 < d /\ forall O sg, grazing_orbit O -> T O = 2 * PI -> Rabs sg = 1 -> (forall t, Rabs (along O (a_y O)
    t + K) <=
  d /\ along O (a_v O) t = - c /\ along O (a_mu O) t = sg) -> exists a1' a2' gamma' rate', generic O a1' a2' gamma'
    rate' /\
  Rabs (a1' - a1) <= eps /\ Rabs (a2' - a2) <= eps /\ Rabs (gamma' - gamma) <= eps /\ Rabs (rate' - sg / K) <= eps.
Proof. intros (A11 & A21 & A22 & -> & -> & HA); apply near; exact HA. Qed.
