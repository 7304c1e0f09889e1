(** * Proof of Theorem 1 for one impact and the affine grazing map in the plane

    The points of an orbit lie on a line, which leaves one quadratic equation for the
    impact velocity y. *)

From Coq Require Import Reals Arith Lra Lia.
From Grazing Require Import Defs StatementAffine Algebra Finite FreeFlight.
Open Scope R_scope.

Section Orbit.
Variables (a1 a2 beta eps : R) (n : nat).
Notation F := (affine_map a1 a2 beta eps).
Notation fly k := (Nat.iter k (flight a1 a2)).
Notation h := (clearance eps).
Notation X2 := ((u a1 a2 (S n) - 1) / u a1 a2 n).

(** (56) *)
Lemma fly_u k x : fly k x = (u a1 a2 (S k) * fst x + u a1 a2 k * snd x,
  - a2 * u a1 a2 k * fst x + (u a1 a2 (S k) - a1 * u a1 a2 k) * snd x).
Proof.
  induction k as [|k IH].
  - rewrite u_1, u_0; destruct x; cbn; f_equal; ring.
  - change (fly (S k) x) with (flight a1 a2 (fly k x)); rewrite IH, !u_SS.
    unfold flight; cbn [fst snd]; f_equal; ring.
Qed.

Lemma map_free x : 0 < h (flight a1 a2 x) -> F x = flight a1 a2 x.
Proof. intros H; unfold affine_map; destruct Rle_dec; [reflexivity | lra]. Qed.

Lemma map_impact x : h (flight a1 a2 x) < 0 ->
  F x = (fst (flight a1 a2 x), snd (flight a1 a2 x) + beta * sqrt (- h (flight a1 a2 x))).
Proof. intros H; unfold affine_map; destruct Rle_dec; [lra | reflexivity]. Qed.

Lemma iterates_free x m :
  (forall k, (k < m)%nat -> 0 < h (fly (S k) x)) -> Nat.iter m F x = fly m x.
Proof. apply (FreeFlight.iterates_free _ F (flight a1 a2) (fun z => 0 < h z)), map_free. Qed.

Lemma iterates_free' x m :
  (forall k, (k < m)%nat -> 0 < h (flight a1 a2 (Nat.iter k F x))) -> Nat.iter m F x = fly m x.
