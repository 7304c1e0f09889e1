(** * Statement: nonlinear oscillators that graze a stop of any shape: Duffing's, a pendulum, all of region 3

    q'' = - c q' - k q - b q^3 - h sin q - e (q - A M)^2 + p + mu between stops at A W, where p is such that A M is
    a motion at mu = 0; A is its amplitude. A velocity v after the stop, v < 0 towards it, becomes
    - tau v exp (x v): the restitution tau exp (- x |v|) depends on the speed. Duffing's oscillator has h = e = 0,
    a pendulum k = b = e = 0, a linear oscillator b = h = e = x = 0. *)
From Coq Require Import Reals.
From Grazing Require Import Defs StatementOscillator StatementNonlinear StatementStops Headline.
Open Scope R_scope.

(** M 0, the motion, and W z 0, stop z, of period 2 pi; M n and W z n are their n-th derivatives. At t0, and then
    alone, they touch, at stop s. *)
Record shapes (M : nat -> R -> R) (W : sign -> nat -> R -> R) (t0 : R) (s : sign) : Prop := {
  shape_slope : forall n t, (n <= 2)%nat ->
    derivable_pt_lim (M n) t (M (S n) t) /\ forall z, derivable_pt_lim (W z n) t (W z (S n) t);
  shape_C3 : forall t, continuity_pt (M 3%nat) t /\ forall z, continuity_pt (W z 3%nat) t;
  shape_period : forall n t, M n (t + 2 * PI) = M n t /\ forall z, W z n (t + 2 * PI) = W z n t;
  shape_touch : 0 < t0 < 2 * PI /\ M 0%nat t0 = W s 0%nat t0 /\ M 1%nat t0 = W s 1%nat t0;
  shape_open : forall t z, 0 <= t <= 2 * PI -> ~ (t = t0 /\ z = s) -> 0 < sgn z * (M 0%nat t - W z 0%nat t);
  shape_bend : 0 < sgn s * (M 2%nat t0 - W s 2%nat t0) }.

Definition driven (M : nat -> R -> R) (W : sign -> nat -> R -> R) (t0 A c k b h e x tau : R) : Stops.t :=
  let m n t := A * M n t in let w z n t := A * W z n t in {|
  Stops.T := 2 * PI;
  Stops.a := fun t q u mu => - c * u - k * q - b * (q * q * q) - h * sin q -
    e * ((q - m 0%nat t) * (q - m 0%nat t)) + (m 2%nat t + c * m 1%nat t + k * m 0%nat t +
    b * (m 0%nat t * m 0%nat t * m 0%nat t) + h * sin (m 0%nat t)) + mu;
  Stops.a_t := fun t q u mu => 2 * e * ((q - m 0%nat t) * m 1%nat t) + (m 3%nat t + c * m 2%nat t + k * m 1%nat t +
    3 * b * (m 0%nat t * m 0%nat t * m 1%nat t) + h * (cos (m 0%nat t) * m 1%nat t));
  Stops.a_q := fun t q u mu => - k - 3 * b * (q * q) - h * cos q - 2 * e * (q - m 0%nat t);
  Stops.a_u := fun t q u mu => - c; Stops.a_mu := fun t q u mu => 1;
  Stops.Q := fun z n t mu => w z n t; Stops.Q_mu := fun z n t mu => 0;
  Stops.U := fun z mu t u => w z 1%nat t - tau * ((u - w z 1%nat t) * exp (x * (sgn z * (u - w z 1%nat t))));
  Stops.tau := tau; Stops.q0 := m 0%nat; Stops.u0 := m 1%nat; Stops.tG := t0 |}.

(** All of them graze. Where b = h = 0 the linearized equation is that of a linear oscillator, and for every (a1, a2)
    of region 3 and both signs of gamma there is one. And whatever b and h are, driven gently enough it is as near
    as one likes to that of the linear oscillator of stiffness k + h, and has each period n that this one has. *)
Record driven_facts (M : nat -> R -> R) (W : sign -> nat -> R -> R) (t0 : R) (s : sign) : Prop := {
  all_graze : forall A c k b h e x tau, 0 < A -> 0 <= tau -> grazing_at (driven M W t0 A c k b h e x tau) s;
  as_linear : forall A c k e x tau a1 a2 gamma, matrix c k Plus a1 a2 gamma -> gamma <> 0 -> k <> 0 ->
    generic (measured (driven M W t0 A c k 0 0 e x tau) s) a1 a2 gamma (sgn s / k);
  all_region_3 : forall A e x tau r y g, 0 < r -> 0 < y < 1 / 2 -> exists c k gamma, sgn g * gamma > 0 /\
    generic (measured (driven M W t0 A c k 0 0 e x tau) s) (2 * r * cos (2 * PI * y)) (r ^ 2) gamma (sgn s / k);
  gentle_periods : forall c k b h e x tau a1 a2 gamma n i g, 0 <= tau -> matrix c (k + h) Plus a1 a2 gamma ->
    k + h <> 0 -> a1 <> a2 + 1 -> (1 <= n)%nat -> orbit a1 a2 n i g -> sgn g * gamma > 0 -> exists A0, 0 < A0 /\
    forall A, 0 < A <= A0 -> exists rate, rate * (sgn s * (k + h)) > 0 /\
    born (Moves (measured (driven M W t0 A c k b h e x tau) s) rate) n i;
  driven_gently : forall c k b h e x tau a1 a2 gamma eps, 0 <= tau -> matrix c (k + h) Plus a1 a2 gamma ->
    gamma <> 0 -> k + h <> 0 -> a1 <> a2 + 1 -> 0 < eps -> exists A0, 0 < A0 /\ forall A, 0 < A <= A0 ->
    exists a1' a2' gamma' rate, generic (measured (driven M W t0 A c k b h e x tau) s) a1' a2' gamma' rate /\
    Rabs (a1' - a1) <= eps /\ Rabs (a2' - a2) <= eps /\ Rabs (gamma' - gamma) <= eps /\
    Rabs (rate - sgn s / (k + h)) <= eps }.
Definition Driven_statement : Prop := forall M W t0 s, shapes M W t0 s -> driven_facts M W t0 s.

(** With numbers: q'' = - q / 16 - q^3 + p + mu, of an orbit of any shape of size 1 and any amplitude A up to 1/60, has
    period 3, in the case (+, +). *)
Definition Duffing_statement : Prop := forall M W t0 s A tau, shapes M W t0 s -> (forall t, Rabs (M 0%nat t) <= 1) ->
  0 < A <= 1 / 60 -> 0 <= tau -> let O := measured (driven M W t0 A 0 (1 / 16) 1 0 0 0 tau) s in
  exists a1 a2 gamma rate, generic O a1 a2 gamma rate /\ Rabs a1 <= 11 / 100 /\ Rabs (a2 - 1) <= 12 / 100 /\
  Rabs (gamma - 4) <= 22 / 100 /\ 12 <= sgn s * rate <= 21 /\ born (Moves O rate) 3 Plus.
