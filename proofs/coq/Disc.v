(** * S1, S2 and S3 hold on the disc and the circle, 0 < r <= 1

    Sections 3 and 4 of ../conjecture1.md: the lattice lemmas, read for b_{n,k} and c_n. *)

From Coq Require Import Reals ZArith Arith Lra Lia.
From Grazing Require Import Defs Statement Cases Polar LnCos Convex Lattice Phase Farey.
Open Scope R_scope.

(** S3's index d decides at (r, s). *)
Definition decides_at (r s : R) (n d : nat) (g : sign) : Prop :=
  (all_b (fun x => x > 0) r s n <-> b_at r s n d > 0) /\
  exists_iff (trace r s) (r ^ 2) n Plus g (b_at r s n d > 0) /\
  (b_at r s n d < 0 -> no_orbit (trace r s) (r ^ 2) n) /\
  (b_at r s n d = 0 -> r < 1 ->
   forall k, (1 <= k <= n - 1)%nat -> k <> d -> b_at r s n k > 0).

Lemma exists_iff_ext a1 a2 n e g P Q : (P <-> Q) -> exists_iff a1 a2 n e g P -> exists_iff a1 a2 n e g Q.
Proof. intros HPQ HP e' g'; rewrite (HP e' g'); tauto. Qed.

(** ** A cell of the disc *)

Section Cell.

Variables (r s : R) (n m : nat).
Hypothesis Hn : (2 <= n)%nat.
Hypothesis H : cell r s n m.
Let th := 2 * PI * s.

Lemma cell_regular : regular r th n m.
Proof.
  destruct H as (Hr & Hs & Hu & Hm); pose proof PI_RGT_0. assert (Hth : 0 < th < PI) by (unfold th; nra).
  refine (conj Hr (conj Hth (conj _ (conj _ _)))); [lia| |].
  - apply (u_zero r th); [lra|apply sin_gt_0; lra|exact Hu].
  - apply Rabs_def2 in Hm; unfold th; apply Rabs_def1; nra.
Qed.

Lemma sign_c : sin (INR n * th) * c_at r s n < 0.
Proof.
  destruct cell_regular as ((Hr & _) & Hth & _ & Hs & _). assert (Hsin : sin th > 0) by (apply sin_gt_0; lra).
  pose proof (pow_lt r n Hr) as Hp. pose proof (c_polar r th Hr Hsin n (proj1 (proj2 (proj2 H)))) as E.
  pose proof (sin2_cos2 (INR n * th)) as T; unfold Rsqr in T.
  fold (trace r s) in E; change (c (2 * r * cos th) (r ^ 2) n) with (c_at r s n) in E.
  set (S := sin (INR n * th)) in *; set (C := cos (INR n * th)) in *.
  assert (0 < S ^ 2) by (pose proof (Rsqr_pos_lt S Hs); unfold Rsqr in *; lra).
  assert (Hpos : 0 < 1 - 2 * r ^ n * C + (r ^ n) ^ 2) by (pose proof (pow2_ge_0 (r ^ n - C)); lra).
  assert (0 < r * sin th) by now apply Rmult_lt_0_compat. apply (Rmult_lt_reg_l (r ^ n)); [assumption|].
  replace (r ^ n * (S * c_at r s n)) with (c_at r s n * (r ^ n * S)) by ring. rewrite E; nra.
Qed.

(** At height 0 a lattice point is inside V. *)
Lemma height_0_neg k l : (0 < k < n)%nat -> (k * m = l * n)%nat -> b_at r s n k < 0.
Proof.
  intros Hk E; pose proof cell_regular as HR. apply (b_neg r th n m HR k (Z.of_nat l)); [lia|].
  rewrite (phase_W r th n m HR), <- INR_IZR_INZ, <- !mult_INR, E, Rminus_eq_0.
  apply (chord_inside _ _ _ _ (phases_chord r th n m HR)). split; [apply lt_0_INR|apply lt_INR]; lia.
Qed.

(** A step th < pi cannot cross the half turn where cos <= 0. *)
Lemma some_b_pos : (1 <= m)%nat -> exists k, (1 <= k <= n - 1)%nat /\ b_at r s n k > 0.
Proof.
  intros Hm1; pose proof cell_regular as HR.
  pose proof (window_alpha r th n) as Ha; pose proof (window_beta r th n m HR) as Hb.
  pose proof (cos_alpha_pos r th n) as Hc. destruct HR as ((Hr & _) & Hth & _ & _).
  assert (Hstep : forall k, (k <= n - 1)%nat -> window (alpha r th n + INR k * th) \/ exists j, (1 <= j <= n - 1)%nat /\
    cos (alpha r th n + INR j * th) <= 0).
  { induction k as [|k IH]; intros Hk; [left; simpl; now rewrite Rmult_0_l, Rplus_0_r|].
    destruct (IH ltac:(lia)) as [Hw|]; [|now right].
    destruct (Rle_or_lt (cos (alpha r th n + INR (S k) * th)) 0).
    { right; exists (S k); split; [lia|assumption]. }
    left; apply cos_pos_window; trivial; rewrite S_INR; unfold window in Hw; lra. }
  destruct (Hstep (n - 1)%nat (le_n _)) as [Hw|(j & Hj & Hcos)].
  - exfalso; rewrite minus_INR in Hw by lia; simpl in Hw. apply (le_INR 1) in Hm1; simpl in Hm1.
    unfold window, beta in *; pose proof PI_RGT_0; nra.
  - exists j; split; [assumption|]. pose proof (b_phase r th n m cell_regular j ltac:(lia)) as E.
    pose proof (pow_lt r j Hr); fold (trace r s) in E.
    change (b (2 * r * cos th) (r ^ 2) n j) with (b_at r s n j) in E; nra.
Qed.

End Cell.

Lemma S1_proof r s n : (2 <= n)%nat -> cell r s n 0 -> all_b (fun x => x < 0) r s n /\ c_at r s n < 0 /\
  exists_iff (trace r s) (r ^ 2) n Minus Plus True.
Proof.
  intros Hn H.
  assert (Hb : all_b (fun x => x < 0) r s n).
  { intros k Hk; apply (height_0_neg r s n 0 Hn H k 0); lia. }
  assert (Hc : c_at r s n < 0).
  { pose proof (sign_c r s n 0 Hn H); pose proof (cell_regular r s n 0 Hn H) as HR.
    destruct (alpha_neg r (2 * PI * s) n 0 HR); [|nra].
    destruct HR as (_ & Hth & H1 & _); apply (le_INR 1) in H1; simpl in *; nra. }
  split; [assumption|split; [assumption|]]. apply exists_Minus_Plus; trivial; apply H.
Qed.

Lemma S2_proof : S2_statement.
Proof.
  intros r s n m Hn Hm H; pose proof (some_b_pos r s n m Hn H Hm) as Hpos.
  split; [assumption|]; intros Hg; split; [apply H|]. destruct Hpos as (k' & Hk' & Hb').
  destruct (Nat.gcd_divide_l m n) as [l El], (Nat.gcd_divide_r m n) as [k Ek]. set (g := Nat.gcd m n) in *.
  exists k, k'; split; [nia|split; [assumption|split; [|assumption]]]. apply (height_0_neg r s n m Hn H k l); nia.
Qed.

(** ** Coprime m and n: one index decides *)

Section Coprime.

Variables (r s : R) (n m mp np mm nm : nat).
Hypothesis Hn : (2 <= n)%nat.
Hypothesis Hm : (1 <= m)%nat.
Hypothesis H : cell r s n m.
Hypothesis HF : neighbours m n mp np mm nm.
Let th := 2 * PI * s.
Let HR : regular r th n m := cell_regular r s n m Hn H.

(** A time k is forced by any lattice point of V at another time. *)
Definition forced (d : nat) : Prop := forall k, (1 <= k <= n - 1)%nat ->
  b_at r s n k <= 0 -> b_at r s n d <= 0 /\ (r < 1 -> k <> d -> b_at r s n d < 0).

Lemma ln_r_neg : r < 1 -> ln r < 0.
Proof. intros; rewrite <- ln_1; apply ln_increasing; [apply H|assumption]. Qed.

Lemma b_nonpos_lattice k : (1 <= k <= n - 1)%nat -> b_at r s n k <= 0 -> exists l, let i :=
  (Z.of_nat k * Z.of_nat m - l * Z.of_nat n)%Z in i <> 0%Z /\ V (alpha r th n) (ln r) (IZR (Z.of_nat k))
  (W (alpha r th n) (beta r th n m) (IZR (Z.of_nat n)) (IZR (Z.of_nat k)) (IZR i)).
Proof.
  intros Hk Hb; apply (b_nonpos r th n m HR) in Hb; [|lia]. destruct Hb as [l HV]; exists l; cbv zeta; split.
  - intros E; pose proof (multiple_zero _ _ _ _ _ _ HF (Z.of_nat k) l ltac:(lia) ltac:(lia)); lia.
  - rewrite (phase_W r th n m HR) in HV. now rewrite minus_IZR, !mult_IZR, <- !INR_IZR_INZ.
Qed.

(** The lattice point of time k and height i decides the sign of b. *)
Lemma b_at_point k l i : (k <= n)%nat -> INR k * INR m - IZR l * INR n = i -> let w := W (alpha r th n) (beta r th n m)
  (INR n) (INR k) i in (V (alpha r th n) (ln r) (INR k) w -> b_at r s n k <= 0) /\
  (inside (alpha r th n) (ln r) (INR k) w -> b_at r s n k < 0).
Proof.
  intros Hk <-; cbv zeta; rewrite <- (phase_W r th n m HR); split; intros HV.
  - apply (b_nonpos r th n m HR); [lia|eauto].
  - now apply (b_neg r th n m HR k l).
Qed.

Lemma height_of_neighbours : INR nm * INR m - IZR (Z.of_nat mm) * INR n = -1 /\
  INR np * INR m - IZR (Z.of_nat mp) * INR n = 1.
Proof.
  destruct HF as (_ & E & _ & E'); apply (f_equal INR) in E, E'.
  rewrite plus_INR, !mult_INR in E, E'; rewrite <- !INR_IZR_INZ; simpl in E, E'; lra.
Qed.

Lemma forced_minus : INR n * s < INR m -> forced nm.
Proof.
  intros Hs k Hk Hb; pose proof PI_RGT_0. destruct (alpha_pos r th n m HR) as [_ Ha]; [unfold th; nra|].
  destruct (b_nonpos_lattice k Hk Hb) as (l & Hi & HV). destruct (neighbours_sum _ _ _ _ _ _ HF) as [_ Sn].
  pose proof (phases_chord r th n m HR) as Hc; rewrite INR_IZR_INZ in Hc.
  pose proof (height_plus _ _ _ _ _ _ HF (Z.of_nat k) l) as Eq.
  pose proof (height_minus _ _ _ _ _ _ HF (Z.of_nat k) l) as Eq'. assert (Hp : (0 < np < n)%nat) by apply HF.
  destruct (b_at_point nm _ _ ltac:(lia) (proj1 height_of_neighbours)) as [Hle Hlt].
  destruct (lattice_decides _ _ _ (Z.of_nat n) (Z.of_nat np) (Z.of_nat nm) (Z.of_nat k) _ _ _ Hc Ha ltac:(lia)
    ltac:(lia) ltac:(lia) Hi Eq Eq' HV) as [HV' Hin].
  rewrite <- !INR_IZR_INZ in HV', Hin; split; [auto|]. intros Hr Hkd; apply Hlt, Hin; [now apply ln_r_neg|lia].
Qed.

(** The mirror image (al, be, height) -> (-al, -be, -height). *)
Lemma forced_plus : INR n * s > INR m -> forced np.
Proof.
  intros Hs k Hk Hb; pose proof PI_RGT_0. destruct (alpha_neg r th n m HR) as [_ Ha]; [unfold th; nra|].
  destruct (b_nonpos_lattice k Hk Hb) as (l & Hi & HV). destruct (neighbours_sum _ _ _ _ _ _ HF) as [_ Sn].
  pose proof (chord_opp _ _ _ _ (phases_chord r th n m HR)) as Hc; rewrite INR_IZR_INZ in Hc.
  pose proof (height_plus _ _ _ _ _ _ HF (Z.of_nat k) l) as Eq.
  pose proof (height_minus _ _ _ _ _ _ HF (Z.of_nat k) l) as Eq'. assert (Hp : (0 < nm < n)%nat) by apply HF.
  destruct (b_at_point np _ _ ltac:(lia) (proj2 height_of_neighbours)) as [Hle Hlt].
  cbv zeta in *; set (i := (Z.of_nat k * Z.of_nat m - l * Z.of_nat n)%Z) in *; clearbody i.
  rewrite <- (Z.opp_involutive i) in Eq.
  apply V_opp in HV; rewrite <- (Ropp_involutive (IZR i)), <- opp_IZR, <- W_opp in HV.
  destruct (lattice_decides _ _ _ (Z.of_nat n) (Z.of_nat nm) (Z.of_nat np) (Z.of_nat k) (- i) _ _ Hc ltac:(lra)
    ltac:(lia) ltac:(lia) ltac:(lia) ltac:(lia) Eq' Eq HV) as [HV' Hin].
  rewrite <- !INR_IZR_INZ, W_opp in HV', Hin; replace (- -1) with 1 in * by ring. split; [apply Hle, V_opp, HV'|].
  intros Hr Hkd; apply Hlt, inside_opp, Hin; [now apply ln_r_neg|lia].
Qed.

Lemma forced_decides d g : (1 <= d <= n - 1)%nat -> forced d -> sgn g * c_at r s n > 0 -> decides_at r s n d g.
Proof.
  intros Hd HFd Hc.
  assert (Hiff : all_b (fun x => x > 0) r s n <-> b_at r s n d > 0).
  { split; [intros Hall; now apply Hall|]; intros Hpos k Hk. apply Rnot_le_gt; intros Hle;
      destruct (HFd k Hk Hle); lra. }
  pose proof (some_b_pos r s n m Hn H Hm) as Hsome. assert (Hu : u (trace r s) (r ^ 2) n <> 0) by apply H.
  split; [assumption|split; [|split]].
  - now apply exists_iff_Plus.
  - intros Hneg; split; [assumption|]; destruct Hsome as (k & Hk & Hpos). exists d, k; auto.
  - intros H0 Hr k Hk Hkd; apply Rnot_le_gt; intros Hle. destruct (HFd k Hk Hle) as [_ Hs]; specialize (Hs Hr Hkd); lra.
Qed.

End Coprime.

Lemma S3_proof r s n m mp np mm nm : (2 <= n)%nat -> (1 <= m)%nat -> neighbours m n mp np mm nm -> cell r s n m ->
  (INR n * s < INR m -> c_at r s n > 0 /\ decides_at r s n nm Plus) /\ (INR n * s > INR m -> c_at r s n < 0 /\
  decides_at r s n np Minus).
Proof.
  intros Hn Hm HF H; pose proof PI_RGT_0.
  pose proof (sign_c r s n m Hn H); pose proof (cell_regular r s n m Hn H) as HR.
  assert (Hd : (1 <= nm <= n - 1)%nat /\ (1 <= np <= n - 1)%nat) by (destruct HF; lia). split; intros Hs.
  - destruct (alpha_pos _ _ _ _ HR); [nra|]. assert (c_at r s n > 0) by nra; split; [assumption|].
    apply (forced_decides r s n m); trivial; [lia| |simpl; lra]. now apply (forced_minus r s n m mp np mm nm).
  - destruct (alpha_neg _ _ _ _ HR); [nra|]. assert (c_at r s n < 0) by nra; split; [assumption|].
    apply (forced_decides r s n m); trivial; [lia| |simpl; lra]. now apply (forced_plus r s n m mp np mm nm).
Qed.

(** ** As stated *)

Lemma decides_at_decides r s n d g : 0 < r -> (1 <= d <= n - 1)%nat ->
  sgn g * c_at r s n > 0 -> decides_at r s n d g -> decides (trace r s) (r ^ 2) n d g.
Proof.
  intros Hr Hd Hc (_ & Hex & Hneg & Hz); constructor; [assumption..| | |].
  - intros H; apply Hex; tauto.
  - assumption.
  - intros H H2; apply Hz; [assumption|]; apply Rnot_le_lt; intros ?; nra.
Qed.

Lemma S1_stated : S1_statement. Proof. intros r s n Hn H; apply (S1_proof r s n Hn H); tauto. Qed.

Lemma S3_stated : S3_statement.
Proof.
  intros r s n m [mp np mm nm HF] Hn Hm H; cbn [n_plus n_minus].
  destruct (S3_proof r s n m mp np mm nm Hn Hm HF H) as [HL HR].
  assert ((1 <= np <= n - 1)%nat /\ (1 <= nm <= n - 1)%nat) by (destruct HF; lia).
  assert (0 < r) by apply H; split; intros Hs.
  - destruct (HL Hs); apply decides_at_decides; cbn [sgn]; tauto || lra.
  - destruct (HR Hs); apply decides_at_decides; cbn [sgn]; tauto || lra.
Qed.
