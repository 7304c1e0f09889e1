(** * The windows of stable orbits with one impact *)
From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import StatementPlane.
From Grazing Require Import StatementAttractor AttractorAlgebra AttractorDerivative AttractorOrbit
  AttractorGaps.
Open Scope R_scope.

Section Orbit.
Variables l1 l2 b nu d y : R.
Variable n : nat.
Hypothesis Hl : 0 < l2 < l1.
Hypothesis Hl1 : l1 < 1.
Hypothesis Hb : 0 < b.
Hypothesis Hn : (1 <= n)%nat.
Let L := l1 ^ n.
Let K := l2 ^ n.
Let La := b * (L - K) / ((1 - L) * (1 - K)).
Hypothesis HLK : 0 < K < L.
Hypothesis HL : L < 1.
Hypothesis Hy : 0 < y.
Hypothesis Ey : y * y + La * y = nu.
Hypothesis Hw : La < 2 * y.
Hypothesis Hd : 0 < d < 1.
Hypothesis Hpow : forall k, (1 <= k <= n - 1)%nat -> (1 - d) * l1 ^ (n - 1) <= l1 ^ k - l2 ^ k.
Hypothesis Hhigh : l1 * nu < (1 - d) * (L * b * y).
Notation height := (height l1 l2 nu).
Notation step := (step l1 l2 b nu).
Notation iterate := (iterate l1 l2 b nu).
Let P := b * y / (1 - L).
Let Q := b * y / (1 - K).
Let x := (l1 ^ (n - 1) * P, l2 ^ (n - 1) * Q).

Lemma HLn : l1 * l1 ^ (n - 1) = L /\ l2 * l2 ^ (n - 1) = K.
Proof. unfold L, K. clear - Hn. destruct n as [|k]; [lia|]. replace (S k - 1)%nat with k by lia. split;
  reflexivity. Qed.
Lemma Hby : 0 < b * y. Proof. apply Rmult_lt_0_compat; lra. Qed.
Lemma height_x : height x = - (y * y).
Proof.
  destruct HLn as [H1 H2]. unfold StatementAttractor.height, x; simpl. rewrite <- !Rmult_assoc, H1, H2, <- Ey.
  unfold P, Q, La. field. split; lra.
Qed.
Lemma step_x : step x = (P, Q).
Proof.
  pose proof height_x as Hh. assert (0 < y * y) by (apply Rmult_lt_0_compat; lra). destruct HLn as [H1 H2].
  rewrite impact, Hh, Ropp_involutive, sqrt_square by lra. unfold x; simpl. rewrite <- !Rmult_assoc, H1, H2.
  unfold P, Q. f_equal; field; lra.
Qed.
Lemma between k : (1 <= k <= n - 1)%nat -> nu < l1 ^ k * P - l2 ^ k * Q.
Proof.
  intros Hk. pose proof (Hpow k Hk) as Hp. pose proof Hby as B. destruct HLn as [H1 _].
  assert (P1 : b * y <= P) by (unfold P; apply le_div; [lra|]; assert (0 <= b * y * L) by (apply Rmult_le_pos;
    lra); lra). assert (P2 : Q <= P).
    { unfold P, Q, Rdiv. apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; lra. } assert (K0 : 0 < l2 ^ k) by
    (apply pow_lt; lra). assert (L0 : 0 < l1 ^ (n - 1)) by (apply pow_lt; lra). assert (l2 ^ k * Q <= l2 ^ k * P) by
      (apply Rmult_le_compat_l; lra). assert (M0 : 0 <= (1 - d) * l1 ^ (n - 1)) by (apply Rmult_le_pos; lra).
    assert ((1
    - d) * l1 ^ (n - 1) * (b * y) <= (l1 ^ k - l2 ^ k) * P) by (apply Rmult_le_compat; lra). apply Rlt_le_trans with
    ((1 - d) * l1 ^ (n - 1) * (b * y)); [|lra]. apply (Rmult_lt_reg_l l1); [lra|]. rewrite <- H1 in Hhigh. lra.
Qed.
Lemma flight k : (k <= n - 1)%nat -> iterate k (P, Q) = (l1 ^ k * P, l2 ^ k * Q).
Proof.
  induction k as [|k IH]; intros Hk; [simpl; f_equal; ring|]. change (iterate (S k) (P, Q)) with (step (iterate k (P,
    Q))). rewrite IH by lia. rewrite free_step; [simpl; f_equal; ring|]. pose proof (between (S k) ltac:(lia)) as B.
  unfold StatementAttractor.height; simpl in *. lra.
