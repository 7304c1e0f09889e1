(** * Numbers worked out by hand that follow from the statements about words

    At (1, 1/4), region 2: u = 0, 1, 1, 3/4, 1/2, p_1 = 0, p_2 = -1/4, q_1 = 1/4, q_2 = 5/16. At (-2/3, 8/9),
    region 3: the five periods 1, 2, 3, 4, 7 of [StatementExamples], with the word U, D, D. *)

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
Lemma Flight_numbers : Flight_statement -> (forall X, single_impact 1 (1 / 4) 2 X -> snd X = - 1 / 4 /\
  snd (apply (mpow (A 1 (1 / 4)) 2) X) = 5 / 16) /\ pattern 1 (1 / 4) Minus Plus [2%nat].
Proof.
  intros F; destruct (F 1 (1 / 4) 2%nat ltac:(numbers)) as [H1 H2]; split; [|apply H2, orbits_1_4].
  intros X HX; destruct (H1 X HX) as [-> ->]; split; numbers.
Qed.
Lemma Identities_numbers : Identities_statement -> c 1 (1 / 4) 2 = - 9 / 16 /\ p 1 (1 / 4) 1 - q 1 (1 / 4) 2 = - 5 / 16
  /\ b 1 (1 / 4) 2 1 = - 1 / 4 /\ p 1 (1 / 4) 2 + q 1 (1 / 4) 2 - 1 = - 15 / 16.
