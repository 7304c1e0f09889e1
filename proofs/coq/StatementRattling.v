(** * Statement: an oscillator between two stops, in the paper's coordinates (37), (38), that grazes one and hits either

    q' = u and u' = a (t, q, u, mu) while Q1 < q < Q2, as in [StatementStops]; now the orbit may have other impacts, on
    both stops, as in a gear that rattles, and the machine may be its own mirror image after half a period: then the
    orbit grazes the one stop and the other in turn, T is half a period, and words count these. [seen_from] measures
    each arc of the orbit from a stop of its own: that is an oscillator of [StatementBouncing], its motions are those
    between the stops, and where they are unstable, so are these. So whatever [Headline] says of
    [Bounces (seen_from P) rate] is about them. *)
From Coq Require Import Reals ZArith.
From Grazing Require Import Defs StatementNonlinear StatementBouncing StatementUnstable.
Open Scope R_scope.

(** Stop z, Plus the lower and Minus the upper, is at Q z 0 t mu; Q z n is its n-th derivative in t, and Q_mu z n the
    derivative of that in mu. U z mu t u is the velocity after an impact, with its derivatives, and tau the restitution
    at the touch. For mu = 0 the orbit is the arc q0 c, u0 c from s c to s (c + 1), where it hits stop [stop c] if
    [impact c]; what is measured from [stop c] on this arc never comes to the other stop. *)
Module Rattling. Record t : Type := { T : R; mirror : sign; a : R -> R -> R -> R -> R;
  a_t : R -> R -> R -> R -> R; a_q : R -> R -> R -> R -> R; a_u : R -> R -> R -> R -> R;
  a_mu : R -> R -> R -> R -> R; Q : sign -> nat -> R -> R -> R; Q_mu : sign -> nat -> R -> R -> R;
  U : sign -> R -> R -> R -> R; U_t : sign -> R -> R -> R -> R; U_u : sign -> R -> R -> R -> R;
  U_mu : sign -> R -> R -> R -> R; tau : R; k : nat; s : Z -> R; stop : Z -> sign; impact : Z -> bool;
  q0 : Z -> R -> R; u0 : Z -> R -> R; tG : R }.
End Rattling.
Import Rattling.

(** Place and velocity as seen from stop z. *)
Definition off (P : Rattling.t) (z : sign) (mu t q : R) : R := sgn z * (q - Q P z 0 t mu).
Definition rel (P : Rattling.t) (z : sign) (mu t u : R) : R := sgn z * (u - Q P z 1 t mu).
(** What is where stop z and q were, after the time T. *)
Definition image (P : Rattling.t) (z : sign) : sign :=
  match mirror P, z with Plus, _ => z | Minus, Plus => Minus | Minus, Minus => Plus end.
Definition turned (P : Rattling.t) (q : R) : R := sgn (mirror P) * q.
(** From q, u at the end of arc c to q', u' at the beginning of the next. *)
Definition passes (P : Rattling.t) (c : Z) (mu t q u q' u' : R) : Prop :=
  q' = q /\ if impact P c then u' = U P (stop P c) mu t u else u' = u.

