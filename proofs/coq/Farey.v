(** * Neighbours of a fraction in lowest terms exist, are unique and add up to it

    Section 4 of ../conjecture1.md, elementary. *)

From Coq Require Import Reals ZArith Arith Lia.
From Grazing Require Import Defs Statement.
Open Scope R_scope.

Lemma neighbours_exist m n : (2 <= n)%nat -> Nat.gcd m n = 1%nat -> exists mp np mm nm, neighbours m n mp np mm nm.
Proof.
  intros Hn Hg. assert (Hm : (0 < m)%nat) by (destruct m; [rewrite Nat.gcd_0_l in Hg|]; lia).
  destruct (Nat.gcd_bezout_pos m n Hm) as (a & c & E); rewrite Hg in E. pose proof (Nat.div_mod a n ltac:(lia)) as D.
  pose proof (Nat.mod_upper_bound a n ltac:(lia)) as B. set (np := (a mod n)%nat) in *; set (t := (a / n)%nat) in *.
  assert (E' : (m * np + m * t * n = 1 + c * n)%nat) by (rewrite <- E, D; ring). assert (Hc : (m * t <= c)%nat) by nia.
  assert (Emp : (m * np = (c - m * t) * n + 1)%nat) by (rewrite Nat.mul_sub_distr_r; nia).
  set (mp := (c - m * t)%nat) in *. assert (Hnp : (0 < np)%nat) by nia. assert (Hmp : (mp < m)%nat) by nia.
  exists mp, np, (m - mp)%nat, (n - np)%nat; unfold neighbours. repeat split; lia.
Qed.

Section Neighbours.

Variables m n mp np mm nm : nat.
Hypothesis H : neighbours m n mp np mm nm.

Lemma neighbours_coprime : Nat.gcd m n = 1%nat.
Proof. destruct H as (_ & E & _); apply Nat.bezout_1_gcd; exists np, mp; lia. Qed.

(** A time determines a lattice point: n divides k if it divides k m. *)
Lemma multiple_zero (k l : Z) : (k * Z.of_nat m = l * Z.of_nat n)%Z -> (- Z.of_nat n < k < Z.of_nat n)%Z -> k = 0%Z.
Proof.
  destruct H as (_ & E & _); intros Ek Hk.
  assert (E' : (Z.of_nat m * Z.of_nat np = Z.of_nat mp * Z.of_nat n + 1)%Z) by lia.
  assert (k = Z.of_nat n * (l * Z.of_nat np - k * Z.of_nat mp))%Z.
  { replace k with (k * Z.of_nat m * Z.of_nat np - k * Z.of_nat mp * Z.of_nat n)%Z at 1 by (rewrite <- Z.mul_assoc, E';
      ring).
    rewrite Ek; ring. }
  set (z := (l * Z.of_nat np - k * Z.of_nat mp)%Z) in *. assert (z = 0 \/ z <= -1 \/ 1 <= z)%Z as [|[|]] by lia; nia.
Qed.

(** Heights i = k m - l n: the times at height i are i n+ and -i n- mod n. *)
Lemma height_plus (k l : Z) : let i := (k * Z.of_nat m - l * Z.of_nat n)%Z in
  (i * Z.of_nat np = k + (k * Z.of_nat mp - l * Z.of_nat np) * Z.of_nat n)%Z.
Proof.
  destruct H as (_ & E & _); apply (f_equal Z.of_nat) in E.
  rewrite Nat2Z.inj_add, !Nat2Z.inj_mul in E; apply (f_equal (Z.mul k)) in E; lia.
Qed.

Lemma height_minus (k l : Z) : let i := (k * Z.of_nat m - l * Z.of_nat n)%Z in
  (- i * Z.of_nat nm = k + (l * Z.of_nat nm - k * Z.of_nat mm) * Z.of_nat n)%Z.
Proof.
  destruct H as (_ & _ & _ & E); apply (f_equal Z.of_nat) in E.
  rewrite Nat2Z.inj_add, !Nat2Z.inj_mul in E; apply (f_equal (Z.mul k)) in E; lia.
Qed.

Lemma neighbours_sum : (mp + mm = m)%nat /\ (np + nm = n)%nat.
Proof.
  pose proof (multiple_zero (Z.of_nat np + Z.of_nat nm - Z.of_nat n) (Z.of_nat mp + Z.of_nat mm - Z.of_nat m)) as Hz.
  destruct H as (? & ? & ? & ?).
  assert (np + nm = n)%nat by (enough (Z.of_nat np + Z.of_nat nm - Z.of_nat n = 0)%Z by lia; apply Hz; lia). split; nia.
Qed.

Lemma neighbours_unique mp' np' mm' nm' : neighbours m n mp' np' mm' nm' -> (mp', np', mm', nm') = (mp, np, mm, nm).
Proof.
  intros H'. pose proof (multiple_zero (Z.of_nat np' - Z.of_nat np) (Z.of_nat mp' - Z.of_nat mp)) as Hp.
  pose proof (multiple_zero (Z.of_nat nm' - Z.of_nat nm) (Z.of_nat mm' - Z.of_nat mm)) as Hm.
  destruct H as (? & ? & ? & ?), H' as (? & ? & ? & ?).
  assert (np' = np) by (enough (Z.of_nat np' - Z.of_nat np = 0)%Z by lia; apply Hp; lia).
  assert (nm' = nm) by (enough (Z.of_nat nm' - Z.of_nat nm = 0)%Z by lia; apply Hm; lia).
  subst np' nm'; assert (mp' = mp) by (apply (Nat.mul_cancel_r _ _ n); lia).
  assert (mm' = mm) by (apply (Nat.mul_cancel_r _ _ n); lia); congruence.
Qed.

End Neighbours.

Lemma neighbours_proof : Neighbours_statement.
Proof.
  intros m n Hn Hg; destruct (neighbours_exist m n Hn Hg) as (mp & np & mm & nm & H).
  exists (Build_Farey _ _ _ _ _ _ H); destruct (neighbours_sum _ _ _ _ _ _ H).
  split; [assumption|split; [assumption|]]; intros [mp' np' mm' nm' H'].
  pose proof (neighbours_unique _ _ _ _ _ _ H _ _ _ _ H') as E; inversion E; cbn; auto.
Qed.

(** ** Theorem 2's intervals with their neighbours spelt out *)

Lemma left_of n m mp np mm nm : (0 < 2 * m < n)%nat -> neighbours m n mp np mm nm -> interval n Plus Plus
  (if (m =? 1)%nat then 1 / (2 * INR n) else INR mp / INR np) (INR m / INR n).
Proof. intros Hm HF; exact (beside n _ _ _ _ (left_side n m (Build_Farey _ _ _ _ _ _ HF) Hm)). Qed.

Lemma right_of n m mp np mm nm : (0 < 2 * m < n)%nat -> neighbours m n mp np mm nm ->
  interval n Plus Minus (INR m / INR n) (INR mm / INR nm).
Proof. intros Hm HF; exact (beside n _ _ _ _ (right_side n m (Build_Farey _ _ _ _ _ _ HF) Hm)). Qed.

Inductive interval_view (n : nat) : sign -> sign -> R -> R -> Prop :=
| view_first : interval_view n Minus Plus 0 (1 / (2 * INR n))
| view_left m mp np mm nm : (0 < 2 * m < n)%nat -> neighbours m n mp np mm nm ->
    interval_view n Plus Plus
      (if (m =? 1)%nat then 1 / (2 * INR n) else INR mp / INR np) (INR m / INR n)
| view_right m mp np mm nm : (0 < 2 * m < n)%nat -> neighbours m n mp np mm nm ->
    interval_view n Plus Minus (INR m / INR n) (INR mm / INR nm).

Lemma view n e g lo hi : interval n e g lo hi -> interval_view n e g lo hi.
Proof.
  intros [|k g' lo' hi' [m F Hm|m F Hm]]; [constructor|eapply view_left|eapply view_right]; eauto using are_neighbours.
Qed.
