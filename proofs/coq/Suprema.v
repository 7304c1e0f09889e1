(** * The suprema are approached: at r = 1, next to s = 1/2 in (+,-) and next to s = 1/4 in (+,+) *)

From Coq Require Import Reals ZArith List Arith Bool Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementWords StatementGraphs StatementReaderWords Algebra
  AppendixA Above Sine WordAlgebra WordPath WordGraph WordPatterns WordPlane ReaderWords GraphWords.
From Grazing Require Import StatementSuprema PatternSums PatternCylinders Endless SupremumMinus SupremumPlus
  SupremumPlusAll.
Import ListNotations. Open Scope R_scope.

(** ** The two roots *)
Lemma root_minus_exists : exists z, root_minus z /\ 0.543689012692076 < z < 0.543689012692077.
Proof.
  set (f := fun z => z + z ^ 2 + z ^ 3 - 1); destruct (IVT_cor f 0.543689012692076 0.543689012692077) as (z & Hz & E).
  - unfold f; reg.
  - lra.
  - unfold f; lra.
  - unfold f in E; assert (N1 : z <> 0.543689012692076) by (intros ->; lra); assert (N2 : z <> 0.543689012692077)
      by (intros ->; lra).
    exists z; split; [split; lra | lra].
Qed.
Lemma root_plus_exists : exists z, root_plus z /\ 0.637382658446787 < z < 0.637382658446788.
Proof.
  set (f := fun z => (1 + z ^ 4) * (z ^ 3 * (1 - z ^ 3) + z ^ 2 * (1 - z ^ 4)) - (1 - z ^ 4) * (1 - z ^ 3)).
  destruct (IVT_cor f 0.637382658446787 0.637382658446788) as (z & Hz & E).
  - unfold f; reg.
  - lra.
  - unfold f; lra.
  - unfold f in E; assert (N1 : z <> 0.637382658446787) by (intros ->; lra); assert (N2 : z <> 0.637382658446788)
      by (intros ->; lra).
    exists z; split; [|lra]; split; [lra|]; assert (z ^ 3 < 1) by (apply pow_lt_1_compat; [lra | lia]);
      assert (z ^ 4 < 1) by (apply pow_lt_1_compat; [lra | lia]).
    apply (Rmult_eq_reg_r ((1 - z ^ 4) * (1 - z ^ 3))); [|apply Rgt_not_eq, Rmult_lt_0_compat; lra]; field_simplify;
      lra.
Qed.

(** A little above z, and still below exp (- h). *)
Lemma little_above z h : 0 < z < 1 -> h < - ln z -> exists t, z < t < 1 /\ h < - ln t.
Proof.
  intros Hz Hh; assert (E : z < exp (- h)) by (apply Rle_lt_trans with (exp (ln z)); [right; symmetry; apply exp_ln;
    lra | apply exp_increasing; lra]); pose proof (Rmin_l 1 (exp (- h))); pose proof (Rmin_r 1 (exp (- h))).
  assert (L : z < Rmin 1 (exp (- h))) by (apply Rmin_glb_lt; lra); exists ((z + Rmin 1 (exp (- h))) / 2); split; [lra|].
  assert (Q : ln ((z + Rmin 1 (exp (- h))) / 2) < - h); [|lra]; apply Rlt_le_trans with (ln (exp (- h)));
    [apply ln_increasing; lra | rewrite ln_exp; lra].
Qed.
Lemma at_least_less G h h' : at_least G h -> h' <= h -> at_least G h'.
Proof. intros H L h'' Hh; apply H; lra. Qed.
Lemma small_power q x d : 0 < q < 1 -> 0 < d -> exists n, forall k, (n <= k)%nat -> q ^ k <= d * x \/ x <= 0.
Proof.
  intros Hq Hd; destruct (Rle_lt_dec x 0) as [L|L]; [exists 0%nat; tauto|].
  destruct (pow_lt_1_zero q ltac:(rewrite Rabs_right; lra) (d * x) ltac:(apply Rmult_lt_0_compat; lra)) as [n Hn];
    exists n; intros k Hk; left.
  specialize (Hn k Hk); rewrite Rabs_right in Hn by (apply Rle_ge, pow_le; lra); lra.
Qed.
Lemma cross p q r t : 0 < q -> 0 < t -> p * t <= r * q -> p / q <= r / t.
Proof.
  intros Hq Ht H; apply (Rmult_le_reg_r (q * t)); [apply Rmult_lt_0_compat; assumption|].
  replace (p / q * (q * t)) with (p * t) by (field; lra); replace (r / t * (q * t)) with (r * q) by (field; lra);
    exact H.
Qed.

(** ** Points on r = 1 *)
Section Circle.
Variable s : R.
Hypothesis Hs : 1 / 4 < s < 1 / 2.
Notation a1 := (trace 1 s).
Notation member := (member a1 (1 ^ 2) Plus).
Notation on := (on a1 (1 ^ 2)).

Lemma circle_first : first_upper a1 (1 ^ 2) 2. Proof. apply (proj2 (proj2 Path) 1 s 2%nat); simpl; lra. Qed.
Lemma on_interval n g lo hi : (3 <= n)%nat -> interval n Plus g lo hi -> lo < s < hi -> member n /\ forall x,
  g = case_of x -> on n x.
