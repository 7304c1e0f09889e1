(** * One point of the line C X = -1 and its images: no time of first return splits into two of its own side

    The algebra of ../returns.md; every identity is one of the recurrence. *)

From Coq Require Import Reals List Arith Lra Lia Wf_nat Classical.
From Grazing Require Import Defs Statement StatementPlane StatementWords StatementReturns Algebra
  MatrixForm WordAlgebra.
Open Scope R_scope.

(** ** One point of the line: how far across it is after k steps *)

Section Algebra.
Variables a1 a2 : R.
Hypothesis complex : a1 ^ 2 < 4 * a2.
Notation u := (u a1 a2).
Notation p := (p a1 a2).
Notation q := (q a1 a2).

(** - C A^k X at X = (-1, y): beyond the line if it is > 1. *)
Definition g (y : R) (k : nat) : R := u (S k) - y * u k.

Lemma beyond_g y k : beyond a1 a2 y k <-> g y k > 1.
Proof. unfold beyond, apply, g; rewrite power_of_A; cbn [fst snd m11 m12]; split; intros; nra. Qed.
Lemma u_sum_g y k l : u (k + l) = u k * g y l + u l * g y k + (2 * y - a1) * (u k * u l).
Proof. rewrite u_sum; unfold g; ring. Qed.
Lemma g_sum y k l : g y (k + l) = g y k * g y l - (y ^ 2 - a1 * y + a2) * (u k * u l).
Proof. unfold g; replace (S (k + l)) with (S k + l)%nat by lia; rewrite !u_sum, !u_SS; ring. Qed.

(** No time splits into two of its own side. *)
Lemma no_split x y k l : x = 1 \/ x = -1 -> 0 < x * u k -> 0 < x * u l -> 0 < x * u (k + l) ->
  g y k <= 1 -> g y l <= 1 -> g y (k + l) <= 1.
Proof.
  intros Hx Hk Hl Hn Gk Gl; apply Rnot_lt_le; intros Gn. pose proof (g_sum y k l) as E; rewrite (u_sum_g y) in Hn.
  assert (Ex : x * x = 1) by (destruct Hx; subst; ring). set (U := x * u k) in *; set (W := x * u l) in *.
  replace (u k * u l) with (U * W) in * by (unfold U, W; transitivity (x * x * (u k * u l)); [ring | rewrite Ex; ring]).
  replace (x * _) with (U * g y l + W * g y k + x * (2 * y - a1) * (U * W)) in Hn by (unfold U, W; ring).
  clearbody U W; set (Q := y ^ 2 - a1 * y + a2) in *; set (z := x * (2 * y - a1)) in *.
  assert (HP : 0 < U * W) by (apply Rmult_lt_0_compat; assumption).
  assert (HQ : z * z < 4 * Q).
  { replace (z * z) with (x * x * ((2 * y - a1) * (2 * y - a1))) by (unfold z; ring); rewrite Ex; unfold Q; nra. }
  assert (0 < Q * (U * W)) by (apply Rmult_lt_0_compat; nra).
  assert (Neg : g y k < 0 /\ g y l < 0).
  { destruct (Rle_or_lt 0 (g y k)), (Rle_or_lt 0 (g y l)); nra. }
  destruct Neg as [N1 N2]; set (G := - g y k) in *; set (F := - g y l) in *.
  assert (HG : 0 < G) by (unfold G; lra); assert (HH : 0 < F) by (unfold F; lra).
  replace (g y k) with (- G) in * by (unfold G; ring); replace (g y l) with (- F) in * by (unfold F; ring).
  assert (S1 : 0 < U * F) by (apply Rmult_lt_0_compat; assumption).
  assert (S2 : 0 < W * G) by (apply Rmult_lt_0_compat; assumption). assert (S3 : U * F + W * G < z * (U * W)) by lra.
  assert (S4 : (U * F + W * G) * (U * F + W * G) < z * (U * W) * (z * (U * W))) by (apply Rmult_le_0_lt_compat; lra).
  pose proof (pow2_ge_0 (U * F - W * G)). assert (S5 : 4 * (U * W * (G * F)) < z * z * (U * W * (U * W))) by nra.
  assert (S6 : z * z * (U * W * (U * W)) < 4 * Q * (U * W * (U * W))).
  { apply Rmult_lt_compat_r; [apply Rmult_lt_0_compat; assumption | assumption]. }
  assert (S7 : U * W * (G * F) > U * W * (Q * (U * W))) by (apply Rmult_lt_compat_l; nra). lra.
