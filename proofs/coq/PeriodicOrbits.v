(** * Proof of Theorem 1 as in the paper: for finitely many impacts det D <> 0 suffices *)

From Coq Require Import Reals Arith Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPeriodic Finite OrbitVectors
  Contraction OrbitRemainder OrbitFixedPoint Orbits SquareSystems PlaneOrbits.
Open Scope R_scope.

Lemma nat_max (F : nat -> nat) m : exists p, forall k, (k < m)%nat -> (F k <= p)%nat.
Proof.
  induction m as [|m (p & H)]; [exists 0%nat; lia|]; exists (Nat.max p (F m)); intros k Hk.
  destruct (Nat.eq_dec k m) as [->|Hne]; [lia | specialize (H k ltac:(lia)); lia].
Qed.

Section Periodic.
Variables (M : Map.t) (J : Type) (next : J -> J) (n : J -> nat).
Variables (m : nat) (at_ : nat -> J) (index : J -> nat).
Hypothesis Hindex : forall j, (index j < m)%nat /\ at_ (index j) = j.
Hypothesis Hat : forall k, (k < m)%nat -> index (at_ k) = k.
Hypothesis HD : det_D_not_0 M J next n.
Notation N := (Map.N M).
Notation p := (S N).

(** All unknowns in one vector: those of impact number k from k (N + 1) on. *)
Definition X_of (z : vec) : J -> vec := fun j i => z (index j * p + i)%nat.
Definition Y_of (z : vec) : J -> R := fun j => z (index j * p + N)%nat.
Definition left_side (X : J -> vec) (Y : J -> R) : vec := fun k =>
  let j := at_ (k / p) in let i := (k mod p)%nat in
  if (i <? N)%nat then X (next j) i - power M (n j) (X j) i - Y j * Map.B M i
  else dot N (Map.C M) (power M (n j) (X j)).
Definition right_side (Q : J -> vec) (q : J -> R) : vec := fun k =>
  if (k mod p <? N)%nat then Q (at_ (k / p)) (k mod p)%nat else q (at_ (k / p)).

Lemma place j i : (i < p)%nat -> (index j * p + i < m * p)%nat /\
  ((index j * p + i) / p)%nat = index j /\ ((index j * p + i) mod p)%nat = i.
Proof.
  intros Hi; destruct (Hindex j) as [Hj _]; split; [nia|].
  split; symmetry; [apply Nat.div_unique with i | apply Nat.mod_unique with (index j)]; lia.
Qed.

Lemma placed k : (k < m * p)%nat -> exists j i, (i < p)%nat /\ k = (index j * p + i)%nat.
Proof.
  intros Hk; exists (at_ (k / p)), (k mod p)%nat; split; [apply Nat.mod_upper_bound; lia|].
  rewrite Hat by (apply Nat.div_lt_upper_bound; lia). pose proof (Nat.div_mod k p ltac:(lia)); lia.
Qed.

Lemma linear_sides X Y Q q : linear M J next n X Y Q q <->
  forall k, (k < m * p)%nat -> left_side X Y k = right_side Q q k.
Proof.
  assert (E : forall j i, (i < p)%nat -> (left_side X Y (index j * p + i)%nat = right_side Q q (index j * p + i)%nat <->
    if (i <? N)%nat then X (next j) i - power M (n j) (X j) i - Y j * Map.B M i = Q j i else dot N (Map.C M)
    (power M (n j) (X j)) = q j)).
  { intros j i Hi; destruct (place j i Hi) as (_ & E1 & E2); unfold left_side, right_side; cbv zeta.
    rewrite E1, E2, (proj2 (Hindex j)); destruct (i <? N)%nat; reflexivity. }
  split.
  - intros H k Hk; destruct (placed k Hk) as (j & i & Hi & ->); apply E; [exact Hi|].
    destruct (H j) as [H1 H2]; destruct (Nat.ltb_spec i N); auto.
  - intros H j; split.
    + specialize (H _ (proj1 (place j N ltac:(lia)))); apply E in H; [|lia]; rewrite Nat.ltb_irrefl in H; exact H.
    + intros i Hi; specialize (H _ (proj1 (place j i ltac:(lia)))); apply E in H; [|lia].
      destruct (Nat.ltb_spec i N); [exact H | lia].
Qed.

Lemma of_bounded t z : within (m * p) t z -> bounded M J t (X_of z) (Y_of z).
Proof. intros H j; split; [intros i Hi|]; apply H, place; lia. Qed.

