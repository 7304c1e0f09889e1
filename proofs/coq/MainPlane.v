(** * The theorems of [StatementPlane] and [DefsQ], and what each rests on *)

From Grazing Require Import Defs Statement StatementPlane AppendixA Region4 Coordinates
  InsideTriangle MatrixForm Summary DefsQ.

Print Assumptions Period1.
Print Assumptions Period2.
Print Assumptions Region1.
Print Assumptions Region2.
Print Assumptions Region5.
Print Assumptions Lines.
Print Assumptions S5.
Print Assumptions Coordinates.
Print Assumptions Summary_from_S4.
Print Assumptions Large.
Print Assumptions Record_identity.
Print Assumptions Record_form.
Print Assumptions Matrix_form.
Print Assumptions Trace_form.
Print Assumptions uQ_u.
Print Assumptions vQ_v.
Print Assumptions bQ_b.
Print Assumptions cQ_c.
