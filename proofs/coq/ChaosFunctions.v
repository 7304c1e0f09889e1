(** * exp, cos and sin of an interval with integer ends lie in the intervals computed for them *)

From Coq Require Import Reals ZArith Lra Lia Bool Machin.
From Grazing Require Import ChaosInterval Derivatives.
Open Scope R_scope.

(** ** exp: its series to the fifth power at x/16, which is below it, and 1 over that at - x/16; squared four times *)

(** Named, so that they are computed once. *)
Definition unit : itv := constant 1 1.
Definition half : itv := constant 1 2.
Definition third : itv := constant 1 3.
Definition c4 : itv := constant 1 4.
Definition c5 : itv := constant 1 5.
Definition c12 : itv := constant 1 12.
Definition c16 : itv := constant 1 16.
Definition c30 : itv := constant 1 30.
Definition c56 : itv := constant 1 56.
Definition c90 : itv := constant 1 90.
Definition c132 : itv := constant 1 132.

Fixpoint squares (n : nat) (X : itv) : itv := match n with O => X | S n => squares n (times X X) end.
Definition join (X Y : itv) : itv := match X, Y with
  | Some (a, _), Some (_, d) => Some (a, d) | _, _ => None end.
Definition exp_series (Y : itv) : itv :=
  let step q X := plus unit (times (times Y q) X) in step unit (step half (step third (step c4 (step c5 unit)))).
Definition exponential (X : itv) : itv :=
  let Y := times X c16 in let Z := exp_series (opp Y) in
  if positive Z then squares 4 (join (exp_series Y) (inverse Z)) else None.

Lemma mem_join X Y x y z : mem X x -> mem Y y -> x <= z <= y -> mem (join X Y) z.
Proof. destruct X as [[]|], Y as [[]|]; cbn; trivial; intros; pose proof one_pos; split; nra. Qed.

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

