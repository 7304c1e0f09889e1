(** * The deciding b of the leftmost area, n odd, changes sign once along a fixed determinant

    The end of statement S5. With a1 = -r X, a2 = r^2 and U_k = u_k at (X, 1), the sign
    of b_{n,n-2} is that of G = r^2 U_n - U_{n-2} + r^n X. For n >= 5

      G / U_n = r^2 - W_{h-2} / W_h - (1 - r^n) X / U_n,   W_k = U_{k+1} + U_k, n = 2h+1,

    and both quotients fall with X, since U_{k+1} / U_k = X - U_{k-1} / U_k rises, and
    likewise for W. So G changes sign once between 2 cos (pi/n) and r + 1/r, across
    s = 1/2, and no trigonometric or hyperbolic functions are needed but at the end. *)

From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import Defs Statement StatementPlane Polar Algebra RealEigenvalues
  Cases AppendixA Region4 Coordinates Summary.
Open Scope R_scope.

(** ** Ratios of a three-term recurrence rise *)
Section Ratios.
Variable s : R -> nat -> R.
Hypothesis recurrence : forall X k, s X (S (S k)) = X * s X (S k) - s X k.
Variables x0 x1 : R.
Hypothesis x01 : x0 < x1.
Hypothesis start_pos : 0 < s x1 0.
Hypothesis start : s x0 1 * s x1 0 < s x1 1 * s x0 0.

