(** * Case (+,+): below 0.4503..., whatever the point, for where K = 2 every word ends early, is in a cylinder
    or in the family U D U^a *)

From Coq Require Import Reals ZArith List Arith Bool Lra Lia Classical.
From Grazing Require Import Defs Statement StatementWords StatementGraphs StatementReaderWords Algebra WordAlgebra
  WordPath WordGraph WordPatterns WordPlane GraphWords.
From Grazing Require Import StatementSuprema PatternSums PatternCylinders Endless SupremumMinus SupremumPlus.
Import ListNotations. Open Scope R_scope.

Section Two.
Variables (a1 a2 z : R).
Hypotheses (Hroot : root_plus z) (Hnum : 6373 / 10000 < z < 6374 / 10000) (first : first_upper a1 a2 2).
Notation small := (below (patterns a1 a2 Plus Plus) (- ln z)).
Notation member := (member a1 a2 Plus).
Notation side := (side a1 a2).
Notation in_word := (in_word a1 a2 2).

Lemma wa_vertices a v : In v (vertices 2 (wa a)) -> v = (1%nat, D) \/ v = (2%nat, U) \/ v = (4%nat, D) \/ exists k,
  (k < a + 1)%nat /\ v = ((3 + 4 * k)%nat, U).
Proof.
  unfold wa, vertices; cbn [periods Nat.add]; intros [<-|[<-|[<-|[<-|H]]]]; [tauto | tauto | | tauto |].
  - right; right; right; exists 0%nat; split; [lia | reflexivity].
  - apply periods_U in H; destruct H as (k & Hk & ->); right; right; right; exists k; split; [lia | f_equal; lia].
Qed.
Lemma wa_start a : in_word (wa a) 4 (4 * a + 3) -> in_word [U; D] 4 3.
Proof.
  intros [Hp HV]; unfold wa in *; split.
  - destruct a as [|a]; [exact Hp|]; cbn [repeat] in Hp; destruct (path_prefix a1 a2 2%nat first [U; D] U (repeat U a) _
      _ Hp) as (i & j & Hp0 & _).
    pose proof (path_final a1 a2 2 _ _ _ Hp0) as F; cbn in F; injection F as <- <-; exact Hp0.
  - rewrite Forall_forall in *; intros v Hv; apply HV; change (U :: D :: repeat U a) with ([U; D] ++ repeat U a);
      apply vertices_app, Hv.
Qed.

(** U D U^a: no later period than 3, 7, 11, ..., 4a + 3. *)
Lemma plus_steps a : in_word [U; D] 4 3 -> (forall n, member n -> n = 1%nat \/ n = 2%nat \/ n = 4%nat \/ side n = U /\
  exists k, (k < a + 1)%nat /\ n = (3 + 4 * k)%nat) -> small.
Proof.
  intros HW H; destruct (numbers_plus z Hroot Hnum) as (B2 & B3 & B4 & _ & C4 & C3 & E).
  assert (S2 : side 2 = U) by (apply (on_side a1 a2), first).
  assert (S4 : side 4 = D).
  { apply (vertex_side a1 a2 2 first [U; D] 4 3 (4%nat, D) HW); right; right; right; left; reflexivity. }
  set (c := / (1 - z ^ 4)) in *; set (e := z ^ (3 + 4 * (a + 1))); assert (He : 0 < e) by (apply pow_lt; lra).
  apply (family a1 a2 z Hroot Hnum first (1 + z ^ 4) ((z ^ 3 - e) * c) HW); [lra | | |].
  { assert (0 < (1 + z ^ 4) * (e * c)) by (apply Rmult_lt_0_compat; [|apply Rmult_lt_0_compat]; lra).
    replace ((1 + z ^ 4) * ((z ^ 3 - e) * c + z ^ 2 * / (1 - z ^ 3)))
      with ((1 + z ^ 4) * (z ^ 3 * c + z ^ 2 * / (1 - z ^ 3)) - (1 + z ^ 4) * (e * c)) by ring; lra. }
  - intros X HN HX; replace (1 + z ^ 4 - 1) with (z ^ 4) by ring; apply sum_one; [lra | exact HN|]; intros n Hn;
      destruct (HX n Hn) as (Mn & Sn & N1).
    destruct (H n Mn) as [->|[->|[->|[Su _]]]]; congruence.
  - intros X HN HX; apply (sum_steps z 3 4 (a + 1)); [lra | lia | exact HN|]; intros x Hx;
      destruct (HX x Hx) as (Mx & Sx & N2).
    destruct (H x Mx) as [->|[->|[->|[_ K]]]]; [|congruence | congruence | exact K];
      rewrite (on_side a1 a2 1 D (on_one a1 a2)) in Sx; discriminate.
