(** * What follows, worked out by hand, from the definitions and statements about oscillators that rattle between two
      stops *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementWords StatementUnstable StatementNonlinear StatementBouncing StatementRattling
  Headline Derivatives NonlinearChain NonlinearBouncingExample.
From Grazing Require ConsequencesHeadline.
Import Rattling.
Open Scope R_scope.

(** ** What the definitions say; a hypothesis that is lost is missed here *)
Lemma image_means P : (mirror P = Minus -> image P Plus = Minus /\ image P Minus = Plus /\ turned P 3 = -3) /\
  (mirror P = Plus -> image P Plus = Plus /\ image P Minus = Minus /\ turned P 3 = 3).
Proof. unfold image, turned; split; intros ->; cbn; repeat split; ring. Qed.
Lemma passes_means P mu q u q' u' : passes P 2 mu 9 q u q' u' -> q' = q /\ (impact P 2 = false -> u' = u) /\
  (impact P 2 = true -> u' = U P (stop P 2) mu 9 u).
Proof. intros [A B]; destruct (impact P 2); repeat split; trivial; discriminate. Qed.
Lemma rattles_means P : rattles P -> mirror P = Minus -> k P = 3%nat -> stop P 0 = Plus -> (T P > 0 /\ forall c t q u mu n,
  s P (c + 3)%Z = s P c + T P /\ (stop P c = Plus -> stop P (c + 3) = Minus) /\ impact P (c + 3) = impact P c /\
  q0 P (c + 3) (t + T P) = - q0 P c t /\ u0 P (c + 3) (t + T P) = - u0 P c t /\ a P (t + T P) (- q) (- u) mu = - a P t q u
  mu /\ Q P Plus n (t + T P) mu = - Q P Minus n t mu /\ U P Plus mu (t + T P) (- u) = - U P Minus mu t u) /\
  (forall c, derivable_pt_lim (q0 P c) (s P c) (u0 P c (s P c)) /\ derivable_pt_lim (u0 P c) (s P c) (a P (s P c) (q0 P c (s
  P c)) (u0 P c (s P c)) 0)) /\
  (forall c, s P c < s P (c + 1)%Z /\ q0 P (c + 1) (s P (c + 1)%Z) = q0 P c (s P (c + 1)%Z)) /\
  (forall t, t = s P 4%Z -> impact P 3 = true -> stop P 3 = Minus -> stop P 4 = Minus /\ q0 P 3 t = Q P Minus 0 t 0 /\
    u0 P 3 t > Q P Minus 1 t 0 /\ u0 P 4 t < Q P Minus 1 t 0 /\ u0 P 4 t = U P Minus 0 t (u0 P 3 t)) /\
  (forall t, t = s P 4%Z -> impact P 3 = false -> stop P 3 = Minus -> q0 P 3 t < Q P Minus 0 t 0 /\ u0 P 4 t = u0 P 3 t) /\
  (s P 0%Z < tG P < s P 1%Z /\ q0 P 0 (tG P) = Q P Plus 0 (tG P) 0 /\ u0 P 0 (tG P) = Q P Plus 1 (tG P) 0 /\
    a P (tG P) (q0 P 0 (tG P)) (u0 P 0 (tG P)) 0 > Q P Plus 2 (tG P) 0) /\
  (forall t, s P 0%Z < t < s P 1%Z -> t <> tG P -> q0 P 0 t > Q P Plus 0 t 0) /\
  (forall t, s P 0%Z <= t <= s P 1%Z -> q0 P 0 t < Q P Minus 0 t 0) /\
  (exists r, r > 0 /\ forall c, C1 (fun t q u mu => s P c - r <= t <= s P (c + 1)%Z + r /\ Rabs (q - q0 P c t) <= r /\ Rabs
    (u - u0 P c t) <= r /\ Rabs mu <= r) (a P) (a_t P) (a_q P) (a_u P) (a_mu P)) /\
  (exists r, r > 0 /\ forall z t mu, - r <= mu <= r -> derivable_pt_lim (fun t => Q P z 2 t mu) t (Q P z 3 t mu) /\
    derivable_pt_lim (fun mu => Q P z 0 t mu) mu (Q_mu P z 0 t mu)) /\
  (tau P >= 0 /\ (forall mu t, U P Plus mu t (Q P Plus 1 t mu) = Q P Plus 1 t mu) /\ forall mu t u, u < Q P Plus 1 t mu ->
    U P Plus mu t u >= Q P Plus 1 t mu) /\
  (exists r f3, r > 0 /\ (forall u, Rabs (u - u0 P 0 (tG P)) <= r -> derivable_pt_lim (U P Plus 0 (tG P)) u (f3 (tG P) (q0 P
    0 (tG P)) u 0)) /\ f3 (tG P) (q0 P 0 (tG P)) (u0 P 0 (tG P)) 0 = - tau P) /\
  forall t u z, t = s P 4%Z -> u = u0 P 3 t -> z = stop P 3 -> impact P 3 = true -> derivable_pt_lim (fun t => U P z 0 t u) t
    (U_t P z 0 t u) /\ derivable_pt_lim (fun u => U P z 0 t u) u (U_u P z 0 t u) /\ derivable_pt_lim (fun mu => U P z mu t u)
    0 (U_mu P z 0 t u).
Proof.
  intros [A B C D E F G I (L0 & L) K M] HM Hk H0; rewrite Hk in *; change (Z.of_nat 3) with 3%Z in *; rewrite H0 in *; cbv
    zeta in *; destruct A as (A1 & _ & A2).
  split; [split; [lra|]; intros c t q u mu n; destruct (A2 c t) as (X1 & X2 & X3 & X4 & X5 & X6); destruct (X6 Minus n q u mu)
    as (Y1 & Y2 & Y3); unfold turned, image in *; rewrite HM in *; cbn [sgn] in *; repeat rewrite <- (Ropp_mult_distr_l 1) in
    *; rewrite ?Rmult_1_l in *; repeat split; trivial; rewrite X2; intros ->; reflexivity|].
  split; [destruct B as (r & Hr & B); intros c; apply B; pose proof (proj1 (C c)); lra|].
  split; [intros c; split; [apply (C c) | apply (proj1 (proj2 (C c)))]|]. change 4%Z with (3 + 1)%Z; split; [|split].
  - intros t -> Im Em; destruct (C 3%Z) as (_ & [X1 X2] & X3); rewrite Im, Em in *; destruct X3 as (X3 & X4 & X5); unfold off,
      rel in *; cbn [sgn] in *; repeat split; trivial; lra.
  - intros t -> Im Em; destruct (C 3%Z) as (_ & [X1 X2] & X3); rewrite Im, Em in *; unfold off in X3; cbn [sgn] in X3; split;
      [lra | exact X2].
  - destruct D as (D1 & D2 & D3 & D4); cbn [sgn] in D4; split; [repeat split; trivial; lra|]; split; [|split; [|split; [|split;
      [|split; [|split]]]]].
    + intros t Ht Ne; assert (X := E 0%Z t Ht); rewrite H0 in X; unfold off in X; cbn [sgn] in X; apply Rminus_gt_0_lt; rewrite
        <- (Rmult_1_l (_ - _)); apply X; intros N [N1 N2]; assert (N = 0%Z) by lia; subst N; apply Ne; rewrite N2; ring.
    + intros t Ht; assert (X := F 0%Z t Minus Ht); rewrite H0 in X; specialize (X ltac:(discriminate)); unfold off in X; cbn
        [sgn] in X; lra.
    + destruct G as (q & Hq & G); exists q; split; [exact Hq | exact G].
    + destruct I as (q & Hq & G'); exists q; split; [exact Hq|]; intros z t mu Hm; split; [apply (in_t _ _ _ _ _ _ (G' z 2%nat
        ltac:(lia)) t 0 0 mu), Rabs_le, Hm | apply (in_mu _ _ _ _ _ _ (G' z 0%nat ltac:(lia)) t 0 0 mu), Rabs_le, Hm].
    + split; [lra | split; [apply L|]]; intros mu t u Hu; destruct L as [_ L2]; specialize (L2 mu t u); unfold rel in L2; cbn
        [sgn] in L2; lra.
    + destruct K as (r & f1 & f2 & f3 & f4 & Hr & Ev & K); exists r, f3; split; [exact Hr | split; [|exact Ev]]; intros u Hu;
        apply (in_v _ _ _ _ _ _ K (tG P) (q0 P 0 (tG P)) u 0). rewrite !Rminus_eq_0, Rabs_R0; lra.
    + intros t u z -> -> -> Im; destruct M as (r & Hr & M); destruct (M 3%Z Im) as [M1 _ M3 M4 _]; assert (Dm : Rabs (s P (3 +
        1)%Z - s P (3 + 1)%Z) <= r /\ Rabs (u0 P 3 (s P (3 + 1)%Z) - u0 P 3 (s P (3 + 1)%Z)) <= r /\ Rabs 0 <= r) by (rewrite
        !Rminus_eq_0, Rabs_R0; lra). split; [apply (M1 _ 0 _ _ Dm) | split; [apply (M3 _ 0 _ _ Dm) | apply (M4 _ 0 _ _ Dm)]].
Qed.
Lemma smooth_means P : rattles P -> (exists r, r > 0 /\ forall z n, (n <= 2)%nat -> C1 (fun _ _ _ mu => Rabs mu <= r) (fun t
  _ _ mu => Q P z n t mu) (fun t _ _ mu => Q P z (S n) t mu) (fun _ _ _ _ => 0) (fun _ _ _ _ => 0) (fun t _ _ mu => Q_mu P z
  n t mu)) /\ exists r f1 f2 f3 f4, r > 0 /\ C1 (fun t _ u mu => Rabs (t - tG P) <= r /\ Rabs (u - u0 P 0 (tG P)) <= r /\
  Rabs mu <= r) (fun t _ u mu => U P (stop P 0) mu t u) f1 f2 f3 f4.
Proof. intros [_ _ _ _ _ _ _ I _ (r & f1 & f2 & f3 & f4 & Hr & _ & K) _]; split; [exact I | exists r, f1, f2, f3, f4; auto].
  Qed.
(** Arc 2 is seen from the upper stop, downwards, and the next from the lower. *)
Lemma seen_from_means P : stop P 2 = Minus -> stop P 3 = Plus -> let O := seen_from P in Bouncing.y0 O 2 5 = Q P Minus 0 5 0
  - q0 P 2 5 /\ Bouncing.v0 O 2 5 = Q P Minus 1 5 0 - u0 P 2 5 /\ (forall mu t y v q u, q = Q P Minus 0 t mu - y -> u = Q P
  Minus 1 t mu - v -> Bouncing.a O 2 t y v mu = Q P Minus 2 t mu - a P t q u mu /\ Bouncing.rebound O 2 mu t v = Q P Minus 1 t
  mu - U P Minus mu t u) /\ Bouncing.face O 2 = -1 /\ forall mu t, t = s P 3%Z -> Bouncing.place O 2 mu = Q P Minus 0 t mu - Q
  P Plus 0 t mu /\ Bouncing.speed O 2 mu = Q P Minus 1 t mu - Q P Plus 1 t mu.
Proof.
  intros E2 E3; cbn; rewrite E2, E3; unfold off, rel; cbn; assert (E : forall x z, x + -1 * z = x - z) by (intros; ring).
  split; [ring | split; [ring|]]; split; [intros mu t y v q u -> ->; rewrite !E; split; ring|]; split; [ring|]; intros mu t ->;
    split; ring.
Qed.
(** From a touch of the lower stop to one of the upper, half a period later, past an impact on the upper stop and a time
    at which it is between the stops. *)
Lemma rides_mean P mu d t q u : k P = 2%nat -> stop P 0 = Plus -> stop P 1 = Minus -> stop P 2 = Minus -> impact P 0 = false ->
  impact P 1 = true -> rattling_motion P mu d (fun i => i) t q u -> (tG P - d <= t 0%Z <= tG P + d /\ tG P + T P - d <= t
  1%Z <= tG P + T P + d /\ u 1%Z (t 1%Z) = U P Minus mu (t 1%Z) (u 0%Z (t 1%Z))) /\ exists r p w,
  (r 0%nat = t 0%Z /\ p 0%nat (t 0%Z) = Q P Plus 0 (t 0%Z) mu /\ r 3%nat = t 1%Z /\ p 2%nat (t 1%Z) = Q P Minus 0 (t 1%Z) mu
    /\ w 2%nat (t 1%Z) > Q P Minus 1 (t 1%Z) mu) /\
  (r 1%nat = s P 1%Z /\ p 1%nat (r 1%nat) = p 0%nat (r 1%nat) /\ w 1%nat (r 1%nat) = w 0%nat (r 1%nat)) /\
  (s P 2%Z - d <= r 2%nat <= s P 2%Z + d /\ r 1%nat < r 2%nat /\ p 1%nat (r 2%nat) = Q P Minus 0 (r 2%nat) mu /\ w 1%nat (r
    2%nat) > Q P Minus 1 (r 2%nat) mu /\ p 2%nat (r 2%nat) = p 1%nat (r 2%nat) /\ w 2%nat (r 2%nat) = U P Minus mu (r 2%nat)
    (w 1%nat (r 2%nat))) /\ (forall x, r 1%nat < x < r 2%nat -> Q P Plus 0 x mu < p 1%nat x < Q P Minus 0 x mu) /\
  (forall x, r 1%nat <= x <= r 2%nat -> derivable_pt_lim (p 1%nat) x (w 1%nat x) /\ derivable_pt_lim (w 1%nat) x (a P x (p
    1%nat x) (w 1%nat x) mu) /\ q0 P 1 x - d <= p 1%nat x - (Q P Minus 0 x mu - Q P Minus 0 x 0) <= q0 P 1 x + d /\
    u0 P 1 x - d <= w 1%nat x - (Q P Minus 1 x mu - Q P Minus 1 x 0) <= u0 P 1 x + d) /\
  (forall x, r 1%nat <= x < r 2%nat -> q 0%Z x = p 1%nat x /\ u 0%Z x = w 1%nat x) /\
  forall x, r 2%nat <= x <= r 3%nat -> q 0%Z x = p 2%nat x /\ u 0%Z x = w 2%nat x.
Proof.
  intros Hk S0 S1 S2 I0 I1 H; destruct (H 0%Z 1%Z eq_refl) as (r & p & w & R); replace (others (seen_from P) (fun i => i) 0 1)
    with 2%nat in R by (unfold others; change (Bouncing.k (seen_from P)) with (k P); rewrite Hk; reflexivity).
  assert (On : forall i m, on P (fun i => i) i m = (2 * i + Z.of_nat m)%Z) by (intros i m; unfold on, arc; change (Bouncing.k
    (seen_from P)) with (k P); rewrite Hk; reflexivity).
  destruct R as [[R1 R2] (R3 & R4 & R5) R6 R7 R8 R9 R10 R11 R12 R13 R14 R15]; cbv zeta in *; rewrite On in R2, R4, R5, R15; cbn
    [Z.of_nat Z.mul Z.add Pos.of_succ_nat Pos.succ Pos.mul] in R2, R4, R5, R15; rewrite S0 in R2; rewrite S2 in R4, R5, R15.
  pose proof (R6 0%Z (or_introl eq_refl)) as N0; pose proof (R6 1%Z (or_intror eq_refl)) as N1; pose proof (R7 2%nat ltac:(lia))
    as N2; rewrite On in N2; cbn [Z.of_nat Z.mul Z.add Pos.of_succ_nat Pos.succ Pos.mul] in N2; apply le_abs in N0, N1, N2.
  pose proof (R9 0%nat ltac:(lia)) as E0; pose proof (R9 1%nat ltac:(lia)) as E1; rewrite !On in E0, E1; cbn [Z.of_nat Z.mul
    Z.add Pos.of_succ_nat Pos.succ Pos.mul] in E0, E1; rewrite I0 in E0; rewrite I1, S1 in E1.
  pose proof (R13 0%nat ltac:(lia)) as F0; pose proof (R13 1%nat ltac:(lia)) as F1; cbv zeta in F0, F1; unfold passes in F0, F1;
    rewrite On in F0, F1; cbn [Z.of_nat Z.mul Z.add Pos.of_succ_nat Pos.succ Pos.mul] in F0, F1; rewrite I0 in F0; rewrite I1,
    S1 in F1. unfold off, rel in R2, R4, R5, E1; cbn [sgn] in R2, R4, R5, E1.
  split; [repeat split; try lra; exact R15|]; exists r, p, w; split; [repeat split; trivial; lra|]; split; [split; [exact E0 |
    exact F0]|]. split; [pose proof (R8 1%nat ltac:(lia)); repeat split; try apply F1; lra|]; split; [intros x Hx; apply (R12
    1%nat); [lia | exact Hx]|]; split; [|split].
  - intros x Hx; destruct (R10 1%nat x ltac:(lia) Hx) as [D1 D2], (R11 1%nat x ltac:(lia) Hx) as [B1 B2]; rewrite On in B1, B2;
      cbn [Z.of_nat Z.mul Z.add Pos.of_succ_nat Pos.succ Pos.mul] in B1, B2; rewrite S1 in B1, B2; unfold off, rel in B1, B2;
      cbn [sgn] in B1, B2; apply le_abs in B1, B2; split; [exact D1 | split; [exact D2 | split; lra]].
  - intros x Hx; apply (R14 1%nat); [lia | lra | intros; lra].
  - intros x Hx; apply (R14 2%nat); [lia | exact Hx | reflexivity].
Qed.
Lemma the_rattling_motion P mu d N : one_rattling_motion P mu d N -> exists t q u, rattling_motion P mu d N t q u /\
  forall t' q' u', rattling_motion P mu d N t' q' u' -> t' 5%Z = t 5%Z /\ forall x, t 5%Z <= x <= t 6%Z ->
    q' 5%Z x = q 5%Z x /\ u' 5%Z x = u 5%Z x.
Proof. intros (t & q & u & M & V); exists t, q, u; split; [exact M|]; intros t' q' u' M'; apply (V t' q' u' M' 5%Z). Qed.

(** ** What [never] and [exactly] say of them *)
Lemma none_rattling P : Rattling_statement -> rattles P -> exists r, r > 0 /\ forall mu d N, Rabs mu <= r -> d <= r -> (forall
  i, N i <= N (i + 1))%Z -> (forall t y v, ~ bouncing_motion (seen_from P) mu d N t y v) <-> forall t q u, ~ rattling_motion P
  mu d N t q u.
Proof.
  intros St HP; destruct (St P HP) as (_ & r & Hr & H); exists r; split; [exact Hr|]; intros mu d N Hm Hd HN; destruct (H mu
    d N Hm Hd HN) as [_ [[K K'] _]]; split; intros No t q u HM; [destruct K as (t' & y & v & HM'); [eauto|] | destruct K'
    as (t' & y & v & HM'); [eauto|]]; exact (No _ _ _ HM').
Qed.
Lemma exactly_rattling a1 a2 n g : exactly a1 a2 n Plus g -> Rattling_statement -> forall P gamma rate, rattles P ->
  generic_round (seen_from P) a1 a2 gamma rate -> rate <> 0 -> sgn g * gamma > 0 -> exists d, d > 0 /\ forall eps, 0 < eps <= d
  -> exists mu0, mu0 > 0 /\ forall mu N, 0 < rate * mu < mu0 -> (forall i, N (i + 1) = N i + Z.of_nat n)%Z ->
  one_rattling_motion P mu eps N /\ forall t q u, rattling_motion P mu eps N t q u -> unstable_motion (rides P mu eps N) t u.
Proof.
  intros H St P gamma rate HP HG Hr Hg; destruct (St P HP) as (HO & r & Pr & Same), (H (Bounces (seen_from P) rate) gamma (conj
    HO HG)) as [B _]; destruct (B Hg) as (d & Hd & V), (two_least d r Hd Pr) as (d' & Hd' & L1 & L2); exists d'; split; [exact
    Hd'|]; intros eps He; destruct (V eps ltac:(lra)) as (mu0 & Hm & W).
  assert (Pa : 0 < Rabs rate) by (apply Rabs_pos_lt, Hr); destruct (two_least mu0 (Rabs rate * r) Hm ltac:(apply
    Rmult_lt_0_compat; lra)) as (mu1 & Hmu1 & L3 & L4); exists mu1; split; [exact Hmu1|]; intros mu N Hmu HN.
  assert (Hmr : Rabs mu <= r) by (apply Rmult_le_reg_l with (Rabs rate); [exact Pa|]; rewrite <- Rabs_mult, Rabs_pos_eq; lra).
  destruct (W mu ltac:(cbn; lra) N HN) as [One Un]; destruct (Same mu eps N Hmr ltac:(lra) ltac:(intros i; rewrite HN; lia)) as
    (S1 & _ & S3). split; [apply S1, One | exact (S3 Un)].
Qed.

(** ** cos t drives a mass between stops at -1 and 1, and (q + cos t)^3 pushes it off its way; it loses half of its velocity
    at an impact. For mu = 0 it moves as - cos t, touches the lower stop at 0 and the upper at pi, and is its own mirror
    image after half a period. It is seen from the stop that is touched next. *)
Definition sample : Rattling.t := {| T := PI; mirror := Minus;
  a := fun t q u mu => (1 + mu) * cos t + (q + cos t) * (q + cos t) * (q + cos t);
  a_t := fun t q u mu => (1 + mu) * - sin t + 3 * (q + cos t) * (q + cos t) * - sin t;
  a_q := fun t q u mu => 3 * (q + cos t) * (q + cos t); a_u := fun t q u mu => 0; a_mu := fun t q u mu => cos t;
  Q := fun z n t mu => match n with 0%nat => - sgn z | _ => 0 end; Q_mu := fun z n t mu => 0;
  U := fun z mu t u => - (1 / 2) * u; U_t := fun z mu t u => 0; U_u := fun z mu t u => - (1 / 2); U_mu := fun z mu t u => 0;
  tau := 1 / 2; k := 1; s := fun c => PI * IZR c - PI / 2; stop := fun c => if Z.even c then Plus else Minus;
  impact := fun c => false; q0 := fun c t => - cos t; u0 := fun c t => sin t; tG := 0 |}.
Lemma half_turns c x : cos (x + PI * IZR c) = sgn (stop sample c) * cos x /\ sin (x + PI * IZR c) = sgn (stop sample c) * sin x.
Proof.
  cbn [stop sample]; destruct (Z.even c) eqn:E; cbn [sgn].
  - apply Z.even_spec in E; destruct E as (m & ->); rewrite mult_IZR; replace (PI * (2 * IZR m)) with (2 * PI * IZR m) by ring;
      rewrite cos_periods, sin_periods; split; ring.
  - assert (Od : Z.odd c = true) by (rewrite <- Z.negb_even, E; reflexivity); apply Z.odd_spec in Od; destruct Od as (m & ->);
      rewrite plus_IZR, mult_IZR; replace (x + PI * (2 * IZR m + 1)) with (x + PI + 2 * PI * IZR m) by ring; rewrite
      cos_periods, sin_periods, neg_cos, neg_sin; split; ring.
Qed.
Lemma sgn_square z : sgn z * sgn z = 1. Proof. destruct z; cbn; ring. Qed.
Lemma sample_off c z x : off sample z 0 (x + PI * IZR c) (q0 sample c (x + PI * IZR c)) = 1 - sgn z * sgn (stop sample c) *
  cos x.
Proof. unfold off; cbn [q0 sample Q]; rewrite (proj1 (half_turns c x)); cbn; destruct z; cbn; ring. Qed.
Ltac split_time t c x := set (x := t - PI * IZR c); replace t with (x + PI * IZR c) in * by (unfold x; ring).
Lemma sample_rattles : rattles sample.
Proof.
  pose proof PI_RGT_0 as HP; assert (Cst : forall D q, continuous D (fun _ _ _ _ => q)) by apply continuous_const.
  assert (Ends : forall c, s sample (c + 1)%Z = PI / 2 + PI * IZR c) by (intros c; cbn; rewrite plus_IZR; field).
  assert (Starts : forall c, s sample c = - (PI / 2) + PI * IZR c) by (intros c; cbn; field).
  constructor.
  - split; [exact HP | split; [cbn; lia|]]; intros c t; change (Z.of_nat (k sample)) with 1%Z; cbv zeta; cbn [s stop impact q0 u0
      sample T]; rewrite plus_IZR, neg_cos, neg_sin; unfold turned, image; cbn [mirror sample sgn a Q U].
    split; [ring | split; [rewrite Z.even_add; destruct (Z.even c); reflexivity | split; [reflexivity | split; [ring | split;
      [ring|]]]]]. intros z n q u mu; rewrite neg_cos; split; [ring | split; [destruct z, n; cbn; ring | ring]].
  - exists 1; split; [lra|]; intros c t _; cbn; split; [eapply D_value; [apply derivable_pt_lim_opp, derivable_pt_lim_cos |
      ring] | eapply D_value; [apply derivable_pt_lim_sin | ring]].
  - intros c; cbv zeta; split; [rewrite Ends, Starts; lra|]; split; [split; cbn; reflexivity|]; cbn [impact sample]; rewrite Ends,
      sample_off, cos_PI2, Rmult_0_r; lra.
  - cbn; rewrite cos_0, sin_0; repeat split; try lra.
  - intros c t Ht Ne; split_time t c x; rewrite Ends, Starts in Ht; rewrite sample_off, sgn_square; destruct (Req_dec x 0) as
      [E|N]; [exfalso; apply (Ne c); split; [change (Z.of_nat (k sample)) with 1%Z; lia | cbn;
      rewrite E; ring]|]. assert (cos x < 1); [|lra]; rewrite <- cos_0;
      destruct (Rlt_le_dec 0 x) as [L|L]; [apply cos_decreasing_1; lra | rewrite <- (cos_neg x); apply cos_decreasing_1; lra].
  - intros c t z Ht Hz; split_time t c x; rewrite Ends, Starts in Ht; rewrite sample_off; assert (E : sgn z * sgn (stop sample c)
      = -1) by (destruct z, (stop sample c); cbn; try ring; exfalso; apply Hz; reflexivity). pose proof (cos_ge_0 x ltac:(lra)
      ltac:(lra)); rewrite E; lra.
  - exists 1; split; [lra|]; intros c; constructor; intros; cbn.
    + eapply D_value; [apply D_plus; [apply D_scale, derivable_pt_lim_cos | apply D_times; [apply D_times|]; apply D_plus;
        [apply D_const | apply derivable_pt_lim_cos | apply D_const | apply derivable_pt_lim_cos | apply D_const | apply
        derivable_pt_lim_cos]] | cbv beta; ring].
    + eapply D_value; [apply D_plus; [apply D_const | apply D_times; [apply D_times|]; apply D_plus; [apply D_id | apply D_const
        | apply D_id | apply D_const | apply D_id | apply D_const]] | cbv beta; ring].
    + apply D_const.
    + eapply D_value; [apply D_plus; [apply D_times; [apply D_plus; [apply D_const | apply D_id] | apply D_const] | apply
        D_const] | cbv beta; ring].
    + assert (Cc : forall D, continuous D (fun t _ _ _ => cos t)) by (intros D; apply C_t; intros t; eapply D_continuous, derivable_pt_lim_cos).
      assert (Cs : forall D, continuous D (fun t _ _ _ => - sin t)) by (intros D; apply C_t; intros t; eapply D_continuous,
        derivable_pt_lim_opp, derivable_pt_lim_sin). assert (Cm : forall D, continuous D (fun _ _ _ mu => mu)) by (intros D t y v m
        _ e He; exists e; auto). repeat split; repeat first [apply C_plus | apply C_times | apply Cst | apply C_y | apply Cc | apply
        Cs | apply Cm].
  - exists 1; split; [lra|]; intros z n Hn; constructor; intros; cbn; destruct n as [|n]; try apply D_const; repeat split; apply
      Cst.
  - split; [cbn; lra | split; cbn; intros; unfold rel in *; cbn in *; lra].
  - exists 1, (fun _ _ _ _ => 0), (fun _ _ _ _ => 0), (fun _ _ _ _ => - (1 / 2)), (fun _ _ _ _ => 0); split; [lra | split;
      [reflexivity|]]; constructor; intros; cbn; try apply D_const; [eapply D_value; [apply D_scale, D_id | ring] | repeat split;
      apply Cst].
  - exists 1; split; [lra|]; intros c E; discriminate.
Qed.
Lemma sample_along c m z w : linear_along (seen_from sample) c m z w -> forall t, PI * IZR c - PI / 2 <= t <= PI * IZR c + PI / 2
  -> derivable_pt_lim z t (w t) /\ derivable_pt_lim w t (sgn (stop sample c) * cos t * m).
Proof.
  intros H t Ht; destruct (H t) as [A B]; [cbn; rewrite plus_IZR; lra|]; split; [exact A|]; eapply D_value; [exact B|]; cbn -[sgn
    stop]; unfold off; cbn -[sgn stop]; destruct (stop sample c); cbn; ring.
Qed.
Lemma sample_change m z w z' w' : linear_impact (seen_from sample) 0 m z w z' w' <-> z' = - z /\ w' = - w.
Proof. unfold linear_impact; cbn; split; intros [A B]; split; lra. Qed.
Lemma sample_generic : generic_round (seen_from sample) (-2) 1 (- PI) (-1).
Proof.
  pose proof PI_RGT_0 as HP; constructor; change (Z.of_nat (Bouncing.k (seen_from sample))) with 1%Z; change (Bouncing.tG (seen_from
    sample)) with 0; change (Bouncing.T (seen_from sample)) with PI; rewrite ?Rplus_0_l; try lra.
  - exists (-1), 0, (-1); split; [ring | split; [ring|]]; intros z w [H1 H2]; change (Z.of_nat (Bouncing.k (seen_from sample))) with
      1%Z in *; cbv zeta; pose proof (H2 0%Z ltac:(lia)) as J; cbv zeta in J; apply sample_change in J; change (0 + 1)%Z with 1%Z in
      J; cbn [Bouncing.s seen_from s sample] in J; replace (PI * 1 - PI / 2) with (PI / 2) in J by field.
    assert (Z0 : forall c x, sgn (stop sample c) * cos x * 0 = 0) by (intros; ring).
    destruct (parabola 0 (z 0%Z) (w 0%Z) (- (PI / 2)) (PI / 2) ltac:(lra)) with (p := 0) (x := PI / 2) as [A1 A2]; try lra.
    { intros t Ht; rewrite <- (Z0 0%Z t); apply sample_along; [apply H1; lia | lra]. }
    destruct (parabola 0 (z 1%Z) (w 1%Z) (PI / 2) PI ltac:(lra)) with (p := PI / 2) (x := PI) as [A3 A4]; try lra.
    { intros t Ht; rewrite <- (Z0 1%Z t); apply sample_along; [apply H1; lia | lra]. }
    rewrite A3, A4, (proj1 J), (proj2 J), A1, A2; split; field.
  - exists (fun c t => - sgn (stop sample c) * cos t), (fun c t => sgn (stop sample c) * sin t); split; [split|].
    + intros c _ t _; cbv zeta; split; [eapply D_value; [apply D_scale, derivable_pt_lim_cos | ring] | eapply D_value; [apply
        D_scale, derivable_pt_lim_sin | cbn -[sgn stop]; unfold off; cbn -[sgn stop]; destruct (stop sample c); cbn; ring]].
    + intros c Hc; change (Z.of_nat (Bouncing.k (seen_from sample))) with 1%Z in Hc; assert (c = 0%Z) by lia; subst c; apply
        sample_change; cbn; split; ring.
    + cbn; rewrite cos_PI, sin_PI, cos_0, sin_0; repeat split; ring.
Qed.
(** For small mu < 0 it also hits the stops in turn, at a small velocity, and the way from one to the next is always the
    same but for the mirror; this is unstable. *)
Lemma in_turn : Theorem_1_statement -> Rattling_statement -> exists d, d > 0 /\ forall eps, 0 < eps <= d -> exists mu0, mu0 > 0 /\
  forall mu, - mu0 < mu < 0 -> one_rattling_motion sample mu eps (fun i => i) /\ forall t q u, rattling_motion sample mu eps (fun
  i => i) t q u -> unstable_motion (rides sample mu eps (fun i => i)) t u /\ Rabs (t 0%Z) <= eps /\ Rabs (t 1%Z - PI) <= eps /\ u
  1%Z (t 1%Z) = - (1 / 2) * u 0%Z (t 1%Z).
Proof.
  intros T1 St; destruct (St sample sample_rattles) as (HO & r & Hr & Same), (T1 (Bounces (seen_from sample) (-1)) _ _ _ (conj HO
    sample_generic) 1%nat) as (d & Hd & H), (two_least d r Hd Hr) as (d' & Hd' & L1 & L2); exists d'; split; [exact Hd'|]; intros
    eps He. destruct (H eps ltac:(lra)) as (mu0 & Hm & W), (two_least mu0 r Hm Hr) as (mu1 & Hmu1 & L3 & L4); exists mu1; split;
    [exact Hmu1|]; intros mu Hmu; pose proof PI_RGT_0. destruct (W (fun _ => 1%nat) Plus Minus mu) as [B _].
  - intros _; split; [lia|]; cbn; lra.
  - cbn; lra.
  - cbn [sgn e_mu]; lra.
  - destruct (B) with (N := fun i : Z => i) as [One Un]; [|intros i; reflexivity|].
    + intros _; split; [split; [cbn; lra | intros q Hq; lia]|]. unfold edge, StatementWords.p, StatementWords.q; cbn; lra.
    + destruct (Same mu eps (fun i => i) ltac:(rewrite Rabs_left; lra) ltac:(lra) ltac:(intros; cbv beta; lia)) as (S1 & _ & S3); split;
        [apply S1, One|]; intros t q u HM; split; [exact (S3 Un t q u HM)|]. destruct (HM 0%Z 1%Z eq_refl) as (rr & p & w & R);
        pose proof (ride_near _ _ _ _ _ _ _ _ _ _ _ _ _ R 0%Z ltac:(auto)) as N0; pose proof (ride_near _ _ _ _ _ _ _ _ _ _ _ _
        _ R 1%Z ltac:(auto)) as N1; cbn in N0, N1. replace (t 0%Z - (0 + PI * 0)) with (t 0%Z) in N0 by ring; replace (t 1%Z - (0 +
        PI * 1)) with (t 1%Z - PI) in N1 by ring; split; [exact N0 | split; [exact N1 | exact (ride_hits _ _ _ _ _ _ _ _ _ _ _ _ _
        R)]].
Qed.
