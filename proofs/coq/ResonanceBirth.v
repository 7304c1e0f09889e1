(** * Which motion with one impact in n periods is born where the stop touches *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOscillator StatementResonance Finite Derivatives Flow OscillatorStop.
From Grazing Require Import ResonanceHop ResonanceExact ResonanceTop ResonanceSigns.
Open Scope R_scope.

Section Birth.
Variables (O : Oscillator.t) (n m : nat).
Hypothesis HO : touching O.
Hypothesis HR : resonant O n m.
Notation c := (Oscillator.c O).
Notation k := (Oscillator.k O).
Notation tau := (Oscillator.tau O).
Notation q := (q O n m).
Notation T := (2 * PI * INR n).
Notation S := (S O).
Notation V := (V O).
Let HS := is_flow O n m HR.
Let HA := is_any_stop O HO.

(** The free motion from the stop at the touch, a whole number of periods later. *)
Lemma S_turns j : exists b, 0 < b /\ S (2 * PI * INR j) = b * sin (PI * (INR j * INR m / INR n)).
Proof.
  pose proof (omega_pos O n m HR) as P; exists (exp (- c / 2 * (2 * PI * INR j)) * / omega O); split.
  { apply Rmult_lt_0_compat; [apply exp_pos | apply Rinv_0_lt_compat, P]. }
  assert (0 < INR n) by (apply lt_0_INR; pose proof (res_periods _ _ _ HR); lia).
  assert (E : omega O * (2 * PI * INR j) = PI * (INR j * INR m / INR n)).
  { apply (Rmult_eq_reg_r (INR n)); [|lra]; pose proof (res_angle _ _ _ HR) as E.
    transitivity (INR j * (INR n * (2 * PI * omega O))); [ring | rewrite E; field; lra]. }
  unfold ResonanceExact.S, damped_S; rewrite E; ring.
Qed.
Lemma S_near j l : 0 < l * S (2 * PI * INR j) ->
  exists d, 0 < d /\ forall x, Rabs (x - 2 * PI * INR j) <= d -> d <= l * S x.
Proof.
  intros H; set (s := l * S (2 * PI * INR j)) in *.
  destruct (continuous_near (fun x => l * S x) (2 * PI * INR j) (s / 2)) as (d & Hd & C); [|lra|].
  { apply (D_continuous _ (l * V (2 * PI * INR j))), D_scale, (D_S c k S V HS). }
  destruct (two_least d (s / 2) Hd ltac:(lra)) as (d' & Hd' & L1 & L2); exists d'; split; [exact Hd'|]; intros x Hx.
  specialize (C x ltac:(lra)); fold s in C; apply le_abs in C; lra.
Qed.

(** The arc is clear of the stop. *)
Section Clear.
Variables (a r g d e nu kap C : R).
Hypothesis Hr : 0 < d <= r.
Hypothesis Hr1 : r <= 1 /\ 2 * r <= kap.
Hypothesis Ha : 0 < a.
Hypothesis Hnu : 0 < nu.
Hypothesis Hkap : forall j x, (0 < j < n)%nat -> Rabs (x - 2 * PI * INR j) <= kap -> kap <= S x.
Hypothesis HC : forall x, Rabs x <= T + 1 -> Rabs (S x) <= C /\ Rabs (- c * V x - k * S x) <= C.
Hypothesis HT : shaped O a r g d e nu.
Notation Q := (stop O (- nu)).
Notation Q1 := (stop1 O (- nu)).
Variables t0 w : R.
Hypothesis Ht0 : - d <= t0 < 0.
Hypothesis Z0 : Q t0 = 0.
Hypothesis Hw : 0 < w /\ C * w < a /\ C * w < g.
Hypothesis Hw2 : 2 * nu < kap * w.
Hypothesis Hout : Q1 t0 <= w.
Hypothesis Hin : q * w <= Q1 t0.

