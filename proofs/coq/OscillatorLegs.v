(** * The legs from given phases of impact and velocities after them are a motion where they obey the law of impact *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOscillator Derivatives Flow OscillatorTurns OscillatorGap OscillatorLaw.
Open Scope R_scope.

Section Legs.
Variables (O : Oscillator.t) (m : sign) (S V : R -> R).
Notation c := (Oscillator.c O).
Notation k := (Oscillator.k O).
Notation tau := (Oscillator.tau O).
Notation G1 := (Oscillator.G1 O).
Notation T := (turn m).
Hypothesis HS : flow c k S V.
Variables (n_max : nat) (K mu h eps d : R) (N : Z -> Z) (n : Z -> nat) (x a : Z -> R).
Notation place := (place O mu).
Hypothesis HK : bounds c k m S V n_max K.
Hypothesis HN : forall i, N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\ regular m S n_max (n i).
Hypothesis Hx : forall i, Rabs (x i) <= h * Rabs mu.
Hypothesis Hd : h * Rabs mu <= d <= 1.
Hypothesis Near : forall i, leg_near O m S V n_max K (n i) eps mu (x i) (x (i + 1)%Z).
Hypothesis Open : opens O m h ((1 + Rabs c + Rabs k) * (K * 2 + K * (2 * (6 * K ^ 5)))) eps mu.
Notation aft i := (aft O m S V (n i%Z) mu (x i%Z) (x (i + 1)%Z)).
Notation bef i := (bef O m S V (n i%Z) mu (x i%Z) (x (i + 1)%Z)).

(** The leg after impact i, its times and sides counted from stop N i; and as they are. *)
Definition here (i : Z) : R -> R := moved c S V (x i) (place (x i)) (a i).
Definition heres (i : Z) : R -> R := moving k S V (x i) (place (x i)) (a i).
Definition at_ (i : Z) : R := T * IZR (N i) + x i.
Definition leg_q (i : Z) (t : R) : R := facing m (N i) * here i (t - T * IZR (N i)).
Definition leg_v (i : Z) (t : R) : R := facing m (N i) * heres i (t - T * IZR (N i)).

Lemma here_free i : free c k (here i) (heres i). Proof. apply (moved_free c k S V HS). Qed.
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
Lemma here_end i : a i = aft i -> let s := T * INR (n i) + x (i + 1)%Z in
  facing m (Z.of_nat (n i)) * here i s = place (x (i + 1)%Z) /\ facing m (Z.of_nat (n i)) * heres i s = bef i.
Proof.
  intros Ea s; pose proof (near_S _ _ _ _ _ _ _ _ _ _ _ (Near i)) as NS; revert NS.
  unfold here, heres, moved, moving; rewrite Ea.
  unfold OscillatorLaw.bef, OscillatorLaw.aft, aft_leg, bef_leg, bef_of, aft_of, turned.
  replace (s - x i) with (T * INR (n i) + (x (i + 1)%Z - x i)) by (unfold s; ring).
  set (t := T * INR (n i) + _); intros NS; split; field; split; intros E; apply NS; rewrite E; ring.
Qed.

(** The place and the velocity of a leg have the size of mu. *)
Lemma here_bounds i t : a i = aft i -> -1 <= t <= T * INR (n i) + 1 ->
  let B := (1 + Rabs c + Rabs k) * (K * 2 + K * (2 * (6 * K ^ 5))) in Rabs (here i t) <= B * Rabs mu /\
  Rabs (heres i t) <= B * Rabs mu /\ Rabs (- c * heres i t - k * here i t) <= B * Rabs mu.
Proof.
  intros Ea Ht B; destruct (HN i) as [_ [Hn _]]; destruct (Near i) as [_ _ _ P A _]; rewrite <- Ea in A.
  assert (In : Rabs (t - x i) <= T * INR n_max + 2).
  { pose proof (le_abs _ _ (Hx i)); pose proof (turn_large m); pose proof (pos_INR (n i)).
    pose proof (le_INR (n i) n_max (proj2 Hn)).
    assert (0 <= T * INR (n i) <= T * INR n_max) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_l]; lra).
    apply Rabs_le; lra. }
  destruct HK as (K1 & F & _); set (z := (K * 2 + K * (2 * (6 * K ^ 5))) * Rabs mu).
  assert (both : forall e f, entry c k S V e -> entry c k S V f -> Rabs (e (t - x i) * place (x i) + f (t - x i) * a i)
    <= z).
  { intros e f He Hf; destruct (F e He _ _ In In) as [Fe _], (F f Hf _ _ In In) as [Ff _].
    pose proof (product _ _ _ _ Fe P); pose proof (product _ _ _ _ Ff A); eapply Rle_trans; [apply Rabs_triang|].
    unfold z; lra. }
  assert (Bh : Rabs (here i t) <= z) by (apply (both (e11 c S V) S); unfold entry; auto).
  assert (Bv : Rabs (heres i t) <= z) by (apply (both (e21 k S) V); unfold entry; auto).
  assert (Pz : 0 <= z) by (eapply Rle_trans; [apply Rabs_pos | exact Bh]).
  replace (B * Rabs mu) with (z + Rabs c * z + Rabs k * z) by (unfold B, z; ring).
  pose proof (Rmult_le_pos _ _ (Rabs_pos c) Pz); pose proof (Rmult_le_pos _ _ (Rabs_pos k) Pz).
  split; [lra|]; split; [lra|]; eapply Rle_trans; [apply apart|].
  pose proof (product (- c) _ _ _ (Rle_refl _) Bv) as X; rewrite (Rabs_Ropp c) in X.
  pose proof (product k _ _ _ (Rle_refl _) Bh); lra.
