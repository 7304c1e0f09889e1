(** * Whatever certificate of kind attractor the check takes is true *)
From Coq Require Import Reals QArith Qreals ZArith Lra Lia Bool List.
From Grazing Require Import Derivatives ChaosInterval ChaosFunctions PathsCheck PathsFlow PathsLegs PathsChecked.
From Grazing Require Import StatementOscillator StatementTrapped TrappedFlow TrappedRange.
From Grazing Require Import StatementPaths StatementTraps TrapsNumbers TrapsCheck.
Import ListNotations.
Open Scope R_scope.

(** ** A1: such a wall is a hump *)
Section Wall.
Variables (M : Machine.t) (nu lo hi l h : R).
Notation g := (g M).
Notation g1 := (g1 M).
Hypothesis Top : g 0 = 1 /\ g1 0 = 0.
Hypothesis Order : l <= lo /\ lo < 0 < hi /\ hi <= h /\ h <= l + 2 * PI.
Hypothesis Bent : forall t, l <= t <= h -> 0 < PathsFlow.bend M t.
Hypothesis Ends : g lo <= 1 - nu /\ g hi <= 1 - nu.
Hypothesis Outside : forall t, h < t < l + 2 * PI -> g t < 1 - nu.
Hypothesis Nu : 0 < nu.
Lemma slope_sign t : (0 < t <= h -> g1 t < 0) /\ (l <= t < 0 -> 0 < g1 t).
Proof.
  split; intros Ht; [destruct (MVT_cor2 g1 (fun t => - PathsFlow.bend M t) 0 t) as (c & E & Hc) | destruct (MVT_cor2 g1
    (fun t => - PathsFlow.bend M t) t 0) as (c & E & Hc)]; try lra; try (intros; apply D_g1); specialize (Bent c
    ltac:(lra)); nra.
Qed.
Lemma falls_right s t : 0 <= s < t -> t <= h -> g t < g s.
Proof.
  intros H1 H2; destruct (MVT_cor2 g g1 s t) as (c & E & Hc); [lra | intros; apply D_g|]; pose proof (proj1 (slope_sign
    c) ltac:(lra)); nra.
Qed.
Lemma falls_left s t : s < t <= 0 -> l <= s -> g s < g t.
Proof.
  intros H1 H2; destruct (MVT_cor2 g g1 s t) as (c & E & Hc); [lra | intros; apply D_g|]; pose proof (proj2 (slope_sign
    c) ltac:(lra)); nra.
Qed.
Lemma g_period t : g (t + 2 * PI) = g t.
Proof. rewrite <- (proj1 (g_turned M 1 t)); f_equal; ring. Qed.
Lemma lower t : hi < t < lo + 2 * PI -> g t < 1 - nu.
Proof.
  intros Ht; destruct (Rle_or_lt t h) as [L|L]; [pose proof (falls_right hi t ltac:(lra) L); lra|].
  destruct (Rlt_or_le t (l + 2 * PI)) as [L'|L']; [apply Outside; lra|].
  replace t with (t - 2 * PI + 2 * PI) by ring; rewrite g_period; pose proof (falls_left (t - 2 * PI) lo ltac:(lra)
    ltac:(lra)); lra.
Qed.
Lemma at_most t : g t <= 1.
Proof.
  pose proof PI_RGT_0; set (z := (Rdefinitions.up ((t - l) / (2 * PI)) - 1)%Z); set (x := t - 2 * PI * IZR z).
  assert (Hx : l <= x <= l + 2 * PI).
  { destruct (archimed ((t - l) / (2 * PI))) as [A B]; assert (E : (t - l) / (2 * PI) * (2 * PI) = t - l) by (field;
    lra); unfold x, z; rewrite minus_IZR; split; [apply (Rmult_le_compat_r (2 * PI)) in B | apply (Rmult_lt_compat_r (2
    * PI)) in A]; lra. }
  replace t with (2 * PI * IZR z + x) by (unfold x; ring); rewrite (proj1 (g_turned M z x)).
  destruct (Rle_or_lt x h) as [L|L].
  - destruct (Rtotal_order x 0) as [N|[->|N]]; [pose proof (falls_left x 0); lra | lra | pose proof (falls_right 0 x);
    lra].
  - destruct (Req_dec x (l + 2 * PI)) as [->|N]; [|pose proof (Outside x ltac:(lra)); lra].
    rewrite g_period; pose proof (falls_left l 0); lra.
