(** * Statement: Theorem 1 for smooth maps of any dimension and for every word

    It says, by the signs (33) and (34), which impact patterns have exactly one orbit near 0 and which
    have none, with one bound on mu for all words over a finite alphabet. Complete on this page. *)
From Coq Require Import Reals.
From Grazing Require Import Defs. (* for sign and sgn only *)
Open Scope R_scope.

(** R^N: the coordinates below N, with the maximum norm; rows and matrices. *)
Definition vec : Type := nat -> R.
Definition zero : vec := fun _ => 0.
Definition minus (x y : vec) : vec := fun i => x i - y i.
Definition within (N : nat) (t : R) (x : vec) : Prop := forall i, (i < N)%nat -> Rabs (x i) <= t.
Fixpoint dot (N : nat) (c x : vec) : R := match N with O => 0 | S i => dot i c x + c i * x i end.
Definition mult (N : nat) (A : nat -> vec) (x : vec) : vec := fun i => dot N (A i) x.

(** F(0, 0) = 0, and F is strictly differentiable there with derivatives L in x and l in mu. *)
Definition strict (N : nat) (F : vec -> R -> R) (L : vec -> R) (l : R) : Prop :=
  F zero 0 = 0 /\ forall eps, 0 < eps -> exists d, 0 < d /\ forall x x' mu mu' t,
  within N d x -> within N d x' -> Rabs mu <= d -> Rabs mu' <= d -> within N t (minus x x') ->
  Rabs (mu - mu') <= t -> Rabs (F x mu - F x' mu' - L (minus x x') - (mu - mu') * l) <= eps * t.
(** f, h and b (here kick) of (1)-(5) and their derivatives at 0; A 0, A 1, ... are the rows of A. *)
Module Map. Record t := { N : nat; f : vec -> R -> vec; h : vec -> R -> R; kick : vec -> R -> R -> vec;
  A : nat -> vec; phi : vec; C : vec; eta : R; B : vec }. End Map.
Import Map.
(** f and h are strictly differentiable; so is kick * y, for y >= 0, its derivatives B in y, 0 in x and mu. *)
Definition smooth (M : Map.t) : Prop :=
  (forall i, (i < N M)%nat -> strict (N M) (fun x mu => f M x mu i) (dot (N M) (A M i)) (phi M i)) /\
  strict (N M) (h M) (dot (N M) (C M)) (eta M) /\
  forall eps, 0 < eps -> exists d, 0 < d /\ forall x x' y y' mu mu' t i, (i < N M)%nat ->
  within (N M) d x -> within (N M) d x' -> 0 <= y <= d -> 0 <= y' <= d -> Rabs mu <= d -> Rabs mu' <= d ->
  within (N M) t (minus x x') -> Rabs (y - y') <= t -> Rabs (mu - mu') <= t ->
    Rabs (kick M x y mu i * y - kick M x' y' mu' i * y' - (y - y') * B M i) <= eps * t.
(** One step x -> g(f(x, mu), mu) of the map, (3) and (4); h in the (k+1)-st step from x. *)
Definition step (M : Map.t) (mu : R) (x : vec) : vec :=
  let z := f M x mu in let y := sqrt (- h M z mu) in
  if Rle_dec 0 (h M z mu) then z else fun i => z i + kick M z y mu i * y.
Definition height (M : Map.t) (mu : R) (x : vec) (k : nat) : R :=
  h M (f M (Nat.iter k (step M mu) x) mu) mu.

Section Word. (** Impacts J, the [next] impact and the number n of steps that lead to it: J is
  cyclic for periodic patterns and Z for bi-infinite words. x j is the point after impact j. *)
Variables (M : Map.t) (J : Type) (next : J -> J) (n : J -> nat).
Definition orbit_near (mu d : R) (x : J -> vec) : Prop := forall j,
  within (N M) d (x j) /\ (forall k, (S k < n j)%nat -> height M mu (x j) k > 0) /\
  (forall k, S k = n j -> height M mu (x j) k < 0) /\
  forall i, (i < N M)%nat -> Nat.iter (n j) (step M mu) (x j) i = x (next j) i.
(** The linear problem (28) with any right-hand side; [invertible]: among bounded families
    it has exactly one solution, at most K times the right-hand side; [solution]: (32). *)
Definition bounded (t : R) (X : J -> vec) (Y : J -> R) : Prop :=
  forall j, within (N M) t (X j) /\ Rabs (Y j) <= t.
Definition power (k : nat) : vec -> vec := Nat.iter k (mult (N M) (A M)).
Definition linear (X : J -> vec) (Y : J -> R) (Q : J -> vec) (r : J -> R) : Prop := forall j,
  dot (N M) (C M) (power (n j) (X j)) = r j /\
  forall i, (i < N M)%nat -> X (next j) i - power (n j) (X j) i - Y j * B M i = Q j i.
Definition invertible (K : R) : Prop :=
  (forall t Q r, bounded t Q r -> exists X Y, bounded (K * t) X Y /\ linear X Y Q r) /\
  (forall t X Y, bounded t X Y -> linear X Y (fun _ => zero) (fun _ => 0) -> bounded 0 X Y).
Definition solution X Y : Prop := (exists t, bounded t X Y) /\ linear X Y (fun _ => zero) (fun _ => -1).
(** v is one of the quantities of (33), (34) for impact j; e is the sign of the paper's e mu. *)
Definition quantity (X : J -> vec) (Y : J -> R) (e : sign) (j : J) (v : R) : Prop :=
  v = sgn e * Y j \/ exists k, (1 <= k < n j)%nat /\ v = sgn e * (dot (N M) (C M) (power k (X j)) + 1).
End Word.
(** w = (I - A)^-1 phi; rate is the paper's e, (26). d depends on the map, n_max and K, mu0 and mu1
    also on kappa and eps, none of them on the word. Parts: existence and uniqueness; non-existence;
    asymptotics. *)
Definition Theorem1_statement : Prop := forall M w rate, smooth M ->
  (forall i, (i < N M)%nat -> w i = mult (N M) (A M) w i + phi M i) ->
  rate = dot (N M) (C M) w + eta M -> rate <> 0 -> forall n_max K, exists d, d > 0 /\
  (forall kappa, kappa > 0 -> exists mu0, mu0 > 0 /\ forall J next n X Y e mu,
   (forall j, 1 <= n j <= n_max)%nat -> invertible M J next n K -> solution M J next n X Y ->
   0 < sgn e * (rate * mu) < mu0 ->
   ((forall j v, quantity M J n X Y e j v -> v >= kappa) ->
    exists x, orbit_near M J next n mu d x /\
    forall x', orbit_near M J next n mu d x' -> forall j i, (i < N M)%nat -> x' j i = x j i) /\
   (forall j v, quantity M J n X Y e j v -> v <= - kappa -> forall x, ~ orbit_near M J next n mu d x)) /\
  (forall eps, eps > 0 -> exists mu1, mu1 > 0 /\ forall J next n X Y mu x,
   (forall j, 1 <= n j <= n_max)%nat -> invertible M J next n K -> solution M J next n X Y ->
   0 < Rabs mu < mu1 -> orbit_near M J next n mu d x -> forall j,
   within (N M) (eps * Rabs mu) (fun i => x j i - mu * w i - rate * mu * X j i) /\
   Rabs (sqrt (- height M mu (x j) (n j - 1)) - rate * mu * Y j) <= eps * Rabs mu).
