(** * Definitions: a nonlinear oscillator whose grazing orbit is told arc by arc, sections 2.1 and 3.1 of the paper

    Definitions for [Headline]; read [StatementNonlinear] first. In each period the orbit touches a stop once; its other
    impacts, at one stop or at two, have velocities that are not zero. It is cut into k >= 1 arcs a period, at these
    impacts and wherever else one likes; on arc c place y and velocity v are measured from a stop of its own, the same
    one period later, and y' = v, v' = a c (t, y, v, mu) while y > 0. Where the machine is its own mirror image after half
    a period, arcs of which the mirror images follow may be measured alike, and T is half a period: [StatementRattling]
    says so, and all this between two stops. Complete on this page, but for [C1] in [StatementNonlinear]. *)
From Coq Require Import Reals ZArith.
From Grazing Require Import StatementNonlinear.
Open Scope R_scope.

(** For mu = 0 the orbit is the arc y0 c, v0 c from the time s c to s (c + 1), c in Z. There, if [impact c], it hits
    arc c's stop: rebound c mu t v is the velocity after an impact from v < 0, and the three that follow are its partial
    derivatives. If not, y and v are now measured as place c mu + face c * y and speed c mu + face c * v; place_mu and
    speed_mu are derivatives in mu. Arc 0 touches its stop at tG, and so do the arcs whole periods later, and no others. *)
Module Bouncing. Record t : Type := { T : R; a : Z -> R -> R -> R -> R -> R;
  a_t : Z -> R -> R -> R -> R -> R; a_y : Z -> R -> R -> R -> R -> R; a_v : Z -> R -> R -> R -> R -> R;
  a_mu : Z -> R -> R -> R -> R -> R; impact : Z -> bool; rebound : Z -> R -> R -> R -> R;
  rebound_t : Z -> R -> R -> R -> R; rebound_v : Z -> R -> R -> R -> R; rebound_mu : Z -> R -> R -> R -> R;
  face : Z -> R; place : Z -> R -> R; place_mu : Z -> R -> R; speed : Z -> R -> R; speed_mu : Z -> R -> R;
  tau : R; k : nat; s : Z -> R; y0 : Z -> R -> R; v0 : Z -> R -> R; tG : R }.
End Bouncing.
Import Bouncing.

Definition runs (O : Bouncing.t) (c : Z) (mu : R) (y v : R -> R) (t : R) : Prop :=
  derivable_pt_lim y t (v t) /\ derivable_pt_lim v t (a O c t (y t) (v t) mu).
(** Near arc c, which goes on for a while on both sides of its ends as if there were no stop. *)
Definition beside (O : Bouncing.t) (r : R) (c : Z) (t y v : R) : Prop :=
  s O c - r <= t <= s O (c + 1) + r /\ Rabs (y - y0 O c t) <= r /\ Rabs (v - v0 O c t) <= r.
(** From y, v at the end of arc c, at the time t, to y', v' at the beginning of the next. *)
Definition follows (O : Bouncing.t) (c : Z) (mu t y v y' v' : R) : Prop := if impact O c
  then y' = 0 /\ v' = rebound O c mu t v else y' = place O c mu + face O c * y /\ v' = speed O c mu + face O c * v.

