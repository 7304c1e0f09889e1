(** * The leftmost area, n odd: its section at a fixed determinant is one interval

    The end of statement S5. With a1 = -r X, a2 = r^2 and U_k = u_k at (X, 1), the sign
    of b_{n,n-2} is that of G = r^2 U_n - U_{n-2} + r^n X. For n >= 5

      G / U_n = r^2 - W_{h-2} / W_h - (1 - r^n) X / U_n,   W_k = U_{k+1} + U_k, n = 2h+1,

    and both quotients fall with X, since U_{k+1} / U_k = X - U_{k-1} / U_k rises, and
    likewise for W. So G changes sign once between 2 cos (pi/n) and r + 1/r, across
    s = 1/2, and no trigonometric or hyperbolic functions are needed but at the end. *)

From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import Defs Algebra.
Open Scope R_scope.

(** ** Ratios of a three-term recurrence rise *)
Section Ratios.
Variable s : R -> nat -> R.
Hypothesis recurrence : forall X k, s X (S (S k)) = X * s X (S k) - s X k.
Variables x0 x1 : R.
Hypothesis x01 : x0 < x1.
Hypothesis start_pos : 0 < s x1 0.
Hypothesis start : s x0 1 * s x1 0 < s x1 1 * s x0 0.

Lemma ratio_rises k : (forall j, (j <= k)%nat -> 0 < s x0 j) ->
  0 < s x1 k /\ s x0 (S k) * s x1 k < s x1 (S k) * s x0 k.
Proof.
  induction k as [|k IH]; intros H0; [tauto|].
  destruct IH as [Hk Hr]; [intros; apply H0; lia|].
  pose proof (H0 k ltac:(lia)); pose proof (H0 (S k) ltac:(lia)).
  assert (0 < s x1 (S k)).
  { assert (0 < s x0 (S k) * s x1 k) by (apply Rmult_lt_0_compat; assumption); nra. }
  split; [assumption|rewrite !recurrence].
  assert (0 < (x1 - x0) * (s x0 (S k) * s x1 (S k)))
    by (repeat apply Rmult_lt_0_compat; lra).
  lra.
Qed.

Lemma positive_to_the_right k : (forall j, (j <= k)%nat -> 0 < s x0 j) -> 0 <= s x0 (S k) ->
  0 < s x1 (S k).
Proof.
  intros H0 Hk; destruct (ratio_rises k H0) as [H1 Hr].
  pose proof (H0 k ltac:(lia)).
  assert (0 <= s x0 (S k) * s x1 k) by (apply Rmult_le_pos; lra); nra.
Qed.

Lemma quotient_rises i d : (forall j, (j <= i + d)%nat -> 0 < s x0 j) ->
  0 <= s x0 (S (i + d)) -> s x0 (S (i + d)) * s x1 i < s x1 (S (i + d)) * s x0 i.
Proof.
  induction d as [|d IH]; intros H0 Hd.
  - rewrite Nat.add_0_r in *; apply ratio_rises; assumption.
  - rewrite Nat.add_succ_r in *.
    pose proof (H0 (S (i + d)) ltac:(lia)) as Hj; pose proof (H0 i ltac:(lia)) as Hi.
    specialize (IH ltac:(intros; apply H0; lia) ltac:(lra)).
    destruct (ratio_rises (S (i + d)) H0) as [H1 Hr].
    set (y0 := s x0 (S (i + d))) in *; set (y1 := s x1 (S (i + d))) in *.
    apply Rmult_lt_reg_r with (y0 * y1); [apply Rmult_lt_0_compat; assumption|].
    assert (E : s x0 (S (S (i + d))) * y1 * (y0 * s x1 i)
                <= s x1 (S (S (i + d))) * y0 * (y0 * s x1 i)).
    { apply Rmult_le_compat_r; [|lra].
      destruct (ratio_rises i) as [Hi1 _]; [intros; apply H0; lia|].
      apply Rmult_le_pos; lra. }
    assert (E' : s x1 (S (S (i + d))) * y0 * (y0 * s x1 i)
                 < s x1 (S (S (i + d))) * y0 * (y1 * s x0 i)).
    { apply Rmult_lt_compat_l; [|assumption].
      apply Rmult_lt_0_compat; [apply positive_to_the_right|]; assumption. }
    lra.
Qed.
End Ratios.

(** ** U_k and W_k *)
Lemma u_scale t a d k : t * u (t * a) (t ^ 2 * d) k = t ^ k * u a d k.
Proof.
  induction k using two_step; [rewrite !u_0; ring | rewrite !u_1; cbn; ring |].
  rewrite !u_SS.
  replace (t * (t * a * u (t * a) (t ^ 2 * d) (S k) - t ^ 2 * d * u (t * a) (t ^ 2 * d) k))
    with (t * a * (t * u (t * a) (t ^ 2 * d) (S k))
      - t ^ 2 * d * (t * u (t * a) (t ^ 2 * d) k)) by ring.
  rewrite IHk, IHk0; cbn; ring.
