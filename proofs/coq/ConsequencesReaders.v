(** * What the readers' statements say of the certificates worked by hand in the heads of the checker's
    modules

    As in [Consequences]: each lemma takes the statement as its hypothesis. *)

From Coq Require Import Reals ZArith List Arith Lra Lia.
From Grazing Require Import Defs Statement StatementWords StatementCircleZ StatementReaders StatementReaderWords.
Import ListNotations. Open Scope R_scope.

(** Period 4 on r = 1. *)
Definition block_4 : list claim := [Orbit (0, 1) (1, 8) Minus Plus; Singular (1, 8); Orbit (1, 8) (1, 4) Plus Plus;
  Singular (1, 4); Orbit (1, 4) (1, 3) Plus Minus; Boundary (1, 3) 3; Opposite (1, 3) (3, 8) 2 1; Singular (3, 8);
  Opposite (3, 8) (1, 2) 1 2]%Z.

Lemma period_4 : Circle_reader_statement -> b_at 1 (7 / 20) 4 2 > 0 /\ b_at 1 (7 / 20) 4 1 < 0 /\ u_at 1 (3 / 8) 4 = 0
  /\ b_at 1 (1 / 3) 4 3 = 0 /\ orbit_at 1 (3 / 10) 4 Plus Minus /\ interval 4 Plus Minus (1 / 4) (1 / 3) /\
  ~ interval 4 Plus Minus (3 / 8) (1 / 2).
