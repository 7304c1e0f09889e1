(** * At a1 = 2 r cos th, a2 = r^2 the quantities u_k, v_k, b_{n,k}, c_n are sines over sines

    Section 1 of ../conjecture1.md. The recurrences are solved by sines, which gives (62)
    and (A8); u_n = 0 is the same as sin (n th) = 0. *)

From Coq Require Import Reals Lra Lia.
From Grazing Require Import Defs Algebra.
Open Scope R_scope.

Section Polar.

Variables r th : R.
Hypothesis Hr : 0 < r.
Hypothesis Hth : sin th > 0.
Let a1 := 2 * r * cos th.
Let a2 := r ^ 2.

Lemma sin_rec x : sin (x + th + th) = 2 * cos th * sin (x + th) - sin x.
Proof. replace x with (x + th - th) at 3 by ring. rewrite sin_plus, sin_minus; ring. Qed.

Lemma u_polar k : u a1 a2 k * (r * sin th) = r ^ k * sin (INR k * th).
Proof.
  enough (H : u a1 a2 k * (r * sin th) = r ^ k * sin (INR k * th) /\ u a1 a2 (S k) * (r * sin th) = r ^ S k
    * sin (INR (S k) * th)) by apply H.
  induction k as [|k [IH1 IH2]].
  - change (INR 0) with 0; change (INR 1) with 1. rewrite u_0, u_1, !Rmult_0_l, !Rmult_1_l, sin_0; split; simpl; ring.
  - split; [exact IH2|]. replace (INR (S (S k)) * th) with (INR k * th + th + th) by (rewrite !S_INR; ring).
    rewrite sin_rec, u_SS. rewrite S_INR, Rmult_plus_distr_r, Rmult_1_l in IH2.
    rewrite Rmult_minus_distr_r, !Rmult_assoc, IH2, IH1. unfold a1, a2; simpl; ring.
Qed.

Lemma v_polar k : v a1 a2 k = 2 * r ^ k * cos (INR k * th).
Proof.
  apply (Rmult_eq_reg_r (r * sin th)); [|nra]. unfold v.
  replace ((2 * u a1 a2 (S k) - a1 * u a1 a2 k) * (r * sin th)) with (2 * (u a1 a2 (S k) * (r * sin th)) - a1
    * (u a1 a2 k * (r * sin th))) by ring.
  rewrite !u_polar, S_INR, Rmult_plus_distr_r, Rmult_1_l, sin_plus. unfold a1; simpl; ring.
Qed.

Lemma u_zero n : u a1 a2 n <> 0 <-> sin (INR n * th) <> 0.
Proof.
  pose proof (u_polar n) as E; pose proof (pow_lt r n Hr). split; intros Hne H0; apply Hne; rewrite H0 in E.
  - apply (Rmult_eq_reg_r (r * sin th)); nra.
  - apply (Rmult_eq_reg_l (r ^ n)); nra.
Qed.

(** (62) *)
Lemma b_polar n k : (k <= n)%nat -> u a1 a2 n <> 0 -> b a1 a2 n k * (r ^ n * sin (INR n * th)) = r ^ n
  * sin (INR n * th) - r ^ k * sin (INR k * th) - r ^ (n + k) * sin (INR (n - k) * th).
Proof.
  intros Hk Hu; unfold b. replace (n + k)%nat with (k + k + (n - k))%nat by lia.
  replace (a2 ^ k) with (r ^ (k + k)) by (unfold a2; rewrite <- pow_mult; f_equal; lia).
  rewrite (pow_add r (k + k)), (Rmult_assoc (r ^ (k + k))). rewrite <- !u_polar; field; exact Hu.
Qed.

(** (A8) *)
Lemma c_polar n : u a1 a2 n <> 0 -> c a1 a2 n * (r ^ n * sin (INR n * th)) = - (r * sin th)
  * (1 - 2 * r ^ n * cos (INR n * th) + (r ^ n) ^ 2).
Proof.
  intros Hu; unfold c; rewrite v_polar.
  replace (a2 ^ n) with ((r ^ n) ^ 2) by (unfold a2; rewrite <- !pow_mult; f_equal; lia).
  rewrite <- u_polar; field; exact Hu.
Qed.

End Polar.
