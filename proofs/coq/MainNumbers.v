(** * The theorems about lengths, times of return, entropy, words of graphs and more dimensions, by name *)

From Grazing Require Import StatementMeasure Measure StatementReturns ReturnTimes StatementEntropy Entropy
  StatementUniform Uniform StatementGraphs GraphEntropy StatementSuprema Suprema.

Theorem Measure : Measure_statement. Proof. exact Measure.Measure. Qed.
Theorem Returns : Returns_statement. Proof. exact ReturnTimes.Returns. Qed.
Theorem Entropy : Period_map_statement /\ Entropy_statement /\ Growth_statement.
Proof. exact (conj Period_map (conj Entropy.Entropy Growth)). Qed.
Theorem Uniform : Uniform_statement. Proof. exact Uniform.Uniform. Qed.
Theorem Graph_entropy : Graph_entropy_statement. Proof. exact GraphEntropy.Graph_entropy. Qed.
Theorem Suprema : Supremum_minus_statement /\ Supremum_plus_statement.
Proof. exact (conj Supremum_minus Supremum_plus). Qed.
