(** * exp, cos, sin and asin of an interval with integer ends lie in the intervals computed for them *)

From Coq Require Import Reals ZArith Lra Lia Bool.
From Grazing Require Import ChaosInterval.
Open Scope R_scope.

(** ** exp: (1 + x/2^12)^(2^12) <= exp x <= (1 - x/2^12)^(-2^12) *)

Fixpoint squares (n : nat) (X : itv) : itv := match n with O => X | S n => squares n (times X X) end.
Definition join (X Y : itv) : itv := match X, Y with
  | Some (a, _), Some (_, d) => Some (a, d) | _, _ => None end.
Definition exponential (X : itv) : itv :=
  let Y := times X (constant 1 4096) in
  let I := constant 1 1 in
  if positive (minus I Y) then squares 12 (join (plus I Y) (inverse (minus I Y))) else None.

Lemma mem_join X Y x y z : mem X x -> mem Y y -> x <= z <= y -> mem (join X Y) z.
Proof.
  destruct X as [[]|], Y as [[]|]; cbn; trivial; intros; pose proof one_pos; split; nra.
Qed.

Lemma mem_squares n X x : mem X (exp (x / 2 ^ n)) -> mem (squares n X) (exp x).
Proof.
  revert X; induction n as [|n IH]; intros X H; cbn [squares].
  - replace (x / 2 ^ 0) with x in H by (cbn; field); exact H.
  - apply IH; replace (x / 2 ^ n) with (x / 2 ^ S n + x / 2 ^ S n).
    + rewrite exp_plus; apply mem_times; exact H.
    + cbn; field; apply pow_nonzero; lra.
Qed.

Lemma mem_1 : mem (constant 1 1) 1.
Proof. pose proof (mem_constant 1 1) as H; replace (1 / 1) with 1 in H by field; exact H. Qed.

Lemma mem_exponential X x : mem X x -> mem (exponential X) (exp x).
Proof.
  intros Hx; unfold exponential.
  pose proof (mem_times _ _ _ _ Hx (mem_constant 1 4096)) as HY; set (Y := times _ _) in *.
  set (y := x * (1 / 4096)) in *.
  pose proof (mem_plus _ _ _ _ mem_1 HY) as P; pose proof (mem_minus _ _ _ _ mem_1 HY) as M.
  cbv zeta; destruct (positive _) eqn:Hp; [|exact I].
  pose proof (positive_lt _ _ Hp M) as Hy.
  apply mem_squares; replace (x / 2 ^ 12) with y by (unfold y; cbn; field).
  apply (mem_join _ _ _ _ _ P (mem_inverse _ _ M)); split; [apply exp_ineq1_le|].
  rewrite <- (Ropp_involutive y), exp_Ropp, Ropp_involutive; apply Rinv_le_contravar; [lra|].
  pose proof (exp_ineq1_le (- y)); lra.
Qed.

(** ** cos: its series at x/64, then six times cos 2x = 2 cos^2 x - 1, about the middle *)

Fixpoint doubled (n : nat) (X : itv) : itv := match n with
  | O => X | S n => doubled n (minus (times (constant 2 1) (times X X)) (constant 1 1)) end.
Definition cos_small (Y : itv) : itv :=
  let Z := times Y Y in
  join (minus (plus (minus (constant 1 1) (times (constant 1 2) Z)) (times (constant 1 24) (times Z Z)))
              (times (constant 1 720) (times (times Z Z) Z)))
       (plus (minus (constant 1 1) (times (constant 1 2) Z)) (times (constant 1 24) (times Z Z))).
Definition cosine (X : itv) : itv := match X with
  | Some (l, h) =>
    let m := Z.shiftr (l + h) 1 in
    if (Z.abs m <=? 64 * one)%Z then
      plus (doubled 6 (cos_small (times (Some (m, m)) (constant 1 64)))) (Some (m - h, h - m)%Z)
    else None
  | None => None end.

Lemma cos_series y : -1 <= y <= 1 ->
  1 - 1 / 2 * (y * y) + 1 / 24 * (y * y * (y * y)) - 1 / 720 * (y * y * (y * y) * (y * y)) <= cos y <=
  1 - 1 / 2 * (y * y) + 1 / 24 * (y * y * (y * y)).
