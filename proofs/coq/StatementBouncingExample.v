(** * Statement: an oscillator whose grazing orbit has another impact in each period

    y'' = pi^2 cos t - 4 + mu above a stop that gives back the velocity, with no force but the driving one. For mu = 0
    it moves as pi^2 (1 - cos t) - 2 t^2 from t = - pi to pi, where it meets the stop at the velocity - 4 pi; it touches
    the stop at t = 0. *)
From Coq Require Import Reals ZArith.
From Grazing Require Import StatementBouncing.
Open Scope R_scope.

Definition bouncing_example : Bouncing.t := {|
  Bouncing.T := 2 * PI; Bouncing.a := fun c t y v mu => PI * PI * cos t - 4 + mu;
  Bouncing.a_t := fun c t y v mu => - (PI * PI * sin t); Bouncing.a_y := fun c t y v mu => 0;
  Bouncing.a_v := fun c t y v mu => 0; Bouncing.a_mu := fun c t y v mu => 1; Bouncing.impact := fun c => true;
  Bouncing.rebound := fun c mu t v => - v; Bouncing.rebound_t := fun c mu t v => 0;
  Bouncing.rebound_v := fun c mu t v => -1; Bouncing.rebound_mu := fun c mu t v => 0;
  Bouncing.face := fun c => 1; Bouncing.place := fun c mu => 0; Bouncing.place_mu := fun c mu => 0;
  Bouncing.speed := fun c mu => 0; Bouncing.speed_mu := fun c mu => 0; Bouncing.tau := 1;
  Bouncing.k := 1; Bouncing.s := fun c => 2 * PI * IZR c - PI;
  Bouncing.y0 := fun c t => PI * PI * (1 - cos t) - 2 * ((t - 2 * PI * IZR c) * (t - 2 * PI * IZR c));
  Bouncing.v0 := fun c t => PI * PI * sin t - 4 * (t - 2 * PI * IZR c); Bouncing.tG := 0 |}.

(** It is in region 1, with the determinant 1 of an impact without loss. *)
Definition Bouncing_example_statement : Prop := bouncing_orbit bouncing_example /\
  generic_round bouncing_example (PI * PI + 2) 1 (PI * PI * PI / 2) (- (PI * PI / 2)).
