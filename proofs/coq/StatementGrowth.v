(** * Statement: a checker of how fast the paths of a graph of letters grow in number

    Read [StatementGraphs] first: what a certificate of chaos or of a range calls growth is that of the words
    of its graph. *)

From Coq Require Import Reals QArith Qreals List.
From Grazing Require Import StatementGraphs.
Import ListNotations.
Open Scope Q_scope.

(** Of each letter how many periods it lasts and the numbers, from 0, of those that may follow. *)
Definition lasts (L : list (positive * list nat)) (i : nat) : nat :=
  Pos.to_nat (fst (nth i L (1%positive, []))).
Definition follow (L : list (positive * list nat)) (i j : nat) : bool :=
  existsb (Nat.eqb j) (snd (nth i L (1%positive, []))).
Definition graph_of (L : list (positive * list nat)) : graph := finite (length L) (lasts L) (follow L).

Fixpoint power (z : Q) (n : nat) : Q := match n with O => 1 | S n => z * power z n end.
(** The sum of z^n v over the letters that may follow letter i, n being their periods and v their entries in
    V. *)
Definition ahead (L : list (positive * list nat)) (V : list Q) (z : Q) (i : nat) : Q :=
  fold_right (fun j s => power z (lasts L j) * nth j V 0 + s) 0 (filter (follow L i) (seq 0 (length L))).
Definition grows (L : list (positive * list nat)) (V : list Q) (lo hi : Q) : bool :=
  (negb (Nat.eqb (length L) 0) && Qle_bool 1 lo && Qle_bool 1 hi && forallb (fun i =>
    negb (Qle_bool (nth i V 0) 0) && Qle_bool (nth i V 0) (ahead L V (/ lo) i) &&
    Qle_bool (ahead L V (/ hi) i) (nth i V 0)) (seq 0 (length L)))%bool.

(** Words of P periods are no more than about hi^P, and no fewer than about lo^P. *)
Definition Growth_reader_statement : Prop := forall L V lo hi, grows L V lo hi = true ->
  at_most (graph_of L) (ln (Q2R hi)) /\ at_least (graph_of L) (ln (Q2R lo)).
