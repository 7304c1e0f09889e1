(** * Numbers worked out by hand that follow from the statements about motions and orbits: an undamped
      oscillator with a restitution of 0, words, two stops, and which (a1, a2) have one *)
From Coq Require Import Reals ZArith List FunctionalExtensionality Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementWords StatementExamples StatementOrbits
  StatementOrbitsPlane StatementOrbitsInstance StatementOrbitsPeriodic StatementOscillator StatementNordmark
  Headline StatementSystems StatementOneImpact Farey StatementZ OrbitZ.
From Grazing Require StatementResonance.
Import ListNotations.
Open Scope R_scope.

Ltac numbers := unfold c, v, b, p, q, u; simpl; lra.

(** ** d = 0, w = 4: a1 = 0, a2 = 1; u = 0, 1, 0, -1, b_{3,1} = b_{3,2} = c_3 = 2: period 3 in (+,+) *)
Lemma orbit_0_1_3 : orbit 0 1 3 Plus Plus.
Proof.
  split; [|split]; [numbers | | numbers]. intros k Hk; assert (k = 1 \/ k = 2)%nat as [->| ->] by lia; numbers.
Qed.

(** A restitution of 0 is allowed. *)
Lemma without_bounce O m a1 a2 gamma : touching O -> Oscillator.tau O = 0 ->
  matrix (Oscillator.c O) (Oscillator.k O) m a1 a2 gamma -> gamma <> 0 -> grazing O m a1 a2 gamma.
Proof. intros HT E HM Hg; constructor; trivial; lra. Qed.

(** The oscillator of the paper with d = 0, w = 4 and tau = 0 has a1 = 0, a2 = 1 and gamma > 0. *)
Lemma undamped : Nordmark_statement -> exists gamma, grazing (Nordmark 0 4 0) Plus 0 1 gamma /\ gamma > 0.
Proof.
  intros HN; pose proof PI_RGT_0; destruct (HN 0 4 0 ltac:(lra) ltac:(lra)) as [G _].
  destruct (G (1 / 4)) as (gamma & HG & Hg); [lra | lra | | |].
  { replace (1 - 0 ^ 2) with 1 by ring; rewrite sqrt_1; field. }
  { replace (2 * PI * (1 / 4)) with (PI / 2) by field; rewrite sin_PI2; lra. }
  replace (2 * PI * (1 / 4)) with (PI / 2) in HG, Hg by field; rewrite sin_PI2 in Hg; rewrite cos_PI2 in HG.
  replace (-4 * PI * 0 / 4) with 0 in HG by field; rewrite exp_0, Rmult_0_r in HG.
  exists gamma; split; [exact HG | lra].
Qed.

(** The equations as in the paper: for small mu < 0 a ball that does not bounce, tau = 0, touches every third period. *)
Lemma period_3_without_bounce : Nordmark_statement -> Single_statement -> Periodic_oscillator_statement -> exists mu0,
  0 < mu0 /\ forall mu, - mu0 < mu < 0 -> exists t y v, t 1%Z = t 0%Z + 2 * PI * 3 /\ y 0%Z (t 0%Z) = (1 + mu) * cos
  (t 0%Z) - 1 /\ v 1%Z (t 1%Z) = - ((1 + mu) * sin (t 1%Z)) /\ (forall x, t 0%Z < x < t 1%Z -> y 0%Z x > (1 + mu) * cos
  x - 1) /\ forall x, derivable_pt_lim (v 0%Z) x (- (1 / 16) * y 0%Z x).
Proof.
  intros HN HS HP; destruct (undamped HN) as (gamma & HG & Hg); destruct (HN 0 4 0 ltac:(lra) ltac:(lra))
    as (_ & _ & _ & E).
  destruct (HS (Oscillates (Nordmark 0 4 0) Plus) 0 1 gamma 3%nat Plus Plus HG) as [B _]; [lia | numbers | cbn; lra|].
  destruct (B orbit_0_1_3) as (d & Hd & P); destruct (P d ltac:(lra)) as (mu0 & Hm & Q); exists mu0; split; [lra|].
  intros mu Hmu; set (N i := (i * 3)%Z); assert (HN3 : forall i, (N (i + 1) = N i + Z.of_nat 3)%Z) by (intros; unfold N;
    lia).
  destruct (Q (- mu) ltac:(cbn; lra) N HN3) as [One _]; destruct (One) as (t & y & v & HM & _).
  destruct (HP _ _ _ _ N t y v 1%Z 3%Z (is_touching _ _ _ _ _ HG) One HM HN3 0%Z 0) as (T & _).
  exists t, y, v; pose proof (proj1 (E mu d N t y v) HM) as HL; destruct (HL 0%Z 1%Z eq_refl)
    as (F & _ & _ & H1 & _ & H2 & _ & H3).
  change (0 + 1)%Z with 1%Z in T; cbn [turn] in T.
  split; [exact T|]; split; [exact H1|]; split; [lra|]; split; [exact H2|].
  intros x; destruct (F x) as [_ D]; replace (- (1 / 16) * y 0%Z x) with (- (2 * 0 / 4) * v 0%Z x - 1 / 4 ^ 2 * y 0%Z x)
    by field; exact D.