Record rattles (P : Rattling.t) : Prop := {
  all_turned : 0 < T P /\ (1 <= k P)%nat /\ forall c t, let c' := (c + Z.of_nat (k P))%Z in s P c' = s P c + T P /\
    stop P c' = image P (stop P c) /\ impact P c' = impact P c /\ q0 P c' (t + T P) = turned P (q0 P c t) /\
    u0 P c' (t + T P) = turned P (u0 P c t) /\ forall z n q u mu,
    a P (t + T P) (turned P q) (turned P u) mu = turned P (a P t q u mu) /\
    Q P (image P z) n (t + T P) mu = turned P (Q P z n t mu) /\
    U P (image P z) mu (t + T P) (turned P u) = turned P (U P z mu t u);
  arcs_run : exists r, 0 < r /\ forall c t, s P c - r <= t <= s P (c + 1)%Z + r ->
    derivable_pt_lim (q0 P c) t (u0 P c t) /\ derivable_pt_lim (u0 P c) t (a P t (q0 P c t) (u0 P c t) 0);
  arcs_end : forall c, let t := s P (c + 1)%Z in let z := stop P c in s P c < t /\
    passes P c 0 t (q0 P c t) (u0 P c t) (q0 P (c + 1)%Z t) (u0 P (c + 1)%Z t) /\ if impact P c
    then stop P (c + 1)%Z = z /\ off P z 0 t (q0 P c t) = 0 /\ rel P z 0 t (u0 P c t) < 0 < rel P z 0 t (u0 P (c + 1)%Z t)
    else 0 < off P z 0 t (q0 P c t);
  arc_touches : let z := stop P 0%Z in let t := tG P in s P 0%Z < t < s P 1%Z /\ q0 P 0%Z t = Q P z 0 t 0 /\
    u0 P 0%Z t = Q P z 1 t 0 /\ 0 < sgn z * (a P t (q0 P 0%Z t) (u0 P 0%Z t) 0 - Q P z 2 t 0);
  off_its_stop : forall c t, s P c < t < s P (c + 1)%Z ->
    (forall N, ~ (c = (Z.of_nat (k P) * N)%Z /\ t = tG P + T P * IZR N)) -> 0 < off P (stop P c) 0 t (q0 P c t);
  off_the_other : forall c t z, s P c <= t <= s P (c + 1)%Z -> z <> stop P c -> 0 < off P z 0 t (q0 P c t);
  a_C1 : exists r, 0 < r /\ forall c, C1 (fun t q u mu => s P c - r <= t <= s P (c + 1)%Z + r /\
      Rabs (q - q0 P c t) <= r /\ Rabs (u - u0 P c t) <= r /\ Rabs mu <= r) (a P) (a_t P) (a_q P) (a_u P) (a_mu P);
  Q_C3 : exists r, 0 < r /\ forall z n, (n <= 2)%nat -> C1 (fun _ _ _ mu => Rabs mu <= r)
    (fun t _ _ mu => Q P z n t mu) (fun t _ _ mu => Q P z (S n) t mu) (fun _ _ _ _ => 0) (fun _ _ _ _ => 0)
    (fun t _ _ mu => Q_mu P z n t mu);
  U_law : 0 <= tau P /\ let z := stop P 0%Z in (forall mu t, U P z mu t (Q P z 1 t mu) = Q P z 1 t mu) /\
    forall mu t u, rel P z mu t u < 0 -> 0 <= rel P z mu t (U P z mu t u);
  U_C1_touch : exists r f1 f2 f3 f4, 0 < r /\ f3 (tG P) (q0 P 0%Z (tG P)) (u0 P 0%Z (tG P)) 0 = - tau P /\
    C1 (fun t _ u mu => Rabs (t - tG P) <= r /\ Rabs (u - u0 P 0%Z (tG P)) <= r /\ Rabs mu <= r)
      (fun t _ u mu => U P (stop P 0%Z) mu t u) f1 f2 f3 f4;
  U_C1 : exists r, 0 < r /\ forall c, impact P c = true -> let z := stop P c in let s1 := s P (c + 1)%Z in
    C1 (fun t _ u mu => Rabs (t - s1) <= r /\ Rabs (u - u0 P c s1) <= r /\ Rabs mu <= r)
      (fun t _ u mu => U P z mu t u) (fun t _ u mu => U_t P z mu t u) (fun _ _ _ _ => 0)
      (fun t _ u mu => U_u P z mu t u) (fun t _ u mu => U_mu P z mu t u) }.

Definition seen_from (P : Rattling.t) : Bouncing.t :=
  let seen f c t y v mu :=
    f t (Q P (stop P c) 0 t mu + sgn (stop P c) * y) (Q P (stop P c) 1 t mu + sgn (stop P c) * v) mu in
  let law f c mu t v := f (stop P c) mu t (Q P (stop P c) 1 t mu + sgn (stop P c) * v) in
  let apart f n c mu := let z := stop P c in let z' := stop P (c + 1)%Z in let t := s P (c + 1)%Z in
    sgn z' * (f z n t mu - f z' n t mu) in {|
  Bouncing.T := T P;
  Bouncing.a := fun c t y v mu => sgn (stop P c) * (seen (a P) c t y v mu - Q P (stop P c) 2 t mu);
  Bouncing.a_t := fun c t y v mu => sgn (stop P c) * (seen (a_t P) c t y v mu + seen (a_q P) c t y v mu *
    Q P (stop P c) 1 t mu + seen (a_u P) c t y v mu * Q P (stop P c) 2 t mu - Q P (stop P c) 3 t mu);
  Bouncing.a_y := seen (a_q P);
  Bouncing.a_v := seen (a_u P);
  Bouncing.a_mu := fun c t y v mu => sgn (stop P c) * (seen (a_mu P) c t y v mu + seen (a_q P) c t y v mu *
    Q_mu P (stop P c) 0 t mu + seen (a_u P) c t y v mu * Q_mu P (stop P c) 1 t mu - Q_mu P (stop P c) 2 t mu);
  Bouncing.impact := impact P;
  Bouncing.rebound := fun c mu t v => rel P (stop P c) mu t (law (U P) c mu t v);
  Bouncing.rebound_t := fun c mu t v => sgn (stop P c) * (law (U_t P) c mu t v +
    law (U_u P) c mu t v * Q P (stop P c) 2 t mu - Q P (stop P c) 2 t mu);
  Bouncing.rebound_v := law (U_u P);
  Bouncing.rebound_mu := fun c mu t v => sgn (stop P c) * (law (U_mu P) c mu t v +
    law (U_u P) c mu t v * Q_mu P (stop P c) 1 t mu - Q_mu P (stop P c) 1 t mu);
  Bouncing.face := fun c => sgn (stop P (c + 1)%Z) * sgn (stop P c);
  Bouncing.place := apart (Q P) 0%nat; Bouncing.place_mu := apart (Q_mu P) 0%nat;
  Bouncing.speed := apart (Q P) 1%nat; Bouncing.speed_mu := apart (Q_mu P) 1%nat;
  Bouncing.tau := tau P; Bouncing.k := k P; Bouncing.s := s P;
  Bouncing.y0 := fun c t => off P (stop P c) 0 t (q0 P c t);
  Bouncing.v0 := fun c t => rel P (stop P c) 0 t (u0 P c t); Bouncing.tG := tG P |}.

