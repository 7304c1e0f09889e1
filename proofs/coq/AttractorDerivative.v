(** * Derivatives in the plane: the chain rule, the derivative of a step *)
From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import StatementPlane.
From Grazing Require Import StatementAttractor AttractorAlgebra.
Open Scope R_scope.

(** ** The norm *)
Lemma norm_le x t : norm x <= t <-> Rabs (fst x) <= t /\ Rabs (snd x) <= t.
Proof.
  unfold norm. split.
  - intros H. pose proof (Rmax_l (Rabs (fst x)) (Rabs (snd x))). pose proof (Rmax_r (Rabs (fst x)) (Rabs (snd x))).
    lra.
  - intros [H1 H2]. apply Rmax_lub; assumption.
Qed.
Lemma norm_fst x : Rabs (fst x) <= norm x. Proof. apply Rmax_l. Qed.
Lemma norm_snd x : Rabs (snd x) <= norm x. Proof. apply Rmax_r. Qed.
Lemma norm_pos x : 0 <= norm x. Proof. pose proof (norm_fst x). pose proof (Rabs_pos (fst x)). lra. Qed.
Definition size (J : mat) : R := Rabs (m11 J) + Rabs (m12 J) + Rabs (m21 J) + Rabs (m22 J).
Lemma size_pos J : 0 <= size J.
Proof. unfold size. pose proof (Rabs_pos (m11 J)). pose proof (Rabs_pos (m12 J)).
  pose proof (Rabs_pos (m21 J)). pose proof (Rabs_pos (m22 J)). lra. Qed.
Lemma norm_apply J x : norm (apply J x) <= size J * norm x.
Proof.
  pose proof (norm_fst x) as H1. pose proof (norm_snd x) as H2. pose proof (norm_pos x) as H0.
  pose proof (Rabs_pos (m11 J)). pose proof (Rabs_pos (m12 J)). pose proof (Rabs_pos (m21 J)).
  pose proof (Rabs_pos (m22 J)). apply norm_le. unfold apply, size; simpl. split.
  - eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult. assert (Rabs (m11 J) * Rabs (fst x) <= Rabs (m11 J) *
      norm x) by (apply Rmult_le_compat_l; lra). assert (Rabs (m12 J) * Rabs (snd x) <= Rabs (m12 J) * norm x) by
      (apply Rmult_le_compat_l; lra). assert (0 <= Rabs (m21 J) * norm x) by (apply Rmult_le_pos; lra).
    assert (0 <= Rabs (m22 J) * norm x) by (apply Rmult_le_pos; lra). lra.
  - eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult. assert (Rabs (m21 J) * Rabs (fst x) <= Rabs (m21 J) *
      norm x) by (apply Rmult_le_compat_l; lra). assert (Rabs (m22 J) * Rabs (snd x) <= Rabs (m22 J) * norm x) by
      (apply Rmult_le_compat_l; lra). assert (0 <= Rabs (m11 J) * norm x) by (apply Rmult_le_pos; lra).
    assert (0 <= Rabs (m12 J) * norm x) by (apply Rmult_le_pos; lra). lra.
Qed.
Definition add (x y : R * R) : R * R := (fst x + fst y, snd x + snd y).
Lemma norm_add x y : norm (add x y) <= norm x + norm y.
Proof.
  apply norm_le. unfold add; simpl. pose proof (norm_fst x). pose proof (norm_fst y). pose proof (norm_snd x).
  pose proof (norm_snd y). split; (eapply Rle_trans; [apply Rabs_triang|]); lra.
Qed.
Lemma apply_mul P Q x : apply (mul P Q) x = apply P (apply Q x). Proof. unfold apply, mul; simpl. f_equal; ring. Qed.
Lemma mul_assoc P Q T : mul P (mul Q T) = mul (mul P Q) T. Proof. unfold mul; simpl. f_equal; ring. Qed.