Qed.
Lemma sqrt_quarter : sqrt (1 / 4) = 1 / 2.
Proof. replace (1 / 4) with (1 / 2 * (1 / 2)) by field; apply sqrt_square; lra. Qed.

(** There an oscillator has two stops. *)
Lemma region_4 : Reach_statement -> (forall O m gamma, grazing O m (-6 / 5) (1 / 4) gamma -> m = Minus) /\
  exists c k g, matrix c k Minus (-6 / 5) (1 / 4) g /\ g < 0.
Proof.
  intros [_ _ _ R4 R5]; split.
  - intros O m gamma HG; destruct m; [|reflexivity].
    destruct (R4 _ _ _ _ _ (is_matrix _ _ _ _ _ HG) (is_generic _ _ _ _ _ HG)) as (_ & X & _); rewrite sqrt_quarter
      in X; lra.
  - destruct (R5 (-6 / 5) (1 / 4)) as (c & k & g & X); [lra | rewrite sqrt_quarter; lra | exists c, k, g; exact X].
Qed.

(** Both signs of gamma at s = 1/6 on the circle; gamma > 0 at (3, 1/2). *)
Lemma reached : Reach_statement -> (exists c k gamma, matrix c k Plus (2 * 1 * cos (2 * PI * (1 / 6))) (1 ^ 2) gamma /\
  gamma < 0) /\ (exists c k gamma, matrix c k Plus 3 (1 / 2) gamma /\ gamma > 0) /\
  (forall c k a1 a2 gamma, matrix c k Plus a1 a2 gamma -> gamma <> 0 -> 0 < a2) /\
  (forall c k gamma, matrix c k Plus 3 (1 / 2) gamma -> gamma <> 0 -> gamma > 0) /\ exists a1 a2 gamma,
  matrix 7 (-2) Plus a1 a2 gamma.
Proof.
  pose proof (sqrt_le_1 (1 / 2) 1 ltac:(lra) ltac:(lra) ltac:(lra)) as X; rewrite sqrt_1 in X.
  intros [R1 R2 R3 R4 _]; split; [|split; [|split; [|split]]].
  - destruct (R2 1 (1 / 6) Minus ltac:(lra) ltac:(lra)) as (c & k & gamma & M & G); exists c, k, gamma; split;
      [exact M | cbn in G; lra].
  - destruct (R3 3 (1 / 2)) as (c & k & gamma & M); [lra | lra | exists c, k, gamma; exact M].
  - intros c k a1 a2 gamma M G; apply (R4 c k a1 a2 gamma M G).
  - intros c k gamma M G; apply (R4 c k 3 (1 / 2) gamma M G); lra.
  - apply R1.
Qed.

(** ** A periodic word between two stops, one half turn on: the motion is its own mirror image *)
Lemma mirrored : Periodic_oscillator_statement -> forall O mu d t y v, touching O -> one_motion O Minus mu d (fun i =>
  i) -> motion O Minus mu d (fun i => i) t y v -> t 1%Z = t 0%Z + PI /\ forall x, y 1%Z (x + PI) = - y 0%Z x /\
  v 1%Z (x + PI) = - v 0%Z x.
Proof.
  intros P O mu d t y v HO H1 HM; assert (Q := P O Minus mu d (fun i => i) t y v 1%Z 1%Z HO H1 HM ltac:(intros;
    reflexivity)).
  split; [destruct (Q 0%Z 0) as [A _]; cbn in A; lra|]; intros x; destruct (Q 0%Z x) as (_ & A & B); cbn in A, B.
  rewrite Rmult_1_r in A, B; lra.
Qed.

(** ** What a motion between two stops is: from the lower one to the upper one, half a turn later, and back at
    tau times the speed *)
