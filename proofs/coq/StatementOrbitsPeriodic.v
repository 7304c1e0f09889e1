(** * Statement: Theorem 1 as in the paper, for one periodic impact pattern

    It says that det (I - A) <> 0 and det D <> 0 are all the hypotheses that a periodic pattern
    needs, and that a symmetry of the word takes orbits to orbits. Read [StatementOrbits] first. *)

From Coq Require Import Reals.
From Grazing Require Import Defs StatementOrbits.
Open Scope R_scope.

(** J = {at 0, ..., at (m-1)}. The pattern (n_1, ..., n_m) is J = Z/m with next j = j + 1. *)
Definition finite (J : Type) : Prop := exists (m : nat) (at_ : nat -> J) (index : J -> nat),
  (forall j, (index j < m)%nat /\ at_ (index j) = j) /\ forall k, (k < m)%nat -> index (at_ k) = k.

(** A square matrix has determinant <> 0 iff only 0 is mapped to 0. *)
Definition det_I_A_not_0 (M : Map.t) : Prop := forall x,
  (forall i, (i < Map.N M)%nat -> x i - mult (Map.N M) (Map.A M) x i = 0) ->
  forall i, (i < Map.N M)%nat -> x i = 0.
Definition det_D_not_0 (M : Map.t) (J : Type) (next : J -> J) (n : J -> nat) : Prop := forall X Y,
  linear M J next n X Y (fun _ => zero) (fun _ => 0) ->
  forall j, Y j = 0 /\ forall i, (i < Map.N M)%nat -> X j i = 0.

Definition Theorem1_statement_periodic : Prop := forall M, smooth M -> det_I_A_not_0 M ->
  exists w, (forall i, (i < Map.N M)%nat -> w i = mult (Map.N M) (Map.A M) w i + Map.phi M i) /\
  let rate := dot (Map.N M) (Map.C M) w + Map.eta M in rate <> 0 ->
  forall J next n, finite J -> (forall j, (1 <= n j)%nat) -> det_D_not_0 M J next n ->
  exists X Y, linear M J next n X Y (fun _ => zero) (fun _ => -1) /\ forall e,
  ((forall j v, quantity M J n X Y e j v -> v > 0) -> exists d, d > 0 /\
   (exists mu0, mu0 > 0 /\ forall mu, 0 < sgn e * (rate * mu) < mu0 ->
    exists x, orbit_near M J next n mu d x /\
    forall x', orbit_near M J next n mu d x' -> forall j i, (i < Map.N M)%nat -> x' j i = x j i) /\
   forall eps, eps > 0 -> exists mu1, mu1 > 0 /\ forall mu x, 0 < sgn e * (rate * mu) < mu1 ->
    orbit_near M J next n mu d x -> forall j, within (Map.N M) eps (x j)) /\
  (forall j v, quantity M J n X Y e j v -> v < 0 -> exists d mu0, d > 0 /\ mu0 > 0 /\
   forall mu x, 0 < sgn e * (rate * mu) < mu0 -> ~ orbit_near M J next n mu d x).

(** With uniqueness: the orbit has every symmetry of its word; periodic words have periodic orbits. *)
Definition Symmetry_statement : Prop := forall M J (next : J -> J) n mu d x (sigma : J -> J),
  (forall j, sigma (next j) = next (sigma j)) -> (forall j, n (sigma j) = n j) ->
  orbit_near M J next n mu d x -> orbit_near M J next n mu d (fun j => x (sigma j)).
