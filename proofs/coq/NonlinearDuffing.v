(** * Duffing's oscillator with numbers: the equation linearized along its orbit in a frame that turns with that of the
      linear oscillator, where Gronwall's inequality loses little *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import Defs Derivatives Headline Systems StatementOscillator StatementNonlinear StatementStops
  StatementNonlinearExamples NonlinearGronwall NonlinearStops NonlinearTube NonlinearGeneric NonlinearExamples.
Open Scope R_scope.

(** From s on for one period: w' = - y / 16 + r (y + m), |r| <= 1 / 1200, where y / 4 and w turn by a quarter if r = 0. *)
Section Turn.
Variables (y w k : R -> R) (s m B : R).
Hypothesis Hk : forall t, Rabs (k t + 1 / 16) <= 1 / 1200.
Hypothesis Hyw : forall t, derivable_pt_lim y t (w t) /\ derivable_pt_lim w t (k t * (y t + m) + m / 16).
Hypothesis HB : 0 <= B /\ y s * y s + 16 * (w s * w s) + m * m <= B * B.
Let c x := cos (1 / 4 * x). Let d x := sin (1 / 4 * x). Let Y x := y (s + x). Let V x := w (s + x).
Let z x := Y x + m. Let r x := k (s + x) + 1 / 16.
Let p x := c x * Y x - 4 * (d x * V x). Let q x := d x * Y x + 4 * (c x * V x).
Lemma frame x : derivable_pt_lim p x (- (4 * (d x * (r x * z x)))) /\ derivable_pt_lim q x (4 * (c x * (r x * z x))).
Proof.
  destruct (Hyw (s + x)) as [A B0]; assert (Dc : derivable_pt_lim c x (- (1 / 4 * d x))) by (unfold c, d; derive_by fail;
    ring); assert (Dd : derivable_pt_lim d x (1 / 4 * c x)) by (unfold c, d; derive_by fail; ring).
  pose proof (D_on _ _ _ _ A) as DY; pose proof (D_on _ _ _ _ B0) as DV; split; (eapply D_value; [unfold p, q; first [apply
    D_minus | apply D_plus]; [apply D_times; [exact Dc || exact Dd | exact DY] | apply D_scale, D_times; [exact Dc || exact Dd
    | exact DV]] | unfold z, r, Y, V; cbv beta; field]).
Qed.
Lemma unit x : c x * c x + d x * d x = 1.
Proof. pose proof (sin2_cos2 (1 / 4 * x)) as H; unfold Rsqr in H; unfold c, d; lra. Qed.
Let E x := p x * p x + q x * q x + m * m.
Lemma stays x : 0 <= x <= 8 -> z x * z x <= 4 * (B * B).
Proof.
  intros Hx; set (E' x := 8 * (r x * (z x * (q x * c x - p x * d x)))).
  assert (Yp : forall x, Y x = c x * p x + d x * q x) by (intros u; unfold p, q; replace (Y u) with ((c u * c u + d u * d u) *
    Y u) at 1 by (rewrite unit; ring); ring).
  assert (Sq : forall x, p x * p x + q x * q x = Y x * Y x + (q x * c x - p x * d x) * (q x * c x - p x * d x)).
  { intros u; rewrite Yp; replace (p u * p u + q u * q u) with ((c u * c u + d u * d u) * (p u * p u + q u * q u)) by
      (rewrite unit; ring); ring. }
  assert (Z2 : forall x, z x * z x <= 2 * (Y x * Y x + m * m)) by (intros u; unfold z; pose proof (Rle_0_sqr (Y u - m)) as H;
    unfold Rsqr in H; lra).
  assert (D : forall x, derivable_pt_lim E x (E' x)).
  { intros u; destruct (frame u) as [A B0]; eapply D_value; [apply D_plus; [apply D_plus; apply D_times; eassumption | apply
      D_const] | unfold E'; ring]. }
  assert (G : E x + 0 / (8 / 1200) <= (E 0 + 0 / (8 / 1200)) * exp (8 / 1200 * x)).
  { apply (gronwall E E' (8 / 1200) 0 8); [lra | intros u _; apply D | | exact Hx]; intros u _; unfold E'.
    set (S := q u * c u - p u * d u) in *; assert (ZS : Rabs (z u * S) <= E u).
    { specialize (Z2 u); specialize (Sq u); fold S in Sq; pose proof (Rle_0_sqr (z u + S)) as H1; pose proof (Rle_0_sqr (z u -
        S)) as H2; unfold Rsqr in H1, H2; pose proof (Rle_0_sqr S) as H3; unfold Rsqr in H3; unfold E; apply Rabs_le; lra. }
    pose proof (product (r u) _ _ _ (Hk (s + u)) ZS) as Q; apply le_abs in Q; lra. }
  assert (X : exp (8 / 1200 * x) <= 2).
  { pose proof (exp_ineq1_le (- (8 / 1200 * x))) as H; rewrite exp_Ropp in H; pose proof (exp_pos (8 / 1200 * x)) as P; apply
      (Rmult_le_compat_r _ _ _ (Rlt_le _ _ P)) in H; rewrite Rinv_l in H by lra; set (ex := exp (8 / 1200 * x)) in *; assert
      (1 / 2 * ex <= (1 + - (8 / 1200 * x)) * ex) by (apply Rmult_le_compat_r; lra); lra. }
  assert (E0 : E 0 = y s * y s + 16 * (w s * w s) + m * m).
  { unfold E, p, q, c, d, Y, V; rewrite Rmult_0_r, cos_0, sin_0, Rplus_0_r; ring. }
  assert (E 0 <= B * B /\ 0 <= E 0) as [L1 L2] by (rewrite E0; pose proof (Rle_0_sqr (y s)); pose proof (Rle_0_sqr (w s)); pose
    proof (Rle_0_sqr m); unfold Rsqr in *; lra). pose proof (Rmult_le_compat_l (E 0) _ _ L2 X); specialize (Z2 x); specialize
    (Sq x); pose proof (Rle_0_sqr (q x * c x - p x * d x)) as H3; unfold Rsqr in H3; unfold E in *; lra.
Qed.
Lemma turn : Rabs (4 * w (s + 2 * PI) + y s) <= 4 / 75 * B /\ Rabs (y (s + 2 * PI) - 4 * w s) <= 4 / 75 * B.
Proof.
  pose proof PI_RGT_0; pose proof PI_4; assert (Z : forall x, 0 <= x <= 8 -> Rabs (z x) <= 2 * B) by (intros x Hx; rewrite <-
    (Rabs_pos_eq (2 * B)) by lra; apply Rsqr_le_abs_0; unfold Rsqr; pose proof (stays x Hx); lra).
  assert (Bd : forall f x, Rabs (f x) <= 1 -> 0 <= x <= 8 -> Rabs (4 * (f x * (r x * z x))) <= B / 150).
  { intros f x Hf Hx; pose proof (product (f x) _ _ _ Hf (product (r x) _ _ _ (Hk (s + x)) (Z x Hx))) as Q; pose proof (product 4
      _ 4 _ ltac:(rewrite Rabs_pos_eq; lra) Q); lra. }
  assert (P : forall x, 0 <= x <= 8 -> Rabs (- (4 * (d x * (r x * z x)))) <= B / 150) by (intros x Hx; rewrite Rabs_Ropp; apply
    Bd; [pose proof (SIN_bound (1 / 4 * x)); apply Rabs_le; unfold d; lra | exact Hx]).
  assert (Q : forall x, 0 <= x <= 8 -> Rabs (4 * (c x * (r x * z x))) <= B / 150) by (intros x Hx; apply Bd; [pose proof
    (COS_bound (1 / 4 * x)); apply Rabs_le; unfold c; lra | exact Hx]).
  pose proof (mvt_on 8 p _ (B / 150) (2 * PI) 0 ltac:(lra) ltac:(lra) (fun x Hx => conj (proj1 (frame x)) (P x Hx))) as M1; pose
    proof (mvt_on 8 q _ (B / 150) (2 * PI) 0 ltac:(lra) ltac:(lra) (fun x Hx => conj (proj2 (frame x)) (Q x Hx))) as M2.
  rewrite Rminus_0_r, (Rabs_pos_eq (2 * PI)) in M1, M2 by lra; unfold p, q, c, d, Y, V in M1, M2; replace (1 / 4 * (2 * PI)) with
    (PI / 2) in M1, M2 by field; rewrite Rmult_0_r, cos_0, sin_0, cos_PI2, sin_PI2, Rplus_0_r in M1, M2.
  assert (B / 150 * (2 * PI) <= B / 150 * 8) by (apply Rmult_le_compat_l; lra); split; [rewrite <- Rabs_Ropp|]; match goal with |-
    Rabs ?u <= _ => first [replace u with (0 * y (s + 2 * PI) - 4 * (1 * w (s + 2 * PI)) - (1 * y s - 4 * (0 * w s))) by ring |
    replace u with (1 * y (s + 2 * PI) + 4 * (0 * w (s + 2 * PI)) - (0 * y s + 4 * (1 * w s))) by ring] end; lra.
Qed.
End Turn.

Theorem Duffing : Duffing_statement.
Proof.
  intros M W t0 s A tau HS HM HA Ht O; pose proof PI_RGT_0 as HP; assert (HO : grazing_orbit O) by (apply measured_grazes,
    driven_grazes; [exact HS | lra | exact Ht]).
  pose proof (driven_along M W t0 s A 0 (1 / 16) 1 0 0 0 tau) as Al; cbv zeta in Al; fold O in Al; set (k := along O
    (Nonlinear.a_y O)) in *.
  assert (Hk : forall t, Rabs (k t + 1 / 16) <= 1 / 1200).
  { intros t; destruct (Al t) as [-> _]; pose proof (HM t) as Mt; set (x := A * M 0%nat t); assert (Bx : Rabs x <= 1 / 60) by
      (unfold x; pose proof (product A _ (1 / 60) 1 ltac:(rewrite Rabs_pos_eq; lra) Mt); lra). pose proof (product _ _ _ _ Bx
      Bx) as Q; apply le_abs in Q; apply Rabs_le; lra. }
  assert (Hkc : forall t, Rabs (k t) <= 1 /\ Rabs (along O (Nonlinear.a_v O) t) <= 1).
  { intros t; specialize (Hk t); apply le_abs in Hk; destruct (Al t) as (_ & -> & _); split; apply Rabs_le; lra. }
  destruct (linear_solutions O HO 0 (Nonlinear.tG O) 1 0) as (z1 & w1 & S1), (linear_solutions O HO 0 (Nonlinear.tG O) 0 1) as
    (z2 & w2 & S2), (linear_solutions O HO 1 (Nonlinear.tG O) 0 0) as (z3 & w3 & S3).
  pose proof (generic_of O 1 z1 w1 z2 w2 z3 w3 HO (Rle_refl 1) Hkc S1 S2 S3) as G; cbv zeta in G.
  assert (L : forall m z w B, linearized O m z w -> 0 <= B -> let x := z t0 - 16 * sgn s * m in x * x + 16 * (w t0 * w t0) + 16 *
    sgn s * m * (16 * sgn s * m) <= B * B -> Rabs (4 * w (t0 + 2 * PI) + x) <= 4 / 75 * B /\ Rabs (z (t0 + 2 * PI) - 16 * sgn s *
    m - 4 * w t0) <= 4 / 75 * B).
  { intros m z w B Hz HB x Hx; apply (turn (fun t => z t - 16 * sgn s * m) w k t0 (16 * sgn s * m) B Hk); [|split; assumption].
    intros t; destruct (Hz t) as [D1 D2], (Al t) as (_ & K2 & K3); rewrite K2, K3 in D2; fold k in D2; split; [eapply D_value;
      [apply D_minus; [exact D1 | apply D_const] | ring] | eapply D_value; [exact D2 | unfold k; field]]. }
  change (Nonlinear.tG O) with t0 in *; change (Nonlinear.T O) with (2 * PI) in *.
  destruct S1 as (S1 & I1 & J1), S2 as (S2 & I2 & J2), S3 as (S3 & I3 & J3).
  pose proof (L 0 z1 w1 1 S1 ltac:(lra)) as N1; pose proof (L 0 z2 w2 4 S2 ltac:(lra)) as N2; pose proof (L 1 z3 w3 23 S3
    ltac:(lra)) as N3; cbv zeta in N1, N2, N3; rewrite I1, J1 in N1; rewrite I2, J2 in N2; rewrite I3, J3 in N3.
  rewrite Rmult_0_r in N1, N2; assert (Ss : sgn s * sgn s = 1) by (destruct s; cbn; ring).
  destruct N1 as [A1 A2]; [lra|]; destruct N2 as [A3 A4]; [lra|]; destruct N3 as [A5 A6]; [replace (16 * sgn s * 1 * (16 * sgn s *
    1)) with (256 * (sgn s * sgn s)) by ring; replace ((0 - 16 * sgn s * 1) * (0 - 16 * sgn s * 1)) with (256 * (sgn s * sgn s))
    by ring; rewrite Ss; lra|].
  set (t1 := t0 + 2 * PI) in *; set (a1 := z1 t1 + w2 t1) in *; set (a2 := z1 t1 * w2 t1 - w1 t1 * z2 t1) in *.
  rewrite <- (sgn_abs s) in A5, A6; replace (sgn s * (4 * w3 t1 + (0 - 16 * sgn s * 1))) with (4 * (sgn s * w3 t1) - 16) in A5 by
    (destruct s; cbn; ring); replace (sgn s * (z3 t1 - 16 * sgn s * 1 - 4 * 0)) with (sgn s * z3 t1 - 16) in A6 by (destruct s; cbn;
    ring).
  apply le_abs in A1, A2, A3, A4, A5, A6; set (x3 := sgn s * z3 t1) in *; set (y3 := sgn s * w3 t1) in *.
  assert (Ha1 : Rabs a1 <= 11 / 100) by (unfold a1; apply Rabs_le; lra).
  assert (Ha2 : Rabs (a2 - 1) <= 12 / 100).
  { pose proof (product (z1 t1) (w2 t1) (1 / 18) (1 / 18) ltac:(apply Rabs_le; lra) ltac:(apply Rabs_le; lra)) as Q1; pose proof
      (product (w1 t1 + 1 / 4) (z2 t1 - 4) (1 / 74) (16 / 74) ltac:(apply Rabs_le; lra) ltac:(apply Rabs_le; lra)) as Q2; apply
      le_abs in Q1, Q2; unfold a2; apply Rabs_le; lra. }
  assert (Hg : Rabs (z2 t1 - 4) <= 22 / 100) by (apply Rabs_le; lra); apply le_abs in Ha1 as B1; apply le_abs in Ha2 as B2.
  set (num := (1 - w2 t1) * x3 + z2 t1 * y3); assert (Hn : 27 <= num <= 37).
  { pose proof (product (w2 t1) (x3 - 16) (1 / 18) (124 / 100) ltac:(apply Rabs_le; lra) ltac:(apply Rabs_le; lra)) as Q1; pose
      proof (product (z2 t1 - 4) (y3 - 4) (16 / 74) (31 / 100) ltac:(apply Rabs_le; lra) ltac:(apply Rabs_le; lra)) as Q2; apply
      le_abs in Q1, Q2; unfold num; lra. }
  set (D := 1 - a1 + a2) in *; assert (HD : 177 / 100 <= D <= 223 / 100) by (unfold D; lra).
  set (rate := ((1 - w2 t1) * z3 t1 + z2 t1 * w3 t1) / D) in *; assert (Er : sgn s * rate = num / D) by (unfold rate, num, x3, y3;
    field; lra).
  assert (Hr : 12 <= sgn s * rate <= 21) by (rewrite Er; split; apply (Rmult_le_reg_r D); try lra; unfold Rdiv; rewrite Rmult_assoc,
    Rinv_l by lra; lra).
  assert (HG : generic O a1 a2 (z2 t1) rate) by (apply G; [lra | first [lra | unfold D in HD; lra] |
    intros Z; rewrite Z, Rmult_0_r in Hr; lra]).
  exists a1, a2, (z2 t1), rate; split; [exact HG | split; [exact Ha1 | split; [exact Ha2 | split; [exact Hg | split; [exact Hr|]]]]].
  assert (Q1 : 0 <= a1 * a1 <= 2 / 100) by (pose proof (product _ _ _ _ Ha1 Ha1) as Q; apply le_abs in Q; pose proof (Rle_0_sqr a1)
    as Q0; unfold Rsqr in Q0; lra). assert (Q2 : Rabs (a1 * a2) <= 13 / 100) by (pose proof (product a1 a2 (11 / 100) (112 / 100)
    Ha1 ltac:(apply Rabs_le; lra)); lra).
  assert (Q3 : 0 <= a2 * a2) by apply Rle_0_sqr. apply le_abs in Q2. assert (U3 : u a1 a2 3%nat = a1 * a1 - a2) by (cbn; ring).
  assert (Neg : forall p q, p < 0 -> q < 0 -> 1 * (p / q) > 0) by (intros p q Hp Hq; rewrite Rmult_1_l; unfold Rdiv; pose proof
    (Rinv_lt_0_compat q Hq); nra).
  apply (Single (Moves O rate) a1 a2 (z2 t1) 3%nat Plus Plus); [split; assumption | lia | rewrite U3; lra | cbn; lra|].
  split; [rewrite U3; lra | split].
  - intros j Hj; unfold b; apply Neg; [|rewrite U3; lra]; destruct j as [|[|[|j]]]; try lia; cbn; lra.
  - unfold c; rewrite Rmult_1_r. assert (Cu : 0 <= a2 * (a2 * a2)) by (apply Rmult_le_pos; lra). assert (Q4 : Rabs (a1 * (a1 * a1))
      <= 1 / 100) by (pose proof (product a1 (a1 * a1) (11 / 100) (2 / 100) Ha1 ltac:(apply Rabs_le; lra)); lra). apply le_abs in
      Q4. apply Neg; [|rewrite U3; lra]; unfold v; cbn; lra.
Qed.