Qed.
Lemma wa_members a n : in_word (wa a) 4 (4 * a + 3) -> In n (map fst (vertices 2 (wa a))) ->
  n = 1%nat \/ n = 2%nat \/ n = 4%nat \/ side n = U /\ exists k, (k < a + 1)%nat /\ n = (3 + 4 * k)%nat.
Proof.
  intros HW I; apply in_map_iff in I; destruct I as (v & <- & Hv); pose proof (vertex_side a1 a2 2 first _ _ _ v HW Hv)
    as S.
  apply wa_vertices in Hv; destruct Hv as [->|[->|[->|(k & Hk & ->)]]]; cbn [fst snd] in *; [tauto | tauto | tauto|];
    right; right; right; split; [exact S | exists k; auto].
Qed.

(** U D U^a D, a >= 4. *)
Lemma plus_long a : (4 <= a)%nat -> in_word (wa a ++ [D]) (4 * a + 7) (4 * a + 3) -> in_word (wa a) 4 (4 * a + 3) ->
  small.
Proof.
  intros Ha HW HWa; destruct (numbers_plus z Hroot Hnum) as (B2 & B3 & B4 & B19 & C4 & C3 & E).
  set (w := wa a ++ [D]) in *; set (e := z ^ (4 * a + 7)); set (c := / (1 - z ^ 4)) in *;
    set (P := z ^ 2 * / (1 - z ^ 3)) in *.
  set (r := z ^ (4 * a + 7 + (4 * a + 3)) / (1 - z ^ Nat.min (4 * a + 7) (4 * a + 3))).
  assert (He : 0 < e) by (apply pow_lt; lra); assert (Hr : 0 <= r <= e / 2000).
  { unfold r; replace (Nat.min (4 * a + 7) (4 * a + 3)) with (4 * a + 3)%nat by lia; rewrite pow_add; fold e.
    assert (Q : z ^ (4 * a + 3) <= 1 / 4000) by (apply Rle_trans with (2 := B19), pow_z_le; [lra | lia]);
      pose proof (pow_lt z (4 * a + 3) ltac:(lra)).
    set (y := z ^ (4 * a + 3)) in *; split; [apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; lra]|].
    apply (Rmult_le_reg_r (1 - y)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; nra. }
  assert (Cases : forall n, In n (map fst (vertices 2 w)) -> n = 1%nat \/ n = 2%nat \/
    (n = 4%nat \/ n = (4 * a + 7)%nat) /\ side n = D \/ side n = U /\ exists k, (k < a + 1)%nat /\ n = (3 + 4 * k)%nat).
  { intros n I; apply in_map_iff in I; destruct I as (v & <- & Hv); pose proof (vertex_side a1 a2 2 first _ _ _ v HW Hv)
      as S.
    unfold w in Hv; rewrite (vertices_snoc a1 a2 2 _ _ _ D (proj1 HWa)), in_app_iff in Hv; destruct Hv as [Hv|[<-|[]]];
      [|cbn [fst snd] in *; right; right; left; split; [right; lia | exact S]].
    apply wa_vertices in Hv; destruct Hv as [->|[->|[->|(k & Hk & ->)]]]; cbn [fst snd] in *; [tauto | tauto | tauto|];
      right; right; right; split; [exact S | exists k; auto]. }
  set (isl := fun n => if in_dec Nat.eq_dec n (map fst (vertices 2 w)) then false else true).
  assert (Late : forall X, NoDup X -> (forall n, In n X -> member n) -> sum_of (filter isl X) (fun k => z ^ k) <= r).
  { intros X HN HX; apply (later_sum a1 a2 2 first z w _ _ _); [lra | apply HW | apply NoDup_filter, HN|]; intros n Hn;
      apply filter_In in Hn; destruct Hn as [Hn Il].
    destruct (member_cases a1 a2 2 first w _ _ n (proj1 HW) (HX n Hn)) as [I|I]; [|exact I]; unfold isl in Il;
      destruct (in_dec _ _ _); [discriminate | contradiction]. }
  assert (NotLate : forall X n, In n (filter (fun n => negb (isl n)) X) -> In n X /\ In n (map fst (vertices 2 w))).
  { intros X n Hn; apply filter_In in Hn; destruct Hn as [Hn F]; split; [exact Hn|]; unfold isl in F;
      destruct (in_dec _ _ _); [assumption | discriminate]. }
  assert (z3c : 0 < z ^ 3 * c < 0.3108) by nra; assert (e3 : e <= z ^ 3) by (apply pow_z_le; [lra | lia]).
  apply (family a1 a2 z Hroot Hnum first (1 + z ^ 4 + e + r) (z ^ 3 * c - e * c + r) (wa_start a HWa)).
  - lra.
  - fold P; assert (X0 : 1.197 * e <= e * c) by (rewrite (Rmult_comm e c); apply Rmult_le_compat_r; lra).
    assert (X1 : (r - e * c) * (1 + z ^ 4 + e + r) <= (r - e * c) * 1.1649) by (apply Rmult_le_compat_neg_l; lra).
    assert (PQ : z ^ 3 * c + P <= 0.86) by (apply (Rmult_le_reg_l (1 + z ^ 4)); [lra|]; rewrite E; lra).
    assert (X2 : (z ^ 3 * c + P) * (e + r) <= 0.86 * (e + r)) by (apply Rmult_le_compat_r; lra).
    replace ((1 + z ^ 4 + e + r) * (z ^ 3 * c - e * c + r + P)) with ((1 + z ^ 4) * (z ^ 3 * c + P) + (z ^ 3 * c + P)
      * (e + r) + (r - e * c) * (1 + z ^ 4 + e + r)) by ring; lra.
  - intros X HN HX; rewrite (sum_filter_two isl X); specialize (Late X HN (fun n Hn => proj1 (HX n Hn))).
    assert (Q : sum_of (filter (fun n => negb (isl n)) X) (fun k => z ^ k) <= sum_of [4; 4 * a + 7]%nat (fun k =>
      z ^ k)); [|cbn [sum_of] in Q; fold e in Q; lra].
    apply sum_incl; [apply NoDup_filter, HN | | intros; apply pow_le; lra]; intros x Hx; apply NotLate in Hx;
      destruct Hx as [Hx NL]; destruct (HX x Hx) as (Mx & Sx & N1).
    destruct (Cases x NL) as [->|[->|[[[->| ->] _]|[Su _]]]]; [congruence | | left; reflexivity | right; left;
      reflexivity | congruence].
    rewrite (on_side a1 a2 2 U) in Sx by apply first; discriminate.
  - intros X HN HX; rewrite (sum_filter_two isl X); specialize (Late X HN (fun n Hn => proj1 (HX n Hn))).
    assert (Q : sum_of (filter (fun n => negb (isl n)) X) (fun k => z ^ k) <= (z ^ 3 - z ^ (3 + 4 * (a + 1)))
      / (1 - z ^ 4)).
    { apply (sum_steps z 3 4 (a + 1)); [lra | lia | apply NoDup_filter, HN|]; intros x Hx; apply NotLate in Hx;
        destruct Hx as [Hx NL]; destruct (HX x Hx) as (Mx & Sx & N2).
      destruct (Cases x NL) as [->|[->|[[_ Sd]|[_ K]]]]; [|congruence | congruence | exact K];
        rewrite (on_side a1 a2 1 D (on_one a1 a2)) in Sx; discriminate. }
    replace (3 + 4 * (a + 1))%nat with (4 * a + 7)%nat in Q by lia; fold e in Q; unfold Rdiv in Q; fold c in Q; lra.
