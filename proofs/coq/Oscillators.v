(** * Proof that (52) and (64) decide which words linear oscillators have near grazing *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOrbitsPlane StatementOscillator Derivatives Flow PlaneLinear OscillatorTurns
  OscillatorStop OscillatorGap OscillatorLaw OscillatorMotion.
Open Scope R_scope.

Lemma sign_over s g a f : sgn g * a > 0 -> (sgn s * sgn g * f > 0 -> sgn s * (f / a) > 0) /\
  (sgn s * sgn g * f < 0 -> sgn s * (f / a) < 0).
Proof.
  intros H; assert (N : a <> 0) by (intros ->; lra).
  assert (E : sgn s * (f / a) = sgn s * sgn g * f * / (sgn g * a)) by (destruct g; cbn in *; field; exact N).
  rewrite E; assert (P : 0 < / (sgn g * a)) by (apply Rinv_0_lt_compat, H); split; intros Hs.
  - apply Rmult_lt_0_compat; assumption.
  - assert (0 < - (sgn s * sgn g * f) * / (sgn g * a)) by (apply Rmult_lt_0_compat; lra); lra.
Qed.

(** x is within e mu of mu y, and y is 0 or at least 2 e away from it. *)
Lemma sign_near s mu x y e : 0 < sgn s * mu -> Rabs (x - mu * y) <= e * Rabs mu -> (y <> 0 -> 2 * e <= Rabs y) ->
  (sgn s * y > 0 -> e * Rabs mu <= x) /\ (sgn s * y < 0 -> x <= - (e * Rabs mu)).
Proof.
  intros Hmu H Hy; apply le_abs in H; pose proof (Rabs_pos mu) as P.
  assert (E : mu * y = Rabs mu * (sgn s * y)) by (destruct s; cbn in *; [rewrite (Rabs_pos_eq mu) by lra |
    rewrite (Rabs_left mu) by lra]; ring).
  assert (A : Rabs y = Rabs (sgn s * y)).
  { rewrite Rabs_mult; destruct s; cbn; [rewrite Rabs_R1 | rewrite (Rabs_left (-1)) by lra]; ring. }
  rewrite A in Hy; set (z := sgn s * y) in *; split; intros Hs;
    specialize (Hy ltac:(intros N; unfold z in Hs; rewrite N in Hs; lra)).
  - rewrite Rabs_pos_eq in Hy by lra; pose proof (Rmult_le_compat_l _ _ _ P Hy); lra.
  - rewrite Rabs_left in Hy by lra; pose proof (Rmult_le_compat_l _ _ _ P Hy); lra.
Qed.

Section Words.
Variables (O : Oscillator.t) (m : sign) (a1 a2 gamma : R) (S V : R -> R).
Notation c := (Oscillator.c O).
Notation k := (Oscillator.k O).
Notation T := (turn m).
Hypothesis HO : grazing O m a1 a2 gamma.
Hypothesis HS : flow c k S V.
Variables (n_max : nat) (K mu h eps : R) (N : Z -> Z) (n : Z -> nat) (s g : sign) (x : Z -> R).
Hypothesis HK : bounds c k m S V n_max K.
Hypothesis Hmu : 0 < sgn s * mu.
Hypothesis HN : forall i, N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\ (1 <= n i <= n_max)%nat /\ u a1 a2 (n i) <> 0.
Hypothesis Near : forall i, leg_near O m S V n_max K (n i) eps mu (x i) (x (i + 1)%Z).
Hypothesis Hg : sgn g * gamma > 0.
Hypothesis Heps : 0 < eps.
Hypothesis Mb : forall i j, (j <= n_max)%nat -> b a1 a2 (n i) j <> 0 -> 2 * eps <= Rabs (b a1 a2 (n i) j).
Hypothesis Mf : forall i j, let f := follows a1 a2 (n i) (n j) / gamma in f <> 0 -> 4 * eps <= Rabs f.
Let HA := is_matrix _ _ _ _ _ HO.
Let Hgam : gamma <> 0 := is_generic _ _ _ _ _ HO.

Lemma all_regular i : regular m S n_max (n i).
Proof.
  destruct (HN i) as (_ & H & Hu); split; [exact H|]; rewrite (turned_S c k m S V HS a1 a2 gamma HA).
  apply Rmult_integral_contrapositive; auto.
Qed.

Let aft i := aft O m S V (n i) mu (x i) (x (i + 1)%Z).
Let bef i := bef O m S V (n i) mu (x i) (x (i + 1)%Z).

Lemma jump_sign i : let f := sgn s * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) in
  (f > 0 -> bef i < aft (i + 1)%Z) /\ (f < 0 -> aft (i + 1)%Z <= bef i).
