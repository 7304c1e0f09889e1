(** * Numbers worked out by hand that follow from the statements, so that a statement
    that has lost its content no longer compiles here

    Each lemma takes the statement as its hypothesis. The last section computes u, b and c
    themselves at one point of each region. *)

From Coq Require Import Reals List Arith ZArith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementB StatementExamples Farey Eight StatementZ OrbitZ.
Open Scope R_scope.

(** The tactic on every conjunct, definitions folded. *)
Ltac each tac := match goal with |- _ /\ _ => split; [each tac | each tac] | _ => tac end.

Ltac pose_neighbours := unfold neighbours; lia.

(** ** Theorem 2 for n = 3, 4, 5 ([Eight] has n = 8) *)

Definition table (n : nat) (e g : sign) (s : R) : Prop :=
  match n, e, g with
  | 3%nat, Minus, Plus => 0 < s < 1 / 6
  | 3%nat, Plus, Plus => 1 / 6 < s < 1 / 3
  | 3%nat, Plus, Minus => 1 / 3 < s < 1 / 2
  | 4%nat, Minus, Plus => 0 < s < 1 / 8
  | 4%nat, Plus, Plus => 1 / 8 < s < 1 / 4
  | 4%nat, Plus, Minus => 1 / 4 < s < 1 / 3
  | 5%nat, Minus, Plus => 0 < s < 1 / 10
  | 5%nat, Plus, Plus => 1 / 10 < s < 1 / 5 \/ 1 / 3 < s < 2 / 5
  | 5%nat, Plus, Minus => 1 / 5 < s < 1 / 4 \/ 2 / 5 < s < 1 / 2
  | _, _, _ => False
  end.

Lemma around_1_3 : neighbours 1 3 0 1 1 2. Proof. pose_neighbours. Qed.
Lemma around_1_4 : neighbours 1 4 0 1 1 3. Proof. pose_neighbours. Qed.
Lemma around_1_5 : neighbours 1 5 0 1 1 4. Proof. pose_neighbours. Qed.
Lemma around_2_5 : neighbours 2 5 1 3 1 2. Proof. pose_neighbours. Qed.

Ltac listed HF H := apply (neighbours_unique _ _ _ _ _ _ H) in HF; inversion HF; subst.

Lemma intervals_table n e g lo hi : (3 <= n <= 5)%nat -> interval n e g lo hi -> forall s, lo < s < hi -> table n e g s.
Proof.
  intros Hn HI s Hs; apply view in HI.
  assert (n = 3 \/ n = 4 \/ n = 5)%nat as [-> | [-> | ->]] by lia;
    destruct HI as [|m mp np mm nm Hm HF|m mp np mm nm Hm HF]; try (simpl in *; lra);
    pose proof (neighbours_coprime _ _ _ _ _ _ HF) as Hg; assert (m = 1 \/ m = 2)%nat as [-> | ->] by lia; try lia;
    try discriminate Hg.
  - simpl in *; lra.
  - listed HF around_1_3; simpl in *; lra.
  - simpl in *; lra.
  - listed HF around_1_4; simpl in *; lra.
  - simpl in *; lra.
  - listed HF around_2_5; simpl in *; lra.
  - listed HF around_1_5; simpl in *; lra.
  - listed HF around_2_5; simpl in *; lra.
Qed.

Ltac by_interval I := eexists _, _; split; [exact I | simpl in *; lra].

Lemma table_intervals n e g s : (3 <= n <= 5)%nat -> table n e g s -> exists lo hi, interval n e g lo hi /\ lo < s < hi.
Proof.
  intros Hn Hs; assert (n = 3 \/ n = 4 \/ n = 5)%nat as [-> | [-> | ->]] by lia.
  - pose proof (left_of 3 1 0 1 1 2 ltac:(lia) around_1_3) as I1.
    pose proof (right_of 3 1 0 1 1 2 ltac:(lia) around_1_3) as I2.
    destruct e, g; [by_interval I1 | by_interval I2 | by_interval (first 3) | destruct Hs].
  - pose proof (left_of 4 1 0 1 1 3 ltac:(lia) around_1_4) as I1.
    pose proof (right_of 4 1 0 1 1 3 ltac:(lia) around_1_4) as I2.
    destruct e, g; [by_interval I1 | by_interval I2 | by_interval (first 4) | destruct Hs].
  - pose proof (left_of 5 1 0 1 1 4 ltac:(lia) around_1_5) as I1.
    pose proof (right_of 5 1 0 1 1 4 ltac:(lia) around_1_5) as I2.
    pose proof (left_of 5 2 1 3 1 2 ltac:(lia) around_2_5) as I3.
    pose proof (right_of 5 2 1 3 1 2 ltac:(lia) around_2_5) as I4.
    destruct e, g; [destruct Hs as [Hs|Hs]; [by_interval I1 | by_interval I3] | destruct Hs as [Hs|Hs];
      [by_interval I2 | by_interval I4] | by_interval (first 5) | destruct Hs].
