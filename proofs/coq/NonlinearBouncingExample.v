(** * An oscillator whose grazing orbit has another impact in each period *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Derivatives StatementNonlinear StatementBouncing StatementBouncingExample.
Import Bouncing.
Open Scope R_scope.
Notation O := bouncing_example.
Ltac un := cbn [T a a_t a_y a_v a_mu impact rebound rebound_t rebound_v rebound_mu face place place_mu speed speed_mu tau k s y0
  v0 tG bouncing_example].
Tactic Notation "un_at" hyp(H) :=
  cbn [T a a_t a_y a_v a_mu impact rebound rebound_t rebound_v rebound_mu face place place_mu speed speed_mu tau k s y0
  v0 tG bouncing_example] in H.

(** sin (t / 2) > t / pi. *)
Lemma above_chord x : 0 < x < PI -> 0 < PI * PI * (1 - cos x) - 2 * (x * x).
Proof.
  intros Hx; pose proof PI_RGT_0 as HP; set (f := fun t => PI * sin t - 2 * t).
  assert (D : forall t, derivable_pt_lim f t (PI * cos t - 2)).
  { intros t; eapply D_value; [apply D_minus; [apply D_scale, derivable_pt_lim_sin | apply D_scale, D_id] | cbv beta; ring]. }
  assert (F : 0 < f (x / 2)).
  { apply Rnot_le_lt; intros N. destruct (MVT_cor2 f (fun t => PI * cos t - 2) 0 (x / 2)) as (c1 & E1 & H1); [lra |
      intros t _; apply D|]. destruct (MVT_cor2 f (fun t => PI * cos t - 2) (x / 2) (PI / 2)) as (c2 & E2 & H2); [lra |
          intros t _; apply D|].
    assert (F0 : f 0 = 0) by (unfold f; rewrite sin_0; ring); assert (F1 : f (PI / 2) = 0) by (unfold f; rewrite
        sin_PI2; field).
    rewrite F0 in E1; rewrite F1 in E2; assert (C : cos c2 < cos c1) by (apply cos_decreasing_1; lra).
    assert (PI * cos c1 - 2 <= 0) by (apply Rnot_lt_le; intros P; assert (0 < (PI * cos c1 - 2) * (x / 2 - 0)) by (apply
      Rmult_lt_0_compat; lra); lra).
    assert (0 <= PI * cos c2 - 2) by (apply Rnot_lt_le; intros P; assert (0 < - (PI * cos c2 - 2) * (PI / 2 - x / 2)) by
      (apply Rmult_lt_0_compat; lra); lra). assert (PI * cos c2 < PI * cos c1) by (apply Rmult_lt_compat_l; lra); lra. }
  assert (E : cos x = 1 - 2 * sin (x / 2) * sin (x / 2)) by (rewrite <- cos_2a_sin; f_equal; field).
  rewrite E; unfold f in F; assert (P : 0 < x) by lra; assert (x < PI * sin (x / 2)) by lra.
  assert (x * x < PI * sin (x / 2) * (PI * sin (x / 2))) by (apply Rmult_le_0_lt_compat; lra); lra.
Qed.
Lemma turns z t : cos (t + 2 * PI * IZR z) = cos t /\ sin (t + 2 * PI * IZR z) = sin t.
Proof. split; [apply cos_periods | apply sin_periods]. Qed.
Lemma turn t : cos (t + 2 * PI) = cos t /\ sin (t + 2 * PI) = sin t.
Proof. pose proof (turns 1 t) as H; rewrite Rmult_1_r in H; exact H. Qed.
Lemma end_of c : s O (c + 1)%Z = 2 * PI * IZR c + PI.
Proof. un; rewrite plus_IZR; ring. Qed.
Lemma at_end c : y0 O c (s O (c + 1)%Z) = 0 /\ v0 O c (s O (c + 1)%Z) = - (4 * PI) /\ v0 O (c + 1)%Z (s O (c + 1)%Z) = 4
    * PI.
Proof.
  rewrite end_of; un; rewrite plus_IZR; destruct (turns c PI) as [E1 E2]; rewrite (Rplus_comm PI) in E1, E2; rewrite
    E1, E2, cos_PI, sin_PI; repeat split; ring.
Qed.
Lemma at_start c : y0 O c (s O c) = 0.
Proof. un; destruct (turns c (- PI)) as [E1 E2]; replace (2 * PI * IZR c - PI) with (- PI + 2 * PI * IZR c) by ring;
  rewrite E1, cos_neg, cos_PI; ring. Qed.
Lemma continuous_const D q : continuous D (fun _ _ _ _ => q).
Proof. intros t y v mu _ e He; exists 1; split; [lra|]; intros; rewrite Rminus_eq_0, Rabs_R0; lra. Qed.
Lemma example_moves c t : StatementBouncing.runs O c 0 (y0 O c) (v0 O c) t.
Proof.
  split; un.
  - eapply D_value; [apply D_minus; [apply D_scale, D_minus; [apply D_const | apply derivable_pt_lim_cos] | apply
      D_scale, D_times; apply D_shift] | cbv beta; ring].
  - eapply D_value; [apply D_minus; [apply D_scale, derivable_pt_lim_sin | apply D_scale, D_shift] | cbv beta; ring].
Qed.
Lemma example_law c D f3 : (forall t y v mu, f3 t y v mu = -1) -> C1 D (fun t y v mu => rebound O c mu t v) (fun _ _ _ _ =>
  0) (fun _ _ _ _ => 0) f3 (fun _ _ _ _ => 0).
Proof.
  intros E; constructor; intros; un; try apply D_const.
  - rewrite E; eapply D_value; [apply derivable_pt_lim_opp, D_id | cbv beta; ring].
  - repeat split; try apply continuous_const. intros t y v mu _ e He; exists 1; split; [lra|]; intros; rewrite !E,
      Rminus_eq_0, Rabs_R0; lra.
Qed.
Lemma example_orbit : bouncing_orbit O.
Proof.
  pose proof PI_RGT_0 as HP; constructor.
  - split; [un; lra | split; [un; lia|]]; intros c t; change (Z.of_nat (k O)) with 1%Z; un; rewrite plus_IZR;
      destruct (turn t) as [E1 E2]; rewrite E1, E2; repeat split; ring.
  - intros c; destruct (at_end c) as (E0 & E1 & E2); cbv zeta; rewrite E0, E1, E2, at_start; unfold follows; un; repeat
      split; try lra; rewrite plus_IZR; lra.
  - un; rewrite cos_0; split; [lra | split; [ring|]]; pose proof PI_4; assert (2 < PI) by (pose proof PI2_3_2; lra);
      nra.
  - intros c t Ht Hc; rewrite end_of in Ht; un_at Ht; un; set (x := t - 2 * PI * IZR c); destruct (turns c x) as [E1
      _]; replace (x + 2 * PI * IZR c) with t in E1 by (unfold x; ring); rewrite E1. destruct (Rtotal_order x 0) as
          [L|[Z|G]].
    + rewrite <- (cos_neg x); pose proof (above_chord (- x) ltac:(unfold x in *; lra)); lra.
    + exfalso; apply (Hc c); change (Z.of_nat (k O)) with 1%Z; split; [lia | un; unfold x in Z; lra].
    + apply above_chord; unfold x in *; lra.
  - exists 1; split; [lra | split; [intros c t _; apply example_moves|]]; intros c; constructor; intros; un; try apply
      D_const.
    + eapply D_value; [apply D_plus; [apply D_minus; [apply D_scale, derivable_pt_lim_cos | apply D_const] | apply
        D_const] | cbv beta; ring].
    + eapply D_value; [apply D_plus; [apply D_const | apply D_id] | cbv beta; ring].
    + repeat split; try apply continuous_const. intros t y v mu _ e He; assert (C : continuity_pt (fun t => - (PI * PI *
        sin t)) t).
      { apply (D_continuous _ (- (PI * PI * cos t))); eapply D_value; [apply derivable_pt_lim_opp, D_scale,
          derivable_pt_lim_sin | cbv beta; ring]. }
      destruct (continuous_near _ t e C He) as (d & Hd & H); exists d; split; [exact Hd|]; intros t' y' v' mu' Ht' _ _
        _; apply H, Ht'.
  - un; split; [lra | split; [intros; ring | intros; lra]].
  - exists 1, (fun _ _ _ _ => 0), (fun _ _ _ _ => 0), (fun _ _ _ _ => -1), (fun _ _ _ _ => 0); split; [lra | split;
      [reflexivity|]]; apply example_law; reflexivity.
  - exists 1; split; [lra|]; intros c; apply example_law; reflexivity.
Qed.
(** A solution of z'' = m is a parabola. *)
Lemma parabola m z w lo hi : lo <= hi -> (forall t, lo <= t <= hi -> derivable_pt_lim z t (w t) /\ derivable_pt_lim w t
  m) -> forall p x, lo <= p <= hi -> lo <= x <= hi -> w x = w p + m * (x - p) /\ z x = z p + w p * (x - p) + m * ((x -
      p) * (x - p)) / 2.
Proof.
  intros O' H p x Hp Hx.
  assert (Cst : forall f, (forall t, lo <= t <= hi -> derivable_pt_lim f t 0) -> f x = f p).
  { intros f Hf; destruct (Rtotal_order p x) as [L|[->|L]]; [|reflexivity|].
    - destruct (MVT_cor2 f (fun _ => 0) p x L) as (q & E & _); [intros t Ht; apply Hf; lra | lra].
    - destruct (MVT_cor2 f (fun _ => 0) x p L) as (q & E & _); [intros t Ht; apply Hf; lra | lra]. }
  assert (W : forall t, lo <= t <= hi -> w t = w p + m * (t - p)).
  { intros t Ht; assert (E : (fun t => w t - m * (t - p)) t = (fun t => w t - m * (t - p)) p); [|cbv beta in E; lra].
    destruct (Rtotal_order p t) as [L|[->|L]]; [|reflexivity|].
    - destruct (MVT_cor2 (fun t => w t - m * (t - p)) (fun _ => 0) p t L) as (q & E & _); [|lra]. intros u Hu; eapply
        D_value; [apply D_minus; [apply H; lra | apply D_scale, D_shift] | cbv beta; ring].
    - destruct (MVT_cor2 (fun t => w t - m * (t - p)) (fun _ => 0) t p L) as (q & E & _); [|lra]. intros u Hu; eapply
        D_value; [apply D_minus; [apply H; lra | apply D_scale, D_shift] | cbv beta; ring]. }
  split; [apply W, Hx|]. pose proof (Cst (fun t => z t - w p * (t - p) - m / 2 * ((t - p) * (t - p)))) as E; cbv beta in
    E. rewrite !Rminus_eq_0 in E; assert (E' : z x - w p * (x - p) - m / 2 * ((x - p) * (x - p)) = z p - w p * 0 - m / 2
        * (0 * 0)); [|lra].
  apply E; intros t Ht; eapply D_value; [apply D_minus; [apply D_minus; [apply H, Ht | apply D_scale, D_shift] | apply
    D_scale, D_times; apply D_shift] | cbv beta; rewrite (W t Ht); field].
Qed.
Lemma example_round m z w : linear_round O m z w -> let z1 := z 1%Z (2 * PI) in let w1 := w 1%Z (2 * PI) in let Z := z
  0%Z 0 + w 0%Z 0 * PI + m * (PI * PI) / 2 in
  z1 = (PI * PI / 2 + 1) * Z - PI * (w 0%Z 0 + m * PI) + m * (PI * PI) / 2 /\
  w1 = - (w 0%Z 0 + m * PI) + (PI / 2 + 2 / PI) * Z + m * PI.
Proof.
  intros [H1 H2]; pose proof PI_RGT_0 as HP; cbv zeta; change (Z.of_nat (k O)) with 1%Z in *.
  assert (L : forall c, (0 <= c <= 1)%Z -> forall t, s O c <= t <= s O (c + 1)%Z -> derivable_pt_lim (z c) t (w c t) /\
    derivable_pt_lim (w c) t m).
  { intros c Hc t Ht; destruct (H1 c Hc t Ht) as [A B]; split; [exact A|]; un_at B; eapply D_value; [exact B | cbv beta; ring]. }
  assert (S0 : s O 0%Z = - PI) by (un; ring); assert (S1 : s O 1%Z = PI) by (un; ring); assert (S2 : s O 2%Z = 3 * PI)
    by (un; ring).
  destruct (parabola m (z 0%Z) (w 0%Z) (- PI) PI ltac:(lra)) with (p := 0) (x := PI) as [A1 A2]; try lra.
  { intros t Ht; apply (L 0%Z ltac:(lia)); rewrite S0; change (0 + 1)%Z with 1%Z; rewrite S1; exact Ht. }
  destruct (parabola m (z 1%Z) (w 1%Z) PI (3 * PI) ltac:(lra)) with (p := PI) (x := 2 * PI) as [A3 A4]; try lra.
  { intros t Ht; apply (L 1%Z ltac:(lia)); rewrite S1; change (1 + 1)%Z with 2%Z; rewrite S2; exact Ht. }
  destruct (H2 0%Z ltac:(lia)) as (h & J1 & J2 & J3); destruct (at_end 0) as (_ & E1 & E2); cbv zeta in *; rewrite E1 in
    J1, J3; rewrite E2 in J2; change (0 + 1)%Z with 1%Z in *; rewrite S1 in *; un_at J3; rewrite cos_PI in J3.
  replace (PI - 0) with PI in A1, A2 by ring; replace (2 * PI - PI) with PI in A3, A4 by ring.
  assert (Eh : h = z 0%Z PI / (4 * PI)) by (field_simplify_eq; lra). rewrite Eh in J2, J3; rewrite A3, A4.
  assert (Ez : z 1%Z PI = - z 0%Z PI) by (replace (4 * PI * (z 0%Z PI / (4 * PI))) with (z 0%Z PI) in J2 by (field;
      lra); lra).
  assert (Ew : w 1%Z PI = - w 0%Z PI + (PI / 2 + 2 / PI) * z 0%Z PI).
  { replace ((PI / 2 + 2 / PI) * z 0%Z PI) with (2 * (PI * PI + 4) * (z 0%Z PI / (4 * PI))) by (field; lra); lra. }
  rewrite Ez, Ew, A1, A2; split; field; lra.
Qed.
Lemma example_generic : generic_round O (PI * PI + 2) 1 (PI * PI * PI / 2) (- (PI * PI / 2)).
Proof.
  pose proof PI_RGT_0 as HP; assert (H2 : 0 < PI * PI) by (apply Rmult_lt_0_compat; lra); constructor.
  - exists (PI * PI / 2 + 1), (PI / 2 + 2 / PI), (PI * PI / 2 + 1); split; [field | split; [field; lra|]]; intros z w H;
      destruct (example_round 0 z w H) as [E1 E2]; change (Z.of_nat (k O)) with 1%Z; change (tG O) with 0; change (T O)
      with (2 * PI); rewrite Rplus_0_l; cbv zeta; rewrite E1, E2; split; field; lra.
  - assert (0 < PI * PI * PI) by (apply Rmult_lt_0_compat; lra); lra.
  - set (zz := fun (c : Z) t => (t - 2 * PI * IZR c) * (t - 2 * PI * IZR c) / 2 - PI * PI / 2); set (ww := fun (c : Z) t
      => t - 2 * PI * IZR c). exists zz, ww; change (Z.of_nat (k O)) with 1%Z; change (tG O) with 0; change (T O) with
      (2 * PI); split; [|unfold zz, ww; un; repeat split; field]. split.
    + intros c _ t _; split; un; unfold zz, ww.
      * assert (D : derivable_pt_lim (fun t => / 2 * ((t - 2 * PI * IZR c) * (t - 2 * PI * IZR c)) - PI * PI / 2) t (t -
          2 * PI * IZR c)) by (eapply D_value; [apply D_minus; [apply D_scale, D_times; apply D_shift | apply D_const] |
          cbv beta; field]). apply (D_ext _ _ _ _ _ D); [intros x; field | reflexivity].
      * eapply D_value; [apply D_shift | cbv beta; ring].
    + intros c Hc; change (Z.of_nat (k O)) with 1%Z in Hc; assert (c = 0%Z) by lia; subst c; change (0 + 1)%Z with 1%Z;
        assert (S1 : s O 1%Z = PI) by (un; ring); cbv zeta; rewrite S1. destruct (at_end 0) as (_ & E1 & E2); change (0
        + 1)%Z with 1%Z in E1, E2; rewrite S1 in E1, E2. exists 0; change (0 + 1)%Z with 1%Z; cbv zeta; rewrite S1, E1,
        E2; unfold zz, ww; un; repeat split; field.
  - lra.
Qed.
Theorem Bouncing_example : Bouncing_example_statement. Proof. exact (conj example_orbit example_generic). Qed.
