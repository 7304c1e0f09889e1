(** P0 to P5: the next contact exists, lies in a later pass and is in D again. *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Derivatives StatementOscillator.
From Grazing Require Import StatementTrapped TrappedCalculus TrappedFlow.
Open Scope R_scope.

Section Stop.
Variables (M : machine) (lo hi : R).
Hypothesis H : hump M lo hi.
Notation a := (a M). Notation b := (b M). Notation tau := (tau M). Notation p := (p M). Notation W := (W M).
Notation mu := (mu M). Notation Q := (Q M). Notation Q1 := (Q1 M). Notation Q2 := (Q2 M).
Notation D := (StatementTrapped.b M - StatementTrapped.a M).

Lemma sizes : lo <= hi <= lo + W /\ W < p. Proof. split; apply H. Qed.
Lemma positives : 0 < mu /\ 0 < al0 M. Proof. split; apply H. Qed.
Lemma hump_shift k : hump M (lo + p * IZR k) (hi + p * IZR k).
Proof.
  destruct H as [h1 h2 h3 hp hs hb hw hn hbelow hbent hal hh hr]. assert (P1 := periodic_slope Q Q1 p hp hs);
    assert (P2 := periodic_slope Q1 Q2 p P1 hb). split; trivial; [lra| |]; intros t Ht.
  - rewrite <- (whole Q p hp (- k) t), opp_IZR; apply hbelow; lra.
  - rewrite <- (whole Q2 p P2 (- k) t), opp_IZR; apply hbent; lra.
Qed.
Lemma Q_whole k t : Q (t + p * IZR k) = Q t. Proof. apply whole, (period _ _ _ H). Qed.
Lemma pass_at t : 0 <= Q t -> in_pass M lo hi (up ((t - lo) / p) - 1) t.
Proof.
  intros Pos; destruct sizes as [w1 w2]. assert (Hp : 0 < p) by lra. destruct (archimed ((t - lo) / p)) as [U1 U2];
    set (u := up ((t - lo) / p)) in *. assert (E : (t - lo) / p * p = t - lo) by (field; lra). unfold in_pass;
    rewrite minus_IZR; split; [nra|]. apply Rnot_lt_le; intros L; assert (B : Q (t + p * IZR (- (u - 1))) < 0).
  { apply (below _ _ _ H); rewrite opp_IZR, minus_IZR; split; [lra|nra]. } rewrite Q_whole in B; lra.
Qed.
Lemma pass_of t : 0 <= Q t -> exists k, in_pass M lo hi k t. Proof. intros HQ; eexists; apply (pass_at t HQ). Qed.
Lemma pass_order k n s t : in_pass M lo hi k s -> in_pass M lo hi n t -> (k < n)%Z -> s < t.
Proof.
  unfold in_pass; intros Hs Ht L; destruct sizes as [w1 w2]. assert (IZR k + 1 <= IZR n) by (rewrite <- plus_IZR;
    apply IZR_le; lia). assert (p * (IZR k + 1) <= p * IZR n) by (apply Rmult_le_compat_l; lra); lra.
Qed.
Lemma Q_end : Q hi <= 0.
Proof.
  destruct sizes as [w1 w2]; apply Rnot_lt_le; intros L. destruct (continuous_near Q hi (Q hi / 2)) as (d & Hd & B);
    [eapply D_continuous, (slope _ _ _ H)|lra|]. set (y := hi + Rmin d ((lo + p - hi) / 2)).
  assert (Y : hi < y < lo + p /\ y <= hi + d) by (unfold y, Rmin; destruct Rle_dec; lra).
  specialize (B y ltac:(apply Rabs_le; lra)); apply le_abs in B; pose proof (below _ _ _ H y ltac:(lra)); lra.
Qed.

(** *** A motion from a contact in pass 0 *)
(** P5, from any contact: the motion would go below the stop. *)
Section Dive.
Variables (k : Z) (t V z : R) (x v : R -> R).
Hypothesis Pt : in_pass M lo hi k t.
Hypothesis F : free (a + b) (a * b) x v.
Hypothesis X0 : x t = Q t.
Hypothesis V0 : V = v t - Q1 t.
Hypothesis HQ : 0 <= Q t.
Hypothesis Hz : 0 <= zet M x v t <= z.
Let Hab := overdamped _ _ _ H.
Let g s := x s - Q s.
Let g1 s := v s - Q1 s.
Let g2 s := - (a + b) * v s - a * b * x s - Q2 s.
Let steep := al1 M + a ^ 2 * (mu + z / D).
Lemma not_below s : t <= s -> 0 <= zet M x v s /\ 0 <= x s.
Proof.
  intros L; rewrite (zet_flow M x v F t s), (x_flow' M Hab x v F t s), X0; split; [apply Rmult_le_pos; [lra|left;
    apply exp_pos]|]. apply Rplus_le_le_0_compat; apply Rmult_le_pos; try lra; [left; apply exp_pos|apply phi12_pos;
    trivial; lra].
