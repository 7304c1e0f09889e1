(** * Proof of Theorem 1 for smooth maps of any dimension and for every word

    Orbits are solutions of (19) with the right signs; near 0 there is one solution, close
    to that of the linear problem, whose signs are those of (33), (34). *)

From Coq Require Import Reals Lra Lia.
From Grazing Require Import Defs StatementOrbits FreeFlight OrbitVectors Contraction OrbitRemainder OrbitFixedPoint.
Import Map.
Open Scope R_scope.

Section Orbits.
Variables (M : Map.t) (mu : R) (J : Type) (next : J -> J) (n : J -> nat).
Hypothesis Hn : forall j, (1 <= n j)%nat.
Notation N := (N M).
Notation hit k x := (h M (fly M mu k x) mu).

Lemma step_free x : 0 < h M (f M x mu) mu -> step M mu x = f M x mu.
Proof. intros H; unfold step; destruct Rle_dec; [reflexivity | lra]. Qed.

Lemma step_impact x : h M (f M x mu) mu < 0 -> step M mu x = fun i => f M x mu i +
  kick M (f M x mu) (sqrt (- h M (f M x mu) mu)) mu i * sqrt (- h M (f M x mu) mu).
Proof. intros H; unfold step; destruct Rle_dec; [lra | reflexivity]. Qed.

Lemma zero_meaning x y : zero_at M J next n mu x y <-> forall j, hit (n j) (x j) = - (y j * y j) /\ forall i,
  (i < N)%nat -> x (next j) i = fly M mu (n j) (x j) i + kick M (fly M mu (n j) (x j)) (Rabs (y j)) mu i * y j.
Proof.
  unfold zero_at, linear, q_at, Q_at, rest1, rest2; split; intros H j; destruct (H j) as [H1 H2]; (split; [lra | intros
    i Hi; specialize (H2 i Hi); lra]).
Qed.

Lemma heights x m : (forall k, (S k < m)%nat -> 0 < height M mu x k) ->
  forall k, (k < m)%nat -> height M mu x k = hit (S k) x.
