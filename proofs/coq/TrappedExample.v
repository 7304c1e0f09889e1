(** * With d = 3/2, w = 8, tau = 4/5 every return separates, for all mu to 1/10: the check by intervals *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import ChaosInterval ChaosFunctions TrapsCheck TrapsNumbers.
From Grazing Require Import StatementTrapped TrappedRange TrappedPaper.
Open Scope R_scope.

(** Worse numbers than those of the paper's oscillators with 0 < mu <= 1/10. *)
Definition limit : machine := {| a := (3 / 2 - sqrt ((3 / 2) ^ 2 - 1)) / 8; b := (3 / 2 + sqrt ((3 / 2) ^ 2 -
  1)) / 8;
  tau := 4 / 5; p := 2 * PI; W := 43 / 50; mu := 1 / 10; al0 := 1; al1 := 11 / 10;
  zm := IZR 786650 / IZR 10000000 * (1 / 10); Vm := IZR 757575 / IZR 1000000 * sqrt (1 / 10);
  Q := fun _ => 0; Q1 := fun _ => 0; Q2 := fun _ => 0 |}.

Definition rootI := root (constant 5 4).
Definition limit_inputs : inputs := {| aI := quo (minus (constant 3 2) rootI) (constant 8 1); bI := quo (plus (constant
  3
  2) rootI) (constant 8 1); dI := quo rootI (constant 4 1); tI := constant 4 5; nI := constant 1 10; wI := constant 43
    50;
  lowI := constant 1 1; topI := constant 11 10; speedI := constant 757575 1000000; slipI := constant 786650 10000000 |}.
Lemma limit_checked : checked limit (201 / 200) 11.
Proof.
  assert (r : 0 < sqrt ((3 / 2) ^ 2 - 1) < 3 / 2).
  { split; [apply sqrt_lt_R0; lra|]; rewrite <- (sqrt_square (3 / 2)) at 2 by lra; apply sqrt_lt_1_alt; lra. }
  assert (W1 : forall z, mem (constant z 1) (IZR z)) by exact PathsLegs.mem_integer.
  assert (Mr : mem rootI (sqrt ((3 / 2) ^ 2 - 1))) by (replace ((3 / 2) ^ 2 - 1) with (5 / 4) by field; apply mem_root,
    mem_constant).
  refine (n_checked _ _ _ _ _ _ (numbers_checked limit_inputs limit (IZR 757575 / IZR 1000000) (IZR 786650 / IZR
    10000000) (201 / 200) (constant 201 200) 11 _ (mem_constant _ _) eq_refl _ _ _ _ _ eq_refl eq_refl _)); try (cbn;
    lra).
  - constructor; try exact (mem_constant _ _); try exact (W1 1%Z); unfold limit_inputs; cbn [aI bI dI a b limit].
    + apply mem_quo; [apply mem_minus; [apply mem_constant | exact Mr] | apply W1].
    + apply mem_quo; [apply mem_plus; [apply mem_constant | exact Mr] | apply W1].
    + replace ((3 / 2 + sqrt _) / 8 - _) with (sqrt ((3 / 2) ^ 2 - 1) / 4) by field; apply mem_quo; [exact Mr | apply
      W1].
  - change (0 < (3 / 2 - sqrt ((3 / 2) ^ 2 - 1)) / 8 < (3 / 2 + sqrt ((3 / 2) ^ 2 - 1)) / 8); lra.
  - vm_compute; reflexivity.
Qed.

Theorem Example : Example_statement.
Proof.
  intros mu Hm; apply (Range limit _ 11%Z); [exact limit_checked|apply Paper; lra|]. constructor; cbn; try lra;
    [|exists (IZR 786650 / IZR 10000000), (IZR 757575 / IZR 1000000); repeat split; lra].
  set (h := acos (/ (1 + mu))). assert (I : 10 / 11 <= / (1 + mu) <= 1).
  { split; [replace (10 / 11) with (/ (11 / 10)) by field|rewrite <- Rinv_1]; apply Rinv_le_contravar; lra. }
  assert (C : cos h = / (1 + mu)) by (apply cos_acos; lra); destruct (acos_bound (/ (1 + mu))) as [b1 b2]; fold h in b1,
    b2. assert (K : cos (43 / 100) <= 10 / 11).
  { apply (below_le (cosine (constant 43 100)) (constant 10 11)); [vm_compute; reflexivity|apply mem_cosine|]; apply
    mem_constant. }
  apply Rnot_lt_le; intros F; pose proof PI2_3_2; assert (cos h < cos (43 / 100)); [|lra].
  apply cos_decreasing_1; lra.
Qed.
