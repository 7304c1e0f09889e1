(** * Statement: how fast the words of a graph grow in number: log 1/z, z the least root of det(I - M(z))

    A word says how many periods lie between one impact and the next: the number of words with at most P
    periods is that of ways in which impacts can follow one another up to period P. *)

From Coq Require Import Reals List Arith.
Import ListNotations. Open Scope R_scope.

(** Vertices, how many periods each takes, and which may follow which. *)
Record graph := { vertex : nat -> Prop; periods_of : nat -> nat; joined : nat -> nat -> Prop }.
Definition total (G : graph) (l : list nat) : nat := fold_right (fun i s => (periods_of G i + s)%nat) 0%nat l.
Fixpoint follows (G : graph) (i : nat) (l : list nat) : Prop := match l with [] => True
  | j :: l => vertex G j /\ joined G i j /\ follows G j l end.
(** The words with at most P periods. *)
Definition words (G : graph) (P : nat) (l : list nat) : Prop := (total G l <= P)%nat /\
  match l with [] => True | i :: l => vertex G i /\ follows G i l end.

(** Their number grows like exp (h P): no faster, no slower. *)
Definition at_most (G : graph) (h : R) : Prop := forall h', h < h' -> exists C, forall P L,
  NoDup L -> Forall (words G P) L -> INR (length L) <= C * exp (h' * INR P).
Definition at_least (G : graph) (h : R) : Prop := forall h', h' < h -> exists c, c > 0 /\ forall P, exists L,
  NoDup L /\ Forall (words G P) L /\ c * exp (h' * INR P) <= INR (length L).

(** ** Finite graphs: the vertices are 0, ..., N - 1 *)
Definition finite (N : nat) (p : nat -> nat) (E : nat -> nat -> bool) : graph :=
  {| vertex := fun i => (i < N)%nat; periods_of := p; joined := fun i j => E i j = true |}.
(** The entry of M(t) at (i, j) is t^(p j) where j may follow i, else 0; v is fixed by M(t), and is not 0. *)
Definition row (p : nat -> nat) (E : nat -> nat -> bool) (t : R) (i j : nat) : R :=
  if E i j then t ^ p j else 0.
Fixpoint sum_to (N : nat) (f : nat -> R) : R := match N with O => 0 | S N => sum_to N f + f N end.
Definition singular (N : nat) (p : nat -> nat) (E : nat -> nat -> bool) (t : R) : Prop := exists v,
  (exists i, (i < N)%nat /\ v i <> 0) /\ forall i, (i < N)%nat ->
    v i = sum_to N (fun j => row p E t i j * v j).
(** z is the least positive root of det(I - M(z)): where it is 0, and nowhere below, a vector is fixed. *)
Definition Graph_entropy_statement : Prop := forall N p E z, (forall i, (i < N)%nat -> (1 <= p i)%nat) ->
  0 < z <= 1 -> singular N p E z -> (forall t, 0 < t < z -> ~ singular N p E t) ->
  at_most (finite N p E) (- ln z) /\ at_least (finite N p E) (- ln z).
