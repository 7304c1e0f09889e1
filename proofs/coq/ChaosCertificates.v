(** * Two certificates of the paper's oscillator pass the check: {1, 2} for every mu > 0, {1, 2,
  3} for mu <= 0.003

    The boxes and weights are those of crates/checker/tests/data/chaos-12.txt and chaos-123.txt. *)

From Coq Require Import QArith List.
From Grazing Require Import StatementPaths PathsCheck.
Import ListNotations.
Open Scope Q_scope.

(** The paper's oscillator, d = 0.6, w = 4.9 and restitution 1; nu = mu/(1 + mu). *)
Definition paper (depth : Q * Q) (cells : nat) (contraction : Q) (letters : list Letter.t) : Certificate.t :=
  {|
  Certificate.damping := (12 # 49, 12 # 49); Certificate.stiffness := (100 # 2401, 100 # 2401);
  Certificate.restitution := (1, 1); Certificate.depth := depth; Certificate.cells := (1, 1, 1, cells)%nat;
  Certificate.behind := true; Certificate.harmonics := [(1%positive, ((1, 1), (0, 0)))];
  Certificate.window := 6 # 5; Certificate.contraction := contraction; Certificate.letters := letters |}.

Definition one : Letter.t := {| Letter.periods := 1; Letter.after := (89 # 1000, 244 # 1000);
  Letter.before := (-1582 # 10000, -612 # 10000); Letter.weights := (264121084 # 1000000000,
    82075454 # 1000000000);
  Letter.next := [0; 1]%nat |}.
Definition two : Letter.t := {| Letter.periods := 2; Letter.after := (615 # 1000, 1036 # 1000);
  Letter.before := (-367 # 1000, -140 # 1000); Letter.weights := (1, 310435706 # 1000000000);
  Letter.next := [0; 1]%nat |}.
Definition chaos_12 : Certificate.t := paper (0, 1) 1 (875 # 1000) [one; two].

Definition one' : Letter.t := {| Letter.periods := 1; Letter.after := (28 # 1000, 196 # 1000);
  Letter.before := (-1137 # 10000, -1010 # 10000); Letter.weights := (11007365 # 1000000000,
    731229 # 1000000000);
  Letter.next := [0; 1; 2]%nat |}.
Definition two' : Letter.t := {| Letter.periods := 2; Letter.after := (481 # 1000, 829 # 1000);
  Letter.before := (-2509 # 10000, -1638 # 10000); Letter.weights := (22847176 # 1000000000,
    5609227 # 1000000000);
  Letter.next := [0; 1; 2]%nat |}.
Definition three' : Letter.t := {| Letter.periods := 3; Letter.after := (169 # 10, 323 # 10);
  Letter.before := (-334 # 100, -175 # 100); Letter.weights := (1, 102973657 # 1000000000);
  Letter.next := [0; 1; 2]%nat |}.
Definition chaos_123 : Certificate.t := paper (0, 3 # 1003) 1 (928 # 1000) [one'; two'; three'].

Lemma checked_12 : check chaos_12 = true. Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma checked_123 : check chaos_123 = true. Proof. vm_cast_no_check (eq_refl true). Qed.
