(** * (iv), the exponent: the next contact is a bounded number of passes on, and stretches multiply *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Derivatives StatementOscillator.
From Grazing Require Import StatementTrapped TrappedCalculus TrappedFlow TrappedReturn TrappedMain
  TrappedCone.
Open Scope R_scope.

Section Exponent.
Variables (M : machine) (lo hi : R) (m : Z).
Hypothesis H : hump M lo hi.
Hypothesis Hb : 0 < alb M /\ least_slip M <= zm M /\ least_speed M <= Vm M.
Hypothesis Ho : 0 < alo M.
Hypothesis Br : brief M m.
Notation a := (a M). Notation b := (b M). Notation tau := (tau M). Notation p := (p M). Notation W := (W M).
Notation mu := (mu M). Notation Q := (Q M). Notation Q1 := (Q1 M).
Let Hab := overdamped _ _ _ H.

Lemma phi12_less S T : S <= T -> phi12 M T <= exp (- a * S) / (b - a).
Proof.
  intros L; apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|]; pose proof (exp_pos (- b * T)); pose proof
    (exp_down a S T ltac:(lra) L); lra.
Qed.
Lemma at_most_m k n t V t' V' x v : in_pass M lo hi k t -> in_pass M lo hi (k + n) t' -> trapped M t V ->
  leg M t V t' V' x v -> (n <= m)%Z.
Proof.
  intros Pt Pt' (q1 & q2 & q3) [F X0 V0 L Op _ _]; destruct Br as [m1 Low]; cbv zeta in Low. destruct (Z_le_gt_dec n
    m) as [|G];
    trivial; exfalso; destruct (sizes M lo hi H) as [w1 w2]. destruct (reached _ _ _ H) as (s0 & E0);
    destruct (pass_of M lo hi H s0) as (j & Hj).
  { rewrite E0; destruct (positives M lo hi H); lra. }
  set (s := s0 + p * IZR (k + m - j)). assert (Es : Q s = mu) by (unfold s; rewrite (Q_whole M lo hi H);
    trivial). assert (Ps : in_pass M lo hi (k + m) s) by (unfold s, in_pass in *; rewrite minus_IZR; lra).
  assert (B1 : t < s) by (apply (pass_order M lo hi H k (k + m)); trivial; lia).
  assert (B2 : s < t') by (apply (pass_order M lo hi H (k
    + m) (k + n)); trivial; lia). specialize (Op s ltac:(lra)); rewrite Es, (x_flow M Hab x v F t s), X0, V0 in Op.
    pose proof (apart_pass M lo hi H k m t s Pt Ps) as Ap; assert (1 <= IZR m) by (apply (IZR_le 1); lia).
    assert (p * 1 <= p * IZR m) by (apply Rmult_le_compat_l; lra); set (T := p * IZR m - W) in *.
    destruct (phi11_down M Hab T (s
    - t) ltac:(unfold T in *; lra)) as [D1 D2]. pose proof (phi12_less T (s - t) ltac:(lra)) as D3; pose proof
    (phi12_pos M Hab (s - t) ltac:(lra)) as D4. pose proof (highest _ _ _ H t) as Ht; pose proof (restitution _ _ _ H)
      as Htau; unfold zeta in q3. assert (phi11 M (s - t) * Q t <= phi11 M T * mu) by (apply Rmult_le_compat;
      lra). assert (0 <= a * Q t) by (apply Rmult_le_pos; lra). assert (tau * - V <= tau * Vm M) by (apply
      Rmult_le_compat_l; lra). pose proof (zm_pos M lo hi H Hb); assert (0 <= tau * - V) by (apply Rmult_le_pos;
      lra). assert (phi12 M (s - t)
    * (Q1 t - tau * V) <= phi12 M (s - t) * ((1 + tau) * Vm M + zm M)) by (apply Rmult_le_compat_l; lra). assert
    (phi12 M (s - t) * ((1 + tau) * Vm M + zm M) <= exp (- a * T) / (b - a) * ((1 + tau) * Vm M + zm M)) by (apply
      Rmult_le_compat_r; lra). unfold Rdiv in *; lra.
Qed.
End Exponent.

