(** * Statements: words end, where two cycles meet, and walks of the graph are orbits

    It joins [StatementWords] to Theorem 1 as [StatementOrbitsPlane] has it: for every grazing
    map of the plane. J is Z for bi-infinite sequences of flights, cyclic for patterns. *)

From Coq Require Import Reals List.
From Grazing Require Import Defs Statement StatementOrbits StatementOrbitsPlane StatementOrbitsPatterns StatementWords.
Import ListNotations. Open Scope R_scope.

(** With damping every word ends. *)
Definition Word_ends_statement : Prop := forall a1 a2 K, first_upper a1 a2 K -> a2 < 1 ->
  exists w i j, path a1 a2 K w i j /\
  Forall (fun x => member a1 a2 Plus (fst x)) (vertices K w) /\ ~ member a1 a2 Plus (i + j).

(** Where two cycles meet. e mu < 0, regions 3 and 4: for gamma > 0 where a1 > 0, for gamma < 0
    nowhere. e mu > 0, region 3: for gamma < 0 on the (+,-) areas of the 1/n, for gamma > 0 and
    s < 1/4 on the (+,+) areas of the 1/n (K + 1 follows K). *)
Definition cycles (a1 a2 : R) (e g : sign) : Prop :=
  two_cycles (fun i j => member a1 a2 e i /\ member a1 a2 e j /\ edge a1 a2 e g i j).
Definition Cycle_statement : Prop :=
  (forall a1 a2 K, first_upper a1 a2 K ->
   (cycles a1 a2 Minus Plus <-> 0 < a1) /\ ~ cycles a1 a2 Minus Minus) /\
  forall r s, 0 < r <= 1 -> 0 < s < 1 / 2 ->
  (cycles (trace r s) (r ^ 2) Plus Minus <->
   exists n, (3 <= n)%nat /\ 1 < INR n * s /\ INR (n - 1) * s < 1 /\ b_at r s n 1 > 0) /\
  forall K, 2 * (INR K - 1) * s <= 1 < 2 * INR K * s -> s < 1 / 4 ->
  (cycles (trace r s) (r ^ 2) Plus Plus <-> b_at r s (K + 1) K > 0).

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

(** With damping V is finite for e mu > 0, and one mu0 serves all patterns over it: the caveat that ends the paper's
    section 2.5 falls there. *)
Definition V_finite_statement : Prop := forall a1 a2 K, first_upper a1 a2 K -> a2 < 1 ->
  (exists L, forall n, member a1 a2 Plus n -> (n <= L)%nat) /\
  forall M gamma e w0, planar M a1 a2 gamma e w0 -> exists d mu0, d > 0 /\ mu0 > 0 /\
  forall l g mu, sgn g * gamma > 0 -> 0 < e * mu < mu0 -> pattern a1 a2 Plus g l ->
  one_orbit M (place l) (next_place l) (steps l) mu d.
