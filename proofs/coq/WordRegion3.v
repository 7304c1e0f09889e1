(** * Region 3: the path is the Stern-Brocot path to s, and S1-S3 decide along it *)

From Coq Require Import Reals List Arith ZArith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementWords Algebra Polar
  Coordinates Farey Disc Radius Count InsideTriangle WordAlgebra WordPath WordGraph.
Import ListNotations.
Open Scope R_scope.

Section Region3.
Variables r s : R.
Hypothesis r_in : 0 < r <= 1.
Hypothesis s_in : 0 < s < 1 / 2.
Notation a1 := (trace r s).
Notation a2 := (r ^ 2).
Notation u := (u a1 a2).

(** u_k has the sign of sin (2 pi (k s - m)). *)
Lemma u_sine k m : exists t, 0 < t /\ u k * t = sin (2 * PI * (INR k * s - INR m)).
Proof.
  pose proof (two_pi_s s s_in) as Hth. assert (Hsin : sin (2 * PI * s) > 0) by (apply sin_gt_0; lra).
  pose proof (u_polar r (2 * PI * s) k) as E; fold (trace r s) in E.
  rewrite (sin_turns (INR k * (2 * PI * s)) (2 * PI * (INR k * s - INR m)) m) in E by ring.
  pose proof (pow_lt r k ltac:(lra)). exists (r * sin (2 * PI * s) / r ^ k); split.
  - apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra.
  - unfold Rdiv; rewrite <- Rmult_assoc, E; field; lra.
Qed.

Lemma u_sign k m : Rabs (INR k * s - INR m) < 1 / 2 ->
  (0 < u k <-> INR m < s * INR k) /\ (u k < 0 <-> s * INR k < INR m).
Proof.
  intros Hm; apply Rabs_def2 in Hm; destruct (u_sine k m) as (t & Ht & E); pose proof PI_RGT_0.
  set (x := INR k * s - INR m) in *.
  assert (Hp : 0 < x -> 0 < u k).
  { intros; assert (0 < sin (2 * PI * x)) by (apply sin_gt_0; nra); nra. }
  assert (Hn : x < 0 -> u k < 0).
  { intros; assert (sin (2 * PI * x) < 0) by (apply sin_lt_0_var; nra); nra. }
  assert (Hz : x = 0 -> u k = 0).
  { intros E0; rewrite E0, Rmult_0_r, sin_0 in E; apply (zero_factor _ t); lra. }
  unfold x in *; destruct (Rtotal_order (INR k * s - INR m) 0) as [Hx|[Hx|Hx]]; specialize (Hp) ;
    [specialize (Hn Hx)|specialize (Hz Hx)|specialize (Hp Hx)]; lra.
Qed.

Lemma trace_in : 0 < a2 <= 1 /\ - (a2 + 1) < a1 < 2 * sqrt a2.
Proof.
  pose proof (two_pi_s s s_in); pose proof PI_RGT_0; rewrite sqrt_pow2 by lra.
  assert (-1 < cos (2 * PI * s)) by (rewrite <- cos_PI; apply cos_decreasing_1; lra).
  assert (cos (2 * PI * s) < 1) by (rewrite <- cos_0; apply cos_decreasing_1; lra).
  unfold trace; pose proof (pow2_ge_0 (1 - r)); split; nra.
Qed.

(** ** K *)

Definition next_half (K : nat) : Prop := 2 * (INR K - 1) * s <= 1 < 2 * INR K * s.

Lemma next_half_exists : exists K, next_half K.
Proof.
  destruct (archimed (1 / (2 * s))) as [H1 H2]; set (l := up (1 / (2 * s))) in *.
  assert (E : 1 / (2 * s) * (2 * s) = 1) by (field; lra). assert (0 < 1 / (2 * s)) by (apply Rdiv_lt_0_compat; lra).
  assert (Hl : (0 < l)%Z) by (apply lt_IZR; lra).
  exists (Z.to_nat l); unfold next_half; rewrite INR_IZR_INZ, Z2Nat.id by lia.
  set (x := IZR l) in *; set (y := 1 / (2 * s)) in *; split; nra.
Qed.

