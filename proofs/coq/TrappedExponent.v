(** * (iv), the exponent: the next contact is a bounded number of passes on, and stretches multiply *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Derivatives StatementOscillator.
From Grazing Require Import StatementTrapped TrappedCalculus TrappedFlow TrappedReturn TrappedMain
  TrappedCone.
Open Scope R_scope.

Section Exponent.
Variables (M : machine) (lo hi : R) (m : Z).
Hypothesis H : hump M lo hi.
Hypothesis Hb : 0 < alb M.
Hypothesis Ho : 0 < alo M.
Hypothesis Br : brief M m.
Notation a := (a M). Notation b := (b M). Notation tau := (tau M). Notation p := (p M). Notation W := (W M).
Notation mu := (mu M). Notation Q := (Q M). Notation Q1 := (Q1 M).
Let Hab := overdamped _ _ _ H.

Lemma phi12_down S T : b * exp (- (b - a) * S) <= a -> S <= T -> phi12 M T <= phi12 M S.
Proof.
  intros F L; destruct (Req_dec S T) as [->|N]; [lra|]. destruct (MVT_cor2 (phi12 M) (phi22 M) S T) as (y & Ey & Hy);
    [lra|intros; apply D_phi12, Hab|]. assert (P : phi22 M y <= 0).
  { replace (phi22 M y) with (- (exp (- a * y) * ((a - b * exp (- (b - a) * y)) * / (b - a)))).
    2:{ unfold phi22; replace (- b * y) with (- a * y + - (b - a) * y) by ring; rewrite exp_plus; field; lra.
      }
    pose proof (exp_down (b - a) S y ltac:(lra) ltac:(lra)). assert (b * exp (- (b - a) * y) <= b * exp (- (b - a) *
      S)) by (apply Rmult_le_compat_l; lra). assert (0 <= exp (- a * y) * ((a - b * exp (- (b - a) * y)) * / (b -
      a))); [|lra]. apply Rmult_le_pos; [left; apply exp_pos|apply Rmult_le_pos; [lra|left;
      apply Rinv_0_lt_compat; lra]]. }
  assert (0 <= - phi22 M y * (T - S)) by (apply Rmult_le_pos; lra); lra.
Qed.
Lemma at_most_m k n t V t' V' x v : in_pass M lo hi k t -> in_pass M lo hi (k + n) t' -> trapped M t V ->
  leg M t V t' V' x v -> (n <= m)%Z.
Proof.
  intros Pt Pt' (q1 & q2 & q3) [F X0 V0 L Op _ _]; destruct Br as [m1 Fa Low]. destruct (Z_le_gt_dec n m) as [|G];
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
    - t) ltac:(unfold T in *; lra)) as [D1 D2]. pose proof (phi12_down T (s - t) Fa ltac:(lra)) as D3; pose proof
    (phi12_pos M Hab (s - t) ltac:(lra)) as D4. pose proof (highest _ _ _ H t) as Ht; pose proof (restitution _ _ _ H)
      as Htau; unfold zeta in q3. assert (phi11 M (s - t) * Q t <= phi11 M T * mu) by (apply Rmult_le_compat;
      lra). assert (0 <= a * Q t) by (apply Rmult_le_pos; lra). assert (tau * - V <= tau * Vm M) by (apply
      Rmult_le_compat_l; lra). pose proof (zm_pos M lo hi H); assert (0 <= tau * - V) by (apply Rmult_le_pos;
      lra). assert (phi12 M (s - t)
    * (Q1 t - tau * V) <= phi12 M (s - t) * ((1 + tau) * Vm M + zm M)) by (apply Rmult_le_compat_l; lra). assert
    (phi12 M (s - t) * ((1 + tau) * Vm M + zm M) <= phi12 M T * ((1 + tau) * Vm M + zm M)) by (apply
      Rmult_le_compat_r; lra). lra.
Qed.
End Exponent.

Theorem Exponent : Exponent_statement.
Proof.
  intros M lo hi theta m [H Hb Ho] Br HE N t V x v d w [HM Tr] Neg Ret C0. assert (All : forall i, cone M (d i) (w i)
    /\ exp (theta * IZR (N i - N 0%nat)) * Rabs (d 0%nat) <= Rabs (d i)).
  { induction i as [|i [Ci Gi]].
    - split; [exact C0|]; rewrite Z.sub_diag, Rmult_0_r, exp_0; lra.
    - destruct (HM i) as [Pi Leg]; destruct (HM (S i)) as [Pi1 _]. destruct (return_trapped M lo hi H Hb Ho _ _ _ _ _
        _ _ Pi (Tr i) Leg) as (_ & n & Hn & Pn). assert (En : N (S i) = (N i + n)%Z) by apply (one_pass M lo hi H _ _
        _ Pi1 Pn). pose proof (at_most_m M lo hi m H Br (N i) n _ _ _ _ _ _ Pi Pn (Tr i) Leg) as Hm.
      destruct (Cone M lo hi {| is_hump := H; opens_before := Hb; opens_after := Ho |} _ _ _ _ _ _ (N i) n (d i) (w i)
        (exp (theta * IZR n)) (Tr i) (Neg i) Leg Pi Pn (HE n ltac:(lia)) Ci) as (_ & C1 & G1).
      destruct (Ret i) as [-> ->]; split; [exact C1|]; apply Rle_trans with (2 := G1); rewrite En.
      replace (N i + n - N 0%nat)%Z with (n + (N i - N 0%nat))%Z by ring; rewrite plus_IZR.
      replace (theta * (IZR n + IZR (N i - N 0%nat))) with (theta * IZR n + theta * IZR (N i - N 0%nat)) by ring.
      rewrite exp_plus, Rmult_assoc; apply Rmult_le_compat_l; [left; apply exp_pos|exact Gi]. }
  intros i; apply All.
Qed.
