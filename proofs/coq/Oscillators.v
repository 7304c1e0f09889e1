(** * Theorem 1 for linear oscillators: which words are motions, and that these are unstable *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOrbitsPlane StatementOscillator StatementUnstable Derivatives Flow PlaneLinear
  OscillatorTurns OscillatorStop OscillatorGap OscillatorLaw OscillatorWords OscillatorUnstable.
Open Scope R_scope.

(** Theorem 1 for oscillators: one d, one mu0 and one K for all words over {n <= n_max : u_n <> 0}. *)
Theorem Word_oscillator : forall O m a1 a2 gamma, grazing O m a1 a2 gamma -> forall n_max, exists d mu0 K, d > 0 /\
  mu0 > 0 /\ forall (N : Z -> Z) (n : Z -> nat) s g mu, (forall i, N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\
  (1 <= n i <= n_max)%nat /\ u a1 a2 (n i) <> 0) -> sgn g * gamma > 0 -> 0 < sgn s * mu < mu0 ->
  ((forall i, (forall j, (1 <= j <= n i - 1)%nat -> sgn s * b a1 a2 (n i) j > 0) /\ sgn s * sgn g * follows a1 a2 (n i)
  (n (i + 1)%Z) > 0) -> one_motion O m mu d N /\ forall t y v, motion O m mu d N t y v -> unstable_motion (swing O m mu
  (K * Rabs mu) N) t v) /\ (forall i, (exists j, (1 <= j <= n i - 1)%nat /\ sgn s * b a1 a2 (n i)
  j < 0) \/ sgn s * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) < 0 -> forall t q v, ~ motion O m mu d N t q v) /\
  forall t q v, motion O m mu d N t q v -> forall i, Rabs (t i - turn m * IZR (N i)) <= K * Rabs mu.
