(** * Bounds of weighed sums over the periods at one point bound how fast all its patterns grow in number *)

From Coq Require Import Reals List Arith Bool Lra Lia.
From Grazing Require Import Defs Statement StatementWords StatementGraphs StatementReaderWords WordAlgebra WordPath
  WordGraph WordPatterns WordPlane ReaderWords GraphWords.
From Grazing Require Import StatementSuprema.
Import ListNotations. Open Scope R_scope.

(** ** Geometric sums *)

Lemma sum_filter_two {T} (b : T -> bool) L f : sum_of L f = sum_of (filter b L) f + sum_of (filter (fun x => negb (b x))
  L) f.
Proof. induction L as [|x L IH]; cbn; [ring | rewrite IH; destruct (b x); cbn; ring]. Qed.
Lemma sum_map {T S} (h : T -> S) L f : sum_of (map h L) f = sum_of L (fun x => f (h x)).
Proof. induction L as [|x L IH]; cbn; [ring | rewrite IH; ring]. Qed.
Lemma map_NoDup {T S} (h : T -> S) L : NoDup L -> (forall x y, In x L -> In y L -> h x = h y -> x = y) ->
  NoDup (map h L).
Proof.
  induction 1 as [|x L Hx HN IH]; intros H; cbn; constructor; [|apply IH; intros; apply H; cbn; auto].
  intros Hin; apply in_map_iff in Hin; destruct Hin as (y & E & Hy); apply Hx; rewrite (H x y); cbn; auto.
Qed.
Lemma sum_seq q n : 0 < q < 1 -> sum_of (seq 0 n) (fun k => q ^ k) = (1 - q ^ n) / (1 - q).
Proof. intros Hq; induction n as [|n IH]; [cbn; field; lra|]; rewrite seq_S, sum_app, IH; cbn; field; lra. Qed.
Lemma sum_powers q X : 0 < q < 1 -> NoDup X -> sum_of X (fun k => q ^ k) <= 1 / (1 - q).
Proof.
  intros Hq HN; assert (Max : exists n, forall k, In k X -> (k < n)%nat).
  { clear; induction X as [|x X [n IH]]; [exists 0%nat; intros k []|]; exists (n + S x)%nat; intros k [<-|Hk];
      [lia | specialize (IH k Hk); lia]. }
  destruct Max as (n & Hn); apply Rle_trans with (sum_of (seq 0 n) (fun k => q ^ k)).
  - apply sum_incl; [exact HN | intros k Hk; apply in_seq; specialize (Hn k Hk); lia | intros k _; apply pow_le; lra].
  - rewrite sum_seq by exact Hq; pose proof (pow_lt q n ltac:(lra)); apply Rmult_le_compat_r;
      [left; apply Rinv_0_lt_compat|]; lra.
Qed.

(** How much such a sum rises from z to t, and that it rises little. *)
Lemma sum_rise z t X : 0 < z < t /\ t < 1 -> NoDup X -> sum_of X (fun k => t ^ k - z ^ k) <= 1 / (1 - t) - 1 / (1 - z).
Proof.
  intros Hz HN; assert (Up : forall k, z ^ k <= t ^ k) by (intros k; apply pow_incr; lra).
  assert (Max : exists n, forall k, In k X -> (k < n)%nat).
  { clear; induction X as [|x X [n IH]]; [exists 0%nat; intros k []|]; exists (n + S x)%nat; intros k [<-|Hk];
      [lia | specialize (IH k Hk); lia]. }
  destruct Max as (n & Hn); apply Rle_trans with (sum_of (seq 0 n) (fun k => t ^ k - z ^ k)).
  - apply sum_incl; [exact HN | intros k Hk; apply in_seq; specialize (Hn k Hk); lia | intros k _; specialize (Up k);
      lra].
  - rewrite (sum_ext _ _ (fun k => t ^ k + -1 * z ^ k)) by (intros; ring); rewrite sum_plus, sum_scale, !sum_seq by lra;
      specialize (Up n).
    assert (I : / (1 - z) <= / (1 - t)) by (apply Rinv_le_contravar; lra); assert (0 < / (1 - z))
      by (apply Rinv_0_lt_compat; lra).
    assert (z ^ n * / (1 - z) <= t ^ n * / (1 - t)) by (apply Rmult_le_compat; [apply pow_le; lra | lra | exact Up |
      exact I]); unfold Rdiv; lra.
