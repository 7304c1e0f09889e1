(** * What follows, worked out by hand, from the definitions and statements about oscillators with other
      impacts on the grazing orbit *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementWords StatementUnstable StatementNonlinear StatementBouncing
  StatementBouncingExample Headline.
Import Bouncing.
Open Scope R_scope.

(** ** What the definitions say *)
Lemma runs_means O mu y v t : runs O 5 mu y v t -> derivable_pt_lim y t (v t) /\
  derivable_pt_lim v t (a O 5 t (y t) (v t) mu).
Proof. intros [A B]; split; assumption. Qed.
Lemma beside_means O r t y v : beside O r 3 t y v -> s O 3%Z - r <= t <= s O 4%Z + r /\ y0 O 3 t - r <= y <= y0 O 3 t +
  r /\ v0 O 3 t - r <= v <= v0 O 3 t + r.
Proof. intros (A & B & C); cbn in A; unfold Rabs in *; repeat destruct Rcase_abs; lra. Qed.
(** An impact on the stop, or the place measured downwards from a stop that is above. *)
Lemma follows_means O mu y v y' v' : follows O 2 mu 9 y v y' v' -> (impact O 2 = true -> y' = 0 /\ v' = rebound O 2 mu 9
  v) /\ (impact O 2 = false -> face O 2 = -1 -> place O 2 mu = 7 -> speed O 2 mu = 3 -> y' = 7 - y /\ v' = 3 - v).
Proof. unfold follows; destruct (impact O 2); intros [A B]; split; [tauto | discriminate | discriminate | intros _ E1 E2
  E3; rewrite E1, E2 in A; rewrite E1, E3 in B; lra]. Qed.
(** A hypothesis that is lost is missed here. *)
Lemma bouncing_orbit_means O : bouncing_orbit O -> (T O > 0 /\ (k O > 0)%nat /\ a O 0 (tG O) 0 0 0 > 0) /\
  (s O 0%Z < tG O /\ tG O < s O 1%Z /\ y0 O 0 (tG O) = 0) /\
  (forall c t, s O (c + Z.of_nat (k O))%Z = s O c + T O /\ y0 O (c + Z.of_nat (k O)) (t + T O) = y0 O c t /\
    v0 O (c + Z.of_nat (k O)) (t + T O) = v0 O c t /\ impact O (c + Z.of_nat (k O)) = impact O c /\
    face O (c + Z.of_nat (k O)) = face O c /\ forall y v mu, a O (c + Z.of_nat (k O)) (t + T O) y v mu = a O c t y v mu /\
    rebound O (c + Z.of_nat (k O)) mu (t + T O) v = rebound O c mu t v /\
    place O (c + Z.of_nat (k O)) mu = place O c mu /\ speed O (c + Z.of_nat (k O)) mu = speed O c mu) /\
  (forall c, s O c < s O (c + 1)%Z) /\ (forall c, impact O c = true -> y0 O c (s O (c + 1)%Z) = 0 /\ v0 O c (s O (c +
    1)%Z) < 0 /\ y0 O (c + 1) (s O (c + 1)%Z) = 0 /\ v0 O (c + 1) (s O (c + 1)%Z) > 0 /\ v0 O (c + 1) (s O (c + 1)%Z) =
    rebound O c 0 (s O (c + 1)%Z) (v0 O c (s O (c + 1)%Z))) /\
  (forall c, impact O c = false -> y0 O c (s O (c + 1)%Z) > 0 /\ y0 O (c + 1) (s O (c + 1)%Z) > 0 /\ y0 O (c + 1) (s O (c
    + 1)%Z) = place O c 0 + face O c * y0 O c (s O (c + 1)%Z) /\ v0 O (c + 1) (s O (c + 1)%Z) = speed O c 0 + face O c *
    v0 O c (s O (c + 1)%Z)) /\
  ((forall t, s O 0%Z < t < s O 1%Z -> t <> tG O -> y0 O 0 t > 0) /\
    forall t, (k O > 1)%nat -> s O 1%Z < t < s O 2%Z -> y0 O 1 t > 0) /\
  (exists r, r > 0 /\ (forall c, runs O c 0 (y0 O c) (v0 O c) (s O c - r / 2)) /\ forall c,
    C1 (fun t y v mu => beside O r c t y v /\ Rabs mu <= r) (a O c) (a_t O c) (a_y O c) (a_v O c) (a_mu O c)) /\
  (tau O >= 0 /\ (forall mu t, rebound O 0 mu t 0 = 0) /\ forall mu t v, v < 0 -> rebound O 0 mu t v >= 0).
Proof.
  intros [(A1 & A2 & A3) B (D1 & D2 & D3) E (r & Hr & F1 & F2) (G1 & G2 & G3) _ _]; split; [repeat split; lra ||
    lia|]; split; [repeat split; lra|]; split; [exact A3|]; split; [intros c; apply B|]; split; [|split; [|split;
    [|split]]].
  - intros c I; destruct (B c) as (_ & B2 & B3); unfold follows in B2; rewrite I in *; repeat split; try apply B2; try
      apply B3; lra.
  - intros c I; destruct (B c) as (_ & B2 & B3); unfold follows in B2; rewrite I in *; repeat split; try apply B2; lra.
  - split; intros t; [intros Ht Ne | intros Hk Ht]; (apply E; [exact Ht|]); intros N [E1 E2].
    + assert (N = 0%Z) by nia; subst N; apply Ne; rewrite E2; ring.
    + destruct (Z_lt_le_dec N 1); nia.
  - exists r; split; [exact Hr | split; [|exact F2]]; intros c; apply F1; pose proof (proj1 (B c)); lra.
  - split; [lra | split; [exact G2|]]; intros mu t v Hv; specialize (G3 mu t v Hv); lra.
Qed.
Lemma touch_law_means O : bouncing_orbit O -> exists r f1 f2 f3 f4, r > 0 /\ f3 (tG O) 0 0 0 = - tau O /\
  C1 (fun t y v mu => Rabs (t - tG O) <= r /\ Rabs v <= r /\ Rabs mu <= r) (fun t y v mu => rebound O 0 mu t v) f1 f2 f3
      f4.
Proof. intros [_ _ _ _ _ _ (r & f1 & f2 & f3 & f4 & Hr & Ev & K) _]; exists r, f1, f2, f3, f4; repeat split; try
  assumption; apply K. Qed.
Lemma other_law_means O : bouncing_orbit O -> let t := s O 8%Z in let v := v0 O 7 t in (impact O 7 = true ->
  derivable_pt_lim (fun x => rebound O 7 0 x v) t (rebound_t O 7 0 t v) /\
  derivable_pt_lim (fun x => rebound O 7 0 t x) v (rebound_v O 7 0 t v) /\
  derivable_pt_lim (fun x => rebound O 7 x t v) 0 (rebound_mu O 7 0 t v)) /\ (impact O 7 = false ->
  derivable_pt_lim (place O 7) 0 (place_mu O 7 0) /\ derivable_pt_lim (speed O 7) 0 (speed_mu O 7 0)).
Proof.
  intros [_ _ _ _ _ _ _ (r & Hr & K)]; specialize (K 7%Z); cbv zeta; assert (Z0 : Rabs 0 <= r) by (rewrite Rabs_R0;
    lra). split; intros I; rewrite I in K; change (7 + 1)%Z with 8%Z in K.
  - destruct K as [K1 _ K3 K4 _]; assert (D : Rabs (s O 8%Z - s O 8%Z) <= r /\ Rabs (v0 O 7 (s O 8%Z) - v0 O 7 (s O 8%Z))
      <= r /\ Rabs 0 <= r) by (rewrite !Rminus_eq_0, Rabs_R0; lra). split; [apply (K1 _ 0 _ _ D) | split; [apply (K3 _ 0
      _ _ D) | apply (K4 _ 0 _ _ D)]].
  - destruct K as [[_ _ _ K1 _] [_ _ _ K2 _]]; split; [apply (K1 0 0 0 0 Z0) | apply (K2 0 0 0 0 Z0)].
Qed.
Lemma linear_along_means O m z w : s O 2%Z <= 7 <= s O 3%Z -> linear_along O 2 m z w -> let at_ f := f 2%Z 7 (y0 O 2 7)
  (v0 O 2 7) 0 in derivable_pt_lim z 7 (w 7) /\ derivable_pt_lim w 7 (at_ (a_y O) * z 7 + at_ (a_v O) * w 7 + at_ (a_mu
      O) * m).
Proof. intros H7 H; exact (H 7 H7). Qed.
(** The velocity - 2 becomes 3, both under no force, and the law has the derivatives 5, 7 and 11. *)
Lemma linear_impact_means O z' w' : impact O 0 = true -> s O 1%Z = 4 -> v0 O 0 4 = -2 -> v0 O 1 4 = 3 -> (forall c v, a O
  c 4 0 v 0 = 0) -> rebound_v O 0 0 4 (-2) = 5 -> rebound_t O 0 0 4 (-2) = 7 -> rebound_mu O 0 0 4 (-2) = 11 ->
  linear_impact O 0 100 2 10 z' w' -> z' = -3 /\ w' = 50 + 7 + 1100.
Proof.
  unfold linear_impact; intros -> E1 E2 E3 E4 E5 E6 E7 (h & A & B & C); change (0 + 1)%Z with 1%Z in *; cbv zeta in *;
    rewrite E1, E2, E3, ?E4 in *; rewrite E5, E6, E7 in *; split; lra.
Qed.
(** Where the chart changes, all is counted the other way, and the stops move apart with mu. *)
Lemma linear_change_means O z' w' : impact O 0 = false -> face O 0 = -1 -> place_mu O 0 0 = 5 -> speed_mu O 0 0 = 7 ->
  linear_impact O 0 100 2 10 z' w' -> z' = 498 /\ w' = 690.
Proof. unfold linear_impact; intros -> -> -> -> [A B]; split; lra. Qed.
Lemma linear_round_means O m z w : k O = 2%nat -> linear_round O m z w -> (forall c, (c = 0 \/ c = 1 \/ c = 2)%Z ->
  linear_along O c m (z c) (w c)) /\ linear_impact O 0 m (z 0%Z (s O 1%Z)) (w 0%Z (s O 1%Z)) (z 1%Z (s O 1%Z)) (w 1%Z (s
      O 1%Z)) /\
  linear_impact O 1 m (z 1%Z (s O 2%Z)) (w 1%Z (s O 2%Z)) (z 2%Z (s O 2%Z)) (w 2%Z (s O 2%Z)).
Proof.
  intros E [A B]; rewrite E in *; split; [intros c Hc; apply A; lia | split; [apply (B 0%Z) | apply (B 1%Z)]; lia].
Qed.
Lemma generic_round_means O a1 a2 gamma rate : k O = 2%nat -> generic_round O a1 a2 gamma rate -> (gamma <> 0 /\ rate <>
  0) /\ (exists z w, linear_round O 1 z w /\ z 0%Z (tG O) = rate /\ z 2%Z (tG O + T O) = z 0%Z (tG O) /\ w 2%Z (tG O + T
      O) = w 0%Z (tG O)) /\
  forall z w z' w', linear_round O 0 z w -> linear_round O 0 z' w' -> z 0%Z (tG O) = 0 -> w 0%Z (tG O) = 1 -> z' 0%Z (tG
      O) = 1 -> w'
  0%Z (tG O) = 0 -> let x f := f 2%Z (tG O + T O) in x z = gamma /\ a1 = x z' + x w /\ a2 = x z' * x w - x w' * x z.
