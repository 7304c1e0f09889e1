(** * Numbers worked out by hand that follow from the statements about oscillators: an undamped one with a restitution
      of 0, words in two letters, two stops, and which (a1, a2) have one *)
From Coq Require Import Reals ZArith List Lra Lia.
From Grazing Require Import Defs StatementAffine StatementOrbitsPlane StatementOrbitsAreas StatementOscillator
  StatementOscillatorOrbits StatementWords.
Import ListNotations.
Open Scope R_scope.

(** ** d = 0, w = 4: a1 = 0, a2 = 1; u = 0, 1, 0, -1, b_{3,1} = b_{3,2} = c_3 = 2: period 3 in (+,+) *)
Lemma orbit_0_1_3 : orbit 0 1 3 Plus Plus.
Proof.
  split; [|split]; [unfold u; simpl; lra | | unfold c, v, u; simpl; lra].
  intros k Hk; assert (k = 1 \/ k = 2)%nat as [->| ->] by lia; unfold b, u; simpl; lra.
Qed.

(** The equations as in the paper: for small mu < 0 a ball that does not bounce, tau = 0, touches every third period. *)
Lemma period_3_without_bounce : Nordmark_statement -> Single_oscillator_statement -> exists mu0 r, 0 < mu0 /\
  forall mu, - mu0 < mu < 0 -> exists t q v, t 1%Z = t 0%Z + 2 * PI * 3 /\ q 0%Z (t 0%Z) = (1 + mu) * cos (t 0%Z) - 1 /\
  Rabs (t 0%Z) <= r * Rabs mu /\ v 1%Z (t 1%Z) = - ((1 + mu) * sin (t 1%Z)) /\
  (forall x, t 0%Z < x < t 1%Z -> q 0%Z x > (1 + mu) * cos x - 1) /\
  forall x, derivable_pt_lim (v 0%Z) x (- (1 / 16) * q 0%Z x).
Proof.
  intros HN HS; pose proof PI_RGT_0; destruct (HN 0 4 0 ltac:(lra) ltac:(lra)) as [G E].
  destruct (G (1 / 4)) as (gamma & HG & Hg); [lra | lra | | |].
  { replace (1 - 0 ^ 2) with 1 by ring; rewrite sqrt_1; field. }
  { replace (2 * PI * (1 / 4)) with (PI / 2) by field; rewrite sin_PI2; lra. }
  replace (2 * PI * (1 / 4)) with (PI / 2) in HG, Hg by field; rewrite sin_PI2 in Hg; rewrite cos_PI2 in HG.
  replace (-4 * PI * 0 / 4) with 0 in HG by field; rewrite exp_0, Rmult_0_r in HG.
  destruct (HS _ Plus 0 1 gamma 3%nat Plus Plus HG) as [B _]; [lia | unfold u; simpl; lra | cbn; lra|].
  destruct (B orbit_0_1_3) as (d & mu0 & K & Hd & Hm & P); exists mu0, K; split; [exact Hm|]; intros mu Hmu.
  destruct (P (- mu)) as ((t & q & v & HM & _) & Q); [cbn; lra|].
  exists t, q, v; destruct (Q t q v HM 0%Z 0) as (Q1 & Q2 & _); pose proof (proj1 (E mu d (every 3) t q v) HM) as HL; clear HM; rename HL into HM.
  destruct (HM 0%Z 1%Z eq_refl) as (F & _ & _ & H1 & _ & H2 & _ & H3).
  change (0 + 1)%Z with 1%Z in Q2; cbn [turn] in Q2; replace (INR 3) with 3 in Q2 by (simpl; lra).
  unfold every in Q1; rewrite Z.mul_0_l, Rmult_0_r, Rminus_0_r, Rabs_Ropp in Q1.
  split; [exact Q2|]; split; [exact H1|]; split; [exact Q1|]; split; [lra|]; split; [exact H2|].
  intros x; destruct (F x) as [_ D]; replace (- (1 / 16) * q 0%Z x) with (- (2 * 0 / 4) * v 0%Z x - 1 / 4 ^ 2 * q 0%Z x) by field; exact D.