Qed.
Lemma rise_small z c : 0 < z < 1 -> 0 < c -> exists t, (0 < z < t /\ t < 1) /\ 1 / (1 - t) - 1 / (1 - z) <= c.
Proof.
  intros Hz Hc; set (y := 1 / (1 - z) + c); assert (Q : 1 / (1 - z) * (1 - z) = 1) by (field; lra).
  assert (P : 1 < 1 / (1 - z)) by (apply (Rmult_lt_reg_r (1 - z)); lra); assert (Y : / y * y = 1) by (apply Rinv_l;
    unfold y; lra).
  assert (Y0 : 0 < / y) by (apply Rinv_0_lt_compat; unfold y; lra); exists (1 - / y); replace (1 - (1 - / y)) with (/ y)
    by ring.
  assert (L : / y < 1 - z) by (rewrite <- (Rinv_inv (1 - z)); apply Rinv_lt_contravar; [apply Rmult_lt_0_compat;
    [apply Rinv_0_lt_compat; lra | unfold y; lra] | unfold y, Rdiv; lra]).
  split; [lra|]; unfold Rdiv at 1; rewrite Rinv_inv; unfold y; lra.
Qed.

(** Whole numbers from s on, m apart at least. *)
Lemma sum_spread z s m X : 0 < z < 1 -> (1 <= m)%nat -> NoDup X -> (forall x, In x X -> (s <= x)%nat) ->
  (forall x y, In x X -> In y X -> (x < y)%nat -> (x + m <= y)%nat) -> sum_of X (fun k => z ^ k) <= z ^ s / (1 - z ^ m).
Proof.
  intros Hz Hm HN Hs Hd; assert (Hq : 0 < z ^ m < 1) by (split; [apply pow_lt; lra | apply pow_lt_1_compat;
    [lra | lia]]).
  set (h := fun x => ((x - s) / m)%nat); apply Rle_trans with (z ^ s * sum_of (map h X) (fun k => (z ^ m) ^ k)).
  - rewrite sum_map, <- sum_scale; apply sum_le; intros x Hx; rewrite <- pow_mult, <- pow_add; apply pow_z_le; [lra|].
    unfold h; pose proof (Nat.mul_div_le (x - s) m ltac:(lia)); specialize (Hs x Hx); lia.
  - unfold Rdiv; apply Rmult_le_compat_l; [apply pow_le; lra|]; rewrite <- (Rmult_1_l (/ _)); apply sum_powers;
      [exact Hq|].
    apply map_NoDup; [exact HN|]; intros x y Hx Hy E; unfold h in E.
    assert (Far : forall x y, In x X -> In y X -> (x < y)%nat -> ((x - s) / m < (y - s) / m)%nat).
    { intros a b Ha Hb L; specialize (Hd a b Ha Hb L); specialize (Hs a Ha); apply Nat.lt_le_trans
        with ((a - s) / m + 1)%nat; [lia|].
      replace ((a - s) / m + 1)%nat with (((a - s) + 1 * m) / m)%nat by (rewrite Nat.div_add; lia);
        apply Nat.div_le_mono; lia. }
    destruct (Nat.lt_trichotomy x y) as [L|[L|L]]; [specialize (Far x y Hx Hy L) | exact L |
      specialize (Far y x Hy Hx L)]; lia.
Qed.
(** c, c + d, ..., n of them. *)
Lemma sum_steps z c d n X : 0 < z < 1 -> (1 <= d)%nat -> NoDup X -> (forall x, In x X -> exists k, (k < n)%nat /\
  x = (c + d * k)%nat) -> sum_of X (fun k => z ^ k) <= (z ^ c - z ^ (c + d * n)) / (1 - z ^ d).
