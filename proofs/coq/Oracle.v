(** * Extraction of the functions of [StatementZ] to OCaml, for oracle.ml

    No part of the proofs. Numbers stay Coq's own binary integers: nothing is replaced but bool, list and pairs by
    OCaml's. check.sh sees that each function extracted is one that a statement of [StatementZ] or
    [StatementWordsZ] is about, or addition, multiplication or negation, with which oracle.ml reads numbers. *)

From Coq Require Import Extraction ExtrOcamlBasic ZArith.
From Grazing Require Import Defs StatementZ.

Extraction "decide.ml" uZ signB signC signD orbitZ no_orbitZ memberZ signE edgeZ patternZ Z.add Z.mul Z.opp.
