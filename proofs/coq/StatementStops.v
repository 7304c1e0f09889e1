(** * Statement: an oscillator between two stops, in the paper's coordinates (37), (38), that grazes either stop

    q' = u and u' = a (t, q, u, mu) while Q1 < q < Q2; at each mu this a is the paper's a (q, u, t). [measured]
    counts place and velocity from the stop that is touched, upwards from the lower and downwards from the upper
    one: that is an oscillator of [StatementNonlinear], its motions are those between the stops, and where they are
    unstable, so are these. So whatever [Headline] says of [Moves (measured P s) rate] is about them. *)
From Coq Require Import Reals ZArith.
From Grazing Require Import Defs StatementNonlinear StatementUnstable.
Open Scope R_scope.

(** Stop s, Plus the lower and Minus the upper, is at Q s 0 t mu; Q s k is its k-th derivative in t, and Q_mu s k
    the derivative of that in mu. U s mu t u is the velocity after an impact, tau the restitution at the touch. *)
Module Stops. Record t : Type := { T : R; a : R -> R -> R -> R -> R;
  a_t : R -> R -> R -> R -> R; a_q : R -> R -> R -> R -> R; a_u : R -> R -> R -> R -> R;
  a_mu : R -> R -> R -> R -> R; Q : sign -> nat -> R -> R -> R; Q_mu : sign -> nat -> R -> R -> R;
  U : sign -> R -> R -> R -> R; tau : R; q0 : R -> R; u0 : R -> R; tG : R }.
End Stops.
Import Stops.

(** Place and velocity as seen from stop s. *)
Definition off (P : Stops.t) (s : sign) (mu t q : R) : R := sgn s * (q - Q P s 0 t mu).
Definition rel (P : Stops.t) (s : sign) (mu t u : R) : R := sgn s * (u - Q P s 1 t mu).

(** q0, u0 is a motion at mu = 0 that touches stop s once each period, at the time tG with a_G > 0, and meets no
    stop otherwise. The force is C1 near it, the stops are C3 near mu = 0, and the law is C1 near the touch. *)
Record grazing_at (P : Stops.t) (s : sign) : Prop := {
  all_periodic : 0 < T P /\ forall t, q0 P (t + T P) = q0 P t /\ u0 P (t + T P) = u0 P t /\
    forall z k q u mu, a P (t + T P) q u mu = a P t q u mu /\ Q P z k (t + T P) mu = Q P z k t mu /\
    U P z mu (t + T P) u = U P z mu t u;
  orbit_runs : forall t, derivable_pt_lim (q0 P) t (u0 P t) /\
    derivable_pt_lim (u0 P) t (a P t (q0 P t) (u0 P t) 0);
  at_tG : 0 < tG P < T P /\ q0 P (tG P) = Q P s 0 (tG P) 0 /\ u0 P (tG P) = Q P s 1 (tG P) 0;
  else_between : forall t z, 0 <= t <= T P -> ~ (t = tG P /\ z = s) -> 0 < off P z 0 t (q0 P t);
  a_G : 0 < sgn s * (a P (tG P) (q0 P (tG P)) (u0 P (tG P)) 0 - Q P s 2 (tG P) 0);
  C1_force : exists r, 0 < r /\
    C1 (fun t q u mu => Rabs (q - q0 P t) <= r /\ Rabs (u - u0 P t) <= r /\ Rabs mu <= r)
      (a P) (a_t P) (a_q P) (a_u P) (a_mu P);
  C3_stops : exists r, 0 < r /\ forall z k, (k <= 2)%nat -> C1 (fun _ _ _ mu => Rabs mu <= r)
    (fun t _ _ mu => Q P z k t mu) (fun t _ _ mu => Q P z (S k) t mu) (fun _ _ _ _ => 0) (fun _ _ _ _ => 0)
    (fun t _ _ mu => Q_mu P z k t mu);
  law_at : 0 <= tau P /\ (forall mu t, U P s mu t (Q P s 1 t mu) = Q P s 1 t mu) /\
    forall mu t u, rel P s mu t u < 0 -> 0 <= rel P s mu t (U P s mu t u);
  C1_law : exists r f1 f2 f3 f4, 0 < r /\ f3 (tG P) (q0 P (tG P)) (u0 P (tG P)) 0 = - tau P /\
    C1 (fun t _ u mu => Rabs (t - tG P) <= r /\ Rabs (u - u0 P (tG P)) <= r /\ Rabs mu <= r)
      (fun t _ u mu => U P s mu t u) f1 f2 f3 f4 }.