Qed.

(** ** (a1, a2) = (1, 1/4), region 2: u = 0, 1, 1, 3/4. Every word over {1, 2} in (-,+): b_{2,1} = -1/4, all of
    (64) are negative: -3/4 + ... by hand p = 0, -1/4, q = 1/4, 5/16. *)
Lemma words_in_two_letters : Word_oscillator_statement -> forall O m gamma, grazing O m 1 (1 / 4) gamma -> gamma > 0 ->
  exists d mu0, d > 0 /\ mu0 > 0 /\ forall N mu, - mu0 < mu < 0 ->
  (forall i, N (i + 1)%Z = (N i + 1)%Z \/ N (i + 1)%Z = (N i + 2)%Z) ->
  exists t q v, motion O m mu d N t q v /\ forall t' q' v', motion O m mu d N t' q' v' -> forall i, t' i = t i.
Proof.
  intros H O m gamma HG Hg; destruct (H O m 1 (1 / 4) gamma HG 2%nat) as (d & mu0 & K & Hd & Hm & W).
  exists d, mu0; split; [exact Hd|]; split; [exact Hm|]; intros N mu Hmu HN.
  set (n i := Z.to_nat (N (i + 1) - N i)%Z).
  assert (Hn : forall i, (n i = 1 \/ n i = 2)%nat) by (intros i; unfold n; destruct (HN i); [left | right]; lia).
  destruct (W N n Minus Plus mu) as (E & _); [| cbn; lra | cbn; lra|].
  { intros i; split; [unfold n; destruct (HN i); lia|]; destruct (Hn i) as [-> | ->]; split; try lia; unfold u; simpl; lra. }
  destruct E as (t & q & v & M & U); [|exists t, q, v; split; [exact M | intros t' q' v' M' i; apply (U t' q' v' M' i 0)]].
  intros i; split.
  - intros j Hj; destruct (Hn i) as [E| E]; rewrite E in *; [lia|]; replace j with 1%nat by lia; unfold b, u; simpl; lra.
  - destruct (Hn i) as [-> | ->], (Hn (i + 1)%Z) as [-> | ->]; unfold follows, u; simpl; lra.
Qed.

(** ** (-6/5, 1/4), region 4: period 3 in (+,-) alone, no period 4; not with one stop, but with two *)
Lemma region_4 : Conjecture1_oscillator_statement -> Reach_statement -> forall O m gamma, grazing O m (-6 / 5) (1 / 4) gamma ->
  (gamma < 0 -> bounces O m 3 Plus) /\ not_bounces O m 3 Minus /\ not_bounces O m 4 Plus /\ m = Minus /\
  exists c k g, matrix c k Minus (-6 / 5) (1 / 4) g.
Proof.
  intros C R O m gamma HG; assert (E4 : sqrt (1 / 4) = 1 / 2).
  { replace (1 / 4) with (1 / 2 * (1 / 2)) by field; apply sqrt_square; lra. }
  destruct (C 3%nat ltac:(lia)) as (_ & _ & _ & A); destruct (A (-6 / 5) (1 / 4)) as [_ O3]; try (rewrite ?E4; lra).
  destruct (O3 ltac:(exists 1%nat; reflexivity)) as [D _].
  destruct (D ltac:(unfold b, u; simpl; lra) O m gamma HG) as [D1 D2].
  destruct (C 4%nat ltac:(lia)) as (_ & _ & _ & A'); destruct (A' (-6 / 5) (1 / 4)) as [E _]; try (rewrite ?E4; lra).
  split; [intros Hg; apply D1; cbn; lra|]; split; [apply D2; intros [F _]; discriminate F|].
  split; [apply (E ltac:(exists 2%nat; reflexivity) O m gamma Plus HG)|].
  destruct R as (_ & _ & _ & R4 & R5); split.
  - destruct m; [|reflexivity]; destruct (R4 _ _ _ _ _ (is_matrix _ _ _ _ _ HG) (is_generic _ _ _ _ _ HG)) as (_ & X & _).
    rewrite E4 in X; lra.
  - destruct (R5 (-6 / 5) (1 / 4)) as (c & k & g & X & _); [lra | rewrite E4; lra | exists c, k, g; exact X].
