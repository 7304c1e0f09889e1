(** * What follows, worked out by hand, from the definitions and statements at resonance *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs Statement StatementOrbits StatementOrbitsPlane StatementPlane StatementAttractor.
From Grazing Require Import StatementOscillator StatementNordmark StatementUnstable StatementResonance.
From Grazing Require Import StatementMultipliers Derivatives Nordmark.
Open Scope R_scope.

(** ** What the definitions say *)
Lemma once_means O mu d t y v : once O 3 mu d t y v -> motion O Plus mu d (fun i => 3 * i)%Z t y v /\
  t 2%Z = t 0%Z + 12 * PI /\ y 2%Z (1 + 12 * PI) = y 0%Z 1 /\ v 2%Z (1 + 12 * PI) = v 0%Z 1.
Proof.
  intros [Hm Ha]; split; [exact Hm|]; destruct (Ha 2%Z 1) as (E1 & E2 & E3); cbn [INR] in E1, E2, E3.
  replace (2 * PI * (1 + 1 + 1) * 2) with (12 * PI) in E1, E2, E3 by ring; auto.
Qed.
Lemma once_is O n mu d t y v : motion O Plus mu d (fun i => Z.of_nat n * i)%Z t y v ->
  (forall i x, t i = t 0%Z + 2 * PI * INR n * IZR i /\ y i (x + 2 * PI * INR n * IZR i) = y 0%Z x /\
    v i (x + 2 * PI * INR n * IZR i) = v 0%Z x) -> once O n mu d t y v.
Proof. intros H H'; constructor; [exact H | exact H']. Qed.
Lemma next_means O mu s w s' w' : next_impact O 3 mu (s, w) (s', w') -> exists t y v, t 0%Z = s /\ v 0%Z s = w /\
  free (Oscillator.c O) (Oscillator.k O) (y 0%Z) (v 0%Z) /\ t 1%Z = s' + 6 * PI /\ v 1%Z (t 1%Z) = w' /\
  (forall x, s < x < t 1%Z -> 0 < gap O Plus mu 0 (y 0%Z) x) /\ gap O Plus mu 3 (y 0%Z) (t 1%Z) = 0.
Proof.
  intros (d & t & y & v & [A B C D E F G H] & E1 & E2); injection E1 as -> ->; injection E2 as -> ->.
  exists t, y, v; split; [reflexivity|]; split; [reflexivity|]; split; [exact A|]; split; [cbn [INR]; ring|].
  split; [reflexivity|]; split; [intros x; exact (F 0%Z x) | exact E].
Qed.

(** ** The paper's oscillator of section 4.1 without damping: w = 6 is s = 1/6, w = 3 is s = 1/3. Its stop is at
    (1 + nu) cos t - 1 *)
Notation paper := (Nordmark 0).
Lemma any_paper d w tau : any_stop (Nordmark d w tau).
Proof.
  constructor; [exact (period _ (Nordmark_touching d w tau)) | exact (slope _ (Nordmark_touching d w tau)) | exact (bend
    _ (Nordmark_touching d w tau))].
Qed.
Lemma omega_is d w tau o : 0 < w -> 0 < o -> o ^ 2 = (1 - d ^ 2) / w ^ 2 -> omega (Nordmark d w tau) = o.
Proof.
  intros Hw Ho E; unfold omega; cbn [Nordmark Oscillator.c Oscillator.k]; rewrite <- (sqrt_square o) by lra; f_equal.
  replace (o * o) with (o ^ 2) by ring; rewrite E; field; lra.
Qed.
Lemma at_resonance d w tau o n m : 0 < w -> 0 < o -> o ^ 2 = (1 - d ^ 2) / w ^ 2 -> 0 <= d -> 0 <= tau <= 1 ->
  INR n * (2 * o) = INR m -> (1 <= n)%nat -> resonant (Nordmark d w tau) n m.
