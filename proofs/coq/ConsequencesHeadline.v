(** * What follows from the five theorems of [Headline], worked out by hand: each of their clauses is used *)
From Coq Require Import Reals ZArith List FunctionalExtensionality Lra Lia.
From Grazing Require Import Defs Statement StatementWords StatementExamples StatementOrbits StatementOrbitsPlane
  StatementUnstable StatementOscillator StatementNonlinear Headline Farey.
From Grazing Require Import StatementChaos.
Import ListNotations.
Open Scope R_scope.

Ltac numbers := unfold c, v, b, p, q, u; simpl; lra.

(** ** (a1, a2) = (1, 1/4), region 2: u = 0, 1, 1, 3/4; p = 0, -1/4, q = 1/4, 5/16, b_{2,1} = -1/4 *)
Definition over_1_2 (n : Z -> nat) : Prop := forall i, (n i = 1 \/ n i = 2)%nat.
(** Every word over {1, 2} in (-,+), in every neighbourhood, with one mu0 for all; none of them for gamma < 0,
    and none that holds a 2 for the other sign of mu. *)
Lemma Theorem_1_numbers : Theorem_1_statement -> forall S gamma, grazes S 1 (1 / 4) gamma -> exists d, d > 0 /\
  forall eps, 0 < eps <= d -> exists mu0, mu0 > 0 /\ forall (n : Z -> nat) mu, over_1_2 n ->
  (gamma > 0 -> - mu0 < e_mu S mu < 0 -> one S mu eps n) /\ (gamma < 0 -> - mu0 < e_mu S mu < 0 -> none S mu d n) /\
  (gamma > 0 -> 0 < e_mu S mu < mu0 -> n 7%Z = 2%nat -> none S mu d n).
