(** * Case (+,+): below 0.4503... where K > 2, and in the family U D U^a *)

From Coq Require Import Reals ZArith List Arith Bool Lra Lia Classical.
From Grazing Require Import Defs Statement StatementWords StatementGraphs StatementReaderWords Algebra WordAlgebra
  WordPath WordGraph WordPatterns WordPlane GraphWords.
From Grazing Require Import StatementSuprema PatternSums PatternCylinders SupremumMinus.
Import ListNotations. Open Scope R_scope.

Lemma powers_plus z : 6373 / 10000 < z <= 6374 / 10000 -> 0.4061 < z ^ 2 < 0.4063 /\ 0.2588 < z ^ 3 < 0.259 /\
  0.1649 < z ^ 4 < 0.1651.
Proof.
  intros B; assert (B2 : 0.4061 < z ^ 2 < 0.4063) by (cbn [pow]; split; nra); split; [exact B2|].
  split; [replace (z ^ 3) with (z ^ 2 * z) by ring | replace (z ^ 4) with (z ^ 2 * z ^ 2) by ring]; split; nra.
Qed.
Lemma numbers_plus z : root_plus z -> 6373 / 10000 < z < 6374 / 10000 -> 0.4061 < z ^ 2 < 0.4063 /\
  0.2588 < z ^ 3 < 0.259 /\ 0.1649 < z ^ 4 < 0.1651 /\ z ^ 19 <= 1 / 4000 /\ 1.197 < / (1 - z ^ 4) < 1.2 /\
  0 < / (1 - z ^ 3) /\ (1 + z ^ 4) * (z ^ 3 * / (1 - z ^ 4) + z ^ 2 * / (1 - z ^ 3)) = 1.
Proof.
  intros [Hz E] B; destruct (powers_plus z ltac:(lra)) as (B2 & B3 & B4).
  split; [exact B2 | split; [exact B3 | split; [exact B4|]]]; split;
    [|split; [|split; [apply Rinv_0_lt_compat; lra | exact E]]].
  - assert (0 <= z ^ 8 <= 0.02726) by (replace (z ^ 8) with (z ^ 4 * z ^ 4) by ring; split; nra).
    assert (0 <= z ^ 16 <= 0.000744) by (replace (z ^ 16) with (z ^ 8 * z ^ 8) by ring; split; nra).
    replace (z ^ 19) with (z ^ 16 * z ^ 3) by ring; nra.
  - split; apply (Rmult_lt_reg_r (1 - z ^ 4)); try lra; rewrite Rinv_l; lra.
Qed.
Lemma periods_U i a : forall j v, In v (periods i j (repeat U a)) -> exists k, (1 <= k <= a)%nat /\
  v = ((j + k * i)%nat, U).
Proof.
  induction a as [|a IH]; intros j v H; cbn [repeat periods] in H; [destruct H|]; destruct H as [<-|H];
    [exists 1%nat; split; [lia | f_equal; lia]|].
  destruct (IH _ _ H) as (k & Hk & ->); exists (S k); split; [lia | f_equal; lia].
Qed.
Lemma sum_one z n X : 0 < z -> NoDup X -> (forall x, In x X -> x = n) -> sum_of X (fun k => z ^ k) <= z ^ n.
Proof.
  intros Hz HN HX; replace (z ^ n) with (sum_of [n] (fun k => z ^ k)) by (cbn [sum_of]; ring); apply sum_incl;
    [exact HN | | intros; apply pow_le; lra].
  intros x Hx; left; symmetry; apply HX, Hx.
Qed.

Section Plus.
Variables (a1 a2 z : R).
Hypotheses (Hroot : root_plus z) (Hnum : 6373 / 10000 < z < 6374 / 10000).
Notation small := (below (patterns a1 a2 Plus Plus) (- ln z)).
Notation member := (member a1 a2 Plus).
Notation side := (side a1 a2).
Notation in_word := (in_word a1 a2).

