(** * A lattice point of V forces the one that decides: the triangle and the reflection

    Section 4 of ../conjecture1.md. [W t h] is the phase at time t, 0 <= t <= n, and height h above the chord
    from (0, al) to (n, be). A point of V at height i >= 1 forces one at height 1, and if al > 0 a point at
    height 1 forces one at height -1. For lattice points this leaves a single one that decides. *)

From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import LnCos Convex.
Open Scope R_scope.

Lemma ratio_lt x n : 0 < x < n -> 0 < x / n < 1.
Proof.
  intros H; split; [apply Rdiv_lt_0_compat; lra|].
  apply (Rmult_lt_reg_r n); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Lemma ratio_le x n : 0 < n -> 0 <= x <= n -> 0 <= x / n <= 1.
Proof.
  intros Hn H; split; [apply Rmult_le_pos; [lra|now apply Rlt_le, Rinv_0_lt_compat]|].
  apply (Rmult_le_reg_r n); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
Qed.

(** The two ends of the chord have gap 0; L = ln r. *)
Definition chord (al be L n : R) : Prop :=
  window al /\ window be /\ al <> be /\ 0 < n /\ L <= 0 /\ lncos al = lncos be + n * L.

Definition W (al be n t h : R) : R := al + t / n * (be - al) + h / n * (2 * PI).

Lemma chord_opp al be L n : chord al be L n -> chord (- al) (- be) L n.
Proof.
  unfold chord; rewrite !lncos_opp; intros (? & ? & Hne & ? & ? & ?).
  assert (- al <> - be) by (intros E; apply Hne; lra). auto 10 using window_opp.
Qed.

Lemma W_opp al be n t h : W (- al) (- be) n t h = - W al be n t (- h). Proof. unfold W, Rdiv; ring. Qed.

Lemma V_opp al L t w : V (- al) L t (- w) <-> V al L t w.
Proof.
  unfold V, gap; rewrite !lncos_opp; split; intros [? ?]; split; trivial.
  - rewrite <- (Ropp_involutive w); now apply window_opp.
  - now apply window_opp.
Qed.

Lemma inside_opp al L t w : inside (- al) L t (- w) <-> inside al L t w.
Proof.
  unfold inside, gap; rewrite !lncos_opp; split; intros [? ?]; split; trivial.
  - rewrite <- (Ropp_involutive w); now apply window_opp.
  - now apply window_opp.
Qed.

Section Chord.

Variables al be L n : R.
Hypothesis Hchord : chord al be L n.
Let w := W al be n.

Lemma V_start : V al L 0 al. Proof. destruct Hchord as (? & _); split; [assumption|]; unfold gap; lra. Qed.
Lemma V_end : V al L n be.
Proof. destruct Hchord as (_ & ? & _ & _ & _ & ?); split; [assumption|]; unfold gap; lra. Qed.

(** The chord is in V, and inside but for its ends. *)
Lemma chord_inside t : 0 < t < n -> inside al L t (w t 0).
Proof.
  destruct Hchord as (_ & _ & Hne & Hn & _); intros Ht.
  assert (Ha : 0 < 1 - t / n < 1) by (pose proof (ratio_lt t n Ht); lra).
  pose proof (V_open_segment al L _ _ _ _ _ Ha V_start V_end (or_introl Hne)) as H.
  replace t with ((1 - t / n) * 0 + (1 - (1 - t / n)) * n) at 1 by (field; lra).
  replace (w t 0) with ((1 - t / n) * al + (1 - (1 - t / n)) * be); [exact H|]. unfold w, W, Rdiv; ring.
Qed.

Lemma chord_V t : 0 <= t <= n -> V al L t (w t 0).
Proof.
  intros Ht; destruct Hchord as (_ & _ & _ & Hn & _).
  destruct (Req_dec t 0) as [->|]; [|destruct (Req_dec t n) as [->|]].
  - replace (w 0 0) with al; [apply V_start|unfold w, W, Rdiv; ring].
  - replace (w n 0) with be; [apply V_end|unfold w, W; field; lra].
  - apply inside_V, chord_inside; lra.
Qed.

(** The triangle with corners (t, i), (0, 0), (n, 0) contains ((t + q n)/i, 1). *)
Lemma triangle t i q : 1 < i -> 0 <= q <= i - 1 -> V al L t (w t i) -> V al L ((t + q * n) / i) (w ((t + q * n) / i) 1)
  /\ (L < 0 -> inside al L ((t + q * n) / i) (w ((t + q * n) / i) 1)).
Proof.
  intros Hi Hq HV; destruct Hchord as (_ & _ & _ & Hn & _). set (s := q * n / (i - 1)).
  assert (Hx : 0 <= q / (i - 1) <= 1) by (apply ratio_le; lra).
  assert (Hs : 0 <= s <= n).
  { replace s with (q / (i - 1) * n) by (unfold s; field; lra); nra. }
  assert (Ha : 0 < / i < 1).
  { split; [apply Rinv_0_lt_compat; lra|]; rewrite <- Rinv_1; apply Rinv_lt_contravar; lra. }
  replace (w ((t + q * n) / i) 1) with (/ i * w t i + (1 - / i) * w s 0) by (unfold w, W, s; field; lra).
  replace ((t + q * n) / i) with (/ i * t + (1 - / i) * s) by (unfold s; field; lra). split.
  - apply V_segment; [lra|assumption|now apply chord_V].
  - intros HL; apply V_open_segment; [lra|assumption|now apply chord_V|].
    destruct (Req_dec t s) as [->|]; [left|right; split; [lra|assumption]]. unfold w, W; intros E; pose proof PI_RGT_0.
    assert (i / n * (2 * PI) = 0) by lra. assert (0 < i / n) by (apply Rdiv_lt_0_compat; lra); nra.
