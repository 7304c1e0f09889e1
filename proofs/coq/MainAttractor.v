(** * The theorems about what is born beyond a touch in region 2, of maps and of overdamped oscillators,
    by name *)

From Grazing Require Import StatementAttractor Attractor AttractorGaps AttractorWindows AttractorFixed.
From Grazing Require StatementTrapped TrappedSeparate TrappedExists TrappedStarts TrappedAlmost TrappedCone
  TrappedDerivative TrappedAll TrappedExponent TrappedRange TrappedPaper TrappedExample TrappedSmall.

Theorem Wedge : Wedge_statement. Proof. exact Attractor.attractor. Qed.
Theorem Gaps_and_windows : Gaps_statement /\ Windows_statement. Proof. exact (conj gaps windows). Qed.
Theorem Grazing_map : Fixed_statement /\ Same_map_statement. Proof. exact (conj fixed same_map). Qed.

Theorem Trapped : StatementTrapped.Trapped_statement /\ StatementTrapped.Exists_statement /\
  StatementTrapped.Absorbed_statement /\ StatementTrapped.Started_statement /\ StatementTrapped.Almost_statement.
Proof.
  exact (conj TrappedSeparate.Trapped (conj TrappedExists.Exists_ (conj TrappedStarts.Absorbed (conj
    TrappedStarts.Started TrappedAlmost.Almost)))).
Qed.
Theorem Stretched : StatementTrapped.Cone_statement /\ StatementTrapped.Derivative_statement /\
  StatementTrapped.Separate_statement /\
  StatementTrapped.No_stable_statement /\ StatementTrapped.Exponent_statement.
Proof.
  exact (conj TrappedCone.Cone (conj TrappedDerivative.Derivative (conj TrappedSeparate.Separate (conj
    TrappedAll.No_stable TrappedExponent.Exponent)))).
Qed.
Theorem By_numbers : StatementTrapped.Range_statement /\ StatementTrapped.Paper_statement /\
  StatementTrapped.Example_statement /\ StatementTrapped.Small_statement.
Proof. exact (conj TrappedRange.Range (conj TrappedPaper.Paper (conj TrappedExample.Example TrappedSmall.Small))). Qed.
