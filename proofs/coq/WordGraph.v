(** * W3, W4 and W5 hold wherever V lies on the path and one b decides along it

    Of region 3 (S2, S3) and region 4 (S5) only [decided] is used: V lies on the path,
    and along it the sign of one b decides. *)

From Coq Require Import Reals List Arith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementWords Algebra InsideTriangle WordAlgebra WordPath.
Import ListNotations.
Open Scope R_scope.

Definition decided (a1 a2 : R) (K : nat) : Prop :=
  (forall n, (n < K)%nat -> u a1 a2 n <> 0 -> member a1 a2 Minus n) /\
  (forall w i j, path a1 a2 K w i j -> on a1 a2 (i + j) U ->
   b a1 a2 (i + j) j > 0 -> member a1 a2 Plus (i + j)) /\
  (forall w i j, path a1 a2 K w i j -> on a1 a2 (i + j) D ->
   b a1 a2 (i + j) i > 0 -> member a1 a2 Plus (i + j)) /\
  forall n, member a1 a2 Plus n -> n = 1%nat \/ n = K \/
   exists w i j, path a1 a2 K w i j /\ n = (i + j)%nat.


Section Graph.
Variables (a1 a2 : R) (K : nat).
Hypothesis first : first_upper a1 a2 K.
Hypothesis decides : decided a1 a2 K.
Notation u := (u a1 a2).
Notation b := (b a1 a2).
Notation p := (p a1 a2).
Notation q := (q a1 a2).
Notation on := (on a1 a2).
Notation member := (member a1 a2).
Notation edge := (edge a1 a2).
Notation path := (path a1 a2 K).
Let a2_pos : 0 < a2. Proof. apply first. Qed.

(** ** Neighbours *)

Lemma zero_factor x y : y <> 0 -> x * y = 0 -> x = 0.
Proof. intros Hy E; apply Rmult_integral in E; tauto. Qed.

(** An edge j -> i of gamma > 0 needs a mediant in V above s; the other sign, one below. *)
Lemma back_edge w i j : path w i j -> let n := (i + j)%nat in
  (p i > q j <-> member Plus n /\ on n U) /\ (p j < q i <-> member Plus n /\ on n D).
