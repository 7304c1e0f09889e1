(** * A solution of the law of impact is a motion, the only one near the touch, if (52) and (64) hold; and
      none is if one fails strictly *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOrbitsPlane StatementOscillator Derivatives Flow PlaneLinear OscillatorTurns
  OscillatorStop OscillatorGap OscillatorLaw.
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
Lemma here_end i : let s := T * INR (n i) + x (i + 1)%Z in
  facing m (Z.of_nat (n i)) * here i s = place (x (i + 1)%Z) /\ facing m (Z.of_nat (n i)) * heres i s = p i.
Proof.
  intros s; pose proof (near_S _ _ _ _ _ _ _ _ _ _ _ (Near i)) as NS; revert NS.
  unfold here, heres, moved, moving, p, bef, a, aft, aft_leg, bef_leg, bef_of, aft_of, turned.
  replace (s - x i) with (T * INR (n i) + (x (i + 1)%Z - x i)) by (unfold s; ring).
  set (t := T * INR (n i) + _); intros NS; split; field; split; intros E; apply NS; rewrite E; ring.
Qed.

(** The law, for an impact of relative speed - z before and tau z after. *)
Lemma impact i : let z := (a (i + 1)%Z - p i) / (1 + tau) in
  p i + G1 mu (x (i + 1)%Z) = - z /\ a (i + 1)%Z + G1 mu (x (i + 1)%Z) = tau * z.
Proof.
  intros z; pose proof (HL (i + 1)%Z) as E; replace (i + 1 - 1)%Z with i in E by lia; fold (a (i + 1)%Z) (p i) in E.
  assert (G1 mu (x (i + 1)%Z) = - (a (i + 1)%Z + tau * p i) / (1 + tau)) as -> by (rewrite <- E; field; lra).
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
  assert (both : forall e f, entry c k S V e -> entry c k S V f -> Rabs (e (t - x i) * place (x i) + f (t - x i) * a i)
    <= z).
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
  intros Hv Mid i j ->; destruct (HN i) as [NN [Hn _]]; pose proof (turn_large m) as HT.
  assert (Tn : T <= T * INR (n i)) by (rewrite <- (Rmult_1_r T) at 1; apply Rmult_le_compat_l;
    [lra | apply (le_INR 1); lia]).
  assert (Sm : forall i, - (h * Rabs mu) <= x i <= h * Rabs mu) by (intros l; apply le_abs, Hx).
  pose proof (Sm i); pose proof (Sm (i + 1)%Z); destruct (here_start i) as [E0 F0], (here_end i) as [E1 F1].
  pose proof (fun l => impact l) as I; cbv zeta in I, E1, F1; set (z := fun l => (a (l + 1)%Z - p l) / (1 + tau)) in *.
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
    + intros t Ht; apply here_bounds; [lra | exact Ht].
    + replace i with (i - 1 + 1)%Z by lia; rewrite Speed0; specialize (Pos (i - 1)%Z); apply Rmult_le_pos; lra.
    + fold s; rewrite Speed1; specialize (Pos i); lra.
    + fold s; lra.
  - rewrite Eb, NN, (proj2 (gap_here i _ _)), Speed1; specialize (Pos i); lra.
  - pose proof (proj2 (gap_here (i + 1) 0 (x (i + 1)%Z))) as Q; rewrite Z.add_0_r in Q; fold (at_ (i + 1)) in Q.
    rewrite Q, Speed0, Eb, NN, (proj2 (gap_here i _ _)), Speed1; ring.
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
  (f > 0 -> p i < a (i + 1)%Z) /\ (f < 0 -> a (i + 1)%Z <= p i).
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
Lemma decided : ((forall i, (forall j, (1 <= j <= n i - 1)%nat -> sgn e * b a1 a2 (n i) j > 0) /\
  sgn e * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) > 0) -> one_motion O m mu d N) /\
  forall t q v, motion O m mu d N t q v -> forall i, Rabs (t i - T * IZR (N i)) <= h * Rabs mu.
Proof.
  split.
  - intros Hs; exists at_, leg_q, leg_v; split.
    + apply solution_motion; [intros i; apply jump_sign, Hs | intros i j Hj; apply mid_sign, Hs; apply Hj].
    + intros t q v HM i y; destruct (motion_is t q v HM i) as [E F]; auto.
  - intros t q v HM i; fold (phase m N t i); rewrite (phases t q v HM); apply Hx.
Qed.
End Words.

(** Theorem 1 for oscillators: one d, one mu0 and one K for all words over {n <= n_max : u_n <> 0}. *)
Theorem Word_oscillator : forall O m a1 a2 gamma, grazing O m a1 a2 gamma -> forall n_max, exists d mu0 K, d > 0 /\
  mu0 > 0 /\ forall (N : Z -> Z) (n : Z -> nat) s g mu, (forall i, N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\
  (1 <= n i <= n_max)%nat /\ u a1 a2 (n i) <> 0) -> sgn g * gamma > 0 -> 0 < sgn s * mu < mu0 ->
  ((forall i, (forall j, (1 <= j <= n i - 1)%nat -> sgn s * b a1 a2 (n i) j > 0) /\ sgn s * sgn g * follows a1 a2 (n i)
  (n (i + 1)%Z) > 0) -> one_motion O m mu d N) /\ (forall i, (exists j, (1 <= j <= n i - 1)%nat /\ sgn s * b a1 a2 (n i)
  j < 0) \/ sgn s * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) < 0 -> forall t q v, ~ motion O m mu d N t q v) /\
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
  assert (Reg : forall i, regular m S n_max (n i)).
  { intros i; destruct (Hw i) as (_ & H & Hu); split; [exact H|].
    rewrite (turned_S _ _ m S V HS a1 a2 gamma (is_matrix _ _ _ _ _ HO)); apply Rmult_integral_contrapositive.
    split; [apply HO | exact Hu]. }
  pose proof (fun i => conj (proj1 (Hw i)) (Reg i)) as HN; destruct (One n mu Reg ltac:(lra)) as (x & Hx & Law & Only).
  assert (Near : forall i, leg_near O m S V n_max K (n i) eps mu (x i) (x (i + 1)%Z)) by (intros i; apply Leg; auto;
    lra).
  assert (Mb' : forall i j, (j <= n_max)%nat -> b a1 a2 (n i) j <> 0 -> 2 * eps <= Rabs (b a1 a2 (n i) j)).
  { intros i j Hj Hne; destruct (Reg i); pose proof (Mb (n i) j ltac:(lia) ltac:(lia) Hne); lra. }
  assert (Mf' : forall i j, let f := follows a1 a2 (n i) (n j) / gamma in f <> 0 -> 4 * eps <= Rabs f).
  { intros i j f Hne; destruct (Reg i), (Reg j); pose proof (Mf (n i) (n j) ltac:(lia) ltac:(lia) Hne) as P;
      fold f in P; lra. }
  pose proof (fun i => proj2 (proj2 (Hw i))) as Hu; assert (Op : opens O m C X eps mu) by (apply Open; lra).
  assert (Hd' : C * Rabs mu <= d <= 1 /\ 2 * d <= / K) by lra.
  destruct (decided O m a1 a2 gamma S V HO HS n_max K mu C eps N n x HK HN Law Hx Near d s g Hu (proj1 Hmu) Hg He Mb'
    Mf' Hd' Op Only) as [One' Small]; split; [exact One' | split; [|exact Small]].
  apply (word_fails O m a1 a2 gamma S V HO HS n_max K mu C eps N n x HK HN Near d s g Hu (proj1 Hmu) Hg He Mb' Mf' Hd'
    Only).
Qed.