Qed.
End Wall.

Section Check.
Variables (X : Trap.t) (M : Machine.t).
Hypothesis HX : check_trap X = true.
Hypothesis HM : covers_trap X M.
Notation nu := (Machine.nu M).
Notation c := (Machine.c M).
Notation k := (Machine.k M).
Notation U := (Q2R (fst (Trap.window X))).
Notation V := (Q2R (snd (Trap.window X))).
Notation al := (Q2R (fst (Trap.bends X))).
Notation al' := (Q2R (snd (Trap.bends X))).
Notation mu0 := (Q2R (Trap.depth X)).
Let r := sqrt (c * c - 4 * k).

Lemma in_wall : in_cell (wall_cell X) M 1 0.
Proof.
  constructor; try exact I; cbn; pose proof (trap_harmonics _ _ HM) as L; unfold rangings.
  induction L as [|(i & A & B) (j & a & b) HI HR (E & HA & HB) _ IH]; cbn [map]; constructor; [|exact IH].
  split; [exact E | split; [apply mem_ranging, HA | apply mem_ranging, HB]].
Qed.
(** The ends of a window. *)
Lemma mem_sin_small Y y : 0 <= y <= 1 -> mem Y y -> mem (sin_small Y) (sin y).
Proof.
  intros Hy HY; pose proof PI_RGT_0; pose proof PI2_3_2; destruct (SIN y ltac:(lra) ltac:(lra)) as [L G].
  unfold sin_small; cbv zeta; set (st := fun q x => 1 - y * y * (1 / q) * x).
  set (lw := y * st 6 (st 20 (st 42 1))); set (up := y * st 6 (st 20 (st 42 (st 72 1)))).
  assert (F : INR (fact 1) = 1 /\ INR (fact 3) = 6 /\ INR (fact 5) = 120 /\ INR (fact 7) = 5040 /\ INR (fact 9) =
    362880).
  { assert (F5 : INR (fact 5) = 120) by (cbn; ring); rewrite (fact_simpl 8), (fact_simpl 7), (fact_simpl 6), (fact_simpl
    5), !mult_INR, F5; rewrite !S_INR; cbn [INR fact]; repeat split; cbn; ring. }
  destruct F as (F1 & F3 & F5 & F7 & F9).
  assert (El : sin_lb y = lw /\ sin_ub y = up).
  { unfold sin_lb, sin_ub, sin_approx; cbn [sum_f_R0]; unfold sin_term; cbn [Nat.mul Nat.add]; rewrite F1, F3, F5, F7,
    F9; unfold lw, up, st; split; field. }
  destruct El as [El Eu].
  assert (St : forall q A a, mem A a -> mem (minus unit (times (times (times Y Y) (constant 1 q)) A)) (st (IZR (Z.pos
    q)) a)).
  { intros q A a HA; pose proof (mem_constant 1 q); unfold st; enc. }
  apply (mem_join _ _ lw up); [apply mem_times; [exact HY|]; repeat apply St; exact mem_1 | apply mem_times; [exact
    HY|]; repeat apply St; exact mem_1 | lra].