Lemma plus_large_K K : first_upper a1 a2 K -> (4 <= K)%nat -> small.
Proof.
  intros first HK; exists (- ln 0.6374); split; [apply Ropp_lt_contravar, ln_increasing; lra|];
    destruct (powers_plus 0.6374 ltac:(lra)) as (B2 & B3 & B4); clear Hroot Hnum.
  revert B2 B3 B4; generalize (eq_refl 0.6374); generalize 0.6374 at -1; clear z; intros z Ez B2 B3 B4;
    set (t := z ^ (1 + K) / (1 - z ^ Nat.min 1 K)).
  assert (P4 : z ^ K <= 0.1651) by (apply Rle_trans with (z ^ 4); [apply pow_z_le; [lra | exact HK] | lra]).
  assert (PK : 0 < z ^ K) by (apply pow_lt; lra); assert (Ht : 0 <= t <= 0.2904).
  { unfold t; replace (Nat.min 1 K) with 1%nat by lia; rewrite pow_1; cbn [Nat.add pow]; split.
    - apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; lra].
    - apply (Rmult_le_reg_r (1 - z)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; nra. }
  set (vv := fun n => if (n =? 1)%nat then 1 else 2); assert (V1 : vv 1%nat = 1) by reflexivity.
  assert (VK : vv K = 2) by (unfold vv; destruct (Nat.eqb_spec K 1); [lia | reflexivity]).
  apply (cylinder a1 a2 K first z Plus vv 2 t [] 1 K (word_start a1 a2 K first)); [lra | lra | | | |].
  - intros x _; unfold vv; destruct (fst x =? 1)%nat; lra.
  - intros X HN HX; apply (later_sum a1 a2 K first z [] 1 K X); [lra | constructor | exact HN | exact HX].
  - change (vertices K []) with [(1%nat, D); (K, U)]; intros x [<-|[<-|[]]]; cbn [filter fst].
    + replace (allowed K [] Plus (1%nat, D) (1%nat, D)) with false by reflexivity; unfold weighed_sum.
      destruct (allowed K [] Plus (1%nat, D) (K, U)); cbn [sum_of fst]; rewrite V1, ?VK; lra.
    + unfold weighed_sum; destruct (allowed K [] Plus (K, U) (1%nat, D)), (allowed K [] Plus (K, U) (K, U));
        cbn [sum_of fst]; rewrite ?V1, ?VK, ?pow_1; lra.
  - change (vertices K []) with [(1%nat, D); (K, U)]; unfold weighed_sum; cbn [sum_of fst]; rewrite V1, VK, pow_1; lra.
Qed.

(** The word has ended after few letters: 1 alone is lower, the sum over the upper ones is s at most. *)
Lemma plus_closed K w i j s : first_upper a1 a2 K -> in_word K w i j -> ~ member (i + j) -> 0 <= s -> s * (1 + z) < 1 ->
  (forall v, In v (vertices K w) -> v = (1%nat, D) \/ snd v = U) ->
  sum_of (filter (fun n => negb (n =? 1)%nat) (map fst (vertices K w))) (fun k => z ^ k) <= s -> small.
Proof.
  intros first HW NM Hs Hs1 HV Hsum; apply (two_sides a1 a2 K first z Plus U s z); [lra | reflexivity | lra | lra |
    lra | |].
  - intros X HN HX; apply Rle_trans with (2 := Hsum); apply sum_incl; [exact HN | | intros; apply pow_le; lra];
      intros n Hn; destruct (HX n Hn) as [Mn Sn].
    destruct (member_cases a1 a2 K first w i j n (proj1 HW) Mn) as [I|L];
      [|destruct (later_none a1 a2 K first w i j n (proj1 HW) NM L)].
    apply filter_In; split; [exact I|]; apply in_map_iff in I; destruct I as (v & <- & Hv);
      rewrite (vertex_side a1 a2 K first w i j v HW Hv) in Sn.
    destruct (Nat.eqb_spec (fst v) 1) as [E|]; [|reflexivity]; exfalso;
      pose proof (vertex_side a1 a2 K first w i j v HW Hv) as S1; rewrite E in S1.
    rewrite (on_side a1 a2 1 D (on_one a1 a2)) in S1; congruence.
  - intros X HN HX; apply Rle_trans with (z ^ 1); [|rewrite pow_1; lra]; apply sum_one; [lra | exact HN|]; intros n Hn;
      destruct (HX n Hn) as [Mn Sn].
    destruct (member_cases a1 a2 K first w i j n (proj1 HW) Mn) as [I|L];
      [|destruct (later_none a1 a2 K first w i j n (proj1 HW) NM L)].
    apply in_map_iff in I; destruct I as (v & <- & Hv); rewrite (vertex_side a1 a2 K first w i j v HW Hv) in Sn;
      destruct (HV v Hv) as [->|E]; [reflexivity | contradiction].
