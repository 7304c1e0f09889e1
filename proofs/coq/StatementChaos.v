(** * Statement: the paper's oscillator has exactly one motion for every word over {1, 2} and every mu > 0,
    and for every word over {1, 2, 3} and every 0 < mu <= 0.003

    Section 4's oscillator (65)-(67) with d = 0.6, w = 4.9 and restitution 1. Its impacts can be one or two
    periods apart in any order, for all time: exactly one motion in the boxes below does it, above the wall
    between impacts. Read [motion] in [StatementOscillator] and [Nordmark] in [StatementNordmark] first. *)
From Coq Require Import Reals ZArith.
From Grazing Require Import Defs StatementOscillator StatementNordmark.
Open Scope R_scope.

(** Impact i, at the time t i, is within 6/5 of the time 2 pi N i. *)
Definition chaos_motion (mu : R) : (Z -> Z) -> (Z -> R) -> (Z -> R -> R) -> (Z -> R -> R) -> Prop :=
  motion (Nordmark (3 / 5) (49 / 10) 1) Plus (- mu) (6 / 5).

(** Boxes for the velocities after the first and before the last impact of a leg of one period, of two. *)
Definition in_two_boxes (mu : R) (N : Z -> Z) (t : Z -> R) (v : Z -> R -> R) : Prop := forall i j,
  j = (i + 1)%Z ->
  (N j = (N i + 1)%Z -> 89 / 1000 * mu <= v i (t i) <= 244 / 1000 * mu /\
    - (1582 / 10000) * mu <= v i (t j) <= - (612 / 10000) * mu) /\
  (N j = (N i + 2)%Z -> 615 / 1000 * mu <= v i (t i) <= 1036 / 1000 * mu /\
    - (367 / 1000) * mu <= v i (t j) <= - (140 / 1000) * mu).

Definition one_or_two (N : Z -> Z) : Prop :=
  forall i, (N (i + 1) = N i + 1)%Z \/ (N (i + 1) = N i + 2)%Z.

(** The times of the impacts say which N it is; where N is periodic, so is the motion. *)
Definition Chaos_distinct_statement : Prop := forall mu N N' t y v y' v',
  chaos_motion mu N t y v -> chaos_motion mu N' t y' v' -> forall i, N i = N' i.
Definition Chaos_periodic_statement : Prop := forall mu N t y v (m P : Z), mu > 0 -> one_or_two N ->
  chaos_motion mu N t y v -> in_two_boxes mu N t v -> (forall i, N (i + m) = N i + P)%Z ->
  forall i x, t (i + m)%Z = t i + 2 * PI * IZR P /\ y (i + m)%Z (x + 2 * PI * IZR P) = y i x /\
  v (i + m)%Z (x + 2 * PI * IZR P) = v i x.

(** Two motions whose N agree around an impact, the 0th for short, are close there. *)
Definition Chaos_continuous_statement : Prop := forall mu N N' t y v t' y' v' (K : nat), mu > 0 ->
  one_or_two N -> one_or_two N' -> chaos_motion mu N t y v -> in_two_boxes mu N t v ->
  chaos_motion mu N' t' y' v' -> in_two_boxes mu N' t' v' ->
  (forall i, (- (Z.of_nat K + 2) <= i <= Z.of_nat K + 2)%Z -> N i = N' i) ->
  Rabs (t 0%Z - t' 0%Z) <= 3 * (7 / 8) ^ K /\
  Rabs (v 0%Z (t 0%Z) - v' 0%Z (t' 0%Z)) <= 2 * mu * (7 / 8) ^ K.

(** The same over {1, 2, 3}, to mu = 0.003, in other boxes. *)
Definition in_three_boxes (mu : R) (N : Z -> Z) (t : Z -> R) (v : Z -> R -> R) : Prop := forall i j,
  j = (i + 1)%Z ->
  (N j = (N i + 1)%Z -> 28 / 1000 * mu <= v i (t i) <= 196 / 1000 * mu /\
    - (1137 / 10000) * mu <= v i (t j) <= - (1010 / 10000) * mu) /\
  (N j = (N i + 2)%Z -> 481 / 1000 * mu <= v i (t i) <= 829 / 1000 * mu /\
    - (2509 / 10000) * mu <= v i (t j) <= - (1638 / 10000) * mu) /\
  (N j = (N i + 3)%Z -> 169 / 10 * mu <= v i (t i) <= 323 / 10 * mu /\
    - (334 / 100) * mu <= v i (t j) <= - (175 / 100) * mu).
Definition one_to_three (N : Z -> Z) : Prop :=
  forall i, (N (i + 1) = N i + 1)%Z \/ (N (i + 1) = N i + 2)%Z \/ (N (i + 1) = N i + 3)%Z.
Definition Chaos_three_statement : Prop := forall mu N, 0 < mu <= 3 / 1000 -> one_to_three N ->
  exists t y v, chaos_motion mu N t y v /\ in_three_boxes mu N t v /\
  forall t' y' v', chaos_motion mu N t' y' v' -> in_three_boxes mu N t' v' ->
  forall i x, t' i = t i /\ y' i x = y i x /\ v' i x = v i x.
