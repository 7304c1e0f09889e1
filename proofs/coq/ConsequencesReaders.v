(** * What the readers' statements say of the certificates worked by hand in the heads of the checker's modules

    As in [Consequences]: each lemma takes the statement as its hypothesis. *)

From Coq Require Import Reals ZArith List Arith Lra Lia.
From Grazing Require Import Defs Statement StatementWords StatementCircleZ StatementReaders StatementReaderWords.
Import ListNotations. Open Scope R_scope.

(** Period 4 on r = 1. *)
Definition block_4 : list claim := [Orbit (0, 1) (1, 8) Minus Plus; Singular (1, 8); Orbit (1, 8) (1, 4) Plus Plus; Singular (1, 4);
  Orbit (1, 4) (1, 3) Plus Minus; Boundary (1, 3) 3; Opposite (1, 3) (3, 8) 2 1; Singular (3, 8); Opposite (3, 8) (1, 2) 1 2]%Z.

Lemma period_4 : Circle_reader_statement -> b_at 1 (7 / 20) 4 2 > 0 /\ b_at 1 (7 / 20) 4 1 < 0 /\ u_at 1 (3 / 8) 4 = 0 /\
  b_at 1 (1 / 3) 4 3 = 0 /\ orbit_at 1 (3 / 10) 4 Plus Minus /\ interval 4 Plus Minus (1 / 4) (1 / 3) /\
  ~ interval 4 Plus Minus (3 / 8) (1 / 2).