Proof.
  intros f; destruct (HN i) as (_ & H & Hi), (HN (i + 1)) as (_ & _ & Hj).
  pose proof (limit_follows c k m S V HS a1 a2 gamma HA (n i) (n (i + 1)%Z) Hgam Hi Hj (proj1 H)) as E.
  destruct (sign_near s mu (aft (i + 1)%Z - bef i) (follows a1 a2 (n i) (n (i + 1)%Z) / gamma) (2 * eps) Hmu) as [P
    Q].
  { rewrite <- E; replace (_ - _) with ((aft (i + 1)%Z - mu * aft0 c m S V (n (i + 1)%Z)) -
      (bef i - mu * bef0 c k m S V (n i))) by ring.
    pose proof (near_aft _ _ _ _ _ _ _ _ _ _ _ (Near (i + 1)%Z));
      pose proof (near_bef _ _ _ _ _ _ _ _ _ _ _ (Near i)).
    eapply Rle_trans; [apply apart|]; unfold aft, bef; lra. }
  { intros H'; specialize (Mf i (i + 1)%Z H'); lra. }
  destruct (sign_over s g gamma (follows a1 a2 (n i) (n (i + 1)%Z)) Hg) as [P' Q'].
  assert (0 < 2 * eps * Rabs mu) by (apply Rmult_lt_0_compat; [lra | apply Rabs_pos_lt; intros Z; rewrite Z in Hmu;
    lra]).
  split; intros Hf; [specialize (P (P' Hf)) | specialize (Q (Q' Hf))]; lra.
Qed.

Lemma mid_sign i j : (1 <= j <= n i - 1)%nat ->
  let y := facing m (Z.of_nat j) * here O m S V mu n x i (T * INR j) + mu in
  (sgn s * b a1 a2 (n i) j > 0 -> eps * Rabs mu <= y) /\ (sgn s * b a1 a2 (n i) j < 0 -> y <= 0).
Proof.
  intros Hj y; destruct (HN i) as (_ & Hn & Hu).
  pose proof (near_mid _ _ _ _ _ _ _ _ _ _ _ (Near i) j ltac:(lia)) as Hm.
  pose proof (limit_b c k m S V HS a1 a2 gamma HA (n i) j Hgam Hu ltac:(lia)) as E; fold (mid0 O m S V (n i) j) in E.
  destruct (sign_near s mu y (b a1 a2 (n i) j) eps Hmu) as [P Q].
  { rewrite <- E; replace (y - _) with (mid O m S V (n i) j mu (x i) (x (i + 1)%Z) - mu * mid0 O m S V (n i) j);
      [exact Hm|]; unfold y, here, moved, mid, turned.
    replace (T * INR j + - x i) with (T * INR j - x i) by ring; ring. }
  { apply Mb; lia. }
  assert (0 <= eps * Rabs mu) by (apply Rmult_le_pos; [lra | apply Rabs_pos]).
  split; [exact P | intros Hs; specialize (Q Hs); lra].
Qed.

(** A motion with these phases satisfies (52) and (64) as far as they are decided. *)
Lemma word_fails i : (exists j, (1 <= j <= n i - 1)%nat /\ sgn s * b a1 a2 (n i) j < 0) \/
  sgn s * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) < 0 -> forall d t q v, d <= 1 -> 2 * d <= / K ->
  motion O m mu d N t q v -> (forall i, phase m N t i = x i) -> False.
