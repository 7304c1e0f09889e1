(** * The theorems about orbits of maps, by name, with the axioms each rests on *)

From Grazing Require Import StatementAffine AffineOrbits.

Theorem Theorem1_for_the_affine_map : Theorem1_statement_affine. Proof. exact Theorem1_affine. Qed.

Print Assumptions Theorem1_for_the_affine_map.