Lemma ratio_rises k : (forall j, (j <= k)%nat -> 0 < s x0 j) -> 0 < s x1 k /\ s x0 (S k) * s x1 k < s x1 (S k) * s x0 k.
Proof.
  induction k as [|k IH]; intros H0; [tauto|]. destruct IH as [Hk Hr]; [intros; apply H0; lia|].
  pose proof (H0 k ltac:(lia)); pose proof (H0 (S k) ltac:(lia)).
  assert (0 < s x1 (S k)).
  { assert (0 < s x0 (S k) * s x1 k) by (apply Rmult_lt_0_compat; assumption); nra. }
  split; [assumption|rewrite !recurrence].
  assert (0 < (x1 - x0) * (s x0 (S k) * s x1 (S k))) by (repeat apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma positive_to_the_right k : (forall j, (j <= k)%nat -> 0 < s x0 j) -> 0 <= s x0 (S k) -> 0 < s x1 (S k).
Proof.
  intros H0 Hk; destruct (ratio_rises k H0) as [H1 Hr]. pose proof (H0 k ltac:(lia)).
  assert (0 <= s x0 (S k) * s x1 k) by (apply Rmult_le_pos; lra); nra.
Qed.

Lemma quotient_rises i d : (forall j, (j <= i + d)%nat -> 0 < s x0 j) ->
  0 <= s x0 (S (i + d)) -> s x0 (S (i + d)) * s x1 i < s x1 (S (i + d)) * s x0 i.
Proof.
  induction d as [|d IH]; intros H0 Hd.
  - rewrite Nat.add_0_r in *; apply ratio_rises; assumption.
  - rewrite Nat.add_succ_r in *. pose proof (H0 (S (i + d)) ltac:(lia)) as Hj; pose proof (H0 i ltac:(lia)) as Hi.
    specialize (IH ltac:(intros; apply H0; lia) ltac:(lra)). destruct (ratio_rises (S (i + d)) H0) as [H1 Hr].
    set (y0 := s x0 (S (i + d))) in *; set (y1 := s x1 (S (i + d))) in *.
    apply Rmult_lt_reg_r with (y0 * y1); [apply Rmult_lt_0_compat; assumption|].
    assert (E : s x0 (S (S (i + d))) * y1 * (y0 * s x1 i) <= s x1 (S (S (i + d))) * y0 * (y0 * s x1 i)).
    { apply Rmult_le_compat_r; [|lra]. destruct (ratio_rises i) as [Hi1 _]; [intros; apply H0; lia|].
      apply Rmult_le_pos; lra. }
    assert (E' : s x1 (S (S (i + d))) * y0 * (y0 * s x1 i) < s x1 (S (S (i + d))) * y0 * (y1 * s x0 i)).
    { apply Rmult_lt_compat_l; [|assumption]. apply Rmult_lt_0_compat; [apply positive_to_the_right|]; assumption. }
    lra.
Qed.
End Ratios.

(** ** U_k and W_k *)
Lemma u_scale t a d k : t * u (t * a) (t ^ 2 * d) k = t ^ k * u a d k.
Proof.
  induction k using two_step; [rewrite !u_0; ring | rewrite !u_1; cbn; ring |]. rewrite !u_SS.
  replace (t * (t * a * u (t * a) (t ^ 2 * d) (S k) - t ^ 2 * d * u (t * a) (t ^ 2 * d) k))
    with (t * a * (t * u (t * a) (t ^ 2 * d) (S k)) - t ^ 2 * d * (t * u (t * a) (t ^ 2 * d) k)) by ring.
  rewrite IHk, IHk0; cbn; ring.
Qed.

Lemma u_sum a1 a2 j k : u a1 a2 (S (j + k)) = u a1 a2 (S j) * u a1 a2 (S k) - a2 * (u a1 a2 j * u a1 a2 k).
Proof.
  induction j using two_step; cbn [Nat.add].
  - rewrite u_1, u_0; ring.
  - rewrite u_2, u_1, u_SS; ring.
  - rewrite (u_SS _ _ (S (j + k))); cbn [Nat.add] in IHj0; rewrite IHj0, IHj. rewrite !u_SS; ring.
Qed.

Definition U (X : R) (k : nat) : R := u X 1 k.
Definition W (X : R) (k : nat) : R := U X (S k) + U X k.

Lemma U_SS X k : U X (S (S k)) = X * U X (S k) - U X k. Proof. unfold U; rewrite u_SS; ring. Qed.
Lemma W_SS X k : W X (S (S k)) = X * W X (S k) - W X k. Proof. unfold W; rewrite !U_SS; ring. Qed.

(** With n = 2h + 5: both factor through Z = U_{h+3} - U_{h+2}. *)
Lemma U_factors X h : U X (2 * h + 5) = (U X (h + 3) - U X (h + 2)) * W X (h + 2) /\
  U X (2 * h + 3) - X = (U X (h + 3) - U X (h + 2)) * W X h.
Proof.
  unfold W, U. pose proof (u_sum X 1 (h + 2) (h + 2)) as E5.
  pose proof (u_sum X 1 (h + 2) h) as E3; pose proof (u_addition X 1 2 h) as E2. rewrite pow1, u_2 in E2.
  replace (S (h + 2 + (h + 2)))%nat with (2 * h + 5)%nat in E5 by lia.
  replace (S (h + 2 + h))%nat with (2 * h + 3)%nat in E3 by lia. replace (2 + h)%nat with (h + 2)%nat in E2 by lia.
  replace (S (h + 2)) with (h + 3)%nat in * by lia. split; lra.
Qed.

(** ** G changes sign once *)
Definition G (r X : R) (n : nat) : R := r ^ 2 * U X n - U X (n - 2) + r ^ n * X.

Section OneSignChange.
Variables (r x0 x1 : R) (h : nat).
Notation n := (2 * h + 5)%nat.
Hypothesis r_in : 0 < r < 1.
Hypothesis x0_pos : 0 < x0.
Hypothesis x01 : x0 < x1.
Hypothesis U_pos : forall k, (1 <= k <= n)%nat -> 0 < U x0 k.

Lemma U_pos_right k : (1 <= k <= n)%nat -> 0 < U x1 k.
Proof.
  intros Hk; destruct k as [|[|k]]; [lia | unfold U; rewrite u_1; lra |].
  apply (positive_to_the_right (fun X k => U X (S k))) with x0; try assumption.
  - intros; apply U_SS.
  - unfold U; rewrite u_1; lra.
  - unfold U; rewrite !u_1, !u_2; lra.
  - intros; apply U_pos; lia.
  - apply Rlt_le, U_pos; lia.
Qed.

Lemma X_over_U_falls : x1 * U x0 n < x0 * U x1 n.
Proof.
  set (s X k := U X (S k)). assert (s0 : 0 < s x1 0%nat) by (unfold s, U; rewrite u_1; lra).
  assert (s1 : s x0 1%nat * s x1 0%nat < s x1 1%nat * s x0 0%nat) by (unfold s, U; rewrite !u_2, !u_1; lra).
  pose proof (quotient_rises s ltac:(intros; apply U_SS) x0 x1 x01 s0 s1 1 (2 * h + 2)) as H.
  unfold s in H; replace (S (S (1 + (2 * h + 2)))) with n in H by lia.
  replace (U x0 2) with x0 in H by (unfold U; rewrite u_2; reflexivity).
  replace (U x1 2) with x1 in H by (unfold U; rewrite u_2; reflexivity). enough (U x0 n * x1 < U x1 n * x0) by lra.
  apply H; [intros; apply U_pos; lia | apply Rlt_le, U_pos; lia].
Qed.

Lemma W_pos k : (k <= h + 2)%nat -> 0 < W x0 k.
Proof.
  intros Hk; unfold W; pose proof (U_pos (S k) ltac:(lia)). destruct k as [|k]; [unfold U at 2; rewrite u_0; lra|].
  pose proof (U_pos (S k) ltac:(lia)); lra.
Qed.

Lemma W_quotient_falls : W x1 h * W x0 (h + 2) < W x0 h * W x1 (h + 2).
Proof.
  assert (s0 : 0 < W x1 0) by (unfold W, U; rewrite u_1, u_0; lra).
  assert (s1 : W x0 1 * W x1 0 < W x1 1 * W x0 0) by (unfold W, U; rewrite !u_2, !u_1, !u_0; lra).
  pose proof (quotient_rises W W_SS x0 x1 x01 s0 s1 h 1) as H. replace (S (h + 1)) with (h + 2)%nat in H by lia.
  enough (W x0 (h + 2) * W x1 h < W x1 (h + 2) * W x0 h) by lra.
  apply H; [intros; apply W_pos; lia | apply Rlt_le, W_pos; lia].
Qed.

Lemma G_stays_positive : 0 <= G r x0 n -> 0 < G r x1 n.
Proof.
  pose proof (U_pos n ltac:(lia)) as H0; pose proof (U_pos_right n ltac:(lia)) as H1.
  assert (HW : forall X, 0 < U X (h + 3) -> 0 < U X (h + 2) -> 0 < W X (h + 2)).
  { intros X; unfold W; replace (S (h + 2)) with (h + 3)%nat by lia; lra. }
  pose proof (HW x0 ltac:(apply U_pos; lia) ltac:(apply U_pos; lia)).
  pose proof (HW x1 ltac:(apply U_pos_right; lia) ltac:(apply U_pos_right; lia)).
  unfold G; replace (n - 2)%nat with (2 * h + 3)%nat by lia.
  destruct (U_factors x0 h) as [E5 E3], (U_factors x1 h) as [F5 F3].
  pose proof W_quotient_falls as Hq; pose proof X_over_U_falls as Hx.
  set (z0 := U x0 (h + 3) - U x0 (h + 2)) in *; set (z1 := U x1 (h + 3) - U x1 (h + 2)) in *.
  assert (0 < z0) by (rewrite E5 in H0; nra); assert (0 < z1) by (rewrite F5 in H1; nra).
  assert (Hp : (U x1 (2 * h + 3) - x1) * U x0 n < (U x0 (2 * h + 3) - x0) * U x1 n).
  { rewrite E3, F3, E5, F5; apply Rmult_lt_compat_l with (r := z0 * z1) in Hq; [lra | apply Rmult_lt_0_compat;
      assumption]. }
  assert (Hr : 0 < 1 - r ^ n) by (pose proof (pow_below_1 r n r_in ltac:(lia)); lra).
  intros HG; apply Rmult_lt_reg_r with (U x0 n); [assumption|].
  apply Rmult_lt_compat_l with (r := 1 - r ^ n) in Hx; [|assumption].
  apply Rmult_le_compat_r with (r := U x1 n) in HG; [lra | lra].
Qed.
End OneSignChange.

Lemma G_3_stays_positive r x0 x1 : 0 < r -> 0 < x0 < x1 -> 0 <= G r x0 3 -> 0 < G r x1 3.
Proof.
  intros Hr Hx; unfold G; cbn [Nat.sub]; unfold U; rewrite !u_SS, !u_1, !u_0.
  pose proof (pow_lt r 3 Hr); pose proof (pow_lt r 2 Hr); intros H1.
  assert (0 < r ^ 2 * (x1 ^ 2 - x0 ^ 2)) by (apply Rmult_lt_0_compat; nra).
  assert (0 < r ^ 3 * (x1 - x0)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(** ** The ends of the section: X = 2 cos (pi/n) and X = r + 1/r *)
Section Ends.
Variable n : nat.
Hypothesis n_in : (3 <= n)%nat.
Definition left_end : R := 2 * cos (PI / INR n).
Notation c0 := left_end.

Lemma angle : 0 < PI / INR n <= PI / 3 /\ INR n * (PI / INR n) = PI.
Proof.
  pose proof PI_RGT_0; apply le_INR in n_in; cbn [INR] in n_in. split; [split | field; lra].
  - apply Rdiv_lt_0_compat; lra.
  - apply Rmult_le_reg_r with (3 * INR n); [lra|]. replace (PI / INR n * (3 * INR n)) with (3 * PI) by (field; lra).
    replace (PI / 3 * (3 * INR n)) with (INR n * PI) by field; nra.
Qed.

Lemma U_left_end k : U c0 k * sin (PI / INR n) = sin (INR k * (PI / INR n)).
Proof.
  pose proof angle as [Ha _]; pose proof PI_RGT_0. pose proof (u_polar 1 (PI / INR n) k) as H1.
  unfold U, left_end; rewrite Rmult_1_r, !pow1, !Rmult_1_l in H1; exact H1.
Qed.

Lemma left_end_pos : 0 < c0.
Proof.
  pose proof angle as [Ha _]; pose proof PI_RGT_0; unfold left_end.
  pose proof (cos_gt_0 (PI / INR n) ltac:(lra) ltac:(lra)); lra.
Qed.

Lemma sin_angle : 0 < sin (PI / INR n).
Proof. pose proof angle as [Ha _]; pose proof PI_RGT_0; apply sin_gt_0; lra. Qed.

Lemma U_left_end_pos k : (1 <= k <= n - 1)%nat -> 0 < U c0 k.
Proof.
  intros Hk; pose proof sin_angle; pose proof angle as [Ha E].
  enough (0 < U c0 k * sin (PI / INR n)) by nra; rewrite U_left_end.
  assert (1 <= INR k) by (change 1 with (INR 1); apply le_INR; lia). assert (INR k < INR n) by (apply lt_INR; lia).
  set (t := PI / INR n) in *; apply sin_gt_0; [nra|].
  apply Rlt_le_trans with (INR n * t); [apply Rmult_lt_compat_r |]; lra.
Qed.

Lemma U_left_end_n : U c0 n = 0.
Proof.
  pose proof sin_angle; apply Rmult_eq_reg_r with (sin (PI / INR n)); [|lra].
  rewrite U_left_end, (proj2 angle), sin_PI; ring.
Qed.

Lemma U_left_end_n_2 : U c0 (n - 2) = c0.
Proof.
  pose proof sin_angle; apply Rmult_eq_reg_r with (sin (PI / INR n)); [|lra].
  rewrite U_left_end, minus_INR by lia; cbn [INR]; unfold left_end.
  replace ((INR n - (1 + 1)) * (PI / INR n)) with (PI - 2 * (PI / INR n)) by (rewrite Rmult_minus_distr_r,
    (proj2 angle); ring).
  rewrite sin_PI_x, sin_2a; ring.
Qed.

Lemma G_left_end r : 0 < r < 1 -> G r c0 n < 0.
Proof.
  intros Hr; unfold G; rewrite U_left_end_n, U_left_end_n_2.
  pose proof left_end_pos; pose proof (pow_below_1 r n Hr ltac:(lia)); nra.
Qed.

Lemma U_pos_beyond X k : c0 < X -> (1 <= k <= n)%nat -> 0 < U X k.
Proof.
  intros HX Hk; pose proof left_end_pos; destruct k as [|[|k]]; [lia | unfold U; rewrite u_1; lra |].
  apply (positive_to_the_right (fun X k => U X (S k))) with c0; try assumption.
  - intros; apply U_SS.
  - unfold U; rewrite u_1; lra.
  - unfold U; rewrite !u_1, !u_2; lra.
  - intros; apply U_left_end_pos; lia.
  - destruct (Nat.eq_dec (S (S k)) n) as [->|]; [rewrite U_left_end_n; lra|]. apply Rlt_le, U_left_end_pos; lia.
Qed.

Lemma G_once r X Y : 0 < r < 1 -> Nat.Odd n -> c0 < X < Y -> 0 <= G r X n -> 0 < G r Y n.
Proof.
  intros Hr [h Hh] HX HG; pose proof left_end_pos. pose proof (fun k => U_pos_beyond X k (proj1 HX)) as HU.
  destruct h as [|[|h]]; [lia | |].
  - replace n with 3%nat in * by lia; apply G_3_stays_positive with X; lra || assumption.
  - replace n with (2 * h + 5)%nat in * by lia. apply G_stays_positive with X; assumption || lra.
Qed.

(** b_{n,n-2} and G have the same sign. *)
Lemma u_odd r X h : 0 < r -> u (- r * X) (r ^ 2) (2 * h + 1) = r ^ (2 * h) * U X (2 * h + 1).
Proof.
  intros Hr; pose proof (u_scale (- r) X 1 (2 * h + 1)) as E. replace ((- r) ^ 2 * 1) with (r ^ 2) in E by ring.
  apply Rmult_eq_reg_l with (- r); [rewrite E | lra]. rewrite pow_add, pow_1, !pow_mult; unfold U.
  replace ((- r) ^ 2) with (r ^ 2) by ring; ring.
Qed.

Lemma b_G r X : 0 < r -> Nat.Odd n -> U X n <> 0 -> b (- r * X) (r ^ 2) n (n - 2) * (r ^ 2 * U X n) = G r X n.
Proof.
  intros Hr [i Hi] HU; destruct i as [|h]; [lia|]. replace n with (2 * (S h) + 1)%nat in * by lia.
  unfold b, G; replace (2 * S h + 1 - 2)%nat with (2 * h + 1)%nat by lia.
  replace (2 * S h + 1 - (2 * h + 1))%nat with 2%nat by lia. rewrite !u_odd, u_2 by assumption.
  replace (2 * S h + 1)%nat with (2 * h + 3)%nat in * by lia. replace (2 * S h)%nat with (2 * h + 2)%nat by lia.
  rewrite <- !pow_mult. replace (2 * (2 * h + 1))%nat with (2 * h + 2 * h + 2)%nat by lia.
  pose proof (pow_lt r (2 * h) Hr); rewrite !pow_add; field; repeat split; nra || assumption.
Qed.
End Ends.
