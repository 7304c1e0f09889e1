(** * Every area reaches below the circle: its lowest radius is at most 1 - 4/(pi n^3)

    At e = 1/(2j) one has A = pi/j, B = pi/n, and by Bernoulli's inequality h > 0 as soon as
    (1 - r)(j sin A + n sin B) < h(1) = 4 sin (A/2) sin (B/2) sin ((A+B)/2). *)

From Coq Require Import Reals Arith Lra Lia.
From Grazing Require Import Defs Statement Farey Disc Sine Radius Count Graph Above.
Open Scope R_scope.

Lemma Bernoulli r k : 0 <= r <= 1 -> 1 - INR k * (1 - r) <= r ^ k.
Proof.
  intros Hr; induction k as [|k IH]; [simpl; lra|]. rewrite S_INR; cbn [pow]; pose proof (pos_INR k).
  apply Rle_trans with (r * (1 - INR k * (1 - r))); [|apply Rmult_le_compat_l; lra].
  assert (0 <= INR k * ((1 - r) * (1 - r))) by (apply Rmult_le_pos; [|apply Rle_0_sqr]; lra); lra.
Qed.

Lemma h_above n j e r : index n j e -> INR j * e < 1 -> 0 < r <= 1 ->
  (1 - r) * (INR j * sin (angle_A e) + INR n * sin (angle_B n j e)) < h n j e 1 -> 0 < h n j e r.
Proof.
  intros Hi Hje Hr Hlt; pose proof (sin_A_pos n j e Hi); pose proof (B_range n j e Hi Hje).
  assert (0 < sin (angle_B n j e)) by (apply sin_gt_0; lra).
  pose proof (Bernoulli r j ltac:(lra)) as B1; pose proof (Bernoulli r n ltac:(lra)) as B2.
  apply (Rmult_le_compat_r (sin (angle_A e))) in B1; [|lra].
  apply (Rmult_le_compat_r (sin (angle_B n j e))) in B2; [|lra]. unfold h in *; rewrite !pow1 in Hlt; lra.
Qed.

(** x = PI / (2 y), y >= 1: sin x >= 1 / y. *)
Lemma sin_chord y : 1 <= y -> / y <= sin (PI / (2 * y)).
Proof.
  intros Hy; pose proof PI_RGT_0; assert (Hi : 0 < / y <= 1).
  { split; [apply Rinv_0_lt_compat; lra|rewrite <- Rinv_1; apply Rinv_le_contravar; lra]. }
  replace (PI / (2 * y)) with (PI / 2 * / y) by (field; lra).
  pose proof (sin_ratio (PI / 2 * / y) (PI / 2) ltac:(nra) ltac:(lra)) as H1. rewrite sin_PI2 in H1; nra.
Qed.

Lemma four_sines x y : sin (2 * x) + sin (2 * y) - sin (2 * x + 2 * y) = 4 * sin x * sin y * sin (x + y).
Proof.
  rewrite (sin_plus (2 * x)), !sin_2a, !cos_2a_sin, (sin_plus x y); ring_simplify.
  pose proof (sin2_cos2 x) as E; pose proof (sin2_cos2 y) as F; unfold Rsqr in E, F. nra.
Qed.

(** The middle, e = 1/(2j). *)
Lemma h_middle n j r : (3 <= n)%nat -> (2 <= j <= n - 1)%nat -> 0 < r <= 1 ->
  1 - r <= 4 / (PI * INR n ^ 3) -> 0 < h n j (1 / (2 * INR j)) r.