Proof.
  intros Hw Ho E Hd Ht A Hn; pose proof (omega_is d w tau o Hw Ho E) as Eo.
  assert (C1 : 0 <= Oscillator.c (Nordmark d w tau)).
  { cbn; apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat, Hw]. }
  assert (C2 : Oscillator.c (Nordmark d w tau) ^ 2 < 4 * Oscillator.k (Nordmark d w tau)).
  { apply Rminus_gt_0_lt; cbn [Nordmark Oscillator.c Oscillator.k].
    replace (4 * (1 / w ^ 2) - (2 * d / w) ^ 2) with (4 * ((1 - d ^ 2) / w ^ 2)) by (field; lra); rewrite <- E; nra. }
  assert (A' : INR n * (2 * PI * omega (Nordmark d w tau)) = INR m * PI) by (rewrite Eo, <- A; ring).
  constructor; [exact Hn | exact (conj C1 C2) | exact Ht | exact A'].
Qed.
Lemma q_undamped w tau n m : 0 < w -> q (paper w tau) n m = (-1) ^ m.
Proof.
  intros Hw; unfold q; cbn [Nordmark Oscillator.c]; replace (- PI * _ * INR n) with 0 by (field; lra); rewrite exp_0;
    ring.
Qed.
Lemma is_six tau : 0 <= tau <= 1 -> resonant (paper 6 tau) 3 1 /\ q (paper 6 tau) 3 1 = -1.
Proof.
  intros Ht; split; [|rewrite q_undamped by lra; ring].
  apply (at_resonance 0 6 tau (1 / 6)); cbn [INR]; try lra; lia.
Qed.
Lemma is_regular w tau n m : 0 < w -> (-1) ^ m = -1 -> tau < 1 -> regular (paper w tau) n m.
Proof.
  intros Hw E Ht; unfold regular; rewrite q_undamped, E by exact Hw; cbn [Nordmark Oscillator.tau].
  assert (A : -1 <> 1) by lra; assert (B : tau * -1 <> -1) by lra; exact (conj A B).
Qed.
Lemma not_regular w tau n m : regular (paper w tau) n m -> 0 < w -> (-1) ^ m = -1 -> tau <> 1 /\ -1 <> 1.
Proof.
  intros [A B] Hw E; rewrite q_undamped, E in A, B by exact Hw; cbn [Nordmark Oscillator.tau] in B; split; [|exact A].
  intros ->; apply B; ring.
Qed.
Lemma stop_is d w tau nu t : stop (Nordmark d w tau) (- nu) t = (1 + nu) * cos t - 1 /\
  stop1 (Nordmark d w tau) (- nu) t = - (1 + nu) * sin t.
Proof. unfold stop, stop1; cbn; split; ring. Qed.

(** V^2 = (1 + rho)^2 (2 nu + nu^2) / (1 - tau rho)^2; here rho = 1 and tau = 1/2. *)
Lemma period_3 : Exact_statement -> forall nu d, 0 < nu ->
  (forall t y v, once (paper 6 (1 / 2)) 3 (- nu) d t y v -> let V := speed (paper 6 (1 / 2)) Plus (- nu) 0 (v 4%Z) (t
    5%Z) in
   cos (t 0%Z) = / (1 + nu) /\ sin (t 0%Z) < 0 /\ V ^ 2 = 16 * (2 * nu + nu ^ 2) /\ V < 0 /\
   y 4%Z (t 4%Z + PI) = - 18 * (1 + nu) * sin (t 0%Z) * sin (PI / 6)) /\
  forall t0, Rabs t0 <= d -> cos t0 = / (1 + nu) -> sin t0 < 0 ->
  (forall s, 0 < s < 6 * PI -> (1 + nu) * cos (t0 + s) - 1 < - 18 * (1 + nu) * sin t0 * sin (s / 6)) ->
  exists t y v, once (paper 6 (1 / 2)) 3 (- nu) d t y v /\ t 0%Z = t0.
Proof.
  intros S nu d Hnu; destruct (is_six (1 / 2) ltac:(lra)) as [HR Eq].
  assert (HN : regular (paper 6 (1 / 2)) 3 1) by (apply is_regular; cbn; lra).
  destruct (S _ 3%nat 1%nat (- nu) d (any_paper 0 6 (1 / 2)) HR) as [Iff Arc _ _]; specialize (Iff HN); specialize (Arc
    HN). assert (Eo : omega (paper 6 (1 / 2)) = 1 / 6) by (apply (omega_is 0 6 (1 / 2)); lra).
  assert (Ea : forall t0 s, arc (paper 6 (1 / 2)) (after (paper 6 (1 / 2)) 3 1 (- nu) t0) s = - 18 * (1 + nu) * sin t0 *
    sin (s / 6)).
  { intros t0 s; unfold arc, after; rewrite Eq, Eo, (proj2 (stop_is 0 6 (1 / 2) nu t0)); cbn [Nordmark Oscillator.c
      Oscillator.tau]; replace (- (2 * 0 / 6) / 2 * s) with 0 by field; rewrite exp_0.
    replace (1 / 6 * s) with (s / 6) by field; field. } split.
  - intros t y v H V; destruct (proj1 (Iff (t 0%Z)) (ex_intro _ t (ex_intro _ y (ex_intro _ v (conj H eq_refl))))) as (_
      & Z & P & _); rewrite (proj1 (stop_is _ _ _ _ _)) in Z; rewrite (proj2 (stop_is _ _ _ _ _)) in P.
    destruct (Arc t y v H 4%Z) as [EV Ey]; change (4 + 1)%Z with 5%Z in EV; fold V in EV.
    rewrite Eq, (proj2 (stop_is _ _ _ _ _)) in EV; cbn [Nordmark Oscillator.tau] in EV.
    assert (EV' : V = 4 * (1 + nu) * sin (t 0%Z)) by (rewrite EV; field).
    assert (C : (1 + nu) * cos (t 0%Z) = 1) by lra; pose proof (sin2_cos2 (t 0%Z)) as T; unfold Rsqr in T.
    split; [apply (Rmult_eq_reg_l (1 + nu)); [rewrite C; field|]; lra|]; split; [nra|]; split; [|split; [rewrite EV';
      nra|]].
    + rewrite EV'; set (c := cos (t 0%Z)) in *; set (s := sin (t 0%Z)) in *.
      transitivity (16 * ((1 + nu) ^ 2 * (s * s + c * c) - ((1 + nu) * c) ^ 2)); [ring | rewrite T, C; ring].
    + rewrite Ey, Ea; reflexivity.
  - intros t0 D C Sn Cl; apply Iff; rewrite (proj1 (stop_is _ _ _ _ _)), (proj2 (stop_is _ _ _ _ _)), C.
    split; [exact D|]; split; [field; lra|]; split; [nra|]; intros s Hs; cbn [INR] in Hs.
    rewrite (proj1 (stop_is _ _ _ _ _)), Ea; apply Cl; lra.
Qed.
(** Without damping: no motion with m even; nor with m odd and tau = 1, as the stop has no double zero. *)
Lemma no_motion : Exact_statement -> forall nu d t y v, ~ once (paper 3 (1 / 2)) 3 (- nu) d t y v /\
  (0 < nu -> ~ once (paper 6 1) 3 (- nu) d t y v).
Proof.
  intros S nu d t y v; split.
  - assert (HR : resonant (paper 3 (1 / 2)) 3 2) by (apply (at_resonance 0 3 (1 / 2) (1 / 3)); cbn [INR]; try lra;
    lia). destruct (S _ 3%nat 2%nat (- nu) d (any_paper 0 3 (1 / 2)) HR) as [_ _ E _].
    apply E; rewrite q_undamped by lra; ring.
  - intros Hnu H; destruct (is_six 1 ltac:(lra)) as [HR Eq].
    destruct (S _ 3%nat 1%nat (- nu) d (any_paper 0 6 1) HR) as [_ _ _ E].
    destruct (E ltac:(rewrite Eq; cbn; ring) t y v H) as [Z Z1]; rewrite (proj1 (stop_is _ _ _ _ _)) in Z.
    rewrite (proj2 (stop_is _ _ _ _ _)) in Z1; pose proof (sin2_cos2 (t 0%Z)) as T; unfold Rsqr in T.
    assert (sin (t 0%Z) = 0) as X by nra; rewrite X in T; assert (cos (t 0%Z) <= 1) by apply COS_bound.
    assert ((cos (t 0%Z) - 1) * (cos (t 0%Z) + 1) = 0) by lra; nra.
Qed.

(** Both multipliers of that motion are 1/2, and those near it come to it. *)
Lemma half : Multipliers_statement -> forall nu d t y v, once (paper 6 (1 / 2)) 3 (- nu) d t y v ->
  let z := (t 0%Z, v 0%Z (t 0%Z)) in exists F e, F z = z /\ derivative F z (Mat (1 / 2) 0 e (1 / 2)) /\
  exists r, 0 < r /\ forall z', norm (sub z' z) <= r -> next_impact (paper 6 (1 / 2)) 3 (- nu) z' (F z').
Proof.
  intros S nu d t y v H z; destruct (is_six (1 / 2) ltac:(lra)) as [HR Eq].
  destruct (S _ 3%nat 1%nat (- nu) d t y v (any_paper 0 6 (1 / 2)) HR) as (F & e & [N Fx D]); [apply is_regular; cbn;
    lra | cbn; lra | exact H|]. exists F, e; split; [exact Fx|]; split; [|exact N].
  rewrite Eq in D; cbn [Nordmark Oscillator.tau] in D; replace (- (1 / 2) * -1) with (1 / 2) in D by field; exact D.
Qed.
Lemma attracts : Stable_statement -> forall nu t y v, once (paper 6 (1 / 2)) 3 (- nu) 1 t y v ->
  exists delta, 0 < delta /\ forall s w, t 0%Z - delta <= s <= t 0%Z + delta ->
  v 0%Z (t 0%Z) - delta <= w <= v 0%Z (t 0%Z) + delta -> exists t' y' v',
  forward (paper 6 (1 / 2)) 3 (- nu) 2 t' y' v' /\ t' 0%Z = s /\ v' 0%Z s = w /\
  t 7%Z - 1 <= t' 7%Z <= t 7%Z + 1 /\ Rabs (v' 7%Z (t' 7%Z) - v 7%Z (t 7%Z)) <= 1 /\
  (exists K, forall i, (K <= i)%Z -> Rabs (t' i - t i) <= 1 / 1000) /\
  forall h t2 y2 v2, forward (paper 6 (1 / 2)) 3 (- nu) h t2 y2 v2 -> t2 0%Z = s -> v2 0%Z s = w ->
  t2 7%Z = t' 7%Z /\ y2 7%Z 1 = y' 7%Z 1 /\ v2 7%Z 1 = v' 7%Z 1.
Proof.
  intros S nu t y v H; destruct (is_six (1 / 2) ltac:(lra)) as [HR Eq].
  destruct (S _ 3%nat 1%nat (- nu) 1 t y v (any_paper 0 6 (1 / 2)) HR) with (eps := 1) as (delta & Hd & A); [apply
    is_regular; cbn; lra | cbn; lra | exact H | lra|]. exists delta; split; [exact Hd|]; intros s w Hs Hw.
  destruct (A s w) as (t' & y' & v' & Fw & E1 & E2 & Nr & Cv & Un); [apply Rabs_le; lra | apply Rabs_le; lra|].
  exists t', y', v'; replace (1 + 1) with 2 in Fw by ring; split; [exact Fw|]; split; [exact E1|]; split; [exact E2|].
  destruct (Nr 7%Z ltac:(lia)) as [N1 N2]; split; [apply le_abs in N1; lra|]; split; [exact N2|]; split.
  - destruct (Cv (1 / 1000) ltac:(lra)) as (K & HK); exists K; intros i Hi; apply (HK i Hi).
  - intros h t2 y2 v2 F2 G1 G2; destruct (Un h t2 y2 v2 F2 G1 G2 7%Z 1 ltac:(lia)) as (U1 & U2 & U3); auto.
Qed.
Lemma forward_means O mu d t y v : forward O 3 mu d t y v -> t 4%Z < t 5%Z /\ gap O Plus mu 15 (y 4%Z) (t 5%Z) = 0.
Proof. intros H; destruct (H 4%Z 5%Z ltac:(lia) eq_refl) as [_ _ A _ B _ _ _]; split; [exact A | exact B]. Qed.

(** At w = 6 period 3 is born, near the touch, and it alone; at w = 3 and w = 3/2 it is not. *)
Lemma births_3 : Birth_statement -> exists mu0, 0 < mu0 /\ forall nu, 0 < nu < mu0 ->
  (exists t y v, once (paper 6 (1 / 2)) 3 (- nu) (1 / 100) t y v /\ forall t' y' v',
   once (paper 6 (1 / 2)) 3 (- nu) PI t' y' v' -> t' 5%Z = t 5%Z /\ y' 5%Z 1 = y 5%Z 1 /\ v' 5%Z 1 = v 5%Z 1) /\
  forall d t y v, ~ once (paper 6 (1 / 2)) 3 nu d t y v.
Proof.
  intros S; destruct (is_six (1 / 2) ltac:(lra)) as [HR _].
  destruct (S _ 3%nat 1%nat (Nordmark_touching 0 6 (1 / 2)) HR (1 / 100) ltac:(lra)) as (mu0 & M0 & B).
  exists mu0; split; [exact M0|]; intros nu Hnu; destruct (B nu Hnu) as [Before One _]; split; [|exact Before].
  assert (HN : regular (paper 6 (1 / 2)) 3 1) by (apply is_regular; cbn; lra).
  destruct (One (conj HN (or_intror eq_refl))) as (t & y & v & H & U); exists t, y, v; split; [exact H|].
  intros t' y' v' H'; destruct (U t' y' v' H' 5%Z 1) as (U1 & U2 & U3); auto.
Qed.
Lemma not_births : Birth_statement -> forall w m, (w = 3 /\ m = 2%nat \/ w = 3 / 2 /\ m = 4%nat \/ w = 6 / 5 /\
  m = 5%nat) ->
  exists mu0, 0 < mu0 /\ forall nu, 0 < nu < mu0 -> forall d t y v, ~ once (paper w (1 / 2)) 3 (- nu) d t y v.
Proof.
  intros S w m Hw; assert (HR : resonant (paper w (1 / 2)) 3 m).
  { destruct Hw as [[-> ->]|[[-> ->]|[-> ->]]]; [apply (at_resonance 0 3 (1 / 2) (1 / 3)) | apply (at_resonance 0 (3 /
      2) (1 / 2) (2 / 3)) | apply (at_resonance 0 (6 / 5) (1 / 2) (5 / 6))]; cbn [INR]; try lra; lia. }
  destruct (S _ 3%nat m (Nordmark_touching 0 w (1 / 2)) HR 1 ltac:(lra)) as (mu0 & M0 & B).
  exists mu0; split; [exact M0|]; intros nu Hnu; destruct (B nu Hnu) as [_ _ No]; apply No; intros [_ [N|N]]; [lia|].
  destruct Hw as [[_ ->]|[[_ ->]|[_ ->]]]; discriminate.
Qed.
(** With damping period 1 is born where theta = 2 pi, too; without, it is not, though m = 1 up to 2 n. *)
Lemma period_1 : Birth_statement -> (exists mu0, 0 < mu0 /\ forall nu, 0 < nu < mu0 ->
  exists t y v, once (Nordmark (3 / 5) (4 / 5) (1 / 2)) 1 (- nu) 1 t y v) /\
  exists mu0, 0 < mu0 /\ forall nu, 0 < nu < mu0 -> forall d t y v, ~ once (paper 2 1) 1 (- nu) d t y v.
Proof.
  intros S; split.
  - assert (HR : resonant (Nordmark (3 / 5) (4 / 5) (1 / 2)) 1 2).
    { apply (at_resonance (3 / 5) (4 / 5) (1 / 2) 1); cbn [INR]; try lra; lia. }
    destruct (S _ 1%nat 2%nat (Nordmark_touching _ _ _) HR 1 ltac:(lra)) as (mu0 & M0 & B); exists mu0; split; [exact
      M0|].
    intros nu Hnu; destruct (B nu Hnu) as [_ One _]; destruct One as (t & y & v & H & _); [|exists t, y, v; exact H].
    assert (E : 0 < q (Nordmark (3 / 5) (4 / 5) (1 / 2)) 1 2 < 1).
    { unfold q; cbn [Nordmark Oscillator.c INR]; replace (_ * exp _) with (exp (- (3 / 2 * PI))).
      - split; [apply exp_pos|]; rewrite <- exp_0; apply exp_increasing; pose proof PI_RGT_0; lra.
      - replace (- PI * (2 * (3 / 5) / (4 / 5)) * 1) with (- (3 / 2 * PI)) by field; ring. }
    assert (N1 : q (Nordmark (3 / 5) (4 / 5) (1 / 2)) 1 2 <> 1) by lra.
    assert (N2 : 1 / 2 * q (Nordmark (3 / 5) (4 / 5) (1 / 2)) 1 2 <> -1) by lra.
    exact (conj (conj N1 N2) (or_introl eq_refl)).
  - assert (HR : resonant (paper 2 1) 1 1) by (apply (at_resonance 0 2 1 (1 / 2)); cbn [INR]; try lra; lia).
    destruct (S _ 1%nat 1%nat (Nordmark_touching 0 2 1) HR 1 ltac:(lra)) as (mu0 & M0 & B).
    exists mu0; split; [exact M0|]; intros nu Hnu; destruct (B nu Hnu) as [_ _ No]; apply No; intros [N _].
    apply (not_regular 2 1 1 1) in N; [destruct N as [N _]; apply N; reflexivity | lra | ring].
Qed.

(** Maps, n = 2: one number has two signs, and the slope is - C A^2 V / e. *)
Lemma curve_2 : Curve_statement -> forall M w V rate, smooth M -> (forall i, (i < Map.N M)%nat ->
  w i = mult (Map.N M) (Map.A M) w i + Map.phi M i) -> rate = dot (Map.N M) (Map.C M) w + Map.eta M -> rate <> 0 ->
  (forall x, (forall i, (i < Map.N M)%nat -> x i = power M 2 x i) -> forall i, (i < Map.N M)%nat -> x i = 0) ->
  (forall i, (i < Map.N M)%nat -> V i = power M 2 V i + Map.B M i) -> exists d, 0 < d /\
  (across M V 1 < across M V 2 -> forall mu x, - d <= mu <= d -> ~ single M 2 mu d x) /\
  (across M V 2 < across M V 1 -> exists r, 0 < r /\ forall y, 0 < y < r -> exists mu x, - d <= mu <= d /\
   single M 2 mu d x /\ speed_of M 2 mu x = y /\ forall mu' x', - d <= mu' <= d -> single M 2 mu' d x' ->
   speed_of M 2 mu' x' = y -> mu' = mu /\ forall i, (i < Map.N M)%nat -> x' tt i = x tt i) /\
  exists r, 0 < r /\ forall mu x, Rabs mu <= d -> single M 2 mu d x -> speed_of M 2 mu x < r ->
   Rabs (mu + across M V 2 / rate * speed_of M 2 mu x) <= 1 / 10 * speed_of M 2 mu x /\ forall i, (i < Map.N M)%nat ->
   Rabs (x tt i - mu * w i - speed_of M 2 mu x * V i) <= 1 / 10 * speed_of M 2 mu x.
Proof.
  intros S M w V rate HM Hw He Ne HD HV; destruct (S M w V rate 2%nat HM Hw He Ne ltac:(lia) HD HV) as (d & Hd & [No One
    Sl]). exists d; split; [exact Hd|]; split; [|split].
  - intros L mu x Hmu; apply No; [exists 1%nat; split; [lia | exact L] | apply Rabs_le, Hmu].
  - intros L; destruct One as (r & Hr & H); [intros k Hk; replace k with 1%nat by lia; exact L|]; exists r; split;
    [exact Hr|].
    intros y Hy; destruct (H y Hy) as (mu & x & Hmu & Ho & Ey & U); exists mu, x; split; [apply le_abs, Hmu|].
    split; [exact Ho|]; split; [exact Ey|]; intros mu' x' Hmu'; apply U, Rabs_le, Hmu'.
  - destruct (Sl (1 / 10) ltac:(lra)) as (r & Hr & H); exists r; split; [exact Hr|]; intros mu x Hmu Ho Hy.
    destruct (H mu x Hmu Ho Hy) as [H1 H2]; split; [exact H1 | exact H2].
Qed.

(** In the plane: at s = 1/4, n = 4 there is none; at s = 1/8 none if gamma < 0,
  and if gamma > 0 one at each small speed. *)
Lemma no_orbits : Plane_statement -> forall M gamma rate w, (planar M (trace (1 / 2) (1 / 4)) ((1 / 2) ^ 2) gamma
  rate w \/
  planar M (trace (1 / 2) (1 / 8)) ((1 / 2) ^ 2) gamma rate w /\ gamma < 0) ->
  exists d, 0 < d /\ forall mu x, - d <= mu <= d -> ~ single M 4 mu d x.
Proof.
  intros S M gamma rate w [H|[H Hg]].
  - destruct (S M (1 / 2) (1 / 4) 4%nat 2%nat gamma rate w) as (V & d & Hd & _ & _ & _ & No); cbn [INR]; try lra;
    try lia; [exact H|]; exists d; split; [exact Hd|]; intros mu x Hm; apply No; [left; lia | apply Rabs_le, Hm].
  - destruct (S M (1 / 2) (1 / 8) 4%nat 1%nat gamma rate w) as (V & d & Hd & _ & _ & _ & No); cbn [INR]; try lra;
    try lia; [exact H|]; exists d; split; [exact Hd|]; intros mu x Hm; apply No; [right; exact Hg | apply Rabs_le, Hm].
Qed.
Lemma one_each : Plane_statement -> forall M gamma rate w, planar M (trace (1 / 2) (1 / 8)) ((1 / 2) ^ 2) gamma rate
  w ->
  0 < gamma -> exists d r, 0 < d /\ 0 < r /\ forall y, 0 < y < r -> exists mu x, single M 4 mu d x /\
  speed_of M 4 mu x = y /\ Rabs mu <= 1 / 1000 * y.
Proof.
  intros S M gamma rate w H Hg; destruct (S M (1 / 2) (1 / 8) 4%nat 1%nat gamma rate w) as (V & d & Hd & [_ One Sl] & Z
    & Pos & _); cbn [INR]; try lra; try lia; [exact H|].
  destruct One as (r & Hr & H1); [intros k Hk; rewrite Z; apply Pos; [reflexivity | exact Hg | exact Hk]|].
  destruct (Sl (1 / 1000) ltac:(lra)) as (r' & Hr' & H2).
  exists d, (Rmin r r'); split; [exact Hd|]; split; [apply Rmin_glb_lt; assumption|]; intros y [Y1 Y2].
  pose proof (Rmin_l r r'); pose proof (Rmin_r r r'); destruct (H1 y ltac:(lra)) as (mu & x & Hmu & Ho & Ey & _).
  exists mu, x; split; [exact Ho|]; split; [exact Ey|]; destruct (H2 mu x Hmu Ho) as [B _]; [lra|].
  rewrite Z, Ey in B; replace (mu + 0 / rate * y) with mu in B; [exact B | unfold Rdiv; ring].
Qed.