Lemma bounces O mu d t y v : motion O Minus mu d (fun i => i) t y v -> (forall x, derivable_pt_lim (y 0%Z) x (v 0%Z x)
  /\ derivable_pt_lim (v 0%Z) x (- Oscillator.c O * v 0%Z x - Oscillator.k O * y 0%Z x)) /\ - d <= t 0%Z <= d /\
  t 0%Z < t 1%Z /\ y 0%Z (t 0%Z) = - mu - Oscillator.G O mu (t 0%Z) /\ y 0%Z (t 1%Z) = mu + Oscillator.G O mu
  (t 1%Z - PI) /\ (forall x, t 0%Z < x < t 1%Z -> - mu - Oscillator.G O mu x < y 0%Z x < mu + Oscillator.G O mu
  (x - PI)) /\ let V i := v i (t 1%Z) - Oscillator.G1 O mu (t 1%Z - PI) in V 0%Z > 0 /\ V 1%Z = - Oscillator.tau O * V
  0%Z.
Proof.
  intros HM; destruct (HM 0%Z 1%Z eq_refl) as [F D L Q0 Q1 A V1 V2]; unfold gap, speed in *; cbn in *.
  rewrite ?Rmult_0_r, ?Rmult_1_r, ?Rminus_0_r in *; split; [exact F|]; split; [unfold Rabs in D; destruct Rcase_abs;
    lra|].
  repeat (split; [lra|]); split; [|lra]; intros x Hx; pose proof (A 0%Z x Hx) as A0; pose proof (A 1%Z x Hx) as A1.
  cbn in A0, A1; rewrite ?Rmult_0_r, ?Rmult_1_r, ?Rminus_0_r in *; lra.
Qed.
Lemma the_motion O m mu d N : one_motion O m mu d N -> exists t y v, motion O m mu d N t y v /\ forall t' y' v',
  motion O m mu d N t' y' v' -> (forall i, t' i = t i) /\ (forall i x, y' i x = y i x /\ v' i x = v i x).
Proof.
  intros (t & y & v & M & U); exists t, y, v; split; [exact M|]; intros t' y' v' M'; split; intros i; [|intros x];
    [destruct (U t' y' v' M' i 0) as (A & _) | destruct (U t' y' v' M' i x) as (_ & A)]; exact A.
Qed.

(** The matrix by what the motions do that start at 0 with velocity 1, and at 1 with velocity 0. *)
Lemma matrix_means c k a1 a2 gamma : matrix c k Minus a1 a2 gamma -> forall y v,
  (forall x, derivable_pt_lim y x (v x) /\ derivable_pt_lim v x (- c * v x - k * y x)) ->
  (y 0 = 0 -> v 0 = 1 -> y PI = - gamma /\ forall z w, (forall x, derivable_pt_lim z x (w x) /\ derivable_pt_lim w x
  (- c * w x - k * z x)) -> z 0 = 1 -> w 0 = 0 -> a1 = - z PI - v PI /\ a2 = z PI * v PI - y PI * w PI).
Proof.
  intros (A11 & A21 & A22 & -> & -> & F) y v Hf Y0 V0; destruct (F y v Hf) as [P Q]; rewrite Y0, V0 in *; cbn in P, Q.
  split; [lra|]; intros z w Hg Z0 W0; destruct (F z w Hg) as [P' Q']; rewrite Z0, W0 in *; cbn in P', Q'.
  replace (z PI) with (- A11) by lra; replace (w PI) with (- A21) by lra; replace (v PI) with (- A22) by lra.
  replace (y PI) with (- gamma) by lra; split; ring.
Qed.
Lemma restitution O m a1 a2 gamma : grazing O m a1 a2 gamma -> Oscillator.tau O >= 0. Proof. intros [_ T _ _]; lra. Qed.
Lemma touching_fields O : touching O -> forall mu t, let G := Oscillator.G O in let G1 := Oscillator.G1 O in
  (derivable_pt_lim (G mu) t (G1 mu t) /\ derivable_pt_lim (G1 mu) t (Oscillator.G2 O mu t)) /\
  G mu (t + 2 * PI) = G mu t /\ G mu 0 = 0 /\ (0 < t -> t < 2 * PI -> G 0 t > 0).
Proof.
  intros [P S B T L _ _] mu t; split; [split; [exact (S mu t) | exact (B mu t)]|]; split; [exact (P mu t)|].
  split; [exact (T mu) | intros H H'; exact (L t (conj H H'))].
Qed.
Lemma touching_means O : touching O -> (0 < Oscillator.G2 O 0 0 /\ continuity_pt (Oscillator.G2 O 0) 0) /\ exists K,
  forall mu t, - 1 <= mu <= 1 -> Rabs (Oscillator.G2 O mu t - Oscillator.G2 O 0 t) <= K * Rabs mu /\
  Rabs (Oscillator.G1 O mu t - Oscillator.G1 O 0 t) <= K * Rabs mu /\ Rabs (Oscillator.G O mu t - Oscillator.G O 0 t)
  <= K * Rabs mu.
