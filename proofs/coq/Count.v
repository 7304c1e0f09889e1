(** * Theorem 2's intervals are phi(n) + 1 in number, disjoint, and grown by the Farey tree

    Section 8 of ../conjecture1.md, integers and fractions only. *)

From Coq Require Import Reals List Arith ZArith Lra Lia.
From Grazing Require Import Defs Statement Cases Farey Disc Sine Radius.
Import ListNotations.
Open Scope nat_scope.

(** ** Mediant insertion *)

Lemma adjacent_unimodular m1 n1 m2 n2 : adjacent m1 n1 m2 n2 ->
  m2 * n1 = m1 * n2 + 1 /\ 2 * m1 < n1 /\ 2 * m2 <= n2 /\ 0 < m2.
Proof. induction 1; lia. Qed.

(** The reverse: the larger denominator was inserted last. *)
Lemma unimodular_adjacent k : forall m1 n1 m2 n2, n1 + n2 <= k ->
  m2 * n1 = m1 * n2 + 1 -> 2 * m2 <= n2 -> adjacent m1 n1 m2 n2.
Proof.
  induction k as [|k IH]; intros m1 n1 m2 n2 Hk E H2; [destruct n1, n2; lia|]. destruct (Nat.eq_dec n1 1) as [->|Hn1].
  - destruct m1 as [|m1]; [|pose proof (Nat.le_0_l (m1 * n2)); simpl in E; lia]. assert (m2 = 1) as -> by lia.
    destruct (Nat.eq_dec n2 2) as [->|]; [constructor|].
    replace n2 with (1 + (n2 - 1)) by lia; apply (insert_left 0 1 1 (n2 - 1)), IH; lia.
  - assert (n1 <> 0) by (intros ->; lia); assert (0 < m2) by (destruct m2; lia).
    destruct (lt_eq_lt_dec n1 n2) as [[Hn|Hn]|Hn].
    + assert (m1 < m2) by nia. destruct (Nat.le_exists_sub n1 n2 ltac:(lia)) as (p & -> & _).
      destruct (Nat.le_exists_sub m1 m2 ltac:(lia)) as (q & -> & _).
      rewrite (Nat.add_comm q), (Nat.add_comm p); apply insert_left, IH; [lia|lia|].
      destruct (le_lt_dec (2 * q) p) as [|Hq]; [assumption|exfalso]. assert (1 + 2 * m1 <= n1) as Hd by lia.
      apply (Nat.mul_le_mono_r _ _ n1) in Hq. apply (Nat.mul_le_mono_l _ _ p) in Hd; lia.
    + subst n2; exfalso; assert (m1 < m2) by nia. destruct (Nat.le_exists_sub m1 m2 ltac:(lia)) as (q & -> & _).
      assert (q = 0 \/ 1 <= q) as [->|Hq] by lia; [lia|]. apply (Nat.mul_le_mono_r _ _ n1) in Hq; lia.
    + assert (m2 <= m1) by nia. destruct (Nat.le_exists_sub n2 n1 ltac:(lia)) as (p & -> & _).
      destruct (Nat.le_exists_sub m2 m1 ltac:(lia)) as (q & -> & _). apply insert_right, IH; lia.
Qed.

Lemma tree_proof : Theorem2_tree_statement.
Proof.
  intros m n mp np mm nm; split.
  - intros [Hm HF]; destruct (neighbours_sum _ _ _ _ _ _ HF) as [Sm Sn].
    destruct HF as (Hp & E & Hp' & E'); repeat split; [|lia|lia]. assert (Eu : mm * np = mp * nm + 1) by (subst; lia).
    apply (unimodular_adjacent (np + nm)); [lia|assumption|].
    destruct (le_lt_dec (2 * mm) nm) as [|Hq]; [assumption|exfalso]. assert (2 + 2 * mp <= np) as Hd by lia.
    apply (Nat.mul_le_mono_r _ _ np) in Hq. apply (Nat.mul_le_mono_l _ _ nm) in Hd; lia.
  - intros (HA & -> & ->); apply adjacent_unimodular in HA as (E & H1 & H2 & H3). unfold neighbours; repeat split; lia.
