(** * Statement: Theorem 1 in the plane, where the linear problem needs no hypothesis

    It says that the signs of b, c and of (64) decide about orbits of every grazing map of the
    plane with C A B <> 0, with one bound on mu for all words over {n <= n_max : u_n <> 0}; and,
    for one impact, that [orbit] and [no_orbit] mean what they say. Read [StatementOrbits] first. *)

From Coq Require Import Reals.
From Grazing Require Import Defs StatementAffine StatementOrbits.
Open Scope R_scope.

(** A smooth map of the plane with trace a1, determinant a2, C B = 0 and gamma = C A B. *)
Record planar (M : Map.t) (a1 a2 gamma e : R) (w : vec) : Prop := {
  is_smooth : smooth M;
  is_plane : Map.N M = 2%nat;
  is_trace : a1 = Map.A M 0%nat 0%nat + Map.A M 1%nat 1%nat;
  is_det : a2 = Map.A M 0%nat 0%nat * Map.A M 1%nat 1%nat - Map.A M 0%nat 1%nat * Map.A M 1%nat 0%nat;
  is_CB : dot 2 (Map.C M) (Map.B M) = 0;
  is_gamma : gamma = dot 2 (Map.C M) (mult 2 (Map.A M) (Map.B M)) /\ gamma <> 0;
  is_w : forall i, (i < 2)%nat -> w i = mult 2 (Map.A M) w i + Map.phi M i;
  is_e : e = dot 2 (Map.C M) w + Map.eta M /\ e <> 0 }.

(** (64), without the signs: positive if a flight of j steps may follow one of i steps. *)
Definition follows (a1 a2 : R) (i j : nat) : R :=
  (u a1 a2 (S j) - 1) / u a1 a2 j - (a2 ^ i + a2 * u a1 a2 (i - 1)) / u a1 a2 i.

Definition Theorem1_statement_plane : Prop := forall M a1 a2 gamma e w,
  planar M a1 a2 gamma e w -> forall n_max, exists d mu0, d > 0 /\ mu0 > 0 /\
  (forall (J : Type) (next prev : J -> J) n s g mu,
   (forall j, prev (next j) = j /\ next (prev j) = j) ->
   (forall j, (1 <= n j <= n_max)%nat /\ u a1 a2 (n j) <> 0) ->
   sgn g * gamma > 0 -> 0 < sgn s * (e * mu) < mu0 ->
   ((forall j, (forall k, (1 <= k <= n j - 1)%nat -> sgn s * b a1 a2 (n j) k > 0) /\
               sgn s * sgn g * follows a1 a2 (n j) (n (next j)) > 0) ->
    exists x, orbit_near M J next n mu d x /\
    forall x', orbit_near M J next n mu d x' -> forall j i, (i < 2)%nat -> x' j i = x j i) /\
   (forall j, (exists k, (1 <= k <= n j - 1)%nat /\ sgn s * b a1 a2 (n j) k < 0) \/
              sgn s * sgn g * follows a1 a2 (n j) (n (next j)) < 0 ->
    forall x, ~ orbit_near M J next n mu d x)) /\
  (** These orbits tend to 0 with mu, uniformly. *)
  (forall eps, eps > 0 -> exists mu1, mu1 > 0 /\ forall (J : Type) (next prev : J -> J) n mu x,
   (forall j, prev (next j) = j /\ next (prev j) = j) ->
   (forall j, (1 <= n j <= n_max)%nat /\ u a1 a2 (n j) <> 0) -> 0 < Rabs mu < mu1 ->
   orbit_near M J next n mu d x -> forall j, within 2 eps (x j)).

(** ** One impact *)

(** x starts an orbit of period n with one impact, within d of 0. *)
Definition periodic (M : Map.t) (n : nat) (mu d : R) (x : vec) : Prop :=
  orbit_near M unit (fun j => j) (fun _ => n) mu d (fun _ => x).

(** For small mu with sign e mu = s there is exactly one near 0, and it tends to 0. *)
Definition born (M : Map.t) (e : R) (n : nat) (s : sign) : Prop := exists d, d > 0 /\
  (exists mu0, mu0 > 0 /\ forall mu, 0 < sgn s * (e * mu) < mu0 ->
   exists x, periodic M n mu d x /\
   forall x', periodic M n mu d x' -> forall i, (i < 2)%nat -> x' i = x i) /\
  forall eps, eps > 0 -> exists mu1, mu1 > 0 /\ forall mu x, 0 < sgn s * (e * mu) < mu1 ->
  periodic M n mu d x -> within 2 eps x.

(** There is none near 0. *)
Definition not_born (M : Map.t) (e : R) (n : nat) (s : sign) : Prop := exists d mu0,
  d > 0 /\ mu0 > 0 /\ forall mu x, 0 < sgn s * (e * mu) < mu0 -> ~ periodic M n mu d x.

Definition Theorem1_statement_single : Prop := forall M a1 a2 gamma e w n s g,
  planar M a1 a2 gamma e w -> (1 <= n)%nat -> u a1 a2 n <> 0 -> sgn g * gamma > 0 ->
  (orbit a1 a2 n s g -> born M e n s) /\ (fails a1 a2 n s g -> not_born M e n s) /\
  ~ (born M e n s /\ not_born M e n s).

(** Born in the case (s, g) and in no other; or in none. *)
Definition born_in (M : Map.t) (gamma e : R) (n : nat) (s g : sign) : Prop :=
  (sgn g * gamma > 0 -> born M e n s) /\
  forall s', ~ (s' = s /\ sgn g * gamma > 0) -> not_born M e n s'.
Definition never_born (M : Map.t) (e : R) (n : nat) : Prop := forall s, not_born M e n s.

(** The words of [Defs] are true of the orbits of every planar map. *)
Definition Meaning_statement : Prop := forall M a1 a2 gamma e w n,
  planar M a1 a2 gamma e w -> (2 <= n)%nat ->
  (forall s g, orbit a1 a2 n s g -> born_in M gamma e n s g) /\
  (no_orbit a1 a2 n -> never_born M e n).
