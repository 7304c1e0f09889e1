(** * Motions near the touch and solutions of the law of impact are the same *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOscillator Derivatives Flow OscillatorTurns OscillatorStop OscillatorLaw.
Open Scope R_scope.

Section Motion.
Variables (O : Oscillator.t) (m : sign) (S V : R -> R).
Notation c := (Oscillator.c O).
Notation k := (Oscillator.k O).
Notation tau := (Oscillator.tau O).
Notation G := (Oscillator.G O).
Notation G1 := (Oscillator.G1 O).
Notation T := (turn m).
Notation place := (place O).
Notation aft := (aft O m S V).
Notation bef := (bef O m S V).
Notation mid := (mid O m S V).
Notation law := (law O m S V).
Notation phase := (phase m).
Notation moved := (moved c S V).
Notation moving := (moving k S V).
Hypothesis HO : touching O.
Hypothesis Htau : 0 <= tau.
Hypothesis HS : flow c k S V.
Variables (n_max : nat) (K mu h eps : R) (N : Z -> Z) (n : Z -> nat).
Hypothesis HK : bounds c k m S V n_max K.
Hypothesis Hmu : mu <> 0.
Hypothesis HN : forall i, N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\ regular m S n_max (n i).
Hypothesis Near : forall i x y, Rabs x <= h -> Rabs y <= h -> leg_near O m S V n_max (n i) eps mu x y.

Let NN i : N (i + 1)%Z = (N i + Z.of_nat (n i))%Z := proj1 (HN i).

(** ** From a motion to a solution *)
Lemma motion_law d t q v : motion O m mu d N t q v -> (forall i, Rabs (phase N t i) <= h * Rabs mu) ->
  let x i := phase N t i / mu in (forall i, Rabs (x i) <= h) /\ law n mu x /\ forall i,
  q i (t i) = facing m (N i) * (mu * place mu (x i)) /\
  v i (t i) = facing m (N i) * (mu * aft (n i) mu (x i) (x (i + 1)%Z)) /\
  mu * (bef (n i) mu (x i) (x (i + 1)%Z) - aft (n (i + 1)%Z) mu (x (i + 1)%Z) (x (i + 1 + 1)%Z)) < 0.
Proof.
  intros HM Hphase x; assert (Ex : forall i, phase N t i = mu * x i) by (intros; unfold x; field; exact Hmu).
  assert (Sx : forall i, Rabs (x i) <= h).
  { intros i; specialize (Hphase i); rewrite Ex, Rabs_mult in Hphase.
    apply (Rmult_le_reg_l (Rabs mu)); [apply Rabs_pos_lt, Hmu | lra]. }
  split; [exact Sx|].
  assert (Leg : forall i, q i (t i) = facing m (N i) * (mu * place mu (x i)) /\
    facing m (N i) * v i (t i) = mu * aft (n i) mu (x i) (x (i + 1)%Z) /\
    facing m (N (i + 1)%Z) * v i (t (i + 1)%Z) = mu * bef (n i) mu (x i) (x (i + 1)%Z)).
  { intros i; destruct (motion_leg O m S V HS mu d N (n i) t q v i HM (NN i)) as (_ & E & X & Y & _).
    rewrite !Ex in *; rewrite <- !(place_mu O) in * by exact Hmu.
    replace (mu * x (i + 1)%Z - mu * x i) with (mu * (x (i + 1)%Z - x i)) in * by ring.
    destruct (Near i (x i) (x (i + 1)%Z) (Sx _) (Sx _)) as [NS _ _ _ _].
    assert (Ea : facing m (N i) * v i (t i) = mu * aft (n i) mu (x i) (x (i + 1)%Z)).
    { unfold OscillatorLaw.aft, aft_leg, aft_of; apply (Rmult_eq_reg_l (turned m S (n i)
        (mu * (x (i + 1)%Z - x i)))); [|exact NS].
      transitivity (mu * place mu (x (i + 1)%Z) - turned m (e11 c S V) (n i) (mu * (x (i + 1)%Z - x i))
        * (mu * place mu (x i)));
        [lra | field; exact NS]. }
    split; [exact E|]; split; [exact Ea|]; rewrite Y, Ea; unfold OscillatorLaw.bef, OscillatorLaw.aft, bef_leg,
      bef_of, aft_leg; ring. }
  assert (Imp : forall i, mu * bef (n i) mu (x i) (x (i + 1)%Z) + G1 mu (mu * x (i + 1)%Z) < 0 /\
    mu * aft (n (i + 1)%Z) mu (x (i + 1)%Z) (x (i + 1 + 1)%Z) + G1 mu (mu * x (i + 1)%Z) =
    - tau * (mu * bef (n i) mu (x i) (x (i + 1)%Z) + G1 mu (mu * x (i + 1)%Z))).
  { intros i; destruct (motion_leg O m S V HS mu d N (n i) t q v i HM (NN i)) as (_ & _ & _ & _ & D & E).
    destruct (Leg i) as (_ & _ & B), (Leg (i + 1)%Z) as (_ & A & _); rewrite B, Ex in D; rewrite A, B, Ex in E;
      auto. }
  split.
  - intros i; destruct (Imp (i - 1)%Z) as [_ E]; replace (i - 1 + 1)%Z with i in E by lia.
    apply (Rmult_eq_reg_l mu); [|exact Hmu].
    replace (mu * ((1 + tau) * (G1 mu (mu * x i) / mu))) with ((1 + tau) * G1 mu (mu * x i)) by (field; exact Hmu);
      lra.
  - intros i; destruct (Leg i) as (A & B & C); destruct (Imp i) as [D E]; split; [exact A|]; split.
    + rewrite <- B, <- Rmult_assoc, side_square; ring.
    + assert (tau * (mu * bef (n i) mu (x i) (x (i + 1)%Z) + G1 mu (mu * x (i + 1)%Z)) <= tau * 0)
        by (apply Rmult_le_compat_l; lra); lra.
Qed.

(** ** From a solution to a motion *)
Section Solution.
Variable x : Z -> R.
Hypothesis HL : law n mu x.
Hypothesis Hx : forall i, Rabs (x i) <= h.
Let a i := aft (n i) mu (x i) (x (i + 1)%Z).
Let p i := bef (n i) mu (x i) (x (i + 1)%Z).
Definition at_ (i : Z) : R := T * IZR (N i) + mu * x i.
Definition leg_q (i : Z) : R -> R := moved (at_ i) (facing m (N i) * (mu * place mu (x i))) (facing m (N i) * (mu * a i)).
Definition leg_v (i : Z) : R -> R := moving (at_ i) (facing m (N i) * (mu * place mu (x i))) (facing m (N i)
  * (mu * a i)).
(** The same leg with its times and sides counted from stop N i. *)
Definition here (i : Z) : R -> R := moved (mu * x i) (mu * place mu (x i)) (mu * a i).
Definition heres (i : Z) : R -> R := moving (mu * x i) (mu * place mu (x i)) (mu * a i).

Lemma leg_here i s : leg_q i (T * IZR (N i) + s) = facing m (N i) * here i s /\
  leg_v i (T * IZR (N i) + s) = facing m (N i) * heres i s.
Proof.
  unfold leg_q, leg_v, here, heres, Flow.moved, Flow.moving, at_.
  replace (T * IZR (N i) + s - (T * IZR (N i) + mu * x i)) with (s - mu * x i) by ring; split; ring.
Qed.

Lemma gap_here i y s : gap O m mu (N i + y) (leg_q i) (T * IZR (N i) + s) = gap O m mu y (here i) s /\
  speed O m mu (N i + y) (leg_v i) (T * IZR (N i) + s) = speed O m mu y (heres i) s.
Proof.
  unfold gap, speed; destruct (leg_here i s) as [-> ->]; rewrite facing_plus, plus_IZR.
  replace (T * IZR (N i) + s - T * (IZR (N i) + IZR y)) with (s - T * IZR y) by ring.
  rewrite !side_twice; split; reflexivity.
Qed.

Lemma at_next i : at_ (i + 1) = T * IZR (N i) + (T * INR (n i) + mu * x (i + 1)%Z).
Proof. unfold at_; rewrite NN, plus_IZR, <- INR_IZR_INZ; ring. Qed.

Lemma here_start i : here i (mu * x i) = mu * place mu (x i) /\ heres i (mu * x i) = mu * a i.
Proof. apply (moved_start c k S V HS). Qed.

Lemma here_end i : let s := T * INR (n i) + mu * x (i + 1)%Z in let j := facing m (Z.of_nat (n i)) in
  j * here i s = mu * place mu (x (i + 1)%Z) /\ j * heres i s = mu * p i.
Proof.
  intros s j; destruct (Near i (x i) (x (i + 1)%Z) (Hx _) (Hx _)) as [NS _ _ _ _]; revert NS.
  unfold here, heres, Flow.moved, Flow.moving, p, OscillatorLaw.bef, a, OscillatorLaw.aft, aft_leg, bef_leg,
    bef_of, aft_of, turned.
  replace (s - mu * x i) with (T * INR (n i) + mu * (x (i + 1)%Z - x i)) by (unfold s; ring); fold j.
  set (t := T * INR (n i) + _); intros NS; split; field; split; intros E; apply NS; rewrite E; ring.
Qed.

(** The law, for an impact of relative speed - z before and tau z after. *)
Lemma impact i : let z := mu * (a (i + 1)%Z - p i) / (1 + tau) in
  mu * p i + G1 mu (mu * x (i + 1)%Z) = - z /\ mu * a (i + 1)%Z + G1 mu (mu * x (i + 1)%Z) = tau * z.
Proof.
  intros z; pose proof (HL (i + 1)%Z) as E; replace (i + 1 - 1)%Z with i in E by lia; fold (a (i + 1)%Z) (p i) in E.
  assert (Eg : (1 + tau) * G1 mu (mu * x (i + 1)%Z) = - mu * (a (i + 1)%Z + tau * p i)).
  { transitivity (mu * ((1 + tau) * (G1 mu (mu * x (i + 1)%Z) / mu))); [field; exact Hmu | rewrite E; ring]. }
  unfold z; split; apply (Rmult_eq_reg_l (1 + tau)); try lra.
  - rewrite Rmult_plus_distr_l, Eg; field; lra.
  - rewrite Rmult_plus_distr_l, Eg; field; lra.
Qed.

(** What [gap_open] says, for a given mu. *)
Definition opens (B kappa : R) : Prop := forall n q v w phi psi, (1 <= n)%nat ->
  (forall t, derivable_pt_lim q t (v t)) -> (forall t, derivable_pt_lim v t (w t)) ->
  (forall t, -1 <= t <= T * INR n + 1 -> Rabs (q t) <= B * Rabs mu /\ Rabs (v t) <= B * Rabs mu /\
    Rabs (w t) <= B * Rabs mu) ->
  Rabs phi <= h * Rabs mu -> Rabs (psi - T * INR n) <= h * Rabs mu ->
  gap O m mu 0 q phi = 0 -> gap O m mu (Z.of_nat n) q psi = 0 ->
  0 <= speed O m mu 0 v phi -> speed O m mu (Z.of_nat n) v psi <= 0 ->
  (forall j, (1 <= j <= n - 1)%nat -> kappa * Rabs mu <= facing m (Z.of_nat j) * q (T * INR j) + mu) ->
  forall z t, phi < t < psi -> 0 < gap O m mu z q t.

(** The place and the velocity of a leg have the size of mu. *)
Lemma here_bounds M i t : Rabs (a i) <= M -> h * Rabs mu <= 1 -> -1 <= t <= T * INR (n i) + 1 ->
  let B := (1 + Rabs c + Rabs k) * (K * 2 + K * M) in Rabs (here i t) <= B * Rabs mu /\
    Rabs (heres i t) <= B * Rabs mu /\
  Rabs (- c * heres i t - k * here i t) <= B * Rabs mu.
Proof.
  intros Ha H1 Ht B; destruct (HN i) as [_ [Hn _]]; destruct (Near i (x i) (x (i + 1)%Z) (Hx _) (Hx _))
    as [_ _ _ P _].
  assert (Sx : -1 <= mu * x i <= 1).
  { apply le_abs; rewrite Rabs_mult, Rmult_comm; apply (Rle_trans _ (h * Rabs mu)); [|exact H1].
    apply Rmult_le_compat_r; [apply Rabs_pos | apply Hx]. }
  assert (In : Rabs (t - mu * x i) <= T * INR n_max + 2).
  { pose proof (turn_large m); pose proof (pos_INR (n i)); pose proof (le_INR (n i) n_max (proj2 Hn)).
    assert (0 <= T * INR (n i) <= T * INR n_max) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_l]; lra).
    apply Rabs_le; lra. }
  destruct HK as (K1 & F & _); set (Q := K * 2 + K * M).
  assert (Q0 : 0 <= Q) by (pose proof (Rabs_pos (a i)); unfold Q; apply Rplus_le_le_0_compat; apply Rmult_le_pos;
    lra).
  assert (both : forall e f, entry c k S V e -> entry c k S V f ->
    Rabs (e (t - mu * x i) * (mu * place mu (x i)) + f (t - mu * x i) * (mu * a i)) <= Q * Rabs mu).
  { intros e f He Hf; destruct (F e He _ _ In In) as [Fe _], (F f Hf _ _ In In) as [Ff _].
    replace (_ + _) with ((e (t - mu * x i) * place mu (x i) + f (t - mu * x i) * a i) * mu) by ring.
    rewrite Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos|]; eapply Rle_trans; [apply Rabs_triang|].
    pose proof (product _ _ _ _ Fe P); pose proof (product _ _ _ _ Ff Ha); unfold Q; lra. }
  assert (Bh : Rabs (here i t) <= Q * Rabs mu) by (apply (both (e11 c S V) S); unfold entry; auto).
  assert (Bv : Rabs (heres i t) <= Q * Rabs mu) by (apply (both (e21 k S) V); unfold entry; auto).
  pose proof (Rabs_pos c); pose proof (Rabs_pos k); pose proof (Rabs_pos mu).
  set (z := Q * Rabs mu) in *; assert (Z : 0 <= z) by (apply Rmult_le_pos; lra).
  replace (B * Rabs mu) with (z + Rabs c * z + Rabs k * z) by (unfold B, z; fold Q; ring).
  assert (0 <= Rabs c * z /\ 0 <= Rabs k * z) as [P1 P2] by (split; apply Rmult_le_pos; lra).
  split; [lra|]; split; [lra|]; eapply Rle_trans; [apply apart|].
  rewrite <- Rabs_Ropp in Bv; pose proof (product c _ _ _ (Rle_refl _) Bv) as X;
    pose proof (product k _ _ _ (Rle_refl _) Bh).
  replace (c * - heres i t) with (- c * heres i t) in X by ring; lra.
