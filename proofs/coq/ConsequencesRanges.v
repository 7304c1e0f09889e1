(** * Numbers that follow from the statement about certificates of ranges

    Two cells of README's machine before it touches its stop, impacts one period apart: what its motion does
    at nu = 1/100, which is in both. *)

From Coq Require Import Reals ZArith QArith Qreals List Lra Lia.
From Grazing Require Import StatementPaths StatementRanges.
Import ListNotations.
Open Scope R_scope.

Definition edge_from (a b : Q) : Edge.t := {| Edge.strengths := (a, b); Edge.factor := 1; Edge.weight := 1 |}.
Definition near : Cell.t := {| Cell.depth := (0, 1 # 100)%Q; Cell.parts := 1; Cell.steps := 0; Cell.edges :=
  [edge_from 2 (5 # 2)] |}.
Definition farther : Cell.t := {| Cell.depth := (1 # 100, 1 # 50)%Q; Cell.parts := 1; Cell.steps := 10; Cell.edges :=
  [edge_from (21 # 10) (24 # 10)] |}.
Definition born : Range.t := {|
  Range.damping := (1 # 10, 1 # 10)%Q; Range.stiffness := (3 # 10, 3 # 10)%Q; Range.restitution := (4 # 5, 4 #
    5)%Q;
  Range.behind := false; Range.harmonics := [(1%positive, ((1, 1), (0, 0)))]%Q; Range.window := (6 # 5)%Q;
  Range.contraction := (9 # 10)%Q; Range.periods := [1%positive]; Range.graph := [(0%nat, 0%nat)];
  Range.cells := [near; farther] |}.
Definition readme : Machine.t := {| Machine.c := 1 / 10; Machine.k := 3 / 10; Machine.tau := 4 / 5;
  Machine.sigma := -1; Machine.nu := 1 / 100; Machine.harmonics := [(1%positive, (1, 0))] |}.

Lemma readme_wall t : g readme t = cos t /\ g1 readme t = - sin t.
Proof. unfold g, g1; cbn [readme Machine.harmonics over_harmonics]; rewrite !(Rmult_1_l t); split; ring. Qed.
Lemma readme_covered : covers_range born readme.
Proof.
  assert (G : g readme 0 = 1 /\ g1 readme 0 = 0) by (destruct (readme_wall 0) as [-> ->]; rewrite cos_0, sin_0; lra).
  constructor; try apply G; try (unfold in_interval, Q2R; cbn; lra);
    [exists near; split; [left; reflexivity | cbn; unfold Q2R; cbn; lra]|].
  constructor; [|constructor]; unfold in_interval, Q2R; cbn; repeat split; lra.
Qed.
Lemma impact_at s t : g1 readme t = Machine.nu readme * s / 2 -> s = - 200 * sin t.
Proof. rewrite (proj2 (readme_wall t)); cbn [readme Machine.nu]; lra. Qed.
Lemma a_motion check : Ranges_statement check -> check born = true -> exists t y v, machine_motion readme (6 / 5)
  (fun i => i) t y v /\ 21 / 2000 <= - sin (t 1%Z) <= 24 / 2000 /\ Rabs (t 1%Z - 2 * PI) < 6 / 5 /\
  v 1%Z (t 1%Z) + sin (t 1%Z) = - (4 / 5) * (v 0%Z (t 1%Z) + sin (t 1%Z)) /\ forall t' y' v', machine_motion readme
  (6 / 5) (fun i => i) t' y' v' -> (forall i, 2 / 200 <= - sin (t' i) <= 5 / 400) -> forall i, t' i = t i.
Proof.
  intros H HX; destruct (H born readme (fun _ => 0%nat) (fun i => i) HX readme_covered) as (_ & t & y & v & HM & HK).
  - intros i; left; reflexivity.
  - intros i; exists 1%positive; split; reflexivity.
  - replace (Q2R (Range.window born)) with (6 / 5) in HM, HK by (cbn; unfold Q2R; cbn; lra).
    assert (C : forall K, K = near \/ K = farther -> In K (Range.cells born) /\ in_interval (Cell.depth K)
      (Machine.nu readme)).
    { intros K [-> | ->]; (split; [cbn; tauto|]); unfold in_interval; cbn; unfold Q2R; cbn; lra. }
    exists t, y, v; split; [exact HM|]; split; [|split; [|split]].
    + destruct (HK farther (C _ (or_intror eq_refl))) as [R _]; destruct (R 0%Z 1%Z eq_refl) as (e & s & E & Hs & Es).
      injection E as <-; apply impact_at in Es; unfold in_interval in Hs; cbn in Hs; unfold Q2R in Hs; cbn in Hs; lra.
    + destruct (HM 1%Z 2%Z eq_refl) as [_ T _ _ _ _ _ _].
      replace (t 1%Z - 2 * PI) with (t 1%Z - 2 * PI * 1) by ring; exact T.
    + destruct (HM 0%Z 1%Z eq_refl) as [_ _ _ _ _ _ _ V].
      rewrite (proj2 (readme_wall _)) in V; cbn [readme Machine.tau] in V; lra.
    + intros t' y' v' HM' B i; destruct (HK near (C _ (or_introl eq_refl))) as [_ U].
      apply (U t' y' v' HM'); [|exact 0]; intros k j ->; exists (edge_from 2 (5 # 2)), (- 200 * sin (t' (k + 1)%Z)).
      specialize (B (k + 1)%Z); split; [reflexivity|]; split.
      * unfold in_interval; cbn; unfold Q2R; cbn; lra.
      * rewrite (proj2 (readme_wall _)); cbn [readme Machine.nu]; lra.
Qed.

(** ** What definitions mean, and that the motion is the only one: each of their clauses *)
Lemma covers_mean M : covers_range born M -> (Machine.c M = 1 / 10 /\ Machine.k M = 3 / 10 /\ Machine.tau M = 4 / 5) /\
  (Machine.sigma M = -1 /\ 0 < Machine.nu M <= 1 / 50) /\ Machine.harmonics M = [(1%positive, (1, 0))] /\ g M 0 = 1 /\
  g1 M 0 = 0.
Proof.
  intros [C K T S P N H G G1]; unfold in_interval, Q2R in *; cbn in *; split; [repeat split; lra|]; split.
  - destruct N as (c & [<-|[<-|[]]] & L); unfold Q2R in L; cbn in L; lra.
  - split; [|split; assumption]; inversion_clear H as [|? x ? l E H2]; inversion_clear H2; destruct x as [j [a b]],
      E as (E & A & B); unfold in_interval, Q2R in *; cbn in *; subst j; replace a with 1 by lra;
      replace b with 0 by lra; reflexivity.
Qed.
Lemma edge_turns_mean l N : edge_turns born l N -> forall i, (l i = 0%nat -> N (i + 1) - N i = 1)%Z /\ (l i < 1)%nat.
Proof.
  intros H i; destruct (H i) as (n & E & F); destruct (l i) as [|k]; cbn in E; [injection E as <-; lia|].
  destruct k; discriminate E.
Qed.
Lemma in_ranges_mean M t : in_ranges born near M (fun _ => 0%nat) t -> exists s, 2 <= s <= 5 / 2 /\
  g1 M (t 1%Z) = Machine.nu M * s / 2.
Proof.
  intros H; destruct (H 0%Z 1%Z eq_refl) as (e & s & E & B & G); injection E as <-; unfold in_interval, Q2R in B;
    cbn in B.
  exists s; split; [lra | exact G].
Qed.
Lemma ranges_mean check : Ranges_statement check -> forall C M l N, check C = true -> covers_range C M ->
  edge_path C l -> edge_turns C l N -> (exists K, in_interval (Cell.depth K) (Machine.nu M) /\ In K (Range.cells C)) /\
  forall K t y v t' y' v', In K (Range.cells C) -> in_interval (Cell.depth K) (Machine.nu M) ->
  machine_motion M (Q2R (Range.window C)) N t y v -> in_ranges C K M l t -> machine_motion M (Q2R (Range.window C)) N t'
  y' v' -> in_ranges C K M l t' -> forall i x, t i = t' i /\ y i x = y' i x /\ v i x = v' i x.
Proof.
  intros H C M l N HX HC HP HN; destruct (H C M l N HX HC HP HN) as ((K & I & W) & t0 & y0 & v0 & _ & A); split;
    [exists K; split; assumption|].
  intros K' t y v t' y' v' I' W' B R B' R' i x; destruct (A K' (conj I' W')) as [_ U].
  destruct (U t y v B R i x) as (-> & -> & ->), (U t' y' v' B' R' i x) as (-> & -> & ->); auto.
Qed.
