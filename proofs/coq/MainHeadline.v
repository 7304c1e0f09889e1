(** * The six theorems, by name *)

From Grazing Require Import Headline Systems SystemsAreas Conjecture1 SystemsWords.
From Grazing Require Chaos TrappedAttracts.

Theorem Theorem_1 : Theorem_1_statement. Proof. exact Systems.Theorem_1. Qed.
Theorem Theorem_2 : Theorem_2_statement. Proof. exact SystemsAreas.Theorem_2. Qed.
Theorem Conjecture_1 : Conjecture_1_statement. Proof. exact Conjecture1.Conjecture_1. Qed.
Theorem Words : Words_statement. Proof. exact SystemsWords.Words. Qed.
Theorem Chaos : Chaos_statement. Proof. exact Chaos.Chaos_oscillator. Qed.
Theorem Attractor : Attractor_statement. Proof. exact TrappedAttracts.Attractor. Qed.
