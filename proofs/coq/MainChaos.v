(** * What else is proved about the chaos of [Headline], by name *)

From Grazing Require Import StatementChaos Chaos ChaosThree ChaosContinuous.

Theorem Chaos_distinct : Chaos_distinct_statement. Proof. exact Chaos.Chaos_distinct. Qed.
Theorem Chaos_periodic : Chaos_periodic_statement. Proof. exact Chaos.Chaos_periodic. Qed.
Theorem Chaos_continuous : Chaos_continuous_statement. Proof. exact ChaosContinuous.Chaos_continuous. Qed.
Theorem Chaos_three : Chaos_three_statement. Proof. exact ChaosThree.Chaos_three. Qed.
