(** * Proof of Theorem 1 for nonlinear oscillators whose grazing orbit has other impacts *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementUnstable StatementWords StatementNonlinear StatementBouncing
  Headline PlaneOrbits Contraction Derivatives.
From Grazing Require Import NonlinearGronwall NonlinearFlow NonlinearTouch NonlinearSpeed NonlinearKick NonlinearMap.
From Grazing Require Import NonlinearFlights NonlinearWords NonlinearSmooth NonlinearTube NonlinearArc NonlinearPoint
  NonlinearStage NonlinearChange NonlinearCompose NonlinearRound.
Open Scope R_scope.

(** Theorem 1 of motions, and that they are unstable. *)
Definition bounces_decided (O : Bouncing.t) (a1 a2 gamma rate : R) : Prop := forall n_max, exists d, d > 0 /\ forall
  eps, 0 < eps <= d -> exists mu0, mu0 > 0 /\
  forall (n : Z -> nat) (N : Z -> Z) e g mu, (forall i, (1 <= n i <= n_max)%nat /\ u a1 a2 (n i) <> 0) ->
  (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z -> sgn g * gamma > 0 -> 0 < sgn e * (rate * mu) < mu0 ->
  ((forall i, member a1 a2 e (n i) /\ edge a1 a2 e g (n i) (n (i + 1)%Z)) -> one_bouncing_motion O mu eps N /\ forall
    t y v, bouncing_motion O mu eps N t y v -> unstable_motion (bounces O mu eps N) t v) /\
  ((exists i, breaks a1 a2 e g (n i) (n (i + 1)%Z)) -> forall t y v, ~ bouncing_motion O mu d N t y v).

Lemma choose (X : Type) (x0 : X) (Q : nat -> X -> Prop) n : (forall m, (m < n)%nat -> exists x, Q m x) -> exists f : nat
  -> X, forall m, (m < n)%nat -> Q m (f m).
Proof.
  induction n as [|n IH]; intros H; [exists (fun _ => x0); intros m Hm; lia|].
  destruct IH as (f & Hf); [intros m Hm; apply H; lia|]; destruct (H n ltac:(lia)) as (x & Hx).
  exists (fun m => if Nat.eq_dec m n then x else f m); intros m Hm; destruct Nat.eq_dec as [->|Ne]; [exact Hx | apply
    Hf; lia].
Qed.
Lemma C1_shift (D D' : R -> R -> R -> R -> Prop) f f1 f2 f3 f4 b : C1 D f f1 f2 f3 f4 -> (forall t y v mu, D' t y v mu
    -> D (t
  + b) y v mu) -> let sh (g : R -> R -> R -> R -> R) (t y v mu : R) := g (t + b) y v mu in C1 D' (sh f) (sh f1) (sh f2)
      (sh f3) (sh f4).
Proof.
  intros [H1 H2 H3 H4 (K1 & K2 & K3 & K4)] HD sh; assert (Cs : forall g, continuous D g -> continuous D' (sh g)).
  { intros g C t y v mu Hd eps He; destruct (C _ _ _ _ (HD _ _ _ _ Hd) eps He) as (d & Pd & H); exists d; split; [exact
      Pd|].
    intros t' y' v' mu' A1 A2 A3 A4; unfold sh; apply H; trivial; replace (t' + b - (t + b)) with (t' - t) by ring;
      exact A1. }
  constructor; unfold sh; intros.
  - apply (D_later (fun t => f t y v mu)), H1, HD, H.
  - apply H2, HD, H.
  - apply H3, HD, H.
  - apply H4, HD, H.
  - repeat split; apply Cs; assumption.
Qed.

(** What is C1 in mu alone. *)
Lemma steady_strict f f_mu r : 0 < r -> C1 (fun _ _ _ mu => Rabs mu <= r) (fun _ _ _ mu => f mu) (fun _ _ _ _ => 0)
  (fun _ _ _ _ => 0) (fun _ _ _ _ => 0) (fun _ _ _ mu => f_mu mu) -> forall eps, 0 < eps -> exists d, 0 < d /\ forall mu
  mu', Rabs mu <= d -> Rabs mu' <= d -> Rabs (f mu - f mu' - f_mu 0 * (mu - mu')) <= eps * Rabs (mu - mu').
Proof.
  intros Hr HC eps He; destruct (strictly _ _ _ _ _ _ 0 0 0 0 r HC Hr) with (eps := eps) as (d & Hd & H); [|exact He|].
  { intros t' y' v' m' _ _ _ C; rewrite Rminus_0_r in C; exact C. }
  exists d; split; [exact Hd|]; intros mu mu' A1 A2; assert (Z : Rabs (0 - 0) <= d) by (rewrite Rminus_0_r, Rabs_R0; lra).
  specialize (H 0 0 0 mu 0 0 0 mu'); rewrite !Rminus_0_r, Rabs_R0 in H; rewrite Rminus_0_r, Rabs_R0 in Z.
  eapply Rle_trans; [|eapply Rle_trans; [apply H; trivial | right; ring]]; right; f_equal; ring.
Qed.

Section Main.
Variables (O : Bouncing.t) (a1 a2 gamma rate : R).
Hypothesis HO : bouncing_orbit O.
Hypothesis HG : generic_round O a1 a2 gamma rate.
Notation T0 := (Bouncing.T O). Notation a0 := (Bouncing.a O). Notation k := (Bouncing.k O). Notation s := (Bouncing.s
    O).
Notation Y := (Bouncing.y0 O). Notation V := (Bouncing.v0 O). Notation tg := (Bouncing.tG O).
Notation kz := (Z.of_nat k). Notation zz := Z.of_nat.
Variable rho : R.
Hypothesis Hrho : 0 < rho.
Hypothesis Hforce : (forall c t, s c - 2 * rho <= t <= s (c + 1)%Z + 2 * rho -> StatementBouncing.runs O c 0 (Y c) (V c)
  t) /\ forall c, C1 (fun t y v mu => beside O (2 * rho) c t y v /\ Rabs mu <= 2 * rho) (a0 c) (Bouncing.a_t O c)
    (Bouncing.a_y O c) (Bouncing.a_v O c) (Bouncing.a_mu O c).
Let Per := its_period O HO. Let Arcs := its_arcs O HO.
Let Hk : (1 <= k)%nat := proj1 (proj2 Per).
(** What becomes of place and velocity at the end of arc c. *)
Definition jyc (c : Z) (mu y : R) : R := if Bouncing.impact O c then 0 else Bouncing.place O c mu + Bouncing.face O c * y.
Definition lawc (c : Z) (mu x v : R) : R := if Bouncing.impact O c then Bouncing.rebound O c mu x v
  else Bouncing.speed O c mu + Bouncing.face O c * v.
Lemma follows_is c mu x y v y' v' : StatementBouncing.follows O c mu x y v y' v' <-> y' = jyc c mu y /\ v' = lawc c mu x v.
Proof. unfold StatementBouncing.follows, jyc, lawc; destruct (Bouncing.impact O c); tauto. Qed.
Lemma turned (X : Type) (f : Z -> R -> X) : (forall c t, f (c + kz)%Z (t + T0) = f c t) -> forall z c t,
  f (c + kz * z)%Z (t + T0 * IZR z) = f c t.
Proof.
  intros H; assert (Up : forall n c t, f (c + kz * Z.of_nat n)%Z (t + T0 * IZR (Z.of_nat n)) = f c t).
  { intros n; induction n as [|n IH]; intros c t; [cbn [Z.of_nat]; rewrite Z.mul_0_r, Z.add_0_r, Rmult_0_r,
      Rplus_0_r; reflexivity|]. rewrite <- (IH c t), <- (H (c + kz * Z.of_nat n)%Z), Nat2Z.inj_succ, succ_IZR; f_equal; [lia | ring]. }
  intros z c t; destruct (Z_le_gt_dec 0 z) as [L|L]; [rewrite <- (Z2Nat.id z L); apply Up|].
  pose proof (Up (Z.to_nat (- z)) (c + kz * z)%Z (t + T0 * IZR z)) as Q; rewrite Z2Nat.id, opp_IZR in Q by lia; rewrite <-
    Q; f_equal; [ring | ring].
Qed.
Lemma many z c t : s (c + kz * z)%Z = s c + T0 * IZR z /\ Y (c + kz * z) (t + T0 * IZR z) = Y c t /\ V (c + kz * z) (t +
  T0 * IZR z) = V c t /\ forall y v mu, a0 (c + kz * z)%Z (t + T0 * IZR z) y v mu = a0 c t y v mu /\
  lawc (c + kz * z)%Z mu (t + T0 * IZR z) v = lawc c mu t v /\
  Bouncing.rebound O (c + kz * z)%Z mu (t + T0 * IZR z) v = Bouncing.rebound O c mu t v.
Proof.
  pose proof Per as (_ & _ & H); split; [|split; [|split; [|intros y v mu; split; [|split]]]].
  - pose proof (turned R (fun c t => t - s c)) as Q; specialize (Q ltac:(intros c' t'; cbv beta; rewrite (proj1 (H c' 0)); ring) z c
      0); cbv beta in Q; lra.
  - apply (turned R Y); intros c' t'; apply (H c' t').
  - apply (turned R V); intros c' t'; apply (H c' t').
  - apply (turned R (fun c t => a0 c t y v mu)); intros c' t'; apply (H c' t').
  - apply (turned R (fun c t => lawc c mu t v)); intros c' t'; unfold lawc; destruct (H c' t') as (_ & _ & _ & -> & -> &
      E); destruct (E y v mu) as (_ & -> & _ & ->); reflexivity.
  - apply (turned R (fun c t => Bouncing.rebound O c mu t v)); intros c' t'; destruct (H c' t') as (_ & _ & _ & _ & _ &
      E); apply (E y v mu).
Qed.
Lemma many_kinds z c : Bouncing.impact O (c + kz * z)%Z = Bouncing.impact O c /\ forall mu y, jyc (c + kz * z)%Z mu y =
  jyc c mu y.
Proof.
  pose proof Per as (_ & _ & H); split; [exact (turned bool (fun c _ => Bouncing.impact O c) ltac:(intros c' t'; apply (H
    c' t')) z c 0)|]. intros mu y; refine (turned R (fun c _ => jyc c mu y) _ z c 0); intros c' t'; unfold jyc; destruct
    (H c' t') as (_ & _ & _ & -> & -> & E); destruct (E 0 0 mu) as (_ & _ & -> & _); reflexivity.
Qed.

(** Arc j, in its own time. *)
Definition bs (j : nat) : R := s (zz j) - rho.
Definition len (j : nat) : R := s (zz j + 1)%Z - s (zz j).
Definition Tj (j : nat) : R := len j + rho + rho.
Definition yy (j : nat) (t : R) : R := Y (zz j) (t + bs j).
Definition vv (j : nat) (t : R) : R := V (zz j) (t + bs j).
Definition sh (j : nat) (g : Z -> R -> R -> R -> R -> R) : R -> R -> R -> R -> R := fun t y v mu => g (zz j) (t + bs j) y v
  mu.
Definition kj (j : nat) := NonlinearArc.k (sh j (Bouncing.a_y O)) (Tj j) (yy j) (vv j).
Definition cj (j : nat) := NonlinearArc.c (sh j (Bouncing.a_v O)) (Tj j) (yy j) (vv j).
Definition lj (j : nat) := NonlinearArc.l (sh j (Bouncing.a_mu O)) (Tj j) (yy j) (vv j).
Lemma len_pos j : 0 < len j. Proof. unfold len; pose proof (proj1 (Arcs (zz j))); lra. Qed.
Definition arc_of (j : nat) (F : force) (q : R) : Prop := 0 < q <= rho /\ @T F = Tj j /\ (forall t, 0 <= t <= Tj j ->
  @y0 F t = yy j t /\ @v0 F t = vv j t) /\ (forall t y v mu, 0 <= t <= Tj j -> inside (yy j) (vv j) q t y v mu -> @a F t
      y v mu = a0 (zz j) (t + bs j) y v mu) /\ @along_arc F (kj j) (cj j) (lj j).
Lemma arc_exists j : exists F q, arc_of j F q.
Proof.
  pose proof (len_pos j) as Hl; destruct Hforce as [Hm HC]; apply (arc_force (sh j a0) (sh j (Bouncing.a_t O)) (sh j
    (Bouncing.a_y O)) (sh j (Bouncing.a_v O)) (sh j (Bouncing.a_mu O)) (Tj j) rho (yy j) (vv j)).
  - unfold Tj; lra.
  - exact Hrho.
  - intros t Ht; destruct (Hm (zz j) (t + bs j)) as [A B]; [unfold bs, Tj, len in *; lra|]; split; [apply (D_later (Y
      (zz j))), A | apply (D_later (V (zz j))), B].
  - refine (C1_shift _ _ _ _ _ _ _ (bs j) (HC (zz j)) _); intros t y v mu [Ht (A & B & C)]; unfold beside, inside, yy,
      vv, bs, Tj, len in *; repeat split; lra.
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
  pose proof (md_lt m) as L; assert (E : md (S m) = md (S (md m))) by (unfold md; rewrite <- (Nat.add_1_r m), <-
    (Nat.add_1_r (m mod k)), Nat.add_mod_idemp_l by lia; reflexivity).
  destruct (Nat.eq_dec (S (md m)) k) as [Q|Q]; [right; split; [exact Q|]; rewrite E, Q; unfold md; apply Nat.mod_same;
    lia | left; split; [lia|]; rewrite E; apply md_small; lia].
Qed.
Definition Fm m := F (md m). Definition em m := len (md m) + rho.
Definition imp m := Bouncing.impact O (zz (md m)). Definition jy m := jyc (zz (md m)).
Definition law m (mu d v : R) := lawc (zz (md m)) mu (s (zz (md m) + 1)%Z + d) v.
Definition Vm m := V (zz (md m)) (s (zz (md m) + 1)%Z). Definition Ym m := Y (zz (md m)) (s (zz (md m) + 1)%Z).
Definition Rm m := if imp m then Bouncing.rebound_mu O (zz (md m)) 0 (s (zz (md m) + 1)%Z) (Vm m)
  else Bouncing.speed_mu O (zz (md m)) 0.
Definition Rt m := if imp m then Bouncing.rebound_t O (zz (md m)) 0 (s (zz (md m) + 1)%Z) (Vm m) else 0.
Definition Rv m := if imp m then Bouncing.rebound_v O (zz (md m)) 0 (s (zz (md m) + 1)%Z) (Vm m)
  else Bouncing.face O (zz (md m)).
Definition Jm m := if imp m then 0 else Bouncing.place_mu O (zz (md m)) 0.
Definition Jy m := if imp m then 0 else Bouncing.face O (zz (md m)).
Lemma f_period m : Fm (k + m)%nat = Fm m /\ em (k + m)%nat = em m /\ law (k + m)%nat = law m /\ kj (md (k + m)) = kj (md
  m) /\ cj (md (k + m)) = cj (md m) /\ lj (md (k + m)) = lj (md m).
Proof. unfold Fm, em, law; rewrite md_k; repeat split; reflexivity. Qed.
Lemma f_kinds m : imp (k + m)%nat = imp m /\ jy (k + m)%nat = jy m /\ (imp m = true -> forall mu y, jy m mu y = 0).
Proof. unfold imp, jy, jyc; rewrite md_k; repeat split; intros ->; reflexivity. Qed.
Lemma f_along m : @along_arc (Fm m) (kj (md m)) (cj (md m)) (lj (md m)). Proof. apply (HFq (md m) (md_lt m)). Qed.
Lemma f_times m : 0 < rho /\ 0 <= em m - rho /\ em m + rho <= @T (Fm m).
Proof. pose proof (len_pos (md m)); destruct (HFq (md m) (md_lt m)) as (_ & E & _); unfold Fm, em; rewrite E; unfold Tj;
    lra.
  Qed.
Lemma f_starts m : rho + rho <= @T (Fm m).
Proof. pose proof (len_pos (md m)); destruct (HFq (md m) (md_lt m)) as (_ & E & _); unfold Fm; rewrite E; unfold Tj;
    lra. Qed.
Lemma f_at m t : 0 <= t <= Tj (md m) -> @y0 (Fm m) t = yy (md m) t /\ @v0 (Fm m) t = vv (md m) t.
Proof. intros Ht; destruct (HFq (md m) (md_lt m)) as (_ & _ & E & _); apply E, Ht. Qed.
Lemma f_ends m : @y0 (Fm m) (em m) = Ym m /\ @v0 (Fm m) (em m) = Vm m /\ (imp m = true -> Ym m = 0 /\ Vm m < 0).
Proof.
  pose proof (len_pos (md m)); destruct (f_at m (em m)) as [-> ->]; [unfold em, Tj; lra|]; unfold yy, vv, Vm, Ym, em,
    bs, len.
  replace (s (zz (md m) + 1)%Z - s (zz (md m)) + rho + (s (zz (md m)) - rho)) with (s (zz (md m) + 1)%Z) by ring.
  repeat split; trivial; destruct (Arcs (zz (md m))) as (_ & _ & A); unfold imp in *; rewrite H0 in A; apply A.
Qed.
Lemma f_begins m : @y0 (Fm m) rho = Y (zz (md m)) (s (zz (md m))) /\ @v0 (Fm m) rho = V (zz (md m)) (s (zz (md m))).
Proof.
  pose proof (len_pos (md m)); destruct (f_at m rho) as [-> ->]; [unfold Tj; lra|]; unfold yy, vv, bs. replace (rho + (s
    (zz (md m)) - rho)) with (s (zz (md m))) by ring. split; reflexivity.
Qed.
(** The next arc, in the times of both. *)
Lemma f_next m : let c := (zz (md m) + 1)%Z in let c' := zz (md (S m)) in Y c' (s c') = Y c (s c) /\ V c' (s c') = V c (s
  c) /\ forall y v mu, a0 c' (s c') y v mu = a0 c (s c) y v mu.
Proof.
  cbv zeta; destruct (md_S m) as [[L E]|[L E]]; rewrite E.
  - replace (zz (S (md m))) with (zz (md m) + 1)%Z by lia; auto.
  - assert (Ez : (zz (md m) + 1 = 0 + kz * 1)%Z) by lia; rewrite Ez; destruct (many 1 0%Z (s 0%Z)) as (E1 & E0 & E2 &
      E3); rewrite E1; split; [symmetry; exact E0 | split; [symmetry; exact E2 | intros y v mu; symmetry; apply E3]].
Qed.
Lemma f_entry m : @y0 (Fm (S m)) rho = jy m 0 (@y0 (Fm m) (em m)) /\ @v0 (Fm (S m)) rho = law m 0 0 (@v0 (Fm m) (em m)).
Proof.
  destruct (f_begins (S m)) as (-> & ->), (f_ends m) as (-> & -> & _), (f_next m) as (-> & -> & _), (Arcs (zz (md m))) as
    (_ & A & _); apply follows_is in A; unfold law, jy; rewrite Rplus_0_r; exact A.
Qed.
Lemma f_jy m eps : 0 < eps -> exists d, 0 < d /\ forall mu y mu' y', Rabs mu <= d -> Rabs mu' <= d ->
  Rabs (y - @y0 (Fm m) (em m)) <= d -> Rabs (y' - @y0 (Fm m) (em m)) <= d ->
  Rabs (jy m mu y - jy m mu' y' - (Jm m * (mu - mu') + Jy m * (y - y'))) <= eps * (Rabs (mu - mu') + Rabs (y - y')).
Proof.
  intros He; destruct (its_other_law_C1 O HO) as (r & Hr & HC); specialize (HC (zz (md m))); unfold jy, jyc, Jm, Jy, imp;
    destruct (Bouncing.impact O (zz (md m))).
  - exists 1; split; [lra|]; intros mu y mu' y' _ _ _ _; rewrite !Rmult_0_l, Rplus_0_r, !Rminus_0_r, Rabs_R0; pose proof
      (Rabs_pos (mu - mu')); pose proof (Rabs_pos (y - y')); apply Rmult_le_pos; lra.
  - destruct (steady_strict _ _ r Hr (proj1 HC) eps He) as (d & Hd & H); exists d; split; [exact Hd|]; intros mu y mu' y'
      A1 A2 _ _; specialize (H mu mu' A1 A2). match goal with |- Rabs ?u <= _ => match type of H with Rabs ?w <= _ =>
      replace u with w by ring end end; pose proof (Rabs_pos (y - y')); assert (0 <= eps * Rabs (y - y')) by (apply
      Rmult_le_pos; lra); lra.
Qed.
Lemma f_law m eps : 0 < eps -> exists d, 0 < d /\ forall mu x v mu' x' v', Rabs mu <= d -> Rabs x <= d -> Rabs (v - @v0
  (Fm m) (em m)) <= d -> Rabs mu' <= d -> Rabs x' <= d -> Rabs (v' - @v0 (Fm m) (em m)) <= d -> Rabs (law m mu x v - law
      m mu' x' v' -
  (Rm m * (mu - mu') + Rt m * (x - x') + Rv m * (v - v'))) <= eps * (Rabs (mu - mu') + Rabs (x - x') + Rabs (v - v')).
Proof.
  intros He; destruct (f_ends m) as (_ & -> & _); destruct (its_other_law_C1 O HO) as (r & Hr & HC); specialize (HC (zz
    (md m))); unfold law, lawc, Rm, Rt, Rv, imp; destruct (Bouncing.impact O (zz (md m))).
  2: { destruct (steady_strict _ _ r Hr (proj2 HC) eps He) as (d & Hd & H); exists d; split; [exact Hd|]; intros mu x v
      mu' x' v' A1 _ _ A2 _ _; specialize (H mu mu' A1 A2). match goal with |- Rabs ?u <= _ => match type of H with Rabs
      ?w <= _ => replace u with w by ring end end; pose proof (Rabs_pos (x - x')); pose proof (Rabs_pos (v - v')); assert
      (0 <= eps * (Rabs (x - x') + Rabs (v - v'))) by (apply Rmult_le_pos; lra); lra. }
  set (t0 := s (zz (md m) + 1)%Z) in *; fold t0 in HC; change (V (zz (md m)) t0) with (Vm m) in HC.
  destruct (strictly _ _ _ _ _ _ t0 0 (Vm m) 0 r HC Hr) with (eps := eps) as (d & Hd & H); [|exact He|].
  { intros t' y' v' m' A _ B C; rewrite Rminus_0_r in C; auto. }
  exists d; split; [exact Hd|]; intros mu x v mu' x' v' A1 A2 A3 A4 A5 A6; assert (Z : Rabs (0 - 0) <= d) by (rewrite
    Rminus_0_r, Rabs_R0; lra). specialize (H (t0 + x) 0 v mu (t0 + x') 0 v' mu').
  replace (t0 + x - t0) with x in H by ring; replace (t0 + x' - t0) with x' in H by ring; replace (t0 + x - (t0 + x'))
    with (x - x') in H by ring; rewrite !Rminus_0_r, Rabs_R0 in H.
  match type of H with _ -> _ -> _ -> _ -> _ -> _ -> _ -> _ -> Rabs ?u <= _ => match goal with |- Rabs ?w <= _ =>
    replace w with u by ring end end. eapply Rle_trans; [apply H; trivial; lra | right; ring].
Qed.

(** The touch, in the time of arc 0. *)
Lemma md_0 : md 0 = 0%nat. Proof. apply md_small; lia. Qed.
Definition tl : R := tg - bs 0.
Lemma tl_in : rho < tl < em 0.
Proof. destruct (its_touch O HO) as (H & _); unfold tl, em, bs, len; rewrite md_0; change (zz 0) with 0%Z; rewrite
  Z.add_0_l; lra. Qed.
Lemma V_touch : V 0 tg = 0.
Proof.
  destruct (its_touch O HO) as (H & Z & _); destruct (proj1 Hforce 0%Z tg) as [D _]; [rewrite Z.add_0_l; lra|];
    pose (Dp := (exist _ (V 0 tg) D) : derivable_pt (Y 0) tg).
  change (derive_pt (Y 0) tg Dp = 0); apply (deriv_minimum (Y 0) (s 0%Z) (s 1%Z)); try lra; intros x H1 H2. rewrite Z;
    destruct (Req_dec x tg) as [->|Ne]; [lra | left]. apply (its_opening O HO); [rewrite Z.add_0_l; lra|]; intros N [E1
    E2]; assert (N = 0%Z) by nia; subst N; apply Ne; rewrite E2; ring.
Qed.
Lemma f_touch : @y0 (Fm 0) tl = 0 /\ @v0 (Fm 0) tl = 0 /\ 0 < @a (Fm 0) tl 0 0 0.
Proof.
  pose proof tl_in as Ht; destruct (its_touch O HO) as (_ & Z & G); pose proof V_touch as Z'. assert (It : 0 <= tl <= Tj
    (md 0)) by (unfold em, Tj in *; lra). destruct (f_at 0 tl It) as [E1 E2]; rewrite E1, E2; destruct (HFq (md 0)
    (md_lt 0)) as (Hq & _ & _ & Ag & _). unfold yy, vv; rewrite md_0 in *; change (zz 0) with 0%Z; replace (tl + bs 0)
    with tg by (unfold tl; ring); split; [exact Z | split; [exact Z'|]].
  unfold Fm; rewrite md_0, Ag; [replace (tl + bs 0) with tg by (unfold tl; ring); change (zz 0) with 0%Z; exact G |
    exact It|]. unfold inside, yy, vv; change (zz 0) with 0%Z; replace (tl + bs 0) with tg by (unfold tl; ring); rewrite
    Z, Z', Rminus_0_r, Rabs_R0; lra.
Qed.
Lemma tl_T : 0 < tl < @T (Fm 0).
Proof. pose proof tl_in; pose proof (f_times 0); lra. Qed.
Definition To : touch (Fm 0) := @Build_touch (Fm 0) tl (@a (Fm 0) tl 0 0 0) tl_T (conj (proj1 f_touch) (proj1 (proj2
  f_touch))) (conj (proj2 (proj2 f_touch)) eq_refl).

(** ** The motions are those of the arcs, each in its time *)
Section Legs.
Variable Io : @NonlinearKick.impact (Fm 0) To.
Hypothesis HIo : forall mu t v, @NonlinearKick.rebound _ _ Io mu t v = Bouncing.rebound O 0 mu (t + bs 0) v.
Variable qm : R.
Hypothesis Hqm : 0 < qm <= rho /\ forall j, (j < k)%nat -> qm <= qs j.
Notation off := (off k em rho (bs 0)). Notation arc := (arc O).
Notation Leg := (@Leg k Fm em rho imp law jy To Io (bs 0)).
Lemma base_is m : base em rho (bs 0) m = bs m.
Proof.
  induction m as [|m IH]; [reflexivity|]; cbn [base]; rewrite IH; unfold em, len, bs. pose proof (md_split m) as E; set
    (q := (m / k)%nat) in *; destruct (many (zz q) (zz (md m)) 0) as (E1 & _), (many (zz q) (zz (md m) + 1)%Z 0) as (E2
        & _).
  replace (zz (md m) + kz * zz q)%Z with (zz m) in E1 by lia; replace (zz (md m) + 1 + kz * zz q)%Z with (zz (S m)) in
    E2 by lia. rewrite E1, E2; ring.
Qed.
Lemma off_is N i m : off N i m = s (arc N i m) - rho.
Proof.
  unfold NonlinearRound.off, P; rewrite !base_is; unfold bs; destruct (many 1 0%Z 0) as (E1 & _), (many (N i) (zz m) 0)
    as (E2 & _). rewrite Z.mul_1_r, Z.add_0_l in E1; change (zz 0) with 0%Z; unfold StatementBouncing.arc; rewrite
    Z.add_comm, E2, E1; ring.
Qed.
Lemma P_is : P k em rho (bs 0) = T0.
Proof. unfold P; rewrite base_is; unfold bs; destruct (many 1 0%Z 0) as (E1 & _); rewrite Z.mul_1_r, Z.add_0_l in E1;
  change (zz 0) with 0%Z; rewrite E1; ring. Qed.
Lemma glob N i m x : let o := off N i m in let c := arc N i m in yy (md m) (x - o) = Y c x /\ vv (md m) (x - o) = V c x /\
  (forall y v mu, a0 (zz (md m)) (x - o + bs (md m)) y v mu = a0 c x y v mu) /\ (forall mu v, law m mu (x - o - em m) v =
  lawc c mu x v) /\ s (c + 1)%Z = o + em m /\ s c = o + rho /\ off N i (S m) = o + em m - rho.
Proof.
  intros o c; set (z := (N i + zz (m / k))%Z); pose proof (md_split m) as Em; assert (Ea : c = (zz (md m) + kz * z)%Z)
    by (unfold c, StatementBouncing.arc, z; lia). destruct (many z (zz (md m)) (x - T0 * IZR z)) as (E1 & E2 & E3 & E4),
    (many z (zz (md m) + 1)%Z 0) as (E5 & _).
  assert (Eo : o = bs (md m) + T0 * IZR z) by (unfold o; rewrite off_is; fold c; rewrite Ea, E1; unfold bs; ring).
  replace (zz (md m) + 1 + kz * z)%Z with (c + 1)%Z in E5 by lia; rewrite <- Ea in E1, E2, E3, E4. replace (x - T0 *
    IZR z + T0 * IZR z) with x in E2, E3, E4 by ring. unfold yy, vv; replace (x - o + bs (md m)) with (x - T0 * IZR z)
        by (rewrite Eo;
    ring). split; [symmetry; exact E2 | split; [symmetry; exact E3 | split; [intros y v mu; symmetry; apply E4|]]].
  split; [|split; [|split]].
  - intros mu v; unfold law; replace (s (zz (md m) + 1)%Z + (x - o - em m)) with (x - T0 * IZR z) by (rewrite Eo; unfold
      em, len, bs; ring). symmetry; apply (E4 0 v mu).
  - rewrite E5, Eo; unfold em, len, bs; ring.
  - rewrite E1, Eo; unfold bs; ring.
  - unfold o, NonlinearRound.off; cbn [base]; ring.
Qed.
Lemma glob_kinds N i m : Bouncing.impact O (arc N i m) = imp m /\ forall mu y, jyc (arc N i m) mu y = jy m mu y.
Proof.
  pose proof (md_split m) as Em; replace (arc N i m) with (zz (md m) + kz * (N i + zz (m / k)))%Z by (unfold
    StatementBouncing.arc; lia). apply many_kinds.
Qed.
Lemma arc_S N i m : arc N i (S m) = (arc N i m + 1)%Z. Proof. unfold StatementBouncing.arc; lia. Qed.
Lemma same_runs N i m mu d p q x : Rabs mu <= qm -> d <= qm -> let o := off N i m in 0 <= x - o <= Tj (md m) -> Rabs (p
  x - Y (arc N i m) x) <= d -> Rabs (q x - V (arc N i m) x) <= d -> @a (Fm m) (x - o) (p x) (q x) mu = a0 (arc N i m) x (p x) (q x)
      mu.
Proof.
  intros Hm Hd o Hx Hp Hq; destruct (glob N i m x) as (E1 & E2 & E3 & _); fold o in E1, E2, E3; destruct (HFq (md m)
    (md_lt m)) as (_ & _ & _ & Ag & _); destruct Hqm as [_ Q]; specialize (Q (md m) (md_lt m)).
  unfold Fm; rewrite Ag; [apply E3 | exact Hx|]; unfold inside; rewrite E1, E2; repeat split; lra.
Qed.
Lemma local_place N i m x : let o := off N i m in 0 <= x - o <= Tj (md m) -> @y0 (Fm m) (x - o) = Y (arc N i m) x /\ @v0
  (Fm m) (x - o) = V (arc N i m) x.
Proof. intros o Hx; destruct (f_at m (x - o) Hx) as [-> ->]; destruct (glob N i m x) as (E1 & E2 & _); auto. Qed.
Lemma off_last N i j : (N i <= N j)%Z -> off N i (others O N i j) = bs 0 + T0 * IZR (N j) /\ md (others O N i j) = 0%nat
  /\ em (others O N i j) = em 0.
Proof.
  intros L; assert (Em : md (others O N i j) = 0%nat) by (unfold others, md; rewrite Nat.mul_comm; apply Nat.mod_mul;
      lia).
  split; [|split; [exact Em | unfold em; rewrite Em, md_0; reflexivity]]. rewrite off_is; unfold StatementBouncing.arc,
    others; rewrite Nat2Z.inj_mul, Z2Nat.id by lia. replace (kz * N i + kz * (N j - N i))%Z with (0 + kz * N j)%Z by
    ring; destruct (many (N j) 0%Z 0) as (-> & _); unfold bs; change (zz 0) with 0%Z; ring.
Qed.
Lemma hit_time (N : Z -> Z) (t : Z -> R) l : Rabs (t l - (bs 0 + T0 * IZR (N l)) - tl) = Rabs (t l - (tg + T0 * IZR (N
    l))).
Proof. f_equal; unfold tl; ring. Qed.
Lemma touch_law N j mu x v : Bouncing.rebound O 0 mu (x - (bs 0 + T0 * IZR (N j)) + bs 0) v = Bouncing.rebound O (arc N j
  0) mu x v.
Proof.
  destruct (many (N j) 0%Z (x - (bs 0 + T0 * IZR (N j)) + bs 0)) as (_ & _ & _ & E); destruct (E 0 v mu) as (_ & _ & E');
    rewrite <- E'; unfold StatementBouncing.arc; f_equal; [cbn; ring | ring].
Qed.
Theorem leg_to mu d N t y v i j : Rabs mu <= qm -> d <= qm -> (N i <= N j)%Z -> Leg mu d N t y v i j -> bounces O mu d N
  t y v i j.
Proof.
  intros Hm Hd HN (al & om & p & q & [R1 R2 R3 (R4 & R4' & R4'') R5 RE RS R6 R7 R8]); set (n := others O N i j) in *;
    change (last k N i j) with n in *; destruct (off_last N i j HN) as (En & Mn & _); fold n in En, Mn; rewrite P_is in
    R1, R2; destruct Hqm as [Hq0 _]; pose proof tl_in as Ht; change (@tG _ To) with tl in *.
  set (r := fun m => match m with 0%nat => al 0%nat + off N i 0 | S m' => om m' + off N i m' end).
  assert (Ra : forall m, (m <= n)%nat -> r m = al m + off N i m).
  { intros [|m] Hm'; [reflexivity|]; destruct (glob N i m 0) as (_ & _ & _ & _ & _ & _ & E); cbv zeta in E; cbn [r];
      rewrite (R3 m ltac:(lia)), E; ring. }
  assert (Ez : off N i 0 = bs 0 + T0 * IZR (N i)) by (rewrite off_is; unfold StatementBouncing.arc; destruct (many (N i)
    0%Z 0) as (E & _); replace (kz * N i + zz 0)%Z with (0 + kz * N i)%Z by (cbn; ring); rewrite E; unfold bs; cbn;
        ring).
  assert (Lo : forall m, (m <= n)%nat -> 0 <= al m).
  { intros [|m] Hm'; [apply le_abs in R4; lra|]; rewrite (R3 m ltac:(lia)); specialize (R4'' m ltac:(lia)); apply le_abs
      in R4''; lra. }
  assert (Up : forall m, (m <= n)%nat -> om m <= Tj (md m)).
  { intros m Hm'; destruct (Nat.eq_dec m n) as [->|Ne]; [rewrite Mn; apply le_abs in R4'; unfold em, Tj in *; rewrite
      md_0 in *; lra|]. specialize (R4'' m ltac:(lia)); apply le_abs in R4''; unfold em, Tj in *; lra. }
  exists r, (fun m x => p m (x - off N i m)), (fun m x => q m (x - off N i m)); fold n.
  assert (Sub : forall m x, (m <= n)%nat -> r m <= x <= r (S m) -> al m <= x - off N i m <= om m) by (intros m x Hm' Hx;
    rewrite Ra in Hx by exact Hm'; cbn [r] in Hx; lra).
  constructor.
  - split; [rewrite Ra by lia; rewrite R1, Ez; ring|]; replace (t i - off N i 0) with (al 0%nat) by (rewrite R1, Ez; ring);
      exact RS.
  - split; [cbn [r]; rewrite R2, En; ring|]; replace (t j - off N i n) with (om n) by (rewrite R2, En; ring); specialize
      (RE n (le_n n)); destruct (Nat.eq_dec n n); [exact RE | lia].
  - intros l [->| ->]; rewrite <- hit_time; [rewrite <- R1; exact R4 | rewrite <- R2; exact R4'].
  - intros [|m] Hm'; [lia|]; cbn [r]; destruct (glob N i m 0) as (_ & _ & _ & _ & E & _); cbv zeta in E; rewrite arc_S,
          E; replace (om m + off N i m - (off N i m + em m)) with (om m - em m) by ring; apply R4''; lia.
  - intros m Hm'; destruct (R5 m Hm') as (A1 & _); rewrite Ra by exact Hm'; cbn [r]; lra.
  - intros m Hm'; specialize (RE m ltac:(lia)); destruct (Nat.eq_dec m n); [lia|]; rewrite (proj1 (glob_kinds N i m)), arc_S;
      destruct (glob N i m 0) as (_ & _ & _ & _ & E & _); cbv zeta in E; rewrite E; cbn [r]; destruct (imp m); [|rewrite
      RE; ring]. replace (om m + off N i m - off N i m) with (om m) by ring; exact RE.
  - intros m x Hm' Hx; specialize (Sub m x Hm' Hx); specialize (Lo m Hm'); specialize (Up m Hm'); destruct (R5 m Hm') as
      (_ & A & _); destruct (A _ Sub) as ([D1 D2] & A1 & A2); assert (Ix : 0 <= x - off N i m <= Tj (md m)) by lra.
          destruct (local_place
      N i m x Ix) as [Q1 Q2]; rewrite Q1 in A1; rewrite Q2 in A2.
    rewrite (same_runs N i m mu d (fun x => p m (x - off N i m)) (fun x => q m (x - off N i m)) x Hm Hd Ix A1 A2) in D2.
    split; (eapply D_value; [apply (D_of (fun x => x - off N i m)); [apply D_shift | eassumption] | ring]).
  - intros m x Hm' Hx; specialize (Sub m x Hm' Hx); specialize (Lo m Hm'); specialize (Up m Hm'); destruct (R5 m Hm') as
      (_ & A & _); destruct (A _ Sub) as (_ & A1 & A2); assert (Ix : 0 <= x - off N i m <= Tj (md m)) by lra. destruct
      (local_place N i m x Ix) as [Q1 Q2]; rewrite Q1 in A1; rewrite Q2 in A2; auto.
  - intros m x Hm' Hx; rewrite Ra in Hx by exact Hm'; cbn [r] in Hx; destruct (R5 m Hm') as (_ & _ & A); apply A; lra.
  - intros m Hm'; cbv zeta; apply follows_is; destruct (glob N i m (r (S m))) as (_ & _ & _ & E & _ & _ & E'); cbv zeta in
      E, E'; rewrite <- E, (proj2 (glob_kinds N i m)), E'; destruct (R6 m Hm') as [Q1 Q2]; cbn [r]. replace (om m + off N i
      m - off N i m) with (om m) by ring; replace (om m + off N i m - (off N i m + em m - rho)) with (al (S m)) by (rewrite
      (R3 m Hm'); ring); auto.
  - intros m x Hm' Hx Hl; destruct (R7 m (x - off N i m) Hm' (Sub m x Hm' Hx)) as [Q1 Q2].
    + intros Q; apply Hl; cbn [r]; lra.
    + replace (off N i m + (x - off N i m)) with x in Q1, Q2 by ring; auto.
  - rewrite R8; destruct (R5 n (le_n n)) as (A1 & _). destruct (R7 n (om n) (le_n n) ltac:(lra) (fun _ => eq_refl)) as
      [_ Q]; rewrite R2, En in Q; replace (bs 0 + T0 * IZR (N j) + (t j - (bs 0 + T0 * IZR (N j)))) with (t j) in Q by
      ring. rewrite <- R2 in Q. rewrite HIo, Q, R2; apply touch_law.
Qed.
Theorem leg_from mu d N t y v i j : Rabs mu <= qm -> d <= qm -> (N i <= N j)%Z -> bounces O mu d N t y v i j -> Leg mu d
  N t y v i j.
Proof.
  intros Hm Hd HN (r & p & q & [[R1 RS] (R2 & RN) R3 R4 R5 RE R6 R7 R8 R9 R10 R11]); set (n := others O N i j) in *; destruct (off_last
    N i j HN) as (En & Mn & _); fold n in En, Mn; destruct Hqm as [Hq0 _]; pose proof tl_in as Ht.
  assert (Ez : off N i 0 = bs 0 + T0 * IZR (N i)) by (rewrite off_is; unfold StatementBouncing.arc; destruct (many (N i)
    0%Z 0) as (E & _); replace (kz * N i + zz 0)%Z with (0 + kz * N i)%Z by (cbn; ring); rewrite E; unfold bs; cbn;
        ring).
  pose proof (R3 i (or_introl eq_refl)) as Ni; pose proof (R3 j (or_intror eq_refl)) as Nj; rewrite <- hit_time in Ni,
      Nj.
  assert (Nx : forall m, (m < n)%nat -> Rabs (r (S m) - off N i m - em m) <= d).
  { intros m Hm'; specialize (R4 (S m) ltac:(lia)); destruct (glob N i m 0) as (_ & _ & _ & _ & E & _); cbv zeta in E;
      rewrite arc_S, E in R4; replace (r (S m) - off N i m - em m) with (r (S m) - (off N i m + em m)) by ring; exact
      R4. }
  assert (Os : forall m, off N i (S m) = off N i m + em m - rho) by (intros m; apply (glob N i m 0)).
  assert (Lo : forall m, (m <= n)%nat -> 0 <= r m - off N i m).
  { intros [|m] Hm'; [rewrite R1, Ez; apply le_abs in Ni; lra|]; rewrite Os; specialize (Nx m ltac:(lia)); apply le_abs
      in Nx; lra. }
  assert (Up : forall m, (m <= n)%nat -> r (S m) - off N i m <= Tj (md m)).
  { intros m Hm'; destruct (Nat.eq_dec m n) as [->|Ne]; [rewrite R2, En, Mn; apply le_abs in Nj; unfold em, Tj in *;
      rewrite md_0 in *; lra|]. specialize (Nx m ltac:(lia)); apply le_abs in Nx; unfold em, Tj in *; lra. }
  exists (fun m => r m - off N i m), (fun m => r (S m) - off N i m), (fun m x => p m (x + off N i m)), (fun m x => q m
    (x + off N i m)); constructor; change (last k N i j) with n; rewrite ?P_is; change (@tG _ To) with tl.
  - rewrite R1, Ez; reflexivity.
  - rewrite R2, En; reflexivity.
  - intros m Hm'; rewrite Os; ring.
  - split; [rewrite R1, Ez; exact Ni | split; [rewrite R2, En; exact Nj | exact Nx]].
  - intros m Hm'; pose proof (R5 m Hm') as A1; specialize (Lo m Hm'); specialize (Up m Hm').
    split; [lra | split; [|intros x Hx; apply R8; [exact Hm' | lra]]].
    intros x Hx; assert (Ix : 0 <= x + off N i m - off N i m <= Tj (md m)) by lra; destruct (R6 m (x + off N i m) Hm'
      ltac:(lra)) as [D1 D2], (R7 m (x + off N i m) Hm' ltac:(lra)) as [B1 B2]. destruct (local_place N i m (x + off N i
          m) Ix) as [Q1 Q2].
    pose proof (same_runs N i m mu d (p m) (q m) (x + off N i m) Hm Hd Ix B1 B2) as Ag; rewrite <- Q1 in B1; rewrite <-
      Q2 in B2; replace (x + off N i m - off N i m) with x in Ag, B1, B2 by ring. rewrite <- Ag in D2; split; [|auto];
      split; apply D_later; assumption.
  - intros m Hm'; destruct (Nat.eq_dec m n) as [->|Ne]; [rewrite R2; replace (t j - off N i n + off N i n) with (t j) by
      ring; exact RN|]. specialize (RE m ltac:(lia)); rewrite (proj1 (glob_kinds N i m)), arc_S in RE; destruct (glob N i m
      0) as (_ & _ & _ & _ & E & _); cbv zeta in E; rewrite E in RE; replace (r (S m) - off N i m + off N i m) with (r (S
      m)) by ring; destruct (imp m); [exact RE | rewrite RE; ring].
  - replace (r 0%nat - off N i 0 + off N i 0) with (t i) by (rewrite R1; ring); exact RS.
  - intros m Hm'; destruct (glob N i m (r (S m))) as (_ & _ & _ & E & _); cbv zeta in E; rewrite E, <- (proj2 (glob_kinds N
      i m)); replace (r (S m) - off N i (S m) + off N i (S m)) with (r (S m)) by ring; replace (r (S m) - off N i m + off N
      i m) with (r (S m)) by ring; apply follows_is, (R9 m Hm').
  - intros m x Hm' Hx Hl; replace (off N i m + x) with (x + off N i m) by ring; apply R10; [exact Hm' | lra | intros Q;
      apply Hl; lra].
  - destruct (R10 n (t j) (le_n n)) as [_ Q]; [pose proof (R5 n (le_n n)); lra | auto |]. rewrite R11, Q, HIo, R2; replace
      (t j - off N i n + off N i n) with (t j) by ring; rewrite En; symmetry; apply touch_law.
Qed.
Lemma same_motions mu d N t y v (n : Z -> nat) : Rabs mu <= qm -> d <= qm -> (forall i, N (i + 1) = N i + Z.of_nat (n
  i))%Z -> bouncing_motion O mu d N t y v <-> motion Leg mu d N t y v.
Proof.
  intros Hm Hd HN; assert (L : forall i, (N i <= N (i + 1))%Z) by (intros i; rewrite HN; lia); split; intros H i j ->;
    [apply leg_from | apply leg_to]; trivial; apply H; reflexivity.
Qed.
End Legs.

(** ** The linearized equation *)
Lemma f_on m t : 0 <= t <= Tj (md m) -> @a (Fm m) t (@y0 (Fm m) t) (@v0 (Fm m) t) 0 = a0 (zz (md m)) (t + bs (md m)) (yy
  (md m) t) (vv (md m) t) 0.
Proof.
  intros Ht; destruct (f_at m t Ht) as [-> ->]; destruct (HFq (md m) (md_lt m)) as (Hq & _ & _ & Ag & _); unfold Fm;
    apply Ag; [exact Ht|]; unfold inside; rewrite !Rminus_eq_0, Rabs_R0; lra.
Qed.
Lemma leap_glob m h z w z' w' : (m < k)%nat -> leap Fm em rho imp Rm Rt Rv Jm Jy m h z w z' w' <->
  linear_impact O (zz m) h (z (em m)) (w (em m)) (z' rho) (w' rho).
Proof.
  intros Hm; pose proof (len_pos (md m)); pose proof (len_pos (md (S m))); unfold leap, linear_impact, turnover, jump, Rm,
    Rt, Rv, Jm, Jy, Vm, imp; cbv zeta. destruct (f_ends m) as (Y1 & E1 & I1), (f_begins (S m)) as (Y2 & E2), (f_next m)
    as (E0 & E3 & E4), (Arcs (zz (md m))) as (_ & A & _); unfold imp, Vm in *; rewrite (md_small m Hm) in *.
  destruct (Bouncing.impact O (zz m)) eqn:I; [|reflexivity]; unfold StatementBouncing.follows in A; rewrite I in A; destruct
    A as [A0 _]; rewrite E0, A0 in Y2; rewrite (proj1 (I1 eq_refl)) in Y1; rewrite !f_on by (unfold em, Tj; rewrite
    ?(md_small m Hm); lra).
  destruct (f_at m (em m)) as [Y3 V3]; [unfold em, Tj; rewrite (md_small m Hm); lra|]; destruct (f_at (S m) rho) as [Y4
    V4]; [unfold Tj; lra|]. rewrite <- Y3, <- V3, <- Y4, <- V4, Y1, Y2, E1, E2, E3; replace (rho + bs (md (S m))) with (s
    (zz (md (S m)))) by (unfold bs; ring); rewrite (md_small m Hm); replace (em m + bs m) with (s (zz m + 1)%Z) by (unfold
    em, len, bs; rewrite (md_small m Hm); ring); rewrite E4.
  split; intros (q & Q1 & Q2 & Q3); exists q; cbv zeta in *; repeat split; trivial; lra.
Qed.
Lemma coef_period x : s 0%Z <= x <= s 1%Z -> forall g, (g = Bouncing.a_y O \/ g = Bouncing.a_v O \/ g = Bouncing.a_mu O)
  -> g kz (x + T0) (Y kz (x + T0)) (V kz (x + T0)) 0 = g 0%Z x (Y 0 x) (V 0 x) 0.
Proof.
  intros Hx g Hg'; destruct (many 1 0%Z x) as (E1 & E2 & E3 & E4); rewrite Z.mul_1_r, Z.add_0_l, ?Rmult_1_r in E1, E2,
    E3; rewrite Rmult_1_r, Z.mul_1_r, Z.add_0_l in E4; rewrite E2, E3; destruct (many 1 1%Z x) as (E5 & _); rewrite Z.mul_1_r, Rmult_1_r in
        E5.
  destruct Hforce as [_ HC]; destruct (HC 0%Z) as [_ Cy Cv Cm _], (HC kz) as [_ Cy' Cv' Cm' _].
  assert (D0 : beside O (2 * rho) 0 x (Y 0 x) (V 0 x) /\ Rabs 0 <= 2 * rho) by (unfold beside; rewrite Z.add_0_l,
    !Rminus_eq_0, Rabs_R0; lra).
  assert (D1 : beside O (2 * rho) kz (x + T0) (Y 0 x) (V 0 x) /\ Rabs 0 <= 2 * rho) by (unfold beside; rewrite E2, E3,
    E1, (Z.add_comm kz 1), E5, !Rminus_eq_0, Rabs_R0; lra).
  destruct Hg' as [->|[->| ->]].
  - apply (uniqueness_limite (fun y => a0 0%Z x y (V 0 x) 0) (Y 0 x)); [|apply Cy, D0]; eapply D_ext; [apply Cy', D1 |
      intros y; apply (proj1 (E4 y (V 0 x) 0)) | reflexivity].
  - apply (uniqueness_limite (fun v => a0 0%Z x (Y 0 x) v 0) (V 0 x)); [|apply Cv, D0]; eapply D_ext; [apply Cv', D1 |
      intros v; apply (proj1 (E4 (Y 0 x) v 0)) | reflexivity].
  - apply (uniqueness_limite (fun mu => a0 0%Z x (Y 0 x) (V 0 x) mu) 0); [|apply Cm, D0]; eapply D_ext; [apply Cm', D1 |
      intros mu; apply (proj1 (E4 (Y 0 x) (V 0 x) mu)) | reflexivity].
Qed.
Lemma coefs m x : (m <= k)%nat -> s (zz m) <= x <= s (zz m + 1)%Z -> let at_x g := g (zz m) x (Y (zz m) x) (V (zz m) x) 0 in kj
  (md m) (x - bs m) = at_x (Bouncing.a_y O) /\ cj (md m) (x - bs m) = at_x (Bouncing.a_v O) /\ lj (md m) (x - bs m) =
      at_x (Bouncing.a_mu O).
Proof.
  intros Hm Hx at_x; assert (Own : forall j x, s (zz j) <= x <= s (zz j + 1)%Z -> let at_x g := g
    (zz j) x (Y (zz j) x) (V (zz j) x) 0 in kj j (x - bs j) = at_x (Bouncing.a_y O) /\ cj j (x - bs j) = at_x
    (Bouncing.a_v O) /\ lj j (x - bs j) = at_x (Bouncing.a_mu O)).
  { intros j u Hu at_u; unfold at_u, kj, cj, lj, NonlinearArc.k, NonlinearArc.c, NonlinearArc.l, arc_at, sh, yy, vv. rewrite
      !froz_id by (unfold bs, Tj, len; lra). replace (u - bs j + bs j) with u by ring; auto. }
  destruct (Nat.eq_dec m k) as [->|Ne]; [|rewrite (md_small m) by lia; apply Own, Hx].
  assert (Ek : md k = 0%nat) by (unfold md; apply Nat.mod_same; lia); rewrite Ek. destruct (many 1 0%Z 0) as (E1 & _),
    (many 1 1%Z 0) as (E2 & _); rewrite Z.mul_1_r, Z.add_0_l, Rmult_1_r in E1; rewrite Z.mul_1_r, Rmult_1_r, Z.add_comm
        in E2; rewrite E1, E2 in
    Hx. replace (x - bs k) with (x - T0 - bs 0) by (unfold bs; rewrite E1; change (zz 0) with 0%Z; ring).
  destruct (Own 0%nat (x - T0)) as (Q1 & Q2 & Q3); [change (zz 0) with 0%Z; rewrite Z.add_0_l; lra|]; rewrite Q1, Q2,
    Q3; change (zz 0) with 0%Z; unfold at_x. assert (I : s 0%Z <= x - T0 <= s 1%Z) by lra. pose proof (coef_period _ I
    (Bouncing.a_y O) ltac:(auto)) as C1'; pose proof (coef_period _ I (Bouncing.a_v O) ltac:(auto)) as C2'; pose proof
    (coef_period _ I (Bouncing.a_mu O) ltac:(auto)) as C3'. replace (x - T0 + T0) with x in C1', C2', C3' by ring; auto.
Qed.
Notation local m := (solves (kj (md m)) (cj (md m)) (lj (md m))).
Lemma lin_glob m h z w : (m <= k)%nat -> local m h z w -> linear_along O (zz m) h (fun x => z (x - bs m)) (fun x => w (x
    - bs m)).
Proof.
  intros Hm H x Hx; cbv zeta; destruct (coefs m x Hm Hx) as (<- & <- & <-), (H (x - bs m)) as [D1 D2]; split; (eapply
    D_value; [apply (D_of (fun x => x - bs m)); [apply D_shift | eassumption] | ring]).
Qed.
Lemma lin_agree m h z w z' w' : (m <= k)%nat -> local m h z w -> linear_along O (zz m) h z' w' -> z rho = z' (s (zz m))
  -> w rho = w' (s (zz m)) -> forall x, s (zz m) <= x <= s (zz m + 1)%Z -> z (x - bs m) = z' x /\ w (x - bs m) = w' x.
Proof.
  intros Hm H H' E1 E2 x Hx; pose proof (lin_glob m h z w Hm H) as G; set (l := s (zz m + 1)%Z - s (zz m)).
  assert (Es : forall t, t + s (zz m) - bs m = t + rho) by (intros t; unfold bs; ring).
  destruct (bound (2 * @L (Fm m)) l (fun t => z (t + s (zz m) - bs m) - z' (t + s (zz m))) (fun t => w (t + s (zz m) -
      bs m) - w' (t + s (zz m))) (fun t => kj (md m) (t + rho) * (z (t + s (zz m) - bs m) - z' (t + s (zz m))) + cj (md
      m) (t + rho) * (w (t + s (zz m) - bs m) - w' (t + s (zz m)))) 0) with (x := x - s (zz m)) as [Q _].
  - pose proof (@HL (Fm m)); lra.
  - lra.
  - intros t Ht; assert (It : s (zz m) <= t + s (zz m) <= s (zz m + 1)%Z) by (unfold l in Ht; lra); destruct (G _ It) as
      [D1 D2], (H' _ It) as [D3 D4], (coefs m _ Hm It) as (C1 & C2 & C3); cbv zeta in D2, D4; rewrite <- C1, <- C2, <-
          C3, !Es in D2, D4.
    split; [|split].
    + apply D_minus; [apply (D_later (fun x => z (x - bs m))), D1 | apply (D_later z'), D3].
    + eapply D_value; [apply D_minus; [apply (D_later (fun x => w (x - bs m))), D2 | apply (D_later w'), D4] | rewrite
        ?Es; ring].
    + assert (Il : 0 <= t + rho <= @T (Fm m)).
      { destruct (HFq (md m) (md_lt m)) as (_ & ET & _); unfold Fm; rewrite ET; unfold Tj, len; pose proof (md_split m)
          as Em; set (q := (m / k)%nat) in *; destruct (many (zz q) (zz (md m)) 0) as (A1 & _), (many (zz q) (zz (md m)
              + 1)%Z 0) as (A2 & _).
        replace (zz (md m) + kz * zz q)%Z with (zz m) in A1 by lia; replace (zz (md m) + 1 + kz * zz q)%Z with (zz m +
          1)%Z in A2 by lia. unfold l in Ht; rewrite A1, A2 in Ht; lra. }
      destruct (proj1 (f_along m) _ Il) as (B1 & B2 & _); eapply Rle_trans; [apply Rabs_triang|]; pose proof (product _
        _ _ _ B1 (Rle_refl (Rabs (z (t + s (zz m) - bs m) - z' (t + s (zz m)))))); pose proof (product _ _ _ _ B2
        (Rle_refl (Rabs (w (t + s (zz m) - bs m) - w' (t + s (zz m)))))). pose proof (@HL (Fm m)) as HL; pose proof
        (Rabs_pos (z (t + s (zz m) - bs m) - z' (t + s (zz m)))) as P1; pose proof (Rabs_pos (w (t + s (zz m) - bs m) -
        w' (t + s (zz m)))) as P2. assert (0 <= @L (Fm m) * Rabs (z (t + s (zz m) - bs m) - z' (t + s (zz m))) /\ 0 <=
        @L (Fm m) * Rabs (w (t + s (zz m) - bs m) - w' (t + s (zz m)))) by (split; apply Rmult_le_pos; lra). lra.
  - unfold l; lra.
  - cbv beta in Q; rewrite !Es, !Rplus_0_l, E1, E2, !Rminus_eq_0, Rabs_R0 in Q. replace (x - s (zz m) + rho) with (x -
      bs m) in Q by (unfold bs; ring); replace (x - s (zz m) + s (zz m)) with x in Q by ring. pose proof (Rabs_pos (z (x
      - bs m) - z' x)); pose proof (Rabs_pos (w (x - bs m) - w' x)); split; apply Rminus_diag_uniq, Rabs_zero; lra.
Qed.

Notation chain := (chain Fm (fun m => kj (md m)) (fun m => cj (md m)) (fun m => lj (md m)) em rho imp Rm Rt Rv Jm Jy k).
Lemma next_times m : (m < k)%nat -> s (zz m + 1)%Z - bs m = em m /\ s (zz m + 1)%Z - bs (S m) = rho.
Proof.
  intros Hm; unfold em, len, bs; rewrite (md_small m Hm); split; [ring|]. replace (zz (S m)) with (zz m + 1)%Z by lia;
      ring.
Qed.
Lemma round_to h z w : chain h z w -> linear_round O h (fun c x => z (Z.to_nat c) (x - bs (Z.to_nat c))) (fun c x => w
  (Z.to_nat c) (x - bs (Z.to_nat c))).
Proof.
  intros [C1 C2]; split; intros c Hc.
  - assert (Ec : c = zz (Z.to_nat c)) by lia; rewrite Ec at 1; apply lin_glob; [lia | apply C1; lia].
  - cbv zeta; set (m := Z.to_nat c); assert (Ec : c = zz m) by (unfold m; lia); assert (Hm : (m < k)%nat) by lia.
    replace (Z.to_nat (c + 1)) with (S m) by lia; rewrite Ec; destruct (next_times m Hm) as [E1 E2]; rewrite E1, E2.
    apply leap_glob; [exact Hm | apply C2, Hm].
Qed.
Lemma round_from h z w : linear_round O h z w -> exists z' w', chain h z' w' /\ forall m x, (m <= k)%nat -> s (zz m) <=
    x <= s (zz m
  + 1)%Z -> z' m (x - bs m) = z (zz m) x /\ w' m (x - bs m) = w (zz m) x.
Proof.
  intros [G1 G2]; destruct (choose ((R -> R) * (R -> R)) (fun _ => 0, fun _ => 0) (fun m zw => local m h (fst zw) (snd
    zw) /\ fst zw rho = z (zz m) (s (zz m)) /\ snd zw rho = w (zz m) (s (zz m))) (S k)) as (zw & Hzw).
  { intros m _; destruct (proj2 (proj2 (f_along m)) h rho (z (zz m) (s (zz m))) (w (zz m) (s (zz m)))) as (z1 & w1 & H);
      exists (z1, w1); exact H. }
  assert (Ag : forall m x, (m <= k)%nat -> s (zz m) <= x <= s (zz m + 1)%Z -> fst (zw m) (x - bs m) = z (zz m) x /\ snd
    (zw m) (x - bs m) = w (zz m) x).
  { intros m x Hm Hx; destruct (Hzw m ltac:(lia)) as (L & E1 & E2); apply (lin_agree m h (fst (zw m)) (snd (zw m)));
      trivial; apply G1; lia. }
  exists (fun m => fst (zw m)), (fun m => snd (zw m)); split; [|exact Ag]; split; intros m Hm.
  - apply (Hzw m ltac:(lia)).
  - apply leap_glob; [exact Hm|]; destruct (next_times m Hm) as [E1 E2]; specialize (G2 (zz m) ltac:(lia)); cbv zeta in
      G2.
    pose proof (proj1 (Arcs (zz m))); pose proof (proj1 (Arcs (zz m + 1)%Z)); destruct (Ag m (s (zz m + 1)%Z) ltac:(lia)
      ltac:(lra)) as [A1 A2], (Ag (S m) (s (zz m + 1)%Z) ltac:(lia)) as [A3 A4]; [replace (zz (S m)) with (zz m + 1)%Z
          by lia; lra|].
    rewrite E1 in A1, A2; rewrite E2 in A3, A4; replace (zz (S m)) with (zz m + 1)%Z in A3, A4 by lia; rewrite A1, A2,
      A3, A4; exact G2.
Qed.

(** ** The theorem *)
Lemma positive_min (f : R -> R) lo hi : (forall x, continuity_pt f x) -> (forall x, lo <= x <= hi -> 0 < f x) -> exists
  d, 0 < d /\ forall x, lo <= x <= hi -> d <= f x.
Proof.
  intros C Pf; destruct (Rle_lt_dec lo hi) as [L|L]; [|exists 1; split; [lra | intros x Hx; lra]].
  destruct (continuity_ab_min f lo hi L (fun x _ => C x)) as (u & U & I); exists (f u); split; [apply Pf, I | intros x
    Hx; apply U, Hx].
Qed.
Lemma steep_all : exists d, 0 < d <= rho /\ forall m, imp m = true -> forall x mu t, within 2 d x -> Rabs mu <= d -> (Rabs
  (t - em m) <= d -> Rabs (@NonlinearFlow.V (Fm m) x mu t - @v0 (Fm m) (em m)) <= - @v0 (Fm m) (em m) / 2) /\ (Rabs (t -
  rho) <= d -> 0 < @NonlinearFlow.V (Fm (S m)) x mu t).
Proof.
  set (Q := fun m d => imp m = true -> forall x mu t, within 2 d x -> Rabs mu <= d -> (Rabs (t - em m) <= d -> Rabs
    (@NonlinearFlow.V (Fm m) x mu t - @v0 (Fm m) (em m)) <= - @v0 (Fm m) (em m) / 2) /\ (Rabs (t - rho) <= d -> 0 <
    @NonlinearFlow.V (Fm (S m)) x mu t)).
  destruct (least k Hk Q k) as (d & Hd & H).
  - intros m d d' H Hd I x mu t Hx Hm; destruct (H I x mu t) as [A B]; [intros i Hi; specialize (Hx i Hi); lra | lra|];
      split; intros Ht; [apply A | apply B]; lra.
  - intros m _; assert (Hs0 : 0 < rho /\ 0 <= rho - rho /\ rho + rho <= @T (Fm (S m))) by (pose proof (f_starts (S m));
      lra). destruct (imp m) eqn:I; [|exists 1; split; [lra | intros I'; rewrite I in I'; discriminate]].
    destruct (f_ends m) as (_ & E1 & N1), (f_begins (S m)) as (_ & E2), (f_next m) as (_ & E3 & _), (Arcs (zz (md m)))
      as (_ & _ & P2); specialize (N1 I); unfold imp in I; rewrite I in P2; rewrite <- E3, <- E2 in P2; set (w := @v0
      (Fm (S m)) rho) in *. destruct (@steady_point (Fm m) (em m) rho (f_times m) (- Vm m / 2) ltac:(lra)) as (d1 & D1 &
      S1), (@steady_point (Fm (S m)) rho rho Hs0 (w / 2) ltac:(lra)) as (d2 & D2 & S2).
    destruct (two_least d1 d2 ltac:(lra) ltac:(lra)) as (d & Hd & L1 & L2); exists d; split; [exact Hd|]; intros _ x mu t
      Hx Hm; split; intros Ht.
    + rewrite E1; rewrite <- E1 at 1; apply S1; [intros i Hi; specialize (Hx i Hi); lra | lra | lra].
    + destruct (S2 x mu t) as [Z _]; [intros i Hi; specialize (Hx i Hi); lra | lra | lra|]. fold w in Z; apply
        le_abs in Z; lra.
  - destruct (two_least d rho Hd Hrho) as (d' & Hd' & L1 & L2); exists d'; split; [lra|]; intros m I x mu t Hx Hm.
    assert (W : forall j, Q j d) by (apply (repeated k Hk); [intros j; unfold Q, imp, Fm, em; rewrite <- Nat.add_succ_r,
      !md_k; auto | exact H]).
    destruct (W m I x mu t) as [A B]; [intros i Hi; specialize (Hx i Hi); lra | lra|]; split; intros Ht; [apply A | apply
        B]; lra.
Qed.
(** A number for each arc, one for all. *)
Lemma least_all (Q : nat -> R -> Prop) : (forall m d d', Q m d -> 0 < d' <= d -> Q m d') -> (forall m, Q (md m) = Q m)
  -> (forall m, exists d, 0 < d /\ Q m d) -> exists d, 0 < d /\ forall m, Q m d.
Proof.
  intros Down Eq H; destruct (least k Hk Q k Down (fun m _ => H m)) as (d & Hd & A); exists d; split; [exact Hd|];
    intros m; rewrite <- Eq; apply A, md_lt.
Qed.
Lemma md_md m : md (md m) = md m. Proof. apply md_small, md_lt. Qed.
Lemma bounds_all : exists wmin B lmin, 0 < wmin /\ 1 <= B /\ 0 < lmin /\ forall m, (imp m = true -> wmin <= - @v0 (Fm m) (em m)) /\ @M
  (Fm m) <= B /\ 4 * lmin <= em m - rho.
Proof.
  destruct (least_all (fun m d => imp m = true -> d <= - @v0 (Fm m) (em m))) as (wmin & W & HW).
  { intros m d d' H Hd I; specialize (H I); lra. } { intros m; unfold Fm, em, imp; rewrite md_md; reflexivity. }
  { intros m; destruct (f_ends m) as (_ & E & N); destruct (imp m); [exists (- @v0 (Fm m) (em m)); rewrite E; destruct N;
      trivial; split; lra | exists 1; split; [lra | discriminate]]. }
  destruct (least_all (fun m d => @M (Fm m) <= / d)) as (b & Hb & HB).
  { intros m d d' H Hd; apply Rle_trans with (1 := H), Rinv_le_contravar; lra. } { intros m; unfold Fm; rewrite md_md;
      reflexivity. }
  { intros m; pose proof (@M_large (Fm m)); exists (/ @M (Fm m)); split; [apply Rinv_0_lt_compat; lra | rewrite
      Rinv_inv; lra]. }
  destruct (least_all (fun m d => 4 * d <= em m - rho)) as (l & Hl & HL).
  { intros; lra. } { intros m; unfold em; rewrite md_md; reflexivity. }
  { intros m; pose proof (len_pos (md m)); exists (len (md m) / 4); unfold em; split; lra. }
  exists wmin, (/ b), l; split; [exact W | split; [pose proof (@M_large (Fm 0)); specialize (HB 0%nat); lra | split;
    [exact Hl | intros m; split; [apply HW | split; [apply HB | apply HL]]]]].
Qed.
Definition before (m : nat) : bool := imp (md m + (k - 1)).
Lemma before_is m : before m = Bouncing.impact O (zz (md m) - 1)%Z /\ before (S m) = imp m.
Proof.
  pose proof (md_lt m) as L; split.
  - unfold before, imp; destruct (Nat.eq_dec (md m) 0) as [->|Ne]; [rewrite md_small by lia; cbn [Nat.add]; rewrite <-
      (proj1 (many_kinds 1 (zz 0 - 1))); f_equal; lia|]. replace (md m + (k - 1))%nat with (k + (md m - 1))%nat by lia;
      rewrite md_k, md_small by lia; f_equal; lia.
  - unfold before, imp; f_equal; f_equal; destruct (md_S m) as [[Q ->]|[Q ->]]; [replace (S (md m) + (k - 1))%nat with (k +
      md m)%nat by lia; rewrite md_k; apply md_md | rewrite md_small by lia; lia].
Qed.
Lemma min_all rho1 r0 : 0 < rho1 -> 0 < r0 -> exists d, 0 < d /\ forall m t, rho + (if before m then rho1 else 0) <= t <=
  em m - (if imp m then rho1 else 0) -> (md m = 0%nat -> r0 <= Rabs (t - tl)) -> d <= @y0 (Fm m) t.
Proof.
  intros P1 P2; apply least_all.
  - intros m d d' H Hd t Ht Hc; specialize (H t Ht Hc); lra.
  - intros m; unfold before, imp, Fm, em; rewrite md_md; reflexivity.
  - intros m; assert (C : forall x, continuity_pt (@y0 (Fm m)) x) by (intros x; apply (D_continuous _ _ _ (proj1 (@Horb
      (Fm m) x)))). set (lo := rho + _); set (hi := em m - _).
    assert (Pos : forall t, lo <= t <= hi -> (md m = 0%nat -> r0 <= Rabs (t - tl)) -> 0 < @y0 (Fm m) t).
    { intros t Ht Hc; destruct (Arcs (zz (md m) - 1)%Z) as (_ & _ & A), (Arcs (zz (md m))) as (_ & _ & B); rewrite <-
        (proj1 (before_is m)) in A; fold (imp m) in B; replace (zz (md m) - 1 + 1)%Z with (zz (md m)) in A by lia;
        pose proof (len_pos (md m)); assert (It : rho <= t <= em m) by (unfold lo, hi in Ht; destruct (before m), (imp
        m); lra). destruct (f_at m t) as [-> _]; [unfold em, Tj in *; lra|]; unfold yy.
      destruct (Req_dec t rho) as [E|N1]; [unfold lo in Ht; destruct (before m); [lra|]; replace (t + bs (md m)) with (s
        (zz (md m))) by (rewrite E; unfold bs; ring); apply A|]. destruct (Req_dec t (em m)) as [E|N2]; [unfold hi in Ht;
        destruct (imp m); [lra|]; replace (t + bs (md m)) with (s (zz (md m) + 1)%Z) by (rewrite E; unfold em, len, bs;
        ring); apply B|]. apply (its_opening O HO); [unfold em, len, bs in *; lra|]. intros N [E1 E2]; pose proof (md_lt
        m); assert (N = 0%Z) by nia; subst N; assert (E0 : md m = 0%nat) by lia; specialize (Hc E0); rewrite E0 in E2;
        replace (t - tl) with 0 in Hc by (unfold tl; lra). rewrite Rabs_R0 in Hc; lra. }
    destruct (Nat.eq_dec (md m) 0) as [E0|Ne].
    + destruct (positive_min (@y0 (Fm m)) lo (Rmin hi (tl - r0)) C) as (d1 & D1 & H1).
      { intros x Hx; pose proof (Rmin_l hi (tl - r0)); pose proof (Rmin_r hi (tl - r0)); apply
          Pos; [lra|]; intros _; rewrite Rabs_left1; lra. }
      destruct (positive_min (@y0 (Fm m)) (Rmax lo (tl + r0)) hi C) as (d2 & D2 & H2).
      { intros x Hx; pose proof (Rmax_l lo (tl + r0)); pose proof (Rmax_r lo (tl + r0)); apply Pos;
          [lra|]; intros _; rewrite Rabs_pos_eq; lra. }
      destruct (two_least d1 d2 D1 D2) as (d & Hd & L1 & L2); exists d; split; [exact Hd|]; intros t Ht Hc; specialize
        (Hc E0); unfold Rabs in Hc; destruct (Rcase_abs (t - tl)).
      * specialize (H1 t ltac:(split; [lra | apply Rmin_glb; lra])); lra.
      * specialize (H2 t ltac:(split; [apply Rmax_lub; lra | lra])); lra.
    + destruct (positive_min (@y0 (Fm m)) lo hi C) as (d & Hd & H); [intros x Hx; apply Pos; [exact
        Hx | contradiction]|]. exists d; split; [exact Hd|]; intros t Ht _; apply H, Ht.
Qed.
Theorem bounces_main : bounces_decided O a1 a2 gamma rate.
Proof.
  destruct steep_all as (ds & Hds & St), bounds_all as (wmin & B & lmin & Hw & HB & Hl & All); pose proof tl_in as Htl;
    pose proof f_touch as (_ & _ & Hg0); set (g0 := @a (Fm 0) tl 0 0 0) in *.
  destruct (@window_exists (Fm 0) To (g0 / 4) ltac:(lra)) as (r' & d1 & Win); assert (Hr' : 0 < r') by apply Win; assert
    (Hd1 : 0 < d1) by apply Win.
  destruct (two_least ((tl - rho) / 4) ((em 0 - tl) / 4) ltac:(lra) ltac:(lra)) as (q1 & Hq1 & A1 & A2), (two_least r'
    q1 Hr' Hq1) as (r0 & Hr0 & A3 & A4), (two_least ds q1 ltac:(lra) Hq1) as (q2 & Hq2 & A5 & A6), (two_least q2 lmin
    Hq2 Hl) as (rho1 & Hrho1 & A7 & A8).
  pose proof (@M_large (Fm 0)) as LM; destruct (two_least d1 (g0 * r0 / (8 * @M (Fm 0))) Hd1 ltac:(apply
    Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra)) as (d0 & Hd0 & A9 & A10).
  assert (Hd0' : 8 * (@M (Fm 0) * d0) <= g0 * r0) by (apply Rle_trans with (8 * (@M (Fm 0) * (g0 * r0 / (8 * @M (Fm
    0))))); [apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra | right; field; lra]).
  pose (Wo := @Build_near (Fm 0) To r0 d0 (@window_down (Fm 0) To (g0 / 4) r' d1 r0 d0 Win ltac:(lra) ltac:(lra)) Hd0').
  assert (Pw : 0 < wmin * rho1) by (apply Rmult_lt_0_compat; lra). destruct (two_least ds (wmin * rho1 / (4 * B))
    ltac:(lra) ltac:(apply Rdiv_lt_0_compat; lra)) as (r1 & Hr1 & A11 & A12).
  assert (Br : B * r1 <= wmin * rho1 / 4) by (apply Rle_trans with (B * (wmin * rho1 / (4 * B))); [apply
    Rmult_le_compat_l; lra | right; field; lra]).
  destruct (min_all rho1 r0 Hrho1 Hr0) as (ymin & Hy & Ym).
  assert (Hex : forall m, imp m = true -> @y0 (Fm m) (em m) = 0 /\ @v0 (Fm m) (em m) < 0) by (intros m I; destruct (f_ends
    m) as (E1 & E2 & E3); rewrite E1, E2; apply E3, I).
  assert (HR1 : 0 < r1 /\ 0 < rho1 <= rho /\ forall m, imp m = true -> 2 * (@M (Fm m) * r1) < - @v0 (Fm m) (em m) *
    rho1).
  { split; [exact Hr1 | split; [lra|]]; intros m I; destruct (All m) as (W1 & W2 & _); specialize (W1 I); assert (@M (Fm
      m) * r1 <= B * r1) by (apply Rmult_le_compat_r; lra); assert (wmin * rho1 <= - @v0 (Fm m) (em m) * rho1) by (apply
      Rmult_le_compat_r; lra); lra. }
  assert (HS1 : forall m, imp m = true -> forall x mu t, within 2 r1 x -> Rabs mu <= r1 -> Rabs (t - em m) <= rho1 -> Rabs
    (@NonlinearFlow.V (Fm m) x mu t - @v0 (Fm m) (em m)) <= - @v0 (Fm m) (em m) / 2).
  { intros m I x mu t Hx Hm Ht; destruct (St m I x mu t) as [Q _]; [intros i Hi; specialize (Hx i Hi); lra | lra | apply
      Q; lra]. }
  assert (HS2 : forall m, imp m = true -> forall x mu t, within 2 r1 x -> Rabs mu <= r1 -> Rabs (t - rho) <= rho1 -> 0 <
    @NonlinearFlow.V (Fm (S m)) x mu t).
  { intros m I x mu t Hx Hm Ht; destruct (St m I x mu t) as [_ Q]; [intros i Hi; specialize (Hx i Hi); lra | lra | apply
      Q; lra]. }
  destruct (round_exists k Fm (fun m => kj (md m)) (fun m => cj (md m)) (fun m => lj (md m)) em rho rho1 r1 imp law jy Rm
    Rt Rv Jm Jy Hk f_period f_kinds f_along f_times f_starts Hex f_entry f_jy f_law HR1 HS1) as (rf & Kf & A & phi & Hrf & HKf & HSm & HCh & Hlp
        & Hsz).
  destruct (proj2 (proj2 (f_along 0)) 0 0 1 0) as (p1 & s1 & F1), (proj2 (proj2 (f_along 0)) 0 0 0 1) as (p2 & s2 & F2),
    (proj2 (proj2 (f_along 0)) 1 0 0 0) as (p3 & s3 & F3), (proj2 (proj2 (f_along 0)) 0 tl 0 1) as (zb & wb & Fb).
  destruct (its_law O HO) as (L1 & L2 & L3), (its_law_C1 O HO) as (rl & f1 & f2 & f3 & f4 & Hrl & Ef3 & HCl).
  assert (Reb : 0 <= Bouncing.tau O /\ (forall mu t, Bouncing.rebound O 0 mu (t + bs 0) 0 = 0) /\ (forall mu t v, v < 0
    -> 0 <= Bouncing.rebound O 0 mu (t + bs 0) v) /\ forall eps, 0 < eps -> exists d, 0 < d /\ forall mu t v mu' t' v',
    Rabs mu <= d -> Rabs (t - tl) <= d -> Rabs v <= d -> Rabs mu' <= d -> Rabs (t' - tl) <= d -> Rabs v' <= d -> Rabs
    (Bouncing.rebound O 0 mu (t + bs 0) v - Bouncing.rebound O 0 mu' (t' + bs 0) v' + Bouncing.tau O * (v - v')) <= eps
    * (Rabs (mu - mu') + Rabs (t - t') + Rabs (v - v'))).
  { split; [exact L1 | split; [intros; apply L2 | split; [intros mu t v Hv; apply L3, Hv|]]]; intros eps He; destruct
      (law_strict (Bouncing.rebound O 0%Z) (Bouncing.tau O) tg f1 f2 f3 f4 rl L2 Hrl Ef3 HCl eps He) as (d & Hd & H); exists
          d; split; [exact Hd|].
    intros mu t v mu' t' v' X1 X2 X3 X4 X5 X6; replace (t - t') with (t + bs 0 - (t' + bs 0)) by ring; apply H; trivial;
      [replace (t + bs 0 - tg) with (t - tl) by (unfold tl; ring); exact X2 | replace (t' + bs 0 - tg) with (t' - tl) by
      (unfold tl; ring); exact X5]. }
  pose (Io := @NonlinearKick.Build_impact (Fm 0) To (fun mu t v => Bouncing.rebound O 0 mu (t + bs 0) v) (Bouncing.tau O)
    (kj (md 0)) (cj (md 0)) (lj (md 0)) p1 s1 p2 s2 p3 s3 zb wb Reb (proj1 (f_along 0)) (proj1 (proj2 (f_along 0)))
        (conj F1 (conj F2 F3)) Fb).
  destruct (least k Hk (fun j d => d <= qs j) k) as (qa & Hqa & HQ).
  { intros; lra. } { intros m Hm; destruct (HFq m Hm) as (Q & _); exists (qs m); split; lra. }
  destruct (two_least qa rho Hqa Hrho) as (qm & Hqm & A13 & A14). assert (Hqm' : 0 < qm <= rho /\ forall j, (j < k)%nat
    -> qm <= qs j) by (split; [lra | intros j Hj; specialize (HQ j Hj); lra]).
  destruct (its_matrix O a1 a2 gamma rate HG) as (al & be & de & Ea1 & Ea2 & HM); rewrite (Rmult_comm be) in Ea2.
  destruct (its_rate O a1 a2 gamma rate HG) as (z & w & Hz & Pz & Pww & Ez); destruct (round_from 1 z w Hz) as (zl & wl
      & Ch & Ag).
  destruct (many 1 0%Z 0) as (E0 & _), (many 1 1%Z 0) as (E1 & _); rewrite Z.mul_1_r, Z.add_0_l, Rmult_1_r in E0;
    rewrite Z.mul_1_r, Rmult_1_r, Z.add_comm in E1. destruct (its_touch O HO) as (Tg & _).
  assert (Ek : tg + T0 - bs k = tl) by (unfold tl, bs; rewrite E0; change (zz 0) with 0%Z; ring).
  destruct (Ag 0%nat tg ltac:(lia)) as [G1 G2]; [change (zz 0) with 0%Z; rewrite Z.add_0_l; lra|].
  destruct (Ag k (tg + T0) (le_n k)) as [G3 G4]; [rewrite E1, E0; lra|]. rewrite Ek in G3, G4; change (tg - bs 0) with
    tl in G1, G2; change (zz 0) with 0%Z in G1, G2; rewrite Pz in G3; rewrite Pww in G4.
  assert (H00 : zl k 0 = zl 0%nat 0 /\ wl k 0 = wl 0%nat 0).
  { apply (@lin_same (Fm 0) (kj (md 0)) (cj (md 0)) (lj (md 0)) (f_along 0) 1 (zl k) (wl k) (zl 0%nat) (wl 0%nat) tl).
    - replace (md 0) with (md k) by (rewrite md_0; unfold md; apply Nat.mod_same; lia); apply Ch; lia.
    - apply Ch; lia.
    - pose proof tl_T; lra.
    - rewrite G3, G1; reflexivity.
    - rewrite G4, G2; reflexivity. }
  pose proof (@round_core k Fm (fun m => kj (md m)) (fun m => cj (md m)) (fun m => lj (md m)) em rho rho1 r1 imp law jy Rm
    Rt Rv Jm Jy Hk f_period f_kinds f_along f_times Hex HR1 HS1 rf Kf A phi Hrf HKf HSm HCh Hlp Hsz To Wo Io ymin wmin (bs 0)) as Core.
  assert (C1' : 0 < ymin /\ forall m t, bare em rho rho1 imp m t -> (forall q, m = (k * q)%nat -> r0 <= Rabs (t -
    tl)) -> ymin <= @y0 (Fm m) t).
  { split; [exact Hy|]; intros m t (B1 & B2 & B3) Hc; apply Ym; [|intros E; apply (Hc (m / k)%nat); pose proof (md_split
      m); lia]. split; [|destruct (imp m); [specialize (B2 eq_refl)|]; lra]. destruct m as [|m]; [destruct (before 0); lra|];
      rewrite (proj2 (before_is m)); destruct (imp m); [specialize (B3 eq_refl)|]; lra. }
  specialize (Core C1' (conj Hw (fun m => proj1 (All m))) HS2).
  assert (C2' : rho + rho1 < tl - r0 /\ tl + r0 < em 0 - rho1 /\ forall m, rho + rho1 < em m - rho1) by (split; [lra |
    split; [lra | intros m; destruct (All m) as (_ & _ & Q); lra]]).
  specialize (Core C2' (conj eq_refl (conj eq_refl eq_refl)) al be de gamma zl wl).
  assert (C3' : forall z w, chain 0 z w -> z k tl = al * z 0%nat tl + gamma * w 0%nat tl /\ w k tl = be * z 0%nat tl +
    de * w 0%nat tl).
  { intros z0 w0 C; pose proof (HM _ _ (round_to 0 z0 w0 C)) as Q; cbv zeta beta in Q; rewrite Nat2Z.id in Q; change
      (Z.to_nat 0) with 0%nat in Q; rewrite Ek in Q; exact Q. }
  specialize (Core C3' (its_gamma _ _ _ _ _ HG) Ch (proj1 H00) (proj2 H00)).
  assert (Er : zl 0%nat tl = rate) by (rewrite G1; symmetry; exact Ez); change (@tG _ To) with tl in Core; rewrite Er in
    Core; specialize (Core (its_rate_not_0 _ _ _ _ _ HG)); cbv zeta in Core; rewrite <- Ea1, <- Ea2 in Core.
  assert (HIo : forall mu t v, @NonlinearKick.rebound _ _ Io mu t v = Bouncing.rebound O 0 mu (t + bs 0) v) by
      reflexivity.
  intros n_max; destruct (Core n_max) as (d & Hd & Core'); destruct (two_least d qm Hd Hqm) as (d' & Hd' & Q1 & Q2);
    exists d'; split; [exact Hd'|]; intros eps Heps. destruct (Core' eps ltac:(lra)) as (mu0 & Hmu0 & W); pose proof
    (its_rate_not_0 _ _ _ _ _ HG) as Hrate; assert (Pra : 0 < Rabs rate) by (apply Rabs_pos_lt, Hrate).
  destruct (two_least mu0 (Rabs rate * qm) Hmu0 ltac:(apply Rmult_lt_0_compat; lra)) as (mu1 & Hmu1 & Q3 & Q4); exists
    mu1; split; [exact Hmu1|]. intros n N e g mu Hn HN Hs Hmu; assert (Sm : 0 < Rabs mu < qm) by (apply (small_mu rate
        e); [exact Hrate | lra]).
  assert (Same : forall r t y v, r <= qm -> bouncing_motion O mu r N t y v <-> motion (@Leg k Fm em rho imp law jy To Io (bs
    0)) mu r N t y v) by (intros r t y v Hr; apply (same_motions Io HIo qm Hqm' mu r N t y v n); [lra | exact Hr | exact
        HN]).
  destruct (W n N e g mu Hn HN Hs ltac:(lra)) as [Ex No]; split.
  - intros Hall; destruct (Ex Hall) as (t & y & v & HMo & Un & Only); split.
    + exists t, y, v; split; [apply Same; [lra | exact HMo]|]. intros t' y' v' HM'; apply Only, Same; [lra | exact HM'].
    + intros t' y' v' HM'; apply Same in HM'; [|lra]; assert (At := Only t' y' v' HM'). destruct Un as (r & Hr & H);
        exists r; split; [exact Hr|]; intros j ep He; destruct (H j ep He) as (l & t2 & y2 & v2 & Hl' & Lg & Nj & Nl).
            exists l, t2, y2, v2; split; [exact
        Hl' | split; [intros i Hi; apply (leg_to Io HIo qm Hqm'); [lra | lra | rewrite HN; lia | apply Lg, Hi]|]].
      assert (E : forall i, t' i = t i /\ v' i (t' i) = v i (t i)).
      { intros i; destruct (At i) as [E2 F0]; split; [exact E2|]; rewrite E2; apply F0. destruct (proj2 (Same eps t y v
          ltac:(lra)) HMo i _ eq_refl) as (rr & pp & qq & J). split; [lra|]. destruct (journey_from _ _ _ _ _ _ _ _ _
          _ _ _ _ J) as [<- _], (journey_to _ _ _ _ _ _ _ _ _ _ _ _ _ J) as [<- _].
        assert (Grow : forall m, (m <= S (others O N i (i + 1)))%nat -> rr 0%nat <= rr m).
        { intros m; induction m as [|m IH]; intros Hm; [lra|]; specialize (IH ltac:(lia)); pose proof (journey_arcs _ _ _
            _ _ _ _ _ _ _ _ _ _ J m ltac:(lia)); lra. }
        apply Grow; lia. }
      unfold StatementUnstable.near in *; destruct (E j) as [E2 E3], (E l) as [E4 E5]; rewrite E3, E5, E2, E4; auto.
  - intros Hb t y v HMo; apply Same in HMo; [|lra]; apply (No Hb t y v). intros i j Hj; destruct (HMo i j Hj) as (al' &
      om' & p' & q' & [R1 R2 R3 (R4 & R4' & R4'') R5 RE RS R6 R7 R8]); exists al', om', p', q'; constructor; trivial.
    + split; [lra | split; [lra | intros m Hm; specialize (R4'' m Hm); lra]].
    + intros m Hm; destruct (R5 m Hm) as (X1 & X2 & X3); split; [exact X1 | split; [|exact X3]]; intros x Hx; destruct
        (X2 x Hx) as (Y1 & Y2 & Y3); split; [exact Y1 | split; lra].
Qed.
End Main.
Theorem bouncing O a1 a2 gamma rate : bouncing_orbit O -> generic_round O a1 a2 gamma rate -> bounces_decided O a1 a2
    gamma rate.
Proof.
  intros HO HG; destruct (its_force O HO) as (r & Hr & H1 & H2); set (rho := r / 2); assert (Hrho : 0 < rho) by (unfold
      rho; lra).
  assert (Hf : (forall c t, Bouncing.s O c - 2 * rho <= t <= Bouncing.s O (c + 1)%Z + 2 * rho -> StatementBouncing.runs
    O c 0 (Bouncing.y0 O c) (Bouncing.v0 O c) t) /\ forall c, C1 (fun t y v mu => beside O (2 * rho) c t y v /\ Rabs mu
    <= 2 * rho) (Bouncing.a O c) (Bouncing.a_t O c) (Bouncing.a_y O c) (Bouncing.a_v O c) (Bouncing.a_mu O c)).
  { replace (2 * rho) with r by (unfold rho; field); auto. }
  destruct (arc_exists O HO rho Hrho Hf 0%nat) as (F0 & q0 & _).
  destruct (choose (force * R) (F0, q0) (fun j Fq => arc_of O rho j (fst Fq) (snd Fq)) (Bouncing.k O)) as (Fq & HFq).
  { intros j _; destruct (arc_exists O HO rho Hrho Hf j) as (F & q & H); exists (F, q); exact H. }
  exact (bounces_main O a1 a2 gamma rate HO HG rho Hrho Hf (fun j => fst (Fq j)) (fun j => snd (Fq j)) HFq).
Qed.
