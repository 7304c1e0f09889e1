(** P8: a motion that impacts, grazing or not, with margins elsewhere, is not stable in Lyapunov's sense. *)
From Coq Require Import Reals ZArith Lra Lia Arith.
From Grazing Require Import Derivatives StatementOscillator.
From Grazing Require Import StatementTrapped TrappedCalculus TrappedFlow TrappedReturn TrappedMain
  TrappedSeparate.
Open Scope R_scope.

(** Its impacts are grazes or faster than m, it impacts again and again, and passes a hump that it does not
    touch at
    m or more. A motion that is periodic and impacts has such an m. *)
Record margin (M : machine) (lo hi m : R) (N : nat -> Z) (t V : nat -> R) (x : nat -> R -> R) : Prop := {
  some : 0 < m;
  impacts : forall i, V i = 0 \/ V i <= - m;
  again : forall i, exists d, V (i + d)%nat < 0;
  over : forall i k s, in_pass M lo hi k s -> (N i < k < N (S i))%Z -> Q M s + m <= x i s }.
Definition near (t t' : nat -> R) (x x' : nat -> R -> R) (eps : R) : Prop := forall i j s,
  t i <= s <= t (S i) -> t' j <= s <= t' (S j) -> Rabs (x' j s - x i s) <= eps.

Section Unstable.
Variables (M : machine) (lo hi E : R).
Hypothesis H : hump M lo hi.
Hypothesis Hb : 0 < alb M /\ least_slip M <= zm M /\ least_speed M <= Vm M.
Hypothesis Ho : 0 < alo M.
Hypothesis HE : 1 < E.
Hypothesis HN : forall n, (1 <= n)%Z -> stretches M E n.
Notation a := (a M). Notation b := (b M). Notation tau := (tau M). Notation p := (p M). Notation W := (W M).
Notation mu := (mu M). Notation Q := (Q M). Notation Q1 := (Q1 M).
Notation D := (StatementTrapped.b M - StatementTrapped.a M).
Let Hab := overdamped _ _ _ H.
Let Htau := restitution _ _ _ H.
Definition leaves (t U : R) (X X' : R -> R) : Prop := free (a + b) (a * b) X X' /\ X t = Q t /\
  X' t = Q1 t - tau * U.

(** Two impacts in pass k, X's first: afterwards X is above Y, by h at the next two if these are in one pass.
    *)
Definition pair k t1 U1 X X' t2 U2 Y Y' h : Prop := in_pass M lo hi k t1 /\ in_pass M lo hi k t2 /\
  trapped M t1 U1 /\ trapped M t2 U2 /\ t1 <= t2 /\ leaves t1 U1 X X' /\ leaves t2 U2 Y Y' /\
  0 <= X t2 - Y t2 /\ sigma M * h <= Vm M * (zet M X X' t2 - zet M Y Y' t2).

Lemma phi12_strict T : 0 < T -> 0 < phi12 M T.
Proof. intros HT; apply Rdiv_lt_0_compat; [|lra]; assert (exp (- b * T) < exp (- a * T));
  [apply exp_increasing; nra|lra]. Qed.
Lemma pair_kick k t1 U1 X X' t2 U2 Y Y' h : 0 < h -> pair k t1 U1 X X' t2 U2 Y Y' h ->
  0 < zet M X X' t2 - zet M Y Y' t2.
Proof.
  intros h0 (_ & _ & _ & _ & _ & _ & _ & _ & K); pose proof (sigma_pos M lo hi H Hb Ho);
    pose proof (Vm_pos M lo hi H Hb). assert (0 < sigma M * h) by (apply Rmult_lt_0_compat; lra);
    apply Rmult_lt_reg_l with (Vm M); lra.
Qed.
Lemma pair_above k t1 U1 X X' t2 U2 Y Y' h s : 0 < h -> pair k t1 U1 X X' t2 U2 Y Y' h -> t2 < s -> Y s < X s.
Proof.
  intros h0 P Ls; pose proof (pair_kick _ _ _ _ _ _ _ _ _ _ h0 P) as K; destruct P as (_ & _ & _ & _ & _ & (FX & _) &
    (FY & _) & O & _). destruct (keep M lo hi H Y Y' X X' t2 s FY FX ltac:(lra)) as [E1 _].
  assert (0 < phi12 M (s - t2) * (zet M X X' t2 - zet M Y Y' t2)) by (apply Rmult_lt_0_compat;
    [apply phi12_strict; lra|lra]). assert (0 <= exp (- a * (s - t2)) * (X t2 - Y t2)) by (apply Rmult_le_pos;
    [left; apply exp_pos|lra]); lra.
Qed.

Lemma pair_next k n t1 U1 X X' t2 U2 Y Y' h T1 T2 W1 W2 Xn Xn' Yn Yn' : 0 < h -> pair k t1 U1 X X' t2 U2 Y Y'
  h ->
  (1 <= n)%Z -> in_pass M lo hi (k + n) T1 -> in_pass M lo hi (k + n) T2 -> T2 <= T1 -> X T1 = Q T1 ->
    Y T2 = Q T2 ->
  W1 = X' T1 - Q1 T1 -> W2 = Y' T2 - Q1 T2 -> trapped M T1 W1 -> trapped M T2 W2 -> leaves T1 W1 Xn Xn' ->
  leaves T2 W2 Yn Yn' -> pair (k + n) T2 W2 Yn Yn' T1 W1 Xn Xn' (E * h) /\ E * h <= Vm M * W.
Proof.
  intros h0 P Hn P1n P2n L12 e1 e2 w1 w2 TW1 TW2 LX LY; pose proof (pair_kick _ _ _ _ _ _ _ _ _ _ h0 P) as K.
  destruct P as (P1 & P2 & Tr1 & Tr2 & L & (FX & X1 & X1') & (FY & Y2 & Y2') & O & Hh).
  pose proof (far' M lo hi H _ _ _ _ _ _ _ _ Hn P1 P1n Tr1 TW1 FX X1 X1' e1) as F1. pose proof (far' M lo hi H _ _ _ _
    _ _ _ _ Hn P2 P2n Tr2 TW2 FY Y2 Y2' e2) as F2. pose proof (sigma_pos M lo hi H Hb Ho) as Sp;
    pose proof (Vm_pos M lo hi H Hb) as Vp. assert (LT : t2 < T1) by (apply (pass_order M lo hi H k (k + n));
    trivial; lia). assert (LT3 : t2 < T2) by (apply (pass_order M lo hi H k (k + n)); trivial; lia).
  destruct (keep_order M lo hi H Y Y' X X' t2 T1 FY FX ltac:(lra) O ltac:(lra)) as [K1 K2].
  assert (R : E * Vm M <= sigma M * phi12 M (T1 - t2)).
  { assert (ApT : p * IZR n - W <= T1 - t2 <= p * IZR n + W) by (apply (apart_pass M lo hi H k); trivial).
    apply (rate M lo hi E H Hb Ho (IZR n) (T1 - t2) (T2 - t2) (T1 - t1)); trivial; try lra; apply HN, Hn. }
  assert (G : E * h <= X T1 - Y T1).
  { destruct (keep M lo hi H Y Y' X X' t2 T1 FY FX ltac:(lra)) as [-> _]. set (zz := zet M X X' t2 - zet M Y Y' t2) in
      *. assert (0 <= exp (- a * (T1 - t2)) * (X t2 - Y t2)) by (apply Rmult_le_pos; [left;
      apply exp_pos|lra]). assert (E * (sigma M * h) <= E * (Vm M * zz)) by (apply Rmult_le_compat_l; lra).
    assert (E * Vm M * zz <= sigma M * phi12 M (T1 - t2) * zz) by (apply Rmult_le_compat_r; lra).
    assert (E * h <= phi12 M (T1 - t2) * zz); [|lra]. apply Rmult_le_reg_l with (sigma M); [lra|lra]. }
  destruct LX as (FXn & Xn1 & Xn1'); destruct LY as (FYn & Yn1 & Yn1'). destruct (impact M lo hi H (zm M) (Vm M) (k +
    n) T2 T1 W2 W1 Y Y' X X' Yn Yn' Xn Xn' P2n P1n L12 TW2 Ho FY FYn e2 w2 e1 w1 Yn1 Yn1' Xn1 Xn1') as (I1 & I2 & I3);
    change (strength M (zm M) (Vm M)) with (sigma M) in I2.
  assert (0 <= tau * (X T1 - Y T1)) by (apply Rmult_le_pos; lra). assert (0 <= tau * (zet M X X' T1 - zet M Y Y' T1))
    by (apply Rmult_le_pos; lra). split.
  - repeat (split; trivial); [lra|]. apply Rle_trans with (sigma M * (Vm M * (T1 - T2)));
      [apply Rmult_le_compat_l; lra|]. replace (sigma M * (Vm M * (T1 - T2))) with (Vm M * (sigma M * (T1 - T2))) by
      ring; apply Rmult_le_compat_l; lra.
  - apply Rle_trans with (Vm M * (T1 - T2)); [lra|apply Rmult_le_compat_l; [lra|]]. destruct (sizes M _ _ H);
      unfold in_pass in *; lra.
Qed.

(** A graze changes nothing. *)
Lemma graze t V t' x v x' v' s : leg M t V t' 0 x v -> leaves t' 0 x' v' -> x' s = x s /\ v' s = v s.
Proof.
  intros [F _ _ _ _ e w] (F' & e' & w'); assert (Ev : v' t' = v t') by lra. assert (Ex : x' s = x s) by (rewrite
    (x_flow' M Hab x v F t'), (x_flow' M Hab x' v' F' t'); unfold zet; rewrite Ev, e', e; ring). split; trivial;
    pose proof (zet_flow M x v F t' s) as Z; pose proof (zet_flow M x' v' F' t' s) as Z'. unfold zet in *;
    rewrite Ev, e', <- e, <- Z, Ex in Z'; lra.
Qed.

Section Two.
Variables (m eps : R) (N : nat -> Z) (t V : nat -> R) (x v : nat -> R -> R).
Variables (N' : nat -> Z) (t' V' : nat -> R) (x' v' : nat -> R -> R).
Hypothesis HM : motion M lo hi N t V x v.
Hypothesis HM' : motion M lo hi N' t' V' x' v'.
Hypothesis Tr : forall i, trapped M (t i) (V i).
Hypothesis Tr' : forall i, trapped M (t' i) (V' i).
Hypothesis Mg : margin M lo hi m N t V x.
Hypothesis Near : near t t' x x' eps.
Hypothesis small : eps < m.
Hypothesis smaller : eps * (1 + / (exp (D * (p - W)) - 1)) < m ^ 2 / (2 * alM M).

Lemma rises i : (N i < N (S i))%Z.
Proof.
  destruct (HM i) as [P L]; destruct (HM (S i)) as [P1 _]. destruct (return_trapped M lo hi H Hb Ho _ _ _ _ _ _ _ P
    (Tr i) L) as (_ & n & Hn & Pn). rewrite (one_pass M lo hi H _ _ _ P1 Pn); lia.
Qed.
Lemma rises' i : (N' i < N' (S i))%Z.
Proof.
  destruct (HM' i) as [P L]; destruct (HM' (S i)) as [P1 _]. destruct (return_trapped M lo hi H Hb Ho _ _ _ _ _ _ _ P
    (Tr' i) L) as (_ & n & Hn & Pn). rewrite (one_pass M lo hi H _ _ _ P1 Pn); lia.
Qed.
Lemma leaving i : leaves (t i) (V i) (x i) (v i). Proof. destruct (HM i) as [_ [F X0 V0 _ _ _ _]];
  repeat split; trivial; apply F. Qed.
Lemma leaving' i : leaves (t' i) (V' i) (x' i) (v' i). Proof. destruct (HM' i) as [_ [F X0 V0 _ _ _ _]];
  repeat split; trivial; apply F. Qed.

Definition other_below i j h : Prop := N i = N' j /\ pair (N i) (t i) (V i) (x i) (v i) (t' j) (V' j) (x' j)
  (v' j) h.
Definition other_above i j h : Prop := exists t2 U2, pair (N' j) (t' j) (V' j) (x' j) (v' j) t2 U2 (x i) (v i)
  h /\
  (N' j <= N i)%Z /\ t2 <= t i /\ t i < t' (S j).

Lemma from_below i j h : 0 < h -> other_below i j h -> other_above (S i) (S j) (E * h) /\ E * h <= Vm M * W.
Proof.
  intros h0 (EN & P); pose proof (rises i) as Ui; pose proof (rises' j) as Uj. destruct (HM i) as [Pi [_ _ _ Lt Op e1
    w1]]; destruct (HM (S i)) as [Pi1 _]. destruct (HM' j) as [Pj [_ _ _ Lt' Op' e2 w2]];
    destruct (HM' (S j)) as [Pj1 _]. assert (Tj : t' j < t (S i)) by (apply (pass_order M lo hi H (N' j) (N (S i)));
    trivial; lia). assert (Ti : t i < t' (S j)) by (apply (pass_order M lo hi H (N i) (N' (S j))); trivial;
    lia). assert (OT : t' (S j) <= t (S i)).
  { apply Rnot_lt_le; intros C; specialize (Op' (t (S i)) ltac:(lra)). pose proof (pair_above _ _ _ _ _ _ _ _ _ _ (t
      (S i)) h0 P Tj); lra. }
  assert (EN1 : N (S i) = N' (S j)).
  { destruct (Z.lt_total (N (S i)) (N' (S j))) as [C|[C|C]]; trivial; exfalso.
    - pose proof (pass_order M lo hi H _ _ _ _ Pi1 Pj1 C); lra.
    - pose proof (over _ _ _ _ _ _ _ _ Mg i (N' (S j)) (t' (S j)) Pj1 ltac:(lia)). pose proof (Near i j (t' (S j))
        ltac:(lra) ltac:(lra)) as B; apply le_abs in B; lra. }
  set (n := (N (S i) - N i)%Z); assert (Hn : (1 <= n)%Z) by (unfold n; lia). assert (q1 : in_pass M lo hi (N i + n) (t
    (S i))) by (replace (N i + n)%Z with (N (S i)) by (unfold n; lia); trivial). assert (q2 : in_pass M lo hi (N i +
    n) (t' (S j))) by (replace (N i + n)%Z with (N' (S j)) by (unfold n; lia); trivial).
  destruct (pair_next (N i) n _ _ _ _ _ _ _ _ h (t (S i)) (t' (S j)) (V (S i)) (V' (S j)) (x (S i)) (v (S i)) (x' (S
    j)) (v' (S j)) h0 P Hn q1 q2 OT e1 e2 w1 w2 (Tr _) (Tr' _) (leaving _) (leaving' _)) as [Pn B]. split;
    trivial; exists (t (S i)), (V (S i)); replace (N' (S j)) with (N i + n)%Z by (unfold n; lia). split;
    trivial; split; [unfold n; lia|split; [lra|]]. apply (pass_order M lo hi H (N (S i)) (N' (S (S j))));
    trivial; [apply HM'|pose proof (rises' (S j)); lia].
Qed.

Lemma from_above_hit i j h : 0 < h -> other_above i j h -> V (S i) < 0 ->
  other_below (S i) (S j) (E * h) /\ E * h <= Vm M * W.
Proof.
  intros h0 (t2 & U2 & P & LN & L2 & Lj) NV; pose proof (rises i) as Ui; pose proof (rises' j) as Uj.
  destruct (HM i) as [Pi Leg]; pose proof Leg as [F x0 v0 Lt Op e1 w1]; destruct (HM (S i)) as [Pi1 _].
  destruct (HM' j) as [Pj [_ _ _ Lt' Op' e2 w2]]; destruct (HM' (S j)) as [Pj1 _]. assert (OT : t (S i) < t' (S j)).
  { apply Rnot_le_lt; intros C; pose proof (pair_above _ _ _ _ _ _ _ _ _ _ (t' (S j)) h0 P ltac:(lra)).
    destruct (Req_dec (t' (S j)) (t (S i))) as [Eq|Ne]; [rewrite Eq in *; lra|specialize (Op (t' (S j)) ltac:(lra));
      lra]. }
  assert (Tj : t' j < t (S i)) by (apply (pass_order M lo hi H (N' j) (N (S i))); trivial; lia).
  assert (EN1 : N (S i) = N' (S j)).
  { destruct (Z.lt_total (N (S i)) (N' (S j))) as [C|[C|C]]; trivial; exfalso; [|pose proof (pass_order M lo hi H _ _
      _ _ Pj1 Pi1 C); lra]. assert (Ez : zet M (x i) (v i) (t (S i)) = zeta M (t (S i)) (V (S i))) by (unfold zet,
      zeta; rewrite e1, w1; ring). pose proof (Tr (S i)) as (q1 & _ & q3).
    destruct (dive M lo hi H (N (S i)) (t (S i)) (V (S i)) (zm M) (x i) (v i) Pi1 F e1 w1 q1 ltac:(rewrite Ez; exact
      q3) NV) as (AM & u & Pu & Lu & Gu); fold (alM M) in AM, Gu. assert (Uu : u < t' (S j)) by exact (pass_order M
      lo hi H _ _ _ _ Pu Pj1 C). specialize (Op' u ltac:(lra)); pose proof (Near i j (t (S i)) ltac:(lra) ltac:(lra))
      as B; apply le_abs in B. pose proof (pair_kick _ _ _ _ _ _ _ _ _ _ h0 P) as K. destruct P as (_ & P2 & _ & _ & _
      & (FX & _) & (FY & _) & O & _). assert (Tp : p - W <= t (S i) - t2).
    { destruct (sizes M _ _ H); unfold in_pass in *; assert (IZR (N' j) + 1 <= IZR (N (S i))) by (rewrite <- plus_IZR;
        apply IZR_le; lia). assert (p * (IZR (N' j) + 1) <= p * IZR (N (S i))) by (apply Rmult_le_compat_l; lra); lra.
        }
    destruct (sizes M _ _ H) as [wa wb]. destruct (keep M lo hi H _ _ _ _ t2 (t (S i)) FY FX ltac:(lra)) as [k1 k2].
    destruct (keep M lo hi H _ _ _ _ (t (S i)) u FY FX Lu) as [k3 _]. set (T := t (S i) - t2) in *;
      set (d1 := x' j (t (S i)) - x i (t (S i))) in *. set (z1 := zet M (x' j) (v' j) (t (S i)) - zet M (x i) (v i) (t
      (S i))) in *. set (z2 := zet M (x' j) (v' j) t2 - zet M (x i) (v i) t2) in *; set (d2 := x' j t2 - x i t2) in *.
    set (r := exp (D * (p - W))) in *. assert (r1 : 1 < r) by (unfold r; rewrite <- exp_0; apply exp_increasing;
      apply Rmult_lt_0_compat; lra). assert (r2 : r <= exp (D * T)).
    { pose proof (exp_down D (- T) (- (p - W)) ltac:(lra) ltac:(lra)) as Y. replace (- D * - (p - W)) with (D * (p -
        W)) in Y by ring; replace (- D * - T) with (D * T) in Y by ring; exact Y. }
    pose proof (exp_pos (- b * T)) as eb; pose proof (exp_pos (- a * T)) as ea. assert (Z1 : 0 <= z1) by (rewrite k2;
      apply Rmult_le_pos; lra). assert (Zd : z1 * (r - 1) <= D * d1).
    { assert (Ph : D * (phi12 M T * z2) = z1 * (exp (D * T) - 1)).
      { rewrite k2; unfold phi12; replace (- a * T) with (- b * T + D * T) by ring; rewrite exp_plus; field; lra. }
      assert (z1 * (r - 1) <= z1 * (exp (D * T) - 1)) by (apply Rmult_le_compat_l; lra).
      assert (0 <= D * (exp (- a * T) * d2)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]). rewrite k1;
        lra. }
    assert (Du : x' j u - x i u <= d1 + z1 / D).
    { rewrite k3; apply Rplus_le_compat.
      - assert (exp (- a * (u - t (S i))) <= 1).
        { pose proof (exp_down a 0 (u - t (S i)) ltac:(lra) ltac:(lra)) as Y; rewrite Rmult_0_r, exp_0 in Y; exact Y.
            }
        assert (D1 : 0 <= d1) by (rewrite k1; pose proof (phi12_pos M Hab T ltac:(lra));
          apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra). rewrite <- (Rmult_1_l d1) at 2;
          apply Rmult_le_compat_r; trivial.
      - unfold Rdiv; rewrite Rmult_comm; apply Rmult_le_compat_l; trivial; unfold phi12.
        assert (exp (- a * (u - t (S i))) <= 1).
        { pose proof (exp_down a 0 (u - t (S i)) ltac:(lra) ltac:(lra)) as Y; rewrite Rmult_0_r, exp_0 in Y; exact Y.
            }
        pose proof (exp_pos (- b * (u - t (S i)))); rewrite <- (Rmult_1_l (/ D)). apply Rmult_le_compat_r;
          [left; apply Rinv_0_lt_compat; lra|lra]. }
    assert (Zq : z1 / D <= eps * / (r - 1)).
    { apply Rmult_le_reg_r with (D * (r - 1)); [apply Rmult_lt_0_compat; lra|]. replace (z1 / D * (D * (r - 1))) with
        (z1 * (r - 1)) by (field; lra). replace (eps * / (r - 1) * (D * (r - 1))) with (D * eps) by (field;
        lra). assert (D * d1 <= D * eps) by (apply Rmult_le_compat_l; lra); lra. }
    pose proof (some _ _ _ _ _ _ _ _ Mg) as m0. destruct (impacts _ _ _ _ _ _ _ _ Mg (S i)) as [Z0|Vm0];
      [lra|]. assert (m ^ 2 / (2 * alM M) <= V (S i) ^ 2 / (2 * alM M)).
    { apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|nra]. } lra. }
  set (n := (N (S i) - N' j)%Z); assert (Hn : (1 <= n)%Z) by (unfold n; lia). assert (q1 : in_pass M lo hi (N' j + n)
    (t (S i))) by (replace (N' j + n)%Z with (N (S i)) by (unfold n; lia); trivial). assert (q2 : in_pass M lo hi (N'
    j + n) (t' (S j))) by (replace (N' j + n)%Z with (N' (S j)) by (unfold n; lia); trivial).
  destruct (pair_next (N' j) n _ _ _ _ _ _ _ _ h (t' (S j)) (t (S i)) (V' (S j)) (V (S i)) (x' (S j)) (v' (S j)) (x (S
    i)) (v (S i)) h0 P Hn q2 q1 ltac:(lra) e2 e1 w2 w1 (Tr' _) (Tr _) (leaving' _) (leaving _)) as [Pn B].
  split; trivial; split; trivial; replace (N (S i)) with (N' j + n)%Z by (unfold n; lia); trivial.
Qed.

Lemma from_above d : forall i j h, 0 < h -> other_above i j h -> V (S i + d)%nat < 0 ->
  (exists i' j', other_below i' j' (E * h)) /\ E * h <= Vm M * W.
Proof.
  induction d as [|d IH]; intros i j h h0 O Hd.
  - rewrite Nat.add_0_r in Hd; destruct (from_above_hit i j h h0 O Hd) as [O' B]; split; trivial;
      exists (S i), (S j); trivial.
  - destruct (Rlt_or_le (V (S i)) 0) as [Neg|Z0].
    { destruct (from_above_hit i j h h0 O Neg) as [O' B]; split; trivial; exists (S i), (S j); trivial. }
    assert (V0 : V (S i) = 0) by (destruct (Tr (S i)) as (_ & hv & _); lra). apply (IH (S i) j h h0);
      [|replace (S (S i) + d)%nat with (S i + S d)%nat by lia; trivial]. destruct O as (t2 & U2 & P & LN & L2 & Lj);
      exists t2, U2; pose proof (rises i) as Ui. destruct (HM i) as [Pi Leg]; pose proof Leg as [F x0 v0 Lt Op e1 w1].
    destruct (HM' j) as [Pj [_ _ _ Lt' Op' e2 w2]]. assert (OT : t (S i) < t' (S j)).
    { apply Rnot_le_lt; intros C; pose proof (pair_above _ _ _ _ _ _ _ _ _ _ (t' (S j)) h0 P ltac:(lra)).
      destruct (Req_dec (t' (S j)) (t (S i))) as [Eq|Ne]; [rewrite Eq in *; lra|specialize (Op (t' (S j)) ltac:(lra));
        lra].
        }
    split; [|split; [lia|split; lra]]. pose proof (leaving (S i)) as Lv; rewrite V0 in Leg, Lv.
    destruct (graze _ _ _ _ _ _ _ t2 Leg Lv) as [g1 g2]; destruct Lv as (FS & _). destruct P as (p1 & p2 & p3 & p4 &
      p5 & p6 & (p7 & p8 & p9) & p10 & p11). repeat (split; trivial); try rewrite g1; try rewrite g2; trivial.
    unfold zet in *; rewrite g1, g2; trivial.
Qed.

Lemma two_steps i j h : 0 < h -> other_below i j h -> exists i' j', other_below i' j' (E * (E * h)) /\
  E * (E * h) <= Vm M * W.
Proof.
  intros h0 O; destruct (from_below i j h h0 O) as [O' _]; destruct (again _ _ _ _ _ _ _ _ Mg (S (S i))) as (d & Hd).
  destruct (from_above d (S i) (S j) (E * h) ltac:(apply Rmult_lt_0_compat; lra) O' Hd) as [(i' & j' & O2) B].
  exists i', j'; split; trivial.
Qed.
Lemma grows h : 0 < h -> h < E * h. Proof. intros h0; rewrite <- (Rmult_1_l h) at 1; apply Rmult_lt_compat_r; lra. Qed.
Lemma bounded_below q : forall i j h, 0 < h -> other_below i j h -> E ^ q * h <= Vm M * W.
Proof.
  induction q as [|q IH]; intros i j h h0 O; destruct (two_steps i j h h0 O) as (i' & j' & O' & B).
  - cbn; pose proof (grows h h0); pose proof (grows (E * h) ltac:(lra)); lra.
  - pose proof (grows h h0); pose proof (grows (E * h) ltac:(lra)). specialize (IH i' j' (E * (E * h)) ltac:(lra) O');
      cbn. assert (P : 0 < E ^ q) by (apply pow_lt; lra); assert (Q0 : 0 < E ^ q * h) by (apply Rmult_lt_0_compat;
      lra). pose proof (grows (E ^ q * h) Q0); pose proof (grows (E * (E ^ q * h)) ltac:(lra)).
    replace (E * E ^ q * h) with (E * (E ^ q * h)) by ring. replace (E ^ q * (E * (E * h))) with (E * (E * (E ^ q *
      h))) in IH by ring; lra.
Qed.
Lemma never_below i j h : 0 < h -> ~ other_below i j h.
Proof.
  intros h0 O; assert (h = 0); [|lra]; apply (no_growth E HE h (Vm M * W)); [lra|]. intros q;
    apply (bounded_below q i j h h0 O).
Qed.
Lemma never_above i j h : 0 < h -> ~ other_above i j h.
Proof.
  intros h0 O; destruct (again _ _ _ _ _ _ _ _ Mg (S i)) as (d & Hd). destruct (from_above d i j h h0 O Hd) as [(i' &
    j' & O2) B]. apply (never_below i' j' (E * h)); trivial; apply Rmult_lt_0_compat; lra.
Qed.
End Two.
End Unstable.

(** One eps: no motion that leaves a contact at the same time with another speed remains within eps. *)
Theorem unstable M lo hi E m N t V x v : chaotic M lo hi E -> 0 < tau M -> stays M lo hi N t V x v ->
  margin M lo hi m N t V x -> exists eps, 0 < eps /\ forall N' t' V' x' v', stays M lo hi N' t' V' x' v' ->
  t' 0%nat = t 0%nat -> V' 0%nat <> V 0%nat -> ~ near t t' x x' eps.
Proof.
  intros [[H Hb Ho] HE HN] Ht [HM Tr] Mg. pose proof (some _ _ _ _ _ _ _ _ Mg) as m0; pose proof (overdamped _ _ _ H)
    as Hab; destruct (sizes M _ _ H) as [w1 w2]. destruct (positives M _ _ H) as [hmu hal];
    pose proof (zm_pos M lo hi H Hb) as zp. assert (AM : 0 < alM M).
  { assert (0 <= zm M / (b M - a M)) by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]).
    assert (0 <= a M ^ 2 * (mu M + zm M / (b M - a M))) by (apply Rmult_le_pos; [apply pow2_ge_0|lra]).
    pose proof (bent _ _ _ H lo ltac:(lra)); unfold alM; lra. }
  set (r := exp ((b M - a M) * (p M - W M))). assert (r1 : 1 < r) by (unfold r; rewrite <- exp_0;
    apply exp_increasing; apply Rmult_lt_0_compat; lra). set (c := 1 + / (r - 1));
    assert (c1 : 0 < / (r - 1)) by (apply Rinv_0_lt_compat; lra). set (y := m ^ 2 / (2 * alM M) / c);
    assert (y0 : 0 < y).
  { unfold y, c; repeat apply Rdiv_lt_0_compat; try lra; apply pow_lt; lra. }
  exists (Rmin (m / 2) (y / 2)); set (eps := Rmin (m / 2) (y / 2)). assert (e0 : 0 < eps) by (unfold eps, Rmin;
    destruct Rle_dec; lra). assert (e1 : eps < m) by (pose proof (Rmin_l (m / 2) (y / 2)); fold eps in H0;
    lra). assert (e2 : eps * c < m ^ 2 / (2 * alM M)).
  { replace (m ^ 2 / (2 * alM M)) with (y * c) by (unfold y, c; field; lra). apply Rmult_lt_compat_r;
      [unfold c; lra|]; pose proof (Rmin_r (m / 2) (y / 2)); fold eps in H0; lra. }
  split; trivial; intros N' t' V' x' v' [HM' Tr'] Et NV Nr. pose proof (sigma_pos M lo hi H Hb Ho) as Sp;
    pose proof (Vm_pos M lo hi H Hb) as Vp. destruct (HM 0%nat) as [P [F x0 v0 _ _ _ _]];
    destruct (HM' 0%nat) as [P' [F' x0' v0' _ _ _ _]]. rewrite Et in P', x0', v0'. assert (EN : N 0%nat = N' 0%nat) by
    apply (one_pass M lo hi H _ _ _ P P'). pose proof (Tr 0%nat) as T0; pose proof (Tr' 0%nat) as T0';
    rewrite Et in T0'. destruct (Rtotal_order (V' 0%nat) (V 0%nat)) as [L|[L|L]]; [|lra|].
  - set (h := Vm M / sigma M * (tau M * (V 0%nat - V' 0%nat))). assert (h0 : 0 < h) by (unfold h;
      apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; lra|apply Rmult_lt_0_compat; lra]).
    apply (never_above M lo hi E H Hb Ho HE HN m eps N t V x v N' t' V' x' v' HM HM' Tr Tr' Mg Nr e1 e2 0%nat 0%nat h
      h0). exists (t 0%nat), (V 0%nat); rewrite Et, <- EN; split; [|split; [lia|split; [lra|]]].
    + repeat (split; trivial); [lra|rewrite x0, x0'; lra|]. unfold zet; rewrite x0, x0', v0, v0'; unfold h;
        right; field; lra.
    + rewrite <- Et; destruct (HM' 0%nat) as [_ [_ _ _ Lt _ _ _]]; lra.
  - set (h := Vm M / sigma M * (tau M * (V' 0%nat - V 0%nat))). assert (h0 : 0 < h) by (unfold h;
      apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; lra|apply Rmult_lt_0_compat; lra]).
    apply (never_below M lo hi E H Hb Ho HE HN m eps N t V x v N' t' V' x' v' HM HM' Tr Tr' Mg Nr e1 e2 0%nat 0%nat h
      h0). split; trivial; rewrite Et; repeat (split; trivial); [lra|rewrite x0, x0'; lra|]. unfold zet;
      rewrite x0, x0', v0, v0'; unfold h; right; field; lra.
Qed.