(** ** The chain rule *)
Lemma chain F G x P Q : derivative F x P -> derivative G (F x) Q -> derivative (fun z => G (F z)) x (mul Q P).
Proof.
  intros HF HG eps Heps. pose proof (size_pos P) as SP. pose proof (size_pos Q) as SQ.
  set (e1 := Rmin 1 (eps / (2 * (size Q + 1)))). assert (He1 : 0 < e1).
  { unfold e1. apply Rmin_glb_lt; [lra|]. apply Rdiv_lt_0_compat; lra. } assert (He1' : size Q * e1 <= eps / 2).
  { assert (e1 <= eps / (2 * (size Q + 1))) by apply Rmin_r. assert (eps / (2 * (size Q + 1)) * (size Q + 1) = eps /
      2) by (field; lra). assert (size Q * e1 <= size Q * (eps / (2 * (size Q + 1)))) by (apply Rmult_le_compat_l;
      lra). assert (0 < eps / (2 * (size Q + 1))) by (apply Rdiv_lt_0_compat; lra). lra. }
  set (e2 := eps / (2 * (size P + 1))). assert (He2 : 0 < e2) by (unfold e2; apply Rdiv_lt_0_compat; lra).
  destruct (HF e1 He1) as (d1 & Hd1 & H1). destruct (HG e2 He2) as (d2 & Hd2 & H2). exists (Rmin d1 (d2 / (size P +
    1))). split. { apply Rmin_glb_lt; [lra|]. apply Rdiv_lt_0_compat; lra. } intros z Hz.
  assert (Hz1 : norm (sub z x) <= d1) by (eapply Rle_trans; [apply Hz|apply Rmin_l]). assert (Hz2 : norm (sub z x) <=
    d2 / (size P + 1)) by (eapply Rle_trans; [apply Hz|apply Rmin_r]). specialize (H1 z Hz1).
  set (t := norm (sub z x)) in *. assert (Ht : 0 <= t) by apply norm_pos. assert (L1 : norm (sub (F z) (F x)) <= (size
    P + 1) * t).
  { replace (sub (F z) (F x)) with (add (sub (sub (F z) (F x)) (apply P (sub z x))) (apply P (sub z x))).
    2:{ unfold add, sub, apply; simpl. f_equal; ring. }
    eapply Rle_trans; [apply norm_add|]. pose proof (norm_apply P (sub z x)) as HP. fold t in HP. assert (e1 * t <= 1
      * t) by (apply Rmult_le_compat_r; [lra|apply Rmin_l]). lra. }
  assert (L2 : norm (sub (F z) (F x)) <= d2).
  { apply (Rmult_le_compat_l (size P + 1)) in Hz2; [|lra]. replace ((size P + 1) * (d2 / (size P + 1))) with d2 in Hz2
      by (field; lra). lra. }
  specialize (H2 (F z) L2). replace (sub (sub (G (F z)) (G (F x))) (apply (mul Q P) (sub z x))) with (add (sub (sub (G
    (F z)) (G (F x))) (apply Q (sub (F z) (F x)))) (apply Q (sub (sub (F z) (F x)) (apply P (sub z x))))).
  2:{ rewrite apply_mul. unfold add, sub, apply; simpl. f_equal; ring. }
  eapply Rle_trans; [apply norm_add|]. pose proof (norm_apply Q (sub (sub (F z) (F x)) (apply P (sub z x)))) as HQ.
  assert (size Q * norm (sub (sub (F z) (F x)) (apply P (sub z x))) <= size Q * (e1 * t)) by (apply Rmult_le_compat_l;
    lra). assert (size Q * e1 * t <= eps / 2 * t) by (apply Rmult_le_compat_r; lra). assert (e2 * norm (sub (F z) (F
    x)) <= e2 * ((size P + 1) * t)) by (apply Rmult_le_compat_l; lra). replace (e2 * ((size P + 1)
    * t)) with (eps / 2 * t) in * by (unfold e2; field; lra). lra.
Qed.
Lemma derivative_one x : derivative (fun z => z) x one.
Proof.
  intros eps Heps. exists 1. split; [lra|]. intros z _. replace (sub (sub z x) (apply one (sub z x))) with (0, 0).
  2:{ unfold sub, apply, one; simpl. f_equal; ring. }
  apply norm_le; simpl. rewrite Rabs_R0. pose proof (norm_pos (sub z x)). split; apply Rmult_le_pos; lra.
Qed.

(** ** The square root *)
Lemma sqrt_near a h : 0 < a -> 0 <= a + h ->
  Rabs (sqrt (a + h) - sqrt a - h / (2 * sqrt a)) <= h ^ 2 / (2 * a * sqrt a).
Proof.
  intros Ha Hh. set (y := sqrt a). set (z := sqrt (a + h)). assert (Hy : 0 < y) by (apply sqrt_lt_R0; lra).
  assert (Hz : 0 <= z) by apply sqrt_pos. assert (Ey : y ^ 2 = a) by (unfold y; simpl; rewrite Rmult_1_r;
    apply sqrt_sqrt; lra). assert (Ez : z ^ 2 = a + h) by (unfold z; simpl; rewrite Rmult_1_r; apply sqrt_sqrt;
    lra). assert (Eh : h = z ^ 2 - y ^ 2) by lra. replace (z - y - h / (2 * y)) with (- ((z - y) ^ 2 / (2 * y))) by
    (rewrite Eh; field; lra). rewrite Rabs_Ropp, Rabs_pos_eq.
  2:{ apply Rmult_le_pos; [apply pow2_ge_0|]. left. apply Rinv_0_lt_compat. lra. }
  rewrite <- Ey. replace (h ^ 2 / (2 * y ^ 2 * y)) with (h ^ 2 / y ^ 2 / (2 * y)) by (field; lra).
  apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|]. apply le_div; [apply pow_lt; lra|].
  rewrite Eh. replace ((z ^ 2 - y ^ 2) ^ 2) with ((z - y) ^ 2 * (z + y) ^ 2) by ring. apply Rmult_le_compat_l;
    [apply pow2_ge_0|]. apply pow_incr. lra.
