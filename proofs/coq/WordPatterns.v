(** * From the table to patterns: W4, W5 and W6 at a point where the path is decided *)

From Coq Require Import Reals List Arith Lra Lia Classical.
From Grazing Require Import Defs Statement StatementPlane StatementWords Algebra
  InsideTriangle WordAlgebra WordPath WordGraph.
Import ListNotations.
Open Scope R_scope.

(** ** Walks *)

Lemma walk_map {S T} (f : S -> T) (E : T -> T -> Prop) l : forall x y,
  walk E (f x) (map f l) (f y) <-> walk (fun x y => E (f x) (f y)) x l y.
Proof. induction l as [|z l IH]; intros x y; cbn [map walk]; [tauto | rewrite IH; tauto]. Qed.

Lemma walk_iff {T} (E F : T -> T -> Prop) (P : T -> Prop) : (forall x y, P x -> P y -> (E x y <-> F x y)) ->
  forall l x y, P x -> P y -> Forall P l -> (walk E x l y <-> walk F x l y).
Proof.
  intros H; induction l as [|z l IH]; intros x y Hx Hy Hl; cbn [walk]; [apply H; assumption|].
  apply Forall_cons_iff in Hl as [Hz Hl]; rewrite (H x z), (IH z y) by assumption; tauto.
Qed.

(** The last edge of a walk. *)
Lemma walk_last {T} (E : T -> T -> Prop) l : forall x y, walk E x l y -> exists z, E z y /\ (z = x \/ In z l).
Proof.
  induction l as [|z l IH]; intros x y; cbn [walk]; [eauto|]; intros [_ H].
  destruct (IH z y H) as (t & Ht & [->|Hin]); cbn [In]; eauto.
Qed.

