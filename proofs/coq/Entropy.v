(** * The motions over {1, 2} are a shift: two impacts are one or two periods apart, hence the golden ratio

    An orbit is close to another as long as both have impacts in the same periods, and far from it where one
    has an impact and the other has none. So separated orbits are counted by words of 0 and 1 without 00. *)

From Coq Require Import Reals ZArith List Arith Lra Lia Classical.
From Grazing Require Import Statement StatementChaos Derivatives Chaos ChaosContinuous Count GoldenWords
  StatementEntropy.
Import ListNotations. Open Scope R_scope.

(** ** Close and far *)

Definition with_N (mu : R) (N : Z -> Z) (z : nat -> R * R) : Prop := one_or_two N /\ exists t y v, chaos_motion mu N t y
  v /\ in_two_boxes mu N t v /\ forall k i, (N i <= Z.of_nat k < N (i + 1))%Z -> z k = (t i - 2 * PI * INR k,
  v i (t i)).

Lemma orbit_with_N mu z : orbit_of mu z <-> exists N, with_N mu N z.
Proof.
  split; [intros (N & t & y & v & S & M & B & H); exists N; split; [assumption | exists t, y, v; auto]|].
  intros (N & S & t & y & v & M & B & H); exists N, t, y, v; auto.
Qed.