(** There is such a number. *)
Lemma some_brief M lo hi : opens M lo hi -> exists m, brief M m.
Proof.
  intros [H Hb Ho]; pose proof (overdamped _ _ _ H) as Hab; destruct (sizes M lo hi H) as [w1 w2], (positives M lo hi
    H) as [hmu _]; pose proof (zm_pos M lo hi H Hb) as Zp; pose proof (Vm_pos M lo hi H Hb) as Vp; pose proof
      (restitution _ _ _ H) as Ht. set (D := b M - a M); set (K := (1 + tau M) * Vm M + zm M).
  assert (K0 : 0 < K) by (assert (0 <= tau M * Vm M) by (apply Rmult_le_pos; lra); unfold K; lra).
  set (C := (b M * mu M + K) / (D * mu M)); assert (0 < b M * mu M) by (apply Rmult_lt_0_compat; lra).
  assert (C0 : 0 < C) by (apply Rdiv_lt_0_compat; [lra|apply Rmult_lt_0_compat; unfold D; lra]).
  destruct (archimed ((C / a M + W M) / p M)) as [A _]; set (m := up ((C / a M + W M) / p M)) in *.
  assert (0 < C / a M) by (apply Rdiv_lt_0_compat; lra); assert (0 < (C / a M + W M) / p M) by (apply
    Rdiv_lt_0_compat; lra). exists m; constructor; [assert (0 < m)%Z by (apply lt_IZR; lra); lia|]; cbv zeta; fold D
    K.
  set (T := p M * IZR m - W M). assert (LT : C / a M < T).
  { apply (Rmult_lt_compat_l (p M)) in A; [|lra]; replace (p M * ((C / a M + W M) / p M)) with (C / a M + W M) in A by
      (field; lra); unfold T; lra. } assert (Ca : C < a M * T) by (apply (Rmult_lt_compat_l (a M)) in LT; [|lra];
  replace (a M * (C / a M)) with C in LT by (field; lra); exact LT). pose proof (exp_ineq1_le (a M * T)) as X; set (e
    := exp (- a M * T)).
  assert (E : e * exp (a M * T) = 1) by (unfold e; rewrite <- exp_plus; replace (- a M * T + a M * T) with 0 by ring;
    apply exp_0). assert (e0 : 0 < e) by apply exp_pos; assert (eC : e * C < 1) by (rewrite <- E; apply
    Rmult_lt_compat_l; lra). pose proof (exp_pos (- b M * T)).
  replace (phi11 M T) with (e * b M / D - a M * exp (- b M * T) / D) by (unfold phi11, e, D; field; lra).
  assert (0 <= a M * exp (- b M * T) / D * mu M) by (apply Rmult_le_pos; [|lra]; apply Rmult_le_pos; [apply
    Rmult_le_pos; lra|left; apply Rinv_0_lt_compat; unfold D; lra]). apply (Rmult_lt_compat_r (mu M)) in eC; [|lra].
  replace (e * C * mu M) with (e * b M / D * mu M + e * K / D) in eC by (unfold C, D; field; unfold D in *; lra). lra.
Qed.

Lemma grows M lo hi theta m : opens M lo hi -> by_passes M theta m -> grow M lo hi theta.
Proof.
  intros [H Hb Ho] [Br HE] N t V x v d w [HM Tr] Neg Ret C0. assert (All : forall i, cone M (d i) (w i)
    /\ exp (theta * IZR (N i - N 0%nat)) * Rabs (d 0%nat) <= Rabs (d i)).
  { induction i as [|i [Ci Gi]].
    - split; [exact C0|]; rewrite Z.sub_diag, Rmult_0_r, exp_0; lra.
    - destruct (HM i) as [Pi Leg]; destruct (HM (S i)) as [Pi1 _]. destruct (return_trapped M lo hi H Hb Ho _ _ _ _ _
        _ _ Pi (Tr i) Leg) as (_ & n & Hn & Pn). assert (En : N (S i) = (N i + n)%Z) by apply (one_pass M lo hi H _ _
        _ Pi1 Pn). pose proof (at_most_m M lo hi m H Hb Br (N i) n _ _ _ _ _ _ Pi Pn (Tr i) Leg) as Hm.
      destruct (Cone M lo hi {| is_hump := H; opens_before := Hb; opens_after := Ho |} _ _ _ _ _ _ (N i) n (d i) (w i)
        (exp (theta * IZR n)) (Tr i) (Neg i) Leg Pi Pn (HE n ltac:(lia)) Ci) as (_ & C1 & G1).
      destruct (Ret i) as [-> ->]; split; [exact C1|]; apply Rle_trans with (2 := G1); rewrite En.
      replace (N i + n - N 0%nat)%Z with (n + (N i - N 0%nat))%Z by ring; rewrite plus_IZR.
      replace (theta * (IZR n + IZR (N i - N 0%nat))) with (theta * IZR n + theta * IZR (N i - N 0%nat)) by ring.
      rewrite exp_plus, Rmult_assoc; apply Rmult_le_compat_l; [left; apply exp_pos|exact Gi]. }
  intros i; apply All.
Qed.
Theorem Exponent : Exponent_statement.
Proof.
  intros M lo hi O; split; [intros theta m; apply grows, O|]; intros E [_ E1 St]; destruct (some_brief M lo hi O) as
    (m & Br). pose proof (some_pass _ _ Br) as m1; assert (m0 : 1 <= IZR m) by (apply (IZR_le 1), m1); assert (L : 0 <
    ln E) by (rewrite <- ln_1; apply ln_increasing; lra). assert (Th : 0 < ln E / IZR m) by (apply Rdiv_lt_0_compat;
    lra).
  exists (ln E / IZR m); split; [exact Th|]; apply (grows M lo hi _ m O); split; [exact Br|]; intros n Hn.
  assert (Le : exp (ln E / IZR m * IZR n) <= E).
  { rewrite <- (exp_ln E) at 2 by lra; assert (X : ln E / IZR m * IZR n <= ln E / IZR m * IZR m) by (apply
      Rmult_le_compat_l; [lra|apply IZR_le; lia]). replace (ln E / IZR m * IZR m) with (ln E) in X by (field; lra).
    destruct X as [X|X]; [left; apply exp_increasing, X|rewrite X; lra]. } destruct (St n ltac:(lia)) as [S|S];
  [left|right]; lra.
Qed.
