(** * A contraction of sequences Z -> R in given intervals, with weights, has exactly one fixed point there *)

From Coq Require Import Reals ZArith Lra Lia.
Open Scope R_scope.

Section Contraction.
Variables (lo hi weight : Z -> R) (T : (Z -> R) -> Z -> R) (k D : R).
Definition inside (s : Z -> R) : Prop := forall i, lo i <= s i <= hi i.
Definition near (d : R) (s s' : Z -> R) : Prop := forall i, Rabs (s i - s' i) <= weight i * d.
Hypothesis Hlo : inside lo.
Hypothesis Hweight : forall i, 0 < weight i.
Hypothesis Hk : 0 <= k < 1.
Hypothesis HD : 0 <= D /\ forall i, hi i - lo i <= weight i * D.
Hypothesis Hin : forall s, inside s -> inside (T s).
Hypothesis HT : forall d s s', 0 <= d -> inside s -> inside s' -> near d s s' -> near (k * d) (T s) (T s').

Let x (m : nat) : Z -> R := Nat.iter m T lo.

Lemma inside_iter m s : inside s -> inside (Nat.iter m T s).
Proof. intros H; induction m; cbn; auto. Qed.

Lemma inside_near s s' : inside s -> inside s' -> near D s s'.
Proof.
  intros H H' i; specialize (H i); specialize (H' i); destruct HD as [_ HD']; specialize (HD' i).
  apply Rabs_le; lra.
Qed.

Lemma pow_k m : 0 <= k ^ m.
Proof. apply pow_le, Hk. Qed.

