(** * Solutions of y'' = F (t, y, y') exist for all time if F is Lipschitz in the state, continuous and bounded in time

    Picard's iteration, with the weight exp (K t) + exp (- K t); primitives are the library's. Place and velocity are
    the two components, true and false, of the state. *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import Contraction Derivatives.
Open Scope R_scope.

(** The primitive that is 0 at 0. *)
Definition prim (f : R -> R) (t : R) : R :=
  the (fun r => exists H, (forall u, Rabs u <= Rabs t + 1 -> derivable_pt_lim H u (f u)) /\ H 0 = 0 /\ r = H t).
Lemma same_primitive f H H' b : (forall u, Rabs u <= b -> derivable_pt_lim H u (f u)) ->
  (forall u, Rabs u <= b -> derivable_pt_lim H' u (f u)) -> H 0 = H' 0 -> forall t, Rabs t <= b -> H t = H' t.
Proof.
  intros D D' E t Ht; assert (Dd : forall u, Rabs u <= b -> derivable_pt_lim (fun u => H u - H' u) u 0).
  { intros u Hu; eapply D_value; [apply D_minus; [apply D, Hu | apply D', Hu] | ring]. }
  apply le_abs in Ht; destruct (Rtotal_order 0 t) as [O|[<-|O]]; [|exact E|].
  - destruct (MVT_cor2 (fun u => H u - H' u) (fun _ => 0) 0 t O) as (c & Q & _);
      [intros u Hu; apply Dd, Rabs_le; lra | lra].
  - destruct (MVT_cor2 (fun u => H u - H' u) (fun _ => 0) t 0 O) as (c & Q & _);
      [intros u Hu; apply Dd, Rabs_le; lra | lra].
Qed.
Lemma primitive_exists f b : (forall t, continuity_pt f t) -> 0 <= b ->
  exists H, (forall u, Rabs u <= b -> derivable_pt_lim H u (f u)) /\ H 0 = 0.
Proof.
  intros C Hb; assert (h : - b <= b) by lra; set (P := primitive h (FTC_P1 h (fun x _ => C x)));
    exists (fun t => P t - P 0). split; [|ring]; intros u Hu; apply le_abs in Hu; eapply D_value;
    [apply D_minus; [apply RiemannInt_P28; lra | apply D_const] | ring].
Qed.
Lemma prim_spec f : (forall t, continuity_pt f t) -> prim f 0 = 0 /\ forall t, derivable_pt_lim (prim f) t (f t).
Proof.
  intros C; assert (Is : forall b H, (forall u, Rabs u <= b + 1 -> derivable_pt_lim H u (f u)) -> H 0 = 0 -> forall t,
    Rabs t <= b -> prim f t = H t).
  { intros b H D Z t Ht; apply the_spec.
    - exists H; split; [|auto]; intros u Hu; apply D; lra.
    - intros r (H' & D' & Z' & ->); apply (same_primitive f H' H (Rabs t)); try lra; intros u Hu; [apply D' | apply D];
        lra. }
  split.
  - destruct (primitive_exists f 1 C ltac:(lra)) as (H & D & Z); rewrite (Is 0 H); trivial; rewrite ?Rabs_R0; try lra;
      intros u Hu; apply D; lra.
  - intros t; destruct (primitive_exists f (Rabs t + 1 + 1) C ltac:(pose proof (Rabs_pos t); lra)) as (H & D & Z).
    intros e He; destruct (D t ltac:(lra) e He) as [d Hd];
      assert (P : 0 < Rmin d 1) by (apply Rmin_glb_lt; [apply cond_pos | lra]). exists (mkposreal _ P); intros h h0 Hh;
      cbn in Hh; pose proof (Rmin_l d 1); pose proof (Rmin_r d 1).
    rewrite (Is (Rabs t + 1) H D Z t), (Is (Rabs t + 1) H D Z (t + h));
      [apply Hd; trivial; lra | pose proof (Rabs_triang t h); lra | lra].
Qed.

Section Picard.
Variables (F : R -> (bool -> R) -> bool -> R) (L A : R) (p : bool -> R).
Hypothesis HL : 0 <= L.
Hypothesis Flip : forall t z w i, Rabs (F t z i - F t w i) <= L * (Rabs (z true - w true) + Rabs (z false - w false)).
Hypothesis Fcont : forall t z i, continuity_pt (fun t => F t z i) t.
Hypothesis Fbound : forall t i, Rabs (F t p i) <= A.
Let K := 4 * (1 + L).
Definition W t := exp (K * t) + exp (- K * t).
Lemma W_large t : 2 <= W t.
Proof.
  unfold W; pose proof (exp_pos (K * t)) as P;
    assert (E : exp (K * t) * exp (- K * t) = 1) by (rewrite <- exp_plus; replace (K * t + - K * t) with 0 by ring;
      apply exp_0). set (x := exp (K * t)) in *; set (y := exp (- K * t)) in *; pose proof (exp_pos (- K * t)) as P';
    fold y in P'. pose proof (Rle_0_sqr (x - y)) as Q; unfold Rsqr in Q; apply Rsqr_incr_0_var; unfold Rsqr; lra.
Qed.
(** What vanishes at 0 and has a derivative of at most 2 (1 + L) b W is at most b W. *)
Lemma grows h h' b : 0 <= b -> h 0 = 0 -> (forall t, derivable_pt_lim h t (h' t) /\ Rabs (h' t) <= K * b * W t) ->
  forall t, Rabs (h t) <= b * W t.
Proof.
  intros Hb H0 D t.
  assert (De : forall c u, derivable_pt_lim (fun t => exp (c * t)) u (exp (c * u) * c)) by (intros c u; apply D_exp;
    eapply D_value; [apply D_scale, D_id | ring]).
  assert (Dg : forall u, derivable_pt_lim (fun t => b * (exp (K * t) - exp (- K * t))) u (K * b * W u))
    by (intros u; eapply D_value; [apply D_scale, D_minus; apply De | unfold W; ring]).
  set (G t := b * (exp (K * t) - exp (- K * t))) in *;
    assert (G0 : G 0 = 0) by (unfold G; rewrite !Rmult_0_r, exp_0; ring).
  assert (Lim : forall u v, u <= v -> h v - h u <= G v - G u /\ - (G v - G u) <= h v - h u).
  { intros u v [O| ->]; [|lra].
    destruct (MVT_cor2 (fun t => h t - G t) (fun t => h' t - K * b * W t) u v O) as (c & E & _);
      [intros c _; apply D_minus; [apply D | apply Dg]|].
    destruct (MVT_cor2 (fun t => h t + G t) (fun t => h' t + K * b * W t) u v O) as (c' & E' & _);
      [intros x _; apply D_plus; [apply D | apply Dg]|]. destruct (D c) as [_ B]; destruct (D c') as [_ B'];
      apply le_abs in B, B'. assert (0 <= (K * b * W c - h' c) * (v - u)) by (apply Rmult_le_pos; lra);
      assert (0 <= (h' c' + K * b * W c') * (v - u)) by (apply Rmult_le_pos; lra); lra. }
  assert (Gb : Rabs (G t) <= b * W t).
  { unfold G; rewrite Rabs_mult, (Rabs_pos_eq b) by exact Hb; apply Rmult_le_compat_l; [exact Hb|]; unfold W;
      pose proof (exp_pos (K * t)); pose proof (exp_pos (- K * t)); apply Rabs_le; lra. }
  apply le_abs in Gb; apply Rabs_le; destruct (Rle_dec 0 t) as [O|O];
    [pose proof (Lim 0 t O) | pose proof (Lim t 0 ltac:(lra))]; lra.
Qed.
Lemma F_path (x : bool -> R -> R) i : (forall j t, continuity_pt (x j) t) -> forall t,
  continuity_pt (fun t => F t (fun j => x j t) i) t.
Proof.
  intros C t e He; assert (Q : 0 < e / (4 * (L + 1))) by (apply Rdiv_lt_0_compat; lra);
    set (q := e / (4 * (L + 1))) in *.
  destruct (continuous_near _ t q (C true t) Q) as (d1 & D1 & H1), (continuous_near _ t q (C false t) Q)
    as (d2 & D2 & H2), (continuous_near _ t (e / 4) (Fcont t (fun j => x j t) i) ltac:(lra)) as (d3 & D3 & H3).
  destruct (two_least d1 d2 D1 D2) as (d4 & D4 & L1 & L2), (two_least d4 d3 D4 D3) as (d & Hd & L3 & L4); exists d;
    split; [exact Hd|]. intros s [_ Hs]; cbn in *; unfold R_dist in *; specialize (H1 s ltac:(lra));
    specialize (H2 s ltac:(lra)); specialize (H3 s ltac:(lra)).
  pose proof (Flip s (fun j => x j s) (fun j => x j t) i) as P; cbv beta in P;
    assert (L * (Rabs (x true s - x true t) + Rabs (x false s - x false t)) <= (L + 1) * (2 * q)).
  { pose proof (Rabs_pos (x true s - x true t)); pose proof (Rabs_pos (x false s - x false t)); apply Rmult_le_compat;
      lra. }
  replace ((L + 1) * (2 * q)) with (e / 2) in * by (unfold q; field; lra); apply le_abs in P, H3; apply Rabs_def1; lra.
Qed.
Fixpoint it (n : nat) : bool -> R -> R := match n with O => fun i _ => p i |
  S n => fun i t => p i + prim (fun t => F t (fun j => it n j t) i) t end.
Lemma step x : (forall i t, continuity_pt (x i) t) -> forall i, p i + prim (fun t => F t (fun j => x j t) i) 0 = p i /\
  forall t, derivable_pt_lim (fun t => p i + prim (fun t => F t (fun j => x j t) i) t) t (F t (fun j => x j t) i).
Proof.
  intros C i; destruct (prim_spec _ (F_path x i C)) as [-> D]; split; [ring|]; intros t; eapply D_value;
    [apply D_plus; [apply D_const | apply D] | ring].
Qed.
Lemma it_continuous n : forall i t, continuity_pt (it n i) t.
Proof. induction n as [|n IH]; intros i t; [exact (D_continuous (fun _ => p i) 0 t (D_const (p i) t)) |
  eapply D_continuous; apply (proj2 (step (it n) IH i))]. Qed.
Lemma A_pos : 0 <= A.
Proof. eapply Rle_trans; [apply Rabs_pos | apply (Fbound 0 true)]. Qed.
(** Where two paths differ by b W, the next ones differ by half of that. *)
Lemma halved x y b : (forall i t, continuity_pt (x i) t) -> (forall i t, continuity_pt (y i) t) -> 0 <= b ->
  (forall i t, Rabs (x i t - y i t) <= b * W t) -> forall i t, Rabs (p i + prim (fun t => F t (fun j => x j t) i) t - (p
  i + prim (fun t => F t (fun j => y j t) i) t)) <= b / 2 * W t.
Proof.
  intros Cx Cy Hb H i; destruct (step x Cx i) as [X0 Dx], (step y Cy i) as [Y0 Dy].
  apply (grows (fun t => p i + prim (fun t => F t (fun j => x j t) i) t -
    (p i + prim (fun t => F t (fun j => y j t) i) t)) (fun t => F t (fun j => x j t) i - F t (fun j => y j t) i));
    [lra | lra|]. intros t; split; [apply D_minus; [apply Dx | apply Dy]|]; eapply Rle_trans; [apply Flip|];
    pose proof (H true t); pose proof (H false t); pose proof (W_large t). apply Rle_trans with (L * (2 * (b * W t)));
    [apply Rmult_le_compat_l; lra|]; assert (0 <= b * W t) by (apply Rmult_le_pos; lra); unfold K; lra.
Qed.
Lemma steps n : forall i t, Rabs (it (S n) i t - it n i t) <= A * (/ 2) ^ n * W t.
Proof.
  pose proof A_pos; induction n as [|n IH]; intros i.
  - destruct (step (it 0) (it_continuous 0) i) as [X0 D]; cbn [pow]; rewrite Rmult_1_r;
      apply (grows (fun t => it 1 i t - it 0 i t) (fun t => F t p i)); [exact H | cbn in *; lra|]. intros t; split;
      [eapply D_value; [apply D_minus; [apply D | exact (D_const (p i) t)] | exact (Rminus_0_r (F t p i))]|];
      pose proof (Fbound t i); pose proof (W_large t). assert (A * 1 <= A * W t) by (apply Rmult_le_compat_l; lra);
      assert (0 <= L * (A * W t)) by (apply Rmult_le_pos; [exact HL | apply Rmult_le_pos; lra]); unfold K; lra.
  - intros t; replace (A * (/ 2) ^ S n) with (A * (/ 2) ^ n / 2) by (cbn [pow]; field).
    apply (halved (it (S n)) (it n)); trivial; try apply it_continuous; apply Rmult_le_pos;
      [exact H | apply pow_le; lra].
Qed.
Definition lim i t := the (Un_cv (fun n => it n i t)).
Lemma limits n i t : Rabs (lim i t - it n i t) <= 2 * A * (/ 2) ^ n * W t.
Proof.
  pose proof A_pos as HA; pose proof (W_large t) as Wt; set (C := A * W t);
    assert (HC : 0 <= C) by (apply Rmult_le_pos; lra).
  assert (Pn : forall m, 0 <= C * (/ 2) ^ m) by (intros m; apply Rmult_le_pos; [exact HC | apply pow_le; lra]).
  assert (Far : forall m n, Rabs (it (n + m) i t - it n i t) <= 2 * (C * (/ 2) ^ n) - 2 * (C * (/ 2) ^ (n + m))).
  { induction m as [|m IH]; intros q; [rewrite Nat.add_0_r, !Rminus_eq_0, Rabs_R0; lra|]; specialize (IH q); pose proof
      (steps (q + m) i t) as S1. replace (q + S m)%nat with (S (q + m)) by lia; replace (A * (/ 2) ^ (q + m) * W t) with
      (C * (/ 2) ^ (q + m)) in S1 by (unfold C; ring). cbn [pow]; apply le_abs in IH, S1; apply Rabs_le; lra. }
  assert (Cc : Cauchy_crit (fun m => it m i t)).
  { intros e He; destruct (powers_small (/ 2) (4 * C) e ltac:(lra) He) as [m Hm]; exists m; intros u v Hu Hv;
      unfold R_dist. pose proof (Far (u - m)%nat m) as X; pose proof (Far (v - m)%nat m) as Y;
      replace (m + (u - m))%nat with u in X by lia; replace (m + (v - m))%nat with v in Y by lia. pose proof (Pn u);
      pose proof (Pn v); apply le_abs in X, Y; apply Rabs_def1; lra. }
  destruct (R_complete _ Cc) as [l Hl]; unfold lim; rewrite (the_spec _ l Hl) by (intros z Hz; apply (UL_sequence _ _ _
    Hz Hl)). apply le_epsilon; intros e He; destruct (Hl e He) as [j Hj]; specialize (Hj (n + j)%nat ltac:(lia)); unfold
    R_dist in Hj; pose proof (Far j n) as X; pose proof (Pn (n + j)%nat).
  replace (2 * A * (/ 2) ^ n * W t) with (2 * (C * (/ 2) ^ n)) by (unfold C; ring); apply le_abs in X;
    apply Rabs_def2 in Hj; apply Rabs_le; lra.
Qed.
Lemma lim_continuous i t : continuity_pt (lim i) t.
Proof.
  intros e He; pose proof A_pos as HA; set (B := 2 * exp (K * (Rabs t + 1))); assert (HK : 0 <= K) by (unfold K; lra).
  assert (Wb : forall u, Rabs (u - t) <= 1 -> W u <= B).
  { intros u Hu; assert (Ru : Rabs u <= Rabs t + 1) by (replace u with (t + (u - t)) by ring; eapply Rle_trans; [apply
      Rabs_triang | lra]); apply le_abs in Ru.
    assert (M : forall q, q <= K * (Rabs t + 1) -> exp q <= exp (K * (Rabs t + 1))) by (intros q [Q| ->];
      [left; apply exp_increasing, Q | lra]). assert (K * u <= K * (Rabs t + 1)) by (apply Rmult_le_compat_l; lra);
      assert (K * - u <= K * (Rabs t + 1)) by (apply Rmult_le_compat_l; lra). pose proof (M (K * u) ltac:(lra));
      pose proof (M (- K * u) ltac:(lra)); unfold W, B; lra. }
  destruct (powers_small (/ 2) (2 * A * B) (e / 4) ltac:(lra) ltac:(lra)) as [n Hn],
    (continuous_near (it n i) t (e / 4) (it_continuous n i t) ltac:(lra)) as (d1 & D1 & N).
  destruct (two_least d1 1 D1 ltac:(lra)) as (d & Hd & L1 & L2); exists d; split; [exact Hd|]; intros u [_ Hu];
    cbn in *; unfold R_dist in *; specialize (N u ltac:(lra)).
  assert (Q : forall u, Rabs (u - t) <= 1 -> Rabs (lim i u - it n i u) <= e / 4).
  { intros x Hx; eapply Rle_trans; [apply limits|]; assert (2 * A * (/ 2) ^ n * W x <= 2 * A * (/ 2) ^ n * B); [|lra].
    apply Rmult_le_compat_l; [apply Rmult_le_pos; [lra | apply pow_le; lra] | apply Wb, Hx]. }
  pose proof (Q u ltac:(lra)) as Q1; pose proof (Q t ltac:(rewrite Rminus_eq_0, Rabs_R0; lra)) as Q2;
    apply le_abs in Q1, Q2, N; apply Rabs_def1; lra.
Qed.
Lemma solution i : lim i 0 = p i /\ forall t, derivable_pt_lim (lim i) t (F t (fun j => lim j t) i).
Proof.
  pose proof A_pos as HA; destruct (step lim lim_continuous i) as [Z D].
  assert (E : forall t, p i + prim (fun t => F t (fun j => lim j t) i) t = lim i t).
  { intros t; apply Rminus_diag_uniq, Rabs_zero, (squeezed (/ 2) _ 0 (2 * A * W t)); [lra|]; intros n;
      assert (Qn : 0 <= (/ 2) ^ n) by (apply pow_le; lra).
    pose proof (halved lim (it n) (2 * A * (/ 2) ^ n) lim_continuous (it_continuous n) ltac:(apply Rmult_le_pos;
      lra) (limits n) i t) as X; pose proof (limits (S n) i t) as Y.
    change (p i + prim (fun t => F t (fun j => it n j t) i) t) with (it (S n) i t) in X; cbn [pow] in Y;
      apply le_abs in X, Y; apply Rabs_le; lra. }
  split; [rewrite <- E; exact Z|]; intros t; eapply D_ext; [apply D | exact E | reflexivity].
Qed.
End Picard.

Theorem picard (F : R -> R -> R -> R) L : 0 <= L -> (forall t y v y' v', Rabs (F t y v - F t y' v') <= L * (Rabs (y -
  y') + Rabs (v - v'))) -> (forall t y v, continuity_pt (fun t => F t y v) t) -> (forall y v, exists A, forall t,
  Rabs (F t y v) <= A) -> forall s p r, exists y v, (forall t, derivable_pt_lim y t (v t) /\
  derivable_pt_lim v t (F t (y t) (v t))) /\ y s = p /\ v s = r.
Proof.
  intros HL Hlip Hc Hb s p r; destruct (Hb p r) as [A HA];
    set (G t (z : bool -> R) (i : bool) := if i then z false else F (t + s) (z true) (z false)).
  assert (Lip : forall t z w i, Rabs (G t z i - G t w i) <=
    (1 + L) * (Rabs (z true - w true) + Rabs (z false - w false))).
  { intros t z w i; pose proof (Rabs_pos (z true - w true)) as P; pose proof (Rabs_pos (z false - w false));
      assert (0 <= L * (Rabs (z true - w true) + Rabs (z false - w false))) by (apply Rmult_le_pos; lra). destruct i;
      cbn; [lra|]; pose proof (Hlip (t + s) (z true) (z false) (w true) (w false)); lra. }
  assert (Con : forall t z i, continuity_pt (fun t => G t z i) t).
  { intros t z [|]; cbn; [apply (D_continuous _ 0), D_const|];
      apply (continuity_pt_comp (fun t => t + s) (fun t => F t (z true) (z false))); [|apply Hc].
    apply (D_continuous _ 1); eapply D_value; [apply D_plus; [apply D_id | apply D_const] | ring]. }
  assert (Bd : forall t i, Rabs (G t (fun i : bool => if i then p else r) i) <= Rabs r + A).
  { intros t i; pose proof (HA (t + s)); pose proof (Rabs_pos (F (t + s) p r)); pose proof (Rabs_pos r); destruct i;
      cbn; lra. }
  pose proof (solution G (1 + L) (Rabs r + A) (fun i : bool => if i then p else r) ltac:(lra) Lip Con Bd) as H;
    set (x := lim G (fun i : bool => if i then p else r)) in *.
  exists (fun t => x true (t - s)), (fun t => x false (t - s)); replace (s - s) with 0 by ring; split;
    [|split; apply H]; intros t. destruct (H true) as [_ D1], (H false) as [_ D2]; specialize (D1 (t - s));
    specialize (D2 (t - s)); cbn in D1, D2; replace (t - s + s) with t in D2 by ring. split;
    (eapply D_value; [apply (D_of (fun t => t - s)); [apply D_shift | eassumption] | ring]).
Qed.
(** Linear equations. *)
Lemma linear_picard (k c l : R -> R) B : (forall t, continuity_pt k t /\ continuity_pt c t /\ continuity_pt l t) ->
  (forall t, Rabs (k t) <= B /\ Rabs (c t) <= B /\ Rabs (l t) <= B) -> forall m s p q, exists z w,
  (forall t, derivable_pt_lim z t (w t) /\ derivable_pt_lim w t (k t * z t + c t * w t + l t * m)) /\ z s = p /\
  w s = q.
Proof.
  intros C H m s p q; assert (HB : 0 <= B) by (destruct (H 0) as (A & _); pose proof (Rabs_pos (k 0)); lra).
  apply (picard (fun t y v => k t * y + c t * v + l t * m) B HB).
  - intros t y v y' v'; replace (k t * y + c t * v + l t * m - (k t * y' + c t * v' + l t * m)) with (k t
      * (y - y') + c t * (v - v')) by ring. destruct (H t) as (H1 & H2 & _); eapply Rle_trans; [apply Rabs_triang|];
      rewrite !Rabs_mult; pose proof (Rabs_pos (y - y')); pose proof (Rabs_pos (v - v')).
    assert (Rabs (k t) * Rabs (y - y') <= B * Rabs (y - y')) by (apply Rmult_le_compat_r; lra); assert (Rabs (c t)
      * Rabs (v - v') <= B * Rabs (v - v')) by (apply Rmult_le_compat_r; lra); lra.
  - intros t y v; destruct (C t) as (C1 & C2 & C3); assert (Cc : forall q, continuity_pt (fun _ : R => q) t) by
      (intros x; apply (D_continuous _ 0), D_const).
    apply (continuity_pt_plus (fun t => k t * y + c t * v) (fun t => l t * m)); [apply (continuity_pt_plus (fun t
      => k t * y) (fun t => c t * v))|].
    + apply (continuity_pt_mult k (fun _ => y)); [exact C1 | apply Cc].
    + apply (continuity_pt_mult c (fun _ => v)); [exact C2 | apply Cc].
    + apply (continuity_pt_mult l (fun _ => m)); [exact C3 | apply Cc].
  - intros y v; exists (B * Rabs y + B * Rabs v + B * Rabs m); intros t; destruct (H t) as (H1 & H2 & H3); eapply
      Rle_trans; [apply Rabs_triang|]; eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang|]; rewrite !Rabs_mult.
    repeat apply Rplus_le_compat; apply Rmult_le_compat_r; try apply Rabs_pos; assumption.
Qed.