Qed.

(** The leg from impact i to the next obeys the law of impact there, and its start may be an impact, too. *)
Record lawful (i : Z) : Prop := {
  lawful_leg : a i = aft i;
  lawful_from : 0 <= a i + G1 mu (x i);
  lawful_hits : bef i + G1 mu (x (i + 1)%Z) < 0;
  lawful_back : a (i + 1)%Z + G1 mu (x (i + 1)%Z) = - tau * (bef i + G1 mu (x (i + 1)%Z)) }.
Lemma lawful_swing i : lawful i -> (forall j, (1 <= j <= n i - 1)%nat -> eps * Rabs mu <= facing m (Z.of_nat j) * here i
  (T * INR j) + mu) -> swing O m mu d N at_ leg_q leg_v i (i + 1)%Z.
Proof.
  intros [La Lf Lh Lb] Mid; destruct (HN i) as [NN [Hn _]]; pose proof (turn_large m) as HT.
  assert (Tn : T <= T * INR (n i)) by (rewrite <- (Rmult_1_r T) at 1; apply Rmult_le_compat_l; [lra | apply (le_INR 1);
    lia]).
  assert (Sm : forall i, - (h * Rabs mu) <= x i <= h * Rabs mu) by (intros l; apply le_abs, Hx).
  pose proof (Sm i); pose proof (Sm (i + 1)%Z); destruct (here_start i) as [E0 F0], (here_end i La) as [E1 F1].
  set (s := T * INR (n i) + x (i + 1)%Z) in *.
  assert (Es : s - T * IZR (Z.of_nat (n i)) = x (i + 1)%Z) by (unfold s; rewrite <- INR_IZR_INZ; ring).
  assert (Gap0 : gap O m mu 0 (here i) (x i) = 0).
  { unfold gap; rewrite side_0, Rmult_0_r, Rminus_0_r, E0; unfold OscillatorLaw.place; ring. }
  assert (Gap1 : gap O m mu (Z.of_nat (n i)) (here i) s = 0).
  { unfold gap; rewrite Es, E1; unfold OscillatorLaw.place; ring. }
  assert (Speed1 : speed O m mu (Z.of_nat (n i)) (heres i) s = bef i + G1 mu (x (i + 1)%Z)) by (unfold speed; rewrite
    Es, F1; reflexivity).
  assert (Speed0 : forall l, speed O m mu 0 (heres l) (x l) = a l + G1 mu (x l)).
  { intros l; unfold speed; rewrite side_0, Rmult_0_r, Rminus_0_r, Rmult_1_l, (proj2 (here_start l)); reflexivity. }
  assert (Ea : at_ i = T * IZR (N i) + x i) by reflexivity; pose proof (at_next i) as Eb; fold s in Eb.
  constructor; [apply leg_free|..].
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
    + intros t Ht; apply here_bounds; [exact La | exact Ht].
    + rewrite Speed0; exact Lf.
    + fold s; rewrite Speed1; lra.
    + fold s; lra.
  - rewrite Eb, NN, (proj2 (gap_here i _ _)), Speed1; exact Lh.
  - pose proof (proj2 (gap_here (i + 1) 0 (x (i + 1)%Z))) as Q; rewrite Z.add_0_r in Q; fold (at_ (i + 1)) in Q.
    rewrite Q, Speed0, Eb, NN, (proj2 (gap_here i _ _)), Speed1; exact Lb.
Qed.
End Legs.
