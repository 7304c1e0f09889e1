(** * Statement: near grazing no periodic orbit with impacts is stable, if no C A^n B of its flights is 0; and
      what it means that a motion is unstable

    The first is of smooth maps in any dimension, whatever the word. (35), (36): a small change of the state
    after an impact becomes one along B at the next, and is multiplied there by about - C A^n B / (2 y), n steps
    on, y the small speed of the impact. No derivative is needed away from 0, where [smooth] asks for none. The
    second, at the end of this page, is for [one] in [Headline]: what is born is unstable. Read [orbit_near] in
    [StatementOrbits], [finite] in [StatementOrbitsPeriodic] and [crossing] in [StatementUniform] first. *)

From Coq Require Import Reals ZArith.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPeriodic StatementUniform.
Open Scope R_scope.

(** Some points as near to x as one likes go away from its orbit, to the distance r. *)
Definition unstable (M : Map.t) (mu : R) (x : vec) : Prop := exists r, r > 0 /\ forall eps, eps > 0 ->
  exists z i, within (Map.N M) eps (minus z x) /\
  ~ within (Map.N M) r (minus (Nat.iter i (step M mu) z) (Nat.iter i (step M mu) x)).

(** So no orbit that is born by Theorem 1 is stable, where C A^n B <> 0 for its letters n: in the plane with C
    B = 0 that is u_n <> 0. *)
Definition Unstable_statement : Prop := forall M w, smooth M ->
  (forall i, (i < Map.N M)%nat -> w i = mult (Map.N M) (Map.A M) w i + Map.phi M i) ->
  forall n_max kappa, kappa > 0 -> exists d, d > 0 /\ forall J next n mu x, finite J ->
  (forall j, (1 <= n j <= n_max)%nat /\ Rabs (crossing M (n j)) >= kappa) -> Rabs mu <= d ->
  orbit_near M J next n mu d x -> forall j, unstable M mu (x j).

(** The derivative of F at x has the matrix D. *)
Definition derivative_at (N : nat) (F : vec -> vec) (D : nat -> vec) (x : vec) : Prop := forall eps, eps > 0 ->
  exists r, r > 0 /\ forall z t, 0 <= t <= r -> within N t (minus z x) ->
  within N (eps * t) (fun i => F z i - F x i - mult N D (minus z x) i).

(** (35), (36): where each flight has a derivative, B is nearly an eigenvector of what they make together, and the
    eigenvalue is the product over the impacts of numbers lambda, each nearly - C A^n B / (2 y). *)
Definition Eigenvalue_statement : Prop := forall M w, smooth M ->
  (forall i, (i < Map.N M)%nat -> w i = mult (Map.N M) (Map.A M) w i + Map.phi M i) ->
  forall n_max kappa eps, kappa > 0 -> eps > 0 -> exists d, d > 0 /\ forall J next prev n mu x D,
  (forall j : J, prev (next j) = j /\ next (prev j) = j) ->
  (forall j, (1 <= n j <= n_max)%nat /\ Rabs (crossing M (n j)) >= kappa) -> Rabs mu <= d ->
  orbit_near M J next n mu d x ->
  (forall j, derivative_at (Map.N M) (Nat.iter (n j) (step M mu)) (D j) (x j)) ->
  exists V lambda, forall j, within (Map.N M) eps (minus (V j) (Map.B M)) /\
  (forall i, (i < Map.N M)%nat -> mult (Map.N M) (D j) (V j) i = lambda j * V (next j) i) /\
  let y := sqrt (- height M mu (x j) (n j - 1)) in y > 0 /\ Rabs (lambda j * (2 * y) + crossing M (n j)) <= eps.

(** ** Motions

    [leg t y v i j] says what the motion t, y, v is from impact i to the next, j: [swing] in
    [StatementOscillator], [leg] in [StatementNonlinear], [flight] in [StatementStops]. Two motions are near
    each other at impact i in its time and in the velocity after it; the place is on the stop. *)
Definition near (t t' : Z -> R) (v v' : Z -> R -> R) (eps : R) (i : Z) : Prop :=
  Rabs (t' i - t i) <= eps /\ Rabs (v' i (t' i) - v i (t i)) <= eps.
(** Not stable in Lyapunov's sense, from whichever impact j on: some motions leave impact j as near as one likes
    and, with the same impacts, come to an impact l whose time or velocity is off by more than r. *)
Definition unstable_motion (leg : (Z -> R) -> (Z -> R -> R) -> (Z -> R -> R) -> Z -> Z -> Prop)
  (t : Z -> R) (v : Z -> R -> R) : Prop := exists r, r > 0 /\ forall j eps, eps > 0 -> exists l t' y' v',
  (j < l)%Z /\ (forall i, (j <= i < l)%Z -> leg t' y' v' i (i + 1)%Z) /\
  near t t' v v' eps j /\ ~ near t t' v v' r l.
