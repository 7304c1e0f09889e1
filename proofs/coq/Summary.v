(** * The summary by period of section 3.7 holds over the whole plane 0 < a2 <= 1

    Region 3 enters through S3 over Theorem 2's intervals. *)

From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import Defs Statement StatementPlane Algebra Cases Radius Above AppendixA Region4 Coordinates.
Open Scope R_scope.

(** The seven zones of the plane, from right to left. *)
Inductive zone (a1 a2 : R) : Prop :=
| zone1 : a2 + 1 < a1 -> zone a1 a2
| line_right : a1 = a2 + 1 -> zone a1 a2
| zone2 : a2 < 1 -> 2 * sqrt a2 <= a1 < a2 + 1 -> zone a1 a2
| zone3 : a1 ^ 2 < 4 * a2 -> zone a1 a2
| zone4 : a2 < 1 -> - (a2 + 1) < a1 <= - 2 * sqrt a2 -> zone a1 a2
| line_left : a1 = - (a2 + 1) -> zone a1 a2
| zone5 : a1 < - (a2 + 1) -> zone a1 a2.

Lemma sqrt_square a2 : 0 < a2 -> 0 < sqrt a2 /\ sqrt a2 * sqrt a2 = a2.
Proof. intros; split; [apply sqrt_lt_R0 | apply sqrt_sqrt]; lra. Qed.
Lemma two_sqrt_at_most a2 : 0 < a2 -> 2 * sqrt a2 <= a2 + 1.
Proof. intros H; destruct (sqrt_square a2 H) as [_ E]. pose proof (pow2_ge_0 (1 - sqrt a2)); lra. Qed.
Lemma below_1 a2 : 0 < a2 <= 1 -> 2 * sqrt a2 < a2 + 1 -> a2 < 1.
Proof. intros H Hs; destruct (Req_dec a2 1) as [->|]; [rewrite sqrt_1 in Hs|]; lra. Qed.
Lemma region3_between a1 a2 : 0 < a2 -> a1 ^ 2 < 4 * a2 -> - (2 * sqrt a2) < a1 < 2 * sqrt a2.
Proof. intros H H1; destruct (sqrt_square a2 H); split; nra. Qed.
Lemma zones a1 a2 : 0 < a2 <= 1 -> zone a1 a2.
Proof.
  intros H2; pose proof (two_sqrt_at_most a2 ltac:(lra)). destruct (sqrt_square a2 ltac:(lra)) as [Hs Es].
  destruct (Rtotal_order a1 (a2 + 1)) as [H1 | [H1 | H1]]; [| apply line_right, H1 | apply zone1, H1].
  destruct (Rtotal_order a1 (- (a2 + 1))) as [H4 | [H4 | H4]]; [apply zone5, H4 | apply line_left, H4 |].
  destruct (Rle_lt_dec (2 * sqrt a2) a1) as [Hr|Hr].
  { apply zone2; [apply below_1 |]; lra. }
  destruct (Rle_lt_dec a1 (- 2 * sqrt a2)) as [Hl|Hl].
  { apply zone4; [apply below_1 |]; lra. }
  apply zone3; nra.
Qed.
Lemma trace_above r s n : 0 < r -> 0 < s < 1 / 2 -> (1 <= n)%nat ->
  2 * r * cos (PI / INR n) < trace r s <-> s < 1 / (2 * INR n).
Proof.
  intros Hr Hs Hn; unfold trace; pose proof PI_RGT_0.
  assert (HN : 1 <= INR n) by (change 1 with (INR 1); apply le_INR; assumption). pose proof (two_pi_s s Hs) as Ht.
  assert (E : PI / INR n = 2 * PI * (1 / (2 * INR n))) by (field; lra). set (w := 1 / (2 * INR n)) in *.
  assert (Hw : 0 < w <= 1 / 2).
  { split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_le_reg_r with (2 * INR n); [lra|].
    unfold w, Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
  rewrite E; clearbody w. assert (0 <= 2 * PI * w <= PI) by (split; nra). split; intros H1.
  - apply Rmult_lt_reg_l in H1; [|lra]. apply cos_decreasing_0 in H1; [|lra..]. apply Rmult_lt_reg_l in H1; lra.
  - apply Rmult_lt_compat_l; [lra|]; apply cos_decreasing_1; [lra..|]. apply Rmult_lt_compat_l; lra.
Qed.
Lemma cos_below_1 n : (1 <= n)%nat -> cos (PI / INR n) < 1.
Proof.
  intros Hn; pose proof PI_RGT_0. assert (1 <= INR n) by (change 1 with (INR 1); apply le_INR; assumption).
  assert (0 < PI / INR n) by (apply Rdiv_lt_0_compat; lra).
  assert (PI / INR n <= PI).
  { apply Rmult_le_reg_r with (INR n); [lra|]. unfold Rdiv; rewrite Rmult_assoc, Rinv_l; nra. }
  rewrite <- cos_0; apply cos_decreasing_1; lra.
Qed.

Section Summary.
Variables (a1 a2 : R) (n : nat).
Hypothesis a2_in : 0 < a2 <= 1.
Hypothesis n_in : (3 <= n)%nat.

Lemma no_area3 g : 4 * a2 <= a1 ^ 2 -> ~ area3 a1 a2 n g.
Proof.
  intros H (r & s & k & lo & hi & Hr & Hs & -> & -> & _). pose proof (two_pi_s s Hs); pose proof PI_RGT_0.
  assert (-1 < cos (2 * PI * s)) by (rewrite <- cos_PI; apply cos_decreasing_1; lra).
  assert (cos (2 * PI * s) < 1) by (rewrite <- cos_0; apply cos_decreasing_1; lra).
  assert (cos (2 * PI * s) ^ 2 < 1) by nra. unfold trace in H; nra.
Qed.
Lemma area3_orbit g : area3 a1 a2 n g -> orbit a1 a2 n Plus g.
Proof.
  intros (r & s & k & lo & hi & Hr & Hs & E1 & E2 & HS & Hsi & Hb).
  assert (r <= 1) by (apply Rnot_lt_le; intros ?; nra). destruct (side_decided n k g lo hi n_in HS) as (j & d & _ & HD).
  destruct (HD r s Hsi ltac:(lra)) as (_ & [_ _ Hp _ _] & _); rewrite E1, E2 in *; auto.
Qed.
Lemma region3_orbit e g : a1 ^ 2 < 4 * a2 -> orbit a1 a2 n e g <-> 2 * sqrt a2 * cos (PI / INR n) < a1 /\ e = Minus /\
  g = Plus \/ area3 a1 a2 n g /\ e = Plus.
Proof.
  intros H; destruct (Coordinates a1 a2 H) as (r & s & Hr & Hs & E1 & E2 & _).
  assert (r <= 1) by (apply Rnot_lt_le; intros ?; nra).
  assert (Er : sqrt a2 = r) by (symmetry; apply root_unique; assumption).
  rewrite Er, E1, trace_above by (assumption || lia); rewrite <- E1; split.
  - intros Ho; assert (Ho' : orbit_at r s n e g) by (unfold orbit_at; rewrite <- E1, <- E2; assumption).
    destruct (orbit_in_interval n r s e g n_in ltac:(lra) Hs Ho') as (lo & hi & HI & Hsi).
    inversion HI as [|k g' lo' hi' HS]; subst; [left; tauto|right; split; [|reflexivity]].
    exists r, s, k, lo, hi; repeat split; try tauto. destruct (index_coprime n k g lo hi n_in HS) as [Hk _].
    destruct Ho as (_ & Hb & _); specialize (Hb k Hk); cbn [sgn] in Hb; lra.
  - intros [(Hlt & -> & ->) | [Ha ->]]; [|apply area3_orbit; assumption].
    rewrite E1, E2; apply (first_orbits n r s n_in ltac:(lra) ltac:(lra)); tauto.
Qed.
Lemma region4_orbit e g : a2 < 1 -> - (a2 + 1) < a1 <= - 2 * sqrt a2 ->
  orbit a1 a2 n e g <-> area4 a1 a2 n /\ e = Plus /\ g = Minus.
Proof.
  intros Hlt H1; destruct (region4_signs a1 a2 n) as (_ & He & Ho); [lra|lra|]; unfold area4.
  destruct (Nat.Even_or_Odd n) as [Hn|Hn].
  - assert (~ Nat.Odd n) by (intros [i Hi]; destruct Hn as [j Hj]; lia). assert (4 <= n)%nat by (destruct Hn; lia).
    split; [|tauto]; intros (_ & Hb & _). destruct He as (_ & k & k' & Hk & Hk' & Hbk & Hbk'); try assumption.
    apply Hb in Hk, Hk'; destruct e; cbn [sgn] in *; lra.
  - destruct (Ho n_in Hn) as (_ & Hex & _); rewrite (Hex e g). intuition lra.
Qed.
Lemma line_left_orbit e g : a1 = - (a2 + 1) -> orbit a1 a2 n e g <-> area4 a1 a2 n /\ e = Plus /\ g = Minus.
Proof.
  intros E; pose proof (two_sqrt_at_most a2 ltac:(lra)); unfold area4. destruct (Nat.Even_or_Odd n) as [Hn|Hn].
  - assert (~ Nat.Odd n) by (intros [i Hi]; destruct Hn as [j Hj]; lia). split; [|tauto]; intros (_ & _ & Hc).
    destruct (Lines a2 n ltac:(lra) ltac:(lia)) as (_ & _ & _ & _ & Hl); destruct (Hl Hn) as [E0 _].
    rewrite E, E0 in Hc; lra.
  - destruct (region5_signs a1 a2 n ltac:(lra) ltac:(lia) (or_intror (conj E Hn))) as (_ & Hb & _ & Hex);
      rewrite (Hex ltac:(lia) e g).
    specialize (Hb (n - 2)%nat ltac:(lia)); cbn beta in Hb; intuition lra.
Qed.
End Summary.

Theorem Summary : Summary_statement.
Proof.
  intros a1 a2 n e g H2 Hn. pose proof (two_sqrt_at_most a2 ltac:(lra)) as Hs2.
  destruct (sqrt_square a2 ltac:(lra)) as [Hs Es]. pose proof (no_area3 a1 a2 n H2 g) as H3.
  assert (Hcos : 2 * sqrt a2 * cos (PI / INR n) < 2 * sqrt a2) by (pose proof (cos_below_1 n ltac:(lia)); nra).
  assert (Hcos' : - (2 * sqrt a2) <= 2 * sqrt a2 * cos (PI / INR n)) by (pose proof (COS_bound (PI / INR n)); nra).
  destruct (zones a1 a2 H2) as [H|H|Hlt H|H|Hlt H|H|H].
  - destruct (region1_signs a1 a2 n ltac:(lra) H ltac:(lia)) as (_ & _ & _ & Hex).
    rewrite (Hex ltac:(lia) e g); specialize (H3 ltac:(nra)); unfold area4; intuition lra.
  - assert (Ho : ~ orbit a1 a2 n e g).
    { intros (_ & _ & Hc); destruct (Lines a2 n ltac:(lra) ltac:(lia)) as (_ & _ & E0 & _). rewrite H, E0 in Hc; lra. }
    specialize (H3 ltac:(nra)); unfold area4; intuition lra.
  - destruct (region2_signs a1 a2 n ltac:(lra) H ltac:(lia)) as (_ & _ & _ & Hex).
    rewrite (Hex ltac:(lia) e g); specialize (H3 ltac:(nra)); unfold area4. intuition lra.
  - rewrite (region3_orbit a1 a2 n H2 Hn e g H); clear H3.
    destruct (region3_between a1 a2 ltac:(lra) H); unfold area4; intuition lra.
  - rewrite (region4_orbit a1 a2 n H2 Hn e g Hlt H). specialize (H3 ltac:(nra)); intuition lra.
  - rewrite (line_left_orbit a1 a2 n H2 Hn e g H). specialize (H3 ltac:(nra)); intuition lra.
  - destruct (region5_signs a1 a2 n ltac:(lra) ltac:(lia) (or_introl H)) as (_ & _ & _ & Hex).
    rewrite (Hex ltac:(lia) e g); specialize (H3 ltac:(nra)); unfold area4; intuition lra.
Qed.