Let gap x := S x * w - Q (t0 + x).
Let gap1 x := V x * w - Q1 (t0 + x).
Let gap2 x := (- c * V x - k * S x) * w + Oscillator.G2 O (- nu) (t0 + x).
Lemma D_gap1 x : derivable_pt_lim gap x (gap1 x).
Proof. unfold gap, gap1; derive_by ltac:(first [apply (D_S c k S V HS) | apply D_on, (D_stop O HO)]); ring. Qed.
Lemma D_gap2 x : derivable_pt_lim gap1 x (gap2 x).
Proof.
  apply (D_ext (fun x => V x * w + Oscillator.G1 O (- nu) (t0 + x)) _ x (gap2 x)); [|intros; unfold gap1, stop1;
    ring | reflexivity].
  unfold gap2; derive_by ltac:(first [apply (D_V c k S V HS) | apply D_on, (bend _ HO)]); ring.
Qed.
Lemma bent x z : Rabs x <= T + 1 -> Rabs (t0 + x - 2 * PI * IZR z) <= r -> 0 < gap2 x.
Proof.
  intros Hx Hz; destruct (HC x Hx) as [_ B]; pose proof (shaped_bent _ _ _ _ _ _ _ HT _ Hz) as P.
  assert (E : Oscillator.G2 O (- nu) (t0 + x - 2 * PI * IZR z) = Oscillator.G2 O (- nu) (t0 + x)).
  { rewrite <- (whole_periods (Oscillator.G2 O (- nu)) z (t0 + x - 2 * PI * IZR z)); [f_equal; ring|].
    apply (periodic_slope (Oscillator.G1 O (- nu))); [|apply (bend _ HO)].
    apply (periodic_slope (Oscillator.G O (- nu))); [apply (period _ HO) | apply (slope _ HO)]. }
  rewrite E in P; unfold gap2; assert (Rabs ((- c * V x - k * S x) * w) <= C * w).
  { rewrite Rabs_mult, (Rabs_pos_eq w) by lra; apply Rmult_le_compat_r; lra. } pose proof (le_abs _ _ H); lra.
Qed.
Lemma clear x : 0 < x < T -> Q (t0 + x) < S x * w.
Proof.
  intros Hx; pose proof PI2_3_2 as HP; assert (N1 : 1 <= INR n) by (apply (le_INR 1), (res_periods _ _ _ HR)).
  assert (HT6 : 6 <= T) by nra; cut (0 < gap x); [unfold gap; lra|].
  destruct (nearest (t0 + x)) as [z Hz]; set (p := t0 + x - 2 * PI * IZR z) in *. assert (EQ : Q (t0 + x) = Q p).
  { destruct (stop_later O (- nu) HA z p) as [E _]; rewrite <- E; f_equal; unfold p; ring. }
  destruct (Rle_lt_dec r (Rabs p)) as [L|L].
  - pose proof (shaped_away _ _ _ _ _ _ _ HT p (conj L Hz)); destruct (HC x) as [B _]; [apply Rabs_le; lra|].
    assert (B' : Rabs (S x * w) <= C * w) by (rewrite Rabs_mult, (Rabs_pos_eq w) by lra; apply Rmult_le_compat_r;
      lra). apply le_abs in B'; unfold gap; rewrite EQ; lra.
  - assert (Lp : - r <= p <= r) by (apply le_abs; lra); unfold p in Lp; set (P := 2 * PI) in *.
    assert (HPP : 6 <= P) by (unfold P; lra). assert (Zr : (0 <= z <= Z.of_nat n)%Z).
    { split; apply Z.lt_succ_r; apply lt_IZR; rewrite succ_IZR, <- ?INR_IZR_INZ; apply Rnot_le_lt; intros Y.
      - assert (P * IZR z <= P * -1) by (apply Rmult_le_compat_l; lra); lra.
      - assert (P * 1 <= P * (IZR z - INR n)) by (apply Rmult_le_compat_l; lra); lra. }
    destruct (Z.eq_dec z 0) as [->|Z1]; [|destruct (Z.eq_dec z (Z.of_nat n)) as [->|Z2]].
    + rewrite Rmult_0_r in *; apply (convex_right gap gap1 gap2 D_gap1 D_gap2 0 (r - t0)); [| | |lra].
      * unfold gap; rewrite (flow_S _ _ _ _ HS), Rplus_0_r, Z0; lra.
      * unfold gap1; rewrite (flow_V _ _ _ _ HS), Rplus_0_r; lra.
      * intros y Hy; apply (bent y 0); [apply Rabs_le; unfold P in *; lra|]; rewrite Rmult_0_r, Rminus_0_r;
        apply Rabs_le; lra.
    + unfold P in *; clear P; rewrite <- INR_IZR_INZ in Lp; destruct (flow_turned O n m HR 0) as [ES EV].
      destruct (turn_1 O n (- nu) HA t0) as [FQ FQ1]; rewrite Rplus_0_r, (flow_S _ _ _ _ HS) in ES.
      rewrite Rplus_0_r, (flow_V _ _ _ _ HS) in EV.
      apply (convex_left gap gap1 gap2 D_gap1 D_gap2 (T - r - t0) T); [| | |lra].
      * unfold gap; rewrite ES, FQ, Z0; lra.
      * unfold gap1; rewrite EV, FQ1, Rmult_1_r; lra.
      * intros y Hy; apply (bent y (Z.of_nat n)); [apply Rabs_le; lra|]; rewrite <- INR_IZR_INZ. apply Rabs_le; lra.
    + assert (Hj : (0 < Z.to_nat z < n)%nat) by lia; specialize (Hkap (Z.to_nat z) x Hj).
      rewrite INR_IZR_INZ, Z2Nat.id in Hkap by lia; specialize (Hkap ltac:(fold P; apply Rabs_le; lra)).
      pose proof (shaped_top _ _ _ _ _ _ _ HT p ltac:(lra)); assert (kap * w <= S x * w) by (apply Rmult_le_compat_r;
        lra). unfold gap; rewrite EQ; lra.