Qed.

(** p_k is where g_k = 1, and k steps lead from there to q_k. *)
Lemma g_p y k : u k <> 0 -> g y k = 1 + u k * (p k - y).
Proof. intros; unfold g, StatementWords.p; field; assumption. Qed.
Lemma g_shift k i : u i <> 0 -> g (p i) (k + i) = g (q i) k.
Proof.
  intros Hi; rewrite q_next by assumption; unfold g, StatementWords.p. replace (S (k + i)) with (S k + i)%nat by lia.
  rewrite !u_sum, u_SS, <- (u_Cassini a1 a2 i); field; assumption.
Qed.

(** (1 - a2^(n/2))^2 <= 1 - v_n + a2^n, strictly where u_n is not 0. *)
Lemma p_q n : u n <> 0 -> 0 < u n * (q n - p n).
Proof.
  intros Hu; pose proof (I1 a1 a2 n Hu) as E; unfold c in E.
  assert (Ec : u n * (q n - p n) = 1 - v a1 a2 n + a2 ^ n).
  { replace (q n - p n) with (- (p n - q n)) by ring; rewrite <- E; field; assumption. }
  rewrite Ec; assert (Ha : 0 < a2) by nra; pose proof (v_discriminant a1 a2 n) as D.
  assert (0 < u n ^ 2) by (rewrite <- Rsqr_pow2; apply Rsqr_pos_lt; assumption).
  set (R := sqrt a2 ^ n); assert (ER : a2 ^ n = R ^ 2).
  { unfold R; rewrite <- pow_mult, Nat.mul_comm, pow_mult, pow2_sqrt by lra; reflexivity. }
  assert (HR : 0 < R) by (apply pow_lt, sqrt_lt_R0; assumption).
  rewrite ER in *; assert (v a1 a2 n < 2 * R) by (apply Rnot_le_lt; intros ?; nra). pose proof (pow2_ge_0 (1 - R)); lra.
Qed.

(** a2 <= 1: the p of the two sides lie apart; a2 >= 1: the q do. *)
Lemma p_apart n : a2 <= 1 -> (0 < u n -> p n < a1 / 2) /\ (u n < 0 -> a1 / 2 < p n).
Proof.
  intros H; assert (0 <= a2) by nra; assert (a2 ^ n <= 1) by (rewrite <- (pow1 n); apply pow_incr; lra).
  split; intros Hu; pose proof (p_q n ltac:(lra)); pose proof (I5_product a1 a2 n ltac:(lra)); nra.
Qed.
Lemma q_apart n : 1 <= a2 -> (0 < u n -> a1 / 2 < q n) /\ (u n < 0 -> q n < a1 / 2).
Proof.
  intros H; assert (1 <= a2 ^ n) by (rewrite <- (pow1 n); apply pow_incr; lra).
  split; intros Hu; pose proof (p_q n ltac:(lra)); pose proof (I5_product a1 a2 n ltac:(lra)); nra.
Qed.

(** ** Times of first return *)

Definition time (n : nat) : Prop := (1 <= n)%nat /\ exists y, g y n > 1 /\ forall k, (1 <= k < n)%nat -> g y k <= 1.

