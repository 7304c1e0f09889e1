(** (iv) for every periodic motion in D, without a word on its first contact. *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Derivatives StatementOscillator.
From Grazing Require Import StatementTrapped TrappedCalculus TrappedFlow TrappedReturn TrappedMain
  TrappedSeparate TrappedUnstable TrappedExists TrappedPeriodic.
Open Scope R_scope.

Section All.
Variables (M : machine) (lo hi : R).
Hypothesis H : hump M lo hi.
Hypothesis Hb : 0 < alb M /\ least_slip M <= zm M /\ least_speed M <= Vm M.
Hypothesis Ho : 0 < alo M.
Notation a := (a M). Notation b := (b M). Notation tau := (tau M). Notation p := (p M). Notation W := (W M).
Notation mu := (mu M). Notation Q := (Q M). Notation Q1 := (Q1 M). Notation Q2 := (Q2 M).
Notation D := (StatementTrapped.b M - StatementTrapped.a M).

Lemma no_level t : Q t = 0 -> Q1 t <> 0.
Proof.
  intros Z0 Z1; destruct (parabola M lo hi H t ltac:(lra)) as (s & Es & G), (positives M lo hi H) as [hmu hal].
  assert (0 <= al0 M / 2 * (s - t) ^ 2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]); rewrite Z0, Z1, Es in G; lra.
Qed.

Lemma Q_start : Q lo <= 0.
Proof.
  destruct (sizes M _ _ H) as [w1 w2]; apply Rnot_lt_le; intros L. destruct (continuous_near Q lo (Q lo / 2)) as (d &
    Hd & B); [eapply D_continuous, (slope _ _ _ H)|lra|]. set (y := lo - Rmin d ((lo + p - hi) / 2)).
  assert (Y : hi - p < y < lo /\ lo - d <= y) by (unfold y, Rmin; destruct Rle_dec; lra).
  specialize (B y ltac:(apply Rabs_le; lra)); apply le_abs in B; pose proof (below _ _ _ H (y + p) ltac:(lra)) as N.
  rewrite (period _ _ _ H) in N; lra.
Qed.

(** zeta < least_slip where there is a contact before. *)
Lemma zeta_less k n t V t' V' x v : in_pass M lo hi k t -> in_pass M lo hi (k + n) t' -> (1 <= n)%Z ->
  trapped M t V ->
  leg M t V t' V' x v -> zeta M t' V' < zm M.
