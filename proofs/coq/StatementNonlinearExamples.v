(** * Statement: nonlinear oscillators with a grazing orbit, for every (a1, a2) of region 3

    y'' = - c y' - k y - b y^3 - h sin y - e (y - Y)^2 + p + mu above a stop at 0, where p is such that
    Y = 1 + cos t is a motion at mu = 0; it touches at pi. The velocity after an impact is - tau v exp (s v):
    the restitution tau exp (- s |v|) depends on the speed. Duffing's oscillator has h = e = 0, a pendulum
    k = b = e = 0, a linear oscillator b = h = e = s = 0. *)
From Coq Require Import Reals.
From Grazing Require Import Defs StatementOscillator StatementNonlinear.
Open Scope R_scope.

Definition Y (t : R) : R := 1 + cos t.
Definition forced (c k b h e s tau : R) : Nonlinear.t := {|
  Nonlinear.T := 2 * PI;
  Nonlinear.a := fun t y v mu => - c * v - k * y - b * (y * y * y) - h * sin y - e * ((y - Y t) * (y - Y t)) +
    (k * Y t + b * (Y t * Y t * Y t) + h * sin (Y t) - cos t - c * sin t) + mu;
  Nonlinear.a_t := fun t y v mu => - 2 * e * ((y - Y t) * sin t) +
    (sin t - k * sin t - 3 * b * (Y t * Y t * sin t) - h * (cos (Y t) * sin t) - c * cos t);
  Nonlinear.a_y := fun t y v mu => - k - 3 * b * (y * y) - h * cos y - 2 * e * (y - Y t);
  Nonlinear.a_v := fun t y v mu => - c;
  Nonlinear.a_mu := fun t y v mu => 1;
  Nonlinear.rebound := fun mu t v => - tau * (v * exp (s * v)); Nonlinear.tau := tau;
  Nonlinear.y0 := Y; Nonlinear.v0 := fun t => - sin t; Nonlinear.tG := PI |}.

(** The orbit grazes; and where b = h = 0 the linearized equation is that of a linear oscillator. So Theorem 1
    is about such oscillators for every (a1, a2) of region 3, both signs of gamma, and every e and s. *)
Definition Forced_statement : Prop := forall e s tau, 0 <= tau ->
  (forall c k b h, grazing_orbit (forced c k b h e s tau)) /\
  (forall c k a1 a2 gamma, matrix c k Plus a1 a2 gamma -> gamma <> 0 -> k <> 0 ->
    generic (forced c k 0 0 e s tau) a1 a2 gamma (1 / k)) /\
  forall r x g, 0 < r -> 0 < x < 1 / 2 -> exists c k gamma,
    generic (forced c k 0 0 e s tau) (2 * r * cos (2 * PI * x)) (r ^ 2) gamma (1 / k) /\ sgn g * gamma > 0.
