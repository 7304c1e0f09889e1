(** * Proof of S1-S5, Theorem 2, Conjecture 1, the summary, the record form, patterns and words for oscillators *)
From Coq Require Import Reals ZArith List Lra Lia.
From Grazing Require Import Defs StatementAffine StatementOrbitsPlane StatementOrbitsAreas StatementWords
  StatementOrbitsPatterns StatementOscillator StatementOscillatorOrbits Derivatives Flow PlaneOrbits OrbitsAreas
  PatternOrbits WordAlgebra WordPath WordGraph WordPatterns WordPlane WordOrbits OscillatorTurns OscillatorUses Oscillators.
Import ListNotations.
Open Scope R_scope.

Lemma every_next n i : every n (i + 1) = (every n i + Z.of_nat n)%Z.
Proof. unfold every; ring. Qed.

Theorem Single_oscillator : Single_oscillator_statement.
Proof.
  intros O m a1 a2 gamma n s g HO Hn Hu Hg; destruct (Word_oscillator O m a1 a2 gamma HO n)
    as (d & mu0 & K & Hd & Hm & W).
  assert (W' := fun mu Hmu => W (every n) (fun _ => n) s g mu
    (fun i => conj (every_next n i) (conj (conj Hn (le_n n)) Hu)) Hg Hmu); clear W; split;
      [intros (_ & Hb & Hc)|intros Hf].
  - exists d, mu0, K; split; [exact Hd|]; split; [exact Hm|]; intros mu Hmu; destruct (W' mu Hmu) as (E & _ & B).
    assert (One : one_motion O m mu d (every n)) by (apply E; intros _; rewrite follows_itself by assumption; auto).
    split; [exact One|]; intros t q v HM i x; split; [apply (B t q v HM)|].
    destruct (Periodic_oscillator O m mu d (every n) t q v 1%Z (Z.of_nat n) (is_touching _ _ _ _ _ HO)
      One HM (every_next n) i x)
      as (P1 & P2 & _); rewrite <- INR_IZR_INZ in P1, P2; auto.
  - exists d, mu0; split; [exact Hd|]; split; [exact Hm|]; intros mu t q v Hmu.
    destruct (W' mu Hmu) as (_ & F & _); apply (F 0%Z); rewrite follows_itself by assumption; exact Hf.
Qed.

Lemma orbit_exactly a1 a2 n s g : (2 <= n)%nat -> orbit a1 a2 n s g -> exactly_oscillator a1 a2 n s g.
Proof.
  intros Hn Ho O m gamma HO; pose proof Ho as (Hu & Hb & Hc); split.
  - intros Hg; apply (Single_oscillator O m a1 a2 gamma n s g HO ltac:(lia) Hu Hg), Ho.
  - intros s' Hne; destruct (sign_of gamma (is_generic _ _ _ _ _ HO)) as [g' Hg'].
    apply (Single_oscillator O m a1 a2 gamma n s' g' HO ltac:(lia) Hu Hg'); specialize (Hb 1%nat ltac:(lia)).
    destruct s, s'; try (left; exists 1%nat; split; [lia | cbn [sgn] in *; lra]);
      right; destruct g, g'; cbn [sgn] in *; try lra; exfalso; apply Hne; split; trivial; lra.
Qed.
Lemma no_orbit_none a1 a2 n : (2 <= n)%nat -> no_orbit a1 a2 n -> none_oscillator a1 a2 n.
Proof.
  intros Hn (Hu & k & k' & Hk & Hk' & Hb & Hb') O m gamma s HO;
    destruct (sign_of gamma (is_generic _ _ _ _ _ HO)) as [g Hg].
  apply (Single_oscillator O m a1 a2 gamma n s g HO ltac:(lia) Hu Hg); left.
  destruct s; [exists k | exists k']; split; trivial; cbn [sgn]; lra.
Qed.
Lemma all_fail_none a1 a2 n : (2 <= n)%nat -> u a1 a2 n <> 0 -> (forall s g,
  fails a1 a2 n s g) -> none_oscillator a1 a2 n.
Proof.
  intros Hn Hu Hf O m gamma s HO; destruct (sign_of gamma (is_generic _ _ _ _ _ HO)) as [g Hg].
  apply (Single_oscillator O m a1 a2 gamma n s g HO ltac:(lia) Hu Hg), Hf.
Qed.

Theorem S1_S3_oscillator : S1_S3_oscillator_statement.
Proof. exact (S1_S3_for _ _ orbit_exactly no_orbit_none). Qed.
Theorem Theorem2_oscillator : Theorem2_oscillator_statement.
Proof. exact (Theorem2_for _ _ orbit_exactly no_orbit_none). Qed.
Theorem Conjecture1_oscillator : Conjecture1_oscillator_statement.
Proof. exact (Conjecture1_for _ _ orbit_exactly no_orbit_none). Qed.
Theorem Record_oscillator : Record_oscillator_statement.
Proof. exact (Record_for _ _ orbit_exactly all_fail_none). Qed.
Theorem Summary_oscillator : Summary_oscillator_statement.
Proof.
  apply Summary_for.
  - intros a1 a2 n s g H Hn O m gamma HO Hg; apply (Single_oscillator O m a1 a2 gamma n s g HO Hn (proj1 H) Hg), H.
  - intros a1 a2 n s g Hu H Hn O m gamma HO Hg; apply (Single_oscillator O m a1 a2 gamma n s g HO Hn Hu Hg), H.
Qed.

(** ** Patterns and words *)
Lemma cyclic_places l i : l <> [] -> exists j : StatementOrbitsPatterns.place l,
  steps l j = cyclic_letter l i /\ steps l (next_place l j) = cyclic_letter l (i + 1).
Proof.
  intros Hl; assert (L : (0 < length l)%nat) by (destruct l; [contradiction | cbn; lia]).
  pose proof (Z.mod_pos_bound i (Z.of_nat (length l)) ltac:(lia)) as B.
  assert (H : (Z.to_nat (i mod Z.of_nat (length l)) < length l)%nat) by lia;
    exists (exist (fun k => (k < length l)%nat) _ H); split; [reflexivity|].
  unfold steps; rewrite proj_next; cbn [proj1_sig]; unfold cyclic_letter; f_equal.
  apply Nat2Z.inj; rewrite Nat2Z.inj_mod, Nat2Z.inj_succ, !Z2Nat.id; try lia; [|apply Z.mod_pos_bound; lia].
  unfold Z.succ; apply Zplus_mod_idemp_l.
Qed.

Theorem Patterns_oscillator : Patterns_oscillator_statement.
Proof.
  intros O m a1 a2 gamma HO n_max; destruct (Word_oscillator O m a1 a2 gamma HO n_max) as (d & mu0 & K & Hd & Hm & W).
  exists d, mu0; split; [exact Hd|]; split; [exact Hm|]; intros l N s g mu Hl Hall HN Hg Hmu [Hv Hc].
  rewrite Forall_forall in Hall, Hv.
  assert (Hin : forall i, In (cyclic_letter l i) l).
  { intros i; destruct (cyclic_places l i Hl) as ([j Hj] & E & _); rewrite <- E; apply nth_In, Hj. }
  apply (W N (cyclic_letter l) s g mu); trivial; [intros i; split; [apply HN | apply Hall, Hin]|].
  intros i; split; [apply (Hv _ (Hin i))|]; destruct (cyclic_places l i Hl) as (j & E & E'); rewrite <- E, <- E'.
  exact (cyclic_nth _ l j Hc).
Qed.

Theorem All_patterns_oscillator : All_patterns_oscillator_statement.
Proof.
  intros O m a1 a2 gamma K HO HK H2; destruct (V_bounded a1 a2 K HK H2) as [L HL].
  destruct (Patterns_oscillator O m a1 a2 gamma HO L) as (d & mu0 & Hd & Hm & H); exists d, mu0; split; [exact Hd|].
  split; [exact Hm|]; intros l N g mu Hl HN Hg Hmu Hp.
  apply (H l N Plus g mu Hl (pattern_letters a1 a2 Plus g l L HL Hp) HN Hg); [cbn [sgn]; lra | exact Hp].
Qed.

Theorem Shift_oscillator : Shift_oscillator_statement.
Proof.
  intros O m a1 a2 gamma HO H2 n_max; destruct (Word_oscillator O m a1 a2 gamma HO n_max)
    as (d & mu0 & K & Hd & Hm & W).
  exists d, mu0; split; [exact Hd|]; split; [exact Hm|]; intros N n s g mu Hn Hg Hmu; apply (W N n s g mu); trivial.
  - intros i; destruct (Hn i) as (HN & Hle & Hu & _); pose proof (u_nonzero_pos _ _ _ Hu); tauto.
  - intros i; split; [apply (Hn i) | apply (full_shift a1 a2 s H2 g); apply Hn].
Qed.

Theorem Graph_oscillator : Graph_oscillator_statement.
Proof.
  intros O m a1 a2 gamma HO K w i j HK Hp HV He; pose proof (decided_everywhere _ _ _ HK) as Hdec.
  assert (HV' : forall x, In x (vertices K w) -> member a1 a2 Plus (fst x)) by (apply Forall_forall; assumption).
  destruct (Word_oscillator O m a1 a2 gamma HO (i + j)%nat) as (d & mu0 & C & Hd & Hm & W).
  exists d, mu0; split; [exact Hd|]; split; [exact Hm|]; intros N n g mu Hn Hg Hmu.
  assert (HE : forall k, edge a1 a2 Plus (if arrow K w (n k) (n (k + 1)%Z) then Plus else Minus) (fst (n k))
    (fst (n (k + 1)%Z))).
  { intros k; apply (word_edges a1 a2 K HK Hdec w i j Hp HV); [apply Hn..|left; exact He]. }
  destruct (W N (fun k => fst (n k)) Plus g mu) as (Hex & Hno & _); trivial; [|cbn [sgn]; lra|split].
  - intros k; destruct (HV' _ (proj2 (Hn k))) as [Hu _]; pose proof (u_nonzero_pos _ _ _ Hu).
    pose proof (vertex_bound a1 a2 K w i j HK Hp _ (proj2 (Hn k))); destruct (Hn k); tauto.
  - intros Hwalk; apply Hex; intros k; split; [apply (HV' _ (proj2 (Hn k)))|].
    specialize (HE k); rewrite Hwalk in HE; exact HE.
  - intros k Hne; apply (Hno k); right; specialize (HE k); unfold edge in HE; unfold follows.
    unfold p, q in HE; destruct (arrow K w (n k) (n (k + 1)%Z)), g; cbn [sgn] in *; tauto || lra.
Qed.

(** ** The paper's oscillator, and stops with any harmonics *)
Lemma cos_below t : 0 < t < 2 * PI -> cos t < 1.
Proof.
  intros Ht; pose proof (COS_bound t) as B; destruct (Req_dec (cos t) 1) as [E|E]; [|lra].
  exfalso; pose proof PI_RGT_0; destruct (Rle_lt_dec t PI) as [L|L].
  - pose proof (cos_decreasing_1 0 t ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as D;
      rewrite cos_0 in D; lra.
  - pose proof (cos_increasing_1 t (2 * PI) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as D.
    rewrite cos_2PI in D; lra.
Qed.

Lemma whole_periods z t : cos (t - 2 * PI * IZR z) = cos t /\ sin (t - 2 * PI * IZR z) = sin t.
Proof.
  assert (P : forall k y, cos (y + 2 * PI * INR k) = cos y /\ sin (y + 2 * PI * INR k) = sin y).
  { intros k y; rewrite <- (cos_period y k), <- (sin_period y k); split; f_equal; ring. }
  destruct (Z_le_gt_dec 0 z) as [L|L].
  - destruct (P (Z.to_nat z) (t - 2 * PI * IZR z)) as [<- <-]; rewrite INR_IZR_INZ, Z2Nat.id by lia; split;
      f_equal; ring.
  - destruct (P (Z.to_nat (- z)) t) as [<- <-]; rewrite INR_IZR_INZ, Z2Nat.id, opp_IZR by lia; split; f_equal; ring.
Qed.

Lemma Nordmark_touching d w tau : touching (Nordmark d w tau).
Proof.
  constructor; cbn.
  - intros mu t; destruct (whole_periods (-1) t) as [E _]; replace (t + 2 * PI) with (t - 2 * PI * -1) by ring;
      rewrite E; reflexivity.
  - intros mu t; derive_by fail; ring.
  - intros mu t; derive_by fail; ring.
  - intros mu; rewrite cos_0; ring.
  - intros t Ht; pose proof (cos_below t Ht); lra.
  - rewrite cos_0, Rminus_0_r, Rmult_1_r; split; [|lra].
    apply (D_continuous _ (0 * cos 0 + 1 * (- sin 0 * 1))); derive_by fail; reflexivity.
  - exists 2; intros mu t _; pose proof (COS_bound t); pose proof (SIN_bound t); pose proof (Rabs_pos mu).
    assert (X : forall x, -2 <= x <= 2 -> Rabs ((1 - mu) * x - (1 - 0) * x) <= 2 * Rabs mu).
    { intros x Hx; replace (_ - _) with (- x * mu) by ring; rewrite Rabs_mult; apply Rmult_le_compat_r; [lra|].
      apply Rabs_le; lra. }
    repeat split; apply X; lra.
Qed.

Theorem Nordmark_oscillator : Nordmark_statement.
Proof.
  intros d w tau Hw Ht; split.
  - intros sigma Hd Hd0 Es Hs; assert (P : 0 < 1 - d ^ 2).
    { assert (d * d < 1 * 1) by (destruct Hd0 as [Hd0|<-]; [apply Rmult_gt_0_lt_compat|]; lra); lra. }
    pose proof (sqrt_lt_R0 _ P) as Hq; pose proof (sqrt_sqrt (1 - d ^ 2) ltac:(lra)) as Eq; set (r := sqrt _) in *.
    assert (Ps : 0 < sigma) by (rewrite Es; apply Rdiv_lt_0_compat; lra).
    pose proof (matrix_damped (2 * d / w) _ Plus _ _ (undamped_circular sigma ltac:(lra))) as M; cbv zeta in M;
      cbn [turn side] in M.
    replace (2 * d / w * (2 * d / w) / 4 + sigma * sigma) with (1 / w ^ 2) in M.
    2: { rewrite Es; replace (r / w * (r / w)) with (r * r / w ^ 2) by (field; lra); rewrite Eq; field; lra. }
    replace (- (2 * d / w) / 2 * (2 * PI)) with (- 2 * PI * d / w) in M by (field; lra).
    replace (sigma * (2 * PI)) with (2 * PI * sigma) in M by ring; set (E := exp (- 2 * PI * d / w)) in *.
    assert (PE : 0 < E) by apply exp_pos; set (si := sin (2 * PI * sigma)) in *.
    exists (E * (1 * (/ sigma * si))); split.
    + constructor; [apply Nordmark_touching | exact Ht | | ].
      * cbn [Nordmark Oscillator.c Oscillator.k]; replace (exp (- 4 * PI * d / w)) with (E * E).
        2: { unfold E; rewrite <- exp_plus; f_equal; field; lra. }
        rewrite <- (Rmult_1_l (cos _)); exact M.
      * rewrite Rmult_1_l; repeat apply Rmult_integral_contrapositive_currified; trivial;
          [lra | apply Rinv_neq_0_compat; lra].
    + replace (E * (1 * (/ sigma * si)) * si) with (E * / sigma * (si * si)) by ring.
      apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [exact PE | apply Rinv_0_lt_compat, Ps]|].
      destruct (Rtotal_order si 0) as [?|[?|?]]; [replace (si * si) with (- si * - si) by ring | contradiction|];
        apply Rmult_lt_0_compat; lra.
  - intros mu r N t q v; unfold motion, gap, speed, free;
      cbn [Nordmark Oscillator.c Oscillator.k Oscillator.G Oscillator.G1
      Oscillator.tau turn side].
    assert (E : forall z x f, 1 * f + - mu + (1 - - mu) * (1 - cos (x - 2 * PI * IZR z)) = f - ((1 + mu) * cos x - 1))
      by (intros; rewrite (proj1 (whole_periods _ _)); ring).
    assert (F : forall z x f, 1 * f + (1 - - mu) * sin (x - 2 * PI * IZR z) = f + (1 + mu) * sin x)
      by (intros; rewrite (proj2 (whole_periods _ _)); ring).
    split; intros H i j Hj; destruct (H i j Hj) as (H1 & H2 & H3 & H4 & H5 & H6 & H7 & H8).
    + rewrite E in H4, H5; rewrite F in H7; rewrite !F in H8; split; [exact H1|]; split; [exact H2|]; split;
        [exact H3|].
      split; [lra|]; split; [lra|]; split; [intros x Hx; specialize (H6 0%Z x Hx); rewrite E in H6; lra | split; lra].
    + repeat (split; [assumption|]); rewrite !E, !F; split; [lra|]; split; [lra|].
      split; [intros z x Hx; rewrite E; specialize (H6 x Hx); lra | split; lra].
Qed.

Fixpoint harmonics1 (j : nat) (l : list (R * R)) (t : R) : R := match l with [] => 0
  | (a, b) :: l => INR j * (a * sin (INR j * t) + b * cos (INR j * t)) + harmonics1 (S j) l t end.
Fixpoint harmonics2 (j : nat) (l : list (R * R)) (t : R) : R := match l with [] => 0
  | (a, b) :: l => INR j ^ 2 * (a * cos (INR j * t) - b * sin (INR j * t)) + harmonics2 (S j) l t end.
Fixpoint harmonics3 (j : nat) (l : list (R * R)) (t : R) : R := match l with [] => 0
  | (a, b) :: l => - INR j ^ 3 * (a * sin (INR j * t) + b * cos (INR j * t)) + harmonics3 (S j) l t end.

Lemma D_harmonics l : forall j t, derivable_pt_lim (harmonics j l) t (harmonics1 j l t) /\
  derivable_pt_lim (harmonics1 j l) t (harmonics2 j l t) /\ derivable_pt_lim (harmonics2 j l) t (harmonics3 j l t).
Proof.
  induction l as [|[a b] l IH]; intros j t; [split; [|split]; exact (D_const 0 t)|];
    destruct (IH (S j) t) as (H1 & H2 & H3).
  split; [|split]; cbn [harmonics harmonics1 harmonics2 harmonics3];
    derive_by ltac:(first [exact H1 | exact H2 | exact H3]); ring.
Qed.

Lemma harmonics_period l : forall j t, harmonics j l (t + 2 * PI) = harmonics j l t.
Proof.
  induction l as [|[a b] l IH]; intros j t; [reflexivity|]; cbn [harmonics]; rewrite IH.
  destruct (whole_periods (- Z.of_nat j) (INR j * t)) as [C D]; rewrite opp_IZR, <- INR_IZR_INZ in C, D.
  replace (INR j * (t + 2 * PI)) with (INR j * t - 2 * PI * - INR j) by ring; rewrite C, D; reflexivity.
Qed.

Lemma harmonics_0 l : forall j, harmonics j l 0 = 0 /\ harmonics2 j l 0 = weighted j l.
Proof.
  induction l as [|[a b] l IH]; intros j; [split; reflexivity|]; destruct (IH (S j)) as [E F].
  cbn [harmonics harmonics2 weighted]; rewrite E, F, Rmult_0_r, cos_0, sin_0; split; ring.
Qed.

Theorem Harmonics : Harmonics_statement.
Proof.
  intros c k tau l Hlow Hw; exists {| Oscillator.c := c; Oscillator.k := k; Oscillator.tau := tau;
    Oscillator.G := fun _ => harmonics 1 l; Oscillator.G1 := fun _ => harmonics1 1 l;
      Oscillator.G2 := fun _ => harmonics2 1 l |}.
  split; [|auto]; constructor; cbn; intros.
  - apply harmonics_period.
  - apply D_harmonics.
  - apply D_harmonics.
  - apply harmonics_0.
  - apply Hlow; assumption.
  - split; [apply (D_continuous _ (harmonics3 1 l 0)), D_harmonics | rewrite (proj2 (harmonics_0 l 1)); exact Hw].
  - exists 0; intros; rewrite !Rminus_eq_0, Rabs_R0; lra.
Qed.
