(** * Statement: the paper's oscillator, with its equations as they stand there, and stops with any harmonics
    are oscillators near grazing

    Read [StatementOscillator] first. *)
From Coq Require Import Reals ZArith List.
From Grazing Require Import Defs StatementOscillator.
Import ListNotations.
Open Scope R_scope.

(** ** The paper's oscillator, (65)-(67); its mu is minus ours, and e = -1 *)
Definition Nordmark (d w tau : R) : Oscillator.t := {|
  Oscillator.c := 2 * d / w; Oscillator.k := 1 / w ^ 2; Oscillator.tau := tau;
  Oscillator.G := fun mu t => (1 - mu) * (1 - cos t); Oscillator.G1 := fun mu t => (1 - mu) * sin t;
  Oscillator.G2 := fun mu t => (1 - mu) * cos t |}.

(** (72)-(74) for d < 1, (69)-(71) for d > 1, what is between them, and a motion word for word. *)
Definition Nordmark_statement : Prop := forall d w tau, 0 < w -> 0 <= tau ->
  let has a1 gamma := grazing (Nordmark d w tau) Plus a1 (exp (- 4 * PI * d / w)) gamma in
  (forall sigma, d < 1 -> 0 <= d -> sigma = sqrt (1 - d ^ 2) / w -> sin (2 * PI * sigma) <> 0 ->
   exists gamma, has (2 * exp (- 2 * PI * d / w) * cos (2 * PI * sigma)) gamma /\
     0 < gamma * sin (2 * PI * sigma)) /\
  (d > 1 -> exists gamma, has (2 * exp (- 2 * PI * d / w) * cosh (2 * PI * sqrt (d ^ 2 - 1) / w)) gamma /\
    0 < gamma) /\
  (d = 1 -> exists gamma, has (2 * exp (- 2 * PI * d / w)) gamma /\ 0 < gamma) /\
  forall mu h N t y v, motion (Nordmark d w tau) Plus (- mu) h N t y v <-> forall i j, j = (i + 1)%Z ->
  (forall x, derivable_pt_lim (y i) x (v i x) /\
   derivable_pt_lim (v i) x (- (2 * d / w) * v i x - 1 / w ^ 2 * y i x)) /\
  Rabs (t i - 2 * PI * IZR (N i)) <= h /\ t i < t j /\
  y i (t i) = (1 + mu) * cos (t i) - 1 /\ y i (t j) = (1 + mu) * cos (t j) - 1 /\
  (forall x, t i < x < t j -> y i x > (1 + mu) * cos x - 1) /\
  v i (t j) < - ((1 + mu) * sin (t j)) /\ v j (t j) = - tau * v i (t j) - (1 + tau) * (1 + mu) * sin (t j).

(** Stops with any harmonics, x_j (1 - cos j t) + y_j sin j t summed over a list of (x_j, y_j), that have
    their one top at 0. *)
Fixpoint harmonics (j : nat) (l : list (R * R)) (t : R) : R := match l with [] => 0
  | (x, y) :: l => x * (1 - cos (INR j * t)) + y * sin (INR j * t) + harmonics (S j) l t end.
Fixpoint weighted (j : nat) (l : list (R * R)) : R := match l with [] => 0
  | (x, _) :: l => INR j ^ 2 * x + weighted (S j) l end.
Definition Harmonics_statement : Prop :=
  forall c k tau l, (forall t, 0 < t < 2 * PI -> 0 < harmonics 1 l t) ->
  0 < weighted 1 l -> exists O, touching O /\ Oscillator.c O = c /\ Oscillator.k O = k /\
    Oscillator.tau O = tau /\ forall mu t, Oscillator.G O mu t = harmonics 1 l t.