Lemma close mu N N' z z' K k : mu > 0 -> with_N mu N z -> with_N mu N' z' ->
  (forall j, (Z.of_nat k - 2 * Z.of_nat K - 5 <= j <= Z.of_nat k + 2 * Z.of_nat K + 5)%Z -> hit N j <-> hit N' j) ->
  Rabs (fst (z k) - fst (z' k)) <= 3 * (7 / 8) ^ K /\ Rabs (snd (z k) - snd (z' k)) <= 2 * mu * (7 / 8) ^ K.
Proof.
  intros Hmu (S & t & y & v & M & B & H) (S' & t' & y' & v' & M' & B' & H') Hh.
  destruct (last_exists N S (Z.of_nat k)) as (i & Hi), (last_exists N' S' (Z.of_nat k)) as (i' & Hi').
  rewrite (H k i Hi), (H' k i' Hi'); cbn [fst snd].
  assert (E : N i = N' i' /\ (Z.of_nat k - 1 <= N i)%Z).
  { destruct (last_in N S _ i Hi) as [P Q], (last_in N' S' _ i' Hi') as [P' Q'];
      specialize (Hh (Z.of_nat k) ltac:(lia)).
    destruct (classic (hit N (Z.of_nat k))) as [X|X]; [rewrite (P X), (P' (proj1 Hh X)) | rewrite (Q X), Q' by tauto];
      lia. }
  assert (Mv : forall mu N t y v i, chaos_motion mu N t y v -> chaos_motion mu (fun j => N (i + j)%Z) (fun j =>
    t (i + j)%Z) (fun j => y (i + j)%Z) (fun j => v (i + j)%Z)).
  { intros ? ? ? ? ? l HM a b ->; destruct (HM (l + a)%Z (l + (a + 1))%Z ltac:(lia)); constructor; assumption. }
  assert (Bv : forall mu N t v i, in_two_boxes mu N t v -> in_two_boxes mu (fun j => N (i + j)%Z) (fun j => t (i + j)%Z)
    (fun j => v (i + j)%Z)).
  { intros ? ? ? ? l HB a b ->; apply HB; lia. }
  assert (Sv : forall N i, one_or_two N -> one_or_two (fun j => N (i + j)%Z)).
  { intros N0 l HN a; replace (l + (a + 1))%Z with (l + a + 1)%Z by lia; apply HN. }
  pose proof (Chaos_continuous mu _ _ _ _ _ _ _ _ K Hmu (Sv N i S) (Sv N' i' S') (Mv _ _ _ _ _ i M) (Bv _ _ _ _ i B)
    (Mv _ _ _ _ _ i' M') (Bv _ _ _ _ i' B')) as C; cbv beta in C; rewrite !Z.add_0_r in C.
  replace (t i - 2 * PI * INR k - (t' i' - 2 * PI * INR k)) with (t i - t' i') by ring. apply C; clear C; intros l Hl.
  apply (agree (fun j => N (i + j)%Z) (fun j => N' (i' + j)%Z) (N i) (K + 2)); [auto | auto | f_equal; lia |
    rewrite Z.add_0_r; lia | | lia].
  assert (Hs : forall N i k, hit (fun j => N (i + j)%Z) k <-> hit N k).
  { intros N0 n0 m; split; intros (j & Hj); [exists (n0 + j)%Z; exact Hj | exists (j - n0)%Z; rewrite <- Hj; f_equal;
      lia]. }
  intros j Hj; rewrite !Hs; apply Hh; lia.
Qed.

Lemma far_apart mu N N' z z' n k : with_N mu N z -> with_N mu N' z' -> (k < n)%nat -> hit N (Z.of_nat k) ->
  ~ hit N' (Z.of_nat k) -> apart n 1 z z' /\ apart n 1 z' z.
Proof.
  intros (S & t & y & v & M & B & H) (S' & t' & y' & v' & M' & B' & H') Hk Hh Hh'.
  destruct (last_exists N S (Z.of_nat k)) as (i & Hi), (last_exists N' S' (Z.of_nat k)) as (i' & Hi').
  pose proof (proj1 (last_in N S _ i Hi) Hh) as E; pose proof (proj2 (last_in N' S' _ i' Hi') Hh') as E'.
  pose proof (chaos_near _ _ _ _ _ i M) as T; pose proof (chaos_near _ _ _ _ _ i' M') as T'.
  rewrite E, <- INR_IZR_INZ in T; rewrite E', minus_IZR, <- INR_IZR_INZ in T'.
  assert (HPI : 3 < PI) by (pose proof PI2_3_2; unfold PI2 in *; lra).
  assert (F : fst (z k) - fst (z' k) > 1) by (rewrite (H k i Hi), (H' k i' Hi'); cbn [fst]; lra).
  split; exists k; (split; [assumption | left]); [rewrite Rabs_right | rewrite Rabs_left]; lra.
Qed.

(** ** Periodic words *)

Definition number (w : list Z) (i : Z) : Z :=
  let m := Z.of_nat (length w) in (sum w * (i / m) + sum (firstn (Z.to_nat (i mod m)) w))%Z.

Lemma sum_firstn w : forall k, (k < length w)%nat -> sum (firstn (S k) w) = (sum (firstn k w) + nth k w 0)%Z.
Proof.
  induction w as [|x w IH]; intros k Hk; [cbn in Hk; lia|]; destruct k as [|k]; [cbn; lia|].
  specialize (IH k ltac:(cbn in Hk; lia)); cbn [firstn nth sum fold_right] in *;
    fold (sum (firstn k w)) (sum (firstn (S k) w)) in *; lia.
Qed.
Lemma sum_firstn_le w : over_12 w -> forall k, (0 <= sum (firstn k w) <= sum w)%Z.
Proof.
  induction 1 as [|x w Hx _ IH]; intros k; [rewrite firstn_nil; cbn; lia|].
  destruct k as [|k]; cbn [firstn sum fold_right]; fold (sum w); [specialize (IH 0%nat); cbn in IH; lia|].
  fold (sum (firstn k w)); specialize (IH k); lia.
Qed.

Section Word.
Variable w : list Z.
Hypothesis some : (0 < length w)%nat.
Hypothesis over : over_12 w.
Let m := Z.of_nat (length w).

Lemma letter k : (k < length w)%nat -> (nth k w 0 = 1 \/ nth k w 0 = 2)%Z.
Proof. intros Hk; unfold over_12 in over; rewrite Forall_forall in over; apply over, nth_In, Hk. Qed.

Lemma number_next i : number w (i + 1) = (number w i + nth (Z.to_nat (i mod m)) w 0)%Z.
Proof.
  assert (Pm : (0 < m)%Z) by (unfold m; lia); pose proof (Z.mod_pos_bound i m Pm) as B;
    pose proof (Z.div_mod i m ltac:(lia)) as E.
  pose proof (sum_firstn w (Z.to_nat (i mod m)) ltac:(unfold m in *; lia)) as F; unfold number; fold m.
  destruct (Z.eq_dec (i mod m) (m - 1)) as [L|L].
  - replace (i + 1)%Z with ((i / m + 1) * m)%Z by lia; rewrite Z.div_mul, Z.mod_mul by lia.
    rewrite firstn_all2 in F by (unfold m in *; lia); cbn [Z.to_nat firstn sum fold_right]; lia.
  - assert (((i + 1) / m = i / m)%Z /\ ((i + 1) mod m = i mod m + 1)%Z) as [-> ->].
    { split; [symmetry; apply (Z.div_unique _ _ _ (i mod m + 1)) | symmetry; apply (Z.mod_unique _ _ (i / m))]; lia. }
    replace (Z.to_nat (i mod m + 1)) with (S (Z.to_nat (i mod m))) by lia; lia.
Qed.

Lemma number_steps : one_or_two (number w).
Proof.
  intros i; rewrite number_next; pose proof (Z.mod_pos_bound i m ltac:(unfold m; lia)).
  destruct (letter (Z.to_nat (i mod m))) as [-> | ->]; [unfold m in *; lia | lia | lia].
Qed.

Lemma number_period i : (number w (i + m) = number w i + sum w)%Z.
Proof. unfold number; fold m; replace (i + m)%Z with (i + 1 * m)%Z by lia; rewrite Z.div_add, Z.mod_add by (unfold m;
    lia); lia. Qed.

Lemma number_prefix k : (k < length w)%nat -> number w (Z.of_nat k) = sum (firstn k w).
Proof. intros H; unfold number; rewrite Z.div_small, Z.mod_small, Nat2Z.id by lia; lia. Qed.

Lemma periodic_orbit mu P : mu > 0 -> sum w = Z.of_nat P -> exists z, with_N mu (number w) z /\ forall k,
  z (k + P)%nat = z k.
Proof.
  intros Hmu E; destruct (Chaos_oscillator mu (number w) Hmu number_steps) as (t & y & v & M & B & _).
  set (N := number w) in *; pose proof number_steps as S; fold N in S.
  exists (fun k => let i := last N (Z.of_nat k) in (t i - 2 * PI * INR k, v i (t i))); split.
  - split; [assumption|]; exists t, y, v; repeat (split; [assumption|]); intros k i Hi; cbv zeta.
    rewrite (last_unique N S (Z.of_nat k) (last N (Z.of_nat k)) i (last_spec N S _) Hi); reflexivity.
  - intros k; cbv zeta; pose proof (last_spec N S (Z.of_nat k)) as L; set (i := last N (Z.of_nat k)) in *.
    pose proof (number_period i) as Ei; pose proof (number_period (i + 1)) as Ej; fold N in Ei, Ej.
    rewrite (last_unique N S (Z.of_nat (k + P)) (last N (Z.of_nat (k + P))) (i + m) (last_spec N S _)).
    2: { replace (i + m + 1)%Z with (i + 1 + m)%Z by lia; lia. }
    destruct (Chaos_periodic mu N t y v m (Z.of_nat P) Hmu S M B) with (i := i) (x := t i) as (T & _ & V).
    { intros j; rewrite <- E; apply number_period. }
    rewrite T at 1; rewrite T, V, plus_INR, (INR_IZR_INZ P); f_equal; ring.
Qed.
End Word.

Lemma first_difference w : forall w', over_12 w -> over_12 w' -> sum w = sum w' -> w <> w' -> exists k,
  (k < length w)%nat /\ (k < length w')%nat /\ sum (firstn k w) = sum (firstn k w') /\ nth k w 0%Z <> nth k w' 0%Z.
Proof.
  assert (Pos : forall x w, over_12 (x :: w) -> (sum (x :: w) > 0)%Z).
  { intros x l H; inversion_clear H as [|? ? Hx Hl]; pose proof (sum_firstn_le l Hl 0); cbn in *; fold (sum l) in *;
      lia. }
  induction w as [|x w IH]; intros [|y w'] H H' E D; [tauto | specialize (Pos _ _ H'); cbn in *; lia |
    specialize (Pos _ _ H); cbn in *; lia|].
  destruct (Z.eq_dec x y) as [<-|Hxy]; [|exists 0%nat; cbn; repeat split; lia || assumption].
  inversion_clear H; inversion_clear H'; destruct (IH w') as (k & A & B & C & F); auto;
    [cbn in *; fold (sum w) (sum w') in *; lia | congruence|].
  exists (S k); cbn [length firstn nth sum fold_right] in *; fold (sum (firstn k w)) (sum (firstn k w')); repeat split;
    lia || assumption.
Qed.

Lemma words_apart mu w w' z z' P : over_12 w -> over_12 w' -> sum w = Z.of_nat P -> sum w' = Z.of_nat P -> w <> w' ->
  with_N mu (number w) z -> with_N mu (number w') z' -> apart P 1 z z'.
Proof.
  intros O O' E E' D HZ HZ'; destruct (first_difference w w' O O' ltac:(congruence) D) as (k & Hk & Hk' & Es & En).
  assert (Sym : forall w w' z z', over_12 w -> over_12 w' -> sum w' = Z.of_nat P -> (k < length w)%nat ->
    (k < length w')%nat -> sum (firstn k w) = sum (firstn k w') -> nth k w 0%Z = 1%Z -> nth k w' 0%Z = 2%Z ->
    with_N mu (number w) z -> with_N mu (number w') z' -> apart P 1 z z' /\ apart P 1 z' z).
  { clear; intros w w' z z' O O' E' Hk Hk' Es L L' HZ HZ'.
    pose proof (number_next w ltac:(lia) (Z.of_nat k)) as A; pose proof (number_next w' ltac:(lia) (Z.of_nat k)) as A'.
    rewrite Z.mod_small, Nat2Z.id, number_prefix, L in A by lia; rewrite Z.mod_small, Nat2Z.id, number_prefix, L' in A'
      by lia.
    pose proof (sum_firstn_le w O k) as [B _]; pose proof (sum_firstn_le w' O' (S k)) as [_ B'];
      rewrite sum_firstn in B' by assumption.
    set (c := (sum (firstn k w) + 1)%Z) in *.
    apply (far_apart mu (number w) (number w') z z' P (Z.to_nat c)); [assumption | assumption | unfold c; lia | |];
      rewrite Z2Nat.id by (unfold c; lia); [exists (Z.of_nat k + 1)%Z; exact A|].
    replace c with (number w' (Z.of_nat k) + 1)%Z by (rewrite number_prefix by lia; unfold c; lia).
    apply skipped; [apply number_steps; [lia | assumption] | rewrite number_prefix by lia; lia]. }
  destruct (letter w O k Hk) as [L|L], (letter w' O' k Hk') as [L'|L']; try congruence.
  - apply (proj1 (Sym w w' z z' O O' E' Hk Hk' Es L L' HZ HZ')).
  - apply (proj2 (Sym w' w z' z O' O E Hk' Hk (eq_sym Es) L' L HZ' HZ)).
Qed.

Lemma Forall2_pairs {A B} (R : A -> B -> Prop) (Q : B -> B -> Prop) l l' : Forall2 R l l' -> NoDup l ->
  (forall a a' b b', In a l -> In a' l -> a <> a' -> R a b -> R a' b' -> Q b b') -> ForallOrdPairs Q l'.
Proof.
  induction 1 as [|a b l l' Hab HF IH]; intros HN HQ; constructor; inversion_clear HN as [|? ? Ha HN'].
  - apply Forall_forall; intros b' Hb'; destruct (proj2 (Forall2_find _ _ _ HF) b' Hb') as (a' & Ha' & Hab').
    apply (HQ a a'); cbn; auto; intros ->; tauto.
  - apply IH; [assumption|]; intros x x' c c' Hx Hx' D Hc Hc'; apply (HQ x x'); cbn; tauto.
Qed.

Lemma many mu P : mu > 0 -> (1 <= P)%nat -> exists L,
  separated (fun z => orbit_of mu z /\ forall k, z (k + P)%nat = z k) P 1 L /\ golden ^ P <= INR (length L) * golden.
Proof.
  intros Hmu HP; destruct (legs_content P) as (HW & _ & HN & _).
  destruct (choose_list (fun w z => with_N mu (number w) z /\ forall k, z (k + P)%nat = z k) (fst (legs P))) as [L HF].
  { intros w Hw; destruct (HW w Hw) as [E O]; apply periodic_orbit; try assumption; destruct w; cbn in *; lia. }
  exists L; split; [split|].
  - apply Forall_forall; intros z Hz; destruct (proj2 (Forall2_find _ _ _ HF) z Hz) as (w & _ & HZ & HPz).
    split; [apply orbit_with_N; eauto | assumption].
  - apply (Forall2_pairs _ _ _ _ HF HN); intros w w' z z' Hw Hw' D [HZ _] [HZ' _].
    destruct (HW w Hw), (HW w' Hw'); apply (words_apart mu w w'); assumption.
  - rewrite <- (Forall2_length_eq _ _ _ HF); apply legs_count.
Qed.

(** ** Counting by marks *)

Lemma counted {A B} (Code : A -> B -> Prop) (D : A -> A -> Prop) L W : ForallOrdPairs D L ->
  (forall z, In z L -> exists w, Code z w /\ In w W) -> (forall z z' w, In z L -> In z' L -> Code z w -> Code z' w ->
  ~ D z z') -> (length L <= length W)%nat.
Proof.
  intros HD HC HI; destruct (choose_list (fun z w => Code z w /\ In w W) L HC) as [W' HF].
  rewrite (Forall2_length_eq _ _ _ HF); apply NoDup_incl_length.
  - revert HI; clear HC; revert HD; induction HF as [|z w L W' [Hz _] HF IH]; intros HD HI; constructor;
      inversion_clear HD as [|? ? Hz' HD'].
    + intros Hw; destruct (proj2 (Forall2_find _ _ _ HF) w Hw) as (z' & Hin & Hc & _); rewrite Forall_forall in Hz'.
      apply (HI z z' w); cbn; auto.
    + apply IH; [assumption|]; intros x x' c Hx Hx' Hc Hc'; apply (HI x x' c); cbn; tauto.
  - intros w Hw; destruct (proj2 (Forall2_find _ _ _ HF) w Hw) as (z & _ & _ & H); exact H.
Qed.

Definition code (N : Z -> Z) (a : Z) (w : list bool) : Prop :=
  forall j, (j < length w)%nat -> nth j w true = true <-> hit N (a + Z.of_nat j).

Lemma code_exists N len : forall a, exists w, length w = len /\ code N a w.
Proof.
  induction len as [|len IH]; intros a; [exists []; split; [reflexivity | intros j Hj; cbn in Hj; lia]|].
  destruct (IH (a + 1)%Z) as (w & Hl & Hw); destruct (classic (hit N a)) as [H|H];
    [exists (true :: w) | exists (false :: w)]; (split; [cbn; lia|]); intros [|j] Hj; cbn [nth];
    try (rewrite Z.add_0_r; split; [tauto || discriminate | tauto]); cbn in Hj; rewrite (Hw j) by lia;
    replace (a + 1 + Z.of_nat j)%Z with (a + Z.of_nat (S j))%Z by lia; reflexivity.
Qed.
Lemma code_no_00 N a w : one_or_two N -> code N a w -> no_00 w.
Proof.
  intros S H j Hj; rewrite (H j), (H (Datatypes.S j)) by lia.
  replace (a + Z.of_nat (Datatypes.S j))%Z with (a + Z.of_nat j + 1)%Z by lia; apply one_of_two, S.
Qed.
Lemma code_same N N' a w j : code N a w -> code N' a w -> (a <= j < a + Z.of_nat (length w))%Z -> hit N j <-> hit N' j.
Proof.
  intros H H' Hj; pose proof (H (Z.to_nat (j - a)) ltac:(lia)) as X; pose proof (H' (Z.to_nat (j - a)) ltac:(lia))
    as X'.
  replace (a + Z.of_nat (Z.to_nat (j - a)))%Z with j in X, X' by lia; tauto.
Qed.

Lemma at_most mu n eps K L : mu > 0 -> 3 * (7 / 8) ^ K <= eps -> 2 * mu * (7 / 8) ^ K <= eps -> separated (orbit_of mu)
  n eps L -> INR (length L) <= golden ^ (n + 4 * K + 11).
Proof.
  intros Hmu H1 H2 [HS HD]; set (a := (- 2 * Z.of_nat K - 5)%Z); set (len := (n + 4 * K + 10)%nat).
  rewrite Forall_forall in HS; apply Rle_trans with (INR (length (fst (marks len)))).
  - apply le_INR, (counted (fun z w => exists N, with_N mu N z /\ length w = len /\ code N a w) (apart n eps));
      [assumption | |].
    + intros z Hz; destruct (proj1 (orbit_with_N mu z) (HS z Hz)) as (N & HZ); destruct (code_exists N len a)
        as (w & Hl & Hw).
      exists w; split; [eauto|]; apply marks_complete; [|assumption]; apply (code_no_00 N a w); [apply HZ | assumption].
    + intros z z' w Hz Hz' (N & HZ & Hl & HC) (N' & HZ' & _ & HC') (k & Hk & HA).
      destruct (close mu N N' z z' K k Hmu HZ HZ') as [C1 C2]; [|lra].
      intros j Hj; apply (code_same N N' a w j HC HC'); rewrite Hl; unfold a, len; lia.
  - replace (n + 4 * K + 11)%nat with (len + 1)%nat by (unfold len; lia); apply marks_count.
Qed.

Lemma hit_seen mu N z k : with_N mu N z -> hit N (Z.of_nat k) <-> fst (z k) > -3.
Proof.
  intros (S & t & y & v & M & B & H); destruct (last_exists N S (Z.of_nat k)) as (i & Hi); rewrite (H k i Hi);
    cbn [fst].
  destruct (last_in N S _ i Hi) as [P Q]; pose proof (chaos_near _ _ _ _ _ i M) as T.
  assert (HPI : 3 < PI) by (pose proof PI2_3_2; unfold PI2 in *; lra).
  destruct (classic (hit N (Z.of_nat k))) as [X|X]; [rewrite (P X) in T | rewrite (Q X), minus_IZR in T];
    rewrite <- INR_IZR_INZ in T; split; intros; try tauto; lra.
Qed.

Lemma tends_0 c x : (forall K, Rabs x <= c * (7 / 8) ^ K) -> x = 0.
Proof.
  intros H; destruct (Req_dec x 0) as [|Hx]; [assumption | exfalso]; apply Rabs_pos_lt in Hx.
  assert (Hc : 0 < c) by (specialize (H 0%nat); cbn in H; lra).
  destruct (pow_lt_1_zero (7 / 8) ltac:(rewrite Rabs_right; lra) (Rabs x / c) ltac:(apply Rdiv_lt_0_compat; lra))
    as [K HK].
  specialize (HK K ltac:(lia)); rewrite Rabs_right in HK by (apply Rle_ge, pow_le; lra).
  apply (Rmult_lt_compat_l c) in HK; [|assumption]; replace (c * (Rabs x / c)) with (Rabs x) in HK by (field; lra).
  specialize (H K); lra.
Qed.

Theorem Growth : Growth_statement.
Proof.
  intros mu P Hmu HP; cbv zeta; pose proof golden_facts as [G _]; split.
  - destruct (many mu P Hmu HP) as (L & HL & Hc); exists L; split; [assumption|].
    destruct P as [|P]; [lia|]; cbn [pow Nat.sub] in *; rewrite Nat.sub_0_r. apply (Rmult_le_reg_l golden); lra.
  - intros L HL HD; rewrite Forall_forall in HL; apply Rle_trans with (INR (length (fst (marks P))));
      [|apply marks_count].
    apply le_INR, (counted (fun z w => exists N, with_N mu N z /\ length w = P /\ code N 0 w) (fun z z' => exists k,
      z k <> z' k)); [assumption | |].
    + intros z Hz; destruct (proj1 (orbit_with_N mu z) (proj1 (HL z Hz))) as (N & HZ); destruct (code_exists N P 0)
        as (w & Hl & Hw).
      exists w; split; [eauto|]; apply marks_complete; [|assumption]; apply (code_no_00 N 0 w); [apply HZ | assumption].
    + intros z z' w Hz Hz' (N & HZ & Hl & HC) (N' & HZ' & _ & HC') (k & Hk); apply Hk; clear Hk.
      assert (Per : forall z q k, In z L -> z (k + q * P)%nat = z k).
      { intros x q l Hx; induction q as [|q IH]; [f_equal; lia|]; replace (l + S q * P)%nat with (l + q * P + P)%nat
          by lia.
        rewrite (proj2 (HL x Hx)); exact IH. }
      assert (Same : forall j, (0 <= j)%Z -> hit N j <-> hit N' j).
      { intros j Hj; replace j with (Z.of_nat (Z.to_nat j)) by lia; rewrite (hit_seen mu N z), (hit_seen mu N' z')
          by assumption.
        pose proof (Nat.div_mod (Z.to_nat j) P ltac:(lia)) as E;
          pose proof (Nat.mod_upper_bound (Z.to_nat j) P ltac:(lia)).
        replace (Z.to_nat j) with (Z.to_nat j mod P + Z.to_nat j / P * P)%nat by lia; rewrite !Per by assumption.
        rewrite <- (hit_seen mu N z), <- (hit_seen mu N' z') by assumption; apply (code_same N N' 0 w); trivial; lia. }
      assert (Close : forall K, Rabs (fst (z k) - fst (z' k)) <= 3 * (7 / 8) ^ K /\ Rabs (snd (z k) - snd (z' k)) <= 2
        * mu * (7 / 8) ^ K).
      { intros K; rewrite <- (Per z (2 * K + 5)%nat k Hz), <- (Per z' (2 * K + 5)%nat k Hz').
        apply (close mu N N'); try assumption; intros j Hj; apply Same; nia. }
      rewrite (surjective_pairing (z k)), (surjective_pairing (z' k)); f_equal; apply Rminus_diag_uniq;
        [apply (tends_0 3) | apply (tends_0 (2 * mu))]; intros K; apply Close.
Qed.

Theorem Entropy : Entropy_statement.
Proof.
  intros mu Hmu; pose proof golden_facts as [G _]; assert (Hl : 0 < ln golden) by (rewrite <- ln_1; apply ln_increasing;
    lra).
  assert (Pow : forall n, golden ^ n = exp (INR n * ln golden)).
  { intros n; rewrite <- ln_pow, exp_ln by ((apply pow_lt; lra) || lra); reflexivity. }
  assert (Large : forall x eta, eta > 0 -> exists n0, forall n, (n0 <= n)%nat -> x <= INR n * eta).
  { intros x eta He; destruct (archimed (x / eta)) as [H0 _]; exists (Z.to_nat (up (x / eta))); intros n Hn.
    assert (IZR (up (x / eta)) <= INR n) by (rewrite INR_IZR_INZ; apply IZR_le; lia).
    replace x with (x / eta * eta) by (field; lra); apply Rmult_le_compat_r; lra. }
  split.
  - intros eps eta He Heta.
    assert (HK : exists K, 3 * (7 / 8) ^ K <= eps /\ 2 * mu * (7 / 8) ^ K <= eps).
    { destruct (pow_lt_1_zero (7 / 8) ltac:(rewrite Rabs_right; lra) (eps / (3 + 2 * mu)) ltac:(apply Rdiv_lt_0_compat;
        lra)) as [K HK].
      exists K; specialize (HK K ltac:(lia)); pose proof (pow_lt (7 / 8) K ltac:(lra)); rewrite Rabs_right in HK by lra.
      apply (Rmult_lt_compat_l (3 + 2 * mu)) in HK; [|lra].
      replace ((3 + 2 * mu) * (eps / (3 + 2 * mu))) with eps in HK by (field; lra); split; nra. }
    destruct HK as (K & H1 & H2); destruct (Large (INR (4 * K + 11) * ln golden) eta Heta) as [n0 H0].
    exists n0; intros n L Hn HL; specialize (H0 n Hn); apply (Rle_trans _ _ _ (at_most mu n eps K L Hmu H1 H2 HL)).
    rewrite Pow; replace (n + 4 * K + 11)%nat with (n + (4 * K + 11))%nat by lia; rewrite plus_INR.
    destruct (Req_dec ((INR n + INR (4 * K + 11)) * ln golden) (INR n * (ln golden + eta))) as [-> | Hne]; [lra|].
    left; apply exp_increasing; lra.
  - intros eta Heta; destruct (Large (ln golden) eta Heta) as [n0 H0]; exists 1, (S n0); split; [lra|]; intros n Hn.
    destruct (many mu n Hmu ltac:(lia)) as (L & [HS HD] & Hc); exists L; split.
    + split; [|assumption]; revert HS; apply Forall_impl; tauto.
    + specialize (H0 n ltac:(lia)); apply (Rmult_le_reg_r golden); [lra|]; apply Rle_trans with (golden ^ n);
        [|assumption].
      rewrite Pow; rewrite <- (exp_ln golden) at 2 by lra; rewrite <- exp_plus.
      destruct (Req_dec (INR n * (ln golden - eta) + ln golden) (INR n * ln golden)) as [-> | Hne]; [lra|].
      left; apply exp_increasing; lra.
Qed.

(** ** The state says what comes next *)

Theorem Period_map : Period_map_statement.
Proof.
  intros mu z z' Hmu (N & t & y & v & S & M & B & H) (N' & t' & y' & v' & S' & M' & B' & H') E k.
  destruct (last_exists N S 0) as (i & Hi), (last_exists N' S' 0) as (i' & Hi').
  assert (HPI : 3 < PI) by (pose proof PI2_3_2; unfold PI2 in *; lra).
  assert (Same : forall i i', t i = t' i' -> N i = N' i').
  { clear - M M' HPI; intros i i' Et; pose proof (chaos_near _ _ _ _ _ i M) as T;
      pose proof (chaos_near _ _ _ _ _ i' M') as T'.
    rewrite Et in T; destruct (Ztrichotomy (N i) (N' i')) as [L|[L|L]]; [exfalso | assumption | exfalso].
    - assert (IZR (N i) + 1 <= IZR (N' i')) by (rewrite <- plus_IZR; apply IZR_le; lia); nra.
    - assert (IZR (N' i') + 1 <= IZR (N i)) by (rewrite <- plus_IZR; apply IZR_le; lia); nra. }
  assert (Next : forall i i', t i = t' i' -> v i (t i) = v' i' (t' i') -> t (i + 1)%Z = t' (i' + 1)%Z /\
    v (i + 1)%Z (t (i + 1)%Z) = v' (i' + 1)%Z (t' (i' + 1)%Z)).
  { clear - M M'; rewrite chaos_words in M, M'; intros i i' Et Ev; destruct (M i _ eq_refl)
      as (F & _ & Lt & Y & Yn & Above & _ & V).
    destruct (M' i' _ eq_refl) as (F' & _ & Lt' & Y' & Yn' & Above' & _ & V').
    assert (Eq : forall x, y i x = y' i' x /\ v i x = v' i' x).
    { intros x; destruct (paper_moved _ _ (t i) x F) as [A A'], (paper_moved _ _ (t' i') x F') as [C C'].
      rewrite A, A', C, C', Ev, Y, Y', Et; split; reflexivity. }
    assert (Et' : t (i + 1)%Z = t' (i' + 1)%Z).
    { destruct (Rtotal_order (t (i + 1)%Z) (t' (i' + 1)%Z)) as [L|[L|L]]; [exfalso | assumption | exfalso].
      - specialize (Above' (t (i + 1)%Z) ltac:(lra)); rewrite <- (proj1 (Eq _)), Yn in Above'; lra.
      - specialize (Above (t' (i' + 1)%Z) ltac:(lra)); rewrite (proj1 (Eq _)), Yn' in Above; lra. }
    split; [assumption|]; rewrite Et', (proj2 (Eq _)) in V; rewrite Et'; lra. }
  assert (All : forall d, t (i + Z.of_nat d)%Z = t' (i' + Z.of_nat d)%Z /\ v (i + Z.of_nat d)%Z (t (i + Z.of_nat d)%Z)
    = v' (i' + Z.of_nat d)%Z (t' (i' + Z.of_nat d)%Z)).
  { induction d as [|d [IH1 IH2]].
    - rewrite !Z.add_0_r; rewrite (H 0%nat i Hi), (H' 0%nat i' Hi') in E; injection E as E1 E2; split;
        [lra | assumption].
    - replace (i + Z.of_nat (Datatypes.S d))%Z with (i + Z.of_nat d + 1)%Z by lia.
      replace (i' + Z.of_nat (Datatypes.S d))%Z with (i' + Z.of_nat d + 1)%Z by lia; apply Next; assumption. }
  destruct (last_exists N S (Z.of_nat k)) as (l & Hl).
  assert (i <= l)%Z by (destruct (Z_le_gt_dec i l) as [|L]; [assumption|];
    pose proof (increasing N S (l + 1) i ltac:(lia)); lia).
  replace l with (i + Z.of_nat (Z.to_nat (l - i)))%Z in Hl by lia; set (d := Z.to_nat (l - i)) in *.
  assert (Hl' : (N' (i' + Z.of_nat d) <= Z.of_nat k < N' (i' + Z.of_nat d + 1))%Z).
  { rewrite <- (Same _ _ (proj1 (All d))); replace (i' + Z.of_nat d + 1)%Z with (i' + Z.of_nat (Datatypes.S d))%Z
      by lia.
    rewrite <- (Same _ _ (proj1 (All (Datatypes.S d)))); replace (i + Z.of_nat (Datatypes.S d))%Z
      with (i + Z.of_nat d + 1)%Z by lia; exact Hl. }
  rewrite (H k _ Hl), (H' k _ Hl'); destruct (All d) as [-> ->]; reflexivity.
Qed.
