(** * The radius R(s) of S4 is continuous, and tends to 1 at the ends but two

    Section 6 of ../conjecture1.md: R(s) < r iff h > 0 at r, and h is continuous in s. *)

From Coq Require Import Reals Arith Lra Lia.
From Grazing Require Import Defs Statement Cases Farey Sine Radius Count.
Open Scope R_scope.

Lemma sign_near f p : continuity f -> f p > 0 -> exists d, d > 0 /\ forall s, Rabs (s - p) < d -> f s > 0.
Proof.
  intros Hf Hp; destruct (Hf p (f p) Hp) as (d & Hd & Hnear); exists d; split; [assumption|].
  intros s Hs; destruct (Req_dec s p) as [->|Hne]; [assumption|].
  assert (Hdist : Rabs (f s - f p) < f p).
  { apply Hnear; split; [split; [exact I|auto]|exact Hs]. }
  apply Rabs_def2 in Hdist; lra.
Qed.

Lemma two_pi_over k : 3 <= k -> 0 < 2 * PI / k < PI.
Proof.
  intros Hk; pose proof PI_RGT_0; split; [apply Rdiv_lt_0_compat; lra|].
  apply (Rmult_lt_reg_r k); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; nra.
Qed.

(** At e = 0 and at j e = 1, h is a negative multiple of a sine. *)
Lemma h_end_0 n j r : (3 <= n)%nat -> 0 < r < 1 -> h n j 0 r < 0.
Proof.
  intros Hn Hr; assert (Hn3 : 3 <= INR n) by (apply le_INR in Hn; simpl in Hn; lra).
  pose proof (two_pi_over (INR n) Hn3) as Hs. assert (0 < sin (2 * PI / INR n)) by (apply sin_gt_0; lra).
  assert (r ^ n < 1 ^ n) by (apply pow_lt_compat_l; [lia|lra]); rewrite pow1 in *.
  unfold h, angle_A, angle_B; rewrite !Rmult_0_r, sin_0, Rplus_0_l, Rminus_0_r, Rmult_1_r; nra.
Qed.

Lemma h_end_1 n j r : (3 <= j)%nat -> 0 < r < 1 -> h n j (/ INR j) r < 0.
Proof.
  intros Hj Hr; assert (Hj3 : 3 <= INR j) by (apply le_INR in Hj; simpl in Hj; lra).
  pose proof (two_pi_over (INR j) Hj3) as Hs. assert (0 < sin (2 * PI / INR j)) by (apply sin_gt_0; lra).
  assert (r ^ j < 1 ^ j) by (apply pow_lt_compat_l; [lia|lra]); rewrite pow1 in *.
  unfold h, angle_A, angle_B; rewrite Rinv_r, Rminus_eq_0, Rmult_0_r by lra.
  unfold Rdiv in *; rewrite Rmult_0_l, Rplus_0_r, sin_0; nra.
Qed.

Section Graph.

Variables (n : nat) (g : sign) (lo hi : R) (j : nat) (d Rad : R -> R).
Hypothesis Hn : (3 <= n)%nat.
Hypothesis HA : area n g lo hi j d.
Hypothesis HR : radius n Plus g lo hi Rad.

Lemma h_continuous_s r : continuity (fun s => h n j (d s) r).
Proof.
  destruct HA as ((x & y & E) & _); intros s.
  apply (continuity_pt_locally_ext (fun s => h n j (x + y * s) r) _ 1); [lra|now intros; rewrite E|].
  unfold h, angle_A, angle_B, Rdiv; reg.
Qed.

Lemma radius_h s r : lo < s < hi -> 0 < r <= 1 -> (Rad s < r <-> 0 < h n j (d s) r).
Proof.
  intros Hs Hr; destruct HA as (_ & Ha); destruct (Ha s Hs) as (_ & _ & Ho).
  destruct (HR s Hs) as [_ Ho']; specialize (Ho r Hr Plus g); specialize (Ho' r Hr Plus g); tauto.
Qed.

Lemma below_radius s r : lo < s < hi -> 0 < r < Rad s -> h n j (d s) r < 0.
Proof.
  intros Hs Hr; destruct (proj2 HA s Hs) as (Hi & Hje & _). destruct (HR s Hs) as [Hx _].
  pose proof (h_increasing n j (d s) Hi r (Rad s) Hje ltac:(lra)). enough (~ 0 < h n j (d s) (Rad s)) by lra.
  intros Hpos; apply radius_h in Hpos; lra.