Qed.
Lemma low_end after q : low_at X after (fraction q) = true -> g M (if after then Q2R q else - Q2R q) <= 1 - mu0.
Proof.
  intros H; unfold low_at in H; cbv zeta in H; apply orb_prop in H; pose proof (mem_fraction q) as Mq; pose proof
    (mem_fraction (Trap.depth X)) as Mn; set (y := Q2R q) in *; destruct H as [H|H].
  - assert (My : mem (if after then fraction q else opp (fraction q)) (if after then y else - y)) by (destruct after;
    [exact Mq | apply mem_opp, Mq]). pose proof (mem_gI _ _ _ _ in_wall _ _ My); assert (mu0 <= 1 - g M (if after then y
    else - y)) by (apply (below_le _ _ _ _ H); enc); lra.
  - apply andb_prop in H; destruct H as [H1 H2]; set (f := fun h : BinNums.positive * (R * R) => let '(j, (a, b)) := h
    in a * (1 - cos (IZR (Z.pos j) * y)) - (if after then b * sin (IZR (Z.pos j) * y) else - (b * sin (IZR (Z.pos j) *
    y)))).
    assert (E : over_harmonics f (Machine.harmonics M) = 1 - g M (if after then y else - y)).
    { rewrite <- (trap_top _ _ HM); unfold g; induction (Machine.harmonics M) as [|(j & a & b) L IH]; cbn
      [over_harmonics]; [ring|]; rewrite IH; unfold f at 1; rewrite Rmult_0_r, cos_0, sin_0; destruct after; [ring|].
      replace (IZR (Z.pos j) * - y) with (- (IZR (Z.pos j) * y)) by ring; rewrite cos_neg, sin_neg; ring. }
    assert (Md : mem (drop_at X after (fraction q)) (over_harmonics f (Machine.harmonics M))).
    { unfold drop_at; pose proof (in_H _ _ _ _ in_wall) as L; clear E H2; induction L as [|(i & A & B) (j & a & b) HI HR
      (<- & HA & HB) _ IH]; cbn [totalI over_harmonics]; [exact mem_zero|]; cbn [forallb fst] in H1; rewrite
      !andb_true_iff in H1; destruct H1 as [[P1 P2] H1]. pose proof (mem_scaled i _ _ Mq) as Ms; pose proof (positive_lt
      _ _ P1 Ms); pose proof (below_le _ _ _ _ P2 Ms mem_1); apply mem_plus; [|apply IH, H1]; unfold f; cbv zeta.
      apply mem_minus; [apply mem_times; [exact HA | apply mem_minus; [exact mem_1 | apply mem_cos_small; [lra | exact
        Ms]]]|].
      destruct after; [|apply mem_opp]; (apply mem_times; [exact HB | apply mem_sin_small; [lra | exact Ms]]). }
    pose proof (below_le _ _ _ _ H2 Mn Md); lra.
Qed.
Lemma roots : 0 < c /\ 0 < k /\ 0 < c * c - 4 * k /\ 0 < r /\ r * r = c * c - 4 * k /\ 0 < (c - r) / 2 < (c + r) / 2 /\
  (c - r) / 2 * ((c + r) / 2) = k /\ mem (aI (inputs_of X)) ((c - r) / 2) /\ mem (bI (inputs_of X)) ((c + r) / 2) /\
  mem (dI (inputs_of X)) ((c + r) / 2 - (c - r) / 2).
Proof.
  pose proof HX as H; unfold check_trap in H; cbv zeta in H; rewrite !andb_true_iff in H; destruct H as [[[[[[[_ H] _]
    _] _] _] _] _].
  unfold overdamped_all in H; cbv zeta in H; rewrite !andb_true_iff in H; destruct H as [[H1 H2] H3].
  pose proof (mem_ranging _ _ (trap_c _ _ HM)) as Mc; pose proof (mem_ranging _ _ (trap_k _ _ HM)) as Mk.
  pose proof (mem_integer 4) as M4; pose proof mem_half as Mh; pose proof (positive_lt _ _ H1 Mc) as C0; pose proof
    (positive_lt _ _ H2 Mk) as K0.
  assert (D0 : 0 < c * c - 4 * k) by (apply (positive_lt _ _ H3); enc); assert (rr : r * r = c * c - 4 * k) by (apply
    sqrt_sqrt; lra). assert (r0 : 0 < r) by (apply sqrt_lt_R0, D0); assert (rc : r < c) by nra.
  assert (Ek : (c - r) / 2 * ((c + r) / 2) = k) by (replace k with ((c * c - r * r) / 4) by lra; field).
  assert (Md : mem (dI (inputs_of X)) r) by (unfold inputs_of, r; cbn [dI]; enc).
  assert (Mb : mem (bI (inputs_of X)) ((c + r) / 2)) by (unfold inputs_of in *; cbn [dI bI] in *; replace ((c + r) / 2)
    with (1 / 2 * (c + r)) by field; enc).
  repeat (split; [first [assumption | lra]|]); split; [|split; [exact Mb|]].
  - unfold inputs_of in *; cbn [aI bI] in *; replace ((c - r) / 2) with (k / ((c + r) / 2)) by (rewrite <- Ek at 1;
    field; lra). apply mem_quo; [exact Mk | exact Mb].
  - replace ((c + r) / 2 - (c - r) / 2) with r by field; exact Md.