Qed.
Lemma dive : V < 0 -> 0 < steep /\ exists s, in_pass M lo hi k s /\ t <= s /\ x s - Q s <= - (V ^ 2 / (2 * steep)).
Proof.
  intros NV; pose proof (hump_shift k) as Hk; set (e := hi + p * IZR k) in *; assert (Te : t <= e) by apply Pt.
  destruct sizes as [w1 w2]; destruct positives as [hmu hal].
  assert (Dg : forall s, derivable_pt_lim g s (g1 s)) by (intros; apply D_minus; [apply (D_x M x v F)|apply (slope _ _
    _ H)]). assert (Dg1 : forall s, derivable_pt_lim g1 s (g2 s)) by (intros; apply D_minus; [apply (D_v M x v
    F)|apply (bend _ _ _ H)]).
  assert (Up : forall y, t <= y <= e -> g2 y <= steep).
  { intros y Hy; pose proof (bent _ _ _ Hk y) as Bt; unfold in_pass in Pt; specialize (Bt ltac:(lra)).
    unfold g2; rewrite (acc_of M Hab x v); destruct (not_below y ltac:(lra)) as [Zp _]. assert (0 <= b ^ 2 * zet M x v
      y / D) by (apply Rmult_le_pos; [apply Rmult_le_pos; [apply pow2_ge_0|trivial]|left; apply Rinv_0_lt_compat;
      lra]). assert (E : eta M x v y <= D * mu + z).
    { pose proof (highest _ _ _ H t); assert (D * Q t <= D * mu) by (apply Rmult_le_compat_l; lra); assert (0 <= D * Q
        t) by (apply Rmult_le_pos; lra). assert (0 <= eta M x v t <= D * mu + z) by (rewrite (eta_zet M x v t), X0;
        lra). rewrite (eta_flow M x v F t y); apply Rle_trans with (eta M x v t * 1); [|lra]. apply Rmult_le_compat_l;
        [lra|]. pose proof (exp_down a 0 (y - t) ltac:(lra) ltac:(lra)) as X; rewrite Rmult_0_r, exp_0 in X; exact X.
        } assert (a ^ 2 * eta M x v y / D <= a ^ 2 * (mu + z / D)); [|unfold steep; lra].
    replace (a ^ 2 * (mu + z / D)) with (a ^ 2 * (D * mu + z) / D) by (field; lra). apply Rmult_le_compat_r; [left;
      apply Rinv_0_lt_compat; lra|apply Rmult_le_compat_l; [apply pow2_ge_0|trivial]]. } assert (AM : 0 < steep).
  { assert (0 <= z / D) by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]). assert (0 <= a ^ 2 * (mu + z
      / D)) by (apply Rmult_le_pos; [apply pow2_ge_0|lra]). pose proof (bent _ _ _ H lo ltac:(lra)); unfold steep;
      lra. }
  assert (Ge : forall y, e <= y < e + (lo + p - hi) -> 0 <= g y).
  { intros y Hy; destruct (not_below y ltac:(lra)) as [_ Xp]; unfold g; destruct (Req_dec y e) as [->|Ne].
    - unfold e in *; rewrite Q_whole; pose proof Q_end; lra.
    - pose proof (below _ _ _ Hk y ltac:(unfold e in *; lra)); lra. }
  assert (g0 : g t = 0) by (unfold g; lra); assert (g10 : g1 t = V) by (unfold g1; lra).
  assert (G : forall s, t <= s <= e -> g s <= V * (s - t) + steep / 2 * (s - t) ^ 2).
  { intros s Hs; pose proof (above_right (fun y => - g y) (fun y => - g1 y) (fun y => - g2 y) ltac:(intros y;
      apply derivable_pt_lim_opp, Dg) ltac:(intros y; apply derivable_pt_lim_opp, Dg1) (- steep) t s ltac:(lra)
      ltac:(intros y Hy; specialize (Up y ltac:(lra)); lra)) as G; cbv beta in G; rewrite g0, g10 in G; lra. }
  clearbody steep; split; trivial; destruct (Rle_or_lt (t - V / steep) e) as [L|L].
  - assert (P : 0 < - V / steep) by (apply Rdiv_lt_0_compat; lra). pose proof (G (t - V / steep) ltac:(unfold Rdiv in
      *; lra)) as G0. replace (V * (t - V / steep - t) + steep / 2 * (t - V / steep - t) ^ 2) with (- (V ^ 2 / (2 *
      steep))) in G0 by (field; lra). exists (t - V / steep); split; [|split; [unfold Rdiv in *;
      lra|exact G0]]. destruct Pt as [q1 q2]; split; unfold e in L; unfold Rdiv in *; lra.
  - exfalso; destruct (Req_dec t e) as [E|Ne].
    + pose proof (slope_after g (g1 t) t (t + (lo + p - hi)) (Dg t) ltac:(lra) ltac:(intros; apply Ge; lra) g0); lra.
    + pose proof (G e ltac:(lra)) as G0; pose proof (Ge e ltac:(lra)). assert (steep * (e - t) < - V).
      { apply Rmult_lt_reg_r with (/ steep); [apply Rinv_0_lt_compat; lra|]. replace (steep * (e - t) * / steep) with
          (e - t) by (field; lra); unfold Rdiv in *; lra. }
      nra.