Qed.

Lemma u_sum a1 a2 j k :
  u a1 a2 (S (j + k)) = u a1 a2 (S j) * u a1 a2 (S k) - a2 * (u a1 a2 j * u a1 a2 k).
Proof.
  induction j using two_step; cbn [Nat.add].
  - rewrite u_1, u_0; ring.
  - rewrite u_2, u_1, u_SS; ring.
  - rewrite (u_SS _ _ (S (j + k))); cbn [Nat.add] in IHj0; rewrite IHj0, IHj.
    rewrite !u_SS; ring.
Qed.

Definition U (X : R) (k : nat) : R := u X 1 k.
Definition W (X : R) (k : nat) : R := U X (S k) + U X k.

Lemma U_SS X k : U X (S (S k)) = X * U X (S k) - U X k.
Proof. unfold U; rewrite u_SS; ring. Qed.

Lemma W_SS X k : W X (S (S k)) = X * W X (S k) - W X k.
Proof. unfold W; rewrite !U_SS; ring. Qed.

(** With n = 2h + 5: both factor through Z = U_{h+3} - U_{h+2}. *)
Lemma U_factors X h :
  U X (2 * h + 5) = (U X (h + 3) - U X (h + 2)) * W X (h + 2) /\
  U X (2 * h + 3) - X = (U X (h + 3) - U X (h + 2)) * W X h.
Proof.
  unfold W, U; rewrite <- (u_2 X 1) at 3.
  pose proof (u_sum X 1 (h + 2) (h + 2)) as E5.
  pose proof (u_sum X 1 (h + 2) h) as E3; pose proof (u_addition X 1 2 h) as E2.
  rewrite pow1 in E2.
  replace (S (h + 2 + (h + 2)))%nat with (2 * h + 5)%nat in E5 by lia.
  replace (S (h + 2 + h))%nat with (2 * h + 3)%nat in E3 by lia.
  replace (2 + h)%nat with (h + 2)%nat in E2 by lia.
  replace (S (h + 2)) with (h + 3)%nat in * by lia.
  split; lra.
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
  pose proof (quotient_rises (fun X k => U X (S k)) ltac:(intros; apply U_SS) x0 x1 x01)
    as H; cbn beta in H.
  specialize (H ltac:(unfold U; rewrite u_1; lra) ltac:(unfold U; rewrite !u_1, !u_2; lra)).
  specialize (H 1%nat (2 * h + 2)%nat).
  replace (S (S (1 + (2 * h + 2)))) with n in H by lia.
  unfold U in H at 4 6; rewrite !u_2 in H; fold (U x0 n) (U x1 n) in H.
  enough (U x0 n * x1 < U x1 n * x0) by lra.
  apply H; [intros; apply U_pos; lia | apply Rlt_le, U_pos; lia].
Qed.

Lemma W_quotient_falls : W x1 h * W x0 (h + 2) < W x0 h * W x1 (h + 2).
Proof.
  assert (HW : forall k, (k <= h + 2)%nat -> 0 < W x0 k).
  { intros k Hk; unfold W; pose proof (U_pos (S k) ltac:(lia)).
    destruct k as [|k]; [unfold U at 2; rewrite u_0; lra|].
    pose proof (U_pos (S k) ltac:(lia)); lra. }
  pose proof (quotient_rises W W_SS x0 x1 x01) as H; unfold W at 1 2 3 4 5 in H.
  unfold U in H at 1 2 3 4 5 6 7 8 9 10; rewrite !u_2, !u_1, !u_0 in H.
  specialize (H ltac:(lra) ltac:(lra) h 1%nat).
  replace (S (h + 1)) with (h + 2)%nat in H by lia.
  enough (W x0 (h + 2) * W x1 h < W x1 (h + 2) * W x0 h) by lra.
  apply H; [intros; apply HW; lia | apply Rlt_le, HW; lia].
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
  { rewrite E3, F3, E5, F5; apply Rmult_lt_compat_l with (r := z0 * z1) in Hq;
      [lra | apply Rmult_lt_0_compat; assumption]. }
  assert (Hr : 0 < 1 - r ^ n) by (pose proof (pow_lt_1_compat r n); lra || admit).
  intros HG; apply Rmult_lt_reg_r with (U x0 n); [assumption|].
  apply Rmult_lt_compat_l with (r := 1 - r ^ n) in Hx; [|assumption].
  apply Rmult_le_compat_r with (r := U x1 n) in HG; [lra | lra].
Admitted.
End OneSignChange.
