(** * The main theorems about signs in region 3, by name *)

From Grazing Require Import Defs Statement StatementExamples Cases Farey Disc Radius Count Above Sections Eight Depth.

Theorem One_case : One_case_statement. Proof. exact Cases.One_case. Qed.
Theorem Neighbours : Neighbours_statement. Proof. exact neighbours_proof. Qed.
Theorem S1 : S1_statement. Proof. exact S1_stated. Qed.
Theorem S2 : S2_statement. Proof. exact S2_proof. Qed.
Theorem S3 : S3_statement. Proof. exact S3_stated. Qed.
Theorem Theorem2 : Theorem2_statement. Proof. exact Theorem2_stated. Qed.
Theorem Theorem2_count : Theorem2_count_statement. Proof. exact count_proof. Qed.
Theorem Deciding_indices : Deciding_indices_statement. Proof. exact deciding_indices_stated. Qed.
Theorem Theorem2_tree : Theorem2_tree_statement. Proof. exact tree_proof. Qed.
Theorem S4 : S4_statement. Proof. exact S4_stated. Qed.
Theorem S4_ends : S4_ends_statement. Proof. exact S4_ends_stated. Qed.
Theorem S4_section : S4_section_statement. Proof. exact S4_section_proof. Qed.
Theorem Period_8 : Period_8_statement. Proof. exact (period_8_from_Theorem2 Theorem2_stated). Qed.
Theorem Depth : Depth_statement. Proof. exact Depth.Depth. Qed.
