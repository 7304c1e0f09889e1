(** * A solution of the law of impact is a motion, the only one near the touch, if (52) and (64) hold; and
      none is if one fails strictly *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOscillator Derivatives Flow PlaneLinear OscillatorTurns OscillatorStop
  OscillatorGap OscillatorLaw OscillatorLegs.
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
Notation tau := (Oscillator.tau O).
Notation G1 := (Oscillator.G1 O).
Notation T := (turn m).
Hypothesis HO : grazing O m a1 a2 gamma.
Hypothesis HS : flow c k S V.
Variables (n_max : nat) (K mu h eps : R) (N : Z -> Z) (n : Z -> nat) (x : Z -> R).
Hypothesis HK : bounds c k m S V n_max K.
Hypothesis HN : forall i, N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\ regular m S n_max (n i).
Hypothesis HL : law O m S V n mu x.
Hypothesis Hx : forall i, Rabs (x i) <= h * Rabs mu.
Hypothesis Near : forall i, leg_near O m S V n_max K (n i) eps mu (x i) (x (i + 1)%Z).
Notation place := (place O mu).
Let a i := aft O m S V (n i) mu (x i) (x (i + 1)%Z).
Let p i := bef O m S V (n i) mu (x i) (x (i + 1)%Z).
Let Htau := is_restitution _ _ _ _ _ HO.
Let HA := is_matrix _ _ _ _ _ HO.

Notation here := (here O S V mu x a).
Notation heres := (heres O S V mu x a).
Notation at_ := (at_ m N x).
Notation leg_q := (leg_q O m S V mu N x a).
Notation leg_v := (leg_v O m S V mu N x a).
Notation gap_here := (gap_here O m S V mu N x a).

(** The law, for an impact of relative speed - z before and tau z after. *)
Lemma impact i : let z := (a (i + 1)%Z - p i) / (1 + tau) in
  p i + G1 mu (x (i + 1)%Z) = - z /\ a (i + 1)%Z + G1 mu (x (i + 1)%Z) = tau * z.
Proof.
  intros z; pose proof (HL (i + 1)%Z) as E; replace (i + 1 - 1)%Z with i in E by lia; fold (a (i + 1)%Z) (p i) in E.
  assert (G1 mu (x (i + 1)%Z) = - (a (i + 1)%Z + tau * p i) / (1 + tau)) as -> by (rewrite <- E; field; lra).
  unfold z; split; field; lra.
Qed.

(** Where the signs decide. *)
Variables (d : R) (e g : sign).
Hypothesis Hu : forall i, u a1 a2 (n i) <> 0.
Hypothesis Hmu : 0 < sgn e * mu.
Hypothesis Hg : sgn g * gamma > 0.
Hypothesis Heps : 0 < eps.
Hypothesis Mb : forall i j, (j <= n_max)%nat -> b a1 a2 (n i) j <> 0 -> 2 * eps <= Rabs (b a1 a2 (n i) j).
Hypothesis Mf : forall i j, let f := follows a1 a2 (n i) (n j) / gamma in f <> 0 -> 4 * eps <= Rabs f.
Hypothesis Hd : h * Rabs mu <= d <= 1 /\ 2 * d <= / K.
Hypothesis Open : opens O m h ((1 + Rabs c + Rabs k) * (K * 2 + K * (2 * (6 * K ^ 5)))) eps mu.
Hypothesis Only : forall x', (forall i, Rabs (x' i) <= d) -> law O m S V n mu x' -> forall i, x' i = x i.
Let Hgam : gamma <> 0 := is_generic _ _ _ _ _ HO.

Lemma solution_motion : (forall i, p i < a (i + 1)%Z) -> (forall i j, (1 <= j <= n i - 1)%nat -> eps * Rabs mu <= facing
  m (Z.of_nat j) * here i (T * INR j) + mu) -> motion O m mu d N at_ leg_q leg_v.