Proof.
  intros Hn HI Hlh; assert (O : orbit_at 1 s n Plus g) by (apply (Theorem2_stated n s Hn ltac:(lra)); eauto);
    destruct (O) as (Hu & Hb & Hc).
  split; [split; assumption|]; intros x ->; pose proof circle_first as F;
    destruct (sign_c a1 (1 ^ 2) (a2_in _ _ 2 F) (a1_in _ _ 2 F) n Hu) as [C1 C2].
  destruct (Rdichotomy _ _ Hu) as [L|L]; [specialize (C2 L) | specialize (C1 L)]; destruct x;
    cbn [case_of sgn StatementWords.on] in *; lra.
Qed.
Lemma word_edge w i j v v' g : in_word a1 (1 ^ 2) 2 w i j -> In v (vertices 2 w) -> In v' (vertices 2 w) ->
  mark_of 2 w false v v' = Some g -> edge a1 (1 ^ 2) Plus g (fst v) (fst v').
Proof.
  intros [Hp HV] Hv Hv' M; pose proof (marks_true a1 (1 ^ 2) 2 circle_first w i j false Hp HV ltac:(discriminate) v v' _
    Hv Hv' M) as Q.
  unfold edge; cbn [marked sgn] in *; lra.
Qed.
End Circle.

(** ** (+,-) *)
Section Minus.
Variables (s : R) (a : nat).
Hypotheses (Hs : 1 / 4 < s < 1 / 2) (Hsa : INR a / INR (2 * a + 1) < s).
Notation a1 := (trace 1 s).
Notation in_word := (in_word a1 (1 ^ 2) 2).

Lemma odd_interval k : (1 <= k <= a)%nat -> member a1 (1 ^ 2) Plus (2 * k + 1) /\ on a1 (1 ^ 2) (2 * k + 1) D.
Proof.
  intros Hk; assert (F : neighbours k (2 * k + 1) (k - 1) (2 * k - 1) 1 2) by (unfold neighbours; repeat split; try lia;
    nia).
  pose proof (right_side (2 * k + 1) k (Build_Farey _ _ _ _ _ _ F) ltac:(lia)) as S; cbn [n_plus m_minus n_minus] in S;
    apply beside in S.
  assert (L : INR k / INR (2 * k + 1) < s).
  { apply Rle_lt_trans with (2 := Hsa); pose proof (pos_INR k); assert (INR k <= INR a) by (apply le_INR; lia);
      rewrite !plus_INR, !mult_INR; simpl (INR 2); simpl (INR 1).
    apply (Rmult_le_reg_r ((2 * INR k + 1) * (2 * INR a + 1))); [apply Rmult_lt_0_compat; lra|]; unfold Rdiv;
      field_simplify; [nra | lra | lra]. }
  destruct (on_interval s Hs (2 * k + 1) Minus _ _ ltac:(lia) S) as [M O]; [simpl (INR 2); simpl (INR 1); lra|]; split;
    [exact M | apply O; reflexivity].
Qed.
Lemma odd_word k : (k <= a)%nat -> in_word (repeat D k) (2 * k + 1) 2.
Proof.
  pose proof (circle_first s Hs) as first; induction k as [|k IH]; intros Hk; [apply word_start, first|];
    destruct (IH ltac:(lia)) as [Hp HV].
  destruct (odd_interval (S k) ltac:(lia)) as [M O]; replace (2 * S k + 1)%nat with (2 * k + 1 + 2)%nat in * by lia;
    rewrite <- repeat_snoc; split.
  - apply path_D; assumption.
  - rewrite (vertices_snoc _ _ 2 _ _ _ D Hp), Forall_app; split; [exact HV | constructor; [exact M | constructor]].
Qed.
Lemma odd_renewed k : forall l, (l <= k < a + l)%nat -> renewed (2 * k + 1) 2 (2 * l + 1) 2 (repeat D a) = Some D.
Proof.
  clear; induction a as [|n IH]; intros l H; [lia|]; cbn [repeat renewed];
    destruct (Nat.eqb_spec (2 * l + 1) (2 * k + 1)) as [|Hne]; [reflexivity|].
  replace (2 * l + 1 + 2)%nat with (2 * S l + 1)%nat by lia; apply IH; lia.
Qed.
Lemma odd_vertex k : (k <= a)%nat -> In ((2 * k + 1)%nat, D) (vertices 2 (repeat D a)).
Proof.
  intros Hk; unfold vertices; destruct k as [|k]; [left; reflexivity | right; right].
  assert (Q : forall n i, (k < n)%nat -> In ((i + (k + 1) * 2)%nat, D) (periods i 2 (repeat D n))).
  { clear; induction k as [|k IH]; intros [|n] i H; try lia; cbn [repeat periods]; [left; f_equal; lia | right].
    replace (i + (S k + 1) * 2)%nat with (i + 2 + (k + 1) * 2)%nat by lia; apply IH; lia. }
  specialize (Q a 1%nat ltac:(lia)); replace (2 * S k + 1)%nat with (1 + (k + 1) * 2)%nat by lia; exact Q.
Qed.
Lemma minus_at_least z : 0 < z < 1 -> (1 <= a)%nat -> 1 <= (z - z ^ (2 * a + 1)) / (1 - z ^ 2) * (1 + z ^ 2) ->
  at_least (patterns a1 (1 ^ 2) Plus Minus) (- ln z).
