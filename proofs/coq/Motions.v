(** * Strengths of impacts that satisfy the law of impact are a motion's, and a motion's strengths satisfy it

    The strength s of an impact says its phase: there the wall's velocity is nu s/2. The legs between impacts
    are given by the two phases alone. *)

From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import StatementOscillator StatementPaths PathsFlow PathsGaps PathsLegs.
Open Scope R_scope.

Section Strengths.
Variables (M : Machine.t) (w : R) (n : Z -> positive) (N : Z -> Z).
Hypothesis HG : good M w.
Hypothesis Hw : w <= PI.
Hypothesis Htau : 0 < Machine.tau M.
Hypothesis HN : forall i, (N (i + 1) = N i + Z.pos (n i))%Z.
Notation nu := (Machine.nu M).
Notation tau := (Machine.tau M).
Notation ph := (phase M w).
Let Hnu := good_nu _ _ HG.
Let Hf := good_f _ _ HG.

Definition afters (s : Z -> R) (i : Z) : R := after M (n i) (ph (s i)) (ph (s (i + 1)%Z)).
Definition befores (s : Z -> R) (i : Z) : R := before M (n i) (ph (s i)) (ph (s (i + 1)%Z)).
Definition sums (s : Z -> R) (i : Z) : R := sum_of tau (afters s i) (befores s (i - 1)%Z).

