(** * Proof of Theorem 1 for nonlinear oscillators whose grazing orbit has other impacts *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementUnstable StatementWords StatementNonlinear StatementBouncing
  Headline PlaneOrbits Contraction Derivatives.
From Grazing Require Import NonlinearGronwall NonlinearFlow NonlinearTouch NonlinearSpeed NonlinearKick NonlinearMap.
From Grazing Require Import NonlinearFlights NonlinearWords NonlinearSmooth NonlinearTube NonlinearArc NonlinearStage
  NonlinearRound.
Open Scope R_scope.

(** Theorem 1 of motions, and that they are unstable. *)
Definition bounces_decided (O : Bouncing.t) (a1 a2 gamma rate : R) : Prop := forall n_max, exists d, d > 0 /\ forall eps, 0 <
  eps <= d -> exists mu0, mu0 > 0 /\
  forall (n : Z -> nat) (N : Z -> Z) e g mu, (forall i, (1 <= n i <= n_max)%nat /\ u a1 a2 (n i) <> 0) ->
  (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z -> sgn g * gamma > 0 -> 0 < sgn e * (rate * mu) < mu0 ->
  ((forall i, member a1 a2 e (n i) /\ edge a1 a2 e g (n i) (n (i + 1)%Z)) -> one_bouncing_motion O mu eps N /\ forall
    t y v, bouncing_motion O mu eps N t y v -> unstable_motion (bounces O mu eps N) t v) /\
  ((exists i, breaks a1 a2 e g (n i) (n (i + 1)%Z)) -> forall t y v, ~ bouncing_motion O mu d N t y v).

Lemma choose (X : Type) (x0 : X) (Q : nat -> X -> Prop) n : (forall m, (m < n)%nat -> exists x, Q m x) -> exists f : nat ->
  X, forall m, (m < n)%nat -> Q m (f m).
Proof.
  induction n as [|n IH]; intros H; [exists (fun _ => x0); intros m Hm; lia|].
  destruct IH as (f & Hf); [intros m Hm; apply H; lia|]; destruct (H n ltac:(lia)) as (x & Hx).
  exists (fun m => if Nat.eq_dec m n then x else f m); intros m Hm; destruct Nat.eq_dec as [->|Ne]; [exact Hx | apply Hf;
    lia].
Qed.
Lemma C1_shift (D D' : R -> R -> R -> R -> Prop) f f1 f2 f3 f4 b : C1 D f f1 f2 f3 f4 -> (forall t y v mu, D' t y v mu -> D (t
  + b) y v mu) -> let sh (g : R -> R -> R -> R -> R) (t y v mu : R) := g (t + b) y v mu in C1 D' (sh f) (sh f1) (sh f2) (sh f3) (sh f4).
Proof.
  intros [H1 H2 H3 H4 (K1 & K2 & K3 & K4)] HD sh; assert (Cs : forall g, continuous D g -> continuous D' (sh g)).
  { intros g C t y v mu Hd eps He; destruct (C _ _ _ _ (HD _ _ _ _ Hd) eps He) as (d & Pd & H); exists d; split; [exact Pd|].
    intros t' y' v' mu' A1 A2 A3 A4; unfold sh; apply H; trivial; replace (t' + b - (t + b)) with (t' - t) by ring; exact
      A1. }
  constructor; unfold sh; intros.
  - apply (D_later (fun t => f t y v mu)), H1, HD, H.
  - apply H2, HD, H.
  - apply H3, HD, H.
  - apply H4, HD, H.
  - repeat split; apply Cs; assumption.
Qed.

Section Main.
Variables (O : Bouncing.t) (a1 a2 gamma rate : R).
Hypothesis HO : bouncing_orbit O.
Hypothesis HG : generic_round O a1 a2 gamma rate.
Notation T0 := (Bouncing.T O). Notation a0 := (Bouncing.a O). Notation k := (Bouncing.k O). Notation s := (Bouncing.s O).
Notation Y := (Bouncing.y0 O). Notation V := (Bouncing.v0 O). Notation tg := (Bouncing.tG O).
Notation kz := (Z.of_nat k). Notation zz := Z.of_nat.
Variable rho : R.
Hypothesis Hrho : 0 < rho.
Hypothesis Hforce : (forall c t, s c - 2 * rho <= t <= s (c + 1)%Z + 2 * rho -> StatementBouncing.runs O 0 (Y c) (V c) t) /\
  forall c, C1 (fun t y v mu => beside O (2 * rho) c t y v /\ Rabs mu <= 2 * rho) a0 (Bouncing.a_t O) (Bouncing.a_y O)
    (Bouncing.a_v O) (Bouncing.a_mu O).
Let Per := its_period O HO. Let Arcs := its_arcs O HO. Let Imp := its_impacts O HO.
Let Hk : (1 <= k)%nat := proj1 (proj2 Per).
Lemma many z c t : s (c + kz * z)%Z = s c + T0 * IZR z /\ Y (c + kz * z) (t + T0 * IZR z) = Y c t /\ V (c + kz * z) (t + T0 *
  IZR z) = V c t /\ forall y v mu, a0 (t + T0 * IZR z) y v mu = a0 t y v mu /\ Bouncing.rebound O mu (t + T0 * IZR z) v =
  Bouncing.rebound O mu t v.
Proof.
  pose proof Per as (_ & _ & H); assert (Up : forall n c t, s (c + kz * Z.of_nat n)%Z = s c + T0 * INR n /\ Y (c + kz * Z.of_nat
    n) (t + T0 * INR n) = Y c t /\ V (c + kz * Z.of_nat n) (t + T0 * INR n) = V c t).
  { intros n; induction n as [|n IH]; intros c' t'; [cbn [INR Z.of_nat]; rewrite Z.mul_0_r, Z.add_0_r, Rmult_0_r, !Rplus_0_r;
      auto|]. destruct (IH c' t') as (E1 & E2 & E3), (H (c' + kz * Z.of_nat n)%Z (t' + T0 * INR n)) as (E4 & E5 & E6 & _).
    rewrite S_INR; replace (c' + kz * Z.of_nat (S n))%Z with (c' + kz * Z.of_nat n + kz)%Z by lia; replace (t' + T0 * (INR n +
      1)) with (t' + T0 * INR n + T0) by ring. rewrite E4, E5, E6, E1; split; [ring | auto]. }
  split; [|split; [|split]].
  - destruct (Z_le_gt_dec 0 z) as [L|L]; [destruct (Up (Z.to_nat z) c t) as (E & _); rewrite INR_IZR_INZ, Z2Nat.id in E by
      exact L; exact E|]. destruct (Up (Z.to_nat (- z)) (c + kz * z)%Z t) as (E & _); rewrite INR_IZR_INZ, Z2Nat.id, opp_IZR in
      E by lia; replace (c + kz * z + kz * - z)%Z with c in E by ring; lra.
  - destruct (Z_le_gt_dec 0 z) as [L|L]; [destruct (Up (Z.to_nat z) c t) as (_ & E & _); rewrite INR_IZR_INZ, Z2Nat.id in E by
      exact L; exact E|]. destruct (Up (Z.to_nat (- z)) (c + kz * z)%Z (t + T0 * IZR z)) as (_ & E & _); rewrite INR_IZR_INZ,
      Z2Nat.id, opp_IZR in E by lia; replace (c + kz * z + kz * - z)%Z with c in E by ring; rewrite <- E; f_equal; ring.
  - destruct (Z_le_gt_dec 0 z) as [L|L]; [destruct (Up (Z.to_nat z) c t) as (_ & _ & E); rewrite INR_IZR_INZ, Z2Nat.id in E by
      exact L; exact E|]. destruct (Up (Z.to_nat (- z)) (c + kz * z)%Z (t + T0 * IZR z)) as (_ & _ & E); rewrite INR_IZR_INZ,
      Z2Nat.id, opp_IZR in E by lia; replace (c + kz * z + kz * - z)%Z with c in E by ring; rewrite <- E; f_equal; ring.
  - intros y v mu; split; [apply (whole (fun t => a0 t y v mu)) | apply (whole (fun t => Bouncing.rebound O mu t v))]; intros
      t'; destruct (H 0%Z t') as (_ & _ & _ & E); [apply E; exact 0 | apply E; exact 0].
Qed.

(** Arc j, in its own time. *)
Definition bs (j : nat) : R := s (zz j) - rho.
Definition len (j : nat) : R := s (zz j + 1)%Z - s (zz j).
Definition Tj (j : nat) : R := len j + rho + rho.
Definition yy (j : nat) (t : R) : R := Y (zz j) (t + bs j).
Definition vv (j : nat) (t : R) : R := V (zz j) (t + bs j).
Definition sh (j : nat) (g : R -> R -> R -> R -> R) : R -> R -> R -> R -> R := fun t y v mu => g (t + bs j) y v mu.
Definition kj (j : nat) := NonlinearArc.k (sh j (Bouncing.a_y O)) (Tj j) (yy j) (vv j).
Definition cj (j : nat) := NonlinearArc.c (sh j (Bouncing.a_v O)) (Tj j) (yy j) (vv j).
Definition lj (j : nat) := NonlinearArc.l (sh j (Bouncing.a_mu O)) (Tj j) (yy j) (vv j).
Lemma len_pos j : 0 < len j. Proof. unfold len; pose proof (proj1 (Arcs (zz j))); lra. Qed.
Definition arc_of (j : nat) (F : force) (q : R) : Prop := 0 < q <= rho /\ @T F = Tj j /\ (forall t, 0 <= t <= Tj j -> @y0 F t =
  yy j t /\ @v0 F t = vv j t) /\ (forall t y v mu, 0 <= t <= Tj j -> inside (yy j) (vv j) q t y v mu -> @a F t y v mu = a0 (t +
  bs j) y v mu) /\ @along_arc F (kj j) (cj j) (lj j).
Lemma arc_exists j : exists F q, arc_of j F q.
Proof.
  pose proof (len_pos j) as Hl; destruct Hforce as [Hm HC]; apply (arc_force (sh j a0) (sh j (Bouncing.a_t O)) (sh j
    (Bouncing.a_y O)) (sh j (Bouncing.a_v O)) (sh j (Bouncing.a_mu O)) (Tj j) rho (yy j) (vv j)).
  - unfold Tj; lra.
  - exact Hrho.
  - intros t Ht; destruct (Hm (zz j) (t + bs j)) as [A B]; [unfold bs, Tj, len in *; lra|]; split; [apply (D_later (Y (zz j))),
      A | apply (D_later (V (zz j))), B].
  - refine (C1_shift _ _ _ _ _ _ _ (bs j) (HC (zz j)) _); intros t y v mu [Ht (A & B & C)]; unfold beside, inside, yy, vv, bs,
      Tj, len in *; repeat split; lra.
Qed.
Variables (F : nat -> force) (qs : nat -> R).
Hypothesis HFq : forall j, (j < k)%nat -> arc_of j (F j) (qs j).
Definition md (m : nat) : nat := (m mod k)%nat.
Lemma md_lt m : (md m < k)%nat. Proof. apply Nat.mod_upper_bound; lia. Qed.
Lemma md_k m : md (k + m) = md m.
Proof. unfold md; rewrite Nat.add_comm, <- (Nat.mul_1_l k) at 1; apply Nat.mod_add; lia. Qed.
Lemma md_small j : (j < k)%nat -> md j = j. Proof. apply Nat.mod_small. Qed.
Lemma md_split m : m = (k * (m / k) + md m)%nat. Proof. apply Nat.div_mod; lia. Qed.
Lemma md_S m : (S (md m) < k)%nat /\ md (S m) = S (md m) \/ S (md m) = k /\ md (S m) = 0%nat.
Proof.
  pose proof (md_lt m) as L; assert (E : md (S m) = md (S (md m))) by (unfold md; rewrite <- (Nat.add_1_r m), <- (Nat.add_1_r
    (m mod k)), Nat.add_mod_idemp_l by lia; reflexivity).
  destruct (Nat.eq_dec (S (md m)) k) as [Q|Q]; [right; split; [exact Q|]; rewrite E, Q; unfold md; apply Nat.mod_same; lia |
    left; split; [lia|]; rewrite E; apply md_small; lia].
Qed.
Definition Fm m := F (md m). Definition em m := len (md m) + rho.
Definition law m (mu d v : R) := Bouncing.rebound O mu (s (zz (md m) + 1)%Z + d) v.
Definition Vm m := V (zz (md m)) (s (zz (md m) + 1)%Z).
Definition Rm m := Bouncing.rebound_mu O 0 (s (zz (md m) + 1)%Z) (Vm m).
Definition Rt m := Bouncing.rebound_t O 0 (s (zz (md m) + 1)%Z) (Vm m).
Definition Rv m := Bouncing.rebound_v O 0 (s (zz (md m) + 1)%Z) (Vm m).
Lemma f_period m : Fm (k + m)%nat = Fm m /\ em (k + m)%nat = em m /\ law (k + m)%nat = law m /\ kj (md (k + m)) = kj (md m) /\
  cj (md (k + m)) = cj (md m) /\ lj (md (k + m)) = lj (md m).
Proof. unfold Fm, em, law; rewrite md_k; repeat split; reflexivity. Qed.
Lemma f_along m : @along_arc (Fm m) (kj (md m)) (cj (md m)) (lj (md m)). Proof. apply (HFq (md m) (md_lt m)). Qed.
Lemma f_times m : 0 < rho /\ 0 <= em m - rho /\ em m + rho <= @T (Fm m).
Proof. pose proof (len_pos (md m)); destruct (HFq (md m) (md_lt m)) as (_ & E & _); unfold Fm, em; rewrite E; unfold Tj; lra.
  Qed.
Lemma f_starts m : rho + rho <= @T (Fm m).
Proof. pose proof (len_pos (md m)); destruct (HFq (md m) (md_lt m)) as (_ & E & _); unfold Fm; rewrite E; unfold Tj; lra. Qed.
Lemma f_at m t : 0 <= t <= Tj (md m) -> @y0 (Fm m) t = yy (md m) t /\ @v0 (Fm m) t = vv (md m) t.
Proof. intros Ht; destruct (HFq (md m) (md_lt m)) as (_ & _ & E & _); apply E, Ht. Qed.
Lemma f_ends m : @y0 (Fm m) (em m) = 0 /\ @v0 (Fm m) (em m) = Vm m /\ Vm m < 0.
Proof.
  pose proof (len_pos (md m)); destruct (f_at m (em m)) as [-> ->]; [unfold em, Tj; lra|]; unfold yy, vv, Vm, em, bs, len.
  replace (s (zz (md m) + 1)%Z - s (zz (md m)) + rho + (s (zz (md m)) - rho)) with (s (zz (md m) + 1)%Z) by ring.
  repeat split; [apply Arcs | apply Imp].
Qed.
Lemma f_begins m : @y0 (Fm m) rho = 0 /\ @v0 (Fm m) rho = V (zz (md m)) (s (zz (md m))) /\ 0 < V (zz (md m)) (s (zz (md m))).
Proof.
  pose proof (len_pos (md m)); destruct (f_at m rho) as [-> ->]; [unfold Tj; lra|]; unfold yy, vv, bs. replace (rho + (s (zz (md
    m)) - rho)) with (s (zz (md m))) by ring. repeat split; [apply Arcs|].
  pose proof (Imp (zz (md m) - 1)%Z) as Q; cbv zeta in Q; replace (zz (md m) - 1 + 1)%Z with (zz (md m)) in Q by lia; apply Q.
Qed.
(** The next arc, in the times of both. *)
Lemma f_next m : V (zz (md (S m))) (s (zz (md (S m)))) = V (zz (md m) + 1) (s (zz (md m) + 1)%Z) /\ forall y v mu, a0 (s (zz (md
  (S m)))) y v mu = a0 (s (zz (md m) + 1)%Z) y v mu.
Proof.
  destruct (md_S m) as [[L E]|[L E]]; rewrite E.
  - replace (zz (S (md m))) with (zz (md m) + 1)%Z by lia; auto.
  - assert (Ez : (zz (md m) + 1 = 0 + kz * 1)%Z) by lia; rewrite Ez; destruct (many 1 0%Z (s 0%Z)) as (E1 & _ & E2 & E3); rewrite
      E1; split; [rewrite E2; reflexivity | intros y v mu; symmetry; apply E3].
Qed.
Lemma f_entry m : @y0 (Fm (S m)) rho = 0 /\ @v0 (Fm (S m)) rho = law m 0 0 (@v0 (Fm m) (em m)).
Proof.
  destruct (f_begins (S m)) as (E1 & E2 & _), (f_ends m) as (_ & -> & _), (f_next m) as [E3 _]; split; [exact E1|]; rewrite E2,
    E3; unfold law, Vm; rewrite Rplus_0_r; apply Imp.
Qed.
Lemma f_law m eps : 0 < eps -> exists d, 0 < d /\ forall mu x v mu' x' v', Rabs mu <= d -> Rabs x <= d -> Rabs (v - @v0 (Fm m)
  (em m)) <= d -> Rabs mu' <= d -> Rabs x' <= d -> Rabs (v' - @v0 (Fm m) (em m)) <= d -> Rabs (law m mu x v - law m mu' x' v' -
  (Rm m * (mu - mu') + Rt m * (x - x') + Rv m * (v - v'))) <= eps * (Rabs (mu - mu') + Rabs (x - x') + Rabs (v - v')).
Proof.
  intros He; destruct (f_ends m) as (_ & -> & _); destruct (its_other_law_C1 O HO) as (r & Hr & HC); specialize (HC (zz (md m)));
    set (t0 := s (zz (md m) + 1)%Z) in *; fold t0 in HC; change (V (zz (md m)) t0) with (Vm m) in HC.
  destruct (strictly _ _ _ _ _ _ t0 0 (Vm m) 0 r HC Hr) with (eps := eps) as (d & Hd & H); [|exact He|].
  { intros t' y' v' m' A _ B C; rewrite Rminus_0_r in C; auto. }
  exists d; split; [exact Hd|]; intros mu x v mu' x' v' A1 A2 A3 A4 A5 A6; assert (Z : Rabs (0 - 0) <= d) by (rewrite
    Rminus_0_r, Rabs_R0; lra). specialize (H (t0 + x) 0 v mu (t0 + x') 0 v' mu').
  replace (t0 + x - t0) with x in H by ring; replace (t0 + x' - t0) with x' in H by ring; replace (t0 + x - (t0 + x')) with (x -
    x') in H by ring; rewrite !Rminus_0_r, Rabs_R0 in H. unfold law, Rm, Rt, Rv; fold t0.
  match type of H with _ -> _ -> _ -> _ -> _ -> _ -> _ -> _ -> Rabs ?u <= _ => match goal with |- Rabs ?w <= _ => replace w with u
    by ring end end. eapply Rle_trans; [apply H; trivial; lra | right; ring].
Qed.

(** The touch, in the time of arc 0. *)
Lemma md_0 : md 0 = 0%nat. Proof. apply md_small; lia. Qed.
Definition tl : R := tg - bs 0.
Lemma tl_in : rho < tl < em 0.
Proof. destruct (its_touch O HO) as (H & _); unfold tl, em, bs, len; rewrite md_0; change (zz 0) with 0%Z; rewrite Z.add_0_l;
  lra. Qed.
Lemma V_touch : V 0 tg = 0.
Proof.
  destruct (its_touch O HO) as (H & Z & _); destruct (proj1 Hforce 0%Z tg) as [D _]; [rewrite Z.add_0_l; lra|];
    pose (Dp := (exist _ (V 0 tg) D) : derivable_pt (Y 0) tg).
  change (derive_pt (Y 0) tg Dp = 0); apply (deriv_minimum (Y 0) (s 0%Z) (s 1%Z)); try lra; intros x H1 H2. rewrite Z;
    destruct (Req_dec x tg) as [->|Ne]; [lra | left]. apply (its_opening O HO); [rewrite Z.add_0_l; lra|]; intros N [E1 E2];
    assert (N = 0%Z) by nia; subst N; apply Ne; rewrite E2; ring.
Qed.
Lemma f_touch : @y0 (Fm 0) tl = 0 /\ @v0 (Fm 0) tl = 0 /\ 0 < @a (Fm 0) tl 0 0 0.
Proof.
  pose proof tl_in as Ht; destruct (its_touch O HO) as (_ & Z & G); pose proof V_touch as Z'. assert (It : 0 <= tl <= Tj (md
    0)) by (unfold em, Tj in *; lra). destruct (f_at 0 tl It) as [E1 E2]; rewrite E1, E2; destruct (HFq (md 0) (md_lt 0)) as
    (Hq & _ & _ & Ag & _). unfold yy, vv; rewrite md_0 in *; change (zz 0) with 0%Z; replace (tl + bs 0) with tg by (unfold tl;
    ring); split; [exact Z | split; [exact Z'|]].
  unfold Fm; rewrite md_0, Ag; [replace (tl + bs 0) with tg by (unfold tl; ring); exact G | exact It|]. unfold inside, yy, vv;
    change (zz 0) with 0%Z; replace (tl + bs 0) with tg by (unfold tl; ring); rewrite Z, Z', Rminus_0_r, Rabs_R0; lra.
Qed.
Lemma tl_T : 0 < tl < @T (Fm 0).
Proof. pose proof tl_in; pose proof (f_times 0); lra. Qed.
Definition To : touch (Fm 0) := @Build_touch (Fm 0) tl (@a (Fm 0) tl 0 0 0) tl_T (conj (proj1 f_touch) (proj1 (proj2 f_touch)))
  (conj (proj2 (proj2 f_touch)) eq_refl).

(** ** The motions are those of the arcs, each in its time *)
Variable Io : @NonlinearKick.impact (Fm 0) To.
Hypothesis HIo : forall mu t v, @NonlinearKick.rebound _ _ Io mu t v = Bouncing.rebound O mu (t + bs 0) v.
Variable qm : R.
Hypothesis Hqm : 0 < qm <= rho /\ forall j, (j < k)%nat -> qm <= qs j.
Notation off := (off k em rho (bs 0)). Notation arc := (arc O).
Notation Leg := (@Leg k Fm em rho law To Io (bs 0)).
Lemma base_is m : base em rho (bs 0) m = bs m.
Proof.
  induction m as [|m IH]; [reflexivity|]; cbn [base]; rewrite IH; unfold em, len, bs. pose proof (md_split m) as E; set (q :=
    (m / k)%nat) in *; destruct (many (zz q) (zz (md m)) 0) as (E1 & _), (many (zz q) (zz (md m) + 1)%Z 0) as (E2 & _).
  replace (zz (md m) + kz * zz q)%Z with (zz m) in E1 by lia; replace (zz (md m) + 1 + kz * zz q)%Z with (zz (S m)) in E2 by
    lia. rewrite E1, E2; ring.
Qed.
Lemma off_is N i m : off N i m = s (arc N i m) - rho.
Proof.
  unfold NonlinearRound.off, P; rewrite !base_is; unfold bs; destruct (many 1 0%Z 0) as (E1 & _), (many (N i) (zz m) 0) as (E2 &
    _). rewrite Z.mul_1_r, Z.add_0_l in E1; change (zz 0) with 0%Z; unfold StatementBouncing.arc; rewrite Z.add_comm, E2, E1;
    ring.
Qed.
Lemma P_is : P k em rho (bs 0) = T0.
Proof. unfold P; rewrite base_is; unfold bs; destruct (many 1 0%Z 0) as (E1 & _); rewrite Z.mul_1_r, Z.add_0_l in E1; change (zz
  0) with 0%Z; rewrite E1; ring. Qed.
Lemma glob N i m x : let o := off N i m in yy (md m) (x - o) = Y (arc N i m) x /\ vv (md m) (x - o) = V (arc N i m) x /\ (forall
  y v mu, a0 (x - o + bs (md m)) y v mu = a0 x y v mu) /\ (forall mu v, law m mu (x - o - em m) v = Bouncing.rebound O mu x v) /\
  s (arc N i m + 1)%Z = o + em m /\ s (arc N i m) = o + rho /\ off N i (S m) = o + em m - rho.
Proof.
  intros o; set (z := (N i + zz (m / k))%Z); pose proof (md_split m) as Em; assert (Ea : arc N i m = (zz (md m) + kz * z)%Z) by
    (unfold StatementBouncing.arc, z; lia). destruct (many z (zz (md m)) (x - T0 * IZR z)) as (E1 & E2 & E3 & E4), (many z (zz
    (md m) + 1)%Z 0) as (E5 & _).
  assert (Eo : o = bs (md m) + T0 * IZR z) by (unfold o; rewrite off_is, Ea, E1; unfold bs; ring).
  replace (zz (md m) + 1 + kz * z)%Z with (arc N i m + 1)%Z in E5 by lia; rewrite <- Ea in E1, E2, E3. replace (x - T0 * IZR z +
    T0 * IZR z) with x in E2, E3, E4 by ring. unfold yy, vv; replace (x - o + bs (md m)) with (x - T0 * IZR z) by (rewrite Eo;
    ring). split; [symmetry; exact E2 | split; [symmetry; exact E3 | split; [intros y v mu; symmetry; apply E4|]]].
  split; [|split; [|split]].
  - intros mu v; unfold law; replace (s (zz (md m) + 1)%Z + (x - o - em m)) with (x - T0 * IZR z) by (rewrite Eo; unfold em, len,
      bs; ring). symmetry; apply (E4 0 v mu).
  - rewrite E5, Eo; unfold em, len, bs; ring.
  - rewrite E1, Eo; unfold bs; ring.
  - unfold o, NonlinearRound.off; cbn [base]; ring.
Qed.
Lemma same_runs N i m mu d p q x : Rabs mu <= qm -> d <= qm -> let o := off N i m in 0 <= x - o <= Tj (md m) -> Rabs (p x - Y
  (arc N i m) x) <= d -> Rabs (q x - V (arc N i m) x) <= d -> @a (Fm m) (x - o) (p x) (q x) mu = a0 x (p x) (q x) mu.
Proof.
  intros Hm Hd o Hx Hp Hq; destruct (glob N i m x) as (E1 & E2 & E3 & _); fold o in E1, E2, E3; destruct (HFq (md m) (md_lt m))
    as (_ & _ & _ & Ag & _); destruct Hqm as [_ Q]; specialize (Q (md m) (md_lt m)).
  unfold Fm; rewrite Ag; [apply E3 | exact Hx|]; unfold inside; rewrite E1, E2; repeat split; lra.
Qed.
Lemma local_place N i m x : let o := off N i m in 0 <= x - o <= Tj (md m) -> @y0 (Fm m) (x - o) = Y (arc N i m) x /\ @v0 (Fm m)
  (x - o) = V (arc N i m) x.
Proof. intros o Hx; destruct (f_at m (x - o) Hx) as [-> ->]; destruct (glob N i m x) as (E1 & E2 & _); auto. Qed.
Lemma off_last N i j : (N i <= N j)%Z -> off N i (others O N i j) = bs 0 + T0 * IZR (N j) /\ md (others O N i j) = 0%nat /\ em
  (others O N i j) = em 0.
Proof.
  intros L; assert (Em : md (others O N i j) = 0%nat) by (unfold others, md; rewrite Nat.mul_comm; apply Nat.mod_mul; lia).
  split; [|split; [exact Em | unfold em; rewrite Em, md_0; reflexivity]]. rewrite off_is; unfold StatementBouncing.arc, others;
    rewrite Nat2Z.inj_mul, Z2Nat.id by lia. replace (kz * N i + kz * (N j - N i))%Z with (0 + kz * N j)%Z by ring; destruct (many
    (N j) 0%Z 0) as (-> & _); unfold bs; change (zz 0) with 0%Z; ring.
Qed.
Lemma hit_time (N : Z -> Z) (t : Z -> R) l : Rabs (t l - (bs 0 + T0 * IZR (N l)) - tl) = Rabs (t l - (tg + T0 * IZR (N l))).
Proof. f_equal; unfold tl; ring. Qed.
Theorem leg_to mu d N t y v i j : Rabs mu <= qm -> d <= qm -> (N i <= N j)%Z -> Leg mu d N t y v i j -> bounces O mu d N t y v i
  j.
Proof.
  intros Hm Hd HN (al & om & p & q & [R1 R2 R3 (R4 & R4' & R4'') R5 R6 R7 R8]); set (n := others O N i j) in *; change (last k N
    i j) with n in *; destruct (off_last N i j HN) as (En & Mn & _); fold n in En, Mn; rewrite P_is in R1, R2; destruct Hqm as
    [Hq0 _]; pose proof tl_in as Ht; change (@tG _ To) with tl in *.
  set (r := fun m => match m with 0%nat => al 0%nat + off N i 0 | S m' => om m' + off N i m' end).
  assert (Ra : forall m, (m <= n)%nat -> r m = al m + off N i m).
  { intros [|m] Hm'; [reflexivity|]; destruct (glob N i m 0) as (_ & _ & _ & _ & _ & _ & E); cbv zeta in E; cbn [r]; rewrite
      (R3 m ltac:(lia)), E; ring. }
  assert (Ez : off N i 0 = bs 0 + T0 * IZR (N i)) by (rewrite off_is; unfold StatementBouncing.arc; destruct (many (N i) 0%Z 0)
    as (E & _); replace (kz * N i + zz 0)%Z with (0 + kz * N i)%Z by (cbn; ring); rewrite E; unfold bs; cbn; ring).
  assert (Lo : forall m, (m <= n)%nat -> 0 <= al m).
  { intros [|m] Hm'; [apply le_abs in R4; lra|]; rewrite (R3 m ltac:(lia)); specialize (R4'' m ltac:(lia)); apply le_abs in R4'';
      lra. }
  assert (Up : forall m, (m <= n)%nat -> om m <= Tj (md m)).
  { intros m Hm'; destruct (Nat.eq_dec m n) as [->|Ne]; [rewrite Mn; apply le_abs in R4'; unfold em, Tj in *; rewrite md_0 in *;
      lra|]. specialize (R4'' m ltac:(lia)); apply le_abs in R4''; unfold em, Tj in *; lra. }
  exists r, (fun m x => p m (x - off N i m)), (fun m x => q m (x - off N i m)); fold n.
  assert (Sub : forall m x, (m <= n)%nat -> r m <= x <= r (S m) -> al m <= x - off N i m <= om m) by (intros m x Hm' Hx; rewrite
    Ra in Hx by exact Hm'; cbn [r] in Hx; lra).
  constructor.
  - rewrite Ra by lia; rewrite R1, Ez; ring.
  - cbn [r]; rewrite R2, En; ring.
  - intros l [->| ->]; rewrite <- hit_time; [rewrite <- R1; exact R4 | rewrite <- R2; exact R4'].
  - intros [|m] Hm'; [lia|]; cbn [r]; destruct (glob N i m 0) as (_ & _ & _ & _ & E & _); cbv zeta in E; replace (arc N i (S m))
      with (arc N i m + 1)%Z by (unfold StatementBouncing.arc; lia); rewrite E; replace (om m + off N i m - (off N i m + em m))
      with (om m - em m) by ring; apply R4''; lia.
  - intros m Hm'; destruct (R5 m Hm') as (A1 & _ & A2 & A3 & _ & A4); rewrite Ra by exact Hm'; cbn [r]; replace (al m + off N i
      m - off N i m) with (al m) by ring; replace (om m + off N i m - off N i m) with (om m) by ring; repeat split; trivial; lra.
  - intros m x Hm' Hx; specialize (Sub m x Hm' Hx); specialize (Lo m Hm'); specialize (Up m Hm'); destruct (R5 m Hm') as (_ & A &
      _); destruct (A _ Sub) as ([D1 D2] & A1 & A2); assert (Ix : 0 <= x - off N i m <= Tj (md m)) by lra. destruct (local_place
      N i m x Ix) as [Q1 Q2]; rewrite Q1 in A1; rewrite Q2 in A2.
    rewrite (same_runs N i m mu d (fun x => p m (x - off N i m)) (fun x => q m (x - off N i m)) x Hm Hd Ix A1 A2) in D2.
    split; (eapply D_value; [apply (D_of (fun x => x - off N i m)); [apply D_shift | eassumption] | ring]).
  - intros m x Hm' Hx; specialize (Sub m x Hm' Hx); specialize (Lo m Hm'); specialize (Up m Hm'); destruct (R5 m Hm') as (_ & A &
      _); destruct (A _ Sub) as (_ & A1 & A2); assert (Ix : 0 <= x - off N i m <= Tj (md m)) by lra. destruct (local_place N i m
      x Ix) as [Q1 Q2]; rewrite Q1 in A1; rewrite Q2 in A2; auto.
  - intros m x Hm' Hx; rewrite Ra in Hx by exact Hm'; cbn [r] in Hx; destruct (R5 m Hm') as (_ & _ & _ & _ & A & _); apply A; lra.
  - intros m Hm'; destruct (glob N i m (r (S m))) as (_ & _ & _ & E & _ & _ & E'); cbv zeta in E, E'; rewrite <- E; cbn [r];
      rewrite E'; replace (om m + off N i m - off N i m) with (om m) by ring; rewrite <- (R6 m Hm'), (R3 m Hm'); f_equal; ring.
  - intros m x Hm' Hx Hl; destruct (R7 m (x - off N i m) Hm' (Sub m x Hm' Hx)) as [Q1 Q2].
    + intros Q; apply Hl; cbn [r]; lra.
    + replace (off N i m + (x - off N i m)) with x in Q1, Q2 by ring; auto.
  - rewrite R8; destruct (R5 n (le_n n)) as (A1 & _). destruct (R7 n (om n) (le_n n) ltac:(lra) (fun _ => eq_refl)) as [_ Q];
      rewrite R2, En in Q; replace (bs 0 + T0 * IZR (N j) + (t j - (bs 0 + T0 * IZR (N j)))) with (t j) in Q by ring. rewrite <-
      R2 in Q. rewrite HIo, Q, R2; destruct (many (N j) 0%Z (t j - (bs 0 + T0 * IZR (N j)) + bs 0)) as (_ & _ & _ & E); destruct
      (E 0 (q n (t j - (bs 0 + T0 * IZR (N j)))) mu) as [_ E']; rewrite <- E'; f_equal; ring.
Qed.