Record bouncing_orbit (O : Bouncing.t) : Prop := {
  its_period : 0 < T O /\ (1 <= k O)%nat /\ forall c t, let c' := (c + Z.of_nat (k O))%Z in s O c' = s O c + T O /\
    y0 O c' (t + T O) = y0 O c t /\ v0 O c' (t + T O) = v0 O c t /\ impact O c' = impact O c /\ face O c' = face O c /\
    forall y v mu, a O c' (t + T O) y v mu = a O c t y v mu /\ rebound O c' mu (t + T O) v = rebound O c mu t v /\
    place O c' mu = place O c mu /\ speed O c' mu = speed O c mu;
  its_arcs : forall c, let t := s O (c + 1)%Z in s O c < t /\
    follows O c 0 t (y0 O c t) (v0 O c t) (y0 O (c + 1)%Z t) (v0 O (c + 1)%Z t) /\
    if impact O c then y0 O c t = 0 /\ v0 O c t < 0 < v0 O (c + 1)%Z t else 0 < y0 O c t /\ 0 < y0 O (c + 1)%Z t;
  its_touch : s O 0%Z < tG O < s O 1%Z /\ y0 O 0%Z (tG O) = 0 /\ 0 < a O 0%Z (tG O) 0 0 0;
  its_opening : forall c t, s O c < t < s O (c + 1)%Z ->
    (forall N, ~ (c = (Z.of_nat (k O) * N)%Z /\ t = tG O + T O * IZR N)) -> 0 < y0 O c t;
  its_force : exists r, 0 < r /\
    (forall c t, s O c - r <= t <= s O (c + 1)%Z + r -> runs O c 0 (y0 O c) (v0 O c) t) /\
    forall c, C1 (fun t y v mu => beside O r c t y v /\ Rabs mu <= r) (a O c) (a_t O c) (a_y O c) (a_v O c) (a_mu O c);
  its_law : 0 <= tau O /\ (forall mu t, rebound O 0%Z mu t 0 = 0) /\
    forall mu t v, v < 0 -> 0 <= rebound O 0%Z mu t v;
  its_law_C1 : exists r f1 f2 f3 f4, 0 < r /\ f3 (tG O) 0 0 0 = - tau O /\
    C1 (fun t y v mu => Rabs (t - tG O) <= r /\ Rabs v <= r /\ Rabs mu <= r)
      (fun t y v mu => rebound O 0%Z mu t v) f1 f2 f3 f4;
  its_other_law_C1 : exists r, 0 < r /\ forall c, if impact O c
    then C1 (fun t y v mu => Rabs (t - s O (c + 1)%Z) <= r /\ Rabs (v - v0 O c (s O (c + 1)%Z)) <= r /\ Rabs mu <= r)
      (fun t y v mu => rebound O c mu t v) (fun t y v mu => rebound_t O c mu t v) (fun t y v mu => 0)
      (fun t y v mu => rebound_v O c mu t v) (fun t y v mu => rebound_mu O c mu t v)
    else let steady f f_mu := C1 (fun _ _ _ mu => Rabs mu <= r) (fun _ _ _ mu => f mu) (fun _ _ _ _ => 0)
      (fun _ _ _ _ => 0) (fun _ _ _ _ => 0) (fun _ _ _ mu => f_mu mu) in
      steady (place O c) (place_mu O c) /\ steady (speed O c) (speed_mu O c) }.

(** The equation linearized along arc c, and about its end at the time t: if mu changes by m, place and velocity on
    either side of it change by z, w and z', w'; and an impact is later by h. *)
Definition linear_along (O : Bouncing.t) (c : Z) (m : R) (z w : R -> R) : Prop :=
  forall t, s O c <= t <= s O (c + 1)%Z -> let along f := f c t (y0 O c t) (v0 O c t) 0 in
  derivable_pt_lim z t (w t) /\
  derivable_pt_lim w t (along (a_y O) * z t + along (a_v O) * w t + along (a_mu O) * m).
Definition linear_impact (O : Bouncing.t) (c : Z) (m z w z' w' : R) : Prop :=
  let t := s O (c + 1)%Z in let v := v0 O c t in let v' := v0 O (c + 1)%Z t in if impact O c
  then exists h, z + v * h = 0 /\ z' + v' * h = 0 /\ w' + a O (c + 1)%Z t 0 v' 0 * h =
    rebound_v O c 0 t v * (w + a O c t 0 v 0 * h) + rebound_t O c 0 t v * h + rebound_mu O c 0 t v * m
  else z' = place_mu O c 0 * m + face O c * z /\ w' = speed_mu O c 0 * m + face O c * w.
(** Over one period, from arc 0 to arc k. *)
Definition linear_round (O : Bouncing.t) (m : R) (z w : Z -> R -> R) : Prop :=
  (forall c, (0 <= c <= Z.of_nat (k O))%Z -> linear_along O c m (z c) (w c)) /\
  forall c, (0 <= c < Z.of_nat (k O))%Z -> let t := s O (c + 1)%Z in
    linear_impact O c m (z c t) (w c t) (z (c + 1)%Z t) (w (c + 1)%Z t).