Proof.
  intros H; destruct (H 4%nat block_4 ltac:(lia) eq_refl) as [A B]; specialize (B ltac:(lia)); unfold block_4 in *.
  assert (At : forall s t, 0 < s < 1 / 2 -> In t block_4 -> there t s -> says 4 s t) by (intros s t Hs; apply (A s Hs)).
  pose proof (At (7 / 20) (Opposite (1, 3) (3, 8) 2 1)%Z ltac:(lra) ltac:(cbn; tauto) ltac:(unfold there, fraction;
    cbn [fst snd]; lra)) as (_ & _ & _ & X1 & X2).
  pose proof (At (3 / 8) (Singular (3, 8))%Z ltac:(lra) ltac:(cbn; tauto) eq_refl) as X3.
  pose proof (At (1 / 3) (Boundary (1, 3) 3)%Z ltac:(lra) ltac:(cbn; tauto) eq_refl) as (_ & _ & X4 & _).
  pose proof (At (3 / 10) (Orbit (1, 4) (1, 3) Plus Minus)%Z ltac:(lra) ltac:(cbn; tauto) ltac:(unfold there, fraction;
    cbn [fst snd]; lra)) as X5.
  split; [exact X1|]; split; [exact X2|]; split; [exact X3|]; split; [exact X4|]; split; [exact X5|]; split.
  - apply B; exists (1, 4)%Z, (1, 3)%Z; split; [cbn; tauto | split; reflexivity].
  - intros X; apply B in X; destruct X as (h & h' & I & E1 & E2); cbn in I.
    repeat (destruct I as [I|I]; [inversion I; subst h h'; unfold fraction in *; cbn [fst snd] in *; lra|]); destruct I.
Qed.
(** One impact in period 1 needs no sign of b, and exists in two cases. *)
Lemma period_1 : Circle_reader_statement -> forall s, 0 < s < 1 / 2 -> orbit_at 1 s 1 Plus Minus.
Proof.
  intros H s Hs; destruct (H 1%nat [Orbit (0, 1) (1, 2) Plus Minus; Orbit (0, 1) (1, 2) Minus Plus]%Z ltac:(lia)
    eq_refl) as [A _].
  apply (proj2 (A s Hs) (Orbit (0, 1) (1, 2) Plus Minus)%Z); [left; reflexivity | unfold there, fraction; cbn [fst snd];
    lra].
Qed.

(** a1 = -1/4, a2 = 1/2: periods 1, 2 and 3 occur for e mu > 0, and no other. *)
Definition here : box := ((-1, 4), (-1, 4), (1, 2), (1, 2))%Z.
Definition rows_here := [[Some Minus; Some Plus; Some Plus]; [Some Plus; Some Plus; Some Plus];
  [Some Minus; Some Plus; Some Plus]].
Lemma in_here : in_box here (- 1 / 4) (1 / 2). Proof. unfold in_box, here, fraction; cbn [fst snd]; lra. Qed.
Lemma in_here_means a1 a2 : in_box here a1 a2 -> a2 = 1 / 2 /\ a1 = - 1 / 4.
Proof. unfold in_box, here, fraction; cbn [fst snd]; intros [A B]; lra. Qed.
Lemma by_signs : Word_reader_statement -> member (- 1 / 4) (1 / 2) Plus 3 /\ lettered (- 1 / 4) (1 / 2) 3 U /\
  b (- 1 / 4) (1 / 2) 4 1 < 0 /\ p (- 1 / 4) (1 / 2) 3 - q (- 1 / 4) (1 / 2) 1 > 0 /\ p (- 1 / 4) (1 / 2) 1 - q
  (- 1 / 4) (1 / 2) 3 < 0.
Proof.
  intros H; destruct (H 96%Z here Plus [Occurs D; Occurs U; Occurs U; Absent 1] rows_here _ _ eq_refl in_here)
    as [L Rw].
  cbn [length seq occurring] in *; inversion_clear L as [|? ? ? ? _ L2]; inversion_clear L2 as [|? ? ? ? _ L3].
  inversion_clear L3 as [|? ? ? ? P3 L4]; inversion_clear L4 as [|? ? ? ? P4 _].
  cbn [period_says] in P3, P4; destruct P3 as [M X], P4 as (_ & _ & A); cbn [sgn] in A.
  split; [exact M|]; split; [exact X|]; split; [lra|]; unfold rows_say, rows_here in Rw.
  inversion_clear Rw as [|? ? ? ? R1 R2]; inversion_clear R2 as [|? ? ? ? _ R3]; inversion_clear R3 as [|? ? ? ? R4 _].
  inversion_clear R1 as [|? ? ? ? _ R5]; inversion_clear R5 as [|? ? ? ? _ R6]; inversion_clear R6 as [|? ? ? ? Y _].
  inversion_clear R4 as [|? ? ? ? Z1 _]; cbn [marked fst snd sgn] in *; split; lra.
Qed.
Lemma by_theorem : Path_reader_statement -> forall n, member (- 1 / 4) (1 / 2) Plus n <-> n = 1%nat \/ n = 2%nat \/
  n = 3%nat.
Proof.
  intros H n; destruct (H 96%Z here 3%Z 2%nat 4%nat [U] (Ends D) rows_here _ _ eq_refl in_here)
    as (_ & V & _ & i & j & _ & All).
  cbn [vertices periods Nat.add map fst] in *; rewrite Forall_forall in V; split.
  - intros Hn; destruct (All n Hn) as [I|[E _]]; [cbn in I; intuition | discriminate].
  - intros [->|[->| ->]]; [apply (V (1%nat, D)) | apply (V (2%nat, U)) | apply (V (3%nat, U))]; cbn; tauto.
Qed.
Lemma rows_by_theorem : Path_reader_statement -> p (- 1 / 4) (1 / 2) 1 - q (- 1 / 4) (1 / 2) 3 < 0 /\
  lettered (- 1 / 4) (1 / 2) 1 D.
Proof.
  intros H; destruct (H 96%Z here 3%Z 2%nat 4%nat [U] (Ends D) rows_here _ _ eq_refl in_here) as (_ & V & Rw & _).
  cbn [vertices periods Nat.add] in *; split; [|rewrite Forall_forall in V; apply (V (1%nat, D)); cbn; tauto];
    unfold rows_say, rows_here in Rw.
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
  intros H n; apply (H 96%Z ((1, 1), (1, 1), (1, 2), (1, 2))%Z 3%Z 3%nat 1 (1 / 2) eq_refl); unfold in_box, fraction;
    cbn [fst snd]; lra.
Qed.
Lemma region_1 : Lonely_reader_statement -> forall n, (1 <= n)%nat -> member 3 (1 / 2) Plus n /\ lettered 3 (1 / 2) n U
  /\ (member 3 (1 / 2) Minus n -> n = 1%nat).
Proof.
  intros H n Hn; set (B := ((3, 1), (3, 1), (1, 2), (1, 2))%Z); assert (HB : in_box B 3 (1 / 2)) by (unfold in_box, B,
    fraction; cbn [fst snd]; lra).
  destruct (H B 1%Z Plus true U 3 (1 / 2) eq_refl HB n) as [M L], (H B 1%Z Minus false U 3 (1 / 2) eq_refl HB n)
    as [M' _].
  assert (Mn : member 3 (1 / 2) Plus n) by (apply M; tauto); split; [exact Mn|]; split; [exact (L Mn)|].
  intros X; apply M' in X; destruct X as [X|[X _]]; [exact X | discriminate].
Qed.
(** r = 9/10 and s = 37/100: a1 between -9/10 of 1.3691 and of 1.369, a2 = 81/100. *)
Lemma a_polar_point : Polar_reader_statement -> - 123219 / 100000 <= trace (9 / 10) (37 / 100) <= - 12321 / 10000 /\
  (9 / 10) ^ 2 = 81 / 100.
Proof.
  intros H; destruct (polarZ (9, 10)%Z (37, 100)%Z (-13691, 10000)%Z (-1369, 1000)%Z) as [B|] eqn:E;
    [|vm_compute in E; discriminate].
  pose proof (H _ _ _ _ B E) as I; vm_compute in E; injection E as <-; unfold in_box, fraction in I; cbn [fst snd] in I;
    lra.
Qed.

(** ** What definitions mean, and what statements say beyond the numbers above: each of their clauses *)
Lemma claims_mean n s t : says n s t -> match t with
  | Opposite _ _ k k' | Excluded _ k k' => (0 < k < Z.of_nat n /\ 0 < k' < Z.of_nat n)%Z /\ u_at 1 s n <> 0 /\
      b_at 1 s n (Z.to_nat k') < 0 < b_at 1 s n (Z.to_nat k)
  | Boundary _ k => ((0 < k < Z.of_nat n)%Z /\ b_at 1 s n (Z.to_nat k) = 0) /\ u_at 1 s n <> 0 /\
      forall j l, (0 < j < n)%nat -> (0 < l < n)%nat -> 0 < b_at 1 s n l -> b_at 1 s n j < 0 -> False
  | _ => True end.
Proof.
  assert (X : forall k k', opposite n s k k' -> (0 < k < Z.of_nat n /\ 0 < k' < Z.of_nat n)%Z /\ u_at 1 s n <> 0 /\
    b_at 1 s n (Z.to_nat k') < 0 < b_at 1 s n (Z.to_nat k)) by (intros k k' (U & A & B & C & D); repeat split; lia ||
    assumption).
  destruct t; trivial; [apply X | | apply X]; intros (U & A & B & C); split; [split; [lia | exact B]|]; split;
    [exact U|].
  intros j l Hj Hl L L'; apply (C j l); [lia | lia | split; assumption].
Qed.
Lemma spoken_of : Circle_reader_statement -> exists t, In t block_4 /\ there t (7 / 20).
Proof. intros H; destruct (H 4%nat block_4 ltac:(lia) eq_refl) as [A _]; apply (A (7 / 20)); lra. Qed.
Lemma absent_means a1 a2 e n k : period_says a1 a2 e n (Absent k) -> (0 < k < n)%nat /\ sgn e * b a1 a2 n k < 0 /\
  u a1 a2 n <> 0.
Proof. intros (A & B & C); split; [lia | split; [exact C | exact A]]. Qed.
Lemma Region_means : Region_reader_statement -> forall B k a1 a2, regionZ B k = true -> in_box B a1 a2 -> a2 > 0 /\
  a2 <= 1 /\ (k = 1%Z -> a2 + 1 < a1) /\ (k = 2%Z -> 2 * sqrt a2 <= a1 < a2 + 1) /\ (k = 3%Z -> a1 ^ 2 < 4 * a2) /\
  (k = 4%Z -> - (a2 + 1) < a1 <= - 2 * sqrt a2) /\ (k = 5%Z -> a1 < - (a2 + 1)) /\
  (k = 34%Z -> - (a2 + 1) < a1 < 2 * sqrt a2) /\ (0 < k < 6 \/ k = 34)%Z.
Proof.
  intros H B k a1 a2 HR HB; destruct (H B k a1 a2 HR HB) as [A R]; split; [lra|]; split; [lra|].
  destruct R as [[E R]|[[E R]|[[E R]|[[E R]|[[E R]|[E R]]]]]]; repeat split; intros; try lia; lra.
Qed.
Lemma Path_means : Path_reader_statement -> first_upper (- 1 / 4) (1 / 2) 2 /\ exists i j, path (- 1 / 4) (1 / 2) 2 [U]
  i j.
Proof.
  intros H; destruct (H 96%Z here 3%Z 2%nat 4%nat [U] (Ends D) rows_here _ _ eq_refl in_here)
    as (A & _ & _ & i & j & P & _).
  split; [exact A | exists i, j; exact P].
Qed.
(** The word [U] left open there: a further member is 4 at least. *)
Lemma Open_means : Path_reader_statement -> forall n, member (- 1 / 4) (1 / 2) Plus n ->
  (n <= 3 \/ exists i j, path (- 1 / 4) (1 / 2) 2 [U] i j /\ i + j <= n)%nat.
Proof.
  intros H n Hn; pose (rows := [[Some Minus; Some Plus; None]; [Some Plus; Some Plus; Some Plus];
    [None; Some Plus; Some Plus]]).
  destruct (H 96%Z here 3%Z 2%nat 4%nat [U] Open rows _ _ eq_refl in_here) as (_ & _ & _ & i & j & P & A).
  destruct (A n Hn) as [I|[_ L]]; [left; cbn in I; lia | right; exists i, j; split; assumption].
Qed.
Lemma Below_means : Below_reader_statement -> lettered 1 (1 / 2) 2 D.
Proof.
  intros H; apply (H 96%Z ((1, 1), (1, 1), (1, 2), (1, 2))%Z 3%Z 3%nat 1 (1 / 2) eq_refl); [|lia].
  unfold in_box, fraction; cbn [fst snd]; lra.
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
Lemma a_path check : Paths_statement check -> check slow = true -> exists t v, 89 / 2000 <= v 0%Z (t 0%Z) <= 244 / 2000
  /\ Rabs (t 1%Z - 2 * PI) < 6 / 5 /\ v 1%Z (t 1%Z) + sin (t 1%Z) = - (v 0%Z (t 1%Z) + sin (t 1%Z)).
Proof.
  intros H HX; set (M := {| Machine.c := 12 / 49; Machine.k := 100 / 2401; Machine.tau := 1; Machine.sigma := 1;
    Machine.nu := 1 / 2; Machine.harmonics := [(1%positive, (1, 0))] |}).
  assert (W : forall t, g M t = cos t /\ g1 M t = - sin t).
  { intros t; unfold g, g1; cbn [M Machine.harmonics over_harmonics]; rewrite !(Rmult_1_l t); split; ring. }
  destruct (H slow M (fun _ => nth 0 (Certificate.letters slow) {| Letter.periods := 1; Letter.after := (0, 0)%Q;
    Letter.before := (0, 0)%Q; Letter.weights := (0, 0)%Q; Letter.next := [] |}) (fun i => i) HX)
    as (t & y & v & HM & HB & _).
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
Lemma covers_mean M : covers slow M -> (Machine.c M = 12 / 49 /\ Machine.k M = 100 / 2401 /\ Machine.tau M = 1) /\
  (Machine.sigma M = 1 /\ 0 < Machine.nu M <= 1) /\ Machine.harmonics M = [(1%positive, (1, 0))] /\ g M 0 = 1 /\
  g1 M 0 = 0.
Proof.
  intros [C K T N S P H G G1]; unfold in_interval, Q2R in *; cbn in *; repeat (split; [repeat split; lra|]).
  split; [|split; assumption]; inversion_clear H as [|? x ? l E H2]; inversion_clear H2; destruct x as [j [a b]],
    E as (E & A & B); unfold in_interval, Q2R in *; cbn in *.
  subst j; replace a with 1 by lra; replace b with 0 by lra; reflexivity.
Qed.
Lemma leg_path_means C l : leg_path C l -> forall i, In (l i) (Certificate.letters C) /\
  exists v, nth_error (Certificate.letters C) v = Some (l (i + 1)%Z) /\ In v (Letter.next (l i)).
Proof. intros H i; destruct (H i) as (A & v & B & E); split; [exact A | exists v; split; assumption]. Qed.
Lemma machine_means M W N t y v : machine_motion M W N t y v -> N 0%Z = 0%Z -> (t 0%Z < t 1%Z /\ - W < t 0%Z < W) /\
  (forall x, derivable_pt_lim (y 0%Z) x (v 0%Z x) /\ derivable_pt_lim (v 0%Z) x (- Machine.c M * v 0%Z x - Machine.k M
  * y 0%Z x)) /\ (y 0%Z (t 0%Z) - wall M (t 0%Z) = 0 /\ y 0%Z (t 1%Z) - wall M (t 1%Z) = 0) /\
  (forall x, t 0%Z < x < t 1%Z -> y 0%Z x - wall M x > 0) /\ let V i := v i (t 1%Z) - g1 M (t 1%Z) in V 0%Z < 0 /\
  V 1%Z = - Machine.tau M * V 0%Z.
Proof.
  intros H N0; destruct (H 0%Z 1%Z eq_refl) as [F D L Q0 Q1 A V1 V2]; rewrite N0, Rmult_0_r, Rminus_0_r in D.
  apply Rabs_def2 in D; split; [split; lra|]; split; [exact F|]; split; [split; lra|]; split; [|split; assumption].
  intros x Hx; specialize (A x Hx); lra.
Qed.
Lemma in_boxes_mean M t v : in_boxes M (fun _ => nth 0 (Certificate.letters slow) {| Letter.periods := 1;
  Letter.after := (0, 0)%Q; Letter.before := (0, 0)%Q; Letter.weights := (0, 0)%Q; Letter.next := [] |}) t v ->
  89 <= 1000 * (v 0%Z (t 0%Z) / Machine.nu M) <= 244 /\ - 1582 <= 10000 * (v 0%Z (t 1%Z) / Machine.nu M) <= - 612.
Proof. intros H; destruct (H 0%Z 1%Z eq_refl) as [A B]; unfold in_interval, Q2R in A, B; cbn in A, B; lra. Qed.
Lemma paths_unique check : Paths_statement check -> forall C M l N t y v t' y' v', check C = true -> covers C M ->
  leg_path C l -> turns l N -> machine_motion M (Q2R (Certificate.window C)) N t y v -> in_boxes M l t v ->
  machine_motion M (Q2R (Certificate.window C)) N t' y' v' -> in_boxes M l t' v' -> forall i x, t i = t' i /\
  y i x = y' i x /\ v i x = v' i x.
Proof.
  intros H C M l N t y v t' y' v' HX HC HP HN A B A' B' i x; destruct (H C M l N HX HC HP HN)
    as (t0 & y0 & v0 & _ & _ & U).
  destruct (U t y v A B i x) as (-> & -> & ->), (U t' y' v' A' B' i x) as (-> & -> & ->); auto.
Qed.
End Paths.
