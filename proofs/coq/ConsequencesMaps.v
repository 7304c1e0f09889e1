(** * Numbers worked out by hand that follow from the statements about maps: x -> (x_2, 0) for x_2 > -mu, else
      with the impact (0, sqrt(-mu - x_2)) added. For small mu < 0 it has one fixed point near (-mu, -mu), for
      mu > 0 none with an impact *)

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
  - intros H; destruct (H tt) as [H1 H2]; pose proof (H2 0%nat ltac:(cbn; lia)) as H3;
      pose proof (H2 1%nat ltac:(cbn; lia)) as H4.
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
  - intros t Q r H; destruct (H tt) as [HQ Hr]; pose proof (HQ 0%nat ltac:(cbn; lia)) as Q0;
      pose proof (HQ 1%nat ltac:(cbn; lia)) as Q1.
    exists (fun _ => pair_vec (Q tt 0%nat + r tt) (r tt)), (fun _ => r tt - Q tt 1%nat); split;
      [|apply rows; repeat split].
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

(** ** What the definitions say: of any map, at n = 2, and of the example *)
Lemma smooth_means M : smooth M -> let N := Map.N M in (forall i, (i < N)%nat -> Map.f M zero 0 i = 0) /\
  Map.h M zero 0 = 0 /\ (forall i eps, (i < N)%nat -> eps > 0 -> exists d, d > 0 /\
  forall x x' mu t, within N d x -> within N d x' -> Rabs mu <= d -> within N t (minus x x') -> 0 <= t ->
  Rabs (Map.f M x mu i - Map.f M x' mu i - dot N (Map.A M i) (minus x x')) <= eps * t /\
  Rabs (Map.h M x mu - Map.h M x' mu - dot N (Map.C M) (minus x x')) <= eps * t) /\
  forall eps, eps > 0 -> exists d, d > 0 /\ forall x y y' mu i, (i < N)%nat -> within N d x -> 0 <= y <= d ->
  0 <= y' <= d -> Rabs mu <= d ->
  Rabs (Map.kick M x y mu i * y - Map.kick M x y' mu i * y' - (y - y') * Map.B M i) <= eps * Rabs (y - y').
Proof.
  intros (F & [H0 H] & K) N; split; [|split; [|split]].
  - intros i Hi; apply (F i Hi).
  - exact H0.
  - intros i eps Hi He; destruct (F i Hi) as [_ G]; destruct (G eps He) as (d1 & Hd1 & G1), (H eps He)
      as (d2 & Hd2 & H2).
    exists (Rmin d1 d2); split; [apply Rmin_glb_lt; assumption|]; intros x x' mu t Hx Hx' Hm Ht Pt.
    pose proof (Rmin_l d1 d2); pose proof (Rmin_r d1 d2).
    assert (W : forall e z, Rmin d1 d2 <= e -> within N (Rmin d1 d2) z -> within N e z) by (intros e z He' Hz k Hk;
      specialize (Hz k Hk); lra).
    assert (Z : Rabs (mu - mu) <= t) by (rewrite Rminus_diag_eq, Rabs_R0; trivial).
    pose proof (G1 x x' mu mu t (W _ x (Rmin_l d1 d2) Hx) (W _ x' (Rmin_l d1 d2) Hx') ltac:(lra) ltac:(lra) Ht Z) as A.
    pose proof (H2 x x' mu mu t (W _ x (Rmin_r d1 d2) Hx) (W _ x' (Rmin_r d1 d2) Hx') ltac:(lra) ltac:(lra) Ht Z) as B.
    replace (mu - mu) with 0 in A, B by ring; rewrite Rmult_0_l, Rminus_0_r in A, B; split; assumption.
  - intros eps He; destruct (K eps He) as (d & Hd & L); exists d; split; [exact Hd|];
      intros x y y' mu i Hi Hx Hy Hy' Hm.
    apply L; trivial; [|apply Rle_refl | rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; apply Rabs_pos].
    intros k _; unfold minus; rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; apply Rabs_pos.
Qed.
(** Two steps: no impact at the first, one at the second, within d of 0, and the word goes on from there. *)
Lemma two_steps M mu d x : orbit_near M Z (fun i => i + 1)%Z (fun _ => 2%nat) mu d x -> forall j,
  (forall i, (i < Map.N M)%nat -> - d <= x j i <= d) /\ Map.h M (Map.f M (x j) mu) mu > 0 /\
  Map.h M (Map.f M (step M mu (x j)) mu) mu < 0 /\
  forall i, (i < Map.N M)%nat -> x (j + 1)%Z i = step M mu (step M mu (x j)) i.
Proof.
  intros H j; destruct (H j) as (A & B & C & D); split; [|split; [|split]].
  - intros i Hi; specialize (A i Hi); unfold Rabs in A; destruct Rcase_abs; lra.
  - exact (B 0%nat ltac:(lia)).
  - exact (C 1%nat eq_refl).
  - intros i Hi; symmetry; exact (D i Hi).
Qed.
(** (28) and (32) for one impact in one step, in words of coordinates; what "invertible" means; (33) and (34). *)
Lemma solution_means M X Y : solution M unit once n_1 X Y -> (exists t, Rabs (Y tt) <= t /\ forall i,
  (i < Map.N M)%nat -> Rabs (X tt i) <= t) /\ dot (Map.N M) (Map.C M) (mult (Map.N M) (Map.A M) (X tt)) = - 1 /\
  forall i, (i < Map.N M)%nat -> X tt i = mult (Map.N M) (Map.A M) (X tt) i + Y tt * Map.B M i.
Proof.
  intros [(t & B) L]; destruct (B tt) as [B1 B2], (L tt) as [L1 L2]; split; [exists t; split; [exact B2 | exact B1]|].
  split; [exact L1|]; intros i Hi; specialize (L2 i Hi); unfold power, once, n_1, zero in L2; cbn in L2; lra.
Qed.
Lemma invertible_means M K : invertible M unit once n_1 K -> (forall t Q r, within (Map.N M) t Q -> Rabs r <= t ->
  exists X Y, within (Map.N M) (K * t) X /\ Rabs Y <= K * t /\ linear M unit once n_1 (fun _ => X) (fun _ => Y)
  (fun _ => Q) (fun _ => r)) /\ forall X Y t, within (Map.N M) t X -> Rabs Y <= t -> linear M unit once n_1 (fun _ => X)
  (fun _ => Y) (fun _ => zero) (fun _ => 0) -> Y = 0.
Proof.
  intros [E U]; split.
  - intros t Q r HQ Hr; destruct (E t (fun _ => Q) (fun _ => r)) as (X & Y & B & L); [intros []; split; assumption|].
    exists (X tt), (Y tt); destruct (B tt) as [B1 B2]; split; [exact B1|]; split; [exact B2|]; intros []; apply (L tt).
  - intros X Y t HX HY L; destruct (U t (fun _ => X) (fun _ => Y) ltac:(intros []; split; assumption) L tt) as [_ B].
    pose proof (Rabs_pos Y); destruct (Req_dec Y 0) as [Z|Z]; [exact Z | apply Rabs_pos_lt in Z; lra].
Qed.
Lemma quantity_means M X Y j x : quantity M unit (fun _ => 3%nat) X Y Minus j x ->
  x = - Y j \/ exists k, (k = 1 \/ k = 2)%nat /\ x = - (1 + dot (Map.N M) (Map.C M) (power M k (X j))).
Proof. intros [E|(k & Hk & E)]; [left; rewrite E; cbn; ring | right; exists k; split; [lia | rewrite E; cbn [sgn];
    ring]]. Qed.
Lemma planar_means M a1 a2 gamma rate w : planar M a1 a2 gamma rate w -> (gamma <> 0 /\ rate <> 0) /\
  gamma = dot 2 (Map.C M) (mult 2 (Map.A M) (Map.B M)) /\ rate = dot 2 (Map.C M) w + Map.eta M.
Proof. intros P; destruct (is_gamma _ _ _ _ _ _ P), (is_rate _ _ _ _ _ _ P); repeat split; assumption. Qed.
Lemma linear_part M a1 a2 gamma rate w : planar M a1 a2 gamma rate w -> let A := Map.A M in
  (smooth M /\ Map.N M = 2%nat) /\ a1 = A 0%nat 0%nat + A 1%nat 1%nat /\
  a2 = A 0%nat 0%nat * A 1%nat 1%nat - A 0%nat 1%nat * A 1%nat 0%nat /\ dot 2 (Map.C M) (Map.B M) = 0.
Proof. intros [S N T D C _ _ _]; split; [exact (conj S N) | exact (conj T (conj D C))]. Qed.

(** One fixed point for small mu < 0, near (-mu, -mu); none for small mu > 0. *)
Lemma Theorem1_numbers : Instance_statement -> Theorem1_statement -> exists d, d > 0 /\
  (exists mu0, mu0 > 0 /\ (forall mu, - mu0 < mu < 0 -> exists x, orbit_near example unit once n_1 mu d x /\
    forall x', orbit_near example unit once n_1 mu d x' -> forall j i, (i < 2)%nat -> x' j i = x j i) /\
    forall mu x, 0 < mu < mu0 -> ~ orbit_near example unit once n_1 mu d x) /\
  exists mu1, mu1 > 0 /\ forall mu x, 0 < Rabs mu < mu1 -> orbit_near example unit once n_1 mu d x ->
  Rabs (x tt 0%nat + mu) <= Rabs mu / 10 /\ Rabs (sqrt (- height example mu (x tt) 0) + mu) <= Rabs mu / 10.
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
    destruct (H unit once n_1 _ _ mu x N1 inverse_2 solution_1 Hmu Hx tt) as [A B];
      specialize (A 0%nat ltac:(cbn; lia)).
    cbn [n_1 Nat.sub] in B; replace (1 * mu * -1) with (- mu) in B by ring; unfold Rminus in B; rewrite Ropp_involutive
      in B.
    split; [cbn in A; replace (x tt 0%nat + mu) with (x tt 0%nat - mu * 0 - 1 * mu * -1) by ring|]; lra.
Qed.

(** The same by the paper's form of the theorem: det (I - A) = 1, and the linear problem has 0 alone. *)
Lemma Theorem1_periodic_numbers : Instance_statement -> Theorem1_statement_periodic -> exists d d' mu0, d > 0 /\
  d' > 0 /\ mu0 > 0 /\ (forall mu, - mu0 < mu < 0 -> exists x, orbit_near example unit once n_1 mu d x /\ forall x',
  orbit_near example unit once n_1 mu d x' -> forall i, (i < 2)%nat -> x' tt i = x tt i) /\
  (forall eps, eps > 0 -> exists mu1, mu1 > 0 /\ forall mu x, - mu1 < mu < 0 -> orbit_near example unit once n_1 mu d x
  -> within 2 eps (x tt)) /\ forall mu x, 0 < mu < mu0 -> ~ orbit_near example unit once n_1 mu d' x.
Proof.
  intros I T; pose proof (example_planar I) as P; destruct (T example (is_smooth _ _ _ _ _ _ P)) as (w & Hw & H).
  { intros x Hx; pose proof (Hx 0%nat ltac:(cbn; lia)) as H0; pose proof (Hx 1%nat ltac:(cbn; lia)) as H1;
      cbn in H0, H1.
    apply (two (fun i => x i = 0)); lra. }
  assert (W0 : w 0%nat = 0).
  { pose proof (Hw 0%nat ltac:(cbn; lia)) as H0; pose proof (Hw 1%nat ltac:(cbn; lia)) as H1; cbn in H0, H1; lra. }
  assert (E1 : dot (Map.N example) (Map.C example) w + Map.eta example = 1) by (cbn; rewrite W0; ring).
  destruct (H ltac:(rewrite E1; lra) unit once n_1) as (X & Y & HL & Q); [| intros; unfold n_1; lia | |].
  { exists 1%nat, (fun _ => tt), (fun _ => 0%nat); split; [intros []; split; [lia | reflexivity] | intros; lia]. }
  { intros X Y HL []; apply rows in HL; unfold zero in HL; destruct HL as (A & B & C); split; [lra|];
      apply (two (fun i => X tt i = 0)); lra. }
  apply rows in HL; rewrite E1 in Q; destruct (Q Minus) as [A _], (Q Plus) as [_ B].
  destruct A as (d & Hd & (mu0 & Hm & A) & Near).
  { intros [] x [->|(k & Hk & _)]; [unfold zero in HL; cbn; lra | unfold n_1 in Hk; lia]. }
  destruct (B tt (Y tt)) as (d' & mu1 & Hd' & Hm' & B'); [left; cbn; ring | unfold zero in HL; lra|].
  exists d, d', (Rmin mu0 mu1); pose proof (Rmin_l mu0 mu1); pose proof (Rmin_r mu0 mu1).
  split; [exact Hd|]; split; [exact Hd'|]; split; [apply Rmin_glb_lt; assumption|]; split; [|split].
  - intros mu Hmu; destruct (A mu ltac:(cbn; lra)) as (x & Hx & U); exists x; split; [exact Hx|]; intros x' Hx';
      apply U, Hx'.
  - intros eps He; destruct (Near eps He) as (mu2 & Hm2 & N); exists mu2; split; [exact Hm2|]; intros mu x Hmu Hx.
    apply (N mu x); [cbn; lra | exact Hx].
  - intros mu x Hmu; apply B'; cbn; lra.
Qed.
(** Its hypotheses: finitely many impacts, and D X = 0 for X = 0 alone. *)
Lemma finite_means J : finite J -> exists m (f : nat -> J) g, forall j k, (g j < m)%nat /\ f (g j) = j /\
  ((k < m)%nat -> g (f k) = k).
Proof. intros (m & f & g & A & B); exists m, f, g; intros j k; split; [apply A|]; split; [apply A | apply B]. Qed.
Lemma det_D_means M next n : det_D_not_0 M bool next n -> forall X Y, linear M bool next n X Y (fun _ => zero) (fun _ =>
  0) -> Y true = 0 /\ forall i, (i < Map.N M)%nat -> X false i = 0.
Proof. intros H X Y L; split; [apply (H X Y L true) | apply (H X Y L false)]. Qed.

(** The orbit of a word with one letter, one impact on. *)
Lemma Symmetry_numbers : Symmetry_statement -> forall n mu d x, orbit_near example Z (fun j => j + 1)%Z (fun _ => n) mu
  d x -> orbit_near example Z (fun j => j + 1)%Z (fun _ => n) mu d (fun j => x (j + 1)%Z).
Proof.
  intros S n mu d x; apply (S example Z (fun j => j + 1)%Z (fun _ => n) mu d x (fun j => j + 1)%Z); reflexivity.
Qed.
