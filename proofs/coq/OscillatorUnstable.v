(** * What is born is unstable: the law of impact, a contraction of phases, has solutions that end next to those of a
      motion, and halve what is between them from impact to impact, backwards *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOscillator StatementUnstable Contraction Derivatives Flow PlaneLinear
  OscillatorTurns OscillatorStop OscillatorGap OscillatorLaw OscillatorLegs OscillatorWords.
Open Scope R_scope.

Lemma halves_small c e : 0 < e -> exists k, c / 2 ^ k < e.
Proof.
  intros He; destruct (powers_small (/ 2) c e ltac:(lra) He) as [k Hk]; exists k; rewrite pow_inv in Hk; exact Hk.
Qed.

Section Ends.
Variables (O : Oscillator.t) (m : sign) (S V : R -> R) (n_max : nat) (mu d s : R) (n : Z -> nat) (x : Z -> R) (l : Z).
Notation tau := (Oscillator.tau O).
Notation next := (next O m S V n mu).
Hypothesis HO : touching O.
Hypothesis Htau : 0 <= tau.
Hypothesis Nr : nearer O m S V n_max d mu.
Hypothesis Hn : forall i, regular m S n_max (n i).
Hypothesis Hs : 0 <= s.
Hypothesis Hx : forall i, Rabs (x i) + s <= d.
Hypothesis HL : law O m S V n mu x.

(** s at l, and half as much at each impact before. *)
Definition fading (i : Z) : R := s / 2 ^ Z.to_nat (l - i).
Lemma fading_end i : (l <= i)%Z -> fading i = s.
Proof. intros H; unfold fading; replace (Z.to_nat (l - i)) with 0%nat by lia; cbn; field. Qed.
Lemma fading_next i : (i < l)%Z -> fading i = fading (i + 1) / 2.
Proof.
  intros H; unfold fading; replace (Z.to_nat (l - i)) with (Datatypes.S (Z.to_nat (l - (i + 1)))) by lia; cbn [pow].
  field; apply pow_nonzero; lra.
Qed.
Lemma fading_le i : 0 <= fading i <= s.
Proof.
  unfold fading; pose proof (pow_R1_Rle 2 (Z.to_nat (l - i)) ltac:(lra)); split.
  - apply Rmult_le_pos; [exact Hs | left; apply Rinv_0_lt_compat; lra].
  - apply (Rmult_le_reg_r (2 ^ Z.to_nat (l - i))); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra.
    rewrite Rmult_1_r; rewrite <- (Rmult_1_r s) at 1; apply Rmult_le_compat_l; lra.
Qed.
Lemma fading_rises i j : (j <= i + 1)%Z -> fading j <= fading (i + 1).
Proof.
  intros H; destruct (Z_lt_le_dec j l) as [L|L]; [|rewrite !fading_end by lia; lra].
  replace j with (i + 1 - Z.of_nat (Z.to_nat (i + 1 - j)))%Z by lia; generalize (Z.to_nat (i + 1 - j)).
  induction n0 as [|k IH]; [rewrite Z.sub_0_r; lra|]; apply Rle_trans with (2 := IH); clear IH.
  set (z := (i + 1 - Z.of_nat k)%Z); replace (i + 1 - _)%Z with (z - 1)%Z by lia.
  destruct (Z_lt_le_dec (z - 1) l); [|rewrite !fading_end by lia; lra].
  rewrite (fading_next (z - 1)) by assumption; replace (z - 1 + 1)%Z with z by lia; pose proof (fading_le z); lra.
Qed.

Theorem other_end : exists x', x' l = x l + s /\ (forall i, Rabs (x' i - x i) <= fading i) /\
  forall i, (i < l)%Z -> next x' i = x' i.
Proof.
  set (T := fun (z : Z -> R) i => if Z_lt_le_dec i l then next z i else x i + s).
  assert (Fix : forall i, next x i = x i) by (apply (law_fixed O m S V HO Htau), HL).
  assert (In : forall z, inside (fun i => x i - fading i) (fun i => x i + fading i) z -> forall j, Rabs (z j) <= d /\
    Rabs (z j - x j) <= fading j).
  { intros z Hz j; specialize (Hz j); pose proof (Hx j) as X; pose proof (fading_le j).
    assert (Rabs (z j - x j) <= fading j) as A by (apply Rabs_le; lra); split; [|exact A].
    replace (z j) with ((z j - x j) + x j) by ring; eapply Rle_trans; [apply Rabs_triang | lra]. }
  assert (Xd : forall j, Rabs (x j) <= d) by (intros j; specialize (Hx j); lra).
  destruct (one_fixed_point (fun i => x i - fading i) (fun i => x i + fading i) (fun _ => 1) T (1 / 2) (2 * s)) as (x' &
    Hx' & F & _).
  - intros i; pose proof (fading_le i); lra.
  - intros; lra.
  - lra.
  - split; [lra|]; intros i; pose proof (fading_le i); lra.
  - intros z Hz i; unfold T; destruct (Z_lt_le_dec i l) as [L|L]; [|rewrite fading_end by exact L; lra].
    destruct (Nr n z x i (fading (i + 1)) Hn) as [A _].
    { intros j Hj; split; [apply In, Hz | split; [apply Xd|]]; apply Rle_trans with (fading j); [apply In, Hz|].
      apply fading_rises; lia. }
    rewrite Fix in A; rewrite (fading_next i L); apply le_abs in A; lra.
  - intros e z z' He Hz Hz' Hzz i; unfold T; destruct (Z_lt_le_dec i l) as [L|L].
    + destruct (Nr n z z' i e Hn) as [A _]; [|lra]; intros j _; split; [apply In, Hz | split; [apply In, Hz'|]].
      specialize (Hzz j); lra.
    + rewrite Rminus_eq_0, Rabs_R0; lra.
  - exists x'; split; [|split].
    + rewrite <- F; unfold T; destruct Z_lt_le_dec; [lia | reflexivity].
    + intros i; apply In, Hx'.
    + intros i L; specialize (F i); unfold T in F; destruct Z_lt_le_dec; [exact F | lia].
Qed.
End Ends.

(** ** A motion whose word satisfies (52) and (64) is unstable: some that end next to it were next to it always *)
Section Away.
Variables (O : Oscillator.t) (m : sign) (a1 a2 gamma : R) (S V : R -> R) (n_max : nat) (K mu h eps s d : R) (N : Z -> Z)
  (n : Z -> nat) (x : Z -> R) (e g : sign).
Notation c := (Oscillator.c O).
Notation k := (Oscillator.k O).
Notation tau := (Oscillator.tau O).
Notation G1 := (Oscillator.G1 O).
Notation G2 := (Oscillator.G2 O 0 0).
Hypothesis HO : grazing O m a1 a2 gamma.
Hypothesis HS : flow c k S V.
Hypothesis HK : bounds c k m S V n_max K.
Hypothesis HN : forall i, N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\ regular m S n_max (n i).
Hypothesis HL : law O m S V n mu x.
Hypothesis Nr : nearer O m S V n_max d mu.
Hypothesis Leg : forall n x y, regular m S n_max n -> Rabs x <= h * Rabs mu -> Rabs y <= h * Rabs mu ->
  leg_near O m S V n_max K n eps mu x y.
Hypothesis Hx : forall i, Rabs (x i) + s <= h * Rabs mu.
Hypothesis Hd : h * Rabs mu <= d <= 1 /\ 2 * d <= / K.
Hypothesis Hs : 0 < s /\ 3 * G2 * s * (1 + tau) <= eps * Rabs mu.
Hypothesis Open : opens O m h ((1 + Rabs c + Rabs k) * (K * 2 + K * (2 * (6 * K ^ 5)))) eps mu.
Hypothesis Hu : forall i, u a1 a2 (n i) <> 0.
Hypothesis Hmu : 0 < sgn e * mu.
Hypothesis Hg : sgn g * gamma > 0.
Hypothesis Heps : 0 < eps.
Hypothesis Mb : forall i j, (j <= n_max)%nat -> b a1 a2 (n i) j <> 0 -> 2 * eps <= Rabs (b a1 a2 (n i) j).
Hypothesis Mf : forall i j, let f := follows a1 a2 (n i) (n j) / gamma in f <> 0 -> 4 * eps <= Rabs f.
Hypothesis Only : forall x', (forall i, Rabs (x' i) <= d) -> law O m S V n mu x' -> forall i, x' i = x i.
Hypothesis Signs : forall i, (forall j, (1 <= j <= n i - 1)%nat -> sgn e * b a1 a2 (n i) j > 0) /\
  sgn e * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) > 0.