Qed.
Lemma Theorem2_3_4_5 : Theorem2_statement -> forall n s e g, (3 <= n <= 5)%nat -> 0 < s < 1 / 2 ->
  (orbit_at 1 s n e g <-> table n e g s).
Proof.
  intros T n s e g Hn Hs; rewrite (proj1 (T n s ltac:(lia) Hs) e g); split.
  - intros (lo & hi & HI & H); exact (intervals_table n e g lo hi Hn HI s H).
  - now apply table_intervals.
Qed.
Lemma Theorem2_8 : Theorem2_statement -> Period_8_statement. Proof. exact period_8_from_Theorem2. Qed.

(** Between 1/3 and 1/2 there is no period 4, and Theorem 1 says so. *)
Lemma Theorem2_outside : Theorem2_statement -> forall s, 1 / 3 < s < 1 / 2 -> u_at 1 s 4 <> 0 -> no_orbit_at 1 s 4.
Proof.
  intros T s Hs Hu; apply (T 4%nat s); [lia|lra| |assumption]; intros e g lo hi HI; right.
  apply view in HI; inversion HI as [|m mp np mm nm Hm HF|m mp np mm nm Hm HF]; subst; [simpl; lra| |];
    assert (m = 1)%nat as -> by lia; [simpl; lra|]; listed HF around_1_4; simpl; lra.
Qed.
Lemma count_8 : Theorem2_count_statement -> exists L : list (sign * sign * R * R), length L = 5%nat /\
  forall e g lo hi, In (e, g, lo, hi) L <-> interval 8 e g lo hi.
Proof. intros T; destruct (T 8%nat ltac:(lia)) as (L & E & _ & H & _); exists L; auto. Qed.

(** b_{4,3} and b_{4,1} decide on either side of 1/4. *)
Lemma indices_4 : Deciding_indices_statement -> (exists g lo hi, side 4 1 g lo hi) /\ (exists g lo hi, side 4 3 g lo hi)
  /\ ~ (exists g lo hi, side 4 2 g lo hi).
Proof.
  intros D; destruct (D 4%nat ltac:(lia)) as [H _]; rewrite <- !H. repeat split; try lia; intros [_ E]; discriminate E.
Qed.

(** ** Region 3 below the circle *)

Lemma S4_outside : S4_statement -> forall r s, 0 < r < 1 -> 1 / 3 < s < 1 / 2 -> u_at r s 4 <> 0 -> no_orbit_at r s 4.
Proof.
  intros S r s Hr Hs Hu; apply (proj2 (proj2 (S 4%nat ltac:(lia)))); trivial; try lra.
  intros e g lo hi HI H; apply view in HI.
  inversion HI as [|m mp np mm nm Hm HF|m mp np mm nm Hm HF]; subst; [simpl in H; lra| |]; assert (m = 1)%nat as ->
    by lia; [simpl in H; lra|]; listed HF around_1_4; simpl in H; lra.
Qed.

(** ** The rest of the plane *)

Lemma Period1_numbers : Period1_statement ->
  orbit 3 1 1 Plus Plus /\ orbit 3 1 1 Minus Minus /\ orbit (-5) 4 1 Plus Minus /\ orbit 1 9 1 Minus Plus.
Proof. intros P; each ltac:(apply P; simpl; lra). Qed.
Lemma Period2_numbers : Period2_statement ->
  orbit 6 4 2 Plus Plus /\ orbit 4 4 2 Minus Plus /\ orbit (-4) 4 2 Plus Plus /\ orbit (-6) 4 2 Plus Minus /\
  orbit 2 (1 / 2) 2 Plus Plus /\ orbit (-1) (1 / 2) 2 Plus Plus /\ ~ orbit 2 9 2 Plus Plus.
Proof.
  intros P; each ltac:(try (apply P; [lra | intuition lra])).
  intros H; apply P in H; [intuition (lra || discriminate) | lra].