Proof.
  intros E [(p & q & r & -> & -> & H) G (z & w & L & P & Q & ->) R]; rewrite E in *; change (Z.of_nat 2) with 2%Z in *;
    split; [split; assumption|]; split; [exists z, w; auto|]. intros z1 w1 z2 w2 L1 L2 E1 E2 E3 E4; destruct (H z1 w1
        L1) as [A1 A2], (H z2 w2 L2) as
    [A3 A4]; cbv zeta beta in *; rewrite E1, E2 in *; rewrite E3, E4 in *. rewrite A1, A2, A3, A4; split; [ring | split;
        ring].
Qed.
(** From one touch to the next but one, past three ends of arcs a period, of which the fifth is an impact, and the
    fourth is not. *)
Lemma bounces_means O mu d t y v : k O = 3%nat -> impact O 3 = true -> impact O 4 = false -> bouncing_motion O mu d (fun i
  => 2 * i)%Z t y v -> (tG O - d <= t 0%Z <= tG O + d /\ tG O + 2 * T O - d <= t 1%Z <= tG O + 2 * T O + d /\ v 1%Z (t
  1%Z) = rebound O 6 mu (t 1%Z) (v 0%Z (t 1%Z))) /\ exists r p q,
  (r 0%nat = t 0%Z /\ p 0%nat (t 0%Z) = 0 /\ r 7%nat = t 1%Z /\ p 6%nat (t 1%Z) = 0 /\ q 6%nat (t 1%Z) < 0) /\
  (s O 4%Z - d <= r 4%nat <= s O 4%Z + d /\ r 3%nat < r 4%nat /\ p 3%nat (r 4%nat) = 0 /\ q 3%nat (r 4%nat) < 0 /\
    p 4%nat (r 4%nat) = 0 /\ q 4%nat (r 4%nat) = rebound O 3 mu (r 4%nat) (q 3%nat (r 4%nat))) /\
  (r 5%nat = s O 5%Z /\ p 5%nat (r 5%nat) = place O 4 mu + face O 4 * p 4%nat (r 5%nat) /\
    q 5%nat (r 5%nat) = speed O 4 mu + face O 4 * q 4%nat (r 5%nat)) /\ (forall x, r 3%nat < x
  < r 4%nat -> p 3%nat x > 0) /\ (forall x, r 3%nat <= x <= r 4%nat -> runs O 3 mu (p 3%nat) (q 3%nat) x /\ y0 O 3 x - d
      <= p 3%nat x <=
  y0 O 3 x + d /\ v0 O 3 x - d <= q 3%nat x <= v0 O 3 x + d) /\ (forall x, r 3%nat <= x < r 4%nat -> y 0%Z x = p 3%nat x
      /\ v 0%Z x =
  q 3%nat x) /\ forall x, r 6%nat <= x <= r 7%nat -> y 0%Z x = p 6%nat x /\ v 0%Z x = q 6%nat x.