Proof.
  intros Hs d t q v H1 Hd HM Ex; pose proof (fun i => conj (proj1 (HN i)) (all_regular i)) as HR.
  destruct Hs as [(j & Hj & Hs)|Hs].
  - destruct (motion_is O m S V HS n_max K mu N n x HK HR d t q v HM Hd Ex i) as [_ E].
    destruct (mid_sign i j Hj) as [_ Q]; specialize (Q Hs); pose proof (turn_large m) as HT3.
    destruct (HM i _ eq_refl) as (_ & _ & _ & _ & _ & Open & _).
    assert (At : forall l, - 1 <= t l - T * IZR (N l) <= 1).
    { intros l; destruct (HM l _ eq_refl) as (_ & D & _); apply le_abs in D; lra. }
    assert (1 <= INR j <= INR (n i) - 1).
    { split; [apply (le_INR 1); lia|]; pose proof (le_INR (1 + j) (n i) ltac:(lia)) as P; rewrite plus_INR in P;
        cbn in P; lra. }
    assert (T * 1 <= T * INR j <= T * (INR (n i) - 1)) by (split; apply Rmult_le_compat_l; lra).
    assert (E1 := At i); assert (E2 := At (i + 1)%Z); rewrite (proj1 (HN i)), plus_IZR, <- INR_IZR_INZ in E2.
    specialize (Open (N i + Z.of_nat j)%Z (T * IZR (N i) + T * INR j) ltac:(split; lra)).
    unfold gap in Open; rewrite (proj1 (E _)) in Open; fold (gap O m mu (N i + Z.of_nat j)
      (leg_q O m S V mu N n x i) (T * IZR (N i) + T * INR j)) in Open.
    rewrite (proj1 (gap_here O m S V mu N n x i _ _)) in Open; unfold gap in Open.
    rewrite <- INR_IZR_INZ, Rminus_eq_0, (touch _ (is_touching _ _ _ _ _ HO)) in Open; lra.
  - destruct (motion_law O m S V (is_restitution _ _ _ _ _ HO) HS n_max K HK mu d N n t q v HM Hd HR) as [_ J].
    specialize (J i); rewrite !Ex in J; destruct (jump_sign i) as [_ Q]; specialize (Q Hs); unfold aft, bef in Q; lra.
Qed.
End Words.

(** Theorem 1 for oscillators: one d, one mu0 and one K for all words over {n <= n_max : u_n <> 0}. *)
Theorem Word_oscillator : forall O m a1 a2 gamma, grazing O m a1 a2 gamma ->
  forall n_max, exists d mu0 K, d > 0 /\ mu0 > 0 /\ forall (N : Z -> Z) (n : Z -> nat) s g mu,
  (forall i, N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\ (1 <= n i <= n_max)%nat /\ u a1 a2 (n i) <> 0) ->
  sgn g * gamma > 0 -> 0 < sgn s * mu < mu0 ->
  ((forall i, (forall j, (1 <= j <= n i - 1)%nat -> sgn s * b a1 a2 (n i) j > 0) /\
              sgn s * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) > 0) -> one_motion O m mu d N) /\
  (forall i, (exists j, (1 <= j <= n i - 1)%nat /\ sgn s * b a1 a2 (n i) j < 0) \/
             sgn s * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) < 0 ->
   forall t q v, ~ motion O m mu d N t q v) /\
  forall t q v, motion O m mu d N t q v -> forall i, Rabs (t i - turn m * IZR (N i)) <= K * Rabs mu.
