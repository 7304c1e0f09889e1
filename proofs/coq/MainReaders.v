(** * The theorems about the readers of certificates, by name *)

From Grazing Require Import StatementReaders StatementReaderWords StatementPaths ReaderCircle ReaderWords
  ReaderPolar PathsCheck.
From Grazing Require StatementGrowth Growth PathsChecked StatementRanges RangesCheck RangesLinks
  StatementTraps TrapsCheck TrapsChecked.

Theorem Circle_reader : Circle_reader_statement. Proof. exact ReaderCircle.Circle_reader. Qed.
Theorem Words_readers : Word_reader_statement /\ Region_reader_statement /\ Path_reader_statement /\
  Below_reader_statement /\ Lonely_reader_statement /\ Polar_reader_statement.
Proof.
  exact (conj Word_reader
    (conj Region_reader (conj Path_reader (conj Below_reader (conj Lonely_reader Polar_reader))))).
Qed.
Theorem Paths_reader : Paths_statement check. Proof. exact PathsChecked.Paths. Qed.
Theorem Ranges_reader : StatementRanges.Ranges_statement RangesCheck.check_range. Proof. exact RangesLinks.Ranges. Qed.
Theorem Traps_reader : StatementTraps.Traps_statement TrapsCheck.check_trap. Proof. exact TrapsChecked.Traps. Qed.
Theorem Growth_reader : StatementGrowth.Growth_reader_statement. Proof. exact Growth.Growth_reader. Qed.