Proof.
  intros E I3 I4 H; destruct (H 0%Z 1%Z eq_refl) as (r & p & q & [J1 J2 J3 J4 J5 JE J6 J7 J8 J9 J10 J11]); unfold others in
    *; assert (A : forall m, arc O (fun i => 2 * i)%Z 0 m = Z.of_nat m) by (intros m; unfold arc; lia); assert (A1 : arc O
    (fun i => 2 * i)%Z 1 0 = 6%Z) by (unfold arc; rewrite E; reflexivity); rewrite A1 in J11; rewrite E in *; cbn [Z.to_nat
    Z.sub Z.mul Z.opp Z.add Pos.to_nat Pos.iter_op Nat.add Nat.mul Z.pos_sub Pos.mul] in *.
  change (3 * Z.to_nat (2 * 1 - 2 * 0))%nat with 6%nat in *. pose proof (J3 0%Z (or_introl eq_refl)) as N0; pose proof (J3
    1%Z (or_intror eq_refl)) as N1; cbn in N0, N1;
    unfold Rabs in N0, N1; split; [repeat destruct Rcase_abs; repeat split; try lra; exact J11|].
  exists r, p, q; pose proof (J4 4%nat ltac:(lia)) as N4; rewrite A in N4; change (Z.of_nat 4) with 4%Z in N4; pose proof
    (JE 3%nat ltac:(lia)) as B3; pose proof (JE 4%nat ltac:(lia)) as B4; pose proof (J9 3%nat ltac:(lia)) as C3; pose
    proof (J9 4%nat ltac:(lia)) as C4; unfold follows in C3, C4; cbv zeta in *; rewrite !A in B3, B4, C3, C4; change
    (Z.of_nat 3) with 3%Z in *; change (Z.of_nat 4) with 4%Z in *; change (Z.of_nat 5) with 5%Z in *; rewrite I3 in B3, C3;
    rewrite I4 in B4, C4; rewrite ?(A 5%nat) in B4. split; [repeat split; first [apply J1 | apply J2]|]; split; [|split; [exact (conj B4 C4)|]].
  { pose proof (J5 3%nat ltac:(lia)); repeat split; try apply B3; try apply C3; pose proof (Rle_abs (r 4%nat - s O 4)); pose proof (Rabs_minus_sym (r 4%nat) (s O 4)); pose proof (Rle_abs (s O 4 - r 4%nat)); lra. }
  split; [intros x Hx; apply (J8 3%nat); [lia | exact Hx]|]; split; [|split].
  - intros x Hx; pose proof (J6 3%nat x ltac:(lia) Hx) as R3; rewrite A in R3; split; [exact R3|]; destruct (J7 3%nat x
      ltac:(lia) Hx) as [C1' C2']; rewrite A in C1', C2'; change (Z.of_nat 3) with 3%Z in *; unfold Rabs in *; repeat
      destruct Rcase_abs; lra.
  - intros x Hx; apply J10; [lia | lra | intros; lra].
  - intros x Hx; apply J10; [lia | exact Hx | reflexivity].
