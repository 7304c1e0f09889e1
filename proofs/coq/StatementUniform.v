(** * Statement: in any dimension one bound serves all words if the flights contract, letter after letter

    Read [invertible] in [StatementOrbits] first: Theorem 1 asks it of each word, with one K for all. *)

From Coq Require Import Reals.
From Grazing Require Import Defs StatementOrbits.
Open Scope R_scope.

(** C A^n B, and the flight of n steps from x, before it a kick along B that makes C x = 0 at its end. *)
Definition crossing (M : Map.t) (n : nat) : R := dot (Map.N M) (Map.C M) (power M n (Map.B M)).
Definition onward (M : Map.t) (n : nat) (x : vec) : vec := power M n (fun i =>
  x i - dot (Map.N M) (Map.C M) (power M n x) / crossing M n * Map.B M i).

(** k flights; the last has w 0 steps. *)
Fixpoint through (M : Map.t) (k : nat) (w : nat -> nat) (x : vec) : vec :=
  match k with O => x | S k => onward M (w 0%nat) (through M k (fun l => w (S l)) x) end.

(** L flights halve every vector. (All end in the plane C x = 0: to halve that plane in L - 1 flights, up to a
    factor, is the same for some L.) *)
Definition contracting (M : Map.t) (letters : nat -> Prop) (L : nat) : Prop := forall w t x,
  (forall k, letters (w k)) -> within (Map.N M) t x -> within (Map.N M) (t / 2) (through M L w x).

Definition Uniform_statement : Prop := forall M (letters : nat -> Prop) n_max L,
  (forall n, letters n -> (n <= n_max)%nat /\ crossing M n <> 0) -> contracting M letters L ->
  exists K, forall (J : Type) (next prev : J -> J) n, (forall j, prev (next j) = j /\ next (prev j) = j) ->
  (forall j, letters (n j)) -> invertible M J next n K.
