(** * The function h(r) = r^j sin A + r^n sin B - sin (A + B) is > 0 above one radius at most

    Section 5 of ../conjecture1.md. With e = |n s - m|, A = 2 pi e and B = 2 pi (1 - j e)/n,
    the deciding b has the sign of h(r). If j e < 1, h increases in r and h(1) > 0,
    so h > 0 above one radius; if j e >= 1, h < 0 on (0, 1] but at r = 1, j e = 1. *)

From Coq Require Import Reals Lra Lia.
From Grazing Require Import LnCos Lattice.
Open Scope R_scope.

Lemma sin_subadditive A B : 0 < A < PI -> 0 < B < PI -> sin (A + B) < sin A + sin B.
Proof.
  intros HA HB; rewrite sin_plus.
  pose proof (sin_gt_0 A ltac:(lra) ltac:(lra)); pose proof (sin_gt_0 B ltac:(lra) ltac:(lra)). pose proof PI_RGT_0.
  assert (cos A < 1) by (rewrite <- cos_0; apply cos_decreasing_1; lra).
  assert (cos B < 1) by (rewrite <- cos_0; apply cos_decreasing_1; lra). nra.
Qed.

(** sin x / x decreases on (0, pi]. *)
Lemma sin_ratio x A : 0 < x <= A -> A <= PI -> x * sin A <= A * sin x.
Proof.
  intros Hx HA; destruct (Req_dec x A) as [->|Hne]; [lra|].
  destruct (MVT_cor2 sin cos 0 x) as (y & Ey & Hy); [lra|intros; apply derivable_pt_lim_sin|].
  destruct (MVT_cor2 sin cos x A) as (z & Ez & Hz); [lra|intros; apply derivable_pt_lim_sin|].
  assert (cos z < cos y) by (apply cos_decreasing_1; lra).
  rewrite sin_0 in Ey; replace (sin x) with (cos y * x) in * by lra.
  replace (sin A) with (cos y * x + cos z * (A - x)) by lra. assert (0 <= x * (A - x) * (cos y - cos z)); [|lra].
  apply Rmult_le_pos; [|lra]; apply Rmult_le_pos; lra.
Qed.

(** The chord of x -> x^j in x^n, strict. *)
Lemma pow_chord r j n : (1 <= j < n)%nat -> 0 < r < 1 -> INR n * r ^ j < INR j * r ^ n + (INR n - INR j).
Proof.
  intros [Hj Hjn] Hr; apply lt_INR in Hjn; apply le_INR in Hj; simpl in Hj.
  assert (E : forall k, r ^ k = exp (INR k * ln r)).
  { intros k; rewrite <- (exp_ln r ltac:(lra)) at 1; induction k as [|k IH].
    - simpl; now rewrite Rmult_0_l, exp_0.
    - rewrite S_INR, Rmult_plus_distr_r, Rmult_1_l, exp_plus, <- IH; simpl; ring. }
  assert (Hl : ln r < 0) by (rewrite <- ln_1; apply ln_increasing; lra).
  assert (T : forall x y, x <> y -> exp x * (1 + (y - x)) < exp y).
  { intros x y Hxy; replace (exp y) with (exp x * exp (y - x)) by (rewrite <- exp_plus; f_equal; ring).
    apply Rmult_lt_compat_l; [apply exp_pos|apply exp_ineq1; lra]. }
  rewrite !E; pose proof (T (INR j * ln r) (INR n * ln r) ltac:(nra)) as T1.
  pose proof (T (INR j * ln r) 0 ltac:(nra)) as T2; rewrite exp_0 in T2.
  set (x := exp (INR j * ln r)) in *; set (l := ln r) in *. apply (Rmult_lt_compat_l (INR j)) in T1; [|lra].
  apply (Rmult_lt_compat_l (INR n - INR j)) in T2; lra.
Qed.

Section Deciding.

Variables (n j : nat) (e : R).

Definition angle_A : R := 2 * PI * e.
Definition angle_B : R := 2 * PI * (1 - INR j * e) / INR n.
Definition h (r : R) : R :=
  r ^ j * sin angle_A + r ^ n * sin angle_B - sin (angle_A + angle_B).

Definition index : Prop := (3 <= n)%nat /\ (1 <= j <= n - 1)%nat /\ 0 < e < 1 / 2.
Hypothesis H : index.

Lemma h_continuous : continuity h. Proof. unfold h; reg. Qed.

Lemma n_ge_3 : 3 <= INR n /\ 1 <= INR j <= INR n - 1.
Proof.
  destruct H as (Hn & [Hj Hjn] & _); apply le_INR in Hjn.
  rewrite minus_INR in Hjn by lia; apply le_INR in Hn, Hj; simpl in Hn, Hj, Hjn; repeat split; lra.
Qed.

Lemma A_range : 0 < angle_A < PI.
Proof. destruct H as (_ & _ & He); pose proof PI_RGT_0; unfold angle_A; split; nra. Qed.
Lemma sin_A_pos : 0 < sin angle_A. Proof. pose proof A_range; apply sin_gt_0; lra. Qed.

