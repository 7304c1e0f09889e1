(** * The clamp that changes a force away from an orbit, bounds of periodic functions, and solutions of the equation
      linearized along an orbit; instability goes over to the same impacts *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Derivatives StatementUnstable StatementNonlinear NonlinearSmooth NonlinearPicard.
From Grazing Require NonlinearKick.
Import Nonlinear.
Open Scope R_scope.

(** Instability goes over to weaker demands on motions, and to the same impacts. *)
Lemma unstable_same (leg leg' : (Z -> R) -> (Z -> R -> R) -> (Z -> R -> R) -> Z -> Z -> Prop) t v t' v' :
  (forall t y v i j, leg t y v i j -> leg' t y v i j) -> (forall i, t' i = t i /\ v' i (t' i) = v i (t i)) ->
    unstable_motion leg t v -> unstable_motion leg' t' v'.
Proof.
  intros HL E (r & Hr & H); exists r; split; [exact Hr|]; intros j eps He; destruct (H j eps He) as (l & s & y & w & Hl
    & Lg & Nj & Nl); exists l, s, y, w; split; [exact Hl | split; [intros i Hi; apply HL, Lg, Hi|]].
  unfold near in *; destruct (E j) as [E1 E2], (E l) as [E3 E4]; rewrite E2, E4, E1, E3; auto.
Qed.

Section Clamp.
Variable r : R.
Hypothesis Hr : 0 < r.
Definition cl x := Rmax (- r) (Rmin r x).
Lemma cl_in x : Rabs (cl x) <= r.
Proof. unfold cl, Rmax, Rmin; repeat destruct Rle_dec; apply Rabs_le; lra. Qed.
Lemma cl_id x : Rabs x <= r -> cl x = x.
Proof. intros H; apply le_abs in H; unfold cl, Rmax, Rmin; repeat destruct Rle_dec; lra. Qed.
Lemma cl_lip x y : Rabs (cl x - cl y) <= Rabs (x - y).
Proof. unfold cl, Rmax, Rmin, Rabs; repeat destruct Rle_dec; repeat destruct Rcase_abs; lra. Qed.
End Clamp.

(** Continuous periodic functions are bounded. *)
Lemma periodic_bounded f T : 0 < T -> (forall t, continuity_pt f t) -> (forall t, f (t + T) = f t) -> exists B, 0 <=
  B /\ forall t, Rabs (f t) <= B.
Proof.
  intros HT C P; destruct (continuous_bounded f T HT C) as (B & HB & H); exists B; split; [exact HB|]; intros t;
    destruct (in_one_period T t HT) as (z & Hz). replace t with (t - T * IZR z + T * IZR z) by ring; rewrite whole by
    exact P; apply H, Rabs_le; lra.
Qed.

(** The equation linearized along an orbit has solutions. *)
Lemma linear_solutions O (HO : grazing_orbit O) m s p q : exists z w, NonlinearKick.solves (k O) (c O) (l O) m z w /\ z
  s = p /\ w s = q.
Proof.
  pose proof (proj1 (period O HO)) as HT; pose proof (along_facts O HO) as C.
  destruct (periodic_bounded (k O) (T O) HT ltac:(intros t; apply C) ltac:(intros t; apply C)) as (B1 & P1 & H1).
  destruct (periodic_bounded (c O) (T O) HT ltac:(intros t; apply C) ltac:(intros t; apply C)) as (B2 & P2 & H2).
  destruct (periodic_bounded (l O) (T O) HT ltac:(intros t; apply C) ltac:(intros t; apply C)) as (B3 & P3 & H3).
  apply (linear_picard _ _ _ (B1 + B2 + B3)); intros t; [destruct (C t) as (C1 & C2 & C3 & _); auto|].
  specialize (H1 t); specialize (H2 t); specialize (H3 t); lra.
Qed.
