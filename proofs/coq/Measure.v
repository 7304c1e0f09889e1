(** * The total length of the intervals of period n, one summand 1/(n k) for each k prime to n: ../measure.md *)

From Coq Require Import Reals List Arith Permutation Lra Lia.
From Grazing Require Import Defs Statement StatementMeasure Cases Farey Disc Sine Radius Count Above.
Import ListNotations. Open Scope R_scope.

Lemma sum_over_permutation {A} (f : A -> R) l l' : Permutation l l' -> sum_over f l = sum_over f l'.
Proof. unfold sum_over; induction 1; cbn [fold_right] in *; lra. Qed.

(** The interval on which n - k decides has a length that k says. *)
Definition share (n k : nat) : R := if (k =? 1)%nat then 1 / (2 * INR n) else / INR n * / INR k.
Definition opposite (n k : nat) (x : sign * sign * R * R) : Prop :=
  let '(e, g, lo, hi) := x in e = Plus /\ side n (n - k) g lo hi.

Lemma side_length n k g lo hi : (3 <= n)%nat -> (1 <= k <= n - 1)%nat -> side n (n - k) g lo hi -> hi - lo = share n k.
Proof.
  intros Hn Hk HS; assert (Hd : exists d, d = (n - k)%nat) by eauto; destruct Hd as [d Ed].
  rewrite <- Ed in HS; destruct HS as [m F Hm|m F Hm]; unfold share;
    destruct (neighbours_R _ _ _ _ _ _ Hn (are_neighbours F)) as (E & E' & _ & Hn3 & Hp & Hq);
    destruct (neighbours_sum _ _ _ _ _ _ (are_neighbours F)) as [_ S]; pose proof (are_neighbours F)
    as (Hnp & I & _ & I').
  - assert (n_plus F = k) as Ek by lia; rewrite Ek in *.
    assert (H1 : m = 1%nat <-> k = 1%nat).
    { split; intros ->; destruct (m_plus F) as [|x]; try lia; pose proof (Nat.le_0_l (x * n)); simpl in I; lia. }
    destruct (Nat.eqb_spec m 1) as [M1|M1], (Nat.eqb_spec k 1) as [K1|K1]; try tauto; [rewrite M1; simpl; field; lra|].
    replace (INR m / INR n - INR (m_plus F) / INR k) with ((INR m * INR k - INR (m_plus F) * INR n)
      * (/ INR n * / INR k)) by (field; lra).
    rewrite E; ring.
  - assert (n_minus F = k) as Ek by lia; rewrite Ek in *.
    destruct (Nat.eqb_spec k 1) as [K1|K1]; [exfalso; rewrite K1 in I'; destruct (m_minus F); cbn in I'; lia|].
    replace (INR (m_minus F) / INR k - INR m / INR n) with ((INR (m_minus F) * INR n - INR m * INR k)
      * (/ INR n * / INR k)) by (field; lra).
    rewrite <- E'; ring.
Qed.

Lemma total n l L : (3 <= n)%nat -> (forall k, In k l -> (1 <= k <= n - 1)%nat) -> Forall2 (opposite n) l L ->
  sum_over length_of L = sum_over (share n) l.
Proof.
  intros Hn Hl HF; induction HF as [|k [[[e g] lo] hi] l L [_ HS] _ IH]; [reflexivity|]; cbn.
  fold (sum_over length_of L) (sum_over (share n) l); rewrite IH by (intros; apply Hl; now right).
  rewrite <- (side_length n k g lo hi); trivial; apply Hl; now left.
Qed.

(** 1 is the first of them. *)
Lemma shares n : (3 <= n)%nat ->
  sum_over (share n) (coprimes n) + 1 / (2 * INR n) = / INR n * sum_over (fun k => / INR k) (coprimes n).
Proof.
  intros Hn; assert (Hn3 : 3 <= INR n) by (apply le_INR in Hn; simpl in Hn; lra).
  unfold coprimes; destruct n as [|n]; [lia|]; cbn [seq filter].
  replace (Nat.gcd 1 (S n)) with 1%nat by (symmetry; apply Nat.divide_1_r, Nat.gcd_divide_l);
    cbn [Nat.eqb sum_over fold_right].
  assert (H : forall l, (forall k, In k l -> (2 <= k)%nat) -> sum_over (share (S n)) l = / INR (S n) * sum_over
    (fun k => / INR k) l).
  { induction l as [|k l IH]; intros Hl; cbn [sum_over fold_right]; [lra|].
    fold (sum_over (share (S n)) l) (sum_over (fun k => / INR k) l).
    rewrite IH by (intros; apply Hl; now right); unfold share at 1.
    assert (2 <= k)%nat by (apply Hl; now left); destruct (Nat.eqb_spec k 1) as [->|]; [lia|].
    set (x := sum_over _ l); generalize (INR (S n)); intros; ring. }
  fold (sum_over (share (S n)) (filter (fun k => Nat.gcd k (S n) =? 1)%nat (seq 2 n))).
  fold (sum_over (fun k => / INR k) (filter (fun k => Nat.gcd k (S n) =? 1)%nat (seq 2 n))).
  rewrite H; [unfold share; cbn [Nat.eqb]; change (INR 1) with 1; field; lra|].
  intros k Hk; apply filter_In in Hk; destruct Hk as [Hk _]; apply in_seq in Hk; lia.
Qed.

Lemma Measure : Measure_statement.
Proof.
  intros n L Hn HL HI.
  destruct (choose_list (opposite n) (coprimes n)) as [L' HF].
  { intros k Hk; apply coprimes_spec in Hk as [Hk Hg]; [|assumption].
    destruct (proj1 (proj1 (deciding_indices_stated n Hn) (n - k)%nat)) as (g & lo & hi & HS).
    - split; [lia | apply coprime_complement; lia].
    - now exists (Plus, g, lo, hi). }
  assert (Hk : forall k, In k (coprimes n) -> (1 <= k <= n - 1)%nat).
  { intros k Hk; apply coprimes_spec in Hk; lia. }
  destruct (Forall2_find _ _ _ HF) as [Hto Hfrom].
  assert (HP : Permutation L ((Minus, Plus, 0, 1 / (2 * INR n)) :: L')).
  { apply NoDup_Permutation; [assumption| |].
    - constructor; [intros Hx; destruct (Hfrom _ Hx) as (? & _ & ? & _); discriminate|].
      apply (Forall2_NoDup _ _ _ HF); [apply NoDup_filter, seq_NoDup|].
      intros k k' [[[e g] lo] hi] H H' [_ HS] [_ HS']; apply Hk in H, H'. assert (n - k = n - k')%nat; [|lia].
      now apply (proj2 (deciding_indices_stated n Hn) _ g lo hi _ g lo hi).
    - intros [[[e g] lo] hi]; rewrite HI; split.
      + intros [|k g' lo' hi' HS]; [now left | right].
        destruct (proj2 (proj1 (deciding_indices_stated n Hn) k)) as [H Hg]; [eauto|].
        destruct (Hto (n - k)%nat) as ([[[e1 g1] lo1] hi1] & Hx & -> & HS').
        { apply coprimes_spec; [assumption|]; split; [lia | apply coprime_complement; lia]. }
        replace (n - (n - k))%nat with k in HS' by lia.
        destruct (proj2 (deciding_indices_stated n Hn) _ _ _ _ _ _ _ _ HS HS') as [HE _].
        now injection (HE eq_refl) as -> -> ->.
      + intros [E|Hx]; [injection E as <- <- <- <-; constructor|].
        destruct (Hfrom _ Hx) as (k & _ & -> & HS); exact (beside n _ _ _ _ HS). }
  rewrite (sum_over_permutation _ _ _ HP); change (coprime_to n) with (coprimes n).
  rewrite <- shares, <- (total n (coprimes n) L' Hn Hk HF) by assumption.
  cbn [sum_over fold_right]; fold (sum_over length_of L'); unfold length_of at 1; cbn [fst]; lra.
Qed.