Lemma iter_near m s s' : inside s -> inside s' -> near (k ^ m * D) (Nat.iter m T s) (Nat.iter m T s').
Proof.
  intros H H'; induction m as [|m IH]; cbn [Nat.iter pow].
  - rewrite Rmult_1_l; apply inside_near; assumption.
  - rewrite Rmult_assoc; apply HT; try (apply inside_iter; assumption); [|exact IH].
    apply Rmult_le_pos; [apply pow_k | apply HD].
Qed.

Lemma iter_plus m n s : Nat.iter (m + n) T s = Nat.iter m T (Nat.iter n T s).
Proof. induction m as [|m IH]; [reflexivity | exact (f_equal T IH)]. Qed.

Lemma x_near m n : (m <= n)%nat -> near (k ^ m * D) (x n) (x m).
Proof.
  intros H; unfold x; replace n with (m + (n - m))%nat by lia.
  rewrite iter_plus; apply iter_near; [apply inside_iter|]; exact Hlo.
Qed.

Lemma small c eps : 0 <= c -> 0 < eps -> exists m, forall n, (m <= n)%nat -> c * k ^ n < eps.
Proof.
  intros Hc He; destruct (pow_lt_1_zero k) with (y := eps / (c + 1)) as [m Hm].
  - rewrite Rabs_pos_eq; apply Hk.
  - apply Rdiv_lt_0_compat; lra.
  - exists m; intros n Hn; specialize (Hm n Hn); rewrite Rabs_pos_eq in Hm by apply pow_k.
    pose proof (pow_k n) as Hp; apply (Rmult_lt_compat_l (c + 1)) in Hm; [|lra].
    replace ((c + 1) * (eps / (c + 1))) with eps in Hm by (field; lra); nra.
Qed.

Lemma squeezed c a : 0 <= c -> (forall m, Rabs a <= c * k ^ m) -> a = 0.
Proof.
  intros Hc H; destruct (Rle_lt_dec (Rabs a) 0) as [L|L].
  - revert L; unfold Rabs; destruct Rcase_abs; lra.
  - destruct (small c (Rabs a) Hc L) as [m Hm]; specialize (Hm m (le_n m)); specialize (H m); lra.
Qed.

Lemma weighted i : 0 <= weight i * D.
Proof. apply Rmult_le_pos; [left; apply Hweight | apply HD]. Qed.

Lemma cauchy i : Cauchy_crit (fun m => x m i).
Proof.
  intros eps He; destruct (small (weight i * D) eps (weighted i) He) as [m Hm]; exists m.
  assert (A : forall n n', (m <= n)%nat -> (n <= n')%nat -> Rabs (x n' i - x n i) < eps).
  { intros n n' Hn Hn'; specialize (Hm n Hn); pose proof (x_near n n' Hn' i); lra. }
  intros n n' Hn Hn'; unfold R_dist; destruct (Nat.le_gt_cases n n').
  - rewrite Rabs_minus_sym; apply A; lia.
  - apply A; lia.
Qed.

Definition fixed_point (i : Z) : R := proj1_sig (R_complete _ (cauchy i)).

Lemma limit i : Un_cv (fun m => x m i) (fixed_point i).
Proof. unfold fixed_point; destruct R_complete; assumption. Qed.

Lemma limit_le a b i : (forall n, a <= x n i <= b) -> a <= fixed_point i <= b.
Proof.
  intros H; split; apply Rnot_lt_le; intros L.
  - destruct (limit i (a - fixed_point i)) as [n Hn]; [lra|]; specialize (Hn n (le_n n)).
    unfold R_dist in Hn; apply Rabs_def2 in Hn; specialize (H n); lra.
  - destruct (limit i (fixed_point i - b)) as [n Hn]; [lra|]; specialize (Hn n (le_n n)).
    unfold R_dist in Hn; apply Rabs_def2 in Hn; specialize (H n); lra.
Qed.

Lemma fixed_inside : inside fixed_point.
Proof. intros i; apply limit_le; intros n; apply inside_iter, Hlo. Qed.

Lemma limit_near m : near (k ^ m * D) fixed_point (x m).
Proof.
  intros i; set (d := weight i * (k ^ m * D)).
  apply Rnot_lt_le; intros L.
  destruct (limit i (Rabs (fixed_point i - x m i) - d)) as [n Hn]; [lra|].
  specialize (Hn (max n m) ltac:(lia)); pose proof (x_near m (max n m) ltac:(lia) i) as Hx.
  unfold R_dist in Hn; fold d in Hx; rewrite Rabs_minus_sym in Hn.
  pose proof (Rabs_triang (fixed_point i - x (max n m) i) (x (max n m) i - x m i)) as Ht.
  replace (fixed_point i - x (max n m) i + (x (max n m) i - x m i)) with (fixed_point i - x m i) in Ht
    by ring.
  lra.
Qed.

Theorem one_fixed_point : exists s, inside s /\ (forall i, T s i = s i) /\
  forall s', inside s' -> (forall i, T s' i = s' i) -> forall i, s' i = s i.
Proof.
  exists fixed_point; split; [exact fixed_inside|].
  assert (HF : forall i, T fixed_point i = fixed_point i).
  { intros i; apply Rminus_diag_uniq, (squeezed (2 * (weight i * D))); [pose proof (weighted i); lra|].
    intros m; pose proof (HT (k ^ m * D) fixed_point (x m)) as H.
    specialize (H ltac:(apply Rmult_le_pos; [apply pow_k | apply HD]) fixed_inside).
    specialize (H (inside_iter m lo Hlo) (limit_near m) i).
    pose proof (limit_near (S m) i) as H'; cbn [pow] in H'; rewrite Rabs_minus_sym in H'.
    pose proof (Rabs_triang (T fixed_point i - T (x m) i) (x (S m) i - fixed_point i)) as Ht.
    change (x (S m) i) with (T (x m) i) in *.
    replace (T fixed_point i - T (x m) i + (T (x m) i - fixed_point i))
      with (T fixed_point i - fixed_point i) in Ht by ring.
    pose proof (pow_k m); pose proof (weighted i).
    assert (k * k ^ m <= k ^ m) by nra.
    assert (weight i * (k * k ^ m * D) <= weight i * D * k ^ m) by nra.
    replace (weight i * (k * (k ^ m * D))) with (weight i * (k * k ^ m * D)) in H by ring; lra. }
  split; [exact HF|]; intros s' Hs' HF' i.
  apply Rminus_diag_uniq, (squeezed (weight i * D)); [apply weighted|]; intros m.
  assert (A : forall s, (forall i, T s i = s i) -> inside s -> forall d s1, 0 <= d -> inside s1 ->
    near d s s1 -> near (k * d) s (T s1)).
  { intros s Hf Hs d s1 Hd H1 H2 j; rewrite <- Hf; apply HT; assumption. }
  assert (Dm : forall m, 0 <= k ^ m * D) by (intros; apply Rmult_le_pos; [apply pow_k | apply HD]).
  assert (B : near (k ^ m * D) s' fixed_point).
  { induction m as [|m IH]; cbn [pow].
    - rewrite Rmult_1_l; apply inside_near; trivial; exact fixed_inside.
    - intros j; rewrite <- HF, Rmult_assoc; apply A; trivial; exact fixed_inside. }
  specialize (B i); replace (weight i * D * k ^ m) with (weight i * (k ^ m * D)) by ring; exact B.
Qed.
End Contraction.
