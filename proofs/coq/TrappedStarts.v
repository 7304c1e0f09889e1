(** * (ii): from larger bounds, and from starts that are no contacts, motions come into D *)
From Coq Require Import Reals ZArith Lra.
From Grazing Require Import Derivatives StatementOscillator.
From Grazing Require Import StatementTrapped TrappedCalculus TrappedFlow TrappedReturn TrappedMain.
Open Scope R_scope.

Section Starts.
Variables (M : machine) (lo hi : R).
Hypothesis O : opens M lo hi.
Let H := is_hump _ _ _ O.
Let Hb := opens_before _ _ _ O.
Notation D := (b M - a M).
Notation fast := (sqrt (2 * alM M * mu M)).
Lemma second z w t V t1 V1 x v : within M z w t V -> 0 < al0 M - b M ^ 2 * (z + (1 + tau M) * w) / D ->
  leg M t V t1 V1 x v -> within M (zm M) fast t1 V1.
Proof.
  intros Hw A L; destruct (pass_of M lo hi H t (proj1 Hw)) as (k & Hk); destruct (return_to M lo hi H Hb k t V t1 V1 x
    v z w Hk Hw A L) as (q1 & q2 & q3 & _ & n & _ & Pn). destruct L as [F _ _ _ _ N3 N4]; split; [exact q1|split;
      [split; [|exact q2]|exact q3]]. apply (shallow M lo hi H (k + n) t1 V1 (zm M) x v Pn F N3 N4 q1); [|exact q2].
  unfold zeta in q3; unfold zet; rewrite N3; rewrite N4 in q3; lra.
Qed.
Lemma into z w t V t1 V1 x v : within M z w t V -> 0 < al0 M - b M ^ 2 * (z + (1 + tau M) * w) / D -> zeta M t V <=
  zm M
  -> leg M t V t1 V1 x v -> trapped M t1 V1.
Proof.
  intros Hw A Hz L; destruct (pass_of M lo hi H t (proj1 Hw)) as (k & Hk); destruct (return_to M lo hi H Hb k t V t1
    V1 x v z w Hk Hw A L) as (q1 & q2 & q3 & q4 & _). split; [exact q1|split; [split; [apply q4, Hz|exact q2]|exact
    q3]].
Qed.

Variables (z s : R) (x v : R -> R).
Hypothesis B : begins M z.
Hypothesis Qs : Q M s <= 0.
Hypothesis F : free (a M + b M) (a M * b M) x v.
Hypothesis Xs : 0 <= x s.
Hypothesis Zs : 0 <= zet M x v s <= z.
Let Hab := overdamped _ _ _ H.
Let g r := x r - Q M r.
Lemma Dg r : derivable_pt_lim g r (v r - Q1 M r). Proof. apply D_minus; [apply F|apply (slope _ _ _ H)]. Qed.
Lemma arrival : exists t V, arrives M s t V x v.
Proof.
  assert (Come : forall s0, s <= s0 -> 0 < g s0 -> (forall r, s < r < s0 -> 0 < g r) -> exists t V, arrives M s t V x
    v).
  { intros s0 L P Op; destruct (meets M lo hi H x v s s0 F ltac:(lra)) as (e & Le & Fall).
    { rewrite (eta_zet M x v); assert (0 <= D * x s) by (apply Rmult_le_pos; lra); lra. } destruct (first_zero g s0 e)
    as (t & T1 & T2 & T3); [intros y; eapply D_continuous, Dg|exact Le|exact P|exact Fall|]. exists t, (v t - Q1 M t);
      unfold g in *; constructor; try lra.
    - intros r Hr; destruct (Rlt_or_le r s0) as [K|K]; [specialize (Op r ltac:(lra))|specialize (T3 r ltac:(lra))];
        lra.
    - apply (slope_at g _ t s0 (Dg t)); [lra|intros; apply T3; lra|exact T2]. } destruct (Rlt_or_le 0 (g s)) as [P|P];
  [apply (Come s); [lra|exact P|intros; lra]|]; unfold g in P.
  destruct (Rle_or_lt (v s - Q1 M s) 0) as [N|N]; [exists s, (v s - Q1 M s); constructor; intros; lra|].
  destruct (Dg s ((v s - Q1 M s) / 2) ltac:(lra)) as ([d Hd] & K); cbn in K.
  assert (Up : forall r, s < r < s + d -> 0 < g r).
  { intros r Hr; specialize (K (r - s) ltac:(lra) ltac:(rewrite Rabs_pos_eq; lra)); replace (s + (r - s)) with r in K
      by ring; apply Rabs_def2 in K; replace (g s) with 0 in K by (unfold g; lra). replace (g r) with ((g r - 0) / (r
      - s) * (r - s)) by (field; lra); apply Rmult_lt_0_compat; lra. } apply (Come (s + d / 2)); [lra|apply Up;
  lra|intros; apply Up; lra].
