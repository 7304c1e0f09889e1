(** * A contraction of families of numbers in given intervals has exactly one fixed point there

    Families I -> R, compared at the indices with P only, with weights: no function space is needed. *)

From Coq Require Import Reals ZArith Lra Lia ClassicalFacts Classical_Prop.
Open Scope R_scope.

(** The number with a property that exactly one number has. *)
Definition chosen (P : R -> Prop) (x : R) : Prop :=
  P x /\ (forall y, P y -> y = x) \/ x = 0 /\ ~ exists y, P y /\ forall z, P z -> z = y.

Lemma chosen_unique (P : R -> Prop) x y : chosen P x -> chosen P y -> x = y.
Proof.
  intros [[Px Hx]|[-> Hx]] [[Py Hy]|[-> Hy]]; auto.
  - destruct Hy; exists x; auto.
  - destruct Hx; exists y; auto.
Qed.
Lemma chosen_exists (P : R -> Prop) : exists x, chosen P x.
Proof.
  destruct (classic (exists y, P y /\ forall z, P z -> z = y)) as [(x & Px & Hx)|H].
  - exists x; left; auto.
  - exists 0; right; auto.
Qed.
Lemma chosen_bound (P : R -> Prop) : bound (chosen P).
Proof. destruct (chosen_exists P) as [x Hx]; exists x; intros y Hy. right; apply (chosen_unique P); assumption. Qed.
Definition the (P : R -> Prop) : R := proj1_sig (completeness _ (chosen_bound P) (chosen_exists P)).

Lemma the_spec (P : R -> Prop) x : P x -> (forall y, P y -> y = x) -> the P = x.
Proof.
  intros Px Hx; unfold the; destruct completeness as (m & Hub & Hleast); cbn. assert (Cx : chosen P x) by (left; auto).
  apply Rle_antisym; [apply Hleast | apply Hub, Cx]. intros y Hy; right; apply (chosen_unique P); assumption.
Qed.
Lemma div_1 x : x / 1 = x. Proof. field. Qed.
Lemma Rabs_zero x : Rabs x <= 0 -> x = 0. Proof. unfold Rabs; destruct Rcase_abs; lra. Qed.
Lemma powers_small k c e : 0 <= k < 1 -> 0 < e -> exists m, c * k ^ m < e.
Proof.
  intros Hk He; pose proof (Rabs_pos c); pose proof (Rle_abs c).
  destruct (pow_lt_1_zero k ltac:(rewrite Rabs_pos_eq; lra) (e / (Rabs c + 1))) as [m Hm];
    [apply Rdiv_lt_0_compat; lra|].
  exists m; specialize (Hm m (le_n m)); assert (0 <= k ^ m) by (apply pow_le, Hk); rewrite Rabs_pos_eq in Hm
    by assumption.
  apply (Rmult_lt_compat_l (Rabs c + 1)) in Hm; [|lra].
  replace ((Rabs c + 1) * (e / (Rabs c + 1))) with e in Hm by (field; lra).
  assert (c * k ^ m <= (Rabs c + 1) * k ^ m) by (apply Rmult_le_compat_r; lra); lra.
Qed.
Lemma squeezed k x a c : 0 <= k < 1 -> (forall m, x <= a + c * k ^ m) -> x <= a.
Proof.
  intros Hk H; apply Rnot_lt_le; intros L; destruct (powers_small k c (x - a) Hk) as [m Hm]; [lra|]; specialize (H m);
    lra.
Qed.
Lemma squeeze x a c : (forall m, x <= a + c / 2 ^ m) -> x <= a.
Proof. intros H; apply (squeezed (/ 2) x a c); [lra|]; intros m; rewrite pow_inv; apply H. Qed.

Section Contraction.
Variables (I : Type) (P : I -> Prop) (weight lo hi : I -> R) (T : (I -> R) -> I -> R) (k D : R).
Definition boxed (s : I -> R) : Prop := forall i, P i -> lo i <= s i <= hi i.
Definition close (d : R) (s s' : I -> R) : Prop := forall i, P i -> Rabs (s i - s' i) <= weight i * d.
Hypothesis Hlo : boxed lo.
Hypothesis Hweight : forall i, P i -> 0 < weight i.
Hypothesis Hk : 0 <= k < 1.
Hypothesis HD : 0 <= D /\ forall i, P i -> hi i - lo i <= weight i * D.
Hypothesis Hin : forall s, boxed s -> boxed (T s).
Hypothesis HT : forall d s s', 0 <= d -> boxed s -> boxed s' -> close d s s' -> close (k * d) (T s) (T s').

Let x (m : nat) : I -> R := Nat.iter m T lo.

