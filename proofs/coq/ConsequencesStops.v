(** * What follows, worked out by hand, from the definitions and statements about oscillators between two stops *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOscillator StatementNonlinear StatementStops StatementNonlinearExamples
  Headline Derivatives ConsequencesSystems.
From Grazing Require ConsequencesHeadline.
Import Stops.
Open Scope R_scope.

(** ** What the definitions say; a hypothesis that is lost is missed here *)
Lemma grazing_at_means P : grazing_at P Minus -> (T P > 0 /\ forall t z k q u mu, q0 P (t + T P) = q0 P t /\ u0 P (t + T
  P) = u0 P t /\ a P (t + T P) q u mu = a P t q u mu /\ Q P z k (t + T P) mu = Q P z k t mu /\ U P z mu (t + T P) u = U
    P z mu t u)
  /\ (forall t, derivable_pt_lim (q0 P) t (u0 P t) /\ derivable_pt_lim (u0 P) t (a P t (q0 P t) (u0 P t) 0)) /\
  (0 < tG P < T P /\ q0 P (tG P) = Q P Minus 0 (tG P) 0 /\ u0 P (tG P) = Q P Minus 1 (tG P) 0) /\ (forall t, 0 <= t <= T
    P ->
  q0 P t > Q P Plus 0 t 0 /\ (t <> tG P -> q0 P t < Q P Minus 0 t 0)) /\ a P (tG P) (q0 P (tG P)) (u0 P (tG P)) 0 <
  Q P Minus 2 (tG P) 0 /\ (exists r, r > 0 /\ C1 (fun t q u mu => q0 P t - r <= q <= q0 P t + r /\ u0 P t - r <= u <= u0
    P t + r
  /\ Rabs mu <= r) (a P) (a_t P) (a_q P) (a_u P) (a_mu P)) /\ (exists r, r > 0 /\ forall z t mu, - r <= mu <= r ->
  derivable_pt_lim (fun t => Q P z 2 t mu) t (Q P z 3 t mu) /\ derivable_pt_lim (fun mu => Q P z 0 t mu) mu (Q_mu P z 0
    t mu)) /\
  (tau P >= 0 /\ (forall mu t, U P Minus mu t (Q P Minus 1 t mu) = Q P Minus 1 t mu) /\ forall mu t u, u > Q P Minus 1 t
    mu ->
  U P Minus mu t u <= Q P Minus 1 t mu) /\ exists r f3, r > 0 /\ (forall u, Rabs (u - u0 P (tG P)) <= r ->
  derivable_pt_lim (U P Minus 0 (tG P)) u (f3 (tG P) (q0 P (tG P)) u 0)) /\ f3 (tG P) (q0 P (tG P)) (u0 P (tG P)) 0 = -
    tau P.
Proof.
  intros [[A1 A2] B C D E F G (L0 & L1 & L2) (r & f1 & f2 & f3 & f4 & Hr & Ev & K)]; cbn [sgn] in E.
  split; [split; [lra|]; intros t z k q u mu; destruct (A2 t) as (X & Y & Z); destruct (Z z k q u mu) as (Z1 & Z2 & Z3);
    repeat split; assumption|]. split; [exact B|]; split; [exact C|]; split; [|split; [lra | split; [|split;
    [|split]]]].
  - intros t Ht; pose proof (D t Plus Ht ltac:(intros [_ X]; discriminate)) as X; unfold off in X; cbn in X; split;
    [lra|]. intros Ne; pose proof (D t Minus Ht ltac:(intros [Y _]; exact (Ne Y))) as Y; unfold off in Y; cbn in Y; lra.
  - destruct F as (q & Hq & [F1 F2 F3 F4 (F5 & F6 & F7 & F8)]); exists q; split; [exact Hq|].
    assert (In : forall t y v mu, q0 P t - q <= y <= q0 P t + q /\ u0 P t - q <= v <= u0 P t + q /\ Rabs mu <= q -> Rabs
      (y - q0 P t) <= q /\ Rabs (v - u0 P t) <= q /\ Rabs mu <= q) by (intros t y v mu (X & Y & Z); repeat split; [apply
      Rabs_le; lra | apply Rabs_le; lra | exact Z]).
    constructor; [intros; auto .. | repeat split; intros t y v mu HD; auto].
  - destruct G as (q & Hq & G); exists q; split; [exact Hq|]; intros z t mu Hm; split.
    + apply (in_t _ _ _ _ _ _ (G z 2%nat ltac:(lia)) t 0 0 mu), Rabs_le, Hm.
    + apply (in_mu _ _ _ _ _ _ (G z 0%nat ltac:(lia)) t 0 0 mu), Rabs_le, Hm.
  - split; [lra | split; [exact L1|]]; intros mu t u Hu; specialize (L2 mu t u); unfold rel in L2; cbn in L2; lra.
  - exists r, f3; split; [exact Hr | split; [|exact Ev]]; intros u Hu; apply (in_v _ _ _ _ _ _ K (tG P) (q0 P (tG P)) u
    0). rewrite Rminus_eq_0, Rabs_R0; lra.
Qed.
Lemma smooth_means P s : grazing_at P s -> (exists r, r > 0 /\ forall z k, (k <= 2)%nat -> C1 (fun _ _ _ mu => Rabs mu
  <= r) (fun t _ _ mu => Q P z k t mu) (fun t _ _ mu => Q P z (S k) t mu) (fun _ _ _ _ => 0) (fun _ _ _ _ => 0)
  (fun t _ _ mu => Q_mu P z k t mu)) /\ exists r f1 f2 f3 f4, r > 0 /\ C1 (fun t _ u mu => Rabs (t - tG P) <= r /\
  Rabs (u - u0 P (tG P)) <= r /\ Rabs mu <= r) (fun t _ u mu => U P s mu t u) f1 f2 f3 f4.
Proof.
  intros [_ _ _ _ _ _ G _ (r & f1 & f2 & f3 & f4 & Hr & _ & K)]; split; [exact G | exists r, f1, f2, f3, f4; split;
    assumption].
Qed.
Lemma flight_means P mu d t q u : motion_between P Minus mu d (fun i => 2 * i)%Z t q u -> (t 0%Z < t 1%Z /\ tG P - d <=
  t 0%Z <= tG P + d /\ tG P + 2 * T P - d <= t 1%Z <= tG P + 2 * T P + d) /\ (q 0%Z (t 0%Z) = Q P Minus 0 (t 0%Z) mu /\
    q 0%Z (t 1%Z) =
  Q P Minus 0 (t 1%Z) mu /\ u 0%Z (t 1%Z) > Q P Minus 1 (t 1%Z) mu /\ u 1%Z (t 1%Z) = U P Minus mu (t 1%Z) (u 0%Z (t
    1%Z))) /\
  (forall x, t 0%Z < x < t 1%Z -> Q P Plus 0 x mu < q 0%Z x < Q P Minus 0 x mu) /\ forall x, t 0%Z <= x <= t 1%Z ->
  derivable_pt_lim (q 0%Z) x (u 0%Z x) /\ derivable_pt_lim (u 0%Z) x (a P x (q 0%Z x) (u 0%Z x) mu) /\ q0 P x - d <= q
    0%Z x -
  (Q P Minus 0 x mu - Q P Minus 0 x 0) <= q0 P x + d /\ u0 P x - d <= u 0%Z x - (Q P Minus 1 x mu - Q P Minus 1 x 0) <=
    u0 P x + d.
Proof.
  intros H; destruct (H 0%Z 1%Z eq_refl) as [A B C D E F G I J], (H 1%Z 2%Z eq_refl) as [_ B' _ _ _ _ _ _ _].
  cbn in B, B'; apply le_abs in B, B'; unfold rel in I; cbn in I; split; [split; [exact A | split; lra]|]; split;
    [repeat split; trivial; lra|]. split; [exact G|]; intros x Hx; destruct (C x Hx) as [C1' C2'], (D x Hx) as [D1 D2];
    unfold off, rel in D1, D2; cbn in D1, D2; apply le_abs in D1, D2; split; [exact C1' | split; [exact C2' | split;
    lra]].
Qed.
Lemma measured_means P : let O := measured P Minus in Nonlinear.y0 O 5 = Q P Minus 0 5 0 - q0 P 5 /\ Nonlinear.v0 O 5 =
  Q P Minus 1 5 0 - u0 P 5 /\ forall mu t y v q u, q = Q P Minus 0 t mu - y -> u = Q P Minus 1 t mu - v -> Nonlinear.a O
    t y v mu
  = Q P Minus 2 t mu - a P t q u mu /\ Nonlinear.rebound O mu t v = Q P Minus 1 t mu - U P Minus mu t u.
Proof.
  cbn; unfold off, rel; cbn; split; [ring | split; [ring|]]; intros mu t y v q u -> ->.
  assert (E : forall x z, x + -1 * z = x - z) by (intros; ring); rewrite !E; split; ring.
Qed.
Lemma the_motion_between P s mu d N : one_between P s mu d N -> exists t q u, motion_between P s mu d N t q u /\
  forall t' q' u', motion_between P s mu d N t' q' u' -> t' 5%Z = t 5%Z /\ forall x, t 5%Z <= x <= t 6%Z ->
    q' 5%Z x = q 5%Z x /\ u' 5%Z x = u 5%Z x.
Proof. intros (t & q & u & M & V); exists t, q, u; split; [exact M|]; intros t' q' u' M'; apply (V t' q' u' M' 5%Z).
  Qed.
Lemma shapes_means M W t0 : shapes M W t0 Minus -> (derivable_pt_lim (M 2%nat) 5 (M 3%nat 5) /\ derivable_pt_lim (W Plus
  1%nat) 5 (W Plus 2%nat 5)) /\ (continuity_pt (M 3%nat) 5 /\ continuity_pt (W Plus 3%nat) 5) /\ (M 2%nat (2 * PI) = M
    2%nat 0 /\
  W Plus 1%nat (2 * PI) = W Plus 1%nat 0) /\ (0 < t0 < 2 * PI /\ M 0%nat t0 = W Minus 0%nat t0 /\ M 1%nat t0 = W Minus
    1%nat t0) /\
  (forall t, 0 <= t <= 2 * PI -> W Plus 0%nat t < M 0%nat t /\ (t <> t0 -> M 0%nat t < W Minus 0%nat t)) /\
  M 2%nat t0 < W Minus 2%nat t0.
Proof.
  intros [A B C D E F]; split; [split; [apply (A 2%nat 5); lia | apply (A 1%nat 5); lia]|]; split; [split; apply (B
    5)|]. split; [destruct (C 2%nat 0) as [C1' _], (C 1%nat 0) as [_ C2']; specialize (C2' Plus); rewrite Rplus_0_l in
    C1', C2'; auto|].
  split; [exact D|]; split; [|cbn in F; lra]; intros t Ht; pose proof (E t Plus Ht ltac:(intros [_ X]; discriminate)) as
    E1; cbn in E1; split; [lra|]; intros Ne; pose proof (E t Minus Ht ltac:(intros [X _]; exact (Ne X))) as E2; cbn in
    E2; lra.
Qed.

(** ** cos t above a wall -1 - (1 - cos 2 t) / 10, and below 2; and its mirror image, which grazes the upper stop *)
Definition M s (n : nat) t : R :=
  sgn s * match n with 0%nat => cos t | 1%nat => - 1 * sin t | 2%nat => - 1 * cos t | 3%nat => sin t | _ => 0 end.
Definition W s z (n : nat) t : R := - sgn z * match s, z with
  | Plus, Plus | Minus, Minus => match n with 0%nat => 1 + (1 - cos (2 * t)) / 10 | 1%nat => sin (2 * t) / 5 |
      2%nat => 2 * cos (2 * t) / 5 | 3%nat => - 4 * sin (2 * t) / 5 | _ => 0 end
  | _, _ => match n with 0%nat => 2 | _ => 0 end end.
Lemma sample s : shapes (M s) (W s) PI s.
Proof.
  pose proof PI_RGT_0 as HP; assert (Cpi : cos (2 * PI) = 1) by apply cos_2PI; assert (Spi : sin (2 * PI) = 0) by apply
    sin_2PI.
  assert (P : forall f, (f = cos \/ f = sin) -> forall t, f (t + 2 * PI) = f t /\ f (2 * (t + 2 * PI)) = f (2 * t)).
  { intros f Hf t; replace (2 * (t + 2 * PI)) with (2 * t + 2 * PI + 2 * PI) by ring; destruct Hf as [-> | ->]; pose
      proof cos_periods as Pc; pose proof sin_periods as Ps; split; rewrite ?(cos_plus _ (2 * PI)), ?(sin_plus _ (2 *
      PI)), Cpi, Spi; rewrite ?(cos_plus _ (2 * PI)), ?(sin_plus _ (2 * PI)), ?Cpi, ?Spi; ring. }
  constructor.
  - intros [|[|[|n]]] t Hn; try lia; (split; [|intros z]); destruct s; try destruct z; cbv beta iota delta [M W sgn];
      unfold Rdiv; derive_by fail; field.
  - intros t; split; [|intros z]; destruct s; try destruct z; cbv beta iota delta [M W sgn]; eapply D_continuous; unfold
      Rdiv; derive_by fail; reflexivity.
  - intros n t; destruct (P cos ltac:(auto) t) as [C1' C2'], (P sin ltac:(auto) t) as [S1' S2']; split; [|intros z];
      unfold M, W; destruct s; try destruct z; destruct n as [|[|[|[|n]]]]; rewrite ?C1', ?C2', ?S1', ?S2'; reflexivity.
  - split; [lra|]; unfold M, W; rewrite cos_PI, sin_PI, Cpi, Spi; destruct s; cbn [sgn]; split; field.
  - intros t z Ht Ne; pose proof (COS_bound t); pose proof (COS_bound (2 * t)).
    assert (C : t <> PI -> -1 < cos t) by (intros N; destruct (Rlt_le_dec t PI) as [O|O]; rewrite <- cos_PI; [apply
      cos_decreasing_1 | apply cos_increasing_1]; lra).
    unfold M, W; destruct s, z; cbn [sgn]; try lra; assert (-1 < cos t) by (apply C; intros E; apply Ne; auto); lra.
  - unfold M, W; rewrite cos_PI, Cpi; destruct s; cbn [sgn]; lra.
Qed.

(** Duffing's oscillator and a pendulum in one, driven gently. *)
Lemma gentle_numbers : Driven_statement -> forall c k gamma, matrix c (k + 3) Plus 0 1 gamma -> gamma <> 0 -> k + 3 <> 0
  -> exists A0, A0 > 0 /\ forall A, 0 < A <= A0 -> exists a1 a2 gamma' rate, generic (measured (driven (M Plus) (W Plus)
    PI A c k 7 3
  0 0 1) Plus) a1 a2 gamma' rate /\ - (1 / 100) <= a1 <= 1 / 100 /\ 99 / 100 <= a2 <= 101 / 100 /\ gamma - 1 / 100 <=
    gamma' <=
  gamma + 1 / 100 /\ 1 / (k + 3) - 1 / 100 <= rate <= 1 / (k + 3) + 1 / 100.
Proof.
  intros Dr c k gamma HM Hg Hk; destruct (driven_gently _ _ _ _ (Dr _ _ _ _ (sample Plus)) c k 7 3 0 0 1 0 1 gamma (1 /
    100)) as (A0 & HA0 & Near); [lra | exact HM | exact Hg | exact Hk | lra | lra|]; exists A0; split; [exact HA0|];
    intros A HA.
  destruct (Near A HA) as (a1 & a2 & gamma' & rate & HG & K1 & K2 & K3 & K4); exists a1, a2, gamma', rate; split; [exact
    HG|]; cbn [sgn] in K4; apply le_abs in K1, K2, K3, K4; repeat split; lra.
Qed.

(** A pendulum that is driven gently, of restitution exp (- |v|) / 2, at the lower stop and at the upper: a motion of
    three periods, with impacts near pi and 7 pi and none between. *)
Lemma pendulum_numbers : Reach_statement -> Driven_statement -> Stops_statement -> forall s, exists
  c h A0, A0 > 0 /\ forall A, 0 < A <= A0 -> exists rate d, rate * (sgn s * h) > 0 /\ d > 0 /\ forall eps,
  0 < eps <= d -> exists mu0, mu0 > 0 /\ forall mu, 0 < rate * mu < mu0 -> exists t0 t1 q u u1, Rabs (t0 - PI) <= eps /\
  Rabs (t1 - 7 * PI) <= eps /\ q t0 = - (sgn s * A * (1 + (1 - cos (2 * t0)) / 10)) /\
  q t1 = - (sgn s * A * (1 + (1 - cos (2 * t1)) / 10)) /\ (let v := u t1 + sgn s * A * sin (2 * t1) / 5 in
  sgn s * v < 0 /\ u1 = - (sgn s * A * sin (2 * t1) / 5) - (1 / 2) * (v * exp (1 * (sgn s * v)))) /\
  (forall x, t0 < x < t1 -> - (1 + (1 - cos (2 * x)) / 10) * A < sgn s * q x < 2 * A) /\ forall x, t0 <= x <= t1 ->
  derivable_pt_lim q x (u x) /\ Rabs (q x - sgn s * A * cos x) <= eps /\ derivable_pt_lim u x (- c * u x - h * sin (q x)
    +
  (- (sgn s * A * cos x) - c * (sgn s * A * sin x) + h * sin (A * (sgn s * cos x))) + mu).
Proof.
  intros Rch Dr St s; destruct (reach_3 Rch 1 (1 / 4) Plus ltac:(lra) ltac:(lra)) as (c & h & gamma & HM & Hg).
  replace (2 * PI * (1 / 4)) with (PI / 2) in HM by field; rewrite cos_PI2, Rmult_0_r, pow1 in HM; cbn [sgn] in Hg.
  assert (Hh : h <> 0).
  { intros ->; destruct HM as (A11 & A21 & A22 & E1 & E2 & HA); destruct (HA (fun _ => 1) (fun _ => 0)) as [F1 F2];
      [intros t; split; [apply D_const | eapply D_value; [apply D_const | ring]] | cbn in F1, F2].
    assert (A11 = 1) by lra; assert (A21 = 0) by lra; subst A11 A21; lra. }
  destruct (gentle_periods _ _ _ _ (Dr _ _ _ _ (sample s)) c 0 0 h 0 1 (1 / 2) 0 1 gamma 3%nat Plus Plus) as (A0 & HA0 &
    Near); [lra | rewrite Rplus_0_l; exact HM | lra | lra | lia | exact orbit_0_1_3 | cbn; lra|]. exists c, h, A0;
    split; [exact HA0|]; intros A HA; rewrite Rplus_0_l in Near; destruct (Near A HA) as (rate & Hs & d & Hd & V).
  set (P := driven (M s) (W s) PI A c 0 0 h 0 1 (1 / 2)) in *.
  pose proof (all_graze _ _ _ _ (Dr _ _ _ _ (sample s)) A c 0 0 h 0 1 (1 / 2) ltac:(lra) ltac:(lra)) as HP; fold P in
    HP; destruct (St P s HP) as (HO & r & Hr & Same).
  destruct (two_least d r Hd Hr) as (d' & Hd' & L3 & L4); exists rate, d'; split; [exact Hs | split; [exact Hd'|]];
    intros eps Heps; destruct (V eps ltac:(lra)) as (mu0 & Hm & X).
  assert (Hrate : 0 < Rabs rate) by (apply Rabs_pos_lt; intros Z; rewrite Z in Hs; lra).
  destruct (two_least mu0 (Rabs rate * r) Hm ltac:(apply Rmult_lt_0_compat; lra)) as (mu1 & Hmu1 & L5 & L6); exists mu1;
    split; [exact Hmu1|]; intros mu Hmu. assert (Hmr : Rabs mu <= r).
  { apply Rmult_le_reg_l with (Rabs rate); [exact Hrate|]; rewrite <- Rabs_mult, Rabs_pos_eq; lra. }
  specialize (X mu ltac:(cbn; lra) (fun i => 3 * i)%Z ltac:(intros; cbv beta; lia)); destruct X as [X _]; apply (Same mu
    eps _ Hmr ltac:(lra)) in X.
  destruct X as (t & q & u & HM' & _), (HM' 0%Z 1%Z eq_refl) as [A1 A2 A3 A4 A5 A6 A7 A8 A9], (HM' 1%Z 2%Z eq_refl) as
    [_ B2 _ _ _ _ _ _ _]; cbn in A2, B2. exists (t 0%Z), (t 1%Z), (q 0%Z), (u 0%Z), (u 1%Z (t 1%Z)).
  replace (PI + 2 * PI * 0) with PI in A2 by ring; replace (PI + 2 * PI * 3) with (7 * PI) in B2 by ring.
  split; [exact A2 | split; [exact B2|]]; split; [rewrite A5; cbn; unfold W; destruct s; cbn; lra|]; split; [rewrite A6;
    cbn; unfold W; destruct s; cbn; lra|]; split; [|split].
  - unfold rel in A8; cbn in A8, A9; replace (u 0%Z (t 1%Z) + sgn s * A * sin (2 * t 1%Z) / 5) with (u 0%Z (t 1%Z) - A *
      W s s 1 (t 1%Z)) by (unfold W; destruct s; cbn; field). cbv zeta; split; [exact A8|]; rewrite A9; unfold W;
      destruct s; cbn; lra.
  - intros x Hx; specialize (A7 x Hx); cbn in A7; unfold W in A7; destruct s; cbn in A7 |- *; lra.
  - intros x Hx; destruct (A3 x Hx) as [D1 D2], (A4 x Hx) as [N _]; split; [exact D1 | split].
    + unfold off in N; cbn in N; match goal with |- Rabs ?w <= _ => match type of N with Rabs ?y <= _ => replace w with
        (sgn s * y) by (unfold M; destruct s; cbn; ring) end end. destruct s; cbn [sgn] in *; [rewrite Rmult_1_l; exact
        N|]; rewrite Rabs_mult, (Rabs_left (-1)) by lra; lra.
    + eapply D_value; [exact D2 | unfold P, M; cbn -[sgn]; ring].
Qed.
(** None can be one of [never]: the correspondence of motions, not of the one alone. *)
Lemma none_between P s mu : Stops_statement -> grazing_at P s -> exists r, r > 0 /\ forall d N, Rabs mu <= r -> d <= r
  -> (forall t y v, ~ nonlinear_motion (measured P s) mu d N t y v) <-> forall t q u, ~ motion_between P s mu d N t q u.
Proof.
  intros St HP; destruct (St P s HP) as (_ & r & Hr & H); exists r; split; [exact Hr|]; intros d N Hm Hd; destruct (H mu
    d N Hm Hd) as [_ [[K K'] _]]; split; intros No t q u HM; [destruct K as (t' & y & v & HM'); [eauto|] | destruct K'
    as (t' & y & v & HM'); [eauto|]]; exact (No _ _ _ HM').
Qed.
(** What is born between the stops is unstable, from its impact 0 on, too: of periods 1 and 2 in any order, at (1,
  1/4). *)
Lemma unstable_between : Theorem_1_statement -> Stops_statement -> forall P s gamma, grazing_at P s ->
  generic (measured P s) 1 (1 / 4) gamma 1 -> gamma > 0 -> exists mu0 d, mu0 > 0 /\ d > 0 /\ forall mu n N t q u,
  - mu0 < mu < 0 -> ConsequencesHeadline.over_1_2 n -> (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z ->
  motion_between P s mu d N t q u -> exists r, r > 0 /\ forall eps, eps > 0 -> exists l t' q' u', (0 < l)%Z /\
  (forall i, (0 <= i < l)%Z -> flight P s mu d N t' q' u' i (i + 1)%Z) /\ Rabs (t' 0%Z - t 0%Z) <= eps /\
  Rabs (u' 0%Z (t' 0%Z) - u 0%Z (t 0%Z)) <= eps /\ ~ (Rabs (t' l - t l) <= r /\ Rabs (u' l (t' l) - u l (t l)) <= r).
Proof.
  intros T St P s gamma HP HG Hg; destruct (St P s HP) as (HO & r & Hr & H).
  destruct (ConsequencesHeadline.Theorem_1_numbers T (Moves (measured P s) 1) gamma (conj HO HG)) as (d & Hd & K).
  destruct (two_least d r Hd Hr) as (e & He & L1 & L2), (K e ltac:(lra)) as (m & Hm & Q), (two_least m r Hm Hr) as (mu0
    & Hmu0 & L3 & L4). exists mu0, e; split; [exact Hmu0 | split; [exact He|]]; intros mu n N t q u Hmu Hn HN HM.
  destruct (proj1 (Q n mu Hn) Hg ltac:(cbn; lra) N HN) as [_ Un].
  destruct (H mu e N ltac:(rewrite Rabs_left; lra) L2) as (_ & _ & U), (U Un t q u HM) as (r0 & Hr0 & V).
  exists r0; split; [exact Hr0|]; intros eps Heps; destruct (V 0%Z eps Heps) as (l & t' & q' & u' & L & Fl & [N1 N2] &
    Out).
  exists l, t', q', u'; auto 6.
Qed.
(** All of region 3: at r = 1/2, y = 1/6, (a1, a2) is (1/2, 1/4). *)
Lemma region_3_again : Driven_statement -> exists c k gamma, gamma < 0 /\
  generic (measured (driven (M Minus) (W Minus) PI 1 c k 0 0 5 1 (1 / 2)) Minus) (1 / 2) (1 / 4) gamma (- 1 / k).
Proof.
  intros Dr; destruct (all_region_3 _ _ _ _ (Dr _ _ _ _ (sample Minus)) 1 5 1 (1 / 2) (1 / 2) (1 / 6) Minus ltac:(lra)
    ltac:(lra)) as (c & k & gamma & Hg & HG). replace (2 * PI * (1 / 6)) with (PI / 3) in HG by field; rewrite cos_PI3
    in HG.
  replace (2 * (1 / 2) * (1 / 2)) with (1 / 2) in HG by field; replace ((1 / 2) ^ 2) with (1 / 4) in HG by (cbn; field).
  exists c, k, gamma; split; [cbn in Hg; lra | exact HG].
Qed.
(** With b = h = e = x = 0 it is linear; it has what [matrix] says, whatever its stops. *)
Lemma linear_again : Driven_statement -> forall k gamma, matrix 0 k Plus 0 1 gamma -> gamma <> 0 -> k <> 0 ->
  let P := driven (M Plus) (W Plus) PI 1 0 k 0 0 0 0 1 in generic (measured P Plus) 0 1 gamma (1 / k) /\ forall t q u
    mu,
  a P t q u mu = - k * q + (k * cos t - cos t) + mu /\ U P Plus mu t u = - 2 * (sin (2 * t) / 5) - u.
Proof.
  intros D k gamma HM Hg Hk; split; [apply (as_linear _ _ _ _ (D _ _ _ _ (sample Plus)) 1 0 k 0 0 1 0 1 gamma);
    assumption|].
  intros t q u mu; cbn; unfold M, W; cbn; rewrite !Rmult_0_l, exp_0; split; field.
Qed.
(** Of amplitude 1/100: the force at the time 0, where it would return in about four periods, and its one motion with an
    impact in three periods, for small mu > 0. *)
Lemma duffing_numbers : Duffing_statement -> let P := driven (M Plus) (W Plus) PI (1 / 100) 0 (1 / 16) 1 0 0 0 (1 / 2) in let O :=
  measured P Plus in (forall q u mu, a P 0 q u mu = - q / 16 - q ^ 3 + (1 / 1600 + 1 / 1000000 - 1 / 100) + mu) /\ exists a1 a2
  gamma rate, generic O a1 a2 gamma rate /\ - (11 / 100) <= a1 <= 11 / 100 /\ 88 / 100 <= a2 <= 112 / 100 /\ 378 / 100 <= gamma
  <= 422 / 100 /\ 12 <= rate <= 21 /\ exists d, d > 0 /\ forall eps, 0 < eps <= d -> exists mu0, mu0 > 0 /\ forall mu, 0 < mu <
  mu0 -> one_nonlinear_motion O mu eps (fun i => 3 * i)%Z.
Proof.
  intros H P O; split; [intros q u mu; cbn; unfold M; cbn; rewrite sin_0, cos_0; field|].
  destruct (H _ _ _ _ (1 / 100) (1 / 2) (sample Plus)) as (a1 & a2 & gamma & rate & HG & A1 & A2 & A3 & A4 & d & Hd & B).
  - intros t; unfold M; cbn [sgn]; rewrite Rmult_1_l; pose proof (COS_bound t); apply Rabs_le; lra.
  - lra.
  - lra.
  - fold P in HG, B; fold O in HG, B; cbn [sgn] in A4; apply le_abs in A1, A2, A3; exists a1, a2, gamma, rate; split; [exact HG |
      split; [lra | split; [lra | split; [lra | split; [lra|]]]]]. exists d; split; [exact Hd|]; intros eps He; destruct (B eps
      He) as (mu0 & Hm & W'); exists (mu0 / 21); split; [apply Rdiv_lt_0_compat; lra|]; intros mu Hmu.
    assert (Q1 : 0 < rate * mu) by (apply Rmult_lt_0_compat; lra); assert (Q2 : rate * mu <= 21 * mu) by (apply
      Rmult_le_compat_r; lra); assert (Q3 : 21 * mu < 21 * (mu0 / 21)) by (apply Rmult_lt_compat_l; lra); replace (21 * (mu0 /
      21)) with mu0 in Q3 by field. apply (W' mu ltac:(cbn; lra) (fun i => 3 * i)%Z ltac:(intros; cbv beta; lia)).
Qed.
