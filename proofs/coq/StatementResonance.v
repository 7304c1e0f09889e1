(** * Statement: at resonance, n theta = m pi, a linear oscillator's motions with one impact in n periods are
      known for every mu

    y'' = - c y' - k y above one stop that moves with period 2 pi, as in [StatementOscillator]: c >= 0, and
    theta = 2 pi omega is the angle of a period. After n periods every free motion is itself, times q: here
    u_n = 0, and Theorem 1 says nothing. Read [swing] in [StatementOscillator], [near] in [StatementUnstable], and
    [derivative] in [StatementAttractor], first. *)
From Coq Require Import Reals ZArith.
From Grazing Require Import Defs Statement StatementOrbits StatementOrbitsPlane StatementPlane.
From Grazing Require Import StatementAttractor StatementOscillator StatementUnstable.
Open Scope R_scope.

(** The stop may have any shape and change with mu as it likes. *)
Record any_stop (O : Oscillator.t) : Prop := {
  stop_period : forall mu t, Oscillator.G O mu (t + 2 * PI) = Oscillator.G O mu t;
  stop_slope : forall mu t, derivable_pt_lim (Oscillator.G O mu) t (Oscillator.G1 O mu t);
  stop_bend : forall mu t, derivable_pt_lim (Oscillator.G1 O mu) t (Oscillator.G2 O mu t) }.
Definition stop (O : Oscillator.t) (mu t : R) : R := - mu - Oscillator.G O mu t.
Definition stop1 (O : Oscillator.t) (mu t : R) : R := - Oscillator.G1 O mu t.

Definition omega (O : Oscillator.t) : R := sqrt (Oscillator.k O - Oscillator.c O ^ 2 / 4).
Record resonant (O : Oscillator.t) (n m : nat) : Prop := {
  res_periods : (1 <= n)%nat;
  res_oscillates : 0 <= Oscillator.c O /\ Oscillator.c O ^ 2 < 4 * Oscillator.k O;
  res_law : 0 <= Oscillator.tau O <= 1;
  res_angle : INR n * (2 * PI * omega O) = INR m * PI }.
Definition q (O : Oscillator.t) (n m : nat) : R := (-1) ^ m * exp (- PI * Oscillator.c O * INR n).
(** What fails where c = 0 alone: m even, or m odd and tau = 1. *)
Definition regular (O : Oscillator.t) (n m : nat) : Prop := q O n m <> 1 /\ Oscillator.tau O * q O n m <> -1.

(** A motion with one impact in n periods; the phase of its impacts is at most d. *)
Record once (O : Oscillator.t) (n : nat) (mu d : R) (t : Z -> R) (y v : Z -> R -> R) : Prop := {
  once_motion : motion O Plus mu d (fun i => Z.of_nat n * i)%Z t y v;
  once_again : forall i x, let P := 2 * PI * INR n * IZR i in
    t i = t 0%Z + P /\ y i (x + P) = y 0%Z x /\ v i (x + P) = v 0%Z x }.

(** ** The motions, for every mu and every stop

    The impact at t0 is where the stop rises through 0, its velocity is a multiple of the stop's, and the
    motion after it is an arc. So there is one at t0 if the arc is clear of the stop. *)
Definition after (O : Oscillator.t) (n m : nat) (mu t0 : R) : R :=
  (1 + Oscillator.tau O) / (1 + Oscillator.tau O * q O n m) * stop1 O mu t0.
Definition arc (O : Oscillator.t) (w s : R) : R :=
  w * (exp (- Oscillator.c O / 2 * s) * sin (omega O * s) / omega O).
Record exact (O : Oscillator.t) (n m : nat) (mu d : R) : Prop := {
  exact_iff : regular O n m -> forall t0, (exists t y v, once O n mu d t y v /\ t 0%Z = t0) <->
    Rabs t0 <= d /\ stop O mu t0 = 0 /\ 0 < stop1 O mu t0 /\
    forall s, 0 < s < 2 * PI * INR n -> stop O mu (t0 + s) < arc O (after O n m mu t0) s;
  exact_arc : regular O n m -> forall t y v, once O n mu d t y v -> forall i,
    speed O Plus mu 0 (v i) (t (i + 1)%Z) =
      - (1 - q O n m) / (1 + Oscillator.tau O * q O n m) * stop1 O mu (t 0%Z) /\
    forall s, y i (t i + s) = arc O (after O n m mu (t 0%Z)) s;
  exact_even : q O n m = 1 -> forall t y v, ~ once O n mu d t y v;
  exact_odd : Oscillator.tau O * q O n m = -1 -> forall t y v, once O n mu d t y v ->
    stop O mu (t 0%Z) = 0 /\ stop1 O mu (t 0%Z) = 0 }.
Definition Exact_statement : Prop := forall O n m mu d, any_stop O -> resonant O n m -> exact O n m mu d.

(** ** Both multipliers are - tau q, whatever the stop

    (s, w): time and velocity just after an impact. The next impact comes about n periods later, and its time
    is counted from there. *)
