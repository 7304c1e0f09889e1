(** * Numbers worked out by hand that follow from the statements about lengths and times of return

    As in [Consequences]: each lemma takes the statement as its hypothesis. *)

From Coq Require Import Reals ZArith List Arith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementWords StatementMeasure StatementReturns.
Import ListNotations. Open Scope R_scope.

(** ** Lengths: 1/10 + 1/10 + 1/20 + 1/15 + 1/10 for n = 5, and n = 8 *)

Lemma length_5 : Measure_statement -> Theorem2_count_statement -> exists L, length L = 5%nat /\
  (forall e g lo hi, In (e, g, lo, hi) L <-> interval 5 e g lo hi) /\
  sum_over length_of L = 1 / 10 + 1 / 10 + 1 / 20 + 1 / 15 + 1 / 10.
Proof.
  intros M C; destruct (C 5%nat ltac:(lia)) as (L & E & HN & H & _); exists L; split; [exact E | split; [exact H|]].
  rewrite (M 5%nat L ltac:(lia) HN H); unfold coprime_to, sum_over; simpl; lra.
Qed.
Lemma length_8 : Measure_statement -> forall L, NoDup L ->
  (forall e g lo hi, In (e, g, lo, hi) L <-> interval 8 e g lo hi) -> sum_over length_of L = 22 / 105.
Proof. intros M L HN H; rewrite (M 8%nat L ltac:(lia) HN H); unfold coprime_to, sum_over; simpl; lra. Qed.

(** ** Times of return at s = 1/6: 1 and 4 for r <= 1, and 5 too for r = 2, where b_{5,1} = -15/16 *)

Lemma no_step w m1 n1 m2 n2 : stern (1 / 6) 4 w m1 n1 m2 n2 -> ~ In 5%nat (map fst (vertices 4 w)) ->
  w = [] /\ n1 = 1%nat /\ n2 = 4%nat.
