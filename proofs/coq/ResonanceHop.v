(** * From one impact to the next at resonance: after the time T every free motion is itself, times q *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOscillator StatementResonance Derivatives Flow.
Open Scope R_scope.

(** ** An impact at the time s, the velocity w after it, and the next at T + s', in free flight and with any stop
    Q of velocity Q1 *)
Section Hop.
Variables (c k : R) (S V : R -> R).
Hypothesis HS : flow c k S V.
Variables (Q Q1 : R -> R) (T q tau : R).
Hypothesis HT : 0 < T.
Hypothesis HQ : forall x, Q (x + T) = Q x.
Hypothesis Hq : forall x, S (T + x) = q * S x /\ V (T + x) = q * V x.

Definition place s w x : R := e11 c S V x * Q s + S x * w.
Definition velocity s w x : R := e21 k S x * Q s + V x * w.
Record hop (s w s' w' : R) : Prop := {
  hop_on : 0 < T + s' - s;
  hop_clear : forall x, 0 < x < T + s' - s -> Q (s + x) < place s w x;
  hop_to : place s w (T + s' - s) = Q s';
  hop_hits : velocity s w (T + s' - s) < Q1 s';
  hop_back : w' = (1 + tau) * Q1 s' - tau * velocity s w (T + s' - s) }.

Lemma place_later s w x : place s w (T + x) = q * place s w x.
Proof. unfold place, e11; destruct (Hq x) as [-> ->]; ring. Qed.
Lemma velocity_later s w x : velocity s w (T + x) = q * velocity s w x.
Proof. unfold velocity, e21; destruct (Hq x) as [-> ->]; ring. Qed.
Lemma place_0 s w : place s w 0 = Q s /\ velocity s w 0 = w.
Proof. unfold place, velocity, e11, e21; rewrite (flow_S _ _ _ _ HS), (flow_V _ _ _ _ HS); split; ring. Qed.
Lemma D_place s w x : derivable_pt_lim (place s w) x (velocity s w x).
Proof.
  unfold place, velocity; derive_by ltac:(first [apply (D_e11 c k S V HS) | apply (D_S c k S V HS)]); ring.
Qed.

(** The next impact is determined. *)
Lemma hop_unique s w s1 w1 s2 w2 : hop s w s1 w1 -> hop s w s2 w2 -> s1 = s2 /\ w1 = w2.
Proof.
  assert (L : forall a b a' b', hop s w a b -> hop s w a' b' -> ~ a < a').
  { intros a b a' b' H H' L; pose proof (hop_clear _ _ _ _ H' (T + a - s)) as C.
    pose proof (hop_on _ _ _ _ H); specialize (C ltac:(lra)); rewrite (hop_to _ _ _ _ H) in C.
    replace (s + (T + a - s)) with (a + T) in C by ring; rewrite HQ in C; lra. }
  intros H1 H2; assert (s1 = s2) as <-.
  { destruct (Rtotal_order s1 s2) as [X|[X|X]]; [|exact X|]; exfalso; revert X; eapply L; eassumption. }
  split; [reflexivity|]; rewrite (hop_back _ _ _ _ H1), (hop_back _ _ _ _ H2); reflexivity.
Qed.

(** One that comes again. *)
Lemma hop_again s w : 0 <= tau <= 1 -> -1 <= q <= 1 -> q <> 1 -> tau * q <> -1 -> hop s w s w <->
  Q s = 0 /\ 0 < Q1 s /\ w = (1 + tau) / (1 + tau * q) * Q1 s /\ forall x, 0 < x < T -> Q (s + x) < S x * w.
Proof.
  intros Ht Hq1 N1 N2; assert (P : 0 < 1 + tau * q) by (assert (-1 <= tau * q) by nra; lra).
  pose proof (place_0 s w) as [E0 E1]; assert (ET : place s w (T + s - s) = q * Q s /\
    velocity s w (T + s - s) = q * w).
  { replace (T + s - s) with (T + 0) by ring; rewrite place_later, velocity_later, E0, E1; auto. }
  destruct ET as [F0 F1]; split.
  - intros [_ C To Hits Back]; rewrite F0 in To; rewrite F1 in Hits, Back.
    assert (Z : Q s = 0) by (apply (Rmult_eq_reg_l (1 - q)); lra).
    assert (W : w = (1 + tau) / (1 + tau * q) * Q1 s).
    { apply (Rmult_eq_reg_l (1 + tau * q)); [|lra]; field_simplify; lra. } repeat split; trivial.
    + apply (Rmult_lt_reg_l (1 - q)); [lra|]; apply (Rmult_lt_compat_l (1 + tau * q)) in Hits; [|exact P].
      rewrite W in Hits; replace ((1 + tau * q) * (q * _)) with (q * (1 + tau) * Q1 s) in Hits by (field; lra); lra.
    + intros x Hx; specialize (C x ltac:(lra)); unfold place in C; rewrite Z in C; lra.
  - intros (Z & P1 & W & C); constructor; rewrite ?F0, ?F1; try lra.
    + intros x Hx; unfold place; rewrite Z; specialize (C x ltac:(lra)); lra.
    + rewrite Z; ring.
    + apply (Rmult_lt_reg_l (1 + tau * q)); [exact P|]; rewrite W.
      replace ((1 + tau * q) * (q * _)) with (q * (1 + tau) * Q1 s) by (field; lra); nra.
    + rewrite W; field; lra.
Qed.
Lemma hop_even s w : 0 <= tau -> q = 1 -> ~ hop s w s w.
Proof.
  intros Ht E [_ _ _ Hits Back]; replace (T + s - s) with (T + 0) in Hits, Back by ring.
  rewrite velocity_later, (proj2 (place_0 s w)), E in Hits, Back; nra.
Qed.
Lemma hop_odd s w : tau * q = -1 -> q <= 0 -> 0 <= tau -> hop s w s w -> Q s = 0 /\ Q1 s = 0.
Proof.
  intros E Hq0 Ht [_ _ To _ Back]; replace (T + s - s) with (T + 0) in To, Back by ring.
  rewrite place_later, (proj1 (place_0 s w)) in To; rewrite velocity_later, (proj2 (place_0 s w)) in Back.
  replace (tau * (q * w)) with (tau * q * w) in Back by ring; rewrite E in Back; split; nra.
Qed.
End Hop.

(** ** Hops are what [swing] says *)
Section Swing.
Variables (O : Oscillator.t) (n m : nat) (S V : R -> R) (mu : R).
Hypothesis HO : any_stop O.
Hypothesis HR : resonant O n m.
Notation c := (Oscillator.c O).
Notation k := (Oscillator.k O).
Notation tau := (Oscillator.tau O).
Notation Q := (stop O mu).
Notation Q1 := (stop1 O mu).
Notation T := (2 * PI * INR n).
Hypothesis HS : flow c k S V.
Notation hops := (hop c k S V Q Q1 T tau).

Lemma period_pos : 0 < T.
Proof.
  pose proof PI_RGT_0; pose proof (le_INR 1 n (res_periods _ _ _ HR)) as P; change (INR 1) with 1 in P; nra.
Qed.
Lemma stop_later z x : Q (x + 2 * PI * IZR z) = Q x /\ Q1 (x + 2 * PI * IZR z) = Q1 x.
Proof.
  unfold stop, stop1; split; [rewrite (whole_periods (Oscillator.G O mu)); [reflexivity | apply HO]|].
  rewrite (whole_periods (Oscillator.G1 O mu)); [reflexivity|].
  apply (periodic_slope (Oscillator.G O mu)); [apply (stop_period _ HO) | apply (stop_slope _ HO)].
Qed.
Lemma turns i x : Q (x + T * IZR i) = Q x /\ Q1 (x + T * IZR i) = Q1 x.
Proof.
  rewrite INR_IZR_INZ; replace (2 * PI * _ * _) with (2 * PI * IZR (Z.of_nat n * i)) by (rewrite mult_IZR; ring).
  apply stop_later.
Qed.
Lemma turn_1 x : Q (x + T) = Q x /\ Q1 (x + T) = Q1 x.
Proof. replace (x + T) with (x + T * IZR 1) by ring; apply turns. Qed.
Lemma gap_is z f x : gap O Plus mu z f x = f x - Q x.
Proof.
  unfold gap; cbn [facing turn]; destruct (stop_later (- z) x) as [E _]; unfold stop in *.
  rewrite opp_IZR in E; replace (x - 2 * PI * IZR z) with (x + 2 * PI * - IZR z) by ring; lra.
Qed.
Lemma speed_is z f x : speed O Plus mu z f x = f x - Q1 x.
Proof.
  unfold speed; cbn [facing turn]; destruct (stop_later (- z) x) as [_ E]; unfold stop1 in *.
  rewrite opp_IZR in E; replace (x - 2 * PI * IZR z) with (x + 2 * PI * - IZR z) by ring; lra.
Qed.

Notation N := (fun i => Z.of_nat n * i)%Z.
Notation Y := (place c S V Q).
Notation U := (velocity k S V Q).
Lemma near_is i x : x - turn Plus * IZR (N i) = x - T * IZR i.
Proof. cbn [turn]; rewrite mult_IZR, <- INR_IZR_INZ; ring. Qed.

Lemma swing_hop d t y v i : swing O Plus mu d N t y v i (i + 1) ->
  let s i := t i - T * IZR i in let w i := v i (t i) in
  hops (s i) (w i) (s (i + 1)%Z) (w (i + 1)%Z) /\ Rabs (s i) <= d /\
  forall x, y i (t i + x) = Y (s i) (w i) x /\ v i (t i + x) = U (s i) (w i) x.
Proof.
  intros [Hf Hn Hon H0 H1 Hc Hh Hb] s w; rewrite gap_is in H0, H1; rewrite speed_is in Hh; rewrite !speed_is in Hb.
  rewrite near_is in Hn; fold (s i) in Hn. assert (Es : forall j, Q (t j) = Q (s j) /\ Q1 (t j) = Q1 (s j)).
  { intros j; unfold s; destruct (turns j (t j - T * IZR j)) as [<- <-]; split; f_equal; ring. }
  assert (E : forall x, y i (t i + x) = Y (s i) (w i) x /\ v i (t i + x) = U (s i) (w i) x).
  { intros x; destruct (free_moved c k S V HS (y i) (v i) (t i) (t i + x) Hf) as [-> ->].
    unfold moved, moving, place, velocity; replace (t i + x - t i) with x by ring; unfold w.
    rewrite <- (proj1 (Es i)); split; repeat f_equal; lra. }
  assert (Et : t (i + 1)%Z = t i + (T + s (i + 1)%Z - s i)) by (unfold s; rewrite plus_IZR; ring).
  split; [|auto]; constructor.
  - lra.
  - intros x Hx; specialize (Hc 0%Z (t i + x) ltac:(lra)); rewrite gap_is, (proj1 (E x)) in Hc.
    replace (t i + x) with (s i + x + T * IZR i) in Hc by (unfold s; ring); rewrite (proj1 (turns i _)) in Hc; lra.
  - rewrite <- (proj1 (E _)), <- Et, <- (proj1 (Es _)); lra.
  - rewrite <- (proj2 (E _)), <- Et, <- (proj2 (Es _)); lra.
  - rewrite <- (proj2 (E _)), <- Et, <- (proj2 (Es _)); unfold w; lra.
Qed.

(** The motion through given impacts. *)
Section Through.
Variables s w : Z -> R.
Definition times (i : Z) : R := s i + T * IZR i.
Definition flights (i : Z) : R -> R := moved c S V (times i) (Q (s i)) (w i).
Definition speeds (i : Z) : R -> R := moving k S V (times i) (Q (s i)) (w i).
Lemma flight_is i x : flights i (times i + x) = Y (s i) (w i) x /\ speeds i (times i + x) = U (s i) (w i) x.
Proof.
  unfold flights, speeds, moved, moving; replace (times i + x - times i) with x by ring; split; reflexivity.
Qed.
Lemma hop_swing d i : hops (s i) (w i) (s (i + 1)%Z) (w (i + 1)%Z) -> Rabs (s i) <= d ->
  swing O Plus mu d N times flights speeds i (i + 1).
Proof.
  intros [Hon Hc Hto Hh Hb] Hd.
  assert (E0 : forall j, flights j (times j) = Q (times j) /\ speeds j (times j) = w j /\ Q (times j) = Q (s j) /\
    Q1 (times j) = Q1 (s j)).
  { intros j; destruct (flight_is j 0) as [A B], (place_0 c k S V HS Q (s j) (w j)) as [C D].
    rewrite Rplus_0_r in A, B; rewrite A, B, C, D; destruct (turns j (s j)) as [F G]; unfold times; rewrite F, G;
      auto. } destruct (flight_is i (T + s (i + 1)%Z - s i)) as [A B].
  replace (times i + (T + s (i + 1)%Z - s i)) with (times (i + 1)) in A, B by (unfold times; rewrite plus_IZR; ring).
  destruct (E0 i) as (F1 & F2 & F3 & F4), (E0 (i + 1)%Z) as (G1 & G2 & G3 & G4).
  constructor; rewrite ?gap_is, ?speed_is; try lra.
  - apply (moved_free c k S V HS).
  - rewrite near_is; unfold times; replace (_ - _) with (s i) by ring; exact Hd.
  - unfold times; rewrite plus_IZR; lra.
  - intros z x Hx; rewrite gap_is; replace x with (times i + (x - times i)) by ring; rewrite (proj1 (flight_is i _)).
    assert (Hx' : 0 < x - times i < T + s (i + 1)%Z - s i) by (unfold times in *; rewrite plus_IZR in Hx; lra).
    specialize (Hc _ Hx'); destruct (turns i (s i + (x - times i))) as [X _].
    replace (s i + (x - times i) + T * IZR i) with (times i + (x - times i)) in X by (unfold times; ring); lra.
  - rewrite G2, G4, B, Hb; ring.
Qed.
End Through.
End Swing.
