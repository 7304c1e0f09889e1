(** * Statement: a checker of certificates of kind attractor, each of which says that beyond a touch the motions
      of overdamped oscillators are trapped and chaotic, at every depth up to one

    Read [chaotic], [begins] and [by_passes] in [StatementTrapped]; what follows from them is [attracts] in
      [Headline].
    The oscillator is that of [StatementPaths]: y'' = - c y' - k y above the wall nu - 1 + g. *)
From Grazing Require Import StatementOscillator StatementTrapped.
From Coq Require Import Reals ZArith QArith Qreals List.
From Grazing Require Import StatementPaths.
Open Scope R_scope.

(** Ranges of c, k, tau and of a and b for each harmonic; the greatest depth; how far before and after the time 0
    the wall may reach the height 0, and between which numbers - g'' is there; where g is concave, if g is not the
    cosine; speed S and slip Z of the trap; by what motions separate, shown for so many returns one by one; how what
    is trapped may start; and from which depth on the exponent is so great, where returns take so many periods. *)
Module Trap. Record t : Type := {
  damping : Q * Q; stiffness : Q * Q; restitution : Q * Q; harmonics : list (positive * ((Q * Q) * (Q * Q)));
  depth : Q; window : Q * Q; bends : Q * Q; concave : option (Q * Q); speed : Q; slip : Q; growth : Q;
  last : positive; start : Q; exponent : option ((Q * Q) * positive) }.
End Trap.
Record covers_trap (C : Trap.t) (M : Machine.t) : Prop := {
  trap_c : in_interval (Trap.damping C) (Machine.c M);
  trap_k : in_interval (Trap.stiffness C) (Machine.k M);
  trap_tau : in_interval (Trap.restitution C) (Machine.tau M);
  trap_sigma : Machine.sigma M = 1;
  trap_nu : 0 < Machine.nu M <= Q2R (Trap.depth C);
  trap_harmonics : Forall2 (fun '(i, (A, B)) '(j, (a, b)) => i = j /\ in_interval A a /\ in_interval B b)
    (Trap.harmonics C) (Machine.harmonics M);
  trap_top : g M 0 = 1;
  trap_level : g1 M 0 = 0 }.

(** The oscillator as [StatementTrapped] has it, its wall of the height 0 or more in times of length w, with the
    listed trap. *)
Definition g2 (M : Machine.t) (t : R) : R := - over_harmonics (fun '(j, (a, b)) => IZR (Z.pos j * Z.pos j) *
  (a * cos (IZR (Z.pos j) * t) + b * sin (IZR (Z.pos j) * t))) (Machine.harmonics M).
Definition seen (C : Trap.t) (M : Machine.t) (w : R) : machine :=
  let c := Machine.c M in let r := sqrt (c * c - 4 * Machine.k M) in {|
  a := (c - r) / 2; b := (c + r) / 2; tau := Machine.tau M; p := 2 * PI; W := w; mu := Machine.nu M;
  al0 := Q2R (fst (Trap.bends C)); al1 := Q2R (snd (Trap.bends C));
  zm := Q2R (Trap.slip C) * Machine.nu M; Vm := Q2R (Trap.speed C) * sqrt (Machine.nu M);
  StatementTrapped.Q := wall M; Q1 := g1 M; Q2 := g2 M |}.

(** All machines in the ranges are as [attracts] asks. *)
Record traps (C : Trap.t) (M : Machine.t) (T : machine) (lo hi : R) : Prop := {
  trap_roots : a T + b T = Machine.c M /\ a T * b T = Machine.k M;
  trap_window : - Q2R (fst (Trap.window C)) <= lo /\ hi <= Q2R (snd (Trap.window C));
  trap_chaotic : chaotic T lo hi (Q2R (Trap.growth C));
  trap_begins : begins T (Q2R (Trap.start C));
  trap_exponent : forall nu theta m, Trap.exponent C = Some ((nu, theta), m) -> Q2R nu <= mu T ->
    by_passes T (Q2R theta) (Z.pos m) }.

(** Whatever passes is true. *)
Definition Traps_statement (check_trap : Trap.t -> bool) : Prop := forall C M, check_trap C = true ->
  covers_trap C M -> exists lo hi, traps C M (seen C M (hi - lo)) lo hi.