Proof.
  intros Hy; pose proof PI2_3_2 as HP.
  destruct (cos_bound y 0) as [_ U]; [lra|lra|]; destruct (cos_bound y 1) as [L _]; [lra|lra|].
  cbn [Nat.mul Nat.add] in L, U; unfold cos_approx in *; cbn [sum_f_R0] in *; unfold cos_term in *.
  cbn [Nat.mul Nat.add] in *.
  replace (INR (fact 0)) with 1 in * by reflexivity.
  replace (INR (fact 2)) with 2 in * by (cbn; ring).
  replace (INR (fact 4)) with 24 in * by (cbn; ring).
  replace (INR (fact 6)) with 720 in * by (rewrite INR_IZR_INZ; reflexivity).
  split; [eapply Rle_trans; [|exact L] | eapply Rle_trans; [exact U|]]; right; field.
Qed.

Lemma cos_lipschitz x y : Rabs (cos x - cos y) <= Rabs (x - y).
Proof.
  rewrite form2.
  replace (Rabs (x - y)) with (Rabs (-2 * ((x - y) / 2) * 1)) by (rewrite Rabs_minus_sym; f_equal; field).
  rewrite !Rabs_mult; apply Rmult_le_compat.
  - apply Rmult_le_pos; apply Rabs_pos.
  - apply Rabs_pos.
  - apply Rmult_le_compat_l; [apply Rabs_pos|].
    set (z := (x - y) / 2).
    assert (H : forall z, 0 <= z -> Rabs (sin z) <= z).
    { intros u Hu; destruct (Rle_lt_or_eq_dec _ _ Hu) as [Hu'|<-]; [|rewrite sin_0, Rabs_R0; lra].
      destruct (Rle_lt_dec 1 u).
      - pose proof (SIN_bound u); apply Rabs_le; lra.
      - pose proof (sin_lt_x u Hu'); pose proof PI2_3_2.
        pose proof (sin_gt_0 u Hu'); rewrite Rabs_pos_eq; lra. }
    destruct (Rle_lt_dec 0 z); [rewrite (Rabs_pos_eq z) by lra; auto|].
    rewrite (Rabs_left z) by lra; rewrite <- (Ropp_involutive z), sin_neg, Rabs_Ropp, Ropp_involutive.
    apply H; lra.
  - rewrite Rabs_R1; pose proof (SIN_bound ((x + y) / 2)); apply Rabs_le; lra.
Qed.

Lemma mem_doubled n X x : mem X (cos (x / 2 ^ n)) -> mem (doubled n X) (cos x).
Proof.
  revert X; induction n as [|n IH]; intros X H; cbn [doubled].
  - replace (x / 2 ^ 0) with x in H by (cbn; field); exact H.
  - apply IH; replace (x / 2 ^ n) with (2 * (x / 2 ^ S n)) by (cbn; field; apply pow_nonzero; lra).
    rewrite cos_2a_cos, Rmult_assoc.
    apply mem_minus; [|exact mem_1]; apply mem_times; [|apply mem_times; exact H].
    pose proof (mem_constant 2 1) as H2; replace (2 / 1) with 2 in H2 by field; exact H2.
Qed.

Lemma mem_cos_small Y y : -1 <= y <= 1 -> mem Y y -> mem (cos_small Y) (cos y).
Proof.
  intros Hy HY; unfold cos_small; cbv zeta.
  eapply mem_join; [| |exact (cos_series y Hy)];
    repeat first [exact HY | apply mem_minus | apply mem_plus | apply mem_times | apply mem_constant | exact
      mem_1].
Qed.

Lemma middle x y h m o c l : y * o = m -> 0 < o -> l <= x * o <= h -> 2 * m <= l + h ->
  Rabs c <= Rabs (x - y) -> m - h <= c * o <= h - m.
Proof.
  intros E Ho Hx Hm Hc.
  assert (D : Rabs (x - y) * o <= h - m).
  { rewrite <- (Rabs_pos_eq o) at 1 by lra; rewrite <- Rabs_mult; apply Rabs_le; lra. }
  assert (Hc' : - Rabs c <= c <= Rabs c) by (unfold Rabs; destruct (Rcase_abs c); lra).
  nra.
Qed.

Lemma mem_cosine X x : mem X x -> mem (cosine X) (cos x).
Proof.
  destruct X as [[l h]|]; [|trivial]; intros Hx; cbn [cosine].
  set (m := Z.shiftr (l + h) 1); destruct (Z.leb_spec (Z.abs m) (64 * one)) as [Hm|]; [|exact I].
  pose proof one_pos as H1.
  assert (exists y, y * IZR one = IZR m) as [y Ey] by (exists (IZR m / IZR one); field; lra).
  assert (Hy : mem (Some (m, m)) y) by (cbn [mem]; lra).
  pose proof (mem_times _ _ _ _ Hy (mem_constant 1 64)) as HY.
  assert (B : -1 <= y * (1 / 64) <= 1).
  { assert (A1 : IZR m <= IZR (64 * one)) by (apply IZR_le; lia).
    assert (A2 : IZR (- (64 * one)) <= IZR m) by (apply IZR_le; lia).
    rewrite opp_IZR in A2; rewrite mult_IZR in A1, A2; split; nra. }
  pose proof (mem_cos_small _ _ B HY) as C.
  replace (y * (1 / 64)) with (y / 2 ^ 6) in C by (cbn; field); apply mem_doubled in C.
  replace (cos x) with (cos y + (cos x - cos y)) by ring; apply mem_plus; [exact C|].
  pose proof (cos_lipschitz x y) as L.
  assert (Hmid : (l + h - 1 <= 2 * m <= l + h)%Z).
  { unfold m; rewrite Z.shiftr_div_pow2 by lia; change (2 ^ 1)%Z with 2%Z.
    pose proof (Z.div_mod (l + h) 2); pose proof (Z.mod_pos_bound (l + h) 2); lia. }
  cbn [mem] in *; rewrite !minus_IZR.
  assert (A : IZR (2 * m) <= IZR (l + h)) by (apply IZR_le; lia).
  rewrite plus_IZR, mult_IZR in A.
  exact (middle _ _ _ _ _ _ _ Ey H1 Hx A L).
Qed.

(** ** pi, from cos (pi/3) = 1/2; sin x = cos (pi/2 - x) *)

Definition pi : itv := join (constant 31413 10000) (constant 31419 10000).

Lemma cos_sign x : 0 <= x <= PI -> (cos (PI / 3) < cos x -> x <= PI / 3) /\ (cos x < cos (PI / 3) ->
  PI / 3 <= x).
Proof.
  intros Hx; pose proof PI_RGT_0; split; intros H0; apply Rnot_lt_le; intros L;
    apply cos_decreasing_1 in L; lra.
Qed.

Lemma third_lo : 10471 / 10000 <= PI / 3.
Proof.
  pose proof PI2_3_2; apply (cos_sign (10471 / 10000)); [lra|].
  rewrite cos_PI3; apply Rminus_gt_0_lt.
  apply (positive_lt (minus (cosine (constant 10471 10000)) (constant 1 2))); [vm_compute; reflexivity|].
  apply mem_minus; [apply mem_cosine|]; apply mem_constant.
Qed.

Lemma third_hi : PI / 3 <= 10473 / 10000.
Proof.
  pose proof PI2_3_2; apply (cos_sign (10473 / 10000)); [lra|].
  rewrite cos_PI3; apply Rminus_gt_0_lt.
  apply (positive_lt (minus (constant 1 2) (cosine (constant 10473 10000)))); [vm_compute; reflexivity|].
  apply mem_minus; [|apply mem_cosine]; apply mem_constant.
Qed.

Lemma mem_pi : mem pi PI.
Proof.
  pose proof third_lo; pose proof third_hi.
  apply (mem_join _ _ _ _ _ (mem_constant 31413 10000) (mem_constant 31419 10000)); lra.
Qed.

Definition sine (X : itv) : itv := cosine (minus (times pi (constant 1 2)) X).

Lemma mem_sine X x : mem X x -> mem (sine X) (sin x).
Proof.
  intros Hx; rewrite <- cos_shift; apply mem_cosine, mem_minus; [|exact Hx].
  replace (PI / 2) with (PI * (1 / 2)) by field; apply mem_times; [exact mem_pi | apply mem_constant].
Qed.

(** sin of small numbers, by its series. *)
Definition sine_small (Y : itv) : itv :=
  let Z := times Y Y in
  let R := times (size (times Y (times Z (times Z Z)))) (constant 1 5040) in
  plus (plus (minus Y (times (constant 1 6) (times Y Z))) (times (constant 1 120) (times Y (times Z Z))))
       (join (opp R) R).

Lemma sin_series y : -1 <= y <= 1 ->
  Rabs (sin y - (y - 1 / 6 * (y * (y * y)) + 1 / 120 * (y * (y * y * (y * y))))) <=
  Rabs (y * (y * y * (y * y * (y * y)))) * (1 / 5040).
Proof.
  assert (H : forall y, 0 <= y <= 1 ->
    - (y * (y * y * (y * y * (y * y))) * (1 / 5040)) <=
    sin y - (y - 1 / 6 * (y * (y * y)) + 1 / 120 * (y * (y * y * (y * y)))) <= 0).
  { clear y; intros y Hy; pose proof PI2_3_2 as HP.
    destruct (sin_bound y 0) as [_ U]; [lra|lra|]; destruct (sin_bound y 1) as [L _]; [lra|lra|].
    cbn [Nat.mul Nat.add] in L, U; unfold sin_approx in *; cbn [sum_f_R0] in *; unfold sin_term in *.
    cbn [Nat.mul Nat.add] in *.
    replace (INR (fact 1)) with 1 in * by reflexivity.
    replace (INR (fact 3)) with 6 in * by (cbn; ring).
    replace (INR (fact 5)) with 120 in * by (rewrite INR_IZR_INZ; reflexivity).
    replace (INR (fact 7)) with 5040 in * by (rewrite INR_IZR_INZ; reflexivity).
    cbn [pow] in *; lra. }
  intros Hy; destruct (Rle_lt_dec 0 y) as [Hp|Hn].
  - specialize (H y ltac:(lra)); set (r := y * (y * y * (y * y * (y * y)))) in *.
    rewrite (Rabs_pos_eq r) by lra; apply Rabs_le; lra.
  - specialize (H (- y) ltac:(lra)); rewrite sin_neg in H.
    replace (- y * (- y * - y * (- y * - y * (- y * - y)))) with (- (y * (y * y * (y * y * (y * y)))))
      in H by ring.
    set (r := y * (y * y * (y * y * (y * y)))) in *.
    rewrite (Rabs_left1 r) by lra; apply Rabs_le; lra.
Qed.

Lemma mem_sine_small Y y : -1 <= y <= 1 -> mem Y y -> mem (sine_small Y) (sin y).
Proof.
  intros Hy HY; unfold sine_small; cbv zeta; pose proof (sin_series y Hy) as H.
  set (R := times _ (constant 1 5040)).
  assert (HR : mem R (Rabs (y * (y * y * (y * y * (y * y)))) * (1 / 5040))).
  { unfold R; apply mem_times; [|apply mem_constant]; apply mem_size;
      repeat first [exact HY | apply mem_times]. }
  set (r := Rabs _ * _) in *; set (P := y - _ + _) in *.
  replace (sin y) with (P + (sin y - P)) by ring; apply mem_plus.
  - unfold P; repeat first [exact HY | apply mem_minus | apply mem_plus | apply mem_times | apply
    mem_constant].
  - apply (mem_join _ _ _ _ _ (mem_opp _ _ HR) HR).
    revert H; unfold Rabs; destruct Rcase_abs; lra.
Qed.

(** cos and sin on [0, pi]: there cos decreases, and sin x = sqrt (1 - cos^2 x). *)
Definition circle (X : itv) : itv * itv := match X with
  | Some (l, h) =>
    if (0 <=? l)%Z && below X pi then
      let c := join (cosine (Some (h, h))) (cosine (Some (l, l))) in
      (c, root (minus (constant 1 1) (times c c)))
    else (None, None)
  | None => (None, None) end.

Lemma mem_point m : mem (Some (m, m)) (IZR m / IZR one).
Proof. pose proof one_pos; cbn [mem]; replace (IZR m / IZR one * IZR one) with (IZR m) by (field; lra);
  lra. Qed.

Lemma ends x l h : mem (Some (l, h)) x -> IZR l / IZR one <= x <= IZR h / IZR one.
Proof.
  pose proof one_pos; cbn [mem]; intros Hx.
  split; apply (Rmult_le_reg_r (IZR one)); trivial; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Lemma mem_circle X x : mem X x -> mem (fst (circle X)) (cos x) /\ mem (snd (circle X)) (sin x).
Proof.
  destruct X as [[l h]|]; [|split; exact I]; intros Hx; cbn [circle].
  destruct (_ && _) eqn:H; [|split; exact I]; apply andb_prop in H; destruct H as [H0 HP].
  apply Z.leb_le, IZR_le in H0; pose proof one_pos as H1; pose proof (ends _ _ _ Hx) as Hx1.
  assert (Hh : IZR h / IZR one <= PI).
  { apply (below_le _ _ _ _ HP); [|exact mem_pi]; cbn [mem] in *.
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
  assert (Hl : 0 <= IZR l / IZR one) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat, H1]).
  assert (C : mem (join (cosine (Some (h, h))) (cosine (Some (l, l)))) (cos x)).
  { apply (mem_join _ _ _ _ _ (mem_cosine _ _ (mem_point h)) (mem_cosine _ _ (mem_point l))).
    split; apply cos_decr_1; lra. }
  cbn [fst snd]; split; [exact C|].
  replace (sin x) with (sqrt (1 - cos x * cos x)).
  - apply mem_root, mem_minus; [exact mem_1 | apply mem_times; exact C].
  - pose proof (sin2_cos2 x) as E; unfold Rsqr in E.
    replace (1 - cos x * cos x) with (sin x * sin x) by lra; apply sqrt_square, sin_ge_0; lra.
Qed.

(** ** asin: a guess 1/5000 off, confirmed by sin *)

Definition guess (y : Z) : Z :=
  let z := down (y * y) in
  (y + down (down (y * z) * (one / 6 + down (z * (3 * one / 40 + down (z * (15 * one / 336)))))))%Z.
Definition arcsine (X : itv) : itv := match X with
  | Some (l, h) =>
    let a := (guess l - one / 5000)%Z in let b := (guess h + one / 5000)%Z in
    if ((- one <=? a) && (a <=? one) && (- one <=? b) && (b <=? one) && (- one <=? l) && (h <=? one))%Z &&
       below (sine_small (Some (a, a))) (Some (l, l)) && below (Some (h, h)) (sine_small (Some (b, b)))
    then Some (a, b) else None
  | None => None end.

Lemma div_le a b : 0 < b -> - b <= a <= b -> -1 <= a / b <= 1.
Proof.
  intros Hb Ha; split; apply (Rmult_le_reg_r b); trivial; replace (a / b * b) with a by (field; lra); lra.
Qed.

Lemma mem_arcsine X x : mem X x -> mem (arcsine X) (asin x).
Proof.
  destruct X as [[l h]|]; [|trivial]; intros Hx; cbn [arcsine].
  set (a := (guess l - _)%Z); set (b := (guess h + _)%Z); cbv zeta.
  destruct (_ && _ && _) eqn:H; [|exact I].
  rewrite !andb_true_iff, !Z.leb_le in H; destruct H as [[[[[[[Ha Ha'] Hb'] Hb] Hl] Hh] Sa] Sb].
  apply IZR_le in Ha, Ha', Hb', Hb, Hl, Hh; rewrite opp_IZR in Ha, Hb', Hl; pose proof one_pos as H1.
  pose proof (div_le (IZR a) _ H1 (conj Ha Ha')) as Ba; pose proof (div_le (IZR b) _ H1 (conj Hb' Hb)) as Bb.
  pose proof (below_le _ _ _ _ Sa (mem_sine_small _ _ Ba (mem_point a)) (mem_point l)) as La.
  pose proof (below_le _ _ _ _ Sb (mem_point h) (mem_sine_small _ _ Bb (mem_point b))) as Lb.
  cbn [mem] in *.
  pose proof (ends _ _ _ Hx) as Hx1.
  assert (Hx2 : -1 <= x <= 1) by (split; apply (Rmult_le_reg_r (IZR one)); lra).
  pose proof PI2_3_2 as HP; pose proof (asin_bound x) as HB; pose proof (sin_asin x Hx2) as Hs.
  assert (A : IZR a / IZR one <= asin x) by (apply sin_incr_0; lra).
  assert (B : asin x <= IZR b / IZR one) by (apply sin_incr_0; lra).
  apply (Rmult_le_compat_r (IZR one)) in A, B; try lra.
  unfold Rdiv in A, B; rewrite Rmult_assoc, Rinv_l in A, B; lra.
Qed.
