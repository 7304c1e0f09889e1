(** * At fixed r an area meets the circle of radius r in one interval: S4's last part

    Section 7 of ../conjecture1.md. h > 0 iff K > 0, where K = atan phi(r^n, A) +
    atan phi(r^j, B), phi(q, x) = (q - cos x)/sin x. The angle
    pi/2 + atan phi(q, x) is the argument of exp(i x) - q, which is concave in x
    (its derivative is a Poisson kernel), and A and B are affine in s. *)

From Coq Require Import Reals Arith Classical Lra Lia.
From Grazing Require Import Defs Statement Farey Sine Radius Graph.
Open Scope R_scope.

Definition phi_q (q x : R) : R := (q - cos x) / sin x.

(** |exp(i x) - q|^2, and the derivative of the argument of exp(i x) - q. *)
Definition dist2 (q x : R) : R := 1 - 2 * q * cos x + q ^ 2.
Definition kernel (q x : R) : R := (1 - q * cos x) / dist2 q x.

Section Argument.

Variable q : R.
Hypothesis Hq : 0 < q < 1.

Lemma dist2_pos x : 0 < dist2 q x. Proof. unfold dist2; pose proof (COS_bound x); nra. Qed.

Lemma argument_derivative x : 0 < x < PI -> derivable_pt_lim (fun x => atan (phi_q q x)) x (kernel q x).
Proof.
  intros Hx; assert (Hs : 0 < sin x) by (apply sin_gt_0; lra).
  pose proof (dist2_pos x) as Hd; pose proof (sin2_cos2 x) as T; unfold Rsqr in T.
  assert (Dphi : derivable_pt_lim (phi_q q) x ((1 - q * cos x) / (sin x)²)).
  { replace ((1 - q * cos x) / (sin x)²) with (((0 - - sin x) * sin x - cos x * (q - cos x)) / (sin x)²).
    - apply (derivable_pt_lim_div (fun y => q - cos y) sin x); [|apply derivable_pt_lim_sin|lra].
      apply (derivable_pt_lim_minus (fct_cte q) cos); [apply derivable_pt_lim_const|apply derivable_pt_lim_cos].
    - f_equal; lra. }
  replace (kernel q x) with (/ (1 + (phi_q q x) ^ 2) * ((1 - q * cos x) / (sin x)²)).
  - apply (derivable_pt_lim_comp (phi_q q) atan); [exact Dphi|apply derivable_pt_lim_atan].
  - assert (E : 1 + phi_q q x ^ 2 = dist2 q x / (sin x * sin x)).
    { unfold phi_q, dist2; replace (1 - 2 * q * cos x + q ^ 2) with (sin x * sin x + (q - cos x) ^ 2) by (rewrite <- T;
        ring); field; lra. }
    rewrite E; unfold kernel, Rsqr; field; split; lra.
Qed.

Lemma kernel_decreasing x y : 0 < x < y -> y < PI -> kernel q y < kernel q x.
Proof.
  intros Hx Hy; pose proof PI_RGT_0. assert (Hc : cos y < cos x) by (apply cos_decreasing_1; lra).
  assert (E : forall z, kernel q z = 1 / 2 + (1 - q ^ 2) / 2 * / dist2 q z).
  { intros z; pose proof (dist2_pos z); unfold kernel; unfold dist2 in *; field; lra. }
  rewrite !E; apply Rplus_lt_compat_l, Rmult_lt_compat_l; [nra|].
  apply Rinv_lt_contravar; [apply Rmult_lt_0_compat; apply dist2_pos|unfold dist2; nra].
Qed.

Lemma argument_tangent x0 x : 0 < x0 < PI -> 0 < x < PI ->
  atan (phi_q q x) <= atan (phi_q q x0) + kernel q x0 * (x - x0).
Proof.
  intros H0 H; destruct (Rtotal_order x0 x) as [Hlt|[->|Hlt]]; [|lra|].
  - destruct (MVT_cor2 (fun x => atan (phi_q q x)) (kernel q) x0 x Hlt) as (z & E & Hz).
    { intros; apply argument_derivative; lra. }
    cbv beta in E; pose proof (kernel_decreasing x0 z ltac:(lra) ltac:(lra)); nra.
  - destruct (MVT_cor2 (fun x => atan (phi_q q x)) (kernel q) x x0 Hlt) as (z & E & Hz).
    { intros; apply argument_derivative; lra. }
    cbv beta in E; pose proof (kernel_decreasing z x0 ltac:(lra) ltac:(lra)); nra.
Qed.

End Argument.

Section Convex_in_e.

Variables (n j : nat) (r : R).
Hypothesis Hr : 0 < r < 1.

