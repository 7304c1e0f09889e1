(** * The theorems of [StatementPlane], [StatementB] and [DefsQ], and what each rests on *)

From Grazing Require Import Defs Statement StatementPlane AppendixA Region4 Coordinates
  InsideTriangle MatrixForm Summary LeftmostSection StatementB AppendixB Eight DefsQ.

Print Assumptions Period1.
Print Assumptions Period2.
Print Assumptions Region1.
Print Assumptions Region2.
Print Assumptions Region5.
Print Assumptions Lines.
Print Assumptions S5.
Print Assumptions S5_section_from_S3.
Print Assumptions Coordinates.
Print Assumptions Summary_from_S4.
Print Assumptions Large.
Print Assumptions Record_identity.
Print Assumptions Record_form.
Print Assumptions Matrix_form.
Print Assumptions Trace_form.
Print Assumptions B_formulas.
Print Assumptions B_zeros.
Print Assumptions B_simple_zero.
Print Assumptions B_double_zero.
Print Assumptions B_at_multiples.
Print Assumptions B_at_odd_multiples.
Print Assumptions Eight.
Print Assumptions uQ_u.
Print Assumptions vQ_v.
Print Assumptions bQ_b.
Print Assumptions cQ_c.