Proof.
  intros Hz Ha HS; pose proof (circle_first s Hs) as first; pose proof (odd_word a (le_n _)) as HW;
    set (odds := map (fun k => (2 * k + 1)%nat) (seq 0 a)).
  assert (Odd : forall n, In n odds <-> exists k, (k < a)%nat /\ n = (2 * k + 1)%nat).
  { intros n; unfold odds; rewrite in_map_iff; split; [intros (k & <- & H); apply in_seq in H; exists k; split;
      [lia | reflexivity] | intros (k & H & ->); exists k; split; [reflexivity | apply in_seq; lia]]. }
  assert (NOdd : NoDup odds) by (apply map_NoDup; [apply seq_NoDup | intros; lia]).
  assert (N2 : ~ In 2%nat odds) by (rewrite Odd; intros (k & _ & H); lia).
  assert (Q2 : 0 < z ^ 2 < 1) by (split; [apply pow_lt; lra | apply pow_lt_1_compat; [lra | lia]]).
  assert (SumO : sum_of odds (fun j => z ^ j * (1 + z ^ 2)) = (z - z ^ (2 * a + 1)) / (1 - z ^ 2) * (1 + z ^ 2)).
  { unfold odds; rewrite sum_map, (sum_ext _ _ (fun k => z * (1 + z ^ 2) * (z ^ 2) ^ k)).
    - rewrite sum_scale, sum_seq by exact Q2; rewrite <- pow_mult, pow_add, pow_1; field; lra.
    - intros k _; rewrite pow_add, pow_mult, pow_1; ring. }
  set (w := fun n : nat => if (n =? 2)%nat then 1 else 1 + z ^ 2);
    set (succ := fun n : nat => if (n =? 2)%nat then odds else 2%nat :: odds).
  assert (SumW : sum_of odds (fun j => z ^ j * w j) = (z - z ^ (2 * a + 1)) / (1 - z ^ 2) * (1 + z ^ 2)).
  { rewrite <- SumO; apply sum_ext; intros n Hn; unfold w; destruct (Nat.eqb_spec n 2) as [->|];
      [contradiction | reflexivity]. }
  assert (Mem : forall n, In n (2%nat :: odds) -> member a1 (1 ^ 2) Plus n).
  { intros n [<-|Hn]; [apply member_K, first|]; apply Odd in Hn; destruct Hn as (k & Hk & ->); destruct HW as [_ HV];
      rewrite Forall_forall in HV; apply (HV _ (odd_vertex k ltac:(lia))). }
  assert (I2 : In (2%nat, U) (vertices 2 (repeat D a))) by (right; left; reflexivity).
  assert (EDD : forall x y, In x odds -> In y odds -> edge a1 (1 ^ 2) Plus Minus x y).
  { intros x y Hx Hy; apply Odd in Hx, Hy; destruct Hx as (k & Hk & ->), Hy as (l & Hl & ->);
      exact (word_edge s Hs _ _ _ _ _ Minus HW (odd_vertex k ltac:(lia)) (odd_vertex l ltac:(lia)) eq_refl). }
  assert (ED2 : forall x, In x odds -> edge a1 (1 ^ 2) Plus Minus x 2 /\ edge a1 (1 ^ 2) Plus Minus 2 x).
  { intros x Hx; apply Odd in Hx; destruct Hx as (k & Hk & ->);
      assert (R0 : renewed (2 * k + 1) 2 1 2 (repeat D a) = Some D) by exact (odd_renewed k 0 ltac:(lia)).
    split; [apply (word_edge s Hs _ _ _ ((2 * k + 1)%nat, D) (2%nat, U) Minus HW) |
      apply (word_edge s Hs _ _ _ (2%nat, U) ((2 * k + 1)%nat, D) Minus HW)]; try apply odd_vertex; try exact I2;
      try lia; unfold mark_of; rewrite R0; reflexivity. }
  apply (from_below (patterns a1 (1 ^ 2) Plus Minus) z ltac:(lra) (member_1_or_more a1 (1 ^ 2)) (fun n =>
    In n (2%nat :: odds)) succ w 2 (2 * a + 2)%nat ltac:(lra)) with (i := 2%nat).
  - intros n _; unfold w; destruct (n =? 2)%nat; lra.
  - intros x Hx; split.
    + unfold succ; destruct (x =? 2)%nat; [exact NOdd | constructor; assumption].
    + intros y Hy; assert (Hy' : In y (2%nat :: odds)) by (unfold succ in Hy; destruct (x =? 2)%nat;
        [right; exact Hy | exact Hy]).
      split; [exact Hy'|]; split; [apply Mem, Hy'|]; cbn [joined patterns periods_of]; split.
      * unfold succ in Hy; destruct (Nat.eqb_spec x 2) as [->|Nx]; [apply (ED2 y Hy)|]; destruct Hx as [E|Hx];
          [congruence|].
        destruct Hy as [<-|Hy]; [apply (ED2 x Hx) | apply (EDD x y Hx Hy)].
      * destruct Hy' as [<-|Hy']; [lia|]; apply Odd in Hy'; destruct Hy' as (k & Hk & ->); lia.
  - intros x Hx; cbn [periods_of patterns]; unfold succ; unfold w at 1; destruct (Nat.eqb_spec x 2) as [->|Nx];
      [rewrite SumW; exact HS|].
    cbn [sum_of]; rewrite SumW; unfold w; cbn [Nat.eqb]; lra.
  - left; reflexivity.
  - apply Mem; left; reflexivity.
  - unfold w; cbn [Nat.eqb]; lra.
