(** * Statement: just beyond the touch the grazing map with eigenvalues 0 < l2 < l1 < 1, l1 > 2/3, is chaotic

    That is region 2 with gamma > 0 and e mu = - nu < 0, where Theorem 1 gives one orbit of each period for
    every small nu > 0. Here all orbits of a wedge are meant: they come to a small set, and none that is
    periodic is stable. For 1/4 < l1 <= 2/3 the same holds in gaps, between windows with a stable orbit. *)
From Coq Require Import Reals.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane StatementPlane.
Open Scope R_scope.

(** ** The plane, and derivatives there *)
Definition norm (x : R * R) : R := Rmax (Rabs (fst x)) (Rabs (snd x)).
Definition sub (x y : R * R) : R * R := (fst x - fst y, snd x - snd y).
Definition scale (e : R) (x : R * R) : R * R := (e * fst x, e * snd x).
Definition derivative (F : R * R -> R * R) (x : R * R) (J : mat) : Prop := forall eps, 0 < eps ->
  exists d, 0 < d /\ forall z, norm (sub z x) <= d ->
  norm (sub (sub (F z) (F x)) (apply J (sub z x))) <= eps * norm (sub z x).

(** ** The map (3), (4) in eigen-coordinates: A = diag (l1, l2), C = (1 -1), B = b (1 1), h (x) = C x - nu

    C B = 0 and C A B = b (l1 - l2) > 0. [height] is h after the linear part of the next step. *)
Section Map.
Variables (l1 l2 b nu : R).
Definition height (x : R * R) : R := l1 * fst x - l2 * snd x - nu.
Definition step (x : R * R) : R * R := let y := sqrt (- height x) in
  if Rle_dec 0 (height x) then (l1 * fst x, l2 * snd x) else (l1 * fst x + b * y, l2 * snd x + b * y).
Definition iterate (k : nat) (x : R * R) : R * R := Nat.iter k step x.
Definition never_grazes (x : R * R) : Prop := forall k, height (iterate k x) <> 0.

(** The wedge between the directions (1, 0) and (1, 1). In it the trap: states just before an impact, its
    depth at most (1 - l1 (1 - eps)) nu, where eps is as small as nu. *)
Definition wedge (x : R * R) : Prop := 0 <= snd x <= fst x.
Definition trap (x : R * R) : Prop := wedge x /\ snd x <= nu / (l1 - l2) /\
  l1 * (1 - nu / ((l1 - l2) * b) ^ 2) * nu <= height x + nu <= nu.

(** The wedge is left by none and leads to the trap; from there the next impact comes after N steps at most,
    and before it one is in the trap again. *)
Record trapping (N : nat) : Prop := {
  wedge_kept : forall x, wedge x -> wedge (step x);
  wedge_leads : forall x, wedge x -> exists n, trap (iterate n x);
  trap_returns : forall x, trap x -> exists n, (1 <= n <= N)%nat /\ trap (iterate n x) /\
    height (iterate n x) < 0 /\ forall k, (1 <= k < n)%nat -> 0 <= height (iterate k x) }.

(** Tangent vectors: what they change the height by, and a cone about that direction. From impact to impact
    the vectors of the cone grow by E. *)
Definition change (v : R * R) : R := l1 * fst v - l2 * snd v.
Definition cone (v : R * R) : Prop := Rabs (l2 * snd v) <= 2 * l2 / (l1 - l2) * Rabs (change v).
Definition expanding (E : R) : Prop := forall x n, trap x -> never_grazes x -> (1 <= n)%nat ->
  height (iterate n x) < 0 -> (forall k, (1 <= k < n)%nat -> 0 < height (iterate k x)) ->
  exists J, derivative (iterate n) x J /\
  forall v, cone v -> cone (apply J v) /\ Rabs (change (apply J v)) >= E * Rabs (change v).

(** So some vector grows by E every N steps, along every orbit. *)
Definition exponent (E : R) (N : nat) : Prop := forall x, wedge x -> never_grazes x ->
  exists v K, K > 0 /\ forall k, exists J, derivative (iterate k) x J /\
  forall i, (N * i <= k)%nat -> norm (apply J v) >= K * E ^ i.

(** And no periodic orbit is stable: the derivative over a period has an eigenvalue beyond E; and some point
    as near as one likes goes away to the distance r. *)
Record periodic (x : R * R) (m : nat) : Prop := {
  in_wedge : wedge x;
  grazes_never : never_grazes x;
  has_period : (1 <= m)%nat;
  comes_again : iterate m x = x }.
Definition large_eigenvalues (E : R) : Prop := forall x m, periodic x m -> exists J v e,
  derivative (iterate m) x J /\ v <> (0, 0) /\ apply J v = scale e v /\ Rabs e >= E.
