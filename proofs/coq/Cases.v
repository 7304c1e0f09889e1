(** * The signs of b and c determine the case in which the orbit exists *)

From Coq Require Import Reals Lra Lia.
From Grazing Require Import Defs Statement Algebra.
Open Scope R_scope.

(** The orbit exists in the case (e, g) if P holds, and in no other case. *)
Definition exists_iff (a1 a2 : R) (n : nat) (e g : sign) (P : Prop) : Prop :=
  forall e' g', orbit a1 a2 n e' g' <-> e' = e /\ g' = g /\ P.

Definition all_b (P : R -> Prop) (r s : R) (n : nat) : Prop :=
  forall k, (1 <= k <= n - 1)%nat -> P (b_at r s n k).

Lemma One_case : One_case_statement.
Proof.
  intros a1 a2 n e g Hn (Hu & Hb & Hc); split.
  - intros (_ & k & k' & Hk & Hk' & H & H'); apply Hb in Hk, Hk'; destruct e; cbn [sgn] in *; lra.
  - intros e' g' (_ & Hb' & Hc'); specialize (Hb 1%nat ltac:(lia)); specialize (Hb' 1%nat ltac:(lia)).
    destruct e, e', g, g'; cbn [sgn] in *; split; reflexivity || lra.
Qed.

Lemma c_detIA a1 a2 n : c a1 a2 n = - detIA a1 a2 n / u a1 a2 n. Proof. reflexivity. Qed.

Lemma quotient_pos y z : 0 < y * z -> 0 < y / z.
Proof.
  intros H; assert (z <> 0) by (intros ->; lra). replace (y / z) with (y * z / (z * z)) by (field; assumption).
  apply Rdiv_lt_0_compat; [assumption | nra].
Qed.

Lemma c_neg a1 a2 n : 0 < detIA a1 a2 n * u a1 a2 n -> c a1 a2 n < 0.
Proof. intros H; apply quotient_pos in H. rewrite c_detIA; unfold Rdiv in *; lra. Qed.
Lemma c_pos a1 a2 n : detIA a1 a2 n * u a1 a2 n < 0 -> c a1 a2 n > 0.
Proof. intros H; rewrite c_detIA; apply quotient_pos; lra. Qed.

(** [decides] and [exists_iff]. *)
Lemma decides_iff a1 a2 n d g : decides a1 a2 n d g -> exists_iff a1 a2 n Plus g (b a1 a2 n d > 0).
Proof.
  intros [_ Hd Hp Hneg _] e' g'; split; [|intros (-> & -> & H); apply Hp, H].
  intros Ho; destruct (Rtotal_order (b a1 a2 n d) 0) as [H|[H|H]].
  - destruct (proj1 (One_case a1 a2 n e' g' ltac:(lia) Ho) (Hneg H)).
  - exfalso; destruct Ho as (_ & Hb & _); specialize (Hb d Hd); rewrite H in Hb; lra.
  - destruct (proj2 (One_case a1 a2 n Plus g ltac:(lia) (Hp H)) e' g' Ho); tauto.
Qed.

Section Cases.
Variables (a1 a2 : R) (n : nat).
Notation b := (b a1 a2 n).
Hypothesis u_n : u a1 a2 n <> 0.

(** Some b > 0 and the sign of c is known: what is left is whether all b > 0. *)
Lemma exists_iff_Plus g (P : Prop) : (exists k, (1 <= k <= n - 1)%nat /\ b k > 0) -> sgn g * c a1 a2 n > 0 ->
  ((forall k, (1 <= k <= n - 1)%nat -> b k > 0) <-> P) -> exists_iff a1 a2 n Plus g P.
Proof.
  intros (k & Hk & Hb) Hc HP e g'; split.
  - intros (_ & H & H'); specialize (H k Hk) as Hbk. destruct e; cbn [sgn] in *; [|lra].
    repeat split; [destruct g, g'; cbn [sgn] in *; reflexivity || lra |].
    apply HP; intros j Hj; specialize (H j Hj); lra.
  - intros (-> & -> & HPt); repeat split; [assumption | | cbn [sgn] in *; lra].
    intros j Hj; cbn [sgn]; rewrite Rmult_1_l; apply HP; assumption.
Qed.

Lemma exists_Plus g : (2 <= n)%nat -> (forall k, (1 <= k <= n - 1)%nat -> b k > 0) -> sgn g * c a1 a2 n > 0 ->
  exists_iff a1 a2 n Plus g True.
Proof. intros Hn Hb Hc; apply exists_iff_Plus; [|assumption|tauto]. exists 1%nat; split; [lia | apply Hb; lia]. Qed.

Lemma exists_Minus_Plus : (2 <= n)%nat -> (forall k, (1 <= k <= n - 1)%nat -> b k < 0) -> c a1 a2 n < 0 ->
  exists_iff a1 a2 n Minus Plus True.
Proof.
  intros Hn Hb Hc e g; split.
  - intros (_ & H & H'). specialize (H 1%nat ltac:(lia)); specialize (Hb 1%nat ltac:(lia)).
    destruct e, g; cbn [sgn] in *; tauto || (exfalso; lra).
  - intros (-> & -> & _); repeat split; [assumption| |cbn; lra]. intros k Hk; specialize (Hb k Hk); cbn; lra.
Qed.
End Cases.