Qed.
End Minus.

Theorem Supremum_minus : Supremum_minus_statement.
Proof.
  destruct root_minus_exists as (z & Hr & Hn); exists z; split; [exact Hr | split; [exact Hn|]]; split;
    [apply (minus_below z Hr ltac:(lra))|].
  intros h Hh; destruct Hr as [Hz E]; destruct (little_above z h Hz Hh) as (t & Ht & Lt); assert (Q2 : 0 < 1 - t ^ 2)
    by (cbn [pow]; nra).
  assert (Gap : 0 < t * (1 + t ^ 2) - (1 - t ^ 2)).
  { replace (t * (1 + t ^ 2) - (1 - t ^ 2)) with (t + t ^ 2 + t ^ 3 - 1) by ring; assert (z ^ 2 < t ^ 2) by (cbn [pow];
      nra).
    assert (z ^ 3 < t ^ 3) by (replace (z ^ 3) with (z ^ 2 * z) by ring; replace (t ^ 3) with (t ^ 2 * t) by ring;
      assert (0 < z ^ 2) by (apply pow_lt; lra); nra); lra. }
  destruct (small_power t (t * (1 + t ^ 2) - (1 - t ^ 2)) (1 / 2) ltac:(lra) ltac:(lra)) as [n Hnn]; set (a := S n).
  assert (Small : t ^ (2 * a + 1) <= 1 / 2 * (t * (1 + t ^ 2) - (1 - t ^ 2)))
    by (destruct (Hnn (2 * a + 1)%nat ltac:(unfold a; lia)); lra).
  set (s := (Rmax (1 / 4) (INR a / INR (2 * a + 1)) + 1 / 2) / 2); assert (A : INR a / INR (2 * a + 1) < 1 / 2).
  { rewrite plus_INR, mult_INR; simpl (INR 2); simpl (INR 1); pose proof (pos_INR a);
      apply (Rmult_lt_reg_r (2 * INR a + 1)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
  pose proof (Rmax_l (1 / 4) (INR a / INR (2 * a + 1))); pose proof (Rmax_r (1 / 4) (INR a / INR (2 * a + 1))).
  assert (M : Rmax (1 / 4) (INR a / INR (2 * a + 1)) < 1 / 2) by (apply Rmax_lub_lt; lra).
  pose proof (circle_first s ltac:(unfold s; lra)) as F; assert (P2 : 0 < t ^ 2 < 1) by (split; [apply pow_lt|]; lra).
  assert (AL : at_least (patterns (trace 1 s) (1 ^ 2) Plus Minus) (- ln t)).
  { apply (minus_at_least s a); [unfold s; lra | unfold s; lra | lra | unfold a; lia|];
      apply (Rmult_le_reg_r (1 - t ^ 2)); [lra|]; unfold Rdiv.
    replace ((t - t ^ (2 * a + 1)) * / (1 - t ^ 2) * (1 + t ^ 2) * (1 - t ^ 2))
      with ((t - t ^ (2 * a + 1)) * (1 + t ^ 2)) by (field; lra).
    assert (t ^ (2 * a + 1) * (1 + t ^ 2) <= t ^ (2 * a + 1) * 2) by (apply Rmult_le_compat_l; [apply pow_le|]; lra);
      lra. }
  rewrite pow1 in F, AL; exists (trace 1 s), 2%nat; split; [exact F | apply (at_least_less _ (- ln t));
    [exact AL | lra]].
Qed.

(** ** (+,+) *)
Section Plus.
Variables (s : R) (a : nat).
Hypotheses (Hs : 1 / 4 < s < 1 / 3) (Hsa : s < INR (a + 1) / INR (4 * a + 3)).
Notation a1 := (trace 1 s).
Notation in_word := (in_word a1 (1 ^ 2) 2).

Lemma step_interval k : (k <= a)%nat -> member a1 (1 ^ 2) Plus (3 + 4 * k) /\ on a1 (1 ^ 2) (3 + 4 * k) U.
Proof.
  intros Hk; assert (Hh : 1 / 4 < s < 1 / 2) by lra; assert (HI : exists lo hi, interval (3 + 4 * k) Plus Plus lo hi /\
    lo < s < hi).
  { assert (Up : s < INR (k + 1) / INR (3 + 4 * k)).
    { apply Rlt_le_trans with (1 := Hsa); pose proof (pos_INR k); assert (INR k <= INR a) by (apply le_INR; lia);
        rewrite !plus_INR, !mult_INR; simpl (INR 4); simpl (INR 3); simpl (INR 1).
      apply cross; lra. }
    destruct k as [|k].
    - assert (F : neighbours 1 3 0 1 1 2) by (unfold neighbours; repeat split; lia);
        pose proof (left_side 3 1 (Build_Farey _ _ _ _ _ _ F) ltac:(lia)) as S; apply beside in S.
      eexists _, _; split; [exact S|]; cbn [Nat.eqb]; change (INR 1) with 1; replace (INR 3) with 3 by (simpl; ring);
        lra.
    - assert (F : neighbours (S k + 1) (3 + 4 * S k) 1 4 (S k) (4 * S k - 1)) by (unfold neighbours; repeat split;
        try lia; nia).
      pose proof (left_side (3 + 4 * S k) (S k + 1) (Build_Farey _ _ _ _ _ _ F) ltac:(lia)) as SI; apply beside in SI;
        cbn [m_plus n_plus] in SI.
      replace (S k + 1 =? 1)%nat with false in SI by (symmetry; apply Nat.eqb_neq; lia); eexists _, _; split;
        [exact SI|]; change (INR 1) with 1; replace (INR 4) with 4 by (simpl; ring); lra. }
  destruct HI as (lo & hi & HI & Hl); destruct (on_interval s Hh (3 + 4 * k) Plus lo hi ltac:(lia) HI Hl) as [M O];
    split; [exact M | apply O; reflexivity].
Qed.
Lemma four_interval : member a1 (1 ^ 2) Plus 4 /\ on a1 (1 ^ 2) 4 D.
Proof.
  assert (Hh : 1 / 4 < s < 1 / 2) by lra; assert (F : neighbours 1 4 0 1 1 3) by (unfold neighbours; repeat split; lia).
  pose proof (right_side 4 1 (Build_Farey _ _ _ _ _ _ F) ltac:(lia)) as S; apply beside in S;
    cbn [n_plus m_minus n_minus] in S.
  destruct (on_interval s Hh 4 Minus _ _ ltac:(lia) S) as [M O]; [change (INR 1) with 1; replace (INR 3) with 3
    by (simpl; ring); replace (INR 4) with 4 by (simpl; ring); lra|]; split; [exact M | apply O; reflexivity].
Qed.
Lemma step_word k : (k <= a)%nat -> in_word (wa k) 4 (4 * k + 3).
Proof.
  pose proof (circle_first s ltac:(lra)) as first; destruct four_interval as [M4 O4];
    destruct (step_interval 0 ltac:(lia)) as [M3 O3]; cbn [Nat.mul Nat.add] in M3, O3.
  induction k as [|k IH]; intros Hk.
  - assert (P1 : path a1 (1 ^ 2) 2 [U] 1 3) by exact (path_U _ _ _ [] 1 2 (path_start _ _ _) O3); split;
      [exact (path_D _ _ _ [U] 1 3 P1 O4)|].
    constructor; [apply member_one | constructor; [apply member_K, first | constructor;
      [exact M3 | constructor; [exact M4 | constructor]]]].
  - destruct (IH ltac:(lia)) as [Hp HV]; destruct (step_interval (S k) Hk) as [M O]; replace (3 + 4 * S k)%nat
      with (4 + (4 * k + 3))%nat in * by lia.
    replace (wa (S k)) with (wa k ++ [U]) by (unfold wa; cbn [app]; rewrite repeat_snoc; reflexivity);
      replace (4 * S k + 3)%nat with (4 + (4 * k + 3))%nat by lia; split.
    + apply path_U; assumption.
    + rewrite (vertices_snoc _ _ 2 _ _ _ U Hp), Forall_app; split; [exact HV | constructor; [exact M | constructor]].
Qed.
Lemma step_renewed k : (k < a)%nat -> renewed 4 (3 + 4 * k) 1 2 (wa a) = Some U.
Proof.
  intros Hk; unfold wa; cbn [renewed Nat.add]; destruct (Nat.eqb_spec 2 (3 + 4 * k)); [lia|]; cbn [Nat.eqb].
  assert (Q : forall n l, (l <= k < n + l)%nat -> renewed 4 (3 + 4 * k) 4 (3 + 4 * l) (repeat U n) = Some U).
  { clear; induction n as [|n IH]; intros l H; [lia|]; cbn [repeat renewed];
      destruct (Nat.eqb_spec (3 + 4 * l) (3 + 4 * k)); [reflexivity|].
    replace (4 + (3 + 4 * l))%nat with (3 + 4 * S l)%nat by lia; apply IH; lia. }
  apply (Q a 0%nat); lia.
Qed.
Lemma step_vertex k : (k <= a)%nat -> In ((3 + 4 * k)%nat, U) (vertices 2 (wa a)).
Proof.
  intros Hk; unfold wa, vertices; cbn [periods Nat.add]; destruct k as [|k]; [right; right; left; reflexivity | right;
    right; right; right].
  assert (Q : forall n j, (k < n)%nat -> In ((j + (k + 1) * 4)%nat, U) (periods 4 j (repeat U n))).
  { clear; induction k as [|k IH]; intros [|n] j H; try lia; cbn [repeat periods]; [left; f_equal; lia | right].
    replace (j + (S k + 1) * 4)%nat with (4 + j + (k + 1) * 4)%nat by lia; apply IH; lia. }
  specialize (Q a 3%nat ltac:(lia)); match goal with |- In (?n, _) _ => replace n with (3 + (k + 1) * 4)%nat by lia end;
    exact Q.
Qed.
Lemma plus_at_least z : 0 < z < 1 -> 1 <= (1 + z ^ 4) * ((z ^ 3 - z ^ (3 + 4 * a)) / (1 - z ^ 4) + z ^ 2 / (1 - z ^ 3))
  -> at_least (patterns a1 (1 ^ 2) Plus Plus) (- ln z).
Proof.
  intros Hz HS; pose proof (circle_first s ltac:(lra)) as first; pose proof (step_word a (le_n _)) as HW;
    set (L := map (fun k => (3 + 4 * k)%nat) (seq 0 a)).
  assert (InL : forall n, In n L <-> exists k, (k < a)%nat /\ n = (3 + 4 * k)%nat).
  { intros n; unfold L; rewrite in_map_iff; split; [intros (k & <- & H); apply in_seq in H; exists k; split;
      [lia | reflexivity] | intros (k & H & ->); exists k; split; [reflexivity | apply in_seq; lia]]. }
  assert (NL : NoDup L) by (apply map_NoDup; [apply seq_NoDup | intros; lia]); assert (L1 : ~ In 1%nat L)
    by (rewrite InL; intros (k & _ & H); lia).
  assert (L2 : ~ In 2%nat L) by (rewrite InL; intros (k & _ & H); lia); assert (L4 : ~ In 4%nat L) by (rewrite InL;
    intros (k & _ & H); lia).
  assert (Q4 : 0 < z ^ 4 < 1) by (split; [apply pow_lt; lra | apply pow_lt_1_compat; [lra | lia]]).
  assert (Q3 : 0 < z ^ 3 < 1) by (split; [apply pow_lt; lra | apply pow_lt_1_compat; [lra | lia]]);
    assert (Q2 : 0 < z ^ 2 < 1) by (split; [apply pow_lt; lra | apply pow_lt_1_compat; [lra | lia]]).
  set (k0 := 1 + z ^ 4); set (w2 := k0 / (1 - z ^ 3)); assert (W2 : w2 * (1 - z ^ 3) = k0) by (unfold w2; field; lra);
    assert (k0 <= w2) by (unfold k0 in *; nra).
  set (w := fun n : nat => if (n =? 1)%nat then z ^ 2 * w2 else if (n =? 2)%nat then w2 else if (n =? 4)%nat then 1 else
    k0).
  set (succ := fun n : nat => if (n =? 1)%nat then [2]%nat else if (n =? 2)%nat then (1 :: 2 :: 4 :: L)%nat else if
    (n =? 4)%nat then (2 :: L)%nat else (2 :: 4 :: L)%nat).
  assert (SumW : z ^ 2 * w2 + sum_of L (fun j => z ^ j * w j) = k0 * ((z ^ 3 - z ^ (3 + 4 * a)) / (1 - z ^ 4) + z ^ 2
    / (1 - z ^ 3))).
  { rewrite (sum_ext L _ (fun j => z ^ j * k0)).
    - unfold L; rewrite sum_map, (sum_ext _ _ (fun k => z ^ 3 * k0 * (z ^ 4) ^ k)) by (intros k _; rewrite pow_add,
        pow_mult; ring).
      rewrite sum_scale, sum_seq by exact Q4; rewrite <- pow_mult, pow_add; unfold w2; field; split; lra.
    - intros n Hn; unfold w; destruct (Nat.eqb_spec n 1) as [->|]; [contradiction|]; destruct (Nat.eqb_spec n 2)
        as [->|]; [contradiction|]; destruct (Nat.eqb_spec n 4) as [->|]; [contradiction | reflexivity]. }
  fold k0 in HS; rewrite <- SumW in HS; set (all := (1 :: 2 :: 4 :: L)%nat).
  assert (V1 : In (1%nat, D) (vertices 2 (wa a))) by (left; reflexivity);
    assert (V2 : In (2%nat, U) (vertices 2 (wa a))) by (right; left; reflexivity).
  assert (V4 : In (4%nat, D) (vertices 2 (wa a))) by (right; right; right; left; reflexivity).
  assert (VL : forall n, In n L -> In (n, U) (vertices 2 (wa a))) by (intros n Hn; apply InL in Hn;
    destruct Hn as (k & Hk & ->); apply step_vertex; lia).
  assert (Mem : forall n, In n all -> member a1 (1 ^ 2) Plus n).
  { destruct HW as [_ HV]; rewrite Forall_forall in HV; intros n [<-|[<-|[<-|Hn]]]; [exact (HV _ V1) | exact (HV _ V2) |
      exact (HV _ V4) | exact (HV _ (VL n Hn))]. }
  assert (ER : forall n x, In (n, x) (vertices 2 (wa a)) -> x = U -> forall m, In (m, U) (vertices 2 (wa a)) ->
    edge a1 (1 ^ 2) Plus Plus n m).
  { intros n x Hn -> m Hm; exact (word_edge s ltac:(lra) _ _ _ _ _ Plus HW Hn Hm eq_refl). }
  assert (E12 : edge a1 (1 ^ 2) Plus Plus 1 2 /\ edge a1 (1 ^ 2) Plus Plus 2 1).
  { split; [exact (word_edge s ltac:(lra) _ _ _ _ _ Plus HW V1 V2 eq_refl) |
      exact (word_edge s ltac:(lra) _ _ _ _ _ Plus HW V2 V1 eq_refl)]. }
  assert (E42 : edge a1 (1 ^ 2) Plus Plus 4 2 /\ edge a1 (1 ^ 2) Plus Plus 2 4).
  { split; [exact (word_edge s ltac:(lra) _ _ _ _ _ Plus HW V4 V2 eq_refl) |
      exact (word_edge s ltac:(lra) _ _ _ _ _ Plus HW V2 V4 eq_refl)]. }
  assert (E4L : forall n, In n L -> edge a1 (1 ^ 2) Plus Plus 4 n /\ edge a1 (1 ^ 2) Plus Plus n 4).
  { intros n Hn; pose proof (VL n Hn) as Vn; apply InL in Hn; destruct Hn as (k & Hk & ->);
      pose proof (step_renewed k Hk) as R0.
    split; [apply (word_edge s ltac:(lra) _ _ _ (4%nat, D) ((3 + 4 * k)%nat, U) Plus HW V4 Vn) |
      apply (word_edge s ltac:(lra) _ _ _ ((3 + 4 * k)%nat, U) (4%nat, D) Plus HW Vn V4)]; unfold mark_of; rewrite R0;
      reflexivity. }
  assert (S1 : forall x, In x all -> incl (succ x) all).
  { intros x _ y Hy; unfold succ in Hy; unfold all; destruct (x =? 1)%nat, (x =? 2)%nat, (x =? 4)%nat; cbn [In] in *;
      tauto. }
  apply (from_below (patterns a1 (1 ^ 2) Plus Plus) z ltac:(lra) (member_1_or_more a1 (1 ^ 2)) (fun n => In n all) succ
    w (w2 + 1 + k0) (4 * a + 4)%nat ltac:(unfold k0 in *; lra)) with (i := 2%nat).
  - intros n _; assert (0 <= z ^ 2 * w2 <= w2) by (unfold k0 in *; split; nra); unfold w; destruct (n =? 1)%nat,
      (n =? 2)%nat, (n =? 4)%nat; unfold k0 in *; lra.
  - intros x Hx; split.
    + unfold succ; destruct (x =? 1)%nat, (x =? 2)%nat, (x =? 4)%nat; repeat constructor; cbn [In]; try exact NL;
        intuition lia.
    + intros y Hy; pose proof (S1 x Hx y Hy) as Hy'; split; [exact Hy'|]; split; [apply Mem, Hy'|];
        cbn [joined patterns periods_of]; split.
      * unfold succ in Hy; destruct Hx as [<-|[<-|[<-|Hx]]]; cbn [Nat.eqb] in Hy.
        -- destruct Hy as [<-|[]]; apply E12.
        -- destruct Hy as [<-|[<-|[<-|Hy]]]; [apply E12 | apply (ER 2%nat U V2 eq_refl 2%nat V2) | apply E42 |
             apply (ER 2%nat U V2 eq_refl y (VL y Hy))].
        -- destruct Hy as [<-|Hy]; [apply E42 | apply (E4L y Hy)].
        -- destruct (Nat.eqb_spec x 1) as [->|]; [contradiction|]; destruct (Nat.eqb_spec x 2) as [->|];
             [contradiction|]; destruct (Nat.eqb_spec x 4) as [->|]; [contradiction|].
           destruct Hy as [<-|[<-|Hy]]; [apply (ER x U (VL x Hx) eq_refl 2%nat V2) | apply (E4L x Hx) |
             apply (ER x U (VL x Hx) eq_refl y (VL y Hy))].
      * destruct Hy' as [<-|[<-|[<-|Hy']]]; try lia; apply InL in Hy'; destruct Hy' as (k & Hk & ->); lia.
  - intros x Hx; cbn [periods_of patterns]; destruct Hx as [<-|[<-|[<-|Hx]]]; unfold succ; cbn [Nat.eqb].
    + unfold w; cbn [Nat.eqb sum_of]; lra.
    + cbn [sum_of]; change (w 1%nat) with (z ^ 2 * w2); change (w 2%nat) with w2; change (w 4%nat) with 1;
        rewrite pow_1.
      replace (z * (z ^ 2 * w2)) with (z ^ 3 * w2) by ring; unfold k0 in W2; lra.
    + cbn [sum_of]; change (w 2%nat) with w2; change (w 4%nat) with 1; lra.
    + destruct (Nat.eqb_spec x 1) as [->|N1]; [contradiction|]; destruct (Nat.eqb_spec x 2) as [->|N2];
        [contradiction|]; destruct (Nat.eqb_spec x 4) as [->|N4]; [contradiction|].
      assert (Wx : w x = k0) by (unfold w; rewrite (proj2 (Nat.eqb_neq _ _) N1), (proj2 (Nat.eqb_neq _ _) N2),
        (proj2 (Nat.eqb_neq _ _) N4); reflexivity).
      rewrite Wx; cbn [sum_of]; change (w 2%nat) with w2; change (w 4%nat) with 1; unfold k0 in *; lra.
  - right; left; reflexivity.
  - apply Mem; right; left; reflexivity.
  - change (w 2%nat) with w2; unfold k0 in *; lra.