Definition unstable_orbits : Prop := forall x m, periodic x m -> exists r, r > 0 /\
  forall eps, eps > 0 -> exists z i, norm (sub z x) < eps /\ norm (sub (iterate (i * m) z) x) > r.

Record chaotic (E : R) (N : nat) : Prop := {
  is_trapping : trapping N;
  has_exponent : exponent E N;
  has_eigenvalues : large_eigenvalues E;
  is_unstable : unstable_orbits }.

(** A periodic orbit with both eigenvalues inside the unit circle. *)
Record stable_orbit (n : nat) (x : R * R) (J : mat) : Prop := {
  is_periodic : periodic x n;
  is_derivative : derivative (iterate n) x J;
  trace_inside : Rabs (m11 J + m22 J) < 1 + (m11 J * m22 J - m12 J * m21 J);
  det_inside : Rabs (m11 J * m22 J - m12 J * m21 J) < 1 }.
End Map.

(** ** The theorem: l1 / (2 (1 - l1)) > 1 as l1 > 2/3 *)
Definition Wedge_statement : Prop := forall l1 l2 b E, 2 / 3 < l1 < 1 -> 0 < l2 < l1 -> 0 < b ->
  1 < E < l1 / (2 * (1 - l1)) -> exists nu0, nu0 > 0 /\ forall nu, 0 < nu <= nu0 -> exists N, (1 <= N)%nat /\
  chaotic l1 l2 b nu E N /\ expanding l1 l2 b nu E.

(** And for every l1 > 1/4 (else there is no g1), for nu / (b l1^n)^2 between g1 and g2 and every n from some
    n0 on: what is left are the windows 3/4 < nu / (b l1^n)^2 < (1 - l1) / l1^2; for l1 > 2/3 there are none.
    *)
Definition Gaps_statement : Prop := forall l1 l2 b g1 g2, 0 < l2 < l1 -> l1 < 1 -> 0 < b ->
  1 - l1 < g1 -> g1 <= g2 < 3 / 4 -> exists E n0, E > 1 /\ forall n nu, (n0 <= n)%nat ->
  g1 * (b * l1 ^ n) ^ 2 <= nu <= g2 * (b * l1 ^ n) ^ 2 -> exists N, (1 <= N)%nat /\ chaotic l1 l2 b nu E N.

(** In the windows, for n from some n0 on: a stable orbit of period n with one impact. (Again, there is no g1
    unless l1 < 2/3.) *)
Definition Windows_statement : Prop := forall l1 l2 b g1 g2, 0 < l2 < l1 -> l1 < 1 -> 0 < b ->
  3 / 4 < g1 -> g1 <= g2 < (1 - l1) / l1 ^ 2 -> exists n0, forall n nu, (n0 <= n)%nat ->
  g1 * (b * l1 ^ n) ^ 2 <= nu <= g2 * (b * l1 ^ n) ^ 2 -> exists x J, stable_orbit l1 l2 b nu n x J.

(** There are orbits that never graze, for every nu: this one has an impact in every step. *)
Definition Fixed_statement : Prop := forall l1 l2 b nu, 0 < l2 < l1 -> l1 < 1 -> 0 < b -> 0 < nu ->
  exists x, periodic l1 l2 b nu x 1.

(** The map is one of the smooth grazing maps of Theorem 1, in region 2; its mu is - nu, and the paper's e is
    1. *)
Definition grazing_map (l1 l2 b : R) : Map.t := {|
  Map.N := 2; Map.f := fun x _ i => match i with O => l1 * x 0%nat | _ => l2 * x 1%nat end;
  Map.h := fun x mu => x 0%nat - x 1%nat + mu; Map.kick := fun _ _ _ _ => b;
  Map.A := fun i j => match i, j with O, O => l1 | S O, S O => l2 | _, _ => 0 end; Map.phi := fun _ => 0;
  Map.C := fun i => match i with O => 1 | _ => -1 end; Map.eta := 1; Map.B := fun _ => b |}.
Definition Same_map_statement : Prop := forall l1 l2 b, 0 < l2 < l1 -> l1 < 1 -> 0 < b ->
  planar (grazing_map l1 l2 b) (l1 + l2) (l1 * l2) (b * (l1 - l2)) 1 zero /\
  2 * sqrt (l1 * l2) <= l1 + l2 < l1 * l2 + 1 /\
  forall nu x, let y := StatementOrbits.step (grazing_map l1 l2 b) (- nu) x in
  step l1 l2 b nu (x 0%nat, x 1%nat) = (y 0%nat, y 1%nat).
