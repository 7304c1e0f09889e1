(** * Definitions: a nonlinear oscillator near a periodic orbit that grazes, sections 3 and 3.1 of the paper

    Definitions for [Headline], where Theorem 1 is stated. Place y and velocity v are measured from the stop,
    which may move, and change with mu: y' = v, v' = a (t, y, v, mu) while y > 0. For the paper's (37), (38)
    and the lower stop Q1, q = y + Q1 and u = v + Q1', and this a is the paper's a (q, u, t) - Q1'':
    [StatementStops] says so, and the same of the upper stop. All of it has period T in t. Complete on this
    page. *)
From Coq Require Import Reals ZArith.
Open Scope R_scope.

(** a_t, a_y, a_v, a_mu are the partial derivatives of a. The law of impact gives the velocity rebound mu t v
    after an impact from the velocity v < 0 before it. For mu = 0 the orbit y0, v0 touches at the time tG. *)
Module Nonlinear. Record t : Type := { T : R; a : R -> R -> R -> R -> R;
  a_t : R -> R -> R -> R -> R; a_y : R -> R -> R -> R -> R; a_v : R -> R -> R -> R -> R;
  a_mu : R -> R -> R -> R -> R; rebound : R -> R -> R -> R; tau : R; y0 : R -> R; v0 : R -> R; tG : R }.
End Nonlinear.
Import Nonlinear.

(** Where D holds, f (t, y, v, mu) has the partial derivatives f1 to f4, and these are continuous: f is C1. *)
Definition continuous (D : R -> R -> R -> R -> Prop) (f : R -> R -> R -> R -> R) : Prop :=
  forall t y v mu, D t y v mu -> forall eps, 0 < eps -> exists d, 0 < d /\ forall t' y' v' mu',
  Rabs (t' - t) <= d -> Rabs (y' - y) <= d -> Rabs (v' - v) <= d -> Rabs (mu' - mu) <= d ->
  Rabs (f t' y' v' mu' - f t y v mu) <= eps.
Record C1 (D : R -> R -> R -> R -> Prop) (f f1 f2 f3 f4 : R -> R -> R -> R -> R) : Prop := {
  in_t : forall t y v mu, D t y v mu -> derivable_pt_lim (fun x => f x y v mu) t (f1 t y v mu);
  in_y : forall t y v mu, D t y v mu -> derivable_pt_lim (fun x => f t x v mu) y (f2 t y v mu);
  in_v : forall t y v mu, D t y v mu -> derivable_pt_lim (fun x => f t y x mu) v (f3 t y v mu);
  in_mu : forall t y v mu, D t y v mu -> derivable_pt_lim (fun x => f t y v x) mu (f4 t y v mu);
  in_all : continuous D f1 /\ continuous D f2 /\ continuous D f3 /\ continuous D f4 }.

Definition moves (O : Nonlinear.t) (mu : R) (y v : R -> R) (t : R) : Prop :=
  derivable_pt_lim y t (v t) /\ derivable_pt_lim v t (a O t (y t) (v t) mu).
Definition tube (O : Nonlinear.t) (d t y v : R) : Prop := Rabs (y - y0 O t) <= d /\ Rabs (v - v0 O t) <= d.

(** A periodic orbit that touches the stop once each period, at a relative acceleration aG > 0, and meets it
    nowhere else; its phase is such that 0 < tG < T. Near it a is C1, and so is the law of impact near the
    touch: it keeps a velocity of zero, and its derivative in v is - tau. *)
