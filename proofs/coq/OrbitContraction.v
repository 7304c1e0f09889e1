(** * Contractions of bounded families of numbers have exactly one fixed point

    Families I -> R, compared at the indices with P only: no function space is needed. *)

From Coq Require Import Reals Lra Lia ClassicalFacts Classical_Prop.
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
Proof.
  destruct (chosen_exists P) as [x Hx]; exists x; intros y Hy.
  right; apply (chosen_unique P); assumption.
Qed.

Definition the (P : R -> Prop) : R := proj1_sig (completeness _ (chosen_bound P) (chosen_exists P)).

Lemma the_spec (P : R -> Prop) x : P x -> (forall y, P y -> y = x) -> the P = x.
Proof.
  intros Px Hx; unfold the; destruct completeness as (m & Hub & Hleast); cbn.
  assert (Cx : chosen P x) by (left; auto).
  apply Rle_antisym; [apply Hleast | apply Hub, Cx].
  intros y Hy; right; apply (chosen_unique P); assumption.
Qed.

Lemma div_1 x : x / 1 = x.
Proof. field. Qed.

Lemma halves c e : 0 < e -> exists m, c / 2 ^ m < e.
Proof.
  intros He; assert (Hp : forall m, 0 < 2 ^ m) by (intros; apply pow_lt; lra).
  destruct (Rle_lt_dec c 0) as [Hc|Hc].
  - exists 0%nat; cbn; lra.
  - destruct (pow_lt_1_zero (/ 2)) with (y := e / c) as [m Hm].
    + rewrite Rabs_pos_eq; lra.
    + apply Rdiv_lt_0_compat; assumption.
    + exists m; specialize (Hm m (le_n m)); rewrite Rabs_pos_eq, pow_inv in Hm by (apply pow_le; lra).
      apply (Rmult_lt_compat_l c) in Hm; [|assumption].
      replace (c * (e / c)) with e in Hm by (field; lra); exact Hm.
Qed.

Lemma Rabs_zero x : Rabs x <= 0 -> x = 0.
Proof. unfold Rabs; destruct Rcase_abs; lra. Qed.

Lemma squeeze x a c : (forall m, x <= a + c / 2 ^ m) -> x <= a.
Proof.
  intros H; apply Rnot_lt_le; intros Hlt; destruct (halves c (x - a)) as [m Hm]; [lra|].
  specialize (H m); lra.
Qed.

Section Contraction.
Variables (I : Type) (P : I -> Prop) (T : (I -> R) -> I -> R) (d : R).
Definition near (e : R) (z w : I -> R) : Prop := forall k, P k -> Rabs (z k - w k) <= e.
Let o : I -> R := fun _ => 0.
Hypothesis Hd : 0 <= d.
Hypothesis HT : forall e z w, near d z o -> near d w o -> near e z w -> near (e / 2) (T z) (T w).
Hypothesis H0 : near (d / 2) (T o) o.

Lemma near_sym e z w : near e z w -> near e w z.
Proof. intros H k Hk; rewrite Rabs_minus_sym; auto. Qed.

