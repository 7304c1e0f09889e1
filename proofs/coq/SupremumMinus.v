(** * Case (+,-): below the logarithm of the tribonacci constant, whatever the point *)

From Coq Require Import Reals ZArith List Arith Bool Lra Lia Classical.
From Grazing Require Import Defs Statement StatementWords StatementGraphs StatementReaderWords Algebra WordAlgebra
  WordPath WordGraph WordPatterns WordPlane GraphWords.
From Grazing Require Import StatementSuprema PatternSums PatternCylinders Endless.
Import ListNotations. Open Scope R_scope.

Lemma numbers_minus z : root_minus z -> 5436 / 10000 < z < 5437 / 10000 -> z ^ 2 = z * z /\
  z / (1 - z ^ 2) * (1 + z ^ 2) = 1 /\ 0.2955 < z ^ 2 < 0.2957 /\ 1.419 < / (1 - z ^ 2) < 1.421 /\ z ^ 13 <= 1 / 2500.
Proof.
  intros [Hz E] B; assert (E2 : z ^ 2 = z * z) by ring; split; [exact E2|]; assert (B2 : 0.2954 < z ^ 2 < 0.2957)
    by (rewrite E2; nra).
  assert (B2' : 0.2955 < z ^ 2 < 0.2957) by (split; [|lra]; rewrite E2; nra); split;
    [field_simplify_eq; [cbn [pow] in *; lra | lra]|]; split; [exact B2'|]; split.
  - split; apply (Rmult_lt_reg_r (1 - z ^ 2)); try lra; rewrite Rinv_l; lra.
  - assert (z ^ 4 <= 0.0875) by (replace (z ^ 4) with (z ^ 2 * z ^ 2) by ring; nra);
      assert (0 <= z ^ 4) by (apply pow_le; lra).
    assert (z ^ 8 <= 0.00766) by (replace (z ^ 8) with (z ^ 4 * z ^ 4) by ring; nra);
      assert (0 <= z ^ 8) by (apply pow_le; lra).
    assert (z ^ 12 <= 0.000671) by (replace (z ^ 12) with (z ^ 8 * z ^ 4) by ring; nra); assert (0 <= z ^ 12)
      by (apply pow_le; lra).
    replace (z ^ 13) with (z ^ 12 * z) by ring; nra.
Qed.

Lemma periods_D j a : forall i v, In v (periods i j (repeat D a)) -> exists k, (1 <= k <= a)%nat /\
  v = ((i + k * j)%nat, D).
Proof.
  induction a as [|a IH]; intros i v H; cbn [repeat periods] in H; [destruct H|]; destruct H as [<-|H];
    [exists 1%nat; split; [lia | f_equal; lia]|].
  destruct (IH _ _ H) as (k & Hk & ->); exists (S k); split; [lia | f_equal; lia].
Qed.

Section Minus.
Variables (a1 a2 z : R).
Hypotheses (Hroot : root_minus z) (Hnum : 5436 / 10000 < z < 5437 / 10000).
Notation small := (below (patterns a1 a2 Plus Minus) (- ln z)).
Notation member := (member a1 a2 Plus).

Lemma minus_large_K K : first_upper a1 a2 K -> (3 <= K)%nat -> small.
Proof.
  intros first HK; exists (- ln 0.5437); split; [apply Ropp_lt_contravar, ln_increasing; lra|]; clear Hroot Hnum;
    generalize (eq_refl 0.5437); generalize 0.5437 at -1.
  clear z; intros z Ez; assert (B2 : 0.2955 < z ^ 2 < 0.2957) by (rewrite <- Ez; lra);
    set (t := z ^ (1 + K) / (1 - z ^ Nat.min 1 K)).
  assert (P3 : z ^ K <= 0.1608) by (apply Rle_trans with (z ^ 3); [apply pow_z_le; [lra | exact HK] | cbn [pow] in *;
    nra]).
  assert (PK : 0 < z ^ K) by (apply pow_lt; lra); assert (Ht : 0 <= t <= 0.1918).
  { unfold t; replace (Nat.min 1 K) with 1%nat by lia; rewrite pow_1; cbn [Nat.add pow]; split.
    - apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; lra].
    - apply (Rmult_le_reg_r (1 - z)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; nra. }
  apply (cylinder a1 a2 K first z Minus (fun _ => 1) 1 t [] 1 K (word_start a1 a2 K first)); [lra | lra | intros; lra |
    | |].
  - intros X HN HX; apply (later_sum a1 a2 K first z [] 1 K X); [lra | constructor | exact HN | exact HX].
  - assert (Full : weighed_sum z (fun _ => 1) (vertices K []) <= 0.5437 + 0.1608) by (unfold weighed_sum;
      cbn [vertices periods sum_of fst]; lra).
    intros x _; apply Rle_trans with (weighed_sum z (fun _ => 1) (vertices K []) + t * 1); [|lra];
      apply Rplus_le_compat_r.
    unfold weighed_sum; change (vertices K []) with [(1%nat, D); (K, U)]; cbn [filter];
      destruct (allowed K [] Minus x (1%nat, D)), (allowed K [] Minus x (K, U)); cbn [sum_of fst]; rewrite ?pow_1; lra.
  - unfold weighed_sum; cbn [vertices periods sum_of fst]; lra.
Qed.

Hypothesis first : first_upper a1 a2 2.
Notation in_word := (in_word a1 a2 2).

(** D^a: the lower periods are 1, 3, ..., 2a + 1, 2 alone is upper. *)
Lemma minus_odd a : (forall n, member n -> n = 2%nat /\ side a1 a2 n = U \/ (exists k, (k < a + 1)%nat /\
  n = (1 + 2 * k)%nat) /\ side a1 a2 n = D) -> small.
Proof.
  intros H; destruct (numbers_minus z Hroot Hnum) as (E2 & ES & B2 & Bc & _); set (e := z ^ (1 + 2 * (a + 1)));
    unfold Rdiv in ES; set (c := / (1 - z ^ 2)) in *.
  assert (He : 0 < e) by (apply pow_lt; lra); assert (Hez : e <= z) by (unfold e; rewrite <- (pow_1 z) at 2;
    apply pow_z_le; [lra | lia]).
  apply (two_sides a1 a2 2 first z Minus D ((z - e) * c) (z ^ 2)); [lra | reflexivity | apply Rmult_le_pos; lra | lra |
    | |].
  - assert (0 < e * c * (1 + z ^ 2)) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
    replace ((z - e) * c * (1 + z ^ 2)) with (z * c * (1 + z ^ 2) - e * c * (1 + z ^ 2)) by ring; lra.
  - intros X HN HX; replace ((z - e) * c) with ((z ^ 1 - e) / (1 - z ^ 2)) by (rewrite pow_1; reflexivity);
      apply (sum_steps z 1 2 (a + 1)); [lra | lia | exact HN|].
    intros x Hx; destruct (HX x Hx) as [Mx Sx]; destruct (H x Mx) as [[_ S]|[K _]]; [congruence | exact K].
  - intros X HN HX; replace (z ^ 2) with (sum_of [2%nat] (fun k => z ^ k)) by (cbn [sum_of]; ring); apply sum_incl;
      [exact HN | | intros; apply pow_le; lra].
    intros x Hx; destruct (HX x Hx) as [Mx Sx]; destruct (H x Mx) as [[-> _]|[_ S]];
      [left; reflexivity | contradiction].
Qed.

Lemma word_D_vertices a v : In v (vertices 2 (repeat D a)) -> v = (2%nat, U) \/ exists k, (k <= a)%nat /\
  v = ((2 * k + 1)%nat, D).
Proof.
  intros [<-|[<-|H]]; [right; exists 0%nat; split; [lia | reflexivity] | left; reflexivity|].
  apply periods_D in H; destruct H as (k & Hk & ->); right; exists k; split; [lia | f_equal; lia].
Qed.

Lemma in_word_D_odd a n : in_word (repeat D a) (2 * a + 1) 2 -> In n (map fst (vertices 2 (repeat D a))) ->
  n = 2%nat /\ side a1 a2 n = U \/ (exists k, (k < a + 1)%nat /\ n = (1 + 2 * k)%nat) /\ side a1 a2 n = D.
Proof.
  intros HW Hn; apply in_map_iff in Hn; destruct Hn as (v & <- & Hv); rewrite (vertex_side a1 a2 2 first _ _ _ v HW Hv).
  apply word_D_vertices in Hv; destruct Hv as [->|(k & Hk & ->)]; [left; auto | right; split;
    [exists k; cbn [fst]; lia | reflexivity]].
Qed.

(** D^a U, a >= 6. *)
Lemma minus_long a : (6 <= a)%nat -> in_word (repeat D a ++ [U]) (2 * a + 1) (2 * a + 3) -> path a1 a2 2 (repeat D a)
  (2 * a + 1) 2 -> small.
Proof.
  intros Ha HW Hp; destruct (numbers_minus z Hroot Hnum) as (E2 & ES & B2 & Bc & B13).
  set (w := repeat D a ++ [U]) in *; set (e := z ^ (2 * a + 3)); set (c := / (1 - z ^ 2)) in *.
  set (r := z ^ (2 * a + 1 + (2 * a + 3)) / (1 - z ^ Nat.min (2 * a + 1) (2 * a + 3))).
  assert (He : 0 < e) by (apply pow_lt; lra); assert (Hr : 0 <= r <= e / 2000).
  { unfold r; replace (Nat.min (2 * a + 1) (2 * a + 3)) with (2 * a + 1)%nat by lia; rewrite Nat.add_comm, pow_add;
      fold e.
    assert (Q : z ^ (2 * a + 1) <= 1 / 2500) by (apply Rle_trans with (2 := B13), pow_z_le; [lra | lia]);
      pose proof (pow_lt z (2 * a + 1) ltac:(lra)).
    set (y := z ^ (2 * a + 1)) in *; split; [apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; lra]|].
    apply (Rmult_le_reg_r (1 - y)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; nra. }
  assert (Cases : forall n, In n (map fst (vertices 2 w)) -> n = 2%nat /\ side a1 a2 n = U \/ n = (2 * a + 3)%nat /\
    side a1 a2 n = U \/ (exists k, (k < a + 1)%nat /\ n = (1 + 2 * k)%nat) /\ side a1 a2 n = D).
  { intros n I; apply in_map_iff in I; destruct I as (v & <- & Hv).
    rewrite (vertex_side a1 a2 2 first _ _ _ v HW Hv); unfold w in Hv; rewrite (vertices_snoc a1 a2 2 _ _ _ U Hp),
      in_app_iff in Hv; destruct Hv as [Hv|[<-|[]]].
    - apply word_D_vertices in Hv; destruct Hv as [->|(k & Hk & ->)]; [tauto|]; right; right; cbn [fst snd]; split;
        [exists k; split; lia | reflexivity].
    - right; left; cbn [fst snd]; split; [lia | reflexivity]. }
  set (isl := fun n => if in_dec Nat.eq_dec n (map fst (vertices 2 w)) then false else true).
  assert (Late : forall X, NoDup X -> (forall n, In n X -> member n) -> sum_of (filter isl X) (fun k => z ^ k) <= r).
  { intros X HN HX; apply (later_sum a1 a2 2 first z w _ _ _); [lra | apply HW | apply NoDup_filter, HN|]; intros n Hn;
      apply filter_In in Hn; destruct Hn as [Hn Il].
    destruct (member_cases a1 a2 2 first w _ _ n (proj1 HW) (HX n Hn)) as [I|I]; [|exact I]; unfold isl in Il;
      destruct (in_dec _ _ _); [discriminate | contradiction]. }
  assert (NotLate : forall X n, In n (filter (fun n => negb (isl n)) X) -> In n X /\ In n (map fst (vertices 2 w))).
  { intros X n Hn; apply filter_In in Hn; destruct Hn as [Hn F]; split; [exact Hn|]; unfold isl in F;
      destruct (in_dec _ _ _); [assumption | discriminate]. }
  apply (two_sides a1 a2 2 first z Minus D (z * c - e * c + r) (z ^ 2 + e + r)).
  - lra.
  - reflexivity.
  - assert (e <= z) by (unfold e; rewrite <- (pow_1 z) at 2; apply pow_z_le; [lra | lia]); assert (0 <= (z - e) * c)
      by (apply Rmult_le_pos; lra); lra.
  - lra.
  - unfold Rdiv in ES; fold c in ES; assert (Hc : 1.419 < c < 1.421) by exact Bc; assert (zc : 0.77 < z * c < 0.773)
      by nra.
    assert (X0 : 1.419 * e <= e * c) by (rewrite (Rmult_comm e c); apply Rmult_le_compat_r; lra).
    assert (X1 : (r - e * c) * (1 + z ^ 2 + e + r) <= (r - e * c) * 1.295) by (apply Rmult_le_compat_neg_l; lra).
    assert (X2 : z * c * (e + r) <= 0.773 * (e + r)) by (apply Rmult_le_compat_r; lra).
    replace ((z * c - e * c + r) * (1 + (z ^ 2 + e + r))) with (z * c * (1 + z ^ 2) + z * c * (e + r) + (r - e * c)
      * (1 + z ^ 2 + e + r)) by ring; lra.
  - intros X HN HX; rewrite (sum_filter_two isl X); specialize (Late X HN (fun n Hn => proj1 (HX n Hn))).
    assert (Q : sum_of (filter (fun n => negb (isl n)) X) (fun k => z ^ k) <= (z ^ 1 - z ^ (1 + 2 * (a + 1)))
      / (1 - z ^ 2)).
    { apply (sum_steps z 1 2 (a + 1)); [lra | lia | apply NoDup_filter, HN|]; intros x Hx; apply NotLate in Hx;
        destruct Hx as [Hx NL]; destruct (HX x Hx) as [Mx Sx].
      destruct (Cases x NL) as [[_ S]|[[_ S]|[K _]]]; [congruence | congruence | exact K]. }
    replace (1 + 2 * (a + 1))%nat with (2 * a + 3)%nat in Q by lia; rewrite pow_1 in Q; fold e in Q; unfold Rdiv in Q;
      fold c in Q; lra.
  - intros X HN HX; rewrite (sum_filter_two isl X); specialize (Late X HN (fun n Hn => proj1 (HX n Hn))).
    assert (Q : sum_of (filter (fun n => negb (isl n)) X) (fun k => z ^ k) <= sum_of [2; 2 * a + 3]%nat (fun k =>
      z ^ k)); [|cbn [sum_of] in Q; fold e in Q; lra].
    apply sum_incl; [apply NoDup_filter, HN | | intros; apply pow_le; lra]; intros x Hx; apply NotLate in Hx;
      destruct Hx as [Hx NL]; destruct (HX x Hx) as [Mx Sx].
    destruct (Cases x NL) as [[-> _]|[[-> _]|[_ S]]]; [left; reflexivity | right; left; reflexivity | contradiction].
Qed.

Lemma minus_short a : (a < 6)%nat -> in_word (repeat D a ++ [U]) (2 * a + 1) (2 * a + 3) -> small.
Proof.
  intros Ha HW; assert (Hz : 0 < z < IZR 5437 / IZR 10000) by lra.
  destruct a as [|[|[|[|[|[|a]]]]]]; [| | | | | |lia]; cbn [repeat app] in HW.
  - exact (cert_sound 5437 10000 2 [U] Minus [3; 1; 3]%Z 3 ltac:(vm_compute; reflexivity) a1 a2 _ _ z first HW Hz).
  - exact (cert_sound 5437 10000 2 [D; U] Minus [5; 3; 4; 4]%Z 5 ltac:(vm_compute; reflexivity) a1 a2 _ _ z first HW
      Hz).
  - exact (cert_sound 5437 10000 2 [D; D; U] Minus [5; 4; 5; 4; 4]%Z 5 ltac:(vm_compute; reflexivity) a1 a2 _ _ z first
      HW Hz).
  - exact (cert_sound 5437 10000 2 [D; D; D; U] Minus [13; 10; 13; 13; 10; 10]%Z 13 ltac:(vm_compute; reflexivity) a1 a2
      _ _ z first HW Hz).
  - exact (cert_sound 5437 10000 2 [D; D; D; D; U] Minus [130; 100; 130; 130; 130; 101; 100]%Z 130 ltac:(vm_compute;
      reflexivity) a1 a2 _ _ z first HW Hz).
  - exact (cert_sound 5437 10000 2 [D; D; D; D; D; U] Minus [259; 200; 259; 259; 259; 259; 200; 200]%Z 259
      ltac:(vm_compute; reflexivity) a1 a2 _ _ z first HW Hz).
Qed.

Lemma minus_2 : small.
Proof.
  destruct (classic (exists a, in_word (repeat D a) (2 * a + 1) 2 /\ ~ in_word (repeat D (S a)) (2 * S a + 1) 2))
    as [(a & HW & Stop)|All].
  - destruct (word_step a1 a2 2 _ _ _ HW) as [NM|[[_ HD]|[_ HU]]].
    + apply (minus_odd a); intros n Hn; destruct (member_cases a1 a2 2 first _ _ _ n (proj1 HW) Hn) as [I|L];
        [apply (in_word_D_odd a n HW I)|].
      destruct (later_none a1 a2 2 first _ _ _ n (proj1 HW) NM L).
    + exfalso; apply Stop; rewrite repeat_snoc in HD; replace (2 * S a + 1)%nat with (2 * a + 1 + 2)%nat by lia;
        exact HD.
    + replace (2 * a + 1 + 2)%nat with (2 * a + 3)%nat in HU by lia; destruct (le_lt_dec 6 a) as [L|L];
        [apply (minus_long a L HU), HW | apply (minus_short a L HU)].
  - destruct (no_D_without_end a1 a2 first); induction a as [|a IH]; [apply word_start, first | apply NNPP; intros No;
      apply All; exists a; split; assumption].
Qed.
End Minus.

Theorem minus_below z : root_minus z -> 5436 / 10000 < z < 5437 / 10000 -> forall a1 a2 K, first_upper a1 a2 K ->
  below (patterns a1 a2 Plus Minus) (- ln z).
Proof.
  intros Hr Hn a1 a2 K first; pose proof (K_ge_2 a1 a2 K first); destruct (Nat.eq_dec K 2) as [->|Hne];
    [exact (minus_2 a1 a2 z Hr Hn first)|].
  apply (minus_large_K a1 a2 z Hn K first); lia.
Qed.