Record grazing_orbit (O : Nonlinear.t) : Prop := {
  has_period : 0 < T O /\ forall t, y0 O (t + T O) = y0 O t /\ v0 O (t + T O) = v0 O t /\ forall y v mu,
    a O (t + T O) y v mu = a O t y v mu /\ rebound O mu (t + T O) v = rebound O mu t v;
  orbit_moves : forall t, moves O 0 (y0 O) (v0 O) t;
  touches : 0 < tG O < T O /\ y0 O (tG O) = 0;
  open_elsewhere : forall t, 0 <= t <= T O -> t <> tG O -> 0 < y0 O t;
  aG : 0 < a O (tG O) 0 0 0;
  force_C1 : exists r, 0 < r /\
    C1 (fun t y v mu => tube O r t y v /\ Rabs mu <= r) (a O) (a_t O) (a_y O) (a_v O) (a_mu O);
  law : 0 <= tau O /\ (forall mu t, rebound O mu t 0 = 0) /\ forall mu t v, v < 0 -> 0 <= rebound O mu t v;
  law_C1 : exists r f1 f2 f3 f4, 0 < r /\ f3 (tG O) 0 0 0 = - tau O /\
    C1 (fun t y v mu => Rabs (t - tG O) <= r /\ Rabs v <= r /\ Rabs mu <= r)
      (fun t y v mu => rebound O mu t v) f1 f2 f3 f4 }.

(** The equation linearized along the orbit, for a change m of mu. Over one period from the touch its
    solutions have the matrix (44), of trace a1 and determinant a2, gamma <> 0; and rate is the paper's e,
    (26): the value at tG of its periodic solution for m = 1. *)
Definition along (O : Nonlinear.t) (f : R -> R -> R -> R -> R) (t : R) : R := f t (y0 O t) (v0 O t) 0.
Definition linearized (O : Nonlinear.t) (m : R) (z w : R -> R) : Prop := forall t,
  derivable_pt_lim z t (w t) /\
  derivable_pt_lim w t (along O (a_y O) t * z t + along O (a_v O) t * w t + along O (a_mu O) t * m).
Record generic (O : Nonlinear.t) (a1 a2 gamma rate : R) : Prop := {
  has_matrix : exists alpha beta delta, a1 = alpha + delta /\ a2 = alpha * delta - beta * gamma /\
    forall z w, linearized O 0 z w -> z (tG O + T O) = alpha * z (tG O) + gamma * w (tG O) /\
    w (tG O + T O) = beta * z (tG O) + delta * w (tG O);
  gamma_not_0 : gamma <> 0;
  has_rate : exists z w, linearized O 1 z w /\ (forall t, z (t + T O) = z t /\ w (t + T O) = w t) /\
    rate = z (tG O);
  rate_not_0 : rate <> 0 }.

(** Between impact i, at the time t i, and the next, j, the oscillator moves as y i, v i, within d of the
    orbit. Impact i is within d of the touch in period N i. Between impacts there is no contact. *)
Record leg (O : Nonlinear.t) (mu d : R) (N : Z -> Z) (t : Z -> R) (y v : Z -> R -> R) (i j : Z) : Prop := {
  leg_on : t i < t j;
  leg_near : Rabs (t i - (tG O + T O * IZR (N i))) <= d;
  leg_moves : forall x, t i <= x <= t j -> moves O mu (y i) (v i) x;
  leg_tube : forall x, t i <= x <= t j -> tube O d x (y i x) (v i x);
  leg_from : y i (t i) = 0;
  leg_to : y i (t j) = 0;
  leg_open : forall x, t i < x < t j -> 0 < y i x;
  leg_hits : v i (t j) < 0;
  leg_back : v j (t j) = rebound O mu (t j) (v i (t j)) }.
Definition nonlinear_motion (O : Nonlinear.t) (mu d : R) (N : Z -> Z) (t : Z -> R)
  (y v : Z -> R -> R) : Prop := forall i j, j = (i + 1)%Z -> leg O mu d N t y v i j.
Definition one_nonlinear_motion (O : Nonlinear.t) (mu d : R) (N : Z -> Z) : Prop := exists t y v,
  nonlinear_motion O mu d N t y v /\ forall t' y' v', nonlinear_motion O mu d N t' y' v' ->
  forall i, t' i = t i /\ forall x, t i <= x <= t (i + 1)%Z -> y' i x = y i x /\ v' i x = v i x.