Qed.
Lemma sqrt_quarter : sqrt (1 / 4) = 1 / 2.
Proof. replace (1 / 4) with ((1 / 2) * (1 / 2)) by field; apply sqrt_square; lra. Qed.
Lemma Region1_numbers : Region1_statement -> orbit 3 (1 / 2) 7 Plus Plus /\ orbit 6 4 3 Plus Plus.
Proof. intros H; each ltac:(apply H; lra || lia). Qed.
Lemma Region2_numbers : Region2_statement -> orbit 1 (1 / 4) 5 Minus Plus.
Proof. intros H; apply H; rewrite ?sqrt_quarter; lra || lia. Qed.
Lemma Region5_numbers : Region5_statement -> orbit (-3) (1 / 2) 4 Plus Minus /\ orbit (-3 / 2) (1 / 2) 3 Plus Minus.
Proof. intros H; each ltac:(apply H; try lra; try lia); right; split; [lra | exists 1%nat; reflexivity]. Qed.
Lemma Lines_numbers : Lines_statement -> u (-3 / 2) (1 / 2) 4 <> 0 /\ b (-3 / 2) (1 / 2) 4 2 = 0.
Proof.
  intros H; destruct (H (1 / 2) 4%nat ltac:(lra) ltac:(lia)) as (_ & Hu & _ & _ & He).
  replace (- (1 / 2 + 1)) with (-3 / 2) in * by field; split; [assumption|].
  apply He; [exists 2%nat; reflexivity | lia | exists 1%nat; reflexivity].
Qed.

(** b_{3,1} = 49/119 at (-6/5, 1/4), and 0 at (-1, 1/4). *)
Lemma S5_numbers : S5_statement -> orbit (-6 / 5) (1 / 4) 3 Plus Minus /\
  b (-1) (1 / 4) 3 2 > 0 /\ no_orbit (-1) (1 / 4) 4 /\ orbit (-1) (1 / 4) 2 Plus Plus.
