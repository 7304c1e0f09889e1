(** * For maps of the plane the signs of (52) and (64) decide which words over finitely many lengths have orbits *)

From Coq Require Import Reals Arith Lra Lia.
From Grazing Require Import Defs Algebra StatementOrbits StatementOrbitsPlane
  StatementUniform StatementUnstable OrbitVectors Contraction OrbitRemainder OrbitFixedPoint Orbits OrbitsNear
    OrbitsUnstable PlaneLinear.
Open Scope R_scope.

Lemma sgn_above s x kappa : kappa <= Rabs x -> 0 < sgn s * x -> sgn s * x >= kappa.
Proof. destruct s; cbn [sgn]; unfold Rabs; destruct Rcase_abs; lra. Qed.
Lemma sgn_below s x kappa : kappa <= Rabs x -> sgn s * x < 0 -> sgn s * x <= - kappa.
Proof. destruct s; cbn [sgn]; unfold Rabs; destruct Rcase_abs; lra. Qed.
Lemma sgn_zero s : sgn s * 0 = 0. Proof. ring. Qed.

(** The sign of gamma cancels. *)
Lemma sgn_gamma s g gamma y : 0 < sgn g * gamma -> (0 < sgn s * sgn g * (gamma * y) <-> 0 < sgn s * y) /\
  (sgn s * sgn g * (gamma * y) < 0 <-> sgn s * y < 0).
Proof.
  intros H; replace (sgn s * sgn g * (gamma * y)) with ((sgn g * gamma) * (sgn s * y)) by ring.
  set (p := sgn g * gamma) in *; set (q := sgn s * y); split; split; intros; nra.
Qed.
Lemma small_mu e s mu t : e <> 0 -> 0 < sgn s * (e * mu) < Rabs e * t -> 0 < Rabs mu < t.
Proof.
  intros He [H1 H2]; assert (Hae : 0 < Rabs e) by (apply Rabs_pos_lt, He); split.
  - apply Rabs_pos_lt; intros ->; rewrite Rmult_0_r, sgn_zero in H1; lra.
  - apply (Rmult_lt_reg_l (Rabs e)); [exact Hae|]; rewrite <- Rabs_mult.
    replace (Rabs (e * mu)) with (sgn s * (e * mu)); [exact H2|].
    destruct s; cbn [sgn] in *; [rewrite Rabs_pos_eq | rewrite Rabs_left]; lra.
Qed.
Theorem Theorem1_plane : forall M a1 a2 gamma e w,
  planar M a1 a2 gamma e w -> forall n_max, exists d mu0, d > 0 /\ mu0 > 0 /\
  (forall (J : Type) (next prev : J -> J) n s g mu,
   (forall j, prev (next j) = j /\ next (prev j) = j) ->
   (forall j, (1 <= n j <= n_max)%nat /\ u a1 a2 (n j) <> 0) ->
   sgn g * gamma > 0 -> 0 < sgn s * (e * mu) < mu0 ->
   ((forall j, (forall k, (1 <= k <= n j - 1)%nat -> sgn s * b a1 a2 (n j) k > 0) /\
               sgn s * sgn g * follows a1 a2 (n j) (n (next j)) > 0) ->
    exists x, orbit_near M J next n mu d x /\
    forall x', orbit_near M J next n mu d x' -> (forall j i, (i < 2)%nat -> x' j i = x j i) /\
    exists c, 0 < c /\ forall j, clear_at M mu (n j) (x' j) c) /\
   (forall j, (exists k, (1 <= k <= n j - 1)%nat /\ sgn s * b a1 a2 (n j) k < 0) \/
              sgn s * sgn g * follows a1 a2 (n j) (n (next j)) < 0 ->
    forall x, ~ orbit_near M J next n mu d x)) /\
  (** These orbits tend to 0 with mu, uniformly. *)
  (forall eps, eps > 0 -> exists mu1, mu1 > 0 /\ forall (J : Type) (next prev : J -> J) n mu x,
   (forall j, prev (next j) = j /\ next (prev j) = j) ->
   (forall j, (1 <= n j <= n_max)%nat /\ u a1 a2 (n j) <> 0) -> 0 < Rabs mu < mu1 ->
   orbit_near M J next n mu d x -> forall j, within 2 eps (x j)).
