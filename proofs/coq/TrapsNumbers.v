(** * What the numbers that TrapsCheck finds show

    Slip and speed are listed: zm = Z mu and Vm = S sqrt mu. *)
From Coq Require Import Reals ZArith List Lra Lia Bool.
From Grazing Require Import ChaosInterval ChaosFunctions PathsCheck PathsLegs TrapsCheck StatementTrapped TrappedRange.
From Grazing Require TrappedFlow.
Open Scope R_scope.

(** ** Enclosures *)
Lemma mem_quo X Y x y : mem X x -> mem Y y -> mem (quo X Y) (x / y).
Proof. intros; apply mem_times, mem_inverse; trivial. Qed.
Lemma value z : mem (at_point z) (IZR z / IZR one). Proof. exact (mem_point z). Qed.
Lemma low_le X x : mem X x -> exists r, mem (low X) r /\ r <= x.
Proof. destruct X as [[l h]|]; intros H; [exists (IZR l / IZR one); split; [apply value | apply (ends _ _ _ H)] | exists
  x; split; [exact H | lra]]. Qed.
Lemma high_ge X x : mem X x -> exists r, mem (high X) r /\ x <= r.
Proof. destruct X as [[l h]|]; intros H; [exists (IZR h / IZR one); split; [apply value | apply (ends _ _ _ H)] | exists
  x; split; [exact H | lra]]. Qed.