Definition next_impact (O : Oscillator.t) (n : nat) (mu : R) (z z' : R * R) : Prop := exists d t y v,
  swing O Plus mu d (fun i => Z.of_nat n * i)%Z t y v 0 1 /\
  z = (t 0%Z, v 0%Z (t 0%Z)) /\ z' = (t 1%Z - 2 * PI * INR n, v 1%Z (t 1%Z)).
Record returns (O : Oscillator.t) (n : nat) (mu : R) (z : R * R) (F : R * R -> R * R) (J : mat) : Prop := {
  returns_near : exists r, 0 < r /\ forall z', norm (sub z' z) <= r -> next_impact O n mu z' (F z');
  returns_fixed : F z = z;
  returns_derivative : derivative F z J }.
Definition Multipliers_statement : Prop := forall O n m mu d t y v, any_stop O -> resonant O n m ->
  regular O n m -> 0 < Oscillator.tau O -> once O n mu d t y v ->
  let a := - Oscillator.tau O * q O n m in
  exists F e, returns O n mu (t 0%Z, v 0%Z (t 0%Z)) F (Mat a 0 e a).

(** So wherever it exists, the motion is asymptotically stable: one that starts near it goes on for ever,
    stays near and comes as near as one likes; there is no other with that start. *)
Definition forward (O : Oscillator.t) (n : nat) (mu d : R) (t : Z -> R) (y v : Z -> R -> R) : Prop :=
  forall i j, (0 <= i)%Z -> j = (i + 1)%Z -> swing O Plus mu d (fun i => Z.of_nat n * i)%Z t y v i j.
Definition Stable_statement : Prop := forall O n m mu d t y v, any_stop O -> resonant O n m ->
  regular O n m -> 0 < Oscillator.tau O -> once O n mu d t y v ->
  forall eps, 0 < eps -> exists delta, 0 < delta /\ forall s w, Rabs (s - t 0%Z) <= delta ->
  Rabs (w - v 0%Z (t 0%Z)) <= delta -> exists t' y' v', forward O n mu (d + eps) t' y' v' /\
  t' 0%Z = s /\ v' 0%Z s = w /\ (forall i, (0 <= i)%Z -> near t t' v v' eps i) /\
  (forall eta, 0 < eta -> exists K, forall i, (K <= i)%Z -> near t t' v v' eta i) /\
  forall h t2 y2 v2, forward O n mu h t2 y2 v2 -> t2 0%Z = s -> v2 0%Z s = w ->
  forall i x, (0 <= i)%Z -> t2 i = t' i /\ y2 i x = y' i x /\ v2 i x = v' i x.

(** ** Birth: where the stop only touches for mu = 0

    For mu = - nu it then reaches the height nu > 0. For n >= 2 the one motion is born if theta is pi / n up
    to whole turns, and none is at the other resonances; for n = 1 it is at both. *)
Definition births (O : Oscillator.t) (n m : nat) : Prop :=
  regular O n m /\ (n = 1%nat \/ m mod (2 * n) = 1)%nat.
Record birth (O : Oscillator.t) (n m : nat) (nu eps : R) : Prop := {
  birth_before : forall d t y v, ~ once O n nu d t y v;
  birth_one : births O n m -> exists t y v, once O n (- nu) eps t y v /\
    forall t' y' v', once O n (- nu) PI t' y' v' ->
    forall i x, t' i = t i /\ y' i x = y i x /\ v' i x = v i x;
  birth_none : ~ births O n m -> forall d t y v, ~ once O n (- nu) d t y v }.
Definition Birth_statement : Prop := forall O n m, touching O -> resonant O n m -> forall eps, 0 < eps ->
  exists mu0, 0 < mu0 /\ forall nu, 0 < nu < mu0 -> birth O n m nu eps.

(** ** Maps: where det (I - A^n) <> 0, whatever C A^n B is, the orbits of period n with one impact are one
    curve near grazing: exactly one for each small speed y of the impact, or none

    It begins with the slope - C A^n V / e in mu and the direction V = (I - A^n)^-1 B. Where that slope is not
    0, this is Theorem 1; here it may be 0. *)
Definition single (M : Map.t) (n : nat) (mu d : R) (x : unit -> vec) : Prop :=
  orbit_near M unit (fun j => j) (fun _ => n) mu d x.
Definition speed_of (M : Map.t) (n : nat) (mu : R) (x : unit -> vec) : R :=
  sqrt (- StatementOrbits.height M mu (x tt) (n - 1)).
Definition across (M : Map.t) (V : vec) (k : nat) : R := dot (Map.N M) (Map.C M) (power M k V).
Record curve (M : Map.t) (w V : vec) (rate : R) (n : nat) (d : R) : Prop := {
  curve_none : (exists k, (0 < k < n)%nat /\ across M V k < across M V n) ->
    forall mu x, Rabs mu <= d -> ~ single M n mu d x;
  curve_one : (forall k, (0 < k < n)%nat -> across M V n < across M V k) -> exists r, 0 < r /\
    forall y, 0 < y < r -> exists mu x, Rabs mu <= d /\ single M n mu d x /\ speed_of M n mu x = y /\
    forall mu' x', Rabs mu' <= d -> single M n mu' d x' -> speed_of M n mu' x' = y ->
    mu' = mu /\ forall i, (i < Map.N M)%nat -> x' tt i = x tt i;
  curve_slope : forall eps, 0 < eps -> exists r, 0 < r /\ forall mu x, Rabs mu <= d -> single M n mu d x ->
    let y := speed_of M n mu x in y < r -> Rabs (mu + across M V n / rate * y) <= eps * y /\
    StatementOrbits.within (Map.N M) (eps * y) (fun i => x tt i - mu * w i - y * V i) }.