Qed.
Lemma plus_short a : (a < 4)%nat -> in_word (wa a ++ [D]) (4 * a + 7) (4 * a + 3) -> small.
Proof.
  intros Ha HW; assert (Hz : 0 < z < IZR 6374 / IZR 10000) by lra; destruct a as [|[|[|[|a]]]]; [| | | |lia];
    unfold wa in HW; cbn [repeat app] in HW.
  - exact (cert_sound 6374 10000 2 [U; D; D] Plus [5; 11; 7; 5; 7]%Z 11 ltac:(vm_compute; reflexivity) a1 a2 _ _ z first
      HW Hz).
  - exact (cert_sound 6374 10000 2 [U; D; U; D] Plus [20; 48; 36; 29; 31; 31]%Z 48 ltac:(vm_compute; reflexivity) a1 a2
      _ _ z first HW Hz).
  - exact (cert_sound 6374 10000 2 [U; D; U; U; D] Plus [60; 147; 109; 93; 109; 94; 94]%Z 147 ltac:(vm_compute;
      reflexivity) a1 a2 _ _ z first HW Hz).
  - exact (cert_sound 6374 10000 2 [U; D; U; U; U; D] Plus [400; 984; 729; 625; 729; 729; 626; 626]%Z 984
      ltac:(vm_compute; reflexivity) a1 a2 _ _ z first HW Hz).