Proof.
  intros Hz Hd HN HX; assert (Hq : 0 < z ^ d < 1) by (split; [apply pow_lt; lra | apply pow_lt_1_compat; [lra | lia]]).
  apply Rle_trans with (sum_of (map (fun k => (c + d * k)%nat) (seq 0 n)) (fun k => z ^ k)).
  - apply sum_incl; [exact HN | | intros k _; apply pow_le; lra]; intros x Hx; apply in_map_iff;
      destruct (HX x Hx) as (k & Hk & ->); exists k.
    split; [reflexivity | apply in_seq; lia].
  - rewrite sum_map, (sum_ext _ _ (fun k => z ^ c * (z ^ d) ^ k)) by (intros k _; rewrite pow_add, pow_mult;
      reflexivity).
    rewrite sum_scale, sum_seq by exact Hq; rewrite <- pow_mult, pow_add; right; field; lra.
Qed.

(** ** Members and edges at one point *)
Section Point.
Variables (a1 a2 : R) (K : nat).
Hypothesis first : first_upper a1 a2 K.
Notation u := (u a1 a2).
Notation on := (on a1 a2).
Notation member := (member a1 a2 Plus).
Notation path := (path a1 a2 K).
Let dec := decided_everywhere a1 a2 K first.

Definition side (n : nat) : letter := if Rlt_dec 0 (u n) then D else U.
Lemma side_on n : member n -> on n (side n).
Proof. intros [Hu _]; unfold side; destruct (Rlt_dec 0 (u n)); cbn [StatementWords.on]; lra. Qed.
Lemma on_side n x : on n x -> side n = x.
Proof. unfold side; destruct (Rlt_dec 0 (u n)), x; cbn [StatementWords.on]; intros; trivial; lra. Qed.
Lemma member_1_or_more n : member n -> (1 <= n)%nat.
Proof. intros [Hu _]; apply (u_nonzero_pos a1 a2 n Hu). Qed.

(** Two of one side follow each other for one sign of gamma. *)
Lemma same_side g x y : member x -> member y -> side x = side y -> edge a1 a2 Plus g x y -> g = case_of (side x).
Proof.
  intros Hx Hy E He; pose proof (side_on x Hx) as Ox; pose proof (side_on y Hy) as Oy; rewrite <- E in Oy.
  pose proof (proj2 (orbit_on a1 a2 K first _ _ Ox) Hx) as Bx; pose proof (proj2 (orbit_on a1 a2 K first _ _ Oy) Hy)
    as By.
  pose proof (full_shift a1 a2 Plus (proj1 (a2_in a1 a2 K first)) _ x y Bx By) as F.
  apply (edge_either a1 a2 Plus g (case_of (side x)) x y He F).
Qed.
Definition in_word (w : list letter) (i j : nat) : Prop := path w i j /\ Forall (fun x => member (fst x))
  (vertices K w).

Lemma word_start : in_word [] 1 K.
Proof. split; [constructor|]; constructor; [apply member_one | constructor; [apply member_K, first | constructor]]. Qed.
Lemma word_step w i j : in_word w i j -> ~ member (i + j) \/ (on (i + j) D /\ in_word (w ++ [D]) (i + j) j) \/
  (on (i + j) U /\ in_word (w ++ [U]) i (i + j)).
Proof.
  intros [Hp HV]; destruct (Classical_Prop.classic (member (i + j))) as [M|]; [right | tauto].
  pose proof (side_on _ M) as O; destruct (side (i + j)); [left | right]; (split; [exact O|]; split;
    [constructor; assumption|]); rewrite (vertices_snoc a1 a2 K w i j _ Hp), Forall_app;
    (split; [exact HV | constructor; [exact M | constructor]]).
Qed.
Lemma vertex_side w i j v : in_word w i j -> In v (vertices K w) -> side (fst v) = snd v.
Proof. intros [Hp _] Hv; destruct v as [n x]; apply on_side, (vertices_on a1 a2 K first w i j Hp n x Hv). Qed.

(** What comes after the word w. *)
Definition later (w : list letter) (n : nat) : Prop := member n /\ exists t i j, path (w ++ t) i j /\ n = (i + j)%nat.

