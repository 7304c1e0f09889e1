(** * A leg contracts (H2), and the gap is positive on it (H4), from the finite checks *)

From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import ChaosFlow ChaosChecks.
Open Scope R_scope.

(** ** A leg depends on s and s' with the bounds of H2 *)

Lemma D_phase nu f x l : Rabs (nu * f x * (1 / 2)) < 1 -> derivable_pt_lim f x l ->
  derivable_pt_lim (fun y => phase nu (f y)) x (- (nu / 2) / cos (phase nu (f x)) * l).
Proof.
  intros Hy Hf; rewrite cos_phase by exact Hy; apply Rabs_def2 in Hy; destruct Hy as [Hy1 Hy2].
  assert (Hr : -1 < nu * f x * (1 / 2) < 1) by lra.
  assert (D : derivable_pt_lim asin (nu * f x * (1 / 2)) (/ sqrt (1 - (nu * f x * (1 / 2))²))).
  { apply (derive_pt_eq_1 _ _ _ (derivable_pt_asin _ Hr)); rewrite derive_pt_asin; unfold Rdiv; ring. }
  unfold phase; eapply D_ext.
  - eapply (D_scale (fun y => asin (nu * f y * (1 / 2))) x _ (-1)).
    eapply (D_of (fun y => nu * f y * (1 / 2)) asin); [|exact D].
    eapply D_ext; [apply (D_scale f x l (nu * (1 / 2))), Hf | intros y; cbn beta; ring | reflexivity].
  - intros y; cbn beta; ring.
  - unfold Rsqr; field; apply Rgt_not_eq, sqrt_lt_R0; nra.
Qed.

Lemma between x a b c d : c <= a <= d -> c <= b <= d -> 0 <= x <= 1 -> c <= b + x * (a - b) <= d.
Proof. intros; split; nra. Qed.

Lemma sum_bound x x' l l' w w' d B : Rabs l <= w * d -> Rabs l' <= w' * d -> 0 <= d ->
  Rabs x * w + Rabs x' * w' <= B -> Rabs (- (x * l + x' * l')) <= B * d.
Proof.
  intros Hl Hl' Hd HB; rewrite Rabs_Ropp; apply (Rle_trans _ _ _ (Rabs_triang _ _)).
  rewrite !Rabs_mult; pose proof (Rabs_pos x); pose proof (Rabs_pos x').
  apply (Rle_trans _ (Rabs x * (w * d) + Rabs x' * (w' * d))); nra.
Qed.

Lemma leg_lipschitz m n k nu s1 s1' s2 s2' d : letter m -> letter n -> letter k -> 0 < nu <= 1 ->
  dec (s_lo m n) <= s1 <= dec (s_hi m n) -> dec (s_lo m n) <= s2 <= dec (s_hi m n) ->
  dec (s_lo n k) <= s1' <= dec (s_hi n k) -> dec (s_lo n k) <= s2' <= dec (s_hi n k) -> 0 <= d ->
  Rabs (s1 - s2) <= dec (weight m n) * d -> Rabs (s1' - s2') <= dec (weight n k) * d ->
  Rabs (after n nu (phase nu s1) (phase nu s1') - after n nu (phase nu s2) (phase nu s2')) <=
    kappa * dec (alpha n) * d /\
  Rabs (before n nu (phase nu s1) (phase nu s1') - before n nu (phase nu s2) (phase nu s2')) <=
    kappa * dec (beta n) * d.
Proof.
  intros Hm Hn Hk Hnu H1 H2 H1' H2' Hd Hl Hl'.
  set (c := fun x => s2 + x * (s1 - s2)); set (c' := fun x => s2' + x * (s1' - s2')).
  assert (Hleg : forall x, 0 <= x <= 1 -> leg_holds m n k nu (c x) (c' x)).
  { intros x Hx; apply leg_checks; trivial; apply between; assumption. }
  assert (Dc : forall f s l x, (forall y, f y = s + y * l) -> derivable_pt_lim f x l).
  { intros f s l x Ef; eapply D_ext.
    - apply (D_plus (fun _ => s) (fun y => l * y));
      [apply D_const | apply (D_scale (fun y => y) x 1 l), D_id].
    - intros y; cbn beta; rewrite Ef; ring.
    - ring. }
  set (r := fun x => - (nu / 2) / cos (phase nu (c x)) * (s1 - s2)).
  set (r' := fun x => - (nu / 2) / cos (phase nu (c' x)) * (s1' - s2')).
  assert (Dt : forall x, 0 <= x <= 1 -> derivable_pt_lim (fun y => phase nu (c y)) x (r x) /\
    derivable_pt_lim (fun y => phase nu (c' y)) x (r' x) /\
      E12 (time n (phase nu (c x)) (phase nu (c' x))) <> 0).
  { intros x Hx; destruct (Hleg x Hx) as (Y & Y' & P & _); split; [|split; [|lra]].
    - apply D_phase; [exact Y | apply (Dc _ s2); reflexivity].
    - apply D_phase; [exact Y' | apply (Dc _ s2'); reflexivity]. }
  assert (E1 : c 1 = s1 /\ c' 1 = s1') by (unfold c, c'; lra).
  assert (E0 : c 0 = s2 /\ c' 0 = s2') by (unfold c, c'; lra).
  destruct E1 as [E1 E1'], E0 as [E0 E0']; split.
  - destruct (MVT_cor2 (fun x => after n nu (phase nu (c x)) (phase nu (c' x)))
      (fun x => after_slope n nu (phase nu (c x)) (phase nu (c' x)) (r x) (r' x)) 0 1 Rlt_0_1) as (x & E &
        Hx).
    { intros x Hx; destruct (Dt x Hx) as (A & A' & P);
      apply (D_after n nu (fun y => phase nu (c y)) (fun y => phase nu (c' y))); trivial; lra. }
    cbn beta in E; rewrite E1, E1', E0, E0', Rminus_0_r, Rmult_1_r in E; rewrite E.
    destruct (Hleg x ltac:(lra)) as (_ & _ & _ & _ & _ & x1 & x1' & y1 & y1' & S & B & _).
    unfold r, r'; destruct (S (s1 - s2) (s1' - s2')) as [-> _].
    apply (sum_bound _ _ _ _ _ _ _ _ Hl Hl' Hd B).
  - destruct (MVT_cor2 (fun x => before n nu (phase nu (c x)) (phase nu (c' x)))
      (fun x => before_slope n nu (phase nu (c x)) (phase nu (c' x)) (r x) (r' x)) 0 1 Rlt_0_1) as (x & E &
        Hx).
    { intros x Hx; destruct (Dt x Hx) as (A & A' & P);
      apply (D_before n nu (fun y => phase nu (c y)) (fun y => phase nu (c' y))); trivial; lra. }
    cbn beta in E; rewrite E1, E1', E0, E0', Rminus_0_r, Rmult_1_r in E; rewrite E.
    destruct (Hleg x ltac:(lra)) as (_ & _ & _ & _ & _ & x1 & x1' & y1 & y1' & S & _ & B).
    unfold r, r'; destruct (S (s1 - s2) (s1' - s2')) as [_ ->].
    apply (sum_bound _ _ _ _ _ _ _ _ Hl Hl' Hd B).
Qed.

(** ** The gap is positive between impacts *)

Lemma D_gap nu phi q a t :
  derivable_pt_lim (gap nu phi q a) t (sin t + nu * moving phi q a t) /\
  derivable_pt_lim (fun t => sin t + nu * moving phi q a t) t (bend nu phi q a t).
Proof.
  destruct (moved_free phi q a t) as [H1 H2]; split.
  - eapply D_ext.
    + apply D_plus; [|apply (D_scale _ _ _ nu (D_minus _ _ _ _ _ H1 (D_const 1 t)))].
      apply (D_minus (fun _ => 1) cos); [apply D_const | apply derivable_pt_lim_cos].
    + reflexivity.
    + ring.
  - eapply D_ext.
    + apply (D_plus sin); [apply derivable_pt_lim_sin | apply (D_scale _ _ _ nu H2)].
    + reflexivity.
    + unfold bend; field.
Qed.

Lemma gap_positive m n nu s a s' : letter m -> letter n -> 0 < nu <= 1 ->
  dec (s_lo m n) <= s <= dec (s_hi m n) -> dec (a_lo n) <= a <= dec (a_hi n) ->
  Rabs (nu * s * (1 / 2)) < 1 -> Rabs (nu * s' * (1 / 2)) < 1 -> phase nu s' <= 3 / 20 -> s / 2 < a ->
  let phi := phase nu s in let x := place nu phi in let end_ := 2 * PI * IZR n + phase nu s' in
  moved phi x a end_ = place nu (phase nu s') -> moving phi x a end_ < s' / 2 ->
  forall t, phi < t < end_ -> 0 < gap nu phi x a t.
Proof.
  intros Hm Hn Hnu Hs Ha Hy Hy' Hp Hv phi x end_ Hx Hv' t Ht.
  destruct (gap_checks m n nu s a Hm Hn Hnu Hs Ha) as (_ & G1 & G2 & G3).
  fold phi x in G1, G2, G3.
  assert (D1 : forall t, derivable_pt_lim (gap nu phi x a) t (sin t + nu * moving phi x a t))
    by (intros; apply D_gap).
  assert (D2 : forall t, derivable_pt_lim (fun t => sin t + nu * moving phi x a t) t (bend nu phi x a t))
    by (intros; apply D_gap).
  pose proof (sin_phase nu s (proj1 Hnu) Hy) as Es; pose proof (sin_phase nu s' (proj1 Hnu) Hy') as Es'.
  assert (Es1 : sin phi = - nu * (s / 2)) by (fold phi in Es; rewrite <- Es; field; lra).
  assert (Es2 : sin end_ = - nu * (s' / 2)).
  { rewrite <- Es'; replace (sin end_) with (sin (phase nu s')); [field; lra|].
    unfold end_; destruct Hn as [->| ->]; symmetry.
    - rewrite <- (sin_period (phase nu s') 1); f_equal; cbn [INR]; ring.
    - rewrite <- (sin_period (phase nu s') 2); f_equal; cbn [INR]; ring. }
  assert (Ec2 : cos end_ = cos (phase nu s')).
  { unfold end_; destruct Hn as [->| ->].
    - rewrite <- (cos_period (phase nu s') 1); f_equal; cbn [INR]; ring.
    - rewrite <- (cos_period (phase nu s') 2); f_equal; cbn [INR]; ring. }
  destruct (moved_start phi x a) as [M0 M1].
  destruct (Rle_lt_dec t 1) as [L|L]; [|destruct (Rle_lt_dec t (2 * PI * IZR n - 1)) as [L'|L']].
  - apply (convex_right _ _ _ D1 D2 phi 1); [| |exact G1 | lra].
    + right; symmetry; unfold gap; rewrite M0; unfold x, place; field; lra.
    + left; rewrite M1, Es1; nra.
  - apply G2; lra.
  - apply (convex_left _ _ _ D1 D2 (2 * PI * IZR n - 1) end_); [| | |lra].
    + right; symmetry; unfold gap; rewrite Hx, Ec2; unfold place; field; lra.
    + left; rewrite Es2; nra.
    + intros y Hy1; apply G3; unfold end_ in *; lra.
Qed.