Proof.
  intros H n; destruct (path_sides a1 a2 K first w i j H) as [Hi Hj].
  destruct (lower_upper a1 a2 K first i j Hi Hj) as (HM & HW & HW').
  destruct (DU a1 a2 i j Hi Hj) as (t & Ht & E & E'); fold n in E, E'.
  pose proof (not_both a1 a2 K first i j Hi Hj) as Hnb; fold n in Hnb.
  destruct (path_pos a1 a2 K w i j H) as [Hi1 HKj]; pose proof (K_ge_2 a1 a2 K first) as HK.
  assert (Hb : u n <> 0 -> b n i * u n = N a1 a2 n i /\ b n j * u n = N a1 a2 n j) by (intros Hu; split; apply b_N;
    assumption).
  destruct decides as (_ & Hup & Hdown & _); specialize (Hup w i j H); specialize (Hdown w i j H).
  fold n in Hup, Hdown; cbn [StatementWords.on] in *. split; (split; [intros Hlt|intros [[Hu HV] Hs]]).
  - assert (N a1 a2 n j < 0) by nra; specialize (HW Hlt). assert (N a1 a2 n i < 0) by nra.
    destruct (Rtotal_order (u n) 0) as [Hs|[Hs|Hs]].
    + destruct (Hb ltac:(lra)) as [_ E2]; split; [apply Hup; [assumption|nra] | assumption].
    + destruct (singular a1 a2 K first i j Hi Hj Hs); lra.
    + destruct (Hb ltac:(lra)) as [E1 E2]; exfalso; apply Hnb; [lra|nra|nra].
  - destruct (Hb Hu) as [_ E2]; pose proof (HV j ltac:(unfold n; lia)); cbn [sgn] in *; nra.
  - assert (0 < N a1 a2 n i) by nra; specialize (HW' Hlt). assert (0 < N a1 a2 n j) by nra.
    destruct (Rtotal_order (u n) 0) as [Hs|[Hs|Hs]].
    + destruct (Hb ltac:(lra)) as [E1 E2]; exfalso; apply Hnb; [lra|nra|nra].
    + destruct (singular a1 a2 K first i j Hi Hj Hs) as (_ & ? & _); lra.
    + destruct (Hb ltac:(lra)) as [E1 _]; split; [apply Hdown; [assumption|nra] | assumption].
  - destruct (Hb Hu) as [E1 _]; pose proof (HV i ltac:(unfold n; lia)); cbn [sgn] in *; nra.
Qed.

Lemma zeros w i j : path w i j -> let n := (i + j)%nat in (p i = q j <-> on n U /\ b n j = 0 \/ u n = 0 /\ a2 = 1) /\
  (p j = q i <-> on n D /\ b n i = 0 \/ u n = 0 /\ a2 = 1).
Proof.
  intros H n; destruct (path_sides a1 a2 K first w i j H) as [Hi Hj].
  destruct (lower_upper a1 a2 K first i j Hi Hj) as (HM & HW & HW').
  destruct (DU a1 a2 i j Hi Hj) as (t & Ht & E & E'); fold n in E, E'.
  pose proof (not_both a1 a2 K first i j Hi Hj) as Hnb; fold n in Hnb.
  destruct (path_pos a1 a2 K w i j H) as [Hi1 HKj]; pose proof (K_ge_2 a1 a2 K first) as HK.
  assert (Hb : u n <> 0 -> b n i * u n = N a1 a2 n i /\ b n j * u n = N a1 a2 n j) by (intros Hu; split; apply b_N;
    assumption).
  pose proof (back_edge w i j H) as Hback; fold n in Hback; cbv zeta in Hback.
  destruct decides as (_ & Hup & Hdown & _); specialize (Hup w i j H); specialize (Hdown w i j H).
  fold n in Hup, Hdown; cbn [StatementWords.on] in *.
  assert (Hsing : u n = 0 -> (p i = q j <-> a2 = 1) /\ (p j = q i <-> a2 = 1)) by (intros H0;
    apply (singular a1 a2 K first i j Hi Hj H0)).
  split; (split; [intros Heq|intros [[Hs H0]|[H0 H1]]]).
  - assert (H0 : N a1 a2 n j = 0) by (rewrite Heq, Rminus_eq_0 in E; clear - E; lra).
    destruct (Rtotal_order (u n) 0) as [Hs|[Hs|Hs]]; [left | right; tauto | exfalso].
    + destruct (Hb ltac:(lra)) as [_ E2]; split; [assumption | apply (zero_factor _ (u n)); lra].
    + destruct (Hb ltac:(lra)) as [E1 E2]; assert (b n j = 0) by (apply (zero_factor _ (u n)); lra).
      assert (0 < b n i) by (apply Rnot_le_lt; intros ?; apply Hnb; lra).
      assert (HV : member Plus n) by (apply Hdown; lra).
      destruct HV as [_ HV]; specialize (HV j ltac:(unfold n; lia)); cbn [sgn] in HV; lra.
  - destruct (Hb ltac:(lra)) as [_ E2]; rewrite H0 in E2. apply Rminus_diag_uniq, (zero_factor _ t); lra.
  - apply Hsing; assumption.
  - assert (H0 : N a1 a2 n i = 0) by (rewrite Heq, Rminus_eq_0 in E'; clear - E'; lra).
    destruct (Rtotal_order (u n) 0) as [Hs|[Hs|Hs]]; [exfalso | right; tauto | left].
    + destruct (Hb ltac:(lra)) as [E1 E2]; assert (b n i = 0) by (apply (zero_factor _ (u n)); lra).
      assert (0 < b n j) by (apply Rnot_le_lt; intros ?; apply Hnb; lra).
      assert (HV : member Plus n) by (apply Hup; lra).
      destruct HV as [_ HV]; specialize (HV i ltac:(unfold n; lia)); cbn [sgn] in HV; lra.
    + destruct (Hb ltac:(lra)) as [E1 _]; split; [assumption | apply (zero_factor _ (u n)); lra].
  - destruct (Hb ltac:(lra)) as [E1 _]; rewrite H0 in E1. apply Rminus_diag_uniq, (zero_factor _ t); lra.
  - apply Hsing; assumption.
Qed.

(** ** W3: ancestors *)

(** One inequality serves both sides of s and both parents. *)
Lemma parents w i j : path w i j -> member Plus (i + j) -> q j < q i.
Proof.
  intros H HV; destruct (path_sides a1 a2 K first w i j H) as [Hi Hj]. pose proof (a1_in a1 a2 K first) as H1.
  pose proof (lower_pq a1 a2 (a2_in a1 a2 K first) H1 i Hi). pose proof (upper_pq a1 a2 (a2_in a1 a2 K first) H1 j Hj).
  destruct (back_edge w i j H) as [[_ HU] [_ HD]]; destruct (Rdichotomy _ _ (proj1 HV)) as [Hs|Hs].
  - specialize (HU (conj HV Hs)); lra.
  - specialize (HD (conj HV Hs)); lra.
Qed.

Lemma initial_piece w i j : path w i j -> member Plus (i + j) -> Forall (fun x => member Plus (fst x)) (vertices K w).
Proof.
  induction 1 as [|w i j H IH Hon|w i j H IH Hon]; intros HV.
  - unfold vertices; rewrite !Forall_cons_iff; cbn [periods fst].
    split; [apply member_one | split; [apply member_K, first | constructor]].
  - pose proof (parents _ _ _ (path_D a1 a2 K w i j H Hon) HV) as Hq.
    destruct (path_sides a1 a2 K first w i j H) as [Hi Hj].
    destruct (path_pos a1 a2 K w i j H) as [Hi1 HKj]; pose proof (K_ge_2 a1 a2 K first).
    pose proof (I3 a1 a2 (i + j) j ltac:(lia) ltac:(cbn [StatementWords.on] in Hon; lra) ltac:(lra)) as E.
    replace (i + j - j)%nat with i in E by lia; pose proof (pow_lt a2 j a2_pos).
    assert (Hij : member Plus (i + j)) by (apply (proj1 (proj2 (proj2 decides)) w i j H Hon); nra).
    rewrite (vertices_snoc a1 a2 K w i j D H), Forall_app; split; [apply IH, Hij|].
    rewrite Forall_cons_iff; split; [assumption | constructor].
  - pose proof (parents _ _ _ (path_U a1 a2 K w i j H Hon) HV) as Hq.
    destruct (path_sides a1 a2 K first w i j H) as [Hi Hj].
    destruct (path_pos a1 a2 K w i j H) as [Hi1 HKj]; pose proof (K_ge_2 a1 a2 K first).
    pose proof (I3 a1 a2 (i + j) i ltac:(lia) ltac:(cbn [StatementWords.on] in Hon; lra) ltac:(lra)) as E.
    replace (i + j - i)%nat with j in E by lia; pose proof (pow_lt a2 i a2_pos).
    assert (Hij : member Plus (i + j)) by (apply (proj1 (proj2 decides) w i j H Hon); nra).
    rewrite (vertices_snoc a1 a2 K w i j U H), Forall_app; split; [apply IH, Hij|].
    rewrite Forall_cons_iff; split; [assumption | constructor].
Qed.

(** ** W5: the table *)

Lemma pairs w i j : path w i j -> (forall k, In (k, D) (vertices K w) -> (k <= i)%nat) /\
  (forall k, In (k, U) (vertices K w) -> (k <= j)%nat) /\ In (i, D) (vertices K w) /\ In (j, U) (vertices K w) /\
  (forall k l, (i <= k)%nat -> (j <= l)%nat -> renewed k l 1 K w = None) /\ (forall k l, In (k, D) (vertices K w) ->
  (j <= l)%nat -> renewed k l 1 K w = if (k =? i)%nat then None else Some D) /\ (forall k l, In (l, U) (vertices K w) ->
  (i <= k)%nat -> renewed k l 1 K w = if (l =? j)%nat then None else Some U).
Proof.
  induction 1 as [|w i j H IH Hon|w i j H IH Hon].
  - cbn [vertices periods renewed]; repeat split.
    + intros k [E|[E|[]]]; inversion E; lia.
    + intros k [E|[E|[]]]; inversion E; lia.
    + left; reflexivity.
    + right; left; reflexivity.
    + intros k l [E|[E|[]]] _; inversion E; subst; reflexivity.
    + intros k l [E|[E|[]]] _; inversion E; subst; rewrite Nat.eqb_refl; reflexivity.
  - destruct IH as (I1 & I2 & I3 & I4 & I5 & I6 & I7).
    destruct (path_pos a1 a2 K w i j H) as [Hi1 HKj]; pose proof (K_ge_2 a1 a2 K first).
    assert (HR : forall k l, renewed k l 1 K (w ++ [D]) = match renewed k l 1 K w with Some y => Some y |
      None => if (i =? k)%nat then Some D else None end) by (intros; rewrite renewed_snoc, (path_final a1 a2 K _ _ _ H);
      reflexivity).
    rewrite (vertices_snoc a1 a2 K w i j D H).
    assert (HD : forall k, In (k, D) (vertices K w ++ [((i + j)%nat, D)]) -> In (k, D) (vertices K w) \/
      k = (i + j)%nat).
    { intros k Hk; apply in_app_iff in Hk as [Hk|[E|[]]]; [tauto | inversion E; tauto]. }
    assert (HU : forall k, In (k, U) (vertices K w ++ [((i + j)%nat, D)]) -> In (k, U) (vertices K w)).
    { intros k Hk; apply in_app_iff in Hk as [Hk|[E|[]]]; [tauto | inversion E]. }
    repeat split.
    + intros k Hk; apply HD in Hk as [Hk| ->]; [apply I1 in Hk|]; lia.
    + intros k Hk; apply I2, HU, Hk.
    + apply in_app_iff; right; left; reflexivity.
    + apply in_app_iff; left; assumption.
    + intros k l Hk Hl; rewrite HR, I5 by lia; destruct (Nat.eqb_spec i k); [lia | reflexivity].
    + intros k l Hk Hl; rewrite HR; apply HD in Hk as [Hk| ->].
      * rewrite (I6 k l Hk Hl); specialize (I1 k Hk).
        destruct (Nat.eqb_spec k i), (Nat.eqb_spec i k), (Nat.eqb_spec k (i + j)); lia || reflexivity.
      * rewrite I5 by lia; rewrite Nat.eqb_refl; destruct (Nat.eqb_spec i (i + j)); [lia | reflexivity].
    + intros k l Hk Hl; apply HU in Hk; rewrite HR, (I7 k l Hk) by lia.
      destruct (Nat.eqb_spec l j), (Nat.eqb_spec i k); lia || reflexivity.
  - destruct IH as (I1 & I2 & I3 & I4 & I5 & I6 & I7).
    destruct (path_pos a1 a2 K w i j H) as [Hi1 HKj]; pose proof (K_ge_2 a1 a2 K first).
    assert (HR : forall k l, renewed k l 1 K (w ++ [U]) = match renewed k l 1 K w with Some y => Some y |
      None => if (j =? l)%nat then Some U else None end) by (intros; rewrite renewed_snoc, (path_final a1 a2 K _ _ _ H);
      reflexivity).
    rewrite (vertices_snoc a1 a2 K w i j U H).
    assert (HU : forall k, In (k, U) (vertices K w ++ [((i + j)%nat, U)]) -> In (k, U) (vertices K w) \/
      k = (i + j)%nat).
    { intros k Hk; apply in_app_iff in Hk as [Hk|[E|[]]]; [tauto | inversion E; tauto]. }
    assert (HD : forall k, In (k, D) (vertices K w ++ [((i + j)%nat, U)]) -> In (k, D) (vertices K w)).
    { intros k Hk; apply in_app_iff in Hk as [Hk|[E|[]]]; [tauto | inversion E]. }
    repeat split.
    + intros k Hk; apply I1, HD, Hk.
    + intros k Hk; apply HU in Hk as [Hk| ->]; [apply I2 in Hk|]; lia.
    + apply in_app_iff; left; assumption.
    + apply in_app_iff; right; left; reflexivity.
    + intros k l Hk Hl; rewrite HR, I5 by lia; destruct (Nat.eqb_spec j l); [lia | reflexivity].
    + intros k l Hk Hl; apply HD in Hk; rewrite HR, (I6 k l Hk) by lia.
      destruct (Nat.eqb_spec k i), (Nat.eqb_spec j l); lia || reflexivity.
    + intros k l Hk Hl; rewrite HR; apply HU in Hk as [Hk| ->].
      * rewrite (I7 k l Hk Hl); specialize (I2 l Hk).
        destruct (Nat.eqb_spec l j), (Nat.eqb_spec j l), (Nat.eqb_spec l (i + j)); lia || reflexivity.
      * rewrite I5 by lia; rewrite Nat.eqb_refl; destruct (Nat.eqb_spec j (i + j)); [lia | reflexivity].
Qed.

Definition table (w : list letter) (i j : nat) : Prop := forall k l,
  In (k, D) (vertices K w) -> In (l, U) (vertices K w) ->
  match renewed k l 1 K w with
  | Some U => q l < p k /\ q k < p l
  | Some D => p k < q l /\ p l < q k
  | None => k = i /\ l = j
  end.

Lemma word_table w i j : path w i j -> Forall (fun x => member Plus (fst x)) (vertices K w) -> table w i j.
Proof.
  induction 1 as [|w i j H IH Hon|w i j H IH Hon]; intros HV.
  - intros k l [E|[E|[]]] [E'|[E'|[]]]; inversion E; inversion E'; subst; split; reflexivity.
  - destruct (path_sides a1 a2 K first w i j H) as [Hi Hj].
    rewrite (vertices_snoc a1 a2 K w i j D H), Forall_app, Forall_cons_iff in HV.
    destruct HV as [HV [Hn _]]; specialize (IH HV); cbn [fst] in Hn.
    destruct (pairs w i j H) as (I1 & I2 & I3 & I4 & I5 & I6 & I7).
    pose proof (proj2 (proj2 (back_edge w i j H)) (conj Hn Hon)) as Hedge.
    destruct (path_pos a1 a2 K w i j H) as [Hi1 HKj]; pose proof (K_ge_2 a1 a2 K first).
    intros k l Hk Hl; rewrite (vertices_snoc a1 a2 K w i j D H), in_app_iff in Hk, Hl.
    rewrite renewed_snoc, (path_final a1 a2 K _ _ _ H); cbn [fst snd renewed].
    destruct Hl as [Hl|[E|[]]]; [|inversion E]. destruct Hk as [Hk|[E|[]]]; [|injection E as <-].
    + specialize (IH k l Hk Hl); destruct (renewed k l 1 K w); [assumption|].
      destruct IH as [-> ->]; rewrite Nat.eqb_refl; split; [|assumption].
      apply (lower_upper a1 a2 K first i j Hi Hj); assumption.
    + rewrite I7 by (assumption || lia); destruct (Nat.eqb_spec l j) as [->|Hlj].
      * destruct (Nat.eqb_spec i (i + j)); [lia | split; reflexivity].
      * specialize (IH i l I3 Hl); rewrite I7 in IH by (assumption || lia).
        destruct (Nat.eqb_spec l j); [tauto|]; destruct IH as [IH _].
        pose proof (vertices_on a1 a2 K first w i j H l U Hl) as Hul.
        destruct (nested a1 a2 Plus a2_pos i (i + j) ltac:(lia) Hn) as [Hnest _].
        destruct Hnest as [Hnest _]; [cbn [sgn]; lra|]. assert (q l < p (i + j)) by lra; split; [assumption|].
        apply (lower_upper a1 a2 K first (i + j) l Hon Hul); assumption.
  - destruct (path_sides a1 a2 K first w i j H) as [Hi Hj].
    rewrite (vertices_snoc a1 a2 K w i j U H), Forall_app, Forall_cons_iff in HV.
    destruct HV as [HV [Hn _]]; specialize (IH HV); cbn [fst] in Hn.
    destruct (pairs w i j H) as (I1 & I2 & I3 & I4 & I5 & I6 & I7).
    pose proof (proj2 (proj1 (back_edge w i j H)) (conj Hn Hon)) as Hedge.
    destruct (path_pos a1 a2 K w i j H) as [Hi1 HKj]; pose proof (K_ge_2 a1 a2 K first).
    intros k l Hk Hl; rewrite (vertices_snoc a1 a2 K w i j U H), in_app_iff in Hk, Hl.
    rewrite renewed_snoc, (path_final a1 a2 K _ _ _ H); cbn [fst snd renewed].
    destruct Hk as [Hk|[E|[]]]; [|inversion E]. destruct Hl as [Hl|[E|[]]]; [|injection E as <-].
    + specialize (IH k l Hk Hl); destruct (renewed k l 1 K w); [assumption|].
      destruct IH as [-> ->]; rewrite Nat.eqb_refl; split; [assumption|].
      apply (lower_upper a1 a2 K first i j Hi Hj); assumption.
    + rewrite I6 by (assumption || lia); destruct (Nat.eqb_spec k i) as [->|Hki].
      * destruct (Nat.eqb_spec j (i + j)); [lia | split; reflexivity].
      * specialize (IH k j Hk I4); rewrite I6 in IH by (assumption || lia).
        destruct (Nat.eqb_spec k i); [tauto|]; destruct IH as [_ IH].
        pose proof (vertices_on a1 a2 K first w i j H k D Hk) as Hdk.
        destruct (nested a1 a2 Plus a2_pos j (i + j) ltac:(lia) Hn) as [_ Hnest].
        destruct Hnest as [Hnest _]; [cbn [sgn]; lra|]. assert (p (i + j) < q k) by lra; split; [|assumption].
        apply (lower_upper a1 a2 K first k (i + j) Hdk Hon); assumption.
Qed.

End Graph.
