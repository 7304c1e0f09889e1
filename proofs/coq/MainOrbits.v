(** * Theorem 1 in any dimension, and the theorems about motions and orbits beside those of [Headline], by name *)

From Grazing Require Import StatementOrbits Orbits StatementOrbitsPeriodic PeriodicOrbits StatementOrbitsInstance
  OrbitsInstance StatementSystems Systems SystemsAreas SystemsWords.
From Grazing Require StatementUnstable OrbitsUnstable OrbitsEigenvalue.

Theorem Theorem1 : Theorem1_statement. Proof. exact Orbits.Theorem1. Qed.
Theorem Theorem1_periodic : Theorem1_statement_periodic /\ Symmetry_statement.
Proof. exact (conj PeriodicOrbits.Theorem1_periodic Symmetry). Qed.
Theorem Instance : Instance_statement. Proof. exact OrbitsInstance.Instance. Qed.
Theorem Unstable : StatementUnstable.Unstable_statement. Proof. exact OrbitsUnstable.Unstable. Qed.
Theorem Eigenvalue : StatementUnstable.Eigenvalue_statement. Proof. exact OrbitsEigenvalue.Eigenvalue. Qed.

(** The theorems about signs, about motions and orbits. *)
Theorem Single : Single_statement. Proof. exact Systems.Single. Qed.
Theorem Meaning : Meaning_statement. Proof. exact Systems.Meaning. Qed.
Theorem S1_S3 : S1_S3_statement. Proof. exact SystemsAreas.S1_S3. Qed.
Theorem Summary_and_record : Summary_systems_statement /\ Record_systems_statement.
Proof. exact (conj Summary_systems Record_systems). Qed.
Theorem Patterns : Patterns_statement /\ All_patterns_statement /\ Shift_statement.
Proof. exact (conj Systems.Patterns (conj All_patterns Shift)). Qed.
