(** * Proof that [memberZ], [edgeZ] and [patternZ] decide members, edges and patterns *)

From Coq Require Import Reals ZArith List Bool Lra Lia.
From Grazing Require Import Defs Algebra StatementWords StatementZ StatementWordsZ OrbitZ WordAlgebra.
Import ListNotations. Open Scope R_scope.

Section At.
Variables p s q : Z.
Hypothesis q_pos : (0 < q)%Z.
Notation a1 := (IZR p / IZR q).
Notation a2 := (IZR s / IZR q).

(** By I4, p_j - q_i is N_{i+j,i} over u_i u_j. *)
Lemma signE_edge i j : u a1 a2 i <> 0 -> u a1 a2 j <> 0 ->
  sign_of (signE p s q i j) (StatementWords.p a1 a2 j - StatementWords.q a1 a2 i).
Proof.
  intros Hi Hj; rewrite (I4 a1 a2 j i Hj Hi).
  replace (N a1 a2 (j + i) i / (u a1 a2 j * u a1 a2 i)) with (N a1 a2 (j + i) i / u a1 a2 j / u a1 a2 i) by (field;
    tauto).
  unfold signE; set (z := (uZ p s q (i + j) - q ^ Z.of_nat j * uZ p s q i - s ^ Z.of_nat i * uZ p s q j)%Z).
  assert (S : sign_of (Z.sgn z) (N a1 a2 (j + i) i)).
  { pose proof (q_R q q_pos); apply (sign_of_scaled _ _ (IZR q ^ (i + j) / IZR q)); [apply scale_pos; assumption|].
    unfold N, z; rewrite !minus_IZR, !mult_IZR, <- !pow_IZR, !uZ_u, (pow_s s q) by assumption.
    replace (j + i - i)%nat with j by lia; replace (j + i)%nat with (i + j)%nat by lia; rewrite !pow_add; field; lra. }
  pose proof (sign_of_quotient _ _ _ _ S (sign_u p s q q_pos j) Hj) as Q.
  pose proof (sign_of_quotient (uZ p s q j * z) (uZ p s q i) (N a1 a2 (j + i) i / u a1 a2 j) (u a1 a2 i)) as Q2.
  rewrite Z.sgn_mul in Q2; apply Q2; trivial; apply sign_u; assumption.
Qed.

Lemma edgeZ_edge e g i j : u a1 a2 i <> 0 -> u a1 a2 j <> 0 -> (edgeZ p s q e g i j = true <-> edge a1 a2 e g i j).
Proof. intros Hi Hj; unfold edgeZ, edge; rewrite Z.ltb_lt; apply sgnZ_sgn_sgn, signE_edge; assumption. Qed.

Lemma memberZ_member e n : memberZ p s q e n = true <-> member a1 a2 e n.
Proof.
  unfold memberZ, member; rewrite andb_true_iff, nonzero, forallb_forall by assumption.
  apply and_iff_dependent; intros Hu; split; intros Hb k Hk.
  - apply (sgnZ_sgn e (signB p s q n k)); [apply signB_b; trivial; lia|]; apply Z.ltb_lt, Hb, in_seq; lia.
  - apply in_seq in Hk; apply Z.ltb_lt, (sgnZ_sgn e _ (b a1 a2 n k)); [apply signB_b; trivial; lia | apply Hb; lia].
Qed.

Lemma walkZ_walk e g l : forall x y, u a1 a2 x <> 0 -> u a1 a2 y <> 0 -> (forall n, In n l -> u a1 a2 n <> 0) ->
  walkZ (edgeZ p s q e g) x l y = true <-> walk (edge a1 a2 e g) x l y.
Proof.
  induction l as [|z l IH]; intros x y Hx Hy Hl; cbn [walkZ walk]; [apply edgeZ_edge; assumption|].
  rewrite andb_true_iff, edgeZ_edge, IH by (cbn in Hl; auto); reflexivity.
Qed.

Lemma patternZ_pattern e g l : patternZ p s q e g l = true <-> pattern a1 a2 e g l.
Proof.
  unfold patternZ, pattern, cyclic; destruct l as [|x l]; [split; [discriminate | intros [_ []]]|].
  rewrite andb_true_iff, forallb_forall, Forall_forall.
  assert (M : (forall n, In n (x :: l) -> memberZ p s q e n = true) <-> (forall n, In n (x :: l) -> member a1 a2 e n)).
  { split; intros H n Hn; apply memberZ_member, H, Hn. }
  rewrite M; apply and_iff_dependent; intros H.
  assert (U : forall n, In n (x :: l) -> u a1 a2 n <> 0) by (intros n Hn; apply (H n Hn)).
  apply walkZ_walk; cbn in U; auto.
Qed.
End At.

Theorem Words_oracle : Words_oracle_statement.
Proof.
  intros p s q Hq; split; [|split].
  - intros e n; apply memberZ_member, Hq.
  - intros i j Hi Hj; split; [apply signE_edge; assumption | intros e g; apply edgeZ_edge; assumption].
  - intros e g l; apply patternZ_pattern, Hq.
Qed.
