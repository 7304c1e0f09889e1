(** * The main theorems, by name, with the axioms each rests on *)

From Grazing Require Import Defs Statement Farey Disc Radius Count Graph Sections Eight.

Theorem Neighbours : Neighbours_statement. Proof. exact neighbours_proof. Qed.
Theorem S1 : S1_statement. Proof. exact S1_proof. Qed.
Theorem S2 : S2_statement. Proof. exact S2_proof. Qed.
Theorem S3 : S3_statement. Proof. exact S3_proof. Qed.
Theorem Theorem2 : Theorem2_statement. Proof. exact Theorem2_proof. Qed.
Theorem Theorem2_count : Theorem2_count_statement. Proof. exact count_proof. Qed.
Theorem Theorem2_tree : Theorem2_tree_statement. Proof. exact tree_proof. Qed.
Theorem S4 : S4_statement. Proof. exact S4_proof. Qed.
Theorem S4_graph : S4_graph_statement. Proof. exact S4_graph_proof. Qed.
Theorem S4_section : S4_section_statement. Proof. exact S4_section_proof. Qed.
Theorem Period_8 : Period_8_statement. Proof. exact period_8_proof. Qed.

Print Assumptions Neighbours.
Print Assumptions S1.
Print Assumptions S2.
Print Assumptions S3.
Print Assumptions Theorem2.
Print Assumptions Theorem2_count.
Print Assumptions Theorem2_tree.
Print Assumptions S4.
Print Assumptions S4_graph.
Print Assumptions S4_section.
Print Assumptions Period_8.