Proof.
  intros Hv Mid i j ->; assert (Pos : forall l, 0 < (a (l + 1)%Z - p l) / (1 + tau)) by (intros l; apply
    Rdiv_lt_0_compat;
    [specialize (Hv l)|]; lra). pose proof (Pos (i - 1)%Z) as P; pose proof (Pos i) as P'.
  destruct (impact i) as [I1 I2], (impact (i - 1)) as [_ I3]; replace (i - 1 + 1)%Z with i in * by lia.
  apply (lawful_swing O m S V HS n_max K mu h eps d N n x a HK HN Hx (proj1 Hd) Near Open);
    [|apply Mid]; constructor; fold (p i).
  - reflexivity.
  - rewrite I3; apply Rmult_le_pos; lra.
  - rewrite I1; lra.
  - rewrite I2, I1; ring.
Qed.

(** The only motion near the touch. *)
Lemma phases t q v : motion O m mu d N t q v -> forall i, phase m N t i = x i.
Proof.
  intros HM; apply Only; [intros i; apply (HM i _ eq_refl)|].
  apply (motion_law O m S V Htau HS n_max K HK mu d N n t q v HM (proj2 Hd) HN).
Qed.
Lemma motion_is t q v : motion O m mu d N t q v -> forall i,
  t i = at_ i /\ forall s, q i s = leg_q i s /\ v i s = leg_v i s.
Proof.
  intros HM i; pose proof (phases t q v HM) as Ex; assert (Et : t i = at_ i) by (unfold at_; rewrite <- (Ex i);
    unfold phase; ring).
  split; [exact Et|]; intros s; pose proof (swing_free _ _ _ _ _ _ _ _ _ _ (HM i _ eq_refl)) as F.
  destruct (motion_leg O m S V HS n_max K HK mu d N n t q v HM (proj2 Hd) HN i) as (_ & Eq & Ev & _).
  rewrite Ex in Eq; rewrite (Ex i), (Ex (i + 1)%Z) in Ev; fold (a i) in Ev;
    destruct (free_moved c k S V HS _ _ (t i) s F) as [-> ->].
  rewrite Eq, Ev, Et; unfold leg_q, leg_v, here, heres, moved, moving, at_.
  replace (s - (T * IZR (N i) + x i)) with (s - T * IZR (N i) - x i) by ring; split; ring.
Qed.
Lemma jump_sign i : let f := sgn e * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) in
  (f > 0 -> p i + 2 * eps * Rabs mu <= a (i + 1)%Z) /\ (f < 0 -> a (i + 1)%Z <= p i).
Proof.
  intros f; pose proof (limit_follows c k m S V HS a1 a2 gamma HA (n i) (n (i + 1)%Z) Hgam (Hu i) (Hu (i + 1)%Z)
    (proj1 (proj1 (proj2 (HN i))))) as E.
  destruct (sign_near e mu (a (i + 1)%Z - p i) (follows a1 a2 (n i) (n (i + 1)%Z) / gamma) (2 * eps) Hmu) as [P Q].
  { rewrite <- E; replace (_ - _) with ((a (i + 1)%Z - mu * aft0 c m S V (n (i + 1)%Z)) - (p i - mu * bef0 c k m S V
      (n i))) by ring.
    pose proof (near_aft _ _ _ _ _ _ _ _ _ _ _ (Near (i + 1)%Z)); pose proof (near_bef _ _ _ _ _ _ _ _ _ _ _ (Near i)).
    eapply Rle_trans; [apply apart|]; unfold a, p; lra. }
  { intros H'; specialize (Mf i (i + 1)%Z H'); lra. }
  destruct (sign_over e g gamma (follows a1 a2 (n i) (n (i + 1)%Z)) Hg) as [P' Q'].
  assert (0 < 2 * eps * Rabs mu) by (apply Rmult_lt_0_compat; [lra | apply Rabs_pos_lt; intros Z; rewrite Z in Hmu;
    lra]).
  split; intros Hf; [specialize (P (P' Hf)) | specialize (Q (Q' Hf))]; lra.
Qed.
Lemma mid_sign i j : (1 <= j <= n i - 1)%nat -> let y := facing m (Z.of_nat j) * here i (T * INR j) + mu
  in (sgn e * b a1 a2 (n i) j > 0 -> eps * Rabs mu <= y) /\ (sgn e * b a1 a2 (n i) j < 0 -> y <= 0).