Proof.
  intros O m a1 a2 gamma HO n_max; destruct (flow_exists (Oscillator.c O) (Oscillator.k O)) as (S & V & HS).
  pose proof (is_touching _ _ _ _ _ HO) as HT; pose proof (is_restitution _ _ _ _ _ HO) as Htau.
  destruct (bounded _ _ m S V HS n_max) as (K & HK); assert (K1 := proj1 HK).
  destruct (one_solution O m S V HT Htau n_max K HK) as (d & mu1 & C & Hd & HdK & Hmu1 & HC & One).
  destruct (margin (fun n j => b a1 a2 n j) (1 + n_max)) as (k1 & P1 & Mb).
  destruct (margin (fun i j => follows a1 a2 i j / gamma) (1 + n_max)) as (k2 & P2 & Mf).
  destruct (two_least (k1 / 2) (k2 / 4) ltac:(lra) ltac:(lra)) as (eps & He & He1 & He2).
  set (X := (1 + Rabs (Oscillator.c O) + Rabs (Oscillator.k O)) * (K * 2 + K * (2 * (6 * K ^ 5)))).
  assert (HX : 0 < X).
  { pose proof (Rabs_pos (Oscillator.c O)); pose proof (Rabs_pos (Oscillator.k O)); pose proof (pow_R1_Rle K 5 K1).
    apply Rmult_lt_0_compat; [lra|]; apply Rplus_lt_0_compat; apply Rmult_lt_0_compat; lra. }
  destruct (legs_near O m S V HT n_max K HK C eps HC He) as (d2 & D2 & Leg).
  destruct (gap_open O HT m C X eps HC HX He) as (d3 & D3 & Open).
  destruct (two_least mu1 d2 Hmu1 D2) as (d4 & D4 & L1 & L2), (two_least d4 d3 D4 D3) as (d5 & D5 & L3 & L4).
  destruct (two_least d5 (d / (C + 1)) D5 ltac:(apply Rdiv_lt_0_compat; lra)) as (mu0 & Hmu0 & L5 & L6).
  apply (Rmult_le_compat_l (C + 1)) in L6; [|lra]; replace ((C + 1) * (d / (C + 1))) with d in L6 by (field; lra).
  exists d, mu0, C; split; [lra|]; split; [exact Hmu0|]; intros N n s g mu Hw Hg Hmu.
  assert (NZ : mu <> 0) by (intros ->; lra); pose proof (Rabs_pos_lt mu NZ) as R.
  assert (Er : Rabs mu < mu0) by (destruct s; cbn in Hmu; unfold Rabs; destruct Rcase_abs; lra).
  assert (Cd : C * Rabs mu <= C * mu0) by (apply Rmult_le_compat_l; lra).
  pose proof (fun i => all_regular O m a1 a2 gamma S V HO HS n_max N n Hw i) as Reg.
  pose proof (fun i => conj (proj1 (Hw i)) (Reg i)) as HR.
  destruct (One n mu Reg ltac:(lra)) as (x & Hx & Law & Only).
  assert (Near : forall i, leg_near O m S V n_max K (n i) eps mu (x i) (x (i + 1)%Z)).
  { intros i; apply Leg; auto; lra. }
  assert (Mb' : forall i j, (j <= n_max)%nat -> b a1 a2 (n i) j <> 0 -> 2 * eps <= Rabs (b a1 a2 (n i) j)).
  { intros i j Hj Hne; destruct (Reg i); pose proof (Mb (n i) j ltac:(lia) ltac:(lia) Hne); lra. }
  assert (Mf' : forall i j, let f := follows a1 a2 (n i) (n j) / gamma in f <> 0 -> 4 * eps <= Rabs f).
  { intros i j f Hne; destruct (Reg i), (Reg j); pose proof (Mf (n i) (n j) ltac:(lia) ltac:(lia) Hne) as P;
      fold f in P; lra. }
  assert (Ph : forall t q v, motion O m mu d N t q v -> forall i, phase m N t i = x i).
  { intros t q v HM; apply Only; [intros i; apply (HM i _ eq_refl)|].
    apply (motion_law O m S V Htau HS n_max K HK mu d N n t q v HM HdK HR). }
  split; [|split].
  - intros Hs; exists (at_ m N x), (leg_q O m S V mu N n x), (leg_v O m S V mu N n x); split.
    + apply (solution_motion O m S V Htau HS n_max K mu C eps N n x HK HR Law Hx Near); [|lra | apply Open; lra |].
      * intros i; apply (jump_sign O m a1 a2 gamma S V HO HS n_max K mu eps N n s g x (proj1 Hmu) Hw Near Hg He
          Mf'), Hs.
      * intros i j Hj; apply (mid_sign O m a1 a2 gamma S V HO HS n_max K mu eps N n s x (proj1 Hmu) Hw Near He Mb' i
          j Hj).
        apply Hs, Hj.
    + intros t q v HM i y.
      destruct (motion_is O m S V HS n_max K mu N n x HK HR d t q v HM HdK (Ph _ _ _ HM) i) as [E F]; auto.
  - intros i Hs t q v HM.
    apply (word_fails O m a1 a2 gamma S V HO HS n_max K mu eps N n s g x HK (proj1 Hmu) Hw Near Hg He Mb' Mf' i Hs
      d t q v); try lra; [exact HM | exact (Ph t q v HM)].
  - intros t q v HM i; fold (phase m N t i); rewrite (Ph t q v HM); apply Hx.
Qed.