Qed.
Lemma shallow : V <= 0 -> - sqrt (2 * steep * mu) <= V.
Proof.
  intros NV; destruct (Req_dec V 0) as [->|N]; [pose proof (sqrt_pos (2 * steep * mu)); lra|]; destruct (dive
    ltac:(lra)) as (AM & s & _ & Ls & Gs); destruct (not_below s Ls) as [_ Xp]; pose proof (highest _ _ _ H s).
  assert (S : V ^ 2 <= 2 * steep * mu).
  { apply Rmult_le_reg_r with (/ (2 * steep)); [apply Rinv_0_lt_compat; lra|]. replace (2 * steep * mu * / (2 *
      steep)) with mu by (field; lra); unfold Rdiv in *; lra. } apply sqrt_le_1_alt in S; replace (V ^ 2) with ((- V)
  ^ 2) in S by ring; rewrite sqrt_pow2 in S by lra; lra.
Qed.
End Dive.
(** It comes down to the stop. *)
Lemma meets x v t s : free (a + b) (a * b) x v -> 0 <= zet M x v t -> 0 <= eta M x v t -> exists e, s < e /\
  x e - Q e <= 0.
Proof.
  intros F Zp Ep; pose proof (overdamped _ _ _ H) as Hab; destruct sizes as [w1 w2]; destruct positives as [hmu _];
    destruct (reached _ _ _ H) as (tm & Etm). set (L := Rmax s (t + eta M x v t / (D * mu * a))); destruct (archimed
    ((L - tm) / p)) as [U1 _]; set (k := up ((L - tm) / p)) in *. assert (E : (L - tm) / p * p = L - tm) by (field;
    lra); set (e := tm + p * IZR k); assert (Le : L < e) by (unfold e; nra).
  assert (L1 : s <= L) by apply Rmax_l; assert (L2 : t + eta M x v t / (D * mu * a) <= L) by apply Rmax_r.
  exists e; split; [lra|]; unfold e at 2; rewrite Q_whole, Etm, (x_of M Hab x v e); assert (Ze : 0 <= zet M x v e) by
    (rewrite (zet_flow M x v F t e); apply Rmult_le_pos; [exact Zp|left; apply exp_pos]).
  apply Rle_minus, Rle_trans with (eta M x v e / D); [apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat;
    lra|lra]|]. rewrite (eta_flow M x v F t e); pose proof (exp_ineq1_le (a * (e - t))) as X.
  replace (- a * (e - t)) with (- (a * (e - t))) by ring; rewrite exp_Ropp. assert (A1 : eta M x v t / (D * mu * a) *
    a <= (e - t) * a) by (apply Rmult_le_compat_r; lra). replace (eta M x v t / (D * mu * a) * a) with (eta M x v t /
    (D
    * mu)) in A1 by (field; lra). set (y := exp (a * (e - t))) in *; assert (Y : eta M x v t / (D * mu) <= y) by lra.
  assert (Yp : 0 < y) by apply exp_pos. apply Rmult_le_reg_r with (D * y); [apply Rmult_lt_0_compat; lra|].
  replace (eta M x v t * / y / D * (D * y)) with (eta M x v t) by (field; lra). apply Rmult_le_reg_r with (/ (D *
    mu)); [apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra|]. replace (mu * (D * y) * / (D * mu)) with y by (field;
    lra); exact Y.