Qed.
Lemma orbit_x k : (1 <= k <= n)%nat -> iterate k x = (l1 ^ (k - 1) * P, l2 ^ (k - 1) * Q).
Proof. intros Hk. replace k with (S (k - 1)) at 1 by lia. rewrite iterate_S, step_x. apply flight. lia. Qed.
Lemma period_x : iterate n x = x. Proof. apply orbit_x. lia. Qed.
Lemma never_x : never_grazes l1 l2 b nu x.
Proof.
  intros k. assert (Hp : forall i, iterate (i * n) x = x).
  { induction i as [|i IH]; [reflexivity|]. simpl. rewrite iterate_add, IH. apply period_x. }
  rewrite (Nat.div_mod k n) by lia. rewrite Nat.mul_comm, Nat.add_comm, iterate_add, Hp.
  pose proof (Nat.mod_upper_bound k n ltac:(lia)) as Hm. set (j := (k mod n)%nat) in *.
  assert (0 < y * y) by (apply Rmult_lt_0_compat; lra). destruct (Nat.eq_dec j 0) as [->|Hj].
  - change (iterate 0 x) with x. rewrite height_x. lra.
  - rewrite orbit_x by lia. pose proof (between j ltac:(lia)) as B. unfold StatementAttractor.height; simpl.
    destruct j as [|j]; [lia|]. simpl in *. rewrite Nat.sub_0_r. lra.
Qed.
Lemma wedge_x : wedge x.
Proof.
  pose proof Hby as B. unfold wedge, x; simpl. assert (P1 : 0 < Q) by (unfold Q; apply Rdiv_lt_0_compat; lra).
  assert (P2 : Q <= P). { unfold P, Q, Rdiv. apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; lra.
  } assert (0 < l2 ^ (n - 1)) by (apply pow_lt; lra). assert (l2 ^ (n - 1) <= l1 ^ (n - 1)) by (apply pow_incr;
    lra). split; [apply Rmult_le_pos; lra|apply Rmult_le_compat; lra].
Qed.
Lemma inside_x : let J := along l1 l2 b nu n x in
  Rabs (m11 J + m22 J) < 1 + (m11 J * m22 J - m12 J * m21 J) /\ Rabs (m11 J * m22 J - m12 J * m21 J) < 1.
Proof.
  assert (Yy : 0 < y * y) by (apply Rmult_lt_0_compat; lra). pose proof height_x as Hh.
  assert (Hr : first_return l1 l2 b nu n x).
  { split; [exact Hn|]. split; [rewrite period_x; lra|]. intros k Hk. rewrite orbit_x by lia.
    pose proof (between k ltac:(lia)) as B. unfold StatementAttractor.height; simpl. destruct k as [|k]; [lia|].
    simpl in *. rewrite Nat.sub_0_r. lra. }
  destruct (return_vector l1 l2 b nu n x (1, 0) ltac:(lra) Hr) as [A1 A2]. destruct (return_vector l1 l2 b nu n x (0,
    1) ltac:(lra) Hr) as [B1 B2]. rewrite Hh, Ropp_involutive, sqrt_square in A1, A2, B2 by lra.
  set (s := b / (2 * y)) in *. pose proof (det_along l1 l2 b nu n x) as D. unfold det in D.
  rewrite Rpow_mult_distr in D. fold L K in D, A1, A2, B2. set (J := along l1 l2 b nu n x) in *.
  unfold change, apply in A1, A2, B2; simpl in A1, A2, B2. assert (T11 : m11 J = L * (1 - s)) by (apply
    (Rmult_eq_reg_l l1); lra). assert (T22 : m22 J = K * (1 + s)) by (apply (Rmult_eq_reg_l l2); lra).
  cbv zeta. rewrite D. assert (S : s * (L - K) = (1 - L) * (1 - K) * (La / (2 * y))) by (unfold s, La; field;
    lra). assert (T : m11 J + m22 J = L + K - (1 - L) * (1 - K) * (La / (2 * y))) by (rewrite T11, T22, <- S;
    ring). rewrite T. assert (W0 : 0 < La / (2 * y)).
  { apply Rdiv_lt_0_compat; [|lra]. unfold La. apply Rdiv_lt_0_compat; apply Rmult_lt_0_compat; lra. }
  assert (W1 : La / (2 * y) < 1).
  { apply (Rmult_lt_reg_r (2 * y)); [lra|]. replace (La / (2 * y) * (2 * y)) with La by (field; lra). lra. }
  set (w := La / (2 * y)) in *. assert (C0 : 0 < (1 - L) * (1 - K)) by (apply Rmult_lt_0_compat; lra). assert (0 < (1
    - L) * (1 - K) * w) by (apply Rmult_lt_0_compat; lra). assert ((1 - L) * (1 - K) * w < (1 - L) * (1 - K) * 1) by
    (apply Rmult_lt_compat_l; lra). assert (0 < L * K) by (apply Rmult_lt_0_compat; lra).
    assert (L * K < 1 * 1) by (apply Rmult_le_0_lt_compat; lra). split; apply Rabs_def1; lra.