Lemma near_trans e e' z w v : near e z w -> near e' w v -> near (e + e') z v.
Proof.
  intros H H' k Hk; replace (z k - v k) with ((z k - w k) + (w k - v k)) by ring.
  eapply Rle_trans; [apply Rabs_triang | apply Rplus_le_compat; auto].
Qed.

Lemma near_le e e' z w : e <= e' -> near e z w -> near e' z w.
Proof. intros He H k Hk; eapply Rle_trans; eauto. Qed.

Fixpoint approx (m : nat) : I -> R := match m with O => o | S j => T (approx j) end.

Lemma half_pow m : d / 2 ^ S m = d / 2 ^ m / 2.
Proof. cbn; field; apply pow_nonzero; lra. Qed.

Lemma approx_in m : near d (approx m) o.
Proof.
  induction m as [|m IH]; cbn.
  - intros k _; unfold o; rewrite Rminus_0_r, Rabs_R0; exact Hd.
  - replace d with (d / 2 + d / 2) by field; apply near_trans with (T o); [|exact H0].
    apply HT; [exact IH | | exact IH]; intros k _; unfold o; rewrite Rminus_0_r, Rabs_R0; exact Hd.
Qed.

Lemma approx_step m i : near (d / 2 ^ m) (approx (m + i)) (approx m).
Proof.
  induction m as [|m IH]; [cbn; rewrite div_1; apply approx_in|].
  rewrite half_pow; apply HT; auto using approx_in.
Qed.

Definition limit (k : I) : R := the (Un_cv (fun m => approx m k)).

Lemma limit_near m : near (d / 2 ^ m) limit (approx m).
Proof.
  intros k Hk.
  assert (Hc : Cauchy_crit (fun j => approx j k)).
  { intros e He; destruct (halves (2 * d) e He) as [j Hj]; exists j; intros p q Hp Hq; unfold R_dist.
    replace p with (j + (p - j))%nat by lia; replace q with (j + (q - j))%nat by lia.
    eapply Rle_lt_trans; [apply (near_trans (d / 2 ^ j) (d / 2 ^ j) _ (approx j)); [apply approx_step |
      apply near_sym, approx_step | exact Hk]|]; unfold Rdiv in *; lra. }
  destruct (R_complete _ Hc) as [l Hl].
  unfold limit; rewrite (the_spec _ l Hl) by (intros y Hy; apply (UL_sequence _ _ _ Hy Hl)).
  apply le_epsilon; intros e He; destruct (Hl e He) as [j Hj].
  specialize (Hj (m + j)%nat ltac:(lia)); unfold R_dist in Hj; rewrite Rabs_minus_sym in Hj.
  pose proof (approx_step m j k Hk) as Hs.
  replace (l - approx m k) with ((l - approx (m + j) k) + (approx (m + j) k - approx m k)) by ring.
  eapply Rle_trans; [apply Rabs_triang | lra].
Qed.

Theorem contraction : exists z, near d z o /\ (forall k, P k -> T z k = z k) /\
  forall w r, near d w o -> near r (T w) w -> near (2 * r) z w.
Proof.
  assert (Hin : near d limit o) by (rewrite <- div_1 at 1; exact (limit_near 0)).
  exists limit; split; [exact Hin | split].
  - intros k Hk; apply Rminus_diag_uniq, Rabs_zero.
    apply (squeeze _ 0 d); intros m.
    replace (0 + d / 2 ^ m) with (d / 2 ^ m / 2 + d / 2 ^ S m) by (rewrite half_pow; field; apply pow_nonzero; lra).
    apply near_trans with (approx (S m)); [|apply near_sym, limit_near | exact Hk].
    cbn [approx]; apply HT; [exact Hin | apply approx_in | apply limit_near].
  - intros w r Hw Hr.
    assert (H : forall m, near (d / 2 ^ m + 2 * r) (approx m) w).
    { induction m as [|m IH].
      - intros k Hk; pose proof (near_sym _ _ _ Hw k Hk); pose proof (Hr k Hk).
        pose proof (Rabs_pos (T w k - w k)); cbn [approx pow]; unfold o in *; lra.
      - replace (d / 2 ^ S m + 2 * r) with ((d / 2 ^ m + 2 * r) / 2 + r) by (rewrite half_pow; field; apply pow_nonzero; lra).
        cbn [approx]; apply near_trans with (T w); [apply HT; auto using approx_in | exact Hr]. }
    intros k Hk; apply (squeeze _ _ (2 * d)); intros m.
    replace (2 * r + 2 * d / 2 ^ m) with (d / 2 ^ m + (d / 2 ^ m + 2 * r)) by (field; apply pow_nonzero; lra).
    apply near_trans with (approx m); [apply limit_near | apply H | exact Hk].
Qed.
End Contraction.
