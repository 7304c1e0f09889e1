(** * The theorems about orbits of maps, by name, with the axioms each rests on *)

From Grazing Require Import StatementOrbits Orbits StatementAffine AffineOrbits.

Theorem Theorem1 : Theorem1_statement. Proof. exact Orbits.Theorem1. Qed.
Theorem Theorem1_affine : Theorem1_statement_affine. Proof. exact AffineOrbits.Theorem1_affine. Qed.

Print Assumptions Theorem1.
Print Assumptions Theorem1_affine.
