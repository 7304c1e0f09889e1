(** * Chaos just beyond the touch: the proof of the theorem *)
From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import StatementPlane.
From Grazing Require Import StatementAttractor AttractorAlgebra AttractorDerivative AttractorEigen
  AttractorOrbit.
Open Scope R_scope.

Section Map.
Variables l1 l2 b E d nu : R.
Hypothesis Hl : 0 < l2 < l1.
Hypothesis Hl1 : l1 < 1.
Hypothesis Hb : 0 < b.
Hypothesis HE : 1 < E.
Hypothesis Hd : 0 < d <= 1 / 4.
Hypothesis HdE : d * (4 + 2 * E) <= l1 - 2 * E * (1 - l1).
Hypothesis Hnu : 0 < nu.
Hypothesis Heps : nu / ((l1 - l2) * b) ^ 2 <= d.
Hypothesis HS : 2 * l2 / (l1 - l2) + 2 * l1 / (l1 - l2) + (E + 1) * l1 / (d * (l1 - l2) ^ 2) <= b / (2 * sqrt
  nu).
Notation height := (height l1 l2 nu).
Notation step := (step l1 l2 b nu).
Notation iterate := (iterate l1 l2 b nu).
Notation change := (change l1 l2).
Notation cone := (cone l1 l2).
Notation trap := (trap l1 l2 b nu).
Notation along := (along l1 l2 b nu).
Notation first_return := (first_return l1 l2 b nu).

(** ** Growth *)
Lemma return_cone n x v : trap x -> height x < 0 -> first_return n x -> cone v ->
  cone (apply (along n x) v) /\ E * Rabs (change v) <= Rabs (change (apply (along n x) v)).