Lemma next_half_first K : next_half K -> first_upper a1 a2 K.
Proof.
  intros [H1 H2]; destruct trace_in as [Ha2 Ha1]. refine (conj Ha2 (conj Ha1 (conj _ _))).
  - assert (Hd : Rabs (INR K * s - INR 1) < 1 / 2) by (apply Rabs_def1; cbn [INR]; lra).
    apply (proj2 (u_sign K 1 Hd)); cbn [INR]; lra.
  - intros k Hk; apply le_INR in Hk; rewrite S_INR in Hk; pose proof (pos_INR k).
    destruct (u_sine k 0) as (t & Ht & E); cbn [INR] in E; rewrite Rminus_0_r in E.
    assert (Hks : 0 <= INR k * s <= 1 / 2) by (split; nra); pose proof PI_RGT_0.
    set (x := INR k * s) in *; clearbody x; clear - Hks Ht E H0.
    assert (0 <= sin (2 * PI * x)) by (apply sin_ge_0; nra). apply Rnot_lt_le; intros ?; nra.
Qed.

Lemma first_next_half K : first_upper a1 a2 K -> next_half K.
Proof.
  intros H; destruct next_half_exists as (L & HL); pose proof (next_half_first L HL) as H'.
  enough (K = L) by (subst; assumption). destruct H as (_ & _ & HK & Hk), H' as (_ & _ & HK' & Hk'); cbn [on] in *.
  destruct (lt_eq_lt_dec K L) as [[Hlt|]|Hlt]; [|assumption|]; exfalso; [specialize (Hk' K Hlt) |
    specialize (Hk L Hlt)]; lra.
Qed.

(** ** The path *)

Section Path.
Variable K : nat.
Hypothesis half : next_half K.

Lemma K_s_below_1 : INR K * s < 1. Proof. destruct half; lra. Qed.

Lemma stern_facts w m1 n1 m2 n2 : stern s K w m1 n1 m2 n2 -> (m2 * n1 = m1 * n2 + 1)%nat /\ (1 <= n1)%nat /\
  (K <= n2)%nat /\ (1 <= m2)%nat /\ INR m1 < s * INR n1 /\ s * INR n2 < INR m2.
Proof.
  induction 1 as [|w m1 n1 m2 n2 H (E & ? & ? & ? & ? & ?)|w m1 n1 m2 n2 H (E & ? & ? & ? & ? & ?)].
  - pose proof K_s_below_1; cbn [INR]; repeat split; (lia || lra).
  - repeat split; try lia; assumption.
  - repeat split; try lia; assumption.
Qed.

Lemma stern_distance w m1 n1 m2 n2 : stern s K w m1 n1 m2 n2 -> Rabs (INR (n1 + n2) * s - INR (m1 + m2)) < 1 / 2.
Proof.
  intros H; destruct (stern_facts _ _ _ _ _ H) as (E & H1 & H2 & H3 & L1 & L2).
  assert (E' : INR m2 * INR n1 = INR m1 * INR n2 + 1) by (rewrite <- !mult_INR, E, plus_INR; reflexivity).
  destruct half as [_ HK]; apply le_INR in H2. assert (G2 : 1 < INR n2) by nra.
  assert (G2' : 2 <= INR n2) by (apply (le_INR 2), INR_lt; cbn [INR]; lra).
  rewrite !plus_INR; set (x := s * INR n1 - INR m1); set (y := INR m2 - s * INR n2).
  assert (Exy : INR n2 * x + INR n1 * y = 1) by (unfold x, y; lra).
  assert (0 < x) by (unfold x; lra); assert (0 < y) by (unfold y; lra).
  assert (G1 : 0 < INR n1) by (apply lt_0_INR; assumption).
  replace ((INR n1 + INR n2) * s - (INR m1 + INR m2)) with (x - y) by (unfold x, y; ring).
  assert (2 * x <= INR n2 * x) by (apply Rmult_le_compat_r; lra).
  assert (0 < INR n2 * x) by (apply Rmult_lt_0_compat; lra). assert (0 < INR n1 * y) by (apply Rmult_lt_0_compat; lra).
  apply Rabs_def1; [lra|]; destruct (Nat.eq_dec n1 1) as [->|Hn].
  - assert (m1 = 0)%nat as ->.
    { destruct m1 as [|m1]; [reflexivity|exfalso]; rewrite S_INR in L1; cbn [INR] in L1. pose proof (pos_INR m1); lra. }
    assert (m2 = 1)%nat as -> by lia. assert (INR K * s <= INR n2 * s) by (apply Rmult_le_compat_r; lra).
    unfold x, y; cbn [INR] in *; lra.
  - assert (2 <= INR n1) by (apply (le_INR 2); lia).
    assert (2 * y <= INR n1 * y) by (apply Rmult_le_compat_r; lra); lra.
Qed.

Lemma stern_on w m1 n1 m2 n2 : stern s K w m1 n1 m2 n2 -> (on a1 a2 (n1 + n2) D <-> INR (m1 + m2) < s * INR (n1 + n2))
  /\ (on a1 a2 (n1 + n2) U <-> s * INR (n1 + n2) < INR (m1 + m2)).
Proof. intros H; apply u_sign, (stern_distance w), H. Qed.

Lemma path_stern w n1 n2 : path a1 a2 K w n1 n2 <-> exists m1 m2, stern s K w m1 n1 m2 n2.
Proof.
  split.
  - induction 1 as [|w i j H (m1 & m2 & IH) Hon|w i j H (m1 & m2 & IH) Hon].
    + exists 0%nat, 1%nat; constructor.
    + exists (m1 + m2)%nat, m2; constructor; [|apply (stern_on w)]; assumption.
    + exists m1, (m1 + m2)%nat; constructor; [|apply (stern_on w)]; assumption.
  - intros (m1 & m2 & H); induction H as [|w m1 n1 m2 n2 H IH Hlt|w m1 n1 m2 n2 H IH Hlt]; constructor; trivial;
      apply (stern_on w _ _ _ _ H), Hlt.
Qed.

(** Every pair of the Farey tree around s is on the path, or precedes 1/K. *)
Lemma adjacent_stern m1 n1 m2 n2 : adjacent m1 n1 m2 n2 -> INR m1 < s * INR n1 -> s * INR n2 < INR m2 -> m1 = 0%nat /\
  n1 = 1%nat /\ m2 = 1%nat /\ (n2 < K)%nat \/ exists w, stern s K w m1 n1 m2 n2.
Proof.
  assert (HK2 : (2 <= K)%nat) by (apply (K_ge_2 a1 a2), next_half_first, half).
  induction 1 as [|m1 n1 m2 n2 H IH|m1 n1 m2 n2 H IH]; intros L1 L2.
  - destruct (Nat.eq_dec K 2) as [E|]; [right; exists []; rewrite <- E; constructor | left; lia].
  - destruct (adjacent_unimodular _ _ _ _ H) as (E & ? & ? & ?).
    assert (E' : INR m2 * INR n1 = INR m1 * INR n2 + 1) by (rewrite <- !mult_INR, E, plus_INR; reflexivity).
    assert (P1 : 0 < INR n1) by (apply lt_0_INR; lia); assert (P2 : 0 < INR n2) by (apply lt_0_INR; lia).
    assert (s * INR n2 < INR m2).
    { rewrite !plus_INR in L2; apply (Rmult_lt_reg_r (INR n1 + INR n2)); [lra|].
      assert (s * (INR n1 + INR n2) * INR n2 < (INR m1 + INR m2) * INR n2) by (apply Rmult_lt_compat_r; lra); lra. }
    destruct IH as [(-> & -> & -> & Hlt)|(w & Hw)]; trivial.
    + destruct (Nat.eq_dec (1 + n2) K) as [HK|]; [right; exists []; rewrite <- HK; constructor | left; lia].
    + right; exists (w ++ [U]); constructor; assumption.
  - destruct (adjacent_unimodular _ _ _ _ H) as (E & ? & ? & ?).
    assert (E' : INR m2 * INR n1 = INR m1 * INR n2 + 1) by (rewrite <- !mult_INR, E, plus_INR; reflexivity).
    assert (P1 : 0 < INR n1) by (apply lt_0_INR; lia); assert (P2 : 0 < INR n2) by (apply lt_0_INR; lia).
    assert (INR m1 < s * INR n1).
    { rewrite !plus_INR in L1; apply (Rmult_lt_reg_r (INR n1 + INR n2)); [lra|].
      assert ((INR m1 + INR m2) * INR n1 < s * (INR n1 + INR n2) * INR n1) by (apply Rmult_lt_compat_r; lra); lra. }
    destruct IH as [(-> & -> & -> & Hlt)|(w & Hw)]; trivial.
    + exfalso; rewrite !plus_INR in L1; cbn [INR] in L1; apply le_INR in Hlt; rewrite S_INR in Hlt.
      pose proof K_s_below_1. assert (s * (INR n2 + 1) <= s * INR K) by (apply Rmult_le_compat_l; lra); lra.
    + right; exists (w ++ [D]); constructor; assumption.
Qed.

Lemma V_on_path n : member a1 a2 Plus n -> n = 1%nat \/ n = K \/ exists w i j, path a1 a2 K w i j /\ n = (i + j)%nat.
Proof.
  intros HV; pose proof (next_half_first K half) as first; pose proof HV as [Hu Hb].
  pose proof (u_nonzero_pos a1 a2 n Hu); pose proof (K_upper a1 a2 K first) as HK.
  destruct (Nat.eq_dec n 1) as [|Hn1]; [tauto|]; destruct (Nat.eq_dec n 2) as [->|Hn2].
  - right; left; destruct (Rdichotomy _ _ Hu) as [Hs|Hs].
    + destruct (lt_eq_lt_dec 2 K) as [[Hlt|]|Hlt]; [|assumption|].
      * pose proof (proj2 (proj2 (proj2 first)) 2%nat Hlt); lra.
      * pose proof (K_ge_2 a1 a2 K first); lia.
    + exfalso; specialize (Hb 1%nat ltac:(lia)); cbn [sgn] in Hb.
      pose proof (b_N a1 a2 2 1 Hu) as E; unfold N in E; cbn [Nat.sub] in E.
      rewrite u_2, u_1 in *; pose proof (a1_in a1 a2 K first) as HA; apply Rabs_def2 in HA; nra.
  - assert (Hn : (3 <= n)%nat) by lia.
    assert (exists g, orbit a1 a2 n Plus g) as [g Ho].
    { destruct (Rdichotomy _ _ Hu) as [Hs|Hs]; eexists; [apply (orbit_on a1 a2 K first U n Hs) |
        apply (orbit_on a1 a2 K first D n Hs)]; assumption. }
    destruct (orbit_in_interval n r s Plus g Hn r_in s_in Ho) as (lo & hi & HI & Hlo).
    assert (exists m mp np mm nm, (0 < 2 * m < n)%nat /\ neighbours m n mp np mm nm /\ INR mp < s * INR np /\
      s * INR nm < INR mm /\ (m = 1%nat -> 1 < 2 * INR n * s)) as (m & mp & np & mm & nm & Hm & HF & L1 & L2 & H1).
    { assert (HN : 3 <= INR n) by (apply (le_INR 3) in Hn; cbn [INR] in Hn; lra).
      pose proof (view _ _ _ _ _ HI) as HW; inversion HW as [|m mp np mm nm Hm HF|m mp np mm nm Hm HF]; subst;
        exists m, mp, np, mm, nm; destruct (neighbours_R n m mp np mm nm Hn HF) as (E & E' & S & _ & P1 & P2).
      - assert (Hs : s * INR n < INR m).
        { replace (INR m) with (INR m / INR n * INR n) by (field; lra). apply Rmult_lt_compat_r; lra. }
        assert (s * INR nm < INR mm).
        { apply (Rmult_lt_reg_r (INR n)); [lra|].
          assert (s * INR n * INR nm < INR m * INR nm) by (apply Rmult_lt_compat_r; lra); lra. }
        destruct (Nat.eqb_spec m 1) as [->|Hm1].
        + assert (mp = 0)%nat as -> by (destruct HF as (? & ? & _), mp; lia || nia).
          assert (1 < 2 * INR n * s).
          { replace 1 with (1 / (2 * INR n) * (2 * INR n)) by (field; lra).
            rewrite (Rmult_comm (2 * INR n)); apply Rmult_lt_compat_r; lra. }
          assert (0 < s * INR np) by (apply Rmult_lt_0_compat; lra).
          refine (conj Hm (conj HF (conj _ (conj _ _)))); [cbn [INR]; lra | assumption | tauto].
        + assert (INR mp < s * INR np).
          { replace (INR mp) with (INR mp / INR np * INR np) by (field; lra). apply Rmult_lt_compat_r; lra. }
          refine (conj Hm (conj HF (conj _ (conj _ _)))); tauto.
      - assert (Hs : INR m < s * INR n).
        { replace (INR m) with (INR m / INR n * INR n) by (field; lra). apply Rmult_lt_compat_r; lra. }
        assert (s * INR nm < INR mm).
        { replace (INR mm) with (INR mm / INR nm * INR nm) by (field; lra). apply Rmult_lt_compat_r; lra. }
        assert (INR mp < s * INR np).
        { apply (Rmult_lt_reg_r (INR n)); [lra|].
          assert (INR m * INR np < s * INR n * INR np) by (apply Rmult_lt_compat_r; lra); lra. }
        refine (conj Hm (conj HF (conj _ (conj _ _)))); trivial; intros ->; cbn [INR] in *; lra. }
    destruct (proj1 (tree_proof m n mp np mm nm) (conj Hm HF)) as (HA & Em & En).
    destruct (adjacent_stern _ _ _ _ HA L1 L2) as [(-> & -> & -> & Hlt)|(w & Hw)].
    + right; left; specialize (H1 Em); destruct half as [HK1 HK2].
      apply (le_INR (S nm) K) in Hlt; rewrite S_INR in Hlt; rewrite En, plus_INR in H1; cbn [INR] in H1.
      apply INR_eq; rewrite En, plus_INR; cbn [INR]; enough (INR K < INR nm + 2).
      { assert (K <= 1 + nm)%nat; [|assert (1 + nm <= K)%nat].
        - apply Nat.lt_succ_r, INR_lt; rewrite !S_INR; lra.
        - apply INR_le; rewrite S_INR; lra.
        - replace K with (1 + nm)%nat by lia; rewrite S_INR; lra. }
      apply Rnot_le_lt; intros Hle; assert (2 * (INR nm + 1) * s <= 2 * (INR K - 1) * s) by nra; lra.
    + right; right; exists w, np, nm; split; [apply path_stern; eauto | assumption].
Qed.

Lemma stern_cell w m1 n1 m2 n2 : stern s K w m1 n1 m2 n2 -> u (n1 + n2) <> 0 -> cell r s (n1 + n2) (m1 + m2).
Proof. intros H Hu; repeat split; try tauto; apply (stern_distance w), H. Qed.

Lemma stern_neighbours w m1 n1 m2 n2 : stern s K w m1 n1 m2 n2 -> neighbours (m1 + m2) (n1 + n2) m1 n1 m2 n2.
Proof.
  intros H; destruct (stern_facts _ _ _ _ _ H) as (E & ? & ? & ? & _).
  pose proof (K_ge_2 a1 a2 K (next_half_first K half)); unfold neighbours; repeat split; lia.
Qed.

Lemma decided_region3 : decided a1 a2 K.
Proof.
  pose proof (next_half_first K half) as first; pose proof (K_ge_2 a1 a2 K first).
  refine (conj _ (conj _ (conj _ V_on_path))).
  - intros n Hn Hu; pose proof (u_nonzero_pos a1 a2 n Hu). destruct (Nat.eq_dec n 1) as [->|]; [apply member_one|].
    assert (Hns : INR n * s <= 1 / 2).
    { destruct half as [H1 _]; apply le_INR in Hn; rewrite S_INR in Hn; nra. }
    assert (INR n * s <> 1 / 2).
    { intros E; apply Hu; destruct (u_sine n 0) as (t & Ht & Et); cbn [INR] in Et.
      replace (2 * PI * (INR n * s - 0)) with PI in Et by (rewrite E; field).
      rewrite sin_PI in Et; apply (zero_factor _ t); lra. }
    pose proof (pos_INR n).
    assert (Hcell : cell r s n 0).
    { repeat split; try tauto; cbn [INR]; rewrite Rminus_0_r; apply Rabs_def1; nra. }
    apply (proj1 (orbit_member_edge a1 a2 Minus Plus n)), (S1_stated r s n ltac:(lia) Hcell).
  - intros w i j Hp Hon Hb; apply path_stern in Hp as (m1 & m2 & Hw).
    destruct (stern_facts _ _ _ _ _ Hw) as (_ & ? & ? & ? & _).
    pose proof (stern_cell _ _ _ _ _ Hw (on_nonzero a1 a2 _ U Hon)) as Hcell.
    destruct (S3_stated r s _ _ (Build_Farey _ _ _ _ _ _ (stern_neighbours _ _ _ _ _ Hw)) ltac:(lia) ltac:(lia) Hcell)
      as [HS _].
    apply (stern_on w _ _ _ _ Hw) in Hon; destruct (HS ltac:(lra)) as [_ _ Ho _ _].
    apply (proj1 (orbit_member_edge a1 a2 Plus Plus _)), Ho, Hb.
  - intros w i j Hp Hon Hb; apply path_stern in Hp as (m1 & m2 & Hw).
    destruct (stern_facts _ _ _ _ _ Hw) as (_ & ? & ? & ? & _).
    pose proof (stern_cell _ _ _ _ _ Hw (on_nonzero a1 a2 _ D Hon)) as Hcell.
    destruct (S3_stated r s _ _ (Build_Farey _ _ _ _ _ _ (stern_neighbours _ _ _ _ _ Hw)) ltac:(lia) ltac:(lia) Hcell)
      as [_ HS].
    apply (stern_on w _ _ _ _ Hw) in Hon; destruct (HS ltac:(lra)) as [_ _ Ho _ _].
    apply (proj1 (orbit_member_edge a1 a2 Plus Minus _)), Ho, Hb.
Qed.
End Path.
End Region3.