Qed.
End Clear.

(** One that exists has its impact at the rising zero of the stop, up to whole periods. *)
Section Given.
Variables (a r g d e nu : R).
Hypothesis Hr : 0 < d <= r.
Hypothesis Ha : 0 < a.
Hypothesis Hnu : 0 < nu.
Hypothesis HT : shaped O a r g d e nu.
Notation Q := (stop O (- nu)).
Notation Q1 := (stop1 O (- nu)).
Lemma not_regular : ~ regular O n m -> forall h t y v, ~ once O n (- nu) h t y v.
Proof.
  intros N h t y v H; pose proof (exact_at O n m HA HR (- nu) h) as E.
  destruct (Req_dec q 1) as [Q'|Q']; [exact (exact_even _ _ _ _ _ E Q' t y v H)|].
  destruct (Req_dec (tau * q) (-1)) as [Q''|Q'']; [|apply N; split; assumption].
  destruct (exact_odd _ _ _ _ _ E Q'' t y v H) as [Z Z1]; destruct (nearest (t 0%Z)) as [z Hz].
  destruct (stop_later O (- nu) HA z (t 0%Z - 2 * PI * IZR z)) as [F F1].
  replace (t 0%Z - 2 * PI * IZR z + 2 * PI * IZR z) with (t 0%Z) in F, F1 by ring; rewrite F in Z; rewrite F1 in Z1.
  destruct (zero_is O HO a r g d e nu Ha Hr Hnu HT _ Hz Z) as [_ [(_ & B & _)|(_ & B)]]; rewrite Z1 in B; lra.
Qed.
Lemma given h t y v : regular O n m -> once O n (- nu) h t y v -> exists s w, - d <= s < 0 /\ 0 < w /\
  Q s = 0 /\ forall x, 0 < x < T -> Q (s + x) < S x * w.
Proof.
  intros [N1 N2] H; destruct (once_hop O n m HA HR (- nu) h t y v H) as (A & _ & _).
  pose proof (res_law _ _ _ HR) as L; pose proof (q_range O n m HR) as [B _]; pose proof (flow_turned O n m HR) as Hq.
  pose proof (tau_q O n m HR (conj N1 N2)) as [B1 B2]; pose proof (period_pos O n m HR) as TP.
  destruct (proj1 (hop_again c k S V HS Q Q1 T q tau TP Hq _ _ L B N1 N2) A) as (Z & P & W & C).
  destruct (nearest (t 0%Z)) as [z Hz]; set (s := t 0%Z - 2 * PI * IZR z) in *.
  assert (F : forall x, Q (t 0%Z + x) = Q (s + x) /\ Q1 (t 0%Z + x) = Q1 (s + x)).
  { intros x; destruct (stop_later O (- nu) HA z (s + x)) as [<- <-]; split; f_equal; unfold s; ring. }
  destruct (F 0) as [F0 F1]; rewrite !Rplus_0_r in F0, F1; rewrite F0 in Z; rewrite F1 in P, W.
  exists s, (v 0%Z (t 0%Z)); destruct (zero_is O HO a r g d e nu Ha Hr Hnu HT s Hz Z) as [D [(D1 & _)|(_ & D1)]];
    [|lra]. split; [lra|]; split; [|split; [exact Z|]].
  - rewrite W; apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat|]; lra.
  - intros x Hx; rewrite <- (proj1 (F x)); apply C, Hx.
Qed.
End Given.

Lemma not_before nu : (forall t, stop O nu t < 0) -> forall h t y v, ~ once O n nu h t y v.
Proof.
  intros B h t y v H; pose proof (exact_at O n m HA HR nu h) as E; specialize (B (t 0%Z)).
  destruct (Req_dec q 1) as [N1|N1]; [exact (exact_even _ _ _ _ _ E N1 t y v H)|].
  destruct (Req_dec (tau * q) (-1)) as [N2|N2]; [destruct (exact_odd _ _ _ _ _ E N2 t y v H); lra|].
  destruct (proj1 (exact_iff _ _ _ _ _ E (conj N1 N2) (t 0%Z))) as (_ & Z & _); [exists t, y, v; auto | lra].
Qed.

Theorem born eps : 0 < eps -> exists mu0, 0 < mu0 /\ forall nu, 0 < nu < mu0 -> birth O n m nu eps.
Proof.
  intros He; pose proof PI2_3_2 as HP; pose proof (res_periods _ _ _ HR) as Hn; pose proof (period_pos O n m HR) as TP.
  pose proof (res_law _ _ _ HR) as L; pose proof (flow_turned O n m HR) as Hq.
  destruct (shapes O HO) as (a & r0 & Ha & Hr0 & Sh), (signs n m Hn) as [Pos Neg].
  (* how far from its value at a pass the free motion keeps its sign *)
  assert (Kap : exists kap, 0 < kap /\ ((m mod (2 * n) = 1)%nat -> forall j x, (0 < j < n)%nat -> Rabs (x - 2 * PI * INR
    j) <= kap -> kap <= S x) /\ ((2 <= n)%nat -> (m mod (2 * n) <> 1)%nat -> S (2 * PI) = 0 \/ exists j, (0 < j < n)%nat
    /\ forall x, Rabs (x - 2 * PI * INR j) <= kap -> S x < 0)).
  { destruct (common_bound (fun j d => (m mod (2 * n) = 1)%nat -> (0 < j)%nat ->
    forall x, Rabs (x - 2 * PI * INR j) <= d -> d <= S x) n) as (d1 & Hd1 & P1).
    - intros j d d' H Hd' E Hj x Hx; specialize (H E Hj x ltac:(lra)); lra.
    - intros j Hj; destruct (Nat.eq_dec (m mod (2 * n)) 1) as [E|E]; [|exists 1; split; [lra | intros;
      contradiction]]. destruct (Nat.eq_dec j 0) as [->|J]; [exists 1; split; [lra | intros; lia]|].
      destruct (S_turns j) as (b & Hb & Eb); destruct (S_near j 1) as (d & Hd & P).
      { rewrite Rmult_1_l, Eb; apply Rmult_lt_0_compat; [exact Hb | apply Pos; [exact E | lia]]. }
      exists d; split; [exact Hd|]; intros _ _ x Hx; rewrite <- (Rmult_1_l (S x)); apply P, Hx.
    - assert (P2 : (m mod (2 * n) = 1)%nat -> forall j x, (0 < j < n)%nat -> Rabs (x - 2 * PI * INR j) <= d1 ->
        d1 <= S x) by (intros E j x [J1 J2] Hx; apply (P1 j); assumption).
      destruct (le_lt_dec 2 n) as [N2|N2]; [|exists d1; split; [exact Hd1 | split; [exact P2 | lia]]].
      destruct (Nat.eq_dec (m mod (2 * n)) 1) as [E|E].
      { exists d1; split; [exact Hd1 | split; [exact P2 | intros; contradiction]]. }
      destruct (Neg N2 E) as [Z|(j & Hj & Z)].
      { exists d1; split; [exact Hd1 | split; [exact P2|]]; intros _ _; left.
        destruct (S_turns 1) as (b & _ & Eb); rewrite Rmult_1_r in Eb; rewrite Eb, Rmult_1_l, Z; ring. }
      destruct (S_turns j) as (b & Hb & Eb); destruct (S_near j (-1)) as (d & Hd & P).
      { rewrite Eb; replace (-1 * _) with (b * - sin (PI * (INR j * INR m / INR n))) by ring.
        apply Rmult_lt_0_compat; lra. }
      destruct (two_least d1 d Hd1 Hd) as (d' & Hd' & L1 & L2); exists d'; split; [exact Hd' | split].
      + intros E'; contradiction.
      + intros _ _; right; exists j; split; [exact Hj|]; intros x Hx; specialize (P x ltac:(lra)); lra. }
  destruct Kap as (kap & Hkap & Kpos & Kneg).
  destruct (continuous_bounded S (T + 1) ltac:(lra) (fun x => D_continuous _ _ _ (D_S c k S V HS x))) as (C1 & PC1 &
    HC1). destruct (continuous_bounded (fun x => - c * V x - k * S x) (T + 1)) as (C2 & PC2 & HC2); [lra| |].
  { intros x; apply (D_continuous _ (- c * (- c * V x - k * S x) - k * V x)).
    apply D_minus; apply D_scale; [apply (D_V c k S V HS) | apply (D_S c k S V HS)]. }
  set (C := C1 + C2 + 1); assert (HC : forall x, Rabs x <= T + 1 -> Rabs (S x) <= C /\
    Rabs (- c * V x - k * S x) <= C) by (intros x Hx; specialize (HC1 x Hx); specialize (HC2 x Hx); unfold C; lra).
  destruct (two_least r0 (kap / 2) ltac:(lra) ltac:(lra)) as (r1 & Hr1 & L1 & L2), (two_least r1 eps Hr1 He)
    as (r & Hr & L3 & L4). destruct (Sh r ltac:(lra)) as (g & Hg & Sh').
  assert (Dec : regular O n m \/ ~ regular O n m).
  { unfold regular; destruct (Req_dec q 1), (Req_dec (tau * q) (-1)); tauto. } destruct Dec as [HN|HN].
  2:{ destruct (Sh' r 1 ltac:(lra) ltac:(lra)) as (mu0 & M0 & Sp); exists mu0; split; [exact M0|]; intros nu Hnu.
    specialize (Sp nu Hnu); constructor; [exact (not_before nu (shaped_before _ _ _ _ _ _ _ Sp))| |].
    - intros [N _]; contradiction.
    - intros _; exact (not_regular a r g r 1 nu ltac:(lra) Ha ltac:(lra) Sp HN). }
  pose proof (tau_q O n m HR HN) as [B1 B2]; pose proof (q_range O n m HR) as [B0 _].
  set (A := (1 + tau) / (1 + tau * q)); assert (HA0 : 0 < A) by (apply Rdiv_lt_0_compat; lra).
  assert (HC0 : 0 < C) by (unfold C; lra); assert (HCA : 0 < C * A) by (apply Rmult_lt_0_compat; assumption).
  destruct (two_least r (kap * A / 4) Hr) as (d & Hd & L5 & L6); [assert (0 < kap * A) by (apply Rmult_lt_0_compat;
    assumption); lra|]. destruct (two_least a g Ha Hg) as (h & Hh & L7 & L8); set (e := h / (2 * (C * A))).
  assert (He0 : 0 < e) by (apply Rdiv_lt_0_compat; lra); assert (He1 : C * A * e = h / 2) by (unfold e; field; lra).
  destruct (Sh' d e ltac:(lra) He0) as (mu0 & M0 & Sp); exists mu0; split; [exact M0|]; intros nu Hnu.
  specialize (Sp nu Hnu); constructor; [exact (not_before nu (shaped_before _ _ _ _ _ _ _ Sp))| |].
  - intros [_ Hb]; destruct (rising_exists O HO a r g d e nu Ha ltac:(lra) Hg ltac:(lra) Sp ltac:(lra)) as (t0 & I0 &
    Z0). destruct (zero_is O HO a r g d e nu Ha ltac:(lra) ltac:(lra) Sp t0 ltac:(apply Rabs_le; lra) Z0)
      as [_ [(_ & S1 & S2)|(X & _)]]; [|lra]. set (s1 := stop1 O (- nu) t0) in *; assert (P1 : 0 < s1) by nra.
    assert (W0 : 0 < A * s1) by (apply Rmult_lt_0_compat; assumption). assert (W1 : C * (A * s1) < h).
    { assert (C * A * s1 <= C * A * e) by (apply Rmult_le_compat_l; lra); lra. }
    assert (EW : (1 + tau * q) * (A * s1) = (1 + tau) * s1) by (unfold A; field; lra).
    assert (EA : forall t, (1 + tau) / (1 + tau * q) * t = A * t) by reflexivity; destruct HN as [N1 N2].
    pose proof (fun s w => hop_again c k S V HS (stop O (- nu)) (stop1 O (- nu)) T q tau TP Hq s w L B0 N1 N2) as Ag.
    destruct (hop_once O n m HA HR (- nu) eps t0 (A * s1)) as (t & y & v & Hon & Et & Ev); [|apply Rabs_le; lra|].
    { apply Ag; repeat split; trivial; intros x Hx.
      apply (clear a r g d e nu kap C) with (t0 := t0); trivial; try lra.
      - intros j z Hj; destruct Hb as [->|Hb]; [lia|]; apply Kpos; assumption.
      - assert (X : kap * A * nu <= kap * A * (s1 * - t0)) by (apply Rmult_le_compat_l;
          [left; apply Rmult_lt_0_compat|]; lra).
        assert (Y : kap * (A * s1) * - t0 <= kap * (A * s1) * d) by (apply Rmult_le_compat_l;
          [left; apply Rmult_lt_0_compat|]; lra).
        assert (Z : d * nu <= kap * A / 4 * nu) by (apply Rmult_le_compat_r; lra).
        apply (Rmult_lt_reg_r d); [lra|]; assert (0 < d * nu) by (apply Rmult_lt_0_compat; lra); lra.
      - fold s1; apply (Rmult_le_reg_l (1 + tau * q)); [lra|]; rewrite EW; apply Rplus_le_reg_l with (- s1).
        replace (- s1 + (1 + tau * q) * s1) with (tau * q * s1) by ring; replace (- s1 + (1 + tau) * s1) with (tau * s1)
          by ring; apply Rmult_le_compat_r; [lra|]; rewrite <- (Rmult_1_r tau) at 2; apply Rmult_le_compat_l; lra.
      - fold s1; apply (Rmult_le_reg_l (1 + tau * q)); [lra|].
        replace ((1 + tau * q) * (q * (A * s1))) with (q * ((1 + tau * q) * (A * s1))) by ring; rewrite EW.
        assert (0 <= (1 - q) * s1) by (apply Rmult_le_pos; lra); lra. }
    exists t, y, v; split; [exact Hon|]; intros t' y' v' H' i x.
    destruct (once_hop O n m HA HR (- nu) PI t' y' v' H') as (A1 & D1 & E1); cbv zeta in *.
    destruct (once_hop O n m HA HR (- nu) eps t y v Hon) as (_ & _ & E2); cbv zeta in *; rewrite Et, Ev in E2.
    destruct (proj1 (Ag _ _) A1) as (Z1 & P2 & W2 & _).
    assert (Es : t' 0%Z = t0) by (apply (rising_unique O HO a r g d e nu Ha ltac:(lra) ltac:(lra) Sp); trivial;
      apply Rabs_le; lra).
    rewrite Es in *; rewrite W2 in E1; change ((1 + tau) / (1 + tau * q) * stop1 O (- nu) t0) with (A * s1) in E1.
    assert (Ti : t' i = t i).
    { rewrite (proj1 (once_again _ _ _ _ _ _ _ H' i 0)), (proj1 (once_again _ _ _ _ _ _ _ Hon i 0)); congruence. }
    split; [exact Ti|]; destruct (E1 i (x - t i)) as [F1 F2], (E2 i (x - t i)) as [G1 G2]; rewrite Ti in F1, F2.
    replace (t i + (x - t i)) with x in F1, F2, G1, G2 by ring; rewrite F1, F2, G1, G2; auto.
  - intros Nb h' t y v H; assert (N2 : (2 <= n)%nat /\ (m mod (2 * n) <> 1)%nat).
    { unfold births in Nb; split; [destruct (Nat.eq_dec n 1); [exfalso; tauto | lia] | tauto]. }
    destruct N2 as [N2 N3]; destruct (given a r g d e nu ltac:(lra) Ha ltac:(lra) Sp h' t y v HN H) as
      (s & w & Is & Hw & Z & Cl).
    pose proof (le_INR 2 n N2) as R2; change (INR 2) with 2 in R2; destruct (Kneg N2 N3) as [Z2|(j & Hj & Ng)].
    + assert (2 * PI * 2 <= T) by (apply Rmult_le_compat_l; lra); specialize (Cl (2 * PI) ltac:(lra)).
      destruct (stop_later O (- nu) HA 1 s) as [E _]; rewrite Rmult_1_r in E; rewrite E, Z, Z2 in Cl; lra.
    + assert (J : 1 <= INR j <= INR n - 1).
      { split; [apply (le_INR 1); lia|]; apply (Rplus_le_reg_r 1); rewrite <- S_INR.
        replace (INR n - 1 + 1) with (INR n) by ring; apply le_INR; lia. }
      assert (2 * PI * 1 <= 2 * PI * INR j <= 2 * PI * (INR n - 1)) by (split; apply Rmult_le_compat_l; lra).
      specialize (Cl (2 * PI * INR j - s) ltac:(lra)); specialize (Ng (2 * PI * INR j - s)).
      replace (2 * PI * INR j - s - 2 * PI * INR j) with (- s) in Ng by ring; specialize (Ng ltac:(apply Rabs_le;
        lra)). destruct (stop_later O (- nu) HA (Z.of_nat j) 0) as [E _]; rewrite <- INR_IZR_INZ, Rplus_0_l in E.
      replace (s + (2 * PI * INR j - s)) with (2 * PI * INR j) in Cl by ring.
      rewrite E, (stop_0 O HO) in Cl; assert (S (2 * PI * INR j - s) * w < 0); [|lra].
      apply Ropp_lt_cancel; rewrite Ropp_0, <- Ropp_mult_distr_l_reverse; apply Rmult_lt_0_compat; lra.
Qed.
End Birth.

Theorem Birth : Birth_statement.
Proof. intros O n m HO HR eps He; exact (born O n m HO HR eps He). Qed.
