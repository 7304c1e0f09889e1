(** * Statement: for every mu > 0 the period map on the motions over {1, 2} has the entropy log of the golden
    ratio

    Read [chaos_motion], [in_two_boxes] and [one_or_two] in [StatementChaos] first. *)

From Coq Require Import Reals ZArith List.
From Grazing Require Import StatementChaos.
Open Scope R_scope.

(** The state k periods on, by the last impact so far: its time, counted from 2 pi k, and the velocity after
    it. *)
Definition orbit_of (mu : R) (z : nat -> R * R) : Prop := exists N t y v,
  one_or_two N /\ chaos_motion mu N t y v /\ in_two_boxes mu N t v /\
  forall k i, (N i <= Z.of_nat k < N (i + 1))%Z -> z k = (t i - 2 * PI * INR k, v i (t i)).

(** The period map: the state says what comes next. *)
Definition Period_map_statement : Prop := forall mu z z', mu > 0 -> orbit_of mu z -> orbit_of mu z' ->
  z 0%nat = z' 0%nat -> forall k, z k = z' k.

(** Bowen's definition: (n, eps)-separated orbits, pairwise, grow in number like exp (n h) as eps tends to 0.
    *)
Definition apart (n : nat) (eps : R) (z z' : nat -> R * R) : Prop := exists k, (k < n)%nat /\
  (Rabs (fst (z k) - fst (z' k)) > eps \/ Rabs (snd (z k) - snd (z' k)) > eps).
Definition separated (S : (nat -> R * R) -> Prop) (n : nat) (eps : R) (L : list (nat -> R * R)) : Prop :=
  Forall S L /\ ForallOrdPairs (apart n eps) L.
Definition entropy (S : (nat -> R * R) -> Prop) (h : R) : Prop :=
  (forall eps eta, eps > 0 -> eta > 0 -> exists n0, forall n L, (n0 <= n)%nat -> separated S n eps L ->
   INR (length L) <= exp (INR n * (h + eta))) /\
  forall eta, eta > 0 -> exists eps n0, eps > 0 /\ forall n, (n0 <= n)%nat ->
  exists L, separated S n eps L /\ exp (INR n * (h - eta)) <= INR (length L).

Definition golden : R := (1 + sqrt 5) / 2.
Definition Entropy_statement : Prop := forall mu, mu > 0 -> entropy (orbit_of mu) (ln golden).

(** Orbits of period P: golden^(P - 1) of them at least, pairwise more than 1 apart, and golden^(P + 1) at
    most. *)
Definition Growth_statement : Prop := forall mu P, mu > 0 -> (1 <= P)%nat ->
  let S := fun z => orbit_of mu z /\ forall k, z (k + P)%nat = z k in
  (exists L, separated S P 1 L /\ golden ^ (P - 1) <= INR (length L)) /\
  forall L, Forall S L -> ForallOrdPairs (fun z z' => exists k, z k <> z' k) L ->
    INR (length L) <= golden ^ (P + 1).