(** From touch to touch its solutions have a matrix of trace a1 and determinant a2, gamma <> 0; and rate is the
    paper's e, (26): the value at tG of its periodic solution for m = 1. *)
Record generic_round (O : Bouncing.t) (a1 a2 gamma rate : R) : Prop := {
  its_matrix : exists alpha beta delta, a1 = alpha + delta /\ a2 = alpha * delta - beta * gamma /\
    forall z w, linear_round O 0 z w -> let z1 := z (Z.of_nat (k O)) in let w1 := w (Z.of_nat (k O)) in
    z1 (tG O + T O) = alpha * z 0%Z (tG O) + gamma * w 0%Z (tG O) /\
    w1 (tG O + T O) = beta * z 0%Z (tG O) + delta * w 0%Z (tG O);
  its_gamma : gamma <> 0;
  its_rate : exists z w, linear_round O 1 z w /\ z (Z.of_nat (k O)) (tG O + T O) = z 0%Z (tG O) /\
    w (Z.of_nat (k O)) (tG O + T O) = w 0%Z (tG O) /\ rate = z 0%Z (tG O);
  its_rate_not_0 : rate <> 0 }.

(** Between two impacts near the touch, i at the time t i in period N i and the next, j, the oscillator moves as y i,
    v i: past n ends of arcs, k in each period, and along the n + 1 arcs p m, q m from r m to r (m + 1), within d of the
    orbit's. It has an impact where the orbit has, and no others. At an impact v i is the velocity after it. *)
Definition others (O : Bouncing.t) (N : Z -> Z) (i j : Z) : nat := (k O * Z.to_nat (N j - N i))%nat.
Definition arc (O : Bouncing.t) (N : Z -> Z) (i : Z) (m : nat) : Z := (Z.of_nat (k O) * N i + Z.of_nat m)%Z.
Record journey (O : Bouncing.t) (mu d : R) (N : Z -> Z) (t : Z -> R) (y v : Z -> R -> R) (i j : Z)
  (r : nat -> R) (p q : nat -> R -> R) (n : nat) : Prop := {
  journey_from : r 0%nat = t i /\ p 0%nat (t i) = 0;
  journey_to : r (S n) = t j /\ p n (t j) = 0 /\ q n (t j) < 0;
  journey_near : forall l, l = i \/ l = j -> Rabs (t l - (tG O + T O * IZR (N l))) <= d;
  journey_others : forall m, (1 <= m <= n)%nat -> Rabs (r m - s O (arc O N i m)) <= d;
  journey_arcs : forall m, (m <= n)%nat -> r m < r (S m);
  journey_ends : forall m, (m < n)%nat -> if impact O (arc O N i m)
    then p m (r (S m)) = 0 /\ q m (r (S m)) < 0 else r (S m) = s O (arc O N i (S m));
  journey_moves : forall m x, (m <= n)%nat -> r m <= x <= r (S m) -> runs O (arc O N i m) mu (p m) (q m) x;
  journey_tube : forall m x, (m <= n)%nat -> r m <= x <= r (S m) ->
    Rabs (p m x - y0 O (arc O N i m) x) <= d /\ Rabs (q m x - v0 O (arc O N i m) x) <= d;
  journey_open : forall m x, (m <= n)%nat -> r m < x < r (S m) -> 0 < p m x;
  journey_back : forall m, (m < n)%nat -> let x := r (S m) in
    follows O (arc O N i m) mu x (p m x) (q m x) (p (S m) x) (q (S m) x);
  journey_is : forall m x, (m <= n)%nat -> r m <= x <= r (S m) -> (x = r (S m) -> m = n) ->
    y i x = p m x /\ v i x = q m x;
  journey_hits : v j (t j) = rebound O (arc O N j 0) mu (t j) (v i (t j)) }.
Definition bounces (O : Bouncing.t) (mu d : R) (N : Z -> Z) (t : Z -> R) (y v : Z -> R -> R) (i j : Z) : Prop :=
  exists r p q, journey O mu d N t y v i j r p q (others O N i j).
Definition bouncing_motion (O : Bouncing.t) (mu d : R) (N : Z -> Z) (t : Z -> R) (y v : Z -> R -> R) : Prop :=
  forall i j, j = (i + 1)%Z -> bounces O mu d N t y v i j.
Definition one_bouncing_motion (O : Bouncing.t) (mu d : R) (N : Z -> Z) : Prop := exists t y v,
  bouncing_motion O mu d N t y v /\ forall t' y' v', bouncing_motion O mu d N t' y' v' ->
  forall i, t' i = t i /\ forall x, t i <= x <= t (i + 1)%Z -> y' i x = y i x /\ v' i x = v i x.
