(** * Affine forms in fixed point hold what they should: u_n and N_{n,k} on all of a box *)

From Coq Require Import Reals ZArith List Bool Lra Lia.
From Grazing Require Import Defs Statement StatementWords StatementZ StatementCircleZ StatementReaders
  StatementReaderWords Algebra WordAlgebra OrbitZ CircleZ ReaderCircle.
Import ListNotations. Open Scope R_scope.

(** A sign that is told is the sign of x. *)
Definition certain (t : Z) (x : R) : Prop := t = 1%Z /\ 0 < x \/ t = (-1)%Z /\ x < 0.
Definition told (t : option Z) (x : R) : Prop := forall z, t = Some z -> certain z x.

Lemma told_times t t' x x' : told t x -> told t' x' -> told (timesS t t') (x * x').
Proof.
  intros H H' z E; destruct t as [z1|], t' as [z2|]; try discriminate; injection E as <-; specialize (H z1 eq_refl);
    specialize (H' z2 eq_refl).
  destruct H as [[-> ?]|[-> ?]], H' as [[-> ?]|[-> ?]]; [left | right | right | left]; (split; [reflexivity | nra]).
Qed.
Lemma told_is e t x : told t x -> isS e t = true -> sgn e * x > 0.
Proof.
  intros H E; destruct t as [z|]; [|discriminate]; cbn [isS] in E; apply Z.ltb_lt in E; destruct (H z eq_refl)
    as [[-> ?]|[-> ?]]; destruct e; cbn [sgnZ sgn] in *; lia || lra.
Qed.
Lemma told_some t z x : told t x -> t = Some z -> x <> 0.
Proof. intros H E; destruct (H z E) as [[_ ?]|[_ ?]]; lra. Qed.

Section Forms.
Variable W : Z.
Hypothesis HW : (0 <= W)%Z.
Let unit := IZR (2 ^ W).
Variables x y : R.
Hypotheses (Hx : Rabs x <= 1) (Hy : Rabs y <= 1).

Definition holds (f : form) (t : R) : Prop := match f with (v, d, d', e) =>
  Rabs (unit * t - (IZR v + IZR d * x + IZR d' * y)) <= IZR e end.

Lemma unit_pos : 0 < unit. Proof. unfold unit; apply IZR_lt, Z.pow_pos_nonneg; lia. Qed.
Lemma shift_bound a : 0 <= IZR a / unit - IZR (Z.shiftr a W) < 1.
Proof.
  rewrite Z.shiftr_div_pow2 by assumption; pose proof unit_pos as P; unfold unit in *; set (s := (2 ^ W)%Z) in *.
  assert (Hs : (0 < s)%Z) by (apply lt_IZR; exact P).
  pose proof (Z.div_mod a s ltac:(lia)) as E; pose proof (Z.mod_pos_bound a s Hs) as [B1 B2]; set (m := (a / s)%Z) in *;
    set (l := (a mod s)%Z) in *.
  apply (f_equal IZR) in E; rewrite plus_IZR, mult_IZR in E; apply IZR_le in B1; apply IZR_lt in B2.
  replace (IZR a / IZR s - IZR m) with (IZR l / IZR s) by (rewrite E; field; lra).
  split; [apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]|].
  apply (Rmult_lt_reg_r (IZR s)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
Qed.
Lemma linear_bound d d' : Rabs (IZR d * x + IZR d' * y) <= IZR (Z.abs d + Z.abs d').
Proof.
  rewrite plus_IZR, !abs_IZR; apply Rle_trans with (1 := Rabs_triang _ _); rewrite !Rabs_mult.
  pose proof (Rabs_pos (IZR d)); pose proof (Rabs_pos (IZR d')); nra.
Qed.
Lemma size_bound f t : holds f t -> Rabs (unit * t) <= IZR (sizeF f).
Proof.
  destruct f as [[[v d] d'] e]; cbn [holds sizeF]; intros H; rewrite !plus_IZR, !abs_IZR.
  pose proof (linear_bound d d') as L; rewrite plus_IZR, !abs_IZR in L.
  replace (unit * t) with ((unit * t - (IZR v + IZR d * x + IZR d' * y)) + IZR v + (IZR d * x + IZR d' * y)) by ring.
  pose proof (Rabs_triang (unit * t - (IZR v + IZR d * x + IZR d' * y) + IZR v) (IZR d * x + IZR d' * y)).
  pose proof (Rabs_triang (unit * t - (IZR v + IZR d * x + IZR d' * y)) (IZR v)); lra.
Qed.
Lemma sub_holds f g t t' : holds f t -> holds g t' -> holds (subF f g) (t - t').
Proof.
  destruct f as [[[v d] d'] e], g as [[[w h] h'] l]; cbn [holds subF]; intros H H'; rewrite !minus_IZR, plus_IZR.
  replace (_ - _) with ((unit * t - (IZR v + IZR d * x + IZR d' * y)) - (unit * t' - (IZR w + IZR h * x + IZR h' * y)))
    by ring.
  unfold Rminus at 1; pose proof (Rabs_triang (unit * t - (IZR v + IZR d * x + IZR d' * y))
    (- (unit * t' - (IZR w + IZR h * x + IZR h' * y)))).
  rewrite Rabs_Ropp in *; lra.
Qed.
Lemma mul_holds f g t t' : holds f t -> holds g t' -> holds (mulF W f g) (t * t').
Proof.
  intros Hf Hg; pose proof (size_bound g t' Hg) as Sg; destruct f as [[[v d] d'] e], g as [[[w h] h'] l];
    pose proof unit_pos as P.
  unfold mulF; set (E := ((Z.abs d + Z.abs d') * (Z.abs h + Z.abs h') + e * sizeF (w, h, h', l) + sizeF (v, d, d', e)
    * l)%Z).
  cbv zeta; cbn [holds] in *; pose proof (shift_bound (v * w)) as [A1 A2]; pose proof (shift_bound (v * h + w * d))
    as [B1 B2]; pose proof (shift_bound (v * h' + w * d')) as [C1 C2]; pose proof (shift_bound E) as [D1 D2].
  set (A := IZR (Z.shiftr (v * w) W)) in *; set (B := IZR (Z.shiftr (v * h + w * d) W)) in *;
    set (C := IZR (Z.shiftr (v * h' + w * d') W)) in *.
  rewrite plus_IZR; set (D := IZR (Z.shiftr E W)) in *; set (a := IZR d * x + IZR d' * y);
    set (b := IZR h * x + IZR h' * y).
  set (eps := unit * t - (IZR v + IZR d * x + IZR d' * y)) in *;
    set (del := unit * t' - (IZR w + IZR h * x + IZR h' * y)) in *.
  pose proof (linear_bound d d') as La; fold a in La; pose proof (linear_bound h h') as Lb; fold b in Lb.
  assert (Lv : Rabs (IZR v + a) <= IZR (sizeF (v, d, d', e))).
  { cbn [sizeF]; rewrite !plus_IZR, !abs_IZR; rewrite plus_IZR, !abs_IZR in La; pose proof (Rabs_triang (IZR v) a);
      pose proof (Rabs_pos eps); lra. }
  set (rest := a * b + eps * (unit * t') + (IZR v + a) * del).
  assert (HR : Rabs rest <= IZR E).
  { unfold rest, E; set (al := (Z.abs d + Z.abs d')%Z) in *; set (be := (Z.abs h + Z.abs h')%Z) in *.
    rewrite !plus_IZR, !mult_IZR; apply Rle_trans with (1 := Rabs_triang _ _); apply Rplus_le_compat.
    - apply Rle_trans with (1 := Rabs_triang _ _); rewrite (Rabs_mult a b), (Rabs_mult eps (unit * t'));
        apply Rplus_le_compat; apply Rmult_le_compat; try apply Rabs_pos; assumption.
    - rewrite Rabs_mult; apply Rmult_le_compat; try apply Rabs_pos; assumption. }
  replace (unit * (t * t') - (A + B * x + C * y)) with ((IZR (v * w) / unit - A) + (IZR (v * h + w * d) / unit - B) * x
    + (IZR (v * h' + w * d') / unit - C) * y + rest / unit).
  2: { unfold rest, del, eps, a, b; rewrite !plus_IZR, !mult_IZR; field; lra. }
  assert (HRU : Rabs (rest / unit) <= IZR E / unit).
  { unfold Rdiv; rewrite Rabs_mult, (Rabs_right (/ unit)) by (left; apply Rinv_0_lt_compat; exact P).
    apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; exact P | exact HR]. }
  assert (Small : forall r z, 0 <= r < 1 -> Rabs z <= 1 -> Rabs (r * z) <= 1).
  { intros r z Hr Hz; rewrite Rabs_mult, (Rabs_right r) by lra; pose proof (Rabs_pos z); nra. }
  pose proof (Small _ _ (conj B1 B2) Hx) as SB; pose proof (Small _ _ (conj C1 C2) Hy) as SC.
  set (r1 := IZR (v * w) / unit - A) in *; set (r2 := (IZR (v * h + w * d) / unit - B) * x) in *;
    set (r3 := (IZR (v * h' + w * d') / unit - C) * y) in *.
  pose proof (Rabs_triang (r1 + r2 + r3) (rest / unit)); pose proof (Rabs_triang (r1 + r2) r3);
    pose proof (Rabs_triang r1 r2).
  rewrite (Rabs_right r1) in * by lra; lra.
Qed.
Lemma sign_told f t : holds f t -> told (signF f) t.
Proof.
  destruct f as [[[v d] d'] e]; cbn [holds signF]; intros H z E; pose proof (linear_bound d d') as L;
    pose proof unit_pos as P.
  replace (unit * t - (IZR v + IZR d * x + IZR d' * y)) with (unit * t - (IZR v + (IZR d * x + IZR d' * y))) in H
    by ring.
  set (a := IZR d * x + IZR d' * y) in *.
  assert (HB : - IZR e <= unit * t - (IZR v + a) <= IZR e) by (revert H; unfold Rabs; destruct (Rcase_abs _); lra).
  assert (LB : - IZR (Z.abs d + Z.abs d') <= a <= IZR (Z.abs d + Z.abs d')) by (revert L; unfold Rabs;
    destruct (Rcase_abs _); lra).
  destruct (Z.ltb_spec (Z.abs d + Z.abs d' + e) v) as [Q|_].
  - injection E as <-; left; split; [reflexivity|]; apply IZR_lt in Q; rewrite plus_IZR in Q; nra.
  - destruct (Z.ltb_spec v (- (Z.abs d + Z.abs d' + e))) as [Q|_]; [|discriminate].
    injection E as <-; right; split; [reflexivity|]; apply IZR_lt in Q; rewrite opp_IZR, plus_IZR in Q; nra.
Qed.
Lemma one_holds : holds (oneF W) 1.
Proof. cbn [holds oneF]; fold unit; rewrite !Rmult_0_l, Rabs_right; lra. Qed.
Lemma zero_holds : holds zeroF 0.
Proof. cbn [holds zeroF]; rewrite !Rmult_0_l, Rmult_0_r, Rabs_right; lra. Qed.

Variables (B : box) (a1 a2 : R).
Hypotheses (H1 : holds (a1F W B) a1) (H2 : holds (a2F W B) a2).

Lemma u_length n : length (uF W B n) = S n.
Proof. induction n as [|n IH]; cbn; [reflexivity | rewrite IH; reflexivity]. Qed.
Lemma pow_length n : length (powF W B n) = S n.
Proof. induction n as [|n IH]; cbn; [reflexivity | rewrite IH; reflexivity]. Qed.
Lemma u_holds n : forall k, (k <= n)%nat -> holds (nth (n - k) (uF W B n) zeroF) (u a1 a2 k).
Proof.
  induction n as [|n IH]; intros k Hk; [assert (k = 0%nat) as -> by lia; rewrite u_0; exact zero_holds|].
  cbn [uF]; destruct (Nat.eq_dec k (S n)) as [->|Hne].
  2: { replace (S n - k)%nat with (S (n - k)) by lia; cbn [nth]; apply IH; lia. }
  rewrite Nat.sub_diag; cbn [nth]; destruct n as [|n]; [rewrite u_1; exact one_holds|].
  pose proof (IH (S n) (le_n _)) as Hf; pose proof (IH n ltac:(lia)) as Hg; rewrite Nat.sub_diag in Hf;
    replace (S n - n)%nat with 1%nat in Hg by lia.
  pose proof (u_length (S n)) as Len; destruct (uF W B (S n)) as [|f [|g us]]; try discriminate; cbn [nth] in Hf, Hg.
  rewrite u_SS; apply sub_holds; apply mul_holds; assumption.
Qed.
Lemma pow_holds n : forall k, (k <= n)%nat -> holds (nth (n - k) (powF W B n) zeroF) (a2 ^ k).
Proof.
  induction n as [|n IH]; intros k Hk; [assert (k = 0%nat) as -> by lia; exact one_holds|].
  cbn [powF]; destruct (Nat.eq_dec k (S n)) as [->|Hne].
  2: { replace (S n - k)%nat with (S (n - k)) by lia; cbn [nth]; apply IH; lia. }
  rewrite Nat.sub_diag; cbn [nth]; pose proof (IH n (le_n _)) as Hf; rewrite Nat.sub_diag in Hf.
  pose proof (pow_length n) as Len; destruct (powF W B n) as [|f ps]; try discriminate; cbn [nth] in Hf; cbn [pow];
    apply mul_holds; assumption.
Qed.
Lemma u_row n k : (k <= n)%nat -> holds (nth k (rev (uF W B n)) zeroF) (u a1 a2 k).
Proof. intros Hk; rewrite rev_nth by (rewrite u_length; lia); rewrite u_length; replace (S n - S k)%nat with (n - k)%nat
    by lia; apply u_holds, Hk. Qed.
Lemma pow_row n k : (k <= n)%nat -> holds (nth k (rev (powF W B n)) zeroF) (a2 ^ k).
Proof. intros Hk; rewrite rev_nth by (rewrite pow_length; lia); rewrite pow_length; replace (S n - S k)%nat
    with (n - k)%nat by lia; apply pow_holds, Hk. Qed.
Lemma u_told n k : told (on_u (signsZ W B n) k) (u a1 a2 k).
Proof.
  cbn [signsZ on_u]; unfold signU; destruct (le_lt_dec k n) as [L|L]; [apply sign_told, u_row, L|].
  rewrite nth_overflow by (rewrite rev_length, u_length; lia); intros z E; discriminate.
Qed.
Lemma N_told n l k : told (on_N (signsZ W B n) l k) (N a1 a2 l k).
Proof.
  cbn [signsZ on_N]; unfold signN; rewrite !rev_length, u_length, pow_length.
  destruct (Nat.leb_spec (S n) k), (Nat.leb_spec (S n) l), (Nat.ltb_spec l k); cbn [orb];
    try (intros z E; discriminate).
  unfold N; apply sign_told, sub_holds; [apply sub_holds; apply u_row; lia|].
  apply mul_holds; [apply pow_row; lia | apply u_row; lia].
Qed.
End Forms.

(** ** Boxes *)

Lemma fraction_bounds W h : (0 < snd h)%Z -> (0 <= W)%Z -> IZR (fst h * 2 ^ W / snd h) <= IZR (2 ^ W) * fraction h
  <= IZR (- (- (fst h * 2 ^ W) / snd h)).
Proof.
  intros Hh HW; assert (Div : forall a, IZR (a / snd h) <= IZR a / IZR (snd h)).
  { intros a; pose proof (Z.mul_div_le a (snd h) Hh) as Q; apply IZR_le in Q; rewrite mult_IZR in Q;
      pose proof (IZR_lt _ _ Hh).
    apply (Rmult_le_reg_r (IZR (snd h))); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
  assert (E : IZR (2 ^ W) * fraction h = IZR (fst h * 2 ^ W) / IZR (snd h)) by (unfold fraction; rewrite mult_IZR;
    unfold Rdiv; ring).
  rewrite E; split; [apply Div|]; pose proof (Div (- (fst h * 2 ^ W))%Z) as D; rewrite opp_IZR in D |- *.
  unfold Rdiv in *; rewrite Ropp_mult_distr_l_reverse in D; lra.
Qed.
Lemma middle_holds W h h' a : (0 <= W)%Z -> (0 < snd h)%Z -> (0 < snd h')%Z -> fraction h <= a <= fraction h' ->
  exists x, Rabs x <= 1 /\ IZR (2 ^ W) * a = IZR (fst (middleF W h h')) + IZR (snd (middleF W h h')) * x.
Proof.
  intros HW Hh Hh' Ha; unfold middleF; cbv zeta; cbn [fst snd]; destruct (fraction_bounds W h Hh HW) as [A _],
    (fraction_bounds W h' Hh' HW) as [_ B].
  set (low := (fst h * 2 ^ W / snd h)%Z) in *; set (high := (- (- (fst h' * 2 ^ W) / snd h'))%Z) in *;
    set (v := ((low + high) / 2)%Z).
  assert (P : 0 < IZR (2 ^ W)) by (apply IZR_lt, Z.pow_pos_nonneg; lia).
  assert (Hlow : IZR low <= IZR (2 ^ W) * a) by nra; assert (Hhigh : IZR (2 ^ W) * a <= IZR high) by nra;
    set (t := IZR (2 ^ W) * a) in *.
  set (d := Z.max (high - v) (v - low)); assert (D1 : (high - v <= d)%Z) by lia; assert (D2 : (v - low <= d)%Z) by lia.
  apply IZR_le in D1, D2; rewrite minus_IZR in D1, D2; destruct (Req_dec (IZR d) 0) as [Z0|NZ].
  - exists 0; rewrite Rabs_R0, Z0; split; lra.
  - assert (0 < IZR d) by lra; exists ((t - IZR v) / IZR d); split; [|field; assumption].
    unfold Rdiv; rewrite Rabs_mult, (Rabs_right (/ IZR d)) by (left; apply Rinv_0_lt_compat; assumption).
    apply (Rmult_le_reg_r (IZR d)); [assumption|]; rewrite Rmult_assoc, Rinv_l, Rmult_1_l, Rmult_1_r by lra;
      apply Rabs_le; lra.
Qed.
Definition positive_box (B : box) : Prop := match B with (h, h', l, l') => (0 < snd h /\ 0 < snd h' /\ 0 < snd l /\
  0 < snd l')%Z end.

Lemma box_true B a1 a2 : boxZ B = true -> in_box B a1 a2 -> positive_box B /\ 0 < a2 <= 1.
Proof.
  destruct B as [[[h h'] l] l']; cbn [boxZ in_box positive_box]; rewrite !andb_true_iff, !Z.ltb_lt, !negb_true_iff.
  intros [[[[[[[A B] C] D] E] F] _] _] [_ [L U]]; split; [tauto|]; pose proof (IZR_lt _ _ C); pose proof (IZR_lt _ _ E);
    split.
  - apply Rlt_le_trans with (2 := L); unfold fraction; apply Rdiv_lt_0_compat; assumption.
  - apply Rle_trans with (1 := U); apply Rnot_lt_le; intros Q; assert (One : fraction (1, 1)%Z = 1) by (unfold fraction;
      cbn [fst snd]; field).
    rewrite <- One in Q; apply (fraction_less (1, 1)%Z l') in Q; [congruence | reflexivity | exact D].
Qed.
Lemma forms_exist W B a1 a2 : (0 <= W)%Z -> positive_box B -> in_box B a1 a2 -> exists x y, Rabs x <= 1 /\
  Rabs y <= 1 /\ holds W x y (a1F W B) a1 /\ holds W x y (a2F W B) a2.
Proof.
  destruct B as [[[h h'] l] l']; intros HW (A & B & C & D) [H1 H2].
  destruct (middle_holds W h h' a1 HW A B H1) as (x & Hx & Ex), (middle_holds W l l' a2 HW C D H2) as (y & Hy & Ey).
  exists x, y; split; [exact Hx | split; [exact Hy|]]; unfold a1F, a2F; destruct (middleF W h h') as [v d],
    (middleF W l l') as [w e]; cbn [fst snd holds] in *.
  rewrite Ex, Ey; split; (rewrite Rabs_right; lra).
Qed.
Lemma signs_told W B n a1 a2 : (0 <= W)%Z -> boxZ B = true -> in_box B a1 a2 ->
  (forall k, told (on_u (signsZ W B n) k) (u a1 a2 k)) /\ (forall l k, told (on_N (signsZ W B n) l k) (N a1 a2 l k)) /\
  forall k, on_zero (signsZ W B n) k = true -> u a1 a2 k = 0.
Proof.
  intros HW HB Hin; destruct (box_true B a1 a2 HB Hin) as [HP _]; destruct (forms_exist W B a1 a2 HW HP Hin)
    as (x & y & Hx & Hy & H1 & H2).
  split; [intros k; apply (u_told W HW x y Hx Hy B a1 a2 H1 H2)|]; split;
    [intros l k; apply (N_told W HW x y Hx Hy B a1 a2 H1 H2)|].
  intros k E; cbn [signsZ on_zero] in E; destruct B as [[[h h'] l] l']; cbn [vanishZ in_box positive_box] in *.
  rewrite !andb_true_iff, Z.eqb_eq in E; destruct E as [[E1 E2] E]; apply same_true in E1, E2; subst h' l'.
  destruct HP as (A & _ & B & _), Hin as [I1 I2]; pose proof (IZR_lt _ _ A); pose proof (IZR_lt _ _ B).
  apply (uZ_zero _ _ (snd h * snd l) (Z.mul_pos_pos _ _ A B)) in E;
    replace a1 with (IZR (fst h * snd l) / IZR (snd h * snd l));
    [replace a2 with (IZR (fst l * snd h) / IZR (snd h * snd l)); [exact E|]|].
  - replace a2 with (fraction l) by lra; unfold fraction; rewrite !mult_IZR; field; split; lra.
  - replace a1 with (fraction h) by lra; unfold fraction; rewrite !mult_IZR; field; split; lra.
Qed.
