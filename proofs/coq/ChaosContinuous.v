(** * Motions whose N agree from -(K + 2) to K + 2 are close at impact 0 *)

From Coq Require Import Reals QArith Qreals ZArith Lra Lia.
From Grazing Require Import PathsFlow PathsLegs PathsGaps PathsChecked Paths ChaosCertificates StatementPaths
  StatementChaos Chaos Contraction.
Open Scope R_scope.

(** ** Two solutions whose letters agree from -K to K *)

Local Notation legs l := (fun i => Letter.periods (l i)).
Section Two.
Variables (M : Machine.t) (w kappa spread : R) (l l' : Z -> Letter.t) (s s' : Z -> R) (K : Z).
Hypothesis HC : chain M w kappa spread l.
Hypothesis Hs : inside (lo M l) (hi M l) s.
Hypothesis Hs' : inside (lo M l') (hi M l') s'.
Hypothesis HF : forall i, sums M w (legs l) s i = s i.
Hypothesis HF' : forall i, sums M w (legs l') s' i = s' i.
Hypothesis HE : forall i, (- K <= i < K)%Z -> l' i = l i.

Definition agree (m : nat) : Prop := forall i, (- K + Z.of_nat m < i < K - Z.of_nat m)%Z ->
  Rabs (s i - s' i) <= wt M l i * (spread * kappa ^ m).

Lemma boxed i : (- K < i < K)%Z -> lo M l i <= s i <= hi M l i /\ lo M l i <= s' i <= hi M l i.
Proof.
  intros H; split; [exact (Hs i)|]; pose proof (Hs' i) as I; unfold lo, hi in I; rewrite !HE in I by lia; exact I.
Qed.
Lemma kappa_pow m : 0 <= spread * kappa ^ m. Proof. apply Rmult_le_pos; [apply HC | apply pow_le, HC]. Qed.

Lemma leg_agrees m i : agree m -> (- K + Z.of_nat m < i)%Z -> (i + 1 < K - Z.of_nat m)%Z ->
  Rabs (afters M w (legs l) s i - afters M w (legs l') s' i) <= kappa * alpha (l i) * (spread * kappa ^ m) /\
  Rabs (befores M w (legs l) s i - befores M w (legs l') s' i) <= kappa * beta (l i) * (spread * kappa ^ m).
Proof.
  intros H Hi Hi'; destruct (boxed i ltac:(lia)) as [B1 B2]; destruct (boxed (i + 1) ltac:(lia)) as [B3 B4].
  unfold afters, befores; rewrite (HE i) by lia.
  apply (leg_close M w kappa spread l HC); auto using kappa_pow; apply H; lia.
Qed.

Lemma closer m : agree m.
Proof.
  induction m as [|m IH]; intros i Hi.
  - destruct (boxed i ltac:(lia)) as [B1 B2]; destruct (wt_pos M w kappa spread l HC i) as (_ & _ & S).
    rewrite pow_O, Rmult_1_r; apply Rabs_le; lra.
  - destruct (leg_agrees m i IH) as [A _]; [lia..|]; destruct (leg_agrees m (i - 1) IH) as [_ B]; [lia..|].
    rewrite <- (HF i), <- (HF' i); unfold sums; cbn [pow].
    replace (spread * (kappa * kappa ^ m)) with (kappa * (spread * kappa ^ m)) by ring.
    apply (sum_close M w kappa spread l HC); [exact A | exact B].
Qed.
End Two.

(** ** The paper's oscillator *)

Lemma phase_lipschitz mu s s' : mu > 0 -> let M := machine mu in good M (6 / 5) ->
  (forall x, Rmin s s' <= x <= Rmax s s' -> lands M (6 / 5) x /\ -1 < x < 1) ->
  Rabs (phase M (6 / 5) s - phase M (6 / 5) s') <= Rabs (s - s').
Proof.
  intros Hmu M HG HL; pose proof (nu_range mu Hmu) as Hn; pose proof PI2_3_2 as HPI.
  assert (B : forall x, Rmin s s' <= x <= Rmax s s' -> Rabs (- (Machine.nu M / 2) / bend M (phase M (6 / 5) x)) <= 1).
  { intros x Hx; destruct (HL x Hx) as [[L E] Hx1]; set (t := phase M (6 / 5) x) in *.
    destruct (machine_wall mu t) as (_ & E1 & E2); fold M in E1, E2; rewrite E1 in E; rewrite E2.
    apply Rabs_def2 in L; assert (C : 0 < cos t) by (apply cos_gt_0; lra).
    pose proof (sin2_cos2 t) as S; unfold Rsqr in S; change (Machine.nu M) with (mu / (1 + mu)) in *.
    set (nu := mu / (1 + mu)) in *; set (y := sin t) in *; set (k := cos t) in *.
    assert (Hy : -1 / 2 < y < 1 / 2) by (split; nra); assert (Hk : nu / 2 <= k) by nra.
    unfold Rdiv at 1; rewrite Rabs_mult, Rabs_Ropp, Rabs_inv, (Rabs_pos_eq (nu / 2)), (Rabs_pos_eq k) by lra.
    apply (Rmult_le_reg_r k); [exact C|]; rewrite Rmult_assoc, Rinv_l; lra. }
  assert (D : forall x, Rmin s s' <= x <= Rmax s s' -> derivable_pt_lim (phase M (6 / 5)) x (- (Machine.nu M / 2) / bend
    M (phase M (6 / 5) x))).
  { intros x Hx; apply (D_phase_at M (6 / 5) (good_b _ _ HG)); [apply HG | apply HL, Hx]. }
  assert (X : forall a b, a < b -> (forall x, a <= x <= b -> Rmin s s' <= x <= Rmax s s') ->
    Rabs (phase M (6 / 5) b - phase M (6 / 5) a) <= Rabs (b - a)).
  { intros a b Hab I; destruct (MVT_cor2 (phase M (6 / 5)) (fun x => - (Machine.nu M / 2) / bend M (phase M (6 / 5) x))
      a b Hab) as (x & E & Hx); [intros; apply D, I; assumption|]; rewrite E, Rabs_mult.
    pose proof (B x (I x ltac:(lra))); pose proof (Rabs_pos (b - a)); nra. }
  destruct (Rtotal_order s s') as [L|[->|L]].
  - rewrite Rabs_minus_sym, (Rabs_minus_sym s); apply X; [exact L|]; rewrite Rmin_left, Rmax_right by lra; auto.
  - rewrite !Rminus_eq_0; lra.
  - apply X; [exact L|]; rewrite Rmin_right, Rmax_left by lra; auto.
Qed.

Lemma chain_12 mu N : mu > 0 -> one_or_two N -> chain (machine mu) (6 / 5) (7 / 8) 2 (letters_of N).
Proof.
  intros Hmu HN; destruct (letters_path N HN) as [HP _].
  destruct (checked_path chaos_12 (machine mu) (letters_of N) checked_12 (machine_covered mu Hmu) HP) as [[B HC] _].
  replace (Q2R (Certificate.window chaos_12)) with (6 / 5) in HC by (unfold Q2R; cbn; lra).
  replace (Q2R (Certificate.contraction chaos_12)) with (7 / 8) in HC by (unfold Q2R; cbn; lra).
  destruct HC; constructor; trivial; [lra|]; intros i; unfold letters_of, letter_of; destruct (_ =? 1)%Z; unfold alpha,
    beta, Q2R; cbn; repeat split; lra.
Qed.

(** The numbers of the boxes. *)
Lemma s_range mu N i : mu > 0 -> one_or_two N -> let M := machine mu in let l := letters_of N in
  -1 < lo M l i /\ hi M l i < 1 /\ wt M l i <= 3 / 2 /\ alpha (l i) <= 1.
Proof.
  intros Hmu HN M l; unfold lo, hi, wt, s_lo, s_hi, weight, sum_of, l, letters_of, letter_of, alpha, beta.
  destruct (_ =? 1)%Z, (_ =? 1)%Z; unfold Q2R; cbn; repeat split; lra.
Qed.

Theorem Chaos_continuous : Chaos_continuous_statement.
Proof.
  intros mu N N' t q v t' q' v' K Hmu HN HN' HM HB HM' HB' HE.
  pose proof (chain_12 mu N Hmu HN) as HC; pose proof (chain_12 mu N' Hmu HN') as HC'.
  destruct (letters_path N HN) as [_ HT], (letters_path N' HN') as [_ HT'].
  pose proof (conj HM (inside_window _ _ _ _ _ Hmu HM (small_12 _ _ _ _ Hmu HN HB))) as J; clear HM.
  pose proof (conj HM' (inside_window _ _ _ _ _ Hmu HM' (small_12 _ _ _ _ Hmu HN' HB'))) as J'; clear HM'.
  apply motion_scaled in J as HM, J' as HM'; try exact Hmu; apply boxes_scaled in HB, HB'; try assumption.
  set (M := machine mu) in *; set (l := letters_of N) in *; set (l' := letters_of N') in *.
  pose proof (sums_inside M (6 / 5) (7 / 8) 2 l HC t (scaled mu v) HB) as Hs.
  pose proof (sums_inside M (6 / 5) (7 / 8) 2 l' HC' t' (scaled mu v') HB') as Hs'.
  pose proof (sums_fixed M (6 / 5) (7 / 8) 2 l N HC HT t _ _ HM HB) as HF.
  pose proof (sums_fixed M (6 / 5) (7 / 8) 2 l' N' HC' HT' t' _ _ HM' HB') as HF'.
  pose proof (chain_good _ _ _ _ _ HC) as HG; pose proof (chain_tau _ _ _ _ _ HC) as Ht.
  pose proof (fun i => proj1 (phases M (6 / 5) N HG Ht t _ _ HM i)) as P.
  pose proof (fun i => proj1 (phases M (6 / 5) N' HG Ht t' _ _ HM' i)) as P'.
  pose proof (motion_leg M (6 / 5) (legs l) N HG Ht HT t _ _ HM (sums_leg _ _ _ _ _ HC t _ HB) 0%Z) as (_ & V & A & _).
  pose proof (motion_leg M (6 / 5) (legs l') N' HG Ht HT' t' _ _ HM' (sums_leg _ _ _ _ _ HC' t' _ HB') 0%Z)
    as (_ & V' & A' & _).
  rewrite <- !P in A; rewrite <- !P' in A'.
  set (s := sums_of M t (scaled mu v)) in *; set (s' := sums_of M t' (scaled mu v')) in *.
  assert (EL : forall i, (- (Z.of_nat K + 2) <= i < Z.of_nat K + 2)%Z -> l' i = l i).
  { intros i Hi; unfold l', l, letters_of; rewrite !HE by lia; reflexivity. }
  pose proof (closer M (6 / 5) (7 / 8) 2 l l' s s' (Z.of_nat K + 2) HC Hs Hs' HF HF' EL) as C.
  destruct (s_range mu N 0 Hmu HN) as (R1 & R2 & R3 & R4); fold M l in R1, R2, R3, R4.
  pose proof (pow_le (7 / 8) K ltac:(lra)) as Hp; split.
  - replace (t 0%Z - t' 0%Z) with (phase M (6 / 5) (s 0%Z) - phase M (6 / 5) (s' 0%Z)).
    2: { rewrite P, P', (HE 0%Z) by lia; ring. }
    apply (Rle_trans _ (Rabs (s 0%Z - s' 0%Z))).
    + apply phase_lipschitz; [exact Hmu | apply HC|].
      pose proof (Hs 0%Z) as I; pose proof (Hs' 0%Z) as I'; unfold lo, hi in I'; rewrite !EL in I' by lia.
      fold (lo M l 0%Z) (hi M l 0%Z) in I'; intros x Hx.
      assert (Ix : lo M l 0%Z <= x <= hi M l 0%Z) by (revert Hx; unfold Rmin, Rmax; destruct Rle_dec; lra).
      split; [|lra]. apply (fun H => proj1 (chain_legs _ _ _ _ _ HC 0%Z x (s 1%Z) Ix H)). exact (Hs 1%Z).
    + apply (Rle_trans _ _ _ (C (S K) 0%Z ltac:(lia))); cbn [pow]; nra.
  - destruct (leg_agrees M (6 / 5) (7 / 8) 2 l l' s s' (Z.of_nat K + 2) HC Hs Hs' EL K 0%Z (C K)) as [X _]; [lia..|].
    unfold afters in X; cbn [Z.add] in A, A'; change (0 + 1)%Z with 1%Z in X; rewrite <- A, <- A' in X.
    pose proof (nu_range mu Hmu) as Hn.
    replace (v 0%Z (t 0%Z) - v' 0%Z (t' 0%Z)) with (mu * (scaled mu v 0%Z (t 0%Z) / Machine.nu M - scaled mu v' 0%Z
      (t' 0%Z) / Machine.nu M)).
    2: { unfold scaled; cbn [M machine Machine.nu]; field; lra. }
    rewrite Rabs_mult, (Rabs_pos_eq mu) by lra. rewrite (Rmult_comm 2 mu), Rmult_assoc; apply Rmult_le_compat_l; [lra|].
    apply (Rle_trans _ _ _ X); pose proof (chain_sizes _ _ _ _ _ HC 0%Z) as (_ & _ & Pa & _).
    assert (alpha (l 0%Z) * (7 / 8) ^ K <= 1 * (7 / 8) ^ K) by (apply Rmult_le_compat_r; lra); lra.
Qed.
