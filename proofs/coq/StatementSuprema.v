(** * Statement: the suprema of the entropy of words in regions 3 and 4, which no point attains

    Read [member], [edge] and [first_upper] in [StatementWords], [at_most] and [at_least] in [StatementGraphs]
    first. *)

From Coq Require Import Reals.
From Grazing Require Import Defs StatementWords StatementGraphs.
Open Scope R_scope.

(** ** The words of all patterns in a case: (52), and (64) strictly *)
Definition patterns (a1 a2 : R) (e g : sign) : graph :=
  {| vertex := member a1 a2 e; periods_of := fun n => n; joined := edge a1 a2 e g |}.
(** (+,-): z + z^2 + z^3 = 1; (+,+): (1 + z^4) (z^3/(1 - z^4) + z^2/(1 - z^3)) = 1. *)
Definition root_minus (z : R) : Prop := 0 < z < 1 /\ z + z ^ 2 + z ^ 3 = 1.
Definition root_plus (z : R) : Prop := 0 < z < 1 /\
  (1 + z ^ 4) * (z ^ 3 / (1 - z ^ 4) + z ^ 2 / (1 - z ^ 3)) = 1.
(** The suprema over regions 3 and 4, e mu > 0: no point attains them, and they are approached on r = 1. *)
Definition below (G : graph) (h : R) : Prop := exists h', h' < h /\ at_most G h'.
Definition supremum (g : sign) (h : R) : Prop :=
  (forall a1 a2 K, first_upper a1 a2 K -> below (patterns a1 a2 Plus g) h) /\
  forall h', h' < h -> exists a1 K, first_upper a1 1 K /\ at_least (patterns a1 1 Plus g) h'.
Definition Supremum_minus_statement : Prop := exists z, root_minus z /\
  0.543689012692076 < z < 0.543689012692077 /\ supremum Minus (- ln z).
Definition Supremum_plus_statement : Prop := exists z, root_plus z /\
  0.637382658446787 < z < 0.637382658446788 /\ supremum Plus (- ln z).