Definition measured (P : Stops.t) (s : sign) : Nonlinear.t :=
  let seen f t y v mu := f t (Q P s 0 t mu + sgn s * y) (Q P s 1 t mu + sgn s * v) mu in {|
  Nonlinear.T := T P;
  Nonlinear.a := fun t y v mu => sgn s * (seen (a P) t y v mu - Q P s 2 t mu);
  Nonlinear.a_t := fun t y v mu => sgn s * (seen (a_t P) t y v mu + seen (a_q P) t y v mu * Q P s 1 t mu +
    seen (a_u P) t y v mu * Q P s 2 t mu - Q P s 3 t mu);
  Nonlinear.a_y := seen (a_q P);
  Nonlinear.a_v := seen (a_u P);
  Nonlinear.a_mu := fun t y v mu => sgn s * (seen (a_mu P) t y v mu + seen (a_q P) t y v mu * Q_mu P s 0 t mu +
    seen (a_u P) t y v mu * Q_mu P s 1 t mu - Q_mu P s 2 t mu);
  Nonlinear.rebound := fun mu t v => rel P s mu t (U P s mu t (Q P s 1 t mu + sgn s * v));
  Nonlinear.tau := tau P; Nonlinear.y0 := fun t => off P s 0 t (q0 P t);
  Nonlinear.v0 := fun t => rel P s 0 t (u0 P t); Nonlinear.tG := tG P |}.

(** Between impact i, at the time t i, and the next, j, both on stop s, the oscillator moves as q i, u i between the
    stops, and as seen from stop s within d of the orbit. Impact i is within d of the touch in period N i. *)
Record flight (P : Stops.t) (s : sign) (mu d : R) (N : Z -> Z) (t : Z -> R) (q u : Z -> R -> R) (i j : Z) :
  Prop := {
  flight_on : t i < t j;
  flight_near : Rabs (t i - (tG P + T P * IZR (N i))) <= d;
  flight_moves : forall x, t i <= x <= t j ->
    derivable_pt_lim (q i) x (u i x) /\ derivable_pt_lim (u i) x (a P x (q i x) (u i x) mu);
  flight_tube : forall x, t i <= x <= t j -> Rabs (off P s mu x (q i x) - off P s 0 x (q0 P x)) <= d /\
    Rabs (rel P s mu x (u i x) - rel P s 0 x (u0 P x)) <= d;
  flight_from : q i (t i) = Q P s 0 (t i) mu;
  flight_to : q i (t j) = Q P s 0 (t j) mu;
  flight_between : forall x, t i < x < t j -> Q P Plus 0 x mu < q i x < Q P Minus 0 x mu;
  flight_hits : rel P s mu (t j) (u i (t j)) < 0;
  flight_back : u j (t j) = U P s mu (t j) (u i (t j)) }.
Definition motion_between (P : Stops.t) (s : sign) (mu d : R) (N : Z -> Z) (t : Z -> R)
  (q u : Z -> R -> R) : Prop := forall i j, j = (i + 1)%Z -> flight P s mu d N t q u i j.
Definition one_between (P : Stops.t) (s : sign) (mu d : R) (N : Z -> Z) : Prop := exists t q u,
  motion_between P s mu d N t q u /\ forall t' q' u', motion_between P s mu d N t' q' u' ->
  forall i, t' i = t i /\ forall x, t i <= x <= t (i + 1)%Z -> q' i x = q i x /\ u' i x = u i x.

Definition Stops_statement : Prop := forall P s, grazing_at P s -> grazing_orbit (measured P s) /\
  exists r, 0 < r /\ forall mu d N, Rabs mu <= r -> d <= r ->
  (one_between P s mu d N <-> one_nonlinear_motion (measured P s) mu d N) /\
  ((exists t q u, motion_between P s mu d N t q u) <->
   exists t y v, nonlinear_motion (measured P s) mu d N t y v) /\
  ((forall t y v, nonlinear_motion (measured P s) mu d N t y v ->
    unstable_motion (leg (measured P s) mu d N) t v) ->
   forall t q u, motion_between P s mu d N t q u -> unstable_motion (flight P s mu d N) t u).
