(** * Statement: the oscillator's map, to second order, meets the hypotheses of Theorem 1 in the plane

    It says that the oscillator's map, to the second order that (75) and (76) give, is [planar],
    for every matrix A with A_12 <> 0; with k = 0 this is the affine map. *)

From Coq Require Import Reals.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane.
Open Scope R_scope.

Definition pair_vec (x0 x1 : R) : vec := fun i => match i with O => x0 | _ => x1 end.

(** f = A x + mu phi, h = x_1 - k0 x_2^2 + mu eta, b = (k1 y + k2 x_2, beta + k3 y + k4 x_2 + k5 mu),
    in the paper's numbering of coordinates, x_1 and x_2. *)
Definition oscillator_map (A00 A01 A10 A11 phi0 phi1 eta beta k0 k1 k2 k3 k4 k5 : R) : Map.t := {|
  Map.N := 2;
  Map.f := fun x mu => pair_vec (A00 * x 0%nat + A01 * x 1%nat + mu * phi0)
                                (A10 * x 0%nat + A11 * x 1%nat + mu * phi1);
  Map.h := fun x mu => x 0%nat - k0 * (x 1%nat * x 1%nat) + mu * eta;
  Map.kick := fun x y mu => pair_vec (k1 * y + k2 * x 1%nat) (beta + k3 * y + k4 * x 1%nat + k5 * mu);
  Map.A := fun i => match i with O => pair_vec A00 A01 | _ => pair_vec A10 A11 end;
  Map.phi := pair_vec phi0 phi1; Map.C := pair_vec 1 0; Map.eta := eta; Map.B := pair_vec 0 beta |}.

Definition Instance_statement : Prop :=
  forall A00 A01 A10 A11 phi0 phi1 eta beta k0 k1 k2 k3 k4 k5 w0 w1,
  w0 = A00 * w0 + A01 * w1 + phi0 -> w1 = A10 * w0 + A11 * w1 + phi1 -> w0 + eta <> 0 -> A01 * beta <> 0 ->
  planar (oscillator_map A00 A01 A10 A11 phi0 phi1 eta beta k0 k1 k2 k3 k4 k5)
    (A00 + A11) (A00 * A11 - A01 * A10) (A01 * beta) (w0 + eta) (pair_vec w0 w1).