Proof.
  intros T; destruct (sharp _ T) as [A B]; split; [split; [exact B | exact A]|]; destruct (steady _ T) as (K & H);
    exists K.
  intros mu t Hm; destruct (H mu t) as (X & Y & Z); [apply Rabs_le; lra | auto].
Qed.

(** d = 5/4, w = 1 and d = w = 1, tau = 1/2: (a1, a2) = (2 exp (-5 pi/2) cosh (3 pi/2), exp (-5 pi)), (2 exp
    (- 2 pi), exp (- 4 pi)). *)
Lemma overdamped : Nordmark_statement -> (exists gamma, 0 < gamma /\ grazing (Nordmark (5 / 4) 1 (1 / 2)) Plus
  (2 * exp (- 5 * PI / 2) * cosh (3 * PI / 2)) (exp (- 5 * PI)) gamma) /\ exists gamma, 0 < gamma /\
  grazing (Nordmark 1 1 (1 / 2)) Plus (2 * exp (- 2 * PI)) (exp (- 4 * PI)) gamma.
Proof.
  intros H; destruct (H (5 / 4) 1 (1 / 2) ltac:(lra) ltac:(lra)) as (_ & A & _), (H 1 1 (1 / 2) ltac:(lra) ltac:(lra))
    as (_ & _ & B & _).
  cbv zeta in *; split; [destruct (A ltac:(lra)) as (g & G & P) | destruct (B eq_refl) as (g & G & P)]; exists g; split;
    try exact P.
  - replace (sqrt ((5 / 4) ^ 2 - 1)) with (3 / 4) in G by (symmetry; apply sqrt_lem_1; lra).
    replace (- 2 * PI * (5 / 4) / 1) with (- 5 * PI / 2) in G by field; replace (- 4 * PI * (5 / 4) / 1) with (- 5 * PI)
      in G by field.
    replace (2 * PI * (3 / 4) / 1) with (3 * PI / 2) in G by field; exact G.
  - replace (- 2 * PI * 1 / 1) with (- 2 * PI) in G by field; replace (- 4 * PI * 1 / 1) with (- 4 * PI) in G by field;
      exact G.
Qed.
(** (65)-(67) word for word, and back: a motion is what they say, at mu = 1/8 say, one turn apart. *)
Lemma the_papers_words : Nordmark_statement -> forall d w tau h t y v, 0 < w -> 0 <= tau -> motion (Nordmark d w tau)
  Plus (- (1 / 8)) h (fun i => i) t y v -> let wall x := 9 / 8 * cos x - 1 in (forall x, derivable_pt_lim (y 0%Z) x
  (v 0%Z x) /\ derivable_pt_lim (v 0%Z) x (- (2 * d / w) * v 0%Z x - 1 / w ^ 2 * y 0%Z x)) /\ Rabs (t 0%Z) <= h /\
  t 0%Z < t 1%Z /\ y 0%Z (t 0%Z) = wall (t 0%Z) /\ y 0%Z (t 1%Z) = wall (t 1%Z) /\ (forall x, t 0%Z < x < t 1%Z ->
  y 0%Z x > wall x) /\ v 0%Z (t 1%Z) + 9 / 8 * sin (t 1%Z) < 0 /\ v 1%Z (t 1%Z) = - tau * v 0%Z (t 1%Z) - (1 + tau)
  * (9 / 8) * sin (t 1%Z).
Proof.
  intros H d w tau h t y v Hw Ht M wall; destruct (H d w tau Hw Ht) as (_ & _ & _ & E).
  destruct (proj1 (E (1 / 8) h (fun i => i) t y v) M 0%Z 1%Z eq_refl) as (F & A & L & Q0 & Q1 & W & V1 & V2);
    unfold wall.
  replace (1 + 1 / 8) with (9 / 8) in * by field; rewrite Rmult_0_r, Rminus_0_r in A; split; [exact F|].
  repeat (split; [lra|]); split; [exact W | split; lra].
Qed.

(** ** Patterns: (1, 2) on r = 1 at a1 = 1/2, for mu < 0 *)
Lemma pattern_1_2 : Patterns_statement -> Pattern_1_2_statement ->
  forall S gamma, grazes S (1 / 2) 1 gamma -> gamma > 0 -> exists d mu0, mu0 > 0 /\ forall mu, - mu0 < e_mu S mu < 0 ->
  one S mu d (fun i => if Z.even i then 1 else 2)%nat.
