(** * The inequalities of one return: trapping, cone, growth *)
From Coq Require Import Reals Lra.
Open Scope R_scope.

Lemma div_le a b c : 0 < b -> a <= c * b -> a / b <= c.
Proof. intros Hb H. apply (Rmult_le_reg_r b); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. Qed.
Lemma le_div a b c : 0 < b -> c * b <= a -> c <= a / b.
Proof. intros Hb H. apply (Rmult_le_reg_r b); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. Qed.

(** Powers: K = l2^n, L = l1^n. *)
Lemma power_ratio l1 l2 n : 0 < l2 < l1 -> (1 <= n)%nat -> l2 ^ n * l1 <= l2 * l1 ^ n.
Proof.
  intros H Hn. destruct n as [|n]; [inversion Hn|]. simpl. assert (l2 ^ n <= l1 ^ n) by (apply pow_incr; lra).
  assert (0 < l2 * l1) by nra. nra.
Qed.

Section Return.
Variables l1 l2 : R.
Hypothesis Hl : 0 < l2 < l1.
Let M := 2 * l2 / (l1 - l2).
Lemma M_eq : M * (l1 - l2) = 2 * l2. Proof. unfold M. field. lra. Qed.
Lemma M_pos : 0 < M. Proof. unfold M. apply Rdiv_lt_0_compat; lra. Qed.

Lemma cone_growth L K s dc dq : 0 < K -> 0 < L -> K * l1 <= l2 * L ->
  M + 2 * l1 / (l1 - l2) <= s -> Rabs dq <= M * Rabs dc ->
  Rabs (K * (dq - s * dc)) <= M * Rabs (L * dc + (L - K) * (dq - s * dc)) /\
  ((L - K) * (s - M) - L) * Rabs dc <= Rabs (L * dc + (L - K) * (dq - s * dc)).
Proof.
  intros HK HL HKL Hs Hq. pose proof M_eq as EM. pose proof M_pos as PM. assert (T : 2 * l1 / (l1 - l2) * (l1 - l2) =
    2 * l1) by (field; lra). set (t := 2 * l1 / (l1 - l2)) in *. assert (Ht : 0 < t) by (unfold t;
    apply Rdiv_lt_0_compat; lra). assert (HLK : 0 < L - K) by nra. set (ds := dq - s * dc).
  assert (H1 : (s - M) * Rabs dc <= Rabs ds).
  { assert (s * Rabs dc <= Rabs ds + Rabs dq).
    { rewrite <- (Rabs_pos_eq s), <- Rabs_mult by lra. replace (s * dc) with (dq - ds) by (unfold ds; ring).
      unfold Rminus at 1. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
    lra. }
  assert (H2 : (L - K) * Rabs ds - L * Rabs dc <= Rabs (L * dc + (L - K) * ds)).
  { assert ((L - K) * Rabs ds <= Rabs (L * dc + (L - K) * ds) + L * Rabs dc).
    { rewrite <- (Rabs_pos_eq (L - K)) at 1 by lra. rewrite <- Rabs_mult. replace ((L - K) * ds) with ((L * dc + (L -
        K) * ds) + - (L * dc)) at 1 by ring. eapply Rle_trans; [apply Rabs_triang|].
      rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq L) by lra. lra. }
    lra. }
  rewrite Rabs_mult, (Rabs_pos_eq K) by lra. set (C := Rabs (L * dc + (L - K) * ds)) in *.
  set (B := Rabs ds) in *. set (A := Rabs dc) in *. assert (HA : 0 <= A) by apply Rabs_pos.
  assert (HB : 0 <= B) by apply Rabs_pos. split.
  - assert (E1 : M * l1 * A <= l2 * B).
    { assert (t * l2 = M * l1) by (unfold t, M; field; lra). assert (M * l1 * A <= l2 * ((s - M) * A)); [|nra].
      assert (t * A <= (s - M) * A) by (apply Rmult_le_compat_r; lra). nra. }
    assert (E2 : 2 * l2 * L <= M * (L - K) * l1).
    { assert (L * (l1 - l2) <= (L - K) * l1) by nra. assert (M * (L * (l1 - l2)) <= M * ((L - K) * l1)) by (apply
        Rmult_le_compat_l; lra). nra. }
    assert (E3 : l1 * (K * B) <= l1 * (M * C)).
    { assert (M * l1 * ((L - K) * B - L * A) <= M * l1 * C) by (apply Rmult_le_compat_l; nra).
      assert (2 * l2 * L * B <= M * (L - K) * l1 * B) by (apply Rmult_le_compat_r; lra).
      assert (L * (M * l1 * A) <= L * (l2 * B)) by (apply Rmult_le_compat_l; lra). assert (K * l1 * B <= l2 * L * B)
        by (apply Rmult_le_compat_r; lra). nra. }
    apply (Rmult_le_reg_l l1); lra.
  - assert ((L - K) * ((s - M) * A) <= (L - K) * B) by (apply Rmult_le_compat_l; lra). nra.
