(** * Motions whose N agree from -(K + 2) to K + 2 are close at impact 0 *)

From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import StatementChaos ChaosFlow Contraction ChaosChecks ChaosLegs Chaos.
Open Scope R_scope.

Definition periods_of (N : Z -> Z) (i : Z) : Z := (N (i + 1) - N i)%Z.

(** A motion by its s. *)
Definition described (mu : R) (N : Z -> Z) (t : Z -> R) (v : Z -> R -> R) (s : Z -> R) : Prop :=
  let nu := mu / (1 + mu) in let n := periods_of N in forall i,
  dec (s_lo (n (i - 1)%Z) (n i)) <= s i <= dec (s_hi (n (i - 1)%Z) (n i)) /\
  v i (t i) = mu * after (n i) nu (phase nu (s i)) (phase nu (s (i + 1)%Z)) /\
  s i = after (n i) nu (phase nu (s i)) (phase nu (s (i + 1)%Z)) +
    before (n (i - 1)%Z) nu (phase nu (s (i - 1)%Z)) (phase nu (s i)) /\
  t i = 2 * PI * IZR (N i) + phase nu (s i).

Lemma motion_described mu N t q v : mu > 0 -> one_or_two N -> motion mu N t q v -> in_boxes mu N t v ->
  described mu N t v (sums_of mu t v).
Proof.
  intros Hmu HN HM HB; unfold described; intros i; set (nu := mu / (1 + mu)); set (n := periods_of N).
  pose proof (sums_inside mu N Hmu HN t v HB i) as I.
  pose proof (sums_fixed mu N Hmu HN t q v HM HB i) as E.
  pose proof (phases mu N Hmu t q v HM) as P.
  destruct (motion_leg mu N Hmu HN t q v HM HB i) as (_ & V & A & _).
  split; [exact I|]; split; [|split].
  - fold nu in P; rewrite !P; rewrite V; f_equal; exact A.
  - symmetry; exact E.
  - fold nu in P; rewrite P; ring.
Qed.

Lemma phase_lipschitz nu s s' : 0 < nu <= 1 -> -1 < s < 1 -> -1 < s' < 1 ->
  Rabs (phase nu s - phase nu s') <= Rabs (s - s').