Qed.
End Plus.

Theorem Supremum_plus : Supremum_plus_statement.
Proof.
  destruct root_plus_exists as (z & Hr & Hn); exists z; split; [exact Hr | split; [exact Hn|]]; split;
    [apply (plus_below z Hr ltac:(lra))|].
  intros h Hh; destruct Hr as [Hz E]; destruct (little_above z h Hz Hh) as (t & Ht & Lt).
  assert (P : forall k x, (1 <= k)%nat -> 0 < x < 1 -> 0 < x ^ k < 1) by (intros k x Hk Hx; split;
    [apply pow_lt; lra | apply pow_lt_1_compat; [lra | lia]]).
  assert (G : forall k, (1 <= k)%nat -> z ^ k < t ^ k) by (intros k Hk; destruct k as [|k]; [lia|];
    apply pow_lt_compat_l; [lia | lra]).
  assert (Gap : 0 < (1 + t ^ 4) * (t ^ 3 / (1 - t ^ 4) + t ^ 2 / (1 - t ^ 3)) - 1).
  { pose proof (P 4%nat z ltac:(lia) Hz); pose proof (P 3%nat z ltac:(lia) Hz); pose proof (P 2%nat z ltac:(lia) Hz).
    pose proof (P 4%nat t ltac:(lia) ltac:(lra)); pose proof (P 3%nat t ltac:(lia) ltac:(lra));
      pose proof (P 2%nat t ltac:(lia) ltac:(lra)).
    pose proof (G 4%nat ltac:(lia)); pose proof (G 3%nat ltac:(lia)); pose proof (G 2%nat ltac:(lia)).
    assert (F1 : z ^ 3 / (1 - z ^ 4) < t ^ 3 / (1 - t ^ 4)).
    { unfold Rdiv; apply Rmult_le_0_lt_compat; try lra; [left; apply Rinv_0_lt_compat; lra | apply Rinv_lt_contravar;
        [apply Rmult_lt_0_compat; lra | lra]]. }
    assert (F2 : z ^ 2 / (1 - z ^ 3) < t ^ 2 / (1 - t ^ 3)).
    { unfold Rdiv; apply Rmult_le_0_lt_compat; try lra; [left; apply Rinv_0_lt_compat; lra | apply Rinv_lt_contravar;
        [apply Rmult_lt_0_compat; lra | lra]]. }
    assert (0 < z ^ 3 / (1 - z ^ 4) + z ^ 2 / (1 - z ^ 3)) by (apply (Rmult_lt_reg_l (1 + z ^ 4)); [lra|]; lra).
    set (f := z ^ 3 / (1 - z ^ 4) + z ^ 2 / (1 - z ^ 3)) in *; set (f' := t ^ 3 / (1 - t ^ 4) + t ^ 2 / (1 - t ^ 3));
      assert (f < f') by (unfold f, f'; lra).
    assert ((1 + z ^ 4) * f < (1 + t ^ 4) * f') by (apply Rmult_le_0_lt_compat; lra); lra. }
  pose proof (P 4%nat t ltac:(lia) ltac:(lra)) as P4; pose proof (P 3%nat t ltac:(lia) ltac:(lra)) as P3.
  set (d := (1 - t ^ 4) / 2); destruct (small_power t ((1 + t ^ 4) * (t ^ 3 / (1 - t ^ 4) + t ^ 2 / (1 - t ^ 3)) - 1) d
    ltac:(lra) ltac:(unfold d; lra)) as [n Hnn]; set (a := n).
  set (g := (1 + t ^ 4) * (t ^ 3 / (1 - t ^ 4) + t ^ 2 / (1 - t ^ 3)) - 1) in *.
  assert (Small : t ^ (3 + 4 * a) <= d * g) by (destruct (Hnn (3 + 4 * a)%nat ltac:(unfold a; lia)); lra).
  set (s := (1 / 4 + Rmin (1 / 3) (INR (a + 1) / INR (4 * a + 3))) / 2);
    assert (A : 1 / 4 < INR (a + 1) / INR (4 * a + 3)).
  { rewrite !plus_INR, mult_INR; change (INR 1) with 1; replace (INR 3) with 3 by (simpl; ring); replace (INR 4) with 4
      by (simpl; ring); pose proof (pos_INR a) as A0.
    clearbody a; apply (Rmult_lt_reg_r (4 * INR a + 3)); [lra|].
    replace ((INR a + 1) / (4 * INR a + 3) * (4 * INR a + 3)) with (INR a + 1) by (field; lra); lra. }
  pose proof (Rmin_l (1 / 3) (INR (a + 1) / INR (4 * a + 3)));
    pose proof (Rmin_r (1 / 3) (INR (a + 1) / INR (4 * a + 3))).
  assert (M : 1 / 4 < Rmin (1 / 3) (INR (a + 1) / INR (4 * a + 3))) by (apply Rmin_glb_lt; lra).
  pose proof (circle_first s ltac:(unfold s; lra)) as F.
  assert (AL : at_least (patterns (trace 1 s) (1 ^ 2) Plus Plus) (- ln t)).
  { apply (plus_at_least s a); [unfold s; lra | unfold s; lra | lra|].
    replace ((1 + t ^ 4) * ((t ^ 3 - t ^ (3 + 4 * a)) / (1 - t ^ 4) + t ^ 2 / (1 - t ^ 3)))
      with (1 + g - (1 + t ^ 4) / (1 - t ^ 4) * t ^ (3 + 4 * a)) by (unfold g; field; split; lra).
    assert (Q : (1 + t ^ 4) / (1 - t ^ 4) * t ^ (3 + 4 * a) <= (1 + t ^ 4) / (1 - t ^ 4) * (d * g)).
    { apply Rmult_le_compat_l; [|exact Small]; apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]. }
    replace ((1 + t ^ 4) / (1 - t ^ 4) * (d * g)) with ((1 + t ^ 4) / 2 * g) in Q by (unfold d; field; lra); nra. }
  rewrite pow1 in F, AL; exists (trace 1 s), 2%nat; split; [exact F | apply (at_least_less _ (- ln t));
    [exact AL | lra]].
Qed.