Proof.
  intros P [HP _] S gamma HG Hg; destruct (P S (1 / 2) 1 gamma HG 2%nat) as (d & Hd & W).
  destruct (W d ltac:(lra)) as (mu0 & Hm & W'); exists d, mu0; split; [exact Hm|]; intros mu Hmu.
  destruct (W' [1; 2]%nat Minus Plus mu) as [E _]; [discriminate | | cbn; lra | cbn; lra|].
  { repeat constructor; numbers. }
  specialize (E ltac:(apply HP; intuition lra)).
  assert (L : forall i, cyclic_letter [1; 2]%nat i = if Z.even i then 1%nat else 2%nat).
  { intros i; unfold cyclic_letter; cbn [length]; change (Z.of_nat 2) with 2%Z; rewrite Zeven_mod.
    pose proof (Z.mod_pos_bound i 2 ltac:(lia)); assert (i mod 2 = 0 \/ i mod 2 = 1)%Z as [-> | ->] by lia;
      reflexivity. }
  rewrite (functional_extensionality _ _ L : cyclic_letter [1; 2]%nat = _) in E; exact E.
Qed.

(** ** One impact per period *)
Lemma orbit_3_half_3 : orbit 3 (1 / 2) 3 Plus Plus.
Proof.
  replace 3 with (IZR 6 / IZR 2) by field; replace (1 / 2) with (IZR 1 / IZR 2) by field.
  apply orbitZ_orbit; reflexivity.
Qed.
Lemma Meaning_numbers : Meaning_statement -> exactly 3 (1 / 2) 3 Plus Plus /\
  never (IZR (-24) / IZR 20) (IZR 5 / IZR 20) 4.
Proof.
  intros M; split; [apply M; [lia | apply orbit_3_half_3]|]. apply M; [lia | apply no_orbitZ_no_orbit; reflexivity].
Qed.
Lemma trace_1_6 : trace 1 (1 / 6) = 1.
Proof. unfold trace; replace (2 * PI * (1 / 6)) with (PI / 3) by field; rewrite cos_PI3; field. Qed.

(** s = 1/6 on r = 1: 2 s < 1/2; 4 s < 1 and b_{4,3} = 2; 14 s = 7/3, and 2 and 14 are not prime. At s = 1/3,
    r = 1/2, 4 s > 1 and b_{4,1} = -7. *)
Lemma S1_S3_numbers : S1_S3_statement -> exactly 1 1 2 Minus Plus /\ exactly 1 1 4 Plus Plus /\ never 1 1 14 /\
  never (- 1 / 2) (1 / 4) 4 /\ forall r s (F : Farey 2 5), cell r s 5 2 -> let a1 := trace r s in let b :=
  b a1 (r ^ 2) 5 in (2 < 5 * s -> b (n_plus F) > 0 -> exactly a1 (r ^ 2) 5 Plus Minus) /\
  (5 * s < 2 -> b (n_minus F) < 0 -> never a1 (r ^ 2) 5).
Proof.
  intros S; pose proof (S 1 (1 / 6) 2%nat 0%nat ltac:(lia)) as A; pose proof (S 1 (1 / 6) 4%nat 1%nat ltac:(lia)) as B.
  pose proof (S 1 (1 / 6) 14%nat 2%nat ltac:(lia)) as C; pose proof (S (1 / 2) (1 / 3) 4%nat 1%nat ltac:(lia)) as D.
  assert (T : trace (1 / 2) (1 / 3) = - 1 / 2).
  { unfold trace; replace (2 * PI * (1 / 3)) with (PI - PI / 3) by field; rewrite Rtrigo_facts.cos_pi_minus, cos_PI3;
      field. }
  assert (G : forall m F, F = Build_Farey 1 4 0 1 1 3 m -> n_minus F = 3%nat /\ n_plus F = 1%nat) by (intros m F ->;
    auto).
  set (F4 := Build_Farey 1 4 0 1 1 3 ltac:(unfold neighbours; lia)); destruct (G _ F4 eq_refl) as [G1 G2].
  unfold cell in A, B, C, D; cbv zeta in *; rewrite trace_1_6, pow1 in A, B, C; rewrite T in D.
  replace ((1 / 2) ^ 2) with (1 / 4) in D by field; split; [|split; [|split; [|split]]].
  - apply A; [|reflexivity]; split; [lra|]; split; [lra|]; split; [numbers|]; apply Rabs_def1; simpl; lra.
  - destruct B as (_ & _ & B); [split; [lra|]; split; [lra|]; split; [numbers|]; apply Rabs_def1; simpl; lra|].
    destruct (B (le_n 1) F4) as [B' _]; rewrite G1 in B'; apply B'; [simpl; lra | numbers].
  - apply C; [| lia | discriminate]; split; [lra|]; split; [lra|]; split; [numbers|]; apply Rabs_def1; simpl; lra.
  - destruct D as (_ & _ & D); [split; [lra|]; split; [lra|]; split; [numbers|]; apply Rabs_def1; simpl; lra|].
    destruct (D (le_n 1) F4) as [_ D']; rewrite G2 in D'; apply D'; [simpl; lra | numbers].
  - intros r s F HC; destruct (S r s 5%nat 2%nat ltac:(lia) HC) as (_ & _ & E); destruct (E ltac:(lia) F) as [E1 E2].
    replace (INR 5) with 5 in * by (simpl; lra); replace (INR 2) with 2 in * by (simpl; lra); split; intros Hs Hb.
    + apply (E2 ltac:(lra)), Hb.
    + apply (E1 ltac:(lra)), Hb.
Qed.
(** What is listed, and that with no zeros nothing else is born. *)
Lemma Summary_systems_numbers : Summary_systems_statement -> forall S a1 a2 gamma, grazes S a1 a2 gamma ->
  0 < a2 <= 1 -> (a1 > a2 + 1 -> gamma > 0 -> born S 1 Plus /\ unborn S 1 Minus /\ born S 2 Plus /\ born S 9 Plus) /\
  (0 < a1 < a2 + 1 -> gamma > 0 -> born S 2 Minus) /\ (- (a2 + 1) < a1 < 0 -> gamma > 0 -> born S 2 Plus) /\
  (a1 < - (a2 + 1) -> gamma < 0 -> born S 2 Plus /\ born S 9 Plus) /\ (2 * sqrt a2 * cos (PI / INR 9) < a1 < a2 + 1 ->
  gamma > 0 -> born S 9 Minus) /\ (forall g, sgn g * gamma > 0 -> area3 a1 a2 9 g -> born S 9 Plus) /\
  (area4 a1 a2 9 -> gamma < 0 -> born S 9 Plus) /\ forall n e g, (2 <= n)%nat -> sgn g * gamma > 0 ->
  no_zeros a1 a2 n -> ~ listed a1 a2 n e g -> unborn S n e.
Proof.
  intros H S a1 a2 gamma HS H2; pose proof (fun n e g => H S a1 a2 gamma n e g HS H2) as X; clear H.
  assert (L : forall n e g, sgn g * gamma > 0 -> listed a1 a2 n e g -> born S n e) by (intros n e g Hg;
    apply (X n e g Hg)).
  split; [|split; [|split; [|split; [|split; [|split; [|split]]]]]].
  - intros Ha Hg; destruct (X 1%nat Plus Plus ltac:(cbn; lra)) as (A & _), (X 1%nat Minus Plus ltac:(cbn; lra))
      as (_ & B & _).
    split; [apply A; cbn; lra|]; split; [apply B; cbn; lra|].
    split; [apply (L 2%nat Plus Plus); [cbn; lra|]; left | apply (L 9%nat Plus Plus); [cbn; lra|]; right; split;
      [lia|]]; intuition lra.
  - intros Ha Hg; apply (L 2%nat Minus Plus); [cbn; lra|]; left; tauto.
  - intros Ha Hg; apply (L 2%nat Plus Plus); [cbn; lra|]; left; tauto.
  - intros Ha Hg; split; [apply (L 2%nat Plus Minus); [cbn; lra|]; left | apply (L 9%nat Plus Minus); [cbn; lra|];
      right; split; [lia|]]; tauto.
  - intros Ha Hg; apply (L 9%nat Minus Plus); [cbn; lra|]; right; split; [lia|]; tauto.
  - intros g Hg A; apply (L 9%nat Plus g Hg); right; split; [lia|]; tauto.
  - intros A Hg; apply (L 9%nat Plus Minus); [cbn; lra|]; right; split; [lia|]; tauto.
  - intros n e g Hn Hg Hz Hl; apply (X n e g Hg); assumption.
Qed.
Lemma listed_means a1 a2 n e g : listed a1 a2 n e g ->
  (n = 2%nat -> ((a2 + 1 < a1 /\ e = Plus \/ 0 < a1 < a2 + 1 /\ e = Minus \/ - (a2 + 1) < a1 < 0 /\ e = Plus) /\
  g = Plus) \/ a1 < - (a2 + 1) /\ e = Plus /\ g = Minus) /\ (n <> 2%nat -> (3 <= n)%nat /\
  (((a2 + 1 < a1 /\ e = Plus \/ 2 * sqrt a2 * cos (PI / INR n) < a1 < a2 + 1 /\ e = Minus) /\ g = Plus) \/ e = Plus /\
  (area3 a1 a2 n g \/ g = Minus /\ (area4 a1 a2 n \/ a1 < - (a2 + 1))))).
Proof. intros [[-> H]|[Hn H]]; (split; [intros E; try (exfalso; lia) | intros E; try contradiction]); tauto. Qed.
Lemma no_zeros_means a1 a2 n : no_zeros a1 a2 n -> u a1 a2 n <> 0 /\ c a1 a2 n <> 0 /\
  forall k, (0 < k < n)%nat -> b a1 a2 n k <> 0.
Proof. intros (A & B & C); split; [exact A | split; [exact B|]]; intros k Hk; apply C; lia. Qed.
(** On the circle, s = 1/6: f_1 = 1 and f_2 = 1/3, a record low; records of any n, and none. *)
Lemma Record_systems_numbers : Record_systems_statement -> exactly 1 1 2 Minus Plus /\ forall a1 a2 n, 0 < a2 <= 1 ->
  - (a2 + 1) < a1 < a2 + 1 -> (2 <= n)%nat -> (f a1 a2 n > 0 -> high a1 a2 n -> exactly a1 a2 n Plus Minus) /\
  (f a1 a2 n < 0 -> low a1 a2 n -> exactly a1 a2 n Plus Plus) /\ (~ high a1 a2 n /\ ~ low a1 a2 n /\ no_zeros a1 a2 n ->
  never a1 a2 n).
Proof.
  intros H; split; [destruct (H 1 1 2%nat) as (_ & _ & L & _); [lra | apply Rabs_def1; lra | lia |]; apply L;
    unfold low, f, u, v, u; [intros k Hk; replace k with 1%nat by lia|]; simpl; lra|].
  intros a1 a2 n H2 H1 Hn; destruct (H a1 a2 n H2 ltac:(apply Rabs_def1; lra) Hn) as (A & B & _ & D).
  split; [intros X Y; exact (A Y X)|]; split; [intros X Y; exact (B Y X) | intros (X & Y & Z); exact (D X Y Z)].
Qed.
(** Failing strictly, (52) or (53); born and unborn exclude each other; a pattern of which a step fails. *)
Lemma Single_numbers : Single_statement -> forall S a1 a2 gamma n e g, grazes S a1 a2 gamma -> (1 <= n)%nat ->
  u a1 a2 n <> 0 -> sgn g * gamma > 0 -> (sgn e * sgn g * c a1 a2 n < 0 -> unborn S n e) /\
  (forall k, (1 <= k <= n - 1)%nat -> sgn e * b a1 a2 n k < 0 -> unborn S n e) /\ (born S n e -> ~ unborn S n e).
Proof.
  intros H S a1 a2 gamma n e g HS Hn Hu Hg; destruct (H S a1 a2 gamma n e g HS Hn Hu Hg) as (_ & A & B).
  split; [intros Hc; apply A; right; exact Hc|]; split; [intros k Hk Hb; apply A; left; exists k; auto | intros X Y;
    apply B; auto].
Qed.
Lemma fails_means a1 a2 n e g : fails a1 a2 n e g -> sgn e * sgn g * c a1 a2 n >= 0 -> exists k, (0 < k < n)%nat /\
  sgn e * b a1 a2 n k < 0.
Proof. intros [(k & Hk & B)|B] N; [exists k; split; [lia | exact B] | lra]. Qed.
Lemma no_pattern_1_1 : Patterns_statement -> forall S gamma, grazes S 1 (1 / 4) gamma -> gamma < 0 ->
  exists d, d > 0 /\ forall eps, 0 < eps <= d -> exists mu0, mu0 > 0 /\ forall mu, - mu0 < e_mu S mu < 0 ->
  none S mu d (cyclic_letter [1; 1]%nat).
Proof.
  intros P S gamma HG Hg; destruct (P S 1 (1 / 4) gamma HG 1%nat) as (d & Hd & W); exists d; split; [exact Hd|];
    intros eps He.
  destruct (W eps He) as (mu0 & Hm & W'); exists mu0; split; [exact Hm|]; intros mu Hmu.
  apply (W' [1; 1]%nat Minus Minus mu); [discriminate | repeat constructor; numbers | cbn; lra | cbn; lra|].
  exists 0%Z; right; cbn; numbers.
Qed.
(** ** A stop with two harmonics, 1 - cos t and (1 - cos 2t)/8: its top is 0, its bend 1 + 4/8 *)
Lemma Harmonics_numbers : Harmonics_statement -> exists O, touching O /\ Oscillator.c O = 1 / 5 /\
  Oscillator.k O = 7 /\ Oscillator.tau O = 1 / 2 /\ Oscillator.G O 0 PI = 2.
Proof.
  intros H; destruct (H (1 / 5) 7 (1 / 2) [(1, 0); (1 / 8, 0)]) as (O & HT & Hc & Hk & Ht & G).
  - intros t Ht; cbn [harmonics]; replace (INR 1) with 1 by reflexivity; rewrite !Rmult_1_l.
    pose proof (COS_bound (INR 2 * t)).
    assert (cos t < 1).
    { pose proof (COS_bound t) as B; destruct (Req_dec (cos t) 1) as [E|E]; [|lra]; pose proof PI_RGT_0; exfalso.
      destruct (Rle_lt_dec t PI) as [L|L].
      - pose proof (cos_decreasing_1 0 t ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as D;
          rewrite cos_0 in D; lra.
      - pose proof (cos_increasing_1 t (2 * PI) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as D;
          rewrite cos_2PI in D; lra. }
    lra.
  - cbn; lra.
  - exists O; split; [exact HT|]; split; [exact Hc|]; split; [exact Hk|]; split; [exact Ht|].
    rewrite G; cbn [harmonics].
    replace (INR 1 * PI) with PI by (simpl; ring); replace (INR 2 * PI) with (2 * PI) by (simpl; ring); rewrite cos_PI,
      sin_PI, cos_2PI, sin_2PI; field.
Qed.

(** ** One impact in n turns, for every mu: a1 = 0, a2 = 1 again, b_{5,1} = 0 and c_5 = -2, gap and speed by hand *)
Lemma none_every_fifth : Nordmark_statement -> Every_mu_statement -> forall mu d t y v,
  ~ StatementResonance.once (Nordmark 0 4 0) 5 mu d t y v.
Proof.
  intros HN HE mu d t y v [HM HA]; destruct (undamped HN) as (gamma & [_ _ HG _] & _).
  destruct (HA 1%Z (t 0%Z)) as (T1 & _ & V1); cbv zeta in *; rewrite Rmult_1_r in *.
  assert (U5 : u 0 1 5 <> 0) by numbers; assert (C5 : Defs.c 0 1 5 <> 0) by numbers.
  refine (HE _ Plus 0 1 gamma 5%nat HG ltac:(cbn; lra) U5 C5 1%nat ltac:(lia) ltac:(right; replace (b 0 1 5 1) with 0 by
    numbers; ring) mu d _ t y v 0%Z (Build_comes_again _ _ _ _ _ _ _ _ _ _ (HM 0%Z 1%Z eq_refl) _ T1 _)); [lia|].
  cbn [facing]; change (0 + 1)%Z with 1%Z; rewrite Rmult_1_l, T1; exact V1.
Qed.
Lemma higher_by O m gamma mu d N t y v i : Gap_statement -> matrix (Oscillator.c O) (Oscillator.k O) m 0 1 gamma ->
  Oscillator.tau O = 1 / 2 -> comes_again O m 3 mu d N t y v i ->
  speed O m mu (N i + 3) (v i) (t i + turn m * 3) = -8 ->
  gap O m mu (N i + 1) (y i) (t i + turn m) = 12 * gamma /\ t (i + 1)%Z = t i + turn m * 3 /\
  facing m 3 * v (i + 1)%Z (t (i + 1)%Z) = v i (t i) /\ gap O m mu (N i + 3) (y i) (t i + turn m * 3) = 0.
Proof.
  intros HG HM Ht H Hs; assert (U3 : u 0 1 3 <> 0) by numbers.
  pose proof (HG _ _ _ _ _ _ _ _ _ _ _ _ i HM U3 H) as E; destruct H as [W N1 P V].
  replace (INR 3) with 3 in * by (cbn; lra); change (Z.of_nat 3) with 3%Z in *; cbv zeta in E.
  rewrite N1, P, Hs, Ht in E; split; [specialize (E 1%nat ltac:(lia)) | split; [exact P | split; [exact V | specialize (E
    3%nat ltac:(lia))]]].
  - cbn [INR] in E; rewrite Rmult_1_r in E; change (Z.of_nat 1) with 1%Z in E.
    replace (Defs.c 0 1 3) with 2 in E by numbers; replace (b 0 1 3 1) with 2 in E by numbers; lra.
  - replace (INR 3) with 3 in E by (cbn; lra); change (Z.of_nat 3) with 3%Z in E.
    replace (Defs.c 0 1 3) with 2 in E by numbers; replace (b 0 1 3 3) with 0 in E by numbers; lra.
Qed.
