(** * A solution of the law of impact is a motion, and the only one near the touch *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOscillator Derivatives Flow OscillatorTurns OscillatorStop OscillatorGap
  OscillatorLaw.
Open Scope R_scope.

Section Motion.
Variables (O : Oscillator.t) (m : sign) (S V : R -> R).
Notation c := (Oscillator.c O).
Notation k := (Oscillator.k O).
Notation tau := (Oscillator.tau O).
Notation G1 := (Oscillator.G1 O).
Notation T := (turn m).
Hypothesis Htau : 0 <= tau.
Hypothesis HS : flow c k S V.
Variables (n_max : nat) (K mu h eps : R) (N : Z -> Z) (n : Z -> nat) (x : Z -> R).
Hypothesis HK : bounds c k m S V n_max K.
Hypothesis HN : forall i, N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\ regular m S n_max (n i).
Hypothesis HL : law O m S V n mu x.
Hypothesis Hx : forall i, Rabs (x i) <= h * Rabs mu.
Hypothesis Near : forall i, leg_near O m S V n_max K (n i) eps mu (x i) (x (i + 1)%Z).
Notation place := (place O mu).
Let a i := aft O m S V (n i) mu (x i) (x (i + 1)%Z).
Let b i := bef O m S V (n i) mu (x i) (x (i + 1)%Z).

(** The leg after impact i, its times and sides counted from stop N i; and as they are. *)
Definition here (i : Z) : R -> R := moved c S V (x i) (place (x i)) (a i).
Definition heres (i : Z) : R -> R := moving k S V (x i) (place (x i)) (a i).
Definition at_ (i : Z) : R := T * IZR (N i) + x i.
Definition leg_q (i : Z) (t : R) : R := facing m (N i) * here i (t - T * IZR (N i)).
Definition leg_v (i : Z) (t : R) : R := facing m (N i) * heres i (t - T * IZR (N i)).

Lemma here_free i : free c k (here i) (heres i).
Proof. apply (moved_free c k S V HS). Qed.
Lemma leg_free i : free c k (leg_q i) (leg_v i).
Proof.
  intros t; destruct (here_free i (t - T * IZR (N i))) as [A B]; unfold leg_q, leg_v.
  split; [apply D_scale, D_at, A|]; eapply D_value; [apply D_scale, D_at, B | ring].
Qed.

Lemma gap_here i z s : gap O m mu (N i + z) (leg_q i) (T * IZR (N i) + s) = gap O m mu z (here i) s /\
  speed O m mu (N i + z) (leg_v i) (T * IZR (N i) + s) = speed O m mu z (heres i) s.
Proof.
  unfold gap, speed, leg_q, leg_v; rewrite facing_plus, plus_IZR, !side_twice.
  replace (T * IZR (N i) + s - T * IZR (N i)) with s by ring.
  replace (T * IZR (N i) + s - T * (IZR (N i) + IZR z)) with (s - T * IZR z) by ring; split; reflexivity.
Qed.

Lemma at_next i : at_ (i + 1) = T * IZR (N i) + (T * INR (n i) + x (i + 1)%Z).
Proof. unfold at_; rewrite (proj1 (HN i)), plus_IZR, <- INR_IZR_INZ; ring. Qed.

Lemma here_start i : here i (x i) = place (x i) /\ heres i (x i) = a i.
Proof. apply (moved_start c k S V HS). Qed.

Lemma here_end i : let s := T * INR (n i) + x (i + 1)%Z in
  facing m (Z.of_nat (n i)) * here i s = place (x (i + 1)%Z) /\ facing m (Z.of_nat (n i)) * heres i s = b i.
Proof.
  intros s; pose proof (near_S _ _ _ _ _ _ _ _ _ _ _ (Near i)) as NS; revert NS.
  unfold here, heres, moved, moving, b, bef, a, aft, aft_leg, bef_leg, bef_of, aft_of, turned.
  replace (s - x i) with (T * INR (n i) + (x (i + 1)%Z - x i)) by (unfold s; ring).
  set (t := T * INR (n i) + _); intros NS; split; field; split; intros E; apply NS; rewrite E; ring.
Qed.

(** The law, for an impact of relative speed - z before and tau z after. *)
Lemma impact i : let z := (a (i + 1)%Z - b i) / (1 + tau) in
  b i + G1 mu (x (i + 1)%Z) = - z /\ a (i + 1)%Z + G1 mu (x (i + 1)%Z) = tau * z.
Proof.
  intros z; pose proof (HL (i + 1)%Z) as E; replace (i + 1 - 1)%Z with i in E by lia; fold (a (i + 1)%Z) (b i) in E.
  assert (G1 mu (x (i + 1)%Z) = - (a (i + 1)%Z + tau * b i) / (1 + tau)) as -> by (rewrite <- E; field; lra).
  unfold z; split; field; lra.
Qed.

(** The place and the velocity of a leg have the size of mu. *)
Lemma here_bounds i t : h * Rabs mu <= 1 -> -1 <= t <= T * INR (n i) + 1 ->
  let B := (1 + Rabs c + Rabs k) * (K * 2 + K * (2 * (6 * K ^ 5))) in Rabs (here i t) <= B * Rabs mu /\
  Rabs (heres i t) <= B * Rabs mu /\ Rabs (- c * heres i t - k * here i t) <= B * Rabs mu.
Proof.
  intros H1 Ht B; destruct (HN i) as [_ [Hn _]]; destruct (Near i) as [_ _ _ P A _].
  assert (In : Rabs (t - x i) <= T * INR n_max + 2).
  { pose proof (le_abs _ _ (Hx i)); pose proof (turn_large m); pose proof (pos_INR (n i)).
    pose proof (le_INR (n i) n_max (proj2 Hn)).
    assert (0 <= T * INR (n i) <= T * INR n_max) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_l]; lra).
    apply Rabs_le; lra. }
  destruct HK as (K1 & F & _); set (z := (K * 2 + K * (2 * (6 * K ^ 5))) * Rabs mu).
  assert (both : forall e f, entry c k S V e -> entry c k S V f ->
    Rabs (e (t - x i) * place (x i) + f (t - x i) * a i) <= z).
  { intros e f He Hf; destruct (F e He _ _ In In) as [Fe _], (F f Hf _ _ In In) as [Ff _].
    pose proof (product _ _ _ _ Fe P); pose proof (product _ _ _ _ Ff A); eapply Rle_trans; [apply Rabs_triang|].
    unfold z, a; lra. }
  assert (Bh : Rabs (here i t) <= z) by (apply (both (e11 c S V) S); unfold entry; auto).
  assert (Bv : Rabs (heres i t) <= z) by (apply (both (e21 k S) V); unfold entry; auto).
  assert (Pz : 0 <= z) by (eapply Rle_trans; [apply Rabs_pos | exact Bh]).
  replace (B * Rabs mu) with (z + Rabs c * z + Rabs k * z) by (unfold B, z; ring).
  pose proof (Rmult_le_pos _ _ (Rabs_pos c) Pz); pose proof (Rmult_le_pos _ _ (Rabs_pos k) Pz).
  split; [lra|]; split; [lra|]; eapply Rle_trans; [apply apart|].
  pose proof (product (- c) _ _ _ (Rle_refl _) Bv) as X; rewrite (Rabs_Ropp c) in X.
  pose proof (product k _ _ _ (Rle_refl _) Bh); lra.
