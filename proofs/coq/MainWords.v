(** * The theorems about words, by name *)

From Grazing Require Import StatementWords WordAlgebra WordPlane StatementExamples WordExamples StatementWordOrbits
  WordOrbits WordFinite WordChaos StatementWordsZ WordsZ.

Theorem Words_algebra : Flight_statement /\ Identities_statement /\ Words_reversal_statement /\
  W1_statement /\ W2_statement.
Proof. exact (conj Flight (conj Identities (conj Words_reversal (conj W1 W2)))). Qed.

Theorem Words : Path_statement /\ W3_statement /\ W5_neighbours_statement /\ W5_statement /\
  W4_statement /\ W6_statement /\ Regions_statement.
Proof.
  exact (conj Path (conj W3 (conj W5_neighbours (conj W5 (conj W4 (conj W6 Regions)))))).
Qed.

Theorem Words_orbits : Word_ends_statement /\ Cycle_statement /\ Shift_orbits_statement /\
  Word_orbits_statement.
Proof. exact (conj Word_ends (conj Chaos (conj Shift_orbits Word_orbits))). Qed.

Theorem V_finite : V_finite_statement. Proof. exact WordOrbits.V_finite. Qed.

Theorem Words_examples : Pattern_1_2_statement /\ Resonance_statement /\ Oscillator_statement /\
  Five_periods_statement /\ Boundary_statement.
Proof.
  exact (conj Pattern_1_2 (conj Resonance (conj Oscillator (conj Five_periods Boundary)))).
Qed.

Theorem Words_oracle : Words_oracle_statement. Proof. exact WordsZ.Words_oracle. Qed.