Proof.
  intros Hx Hh Hr Hv. pose proof (return_point l1 l2 b nu n x ltac:(lra) Hr) as [E1 _]. simpl in E1.
  assert (Ht : trap (iterate n x)) by exact (return_trap l1 l2 b nu Hl Hb Hnu n x (proj1 Hx) ltac:(lra) Hr).
  destruct Hx as (Hw & Hq & Hc1 & Hc2). destruct Ht as (_ & _ & Hc1' & _). destruct Hr as (Hn & Hh' & Hk).
  set (y := sqrt (- height x)) in *. assert (Hy : 0 < y) by (apply sqrt_lt_R0; lra).
  assert (Hy2 : y ^ 2 = nu - (height x + nu)). { unfold y. simpl. rewrite Rmult_1_r, sqrt_sqrt by lra. ring.
  } set (s := b / (2 * y)). assert (Hs : 2 * s * y = b) by (unfold s; field; lra). set (c := height x + nu) in *.
  set (q := l2 * snd x) in *. assert (Hc : 0 <= c) by (unfold c, StatementAttractor.height, wedge in *; nra).
  assert (Hq0 : 0 <= q) by (unfold q, wedge in *; nra). assert (Hq1 : q
    * (l1 - l2) <= l2 * nu).
  { apply (Rmult_le_compat_r (l1 - l2)) in Hq; [|lra]. replace (nu / (l1 - l2) * (l1 - l2)) with nu in Hq by (field;
      lra). apply (Rmult_le_compat_l l2) in Hq; [|lra]. unfold q. lra. }
  assert (HK : 0 < l2 ^ n) by (apply pow_lt; lra). assert (HL : 0 < l1 ^ n) by (apply pow_lt; lra).
  assert (HL1 : l1 ^ n <= l1).
  { destruct n as [|n]; [lia|]. simpl. assert (l1 ^ n <= 1) by (rewrite <- (pow1 n); apply pow_incr; lra). nra. }
  pose proof (power_ratio l1 l2 n Hl Hn) as HKL. set (M := 2 * l2 / (l1 - l2)) in *. assert (PM : 0 < M) by (unfold M;
    apply Rdiv_lt_0_compat; lra). assert (P1 : 0 < 2 * l1 / (l1 - l2)) by (apply Rdiv_lt_0_compat; lra).
  assert (P2 : 0 < (E + 1) * l1 / (d * (l1 - l2) ^ 2)).
  { apply Rdiv_lt_0_compat; [nra|]. apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]. }
  assert (Ss : b / (2 * sqrt nu) <= s).
  { unfold s. unfold Rdiv. apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; [lra|].
    assert (y <= sqrt nu); [|lra]. apply sqrt_le_1_alt. unfold c in Hc. lra. }
  assert (Gr := growth l1 l2 Hl E d Hl1 HE Hd HdE nu b (l1 ^ n) (l2 ^ n) s y c (height (iterate n x) + nu) q (nu /
    ((l1 - l2) * b) ^ 2) Hnu Hb HK ltac:(lra) HKL Hy Hy2 Hs Heps Hc1 Hq0 Hq1 Hc2 Hc1' E1 ltac:(fold M; lra)).
  fold M in Gr. set (dc := change v). set (dq := l2 * snd v). assert (Hv' : Rabs dq <= M * Rabs dc) by exact Hv.
  destruct (cone_growth l1 l2 Hl (l1 ^ n) (l2 ^ n) s dc dq HK HL HKL ltac:(fold M; lra) Hv') as [C1 C2].
  fold M in C1, C2. destruct (return_vector l1 l2 b nu n x v Hh (conj Hn (conj Hh' Hk))) as [Ec Es].
  fold y s dc dq in Ec, Es. split.
  - unfold StatementAttractor.cone. rewrite Es, Ec. exact C1.
  - rewrite Ec. eapply Rle_trans; [|exact C2]. apply Rmult_le_compat_r; [apply Rabs_pos|exact Gr].
Qed.

Lemma theorem : exists N, (1 <= N)%nat /\ chaotic l1 l2 b nu E N /\ expanding l1 l2 b nu E.
Proof.
  destruct (growing l1 l2 b nu Hl Hl1 Hb Hnu E 1 (fun _ => 1) HE) as (N & H1 & H2).
  - intros x _. lra.
  - intros n x v Hx Hh Hr Hv. destruct (return_cone n x v Hx Hh Hr Hv) as [C1 C2]. split; [exact C1|lra].
  - exists N. split; [exact H1|]. split; [exact H2|]. intros x n Hx Hg Hn Hh Hk. exists (along n x). split;
      [apply derivative_iterate; try assumption; intros j _; apply Hg|]. intros v Hv. assert (Hx0 : height x < 0).
    { pose proof (Hg 0%nat) as H0. destruct Hx as (_ & _ & _ & H). simpl in H0. lra. } destruct (return_cone n x v Hx
      Hx0) as [C1 C2]; [|exact Hv|split; [exact C1|lra]]. split; [exact Hn|]. split; [exact Hh|]. intros k H.
    left. apply Hk. exact H.
Qed.
End Map.

Theorem attractor : Wedge_statement.
Proof.
  intros l1 l2 b E Hl1 Hl Hb HE. assert (HE' : 2 * E * (1 - l1) < l1).
  { destruct HE as [_ H]. apply Rmult_lt_compat_r with (r := 2 * (1 - l1)) in H; [|lra]. replace (l1 / (2 * (1 - l1))
      * (2 * (1 - l1))) with l1 in H by (field; lra). lra. }
  set (d := (l1 - 2 * E * (1 - l1)) / (4 + 2 * E)). assert (Hd1 : d * (4 + 2 * E) = l1 - 2 * E * (1 - l1)) by (unfold
    d; field; lra). assert (Hd : 0 < d <= 1 / 4).
  { split; [unfold d; apply Rdiv_lt_0_compat; lra|]. unfold d. apply div_le; [lra|].
    assert (0 < E * (1 - l1)) by (apply Rmult_lt_0_compat; lra). lra. }
  set (S0 := 2 * l2 / (l1 - l2) + 2 * l1 / (l1 - l2) + (E + 1) * l1 / (d * (l1 - l2) ^ 2)). assert (HS0 : 0 < S0).
  { assert (0 < 2 * l2 / (l1 - l2)) by (apply Rdiv_lt_0_compat; lra). assert (0 < 2 * l1 / (l1 - l2)) by (apply
      Rdiv_lt_0_compat; lra). assert (0 < (E + 1) * l1 / (d * (l1 - l2) ^ 2)).
    { apply Rdiv_lt_0_compat; [nra|]. apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]. } unfold S0. lra. }
  assert (Hw : 0 < ((l1 - l2) * b) ^ 2) by (apply pow_lt; apply Rmult_lt_0_compat; lra). exists (Rmin (d * ((l1 - l2)
    * b) ^ 2) ((b / (2 * S0)) ^ 2)). split.
  { apply Rmin_glb_lt; [apply Rmult_lt_0_compat; lra|]. apply pow_lt. apply Rdiv_lt_0_compat; lra. }
  intros nu [Hnu Hnu0]. assert (N1 : nu <= d * ((l1 - l2) * b) ^ 2) by (eapply Rle_trans;
    [apply Hnu0|apply Rmin_l]). assert (N2 : nu <= (b / (2 * S0)) ^ 2) by (eapply Rle_trans;
    [apply Hnu0|apply Rmin_r]). apply (theorem l1 l2 b E d nu); try assumption; try lra.
  - apply div_le; assumption.
  - fold S0. assert (Hs : 0 < sqrt nu) by (apply sqrt_lt_R0; lra). assert (sqrt nu <= b / (2 * S0)).
    { rewrite <- (sqrt_pow2 (b / (2 * S0))) by (left; apply Rdiv_lt_0_compat; lra). apply sqrt_le_1_alt. exact N2. }
    apply le_div; [lra|]. apply Rmult_le_compat_r with (r := 2 * S0) in H; [|lra]. replace (b / (2 * S0) * (2 * S0))
      with b in H by (field; lra). lra.
Qed.
