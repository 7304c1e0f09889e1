(** * Statement: members, edges and patterns at rational (a1, a2), decided with integers alone

    The functions of [StatementZ] on the words of [StatementWords]. [Oracle] extracts them too. *)

From Coq Require Import Reals ZArith List.
From Grazing Require Import Defs StatementWords StatementZ.
Open Scope R_scope.

Definition Words_oracle_statement : Prop := forall x y z, (0 < z)%Z ->
  let a1 := IZR x / IZR z in let a2 := IZR y / IZR z in
  (forall e n, memberZ x y z e n = true <-> member a1 a2 e n) /\
  (forall i j, u a1 a2 i <> 0 -> u a1 a2 j <> 0 ->
   sign_of (signE x y z i j) (p a1 a2 j - q a1 a2 i) /\
   forall e g, edgeZ x y z e g i j = true <-> edge a1 a2 e g i j) /\
  forall e g l, patternZ x y z e g l = true <-> pattern a1 a2 e g l.