Definition Curve_statement : Prop := forall M w V rate n, smooth M -> let N := Map.N M in
  (forall i, (i < N)%nat -> w i = mult N (Map.A M) w i + Map.phi M i) ->
  rate = dot N (Map.C M) w + Map.eta M -> rate <> 0 -> (1 <= n)%nat ->
  (forall x, (forall i, (i < N)%nat -> x i = power M n x i) -> forall i, (i < N)%nat -> x i = 0) ->
  (forall i, (i < N)%nat -> V i = power M n V i + Map.B M i) -> exists d, 0 < d /\ curve M w V rate n d.

(** Where that slope is 0, the second order of n steps decides, in the direction (1, 0, V) of (y, mu, x). A
    function G of these bends by Q y^2 there, besides its linear part L: if it is C2, Q is half its second
    derivative in this direction. *)
Definition beside (N : nat) (V : vec) (r y mu : R) (x : vec) : Prop := Rabs mu <= r * Rabs y /\
  StatementOrbits.within N (r * Rabs y) (fun i => x i - y * V i).
Definition bends (N : nat) (V : vec) (G L : R -> R -> vec -> R) (Q : R) : Prop := forall eps, 0 < eps ->
  exists r, 0 < r /\ forall y mu x y' mu' x', 0 <= y <= r -> 0 <= y' <= r ->
  beside N V r y mu x -> beside N V r y' mu' x' -> beside N V r (y - y') (mu - mu') (minus x x') ->
  Rabs (G y mu x - G y' mu' x' - L (y - y') (mu - mu') (minus x x') - Q * (y ^ 2 - y' ^ 2)) <=
    eps * ((y + y') * Rabs (y - y')).
(** The height after n steps without impact, and the point after an impact of speed y there. *)
Record second_order (M : Map.t) (w V : vec) (rate : R) (n : nat) (Qh : R) (Q : vec) : Prop := {
  second_height : bends (Map.N M) V (fun _ mu x => Map.h M (Nat.iter n (fun x => Map.f M x mu) x) mu)
    (fun _ mu x => across M x n + mu * (rate - across M w n)) Qh;
  second_impact : forall i, (i < Map.N M)%nat -> bends (Map.N M) V (fun y mu x =>
    let z := Nat.iter n (fun x => Map.f M x mu) x in z i + Map.kick M z y mu i * y)
    (fun y mu x => power M n x i + y * Map.B M i + mu * (w i - power M n w i)) (Q i) }.
(** Then mu is about K y^2 on the curve: exactly one orbit where K mu > 0, and none elsewhere. *)
Definition Side_statement : Prop := forall M w V U rate n Qh Q, smooth M -> let N := Map.N M in
  (forall i, (i < N)%nat -> w i = mult N (Map.A M) w i + Map.phi M i) ->
  rate = dot N (Map.C M) w + Map.eta M -> rate <> 0 -> (1 <= n)%nat ->
  (forall x, (forall i, (i < N)%nat -> x i = power M n x i) -> forall i, (i < N)%nat -> x i = 0) ->
  (forall i, (i < N)%nat -> V i = power M n V i + Map.B M i /\ U i = power M n U i + Q i) ->
  second_order M w V rate n Qh Q -> across M V n = 0 -> (forall k, (0 < k < n)%nat -> 0 < across M V k) ->
  let K := - (1 + Qh + across M U n) / rate in K <> 0 -> exists d mu0, 0 < d /\ 0 < mu0 /\
  forall mu, Rabs mu < mu0 -> (0 < K * mu -> exists x, single M n mu d x /\ forall x', single M n mu d x' ->
    forall i, (i < N)%nat -> x' tt i = x tt i) /\ (K * mu <= 0 -> forall x, ~ single M n mu d x).

(** In the plane at resonance the slope is 0. For m = 1, gamma > 0 there is the curve. At the other resonances
    no orbit of period n with one impact is near grazing, on either side of mu = 0, whatever the second
    order. *)
Definition Plane_statement : Prop := forall M r s n m gamma rate w, 0 < r < 1 -> 0 < s < 1 / 2 ->
  (1 <= n)%nat -> INR n * s = INR m / 2 -> planar M (trace r s) (r ^ 2) gamma rate w ->
  exists V d, 0 < d /\ curve M w V rate n d /\ across M V n = 0 /\
  (m = 1%nat -> 0 < gamma -> forall k, (0 < k < n)%nat -> 0 < across M V k) /\
  ((2 <= m)%nat \/ gamma < 0 -> forall mu x, Rabs mu <= d -> ~ single M n mu d x).
