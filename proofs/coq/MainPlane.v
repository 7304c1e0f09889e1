(** * The theorems of [StatementPlane], [StatementB] and [DefsQ], and what each rests on

    Few conjunctions instead of many theorems: one walk through the library takes
    Coq half a second. *)

From Coq Require Import Reals QArith Qreals.
From Grazing Require Import Defs Statement StatementPlane StatementB AppendixA Region4
  Coordinates InsideTriangle MatrixForm Summary LeftmostSection Reverse AppendixB DefsQ.

Theorem S5_and_section : S5_statement /\ S5_section_statement /\ Joined_statement.
Proof. exact (conj S5 (conj S5_section Joined)). Qed.

Theorem Summary_by_period : Period1_statement /\ Period2_statement /\ Region1_statement /\
  Region2_statement /\ Region5_statement /\ Lines_statement /\ Coordinates_statement /\
  Summary_statement /\ Reversal_statement.
Proof.
  exact (conj Period1 (conj Period2 (conj Region1 (conj Region2 (conj Region5
    (conj Lines (conj Coordinates (conj Summary Reversal)))))))).
Qed.

Theorem Large_Record_Matrix : Large_statement /\ Record_identity_statement /\
  Record_statement /\ Matrix_statement /\ Trace_statement.
Proof.
  exact (conj Large (conj Record_identity (conj Record_form (conj Matrix_form Trace_form)))).
Qed.

Theorem Appendix_B : B_formulas_statement /\ B_zeros_statement /\
  B_simple_zero_statement /\ B_double_zero_statement /\ B_at_multiples_statement /\
  B_at_odd_multiples_statement.
Proof.
  exact (conj B_formulas (conj B_zeros (conj B_simple_zero (conj B_double_zero
    (conj B_at_multiples B_at_odd_multiples))))).
Qed.

Theorem Rational_values : forall a1 a2 n k, Q2R (uQ a1 a2 n) = u (Q2R a1) (Q2R a2) n /\
  (~ uQ a1 a2 n == 0 -> Q2R (bQ a1 a2 n k) = b (Q2R a1) (Q2R a2) n k /\
                        Q2R (cQ a1 a2 n) = c (Q2R a1) (Q2R a2) n)%Q /\
  forall e g, orbitQ a1 a2 n e g = true <-> orbit (Q2R a1) (Q2R a2) n e g.
Proof.
  intros a1 a2 n k; refine (conj (uQ_u _ _ _) (conj _ (orbitQ_orbit a1 a2 n))).
  intros Hu; split; [apply bQ_b | apply cQ_c]; exact Hu.
Qed.

Print Assumptions S5_and_section.
Print Assumptions Summary_by_period.
Print Assumptions Large_Record_Matrix.
Print Assumptions Appendix_B.
Print Assumptions Rational_values.
