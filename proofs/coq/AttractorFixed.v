(** * The fixed point with an impact in every step; the map is one of [StatementOrbits], in region 2 *)
From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane StatementAttractor.
Open Scope R_scope.
Theorem fixed : Fixed_statement.
Proof.
  intros l1 l2 b nu Hl Hl1 Hb Hnu. set (L := b * (l1 - l2) / ((1 - l1) * (1 - l2))).
  assert (HL : 0 < L) by (apply Rdiv_lt_0_compat; apply Rmult_lt_0_compat; lra). set (r := sqrt (L ^ 2 + 4 * nu)).
  assert (Er : r * r = L ^ 2 + 4
    * nu) by (apply sqrt_sqrt; pose proof (pow2_ge_0 L); lra). assert (Pr : 0 <= r) by apply sqrt_pos. assert (Hr : L
    < r).
  { apply Rnot_le_lt; intros C. assert (0 <= (L - r) * (L + r)) by (apply Rmult_le_pos; lra). lra. }
  set (y := (r - L) / 2). assert (Hy : 0 < y) by (unfold y; lra). assert (Ey : y * y + L * y = nu) by (unfold y;
    lra). set (x := (b * y / (1 - l1), b * y / (1 - l2))). assert (Hh : height l1 l2 nu x = - (y * y)).
  { unfold height, x; simpl. rewrite <- Ey. unfold L. field. split; lra. } assert (Hs : step l1 l2 b nu x = x).
  { unfold step. destruct (Rle_dec 0 (height l1 l2 nu x)) as [C|_]; [assert (0 < y * y) by (apply Rmult_lt_0_compat;
      lra); lra|]. rewrite Hh, Ropp_involutive, sqrt_square by lra. unfold x; simpl. f_equal; field; lra. }
  assert (Hby : 0 < b * y) by (apply Rmult_lt_0_compat; lra). exists x. constructor; [| |apply le_n|exact Hs].
  - unfold wedge, x; simpl. split; [left; apply Rdiv_lt_0_compat; lra|]. unfold Rdiv. apply Rmult_le_compat_l;
      [lra|]. apply Rinv_le_contravar; lra.
  - intros k. assert (Hk : iterate l1 l2 b nu k x = x).
    { induction k as [|k IH]; [reflexivity|]. change (step l1 l2 b nu (iterate l1 l2 b nu k x) = x). rewrite IH.
      exact Hs. }
    rewrite Hk, Hh. assert (0 < y * y) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma linear_strict F L l : (forall x mu, F x mu = L x + mu * l) -> (L zero = 0) ->
  (forall x x', L (minus x x') = L x - L x') -> strict 2 F L l.
Proof.
  intros HF H0 HL. split; [rewrite HF, H0; ring|]. intros eps He. exists 1. split; [lra|].
  intros x x' mu mu' t _ _ _ _ Hx _. rewrite !HF, HL. replace (L x + mu * l - (L x' + mu' * l) - (L x - L x') - (mu -
    mu') * l) with 0 by ring. rewrite Rabs_R0. specialize (Hx 0%nat ltac:(lia)). pose proof (Rabs_pos (minus x x'
    0%nat)). apply Rmult_le_pos; lra.
Qed.
Theorem same_map : Same_map_statement.
Proof.
  intros l1 l2 b Hl Hl1 Hb. split; [split|split].
  - split; [|split].
    + intros i Hi. simpl in Hi. destruct i as [|[|i]]; try lia; apply linear_strict; intros;
        unfold minus, zero; simpl; ring.
    + apply linear_strict; unfold minus, zero; intros; simpl; ring.
    + intros eps He. exists 1. split; [lra|]. intros x x' y y' mu mu' t i _ _ _ _ _ _ _ _ Hy _.
      match goal with |- Rabs ?e <= _ => replace e with 0 by (simpl; ring) end.
      rewrite Rabs_R0. pose proof (Rabs_pos (y - y')). apply Rmult_le_pos; lra.
  - reflexivity.
  - reflexivity.
  - simpl. ring.
  - simpl. ring.
  - unfold mult; simpl. split; [ring|]. apply Rmult_integral_contrapositive_currified; lra.
  - intros i Hi. unfold zero, mult. destruct i as [|[|i]]; try lia; simpl; ring.
  - simpl. unfold zero. split; [ring|lra].
  - split; [|nra]. rewrite sqrt_mult by lra. pose proof (pow2_ge_0 (sqrt l1 - sqrt l2)).
    pose proof (sqrt_sqrt l1 ltac:(lra)). pose proof (sqrt_sqrt l2 ltac:(lra)). nra.
  - intros nu x; cbv zeta. unfold step, height, StatementOrbits.step; simpl. replace (l1 * x 0%nat - l2 * x 1%nat + -
      nu) with (l1 * x 0%nat - l2 * x 1%nat - nu) by ring. destruct (Rle_dec 0 (l1 * x 0%nat - l2 * x 1%nat - nu));
      reflexivity.
Qed.