(** If every edge leads to one vertex, there is at most one cycle through each. *)
Lemma one_target {T} (E : T -> T -> Prop) t : (forall x y, E x y -> y = t) -> ~ two_cycles E.
Proof.
  intros H (v & l & l' & Hne & Hl & Hl' & Hw & Hw').
  assert (Hnil : forall l, ~ In v l -> walk E v l v -> l = []).
  { clear l l' Hne Hl Hl' Hw Hw'; intros [|z l] Hl Hw; [reflexivity|exfalso].
    destruct (walk_last _ _ _ _ Hw) as (y & Hy & _); apply H in Hy.
    destruct Hw as [Hz _]; apply H in Hz; apply Hl; left; congruence. }
  apply Hne; rewrite (Hnil l), (Hnil l'); trivial.
Qed.

Lemma two_loops {T} (E : T -> T -> Prop) i j : i <> j -> E i i -> E i j -> E j i -> two_cycles E.
Proof.
  intros Hne Hi Hij Hji; exists i, [], [j]; cbn [In walk].
  repeat split; try assumption; try tauto; [discriminate | intros [->|[]]; tauto].
Qed.

Section Patterns.
Variables (a1 a2 : R) (K : nat).
Hypothesis first : first_upper a1 a2 K.
Hypothesis decides : decided a1 a2 K.
Notation u := (u a1 a2).
Notation p := (p a1 a2).
Notation q := (q a1 a2).
Notation on := (on a1 a2).
Notation member := (member a1 a2).
Notation edge := (edge a1 a2).
Notation path := (path a1 a2 K).
Notation pattern := (pattern a1 a2).
Let a2_pos : 0 < a2. Proof. apply first. Qed.

Lemma edge_either e g h i j : edge e g i j -> edge e h i j -> g = h.
Proof. unfold StatementWords.edge; destruct e, g, h; cbn [sgn]; intros; reflexivity || (exfalso; lra). Qed.

Lemma vertices_app w t v : In v (vertices K w) -> In v (vertices K (w ++ t)).
Proof.
  unfold vertices; intros [H|[H|H]]; [left; exact H | right; left; exact H | right; right].
  revert H; generalize 1%nat, K; clear; induction w as [|x w IH]; intros i j H; [destruct H|].
  destruct x; cbn [app periods In] in *; (destruct H as [H|H]; [left; exact H | right; apply IH, H]).
Qed.

Lemma vertex_K_or_later w i j : path w i j -> forall x t, In ((i + j)%nat, x) (vertices K (w ++ x :: t)).
Proof.
  intros H x t; replace (w ++ x :: t) with ((w ++ [x]) ++ t) by (rewrite <- app_assoc; reflexivity).
  apply vertices_app; rewrite (vertices_snoc a1 a2 K w i j x H), in_app_iff; right; left; reflexivity.
Qed.

Lemma members_vertices w i j : path w i j -> member Plus (i + j) ->
  forall x, In x (vertices K w) -> member Plus (fst x).
Proof. intros H HV; apply Forall_forall, (initial_piece a1 a2 K first decides w i j H HV). Qed.

(** ** W5 *)

Lemma word_edges w i j : path w i j -> Forall (fun x => member Plus (fst x)) (vertices K w) ->
  forall x y, In x (vertices K w) -> In y (vertices K w) ->
  ends a1 a2 i j \/ (fst x + fst y <> i + j)%nat ->
  edge Plus (if arrow K w x y then Plus else Minus) (fst x) (fst y).
Proof.
  intros H HV x y Hx Hy Hends. pose proof (word_table a1 a2 K first decides w i j H HV) as HT.
  pose proof (back_edge a1 a2 K first decides w i j H) as [HbU HbD].
  assert (Horb : forall k s, In (k, s) (vertices K w) -> orbit a1 a2 k Plus (case_of s)).
  { intros k s Hk; apply (orbit_on a1 a2 K first); [apply (vertices_on a1 a2 K first w i j H), Hk|].
    rewrite Forall_forall in HV; apply (HV _ Hk). }
  assert (Hlast : ends a1 a2 i j -> p i < q j /\ q i < p j).
  { intros (Hno & H1 & H2); cbn zeta in HbU, HbD.
    split; apply Rnot_le_lt; intros [Hle|E]; try lra; apply Hno; [apply HbU | apply HbD]; lra. }
  destruct x as [k []], y as [l []]; cbn [fst arrow] in *.
  - apply (full_shift a1 a2 Plus a2_pos Minus); apply (Horb _ D); assumption.
  - specialize (HT k l Hx Hy); destruct (renewed k l 1 K w) as [[]|]; unfold StatementWords.edge; cbn [sgn];
      [lra | lra |].
    destruct HT as [-> ->]; destruct Hends as [He|]; [apply Hlast in He; lra | tauto].
  - specialize (HT l k Hy Hx); destruct (renewed l k 1 K w) as [[]|]; unfold StatementWords.edge; cbn [sgn];
      [lra | lra |].
    destruct HT as [-> ->]; destruct Hends as [He|]; [apply Hlast in He; lra | lia].
  - apply (full_shift a1 a2 Plus a2_pos Plus); apply (Horb _ U); assumption.
Qed.

Lemma V_is_word w i j : path w i j -> ~ member Plus (i + j) ->
  forall n, member Plus n -> exists x, In x (vertices K w) /\ fst x = n.
Proof.
  intros H Hno n HV; destruct (proj2 (proj2 (proj2 decides)) n HV) as [->|[->|(w' & i' & j' & H' & ->)]].
  - exists (1%nat, D); split; [left|]; reflexivity.
  - exists (K, U); split; [right; left|]; reflexivity.
  - destruct (paths_agree a1 a2 K first w i j w' i' j' H H') as [[[|x t] ->]|(x & t & ->)].
    + rewrite app_nil_r in H'; destruct (path_unique a1 a2 K _ _ _ _ _ H H') as [<- <-]; tauto.
    + exfalso; apply Hno, (members_vertices _ _ _ H' HV ((i + j)%nat, x)), (vertex_K_or_later w i j H).
    + exists ((i' + j')%nat, x); split; [apply (vertex_K_or_later w' i' j' H') | reflexivity].
Qed.

Lemma word_patterns w i j : path w i j -> Forall (fun x => member Plus (fst x)) (vertices K w) ->
  ends a1 a2 i j -> forall g l, pattern Plus g l <-> exists l', l = map fst l' /\
  incl l' (vertices K w) /\ cyclic (fun x y => (if arrow K w x y then Plus else Minus) = g) l'.
Proof.
  intros H HV He g l.
  assert (HE : forall x y, In x (vertices K w) -> In y (vertices K w) -> (edge Plus g (fst x) (fst y) <->
    (if arrow K w x y then Plus else Minus) = g)).
  { intros x y Hx Hy; pose proof (word_edges w i j H HV x y Hx Hy (or_introl He)) as Hxy.
    split; [apply (edge_either _ _ _ _ _ Hxy) | intros <-; exact Hxy]. }
  split.
  - intros [Hl Hc]; assert (exists l', l = map fst l' /\ incl l' (vertices K w)) as (l' & -> & Hincl).
    { clear Hc; induction l as [|n l IH]; [exists []; split; [reflexivity | intros ? []]|].
      apply Forall_cons_iff in Hl as [Hn Hl]; destruct (IH Hl) as (l' & -> & Hl').
      destruct (V_is_word w i j H (proj1 He) n Hn) as (x & Hx & <-).
      exists (x :: l'); split; [reflexivity | intros z [<-|Hz]; auto]. }
    exists l'; split; [reflexivity | split; [assumption|]]; destruct l' as [|x l']; [exact Hc|].
    cbn [map cyclic] in *; rewrite walk_map in Hc; revert Hc.
    apply (walk_iff _ _ (fun x => In x (vertices K w)) HE); [apply Hincl; left; reflexivity..|].
    apply Forall_forall; intros z Hz; apply Hincl; right; assumption.
  - intros (l' & -> & Hincl & Hc); split.
    + apply Forall_map, Forall_forall; intros x Hx; rewrite Forall_forall in HV; apply HV, Hincl, Hx.
    + destruct l' as [|x l']; [exact Hc|]; cbn [map cyclic] in *; rewrite walk_map; revert Hc.
      apply (walk_iff _ _ (fun x => In x (vertices K w)) HE); [apply Hincl; left; reflexivity..|].
      apply Forall_forall; intros z Hz; apply Hincl; right; assumption.
Qed.

(** ** W4 *)

Lemma pattern_two e g i j : pattern e g [i; j] <-> member e i /\ member e j /\ edge e g i j /\ edge e g j i.
Proof.
  unfold StatementWords.pattern; cbn [cyclic walk]; rewrite !Forall_cons_iff. split; [tauto | intuition constructor].
Qed.

Lemma twins w i j : path w i j -> forall g, pattern Plus g [i; j] <-> orbit a1 a2 (i + j) Plus g.
Proof.
  intros H g; rewrite pattern_two; destruct (back_edge a1 a2 K first decides w i j H) as [HU HD].
  destruct (path_sides a1 a2 K first w i j H) as [Hi Hj].
  destruct (lower_upper a1 a2 K first i j Hi Hj) as (HM & HW & HW').
  rewrite (orbit_case a1 a2 K first); unfold StatementWords.edge; split.
  - intros (_ & _ & H1 & H2); destruct g; cbn [sgn] in *.
    + destruct (proj1 HU ltac:(lra)); exists U; tauto.
    + destruct (proj1 HD ltac:(lra)); exists D; tauto.
  - intros (x & Hx & -> & HV); pose proof (members_vertices w i j H HV) as Hall.
    destruct (pairs a1 a2 K first decides w i j H) as (_ & _ & I3 & I4 & _).
    split; [apply (Hall _ I3) | split; [apply (Hall _ I4)|]]. destruct x; cbn [case_of sgn].
    + pose proof (proj2 HD (conj HV Hx)); specialize (HW' ltac:(lra)); lra.
    + pose proof (proj2 HU (conj HV Hx)); specialize (HW ltac:(lra)); lra.
Qed.

Lemma not_parents w i j k x y g : path w i j -> In (k, x) (vertices K w) -> on (i + j) y -> x = y \/ k <> i /\ k <> j ->
  (pattern Plus g [k; (i + j)%nat] <-> member Plus (i + j) /\ g = case_of x).
Proof.
  intros H Hk Hy Hxy; set (n := (i + j)%nat) in *.
  assert (Hboth : member Plus n -> edge Plus (case_of x) k n /\ edge Plus (case_of x) n k).
  { intros HV; pose proof (members_vertices w i j H HV) as Hall.
    assert (Horb : forall l s, on l s -> member Plus l -> orbit a1 a2 l Plus (case_of s)) by (intros l s Hs;
      apply (orbit_on a1 a2 K first), Hs).
    pose proof (vertices_on a1 a2 K first w i j H k x Hk) as Hkx.
    destruct (pairs a1 a2 K first decides w i j H) as (I1 & I2 & I3 & I4 & I5 & I6 & I7).
    destruct (path_pos a1 a2 K w i j H) as [Hi1 HKj]; pose proof (K_ge_2 a1 a2 K first).
    assert (HF : forall z, Forall (fun x => member Plus (fst x)) (vertices K (w ++ [z]))).
    { intros z; rewrite (vertices_snoc a1 a2 K w i j z H), Forall_app, Forall_cons_iff.
      split; [apply Forall_forall, Hall | split; [assumption | constructor]]. }
    destruct x, y; cbn [StatementWords.on] in *.
    - split; apply full_shift; trivial; apply (Horb _ D); trivial; apply (Hall _ Hk).
    - destruct Hxy as [|[Hki _]]; [discriminate|].
      pose proof (word_table a1 a2 K first decides _ _ _ (path_U a1 a2 K w i j H Hy) (HF U) k n) as HT.
      rewrite (vertices_snoc a1 a2 K w i j U H), renewed_snoc, I6 in HT by (assumption || lia).
      destruct (Nat.eqb_spec k i); [tauto|].
      destruct HT as [? ?]; [apply in_app_iff; tauto | apply in_app_iff; right; left; reflexivity|].
      unfold StatementWords.edge; cbn [sgn case_of]; lra.
    - destruct Hxy as [|[_ Hkj]]; [discriminate|].
      pose proof (word_table a1 a2 K first decides _ _ _ (path_D a1 a2 K w i j H Hy) (HF D) n k) as HT.
      rewrite (vertices_snoc a1 a2 K w i j D H), renewed_snoc, I7 in HT by (assumption || lia).
      destruct (Nat.eqb_spec k j); [tauto|].
      destruct HT as [? ?]; [apply in_app_iff; right; left; reflexivity | apply in_app_iff; tauto|].
      unfold StatementWords.edge; cbn [sgn case_of]; lra.
    - split; apply full_shift; trivial; apply (Horb _ U); trivial; apply (Hall _ Hk). }
  rewrite pattern_two; split.
  - intros (_ & HV & H1 & _); split; [assumption|]. apply (edge_either _ _ _ _ _ H1), Hboth, HV.
  - intros [HV ->]; split; [apply (members_vertices w i j H HV _ Hk)|]; tauto.
Qed.

Lemma ancestors_only k n g : (k < n)%nat -> pattern Plus g [k; n] -> k = 1%nat /\ n = K \/
  exists w i j x, path w i j /\ n = (i + j)%nat /\ In (k, x) (vertices K w).
Proof.
  rewrite pattern_two; intros Hkn (Hk & Hn & _); pose proof (u_nonzero_pos a1 a2 k (proj1 Hk)).
  pose proof (K_ge_2 a1 a2 K first); destruct decides as (_ & _ & _ & HP).
  destruct (HP n Hn) as [->|[->|(w & i & j & H' & ->)]]; [lia| |right].
  - left; split; [|reflexivity]; destruct (HP k Hk) as [->|[->|(w & i & j & Hp & ->)]]; [reflexivity|lia|].
    pose proof (path_pos a1 a2 K w i j Hp); lia.
  - exists w, i, j; destruct (HP k Hk) as [->|[->|(w' & i' & j' & Hp & ->)]].
    + exists D; repeat split; trivial; left; reflexivity.
    + exists U; repeat split; trivial; right; left; reflexivity.
    + destruct (paths_agree a1 a2 K first w i j w' i' j' H' Hp) as [[[|x t] ->]|(x & t & ->)].
      * rewrite app_nil_r in Hp; destruct (path_unique a1 a2 K _ _ _ _ _ H' Hp); lia.
      * destruct (path_prefix a1 a2 K first w x t i' j' Hp) as (i0 & j0 & Hp0 & _ & _ & Hi & Hj).
        destruct (path_unique a1 a2 K _ _ _ _ _ H' Hp0) as [<- <-]. destruct x; cbn [final fst snd] in *; lia.
      * exists x; repeat split; trivial; apply (vertex_K_or_later w' i' j' Hp).
Qed.

(** ** e mu < 0 *)

Lemma Minus_members n : member Minus n <-> (n < K)%nat /\ u n <> 0.
Proof.
  split; [|intros [Hn Hu]; apply (proj1 decides); assumption].
  intros HV; split; [|apply HV]; apply Nat.nle_gt; intros Hle.
  pose proof (K_ge_2 a1 a2 K first) as HK2; pose proof (K_upper a1 a2 K first) as HKu.
  destruct (Nat.eq_dec n K) as [->|Hne].
  - pose proof (member_K a1 a2 K first) as [_ H1]; destruct HV as [_ H2].
    specialize (H1 1%nat ltac:(lia)); specialize (H2 1%nat ltac:(lia)); cbn [sgn] in *; lra.
  - destruct (nested a1 a2 Minus a2_pos K n ltac:(lia) HV) as [H1 _].
    destruct (nested a1 a2 Minus a2_pos 1 n ltac:(lia) HV) as [_ H2].
    pose proof (on_one a1 a2) as H3; cbn [StatementWords.on sgn] in *.
    destruct (lower_upper a1 a2 K first 1 K H3 HKu) as [HM _].
    destruct H1 as [H1 _]; [lra|]; destruct H2 as [H2 _]; lra.
Qed.

Lemma Minus_orbit n : member Minus n -> orbit a1 a2 n Minus Plus.
Proof.
  intros HV; pose proof HV as [Hn Hu]%Minus_members; destruct HV as [_ Hb].
  pose proof (proj2 (proj2 (proj2 first)) n Hn) as Hpos.
  destruct (sign_c a1 a2 (a2_in a1 a2 K first) (a1_in a1 a2 K first) n Hu) as [Hc _].
  split; [assumption | split; [assumption | cbn [sgn]; specialize (Hc ltac:(lra)); lra]].
Qed.

Lemma Minus_patterns g l : pattern Minus g l <-> g = Plus /\ l <> [] /\ Forall (fun n => (n < K)%nat /\ u n <> 0) l.
Proof.
  split.
  - intros [Hl Hc]; destruct l as [|n l]; [destruct Hc|]; split; [|split; [discriminate|]].
    + pose proof Hl as Hl'; apply Forall_cons_iff in Hl' as [Hn _]. destruct (walk_last _ _ _ _ Hc) as (k & Hk & Hin).
      assert (member Minus k) by (destruct Hin as [->|Hin]; [|rewrite Forall_forall in Hl; apply Hl; right];
        assumption).
      apply (edge_either _ _ _ _ _ Hk), full_shift; trivial; apply Minus_orbit; assumption.
    + revert Hl; apply Forall_impl, Minus_members.
  - intros (-> & Hne & Hl); apply (proj2 (W1 a1 a2 Minus a2_pos)); [assumption|].
    revert Hl; apply Forall_impl; intros n Hn; apply Minus_orbit, Minus_members, Hn.
Qed.

(** ** W6 *)

Lemma second_upper i j : member Plus i -> member Plus j -> on i D -> on j U -> q j < p i ->
  exists j', j' <> j /\ member Plus j' /\ on j' U.
Proof.
  intros Hi Hj Di Uj Hlt; pose proof (member_K a1 a2 K first) as HK.
  pose proof (K_upper a1 a2 K first) as UK; pose proof (K_ge_2 a1 a2 K first).
  destruct (Nat.eq_dec K j) as [<-|Hne]; [|exists K; tauto].
  assert (Hnext : forall w, path w i K -> exists j', j' <> K /\ member Plus j' /\ on j' U).
  { intros w Hw; pose proof (path_pos a1 a2 K w i K Hw).
    destruct (back_edge a1 a2 K first decides w i K Hw) as [[Hn _] _]. exists (i + K)%nat; split; [lia | apply Hn,
      Hlt]. }
  destruct (proj2 (proj2 (proj2 decides)) i Hi) as [->|[->|(w & i' & j' & Hw & ->)]].
  - apply (Hnext []), path_start.
  - cbn [StatementWords.on] in *; lra.
  - destruct (pairs a1 a2 K first decides w i' j' Hw) as (_ & _ & _ & I4 & _). destruct (Nat.eq_dec j' K) as [->|Hne].
    + apply (Hnext (w ++ [D])), path_D; assumption.
    + exists j'; split; [assumption | split]; [apply (members_vertices w i' j' Hw Hi _ I4)|].
      apply (path_sides a1 a2 K first w i' j' Hw).
Qed.

Lemma second_lower i j : member Plus i -> member Plus j -> on i D -> on j U -> p j < q i ->
  exists i', i' <> i /\ member Plus i' /\ on i' D.
Proof.
  intros Hi Hj Di Uj Hlt; pose proof (member_one a1 a2 Plus) as H1.
  pose proof (on_one a1 a2) as D1; pose proof (K_ge_2 a1 a2 K first).
  destruct (Nat.eq_dec 1 i) as [<-|Hne]; [|exists 1%nat; tauto].
  assert (Hnext : forall w, path w 1 j -> exists i', i' <> 1%nat /\ member Plus i' /\ on i' D).
  { intros w Hw; pose proof (path_pos a1 a2 K w 1 j Hw).
    destruct (back_edge a1 a2 K first decides w 1%nat j Hw) as [_ [Hn _]].
    exists (1 + j)%nat; split; [lia | apply Hn, Hlt]. }
  destruct (proj2 (proj2 (proj2 decides)) j Hj) as [->|[->|(w & i' & j' & Hw & ->)]].
  - cbn [StatementWords.on] in *; lra.
  - apply (Hnext []), path_start.
  - destruct (pairs a1 a2 K first decides w i' j' Hw) as (_ & _ & I3 & _). destruct (Nat.eq_dec i' 1) as [->|Hne].
    + apply (Hnext (w ++ [U])), path_U; assumption.
    + exists i'; split; [assumption | split]; [apply (members_vertices w i' j' Hw Hj _ I3)|].
      apply (path_sides a1 a2 K first w i' j' Hw).
Qed.

(** With one orbit only, all edges of the case lead to its period. *)
Lemma lonely e g : (forall i j, orbit a1 a2 i e g -> orbit a1 a2 j e g -> i = j) ->
  exists t, forall i j, member e i /\ member e j /\ edge e g i j -> j = t.
Proof.
  intros Hone; destruct e.
  - assert (Hside : forall n, member Plus n -> on n U \/ on n D).
    { intros n [Hu _]; cbn [StatementWords.on]; destruct (Rdichotomy _ _ Hu); tauto. }
    assert (Hx : forall x i j, g = case_of x -> member Plus i -> member Plus j -> on i x -> on j x -> i = j).
    { intros x i j -> Hi Hj Hix Hjx; apply Hone; apply (orbit_on a1 a2 K first); assumption. }
    assert (Hxx : forall x i j, member Plus i -> member Plus j -> on i x -> on j x -> edge Plus (case_of x) i j).
    { intros x i j Hi Hj Hix Hjx; apply full_shift; trivial; apply (orbit_on a1 a2 K first); assumption. }
    destruct g.
    + exists K; intros i j (Hi & Hj & He); symmetry.
      destruct (Hside j Hj) as [Uj|Dj]; [apply (Hx U); trivial; [apply member_K | apply K_upper]; assumption|].
      destruct (Hside i Hi) as [Ui|Di]; exfalso.
      * destruct (second_upper j i Hj Hi Dj Ui) as (k & Hk & HVk & Uk); [unfold StatementWords.edge in He;
          cbn [sgn] in He; lra|].
        apply Hk, (Hx U); trivial.
      * pose proof (edge_either _ _ _ _ _ He (Hxx D i j Hi Hj Di Dj)); discriminate.
    + exists 1%nat; intros i j (Hi & Hj & He); symmetry.
      destruct (Hside j Hj) as [Uj|Dj]; [|apply (Hx D); trivial; [apply member_one | apply on_one]].
      destruct (Hside i Hi) as [Ui|Di]; exfalso.
      * pose proof (edge_either _ _ _ _ _ He (Hxx U i j Hi Hj Ui Uj)); discriminate.
      * destruct (second_lower i j Hi Hj Di Uj) as (k & Hk & HVk & Dk); [unfold StatementWords.edge in He;
          cbn [sgn] in He; lra|].
        apply Hk, (Hx D); trivial.
  - exists 1%nat; intros i j (Hi & Hj & He).
    assert (g = Plus) as ->.
    { apply (edge_either _ _ _ _ _ He), full_shift; trivial; apply Minus_orbit; assumption. }
    apply Hone; apply Minus_orbit; [assumption | apply member_one].
Qed.
End Patterns.

(** Two orbits give two cycles everywhere; the converse needs a single target. *)
Lemma W6_from_lonely a1 a2 e g : 0 < a2 -> ((forall i j, orbit a1 a2 i e g -> orbit a1 a2 j e g -> i = j) -> exists t,
  forall i j, member a1 a2 e i /\ member a1 a2 e j /\ edge a1 a2 e g i j -> j = t) ->
  (two_cycles (fun i j => member a1 a2 e i /\ member a1 a2 e j /\ edge a1 a2 e g i j) <-> exists i j, i <> j /\
  orbit a1 a2 i e g /\ orbit a1 a2 j e g).
Proof.
  intros H Hlonely; split.
  - intros Htwo; apply NNPP; intros Hno; destruct Hlonely as [t Ht].
    { intros i j Hi Hj; apply NNPP; intros Hne; apply Hno; eauto. }
    apply (one_target _ t Ht Htwo).
  - intros (i & j & Hne & Hi & Hj); apply (two_loops _ i j Hne); (split; [|split]);
      try (apply orbit_member_edge in Hi, Hj; tauto); apply full_shift; assumption.
Qed.