Proof.
  intros M a1 a2 gamma e w HP n_max; pose proof (is_plane _ _ _ _ _ _ HP) as HN.
  destruct (inverse M a1 a2 gamma e w HP n_max) as (K & HK).
  destruct (is_rate _ _ _ _ _ _ HP) as [He He0]; destruct (is_gamma _ _ _ _ _ _ HP) as [_ Hg0].
  destruct (Orbits.Theorem1_clear M w e (is_smooth _ _ _ _ _ _ HP)) with (n_max := n_max) (K := K) as (d & Hd & Hmain &
    Hlead); [rewrite HN; exact (is_w _ _ _ _ _ _ HP) | rewrite HN; exact He | exact He0|].
  destruct (margin (b a1 a2) (S n_max)) as (k1 & Hk1 & Hb).
  destruct (margin (fun i j => follows a1 a2 i j / gamma) (S n_max)) as (k2 & Hk2 & Hf).
  set (kappa := Rmin k1 k2); assert (Hkappa : 0 < kappa) by (apply Rmin_glb_lt; assumption).
  destruct (Hmain kappa Hkappa) as (mu0 & Hmu0 & H); clear Hmain.
  assert (Hsol : forall (J : Type) (next prev : J -> J) n, (forall j, prev (next j) = j /\ next (prev j) = j) -> (forall
    j, (1 <= n j <= n_max)%nat /\ u a1 a2 (n j) <> 0) -> exists X Y, bounded M J (K * 1) X Y /\ linear M J next n X Y
    (fun _ => zero) (fun _ => -1)).
  { intros J next prev n Hnext Hn; apply (proj1 (HK J next prev n Hnext Hn)).
    intros j; split; [apply within_zero; lra | rewrite Rabs_left; lra]. }
  exists d, mu0; split; [exact Hd | split; [exact Hmu0 | split]].
  - intros J next prev n s g mu Hnext Hn Hg Hmu. destruct (Hsol J next prev n Hnext Hn) as (X & Y & HXb & HXl).
    pose proof (solution_rows M a1 a2 gamma e w HP n_max J next prev n Hnext Hn X Y HXl) as Hrows.
    assert (HX : solution M J next n X Y) by (split; [exists (K * 1)|]; assumption).
    specialize (H J next n X Y s mu (fun j => proj1 (Hn j)) (HK J next prev n Hnext Hn) HX Hmu).
    rewrite HN in H; destruct H as [Hex Hno].
    assert (Hrow : forall j k, (1 <= k < n j)%nat -> dot 2 (Map.C M) (power M k (X j)) + 1 = b a1 a2 (n j) k).
    { intros j k Hk; unfold power; rewrite HN; apply Hrows; lia. }
    assert (HY : forall j, Y j = follows a1 a2 (n j) (n (next j)) / gamma) by (intros j; rewrite <- (proj2 (Hrows j));
      field; exact Hg0).
    assert (HYk : forall j, sgn s * Y j <> 0 -> kappa <= Rabs (Y j)).
    { intros j Hne; apply Rle_trans with k2; [apply Rmin_r|]; rewrite HY in *; apply Hf.
      - destruct (Hn j); lia.
      - destruct (Hn (next j)); lia.
      - intros E; rewrite E, sgn_zero in Hne; lra. }
    assert (Hbk : forall j k, (1 <= k < n j)%nat -> sgn s * b a1 a2 (n j) k <> 0 -> kappa <= Rabs (b a1 a2 (n j) k)).
    { intros j k Hk Hne; apply Rle_trans with k1; [apply Rmin_l|]; destruct (Hn j); apply Hb; try lia.
      intros E; rewrite E, sgn_zero in Hne; lra. }
    split.
    + intros Hall; apply Hex; intros j v Hv; destruct (Hall j) as [Hbpos Hfpos].
      unfold quantity in Hv; rewrite HN in Hv; destruct Hv as [->|(k & Hk & ->)].
      * rewrite <- (proj2 (Hrows j)) in Hfpos; apply sgn_gamma in Hfpos; [|exact Hg].
        apply sgn_above; [apply HYk; lra | exact Hfpos].
      * rewrite Hrow by exact Hk; specialize (Hbpos k ltac:(lia)).
        apply sgn_above; [apply Hbk; [exact Hk | lra] | exact Hbpos].
    + intros j Hneg; destruct Hneg as [(k & Hk & Hbneg)|Hfneg].
      * apply (Hno j (sgn s * b a1 a2 (n j) k)).
        -- right; exists k; split; [lia|]; rewrite HN, Hrow by lia; reflexivity.
        -- apply sgn_below; [apply Hbk; [lia | lra] | exact Hbneg].
      * apply (Hno j (sgn s * Y j)); [left; reflexivity|].
        rewrite <- (proj2 (Hrows j)) in Hfneg; apply sgn_gamma in Hfneg; [|exact Hg].
        apply sgn_below; [apply HYk; lra | exact Hfneg].
  - intros eps Heps; destruct (Hlead 1) as (mu1 & Hmu1 & Hx); [lra|]. destruct (within_exists 2 w) as (W & HW & Hw).
    assert (HeK : 0 <= Rabs e * Rabs (K * 1)) by (apply Rmult_le_pos; apply Rabs_pos).
    set (m := 1 + W + Rabs e * Rabs (K * 1)); assert (Hm : 1 <= m) by (unfold m; lra).
    exists (Rmin mu1 (eps / m)); split; [apply Rmin_glb_lt; [|apply Rdiv_lt_0_compat]; lra|].
    intros J next prev n mu x Hnext Hn Hmu Horb j i Hi. destruct (Hsol J next prev n Hnext Hn) as (X & Y & HXb & HXl).
    destruct (Hx J next n X Y mu x (fun j => proj1 (Hn j)) (HK J next prev n Hnext Hn)) with (j := j) as [Hxj _];
      trivial.
    { split; [exists (K * 1)|]; assumption. }
    { split; [apply Hmu | eapply Rlt_le_trans; [apply Hmu | apply Rmin_l]]. }
    rewrite HN in Hxj; specialize (Hxj i Hi); specialize (Hw i Hi).
    destruct (HXb j) as [HXj _]; rewrite HN in HXj; specialize (HXj i Hi). pose proof (Rle_abs (K * 1)) as HKa.
    replace (x j i) with ((x j i - mu * w i - e * mu * X j i) + w i * mu + e * X j i * mu) by ring.
    apply Rle_trans with (1 * Rabs mu + W * Rabs mu + Rabs e * Rabs (K * 1) * Rabs mu).
    + apply triangle3; [exact Hxj | apply Rabs_mult_le; lra|]. apply Rabs_mult_le; [apply Rabs_mult_le|]; lra.
    + replace (1 * Rabs mu + W * Rabs mu + Rabs e * Rabs (K * 1) * Rabs mu) with (m * Rabs mu) by (unfold m; ring).
      replace eps with (m * (eps / m)) by (field; lra); apply Rmult_le_compat_l; [lra|].
      left; eapply Rlt_le_trans; [apply Hmu | apply Rmin_r].
