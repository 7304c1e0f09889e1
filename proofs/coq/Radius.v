(** * At fixed s the orbit exists exactly above one radius R(s): S4's first half, and Theorem 2

    Section 5 of ../conjecture1.md: at fixed s, the deciding b has the sign of h(r); Theorem 2's
    intervals are where j e < 1, and r = 1 is above every radius. *)

From Coq Require Import Reals ZArith Arith Lra Lia.
From Grazing Require Import Defs Statement Cases Polar LnCos Phase Farey Disc Sine.
Open Scope R_scope.

(** ** Cells *)

(** n th = 2 pi n s differs from 2 pi m by less than a half turn. *)
Lemma sin_turns (x y : R) (m : nat) : x = y + INR m * (2 * PI) -> sin x = sin y.
Proof. intros E; destruct (periods_nat x m) as [_ <-]; f_equal; lra. Qed.

Lemma cell_of_distance r s n m : 0 < r <= 1 -> 0 < s < 1 / 2 ->
  INR n * s <> INR m -> Rabs (INR n * s - INR m) < 1 / 2 -> cell r s n m.
Proof.
  intros Hr Hs Hne Hm; pose proof PI_RGT_0. split; [assumption|split; [assumption|split; [|assumption]]].
  apply (u_zero r (2 * PI * s)); [lra|apply sin_gt_0; nra|].
  rewrite (sin_turns _ (2 * PI * (INR n * s - INR m)) m) by ring.
  apply Rabs_def2 in Hm; destruct (Rtotal_order (INR n * s) (INR m)) as [Hl|[|Hl]]; [|tauto|].
  - apply Rlt_not_eq, sin_lt_0_var; nra.
  - apply Rgt_not_eq, sin_gt_0; nra.
Qed.

(** Where u_n <> 0, n s has a nearest integer, and is not an integer. *)
Lemma cell_exists r s n : 0 < r <= 1 -> 0 < s < 1 / 2 -> u (trace r s) (r ^ 2) n <> 0 -> exists m, cell r s n m /\
  INR n * s <> INR m.
Proof.
  intros Hr Hs Hu; pose proof PI_RGT_0.
  assert (Hsin : sin (INR n * (2 * PI * s)) <> 0).
  { apply (u_zero r (2 * PI * s)) in Hu; [assumption|lra|apply sin_gt_0; nra]. }
  destruct (archimed (INR n * s - 1 / 2)) as [H1 H2]. set (l := up (INR n * s - 1 / 2)) in *.
  assert (Hns : 0 <= INR n * s) by (pose proof (pos_INR n); nra).
  assert (Hl : (0 <= l)%Z) by (apply Z.lt_succ_r, lt_IZR; rewrite succ_IZR; lra). exists (Z.to_nat l).
  assert (El : INR (Z.to_nat l) = IZR l) by (rewrite INR_IZR_INZ; now rewrite Z2Nat.id).
  assert (Hne : INR n * s <> INR (Z.to_nat l)).
  { intros E; apply Hsin; rewrite (sin_turns _ 0 (Z.to_nat l)); [apply sin_0|rewrite <- E; ring]. }
  split; [|assumption]; apply cell_of_distance; trivial. destruct H2 as [H2|H2].
  - rewrite El; apply Rabs_def1; lra.
  - exfalso; apply Hsin; rewrite (sin_turns _ (- PI) (Z.to_nat l)); [now rewrite sin_neg, sin_PI, Ropp_0|].
    rewrite El; replace (INR n * (2 * PI * s)) with (2 * PI * (INR n * s)) by ring.
    replace (INR n * s) with (IZR l - 1 / 2) by lra; field.
Qed.

(** ** The deciding b and h *)

Definition same_sign (x y : R) : Prop :=
  (0 < x <-> 0 < y) /\ (x = 0 <-> y = 0) /\ (x < 0 <-> y < 0).