Qed.

(** ** Growth: after long flights by the height, after short ones by the speed *)
Variables E d : R.
Hypothesis Hl1 : l1 < 1.
Hypothesis HE : 1 < E.
Hypothesis Hd : 0 < d <= 1 / 4.
Hypothesis HdE : d * (4 + 2 * E) <= l1 - 2 * E * (1 - l1).

Lemma growth nu b L K s y c c' q e :
  0 < nu -> 0 < b -> 0 < K -> 0 < L <= l1 -> K * l1 <= l2 * L -> 0 < y -> y ^ 2 = nu - c -> 2 * s * y = b ->
  e <= d -> l1 * (1 - e) * nu <= c -> 0 <= q -> q * (l1 - l2) <= l2 * nu -> c <= nu -> l1 * (1 - e) * nu <= c'
    ->
  c' = L * c + (L - K) * (q + b * y) ->
  M + (E + 1) * l1 / (d * (l1 - l2) ^ 2) <= s ->
  E <= (L - K) * (s - M) - L.
Proof.
  intros Hnu Hb HK HL HKL Hy Hyc Hs He Hc Hq Hq' Hcn Hc' Ec' HS. pose proof M_eq as EM. pose proof M_pos as PM.
  assert (HLK : L * (l1 - l2) <= (L - K) * l1) by lra. assert (HLK0 : 0 < L - K).
  { apply (Rmult_lt_reg_r l1); [lra|]. rewrite Rmult_0_l. assert (0 < L * (l1 - l2)) by (apply Rmult_lt_0_compat;
      lra). lra. }
  assert (Hlnu : 0 < l1 * nu) by (apply Rmult_lt_0_compat; lra). assert (Hed : e * (l1 * nu) <= d * (l1 * nu)) by
    (apply Rmult_le_compat_r; lra). destruct (Rle_or_lt L (d * (l1 - l2))) as [Hs1|Hs1].
  - (* long *)
    assert (HM1 : L * (1 + M) <= 2 * d).
    { assert (L * (1 + M) <= d * (l1 - l2) * (1 + M)) by (apply Rmult_le_compat_r; lra).
      replace (d * (l1 - l2) * (1 + M)) with (d * (l1 - l2 + M * (l1 - l2))) in * by ring. rewrite EM in *.
      assert (d * (l1 - l2 + 2 * l2) <= d * 2) by (apply Rmult_le_compat_l; lra). lra. }
    assert (Hcq : L * (c + q) <= d * (l1 * nu)).
    { assert (Hcq1 : (c + q) * (l1 - l2) <= l1 * nu).
      { assert (c * (l1 - l2) <= nu * (l1 - l2)) by (apply Rmult_le_compat_r; lra). lra. }
      assert (d * (l1 * nu) <= 1 / 4 * (l1 * nu)) by (apply Rmult_le_compat_r; lra).
      assert (0 <= c + q) by lra. assert (L * (c + q) <= d * (l1 - l2) * (c + q)) by (apply Rmult_le_compat_r;
        lra). assert (d * ((c + q) * (l1
        - l2)) <= d * (l1 * nu)) by (apply Rmult_le_compat_l; lra). nra. }
    assert (Hnum : l1 * nu * (1 - 2 * d) <= (L - K) * (b * y)).
    { replace ((L - K) * (b * y)) with (c' - L * (c + q) + K * q) by (rewrite Ec'; ring).
      assert (0 <= K * q) by (apply Rmult_le_pos; lra). nra. }
    assert (Hw : y ^ 2 <= nu * (1 - l1 + l1 * d)) by lra. assert (Hy2 : 0 < y ^ 2) by (apply pow_lt; lra).
    assert (Hmid : 2 * y ^ 2 * (E + 2 * d) <= l1 * nu * (1 - 2 * d)).
    { assert (2 * y ^ 2 * (E + 2 * d) <= 2 * (nu * (1 - l1 + l1 * d)) * (E + 2 * d)) by (apply Rmult_le_compat_r;
        lra). assert (2 * (1 - l1 + l1 * d) * (E + 2 * d) <= l1 * (1 - 2 * d)).
      { assert (0 <= l1 * d) by (apply Rmult_le_pos; lra). assert (d * d <= d * (1 / 4)) by (apply Rmult_le_compat_l;
          lra). assert (l1 * (d * d) <= l1 * (d * (1 / 4))) by (apply Rmult_le_compat_l; lra).
        assert (l1 * (E * d) <= 1 * (E * d)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos; lra|lra]). lra.
          }
      assert (nu * (2 * (1 - l1 + l1 * d) * (E + 2 * d)) <= nu * (l1 * (1 - 2 * d))) by (apply Rmult_le_compat_l;
        lra). nra. }
    assert (Hfin : 2 * y ^ 2 * (E + 2 * d) <= 2 * y ^ 2 * ((L - K) * s)).
    { replace (2 * y ^ 2 * ((L - K) * s)) with ((L - K) * (2 * s * y * y)) by ring. rewrite Hs. lra. }
    apply Rmult_le_reg_l in Hfin; [|lra]. assert (0 <= K * M) by (apply Rmult_le_pos; lra). lra.
  - (* short *)
    assert (Hdd : 0 < d * (l1 - l2) ^ 2) by (apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]).
    set (t := (E + 1) * l1 / (d * (l1 - l2) ^ 2)) in *. assert (Et : t * (d * (l1 - l2) ^ 2) = (E + 1) * l1) by
      (unfold t; field; split; lra). assert (Ht : 0 < t) by (unfold t; apply Rdiv_lt_0_compat;
      [apply Rmult_lt_0_compat; lra|lra]). assert (H1 : d * (l1 - l2) ^ 2 <= (L - K) * l1).
    { assert (d * (l1 - l2) * (l1 - l2) <= L * (l1 - l2)) by (apply Rmult_le_compat_r; lra). nra. }
    assert (H2 : (E + 1) * l1 <= (L - K) * t * l1).
    { rewrite <- Et. assert (t * (d * (l1 - l2) ^ 2) <= t * ((L - K) * l1)) by (apply Rmult_le_compat_l; lra). nra. }
    apply Rmult_le_reg_r in H2; [|lra]. assert ((L - K) * t <= (L - K) * (s - M)) by (apply Rmult_le_compat_l;
      lra). lra.