Qed.

Lemma above_near p r : 0 < r <= 1 -> h n j (d p) r > 0 ->
  exists de, de > 0 /\ forall s, lo < s < hi -> Rabs (s - p) < de -> Rad s < r.
Proof.
  intros Hr Hp; destruct (sign_near _ p (h_continuous_s r) Hp) as (de & Hd & Hnear).
  exists de; split; [assumption|]; intros s Hs Hsp. apply radius_h; trivial; exact (Hnear s Hsp).
Qed.

Lemma below_near p r : 0 < r <= 1 -> h n j (d p) r < 0 ->
  exists de, de > 0 /\ forall s, lo < s < hi -> Rabs (s - p) < de -> r <= Rad s.
Proof.
  intros Hr Hp; destruct (sign_near (fun s => - h n j (d s) r) p) as (de & Hd & Hnear).
  - exact (continuity_opp _ (h_continuous_s r)).
  - lra.
  - exists de; split; [assumption|]; intros s Hs Hsp; apply Rnot_lt_le; intros Hlt.
    apply radius_h in Hlt; trivial; specialize (Hnear s Hsp); lra.
Qed.

Lemma radius_continuous p : lo < p < hi -> continuity_pt Rad p.
Proof.
  intros Hp eps Heps; destruct (HR p Hp) as [Hx _]. set (r1 := Rmin (Rad p + eps / 2) 1).
  assert (Hr1 : Rad p < r1 <= 1 /\ r1 < Rad p + eps) by (unfold r1, Rmin; destruct Rle_dec; lra).
  destruct (above_near p r1) as (d1 & Hd1 & Hup); [lra|apply radius_h; lra|].
  assert (Hlow : exists d2, d2 > 0 /\ forall s, lo < s < hi -> Rabs (s - p) < d2 -> Rad p - eps < Rad s).
  { destruct (Rle_or_lt (Rad p - eps / 2) 0).
    - exists 1; split; [lra|]; intros s Hs _; destruct (HR s Hs); lra.
    - destruct (below_near p (Rad p - eps / 2)) as (d2 & Hd2 & Hdown); [lra|apply below_radius; lra|].
      exists d2; split; [assumption|]; intros s Hs Hsp; specialize (Hdown s Hs Hsp); lra. }
  destruct Hlow as (d2 & Hd2 & Hdown). set (de := Rmin (Rmin d1 d2) (Rmin (p - lo) (hi - p))).
  assert (Hde : 0 < de <= d1 /\ de <= d2 /\ de <= p - lo /\ de <= hi - p).
  { unfold de, Rmin; repeat destruct Rle_dec; lra. }
  exists de; split; [lra|]; intros s [_ Hs]; change (Rabs (s - p) < de) in Hs.
  change (Rabs (Rad s - Rad p) < eps); pose proof (Rabs_def2 _ _ Hs). assert (Hi : lo < s < hi) by lra.
  specialize (Hup s Hi ltac:(lra)); specialize (Hdown s Hi ltac:(lra)). apply Rabs_def1; lra.
Qed.

Lemma radius_to_1 p x : (forall r, 0 < r < 1 -> h n j (d p) r < 0) -> x < 1 ->
  exists de, de > 0 /\ forall s, lo < s < hi -> Rabs (s - p) < de -> x < Rad s.
Proof.
  intros Hp Hx; set (r := Rmax (1 / 2) ((x + 1) / 2)).
  assert (Hr : 0 < r < 1 /\ x < r) by (unfold r, Rmax; destruct Rle_dec; lra).
  destruct (below_near p r) as (de & Hd & Hnear); [lra|apply Hp; tauto|].
  exists de; split; [assumption|]; intros s Hs Hsp; specialize (Hnear s Hs Hsp); lra.
Qed.

End Graph.

Lemma denominator_plus m n mp np mm nm : (0 < 2 * m < n)%nat -> neighbours m n mp np mm nm ->
  m <> 1%nat -> (3 <= np)%nat.
