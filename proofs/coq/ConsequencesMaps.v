(** * Numbers worked out by hand that follow from the statements about maps: x -> (x_2, 0) for x_2 > -mu, else with the
      impact (0, sqrt(-mu - x_2)) added. For small mu < 0 it has one fixed point near (-mu, -mu), for mu > 0 none with an impact *)

From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane StatementOrbitsInstance StatementOrbitsPeriodic.
Open Scope R_scope.

(** A = [[0, 1], [0, 0]], C = (1 0), B = (0, 1), phi = 0, eta = 1: w = 0, rate = 1. *)
Definition example : Map.t := oscillator_map 0 1 0 0 0 0 1 1 0 0 0 0 0 0.

Lemma example_planar : Instance_statement -> planar example 0 0 1 1 (pair_vec 0 0).
Proof.
  intros I; pose proof (I 0 1 0 0 0 0 1 1 0 0 0 0 0 0 0 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as H.
  replace (0 + 0) with 0 in H by ring; replace (0 * 0 - 1 * 0) with 0 in H by ring; rewrite Rmult_1_l in H.
  replace (0 + 1) with 1 in H by ring; exact H.
Qed.

(** With curvature, and with an impact that depends on speed and place: (1, 1/4), gamma = 1. *)
Lemma instance_numbers : Instance_statement ->
  planar (oscillator_map 1 1 (- 1 / 4) 0 0 0 1 1 2 3 4 5 6 7) 1 (1 / 4) 1 1 (pair_vec 0 0).
Proof.
  intros I; pose proof (I 1 1 (- 1 / 4) 0 0 0 1 1 2 3 4 5 6 7 0 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as H.
  replace (1 + 0) with 1 in H by ring; replace (1 * 0 - 1 * (- 1 / 4)) with (1 / 4) in H by field.
  rewrite Rmult_1_l in H; replace (0 + 1) with 1 in H by ring; exact H.
Qed.

Definition once (j : unit) : unit := j.
Definition n_1 (j : unit) : nat := 1%nat.

(** The linear problem: X_2 = r, X_1 = Q_1 + X_2, Y = - Q_2 - (- r). *)
Lemma rows X Y Q r : linear example unit once n_1 X Y Q r <->
  X tt 1%nat = r tt /\ X tt 0%nat = Q tt 0%nat + X tt 1%nat /\ Y tt = X tt 1%nat - Q tt 1%nat.
Proof.
  split.
  - intros H; destruct (H tt) as [H1 H2]; pose proof (H2 0%nat ltac:(cbn; lia)) as H3; pose proof (H2 1%nat ltac:(cbn; lia)) as H4.
    unfold power, once, n_1 in *; cbn in H1, H3, H4; repeat split; lra.
  - intros (E1 & E2 & E3) []; unfold power, once, n_1; cbn; split; [lra|].
    intros i Hi; destruct i as [|[|i]]; [cbn; lra | cbn; lra | lia].
Qed.

Lemma two (P : nat -> Prop) : P 0%nat -> P 1%nat -> forall i, (i < 2)%nat -> P i.
Proof. intros H0 H1 [|[|i]] Hi; [assumption | assumption | lia]. Qed.

Lemma within_two t x : Rabs (x 0%nat) <= t -> Rabs (x 1%nat) <= t -> within (Map.N example) t x.
Proof. exact (two (fun i => Rabs (x i) <= t)). Qed.

Lemma inverse_2 : invertible example unit once n_1 2.
Proof.
  split.
  - intros t Q r H; destruct (H tt) as [HQ Hr]; pose proof (HQ 0%nat ltac:(cbn; lia)) as Q0; pose proof (HQ 1%nat ltac:(cbn; lia)) as Q1.
    exists (fun _ => pair_vec (Q tt 0%nat + r tt) (r tt)), (fun _ => r tt - Q tt 1%nat); split; [|apply rows; repeat split].
    intros []; split; [apply within_two; cbn [pair_vec]|].
    + eapply Rle_trans; [apply Rabs_triang | lra].
    + pose proof (Rabs_pos (r tt)); lra.
    + unfold Rminus; eapply Rle_trans; [apply Rabs_triang | rewrite Rabs_Ropp; lra].
  - intros t X Y _ H []; apply rows in H; destruct H as (E1 & E2 & E3); unfold zero in *.
    split; [apply within_two|]; rewrite ?E3, ?E2, ?E1, ?Rplus_0_r, ?Rminus_0_r, Rabs_R0; lra.
Qed.

Lemma solution_1 : solution example unit once n_1 (fun _ => pair_vec (-1) (-1)) (fun _ => -1).
Proof.
  split; [|apply rows; unfold zero; cbn; lra]; exists 1; intros []; split; [apply within_two; cbn [pair_vec]|];
    rewrite Rabs_left; lra.
Qed.

Lemma quantities e x : quantity example unit n_1 (fun _ => pair_vec (-1) (-1)) (fun _ => -1) e tt x -> x = - sgn e.
Proof. intros [->|(k & Hk & _)]; [ring | unfold n_1 in Hk; lia]. Qed.

(** One fixed point for small mu < 0, near (-mu, -mu); none for small mu > 0. *)
Lemma Theorem1_numbers : Instance_statement -> Theorem1_statement -> exists d, d > 0 /\
  (exists mu0, mu0 > 0 /\ (forall mu, - mu0 < mu < 0 -> exists x, orbit_near example unit once n_1 mu d x /\
    forall x', orbit_near example unit once n_1 mu d x' -> forall j i, (i < 2)%nat -> x' j i = x j i) /\
    forall mu x, 0 < mu < mu0 -> ~ orbit_near example unit once n_1 mu d x) /\
  exists mu1, mu1 > 0 /\ forall mu x, 0 < Rabs mu < mu1 -> orbit_near example unit once n_1 mu d x ->
  Rabs (x tt 0%nat + mu) <= Rabs mu / 10.
Proof.
  intros I T; pose proof (example_planar I) as P.
  destruct (T example (pair_vec 0 0) 1 (is_smooth _ _ _ _ _ _ P)) with (n_max := 1%nat) (K := 2) as (d & Hd & H1 & H2).
  { exact (is_w _ _ _ _ _ _ P). }
  { cbn; ring. }
  { lra. }
  assert (N1 : unit -> (1 <= 1 <= 1)%nat) by (intros; lia); exists d; split; [exact Hd | split].
  - destruct (H1 1 ltac:(lra)) as (mu0 & Hm & H); exists mu0; split; [exact Hm|]; split.
    + intros mu Hmu; destruct (H unit once n_1 _ _ Minus mu N1 inverse_2 solution_1) as [E _]; [cbn; lra|].
      destruct (E ltac:(intros [] x Hx; apply quantities in Hx; subst; cbn; lra)) as (x & Hx & U); exists x; split;
        [exact Hx | exact U].
    + intros mu x Hmu; destruct (H unit once n_1 _ _ Plus mu N1 inverse_2 solution_1) as [_ E]; [cbn; lra|].
      apply (E tt (- 1)); [left; cbn; ring | lra].
  - destruct (H2 (1 / 10) ltac:(lra)) as (mu1 & Hm & H); exists mu1; split; [exact Hm|]; intros mu x Hmu Hx.
    destruct (H unit once n_1 _ _ mu x N1 inverse_2 solution_1 Hmu Hx tt) as [A _]; specialize (A 0%nat ltac:(cbn; lia)).
    cbn in A; replace (x tt 0%nat + mu) with (x tt 0%nat - mu * 0 - 1 * mu * -1) by ring; lra.
Qed.

(** The same by the paper's form of the theorem: det (I - A) = 1, and the linear problem has 0 alone. *)
Lemma Theorem1_periodic_numbers : Instance_statement -> Theorem1_statement_periodic -> exists d mu0, d > 0 /\ mu0 > 0 /\
  forall mu, - mu0 < mu < 0 -> exists x, orbit_near example unit once n_1 mu d x.
Proof.
  intros I T; pose proof (example_planar I) as P; destruct (T example (is_smooth _ _ _ _ _ _ P)) as (w & Hw & H).
  { intros x Hx; pose proof (Hx 0%nat ltac:(cbn; lia)) as H0; pose proof (Hx 1%nat ltac:(cbn; lia)) as H1; cbn in H0, H1.
    apply (two (fun i => x i = 0)); lra. }
  assert (W0 : w 0%nat = 0).
  { pose proof (Hw 0%nat ltac:(cbn; lia)) as H0; pose proof (Hw 1%nat ltac:(cbn; lia)) as H1; cbn in H0, H1; lra. }
  assert (E1 : dot (Map.N example) (Map.C example) w + Map.eta example = 1) by (cbn; rewrite W0; ring).
  destruct (H ltac:(rewrite E1; lra) unit once n_1) as (X & Y & HL & Q); [| intros; unfold n_1; lia | |].
  { exists 1%nat, (fun _ => tt), (fun _ => 0%nat); split; [intros []; split; [lia | reflexivity] | intros; lia]. }
  { intros X Y HL []; apply rows in HL; unfold zero in HL; destruct HL as (A & B & C); split; [lra|]; apply (two (fun i => X tt i = 0)); lra. }
  apply rows in HL; destruct (Q Minus) as [[d [Hd [[mu0 [Hm B]] _]]] _].
  - intros [] x [->|(k & Hk & _)]; [unfold zero in HL; cbn; lra | unfold n_1 in Hk; lia].
  - exists d, mu0; split; [exact Hd|]; split; [exact Hm|]; intros mu Hmu; rewrite E1 in B.
    destruct (B mu ltac:(cbn; lra)) as (x & Hx & _); exists x; exact Hx.
Qed.

(** The orbit of a word with one letter, one impact on. *)
Lemma Symmetry_numbers : Symmetry_statement -> forall n mu d x,
  orbit_near example Z (fun j => j + 1)%Z (fun _ => n) mu d x ->
  orbit_near example Z (fun j => j + 1)%Z (fun _ => n) mu d (fun j => x (j + 1)%Z).
Proof. intros S n mu d x; apply (S example Z (fun j => j + 1)%Z (fun _ => n) mu d x (fun j => j + 1)%Z); reflexivity. Qed.