Qed.

Lemma neighbours_half m n mp np mm nm : 0 < 2 * m < n -> neighbours m n mp np mm nm -> 2 * mp < np /\ 2 * mm <= nm.
Proof.
  intros Hm HF; destruct (proj1 (tree_proof m n mp np mm nm) (conj Hm HF)) as (HA & _).
  now apply adjacent_unimodular in HA.
Qed.

(** ** The intervals are not empty and are disjoint *)

Open Scope R_scope.

Lemma fraction_lt p q x y : 0 < q -> 0 < y -> p * y < x * q -> p / q < x / y.
Proof.
  intros Hq Hy H; apply (Rmult_lt_reg_r (q * y)); [nra|]. replace (p / q * (q * y)) with (p * y) by (field; lra).
  replace (x / y * (q * y)) with (x * q) by (field; lra); lra.
Qed.

Lemma interval_nonempty n e g lo hi : (3 <= n)%nat -> interval n e g lo hi -> 0 <= lo < hi /\ hi <= 1 / 2.
Proof.
  intros Hn HI; assert (Hn3 : 3 <= INR n) by (apply le_INR in Hn; simpl in Hn; lra).
  assert (Hpos : forall k q, 0 < q -> 0 <= INR k / q).
  { intros k q Hq; apply Rmult_le_pos; [apply pos_INR|now apply Rlt_le, Rinv_0_lt_compat]. }
  destruct (view _ _ _ _ _ HI) as [|m mp np mm nm Hm HF|m mp np mm nm Hm HF].
  - split; [split; [lra|]|apply Rlt_le]; replace 0 with (0 / 1) by field; apply fraction_lt; lra.
  - destruct (neighbours_R _ _ _ _ _ _ Hn HF) as (E & _ & _ & _ & Hp & _).
    apply proj2, lt_INR in Hm as H2; rewrite mult_INR in H2; simpl in H2. split; [|apply Rlt_le, fraction_lt; lra].
    destruct (Nat.eqb_spec m 1) as [->|].
    + split; [replace 0 with (INR 0 / 1) by (simpl; field)|]; [|apply fraction_lt; simpl; lra].
      replace (INR 0 / 1) with (0 / 1) by (simpl; field); apply Rlt_le, fraction_lt; lra.
    + split; [apply Hpos; lra|apply fraction_lt; lra].
  - destruct (neighbours_R _ _ _ _ _ _ Hn HF) as (_ & E & _ & _ & _ & Hp).
    destruct (neighbours_half _ _ _ _ _ _ Hm HF) as [_ H2]. apply le_INR in H2; rewrite mult_INR in H2; simpl in H2.
    split; [split; [apply Hpos; lra|apply fraction_lt; lra]|].
    apply (Rmult_le_reg_r (INR nm)); [lra|]; unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l; lra.
Qed.

(** A point of an interval has its orbit at r = 1. *)
Lemma interval_orbit n e g lo hi s : (3 <= n)%nat -> interval n e g lo hi ->
  lo < s < hi -> exists_iff (trace 1 s) (1 ^ 2) n e g True.
Proof.
  intros Hn HI Hs; destruct (proj1 (S4_proof n Hn) e g lo hi HI) as (Rad & HR & _).
  destruct (HR s Hs) as [Hx H1]; refine (exists_iff_ext _ _ _ _ _ _ _ _ (H1 1 _)); [|lra]. split; [trivial|lra].
Qed.

