(** * The paper's oscillator: legs of one and two periods follow each other in every order *)

From Coq Require Import Reals QArith Qreals ZArith Lra Lia List FunctionalExtensionality.
From Grazing Require Headline.
From Grazing Require Import Defs StatementOscillator StatementNordmark Derivatives Flow OscillatorUses Nordmark
  PlaneLinear.
From Grazing Require Import PathsFlow PathsCheck PathsChecked Paths ChaosCertificates StatementPaths StatementChaos.
Open Scope R_scope.

(** ** It is a machine, with lengths divided by 1 + mu *)

Definition machine (mu : R) : Machine.t := {| Machine.c := 12 / 49; Machine.k := 100 / 2401; Machine.tau := 1;
  Machine.sigma := 1; Machine.nu := mu / (1 + mu); Machine.harmonics := (1%positive, (1, 0)) :: nil |}.
Definition scaled (mu : R) (f : Z -> R -> R) : Z -> R -> R := fun i x => f i x / (1 + mu).

Lemma nu_range mu : mu > 0 -> 0 < mu / (1 + mu) < 1.
Proof.
  intros H; split; [apply Rdiv_lt_0_compat; lra|].
  apply (Rmult_lt_reg_r (1 + mu)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
Qed.
Lemma machine_wall mu t : g (machine mu) t = cos t /\ g1 (machine mu) t = - sin t /\ bend (machine mu) t = cos t.
Proof. unfold g, g1, bend; cbn [machine Machine.harmonics over_harmonics]; rewrite ?(Rmult_1_l t); change (IZR (1 * 1))
    with 1; repeat split; ring. Qed.

Lemma free_over c k r f f' : free c k f f' -> free c k (fun x => f x * r) (fun x => f' x * r).
Proof.
  intros H x; destruct (H x) as [D D']; split.
  - eapply D_ext; [apply (D_scale _ _ _ r D) | intros; cbv beta; ring | ring].
  - eapply D_ext; [apply (D_scale _ _ _ r D') | intros; cbv beta; ring | cbv beta; ring].
Qed.
Lemma free_ext c k f f' h h' : (forall x, f x = h x) -> (forall x, f' x = h' x) -> free c k f f' -> free c k h h'.
Proof. intros E E'; apply functional_extensionality in E, E'; subst; trivial. Qed.

(** There is no other free motion from a place with a velocity. *)
Lemma paper_moved q v t0 t : free (12 / 49) (100 / 2401) q v -> q t = moved (machine 1) t0 (q t0) (v t0) t /\
  v t = moving (machine 1) t0 (q t0) (v t0) t.
Proof. intros H; apply (free_moved (machine 1)); [cbn; lra | exact H]. Qed.

(** The motion in the words of [Nordmark_statement]. *)
Lemma chaos_words mu N t y v : chaos_motion mu N t y v <-> forall i j, j = (i + 1)%Z -> free (12 / 49) (100 / 2401)
  (y i) (v i) /\ Rabs (t i - 2 * PI * IZR (N i)) <= 6 / 5 /\ t i < t j /\ y i (t i) = (1 + mu) * cos (t i) - 1 /\
  y i (t j) = (1 + mu) * cos (t j) - 1 /\ (forall x, t i < x < t j -> y i x > (1 + mu) * cos x - 1) /\
  v i (t j) < - ((1 + mu) * sin (t j)) /\ v j (t j) = - 1 * v i (t j) - (1 + 1) * (1 + mu) * sin (t j).
Proof.
  destruct (Nordmark_oscillator (3 / 5) (49 / 10) 1 ltac:(lra) ltac:(lra)) as (_ & _ & _ & H); unfold chaos_motion.
  replace (12 / 49) with (2 * (3 / 5) / (49 / 10)) by field; replace (100 / 2401) with (1 / (49 / 10) ^ 2) by field.
  exact (H mu (6 / 5) N t y v).
Qed.
(** The law of impact keeps impacts away from the ends of the window if velocities are small. *)
Lemma inside_window mu N t y v : mu > 0 -> chaos_motion mu N t y v ->
  (forall i, Rabs (v i (t (i + 1)%Z) + v (i + 1)%Z (t (i + 1)%Z)) < 1 + mu) -> forall i, Rabs (t i - 2 * PI * IZR (N i))
  < 6 / 5.
Proof.
  intros Hmu HM HV i; rewrite chaos_words in HM; destruct (HM i _ eq_refl) as (_ & [L|E] & _); [exact L | exfalso].
  destruct (HM (i - 1)%Z i ltac:(lia)) as (_ & _ & _ & _ & _ & _ & _ & V); specialize (HV (i - 1)%Z).
  replace (i - 1 + 1)%Z with i in HV by lia; apply Rabs_def2 in HV; destruct (periods_back (N i) (t i)) as [_ S].
  pose proof PI2_3_2; pose proof PI_4; pose proof (sin_increasing_1 (PI / 6) (6 / 5) ltac:(lra) ltac:(lra) ltac:(lra)
    ltac:(lra) ltac:(lra)) as B.
  rewrite sin_PI6 in B; assert (sin (t i) = sin (6 / 5) \/ sin (t i) = - sin (6 / 5)) as [Z|Z];
    [|rewrite Z in V; nra..].
  rewrite <- S, <- sin_neg; unfold Rabs in E; destruct Rcase_abs; [right | left]; f_equal; lra.
Qed.

Lemma motion_scaled mu N t y v : mu > 0 -> (chaos_motion mu N t y v /\ (forall i, Rabs (t i - 2 * PI * IZR (N i)) < 6
  / 5) <-> machine_motion (machine mu) (6 / 5) N t (scaled mu y) (scaled mu v)).
Proof.
  intros Hmu; set (r := 1 + mu); assert (Hr : 0 < r) by (unfold r; lra); rewrite chaos_words; fold r.
  assert (HW : forall t, StatementPaths.wall (machine mu) t * r = r * cos t - 1).
  { intros u; unfold StatementPaths.wall; destruct (machine_wall mu u) as (-> & _); cbn; fold r; unfold r; field; lra. }
  assert (HV : forall t, g1 (machine mu) t * r = - (r * sin t)) by (intros u; destruct (machine_wall mu u)
    as (_ & -> & _); ring).
  assert (S : forall f i x, scaled mu f i x * r = f i x) by (intros; unfold scaled, r; field; lra).
  assert (X : forall a b a' b', a * r = a' -> b * r = b' -> ((a = b <-> a' = b') /\ (a < b <-> a' < b'))).
  { intros a b a' b' <- <-; split; split; intros H; try nra; apply (Rmult_eq_reg_r r); lra. }
  split.
  - intros [H A] i j E; destruct (H i j E) as (F & _ & O & Q0 & Q1 & G & V & V'); constructor;
      [exact (free_over _ _ (/ r) _ _ F) | apply A | exact O | apply (X _ _ _ _ (S y i (t i)) (HW (t i))), Q0 |
      apply (X _ _ _ _ (S y i (t j)) (HW (t j))), Q1 | ..].
    + intros x Hx; apply (X _ _ _ _ (HW x) (S y i x)), G, Hx.
    + pose proof (S v i (t j)); pose proof (HV (t j)); nra.
    + pose proof (S v i (t j)); pose proof (S v j (t j)); pose proof (HV (t j)); cbn [machine Machine.tau]; nra.
  - intros H; split; [|intros i; apply (H i _ eq_refl)]; intros i j E; destruct (H i j E) as [F A O Q0 Q1 G V V'].
    split; [apply (free_ext _ _ (fun x => scaled mu y i x * r) (fun x => scaled mu v i x * r));
      [apply S | apply S | apply free_over, F]|].
    split; [lra|]; split; [exact O|]; split; [apply (X _ _ _ _ (S y i (t i)) (HW (t i))), Q0|].
    split; [apply (X _ _ _ _ (S y i (t j)) (HW (t j))), Q1|]; split; [intros x Hx; apply (X _ _ _ _ (HW x) (S y i x)),
      G, Hx|].
    cbn [machine Machine.tau] in V'; rewrite <- (S v i (t j)), <- (S v j (t j)); pose proof (HV (t j)); split; nra.
Qed.

Lemma within_scaled mu X y : mu > 0 ->
  (in_interval X (y / (1 + mu) / Machine.nu (machine mu)) <-> Q2R (fst X) * mu <= y <= Q2R (snd X) * mu).
Proof.
  intros H; unfold in_interval; cbn [machine Machine.nu].
  replace (y / (1 + mu) / (mu / (1 + mu))) with (y / mu) by (field; lra).
  assert (E : y = y / mu * mu) by (field; lra); set (z := y / mu) in *; rewrite E; split; intros; split; nra.
Qed.

(** ** Words over {1, 2} as paths *)

Definition letter_of (n : Z) : Letter.t := if (n =? 1)%Z then one else two.
Definition letters_of (N : Z -> Z) (i : Z) : Letter.t := letter_of (N (i + 1) - N i)%Z.

Lemma letters_path N : one_or_two N -> leg_path chaos_12 (letters_of N) /\ turns (letters_of N) N.
Proof.
  intros H; assert (C : forall i, letters_of N i = one /\ (N (i + 1) = N i + 1)%Z \/ letters_of N i = two /\
    (N (i + 1) = N i + 2)%Z).
  { intros i; unfold letters_of, letter_of; destruct (H i) as [E|E]; rewrite E; [left | right]; split; trivial.
    - replace (N i + 1 - N i)%Z with 1%Z by lia; reflexivity.
    - replace (N i + 2 - N i)%Z with 2%Z by lia; reflexivity. }
  split; intros i; destruct (C i) as [[-> E]|[-> E]]; try (rewrite E; reflexivity); (split; [cbn; tauto|]);
    (destruct (C (i + 1)%Z) as [[-> _]|[-> _]]; [exists 0%nat | exists 1%nat]; cbn; tauto).
Qed.

Lemma machine_covered mu : mu > 0 -> covers chaos_12 (machine mu).
Proof.
  intros H; pose proof (nu_range mu H); destruct (machine_wall mu 0) as (E1 & E2 & _).
  assert (G : g (machine mu) 0 = 1 /\ g1 (machine mu) 0 = 0) by (rewrite E1, E2, cos_0, sin_0; lra); clear E1 E2.
  constructor; try apply G; try (unfold in_interval, Q2R; cbn; lra).
  constructor; [|constructor]; unfold in_interval, Q2R; cbn; repeat split; lra.
Qed.

Lemma boxes_scaled mu N t v : mu > 0 -> one_or_two N ->
  (in_two_boxes mu N t v <-> in_boxes (machine mu) (letters_of N) t (scaled mu v)).
Proof.
  intros Hmu HN; unfold in_two_boxes, in_boxes, scaled; split; intros H i j E; specialize (H i j E); subst j.
  - rewrite !within_scaled by exact Hmu; unfold letters_of, letter_of; destruct H as [H1 H2], (HN i) as [E|E];
      rewrite E.
    + replace (N i + 1 - N i =? 1)%Z with true by (symmetry; apply Z.eqb_eq; lia); specialize (H1 E).
      unfold Q2R; cbn; lra.
    + replace (N i + 2 - N i =? 1)%Z with false by (symmetry; apply Z.eqb_neq; lia); specialize (H2 E).
      unfold Q2R; cbn; lra.
  - rewrite !within_scaled in H by exact Hmu; unfold letters_of, letter_of in H; split; intros E; rewrite E in H.
    + replace (N i + 1 - N i =? 1)%Z with true in H by (symmetry; apply Z.eqb_eq; lia). unfold Q2R in H; cbn in H; lra.
    + replace (N i + 2 - N i =? 1)%Z with false in H by (symmetry; apply Z.eqb_neq; lia).
      unfold Q2R in H; cbn in H; lra.
Qed.

(** What a certificate says of the machine, said of the oscillator. *)
Lemma scaled_motion X mu l N : mu > 0 -> check X = true -> covers X (machine mu) -> leg_path X l -> turns l N ->
  Q2R (Certificate.window X) = 6 / 5 -> let boxed t v := in_boxes (machine mu) l t (scaled mu v) in
  (forall t v, boxed t v -> forall i, Rabs (v i (t (i + 1)%Z) + v (i + 1)%Z (t (i + 1)%Z)) < 1 + mu) ->
  exists t y v, chaos_motion mu N t y v /\ boxed t v /\ forall t' y' v', chaos_motion mu N t' y' v' -> boxed t' v' ->
  forall i x, t' i = t i /\ y' i x = y i x /\ v' i x = v i x.
Proof.
  intros Hmu HX HM HP HT EW boxed Small; destruct (Paths X (machine mu) l N HX HM HP HT) as (t & y & v & Ht & HB & H1).
  rewrite EW in Ht, H1; set (r := 1 + mu); assert (Hr : r <> 0) by (unfold r; lra).
  set (y' := fun i x => y i x * r); set (v' := fun i x => v i x * r).
  assert (Ey : scaled mu y' = y /\ scaled mu v' = v).
  { split; apply functional_extensionality; intros i; apply functional_extensionality; intros x; unfold scaled, y', v';
      fold r; field; exact Hr. }
  destruct Ey as [Ey Ev]; exists t, y', v'; split; [apply motion_scaled; [exact Hmu | rewrite Ey, Ev; exact Ht]|].
  unfold boxed; split; [rewrite Ev; exact HB|]; intros t2 y2 v2 HM2 HB2 i x.
  destruct (H1 _ _ _ (proj1 (motion_scaled _ _ _ _ _ Hmu) (conj HM2 (inside_window _ _ _ _ _ Hmu HM2 (Small _ _ HB2))))
    HB2 i x) as (A & B & C).
  split; [exact A|]; unfold scaled in B, C; fold r in B, C; unfold y', v'; rewrite <- B, <- C; split; field; exact Hr.
Qed.

Lemma small_12 mu N t v : mu > 0 -> one_or_two N -> in_two_boxes mu N t v ->
  forall i, Rabs (v i (t (i + 1)%Z) + v (i + 1)%Z (t (i + 1)%Z)) < 1 + mu.
Proof.
  intros Hmu HN HB i; destruct (HB i _ eq_refl) as [B1 B2], (HB (i + 1)%Z _ eq_refl) as [C1 C2].
  destruct (HN i) as [E|E]; [specialize (B1 E) | specialize (B2 E)]; destruct (HN (i + 1)%Z) as [F|F];
    [specialize (C1 F) | specialize (C2 F) | specialize (C1 F) | specialize (C2 F)]; apply Rabs_def1; lra.
Qed.

Theorem Chaos_oscillator : Headline.Chaos_statement.
Proof.
  intros mu N Hmu HN; destruct (letters_path N HN) as [HP HT].
  destruct (scaled_motion chaos_12 mu (letters_of N) N Hmu checked_12 (machine_covered mu Hmu) HP HT)
    as (t & y & v & HM & HB & H1).
  - unfold Q2R; cbn; lra.
  - intros t v HB; apply (small_12 mu N t v Hmu HN), boxes_scaled; assumption.
  - exists t, y, v; split; [exact HM|]; split; [apply boxes_scaled; assumption|].
    intros t' y' v' HM' HB'; apply H1; [exact HM' | apply boxes_scaled; assumption].
Qed.

(** ** The times determine N; periodic sequences have periodic motions *)

Lemma chaos_near mu N t y v i : chaos_motion mu N t y v -> - (6 / 5) <= t i - 2 * PI * IZR (N i) <= 6 / 5.
Proof. intros H; apply le_abs, (H i _ eq_refl). Qed.

Theorem Chaos_distinct : Chaos_distinct_statement.
Proof.
  intros mu N N' t q v q' v' H H' i; pose proof (chaos_near _ _ _ _ _ i H) as A; pose proof (chaos_near _ _ _ _ _ i H')
    as A'.
  pose proof PI2_3_2; destruct (Z.lt_trichotomy (N i) (N' i)) as [L|[E|L]]; [exfalso | exact E | exfalso].
  - assert (IZR (N i) + 1 <= IZR (N' i)) by (rewrite <- plus_IZR; apply IZR_le; lia); nra.
  - assert (IZR (N' i) + 1 <= IZR (N i)) by (rewrite <- plus_IZR; apply IZR_le; lia); nra.
Qed.

Theorem Chaos_periodic : Chaos_periodic_statement.
Proof.
  intros mu N t q v m P Hmu HN HM HB HP i x; destruct (Chaos_oscillator mu N Hmu HN) as (t0 & q0 & v0 & _ & _ & H1).
  pose proof (motion_later _ _ _ _ _ _ _ _ _ _ HM HP) as HM'; cbn [StatementOscillator.turn] in HM'.
  assert (HB' : in_two_boxes mu N (fun i => t (i + m)%Z - 2 * PI * IZR P) (fun i => later Plus P (v (i + m)%Z))).
  { intros l j ->; unfold later; cbn [StatementOscillator.turn facing]; rewrite !Rmult_1_l.
    replace (t (l + m)%Z - 2 * PI * IZR P + 2 * PI * IZR P) with (t (l + m)%Z) by ring.
    replace (t (l + 1 + m)%Z - 2 * PI * IZR P + 2 * PI * IZR P) with (t (l + 1 + m)%Z) by ring.
    destruct (HB (l + m)%Z (l + 1 + m)%Z ltac:(lia)) as [B1 B2]; rewrite !HP in B1, B2; split; intros E;
      [apply B1 | apply B2]; lia. }
  destruct (H1 _ _ _ HM HB i x) as (T1 & Q1 & V1), (H1 _ _ _ HM' HB' i x) as (T2 & Q2 & V2).
  unfold later in Q2, V2; cbn [StatementOscillator.turn facing] in Q2, V2; rewrite Rmult_1_l in Q2, V2; rewrite Q1, V1;
    split; [lra | auto].
Qed.