Qed.

Section Leg.
Variables (t V : R) (x v : R -> R) (z w : R).
Hypothesis Ht : lo <= t <= hi.
Hypothesis Hc : within M z w t V.
Hypothesis F : free (a + b) (a * b) x v.
Hypothesis X0 : x t = Q t.
Hypothesis V0 : v t = Q1 t - tau * V.
Hypothesis Open : 0 < al0 M - b ^ 2 * (z + (1 + tau) * w) / D.
Let Hab := overdamped _ _ _ H.
Let Htau := restitution _ _ _ H.
Let g s := x s - Q s.
Let g1 s := v s - Q1 s.
Let g2 s := - (a + b) * v s - a * b * x s - Q2 s.
Let Z := zet M x v.

Lemma Dg s : derivable_pt_lim g s (g1 s). Proof. apply D_minus; [apply (D_x M x v F)|apply (slope _ _ _ H)]. Qed.
Lemma Dg1 s : derivable_pt_lim g1 s (g2 s). Proof. apply D_minus; [apply (D_v M x v F)|apply (bend _ _ _ H)]. Qed.
Lemma Z_start : Z t = zeta M t V - (1 + tau) * V /\ - (1 + tau) * V <= Z t <= z + (1 + tau) * w /\ 0 <= Z t.
Proof.
  destruct Hc as (h1 & h2 & h3); unfold Z, zet, zeta in *; rewrite X0, V0; split; [ring|].
  assert (0 <= (1 + tau) * - V) by (apply Rmult_le_pos; lra). assert ((1 + tau) * - V <= (1 + tau) * w) by (apply
    Rmult_le_compat_l; lra); lra.
Qed.
Lemma Z_pos s : 0 <= Z s.
Proof. unfold Z; rewrite (zet_flow M x v F t s); apply Rmult_le_pos; [apply Z_start|left; apply exp_pos]. Qed.
Lemma eta_pos s : 0 <= eta M x v s.
Proof.
  rewrite (eta_flow M x v F t s); apply Rmult_le_pos; [|left; apply exp_pos]. rewrite (eta_zet M x v);
    destruct Hc as (h1 & _); rewrite X0; pose proof (Z_pos t); unfold Z in *. assert (0 <= D * Q t) by (apply
    Rmult_le_pos; lra); lra.
