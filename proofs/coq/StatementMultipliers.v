(** * Statement: the multipliers of orbits with one impact where Theorem 1 is silent, in any dimension

    [StatementResonance] says where such orbits are when C A^n (I - A^n)^-1 B = 0. Read there [single],
    [across] and [second_order] first, and [derivative_at] in [StatementUnstable]. *)
From Coq Require Import Reals Arith.
From Grazing Require Import StatementOrbits StatementUnstable StatementResonance.
Open Scope R_scope.

(** The derivatives in y and x of a function of both. *)
Definition slopes (N : nat) (G : R -> vec -> R) (y : R) (x : vec) (q : R) (p : vec) : Prop := forall eps,
  0 < eps -> exists r, 0 < r /\ forall y' x' t, 0 <= t <= r -> Rabs (y' - y) <= t ->
  StatementOrbits.within N t (minus x' x) ->
  Rabs (G y' x' - G y x - (y' - y) * q - dot N p (minus x' x)) <= eps * t.
(** At the speed y of an impact: c of the height of [second_order], and q, P of the point. *)
Record flight_slopes (M : Map.t) (n : nat) (mu y : R) (x c q : vec) (P : nat -> vec) : Prop := {
  slopes_height : slopes (Map.N M) (fun _ x => Map.h M (Nat.iter n (fun x => Map.f M x mu) x) mu) y x 0 c;
  slopes_impact : forall i, (i < Map.N M)%nat -> slopes (Map.N M) (fun y x =>
    let z := Nat.iter n (fun x => Map.f M x mu) x in z i + Map.kick M z y mu i * y) y x (q i) (P i) }.
Definition monodromy (y : R) (c q : vec) (P : nat -> vec) : nat -> vec := fun i j => P i j - q i * c j / (2 * y).
(** Determinants, by the first coordinates of the columns a 0, ..., a (N - 1); det (I - L), L linear. *)
Definition skip (j k : nat) : nat := if Nat.ltb k j then k else S k.
Fixpoint det (N : nat) (a : nat -> vec) : R := match N with O => 1 | S n =>
  dot N (fun j => (-1) ^ j * det n (fun k i => a (skip j k) (S i))) (fun j => a j O) end.
Definition axis (j : nat) : vec := fun i => if Nat.eqb i j then 1 else 0.
Definition det_less (N : nat) (L : vec -> vec) : R := det N (fun j => minus (axis j) (L (axis j))).
(** It is the derivative of n steps, and det (I - M) tends to - e K det (I - A^n); where it is negative, a
    multiplier is real and exceeds 1. *)
Definition Determinant_statement : Prop := forall M w V U rate n Qh Q, smooth M -> let N := Map.N M in
  (forall i, (i < N)%nat -> w i = mult N (Map.A M) w i + Map.phi M i) ->
  rate = dot N (Map.C M) w + Map.eta M -> rate <> 0 -> (1 <= n)%nat ->
  (forall x, (forall i, (i < N)%nat -> x i = power M n x i) -> forall i, (i < N)%nat -> x i = 0) ->
  (forall i, (i < N)%nat -> V i = power M n V i + Map.B M i /\ U i = power M n U i + Q i) ->
  second_order M w V rate n Qh Q -> across M V n = 0 ->
  let K := - (1 + Qh + across M U n) / rate in forall eps, 0 < eps -> exists d, 0 < d /\
  forall mu x c q P, Rabs mu <= d -> single M n mu d x -> let y := speed_of M n mu x in
  flight_slopes M n mu y (x tt) c q P -> let D := mult N (monodromy y c q P) in
  derivative_at N (Nat.iter n (step M mu)) (monodromy y c q P) (x tt) /\
  Rabs (det_less N D + rate * K * det_less N (power M n)) <= eps /\
  (det_less N D < 0 -> exists lambda v, 1 < lambda /\ (exists i, (i < N)%nat /\ v i <> 0) /\
    forall i, (i < N)%nat -> D v i = lambda * v i).