Lemma invertible_finite : exists K, invertible M J next n K.
Proof.
  destruct (linear_map_bounded (m * p) (fun z => left_side (X_of z) (Y_of z))) as (K & HK & H).
  - intros a c x y k _; unfold left_side; cbv zeta.
    change (X_of (comb a c x y)) with (fun j => comb a c (X_of x j) (X_of y j)).
    change (Y_of (comb a c x y)) with (fun j => a * Y_of x j + c * Y_of y j); cbv beta.
    unfold power; rewrite power_comb, dot_comb; unfold comb; destruct (_ <? _)%nat; ring.
  - intros x y Hxy k _.
    assert (EX : forall j i, (i < N)%nat -> X_of x j i = X_of y j i) by (intros j i Hi; apply Hxy, place; lia).
    assert (EY : forall j, Y_of x j = Y_of y j) by (intros j; apply Hxy, place; lia).
    unfold left_side; cbv zeta; rewrite EY; destruct (Nat.ltb_spec (k mod p) N) as [Hi|Hi].
    + rewrite EX by exact Hi; f_equal; f_equal; apply power_ext; [apply EX | exact Hi].
    + apply dot_ext, power_ext, EX.
  - intros x Hx k Hk; destruct (placed k Hk) as (j & i & Hi & ->).
    destruct (HD (X_of x) (Y_of x)) with (j := j) as [HY HX].
    + apply linear_sides; intros k' Hk'; rewrite (Hx k' Hk'); unfold right_side, zero.
      destruct (_ <? _)%nat; reflexivity.
    + destruct (Nat.eq_dec i N) as [->|Hne]; [exact HY | apply HX; lia].
  - exists K; split.
    + intros t Q q HQ.
      assert (Ht : m = 0%nat \/ 0 <= t).
      { destruct (Nat.eq_dec m 0) as [E|E]; [left; exact E | right]. apply (Rabs_nonneg (q (at_ 0))), HQ. }
      destruct Ht as [Hm|Ht].
      { exists (fun _ => zero), (fun _ => 0); split; intros j; destruct (Hindex j); lia. }
      destruct (H (right_side Q q) t) as (z & Hz & Hk); [|exact Ht|].
      * intros k Hk; destruct (placed k Hk) as (j & i & Hi & ->); destruct (place j i Hi) as (_ & E1 & E2).
        unfold right_side; rewrite E1, E2, (proj2 (Hindex j)); destruct (HQ j) as [H1 H2].
        destruct (Nat.ltb_spec i N); [apply H1; assumption | exact H2].
      * exists (X_of z), (Y_of z); split; [apply of_bounded, Hz | apply linear_sides, Hk].
    + intros _ X Y _ Hl j; destruct (HD X Y Hl j) as [HY HX]; split.
      * intros i Hi; rewrite (HX i Hi), Rabs_R0; lra.
      * rewrite HY, Rabs_R0; lra.
Qed.

(** Positive quantities have a positive lower bound. *)
Lemma least_quantity X Y s : (forall j v, quantity M J n X Y s j v -> v > 0) ->
  exists kappa, 0 < kappa /\ forall j v, quantity M J n X Y s j v -> v >= kappa.
Proof.
  intros Hq. destruct (common_bound (fun k d => forall v, quantity M J n X Y s (at_ k) v -> d <= v) m) as (d & Hd & H).
  - intros k d d' H Hd v Hv; specialize (H v Hv); lra.
  - intros k _; set (j := at_ k). pose (V i := sgn s * (dot N (Map.C M) (power M i (X j)) + 1)).
    destruct (common_bound (fun i d => (1 <= i)%nat -> d <= V i) (n j)) as (d & Hd & H).
    + intros i d d' H Hd Hi; specialize (H Hi); lra.
    + intros i Hi; destruct (Nat.eq_dec i 0) as [->|Hne]; [exists 1; split; [lra | lia]|].
      exists (V i); split; [|lra]; apply (Hq j); right; exists i; split; [lia | reflexivity].
    + exists (Rmin d (sgn s * Y j)); split.
      * apply Rmin_glb_lt; [exact Hd | apply (Hq j); left; reflexivity].
      * intros v [->|(i & Hi & ->)]; [apply Rmin_r|]. apply Rle_trans with d; [apply Rmin_l | apply (H i); lia].
  - exists d; split; [exact Hd|]; intros j v Hv; destruct (Hindex j) as [Hj Ej].
    apply Rle_ge, (H (index j) Hj); rewrite Ej; exact Hv.
Qed.
End Periodic.