Lemma path_grows w i j t i' j' : path w i j -> path (w ++ t) i' j' -> (i <= i' /\ j <= j')%nat.
Proof.
  intros Hp Hp'; destruct t as [|x t]; [rewrite app_nil_r in Hp'; destruct (path_unique a1 a2 K w i j i' j' Hp Hp');
    lia|].
  destruct (path_prefix a1 a2 K first w x t i' j' Hp') as (i0 & j0 & Hp0 & _ & _ & L1 & L2).
  destruct (path_unique a1 a2 K w i j i0 j0 Hp Hp0) as [<- <-]; destruct x; cbn [final fst snd] in *; lia.
Qed.
Lemma member_cases w i j n : path w i j -> member n -> In n (map fst (vertices K w)) \/ later w n.
Proof.
  intros Hp Hn; destruct (W3 a1 a2 K first) as (_ & _ & _ & On & _);
    destruct (On n Hn) as [->|[->|(w' & i' & j' & Hp' & E)]]; [left; left; reflexivity | left; right; left;
    reflexivity|].
  destruct (paths_agree a1 a2 K first w i j w' i' j' Hp Hp') as [(t & Et)|(x & t & Et)].
  - right; split; [exact Hn|]; exists t, i', j'; rewrite <- Et; auto.
  - left; apply in_map_iff; exists ((i' + j')%nat, x); split; [auto|]; rewrite Et;
      apply (vertex_K_or_later a1 a2 K w' i' j' Hp').
Qed.
Lemma later_from w i j n : path w i j -> later w n -> (i + j <= n)%nat.
Proof. intros Hp (_ & t & i' & j' & Hp' & ->); pose proof (path_grows w i j t i' j' Hp Hp'); lia. Qed.
Lemma later_apart w i j n n' : path w i j -> later w n -> later w n' -> (n < n')%nat -> (n + Nat.min i j <= n')%nat.
Proof.
  intros Hp (_ & t & i1 & j1 & P1 & ->) (_ & t' & i2 & j2 & P2 & ->) L; pose proof (path_grows w i j t i1 j1 Hp P1)
    as G1.
  destruct (paths_agree a1 a2 K first _ i1 j1 _ i2 j2 P1 P2) as [(s & E)|(x & s & E)].
  - rewrite E in P2; destruct s as [|x s]; [rewrite app_nil_r in P2; destruct (path_unique a1 a2 K _ i1 j1 i2 j2 P1 P2);
      lia|].
    destruct (path_prefix a1 a2 K first _ x s i2 j2 P2) as (i0 & j0 & P0 & _ & _ & L1 & L2).
    destruct (path_unique a1 a2 K _ i1 j1 i0 j0 P1 P0) as [<- <-]; destruct x; cbn [final fst snd] in *; lia.
  - rewrite E in P1; pose proof (path_grows _ i2 j2 (x :: s) i1 j1 P2 P1); lia.
Qed.
Lemma later_sum z w i j X : 0 < z < 1 -> path w i j -> NoDup X -> (forall n, In n X -> later w n) ->
  sum_of X (fun k => z ^ k) <= z ^ (i + j) / (1 - z ^ Nat.min i j).
Proof.
  intros Hz Hp HN HX; destruct (path_pos a1 a2 K w i j Hp) as [P1 P2]; pose proof (K_ge_2 a1 a2 K first).
  apply sum_spread; [exact Hz | lia | exact HN | |].
  - intros x Hx; apply (later_from w i j x Hp (HX x Hx)).
  - intros x y Hx Hy L; apply (later_apart w i j x y Hp (HX x Hx) (HX y Hy) L).
Qed.
(** Where the word has ended there is nothing after it. *)
Lemma later_none w i j n : path w i j -> ~ member (i + j) -> ~ later w n.
Proof.
  intros Hp NM (Hn & t & i' & j' & Hp' & E); destruct t as [|x t].
  - rewrite app_nil_r in Hp'; destruct (path_unique a1 a2 K w i j i' j' Hp Hp') as [<- <-]; subst n; contradiction.
  - destruct (W3 a1 a2 K first) as (_ & _ & _ & _ & Init); subst n; specialize (Init _ i' j' Hp' Hn);
      rewrite Forall_forall in Init.
    apply NM, (Init ((i + j)%nat, x)), (vertex_K_or_later a1 a2 K w i j Hp).
Qed.

(** Edges that the word forbids. *)
Definition allowed (w : list letter) (g : sign) (x y : nat * letter) : bool := match mark_of K w false x y with
  | Some g' => StatementCircleZ.same_sign g' g | None => true end.
Lemma edge_allowed w i j g x y : in_word w i j -> In x (vertices K w) -> In y (vertices K w) ->
  edge a1 a2 Plus g (fst x) (fst y) -> allowed w g x y = true.
Proof.
  intros [Hp HV] Hx Hy He; pose proof (marks_true a1 a2 K first w i j false Hp HV ltac:(discriminate) x y _ Hx Hy
    eq_refl) as M.
  unfold allowed; destruct (mark_of K w false x y) as [g'|]; [|reflexivity]; cbn [marked] in M; unfold edge in He;
    cbn [sgn] in He.
  destruct g, g'; cbn [StatementCircleZ.same_sign sgn] in *; trivial; lra.
Qed.

(** ** Bounds of the number of words *)

Lemma bounded z g (v : nat -> R) lo hi : 0 < z < 1 -> 0 < lo -> (forall n, member n -> lo <= v n <= hi) ->
  (forall x, member x -> forall X, NoDup X -> (forall y, In y X -> member y /\ edge a1 a2 Plus g x y) ->
  sum_of X (fun y => z ^ y * v y) <= v x) -> at_most (patterns a1 a2 Plus g) (- ln z).
Proof.
  intros Hz Hlo Hv Hs; apply (from_above (patterns a1 a2 Plus g) z ltac:(lra) member_1_or_more v lo Hlo (fun n Hn =>
    proj1 (Hv n Hn)) Hs (hi * (1 / (1 - z)))).
  intros X HN HX; apply Rle_trans with (sum_of X (fun y => hi * z ^ y)).
  - apply sum_le; intros y Hy; cbn [periods_of patterns]; rewrite Rmult_comm; apply Rmult_le_compat_r;
      [apply pow_le; lra | apply (Hv y (HX y Hy))].
  - rewrite sum_scale; apply Rmult_le_compat_l; [|apply sum_powers; assumption].
    destruct (Hv 1%nat (member_one a1 a2 Plus)); lra.
Qed.

(** With something to spare the same holds a little above z. *)
Lemma spare z g (v : nat -> R) lo hi gap : 0 < z < 1 -> 0 < lo -> 0 < gap -> (forall n, member n -> lo <= v n <= hi) ->
  (forall x, member x -> forall X, NoDup X -> (forall y, In y X -> member y /\ edge a1 a2 Plus g x y) ->
  sum_of X (fun y => z ^ y * v y) <= v x - gap) -> below (patterns a1 a2 Plus g) (- ln z).
Proof.
  intros Hz Hlo Hgap Hv Hs; pose proof (Hv 1%nat (member_one a1 a2 Plus)) as H1; assert (Hhi : 0 < hi) by lra.
  destruct (rise_small z (gap / hi) Hz (Rdiv_lt_0_compat _ _ Hgap Hhi)) as (t & Ht & Rise); exists (- ln t); split;
    [apply Ropp_lt_contravar, ln_increasing; lra|].
  apply (bounded t g v lo hi); [lra | exact Hlo | exact Hv|]; intros x Hx X HN HX; specialize (Hs x Hx X HN HX).
  rewrite (sum_ext X _ (fun y => z ^ y * v y + (t ^ y - z ^ y) * v y)) by (intros; ring); rewrite sum_plus.
  assert (Q : sum_of X (fun y => (t ^ y - z ^ y) * v y) <= hi * (1 / (1 - t) - 1 / (1 - z))).
  { apply Rle_trans with (hi * sum_of X (fun y => t ^ y - z ^ y)); [|apply Rmult_le_compat_l;
      [lra | apply sum_rise; [lra | exact HN]]].
    rewrite <- sum_scale; apply sum_le; intros y Hy; rewrite (Rmult_comm hi); apply Rmult_le_compat_l;
      [|apply Hv, (HX y Hy)].
    assert (z ^ y <= t ^ y) by (apply pow_incr; lra); lra. }
  assert (hi * (1 / (1 - t) - 1 / (1 - z)) <= gap); [|lra].
  apply Rle_trans with (hi * (gap / hi)); [apply Rmult_le_compat_l; lra | right; field; lra].
Qed.

(** The side that goes with g is joined to all, the other to it alone. *)
Lemma two_sides z g full s t : 0 < z < 1 -> case_of full = g -> 0 <= s -> 0 <= t -> s * (1 + t) < 1 ->
  (forall X, NoDup X -> (forall n, In n X -> member n /\ side n = full) -> sum_of X (fun k => z ^ k) <= s) ->
  (forall X, NoDup X -> (forall n, In n X -> member n /\ side n <> full) -> sum_of X (fun k => z ^ k) <= t) ->
  below (patterns a1 a2 Plus g) (- ln z).
Proof.
  intros Hz Hg Hs Ht Hst HS HT; set (is := fun n => match full, side n with D, D | U, U => true | _, _ => false end).
  assert (Is : forall n, is n = true <-> side n = full) by (intros n; unfold is; destruct full, (side n); split;
    congruence).
  apply (spare z g (fun n => if is n then 1 + t else 1) 1 (1 + t) (1 - s * (1 + t)));
    [exact Hz | lra | lra | intros n _; destruct (is n); lra|].
  intros x Hx X HN HX; rewrite (sum_filter_two is X).
  rewrite (sum_ext (filter is X) _ (fun k => (1 + t) * z ^ k)) by (intros k Hk; apply filter_In in Hk;
    rewrite (proj2 Hk); ring).
  rewrite (sum_ext (filter (fun y => negb (is y)) X) _ (fun k => z ^ k)) by (intros k Hk; apply filter_In in Hk;
    destruct Hk as [_ Hk]; apply negb_true_iff in Hk; rewrite Hk; ring).
  rewrite sum_scale; pose proof (HS (filter is X) (NoDup_filter _ HN)) as A;
    pose proof (HT (filter (fun y => negb (is y)) X) (NoDup_filter _ HN)) as B.
  assert (A' : sum_of (filter is X) (fun k => z ^ k) <= s) by (apply A; intros n Hn; apply filter_In in Hn; split;
    [apply (HX n), Hn | apply Is, Hn]).
  assert (B' : sum_of (filter (fun y => negb (is y)) X) (fun k => z ^ k) <= t).
  { apply B; intros n Hn; apply filter_In in Hn; split; [apply (HX n), Hn|]; intros E; apply Is in E;
      destruct Hn as [_ Hn]; rewrite E in Hn; discriminate. }
  assert (AA : (1 + t) * sum_of (filter is X) (fun k => z ^ k) <= s * (1 + t)) by (rewrite (Rmult_comm s);
    apply Rmult_le_compat_l; lra).
  cbv beta; change (sum_of (filter is X) (pow z)) with (sum_of (filter is X) (fun k => z ^ k)); destruct (is x) eqn:Ex;
    [lra|]; replace (filter (fun y => negb (is y)) X) with (@nil nat); [cbn [sum_of]; lra|].
  symmetry; destruct (filter (fun y => negb (is y)) X) as [|y Y] eqn:EY; [reflexivity | exfalso].
  assert (Iy : In y (filter (fun y => negb (is y)) X)) by (rewrite EY; left; reflexivity); apply filter_In in Iy;
    destruct Iy as [Iy Ny].
  destruct (HX y Iy) as [My Ed]; apply negb_true_iff in Ny; assert (Sx : side x <> full) by (intros E; apply Is in E;
    congruence).
  assert (Sy : side y <> full) by (intros E; apply Is in E; congruence).
  assert (E : side x = side y) by (destruct full, (side x), (side y); congruence);
    pose proof (same_side g x y Hx My E Ed) as G.
  destruct full, (side x), g; cbn [case_of] in *; congruence.
Qed.
End Point.