Proof.
  intros H; assert (Ho : Nat.Odd 3) by (exists 1%nat; reflexivity).
  destruct (H (-6 / 5) (1 / 4) 3%nat) as (_ & _ & D); rewrite ?sqrt_quarter; try lra.
  destruct (D ltac:(lia) Ho) as (_ & [_ _ Hp _ _]).
  destruct (H (-1) (1 / 4) 3%nat) as (_ & _ & D'); rewrite ?sqrt_quarter; try lra.
  destruct (D' ltac:(lia) Ho) as (_ & [_ _ _ _ Hz]).
  destruct (H (-1) (1 / 4) 4%nat) as (_ & H4 & _); rewrite ?sqrt_quarter; try lra.
  destruct (H (-1) (1 / 4) 2%nat) as (H2 & _ & _); rewrite ?sqrt_quarter; try lra. split; [|split; [|split]].
  - apply Hp; unfold b, u; simpl; lra.
  - apply Hz; try lia; try lra; unfold b, u; simpl; lra.
  - apply H4; [lia | exists 2%nat; reflexivity].
  - exact (H2 eq_refl).
Qed.
Lemma Reversal_numbers : Reversal_statement -> Region1_statement -> orbit 6 2 7 Plus Plus.
Proof.
  intros R H; replace 6 with (3 / (1 / 2)) by field; replace 2 with (/ (1 / 2)) by field.
  apply R; [lra | apply H; lra || lia].
Qed.
Lemma Large_numbers : Large_statement -> large 1 1 1 3 (1 / 2) 2 * 1 < 0 /\ large 1 1 1 1 (1 / 2) 2 * 1 > 0 /\
  large 1 1 (-1) (-3 / 2) (1 / 2) 3 * -1 > 0.
Proof.
  intros H; split; [|split].
  - apply H; try lra; try lia; unfold u; simpl; lra.
  - destruct (H 1 1 1 1 (1 / 2) 2%nat) as (_ & L & _); try lra; try lia; [unfold u; simpl; lra | apply L, Rabs_def1;
      lra].
  - destruct (H 1 1 (-1) (-3 / 2) (1 / 2) 3%nat) as (_ & _ & _ & L); try lra; try lia; [unfold u; simpl; lra | apply L;
      [lra | exists 1%nat; reflexivity]].
Qed.

(** On the circle, s = 1/6: f_1 = 1 and f_2 = 1/3, a record low. *)
Lemma Record_numbers : Record_statement -> orbit 1 1 2 Minus Plus.
Proof.
  intros H; destruct (H 1 1 2%nat) as (_ & _ & _ & L & _); [lra | apply Rabs_def1; lra | lia |].
  apply L; unfold low, f, u, v, u; split; [intros k Hk; replace k with 1%nat by lia|]; simpl; lra.
Qed.

(** n = 6, k = 3, s = 1/3: a double zero beyond the smallest k. *)
Lemma B_double_zero_numbers : B_double_zero_statement ->
  tends (fun h => B 6 3 (1 / 3 + h) / h ^ 2) (-2 * PI ^ 2 * 3 * 3).
Proof.
  intros H; destruct (H 6%nat 3%nat (1 / 3) 1%Z 1%Z) as (_ & _ & T); [lia | simpl; lra | simpl; lra |].
  cbn [Nat.sub] in T; replace (INR 3) with 3 in T by (simpl; lra); exact T.
Qed.

(** ** One point of each region, from the definitions alone *)

(** u = 0, 1, 1, 0, -1, -1: s = 1/6 on the circle. *)
Lemma point_circle : b 1 1 4 1 = 2 /\ b 1 1 4 2 = 3 /\ b 1 1 4 3 = 2 /\ c 1 1 4 = 3.
Proof. unfold b, c, v, u; simpl; repeat split; field. Qed.

(** u = 0, 1, 3, 17/2. *)
Lemma point_region1 : b 3 (1 / 2) 3 1 = 12 / 17 /\ b 3 (1 / 2) 3 2 = 21 / 34 /\ orbit 3 (1 / 2) 3 Plus Plus.
Proof.
  split; [|split]; [unfold b, u; simpl; field..|].
  replace 3 with (IZR 6 / IZR 2) by field; replace (1 / 2) with (IZR 1 / IZR 2) by field.
  apply orbitZ_orbit; reflexivity.
Qed.

(** u = 0, 1, 1, 3/4, 1/2: equal eigenvalues 1/2. *)
Lemma point_region2 : b 1 (1 / 4) 4 1 = -11 / 8 /\ orbit 1 (1 / 4) 4 Minus Plus.
Proof.
  split; [unfold b, u; simpl; field|].
  replace 1 with (IZR 4 / IZR 4) at 1 by field; replace (1 / 4) with (IZR 1 / IZR 4) by field.
  apply orbitZ_orbit; reflexivity.
Qed.

(** u = 0, 1, 0, -1/2, 0, 1/4: r^2 = 1/2, s = 1/4. *)
Lemma point_region3 : b 0 (1 / 2) 3 1 = 3 /\ b 0 (1 / 2) 3 2 = 3 / 2 /\ orbit 0 (1 / 2) 3 Plus Plus.
Proof.
  split; [|split]; [unfold b, u; simpl; field..|].
  replace 0 with (IZR 0 / IZR 2) by field; replace (1 / 2) with (IZR 1 / IZR 2) by field.
  apply orbitZ_orbit; reflexivity.
Qed.

(** u = 0, 1, -6/5, 119/100. *)
Lemma point_region4 : b (-6 / 5) (1 / 4) 3 1 = 7 / 17 /\ orbit (-6 / 5) (1 / 4) 3 Plus Minus /\
  no_orbit (-6 / 5) (1 / 4) 4.
Proof.
  split; [unfold b, u; simpl; field|].
  replace (-6 / 5) with (IZR (-24) / IZR 20) by field; replace (1 / 4) with (IZR 5 / IZR 20) by field.
  split; [apply orbitZ_orbit; reflexivity | apply no_orbitZ_no_orbit; reflexivity].
Qed.

(** u = 0, 1, -3, 17/2. *)
Lemma point_region5 : b (-3) (1 / 2) 3 1 = 18 / 17 /\ orbit (-3) (1 / 2) 3 Plus Minus.
Proof.
  split; [unfold b, u; simpl; field|].
  replace (-3) with (IZR (-6) / IZR 2) by field; replace (1 / 2) with (IZR 1 / IZR 2) by field.
  apply orbitZ_orbit; reflexivity.
Qed.

(** ** The paper's oscillator: impacts one period apart for ever, slow ones, and two apart, fast ones *)

From Grazing Require Import StatementOscillator StatementNordmark StatementChaos.
From Grazing Require Headline.

Lemma one_apart_and_two : Headline.Chaos_statement -> Chaos_periodic_statement -> forall mu, mu > 0 ->
  (exists t q v, chaos_motion mu (fun i => i) t q v /\ t 1%Z = t 0%Z + 2 * PI /\ v 0%Z (t 0%Z) <= 1 / 4 * mu /\
  q 0%Z (t 0%Z) = (1 + mu) * cos (t 0%Z) - 1 /\ forall x, q 1%Z (x + 2 * PI) = q 0%Z x /\ v 1%Z (x + 2 * PI) = v 0%Z x)
  /\ exists t q v, chaos_motion mu (fun i => 2 * i)%Z t q v /\ t 1%Z = t 0%Z + 4 * PI /\ v 0%Z (t 0%Z) >= 3 / 5 * mu.
Proof.
  intros H HP mu Hmu; split.
  - assert (HN : one_or_two (fun i => i)) by (intros i; lia). destruct (H mu _ Hmu HN) as (t & q & v & HM & HB & _).
    destruct (HP mu _ t q v 1%Z 1%Z Hmu HN HM HB ltac:(intros; cbn beta; lia) 0%Z 0) as (T & _).
    destruct (HB 0%Z 1%Z eq_refl) as [B _]; destruct (B eq_refl) as [A _].
    pose proof (swing_from _ _ _ _ _ _ _ _ _ _ (HM 0%Z 1%Z eq_refl)) as Q; unfold gap in Q; cbn in Q; rewrite Rmult_0_r,
      Rminus_0_r in Q.
    exists t, q, v; split; [exact HM|]; change (0 + 1)%Z with 1%Z in T; split; [lra|]; split; [lra|].
    split; [lra|]; intros x; destruct (HP mu _ t q v 1%Z 1%Z Hmu HN HM HB ltac:(intros; cbn beta; lia) 0%Z x)
      as (_ & P).
    rewrite Rmult_1_r in P; exact P.
  - assert (HN : one_or_two (fun i => 2 * i)%Z) by (intros i; lia).
    destruct (H mu _ Hmu HN) as (t & q & v & HM & HB & _).
    destruct (HP mu _ t q v 1%Z 2%Z Hmu HN HM HB ltac:(intros; cbn beta; lia) 0%Z 0) as (T & _).
    destruct (HB 0%Z 1%Z eq_refl) as [_ B]; destruct (B eq_refl) as [A _].
    exists t, q, v; split; [exact HM|]; change (0 + 1)%Z with 1%Z in T; split; lra.
Qed.

(** What a motion is, and what its boxes say, at the first leg. *)
Lemma a_leg : Nordmark_statement -> forall mu N t y v, chaos_motion mu N t y v -> N 0%Z = 0%Z -> let w x :=
  (1 + mu) * cos x - 1 in let V i := v i (t 1%Z) + (1 + mu) * sin (t 1%Z) in (forall x, derivable_pt_lim (y 0%Z) x
  (v 0%Z x) /\ derivable_pt_lim (v 0%Z) x (- (12 / 49) * v 0%Z x - 100 / 2401 * y 0%Z x)) /\ - 6 / 5 <= t 0%Z <= 6 / 5
  /\ t 0%Z < t 1%Z /\ y 0%Z (t 0%Z) = w (t 0%Z) /\ y 0%Z (t 1%Z) = w (t 1%Z) /\ (forall x, t 0%Z < x < t 1%Z ->
  w x < y 0%Z x) /\ V 0%Z < 0 /\ V 1%Z = - V 0%Z.
Proof.
  intros H mu N t y v HM N0; destruct (H (3 / 5) (49 / 10) 1 ltac:(lra) ltac:(lra)) as (_ & _ & _ & E).
  replace (2 * (3 / 5) / (49 / 10)) with (12 / 49) in E by field; replace (1 / (49 / 10) ^ 2) with (100 / 2401) in E
    by field.
  destruct (proj1 (E mu _ N t y v) HM 0%Z 1%Z eq_refl) as (F & D & L & Q0 & Q1 & A & V1 & V2).
  rewrite N0, Rmult_0_r, Rminus_0_r in D; cbv zeta; split; [exact F|]; unfold Rabs in D; destruct Rcase_abs;
    repeat (split; [lra|]); split; try exact A; lra.
Qed.
Lemma its_boxes t v : (in_two_boxes 1 (fun i => i) t v -> 89 <= 1000 * v 0%Z (t 0%Z) <= 244 /\ - 1582 <= 10000 * v 0%Z
  (t 1%Z) <= - 612) /\ (in_two_boxes 1 (fun i => 2 * i)%Z t v -> 615 <= 1000 * v 0%Z (t 0%Z) <= 1036 /\
  - 367 <= 1000 * v 0%Z (t 1%Z) <= - 140) /\ (in_three_boxes 1 (fun i => i) t v -> 28 <= 1000 * v 0%Z (t 0%Z) <= 196 /\
  - 1137 <= 10000 * v 0%Z (t 1%Z) <= - 1010) /\ (in_three_boxes 1 (fun i => 2 * i)%Z t v -> 481 <= 1000 * v 0%Z (t 0%Z)
  <= 829 /\ - 2509 <= 10000 * v 0%Z (t 1%Z) <= - 1638) /\ (in_three_boxes 1 (fun i => 3 * i)%Z t v ->
  169 <= 10 * v 0%Z (t 0%Z) <= 323 /\ - 334 <= 100 * v 0%Z (t 1%Z) <= - 175).
Proof.
  split; [|split; [|split; [|split]]]; intros H; destruct (H 0%Z 1%Z eq_refl) as (A & B); try (destruct (A eq_refl);
    lra).
  - destruct (B eq_refl); lra.
  - destruct B as [B _]; destruct (B eq_refl); lra.
  - destruct B as [_ B]; destruct (B eq_refl); lra.
Qed.
Lemma one_of_three : Chaos_three_statement -> forall N t y v t' y' v', one_to_three N -> chaos_motion (1 / 1000) N t y v
  -> chaos_motion (1 / 1000) N t' y' v' -> in_three_boxes (1 / 1000) N t v -> in_three_boxes (1 / 1000) N t' v' ->
  forall i x, t i = t' i /\ y i x = y' i x /\ v i x = v' i x.
Proof.
  intros H N t y v t' y' v' HN M M' B B' i x; destruct (H (1 / 1000) N ltac:(lra) HN) as (t0 & y0 & v0 & _ & _ & U).
  destruct (U _ _ _ M B i x) as (-> & -> & ->), (U _ _ _ M' B' i x) as (-> & -> & ->); auto.
Qed.

(** No motion is one apart and two apart; those that agree up to 12 impacts around one are within 3 (7/8)^10 there. *)
Lemma apart : Chaos_distinct_statement -> forall mu t y v y' v', chaos_motion mu (fun i => i) t y v ->
  ~ chaos_motion mu (fun i => 2 * i)%Z t y' v'.
Proof. intros D mu t y v y' v' M M'; specialize (D mu _ _ t y v y' v' M M' 1%Z); discriminate D. Qed.
Lemma close_by : Chaos_continuous_statement -> forall mu N t y v t' y' v', mu > 0 -> one_or_two N ->
  (forall i, (-12 <= i <= 12)%Z -> N i = i) -> chaos_motion mu (fun i => i) t y v -> in_two_boxes mu (fun i => i) t v ->
  chaos_motion mu N t' y' v' -> in_two_boxes mu N t' v' -> Rabs (t 0%Z - t' 0%Z) <= 3 * (7 / 8) ^ 10 /\
  Rabs (v 0%Z (t 0%Z) - v' 0%Z (t' 0%Z)) <= 2 * mu * (7 / 8) ^ 10.