Qed.

(** The reflection (t, 1) -> (n - t, -1). *)
Lemma reflection t : al > 0 -> be < al -> 0 < t < n -> V al L t (w t 1) -> V al L (n - t) (w (n - t) (-1)) /\
  (L < 0 -> inside al L (n - t) (w (n - t) (-1))).
Proof.
  intros Hal Hlt Ht [Hw Hg]; destruct Hchord as (Ha & Hb & _ & Hn & HL & E).
  assert (Hle : w t 1 <= al).
  { apply Rle_trans with (Rabs (w t 1)); [apply Rle_abs|]. rewrite <- (Rabs_pos_eq al) by lra.
    apply lncos_inj_le; trivial; unfold gap in Hg; nra. }
  assert (Eq : w (n - t) (-1) = al + be - w t 1) by (unfold w, W; field; lra).
  assert (Hbetween : be <= w (n - t) (-1) <= w (n - t) 0).
  { split; [lra|]; unfold w, W; pose proof PI_RGT_0. assert (0 < / n) by now apply Rinv_0_lt_compat. unfold Rdiv; nra. }
  assert (Hc : inside al L (n - t) (w (n - t) 0)) by (apply chord_inside; lra). split; [|intros HL0].
  - apply (V_between al L _ be _ (w (n - t) 0)); trivial; [|now apply inside_V]. split; [assumption|]; unfold gap; nra.
  - apply (inside_between al L _ be _ (w (n - t) 0)); trivial. split; [assumption|]; unfold gap; nra.
Qed.

End Chord.

(** ** Lattice points: integer times k, 0 < k < n, and heights i

    At height 1 there is one time p, at height -1 one time p' = n - p; at height i the times are i p mod n. *)

Section Points.

Variables (al be L : R) (n : Z).
Hypothesis Hchord : chord al be L (IZR n).
Let w := W al be (IZR n).

Lemma triangle_lattice k i p q : (0 < k < n)%Z -> (0 < p < n)%Z -> (1 <= i)%Z -> (i * p = k + q * n)%Z ->
  V al L (IZR k) (w (IZR k) (IZR i)) -> V al L (IZR p) (w (IZR p) 1) /\
  (L < 0 -> k <> p -> inside al L (IZR p) (w (IZR p) 1)).
Proof.
  intros Hk Hp Hi E HV. assert (Hq : (0 <= q <= i - 1)%Z) by nia. destruct (Z.eq_dec i 1) as [->|Hne].
  - assert (k = p) as -> by nia; tauto.
  - assert (1 < IZR i) by (apply IZR_lt; lia).
    assert (Ep : IZR p = (IZR k + IZR q * IZR n) / IZR i).
    { rewrite <- mult_IZR, <- plus_IZR, <- E, mult_IZR; field; lra. }
    assert (Hq' : 0 <= IZR q <= IZR i - 1) by (rewrite <- minus_IZR; split; apply IZR_le; lia).
    rewrite Ep; destruct (triangle al be L (IZR n) Hchord (IZR k) (IZR i) (IZR q)); tauto.
Qed.

End Points.

(** If al > 0, any lattice point of V forces the one at height -1. *)
Lemma lattice_decides al be L n p p' k i q q' : chord al be L (IZR n) -> al > 0 -> (0 < k < n)%Z -> (0 < p < n)%Z ->
  (p + p' = n)%Z -> i <> 0%Z -> (i * p = k + q * n)%Z -> (- i * p' = k + q' * n)%Z ->
  V al L (IZR k) (W al be (IZR n) (IZR k) (IZR i)) -> V al L (IZR p') (W al be (IZR n) (IZR p') (-1)) /\
  (L < 0 -> k <> p' -> inside al L (IZR p') (W al be (IZR n) (IZR p') (-1))).
Proof.
  intros Hc Hal Hk Hp Hpp Hi Eq Eq' HV. destruct (Z_lt_le_dec i 0) as [Hneg|Hpos].
  - pose proof (chord_opp _ _ _ _ Hc) as Hc'.
    apply V_opp in HV; rewrite <- (Ropp_involutive (IZR i)), <- opp_IZR, <- W_opp in HV.
    destruct (triangle_lattice _ _ _ _ Hc' k (- i) p' q') as [HV' Hs]; [lia|lia|lia|assumption|assumption|].
    rewrite W_opp in HV', Hs; split; [now apply V_opp|intros; apply inside_opp; auto].
  - destruct (triangle_lattice _ _ _ _ Hc k i p q) as [HV' _]; [lia|lia|lia|assumption|assumption|].
    assert (Hlt : be < al).
    { destruct Hc as (Ha & Hb & Hne & Hn & HL & E).
      assert (Hle : Rabs be <= Rabs al) by (apply lncos_inj_le; trivial; nra). rewrite (Rabs_pos_eq al) in Hle by lra.
      pose proof (Rle_abs be); lra. }
    replace p' with (n - p)%Z by lia; rewrite minus_IZR.
    destruct (reflection al be L (IZR n) Hc (IZR p)) as [Hr Hs]; trivial.
    + split; [apply IZR_lt|apply IZR_lt]; lia.
    + tauto.
Qed.