Proof.
  intros I; destruct (I 1 (1 / 4) 2%nat 1%nat ltac:(numbers) ltac:(numbers)) as (E1 & E2 & _ & E4).
  destruct (I 1 (1 / 4) 1%nat 2%nat ltac:(numbers) ltac:(numbers)) as (_ & _ & E3 & _).
  destruct (E2 ltac:(lia)) as [E2' _]; rewrite E1, E2', E3, E4; repeat split; numbers.
Qed.

(** (4, 4) is (1, 1/4) in reversed time. *)
Lemma Words_reversal_numbers : Words_reversal_statement -> p (1 / (1 / 4)) (/ (1 / 4)) 1 - q (1 / (1 / 4)) (/ (1 / 4)) 2
  = - 2 /\ (member (1 / (1 / 4)) (/ (1 / 4)) Minus 2 <-> member 1 (1 / 4) Minus 2).
Proof.
  intros R; destruct (R 1 (1 / 4) 1%nat 2%nat ltac:(lra) ltac:(numbers) ltac:(numbers)) as (_ & -> & _).
  destruct (R 1 (1 / 4) 2%nat 2%nat ltac:(lra) ltac:(numbers) ltac:(numbers)) as (_ & _ & M).
  split; [numbers | apply M].
Qed.
Lemma W1_numbers : W1_statement -> pattern 1 (1 / 4) Minus Plus [1; 2; 2; 1]%nat /\ p 1 (1 / 4) 2 < p 1 (1 / 4) 1.
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
Lemma Regions_numbers : Regions_statement -> pattern 3 (1 / 2) Plus Plus [1; 2; 3]%nat /\ ~ pattern 3 (1 / 2) Plus Minus
  [1; 2; 3]%nat /\ pattern (-3) (1 / 2) Plus Minus [4; 7]%nat /\ pattern 1 (1 / 4) Minus Plus [5]%nat.
Proof.
  intros R; assert (E4 : sqrt (1 / 4) = 1 / 2).
  { replace (1 / 4) with (1 / 2 * (1 / 2)) by field; apply sqrt_square; lra. }
  assert (X : forall l, Forall (le 1) l -> Forall (le 1) l) by trivial. split; [|split; [|split]].
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
Lemma W5_neighbours_numbers : W5_neighbours_statement -> Five_periods_statement -> p (-2 / 3) (8 / 9) 1 > q (-2 / 3)
  (8 / 9) 2 /\ ~ p (-2 / 3) (8 / 9) 2 < q (-2 / 3) (8 / 9) 1 /\ p (-2 / 3) (8 / 9) 3 < q (-2 / 3) (8 / 9) 1.
Proof.
  intros W F; destruct (W _ _ 2%nat [] 1%nat 2%nat first_five (path_start _ _ 2)) as (H1 & H2 & _).
  destruct (W _ _ 2%nat [U] 1%nat 3%nat first_five path_3) as (_ & H3 & _).
  split; [apply H1; split; [apply (five_members F); cbn; tauto | cbn [on]; numbers]|].
  split; [intros H; apply H2 in H; destruct H as [_ H]; cbn [on] in H; revert H; numbers|].
  apply H3; split; [apply (five_members F); cbn; tauto | cbn [on]; numbers].
Qed.
Lemma W5_numbers : W5_statement -> Five_periods_statement -> edge (-2 / 3) (8 / 9) Plus Plus 2 3 /\
  edge (-2 / 3) (8 / 9) Plus Minus 1 4 /\ pattern (-2 / 3) (8 / 9) Plus Plus [2; 3]%nat.
Proof.
  intros W F; destruct (W _ _ 2%nat [U; D; D] 7%nat 3%nat first_five path_7 (five_vertices F)) as [H1 H2].
  pose proof (five_ends F) as HE; split; [|split].
  - apply (H1 (2, U)%nat (3, U)%nat); cbn; tauto.
  - apply (H1 (1, D)%nat (4, D)%nat); cbn; tauto.
  - apply (H2 HE); exists [(2, U); (3, U)]%nat; split; [reflexivity|]; split; [intros x; cbn; tauto | cbn; auto].
Qed.

(** Twins: the pattern (1, 2) and period 3. *)
Lemma W4_numbers : W4_statement -> (pattern (-2 / 3) (8 / 9) Plus Plus [1; 2]%nat <-> orbit (-2 / 3) (8 / 9) 3 Plus
  Plus) /\ ~ pattern (-2 / 3) (8 / 9) Minus Plus [1; 2]%nat /\ (member (-2 / 3) (8 / 9) Minus 1 ->
  pattern (-2 / 3) (8 / 9) Minus Plus [1; 1]%nat).
Proof.
  intros W; destruct (W _ _ 2%nat first_five) as (H1 & _ & H3); split.
  - apply (H1 [] 1%nat 2%nat (path_start _ _ 2) Plus).
  - split; [|intros [Hu _]; apply H3].
    + intros H; apply H3 in H; destruct H as (_ & _ & H); inversion H as [|x l _ H'];
        inversion H' as [|x' l' [H'' _] _]; lia.
    + split; [reflexivity|]; split; [discriminate | repeat constructor; trivial; lia].
Qed.
Lemma V_finite_numbers : V_finite_statement -> exists L, ~ member (-2 / 3) (8 / 9) Plus (S L).
Proof.
  intros V; destruct (V _ _ 2%nat first_five ltac:(lra)) as [L HL]; exists L; intros H; specialize (HL _ H); lia.
Qed.

(** Where two cycles meet: at (1/2, 1/2) for e mu < 0 and gamma > 0. At s = 1/6 on r = 1, where K = 4, for e
    mu > 0 and gamma > 0, as b_{5,4} = (-1 + 1 - 1)/-1 = 1; not for gamma < 0, as no n has n/6 > 1 > (n -
    1)/6. *)
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
Lemma Words_oracle_numbers : Words_oracle_statement -> member (IZR (-6) / IZR 9) (IZR 8 / IZR 9) Plus 7 /\
  ~ member (IZR (-6) / IZR 9) (IZR 8 / IZR 9) Plus 5 /\ edge (IZR (-6) / IZR 9) (IZR 8 / IZR 9) Plus Plus 2 7 /\
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
  Period_8_statement -> pattern (trace 1 (1 / 6)) (1 ^ 2) Minus Plus [1; 2; 2]%nat /\ ~ pattern (trace 1 (8 / 49))
  (1 ^ 2) Minus Minus [1%nat] /\ pattern (trace 1 (8 / 49)) (1 ^ 2) Minus Plus [3; 1; 2]%nat /\ edge (-2 / 3) (8 / 9)
  Plus Plus 7 3 /\ b (-1 / 2) (1 / 2) 3 2 = 0 /\ orbit_at 1 (7 / 20) 8 Plus Plus /\ ~ orbit_at 1 (3 / 10) 8 Plus Plus.
Proof.
  intros R O F B P; split; [apply (R 1 ltac:(lra)); split; [discriminate | repeat constructor; tauto]|].
  split; [apply (O 1 [1%nat] ltac:(lra))|].
  split; [apply (O 1 [3; 1; 2]%nat ltac:(lra)); split; [discriminate | repeat constructor; lia]|].
  split; [apply F; cbn; tauto|]; split; [apply B|]. split; [apply P; cbn; lra|]; intros H; apply P in H; cbn in H; lra.
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
Lemma Shift_numbers : Shift_statement -> forall S gamma, grazes S 1 (1 / 4) gamma -> gamma > 0 -> exists d mu0, d > 0 /\
  mu0 > 0 /\ forall (n : Z -> nat) mu, - mu0 < e_mu S mu < 0 -> (forall i, n i = 1 \/ n i = 2)%nat -> one S mu d n.
Proof.
  intros H S gamma HS Hg; destruct (H S _ _ gamma HS ltac:(lra) 2%nat) as (d & Hd & T).
  destruct (T d ltac:(lra)) as (mu0 & Hm & T'); exists d, mu0; split; [exact Hd|]; split; [exact Hm|].
  intros n mu Hmu Hn; apply (T' n Minus Plus mu); [|cbn [sgn]; lra | cbn [sgn]; lra].
  intros i; destruct orbits_1_4, (Hn i) as [-> | ->]; split; trivial; lia.
Qed.

(** ** What definitions mean, and what statements say beyond the numbers above: each of their clauses *)
Lemma member_means a1 a2 e n : member a1 a2 e n -> (forall k, (0 < k < n)%nat -> sgn e * b a1 a2 n k > 0) /\
  u a1 a2 n <> 0.
Proof. intros [A B]; split; [intros k Hk; apply B; lia | exact A]. Qed.
Lemma pattern_means a1 a2 e g i j : pattern a1 a2 e g [i; j] -> (edge a1 a2 e g i j /\ edge a1 a2 e g j i) /\
  member a1 a2 e i /\ member a1 a2 e j.
Proof.
  intros [M C]; inversion_clear M as [|? ? Mi Mj]; inversion_clear Mj as [|? ? Mj' _].
  destruct C as [A B]; split; [split; [exact A | exact B] | split; assumption].
Qed.
Lemma first_upper_means a1 a2 K : first_upper a1 a2 K -> (0 < a2 <= 1 /\ - (a2 + 1) < a1 < 2 * sqrt a2) /\
  u a1 a2 K < 0 /\ forall k, u a1 a2 k < 0 -> (K <= k)%nat.
Proof.
  intros (A & B & C & D); split; [split; assumption|]; split; [exact C|]; intros k Hk.
  destruct (le_lt_dec K k) as [L|L]; [exact L | specialize (D k L); lra].
Qed.
Lemma ends_mean a1 a2 i j : ends a1 a2 i j -> p a1 a2 j <> q a1 a2 i /\ p a1 a2 i <> q a1 a2 j /\
  ~ member a1 a2 Plus (i + j).
Proof. intros (A & B & C); split; [exact C | split; [exact B | exact A]]. Qed.
Lemma cycles_mean a1 a2 e g : cycles a1 a2 e g -> exists v l l', (~ In v l /\ ~ In v l' /\ l <> l') /\
  walk (fun i j => edge a1 a2 e g i j /\ member a1 a2 e j /\ member a1 a2 e i) v l' v /\
  walk (fun i j => member a1 a2 e j /\ edge a1 a2 e g i j /\ member a1 a2 e i) v l v.
Proof.
  assert (X : forall (E E' : nat -> nat -> Prop), (forall i j, E i j -> E' i j) -> forall l v w, walk E v l w ->
    walk E' v l w).
  { intros E E' HE; induction l as [|z k IH]; intros x w H; [apply HE, H | destruct H; split; auto]. }
  intros (v & l & l' & D & N & N' & W & W'); exists v, l, l'; split; [auto|].
  split; [revert W' | revert W]; apply X; intros i j (A & B & C); auto.
Qed.
Lemma Words_mean : Identities_statement -> Words_reversal_statement -> forall a1 a2 n k, 0 < a2 -> u a1 a2 n <> 0 ->
  u a1 a2 k <> 0 -> u (a1 / a2) (/ a2) n <> 0 /\
  ((k <= n)%nat -> a2 ^ k * b a1 a2 n (n - k) = u a1 a2 k * (q a1 a2 k - q a1 a2 n)).
Proof.
  intros I R a1 a2 n k H2 Hn Hk; split; [apply (R a1 a2 n k H2 Hn Hk)|]; intros L.
  destruct (I a1 a2 n k Hn Hk) as (_ & A & _); apply A, L.
Qed.
Lemma W1_means : W1_statement -> forall a1 a2 e i j, 0 < a2 -> (i < j)%nat -> member a1 a2 e j ->
  (sgn e * u a1 a2 i > 0 -> q a1 a2 j < q a1 a2 i /\ p a1 a2 i < p a1 a2 j) /\
  (sgn e * u a1 a2 i < 0 -> q a1 a2 i < q a1 a2 j /\ p a1 a2 j < p a1 a2 i).
Proof.
  intros W a1 a2 e i j H2 L M; destruct (W a1 a2 e H2) as [H _]; destruct (H i j L M) as [A B].
  split; intros X; [destruct (A X) | destruct (B X)]; split; assumption.
Qed.
Lemma W2_means : W2_statement -> p 0 (1 / 2) 3 < q 0 (1 / 2) 1 -> p 0 (1 / 2) 1 < q 0 (1 / 2) 3.
Proof.
  intros W; destruct (W 0 (1 / 2) ltac:(lra) ltac:(rewrite Rabs_R0; lra)) as [_ H].
  apply (H 1%nat 3%nat ltac:(cbn [on]; numbers) ltac:(cbn [on]; numbers)).
Qed.
Lemma Path_means : Path_statement -> (forall a1 a2 K, first_upper a1 a2 K -> 4 * a2 <= a1 ^ 2 -> K = 2%nat) /\
  forall r s K w n1 n2, 0 < r <= 1 -> 0 < s < 1 / 2 -> first_upper (trace r s) (r ^ 2) K ->
  (exists m1 m2, stern s K w m1 n1 m2 n2) <-> path (trace r s) (r ^ 2) K w n1 n2.
Proof.
  intros (_ & A & B); split; [intros a1 a2 K H L; apply (A a1 a2 K H); lra|].
  intros r s K w n1 n2 Hr Hs H; symmetry; apply (B r s K Hr Hs), H.
Qed.
Lemma W3_means : W3_statement -> forall a1 a2 K, first_upper a1 a2 K -> (forall n, member a1 a2 Minus n ->
  u a1 a2 n <> 0) /\ (forall n, member a1 a2 Plus n -> (1 < n)%nat -> n <> K -> exists w i j, n = (i + j)%nat /\
  path a1 a2 K w i j) /\ forall w i j x, path a1 a2 K w i j -> member a1 a2 Plus (i + j) -> In x (vertices K w) ->
  on a1 a2 (fst x) (snd x) /\ member a1 a2 Plus (fst x).
Proof.
  intros W a1 a2 K H; destruct (W a1 a2 K H) as (A & _ & _ & B & C); split; [intros n Hn; apply A in Hn; apply Hn|];
    split.
  - intros n Hn L NK; destruct (B n Hn) as [E|[E|(w & i & j & P & E)]]; [lia | lia | exists w, i, j; split; assumption].
  - intros w i j x P M Hx; specialize (C w i j P M); rewrite Forall_forall in C; destruct (C x Hx); split; assumption.
Qed.
Lemma W5_means : W5_neighbours_statement -> forall a1 a2 K w i j, first_upper a1 a2 K -> path a1 a2 K w i j ->
  (u a1 a2 (i + j) = 0 -> a2 = 1 -> p a1 a2 i = q a1 a2 j /\ p a1 a2 j = q a1 a2 i) /\
  (p a1 a2 i = q a1 a2 j -> u a1 a2 (i + j) > 0 -> False) /\ (p a1 a2 j = q a1 a2 i -> u a1 a2 (i + j) < 0 -> False).
Proof.
  intros W a1 a2 K w i j H P; destruct (W a1 a2 K w i j H P) as (_ & _ & A & B); split; [|split].
  - intros Z E; split; [apply A | apply B]; right; split; assumption.
  - intros E L; apply A in E; cbn [on] in E; lra.
  - intros E L; apply B in E; cbn [on] in E; lra.
Qed.
Lemma W4_means : W4_statement -> forall a1 a2 K, first_upper a1 a2 K -> (forall w i j k x y, path a1 a2 K w i j ->
  In (k, x) (vertices K w) -> on a1 a2 (i + j) y -> x = y \/ k <> i /\ k <> j -> member a1 a2 Plus (i + j) ->
  pattern a1 a2 Plus (case_of x) [k; (i + j)%nat]) /\ (forall k n g, (k < n)%nat -> pattern a1 a2 Plus g [k; n] ->
  n = K /\ k = 1%nat \/ exists w i j x, (n = (i + j)%nat /\ path a1 a2 K w i j) /\ In (k, x) (vertices K w)) /\
  forall g l n, pattern a1 a2 Minus g l -> In n l -> u a1 a2 n <> 0 /\ (n < K)%nat.
Proof.
  intros W a1 a2 K H; destruct (W a1 a2 K H) as (A & B & C); split; [|split].
  - intros w i j k x y P V O N M; apply (proj2 (A w i j P (case_of x)) k x y V O N); split; [exact M | reflexivity].
  - intros k n g L P; destruct (B k n g L P) as [[E F]|(w & i & j & x & Q & E & V)]; [left; split; assumption | right].
    exists w, i, j, x; split; [split; assumption | exact V].
  - intros g l n P Hn; apply C in P; destruct P as (_ & _ & P); rewrite Forall_forall in P; destruct (P n Hn); split;
      assumption.
Qed.
Lemma Words_oracle_means : Words_oracle_statement -> p (IZR 4 / IZR 4) (IZR 1 / IZR 4) 1 - q (IZR 4 / IZR 4)
  (IZR 1 / IZR 4) 1 < 0.
Proof.
  intros O; destruct (O 4%Z 1%Z 4%Z ltac:(lia)) as (_ & E & _).
  destruct (E 1%nat 1%nat) as [(A & _) _]; [unfold u; simpl; lra | unfold u; simpl; lra | apply A; reflexivity].
Qed.
Lemma examples_mean : Pattern_1_2_statement -> Resonance_statement -> Oscillator_statement -> Boundary_statement ->
  (pattern (trace 1 (1 / 5)) 1 Minus Plus [1; 2]%nat /\ orbit (trace 1 (1 / 5)) 1 3 Plus Plus /\ pattern 1 1 Minus Plus
  [1; 2]%nat) /\ (~ pattern (trace 1 (1 / 6)) (1 ^ 2) Plus Minus [4%nat] /\ ~ pattern (trace 1 (1 / 6)) (1 ^ 2) Minus
  Plus [3%nat]) /\ (b (-1 / 2) (1 / 2) 3 2 = 0 /\ u (-1 / 2) (1 / 2) 3 < 0 /\ p (-1 / 2) (1 / 2) 1 = q (-1 / 2) (1 / 2)
  2 /\ edge (-1 / 2) (1 / 2) Plus Plus 1 2) /\ (u (-1 / 2) (1 / 4) 3 = 0 /\ edge (-1 / 2) (1 / 4) Plus Plus 1 2 /\
  edge (-1 / 2) (1 / 4) Plus Minus 2 1) /\ u (-1) 1 3 = 0 /\ p (-1) 1 1 = q (-1) 1 2 /\ p (-1) 1 2 = q (-1) 1 1.
Proof.
  intros [P1 P2] R _ (B1 & B2 & B3); destruct (P2 Minus Plus) as [Q1 _], (P2 Plus Plus) as [_ Q2].
  split; [split; [apply Q1; auto | split; [apply Q2; auto | apply P1; [lra | left; repeat split; lra]]]|].
  destruct (R 1 ltac:(lra)) as [R1 R2]; split; [|split; [|split]].
  - split; [intros H; apply R2 in H; discriminate|]; intros H; apply R1 in H; destruct H as [_ H]; inversion H; lia.
  - decompose [and] B1; repeat (split; [assumption|]); assumption.
  - decompose [and] B2; repeat (split; [assumption|]); assumption.
  - decompose [and] B3; repeat (split; [assumption|]); assumption.
Qed.
Lemma five_not_followed : Five_periods_statement -> edge (-2 / 3) (8 / 9) Plus Minus 1 4.
Proof. intros [_ H]; apply (H 1%nat 4%nat); cbn; intuition discriminate. Qed.