Notation after x i := (aft O m S V (n i%Z) mu (x i%Z) (x (i + 1)%Z)).
Notation before x i := (bef O m S V (n i%Z) mu (x i%Z) (x (i + 1)%Z)).
Let Htau := is_restitution _ _ _ _ _ HO.
Let HG := g_pos O (is_touching _ _ _ _ _ HO).

Theorem motion_unstable t q v : motion O m mu d N t q v -> unstable_motion (swing O m mu (h * Rabs mu) N) t v.
Proof.
  intros HM; assert (Xh : forall i, Rabs (x i) <= h * Rabs mu) by (intros i; specialize (Hx i); lra).
  assert (Near : forall i, leg_near O m S V n_max K (n i) eps mu (x i) (x (i + 1)%Z)) by (intros; apply Leg; auto; apply
    HN). pose proof (motion_is O m a1 a2 gamma S V HO HS n_max K mu h N n x HK HN d Hd Only t q v HM) as Is.
  assert (Pg : 0 < G2 * s) by (apply Rmult_lt_0_compat; lra); assert (Xd : forall i, Rabs (x i) + s <= d) by (intros i;
    specialize (Hx i); lra).
  assert (Pos : forall i, before x i + G1 mu (x (i + 1)%Z) < - (3 * G2 * s)).
  { intros i; pose proof (proj1 (jump_sign O m a1 a2 gamma S V HO HS n_max K mu eps N n x HN Near e g Hu Hmu Hg Heps Mf
      i) (proj2 (Signs i))) as J; cbv beta in J. pose proof (HL (i + 1)%Z) as E; replace (i + 1 - 1)%Z with i in E by
      lia.
    apply (Rmult_lt_reg_l (1 + tau)); [lra|]; assert (0 <= tau * (G2 * s)) by (apply Rmult_le_pos; lra); lra. }
  exists (s / 2); split; [lra|]; intros j r Hr; destruct (halves_small (2 * s + G2 * (2 * s)) r Hr) as [z Hz].
  set (l := (j + 1 + Z.of_nat z)%Z).
  destruct (other_end O m S V n_max mu d s n x l (is_touching _ _ _ _ _ HO) Htau Nr (fun i => proj2 (HN i)) ltac:(lra)
    Xd HL) as (x' & El & Fade & Fix); pose proof (fading_le s l ltac:(lra)) as Fl.
  assert (Xh' : forall i, Rabs (x' i) <= h * Rabs mu).
  { intros i; replace (x' i) with ((x' i - x i) + x i) by ring; eapply Rle_trans; [apply Rabs_triang|]; specialize (Fade
      i); specialize (Fl i); specialize (Hx i); lra. }
  assert (Near' : forall i, leg_near O m S V n_max K (n i) eps mu (x' i) (x' (i + 1)%Z)) by (intros; apply Leg; auto;
    apply HN).
  assert (Beside : forall i, Rabs (after x' i - after x i) <= G2 * fading s l (i + 1) /\ before x' i + G1 mu (x' (i +
    1)%Z) < 0).
  { assert (D : forall i e, (forall j, (i - 1 <= j <= i + 1)%Z -> Rabs (x' j - x j) <= e) -> Rabs (after x' i - after x
      i) <= G2 * e /\ Rabs (before x' (i - 1)%Z - before x (i - 1)%Z) <= G2 * e /\ Rabs (G1 mu (x' i) - G1 mu (x i)) <=
      2 * G2 * e).
    { intros i f H; replace (i - 1 + 1)%Z with i by lia; refine (proj2 (Nr n x' x i f (fun i => proj2 (HN i)) _));
      intros y Hy; specialize (Xh' y); specialize (Xh y); split; [lra | split; [lra | apply H, Hy]]. }
    intros i; split.
    - apply D; intros y Hy; apply Rle_trans with (1 := Fade y), fading_rises; [lra | lia].
    - destruct (D (i + 1)%Z s) as (_ & D2 & D3); [intros y _; specialize (Fade y); specialize (Fl y); lra|].
      replace (i + 1 - 1)%Z with i in D2 by lia; apply le_abs in D2, D3; specialize (Pos i); lra. }
  set (a' := fun i => - G1 mu (x' i) - tau * (before x' (i - 1)%Z + G1 mu (x' i))).
  assert (Ea : forall i, (i < l)%Z -> a' i = after x' i).
  { intros i Hi; pose proof (proj2 (law_at O m S V (is_touching _ _ _ _ _ HO) Htau n mu x' i) (Fix i Hi)) as E; unfold
    a'.
    replace (i - 1 + 1)%Z with i by lia; lra. }
  assert (Start : forall X a i, leg_v O m S V mu N X a i (at_ m N X i) = facing m (N i) * a i).
  { intros X a i; unfold leg_v, at_; replace (turn m * IZR (N i) + X i - turn m * IZR (N i)) with (X i) by ring.
    rewrite (proj2 (here_start O S V HS mu X a i)); reflexivity. }
  exists l, (at_ m N x'), (leg_q O m S V mu N x' a'), (leg_v O m S V mu N x' a'); split; [unfold l; lia|].
  assert (Et : forall i, at_ m N x' i - t i = x' i - x i) by (intros i; rewrite (proj1 (Is i)); unfold at_; ring).
  split; [|split].
  - intros i Hi; apply (lawful_swing O m S V HS n_max K mu h eps (h * Rabs mu) N n x' a' HK HN Xh' ltac:(lra) Near'
    Open).
    + constructor.
      * apply Ea; lia.
      * destruct (Beside (i - 1)%Z) as [_ B]; replace (i - 1 + 1)%Z with i in B by lia; unfold a'.
        replace (i - 1 + 1)%Z with i by lia; set (y := _ + G1 mu (x' i)) in B; fold y.
        assert (tau * y <= tau * 0) by (apply Rmult_le_compat_l; lra); lra.
      * apply Beside.
      * unfold a'; replace (i + 1 - 1)%Z with i by lia; ring.
    + intros y Hy; pose proof (proj1 (mid_sign O m a1 a2 gamma S V HO HS n_max K mu eps N n x' HN Near' e Hu Hmu Heps Mb
        i y Hy) (proj1 (Signs i) y Hy)) as Q; cbv beta in Q; unfold here in Q |- *; rewrite (Ea i) by lia; exact Q.
  - assert (Fj : fading s l j = s / 2 ^ Datatypes.S z /\ fading s l (j + 1) = s / 2 ^ z) by (unfold fading, l; split; do
      2 f_equal; lia). assert (P2 : 0 < / 2 ^ z) by (apply Rinv_0_lt_compat, pow_lt; lra).
    unfold Rdiv in Hz; rewrite Rmult_plus_distr_r in Hz; assert (0 < s * / 2 ^ z /\ 0 < G2 * (s * / 2 ^ z)) by (split;
      repeat apply Rmult_lt_0_compat; lra). split.
    + rewrite Et; apply Rle_trans with (1 := Fade j); rewrite (fading_next s l j) by (unfold l; lia); rewrite (proj2
        Fj); unfold Rdiv; lra.
    + rewrite Start, (proj1 (Is j)), (proj2 (proj2 (Is j) _)), Start, <- Rmult_minus_distr_l, Rabs_mult, side_abs,
        Rmult_1_l, Ea by (unfold l; lia). apply Rle_trans with (1 := proj1 (Beside j)); rewrite (proj2 Fj); unfold Rdiv;
        lra.
  - intros [A _]; rewrite Et, El in A; replace (x l + s - x l) with s in A by ring; rewrite Rabs_pos_eq in A; lra.
Qed.
End Away.