Qed.

(** (I1) *)
Lemma follows_itself a1 a2 n : (1 <= n)%nat -> u a1 a2 n <> 0 -> follows a1 a2 n n = c a1 a2 n.
Proof.
  intros Hn Hu; unfold follows, c; destruct n as [|m]; [lia|].
  rewrite v_neighbours; cbn [Nat.sub]; rewrite Nat.sub_0_r; field; exact Hu.
Qed.

(** What is born is unstable: C A^n B is gamma u_n. *)
Theorem plane_leave M a1 a2 gamma e w : planar M a1 a2 gamma e w -> forall n_max, exists d, d > 0 /\
  forall J next n mu x c, (forall j : J, (1 <= n j <= n_max)%nat /\ u a1 a2 (n j) <> 0) -> Rabs mu <= d ->
  orbit_near M J next n mu d x -> 0 < c -> (forall j, clear_at M mu (n j) (x j) c) ->
  (forall j, unstable M mu (x j)) /\ leaving M J next n mu x.
Proof.
  intros HP n_max; destruct (margin (fun n _ => u a1 a2 n * gamma) (S n_max)) as (k & Hk & Mk).
  pose proof (is_plane _ _ _ _ _ _ HP) as E; destruct (is_gamma _ _ _ _ _ _ HP) as [Eg Ng].
  destruct (orbits_leave M w (is_smooth _ _ _ _ _ _ HP)) with (n_max := n_max) (kappa := k) as (d & Hd & H); [rewrite E;
    apply HP | exact Hk|]; exists d; split; [exact Hd|]; intros J next n mu x c Hn; apply H; intros j; destruct (Hn j)
    as [N0 N1]; split; [exact N0|]; unfold crossing, power; rewrite E.
  pose proof (row_u M a1 a2 gamma e w HP (n j) (Map.B M)) as R; unfold row in R; rewrite R; change (Nat.iter 0 (mult 2
    (Map.A M)) (Map.B M)) with (Map.B M); change (Nat.iter 1 (mult 2 (Map.A M)) (Map.B M)) with (mult 2 (Map.A M) (Map.B
    M)).
  rewrite (is_CB _ _ _ _ _ _ HP), <- Eg, Rmult_0_r, Rplus_0_r; apply Rle_ge, (Mk (n j) 0%nat); try lia.
  apply Rmult_integral_contrapositive; auto.
Qed.