Theorem Theorem1_periodic : Theorem1_statement_periodic.
Proof.
  intros M HM HIA; set (N := Map.N M).
  destruct (linear_map_bounded N (fun x i => x i - mult N (Map.A M) x i)) as (K0 & _ & Hsolve).
  - intros a c x y k _; unfold mult; rewrite dot_comb; unfold comb; ring.
  - intros x y Hxy k Hk; rewrite (Hxy k Hk); f_equal; apply dot_ext, Hxy.
  - exact HIA.
  - destruct (within_exists N (Map.phi M)) as (t & Ht & Hphi). destruct (Hsolve (Map.phi M) t Hphi Ht) as (w & _ & Hw).
    assert (Hw' : forall i, (i < N)%nat -> w i = mult N (Map.A M) w i + Map.phi M i) by (intros i Hi;
      rewrite <- (Hw i Hi); ring).
    exists w; split; [exact Hw'|]; intros e He0 J next n (m & at_ & index & Hindex & Hat) Hn HD.
    destruct (invertible_finite M J next n m at_ index Hindex Hat HD) as (K & HK).
    destruct (nat_max (fun k => n (at_ k)) m) as (n_max & Hmax).
    assert (Hnm : forall j, (1 <= n j <= n_max)%nat).
    { intros j; destruct (Hindex j) as [Hj Ej]; split; [apply Hn|]; rewrite <- Ej; apply Hmax, Hj. }
    destruct (proj1 HK 1 (fun _ => zero) (fun _ => -1)) as (X & Y & HXb & HXl).
    { intros j; split; [apply within_zero; lra | rewrite Rabs_left; lra]. }
    assert (HX : solution M J next n X Y) by (split; [exists (K * 1)|]; assumption).
    destruct (Orbits.Theorem1 M w e HM Hw' eq_refl He0 n_max K) as (d & Hd & Hmain & Hlead).
    assert (Hae : 0 < Rabs e) by (apply Rabs_pos_lt, He0). exists X, Y; split; [exact HXl|]; intros s; split.
    + intros Hq; destruct (least_quantity M J n m at_ index Hindex X Y s Hq) as (kappa & Hkappa & Hge).
      exists d; split; [exact Hd | split].
      * destruct (Hmain kappa Hkappa) as (mu0 & Hmu0 & H); exists mu0; split; [exact Hmu0|].
        intros mu Hmu; apply (H J next n X Y s mu Hnm HK HX Hmu), Hge.
      * intros eps Heps; destruct (Hlead 1) as (mu1 & Hmu1 & Hx); [lra|].
        destruct (within_exists N w) as (W & HW & Hwb).
        assert (HeK : 0 <= Rabs e * Rabs (K * 1)) by (apply Rmult_le_pos; apply Rabs_pos).
        set (c := 1 + W + Rabs e * Rabs (K * 1)); assert (Hc : 1 <= c) by (unfold c; lra).
        exists (Rabs e * Rmin mu1 (eps / c)); split.
        { apply Rmult_lt_0_compat; [exact Hae|]; apply Rmin_glb_lt; [|apply Rdiv_lt_0_compat]; lra. }
        intros mu x Hmu Horb j i Hi; apply small_mu in Hmu; [|exact He0].
        destruct (Hx J next n X Y mu x Hnm HK HX) with (j := j) as [Hxj _]; trivial.
        { split; [apply Hmu | eapply Rlt_le_trans; [apply Hmu | apply Rmin_l]]. }
        specialize (Hxj i Hi); specialize (Hwb i Hi); destruct (HXb j) as [HXj _]; specialize (HXj i Hi).
        pose proof (Rle_abs (K * 1)) as HKa.
        replace (x j i) with ((x j i - mu * w i - e * mu * X j i) + w i * mu + e * X j i * mu) by ring.
        apply Rle_trans with (1 * Rabs mu + W * Rabs mu + Rabs e * Rabs (K * 1) * Rabs mu).
        -- apply triangle3; [exact Hxj | apply Rabs_mult_le; lra|]. apply Rabs_mult_le; [apply Rabs_mult_le|]; lra.
        -- replace (1 * Rabs mu + W * Rabs mu + Rabs e * Rabs (K * 1) * Rabs mu) with (c * Rabs mu) by (unfold c; ring).
           replace eps with (c * (eps / c)) by (field; lra); apply Rmult_le_compat_l; [lra|].
           left; eapply Rlt_le_trans; [apply Hmu | apply Rmin_r].
    + intros j v Hv Hneg; destruct (Hmain (- v)) as (mu0 & Hmu0 & H); [lra|].
      exists d, mu0; split; [exact Hd | split; [exact Hmu0|]]; intros mu x Hmu.
      apply (H J next n X Y s mu Hnm HK HX Hmu) with (j := j) (v := v); [exact Hv | lra].
Qed.

Theorem Symmetry : Symmetry_statement.
Proof. intros M J next n mu d x sigma Hs Hn H j; pose proof (H (sigma j)) as Hj. rewrite Hn, <- Hs in Hj; exact Hj. Qed.
