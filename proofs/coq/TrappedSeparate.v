(** (iii) for finite displacements, for ever: ordered motions with the same passes are the same. *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Derivatives StatementOscillator.
From Grazing Require Import StatementTrapped TrappedCalculus TrappedFlow TrappedReturn TrappedMain.
Open Scope R_scope.

Section Separate.
Variables (M : machine) (lo hi E : R).
Hypothesis H : hump M lo hi.
Hypothesis Hb : 0 < alb M /\ least_slip M <= zm M /\ least_speed M <= Vm M.
Hypothesis Ho : 0 < alo M.
Hypothesis HE : 1 < E.
Notation a := (a M). Notation b := (b M). Notation tau := (tau M). Notation p := (p M). Notation W := (W M).
Notation mu := (mu M). Notation Q := (Q M). Notation Q1 := (Q1 M).
Let Hab := overdamped _ _ _ H.
Let Htau := restitution _ _ _ H.

(** The lower motion hits first; it is lower by h or more at the later contact. *)
Definition ordered (x v y w : R -> R) (tx ty h : R) : Prop := tx <= ty /\ h <= y ty - x ty /\ 0 <= y ty - x ty
  /\
  0 <= zet M y w ty - zet M x v ty.

(** E Vm <= sigma phi12 T whenever T is between two returns n passes on. *)
Lemma rate n T T1 T2 : E <= A_ M n \/ E <= B_ M n -> p * n - W <= T <= p * n + W -> T1 <= T <= T2 ->
  0 <= T1 ->
  Ql M - phi11 M (p * n - W) * mu <= phi12 M T1 * ((1 + tau) * Vm M + zm M) ->
  Ql M - phi11 M (p * n - W) * mu <= phi12 M T2 * ((1 + tau) * Vm M + zm M) -> E * Vm M <= sigma M * phi12 M
    T.
Proof.
  intros HEn HT HT12 HT1 F1 F2; pose proof (Vm_pos M lo hi H Hb) as Vp; pose proof (zm_pos M lo hi H Hb) as Zp.
  pose proof (sigma_pos M lo hi H Hb Ho) as Sp. destruct HEn as [A|B].
  - apply Rle_trans with (sigma M * ell M n).
    + apply (Rmult_le_compat_r (Vm M)) in A; [|lra]; unfold A_ in A. replace (sigma M * ell M n / Vm M * Vm M) with
        (sigma M * ell M n) in A by (field; lra); trivial.
    + apply Rmult_le_compat_l; [lra|]; apply phi12_between; trivial.
  - assert (0 <= tau * Vm M) by (apply Rmult_le_pos; lra); set (C := (1 + tau) * Vm M + zm M) in *.
    assert (Cp : 0 < C) by (unfold C; lra); set (q := Ql M - phi11 M (p * n - W) * mu) in *.
    assert (F : q <= phi12 M T * C).
    { pose proof (phi12_between M Hab T1 T2 T HT12) as Min; revert Min; unfold Rmin; destruct Rle_dec; intros.
      - apply Rle_trans with (phi12 M T1 * C); trivial; apply Rmult_le_compat_r; lra.
      - apply Rle_trans with (phi12 M T2 * C); trivial; apply Rmult_le_compat_r; lra. }
    unfold B_ in B; fold C q in B; apply (Rmult_le_compat_r (C * Vm M)) in B; [|apply Rmult_le_pos; lra].
    replace (sigma M * q / (C * Vm M) * (C * Vm M)) with (sigma M * q) in B by (field; lra).
    apply Rmult_le_reg_r with C; trivial. assert (sigma M * q <= sigma M * (phi12 M T * C)) by (apply
      Rmult_le_compat_l; lra); lra.
Qed.

Section Two.
Variables (N : nat -> Z).
Hypothesis HN : forall n, (1 <= n)%Z -> stretches M E n.

Lemma ordered_step i t V x v t' V' x' v' h : motion M lo hi N t V x v -> motion M lo hi N t' V' x' v' ->
  (forall i, trapped M (t i) (V i)) -> (forall i, trapped M (t' i) (V' i)) -> 0 <= h ->
  ordered (x i) (v i) (x' i) (v' i) (t (S i)) (t' (S i)) h ->
  h <= Vm M * W /\
  ordered (x' (S i)) (v' (S i)) (x (S i)) (v (S i)) (t' (S (S i))) (t (S (S i))) (E * h).
Proof.
  intros HM HM' Tr Tr' h0 (L & Hh & Hp & Hz). destruct (HM i) as [_ [Fx _ _ _ _ x1 v1]];
    destruct (HM (S i)) as [P1 Leg]; destruct (HM (S (S i))) as [P1n _]. destruct (HM' i) as [_ [Fy _ _ _ _ y2 w2]];
    destruct (HM' (S i)) as [P2 Leg']; destruct (HM' (S (S i))) as [P2n _]. destruct (return_trapped M lo hi H Hb Ho _
    _ _ _ _ _ _ P1 (Tr (S i)) Leg) as (_ & n & Hn & Pn). assert (En : N (S (S i)) = (N (S i) + n)%Z) by apply
    (one_pass M lo hi H _ _ _ P1n Pn); rewrite En in P1n, P2n. pose proof (far M lo hi H _ _ _ _ _ _ _ _ Hn P1 P1n (Tr
    _) (Tr _) Leg) as F1. pose proof (far M lo hi H _ _ _ _ _ _ _ _ Hn P2 P2n (Tr' _) (Tr' _) Leg') as F2.
  destruct Leg as [FX X1 X1' _ _ X3 _]; destruct Leg' as [FY Y2 Y2' _ Open Y3 _]. destruct (impact M lo hi H (zm M)
    (Vm M) (N
    (S i)) (t (S i)) (t' (S i)) (V (S i)) (V' (S i)) (x i) (v i) (x' i) (v' i) (x (S i)) (v (S i)) (x' (S i)) (v' (S
    i)) P1 P2 L (Tr (S i)) Ho Fx FX x1 v1 y2 w2 X1 X1' Y2 Y2') as (I1 & I2 & I3); change (strength M (zm M) (Vm M))
    with (sigma M) in I2. set (t1 := t (S i)) in *;
    set (t2 := t' (S i)) in *; set (T1 := t (S (S i))) in *; set (T2 := t' (S (S i))) in *.
  pose proof (sigma_pos M lo hi H Hb Ho) as Sp; pose proof (Vm_pos M lo hi H Hb) as Vp.
  assert (O1 : 0 <= x (S i) t2 - x' (S i) t2) by (assert (0 <= tau * (x' i t2 - x i t2)) by (apply Rmult_le_pos;
    lra); lra). assert (O2 : 0 <= sigma M * (t2 - t1)) by (apply Rmult_le_pos; lra).
  assert (O3 : 0 <= tau * (zet M (x' i) (v' i) t2 - zet M (x i) (v i) t2)) by (apply Rmult_le_pos; lra).
  assert (LT : t2 < T1) by (apply (pass_order M lo hi H (N (S i)) (N (S i) + n)); trivial; lia).
  assert (LT2 : t1 < T2) by (apply (pass_order M lo hi H (N (S i)) (N (S i) + n)); trivial; lia).
  destruct (keep_order M lo hi H (x' (S i)) (v' (S i)) (x (S i)) (v (S i)) t2 T1 FY FX ltac:(lra) O1 ltac:(lra)) as
    [K1 K2]. assert (OT : T2 <= T1). { apply Rnot_lt_le; intros C; specialize (Open T1 ltac:(lra)); lra. } split.
  - apply Rle_trans with (Vm M * (t2 - t1)); [lra|apply Rmult_le_compat_l; [lra|]]. destruct (sizes M _ _ H);
      unfold in_pass in *; lra.
  - split; trivial; split; [|split; trivial]. destruct (keep M lo hi H (x' (S i)) (v' (S i)) (x (S i)) (v (S i)) t2 T1
      FY FX ltac:(lra)) as [-> _]. assert (LT3 : t2 < T2) by (apply (pass_order M lo hi H (N (S i)) (N (S i) + n));
      trivial; lia). assert (R : E * Vm M <= sigma M * phi12 M (T1 - t2)).
    { assert (ApT : p * IZR n - W <= T1 - t2 <= p * IZR n + W) by (apply (apart_pass M lo hi H (N (S i)));
        trivial). apply (rate (IZR n) (T1 - t2) (T2 - t2) (T1 - t1)); trivial; try lra; apply HN, Hn. }
    pose proof (phi12_pos M Hab (T1 - t2) ltac:(lra)) as Pp; pose proof (exp_pos (- a * (T1 - t2))).
    assert (0 <= exp (- a * (T1 - t2)) * (x (S i) t2 - x' (S i) t2)) by (apply Rmult_le_pos; lra).
    assert (phi12 M (T1 - t2) * (sigma M * (t2 - t1)) <= phi12 M (T1 - t2) * (zet M (x (S i)) (v (S i)) t2 - zet M (x'
      (S i)) (v' (S i)) t2)) by (apply Rmult_le_compat_l; lra). assert (E * Vm M * (t2 - t1) <= sigma M * phi12 M (T1
      - t2) * (t2 - t1)) by (apply Rmult_le_compat_r; lra). assert (E * h <= E * (Vm M * (t2 - t1))) by (apply
      Rmult_le_compat_l; lra); lra.
Qed.

Lemma ordered_bound j : forall i t V x v t' V' x' v' h, motion M lo hi N t V x v -> motion M lo hi N t' V' x'
  v' ->
  (forall i, trapped M (t i) (V i)) -> (forall i, trapped M (t' i) (V' i)) -> 0 <= h ->
  ordered (x i) (v i) (x' i) (v' i) (t (S i)) (t' (S i)) h -> E ^ j * h <= Vm M * W.
Proof.
  induction j as [|j IH]; intros i t V x v t' V' x' v' h HM HM' Tr Tr' h0 O; destruct (ordered_step i t V x v t' V' x'
    v' h HM HM' Tr Tr' h0 O) as [B O'].
  - cbn; lra.
  - replace (E ^ S j * h) with (E ^ j * (E * h)) by (cbn; ring). apply (IH (S i) t' V' x' v' t V x v (E * h));
      trivial; apply Rmult_le_pos; lra.
Qed.

Lemma no_growth h B : 0 <= h -> (forall j, E ^ j * h <= B) -> h = 0.
Proof.
  intros h0 HB; destruct (Req_dec h 0) as [|N0]; trivial; exfalso. destruct (Pow_x_infinity E ltac:(rewrite
    Rabs_right; lra) (B / h + 1)) as (j & Hj); specialize (Hj j (le_n j)). rewrite Rabs_right in Hj by (apply Rle_ge,
    pow_le; lra); specialize (HB j). apply Rge_le, (Rmult_le_compat_r h) in Hj; [|trivial].
  replace ((B / h + 1) * h) with (B + h) in Hj by (field; lra); lra.
Qed.

Lemma separate t V x v t' V' x' v' s : motion M lo hi N t V x v -> motion M lo hi N t' V' x' v' ->
  (forall i, trapped M (t i) (V i)) -> (forall i, trapped M (t' i) (V' i)) ->
  t 0%nat <= s < t 1%nat -> t' 0%nat <= s < t' 1%nat ->
  0 <= x' 0%nat s - x 0%nat s -> 0 <= a * (x' 0%nat s - x 0%nat s) + (v' 0%nat s - v 0%nat s) ->
  x' 0%nat s = x 0%nat s /\ v' 0%nat s = v 0%nat s.
Proof.
  intros HM HM' Tr Tr' S1 S2 d0 z0. destruct (HM 0%nat) as [_ [F _ _ _ Op e1 _]]; destruct (HM' 0%nat) as [_ [F' _ _ _
    Op' e2 _]]. replace (a * (x' 0%nat s - x 0%nat s) + (v' 0%nat s - v 0%nat s)) with (zet M (x' 0%nat) (v' 0%nat) s
    - zet M (x 0%nat) (v 0%nat) s) in z0 by (unfold zet; ring). assert (L : t 1%nat <= t' 1%nat).
  { apply Rnot_lt_le; intros C; specialize (Op (t' 1%nat) ltac:(lra)). destruct (keep_order M lo hi H _ _ _ _ s (t'
      1%nat) F F' ltac:(lra) d0 z0); lra. }
  destruct (keep_order M lo hi H _ _ _ _ s (t' 1%nat) F F' ltac:(lra) d0 z0) as [k1 k2].
  assert (Z : x' 0%nat (t' 1%nat) - x 0%nat (t' 1%nat) = 0).
  { apply (no_growth _ (Vm M * W)); trivial; intros j. apply (ordered_bound j 0%nat t V x v t' V' x' v');
      trivial; split; trivial; split; [lra|split; trivial]. }
  destruct (keep M lo hi H _ _ _ _ s (t' 1%nat) F F' ltac:(lra)) as [K _]; rewrite Z in K.
  set (T := t' 1%nat - s) in *; assert (TP : 0 < T) by (unfold T; lra). assert (Pp : 0 < phi12 M T).
  { apply Rdiv_lt_0_compat; [|lra]; assert (exp (- b * T) < exp (- a * T)); [apply exp_increasing; nra|lra]. }
  pose proof (exp_pos (- a * T)) as Ep; set (d := x' 0%nat s - x 0%nat s) in *. set (zz := zet M (x' 0%nat) (v' 0%nat)
    s - zet M (x 0%nat) (v 0%nat) s) in *. assert (0 <= exp (- a * T) * d) by (apply Rmult_le_pos; lra);
    assert (0 <= phi12 M T * zz) by (apply Rmult_le_pos; lra). assert (Ed : d = 0) by (apply Rmult_eq_reg_l with (exp
    (- a * T)); [lra|lra]). assert (Ez : zz = 0) by (apply Rmult_eq_reg_l with (phi12 M T); [lra|lra]). split;
    [unfold d in Ed; lra|]; unfold zz, zet in Ez; unfold d in Ed; nra.
Qed.
End Two.
End Separate.

Theorem Trapped : Trapped_statement.
Proof.
  intros M lo hi [H Hb Ho] t V Tr; split; [apply (next_leg M lo hi H _ _ _ _ Tr Ho)|]. destruct (pass_of M lo hi H t
    (proj1 Tr)) as (k &
    Hk); exists k; split; trivial. intros t' V' x v L; eapply return_trapped; eauto.
Qed.
Theorem Separate : Separate_statement.
Proof.
  intros M lo hi E [[H Hb Ho] HE HN] N t V x v t' V' x' v' [HM Tr] [HM' Tr'] s S1 S2 d0 z0.
  apply (separate M lo hi E H Hb Ho HE N HN t V x v t' V' x' v'); trivial.
Qed.