Proof.
  intros O m a1 a2 gamma HO n_max; destruct (flow_exists (Oscillator.c O) (Oscillator.k O)) as (S & V & HS).
  pose proof (is_touching _ _ _ _ _ HO) as HT; pose proof (is_restitution _ _ _ _ _ HO) as Htau.
  destruct (bounded _ _ m S V HS n_max) as (K & HK); assert (K1 := proj1 HK).
  destruct (one_solution O m S V HT Htau n_max K HK) as (d & mu1 & C & Hd & HdK & Hmu1 & HC & Nr & One).
  destruct (margin (fun n j => b a1 a2 n j) (1 + n_max)) as (k1 & P1 & Mb).
  destruct (margin (fun i j => follows a1 a2 i j / gamma) (1 + n_max)) as (k2 & P2 & Mf).
  destruct (two_least (k1 / 2) (k2 / 4) ltac:(lra) ltac:(lra)) as (eps & He & He1 & He2).
  set (X := (1 + Rabs (Oscillator.c O) + Rabs (Oscillator.k O)) * (K * 2 + K * (2 * (6 * K ^ 5)))).
  assert (HX : 0 < X).
  { pose proof (Rabs_pos (Oscillator.c O)); pose proof (Rabs_pos (Oscillator.k O)); pose proof (pow_R1_Rle K 5 K1).
    apply Rmult_lt_0_compat; [lra|]; apply Rplus_lt_0_compat; apply Rmult_lt_0_compat; lra. }
  destruct (legs_near O m S V HT n_max K HK (C + 1) eps ltac:(lra) He) as (d2 & D2 & Leg).
  destruct (gap_open O HT m (C + 1) X eps ltac:(lra) HX He) as (d3 & D3 & Open).
  destruct (two_least mu1 d2 Hmu1 D2) as (d4 & D4 & L1 & L2), (two_least d4 d3 D4 D3) as (d5 & D5 & L3 & L4).
  destruct (two_least d5 (d / (C + 1)) D5 ltac:(apply Rdiv_lt_0_compat; lra)) as (mu0 & Hmu0 & L5 & L6).
  apply (Rmult_le_compat_l (C + 1)) in L6; [|lra]; replace ((C + 1) * (d / (C + 1))) with d in L6 by (field; lra).
  exists d, mu0, (C + 1); split; [lra|]; split; [exact Hmu0|]; intros N n s g mu Hw Hg Hmu.
  assert (NZ : mu <> 0) by (intros ->; lra); pose proof (Rabs_pos_lt mu NZ) as R.
  assert (Er : Rabs mu < mu0) by (destruct s; cbn in Hmu; unfold Rabs; destruct Rcase_abs; lra).
  assert (Cd : (C + 1) * Rabs mu <= (C + 1) * mu0) by (apply Rmult_le_compat_l; lra).
  assert (Reg : forall i, regular m S n_max (n i)).
  { intros i; destruct (Hw i) as (_ & H & Hu); split; [exact H|].
    rewrite (turned_S _ _ m S V HS a1 a2 gamma (is_matrix _ _ _ _ _ HO)); apply Rmult_integral_contrapositive.
    split; [apply HO | exact Hu]. }
  pose proof (fun i => conj (proj1 (Hw i)) (Reg i)) as HN; destruct (One n mu Reg ltac:(lra)) as (x & Hx & Law & Only).
  assert (Near : forall i, leg_near O m S V n_max K (n i) eps mu (x i) (x (i + 1)%Z)) by (intros i; apply Leg; auto;
    specialize (Hx i) as X1; specialize (Hx (i + 1)%Z) as X2; lra).
  assert (Mb' : forall i j, (j <= n_max)%nat -> b a1 a2 (n i) j <> 0 -> 2 * eps <= Rabs (b a1 a2 (n i) j)).
  { intros i j Hj Hne; destruct (Reg i); pose proof (Mb (n i) j ltac:(lia) ltac:(lia) Hne); lra. }
  assert (Mf' : forall i j, let f := follows a1 a2 (n i) (n j) / gamma in f <> 0 -> 4 * eps <= Rabs f).
  { intros i j f Hne; destruct (Reg i), (Reg j); pose proof (Mf (n i) (n j) ltac:(lia) ltac:(lia) Hne) as P; fold f in
      P; lra. }
  pose proof (fun i => proj2 (proj2 (Hw i))) as Hu; assert (Op : opens O m (C + 1) X eps mu) by (apply Open; lra).
  assert (Hd' : (C + 1) * Rabs mu <= d <= 1 /\ 2 * d <= / K) by lra; assert (Hx' : forall i, Rabs (x i) <= (C + 1) *
    Rabs mu) by (intros i; specialize (Hx i); lra).
  pose proof (decided O m a1 a2 gamma S V HO HS n_max K mu (C + 1) eps N n x HK HN Law Hx' Near d s g Hu (proj1 Hmu) Hg
    He Mb' Mf' Hd' Op Only) as One'; split; [|split].
  - intros Hs; split; [exact (One' Hs)|]; intros t q v HM; pose proof (g_pos O HT) as Pg; set (g2 := Oscillator.G2 O 0
    0) in *; assert (P3 : 0 < 3 * g2 * (1 + Oscillator.tau O)) by (apply Rmult_lt_0_compat; lra).
    destruct (two_least (Rabs mu) (eps * Rabs mu / (3 * g2 * (1 + Oscillator.tau O))) R ltac:(apply Rdiv_lt_0_compat;
      [apply Rmult_lt_0_compat|]; lra)) as (r & Hr & R1 & R2). apply (Rmult_le_compat_l _ _ _ (Rlt_le _ _ P3)) in R2.
    replace (3 * g2 * (1 + Oscillator.tau O) * (eps * Rabs mu / (3 * g2 * (1 + Oscillator.tau O)))) with (eps * Rabs mu)
      in R2 by (field; lra).
    apply (motion_unstable O m a1 a2 gamma S V n_max K mu (C + 1) eps r d N n x s g HO HS HK HN Law) with (q := q);
      trivial; try lra.
    + apply Nr; lra.
    + intros j p p' Hj Hp Hp'; apply Leg; trivial; lra.
    + intros i; specialize (Hx i); lra.
    + split; [exact Hr|]; fold g2; lra.
  - apply (word_fails O m a1 a2 gamma S V HO HS n_max K mu (C + 1) eps N n x HK HN Near d s g Hu (proj1 Hmu) Hg He Mb'
    Mf' Hd' Only).
  - intros t q v HM i; fold (phase m N t i).
    rewrite (phases O m a1 a2 gamma S V HO HS n_max K mu (C + 1) N n x HK HN d Hd' Only t q v HM); apply Hx'.
Qed.
