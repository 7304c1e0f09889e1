(** * Proof that closed walks in the graph of (52) and (64) are periodic orbits of maps *)

From Coq Require Import Reals List Arith Lia.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane StatementWords
  StatementOrbitsPatterns PlaneOrbits.
Import ListNotations.
Open Scope R_scope.

Lemma place_eq l (i j : place l) : proj1_sig i = proj1_sig j -> i = j.
Proof.
  destruct i as [i Hi], j as [j Hj]; cbn; intros <-; f_equal; apply le_unique.
Qed.

Lemma proj_next l j : proj1_sig (next_place l j) = (S (proj1_sig j) mod length l)%nat.
Proof. destruct j; reflexivity. Qed.

Definition prev_place (l : list nat) (j : place l) : place l := let (k, Hk) := j in
  exist _ ((k + (length l - 1)) mod length l)%nat (Nat.mod_upper_bound (k + (length l - 1)) (length l)
    (fun E => Nat.nlt_0_r k (eq_ind (length l) (lt k) Hk 0%nat E))).

Lemma proj_prev l j : proj1_sig (prev_place l j) = ((proj1_sig j + (length l - 1)) mod length l)%nat.
Proof. destruct j; reflexivity. Qed.

Lemma places_bijective l (j : place l) :
  prev_place l (next_place l j) = j /\ next_place l (prev_place l j) = j.
Proof.
  assert (Hm : forall k, (k < length l)%nat -> ((k + length l) mod length l = k)%nat).
  { intros k Hk; rewrite <- (Nat.mul_1_l (length l)) at 1; rewrite Nat.mod_add by lia.
    apply Nat.mod_small, Hk. }
  destruct j as [k Hk]; split; apply place_eq.
  - rewrite proj_prev, proj_next; cbn [proj1_sig]; rewrite Nat.add_mod_idemp_l by lia.
    rewrite <- (Hm k Hk) at 2; f_equal; lia.
  - rewrite proj_next, proj_prev; cbn [proj1_sig].
    rewrite <- Nat.add_1_l, Nat.add_mod_idemp_r by lia.
    rewrite <- (Hm k Hk) at 2; f_equal; lia.
Qed.

(** A walk, step by step. *)
Lemma walk_nth {T} (E : T -> T -> Prop) (z : T) x l y : walk E x l y ->
  forall k, (k <= length l)%nat -> E (nth k (x :: l) z) (nth k (l ++ [y]) z).
Proof.
  revert x; induction l as [|x' l IH]; intros x H k Hk; cbn in *.
  - replace k with 0%nat by lia; exact H.
  - destruct H as [H1 H2]; destruct k as [|k]; [exact H1 | apply (IH x' H2 k); lia].
Qed.

Lemma cyclic_nth (E : nat -> nat -> Prop) l (j : place l) : cyclic E l ->
  E (steps l j) (steps l (next_place l j)).
Proof.
  unfold steps; rewrite proj_next; destruct j as [k Hk]; cbn [proj1_sig]; destruct l as [|x l]; [contradiction|].
  intros H; pose proof (walk_nth E 0%nat x l x H k ltac:(cbn in Hk; lia)) as Hw.
  replace (nth (S k mod length (x :: l)) (x :: l) 0%nat) with (nth k (l ++ [x]) 0%nat); [exact Hw|].
  cbn [length] in *; destruct (Nat.eq_dec k (length l)) as [->|Hne].
  - rewrite Nat.mod_same, app_nth2, Nat.sub_diag by lia; reflexivity.
  - rewrite Nat.mod_small, app_nth1 by lia; reflexivity.
Qed.

Theorem Patterns_orbits : Patterns_statement_orbits.
Proof.
  intros M a1 a2 gamma e w HP n_max.
  destruct (Theorem1_plane M a1 a2 gamma e w HP n_max) as (d & mu0 & Hd & Hmu0 & H & _).
  exists d, mu0; split; [exact Hd | split; [exact Hmu0|]]; intros l s g mu Hg Hmu Hl.
  rewrite Forall_forall in Hl.
  assert (Hin : forall j : place l, In (steps l j) l) by (intros [k Hk]; apply nth_In; exact Hk).
  destruct (H (place l) (next_place l) (prev_place l) (steps l) s g mu (places_bijective l)
    (fun j => Hl _ (Hin j)) Hg Hmu) as [Hex Hno]; split.
  - intros [Hm Hc]; rewrite Forall_forall in Hm; apply Hex; intros j; split; [apply (Hm _ (Hin j))|].
    exact (cyclic_nth _ l j Hc).
  - intros [j Hj]; exact (Hno j Hj).
Qed.
