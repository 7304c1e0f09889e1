(** * Solutions of y'' = F (t, y, y') exist for all time if F is Lipschitz in the state, continuous and bounded in time

    Picard's iteration, with the weight exp (K t) + exp (- K t); primitives are the library's. *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import Contraction Derivatives.
Open Scope R_scope.

(** The primitive that is 0 at 0. *)
Definition prim (f : R -> R) (t : R) : R :=
  the (fun r => exists H, (forall u, Rabs u <= Rabs t + 1 -> derivable_pt_lim H u (f u)) /\ H 0 = 0 /\ r = H t).
Lemma same_primitive f H H' b : (forall u, Rabs u <= b -> derivable_pt_lim H u (f u)) ->
  (forall u, Rabs u <= b -> derivable_pt_lim H' u (f u)) ->
  H 0 = H' 0 -> forall t, Rabs t <= b -> H t = H' t.
Proof.
  intros D D' E t Ht; assert (Dd : forall u, Rabs u <= b -> derivable_pt_lim (fun u => H u - H' u) u 0).
  { intros u Hu; eapply D_value; [apply D_minus; [apply D, Hu | apply D', Hu] | ring]. }
  apply le_abs in Ht; destruct (Rtotal_order 0 t) as [O|[<-|O]]; [|exact E|].
  - destruct (MVT_cor2 (fun u => H u - H' u) (fun _ => 0) 0 t O) as (c & Q & _);
      [intros u Hu; apply Dd, Rabs_le; lra | lra].
  - destruct (MVT_cor2 (fun u => H u - H' u) (fun _ => 0) t 0 O) as (c & Q & _);
      [intros u Hu; apply Dd, Rabs_le; lra | lra].
Qed.
Lemma primitive_exists f b : (forall t, continuity_pt f t) -> 0 <= b -> exists H,
  (forall u, Rabs u <= b -> derivable_pt_lim H u (f u)) /\ H 0 = 0.
Proof.
  intros C Hb; assert (h : - b <= b) by lra; set (P := primitive h (FTC_P1 h (fun x _ => C x)));
    exists (fun t => P t - P 0). split; [|ring]; intros u Hu; apply le_abs in Hu; eapply D_value;
    [apply D_minus; [apply RiemannInt_P28; lra | apply D_const] | ring].
Qed.
Lemma prim_spec f : (forall t, continuity_pt f t) -> prim f 0 = 0 /\ forall t, derivable_pt_lim (prim f) t (f t).
Proof.
  intros C;
    assert (Is : forall b H, (forall u, Rabs u <= b + 1 -> derivable_pt_lim H u (f u)) -> H 0 = 0 -> forall t, Rabs t <=
      b -> prim f t = H t).
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

Section Weight.
Variable K : R.
Hypothesis HK : 0 < K.
Definition W t := exp (K * t) + exp (- K * t).
Lemma W_large t : 2 <= W t.
Proof.
  unfold W; pose proof (exp_pos (K * t)) as P;
    assert (E : exp (K * t) * exp (- K * t) = 1) by (rewrite <- exp_plus; replace (K * t + - K * t) with 0 by ring;
      apply exp_0). set (x := exp (K * t)) in *; set (y := exp (- K * t)) in *; pose proof (exp_pos (- K * t)) as P';
    fold y in P'. pose proof (Rle_0_sqr (x - y)) as Q; unfold Rsqr in Q; apply Rsqr_incr_0_var; unfold Rsqr; lra.
Qed.
Lemma grows h h' A : 0 <= A -> h 0 = 0 -> (forall t, derivable_pt_lim h t (h' t) /\ Rabs (h' t) <= A * W t) -> forall t,
  Rabs (h t) <= A / K * W t.
Proof.
  intros HA H0 D t; assert (AK : 0 <= A / K) by (apply Rmult_le_pos; [exact HA | left; apply Rinv_0_lt_compat, HK]).
  assert (De : forall c u, derivable_pt_lim (fun t => exp (c * t)) u (exp (c * u) * c)).
  { intros c u; apply D_exp; eapply D_value; [apply D_scale, D_id | ring]. }
  assert (Dg : forall u, derivable_pt_lim (fun t => A / K * (exp (K * t) - exp (- K * t))) u (A * W u)).
  { intros u; eapply D_value; [apply D_scale, D_minus; apply De | unfold W; field; lra]. }
  set (G t := A / K * (exp (K * t) - exp (- K * t))) in *;
    assert (G0 : G 0 = 0) by (unfold G; rewrite !Rmult_0_r, exp_0; ring).
  assert (Lim : forall u v, u <= v -> h v - h u <= G v - G u /\ - (G v - G u) <= h v - h u).
  { intros u v [O| ->]; [|lra]. destruct (MVT_cor2 (fun t => h t - G t) (fun t => h' t - A * W t) u v O) as (c & E & _);
      [intros c _; apply D_minus; [apply D | apply Dg]|].
    destruct (MVT_cor2 (fun t => h t + G t) (fun t => h' t + A * W t) u v O) as (c' & E' & _);
      [intros x _; apply D_plus; [apply D | apply Dg]|]. destruct (D c) as [_ B]; destruct (D c') as [_ B'];
      apply le_abs in B, B'. assert (0 <= (A * W c - h' c) * (v - u)) by (apply Rmult_le_pos; lra);
      assert (0 <= (h' c' + A * W c') * (v - u)) by (apply Rmult_le_pos; lra); lra. }
  assert (Gb : Rabs (G t) <= A / K * W t).
  { unfold G; rewrite Rabs_mult, (Rabs_pos_eq (A / K)) by exact AK; apply Rmult_le_compat_l; [exact AK|]; unfold W;
      pose proof (exp_pos (K * t)); pose proof (exp_pos (- K * t)); apply Rabs_le; lra. }
  apply le_abs in Gb; apply Rabs_le; destruct (Rle_dec 0 t) as [O|O];
    [pose proof (Lim 0 t O) | pose proof (Lim t 0 ltac:(lra))]; lra.
Qed.
End Weight.

Lemma limit s C : 0 <= C -> (forall n, Rabs (s (S n) - s n) <= C * (/ 2) ^ n) -> exists l : R, Un_cv s l /\ forall n,
  Rabs (l - s n) <= 2 * C * (/ 2) ^ n.
Proof.
  intros HC H; assert (Q : forall n, 0 <= (/ 2) ^ n) by (intros n; apply pow_le; lra).
  assert (Far : forall m n, Rabs (s (n + m)%nat - s n) <= 2 * C * (/ 2) ^ n - 2 * C * (/ 2) ^ (n + m)).
  { induction m as [|m IH]; intros n; [rewrite Nat.add_0_r, !Rminus_eq_0, Rabs_R0; lra|]; specialize (IH n);
      specialize (H (n + m)%nat). replace (n + S m)%nat with (S (n + m)) by lia;
      replace (s (S (n + m)) - s n) with ((s (S (n + m)) - s (n + m)%nat) + (s (n + m)%nat - s n)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; cbn [pow]; lra. }
  assert (Cc : Cauchy_crit s).
  { intros e He; destruct (powers_small (/ 2) (4 * C) e ltac:(lra) He) as [m Hm]; exists m; intros p q Hp Hq;
      unfold R_dist. pose proof (Far (p - m)%nat m) as A; pose proof (Far (q - m)%nat m) as B;
      replace (m + (p - m))%nat with p in A by lia; replace (m + (q - m))%nat with q in B by lia.
    assert (0 <= C * (/ 2) ^ p) by (apply Rmult_le_pos; auto);
      assert (0 <= C * (/ 2) ^ q) by (apply Rmult_le_pos; auto).
    replace (s p - s q) with ((s p - s m) - (s q - s m)) by ring; eapply Rle_lt_trans; [apply apart | lra]. }
  destruct (R_complete s Cc) as [l Hl]; exists l; split; [exact Hl|]; intros n; apply le_epsilon; intros e He.
  destruct (Hl e He) as [j Hj]; specialize (Hj (n + j)%nat ltac:(lia)); unfold R_dist in Hj;
    rewrite Rabs_minus_sym in Hj; pose proof (Far j n) as A.
  assert (0 <= C * (/ 2) ^ (n + j)) by (apply Rmult_le_pos; auto).
  replace (l - s n) with ((l - s (n + j)%nat) + (s (n + j)%nat - s n)) by ring; eapply Rle_trans;
    [apply Rabs_triang | lra].
Qed.

Section Picard.
Variables (F : R -> R -> R -> R) (L p r A : R).
Hypothesis HL : 0 <= L.
Hypothesis Flip : forall t y v y' v', Rabs (F t y v - F t y' v') <= L * (Rabs (y - y') + Rabs (v - v')).
Hypothesis Fcont : forall t y v, continuity_pt (fun t => F t y v) t.
Hypothesis Fbound : forall t, Rabs (F t p r) <= A.
Let K := 2 * (1 + L).
Notation W := (W K).

Lemma F_path y v : (forall t, continuity_pt y t) -> (forall t, continuity_pt v t) -> forall t,
  continuity_pt (fun t => F t (y t) (v t)) t.
Proof.
  intros Cy Cv t e He;
    destruct (continuous_near y t (e / (4 * (L + 1))) (Cy t) ltac:(apply Rdiv_lt_0_compat; lra)) as (d1 & D1 & H1).
  destruct (continuous_near v t (e / (4 * (L + 1))) (Cv t) ltac:(apply Rdiv_lt_0_compat; lra)) as (d2 & D2 & H2).
  destruct (continuous_near (fun s => F s (y t) (v t)) t (e / 4) (Fcont t _ _) ltac:(lra)) as (d3 & D3 & H3).
  destruct (two_least d1 d2 D1 D2) as (d4 & D4 & L1 & L2), (two_least d4 d3 D4 D3) as (d & Hd & L3 & L4); exists d;
    split; [exact Hd|]. intros s [_ Hs]; cbn in *; unfold R_dist in *; specialize (H1 s ltac:(lra));
    specialize (H2 s ltac:(lra)); specialize (H3 s ltac:(lra)). pose proof (Flip s (y s) (v s) (y t) (v t)) as Q;
    replace (F s (y s) (v s) - F t (y t) (v t))
      with ((F s (y s) (v s) - F s (y t) (v t)) + (F s (y t) (v t) - F t (y t) (v t))) by ring. eapply Rle_lt_trans;
    [apply Rabs_triang|]; assert (L * (Rabs (y s - y t) + Rabs (v s - v t)) <= (L + 1) * (2 * (e / (4 * (L + 1))))).
  { apply Rmult_le_compat; try lra; pose proof (Rabs_pos (y s - y t)); pose proof (Rabs_pos (v s - v t)); lra. }
  replace ((L + 1) * (2 * (e / (4 * (L + 1))))) with (e / 2) in * by (field; lra); lra.
Qed.

Fixpoint it (n : nat) : (R -> R) * (R -> R) := match n with O => (fun _ => p, fun _ => r) | S n =>
  (fun t => p + prim (snd (it n)) t, fun t => r + prim (fun t => F t (fst (it n) t) (snd (it n) t)) t) end.
Notation y n := (fst (it n)).
Notation v n := (snd (it n)).
Lemma it_spec n : (forall t, continuity_pt (y n) t) /\ (forall t, continuity_pt (v n) t) /\ y n 0 = p /\ v n 0 = r /\
  forall t, derivable_pt_lim (y (S n)) t (v n t) /\ derivable_pt_lim (v (S n)) t (F t (y n t) (v n t)).
Proof.
  assert (Next : forall n, (forall t, continuity_pt (y n) t) -> (forall t, continuity_pt (v n) t) -> y (S n) 0 = p /\
    v (S n) 0 = r /\ forall t, derivable_pt_lim (y (S n)) t (v n t) /\
    derivable_pt_lim (v (S n)) t (F t (y n t) (v n t))).
  { intros m Cy Cv; destruct (prim_spec _ Cv) as [P1 P2], (prim_spec _ (F_path _ _ Cy Cv)) as [P3 P4]; cbn [it fst snd];
      split; [lra | split; [lra|]]; intros t. split;
      (eapply D_value; [apply D_plus; [apply D_const | first [apply P2 | apply P4]] | ring]). }
  induction n as [|n (Cy & Cv & _)].
  - assert (C : forall c t, continuity_pt (fun _ : R => c) t) by (intros c t; apply (D_continuous _ 0), D_const). split;
      [exact (C p) | split; [exact (C r) | split; [reflexivity | split; [reflexivity|]]]]; apply (Next 0%nat);
      [exact (C p) | exact (C r)].
  - destruct (Next n Cy Cv) as (Z1 & Z2 & Dn);
      assert (Cy' : forall t, continuity_pt (y (S n)) t) by (intros t; apply (D_continuous _ _ _ (proj1 (Dn t)))).
    assert (Cv' : forall t, continuity_pt (v (S n)) t) by (intros t; apply (D_continuous _ _ _ (proj2 (Dn t)))). split;
      [exact Cy' | split; [exact Cv' | split; [exact Z1 | split; [exact Z2|]]]]; apply (Next (S n) Cy' Cv').
Qed.
Let c := Rabs r + A.
Lemma c_pos : 0 <= A /\ 0 <= c /\ 0 < K.
Proof. pose proof (Rabs_pos r); pose proof (Rabs_pos (F 0 p r)); pose proof (Fbound 0); unfold c, K; lra. Qed.
Lemma steps n t : Rabs (y (S n) t - y n t) <= c * (/ 2) ^ n * W t /\ Rabs (v (S n) t - v n t) <= c * (/ 2) ^ n * W t.
Proof.
  destruct c_pos as (HA & Hc & HK); revert t.
  assert (H : forall t, Rabs (y (S n) t - y n t) <= c * (/ 2) ^ n / K * W t /\ Rabs (v (S n) t - v n t) <=
    (1 + L) * c * (/ 2) ^ n / K * W t).
  { induction n as [|n IH]; intros t.
    - destruct (it_spec 0) as (_ & _ & _ & _ & D); destruct (it_spec 1) as (_ & _ & Y1 & V1 & _); cbn [pow];
        rewrite !Rmult_1_r; pose proof (Rabs_pos r). split;
        [apply (grows K HK (fun t => y 1 t - y 0 t) (fun t => v 0 t)) |
          apply (grows K HK (fun t => v 1 t - v 0 t) (fun t => F t (y 0 t) (v 0 t)))].
      + exact Hc.
      + rewrite Y1; cbn; ring.
      + intros s; split; [eapply D_value; [apply D_minus; [apply D | exact (D_const p s)] | ring]|]; cbn;
          pose proof (W_large K s); apply Rle_trans with (c * 1); [unfold c; lra | apply Rmult_le_compat_l; lra].
      + apply Rmult_le_pos; lra.
      + rewrite V1; cbn; ring.
      + intros s; split; [eapply D_value; [apply D_minus; [apply D | exact (D_const r s)] | ring]|]; cbn;
          pose proof (W_large K s); pose proof (Fbound s). assert (0 <= L * c) by (apply Rmult_le_pos; lra);
          apply Rle_trans with ((1 + L) * c * 1); [unfold c in *; lra | apply Rmult_le_compat_l; lra].
    - destruct (it_spec n) as (_ & _ & Z1 & Z2 & D), (it_spec (S n)) as (_ & _ & Z3 & Z4 & D'), (it_spec (S (S n)))
        as (_ & _ & Z5 & Z6 & _). assert (Q : 0 <= (/ 2) ^ n) by (apply pow_le; lra);
        assert (cq : 0 <= c * (/ 2) ^ n) by (apply Rmult_le_pos; assumption). set (k := c * (/ 2) ^ n) in *;
        assert (Ek : c * (/ 2) ^ S n = k / 2) by (unfold k; cbn [pow]; field); rewrite Rmult_assoc, Ek.
      assert (IH' : forall s, Rabs (y (S n) s - y n s) <= k / K * W s /\ Rabs (v (S n) s - v n s) <=
        (1 + L) * k / K * W s).
      { intros s; destruct (IH s) as [I1 I2]; rewrite (Rmult_assoc (1 + L)) in I2; fold k in I2; auto. }
      assert (E2 : (1 + L) * k / K = k / 2) by (unfold K; field; lra);
        assert (Lk : 0 <= L * k) by (apply Rmult_le_pos; lra).
      assert (E1 : L * (k / K) + L * (k / 2) <= (1 + L) * (k / 2)).
      { assert (k / K * K = k) by (field; lra);
          assert (0 <= k / K) by (apply Rmult_le_pos; [exact cq | left; apply Rinv_0_lt_compat, HK]);
          unfold K in H at 2; assert (L * (k / K) <= k / 2); [|lra].
        assert (0 <= L * (k / K)) by (apply Rmult_le_pos; lra); lra. }
      split;
        [apply (grows K HK (fun t => y (S (S n)) t - y (S n) t) (fun t => v (S n) t - v n t)) |
          apply (grows K HK (fun t => v (S (S n)) t - v (S n) t) (fun t => F t (y (S n) t) (v (S n) t) -
          F t (y n t) (v n t)))].
      + lra.
      + rewrite Z5, Z3; ring.
      + intros s; split; [apply D_minus; [apply D' | apply D]|]; destruct (IH' s) as [_ I2]; rewrite E2 in I2; exact I2.
      + apply Rmult_le_pos; lra.
      + rewrite Z6, Z4; ring.
      + intros s; split; [apply D_minus; [apply D' | apply D]|]; destruct (IH' s) as [I1 I2]; rewrite E2 in I2;
          pose proof (W_large K s). eapply Rle_trans; [apply Flip|];
          apply Rle_trans with ((L * (k / K) + L * (k / 2)) * W s); [|apply Rmult_le_compat_r; lra].
        apply Rle_trans with (L * (k / K * W s + k / 2 * W s)); [apply Rmult_le_compat_l; lra | right; ring]. }
  intros t; destruct (H t) as [I1 I2]; pose proof (W_large K t);
    assert (cq : 0 <= c * (/ 2) ^ n) by (apply Rmult_le_pos; [exact Hc | apply pow_le; lra]);
    set (k := c * (/ 2) ^ n) in *. split; (eapply Rle_trans; [eassumption|]; apply Rmult_le_compat_r; [lra|]).
  - apply Rmult_le_reg_r with K; [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra;
      assert (k * 1 <= k * K) by (apply Rmult_le_compat_l; [lra | unfold K; lra]); lra.
  - rewrite Rmult_assoc; fold k; replace ((1 + L) * k / K) with (k / 2) by (unfold K; field; lra); lra.
Qed.

Definition yl t := the (Un_cv (fun n => y n t)).
Definition vl t := the (Un_cv (fun n => v n t)).
Lemma limits n t : Rabs (yl t - y n t) <= 2 * c * W t * (/ 2) ^ n /\ Rabs (vl t - v n t) <= 2 * c * W t * (/ 2) ^ n.
Proof.
  destruct c_pos as (HA & Hc & HK); pose proof (W_large K t); assert (P : 0 <= c * W t) by (apply Rmult_le_pos; lra).
  destruct (limit (fun n => y n t) (c * W t) P ltac:(intros m; replace (c * W t * (/ 2) ^ m) with (c * (/ 2) ^ m * W t)
    by ring; apply steps)) as (l1 & U1 & Q1).
  destruct (limit (fun n => v n t) (c * W t) P ltac:(intros m; replace (c * W t * (/ 2) ^ m) with (c * (/ 2) ^ m * W t)
    by ring; apply steps)) as (l2 & U2 & Q2). unfold yl, vl;
    rewrite (the_spec _ l1 U1) by (intros z Hz; apply (UL_sequence _ _ _ Hz U1));
    rewrite (the_spec _ l2 U2) by (intros z Hz; apply (UL_sequence _ _ _ Hz U2)). specialize (Q1 n); specialize (Q2 n);
    cbv beta in Q1, Q2; split; lra.
Qed.
Lemma uniform s f : (forall n t, continuity_pt (f n) t) -> (forall n t, Rabs (s t - f n t) <= 2 * c * W t * (/ 2) ^ n)
  -> forall t : R, continuity_pt s t.
Proof.
  intros C H t e He; destruct c_pos as (HA & Hc & HK); set (B := 2 * exp (K * (Rabs t + 1))).
  assert (Wb : forall u, Rabs (u - t) <= 1 -> W u <= B).
  { intros u Hu;
      assert (Rabs u <= Rabs t + 1) by (replace u with (t + (u - t)) by ring; eapply Rle_trans;
        [apply Rabs_triang | lra]); apply le_abs in H0.
    assert (M : forall q, q <= K * (Rabs t + 1) -> exp q <= exp (K * (Rabs t + 1))) by (intros q [Q| ->];
      [left; apply exp_increasing, Q | lra]). assert (K * u <= K * (Rabs t + 1)) by (apply Rmult_le_compat_l; lra);
      assert (K * - u <= K * (Rabs t + 1)) by (apply Rmult_le_compat_l; lra). pose proof (M (K * u) ltac:(lra));
      pose proof (M (- K * u) ltac:(lra)); unfold NonlinearPicard.W, B; lra. }
  destruct (powers_small (/ 2) (2 * c * B) (e / 4) ltac:(lra) ltac:(lra)) as [n Hn].
  destruct (continuous_near (f n) t (e / 4) (C n t) ltac:(lra)) as (d1 & D1 & N);
    destruct (two_least d1 1 D1 ltac:(lra)) as (d & Hd & L1 & L2). exists d; split; [exact Hd|]; intros u [_ Hu];
    cbn in *; unfold R_dist in *; specialize (N u ltac:(lra)).
  assert (Q : forall u, Rabs (u - t) <= 1 -> Rabs (s u - f n u) <= e / 4).
  { intros x Hx; eapply Rle_trans; [apply H|]; assert (2 * c * W x * (/ 2) ^ n <= 2 * c * B * (/ 2) ^ n); [|lra].
    apply Rmult_le_compat_r; [apply pow_le; lra | apply Rmult_le_compat_l; [lra | apply Wb, Hx]]. }
  pose proof (Q u ltac:(lra)) as Q1; pose proof (Q t ltac:(rewrite Rminus_eq_0, Rabs_R0; lra)) as Q2;
    rewrite Rabs_minus_sym in Q2. replace (s u - s t) with ((s u - f n u) + ((f n u - f n t) + (f n t - s t))) by ring.
  eapply Rle_lt_trans; [apply Rabs_triang|]; eapply Rle_lt_trans; [apply Rplus_le_compat_l, Rabs_triang | lra].
Qed.
Theorem picard0 : (forall t, derivable_pt_lim yl t (vl t) /\ derivable_pt_lim vl t (F t (yl t) (vl t))) /\ yl 0 = p /\
  vl 0 = r.
Proof.
  destruct c_pos as (HA & Hc & HK).
  assert (Cy : forall t, continuity_pt yl t) by (apply (uniform yl (fun n => y n));
    [intros n; apply it_spec | intros n t; apply limits]).
  assert (Cv : forall t, continuity_pt vl t) by (apply (uniform vl (fun n => v n));
    [intros n; apply it_spec | intros n t; apply limits]).
  destruct (prim_spec _ Cv) as [P1 P2], (prim_spec _ (F_path _ _ Cy Cv)) as [P3 P4].
  (* what has the derivative of the limit, and its value at 0, is the limit *)
  assert (Same : forall (s : R -> R) (f : nat -> R -> R) (s' : R -> R) (f' : nat -> R -> R) q,
    (forall t, derivable_pt_lim s t (s' t)) -> (forall n t, derivable_pt_lim (f (S n)) t (f' n t)) ->
    (forall n, f (S n) 0 = s 0) -> 0 <= q -> (forall n t, Rabs (s' t - f' n t) <= q * (/ 2) ^ n * W t) ->
    forall (g : R -> R), (forall n t, Rabs (g t - f n t) <= 2 * c * W t * (/ 2) ^ n) -> forall t, g t = s t).
  { intros s f s' f' q Ds Df Z Hq Hd g Hg t;
      apply Rminus_diag_uniq, Rabs_zero, (squeezed (/ 2) _ 0 (2 * c * W t + q / K * W t)); [lra|]; intros n.
    pose proof (Hg (S n) t) as G; assert (Qn : 0 <= (/ 2) ^ n) by (apply pow_le; lra); pose proof (W_large K t) as Wt.
    pose proof (grows K HK (fun t => s t - f (S n) t) (fun t => s' t - f' n t) (q * (/ 2) ^ n) ltac:(apply Rmult_le_pos;
      assumption) ltac:(cbv beta; rewrite Z; ring) ltac:(intros u; split; [apply D_minus; [apply Ds | apply Df] |
      apply Hd]) t) as E; cbv beta in E. replace (g t - s t) with ((g t - f (S n) t) - (s t - f (S n) t)) by ring;
      eapply Rle_trans; [apply apart|].
    replace (q * (/ 2) ^ n / K * W t) with (q / K * W t * (/ 2) ^ n) in E by (field; lra); cbn [pow] in G.
    assert (0 <= 2 * c * W t * (/ 2) ^ n) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | exact Qn]); lra. }
  assert (Ey : forall t, yl t = p + prim vl t).
  { apply (Same (fun t => p + prim vl t) (fun n => y n) vl (fun n => v n) (2 * c)).
    - intros t; eapply D_value; [apply D_plus; [apply D_const | apply P2] | ring].
    - intros n t; apply it_spec.
    - intros n; rewrite P1; destruct (it_spec (S n)) as (_ & _ & -> & _); ring.
    - lra.
    - intros n t; destruct (limits n t) as [_ Q]; lra.
    - intros n t; apply limits. }
  assert (Ev : forall t, vl t = r + prim (fun t => F t (yl t) (vl t)) t).
  { apply (Same (fun t => r + prim (fun t => F t (yl t) (vl t)) t) (fun n => v n) (fun t => F t (yl t) (vl t))
      (fun n t => F t (y n t) (v n t)) (L * (4 * c))).
    - intros t; eapply D_value; [apply D_plus; [apply D_const | apply P4] | ring].
    - intros n t; apply it_spec.
    - intros n; rewrite P3; destruct (it_spec (S n)) as (_ & _ & _ & -> & _); ring.
    - apply Rmult_le_pos; lra.
    - intros n t; destruct (limits n t) as [Q Q']; eapply Rle_trans; [apply Flip|]; rewrite !Rmult_assoc;
        apply Rmult_le_compat_l; lra.
    - intros n t; apply limits. }
  split; [|rewrite Ey, Ev, P1, P3; lra]; intros t; split.
  - eapply D_ext;
      [apply (D_plus (fun _ => p) (prim vl)); [apply D_const | apply P2] | intros u; symmetry; apply Ey | ring].
  - eapply D_ext;
      [apply (D_plus (fun _ => r) (prim (fun t => F t (yl t) (vl t)))); [apply D_const | apply P4] | intros u; symmetry;
        apply Ev | ring].
Qed.
End Picard.

Theorem picard (F : R -> R -> R -> R) L : 0 <= L -> (forall t y v y' v', Rabs (F t y v - F t y' v') <=
  L * (Rabs (y - y') + Rabs (v - v'))) ->
  (forall t y v, continuity_pt (fun t => F t y v) t) -> (forall y v, exists A, forall t, Rabs (F t y v) <= A) ->
  forall s p r, exists y v, (forall t, derivable_pt_lim y t (v t) /\ derivable_pt_lim v t (F t (y t) (v t))) /\
    y s = p /\ v s = r.
Proof.
  intros HL Hlip Hc Hb s p r; destruct (Hb p r) as [A HA]; set (G t y v := F (t + s) y v).
  assert (Gc : forall t y v, continuity_pt (fun t => G t y v) t).
  { intros t y v; apply (continuity_pt_comp (fun t => t + s) (fun t => F t y v)); [|apply Hc]. apply (D_continuous _ 1);
      eapply D_value; [apply D_plus; [apply D_id | apply D_const] | ring]. }
  destruct (picard0 G L p r A HL (fun t => Hlip (t + s)) Gc (fun t => HA (t + s))) as (H & E & E').
  set (Y := yl G p r) in *; set (V := vl G p r) in *; exists (fun t => Y (t - s)), (fun t => V (t - s)); split;
    [|replace (s - s) with 0 by ring; auto]. intros t; destruct (H (t - s)) as [D1 D2]; unfold G in D2;
    replace (t - s + s) with t in D2 by ring. split;
    (eapply D_value; [apply (D_of (fun t => t - s)); [apply D_shift | eassumption] | ring]).
Qed.