Lemma previous i : (i + 1 - 1)%Z = i /\ (i - 1 + 1)%Z = i. Proof. lia. Qed.
Lemma wall_place z t : wall M (2 * PI * IZR z + t) = nu * place M t /\ g1 M (2 * PI * IZR z + t) = g1 M t.
Proof. destruct (g_turned M z t) as [E E']; unfold wall, place; rewrite E, E'; split; [field; lra | reflexivity]. Qed.

(** ** The motion of a solution *)

Record solution (s : Z -> R) : Prop := {
  lands_at : forall i, lands M w (s i);
  legs_at : forall i, E12 M (time (n i) (ph (s i)) (ph (s (i + 1)%Z))) <> 0;
  sums_at : forall i, sums s i = s i }.

Section Motion.
Variable s : Z -> R.
Hypothesis Hs : solution s.
Let x (i : Z) : R := place M (ph (s i)).
Let a (i : Z) : R := afters s i.
Let p (i : Z) : R := befores s i.
Definition at_ (i : Z) : R := 2 * PI * IZR (N i) + ph (s i).
Definition leg_q (i : Z) : R -> R := moved M (at_ i) (nu * x i) (nu * a i).
Definition leg_v (i : Z) : R -> R := moving M (at_ i) (nu * x i) (nu * a i).

(** Impacts are at positive speed; the leg, moved to turn 0, is above the wall. *)
Hypothesis Hp : forall i, p (i - 1)%Z < s i / 2.
Hypothesis HO : forall i, let end_ := 2 * PI * IZR (Z.pos (n i)) + ph (s (i + 1)%Z) in s i / 2 <= a i ->
  moved M (ph (s i)) (x i) (a i) end_ = x (i + 1)%Z -> moving M (ph (s i)) (x i) (a i) end_ <= s (i + 1)%Z / 2 ->
  forall t, ph (s i) < t < end_ -> 0 < gap M (ph (s i)) (x i) (a i) t.

Lemma at_next i : at_ (i + 1) - at_ i = time (n i) (ph (s i)) (ph (s (i + 1)%Z)).
Proof. unfold at_, time; rewrite HN, plus_IZR; ring. Qed.
Lemma leg_end i : let T := time (n i) (ph (s i)) (ph (s (i + 1)%Z)) in
  E11 M T * x i + E12 M T * a i = x (i + 1)%Z /\ E21 M T * x i + E22 M T * a i = p i.
Proof. intros T; split; [apply leg_hits, (legs_at s Hs) | reflexivity]. Qed.
Lemma leg_ends i : leg_q i (at_ (i + 1)) = nu * x (i + 1)%Z /\ leg_v i (at_ (i + 1)) = nu * p i.
Proof.
  unfold leg_q, leg_v; destruct (moved_scaled M nu (at_ i) (x i) (a i) (at_ (i + 1))) as [-> ->].
  unfold moved, moving, Flow.moved, Flow.moving; rewrite at_next; split; f_equal; apply (leg_end i).
Qed.
Lemma leg_starts i : leg_q i (at_ i) = nu * x i /\ leg_v i (at_ i) = nu * a i.
Proof. apply moved_start, Hf. Qed.
Lemma wall_at i : wall M (at_ i) = nu * x i /\ g1 M (at_ i) = nu * (s i / 2).
Proof.
  unfold at_; destruct (wall_place (N i) (ph (s i))) as [-> ->]; split; [reflexivity|].
  rewrite (proj2 (lands_at s Hs i)); field.
Qed.
Lemma speeds i : p (i - 1)%Z < s i / 2 /\ s i / 2 <= a i /\ a i - s i / 2 = - tau * (p (i - 1)%Z - s i / 2).
Proof.
  pose proof (sums_at s Hs i) as E; unfold sums, sum_of in E; fold (a i) (p (i - 1)%Z) in E; specialize (Hp i).
  assert (E' : s i / 2 * (1 + tau) = a i + tau * p (i - 1)%Z) by (rewrite <- E; field; lra).
  set (h := s i / 2) in *; clearbody h; split; [exact Hp|]; split; nra.
Qed.
Theorem is_motion : machine_motion M w N at_ leg_q leg_v.
Proof.
  intros i j ->; destruct (leg_starts i) as [Q0 V0]; destruct (leg_ends i) as [Q1 V1].
  destruct (wall_at i) as [W0 U0]; destruct (wall_at (i + 1)) as [W1 U1]; destruct (leg_starts (i + 1)) as [_ V2].
  destruct (speeds (i + 1)) as (S1 & S2 & S3); rewrite (proj1 (previous i)) in S1, S3.
  destruct (lands_at s Hs i) as [L _], (lands_at s Hs (i + 1)%Z) as [L' _]; apply Rabs_def2 in L as B, L' as B'.
  pose proof PI_RGT_0. constructor; [apply moved_free, Hf|..].
  - unfold at_; replace (2 * PI * IZR (N i) + ph (s i) - 2 * PI * IZR (N i)) with (ph (s i)) by ring; exact L.
  - apply Rminus_gt_0_lt; rewrite at_next; unfold time. assert (1 <= IZR (Z.pos (n i))) by (apply IZR_le; lia); nra.
  - congruence.
  - congruence.
  - intros y Hy; assert (G : 0 < gap M (ph (s i)) (x i) (a i) (y - 2 * PI * IZR (N i))).
    { assert (ET : forall z, 2 * PI * IZR (Z.pos (n i)) + z - ph (s i) = time (n i) (ph (s i)) z) by (intros;
        unfold time; ring).
      apply (HO i).
      - apply (speeds i).
      - unfold moved, Flow.moved; rewrite ET; apply (leg_end i).
      - unfold moving, Flow.moving; rewrite ET; fold (E21 M); rewrite (proj2 (leg_end i)); lra.
      - pose proof (at_next i) as T; unfold at_, time in *; lra. }
    unfold leg_q; rewrite (proj1 (moved_scaled _ _ _ _ _ _)); unfold at_; rewrite (proj1 (moved_shifted _ _ _ _ _ _)).
    unfold gap in G; pose proof (proj1 (g_turned M (N i) (y - 2 * PI * IZR (N i)))) as E.
    replace (2 * PI * IZR (N i) + (y - 2 * PI * IZR (N i))) with y in E by ring; rewrite <- E in G; unfold wall; lra.
  - rewrite V1, U1; nra.
  - rewrite V1, V2, U1; transitivity (nu * (a (i + 1)%Z - s (i + 1)%Z / 2)); [ring | rewrite S3; ring].
Qed.
End Motion.

(** ** The solution of a motion *)

Section Only.
Variables (t : Z -> R) (q v : Z -> R -> R).
Hypothesis HM : machine_motion M w N t q v.
Let phi (i : Z) : R := t i - 2 * PI * IZR (N i).
Let a (i : Z) : R := v i (t i) / nu.
Let p (i : Z) : R := v i (t (i + 1)%Z) / nu.
Definition sums_of (i : Z) : R := sum_of tau (a i) (p (i - 1)%Z).

Lemma t_phi i : t i = 2 * PI * IZR (N i) + phi i. Proof. unfold phi; ring. Qed.

(** By the law of impact. *)
Lemma strength_of i : g1 M (t i) = nu * sums_of i * (1 / 2).
Proof.
  pose proof (machine_back _ _ _ _ _ _ _ _ (HM (i - 1)%Z i ltac:(lia))) as V.
  unfold sums_of, sum_of, a, p; rewrite (proj2 (previous i)). apply (Rmult_eq_reg_r (1 + tau)); [|lra].
  match goal with |- _ = ?r => replace r with (v i (t i) + tau * v (i - 1)%Z (t i)) by (field; lra) end; lra.
Qed.
Lemma phases i : ph (sums_of i) = phi i /\ lands M w (sums_of i).
Proof.
  pose proof (machine_near _ _ _ _ _ _ _ _ (HM i _ eq_refl)) as P; fold (phi i) in P.
  apply (lands_is M w (good_b _ _ HG)); [exact P|].
  pose proof (strength_of i) as V; rewrite (t_phi i), (proj2 (wall_place _ _)) in V; exact V.
Qed.

Hypothesis HE : forall i, E12 M (time (n i) (ph (sums_of i)) (ph (sums_of (i + 1)%Z))) <> 0.

Lemma motion_leg i : q i (t i) = nu * place M (phi i) /\ v i (t i) = nu * a i /\
  a i = after M (n i) (phi i) (phi (i + 1)%Z) /\ p i = before M (n i) (phi i) (phi (i + 1)%Z).
Proof.
  destruct (HM i _ eq_refl) as [Hfr _ _ Q0 Q1 _ _ _]. destruct (free_moved M Hf _ _ (t i) (t (i + 1)%Z) Hfr) as [E V].
  assert (Ea : v i (t i) = nu * a i) by (unfold a; field; lra).
  assert (Ep : v i (t (i + 1)%Z) = nu * p i) by (unfold p; field; lra).
  rewrite (t_phi i) in Q0 at 2; rewrite (t_phi (i + 1)) in Q1 at 2.
  rewrite (proj1 (wall_place _ _)) in Q0; rewrite (proj1 (wall_place _ _)) in Q1.
  rewrite Q0, Ea in E, V; rewrite Q1 in E; rewrite Ep in V.
  rewrite (proj1 (moved_scaled _ _ _ _ _ _)) in E; rewrite (proj2 (moved_scaled _ _ _ _ _ _)) in V.
  apply Rmult_eq_reg_l in E; [|lra]; apply Rmult_eq_reg_l in V; [|lra].
  unfold moved, moving, Flow.moved, Flow.moving in E, V.
  assert (ET : t (i + 1)%Z - t i = time (n i) (phi i) (phi (i + 1)%Z)).
  { unfold phi, time; rewrite HN, plus_IZR; ring. }
  rewrite ET in E, V; fold (E11 M) in E; fold (E21 M) in V. pose proof (HE i) as P; rewrite !(proj1 (phases _)) in P.
  assert (A : a i = after M (n i) (phi i) (phi (i + 1)%Z)).
  { unfold after; rewrite E; unfold E11; field; exact P. }
  repeat split; trivial. unfold before; rewrite <- A; exact V.
Qed.
Theorem is_solution : solution sums_of.
Proof.
  constructor; [apply phases | exact HE|]; intros i.
  unfold sums, afters, befores; rewrite !(proj1 (phases _)); unfold sums_of.
  destruct (motion_leg i) as (_ & _ & <- & _); destruct (motion_leg (i - 1)) as (_ & _ & _ & E).
  rewrite (proj2 (previous i)) in *; rewrite <- E; reflexivity.
Qed.

(** It has no other motion. *)
Lemma motion_determined s : (forall i, sums_of i = s i) -> forall i x,
  t i = at_ s i /\ q i x = leg_q s i x /\ v i x = leg_v s i x.
Proof.
  intros E i x. assert (Ephi : forall i, ph (s i) = phi i) by (intros j; rewrite <- E; apply phases).
  assert (Et : t i = at_ s i) by (unfold at_; rewrite Ephi; apply t_phi).
  destruct (motion_leg i) as (Q & V & A & _); pose proof (machine_free _ _ _ _ _ _ _ _ (HM i _ eq_refl)) as Hfr.
  destruct (free_moved M Hf _ _ (t i) x Hfr) as [E1 E2].
  unfold leg_q, leg_v, afters; rewrite !Ephi, <- A, <- Et, <- Q, <- V; auto.
Qed.
End Only.
End Strengths.