(** A [journey] of [StatementBouncing], between the stops: from impact i at the touched stop, which is the image of
    [stop 0] in half periods N i, to the next, j, past n ends of arcs at the times r 1 to r n, along the arcs p m, w m, near
    those of the orbit as they are seen from their stops. *)
Definition on (P : Rattling.t) (N : Z -> Z) (i : Z) (m : nat) : Z := arc (seen_from P) N i m.
Record ride (P : Rattling.t) (mu d : R) (N : Z -> Z) (t : Z -> R) (q u : Z -> R -> R) (i j : Z)
  (r : nat -> R) (p w : nat -> R -> R) (n : nat) : Prop := {
  ride_from : r 0%nat = t i /\ off P (stop P (on P N i 0)) mu (t i) (p 0%nat (t i)) = 0;
  ride_to : r (S n) = t j /\ off P (stop P (on P N i n)) mu (t j) (p n (t j)) = 0 /\
    rel P (stop P (on P N i n)) mu (t j) (w n (t j)) < 0;
  ride_near : forall l, l = i \/ l = j -> Rabs (t l - (tG P + T P * IZR (N l))) <= d;
  ride_others : forall m, (1 <= m <= n)%nat -> Rabs (r m - s P (on P N i m)) <= d;
  ride_arcs : forall m, (m <= n)%nat -> r m < r (S m);
  ride_ends : forall m, (m < n)%nat -> let z := stop P (on P N i m) in let x := r (S m) in if impact P (on P N i m)
    then off P z mu x (p m x) = 0 /\ rel P z mu x (w m x) < 0 else x = s P (on P N i (S m));
  ride_moves : forall m x, (m <= n)%nat -> r m <= x <= r (S m) ->
    derivable_pt_lim (p m) x (w m x) /\ derivable_pt_lim (w m) x (a P x (p m x) (w m x) mu);
  ride_tube : forall m x, (m <= n)%nat -> r m <= x <= r (S m) -> let c := on P N i m in let z := stop P c in
    Rabs (off P z mu x (p m x) - off P z 0 x (q0 P c x)) <= d /\
    Rabs (rel P z mu x (w m x) - rel P z 0 x (u0 P c x)) <= d;
  ride_between : forall m x, (m <= n)%nat -> r m < x < r (S m) -> Q P Plus 0 x mu < p m x < Q P Minus 0 x mu;
  ride_back : forall m, (m < n)%nat -> let x := r (S m) in
    passes P (on P N i m) mu x (p m x) (w m x) (p (S m) x) (w (S m) x);
  ride_is : forall m x, (m <= n)%nat -> r m <= x <= r (S m) -> (x = r (S m) -> m = n) ->
    q i x = p m x /\ u i x = w m x;
  ride_hits : u j (t j) = U P (stop P (on P N j 0)) mu (t j) (u i (t j)) }.
Definition rides (P : Rattling.t) (mu d : R) (N : Z -> Z) (t : Z -> R) (q u : Z -> R -> R) (i j : Z) : Prop :=
  exists r p w, ride P mu d N t q u i j r p w (others (seen_from P) N i j).
Definition rattling_motion (P : Rattling.t) (mu d : R) (N : Z -> Z) (t : Z -> R) (q u : Z -> R -> R) : Prop :=
  forall i j, j = (i + 1)%Z -> rides P mu d N t q u i j.
Definition one_rattling_motion (P : Rattling.t) (mu d : R) (N : Z -> Z) : Prop := exists t q u,
  rattling_motion P mu d N t q u /\ forall t' q' u', rattling_motion P mu d N t' q' u' ->
  forall i, t' i = t i /\ forall x, t i <= x <= t (i + 1)%Z -> q' i x = q i x /\ u' i x = u i x.

Definition Rattling_statement : Prop := forall P, rattles P -> bouncing_orbit (seen_from P) /\
  exists r, 0 < r /\ forall mu d N, Rabs mu <= r -> d <= r -> (forall i, N i <= N (i + 1))%Z ->
  (one_rattling_motion P mu d N <-> one_bouncing_motion (seen_from P) mu d N) /\
  ((exists t q u, rattling_motion P mu d N t q u) <->
   exists t y v, bouncing_motion (seen_from P) mu d N t y v) /\
  ((forall t y v, bouncing_motion (seen_from P) mu d N t y v ->
    unstable_motion (bounces (seen_from P) mu d N) t v) ->
   forall t q u, rattling_motion P mu d N t q u -> unstable_motion (rides P mu d N) t u).