Proof.
  intros Hm (? & ? & _) Hm1.
  assert (np <> 1 /\ np <> 2)%nat; [|lia]; split; intros ->; (destruct mp as [|q]; [|pose proof (Nat.le_0_l (q * n))]);
    simpl in *; lia.
Qed.

Lemma denominator_minus m n mp np mm nm : (0 < 2 * m < n)%nat -> neighbours m n mp np mm nm ->
  (nm = 2 /\ mm = 1)%nat \/ (3 <= nm)%nat.
Proof.
  intros Hm (_ & _ & ? & E); destruct mm as [|q]; [lia|]; simpl in E.
  assert (q = 0 \/ n <= q * n)%nat as [->|Hq] by (destruct q as [|q']; [tauto|right; simpl; lia]).
  - destruct (Nat.eq_dec nm 1) as [->|]; [lia|]; destruct (Nat.eq_dec nm 2); lia.
  - destruct (le_lt_dec nm 2) as [Hle|]; [|lia]; apply (Nat.mul_le_mono_l _ _ m) in Hle; lia.
Qed.

(** Next to 1/(2n) the radius is 0. *)
Lemma h_0_nonneg n s : (3 <= n)%nat -> 1 / (2 * INR n) < s <= 1 / (2 * (INR n - 1)) -> 0 <= h n 1 (1 - INR n * s) 0.
Proof.
  intros Hn [Hlo Hhi]; assert (Hn3 : 3 <= INR n) by (apply le_INR in Hn; simpl in Hn; lra).
  pose proof PI_RGT_0; apply (Rmult_lt_compat_l (2 * INR n)) in Hlo; [|lra].
  apply (Rmult_le_compat_l (2 * (INR n - 1))) in Hhi; [|lra].
  replace (2 * INR n * (1 / (2 * INR n))) with 1 in Hlo by (field; lra).
  replace (2 * (INR n - 1) * (1 / (2 * (INR n - 1)))) with 1 in Hhi by (field; lra). unfold h; rewrite !pow_i by lia.
  set (x := angle_A (1 - INR n * s) + angle_B n 1 (1 - INR n * s)).
  assert (E : x = PI + PI * (1 - 2 * (INR n - 1) * s)) by (unfold x, angle_A, angle_B; simpl; field; lra).
  rewrite E, sin_plus, sin_PI, cos_PI. assert (0 < s) by nra; assert (0 <= 2 * (INR n - 1) * s) by nra.
  set (y := 2 * (INR n - 1) * s) in *; clearbody y. pose proof (sin_ge_0 (PI * (1 - y)) ltac:(nra) ltac:(nra)); lra.
Qed.

Section Ends.

Variables n m mp np mm nm : nat.
Hypothesis Hn : (3 <= n)%nat.
Hypothesis Hm : (0 < 2 * m < n)%nat.
Hypothesis HF : neighbours m n mp np mm nm.

Let Hn3 : 3 <= INR n.
Proof. apply le_INR in Hn; simpl in Hn; lra. Qed.

Lemma left_graph_lo : (3 <= np)%nat -> INR m - INR n * (INR mp / INR np) = / INR np.
Proof.
  intros; destruct (neighbours_R _ _ _ _ _ _ Hn HF) as (E & _ & _ & _ & Hp & _).
  apply (Rmult_eq_reg_r (INR np)); [|lra]; field_simplify; lra.
Qed.

Lemma right_graph_hi : (3 <= nm)%nat -> INR n * (INR mm / INR nm) - INR m = / INR nm.
Proof.
  intros; destruct (neighbours_R _ _ _ _ _ _ Hn HF) as (_ & E & _ & _ & _ & Hp).
  apply (Rmult_eq_reg_r (INR nm)); [|lra]; field_simplify; lra.
Qed.

Lemma right_lo_not_first : INR m / INR n <> 1 / (2 * INR n).
Proof.
  intros E; destruct (m_bounds n m Hn Hm) as (_ & H1 & _). apply (f_equal (Rmult (INR n))) in E.
  replace (INR n * (INR m / INR n)) with (INR m) in E by (field; lra).
  replace (INR n * (1 / (2 * INR n))) with (1 / 2) in E by (field; lra); lra.
Qed.

Lemma left_lo_not_first : m <> 1%nat -> INR mp / INR np <> 1 / (2 * INR n).
Proof.
  intros Hm1 E; destruct (neighbours_R _ _ _ _ _ _ Hn HF) as (_ & _ & S & _ & Hp & Hp').
  apply (f_equal (Rmult (2 * INR n * INR np))) in E.
  replace (2 * INR n * INR np * (INR mp / INR np)) with (2 * INR n * INR mp) in E by (field; lra).
  replace (2 * INR n * INR np * (1 / (2 * INR n))) with (INR np) in E by (field; lra).
  destruct mp as [|mp']; [simpl in E; lra|]. rewrite S_INR in E; pose proof (pos_INR mp'); nra.
Qed.

End Ends.

Lemma S4_graph_proof n g lo hi Rad : (3 <= n)%nat -> interval n Plus g lo hi -> radius n Plus g lo hi Rad ->
  (forall s, lo < s < hi -> continuity_pt Rad s) /\ (hi <> 1 / 2 -> tends_to_1 Rad lo hi hi) /\
  (lo <> 1 / (2 * INR n) -> tends_to_1 Rad lo hi lo) /\ (lo = 1 / (2 * INR n) -> forall s, lo < s < hi ->
  s <= 1 / (2 * (INR n - 1)) -> Rad s = 0).
Proof.
  intros Hn HI HR. assert (Hn3 : 3 <= INR n) by (apply le_INR in Hn; simpl in Hn; lra).
  split; [destruct (interval_area n g lo hi Hn HI) as (j & d & HA); intros; eapply radius_continuous; eassumption|].
  pose proof (view _ _ _ _ _ HI) as HV; inversion HV as [|m mp np mm nm Hm HF|m mp np mm nm Hm HF]; subst.
  - pose proof (left_area n m mp np mm nm Hn Hm HF) as HA. split; [|split]; [intros _ x Hx|intros Hlo x Hx|intros Hlo].
    + apply (radius_to_1 n Plus _ _ np _ Rad HA HR _ x); [|assumption]; intros r Hr.
      replace (INR m - INR n * (INR m / INR n)) with 0 by (field; lra); now apply h_end_0.
    + destruct (Nat.eqb_spec m 1) as [|Hm1]; [tauto|]. pose proof (denominator_plus m n mp np mm nm Hm HF Hm1) as Hp.
      apply (radius_to_1 n Plus _ _ np _ Rad HA HR _ x); [|assumption]; intros r Hr.
      rewrite (left_graph_lo n m mp np mm nm) by assumption; now apply h_end_1.
    + destruct (Nat.eqb_spec m 1) as [->|Hm1].
      2:{ now apply (left_lo_not_first n m mp np mm nm Hn HF Hm1) in Hlo. }
      assert (np = 1)%nat as -> by (destruct HF as (? & ? & _), mp; lia || nia).
      intros s Hs Hle; destruct (HR s Hs) as [[[Hpos|E] Hx] _]; [exfalso|easy].
      pose proof (below_radius n Plus _ _ 1 _ Rad HA HR s (Rad s / 2) Hs ltac:(lra)) as Hneg.
      destruct (proj2 HA s Hs) as (Hi & Hje & _). pose proof (h_0_nonneg n s Hn ltac:(lra)).
      pose proof (h_increasing n 1 _ Hi 0 (Rad s / 2) Hje ltac:(lra)); simpl in *; lra.
  - pose proof (right_area n m mp np mm nm Hn Hm HF) as HA. split; [|split]; [intros Hhi x Hx|intros _ x Hx|intros Hlo].
    + destruct (denominator_minus m n mp np mm nm Hm HF) as [[-> ->]|Hp]; [simpl in Hhi; lra|].
      apply (radius_to_1 n Minus _ _ nm _ Rad HA HR _ x); [|assumption]; intros r Hr.
      rewrite (right_graph_hi n m mp np mm nm) by assumption; now apply h_end_1.
    + apply (radius_to_1 n Minus _ _ nm _ Rad HA HR _ x); [|assumption]; intros r Hr.
      replace (INR n * (INR m / INR n) - INR m) with 0 by (field; lra); now apply h_end_0.
    + now apply (right_lo_not_first n m Hn Hm) in Hlo.
Qed.
