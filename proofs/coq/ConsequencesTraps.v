(** * Numbers that follow from the statement about certificates of kind attractor

    The certificate of crates/checker/tests/data/attractor.txt, and what it says of its machine at nu = 1/200. *)
From Grazing Require Import StatementOscillator StatementTrapped.
From Coq Require Import Reals ZArith QArith Qreals List Lra Lia.
From Grazing Require Import StatementPaths StatementTraps.
Import ListNotations.
Open Scope R_scope.

Definition sample : Trap.t := {| Trap.damping := (3 # 8, 3 # 8)%Q; Trap.stiffness := (1 # 64, 1 # 64)%Q;
  Trap.restitution := (4 # 5, 4 # 5)%Q; Trap.harmonics := [(1%positive, ((1, 1), (0, 0)))]%Q; Trap.depth := (1 # 100)%Q;
  Trap.window := (15 # 100, 15 # 100)%Q; Trap.bends := (98 # 100, 101 # 100)%Q; Trap.concave := None;
  Trap.speed := (3 # 4)%Q; Trap.slip := (7 # 100)%Q; Trap.growth := (23 # 20)%Q; Trap.last := 14; Trap.start := 2%Q |}.
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
Definition third (lo hi : R) (T : machine) (z w : R) : Prop := forall t V t1 V1 x v t2 V2 y u, 0 <= wall at_200 t -> - w
  <= V
  <= 0 -> 0 <= a T * wall at_200 t - sin t + V <= z -> leg T t V t1 V1 x v -> leg T t1 V1 t2 V2 y u ->
  - (3 / 4) * sqrt (1 / 200) <= V2 <= 0 /\ 0 <= a T * wall at_200 t2 - sin t2 + V2 <= 7 / 20000.
Lemma trapped_there check : Traps_statement check -> check sample = true -> exists lo hi T, - (15 / 100) <= lo /\ hi <=
  15 / 100 /\ a T + b T = 3 / 8 /\ a T * b T = 1 / 64 /\ chaotic T lo hi (23 / 20) /\ StatementTrapped.Q T = wall at_200
    /\
  Q1 T = g1 at_200 /\ tau T = 4 / 5 /\ mu T = 1 / 200 /\ p T = 2 * PI /\ W T = hi - lo /\
  third lo hi T (7 / 20000) (3 / 4 * sqrt (1 / 200)) /\
  third lo hi T 2 (sqrt (2 * (1 / 200 * (101 / 100 + a T * a T * (1 / 200 + 2 / (b T - a T)))))).
Proof.
  intros H HC; destruct (H sample at_200 HC sample_covered) as (lo & hi & P); cbv zeta in P; set (T := seen sample
    at_200 (hi - lo)) in *. destruct P as [[R1 R2] [W1 W2] Ch [Z1 S1] Ab].
  assert (E : Q2R (fst (Trap.window sample)) = 15 / 100 /\ Q2R (snd (Trap.window sample)) = 15 / 100 /\ Q2R (Trap.growth
    sample) = 23 / 20 /\ Q2R (Trap.slip sample) = 7 / 100 /\ Q2R (Trap.speed sample) = 3 / 4 /\ Q2R (Trap.start sample)
    = 2 /\ al1 T = 101 / 100) by (unfold T, seen, Q2R; cbn; repeat split; lra).
  destruct E as (E1 & E2 & E3 & E4 & E5 & E6 & E7); rewrite E1 in W1; rewrite E2 in W2; rewrite E3 in Ch; rewrite E4,
    E5, E6, ?E7 in *; change (mu T) with (1 / 200) in *.
  assert (Third : forall z w, (z = 7 / 100 * (1 / 200) /\ w = 3 / 4 * sqrt (1 / 200) \/ z = 2 /\ w = sqrt (2 * (1 / 200
    * (101 / 100 + a T * a T * (1 / 200 + 2 / (b T - a T)))))) -> third lo hi T z w).
  { intros z w Hz t V t1 V1 x v t2 V2 y u A B C L1 L2; assert (Zt : forall t V, zeta T t V = a T * wall at_200 t - sin t
    + V) by (intros s X; unfold zeta; change (Q1 T s) with (g1 at_200 s); rewrite (proj1 (proj2 (walls s)));
    reflexivity).
    destruct (Ab z w t V t1 V1 x v t2 V2 y u Hz) as (_ & B1 & B2); trivial; [split; [exact A | rewrite Zt; auto]|];
      rewrite Zt in B2. lra. }
  exists lo, hi, T; repeat (split; [first [exact W1 | exact W2 | exact R1 | exact R2 | exact Ch | reflexivity]|]).
  split; apply Third; [left; split; [field | reflexivity] | right; auto].
Qed.

(** No motion that keeps the same passes for ever is stable there, if it is periodic; and what is not covered. *)
Lemma none_stable check : Traps_statement check -> check sample = true -> No_stable_statement -> exists lo hi T,
  Q1 T = g1 at_200 /\ forall t V x v, stays T lo hi (fun i => Z.of_nat i) t V x v -> (forall i, t (S i) = t i + 2 * PI
    /\ V (S
  i) = V i) -> exists i0 eps, 0 < eps /\ forall d, 0 < d -> exists N' t' V' x' v', stays T lo hi N' t' V' x' v' /\
  t' 0%nat = t i0 /\ exists i j s, t i <= s <= t (S i) /\ t' j <= s <= t' (S j) /\ eps < Rabs (x' j s - x i s).
Proof.
  intros H HC NS; destruct (trapped_there check H HC) as (lo & hi & T & _ & _ & _ & _ & Ch & _ & EQ & Et & _ & Ep & _).
  exists lo, hi, T; split; [exact EQ|]; intros t V x v St Pe; destruct (NS T lo hi (23 / 20) Ch ltac:(rewrite Et; lra)
    1%nat 1%Z _ t V x v (le_n 1) St) as (i0 & eps & e0 & A).
  - intros i; replace (i + 1)%nat with (S i) by lia; destruct (Pe i) as [P1 P2]; rewrite Ep; split; [lia | split; [lra |
    exact P2]].
  - exists i0, eps; split; [exact e0|]; intros d Hd; destruct (A d Hd) as (N' & t' & V' & x' & v' & B1 & B2 & _ & B3).
    exists N', t', V', x', v'; auto.
Qed.
Lemma not_covered : (forall M, covers_trap sample M -> Machine.c M = 3 / 8 /\ Machine.k M = 1 / 64 /\ Machine.tau M = 4
  / 5 /\
  Machine.sigma M = 1 /\ 0 < Machine.nu M <= 1 / 100 /\ g M 0 = 1 /\ g1 M 0 = 0 /\
  Machine.harmonics M = [(1%positive, (1, 0))]).
Proof.
  intros M [C K T S N H G G1]; unfold in_interval, Q2R in *; cbn in C, K, T, N; repeat (split; [lra|]); inversion H as
    [|y h l l' R L E0 E1]; subst y l; inversion L; subst l'; destruct h as (j & x & z), R as (E & A & B); unfold Q2R in
    A, B; cbn in A, B; rewrite <- E; repeat f_equal; lra.
Qed.