Lemma time_return n : return_time a1 a2 n <-> time n.
Proof.
  unfold return_time, time; split; intros [Hn (y & Hy & Hk)]; (split; [assumption|]); exists y; rewrite beyond_g in *;
    (split; [assumption|]); intros k Hk'; specialize (Hk k ltac:(lia)); rewrite beyond_g in *; lra.
Qed.
Lemma least y k : (1 <= k)%nat -> g y k > 1 -> exists l, (1 <= l <= k)%nat /\ time l /\ g y l > 1.
Proof.
  induction k as [k IH] using lt_wf_ind; intros Hk Hg.
  destruct (classic (exists l, (1 <= l < k)%nat /\ g y l > 1)) as [(l & Hl & Hgl)|Hno].
  - destruct (IH l) as (l' & ? & ?); try lia; try assumption; exists l'; split; [lia | assumption].
  - exists k; repeat split; try lia; try assumption; exists y; split; [assumption|]; intros l Hl.
    apply Rnot_lt_le; intros ?; apply Hno; exists l; split; [assumption | lra].
Qed.
Lemma member_g n : member a1 a2 Plus n <-> u n <> 0 /\ forall k, (1 <= k < n)%nat -> g (p n) k < 1.
Proof.
  unfold member; cbn [sgn]; split; intros [Hu H]; (split; [assumption|]); intros k Hk; specialize (H k ltac:(lia));
    rewrite (b_is_1_plus_x a1 a2 n k ltac:(lia) Hu) in *; unfold orbit_x in *; unfold g, StatementWords.p in *; lra.
Qed.
Lemma nearby y n : (forall k, (1 <= k < n)%nat -> g y k < 1) ->
  exists e, 0 < e /\ forall y' k, Rabs (y' - y) < e -> (1 <= k < n)%nat -> g y' k < 1.
Proof.
  induction n as [|n IH]; intros H; [exists 1; split; [lra | intros; lia]|].
  destruct IH as (e & He & IH); [intros; apply H; lia|].
  destruct (Nat.eq_dec n 0) as [->|Hn]; [exists e; split; [assumption | intros; lia]|].
  set (d := (1 - g y n) / (1 + Rabs (u n))); pose proof (Rabs_pos (u n)); pose proof (H n ltac:(lia)).
  assert (Ed : d * (1 + Rabs (u n)) = 1 - g y n) by (unfold d; field; lra).
  assert (0 < d) by (apply Rdiv_lt_0_compat; lra).
  exists (Rmin e d); split; [apply Rmin_pos; assumption|]; intros y' k Hy Hk.
  pose proof (Rmin_l e d); pose proof (Rmin_r e d). destruct (Nat.eq_dec k n) as [->|]; [|apply IH; [lra | lia]].
  replace (g y' n) with (g y n - (y' - y) * u n) by (unfold g; ring).
  pose proof (Rle_abs (- ((y' - y) * u n))) as B; rewrite Rabs_Ropp, Rabs_mult in B.
  assert (Rabs (y' - y) * Rabs (u n) <= d * Rabs (u n)) by (apply Rmult_le_compat_r; lra); lra.
Qed.
Lemma member_time n : member a1 a2 Plus n -> time n.
Proof.
  intros HV; apply member_g in HV; destruct HV as [Hu H]; destruct (nearby (p n) n H) as (e & He & HN).
  split; [apply (u_nonzero_pos a1 a2), Hu|].
  assert (HG : forall x, Rabs x < e -> 0 < - x * u n -> exists y, g y n > 1 /\ forall k, (1 <= k < n)%nat ->
    g y k <= 1).
  { intros x Hx Hs; exists (p n + x); rewrite g_p by assumption; split; [lra|].
    intros k Hk; apply Rlt_le, HN; [replace (p n + x - p n) with x by ring|]; assumption. }
  destruct (Rdichotomy _ _ Hu) as [Hs|Hs].
  - apply (HG (e / 2)); [apply Rabs_def1; lra | nra].
  - apply (HG (- e / 2)); [apply Rabs_def1; lra | nra].
Qed.

End Algebra.
