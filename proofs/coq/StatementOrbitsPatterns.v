(** * Statement: the patterns [n_1; ...; n_m] of [StatementWords] are periodic orbits of maps

    It says that closed walks in the graph of (52) and (64) are periodic orbits, for all
    patterns over the periods up to n_max at once. Read [StatementOrbitsPlane] first. *)

From Coq Require Import Reals List Arith.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane StatementWords.
Import ListNotations.
Open Scope R_scope.

(** The places of the pattern l = [n_1; ...; n_m], in cyclic order. *)
Definition place (l : list nat) : Type := {k : nat | (k < length l)%nat}.
Definition next_place (l : list nat) (j : place l) : place l := let (k, Hk) := j in
  exist _ (S k mod length l) (Nat.mod_upper_bound (S k) (length l)
    (fun E => Nat.nlt_0_r k (eq_ind (length l) (lt k) Hk 0%nat E))).
Definition steps (l : list nat) (j : place l) : nat := nth (proj1_sig j) l 0%nat.

(** (52) or (64) fails strictly somewhere in l. *)
Definition pattern_fails (a1 a2 : R) (s g : sign) (l : list nat) : Prop := exists j : place l,
  (exists k, (1 <= k <= steps l j - 1)%nat /\ sgn s * b a1 a2 (steps l j) k < 0) \/
  sgn s * sgn g * (p a1 a2 (steps l (next_place l j)) - q a1 a2 (steps l j)) < 0.

Definition Patterns_statement_orbits : Prop := forall M a1 a2 gamma e w,
  planar M a1 a2 gamma e w -> forall n_max, exists d mu0, d > 0 /\ mu0 > 0 /\
  forall l s g mu, sgn g * gamma > 0 -> 0 < sgn s * (e * mu) < mu0 ->
  Forall (fun n => (1 <= n <= n_max)%nat /\ u a1 a2 n <> 0) l ->
  (pattern a1 a2 s g l -> exists x, orbit_near M (place l) (next_place l) (steps l) mu d x /\
   forall x', orbit_near M (place l) (next_place l) (steps l) mu d x' ->
   forall j i, (i < 2)%nat -> x' j i = x j i) /\
  (pattern_fails a1 a2 s g l ->
   forall x, ~ orbit_near M (place l) (next_place l) (steps l) mu d x).
