(** * The paper's oscillator: legs of one and two periods follow each other in every order *)

From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Headline.
From Grazing Require Import StatementChaos ChaosFlow Contraction ChaosChecks ChaosLegs.
Open Scope R_scope.

(** ** Periods of the wall *)

Lemma periods z x : cos (2 * PI * IZR z + x) = cos x /\ sin (2 * PI * IZR z + x) = sin x.
Proof.
  assert (P : forall k y, cos (2 * PI * INR k + y) = cos y /\ sin (2 * PI * INR k + y) = sin y).
  { intros k y; rewrite <- (cos_period y k), <- (sin_period y k); split; f_equal; ring. }
  destruct (Z_le_gt_dec 0 z) as [L|L].
  - replace (IZR z) with (INR (Z.to_nat z)) by (rewrite INR_IZR_INZ, Z2Nat.id by lia; reflexivity); apply P.
  - destruct (P (Z.to_nat (- z)) (2 * PI * IZR z + x)) as [C S].
    replace (2 * PI * INR (Z.to_nat (- z)) + (2 * PI * IZR z + x)) with x in C, S; [auto|].
    rewrite INR_IZR_INZ, Z2Nat.id, opp_IZR by lia; ring.
Qed.

Lemma moved_scaled mu t0 x u t : moved t0 (mu * x) (mu * u) t = mu * moved t0 x u t /\
  moving t0 (mu * x) (mu * u) t = mu * moving t0 x u t.
Proof. unfold moved, moving; split; ring. Qed.

Lemma moved_shifted T t0 x u t : moved (T + t0) x u t = moved t0 x u (t - T) /\
  moving (T + t0) x u t = moving t0 x u (t - T).
Proof. unfold moved, moving; replace (t - (T + t0)) with (t - T - t0) by ring; auto. Qed.

(** ** Every sequence of gaps of one and two periods *)

Section Word.
Variables (mu : R) (N : Z -> Z).
Hypothesis Hmu : mu > 0.
Hypothesis HN : one_or_two N.
Let nu := mu / (1 + mu).
Let n (i : Z) : Z := (N (i + 1) - N i)%Z.

Lemma n_letter i : letter (n i).
Proof. unfold letter, n; destruct (HN i); lia. Qed.

Lemma nu_range : 0 < nu < 1.
Proof.
  unfold nu; split; [apply Rdiv_lt_0_compat; lra|].
  apply (Rmult_lt_reg_r (1 + mu)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Lemma nu_range' : 0 < nu <= 1.
Proof. pose proof nu_range; lra. Qed.

Lemma wall_place z x : wall mu (2 * PI * IZR z + x) = mu * place nu x /\
  wall_velocity mu (2 * PI * IZR z + x) = mu * (- sin x / nu).
Proof.
  unfold wall, wall_velocity, place; destruct (periods z x) as [-> ->]; unfold nu; split; field; lra.
Qed.

Lemma wall_gap phi q a t : mu * moved phi q a t - wall mu t = (1 + mu) * gap nu phi q a t.
Proof. unfold wall, gap, nu; field; lra. Qed.

Let lo (i : Z) : R := dec (s_lo (n (i - 1)) (n i)).
Let hi (i : Z) : R := dec (s_hi (n (i - 1)) (n i)).
Let w (i : Z) : R := dec (weight (n (i - 1)) (n i)).
Let ph (s : R) : R := phase nu s.
Let F (s : Z -> R) (i : Z) : R := after (n i) nu (ph (s i)) (ph (s (i + 1)%Z)) +
  before (n (i - 1)) nu (ph (s (i - 1)%Z)) (ph (s i)).

Lemma previous i : (i + 1 - 1)%Z = i /\ (i - 1 + 1)%Z = i.
Proof. lia. Qed.

Ltac numbers := unfold dec, s_lo, s_hi, weight, a_lo, a_hi, p_lo, p_hi, alpha, beta in *; cbn in *; lra.

Lemma sizes m k : letter m -> letter k -> 0 < dec (weight m k) /\ dec (s_lo m k) <= dec (s_hi m k) /\
  dec (s_hi m k) - dec (s_lo m k) <= dec (weight m k) * 2 /\ -1 < dec (s_lo m k) /\ dec (s_hi m k) < 1.
Proof. intros [->| ->] [->| ->]; repeat split; numbers. Qed.

Lemma sums m k a p : dec (a_lo k) <= a <= dec (a_hi k) -> dec (p_lo m) <= p <= dec (p_hi m) ->
  dec (s_lo m k) <= a + p <= dec (s_hi m k).
Proof. unfold dec, s_lo, s_hi; rewrite !plus_IZR; lra. Qed.

Lemma speeds m k a p : letter m -> letter k -> dec (a_lo k) <= a -> p <= dec (p_hi m) -> p < a.
Proof. intros [->| ->] [->| ->]; numbers. Qed.

Lemma legs s i : inside lo hi s ->
  leg_holds (n (i - 1)) (n i) (n (i + 1)) nu (s i) (s (i + 1)%Z) /\
  leg_holds (n (i - 1 - 1)) (n (i - 1)) (n i) nu (s (i - 1)%Z) (s i).
Proof.
  assert (A : forall j, inside lo hi s -> leg_holds (n (j - 1)) (n j) (n (j + 1)) nu (s j) (s (j + 1)%Z)).
  { intros j H; apply leg_checks; auto using n_letter, nu_range'; [exact (H j)|].
    specialize (H (j + 1)%Z); unfold lo, hi in H; rewrite (proj1 (previous j)) in H; exact H. }
  intros H; split; [exact (A i H)|].
  specialize (A (i - 1)%Z H); rewrite (proj2 (previous i)) in A; exact A.
Qed.

Lemma one_solution : exists s, inside lo hi s /\ (forall i, F s i = s i) /\
  forall s', inside lo hi s' -> (forall i, F s' i = s' i) -> forall i, s' i = s i.
Proof.
  assert (Hw : forall i, 0 < w i) by (intros; apply sizes; apply n_letter).
  apply (one_fixed_point lo hi w F kappa 2); trivial.
  - intros i; unfold lo, hi; destruct (sizes (n (i - 1)) (n i)) as (_ & H & _); auto using n_letter; lra.
  - unfold kappa, dec; lra.
  - split; [lra|]; intros i; apply sizes; apply n_letter.
  - intros s H i; destruct (legs s i H) as [(_ & _ & _ & A & _) (_ & _ & _ & _ & B & _)].
    apply sums; [exact A | exact B].
  - intros d s s' Hd H H' D i.
    assert (L : forall j, Rabs (after (n j) nu (ph (s j)) (ph (s (j + 1)%Z)) -
        after (n j) nu (ph (s' j)) (ph (s' (j + 1)%Z))) <= kappa * dec (alpha (n j)) * d /\
      Rabs (before (n j) nu (ph (s j)) (ph (s (j + 1)%Z)) -
        before (n j) nu (ph (s' j)) (ph (s' (j + 1)%Z))) <= kappa * dec (beta (n j)) * d).
    { intros j; pose proof (H (j + 1)%Z) as I; pose proof (H' (j + 1)%Z) as I';
      pose proof (D (j + 1)%Z) as I''.
      unfold lo, hi, w in I, I', I''; rewrite (proj1 (previous j)) in I, I', I''.
      apply (leg_lipschitz (n (j - 1)) _ (n (j + 1))); auto using n_letter, nu_range';
        [exact (H j) | exact (H' j) | exact (D j)]. }
    destruct (L i) as [A _]; destruct (L (i - 1)%Z) as [_ B]; rewrite (proj2 (previous i)) in B.
    unfold F; match goal with |- Rabs (?a + ?b - (?c + ?e)) <= _ =>
      replace (a + b - (c + e)) with ((a - c) + (b - e)) by ring end.
    apply (Rle_trans _ _ _ (Rabs_triang _ _)).
    unfold w, dec, weight in *; rewrite plus_IZR; lra.
Qed.

Lemma small_phase s : -1 < s < 1 -> Rabs (phase nu s) < PI / 6.
Proof.
  intros Hs; pose proof nu_range as Hn; pose proof PI_RGT_0.
  assert (Hy : -1 / 2 < nu * s * (1 / 2) < 1 / 2) by (split; nra).
  pose proof (asin_bound (nu * s * (1 / 2))).
  assert (S : sin (asin (nu * s * (1 / 2))) = nu * s * (1 / 2)) by (apply sin_asin; lra).
  unfold phase; rewrite Rabs_Ropp; apply Rabs_def1.
  - apply sin_increasing_0; try lra; rewrite S, sin_PI6; lra.
  - apply sin_increasing_0; try lra; rewrite S, sin_neg, sin_PI6; lra.
Qed.

(** *** The motion of a solution *)

Section Motion.
Variable s : Z -> R.
Hypothesis Hs : inside lo hi s.
Hypothesis HF : forall i, F s i = s i.

Let x (i : Z) : R := place nu (ph (s i)).
Let a (i : Z) : R := after (n i) nu (ph (s i)) (ph (s (i + 1)%Z)).
Let p (i : Z) : R := before (n i) nu (ph (s i)) (ph (s (i + 1)%Z)).
Definition at_ (i : Z) : R := 2 * PI * IZR (N i) + ph (s i).
Definition leg_q (i : Z) : R -> R := moved (at_ i) (mu * x i) (mu * a i).
Definition leg_v (i : Z) : R -> R := moving (at_ i) (mu * x i) (mu * a i).

Lemma s_size i : -1 < s i < 1.
Proof.
  specialize (Hs i); destruct (sizes (n (i - 1)) (n i)) as (_ & _ & _ & A & B); auto using n_letter.
  unfold lo, hi in Hs; lra.
Qed.

Lemma N_next i : N (i + 1)%Z = (N i + n i)%Z.
Proof. unfold n; lia. Qed.

Lemma at_next i : at_ (i + 1) - at_ i = time (n i) (ph (s i)) (ph (s (i + 1)%Z)).
Proof. unfold at_, time; rewrite N_next, plus_IZR; ring. Qed.

Lemma leg_i i : leg_holds (n (i - 1)) (n i) (n (i + 1)) nu (s i) (s (i + 1)%Z).
Proof. apply legs, Hs. Qed.

Lemma leg_ends i : leg_q i (at_ (i + 1)) = mu * x (i + 1)%Z /\ leg_v i (at_ (i + 1)) = mu * p i.
Proof.
  destruct (leg_i i) as (_ & _ & P & _); fold (ph (s i)) (ph (s (i + 1)%Z)) in P.
  unfold leg_q, leg_v; destruct (moved_scaled mu (at_ i) (x i) (a i) (at_ (i + 1))) as [-> ->].
  unfold moved, moving; rewrite at_next; split; f_equal.
  apply leg_hits; lra.
Qed.

Lemma s_sum i : s (i + 1)%Z = a (i + 1)%Z + p i.
Proof. rewrite <- HF; unfold F, a, p; rewrite (proj1 (previous i)); reflexivity. Qed.

Lemma boxes i : dec (a_lo (n i)) <= a i <= dec (a_hi (n i)) /\ dec (p_lo (n i)) <= p i <= dec (p_hi (n i)).
Proof. destruct (leg_i i) as (_ & _ & _ & A & B & _); split; assumption. Qed.

Lemma a_above i : p i < a (i + 1)%Z.
Proof.
  apply (speeds (n i) (n (i + 1))); auto using n_letter; [apply (boxes (i + 1)) | apply (boxes i)].
Qed.

Lemma wall_at i : wall mu (at_ i) = mu * x i /\ wall_velocity mu (at_ i) = mu * (s i / 2).
Proof.
  unfold at_; destruct (wall_place (N i) (ph (s i))) as [-> ->]; split; [reflexivity|].
  f_equal; apply sin_phase; [apply nu_range|].
  destruct (leg_i i) as (Y & _); exact Y.
Qed.

Lemma leg_starts i : leg_q i (at_ i) = mu * x i /\ leg_v i (at_ i) = mu * a i.
Proof. apply moved_start. Qed.

Lemma is_motion : motion mu N at_ leg_q leg_v.
Proof.
  intros i j ->; pose proof PI2_3_2 as HP; pose proof PI_4 as HP4.
  pose proof (small_phase _ (s_size i)) as S1; pose proof (small_phase _ (s_size (i + 1))) as S2.
  destruct (leg_starts i) as [Q0 V0]; destruct (leg_ends i) as [Q1 V1].
  destruct (wall_at i) as [W0 U0]; destruct (wall_at (i + 1)) as [W1 U1].
  destruct (leg_starts (i + 1)) as [_ V2].
  pose proof (s_sum i) as E; pose proof (a_above i) as Ha.
  assert (Hn : 1 <= IZR (n i)) by (apply IZR_le; destruct (n_letter i) as [->| ->]; lia).
  split; [apply moved_free|]; split; [|split; [|split; [|split; [|split; [|split]]]]].
  - unfold at_; replace (2 * PI * IZR (N i) + ph (s i) - 2 * PI * IZR (N i)) with (ph (s i)) by ring.
    unfold ph; lra.
  - apply Rminus_gt_0_lt; rewrite at_next; unfold time, ph.
    apply Rabs_def2 in S1, S2; nra.
  - congruence.
  - congruence.
  - intros y Hy; apply Rminus_gt.
    pose proof (leg_i i) as (Y & Y' & P & A & B & _).
    pose proof (leg_i (i + 1)) as (_ & _ & _ & A' & _).
    assert (G : 0 < gap nu (ph (s i)) (x i) (a i) (y - 2 * PI * IZR (N i))).
    { apply (gap_positive (n (i - 1)) (n i) nu (s i) (a i) (s (i + 1)%Z)); auto using n_letter, nu_range'.
      - exact (Hs i).
      - apply (proj1 (gap_checks (n i) (n (i + 1)) nu (s (i + 1)%Z) (a (i + 1)%Z) (n_letter i) (n_letter (i
        + 1))
          nu_range' ltac:(pose proof (Hs (i + 1)%Z) as I; unfold lo, hi in I;
                          rewrite (proj1 (previous i)) in I; exact I) A')).
      - pose proof (a_above (i - 1)) as C; pose proof (s_sum (i - 1)) as E'.
        rewrite (proj2 (previous i)) in C, E'; lra.
      - fold (ph (s i)) (ph (s (i + 1)%Z)).
        unfold moved; replace (2 * PI * IZR (n i) + ph (s (i + 1)%Z) - ph (s i))
          with (time (n i) (ph (s i)) (ph (s (i + 1)%Z))) by (unfold time; ring).
        apply leg_hits; fold (ph (s i)) (ph (s (i + 1)%Z)) in P; lra.
      - fold (ph (s i)) (ph (s (i + 1)%Z)).
        unfold moving; replace (2 * PI * IZR (n i) + ph (s (i + 1)%Z) - ph (s i))
          with (time (n i) (ph (s i)) (ph (s (i + 1)%Z))) by (unfold time; ring).
        fold (p i); change (p i < s (i + 1)%Z / 2); lra.
      - fold (ph (s i)) (ph (s (i + 1)%Z)); pose proof (at_next i) as T; unfold at_, time in *; lra. }
    unfold leg_q; rewrite (proj1 (moved_scaled _ _ _ _ _)); unfold at_;
      rewrite (proj1 (moved_shifted _ _ _ _ _)).
    replace (wall mu y) with (wall mu (y - 2 * PI * IZR (N i))).
    + rewrite wall_gap; apply Rmult_gt_0_compat; lra.
    + unfold wall; do 2 f_equal; rewrite <- (proj1 (periods (N i) (y - 2 * PI * IZR (N i)))); f_equal; ring.
  - rewrite V1, U1; nra.
  - rewrite V1, V2, U1, E; field.
Qed.

Lemma is_in_boxes : in_boxes mu N at_ leg_v.
Proof.
  intros i j ->; destruct (leg_starts i) as [_ V0]; destruct (leg_ends i) as [_ V1]; rewrite V0, V1.
  destruct (boxes i) as [A B]; split; intros E.
  - assert (En : n i = 1%Z) by (unfold n; lia); rewrite En in A, B.
    unfold dec in A, B; cbn in A, B; split; split; nra.
  - assert (En : n i = 2%Z) by (unfold n; lia); rewrite En in A, B.
    unfold dec in A, B; cbn in A, B; split; split; nra.
Qed.
End Motion.

(** *** A motion in the boxes is a solution *)

Section Only.
Variables (t : Z -> R) (q v : Z -> R -> R).
Hypothesis HM : motion mu N t q v.
Hypothesis HB : in_boxes mu N t v.
Let phi (i : Z) : R := t i - 2 * PI * IZR (N i).
Let a (i : Z) : R := v i (t i) / mu.
Let p (i : Z) : R := v i (t (i + 1)%Z) / mu.
Definition sums_of (i : Z) : R := a i + p (i - 1)%Z.

Lemma in_box i : dec (a_lo (n i)) <= a i <= dec (a_hi (n i)) /\ dec (p_lo (n i)) <= p i <= dec (p_hi (n i)).
Proof.
  destruct (HB i _ eq_refl) as [B1 B2].
  assert (Ea : v i (t i) = mu * a i) by (unfold a; field; lra).
  assert (Ep : v i (t (i + 1)%Z) = mu * p i) by (unfold p; field; lra).
  rewrite Ea, Ep in B1, B2; destruct (HN i) as [E|E].
  - destruct (B1 E) as [A B]; replace (n i) with 1%Z by (unfold n; lia).
    unfold dec; cbn; split; split; apply (Rmult_le_reg_l mu); lra.
  - destruct (B2 E) as [A B]; replace (n i) with 2%Z by (unfold n; lia).
    unfold dec; cbn; split; split; apply (Rmult_le_reg_l mu); lra.
Qed.

Lemma sums_inside : inside lo hi sums_of.
Proof. intros i; apply sums; apply in_box. Qed.

Lemma t_phi i : t i = 2 * PI * IZR (N i) + phi i.
Proof. unfold phi; ring. Qed.

Lemma phases i : phase nu (sums_of i) = phi i.
Proof.
  destruct (HM (i - 1)%Z i ltac:(lia)) as (_ & _ & _ & _ & _ & _ & _ & V).
  destruct (HM i _ eq_refl) as (_ & P & _); fold (phi i) in P; apply Rabs_def2 in P.
  pose proof PI2_3_2; pose proof nu_range.
  assert (E : sums_of i = 2 * (- sin (phi i) / nu)).
  { rewrite (t_phi i) in V at 2 4; rewrite (proj2 (wall_place _ _)) in V.
    assert (Ea : v i (t i) = mu * a i) by (unfold a; field; lra).
    assert (Ep : v (i - 1)%Z (t i) = mu * p (i - 1)%Z)
      by (unfold p; rewrite (proj2 (previous i)); field; lra).
    rewrite Ea, Ep in V; unfold sums_of; apply (Rmult_eq_reg_l mu); lra. }
  unfold phase; rewrite E; replace (nu * (2 * (- sin (phi i) / nu)) * (1 / 2)) with (- sin (phi i))
    by (field; lra).
  rewrite asin_opp, Ropp_involutive; apply asin_sin; lra.
Qed.

Lemma motion_leg i : q i (t i) = mu * place nu (phi i) /\ v i (t i) = mu * a i /\
  a i = after (n i) nu (phi i) (phi (i + 1)%Z) /\ p i = before (n i) nu (phi i) (phi (i + 1)%Z).
Proof.
  destruct (HM i _ eq_refl) as (Hf & _ & _ & Q0 & Q1 & _).
  destruct (free_moved _ _ (t i) (t (i + 1)%Z) Hf) as [M V].
  assert (Ea : v i (t i) = mu * a i) by (unfold a; field; lra).
  assert (Ep : v i (t (i + 1)%Z) = mu * p i) by (unfold p; field; lra).
  rewrite (t_phi i) in Q0 at 2; rewrite (t_phi (i + 1)) in Q1 at 2; rewrite (proj1 (wall_place _ _)) in Q0.
  rewrite (proj1 (wall_place _ _)) in Q1.
  rewrite Q0, Ea in M, V; rewrite Q1 in M; rewrite Ep in V.
  rewrite (proj1 (moved_scaled _ _ _ _ _)) in M; rewrite (proj2 (moved_scaled _ _ _ _ _)) in V.
  apply Rmult_eq_reg_l in M; [|lra]; apply Rmult_eq_reg_l in V; [|lra].
  unfold moved, moving in M, V.
  assert (ET : t (i + 1)%Z - t i = time (n i) (phi i) (phi (i + 1)%Z)).
  { unfold phi, time, n; rewrite minus_IZR; ring. }
  rewrite ET in M, V.
  destruct (legs sums_of i sums_inside) as [(_ & _ & P & _) _]; rewrite !phases in P.
  assert (A : a i = after (n i) nu (phi i) (phi (i + 1)%Z)) by (unfold after; rewrite M; field; lra).
  repeat split; trivial.
  unfold before; rewrite <- A; exact V.
Qed.

Lemma sums_fixed i : F sums_of i = sums_of i.
Proof.
  unfold F, ph; rewrite !phases; unfold sums_of.
  destruct (motion_leg i) as (_ & _ & <- & _); destruct (motion_leg (i - 1)) as (_ & _ & _ & E).
  rewrite (proj2 (previous i)) in E; rewrite <- E; reflexivity.
Qed.

Lemma motion_determined s : (forall i, sums_of i = s i) -> forall i x,
  t i = at_ s i /\ q i x = leg_q s i x /\ v i x = leg_v s i x.
Proof.
  intros E i x.
  assert (Ephi : forall i, ph (s i) = phi i) by (intros k; unfold ph; rewrite <- E; apply phases).
  assert (Et : t i = at_ s i) by (unfold at_; rewrite Ephi; apply t_phi).
  destruct (motion_leg i) as (Q & V & A & _); destruct (HM i _ eq_refl) as (Hf & _).
  destruct (free_moved _ _ (t i) x Hf) as [M M'].
  unfold leg_q, leg_v; rewrite !Ephi, <- A, <- Et, <- Q, <- V; auto.
Qed.
End Only.

Theorem one_motion : exists t q v, motion mu N t q v /\ in_boxes mu N t v /\ forall t' q' v',
  motion mu N t' q' v' -> in_boxes mu N t' v' ->
  forall i x, t' i = t i /\ q' i x = q i x /\ v' i x = v i x.
Proof.
  destruct one_solution as (s & Hs & HF & H1).
  exists (at_ s), (leg_q s), (leg_v s); split; [exact (is_motion s Hs HF)|]; split;
    [exact (is_in_boxes s Hs)|].
  intros t' q' v' HM HB; apply (motion_determined t' q' v' HM HB).
  apply H1; [exact (sums_inside t' v' HB) | exact (sums_fixed t' q' v' HM HB)].
Qed.
End Word.

Theorem Chaos_oscillator : Headline.Chaos_statement.
Proof. intros mu N Hmu HN; exact (one_motion mu N Hmu HN). Qed.

(** ** The times determine N; periodic sequences have periodic motions *)

Theorem Chaos_distinct : Chaos_distinct_statement.
Proof.
  intros mu N N' t q v q' v' H H' i.
  destruct (H i _ eq_refl) as (_ & A & _); destruct (H' i _ eq_refl) as (_ & A' & _).
  apply Rabs_def2 in A, A'; pose proof PI2_3_2.
  destruct (Z.lt_trichotomy (N i) (N' i)) as [L|[E|L]]; [exfalso | exact E | exfalso].
  - assert (IZR (N i) + 1 <= IZR (N' i)) by (rewrite <- plus_IZR; apply IZR_le; lia); nra.
  - assert (IZR (N' i) + 1 <= IZR (N i)) by (rewrite <- plus_IZR; apply IZR_le; lia); nra.
Qed.

Theorem Chaos_periodic : Chaos_periodic_statement.
Proof.
  intros mu N t q v m P Hmu HN HM HB HP.
  destruct (Chaos_oscillator mu N Hmu HN) as (t0 & q0 & v0 & _ & _ & H1).
  set (T := 2 * PI * IZR P).
  set (t' := fun i => t (i + m)%Z - T).
  set (q' := fun i x => q (i + m)%Z (x + T)); set (v' := fun i x => v (i + m)%Z (x + T)).
  assert (HW : forall x, wall mu (x + T) = wall mu x /\ wall_velocity mu (x + T) = wall_velocity mu x).
  { intros x; unfold wall, wall_velocity, T; rewrite (Rplus_comm x).
    destruct (periods P x) as [-> ->]; auto. }
  assert (Hf : forall f f', free f f' -> free (fun x => f (x + T)) (fun x => f' (x + T))).
  { intros f f' H x; destruct (H (x + T)) as [D D'].
    assert (S : derivable_pt_lim (fun y => y + T) x 1).
    { eapply D_ext; [apply (D_plus (fun y => y) (fun _ => T));
      [apply D_id | apply D_const] | reflexivity | ring]. }
    split.
    - eapply D_ext; [apply (D_of (fun y => y + T) f _ _ _ S D) | reflexivity | ring].
    - eapply D_ext; [apply (D_of (fun y => y + T) f' _ _ _ S D') | reflexivity | ring]. }
  assert (Et : forall i, t' i + T = t (i + m)%Z) by (intros; unfold t'; ring).
  assert (HM' : motion mu N t' q' v').
  { intros i j ->; destruct (HM (i + m)%Z (i + 1 + m)%Z ltac:(lia)) as (F & A & O & Q0 & Q1 & G & V & V').
    unfold q', v'; rewrite !Et; split; [exact (Hf _ _ F)|].
    destruct (HW (t' i)) as [W _]; destruct (HW (t' (i + 1)%Z)) as [W1 U1]; rewrite Et in W, W1, U1.
    rewrite W in Q0; rewrite W1 in Q1; rewrite U1 in V, V'.
    split; [|split; [|split; [|split; [|split; [|split]]]]]; trivial.
    - unfold t', T; rewrite HP, plus_IZR in A.
      replace (t (i + m)%Z - 2 * PI * IZR P - 2 * PI * IZR (N i))
        with (t (i + m)%Z - 2 * PI * (IZR (N i) + IZR P)) by ring; exact A.
    - unfold t'; lra.
    - intros x Hx; rewrite <- (proj1 (HW x)); apply G; rewrite <- !Et; lra. }
  assert (HB' : in_boxes mu N t' v').
  { intros i j ->; unfold v'; rewrite !Et.
    destruct (HB (i + m)%Z (i + 1 + m)%Z ltac:(lia)) as [B1 B2]; rewrite !HP in B1, B2.
    split; intros E; [apply B1 | apply B2]; lia. }
  intros i x; destruct (H1 t q v HM HB i x) as (T1 & Q1 & V1).
  destruct (H1 t' q' v' HM' HB' i x) as (T2 & Q2 & V2).
  fold T; rewrite <- Et, T2, Q1, V1, <- T1; unfold q' in Q2; unfold v' in V2; auto.
Qed.