Lemma proportional x y p q : 0 < p -> 0 < q -> x * p = q * y -> same_sign x y.
Proof.
  intros Hp Hq E; destruct (Rtotal_order x 0) as [H|[H|H]].
  - assert (0 < (- x) * p) by (apply Rmult_lt_0_compat; lra). assert (0 < - y) by (apply (Rmult_lt_reg_l q); lra).
    repeat split; intros; lra.
  - subst; assert (y = 0) by (apply (Rmult_eq_reg_l q); lra); repeat split; intros; lra.
  - assert (0 < x * p) by (apply Rmult_lt_0_compat; lra). assert (0 < y) by (apply (Rmult_lt_reg_l q); lra).
    repeat split; intros; lra.
Qed.

Section Deciding.

Variables (r s : R) (n m mp np mm nm : nat).
Hypothesis Hn : (3 <= n)%nat.
Hypothesis HF : neighbours m n mp np mm nm.
Hypothesis H : cell r s n m.

(** b r^n sin A = r^k h(r), so b has the sign of h, if the three angles are g A, g (A + B), -g B. *)
Lemma b_h g k j e : (k + j = n)%nat -> (g = 1 \/ g = -1) -> 0 < e < 1 / 2 -> let A := angle_A e in let B :=
  angle_B n j e in let th := 2 * PI * s in sin (INR n * th) = g * sin A -> sin (INR k * th) = g * sin (A + B) ->
  sin (INR j * th) = - g * sin B -> same_sign (b_at r s n k) (h n j e r).
Proof.
  intros E Hg He A B th En Ek Ej; destruct H as (Hr & Hs & Hu & _); pose proof PI_RGT_0.
  assert (Hth : sin th > 0) by (apply sin_gt_0; unfold th; nra). pose proof (b_polar r th n k ltac:(lia) Hu) as Eb.
  change (b (2 * r * cos th) (r ^ 2) n k) with (b_at r s n k) in Eb.
  replace (n - k)%nat with j in Eb by lia; rewrite En, Ek, Ej in Eb.
  assert (HA : 0 < sin A) by (apply sin_gt_0; unfold A, angle_A; nra). assert (Hpn : 0 < r ^ n) by (apply pow_lt; lra).
  assert (Hpk : 0 < r ^ k) by (apply pow_lt; lra).
  assert (Eh : b_at r s n k * (r ^ n * sin A) = r ^ k * h n j e r).
  { unfold h; fold A B.
    replace (r ^ k * (r ^ j * sin A + r ^ n * sin B - sin (A + B))) with (r ^ (k + j) * sin A + r ^ (n + k) * sin B - r
      ^ k * sin (A + B)) by (rewrite !pow_add; ring).
    rewrite E; destruct Hg as [-> | ->]; lra. }
  assert (Hd : 0 < r ^ n * sin A) by now apply Rmult_lt_0_compat. exact (proportional _ _ _ _ Hd Hpk Eh).
Qed.

(** neighbours, over R *)
Lemma neighbours_R : INR m * INR np = INR mp * INR n + 1 /\ INR m * INR nm + 1 = INR mm * INR n /\ INR np + INR nm = INR
  n /\ 3 <= INR n /\ 1 <= INR np /\ 1 <= INR nm.