Proof.
  intros H S gamma HG; destruct (H S 1 (1 / 4) gamma HG 2%nat) as (d & Hd & W); exists d; split; [exact Hd|].
  intros eps He; destruct (W eps He) as (mu0 & Hm & W'); exists mu0; split; [exact Hm|]; intros n mu Hn.
  assert (U : forall i, (1 <= n i <= 2)%nat /\ u 1 (1 / 4) (n i) <> 0) by (intros i; destruct (Hn i) as [-> | ->];
    split; try lia; numbers).
  split; [|split]; intros Hg Hmu; [apply (W' n Minus Plus mu U) | apply (W' n Minus Minus mu U) | intros E7; apply (W' n
    Plus Plus mu U)]; try (cbn; lra).
  - intros i; split.
    + destruct (Hn i) as [-> | ->]; split; try numbers; intros k Hk; [lia|]; replace k with 1%nat by lia; numbers.
    + destruct (Hn i) as [-> | ->], (Hn (i + 1)%Z) as [-> | ->]; unfold edge; cbn [sgn]; numbers.
  - exists 0%Z; right; destruct (Hn 0%Z) as [-> | ->], (Hn (0 + 1)%Z) as [-> | ->]; cbn [sgn]; numbers.
  - exists 7%Z; left; exists 1%nat; rewrite E7; split; [lia | cbn [sgn]; numbers].
Qed.
(** None of them is stable, not even from some impact on: of oscillators and of maps. *)
Definition stable_motion (leg : (Z -> R) -> (Z -> R -> R) -> (Z -> R -> R) -> Z -> Z -> Prop) t v : Prop := forall r,
  0 < r -> exists j eps, 0 < eps /\ forall l t' y' v', (j < l)%Z ->
  (forall i, (j <= i < l)%Z -> leg t' y' v' i (i + 1)%Z) -> Rabs (t' j - t j) <= eps -> Rabs (v' j (t' j) - v j (t j))
    <=
  eps -> Rabs (t' l - t l) <= r /\ Rabs (v' l (t' l) - v l (t l)) <= r.
Lemma not_stable leg t v : unstable_motion leg t v -> ~ stable_motion leg t v.
Proof.
  intros (r & Hr & H) St; destruct (St r Hr) as (j & eps & He & K), (H j eps He) as (l & t' & y' & v' & L & Lg & [N1 N2]
    & Out). apply Out, (K l t' y' v' L Lg N1 N2).
Qed.
Definition ones_and_twos (N : Z -> Z) : Prop := forall i, (N (i + 1) = N i + 1 \/ N (i + 1) = N i + 2)%Z.
Lemma letters N : ones_and_twos N -> exists n, over_1_2 n /\ forall i, (N (i + 1) = N i + Z.of_nat (n i))%Z.
Proof. intros H; exists (fun i => Z.to_nat (N (i + 1) - N i)%Z); split; intros i; destruct (H i); lia. Qed.
Lemma Theorem_1_unstable : Theorem_1_statement -> forall gamma, gamma > 0 -> (forall O m, grazing O m 1 (1 / 4) gamma ->
  exists mu0 d, mu0 > 0 /\ d > 0 /\ forall mu N t y v, - mu0 < mu < 0 -> ones_and_twos N -> motion O m mu d N t y v ->
  ~ stable_motion (swing O m mu d N) t v) /\ (forall O, grazing_orbit O -> generic O 1 (1 / 4) gamma 1 ->
  exists mu0 d, mu0 > 0 /\ d > 0 /\ forall mu N t y v, - mu0 < mu < 0 -> ones_and_twos N ->
  nonlinear_motion O mu d N t y v -> ~ stable_motion (leg O mu d N) t v) /\ forall M w, planar M 1 (1 / 4) gamma 1 w ->
  exists mu0 d, mu0 > 0 /\ d > 0 /\ forall mu n x, - mu0 < mu < 0 -> over_1_2 n -> orbit_near M Z (fun i => i + 1)%Z n
    mu d
  x -> exists r, 0 < r /\ forall eps, 0 < eps -> exists z i, within (Map.N M) eps (minus z (x 0%Z)) /\
  ~ within (Map.N M) r (minus (Nat.iter i (step M mu) z) (Nat.iter i (step M mu) (x 0%Z))).
Proof.
  intros H gamma Hg; assert (T := fun S G => Theorem_1_numbers H S gamma G); assert (W : forall S, grazes S 1 (1 / 4)
    gamma -> exists mu0 d, mu0 > 0 /\ d > 0 /\ forall mu n, - mu0 < e_mu S mu < 0 -> over_1_2 n -> one S mu d n).
  { intros S HS; destruct (T S HS) as (d & Hd & K), (K d ltac:(lra)) as (mu0 & Hm & Q); exists mu0, d; repeat (split;
    [lra|]).
    intros mu n Hmu Hn; apply (Q n mu Hn); assumption. }
  split; [|split].
  - intros O m HO; destruct (W (Oscillates O m) HO) as (mu0 & d & Hm & Hd & Q); exists mu0, d; repeat (split; [lra|]).
    intros mu N t y v Hmu HN HM; destruct (letters N HN) as (n & Hn & E); exact (not_stable _ _ _ (proj2 (Q mu n Hmu Hn
      N E) t y v HM)).
  - intros O HO HG; destruct (W (Moves O 1) (conj HO HG)) as (mu0 & d & Hm & Hd & Q); exists mu0, d; repeat (split;
    [lra|]).
    intros mu N t y v Hmu HN HM; destruct (letters N HN) as (n & Hn & E).
    exact (not_stable _ _ _ (proj2 (Q mu n ltac:(cbn; lra) Hn N E) t y v HM)).
  - intros M w HM; destruct (W (Steps M 1 w) HM) as (mu0 & d & Hm & Hd & Q); exists mu0, d; repeat (split; [lra|]).
    intros mu n x Hmu Hn Hx; exact (proj2 (Q mu n ltac:(cbn; lra) Hn) x 0%Z Hx).
Qed.
(** What fails is a b_{n,k} with 1 <= k <= n - 1, or (64). *)
Lemma breaks_by a1 a2 e g i j : breaks a1 a2 e g i j -> ~ sgn e * sgn g * (p a1 a2 j - q a1 a2 i) < 0 ->
  (2 <= i)%nat /\ exists k, (k < i)%nat /\ sgn e * b a1 a2 i k < 0.
Proof. intros [(k & Hk & B)|B] N; [split; [lia | exists k; split; [lia | exact B]] | contradiction]. Qed.

(** ** What [exactly] and [never] say of oscillators and of maps *)
Definition apart (N : Z -> Z) (n : nat) : Prop := forall i, (N (i + 1) = N i + Z.of_nat n)%Z.
Definition no_motion (O : Oscillator.t) (m e : sign) (n : nat) : Prop := exists d mu0, d > 0 /\ mu0 > 0 /\
  forall mu N t y v, 0 < sgn e * mu < mu0 -> apart N n -> ~ motion O m mu d N t y v.
Definition no_orbit_of (M : Map.t) (rate : R) (e : sign) (n : nat) : Prop := exists d mu0, d > 0 /\ mu0 > 0 /\
  forall mu x, 0 < sgn e * (rate * mu) < mu0 -> ~ orbit_near M Z (fun i => i + 1)%Z (fun _ => n) mu d x.
Lemma never_means a1 a2 n : never a1 a2 n -> forall gamma e, (forall O m, grazing O m a1 a2 gamma -> no_motion O m e n)
  /\ forall M rate w, planar M a1 a2 gamma rate w -> no_orbit_of M rate e n.
Proof.
  intros H gamma e; split.
  - intros O m HG; destruct (H (Oscillates O m) gamma e HG) as (d & mu0 & Hd & Hm & U); exists d, mu0.
    split; [exact Hd | split; [exact Hm|]]; intros mu N t y v Hmu HN; exact (U mu Hmu N t y v HN).
  - intros M rate w HG; destruct (H (Steps M rate w) gamma e HG) as (d & mu0 & Hd & Hm & U); exists d, mu0.
    split; [exact Hd | split; [exact Hm|]]; intros mu x Hmu; exact (U mu Hmu x).
Qed.
Lemma exactly_means a1 a2 n g : exactly a1 a2 n Plus g -> forall gamma, (forall O m, grazing O m a1 a2 gamma ->
  no_motion O m Minus n /\ (sgn g * gamma < 0 -> no_motion O m Plus n) /\ (sgn g * gamma > 0 -> exists d, d > 0 /\
  forall eps, 0 < eps <= d -> exists mu0, mu0 > 0 /\ forall mu N, 0 < mu < mu0 -> apart N n -> one_motion O m mu eps N))
  /\ forall M rate w, planar M a1 a2 gamma rate w -> no_orbit_of M rate Minus n /\
  (sgn g * gamma < 0 -> no_orbit_of M rate Plus n) /\ (sgn g * gamma > 0 -> exists d, d > 0 /\ forall eps,
  0 < eps <= d -> exists mu0, mu0 > 0 /\ forall mu, 0 < rate * mu < mu0 -> one_orbit M Z (fun i => i + 1)%Z (fun _ => n)
  mu eps).
Proof.
  intros H gamma; split.
  - intros O m HG; destruct (H (Oscillates O m) gamma HG) as [B U].
    assert (N0 : forall e, (e = Plus -> sgn g * gamma > 0 -> False) -> no_motion O m e n).
    { intros e E; destruct (U e) as (d & mu0 & Hd & Hm & T); [tauto|]; exists d, mu0.
      split; [exact Hd | split; [exact Hm|]]; intros mu N t y v Hmu HN; exact (T mu Hmu N t y v HN). }
    split; [apply N0; discriminate|]; split; [intros Hg; apply N0; lra|]; intros Hg.
    destruct (B Hg) as (d & Hd & T); exists d; split; [exact Hd|]; intros eps He; destruct (T eps He) as (mu0 & Hm &
      T').
    exists mu0; split; [exact Hm|]; intros mu N Hmu HN; apply (T' mu); [cbn; lra | exact HN].
  - intros M rate w HG; destruct (H (Steps M rate w) gamma HG) as [B U].
    assert (N0 : forall e, (e = Plus -> sgn g * gamma > 0 -> False) -> no_orbit_of M rate e n).
    { intros e E; destruct (U e) as (d & mu0 & Hd & Hm & T); [tauto|]; exists d, mu0.
      split; [exact Hd | split; [exact Hm|]]; intros mu x Hmu; exact (T mu Hmu x). }
    split; [apply N0; discriminate|]; split; [intros Hg; apply N0; lra|]; intros Hg.
    destruct (B Hg) as (d & Hd & T); exists d; split; [exact Hd|]; intros eps He; destruct (T eps He) as (mu0 & Hm &
      T').
    exists mu0; split; [exact Hm|]; intros mu Hmu; apply (T' mu); cbn; lra.
Qed.
(** Between two stops n counts half periods: with n = 1 the second impact is half a period after the first. *)
Lemma half_periods O mu d N t y v : motion O Minus mu d N t y v -> apart N 1 -> Rabs (t 1%Z - t 0%Z - PI) <= 2 * d.
Proof.
  intros HM HN; destruct (HM 0%Z 1%Z eq_refl) as [_ A _ _ _ _ _ _], (HM 1%Z 2%Z eq_refl) as [_ B _ _ _ _ _ _].
  pose proof (HN 0%Z) as E; cbn in E; rewrite E, plus_IZR in B; cbn [turn Z.of_nat] in *.
  unfold Rabs in *; repeat destruct Rcase_abs; lra.
Qed.

(** ** The intervals of periods 4 and 5 *)
Lemma of_4 (F : Farey 1 4) : m_plus F = 0%nat /\ n_plus F = 1%nat /\ m_minus F = 1%nat /\ n_minus F = 3%nat.
Proof.
  destruct F as [mp np mm nm HF]; cbn [m_plus n_plus m_minus n_minus].
  assert (A : neighbours 1 4 0 1 1 3) by (unfold neighbours; lia); apply (neighbours_unique _ _ _ _ _ _ A) in HF;
    inversion HF; subst; auto.
Qed.
Lemma interval_4 e g lo hi : interval 4 e g lo hi -> hi <= 1 / 3.
Proof.
  intros [|k g' lo' hi' [m F Hm|m F Hm]]; [simpl; lra| |]; assert (E : m = 1%nat) by lia; subst m; [simpl; lra|].
  destruct (of_4 F) as (_ & _ & -> & ->); simpl; lra.
Qed.
Lemma side_4 : side 4 3 Plus (1 / 8) (1 / 4).
Proof.
  pose proof (left_side 4 1 (Build_Farey 1 4 0 1 1 3 ltac:(unfold neighbours; lia)) ltac:(lia)) as H; cbn in H.
  replace (1 / (2 * (1 + 1 + 1 + 1))) with (1 / 8) in H by field; replace (1 + 1 + 1 + 1) with 4 in H by ring; exact H.
Qed.
(** Every period just above 0; period 4 between 1/8 and 1/4, and not between 1/3 and 1/2. *)
Lemma Theorem_2_numbers : Theorem_2_statement -> (forall n s, (3 <= n)%nat -> 0 < s < 1 / (2 * INR n) ->
  exactly (2 * cos (2 * PI * s)) 1 n Minus Plus) /\ (forall s, 1 / 8 < s < 1 / 4 -> exactly (2 * cos (2 * PI * s)) 1 4
  Plus Plus) /\ forall s, 1 / 3 < s < 1 / 2 -> u (2 * cos (2 * PI * s)) 1 4 <> 0 -> never (2 * cos (2 * PI * s)) 1 4.
Proof.
  intros T; split; [|split].
  - intros n s Hn Hs; assert (L : 1 / (2 * INR n) <= 1 / 6).
    { apply le_INR in Hn; simpl in Hn; unfold Rdiv; rewrite !Rmult_1_l; apply Rinv_le_contravar; lra. }
    apply (T n s Hn ltac:(lra)) with (lo := 0) (hi := 1 / (2 * INR n)); [constructor | exact Hs].
  - intros s Hs; apply (T 4%nat s ltac:(lia) ltac:(lra)) with (lo := 1 / 8) (hi := 1 / 4); [|exact Hs].
    apply (beside 4 3), side_4.
  - intros s Hs Hu; apply (T 4%nat s ltac:(lia) ltac:(lra)); [|exact Hu].
    intros e g lo hi HI; right; pose proof (interval_4 e g lo hi HI); lra.
Qed.

(** ** Conjecture 1 *)
(** What lies above a graph, one point at a time. *)
Definition above_graph (n k : nat) (g : sign) (lo hi : R) (Rad : R -> R) : Prop := forall r s, 0 < r <= 1 ->
  lo < s < hi -> let a1 := 2 * r * cos (2 * PI * s) in let a2 := r ^ 2 in
  (0 <= Rad s < 1 /\ continuity_pt Rad s) /\ u a1 a2 n <> 0 /\ (r > Rad s -> exactly a1 a2 n Plus g) /\
  (r < Rad s -> never a1 a2 n) /\ (b a1 a2 n k = 0 <-> r = Rad s) /\
  forall j, (0 < j < n)%nat -> j <> k -> r = Rad s -> 0 < b a1 a2 n j.
Lemma area_above n k g lo hi Rad : area n k g lo hi Rad -> above_graph n k g lo hi Rad.
Proof.
  intros H r s Hr Hs; destruct (H s Hs) as (A & C & P); destruct (P r Hr) as (U & X & Y & Z & W).
  split; [split; [exact A | exact C]|]; split; [exact U|]; split; [intros L; exact (X L)|]; split; [exact Y|]; split.
  - split; intros E; [symmetry; apply Z, E | apply Z; symmetry; exact E].
  - intros j Hj Hk E; apply (W (eq_sym E) j); [lia | exact Hk].
Qed.
Definition tends_up (Rad : R -> R) (lo hi end_ : R) : Prop := forall x, x < 1 -> exists h, 0 < h /\
  forall s, lo < s < hi -> end_ - h < s < end_ + h -> Rad s > x.
Lemma tends_1 Rad lo hi x : tends_to_1 Rad lo hi x -> tends_up Rad lo hi x.
Proof.
  intros H y Hy; destruct (H y Hy) as (h & Hh & T); exists h; split; [exact Hh|]; intros s Hs Hn; apply T; [exact Hs|].
  apply Rabs_def1; lra.
Qed.
(** A circle of any radius r < 1 meets an area in one interval within (lo, hi). *)
Definition one_arc (Rad : R -> R) (lo hi : R) : Prop := forall r, 0 < r < 1 -> exists lo' hi', lo <= lo' /\ hi' <= hi /\
  forall s, lo < s < hi -> (lo' < s < hi' <-> Rad s < r).
Lemma extends_arc n k g lo hi : extends n k g lo hi -> exists Rad, above_graph n k g lo hi Rad /\
  tends_up Rad lo hi lo /\ tends_up Rad lo hi hi /\ one_arc Rad lo hi.
Proof.
  intros (Rad & A & L & H & S); exists Rad; split; [apply area_above, A|]; split; [apply tends_1, L|].
  split; [apply tends_1, H|]; intros r Hr; destruct (S r Hr) as (lo' & hi' & E1 & E2 & E); exists lo', hi'.
  split; [exact E1|]; split; [exact E2|]; intros s Hs; symmetry; apply E, Hs.
Qed.

(** First bullet, every n. Second, n = 4: over (1/8, 1/4), where b_{4,3} = 0; the graph is 0 up to 1/6. *)
Lemma bullet_1 : Conjecture_1_statement -> forall n r s, (3 <= n)%nat -> 0 < r <= 1 -> 0 < s < 1 / (2 * INR n) ->
  exactly (2 * r * cos (2 * PI * s)) (r ^ 2) n Minus Plus.
Proof. intros C n r s Hn Hr Hs; apply (first_area _ _ (C n Hn)); assumption. Qed.
Lemma bullet_2 : Conjecture_1_statement -> exists Rad, above_graph 4 3 Plus (1 / 8) (1 / 4) Rad /\
  tends_up Rad (1 / 8) (1 / 4) (1 / 4) /\ (forall s, 1 / 8 < s <= 1 / 6 -> Rad s = 0) /\
  forall r, 0 < r < 1 -> exists s', 1 / 8 < s' <= 1 / 4 /\ forall s, 1 / 8 < s < 1 / 4 -> (s < s' <-> Rad s < r).
Proof.
  intros C; destruct (second_area _ _ (C 4%nat ltac:(lia))) as (Rad & A & T & Z & S); cbn [Nat.sub] in A; exists Rad.
  replace (1 / (2 * INR 4)) with (1 / 8) in * by (simpl; field); replace (1 / INR 4) with (1 / 4) in * by (simpl;
    field).
  replace (1 / (2 * (INR 4 - 1))) with (1 / 6) in * by (simpl; field).
  split; [apply area_above, A|]; split; [apply tends_1, T|]; split; [exact Z|]; intros r Hr.
  destruct (S r Hr) as (s' & Hs' & E); exists s'; split; [exact Hs'|]; intros s Hs; symmetry; apply E, Hs.
Qed.
(** Third, region 3, n = 3: over (1/3, 1/2), where b_{3,1} = 0. *)
Lemma bullet_3 : Conjecture_1_statement -> exists Rad, above_graph 3 1 Minus (1 / 3) (1 / 2) Rad /\
  tends_up Rad (1 / 3) (1 / 2) (1 / 3).
Proof.
  intros C; destruct (leftmost_area _ _ (C 3%nat ltac:(lia))) as ((Rad & A & T) & _); [exists 1%nat; reflexivity|]; cbn
    [Nat.sub] in A; exists Rad.
  replace ((INR 3 - 1) / (2 * INR 3)) with (1 / 3) in * by (simpl; field); split; [apply area_above, A | apply tends_1,
    T].
Qed.
Lemma trace_sqrt a2 n s : s = (INR n - 1) / (2 * INR n) -> trace (sqrt a2) s = 2 * sqrt a2 * cos (2 * PI * s).
Proof. reflexivity. Qed.
(** Third, region 4: b_{3,1} = (a1 + 1)(a1 - a2 - 1)/(a1^2 - a2) is 0 at a1 = -1, so the area of period 3 ends there. *)
Lemma bullet_3_left : Conjecture_1_statement -> forall a1 a2, 0 < a2 < 1 ->
  (- (a2 + 1) < a1 < - 1 -> exactly a1 a2 3 Plus Minus) /\ (- 1 < a1 < - sqrt a2 -> never a1 a2 3).
Proof.
  intros C a1 a2 H2; destruct (leftmost_area _ _ (C 3%nat ltac:(lia))) as [_ A]; [exists 1%nat; reflexivity|].
  destruct (A a2 H2) as (a1s & Hs & H); rewrite (trace_sqrt a2 3 _ eq_refl) in *.
  replace (2 * PI * ((INR 3 - 1) / (2 * INR 3))) with (PI - PI / 3) in * by (simpl; field).
  rewrite Rtrigo_facts.cos_pi_minus, cos_PI3 in *; assert (L : sqrt a2 < 1) by (rewrite <- sqrt_1; apply sqrt_lt_1;
    lra).
  destruct (H (-1) ltac:(lra)) as (_ & _ & _ & Z & _); cbn [Nat.sub] in Z.
  assert (E : a1s = -1) by (apply Z; unfold b, u; simpl; field_simplify_eq; lra); subst; split; intros Ha; apply H; lra.
Qed.
(** Period 5: on the boundary, which is at one place, only b_{5,3} vanishes. *)
Lemma bullet_3_boundary : Conjecture_1_statement -> forall a2, 0 < a2 < 1 -> let hi :=
  2 * sqrt a2 * cos (2 * PI * ((INR 5 - 1) / (2 * INR 5))) in (forall a1, - (a2 + 1) < a1 < hi -> u a1 a2 5 <> 0) /\
  exists a1, - (a2 + 1) < a1 < hi /\ b a1 a2 5 3 = 0 /\ b a1 a2 5 1 > 0 /\ b a1 a2 5 2 > 0 /\ b a1 a2 5 4 > 0 /\
  forall a1', - (a2 + 1) < a1' < hi -> b a1' a2 5 3 = 0 -> a1' = a1.
Proof.
  intros C a2 H2 hi; destruct (leftmost_area _ _ (C 5%nat ltac:(lia))) as [_ A]; [exists 2%nat; reflexivity|].
  destruct (A a2 H2) as (a1 & Hs & H); rewrite (trace_sqrt a2 5 _ eq_refl) in *; fold hi in Hs, H; cbn [Nat.sub] in H.
  split; [intros a1' Ha; apply (H a1' Ha)|]; exists a1; split; [exact Hs|].
  destruct (H a1 Hs) as (_ & _ & _ & Z & W); split; [apply Z; reflexivity|].
  split; [|split; [|split]]; try (apply W; [reflexivity | lia | lia]). intros a1' Ha B; symmetry; apply (H a1' Ha), B.
Qed.
(** Fourth and fifth: (1/3, 3/8) and (3/8, 2/5) of period 8, and (1/4, 1/3) of period 4. *)
Lemma bullets_4_5 : Conjecture_1_statement -> extends 8 5 Plus (1 / 3) (3 / 8) /\ extends 8 3 Minus (3 / 8) (2 / 5) /\
  extends 4 1 Minus (1 / 4) (1 / 3).
Proof.
  intros C; pose proof (left_areas _ _ (C 8%nat ltac:(lia))) as H4; pose proof (right_areas _ _ (C 8%nat ltac:(lia))) as
    H5.
  pose proof (right_areas _ _ (C 4%nat ltac:(lia))) as H.
  set (F := Build_Farey 3 8 1 3 2 5 ltac:(unfold neighbours; lia)); set (G := Build_Farey 1 4 0 1 1 3 ltac:(unfold
    neighbours; lia)).
  specialize (H4 3%nat F ltac:(lia) ltac:(cbn; lia)); specialize (H5 3%nat F ltac:(lia) ltac:(cbn; lia)).
  specialize (H 1%nat G ltac:(lia) ltac:(cbn; lia)); cbn [F G m_plus n_plus m_minus n_minus Nat.sub] in *.
  replace (INR 3) with 3 in * by (simpl; lra); replace (INR 8) with 8 in * by (simpl; lra).
  replace (INR 2) with 2 in * by (simpl; lra); replace (INR 5) with 5 in * by (simpl; lra).
  replace (INR 4) with 4 in * by (simpl; lra); replace (INR 1) with 1 in * by reflexivity; auto.
Qed.
(** No others: all intervals of periods 4 and 5; none elsewhere, in region 3 or, for even n, in region 4. *)
Lemma no_other : Conjecture_1_statement -> (forall e g lo hi, interval 4 e g lo hi -> (e, g, lo, hi) = (Minus, Plus, 0,
  1 / 8) \/ (e, g, lo, hi) = (Plus, Plus, 1 / 8, 1 / 4) \/ (e, g, lo, hi) = (Plus, Minus, 1 / 4, 1 / 3)) /\
  (forall e g lo hi, interval 5 e g lo hi -> (e, g, lo, hi) = (Minus, Plus, 0, 1 / 10) \/ (e, g, lo, hi) = (Plus, Plus,
  1 / 10, 1 / 5) \/ (e, g, lo, hi) = (Plus, Minus, 1 / 5, 1 / 4) \/ (e, g, lo, hi) = (Plus, Plus, 1 / 3, 2 / 5) \/
  (e, g, lo, hi) = (Plus, Minus, 2 / 5, 1 / 2)) /\ (forall r s, 0 < r < 1 -> 1 / 3 < s < 1 / 2 -> u_at r s 4 <> 0 ->
  never (2 * r * cos (2 * PI * s)) (r ^ 2) 4) /\ forall n a1 a2, (2 <= n)%nat -> 0 < a2 < 1 -> - (a2 + 1) < a1 <= - 2
  * sqrt a2 -> never a1 a2 (2 * n).
Proof.
  assert (X : forall (e e' g g' : sign) (x x' y y' : R), (e, g, x, y) = (e', g', x', y') -> e = e' /\ g = g' /\ x = x'
    /\ y = y') by (intros e e' g g' x x' y y' E; injection E; auto).
  assert (Y : forall (e g : sign) (x x' y y' : R), x = x' -> y = y' -> (e, g, x, y) = (e, g, x', y')) by congruence.
  intros C; split; [|split; [|split]].
  - intros e g lo hi HI; pose proof (no_others _ _ (C 4%nat ltac:(lia))) as H.
    destruct (H e g lo hi HI) as [E|[E|[[[k O] _]|(m & F & Hm & [[Hp E]|[Hq E]])]]]; [left | right; left | lia | |
      right; right]; [| |assert (m = 1%nat) as -> by lia; destruct (of_4 F) as (Z & _); lia|assert (m = 1%nat) as -> by
      lia; destruct (of_4 F) as (_ & _ & Em & En); rewrite Em, En in E]; apply X in E; destruct E as (-> & -> & -> &
      ->); apply Y; simpl; field.
  - intros e g lo hi HI; pose proof (no_others _ _ (C 5%nat ltac:(lia))) as H.
    assert (F5 : forall m, (0 < 2 * m < 5)%nat -> forall F : Farey m 5, m = 1%nat /\ m_plus F = 0%nat /\ m_minus F =
      1%nat /\ n_minus F = 4%nat \/ m = 2%nat /\ m_plus F = 1%nat /\ n_plus F = 3%nat /\ m_minus F = 1%nat /\ n_minus F
      = 2%nat).
    { intros m Hm [mp np mm nm HF]; unfold neighbours in HF; cbn [m_plus n_plus m_minus n_minus].
      assert (m = 1 \/ m = 2)%nat as [-> | ->] by lia; [left | right]; lia. }
    destruct (H e g lo hi HI) as [E|[E|[[_ E]|(m & F & Hm & [[Hp E]|[Hq E]])]]]; [left | right; left | right; right;
      right; right | right; right; right; left | right; right; left]; try (destruct (F5 m Hm F) as [(-> & E1 & E2 &
      E3)|(-> & E1 & E2 & E3 & E4)]; [try lia | try lia]); try rewrite E1, E2 in E; try rewrite E2, E3 in E; apply X in
      E; destruct E as (-> & -> & -> & ->); apply Y; simpl; field.
  - intros r s Hr Hs Hu; apply (none_in_3 _ _ (C 4%nat ltac:(lia)) r s Hr ltac:(lra) Hu); intros e g lo hi HI L; pose
      proof (interval_4 e g lo hi HI); lra.
  - intros n a1 a2 Hn H2 H1; apply (none_in_4 _ _ (C (2 * n)%nat ltac:(lia))); trivial; exists n; reflexivity.
Qed.

(** ** The word theorem at (-2/3, 8/9): 1, 2, 3, 4, 7, with the word U, D, D *)
Lemma first_five : first_upper (-2 / 3) (8 / 9) 2.
Proof.
  pose proof (sqrt_pos (8 / 9)); split; [lra|]; split; [lra|]; split; [cbn [on]; numbers|].
  intros k Hk; assert (k = 0 \/ k = 1)%nat as [-> | ->] by lia; numbers.
Qed.
Lemma path_7 : path (-2 / 3) (8 / 9) 2 [U; D; D] 7 3.
Proof.
  apply (path_D _ _ 2 [U; D] 4 3); [apply (path_D _ _ 2 [U] 1 3); [apply (path_U _ _ 2 [] 1 2 (path_start _ _ 2))|]|];
    cbn [on]; numbers.
Qed.
Lemma five_vertices : Five_periods_statement ->
  Forall (fun x => member (-2 / 3) (8 / 9) Plus (fst x)) (vertices 2 [U; D; D]).
Proof. intros [F _]; repeat constructor; apply F; cbn; tauto. Qed.
Lemma five_ends : Five_periods_statement -> ends (-2 / 3) (8 / 9) 7 3.
Proof. intros [F _]; split; [intros H; apply F in H; cbn in H; lia|]; split; unfold p, q, u; simpl; lra. Qed.

(** 2 and 3 follow each other for gamma > 0, where 1 does not follow 1; for gamma < 0 it does, and 2 does not
    follow 2. *)
Lemma Words_numbers : Words_statement -> Five_periods_statement -> forall S gamma, grazes S (-2 / 3) (8 / 9) gamma ->
  exists d, d > 0 /\ forall eps, 0 < eps <= d -> exists mu0, mu0 > 0 /\ forall mu, 0 < e_mu S mu < mu0 ->
  (gamma > 0 -> one S mu eps (fun i => if Z.even i then 2 else 3)%nat /\ none S mu d (fun _ => 1%nat)) /\
  (gamma < 0 -> one S mu eps (fun _ => 1%nat) /\ none S mu d (fun _ => 2%nat)).
Proof.
  intros W F S gamma HS; destruct (W _ _ 2%nat first_five) as [_ H].
  destruct (H _ _ _ path_7 (five_vertices F) (five_ends F)) as [_ T]; destruct (T S gamma HS) as (d & Hd & T').
  exists d; split; [exact Hd|]; intros eps He; destruct (T' eps He) as (mu0 & Hm & T2); exists mu0; split; [exact Hm|].
  intros mu Hmu; split; intros Hg; split.
  - destruct (T2 (fun i => if Z.even i then (2, U) else (3, U))%nat Plus mu) as [E _]; [intros i; destruct (Z.even i);
      cbn; tauto | cbn [sgn]; lra | exact Hmu|].
    replace (fun i => if Z.even i then 2%nat else 3%nat) with (fun i => fst (if Z.even i then (2%nat, U) else (3%nat,
      U))) by (apply functional_extensionality; intros i; destruct (Z.even i); reflexivity).
    apply E; intros i; destruct (Z.even i), (Z.even (i + 1)); reflexivity.
  - apply (T2 (fun _ => (1, D))%nat Plus mu); [intros i; cbn; tauto | cbn [sgn]; lra | exact Hmu|].
    exists 0%Z; cbn; discriminate.
  - apply (T2 (fun _ => (1, D))%nat Minus mu); [intros i; cbn; tauto | cbn [sgn]; lra | exact Hmu | reflexivity].
  - apply (T2 (fun _ => (2, U))%nat Minus mu); [intros i; cbn; tauto | cbn [sgn]; lra | exact Hmu|].
    exists 0%Z; cbn; discriminate.
Qed.
(** That this word is the whole of V; that with damping V's word ends, and satisfies (52) up to there. *)
Lemma Words_vertices : Words_statement -> Five_periods_statement ->
  (forall n, member (-2 / 3) (8 / 9) Plus n -> n = 1 \/ n = 2 \/ n = 3 \/ n = 4 \/ n = 7)%nat /\
  forall a1 a2 K, first_upper a1 a2 K -> a2 < 1 -> exists w i j, path a1 a2 K w i j /\ member a1 a2 Plus K /\
  (forall n, In n (map fst (vertices K w)) -> member a1 a2 Plus n) /\ ~ member a1 a2 Plus (i + j).
Proof.
  intros W F; split.
  - destruct (W _ _ 2%nat first_five) as [_ H]; destruct (H _ _ _ path_7 (five_vertices F) (five_ends F)) as [V _].
    intros n Hn; apply V in Hn; cbn in Hn; lia.
  - intros a1 a2 K HK H2; destruct (W a1 a2 K HK) as [E _]; destruct (E H2) as (w & i & j & P & A & N); exists w, i, j.
    rewrite Forall_forall in A; split; [exact P|]; split; [apply (A (K, U)); cbn; tauto|]; split; [|exact N].
    intros n Hn; apply in_map_iff in Hn; destruct Hn as (x & <- & Hx); apply A, Hx.
Qed.

(** ** Chaos: for every mu > 0 and every word over {1, 2} a motion, and no second one *)
Lemma Chaos_numbers : Headline.Chaos_statement -> forall mu N, mu > 0 -> one_or_two N ->
  (exists t y v, chaos_motion mu N t y v /\ in_two_boxes mu N t v) /\ forall t y v t' y' v', chaos_motion mu N t y v ->
  chaos_motion mu N t' y' v' -> in_two_boxes mu N t v -> in_two_boxes mu N t' v' -> forall i x, t i = t' i /\
  y i x = y' i x /\ v i x = v' i x.
Proof.
  intros H mu N Hmu HN; destruct (H mu N Hmu HN) as (t0 & y0 & v0 & M & B & U); split; [exists t0, y0, v0; auto|].
  intros t y v t' y' v' M1 M2 B1 B2 i x; destruct (U _ _ _ M1 B1 i x) as (-> & -> & ->), (U _ _ _ M2 B2 i x) as (-> & ->
    & ->).
  auto.
Qed.