Lemma B_range : INR j * e < 1 -> 0 < angle_B < PI.
Proof.
  intros Hje; destruct n_ge_3; destruct H as (_ & _ & He); pose proof PI_RGT_0. unfold angle_B; split.
  - apply Rdiv_lt_0_compat; nra.
  - apply (Rmult_lt_reg_r (INR n)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra.
    assert (0 < INR j * e) by nra; nra.
Qed.

Lemma pow_lt_compat_l x y k : (1 <= k)%nat -> 0 <= x < y -> x ^ k < y ^ k.
Proof.
  intros Hk Hx; induction k as [|[|k] IH]; [lia|simpl; lra|]. simpl in *; assert (0 <= x ^ k) by (apply pow_le; lra).
  apply Rmult_le_0_lt_compat; try nra; apply IH; lia.
Qed.

Lemma h_increasing x y : INR j * e < 1 -> 0 <= x < y -> h x < h y.
Proof.
  intros Hje Hx; pose proof (B_range Hje); pose proof sin_A_pos. assert (0 < sin angle_B) by (apply sin_gt_0; lra).
  destruct H as (? & ? & _). pose proof (pow_lt_compat_l x y j ltac:(lia) Hx).
  pose proof (pow_lt_compat_l x y n ltac:(lia) Hx). unfold h; nra.
Qed.

Lemma h_1_pos : INR j * e < 1 -> 0 < h 1.
Proof. intros Hje; pose proof (sin_subadditive _ _ A_range (B_range Hje)). unfold h; rewrite !pow1; lra. Qed.

(** For j e >= 1 no radius is left, except that h = 0 at r = 1 and j e = 1. *)
Lemma h_neg r : 1 <= INR j * e -> 0 < r <= 1 -> r < 1 \/ 1 < INR j * e -> h r < 0.
Proof.
  intros Hje Hr Hstrict; pose proof PI_RGT_0; pose proof A_range as HA; pose proof sin_A_pos as HsA.
  destruct n_ge_3 as [Hn Hj]; destruct H as (_ & Hjn & He).
  assert (Hr1 : r ^ n <= 1) by (rewrite <- (pow1 n); apply pow_incr; lra).
  assert (Hr0 : 0 < r ^ n) by (apply pow_lt; lra). set (B := - angle_B).
  assert (EB : INR n * B = INR j * angle_A - 2 * PI) by (unfold B, angle_B, angle_A; field; lra).
  assert (HB : 0 <= B < angle_A).
  { unfold angle_A in *; split; [apply (Rmult_le_reg_l (INR n))|apply (Rmult_lt_reg_l (INR n))]; nra. }
  unfold h; replace (angle_A + angle_B) with (angle_A - B) by (unfold B; ring).
  replace (sin angle_B) with (- sin B) by (unfold B; rewrite sin_neg; ring).
  (* at r = 0 *)
  assert (Q0 : (INR n - INR j) * sin angle_A <= INR n * sin (angle_A - B)).
  { pose proof (sin_ratio (angle_A - B) angle_A ltac:(lra) ltac:(lra)) as Q.
    assert ((INR n - INR j) * angle_A <= INR n * (angle_A - B)) by lra. apply (Rmult_le_reg_l angle_A); nra. }
  (* at r = 1 *)
  assert (Q1 : 0 < B -> sin angle_A < sin B + sin (angle_A - B)).
  { intros; replace angle_A with (B + (angle_A - B)) at 1 by ring; apply sin_subadditive; lra. }
  assert (Q1' : sin angle_A <= sin B + sin (angle_A - B)).
  { destruct (Req_dec B 0) as [->|]; [rewrite sin_0, Rminus_0_r; lra|apply Rlt_le, Q1; lra]. }
  assert (HB1 : 1 < INR j * e -> 0 < B) by (intros; unfold angle_A in *; apply (Rmult_lt_reg_l (INR n)); nra).
  set (x := r ^ n) in *; set (SA := sin angle_A) in *; set (D := sin (angle_A - B)) in *.
  apply (Rmult_le_compat_l (1 - x)) in Q0; [|lra].
  apply (Rmult_lt_reg_l (INR n)); [lra|]; destruct (Rlt_le_dec r 1) as [Hlt|Hge].
  - pose proof (pow_chord r j n ltac:(lia) ltac:(lra)) as Hc. apply (Rmult_lt_compat_r SA) in Hc; [|lra].
    apply (Rmult_le_compat_l (INR n * x)) in Q1'; [|nra]; fold x in Hc; lra.
  - assert (r = 1) as -> by lra; destruct Hstrict as [|Hs]; [lra|]; specialize (Q1 (HB1 Hs)).
    replace x with 1 in * by (unfold x; now rewrite pow1); rewrite pow1; nra.
Qed.

Lemma h_at_end : INR j * e = 1 -> h 1 = 0.
Proof.
  intros E; unfold h, angle_B; rewrite E, !pow1, Rminus_eq_0, Rmult_0_r.
  unfold Rdiv; rewrite Rmult_0_l, sin_0, Rplus_0_r; lra.
Qed.

End Deciding.

(** The radius above which h > 0. *)
Lemma threshold n j e : {x : R | index n j e -> INR j * e < 1 ->
  0 <= x < 1 /\ forall r, 0 < r -> (0 < h n j e r <-> x < r)}.
Proof.
  destruct (Rlt_le_dec (h n j e 0) 0) as [H0|H0]; [destruct (Rlt_le_dec 0 (h n j e 1)) as [H1|H1]|].
  - destruct (IVT (h n j e) 0 1 (h_continuous n j e) Rlt_0_1 H0 H1) as (x & Hx & Ex). exists x; intros Hi Hje; split.
    + split; [lra|]; destruct Hx as [_ [Hx|Hx]]; [assumption|subst; lra].
    + intros r Hr; split; intros Hlt.
      * apply Rnot_le_lt; intros [Hle|Hle]; [|subst; lra]. pose proof (h_increasing n j e Hi r x Hje ltac:(lra)); lra.
      * pose proof (h_increasing n j e Hi x r Hje ltac:(lra)); lra.
  - exists 0; intros Hi Hje; pose proof (h_1_pos n j e Hi Hje); lra.
  - exists 0; intros Hi Hje; split; [lra|]; intros r Hr; split; [lra|intros _].
    pose proof (h_increasing n j e Hi 0 r Hje ltac:(lra)); lra.
Qed.
