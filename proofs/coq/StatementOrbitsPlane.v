(** * Definitions: a grazing map of the plane, and that it has exactly one orbit near grazing

    Definitions for [Headline], where Theorem 1 in the plane is stated; it needs no hypothesis on the linear
    problem there. Read [StatementOrbits] first. *)

From Coq Require Import Reals.
From Grazing Require Import Defs StatementOrbits.
Open Scope R_scope.

(** A smooth map of the plane with trace a1, determinant a2, C B = 0 and gamma = C A B; rate is the paper's e,
    (26). *)
Record planar (M : Map.t) (a1 a2 gamma rate : R) (w : vec) : Prop := {
  is_smooth : smooth M;
  is_plane : Map.N M = 2%nat;
  is_trace : a1 = Map.A M 0%nat 0%nat + Map.A M 1%nat 1%nat;
  is_det : a2 = Map.A M 0%nat 0%nat * Map.A M 1%nat 1%nat - Map.A M 0%nat 1%nat * Map.A M 1%nat 0%nat;
  is_CB : dot 2 (Map.C M) (Map.B M) = 0;
  is_gamma : gamma = dot 2 (Map.C M) (mult 2 (Map.A M) (Map.B M)) /\ gamma <> 0;
  is_w : forall i, (i < 2)%nat -> w i = mult 2 (Map.A M) w i + Map.phi M i;
  is_rate : rate = dot 2 (Map.C M) w + Map.eta M /\ rate <> 0 }.

(** Exactly one orbit within d of 0. *)
Definition one_orbit (M : Map.t) (J : Type) (next : J -> J) (n : J -> nat) (mu d : R) : Prop :=
  exists x, orbit_near M J next n mu d x /\
  forall x', orbit_near M J next n mu d x' -> forall j i, (i < 2)%nat -> x' j i = x j i.