Proof.
  intros Hj y; destruct (HN i) as (_ & Hn & _). pose proof (near_mid _ _ _ _ _ _ _ _ _ _ _ (Near i) j ltac:(lia)) as Hm.
  pose proof (limit_b c k m S V HS a1 a2 gamma HA (n i) j Hgam (Hu i) ltac:(lia)) as E; fold (mid0 O m S V (n i) j)
    in E.
  destruct (sign_near e mu y (b a1 a2 (n i) j) eps Hmu) as [P Q].
  { rewrite <- E; replace (y - _) with (mid O m S V (n i) j mu (x i) (x (i + 1)%Z) - mu * mid0 O m S V (n i) j);
      [exact Hm|]; unfold y, here, moved, a, mid, turned.
    replace (T * INR j + - x i) with (T * INR j - x i) by ring; ring. }
  { apply Mb; lia. }
  assert (0 <= eps * Rabs mu) by (apply Rmult_le_pos; [lra | apply Rabs_pos]).
  split; [exact P | intros Hs; specialize (Q Hs); lra].
Qed.

(** A motion satisfies (52) and (64) as far as they are decided. *)
Lemma word_fails i : (exists j, (1 <= j <= n i - 1)%nat /\ sgn e * b a1 a2 (n i) j < 0) \/
  sgn e * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) < 0 -> forall t q v, ~ motion O m mu d N t q v.
Proof.
  intros Hs t q v HM; destruct Hs as [(j & Hj & Hs)|Hs].
  - destruct (motion_is t q v HM i) as [_ E], (mid_sign i j Hj) as [_ Q]; specialize (Q Hs).
    pose proof (swing_clear _ _ _ _ _ _ _ _ _ _ (HM i _ eq_refl)) as Op; pose proof (turn_large m) as HT3.
    assert (At : forall l, - 1 <= t l - T * IZR (N l) <= 1).
    { intros l; pose proof (swing_near _ _ _ _ _ _ _ _ _ _ (HM l _ eq_refl)) as D; apply le_abs in D; lra. }
    assert (1 <= INR j <= INR (n i) - 1).
    { split; [apply (le_INR 1); lia|]; pose proof (le_INR (1 + j) (n i) ltac:(lia)) as P; rewrite plus_INR in P;
        cbn in P; lra. }
    assert (T * 1 <= T * INR j <= T * (INR (n i) - 1)) by (split; apply Rmult_le_compat_l; lra).
    assert (E1 := At i); assert (E2 := At (i + 1)%Z); rewrite (proj1 (HN i)), plus_IZR, <- INR_IZR_INZ in E2.
    specialize (Op (N i + Z.of_nat j)%Z (T * IZR (N i) + T * INR j) ltac:(split; lra)).
    unfold gap in Op; rewrite (proj1 (E _)) in Op.
    fold (gap O m mu (N i + Z.of_nat j) (leg_q i) (T * IZR (N i) + T * INR j)) in Op.
    rewrite (proj1 (gap_here i _ _)) in Op; unfold gap in Op.
    rewrite <- INR_IZR_INZ, Rminus_eq_0, (touch _ (is_touching _ _ _ _ _ HO)) in Op; lra.
  - destruct (motion_law O m S V Htau HS n_max K HK mu d N n t q v HM (proj2 Hd) HN) as [_ J].
    specialize (J i); rewrite !(phases t q v HM) in J; destruct (jump_sign i) as [_ Q]; specialize (Q Hs);
      unfold a, p in Q; lra.
Qed.
Lemma decided : (forall i, (forall j, (1 <= j <= n i - 1)%nat -> sgn e * b a1 a2 (n i) j > 0) /\
  sgn e * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) > 0) -> one_motion O m mu d N.
Proof.
  intros Hs; exists at_, leg_q, leg_v; split.
  - apply solution_motion; [|intros i j Hj; apply mid_sign, Hs; apply Hj].
    intros i; pose proof (proj1 (jump_sign i) (proj2 (Hs i))); assert (0 < eps * Rabs mu) by (apply Rmult_lt_0_compat;
      [lra | apply Rabs_pos_lt; intros Z; rewrite Z in Hmu; lra]); lra.
  - intros t q v HM i y; destruct (motion_is t q v HM i) as [E F]; auto.
Qed.
End Words.