Qed.

Section Map.
Variables l1 l2 b nu : R.
Hypothesis Hl : 0 < l2 < l1.
Hypothesis Hl1 : l1 < 1.
Hypothesis Hb : 0 < b.
Notation height := (height l1 l2 nu).
Notation step := (step l1 l2 b nu).
Notation iterate := (iterate l1 l2 b nu).
Notation change := (change l1 l2).

Definition diag (p q : R) : mat := Mat p 0 0 q.
(** The derivative of a step, and of a number of them. *)
Definition D (x : R * R) : mat :=
  if Rle_dec 0 (height x) then diag l1 l2
  else let s := b / (2 * sqrt (- height x)) in Mat (l1 - s * l1) (s * l2) (- (s * l1)) (l2 + s * l2).
Fixpoint along (k : nat) (x : R * R) : mat := match k with O => one | S j => mul (D (iterate j x)) (along j x)
  end.

Lemma height_sub z x : height z - height x = change (sub z x).
Proof. unfold StatementAttractor.height, StatementAttractor.change, sub; simpl. ring. Qed.
Lemma change_le v : Rabs (change v) <= 2 * norm v.
Proof.
  unfold StatementAttractor.change. unfold Rminus. eapply Rle_trans; [apply Rabs_triang|].
  rewrite Rabs_Ropp, !Rabs_mult, (Rabs_pos_eq l1), (Rabs_pos_eq l2) by lra. pose proof (norm_fst v).
  pose proof (norm_snd v). pose proof (Rabs_pos (fst v)). pose proof (Rabs_pos (snd v)). nra.
Qed.

