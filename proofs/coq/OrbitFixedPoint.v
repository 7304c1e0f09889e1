(** * The equations (19) have exactly one solution near 0 in bounded families

    The linear problem turns them into a fixed point equation; its map is a contraction
    because what remains after the linear part has a small Lipschitz constant. *)

From Coq Require Import Reals Lra Lia.
From Grazing Require Import StatementOrbits OrbitVectors Contraction OrbitRemainder.
Import Map.
Open Scope R_scope.

Section Families.
Variables (M : Map.t) (J : Type) (next : J -> J) (n : J -> nat).
Notation N := (N M).
Notation linear := (linear M J next n).
Notation bounded := (bounded M J).
Notation dot := (dot N).
Notation power := (power M).

Definition diff (x x' : J -> vec) : J -> vec := fun j => minus (x j) (x' j).
Definition diff1 (y y' : J -> R) : J -> R := fun j => y j - y' j.

Lemma bounded_le e e' x y : e <= e' -> bounded e x y -> bounded e' x y.
Proof. intros He H j; destruct (H j) as [Hx Hy]; split; [apply within_le with e; assumption | lra]. Qed.
Lemma bounded_nonneg e x y : bounded e x y -> J -> 0 <= e.
Proof. intros H j; exact (Rabs_nonneg _ _ (proj2 (H j))). Qed.

Lemma bounded_diff e e' x y x' y' : bounded e x y -> bounded e' x' y' -> bounded (e + e') (diff x x') (diff1 y y').
Proof.
  intros H H' j; destruct (H j) as [Hx Hy], (H' j) as [Hx' Hy']; split.
  - apply within_minus; assumption.
  - unfold diff1, Rminus; apply triangle2; [|rewrite Rabs_Ropp]; assumption.
Qed.

Lemma bounded_plus e e' x y x' y' : bounded e (diff x x') (diff1 y y') -> bounded e' x' y' -> bounded (e + e') x y.
Proof.
  intros H H' j; destruct (H j) as [Hx Hy], (H' j) as [Hx' Hy']; split.
  - intros i Hi; replace (x j i) with (minus (x j) (x' j) i + x' j i) by (unfold minus; ring).
    apply triangle2; [apply Hx | apply Hx']; exact Hi.
  - replace (y j) with (diff1 y y' j + y' j) by (unfold diff1; ring); apply triangle2; assumption.
Qed.

Lemma linear_ext x y Q q x' y' Q' q' : linear x y Q q -> (forall j i, (i < N)%nat -> x j i = x' j i) ->
  (forall j, y j = y' j) -> (forall j i, (i < N)%nat -> Q j i = Q' j i) -> (forall j, q j = q' j) -> linear x' y' Q' q'.
Proof.
  intros H Hx Hy HQ Hq j; destruct (H j) as [H1 H2].
  assert (Hp : forall i, (i < N)%nat -> power (n j) (x j) i = power (n j) (x' j) i) by (apply power_ext, Hx). split.
  - rewrite <- Hq, <- H1; symmetry; apply dot_ext, Hp.
  - intros i Hi; rewrite <- HQ, <- Hx, <- Hp, <- Hy by assumption; apply H2, Hi.
Qed.

Lemma linear_comb a c x y Q q x' y' Q' q' : linear x y Q q -> linear x' y' Q' q' ->
  linear (fun j => comb a c (x j) (x' j)) (fun j => a * y j + c * y' j)
         (fun j => comb a c (Q j) (Q' j)) (fun j => a * q j + c * q' j).
Proof.
  intros H H' j; destruct (H j) as [H1 H2], (H' j) as [H1' H2']; unfold StatementOrbits.power in *.
  rewrite power_comb; split.
  - rewrite dot_comb, H1, H1'; reflexivity.
  - intros i Hi; unfold comb; rewrite <- H2, <- H2' by assumption; ring.
Qed.

Lemma linear_diff x y Q q x' y' Q' q' : linear x y Q q -> linear x' y' Q' q' ->
  linear (diff x x') (diff1 y y') (diff Q Q') (diff1 q q').
Proof.
  intros H H'; apply (linear_ext _ _ _ _ _ _ _ _ (linear_comb 1 (-1) _ _ _ _ _ _ _ _ H H')); intros; unfold diff, diff1,
    minus, comb; ring.
Qed.

Variable K : R.
Hypothesis HK : invertible M J next n K.

Lemma inverse_bound E e x y Q q : bounded E x y -> linear x y Q q -> bounded e Q q -> bounded (K * e) x y.
Proof.
  intros Hb Hl HQ; destruct (proj1 HK e Q q HQ) as (x' & y' & Hb' & Hl').
  replace (K * e) with (0 + K * e) by ring; apply (bounded_plus _ _ _ _ x' y'); [|exact Hb'].
  apply (proj2 HK (E + K * e)); [apply bounded_diff; assumption|].
  apply (linear_ext _ _ _ _ _ _ _ _ (linear_diff _ _ _ _ _ _ _ _ Hl Hl')); trivial; intros; unfold diff, diff1, minus,
    zero; ring.
Qed.

(** Families of points x and numbers y as one family of numbers. *)
Definition index : Type := (J * nat) + J.
Definition counts (s : index) : Prop := match s with inl (_, i) => (i < N)%nat | inr _ => True end.
Definition points (z : index -> R) : J -> vec := fun j i => z (inl (j, i)).
Definition speeds (z : index -> R) : J -> R := fun j => z (inr j).
Definition family (x : J -> vec) (y : J -> R) : index -> R :=
  fun s => match s with inl (j, i) => x j i | inr j => y j end.

Lemma near_bounded e z z' : near index counts e z z' <->
  bounded e (diff (points z) (points z')) (diff1 (speeds z) (speeds z')).
Proof.
  split.
  - intros H j; split; [intros i Hi; exact (H (inl (j, i)) Hi) | exact (H (inr j) I)].
  - intros H [[j i]|j] Hs; [exact (proj1 (H j) i Hs) | exact (proj2 (H j))].
Qed.

Lemma near_zero e z : near index counts e z (fun _ => 0) <-> bounded e (points z) (speeds z).
Proof.
  split.
  - intros H j; split.
    + intros i Hi; pose proof (H (inl (j, i)) Hi) as E; cbn in E; rewrite Rminus_0_r in E; exact E.
    + pose proof (H (inr j) I) as E; cbn in E; rewrite Rminus_0_r in E; exact E.
  - intros H [[j i]|j] Hs; rewrite Rminus_0_r; [exact (proj1 (H j) i Hs) | exact (proj2 (H j))].
Qed.

(** The solution of the linear problem as a function of its right-hand side. *)
Definition solve (Q : J -> vec) (q : J -> R) : index -> R := fun s => the (fun v =>
  exists x y, (exists E, bounded E x y) /\ linear x y Q q /\ v = family x y s).

Lemma solve_spec e Q q : bounded e Q q -> bounded (K * e) (points (solve Q q)) (speeds (solve Q q)) /\
  linear (points (solve Q q)) (speeds (solve Q q)) Q q.
Proof.
  intros HQ; destruct (proj1 HK e Q q HQ) as (x & y & Hb & Hl).
  assert (E : forall s, counts s -> solve Q q s = family x y s).
  { intros s Hs; apply the_spec; [exists x, y; eauto|]. intros v (x' & y' & (E & Hb') & Hl' & ->).
    assert (H0 : bounded 0 (diff x' x) (diff1 y' y)).
    { apply (proj2 HK (E + K * e)); [apply bounded_diff; assumption|].
      apply (linear_ext _ _ _ _ _ _ _ _ (linear_diff _ _ _ _ _ _ _ _ Hl' Hl)); trivial; intros; unfold diff, diff1,
        minus, zero; ring. }
    apply Rminus_diag_uniq, Rabs_zero. destruct s as [[j i]|j]; [exact (proj1 (H0 j) i Hs) | exact (proj2 (H0 j))]. }
  assert (Ex : forall j i, (i < N)%nat -> points (solve Q q) j i = x j i) by (intros j i Hi; exact (E (inl (j, i)) Hi)).
  assert (Ey : forall j, speeds (solve Q q) j = y j) by (intros j; exact (E (inr j) I)). split.
  - intros j; rewrite Ey; split; [|apply Hb]; intros i Hi; rewrite Ex by exact Hi; apply (Hb j), Hi.
  - apply (linear_ext _ _ _ _ _ _ _ _ Hl); auto; intros; symmetry; auto.
Qed.

(** ** The fixed point *)

Variables (w : vec) (e mu eps d M0 : R) (n_max : nat) (X : J -> vec) (Y : J -> R).
Hypothesis HM : smooth M.
Hypothesis Hw : forall i, (i < N)%nat -> w i = mult N (A M) w i + phi M i.
Hypothesis He : e = dot (C M) w + eta M.
Hypothesis Hn : forall j, (n j <= n_max)%nat.
Hypothesis Hrem : remainder M w e n_max eps d.
Hypothesis HKe : 0 <= K /\ 0 < eps /\ K * eps <= / 2.
Hypothesis HX : solution M J next n X Y.
Hypothesis HM0 : 1 <= M0 /\ 4 * M0 * Rabs mu <= d /\ bounded M0 (fun j => comb 1 e w (X j)) (fun j => e * Y j).

Definition Q_at (x : J -> vec) (y : J -> R) : J -> vec := fun j => rest1 M mu (n j) (x j) (y j).
Definition q_at (x : J -> vec) (y : J -> R) : J -> R := fun j => rest2 M mu (n j) (x j) (y j).

(** (19), the second line times -1. *)
Definition zero_at (x : J -> vec) (y : J -> R) : Prop := linear x y (Q_at x y) (q_at x y).

(** The solution of the linear problem with the terms in mu. *)
Definition x_lin : J -> vec := fun j => comb mu (e * mu) w (X j).
Definition y_lin : J -> R := fun j => e * mu * Y j.
Definition Q_lin : J -> vec := fun j i => mu * (w i - power (n j) w i).
Definition q_lin : J -> R := fun j => - (mu * (e - dot (C M) (power (n j) w))).

Lemma linear_lin : linear x_lin y_lin Q_lin q_lin.
Proof.
  assert (Hc : linear (fun _ => w) (fun _ => 0) (fun j => minus w (power (n j) w)) (fun j =>
    dot (C M) (power (n j) w))).
  { intros j; split; [reflexivity | intros i _; unfold minus; ring]. }
  apply (linear_ext _ _ _ _ _ _ _ _ (linear_comb mu (e * mu) _ _ _ _ _ _ _ _ Hc (proj2 HX))); intros; unfold x_lin,
    y_lin, Q_lin, q_lin, comb, minus, zero; ring.
Qed.

Lemma mu_d : 0 <= Rabs mu <= d /\ M0 * Rabs mu <= d /\ 0 <= d /\ Rabs mu <= M0 * Rabs mu.
Proof.
  destruct HM0 as (H1 & H2 & _); pose proof (Rabs_pos mu) as H3.
  assert (1 * Rabs mu <= M0 * Rabs mu) by (apply Rmult_le_compat_r; assumption); lra.
Qed.

Lemma lin_bounded : bounded (M0 * Rabs mu) x_lin y_lin.
Proof.
  intros j; destruct HM0 as (_ & _ & H); destruct (H j) as [Hx Hy]; split.
  - intros i Hi; replace (x_lin j i) with (comb 1 e w (X j) i * mu) by (unfold x_lin, comb; ring).
    apply Rabs_mult_le; [apply Hx, Hi | lra].
  - replace (y_lin j) with (e * Y j * mu) by (unfold y_lin; ring); apply Rabs_mult_le; [exact Hy | lra].
Qed.

Lemma Q_lin_bounded : exists E, bounded E Q_lin q_lin.
Proof.
  destruct (power_bound N (A M) n_max) as (m & Hm & Hpow), (within_exists N w) as (W & HW & Hwb).
  destruct (dot_bound N (C M)) as (mc & Hmc & Hc). assert (HmW : 0 <= m * W) by (apply Rmult_le_pos; lra).
  assert (HmcmW : 0 <= mc * (m * W)) by (apply Rmult_le_pos; lra). pose proof (Rabs_pos e).
  exists (Rabs mu * (W + m * W + (Rabs e + mc * (m * W)))); intros j. pose proof (Hpow (n j) W w (Hn j) HW Hwb) as Hp.
  split.
  - intros i Hi; apply Rle_trans with (Rabs mu * (W + m * W)).
    + apply Rabs_mult_le; [lra | apply (within_minus N W (m * W) w (power (n j) w) Hwb Hp i Hi)].
    + apply Rmult_le_compat_l; [apply Rabs_pos | lra].
  - unfold q_lin; rewrite Rabs_Ropp; apply Rle_trans with (Rabs mu * (Rabs e + mc * (m * W))).
    + apply Rabs_mult_le; [lra|]; unfold Rminus; apply triangle2; [lra | rewrite Rabs_Ropp; apply Hc, Hp].
    + apply Rmult_le_compat_l; [apply Rabs_pos | lra].
Qed.

Lemma rest_diff t x y x' y' : bounded d x y -> bounded d x' y' -> bounded t (diff x x') (diff1 y y') ->
  bounded (eps * t) (diff (Q_at x y) (Q_at x' y')) (diff1 (q_at x y) (q_at x' y')).
Proof.
  intros Hb Hb' Ht j; destruct (Hb j) as [Hx Hy], (Hb' j) as [Hx' Hy'], (Ht j) as [Htx Hty].
  pose proof (Rabs_nonneg _ _ Hty) as Ht0; pose proof mu_d as Hmu.
  destruct (Hrem (n j) (x j) (x' j) (y j) (y' j) mu mu t) as (H1 & H2 & _); trivial; try lra.
  { unfold Rminus; rewrite Rplus_opp_r, Rabs_R0; exact Ht0. }
  replace (mu - mu) with 0 in * by ring; split.
  - intros i Hi; specialize (H1 i Hi); rewrite Rmult_0_l, Rminus_0_r in H1; exact H1.
  - rewrite Rmult_0_l, Rplus_0_r in H2; exact H2.
Qed.

Lemma rest_lin t x y : bounded d x y -> bounded t x y -> Rabs mu <= t ->
  bounded (eps * t) (diff (Q_at x y) Q_lin) (diff1 (q_at x y) q_lin).
Proof.
  intros Hb Ht Hmt j; destruct (Hb j) as [Hx Hy], (Ht j) as [Htx Hty].
  pose proof (Rabs_nonneg _ _ Hty) as Ht0; pose proof mu_d as Hmu.
  destruct (Hrem (n j) (x j) zero (y j) 0 mu 0 t) as (H1 & H2 & _); rewrite ?Rminus_0_r, ?Rabs_R0; trivial; try lra;
    try (apply within_zero; lra).
  { intros i Hi; unfold minus, zero; rewrite Rminus_0_r; apply Htx, Hi. }
  rewrite !Rminus_0_r in *; split.
  - intros i Hi; unfold diff, minus, Q_at, Q_lin.
    replace (rest1 M mu (n j) (x j) (y j) i - mu * (w i - power (n j) w i)) with (rest1 M mu (n j) (x j) (y j) i - rest1
      M 0 (n j) zero 0 i - mu * (w i - power (n j) w i)).
    + apply H1, Hi.
    + unfold rest1 at 2; rewrite (fly_zero M w HM Hw (n j) i Hi).
      unfold StatementOrbits.power at 1; rewrite power_zero; unfold zero; ring.
  - unfold diff1, q_at, q_lin.
    replace (rest2 M mu (n j) (x j) (y j) - - (mu * (e - dot (C M) (power (n j) w))))
      with (rest2 M mu (n j) (x j) (y j) - rest2 M 0 (n j) zero 0 + mu * (e - dot (C M) (power (n j) w))).
    + exact H2.
    + unfold rest2 at 2; rewrite (height_zero M w e HM Hw He).
      unfold StatementOrbits.power at 1; rewrite power_zero, dot_zero; ring.
Qed.

Lemma rest_bounded x y : bounded d x y -> exists E, bounded E (Q_at x y) (q_at x y).
Proof.
  intros Hb; destruct Q_lin_bounded as [E HE].
  exists (eps * d + E); apply (bounded_plus _ _ _ _ Q_lin q_lin); [|exact HE]. apply rest_lin; trivial; apply mu_d.
Qed.

Definition T (z : index -> R) : index -> R := solve (Q_at (points z) (speeds z)) (q_at (points z) (speeds z)).

Lemma T_spec z : bounded d (points z) (speeds z) -> (exists E, bounded E (points (T z)) (speeds (T z))) /\
  linear (points (T z)) (speeds (T z)) (Q_at (points z) (speeds z)) (q_at (points z) (speeds z)).
Proof.
  intros Hb; destruct (rest_bounded _ _ Hb) as [E HE].
  destruct (solve_spec E _ _ HE) as [H1 H2]; split; [exists (K * E); exact H1 | exact H2].
Qed.

(** T z and the linear solution differ little. *)
Lemma T_lin t z : bounded d (points z) (speeds z) -> bounded t (points z) (speeds z) -> Rabs mu <= t ->
  bounded (K * (eps * t)) (diff (points (T z)) x_lin) (diff1 (speeds (T z)) y_lin).
Proof.
  intros Hb Ht Hmt; destruct (T_spec z Hb) as [[E HE] Hl].
  apply (inverse_bound (E + M0 * Rabs mu) _ _ _ (diff (Q_at (points z) (speeds z)) Q_lin)
    (diff1 (q_at (points z) (speeds z)) q_lin)).
  - apply bounded_diff; [exact HE | exact lin_bounded].
  - apply linear_diff; [exact Hl | exact linear_lin].
  - apply rest_lin; assumption.
Qed.

Theorem fixed_point : exists x y, bounded d x y /\ zero_at x y /\
  bounded (2 * (K * (eps * (M0 * Rabs mu)))) (diff x x_lin) (diff1 y y_lin) /\
  forall x' y', bounded d x' y' -> zero_at x' y' -> bounded 0 (diff x x') (diff1 y y').
Proof.
  pose proof mu_d as Hmu; destruct HKe as (HK0 & Heps & HKeps).
  assert (Hhalf : forall t, 0 <= t -> K * (eps * t) <= t / 2).
  { intros t Ht; rewrite <- Rmult_assoc; unfold Rdiv; rewrite (Rmult_comm t). apply Rmult_le_compat_r; assumption. }
  destruct (contraction index counts T d) as (z & Hz & Hfix & Huniq).
  - lra.
  - intros t z z' Hz Hz' Ht; apply near_zero in Hz, Hz'; apply near_bounded in Ht.
    apply near_bounded; destruct (T_spec z Hz) as [[E HE] Hl], (T_spec z' Hz') as [[E' HE'] Hl'].
    assert (H : bounded (K * (eps * t)) (diff (points (T z)) (points (T z'))) (diff1 (speeds (T z)) (speeds (T z')))).
    { apply (inverse_bound (E + E') _ _ _ _ _ (bounded_diff _ _ _ _ _ _ HE HE') (linear_diff _ _ _ _ _ _ _ _ Hl Hl')).
      apply rest_diff; assumption. }
    intros j; apply (bounded_le _ (t / 2) _ _ (Hhalf t (bounded_nonneg _ _ _ Ht j)) H).
  - apply near_zero.
    assert (H : bounded (K * (eps * Rabs mu) + M0 * Rabs mu) (points (T (fun _ => 0))) (speeds (T (fun _ => 0)))).
    { apply (bounded_plus _ _ _ _ x_lin y_lin); [|exact lin_bounded].
      assert (Hb : forall t, 0 <= t -> bounded t (points (fun _ => 0)) (speeds (fun _ => 0))).
      { intros t Ht j; split; [apply within_zero; exact Ht|]. unfold speeds; rewrite Rabs_R0; exact Ht. }
      apply T_lin; [apply Hb | apply Hb|]; lra. }
    revert H; apply bounded_le; pose proof (Hhalf (Rabs mu) ltac:(lra)); lra.
  - apply near_zero in Hz; destruct (T_spec z Hz) as [_ Hl].
    assert (HT : forall x y, bounded d x y -> zero_at x y -> near index counts 0 (T (family x y)) (family x y)).
    { intros x y Hb Hzero; apply near_bounded. destruct (T_spec (family x y) Hb) as [[E HE] Hl'].
      change (points (family x y)) with x in *; change (speeds (family x y)) with y in *.
      apply (proj2 HK (E + d)); [apply bounded_diff; assumption|].
      apply (linear_ext _ _ _ _ _ _ _ _ (linear_diff _ _ _ _ _ _ _ _ Hl' Hzero)); trivial; intros; unfold diff, diff1,
        minus, zero; ring. }
    exists (points z), (speeds z); split; [exact Hz | split; [|split]].
    + apply (linear_ext _ _ _ _ _ _ _ _ Hl); trivial.
      * intros j i Hi; exact (Hfix (inl (j, i)) Hi).
      * intros j; exact (Hfix (inr j) I).
    + apply (near_bounded _ z (family x_lin y_lin)).
      assert (Hb : bounded d x_lin y_lin) by (apply bounded_le with (M0 * Rabs mu); [lra | exact lin_bounded]).
      apply Huniq; [apply near_zero; exact Hb|].
      apply near_bounded, (T_lin (M0 * Rabs mu)); [exact Hb | exact lin_bounded | lra].
    + intros x' y' Hb' Hz'; apply (near_bounded 0 z (family x' y')).
      replace 0 with (2 * 0) by ring; apply Huniq; [apply near_zero; exact Hb' | apply HT; assumption].
Qed.
End Families.