Qed.

(** ** Trapping *)
Lemma trapped_q nu L K c c' sg : 0 < K -> K * l1 <= l2 * L -> 0 < L -> 0 <= c -> 0 <= sg ->
  c' = L * c + (L - K) * sg -> c' < nu -> K * sg * (l1 - l2) <= l2 * nu.
Proof.
  intros. assert (K * (l1 - l2) <= l2 * (L - K)) by nra. assert (K * (l1 - l2) * sg <= l2 * (L - K) * sg) by (apply
    Rmult_le_compat_r; lra). assert (0 <= L * c) by (apply Rmult_le_pos; lra). nra.
Qed.
Lemma trapped_c nu b y c c' q : 0 < nu -> 0 < b -> 0 <= y -> y ^ 2 = nu - c -> 0 <= c -> 0 <= q ->
  c' = l1 * c + (l1 - l2) * (q + b * y) -> c' < nu -> l1 * (1 - nu / ((l1 - l2) * b) ^ 2) * nu <= c'.
Proof.
  intros Hnu Hb Hy Hyc Hc Hq E' Hc'. set (w := (l1 - l2) * b). assert (Hw : 0 < w) by (apply Rmult_lt_0_compat;
    lra). assert (H1 : w * y <= nu).
  { assert (0 <= l1 * c) by (apply Rmult_le_pos; lra). assert (0 <= (l1 - l2) * q) by (apply Rmult_le_pos;
      lra). unfold w. nra. }
  assert (H2 : y ^ 2 <= nu / w ^ 2 * nu).
  { assert (H3 : (w * y) ^ 2 <= nu ^ 2) by (apply pow_incr; split; [apply Rmult_le_pos; lra|lra]).
    apply (Rmult_le_reg_r (w ^ 2)); [apply pow_lt; lra|]. replace (nu / w ^ 2 * nu * w ^ 2) with (nu ^ 2) by (field;
      lra). nra. }
  assert (0 <= (l1 - l2) * (q + b * y)).
  { apply Rmult_le_pos; [lra|]. assert (0 <= b * y) by (apply Rmult_le_pos; lra). lra. }
  assert (l1 * ((1 - nu / w ^ 2) * nu) <= l1 * c) by (apply Rmult_le_compat_l; nra). nra.
Qed.
End Return.
