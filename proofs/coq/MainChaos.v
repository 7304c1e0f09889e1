(** * The theorems about the paper's oscillator, by name *)

From Grazing Require Import StatementChaos Chaos ChaosContinuous.

Theorem Chaos_oscillator : Chaos_oscillator_statement. Proof. exact Chaos.Chaos_oscillator. Qed.
Theorem Chaos_distinct : Chaos_distinct_statement. Proof. exact Chaos.Chaos_distinct. Qed.
Theorem Chaos_periodic : Chaos_periodic_statement. Proof. exact Chaos.Chaos_periodic. Qed.
Theorem Chaos_continuous : Chaos_continuous_statement. Proof. exact ChaosContinuous.Chaos_continuous. Qed.