Proof.
  intros H; destruct (H 4%nat block_4 ltac:(lia) eq_refl) as [A B]; specialize (B ltac:(lia)); unfold block_4 in *.
  assert (At : forall s t, 0 < s < 1 / 2 -> In t block_4 -> there t s -> says 4 s t) by (intros s t Hs; apply (A s Hs)).
  pose proof (At (7 / 20) (Opposite (1, 3) (3, 8) 2 1)%Z ltac:(lra) ltac:(cbn; tauto) ltac:(unfold there, fraction; cbn [fst snd]; lra)) as (_ & _ & _ & X1 & X2).
  pose proof (At (3 / 8) (Singular (3, 8))%Z ltac:(lra) ltac:(cbn; tauto) eq_refl) as X3.
  pose proof (At (1 / 3) (Boundary (1, 3) 3)%Z ltac:(lra) ltac:(cbn; tauto) eq_refl) as (_ & _ & X4 & _).
  pose proof (At (3 / 10) (Orbit (1, 4) (1, 3) Plus Minus)%Z ltac:(lra) ltac:(cbn; tauto) ltac:(unfold there, fraction; cbn [fst snd]; lra)) as X5.
  split; [exact X1|]; split; [exact X2|]; split; [exact X3|]; split; [exact X4|]; split; [exact X5|]; split.
  - apply B; exists (1, 4)%Z, (1, 3)%Z; split; [cbn; tauto | split; reflexivity].
  - intros X; apply B in X; destruct X as (h & h' & I & E1 & E2); cbn in I.
    repeat (destruct I as [I|I]; [inversion I; subst h h'; unfold fraction in *; cbn [fst snd] in *; lra|]); destruct I.
Qed.
(** One impact in period 1 needs no sign of b, and exists in two cases. *)
Lemma period_1 : Circle_reader_statement -> forall s, 0 < s < 1 / 2 -> orbit_at 1 s 1 Plus Minus.
Proof.
  intros H s Hs; destruct (H 1%nat [Orbit (0, 1) (1, 2) Plus Minus; Orbit (0, 1) (1, 2) Minus Plus]%Z ltac:(lia) eq_refl) as [A _].
  apply (proj2 (A s Hs) (Orbit (0, 1) (1, 2) Plus Minus)%Z); [left; reflexivity | unfold there, fraction; cbn [fst snd]; lra].
Qed.

(** a1 = -1/4, a2 = 1/2: periods 1, 2 and 3 occur for e mu > 0, and no other. *)
Definition here : box := ((-1, 4), (-1, 4), (1, 2), (1, 2))%Z.
Definition rows_here := [[Some Minus; Some Plus; Some Plus]; [Some Plus; Some Plus; Some Plus]; [Some Minus; Some Plus; Some Plus]].
Lemma in_here : in_box here (- 1 / 4) (1 / 2).
Proof. unfold in_box, here, fraction; cbn [fst snd]; lra. Qed.

Lemma by_signs : Word_reader_statement -> member (- 1 / 4) (1 / 2) Plus 3 /\ lettered (- 1 / 4) (1 / 2) 3 U /\ b (- 1 / 4) (1 / 2) 4 1 < 0 /\
  p (- 1 / 4) (1 / 2) 3 - q (- 1 / 4) (1 / 2) 1 > 0 /\ p (- 1 / 4) (1 / 2) 1 - q (- 1 / 4) (1 / 2) 3 < 0.
Proof.
  intros H; destruct (H 96%Z here Plus [Occurs D; Occurs U; Occurs U; Absent 1] rows_here _ _ eq_refl in_here) as [L Rw].
  cbn [length seq occurring] in *; inversion_clear L as [|? ? ? ? _ L2]; inversion_clear L2 as [|? ? ? ? _ L3].
  inversion_clear L3 as [|? ? ? ? P3 L4]; inversion_clear L4 as [|? ? ? ? P4 _].
  cbn [period_says] in P3, P4; destruct P3 as [M X], P4 as (_ & _ & A); cbn [sgn] in A.
  split; [exact M|]; split; [exact X|]; split; [lra|]; unfold rows_say, rows_here in Rw.
  inversion_clear Rw as [|? ? ? ? R1 R2]; inversion_clear R2 as [|? ? ? ? _ R3]; inversion_clear R3 as [|? ? ? ? R4 _].
  inversion_clear R1 as [|? ? ? ? _ R5]; inversion_clear R5 as [|? ? ? ? _ R6]; inversion_clear R6 as [|? ? ? ? Y _].
  inversion_clear R4 as [|? ? ? ? Z1 _]; cbn [marked fst snd sgn] in *; split; lra.
Qed.

Lemma by_theorem : Path_reader_statement -> forall n, member (- 1 / 4) (1 / 2) Plus n <-> n = 1%nat \/ n = 2%nat \/ n = 3%nat.
Proof.
  intros H n; destruct (H 96%Z here 3%Z 2%nat 4%nat [U] (Ends D) rows_here _ _ eq_refl in_here) as (_ & V & _ & i & j & _ & All).
  cbn [vertices periods Nat.add map fst] in *; rewrite Forall_forall in V; split.
  - intros Hn; destruct (All n Hn) as [I|[E _]]; [cbn in I; intuition | discriminate].
  - intros [->|[->| ->]]; [apply (V (1%nat, D)) | apply (V (2%nat, U)) | apply (V (3%nat, U))]; cbn; tauto.
Qed.
Lemma rows_by_theorem : Path_reader_statement -> p (- 1 / 4) (1 / 2) 1 - q (- 1 / 4) (1 / 2) 3 < 0 /\ lettered (- 1 / 4) (1 / 2) 1 D.
Proof.
  intros H; destruct (H 96%Z here 3%Z 2%nat 4%nat [U] (Ends D) rows_here _ _ eq_refl in_here) as (_ & V & Rw & _).
  cbn [vertices periods Nat.add] in *; split; [|rewrite Forall_forall in V; apply (V (1%nat, D)); cbn; tauto]; unfold rows_say, rows_here in Rw.
  inversion_clear Rw as [|? ? ? ? _ R2]; inversion_clear R2 as [|? ? ? ? _ R3]; inversion_clear R3 as [|? ? ? ? R4 _].
  inversion_clear R4 as [|? ? ? ? Z1 _]; cbn [marked fst snd sgn] in *; lra.
Qed.

(** A box in region 4, u_4 = 0 at a1 = 1 and a2 = 1/2, and region 1. *)
Lemma a_region : Region_reader_statement -> forall a1, - 11 / 10 <= a1 <= - 1 -> a1 <= - 2 * sqrt (1 / 4).
Proof.
  intros H a1 Ha; destruct (H ((-11, 10), (-1, 1), (1, 5), (1, 4))%Z 4%Z a1 (1 / 4) eq_refl) as [_ R];
    [unfold in_box, fraction; cbn [fst snd]; lra|]; decompose [or and] R; lia || lra.
Qed.
Lemma below_4 : Below_reader_statement -> forall n, member 1 (1 / 2) Minus n <-> (1 <= n <= 3)%nat.
Proof.
  intros H n; apply (H 96%Z ((1, 1), (1, 1), (1, 2), (1, 2))%Z 3%Z 3%nat 1 (1 / 2) eq_refl); unfold in_box, fraction; cbn [fst snd]; lra.
Qed.
Lemma region_1 : Lonely_reader_statement -> forall n, (1 <= n)%nat -> member 3 (1 / 2) Plus n /\ lettered 3 (1 / 2) n U /\
  (member 3 (1 / 2) Minus n -> n = 1%nat).
Proof.
  intros H n Hn; set (B := ((3, 1), (3, 1), (1, 2), (1, 2))%Z); assert (HB : in_box B 3 (1 / 2)) by (unfold in_box, B, fraction; cbn [fst snd]; lra).
  destruct (H B 1%Z Plus true U 3 (1 / 2) eq_refl HB n) as [M L], (H B 1%Z Minus false U 3 (1 / 2) eq_refl HB n) as [M' _].
  assert (Mn : member 3 (1 / 2) Plus n) by (apply M; tauto); split; [exact Mn|]; split; [exact (L Mn)|].
  intros X; apply M' in X; destruct X as [X|[X _]]; [exact X | discriminate].
Qed.
(** r = 9/10 and s = 37/100: a1 between -9/10 of 1.3691 and of 1.369, a2 = 81/100. *)
Lemma a_polar_point : Polar_reader_statement -> - 123219 / 100000 <= trace (9 / 10) (37 / 100) <= - 12321 / 10000 /\ (9 / 10) ^ 2 = 81 / 100.
Proof.
  intros H; destruct (polarZ (9, 10)%Z (37, 100)%Z (-13691, 10000)%Z (-1369, 1000)%Z) as [B|] eqn:E; [|vm_compute in E; discriminate].
  pose proof (H _ _ _ _ B E) as I; vm_compute in E; injection E as <-; unfold in_box, fraction in I; cbn [fst snd] in I; lra.
Qed.

(** A certificate with one letter, slow impacts one period apart; and what its one motion does at nu = 1/2. *)
From Coq Require Import ZArith QArith Qreals.
From Grazing Require StatementPaths.
Section Paths.
Import StatementPaths.
Definition slow : Certificate.t := {|
  Certificate.damping := (12 # 49, 12 # 49)%Q; Certificate.stiffness := (100 # 2401, 100 # 2401)%Q;
  Certificate.restitution := (1, 1)%Q; Certificate.depth := (0, 1)%Q; Certificate.cells := (1, 1, 1, 1)%nat;
  Certificate.behind := true; Certificate.harmonics := [(1%positive, ((1, 1), (0, 0)))]%Q;
  Certificate.window := (6 # 5)%Q; Certificate.contraction := (7 # 8)%Q; Certificate.letters := [{|
  Letter.periods := 1; Letter.after := (89 # 1000, 244 # 1000)%Q; Letter.before := (-1582 # 10000,
    -612 # 10000)%Q;
  Letter.weights := (264 # 1000, 82 # 1000)%Q; Letter.next := [0%nat] |}] |}.
Lemma a_path check : Paths_statement check -> check slow = true -> exists t v,
  89 / 2000 <= v 0%Z (t 0%Z) <= 244 / 2000 /\
  Rabs (t 1%Z - 2 * PI) < 6 / 5 /\ v 1%Z (t 1%Z) + sin (t 1%Z) = - (v 0%Z (t 1%Z) + sin (t 1%Z)).
Proof.
  intros H HX; set (M := {| Machine.c := 12 / 49; Machine.k := 100 / 2401; Machine.tau := 1; Machine.sigma :=
    1;
    Machine.nu := 1 / 2; Machine.harmonics := [(1%positive, (1, 0))] |}).
  assert (W : forall t, g M t = cos t /\ g1 M t = - sin t).
  { intros t; unfold g, g1; cbn [M Machine.harmonics over_harmonics]; rewrite !(Rmult_1_l t); split; ring. }
  destruct (H slow M (fun _ => nth 0 (Certificate.letters slow) {| Letter.periods := 1; Letter.after := (0,
    0)%Q;
    Letter.before := (0, 0)%Q; Letter.weights := (0, 0)%Q; Letter.next :=
      [] |}) (fun i => i) HX) as (t & y & v & HM & HB & _).
  - assert (G : g M 0 = 1 /\ g1 M 0 = 0) by (destruct (W 0) as [-> ->]; rewrite cos_0, sin_0; lra).
    constructor; try apply G; try (unfold in_interval, Q2R; cbn; lra).
    constructor; [|constructor]; unfold in_interval, Q2R; cbn; repeat split; lra.
  - intros i; split; [left; reflexivity | exists 0%nat; split; [left; reflexivity | reflexivity]].
  - intros i; reflexivity.
  - exists t, v; destruct (HB 0%Z 1%Z eq_refl) as [[A A'] _]; unfold Q2R in A, A'; cbn in A, A'.
    destruct (HM 0%Z 1%Z eq_refl) as [_ _ _ _ _ _ _ V], (HM 1%Z 2%Z eq_refl) as [_ T _ _ _ _ _ _].
    rewrite (proj2 (W _)) in V; cbn [M Machine.tau] in V; unfold Q2R in T; cbn in T.
    split; [split; lra|]; split; [|lra]; replace (t 1%Z - 2 * PI) with (t 1%Z - 2 * PI * 1) by ring; lra.
Qed.
End Paths.
