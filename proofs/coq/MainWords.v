(** * The theorems about words, by name *)

From Grazing Require Import StatementWords WordAlgebra WordPlane StatementExamples WordExamples
  WordChaos SystemsWords StatementWordsZ WordsZ.

Theorem Words_algebra : Flight_statement /\ Identities_statement /\ Words_reversal_statement /\
  W1_statement /\ W2_statement.
Proof. exact (conj Flight (conj Identities (conj Words_reversal (conj W1 W2)))). Qed.

Theorem Words_plane : Path_statement /\ W3_statement /\ W5_neighbours_statement /\ W5_statement /\
  W4_statement /\ W6_statement /\ Regions_statement.
Proof. exact (conj Path (conj W3 (conj W5_neighbours (conj W5 (conj W4 (conj W6 Regions)))))). Qed.

Theorem V_and_cycles : V_finite_statement /\ Cycle_statement. Proof. exact (conj V_finite Cycles). Qed.

Theorem Words_examples : Pattern_1_2_statement /\ Resonance_statement /\ Oscillator_statement /\
  Five_periods_statement /\ Boundary_statement.
Proof. exact (conj Pattern_1_2 (conj Resonance (conj Oscillator (conj Five_periods Boundary)))). Qed.

Theorem Words_oracle : Words_oracle_statement. Proof. exact WordsZ.Words_oracle. Qed.
