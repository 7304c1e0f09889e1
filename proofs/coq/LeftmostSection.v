(** * The leftmost area, n odd, has one interval as its section at a fixed determinant

    [LeftmostArea] gives the sign of b_{n,n-2}; S3 (with m = (n-1)/2) and S5 say that
    it decides on both sides of s = 1/2. *)

From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import Defs Statement StatementPlane Polar Algebra RealEigenvalues
  Cases Disc AppendixA Region4 Coordinates Summary LeftmostArea.
Open Scope R_scope.

Lemma continuity_U k : continuity (fun X => U X k).
Proof.
  induction k using two_step.
  - apply continuity_const; intros ? ?; reflexivity.
  - apply continuity_const; intros ? ?; reflexivity.
  - assert (E : (fun X => U X (S (S k))) = ((id * (fun X => U X (S k))) - (fun X => U X k))%F)
      by (apply FunctionalExtensionality.functional_extensionality; intros; apply U_SS).
    rewrite E; apply continuity_minus; [apply continuity_mult|]; try assumption.
    apply derivable_continuous, derivable_id.
Qed.

Lemma continuity_G r n : continuity (fun X => G r X n).
Proof.
  unfold G; apply (continuity_plus (fun X => r ^ 2 * U X n - U X (n - 2)));
    [apply (continuity_minus (fun X => r ^ 2 * U X n)) |].
  - apply (continuity_scal (fun X => U X n)), continuity_U.
  - apply continuity_U.
  - apply (continuity_scal id), derivable_continuous, derivable_id.
Qed.

(** The indices of the half-cell next to s = 1/2: n = 2h + 1, m = h, n+ = n - 2. *)
Lemma last_neighbours h : (1 <= h)%nat -> neighbours h (2 * h + 1) (h - 1) (2 * h + 1 - 2) 1 2.
Proof. intros Hh; repeat split; nia. Qed.

Section Section_.
Variables (r : R) (n : nat).
Hypothesis r_in : 0 < r < 1.
Hypothesis n_in : (3 <= n)%nat.
Hypothesis n_odd : Nat.Odd n.
Notation c0 := (left_end n).

Lemma right_end_beyond : c0 < r + / r.
Proof.
  pose proof (COS_bound (PI / INR n)); unfold left_end. assert (r * / r = 1) by (apply Rinv_r; lra).
  assert (0 < (1 - r) * (1 - r)) by (apply Rmult_lt_0_compat; lra). apply Rmult_lt_reg_l with r; nra.
Qed.

Lemma G_right_end : 0 < G r (r + / r) n.
Proof.
  pose proof (U_pos_beyond n n_in (r + / r) n right_end_beyond ltac:(lia)) as HU. rewrite <- b_G by (assumption || lra).
  assert (E : - r * (r + / r) = - (r ^ 2 + 1)) by (field; lra).
  destruct (region5_signs (- r * (r + / r)) (r ^ 2) n) as (_ & Hb & _); [nra | lia | tauto |].
  specialize (Hb (n - 2)%nat ltac:(lia)); cbn beta in Hb.
  apply Rmult_lt_0_compat; [lra|]; apply Rmult_lt_0_compat; [nra | assumption].
Qed.

(** The sign change of G, and that of b. *)
Lemma G_root : exists Xs, c0 < Xs < r + / r /\ G r Xs n = 0 /\ forall X, c0 < X -> (0 < G r X n <-> Xs < X).
Proof.
  pose proof right_end_beyond; pose proof G_right_end as HR. pose proof (G_left_end n n_in r r_in) as HL.
  destruct (IVT _ _ _ (continuity_G r n) H HL HR) as (Xs & [H1 H2] & E).
  assert (Xs <> c0) by (intros ->; lra); assert (Xs <> r + / r) by (intros ->; lra).
  exists Xs; split; [lra | split; [assumption|]]; intros X HX; split; intros HG.
  - apply Rnot_le_lt; intros [Hlt | ->]; [|lra].
    pose proof (G_once n n_in r X Xs r_in n_odd ltac:(lra) ltac:(lra)); lra.
  - apply (G_once n n_in r Xs X r_in n_odd); lra.
Qed.

Lemma b_sign_G X : c0 < X -> (b (- r * X) (r ^ 2) n (n - 2) > 0 <-> 0 < G r X n) /\
  (b (- r * X) (r ^ 2) n (n - 2) = 0 <-> G r X n = 0).
Proof.
  intros HX; pose proof (U_pos_beyond n n_in X n HX ltac:(lia)) as HU.
  assert (Hm : 0 < r ^ 2 * U X n) by (apply Rmult_lt_0_compat; nra). rewrite <- (b_G n n_in r X) by (assumption || lra).
  split; split; intros; nra.
Qed.

(** b_{n,n-2} decides in region 3 too. *)
Lemma decides_region3 s : (1 - 1 / INR n) / 2 < s < 1 / 2 ->
  u_at r s n <> 0 /\ decides (trace r s) (r ^ 2) n (n - 2) Minus.