Proof.
  intros Hn Hj Hr Hlt; pose proof PI_RGT_0. assert (Hn3 : 3 <= INR n) by (apply le_INR in Hn; simpl in Hn; lra).
  assert (Hj2 : 2 <= INR j < INR n).
  { split; [apply (le_INR 2); lia|apply lt_INR; lia]. }
  assert (Eje : INR j * (1 / (2 * INR j)) = 1 / 2) by (field; lra).
  assert (Hi : index n j (1 / (2 * INR j))).
  { split; [assumption|split; [lia|]]; split; [apply Rdiv_lt_0_compat; lra|].
    apply (Rmult_lt_reg_l (INR j)); [lra|]; rewrite Eje; lra. }
  apply h_above; trivial; [lra|]. set (x := PI / (2 * INR j)); set (y := PI / (2 * INR n)).
  assert (EA : angle_A (1 / (2 * INR j)) = 2 * x) by (unfold angle_A, x; field; lra).
  assert (EB : angle_B n j (1 / (2 * INR j)) = 2 * y) by (unfold angle_B, y; rewrite Eje; field; lra).
  unfold h; rewrite EA, EB, !pow1, !Rmult_1_l, four_sines.
  assert (Hx : 0 < 2 * x <= PI / 2).
  { unfold x; replace (2 * (PI / (2 * INR j))) with (PI * / INR j) by (field; lra).
    assert (0 < / INR j <= / 2) by (split; [apply Rinv_0_lt_compat; lra|apply Rinv_le_contravar; lra]); nra. }
  assert (Hy : 0 < 2 * y <= PI / 3).
  { unfold y; replace (2 * (PI / (2 * INR n))) with (PI * / INR n) by (field; lra).
    assert (0 < / INR n <= / 3) by (split; [apply Rinv_0_lt_compat; lra|apply Rinv_le_contravar; lra]); nra. }
  assert (Hd : INR j * sin (2 * x) + INR n * sin (2 * y) < 2 * PI).
  { pose proof (sin_lt_x (2 * x) ltac:(lra)); pose proof (sin_lt_x (2 * y) ltac:(lra)).
    assert (INR j * (2 * x) = PI) by (unfold x; field; lra).
    assert (INR n * (2 * y) = PI) by (unfold y; field; lra); nra. }
  assert (Hd0 : 0 < INR j * sin (2 * x) + INR n * sin (2 * y)).
  { assert (0 < sin (2 * x)) by (apply sin_gt_0; lra). assert (0 < sin (2 * y)) by (apply sin_gt_0; lra); nra. }
  set (i := / INR n) in *. assert (Hi0 : 0 < i) by (apply Rinv_0_lt_compat; lra).
  assert (S1 : i <= sin x).
  { apply Rle_trans with (/ INR j); [apply Rinv_le_contravar; lra|apply sin_chord; lra]. }
  assert (S2 : i <= sin y) by (apply sin_chord; lra).
  assert (S3 : 2 * i <= sin (x + y)).
  { pose proof (sin_ratio (x + y) (PI / 2) ltac:(lra) ltac:(lra)) as Q; rewrite sin_PI2 in Q.
    assert (E1 : y = PI / 2 * i) by (unfold y, i; field; lra).
    assert (E2 : x = PI / 2 * / INR j) by (unfold x; field; lra).
    assert (i <= / INR j) by (apply Rinv_le_contravar; lra); nra. }
  assert (P1 : i * i <= sin x * sin y) by (apply Rmult_le_compat; lra).
  assert (P2 : i * i * (2 * i) <= sin x * sin y * sin (x + y)) by (apply Rmult_le_compat; nra).
  assert (E : 4 / (PI * INR n ^ 3) * (2 * PI) = 4 * (i * i * (2 * i))) by (unfold i; field; lra).
  assert (0 < 4 / (PI * INR n ^ 3)).
  { apply Rdiv_lt_0_compat; [lra|apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]]. }
  apply Rle_lt_trans with (4 / (PI * INR n ^ 3) * (INR j * sin (2 * x) + INR n * sin (2 * y)));
    [apply Rmult_le_compat_r; lra|].
  apply Rlt_le_trans with (4 / (PI * INR n ^ 3) * (2 * PI)); [apply Rmult_lt_compat_l; lra|lra].
Qed.