Qed.

(** The word U: periods 1, 2 and 3, and 1 does not follow 3. *)
Lemma plus_U : in_word [U] 1 3 -> ~ member 4 -> small.
Proof.
  intros HW NM; destruct (numbers_plus z Hroot Hnum) as (B2 & B3 & _).
  assert (Three : forall n, member n -> In n [1; 2; 3]%nat).
  { intros n Hn; destruct (member_cases a1 a2 2 first _ _ _ n (proj1 HW) Hn) as [I|L];
      [exact I | destruct (later_none a1 a2 2 first _ _ _ n (proj1 HW) NM L)]. }
  assert (No31 : ~ edge a1 a2 Plus Plus 3 1).
  { intros E; destruct (W5_neighbours a1 a2 2%nat [U] 1%nat 3%nat first (proj1 HW)) as (A & _); apply NM, A;
      unfold edge in E; cbn [sgn] in E; lra. }
  assert (No11 : ~ edge a1 a2 Plus Plus 1 1) by (apply (lower_apart a1 a2 first 1 1); try apply member_one;
    apply (on_side a1 a2), on_one).
  set (v := fun n : nat => if (n =? 2)%nat then 1 + z else 1); apply (spare a1 a2 z Plus v 1 2 0.05);
    [lra | lra | lra | intros n _; unfold v; destruct (n =? 2)%nat; lra|].
  intros x Mx X HN HX; assert (Pos : forall y : nat, 0 <= z ^ y * v y) by (intros y; apply Rmult_le_pos;
    [apply pow_le; lra | unfold v; destruct (y =? 2)%nat; lra]).
  destruct (Three x Mx) as [<-|[<-|[<-|[]]]].
  - apply Rle_trans with (sum_of [2; 3]%nat (fun y => z ^ y * v y)); [|unfold v; cbn [sum_of Nat.eqb]; nra].
    apply sum_incl; [exact HN | | intros; apply Pos]; intros y Hy; destruct (HX y Hy) as [My Ey]; destruct (Three y My)
      as [<-|H]; [contradiction | exact H].
  - apply Rle_trans with (sum_of [1; 2; 3]%nat (fun y => z ^ y * v y)); [|unfold v; cbn [sum_of Nat.eqb]; rewrite pow_1;
      nra].
    apply sum_incl; [exact HN | | intros; apply Pos]; intros y Hy; apply Three, (HX y Hy).
  - apply Rle_trans with (sum_of [2; 3]%nat (fun y => z ^ y * v y)); [|unfold v; cbn [sum_of Nat.eqb]; nra].
    apply sum_incl; [exact HN | | intros; apply Pos]; intros y Hy; destruct (HX y Hy) as [My Ey]; destruct (Three y My)
      as [<-|H]; [contradiction | exact H].
