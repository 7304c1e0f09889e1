(** * First returns across a line: the times are the periods with (52), and one more if r > 1: ../returns.md *)

From Coq Require Import Reals List Arith Lra Lia Wf_nat Classical.
From Grazing Require Import Defs Statement StatementPlane StatementWords StatementReturns Algebra Polar Coordinates
  Radius WordAlgebra WordPath WordFinite WordRegion3 ReturnAlgebra Reverse.
Import ListNotations. Open Scope R_scope.

(** ** Along the path *)

Section Path.
Variables r s : R.
Hypothesis r_pos : 0 < r.
Hypothesis s_in : 0 < s < 1 / 2.
Notation a1 := (trace r s).
Notation a2 := (r ^ 2).
Notation u := (u a1 a2).
Notation p := (p a1 a2).
Notation q := (q a1 a2).
Notation g := (g a1 a2).
Notation time := (time a1 a2).
Notation member := (member a1 a2 Plus).

Lemma sin_pos : 0 < sin (2 * PI * s). Proof. pose proof (two_pi_s s s_in); apply sin_gt_0; lra. Qed.

Lemma complex_here : a1 ^ 2 < 4 * a2.
Proof.
  pose proof sin_pos as HS; pose proof (sin2_cos2 (2 * PI * s)) as E; unfold Rsqr in E; unfold trace.
  set (S := sin (2 * PI * s)) in *; set (C := cos (2 * PI * s)) in *.
  assert (0 < r ^ 2 * (S * S)) by (apply Rmult_lt_0_compat; [apply pow_lt, r_pos | apply Rmult_lt_0_compat;
    assumption]).
  replace ((2 * r * C) ^ 2) with (4 * (r ^ 2 * (C * C))) by ring; replace (C * C) with (1 - S * S) by lra; lra.
Qed.

(** At an angle x from 2 pi m after k steps. *)
Lemma u_angle k m (x := 2 * PI * (INR k * s - INR m)) :
  (exists t, 0 < t /\ u k * t = sin x) /\ u (S k) * sin (2 * PI * s) = r ^ k * sin (x + 2 * PI * s).
