(** * Extraction of the functions of [StatementZ] and [StatementCircleZ] to OCaml, for oracle.ml

    No part of the proofs. Numbers stay Coq's own binary integers: nothing is replaced but bool, list and pairs by
    OCaml's. check.sh sees that each function extracted is one that a statement of [StatementZ],
    [StatementWordsZ] or [StatementCircleZ] is about, or addition, multiplication or negation, with which oracle.ml
    reads numbers. *)

From Coq Require Import Extraction ExtrOcamlBasic ZArith.
From Grazing Require Import Defs StatementZ StatementCircleZ.

Extraction "decide.ml" uZ signB signC signD orbitZ no_orbitZ memberZ signE edgeZ patternZ sidesZ singularZ circleZ no_circleZ
  Z.add Z.mul Z.opp.