Qed.
End Orbit.

Theorem windows : Windows_statement.
Proof.
  intros l1 l2 b g1 g2 Hl Hl1 Hb Hg1 Hg2. assert (Hl2 : 0 < l1 ^ 2) by (apply pow_lt; lra).
  assert (G : g2 * l1 ^ 2 < 1 - l1).
  { destruct Hg2 as [_ H]. apply (Rmult_lt_compat_r (l1 ^ 2)) in H; [|lra]. replace ((1 - l1) / l1 ^ 2 * l1 ^ 2) with
      (1 - l1) in H by (field; lra). exact H. }
  set (d := Rmin ((1 - l1 - g2 * l1 ^ 2) / 4) (Rmin ((4 * g1 / 3 - 1) / 4) (1 / 2))). assert (Hd : 0 < d /\ d <= (1 -
    l1 - g2 * l1 ^ 2) / 4 /\ d <= (4 * g1 / 3 - 1) / 4 /\ d <= 1 / 2).
  { pose proof (Rmin_l ((1 - l1 - g2 * l1 ^ 2) / 4) (Rmin ((4 * g1 / 3 - 1) / 4) (1 / 2))).
    pose proof (Rmin_r ((1 - l1 - g2 * l1 ^ 2) / 4) (Rmin ((4 * g1 / 3 - 1) / 4) (1 / 2))).
    pose proof (Rmin_l ((4 * g1 / 3 - 1) / 4) (1 / 2)). pose proof (Rmin_r ((4 * g1 / 3 - 1) / 4) (1 / 2)).
    split; [|unfold d; lra]. unfold d. repeat apply Rmin_glb_lt; lra. }
  clearbody d. destruct Hd as (Hd0 & Hd1 & Hd2 & Hd3). destruct (eventually_and _ _ (eventually_pow l1 l2 d Hl Hl1
    ltac:(lra)) (eventually_small l1 (d / 4) ltac:(lra) ltac:(lra))) as (n0 & Hn0). exists (S n0).
  intros n nu Hn [Hn1 Hn2]. destruct (Hn0 (n - 1)%nat ltac:(lia)) as [Hpow _]. destruct (Hn0 n ltac:(lia)) as [_ HLd].
  set (L := l1 ^ n) in *. set (K := l2 ^ n). assert (PK : 0 < K) by (apply pow_lt; lra).
  assert (PL : 0 < L) by (apply pow_lt; lra). assert (HLK : K < L).
  { pose proof (power_ratio l1 l2 n Hl ltac:(lia)) as R. fold K L in R. apply (Rmult_lt_reg_r l1); [lra|].
    assert (0 < L * (l1 - l2)) by (apply Rmult_lt_0_compat; lra). lra. }
  set (La := b * (L - K) / ((1 - L) * (1 - K))). assert (PC : 0 < (1 - L) * (1 - K)) by (apply Rmult_lt_0_compat;
    lra). assert (PLa : 0 < La) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|lra]).
  assert (PbL : 0 < b * L) by (apply Rmult_lt_0_compat; lra). assert (HLa : La <= (1 + d) * (b * L)).
  { unfold La. apply div_le; [lra|]. assert (Q : 1 <= (1 + d) * ((1 - L) * (1 - K))).
    { assert ((1 - L) * (1 - L) <= (1 - L) * (1 - K)) by (apply Rmult_le_compat_l; lra).
      assert (0 <= L * L) by (apply Rmult_le_pos; lra). assert ((1 + d) * (1 - 2 * L) <= (1 + d) * ((1 - L) * (1 -
        K))) by (apply Rmult_le_compat_l; lra). assert (d * L <= 1 / 2 * L) by (apply Rmult_le_compat_r; lra). lra. }
    apply (Rmult_le_compat_l (b * L)) in Q; [|lra]. assert (0 < b * K) by (apply Rmult_lt_0_compat; lra). lra.
      }
  assert (Pnu : 0 < nu). { assert (0 < g1 * (b * L) ^ 2) by (apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]). lra.
  } set (r := sqrt (La ^ 2 + 4 * nu)). assert (Er : r * r = La ^ 2 + 4 * nu) by (apply sqrt_sqrt;
    pose proof (pow2_ge_0 La); lra). assert (Pr : 0 <= r) by apply sqrt_pos. assert (Hr : La < r).
  { apply Rnot_le_lt; intros C. assert (0 <= (La - r) * (La + r)) by (apply Rmult_le_pos; lra). lra. }
  set (y := (r - La) / 2). assert (Hy : 0 < y) by (unfold y; lra). assert (Ey : y * y + La * y = nu) by (unfold y;
    lra). clearbody y. assert (Hw : La < 2 * y).
  { apply Rnot_le_lt; intros C. assert (y * y <= La / 2 * (La / 2)) by (apply Rmult_le_compat; lra).
    assert (La * y <= La * (La / 2)) by (apply Rmult_le_compat_l; lra). assert (La * La <= (1 + d) * (b * L) * ((1 +
      d) * (b * L))) by (apply Rmult_le_compat; lra). assert (Z : 0 < (b * L) ^ 2) by (apply pow_lt; lra).
    assert (D2 : 3 / 4 * ((1 + d)
      * (1 + d)) < g1).
    { assert (d * d <= d * (1 / 2)) by (apply Rmult_le_compat_l; lra). lra. }
    apply (Rmult_lt_compat_r ((b * L) ^ 2)) in D2; [|lra]. lra. }
  assert (Hhigh : l1 * nu < (1 - d) * (L * b * y)).
  { apply Rnot_le_lt; intros C. set (X := L * b * y) in *. assert (PX : 0 < X) by (unfold X;
      apply Rmult_lt_0_compat; [|lra]; lra). assert (A1 : La * y <= (1 + d) * X).
    { apply (Rmult_le_compat_r y) in HLa; [|lra]. unfold X. lra. } assert (A2 : nu * (y * y) <= g2 * (X * X)).
    { apply (Rmult_le_compat_r (y * y)) in Hn2; [|apply Rmult_le_pos; lra]. unfold X. lra. }
    (* nu^2 <= g2 X^2 + (1 + d) X nu, and (1 - d) X <= l1 nu *)
    assert (A3 : nu * nu <= g2 * (X * X) + (1 + d) * (X * nu)).
    { rewrite <- Ey at 2. apply (Rmult_le_compat_l nu) in A1; lra. }
    assert (A4 : (1 - d) * X * ((1 - d) * X) <= l1 * nu * (l1 * nu)) by (apply Rmult_le_compat; try lra;
      apply Rmult_le_pos; lra). assert (A5 : (1 - d) * X * nu <= l1 * nu * nu) by (apply Rmult_le_compat_r;
      lra). assert (N2 : 0 < nu * nu) by (apply Rmult_lt_0_compat; lra). assert (A6 : (1 - d) ^ 2 * (nu * nu) <= g2 *
      (l1 * nu * (l1 * nu)) + (1 + d) * (1 - d) * (l1 * nu * nu)).
    { apply (Rmult_le_compat_l ((1 - d) ^ 2)) in A3; [|apply pow2_ge_0]. apply (Rmult_le_compat_l g2) in A4;
        [|lra]. apply (Rmult_le_compat_l ((1 + d) * (1 - d))) in A5; [|apply Rmult_le_pos; lra]. lra. }
    assert (A7 : g2 * l1 ^ 2 + (1 + d) * (1 - d) * l1 < (1 - d) ^ 2).
    { assert (0 <= d * d) by (apply Rmult_le_pos; lra). assert (0 <= d * d * l1) by (apply Rmult_le_pos; lra). lra. }
    apply (Rmult_lt_compat_r (nu * nu)) in A7; [|lra]. lra. }
  assert (HK : 0 < l2 ^ n < l1 ^ n) by (fold K L; lra). assert (HL1 : l1 ^ n < 1) by (fold L; lra).
  assert (H1 : (1 <= n)%nat) by lia. assert (Hd' : 0 < d < 1) by lra. set (x := (l1 ^ (n - 1) * (b * y / (1 - l1 ^
    n)), l2 ^ (n - 1) * (b * y / (1 - l2 ^ n)))). assert (Hnev : never_grazes l1 l2 b nu x) by (apply (never_x l1 l2 b
    nu d y n); assumption). destruct (inside_x l1 l2 b nu d y n) as [I1 I2]; try assumption.
  exists x, (along l1 l2 b nu n x). constructor; [constructor| | |].
  - apply (wedge_x l1 l2 b y n); assumption.
  - exact Hnev.
  - exact H1.
  - apply (period_x l1 l2 b nu d y n); assumption.
  - apply derivative_iterate; try assumption. intros j _. apply Hnev.
  - exact I1.
  - exact I2.
Qed.
