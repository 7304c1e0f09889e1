(** * Extraction of the functions of [StatementZ] and [StatementCircleZ], and of the readers of certificates, to OCaml

    No part of the proofs. Numbers stay Coq's own binary integers: nothing is replaced but bool, list, option and pairs
    by OCaml's. check.sh sees that each function extracted is one that a statement of [StatementZ], [StatementWordsZ],
    [StatementCircleZ], [StatementReaders], [StatementReaderWords], [StatementPaths] or [StatementRanges] is about, or
    addition, multiplication, negation or the greatest common divisor, with which oracle.ml and reader.ml read numbers. *)

From Coq Require Import Extraction ExtrOcamlBasic ZArith.
From Grazing Require Import Defs StatementZ StatementCircleZ StatementReaders StatementReaderWords PathsCheck
  RangesCheck.

Extraction "decide.ml" uZ signB signC signD orbitZ no_orbitZ memberZ signE edgeZ patternZ sidesZ singularZ circleZ no_circleZ
  blockZ wordZ regionZ pathZ belowZ lonelyZ polarZ check check_range Z.add Z.mul Z.opp Z.gcd.