Qed.
Lemma u_first : u a1 a2 2 = a1 /\ u a1 a2 3 = a1 * a1 - a2 /\ u a1 a2 4 = a1 * (a1 * a1 - 2 * a2) /\
  u a1 a2 6 = a1 * (a1 * a1 - a2) * (a1 * a1 - 3 * a2).
Proof. repeat split; unfold u; cbn; ring. Qed.
Lemma plus_3 : first_upper a1 a2 3 -> small.
Proof.
  intros first; destruct (numbers_plus z Hroot Hnum) as (B2 & B3 & B4 & _); assert (B5 : z ^ 5 <= 0.1053)
    by (replace (z ^ 5) with (z ^ 4 * z) by ring; nra).
  assert (P5 : 0 < z ^ 5) by (apply pow_lt; lra); destruct u_first as (U2 & U3 & U4 & U6);
    destruct (first) as ([A0 A1] & _ & O3 & Low).
  pose proof (Low 2%nat ltac:(lia)) as L2; cbn [on] in O3; rewrite U2 in L2; rewrite U3 in O3;
    assert (Hz : 0 < z < IZR 6374 / IZR 10000) by lra.
  assert (S5 : (0.259 + 0.1651 + 0.1053) * (1 + z) < 1) by nra.
  destruct (word_step a1 a2 3 _ _ _ (word_start a1 a2 3 first)) as [NM|[[HD _]|[HU H1]]].
  - apply (plus_closed 3 _ _ _ (0.259 + 0.1651 + 0.1053) first (word_start a1 a2 3 first) NM);
      [lra | exact S5 | | cbn; lra].
    intros v [<-|[<-|[]]]; cbn; tauto.
  - exfalso; cbn [on Nat.add] in HD; rewrite U4 in HD; assert (a1 * a1 - 2 * a2 < 0) by lra; nra.
  - cbn [on Nat.add app] in HU, H1; rewrite U4 in HU; assert (Pa : 0 < a1) by nra; destruct (word_step a1 a2 3 _ _ _ H1)
      as [NM|[[HD H2]|[HU2 H2]]].
    + apply (plus_closed 3 _ _ _ (0.259 + 0.1651 + 0.1053) first H1 NM); [lra | exact S5 | | cbn; lra];
        intros v [<-|[<-|[<-|[]]]]; cbn; tauto.
    + exact (cert_sound 6374 10000 3 [U; D] Plus [1; 2; 1; 1]%Z 2 ltac:(vm_compute; reflexivity) a1 a2 _ _ z first H2
        Hz).
    + cbn [app Nat.add] in H2; destruct (word_step a1 a2 3 _ _ _ H2) as [NM|[[HD H3]|[HU3 _]]].
      * apply (plus_closed 3 _ _ _ (0.259 + 0.1651 + 0.1053) first H2 NM); [lra | exact S5 | | cbn; lra];
          intros v [<-|[<-|[<-|[<-|[]]]]]; cbn; tauto.
      * exact (cert_sound 6374 10000 3 [U; U; D] Plus [4; 7; 7; 5; 5]%Z 7 ltac:(vm_compute; reflexivity) a1 a2 _ _ z
          first H3 Hz).
      * exfalso; cbn [on Nat.add] in HU3; rewrite U6 in HU3; assert (0 < - (a1 * a1 - a2)) by lra;
          assert (0 < - (a1 * a1 - 3 * a2)) by lra.
        assert (0 < a1 * (- (a1 * a1 - a2)) * (- (a1 * a1 - 3 * a2))) by (repeat apply Rmult_lt_0_compat; assumption);
          lra.
Qed.

(** ** K = 2 *)
Hypothesis first : first_upper a1 a2 2.
Let dec := decided_everywhere a1 a2 2 first.

Lemma lower_apart x y : member x -> member y -> side x = D -> side y = D -> ~ edge a1 a2 Plus Plus x y.
Proof. intros Mx My Sx Sy E; pose proof (same_side a1 a2 2 first Plus x y Mx My ltac:(congruence) E) as G;
    rewrite Sx in G; discriminate. Qed.

(** After U, D the periods 1 and n, n upper and not 2, are not joined. *)
Lemma one_apart n : in_word 2 [U; D] 4 3 -> member n -> side n = U -> n <> 2%nat -> ~ edge a1 a2 Plus Plus 1 n /\
  ~ edge a1 a2 Plus Plus n 1.
