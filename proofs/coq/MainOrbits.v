(** * The theorems about orbits of maps, by name *)

From Grazing Require Import StatementOrbits Orbits StatementAffine AffineOrbits
  StatementOrbitsPeriodic PeriodicOrbits StatementOrbitsPlane PlaneOrbits StatementOrbitsInstance
  OrbitsInstance StatementOrbitsAreas OrbitsAreas StatementOrbitsPatterns PatternOrbits.

Theorem Theorem1 : Theorem1_statement. Proof. exact Orbits.Theorem1. Qed.
Theorem Theorem1_periodic : Theorem1_statement_periodic /\ Symmetry_statement.
Proof. exact (conj PeriodicOrbits.Theorem1_periodic Symmetry). Qed.
Theorem Theorem1_affine : Theorem1_statement_affine. Proof. exact AffineOrbits.Theorem1_affine. Qed.
Theorem Theorem1_plane : Theorem1_statement_plane. Proof. exact PlaneOrbits.Theorem1_plane. Qed.
Theorem Theorem1_single : Theorem1_statement_single. Proof. exact PlaneOrbits.Theorem1_single. Qed.
Theorem Meaning : Meaning_statement. Proof. exact PlaneOrbits.Meaning. Qed.
Theorem Instance : Instance_statement. Proof. exact OrbitsInstance.Instance. Qed.

(** The theorems about signs, about orbits. *)
Theorem S1_to_S5_for_orbits : S1_S3_statement_orbits /\ Theorem2_statement_orbits /\
  Conjecture1_statement_orbits.
Proof. exact (conj S1_S3_orbits (conj Theorem2_orbits Conjecture1_orbits)). Qed.
Theorem Summary_and_record_for_orbits : Summary_statement_orbits /\ Record_statement_orbits.
Proof. exact (conj Summary_orbits Record_orbits). Qed.

Theorem Patterns_for_orbits : Patterns_statement_orbits. Proof. exact Patterns_orbits. Qed.
