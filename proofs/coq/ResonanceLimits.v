(** * Limits of functions of any points, and slopes: a function that is derivable at x is f x + (y - x) g y, where
      g is continuous at x *)
From Coq Require Import Reals Lra.
From Grazing Require Import Derivatives.
Open Scope R_scope.

Section Limits.
Variables (X : Type) (size : X -> R).
Definition tends (f : X -> R) (l : R) : Prop := forall eps, 0 < eps -> exists d, 0 < d /\
  forall z, size z <= d -> Rabs (f z - l) <= eps.
Lemma tends_size f l : (forall z, Rabs (f z - l) <= size z) -> tends f l.
Proof. intros H eps He; exists eps; split; [exact He|]; intros z Hz; eapply Rle_trans; [apply H | exact Hz]. Qed.
Lemma tends_const l : tends (fun _ => l) l.
Proof. intros eps He; exists 1; split; [lra|]; intros z _; rewrite Rminus_eq_0, Rabs_R0; lra. Qed.
Lemma tends_plus f g l m : tends f l -> tends g m -> tends (fun z => f z + g z) (l + m).
Proof.
  intros F G eps He; destruct (F (eps / 2) ltac:(lra)) as (d & Hd & A), (G (eps / 2) ltac:(lra)) as (d' & Hd' & B).
  destruct (two_least d d' Hd Hd') as (r & Hr & L & L'); exists r; split; [exact Hr|]; intros z Hz.
  specialize (A z ltac:(lra)); specialize (B z ltac:(lra)).
  replace (f z + g z - (l + m)) with (f z - l + (g z - m)) by ring; eapply Rle_trans; [apply Rabs_triang | lra].
Qed.
Lemma tends_mult f g l m : tends f l -> tends g m -> tends (fun z => f z * g z) (l * m).
Proof.
  intros F G eps He; pose proof (Rabs_pos l) as Pl; pose proof (Rabs_pos m) as Pm; set (K := Rabs l + Rabs m + 1).
  assert (HK : 1 <= K) by (unfold K; lra).
  destruct (two_least 1 (eps / (2 * K)) ltac:(lra) ltac:(apply Rdiv_lt_0_compat; lra)) as (e & He' & E1 & E2).
  assert (E3 : K * e <= eps / 2) by (replace (eps / 2) with (K * (eps / (2 * K))) by (field; lra); nra).
  destruct (F e He') as (d & Hd & A), (G e He') as (d' & Hd' & B).
  destruct (two_least d d' Hd Hd') as (r & Hr & L & L'); exists r; split; [exact Hr|]; intros z Hz.
  specialize (A z ltac:(lra)); specialize (B z ltac:(lra)).
  replace (f z * g z - l * m) with ((f z - l) * (g z - m) + (l * (g z - m) + (f z - l) * m)) by ring.
  pose proof (product _ _ _ _ A B); pose proof (product l _ _ _ (Rle_refl _) B);
    pose proof (product _ m _ _ A (Rle_refl _)).
  eapply Rle_trans; [apply Rabs_triang|]; eapply Rle_trans; [apply Rplus_le_compat_l, Rabs_triang|].
  assert (e * e <= 1 * e) by (apply Rmult_le_compat_r; lra); unfold K in E3; lra.
Qed.
Lemma tends_of g f l : continuity_pt g l -> tends f l -> tends (fun z => g (f z)) (g l).
Proof.
  intros C F eps He; destruct (continuous_near g l eps C He) as (e & He' & A), (F e He') as (d & Hd & B).
  exists d; split; [exact Hd|]; intros z Hz; apply A, B, Hz.
Qed.
Lemma tends_minus f g l m : tends f l -> tends g m -> tends (fun z => f z - g z) (l - m).
Proof.
  intros F G; assert (H : tends (fun z => - g z) (- m)) by (apply (tends_of Ropp); [apply continuity_pt_opp,
    derivable_continuous_pt, derivable_pt_id | exact G]). exact (tends_plus _ _ _ _ F H).
Qed.
Lemma tends_over f g l m : m <> 0 -> tends f l -> tends g m -> tends (fun z => f z / g z) (l / m).
Proof.
  intros N F G; apply tends_mult; [exact F|]; apply (tends_of Rinv); [|exact G].
  apply (continuity_pt_inv (fun x => x)); [apply derivable_continuous_pt, derivable_pt_id | exact N].
Qed.
Lemma tends_at f l l' : tends f l -> l = l' -> tends f l'. Proof. intros H <-; exact H. Qed.
End Limits.

Lemma slope_of f x l : derivable_pt_lim f x l -> exists g, g x = l /\ continuity_pt g x /\
  forall y, f y = f x + (y - x) * g y.
Proof.
  intros D; exists (fun y => if Req_EM_T y x then l else (f y - f x) / (y - x)); split; [|split].
  - destruct (Req_EM_T x x); [reflexivity | congruence].
  - intros eps He; destruct (D eps He) as ([d Hd] & B); exists d; split; [exact Hd|]; intros y [[_ N] L]; cbn in *.
    unfold R_dist in *; destruct (Req_EM_T x x) as [_|]; [|congruence]; destruct (Req_EM_T y x) as [->|N'].
    + rewrite Rminus_eq_0, Rabs_R0; exact He.
    + specialize (B (y - x) ltac:(lra) L); replace (x + (y - x)) with y in B by ring; exact B.
  - intros y; destruct (Req_EM_T y x) as [->|N]; [ring | field; lra].
Qed.
