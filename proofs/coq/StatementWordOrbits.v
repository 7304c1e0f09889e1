(** * Statements: words are finite if a2 < 1, and the walks of their graphs are orbits of every
    grazing map of the plane

    It joins [StatementWords] to Theorem 1 as [StatementOrbitsPlane] has it; read these first.
    J is Z for bi-infinite sequences of flights, cyclic for patterns. *)

From Coq Require Import Reals List.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane StatementWords.
Import ListNotations. Open Scope R_scope.

(** With damping every word ends. *)
Definition Word_ends_statement : Prop := forall a1 a2 K, first_upper a1 a2 K -> a2 < 1 ->
  exists w i j, path a1 a2 K w i j /\
  Forall (fun x => member a1 a2 Plus (fst x)) (vertices K w) /\ ~ member a1 a2 Plus (i + j).

(** Exactly one orbit within d of 0. *)
Definition one_orbit (M : Map.t) (J : Type) (next : J -> J) (n : J -> nat) (mu d : R) : Prop :=
  exists x, orbit_near M J next n mu d x /\
  forall x', orbit_near M J next n mu d x' -> forall j i, (i < 2)%nat -> x' j i = x j i.

(** Every region: all sequences of periods up to n_max that have an orbit in one case, with one mu0. *)
Definition Shift_orbits_statement : Prop := forall M a1 a2 gamma e w0, planar M a1 a2 gamma e w0 ->
  0 < a2 -> forall n_max, exists d mu0, d > 0 /\ mu0 > 0 /\
  forall (J : Type) (next prev : J -> J) n s g mu,
  (forall j, prev (next j) = j /\ next (prev j) = j) ->
  sgn g * gamma > 0 -> 0 < sgn s * (e * mu) < mu0 ->
  (forall j, (n j <= n_max)%nat /\ orbit a1 a2 (n j) s g) -> one_orbit M J next n mu d.

(** Regions 3 and 4, e mu > 0: where the word ends in w, the sequences over all of V that have an
    orbit are those that follow the arrows (for gamma < 0, that follow none). *)
Definition Word_orbits_statement : Prop := forall M a1 a2 gamma e w0, planar M a1 a2 gamma e w0 ->
  forall K w i j, first_upper a1 a2 K -> path a1 a2 K w i j ->
  Forall (fun x => member a1 a2 Plus (fst x)) (vertices K w) -> ends a1 a2 i j ->
  (forall n, member a1 a2 Plus n <-> In n (map fst (vertices K w))) /\
  exists d mu0, d > 0 /\ mu0 > 0 /\
  forall (J : Type) (next prev : J -> J) (n : J -> nat * letter) g mu,
  (forall j, prev (next j) = j /\ next (prev j) = j) ->
  sgn g * gamma > 0 -> 0 < e * mu < mu0 -> (forall j, In (n j) (vertices K w)) ->
  ((forall j, (if arrow K w (n j) (n (next j)) then Plus else Minus) = g) ->
   one_orbit M J next (fun j => fst (n j)) mu d) /\
  forall j, (if arrow K w (n j) (n (next j)) then Plus else Minus) <> g ->
  forall x, ~ orbit_near M J next (fun j => fst (n j)) mu d x.
