(** * Each (a1, a2) with a1^2 < 4 a2 has exactly one (r, s) *)

From Coq Require Import Reals Lra.
From Grazing Require Import Defs Statement StatementPlane.
Open Scope R_scope.

Lemma two_pi_s s : 0 < s < 1 / 2 -> 0 < 2 * PI * s < PI. Proof. intros; pose proof PI_RGT_0; split; nra. Qed.

Lemma trace_injective r s s' : 0 < r -> 0 < s < 1 / 2 -> 0 < s' < 1 / 2 -> trace r s = trace r s' -> s = s'.
Proof.
  intros Hr Hs Hs' E; unfold trace in E; apply Rmult_eq_reg_l in E; [|lra].
  pose proof (two_pi_s s Hs); pose proof (two_pi_s s' Hs'); pose proof PI_RGT_0. apply cos_inj in E; [|lra..].
  apply Rmult_eq_reg_l with (2 * PI); lra.
Qed.

Lemma root_unique a r : 0 < r -> a = r ^ 2 -> r = sqrt a. Proof. intros Hr ->; rewrite sqrt_pow2; lra. Qed.

(** The angle with a given cosine, as a fraction of a full turn. *)
Lemma turn_of_cosine w : -1 < w < 1 -> exists s, 0 < s < 1 / 2 /\ cos (2 * PI * s) = w.
Proof.
  intros Hw; pose proof PI_RGT_0; pose proof (acos_bound_lt w Hw) as Ha. exists (acos w / (2 * PI)); split.
  - split; [apply Rdiv_lt_0_compat; lra |]. apply Rmult_lt_reg_r with (2 * PI); [lra|].
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
  - replace (2 * PI * (acos w / (2 * PI))) with (acos w) by (field; lra). apply cos_acos; lra.
Qed.

Theorem Coordinates : Coordinates_statement.
Proof.
  intros a1 a2 H; assert (H2 : 0 < a2) by (pose proof (pow2_ge_0 a1); lra).
  set (r := sqrt a2); assert (Hr : 0 < r) by (apply sqrt_lt_R0; assumption).
  assert (Er : a2 = r ^ 2) by (unfold r; rewrite pow2_sqrt; lra).
  destruct (turn_of_cosine (a1 / (2 * r))) as (s & Hs & Es).
  { assert (E : (a1 / (2 * r)) ^ 2 * (4 * a2) = a1 ^ 2) by (rewrite Er; field; lra).
    set (w := a1 / (2 * r)) in *; clearbody w. assert (w ^ 2 < 1) by (apply Rmult_lt_reg_r with (4 * a2); lra).
    split; nra. }
  assert (E1 : a1 = trace r s) by (unfold trace; rewrite Es; field; lra).
  exists r, s; repeat split; try assumption; try apply Hs.
  - rewrite (root_unique a2 r'); trivial.
  - assert (r' = r) as -> by (apply root_unique; assumption). apply trace_injective with r; congruence || assumption.
Qed.