Qed.
Lemma the_bouncing_motion O mu d N : one_bouncing_motion O mu d N -> exists t y v, bouncing_motion O mu d N t y v /\
  forall t' y' v', bouncing_motion O mu d N t' y' v' -> t' 5%Z = t 5%Z /\ forall x, t 5%Z <= x <= t 6%Z ->
    y' 5%Z x = y 5%Z x /\ v' 5%Z x = v 5%Z x.
Proof. intros (t & y & v & M & U); exists t, y, v; split; [exact M|]; intros t' y' v' M'; apply (U t' y' v' M' 5%Z).
    Qed.

(** ** What [exactly] and [never] say of them *)
Lemma never_bouncing a1 a2 n : never a1 a2 n -> forall O gamma rate e, bouncing_orbit O -> generic_round O a1 a2 gamma
  rate -> exists d mu0, d > 0 /\ mu0 > 0 /\ forall mu N t y v, 0 < sgn e * (rate * mu) < mu0 -> (forall i,
  N (i + 1) = N i + Z.of_nat n)%Z -> ~ bouncing_motion O mu d N t y v.
Proof.
  intros H O gamma rate e HO HG; destruct (H (Bounces O rate) gamma e (conj HO HG)) as (d & mu0 & Hd & Hm & U);
    exists d, mu0. split; [exact Hd | split; [exact Hm|]]; intros mu N t y v Hmu HN; exact (U mu Hmu N t y v HN).