Qed.
Notation T lo hi := (seen X M (hi - lo)).

(** The wall of this depth. *)
Lemma wall_hump : 0 <= Machine.tau M -> exists lo hi, - U <= lo /\ hi <= V /\ lo < 0 < hi /\
  (hi - lo < 2 * PI -> 0 < al -> hump (T lo hi) lo hi).
Proof.
  intros Tau; destruct roots as (_ & _ & _ & _ & _ & Hab & _); destruct (trap_nu _ _ HM) as [N0 N1].
  pose proof (conj (trap_top _ _ HM) (trap_level _ _ HM)) as Top; pose proof in_wall as IW; pose proof PI_RGT_0 as Pp.
  assert (Hump : forall lo hi l h, l <= lo /\ lo < 0 < hi /\ hi <= h /\ h <= l + 2 * PI -> (forall t, l <= t <= h -> 0 <
    PathsFlow.bend M t) -> g M lo <= 1 - nu /\ g M hi <= 1 - nu -> (forall t, h < t < l + 2 * PI -> g M t < 1 - nu) ->
    (forall t, lo <= t <= hi -> al <= PathsFlow.bend M t <= al') -> hi - lo < 2 * PI -> 0 < al -> hump (T lo hi) lo hi).
  { intros lo hi l h O B E Out Bd Nr Al; assert (Ew : forall t, wall M t = nu - 1 + g M t) by (intros t; unfold wall;
    rewrite (trap_sigma _ _ HM); ring).
    constructor; cbn [a b StatementTrapped.tau p StatementTrapped.W mu al0 al1 StatementTrapped.Q Q1 Q2 seen]; fold r;
      trivial; try lra.
    - intros t; rewrite !Ew, g_period; reflexivity.
    - intros t; apply (D_ext (fun t => nu - 1 + g M t) _ _ (0 + g1 M t)); [apply D_plus; [apply D_const | apply D_g] |
      intros; symmetry; apply Ew | ring].
    - intros t; exact (D_g1 M t).
    - intros t Ht; rewrite Ew; pose proof (lower M nu lo hi l h Top O B E Out t Ht); lra.
    - intros t Ht; change (g2 M t) with (- PathsFlow.bend M t); rewrite Ropp_involutive; apply Bd, Ht.
    - intros t; rewrite Ew; pose proof (at_most M nu lo hi l h Top O B Out N0 t); lra.
    - exists 0; rewrite Ew, (proj1 Top); ring. }
  pose proof HX as H; unfold check_trap in H; cbv zeta in H; rewrite !andb_true_iff in H; destruct H as [[[[[[[H _] _]
    _] _] _] _] _].
  destruct (Trap.concave X) as [(u', v')|].
  - unfold several_hold in H; cbv beta zeta in H; rewrite !andb_true_iff in H; cbn [fst snd] in H.
    destruct H as [[[[[[[[[[_ U0] V0] UU] VV] Nr] E1] E2] Bn] Out] Bd].
    apply less_lt in U0, V0; rewrite Q2R_0 in U0, V0; apply Qle_bool_iff, Qle_Rle in UU, VV.
    pose proof (mem_fraction u') as Mu; pose proof (mem_fraction v') as Mv; pose proof (mem_fraction (fst (Trap.window
      X))) as MU; pose proof (mem_fraction (snd (Trap.window X))) as MV; pose proof (mem_fraction (Trap.depth X)) as Mn.
    assert (Piece : forall f x y L H t, pieces_of f L H = true -> mem L x -> mem H y -> x <= t <= y -> exists Y, f Y =
      true /\ mem Y t) by (intros f x y L H t Hf HL HH Ht; exact (cover_one _ _ _ _ Hf (mem_join _ _ _ _ _ HL HH Ht))).
    assert (Mh : mem (plus (opp (fraction u')) turn_1) (- Q2R u' + 2 * PI)) by (apply mem_plus; [apply mem_opp, Mu |
      exact mem_turn_1]). pose proof (below_le _ _ _ _ Nr Mv Mh) as Nr'.
    exists (- U), V; split; [lra|]; split; [lra|]; split; [lra|]; apply (Hump _ _ (- Q2R u') (Q2R v')); [lra | | | |].
    + intros t Ht; destruct (Piece _ _ _ _ _ t Bn (mem_opp _ _ Mu) Mv Ht) as (Y & P & MY); exact (positive_lt _ _ P
      (mem_bendI _ _ _ _ IW _ _ MY)).
    + pose proof (low_end false _ E1); pose proof (low_end true _ E2); cbv iota in *; lra.
    + intros t Ht; destruct (Piece _ _ _ _ _ t Out Mv Mh ltac:(lra)) as (Y & P & MY); pose proof (mem_gI _ _ _ _ IW _ _
      MY); assert (0 < 1 - g M t - mu0) by (apply (positive_lt _ _ P); enc); lra.
    + intros t Ht; destruct (Piece _ _ _ _ _ t Bd (mem_opp _ _ MU) MV Ht) as (Y & P & MY); cbv zeta in P; apply
      andb_prop in P; destruct P as [P1 P2]; pose proof (mem_bendI _ _ _ _ IW _ _ MY) as MB; split; [apply (below_le _ _
      _ _ P1) | apply (below_le _ _ _ _ P2)]; trivial; apply mem_fraction.
  - unfold cosine_holds in H; cbv beta zeta in H; rewrite !andb_true_iff in H.
    destruct H as [[[[[[[Ic N2] [F1 F2]] [F3 F4]] U0] V0] A0] A1]; apply less_lt in N2, U0, V0.
    rewrite Q2R_0 in U0, V0; rewrite Q2R_1 in N2; apply Qle_bool_iff, Qle_Rle in A0, A1; rewrite Q2R_1 in A1.
    rewrite Q2R_minus, Q2R_1 in A0; assert (Cs : forall t, g M t = cos t /\ PathsFlow.bend M t = cos t).
    { pose proof (trap_harmonics _ _ HM) as L; unfold is_cosine in Ic; destruct (Trap.harmonics X) as [|(j & (A & A') &
      (B & B')) [|]]; try discriminate; destruct j; try discriminate; rewrite !andb_true_iff in Ic; destruct Ic as [[[I1
      I2] I3] I4]. inversion L as [|y h l' l'' R L' E1 E2]; subst y l'; destruct h as (j & x & z), R as (Ej & Ha & Hb);
      inversion L'; subst l'' j; unfold g, PathsFlow.bend; rewrite <- E2; cbn [over_harmonics].
      apply Qeq_bool_iff, Qeq_eqR in I1, I2, I3, I4; unfold in_interval in Ha, Hb; cbn [fst snd] in Ha, Hb; rewrite I1,
        I2, Q2R_1 in Ha; rewrite I3, I4, Q2R_0 in Hb; replace x with 1 by lra; replace z with 0 by lra.
      intros t; rewrite !(Rmult_1_l t); change (1 * 1)%Z with 1%Z; split; ring. }
    set (w := acos (1 - nu)); assert (Cw : cos w = 1 - nu) by (apply cos_acos; lra); destruct (acos_bound (1 - nu)) as
      [w0 w1]; fold w in w0, w1. assert (w2 : 0 < w) by (destruct (Req_dec w 0) as [E|E]; [rewrite E, cos_0 in Cw; lra |
      lra]).
    assert (w3 : w < PI) by (destruct (Req_dec w PI) as [E|E]; [rewrite E, cos_PI in Cw; lra | lra]).
    assert (Far : forall q, 0 < Q2R q -> ChaosInterval.below (fraction q) pi = true -> ChaosInterval.below (cosine
      (fraction q)) (minus unit (fraction (Trap.depth X))) = true -> w <= Q2R q).
    { intros q q0 B1 B2; pose proof (mem_fraction q) as Mq; pose proof (mem_fraction (Trap.depth X)) as Mn; pose proof
      (below_le _ _ _ _ B1 Mq mem_pi) as q1. assert (B : cos (Q2R q) <= 1 - mu0) by (apply (below_le _ _ _ _ B2); [apply
      mem_cosine, Mq | enc]). apply Rnot_lt_le; intros L; pose proof (cos_decreasing_1 (Q2R q) w ltac:(lra) ltac:(lra)
      ltac:(lra) ltac:(lra) L); lra. }
    assert (In : forall t, - w <= t <= w -> 1 - nu <= cos t).
    { intros t Ht; rewrite <- Cw; destruct (Rle_or_lt 0 t); [|rewrite <- (cos_neg t)]; apply cos_decr_1; lra. }
    exists (- w), w; split; [pose proof (Far _ U0 F1 F2); lra|]; split; [exact (Far _ V0 F3 F4)|]; split; [lra|].
    apply (Hump _ _ (- w) w); [lra | | | |]; intros; rewrite ?(proj1 (Cs _)), ?(proj2 (Cs _)), ?cos_neg.
    + pose proof (In t ltac:(lra)); lra.
    + lra.
    + rewrite <- Cw; destruct (Rle_or_lt t PI); [apply cos_decreasing_1; lra|]; replace (cos t) with (cos (2 * PI - t))
      by (rewrite cos_minus, cos_2PI, sin_2PI; ring). apply cos_decreasing_1; lra.
    + pose proof (In t ltac:(lra)); pose proof (COS_bound t); lra.
Qed.

Notation Z := (Q2R (Trap.slip X)).
Notation S := (Q2R (Trap.speed X)).
Notation E := (Q2R (Trap.growth X)).
Definition worst : machine := {| a := (c - r) / 2; b := (c + r) / 2; tau := Machine.tau M; p := 2 * PI;
  StatementTrapped.W := U + V; mu := mu0; al0 := al; al1 := al'; zm := Z * mu0; Vm := S * sqrt mu0; StatementTrapped.Q
  := fun _ => 0; Q1 := fun _ => 0; Q2 := fun _ => 0 |}.
Theorem checks : exists lo hi, traps X M (seen X M (hi - lo)) lo hi.
Proof.
  pose proof HX as H; unfold check_trap in H; cbv zeta in H; rewrite !andb_true_iff in H.
  destruct H as [[[[[[[_ _] Ht] Hd] Ha] Hn] Hs] Hx]; apply Qle_bool_iff, Qle_Rle in Ht, Ha; apply less_lt in Hd;
    rewrite
    Q2R_0 in Ht, Hd. destruct roots as (c0 & k0 & d0 & r0 & rr & Hab & Ek & Ma & Mb & Md); destruct (trap_tau _ _ HM) as
    [T0 _].
  destruct (trap_nu _ _ HM) as [N0 N1]; assert (Tau : 0 <= Machine.tau M) by lra.
  destruct (wall_hump Tau) as (lo & hi & L1 & L2 & L3 & Hump); exists lo, hi; set (T := seen X M (hi - lo)); assert
    (W0 : 0 <= U + V) by lra.
  assert (HI : inside_of (inputs_of X) worst S Z).
  { constructor; try assumption; try apply mem_fraction; [apply mem_ranging, (trap_tau _ _ HM) | apply mem_plus; apply
    mem_fraction]. }
  destruct (numbers_checked (inputs_of X) worst S Z E (fraction (Trap.growth X)) (Trap.last X) HI (mem_fraction _)
    eq_refl Hab Tau Hd W0 Ha eq_refl eq_refl Hn) as [UL S0 Ch _]; pose proof (is_narrow _ _ _ Ch) as Nw; pose proof
    (is_rounded _ _ _ Ch) as Al; cbn [worst p StatementTrapped.W al0] in Nw, Al; assert (HH : hump T lo hi) by (apply
    Hump; lra). pose proof (u_Z _ _ UL) as Z0.
  assert (Wo : worse worst T) by (constructor; cbn [T seen worst a b StatementTrapped.tau mu StatementTrapped.W p al0
    al1 zm Vm]; fold r; try split; trivial; try lra; exists Z, S; repeat split).
  pose proof (Range worst E (Zpos (Trap.last X)) T lo hi Ch HH Wo) as Chaos; assert (UT : usable T Z) by (constructor;
    cbn [T seen a b StatementTrapped.tau mu StatementTrapped.W p al0 al1 zm]; fold r; trivial; lra).
  constructor; trivial; [cbn; fold r; split; [field | exact Ek] | lra | |].
  - set (A := (c - r) / 2) in *; set (B := (c + r) / 2) in *; set (D := B - A); set (Xs := Q2R (Trap.start X)) in *;
      set (tt := Machine.tau M) in *. assert (D0 : 0 < D) by (unfold D; lra); set (q := B * B / D); assert (q0 : 0 <
      q) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
    set (fastest := fun m => sqrt (2 * (m * (al' + A * A * (m + Xs / D))))).
    assert (St : mu0 * Z <= Xs /\ 0 < al - q * (Xs + (1 + tt) * fastest mu0)).
    { unfold starts in Hs; cbv zeta in Hs; apply andb_prop in Hs; destruct Hs as [S1 S2], HI as [Ja Jb Jd Jt Jn Jw J0
        J1 JS JZ]; cbn [worst a b StatementTrapped.tau mu al0 al1] in *; pose proof (mem_fraction (Trap.start X)) as
      MX; fold Xs in MX.
      split; [apply (below_le _ _ _ _ S1); enc | apply (positive_lt _ _ S2)]; unfold q, fastest, shareI, bothI; enc. }
    destruct St as [S1 S2]; assert (nu * Z <= mu0 * Z) by (apply Rmult_le_compat_r; lra); assert (0 <= mu0 * Z) by
      (apply Rmult_le_pos; lra). assert (XD : 0 <= Xs / D) by (apply Rmult_le_pos; [lra | left; apply
      Rinv_0_lt_compat, D0]).
    assert (Fast : fastest nu <= fastest mu0).
    { apply sqrt_le_1_alt, Rmult_le_compat_l; [lra|]; assert (A * A * (nu + Xs / D) <= A * A * (mu0 + Xs / D)) by
        (apply Rmult_le_compat_l; [nra | lra]); assert (0 <= A * A * (nu + Xs / D)) by (apply Rmult_le_pos; [nra |
      lra]).
      apply Rmult_le_compat; lra. } split; [change (Z * nu <= Xs); lra|]; change (0 < al - B ^ 2 * (Xs + (1 + tt) *
    sqrt (2 * (al' + A ^ 2 * (nu + Xs / D)) * nu)) / D). replace (2 * (al' + A ^ 2 * (nu + Xs / D)) * nu) with (2 *
      (nu * (al' + A * A * (nu + Xs / D)))) by ring; fold (fastest nu). replace (B ^ 2 * (Xs + (1 + tt) * fastest nu)
      / D) with (q * (Xs + (1 + tt) * fastest nu)) by (unfold q; field; lra). assert ((1 + tt) * fastest nu <= (1 +
      tt) * fastest mu0) by (apply Rmult_le_compat_l; lra); assert (q * (Xs + (1 + tt) * fastest nu) <= q * (Xs + (1 +
      tt) * fastest mu0)) by (apply Rmult_le_compat_l; lra); lra.
  - intros n0 th m Ex N2; change (mu T) with nu in N2; unfold exponent_is in Hx; rewrite Ex in Hx; apply andb_prop in
      Hx; destruct Hx as [X0 Hx]; apply less_lt in X0; rewrite Q2R_0 in X0.
    destruct (exponent_checked (inputs_of X) worst S Z E (fraction (Trap.growth X)) (Trap.last X) HI (mem_fraction _)
      eq_refl Hab Tau Hd W0 Ha eq_refl eq_refl Hn _ _ _ _ m (mem_fraction n0) X0 (mem_fraction th) Hx) as [Low Sts];
        split.
    + constructor; [lia|]; cbv zeta in Low |- *; set (TL := p worst * IZR (Zpos m) - StatementTrapped.W worst) in *;
        set (TT := p T * IZR (Zpos m) - StatementTrapped.W T).
      assert (LT : 0 <= TL <= TT).
      { assert (1 <= IZR (Zpos m)) by (apply (IZR_le 1); lia); assert (2 * PI * 1 <= 2 * PI * IZR (Zpos m)) by (apply
          Rmult_le_compat_l; pose proof PI_RGT_0; lra). unfold TL, TT; cbn [worst T seen p StatementTrapped.W]; lra. }
      destruct (phi11_down worst Hab TL TT LT) as [F1 _]; destruct (phis worst T Wo TT) as [-> _]; pose proof
        (exp_down (a worst) TL TT ltac:(left; apply Hab) (proj2 LT)) as F2. change (a T) with (a worst); change (b T)
        with (b worst); change (StatementTrapped.tau T) with (StatementTrapped.tau worst); change (mu T) with nu;
        change (Vm T) with (S * sqrt nu); change (zm T) with (Z * nu). set (rn := sqrt nu); assert (rn0 : 0 < rn) by
        (apply sqrt_lt_R0, N0); assert (rnn : rn * rn = nu) by (apply sqrt_sqrt; lra). assert (R0 : 0 < sqrt (Q2R n0)
        <= rn) by (split; [apply sqrt_lt_R0, X0 | apply sqrt_le_1_alt, N2]).
      set (tt := StatementTrapped.tau worst) in *; set (D := b worst - a worst) in *; assert (D0 : 0 < D) by (unfold
        D; cbn [worst a b]; lra). assert (Tt : 0 <= tt) by exact Tau; set (k0' := (1 + tt) * S / sqrt (Q2R n0) + Z) in
          *; set (k1 := (1 + tt) * S / rn + Z). assert (S1 : 0 <= (1 + tt) * S) by (apply Rmult_le_pos; lra).
      assert (K : 0 <= k1 <= k0').
      { split; unfold k1, k0'; [assert (0 <= (1 + tt) * S / rn) by (apply Rmult_le_pos; [exact S1 | left; apply
          Rinv_0_lt_compat, rn0]); lra | apply Rplus_le_compat_r; apply div_mono; lra]. } assert (G : exp (- a worst *
      TT) * k1 / D <= exp (- a worst * TL) * k0' / D) by (apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat, D0 |
        apply Rmult_le_compat; [left; apply exp_pos | lra | exact F2 | lra]]).
      replace ((1 + tt) * (S * rn) + Z * nu) with (k1 * nu) by (unfold k1; rewrite <- rnn; field; lra).
      replace (exp (- a worst * TT) * (k1 * nu) / D) with (exp (- a worst * TT) * k1 / D * nu) by (field; lra).
      rewrite <- Rmult_plus_distr_r; rewrite <- (Rmult_1_l nu) at 2; apply Rmult_lt_compat_r; lra.
    + intros n Hn'; apply (stretches_more worst T Z S UL UT Wo S0 eq_refl eq_refl (is_open_after _ _ _ Ch)); [lia |
        apply exp_pos | apply Sts, Hn'].
Qed.
End Check.
Theorem Traps : Traps_statement check_trap.
Proof. intros C M HX HM; exact (checks C M HX HM). Qed.