Qed.
Lemma plus_2 : small.
Proof.
  destruct (numbers_plus z Hroot Hnum) as (B2 & B3 & B4 & _); assert (Hz : 0 < z < IZR 6374 / IZR 10000) by lra.
  destruct (u_first a1 a2) as (U2 & U3 & U4 & _); destruct (first) as ([A0 A1] & _ & O2 & _); cbn [on] in O2;
    rewrite U2 in O2.
  destruct (word_step a1 a2 2 _ _ _ (word_start a1 a2 2 first)) as [NM|[[_ HD]|[HU H1]]].
  - apply (plus_closed a1 a2 z Hnum 2 _ _ _ (z ^ 2) first (word_start a1 a2 2 first) NM);
      [lra | nra | intros v [<-|[<-|[]]]; cbn; tauto | cbn [sum_of filter map vertices periods fst Nat.eqb negb]; lra].
  - exact (cert_sound 6374 10000 2 [D] Plus [1; 3; 2]%Z 3 ltac:(vm_compute; reflexivity) a1 a2 _ _ z first HD Hz).
  - cbn [app Nat.add on] in H1, HU; rewrite U3 in HU; destruct (word_step a1 a2 2 _ _ _ H1) as [NM|[[_ H2]|[HU4 _]]];
      [exact (plus_U H1 NM) | |].
    + assert (W0 : in_word (wa 0) 4 (4 * 0 + 3)) by exact H2.
      destruct (classic (exists a, in_word (wa a) 4 (4 * a + 3) /\ ~ in_word (wa (S a)) 4 (4 * S a + 3)))
        as [(a & HW & Stop)|All].
      * destruct (word_step a1 a2 2 _ _ _ HW) as [NM|[[_ HD]|[_ HUa]]].
        -- apply (plus_steps a); [exact H2|]; intros n Hn; destruct (member_cases a1 a2 2 first _ _ _ n (proj1 HW) Hn)
             as [I|L]; [apply (wa_members a n HW I)|].
           destruct (later_none a1 a2 2 first _ _ _ n (proj1 HW) NM L).
        -- replace (4 + (4 * a + 3))%nat with (4 * a + 7)%nat in HD by lia; destruct (le_lt_dec 4 a) as [L|L];
             [apply (plus_long a L HD HW) | apply (plus_short a L HD)].
        -- exfalso; apply Stop; unfold wa in HUa |- *; cbn [app] in HUa; rewrite repeat_snoc in HUa;
             replace (4 * S a + 3)%nat with (4 + (4 * a + 3))%nat by lia; exact HUa.
      * destruct (no_U_without_end a1 a2 first); induction a as [|a IH]; [exact W0 | apply NNPP; intros No; apply All;
          exists a; split; assumption].
    + exfalso; cbn [on Nat.add] in HU4; rewrite U4 in HU4; assert (0 < - a1) by lra; assert (0 < - (a1 * a1 - 2 * a2))
        by lra.
      assert (0 < - a1 * - (a1 * a1 - 2 * a2)) by (apply Rmult_lt_0_compat; assumption); lra.
Qed.
End Two.

Theorem plus_below z : root_plus z -> 6373 / 10000 < z < 6374 / 10000 -> forall a1 a2 K, first_upper a1 a2 K ->
  below (patterns a1 a2 Plus Plus) (- ln z).
Proof.
  intros Hr Hn a1 a2 K first; pose proof (K_ge_2 a1 a2 K first); destruct (Nat.eq_dec K 2) as [->|N2];
    [exact (plus_2 a1 a2 z Hr Hn first)|].
  destruct (Nat.eq_dec K 3) as [->|N3]; [exact (plus_3 a1 a2 z Hr Hn first)|]; apply (plus_large_K a1 a2 z Hn K first);
    lia.
Qed.
