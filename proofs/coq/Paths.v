(** * Every path is exactly one motion: legs that contract, as the checks say, follow each other *)

From Coq Require Import Reals QArith Qreals ZArith Lra Lia Bool List.
From Grazing Require Import StatementOscillator PathsCheck PathsFlow PathsLegs PathsGaps StatementPaths
  Contraction.
Open Scope R_scope.

Lemma sum_bounds tau a p a' p' b q : 0 < tau -> a <= b <= a' -> p <= q <= p' ->
  sum_of tau a p <= sum_of tau b q <= sum_of tau a' p'.
Proof.
  intros Ht Ha Hp; assert (P : 0 < / (1 + tau)) by (apply Rinv_0_lt_compat; lra); unfold sum_of.
  split; apply Rmult_le_compat_r; nra.
Qed.

(** A path of letters, with what is known of each place in it. *)
Record chain (M : Machine.t) (w kappa spread : R) (l : Z -> Letter.t) : Prop := {
  chain_good : good M w; chain_w : w <= PI; chain_tau : 0 < Machine.tau M; chain_kappa : 0 <= kappa < 1;
  chain_spread : 0 <= spread;
  chain_sizes : forall i, Q2R (fst (Letter.after (l i))) <= Q2R (snd (Letter.after (l i))) /\
    Q2R (fst (Letter.before (l i))) <= Q2R (snd (Letter.before (l i))) /\ 0 < alpha (l i) /\ 0 < beta (l i) /\
    Q2R (snd (Letter.after (l i))) - Q2R (fst (Letter.after (l i))) <= alpha (l i) * spread /\
    Q2R (snd (Letter.before (l i))) - Q2R (fst (Letter.before (l i))) <= beta (l i) * spread;
  chain_order : forall i, Q2R (snd (Letter.before (l (i - 1)%Z))) < Q2R (fst (Letter.after (l i)));
  chain_legs : forall i s s', let tau := Machine.tau M in
    s_lo tau (l (i - 1)%Z) (l i) <= s <= s_hi tau (l (i - 1)%Z) (l i) ->
    s_lo tau (l i) (l (i + 1)%Z) <= s' <= s_hi tau (l i) (l (i + 1)%Z) ->
    leg_holds M w kappa (l (i - 1)%Z) (l i) (l (i + 1)%Z) s s' }.
(** And that its gaps are positive. *)
Definition open_gaps (M : Machine.t) (w : R) (l : Z -> Letter.t) : Prop := forall i s s' a, let tau :=
  Machine.tau M in
  s_lo tau (l (i - 1)%Z) (l i) <= s <= s_hi tau (l (i - 1)%Z) (l i) ->
  s_lo tau (l i) (l (i + 1)%Z) <= s' <= s_hi tau (l i) (l (i + 1)%Z) -> within (Letter.after (l i)) a ->
  let phi := phase M w s in let x := place M phi in let end_ := 2 * PI * IZR (Z.pos (Letter.periods (l i))) +
    phase M w s' in
  s / 2 <= a -> moved M phi x a end_ = place M (phase M w s') -> moving M phi x a end_ <= s' / 2 ->
  forall t, phi < t < end_ -> 0 < gap M phi x a t.

Section Path.
Variables (M : Machine.t) (w kappa spread : R) (l : Z -> Letter.t) (N : Z -> Z).
Hypothesis HC : chain M w kappa spread l.
Hypothesis HN : turns l N.
Notation nu := (Machine.nu M).
Notation tau := (Machine.tau M).
Notation ph := (phase M w).
Let HG := chain_good _ _ _ _ _ HC.
Let Hnu := good_nu _ _ HG.
Let Hf := good_f _ _ HG.
Let Htau := chain_tau _ _ _ _ _ HC.
Let n (i : Z) := Letter.periods (l i).

Definition lo (i : Z) : R := s_lo tau (l (i - 1)%Z) (l i).
Definition hi (i : Z) : R := s_hi tau (l (i - 1)%Z) (l i).
Definition wt (i : Z) : R := weight tau (l (i - 1)%Z) (l i).
Definition afters (s : Z -> R) (i : Z) : R := after M (n i) (ph (s i)) (ph (s (i + 1)%Z)).
Definition befores (s : Z -> R) (i : Z) : R := before M (n i) (ph (s i)) (ph (s (i + 1)%Z)).
Definition sums (s : Z -> R) (i : Z) : R := sum_of tau (afters s i) (befores s (i - 1)%Z).

Lemma previous i : (i + 1 - 1)%Z = i /\ (i - 1 + 1)%Z = i.
Proof. lia. Qed.
Lemma inv_pos : 0 < / (1 + tau).
Proof. apply Rinv_0_lt_compat; lra. Qed.

Lemma wt_pos i : 0 < wt i /\ lo i <= hi i /\ hi i - lo i <= wt i * spread.
Proof.
  destruct (chain_sizes _ _ _ _ _ HC i) as (A & _ & B & _ & C & _), (chain_sizes _ _ _ _ _ HC (i - 1)%Z) as
    (_ & A' & _ & B' & _ & C'); pose proof inv_pos as P.
  split; [unfold wt, weight, sum_of; apply Rmult_lt_0_compat; nra|]; split.
  - exact (proj1 (sum_bounds tau _ _ _ _ _ _ Htau (conj A (Rle_refl _)) (conj A' (Rle_refl _)))).
  - unfold hi, lo, wt, s_hi, s_lo, weight, sum_of; rewrite <- Rmult_minus_distr_r.
    replace (2 * (alpha (l i) + tau * beta (l (i - 1)%Z)) * / (1 + tau) * spread) with
      (2 * (alpha (l i) * spread + tau * (beta (l (i - 1)%Z) * spread)) * / (1 + tau)) by ring.
    apply Rmult_le_compat_r; nra.
Qed.

Lemma sum_inside i a p : within (Letter.after (l i)) a -> within (Letter.before (l (i - 1)%Z)) p ->
  lo i <= sum_of tau a p <= hi i.
Proof. intros; apply sum_bounds; trivial. Qed.

Lemma leg_at s i : inside lo hi s -> leg_holds M w kappa (l (i - 1)%Z) (l i) (l (i + 1)%Z) (s i) (s (i +
  1)%Z).
Proof.
  intros H; apply (chain_legs _ _ _ _ _ HC); [exact (H i)|]; specialize (H (i + 1)%Z); unfold lo, hi in H.
  rewrite (proj1 (previous i)) in H; exact H.
Qed.
Lemma boxes s i : inside lo hi s -> within (Letter.after (l i)) (afters s i) /\
  within (Letter.before (l i)) (befores s i).
Proof. intros H; destruct (leg_at s i H) as (_ & _ & _ & A & B & _); split; assumption. Qed.
Lemma landing s i : inside lo hi s -> lands M w (s i).
Proof. intros H; apply (leg_at s i H). Qed.

(** Where s and s' are close at two impacts so is the leg between them. *)
Lemma leg_close s1 s1' s2 s2' i d : lo i <= s1 <= hi i -> lo i <= s2 <= hi i ->
  lo (i + 1) <= s1' <= hi (i + 1) ->
  lo (i + 1) <= s2' <= hi (i + 1) -> 0 <= d -> Rabs (s1 - s2) <= wt i * d ->
    Rabs (s1' - s2') <= wt (i + 1) * d ->
  Rabs (after M (n i) (ph s1) (ph s1') - after M (n i) (ph s2) (ph s2')) <= kappa * alpha (l i) * d /\
  Rabs (before M (n i) (ph s1) (ph s1') - before M (n i) (ph s2) (ph s2')) <= kappa * beta (l i) * d.
Proof.
  intros H1 H2 H1' H2' Hd D D'; unfold lo, hi, wt in H1', H2', D'; rewrite (proj1 (previous i)) in H1', H2',
    D'.
  apply (leg_lipschitz M w kappa (l (i - 1)%Z) (l i) (l (i + 1)%Z) HG (chain_legs _ _ _ _ _ HC i));
    assumption.
Qed.
Lemma sum_close a a' p p' i d : Rabs (a - a') <= kappa * alpha (l i) * d ->
  Rabs (p - p') <= kappa * beta (l (i - 1)%Z) * d -> Rabs (sum_of tau a p - sum_of tau a' p') <= wt i *
    (kappa * d).
Proof.
  intros A B; pose proof inv_pos as P; unfold wt, weight, sum_of.
  replace (2 * (a + tau * p) * / (1 + tau) - 2 * (a' + tau * p') * / (1 + tau)) with
    (2 * ((a - a') + tau * (p - p')) * / (1 + tau)) by ring.
  rewrite !Rabs_mult, (Rabs_pos_eq 2), (Rabs_pos_eq (/ (1 + tau))) by lra.
  replace (2 * (alpha (l i) + tau * beta (l (i - 1)%Z)) * / (1 + tau) * (kappa * d)) with
    (2 * (kappa * alpha (l i) * d + tau * (kappa * beta (l (i - 1)%Z) * d)) * / (1 + tau)) by ring.
  apply Rmult_le_compat_r; [lra|]; apply Rmult_le_compat_l; [lra|].
  apply (Rle_trans _ _ _ (Rabs_triang _ _)), Rplus_le_compat; [exact A|].
  rewrite Rabs_mult, (Rabs_pos_eq tau) by lra; apply Rmult_le_compat_l; lra.
Qed.

Lemma one_solution : exists s, inside lo hi s /\ (forall i, sums s i = s i) /\
  forall s', inside lo hi s' -> (forall i, sums s' i = s' i) -> forall i, s' i = s i.
Proof.
  apply (one_fixed_point lo hi wt sums kappa spread).
  - intros i; destruct (wt_pos i); lra.
  - intros i; apply wt_pos.
  - apply HC.
  - split; [apply HC | intros i; apply wt_pos].
  - intros s H i; apply sum_inside; apply boxes, H.
  - intros d s s' Hd H H' E i; apply sum_close.
    + apply leg_close; auto.
    + unfold befores; rewrite (proj2 (previous i)); apply (leg_close _ _ _ _ (i - 1) d); auto;
        rewrite (proj2 (previous i)); auto.
Qed.

(** ** The motion of a solution *)

Section Motion.
Variable s : Z -> R.
Hypothesis Hs : inside lo hi s.
Hypothesis HF : forall i, sums s i = s i.
Hypothesis HO : open_gaps M w l.

Let x (i : Z) : R := place M (ph (s i)).
Let a (i : Z) : R := afters s i.
Let p (i : Z) : R := befores s i.
Definition at_ (i : Z) : R := 2 * PI * IZR (N i) + ph (s i).
Definition leg_q (i : Z) : R -> R := moved M (at_ i) (nu * x i) (nu * a i).
Definition leg_v (i : Z) : R -> R := moving M (at_ i) (nu * x i) (nu * a i).

Lemma at_next i : at_ (i + 1) - at_ i = time (n i) (ph (s i)) (ph (s (i + 1)%Z)).
Proof. unfold at_, time; rewrite HN, plus_IZR; unfold n; ring. Qed.

Lemma leg_end i : let T := time (n i) (ph (s i)) (ph (s (i + 1)%Z)) in
  E11 M T * x i + E12 M T * a i = x (i + 1)%Z /\ E21 M T * x i + E22 M T * a i = p i.
Proof.
  intros T; split; [|reflexivity]; apply leg_hits; destruct (leg_at s i Hs) as (_ & _ & P & _); exact P.
Qed.
Lemma leg_ends i : leg_q i (at_ (i + 1)) = nu * x (i + 1)%Z /\ leg_v i (at_ (i + 1)) = nu * p i.
Proof.
  unfold leg_q, leg_v; destruct (moved_scaled M nu (at_ i) (x i) (a i) (at_ (i + 1))) as [-> ->].
  unfold moved, moving, Flow.moved, Flow.moving; rewrite at_next; split; f_equal; apply (leg_end i).
Qed.
Lemma leg_starts i : leg_q i (at_ i) = nu * x i /\ leg_v i (at_ i) = nu * a i.
Proof. apply moved_start, Hf. Qed.

Lemma wall_place z t : wall M (2 * PI * IZR z + t) = nu * place M t /\ g1 M (2 * PI * IZR z + t) = g1 M t.
Proof.
  destruct (g_turned M z t) as [E E']; unfold wall, place; rewrite E, E'; split; [field; lra | reflexivity].
Qed.
Lemma wall_at i : wall M (at_ i) = nu * x i /\ g1 M (at_ i) = nu * (s i / 2).
Proof.
  unfold at_; destruct (wall_place (N i) (ph (s i))) as [-> ->]; split; [reflexivity|].
  rewrite (proj2 (landing s i Hs)); field.
Qed.

(** H3, and what it says of the speeds. *)
Lemma speeds i : p (i - 1)%Z < s i / 2 /\ s i / 2 <= a i /\ a i - s i / 2 = - tau * (p (i - 1)%Z - s i / 2).
Proof.
  pose proof (chain_order _ _ _ _ _ HC i) as O; destruct (boxes s i Hs) as [[A _] _],
    (boxes s (i - 1)%Z Hs) as [_ [_ B]].
  fold (a i) in A; fold (p (i - 1)%Z) in B; pose proof (HF i) as E; unfold sums, sum_of in E;
    fold (a i) (p (i - 1)%Z) in E.
  assert (E' : s i / 2 * (1 + tau) = a i + tau * p (i - 1)%Z) by (rewrite <- E; field; lra).
  set (h := s i / 2) in *; clearbody h; split; [nra|]; split; nra.
Qed.

Lemma is_motion : motion M w N at_ leg_q leg_v.
Proof.
  intros i j ->; destruct (leg_starts i) as [Q0 V0]; destruct (leg_ends i) as [Q1 V1].
  destruct (wall_at i) as [W0 U0]; destruct (wall_at (i + 1)) as [W1 U1];
    destruct (leg_starts (i + 1)) as [_ V2].
  destruct (speeds (i + 1)) as (S1 & S2 & S3); rewrite (proj1 (previous i)) in S1, S3.
  destruct (landing s i Hs) as [L _], (landing s (i + 1)%Z Hs) as [L' _]; apply Rabs_def2 in L as B, L' as B'.
  pose proof PI_RGT_0; pose proof (chain_w _ _ _ _ _ HC).
  split; [apply moved_free, Hf|]; split; [|split; [|split; [|split; [|split; [|split]]]]].
  - unfold at_; replace (2 * PI * IZR (N i) + ph (s i) - 2 * PI * IZR (N i)) with (ph (s i)) by ring; exact L.
  - apply Rminus_gt_0_lt; rewrite at_next; unfold time.
    assert (1 <= IZR (Z.pos (n i))) by (apply IZR_le; lia); nra.
  - congruence.
  - congruence.
  - intros y Hy; assert (G : 0 < gap M (ph (s i)) (x i) (a i) (y - 2 * PI * IZR (N i))).
    { pose proof (Hs (i + 1)%Z) as I; unfold lo, hi in I; rewrite (proj1 (previous i)) in I.
      assert (ET : forall z, 2 * PI * IZR (Z.pos (n i)) + z - ph (s i) = time (n i) (ph (s i)) z) by (intros;
        unfold time; ring).
      apply (HO i (s i) (s (i + 1)%Z) (a i)); trivial.
      - exact (Hs i).
      - apply (boxes s i Hs).
      - apply (speeds i).
      - fold (n i) (x i); unfold moved, Flow.moved; rewrite ET; apply (leg_end i).
      - fold (n i) (x i); unfold moving, Flow.moving; rewrite ET; fold (E21 M); rewrite (proj2 (leg_end i));
          lra.
      - fold (n i); pose proof (at_next i) as T; unfold at_, time in *; lra. }
    unfold leg_q; rewrite (proj1 (moved_scaled _ _ _ _ _ _)); unfold at_;
      rewrite (proj1 (moved_shifted _ _ _ _ _ _)).
    unfold gap in G; pose proof (proj1 (g_turned M (N i) (y - 2 * PI * IZR (N i)))) as E.
    replace (2 * PI * IZR (N i) + (y - 2 * PI * IZR (N i))) with y in E by ring; rewrite <- E in G;
      unfold wall; lra.
  - rewrite V1, U1; nra.
  - rewrite V1, V2, U1; transitivity (nu * (a (i + 1)%Z - s (i + 1)%Z / 2)); [ring | rewrite S3; ring].
Qed.

Lemma is_in_boxes : in_boxes M l at_ leg_v.
Proof.
  intros i j ->; destruct (leg_starts i) as [_ V0]; destruct (leg_ends i) as [_ V1]; rewrite V0, V1.
  replace (nu * a i / nu) with (a i) by (field; lra); replace (nu * p i / nu) with (p i) by (field; lra).
  apply boxes, Hs.
Qed.
End Motion.

(** ** A motion in the boxes is a solution *)

Section Only.
Variables (t : Z -> R) (q v : Z -> R -> R).
Hypothesis HM : motion M w N t q v.
Hypothesis HB : in_boxes M l t v.
Let phi (i : Z) : R := t i - 2 * PI * IZR (N i).
Let a (i : Z) : R := v i (t i) / nu.
Let p (i : Z) : R := v i (t (i + 1)%Z) / nu.
Definition sums_of (i : Z) : R := sum_of tau (a i) (p (i - 1)%Z).

Lemma sums_inside : inside lo hi sums_of.
Proof.
  intros i; apply sum_inside; [apply (HB i _ eq_refl)|]; pose proof (HB (i - 1)%Z i ltac:(lia)) as [_ B].
  unfold p; rewrite (proj2 (previous i)); exact B.
Qed.

Lemma t_phi i : t i = 2 * PI * IZR (N i) + phi i.
Proof. unfold phi; ring. Qed.

Lemma phases i : ph (sums_of i) = phi i.
Proof.
  destruct (HM (i - 1)%Z i ltac:(lia)) as (_ & _ & _ & _ & _ & _ & _ & V).
  destruct (HM i _ eq_refl) as (_ & P & _); fold (phi i) in P.
  apply (lands_is M w (good_b _ _ HG)); [exact P|].
  rewrite (t_phi i) in V at 2 4; rewrite (proj2 (wall_place _ _)) in V.
  unfold sums_of, sum_of, a, p; rewrite (proj2 (previous i)).
  apply (Rmult_eq_reg_r (1 + tau)); [|lra].
  match goal with |- _ = ?r => replace r with (v i (t i) + tau * v (i - 1)%Z (t i)) by (field; lra) end; lra.
Qed.

Lemma motion_leg i : q i (t i) = nu * place M (phi i) /\ v i (t i) = nu * a i /\
  a i = after M (n i) (phi i) (phi (i + 1)%Z) /\ p i = before M (n i) (phi i) (phi (i + 1)%Z).
Proof.
  destruct (HM i _ eq_refl) as (Hfr & _ & _ & Q0 & Q1 & _).
  destruct (free_moved M Hf _ _ (t i) (t (i + 1)%Z) Hfr) as [E V].
  assert (Ea : v i (t i) = nu * a i) by (unfold a; field; lra).
  assert (Ep : v i (t (i + 1)%Z) = nu * p i) by (unfold p; field; lra).
  rewrite (t_phi i) in Q0 at 2; rewrite (t_phi (i + 1)) in Q1 at 2.
  rewrite (proj1 (wall_place _ _)) in Q0; rewrite (proj1 (wall_place _ _)) in Q1.
  rewrite Q0, Ea in E, V; rewrite Q1 in E; rewrite Ep in V.
  rewrite (proj1 (moved_scaled _ _ _ _ _ _)) in E; rewrite (proj2 (moved_scaled _ _ _ _ _ _)) in V.
  apply Rmult_eq_reg_l in E; [|lra]; apply Rmult_eq_reg_l in V; [|lra].
  unfold moved, moving, Flow.moved, Flow.moving in E, V.
  assert (ET : t (i + 1)%Z - t i = time (n i) (phi i) (phi (i + 1)%Z)).
  { unfold phi, time; rewrite HN, plus_IZR; unfold n; ring. }
  rewrite ET in E, V; fold (E11 M) in E; fold (E21 M) in V.
  destruct (leg_at sums_of i sums_inside) as (_ & _ & P & _); rewrite !phases in P; fold (n i) in P.
  assert (A : a i = after M (n i) (phi i) (phi (i + 1)%Z)).
  { unfold after; rewrite E; unfold E11; field; exact P. }
  repeat split; trivial.
  unfold before; rewrite <- A; exact V.
Qed.

Lemma sums_fixed i : sums sums_of i = sums_of i.
Proof.
  unfold sums, afters, befores; rewrite !phases; unfold sums_of.
  destruct (motion_leg i) as (_ & _ & <- & _); destruct (motion_leg (i - 1)) as (_ & _ & _ & E).
  rewrite (proj2 (previous i)) in *; rewrite <- E; reflexivity.
Qed.

Lemma motion_determined s : (forall i, sums_of i = s i) -> forall i x,
  t i = at_ s i /\ q i x = leg_q s i x /\ v i x = leg_v s i x.
Proof.
  intros E i x.
  assert (Ephi : forall i, ph (s i) = phi i) by (intros j; rewrite <- E; apply phases).
  assert (Et : t i = at_ s i) by (unfold at_; rewrite Ephi; apply t_phi).
  destruct (motion_leg i) as (Q & V & A & _); destruct (HM i _ eq_refl) as (Hfr & _).
  destruct (free_moved M Hf _ _ (t i) x Hfr) as [E1 E2].
  unfold leg_q, leg_v, afters; rewrite !Ephi, <- A, <- Et, <- Q, <- V; auto.
Qed.
End Only.

Theorem one_motion : open_gaps M w l -> exists t q v, motion M w N t q v /\ in_boxes M l t v /\
  forall t' q' v',
  motion M w N t' q' v' -> in_boxes M l t' v' -> forall i x, t' i = t i /\ q' i x = q i x /\ v' i x = v i x.
Proof.
  intros HO; destruct one_solution as (s & Hs & HF & H1).
  exists (at_ s), (leg_q s), (leg_v s); split; [exact (is_motion s Hs HF HO)|]; split;
    [exact (is_in_boxes s Hs)|].
  intros t' q' v' HM HB; apply (motion_determined t' q' v' HM HB).
  apply H1; [exact (sums_inside t' v' HB) | exact (sums_fixed t' q' v' HM HB)].
Qed.
End Path.