Qed.
Lemma x_pos s : t <= s -> 0 <= x s.
Proof.
  intros L; rewrite (x_flow' M Hab x v F t s), X0; destruct Hc as (h1 & _). apply Rplus_le_le_0_compat;
    apply Rmult_le_pos; trivial; [left; apply exp_pos|apply phi12_pos; trivial; lra|apply Z_pos].
Qed.
Lemma acc_low B s : Z s <= B -> - b ^ 2 * B / D <= - (a + b) * v s - a * b * x s.
Proof.
  intros HB; rewrite (acc_of M Hab x v); pose proof (eta_pos s); fold Z. assert (0 <= a ^ 2 * eta M x v s / D).
  { apply Rmult_le_pos; [apply Rmult_le_pos; [apply pow2_ge_0|trivial]|left; apply Rinv_0_lt_compat; lra]. }
  assert (b ^ 2 * Z s / D <= b ^ 2 * B / D); [|unfold Rdiv in *; lra]. apply Rmult_le_compat_r; [left;
    apply Rinv_0_lt_compat; lra|apply Rmult_le_compat_l; [apply pow2_ge_0|trivial]].
Qed.
Lemma Z_down s s' : s <= s' -> Z s' <= Z s.
Proof.
  intros L; unfold Z; rewrite (zet_flow M x v F s s'); fold (Z s); pose proof (Z_pos s).
  assert (exp (- b * (s' - s)) <= exp (- b * 0)) by (apply exp_down; lra); rewrite Rmult_0_r, exp_0 in *.
  rewrite <- (Rmult_1_r (Z s)) at 2; apply Rmult_le_compat_l; trivial.
Qed.
(** P1 *)
Lemma opening s : t <= s <= hi -> al0 M - b ^ 2 * (z + (1 + tau) * w) / D <= g2 s.
Proof.
  intros Hs; pose proof (acc_low (z + (1 + tau) * w) s) as A; pose proof (Z_down t s ltac:(lra));
    destruct Z_start as (_ & h & _). specialize (A ltac:(lra)); pose proof (bent _ _ _ H s ltac:(lra));
    unfold g2; unfold Rdiv in *; lra.
Qed.
Lemma open_after s : t < s < lo + p -> Q s < x s.
Proof.
  intros Hs; destruct (Rle_or_lt s hi) as [L|L].
  - pose proof (above_right g g1 g2 Dg Dg1 (al0 M - b ^ 2 * (z + (1 + tau) * w) / D) t s ltac:(lra) ltac:(intros;
      apply opening; lra)) as G. unfold g, g1 in G; rewrite X0, V0 in G; destruct Hc as (_ & h2 & _).
    assert (0 <= (- tau * V) * (s - t)) by (apply Rmult_le_pos; [nra|lra]). assert (0 < (al0 M - b ^ 2 * (z + (1 +
      tau) * w) / D) / 2 * (s - t) ^ 2) by (apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]); lra.
  - pose proof (below _ _ _ H s ltac:(lra)); pose proof (x_pos s ltac:(lra)); lra.
Qed.
Lemma next_exists : exists t' V', leg M t V t' V' x v.
Proof.
  destruct sizes as [w1 w2]; set (s0 := (hi + (lo + p)) / 2); assert (S0 : t < s0 < lo + p) by (unfold s0; lra).
  destruct (meets x v t s0 F (Z_pos t) (eta_pos t)) as (e & Le & Fall). destruct (first_zero g s0 e) as (t' & T1 & T2
    & T3); [intros y; eapply D_continuous, Dg|exact Le|pose proof (open_after s0 S0); unfold g; lra|exact Fall|].
  exists t', (v t' - Q1 t'); unfold g in *; repeat split; trivial; [apply F|apply F|lra| |lra].
  intros y Hy; destruct (Rle_or_lt s0 y) as [K|K]; [specialize (T3 y ltac:(lra)); lra|apply open_after; lra].
Qed.

(** *** The next contact *)
Section Next.
Variables t' V' : R.
Hypothesis N1 : t < t'.
Hypothesis N2 : forall s, t < s < t' -> Q s < x s.
Hypothesis N3 : x t' = Q t'.
Hypothesis N4 : V' = v t' - Q1 t'.
Lemma later : lo + p <= t'. Proof. apply Rnot_lt_le; intros L; pose proof (open_after t' ltac:(lra)); lra. Qed.
Lemma next_pass : exists n, (1 <= n)%Z /\ in_pass M lo hi n t'.
Proof.
  destruct (pass_of t') as (n & Hn); [rewrite <- N3; apply x_pos; lra|]; exists n; split; trivial.
  destruct (Z_le_gt_dec 1 n) as [|G]; trivial; exfalso; pose proof later. assert (IZR n <= 0) by (apply (IZR_le n 0);
    lia); destruct sizes as [w1 w2]; destruct Hn as [_ Hn]. assert (p * IZR n <= 0) by nra; lra.
Qed.
Lemma speed_sign : V' <= 0.
Proof. rewrite N4; apply (slope_at g _ t' t (Dg t') N1); [intros y Hy; specialize (N2 y Hy)|]; unfold g; lra.
  Qed.
Lemma speed_zeta : zeta M t' V' = Z t'. Proof. unfold zeta, Z, zet; rewrite N3, N4; ring. Qed.
(** P2 *)
Lemma kick_bound : phi12 M (t' - t) * Z t <= mu.
Proof.
  pose proof (highest _ _ _ H t'); rewrite <- N3, (x_flow' M Hab x v F t t'), X0 in *; destruct Hc as (h1 & _).
  assert (0 <= exp (- a * (t' - t)) * Q t) by (apply Rmult_le_pos; [left; apply exp_pos|trivial]); unfold Z; lra.
Qed.
Lemma next_zeta : 0 <= zeta M t' V' <= least_slip M.
Proof.
  rewrite speed_zeta; split; [apply Z_pos|]; pose proof kick_bound as K; pose proof later;
    destruct sizes as [w1 w2]. unfold Z in *; rewrite (zet_flow M x v F t t'); fold (Z t) in *; unfold least_slip.
  assert (E1 : 1 < exp (D * (p - W))) by (rewrite <- exp_0; apply exp_increasing; apply Rmult_lt_0_compat;
    lra). assert (E2 : exp (D * (p - W)) <= exp (D * (t' - t))).
  { pose proof (exp_down D (- (t' - t)) (- (p - W)) ltac:(lra) ltac:(lra)) as X. replace (- D * - (p - W)) with (D *
      (p - W)) in X by ring; replace (- D * - (t' - t)) with (D * (t' - t)) in X by ring. exact X. }
  unfold phi12 in K; replace (- a * (t' - t)) with (- b * (t' - t) + D * (t' - t)) in K by ring.
  rewrite exp_plus in K; set (q := exp (- b * (t' - t))) in *; set (r := exp (D * (t' - t))) in *;
    set (r0 := exp (D * (p - W))) in *. assert (Qp : 0 < q) by apply exp_pos; pose proof (Z_pos t) as Zp.
  apply Rmult_le_reg_r with (r0 - 1); [lra|]; replace (mu * D / (r0 - 1) * (r0 - 1)) with (mu * D) by (field;
    lra). assert (K' : (q * r - q) / D * Z t * D <= mu
    * D) by (apply Rmult_le_compat_r; lra). replace ((q * r - q) / D * Z t * D) with (Z t * q * (r - 1)) in K' by
    (field; lra). assert (Z t * q * (r0 - 1) <= Z t * q * (r - 1)); [|lra]. apply Rmult_le_compat_l;
      [apply Rmult_le_pos; lra|lra].
Qed.
(** P3 *)
Lemma after_one : in_pass M lo hi 1 t' -> 0 < ell M 1 /\ - V1 M <= V.
Proof.
  intros Hp; pose proof kick_bound as K; destruct sizes as [w1 w2]; destruct Hp as [p1 p2];
    rewrite Rmult_1_r in *. pose proof (phi12_between M Hab (p * 1 - W) (p * 1 + W) (t' - t) ltac:(lra)) as B;
    fold (ell M 1) in B. assert (Strict : forall T, 0 < T -> 0 < phi12 M T).
  { intros T HT; apply Rdiv_lt_0_compat; [|lra]; assert (exp (- b * T) < exp (- a * T));
      [apply exp_increasing; nra|lra]. }
  assert (L : 0 < ell M 1) by (unfold ell, Rmin; destruct Rle_dec; apply Strict; lra). split; trivial;
    destruct Z_start as (_ & [h1 _] & h2); unfold V1. assert (ell M 1 * Z t <= phi12 M (t' - t) * Z t) by (apply
    Rmult_le_compat_r; lra). assert (ell M 1 * (- (1 + tau) * V) <= ell M 1 * Z t) by (apply Rmult_le_compat_l;
    lra). assert (- V <= mu / ((1 + tau) * ell M 1)); [|lra]. apply Rmult_le_reg_r with ((1 + tau) * ell M 1);
    [apply Rmult_lt_0_compat; lra|]. replace (mu / ((1 + tau) * ell M 1) * ((1 + tau) * ell M 1)) with mu by (field;
    lra); lra.
Qed.
(** P4 *)
Hypothesis Hz : zeta M t V <= zm M.
Hypothesis Hb : 0 < alb M /\ least_slip M <= zm M /\ least_speed M <= Vm M.
Lemma lam : 0 < exp (- a * p) <= 1.
Proof.
  split; [apply exp_pos|]; rewrite <- exp_0; destruct sizes as [w1 w2]. left; apply exp_increasing;
    assert (0 < a * p) by (apply Rmult_lt_0_compat; lra); lra.
Qed.
Lemma deep_pos : (1 - exp (- a * p)) * mu <= deep M.
Proof.
  unfold deep; assert (0 <= exp (- a * p) * (tau ^ 2 * V1 M ^ 2 / (2 * alb M))); [|lra]. apply Rmult_le_pos;
    [left; apply exp_pos|]; apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat; lra]. apply Rmult_le_pos;
    apply pow2_ge_0.
Qed.
Lemma period_back s : exp (- a * p) * x (s - p) <= x s.
Proof.
  rewrite (x_flow' M Hab x v F (s - p) s); replace (s - (s - p)) with p by ring; pose proof (Z_pos (s - p));
    unfold Z in *. assert (0 <= phi12 M p * zet M x v (s - p)); [|lra]; destruct sizes as [w1 w2].
  apply Rmult_le_pos; [apply phi12_pos; trivial; lra|trivial].
Qed.
Lemma backward q : - V1 M <= V -> lo <= q <= t -> - (tau ^ 2 * V1 M ^ 2 / (2 * alb M)) <= g q.
Proof.
  intros HV Hq; destruct sizes as [w1 w2]; destruct Hc as (_ & h2 & _). assert (A : forall y, q <= y <= t -> alb M <=
    g2 y).
  { intros y Hy; pose proof (acc_low (exp (b * W) * (zm M + (1 + tau) * V1 M)) y) as A.
    pose proof (bent _ _ _ H y ltac:(lra)); unfold g2, alb; unfold Rdiv in *. assert (B : Z y <= exp (b * W) * (zm M +
      (1 + tau) * V1 M)); [|specialize (A B); lra]. unfold Z; rewrite (zet_flow M x v F t y); fold (Z t);
      rewrite Rmult_comm; destruct Z_start as (E & _ & P). apply Rmult_le_compat; [left; apply exp_pos|trivial| |].
    - destruct (Req_dec (- b * (y - t)) (b * W)) as [->|Ne]; [lra|left; apply exp_increasing].
      assert (b * (t - y) <= b * W) by (apply Rmult_le_compat_l; lra); lra.
    - rewrite E; assert ((1 + tau) * - V <= (1 + tau) * V1 M) by (apply Rmult_le_compat_l; lra); lra. }
  pose proof (above_left g g1 g2 Dg Dg1 (alb M) t q ltac:(lra) A) as G; unfold g at 1, g1 in G;
    rewrite X0, V0 in G. set (y := t - q) in *; replace (q - t) with (- y) in G by (unfold y; ring).
  assert (S : V ^ 2 <= V1 M ^ 2) by nra. assert (T2 : tau ^ 2 * V ^ 2 <= tau ^ 2 * V1 M ^ 2) by (apply
    Rmult_le_compat_l; [apply pow2_ge_0|trivial]). apply Rle_trans with (- (tau ^ 2 * V ^ 2 / (2 * alb M))).
  { apply Ropp_le_contravar, Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|trivial]. }
  apply Rle_trans with (tau * V * y + alb M / 2 * y ^ 2); [|nra]. apply Rmult_le_reg_r with (2 * alb M);
    [lra|]. replace (- (tau ^ 2 * V ^ 2 / (2 * alb M)) * (2 * alb M)) with (- (tau ^ 2 * V ^ 2)) by (field; lra).
  pose proof (pow2_ge_0 (alb M * y + tau * V)); nra.
Qed.
Lemma depth n s : (1 <= n)%Z -> in_pass M lo hi n t' -> in_pass M lo hi n s -> t' <= s -> - deep M <= g s.
Proof.
  intros Hn Pt Ps L; pose proof (period_back s) as B; pose proof deep_pos as DP; pose proof lam as La.
  pose proof (highest _ _ _ H s) as Hh; destruct sizes as [w1 w2]. assert (Eq : Q (s - p) = Q s) by (rewrite <-
    (period _ _ _ H (s - p)); f_equal; ring). assert (P1 : (exp (- a * p) - 1) * Q s >= (exp (- a * p) - 1) * mu) by
    nra. assert (Before : s - p < t').
  { apply (pass_order (n - 1) n); trivial; [|lia]; unfold in_pass in *; rewrite minus_IZR; lra. }
  destruct (Rle_or_lt t (s - p)) as [T|T].
  - assert (Q (s - p) <= x (s - p)). { destruct (Req_dec t (s - p)) as [<-|Ne]; [lra|left; apply N2; lra].
    } rewrite Eq in *; unfold g; assert (exp (- a * p) * Q s <= exp (- a * p) * x (s - p)) by (apply
      Rmult_le_compat_l; lra). lra.
  - destruct (Z.eq_dec n 1) as [->|Ne].
    + destruct (after_one Pt) as [_ HV]; unfold in_pass in *. pose proof (backward (s - p) HV ltac:(lra)) as G;
        unfold g in *; rewrite Eq in G; unfold deep. set (c := tau ^ 2 * V1 M ^ 2 / (2 * alb M)) in *.
      assert (exp (- a * p)
        * (Q s - c) <= exp (- a * p) * x (s - p)) by (apply Rmult_le_compat_l; lra); lra.
    + exfalso; unfold in_pass in *; assert (2 <= IZR n) by (apply (IZR_le 2); lia).
      assert (p * 2 <= p * IZR n) by (apply Rmult_le_compat_l; lra); lra.
Qed.
(** P5 *)
Lemma next_speed n : (1 <= n)%Z -> in_pass M lo hi n t' -> - Vm M <= V'.
Proof.
  intros Hn Pt; pose proof speed_sign as Sg; pose proof (sqrt_pos (2 * alM M * deep M)) as Rp; fold (least_speed M) in
    Rp; destruct (Req_dec V' 0) as [->|NV]; [lra|]. pose proof next_zeta as NZ; rewrite speed_zeta in NZ; destruct
      (dive n t' V' (zm M) x v Pt F N3 N4 ltac:(rewrite <- N3; apply x_pos; lra) ltac:(unfold Z in NZ; lra)
    ltac:(lra)) as (AM & s & Ps & Ls & Gs); fold (alM M) in AM, Gs; pose proof (depth n s Hn Pt Ps Ls) as Dp; unfold g
    in Dp.
  assert (S : V' ^ 2 <= 2 * alM M * deep M).
  { apply Rmult_le_reg_r with (/ (2 * alM M)); [apply Rinv_0_lt_compat; lra|]. replace (2 * alM M * deep M * / (2 *
      alM M)) with (deep M) by (field; lra); unfold Rdiv in *; lra. }
  apply sqrt_le_1_alt in S; fold (least_speed M) in S; replace (V' ^ 2) with ((- V') ^ 2) in S by ring; rewrite
    sqrt_pow2 in S by lra; lra.
Qed.
End Next.
End Leg.
End Stop.
