(** * The theorems about orbits of maps, by name, with the axioms each rests on *)

From Grazing Require Import StatementOrbits Orbits StatementAffine AffineOrbits
  StatementOrbitsPlane PlaneOrbits.

Theorem Theorem1 : Theorem1_statement. Proof. exact Orbits.Theorem1. Qed.
Theorem Theorem1_affine : Theorem1_statement_affine. Proof. exact AffineOrbits.Theorem1_affine. Qed.
Theorem Theorem1_plane : Theorem1_statement_plane. Proof. exact PlaneOrbits.Theorem1_plane. Qed.
Theorem Theorem1_single : Theorem1_statement_single. Proof. exact PlaneOrbits.Theorem1_single. Qed.
Theorem Meaning : Meaning_statement. Proof. exact PlaneOrbits.Meaning. Qed.

Print Assumptions Theorem1.
Print Assumptions Theorem1_affine.
Print Assumptions Theorem1_plane.
Print Assumptions Theorem1_single.
Print Assumptions Meaning.
