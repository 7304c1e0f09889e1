(** * Every path is exactly one motion: legs that contract, as the checks say, follow each other *)

From Coq Require Import Reals QArith Qreals ZArith Lra Lia Bool List.
From Grazing Require Import StatementOscillator PathsCheck PathsFlow PathsLegs PathsGaps StatementPaths Contraction.
From Grazing Require Export Motions.
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
  s_lo tau (l i) (l (i + 1)%Z) <= s' <= s_hi tau (l i) (l (i + 1)%Z) -> in_interval (Letter.after (l i)) a ->
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
Notation n := (fun i => Letter.periods (l i)).

Definition lo (i : Z) : R := s_lo tau (l (i - 1)%Z) (l i).
Definition hi (i : Z) : R := s_hi tau (l (i - 1)%Z) (l i).
Definition wt (i : Z) : R := weight tau (l (i - 1)%Z) (l i).
Lemma inv_pos : 0 < / (1 + tau). Proof. apply Rinv_0_lt_compat; lra. Qed.
Lemma wt_pos i : 0 < wt i /\ lo i <= hi i /\ hi i - lo i <= wt i * spread.
Proof.
  destruct (chain_sizes _ _ _ _ _ HC i) as (A & _ & B & _ & C & _), (chain_sizes _ _ _ _ _ HC (i - 1)%Z)
    as (_ & A' & _ & B' & _ & C'); pose proof inv_pos as P.
  split; [unfold wt, weight, sum_of; apply Rmult_lt_0_compat; nra|]; split.
  - exact (proj1 (sum_bounds tau _ _ _ _ _ _ Htau (conj A (Rle_refl _)) (conj A' (Rle_refl _)))).
  - unfold hi, lo, wt, s_hi, s_lo, weight, sum_of; rewrite <- Rmult_minus_distr_r.
    replace (2 * (alpha (l i) + tau * beta (l (i - 1)%Z)) * / (1 + tau) * spread)
      with (2 * (alpha (l i) * spread + tau * (beta (l (i - 1)%Z) * spread)) * / (1 + tau)) by ring.
    apply Rmult_le_compat_r; nra.
Qed.
Lemma sum_inside i a p : in_interval (Letter.after (l i)) a -> in_interval (Letter.before (l (i - 1)%Z)) p ->
  lo i <= sum_of tau a p <= hi i.
Proof. intros; apply sum_bounds; trivial. Qed.
Lemma leg_at s i : inside lo hi s -> leg_holds M w kappa (l (i - 1)%Z) (l i) (l (i + 1)%Z) (s i) (s (i + 1)%Z).
Proof.
  intros H; apply (chain_legs _ _ _ _ _ HC); [exact (H i)|]; specialize (H (i + 1)%Z); unfold lo, hi in H.
  rewrite (proj1 (previous i)) in H; exact H.
Qed.
Lemma boxes s i : inside lo hi s -> in_interval (Letter.after (l i)) (afters M w n s i) /\
  in_interval (Letter.before (l i)) (befores M w n s i).
Proof. intros H; destruct (leg_at s i H) as (_ & _ & _ & A & B & _); split; assumption. Qed.
Lemma landing s i : inside lo hi s -> lands M w (s i). Proof. intros H; apply (leg_at s i H). Qed.

(** Where s and s' are close at two impacts so is the leg between them. *)
Lemma leg_close s1 s1' s2 s2' i d : lo i <= s1 <= hi i -> lo i <= s2 <= hi i -> lo (i + 1) <= s1' <= hi (i + 1) ->
  lo (i + 1) <= s2' <= hi (i + 1) -> 0 <= d -> Rabs (s1 - s2) <= wt i * d -> Rabs (s1' - s2') <= wt (i + 1) * d ->
  Rabs (after M (n i) (ph s1) (ph s1') - after M (n i) (ph s2) (ph s2')) <= kappa * alpha (l i) * d /\
  Rabs (before M (n i) (ph s1) (ph s1') - before M (n i) (ph s2) (ph s2')) <= kappa * beta (l i) * d.
Proof.
  intros H1 H2 H1' H2' Hd D D'; unfold lo, hi, wt in H1', H2', D'; rewrite (proj1 (previous i)) in H1', H2', D'.
  apply (leg_lipschitz M w kappa (l (i - 1)%Z) (l i) (l (i + 1)%Z) HG (chain_legs _ _ _ _ _ HC i)); assumption.
Qed.
Lemma sum_close a a' p p' i d : Rabs (a - a') <= kappa * alpha (l i) * d -> Rabs (p - p') <= kappa * beta (l (i - 1)%Z)
  * d -> Rabs (sum_of tau a p - sum_of tau a' p') <= wt i * (kappa * d).
Proof.
  intros A B; pose proof inv_pos as P; unfold wt, weight, sum_of.
  replace (2 * (a + tau * p) * / (1 + tau) - 2 * (a' + tau * p') * / (1 + tau)) with (2 * ((a - a') + tau * (p - p')) *
    / (1 + tau)) by ring.
  rewrite !Rabs_mult, (Rabs_pos_eq 2), (Rabs_pos_eq (/ (1 + tau))) by lra.
  replace (2 * (alpha (l i) + tau * beta (l (i - 1)%Z)) * / (1 + tau) * (kappa * d))
    with (2 * (kappa * alpha (l i) * d + tau * (kappa * beta (l (i - 1)%Z) * d)) * / (1 + tau)) by ring.
  apply Rmult_le_compat_r; [lra|]; apply Rmult_le_compat_l; [lra|].
  apply (Rle_trans _ _ _ (Rabs_triang _ _)), Rplus_le_compat; [exact A|].
  rewrite Rabs_mult, (Rabs_pos_eq tau) by lra; apply Rmult_le_compat_l; lra.
Qed.
Lemma one_solution : exists s, inside lo hi s /\ (forall i, sums M w n s i = s i) /\
  forall s', inside lo hi s' -> (forall i, sums M w n s' i = s' i) -> forall i, s' i = s i.
Proof.
  apply (one_fixed_point lo hi wt (sums M w n) kappa spread).
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
Lemma solves s : inside lo hi s -> (forall i, sums M w n s i = s i) -> solution M w n s.
Proof. intros Hs HF; constructor; [intros i; apply landing, Hs | intros i; apply (leg_at s i Hs) | exact HF]. Qed.

(** H3, and H4. *)
Lemma moves s : open_gaps M w l -> inside lo hi s -> (forall i, sums M w n s i = s i) ->
  machine_motion M w N (at_ M w N s) (leg_q M w n N s) (leg_v M w n N s).
Proof.
  intros HO Hs HF; apply is_motion; auto using solves; try apply HC.
  - intros i; pose proof (chain_order _ _ _ _ _ HC i) as O; destruct (boxes s i Hs) as [[A _] _], (boxes s (i - 1)%Z Hs)
      as [_ [_ B]]; pose proof (HF i) as E; unfold sums, sum_of in E.
    set (a := afters M w n s i) in *; set (p := befores M w n s (i - 1)%Z) in *; clearbody a p.
    assert (E' : s i / 2 * (1 + tau) = a + tau * p) by (rewrite <- E; field; lra); nra.
  - intros i end_ H1 H2 H3; pose proof (Hs (i + 1)%Z) as I; unfold lo, hi in I; rewrite (proj1 (previous i)) in I.
    apply (HO i (s i) (s (i + 1)%Z)); trivial; [exact (Hs i) | apply (boxes s i Hs)].
Qed.
Lemma is_in_boxes s : inside lo hi s -> (forall i, sums M w n s i = s i) ->
  in_boxes M l (at_ M w N s) (leg_v M w n N s).
Proof.
  intros Hs HF; pose proof (solves s Hs HF) as S; intros i j ->.
  rewrite (proj2 (leg_starts M w n N HG s i)), (proj2 (leg_ends M w n N HN s S i)).
  replace (nu * afters M w n s i / nu) with (afters M w n s i) by (field; lra).
  replace (nu * befores M w n s i / nu) with (befores M w n s i) by (field; lra); apply boxes, Hs.
Qed.

(** ** A motion in the boxes is a solution *)

Section Only.
Variables (t : Z -> R) (q v : Z -> R -> R).
Hypothesis HM : machine_motion M w N t q v.
Hypothesis HB : in_boxes M l t v.

Lemma sums_inside : inside lo hi (sums_of M t v).
Proof.
  intros i; apply sum_inside; [apply (HB i _ eq_refl)|]; pose proof (HB (i - 1)%Z i ltac:(lia)) as [_ B].
  rewrite (proj2 (previous i)); exact B.
Qed.
Lemma sums_leg i : E12 M (time (n i) (ph (sums_of M t v i)) (ph (sums_of M t v (i + 1)%Z))) <> 0.
Proof. apply (leg_at _ i sums_inside). Qed.
Lemma sums_fixed i : sums M w n (sums_of M t v) i = sums_of M t v i.
Proof. apply (is_solution M w n N HG Htau HN t q v HM sums_leg). Qed.
End Only.

Theorem one_motion : open_gaps M w l -> exists t q v, machine_motion M w N t q v /\ in_boxes M l t v /\ forall t' q' v',
  machine_motion M w N t' q' v' -> in_boxes M l t' v' -> forall i x, t' i = t i /\ q' i x = q i x /\ v' i x = v i x.
Proof.
  intros HO; destruct one_solution as (s & Hs & HF & H1).
  exists (at_ M w N s), (leg_q M w n N s), (leg_v M w n N s); split; [exact (moves s HO Hs HF)|]; split;
    [exact (is_in_boxes s Hs HF)|].
  intros t' q' v' HM HB; apply (motion_determined M w n N HG Htau HN t' q' v' HM (sums_leg t' v' HB)).
  apply H1; [exact (sums_inside t' v' HB) | exact (sums_fixed t' q' v' HM HB)].
Qed.
End Path.
