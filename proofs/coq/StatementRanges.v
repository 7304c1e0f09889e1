(** * Statement: a checker of certificates, each of which says that from the touch to a distance from it every
    path of a graph is a motion

    Machines and motions are those of [StatementPaths]. The graph is of letters, legs of whole numbers of
    periods; an edge is an impact between two legs, with a range of strengths s: there the wall's velocity is
    nu s/2. Complete on this page and that of [StatementPaths]. *)
From Coq Require Import Reals ZArith QArith Qreals List.
From Grazing Require Import StatementPaths.
Open Scope R_scope.

(** Of an edge the range of s; a factor and a weight for the proof. *)
Module Edge. Record t : Type := { strengths : Q * Q; factor : Q; weight : Q }.
End Edge.
(** From which depth nu to which; what is said of each edge, in their order; in how many parts each range is
    cut, and in how many steps the motions are found to be those of the cell before. *)
Module Cell. Record t : Type := { depth : Q * Q; parts : nat; steps : nat; edges : list Edge.t }.
End Cell.
(** Ranges of c, k, tau; whether sigma is 1 or - 1; ranges of a and b for each harmonic; impacts are at phases
    within the window; the contraction; the periods of each letter, counted from 0, and the edges, each from
    letter to letter. *)
Module Range. Record t : Type := {
  damping : Q * Q; stiffness : Q * Q; restitution : Q * Q; behind : bool;
  harmonics : list (positive * ((Q * Q) * (Q * Q))); window : Q; contraction : Q;
  periods : list positive; graph : list (nat * nat); cells : list Cell.t }.
End Range.

(** From the touch on, without the touch; the wall is highest at the time 0, where g = 1 and g' = 0. *)
Record covers_range (C : Range.t) (M : Machine.t) : Prop := {
  range_c : in_interval (Range.damping C) (Machine.c M);
  range_k : in_interval (Range.stiffness C) (Machine.k M);
  range_tau : in_interval (Range.restitution C) (Machine.tau M);
  range_sigma : Machine.sigma M = (if Range.behind C then 1 else -1);
  range_deep : 0 < Machine.nu M;
  range_nu : exists K, In K (Range.cells C) /\ Machine.nu M <= Q2R (snd (Cell.depth K));
  range_harmonics : Forall2 (fun '(i, (A, B)) '(j, (a, b)) => i = j /\ in_interval A a /\ in_interval B b)
    (Range.harmonics C) (Machine.harmonics M);
  range_top : g M 0 = 1;
  range_level : g1 M 0 = 0 }.

(** Leg i is of letter l i; impact i + 1 is between it and the next, N i the turn of impact i. *)
Definition edge_path (C : Range.t) (l : Z -> nat) : Prop := forall i, In (l i, l (i + 1)%Z) (Range.graph C).
Definition edge_turns (C : Range.t) (l : Z -> nat) (N : Z -> Z) : Prop := forall i, exists n,
  nth_error (Range.periods C) (l i) = Some n /\ (N (i + 1) = N i + Z.pos n)%Z.

(** What a cell says of an edge. *)
Fixpoint edge_at (G : list (nat * nat)) (E : list Edge.t) (u v : nat) : option Edge.t := match G, E with
  | (u', v') :: G, e :: E => if (Nat.eqb u u' && Nat.eqb v v')%bool then Some e else edge_at G E u v
  | _, _ => None end.
(** The strengths of the impacts, at the times t, are in the cell's ranges. *)
Definition in_ranges (C : Range.t) (K : Cell.t) (M : Machine.t) (l : Z -> nat) (t : Z -> R) : Prop :=
  forall i j, j = (i + 1)%Z -> exists e s, edge_at (Range.graph C) (Cell.edges K) (l i) (l j) = Some e /\
  in_interval (Edge.strengths e) s /\ g1 M (t j) = Machine.nu M * s / 2.

(** Whatever passes is true: the depth is in a cell; and one motion has its strengths in the ranges of every
    cell that the depth is in, and in those of each is the only one. *)
Definition Ranges_statement (check_range : Range.t -> bool) : Prop := forall C M l N, check_range C = true ->
  covers_range C M -> edge_path C l -> edge_turns C l N -> let W := Q2R (Range.window C) in
  let cell K := In K (Range.cells C) /\ in_interval (Cell.depth K) (Machine.nu M) in
  (exists K, cell K) /\ exists t y v, machine_motion M W N t y v /\ forall K, cell K -> in_ranges C K M l t /\
  forall t' y' v', machine_motion M W N t' y' v' -> in_ranges C K M l t' ->
  forall i x, t' i = t i /\ y' i x = y i x /\ v' i x = v i x.