Proof.
  intros H k Hk; unfold height.
  rewrite (iterates_free' _ _ (fun x => f M x mu) (fun z => 0 < h M z mu)); [reflexivity | apply step_free|].
  intros i Hi; apply H; lia.
Qed.

Lemma iterate_impact x m : (forall k, (S k < S m)%nat -> 0 < height M mu x k) -> height M mu x m < 0 ->
  forall i, Nat.iter (S m) (step M mu) x i = fly M mu (S m) x i +
  kick M (fly M mu (S m) x) (sqrt (- height M mu x m)) mu i * sqrt (- height M mu x m).
Proof.
  intros H Hm i; rewrite (heights x (S m)) in * by (trivial; lia).
  change (Nat.iter (S m) (step M mu) x) with (step M mu (Nat.iter m (step M mu) x)).
  rewrite (iterates_free' _ _ (fun x => f M x mu) (fun z => 0 < h M z mu)); [| apply step_free | intros k Hk; apply H;
    lia].
  rewrite step_impact by exact Hm; reflexivity.
Qed.

Definition speed (x : J -> vec) : J -> R := fun j => sqrt (- height M mu (x j) (n j - 1)).

Definition right_signs (x : J -> vec) (y : J -> R) : Prop := forall j,
  0 < y j /\ forall k, (1 <= k < n j)%nat -> 0 < hit k (x j).

Lemma orbit_zero d x : orbit_near M J next n mu d x -> zero_at M J next n mu x (speed x) /\ right_signs x (speed x).
Proof.
  intros H; split.
  - apply zero_meaning; intros j; destruct (H j) as (_ & Hfree & Hhit & Hback).
    specialize (Hhit (n j - 1)%nat); pose proof (Hn j) as H1; unfold speed.
    destruct (n j) as [|m]; [lia|]; cbn [Nat.sub] in *; rewrite Nat.sub_0_r in *. specialize (Hhit eq_refl); split.
    + rewrite sqrt_sqrt by lra; rewrite <- (heights (x j) (S m)) by (trivial; lia); ring.
    + intros i Hi; rewrite <- Hback, iterate_impact by assumption. rewrite Rabs_pos_eq by apply sqrt_pos; reflexivity.
  - intros j; destruct (H j) as (_ & Hfree & Hhit & _); pose proof (Hn j) as H1; split.
    + apply sqrt_lt_R0; specialize (Hhit (n j - 1)%nat ltac:(lia)); lra.
    + intros [|k] Hk; [lia|]; rewrite <- (heights (x j) (n j)) by (trivial; lia); apply Hfree; lia.
Qed.

Lemma zero_orbit d x y : (forall j, within N d (x j)) -> zero_at M J next n mu x y ->
  right_signs x y -> orbit_near M J next n mu d x.
Proof.
  intros Hd Hz Hs j; destruct (proj1 (zero_meaning x y) Hz j) as [H1 H2], (Hs j) as [Hy Hk].
  assert (Hi : forall k, (S k <= n j)%nat -> height M mu (x j) k = hit (S k) (x j)).
  { intros k Hkn; unfold height.
    rewrite (iterates_free _ _ (fun x => f M x mu) (fun z => 0 < h M z mu)); [reflexivity | apply step_free|].
    intros i Hi; apply (Hk (S i)); lia. }
  assert (Hfree : forall k, (S k < n j)%nat -> 0 < height M mu (x j) k) by (intros k Hkn; rewrite Hi by lia; apply Hk;
    lia).
  assert (Hhit : forall k, S k = n j -> height M mu (x j) k = - (y j * y j)) by (intros k Hkn; rewrite Hi, Hkn by lia;
    exact H1).
  assert (Hyy : 0 < y j * y j) by (apply Rmult_lt_0_compat; exact Hy).
  split; [apply Hd | split; [exact Hfree | split; [intros k Hkn; rewrite Hhit by exact Hkn; lra|]]].
  intros i HiN; rewrite (H2 i HiN); pose proof (Hn j) as H1n.
  destruct (n j) as [|m]; [lia|]; rewrite iterate_impact; [| exact Hfree | rewrite Hhit by reflexivity; lra].
  rewrite Hhit, Ropp_involutive, sqrt_square, Rabs_pos_eq by (trivial; lra); reflexivity.
Qed.
End Orbits.

(** The heights on the way from x to an impact after k steps stay off 0, by c. *)
Definition clear_at (M : Map.t) (mu : R) (k : nat) (x : vec) (c : R) : Prop := (forall i, (1 <= i < k)%nat ->
  c <= h M (fly M mu i x) mu) /\ h M (fly M mu k x) mu <= - c.

(** The parts of Theorem 1: existence, where the heights then stay off 0, uniqueness and non-existence, by the signs
    of the quantities; and asymptotics. *)
Definition decided (M : Map.t) (e K : R) (n_max : nat) (d : R) : Prop := forall kappa, kappa > 0 -> exists mu0, mu0 >
  0 /\
  forall (J : Type) (next : J -> J) n X Y s mu, (forall j, 1 <= n j <= n_max)%nat -> invertible M J next n K ->
  solution M J next n X Y -> 0 < sgn s * (e * mu) < mu0 -> ((forall j v, quantity M J n X Y s j v -> v >= kappa) ->
  exists x, orbit_near M J next n mu d x /\ forall x', orbit_near M J next n mu d x' ->
  (forall j i, (i < N M)%nat -> x' j i = x j i) /\ exists c, 0 < c /\ forall j, clear_at M mu (n j) (x' j) c) /\
  (forall j v, quantity M J n X Y s j v -> v <= - kappa -> forall x, ~ orbit_near M J next n mu d x).
Definition leads (M : Map.t) (w : vec) (e K : R) (n_max : nat) (d : R) : Prop := forall eps, eps > 0 -> exists mu1,
  mu1 > 0 /\ forall (J : Type) (next : J -> J) n X Y mu x, (forall j, 1 <= n j <= n_max)%nat -> invertible M J next n
    K ->
  solution M J next n X Y -> 0 < Rabs mu < mu1 -> orbit_near M J next n mu d x -> forall j,
  within (N M) (eps * Rabs mu) (fun i => x j i - mu * w i - e * mu * X j i) /\
  Rabs (sqrt (- height M mu (x j) (n j - 1)) - e * mu * Y j) <= eps * Rabs mu.

Lemma invertible_up M J (next : J -> J) n K K' : K <= K' -> invertible M J next n K -> invertible M J next n K'.
Proof.
  intros HK [H1 H2]; split; [|exact H2]; intros e Q q HQ; destruct (H1 e Q q HQ) as (X & Y & Hb & Hl).
  exists X, Y; split; [|exact Hl]; intros j. apply (bounded_le M J (K * e) (K' * e)); [|exact Hb].
  apply Rmult_le_compat_r; [exact (bounded_nonneg M J _ _ _ HQ j) | exact HK].
Qed.

Lemma Rabs_le_inv x a : Rabs x <= a -> - a <= x <= a. Proof. unfold Rabs; destruct Rcase_abs; lra. Qed.
Lemma within_zero_eq N x x' : within N 0 (minus x x') -> forall i, (i < N)%nat -> x i = x' i.
Proof. intros H i Hi; apply Rminus_diag_uniq, Rabs_zero, (H i Hi). Qed.

Lemma signed s e mu q kappa : 0 < sgn s * (e * mu) -> kappa <= sgn s * q -> Rabs e * Rabs mu * kappa <= e * mu * q.
Proof.
  intros H Hq; rewrite <- Rabs_mult.
  replace (Rabs (e * mu)) with (sgn s * (e * mu)) by (destruct s; cbn [sgn] in *; [rewrite Rabs_pos_eq | rewrite
    Rabs_left]; lra).
  apply (Rmult_le_compat_l _ _ _ (Rlt_le _ _ H)) in Hq.
  replace (e * mu * q) with (sgn s * (e * mu) * (sgn s * q)); [exact Hq | destruct s; cbn; ring].
Qed.

Section Uniform.
Variables (M : Map.t) (w : vec) (e K : R) (n_max : nat).
Hypothesis HM : smooth M.
Hypothesis Hw : forall i, (i < N M)%nat -> w i = mult (N M) (A M) w i + phi M i.
Hypothesis He : e = dot (N M) (C M) w + eta M.
Hypothesis HK : 1 <= K.
Notation N := (N M).
Notation eps0 := (/ (2 * K)).

(** d1 for the fixed point, d for the orbits. *)
Variables (d1 d l : R).
Hypothesis Hd1 : 0 < d1.
Hypothesis Hrem : remainder M w e n_max eps0 d1.
Hypothesis Hd : 0 < d <= d1.
Hypothesis Hl : 1 <= l /\ l * d <= d1 * d1.
Hypothesis Hfly : forall k x x' mu mu' t, (k <= n_max)%nat -> within N d x -> within N d x' -> Rabs mu <= d ->
  Rabs mu' <= d -> within N t (minus x x') -> Rabs (mu - mu') <= t -> Rabs (h M (fly M mu k x) mu - h M (fly M mu' k x')
  mu') <= l * t.

(** An orbit within d is a solution within d1. *)
Lemma orbit_bounded J (next : J -> J) n mu x : (forall j, 1 <= n j <= n_max)%nat -> Rabs mu <= d ->
  orbit_near M J next n mu d x -> bounded M J d1 x (speed M mu J n x).
Proof.
  intros Hn Hmu Hx j; destruct (Hx j) as (Hxd & _).
  destruct (orbit_zero M mu J next n (fun j => proj1 (Hn j)) d x Hx) as [Hz Hs].
  destruct (proj1 (zero_meaning M mu J next n x _) Hz j) as [E _], (Hs j) as [Hy _].
  split; [apply within_le with d; [apply Hd | exact Hxd]|].
  rewrite Rabs_pos_eq by lra; set (y := speed M mu J n x j) in *.
  assert (Hyy : y * y <= d1 * d1).
  { apply Rle_trans with (l * d); [|apply Hl].
    pose proof (Hfly (n j) (x j) zero mu 0 d) as H; rewrite (height_zero M w e HM Hw He) in H.
    rewrite !Rminus_0_r, E, Rabs_Ropp in H; eapply Rle_trans; [apply Rle_abs|].
    apply H; trivial; rewrite ?Rabs_R0; try lra; try apply Hn; [apply within_zero; lra|].
    intros i Hi; unfold minus, zero; rewrite Rminus_0_r; apply Hxd, Hi. }
  apply Rnot_lt_le; intros Hlt. assert (d1 * d1 < y * y) by (apply Rmult_gt_0_lt_compat; lra); lra.
Qed.

(** Two zeros that are the same as a third are the same. *)
Lemma same_zero J x1 y1 x y x' y' : bounded M J 0 (diff J x1 x') (diff1 J y1 y') ->
  bounded M J 0 (diff J x1 x) (diff1 J y1 y) -> bounded M J 0 (diff J x x') (diff1 J y y').
Proof.
  intros H1 H2 j; destruct (H1 j) as [H1x H1y], (H2 j) as [H2x H2y]; unfold diff, diff1 in *; split.
  - intros i Hi; specialize (H1x i Hi); specialize (H2x i Hi); unfold minus in *.
    apply Rabs_zero in H1x, H2x; replace (x j i - x' j i) with 0 by lra; rewrite Rabs_R0; lra.
  - apply Rabs_zero in H1y, H2y; replace (y j - y' j) with 0 by lra; rewrite Rabs_R0; lra.
Qed.

(** The solution of the linear problem, moved to w, is bounded. *)
Lemma start_bounded J (next : J -> J) n X Y W : 0 <= W -> within N W w -> invertible M J next n K ->
  solution M J next n X Y -> bounded M J (1 + W + Rabs e * K) (fun j => comb 1 e w (X j)) (fun j => e * Y j).
Proof.
  intros HW Hwb HInv [[E HE] HXl]; assert (HeK : 0 <= Rabs e * K) by (apply Rmult_le_pos; [apply Rabs_pos | lra]).
  assert (HXK : bounded M J (K * 1) X Y).
  { apply (inverse_bound M J next n K HInv E 1 X Y _ _ HE HXl).
    intros j; split; [apply within_zero; lra | change (Rabs (-1) <= 1); rewrite Rabs_left; lra]. }
  intros j; destruct (HXK j) as [HXj HYj]; split.
  - apply within_le with (Rabs 1 * W + Rabs e * (K * 1)); [|apply within_comb; assumption]. rewrite Rabs_R1; lra.
  - apply Rle_trans with (Rabs e * (K * 1)); [apply Rabs_mult_le; lra | lra].
Qed.

(** The heights on the way, where x is within err of its linear part. *)
Lemma heights_near eps' d' mc m k x X mu r err : remainder M w e n_max eps' d' -> (k <= n_max)%nat -> 0 < d' ->
  (forall t y, within N t y -> Rabs (dot N (C M) y) <= mc * t) -> (forall t y, 0 <= t -> within N t y ->
  within N (m * t) (power M k y)) -> within N d' x -> within N r x -> Rabs mu <= r -> Rabs mu <= d' -> 0 <= err ->
  within N err (minus x (comb mu (e * mu) w X)) ->
  Rabs (h M (fly M mu k x) mu - e * mu * (dot N (C M) (power M k X) + 1)) <= eps' * r + mc * (m * err).
Proof.
  intros Hrem' Hk Hd' Hc Hpow Hxd Hx Hmu Hmud Herr Hlin; pose proof (Rabs_pos mu) as Hmu0.
  destruct (Hrem' k x zero 0 0 mu 0 r) as (_ & _ & Hh); rewrite ?Rminus_0_r, ?Rabs_R0; trivial; try lra; try (apply
    within_zero; lra).
  { intros i Hi; unfold minus, zero; rewrite Rminus_0_r; apply Hx, Hi. }
  rewrite (height_zero M w e HM Hw He), !Rminus_0_r in Hh.
  assert (Ez : dot N (C M) (power M k (minus x zero)) = dot N (C M) (power M k x)).
  { unfold power; rewrite power_minus, power_zero, dot_minus, dot_zero; ring. }
  rewrite Ez in Hh; set (v := minus x (comb mu (e * mu) w X)) in *.
  assert (Hv : Rabs (dot N (C M) (power M k v)) <= mc * (m * err)) by (apply Hc, Hpow; assumption).
  assert (Ev : dot N (C M) (power M k v) = dot N (C M) (power M k x) - (mu * dot N (C M) (power M k w) + e * mu * dot N
    (C M) (power M k X))).
  { unfold v, power; rewrite power_minus, power_comb, dot_minus, dot_comb; ring. }
  replace (h M (fly M mu k x) mu - e * mu * (dot N (C M) (power M k X) + 1)) with ((h M (fly M mu k x) mu - dot N (C M)
    (power M k x) - mu * (e - dot N (C M) (power M k w))) + dot N (C M) (power M k v)) by (rewrite Ev; ring).
  apply triangle2; assumption.
Qed.

Lemma close eps : 0 < eps -> exists mu1, 0 < mu1 <= d /\ forall (J : Type) (next : J -> J) n X Y mu,
  (forall j, 1 <= n j <= n_max)%nat -> invertible M J next n K -> solution M J next n X Y -> Rabs mu < mu1 ->
  exists x y, (forall j, within N d (x j)) /\ zero_at M J next n mu x y /\ (forall x' y', bounded M J d1 x' y' ->
  zero_at M J next n mu x' y' -> bounded M J 0 (diff J x x') (diff1 J y y')) /\
  (forall j, within N (eps * Rabs mu) (fun i => x j i - mu * w i - e * mu * X j i) /\ Rabs (y j - e * mu * Y j) <= eps
  * Rabs mu /\ forall k, (k <= n_max)%nat -> Rabs (h M (fly M mu k (x j)) mu - e * mu * (dot N (C M) (power M k (X j))
  + 1)) <= eps * Rabs mu).
Proof.
  intros Heps; destruct (within_exists N w) as (W & HW & Hwb).
  destruct (power_bound N (A M) n_max) as (m & Hm & Hpow), (dot_bound N (C M)) as (mc & Hmc & Hc).
  assert (HeK : 0 <= Rabs e * K) by (apply Rmult_le_pos; [apply Rabs_pos | lra]).
  set (M0 := 1 + W + Rabs e * K); assert (HM0 : 1 <= M0) by (unfold M0; lra).
  assert (Hmcm : 0 <= mc * m) by (apply Rmult_le_pos; lra).
  assert (HmcmK : 0 <= mc * m * K) by (apply Rmult_le_pos; lra). set (c := 2 * M0 * (1 + K + mc * m * K)).
  assert (Hc0 : 0 < c) by (apply Rmult_lt_0_compat; lra). assert (Heps0 : 0 < eps0) by (apply Rinv_0_lt_compat; lra).
  set (eps' := Rmin eps0 (eps / c)).
  assert (He1 : 0 < eps') by (apply Rmin_glb_lt; [exact Heps0 | apply Rdiv_lt_0_compat; lra]).
  assert (He2 : c * eps' <= eps).
  { apply Rle_trans with (c * (eps / c)); [apply Rmult_le_compat_l; [lra | apply Rmin_r]|]. right; field; lra. }
  assert (HK0 : K * eps0 = / 2) by (field; lra).
  assert (HKe : K * eps' <= / 2) by (rewrite <- HK0; apply Rmult_le_compat_l; [lra | apply Rmin_l]).
  destruct (remainder_exists M w e HM Hw He n_max eps' He1) as (d2 & Hd2 & Hrem2).
  set (d' := Rmin d1 d2); assert (Hd' : 0 < d' <= d1) by (split; [apply Rmin_glb_lt; lra | apply Rmin_l]).
  assert (Hrem' : remainder M w e n_max eps' d') by (apply remainder_down with d2; [exact Hrem2 | apply Rmin_r]).
  exists (Rmin (d' / (4 * M0)) (d / (2 * M0))). assert (Hq1 : 0 < d' / (4 * M0)) by (apply Rdiv_lt_0_compat; lra).
  assert (Hq2 : 0 < d / (2 * M0)) by (apply Rdiv_lt_0_compat; lra).
  split.
  { split; [apply Rmin_glb_lt; assumption|]; eapply Rle_trans; [apply Rmin_r|]. apply (Rmult_le_reg_r (2 * M0)); [lra|].
    replace (d / (2 * M0) * (2 * M0)) with (d * 1) by (field; lra); apply Rmult_le_compat_l; lra. }
  intros J next n X Y mu Hn HInv HX Hmu.
  assert (Hmu1 : 4 * M0 * Rabs mu <= d').
  { replace d' with (4 * M0 * (d' / (4 * M0))) by (field; lra); apply Rmult_le_compat_l; [lra|].
    left; eapply Rlt_le_trans; [exact Hmu | apply Rmin_l]. }
  assert (Hmu2 : 2 * M0 * Rabs mu <= d).
  { replace d with (2 * M0 * (d / (2 * M0))) by (field; lra); apply Rmult_le_compat_l; [lra|].
    left; eapply Rlt_le_trans; [exact Hmu | apply Rmin_r]. }
  pose proof (start_bounded J next n X Y W HW Hwb HInv HX : bounded M J M0 _ _) as HXb.
  assert (Hnm : forall j, (n j <= n_max)%nat) by apply Hn.
  destruct (fixed_point M J next n K HInv w e mu eps' d' M0 n_max X Y) as (x & y & Hxd & Hz & Hlin & _); trivial;
    [split; [|split]; lra | split; [|split]; trivial; lra |].
  destruct (fixed_point M J next n K HInv w e mu eps0 d1 M0 n_max X Y) as (x1 & y1 & _ & _ & _ & Huniq); trivial;
    [split; [|split]; lra | split; [|split]; trivial; lra |].
  pose proof (Rabs_pos mu) as Hmu0. set (err := 2 * (K * (eps' * (M0 * Rabs mu)))) in *.
  assert (HM0mu : 0 <= M0 * Rabs mu) by (apply Rmult_le_pos; lra).
  assert (Hmu3 : Rabs mu <= M0 * Rabs mu) by (rewrite <- (Rmult_1_l (Rabs mu)) at 1; apply Rmult_le_compat_r; lra).
  assert (Herr1 : err <= M0 * Rabs mu).
  { unfold err; replace (2 * (K * (eps' * (M0 * Rabs mu)))) with (2 * (K * eps') * (M0 * Rabs mu)) by ring.
    rewrite <- (Rmult_1_l (M0 * Rabs mu)) at 2; apply Rmult_le_compat_r; lra. }
  assert (Hbudget : forall a, 0 <= a <= c -> a * eps' * Rabs mu <= eps * Rabs mu).
  { intros a Ha; apply Rmult_le_compat_r; [exact Hmu0|].
    apply Rle_trans with (c * eps'); [apply Rmult_le_compat_r; lra | exact He2]. }
  assert (Hpos : 0 <= M0 * K /\ 0 <= M0 * (mc * m * K)) by (split; apply Rmult_le_pos; lra).
  assert (Herr2 : err <= eps * Rabs mu).
  { replace err with (2 * M0 * K * eps' * Rabs mu) by (unfold err; ring); apply Hbudget; unfold c; lra. }
  assert (Hxs : bounded M J (2 * M0 * Rabs mu) x y).
  { apply (bounded_le M J (err + M0 * Rabs mu)); [lra|]. apply (bounded_plus M J _ _ _ _ _ _ Hlin).
    apply (lin_bounded M J w e mu d' M0 X Y); split; [|split]; trivial; lra. }
  exists x, y; split; [|split; [exact Hz | split]].
  - intros j; apply within_le with (2 * M0 * Rabs mu); [lra | apply Hxs].
  - intros x' y' Hb' Hz'; pose proof (Huniq x' y' Hb' Hz') as H1.
    pose proof (Huniq x y (bounded_le M J _ _ _ _ (proj2 Hd') Hxd) Hz) as H2. exact (same_zero J x1 y1 x y x' y' H1 H2).
  - intros j; destruct (Hlin j) as [Hlx Hly]; split; [|split].
    + intros i Hi; replace (x j i - mu * w i - e * mu * X j i) with (diff J x (x_lin J w e mu X) j i) by (unfold diff,
        minus, x_lin, comb; ring).
      eapply Rle_trans; [apply Hlx, Hi | exact Herr2].
    + eapply Rle_trans; [exact Hly | exact Herr2].
    + intros k Hk; destruct (Hxs j) as [Hxj _]; destruct (Hxd j) as [Hxdj _].
      apply Rle_trans with (eps' * (2 * M0 * Rabs mu) + mc * (m * err)).
      { apply (heights_near eps' d' mc m k (x j) (X j) mu (2 * M0 * Rabs mu) err); trivial; try lra; [intros t0 z0 Ht0
          Hz0; apply Hpow; trivial | exact (Rabs_nonneg _ _ Hly)]. }
      replace (eps' * (2 * M0 * Rabs mu) + mc * (m * err)) with (2 * M0 * (1 + mc * m * K) * eps' * Rabs mu) by (unfold
        err; ring).
      apply Hbudget; unfold c; lra.
Qed.
Lemma signs_decide : e <> 0 -> decided M e K n_max d.
Proof.
  intros He0. intros kappa Hkappa; assert (Hae : 0 < Rabs e) by (apply Rabs_pos_lt, He0).
  destruct (close (Rabs e * kappa / 2)) as (mu1 & Hmu1 & H).
  { apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra. }
  exists (Rabs e * mu1); split; [apply Rmult_lt_0_compat; lra|]. intros J next n X Y s mu Hn HInv HX [Hs Hsmu].
  assert (Hmu : 0 < Rabs mu < mu1).
  { split.
    - apply Rabs_pos_lt; intros ->; rewrite !Rmult_0_r in Hs; lra.
    - apply (Rmult_lt_reg_l (Rabs e)); [exact Hae|]; rewrite <- Rabs_mult.
      replace (Rabs (e * mu)) with (sgn s * (e * mu)); [exact Hsmu|].
      destruct s; cbn [sgn] in *; [rewrite Rabs_pos_eq | rewrite Rabs_left]; lra. }
  assert (Hkm : 0 < Rabs e * Rabs mu * kappa) by (repeat apply Rmult_lt_0_compat; lra).
  destruct (H J next n X Y mu Hn HInv HX (proj2 Hmu)) as (x & y & Hxd & Hz & Huniq & Hest).
  assert (Hsame : forall x', orbit_near M J next n mu d x' -> bounded M J 0 (diff J x x') (diff1 J y (speed M mu J n
    x'))).
  { intros x' Hx'; apply Huniq; [apply (orbit_bounded J next n mu x'); trivial; lra|].
    apply (orbit_zero M mu J next n (fun j => proj1 (Hn j)) d x' Hx'). }
  assert (Hsame_hit : forall x', orbit_near M J next n mu d x' -> forall j k, (k <= n_max)%nat -> h M (fly M mu k (x j))
    mu = h M (fly M mu k (x' j)) mu).
  { intros x' Hx' j k Hk; apply Rminus_diag_uniq, Rabs_zero; rewrite <- (Rmult_0_r l); apply Hfly; trivial; try lra;
      [apply Hx' | apply (Hsame x' Hx') | unfold Rminus; rewrite Rplus_opp_r, Rabs_R0; lra]. }
  split.
  + intros Hq; set (q := Rabs e * Rabs mu * kappa) in *.
    assert (Big : forall j, q / 2 <= y j /\ forall k, (1 <= k < n j)%nat -> q / 2 <= h M (fly M mu k (x j)) mu).
    { intros j; destruct (Hest j) as (_ & Hy & Hh); split.
      - pose proof (signed s e mu (Y j) kappa Hs (Rge_le _ _ (Hq j _ (or_introl eq_refl)))).
        apply Rabs_le_inv in Hy; unfold q in *; lra.
      - intros k Hk; specialize (Hh k ltac:(specialize (Hn j); lia)).
        pose proof (signed s e mu _ kappa Hs (Rge_le _ _ (Hq j _ (or_intror (ex_intro _ k (conj Hk eq_refl)))))).
        apply Rabs_le_inv in Hh; unfold q in *; lra. }
    exists x; split.
    * apply (zero_orbit M mu J next n (fun j => proj1 (Hn j)) d x y Hxd Hz); intros j; destruct (Big j) as [By Bh].
      split; [lra|]; intros k Hk; specialize (Bh k Hk); lra.
    * intros x' Hx'; split; [intros j i Hi; symmetry; apply (within_zero_eq _ _ _ (proj1 (Hsame x' Hx' j)) i Hi)|].
      assert (Hqq : 0 < q / 2 * (q / 2)) by (apply Rmult_lt_0_compat; lra).
      exists (Rmin (q / 2) (q / 2 * (q / 2))); split; [apply Rmin_glb_lt; lra|]; intros j; destruct (Big j) as [By Bh].
      destruct (Hsame x' Hx' j) as [_ Hyy], (orbit_zero M mu J next n (fun j => proj1 (Hn j)) d x' Hx') as [Hz' _];
        split.
      -- intros k Hk; apply Rle_trans with (q / 2); [apply Rmin_l|]; rewrite <- (Hsame_hit x' Hx' j k); [apply Bh, Hk |
         specialize (Hn j); lia].
      -- destruct (proj1 (zero_meaning M mu J next n x' (speed M mu J n x')) Hz' j) as [-> _].
         apply Rabs_zero in Hyy; unfold diff1 in Hyy; replace (speed M mu J n x' j) with (y j) by lra.
         apply Ropp_le_contravar, Rle_trans with (1 := Rmin_r _ _), Rmult_le_compat; lra.
  + intros j v Hv Hvk x' Hx'; destruct (Hsame x' Hx' j) as [_ Hyy].
    destruct (orbit_zero M mu J next n (fun j => proj1 (Hn j)) d x' Hx') as [_ Hsigns].
    destruct (Hsigns j) as [Hy' Hh'], (Hest j) as (_ & Hy & Hh). destruct Hv as [->|(k & Hk & ->)].
    * assert (E : kappa <= sgn s * - Y j) by lra; apply (signed s e mu) in E; [|exact Hs].
      apply Rabs_zero in Hyy; unfold diff1 in Hyy; apply Rabs_le_inv in Hy; lra.
    * set (q := dot N (C M) (power M k (X j)) + 1) in *.
      assert (E : kappa <= sgn s * - q) by lra; apply (signed s e mu) in E; [|exact Hs].
      specialize (Hh' k Hk); specialize (Hh k ltac:(specialize (Hn j); lia)).
      rewrite (Hsame_hit x' Hx' j k) in Hh by (specialize (Hn j); lia); fold q in Hh; apply Rabs_le_inv in Hh; lra.
Qed.

Lemma leading : leads M w e K n_max d.
Proof.
  intros eps Heps; destruct (close eps Heps) as (mu1 & Hmu1 & H).
  exists mu1; split; [lra|]; intros J next n X Y mu x' Hn HInv HX Hmu Hx' j.
  destruct (H J next n X Y mu Hn HInv HX (proj2 Hmu)) as (x & y & Hxd & Hz & Huniq & Hest).
  destruct (orbit_zero M mu J next n (fun j => proj1 (Hn j)) d x' Hx') as [Hz' _].
  assert (Hb' : bounded M J d1 x' (speed M mu J n x')) by (apply (orbit_bounded J next n mu x'); trivial; lra).
  destruct (Huniq x' _ Hb' Hz' j) as [Hxx Hyy], (Hest j) as (Hx & Hy & _); split.
  + intros i Hi; rewrite <- (within_zero_eq _ _ _ Hxx i Hi); apply Hx, Hi.
  + apply Rabs_zero in Hyy; unfold diff1 in Hyy.
    change (sqrt (- height M mu (x' j) (n j - 1))) with (speed M mu J n x' j).
    replace (speed M mu J n x' j) with (y j) by lra; exact Hy.
Qed.
End Uniform.

Theorem Theorem1_clear M w e : smooth M -> (forall i, (i < N M)%nat -> w i = mult (N M) (A M) w i + phi M i) ->
  e = dot (N M) (C M) w + eta M -> e <> 0 -> forall n_max K, exists d, d > 0 /\ decided M e K n_max d /\
  leads M w e K n_max d.
Proof.
  intros HM Hw He He0 n_max K.
  set (K1 := Rmax K 1); assert (HK1 : 1 <= K1) by apply Rmax_r; assert (HK : K <= K1) by apply Rmax_l.
  assert (Heps0 : 0 < / (2 * K1)) by (apply Rinv_0_lt_compat; lra).
  destruct (remainder_exists M w e HM Hw He n_max _ Heps0) as (d1 & Hd1 & Hrem).
  destruct (Lipschitz_fly M w e HM Hw He n_max) as (l & dl & Hl & Hdl & Hfly).
  set (d := Rmin (Rmin d1 dl) (d1 * d1 / l)).
  assert (Hd : 0 < d /\ d <= d1 /\ d <= dl /\ l * d <= d1 * d1).
  { assert (0 < d1 * d1 / l) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
    split; [repeat apply Rmin_glb_lt; lra|]; split; [|split].
    - eapply Rle_trans; [apply Rmin_l | apply Rmin_l].
    - eapply Rle_trans; [apply Rmin_l | apply Rmin_r].
    - replace (d1 * d1) with (l * (d1 * d1 / l)) by (field; lra). apply Rmult_le_compat_l; [lra | apply Rmin_r]. }
  assert (HflyC : forall k x x' mu mu' t, (k <= n_max)%nat -> within (N M) d x -> within (N M) d x' -> Rabs mu <= d ->
    Rabs mu' <= d -> within (N M) t (minus x x') -> Rabs (mu - mu') <= t -> Rabs (h M (fly M mu k x) mu - h M (fly M mu'
    k x') mu') <= l * t).
  { intros k x x' mu mu' t Hk Hx Hx' Hmu Hmu' Ht Hmt; apply (Hfly k x x' mu mu' t); trivial; try lra; apply within_le
      with d; trivial; lra. }
  assert (Hd12 : 0 < d <= d1) by lra; assert (Hll : 1 <= l /\ l * d <= d1 * d1) by lra. exists d; split; [lra | split].
  - intros kappa Hkappa; destruct (signs_decide M w e K1 n_max HM Hw He HK1 d1 d l Hd1 Hrem Hd12 Hll HflyC He0 kappa
      Hkappa) as (mu0 & Hmu0 & H); exists mu0; split; [exact Hmu0|]; intros J next n X Y s mu Hn HInv.
    apply H; [exact Hn | exact (invertible_up _ _ _ _ _ _ HK HInv)].
  - intros eps Heps; destruct (leading M w e K1 n_max HM Hw He HK1 d1 d l Hd1 Hrem Hd12 Hll HflyC eps Heps) as (mu1 &
      Hmu1 & H); exists mu1; split; [exact Hmu1|]; intros J next n X Y mu x Hn HInv.
    apply H; [exact Hn | exact (invertible_up _ _ _ _ _ _ HK HInv)].
Qed.
Theorem Theorem1 : Theorem1_statement.
Proof.
  intros M w e HM Hw He He0 n_max K; destruct (Theorem1_clear M w e HM Hw He He0 n_max K) as (d & Hd & H & L); exists d.
  split; [exact Hd | split; [|exact L]]; intros kappa Hk; destruct (H kappa Hk) as (mu0 & Hm & W); exists mu0; split;
    [exact Hm|]; intros J next n X Y s mu Hn HI HX Hmu; destruct (W J next n X Y s mu Hn HI HX Hmu) as [Ex No]; split;
    [|exact No]. intros Hq; destruct (Ex Hq) as (x & Hx & Only); exists x; split; [exact Hx | apply Only].
Qed.
