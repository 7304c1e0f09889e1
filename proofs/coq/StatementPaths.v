(** * Statement: a checker of certificates, each of which says that every path of a graph of legs is a motion

    The oscillator y'' = - c y' - k y above a wall that moves with harmonics of period 2 pi, with any
    restitution. Legs of whole numbers of periods, each in its box of velocities, follow each other in every
    order that the graph allows, for all time: exactly one motion does it, above the wall between impacts.
    Complete on this page, but for [free]. *)
From Coq Require Import Reals ZArith QArith Qreals List.
From Grazing Require Import StatementOscillator.
Open Scope R_scope.

(** The wall is sigma nu - 1 + g, where g is the sum of the harmonics a cos (j t) + b sin (j t); an impact
    turns the relative velocity - V into tau V. *)
Module Machine. Record t : Type := {
  c : R; k : R; tau : R; sigma : R; nu : R; harmonics : list (positive * (R * R)) }.
End Machine.
Fixpoint over_harmonics (f : positive * (R * R) -> R) (H : list (positive * (R * R))) : R :=
  match H with nil => 0 | cons h H => f h + over_harmonics f H end.
Definition g (M : Machine.t) (t : R) : R := over_harmonics (fun '(j, (a, b)) =>
  a * cos (IZR (Z.pos j) * t) + b * sin (IZR (Z.pos j) * t)) (Machine.harmonics M).
Definition g1 (M : Machine.t) (t : R) : R := over_harmonics (fun '(j, (a, b)) =>
  IZR (Z.pos j) * (b * cos (IZR (Z.pos j) * t) - a * sin (IZR (Z.pos j) * t))) (Machine.harmonics M).
Definition wall (M : Machine.t) (t : R) : R := Machine.sigma M * Machine.nu M - 1 + g M t.

(** A leg lasts that many periods; ranges of the velocities, divided by nu, just after its first and just
    before its last impact, and the weights of the two in the norm in which legs contract; the numbers of
    those that may follow. *)
Module Letter. Record t : Type := {
  periods : positive; after : Q * Q; before : Q * Q; weights : Q * Q; next : list nat }.
End Letter.

(** Ranges of c, k, tau and nu, and in how many cells each is cut; whether sigma is 1 or - 1; ranges of a and
    b for each harmonic; impacts are at phases within the window; the contraction. *)
Module Certificate. Record t : Type := {
  damping : Q * Q; stiffness : Q * Q; restitution : Q * Q; depth : Q * Q; cells : nat * nat * nat * nat;
  behind : bool; harmonics : list (positive * ((Q * Q) * (Q * Q))); window : Q; contraction : Q;
  letters : list Letter.t }.
End Certificate.

Definition in_interval (X : Q * Q) (x : R) : Prop := Q2R (fst X) <= x <= Q2R (snd X).
(** The wall is highest at the time 0, where g = 1 and g' = 0. *)
Record covers (C : Certificate.t) (M : Machine.t) : Prop := {
  covers_c : in_interval (Certificate.damping C) (Machine.c M);
  covers_k : in_interval (Certificate.stiffness C) (Machine.k M);
  covers_tau : in_interval (Certificate.restitution C) (Machine.tau M);
  covers_nu : in_interval (Certificate.depth C) (Machine.nu M);
  covers_sigma : Machine.sigma M = (if Certificate.behind C then 1 else -1);
  covers_deep : 0 < Machine.nu M;
  covers_harmonics : Forall2 (fun '(i, (A, B)) '(j, (a, b)) => i = j /\ in_interval A a /\ in_interval B b)
    (Certificate.harmonics C) (Machine.harmonics M);
  covers_top : g M 0 = 1;
  covers_level : g1 M 0 = 0 }.

(** Bi-infinite paths of the graph, and the turns of the wall at which their impacts are. *)
Definition follows (C : Certificate.t) (l l' : Letter.t) : Prop :=
  exists v, In v (Letter.next l) /\ nth_error (Certificate.letters C) v = Some l'.
Definition leg_path (C : Certificate.t) (l : Z -> Letter.t) : Prop :=
  forall i, In (l i) (Certificate.letters C) /\ follows C (l i) (l (i + 1)%Z).
Definition turns (l : Z -> Letter.t) (N : Z -> Z) : Prop :=
  forall i, (N (i + 1) = N i + Z.pos (Letter.periods (l i)))%Z.

(** Between impact i, at the time t i, and the next, j, the oscillator moves as y i, v i. Impact i is within W
    of the time 2 pi N i, at positive relative speed, of which tau times returns. The oscillator is above the
    wall strictly between impacts. *)
Record machine_swing (M : Machine.t) (W : R) (N : Z -> Z) (t : Z -> R) (y v : Z -> R -> R)
  (i j : Z) : Prop := {
  machine_free : free (Machine.c M) (Machine.k M) (y i) (v i);
  machine_near : Rabs (t i - 2 * PI * IZR (N i)) < W;
  machine_on : t i < t j;
  machine_from : y i (t i) = wall M (t i);
  machine_to : y i (t j) = wall M (t j);
  machine_clear : forall x, t i < x < t j -> wall M x < y i x;
  machine_hits : v i (t j) - g1 M (t j) < 0;
  machine_back : v j (t j) - g1 M (t j) = - Machine.tau M * (v i (t j) - g1 M (t j)) }.
Definition machine_motion (M : Machine.t) (W : R) (N : Z -> Z) (t : Z -> R) (y v : Z -> R -> R) : Prop :=
  forall i j, j = (i + 1)%Z -> machine_swing M W N t y v i j.
Definition in_boxes (M : Machine.t) (l : Z -> Letter.t) (t : Z -> R) (v : Z -> R -> R) : Prop := forall i j,
  j = (i + 1)%Z -> in_interval (Letter.after (l i)) (v i (t i) / Machine.nu M) /\
  in_interval (Letter.before (l i)) (v i (t j) / Machine.nu M).

(** Whatever passes is true. *)
Definition Paths_statement (check : Certificate.t -> bool) : Prop := forall C M l N, check C = true ->
  covers C M -> leg_path C l -> turns l N -> let W := Q2R (Certificate.window C) in
  exists t y v, machine_motion M W N t y v /\ in_boxes M l t v /\
  forall t' y' v', machine_motion M W N t' y' v' -> in_boxes M l t' v' ->
  forall i x, t' i = t i /\ y' i x = y i x /\ v' i x = v i x.