Proof.
  intros HW Hn Sn N2; assert (Some : exists t i j, in_word 2 ([U; D] ++ t) i j /\ In (n, U) (vertices 2 ([U; D] ++ t))).
  { destruct (member_cases a1 a2 2 first _ _ _ n (proj1 HW) Hn) as [I|(_ & t & i & j & Hp & E)].
    - exists [], 4%nat, 3%nat; split; [exact HW|]; apply in_map_iff in I; destruct I as (v & <- & Hv);
        rewrite (vertex_side a1 a2 2 first _ _ _ v HW Hv) in Sn.
      destruct v as [m l]; cbn [fst snd] in *; subst l; exact Hv.
    - exists (t ++ [U]), i, n; rewrite app_assoc; subst n; split.
      + split; [constructor; [exact Hp|]; rewrite <- Sn; apply (side_on a1 a2), Hn|].
        rewrite (vertices_snoc a1 a2 2 _ i j U Hp), Forall_app; split; [|constructor; [exact Hn | constructor]].
        destruct (W3 a1 a2 2%nat first) as (_ & _ & _ & _ & Init); specialize (Init _ i j Hp Hn); revert Init;
          apply Forall_impl; tauto.
      + rewrite (vertices_snoc a1 a2 2 _ i j U Hp); apply in_app_iff; right; left; reflexivity. }
  destruct Some as (t & i & j & [Hp HV] & Iv); pose proof (word_table a1 a2 2 first dec _ i j Hp HV 1%nat n ltac:(left;
    reflexivity) Iv) as Tab.
  cbn [app renewed] in Tab; destruct (Nat.eqb_spec 2 n) as [E|_]; [congruence|]; cbn in Tab; unfold edge; cbn [sgn];
    split; lra.
Qed.

Section Family.
Variables (k s : R).
Hypotheses (HW : in_word 2 [U; D] 4 3) (Hk : 1 <= k) (Hks : k * (s + z ^ 2 * / (1 - z ^ 3)) < 1).
Hypothesis HD : forall X, NoDup X -> (forall n, In n X -> member n /\ side n = D /\ n <> 1%nat) ->
  sum_of X (fun j => z ^ j) <= k - 1.
Hypothesis HU : forall X, NoDup X -> (forall n, In n X -> member n /\ side n = U /\ n <> 2%nat) ->
  sum_of X (fun j => z ^ j) <= s.
Let v2 := k * / (1 - z ^ 3).
Let gap := (1 - k * (s + z ^ 2 * / (1 - z ^ 3))) / 2.
Let v1 := z ^ 2 * v2 + gap.
Let v (n : nat) : R := if (n =? 1)%nat then v1 else if (n =? 2)%nat then v2 else match side n with D => 1 | U => k end.

Lemma family_sum X : NoDup X -> (forall n, In n X -> member n) -> exists A B C E, sum_of X (fun n => z ^ n * v n) = A
  + B + C + E /\ (0 <= A <= z * v1 /\ (~ In 1%nat X -> A = 0)) /\ 0 <= B <= z ^ 2 * v2 /\
  (0 <= C <= k - 1 /\ ((forall n, In n X -> side n = U \/ n = 1%nat) -> C = 0)) /\
  (0 <= E <= k * s /\ ((forall n, In n X -> side n = D \/ n = 2%nat) -> E = 0)).
