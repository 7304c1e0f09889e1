(** * What follows, worked out by hand, from the definitions and statements about nonlinear oscillators *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementNonlinear Headline.
Import Nonlinear.
Open Scope R_scope.

(** ** What the definitions say *)
Lemma C1_means f f1 f2 f3 f4 : C1 (fun t y _ _ => t < y) f f1 f2 f3 f4 -> (derivable_pt_lim (fun x => f x 2 3 4) 1 (f1 1
  2 3 4) /\ derivable_pt_lim (fun x => f 1 x 3 4) 2 (f2 1 2 3 4) /\ derivable_pt_lim (fun x => f 1 2 x 4) 3 (f3 1 2 3 4)
  /\ derivable_pt_lim (fun x => f 1 2 3 x) 4 (f4 1 2 3 4)) /\ forall g, g = f1 \/ g = f2 \/ g = f3 \/ g = f4 ->
  exists d, d > 0 /\ forall t y v mu, 1 - d <= t <= 1 + d -> 2 - d <= y <= 2 + d -> 3 - d <= v <= 3 + d ->
  4 - d <= mu <= 4 + d -> g 1 2 3 4 - 1 / 9 <= g t y v mu <= g 1 2 3 4 + 1 / 9.
Proof.
  intros [A B C D (E1 & E2 & E3 & E4)]; split;
    [split; [apply A; lra | split; [apply B; lra | split; [apply C; lra | apply D; lra]]]|]. intros g Hg;
    assert (E : continuous (fun t y _ _ => t < y) g) by (destruct Hg as [->|[->|[->| ->]]]; assumption).
  destruct (E 1 2 3 4 ltac:(lra) (1 / 9) ltac:(lra)) as (d & Hd & H); exists d; split; [exact Hd|];
    intros t y v mu Ht Hy Hv Hm.
  specialize (H t y v mu ltac:(apply Rabs_le; lra) ltac:(apply Rabs_le; lra) ltac:(apply Rabs_le;
    lra) ltac:(apply Rabs_le; lra)). unfold Rabs in H; destruct Rcase_abs; lra.
Qed.
Lemma moves_means O mu y v t : moves O mu y v t -> derivable_pt_lim y t (v t) /\
  derivable_pt_lim v t (a O t (y t) (v t) mu).
Proof. intros [A B]; split; assumption. Qed.
Lemma tube_means O d t y v : tube O d t y v -> y0 O t - d <= y <= y0 O t + d /\ v0 O t - d <= v <= v0 O t + d.
Proof. intros [A B]; unfold Rabs in *; repeat destruct Rcase_abs; lra. Qed.
(** A hypothesis that is lost is missed here. *)
Lemma grazing_orbit_means O : grazing_orbit O -> (T O > 0 /\ 0 < tG O /\ tG O < T O /\ y0 O (tG O) = 0 /\
  a O (tG O) 0 0 0 > 0) /\ (forall t, y0 O (t + T O) = y0 O t /\ v0 O (t + T O) = v0 O t /\ forall y v mu,
  a O (t + T O) y v mu = a O t y v mu /\ rebound O mu (t + T O) v = rebound O mu t v) /\ (forall t,
  derivable_pt_lim (y0 O) t (v0 O t) /\ derivable_pt_lim (v0 O) t (a O t (y0 O t) (v0 O t) 0)) /\ (forall t,
  0 <= t < tG O \/ tG O < t <= T O -> y0 O t > 0) /\ (exists r, r > 0 /\ C1 (fun t y v mu => tube O r t y v /\
  Rabs mu <= r) (a O) (a_t O) (a_y O) (a_v O) (a_mu O)) /\ (tau O >= 0 /\ (forall mu t, rebound O mu t 0 = 0) /\
  forall mu t v, v < 0 -> rebound O mu t v >= 0) /\ exists r f3, r > 0 /\ (forall v, Rabs v <= r ->
  derivable_pt_lim (rebound O 0 (tG O)) v (f3 (tG O) 0 v 0)) /\ f3 (tG O) 0 0 0 = - tau O.
Proof.
  intros [[A1 A2] B [C1' C2] D E F (G1 & G2 & G3) (r & f1 & f2 & f3 & f4 & Hr & Ev & K)]. split; [lra|]; split;
    [exact A2|]; split; [exact B|]; split; [intros t Ht; apply D; lra|]; split; [|split].
  - destruct F as (q & Hq & H); exists q; split; [exact Hq | exact H].
  - split; [lra | split; [exact G2|]]; intros mu t v Hv; specialize (G3 mu t v Hv); lra.
  - exists r, f3; split; [exact Hr | split; [|exact Ev]]; intros v Hv; apply (in_v _ _ _ _ _ _ K).
    rewrite Rminus_eq_0, Rabs_R0; lra.
Qed.
Lemma law_means O : grazing_orbit O -> exists r f1 f2 f3 f4, r > 0 /\ C1 (fun t y v mu => Rabs (t - tG O) <= r /\
  Rabs v <= r /\ Rabs mu <= r) (fun t y v mu => rebound O mu t v) f1 f2 f3 f4.
Proof. intros [_ _ _ _ _ _ _ (r & f1 & f2 & f3 & f4 & Hr & _ & K)]; exists r, f1, f2, f3, f4; split; assumption. Qed.
Lemma linearized_means O m z w : linearized O m z w -> let at_ f := f 7 (y0 O 7) (v0 O 7) 0 in derivable_pt_lim z 7 (w
  7) /\ derivable_pt_lim w 7 (at_ (a_y O) * z 7 + at_ (a_v O) * w 7 + at_ (a_mu O) * m).
Proof. intros H; apply (H 7). Qed.
Lemma generic_means O a1 a2 gamma rate : generic O a1 a2 gamma rate -> (gamma <> 0 /\ rate <> 0) /\ (exists z w,
  linearized O 1 z w /\ z (tG O) = rate /\ forall t, z (t + T O) = z t /\ w (t + T O) = w t) /\ forall z w z' w',
  linearized O 0 z w -> linearized O 0 z' w' -> z (tG O) = 0 -> w (tG O) = 1 -> z' (tG O) = 1 -> w' (tG O) = 0 ->
  z (tG O + T O) = gamma /\ a1 = z' (tG O + T O) + w (tG O + T O) /\ a2 = z' (tG O + T O) * w (tG O + T O) - w' (tG O +
  T O) * z (tG O + T O).
Proof.
  intros [(p & q & r & -> & -> & H) G (z & w & L & P & ->) R]; split; [split; assumption|]; split; [exists z, w; auto|].
  intros z1 w1 z2 w2 L1 L2 E1 E2 E3 E4; destruct (H z1 w1 L1) as [A1 A2], (H z2 w2 L2) as [A3 A4]; rewrite E1, E2 in *;
    rewrite E3, E4 in *. rewrite A1, A2, A3, A4; split; [ring | split; ring].
Qed.
Lemma leg_means O mu d t y v : nonlinear_motion O mu d (fun i => 2 * i)%Z t y v -> (t 0%Z < t 1%Z /\ tG O - d <=
  t 0%Z <= tG O + d /\
  tG O + 2 * T O - d <= t 1%Z <= tG O + 2 * T O + d) /\ (y 0%Z (t 0%Z) = 0 /\ y 0%Z (t 1%Z) = 0 /\ v 0%Z (t 1%Z) < 0 /\
  v 1%Z (t 1%Z) = rebound O mu (t 1%Z) (v 0%Z (t 1%Z))) /\ (forall x, t 0%Z < x < t 1%Z -> y 0%Z x > 0) /\
  forall x, t 0%Z <= x <= t 1%Z -> moves O mu (y 0%Z) (v 0%Z) x /\ tube O d x (y 0%Z x) (v 0%Z x).
Proof.
  intros H; destruct (H 0%Z 1%Z eq_refl) as [A B C D E F G I J], (H 1%Z 2%Z eq_refl) as [_ B' _ _ _ _ _ _ _].
  cbn in B, B'; unfold Rabs in B, B'; repeat destruct Rcase_abs; repeat split; auto; try lra; try (apply C; assumption);
    apply D; assumption.
Qed.
Lemma the_nonlinear_motion O mu d N : one_nonlinear_motion O mu d N -> exists t y v, nonlinear_motion O mu d N t y v /\
  forall t' y' v', nonlinear_motion O mu d N t' y' v' -> t' 5%Z = t 5%Z /\ forall x, t 5%Z <= x <= t 6%Z ->
    y' 5%Z x = y 5%Z x /\ v' 5%Z x = v 5%Z x.
Proof. intros (t & y & v & M & U); exists t, y, v; split; [exact M|]; intros t' y' v' M'; apply (U t' y' v' M' 5%Z).
Qed.

(** ** What [exactly] and [never] say of them *)
Lemma never_nonlinear a1 a2 n : never a1 a2 n -> forall O gamma rate e, grazing_orbit O -> generic O a1 a2 gamma rate ->
  exists d mu0, d > 0 /\ mu0 > 0 /\ forall mu N t y v, 0 < sgn e * (rate * mu) < mu0 -> (forall i,
  N (i + 1) = N i + Z.of_nat n)%Z -> ~ nonlinear_motion O mu d N t y v.
Proof.
  intros H O gamma rate e HO HG; destruct (H (Moves O rate) gamma e (conj HO HG)) as (d & mu0 & Hd & Hm & U);
    exists d, mu0. split; [exact Hd | split; [exact Hm|]]; intros mu N t y v Hmu HN; exact (U mu Hmu N t y v HN).
Qed.
Lemma exactly_nonlinear a1 a2 n g : exactly a1 a2 n Plus g -> forall O gamma rate, grazing_orbit O ->
  generic O a1 a2 gamma rate -> sgn g * gamma > 0 -> exists d, d > 0 /\ forall eps, 0 < eps <= d -> exists mu0,
  mu0 > 0 /\ forall mu N, 0 < rate * mu < mu0 -> (forall i, N (i + 1) = N i + Z.of_nat n)%Z ->
  one_nonlinear_motion O mu eps N.
Proof.
  intros H O gamma rate HO HG Hg; destruct (H (Moves O rate) gamma (conj HO HG)) as [B _];
    destruct (B Hg) as (d & Hd & U). exists d; split; [exact Hd|]; intros eps He; destruct (U eps He) as (mu0 & Hm & W);
    exists mu0; split; [exact Hm|]. intros mu N Hmu HN; apply (W mu); [cbn; lra | exact HN].
Qed.