Proof.
  pose proof sin_pos as HS; pose proof (pow_lt r k r_pos).
  pose proof (u_polar r (2 * PI * s) k) as E; pose proof (u_polar r (2 * PI * s) (S k)) as E'; fold a1 in E, E'.
  rewrite (sin_turns (INR k * (2 * PI * s)) x m) in E by (unfold x; ring).
  rewrite (sin_turns (INR (S k) * (2 * PI * s)) (x + 2 * PI * s) m) in E' by (unfold x; rewrite S_INR; ring). split.
  - exists (r * sin (2 * PI * s) / r ^ k); split; [apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra|].
    unfold Rdiv; rewrite <- Rmult_assoc, E; field; lra.
  - apply (Rmult_eq_reg_l r); [|lra].
    transitivity (u (S k) * (r * sin (2 * PI * s))); [ring | rewrite E'; cbn [pow]; ring].
Qed.

(** The sign of u_k within half a turn of m turns, and its next where it vanishes. *)
Lemma side_of k m : Rabs (INR k * s - INR m) < 1 / 2 -> (INR m < INR k * s -> 0 < u k) /\ (INR k * s < INR m -> u k < 0)
  /\ (INR k * s = INR m -> u k = 0 /\ u (S k) = r ^ k).
Proof.
  intros Hm; apply Rabs_def2 in Hm; destruct (u_angle k m) as [(t & Ht & E) E']; pose proof PI_RGT_0;
    pose proof sin_pos.
  split; [|split]; intros Hk.
  - assert (0 < sin (2 * PI * (INR k * s - INR m))) by (apply sin_gt_0; nra); nra.
  - assert (sin (2 * PI * (INR k * s - INR m)) < 0) by (apply sin_lt_0_var; nra); nra.
  - rewrite Hk, Rminus_diag_eq, Rmult_0_r in * by reflexivity; rewrite sin_0 in E; rewrite Rplus_0_l in E'.
    split; [|apply (Rmult_eq_reg_r (sin (2 * PI * s))); lra]. destruct (Rmult_integral _ _ E); lra.
Qed.

(** Half a turn: u_k = 0, and the point is on the other side of 0. *)
Lemma half_turn k m : INR k * s = INR m + 1 / 2 -> u k = 0 /\ u (S k) < 0.
Proof.
  intros Hk; destruct (u_angle k m) as [(t & Ht & E) E']; pose proof sin_pos; pose proof (pow_lt r k r_pos).
  replace (2 * PI * (INR k * s - INR m)) with PI in * by (rewrite Hk; field).
  rewrite sin_PI in E; rewrite Rplus_comm, neg_sin in E'; split; [destruct (Rmult_integral _ _ E); lra | nra].
Qed.

(** The nearest number of turns; not half a turn for a time, nor where u_k = 0 < u_{k+1}. *)
Lemma nearest k : (exists y, 0 < g y k) -> exists m, Rabs (INR k * s - INR m) < 1 / 2.
Proof.
  intros (y & Hy); destruct (archimed (INR k * s - 1 / 2)) as [H1 H2]; pose proof (pos_INR k).
  assert (0 <= INR k * s) by nra; set (z := up (INR k * s - 1 / 2)) in *.
  assert (Hz : (-1 < z)%Z) by (apply lt_IZR; lra); assert (E : INR (Z.to_nat z) = IZR z) by (rewrite INR_IZR_INZ,
    Z2Nat.id; [reflexivity | lia]).
  exists (Z.to_nat z); rewrite E; apply Rabs_def1; [lra|]; apply Rnot_le_lt; intros Hle.
  destruct (half_turn k (Z.to_nat (z - 1))) as [E0 E1].
  { assert (0 < z)%Z by (apply lt_IZR; lra); rewrite (INR_IZR_INZ (Z.to_nat _)), Z2Nat.id, minus_IZR by lia; lra. }
  unfold ReturnAlgebra.g in Hy; rewrite E0 in Hy; lra.
Qed.

Lemma time_nearest n : time n -> exists m, Rabs (INR n * s - INR m) < 1 / 2.
Proof. intros [_ (y & Hy & _)]; apply nearest; exists y; lra. Qed.

Variable K : nat.
Hypothesis half : next_half s K.

Lemma K_2 : (2 <= K)%nat.
Proof. destruct half as [_ H]; destruct K as [|[|k]]; cbn [INR] in H; [lra | lra | lia]. Qed.
Lemma side_K : u K < 0. Proof. destruct half; apply (side_of K 1); [apply Rabs_def1 | ]; cbn [INR]; lra. Qed.

Lemma before_K k : (k < K)%nat -> 0 <= u k /\ ((1 <= k)%nat -> u k = 0 -> u (S k) < 0).
Proof.
  intros Hk; apply le_INR in Hk; rewrite S_INR in Hk; destruct half as [H1 H2]; pose proof (pos_INR k).
  destruct (Rle_lt_or_eq_dec (INR k * s) (1 / 2) ltac:(nra)) as [Hlt|E].
  - destruct (Nat.eq_dec k 0) as [->|H0]; [rewrite u_0; split; [lra | lia]|].
    assert (1 <= INR k) by (apply (le_INR 1); lia).
    assert (0 < u k) by (apply (side_of k 0); [apply Rabs_def1|]; cbn [INR]; nra); split; [lra | intros _ ?; lra].
  - destruct (half_turn k 0) as [E0 E1]; [cbn [INR]; lra|]; rewrite E0; split; [lra | intros; assumption].
Qed.

Lemma member_1 : member 1. Proof. split; [rewrite u_1; lra | intros; lia]. Qed.

Lemma member_first : member K.
Proof.
  pose proof side_K as HK; split; [lra|]; intros k Hk; cbn [sgn]; rewrite Rmult_1_l.
  destruct (before_K k ltac:(lia)) as [H1 _], (before_K (K - k) ltac:(lia)) as [H2 _].
  pose proof (pow_lt a2 k ltac:(apply pow_lt, r_pos)); pose proof (b_N a1 a2 K k ltac:(lra)) as E; unfold N in E.
  assert (0 <= a2 ^ k * u (K - k)) by (apply Rmult_le_pos; lra); nra.
Qed.

Lemma time_between n : time n -> (n <= K)%nat -> n = 1%nat \/ n = K.
Proof.
  intros [H1 (y & Hy & Hk)] Hn; destruct (Nat.eq_dec n 1) as [|N1]; [tauto|]; destruct (Nat.eq_dec n K) as [|NK];
    [tauto|].
  exfalso; destruct (before_K n ltac:(lia)) as [Hu H0]; destruct (before_K (n - 1) ltac:(lia)) as [Hv Hv0].
  destruct (Req_dec (u n) 0) as [E|E].
  - specialize (H0 ltac:(lia) E); unfold ReturnAlgebra.g in Hy; rewrite E in Hy; lra.
  - assert (0 < u n) by (destruct (Rle_lt_or_eq_dec _ _ Hu); [assumption | congruence]).
    assert (0 < u (n - 1)).
    { destruct (Rle_lt_or_eq_dec _ _ Hv) as [|E']; [assumption|]; specialize (Hv0 ltac:(lia) (eq_sym E')).
      replace (S (n - 1)) with n in Hv0 by lia; lra. }
    pose proof (no_split a1 a2 complex_here 1 y 1 (n - 1)) as HS; replace (1 + (n - 1))%nat with n in HS by lia.
    rewrite u_1 in HS; specialize (HS ltac:(tauto) ltac:(lra) ltac:(lra) ltac:(lra) (Hk 1%nat ltac:(lia))
      (Hk (n - 1)%nat ltac:(lia))); lra.
Qed.

Lemma nonpos_nonneg x y : x <= 0 -> 0 <= y -> x * y <= 0. Proof. intros; nra. Qed.
Lemma pos_neg x y : 0 < x -> y < 0 -> x * y < 0. Proof. intros; nra. Qed.
Lemma nonpos_nonpos x y : x <= 0 -> y <= 0 -> 0 <= x * y. Proof. intros; nra. Qed.
Lemma compat_nonpos x y z : z <= 0 -> x <= y -> y * z <= x * z. Proof. intros; nra. Qed.

(** What n1, n2 and a later time have to do with each other: whole numbers a, b with n = a n1 + b n2. *)
Section Pair.
Variables (w : list letter) (m1 n1 m2 n2 : nat).
Hypothesis path : stern s K w m1 n1 m2 n2.

Lemma pair_facts : (m2 * n1 = m1 * n2 + 1)%nat /\ (1 <= n1)%nat /\ (K <= n2)%nat /\ (1 <= m2)%nat /\
  INR m1 < INR n1 * s /\ INR n2 * s < INR m2 /\ INR n1 * s - INR m1 < 1 / 2 /\ - (1 / 2) < INR n2 * s - INR m2.
Proof.
  assert (Hd : forall w m1 n1 m2 n2, stern s K w m1 n1 m2 n2 -> Rabs (INR (n1 + n2) * s - INR (m1 + m2)) < 1 / 2)
    by (intros; eapply stern_distance; eassumption).
  assert (Hf : forall w m1 n1 m2 n2, stern s K w m1 n1 m2 n2 -> (m2 * n1 = m1 * n2 + 1)%nat /\ (1 <= n1)%nat /\
    (K <= n2)%nat /\ (1 <= m2)%nat /\ INR m1 < s * INR n1 /\ s * INR n2 < INR m2) by (intros; eapply stern_facts;
    eassumption).
  destruct (Hf _ _ _ _ _ path) as (E & H1 & H2 & H3 & L1 & L2); repeat (split; [assumption || lra|]).
  clear E H1 H2 H3 L1 L2; induction path as [|w' m1 n1 m2 n2 H IH Hlt|w' m1 n1 m2 n2 H IH Hlt]; cbn [INR].
  - destruct half; lra.
  - pose proof (Rabs_def2 _ _ (Hd _ _ _ _ _ H)); specialize (IH H); lra.
  - pose proof (Rabs_def2 _ _ (Hd _ _ _ _ _ H)); specialize (IH H); lra.
Qed.

Lemma gap n m : (1 <= n)%nat -> Rabs (INR n * s - INR m) < 1 / 2 -> (n1 + n2 <= n)%nat \/ INR n * s <> INR m /\
  ((Nat.max n1 n2 < n)%nat -> exists x k l, (x = 1 \/ x = -1) /\ (1 <= k)%nat /\ (1 <= l)%nat /\ n = (k + l)%nat /\
  0 < x * u k /\ 0 < x * u l /\ 0 < x * u (k + l)).
Proof.
  intros Hn Hm; pose proof Hm as Hm'; apply Rabs_def2 in Hm'.
  destruct pair_facts as (E & H1 & H2 & H3 & L1 & L2 & B1 & B2); pose proof K_2.
  set (a := (Z.of_nat m2 * Z.of_nat n - Z.of_nat m * Z.of_nat n2)%Z).
  set (b := (Z.of_nat m * Z.of_nat n1 - Z.of_nat m1 * Z.of_nat n)%Z).
  assert (EZ : (Z.of_nat m2 * Z.of_nat n1 = Z.of_nat m1 * Z.of_nat n2 + 1)%Z) by lia.
  assert (En : (Z.of_nat n = a * Z.of_nat n1 + b * Z.of_nat n2)%Z).
  { transitivity (Z.of_nat n * (Z.of_nat m2 * Z.of_nat n1 - Z.of_nat m1 * Z.of_nat n2))%Z; [rewrite EZ | unfold a, b];
      ring. }
  assert (Em : (Z.of_nat m = a * Z.of_nat m1 + b * Z.of_nat m2)%Z).
  { transitivity (Z.of_nat m * (Z.of_nat m2 * Z.of_nat n1 - Z.of_nat m1 * Z.of_nat n2))%Z; [rewrite EZ | unfold a, b];
      ring. }
  assert (Ed : INR n * s - INR m = IZR a * (INR n1 * s - INR m1) + IZR b * (INR n2 * s - INR m2)).
  { apply (f_equal IZR) in En, Em; rewrite plus_IZR, !mult_IZR, <- !INR_IZR_INZ in En, Em; rewrite En, Em; ring. }
  set (d1 := INR n1 * s - INR m1) in *; set (d2 := INR n2 * s - INR m2) in *.
  assert (D1 : 0 < d1) by (unfold d1; lra); assert (D2 : d2 < 0) by (unfold d2; lra).
  assert (Low : forall x y : Z, (x <= 0 -> 0 <= y -> x * y <= 0)%Z) by (intros; apply Z.mul_nonpos_nonneg; assumption).
  assert (Up : forall x y : Z, (1 <= x -> 0 <= y -> y <= x * y)%Z).
  { intros x y Hx Hy; apply (Z.mul_le_mono_nonneg_r 1 x y Hy) in Hx; lia. }
  pose proof (Low a (Z.of_nat n1)) as La; pose proof (Low b (Z.of_nat n2)) as Lb.
  pose proof (Up a (Z.of_nat n1)) as Ua; pose proof (Up b (Z.of_nat n2)) as Ub.
  destruct (Z_le_gt_dec a 0) as [Ha|Ha]; [|destruct (Z_le_gt_dec b 0) as [Hb|Hb]; [|left; lia]].
  - right; assert (Hb : (1 <= b)%Z) by (destruct (Z_le_gt_dec b 0); lia); pose proof (IZR_le _ _ Ha) as RA.
    assert (Xa : IZR a * d1 <= 0) by (apply nonpos_nonneg; lra).
    split; [intros E0; pose proof (IZR_le _ _ Hb); assert (IZR b * d2 < 0) by (apply pos_neg; lra); lra|]; intros Hmax.
    assert (Hb2 : (2 <= b)%Z) by (destruct (Z.eq_dec b 1) as [->|]; lia); apply IZR_le in Hb2.
    assert (Hmm : (m2 < m)%nat).
    { apply Nat2Z.inj_lt, (Z.mul_lt_mono_pos_r (Z.of_nat n2)); [lia|].
      apply Z.lt_le_trans with (Z.of_nat m2 * Z.of_nat n)%Z; [apply Z.mul_lt_mono_pos_l; lia | unfold a in Ha; lia]. }
    exists (-1), n2, (n - n2)%nat; do 3 (split; [tauto || lia|]); split; [lia|].
    replace (n2 + (n - n2))%nat with n by lia.
    assert (Hl : INR (n - n2) * s - INR (m - m2) = INR n * s - INR m - d2) by (rewrite !minus_INR by lia; unfold d2;
      ring).
    assert (Hlt : INR n * s - INR m - d2 < 0).
    { assert (IZR b * d2 <= 2 * d2) by (apply compat_nonpos; lra); lra. }
    assert (u n2 < 0) by (apply (side_of n2 m2); [apply Rabs_def1|]; unfold d2 in *; lra).
    assert (u (n - n2) < 0) by (apply (side_of (n - n2) (m - m2)); [apply Rabs_def1|]; lra).
    assert (u n < 0) by (apply (side_of n m Hm); lra); lra.
  - right; pose proof (IZR_le _ _ Hb) as RB; pose proof (IZR_le 1 a ltac:(lia)) as RA.
    assert (Xb : 0 <= IZR b * d2) by (apply nonpos_nonpos; lra).
    split; [intros E0; assert (0 < IZR a * d1) by (apply Rmult_lt_0_compat; lra); lra|]; intros Hmax.
    assert (Ha2 : (2 <= a)%Z) by (destruct (Z.eq_dec a 1) as [->|]; lia); apply IZR_le in Ha2.
    assert (Hlt : INR n * s - INR m - d1 > 0).
    { assert (2 * d1 <= IZR a * d1) by (apply Rmult_le_compat_r; lra); lra. }
    assert (Hmm : (m1 <= m)%nat).
    { apply Nat.lt_succ_r, INR_lt; rewrite S_INR; unfold d1 in *.
      assert (INR n1 * s <= INR n * s) by (apply Rmult_le_compat_r; [lra | apply le_INR; lia]); lra. }
    exists 1, n1, (n - n1)%nat; do 3 (split; [tauto || lia|]); split; [lia|]. replace (n1 + (n - n1))%nat with n by lia.
    assert (Hl : INR (n - n1) * s - INR (m - m1) = INR n * s - INR m - d1) by (rewrite !minus_INR by lia; unfold d1;
      ring).
    assert (0 < u n1) by (apply (side_of n1 m1); [apply Rabs_def1|]; unfold d1 in *; lra).
    assert (0 < u (n - n1)) by (apply (side_of (n - n1) (m - m1)); [apply Rabs_def1|]; lra).
    assert (0 < u n) by (apply (side_of n m Hm); lra); lra.
Qed.

Lemma time_gap n : time n -> (Nat.max n1 n2 < n)%nat -> (n1 + n2 <= n)%nat.
Proof.
  intros HT Hmax; destruct (time_nearest n HT) as (m & Hm); destruct HT as [Hn (y & Hy & Hk)].
  destruct (gap n m Hn Hm) as [|[_ HS]]; [assumption|exfalso].
  destruct (HS Hmax) as (x & k & l & Hx & Hk1 & Hl1 & -> & Uk & Ul & Un).
  pose proof (no_split a1 a2 complex_here x y k l Hx Uk Ul Un (Hk k ltac:(lia)) (Hk l ltac:(lia))); lra.
Qed.

Lemma resonance k : (1 <= k)%nat -> u k = 0 -> 0 < u (S k) -> (n1 + n2 <= k)%nat.
Proof.
  intros Hk H0 H1; destruct (nearest k) as (m & Hm).
  { exists 0; unfold ReturnAlgebra.g; lra. }
  destruct (gap k m Hk Hm) as [|[Hne _]]; [assumption|exfalso].
  destruct (side_of k m Hm) as (Hp & Hq & _); destruct (Rdichotomy _ _ Hne) as [Hlt|Hlt];
    [specialize (Hq Hlt) | specialize (Hp Hlt)]; lra.
Qed.

(** The points that have not returned by the time max n1 n2 lie between p_{n1} and p_{n2}. *)
Definition left_over : Prop := 0 < u n1 /\ u n2 < 0 /\ p n1 <= p n2 /\
  forall y, (forall k, (1 <= k <= Nat.max n1 n2)%nat -> g y k <= 1) <-> p n1 <= y <= p n2.

Hypothesis points : left_over.
Let n := (n1 + n2)%nat.

(** Nothing happens before the mediant. *)
Lemma before_mediant y k : p n1 <= y <= p n2 -> (1 <= k < n)%nat -> g y k <= 1.
Proof.
  intros Hy Hk; apply Rnot_lt_le; intros Hg; destruct points as (_ & _ & _ & HJ).
  destruct (least a1 a2 y k ltac:(lia) Hg) as (l & Hl & HT & Hgl). destruct (le_lt_dec l (Nat.max n1 n2)) as [Hm|Hm].
  - pose proof (proj2 (HJ y) Hy l ltac:(lia)); lra.
  - pose proof (time_gap l HT Hm); unfold n in *; lia.
Qed.

Lemma mediant_time : time n <-> exists y, p n1 <= y <= p n2 /\ g y n > 1.
Proof.
  destruct points as (_ & _ & _ & HJ); destruct pair_facts as (_ & H1 & H2 & _); pose proof K_2; split.
  - intros [_ (y & Hy & Hk)]; exists y; split; [|assumption]; apply HJ; intros k Hk'; apply Hk; unfold n; lia.
  - intros (y & Hy & Hg); split; [unfold n; lia|]; exists y; split; [assumption|]; intros k Hk; apply before_mediant;
      assumption.
Qed.

Lemma mediant_side : (0 < u n -> (time n <-> p n1 < p n)) /\ (u n < 0 -> (time n <-> p n < p n2)) /\
  (u n = 0 -> (time n <-> 1 < u (S n))).
Proof.
  destruct points as (_ & _ & Hp & _); rewrite mediant_time; split; [|split]; intros Hu; split.
  - intros (y & Hy & Hg); rewrite g_p in Hg by lra; nra.
  - intros Hlt; exists (p n1); rewrite g_p by lra; split; [lra | nra].
  - intros (y & Hy & Hg); rewrite g_p in Hg by lra; nra.
  - intros Hlt; exists (p n2); rewrite g_p by lra; split; [lra | nra].
  - intros (y & Hy & Hg); unfold ReturnAlgebra.g in Hg; rewrite Hu in Hg; lra.
  - intros Hlt; exists (p n1); unfold ReturnAlgebra.g; rewrite Hu; split; lra.
Qed.

Lemma mediant_member : member n <-> u n <> 0 /\ p n1 < p n < p n2.
Proof.
  destruct points as (D1 & U2 & Hp & HJ); destruct pair_facts as (_ & H1 & H2 & _); pose proof K_2 as HK2.
  rewrite member_g; split; intros [Hu H]; (split; [assumption|]).
  - pose proof (H n1 ltac:(unfold n; lia)) as G1; pose proof (H n2 ltac:(unfold n; lia)) as G2.
    rewrite g_p in G1, G2 by lra; split; nra.
  - intros k Hk; destruct (before_mediant (p n) k ltac:(lra) Hk) as [|E]; [assumption|exfalso].
    destruct (Rtotal_order (u k) 0) as [Hs|[Hs|Hs]].
    + pose proof (before_mediant (p n2) k ltac:(lra) Hk) as G; rewrite g_p in E, G by lra; nra.
    + unfold ReturnAlgebra.g in E; rewrite Hs in E; pose proof (resonance k ltac:(lia) Hs ltac:(lra)); unfold n in *;
        lia.
    + pose proof (before_mediant (p n1) k ltac:(lra) Hk) as G; rewrite g_p in E, G by lra; nra.
Qed.

(** If the mediant is no time, there is none after it. *)
Lemma no_later k : ~ time n -> (Nat.max n1 n2 < k)%nat -> ~ time k.
Proof.
  intros Hno; induction k as [k IH] using lt_wf_ind; intros Hk HT; destruct points as (D1 & U2 & Hp & HJ).
  pose proof (time_gap k HT Hk) as Hnk; assert (k <> n) by (intros ->; tauto).
  destruct pair_facts as (_ & H1 & H2 & _); pose proof K_2.
  assert (Quiet : forall y l, p n1 <= y <= p n2 -> (1 <= l < k)%nat -> g y l <= 1).
  { intros y l Hy Hl; apply Rnot_lt_le; intros Hg. destruct (least a1 a2 y l ltac:(lia) Hg) as (l' & Hl' & HT' & Hg').
    destruct (le_lt_dec l' (Nat.max n1 n2)) as [Hm|Hm].
    - pose proof (proj2 (HJ y) Hy l' ltac:(lia)); lra.
    - apply (IH l'); assumption || lia. }
  assert (Shift : forall i l, (i = n1 \/ i = n2) -> g (p i) k > 1 -> k = (l + i)%nat -> u i <> 0 -> g (q i) l > 1 /\
    (forall l', (1 <= l' < l)%nat -> g (q i) l' <= 1) /\ (q i < p n1 \/ p n2 < q i)).
  { intros i l Hi Hg -> Hui; rewrite (g_shift a1 a2 l i Hui) in Hg.
    assert (Hpi : p n1 <= p i <= p n2) by (destruct Hi; subst; lra). split; [assumption | split].
    - intros l' Hl'; rewrite <- (g_shift a1 a2 l' i Hui); apply Quiet; [assumption | lia].
    - destruct (Rlt_le_dec (q i) (p n1)) as [|L1]; [tauto|]; destruct (Rlt_le_dec (p n2) (q i)) as [|L2]; [tauto|].
      pose proof (Quiet (q i) l ltac:(lra) ltac:(unfold n in *; lia)); lra. }
  destruct HT as [_ (y & Hy & Hyk)].
  assert (HyJ : p n1 <= y <= p n2) by (apply HJ; intros; apply Hyk; unfold n in *; lia).
  assert (Ends : g (p n1) k > 1 \/ g (p n2) k > 1).
  { unfold ReturnAlgebra.g in *; destruct (Rle_or_lt 0 (u k)); [left | right]; nra. }
  destruct Ends as [Hg|Hg].
  - destruct (Shift n1 (k - n1)%nat) as (Hq & Hql & HqJ); [tauto | assumption | unfold n in *; lia | lra|].
    pose proof (p_q a1 a2 complex_here n1 ltac:(lra)); destruct HqJ as [HqJ|HqJ]; [nra|].
    assert (g (q n1) n2 > 1) by (rewrite g_p by lra; nra).
    destruct (le_lt_dec (k - n1) n2) as [|Hlt]; [unfold n in *; lia|]; specialize (Hql n2 ltac:(lia)); lra.
  - destruct (Shift n2 (k - n2)%nat) as (Hq & Hql & HqJ); [tauto | assumption | unfold n in *; lia | lra|].
    pose proof (p_q a1 a2 complex_here n2 ltac:(lra)); destruct HqJ as [HqJ|HqJ]; [|nra].
    assert (g (q n2) n1 > 1) by (rewrite g_p by lra; nra).
    destruct (le_lt_dec (k - n2) n1) as [|Hlt]; [unfold n in *; lia|]; specialize (Hql n1 ltac:(lia)); lra.
Qed.

(** r >= 1: the mediant is always a time, but for a return to the line itself at r = 1. *)
Lemma mediant_time_beyond : 1 <= r -> u n <> 0 \/ 1 < r -> time n.
Proof.
  intros Hr Hor; destruct points as (D1 & U2 & Hp & _); destruct mediant_side as (SD & SU & S0).
  assert (Ha : 1 <= a2) by (rewrite <- (pow1 2); apply pow_incr; lra).
  assert (Hd := stern_distance s s_in K half w m1 n1 m2 n2 path).
  pose proof (q_apart a1 a2 complex_here n1 Ha) as [Q1 _]; pose proof (q_apart a1 a2 complex_here n2 Ha) as [_ Q2].
  pose proof (q_apart a1 a2 complex_here n Ha) as [QD QU]; specialize (Q1 D1); specialize (Q2 U2).
  destruct (Rtotal_order (u n) 0) as [Hs|[Hs|Hs]].
  - apply SU; [assumption|]; apply Rnot_le_lt; intros Hle; specialize (QU Hs).
    pose proof (I2 a1 a2 n n2 ltac:(unfold n; lia) ltac:(lra) ltac:(lra)) as E2.
    pose proof (I3 a1 a2 n n1 ltac:(unfold n; lia) ltac:(lra) ltac:(lra)) as E3.
    replace (n - n1)%nat with n2 in E3 by (unfold n; lia). assert (0 < a2 ^ n1) by (apply pow_lt; lra).
    assert (0 < u n1 * (q n1 - q n)) by (apply Rmult_lt_0_compat; lra).
    assert (b a1 a2 n n2 <= 0) by (rewrite E2; nra); nra.
  - apply S0; [assumption|]; destruct Hor as [|Hr1]; [lra|]. destruct (side_of n (m1 + m2) Hd) as (Hpos & Hneg & Hz).
    destruct (Rtotal_order (INR n * s) (INR (m1 + m2))) as [L|[L|L]]; [specialize (Hneg L); lra | | specialize (Hpos L);
      lra].
    rewrite (proj2 (Hz L)); apply Rlt_pow_R1; [assumption | destruct pair_facts; unfold n; lia].
  - apply SD; [assumption|]; apply Rnot_le_lt; intros Hle; specialize (QD Hs).
    pose proof (I2 a1 a2 n n1 ltac:(unfold n; lia) ltac:(lra) ltac:(lra)) as E2.
    pose proof (I3 a1 a2 n n2 ltac:(unfold n; lia) ltac:(lra) ltac:(lra)) as E3.
    replace (n - n2)%nat with n1 in E3 by (unfold n; lia). assert (0 < a2 ^ n2) by (apply pow_lt; lra).
    assert (0 < - u n2 * (q n - q n2)) by (apply Rmult_lt_0_compat; lra).
    assert (b a1 a2 n n1 <= 0) by (rewrite E2; nra); nra.
Qed.

(** r <= 1: a mediant that is a time is in V. *)
Lemma mediant_time_within : r <= 1 -> time n -> member n.
Proof.
  intros Hr HT; destruct points as (D1 & U2 & Hp & _); destruct mediant_side as (SD & SU & S0).
  assert (Ha : a2 <= 1) by (rewrite <- (pow1 2); apply pow_incr; lra).
  pose proof (p_apart a1 a2 complex_here n1 Ha) as [P1 _]; pose proof (p_apart a1 a2 complex_here n2 Ha) as [_ P2].
  pose proof (p_apart a1 a2 complex_here n Ha) as [PD PU]; specialize (P1 D1); specialize (P2 U2).
  apply mediant_member; destruct (Rtotal_order (u n) 0) as [Hs|[Hs|Hs]].
  - specialize (PU Hs); apply SU in HT; lra.
  - apply S0 in HT; [exfalso | assumption].
    destruct (side_of n (m1 + m2) (stern_distance s s_in K half w m1 n1 m2 n2 path)) as (Hpos & Hneg & Hz).
    destruct (Rtotal_order (INR n * s) (INR (m1 + m2))) as [L|[L|L]]; [specialize (Hneg L); lra | | specialize (Hpos L);
      lra].
    rewrite (proj2 (Hz L)) in HT; pose proof (pow_incr r 1 n ltac:(lra)); rewrite pow1 in *; lra.
  - specialize (PD Hs); apply SD in HT; lra.
Qed.

End Pair.
(** ** From pair to pair *)

Lemma extend_D w m1 n1 m2 n2 : stern s K w m1 n1 m2 n2 -> left_over n1 n2 -> let n := (n1 + n2)%nat in
  0 < u n -> p n1 <= p n <= p n2 -> stern s K (w ++ [D]) (m1 + m2) n m2 n2 /\ left_over n n2.
Proof.
  intros H HL n Hu Hp; destruct (pair_facts w m1 n1 m2 n2 H) as (_ & H1 & H2 & _); pose proof K_2.
  destruct (side_of n (m1 + m2) (stern_distance s s_in K half w m1 n1 m2 n2 H)) as (_ & Hneg & Hz).
  split; [constructor; [assumption|]|].
  - fold n; destruct (Rtotal_order (INR n * s) (INR (m1 + m2))) as [L|[L|L]]; [specialize (Hneg L); lra |
      destruct (Hz L); lra | lra].
  - pose proof HL as (D1 & U2 & _ & HJ); repeat (split; [assumption || lra|]); intros y; split.
    + intros Hy; pose proof (Hy n ltac:(unfold n; lia)) as Hg; rewrite g_p in Hg by lra.
      assert (p n1 <= y <= p n2) by (apply HJ; intros; apply Hy; unfold n; lia); split; nra.
    + intros Hy k Hk; destruct (Nat.eq_dec k n) as [->|]; [rewrite g_p by lra; nra|].
      apply (before_mediant w m1 n1 m2 n2 H HL); [lra | unfold n in *; lia].
Qed.

Lemma extend_U w m1 n1 m2 n2 : stern s K w m1 n1 m2 n2 -> left_over n1 n2 -> let n := (n1 + n2)%nat in
  u n < 0 -> p n1 <= p n <= p n2 -> stern s K (w ++ [U]) m1 n1 (m1 + m2) n /\ left_over n1 n.
Proof.
  intros H HL n Hu Hp; destruct (pair_facts w m1 n1 m2 n2 H) as (_ & H1 & H2 & _); pose proof K_2.
  destruct (side_of n (m1 + m2) (stern_distance s s_in K half w m1 n1 m2 n2 H)) as (Hpos & _ & Hz).
  split; [constructor; [assumption|]|].
  - fold n; destruct (Rtotal_order (INR n * s) (INR (m1 + m2))) as [L|[L|L]]; [lra | destruct (Hz L); lra |
      specialize (Hpos L); lra].
  - pose proof HL as (D1 & U2 & _ & HJ); repeat (split; [assumption || lra|]); intros y; split.
    + intros Hy; pose proof (Hy n ltac:(unfold n; lia)) as Hg; rewrite g_p in Hg by lra.
      assert (p n1 <= y <= p n2) by (apply HJ; intros; apply Hy; unfold n; lia); split; nra.
    + intros Hy k Hk; destruct (Nat.eq_dec k n) as [->|]; [rewrite g_p by lra; nra|].
      apply (before_mediant w m1 n1 m2 n2 H HL); [lra | unfold n in *; lia].
Qed.

Notation spelt w := (map fst (vertices K w)).

Lemma spelt_snoc w m1 n1 m2 n2 x : stern s K w m1 n1 m2 n2 -> spelt (w ++ [x]) = spelt w ++ [(n1 + n2)%nat].
Proof.
  intros H; assert (E : final 1 K w = (n1, n2)).
  { induction H as [|w m1 n1 m2 n2 H IH|w m1 n1 m2 n2 H IH]; [reflexivity | |]; rewrite final_snoc, IH; reflexivity. }
  unfold vertices; rewrite periods_snoc, E; cbn [map fst snd]; rewrite map_app; reflexivity.
Qed.

Lemma spelt_on_path w m1 n1 m2 n2 k : stern s K w m1 n1 m2 n2 -> In k (spelt w) ->
  k = 1%nat \/ k = K \/ exists w m1 n1 m2 n2, stern s K w m1 n1 m2 n2 /\ k = (n1 + n2)%nat.
Proof.
  intros H; induction H as [|w m1 n1 m2 n2 H IH Hlt|w m1 n1 m2 n2 H IH Hlt].
  - intros [<-|[<-|[]]]; tauto.
  - rewrite (spelt_snoc _ _ _ _ _ _ H), in_app_iff; intros [Hk|[<-|[]]]; [auto | right; right; repeat eexists;
      eassumption].
  - rewrite (spelt_snoc _ _ _ _ _ _ H), in_app_iff; intros [Hk|[<-|[]]]; [auto | right; right; repeat eexists;
      eassumption].
Qed.

(** So far everything on the path is in V, and these are the times so far. *)
Definition good (w : list letter) (n1 n2 : nat) : Prop := left_over n1 n2 /\ Forall member (spelt w) /\
  forall k, (k <= Nat.max n1 n2)%nat -> time k -> In k (spelt w).

Lemma good_nil : good [] 1 K.
Proof.
  pose proof K_2; pose proof side_K; pose proof (u_1 a1 a2) as E1; split; [|split].
  - assert (Hp : p 1 < p K).
    { pose proof (proj2 (proj1 (member_g a1 a2 K) member_first) 1%nat ltac:(lia)) as G; rewrite g_p in G by lra; nra. }
    repeat (split; [lra|]); intros y; split; intros Hy.
    + pose proof (Hy 1%nat ltac:(lia)) as G1; pose proof (Hy K ltac:(lia)) as GK; rewrite g_p in G1, GK by lra; split;
        nra.
    + intros k Hk; apply Rnot_lt_le; intros Hg; destruct (least a1 a2 y k ltac:(lia) Hg) as (l & Hl & HT & Hgl).
      destruct (time_between l HT ltac:(lia)) as [-> | ->]; rewrite g_p in Hgl by lra; nra.
  - unfold vertices; cbn [periods map fst]; repeat apply Forall_cons; [apply member_1 | apply member_first |
      constructor].
  - intros k Hk HT; destruct (time_between k HT ltac:(lia)) as [-> | ->]; cbn; tauto.
Qed.

Lemma good_snoc w m1 n1 m2 n2 x n1' n2' : stern s K w m1 n1 m2 n2 -> good w n1 n2 -> member (n1 + n2) ->
  left_over n1' n2' -> Nat.max n1' n2' = (n1 + n2)%nat -> good (w ++ [x]) n1' n2'.
Proof.
  intros H (HL & HF & Hk) HV HL' Em; split; [assumption|]; rewrite (spelt_snoc _ _ _ _ _ _ H); split.
  - apply Forall_app; split; [assumption | constructor; [assumption | constructor]].
  - intros k Hk' HT; rewrite in_app_iff; cbn [In]; destruct (le_lt_dec k (Nat.max n1 n2)) as [Hm|Hm]; [left; auto|].
    pose proof (time_gap w m1 n1 m2 n2 H k HT Hm); right; left; lia.
Qed.

Lemma good_D w m1 n1 m2 n2 : stern s K w m1 n1 m2 n2 -> good w n1 n2 -> member (n1 + n2) -> 0 < u (n1 + n2) ->
  stern s K (w ++ [D]) (m1 + m2) (n1 + n2) m2 n2 /\ good (w ++ [D]) (n1 + n2) n2.
Proof.
  intros H HG HV Hu; pose proof (proj1 HG) as HL; apply (mediant_member w m1 n1 m2 n2 H HL) in HV as HV'.
  destruct (extend_D w m1 n1 m2 n2 H HL Hu ltac:(lra)) as [H' HL']; split; [assumption|].
  apply (good_snoc w m1 n1 m2 n2 D _ _ H HG HV HL'); lia.
Qed.
Lemma good_U w m1 n1 m2 n2 : stern s K w m1 n1 m2 n2 -> good w n1 n2 -> member (n1 + n2) -> u (n1 + n2) < 0 ->
  stern s K (w ++ [U]) m1 n1 (m1 + m2) (n1 + n2) /\ good (w ++ [U]) n1 (n1 + n2).
Proof.
  intros H HG HV Hu; pose proof (proj1 HG) as HL; apply (mediant_member w m1 n1 m2 n2 H HL) in HV as HV'.
  destruct (extend_U w m1 n1 m2 n2 H HL Hu ltac:(lra)) as [H' HL']; split; [assumption|].
  apply (good_snoc w m1 n1 m2 n2 U _ _ H HG HV HL'); lia.
Qed.

(** ** The end: the mediant n is not in V *)

(** All points have returned by n, or one is left, p_n, which returns at the next mediant if at all. *)
Lemma last_point w m1 n1 m2 n2 k : stern s K w m1 n1 m2 n2 -> left_over n1 n2 -> p n1 = p n2 -> time k ->
  (Nat.max n1 n2 < k)%nat -> k = (n1 + n2)%nat.
Proof.
  intros H HL E HT Hk; pose proof (time_gap w m1 n1 m2 n2 H k HT Hk) as Hn; pose proof HL as (_ & _ & _ & HJ).
  destruct (pair_facts w m1 n1 m2 n2 H) as (_ & H1 & H2 & _); pose proof K_2 as HK2.
  destruct (classic (time (n1 + n2))) as [HN|HN]; [|exfalso; exact (no_later w m1 n1 m2 n2 H HL k HN Hk HT)].
  apply (mediant_time w m1 n1 m2 n2 H HL) in HN; destruct HN as (y & Hy & Hg).
  destruct (Nat.eq_dec k (n1 + n2)) as [|Hne]; [assumption | exfalso].
  destruct HT as [_ (z & Hz & Hzk)]; assert (p n1 <= z <= p n2) by (apply HJ; intros; apply Hzk; lia).
  assert (z = y) by lra; subst z; pose proof (Hzk (n1 + n2)%nat ltac:(lia)); lra.
Qed.

Lemma after_end w m1 n1 m2 n2 k : stern s K w m1 n1 m2 n2 -> good w n1 n2 -> ~ member (n1 + n2) -> time k ->
  (Nat.max n1 n2 < k)%nat -> let n := (n1 + n2)%nat in time n /\ (k = n \/ (n < k)%nat /\ tie a1 a2 n1 n2 k /\
  ((0 < u n /\ stern s K (w ++ [D]) (m1 + m2) n m2 n2 /\ left_over n n2 /\ p n = p n2 /\ k = (n + n2)%nat) \/
   (u n < 0 /\ stern s K (w ++ [U]) m1 n1 (m1 + m2) n /\ left_over n1 n /\ p n1 = p n /\ k = (n1 + n)%nat))).
Proof.
  intros H (HL & _ & _) HV HT Hk n; rewrite (mediant_member w m1 n1 m2 n2 H HL) in HV.
  pose proof (time_gap w m1 n1 m2 n2 H k HT Hk) as Hn; pose proof HL as (D1 & U2 & Hp & HJ); fold n in HV, Hn.
  destruct (pair_facts w m1 n1 m2 n2 H) as (_ & H1 & H2 & _); pose proof K_2 as HK2.
  destruct (classic (time n)) as [HN|HN]; [|exfalso; exact (no_later w m1 n1 m2 n2 H HL k HN Hk HT)].
  split; [assumption|]; destruct (Nat.eq_dec k n) as [|Hne]; [tauto|]; right; split; [lia|].
  destruct (mediant_side w m1 n1 m2 n2 H HL) as (SD & SU & S0); fold n in SD, SU, S0.
  pose proof HT as [_ (y & Hy & Hyk)]; assert (HyJ : p n1 <= y <= p n2) by (apply HJ; intros; apply Hyk; unfold n in *;
    lia).
  pose proof (Hyk n ltac:(unfold n in *; lia)) as Hyn; destruct (Rtotal_order (u n) 0) as [Hs|[Hs|Hs]].
  - apply SU in HN; [|assumption]; rewrite g_p in Hyn by lra.
    assert (Ep : p n = p n1) by (apply Rle_antisym; [nra|]; nra).
    destruct (extend_U w m1 n1 m2 n2 H HL Hs ltac:(fold n; lra)) as [H' HL']; fold n in H', HL'.
    assert (Ek : k = (n1 + n)%nat) by (apply (last_point _ _ _ _ _ k H' HL'); [lra | assumption | lia]).
    split; right; [exact (conj Hs (conj Ep (eq_trans Ek (Nat.add_comm _ _)))) |
      exact (conj Hs (conj H' (conj HL' (conj (eq_sym Ep) Ek))))].
  - apply S0 in HN; [|assumption]; unfold ReturnAlgebra.g in Hyn; rewrite Hs in Hyn; lra.
  - apply SD in HN; [|assumption]; rewrite g_p in Hyn by lra.
    assert (Ep : p n = p n2) by (apply Rle_antisym; [nra|]; nra).
    destruct (extend_D w m1 n1 m2 n2 H HL Hs ltac:(fold n; lra)) as [H' HL']; fold n in H', HL'.
    assert (Ek : k = (n + n2)%nat) by (apply (last_point _ _ _ _ _ k H' HL'); [lra | assumption | lia]).
    split; left; [exact (conj Hs (conj Ep Ek)) | exact (conj Hs (conj H' (conj HL' (conj Ep Ek))))].
Qed.

(** The left-over point of a tie is not in V. *)
Lemma tie_not_member w m1 n1 m2 n2 : stern s K w m1 n1 m2 n2 -> left_over n1 n2 -> p n1 = p n2 -> ~ member (n1 + n2).
Proof. intros H HL E HV; apply (mediant_member w m1 n1 m2 n2 H HL) in HV; lra. Qed.

Lemma after_end_not_member w m1 n1 m2 n2 k : stern s K w m1 n1 m2 n2 -> good w n1 n2 -> ~ member (n1 + n2) ->
  (Nat.max n1 n2 < k)%nat -> ~ member k.
Proof.
  intros H HG HV Hk HVk; pose proof (member_time a1 a2 k HVk) as HT.
  destruct (after_end w m1 n1 m2 n2 k H HG HV HT Hk)
    as (_ & [-> | (_ & _ & [(_ & H' & HL' & E & ->) | (_ & H' & HL' & E & ->)])]);
    [tauto | exact (tie_not_member _ _ _ _ _ H' HL' E HVk) ..].
Qed.

(** Anywhere on the path: all of it so far is in V; or it is in T and ends here; or T has ended before. *)
Definition ended (w : list letter) (n1 n2 : nat) : Prop :=
  (Forall time (spelt w) /\ ~ member (n1 + n2) /\ forall k, time k -> (k <= n1 + n2)%nat) \/
  forall k, time k -> (k < n1 + n2)%nat.

Lemma ends_here w m1 n1 m2 n2 x n1' n2' : stern s K w m1 n1 m2 n2 -> good w n1 n2 -> ~ member (n1 + n2) ->
  (Nat.max n1 n2 < n1' + n2' /\ n1 + n2 < n1' + n2')%nat ->
  (forall k, tie a1 a2 n1 n2 k -> k = (n1' + n2')%nat) -> ended (w ++ [x]) n1' n2'.
Proof.
  intros H HG HV Hlt Htie; assert (Hle : forall k, time k -> (k <= n1' + n2')%nat).
  { intros k Hk; destruct (le_lt_dec k (Nat.max n1 n2)) as [|Hm]; [lia|].
    destruct (after_end w m1 n1 m2 n2 k H HG HV Hk Hm) as (_ & [-> | (_ & Ht & _)]); [lia | rewrite (Htie k Ht); lia]. }
  destruct (classic (time (n1 + n2))) as [HN|HN].
  - left; split; [|split; [|assumption]].
    + rewrite (spelt_snoc _ _ _ _ _ _ H); apply Forall_app; split; [|constructor; [exact HN | constructor]].
      destruct HG as (_ & HF & _); revert HF; apply Forall_impl; exact (member_time a1 a2).
    + intros HV'; refine (after_end_not_member w m1 n1 m2 n2 _ H HG HV _ HV'); lia.
  - right; intros k Hk; destruct (le_lt_dec k (Nat.max n1 n2)) as [|Hm]; [lia|].
    destruct (no_later w m1 n1 m2 n2 H (proj1 HG) k HN Hm Hk).
Qed.

Lemma trichotomy w m1 n1 m2 n2 : stern s K w m1 n1 m2 n2 -> good w n1 n2 \/ ended w n1 n2.
Proof.
  intros H; induction H as [|w m1 n1 m2 n2 H IH Hlt|w m1 n1 m2 n2 H IH Hlt]; [left; apply good_nil | |];
    destruct (pair_facts w m1 n1 m2 n2 H) as (_ & H1 & H2 & _); pose proof K_2 as HK2;
    destruct (side_of (n1 + n2) (m1 + m2) (stern_distance s s_in K half w m1 n1 m2 n2 H)) as (Hpos & Hneg & _).
  - assert (Hu : 0 < u (n1 + n2)) by (apply Hpos; lra); destruct IH as [HG|[(_ & _ & HT)|HT]];
      [|right; right; intros k Hk; specialize (HT k Hk); lia ..].
    destruct (classic (member (n1 + n2))) as [HV|HV]; [left; apply (good_D w m1 n1 m2 n2); assumption | right].
    apply (ends_here w m1 n1 m2 n2); trivial; [lia|]; intros k [(_ & _ & ->)|(Hu' & _)]; [reflexivity | lra].
  - assert (Hu : u (n1 + n2) < 0) by (apply Hneg; lra); destruct IH as [HG|[(_ & _ & HT)|HT]];
      [|right; right; intros k Hk; specialize (HT k Hk); lia ..].
    destruct (classic (member (n1 + n2))) as [HV|HV]; [left; apply (good_U w m1 n1 m2 n2); assumption | right].
    apply (ends_here w m1 n1 m2 n2); trivial; [lia|]; intros k [(Hu' & _)|(_ & _ & ->)]; [lra | lia].
Qed.

(** r = 1: nothing ends before s. *)
Lemma whole_path w m1 n1 m2 n2 : r = 1 -> stern s K w m1 n1 m2 n2 ->
  good w n1 n2 /\ (u (n1 + n2) <> 0 -> member (n1 + n2)).
Proof.
  intros Hr H; assert (Next : forall w m1 n1 m2 n2, stern s K w m1 n1 m2 n2 -> good w n1 n2 -> u (n1 + n2) <> 0 ->
    member (n1 + n2)).
  { clear - r_pos s_in half Hr; intros w m1 n1 m2 n2 H (HL & _) Hu.
    apply (mediant_time_within w m1 n1 m2 n2 H HL); [lra|].
    apply (mediant_time_beyond w m1 n1 m2 n2 H HL); [lra | tauto]. }
  induction H as [|w m1 n1 m2 n2 H [HG IH] Hlt|w m1 n1 m2 n2 H [HG IH] Hlt].
  - split; [apply good_nil | apply (Next [] 0%nat 1%nat 1%nat K); [constructor | apply good_nil]].
  - destruct (side_of (n1 + n2) (m1 + m2) (stern_distance s s_in K half w m1 n1 m2 n2 H)) as (Hp & _ & _).
    specialize (Hp ltac:(lra)); destruct (good_D w m1 n1 m2 n2 H HG (IH ltac:(lra)) Hp) as [H' HG'].
    split; [exact HG' | apply (Next _ _ _ _ _ H' HG')].
  - destruct (side_of (n1 + n2) (m1 + m2) (stern_distance s s_in K half w m1 n1 m2 n2 H)) as (_ & Hn & _).
    specialize (Hn ltac:(lra)); destruct (good_U w m1 n1 m2 n2 H HG (IH ltac:(lra)) Hn) as [H' HG'].
    split; [exact HG' | apply (Next _ _ _ _ _ H' HG')].
Qed.

Lemma far L : exists w m1 n1 m2 n2, stern s K w m1 n1 m2 n2 /\ good w n1 n2 /\
  ((L <= Nat.max n1 n2)%nat \/ ~ member (n1 + n2)).
Proof.
  induction L as [|L (w & m1 & n1 & m2 & n2 & H & HG & HL)].
  - exists [], 0%nat, 1%nat, 1%nat, K; split; [constructor | split; [apply good_nil | left; lia]].
  - destruct (classic (member (n1 + n2))) as [HV|HV]; [destruct HL as [HL|]; [|tauto] | exists w, m1, n1, m2, n2;
      tauto].
    destruct (pair_facts w m1 n1 m2 n2 H) as (_ & H1 & H2 & _); pose proof K_2 as HK2.
    destruct (Rdichotomy _ _ (proj1 HV)) as [Hu|Hu].
    + destruct (good_U w m1 n1 m2 n2 H HG HV Hu) as [H' HG']; eexists _, _, _, _, _; split;
        [exact H' | split; [exact HG' | left; lia]].
    + destruct (good_D w m1 n1 m2 n2 H HG HV Hu) as [H' HG']; eexists _, _, _, _, _; split;
        [exact H' | split; [exact HG' | left; lia]].
Qed.

Lemma time_on_path k : time k -> k = 1%nat \/ k = K \/ exists w m1 n1 m2 n2, stern s K w m1 n1 m2 n2 /\
  k = (n1 + n2)%nat.
Proof.
  intros HT; destruct (far k) as (w & m1 & n1 & m2 & n2 & H & HG & HL).
  destruct (le_lt_dec k (Nat.max n1 n2)) as [Hm|Hm]; [apply (spelt_on_path w m1 n1 m2 n2 k H), HG; assumption|].
  destruct HL as [|HV]; [lia|]; right; right.
  destruct (after_end w m1 n1 m2 n2 k H HG HV HT Hm)
    as (_ & [-> | (_ & _ & [(_ & H' & _ & _ & ->) | (_ & H' & _ & _ & ->)])]); repeat eexists; eassumption.
Qed.

Lemma time_member_within : r <= 1 -> forall k, time k -> member k.
Proof.
  intros Hr k HT; destruct (far k) as (w & m1 & n1 & m2 & n2 & H & HG & HL).
  pose proof HG as (HLO & HF & HI); rewrite Forall_forall in HF.
  destruct (le_lt_dec k (Nat.max n1 n2)) as [Hm|Hm]; [apply HF, HI; assumption|].
  destruct HL as [|HV]; [lia|]; exfalso; apply HV, (mediant_time_within w m1 n1 m2 n2 H HLO Hr).
  apply (after_end w m1 n1 m2 n2 k H HG HV HT Hm).
Qed.

Lemma times_beyond L : 1 < r -> (forall k, (L <= k)%nat -> ~ member k) -> exists w m1 n1 m2 n2,
  stern s K w m1 n1 m2 n2 /\ (forall k, member k <-> In k (spelt w)) /\ ~ member (n1 + n2) /\
  forall k, time k <-> member k \/ k = (n1 + n2)%nat \/ tie a1 a2 n1 n2 k.
Proof.
  intros Hr HVL; destruct (far L) as (w & m1 & n1 & m2 & n2 & H & HG & HL).
  assert (HV : ~ member (n1 + n2)) by (destruct HL as [|]; [apply HVL; lia | assumption]).
  pose proof HG as (HLO & HF & HI); rewrite Forall_forall in HF.
  assert (HM : forall k, member k <-> In k (spelt w)).
  { intros k; split; [|apply HF]; intros Hk; destruct (le_lt_dec k (Nat.max n1 n2)) as [Hm|Hm].
    - apply HI; [assumption | apply member_time; assumption].
    - destruct (after_end_not_member w m1 n1 m2 n2 k H HG HV Hm Hk). }
  assert (HN : time (n1 + n2)) by (apply (mediant_time_beyond w m1 n1 m2 n2 H HLO); lra).
  exists w, m1, n1, m2, n2; repeat (split; [assumption|]); intros k; split.
  - intros HT; destruct (le_lt_dec k (Nat.max n1 n2)) as [Hm|Hm]; [left; apply HM, HI; assumption | right].
    destruct (after_end w m1 n1 m2 n2 k H HG HV HT Hm) as (_ & [-> | (_ & HT' & _)]); tauto.
  - destruct (mediant_side w m1 n1 m2 n2 H HLO) as (SD & SU & _); pose proof HLO as (_ & _ & Hp & _).
    intros [Hk | [-> | [(Hu & E & ->) | (Hu & E & ->)]]]; [apply member_time; assumption | assumption | |].
    + apply (SD Hu) in HN; destruct (extend_D w m1 n1 m2 n2 H HLO Hu ltac:(lra)) as [H' HL'].
      apply (mediant_time_beyond _ _ _ _ _ H' HL'); lra.
    + apply (SU Hu) in HN; destruct (extend_U w m1 n1 m2 n2 H HLO Hu ltac:(lra)) as [H' HL'].
      rewrite Nat.add_comm; apply (mediant_time_beyond _ _ _ _ _ H' HL'); lra.
Qed.

End Path.

(** ** The theorem *)

Lemma V_reversed r s n : 0 < r -> V r s n <-> V (/ r) s n.
Proof.
  intros Hr; unfold V; assert (Ha : 0 < r ^ 2) by (apply pow_lt; assumption).
  replace (trace (/ r) s) with (trace r s / r ^ 2) by (unfold trace; field; lra).
  replace ((/ r) ^ 2) with (/ r ^ 2) by (field; lra). split; intros [Hu H].
  - apply (Words_reversal _ _ n n Ha Hu Hu); split; assumption.
  - assert (Hu' : u (trace r s) (r ^ 2) n <> 0) by (apply (u_reversed_zero _ _ Ha n); assumption).
    apply (Words_reversal _ _ n n Ha Hu' Hu'); split; assumption.
Qed.

Theorem Returns : Returns_statement.
Proof.
  intros r s K Hr Hs HK; pose proof (time_on_path r s Hr Hs K HK) as HP; fold (next_half s K) in HK.
  assert (HVT : forall n, V r s n -> T r s n) by (intros n HV; apply time_return, member_time, HV).
  assert (Within : forall r, 0 < r -> r <= 1 -> forall n, T r s n <-> V r s n).
  { intros r' Hr' H1 n; split; [|intros HV; apply time_return, member_time, HV].
    intros HT; apply (time_member_within r' s Hr' Hs K HK H1), time_return, HT. }
  constructor; [| | intros; apply V_reversed; assumption | assumption | apply Within; assumption | |].
  - split; [apply member_1 | split; [apply (member_first r s); assumption | split]].
    + intros n HV; apply HP, member_time, HV.
    + intros w m1 n1 m2 n2 H HV; destruct (trichotomy r s Hr Hs K HK w m1 n1 m2 n2 H)
        as [(_ & HF & _)|[(_ & HV' & _)|HD]]; [exact HF | tauto | specialize (HD _ (member_time _ _ _ HV)); lia].
  - split; [apply HVT, member_1 | split; [apply HVT, (member_first r s); assumption | split]].
    + intros n HT; apply HP, time_return, HT.
    + intros w m1 n1 m2 n2 H HT; destruct (trichotomy r s Hr Hs K HK w m1 n1 m2 n2 H) as [(_ & HF & _)|[(HF & _)|HD]].
      * eapply Forall_impl; [exact HVT | exact HF].
      * eapply Forall_impl; [|exact HF]; intros n; apply time_return.
      * apply time_return in HT; specialize (HD _ HT); lia.
  - intros H1 w m1 n1 m2 n2 H Hne; apply (whole_path r s Hr Hs K HK w m1 n1 m2 n2 H1 H).
    destruct (side_of r s Hr Hs (n1 + n2) (m1 + m2) (stern_distance s Hs K HK w m1 n1 m2 n2 H)) as (Hp & Hn & _).
    destruct (Rdichotomy _ _ Hne) as [L|L]; [apply Rlt_not_eq, Hn; lra | apply Rgt_not_eq, Hp; lra].
  - intros H1; assert (Hi : 0 < / r < 1) by (split; [apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1;
      apply Rinv_lt_contravar; lra]).
    pose proof (next_half_first (/ r) s ltac:(lra) Hs K HK) as HF.
    destruct (V_finite _ _ K HF) as [L HL]; [simpl; nra|].
    destruct (times_beyond r s Hr Hs K HK L H1) as (w & m1 & n1 & m2 & n2 & H & HV & HN & HT).
    { intros k Hk HV; apply (HL k Hk); apply (V_reversed r s k Hr), HV. }
    exists w, m1, n1, m2, n2; repeat (split; [assumption|]); intros k.
    unfold T at 1; rewrite time_return, HT, (Within (/ r) ltac:(lra) ltac:(lra) k), <- (V_reversed r s k Hr);
      reflexivity.
Qed.
