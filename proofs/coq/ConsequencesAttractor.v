(** * Numbers worked out by hand that follow from the statements about what is born beyond a touch in region 2

    As in [Consequences]: each lemma takes the statement as its hypothesis. *)

From Coq Require Import Reals ZArith Arith Lra Lia.
From Grazing Require Import StatementPlane StatementAttractor AttractorDerivative.
Open Scope R_scope.

(** ** Maps: l1 = 3/4, l2 = 1/2, b = 1 *)

(** What a derivative is: of x -> 2 x the first column is 2, 0. *)
Lemma derivative_double J : derivative (scale 2) (0, 0) J -> m11 J = 2 /\ m21 J = 0.
Proof.
  intros D; assert (C : forall eps, 0 < eps -> Rabs (2 - m11 J) <= eps /\ Rabs (m21 J) <= eps).
  { intros eps He; destruct (D eps He) as (d & Hd & HD); specialize (HD (d, 0)). assert (E : norm (sub (d, 0) (0, 0))
      = d).
    { unfold norm, sub; cbn; rewrite !Rminus_0_r, Rabs_R0, Rabs_pos_eq, Rmax_left; lra. }
    rewrite E in HD; specialize (HD ltac:(lra)); apply norm_le in HD; cbn in HD; destruct HD as [A B]. replace (2 * d
      - 2 * 0 - (m11 J * (d - 0) + m12 J * (0 - 0))) with ((2 - m11 J) * d) in A by ring. replace (2 * 0 - 2 * 0 -
      (m21 J * (d - 0) + m22 J * (0 - 0))) with (- m21 J * d) in B by ring. rewrite Rabs_mult, (Rabs_pos_eq d) in A by
        lra; rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq d) in B by lra. split; apply (Rmult_le_reg_r d); lra. }
  assert (Z : forall x, (forall eps, 0 < eps -> Rabs x <= eps) -> x = 0).
  { intros x H; pose proof (Rabs_pos x); destruct (Req_dec x 0) as [|N]; trivial;
      pose proof (Rabs_pos_lt x N). specialize (H (Rabs x / 2) ltac:(lra)); lra. }
  split; [assert (2 - m11 J = 0); [|lra]|]; apply Z; intros eps He; apply (C eps He).
Qed.

Notation step' := (step (3 / 4) (1 / 2) 1). Notation iterate' := (iterate (3 / 4) (1 / 2) 1).
Notation height' := (height (3 / 4) (1 / 2)). Notation never' := (never_grazes (3 / 4) (1 / 2) 1).

(** E = 5/4 < 3/2. From (1, 1) the iterates come to a state not above 4 nu, no deeper than nu below the touch, and
    with 3/4 nu (1 - 16 nu) <= 3/4 p - 1/2 q <= nu. *)
