(** * Statement: where the curve of orbits with one impact turns, in a family of maps with a second parameter nu

    [StatementResonance] says that these orbits are one curve, with one mu for each small speed y, and on which
    side of mu = 0 it is where it begins with the slope 0. Here it does for nu = 0. For the other small nu mu is
    about S nu y + K y^2: so K mu falls up to y = - S nu / (2 K), and rises from there: where this is positive
    the orbits have a fold, and elsewhere none. Read [single], [across] and [beside] there first. *)
From Coq Require Import Reals Arith.
From Grazing Require Import StatementOrbits StatementResonance.
Open Scope R_scope.

(** f, h and kick are those of [Map], with nu besides, and so are their derivatives at 0. *)
Module Family. Record t := { N : nat; f : R -> vec -> R -> vec; h : R -> vec -> R -> R; kick : R -> vec -> R -> R ->
  vec; A : nat -> vec; phi : vec; C : vec; eta : R; B : vec }. End Family.
Definition member (F : Family.t) (nu : R) : Map.t := Map.Build_t (Family.N F) (Family.f F nu) (Family.h F nu)
  (Family.kick F nu) (Family.A F) (Family.phi F) (Family.C F) (Family.eta F) (Family.B F).
(** nu as one more coordinate, that no step changes; all derivatives in it are 0. *)
Definition rows (r : R) (x : vec) : vec := fun i => match i with O => r | S j => x j end.
Definition hat (x : vec) : vec := fun i => x (S i).
Definition whole (F : Family.t) : Map.t := Map.Build_t (S (Family.N F))
  (fun x mu => rows (x O) (Family.f F (x O) (hat x) mu)) (fun x mu => Family.h F (x O) (hat x) mu)
  (fun x y mu => rows 0 (Family.kick F (x O) (hat x) y mu))
  (fun i => match i with O => rows 1 zero | S j => rows 0 (Family.A F j) end) (rows 0 (Family.phi F))
  (rows 0 (Family.C F)) (Family.eta F) (rows 0 (Family.B F)).
(** All are C1 together, and for mu = 0 those with a small nu graze at 0. *)
Record smooth_family (F : Family.t) : Prop := {
  family_smooth : smooth (whole F);
  family_grazes : exists r, 0 < r /\ forall nu x, Rabs nu <= r -> (forall i, (i < Family.N F)%nat -> x i = 0) ->
    Family.h F nu x 0 = 0 /\ forall i, (i < Family.N F)%nat -> Family.f F nu x 0 i = 0 }.

(** [bends], and how the derivative in the direction (1, 0, V) changes with nu: p is a mixed second derivative. *)
Definition bends_along (N : nat) (V : vec) (G : R -> R -> R -> vec -> R) (L : R -> R -> vec -> R) (p Q : R) : Prop :=
  forall eps, 0 < eps -> exists r, 0 < r /\ forall nu y mu x y' mu' x', Rabs nu <= r -> 0 <= y <= r -> 0 <= y' <= r ->
  beside N V r y mu x -> beside N V r y' mu' x' -> beside N V r (y - y') (mu - mu') (minus x x') ->
  Rabs (G nu y mu x - G nu y' mu' x' - L (y - y') (mu - mu') (minus x x') -
    (nu * p * (y - y') + Q * (y ^ 2 - y' ^ 2))) <= eps * ((Rabs nu + y + y') * Rabs (y - y')).
Record mixed_order (F : Family.t) (w V : vec) (rate : R) (n : nat) (ph Qh : R) (p Q : vec) : Prop := {
  mixed_height : bends_along (Family.N F) V
    (fun nu _ mu x => Family.h F nu (Nat.iter n (fun x => Family.f F nu x mu) x) mu)
    (fun _ mu x => across (member F 0) x n + mu * (rate - across (member F 0) w n)) ph Qh;
  mixed_impact : forall i, (i < Family.N F)%nat -> bends_along (Family.N F) V (fun nu y mu x =>
    let z := Nat.iter n (fun x => Family.f F nu x mu) x in z i + Family.kick F nu z y mu i * y)
    (fun y mu x => power (member F 0) n x i + y * Family.B F i + mu * (w i - power (member F 0) n w i)) (p i) (Q i) }.

(** An orbit with one impact, of the speed y, in n steps. *)
Definition one_impact (F : Family.t) (n : nat) (d nu mu : R) (x : unit -> vec) (y : R) : Prop :=
  Rabs mu <= d /\ single (member F nu) n mu d x /\ speed_of (member F nu) n mu x = y.
Record turns (F : Family.t) (n : nat) (S K d : R) : Prop := {
  turn_one : exists r, 0 < r /\ forall nu y, Rabs nu < r -> 0 < y < r -> exists mu x, one_impact F n d nu mu x y /\
    forall mu' x', one_impact F n d nu mu' x' y -> mu' = mu /\ forall i, (i < Family.N F)%nat -> x' tt i = x tt i;
  turn_law : forall eps, 0 < eps -> exists r, 0 < r /\ forall nu mu x y mu' x' y', Rabs nu < r -> y < r -> y' < r ->
    one_impact F n d nu mu x y -> one_impact F n d nu mu' x' y' ->
    Rabs (mu - (nu * S * y + K * y ^ 2)) <= eps * ((Rabs nu + y) * y) /\
    Rabs (mu - mu' - (nu * S * (y - y') + K * (y ^ 2 - y' ^ 2))) <= eps * ((Rabs nu + y + y') * Rabs (y - y'));
  turn_where : K <> 0 -> forall eps, 0 < eps -> exists r, 0 < r /\ forall nu mu x y mu' x' y', Rabs nu < r -> y < r ->
    one_impact F n d nu mu x y -> one_impact F n d nu mu' x' y' -> y' < y -> let s := - (nu * S) / (2 * K) in
    (y <= s - eps * Rabs nu -> K * mu < K * mu') /\ (s + eps * Rabs nu <= y' -> K * mu' < K * mu) }.
Definition Fold_statement : Prop := forall F w V T U rate n ph Qh p Q, smooth_family F -> let N := Family.N F in
  let M := member F 0 in (forall i, (i < N)%nat -> w i = mult N (Map.A M) w i + Map.phi M i) ->
  rate = dot N (Map.C M) w + Map.eta M -> rate <> 0 -> (1 <= n)%nat ->
  (forall x, (forall i, (i < N)%nat -> x i = power M n x i) -> forall i, (i < N)%nat -> x i = 0) ->
  (forall i, (i < N)%nat -> V i = power M n V i + Map.B M i /\ T i = power M n T i + p i /\ U i = power M n U i + Q i)
    ->
  mixed_order F w V rate n ph Qh p Q -> across M V n = 0 -> (forall k, (0 < k < n)%nat -> 0 < across M V k) ->
  exists d, 0 < d /\ turns F n (- (ph + across M T n) / rate) (- (1 + Qh + across M U n) / rate) d.
