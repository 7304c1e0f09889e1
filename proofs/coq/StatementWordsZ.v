(** * Statement: members, edges and patterns at rational (a1, a2), decided with integers alone

    The functions of [StatementZ] on the words of [StatementWords]. [Oracle] extracts them too. *)

From Coq Require Import Reals ZArith List.
From Grazing Require Import Defs StatementWords StatementZ.
Open Scope R_scope.

Definition Words_oracle_statement : Prop := forall p s q, (0 < q)%Z ->
  let a1 := IZR p / IZR q in let a2 := IZR s / IZR q in
  (forall e n, memberZ p s q e n = true <-> member a1 a2 e n) /\
  (forall i j, u a1 a2 i <> 0 -> u a1 a2 j <> 0 ->
   sign_of (signE p s q i j) (StatementWords.p a1 a2 j - StatementWords.q a1 a2 i) /\
   forall e g, edgeZ p s q e g i j = true <-> edge a1 a2 e g i j) /\
  forall e g l, patternZ p s q e g l = true <-> pattern a1 a2 e g l.