Lemma attractor_numbers : Wedge_statement -> exists nu0, nu0 > 0 /\ forall nu, 0 < nu <= nu0 ->
  (forall x, wedge x -> 0 <= fst (step' nu x) /\ snd (step' nu x) <= fst (step' nu x)) /\
  (exists n, let y := iterate' nu n (1, 1) in 0 <= snd y <= fst y /\ snd y <= 4 * nu /\
    3 / 4 * (1 - 16 * nu) * nu <= 3 / 4 * fst y - 1 / 2 * snd y <= nu /\
    exists m, (1 <= m)%nat /\ 3 / 4 * fst (iterate' nu m y) - 1 / 2 * snd (iterate' nu m y) < nu /\
      snd (iterate' nu m y) <= 4 * nu /\ forall k, (1 <= k < m)%nat -> 0 <= height' nu (iterate' nu k y)) /\
  (forall x, wedge x -> never' nu x -> exists v K N, (1 <= N)%nat /\ K > 0 /\ forall k, exists J, derivative (iterate'
    nu k) x J /\
    forall i, (N * i <= k)%nat -> norm (apply J v) >= K * (5 / 4) ^ i) /\
  (exists N, forall x, trap (3 / 4) (1 / 2) 1 nu x -> exists m, (m <= N)%nat /\ height' nu (iterate' nu m x) < 0).
Proof.
  intros H; destruct (H (3 / 4) (1 / 2) 1 (5 / 4)) as (nu0 & H0 & HN); try lra; exists nu0; split; [exact H0|].
  intros nu Hnu; destruct (HN nu Hnu) as (N & N1 & [[K L T] G _ _] & _); split; [|split; [|split]].
  - intros x Hx; destruct (K x Hx) as [k1 k2]; lra.
  - destruct (L (1, 1)) as (n & Hn); [unfold wedge; cbn; lra|]; exists n; cbv zeta; pose proof Hn as ((w1 & w2) & w3 &
      w4 & w5). replace (((3 / 4 - 1 / 2) * 1) ^ 2) with (1 / 16) in w4 by field; unfold height in w4, w5.
    destruct (T _ Hn) as (m & Hm & Hm1 & Hm2 & Hm3); pose proof Hm1 as (_ & u3 & _); unfold height in Hm2.
    replace (nu / (3 / 4
      - 1 / 2)) with (4 * nu) in w3, u3 by field; replace (nu / (1 / 16)) with (16 * nu) in w4 by field. split;
      [lra|split; [lra|split; [lra|]]]; exists m; split; [lia|split; [lra|split; [lra|exact Hm3]]].
  - intros x Hx Hg; destruct (G x Hx Hg) as (v & K' & HK & HJ); exists v, K', N; split; [exact N1|split; assumption].
  - exists N; intros x Hx; destruct (T x Hx) as (m & Hm & _ & Hm2 & _); exists m; split; [lia|exact Hm2].
Qed.
(** No periodic orbit is stable: an eigenvalue beyond 5/4, and some nearby point goes away. The cone of the vectors is
    |q| <= 8 |3/4 p - 1/2 q|, in it (1, 1) for one, and they grow by 5/4 to the next impact. *)
Lemma unstable_numbers : Wedge_statement -> Fixed_statement -> exists nu, nu > 0 /\ exists x,
  step' nu x = x /\ 0 <= snd x /\ (exists J v e, derivative (step' nu) x J /\ v <> (0, 0) /\
    m11 J * fst v + m12 J * snd v = e * fst v /\ 5 / 4 <= Rabs e) /\
  (exists r, r > 0 /\ forall eps, eps > 0 -> exists z i, norm (sub z x) < eps /\ norm (sub (iterate' nu i z) x) > r).
Proof.
  intros H F; destruct (H (3 / 4) (1 / 2) 1 (5 / 4)) as (nu0 & H0 & HN); try lra; exists nu0; split;
    [exact H0|]. destruct (HN nu0 ltac:(lra)) as (N & N1 & [_ _ Ei Un] & _); destruct (F (3 / 4) (1 / 2) 1 nu0) as (x
    & P); try lra. exists x; pose proof P as [[w1 w2] _ _ E]; split; [exact E|split; [exact w1|split]].
  - destruct (Ei x 1%nat P) as (J & v & e & D & Hv & Ev & He); exists J, v, e; split; [exact D|split;
      [exact Hv|]]. apply (f_equal fst) in Ev; cbn in Ev; split; [exact Ev|lra].
  - destruct (Un x 1%nat P) as (r & Hr & HU); exists r; split; [exact Hr|]; intros eps He.
    destruct (HU eps He) as (z & i & Hz & Hi); exists z, (i * 1)%nat; split; assumption.
Qed.
Lemma cone_numbers : Wedge_statement -> exists nu0, nu0 > 0 /\ forall nu, 0 < nu <= nu0 -> forall x,
  trap (3 / 4) (1 / 2) 1 nu x -> never' nu x -> height' nu (step' nu x) < 0 -> exists J, derivative (step' nu) x J /\
  let w := apply J (1, 1) in 5 / 16 <= Rabs (3 / 4 * fst w - 1 / 2 * snd w) /\
  Rabs (1 / 2 * snd w) <= 4 * Rabs (3 / 4 * fst w - 1 / 2 * snd w).
Proof.
  intros H; destruct (H (3 / 4) (1 / 2) 1 (5 / 4)) as (nu0 & H0 & HN); try lra; exists nu0; split; [exact H0|].
  intros nu Hnu x Hx Hg Hh; destruct (HN nu Hnu) as (N & N1 & _ & Ex). destruct (Ex x 1%nat Hx Hg (le_n 1) Hh
    ltac:(intros; lia)) as (J & D & HJ); exists J; split; [exact D|]; cbv zeta. assert (C : cone (3 / 4) (1 / 2) (1,
    1)) by (unfold cone, change; cbn; rewrite !Rabs_pos_eq; lra). destruct (HJ _ C) as [C1 C2];
    unfold cone, change in C1, C2; cbn [fst snd] in C1, C2. replace (2 * (1 / 2) / (3 / 4 - 1 / 2)) with 4 in C1 by
    field; replace (3 / 4 * 1 - 1 / 2 * 1) with (1 / 4) in C2 by field; rewrite (Rabs_pos_eq (1 / 4)) in C2 by lra.
  split; [lra|exact C1].
Qed.

(** l1 = 1/2, l2 = 1/4, b = 1: 3/5 to 7/10 of 4^-n is a gap; at 4/5 to 19/10 there is a stable orbit, of period n. *)
Lemma gap_numbers : Gaps_statement -> exists E n0, E > 1 /\ forall n nu, (n0 <= n)%nat ->
  3 / 5 * (1 * (1 / 2) ^ n) ^ 2 <= nu <= 7 / 10 * (1 * (1 / 2) ^ n) ^ 2 ->
  (exists N, (1 <= N)%nat /\ exponent (1 / 2) (1 / 4) 1 nu E N) /\ forall x m, wedge x ->
  never_grazes (1 / 2) (1 / 4) 1 nu x -> (1 <= m)%nat -> iterate (1 / 2) (1 / 4) 1 nu m x = x -> exists J v e,
  derivative (iterate (1 / 2) (1 / 4) 1 nu m) x J /\ v <> (0, 0) /\ apply J v = scale e v /\ Rabs e > 1.
Proof.
  intros H; destruct (H (1 / 2) (1 / 4) 1 (3 / 5) (7 / 10)) as (E & n0 & HE & HN); try lra; exists E, n0.
  split; [exact HE|]; intros n nu Hn Hnu; destruct (HN n nu Hn Hnu) as (N & N1 & [_ Ex Ei _]).
  split; [exists N; split; assumption|]; intros x m Hw Hg Hm Hx.
  destruct (Ei x m) as (J & v & e & D & Hv & Ev & He); [constructor; assumption|].
  exists J, v, e; split; [exact D|split; [exact Hv|split; [exact Ev|lra]]].
Qed.
Lemma window_numbers : Windows_statement -> exists n0, forall n nu, (n0 <= n)%nat ->
  4 / 5 * (1 * (1 / 2) ^ n) ^ 2 <= nu <= 19 / 10 * (1 * (1 / 2) ^ n) ^ 2 -> exists x J, 0 <= snd x <= fst x /\
  never_grazes (1 / 2) (1 / 4) 1 nu x /\ (1 <= n)%nat /\ iterate (1 / 2) (1 / 4) 1 nu n x = x /\
  derivative (iterate (1 / 2) (1 / 4) 1 nu n) x J /\
  m11 J + m22 J < 1 + (m11 J * m22 J - m12 J * m21 J) /\ m11 J * m22 J - m12 J * m21 J < 1.
Proof.
  intros H; destruct (H (1 / 2) (1 / 4) 1 (4 / 5) (19 / 10)) as (n0 & HN); try lra; exists n0;
    intros n nu Hn Hnu. destruct (HN n nu Hn Hnu) as (x & J & [[w g h p] D T S]); exists x, J. split;
    [exact w|split; [exact g|split; [exact h|split; [exact p|split; [exact D|]]]]]. pose proof (Rle_abs (m11 J + m22
    J)); pose proof (Rle_abs (m11 J * m22 J - m12 J * m21 J)); lra.
Qed.
(** l1 = 1/2, l2 = 1/4, b = 3: trace 3/4, gamma = 3/4. *)
Lemma same_map_numbers : Same_map_statement ->
  StatementOrbitsPlane.planar (grazing_map (1 / 2) (1 / 4) 3) (1 / 2 + 1 / 4) (1 / 2 * (1 / 4)) (3 * (1 / 2 - 1 / 4)) 1
    StatementOrbits.zero /\ 2 * sqrt (1 / 2 * (1 / 4)) <= 3 / 4 /\
  forall nu x, let y := StatementOrbits.step (grazing_map (1 / 2) (1 / 4) 3) (- nu) x in
  step (1 / 2) (1 / 4) 3 nu (x 0%nat, x 1%nat) = (y 0%nat, y 1%nat).
Proof. intros H; destruct (H (1 / 2) (1 / 4) 3) as (P & B & S); try lra; split; [exact P|split; [lra|exact S]]. Qed.

(** ** Overdamped oscillators: the paper's, d = 3/2, w = 8, tau = 4/5, mu = 1/10 *)

From Grazing Require Import StatementOscillator StatementTrapped.

Notation example := (paper (3 / 2) 8 (4 / 5) (1 / 10) (78665 / 1000000) (757575 / 1000000)).
Definition half : R := acos (/ (1 + 1 / 10)).

Lemma example_numbers : Example_statement -> 0 < alb example /\ 0 < alo example /\ stretches example (201 / 200) 1 /\
  stretches example (201 / 200) 100 /\ 201 / 200 > 1 /\ - half <= half <= - half + W example /\
  W example < p example /\ (forall t, half < t < - half + p example -> Q example t < 0) /\ least_slip example <= 78665
  / 10000000 /\ least_speed example <= 757575 / 1000000 * sqrt (1 / 10).
Proof.
  intros H; destruct (H (1 / 10) ltac:(lra)) as [[P [B [Z V]] C] E S]; destruct P; fold half in *. split;
    [exact B|split; [exact C|split; [apply S; lia|split; [apply S; lia|split; [lra|split; [exact width|]]]]]].
  split; [exact narrow|split; [exact below|split; [cbn [zm paper] in Z; lra|exact V]]].
Qed.
(** d = 5/4, w = 2: a = 1/4, b = 1, and cos t > 1/2 beyond mu = 1, for |t| < pi/3; at pi the stop is at -3. *)
Lemma paper_numbers : Paper_statement -> let M := paper (5 / 4) 2 (1 / 2) 1 3 4 in let h := acos (/ (1 + 1)) in
  a M + b M = 5 / 4 /\ a M * b M = 1 / 4 /\ 0 < a M < b M /\ 0 <= tau M /\ 0 < mu M /\ 0 < al0 M /\ Q M 0 = Q M (0 + p
    M) /\
  (forall t, derivable_pt_lim (Q M) t (Q1 M t)) /\ (forall t, derivable_pt_lim (Q1 M) t (Q2 M t)) /\
  (forall t, - h <= t <= h -> 1 <= - Q2 M t <= 2) /\ (forall t, Q M t <= 1) /\ exists t, Q M t = 1.
Proof.
  intros H M h; destruct (H (5 / 4) 2 (1 / 2) 1 3 4) as (E1 & E2 & U); try lra; fold M h in E1, E2, U.
  destruct U as [U0 U1 U2 U3 U4 U5 _ _ _ U6 U7 U8 U9]; split; [lra|split; [lra|split; [exact U0|]]]. split;
    [exact U1|split; [exact U2|split; [exact U7|split; [symmetry; apply U3|split; [exact U4|split;
    [exact U5|]]]]]]. split; [intros t Ht; specialize (U6 t Ht); cbn in *; lra|split; [exact U8|exact U9]].
Qed.
Lemma opens_example : Example_statement -> opens example (- half) half. Proof. intros H; apply (H (1 / 10)); lra. Qed.

(** From a contact of the set the next comes after 5 at least: p - W > 5. *)
Lemma trapped_numbers : Example_statement -> Trapped_statement -> forall t V, trapped example t V ->
  (exists t' V' x v, leg example t V t' V' x v) /\ forall t' V' x v, leg example t V t' V' x v -> t' >= t + 5 /\
  0 <= Q example t' /\ V' <= 0 /\ - Vm example <= V' /\ 0 <= zeta example t' V' <= zm example.
Proof.
  intros H T t V Tr; destruct (T example _ _ (opens_example H) t V Tr) as (Ex & k & Hk & All); split;
    [exact Ex|]. intros t' V' x v L; destruct (All t' V' x v L) as ((q1 & q2 & q3) & n & Hn & Pn). split;
    [|split; [exact q1|split; [apply q2|split; [apply q2|exact q3]]]]. assert (B : 2 * half <= 9 / 10).
  { apply Rnot_lt_le; intros F; assert (C : cos half = / (1 + 1 / 10)) by (apply cos_acos; lra).
    destruct (acos_bound (/ (1 + 1 / 10))) as [_ b2]; fold half in b2. assert (cos half < cos (9 / 20)) by (apply
      cos_decreasing_1; pose proof PI2_3_2; lra). assert (cos (9 / 20) <= 10 / 11); [|replace (/ (1 + 1 / 10)) with
      (10 / 11) in C by field; lra]. destruct (pre_cos_bound (9 / 20) 0) as [_ U]; [lra|lra|];
      unfold cos_approx, cos_term in U; cbn in U; lra.
      }
  unfold in_pass in *; rewrite plus_IZR in Pn; assert (1 <= IZR n) by (apply (IZR_le 1); lia); cbn [p paper]
    in *. pose proof PI2_3_2; assert (2 * PI * 1 <= 2 * PI * IZR n) by (apply Rmult_le_compat_l; lra); lra.
Qed.
(** The motion from there, as the law of impact and the differential equation say. *)
Lemma exists_numbers : Example_statement -> Exists_statement -> forall t0 V0, trapped example t0 V0 ->
  exists N t V (x v : nat -> R -> R), t 0%nat = t0 /\ V 0%nat = V0 /\ forall i, t i < t (S i) /\
  - half <= t i - 2 * PI * IZR (N i) <= half /\
  (forall s, derivable_pt_lim (x i) s (v i s)) /\ x i (t i) = Q example (t i) /\
  v i (t i) = Q1 example (t i) - 4 / 5 * V i /\ x i (t (S i)) = Q example (t (S i)) /\
  V (S i) = v i (t (S i)) - Q1 example (t (S i)) /\ (forall s, t i < s < t (S i) -> Q example s < x i s) /\
  trapped example (t i) (V i).
Proof.
  intros H T t0 V0 Tr; destruct (T example _ _ (opens_example H) t0 V0 Tr) as (N & t & V & x & v & (HM & All) & E1 &
    E2).
  exists N, t, V, x, v; split; [exact E1|split; [exact E2|]]; intros i; destruct (HM i) as [P [F L1 L2 L3 L4 L5 L6]].
  split; [exact L3|split; [unfold in_pass in P; cbn [p paper] in P; lra|split; [intros s; apply F|]]].
  split; [exact L1|split; [exact L2|split; [exact L5|split; [exact L6|split; [exact L4|apply All]]]]].
Qed.
Lemma absorbed_numbers : Example_statement -> Absorbed_statement -> forall t V t1 V1 x v t2 V2 y u,
  let M := example in let fast := sqrt (2 * alM M * mu M) in
  0 < al0 M - b M ^ 2 * (1 / 10 + (1 + tau M) * (3 / 10)) / (b M - a M) ->
  0 < al0 M - b M ^ 2 * (zm M + (1 + tau M) * fast) / (b M - a M) ->
  0 <= Q M t -> - (3 / 10) <= V <= 0 -> 0 <= zeta M t V <= 1 / 10 -> leg M t V t1 V1 x v -> leg M t1 V1 t2 V2 y u ->
  - fast <= V1 /\ zeta M t1 V1 <= zm M /\ - Vm M <= V2 <= 0 /\ 0 <= zeta M t2 V2 <= zm M.
Proof.
  intros H T t V t1 V1 x v t2 V2 y u M fast A1 A2 q1 q2 q3 L1 L2.
  destruct (T example _ _ (1 / 10) (3 / 10) t V t1 V1 x v t2 V2 y u (opens_example H) A1 A2) as [(_ & W1 & W2) (_ & W3
    & W4)];
    [split; [exact q1|split; [exact q2|exact q3]]|exact L1|exact L2|]; fold fast in W1. split; [apply W1|split;
    [apply W2|split; [exact W3|exact W4]]].
Qed.
(** A motion that begins at rest at 1, when the stop is at - 21/10: a x + x' = a. All speeds there but countably many
    never graze. *)
Lemma started_numbers : Example_statement -> Started_statement -> let M := example in begins M (a M) ->
  forall x v, free (a M + b M) (a M * b M) x v -> x PI = 1 -> v PI = 0 -> exists t V t1 V1 x1 v1 t2 V2 x2 v2, PI <= t
    /\ (forall r, PI < r < t -> Q M r < x r) /\ x t = Q M t /\ V = v t - Q1 M t /\ V <= 0 /\ leg M t V t1 V1 x1 v1 /\
  leg M t1 V1 t2 V2 x2 v2 /\ 0 <= Q M t2 /\ V2 <= 0 /\ zeta M t2 V2 <= 78665 / 10000000.
Proof.
  intros H T M B x v F X0 V0; destruct (opens_example H) as [U _ _]; pose proof (overdamped _ _ _ U) as Hab; fold M in
    Hab. assert (QP : Q M PI <= 0) by (cbn [Q M paper]; unfold M; cbn [Q paper]; rewrite cos_PI; lra).
  destruct (T M _ _ (a M) PI x v (opens_example H) B QP F) as ((t & V & Ar) & Th); [lra|rewrite X0, V0; lra|].
  destruct (Th t V Ar) as ((t1 & V1 & x1 & v1 & L1) & Th1); destruct (Th1 _ _ _ _ L1) as ((t2 & V2 & x2 & v2 & L2) &
    Th2); destruct (Th2 _ _ _ _ L2) as (q1 & q2 & q3); destruct Ar as [A1 A2 A3 A4 A5]. exists t, V, t1, V1, x1, v1,
    t2, V2, x2, v2; repeat (split; [assumption|]); split; [lra|]; unfold M in q3; cbn [zm paper] in q3; unfold M; lra.
Qed.
Lemma almost_numbers : Example_statement -> Almost_statement -> let M := example in begins M 2 -> exists f : nat -> R,
  forall y u N t V x v, free (a M + b M) (a M * b M) y u -> y PI = 1 -> 0 <= a M + u PI <= 2 -> arrives M PI (t 0%nat)
  (V 0%nat) y u -> motion M (- half) half N t V x v -> (forall n, u PI <> f n) ->
  forall i, V i <> 0.
Proof.
  intros H T M B; assert (QP : Q M PI < 0) by (unfold M; cbn [Q paper]; rewrite cos_PI; lra).
  destruct (T M _ _ 2 PI 1 (opens_example H) B ltac:(lra) ltac:(lra)) as (f & Hf); exists f; intros y u N t V x v F Y0
    U0 Ar Mo No i V0. destruct (Hf y u N t V x v F Y0 ltac:(rewrite Rmult_1_r; exact U0) Ar Mo) as (n & E); [exists i;
      exact V0|exact (No n E)].
Qed.
(** The vector (1, 0) at an impact is more than 1.005 away just before the next. *)
Lemma cone_example : Example_statement -> Cone_statement -> forall t V t' V' x v k n, let M := example in
  trapped M t V -> V < 0 -> leg M t V t' V' x v -> in_pass M (- half) half k t -> (1 <= n)%Z ->
  in_pass M (- half) half (k + n) t' ->
  let d := phi11 M (t' - t) * - (4 / 5) + phi12 M (t' - t) * (jump M t V / V) in
  let w := phi21 M (t' - t) * - (4 / 5) + phi22 M (t' - t) * (jump M t V / V) in
  201 / 200 <= Rabs d /\ 0 <= d * (a M * d + w) /\ 0 <= - (4 / 5) * (a M * - (4 / 5) + jump M t V / V).
Proof.
  intros H T t V t' V' x v k n M Tr HV L Hk Hn Hk' d w; pose proof (H (1 / 10) ltac:(lra)) as [O _ S].
  destruct (T example _ _ O t V t' V' x v k n 1 0 (201 / 200) Tr HV L Hk Hk' (S n Hn)) as (C1 & C & G).
  { left; destruct O as [[U _ _ _ _ _ _ _ _ _ _ _ _] _ _]; lra. }
  replace (- tau example * 1) with (- (4 / 5)) in C1, C, G by (cbn; lra).
  replace (- tau example * 0 + jump example t V * 1 / V) with (jump M t V / V) in C1, C, G by (fold M; unfold Rdiv;
    ring).
  fold M d in G; fold M d w in C; fold M in C1; rewrite Rabs_R1 in G; split; [lra|].
  assert (K : forall q r, cone M q r -> 0 <= q * (a M * q + r)).
  { intros q r [[c1 c2]|[c1 c2]]; [apply Rmult_le_pos; assumption|].
    replace (q * (a M * q + r)) with (- q * - (a M * q + r)) by ring; apply Rmult_le_pos; lra. }
  split; apply K; assumption.
Qed.
(** At the speed 1/5, V = - 1/5: a displacement (d, 0) becomes - (4/5 d, 5 J d), to 1/100 of d. *)
Lemma derivative_numbers : Example_statement -> Derivative_statement -> let M := example in forall t x v X U,
  through M t x v X U -> v t - Q1 M t = - (1 / 5) -> exists r, 0 < r /\ forall t1 y u Y W, free (a M + b M) (a M * b
  M) y u -> free (a M + b M) (a M * b M) Y W -> y t1 = Q M t1 -> Y t1 = Q M t1 -> W t1 = Q1 M t1 - 4 / 5 * (u t1 - Q1
  M t1) -> Rabs (t1 - t) <= r -> u t = v t -> let d := y t - x t in Rabs (Y t - X t + 4 / 5 * d) <= 1 / 100 * Rabs d
  /\ Rabs (W t - U t + 5 * jump M t (- (1 / 5)) * d) <= 1 / 100 * Rabs d.
Proof.
  intros H D M t x v X U T HV; destruct (opens_example H) as [Hu _ _]; destruct (D M _ _ t (- (1 / 5)) x v X U Hu T
    (eq_sym HV) ltac:(lra) (1 / 100) ltac:(lra)) as (r & Hr & K); exists r; split; [exact Hr|]; intros t1 y u Y W Fy
      FY Ey EY EW Ht Eu d. destruct (K t1 y u Y W (conj Fy (conj FY (conj Ey (conj EY EW)))) Ht) as [K1 K2]; rewrite
    Eu, Rminus_eq_0, Rabs_R0, Rplus_0_r in *; fold d in K1, K2; change (tau M) with (4 / 5) in K1, K2. split.
  - replace (Y t - X t + 4 / 5 * d) with (Y t - X t - - (4 / 5) * d) by ring; exact K1.
  - replace (W t - U t + 5 * jump M t (- (1 / 5)) * d) with (W t - U t - (- (4 / 5) * 0 + jump M t (- (1 / 5)) * d /
      - (1 / 5))) by field; exact K2.
Qed.
Lemma through_numbers : let M := example in forall t x v X U, through M t x v X U -> free (a M + b M) (a M * b M) x v
  /\ free (a M + b M) (a M * b M) X U /\ x t = Q M t /\ X t = Q M t /\ U t = Q1 M t - 4 / 5 * (v t - Q1 M t).
Proof. intros M t x v X U T; exact T. Qed.
Lemma separate_numbers : Example_statement -> Separate_statement -> forall N t V x v t' V' x' v', let M := example in
  stays M (- half) half N t V x v -> stays M (- half) half N t' V' x' v' -> t 0%nat = 0 -> t' 0%nat = 0 ->
  0 < t 1%nat -> 0 < t' 1%nat -> x 0%nat 0 <= x' 0%nat 0 -> a M * x 0%nat 0 + v 0%nat 0 <= a M * x' 0%nat 0 + v' 0%nat 0
    ->
  x' 0%nat 0 = x 0%nat 0 /\ v' 0%nat 0 = v 0%nat 0.
Proof.
  intros H T N t V x v t' V' x' v' M S S' E1 E2 L1 L2 O1 O2.
  apply (T example _ _ _ (H (1 / 10) ltac:(lra)) N t V x v t' V' x' v' S S' 0); try lra; fold M; lra.
Qed.
Lemma no_stable_numbers : Example_statement -> No_stable_statement -> forall t V x v, let M := example in
  stays M (- half) half (fun i => Z.of_nat i) t V x v -> (forall i, t (S i) = t i + 2 * PI /\ V (S i) = V i) ->
  exists i0 eps, 0 < eps /\ forall d, 0 < d -> exists N' t' V' x' v', stays M (- half) half N' t' V' x' v' /\
  t' 0%nat = t i0 /\ Rabs (V' 0%nat - V 0%nat) <= d /\ exists i j s, t i <= s <= t (S i) /\ t' j <= s <= t' (S j) /\
  eps < Rabs (x' j s - x i s).
Proof.
  intros H T t V x v M S P; assert (E : forall i, V i = V 0%nat).
  { induction i as [|i IH]; [reflexivity|]; rewrite <- IH; apply P. }
  destruct (T example _ _ _ (H (1 / 10) ltac:(lra)) ltac:(cbn; lra) 1%nat 1%Z _ t V x v (le_n 1) S) as (i0 & eps & e0
    & U).
  { intros i; replace (i + 1)%nat with (Datatypes.S i) by lia; destruct (P i) as [P1 P2]; cbn [p paper].
    split; [lia|split; [lra|exact P2]]. }
  exists i0, eps; split; [exact e0|]; intros d Hd; destruct (U d Hd) as (N' & t' & V' & x' & v' & S' & A & B & C).
  rewrite E in B; exists N', t', V', x', v'; split; [exact S'|split; [exact A|split; [exact B|exact C]]].
Qed.
(** theta = 1/100, so a displacement doubles in 100 periods, as exp 1 > 2; and it is not bounded, whatever m is. *)
Lemma exponent_numbers : Example_statement -> Exponent_statement -> let M := example in
  forall N t V x v d w, stays M (- half) half N t V x v -> (forall i, V i < 0) ->
  (forall i, returns M (t (S i) - t i) (t i) (V i) (d i) (w i) (d (S i)) (w (S i))) -> d 0%nat = 1 -> w 0%nat = 0 ->
  (forall m, by_passes M (1 / 100) m -> forall i, (N 0%nat + 100 <= N i)%Z -> 2 <= Rabs (d i)) /\ exists theta, 0 <
  theta /\ forall i, 1 + theta * IZR (N i - N 0%nat) <= Rabs (d i).
Proof.
  intros H T M N t V x v d w S Neg Ret d0 w0; pose proof (H (1 / 10) ltac:(lra)) as Ch; destruct (opens_example H) as
    [[U _ _ _ _ _ _ _ _ _ _ _ _] _ _]; destruct (T M _ _ (opens_example H)) as [G1 G2].
  assert (C : cone M (d 0%nat) (w 0%nat)) by (rewrite d0, w0; left; unfold M; lra); split.
  - intros m Br i Hi; pose proof (G1 _ _ Br N t V x v d w S Neg Ret C i) as G; rewrite d0, Rabs_R1 in G.
    assert (X : 100 <= IZR (N i - N 0%nat)) by (apply (IZR_le 100); lia); pose proof (exp_ineq1_le 1).
    destruct (Req_dec (1 / 100 * IZR (N i - N 0%nat)) 1) as [Eq|Ne]; [rewrite Eq in G; lra|].
    pose proof (exp_increasing 1 (1 / 100 * IZR (N i - N 0%nat)) ltac:(lra)); lra.
  - destruct (G2 _ Ch) as (th & T0 & G); exists th; split; [exact T0|]; intros i; specialize (G N t V x v d w S Neg
      Ret C i); rewrite d0, Rabs_R1 in G; pose proof (exp_ineq1_le (th * IZR (N i - N 0%nat))); lra.
Qed.
(** A machine with the paper's flow at mu = 1/20, from the numbers at 1/10. *)
Lemma range_numbers : Range_statement -> Paper_statement -> forall L m, checked L (11 / 10) m ->
  worse L (paper (3 / 2) 8 (4 / 5) (1 / 20) 1 2) -> let M := paper (3 / 2) 8 (4 / 5) (1 / 20) 1 2 in
  0 < alb M /\ 0 < alo M /\ forall n, (1 <= n)%Z -> 11 / 10 <= A_ M (IZR n) \/ 11 / 10 <= B_ M (IZR n).
Proof.
  intros H P L m C Wo M; destruct (P (3 / 2) 8 (4 / 5) (1 / 20) 1 2) as (_ & _ & U); try lra.
  destruct (H L (11 / 10) m _ _ _ C U Wo) as [[_ [O1 _] O2] _ S]; split; [exact O1|split; [exact O2|exact S]].
Qed.

(** What stands in hypotheses, at numbers. *)
Lemma hypotheses_hold : forall lo hi N t V d w m L, let M := example in (chaotic M lo hi 1 -> False) /\
  (periodic M 3 2 N t V -> N 3%nat = (N 0%nat + 2)%Z /\ t 3%nat = t 0%nat + 4 * PI /\ V 3%nat = V 0%nat) /\
  (returns M 6 0 (-1) 0 1 d w -> d = phi12 M 6 * - (4 / 5) /\ w = phi22 M 6 * - (4 / 5)) /\
  (brief M m -> (1 <= m)%Z /\ let T := 2 * PI * IZR m - W M in phi11 M T / 10 + exp (- a M * T) * (9 / 5 * Vm M + zm
    M) / (b M - a M) < 1 / 10) /\ (by_passes M 1 m -> brief M m /\ ((1 <= m)%Z -> stretches M (exp 1) 1)) /\ (begins M
  w -> 78665 / 10000000 <= w /\ 0 < 1 - b M ^ 2 * (w + 9 / 5 * sqrt (2 * (11 / 10 + a M ^ 2 * (1 / 10 + w / (b M
    - a M))) * (1 / 10))) / (b M - a M)) /\
  (worse L M -> a L = a M /\ b L = b M /\ tau L = 4 / 5 /\ p L = 2 * PI /\ 1 / 10 <= mu L /\ W M <= W L /\ al0 L <= 1 /\
    11 / 10 <= al1 L /\ exists S, zm L = 78665 / 1000000 * mu L /\ Vm M = S * sqrt (1 / 10) /\ Vm L = S * sqrt (mu L))
      /\ (checked L 2 m -> W L < p L /\ 0 < al0 L /\ 0 < alb L /\ least_slip L <= zm L /\ least_speed L <= Vm L /\ 0 <
    alo L /\ (1 <= m)%Z /\ 2 <= B_ L (IZR m) /\
    forall n, (1 <= n < m)%Z -> stretches L 2 n) /\ (checked L 1 m -> False).
Proof.
  intros lo hi N t V d w m L M; split; [intros [_ E _]; lra|split; [|split; [|split; [|split; [|split; [|split;
    [|split]]]]]]].
  - intros P; destruct (P 0%nat) as (P1 & P2 & P3); cbn [Nat.add p paper] in *; split; [exact P1|split; [|exact P3]].
    unfold M in P2; cbn [p paper] in P2; lra.
  - intros [-> ->]; cbn [tau paper M]; unfold M; split; unfold Rdiv; cbn [tau paper]; ring.
  - intros [H1 H2]; unfold M in *; cbv zeta in *; cbn [p mu tau paper] in *; split; [exact H1|].
    replace (9 / 5) with (1 + 4 / 5) by field; lra.
  - intros [H1 H2]; split; [exact H1|]; intros Hm; specialize (H2 1%Z ltac:(lia)); rewrite Rmult_1_l in H2; exact H2.
  - intros [H1 H2]; unfold M in *; cbn [zm al0 al1 mu tau paper] in *; split; [lra|]; replace (9 / 5) with (1 + 4 / 5)
      by field; replace (11 / 10) with (1 + 1 / 10) by field; exact H2.
  - intros [[H1 H2] [H3 H4] H5 H6 [H7 H8] (Z & S & E1 & E2 & E3 & E4)]; unfold M in *; cbn [tau p mu al0 al1 zm Vm
      paper] in
      *. split; [symmetry; exact H1|split; [symmetry; exact H2|]]; repeat (split; [lra|]); exists S; replace (78665 /
      1000000) with Z by lra; repeat split; assumption.
  - intros [H1 H2 [H3 [H3' H3'']] H4 _ H6 H7 H8]; repeat (split; [assumption|]); exact H7.
  - intros [_ _ _ _ H5 _ _ _]; lra.
Qed.
(** d = 3/2, w = 24: a < 1/60, so exp (- 2 pi a) > 4/5 and E = 2 will do. *)
Lemma small_numbers : Small_statement -> exists Z S mu1, mu1 > 0 /\ forall mu, 0 < mu <= mu1 ->
  let M := paper (3 / 2) 24 (1 / 2) mu Z S in 0 < alb M /\ 0 < alo M /\ stretches M 2 1.
Proof.
  intros H; destruct (H (3 / 2) 24 (1 / 2) 2) as (Z & S & mu1 & H1 & HM); try lra.
  - cbn [a paper]; replace ((3 / 2) ^ 2 - 1) with (5 / 4) by field; set (r := sqrt (5 / 4)).
    assert (Er : r * r = 5 / 4) by (apply sqrt_sqrt; lra); assert (R0 : 0 <= r) by apply sqrt_pos.
    assert (R1 : 11 / 10 < r) by (apply Rnot_le_lt; intros F; assert (r * r <= 11 / 10 * (11 / 10)) by
      (apply Rmult_le_compat; lra); lra).
    assert (R2 : r < 3 / 2) by (apply Rnot_le_lt; intros F; assert (3 / 2 * (3 / 2) <= r * r) by
      (apply Rmult_le_compat; lra); lra).
    set (t := (3 / 2 - r) / 24 * (2 * PI)); replace (- ((3 / 2 - r) / 24) * (2 * PI)) with (- t) by (unfold t; ring).
    assert (T : 0 < t <= 1 / 60 * 8).
    { pose proof PI_4; pose proof PI_RGT_0; unfold t; split; [apply Rmult_lt_0_compat; lra|apply Rmult_le_compat; lra].
      }
    pose proof (exp_ineq1_le (- t)); assert (exp (- t) < 1) by (rewrite <- exp_0; apply exp_increasing; lra).
    split; [lra|]; set (l := exp (- t)) in *; apply (Rmult_lt_reg_r (2 * (1 - l))); [lra|].
    replace (l / (2 * (1 - l)) * (2 * (1 - l))) with l by (field; lra); lra.
  - exists Z, S, mu1; split; [exact H1|]; intros mu Hmu M; destruct (HM mu Hmu) as [[_ [B _] C] _ St].
    split; [exact B|split; [exact C|apply St; lia]].
Qed.

(** ** Instability near grazing: l1 = 1/2, l2 = 1/4, b = 1, of the words over {1, 2}; C A B = 1/4, C A^2 B = 3/16 *)

From Grazing Require Import StatementOrbits StatementOrbitsPeriodic StatementUniform StatementUnstable Derivatives.

Lemma unstable_words : Unstable_statement -> Same_map_statement -> let M := grazing_map (1 / 2) (1 / 4) 1 in
  exists d, d > 0 /\ (forall mu x, Rabs mu <= d -> Rabs (x 0%nat) <= d -> Rabs (x 1%nat) <= d -> height M mu x 0 < 0 ->
  step M mu x 0%nat = x 0%nat -> step M mu x 1%nat = x 1%nat -> exists r, r > 0 /\ forall eps, eps > 0 -> exists z i,
  Rabs (z 0%nat - x 0%nat) <= eps /\ Rabs (z 1%nat - x 1%nat) <= eps /\ ~ within 2 r (minus (Nat.iter i (step M mu) z)
    (Nat.iter i (step M mu) x))) /\
  forall mu (n : bool -> nat) x, Rabs mu <= d -> (forall j, n j = 1%nat \/ n j = 2%nat) ->
  orbit_near M bool negb n mu d x -> unstable M mu (x true).
Proof.
  intros H Sm M; destruct (Sm (1 / 2) (1 / 4) 1) as [[S _ _ _ _ _ Wq _] _]; try lra. assert (C1 : crossing M 1 = 1 /
    4) by (unfold crossing, power, mult; cbn; lra). assert (C2 : crossing M 2 = 3 / 16) by (unfold crossing, power,
    mult; cbn; lra). destruct (H M zero S Wq 2%nat (3 / 16)) as (d & Hd & HU); [lra|]; exists d; split;
    [exact Hd|split].
  - intros mu x Hmu x0 x1 Hh s0 s1; assert (U0 : unstable M mu x).
    { apply (HU unit (fun j => j) (fun _ => 1%nat) mu (fun _ => x)); [| | | |exact tt].
    + exists 1%nat, (fun _ => tt), (fun _ => 0%nat); split; [intros []; split; [lia|reflexivity]|intros k Hk; lia].
    + intros _; rewrite C1, Rabs_pos_eq; [split; [lia|lra]|lra].
    + exact Hmu.
    + intros j; split; [intros [|[|i]] Hi; [exact x0|exact x1|cbn in Hi; lia]|]. split; [intros k Hk;
        lia|split; [intros k Hk; replace k with 0%nat by lia; exact Hh|]]. intros [|[|i]] Hi;
        [exact s0|exact s1|cbn in Hi; lia].
        }
    destruct U0 as (r & Hr & U); exists r; split; [exact Hr|]; intros eps He; destruct (U eps He) as (z & i & Hz &
      Hi); exists z, i. split; [apply (Hz 0%nat); cbn; lia|split; [apply (Hz 1%nat); cbn; lia|exact Hi]].
  - intros mu n x Hmu Hn Orb; apply (HU bool negb n mu x); trivial.
    + exists 2%nat, (fun k => match k with O => false | _ => true end), (fun j : bool => if j then 1%nat else 0%nat);
        split.
      * intros []; split; [lia|reflexivity|lia|reflexivity].
      * intros [|[|k]] Hk; [reflexivity|reflexivity|lia].
    + intros j; destruct (Hn j) as [-> | ->]; [rewrite C1|rewrite C2]; (rewrite Rabs_pos_eq; [split; [lia|lra]|lra]).
Qed.

(** The derivative of one flight and the next has an eigenvalue near (C A^n B) (C A^n' B) / (4 y y'), and nearly B for
    an eigenvector. *)
Lemma derivative_at_means g l x : derivative_at 1 (fun z _ => g (z 0%nat)) (fun _ _ => l) (fun _ => x) ->
  derivable_pt_lim g x l.
Proof.
  intros H eps He; destruct (H (eps / 2) ltac:(lra)) as (r & Hr & K); exists (mkposreal r Hr); intros h h0 Hh; cbn in
    Hh.
  pose proof (Rabs_pos_lt h h0) as Ph; specialize (K (fun _ => x + h) (Rabs h) ltac:(lra)).
  assert (W : within 1 (Rabs h) (minus (fun _ => x + h) (fun _ => x))) by (intros i _; unfold minus; right; f_equal;
    ring).
  specialize (K W 0%nat ltac:(lia)); unfold mult, minus in K; cbn in K.
  replace (g (x + h) - g x - (0 + l * (x + h - x))) with (((g (x + h) - g x) / h - l) * h) in K by (field; exact h0).
  rewrite Rabs_mult in K; apply Rmult_le_reg_r in K; lra.
Qed.
Lemma eigenvalue_words : Eigenvalue_statement -> Same_map_statement -> let M := grazing_map (1 / 2) (1 / 4) 1 in
  exists d, d > 0 /\ forall mu (n : bool -> nat) x D, Rabs mu <= d -> (forall j, n j = 1%nat \/ n j = 2%nat) ->
  orbit_near M bool negb n mu d x -> (forall j, derivative_at 2 (Nat.iter (n j) (step M mu)) (D j) (x j)) ->
  exists v lambda y y', Rabs (v 0%nat - Map.B M 0%nat) <= 1 / 100 /\ Rabs (v 1%nat - Map.B M 1%nat) <= 1 / 100 /\
  (forall i, (i < 2)%nat -> mult 2 (D false) (mult 2 (D true) v) i = lambda * v i) /\ 0 < y /\ 0 < y' /\
  y * y = - height M mu (x true) (n true - 1) /\ y' * y' = - height M mu (x false) (n false - 1) /\
  3 / 100 <= lambda * (2 * y * (2 * y')) <= 7 / 100.
Proof.
  intros H Sm M; destruct (Sm (1 / 2) (1 / 4) 1) as [[S _ _ _ _ _ Wq _] _]; try lra. assert (C1 : crossing M 1 = 1 /
    4) by (unfold crossing, power, mult; cbn; lra). assert (C2 : crossing M 2 = 3 / 16) by (unfold crossing, power,
    mult; cbn; lra). destruct (H M zero S Wq 2%nat (3 / 16) (1 / 100)) as (d & Hd & HU); [lra | lra|]; exists d; split;
    [exact Hd|]; intros mu n x D Hmu Hn Orb Der.
  destruct (HU bool negb negb n mu x D) as (V & lambda & HV); trivial.
  - intros []; auto.
  - intros j; destruct (Hn j) as [-> | ->]; [rewrite C1 | rewrite C2]; rewrite Rabs_pos_eq by lra; split; lia || lra.
  - destruct (HV true) as (W1 & E1 & Y1 & L1), (HV false) as (_ & E2 & Y2 & L2); cbn [negb Map.N M grazing_map] in *.
    set (y := sqrt (- height M mu (x true) (n true - 1))) in *; set (y' := sqrt (- height M mu (x false) (n false - 1)))
      in *.
    assert (Sq : forall t, sqrt t > 0 -> sqrt t * sqrt t = t) by (intros t Ht; apply sqrt_sqrt, Rnot_lt_le; intros Z;
      rewrite (sqrt_neg_0 t) in Ht; lra).
    exists (V true), (lambda true * lambda false), y, y'; split; [apply (W1 0%nat); cbn; lia | split; [apply (W1 1%nat);
      cbn; lia | split; [|split; [exact Y1 | split; [exact Y2 | split; [apply Sq, Y1 | split; [apply Sq, Y2|]]]]]]].
    + intros i Hi; unfold mult at 1; cbn [dot]; rewrite !E1 by (cbn; lia).
      specialize (E2 i Hi); unfold mult in E2; cbn [dot] in E2; rewrite Rmult_assoc, <- E2; ring.
    + assert (Cr : forall j, 3 / 16 <= crossing M (n j) <= 1 / 4) by (intros j; destruct (Hn j) as [-> | ->]; [rewrite
        C1 | rewrite C2]; lra). pose proof (Cr true); pose proof (Cr false); apply le_abs in L1, L2.
      set (p := lambda true * (2 * y)) in *; set (q := lambda false * (2 * y')) in *.
      replace (lambda true * lambda false * (2 * y * (2 * y'))) with (- p * - q) by (unfold p, q; ring).
      assert (A1 : 177 / 1000 <= - p <= 26 / 100) by lra; assert (A2 : 177 / 1000 <= - q <= 26 / 100) by lra; split.
      * apply Rle_trans with (177 / 1000 * (177 / 1000)); [lra | apply Rmult_le_compat; lra].
      * apply Rle_trans with (26 / 100 * (26 / 100)); [apply Rmult_le_compat; lra | lra].
Qed.
