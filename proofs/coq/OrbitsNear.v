(** * Points near an orbit near grazing have its flights and slow impacts *)

From Coq Require Import Reals Lra Lia.
From Grazing Require Import StatementOrbits FreeFlight Finite OrbitVectors OrbitRemainder Orbits Derivatives.
Import Map.
Open Scope R_scope.

Section Flight.
Variables (M : Map.t) (n_max : nat) (eta' d mu : R).
Notation N := (N M).
Notation hit k x := (h M (fly M mu k x) mu).
(** What flight and impact make of x. *)
Definition speed_at (k : nat) (x : vec) : R := sqrt (- hit k x).
Definition go (k : nat) (x : vec) : vec := fun i =>
  fly M mu k x i + kick M (fly M mu k x) (speed_at k x) mu i * speed_at k x.
(** x is near 0, and its impact after k steps is slow. *)
Record slow (k : nat) (x : vec) : Prop := {
  slow_steps : (1 <= k <= n_max)%nat;
  slow_near : within N d x;
  slow_hits : hit k x < 0;
  slow_speed : speed_at k x <= eta' / 2 /\ speed_at k x <= d }.
End Flight.

Section Near.
Variables (M : Map.t) (w : vec) (e : R).
Hypothesis HM : smooth M.
Hypothesis Hw : forall i, (i < N M)%nat -> w i = mult (N M) (A M) w i + phi M i.
Hypothesis He : e = dot (N M) (C M) w + eta M.
Notation N := (N M).
Variables (n_max : nat) (l d1 d eta' mu : R).
Notation hit k x := (h M (fly M mu k x) mu).
Hypothesis Hl : 1 <= l.
Hypothesis HL : forall k x x' mu mu' t, (k <= n_max)%nat -> within N d1 x -> within N d1 x' -> Rabs mu <= d1 ->
  Rabs mu' <= d1 -> within N t (minus x x') -> Rabs (mu - mu') <= t ->
  within N (l * t) (minus (fly M mu k x) (fly M mu' k x')) /\ Rabs (h M (fly M mu k x) mu - h M (fly M mu' k x') mu') <=
    l * t.
Hypothesis Hd : 0 < d <= d1.
Hypothesis Hs : 0 < eta' /\ l * d <= (eta' / 2) ^ 2 /\ l * d <= d1 ^ 2.
Hypothesis Hmu : Rabs mu <= d.

Lemma slow_there k p : (1 <= k <= n_max)%nat -> within N d p -> hit k p < 0 -> slow M n_max eta' d1 mu k p.
Proof.
  intros K Np Hh; split; trivial; [apply within_le with d; trivial; lra|]. destruct (HL k p zero mu 0 d) as [_ B]; try
    lia; try (rewrite ?Rabs_R0, ?Rminus_0_r; lra).
  { apply within_le with d; trivial; lra. } { apply within_zero; lra. }
  { intros i Hi; unfold minus, zero; rewrite Rminus_0_r; apply Np, Hi. }
  rewrite (height_zero M w e HM Hw He k), Rminus_0_r in B; apply le_abs in B; unfold speed_at. split; [rewrite <-
    (sqrt_pow2 (eta' / 2)) by lra|rewrite <- (sqrt_pow2 d1) by lra]; apply sqrt_le_1_alt; lra.
Qed.
Lemma flight_there k p : (1 <= k <= n_max)%nat -> (forall i, (1 <= i < k)%nat -> 0 < hit i p) -> hit k p < 0 ->
  forall i, (i < N)%nat -> Nat.iter k (step M mu) p i = go M mu k p i.
Proof.
  intros K Hf Hh i Hi; destruct k as [|k]; [lia|]. assert (E : forall j, (j <= k)%nat -> height M mu p j = hit (S j) p).
  { intros j Hj; unfold height; rewrite (iterates_free _ _ (fun x => f M x mu) (fun z => 0 < h M z mu));
      [reflexivity|apply step_free|]; intros a Ha; apply (Hf (S a)); lia. }
  rewrite (iterate_impact M mu p k).
  - unfold go, speed_at; rewrite E by lia; reflexivity.
  - intros a Ha; rewrite E by lia; apply Hf; lia.
  - rewrite E by lia; exact Hh.
Qed.
Lemma near_there c k x : (1 <= k <= n_max)%nat -> within N (d / 2) x -> 0 < c -> clear_at M mu k x c -> let r := Rmin
  (d / 2) (c / (2 * l)) in forall p, within N r (minus p x) -> slow M n_max eta' d1 mu k p /\ (forall i, (1 <= i <
  k)%nat -> 0 < hit i p) /\ forall i, (i < N)%nat -> Nat.iter k (step M mu) p i = go M mu k p i.
Proof.
  intros K Nx Hc [Hf Hh] r p Np; assert (R1 : r <= d / 2) by apply Rmin_l; assert (R2 : l * r <= c / 2).
  { apply Rle_trans with (l * (c / (2 * l))); [apply Rmult_le_compat_l; [lra | apply Rmin_r] | right; field; lra]. }
  assert (R0 : 0 < r) by (apply Rmin_glb_lt; [lra | apply Rdiv_lt_0_compat; lra]). assert (Npd : within N d p).
  { intros i Hi; specialize (Nx i Hi); specialize (Np i Hi); unfold minus in Np. replace (p i) with ((p i - x i) + x i)
      by ring; eapply Rle_trans; [apply Rabs_triang|lra]. }
  assert (Close : forall i, (i <= k)%nat -> Rabs (hit i p - hit i x) <= l * r).
  { intros i Hi; apply (HL i p x mu mu r); trivial; try lia; try lra.
    - apply within_le with d; trivial; lra.
    - apply within_le with (d / 2); trivial; lra.
    - rewrite Rminus_eq_0, Rabs_R0; lra. }
  assert (Hp : hit k p < 0) by (pose proof (Close k (le_n k)) as Q; apply le_abs in Q; lra).
  assert (Hfp : forall i, (1 <= i < k)%nat -> 0 < hit i p).
  { intros i Hi; specialize (Hf i Hi); pose proof (Close i ltac:(lia)) as Q; apply le_abs in Q; lra. }
  split; [apply slow_there; assumption | split; [exact Hfp | apply flight_there; assumption]].
Qed.
End Near.

Lemma small_enough a c : 0 < a -> 0 <= c -> exists t, 0 < t <= 1 /\ c * t <= a.
Proof.
  intros Ha Hc; exists (Rmin 1 (a / (c + 1))); split.
  - split; [apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]|apply Rmin_l].
  - apply Rle_trans with (c * (a / (c + 1))); [apply Rmult_le_compat_l; [lra|apply Rmin_r]|].
    replace (c * (a / (c + 1))) with (a * (c / (c + 1))) by (field; lra); rewrite <- (Rmult_1_r a) at 2.
    apply Rmult_le_compat_l; [lra|]; apply (Rmult_le_reg_r (c + 1)); [lra|]. replace (c / (c + 1) * (c + 1)) with c by
      (field; lra); lra.
Qed.

(** Points near an orbit near grazing have its flights: the nearer, the nearer its heights come to 0. *)
Lemma there M w n_max eps small : smooth M -> (forall i, (i < N M)%nat -> w i = mult (N M) (A M) w i + phi M i) -> 0 <
  eps -> 0 < small -> exists d1 d rho, 0 < d <= d1 /\ remainder M w (dot (N M) (C M) w + eta M) n_max eps d1 /\
  (forall c, 0 < c -> 0 < rho c) /\ forall k mu x c p, (1 <= k <= n_max)%nat -> Rabs mu <= d -> within (N M) d x ->
  0 < c -> clear_at M mu k x c -> within (N M) (rho c) (minus p x) -> slow M n_max small d1 mu k p /\ (forall i, (1 <= i
  < k)%nat -> 0 < h M (fly M mu i p) mu) /\ forall i, (i < N M)%nat -> Nat.iter k (step M mu) p i = go M mu k p i.
Proof.
  intros HM Hw Hep Hsm; set (e := dot (N M) (C M) w + eta M).
  destruct (remainder_exists M w e HM Hw eq_refl n_max eps) as (dr & dr0 & HR); [lra|].
  destruct (Lipschitz_fly M w e HM Hw eq_refl n_max) as (l & dl & l1 & dl0 & HL). destruct (two_least dr dl dr0 dl0) as
    (d1 & d10 & d1r & d1l). destruct (two_least ((small / 2) ^ 2) (d1 ^ 2)) as (sq & s0 & s1 & s2); [apply pow_lt;
    lra|apply pow_lt; lra|]. destruct (small_enough sq l s0 ltac:(lra)) as (d2 & d20 & d21).
  destruct (two_least d1 d2 d10 ltac:(lra)) as (d & d0 & da & db). assert (HL1 : forall k x x' mu mu' t, (k <=
    n_max)%nat -> within (N M) d1 x -> within (N M) d1 x' -> Rabs mu <= d1 -> Rabs mu' <= d1 -> within (N M) t (minus x
    x') -> Rabs (mu - mu') <= t -> within (N M) (l * t) (minus (fly M mu k x) (fly M mu' k x')) /\ Rabs (h M (fly M mu k
    x) mu - h M (fly M mu' k x') mu') <= l * t).
  { intros k x x' mu mu' t K X X' Mu Mu' T T'; apply HL; trivial; try lra; apply within_le with d1; trivial; lra. }
  assert (Ld : l * d <= sq) by (apply Rle_trans with (2 := d21); apply Rmult_le_compat_l; lra).
  exists d1, (d / 2), (fun c => Rmin (d / 2) (c / (2 * l))); split; [lra | split; [apply (remainder_down M w e n_max eps
    dr); trivial | split]].
  - intros c Hc; apply Rmin_glb_lt; [lra | apply Rdiv_lt_0_compat; lra].
  - intros k mu x c p K Hmu Nx Hc Cl Np; apply (near_there M w e HM Hw eq_refl n_max l d1 d small mu l1 HL1) with (c
    := c) (x := x); trivial; lra.
Qed.
Lemma orbit_clear M J next n mu d x j : (forall j : J, (1 <= n j)%nat) -> orbit_near M J next n mu d x -> exists c, 0
  < c
  /\ clear_at M mu (n j) (x j) c.
Proof.
  intros Hn Orb; destruct (orbit_zero M mu J next n Hn d x Orb) as [Z S]; destruct (S j) as [Pos F].
  destruct (proj1 (zero_meaning M mu J next n x (speed M mu J n x)) Z j) as [Eh _].
  destruct (common_bound (fun i c => (1 <= i < n j)%nat -> c <= h M (fly M mu i (x j)) mu) (n j)) as (c & Hc & All).
  - intros i c c' H Hc Hi; specialize (H Hi); lra.
  - intros i Hi; destruct i as [|i]; [exists 1; split; [lra | lia]|]; eexists; split; [|intros _; apply Rle_refl]; apply
      F; lia.
  - set (y := speed M mu J n x j) in *; assert (0 < y * y) by (apply Rmult_lt_0_compat; exact Pos).
    destruct (two_least c (y * y)) as (c' & Hc' & L1 & L2); trivial; exists c'; split; [exact Hc' | split; [|lra]].
    intros i Hi; specialize (All i ltac:(lia) Hi); lra.
Qed.
