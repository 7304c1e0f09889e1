(** * Proof of Theorem 1 for nonlinear oscillators: one with a touch is one of [StatementBouncing], cut once a period *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs Derivatives StatementWords StatementUnstable Headline StatementNonlinear
  StatementBouncing NonlinearSmooth NonlinearGronwall NonlinearSeen NonlinearTube NonlinearBounces.
Open Scope R_scope.

(** Theorem 1 of motions, and that they are unstable. *)
Definition decided (O : Nonlinear.t) (a1 a2 gamma rate : R) : Prop := forall n_max, exists d, d > 0 /\ forall eps, 0 <
  eps <= d -> exists mu0, mu0 > 0 /\
  forall (n : Z -> nat) (N : Z -> Z) e g mu, (forall i, (1 <= n i <= n_max)%nat /\ u a1 a2 (n i) <> 0) ->
  (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z -> sgn g * gamma > 0 -> 0 < sgn e * (rate * mu) < mu0 ->
  ((forall i, member a1 a2 e (n i) /\ edge a1 a2 e g (n i) (n (i + 1)%Z)) -> one_nonlinear_motion O mu eps N /\ forall
    t y v, nonlinear_motion O mu eps N t y v -> unstable_motion (leg O mu eps N) t v) /\
  ((exists i, breaks a1 a2 e g (n i) (n (i + 1)%Z)) -> forall t y v, ~ nonlinear_motion O mu d N t y v).

Section Cut.
Variable O : Nonlinear.t.
Hypothesis HO : grazing_orbit O.
Notation T := (Nonlinear.T O).
Notation tG := (Nonlinear.tG O).
Notation y0 := (Nonlinear.y0 O).
Notation v0 := (Nonlinear.v0 O).
Definition cut : Bouncing.t := Bouncing.Build_t T (fun _ => Nonlinear.a O) (fun _ => Nonlinear.a_t O) (fun _ =>
  Nonlinear.a_y O) (fun _ => Nonlinear.a_v O) (fun _ => Nonlinear.a_mu O) (fun _ => false) (fun _ => Nonlinear.rebound
    O)
  (fun _ _ _ _ => 0) (fun _ _ _ _ => 0) (fun _ _ _ _ => 0) (fun _ => 1) (fun _ _ => 0) (fun _ _ => 0) (fun _ _ => 0)
  (fun _ _ => 0) (Nonlinear.tau O) 1 (fun c => T * IZR c) (fun _ => y0) (fun _ => v0) tG.
Lemma at_cut c : y0 (T * IZR c) = y0 0 /\ v0 (T * IZR c) = v0 0 /\ 0 < y0 0.
Proof.
  destruct (period O HO) as (HT & _ & _ & Po), (touches O HO) as [HtG _]; rewrite <- (Rplus_0_l (T * IZR c)).
  split; [apply whole; intros t; apply Po | split; [apply whole; intros t; apply Po | apply (open_elsewhere O HO);
    lra]].
Qed.
Lemma cut_orbit : bouncing_orbit cut.
Proof.
  destruct (period O HO) as (HT & Pa & Pr & Po), (touches O HO) as [HtG Z0].
  assert (St : forall D, C1 D (fun _ _ _ _ => 0) (fun _ _ _ _ => 0) (fun _ _ _ _ => 0) (fun _ _ _ _ => 0) (fun _ _ _ _
    => 0)).
  { intros D; constructor; try (intros; apply D_const); repeat split; intros t y v mu _ eps He; exists 1; (split;
      [lra|]); intros; rewrite Rminus_eq_0, Rabs_R0; lra. }
  constructor; cbn [Bouncing.T Bouncing.a Bouncing.impact Bouncing.rebound Bouncing.face Bouncing.place Bouncing.speed
    Bouncing.k Bouncing.s Bouncing.y0 Bouncing.v0 Bouncing.tG Bouncing.tau cut].
  - split; [exact HT | split; [lia|]]; intros c t; cbv zeta; change (Z.of_nat 1) with 1%Z; rewrite plus_IZR.
    destruct (Po t) as [-> ->]; repeat split; try ring; [apply Pa | apply Pr].
  - intros c; destruct (at_cut (c + 1)) as (E & _ & P); cbv zeta; rewrite E; split; [rewrite plus_IZR; lra|].
    split; [unfold follows; cbn; split; ring | auto].
  - split; [rewrite Rmult_0_r, Rmult_1_r; exact HtG | split; [exact Z0 | apply (aG O HO)]].
  - intros c t Ht No; rewrite plus_IZR in Ht; assert (E : y0 t = y0 (t - T * IZR c)) by (transitivity (y0 (t - T * IZR c
      + T * IZR c)); [f_equal; ring | apply whole; intros x; apply Po]). rewrite E; apply (open_elsewhere O HO); [lra|];
      intros F; apply (No c); split; [lia | lra].
  - destruct (force_C1 O HO) as (r & Hr & H); exists r; split; [exact Hr|]; split; [intros c t _; apply (orbit_moves O
      HO)|]; intros c; apply (C1_sub _ _ _ _ _ _ _ H); intros t y v mu [[_ B] M]; split; [exact B | exact M].
  - exact (StatementNonlinear.law O HO).
  - exact (law_C1 O HO).
  - exists 1; split; [lra|]; intros c; cbn; split; apply St.
Qed.

(** ** The linearized equation *)
Variables (a1 a2 gamma rate : R).
Hypothesis HG : generic O a1 a2 gamma rate.
Notation kk := (fun t => along O (Nonlinear.a_y O) t).
Notation cc := (fun t => along O (Nonlinear.a_v O) t).
Notation ll := (fun t => along O (Nonlinear.a_mu O) t).
Definition lin_at m (z w : R -> R) t := derivable_pt_lim z t (w t) /\ derivable_pt_lim w t (kk t * z t + cc t * w t + ll
  t
  * m).
Lemma linear_unique z w z' w' t0 t1 : (forall t, t0 <= t <= t1 -> lin_at 0 z w t /\ lin_at 0 z' w' t) -> z t0 = z' t0 ->
  w t0 = w' t0 -> t0 <= t1 -> z t1 = z' t1 /\ w t1 = w' t1.
Proof.
  intros H Ez Ew Ht; pose proof (along_facts O HO) as C; destruct (period O HO) as (HT & _).
  destruct (periodic_bounded kk T HT ltac:(intros t; apply C) ltac:(intros t; apply C)) as (B1 & P1 & H1).
  destruct (periodic_bounded cc T HT ltac:(intros t; apply C) ltac:(intros t; apply C)) as (B2 & P2 & H2).
  destruct (bound (1 + B1 + B2) (t1 - t0) (fun t => z (t + t0) - z' (t + t0)) (fun t => w (t + t0) - w' (t + t0)) (fun t
    => kk (t + t0) * (z (t + t0) - z' (t + t0)) + cc (t + t0) * (w (t + t0) - w' (t + t0))) 0) with (x := t1 - t0) as
    [Q _]; try lra.
  - intros t It; destruct (H (t + t0) ltac:(lra)) as [[D1 D2] [D3 D4]]; split; [|split].
    + apply D_minus; [apply (D_later z), D1 | apply (D_later z'), D3].
    + eapply D_value; [apply D_minus; [apply (D_later w), D2 | apply (D_later w'), D4] | ring].
    + rewrite Rplus_0_r; set (p := z (t + t0) - z' (t + t0)); set (q := w (t + t0) - w' (t + t0)); pose proof (product _
        _ _ _ (H1 (t + t0)) (Rle_refl (Rabs p))); pose proof (product _ _ _ _ (H2 (t + t0)) (Rle_refl (Rabs q))).
      pose proof (Rabs_pos p); pose proof (Rabs_pos q); eapply Rle_trans; [apply Rabs_triang|]; nra.
  - rewrite !Rplus_0_l, Ez, Ew, !Rminus_eq_0, Rabs_R0, !Rplus_0_l, Rmult_0_r in Q; replace (t1 - t0 + t0) with t1 in Q
      by ring. pose proof (Rabs_pos (z t1 - z' t1)); pose proof (Rabs_pos (w t1 - w' t1)).
    split; apply Rminus_diag_uniq, Contraction.Rabs_zero; lra.
Qed.
Lemma cut_generic : generic_round cut a1 a2 gamma rate.
Proof.
  destruct HG as [(al & be & de & E1 & E2 & HM) G0 (z & w & Hl & P & Er) R0], (touches O HO) as [HtG _].
  assert (One : forall c m z w, (forall t, T * IZR c <= t <= T * IZR (c + 1) -> lin_at m z w t) <-> linear_along cut c m
    z w) by (intros c m p q; split; intros H t Ht; exact (H t Ht)).
  constructor; trivial.
  - exists al, be, de; split; [exact E1 | split; [exact E2|]]; intros p q [HA HI]; cbn [Bouncing.k cut] in *.
    change (Z.of_nat 1) with 1%Z in *; pose proof (proj2 (One 0%Z _ _ _) (HA 0%Z ltac:(lia))) as A0; pose proof (proj2
      (One 1%Z _ _ _) (HA 1%Z ltac:(lia))) as A1; destruct (HI 0%Z ltac:(lia)) as [I1 I2]; cbn in A0, A1, I1, I2.
    rewrite ?Rmult_0_l, ?Rmult_0_r, ?Rmult_1_r, ?Rmult_1_l, ?Rplus_0_l in *.
    destruct (linear_solutions O HO 0 tG (p 0%Z tG) (q 0%Z tG)) as (Z & W & HZ & EZ & EW).
    destruct (linear_unique (p 0%Z) (q 0%Z) Z W tG T) as [F1 F2]; auto; [intros t Ht; split; [apply A0; lra | apply HZ]
      | lra|].
    destruct (linear_unique (p 1%Z) (q 1%Z) Z W T (tG + T)) as [F3 F4]; try congruence; [intros t Ht; split; [apply A1;
      lra | apply HZ] | lra|]. cbn [Bouncing.tG Bouncing.T cut]; cbv zeta; rewrite F3, F4, <- EZ, <- EW; apply HM, HZ.
  - exists (fun _ => z), (fun _ => w); split; [|split; [apply P | split; [apply P | exact Er]]].
    split; [intros c _; apply One; intros t _; apply Hl | intros c _; cbn; split; ring].
Qed.
End Cut.

(** ** Derivatives on an interval, and a function that goes on beyond it *)
Definition on (lo hi : R) (f : R -> R) (x l : R) : Prop := forall eps, 0 < eps -> exists d, 0 < d /\ forall z, lo <= z
  <= hi
  -> Rabs (z - x) < d -> Rabs (f z - f x - l * (z - x)) <= eps * Rabs (z - x).
Lemma on_D lo hi f g x l : derivable_pt_lim g x l -> (forall z, lo <= z <= hi -> f z = g z) -> lo <= x <= hi ->
  on lo hi f x l.
Proof.
  intros D E Hx eps He; destruct (D eps He) as [d Hd]; exists d; split; [apply cond_pos|]; intros z Hz Hzx; rewrite !E
    by assumption. destruct (Req_dec z x) as [->|Ne]; [rewrite !Rminus_eq_0, Rmult_0_r, Rminus_eq_0, Rabs_R0; lra|].
  specialize (Hd (z - x) ltac:(lra) Hzx); replace (x + (z - x)) with z in Hd by ring; left; replace (g z - g x - l * (z
    - x)) with (((g z - g x) / (z - x) - l) * (z - x)) by (field; lra).
  rewrite Rabs_mult; apply Rmult_lt_compat_r; [apply Rabs_pos_lt; lra | exact Hd].
Qed.
Lemma on_glue lo mid hi f x l : (x <= mid -> on lo mid f x l) -> (mid <= x -> on mid hi f x l) -> on lo hi f x l.
Proof.
  intros A B eps He; destruct (Rtotal_order x mid) as [L|[E|L]].
  - destruct (A ltac:(lra) eps He) as (d & Hd & H), (two_least d (mid - x) Hd ltac:(lra)) as (d' & Hd' & L1 & L2).
    exists d'; split; [exact Hd'|]; intros z Hz Hzx; pose proof (Rabs_def2 _ _ Hzx); apply H; lra.
  - destruct (A ltac:(lra) eps He) as (d1 & Hd1 & H1), (B ltac:(lra) eps He) as (d2 & Hd2 & H2), (two_least d1 d2 Hd1
      Hd2) as (d & Hd & L1 & L2). exists d; split; [exact Hd|]; intros z Hz Hzx; destruct (Rle_dec z mid); [apply H1 |
      apply H2]; lra.
  - destruct (B ltac:(lra) eps He) as (d & Hd & H), (two_least d (x - mid) Hd ltac:(lra)) as (d' & Hd' & L1 & L2).
    exists d'; split; [exact Hd'|]; intros z Hz Hzx; pose proof (Rabs_def2 _ _ Hzx); apply H; lra.
Qed.
Definition beyond (lo hi : R) (f f1 : R -> R) (x : R) : R := if Rle_dec x lo then f lo + f1 lo * (x - lo) else
  if Rle_dec x hi then f x else f hi + f1 hi * (x - hi).
Lemma beyond_from lo hi f f1 : beyond lo hi f f1 lo = f lo.
Proof. unfold beyond; destruct (Rle_dec lo lo); [ring | lra]. Qed.
Lemma beyond_in lo hi f f1 x : lo <= x <= hi -> beyond lo hi f f1 x = f x.
Proof.
  intros Hx; unfold beyond; destruct (Rle_dec x lo); [replace x with lo by lra; ring|]; destruct (Rle_dec x hi); lra.
Qed.
Lemma beyond_D lo hi f f1 x : lo <= x <= hi -> on lo hi f x (f1 x) -> derivable_pt_lim (beyond lo hi f f1) x (f1 x).
Proof.
  intros Hx H eps He; destruct (H (eps / 2) ltac:(lra)) as (d & Hd & D).
  destruct (two_least d (if Rlt_dec lo x then x - lo else 1) Hd ltac:(destruct (Rlt_dec lo x); lra)) as (d1 & H1 & A1 &
    A2).
  destruct (two_least d1 (if Rlt_dec x hi then hi - x else 1) H1 ltac:(destruct (Rlt_dec x hi); lra)) as (d2 & H2 & A3 &
    A4). exists (mkposreal d2 H2); intros h Nh Hh; cbn in Hh; pose proof (Rabs_def2 _ _ Hh); rewrite (beyond_in _ _ _ _
    x Hx).
  assert (B : Rabs (beyond lo hi f f1 (x + h) - f x - f1 x * h) <= eps / 2 * Rabs h).
  { unfold beyond; destruct (Rle_dec (x + h) lo) as [L|L].
    - destruct (Rlt_dec lo x); [lra|]; replace x with lo by lra; match goal with |- Rabs ?g <= _ => replace g with 0 by
        ring end. rewrite Rabs_R0; apply Rmult_le_pos; [lra | apply Rabs_pos].
    - destruct (Rle_dec (x + h) hi) as [U|U].
      + specialize (D (x + h) ltac:(lra)); replace (x + h - x) with h in D by ring; apply D; lra.
      + destruct (Rlt_dec x hi); [lra|]; replace x with hi by lra; match goal with |- Rabs ?g <= _ => replace g with 0
          by ring end. rewrite Rabs_R0; apply Rmult_le_pos; [lra | apply Rabs_pos]. }
  pose proof (Rabs_pos_lt h Nh); replace ((beyond lo hi f f1 (x + h) - f x) / h - f1 x) with ((beyond lo hi f f1 (x + h)
    - f x - f1 x * h) / h) by (field; exact Nh).
  unfold Rdiv; rewrite Rabs_mult, Rabs_inv; apply (Rmult_lt_reg_r (Rabs h)); [assumption|]; rewrite Rmult_assoc, Rinv_l
    by lra. assert (0 < eps * Rabs h) by (apply Rmult_lt_0_compat; lra); lra.
Qed.

(** ** Motions: legs cut at the ends of periods, and joined there *)
Section Motions.
Variable O : Nonlinear.t.
Hypothesis HO : grazing_orbit O.
Notation T := (Nonlinear.T O).
Notation tG := (Nonlinear.tG O).
Notation y0 := (Nonlinear.y0 O).
Variables (mu d : R).
Hypothesis Hd : d < tG /\ d < T - tG /\ d < y0 0.
Lemma bounces_of D N t y v i j : d <= D -> (N i < N j)%Z -> Rabs (t j - (tG + T * IZR (N j))) <= d -> leg O mu d N t y v
  i j -> bounces (cut O) mu D N t y v i j.
Proof.
  intros HD HN Nj [L1 L2 L3 L4 L5 L6 L7 L8 L9]; destruct (period O HO) as (HT & _); set (n := others (cut O) N i j).
  assert (En : Z.of_nat n = (N j - N i)%Z) by (unfold n, others; cbn [Bouncing.k cut]; lia).
  set (r := fun m => if Nat.eqb m 0 then t i else if Nat.leb m n then T * IZR (N i + Z.of_nat m) else t j).
  assert (R0 : r 0%nat = t i) by reflexivity; assert (RS : r (S n) = t j) by (unfold r; cbn [Nat.eqb]; destruct
    (Nat.leb_spec (S n) n); [lia | reflexivity]).
  assert (Rm : forall m, (1 <= m <= n)%nat -> r m = T * IZR (N i + Z.of_nat m)) by (intros m Hm; unfold r; destruct
    (Nat.eqb_spec m 0), (Nat.leb_spec m n); try lia; reflexivity).
  apply le_abs in L2, Nj; assert (Up : forall m, (m <= n)%nat -> r m < r (S m)).
  { intros m Hm; assert (P1 : r m <= T * IZR (N i + Z.of_nat m) + (if Nat.eqb m 0 then tG + d else 0)).
    { destruct (Nat.eqb_spec m 0) as [->|]; [rewrite R0, Z.add_0_r; lra | rewrite Rm by lia; lra]. }
    assert (P2 : T * IZR (N i + Z.of_nat m) + (if Nat.eqb m n then tG - d else T) <= r (S m)).
    { destruct (Nat.eqb_spec m n) as [->|]; [rewrite RS, En; replace (N i + (N j - N i))%Z with (N j) by ring; lra|].
      rewrite Rm by lia; replace (N i + Z.of_nat (S m))%Z with ((N i + Z.of_nat m) + 1)%Z by lia; rewrite (plus_IZR (N i
        + Z.of_nat m)); lra. }
    destruct (Nat.eqb_spec m 0), (Nat.eqb_spec m n); try lia; lra. }
  assert (In : forall m, (m <= S n)%nat -> t i <= r m <= t j).
  { assert (Lo : forall m, (m <= S n)%nat -> r 0%nat <= r m) by (induction m as [|m IH]; intros Hm; [lra|]; specialize
      (IH ltac:(lia)); specialize (Up m ltac:(lia)); lra).
    assert (Hi : forall k, (k <= S n)%nat -> r (S n - k)%nat <= r (S n)) by (induction k as [|k IH]; intros Hk; [rewrite
      Nat.sub_0_r; lra|]; specialize (IH ltac:(lia)); specialize (Up (S n - S k)%nat ltac:(lia)); replace (S (S n - S
      k)) with (S n - k)%nat in Up by lia; lra).
    intros m Hm; specialize (Lo m Hm); specialize (Hi (S n - m)%nat ltac:(lia)); replace (S n - (S n - m))%nat with m in
      Hi by lia; lra. }
  assert (Sub : forall m x, (m <= n)%nat -> r m <= x <= r (S m) -> t i <= x <= t j) by (intros m x Hm Hx; pose proof (In
    m ltac:(lia)); pose proof (In (S m) ltac:(lia)); lra).
  exists r, (fun _ => y i), (fun _ => v i); fold n; constructor; auto.
  - intros l [-> | ->]; cbn [Bouncing.tG Bouncing.T cut]; apply Rabs_le; lra.
  - intros m Hm; unfold StatementBouncing.arc; cbn [Bouncing.s Bouncing.k cut]; rewrite Rm by lia; change (Z.of_nat 1)
      with 1%Z; rewrite Z.mul_1_l, Rminus_eq_0, Rabs_R0. apply Rle_trans with (2 := HD); lra.
  - intros m Hm; cbn [Bouncing.impact cut]; unfold StatementBouncing.arc; cbn [Bouncing.s Bouncing.k cut]; change
      (Z.of_nat 1) with 1%Z; rewrite Z.mul_1_l; apply Rm; lia.
  - intros m x Hm Hx; exact (L3 x (Sub m x Hm Hx)).
  - intros m x Hm Hx; destruct (L4 x (Sub m x Hm Hx)); cbn [Bouncing.y0 Bouncing.v0 cut]; split; lra.
  - intros m x Hm Hx; apply L7; pose proof (In m ltac:(lia)); pose proof (In (S m) ltac:(lia)); lra.
  - intros m Hm; unfold follows; cbn; split; ring.
Qed.

(** They go on beyond their ends. *)
Definition longer (t : Z -> R) (y v : Z -> R -> R) (i : Z) : R -> R := beyond (t i) (t (i + 1)%Z) (y i) (v i).
Definition longer1 (t : Z -> R) (y v : Z -> R -> R) (i : Z) : R -> R := beyond (t i) (t (i + 1)%Z) (v i) (fun x =>
  Nonlinear.a O x (y i x) (v i x) mu).
Lemma leg_of N t y v i j : j = (i + 1)%Z -> bounces (cut O) mu d N t y v i j -> leg O mu d N t (longer t y v) (longer1 t
  y v) i j.
Proof.
  intros Hj (r & p & q & [[J1 J1'] (J2 & J2' & J2'') J3 J4 J5 J6 J7 J8 J9 J10 J11 J12]); set (n := others (cut O) N i j)
    in *. assert (Mono : forall m, (m <= S n)%nat -> r 0%nat <= r m) by (induction m as [|m IH]; intros Hm; [lra|];
    specialize (IH ltac:(lia)); specialize (J5 m ltac:(lia)); lra).
  assert (Is : forall m x, (m <= n)%nat -> r m <= x <= r (S m) -> y i x = p m x /\ v i x = q m x).
  { intros m x Hm Hx; destruct (Req_dec x (r (S m))) as [E|E]; [|apply J11; trivial; intros; contradiction].
    destruct (Nat.eq_dec m n) as [->|Nm]; [apply J11; auto|]; pose proof (J5 (S m) ltac:(lia)); destruct (J10 m
      ltac:(lia)) as [B1 B2]; cbn in B1, B2; rewrite <- E in B1, B2; destruct (J11 (S m) x ltac:(lia)) as [-> ->]; [lra
      | lra |].
    rewrite B1, B2; split; ring. }
  assert (Dv : forall m, (m <= n)%nat -> forall x, r 0%nat <= x <= r (S m) -> on (r 0%nat) (r (S m)) (y i) x (v i x) /\
    on (r 0%nat) (r (S m)) (v i) x (Nonlinear.a O x (y i x) (v i x) mu)).
  { assert (Piece : forall m x, (m <= n)%nat -> r m <= x <= r (S m) -> on (r m) (r (S m)) (y i) x (v i x) /\ on (r m) (r
      (S m)) (v i) x (Nonlinear.a O x (y i x) (v i x) mu)).
    { intros m x Hm Hx; destruct (J7 m x Hm Hx) as [D1 D2]; cbn [Bouncing.a cut] in D2; destruct (Is m x Hm Hx) as [E1
      E2]. split; [apply on_D with (p m) | apply on_D with (q m)]; trivial; try (intros z Hz; apply (Is m z Hm Hz));
        rewrite ?E1, ?E2; assumption. }
    induction m as [|m IH]; intros Hm x Hx; [apply Piece; [lia | exact Hx]|].
    split; apply on_glue with (r (S m)); intros Hx'; (apply IH || apply Piece); try lia; lra. }
  specialize (Dv n (le_n n)); rewrite J1, J2 in Dv; assert (Lt : t i < t j) by (rewrite <- J1, <- J2; pose proof (J5
    0%nat ltac:(lia)); assert (r 1%nat <= r (S n)); [|lra]; assert (G : forall m, (m <= n)%nat -> r 1%nat <= r (S m)) by
    (induction m as [|m IH]; intros Hm; [lra|]; specialize (IH ltac:(lia)); specialize (J5 (S m) ltac:(lia)); lra);
    apply G; lia).
  assert (Find : forall x, t i <= x <= t j -> exists m, (m <= n)%nat /\ r m <= x <= r (S m)).
  { intros x Hx; assert (G : forall m, (m <= n)%nat -> r 0%nat <= x <= r (S m) -> exists k, (k <= m)%nat /\ r k <= x <=
      r (S k)) by (induction m as [|m IH]; intros Hm Hx'; [exists 0%nat; split; [lia | exact Hx']|]; destruct (Rle_dec x
      (r (S m))); [destruct (IH ltac:(lia) ltac:(lra)) as (k & Hk & K); exists k; split; [lia | exact K] | exists (S m);
      split; [lia | lra]]).
    apply (G n (le_n n)); lra. }
  subst j; set (j := (i + 1)%Z) in *.
  assert (Ey : forall x, t i <= x <= t j -> longer t y v i x = y i x /\ longer1 t y v i x = v i x) by (intros x Hx;
    split; apply beyond_in, Hx).
  assert (Tube : forall x, t i <= x <= t j -> tube O d x (y i x) (v i x)).
  { intros x Hx; destruct (Find x Hx) as (m & Hm & Hr); destruct (Is m x Hm Hr) as [-> ->]; exact (J8 m x Hm Hr). }
  constructor; trivial.
  - apply (J3 i); auto.
  - intros x Hx; destruct (Ey x Hx) as [E1 E2], (Dv x Hx) as [D1 D2]; unfold moves; rewrite E1, E2; split; apply
      beyond_D with (f1 := v i) || (apply (beyond_D _ _ _ (fun x => Nonlinear.a O x (y i x) (v i x) mu))); assumption.
  - intros x Hx; destruct (Ey x Hx) as [-> ->]; apply Tube, Hx.
  - rewrite (proj1 (Ey (t i) ltac:(lra))), <- J1' at 1; apply (Is 0%nat); [lia|]; rewrite <- J1; pose proof (J5 0%nat
      ltac:(lia)); lra.
  - rewrite (proj1 (Ey (t j) ltac:(lra))), <- J2' at 1; apply (Is n); [lia|]; rewrite J2; pose proof (J5 n ltac:(lia));
    lra.
  - intros x Hx; rewrite (proj1 (Ey x ltac:(lra))); destruct (Find x ltac:(lra)) as (m & Hm & Hr).
    assert (At : forall c, x = T * IZR c -> 0 < y i x).
    { intros c E; destruct (Tube x ltac:(lra)) as [B _]; rewrite E, (proj1 (at_cut O HO c)), <- E in B; apply le_abs in
        B; lra. }
    destruct (Req_dec x (r m)) as [E|E]; [|destruct (Req_dec x (r (S m))) as [E'|E']].
    + destruct m as [|m]; [lra|]; specialize (J6 m ltac:(lia)); cbn [Bouncing.impact Bouncing.s cut] in J6; apply (At _
        (eq_trans E J6)).
    + destruct (Nat.eq_dec m n) as [->|Nm]; [lra|]; specialize (J6 m ltac:(lia)); cbn [Bouncing.impact Bouncing.s cut]
        in J6; apply (At _ (eq_trans E' J6)).
    + rewrite (proj1 (Is m x Hm Hr)); apply (J9 m x Hm); lra.
  - rewrite (proj2 (Ey (t j) ltac:(lra))); destruct (Is n (t j) (le_n n)) as [_ ->]; [rewrite J2; pose proof (J5 n
      ltac:(lia)); lra | exact J2''].
  - unfold longer1 at 1; rewrite beyond_from, (proj2 (Ey (t j) ltac:(lra))); exact J12.
Qed.
End Motions.

Theorem nonlinear O a1 a2 gamma rate : grazing_orbit O -> generic O a1 a2 gamma rate -> decided O a1 a2 gamma rate.
Proof.
  intros HO HG n_max; destruct (bouncing (cut O) a1 a2 gamma rate (cut_orbit O HO) (cut_generic O HO a1 a2 gamma rate
    HG) n_max) as (d1 & Hd1 & H); destruct (touches O HO) as [HtG _], (at_cut O HO 0) as (_ & _ & Y0).
  destruct (two_least (Nonlinear.tG O / 2) ((Nonlinear.T O - Nonlinear.tG O) / 2)) as (a & Ha & A1 & A2); try lra.
  destruct (two_least a (Nonlinear.y0 O 0 / 2) Ha ltac:(lra)) as (b & Hb & A3 & A4), (two_least d1 b Hd1 Hb) as (d & Hd
    & A5 & A6). exists d; split; [exact Hd|]; intros eps Heps; destruct (H eps ltac:(lra)) as (mu0 & Hm & W).
  exists mu0; split; [exact Hm|]; intros n N e g mu Hn HN Hg Hmu; destruct (W n N e g mu Hn HN Hg Hmu) as [Ex No].
  assert (To : forall r D t y v, r <= d -> r <= D -> nonlinear_motion O mu r N t y v -> bouncing_motion (cut O) mu D N t
    y v).
  { intros r D t y v Hr HD HM i j Hj; apply (bounces_of O HO mu r); [repeat split; lra | exact HD | rewrite Hj, HN;
      destruct (Hn i); lia | exact (leg_near _ _ _ _ _ _ _ _ _ (HM j _ eq_refl)) | apply HM, Hj]. }
  assert (From : forall t y v i, bounces (cut O) mu eps N t y v i (i + 1) -> leg O mu eps N t (longer t y v) (longer1 O
    mu t y v) i (i + 1)) by (intros t y v i B; apply (leg_of O HO mu eps); [repeat split; lra | reflexivity | exact B]).
  split; [|intros Hbr t y v HM; apply (No Hbr t y v), (To d); trivial; lra].
  intros All; destruct (Ex All) as [(t & y & v & HM & Only) Un]; split.
  - exists t, (longer t y v), (longer1 O mu t y v); split; [intros i j ->; apply From, HM; reflexivity|].
    intros t' y' v' HM' i; destruct (Only t' y' v' (To eps eps t' y' v' ltac:(lra) (Rle_refl _) HM') i) as [E F].
    split; [exact E|]; intros x Hx; unfold longer, longer1; rewrite !beyond_in by exact Hx; apply F, Hx.
  - intros t' y' v' HM'; destruct (Un t' y' v' (To eps eps t' y' v' ltac:(lra) (Rle_refl _) HM')) as (r & Hr & F).
    exists r; split; [exact Hr|]; intros j ep Hep; destruct (F j ep Hep) as (l & t2 & y2 & v2 & Hl & Lg & N1 & N2).
    exists l, t2, (longer t2 y2 v2), (longer1 O mu t2 y2 v2); split; [exact Hl|]; split; [intros i Hi; apply From, Lg,
      Hi|].
    unfold near, longer1 in *; rewrite !beyond_from; auto.
Qed.
