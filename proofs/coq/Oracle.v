(** * Extraction of the functions of [StatementZ] to OCaml, for oracle.ml

    No part of the proofs. Numbers stay Coq's own binary integers: nothing is replaced
    but bool, list and pairs by OCaml's. *)

From Coq Require Import Extraction ExtrOcamlBasic ZArith List.
From Grazing Require Import Defs StatementZ.

Definition all_cases (p s q : Z) (n : nat) : list bool :=
  map (fun '(e, g) => orbitZ p s q n e g)
    ((Plus, Plus) :: (Plus, Minus) :: (Minus, Plus) :: (Minus, Minus) :: nil).

Extraction "decide.ml" uZ signB signC signD all_cases no_orbitZ Z.add Z.mul Z.opp.
