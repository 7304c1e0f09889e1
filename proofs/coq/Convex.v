(** * The set V of points whose gap is >= 0 is convex, and a segment in V has gap > 0 between its ends

    Section 2 of ../conjecture1.md. A point is a time t (0 at phase al, n at phase be) and
    a phase w; it lies in V where [gap] >= 0, and inside where [gap] > 0. *)

From Coq Require Import Reals Lra.
From Grazing Require Import LnCos.
Open Scope R_scope.

Section Convex.

(** The phase at time 0, and ln r. *)
Variables al L : R.

Definition gap (t w : R) : R := lncos w + t * L - lncos al.
Definition V (t w : R) : Prop := window w /\ 0 <= gap t w.
Definition inside (t w : R) : Prop := window w /\ 0 < gap t w.

Lemma inside_V t w : inside t w -> V t w. Proof. intros [? ?]; split; [assumption|lra]. Qed.

Lemma window_mean a w1 w2 : 0 <= a <= 1 -> window w1 -> window w2 -> window (a * w1 + (1 - a) * w2).
Proof.
  intros Ha H1 H2; destruct (Rle_or_lt w1 w2).
  - apply (window_between w1 _ w2); trivial; nra.
  - apply (window_between w2 _ w1); trivial; nra.
Qed.

Lemma gap_concave a t1 w1 t2 w2 : 0 <= a <= 1 -> window w1 -> window w2 -> a * gap t1 w1 + (1 - a) * gap t2 w2 <= gap
  (a * t1 + (1 - a) * t2) (a * w1 + (1 - a) * w2).
Proof.
  intros Ha H1 H2; pose proof (window_mean a w1 w2 Ha H1 H2) as H0.
  pose proof (lncos_tangent _ _ H0 H1); pose proof (lncos_tangent _ _ H0 H2). unfold gap; nra.
Qed.

Lemma gap_concave_strict a t1 w1 t2 w2 : 0 < a < 1 -> window w1 -> window w2 -> w1 <> w2 -> a * gap t1 w1 + (1 - a)
  * gap t2 w2 < gap (a * t1 + (1 - a) * t2) (a * w1 + (1 - a) * w2).
Proof.
  intros Ha H1 H2 Hne. assert (H0 : window (a * w1 + (1 - a) * w2)) by (apply window_mean; trivial; lra).
  assert (w1 <> a * w1 + (1 - a) * w2) by (intros E; apply Hne; nra).
  pose proof (lncos_tangent_strict _ _ H0 H1 H); pose proof (lncos_tangent _ _ H0 H2). unfold gap; nra.
Qed.

Lemma V_segment a t1 w1 t2 w2 : 0 <= a <= 1 -> V t1 w1 -> V t2 w2 -> V (a * t1 + (1 - a) * t2) (a * w1 + (1 - a) * w2).
Proof.
  intros Ha [H1 G1] [H2 G2]; split; [now apply window_mean|]. pose proof (gap_concave a t1 w1 t2 w2 Ha H1 H2); nra.
Qed.

(** Strictly convex, but along a constant phase, where [gap] is affine in t. *)
Lemma V_open_segment a t1 w1 t2 w2 : 0 < a < 1 -> V t1 w1 -> V t2 w2 -> w1 <> w2 \/ L <> 0 /\ t1 <> t2 ->
  inside (a * t1 + (1 - a) * t2) (a * w1 + (1 - a) * w2).
Proof.
  intros Ha [H1 G1] [H2 G2] Hne; split; [apply window_mean; trivial; lra|]. destruct (Req_dec w1 w2) as [->|Hw].
  - destruct Hne as [|[HL Ht]]; [lra|]. replace (a * w2 + (1 - a) * w2) with w2 by ring.
    assert (gap t1 w2 <> gap t2 w2).
    { unfold gap; intros E; apply Ht, (Rmult_eq_reg_r L); [lra|assumption]. }
    replace (gap (a * t1 + (1 - a) * t2) w2) with (a * gap t1 w2 + (1 - a) * gap t2 w2) by (unfold gap; ring). nra.
  - pose proof (gap_concave_strict a t1 w1 t2 w2 Ha H1 H2 Hw); nra.
Qed.

(** At a fixed time gap is least at an end of a segment. *)
Lemma gap_between t v w z : window v -> window z -> v <= w <= z ->
  window w /\ (gap t v <= gap t w \/ gap t z <= gap t w).
Proof.
  intros Hv Hz Hw; assert (Hi : window w) by (apply (window_between v w z); assumption).
  pose proof (lncos_tangent _ _ Hi Hv); pose proof (lncos_tangent _ _ Hi Hz). split; [assumption|]; unfold gap.
  destruct (Rle_or_lt 0 (tan w)); [right|left]; nra.
Qed.

Lemma V_between t v w z : V t v -> V t z -> v <= w <= z -> V t w.
Proof. intros [Hv Gv] [Hz Gz] Hw; destruct (gap_between t v w z Hv Hz Hw) as [Hi [|]]; split; trivial; lra. Qed.
Lemma inside_between t v w z : inside t v -> inside t z -> v <= w <= z -> inside t w.
Proof. intros [Hv Gv] [Hz Gz] Hw; destruct (gap_between t v w z Hv Hz Hw) as [Hi [|]]; split; trivial; lra. Qed.

End Convex.