Proof.
  intros H; induction H as [|w m1 n1 m2 n2 H IH Hlt|w m1 n1 m2 n2 H IH Hlt]; [tauto | |]; intros H5; exfalso.
  all: assert (E : exists l, periods 1 4 (w ++ [D]) = periods 1 4 w ++ l /\ exists l', periods 1 4 (w ++ [U]) = periods
    1 4 w ++ l').
  all: try (clear; generalize 1%nat, 4%nat; induction w as [|[] w IH]; intros i j; cbn [app periods];
    [eexists; split; [reflexivity | eexists; reflexivity] | destruct (IH (i + j)%nat j) as (l & -> & l' & ->) |
    destruct (IH i (i + j)%nat) as (l & -> & l' & ->)]; eexists; split; [reflexivity | eexists; reflexivity |
    reflexivity | eexists; reflexivity]).
  all: destruct E as (l & E & l' & E'); assert (H5' : ~ In 5%nat (map fst (vertices 4 w))).
  all: try (intros Hin; apply H5; unfold vertices in *; cbn [map] in *; rewrite ?E, ?E', map_app; cbn [In] in *;
    rewrite in_app_iff; tauto).
  all: destruct (IH H5') as (-> & -> & ->); cbn [app periods vertices map fst In] in H5; cbn in H5; tauto.
Qed.
Lemma trace_6 r : trace r (1 / 6) = r.
Proof. unfold trace; replace (2 * PI * (1 / 6)) with (PI / 3) by field; rewrite cos_PI3; field. Qed.
Lemma returns_6 : Returns_statement -> forall n, return_time 2 4 n <-> n = 1%nat \/ n = 4%nat \/ n = 5%nat.
Proof.
  intros H n; destruct (H 2 (1 / 6) 4%nat) as [_ _ Hr _ _ _ HB]; [lra | lra | simpl; lra|].
  destruct (HB ltac:(lra)) as (w & m1 & n1 & m2 & n2 & HS & HV & HN & HT).
  assert (H5 : ~ V 2 (1 / 6) 5).
  { unfold V; rewrite trace_6; intros [Hu Hb]; specialize (Hb 1%nat ltac:(lia)); unfold b, u in Hb; simpl in Hb; lra. }
  destruct (no_step w m1 n1 m2 n2 HS) as (-> & -> & ->); [rewrite <- HV; assumption|].
  specialize (HT n); unfold T at 1 in HT; rewrite trace_6 in HT; replace (2 ^ 2) with 4 in HT by ring; rewrite HT.
  destruct (H (/ 2) (1 / 6) 4%nat) as [_ _ _ _ HW _ _]; [lra | lra | simpl; lra|].
  rewrite (HW ltac:(lra)), <- Hr, HV; cbn [vertices periods map fst In Nat.add]; split.
  - intros [[<-|[<-|[]]]|[->|[(_ & E & _)|(_ & E & _)]]]; try tauto; unfold p, u in E; simpl in E; lra.
  - intros [->|[->| ->]]; tauto.
Qed.

(** Past 1 and 3 at r = 1 and s = 13/36 < 2/5: 3 is lower, then 5 is upper, and in V. *)
Lemma V_whole : Returns_statement -> V 1 (13 / 36) 2 /\ V 1 (13 / 36) 5 /\ T (1 / 2) (13 / 36) 2.
Proof.
  intros H; destruct (H 1 (13 / 36) 2%nat) as [(_ & H2 & _) _ _ _ _ HW _]; [lra | lra | simpl; lra|].
  destruct (H (1 / 2) (13 / 36) 2%nat) as [_ (_ & HT & _) _ _ _ _ _]; [lra | lra | simpl; lra|].
  split; [exact H2 | split; [|exact HT]]; apply (HW eq_refl ([] ++ [D]) 1%nat 3%nat 1%nat 2%nat); [|simpl; lra].
  apply (stern_D (13 / 36) 2 [] 0 1 1 2); [constructor | simpl; lra].
Qed.

(** ** Entropy: between log 8/5 and log 33/20, for small mu and large *)

From Grazing Require Import StatementChaos StatementEntropy.

Lemma golden_between : 8 / 5 < golden < 33 / 20 /\ golden * golden = golden + 1.
Proof.
  assert (E : sqrt 5 * sqrt 5 = 5) by (apply sqrt_sqrt; lra); pose proof (sqrt_pos 5).
  assert (11 / 5 < sqrt 5 < 23 / 10) by (split; apply Rnot_le_lt; intros ?; nra); unfold golden; lra.
Qed.
Lemma exp_pow x n : 0 < x -> exp (INR n * ln x) = x ^ n.
Proof. intros Hx; rewrite <- ln_pow, exp_ln by ((apply pow_lt; lra) || lra); reflexivity. Qed.
Lemma entropy_between : Entropy_statement -> forall mu, mu = 1 / 1000 \/ mu = 20 -> (exists eps n0, eps > 0 /\ forall n,
  (n0 <= n)%nat -> exists L, separated (orbit_of mu) n eps L /\ (8 / 5) ^ n <= INR (length L)) /\ exists n0, forall n L,
  (n0 <= n)%nat -> separated (orbit_of mu) n (1 / 10) L -> INR (length L) <= (33 / 20) ^ n.
Proof.
  intros H mu Hmu; destruct (H mu ltac:(lra)) as [A B]; pose proof golden_between as [[G1 G2] _]; split.
  - destruct (B (ln golden - ln (8 / 5))) as (eps & n0 & He & HL); [pose proof (ln_increasing (8 / 5) golden); lra|].
    exists eps, n0; split; [assumption|]; intros n Hn; destruct (HL n Hn) as (L & HS & HE); exists L; split;
      [assumption|].
    rewrite <- exp_pow by lra; replace (ln golden - (ln golden - ln (8 / 5))) with (ln (8 / 5)) in HE by ring; exact HE.
  - destruct (A (1 / 10) (ln (33 / 20) - ln golden)) as (n0 & HL); [lra | pose proof (ln_increasing golden (33 / 20));
      lra|].
    exists n0; intros n L Hn HS; specialize (HL n L Hn HS); rewrite <- exp_pow by lra.
    replace (ln golden + (ln (33 / 20) - ln golden)) with (ln (33 / 20)) in HL by ring; exact HL.
Qed.

(** Of period 3 there are 1 1 1 and the three turns of 1 2: at least 3, at most 6, by the statement. *)
Lemma growth_3 : Growth_statement -> forall mu, mu = 1 / 1000 \/ mu = 20 -> (exists L, (3 <= length L)%nat /\
  ForallOrdPairs (apart 3 1) L /\ Forall (fun z => orbit_of mu z /\ z 7%nat = z 4%nat) L) /\ forall L,
  Forall (fun z => orbit_of mu z /\ forall k, z (k + 3)%nat = z k) L -> ForallOrdPairs (fun z z' => z 2%nat <> z' 2%nat)
  L -> (length L <= 6)%nat.
Proof.
  intros H mu Hmu; pose proof golden_between as [[G1 G2] G3]; destruct (H mu 3%nat ltac:(lra) ltac:(lia))
    as [(L & [HS HD] & HL) HU]; split.
  - exists L; split; [|split; [assumption|]].
    + apply INR_lt in HL || (apply Nat.lt_nge; intros Hn; assert (Hn' : (length L <= 2)%nat) by lia;
        apply le_INR in Hn'; simpl in HL, Hn'; nra).
    + revert HS; apply Forall_impl; intros z [HO HP]; split; [assumption | apply (HP 4%nat)].
  - intros L' HS' HD'; apply Nat.lt_succ_r, INR_lt; specialize (HU L' HS').
    apply Rle_lt_trans with (golden ^ (3 + 1)); [apply HU | replace (INR 7) with 7 by (simpl; lra); cbn [pow Nat.add];
      replace (golden * (golden * (golden * (golden * 1)))) with (golden * golden * (golden * golden)) by ring;
      rewrite G3; nra].
    clear - HD'; induction HD' as [|z l Hz _ IH]; constructor; [|assumption].
    revert Hz; apply Forall_impl; intros z' Hz; exists 2%nat; assumption.
Qed.
Lemma next_state : Period_map_statement -> forall mu z z', mu = 1 / 1000 \/ mu = 20 -> orbit_of mu z ->
  orbit_of mu z' -> z 0%nat = z' 0%nat -> fst (z 5%nat) = fst (z' 5%nat).
Proof. intros H mu z z' Hmu HO HO' E; f_equal; apply (H mu z z'); trivial; lra. Qed.

(** ** Three dimensions, A e_2 = e_1, A e_3 = e_2, B = e_2: two flights of one step leave nothing *)

From Grazing Require Import StatementOrbits StatementUniform.

Definition shift_map : Map.t := {| Map.N := 3; Map.f := fun x _ => x; Map.h := fun _ _ => 0; Map.kick := fun _ _ _ =>
  zero; Map.A := fun i k => match i, k with 0%nat, 1%nat | 1%nat, 2%nat => 1 | _, _ => 0 end; Map.phi := zero;
  Map.C := fun i => match i with 0%nat => 1 | _ => 0 end; Map.eta := 0; Map.B := fun i => match i with 1%nat => 1 |
  _ => 0 end |}.

Lemma shift_invertible : Uniform_statement -> exists K, invertible shift_map Z (fun j => (j + 1)%Z) (fun _ => 1%nat) K.
Proof.
  intros H; destruct (H shift_map (fun n => n = 1%nat) 1%nat 2%nat) as [K HK].
  - intros n ->; split; [lia|]; unfold crossing, power; cbn; lra.
  - intros w t x Hw Hx i Hi; assert (Ht : 0 <= t) by (apply Rle_trans with (Rabs (x 0%nat)); [apply Rabs_pos | apply Hx;
      cbn; lia]).
    cbn [through]; rewrite !Hw; unfold onward, crossing, power; cbn in *.
    assert (i = 0 \/ i = 1 \/ i = 2)%nat as [-> | [-> | ->]] by lia; cbn; rewrite Rabs_right; lra.
  - exists K; apply (HK Z _ (fun j => (j - 1)%Z)); [intros j; lia | reflexivity].
Qed.

(** ** Words over {1, 2}: the least root of det(I - M(z)) is that of z + z^2 = 1 *)

From Grazing Require Import StatementGraphs.

Definition one_two (i : nat) : nat := match i with O => 1%nat | _ => 2%nat end.

Lemma words_over_12 : Graph_entropy_statement -> let G := finite 2 one_two (fun _ _ => true) in
  (exists C, forall P L, NoDup L -> Forall (words G P) L -> INR (length L) <= C * (33 / 20) ^ P) /\
  exists c, c > 0 /\ forall P, exists L, NoDup L /\ Forall (words G P) L /\ c * (8 / 5) ^ P <= INR (length L).
Proof.
  intros H G; set (z := (sqrt 5 - 1) / 2); pose proof (sqrt_sqrt 5 ltac:(lra)) as E; pose proof (sqrt_pos 5).
  assert (B : 22 / 10 < sqrt 5 < 224 / 100) by (split; apply Rnot_le_lt; intros Q; nra).
  assert (Ez : z + z ^ 2 = 1) by (unfold z; nra); assert (Hz : 60 / 100 < z < 62 / 100) by (unfold z; lra).
  destruct (H 2%nat one_two (fun _ _ => true) z) as [A L].
  - intros [|i] _; cbn; lia.
  - lra.
  - exists (fun _ => 1); split; [exists 0%nat; split; [lia | lra]|]; intros i _; unfold row; cbn [sum_to one_two pow];
      cbn [pow] in Ez; lra.
  - intros t Ht (v & (i & Hi & Vi) & Ev); pose proof (Ev 0%nat ltac:(lia)) as E0; pose proof (Ev 1%nat ltac:(lia))
      as E1.
    unfold row in E0, E1; cbn [sum_to one_two pow] in E0, E1, Ez; assert (V : v 0%nat = v 1%nat) by lra;
      rewrite <- V in E0.
    assert (v 0%nat * (1 - t - t * t) = 0) by lra; assert (0 < 1 - t - t * t) by nra; assert (v 0%nat = 0) by nra.
    destruct i as [|[|i]]; [|rewrite <- V in Vi|]; lra || lia.
  - assert (Inv : / z = 1 + z) by (apply (Rmult_eq_reg_r z); [rewrite Rinv_l by lra; nra | lra]).
    assert (Hl : ln (8 / 5) < - ln z < ln (33 / 20)).
    { rewrite <- ln_Rinv, Inv by lra; split; apply ln_increasing; unfold z in *; nra. }
    split.
    + destruct (A (ln (33 / 20)) ltac:(lra)) as (C & HC); exists C; intros P l HN HF; rewrite <- exp_pow, Rmult_comm
        with (r1 := INR P) by lra; apply HC; assumption.
    + destruct (L (ln (8 / 5)) ltac:(lra)) as (c & Hc & HL); exists c; split; [exact Hc|]; intros P;
        destruct (HL P) as (l & N & F & S); exists l.
      split; [exact N | split; [exact F|]]; rewrite <- exp_pow, Rmult_comm with (r1 := INR P) by lra; exact S.
Qed.

(** The same as [grows] finds it, with the vector (1, 1): slower than (33/20)^P, and faster than (8/5)^P. *)
From Grazing Require StatementGrowth.
From Coq Require QArith.
Definition over_12 : list (positive * list nat) := [(1%positive, [0; 1]%nat); (2%positive, [0; 1]%nat)].
Lemma words_over_12_read : StatementGrowth.Growth_reader_statement ->
  at_most (StatementGrowth.graph_of over_12) (ln (33 / 20)) /\ at_least (StatementGrowth.graph_of over_12) (ln (8 / 5)).
Proof.
  intros H; set (Q := QArith_base.Qmake); destruct (H over_12 [Q 1%Z 1%positive; Q 1%Z 1%positive] (Q 8%Z 5%positive)
    (Q 33%Z 20%positive) eq_refl) as [A B].
  unfold Q2R in A, B; cbn in A, B; split; [exact A | exact B].
Qed.

(** ** Words of all patterns: slower than t^P, t = 1.839... in (+,-) and 1.568... in (+,+), and somewhere like
    1.839^P and 1.568^P *)

From Grazing Require Import StatementSuprema.

Definition no_faster (G : graph) (x : R) : Prop := exists C, forall P L, NoDup L -> Forall (words G P) L ->
  INR (length L) <= C * x ^ P.
Definition no_slower (G : graph) (x : R) : Prop := exists c, c > 0 /\ forall P, exists L, NoDup L /\
  Forall (words G P) L /\ c * x ^ P <= INR (length L).
Lemma from_logarithms G h x y : 0 < x -> 0 < y -> h < ln x -> ln y < h -> (at_most G h -> no_faster G x) /\
  (at_least G h -> no_slower G y).
Proof.
  intros Hx Hy Lx Ly; split.
  - intros A; destruct (A (ln x) Lx) as (C & HC); exists C; intros P L HN HF; rewrite <- exp_pow, Rmult_comm
      with (r1 := INR P) by exact Hx; apply HC; assumption.
  - intros A; destruct (A (ln y) Ly) as (c & Hc & HL); exists c; split; [exact Hc|]; intros P;
      destruct (HL P) as (L & N & F & S); exists L.
    split; [exact N | split; [exact F|]]; rewrite <- exp_pow, Rmult_comm with (r1 := INR P) by exact Hy; exact S.
Qed.
Lemma ln_inverse z y x : 0 < y -> 0 < z -> y * z < 1 -> 1 < x * z -> ln y < - ln z < ln x.
Proof.
  intros Hy Hz H1 H2; rewrite <- ln_Rinv by exact Hz; pose proof (Rinv_0_lt_compat z Hz); split; apply ln_increasing;
    trivial; apply (Rmult_lt_reg_r z); trivial; rewrite Rinv_l; lra.
Qed.

(** Where the statement says "below - ln z" a number less than 1/z serves. *)
Lemma slower G z : 0 < z -> below G (- ln z) -> exists x, 0 < x < / z /\ no_faster G x.
Proof.
  intros Hz (h & Hh & A); exists (exp ((h - ln z) / 2)); split.
  - split; [apply exp_pos|]; rewrite <- (exp_ln (/ z)) by (apply Rinv_0_lt_compat, Hz); rewrite ln_Rinv by exact Hz;
      apply exp_increasing; lra.
  - apply (proj1 (from_logarithms G h (exp ((h - ln z) / 2)) (exp (h - 1)) (exp_pos _) (exp_pos _) ltac:(rewrite ln_exp;
      lra) ltac:(rewrite ln_exp; lra))), A.
Qed.

(** The tribonacci constant t: at each point words grow like some x^P at most, x < t. *)
Lemma words_minus : Supremum_minus_statement -> exists t, t ^ 3 = t ^ 2 + t + 1 /\ 1839 / 1000 < t < 184 / 100 /\
  (forall a1 a2 K, first_upper a1 a2 K -> exists x, 0 < x < t /\ no_faster (patterns a1 a2 Plus Minus) x) /\
  exists a1 K, first_upper a1 1 K /\ no_slower (patterns a1 1 Plus Minus) (1839 / 1000).
Proof.
  intros (z & [Hz E] & Hn & A & B); assert (Iz : z * / z = 1) by (field; lra); exists (/ z); split;
    [field_simplify_eq; [cbn [pow] in *; lra | lra]|].
  split; [split; apply (Rmult_lt_reg_l z); lra|]; split; [intros a1 a2 K H; apply (slower _ z (proj1 Hz)),
    (A a1 a2 K H)|].
  destruct (ln_inverse z (18391 / 10000) 2) as [L1 L2]; [lra..|]; destruct (B (ln (18391 / 10000)) L1)
    as (a1 & K & H & HL); exists a1, K; split; [exact H|].
  apply (proj2 (from_logarithms _ (ln (18391 / 10000)) 2 (1839 / 1000) ltac:(lra) ltac:(lra) ltac:(apply ln_increasing;
    lra) ltac:(apply ln_increasing; lra))), HL.
Qed.
Lemma words_plus : Supremum_plus_statement -> exists z, root_plus z /\ 1568 / 1000 < / z < 157 / 100 /\
  (forall a1 a2 K, first_upper a1 a2 K -> exists x, 0 < x < / z /\ no_faster (patterns a1 a2 Plus Plus) x) /\
  exists a1 K, first_upper a1 1 K /\ no_slower (patterns a1 1 Plus Plus) (1568 / 1000).
Proof.
  intros (z & Hr & Hn & A & B); assert (Hz : 0 < z < 1) by apply Hr; assert (Iz : z * / z = 1) by (field; lra);
    exists z; split; [exact Hr|].
  split; [split; apply (Rmult_lt_reg_l z); lra|]; split; [intros a1 a2 K H; apply (slower _ z (proj1 Hz)),
    (A a1 a2 K H)|].
  destruct (ln_inverse z (15681 / 10000) 2) as [L1 L2]; [lra..|]; destruct (B (ln (15681 / 10000)) L1)
    as (a1 & K & H & HL); exists a1, K; split; [exact H|].
  apply (proj2 (from_logarithms _ (ln (15681 / 10000)) 2 (1568 / 1000) ltac:(lra) ltac:(lra) ltac:(apply ln_increasing;
    lra) ltac:(apply ln_increasing; lra))), HL.
Qed.

(** ** What definitions mean, and what statements say beyond the numbers above: each of their clauses *)
Lemma orbit_of_means mu z : orbit_of mu z -> exists N t y v, (in_two_boxes mu N t v /\ chaos_motion mu N t y v) /\
  one_or_two N /\ forall k i, (N i <= Z.of_nat k)%Z -> (Z.of_nat k < N (i + 1))%Z -> fst (z k) = t i - 2 * PI * INR k /\
  snd (z k) = v i (t i).
Proof.
  intros (N & t & y & v & A & B & C & D); exists N, t, y, v; split; [split; assumption|]; split; [exact A|].
  intros k i L L'; rewrite (D k i (conj L L')); split; reflexivity.
Qed.
Lemma apart_means n eps z z' : StatementEntropy.apart n eps z z' -> exists k, (Rabs (fst (z k) - fst (z' k)) > eps \/
  Rabs (snd (z k) - snd (z' k)) > eps) /\ (k < n)%nat.
Proof. intros (k & A & B); exists k; split; assumption. Qed.
Lemma separated_means S n eps z z' : separated S n eps [z; z'] -> (S z /\ S z') /\ StatementEntropy.apart n eps z z'.
Proof.
  intros [A B]; inversion_clear A as [|? ? A1 A2]; inversion_clear A2 as [|? ? A3 _]; inversion_clear B as [|? ? B1 _].
  inversion_clear B1; split; [split|]; assumption.
Qed.
Lemma words_mean G P i j l : words G P (i :: j :: l) -> (periods_of G i + (periods_of G j + total G l) <= P)%nat /\
  (vertex G i /\ vertex G j) /\ joined G i j /\ follows G j l.
Proof. intros (A & B & C & D & E); split; [exact A|]; split; [split; assumption | split; assumption]. Qed.
Lemma singular_means p E t : singular 1 p E t -> exists x, x <> 0 /\ x = 0 + row p E t 0 0 * x.
Proof.
  intros (v & (i & Hi & Vi) & H); replace i with 0%nat in Vi by lia; exists (v 0%nat); split;
    [exact Vi | apply (H 0%nat); lia].
Qed.
Lemma root_plus_means z : root_plus z -> (1 + z ^ 4) * (z ^ 3 / (1 - z ^ 4) + z ^ 2 / (1 - z ^ 3)) = 1 /\ z < 1 /\
  0 < z.
Proof. intros [A B]; split; [exact B | lra]. Qed.
Lemma return_time_means a1 a2 n : return_time a1 a2 n -> (0 < n)%nat /\ exists y, (forall k, (0 < k < n)%nat ->
  ~ beyond a1 a2 y k) /\ fst (apply (mpow (A a1 a2) n) (-1, y)) < -1.
Proof. intros (L & y & B & C); split; [lia|]; exists y; split; [intros k Hk; apply C; lia | exact B]. Qed.
Lemma initial_means s K S : initial_piece s K S -> (S K /\ S 1%nat) /\ (forall n, S n -> (1 < n)%nat -> n <> K ->
   exists w m1 n1 m2 n2, n = (n1 + n2)%nat /\ stern s K w m1 n1 m2 n2) /\
  forall w m1 n1 m2 n2 x, stern s K w m1 n1 m2 n2 -> S (n1 + n2)%nat -> In x (vertices K w) -> S (fst x).
Proof.
  intros (A & B & C & D); split; [split; assumption|]; split.
  - intros n Hn L NK; destruct (C n Hn) as [E|[E|(w & m1 & n1 & m2 & n2 & P & E)]]; [lia | lia|].
    exists w, m1, n1, m2, n2; split; assumption.
  - intros w m1 n1 m2 n2 x P M Hx; specialize (D w m1 n1 m2 n2 P M); rewrite Forall_forall in D; apply D, in_map, Hx.
Qed.
Lemma tie_means a1 a2 n1 n2 k : tie a1 a2 n1 n2 k ->
  (u a1 a2 (n1 + n2) > 0 -> k = (n1 + n2 + n2)%nat /\ p a1 a2 (n1 + n2) = p a1 a2 n2) /\
  (u a1 a2 (n1 + n2) < 0 -> k = (n1 + n2 + n1)%nat /\ p a1 a2 (n1 + n2) = p a1 a2 n1) /\ u a1 a2 (n1 + n2) <> 0.
Proof. intros [(A & B & C)|(A & B & C)]; repeat split; intros; try assumption; lra. Qed.
Lemma Returns_mean : Returns_statement -> forall r s K, 0 < r -> 0 < s < 1 / 2 -> 2 * (INR K - 1) * s <= 1 < 2 * INR K
  * s -> (initial_piece s K (T r s) /\ initial_piece s K (V r s)) /\ (forall n, V (/ r) s n -> V r s n) /\
  (forall n, V r s n -> T r s n) /\ (r <= 1 -> forall n, T r s n -> V r s n).
Proof.
  intros H r s K Hr Hs HK; destruct (H r s K Hr Hs HK) as [A B C D E _ _]; split; [split; assumption|].
  split; [intros n; apply C|]; split; [exact D | intros L n; apply (E L)].
Qed.