Definition K (e : R) : R :=
  atan (phi_q (r ^ n) (angle_A e)) + atan (phi_q (r ^ j) (angle_B n j e)).

Lemma h_K e : index n j e -> INR j * e < 1 -> (0 < h n j e r <-> 0 < K e).
Proof.
  intros Hi Hje; pose proof (A_range n j e Hi); pose proof (B_range n j e Hi Hje).
  assert (HA : 0 < sin (angle_A e)) by (apply sin_gt_0; lra).
  assert (HB : 0 < sin (angle_B n j e)) by (apply sin_gt_0; lra).
  set (x := phi_q (r ^ n) (angle_A e)); set (y := phi_q (r ^ j) (angle_B n j e)).
  assert (Eh : h n j e r = sin (angle_A e) * sin (angle_B n j e) * (x + y)).
  { unfold h, x, y, phi_q; rewrite sin_plus; field; lra. }
  assert (Hp : 0 < sin (angle_A e) * sin (angle_B n j e)) by now apply Rmult_lt_0_compat.
  unfold K; fold x y; rewrite Eh. transitivity (- y < x); [split; intros; nra|].
  transitivity (atan (- y) < atan x); [|rewrite atan_opp; lra].
  split; [apply atan_increasing|]; intros Hlt; apply Rnot_le_lt; intros [Hle|E]; [apply atan_increasing in Hle;
    lra|rewrite E in Hlt; lra].
Qed.

Lemma pow_unit k : (1 <= k)%nat -> 0 < r ^ k < 1.
Proof. intros Hk; split; [apply pow_lt; lra|]; rewrite <- (pow1 k); apply pow_lt_compat_l; [assumption|lra]. Qed.

Lemma K_concave e1 e2 e3 : index n j e1 -> index n j e3 -> INR j * e1 < 1 -> INR j * e3 < 1 ->
  e1 < e2 < e3 -> 0 < K e1 -> 0 < K e3 -> 0 < K e2.
Proof.
  intros H1 H3 J1 J3 He P1 P3.
  assert (Hj : 1 <= INR j) by (destruct H1 as (_ & [Hj _] & _); apply (le_INR 1) in Hj; exact Hj).
  assert (H2 : index n j e2) by (destruct H1 as (? & ? & ?), H3 as (_ & _ & ?); repeat split; tauto || lra).
  assert (J2 : INR j * e2 < 1) by nra. assert (Hn : (1 <= n)%nat /\ (1 <= j)%nat) by (destruct H1; lia).
  pose proof (n_ge_3 n j e1 H1) as [Hn3 _].
  pose proof (argument_tangent _ (pow_unit n (proj1 Hn)) _ _ (A_range _ _ _ H2) (A_range _ _ _ H1)).
  pose proof (argument_tangent _ (pow_unit n (proj1 Hn)) _ _ (A_range _ _ _ H2) (A_range _ _ _ H3)).
  pose proof (argument_tangent _ (pow_unit j (proj2 Hn)) _ _ (B_range _ _ _ H2 J2) (B_range _ _ _ H1 J1)).
  pose proof (argument_tangent _ (pow_unit j (proj2 Hn)) _ _ (B_range _ _ _ H2 J2) (B_range _ _ _ H3 J3)).
  set (u := kernel (r ^ n) (angle_A e2)) in *; set (w := kernel (r ^ j) (angle_B n j e2)) in *.
  set (c := u * (2 * PI) - w * (2 * PI * INR j / INR n)).
  assert (T : forall e, K e2 + c * (e - e2) = K e2 + u * (angle_A e - angle_A e2) + w * (angle_B n j e - angle_B n j
    e2)) by (intros e; unfold c, angle_A, angle_B; field; lra).
  assert (T1 : 0 < K e2 + c * (e1 - e2)) by (rewrite T; unfold K in *; lra).
  assert (T3 : 0 < K e2 + c * (e3 - e2)) by (rewrite T; unfold K in *; lra). clearbody c; destruct (Rle_or_lt 0 c); nra.
Qed.

End Convex_in_e.

(** ** Convex open subsets of an interval are intervals *)

Lemma sup_of (P : R -> Prop) lo hi : (exists x, lo < x < hi /\ P x) -> exists b, b <= hi /\ (forall x, lo < x < hi ->
  P x -> x <= b) /\ forall s, s < b -> exists z, s < z /\ lo < z < hi /\ P z.
