(** * The main theorems about the rest of the plane, appendix B, the linear problem and
    the oracle over Z, by name *)

From Coq Require Import Reals ZArith.
From Grazing Require Import Defs Statement StatementPlane StatementImpacts StatementB StatementZ StatementCircleZ
  AppendixA Region4 Coordinates InsideTriangle MatrixForm Impacts Summary LeftmostSection Reverse AppendixB OrbitZ
  CircleZ.

Theorem S5 : S5_statement. Proof. exact Region4.S5. Qed.
Theorem S5_section : S5_section_statement. Proof. exact LeftmostSection.S5_section. Qed.
Theorem Joined : Joined_statement. Proof. exact LeftmostSection.Joined. Qed.

Theorem Summary_by_period : Period1_statement /\ Period2_statement /\ Summary_statement.
Proof. exact (conj Period1 (conj Period2 Summary)). Qed.

Theorem Appendix_A : Region1_statement /\ Region2_statement /\ Region5_statement /\ Lines_statement.
Proof. exact (conj Region1 (conj Region2 (conj Region5 Lines))). Qed.

Theorem Coordinates_Reversal : Coordinates_statement /\ Reversal_statement.
Proof. exact (conj Coordinates Reversal). Qed.

Theorem Record_form : Record_identity_statement /\ Record_statement.
Proof. exact (conj Record_identity Record_form). Qed.

Theorem Matrix_form : Matrix_statement /\ Trace_statement.
Proof. exact (conj Matrix_form Trace_form). Qed.

Theorem Impact_patterns : Impacts_statement /\ Single_impact_statement /\ Det_D_statement.
Proof. exact (conj Impacts (conj Single_impact Det_D)). Qed.

Theorem Large_eigenvalue : Large_formula_statement /\ Large_statement.
Proof. exact (conj Large_formula Large). Qed.

Theorem Appendix_B : B_formulas_statement /\ B_zeros_statement /\ B_simple_zero_statement /\ B_double_zero_statement /\
  B_at_multiples_statement /\ B_at_odd_multiples_statement.
Proof.
  exact
    (conj B_formulas (conj B_zeros (conj B_simple_zero (conj B_double_zero (conj B_at_multiples B_at_odd_multiples))))).
Qed.

Theorem Oracle : Oracle_statement.
Proof. exact Oracle. Qed.

Theorem Circle : Sides_statement /\ Circle_statement. Proof. exact (conj Sides CircleZ.Circle). Qed.
