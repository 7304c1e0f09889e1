(** * Statement: Theorem 1 for one impact and the affine grazing map in the plane

    It says that the signs (52), (53) decide which single-impact orbits of that map exist
    near 0, for every period n: existence, uniqueness and non-existence. Read [Defs] first. *)

From Coq Require Import Reals.
From Grazing Require Import Defs.
Open Scope R_scope.

Definition point : Type := R * R.

(** One step without impact, seen from its fixed point: the matrix (45). *)
Definition flight (a1 a2 : R) (x : point) : point := (a1 * fst x + snd x, - a2 * fst x).

(** h = e mu + x_1, where eps stands for e mu. Negative means impact. *)
Definition clearance (eps : R) (z : point) : R := eps + fst z.

(** The grazing map g o f, with B = (0, beta). *)
Definition affine_map (a1 a2 beta eps : R) (x : point) : point :=
  let z := flight a1 a2 x in
  if Rle_dec 0 (clearance eps z) then z
  else (fst z, snd z + beta * sqrt (- clearance eps z)).

(** n steps lead from x back to x; the first n - 1 are free and the last one impacts. *)
Definition single_impact_orbit (a1 a2 beta eps : R) (n : nat) (x : point) : Prop :=
  let visit k := Nat.iter k (affine_map a1 a2 beta eps) x in
  visit n = x /\
  (forall k, (S k < n)%nat -> clearance eps (flight a1 a2 (visit k)) > 0) /\
  (forall k, S k = n -> clearance eps (flight a1 a2 (visit k)) < 0).

(** (52) or (53) fails strictly in the case (e, g). *)
Definition fails (a1 a2 : R) (n : nat) (e g : sign) : Prop :=
  (exists k, (1 <= k <= n - 1)%nat /\ sgn e * b a1 a2 n k < 0) \/
  sgn e * sgn g * c a1 a2 n < 0.

(** sgn g is the sign of C A B = beta. The orbit tends to 0 with eps; no other comes as
    near as d, which does not depend on eps, and none does if a condition fails. *)
Definition Theorem1_statement_affine : Prop := forall a1 a2 beta n e g,
  (1 <= n)%nat -> u a1 a2 n <> 0 -> sgn g * beta > 0 ->
  exists d eps0 M, d > 0 /\ eps0 > 0 /\ forall eps, 0 < sgn e * eps < eps0 ->
  (orbit a1 a2 n e g -> exists x, single_impact_orbit a1 a2 beta eps n x /\
     Rabs (fst x) <= M * Rabs eps < d /\ Rabs (snd x) <= M * Rabs eps /\
     forall x', single_impact_orbit a1 a2 beta eps n x' -> Rabs (fst x') < d -> x' = x) /\
  (fails a1 a2 n e g -> forall x, single_impact_orbit a1 a2 beta eps n x -> d <= Rabs (fst x)).