Qed.

Lemma solution_motion d M kappa : (forall i, 0 < mu * (a (i + 1)%Z - p i)) -> h * Rabs mu <= d -> h * Rabs mu <= 1 ->
  (forall i, Rabs (a i) <= M) -> opens ((1 + Rabs c + Rabs k) * (K * 2 + K * M)) kappa ->
  (forall i j, (1 <= j <= n i - 1)%nat -> kappa * Rabs mu <= facing m (Z.of_nat j) * here i (T * INR j) + mu) ->
  motion O m mu d N at_ leg_q leg_v.
Proof.
  intros Hv Hd H1 HM Open Mid i j ->.
  assert (Sm : forall i, Rabs (mu * x i) <= h * Rabs mu).
  { intros l; rewrite Rabs_mult, Rmult_comm; apply Rmult_le_compat_r; [apply Rabs_pos | apply Hx]. }
  destruct (HN i) as [_ [Hn _]]; pose proof (turn_large m) as HT.
  assert (Tn : T <= T * INR (n i)) by (rewrite <- (Rmult_1_r T) at 1; apply Rmult_le_compat_l;
    [lra | apply (le_INR 1); lia]).
  pose proof (Sm i) as S1; pose proof (Sm (i + 1)%Z) as S2.
  assert (-1 <= mu * x i <= 1) by (apply le_abs; lra); assert (-1 <= mu * x (i + 1)%Z <= 1) by (apply le_abs; lra).
  destruct (here_start i) as [E0 F0], (here_end i) as [E1 F1]; cbv zeta in E1, F1.
  destruct (impact i) as [I1 I2]; cbv zeta in I1, I2.
  assert (Pos : forall l, 0 < mu * (a (l + 1)%Z - p l) / (1 + tau)) by (intros l; apply Rdiv_lt_0_compat;
    [apply Hv | lra]).
  assert (Stop0 : forall y, gap O m mu 0 y (mu * x i) = y (mu * x i) + mu + G mu (mu * x i)).
  { intros y; unfold gap; rewrite side_0, Rmult_0_r, Rminus_0_r; ring. }
  set (s := T * INR (n i) + mu * x (i + 1)%Z) in *.
  assert (Es : s - T * IZR (Z.of_nat (n i)) = mu * x (i + 1)%Z) by (unfold s; rewrite <- INR_IZR_INZ; ring).
  assert (Gap0 : gap O m mu 0 (here i) (mu * x i) = 0) by (rewrite Stop0, E0, (place_mu O) by exact Hmu; ring).
  assert (Gap1 : gap O m mu (Z.of_nat (n i)) (here i) s = 0).
  { unfold gap; rewrite Es, E1, (place_mu O) by exact Hmu; ring. }
  assert (Speed1 : speed O m mu (Z.of_nat (n i)) (heres i) s = - (mu * (a (i + 1)%Z - p i) / (1 + tau))).
  { unfold speed; rewrite Es, F1; exact I1. }
  assert (Ea : at_ i = T * IZR (N i) + mu * x i) by reflexivity; pose proof (at_next i) as Eb; fold s in Eb.
  assert (Free : free c k (here i) (heres i)) by apply (moved_free c k S V HS).
  split; [apply (moved_free c k S V HS)|]; split; [|split; [|split; [|split; [|split; [|split]]]]].
  - rewrite Ea; replace (_ - _) with (mu * x i) by ring; lra.
  - rewrite Ea, Eb; unfold s; lra.
  - rewrite Ea, <- (Z.add_0_r (N i)) at 1; rewrite (proj1 (gap_here i 0 _)); exact Gap0.
  - rewrite Eb, NN, (proj1 (gap_here i _ _)); exact Gap1.
  - intros z y Hy; set (r := y - T * IZR (N i)); replace y with (T * IZR (N i) + r) by (unfold r; ring).
    replace z with (N i + (z - N i))%Z by lia; rewrite (proj1 (gap_here i _ _)).
    apply (Open (n i) (here i) (heres i) (fun t => - c * heres i t - k * here i t) (mu * x i) s); trivial.
    + apply Hn.
    + apply Free.
    + apply Free.
    + intros t Ht; apply here_bounds; auto.
    + replace (s - T * INR (n i)) with (mu * x (i + 1)%Z) by (unfold s; ring); exact S2.
    + destruct (impact (i - 1)) as [_ I]; specialize (Pos (i - 1)%Z); replace (i - 1 + 1)%Z with i in I, Pos by lia.
      unfold speed; rewrite side_0, Rmult_0_r, Rminus_0_r, F0, Rmult_1_l, I; apply Rmult_le_pos; lra.
    + rewrite Speed1; specialize (Pos i); lra.
    + intros j Hj; apply Mid, Hj.
    + rewrite Ea, Eb in Hy; unfold r; lra.
  - rewrite Eb, NN, (proj2 (gap_here i _ _)), Speed1; specialize (Pos i); lra.
  - pose proof (proj2 (gap_here (i + 1) 0 (mu * x (i + 1)%Z))) as Q; rewrite Z.add_0_r in Q; fold (at_ (i + 1)) in Q.
    rewrite Q; unfold speed at 1; rewrite side_0, Rmult_0_r, Rminus_0_r, Rmult_1_l, (proj2 (here_start (i + 1))), I2.
    rewrite Eb, NN, (proj2 (gap_here i _ _)), Speed1; ring.
Qed.
End Solution.
End Motion.
