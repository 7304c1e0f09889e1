(** * Extraction of the functions of [StatementZ] and [StatementCircleZ], and of the readers of certificates, to OCaml

    No part of the proofs. Numbers stay Coq's own binary integers: nothing is replaced but bool, list, option and pairs
    by OCaml's. check.sh sees that this is all that stands here, that each function has its full name, and that a
    theorem is about it: assumptions.txt ends with a list of both. Addition, multiplication, negation and the greatest
    common divisor are Coq's own; with them oracle.ml and reader.ml read numbers. *)

From Coq Require Extraction ExtrOcamlBasic ZArith.
From Grazing Require StatementZ StatementCircleZ StatementReaders StatementReaderWords StatementGrowth PathsCheck
  RangesCheck TrapsCheck.

Extraction "decide.ml"
  Grazing.StatementZ.uZ Grazing.StatementZ.signB Grazing.StatementZ.signC Grazing.StatementZ.signD
  Grazing.StatementZ.orbitZ Grazing.StatementZ.no_orbitZ Grazing.StatementZ.memberZ Grazing.StatementZ.signE
  Grazing.StatementZ.edgeZ Grazing.StatementZ.patternZ
  Grazing.StatementCircleZ.sidesZ Grazing.StatementCircleZ.singularZ Grazing.StatementCircleZ.circleZ
  Grazing.StatementCircleZ.no_circleZ
  Grazing.StatementReaders.blockZ
  Grazing.StatementReaderWords.wordZ Grazing.StatementReaderWords.regionZ Grazing.StatementReaderWords.pathZ
  Grazing.StatementReaderWords.belowZ Grazing.StatementReaderWords.lonelyZ Grazing.StatementReaderWords.polarZ
  Grazing.StatementGrowth.grows Grazing.PathsCheck.check Grazing.RangesCheck.check_range
  Grazing.TrapsCheck.check_trap
  Coq.ZArith.BinInt.Z.add Coq.ZArith.BinInt.Z.mul Coq.ZArith.BinInt.Z.opp Coq.ZArith.BinInt.Z.gcd.