Proof.
  intros Hex; destruct (completeness (fun x => lo < x < hi /\ P x)) as (b & Hb & Hb').
  { exists hi; intros x [? _]; lra. } { exact Hex. }
  exists b; split; [|split].
  - apply Hb'; intros x [? _]; lra.
  - intros x Hx Px; now apply Hb.
  - intros s Hs; apply NNPP; intros Hn; apply (Rlt_not_le _ _ Hs), Hb'; intros x Hx.
    apply Rnot_lt_le; intros Hlt; apply Hn; exists x; tauto.
Qed.

Lemma inf_of (P : R -> Prop) lo hi : (exists x, lo < x < hi /\ P x) -> exists a, lo <= a /\ (forall x, lo < x < hi ->
  P x -> a <= x) /\ forall s, a < s -> exists z, z < s /\ lo < z < hi /\ P z.
Proof.
  intros (x0 & Hx0 & P0); destruct (sup_of (fun x => P (- x)) (- hi) (- lo)) as (b & H1 & H2 & H3).
  { exists (- x0); rewrite Ropp_involutive; split; [lra|assumption]. }
  exists (- b); split; [lra|split].
  - intros x Hx Px; enough (- x <= b) by lra; apply H2; [lra|now rewrite Ropp_involutive].
  - intros s Hs; destruct (H3 (- s)) as (z & ? & ? & ?); [lra|exists (- z)]; repeat split; trivial; lra.
Qed.

Definition near (P : R -> Prop) (x : R) : Prop :=
  exists d, d > 0 /\ forall y, Rabs (y - x) < d -> P y.

Lemma convex_interval (P : R -> Prop) lo hi : lo < hi -> (forall x y z, P x -> P z -> lo < x -> z < hi -> x < y < z ->
  P y) -> (forall x, P x -> near P x) -> exists lo' hi', lo <= lo' /\ hi' <= hi /\ (forall s, lo < s < hi ->
  (P s <-> lo' < s < hi')) /\ (near P lo -> lo' = lo /\ lo < hi').
Proof.
  intros Hlh Hconv Hopen.
  assert (Hstart : near P lo -> forall c, lo < c -> exists y, lo < y < c /\ y < hi /\ P y).
  { intros (d & Hd & H) c Hc; set (y := Rmin (lo + d / 2) (Rmin ((lo + c) / 2) ((lo + hi) / 2))).
    assert (Hy : lo < y < c /\ y < hi /\ y < lo + d) by (unfold y, Rmin; repeat destruct Rle_dec; lra).
    exists y; split; [lra|split; [lra|]]; apply H, Rabs_def1; lra. }
  destruct (classic (exists x, lo < x < hi /\ P x)) as [Hex|Hno].
  2:{ exists lo, lo; split; [lra|split; [lra|split]].
      - intros s Hs; split; [intros; exfalso; eauto|lra].
      - intros HP; destruct (Hstart HP hi Hlh) as (y & ? & ? & ?); exfalso; apply Hno; exists y; tauto. }
  destruct (sup_of P lo hi Hex) as (b & Hb & Hb' & Hup). destruct (inf_of P lo hi Hex) as (a & Ha & Ha' & Hdown).
  exists a, b; split; [assumption|split; [assumption|split]].
  - intros s Hs; split.
    + intros Ps; destruct (Hopen s Ps) as (d & Hd & Hnear).
      set (y := Rmin (d / 2) (Rmin ((s - lo) / 2) ((hi - s) / 2))).
      assert (Hy : 0 < y <= d / 2 /\ y <= (s - lo) / 2 /\ y <= (hi - s) / 2) by (unfold y, Rmin;
        repeat destruct Rle_dec; lra).
      pose proof (Hb' (s + y) ltac:(lra) (Hnear (s + y) ltac:(apply Rabs_def1; lra))).
      pose proof (Ha' (s - y) ltac:(lra) (Hnear (s - y) ltac:(apply Rabs_def1; lra))); lra.
    + intros [H1 H2]; destruct (Hdown s H1) as (x & ? & ? & ?), (Hup s H2) as (z & ? & ? & ?).
      apply (Hconv x s z); trivial; lra.
  - intros HP; assert (a = lo) as ->.
    { apply Rle_antisym; [|assumption]; apply Rnot_lt_le; intros Hlt.
      destruct (Hstart HP a Hlt) as (y & Hy & Hyh & Py); pose proof (Ha' y ltac:(lra) Py); lra. }
    split; [reflexivity|]; destruct Hex as (x & Hx & Px); pose proof (Hb' x Hx Px); lra.
Qed.

(** ** The sections *)

Lemma area_section n g lo hi j d r : (3 <= n)%nat -> lo < hi -> 0 < r < 1 -> area n g lo hi j d -> exists lo' hi',
  lo <= lo' /\ hi' <= hi /\ (forall s, lo < s < hi -> (orbit_at r s n Plus g <-> lo' < s < hi')) /\
  (h n j (d lo) r > 0 -> lo' = lo /\ lo < hi').
Proof.
  intros Hn Hlh Hr HA; pose proof (h_continuous_s n g lo hi j d HA r) as Hcont.
  assert (Hspec : forall s, lo < s < hi -> (orbit_at r s n Plus g <-> h n j (d s) r > 0)).
  { intros s Hs; destruct (proj2 HA s Hs) as (_ & _ & Ho). specialize (Ho r ltac:(lra) Plus g); unfold orbit_at;
      tauto. }
  destruct (convex_interval (fun s => h n j (d s) r > 0) lo hi Hlh) as (lo' & hi' & H1 & H2 & H3 & H4).
  - intros x y z Px Pz Hx Hz Hy; destruct HA as ((p & q & E) & Ha).
    destruct (Ha x ltac:(lra)) as (Ix & Jx & _), (Ha y ltac:(lra)) as (Iy & Jy & _), (Ha z ltac:(lra)) as (Iz & Jz & _).
    apply (h_K n j r) in Px, Pz; trivial; apply (h_K n j r); trivial. destruct (Rtotal_order q 0) as [Hq|[->|Hq]].
    + apply (K_concave n j r Hr (d z) _ (d x)); trivial; rewrite !E; nra.
    + replace (d y) with (d x); [assumption|rewrite !E; ring].
    + apply (K_concave n j r Hr (d x) _ (d z)); trivial; rewrite !E; nra.
  - intros x Px; exact (sign_near _ x Hcont Px).
  - exists lo', hi'; split; [assumption|split; [assumption|split]].
    + intros s Hs; rewrite (Hspec s Hs); now apply H3.
    + intros Hlo; apply H4; exact (sign_near _ lo Hcont Hlo).
Qed.

Lemma h_first_pos n r : (3 <= n)%nat -> 0 < r < 1 -> h n 1 (1 / 2) r > 0.
Proof.
  intros Hn Hr; assert (Hn3 : 3 <= INR n) by (apply le_INR in Hn; simpl in Hn; lra).
  pose proof (two_pi_over (2 * INR n) ltac:(lra)) as Hs.
  assert (0 < sin (2 * PI / (2 * INR n))) by (apply sin_gt_0; lra). assert (0 < r ^ n) by (apply pow_lt; lra).
  unfold h; replace (angle_A (1 / 2)) with PI by (unfold angle_A; field).
  replace (angle_B n 1 (1 / 2)) with (2 * PI / (2 * INR n)) by (unfold angle_B; simpl; field; lra).
  rewrite (Rplus_comm PI), neg_sin, sin_PI; nra.
Qed.

Lemma S4_section_proof : S4_section_statement.
Proof.
  intros n e g lo hi r Hn HI Hr; assert (Hn3 : 3 <= INR n) by (apply le_INR in Hn; simpl in Hn; lra).
  pose proof (Count.interval_nonempty n e g lo hi Hn HI) as [[_ Hlh] _].
  pose proof (view _ _ _ _ _ HI) as HV; inversion HV as [|m mp np mm nm Hm HF|m mp np mm nm Hm HF]; subst.
  - exists 0, (1 / (2 * INR n)); split; [lra|split; [lra|split]].
    + intros E; exfalso; lra.
    + intros s Hs; split; [tauto|]; intros _. now apply (first_orbits n r s Hn ltac:(lra) Hs).
  - destruct (area_section n Plus _ _ _ _ r Hn Hlh Hr (left_area n m mp np mm nm Hn Hm HF))
      as (lo' & hi' & H1 & H2 & H3 & H4).
    exists lo', hi'; split; [assumption|split; [assumption|split; [|assumption]]].
    intros Hlo; apply H4; destruct (Nat.eqb_spec m 1) as [->|Hm1].
    2:{ now apply (left_lo_not_first n m mp np mm nm Hn HF Hm1) in Hlo. }
    assert (np = 1)%nat as -> by (destruct HF as (? & ? & _), mp; lia || nia).
    replace (INR 1 - INR n * (1 / (2 * INR n))) with (1 / 2) by (simpl; field; lra). now apply h_first_pos.
  - destruct (area_section n Minus _ _ _ _ r Hn Hlh Hr (right_area n m mp np mm nm Hn Hm HF))
      as (lo' & hi' & H1 & H2 & H3 & _).
    exists lo', hi'; split; [assumption|split; [assumption|split; [|assumption]]].
    intros Hlo; now apply (right_lo_not_first n m Hn Hm) in Hlo.
Qed.