Qed.
Notation w := (sqrt (2 * (al1 M + a M ^ 2 * (mu M + z / D)) * mu M)).
Lemma fast_w : fast <= w.
Proof.
  destruct B as [Bz _], (positives M lo hi H) as [hmu _]; apply sqrt_le_1_alt, Rmult_le_compat_r; [lra|]; apply
    Rmult_le_compat_l; [lra|]; apply Rplus_le_compat_l, Rmult_le_compat_l; [apply pow2_ge_0|]; apply
      Rplus_le_compat_l, Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|exact Bz].
Qed.
Lemma fast_open : 0 < al0 M - b M ^ 2 * (zm M + (1 + tau M) * fast) / D.
Proof.
  pose proof fast_w; destruct B as [Bz A]; pose proof (restitution _ _ _ H); assert ((1 + tau M) * fast <= (1 + tau M)
    * w) by (apply Rmult_le_compat_l; lra); assert (b M ^ 2 * (zm M + (1 + tau M) * fast) / D <= b M ^ 2 * (z + (1 +
      tau M)
    * w) / D); [|lra]. apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|apply Rmult_le_compat_l; [apply
    pow2_ge_0|lra]].
Qed.
Lemma arrives_within t V : arrives M s t V x v -> within M z w t V.
Proof.
  intros [L Op E N NV]; assert (Ew : exp (- b M * (t - s)) <= 1) by (pose proof (exp_down (b M) 0 (t - s) ltac:(lra)
    ltac:(lra)) as X; rewrite Rmult_0_r, exp_0 in X; exact X). assert (Zt : 0 <= zet M x v t <= z).
  { rewrite (zet_flow M x v F s t); pose proof (exp_pos (- b M * (t - s))); split; [apply Rmult_le_pos; lra|]; apply
      Rle_trans with (zet M x v s * 1); [apply Rmult_le_compat_l; lra|lra]. } assert (Qt : 0 <= Q M t).
  { rewrite <- E, (x_flow' M Hab x v F s t); apply Rplus_le_le_0_compat; apply Rmult_le_pos; try lra; [left; apply
      exp_pos|apply phi12_pos; trivial; lra]. } destruct (pass_of M lo hi H t Qt) as (k & Hk); pose proof (shallow M
  lo hi H k t V z x v Hk F E N Qt Zt NV) as S.
  split; [exact Qt|split; [split; assumption|]]; unfold zeta; unfold zet in Zt; rewrite <- E; rewrite N; lra.
Qed.
Lemma stays_within t V t1 V1 y u : within M z w t V -> leg M t V t1 V1 y u -> within M z w t1 V1.
Proof.
  intros Hw L; destruct (second z w t V t1 V1 y u Hw (proj2 B) L) as (q1 & q2 & q3); pose proof fast_w; destruct B;
    split; [exact q1|split; lra].
Qed.
Lemma from_third t V : arrives M s t V x v -> third M t V.
Proof.
  intros Ar; pose proof (arrives_within t V Ar) as Hw; pose proof fast_open as Af; pose proof (proj2 B) as A.
  split; [apply (next_leg M lo hi H z w t V Hw A)|]; intros t1 V1 x1 v1 L1; pose proof (second z w t V t1 V1 x1 v1 Hw
    A L1) as W1. split; [apply (next_leg M lo hi H _ _ t1 V1 W1 Af)|]; intros t2 V2 y u L2.
  apply (into _ _ t1 V1 t2 V2 y u W1 Af); [apply W1|exact L2].
Qed.
End Starts.

Theorem Absorbed : Absorbed_statement.
Proof.
  intros M lo hi z w t V t1 V1 x v t2 V2 y u O fast A1 A2 Hw L1 L2; pose proof (second M lo hi O z w t V t1 V1 x v Hw
    A1 L1) as W1. split; [exact W1|]; apply (into M lo hi O _ _ t1 V1 t2 V2 y u W1 A2); [apply W1|exact L2].
Qed.
Theorem Started : Started_statement.
Proof.
  intros M lo hi z s x v O B Qs F Xs Zs; split; [apply (arrival M lo hi O z s x v); trivial|]; intros t V; apply
    (from_third M lo hi O z s x v); trivial.
Qed.
