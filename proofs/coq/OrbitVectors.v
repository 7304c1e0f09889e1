(** * Rows and powers of a matrix are linear, and bounded in the maximum norm *)

From Coq Require Import Reals FunctionalExtensionality Lra Lia.
From Grazing Require Import StatementOrbits.
Open Scope R_scope.

(** a x + c y *)
Definition comb (a c : R) (x y : vec) : vec := fun i => a * x i + c * y i.

Lemma minus_comb x y : minus x y = comb 1 (-1) x y. Proof. extensionality i; unfold minus, comb; ring. Qed.

Section Vectors.
Variable N : nat.
Notation within := (within N).
Notation dot := (dot N).
Notation mult := (mult N).

Lemma within_le e e' x : e <= e' -> within e x -> within e' x.
Proof. intros He H i Hi; eapply Rle_trans; [apply H, Hi | exact He]. Qed.
Lemma within_zero e : 0 <= e -> within e zero.
Proof. intros He i _; unfold zero; rewrite Rabs_R0; exact He. Qed.
Lemma within_comb a c e e' x y : within e x -> within e' y -> within (Rabs a * e + Rabs c * e') (comb a c x y).
Proof.
  intros Hx Hy i Hi; unfold comb; eapply Rle_trans; [apply Rabs_triang|]; rewrite !Rabs_mult.
  apply Rplus_le_compat; apply Rmult_le_compat_l; try apply Rabs_pos; auto.
Qed.
Lemma within_minus e e' x y : within e x -> within e' y -> within (e + e') (minus x y).
Proof.
  intros Hx Hy i Hi; unfold minus, Rminus; eapply Rle_trans; [apply Rabs_triang|].
  rewrite Rabs_Ropp; apply Rplus_le_compat; auto.
Qed.

(** Every vector has a bound. *)
Lemma within_exists x : exists e, 0 <= e /\ within e x.
Proof.
  clear; unfold StatementOrbits.within; induction N as [|m (e & He & H)].
  - exists 0; split; [lra | intros; lia].
  - exists (Rmax e (Rabs (x m))); split; [eapply Rle_trans; [exact He | apply Rmax_l]|].
    intros i Hi; destruct (Nat.eq_dec i m) as [->|Hne]; [apply Rmax_r|].
    eapply Rle_trans; [apply H; lia | apply Rmax_l].
Qed.
Lemma dot_ext c x y : (forall i, (i < N)%nat -> x i = y i) -> dot c x = dot c y.
Proof.
  clear; induction N as [|m IH]; intros H; [reflexivity|]; cbn.
  rewrite IH, H by (intros; try apply H; lia); reflexivity.
Qed.
Lemma dot_comb v a c x y : dot v (comb a c x y) = a * dot v x + c * dot v y.
Proof. clear; induction N as [|m IH]; cbn; [ring|]; rewrite IH; unfold comb; ring. Qed.
Lemma dot_minus v x y : dot v (minus x y) = dot v x - dot v y. Proof. rewrite minus_comb, dot_comb; ring. Qed.
Lemma dot_zero v : dot v zero = 0.
Proof. clear; induction N as [|m IH]; cbn; [reflexivity | rewrite IH; unfold zero; ring]. Qed.
Lemma dot_bound v : exists m, 0 <= m /\ forall e x, within e x -> Rabs (dot v x) <= m * e.
Proof.
  clear; unfold StatementOrbits.within; induction N as [|k (m & Hm & H)]; cbn.
  - exists 0; split; [lra|]; intros; rewrite Rabs_R0; lra.
  - exists (m + Rabs (v k)); split; [pose proof (Rabs_pos (v k)); lra|]; intros e x Hx.
    eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_mult, Rmult_plus_distr_r.
    apply Rplus_le_compat; [apply H; auto|]. apply Rmult_le_compat_l; [apply Rabs_pos | apply Hx; lia].
Qed.

Variable A : nat -> vec.
Notation power k := (Nat.iter k (mult A)).

Lemma power_comb k a c x y : power k (comb a c x y) = comb a c (power k x) (power k y).
Proof.
  induction k as [|k IH]; [reflexivity|].
  change (mult A (power k (comb a c x y)) = comb a c (mult A (power k x)) (mult A (power k y))).
  rewrite IH; extensionality i; apply dot_comb.
Qed.
Lemma power_minus k x y : power k (minus x y) = minus (power k x) (power k y).
Proof. rewrite !minus_comb; apply power_comb. Qed.
Lemma power_zero k : power k zero = zero.
Proof.
  induction k as [|k IH]; [reflexivity|]; change (mult A (power k zero) = zero).
  rewrite IH; extensionality i; apply dot_zero.
Qed.
Lemma power_ext k x y : (forall i, (i < N)%nat -> x i = y i) -> forall i, (i < N)%nat -> power k x i = power k y i.
Proof. intros H; induction k as [|k IH]; [exact H|]; intros i _; apply dot_ext, IH. Qed.
Lemma mult_bound : exists m, 1 <= m /\ forall e x, 0 <= e -> within e x -> within (m * e) (mult A x).
Proof.
  assert (H : forall k, exists m, 1 <= m /\ forall e x, 0 <= e -> within e x -> forall i, (i < k)%nat ->
    Rabs (mult A x i) <= m * e).
  { induction k as [|k (m & Hm & H)]; [exists 1; split; [lra | intros; lia]|].
    destruct (dot_bound (A k)) as (a & Ha & Hk); exists (m + a); split; [lra|].
    intros e x He Hx i Hi; destruct (Nat.eq_dec i k) as [->|Hne].
    - eapply Rle_trans; [apply (Hk e x Hx)|]; apply Rmult_le_compat_r; lra.
    - eapply Rle_trans; [apply (H e x He Hx); lia|]; apply Rmult_le_compat_r; lra. }
  exact (H N).
Qed.

(** One bound for all powers up to the n-th. *)
Lemma power_bound n : exists m, 1 <= m /\ forall k e x, (k <= n)%nat -> 0 <= e -> within e x ->
  within (m * e) (power k x).
Proof.
  destruct mult_bound as (m & Hm & H); exists (m ^ n); split; [apply pow_R1_Rle, Hm|]. intros k e x Hk He Hx.
  apply within_le with (m ^ k * e); [apply Rmult_le_compat_r; [exact He | apply Rle_pow; assumption]|].
  clear Hk; induction k as [|k IH]; [cbn; rewrite Rmult_1_l; exact Hx|].
  change (within (m ^ S k * e) (mult A (power k x))). replace (m ^ S k * e) with (m * (m ^ k * e)) by (cbn; ring).
  apply H; [|exact IH]; apply Rmult_le_pos; [apply pow_le; lra | exact He].
Qed.
End Vectors.
