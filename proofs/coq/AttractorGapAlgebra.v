(** * Two returns: identity (5), and what it gives in the metric |dc| / sqrt (c (1 - c)) *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import AttractorAlgebra.
Open Scope R_scope.

(** The growth of the limit map c' = B sqrt (1 - c), in the metric |dc| / c. *)
Definition W (c : R) : R := c / (2 * (1 - c)).

(** Identity (5), t = 2 u / sqrt 3 the successor of c = 1 - u^2 for B = 2 / sqrt 3. *)
Lemma identity5 t : 0 < t < 1 -> W (1 - 3 / 4 * t ^ 2) * W t - 1 = (3 * t - 2) ^ 2 / (12 * t * (1 - t)).
Proof. intros H. unfold W. field. repeat split; nra. Qed.

Lemma W_mono c c' : c <= c' < 1 -> W c <= W c'.
Proof.
  intros H. unfold W. apply div_le; [lra|]. apply (Rmult_le_reg_r (2 * (1 - c'))); [lra|].
  replace (c' / (2 * (1 - c')) * (2 * (1 - c)) * (2 * (1 - c'))) with (c' * (2 * (1 - c))) by (field; lra). nra.
Qed.
Lemma W_pair c u c' m : 1 <= m -> 0 < u -> u ^ 2 = 1 - c -> 0 < c -> c' < 1 -> m * (2 * u / sqrt 3) <= c' ->
  m <= W c * W c'.
Proof.
  intros Hm Hu Hc Hc0 Hc' Hb. assert (H3 : 0 < sqrt 3) by (apply sqrt_lt_R0; lra). assert (E3 : sqrt 3 ^ 2 = 3) by
    (simpl; rewrite Rmult_1_r; apply sqrt_sqrt; lra). set (t := 2 * u / sqrt 3) in *.
  assert (Ht : 0 < t) by (unfold t; apply Rdiv_lt_0_compat; lra). assert (Ht1 : t < 1) by nra.
  assert (Eu : u ^ 2 = 3 / 4 * t ^ 2).
  { replace (3 / 4 * t ^ 2) with (3 * u ^ 2 / sqrt 3 ^ 2) by (unfold t; field; lra). rewrite E3. field. }
  assert (Ec : c = 1 - 3 / 4 * t ^ 2) by lra. assert (I := identity5 t (conj Ht Ht1)). rewrite <- Ec in I.
  assert (P : 0 <= (3 * t - 2) ^ 2 / (12 * t * (1 - t))).
  { apply Rmult_le_pos; [apply pow2_ge_0|]. left. apply Rinv_0_lt_compat. nra. }
  assert (Wc : 0 < W c). { unfold W. apply Rdiv_lt_0_compat; [lra|]. rewrite <- Hc.
  assert (0 < u ^ 2) by (apply pow_lt; lra). lra. } assert (Wt : m * W t <= W c').
  { eapply Rle_trans; [|apply (W_mono (m * t)); lra]. unfold W. apply le_div; [lra|]. replace (m * (t / (2 * (1 - t)))
      * (2 * (1 - m * t))) with (m * t * ((1 - m * t) / (1 - t))) by (field; lra). assert ((1 - m * t) / (1 - t) <= 1)
      by (apply div_le; [lra|nra]). assert (0 <= m * t) by nra. nra. }
  assert (W c * (m * W t) <= W c * W c') by (apply Rmult_le_compat_l; lra). nra.
Qed.

Section Gap.
Variables l1 l2 d E1 : R.
Hypothesis Hl : 0 < l2 < l1.
Hypothesis Hl1 : l1 < 1.
Hypothesis HE1 : 1 <= E1.
Hypothesis Hd : 0 < d <= 1 / 6.
Let M := 2 * l2 / (l1 - l2).

(** The metric is phi (c) / c |dc|, phi = sqrt W up to a bound. *)
Definition phi (c : R) : R := Rmin (3 * E1) (Rmax (2 / 5) (sqrt (W c))).
Lemma phi_bounds c : 2 / 5 <= phi c <= 3 * E1.
Proof. unfold phi. split; [|apply Rmin_l]. apply Rmin_glb; [lra|apply Rmax_l]. Qed.
Lemma W_quarter c : 1 / 4 <= c < 1 -> 1 / 6 <= W c. Proof. intros H. unfold W. apply le_div; lra. Qed.
Lemma phi_pair c c' : 1 / 4 <= c < 1 -> 1 / 4 <= c' < 1 -> E1 ^ 2 <= W c * W c' -> E1 * phi c <= W c * phi c'.
Proof.
  intros Hc Hc' HW. pose proof (W_quarter c Hc) as W1. pose proof (W_quarter c' Hc') as W2. set (r := sqrt (W c)).
  set (r' := sqrt (W c')). assert (Er : r * r = W c) by (apply sqrt_sqrt; lra). assert (Er' : r' * r' = W c') by
    (apply sqrt_sqrt; lra). assert (Pr : 0 <= r) by apply sqrt_pos. assert (Pr' : 0 <= r') by apply sqrt_pos.
  assert (Qr : 2 / 5 <= r).
  { apply Rnot_lt_le; intros C. assert (0 < (2 / 5 - r) * (2 / 5 + r)) by (apply Rmult_lt_0_compat; lra). lra.
    }
  assert (Qr' : 2 / 5 <= r').
  { apply Rnot_lt_le; intros C. assert (0 < (2 / 5 - r') * (2 / 5 + r')) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (Hrr : E1 <= r * r').
  { apply Rnot_lt_le; intros C. assert (Px : 0 <= r * r') by (apply Rmult_le_pos; lra).
    assert (0 < (E1 - r * r') * (E1 + r * r')) by (apply Rmult_lt_0_compat; lra). rewrite <- Er, <- Er' in HW. lra. }
  assert (P1 : phi c <= r). { unfold phi. fold r. rewrite Rmax_right by lra. apply Rmin_r.
  } pose proof (phi_bounds c) as [_ P2]. rewrite <- Er. unfold phi at 2. fold r'. rewrite (Rmax_right (2 / 5) r') by
    lra. unfold Rmin. destruct (Rle_dec (3 * E1) r').
  - destruct (Rle_or_lt E1 (r * r)).
    + apply Rle_trans with (E1 * (3 * E1)); [apply Rmult_le_compat_l; lra|]. apply Rmult_le_compat_r; lra.
    + apply Rle_trans with (E1 * r); [apply Rmult_le_compat_l; lra|]. assert (r * 1 <= r * (3 * r)) by (apply
        Rmult_le_compat_l; lra). assert (E1 * (r * 1) <= E1 * (r * (3 * r))) by (apply Rmult_le_compat_l; lra). lra.
  - assert (E1 * phi c <= E1 * r) by (apply Rmult_le_compat_l; lra). assert (r * E1 <= r * (r * r')) by (apply
      Rmult_le_compat_l; lra). lra.
Qed.

Lemma gap_growth L K be u c c' q s : 0 < K -> 0 < L <= l1 -> K * l1 <= l2 * L -> 0 < u -> u ^ 2 = 1 - c ->
  2 * s * u = be ->
  1 / 4 <= c -> 0 <= q -> q * (l1 - l2) <= l2 -> 1 / 4 <= c' < 1 -> c' = L * c + (L - K) * (q + be * u) ->
  E1 ^ 2 <= W c * W c' -> M + (30 * E1 ^ 2 + 1) * l1 / (d / 96 * (l1 - l2) ^ 2) <= s ->
  (1 - d) * E1 * (phi c / c) <= ((L - K) * (s - M) - L) * (phi c' / c').
Proof.
  intros HK HL HKL Hu Hc Hs Hc0 Hq Hq' Hc' Ec' HW HS. assert (Hu2 : 0 < u ^ 2) by (apply pow_lt; lra).
  pose proof (phi_bounds c) as [F1 F2]. pose proof (phi_bounds c') as [F3 F4]. assert (EM : M * (l1 - l2) = 2 * l2) by
    (unfold M; field; lra). assert (PM : 0 < M) by (unfold M; apply Rdiv_lt_0_compat; lra).
  assert (HLK : L * (l1 - l2) <= (L
    - K) * l1) by lra. assert (HLK0 : 0 < L - K).
  { apply (Rmult_lt_reg_r l1); [lra|]. rewrite Rmult_0_l. assert (0 < L * (l1 - l2)) by (apply Rmult_lt_0_compat;
      lra). lra. }
  set (G := (L - K) * (s - M) - L). destruct (Rle_or_lt L (d / 96 * (l1 - l2))) as [Hs1|Hs1].
  - (* long *)
    assert (HM1 : L * (1 + M) <= d / 48).
    { apply Rle_trans with (d / 96 * (l1 - l2) * (1 + M)); [apply Rmult_le_compat_r; lra|].
      replace (d / 96 * (l1 - l2) * (1 + M)) with (d / 96 * (l1 - l2 + M * (l1 - l2))) by ring. rewrite EM.
      apply Rle_trans with (d / 96 * 2); [apply Rmult_le_compat_l; lra|lra]. }
    assert (Hcq : L * (c + q) <= d / 96).
    { apply Rle_trans with (d / 96 * (l1 - l2) * (c + q)); [apply Rmult_le_compat_r; lra|].
      assert ((l1 - l2) * c <= (l1 - l2) * 1) by (apply Rmult_le_compat_l; lra). assert ((l1 - l2) * (c + q) <= 1) by
        lra. apply Rle_trans with (d / 96 * 1); [|lra]. rewrite Rmult_assoc. apply Rmult_le_compat_l; lra. }
    set (X := c' / (2 * u ^ 2)). assert (EX : X * (2 * u ^ 2) = c') by (unfold X; field; lra).
    assert (HX : 1 / 6 <= X) by (unfold X; apply le_div; lra). assert (HG1 : (1 - d / 24) * X <= (L - K) * s).
    { apply (Rmult_le_reg_r (2 * u ^ 2)); [lra|]. rewrite Rmult_assoc, EX. replace ((L - K) * s * (2 * u ^ 2)) with
        ((L - K) * (2 * s * u * u)) by ring. rewrite Hs. replace ((L - K) * (be * u)) with (c' - L * (c + q) + K * q)
        by (rewrite Ec'; ring). assert (0 <= K * q) by (apply Rmult_le_pos; lra). assert (d * (1 / 4) <= d * c') by
        (apply Rmult_le_compat_l; lra). lra. }
    assert (HG : (1 - d) * X <= G).
    { unfold G. assert (0 <= K * M) by (apply Rmult_le_pos; lra). assert (d * (1 / 6) <= d * X) by (apply
        Rmult_le_compat_l; lra). lra. }
    assert (WX : W c / c = X / c') by (unfold W, X; rewrite Hc; field; lra). apply Rle_trans with ((1 - d) * X * (phi
      c' / c')).
    + replace ((1 - d) * E1 * (phi c / c)) with ((1 - d) * (E1 * phi c / c)) by (field; lra).
      replace ((1 - d) * X * (phi c' / c')) with ((1 - d) * (W c * phi c' / c)).
      2:{ replace (W c * phi c' / c) with (W c / c * phi c') by (field; lra). rewrite WX. field. lra. }
      apply Rmult_le_compat_l; [lra|]. unfold Rdiv. apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat;
        lra|]. apply phi_pair; try assumption. lra.
    + apply Rmult_le_compat_r; [|exact HG]. apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat. lra.
  - (* short *)
    assert (PE : 1 <= E1 ^ 2) by (rewrite <- (pow1 2); apply pow_incr; lra). assert (Pl : 0 < (l1 - l2) ^ 2) by (apply
      pow_lt; lra). set (t := (30 * E1 ^ 2 + 1) * l1 / (d / 96 * (l1 - l2) ^ 2)) in *. assert (Et : t * (d / 96 * (l1
      - l2) ^ 2) = (30 * E1 ^ 2 + 1) * l1) by (unfold t; field; split; lra). assert (Ht : 0 < t).
    { unfold t. apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|apply Rmult_lt_0_compat; lra]. }
    assert (H1 : d / 96 * (l1 - l2) ^ 2 <= (L - K) * l1).
    { assert (d / 96 * (l1 - l2) * (l1 - l2) <= L * (l1 - l2)) by (apply Rmult_le_compat_r; lra). lra. }
    assert (H2 : 30 * E1 ^ 2 + 1 <= (L - K) * t).
    { apply (Rmult_le_reg_r l1); [lra|]. rewrite <- Et. apply Rle_trans with (t * ((L - K) * l1));
        [apply Rmult_le_compat_l; lra|lra]. }
    assert (H3 : (L - K) * t <= (L - K) * (s - M)) by (apply Rmult_le_compat_l; lra).
    assert (HG : 30 * E1 ^ 2 <= G) by (unfold G; lra). assert (A1 : phi c / c <= 12 * E1).
    { apply div_le; [lra|]. assert (12 * E1 * (1 / 4) <= 12 * E1 * c) by (apply Rmult_le_compat_l; lra). lra.
      }
    assert (A2 : 2 / 5 <= phi c' / c') by (apply le_div; [lra|lra]). apply Rle_trans with (E1 * (12 * E1)).
    { apply Rmult_le_compat; try lra.
      - apply Rmult_le_pos; lra.
      - apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat. lra.
      - assert (0 <= d * E1) by (apply Rmult_le_pos; lra). lra. }
    apply Rle_trans with (30 * E1 ^ 2 * (2 / 5)); [lra|]. apply Rmult_le_compat; lra.
Qed.
End Gap.