Lemma small_depth n : (3 <= n)%nat -> 0 < 4 / (PI * INR n ^ 3) < 1.
Proof.
  intros Hn; assert (Hn3 : 3 <= INR n) by (apply le_INR in Hn; simpl in Hn; lra).
  pose proof PI2_3_2; assert (3 ^ 3 <= INR n ^ 3) by (apply pow_incr; lra).
  assert (4 < PI * INR n ^ 3) by (simpl in *; nra). split; [apply Rdiv_lt_0_compat; lra|].
  apply (Rmult_lt_reg_r (PI * INR n ^ 3)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Theorem Depth : Depth_statement.
Proof.
  intros n k g lo hi Rad Hn HS HA; pose proof (small_depth n Hn) as Hc.
  assert (Hn3 : 3 <= INR n) by (apply le_INR in Hn; simpl in Hn; lra).
  pose proof (above_radius n k g lo hi Rad Hn HS HA) as HR. set (r := 1 - 4 / (PI * INR n ^ 3)) in *.
  destruct HS as [m F Hm|m F Hm]; destruct F as [mp np mm nm HF]; cbn [m_plus n_plus m_minus n_minus] in *;
    pose proof HF as (Hp & E & Hp' & E').
  - destruct (Nat.eq_dec np 1) as [E1|Hnp].
    + assert (m = 1)%nat as -> by (rewrite E1 in E; destruct mp; lia || nia).
      cbn [Nat.eqb] in *; exists (1 / (2 * (INR n - 1))).
      assert (Hs : 1 / (2 * INR n) < 1 / (2 * (INR n - 1)) < INR 1 / INR n) by (split; apply fraction_lt; simpl; lra).
      split; [assumption|].
      destruct (S4_ends_stated n _ _ _ _ Rad Hn (left_side n 1 (Build_Farey _ _ _ _ _ _ HF) Hm) HA) as (_ & _ & H0).
      cbn in H0; rewrite (H0 eq_refl _ Hs ltac:(lra)); unfold r; lra.
    + pose proof (left_area n m mp np mm nm Hn Hm HF) as HAr. set (s := (INR m - 1 / (2 * INR np)) / INR n).
      assert (Hnp2 : 2 <= INR np) by (apply (le_INR 2); lia).
      assert (Es : INR m - INR n * s = 1 / (2 * INR np)) by (unfold s; field; lra).
      assert (Eje : INR np * (1 / (2 * INR np)) = 1 / 2) by (field; lra).
      assert (Hs : (if (m =? 1)%nat then 1 / (2 * INR n) else INR mp / INR np) < s < INR m / INR n).
      { apply (left_interval n m mp np mm nm s Hn Hm HF); rewrite Es; split; [|lra].
        split; [assumption|split; [lia|]]; split; [apply Rdiv_lt_0_compat; lra|].
        apply (Rmult_lt_reg_l (INR np)); [lra|]; rewrite Eje; lra. }
      exists s; split; [assumption|]. apply (radius_h n Plus _ _ np _ Rad HAr HR s r Hs); [unfold r; lra|]; rewrite Es.
      apply h_middle; trivial; [lia|unfold r; lra|unfold r; lra].
  - pose proof (right_area n m mp np mm nm Hn Hm HF) as HAr. set (s := (INR m + 1 / (2 * INR nm)) / INR n).
    assert (nm <> 1)%nat by (intros ->; destruct mm; nia). assert (Hnm2 : 2 <= INR nm) by (apply (le_INR 2); lia).
    assert (Es : INR n * s - INR m = 1 / (2 * INR nm)) by (unfold s; field; lra).
    assert (Eje : INR nm * (1 / (2 * INR nm)) = 1 / 2) by (field; lra).
    assert (Hs : INR m / INR n < s < INR mm / INR nm).
    { apply (right_interval n m mp np mm nm s Hn Hm HF); rewrite Es; split; [|lra].
      split; [assumption|split; [lia|]]; split; [apply Rdiv_lt_0_compat; lra|].
      apply (Rmult_lt_reg_l (INR nm)); [lra|]; rewrite Eje; lra. }
    exists s; split; [assumption|]. apply (radius_h n Minus _ _ nm _ Rad HAr HR s r Hs); [unfold r; lra|]; rewrite Es.
    apply h_middle; trivial; [lia|unfold r; lra|unfold r; lra].
Qed.