Lemma derivative_step x : height x <> 0 -> derivative step x (D x).
Proof.
  intros Hx eps Heps. unfold D. destruct (Rle_dec 0 (height x)) as [H|H].
  - exists (height x / 3). split; [lra|]. intros z Hz. assert (Hzx : 0 <= height z).
    { pose proof (height_sub z x) as E. pose proof (change_le (sub z x)) as C. rewrite <- E in C.
      unfold Rabs in C. destruct (Rcase_abs (height z - height x)); lra. }
    unfold StatementAttractor.step. destruct (Rle_dec 0 (height z)) as [_|N]; [|lra]. destruct (Rle_dec 0 (height x))
      as [_|N]; [|lra]. match goal with |- norm ?e <= _ => replace e with (0, 0) end.
    2:{ unfold sub, apply, diag; simpl. f_equal; ring. }
    pose proof (norm_pos (sub z x)). apply norm_le; simpl. rewrite Rabs_R0. split; apply Rmult_le_pos; lra.
  - assert (Ha : 0 < - height x) by lra. set (a := - height x) in *. assert (Hs : 0 < sqrt a) by (apply sqrt_lt_R0;
      lra). set (k := b * 4 / (2 * a * sqrt a)). assert (Hk : 0 < k).
    { unfold k. apply Rdiv_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; lra. } exists (Rmin (a / 3) (eps / k)).
      split.
    { apply Rmin_glb_lt; [lra|]. apply Rdiv_lt_0_compat; lra. } intros z Hz. set (h := - change (sub z x)).
    assert (Hz1 : norm (sub z x) <= a / 3) by (eapply Rle_trans; [apply Hz|apply Rmin_l]).
    assert (Hz2 : norm (sub z x) <= eps / k) by (eapply Rle_trans; [apply Hz|apply Rmin_r]).
    assert (Eh : - height z = a + h). { pose proof (height_sub z x). unfold a, h. lra.
    } pose proof (change_le (sub z x)) as C. set (t := norm (sub z x)) in *. assert (Ht : 0 <= t) by apply norm_pos.
    assert (Ch : Rabs h <= 2 * t) by (unfold h; rewrite Rabs_Ropp; exact C). assert (Hah : 0 < a + h).
    { unfold Rabs in Ch. destruct (Rcase_abs h); lra. }
    assert (HR : Rabs (b * (sqrt (a + h) - sqrt a - h / (2 * sqrt a))) <= eps * t).
    { rewrite Rabs_mult, (Rabs_pos_eq b) by lra. pose proof (sqrt_near a h Ha (Rlt_le _ _ Hah)) as Q.
      assert (Hh2 : h ^ 2 <= 4 * t * t).
      { rewrite <- (pow2_abs h). assert (0 <= Rabs h) by apply Rabs_pos. assert (Rabs h ^ 2 <= (2 * t) ^ 2) by (apply
          pow_incr; lra). lra. }
      assert (Q2 : b * (h ^ 2 / (2 * a * sqrt a)) <= k * t * t).
      { replace (k * t * t) with (b * (4 * t * t / (2 * a * sqrt a))) by (unfold k; field; lra).
        apply Rmult_le_compat_l; [lra|]. unfold Rdiv. apply Rmult_le_compat_r; [|exact Hh2]. left.
        apply Rinv_0_lt_compat. apply Rmult_lt_0_compat; lra. }
      assert (Q3 : k * t <= eps).
      { apply (Rmult_le_compat_l k) in Hz2; [|lra]. replace (k * (eps / k)) with eps in Hz2 by (field; lra). lra. }
      assert (k * t * t <= eps * t) by (apply Rmult_le_compat_r; lra). assert (b * Rabs (sqrt (a + h) - sqrt a - h /
        (2 * sqrt a)) <= b * (h ^ 2 / (2 * a * sqrt a))) by (apply Rmult_le_compat_l; lra). lra. }
    unfold StatementAttractor.step. destruct (Rle_dec 0 (height z)) as [N|_]; [lra|]. destruct (Rle_dec 0 (height x))
      as [N|_]; [lra|]. fold a. rewrite Eh. match goal with |- norm ?e <= _ => replace e with (b * (sqrt (a + h) -
      sqrt a - h / (2 * sqrt a)), b * (sqrt (a + h) - sqrt a - h / (2 * sqrt a))) end.
    2:{ unfold h, StatementAttractor.change, sub, apply; simpl. f_equal; field; lra. }
    apply norm_le; simpl. split; exact HR.
Qed.

Lemma derivative_iterate k x : (forall j, (j < k)%nat -> height (iterate j x) <> 0) -> derivative (iterate k)
  x (along k x).
Proof.
  induction k as [|k IH]; intros H.
  - exact (derivative_one x).
  - apply (chain (iterate k) step).
    + apply IH. intros j Hj. apply H. lia.
    + apply derivative_step. apply H. lia.
Qed.

(** ** Composition, determinants *)
Lemma iterate_add j n x : iterate (j + n) x = iterate j (iterate n x).
Proof. unfold StatementAttractor.iterate. induction j as [|j IH]; simpl; [reflexivity|rewrite IH; reflexivity]. Qed.
Lemma iterate_S n x : iterate (S n) x = iterate n (step x).
Proof. replace (S n) with (n + 1)%nat by lia. apply iterate_add. Qed.
Lemma along_add j n x : along (j + n) x = mul (along j (iterate n x)) (along n x).
Proof.
  induction j as [|j IH].
  - simpl. destruct (along n x). unfold mul, one; simpl. f_equal; ring.
  - simpl. rewrite IH, iterate_add. apply mul_assoc.
Qed.
Definition det (P : mat) : R := m11 P * m22 P - m12 P * m21 P.
Lemma det_mul P Q : det (mul P Q) = det P * det Q. Proof. unfold det, mul; simpl. ring. Qed.
Lemma det_along k x : det (along k x) = (l1 * l2) ^ k.
Proof.
  induction k as [|k IH]; simpl; [unfold det, one; simpl; ring|]. rewrite det_mul, IH. f_equal. unfold D.
  destruct (Rle_dec 0 (height (iterate k x))); unfold det, diag; simpl; ring.
Qed.
End Map.
