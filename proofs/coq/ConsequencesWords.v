(** * Numbers worked out by hand that follow from the statements about words

    At (1, 1/4), region 2: u = 0, 1, 1, 3/4, 1/2, p_1 = 0, p_2 = -1/4, q_1 = 1/4, q_2 = 5/16. At (-2/3, 8/9), region 3:
    the five periods 1, 2, 3, 4, 7 of [StatementExamples], with the word U, D, D. *)

From Coq Require Import Reals List Arith ZArith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementWords StatementExamples StatementZ StatementWordsZ
  StatementSystems Headline ConsequencesHeadline.
Import ListNotations.
Open Scope R_scope.

Ltac by_hand := unfold edge, p, q, u; cbn [sgn]; simpl; lra.

(** ** (1, 1/4) *)
Lemma orbits_1_4 : orbit 1 (1 / 4) 1 Minus Plus /\ orbit 1 (1 / 4) 2 Minus Plus.
Proof.
  split; (split; [numbers | split; [intros k Hk | cbn [sgn]; numbers]]); [lia | replace k with 1%nat by lia].
  cbn [sgn]; numbers.
Qed.

Lemma Flight_numbers : Flight_statement ->
  (forall X, single_impact 1 (1 / 4) 2 X -> snd X = - 1 / 4 /\ snd (apply (mpow (A 1 (1 / 4)) 2) X) = 5 / 16) /\
  pattern 1 (1 / 4) Minus Plus [2%nat].
Proof.
  intros F; destruct (F 1 (1 / 4) 2%nat ltac:(numbers)) as [H1 H2]; split; [|apply H2, orbits_1_4].
  intros X HX; destruct (H1 X HX) as [-> ->]; split; numbers.
Qed.

Lemma Identities_numbers : Identities_statement ->
  c 1 (1 / 4) 2 = - 9 / 16 /\ p 1 (1 / 4) 1 - q 1 (1 / 4) 2 = - 5 / 16 /\ b 1 (1 / 4) 2 1 = - 1 / 4 /\
  p 1 (1 / 4) 2 + q 1 (1 / 4) 2 - 1 = - 15 / 16.