Qed.
Lemma exactly_bouncing a1 a2 n g : exactly a1 a2 n Plus g -> forall O gamma rate, bouncing_orbit O ->
  generic_round O a1 a2 gamma rate -> sgn g * gamma > 0 -> exists d, d > 0 /\ forall eps, 0 < eps <= d -> exists mu0,
  mu0 > 0 /\ forall mu N, 0 < rate * mu < mu0 -> (forall i, N (i + 1) = N i + Z.of_nat n)%Z ->
  one_bouncing_motion O mu eps N /\ forall t y v, bouncing_motion O mu eps N t y v -> unstable_motion (bounces O mu eps
      N) t v.
Proof.
  intros H O gamma rate HO HG Hg; destruct (H (Bounces O rate) gamma (conj HO HG)) as [B _];
    destruct (B Hg) as (d & Hd & U). exists d; split; [exact Hd|]; intros eps He; destruct (U eps He) as (mu0 & Hm & W);
    exists mu0; split; [exact Hm|]. intros mu N Hmu HN; apply (W mu); [cbn; lra | exact HN].
Qed.

(** ** The example: an impact of small velocity in each period, for small mu < 0 *)
Lemma example_period_1 : Theorem_1_statement -> Bouncing_example_statement -> exists d, d > 0 /\ forall eps, 0 < eps <=
  d -> exists mu0, mu0 > 0 /\ forall mu, - mu0 < mu < 0 -> one_bouncing_motion bouncing_example mu eps (fun i => i).
Proof.
  intros T1 [HO HG]; pose proof PI_RGT_0 as HP; assert (H2 : 0 < PI * PI) by (apply Rmult_lt_0_compat; lra); assert (H3
    : 0 < PI * PI * PI) by (apply Rmult_lt_0_compat; lra). destruct (T1 (Bounces bouncing_example _) _ _ _ (conj HO HG)
        1%nat) as (d & Hd & H); exists d;
    split; [exact Hd|]; intros eps He; destruct (H eps He) as (mu0 & Hm & W).
  exists (mu0 / (PI * PI / 2)); split; [apply Rdiv_lt_0_compat; lra|]; intros mu Hmu.
  assert (Q : PI * PI / 2 * (mu0 / (PI * PI / 2)) = mu0) by (field; lra). assert (Q' : PI * PI / 2 * - mu < PI * PI / 2
    * (mu0 / (PI * PI / 2))) by (apply Rmult_lt_compat_l; lra). assert (Q0 : 0 < PI * PI / 2 * - mu) by (apply
        Rmult_lt_0_compat; lra).
  destruct (W (fun _ => 1%nat) Plus Plus mu) as [B _].
  - intros _; split; [lia|]; cbn; lra.
  - cbn; lra.
  - cbn [sgn e_mu]; lra.
  - destruct (B) with (N := fun i : Z => i) as [One _]; [|intros i; reflexivity | exact One].
    intros _; split; [split; [cbn; lra | intros q Hq; lia]|]. unfold edge, p, q; cbn; lra.
Qed.
(** It hits at the velocity - 4 pi and leaves at 4 pi, and touches halfway. *)
Lemma example_numbers : Bouncing_example_statement -> let O := bouncing_example in k O = 1%nat /\ s O 0%Z = - PI /\ s O
  1%Z = PI /\ tG O = 0 /\ v0 O 0 PI = - (4 * PI) /\ v0 O 1 PI = 4 * PI /\ y0 O 0 (PI / 2) = PI * PI / 2 /\ a O 0 0 5 7 2 = PI * PI - 2.
Proof.
  intros _; cbn; rewrite sin_PI, cos_PI2, cos_0; repeat split; field.
Qed.
