(** * A ball between a ceiling that it grazes and a floor that vibrates: another impact in each period, on the other stop *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementNonlinear StatementBouncing StatementRattling Headline Derivatives NonlinearChain
  NonlinearBouncingExample.
Import Rattling.
Open Scope R_scope.

(** q counts downwards: the lower stop, 0, is the ceiling, and the upper one, pi^2 + 1 + cos t, the floor. For mu = 0 the
    ball falls as t^2, touches the ceiling at 0 and bounces from the floor at pi, at the velocity 2 pi, without loss. *)
Definition ball : Rattling.t := {| T := 2 * PI; mirror := Plus; a := fun t q u mu => 2 + mu; a_t := fun t q u mu => 0;
  a_q := fun t q u mu => 0; a_u := fun t q u mu => 0; a_mu := fun t q u mu => 1;
  Q := fun z n t mu => match z with Plus => 0 | Minus => match n with 0%nat => PI * PI + 1 + cos t | 1%nat => - sin t | 2%nat =>
    - cos t | 3%nat => sin t | _ => 0 end end; Q_mu := fun z n t mu => 0;
  U := fun z mu t u => match z with Plus => - u | Minus => - 2 * sin t - u end;
  U_t := fun z mu t u => match z with Plus => 0 | Minus => - 2 * cos t end; U_u := fun z mu t u => -1; U_mu := fun z mu t u => 0;
  tau := 1; k := 3; s := fun c => 2 * PI * IZR (c / 3) + match (c mod 3)%Z with 0%Z => - (PI / 2) | 1%Z => PI / 2 | _ => PI end;
  stop := fun c => match (c mod 3)%Z with 0%Z => Plus | _ => Minus end;
  impact := fun c => match (c mod 3)%Z with 1%Z => true | _ => false end;
  q0 := fun c t => (t - 2 * PI * IZR ((c + 1) / 3)) * (t - 2 * PI * IZR ((c + 1) / 3));
  u0 := fun c t => 2 * (t - 2 * PI * IZR ((c + 1) / 3)); tG := 0 |}.
Lemma thirds c : exists m, c = (3 * m)%Z \/ c = (3 * m + 1)%Z \/ c = (3 * m + 2)%Z.
Proof. exists (c / 3)%Z; pose proof (Z.div_mod c 3 ltac:(lia)); pose proof (Z.mod_pos_bound c 3 ltac:(lia)); lia. Qed.
Lemma at_third m : (3 * m / 3 = m /\ (3 * m) mod 3 = 0 /\ (3 * m + 1) / 3 = m /\ (3 * m + 1) mod 3 = 1 /\ (3 * m + 2) / 3 = m /\
  (3 * m + 2) mod 3 = 2 /\ (3 * m + 2 + 1) / 3 = m + 1 /\ (3 * m + 2 + 1) mod 3 = 0 /\ (3 * m + 1 + 1) / 3 = m /\ (3 * m + 1 + 1)
  mod 3 = 2 /\ (3 * m + 2 + 1 + 1) / 3 = m + 1 /\ (3 * m + 1 + 1 + 1) / 3 = m + 1)%Z.
Proof.
  repeat split; try (symmetry; apply (Z.div_unique _ 3 _ 0); lia); try (symmetry; apply (Z.div_unique _ 3 _ 1); lia); try
    (symmetry; apply (Z.div_unique _ 3 _ 2); lia); symmetry; [apply (Z.mod_unique _ 3 m) | apply (Z.mod_unique _ 3 m) | apply
    (Z.mod_unique _ 3 m) | apply (Z.mod_unique _ 3 (m + 1)) | apply (Z.mod_unique _ 3 m)]; lia.
Qed.
(** Arc by arc, x being the time since the last touch or until the next. *)
Ltac each c m := destruct (thirds c) as (m & [-> | [-> | ->]]); destruct (at_third m) as (D0 & M0 & D1 & M1 & D2 & M2 & D3 & M3 & D4
  & M4 & D5 & D6); cbn [s stop impact q0 u0 ball] in *; rewrite ?D6, ?D5, ?D4, ?D3, ?D2, ?D1, ?D0, ?M4, ?M3, ?M2, ?M1, ?M0 in *.
Lemma turns_at m x : cos (2 * PI * IZR m + x) = cos x /\ sin (2 * PI * IZR m + x) = sin x.
Proof. rewrite Rplus_comm; split; [apply cos_periods | apply sin_periods]. Qed.
Lemma under x : - PI < x < PI -> 0 < PI * PI + 1 + cos x - x * x.
Proof.
  intros Hx; assert (x * x < PI * PI) by (replace (x * x) with (Rabs x * Rabs x) by (rewrite <- Rabs_mult; apply Rabs_pos_eq,
    Rle_0_sqr); apply Rmult_le_0_lt_compat; try apply Rabs_pos; apply Rabs_def1; lra). pose proof (COS_bound x); lra.
Qed.
Lemma ball_rattles : rattles ball.
Proof.
  pose proof PI_RGT_0 as HP; assert (P2 : 0 < PI * PI) by (apply Rmult_lt_0_compat; lra); assert (Cst : forall D q, continuous D
    (fun _ _ _ _ => q)) by apply continuous_const.
  assert (Sq : forall x, x <> 0 -> 0 < 1 * (x * x - 0)) by (intros x Hx; apply Rsqr_pos_lt in Hx; unfold Rsqr in Hx; lra).
  assert (Fl : forall m t, - PI < t - 2 * PI * IZR m < PI -> 0 < -1 * ((t - 2 * PI * IZR m) * (t - 2 * PI * IZR m) - (PI * PI + 1 +
    cos t))).
  { intros m t Hx; set (x := t - 2 * PI * IZR m) in *; replace (cos t) with (cos x) by (rewrite <- (proj1 (turns_at m x)); f_equal;
      unfold x; ring); pose proof (under x Hx); lra. }
  constructor.
  - split; [cbn; lra | split; [cbn; lia|]]; intros c t; change (Z.of_nat (k ball)) with 3%Z; cbv zeta; unfold turned, image; cbn
      [mirror ball sgn]. assert (E3 : ((c + 3) / 3 = c / 3 + 1 /\ (c + 3) mod 3 = c mod 3 /\ (c + 3 + 1) / 3 = (c + 1) / 3 + 1)%Z) by
      (replace (c + 3 + 1)%Z with (c + 1 + 1 * 3)%Z by ring; replace (c + 3)%Z with (c + 1 * 3)%Z by ring; rewrite !Z.div_add,
      Z.mod_add by lia; auto). destruct E3 as (E1 & E2 & E3), (turn t) as [C1' S1']; cbn [s stop impact q0 u0 ball T]; rewrite E1,
      E2, E3, !plus_IZR.
    split; [ring | split; [reflexivity | split; [reflexivity | split; [ring | split; [ring|]]]]]; intros z n q u mu; cbn [a ball Q
      U]; destruct z; (split; [ring | split; [destruct n as [|[|[|[|n]]]]; rewrite ?C1', ?S1'; ring | rewrite ?S1'; ring]]).
  - exists 1; split; [lra|]; intros c t _; cbn; split; (eapply D_value; [first [apply D_times; apply D_shift | apply D_scale,
      D_shift] | cbv beta; ring]).
  - intros c; each c m; cbv zeta; unfold passes, off, rel; cbn [s stop impact q0 u0 ball Q U sgn]; rewrite ?D6, ?D5, ?D4, ?D3, ?D2, ?D1,
      ?D0, ?M4, ?M3, ?M2, ?M1, ?M0, ?plus_IZR.
    + split; [lra | split; [split; reflexivity | apply Sq; lra]].
    + destruct (turns_at m PI) as [E1 E2]; rewrite E1, E2, cos_PI, sin_PI; repeat split; lra.
    + split; [lra | split; [split; reflexivity|]]; rewrite <- (plus_IZR m 1); apply Fl; rewrite plus_IZR; lra.
  - cbn; repeat split; lra.
  - intros c t Ht Ne; each c m; unfold off; cbn [q0 ball Q sgn]; rewrite ?D3, ?D4, ?D1; rewrite ?plus_IZR in Ht.
    + apply Sq; intros E; apply (Ne m); split; [reflexivity | cbn; lra].
    + apply Fl; lra.
    + apply Fl; rewrite plus_IZR; lra.
  - intros c t z Ht Hz; each c m; unfold off; cbn [q0 ball Q]; rewrite ?D3, ?D4, ?D1; rewrite ?plus_IZR in Ht; destruct z; try (exfalso;
      apply Hz; reflexivity); cbn [sgn]; [apply Fl; lra | apply Sq; lra | apply Sq; rewrite plus_IZR; lra].
  - exists 1; split; [lra|]; intros c; constructor; intros; cbn; try apply D_const; [eapply D_value; [apply D_plus; [apply D_const |
      apply D_id] | ring] | repeat split; apply Cst].
  - assert (Cc : forall D, continuous D (fun t _ _ _ => - cos t)) by (intros D; apply C_t; intros t; eapply D_continuous,
      derivable_pt_lim_opp, derivable_pt_lim_cos); assert (Cs : forall D, continuous D (fun t _ _ _ => - sin t)) by (intros D; apply
      C_t; intros t; eapply D_continuous, derivable_pt_lim_opp, derivable_pt_lim_sin); assert (Cs' : forall D, continuous D (fun t _
      _ _ => sin t)) by (intros D; apply C_t; intros t; eapply D_continuous, derivable_pt_lim_sin).
    exists 1; split; [lra|]; intros z n Hn; destruct z; [constructor; intros; cbn; try apply D_const; repeat split; apply Cst|].
    destruct n as [|[|[|n]]]; [| | | lia]; (constructor; intros; cbn; try apply D_const; [eapply D_value; [first [apply D_plus; [apply
      D_const | apply derivable_pt_lim_cos] | apply derivable_pt_lim_opp, derivable_pt_lim_sin | apply derivable_pt_lim_opp,
      derivable_pt_lim_cos] | ring] | repeat split; first [apply Cst | apply Cc | apply Cs | apply Cs']]).
  - split; [cbn; lra | split; cbn; intros; unfold rel in *; cbn in *; lra].
  - exists 1, (fun _ _ _ _ => 0), (fun _ _ _ _ => 0), (fun _ _ _ _ => -1), (fun _ _ _ _ => 0); split; [lra | split; [cbn; lra|]];
      constructor; intros; cbn; try apply D_const; [eapply D_value; [apply derivable_pt_lim_opp, D_id | ring] | repeat split; apply
      Cst].
  - exists 1; split; [lra|]; intros c E; each c m; try discriminate; constructor; intros; cbn; rewrite ?M1; try apply D_const.
    + eapply D_value; [apply D_minus; [apply D_scale, derivable_pt_lim_sin | apply D_const] | ring].
    + eapply D_value; [apply D_minus; [apply D_const | apply D_id] | ring].
    + repeat split; try apply Cst. apply (C_t _ (fun t => -2 * cos t)); intros t; eapply D_continuous, D_scale, derivable_pt_lim_cos.
Qed.
Lemma ball_along c m z w : linear_along (seen_from ball) c m z w -> forall t, s ball c <= t <= s ball (c + 1)%Z -> derivable_pt_lim z
  t (w t) /\ derivable_pt_lim w t (sgn (stop ball c) * m).
Proof. intros H t Ht; destruct (H t Ht) as [A B]; split; [exact A|]; eapply D_value; [exact B | cbn -[stop sgn]; ring]. Qed.
Lemma ball_times : s ball 0 = - (PI / 2) /\ s ball 1 = PI / 2 /\ s ball 2 = PI /\ s ball 3 = 3 * (PI / 2) /\ s ball 4 = 5 * (PI / 2).
Proof. cbn; repeat split; field. Qed.
(** The floor rises at the impact half as fast as the ball's fall changes: w' = - w + z / pi. *)
Lemma ball_ends m z w z' w' : (forall c, c = 0%Z \/ c = 2%Z -> linear_impact (seen_from ball) c m z w z' w' <-> z' = - z /\ w' = - w)
  /\ (linear_impact (seen_from ball) 1 m z w z' w' <-> z' = - z /\ w' = - w + z / PI).
Proof.
  pose proof PI_RGT_0 as HP; split; [intros c [->| ->]; unfold linear_impact; cbn; split; intros [A B]; split; lra|].
  unfold linear_impact; cbn -[IZR]; replace (2 * PI * IZR 0 + PI) with PI by ring; unfold rel; cbn -[IZR]; rewrite cos_PI, sin_PI.
  split; [intros (h & A & B & C) | intros [A B]; exists (z / (2 * PI))].
  - assert (Eh : h = z / (2 * PI)) by (apply (Rmult_eq_reg_l (2 * PI)); [field_simplify; lra | lra]); split; [lra|]; replace (z / PI)
      with (2 * h) by (rewrite Eh; field; lra); lra.
  - assert (Ez : 2 * PI * (z / (2 * PI)) = z) by (field; lra); assert (E2 : z / PI = 2 * (z / (2 * PI))) by (field; lra); set (h := z /
      (2 * PI)) in *; repeat split; lra.
Qed.
Lemma ball_generic : generic_round (seen_from ball) 0 1 (- PI) (- (PI * PI / 2)).
Proof.
  pose proof PI_RGT_0 as HP; assert (P2 : 0 < PI * PI) by (apply Rmult_lt_0_compat; lra); destruct ball_times as (T0 & T1 & T2 & T3 &
    T4); constructor; change (Z.of_nat (Bouncing.k (seen_from ball))) with 3%Z; change (Bouncing.tG (seen_from ball)) with 0; change
    (Bouncing.T (seen_from ball)) with (2 * PI); rewrite ?Rplus_0_l; try lra.
  - exists 0, (1 / PI), 0; split; [ring | split; [field; lra|]]; intros z w [H1 H2]; change (Z.of_nat (Bouncing.k (seen_from ball)))
      with 3%Z in *; change (Bouncing.s (seen_from ball)) with (s ball) in *; cbv zeta in *.
    pose proof (H2 0%Z ltac:(lia)) as J0; pose proof (H2 1%Z ltac:(lia)) as J1; pose proof (H2 2%Z ltac:(lia)) as J2; cbn [Z.add
      Pos.add Pos.succ] in J0, J1, J2; apply (ball_ends 0) in J0; [|auto]; apply (ball_ends 0) in J1; apply (ball_ends 0) in J2;
      [|auto]; rewrite T1 in J0; rewrite T2 in J1; rewrite T3 in J2.
    assert (L : forall c, (0 <= c <= 3)%Z -> forall t, s ball c <= t <= s ball (c + 1)%Z -> derivable_pt_lim (z c) t (w c t) /\
      derivable_pt_lim (w c) t 0) by (intros c Hc t Ht; destruct (ball_along c 0 _ _ (H1 c Hc) t Ht) as [A B]; rewrite Rmult_0_r in B;
      auto).
    destruct (parabola 0 (z 0%Z) (w 0%Z) (- (PI / 2)) (PI / 2) ltac:(lra)) with (p := 0) (x := PI / 2) as [A1 A2]; try lra; [intros t
      Ht; apply (L 0%Z ltac:(lia)); change (0 + 1)%Z with 1%Z; rewrite T0, T1; exact Ht|].
    destruct (parabola 0 (z 1%Z) (w 1%Z) (PI / 2) PI ltac:(lra)) with (p := PI / 2) (x := PI) as [A3 A4]; try lra; [intros t Ht; apply
      (L 1%Z ltac:(lia)); change (1 + 1)%Z with 2%Z; rewrite T1, T2; exact Ht|].
    destruct (parabola 0 (z 2%Z) (w 2%Z) PI (3 * (PI / 2)) ltac:(lra)) with (p := PI) (x := 3 * (PI / 2)) as [A5 A6]; try lra; [intros
      t Ht; apply (L 2%Z ltac:(lia)); change (2 + 1)%Z with 3%Z; rewrite T2, T3; exact Ht|].
    destruct (parabola 0 (z 3%Z) (w 3%Z) (3 * (PI / 2)) (5 * (PI / 2)) ltac:(lra)) with (p := 3 * (PI / 2)) (x := 2 * PI) as [A7 A8];
      try lra; [intros t Ht; apply (L 3%Z ltac:(lia)); change (3 + 1)%Z with 4%Z; rewrite T3, T4; exact Ht|].
    rewrite A7, A8, (proj1 J2), (proj2 J2), A5, A6, (proj1 J1), (proj2 J1), A3, A4, (proj1 J0), (proj2 J0), A1, A2; split; field; lra.
  - exists (fun c t => sgn (stop ball c) * (/ 2 * ((t - 2 * PI * IZR ((c + 1) / 3)) * (t - 2 * PI * IZR ((c + 1) / 3))) - PI * PI / 2)),
      (fun c t => sgn (stop ball c) * (t - 2 * PI * IZR ((c + 1) / 3))); split; [split|].
    + intros c _ t _; cbv zeta; split; (eapply D_value; [apply D_scale; first [apply D_minus; [apply D_scale, D_times; apply D_shift |
        apply D_const] | apply D_shift] | cbn -[stop sgn]; field]).
    + intros c Hc; change (Z.of_nat (Bouncing.k (seen_from ball))) with 3%Z in Hc; cbv zeta; change (Bouncing.s (seen_from ball)) with
        (s ball); assert (C : c = 0%Z \/ c = 1%Z \/ c = 2%Z) by lia; destruct C as [->|[->| ->]]; cbn [Z.add Pos.add Pos.succ]; apply
        (ball_ends 1); auto; rewrite ?T1, ?T2, ?T3; cbn; split; field; lra.
    + cbn; repeat split; field.
Qed.