Proof.
  intros I; destruct (I 1 (1 / 4) 2%nat 1%nat ltac:(numbers) ltac:(numbers)) as (E1 & E2 & _ & E4).
  destruct (I 1 (1 / 4) 1%nat 2%nat ltac:(numbers) ltac:(numbers)) as (_ & _ & E3 & _).
  destruct (E2 ltac:(lia)) as [E2' _]; rewrite E1, E2', E3, E4; repeat split; numbers.
Qed.

(** (4, 4) is (1, 1/4) in reversed time. *)
Lemma Words_reversal_numbers : Words_reversal_statement ->
  p (1 / (1 / 4)) (/ (1 / 4)) 1 - q (1 / (1 / 4)) (/ (1 / 4)) 2 = - 2 /\
  (member (1 / (1 / 4)) (/ (1 / 4)) Minus 2 <-> member 1 (1 / 4) Minus 2).
Proof.
  intros R; destruct (R 1 (1 / 4) 1%nat 2%nat ltac:(lra) ltac:(numbers) ltac:(numbers)) as (_ & -> & _).
  destruct (R 1 (1 / 4) 2%nat 2%nat ltac:(lra) ltac:(numbers) ltac:(numbers)) as (_ & _ & M).
  split; [numbers | apply M].
Qed.

Lemma W1_numbers : W1_statement -> pattern 1 (1 / 4) Minus Plus [1; 2; 2; 1]%nat /\
  p 1 (1 / 4) 2 < p 1 (1 / 4) 1.
Proof.
  intros W; destruct orbits_1_4 as [O1 O2]; destruct (W 1 (1 / 4) Minus ltac:(lra)) as [H1 H2]; split.
  - apply H2; [discriminate | repeat (apply Forall_cons; [assumption|]); apply Forall_nil].
  - apply (H1 1%nat 2%nat ltac:(lia)); [split; apply O2 | cbn [sgn]; numbers].
Qed.

Lemma W6_numbers : W6_statement ->
  two_cycles (fun i j => member 1 (1 / 4) Minus i /\ member 1 (1 / 4) Minus j /\ edge 1 (1 / 4) Minus Plus i j).
Proof.
  intros W; apply W; [lra | rewrite Rabs_pos_eq; lra|]; destruct orbits_1_4 as [O1 O2].
  exists 1%nat, 2%nat; split; [discriminate | split; assumption].
Qed.

Lemma Regions_numbers : Regions_statement -> pattern 3 (1 / 2) Plus Plus [1; 2; 3]%nat /\
  ~ pattern 3 (1 / 2) Plus Minus [1; 2; 3]%nat /\ pattern (-3) (1 / 2) Plus Minus [4; 7]%nat /\
  pattern 1 (1 / 4) Minus Plus [5]%nat.
Proof.
  intros R; assert (E4 : sqrt (1 / 4) = 1 / 2).
  { replace (1 / 4) with (1 / 2 * (1 / 2)) by field; apply sqrt_square; lra. }
  assert (X : forall l, Forall (le 1) l -> Forall (le 1) l) by trivial.
  split; [|split; [|split]].
  - apply (R 3 (1 / 2) Plus Plus); [lra | intuition lra | | split; [reflexivity | split; [reflexivity|]]].
    + apply Exists_exists; exists 2%nat; split; [cbn; tauto | lia].
    + repeat constructor; lia.
  - intros H; apply (R 3 (1 / 2) Plus Plus) in H; [|lra | intuition lra |].
    + destruct H as (_ & H & _); discriminate H.
    + apply Exists_exists; exists 2%nat; split; [cbn; tauto | lia].
  - apply (R (-3) (1 / 2) Plus Minus); [lra | intuition lra | | split; [reflexivity | split; [reflexivity|]]].
    + apply Exists_exists; exists 4%nat; split; [cbn; tauto | lia].
    + repeat constructor; lia.
  - apply (R 1 (1 / 4) Minus Plus); [lra | rewrite E4; intuition lra | | split; [reflexivity | split; [reflexivity|]]].
    + apply Exists_exists; exists 5%nat; split; [cbn; tauto | lia].
    + repeat constructor; lia.
Qed.

(** At (0, 1/2) period 1 is lower, period 3 upper: p_1 = -1 < 0 < p_3 = 2. *)
Lemma W2_numbers : W2_statement -> p 0 (1 / 2) 1 < 0 < p 0 (1 / 2) 3 /\
  (q 0 (1 / 2) 3 < p 0 (1 / 2) 1 -> q 0 (1 / 2) 1 < p 0 (1 / 2) 3) /\ sgn Plus * c 0 (1 / 2) 3 > 0.
Proof.
  intros W; destruct (W 0 (1 / 2) ltac:(lra) ltac:(rewrite Rabs_R0; lra)) as [H1 H2].
  destruct (H2 1%nat 3%nat ltac:(cbn [on]; numbers) ltac:(cbn [on]; numbers)) as (A & B & _).
  split; [lra|]; split; [exact B | apply (H1 3%nat U); cbn [on]; numbers].
Qed.

(** ** s = 1/6: K = 4; regions 3 and 4: K = 2 for a1 < 0 *)
Lemma Path_numbers : Path_statement -> first_upper (trace 1 (1 / 6)) (1 ^ 2) 4 /\
  ~ first_upper (trace 1 (1 / 6)) (1 ^ 2) 3 /\ (exists K, first_upper (-11 / 10) (1 / 4) K).
Proof.
  intros (P1 & _ & P3); assert (E4 : sqrt (1 / 4) = 1 / 2).
  { replace (1 / 4) with (1 / 2 * (1 / 2)) by field; apply sqrt_square; lra. }
  split; [apply (P3 1 (1 / 6) 4%nat); simpl; lra|]; split.
  - intros H; apply (P3 1 (1 / 6) 3%nat) in H; simpl in H; lra.
  - apply P1; rewrite ?E4; lra.
Qed.

Lemma path_3 : path (-2 / 3) (8 / 9) 2 [U] 1 3.
Proof. apply (path_U _ _ 2 [] 1 2 (path_start _ _ 2)); cbn [on]; numbers. Qed.
Lemma five_members : Five_periods_statement -> forall n, In n five -> member (-2 / 3) (8 / 9) Plus n.
Proof. intros [F _] n Hn; apply F, Hn. Qed.

Lemma W3_numbers : W3_statement -> member (-2 / 3) (8 / 9) Minus 1 /\ ~ member (-2 / 3) (8 / 9) Minus 2 /\
  member (-2 / 3) (8 / 9) Plus 1 /\ member (-2 / 3) (8 / 9) Plus 2.
Proof.
  intros W; destruct (W _ _ 2%nat first_five) as (H1 & H2 & H3 & _); split; [apply H1; split; [lia | numbers]|].
  split; [intros H; apply H1 in H; lia | split; assumption].
Qed.

Lemma W5_neighbours_numbers : W5_neighbours_statement -> Five_periods_statement ->
  p (-2 / 3) (8 / 9) 1 > q (-2 / 3) (8 / 9) 2 /\ ~ p (-2 / 3) (8 / 9) 2 < q (-2 / 3) (8 / 9) 1 /\
  p (-2 / 3) (8 / 9) 3 < q (-2 / 3) (8 / 9) 1.
Proof.
  intros W F; destruct (W _ _ 2%nat [] 1%nat 2%nat first_five (path_start _ _ 2)) as (H1 & H2 & _).
  destruct (W _ _ 2%nat [U] 1%nat 3%nat first_five path_3) as (_ & H3 & _).
  split; [apply H1; split; [apply (five_members F); cbn; tauto | cbn [on]; numbers]|].
  split; [intros H; apply H2 in H; destruct H as [_ H]; cbn [on] in H; revert H; numbers|].
  apply H3; split; [apply (five_members F); cbn; tauto | cbn [on]; numbers].
Qed.

Lemma W5_numbers : W5_statement -> Five_periods_statement ->
  edge (-2 / 3) (8 / 9) Plus Plus 2 3 /\ edge (-2 / 3) (8 / 9) Plus Minus 1 4 /\
  pattern (-2 / 3) (8 / 9) Plus Plus [2; 3]%nat.
Proof.
  intros W F; destruct (W _ _ 2%nat [U; D; D] 7%nat 3%nat first_five path_7 (five_vertices F)) as [H1 H2].
  pose proof (five_ends F) as HE; split; [|split].
  - apply (H1 (2, U)%nat (3, U)%nat); cbn; tauto.
  - apply (H1 (1, D)%nat (4, D)%nat); cbn; tauto.
  - apply (H2 HE); exists [(2, U); (3, U)]%nat; split; [reflexivity|]; split; [intros x; cbn; tauto | cbn; auto].
Qed.

(** Twins: the pattern (1, 2) and period 3. *)
Lemma W4_numbers : W4_statement -> (pattern (-2 / 3) (8 / 9) Plus Plus [1; 2]%nat <-> orbit (-2 / 3) (8 / 9) 3 Plus Plus) /\
  ~ pattern (-2 / 3) (8 / 9) Minus Plus [1; 2]%nat /\
  (member (-2 / 3) (8 / 9) Minus 1 -> pattern (-2 / 3) (8 / 9) Minus Plus [1; 1]%nat).
Proof.
  intros W; destruct (W _ _ 2%nat first_five) as (H1 & _ & H3); split.
  - apply (H1 [] 1%nat 2%nat (path_start _ _ 2) Plus).
  - split; [|intros [Hu _]; apply H3].
    + intros H; apply H3 in H; destruct H as (_ & _ & H); inversion H as [|x l _ H']; inversion H' as [|x' l' [H'' _] _]; lia.
    + split; [reflexivity|]; split; [discriminate | repeat constructor; trivial; lia].
Qed.

Lemma V_finite_numbers : V_finite_statement -> exists L, ~ member (-2 / 3) (8 / 9) Plus (S L).
Proof.
  intros V; destruct (V _ _ 2%nat first_five ltac:(lra)) as [L HL]; exists L; intros H; specialize (HL _ H); lia.
Qed.

(** Where two cycles meet: at (1/2, 1/2) for e mu < 0 and gamma > 0. At s = 1/6 on r = 1, where K = 4, for e mu > 0 and
    gamma > 0, as b_{5,4} = (-1 + 1 - 1)/-1 = 1; not for gamma < 0, as no n has n/6 > 1 > (n - 1)/6. *)
Lemma Cycle_numbers : Cycle_statement -> cycles (1 / 2) (1 / 2) Minus Plus /\ ~ cycles (1 / 2) (1 / 2) Minus Minus /\
  cycles (trace 1 (1 / 6)) (1 ^ 2) Plus Plus /\ ~ cycles (trace 1 (1 / 6)) (1 ^ 2) Plus Minus.
Proof.
  intros [H1 H2]; assert (HK : first_upper (1 / 2) (1 / 2) 3).
  { pose proof (sqrt_lt_1 (1 / 4) (1 / 2) ltac:(lra) ltac:(lra) ltac:(lra)) as X.
    replace (1 / 4) with (1 / 2 * (1 / 2)) in X at 1 by field; rewrite sqrt_square in X by lra.
    split; [lra|]; split; [lra|]; split; [cbn [on]; numbers|].
    intros k Hk; assert (k = 0 \/ k = 1 \/ k = 2)%nat as [-> | [-> | ->]] by lia; numbers. }
  destruct (H1 _ _ _ HK) as [A B], (H2 1 (1 / 6) ltac:(lra) ltac:(lra)) as [C D].
  split; [apply A; lra|]; split; [exact B|]; split.
  - apply (D 4%nat); [simpl; lra | lra|]; cbn [Nat.add]; unfold b_at, trace.
    replace (2 * PI * (1 / 6)) with (PI / 3) by field; rewrite cos_PI3, pow1; replace (2 * 1 * (1 / 2)) with 1 by field.
    numbers.
  - intros X; apply C in X; destruct X as (n & _ & L & L' & _).
    assert (6 < n)%nat by (apply INR_lt; simpl; lra); assert (n - 1 < 6)%nat by (apply INR_lt; simpl; lra); lia.
Qed.

(** With integers: -2/3 = -6/9. *)
Lemma Words_oracle_numbers : Words_oracle_statement ->
  member (IZR (-6) / IZR 9) (IZR 8 / IZR 9) Plus 7 /\ ~ member (IZR (-6) / IZR 9) (IZR 8 / IZR 9) Plus 5 /\
  edge (IZR (-6) / IZR 9) (IZR 8 / IZR 9) Plus Plus 2 7 /\
  pattern (IZR (-6) / IZR 9) (IZR 8 / IZR 9) Plus Plus [2; 3; 3]%nat.
Proof.
  intros O; destruct (O (-6)%Z 8%Z 9%Z ltac:(lia)) as (M & E & P); split; [apply M; reflexivity|].
  split; [intros H; apply M in H; discriminate H|]; split; [|apply P; reflexivity].
  apply E; [| | reflexivity]; unfold u; simpl; lra.
Qed.

Lemma Oracle_numbers : Oracle_statement -> orbit (IZR 6 / IZR 2) (IZR 1 / IZR 2) 3 Plus Plus /\
  no_orbit (IZR (-24) / IZR 20) (IZR 5 / IZR 20) 4 /\ b (IZR 4 / IZR 4) (IZR 1 / IZR 4) 4 1 < 0.
Proof.
  intros O; destruct (O 6%Z 1%Z 2%Z 3%nat ltac:(lia)) as (_ & _ & _ & H1 & _).
  destruct (O (-24)%Z 5%Z 20%Z 4%nat ltac:(lia)) as (_ & _ & _ & _ & H2).
  destruct (O 4%Z 1%Z 4%Z 4%nat ltac:(lia)) as (_ & H3 & _); split; [apply H1; reflexivity|].
  split; [apply H2; reflexivity|]; destruct H3 as [_ H3]; [unfold u; simpl; lra|].
  apply (H3 1%nat ltac:(lia)); reflexivity.
Qed.

(** ** The worked instances of [StatementExamples] *)
Lemma examples : Resonance_statement -> Oscillator_statement -> Five_periods_statement -> Boundary_statement ->
  Period_8_statement -> pattern (trace 1 (1 / 6)) (1 ^ 2) Minus Plus [1; 2; 2]%nat /\
  ~ pattern (trace 1 (8 / 49)) (1 ^ 2) Minus Minus [1%nat] /\
  pattern (trace 1 (8 / 49)) (1 ^ 2) Minus Plus [3; 1; 2]%nat /\
  edge (-2 / 3) (8 / 9) Plus Plus 7 3 /\ b (-1 / 2) (1 / 2) 3 2 = 0 /\
  orbit_at 1 (7 / 20) 8 Plus Plus /\ ~ orbit_at 1 (3 / 10) 8 Plus Plus.
Proof.
  intros R O F B P; split; [apply (R 1 ltac:(lra)); split; [discriminate | repeat constructor; tauto]|].
  split; [apply (O 1 [1%nat] ltac:(lra))|].
  split; [apply (O 1 [3; 1; 2]%nat ltac:(lra)); split; [discriminate | repeat constructor; lia]|].
  split; [apply F; cbn; tauto|]; split; [apply B|].
  split; [apply P; cbn; lra|]; intros H; apply P in H; cbn in H; lra.
Qed.

(** ** Motions and orbits *)

Lemma All_patterns_numbers : All_patterns_statement -> W5_statement -> Five_periods_statement -> forall S gamma,
  grazes S (-2 / 3) (8 / 9) gamma -> gamma > 0 -> exists d mu0, d > 0 /\ mu0 > 0 /\ forall mu, 0 < e_mu S mu < mu0 ->
  one S mu d (cyclic_letter [2; 3]%nat).
Proof.
  intros A W F S gamma HS Hg; destruct (A S _ _ gamma 2%nat HS first_five ltac:(lra)) as (d & Hd & T).
  destruct (T d ltac:(lra)) as (mu0 & Hm & T'); exists d, mu0; split; [exact Hd|]; split; [exact Hm|].
  intros mu Hmu; apply (T' [2; 3]%nat Plus mu); [cbn [sgn]; lra | exact Hmu | apply (W5_numbers W F)].
Qed.

Lemma Shift_numbers : Shift_statement -> forall S gamma, grazes S 1 (1 / 4) gamma -> gamma > 0 ->
  exists d mu0, d > 0 /\ mu0 > 0 /\ forall (n : Z -> nat) mu, - mu0 < e_mu S mu < 0 ->
  (forall i, n i = 1 \/ n i = 2)%nat -> one S mu d n.
Proof.
  intros H S gamma HS Hg; destruct (H S _ _ gamma HS ltac:(lra) 2%nat) as (d & Hd & T).
  destruct (T d ltac:(lra)) as (mu0 & Hm & T'); exists d, mu0; split; [exact Hd|]; split; [exact Hm|].
  intros n mu Hmu Hn; apply (T' n Minus Plus mu); [|cbn [sgn]; lra | cbn [sgn]; lra].
  intros i; destruct orbits_1_4, (Hn i) as [-> | ->]; split; trivial; lia.
Qed.