Proof. apply (FreeFlight.iterates_free' _ F (flight a1 a2) (fun z => 0 < h z)), map_free. Qed.

(** An orbit in terms of the flight alone. *)
Lemma orbit_flight x : (1 <= n)%nat -> single_impact_orbit a1 a2 beta eps n x <->
  (forall k, (1 <= k <= n - 1)%nat -> 0 < h (fly k x)) /\ h (fly n x) < 0 /\
  x = (fst (fly n x), snd (fly n x) + beta * sqrt (- h (fly n x))).
Proof.
  destruct n as [|m]; [lia|]; intros _; cbn [Nat.sub]; rewrite Nat.sub_0_r.
  unfold single_impact_orbit; cbv zeta.
  change (Nat.iter (S m) F x) with (F (Nat.iter m F x)).
  change (fly (S m) x) with (flight a1 a2 (fly m x)).
  split.
  - intros (Hx & Hfree & Hhit); specialize (Hhit m eq_refl).
    assert (E : forall k, (k <= m)%nat -> Nat.iter k F x = fly k x)
      by (intros k Hk; apply iterates_free'; intros i Hi; apply Hfree; lia).
    rewrite (E m) in * by lia; rewrite map_impact in Hx by assumption.
    split; [| split; [assumption | symmetry; exact Hx]].
    intros [|k] Hk; [lia|]; change (0 < h (flight a1 a2 (fly k x))).
    rewrite <- E by lia; apply Hfree; lia.
  - intros (Hfree & Hhit & Hx).
    assert (E : forall k, (k <= m)%nat -> Nat.iter k F x = fly k x)
      by (intros k Hk; apply iterates_free; intros i Hi; apply Hfree; lia).
    rewrite (E m), map_impact by (lia || assumption); split; [symmetry; exact Hx | split].
    + intros k Hk; rewrite E by lia; apply (Hfree (S k)); lia.
    + intros k Hk; injection Hk as ->; rewrite E by lia; exact Hhit.
Qed.

Hypothesis Hn : (1 <= n)%nat.
Hypothesis Hu : u a1 a2 n <> 0.

(** From t (-1, X2) the flight returns to its first coordinate after n steps. *)
Lemma line_1 t k : fst (fly k (- t, t * X2)) = t * orbit_x a1 a2 n k.
Proof. rewrite fly_u; unfold orbit_x; cbn [fst snd]; ring. Qed.

Lemma line_2 t : t * X2 - snd (fly n (- t, t * X2)) = t * c a1 a2 n.
Proof.
  rewrite fly_u; cbn [fst snd]; unfold c, v; rewrite <- (u_Cassini a1 a2 n).
  field; assumption.
Qed.

(** All orbits, by their y. *)
Lemma orbit_y x : single_impact_orbit a1 a2 beta eps n x <-> exists y, 0 < y /\
  c a1 a2 n * (eps + y ^ 2) = beta * y /\ x = (- (eps + y ^ 2), (eps + y ^ 2) * X2) /\
  forall k, (1 <= k <= n - 1)%nat -> 0 < eps * b a1 a2 n k + y ^ 2 * (b a1 a2 n k - 1).
Proof.
  assert (Hb : forall t k, (k <= n)%nat -> fst (fly k (- t, t * X2)) = t * (b a1 a2 n k - 1))
    by (intros; rewrite line_1, b_is_1_plus_x by assumption; ring).
  rewrite orbit_flight by assumption; unfold clearance; split.
  - intros (Hfree & Hhit & Hx); set (y := sqrt (- (eps + fst (fly n x)))) in *.
    assert (Hy : 0 < y) by (apply sqrt_lt_R0; lra).
    assert (Ey : y * y = - (eps + fst (fly n x))) by (apply sqrt_sqrt; lra).
    assert (E1 : fst x = fst (fly n x)) by (rewrite Hx at 1; reflexivity).
    assert (E2 : snd x = snd (fly n x) + beta * y) by (rewrite Hx at 1; reflexivity).
    set (t := eps + y ^ 2); assert (Et : fst x = - t) by (unfold t; cbn; lra).
    assert (Em : x = (- t, t * X2)).
    { rewrite <- Et; rewrite fly_u in E1; cbn [fst] in E1.
      replace (t * X2) with (snd x); [destruct x; reflexivity|].
      apply (Rmult_eq_reg_l (u a1 a2 n)); [|assumption].
      replace (u a1 a2 n * (t * X2)) with (t * (u a1 a2 (S n) - 1)) by (field; assumption).
      replace t with (- fst x) by lra; lra. }
    exists y; split; [assumption|]; rewrite Em in E2, Hfree; cbn [snd] in E2.
    split; [pose proof (line_2 t); unfold t in *; lra | split; [exact Em|]].
    intros k Hk; specialize (Hfree k Hk); rewrite Hb in Hfree by lia; unfold t in Hfree; lra.
  - intros (y & Hy & Ec & -> & Hk); set (t := eps + y ^ 2) in *.
    assert (E1 : fst (fly n (- t, t * X2)) = - t) by (rewrite line_1, x_n by assumption; ring).
    assert (Et : - (eps + - t) = y * y) by (unfold t; ring).
    rewrite E1, Et, sqrt_square by lra; split; [|split].
    + intros k Hk'; rewrite Hb by lia; specialize (Hk k Hk'); unfold t; lra.
    + assert (0 < y * y) by (apply Rmult_lt_0_compat; assumption); lra.
    + pose proof (line_2 t); f_equal; lra.
Qed.
End Orbit.

Lemma pow2_pos x : x <> 0 -> 0 < x ^ 2.
Proof. intros H; rewrite <- Rsqr_pow2; apply Rsqr_pos_lt, H. Qed.

(** ** The quadratic y^2 = kappa y - eps for small eps *)

Lemma small_root kappa eps : 0 < kappa * eps -> 8 * Rabs eps < kappa ^ 2 ->
  exists y, 0 < y /\ y ^ 2 = kappa * y - eps /\ Rabs kappa * y <= 2 * Rabs eps.
Proof.
  intros Hs Hsmall; assert (Hk : kappa <> 0) by (intros ->; lra).
  assert (Hk2 : 0 < kappa ^ 2) by (apply pow2_pos, Hk).
  assert (Hm : 0 < eps / kappa).
  { replace (eps / kappa) with (kappa * eps * / kappa ^ 2) by (field; assumption).
    apply Rmult_lt_0_compat; [assumption | apply Rinv_0_lt_compat; assumption]. }
  set (q := sqrt (1 - 4 * (eps / kappa ^ 2))).
  assert (Hq : 0 <= q) by apply sqrt_pos.
  assert (Eq : q * q = 1 - 4 * (eps / kappa ^ 2)).
  { apply sqrt_sqrt; apply Rmult_le_reg_l with (kappa ^ 2); [assumption|].
    replace (kappa ^ 2 * (1 - 4 * (eps / kappa ^ 2))) with (kappa ^ 2 - 4 * eps)
      by (field; assumption); pose proof (Rle_abs eps); lra. }
  exists (2 * (eps / kappa) / (1 + q)); split; [|split].
  - apply Rdiv_lt_0_compat; lra.
  - replace (2 * (eps / kappa) / (1 + q)) with (kappa * (1 - q) / 2).
    + replace eps with (kappa ^ 2 * (1 - q * q) / 4) by (rewrite Eq; field; assumption); field.
    + apply (Rmult_eq_reg_l (1 + q)); [|lra].
      replace ((1 + q) * (kappa * (1 - q) / 2)) with (kappa * (1 - q * q) / 2) by field.
      rewrite Eq; field; repeat split; (assumption || lra).
  - rewrite <- (Rabs_pos_eq (2 * (eps / kappa) / (1 + q))) by (left; apply Rdiv_lt_0_compat; lra).
    rewrite <- Rabs_mult; replace (kappa * (2 * (eps / kappa) / (1 + q))) with (2 * eps * / (1 + q))
      by (field; repeat split; (assumption || lra)).
    rewrite !Rabs_mult, (Rabs_pos_eq 2), (Rabs_pos_eq (/ (1 + q))) by
      (try (left; apply Rinv_0_lt_compat); lra).
    rewrite <- (Rmult_1_r (2 * Rabs eps)) at 2; apply Rmult_le_compat_l;
      [pose proof (Rabs_pos eps); lra|].
    rewrite <- Rinv_1; apply Rinv_le_contravar; lra.
Qed.

Lemma one_small_root kappa eps y y' : Rabs kappa * y <= 2 * Rabs eps -> 8 * Rabs eps < kappa ^ 2 ->
  0 < y -> 0 < y' < Rabs kappa / 2 ->
  y ^ 2 = kappa * y - eps -> y' ^ 2 = kappa * y' - eps -> y' = y.
Proof.
  intros Hle Hsmall Hy Hy' E E'; rewrite <- (pow2_abs kappa) in Hsmall.
  assert (y < Rabs kappa / 4).
  { apply (Rmult_lt_reg_l (Rabs kappa)); lra. }
  assert (P : (y' - y) * (y' + y - kappa) = 0) by lra.
  apply Rmult_integral in P; destruct P; [lra | exfalso].
  unfold Rabs in *; destruct Rcase_abs; lra.
Qed.

(** With the wrong sign of kappa there is none. *)
Lemma no_small_root kappa eps y : kappa * eps < 0 -> 0 < y < Rabs kappa / 2 ->
  y ^ 2 <> kappa * y - eps.
Proof.
  intros Hs Hy E; assert (0 < y ^ 2) by (apply pow_lt; lra).
  unfold Rabs in Hy; destruct Rcase_abs.
  - assert (0 < - kappa * y) by (apply Rmult_lt_0_compat; lra).
    assert (0 < eps) by nra; lra.
  - assert (0 < y * (kappa - y)) by (apply Rmult_lt_0_compat; lra).
    assert (eps < 0) by nra; lra.
Qed.

(** ** For small eps the signs of eps b + y^2 (b - 1) are those of eps b *)

Lemma small_correction kappa x : kappa <> 0 -> x <> 0 -> exists d, 0 < d /\
  forall eps y, 0 < Rabs eps < d -> 0 < y -> Rabs kappa * y <= 2 * Rabs eps ->
  Rabs (y ^ 2 * (x - 1)) < Rabs (eps * x).
Proof.
  intros Hk Hx; apply Rabs_pos_lt in Hk; apply Rabs_pos_lt in Hx.
  set (K := Rabs kappa) in *; pose proof (Rabs_pos (x - 1)) as Hq; set (q := Rabs (x - 1)) in *.
  exists (K ^ 2 * Rabs x / (4 * (q + 1))); split.
  - apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [apply pow_lt|] |]; lra.
  - intros eps y He Hy Hle; rewrite !Rabs_mult, (Rabs_pos_eq (y ^ 2)) by (apply pow_le; lra).
    fold q; destruct He as [He Hlt]; set (E := Rabs eps) in *.
    assert (H4 : 4 * (q + 1) * E < K ^ 2 * Rabs x).
    { apply (Rmult_lt_compat_l (4 * (q + 1))) in Hlt; [|lra].
      replace (4 * (q + 1) * (K ^ 2 * Rabs x / (4 * (q + 1)))) with (K ^ 2 * Rabs x) in Hlt
        by (field; lra); exact Hlt. }
    assert (Hy2 : K ^ 2 * y ^ 2 <= 4 * E * E).
    { replace (K ^ 2 * y ^ 2) with ((K * y) * (K * y)) by ring.
      replace (4 * E * E) with ((2 * E) * (2 * E)) by ring.
      assert (0 < K * y) by (apply Rmult_lt_0_compat; assumption).
      apply Rmult_le_compat; lra. }
    apply (Rmult_lt_reg_l (K ^ 2)); [apply pow_lt; assumption|].
    apply (Rmult_le_compat_r q) in Hy2; [|assumption].
    apply (Rmult_lt_compat_l E) in H4; [|assumption].
    assert (0 < E * E) by (apply Rmult_lt_0_compat; assumption); lra.