Proof.
  intros Hs; destruct n_odd as [h Hh]. assert (HN : 3 <= INR n) by (apply le_INR in n_in; cbn [INR] in n_in; lra).
  assert (En : INR n = 2 * INR h + 1) by (rewrite Hh, plus_INR, mult_INR; cbn [INR]; ring).
  assert (Hns : INR h < INR n * s < INR n / 2).
  { assert ((1 - 1 / INR n) / 2 * INR n = INR h) by (rewrite En; field; lra). split; nra. }
  assert (Hc : c0 < - 2 * cos (2 * PI * s)).
  { unfold left_end; pose proof PI_RGT_0; destruct (angle n n_in) as [Ha E].
    enough (cos (PI / INR n) < cos (PI - 2 * PI * s)) by (rewrite Rtrigo_facts.cos_pi_minus in *; lra).
    apply cos_decreasing_1; nra. }
  pose proof (U_pos_beyond n n_in _ n Hc ltac:(lia)) as HU.
  assert (Et : trace r s = - r * (-2 * cos (2 * PI * s))) by (unfold trace; ring).
  assert (Hu : u (trace r s) (r ^ 2) n <> 0).
  { rewrite Et, Hh, u_odd by lra; rewrite <- Hh. pose proof (pow_lt r (2 * h) ltac:(lra)); nra. }
  assert (Hcell : cell r s n h).
  { assert (0 < s) by (pose proof (pos_INR h); nra).
    split; [lra | split; [lra | split; [assumption | apply Rabs_def1; lra]]]. }
  pose proof (last_neighbours h ltac:(lia)) as Hn; rewrite <- Hh in Hn; split; [assumption|].
  apply (S3_stated r s n h (Build_Farey _ _ _ _ _ _ Hn)); trivial; lia || lra.
Qed.
End Section_.

Theorem S5_section : S5_section_statement.
Proof.
  intros a2 n H2 Hn Ho; destruct (sqrt_square a2 ltac:(lra)) as [Hr Er].
  set (r := sqrt a2) in *; assert (r_in : 0 < r < 1) by (split; [|apply Rnot_le_lt; intros ?]; nra).
  assert (E2 : a2 = r ^ 2) by lra. assert (HN : 3 <= INR n) by (apply le_INR in Hn; cbn [INR] in Hn; lra).
  assert (Hs : 0 < (1 - 1 / INR n) / 2 < 1 / 2).
  { assert (0 < 1 / INR n <= 1 / 3); [|lra]. split; [apply Rdiv_lt_0_compat; lra|].
    apply Rmult_le_reg_r with (3 * INR n); [lra|]; field_simplify; lra. }
  assert (ET : trace r ((1 - 1 / INR n) / 2) = - r * left_end n).
  { unfold trace, left_end. replace (2 * PI * ((1 - 1 / INR n) / 2)) with (PI - PI / INR n) by (field; lra).
    rewrite Rtrigo_facts.cos_pi_minus; ring. }
  destruct (G_root r n r_in Hn Ho) as (Xs & HXs & E0 & Hsign).
  assert (Eend : - (a2 + 1) = - r * (r + / r)) by (rewrite E2; field; lra).
  exists (- r * Xs); rewrite ET, Eend; split; [split; nra |].
  intros a1 Ha; assert (Ea : a1 = - r * (- a1 / r)) by (field; lra). set (X := - a1 / r) in *; clearbody X; subst a1.
  assert (HX : left_end n < X) by nra.
  assert (HD : u (- r * X) a2 n <> 0 /\ decides (- r * X) a2 n (n - 2) Minus).
  { destruct (Rle_lt_dec (- r * X) (- 2 * r)) as [H4|H3].
    - destruct (S5 (- r * X) a2 n) as (_ & _ & H); [lra|fold r; lra|]; apply (H Hn Ho).
    - destruct (turn_of_cosine (- X / 2)) as (s & Hss & Ec).
      { pose proof (left_end_pos n Hn); split; nra. }
      assert (Et : - r * X = trace r s) by (unfold trace; rewrite Ec; field).
      rewrite Et, E2; apply (decides_region3 r n r_in Hn Ho s). split; [|lra].
      apply Rnot_le_lt; intros Hle; pose proof (two_pi_s s Hss); pose proof PI_RGT_0. pose proof (two_pi_s _ Hs).
      assert (cos (2 * PI * ((1 - 1 / INR n) / 2)) <= cos (2 * PI * s)) by (apply cos_decr_1; try lra;
        apply Rmult_le_compat_l; lra).
      unfold trace in *; nra. }
  destruct (b_sign_G r n r_in Hn Ho X HX) as [Sp S0]; rewrite <- E2 in Sp, S0.
  destruct HD as [Hu HD]; split; [exact Hu|split; [exact HD|split]].
  - rewrite Sp, (Hsign X HX); split; intros; nra.
  - rewrite S0; split; intros H0.
    + assert (X = Xs) as -> by (apply (Rmult_eq_reg_l (- r)); lra); assumption.
    + destruct (Rtotal_order X Xs) as [H|[->|H]]; [exfalso|reflexivity|exfalso].
      * pose proof (G_once n Hn r X Xs r_in Ho ltac:(lra) ltac:(lra)); lra.
      * apply (Hsign X HX) in H; lra.
Qed.

Theorem Joined : Joined_statement.
Proof.
  intros a2 n H2 Hn Ho. destruct (S5_section a2 n H2 Hn Ho) as (a1s & Ha & H).
  destruct (H a1s Ha) as (Hus & _ & _ & Es).
  exists a1s; split; [assumption | split; [assumption | split; [apply Es; reflexivity |]]].
  intros a1 HT; destruct (Rlt_le_dec (- (a2 + 1)) a1) as [Hl|Hl].
  - destruct (H a1 ltac:(lra)) as (_ & HD & Hp & _); rewrite Hp.
    apply decides_iff in HD; rewrite (HD Plus Minus); tauto.
  - destruct (region5_signs a1 a2 n ltac:(lra) ltac:(lia)) as (_ & _ & _ & Hex); [destruct Hl; [left | right]; tauto|].
    rewrite (Hex ltac:(lia) Plus Minus); intuition lra.
Qed.