Lemma near_unique m m' : -1 < INR m - INR m' < 1 -> m = m'.
Proof.
  intros H; destruct (lt_eq_lt_dec m m') as [[Hlt|]|Hlt]; [|assumption|]; apply le_INR in Hlt; rewrite S_INR in Hlt;
    lra.
Qed.

Lemma interval_determined n e g lo hi lo' hi' s : (3 <= n)%nat -> interval n e g lo hi -> interval n e g lo' hi' ->
  lo < s < hi -> lo' < s < hi' -> lo = lo' /\ hi = hi'.
Proof.
  intros Hn HI HI' Hs Hs'.
  pose proof (view _ _ _ _ _ HI) as HV; inversion HV as [|m mp np mm nm Hm HF|m mp np mm nm Hm HF]; subst;
    pose proof (view _ _ _ _ _ HI') as HV'; inversion HV' as [|m' mp' np' mm' nm' Hm' HF'|m' mp' np' mm' nm' Hm' HF'];
    subst; [tauto| |].
  - apply (left_interval n m mp np mm nm) in Hs as ((_ & _ & He) & _); trivial.
    apply (left_interval n m' mp' np' mm' nm') in Hs' as ((_ & _ & He') & _); trivial.
    assert (m = m') as <- by (apply near_unique; lra).
    apply (neighbours_unique _ _ _ _ _ _ HF) in HF'; now inversion HF'.
  - apply (right_interval n m mp np mm nm) in Hs as ((_ & _ & He) & _); trivial.
    apply (right_interval n m' mp' np' mm' nm') in Hs' as ((_ & _ & He') & _); trivial.
    assert (m = m') as <- by (apply near_unique; lra).
    apply (neighbours_unique _ _ _ _ _ _ HF) in HF'; now inversion HF'.
Qed.

Lemma intervals_disjoint n e g lo hi e' g' lo' hi' : (3 <= n)%nat -> interval n e g lo hi -> interval n e' g' lo' hi' ->
  (e, g, lo, hi) = (e', g', lo', hi') \/ hi <= lo' \/ hi' <= lo.
Proof.
  intros Hn HI HI'. destruct (Rle_or_lt hi lo') as [|H1]; [tauto|]; destruct (Rle_or_lt hi' lo) as [|H2]; [tauto|].
  destruct (interval_nonempty _ _ _ _ _ Hn HI), (interval_nonempty _ _ _ _ _ Hn HI'); left.
  set (s := (Rmax lo lo' + Rmin hi hi') / 2).
  assert (Hs : lo < s < hi /\ lo' < s < hi').
  { unfold s, Rmax, Rmin; destruct Rle_dec, Rle_dec; lra. }
  assert (Ho : orbit (trace 1 s) (1 ^ 2) n e g) by (apply (interval_orbit n e g lo hi s); tauto).
  apply (interval_orbit n e' g' lo' hi' s Hn HI' (proj2 Hs)) in Ho; destruct Ho as (-> & -> & _).
  destruct (interval_determined n e' g' lo hi lo' hi' s); try tauto; congruence.
Qed.

(** ** One interval for each k coprime to n, and the first *)

(** k = m to the left of m/n, k = n - m to its right. *)
Definition numbered (n k : nat) (x : sign * sign * R * R) : Prop :=
  let '(e, g, lo, hi) := x in interval n e g lo hi /\ e = Plus /\
  ((2 * k < n)%nat /\ g = Plus /\ hi = INR k / INR n \/
   (n < 2 * k)%nat /\ g = Minus /\ lo = INR (n - k) / INR n).

Definition coprimes (n : nat) : list nat :=
  filter (fun k => Nat.gcd k n =? 1)%nat (seq 1 n).

Lemma coprimes_spec n k : (3 <= n)%nat -> (In k (coprimes n) <-> (1 <= k < n)%nat /\ Nat.gcd k n = 1%nat).
Proof.
  intros Hn; unfold coprimes; rewrite filter_In, in_seq, Nat.eqb_eq.
  split; [|intuition lia]; intros [Hk Hg]; split; [|assumption].
  assert (k <> n); [|lia]; intros ->; rewrite Nat.gcd_diag in Hg; lia.
Qed.

Lemma coprime_complement k n : (k < n)%nat -> Nat.gcd k n = 1%nat -> Nat.gcd (n - k) n = 1%nat.
Proof.
  intros Hk Hg; rewrite Nat.gcd_comm; replace n with (n - k + k)%nat at 1 by lia.
  rewrite Nat.add_comm, Nat.gcd_comm, Nat.gcd_add_diag_r. rewrite <- Hg; replace n with (n - k + 1 * k)%nat at 2 by lia.
  now rewrite Nat.gcd_add_mult_diag_r, Nat.gcd_comm.
Qed.

Lemma coprime_not_half k n : (3 <= n)%nat -> Nat.gcd k n = 1%nat -> (2 * k <> n)%nat.
Proof. intros Hn Hg E; rewrite <- E, Nat.mul_comm, Nat.gcd_mul_diag_l in Hg; lia. Qed.

Lemma numbered_exists n k : (3 <= n)%nat -> In k (coprimes n) -> exists x, numbered n k x.
Proof.
  intros Hn Hk; apply coprimes_spec in Hk as [Hk Hg]; [|assumption].
  pose proof (coprime_not_half k n Hn Hg); destruct (lt_dec (2 * k) n) as [Hlt|Hge].
  - destruct (neighbours_exist k n ltac:(lia) Hg) as (mp & np & mm & nm & HF).
    eexists (_, _, _, _); split; [apply (left_of n k mp np mm nm); [lia|assumption]|tauto].
  - destruct (neighbours_exist (n - k) n ltac:(lia)) as (mp & np & mm & nm & HF); [apply coprime_complement; tauto|].
    eexists (_, _, _, _); split; [apply (right_of n (n - k) mp np mm nm); [lia|assumption]|].
    split; [reflexivity|right; split; [lia|tauto]].
Qed.

Lemma fraction_inj n a c : (3 <= n)%nat -> INR a / INR n = INR c / INR n -> a = c.
Proof. intros Hn E; apply INR_eq, (Rmult_eq_reg_r (/ INR n)); [exact E|]. apply Rinv_neq_0_compat, not_0_INR; lia. Qed.

Lemma numbered_inj n k k' x : (3 <= n)%nat -> (k <= n)%nat -> (k' <= n)%nat ->
  numbered n k x -> numbered n k' x -> k = k'.
Proof.
  destruct x as [[[e g] lo] hi]; intros Hn Hk Hk' (_ & _ & H) (_ & _ & H').
  destruct H as [(? & -> & ->)|(? & -> & ->)], H' as [(? & ? & E)|(? & ? & E)]; try discriminate;
    apply fraction_inj in E; lia.
Qed.

Lemma numbered_unique n k x y : (3 <= n)%nat -> numbered n k x -> numbered n k y -> x = y.
Proof.
  destruct x as [[[e g] lo] hi], y as [[[e' g'] lo'] hi']. intros Hn (HI & -> & H) (HI' & -> & H').
  destruct H as [(? & -> & Eh)|(? & -> & El)], H' as [(? & -> & Eh')|(? & -> & El')]; try lia;
    destruct (interval_nonempty _ _ _ _ _ Hn HI), (interval_nonempty _ _ _ _ _ Hn HI');
    destruct (intervals_disjoint _ _ _ _ _ _ _ _ _ Hn HI HI') as [|[|]]; trivial; lra.
Qed.

Lemma choose_list {A B} (P : A -> B -> Prop) l : (forall a, In a l -> exists b, P a b) -> exists l', Forall2 P l l'.
Proof.
  induction l as [|a l IH]; intros H; [now exists []|].
  destruct (H a) as [b Hb]; [now left|]; destruct IH as [l' Hl']; [intros; apply H; now right|].
  exists (b :: l'); now constructor.
Qed.

Lemma Forall2_find {A B} (P : A -> B -> Prop) l l' : Forall2 P l l' -> (forall a, In a l -> exists b, In b l' /\ P a b)
  /\ (forall b, In b l' -> exists a, In a l /\ P a b).
Proof.
  induction 1 as [|a b l l' Hab _ [IH1 IH2]]; [now split|]; split.
  - intros x [->|Hx]; [exists b; simpl; tauto|]. destruct (IH1 x Hx) as (y & ? & ?); exists y; simpl; tauto.
  - intros y [->|Hy]; [exists a; simpl; tauto|]. destruct (IH2 y Hy) as (x & ? & ?); exists x; simpl; tauto.
Qed.

Lemma Forall2_NoDup {A B} (P : A -> B -> Prop) l l' : Forall2 P l l' -> NoDup l ->
  (forall a a' b, In a l -> In a' l -> P a b -> P a' b -> a = a') -> NoDup l'.
Proof.
  induction 1 as [|a b l l' Hab HF IH]; intros Hl Hinj; [constructor|].
  inversion Hl as [|? ? Hnot Hl']; subst; constructor.
  - intros Hb; destruct (proj2 (Forall2_find _ _ _ HF) b Hb) as (a' & Ha' & Hab').
    apply Hnot; rewrite (Hinj a a' b); simpl; auto.
  - apply IH; [assumption|]; intros; eapply Hinj; simpl; eauto.
Qed.

Lemma Forall2_length_eq {A B} (P : A -> B -> Prop) l l' : Forall2 P l l' -> length l = length l'.
Proof. induction 1; simpl; congruence. Qed.

Lemma interval_numbered n g lo hi : (3 <= n)%nat -> interval n Plus g lo hi ->
  exists k, In k (coprimes n) /\ numbered n k (Plus, g, lo, hi).
Proof.
  intros Hn HI; pose proof (view _ _ _ _ _ HI) as HV; inversion HV as [|m mp np mm nm Hm HF|m mp np mm nm Hm HF]; subst;
    pose proof (neighbours_coprime _ _ _ _ _ _ HF) as Hg.
  - exists m; split; [apply coprimes_spec; lia|]; split; [assumption|]; split; [reflexivity|left]. split; [lia|tauto].
  - exists (n - m)%nat; split.
    { apply coprimes_spec; [assumption|]; split; [lia|]; apply coprime_complement; lia. }
    split; [assumption|]; split; [reflexivity|right]; split; [lia|]. replace (n - (n - m))%nat with m by lia; tauto.
Qed.

Lemma count_proof : Theorem2_count_statement.
Proof.
  intros n Hn; destruct (choose_list (numbered n) (coprimes n)) as [L HL].
  { intros k Hk; now apply numbered_exists. }
  destruct (Forall2_find _ _ _ HL) as [Hto Hfrom].
  assert (Hin : forall e g lo hi, In (e, g, lo, hi) L <-> interval n e g lo hi /\ e = Plus).
  { intros e g lo hi; split.
    - intros Hx; destruct (Hfrom _ Hx) as (k & _ & HI & He & _); tauto.
    - intros [HI ->]; destruct (interval_numbered n g lo hi Hn HI) as (k & Hk & HP).
      destruct (Hto k Hk) as (x & Hx & HP'); now rewrite (numbered_unique n k _ _ Hn HP HP'). }
  exists ((Minus, Plus, 0, 1 / (2 * INR n)) :: L); split; [|split; [|split; [|split]]].
  - simpl; rewrite <- (Forall2_length_eq _ _ _ HL); unfold phi, coprimes; lia.
  - constructor; [rewrite Hin; intros [_ ?]; discriminate|].
    apply (Forall2_NoDup _ _ _ HL); [apply NoDup_filter, seq_NoDup|].
    intros k k' x Hk Hk'; apply coprimes_spec in Hk, Hk'; trivial. apply numbered_inj; trivial; lia.
  - intros e g lo hi; simpl; rewrite Hin; split.
    + intros [E|[HI _]]; [inversion E; subst; constructor|assumption].
    + intros HI; inversion HI; subst; tauto.
  - intros e g lo hi; now apply interval_nonempty.
  - intros; now apply intervals_disjoint with (n := n).
Qed.