Proof.
  intros HN HX; destruct (numbers_plus z Hroot Hnum) as (B2 & B3 & _ & _ & _ & C3 & _); assert (V2 : 0 < v2)
    by (unfold v2; apply Rmult_lt_0_compat; lra).
  assert (V1 : 0 < v1) by (unfold v1, gap; pose proof (Rmult_lt_0_compat _ _ (pow_lt z 2 ltac:(lra)) V2); lra);
    set (p1 := fun n => (n =? 1)%nat); set (p2 := fun n => (n =? 2)%nat); set (pd := fun n => match side n with D =>
    true | U => false end).
  set (X1 := filter p1 X); set (Y1 := filter (fun n => negb (p1 n)) X); set (X2 := filter p2 Y1);
    set (Y2 := filter (fun n => negb (p2 n)) Y1).
  set (X3 := filter pd Y2); set (X4 := filter (fun n => negb (pd n)) Y2).
  assert (I1 : forall n, In n X1 -> In n X /\ n = 1%nat) by (intros n H; apply filter_In in H; destruct H as [H E];
    apply Nat.eqb_eq in E; auto).
  assert (J1 : forall n, In n Y1 -> In n X /\ n <> 1%nat) by (intros n H; apply filter_In in H; destruct H as [H E];
    apply negb_true_iff, Nat.eqb_neq in E; auto).
  assert (I2 : forall n, In n X2 -> n = 2%nat) by (intros n H; apply filter_In in H; destruct H as [_ E];
    apply Nat.eqb_eq in E; auto).
  assert (J2 : forall n, In n Y2 -> In n X /\ n <> 1%nat /\ n <> 2%nat).
  { intros n H; apply filter_In in H; destruct H as [H E]; apply J1 in H; apply negb_true_iff, Nat.eqb_neq in E;
      tauto. }
  assert (I3 : forall n, In n X3 -> In n X /\ n <> 1%nat /\ n <> 2%nat /\ side n = D).
  { intros n H; apply filter_In in H; destruct H as [H E]; apply J2 in H; unfold pd in E; destruct (side n);
      [tauto | discriminate]. }
  assert (I4 : forall n, In n X4 -> In n X /\ n <> 1%nat /\ n <> 2%nat /\ side n = U).
  { intros n H; apply filter_In in H; destruct H as [H E]; apply J2 in H; unfold pd in E; destruct (side n);
      [discriminate | tauto]. }
  exists (v1 * sum_of X1 (fun n => z ^ n)), (v2 * sum_of X2 (fun n => z ^ n)), (sum_of X3 (fun n => z ^ n)),
    (k * sum_of X4 (fun n => z ^ n)).
  assert (N1 : NoDup Y1) by (apply NoDup_filter, HN); assert (N2 : NoDup Y2) by (apply NoDup_filter, N1).
  assert (Pos : forall Y, 0 <= sum_of Y (fun n => z ^ n)) by (intros Y; apply sum_pos; intros; apply pow_le; lra).
  assert (None : forall Y, (forall n : nat, ~ In n Y) -> sum_of Y (fun n => z ^ n) = 0) by (intros [|n Y] H;
    [reflexivity | destruct (H n); left; reflexivity]).
  split.
  { rewrite (sum_filter_two p1 X); fold X1 Y1; rewrite (sum_filter_two p2 Y1); fold X2 Y2;
      rewrite (sum_filter_two pd Y2); fold X3 X4.
    rewrite <- !sum_scale; rewrite (sum_ext X1 _ (fun n => v1 * z ^ n)) by (intros n H; destruct (I1 n H) as [_ ->];
      unfold v; cbn [Nat.eqb]; ring).
    rewrite (sum_ext X2 _ (fun n => v2 * z ^ n)) by (intros n H; rewrite (I2 n H); unfold v; cbn [Nat.eqb]; ring).
    rewrite (sum_ext X3 _ (fun n => z ^ n)).
    2: { intros n H; destruct (I3 n H) as (_ & E1 & E2 & S); unfold v; rewrite (proj2 (Nat.eqb_neq _ _) E1),
           (proj2 (Nat.eqb_neq _ _) E2), S; ring. }
    rewrite (sum_ext X4 _ (fun n => k * z ^ n)).
    2: { intros n H; destruct (I4 n H) as (_ & E1 & E2 & S); unfold v; rewrite (proj2 (Nat.eqb_neq _ _) E1),
           (proj2 (Nat.eqb_neq _ _) E2), S; ring. }
    ring. }
  assert (Q1 : sum_of X1 (fun n => z ^ n) <= z ^ 1) by (apply sum_one; [lra | apply NoDup_filter, HN | intros n H;
    apply (I1 n H)]).
  assert (Q2 : sum_of X2 (fun n => z ^ n) <= z ^ 2) by (apply sum_one; [lra | apply NoDup_filter, N1 | exact I2]).
  assert (Q3 : sum_of X3 (fun n => z ^ n) <= k - 1) by (apply HD; [apply NoDup_filter, N2|]; intros n H;
    destruct (I3 n H) as (H1 & H2 & _ & H4); split; [apply HX, H1 | tauto]).
  assert (Q4 : sum_of X4 (fun n => z ^ n) <= s) by (apply HU; [apply NoDup_filter, N2|]; intros n H;
    destruct (I4 n H) as (H1 & _ & H3 & H4); split; [apply HX, H1 | tauto]).
  rewrite pow_1 in Q1; pose proof (Pos X1); pose proof (Pos X2); pose proof (Pos X3); pose proof (Pos X4).
  split; [split; [split; [apply Rmult_le_pos; lra | rewrite (Rmult_comm z); apply Rmult_le_compat_l; lra]|]|].
  { intros No; rewrite None; [ring|]; intros n H'; destruct (I1 n H') as [G1 ->]; contradiction. }
  split; [split; [apply Rmult_le_pos; lra | rewrite (Rmult_comm (z ^ 2)); apply Rmult_le_compat_l; lra]|].
  split; [split; [lra|]; intros No; apply None; intros n H'; destruct (I3 n H') as (G1 & E1 & _ & G4);
    destruct (No n G1); congruence|].
  split; [split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_l; lra]|]; intros No; rewrite None; [ring|];
    intros n H'; destruct (I4 n H') as (G1 & _ & E2 & G4); destruct (No n G1); congruence.