Lemma boxed_close s s' : boxed s -> boxed s' -> close D s s'.
Proof. intros H H' i Hi; specialize (H i Hi); specialize (H' i Hi); pose proof (proj2 HD i Hi); apply Rabs_le; lra. Qed.
Lemma close_sym d s s' : close d s s' -> close d s' s.
Proof. intros H i Hi; rewrite Rabs_minus_sym; auto. Qed.
Lemma close_trans d d' s s' s'' : close d s s' -> close d' s' s'' -> close (d + d') s s''.
Proof.
  intros H H' i Hi; replace (s i - s'' i) with ((s i - s' i) + (s' i - s'' i)) by ring; rewrite Rmult_plus_distr_l.
  eapply Rle_trans; [apply Rabs_triang | apply Rplus_le_compat; auto].
Qed.
Lemma x_boxed m : boxed (x m). Proof. induction m; cbn; auto. Qed.
Lemma part m : 0 <= k ^ m * D. Proof. apply Rmult_le_pos; [apply pow_le, Hk | apply HD]. Qed.
Lemma x_close m n : close (k ^ m * D) (x (m + n)) (x m).
Proof.
  induction m as [|m IH]; [cbn [pow]; rewrite Rmult_1_l; apply boxed_close; apply x_boxed|].
  cbn [pow]; rewrite Rmult_assoc; apply HT; auto using x_boxed, part.
Qed.
Definition fixed_point (i : I) : R := the (Un_cv (fun m => x m i)).
Lemma fixed_close m : close (k ^ m * D) fixed_point (x m).
Proof.
  intros i Hi; assert (Hc : Cauchy_crit (fun j => x j i)).
  { intros e He; destruct (powers_small k (2 * (weight i * D)) e Hk He) as [j Hj]; exists j; intros p q Hp Hq;
      unfold R_dist.
    replace p with (j + (p - j))%nat by lia; replace q with (j + (q - j))%nat by lia.
    pose proof (close_trans _ _ _ _ _ (x_close j (p - j)) (close_sym _ _ _ (x_close j (q - j))) i Hi); lra. }
  destruct (R_complete _ Hc) as [l Hl]; unfold fixed_point; rewrite (the_spec _ l Hl) by (intros y Hy;
    apply (UL_sequence _ _ _ Hy Hl)).
  apply le_epsilon; intros e He; destruct (Hl e He) as [j Hj]; specialize (Hj (m + j)%nat ltac:(lia));
    unfold R_dist in Hj.
  rewrite Rabs_minus_sym in Hj; pose proof (x_close m j i Hi);
    pose proof (Rabs_triang (l - x (m + j) i) (x (m + j) i - x m i)) as A.
  replace (l - x (m + j) i + (x (m + j) i - x m i)) with (l - x m i) in A by ring; lra.
Qed.
Lemma fixed_boxed : boxed fixed_point.
Proof.
  intros i Hi; assert (C : forall m, Rabs (fixed_point i - x m i) <= weight i * D * k ^ m) by (intros m;
    pose proof (fixed_close m i Hi); lra).
  split; apply (squeezed k _ _ (weight i * D) Hk); intros m; specialize (C m); pose proof (x_boxed m i Hi);
    pose proof (Rle_abs (fixed_point i - x m i)); pose proof (Rle_abs (- (fixed_point i - x m i)));
    rewrite Rabs_Ropp in *; lra.
Qed.

(** It is the only one, and where T moves a family little, that is near it. *)
Theorem fixed : exists s, boxed s /\ (forall i, P i -> T s i = s i) /\
  forall w r, 0 <= r -> boxed w -> close r (T w) w -> close (r / (1 - k)) s w.
Proof.
  assert (HF : forall i, P i -> T fixed_point i = fixed_point i).
  { intros i Hi; apply Rminus_diag_uniq, Rabs_zero, (squeezed k _ 0 (2 * (weight i * D)) Hk); intros m.
    assert (A : close (k ^ S m * D) (T fixed_point) (x (S m))).
    { cbn [pow]; rewrite Rmult_assoc; apply HT; auto using part, fixed_boxed, x_boxed, fixed_close. }
    pose proof (close_trans _ _ _ _ _ A (close_sym _ _ _ (fixed_close (S m))) i Hi) as B; cbn [pow] in B.
    assert (k * (weight i * D * k ^ m) <= 1 * (weight i * D * k ^ m)); [|lra]; apply Rmult_le_compat_r; [|lra].
    pose proof (Rmult_le_pos _ _ (Rlt_le _ _ (Hweight i Hi)) (part m)); lra. }
  exists fixed_point; split; [exact fixed_boxed|]; split; [exact HF|]; intros w r Hr Hw Hc;
    assert (R0 : 0 <= r / (1 - k)).
  { apply Rmult_le_pos; [exact Hr | left; apply Rinv_0_lt_compat; lra]. }
  assert (H : forall m, close (k ^ m * D + r / (1 - k)) fixed_point w).
  { induction m as [|m IH].
    - intros i Hi; pose proof (boxed_close _ _ fixed_boxed Hw i Hi) as A; cbn [pow];
        pose proof (Rmult_le_pos _ _ (Rlt_le _ _ (Hweight i Hi)) R0); lra.
    - intros i Hi; rewrite <- (HF i Hi).
      replace (k ^ S m * D + r / (1 - k)) with (k * (k ^ m * D + r / (1 - k)) + r) by (cbn [pow]; field; lra).
      apply (close_trans _ _ _ (T w)); trivial; apply HT; auto using fixed_boxed; pose proof (part m); lra. }
  intros i Hi; apply (squeezed k _ _ (weight i * D) Hk); intros m; specialize (H m i Hi); lra.
Qed.
End Contraction.

(** Families |z k| <= d, and halves. *)
Definition near (I : Type) (P : I -> Prop) (e : R) (z w : I -> R) : Prop := forall k, P k -> Rabs (z k - w k) <= e.
Theorem contraction (I : Type) (P : I -> Prop) (T : (I -> R) -> I -> R) d : let near := near I P in let o := fun _ =>
  0 in 0 <= d -> (forall e z w, near d z o -> near d w o -> near e z w -> near (e / 2) (T z) (T w)) ->
  near (d / 2) (T o) o -> exists z, near d z o /\ (forall k, P k -> T z k = z k) /\ forall w r, near d w o ->
  near r (T w) w -> near (2 * r) z w.
Proof.
  intros near o Hd HT H0; assert (B : forall z, boxed I P (fun _ => - d) (fun _ => d) z <-> near d z o).
  { intros z; split; intros H i Hi; specialize (H i Hi); unfold o in *; rewrite Rminus_0_r in *;
      [apply Rabs_le; exact H|].
    pose proof (Rle_abs (z i)); pose proof (Rle_abs (- z i)); rewrite Rabs_Ropp in *; lra. }
  assert (C : forall e z w, close I P (fun _ => 1) e z w <-> near e z w) by (intros; unfold close, near,
    Contraction.near; split; intros H i Hi; specialize (H i Hi); lra).
  destruct (fixed I P (fun _ => 1) (fun _ => - d) (fun _ => d) T (1 / 2) (2 * d)) as (z & Hz & F & U).
  - intros i Hi; lra.
  - intros; lra.
  - lra.
  - split; [lra | intros; lra].
  - intros z Hz; rewrite B in *; intros i Hi; assert (Ho : near d o o) by (intros j _; unfold o; rewrite Rminus_0_r,
      Rabs_R0; exact Hd).
    specialize (HT d z o Hz Ho Hz i Hi); specialize (H0 i Hi); unfold o in *; rewrite Rminus_0_r in *.
    pose proof (Rabs_triang (T z i - T (fun _ => 0) i) (T (fun _ => 0) i)) as A;
      replace (T z i - T (fun _ => 0) i + T (fun _ => 0) i) with (T z i) in A by ring; lra.
  - intros e z w He Hz Hw Hc; rewrite B in *; rewrite C in *; replace (1 / 2 * e) with (e / 2) by field; apply HT;
      assumption.
  - exists z; split; [apply B, Hz|]; split; [exact F|]; intros w r Hw Hr i Hi; assert (R0 : 0 <= r)
      by (eapply Rle_trans; [apply Rabs_pos | exact (Hr i Hi)]).
    pose proof (U w r R0 (proj2 (B w) Hw) (proj2 (C r _ _) Hr) i Hi) as A; replace (r / (1 - 1 / 2)) with (2 * r) in A
      by field; lra.
Qed.

(** Sequences Z -> R, with weights. *)
Definition inside (lo hi s : Z -> R) : Prop := forall i, lo i <= s i <= hi i.
Theorem one_fixed_point lo hi weight T k D : inside lo hi lo -> (forall i, 0 < weight i) -> 0 <= k < 1 ->
  (0 <= D /\ forall i, hi i - lo i <= weight i * D) -> (forall s, inside lo hi s -> inside lo hi (T s)) ->
  (forall d s s', 0 <= d -> inside lo hi s -> inside lo hi s' -> (forall i, Rabs (s i - s' i) <= weight i * d) ->
  forall i, Rabs (T s i - T s' i) <= weight i * (k * d)) -> exists s, inside lo hi s /\ (forall i, T s i = s i) /\
  forall s', inside lo hi s' -> (forall i, T s' i = s' i) -> forall i, s' i = s i.
Proof.
  intros Hlo Hw Hk HD Hin HT.
  assert (B : forall s, boxed Z (fun _ => True) lo hi s <-> inside lo hi s) by (intros s; split; intros H i; auto).
  destruct (fixed Z (fun _ => True) weight lo hi T k D) as (s & Hs & F & U).
  - apply B, Hlo.
  - auto.
  - exact Hk.
  - split; [apply HD | intros i _; apply HD].
  - intros s H; apply B, Hin, B, H.
  - intros d s s' Hd H H' Hc i _; apply HT; [exact Hd | apply B, H | apply B, H' | intros j; auto].
  - exists s; split; [apply B, Hs|]; split; [auto|]; intros s' H' F' i; symmetry; apply Rminus_diag_uniq, Rabs_zero.
    replace 0 with (weight i * (0 / (1 - k))) by (field; lra); apply (U s' 0); [lra | apply B, H' | | exact Logic.I].
    intros j _; rewrite F', Rminus_eq_0, Rabs_R0; lra.
Qed.
