(** * Proof that the oscillator's map, to second order, meets the hypotheses of Theorem 1 *)

From Coq Require Import Reals Arith Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane StatementOrbitsInstance
  OrbitVectors OrbitRemainder.
Open Scope R_scope.

(** A linear function, and one with a square. *)
Lemma strict_quadratic N (c : vec) p k i : (i < N)%nat ->
  strict N (fun x mu => dot N c x + mu * p - k * (x i * x i)) (dot N c) p.
Proof.
  intros Hi; split; [rewrite dot_zero; unfold zero; ring|]; intros eps Heps. pose proof (Rabs_pos k) as Hk.
  exists (eps / (2 * (Rabs k + 1))); split; [apply Rdiv_lt_0_compat; lra|].
  set (d := eps / (2 * (Rabs k + 1))); intros x x' mu mu' t Hx Hx' _ _ Ht Hmt.
  pose proof (Rabs_nonneg _ _ Hmt) as Ht0; rewrite dot_minus.
  replace (dot N c x + mu * p - k * (x i * x i) - (dot N c x' + mu' * p - k * (x' i * x' i)) - (dot N c x - dot N c x')
    - (mu - mu') * p) with (- (k * ((x i - x' i) * (x i + x' i)))) by ring.
  rewrite Rabs_Ropp; apply Rle_trans with (Rabs k * (t * (d + d))).
  - apply Rabs_mult_le; [lra|]; apply Rabs_mult_le; [apply (Ht i Hi) | apply triangle2; [apply Hx | apply Hx'];
      exact Hi].
  - replace (Rabs k * (t * (d + d))) with (Rabs k / (Rabs k + 1) * (eps * t)) by (unfold d; field; lra).
    rewrite <- (Rmult_1_l (eps * t)) at 2; apply Rmult_le_compat_r; [apply Rmult_le_pos; lra|].
    apply (Rmult_le_reg_r (Rabs k + 1)); [lra|].
    replace (Rabs k / (Rabs k + 1) * (Rabs k + 1)) with (Rabs k) by (field; lra); lra.
Qed.

Lemma strict_same N F G L p : (forall x mu, F x mu = G x mu) -> strict N F L p -> strict N G L p.
Proof.
  intros E [H0 H]; split; [rewrite <- E; exact H0|]; intros eps Heps.
  destruct (H eps Heps) as (d & Hd & Hs); exists d; split; [exact Hd|]. intros x x' mu mu' t; rewrite <- !E; apply Hs.
Qed.

(** A kick that is B at 0 and Lipschitz is smooth enough. *)
Lemma kick_from_Lipschitz M : (forall i, (i < Map.N M)%nat -> Map.kick M zero 0 0 i = Map.B M i) ->
  (exists l d, 0 < d /\ forall x x' y y' mu mu' t, within (Map.N M) d x -> within (Map.N M) d x' ->
   0 <= y <= d -> 0 <= y' <= d -> Rabs mu <= d -> Rabs mu' <= d -> within (Map.N M) t (minus x x') ->
   Rabs (y - y') <= t -> Rabs (mu - mu') <= t ->
   within (Map.N M) (l * t) (minus (Map.kick M x y mu) (Map.kick M x' y' mu'))) ->
  forall eps, 0 < eps -> exists d, 0 < d /\ forall x x' y y' mu mu' t i, (i < Map.N M)%nat -> within (Map.N M) d x ->
  within (Map.N M) d x' -> 0 <= y <= d -> 0 <= y' <= d -> Rabs mu <= d -> Rabs mu' <= d ->
  within (Map.N M) t (minus x x') -> Rabs (y - y') <= t -> Rabs (mu - mu') <= t ->
  Rabs (Map.kick M x y mu i * y - Map.kick M x' y' mu' i * y' - (y - y') * Map.B M i) <= eps * t.
Proof.
  intros HB (l & d0 & Hd0 & H) eps He; pose proof (Rabs_pos l) as Hl; set (q := eps / (2 * (Rabs l + 1))).
  assert (Hq : 0 < q) by (apply Rdiv_lt_0_compat; lra); exists (Rmin d0 q); split; [apply Rmin_glb_lt; assumption|].
  pose proof (Rmin_l d0 q); pose proof (Rmin_r d0 q); set (d := Rmin d0 q) in *.
  intros x x' y y' mu mu' t i Hi Hx Hx' Hy Hy' Hm Hm' Hxt Hyt Hmt; pose proof (Rabs_nonneg _ _ Hmt) as Ht.
  assert (Hd : 0 <= d) by lra; assert (W : forall x, within (Map.N M) d x -> within (Map.N M) d0 x)
    by (intros z Hz; apply (within_le _ d); [lra | exact Hz]).
  assert (A : Rabs (Map.kick M x y mu i - Map.B M i) <= Rabs l * d).
  { rewrite <- HB by exact Hi; apply Rle_trans with (l * d); [|apply Rmult_le_compat_r; [lra | apply Rle_abs]].
    apply (H x zero y 0 mu 0 d); trivial; rewrite ?Rminus_0_r, ?Rabs_R0; try lra; auto.
    - apply within_zero; lra.
    - intros j Hj; unfold minus, zero; rewrite Rminus_0_r; apply Hx, Hj.
    - rewrite Rabs_pos_eq; lra. }
  assert (A' : Rabs (Map.kick M x y mu i - Map.kick M x' y' mu' i) <= Rabs l * t).
  { apply Rle_trans with (l * t); [|apply Rmult_le_compat_r; [lra | apply Rle_abs]]; apply (H x x' y y' mu mu' t);
      trivial; auto; lra. }
  replace (_ - _ - _)
    with ((Map.kick M x y mu i - Map.B M i) * (y - y') + (Map.kick M x y mu i - Map.kick M x' y' mu' i) * y') by ring.
  apply Rle_trans with (Rabs l * d * t + Rabs l * t * d).
  - apply triangle2; apply Rabs_mult_le; trivial; rewrite Rabs_pos_eq; lra.
  - assert (E : 2 * ((Rabs l + 1) * q) = eps) by (unfold q; field; lra).
    assert (Rabs l * d <= (Rabs l + 1) * q) by (apply Rmult_le_compat; lra).
    replace (Rabs l * d * t + Rabs l * t * d) with (2 * (Rabs l * d) * t) by ring; apply Rmult_le_compat_r; lra.
Qed.

Theorem Instance : Instance_statement.
Proof.
  intros A00 A01 A10 A11 phi0 phi1 eta beta k0 k1 k2 k3 k4 k5 w0 w1 Hw0 Hw1 He Hg; constructor; cbn.
  - split; [|split; [|apply kick_from_Lipschitz]]; cbn.
    + intros [|[|i]] Hi; [| |lia]; cbn.
      * apply (strict_same _ (fun x mu => dot 2 (pair_vec A00 A01) x + mu * phi0 - 0 * (x 0%nat * x 0%nat)));
          [intros; cbn; ring | apply strict_quadratic; lia].
      * apply (strict_same _ (fun x mu => dot 2 (pair_vec A10 A11) x + mu * phi1 - 0 * (x 0%nat * x 0%nat)));
          [intros; cbn; ring | apply strict_quadratic; lia].
    + apply (strict_same _ (fun x mu => dot 2 (pair_vec 1 0) x + mu * eta - k0 * (x 1%nat * x 1%nat)));
        [intros; cbn; ring | apply strict_quadratic; lia].
    + intros [|[|i]] Hi; [| |lia]; cbn; unfold zero; ring.
    + exists (Rabs k1 + Rabs k2 + (Rabs k3 + Rabs k4 + Rabs k5)), 1; split; [lra|].
      intros x x' y y' mu mu' t _ _ _ _ _ _ Hx Hy Hmu; pose proof (Rabs_nonneg _ _ Hmu) as Ht.
      specialize (Hx 1%nat ltac:(lia)); unfold minus in Hx.
      assert (H1 : Rabs (k1 * (y - y')) <= Rabs k1 * t) by (apply Rabs_mult_le; lra).
      assert (H2 : Rabs (k2 * (x 1%nat - x' 1%nat)) <= Rabs k2 * t) by (apply Rabs_mult_le; lra).
      assert (H3 : Rabs (k3 * (y - y')) <= Rabs k3 * t) by (apply Rabs_mult_le; lra).
      assert (H4 : Rabs (k4 * (x 1%nat - x' 1%nat)) <= Rabs k4 * t) by (apply Rabs_mult_le; lra).
      assert (H5 : Rabs (k5 * (mu - mu')) <= Rabs k5 * t) by (apply Rabs_mult_le; lra).
      pose proof (Rabs_nonneg _ _ H1); pose proof (Rabs_nonneg _ _ H2); pose proof (Rabs_nonneg _ _ H3);
        pose proof (Rabs_nonneg _ _ H4); pose proof (Rabs_nonneg _ _ H5).
      intros [|[|i]] Hi; [| |lia]; unfold minus; cbn.
      * replace (k1 * y + k2 * x 1%nat - (k1 * y' + k2 * x' 1%nat)) with (k1 * (y - y') + k2 * (x 1%nat - x' 1%nat))
          by ring.
        eapply Rle_trans; [apply triangle2; eassumption | lra].
      * replace (beta + k3 * y + k4 * x 1%nat + k5 * mu - (beta + k3 * y' + k4 * x' 1%nat + k5 * mu'))
          with (k3 * (y - y') + k4 * (x 1%nat - x' 1%nat) + k5 * (mu - mu')) by ring.
        eapply Rle_trans; [apply triangle3; eassumption | lra].
  - reflexivity.
  - reflexivity.
  - reflexivity.
  - ring.
  - split; [unfold mult; cbn; ring | exact Hg].
  - intros [|[|i]] Hi; [| |lia]; unfold mult; cbn; [rewrite Hw0 at 1 | rewrite Hw1 at 1]; ring.
  - split; [ring | exact He].
Qed.