Qed.
Lemma family : small.
Proof.
  destruct (numbers_plus z Hroot Hnum) as (B2 & B3 & _ & _ & _ & C3 & _); assert (V2 : v2 * (1 - z ^ 3) = k)
    by (unfold v2; field; lra).
  assert (P2 : 0 < v2) by (unfold v2; apply Rmult_lt_0_compat; lra); assert (K2 : k <= v2) by nra;
    assert (W : 0 < z ^ 2 * v2) by (apply Rmult_lt_0_compat; lra).
  assert (Sd1 : side 1 = D) by (apply (on_side a1 a2), on_one); assert (Sd2 : side 2 = U) by (apply (on_side a1 a2),
    first).
  assert (G0 : 0 < gap) by (unfold gap; lra); apply (spare a1 a2 z Plus v (Rmin 1 v1) (v2 + 1 + v1) gap);
    [lra | apply Rmin_glb_lt; unfold v1; lra | exact G0 | |].
  { intros n _; pose proof (Rmin_l 1 v1); pose proof (Rmin_r 1 v1); assert (0 < v1) by (unfold v1; lra); unfold v;
      destruct (n =? 1)%nat, (n =? 2)%nat, (side n); lra. }
  intros x Mx X HN HX; destruct (family_sum X HN (fun n Hn => proj1 (HX n Hn))) as (A & B & C & E & ->
    & [HA HA0] & HB & [HC HC0] & [HE HE0]).
  assert (Z3 : z * v1 <= z ^ 3 * v2 + gap) by (replace (z * v1) with (z ^ 3 * v2 + z * gap) by (unfold v1; ring);
    assert (z * gap <= 1 * gap) by (apply Rmult_le_compat_r; lra); lra).
  assert (One : z ^ 2 * v2 + k * s = 1 - 2 * gap) by (unfold v2, gap; field; lra).
  destruct (Nat.eq_dec x 1) as [->|X1]; [|destruct (Nat.eq_dec x 2) as [->|X2]].
  - change (v 1%nat) with v1; unfold v1; assert (A = 0) as ->. { apply HA0; intros I; apply (lower_apart 1 1);
                                                                   try assumption; apply (HX 1%nat I). }
    assert (C = 0) as ->. { apply HC0; intros n Hn; destruct (HX n Hn) as [Mn En]; destruct (side n) eqn:Sn; [|tauto];
                              destruct (lower_apart 1 n Mx Mn Sd1 Sn En). }
    assert (E = 0) as ->; [|lra]. { apply HE0; intros n Hn; destruct (HX n Hn) as [Mn En]; destruct (side n) eqn:Sn;
                                      [tauto|]; right.
      destruct (Nat.eq_dec n 2) as [|N2]; [assumption|]; destruct (proj1 (one_apart n HW Mn Sn N2) En). }
  - change (v 2%nat) with v2; lra.
  - assert (Vx : v x = match side x with D => 1 | U => k end) by (unfold v; rewrite (proj2 (Nat.eqb_neq _ _) X1),
      (proj2 (Nat.eqb_neq _ _) X2); reflexivity).
    rewrite Vx; destruct (side x) eqn:Sx.
    + assert (A = 0) as ->. { apply HA0; intros I; destruct (HX _ I) as [Mn En]; apply (lower_apart x 1); assumption. }
      assert (C = 0) as ->; [|lra]. { apply HC0; intros n Hn; destruct (HX n Hn) as [Mn En]; destruct (side n) eqn:Sn;
                                        [|tauto]; destruct (lower_apart x n Mx Mn Sx Sn En). }
    + assert (A = 0) as ->; [|lra]. apply HA0; intros I; destruct (HX _ I) as [Mn En];
        apply (proj2 (one_apart x HW Mx Sx X2) En).
Qed.
End Family.
End Plus.
