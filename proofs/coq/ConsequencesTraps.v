(** * Numbers that follow from the statement about certificates of kind attractor

    The certificate of crates/checker/tests/data/attractor.txt, and what it says of its machine at nu = 1/200. *)
From Grazing Require Import StatementOscillator StatementTrapped.
From Coq Require Import Reals ZArith QArith Qreals List Lra Lia.
From Grazing Require Import StatementPaths StatementTraps.
From Grazing Require Headline.
Import ListNotations.
Open Scope R_scope.

Definition sample : Trap.t := {| Trap.damping := (3 # 8, 3 # 8)%Q; Trap.stiffness := (1 # 64, 1 # 64)%Q;
  Trap.restitution := (4 # 5, 4 # 5)%Q; Trap.harmonics := [(1%positive, ((1, 1), (0, 0)))]%Q; Trap.depth := (1 # 100)%Q;
  Trap.window := (15 # 100, 15 # 100)%Q; Trap.bends := (98 # 100, 101 # 100)%Q; Trap.concave := None;
  Trap.speed := (3 # 4)%Q; Trap.slip := (7 # 100)%Q; Trap.growth := (23 # 20)%Q; Trap.last := 14; Trap.start := 2%Q;
  Trap.exponent := Some ((1 # 10000, 5 # 1000), 25%positive)%Q |}.
Definition at_200 : Machine.t := {| Machine.c := 3 / 8; Machine.k := 1 / 64; Machine.tau := 4 / 5; Machine.sigma := 1;
  Machine.nu := 1 / 200; Machine.harmonics := [(1%positive, (1, 0))] |}.
Lemma walls t : g at_200 t = cos t /\ g1 at_200 t = - sin t /\ g2 at_200 t = - cos t /\ wall at_200 t = 1 / 200 - 1 +
  cos t.
Proof.
  unfold wall, g, g1, g2; cbn [at_200 Machine.harmonics Machine.sigma Machine.nu over_harmonics]; change (1 * 1)%Z with
    1%Z.
  rewrite !(Rmult_1_l t); repeat split; ring.
Qed.
Lemma sample_covered : covers_trap sample at_200.
Proof.
  destruct (walls 0) as (G & G1 & _); rewrite cos_0 in G; rewrite sin_0 in G1; constructor; trivial; try (rewrite G1;
    ring); try (unfold in_interval, Q2R; cbn; lra).
  constructor; [|constructor]; unfold in_interval, Q2R; cbn; repeat split; lra.
Qed.
Lemma trapped_there check : Traps_statement check -> check sample = true -> exists lo hi, let T := seen sample at_200
  (hi - lo) in - (15 / 100) <= lo /\ hi <= 15 / 100 /\ a T + b T = 3 / 8 /\ a T * b T = 1 / 64 /\ chaotic T lo hi (23
  / 20)
    /\
  begins T 2 /\ by_passes T (1 / 200) 25 /\ tau T = 4 / 5 /\ mu T = 1 / 200 /\ p T = 2 * PI /\ zm T = 7 / 20000 /\ Vm
  T = 3 / 4 * sqrt (1 / 200) /\ StatementTrapped.Q T = wall at_200 /\ Q1 T = g1 at_200.
Proof.
  intros H HC; destruct (H sample at_200 HC sample_covered) as (lo & hi & P); set (T := seen sample at_200 (hi - lo))
    in *; destruct P as [[R1 R2] [W1 W2] Ch Be Ex]; specialize (Ex _ _ _ eq_refl).
  assert (E : Q2R (fst (Trap.window sample)) = 15 / 100 /\ Q2R (snd (Trap.window sample)) = 15 / 100 /\ Q2R (Trap.growth
    sample) = 23 / 20 /\ Q2R (Trap.slip sample) = 7 / 100 /\ Q2R (Trap.speed sample) = 3 / 4 /\ Q2R (Trap.start sample)
    = 2 /\ Q2R (5 # 1000) = 1 / 200 /\ Q2R (1 # 10000) = 1 / 10000) by (unfold Q2R; cbn; repeat split; lra).
  destruct E as (E1 & E2 & E3 & E4 & E5 & E6 & E7 & E8); rewrite E1 in W1; rewrite E2 in W2; rewrite E3 in Ch; rewrite
    E6 in Be; rewrite E7, E8 in Ex. specialize (Ex ltac:(change (mu T) with (1 / 200); lra)); exists lo, hi; cbv zeta;
      fold T.
  repeat (split; [first [exact W1 | exact W2 | exact R1 | exact R2 | exact Ch | exact Be | exact Ex | reflexivity]|]).
  split; [change (Q2R (Trap.slip sample) * (1 / 200) = 7 / 20000); rewrite E4; lra|]; split; [change (Q2R (Trap.speed
    sample) * sqrt (1 / 200) = 3 / 4 * sqrt (1 / 200)); rewrite E5; reflexivity | split; reflexivity].
Qed.
(** The sentences, in the order of the text, of this machine. *)
Section Sentences.
Variable T : machine.
Definition in_D (t V : R) : Prop := 0 <= wall at_200 t /\ - (3 / 4 * sqrt (1 / 200)) <= V <= 0 /\
  0 <= a T * wall at_200 t - sin t + V <= 7 / 20000.
Lemma sentences lo hi : Headline.Attractor_statement -> chaotic T lo hi (23 / 20) -> begins T 2 -> by_passes T (1 /
  200) 25
  -> tau T = 4 / 5 -> zm T = 7 / 20000 -> Vm T = 3 / 4 * sqrt (1 / 200) -> StatementTrapped.Q T = wall at_200 -> Q1 T
    = g1 at_200 -> (forall t V, in_D t V -> (exists t' V' x v, leg T t V t' V' x v) /\ forall t' V' x v, leg T t V t'
  V' x v -> in_D t' V') /\ (forall x v, free (a T + b T) (a T * b T) x v -> 0 <= x PI -> 0 <= a T * x PI + v PI <= 2
  -> exists t V t1 V1 x1 v1 t2 V2 x2 v2, arrives T PI t V x v /\ leg T t V t1 V1 x1 v1 /\ leg T t1 V1 t2 V2 x2 v2 /\
    in_D t2 V2) /\ (forall t V t' V' x v d w, in_D t V -> V < 0 -> leg T t V t' V' x v -> returns T (t' - t) t V 1 0 d
  w -> 0 < a T -> 0 <= d * (a T * d + w) /\ 23 / 20 <= Rabs d) /\ (forall N t V x v t' V' x' v', stays T lo hi N t V x
  v -> stays T lo hi N t' V' x' v' -> t 1%nat <= t' 1%nat -> x' 0%nat (t' 1%nat) - x 0%nat (t' 1%nat) = 1 / 1000 -> v'
    0%nat (t' 1%nat) = v 0%nat (t' 1%nat) -> 0 <= a T -> t' 2%nat <= t 2%nat /\ 115 / 100000 <= x 1%nat (t 2%nat) - x'
    1%nat (t 2%nat) /\ 0 <= a T * (x 1%nat (t 2%nat) - x' 1%nat (t 2%nat)) + (v 1%nat (t 2%nat) - v' 1%nat (t 2%nat)))
    /\
  (forall t V x v, stays T lo hi (fun i => Z.of_nat i) t V x v -> (forall i, t (S i) = t i + p T /\ V (S i) = V i) ->
    exists i0 eps, 0 < eps /\ forall d, 0 < d -> exists N' t' V' x' v', stays T lo hi N' t' V' x' v' /\ t' 0%nat = t
      i0 /\ exists i j s, t i <= s <= t (S i) /\ t' j <= s <= t' (S j) /\ eps < Rabs (x' j s - x i s)) /\ (forall N t
  V x v d w, stays T lo hi N t V x v -> (forall i, V i < 0) -> (forall i, returns T (t (S i) - t i) (t i) (V i) (d i)
    (w i) (d (S i)) (w (S i))) -> d 0%nat = 1 -> w 0%nat = 0 -> 0 < a T -> (exists theta, 0 < theta /\ forall i, exp
    (theta * IZR (N i - N 0%nat)) <= Rabs (d i)) /\ forall i, 1 + 1 / 200 * IZR (N i - N 0%nat) <= Rabs (d i)) /\
  exists f : nat -> R, forall y u N t V x v, free (a T + b T) (a T * b T) y u -> y PI = 1 -> 0 <= a T + u PI <= 2 ->
    arrives T PI (t 0%nat) (V 0%nat) y u -> motion T lo hi N t V x v -> (forall n, u PI <> f n) -> forall i, V i <> 0.
Proof.
  intros [H _] Ch Be By Et Ez Ev EQ EQ1; destruct (H T lo hi _ 2 Ch Be) as [K1 K2 K3 K4 K5 K6 K7 K8].
  assert (D : forall t V, trapped T t V <-> in_D t V) by (intros t V; unfold trapped, within, zeta, in_D; rewrite EQ,
    EQ1, Ez, Ev, (proj1 (proj2 (walls t))); tauto).
  assert (QP : StatementTrapped.Q T PI < 0) by (rewrite EQ, (proj2 (proj2 (proj2 (walls PI)))), cos_PI; lra).
  repeat match goal with |- _ /\ _ => split end.
  - intros t V Ht; apply D in Ht; destruct (K1 t V Ht) as [A B]; split; [exact A|]; intros t' V' x v L; apply D, (B t'
      V' x v L).
  - intros x v F X Z; destruct (K2 PI x v ltac:(lra) F X Z) as ((t & V & Ar) & B); destruct (B t V Ar) as ((t1 & V1 &
      x1 & v1 & L1) & B1); destruct (B1 _ _ _ _ L1) as ((t2 & V2 & x2 & v2 & L2) & B2). exists t, V, t1, V1, x1, v1,
      t2, V2, x2, v2; split; [exact Ar | split; [exact L1 | split; [exact L2|]]]; apply D, (B2 _ _ _ _ L2).
  - intros t V t' V' x v d w Ht NV L Re A; destruct (K3 t V t' V' x v 1 0 d w (proj2 (D t V) Ht) NV L Re) as [C G];
      [left; lra|]. rewrite Rabs_R1 in G; split; [|lra]; destruct C as [[c1 c2]|[c1 c2]]; [apply Rmult_le_pos;
      assumption|].
    replace (d * (a T * d + w)) with (- d * - (a T * d + w)) by ring; apply Rmult_le_pos; lra.
  - intros N t V x v t' V' x' v' St St' L E1 E2 A; destruct (K4 N t V x v t' V' x' v' 0%nat St St' L) as (G1 & G2 &
      G3); [lra | rewrite E1, E2; lra|]. rewrite E1 in G2; split; [exact G1 | split; [lra | exact G3]].
  - intros t V x v St Pe; destruct (K5 ltac:(lra) 1%nat 1%Z _ t V x v (le_n 1) St) as (i0 & eps & e0 & U).
    + intros i; replace (i + 1)%nat with (S i) by lia; destruct (Pe i) as [P1 P2]; rewrite Rmult_1_r; split; [lia |
        split; assumption].
    + exists i0, eps; split; [exact e0|]; intros d Hd; destruct (U d Hd) as (N' & t' & V' & x' & v' & B1 & B2 & _ &
        B3).
      exists N', t', V', x', v'; auto.
  - intros N t V x v d w St Neg Re d0 w0 A; assert (C : cone T (d 0%nat) (w 0%nat)) by (rewrite d0, w0; left; lra);
      split.
    + destruct K6 as (th & T0 & G); exists th; split; [exact T0|]; intros i; specialize (G N t V x v d w St Neg Re C
        i); rewrite d0, Rabs_R1 in G; lra.
    + intros i; pose proof (K7 _ _ By N t V x v d w St Neg Re C i) as G; rewrite d0, Rabs_R1 in G; pose proof
        (exp_ineq1_le (1 / 200 * IZR (N i - N 0%nat))); lra.
  - destruct (K8 PI 1 ltac:(lra) ltac:(lra)) as (f & Hf); exists f; intros y u N t V x v F Y0 U0 Ar Mo No i V0.
    destruct (Hf y u N t V x v F Y0 ltac:(rewrite Rmult_1_r; exact U0) Ar Mo) as (n & E); [exists i; exact V0 | exact
      (No n E)].
Qed.
End Sentences.
(** With d = 3/2, w = 24, tau = 1/2: a < 1/60, so that exp (- 2 pi a) > 2/3. *)
Lemma paper_attracts : Headline.Attractor_statement -> exists E Z S mu1, mu1 > 0 /\ forall mu, 0 < mu <= mu1 -> let M
  := paper (3 / 2) 24 (1 / 2) mu Z S in 1 < E /\ stretches M E 1.
Proof.
  intros [_ H]; destruct (H (3 / 2) 24 (1 / 2)) as (E & Z & S & mu1 & H1 & HM); try lra.
  - cbn [a paper]; set (r := sqrt ((3 / 2) ^ 2 - 1)); assert (R1 : 11 / 10 < r) by (unfold r; rewrite <- (sqrt_square
      (11 / 10)) by lra; apply sqrt_lt_1_alt; lra). assert (R2 : r < 3 / 2) by (unfold r; rewrite <- (sqrt_square (3 /
      2)) at 2 by lra; apply sqrt_lt_1_alt; lra). pose proof (exp_ineq1_le (- ((3 / 2 - r) / 24) * (2 * PI))); pose
      proof PI_4; assert ((3 / 2 - r) / 24 * (2 * PI) <= 1 / 60 * 8) by (apply Rmult_le_compat; pose proof PI_RGT_0;
      lra); lra.
  - exists E, Z, S, mu1; split; [exact H1|]; intros mu Hmu M; destruct (HM mu Hmu) as [_ E1 St]; split; [exact E1 |
      apply St; lia].
Qed.

(** What is not covered. *)
Lemma not_covered : (forall M, covers_trap sample M -> Machine.c M = 3 / 8 /\ Machine.k M = 1 / 64 /\ Machine.tau M = 4
  / 5 /\
  Machine.sigma M = 1 /\ 0 < Machine.nu M <= 1 / 100 /\ g M 0 = 1 /\ g1 M 0 = 0 /\
  Machine.harmonics M = [(1%positive, (1, 0))]).
Proof.
  intros M [C K T S N H G G1]; unfold in_interval, Q2R in *; cbn in C, K, T, N; repeat (split; [lra|]); inversion H as
    [|y h l l' R L E0 E1]; subst y l; inversion L; subst l'; destruct h as (j & x & z), R as (E & A & B); unfold Q2R in
    A, B; cbn in A, B; rewrite <- E; repeat f_equal; lra.
Qed.
