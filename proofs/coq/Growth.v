(** * Proof that the words of a graph grow as [grows] finds it: of [GraphWords], one vector for both bounds *)

From Coq Require Import Reals QArith Qreals List Bool Arith Lra Lia.
From Grazing Require Import StatementGraphs StatementGrowth GraphWords GraphEntropy.
Import ListNotations. Open Scope R_scope.

Lemma Q2R_one : Q2R 1 = 1. Proof. unfold Q2R; cbn; field. Qed.
Lemma Q2R_ahead L V z i : Q2R (ahead L V z i) =
  sum_of (filter (follow L i) (seq 0 (length L))) (fun j => Q2R z ^ lasts L j * Q2R (nth j V 0%Q)).
Proof.
  assert (P : forall n, Q2R (power z n) = Q2R z ^ n) by (induction n as [|n IH]; cbn;
    [apply Q2R_one | rewrite Q2R_mult, IH; reflexivity]).
  unfold ahead; induction (filter _ _) as [|j l IH]; cbn [fold_right sum_of]; [unfold Q2R; cbn; field|].
  rewrite Q2R_plus, Q2R_mult, P, IH; reflexivity.
Qed.
(** 1/x for x >= 1. *)
Lemma inverse x : Qle_bool 1 x = true -> 0 < Q2R (/ x) <= 1 /\ ln (Q2R x) = - ln (Q2R (/ x)).
Proof.
  intros H; apply Qle_bool_iff in H; pose proof (Qle_Rle _ _ H) as H'; rewrite Q2R_one in H'.
  rewrite Q2R_inv by (intros E; rewrite E in H; unfold Qle in H; cbn in H; lia); rewrite ln_Rinv by lra; split; [|ring].
  split; [apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1; apply Rinv_le_contravar; lra].
Qed.
Theorem Growth_reader : Growth_reader_statement.
Proof.
  intros L V lo hi H; unfold grows in H; rewrite !andb_true_iff, negb_true_iff, Nat.eqb_neq, forallb_forall in H.
  destruct H as (((HN & Hlo) & Hhi) & H); destruct (inverse lo Hlo) as [Zlo ->], (inverse hi Hhi) as [Zhi ->].
  set (N := length L) in *; set (v := fun j => Q2R (nth j V 0%Q)); assert (Hp : forall i, (1 <= lasts L i)%nat)
    by (intros i; unfold lasts; pose proof (Pos2Nat.is_pos (fst (nth i L (1%positive, [])))); lia).
  assert (HV : forall i, (i < N)%nat -> 0 < v i /\ v i <= Q2R (ahead L V (/ lo) i) /\ Q2R (ahead L V (/ hi) i) <= v i).
  { intros i Hi; specialize (H i ltac:(apply in_seq; lia)); rewrite !andb_true_iff, negb_true_iff in H.
    destruct H as ((A & B) & C); apply Qle_bool_iff, Qle_Rle in B; apply Qle_bool_iff, Qle_Rle in C; split;
      [|split; assumption].
    unfold v; replace 0 with (Q2R 0) by (unfold Q2R; cbn; field); apply Qlt_Rlt, Qnot_le_lt; intros E.
    apply Qle_bool_iff in E; congruence. }
  assert (Pos : forall z l, 0 < z <= 1 -> incl l (seq 0 N) -> forall j, In j l -> 0 <= z ^ lasts L j * v j).
  { intros z l Hz Hl j Hj; apply Hl, in_seq in Hj; destruct (HV j ltac:(lia)); apply Rmult_le_pos;
      [apply pow_le|]; lra. }
  split.
  - destruct (least N v ltac:(lia)) as (k & Hk & Hm).
    apply (from_above (graph_of L) _ Zhi (fun i _ => Hp i) v (v k) (proj1 (HV k Hk)) Hm)
      with (T := sum_of (seq 0 N) (fun j => Q2R (/ hi) ^ lasts L j * v j)).
    + intros i Hi X HX Hj; destruct (HV i Hi) as (_ & _ & B); rewrite Q2R_ahead in B; eapply Rle_trans; [|exact B].
      apply sum_incl; [exact HX | |]; intros j Ij.
      * destruct (Hj j Ij) as [J1 J2]; apply filter_In; split; [apply in_seq; cbn in J1; fold N; lia | exact J2].
      * apply (Pos _ _ Zhi) with (2 := Ij); intros x Ix; apply filter_In in Ix; apply Ix.
    + intros X HX Hj; apply sum_incl; [exact HX | intros j Ij; apply in_seq; specialize (Hj j Ij); cbn in Hj;
        fold N in Hj; lia|].
      apply (Pos _ _ Zhi); intros x; trivial.
  - destruct (least N (fun i => - v i) ltac:(lia)) as (k & Hk & Hm);
      destruct (least N (fun i => - INR (lasts L i)) ltac:(lia)) as (l & _ & Hl).
    apply (from_below (graph_of L) _ Zlo (fun i _ => Hp i) (fun i => (i < N)%nat) (fun i =>
      filter (follow L i) (seq 0 N)) v (v k) (lasts L l) (proj1 (HV k Hk))) with (i := k); try assumption;
      [| | |apply (HV k Hk)].
    + intros i Hi; specialize (Hm i Hi); destruct (HV i Hi); cbv beta in Hm; lra.
    + intros i Hi; split; [apply NoDup_filter, seq_NoDup|]; intros j Ij; apply filter_In in Ij; destruct Ij as [Ij E].
      apply in_seq in Ij; cbn; fold N; repeat split; try lia; [exact E|]; specialize (Hl j ltac:(lia)); cbv beta in Hl;
        apply INR_le; lra.
    + intros i Hi; destruct (HV i Hi) as (_ & B & _); rewrite Q2R_ahead in B; exact B.
Qed.