Lemma over_one u v : (u <= v)%Z -> IZR u / IZR one <= IZR v / IZR one.
Proof. intros H; apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat, one_pos | apply IZR_le, H]. Qed.
Lemma lesser_le X Y x y : mem X x -> mem Y y -> exists r, mem (lesser X Y) r /\ r <= x /\ r <= y.
Proof.
  destruct X as [[l h]|], Y as [[l' h']|]; intros HX HY; try (exists (Rmin x y); split; [exact I | split; [apply Rmin_l
    | apply Rmin_r]]). apply ends in HX, HY; exists (IZR (Z.min l l') / IZR one); split; [apply value|].
  pose proof (over_one _ _ (Z.le_min_l l l')); pose proof (over_one _ _ (Z.le_min_r l l')); lra.
Qed.
Lemma greater_ge X Y x y : mem X x -> mem Y y -> exists r, mem (greater X Y) r /\ x <= r /\ y <= r.
Proof.
  destruct X as [[l h]|], Y as [[l' h']|]; intros HX HY; try (exists (Rmax x y); split; [exact I | split; [apply Rmax_l
    | apply Rmax_r]]). apply ends in HX, HY; exists (IZR (Z.max h h') / IZR one); split; [apply value|].
  pose proof (over_one _ _ (Z.le_max_l h h')); pose proof (over_one _ _ (Z.le_max_r h h')); lra.
Qed.
Lemma exp_le x y : x <= y -> exp x <= exp y.
Proof. intros [H| ->]; [left; apply exp_increasing, H | right; reflexivity]. Qed.
Lemma mem_exp_at z : mem (exp_at z) (exp (IZR z / IZR one)).
Proof.
  unfold exp_at; apply mem_squares, mem_exponential; replace (IZR z / IZR one / 2 ^ 3) with (IZR z / IZR one * (1 / 8))
    by (cbn; field; pose proof one_pos; lra). apply mem_times; [apply value | exact (mem_constant 1 8)].
Qed.
Lemma mem_fall X x : mem X x -> mem (fallI X) (exp (- x)).
Proof.
  destruct X as [[l h]|]; [|intros _; exact I]; intros H; apply ends in H; unfold fallI; pose proof one_pos as O.
  assert (Neg : forall z, IZR (- z) / IZR one = - (IZR z / IZR one)) by (intros z; rewrite opp_IZR; field; lra).
  destruct (22 * one <=? l)%Z eqn:B.
  - apply Z.leb_le, over_one in B; change (-22 * one)%Z with (- (22 * one))%Z; apply (mem_join _ _ 0 (exp (IZR (- (22 *
    one)) / IZR one))); [exact mem_zero | apply mem_exp_at|]; rewrite Neg; split; [left; apply exp_pos | apply exp_le;
    lra].
  - apply (mem_join _ _ _ _ _ (mem_exp_at _) (mem_exp_at _)); rewrite !Neg; split; apply exp_le; lra.
Qed.
Ltac enc := first [assumption | lazymatch goal with
  | |- mem (plus _ _) _ => apply mem_plus; enc | |- mem (minus _ _) _ => apply mem_minus; enc
  | |- mem (times _ _) _ => apply mem_times; enc | |- mem (quo _ _) _ => apply mem_quo; enc
  | |- mem (inverse _) _ => apply mem_inverse; enc | |- mem (root _) _ => apply mem_root; enc
  | |- mem (double _) _ => apply mem_double; enc | |- mem (fallI _) _ => apply mem_fall; enc
  | |- mem (turn _) _ => apply mem_turn | |- mem unit _ => exact mem_1 end].

(** ** phi11 and phi12 fall as a or b grow *)
Lemma growth_ratio x y : 0 < x <= y -> (exp x - 1) * y <= (exp y - 1) * x.
Proof.
  intros [H [L| ->]]; [|lra]; destruct (MVT_cor2 exp exp 0 x H) as (c & Ec & Hc); [intros; apply derivable_pt_lim_exp|].
  destruct (MVT_cor2 exp exp x y L) as (d & Ed & Hd); [intros; apply derivable_pt_lim_exp|]; rewrite exp_0 in Ec.
  pose proof (exp_increasing c d ltac:(lra)); assert (0 < (y - x) * x) by (apply Rmult_lt_0_compat; lra).
  replace (exp y - 1) with ((exp x - 1) + (exp y - exp x)) by ring; rewrite Ec, Ed; nra.
Qed.
Lemma decay_ratio x y : 0 < x <= y -> (1 - exp (- y)) * x <= (1 - exp (- x)) * y.
Proof.
  intros [H [L| ->]]; [|lra]; destruct (MVT_cor2 exp exp (- x) 0 ltac:(lra)) as (c & Ec & Hc); [intros; apply
    derivable_pt_lim_exp|]; destruct (MVT_cor2 exp exp (- y) (- x) ltac:(lra)) as (d & Ed & Hd); [intros; apply
    derivable_pt_lim_exp|]; rewrite exp_0 in Ec.
  pose proof (exp_increasing d c ltac:(lra)); assert (0 < (y - x) * x) by (apply Rmult_lt_0_compat; lra).
  replace (1 - exp (- y)) with ((1 - exp (- x)) + (exp (- x) - exp (- y))) by ring; rewrite Ec, Ed; nra.
Qed.
Definition f12 (a b T : R) : R := (exp (- (a * T)) - exp (- (b * T))) / (b - a).
Lemma f12_down_b a b b' T : a < b <= b' -> 0 <= T -> f12 a b' T <= f12 a b T.
Proof.
  intros H [HT|<-]; [|unfold f12; rewrite !Rmult_0_r; right; field; lra]; set (x := (b - a) * T); set (y := (b' - a) *
    T).
  assert (Hx : 0 < x <= y) by (unfold x, y; split; [apply Rmult_lt_0_compat | apply Rmult_le_compat_r]; lra).
  pose proof (decay_ratio x y Hx) as D; assert (Es : forall c, f12 a c T = exp (- (a * T)) * ((1 - exp (- ((c - a) *
    T))) / (c - a))) by (intros c; unfold f12, Rdiv; rewrite <- Rmult_assoc; f_equal; rewrite Rmult_minus_distr_l, <-
    exp_plus, Rmult_1_r; do 2 f_equal; ring).
  rewrite !Es; fold x y; apply Rmult_le_compat_l; [left; apply exp_pos|]; apply (Rmult_le_reg_r (x * y)); [apply
    Rmult_lt_0_compat; lra|]. replace ((1 - exp (- y)) / (b' - a) * (x * y)) with ((1 - exp (- y)) * x * T) by (unfold
    x, y; field; lra). replace ((1 - exp (- x)) / (b - a) * (x * y)) with ((1 - exp (- x)) * y * T) by (unfold x, y;
    field; lra). apply Rmult_le_compat_r; lra.
Qed.
Lemma f12_down_a a a' b T : a <= a' < b -> 0 <= T -> f12 a' b T <= f12 a b T.
Proof.
  intros H [HT|<-]; [|unfold f12; rewrite !Rmult_0_r; right; field; lra]; set (x := (b - a') * T); set (y := (b - a) *
    T).
  assert (Hx : 0 < x <= y) by (unfold x, y; split; [apply Rmult_lt_0_compat | apply Rmult_le_compat_r]; lra).
  pose proof (growth_ratio x y Hx) as D; assert (Es : forall c, f12 c b T = exp (- (b * T)) * ((exp ((b - c) * T) - 1) /
    (b - c))) by (intros c; unfold f12, Rdiv; rewrite <- Rmult_assoc; f_equal; rewrite Rmult_minus_distr_l, <- exp_plus,
    Rmult_1_r; do 2 f_equal; ring).
  rewrite !Es; fold x y; apply Rmult_le_compat_l; [left; apply exp_pos|]; apply (Rmult_le_reg_r (x * y)); [apply
    Rmult_lt_0_compat; lra|]. replace ((exp x - 1) / (b - a') * (x * y)) with ((exp x - 1) * y * T) by (unfold x, y;
    field; lra). replace ((exp y - 1) / (b - a) * (x * y)) with ((exp y - 1) * x * T) by (unfold x, y; field; lra).
  apply Rmult_le_compat_r; lra.
Qed.
Lemma f12_down a a' b b' T : a <= a' -> a < b <= b' -> a' < b' -> 0 <= T -> f12 a' b' T <= f12 a b T.
Proof. intros; apply Rle_trans with (f12 a b' T); [apply f12_down_a | apply f12_down_b]; lra. Qed.
Definition f11 (a b T : R) : R := exp (- (a * T)) + a * f12 a b T.
Lemma f11_down a a' b b' T : 0 <= a <= a' -> a < b <= b' -> a' < b' -> 0 <= T -> f11 a' b' T <= f11 a b T.
Proof.
  intros; apply Rle_trans with (f11 a b' T).
  - assert (Es : forall c, c < b' -> f11 c b' T = exp (- (b' * T)) + b' * f12 c b' T) by (intros c Hc; unfold f11, f12;
    field; lra). rewrite !Es by lra; apply Rplus_le_compat_l, Rmult_le_compat_l; [lra | apply f12_down_a; lra].
  - apply Rplus_le_compat_l, Rmult_le_compat_l; [lra | apply f12_down_b; lra].
Qed.

(** ** What it shows *)
Section Sound.
Variables (I : inputs) (L : machine) (S Z E : R) (eI : itv) (last : BinNums.positive).
Record inside_of : Prop := { i_a : mem (aI I) (a L); i_b : mem (bI I) (b L); i_d : mem (dI I) (b L - a L);
  i_t : mem (tI I) (tau L); i_n : mem (nI I) (mu L); i_w : mem (wI I) (W L); i_low : mem (lowI I) (al0 L);
  i_top : mem (topI I) (al1 L); i_speed : mem (speedI I) S; i_slip : mem (slipI I) Z }.
Hypothesis HI : inside_of.
Hypothesis HE : mem eI E.
Hypothesis Hp : p L = 2 * PI.
Hypothesis Hab : 0 < a L < b L.
Hypothesis Htau : 0 <= tau L.
Hypothesis Hmu : 0 < mu L.
Hypothesis HW : 0 <= W L.
Hypothesis Hal : al0 L <= al1 L.
Hypothesis Hzm : zm L = Z * mu L.
Hypothesis HVm : Vm L = S * sqrt (mu L).
Hypothesis H : numbers_hold I eI last = true.
Notation D := (b L - a L).

Lemma mem_reach T r : mem T r -> 0 <= r -> positive (minus (high (bI I)) (high (aI I))) = true ->
  exists z, mem (reachI I T) z /\ z <= phi12 L r.
Proof.
  intros HT Hr P; destruct HI as [Ma Mb _ _ _ _ _ _ _ _], (high_ge _ _ Ma) as (x & Mx & Lx), (high_ge _ _ Mb) as (y & My
    & Ly).
  assert (X : 0 < y - x) by (apply (positive_lt _ _ P); enc); exists (f12 x y r); split; [unfold reachI, f12; enc|].
  replace (phi12 L r) with (f12 (a L) (b L) r) by (unfold phi12, f12; do 2 f_equal; f_equal; ring); apply f12_down; lra.
Qed.
Lemma mem_rest T r : mem T r -> 0 <= r -> positive (minus (low (bI I)) (low (aI I))) = true -> positive (low (aI I)) =
  true -> exists z, mem (restI I T) z /\ phi11 L r <= z.
Proof.
  intros HT Hr P P0; destruct HI as [Ma Mb _ _ _ _ _ _ _ _], (low_le _ _ Ma) as (x & Mx & Lx), (low_le _ _ Mb) as (y &
    My & Ly).
  assert (X : 0 < y - x) by (apply (positive_lt _ _ P); enc); pose proof (positive_lt _ _ P0 Mx); exists (f11 x y r);
    split; [unfold restI, f11, f12; cbv zeta; enc|].
  replace (phi11 L r) with (f11 (a L) (b L) r); [apply f11_down; lra|]; unfold f11, f12, phi11.
  replace (- (a L * r)) with (- a L * r) by ring; replace (- (b L * r)) with (- b L * r) by ring; field; lra.
Qed.

Record numbers : Prop := { n_usable : usable L Z; n_speed : 0 < S; n_checked : checked L E (Z.pos last);
  n_stretches : forall fI f n, mem fI f -> 0 < f -> by_either I (strengthI I) (heightI I) (quickI I) (wayI I) fI n =
    true -> stretches L f (Z.pos n) }.
Theorem numbers_checked : numbers.
Proof.
  pose proof H as B; unfold numbers_hold in B; cbv zeta in B; rewrite !andb_true_iff in B.
  destruct B as [[[[[[[[[[[[[N0 A0] PH] P0] PL] PE] SH] Pe] BM] Pl] PS] PZ] E1] [F BB]].
  pose proof HI as HI'; destruct HI' as [Ma Mb Md Mt Mn Mw M0 M1 MS MZ].
  assert (N : W L < p L) by (rewrite Hp; apply Rminus_gt_0_lt, (positive_lt _ _ N0); replace (2 * PI) with (2 * PI * 1)
    by ring; enc). assert (R0 : 0 < al0 L) by (apply (positive_lt _ _ A0), M0); pose proof (positive_lt _ _ PS MS) as
      S0; pose proof (positive_lt _ _ PZ MZ) as Z0. assert (U : usable L Z) by (split; lra).
  set (nu := mu L) in *; set (r := sqrt nu) in *.
  assert (Mr : mem (rI I) r) by (unfold rI, r; enc); assert (rr : r * r = nu) by (apply sqrt_sqrt; lra); assert (r0 : 0
    < r) by (apply sqrt_lt_R0; lra).
  assert (Ell : forall n, exists z, mem (ellI I n) z /\ z <= ell L (IZR (Z.pos n))).
  { intros n; assert (1 <= IZR (Z.pos n)) by (apply (IZR_le 1); lia); assert (p L * 1 <= p L * IZR (Z.pos n)) by (apply
    Rmult_le_compat_l; lra). assert (Mp : mem (turn n) (p L * IZR (Z.pos n))) by (rewrite Hp; apply mem_turn). destruct
    (mem_reach (minus (turn n) (wI I)) (p L * IZR (Z.pos n) - W L)) as (x & Mx & Lx); [enc | lra | exact PH|]. destruct
    (mem_reach (plus (turn n) (wI I)) (p L * IZR (Z.pos n) + W L)) as (y & My & Ly); [enc | lra | exact PH|].
    destruct (lesser_le _ _ _ _ Mx My) as (z & Mz & L1 & L2); exists z; split; [exact Mz|]; apply Rmin_glb; lra. }
  assert (Slip : zh L <= Z).
  { unfold slip_holds in SH; cbv zeta in SH; rewrite !andb_true_iff in SH; destruct SH as [[S1 S2] S3]; destruct (low_le
    _ _ Md) as (x & Mx & Lx). pose proof (positive_lt _ _ S1 Mx) as x0; set (y := p L - W L) in *; assert (y0 : 0 < y)
    by (unfold y; lra). assert (My : mem (minus (turn 1) (wI I)) y) by (unfold y; rewrite Hp; replace (2 * PI) with (2 *
    PI * 1) by ring; enc). set (f := exp (- (x * y))); assert (Mf : mem (fallI (times (low (dI I)) (minus (turn 1) (wI
    I)))) f) by (unfold f; enc). assert (f0 : 0 < f) by apply exp_pos; assert (f1 : 0 < 1 - f) by (apply (positive_lt _
    _ S2); enc).
    assert (X : x * f <= Z * (1 - f)) by (apply (below_le _ _ _ _ S3); enc).
    pose proof (growth_ratio (x * y) (D * y) ltac:(split; [apply Rmult_lt_0_compat; lra | apply Rmult_le_compat_r;
      lra])) as G.
    assert (Ef : exp (x * y) * f = 1) by (unfold f; rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
    pose proof (rise L Z U) as Rs; fold y in Rs; unfold zh; fold y; set (g := exp (D * y)) in *; set (h := exp (x *
      y)) in
      *.
    apply (Rmult_le_reg_r (g - 1)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    assert (G' : (h - 1) * D <= (g - 1) * x) by (apply (Rmult_le_reg_r y); lra).
    apply (Rmult_le_compat_r f) in G'; [|lra]; replace ((h - 1) * D * f) with ((1 - f) * D) in G' by (replace (1 - f)
      with (h * f - f) by lra; ring). apply (Rmult_le_reg_l (1 - f)); [exact f1|]; apply (Rmult_le_compat_l (g - 1)) in
      X; lra. }
  destruct (Ell 1%positive) as (z1 & Mz1 & Lz1); pose proof (positive_lt _ _ PE Mz1) as z0; set (w := / z1).
  assert (w0 : 0 < w) by (apply Rinv_0_lt_compat, z0); assert (Mw1 : mem (wholeI I) w) by (unfold wholeI, w; enc).
  pose proof (V1h_pos L Z U) as vp; pose proof (slip_hat L Z U) as slip_is; fold nu in slip_is.
  assert (V1w : (1 + tau L) * V1h L <= w).
  { unfold V1h; rewrite Rinv_mult, <- Rmult_assoc, Rinv_r, Rmult_1_l by lra; apply Rinv_le_contravar; [exact z0 | exact
    Lz1]. }
  set (q := b L * b L / D); assert (Mq : mem (shareI I) q) by (unfold shareI, q; enc); assert (q0 : 0 < q) by (apply
    Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
  set (ew := / exp (- (b L * W L))); set (e := al0 L - q * ew * (nu * (Z + w))).
  assert (Me : mem (earlyI I) e) by (unfold earlyI, e, ew; enc); pose proof (positive_lt _ _ Pe Me) as e0.
  assert (Ew : exp (b L * W L) = ew) by (unfold ew; rewrite <- exp_Ropp; f_equal; ring); assert (ew0 : 0 < ew) by (apply
    Rinv_0_lt_compat, exp_pos).
  assert (Before : e <= alb L).
  { unfold alb, e; rewrite Ew, Hzm; replace (b L ^ 2 * ew * (Z * nu + (1 + tau L) * V1 L) / D) with (q * ew * (Z * nu
      + (1 + tau
    L) * V1 L)) by (unfold q; field; lra). apply Rplus_le_compat_l, Ropp_le_contravar, Rmult_le_compat_l; [apply
    Rmult_le_pos; lra|]. rewrite V1_hat; fold nu; assert (nu * ((1 + tau L) * V1h L) <= nu * w) by (apply
    Rmult_le_compat_l; lra); lra. }
  set (v := w / (1 + tau L)); set (la := exp (- (a L * (2 * PI * 1)))); set (fl := 1 - la * (1 - tau L * tau L * (nu *
    (v * v)) / (2 * e))). assert (Mfl : mem (fallenI I) fl).
  { unfold fallenI, fl, v, la; cbv zeta; assert (mem (bothI I) (1 + tau L)) by (unfold bothI; enc); enc. }
  assert (Ela : exp (- a L * p L) = la) by (unfold la; rewrite Hp; f_equal; ring); pose proof (decay_1 L Z U) as L1;
    rewrite Ela in L1.
  assert (Vv : 0 < V1h L <= v) by (split; [exact vp|]; unfold v; apply (Rmult_le_reg_r (1 + tau L)); [lra|]; unfold
    Rdiv; rewrite Rmult_assoc, Rinv_l; lra). assert (Deep : deeph L <= fl).
  { unfold deeph, fl; rewrite Ela; fold nu; assert (T : tau L ^ 2 * V1h L ^ 2 * nu / (2 * alb L) <= tau L * tau L * (nu
    * (v * v)) / (2 * e)); [|apply (Rmult_le_compat_l la) in T; lra]. apply div_mono; [|lra]; replace (tau L ^ 2 * V1h L
    ^ 2 * nu) with (tau L * tau L * (nu * (V1h L * V1h L))) by ring. assert (0 <= tau L * tau L) by nra; assert (V1h L *
    V1h L <= v * v) by (apply Rmult_le_compat; lra). split; [apply Rmult_le_pos; [|apply Rmult_le_pos]; nra|]; apply
    Rmult_le_compat_l; [lra | apply Rmult_le_compat_l; lra]. }
  set (mo := al1 L + a L * a L * (nu * (1 + Z / D))); assert (Mmo : mem (mostI I) mo) by (unfold mostI, mo; enc).
  assert (Most : alM L = mo) by (unfold alM, mo; rewrite Hzm; fold nu; field; lra).
  assert (Before0 : 0 < alb L) by lra; pose proof (alM_pos L Z U) as mp; pose proof (deeph_pos L Z U Before0) as dp.
  assert (Speed : vh L <= S).
  { assert (X : 2 * (mo * fl) <= S * S) by (apply (below_le _ _ _ _ BM); enc); unfold vh; rewrite <- (sqrt_square S) by
    lra; apply sqrt_le_1_alt; apply Rle_trans with (2 := X); rewrite Rmult_assoc; apply Rmult_le_compat_l; [lra|]; apply
    Rmult_le_compat; lra. }
  assert (Mqk : mem (quickI I) (r * S)) by (unfold quickI; enc). assert (Mbo : mem (bothI I) (1 + tau L)) by (unfold
    bothI; enc).
  set (lt := al0 L - q * (nu * Z + (1 + tau L) * (r * S))); assert (Mlt : mem (lateI I) lt) by (unfold lateI, lt; enc).
  pose proof (positive_lt _ _ Pl Mlt) as lt0; assert (After : alo L = lt) by (unfold alo, lt, q; rewrite Hzm, HVm;
    field; lra). set (s := tau L * (al0 L - q * (nu * Z)) + lt); assert (Ms : mem (strengthI I) s) by (unfold
    strengthI, s; enc). assert (Str : sigma L = s) by (unfold sigma, s, q; rewrite After, Hzm; field; lra).
  assert (s0 : 0 < s) by (rewrite <- Str; apply (sigma_0 L Z U S S0 HVm); lra).
  destruct (greater_ge (plus (speedI I) (times (rI I) (slipI I))) (times (aI I) (rI I)) (S + r * Z) (a L * r)) as (m &
    Mm & G1 & G2); [enc | enc|]. set (h := 1 - m * m / (2 * al0 L)); assert (Mh : mem (heightI I) h) by (unfold heightI,
    steepI, h; enc). assert (rz : 0 < r * Z) by (apply Rmult_lt_0_compat; lra). assert (Top : topped L Z S <= m * m /
      (2
    * al0 L)).
  { unfold topped; fold nu r; apply div_mono; [|lra]; split; [apply pow2_ge_0|]; replace (m * m) with (m ^ 2) by ring;
    apply pow_incr; split; [apply Rle_trans with (S + r * Z); [lra | apply Rmax_l] | apply Rmax_lub; lra]. }
  set (way := ((1 + tau L) * S + r * Z) * S); assert (Mway : mem (wayI I) way) by (unfold wayI, way; enc).
  assert (E0 : 1 < E) by (apply Rminus_gt_0_lt, (positive_lt _ _ E1); enc); assert (way0 : 0 < way) by (assert (0 <=
    tau L * S) by (apply Rmult_le_pos; lra); apply Rmult_lt_0_compat; lra).
  assert (ByB : forall fI f n, mem fI f -> 0 < f -> by_B I (strengthI I) (heightI I) (times fI (wayI I)) n = true -> f
    <= B_ L (IZR (Z.pos n))).
  { intros fI f n Mf f0 X; assert (1 <= IZR (Z.pos n)) by (apply (IZR_le 1); lia); assert (p L * 1 <= p L * IZR (Z.pos
    n)) by (apply Rmult_le_compat_l; lra). assert (Mp : mem (turn n) (p L * IZR (Z.pos n))) by (rewrite Hp; apply
    mem_turn). destruct (mem_rest (minus (turn n) (wI I)) (p L * IZR (Z.pos n) - W L)) as (x & Mx & Lx); [enc | lra |
      exact PL | exact P0|]. apply (below_le _ _ (f * way) (s * (h - x))) in X; [|enc|enc]; rewrite (B_hat L Z U S S0
      HVm), Str; fold nu r way.
    assert (T : s * (h - x) <= s * (1 - topped L Z S - phi11 L (p L * IZR (Z.pos n) - W L))) by (apply
      Rmult_le_compat_l; unfold h; lra). apply (Rmult_le_reg_r way); [exact way0|]; unfold Rdiv; rewrite Rmult_assoc,
      Rinv_l, Rmult_1_r; lra. } assert (ByA : forall fI f n, mem fI f -> 0 < f -> by_A I (strengthI I) (times fI
  (quickI I)) n = true -> f <= A_ L (IZR (Z.pos n))).
  { intros fI f n Mf f0 X; destruct (Ell n) as (z & Mz & Lz); apply (below_le _ _ (f * (r * S)) (s * z)) in X;
      [|enc|enc]. assert (s * z <= s * ell L (IZR (Z.pos n))) by (apply Rmult_le_compat_l; lra).
    assert (V0 : 0 < r * S) by (apply Rmult_lt_0_compat; lra); unfold A_; rewrite Str, HVm, (Rmult_comm S); apply
      (Rmult_le_reg_r (r * S)); [exact V0|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r; lra. } assert (Both
  : forall fI f n, mem fI f -> 0 < f -> by_either I (strengthI I) (heightI I) (quickI I) (wayI I) fI n = true
    -> stretches L f (Z.pos n)) by (intros fI f n Mf f0 X; apply orb_prop in X; destruct X as [X|X]; [left; apply (ByA
    fI) | right; apply (ByB fI)]; assumption).
  constructor; [exact U | exact S0 | | exact Both]. constructor; try lia; try lra.
  - rewrite slip_is, Hzm, (speed_hat L Z U Before0), HVm; fold nu r; repeat split; [exact Before0 | rewrite
      (Rmult_comm Z) | rewrite (Rmult_comm S)]; apply Rmult_le_compat_l; lra.
  - intros n Hn; pose proof (proj1 (forallb_forall _ _) F (Z.to_nat n) ltac:(apply in_seq; lia)) as X; cbv beta in X.
    replace n with (Z.pos (Pos.of_nat (Z.to_nat n))) by lia; apply (Both _ _ _ HE); [lra | exact X].
  - apply (ByB _ _ _ HE); [lra | exact BB].
Qed.
(** A7, for any depth from nu0 on. *)
Theorem exponent_checked NI nu0 RI R m : mem NI nu0 -> 0 < nu0 -> mem RI R -> exponent_holds I NI RI m = true ->
  let T := p L * IZR (Z.pos m) - W L in phi11 L T + exp (- a L * T) * ((1 + tau L) * S / sqrt nu0 + Z) / D < 1 /\
  forall n, (1 <= n <= Z.pos m)%Z -> stretches L (exp (R * IZR n)) n.
Proof.
  intros HN N0 HR X T; unfold exponent_holds in X; cbv zeta in X; apply andb_prop in X; destruct X as [X1 X2].
  destruct numbers_checked as [U S0 [w0 _ _ _ _ _ _ _] St]; pose proof HI as [Ma Mb Md Mt Mn Mw M0 M1 MS MZ]; split.
  - pose proof H as B; unfold numbers_hold in B; cbv zeta in B; rewrite !andb_true_iff in B.
    destruct B as [[[[[[[[[[[[[_ _] _] P0] PL] _] _] _] _] _] _] _] _] _]; assert (1 <= IZR (Z.pos m)) by (apply
      (IZR_le 1); lia). assert (p L * 1 <= p L * IZR (Z.pos m)) by (apply Rmult_le_compat_l; lra).
    assert (MT : mem (minus (turn m) (wI I)) T) by (unfold T; rewrite Hp; pose proof (mem_turn m); enc).
    destruct (mem_rest _ T MT ltac:(unfold T; lra) PL P0) as (x & Mx & Lx); assert (Mk : mem (plus (quo (times (bothI
      I) (speedI I)) (root NI)) (slipI I)) ((1 + tau L) * S / sqrt nu0 + Z)) by (assert (mem (bothI I) (1 + tau L)) by
      (unfold bothI; enc); enc). set (k := (1 + tau L) * S / sqrt nu0 + Z) in *.
    assert (Y : 0 < 1 - (x + exp (- (a L * T)) / D * k)) by (apply (positive_lt _ _ X1); enc).
    replace (- a L * T) with (- (a L * T)) by ring; unfold Rdiv in *; lra.
  - intros n Hn; pose proof (proj1 (forallb_forall _ _) X2 (Z.to_nat n) ltac:(apply in_seq; lia)) as Y; cbv beta zeta
      in Y. replace n with (Z.pos (Pos.of_nat (Z.to_nat n))) by lia; set (k := Pos.of_nat (Z.to_nat n)) in *.
    refine (St _ _ _ _ (exp_pos _) Y); replace (exp (R * IZR (Z.pos k))) with (/ exp (- (IZR (Z.pos k) * R))) by
      (rewrite <- exp_Ropp; f_equal; ring). apply mem_inverse, mem_fall, mem_scaled, HR.
Qed.
End Sound.