Proof.
  destruct (neighbours_sum _ _ _ _ _ _ HF) as [_ S]. destruct HF as ([Hp _] & E & [Hp' _] & E').
  apply (f_equal INR) in E, E', S; apply le_INR in Hn, Hp, Hp'.
  rewrite plus_INR, !mult_INR in E, E'; rewrite plus_INR in S; simpl in *. repeat split; lra.
Qed.

(** The turns made by k th and j th, k the deciding index, j = n - k. *)
Lemma turns_left (e := INR m - INR n * s) : INR nm * s = INR mm - (e + (1 - INR np * e) / INR n) /\
  INR np * s = INR mp + (1 - INR np * e) / INR n.
Proof.
  destruct neighbours_R as (E & E' & S & Hn3 & _); apply (f_equal (Rmult e)) in S.
  replace s with ((INR m - e) / INR n) by (unfold e; field; lra). split; field_simplify_eq; lra.
Qed.

Lemma turns_right (e := INR n * s - INR m) : INR np * s = INR mp + (e + (1 - INR nm * e) / INR n) /\
  INR nm * s = INR mm - (1 - INR nm * e) / INR n.
Proof.
  destruct neighbours_R as (E & E' & S & Hn3 & _); apply (f_equal (Rmult e)) in S.
  replace s with ((INR m + e) / INR n) by (unfold e; field; lra). split; field_simplify_eq; lra.
Qed.

Lemma b_left_h : INR n * s < INR m -> same_sign (b_at r s n nm) (h n np (INR m - INR n * s) r).
Proof.
  intros Hs; destruct H as (_ & _ & _ & Hm); apply Rabs_def2 in Hm.
  pose proof (neighbours_sum _ _ _ _ _ _ HF); destruct turns_left as [Tk Tj]. set (e := INR m - INR n * s) in *.
  apply (b_h (-1)); [lia|tauto|unfold e in *; lra|..]; unfold angle_A, angle_B.
  - rewrite (sin_turns _ (- (2 * PI * e)) m), sin_neg; unfold e; ring.
  - rewrite (sin_turns _ (- (2 * PI * e + 2 * PI * (1 - INR np * e) / INR n)) mm), sin_neg; [ring|].
    replace (INR nm * (2 * PI * s)) with (2 * PI * (INR nm * s)) by ring. rewrite Tk; unfold Rdiv; ring.
  - rewrite (sin_turns _ (2 * PI * (1 - INR np * e) / INR n) mp); [ring|].
    replace (INR np * (2 * PI * s)) with (2 * PI * (INR np * s)) by ring. rewrite Tj; unfold Rdiv; ring.
Qed.

Lemma b_right_h : INR n * s > INR m -> same_sign (b_at r s n np) (h n nm (INR n * s - INR m) r).
Proof.
  intros Hs; destruct H as (_ & _ & _ & Hm); apply Rabs_def2 in Hm.
  pose proof (neighbours_sum _ _ _ _ _ _ HF); destruct turns_right as [Tk Tj]. set (e := INR n * s - INR m) in *.
  apply (b_h 1); [lia|tauto|unfold e in *; lra|..]; unfold angle_A, angle_B.
  - rewrite (sin_turns _ (2 * PI * e) m); unfold e; ring.
  - rewrite (sin_turns _ (2 * PI * e + 2 * PI * (1 - INR nm * e) / INR n) mp); [ring|].
    replace (INR np * (2 * PI * s)) with (2 * PI * (INR np * s)) by ring. rewrite Tk; unfold Rdiv; ring.
  - rewrite (sin_turns _ (- (2 * PI * (1 - INR nm * e) / INR n)) mm), sin_neg; [ring|].
    replace (INR nm * (2 * PI * s)) with (2 * PI * (INR nm * s)) by ring. rewrite Tj; unfold Rdiv; ring.
Qed.

End Deciding.

(** ** Theorem 2's intervals in terms of e *)

Lemma left_interval n m mp np mm nm s : (3 <= n)%nat -> (0 < 2 * m < n)%nat -> neighbours m n mp np mm nm -> let e :=
  INR m - INR n * s in ((if (m =? 1)%nat then 1 / (2 * INR n) else INR mp / INR np) < s < INR m / INR n <->
  index n np e /\ INR np * e < 1).
Proof.
  intros Hn Hm HF e; destruct (neighbours_R n m mp np mm nm Hn HF) as (E & _ & _ & Hn3 & Hp & _).
  assert (Hj : (1 <= np <= n - 1)%nat) by (destruct HF; lia).
  assert (Hright : s < INR m / INR n <-> 0 < e).
  { unfold e; split; intros Hs.
    - apply (Rmult_lt_compat_l (INR n)) in Hs; [|lra].
      replace (INR n * (INR m / INR n)) with (INR m) in Hs by (field; lra); lra.
    - apply (Rmult_lt_reg_l (INR n)); [lra|]. replace (INR n * (INR m / INR n)) with (INR m) by (field; lra); lra. }
  destruct (Nat.eqb_spec m 1) as [->|Hm1].
  - assert (np = 1)%nat as -> by (destruct HF as (? & ? & _), mp; lia || nia).
    assert (Hleft : 1 / (2 * INR n) < s <-> e < 1 / 2).
    { unfold e; split; intros Hs.
      - apply (Rmult_lt_compat_l (INR n)) in Hs; [|lra].
        replace (INR n * (1 / (2 * INR n))) with (1 / 2) in Hs by (field; lra); simpl; lra.
      - apply (Rmult_lt_reg_l (INR n)); [lra|].
        replace (INR n * (1 / (2 * INR n))) with (1 / 2) by (field; lra); simpl in Hs; lra. }
    rewrite Hleft, Hright; unfold index; replace (INR 1) with 1 by reflexivity.
    split; [intros [? ?]; repeat split; lia || lra|intros ((_ & _ & ?) & _); lra].
  - assert (Hp2 : 2 <= INR np).
    { apply (le_INR 2); destruct HF as (? & ? & _). assert (np <> 1)%nat; [|lia]; intros ->; destruct mp; nia. }
    assert (Hleft : INR mp / INR np < s <-> INR np * e < 1).
    { assert (EI : INR np * INR n * (INR mp / INR np) = INR mp * INR n) by (field; lra).
      assert (0 < INR np * INR n) by nra.
      unfold e; split; intros Hs; [apply (Rmult_lt_compat_l (INR np * INR n)) in Hs; lra|].
      apply (Rmult_lt_reg_l (INR np * INR n)); lra. }
    rewrite Hleft, Hright; unfold index; split; [intros [? ?]; repeat split; lia || nra|].
    intros ((_ & _ & ?) & ?); lra.
Qed.

Lemma right_interval n m mp np mm nm s : (3 <= n)%nat -> (0 < 2 * m < n)%nat -> neighbours m n mp np mm nm -> let e :=
  INR n * s - INR m in (INR m / INR n < s < INR mm / INR nm <-> index n nm e /\ INR nm * e < 1).
Proof.
  intros Hn Hm HF e; destruct (neighbours_R n m mp np mm nm Hn HF) as (_ & E & _ & Hn3 & _ & Hp).
  assert (Hj : (1 <= nm <= n - 1)%nat) by (destruct HF as (_ & _ & ? & _); lia).
  assert (Hleft : INR m / INR n < s <-> 0 < e).
  { unfold e; split; intros Hs.
    - apply (Rmult_lt_compat_l (INR n)) in Hs; [|lra].
      replace (INR n * (INR m / INR n)) with (INR m) in Hs by (field; lra); lra.
    - apply (Rmult_lt_reg_l (INR n)); [lra|]. replace (INR n * (INR m / INR n)) with (INR m) by (field; lra); lra. }
  assert (Hp2 : 2 <= INR nm).
  { apply (le_INR 2); destruct HF as (_ & _ & ? & ?). assert (nm <> 1)%nat; [|lia]; intros ->; destruct mm; nia. }
  assert (Hright : s < INR mm / INR nm <-> INR nm * e < 1).
  { assert (EI : INR nm * INR n * (INR mm / INR nm) = INR mm * INR n) by (field; lra).
    assert (0 < INR nm * INR n) by nra.
    unfold e; split; intros Hs; [apply (Rmult_lt_compat_l (INR nm * INR n)) in Hs; lra|].
    apply (Rmult_lt_reg_l (INR nm * INR n)); lra. }
  rewrite Hleft, Hright; unfold index; split; [intros [? ?]; repeat split; lia || nra|]. intros ((_ & _ & ?) & ?); lra.
Qed.

(** ** S4 *)

Lemma left_orbits r s n m mp np mm nm : (3 <= n)%nat -> (1 <= m)%nat -> neighbours m n mp np mm nm -> cell r s n m ->
  INR n * s < INR m -> exists_iff (trace r s) (r ^ 2) n Plus Plus (0 < h n np (INR m - INR n * s) r).
Proof.
  intros Hn Hm HF H Hs. destruct (S3_proof r s n m mp np mm nm ltac:(lia) Hm HF H) as [HS _].
  destruct (HS Hs) as (_ & _ & He & _); revert He; apply exists_iff_ext.
  exact (proj1 (b_left_h r s n m mp np mm nm Hn HF H Hs)).
Qed.

Lemma right_orbits r s n m mp np mm nm : (3 <= n)%nat -> (1 <= m)%nat -> neighbours m n mp np mm nm -> cell r s n m ->
  INR n * s > INR m -> exists_iff (trace r s) (r ^ 2) n Plus Minus (0 < h n nm (INR n * s - INR m) r).
Proof.
  intros Hn Hm HF H Hs. destruct (S3_proof r s n m mp np mm nm ltac:(lia) Hm HF H) as [_ HS].
  destruct (HS Hs) as (_ & _ & He & _); revert He; apply exists_iff_ext.
  exact (proj1 (b_right_h r s n m mp np mm nm Hn HF H Hs)).
Qed.

(** Over lo < s < hi the orbit (+, g) exists where h > 0; d s is e = |n s - m|. *)
Definition area (n : nat) (g : sign) (lo hi : R) (j : nat) (d : R -> R) : Prop :=
  (exists x y, forall s, d s = x + y * s) /\ forall s, lo < s < hi ->
  index n j (d s) /\ INR j * d s < 1 /\ forall r, 0 < r <= 1 ->
  exists_iff (trace r s) (r ^ 2) n Plus g (0 < h n j (d s) r).

Section Areas.

Variables n m mp np mm nm : nat.
Hypothesis Hn : (3 <= n)%nat.
Hypothesis Hm : (0 < 2 * m < n)%nat.
Hypothesis HF : neighbours m n mp np mm nm.

Lemma m_bounds : 3 <= INR n /\ 1 <= INR m /\ 2 * INR m + 1 <= INR n.
Proof.
  destruct Hm as [Hm1 Hm2]; assert (Hm3 : (1 <= m)%nat) by lia. apply le_INR in Hm2, Hm3; pose proof (le_INR _ _ Hn).
  rewrite S_INR, mult_INR in Hm2; simpl in *; lra.
Qed.

Lemma left_area : area n Plus (if (m =? 1)%nat then 1 / (2 * INR n) else INR mp / INR np)
  (INR m / INR n) np (fun s => INR m - INR n * s).
Proof.
  split; [exists (INR m), (- INR n); intros; ring|]; intros s Hs.
  apply (left_interval n m mp np mm nm) in Hs; trivial; destruct Hs as [Hi Hj].
  split; [assumption|split; [assumption|]]; intros r Hr. destruct m_bounds as (? & ? & ?); destruct Hi as (_ & _ & He).
  apply (left_orbits r s n m mp np mm nm); trivial; [lia| |lra].
  apply cell_of_distance; trivial; [split; nra|lra|apply Rabs_def1; lra].
Qed.

Lemma right_area : area n Minus (INR m / INR n) (INR mm / INR nm) nm (fun s => INR n * s - INR m).
Proof.
  split; [exists (- INR m), (INR n); intros; ring|]; intros s Hs.
  apply (right_interval n m mp np mm nm) in Hs; trivial; destruct Hs as [Hi Hj].
  split; [assumption|split; [assumption|]]; intros r Hr. destruct m_bounds as (? & ? & ?); destruct Hi as (_ & _ & He).
  apply (right_orbits r s n m mp np mm nm); trivial; [lia| |lra].
  apply cell_of_distance; trivial; [split; nra|lra|apply Rabs_def1; lra].
Qed.

End Areas.

Lemma first_orbits n r s : (3 <= n)%nat -> 0 < r <= 1 -> 0 < s < 1 / (2 * INR n) ->
  exists_iff (trace r s) (r ^ 2) n Minus Plus True.
Proof.
  intros Hn Hr Hs; assert (Hn3 : 3 <= INR n) by (apply le_INR in Hn; simpl in Hn; lra).
  assert (Hns : 0 < INR n * s < 1 / 2).
  { split; [nra|]; replace (1 / 2) with (INR n * (1 / (2 * INR n))) by (field; lra); nra. }
  apply (S1_proof r s n ltac:(lia)), cell_of_distance; [assumption|nra|simpl; lra|].
  simpl; rewrite Rminus_0_r; apply Rabs_def1; lra.
Qed.

Lemma interval_area n g lo hi : (3 <= n)%nat -> interval n Plus g lo hi -> exists j d, area n g lo hi j d.
Proof.
  intros Hn HI; pose proof (view _ _ _ _ _ HI) as HV; inversion HV; subst; eexists _, _;
    [eapply left_area|eapply right_area]; eassumption.
Qed.

(** Where s is: over an interval, or where there is no orbit; at r = 1 an end of an interval is neither. *)
Definition placed (n : nat) (r s : R) : Prop :=
  (exists e g lo hi, interval n e g lo hi /\ lo < s < hi) \/ no_orbit_at r s n \/
  r = 1 /\ (exists e g lo hi, interval n e g lo hi /\ (s = lo \/ s = hi)) /\
  exists k, (1 <= k <= n - 1)%nat /\ b_at r s n k = 0.

Lemma S3_at r s n m mp np mm nm : (3 <= n)%nat -> (1 <= m)%nat -> neighbours m n mp np mm nm -> cell r s n m ->
  (INR n * s < INR m -> b_at r s n nm < 0 -> no_orbit_at r s n) /\ (INR n * s > INR m -> b_at r s n np < 0 ->
  no_orbit_at r s n).
Proof.
  intros Hn Hm HF H. destruct (S3_proof r s n m mp np mm nm ltac:(lia) Hm HF H) as [HL HRt].
  split; intros Hs; [apply (HL Hs)|apply (HRt Hs)].
Qed.

Lemma place n r s : (3 <= n)%nat -> 0 < r <= 1 -> 0 < s < 1 / 2 -> u_at r s n <> 0 -> placed n r s.
Proof.
  intros Hn Hr Hs Hu; assert (Hn3 : 3 <= INR n) by (apply le_INR in Hn; simpl in Hn; lra).
  destruct (cell_exists r s n Hr Hs Hu) as (m & H & Hne). pose proof H as (_ & _ & _ & Hm); apply Rabs_def2 in Hm.
  destruct m as [|m'].
  { left; exists Minus, Plus, 0, (1 / (2 * INR n)); split; [constructor|].
    split; [apply Hs|]; simpl in Hm; apply (Rmult_lt_reg_l (INR n)); [lra|].
    replace (INR n * (1 / (2 * INR n))) with (1 / 2) by (field; lra); lra. }
  set (m := S m') in *; assert (Hm1 : (1 <= m)%nat) by (unfold m; lia); clearbody m.
  destruct (Nat.eq_dec (Nat.gcd m n) 1) as [Hg|Hg]; [|right; left; apply (S2_proof r s n m ltac:(lia) Hm1 H);
    assumption].
  assert (Hm2 : (0 < 2 * m < n)%nat).
  { assert (Hlt : (2 * m < n + 1)%nat).
    { apply INR_lt; rewrite plus_INR, mult_INR; simpl; nra. }
    assert (2 * m <> n)%nat; [|lia]; intros E.
    assert (Nat.gcd m n = m) as Eg by (rewrite <- E, Nat.mul_comm; apply Nat.gcd_mul_diag_l; lia); lia. }
  destruct (neighbours_exist m n ltac:(lia) Hg) as (mp & np & mm & nm & HF).
  pose proof (neighbours_R n m mp np mm nm Hn HF) as (EL & ER & _ & _ & Hp & Hp').
  destruct (S3_at r s n m mp np mm nm Hn Hm1 HF H) as [HL HRt].
  destruct (Rtotal_order (INR n * s) (INR m)) as [Hl|[|Hl]]; [|tauto|].
  - pose proof (left_of n m mp np mm nm Hm2 HF) as HI.
    assert (Hi : index n np (INR m - INR n * s)) by (destruct HF; repeat split; lia || lra).
    pose proof (b_left_h r s n m mp np mm nm Hn HF H Hl) as (_ & S0 & S1).
    destruct (Rlt_le_dec (INR np * (INR m - INR n * s)) 1) as [Hlt|Hge].
    { left; eexists _, _, _, _; split; [exact HI|]. apply (left_interval n m mp np mm nm s Hn Hm2 HF); tauto. }
    destruct (Rlt_le_dec r 1) as [Hr1|Hr1]; [right; left; apply HL, S1, h_neg; trivial; tauto|].
    destruct Hge as [Hge|Hge]; [right; left; apply HL, S1, h_neg; trivial; tauto || lra|].
    right; right; split; [lra|split].
    + eexists _, _, _, _; split; [exact HI|left]; destruct (Nat.eqb_spec m 1) as [->|].
      * exfalso; assert (np = 1)%nat as -> by (destruct HF as (? & ? & _), mp; lia || nia). simpl in *; lra.
      * apply (Rmult_eq_reg_l (INR np * INR n)); [|nra].
        replace (INR np * INR n * (INR mp / INR np)) with (INR mp * INR n) by (field; lra); lra.
    + exists nm; split; [destruct HF as (_ & _ & ? & _); lia|].
      apply S0; assert (r = 1) as -> by lra; apply h_at_end; lra.
  - pose proof (right_of n m mp np mm nm Hm2 HF) as HI.
    assert (Hi : index n nm (INR n * s - INR m)) by (destruct HF as (_ & _ & ? & _); repeat split; lia || lra).
    pose proof (b_right_h r s n m mp np mm nm Hn HF H Hl) as (_ & S0 & S1).
    destruct (Rlt_le_dec (INR nm * (INR n * s - INR m)) 1) as [Hlt|Hge].
    { left; eexists _, _, _, _; split; [exact HI|]. apply (right_interval n m mp np mm nm s Hn Hm2 HF); tauto. }
    destruct (Rlt_le_dec r 1) as [Hr1|Hr1]; [right; left; apply HRt, S1, h_neg; trivial; tauto|].
    destruct Hge as [Hge|Hge]; [right; left; apply HRt, S1, h_neg; trivial; tauto || lra|].
    right; right; split; [lra|split].
    + eexists _, _, _, _; split; [exact HI|right]. apply (Rmult_eq_reg_l (INR nm * INR n)); [|nra].
      replace (INR nm * INR n * (INR mm / INR nm)) with (INR mm * INR n) by (field; lra); lra.
    + exists np; split; [destruct HF as (? & _); lia|]. apply S0; assert (r = 1) as -> by lra; apply h_at_end; lra.
Qed.

(** An orbit of region 3 lies over some interval, and has its case. *)
Lemma orbit_in_interval n r s e g : (3 <= n)%nat -> 0 < r <= 1 -> 0 < s < 1 / 2 ->
  orbit_at r s n e g -> exists lo hi, interval n e g lo hi /\ lo < s < hi.
Proof.
  intros Hn Hr Hs Ho.
  destruct (place n r s Hn Hr Hs (proj1 Ho)) as [(e' & g' & lo & hi & HI & Hlo)|[Hno|(_ & _ & k & Hk & E)]].
  - exists lo, hi; split; [|assumption]. assert (e = e' /\ g = g') as [-> ->]; [|assumption]. destruct e'.
    + destruct (interval_area n g' lo hi Hn HI) as (j & d & _ & Hd).
      destruct (Hd s Hlo) as (_ & _ & Hex); apply (Hex r Hr) in Ho; tauto.
    + pose proof (view _ _ _ _ _ HI) as HV; inversion HV; subst; apply (first_orbits n r s Hn Hr Hlo) in Ho; tauto.
  - destruct (proj1 (One_case _ _ n e g ltac:(lia) Ho) Hno).
  - exfalso; destruct Ho as (_ & Hb & _); specialize (Hb k Hk); unfold b_at in E; rewrite E in Hb; lra.
Qed.

(** For s in the interval and 0 < r <= 1 the orbit exists iff Rad s < r. *)
Definition radius (n : nat) (e g : sign) (lo hi : R) (Rad : R -> R) : Prop :=
  forall s, lo < s < hi -> 0 <= Rad s < 1 /\
  forall r, 0 < r <= 1 -> exists_iff (trace r s) (r ^ 2) n e g (Rad s < r).

Lemma S4_proof n : (3 <= n)%nat -> (forall e g lo hi, interval n e g lo hi -> exists Rad, radius n e g lo hi Rad /\
  (e = Minus -> forall s, Rad s = 0)) /\ (forall s, 0 < s < 1 / 2 -> (forall e g lo hi, interval n e g lo hi ->
  ~ lo < s < hi) -> forall r e g, 0 < r <= 1 -> ~ orbit_at r s n e g).
Proof.
  intros Hn; split.
  - intros [|] g lo hi HI.
    + destruct (interval_area n g lo hi Hn HI) as (j & d & _ & Hd).
      exists (fun s => proj1_sig (threshold n j (d s))); split; [|discriminate].
      intros s Hs; destruct (Hd s Hs) as (Hi & Hje & Ho). destruct (threshold n j (d s)) as (x & Hx); simpl.
      destruct (Hx Hi Hje) as [Hx1 Hx2]; split; [assumption|]; intros r Hr.
      refine (exists_iff_ext _ _ _ _ _ _ _ _ (Ho r Hr)); apply Hx2; lra.
    + exists (fun _ => 0); split; [|reflexivity]; pose proof (view _ _ _ _ _ HI) as HV; inversion HV; subst.
      intros s Hs; split; [lra|]; intros r Hr.
      refine (exists_iff_ext _ _ _ _ _ _ _ _ (first_orbits n r s Hn Hr Hs)); lra.
  - intros s Hs Hnone r e g Hr Ho. destruct (orbit_in_interval n r s e g Hn Hr Hs Ho) as (lo & hi & HI & Hlo).
    exact (Hnone e g lo hi HI Hlo).
Qed.

(** ** Theorem 2 is the case r = 1 *)

Lemma Theorem2_proof n s e g : (3 <= n)%nat -> 0 < s < 1 / 2 ->
  (orbit_at 1 s n e g <-> exists lo hi, interval n e g lo hi /\ lo < s < hi).
Proof.
  intros Hn Hs; split.
  - apply orbit_in_interval; trivial; lra.
  - intros (lo & hi & HI & Hlo); destruct (proj1 (S4_proof n Hn) e g lo hi HI) as (Rad & HR & _).
    destruct (HR s Hlo) as [Hx HI1]; apply (HI1 1); [lra|]; tauto.
Qed.