Proof.
  intros C mu N t y v t' y' v' Hmu HN E M B M' B'; apply (C mu (fun i => i) N t y v t' y' v' 10%nat); trivial.
  - intros i; lia.
  - intros i Hi; symmetry; apply E; lia.
Qed.

(** At mu = 0.003 impacts three periods apart for ever, each leg leaving at 16.9 mu or faster. *)
Lemma three_apart : Chaos_three_statement -> exists t q v, chaos_motion (3 / 1000) (fun i => 3 * i)%Z t q v /\
  507 / 10000 <= v 0%Z (t 0%Z) /\ Rabs (t 1%Z - 6 * PI) <= 6 / 5.
Proof.
  intros H; destruct (H (3 / 1000) (fun i => 3 * i)%Z ltac:(lra)) as (t & q & v & HM & HB & _).
  { intros i; right; right; lia. }
  destruct (HB 0%Z 1%Z eq_refl) as (_ & _ & B); destruct (B eq_refl) as [A _].
  pose proof (swing_near _ _ _ _ _ _ _ _ _ _ (HM 1%Z 2%Z eq_refl)) as T; cbn [turn] in T; change (3 * 1)%Z with 3%Z
    in T.
  exists t, q, v; split; [exact HM|]; split; [lra|]; replace (6 * PI) with (2 * PI * 3) by ring; exact T.
Qed.
