(** * The theorems of [StatementWords], by name, with the axioms each rests on *)

From Grazing Require Import StatementWords WordAlgebra WordPlane.

Theorem Words_algebra : Flight_statement /\ Identities_statement /\ Words_reversal_statement /\
  W1_statement /\ W2_statement.
Proof. exact (conj Flight (conj Identities (conj Words_reversal (conj W1 W2)))). Qed.

Theorem Words : Path_statement /\ W3_statement /\ W5_neighbours_statement /\ W5_statement /\
  W4_statement /\ W6_statement /\ Regions_statement.
Proof.
  exact (conj Path (conj W3 (conj W5_neighbours (conj W5 (conj W4 (conj W6 Regions)))))).
Qed.

Print Assumptions Words_algebra.
Print Assumptions Words.