Proof.
  intros Hk Hk' Hn Tr [F X0 V0 N1 N2 N3 N4]; pose proof (overdamped _ _ _ H) as Hab; pose proof (hump_shift M lo hi H
    k) as Hs. destruct (sizes M _ _ H) as [w1 w2]; destruct (positives M _ _ H) as [hmu hal].
  pose proof (kick_bound M _ _ Hs t V x v (zm M) (Vm M) Tr F X0) as K. pose proof (Z_pos M _ _ Hs t V x v (zm M) (Vm
    M) Tr F X0 V0 t) as Zp. rewrite (speed_zeta M x v t' V' N3 N4), (zet_flow M x v F t t').
  pose proof (apart_pass M lo hi H k n t t' Hk Hk') as Ap; assert (1 <= IZR n) by (apply (IZR_le 1); lia).
  assert (p * 1 <= p * IZR n) by (apply Rmult_le_compat_l; lra). set (z := zet M x v t) in *;
    set (T := t' - t) in *; set (q := exp (- b * T)). set (r0 := exp (D * (p - W))); set (r := exp (D * T));
    assert (q0 : 0 < q) by apply exp_pos. assert (r1 : 1 < r0) by (unfold r0; rewrite <- exp_0;
    apply exp_increasing; apply Rmult_lt_0_compat; lra). specialize (K t' N3); fold T in K. apply Rlt_le_trans with
      (least_slip M); [|lra]; unfold least_slip; fold r0;
    apply Rmult_lt_reg_r with (r0 - 1); [lra|]. replace (mu * D / (r0 - 1) * (r0 - 1)) with (mu * D) by (field;
    lra). destruct (Req_dec z 0) as [->|Nz]; [assert (0 < mu * D) by (apply Rmult_lt_0_compat; lra); lra|].
  assert (zq : 0 < z * q) by (apply Rmult_lt_0_compat; lra). assert (Kx : z * q * (r - 1) <= mu * D).
  { replace (z * q * (r - 1)) with (phi12 M T * z * D); [apply Rmult_le_compat_r; lra|]. unfold phi12;
      replace (- a * T) with (- b * T + D * T) by ring; rewrite exp_plus; fold q r; field; lra. }
  destruct (Req_dec T (p - W)) as [ET|NT].
  - exfalso; unfold in_pass in *; rewrite plus_IZR in *; assert (Eh : t' = lo + p * IZR (k + n)) by (rewrite plus_IZR;
      unfold T in *; lra). pose proof Q_start as Qs; rewrite <- (Q_whole M lo hi H (k + n) lo), <- Eh, <- N3, (x_flow'
      M Hab x v F t t') in Qs; fold T z in Qs. destruct Tr as (h1 & _); rewrite X0 in Qs;
      assert (0 <= exp (- a * T) * Q t) by (apply Rmult_le_pos; [left; apply exp_pos|trivial]).
    assert (0 < phi12 M T * z) by (apply Rmult_lt_0_compat; [apply (phi12_strict M lo hi H); lra|lra]); lra.
  - assert (r0 < r) by (apply exp_increasing, Rmult_lt_compat_l; lra). assert (z * q * (r0 - 1) < z * q * (r - 1)) by
      (apply Rmult_lt_compat_l; lra); lra.
Qed.

Lemma some_impact K P N t V x v : (1 <= K)%nat -> motion M lo hi N t V x v -> (forall i, trapped M (t i) (V
  i)) ->
  periodic M K P N t V -> exists i, V (S i) < 0.
Proof.
  intros HK HM Tr Per; apply Classical_Prop.NNPP; intros No. assert (Z : forall i, V (S i) = 0).
  { intros i; destruct (Tr (S i)) as (_ & h & _); destruct (Rlt_or_le (V (S i)) 0); [exfalso; apply No;
      exists i; trivial|lra]. }
  assert (Same : forall j s, x (1 + j)%nat s = x 1%nat s /\ v (1 + j)%nat s = v 1%nat s).
  { induction j as [|j IH]; intros s; [split; reflexivity|]. destruct (HM (1 + j)%nat) as [_ Leg];
      rewrite (Z (1 + j)%nat) in Leg. pose proof (leaving M lo hi N t V x v HM (S (1 + j))) as Lv;
      rewrite (Z (1 + j)%nat) in Lv. destruct (graze M lo hi H _ _ _ _ _ _ _ s Leg Lv) as [g1 g2];
      destruct (IH s) as [i1 i2]. replace (1 + S j)%nat with (S (1 + j)) by lia; rewrite g1, g2; split; trivial. }
  destruct (Per 1%nat) as (EN & Et & EV); destruct (Same K (t (1 + K)%nat)) as [sx sv].
  destruct (HM 1%nat) as [P1 [F X0 V0 _ _ _ _]]; destruct (HM (1 + K)%nat) as [PK [F' X0' V0' _ _ _ _]].
  rewrite sx in X0'; rewrite sv in V0'; rewrite EV in V0'; rewrite (Z 0%nat) in V0, V0'.
  assert (Lt : t 1%nat < t (1 + K)%nat).
  { assert (forall j, t 1%nat <= t (1 + j)%nat).
    { induction j as [|j IH]; [cbn; lra|]; destruct (HM (1 + j)%nat) as [_ [_ _ _ L _ _ _]].
      replace (1 + S j)%nat with (S (1 + j)) by lia; lra. }
    destruct K as [|K']; [lia|]; specialize (H0 K'); destruct (HM (1 + K')%nat) as [_ [_ _ _ L _ _ _]].
    replace (1 + S K')%nat with (S (1 + K')) by lia; lra. }
  assert (eQ : Q (t (1 + K)%nat) = Q (t 1%nat)) by (rewrite Et; apply (Q_whole M lo hi H)).
  assert (eQ1 : Q1 (t (1 + K)%nat) = Q1 (t 1%nat)) by (rewrite Et; apply (whole Q1 p (periodic_slope Q Q1 p (period _
    _ _ H) (slope _ _ _ H)))). pose proof (overdamped _ _ _ H) as Hab. pose proof (zet_flow M _ _ F (t 1%nat) (t (1 +
    K)%nat)) as fz; pose proof (eta_flow M _ _ F (t 1%nat) (t (1
    + K)%nat)) as fe.
  assert (Dec : forall c, 0 < c -> exp (- c * (t (1 + K)%nat - t 1%nat)) < 1).
  { intros c Hc; rewrite <- exp_0; apply exp_increasing; assert (0 < c * (t (1 + K)%nat - t 1%nat)) by (apply
      Rmult_lt_0_compat; lra); lra. }
  unfold zet, eta in fz, fe; rewrite X0, X0', V0, V0', eQ, eQ1 in fz, fe. assert (z0 : a * Q (t 1%nat) + Q1 (t 1%nat)
    = 0).
  { pose proof (Dec b ltac:(lra)); apply Rmult_eq_reg_r with (1 - exp (- b * (t (1 + K)%nat - t 1%nat))); lra.
    }
  assert (e0 : b * Q (t 1%nat) + Q1 (t 1%nat) = 0).
  { pose proof (Dec a ltac:(lra)); apply Rmult_eq_reg_r with (1 - exp (- a * (t (1 + K)%nat - t 1%nat))); lra.
    }
  assert (Q0 : Q (t 1%nat) = 0) by (apply Rmult_eq_reg_l with D; lra). apply (no_level _ Q0); rewrite Q0 in z0; lra.
Qed.
End All.

Theorem No_stable : No_stable_statement.
Proof.
  intros M lo hi E Ch Ht K P N t V x v HK [HM Tr] Per; pose proof Ch as [[H Hb Ho] _ _].
  destruct (some_impact M lo hi H K P N t V x v HK HM Tr Per) as (i & Neg). destruct (HM i) as [Pi Leg];
    destruct (return_trapped M lo hi H Hb Ho _ _ _ _ _ _ _ Pi (Tr i) Leg) as (_ & n & Hn & Pn).
  pose proof (zeta_less M lo hi H Hb _ _ _ _ _ _ _ _ Pi Pn Hn (Tr i) Leg) as Zs; set (m := S i) in *.
  destruct (periodic_departs M lo hi E K P (fun j => N (j + m)%nat) (fun j => t (j
    + m)%nat) (fun j => V (j + m)%nat) (fun j => x (j + m)%nat) (fun j => v (j + m)%nat) Ch Ht HK) as (eps & e0 & U).
  - split; [intros j; apply (HM (j + m)%nat)|intros j; apply Tr].
  - intros j; replace (j + K + m)%nat with (j + m + K)%nat by lia; apply Per.
  - exact Neg.
  - exact Zs.
  - exists m, eps; split; trivial; intros d Hd. destruct (U d Hd) as (N' & t' & V' & x' & v' & h1 & h2 & h3 & j & l &
      s & h4). exists N', t', V', x', v'; split; trivial; split; trivial; split; trivial;
      exists (j + m)%nat, l, s; exact h4.
Qed.