Qed.

Lemma same_sign x q : Rabs q < Rabs x -> 0 < x <-> 0 < x + q.
Proof. unfold Rabs; do 2 destruct Rcase_abs; lra. Qed.

Lemma Rabs_sgn e x : 0 < sgn e * x -> Rabs x = sgn e * x.
Proof. destruct e; cbn [sgn]; intros; [rewrite Rabs_pos_eq | rewrite Rabs_left]; lra. Qed.

Lemma sgn_iff e x y : 0 < sgn e * x -> (0 < sgn e * y <-> 0 < x * y).
Proof. destruct e; cbn [sgn]; intros; split; nra. Qed.

Lemma sgn_negative e x y : 0 < sgn e * x -> sgn e * y < 0 -> y * x < 0.
Proof. destruct e; cbn [sgn]; intros; nra. Qed.

Theorem Theorem1_affine : Theorem1_statement_affine.
Proof.
  intros a1 a2 beta n e g Hn Hu Hg.
  destruct (Req_dec (c a1 a2 n) 0) as [Hc0|Hc0].
  { exists 1, 1, 0; split; [lra|]; split; [lra|]; intros eps Heps; split.
    - intros (_ & _ & Hc); rewrite Hc0 in Hc; lra.
    - intros _ x Hx; apply orbit_y in Hx; try assumption; destruct Hx as (y & Hy & Ec & _).
      rewrite Hc0 in Ec; destruct g; cbn [sgn] in Hg; nra. }
  set (kappa := beta / c a1 a2 n).
  assert (Hbeta : beta = c a1 a2 n * kappa) by (unfold kappa; field; assumption).
  assert (Hkappa : kappa <> 0) by (intros E; rewrite E in Hbeta; subst beta; lra).
  assert (Hk2 : 0 < kappa ^ 2) by (apply pow2_pos, Hkappa).
  assert (Hsign : 0 < sgn e * sgn g * c a1 a2 n <-> 0 < sgn e * kappa).
  { rewrite Hbeta in Hg; destruct e, g; cbn [sgn] in *; split; nra. }
  destruct (common_bound (fun k d => b a1 a2 n k <> 0 ->
    forall eps y, 0 < Rabs eps < d -> 0 < y -> Rabs kappa * y <= 2 * Rabs eps ->
    Rabs (y ^ 2 * (b a1 a2 n k - 1)) < Rabs (eps * b a1 a2 n k)) n) as (d1 & Hd1 & Hcorr).
  { intros k d d' H Hd Hb eps y He; apply H; [assumption | lra]. }
  { intros k _; destruct (Req_dec (b a1 a2 n k) 0) as [E|Hb].
    - exists 1; split; [lra | intros Hb; contradiction].
    - destruct (small_correction kappa _ Hkappa Hb) as (d & Hd & H); exists d; auto. }
  set (X2 := (u a1 a2 (S n) - 1) / u a1 a2 n); set (M := 2 * (Rabs X2 + 1)).
  assert (HM : 2 <= M /\ 2 * Rabs X2 <= M) by (unfold M; pose proof (Rabs_pos X2); lra).
  set (d := Rmin d1 (kappa ^ 2 / 16)).
  assert (Hd : 0 < d /\ d <= d1 /\ d <= kappa ^ 2 / 16).
  { unfold d; split; [apply Rmin_glb_lt; lra | split; [apply Rmin_l | apply Rmin_r]]. }
  assert (HdM : 0 < d / M) by (apply Rdiv_lt_0_compat; lra).
  exists d, (d / M), M; split; [lra | split; [lra|]]; intros eps Heps.
  assert (HE : Rabs eps = sgn e * eps) by (apply Rabs_sgn; lra).
  assert (HMe : M * Rabs eps < d).
  { apply (Rmult_lt_reg_r (/ M)); [apply Rinv_0_lt_compat; lra|].
    replace (M * Rabs eps * / M) with (Rabs eps) by (field; lra); rewrite HE; apply Heps. }
  assert (H2e : 2 * Rabs eps <= M * Rabs eps) by (apply Rmult_le_compat_r; [apply Rabs_pos | lra]).
  assert (He0 : 0 < Rabs eps) by lra.
  assert (Hsmall : 8 * Rabs eps < kappa ^ 2) by lra.
  assert (Hsmall' : 4 * Rabs eps <= kappa ^ 2) by lra.
  assert (Hquad : forall y, c a1 a2 n * (eps + y ^ 2) = beta * y <-> y ^ 2 = kappa * y - eps).
  { intros y; rewrite Hbeta; split; intros H; [apply (Rmult_eq_reg_l (c a1 a2 n)); lra|].
    rewrite H; ring. }
  assert (Hreach : forall y, 0 < y -> Rabs (- (eps + y ^ 2)) < d -> 0 < y < Rabs kappa / 2).
  { intros y Hy H; split; [assumption|]; apply Rnot_le_lt; intros Hle.
    assert (kappa ^ 2 / 4 <= y ^ 2) 
      by (rewrite <- (pow2_abs kappa); replace (Rabs kappa ^ 2 / 4) with ((Rabs kappa / 2) ^ 2) by field;
          apply pow_incr; pose proof (Rabs_pos kappa); lra).
    apply Rabs_def2 in H; pose proof (Rle_abs (- eps)) as Ha; rewrite Rabs_Ropp in Ha; lra. }
  assert (Hcase : sgn e * sgn g * c a1 a2 n <> 0)
    by (destruct e, g; cbn [sgn]; lra).
  assert (Hdich : 0 < sgn e * kappa -> exists y, 0 < y /\ y ^ 2 = kappa * y - eps /\
    Rabs kappa * y <= 2 * Rabs eps /\
    forall y', 0 < y' < Rabs kappa / 2 -> y' ^ 2 = kappa * y' - eps -> y' = y).
  { intros Hk; destruct (small_root kappa eps) as (y & Hy & Ey & Hle);
      [rewrite Rmult_comm; apply (sgn_iff e); [apply Heps | assumption] | assumption|].
    exists y; repeat split; try assumption; intros y' Hy' Ey'.
    apply (one_small_root kappa eps); assumption. }
  assert (Hb : forall k y, (1 <= k <= n - 1)%nat -> b a1 a2 n k <> 0 -> 0 < y ->
    Rabs kappa * y <= 2 * Rabs eps ->
    0 < sgn e * b a1 a2 n k <-> 0 < eps * b a1 a2 n k + y ^ 2 * (b a1 a2 n k - 1)).
  { intros k y Hk Hbk Hy Hle; rewrite <- same_sign; [apply sgn_iff, Heps|].
    apply (Hcorr k); try assumption; [lia | lra]. }
  split.
  - intros (_ & Hall & Hc); apply Hsign in Hc; destruct (Hdich Hc) as (y & Hy & Ey & Hle & Huniq).
    assert (Hy2 : 0 < y ^ 2 <= Rabs eps).
    { split; [apply pow_lt; assumption|]; apply (Rmult_le_reg_l (kappa ^ 2)); [assumption|].
      assert (P : (Rabs kappa * y) ^ 2 <= (2 * Rabs eps) ^ 2)
        by (apply pow_incr; split; [apply Rmult_le_pos; [apply Rabs_pos | lra] | assumption]).
      rewrite Rpow_mult_distr, pow2_abs in P.
      apply (Rmult_le_compat_r (Rabs eps)) in Hsmall'; lra. }
    assert (Ht : Rabs (eps + y ^ 2) <= 2 * Rabs eps).
    { eapply Rle_trans; [apply Rabs_triang|]; rewrite (Rabs_pos_eq (y ^ 2)); lra. }
    exists (- (eps + y ^ 2), (eps + y ^ 2) * X2); cbn [fst snd]; split; [|split; [|split]].
    + apply orbit_y; try assumption; exists y; split; [assumption|].
      split; [apply Hquad; assumption | split; [reflexivity|]].
      intros k Hk; specialize (Hall k Hk); apply Hb; try assumption.
      intros E; rewrite E in Hall; lra.
    + rewrite Rabs_Ropp; split; [lra | assumption].
    + rewrite Rabs_mult; pose proof (Rabs_pos eps); pose proof (Rabs_pos X2).
      apply Rle_trans with (2 * Rabs eps * Rabs X2); [apply Rmult_le_compat_r; assumption|].
      rewrite (Rmult_comm 2), Rmult_assoc, (Rmult_comm M); apply Rmult_le_compat_l; lra.
    + intros x' Hx' Hd'; apply orbit_y in Hx'; try assumption.
      destruct Hx' as (y' & Hy' & Ec & -> & _); cbn [fst] in Hd'.
      rewrite (Huniq y'); [reflexivity | apply Hreach; assumption | apply Hquad; assumption].
  - intros Hf x Hx; apply Rnot_lt_le; intros Hxd; apply orbit_y in Hx; try assumption.
    destruct Hx as (y & Hy & Ec & -> & Hall); cbn [fst] in Hxd.
    apply Hquad in Ec; pose proof (Hreach y Hy Hxd) as Hy'.
    destruct (Rle_lt_dec (sgn e * kappa) 0) as [Hk|Hk].
    { revert Ec; apply no_small_root; [|assumption].
      apply Rnot_le_lt; intros Hpos; destruct (Rle_lt_or_eq_dec _ _ Hk) as [Hneg|H0].
      - pose proof (sgn_negative e eps kappa (proj1 Heps) Hneg); lra.
      - apply Hkappa; destruct e; cbn [sgn] in H0; lra. }
    apply Hsign in Hk as Hc; destruct Hf as [(k & Hk1 & Hbk)|Hc']; [|lra].
    destruct (Hdich Hk) as (y0 & Hy0 & _ & Hle & Huniq).
    rewrite <- (Huniq y Hy' Ec) in Hle.
    specialize (Hall k Hk1); apply Hb in Hall; try assumption; [lra|].
    intros E; rewrite E in Hbk; lra.
Qed.