Proof.
  intros Hn Hs Hs'; set (c := fun x => s' + x * (s - s')).
  assert (Hc : forall x, 0 <= x <= 1 -> -1 < c x < 1).
  { intros x Hx; pose proof (Rmin_l s s'); pose proof (Rmin_r s s').
    pose proof (Rmax_l s s'); pose proof (Rmax_r s s').
    pose proof (between x s s' (Rmin s s') (Rmax s s') ltac:(lra) ltac:(lra) Hx).
    assert (-1 < Rmin s s') by (apply Rmin_glb_lt; lra); assert (Rmax s s' < 1) by (apply Rmax_lub_lt; lra).
    unfold c; lra. }
  destruct (MVT_cor2 (fun x => phase nu (c x)) (fun x => - (nu / 2) / cos (phase nu (c x)) * (s - s')) 0 1
    Rlt_0_1) as (x & E & Hx).
  { intros x Hx; specialize (Hc x Hx); apply D_phase; [apply Rabs_def1; nra|].
    unfold c; eapply D_ext.
    - apply (D_plus (fun _ => s') (fun y => (s - s') * y)); [apply D_const|].
      apply (D_scale (fun y => y) x 1 (s - s')), D_id.
    - intros y; cbn beta; ring.
    - ring. }
  replace (c 1) with s in E by (unfold c; ring); replace (c 0) with s' in E by (unfold c; ring).
  rewrite E, Rminus_0_r, Rmult_1_r, Rabs_mult; specialize (Hc x ltac:(lra)).
  assert (Hy : Rabs (nu * c x * (1 / 2)) < 1) by (apply Rabs_def1; nra).
  pose proof (cos_phase_pos nu (c x) Hy) as Pc; pose proof (cos_phase nu (c x) Hy) as Ec.
  set (y := nu * c x * (1 / 2)) in *.
  assert (Hy2 : -1 / 2 < y < 1 / 2) by (unfold y; split; nra).
  assert (Hw : 0 <= 1 - y * y) by nra; pose proof (sqrt_sqrt _ Hw) as Es; rewrite <- Ec in Es.
  set (k := cos (phase nu (c x))) in *.
  assert (Hk : nu / 2 <= k) by nra.
  apply (Rle_trans _ (1 * Rabs (s - s'))); [|lra]; apply Rmult_le_compat_r; [apply Rabs_pos|].
  unfold Rdiv at 1; rewrite Rabs_mult, Rabs_Ropp, Rabs_inv, (Rabs_pos_eq (nu / 2)), (Rabs_pos_eq k) by lra.
  apply (Rmult_le_reg_r k); [exact Pc|]; rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Section Two.
Variables (mu : R) (N N' : Z -> Z) (t t' : Z -> R) (v v' : Z -> R -> R) (s s' : Z -> R) (K : Z).
Hypothesis Hmu : mu > 0.
Hypothesis HN : one_or_two N.
Hypothesis HD : described mu N t v s.
Hypothesis HD' : described mu N' t' v' s'.
Hypothesis HE : forall i, (- K <= i <= K)%Z -> N i = N' i.
Let nu := mu / (1 + mu).
Let n := periods_of N.

Lemma letters i : letter (n i).
Proof. unfold letter, n, periods_of; destruct (HN i); lia. Qed.

Lemma same i : (- K <= i < K)%Z -> periods_of N' i = n i.
Proof. intros H; unfold n, periods_of; rewrite !HE by lia; reflexivity. Qed.

Lemma nu_in : 0 < nu <= 1.
Proof. pose proof (nu_range mu Hmu : 0 < nu < 1); lra. Qed.

Lemma boxed i : (- K < i < K)%Z -> dec (s_lo (n (i - 1)) (n i)) <= s i <= dec (s_hi (n (i - 1)) (n i)) /\
  dec (s_lo (n (i - 1)) (n i)) <= s' i <= dec (s_hi (n (i - 1)) (n i)).
Proof.
  intros H; destruct (HD i) as (I & _), (HD' i) as (I' & _); rewrite !same in I' by lia; split; assumption.
Qed.

Definition close (m : nat) : Prop := forall i, (- K + Z.of_nat m < i < K - Z.of_nat m)%Z ->
  Rabs (s i - s' i) <= dec (weight (n (i - 1)) (n i)) * (2 * kappa ^ m).

Lemma kappa_pow m : 0 <= 2 * kappa ^ m.
Proof. pose proof (pow_le kappa m ltac:(unfold kappa, dec; lra)); lra. Qed.

Lemma leg_close m i : close m -> (- K + Z.of_nat m < i)%Z -> (i + 1 < K - Z.of_nat m)%Z ->
  Rabs (after (n i) nu (phase nu (s i)) (phase nu (s (i + 1)%Z)) -
        after (n i) nu (phase nu (s' i)) (phase nu (s' (i + 1)%Z)))
    <= kappa * dec (alpha (n i)) * (2 * kappa ^ m) /\
  Rabs (before (n i) nu (phase nu (s i)) (phase nu (s (i + 1)%Z)) -
        before (n i) nu (phase nu (s' i)) (phase nu (s' (i + 1)%Z)))
    <= kappa * dec (beta (n i)) * (2 * kappa ^ m).
Proof.
  intros H Hi Hi'; destruct (boxed i ltac:(lia)) as [B1 B2]; destruct (boxed (i + 1) ltac:(lia)) as [B3 B4].
  pose proof (H i ltac:(lia)) as C; pose proof (H (i + 1)%Z ltac:(lia)) as C'.
  replace (i + 1 - 1)%Z with i in B3, B4, C' by lia.
  apply (leg_lipschitz (n (i - 1)) _ (n (i + 1))); auto using letters, nu_in, kappa_pow.
Qed.

Lemma closer m : close m.
Proof.
  induction m as [|m IH]; intros i Hi.
  - destruct (boxed i ltac:(lia)) as [B1 B2].
    destruct (sizes (n (i - 1)) (n i) (letters _) (letters _)) as (_ & _ & S & _).
    rewrite pow_O, Rmult_1_r; apply Rabs_le; lra.
  - destruct (leg_close m i IH) as [A _]; [lia..|].
    destruct (leg_close m (i - 1) IH) as [_ B]; [lia..|].
    replace (i - 1 + 1)%Z with i in B by lia.
    destruct (HD i) as (_ & _ & E & _), (HD' i) as (_ & _ & E' & _).
    rewrite !same in E' by lia; fold nu n in E, E'; rewrite E, E'.
    match goal with |- Rabs (?a + ?b - (?c + ?e)) <= _ =>
      replace (a + b - (c + e)) with ((a - c) + (b - e)) by ring end.
    apply (Rle_trans _ _ _ (Rabs_triang _ _)).
    cbn [pow]; unfold dec, weight in *; rewrite plus_IZR; lra.
Qed.
End Two.

Theorem Chaos_continuous : Chaos_continuous_statement.
Proof.
  intros mu N N' t q v t' q' v' K Hmu HN HN' HM HB HM' HB' HE.
  pose proof (motion_described mu N t q v Hmu HN HM HB) as HD.
  pose proof (motion_described mu N' t' q' v' Hmu HN' HM' HB') as HD'.
  set (s := sums_of mu t v) in *; set (s' := sums_of mu t' v') in *; clearbody s s'.
  set (L := (Z.of_nat K + 2)%Z).
  pose proof (closer mu N N' t t' v v' s s' L Hmu HN HD HD' HE) as C.
  pose proof (letters N HN) as HL.
  pose proof (boxed mu N N' t t' v v' s s' L HD HD' HE 0%Z ltac:(lia)) as [B B'].
  destruct (sizes _ _ (HL (-1)%Z) (HL 0%Z)) as (_ & _ & _ & S1 & S2).
  assert (Hk : kappa = 7 / 8) by (unfold kappa, dec; lra).
  pose proof (pow_le kappa K ltac:(lra)) as Hp.
  split.
  - destruct (HD 0%Z) as (_ & _ & _ & ->), (HD' 0%Z) as (_ & _ & _ & ->); rewrite (HE 0%Z) by lia.
    set (nu := mu / (1 + mu)).
    replace (2 * PI * IZR (N' 0%Z) + phase nu (s 0%Z) - (2 * PI * IZR (N' 0%Z) + phase nu (s' 0%Z)))
      with (phase nu (s 0%Z) - phase nu (s' 0%Z)) by ring.
    apply (Rle_trans _ (Rabs (s 0%Z - s' 0%Z))).
    + apply phase_lipschitz; [exact (nu_in mu Hmu) | cbn in *; lra | cbn in *; lra].
    + apply (Rle_trans _ _ _ (C (S K) 0%Z ltac:(lia))); cbn [pow]; rewrite <- Hk.
      assert (W : dec (weight (periods_of N (0 - 1)) (periods_of N 0)) <= 3 / 2).
      { destruct (HL (0 - 1)%Z) as [->| ->], (HL 0%Z) as [->| ->];
        unfold dec, weight, alpha, beta; cbn; lra. }
      rewrite Hk at 1; nra.
  - destruct (leg_close mu N N' t t' v v' s s' L Hmu HN HD HD' HE K 0%Z (C K)) as [A _]; [lia..|].
    destruct (HD 0%Z) as (_ & -> & _), (HD' 0%Z) as (_ & -> & _).
    rewrite (same N N' L HE) by lia; rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq mu) by lra.
    rewrite (Rmult_comm 2 mu), Rmult_assoc; apply Rmult_le_compat_l; [lra|].
    apply (Rle_trans _ _ _ A); rewrite <- Hk.
    assert (W : 0 <= dec (alpha (periods_of N 0)) <= 1).
    { destruct (HL 0%Z) as [->| ->]; unfold dec, alpha; cbn; lra. }
    rewrite Hk at 1; nra.
Qed.