Lemma twice_up f f' f'' : (forall x, derivable_pt_lim f x (f' x)) -> (forall x, derivable_pt_lim f' x (f'' x)) ->
  f 0 = 0 -> f' 0 = 0 -> (forall x, 0 <= f'' x) -> forall x, 0 <= f x.
Proof.
  intros D D' E E' H x; destruct (Rtotal_order x 0) as [L|[->|L]]; [|lra|].
  - destruct (MVT_cor2 f f' x 0 L) as (y & Ey & Hy); [auto|].
    destruct (MVT_cor2 f' f'' y 0 ltac:(lra)) as (z & Ez & Hz); [auto|]; specialize (H z).
    assert (0 <= f'' z * (0 - y)) by (apply Rmult_le_pos; lra); nra.
  - destruct (MVT_cor2 f f' 0 x L) as (y & Ey & Hy); [auto|].
    destruct (MVT_cor2 f' f'' 0 y ltac:(lra)) as (z & Ez & Hz); [auto|]; specialize (H z).
    assert (0 <= f'' z * (y - 0)) by (apply Rmult_le_pos; lra); nra.
Qed.

Definition exp_step (y q x : R) : R := 1 + y * (1 / q) * x.
Definition exp_sum (y : R) : R := exp_step y 1 (exp_step y 2 (exp_step y 3 (exp_step y 4 (exp_step y 5 1)))).
Lemma exp_sum_below y : exp_sum y <= exp y.
Proof.
  set (r1 := fun x => exp x - (1 + x)); set (r2 := fun x => r1 x - x * x / 2).
  set (r3 := fun x => r2 x - x * x * x / 6); set (r4 := fun x => r3 x - x * x * x * x / 24).
  set (r5 := fun x => r4 x - x * x * x * x * x / 120). assert (E : r1 0 = 0) by (unfold r1; rewrite exp_0; ring).
  assert (H3 : forall x, 0 <= r3 x).
  { apply (twice_up _ r2 r1); try (unfold r3, r2; rewrite E; lra).
    - intros x; unfold r3, r2, r1, Rdiv; derive_by fail; field.
    - intros x; unfold r2, r1, Rdiv; derive_by fail; field.
    - intros x; unfold r1; pose proof (exp_ineq1_le x); lra. }
  assert (H5 : forall x, 0 <= r5 x).
  { apply (twice_up _ r4 r3); try (unfold r5, r4, r3, r2; rewrite E; lra); trivial.
    - intros x; unfold r5, r4, r3, r2, r1, Rdiv; derive_by fail; field.
    - intros x; unfold r4, r3, r2, r1, Rdiv; derive_by fail; field. }
  specialize (H5 y); unfold r5, r4, r3, r2, r1 in H5; unfold exp_sum, exp_step; lra.
Qed.
Lemma mem_exp_series Y y : mem Y y -> mem (exp_series Y) (exp_sum y).
Proof.
  intros HY; unfold exp_series, exp_sum; cbv zeta beta.
  assert (HS : forall q X x, mem X x -> mem (plus unit (times (times Y (constant 1 q)) X)) (exp_step y (IZR (Z.pos q))
    x)).
  { intros q X x HX; unfold exp_step; repeat first [exact HX | exact HY | apply mem_plus | apply mem_times |
      apply mem_constant | exact mem_1]. }
  repeat apply HS; exact mem_1.
Qed.

Lemma mem_exponential X x : mem X x -> mem (exponential X) (exp x).
Proof.
  intros Hx; unfold exponential; cbv zeta.
  pose proof (mem_times _ _ _ _ Hx (mem_constant 1 16)) as HY; change (constant 1 16) with c16 in HY.
  set (Y := times _ _) in *; set (y := x * (1 / 16)) in *.
  pose proof (mem_exp_series _ _ HY) as P; pose proof (mem_exp_series _ _ (mem_opp _ _ HY)) as N.
  destruct (positive _) eqn:B; [|exact I]; apply mem_squares; replace (x / 2 ^ 4) with y by (unfold y; cbn; field).
  pose proof (positive_lt _ _ B N) as N0; apply (mem_join _ _ _ _ _ P (mem_inverse _ _ N)).
  split; [apply exp_sum_below|]; rewrite <- (Ropp_involutive y) at 1; rewrite exp_Ropp.
  apply Rinv_le_contravar; [exact N0 | apply exp_sum_below].
Qed.

(** ** cos: near 0, by whole turns; its series at x/4, then cos 2x = 2 cos^2 x - 1 twice, about the middle *)

(** Twice. *)
Definition double (X : itv) : itv := match X with Some (l, h) => Some (2 * l, 2 * h)%Z | None => None end.

Fixpoint doubled (n : nat) (X : itv) : itv := match n with
  | O => X | S n => doubled n (minus (double (times X X)) unit) end.
Definition cos_small (Y : itv) : itv :=
  let Z := times Y Y in
  let step q X := minus unit (times (times Z q) X) in
  let series X := step half (step c12 (step c30 (step c56 (step c90 X)))) in
  join (series unit) (series (minus unit (times Z c132))).
Definition cosine_middle (X : itv) : itv := match X with
  | Some (l, h) =>
    let m := Z.shiftr (l + h) 1 in
    if (Z.abs m <=? 4 * one)%Z then
      plus (doubled 2 (cos_small (times (Some (m, m)) c4))) (Some (m - h, h - m)%Z)
    else None
  | None => None end.

Definition cos_step (z q x : R) : R := 1 - z * (1 / q) * x.
Definition cos_sum (z x : R) : R := cos_step z 2 (cos_step z 12 (cos_step z 30 (cos_step z 56 (cos_step z 90 x)))).
Lemma cos_series y : -1 <= y <= 1 -> cos_sum (y * y) 1 <= cos y <= cos_sum (y * y) (1 - y * y * (1 / 132)).
Proof.
  intros Hy; pose proof PI2_3_2 as HP; destruct (cos_bound y 2) as [L U]; [lra|lra|].
  cbn [Nat.mul Nat.add] in L, U; unfold cos_approx in *; cbn [sum_f_R0] in *; unfold cos_term in *.
  cbn [Nat.mul Nat.add] in *.
  rewrite (fact_simpl 11), (fact_simpl 10) in U; rewrite (fact_simpl 9), (fact_simpl 8), (fact_simpl 7), (fact_simpl 6)
    in *.
  rewrite !mult_INR in *. replace (INR 12) with 12 in U by (cbn; ring); replace (INR 11) with 11 in U by (cbn; ring).
  replace (INR 10) with 10 in * by (cbn; ring); replace (INR 9) with 9 in * by (cbn; ring).
  replace (INR 8) with 8 in * by (cbn; ring); replace (INR 7) with 7 in * by (cbn; ring).
  replace (INR (fact 0)) with 1 in * by reflexivity; replace (INR (fact 2)) with 2 in * by (cbn; ring).
  replace (INR (fact 4)) with 24 in * by (cbn; ring).
  replace (INR (fact 6)) with 720 in * by (rewrite INR_IZR_INZ; reflexivity).
  unfold cos_sum, cos_step; split; [eapply Rle_trans; [|exact L] | eapply Rle_trans; [exact U|]]; right; field.
Qed.

Lemma cos_lipschitz x y : Rabs (cos x - cos y) <= Rabs (x - y).
Proof.
  rewrite form2.
  replace (Rabs (x - y)) with (Rabs (-2 * ((x - y) / 2) * 1)) by (rewrite Rabs_minus_sym; f_equal; field).
  rewrite !Rabs_mult; apply Rmult_le_compat.
  - apply Rmult_le_pos; apply Rabs_pos.
  - apply Rabs_pos.
  - apply Rmult_le_compat_l; [apply Rabs_pos|]. set (z := (x - y) / 2).
    assert (H : forall z, 0 <= z -> Rabs (sin z) <= z).
    { intros u Hu; destruct (Rle_lt_or_eq_dec _ _ Hu) as [Hu'|<-]; [|rewrite sin_0, Rabs_R0; lra].
      destruct (Rle_lt_dec 1 u).
      - pose proof (SIN_bound u); apply Rabs_le; lra.
      - pose proof (sin_lt_x u Hu'); pose proof PI2_3_2. pose proof (sin_gt_0 u Hu'); rewrite Rabs_pos_eq; lra. }
    destruct (Rle_lt_dec 0 z); [rewrite (Rabs_pos_eq z) by lra; auto|].
    rewrite (Rabs_left z) by lra; rewrite <- (Ropp_involutive z), sin_neg, Rabs_Ropp, Ropp_involutive. apply H; lra.
  - rewrite Rabs_R1; pose proof (SIN_bound ((x + y) / 2)); apply Rabs_le; lra.
Qed.

Lemma mem_double X x : mem X x -> mem (double X) (2 * x).
Proof. destruct X as [[l h]|]; [|trivial]; cbn [mem double]; rewrite !mult_IZR; lra. Qed.
Lemma mem_doubled n X x : mem X (cos (x / 2 ^ n)) -> mem (doubled n X) (cos x).
Proof.
  revert X; induction n as [|n IH]; intros X H; cbn [doubled].
  - replace (x / 2 ^ 0) with x in H by (cbn; field); exact H.
  - apply IH; replace (x / 2 ^ n) with (2 * (x / 2 ^ S n)) by (cbn; field; apply pow_nonzero; lra).
    rewrite cos_2a_cos, Rmult_assoc; apply mem_minus; [apply mem_double, mem_times; exact H | exact mem_1].
Qed.

Lemma mem_cos_small Y y : -1 <= y <= 1 -> mem Y y -> mem (cos_small Y) (cos y).
Proof.
  intros Hy HY; unfold cos_small; cbv zeta beta.
  assert (HS : forall q X x, mem X x -> mem (minus unit (times (times (times Y Y) (constant 1 q)) X))
    (cos_step (y * y) (IZR (Z.pos q)) x)).
  { intros q X x HX; unfold cos_step; repeat first [exact HX | exact HY | apply mem_minus | apply mem_times |
      apply mem_constant | exact mem_1]. }
  eapply mem_join; [| |exact (cos_series y Hy)]; unfold cos_sum; repeat (apply HS); [exact mem_1|].
  apply mem_minus; [exact mem_1 | repeat apply mem_times; try exact HY; apply (mem_constant 1 132)].
Qed.

Lemma middle x y h m o c l : y * o = m -> 0 < o -> l <= x * o <= h -> 2 * m <= l + h ->
  Rabs c <= Rabs (x - y) -> m - h <= c * o <= h - m.
Proof.
  intros E Ho Hx Hm Hc.
  assert (D : Rabs (x - y) * o <= h - m).
  { rewrite <- (Rabs_pos_eq o) at 1 by lra; rewrite <- Rabs_mult; apply Rabs_le; lra. }
  assert (Hc' : - Rabs c <= c <= Rabs c) by (unfold Rabs; destruct (Rcase_abs c); lra). nra.
Qed.

Lemma mem_cosine_middle X x : mem X x -> mem (cosine_middle X) (cos x).
Proof.
  destruct X as [[l h]|]; [|trivial]; intros Hx; cbn [cosine_middle].
  set (m := Z.shiftr (l + h) 1); destruct (Z.leb_spec (Z.abs m) (4 * one)) as [Hm|]; [|exact I].
  pose proof one_pos as H1. assert (exists y, y * IZR one = IZR m) as [y Ey] by (exists (IZR m / IZR one); field; lra).
  assert (Hy : mem (Some (m, m)) y) by (cbn [mem]; lra). pose proof (mem_times _ _ _ _ Hy (mem_constant 1 4)) as HY.
  assert (B : -1 <= y * (1 / 4) <= 1).
  { assert (A1 : IZR m <= IZR (4 * one)) by (apply IZR_le; lia).
    assert (A2 : IZR (- (4 * one)) <= IZR m) by (apply IZR_le; lia). rewrite opp_IZR in A2; rewrite mult_IZR in A1, A2.
    assert (A : -4 <= y <= 4) by (split; apply (Rmult_le_reg_r (IZR one)); lra); lra. }
  pose proof (mem_cos_small _ _ B HY) as C.
  replace (y * (1 / 4)) with (y / 2 ^ 2) in C by (cbn; field); apply mem_doubled in C.
  replace (cos x) with (cos y + (cos x - cos y)) by ring; apply mem_plus; [exact C|].
  pose proof (cos_lipschitz x y) as L.
  assert (Hmid : (l + h - 1 <= 2 * m <= l + h)%Z).
  { unfold m; rewrite Z.shiftr_div_pow2 by lia; change (2 ^ 1)%Z with 2%Z.
    pose proof (Z.div_mod (l + h) 2); pose proof (Z.mod_pos_bound (l + h) 2); lia. }
  cbn [mem] in *; rewrite !minus_IZR. assert (A : IZR (2 * m) <= IZR (l + h)) by (apply IZR_le; lia).
  rewrite plus_IZR, mult_IZR in A. exact (middle _ _ _ _ _ _ _ Ey H1 Hx A L).
Qed.

(** ** pi, from its series; sin x = cos (pi/2 - x) *)

Definition pi : itv := join (constant 314159265 100000000) (constant 314159266 100000000).

Lemma mem_pi : mem pi PI.
Proof.
  apply (mem_join _ _ _ _ _ (mem_constant 314159265 100000000) (mem_constant 314159266 100000000)).
  pose proof (PI_2_3_7_ineq 4) as H; cbn [sum_f_R0 Nat.mul Nat.add] in H.
  unfold tg_alt, PI_2_3_7_tg, Ratan_seq in H; rewrite !INR_IZR_INZ in H.
  cbn [Nat.mul Nat.add Z.of_nat Pos.of_succ_nat Pos.succ] in H; cbn [pow] in H; lra.
Qed.

Lemma mem_point m : mem (Some (m, m)) (IZR m / IZR one).
Proof. pose proof one_pos; cbn [mem]; replace (IZR m / IZR one * IZR one) with (IZR m) by (field; lra); lra. Qed.

Lemma ends x l h : mem (Some (l, h)) x -> IZR l / IZR one <= x <= IZR h / IZR one.
Proof.
  pose proof one_pos; cbn [mem]; intros Hx.
  split; apply (Rmult_le_reg_r (IZR one)); trivial; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
Qed.

(** cos decreases on [0, pi], and cos (- x) = cos x. *)
Definition cosine_near (X : itv) : itv := match X with
  | Some (l, h) =>
    let a := Z.max 0 (Z.max l (- h)) in let b := Z.max (- l) h in
    if (h - l <? one / 1000000)%Z then cosine_middle X else
    if below (Some (b, b)) pi then join (cosine_middle (Some (b, b))) (cosine_middle (Some (a, a)))
    else cosine_middle X
  | None => None end.

Lemma mem_cosine_near X x : mem X x -> mem (cosine_near X) (cos x).
Proof.
  destruct X as [[l h]|]; [|trivial]; intros Hx; cbn [cosine_near]; set (a := Z.max 0 _); set (b := Z.max (- l) h).
  destruct (h - l <? one / 1000000)%Z; [apply mem_cosine_middle, Hx|].
  destruct (below (Some (b, b)) pi) eqn:HP; [|apply mem_cosine_middle, Hx].
  pose proof (below_le _ _ _ _ HP (mem_point b) mem_pi) as Hb; pose proof one_pos as H1.
  pose proof (mem_size _ _ Hx) as HS; cbn [size] in HS; fold b in HS; apply ends in HS.
  assert (A : IZR a / IZR one <= Rabs x).
  { apply (Rmult_le_reg_r (IZR one)); trivial; unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    replace (Rabs x * IZR one) with (Rabs (x * IZR one)) by (rewrite Rabs_mult, (Rabs_pos_eq (IZR one)); lra).
    cbn [mem] in Hx; unfold a; apply Z.max_case_strong; intros _; [apply Rabs_pos|].
    apply Z.max_case_strong; intros _; [pose proof (Rle_abs (x * IZR one)); lra|].
    rewrite opp_IZR; pose proof (Rle_abs (- (x * IZR one))); rewrite Rabs_Ropp in *; lra. }
  assert (A0 : 0 <= IZR a / IZR one).
  { apply Rmult_le_pos; [apply IZR_le, Z.le_max_l | left; apply Rinv_0_lt_compat, H1]. }
  replace (cos x) with (cos (Rabs x)) by (unfold Rabs; destruct Rcase_abs; [apply cos_neg | reflexivity]).
  apply (mem_join _ _ _ _ _ (mem_cosine_middle _ _ (mem_point b)) (mem_cosine_middle _ _ (mem_point a))).
  pose proof (Rabs_pos x); split; apply cos_decr_1; lra.
Qed.

(** By the whole turns next to the middle; 2 pi is about 1686629713/2^28. *)
Definition cosine (X : itv) : itv := match X with
  | Some (l, h) => let z := (((l + h + 1686629713) / 3373259426) * one)%Z in
    cosine_near (minus X (times (double pi) (Some (z, z))))
  | None => None end.
Lemma mem_cosine X x : mem X x -> mem (cosine X) (cos x).
Proof.
  destruct X as [[l h]|]; [|trivial]; intros Hx; unfold cosine; set (k := (_ / _)%Z); cbv zeta.
  pose proof one_pos; rewrite <- (cos_periods (- k) x), opp_IZR.
  replace (x + 2 * PI * - IZR k) with (x - 2 * PI * IZR k) by ring; apply mem_cosine_near, mem_minus; [exact Hx|].
  apply mem_times; [apply mem_double, mem_pi | cbn [mem]; rewrite mult_IZR; lra].
Qed.

Definition right : itv := times pi half.
Definition sine (X : itv) : itv := cosine (minus right X).

Lemma mem_sine X x : mem X x -> mem (sine X) (sin x).
Proof.
  intros Hx; rewrite <- cos_shift; apply mem_cosine, mem_minus; [|exact Hx].
  replace (PI / 2) with (PI * (1 / 2)) by field; apply mem_times; [exact mem_pi | apply mem_constant].
Qed.

(** cos and sin on [0, pi]: there cos decreases, and sin x = sqrt (1 - cos^2 x). *)
Definition circle (X : itv) : itv * itv := match X with
  | Some (l, h) =>
    if (0 <=? l)%Z && below X pi then
      let c := join (cosine (Some (h, h))) (cosine (Some (l, l))) in
      (c, root (minus unit (times c c)))
    else (None, None)
  | None => (None, None) end.

Lemma mem_circle X x : mem X x -> mem (fst (circle X)) (cos x) /\ mem (snd (circle X)) (sin x).
Proof.
  destruct X as [[l h]|]; [|split; exact I]; intros Hx; cbn [circle].
  destruct (_ && _) eqn:H; [|split; exact I]; apply andb_prop in H; destruct H as [H0 HP].
  apply Z.leb_le, IZR_le in H0; pose proof one_pos as H1; pose proof (ends _ _ _ Hx) as Hx1.
  assert (Hh : IZR h / IZR one <= PI).
  { apply (below_le _ _ _ _ HP); [|exact mem_pi]; cbn [mem] in *. unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
  assert (Hl : 0 <= IZR l / IZR one) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat, H1]).
  assert (C : mem (join (cosine (Some (h, h))) (cosine (Some (l, l)))) (cos x)).
  { apply (mem_join _ _ _ _ _ (mem_cosine _ _ (mem_point h)) (mem_cosine _ _ (mem_point l))).
    split; apply cos_decr_1; lra. }
  cbn [fst snd]; split; [exact C|]. replace (sin x) with (sqrt (1 - cos x * cos x)).
  - apply mem_root, mem_minus; [exact mem_1 | apply mem_times; exact C].
  - pose proof (sin2_cos2 x) as E; unfold Rsqr in E.
    replace (1 - cos x * cos x) with (sin x * sin x) by lra; apply sqrt_square, sin_ge_0; lra.
Qed.

(** The same of any x. *)
Definition angle (X : itv) : itv * itv := match circle X with
  | (Some C, Some D) => (Some C, Some D) | _ => (cosine X, sine X) end.
Lemma mem_angle X x : mem X x -> mem (fst (angle X)) (cos x) /\ mem (snd (angle X)) (sin x).
Proof.
  intros H; unfold angle; pose proof (mem_circle _ _ H) as [A B]; revert A B.
  destruct (circle X) as [[C|] [D|]]; cbn [fst snd]; auto using mem_cosine, mem_sine.
Qed.
