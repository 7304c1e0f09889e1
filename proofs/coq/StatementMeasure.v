(** * Statement: for n >= 3 Theorem 2's intervals have the total length (1/n) (sum of 1/k over the k < n prime
    to n)

    Read [interval] in [Statement] first. *)

From Coq Require Import Reals List Arith.
From Grazing Require Import Defs Statement.
Open Scope R_scope.

Definition sum_over {A : Type} (f : A -> R) (l : list A) : R := fold_right (fun x y => f x + y) 0 l.

Definition coprime_to (n : nat) : list nat := filter (fun k => Nat.gcd k n =? 1)%nat (seq 1 n).

Definition length_of (x : sign * sign * R * R) : R := let (_, hi) := x in let (_, lo) := fst x in hi - lo.

(** In whatever order L lists the intervals, each once; [Theorem2_count_statement] says that such an L exists.
    *)
Definition Measure_statement : Prop := forall n (L : list (sign * sign * R * R)), (3 <= n)%nat -> NoDup L ->
  (forall e g lo hi, In (e, g, lo, hi) L <-> interval n e g lo hi) ->
  sum_over length_of L = / INR n * sum_over (fun k => / INR k) (coprime_to n).
