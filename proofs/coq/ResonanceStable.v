(** * Where the motion exists, its return map has both multipliers - tau q, and it is asymptotically stable *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementPlane StatementAttractor StatementOscillator StatementUnstable
  StatementResonance Derivatives Flow.
From Grazing Require Import AttractorDerivative ResonanceHop ResonanceExact ResonanceReturn.
Open Scope R_scope.

(** ** A fixed point with the derivative (a 0; e a), |a| < 1, attracts *)
Section Attracts.
Variables (F : R * R -> R * R) (s0 w0 a e : R).
Hypothesis Fix : F (s0, w0) = (s0, w0).
Hypothesis D : derivative F (s0, w0) (Mat a 0 e a).
Hypothesis Ha : Rabs a < 1.
Definition weight : R := 1 + 4 * Rabs e / (1 - Rabs a).
Definition size (z : R * R) : R := weight * Rabs (fst z - s0) + Rabs (snd z - w0).
Lemma weight_1 : 1 <= weight.
Proof.
  unfold weight; assert (0 <= 4 * Rabs e / (1 - Rabs a)); [|lra].
  apply Rmult_le_pos; [pose proof (Rabs_pos e); lra | left; apply Rinv_0_lt_compat; lra].
Qed.
Lemma size_norm z : norm (sub z (s0, w0)) <= size z /\ size z <= 2 * weight * norm (sub z (s0, w0)).
Proof.
  pose proof weight_1 as W; destruct z as [s w]; unfold size; cbn [fst snd]; pose proof (Rabs_pos (s - s0)).
  pose proof (Rabs_pos (w - w0)); pose proof (norm_fst (sub (s, w) (s0, w0))) as A;
    pose proof (norm_snd (sub (s, w) (s0, w0))) as B.
  set (t := norm _) in *; cbn [sub fst snd] in A, B; split; [|nra].
  apply (proj2 (norm_le _ _)); cbn [sub fst snd]; nra.
Qed.
Notation lam := ((1 + Rabs a) / 2).
Lemma contracts : exists r, 0 < r /\ forall z, size z <= r -> size (F z) <= lam * size z.
Proof.
  pose proof weight_1 as W; pose proof (Rabs_pos a) as Pa; set (eps := (1 - Rabs a) / (4 * (1 + weight))).
  assert (He : 0 < eps) by (apply Rdiv_lt_0_compat; lra).
  destruct (D eps He) as (d & Hd & H); exists d; split; [exact Hd|]; intros [s w] Hz.
  destruct (size_norm (s, w)) as [N _]; specialize (H (s, w) ltac:(lra)); rewrite Fix in H.
  destruct (F (s, w)) as [s' w']; apply norm_le in H; cbn [sub apply fst snd m11 m12 m21 m22] in H; destruct H as [A B].
  set (t := norm _) in *; unfold size in *; cbn [fst snd] in *; set (x := s - s0) in *; set (y := w - w0) in *.
  assert (E : eps * (1 + weight) = (1 - Rabs a) / 4) by (unfold eps; field; lra).
  assert (L1 : Rabs (s' - s0) <= Rabs a * Rabs x + eps * t).
  { replace (s' - s0) with (a * x + (s' - s0 - (a * x + 0 * y))) by ring; eapply Rle_trans; [apply Rabs_triang|].
    rewrite Rabs_mult; lra. } assert (L2 : Rabs (w' - w0) <= Rabs e * Rabs x + Rabs a * Rabs y + eps * t).
  { replace (w' - w0) with (e * x + a * y + (w' - w0 - (e * x + a * y))) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; pose proof (Rabs_triang (e * x) (a * y)) as T; rewrite !Rabs_mult in T;
      lra. } pose proof (Rabs_pos x) as Px; pose proof (Rabs_pos y) as Py.
  assert (L3 : Rabs e * Rabs x <= (1 - Rabs a) / 4 * (weight * Rabs x)).
  { rewrite <- Rmult_assoc; apply Rmult_le_compat_r; [exact Px|]; unfold weight.
    replace ((1 - Rabs a) / 4 * _) with ((1 - Rabs a) / 4 + Rabs e) by (field; lra); lra. }
  assert (L4 : eps * t * (1 + weight) <= (1 - Rabs a) / 4 * (weight * Rabs x + Rabs y)).
  { replace (eps * t * (1 + weight)) with (eps * (1 + weight) * t) by ring; rewrite E; apply Rmult_le_compat_l; lra. }
  assert (L5 : weight * Rabs (s' - s0) <= weight * (Rabs a * Rabs x + eps * t)) by (apply Rmult_le_compat_l; lra).
  assert (0 <= (1 - Rabs a) * Rabs y) by (apply Rmult_le_pos; lra); lra.
Qed.
Lemma iterates r : 0 < r -> (forall z, size z <= r -> size (F z) <= lam * size z) -> forall z, size z <= r ->
  forall i, size (Nat.iter i F z) <= lam ^ i * size z /\ size (Nat.iter i F z) <= size z.
Proof.
  intros Hr H z Hz; pose proof (Rabs_pos a); assert (L : 0 <= lam <= 1) by lra. assert (P : forall z, 0 <= size z).
  { intros [s w]; destruct (size_norm (s, w)) as [N _]; pose proof (norm_pos (sub (s, w) (s0, w0))); lra. }
  induction i as [|i [I1 I2]]; [cbn; lra|]; cbn [Nat.iter nat_rect]; change (nat_rect _ _ _ i) with (Nat.iter i F z).
  specialize (H _ (Rle_trans _ _ _ I2 Hz)); pose proof (P (Nat.iter i F z)); split.
  - cbn [pow]; rewrite Rmult_assoc; eapply Rle_trans; [exact H | apply Rmult_le_compat_l; lra].
  - assert (lam * size (Nat.iter i F z) <= 1 * size (Nat.iter i F z)) by (apply Rmult_le_compat_r; lra); lra.
Qed.
End Attracts.

Section Stable.
Variables (O : Oscillator.t) (n m : nat).
Hypothesis HO : any_stop O.
Hypothesis HR : resonant O n m.
Hypothesis HN : regular O n m.
Notation c := (Oscillator.c O).
Notation k := (Oscillator.k O).
Notation tau := (Oscillator.tau O).
Hypothesis Htau : 0 < tau.
Notation q := (q O n m).
Notation T := (2 * PI * INR n).
Notation N := (fun i => Z.of_nat n * i)%Z.
Notation S := (S O).
Notation V := (V O).
Variables (mu d : R) (t : Z -> R) (y v : Z -> R -> R).
Hypothesis H1 : once O n mu d t y v.
Notation Q := (stop O mu).
Notation Q1 := (stop1 O mu).
Notation hops := (hop c k S V Q Q1 T tau).
Let HS := is_flow O n m HR.
Notation s0 := (t 0%Z).
Notation w0 := (v 0%Z s0).

Lemma hop_next s w s' w' : hops s w s' w' <-> next_impact O n mu (s, w) (s', w').
Proof.
  split.
  - intros H; set (pick := fun (a b : R) (i : Z) => if Z.eqb i 0 then a else b).
    pose proof (hop_swing O n S V mu HO HS (pick s s') (pick w w') (Rabs s) 0 H (Rle_refl _)) as X.
    exists (Rabs s); do 3 eexists; split; [exact X|].
    pose proof (proj2 (flight_is O n S V mu (pick s s') (pick w w') 0 0)) as A;
      pose proof (proj2 (flight_is O n S V mu (pick s s') (pick w w') 1 0)) as B.
    rewrite (proj2 (place_0 c k S V HS _ _ _)), Rplus_0_r in A.
    rewrite (proj2 (place_0 c k S V HS _ _ _)), Rplus_0_r in B; rewrite A, B; unfold times, pick; cbn [Z.eqb].
    split; f_equal; ring.
  - intros (h & t' & y' & v' & X & E & E'); injection E as -> ->; injection E' as -> ->.
    destruct (swing_hop O n S V mu HO HS h t' y' v' 0 X) as (A & _); change (0 + 1)%Z with 1%Z in A.
    rewrite Rmult_0_r, Rminus_0_r, Rmult_1_r in A; exact A.
Qed.

Theorem multipliers : let a := - tau * q in exists F e, returns O n mu (s0, w0) F (Mat a 0 e a).
Proof.
  intros a; destruct (once_hop O n m HO HR mu d t y v H1) as (A & _ & _); destruct HN as [N1 N2].
  pose proof (q_range O n m HR) as [B N0]; pose proof (tau_q O n m HR HN) as [B1 B2];
    pose proof (res_law _ _ _ HR) as L.
  pose proof (flow_turned O n m HR) as Hq; pose proof (period_pos O n m HR) as HT.
  destruct (proj1 (hop_again c k S V HS Q Q1 T q tau HT Hq _ _ L B N1 N2) A) as (Z & P & W & C).
  assert (E : (1 + tau * q) * w0 = (1 + tau) * Q1 s0) by (rewrite W at 1; field; lra).
  assert (P1 : 0 < (1 - q) * Q1 s0) by (apply Rmult_lt_0_compat; lra).
  destruct (returned c k S V HS Q Q1 (fun x => - Oscillator.G2 O mu x) T q tau HT) with (s0 := s0) (w0 := w0)
    as (F & e & (r & Hr & X) & Fix & D); trivial.
  - intros x; apply (turn_1 O n mu HO).
  - intros x; unfold stop, stop1; derive_by ltac:(apply (stop_slope _ HO)); ring.
  - intros x; apply (D_ext (fun x => -1 * Oscillator.G1 O mu x) _ x (-1 * Oscillator.G2 O mu x)).
    + apply D_scale, (stop_bend _ HO).
    + intros; unfold stop1; ring.
    + ring.
  - apply (Rmult_lt_reg_l (1 + tau * q)); [lra|]; rewrite Rmult_0_r.
    replace ((1 + tau * q) * (Q1 s0 - q * w0)) with ((1 + tau * q) * Q1 s0 - q * ((1 + tau * q) * w0)) by ring.
    rewrite E; lra.
  - apply (Rmult_lt_reg_l (1 + tau * q)); [lra|]; rewrite Rmult_0_r, Rmult_minus_distr_l, E.
    assert (0 < tau * ((1 - q) * Q1 s0)) by (apply Rmult_lt_0_compat; lra); lra.
  - lra.
  - exists F, e; split; [|exact Fix|exact D]; exists r; split; [exact Hr|]; intros [s w] Hz; apply norm_le in Hz.
    specialize (X s w (proj1 Hz) (proj2 Hz)); destruct (F (s, w)) as [s' w']; apply hop_next, X.
Qed.

Theorem stable eps : 0 < eps -> exists delta, 0 < delta /\ forall s w, Rabs (s - s0) <= delta ->
  Rabs (w - w0) <= delta -> exists t' y' v', forward O n mu (d + eps) t' y' v' /\
  t' 0%Z = s /\ v' 0%Z s = w /\ (forall i, (0 <= i)%Z -> near t t' v v' eps i) /\
  (forall eta, 0 < eta -> exists K, forall i, (K <= i)%Z -> near t t' v v' eta i) /\
  forall h t2 y2 v2, forward O n mu h t2 y2 v2 -> t2 0%Z = s -> v2 0%Z s = w ->
  forall i x, (0 <= i)%Z -> t2 i = t' i /\ y2 i x = y' i x /\ v2 i x = v' i x.
Proof.
  intros He; destruct multipliers as (F & e & [(r & Hr & X) Fix D]); set (a := - tau * q) in *.
  destruct (once_hop O n m HO HR mu d t y v H1) as (_ & D0 & _); pose proof (tau_q O n m HR HN) as [_ B2].
  assert (Ha : Rabs a < 1) by (unfold a; apply Rabs_def1; lra); pose proof (Rabs_pos a) as Pa.
  destruct (contracts F s0 w0 a e Fix D Ha) as (r1 & Hr1 & Con); pose proof (weight_1 a e Ha) as W.
  set (M := weight a e) in *; set (size := size s0 w0 a e) in *.
  destruct (two_least r r1 Hr Hr1) as (r2 & Hr2 & L1 & L2), (two_least r2 eps Hr2 He) as (r3 & Hr3 & L3 & L4).
  exists (r3 / (2 * M)); split; [apply Rdiv_lt_0_compat; lra|]; intros s w Hs Hw. assert (Sz : size (s, w) <= r3).
  { apply (Rle_trans _ (2 * M * norm (sub (s, w) (s0, w0)))); [apply (size_norm s0 w0 a e Ha)|].
    apply (Rle_trans _ (2 * M * (r3 / (2 * M)))); [|right; field; lra]; apply Rmult_le_compat_l; [lra|].
    apply norm_le; split; assumption. }
  set (z := fun i : Z => Nat.iter (Z.to_nat i) F (s, w)); set (s' := fun i => fst (z i));
    set (w' := fun i => snd (z i)).
  assert (It : forall i, size (z i) <= ((1 + Rabs a) / 2) ^ Z.to_nat i * r3 /\ size (z i) <= r3).
  { intros i; destruct (iterates F s0 w0 a e Ha r1 Hr1 Con (s, w) ltac:(fold size; lra) (Z.to_nat i)) as [I1 I2].
    fold size in I1, I2; split; [|unfold z; lra]; eapply Rle_trans; [exact I1 | apply Rmult_le_compat_l; [|exact Sz]].
    apply pow_le; lra. }
  assert (Nr : forall i b, size (z i) <= b -> Rabs (s' i - s0) <= b /\ Rabs (w' i - w0) <= b).
  { intros i b Hb; destruct (size_norm s0 w0 a e Ha (z i)) as [N1 _]; fold size in N1.
    apply (proj1 (norm_le (sub (z i) (s0, w0)) b)); lra. }
  assert (Hop : forall i, (0 <= i)%Z -> hops (s' i) (w' i) (s' (i + 1)%Z) (w' (i + 1)%Z)).
  { intros i Hi; apply hop_next; unfold s', w'; rewrite <- !surjective_pairing.
    replace (z (i + 1)%Z) with (F (z i)) by (unfold z; replace (Z.to_nat (i + 1)) with (1 + Z.to_nat i)%nat by lia;
      reflexivity).
    apply X; destruct (size_norm s0 w0 a e Ha (z i)) as [N1 _]; fold size in N1; destruct (It i); lra. }
  assert (At : forall i, speeds O n S V mu s' w' i (times n s' i) = w' i).
  { intros i; rewrite <- (Rplus_0_r (times n s' i)), (proj2 (flight_is O n S V mu s' w' i 0)).
    apply (place_0 c k S V HS). }
  assert (Near : forall i b, size (z i) <= b -> near t (times n s') v (speeds O n S V mu s' w') b i).
  { intros i b Hb; unfold near; rewrite At; destruct (once_again _ _ _ _ _ _ _ H1 i s0) as (E1 & _ & E2).
    cbv zeta in *; rewrite E1, E2; unfold times; replace (s' i + _ - _) with (s' i - s0) by ring; apply Nr, Hb. }
  exists (times n s'), (flights O n S V mu s' w'), (speeds O n S V mu s' w').
  assert (T0 : times n s' 0 = s) by (unfold times, s', z; cbn; ring).
  split; [|split; [exact T0|split; [|split; [|split]]]].
  - intros i j Hi ->; apply (hop_swing O n S V mu HO HS); [apply Hop, Hi|].
    destruct (Nr i r3 (proj2 (It i))) as [A _]; apply from in A; lra.
  - rewrite <- T0, At; reflexivity.
  - intros i Hi; apply Near; destruct (It i); lra.
  - intros eta Heta; destruct (pow_lt_1_zero ((1 + Rabs a) / 2)) with (y := eta / r3) as (K & HK).
    { rewrite Rabs_pos_eq; lra. } { apply Rdiv_lt_0_compat; lra. }
    exists (Z.of_nat K); intros i Hi; apply Near; specialize (HK (Z.to_nat i) ltac:(lia)).
    eapply Rle_trans; [apply (proj1 (It i))|]; rewrite Rabs_pos_eq in HK by (apply pow_le; lra).
    apply (Rle_trans _ (eta / r3 * r3)); [apply Rmult_le_compat_r; lra | right; field; lra].
  - intros h t2 y2 v2 Fw E0 E1 i x Hi. assert (Same : forall j : nat, t2 (Z.of_nat j) = times n s' (Z.of_nat j) /\
      v2 (Z.of_nat j) (t2 (Z.of_nat j)) = w' (Z.of_nat j)).
    { induction j as [|j [I1 I2]]; [change (Z.of_nat 0) with 0%Z; rewrite E0, E1; split; [congruence | reflexivity]|].
      destruct (swing_hop O n S V mu HO HS h t2 y2 v2 _ (Fw (Z.of_nat j) _ ltac:(lia) eq_refl)) as (A & _).
      rewrite I2, I1 in A; unfold times in A at 1; replace (s' _ + _ - _) with (s' (Z.of_nat j)) in A by ring.
      destruct (hop_unique c k S V Q Q1 T tau (fun x => proj1 (turn_1 O n mu HO x)) _ _ _ _ _ _ A
        (Hop (Z.of_nat j) ltac:(lia))) as [U1 U2].
      rewrite Nat2Z.inj_succ; change (Z.succ (Z.of_nat j)) with (Z.of_nat j + 1)%Z; rewrite U2; split; [|reflexivity].
      unfold times; rewrite <- U1; ring. }
    destruct (Same (Z.to_nat i)) as [A B]; rewrite Z2Nat.id in A, B by lia; split; [exact A|].
    destruct (swing_hop O n S V mu HO HS h t2 y2 v2 i (Fw i _ Hi eq_refl)) as (_ & _ & E).
    destruct (flight_is O n S V mu s' w' i (x - times n s' i)) as [G1 G2].
    replace (times n s' i + (x - times n s' i)) with x in G1, G2 by ring; rewrite G1, G2.
    destruct (E (x - t2 i)) as [E2 E3]; replace (t2 i + (x - t2 i)) with x in E2, E3 by ring.
    rewrite E2, E3, B, A; replace (times n s' i - T * IZR i) with (s' i) by (unfold times; ring); auto.
Qed.
End Stable.

Theorem Multipliers : Multipliers_statement.
Proof. intros O n m mu d t y v HO HR HN Ht H; apply (multipliers O n m HO HR HN Ht mu d t y v H). Qed.
Theorem Stable : Stable_statement.
Proof. intros O n m mu d t y v HO HR HN Ht H; apply (stable O n m HO HR HN Ht mu d t y v H). Qed.
