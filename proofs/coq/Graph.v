(** * S4: the radius R(s) is continuous, and its limits at the ends

    Step 11 of the proof: R(s) < r iff h > 0 at r, and h is continuous in s. *)

From Coq Require Import Reals Arith Lra Lia.
From Grazing Require Import Defs Statement Farey Sine Radius Count.
Open Scope R_scope.

Lemma sign_near f p : continuity f -> f p > 0 ->
  exists d, d > 0 /\ forall s, Rabs (s - p) < d -> f s > 0.
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
  pose proof (two_pi_over (INR n) Hn3) as Hs.
  assert (0 < sin (2 * PI / INR n)) by (apply sin_gt_0; lra).
  assert (r ^ n < 1 ^ n) by (apply pow_lt_compat_l; [lia|lra]); rewrite pow1 in *.
  unfold h, angle_A, angle_B; rewrite !Rmult_0_r, sin_0, Rplus_0_l, Rminus_0_r, Rmult_1_r; nra.
Qed.

Lemma h_end_1 n j r : (3 <= j)%nat -> 0 < r < 1 -> h n j (/ INR j) r < 0.
Proof.
  intros Hj Hr; assert (Hj3 : 3 <= INR j) by (apply le_INR in Hj; simpl in Hj; lra).
  pose proof (two_pi_over (INR j) Hj3) as Hs.
  assert (0 < sin (2 * PI / INR j)) by (apply sin_gt_0; lra).
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
  revert s; unfold h, angle_A, angle_B, Rdiv; reg.
Qed.

Lemma radius_h s r : lo < s < hi -> 0 < r <= 1 -> (Rad s < r <-> 0 < h n j (d s) r).
Proof.
  intros Hs Hr; destruct HA as (_ & Ha); destruct (Ha s Hs) as (_ & _ & Ho).
  destruct (HR s Hs) as [_ Ho']; specialize (Ho r Hr Plus g); specialize (Ho' r Hr Plus g); tauto.
Qed.

Lemma below_radius s r : lo < s < hi -> 0 < r < Rad s -> h n j (d s) r < 0.
Proof.
  intros Hs Hr; destruct (proj2 HA s Hs) as (Hi & Hje & _).
  destruct (HR s Hs) as [Hx _].
  pose proof (h_increasing n j (d s) Hi r (Rad s) Hje ltac:(lra)).
  enough (~ 0 < h n j (d s) (Rad s)) by lra.
  intros Hpos; apply radius_h in Hpos; lra.
Qed.

Lemma above_near p r : 0 < r <= 1 -> h n j (d p) r > 0 ->
  exists de, de > 0 /\ forall s, lo < s < hi -> Rabs (s - p) < de -> Rad s < r.
Proof.
  intros Hr Hp; destruct (sign_near _ p (h_continuous_s r) Hp) as (de & Hd & Hnear).
  exists de; split; [assumption|]; intros s Hs Hsp; apply radius_h; auto.
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
  intros Hp eps Heps; destruct (HR p Hp) as [Hx _].
  set (r1 := Rmin (Rad p + eps / 2) 1).
  assert (Hr1 : Rad p < r1 <= 1 /\ r1 < Rad p + eps) by (unfold r1, Rmin; destruct Rle_dec; lra).
  destruct (above_near p r1) as (d1 & Hd1 & Hup); [lra|apply radius_h; lra|].
  assert (Hlow : exists d2, d2 > 0 /\ forall s, lo < s < hi -> Rabs (s - p) < d2 -> Rad p - eps < Rad s).
  { destruct (Rle_or_lt (Rad p - eps / 2) 0).
    - exists 1; split; [lra|]; intros s Hs _; destruct (HR s Hs); lra.
    - destruct (below_near p (Rad p - eps / 2)) as (d2 & Hd2 & Hdown); [lra|apply below_radius; lra|].
      exists d2; split; [assumption|]; intros s Hs Hsp; specialize (Hdown s Hs Hsp); lra. }
  destruct Hlow as (d2 & Hd2 & Hdown).
  set (de := Rmin (Rmin d1 d2) (Rmin (p - lo) (hi - p))).
  assert (Hde : 0 < de <= d1 /\ de <= d2 /\ de <= p - lo /\ de <= hi - p).
  { unfold de, Rmin; repeat destruct Rle_dec; lra. }
  exists de; split; [lra|]; intros s [_ Hs]; change (Rabs (s - p) < de) in Hs.
  change (Rabs (Rad s - Rad p) < eps); pose proof (Rabs_def2 _ _ Hs).
  assert (Hi : lo < s < hi) by lra.
  specialize (Hup s Hi ltac:(lra)); specialize (Hdown s Hi ltac:(lra)).
  apply Rabs_def1; lra.
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
  assert (np <> 1 /\ np <> 2)%nat; [|lia]; split; intros ->; destruct mp; lia || nia.
Qed.

Lemma denominator_minus m n mp np mm nm : (0 < 2 * m < n)%nat -> neighbours m n mp np mm nm ->
  (nm = 2 /\ mm = 1)%nat \/ (3 <= nm)%nat.
Proof.
  intros Hm (_ & _ & ? & ?); assert (nm <> 1)%nat by (intros ->; destruct mm; nia).
  destruct (Nat.eq_dec nm 2) as [->|]; [left|lia]; destruct mm as [|[|]]; nia.
Qed.

(** Next to 1/(2n) the radius is 0. *)
Lemma h_0_nonneg n s : (3 <= n)%nat -> 1 / (2 * INR n) < s <= 1 / (2 * (INR n - 1)) ->
  0 <= h n 1 (1 - INR n * s) 0.
Proof.
  intros Hn [Hlo Hhi]; assert (Hn3 : 3 <= INR n) by (apply le_INR in Hn; simpl in Hn; lra).
  pose proof PI_RGT_0; apply (Rmult_lt_compat_l (2 * INR n)) in Hlo; [|lra].
  apply (Rmult_le_compat_l (2 * (INR n - 1))) in Hhi; [|lra].
  replace (2 * INR n * (1 / (2 * INR n))) with 1 in Hlo by (field; lra).
  replace (2 * (INR n - 1) * (1 / (2 * (INR n - 1)))) with 1 in Hhi by (field; lra).
  unfold h; rewrite !pow_i by lia.
  set (x := angle_A (1 - INR n * s) + angle_B n 1 (1 - INR n * s)).
  assert (E : x = PI + PI * (1 - 2 * (INR n - 1) * s)) by (unfold x, angle_A, angle_B; simpl; field; lra).
  rewrite E, sin_plus, sin_PI, cos_PI.
  pose proof (sin_ge_0 (PI * (1 - 2 * (INR n - 1) * s)) ltac:(nra) ltac:(nra)); lra.
Qed.

Lemma S4_graph_proof : S4_graph_statement.
Proof.
  intros n g lo hi Rad Hn HI HR; assert (Hn3 : 3 <= INR n) by (apply le_INR in Hn; simpl in Hn; lra).
  split; [destruct (interval_area n g lo hi Hn HI) as (j & d & HA);
          intros; eapply radius_continuous; eassumption|].
Admitted.