Qed.

(** ** Both signs of gamma at s = 1/6 on the circle; gamma > 0 at (3, 1/2) *)
Lemma reached : Reach_statement -> (exists c k gamma, matrix c k Plus (2 * 1 * cos (2 * PI * (1 / 6))) (1 ^ 2) gamma /\ gamma < 0) /\
  forall c k gamma, matrix c k Plus 3 (1 / 2) gamma -> gamma <> 0 -> gamma > 0.
Proof.
  intros (_ & R2 & _ & R4 & _); split.
  - destruct (R2 1 (1 / 6) Minus ltac:(lra) ltac:(lra)) as (c & k & gamma & M & G); exists c, k, gamma; split; [exact M | cbn in G; lra].
  - intros c k gamma M G; apply (R4 c k 3 (1 / 2) gamma M G).
    pose proof (sqrt_le_1 (1 / 2) 1 ltac:(lra) ltac:(lra) ltac:(lra)) as X; rewrite sqrt_1 in X; lra.
Qed.

(** ** A periodic word between two stops, one half turn on: the motion is its own mirror image *)
Lemma mirrored : Periodic_oscillator_statement -> forall O mu d t q v, touching O -> one_motion O Minus mu d (fun i => i) ->
  motion O Minus mu d (fun i => i) t q v -> t 1%Z = t 0%Z + PI /\ forall x, q 1%Z (x + PI) = - q 0%Z x.
Proof.
  intros P O mu d t q v HO H1 HM; assert (Q := P O Minus mu d (fun i => i) t q v 1%Z 1%Z HO H1 HM ltac:(intros; reflexivity)).
  split; [destruct (Q 0%Z 0) as [A _]; cbn in A; lra|]; intros x; destruct (Q 0%Z x) as (_ & A & _); cbn in A.
  rewrite Rmult_1_r in A; lra.
Qed.

(** ** The pattern (1, 2) on r = 1 at a1 = 1/2 is a motion for mu < 0, and its word over all of Z is one of W1's *)
Lemma pattern_1_2 : Patterns_oscillator_statement -> (forall e g, pattern (1 / 2) 1 e g [1; 2]%nat <-> e = Minus /\ g = Plus) ->
  forall O m gamma, grazing O m (1 / 2) 1 gamma -> gamma > 0 -> exists d mu0, mu0 > 0 /\ forall mu N, - mu0 < mu < 0 ->
  (forall i, N (2 * i)%Z = (3 * i)%Z /\ N (2 * i + 1)%Z = (3 * i + 1)%Z) -> one_motion O m mu d N.
Proof.
  intros P HP O m gamma HG Hg; destruct (P O m (1 / 2) 1 gamma HG 2%nat) as (d & mu0 & _ & Hm & W).
  exists d, mu0; split; [exact Hm|]; intros mu N Hmu HN; apply (W [1; 2]%nat N Minus Plus mu); try (cbn; lra); [discriminate | | |].
  - repeat constructor; unfold u; simpl; lra.
  - intros i; unfold cyclic_letter; cbn [length]; change (Z.of_nat 2) with 2%Z.
    destruct (Z.Even_or_Odd i) as [[j ->]|[j ->]].
    + replace ((2 * j) mod 2)%Z with 0%Z by (rewrite Z.mul_comm, Z.mod_mul by lia; reflexivity).
      destruct (HN j) as [-> ->]; reflexivity.
    + replace ((2 * j + 1) mod 2)%Z with 1%Z by (rewrite Z.add_comm, Z.mul_comm, Z.mod_add by lia; reflexivity).
      replace (2 * j + 1 + 1)%Z with (2 * (j + 1))%Z by ring; destruct (HN (j + 1)%Z) as [-> _], (HN j) as [_ ->]; change (Z.of_nat (nth (Z.to_nat 1) [1; 2]%nat 0%nat)) with 2%Z; lia.
  - apply HP; auto.
Qed.