Qed.

Lemma solution_motion d : (forall i, b i < a (i + 1)%Z) -> h * Rabs mu <= d <= 1 ->
  opens O m h ((1 + Rabs c + Rabs k) * (K * 2 + K * (2 * (6 * K ^ 5)))) eps mu ->
  (forall i j, (1 <= j <= n i - 1)%nat -> eps * Rabs mu <= facing m (Z.of_nat j) * here i (T * INR j) + mu) ->
  motion O m mu d N at_ leg_q leg_v.
Proof.
  intros Hv Hd Open Mid i j ->; destruct (HN i) as [NN [Hn _]]; pose proof (turn_large m) as HT.
  assert (Tn : T <= T * INR (n i)) by (rewrite <- (Rmult_1_r T) at 1; apply Rmult_le_compat_l;
    [lra | apply (le_INR 1); lia]).
  assert (Sm : forall i, - (h * Rabs mu) <= x i <= h * Rabs mu) by (intros l; apply le_abs, Hx).
  pose proof (Sm i); pose proof (Sm (i + 1)%Z); destruct (here_start i) as [E0 F0], (here_end i) as [E1 F1].
  pose proof (fun l => impact l) as I; cbv zeta in I, E1, F1;
    set (z := fun l => (a (l + 1)%Z - b l) / (1 + tau)) in *.
  assert (Pos : forall l, 0 < z l) by (intros l; apply Rdiv_lt_0_compat; [specialize (Hv l)|]; lra).
  set (s := T * INR (n i) + x (i + 1)%Z) in *.
  assert (Es : s - T * IZR (Z.of_nat (n i)) = x (i + 1)%Z) by (unfold s; rewrite <- INR_IZR_INZ; ring).
  assert (Gap0 : gap O m mu 0 (here i) (x i) = 0).
  { unfold gap; rewrite side_0, Rmult_0_r, Rminus_0_r, E0; unfold OscillatorLaw.place; ring. }
  assert (Gap1 : gap O m mu (Z.of_nat (n i)) (here i) s = 0).
  { unfold gap; rewrite Es, E1; unfold OscillatorLaw.place; ring. }
  assert (Speed1 : speed O m mu (Z.of_nat (n i)) (heres i) s = - z i) by (unfold speed; rewrite Es, F1; apply I).
  assert (Speed0 : forall l, speed O m mu 0 (heres (l + 1)) (x (l + 1)%Z) = tau * z l).
  { intros l; unfold speed; rewrite side_0, Rmult_0_r, Rminus_0_r, Rmult_1_l, (proj2 (here_start (l + 1))); apply I. }
  assert (Ea : at_ i = T * IZR (N i) + x i) by reflexivity; pose proof (at_next i) as Eb; fold s in Eb.
  split; [apply leg_free|]; split; [|split; [|split; [|split; [|split; [|split]]]]].
  - rewrite Ea; replace (_ - _) with (x i) by ring; apply Rabs_le; lra.
  - rewrite Ea, Eb; unfold s; lra.
  - rewrite Ea, <- (Z.add_0_r (N i)) at 1; rewrite (proj1 (gap_here i 0 _)); exact Gap0.
  - rewrite Eb, NN, (proj1 (gap_here i _ _)); exact Gap1.
  - intros y r Hr; replace r with (T * IZR (N i) + (r - T * IZR (N i))) by ring.
    replace y with (N i + (y - N i))%Z by lia; rewrite (proj1 (gap_here i _ _)).
    apply (Open (n i) (here i) (heres i) (fun t => - c * heres i t - k * here i t) (x i) (x (i + 1)%Z)); auto.
    + apply Hn.
    + apply here_free.
    + apply here_free.
    + intros t Ht; apply here_bounds; [lra | exact Ht].
    + replace i with (i - 1 + 1)%Z by lia; rewrite Speed0; specialize (Pos (i - 1)%Z); apply Rmult_le_pos; lra.
    + fold s; rewrite Speed1; specialize (Pos i); lra.
    + fold s; lra.
  - rewrite Eb, NN, (proj2 (gap_here i _ _)), Speed1; specialize (Pos i); lra.
  - pose proof (proj2 (gap_here (i + 1) 0 (x (i + 1)%Z))) as Q; rewrite Z.add_0_r in Q; fold (at_ (i + 1)) in Q.
    rewrite Q, Speed0, Eb, NN, (proj2 (gap_here i _ _)), Speed1; ring.
Qed.

(** A motion with these phases. *)
Lemma motion_is d t q v : motion O m mu d N t q v -> 2 * d <= / K -> (forall i, phase m N t i = x i) -> forall i,
  t i = at_ i /\ forall s, q i s = leg_q i s /\ v i s = leg_v i s.
Proof.
  intros HM Hd Ex i; assert (Et : t i = at_ i) by (unfold at_; rewrite <- (Ex i); unfold phase; ring).
  split; [exact Et|]; intros s; destruct (HM i _ eq_refl) as (F & _).
  destruct (motion_leg O m S V HS n_max K HK mu d N n t q v HM Hd HN i) as (_ & Eq & Ev & _).
  rewrite Ex in Eq; rewrite (Ex i), (Ex (i + 1)%Z) in Ev; fold (a i) in Ev;
    destruct (free_moved c k S V HS _ _ (t i) s F) as [-> ->].
  rewrite Eq, Ev, Et; unfold leg_q, leg_v, here, heres, moved, moving, at_.
  replace (s - (T * IZR (N i) + x i)) with (s - T * IZR (N i) - x i) by ring; split; ring.
Qed.
End Motion.
