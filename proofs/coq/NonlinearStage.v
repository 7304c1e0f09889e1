(** * From an impact to the next: where a solution meets the stop at a velocity that is not small, the law of
      impact makes of it one near the next arc, whose state is strictly differentiable in that of the first *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import StatementOrbits Contraction Derivatives NonlinearGronwall NonlinearFlow NonlinearKick.
From Grazing Require Import NonlinearMap NonlinearArc NonlinearPoint.
Open Scope R_scope.

Section Stage.
(** The arc of F ends at its time e, at the velocity v0 e < 0; that of F' begins at its time rho. law mu s v
    is the velocity after an impact s later. *)
Variables (F F' : force) (kk cc ll kk' cc' ll' : R -> R) (e rho r1 rho1 Rm Rt Rv : R) (law : R -> R -> R -> R).
Notation Y1 := (@Y F). Notation V1 := (@V F). Notation Y2 := (@Y F'). Notation V2 := (@V F').
Notation acc1 := (@a F e (@y0 F e) (@v0 F e) 0). Notation acc2 := (@a F' rho (@y0 F' rho) (@v0 F' rho) 0).
Let u1 := @v0 F e. Let u2 := @v0 F' rho.
Hypothesis HA : @along_arc F kk cc ll.
Hypothesis HA' : @along_arc F' kk' cc' ll'.
Hypothesis He : 0 < rho /\ 0 <= e - rho /\ e + rho <= @T F.
Hypothesis HT' : rho + rho <= @T F'.
Hypothesis Hex : @y0 F e = 0 /\ u1 < 0.
Hypothesis Hen : @y0 F' rho = 0 /\ u2 = law 0 0 u1.
Hypothesis Hlaw : forall eps, 0 < eps -> exists d, 0 < d /\ forall mu s v mu' s' v', Rabs mu <= d -> Rabs s <= d ->
  Rabs (v - u1) <= d -> Rabs mu' <= d -> Rabs s' <= d -> Rabs (v' - u1) <= d ->
  Rabs (law mu s v - law mu' s' v' - (Rm * (mu - mu') + Rt * (s - s') + Rv * (v - v'))) <=
  eps * (Rabs (mu - mu') + Rabs (s - s') + Rabs (v - v')).
Hypothesis Hr1 : 0 < r1 /\ 0 < rho1 <= rho /\ 2 * (@M F * r1) < - u1 * rho1.
Hypothesis Hsteep : forall x mu s, within 2 r1 x -> Rabs mu <= r1 -> Rabs (s - e) <= rho1 ->
  Rabs (V1 x mu s - u1) <= - u1 / 2.
Let M_F := @M_large F. Let M_F' := @M_large F'.
Let HL1 := @HL F. Let HT1 := @HT F. Let HL2 := @HL F'. Let HT2 := @HT F'.
Lemma He2 : 0 < rho /\ 0 <= rho - rho /\ rho + rho <= @T F'. Proof. repeat split; lra. Qed.

Definition cross (x : vec) mu := the (fun s => Rabs (s - e) <= rho1 /\ Y1 x mu s = 0).
Lemma downhill x mu s s' : small r1 x mu -> Rabs (s - e) <= rho1 -> Rabs (s' - e) <= rho1 -> s <= s' ->
  - u1 / 2 * (s' - s) <= Y1 x mu s - Y1 x mu s'.
Proof.
  intros [Hx Hm] Hs Hs' O; apply le_abs in Hs, Hs'; destruct (@flow F x mu) as (S & _).
  pose proof (NonlinearCrossing.between (Y1 x mu) (V1 x mu) u1 (- u1 / 2) s s') as B; specialize (B ltac:(intros z Hz;
    split; [apply S | apply Hsteep; trivial; apply Rabs_le; lra]) O). apply le_abs in B; lra.
Qed.
Lemma cross_spec x mu : small r1 x mu -> let s := cross x mu in Rabs (s - e) <= rho1 /\ Y1 x mu s = 0 /\
  V1 x mu s < 0 /\ (forall z, Rabs (z - e) <= rho1 -> z < s -> 0 < Y1 x mu z) /\
  forall z, Rabs (z - e) <= rho1 -> Y1 x mu z = 0 -> z = s.
Proof.
  intros S s; destruct (@flow F x mu) as (Fl & _).
  assert (Near : forall z, Rabs (z - e) <= rho1 -> Rabs (Y1 x mu z - @y0 F z) <= @M F * r1).
  { intros z Hz; apply le_abs in Hz; apply (@near_y0 F x mu r1 z (proj1 S) (proj2 S)); lra. }
  assert (S0 : small r1 zero 0) by (split; [intros i _; unfold zero|]; rewrite Rabs_R0; lra).
  assert (Re : Rabs (e - e) <= rho1) by (rewrite Rminus_eq_0, Rabs_R0; lra); assert (Rl : Rabs (e - rho1 - e) <= rho1)
    by (replace (e - rho1 - e) with (- rho1) by ring; rewrite Rabs_Ropp, Rabs_pos_eq; lra); assert (Rr : Rabs (e + rho1
    - e) <= rho1) by (replace (e + rho1 - e) with rho1 by ring; rewrite Rabs_pos_eq; lra).
  pose proof (downhill zero 0 (e - rho1) e S0 Rl Re ltac:(lra)) as D1; pose proof (downhill zero 0 e (e + rho1) S0 Re Rr
    ltac:(lra)) as D2. rewrite !(proj1 (@at_rest F _)), (proj1 Hex) in D1; rewrite !(proj1 (@at_rest F _)), (proj1 Hex)
        in D2.
  pose proof (le_abs _ _ (Near _ Rl)) as N1; pose proof (le_abs _ _ (Near _ Rr)) as N2.
  assert (Ex : exists z, Rabs (z - e) <= rho1 /\ Y1 x mu z = 0).
  { destruct (IVT (fun z => - Y1 x mu z) (e - rho1) (e + rho1)) as (z & Hz & E); [|lra|lra|lra|].
    - intros z; apply (D_continuous _ (- V1 x mu z)), derivable_pt_lim_opp, Fl.
    - exists z; split; [apply Rabs_le; lra | lra]. }
  destruct Ex as (z & Hz & Ez); assert (U : forall z', Rabs (z' - e) <= rho1 /\ Y1 x mu z' = 0 -> z' = z).
  { intros z' [Hz' Ez']; destruct (Rtotal_order z z') as [O|[O|O]]; [|auto|].
    - pose proof (downhill x mu z z' S Hz Hz' ltac:(lra)); assert (0 < - u1 / 2 * (z' - z)) by (apply
        Rmult_lt_0_compat; lra); lra.
    - pose proof (downhill x mu z' z S Hz' Hz ltac:(lra)); assert (0 < - u1 / 2 * (z - z')) by (apply
        Rmult_lt_0_compat; lra); lra. }
  assert (Es : s = z) by (apply the_spec; [split; assumption | exact U]); rewrite Es; split; [exact Hz | split; [exact
    Ez | split; [|split]]].
  - pose proof (Hsteep x mu z (proj1 S) (proj2 S) Hz) as Q; apply le_abs in Q; lra.
  - intros q Hq O; pose proof (downhill x mu q z S Hq Hz ltac:(lra)); assert (0 < - u1 / 2 * (z - q)) by (apply
      Rmult_lt_0_compat; lra); lra.
  - intros q Hq Eq; apply U; auto.
Qed.
Lemma cross_near r x mu : small r x mu -> r <= r1 -> - u1 * Rabs (cross x mu - e) <= 2 * (@M F * r).
Proof.
  intros S O; destruct (cross_spec x mu (small_less r r1 x mu S O)) as (Hs & Es & _); set (s := cross x mu) in *.
  assert (Re : Rabs (e - e) <= rho1) by (rewrite Rminus_eq_0, Rabs_R0; lra); pose proof (le_abs _ _ Hs) as Hs'.
  destruct (@near_y0 F x mu r s (proj1 S) (proj2 S) ltac:(lra)) as [N _]; rewrite Es in N; apply le_abs in N.
  pose proof (small_zero r1 ltac:(lra)) as S0. destruct (Rle_dec s e) as [Q|Q].
  - pose proof (downhill zero 0 s e S0 Hs Re Q) as D; rewrite !(proj1 (@at_rest F _)), (proj1 Hex) in D.
    rewrite Rabs_left1; lra.
  - pose proof (downhill zero 0 e s S0 Re Hs ltac:(lra)) as D; rewrite !(proj1 (@at_rest F _)), (proj1 Hex) in D.
    rewrite Rabs_pos_eq; lra.
Qed.
Definition after_hit (x : vec) mu := law mu (cross x mu - e) (V1 x mu (cross x mu)).
Definition carry (x : vec) mu : vec := @origin F' mu (cross x mu - e + rho) 0 (after_hit x mu).
Lemma carry_flow x mu : let s := cross x mu - e + rho in Y2 (carry x mu) mu s = 0 /\ V2 (carry x mu) mu s =
  after_hit x mu.
Proof. apply origin_flow. Qed.
Lemma cross_small eps : 0 < eps -> exists d, 0 < d <= r1 /\ forall x mu, small d x mu -> Rabs (cross x mu - e) <= eps.
Proof.
  intros Hp; assert (P : 0 < - u1 * eps / (2 * @M F)) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
  destruct (two_least r1 (- u1 * eps / (2 * @M F)) ltac:(lra) P) as (d & Hd & L1 & L2); exists d; split; [lra|].
  intros x mu S; pose proof (cross_near d x mu S L1) as A; assert (2 * (@M F * d) <= - u1 * eps).
  { apply Rle_trans with (2 * (@M F * (- u1 * eps / (2 * @M F)))); [apply Rmult_le_compat_l; [lra|]; apply
      Rmult_le_compat_l; lra | right; field; lra]. }
  apply Rmult_le_reg_l with (- u1); lra.
Qed.
Lemma hit_small eps : 0 < eps -> exists d, 0 < d <= r1 /\ forall x mu, small d x mu -> Rabs (cross x mu - e) <= eps /\
  Rabs (V1 x mu (cross x mu) - u1) <= eps /\ Rabs (after_hit x mu - u2) <= eps.
Proof.
  intros Hp; set (W := 3 + Rabs Rm + Rabs Rt + Rabs Rv); pose proof (Rabs_pos Rm) as P1; pose proof (Rabs_pos Rt) as P2;
    pose proof (Rabs_pos Rv) as P3. destruct (Hlaw 1 ltac:(lra)) as (dl & Hdl & Law).
  destruct (two_least (eps / W) dl ltac:(apply Rdiv_lt_0_compat; unfold W; lra) Hdl) as (q & Hq & L1 & L2), (two_least q
    eps Hq Hp) as (q' & Hq' & L3 & L4).
  assert (Wq : W * q' <= eps) by (apply Rle_trans with (W * (eps / W)); [apply Rmult_le_compat_l; unfold W in *; lra |
    right; field; unfold W; lra]).
  destruct (@steady_point F e rho He q' Hq') as (d1 & Hd1 & St), (two_least d1 q' ltac:(lra) Hq') as (d1' & Hd1' & L5 &
    L6), (cross_small d1' Hd1') as (d2 & Hd2 & Cs), (two_least d1' d2 Hd1' ltac:(lra)) as (d & Hd & L7 & L8). exists d;
    split; [lra|]; intros x mu S.
  pose proof (Cs x mu (small_less d d2 x mu S L8)) as C1; destruct (St x mu (cross x mu)) as [C2 _]; [intros i Hi; pose
    proof (proj1 S i Hi); lra | destruct S; lra | lra|]. fold u1 in C2. split; [lra | split; [lra|]].
  assert (Zm : Rabs 0 <= dl) by (rewrite Rabs_R0; lra); pose proof (Law mu (cross x mu - e) (V1 x mu (cross x mu)) 0 0
    u1 ltac:(destruct S; lra) ltac:(lra) ltac:(lra) Zm Zm ltac:(rewrite Rminus_eq_0; exact Zm)) as Q; rewrite
    !Rminus_0_r in Q. rewrite <- (proj2 Hen) in Q; fold (after_hit x mu) in Q. destruct S as [_ Hm].
  assert (Hm' : Rabs mu <= q') by lra; assert (Hc' : Rabs (cross x mu - e) <= q') by lra; set (p1 := cross x mu - e) in
    *; set (p2 := V1 x mu (cross x mu) - u1) in *.
  replace (after_hit x mu - u2) with ((after_hit x mu - u2 - (Rm * mu + Rt * p1 + Rv * p2)) + (Rm * mu + Rt * p1 + Rv *
    p2)) by ring. eapply Rle_trans; [apply Rabs_triang|].
  pose proof (product Rm mu _ _ (Rle_refl _) Hm') as B1; pose proof (product Rt p1 _ _ (Rle_refl _) Hc') as B2; pose
    proof (product Rv p2 _ _ (Rle_refl _) C2) as B3. pose proof (Rabs_triang (Rm * mu + Rt * p1) (Rv * p2)); pose proof
    (Rabs_triang (Rm * mu) (Rt * p1)). unfold W in Wq; lra.
Qed.
Lemma carry_small eps : 0 < eps -> exists d, 0 < d <= r1 /\ forall x mu, small d x mu -> within 2 eps (carry x mu).
Proof.
  intros Hp; assert (P : 0 < eps / (2 * @M F')) by (apply Rdiv_lt_0_compat; lra); set (q := eps / (2 * @M F')) in *.
  assert (Mq : @M F' * (2 * q) = eps) by (unfold q; field; lra).
  destruct (@steady_point F' rho rho He2 q P) as (d1 & Hd1 & St), (@flow_lip F' kk' cc' ll' HA' rho rho He2) as (d2 & C
    & Hd2 & HC & Lip).
  destruct (two_least d1 d2 ltac:(lra) ltac:(lra)) as (d3 & Hd3 & L1 & L2), (two_least d3 (q / C) Hd3 ltac:(apply
    Rdiv_lt_0_compat; lra)) as (d4 & Hd4 & L3 & L4), (two_least d4 q Hd4 P) as (d4' & Hd4' & L3' & L4').
  destruct (hit_small d4' Hd4') as (d5 & Hd5 & Hit), (two_least d5 d4' ltac:(lra) Hd4') as (d & Hd & L5 & L6). exists d;
    split; [lra|]; intros x mu S; destruct (Hit x mu (small_less d d5 x mu S L5)) as (C1 & _ & C3).
  destruct (carry_flow x mu) as [E1 E2]; set (s := cross x mu - e + rho) in *.
  assert (Hs : Rabs (s - rho) <= d4') by (replace (s - rho) with (cross x mu - e) by (unfold s; ring); exact C1).
  assert (Cd : C * d4' <= q) by (apply Rle_trans with (C * (q / C)); [apply Rmult_le_compat_l; lra | right; field;
    lra]). assert (Zw : forall r, 0 < r -> within 2 r zero) by (intros r Hr i _; unfold zero; rewrite Rabs_R0; lra).
  assert (Z0 : forall r, 0 < r -> Rabs 0 <= r) by (intros; rewrite Rabs_R0; lra).
  destruct (St zero 0 s) as [N1 _]; [apply Zw; lra | apply Z0; lra | lra|].
  destruct (Lip zero zero 0 0 0 s rho) as [N2 _]; try (apply Zw; lra); try (apply Z0; lra); try lra.
  1: rewrite Rminus_eq_0; apply Z0; lra. 1: intros i _; unfold minus, zero; rewrite Rminus_eq_0, Rabs_R0; lra.
  1: rewrite Rminus_eq_0, Rabs_R0; lra.
  rewrite (proj1 (@at_rest F' rho)), (proj1 Hen), Rminus_0_r, Rplus_0_l in N2.
  assert (N3 : C * Rabs (s - rho) <= C * d4') by (apply Rmult_le_compat_l; lra).
  pose proof (@nearby_back F' (carry x mu) zero mu 0 (2 * q) s) as B; rewrite E1, E2, Rminus_0_r, Rminus_0_l, Rabs_Ropp
    in B. rewrite Mq in B; pose proof (le_abs _ _ Hs); destruct S as [_ Hm].
  assert (B' : within 2 eps (minus (carry x mu) zero)).
  { apply B; [lra | | lra | lra]. replace (after_hit x mu - V2 zero 0 s) with ((after_hit x mu - u2) - (V2 zero 0 s -
      u2)) by ring. eapply Rle_trans; [apply apart | fold u2 in N1; lra]. }
  intros i Hi; specialize (B' i Hi); unfold minus, zero in B'; rewrite Rminus_0_r in B'; exact B'.
Qed.
Lemma carry_rest i : (i < 2)%nat -> carry zero 0 i = 0.
Proof.
  intros Hi; apply Rabs_zero, Rnot_lt_le; intros P; destruct (carry_small (Rabs (carry zero 0 i) / 2) ltac:(lra)) as (d
    & Hd & H). specialize (H zero 0 (small_zero d ltac:(lra)) i Hi); lra.
Qed.

(** The equation linearized about the impact: h is by how much later it is. *)
Definition jump (m : R) (z w z' w' : R -> R) : Prop := exists h, z e + u1 * h = 0 /\ z' rho + u2 * h = 0 /\
  w' rho + acc2 * h = Rm * m + Rt * h + Rv * (w e + acc1 * h).
Notation lin := (solves kk cc ll). Notation lin' := (solves kk' cc' ll').
Theorem carry_strict eps : 0 < eps -> exists d, 0 < d <= r1 /\ forall x x' mu mu' t z w z' w', small d x mu ->
  small d x' mu' -> within 2 t (minus x x') -> Rabs (mu - mu') <= t -> lin (mu - mu') z w ->
  z 0 = x 0%nat - x' 0%nat -> w 0 = x 1%nat - x' 1%nat -> lin' (mu - mu') z' w' -> jump (mu - mu') z w z' w' ->
  Rabs (carry x mu 0%nat - carry x' mu' 0%nat - z' 0) <= eps * t /\
  Rabs (carry x mu 1%nat - carry x' mu' 1%nat - w' 0) <= eps * t.
Proof.
  intros Hp; pose proof (proj2 Hex) as U1; set (w := - u1) in *; assert (Pw : 0 < w) by (unfold w; lra).
  destruct (@flow_lip F kk cc ll HA e rho He) as (dA & C1 & HdA & HC1 & LipA), (@flow_lip F' kk' cc' ll' HA' rho rho
    He2) as (dB & C2 & HdB & HC2 & LipB).
  set (Ct := 2 * @M F / w + 1); assert (HCt : 1 <= Ct /\ w * Ct = 2 * @M F + w).
  { split; [|unfold Ct; field; lra]; unfold Ct; assert (0 < 2 * @M F / w) by (apply Rdiv_lt_0_compat; lra); lra. }
  destruct HCt as [HCt ECt]; set (G := 1 + Ct); set (H := G / w); assert (EH : w * H = G) by (unfold H; field; lra).
  assert (HH : 0 < H) by (apply Rdiv_lt_0_compat; unfold G; lra).
  set (A1 := Rabs acc1); set (A2 := Rabs acc2); set (Bt := Rabs Rt); set (Bv := Rabs Rv); set (Bm := Rabs Rm); set (Bu
    := Rabs u2).
  assert (P0 : 0 <= A1 /\ 0 <= A2 /\ 0 <= Bt /\ 0 <= Bv /\ 0 <= Bm /\ 0 <= Bu) by (repeat split; apply Rabs_pos).
  set (K1 := G + C1 * G + Bt * H + Bv * (G + A1 * H)); set (K2 := Bm + Bt * Ct + Bv * (C1 * G) + G + C1 * G).
  assert (G0 : 2 <= G) by (unfold G; lra). assert (Q1 : 0 <= C1 * G /\ 0 <= Bt * H /\ 0 <= Bv * (G + A1 * H) /\ 0 <= Bt
    * Ct /\ 0 <= Bv * (C1 * G) /\ 0 <= C2 * Ct).
  { assert (0 <= C1 * G) by (apply Rmult_le_pos; lra). assert (0 <= A1 * H) by (apply Rmult_le_pos; lra). repeat split;
      try apply Rmult_le_pos; lra. }
  assert (HK1 : 0 <= K1 /\ 0 <= K2) by (unfold K1, K2; lra); set (K3 := 1 + K2 + C2 * Ct); assert (HK3 : 1 <= K3) by
    (unfold K3; lra). set (W := @M F' * K3 + Ct); assert (HW0 : 0 <= @M F' * K3) by (apply Rmult_le_pos; lra).
  assert (HW : 1 <= W) by (unfold W; lra). set (KK := @M F' * (2 * W + Bu * H + K1 + A2 * H) + 1).
  assert (HKK : 1 <= KK) by (unfold KK; assert (0 <= Bu * H /\ 0 <= A2 * H) by (split; apply Rmult_le_pos; lra); assert
    (0 <= @M F' * (2 * W + Bu * H + K1 + A2 * H)) by (apply Rmult_le_pos; lra); lra).
  destruct (two_least 1 (w / 4) ltac:(lra) ltac:(lra)) as (e0 & He0 & L1 & L2), (two_least e0 (eps / KK) He0 ltac:(apply
    Rdiv_lt_0_compat; lra)) as (e1 & He1 & L3 & L4).
  assert (Ke : KK * e1 <= eps) by (apply Rle_trans with (KK * (eps / KK)); [apply Rmult_le_compat_l; lra | right; field;
    lra]).
  destruct (@flow_point F kk cc ll HA e rho He e1 He1) as (d1 & Hd1 & Pt1), (@flow_point F' kk' cc' ll' HA' rho rho He2
    e1 He1) as (d2 & Hd2 & Pt2), (Hlaw e1 He1) as (d3 & Hd3 & Law).
  destruct (two_least d1 dA ltac:(lra) ltac:(lra)) as (q1 & Hq1 & M1 & M2), (two_least q1 d3 Hq1 Hd3) as (q2 & Hq2 & M3
    & M4), (two_least d2 dB ltac:(lra) ltac:(lra)) as (q3 & Hq3 & M5 & M6), (two_least q2 q3 Hq2 Hq3) as (q & Hq & M7 &
    M8).
  destruct (hit_small q Hq) as (d4 & Hd4 & Hit), (carry_small q Hq) as (d5 & Hd5 & Car), (two_least d4 d5 ltac:(lra)
    ltac:(lra)) as (q4 & Hq4 & M9 & M10), (two_least q4 q Hq4 Hq) as (d & Hd & M11 & M12). exists d; split; [lra|].
  intros x x' mu mu' t z w0 z' w' S S' Hxt Hmt Z Ez Ew Z' (h & J1 & J2 & J3).
  assert (t0 : 0 <= t) by (pose proof (Rabs_pos (mu - mu')); lra).
  destruct (Hit x mu (small_less d d4 x mu S ltac:(lra))) as (T1 & V1' & _), (Hit x' mu' (small_less d d4 x' mu' S'
    ltac:(lra))) as (T2 & V2' & _).
  destruct (cross_spec x mu (small_less d r1 x mu S ltac:(lra))) as (_ & E1 & _), (cross_spec x' mu' (small_less d r1 x'
    mu' S' ltac:(lra))) as (_ & E2 & _).
  assert (Wi : forall x mu r, small d x mu -> d <= r -> within 2 r x /\ Rabs mu <= r) by (intros u m r Su Hr; apply
    (small_less d r u m Su Hr)).
  pose proof (Car x mu (small_less d d5 x mu S ltac:(lra))) as X; pose proof (Car x' mu' (small_less d d5 x' mu' S'
    ltac:(lra))) as X'. destruct (carry_flow x mu) as [E3 E4], (carry_flow x' mu') as [E5 E6].
  set (s := cross x mu) in *; set (s' := cross x' mu') in *; set (D := s - s').
  destruct (Pt1 x x' mu mu' t s s' z w0) as [B1 B2]; try apply (Wi _ _ d1 S); try apply (Wi _ _ d1 S'); trivial; try
      lra.
  rewrite E1, E2, Rminus_0_r, Rminus_0_l, Rabs_Ropp in B1; fold D in B1, B2; fold u1 in B1.
  assert (Zs : Rabs (z e) <= @M F * t) by (apply (@lin_size F kk cc ll HA (mu - mu') z w0 t Z); try lra; [rewrite Ez;
    apply (Hxt 0%nat); lia | rewrite Ew; apply (Hxt 1%nat); lia]).
  assert (DB : Rabs D <= Ct * t).
  { pose proof (apart (z e + u1 * D) (z e)) as Q; replace (z e + u1 * D - z e) with (- (w * D)) in Q by (unfold w;
      ring); rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq w) in Q by lra.
    assert (e1 * (t + Rabs D) <= w / 4 * (t + Rabs D)) by (apply Rmult_le_compat_r; [pose proof (Rabs_pos D) |]; lra).
    apply Rmult_le_reg_l with w; [exact Pw|]; rewrite <- Rmult_assoc, ECt. assert (0 <= @M F * t /\ 0 <= w * t) by
      (split; apply Rmult_le_pos; lra). lra. }
  set (b := e1 * t); assert (b0 : 0 <= b) by (apply Rmult_le_pos; lra).
  assert (Gb : e1 * (t + Rabs D) <= G * b).
  { replace (G * b) with (e1 * (t + Ct * t)) by (unfold G, b; ring); apply Rmult_le_compat_l; lra. }
  assert (Dh : Rabs (D - h) <= H * b).
  { apply Rmult_le_reg_l with w; [exact Pw|]; rewrite <- Rmult_assoc, EH, <- (Rabs_pos_eq w), <- Rabs_mult by lra.
    replace (w * (D - h)) with (- (z e + u1 * D - (z e + u1 * h))) by (unfold w; ring); rewrite J1, Rminus_0_r,
      Rabs_Ropp; lra. }
  destruct (LipA x x' mu mu' t s s') as [_ LV]; try apply (Wi _ _ dA S); try apply (Wi _ _ dA S'); trivial; try lra.
    fold D in LV. set (dV := V1 x mu s - V1 x' mu' s') in *.
  assert (Tg : t + Rabs D <= G * t) by (unfold G; lra).
  assert (LV' : Rabs dV <= C1 * G * t) by (apply Rle_trans with (1 := LV); rewrite Rmult_assoc; apply Rmult_le_compat_l;
    lra).
  set (qv := w0 e + acc1 * h) in *; pose proof (product acc1 (D - h) A1 (H * b) (Rle_refl _) Dh) as Y1'.
  assert (X1 : Rabs (dV - qv) <= (G + A1 * H) * b).
  { replace (dV - qv) with ((dV - (w0 e + acc1 * D)) + acc1 * (D - h)) by (unfold qv; ring); eapply Rle_trans; [apply
      Rabs_triang | lra]. }
  pose proof (Law mu (s - e) (V1 x mu s) mu' (s' - e) (V1 x' mu' s') ltac:(destruct S; lra) ltac:(lra) ltac:(lra)
    ltac:(destruct S'; lra) ltac:(lra) ltac:(lra)) as La; change (law mu (s - e) (V1 x mu s)) with (after_hit x mu) in
    La; change (law mu' (s' - e) (V1 x' mu' s')) with (after_hit x' mu') in La; replace (s - e - (s' - e)) with D in La
    by (unfold D; ring); fold dV in La. set (dl := after_hit x mu - after_hit x' mu') in *.
  assert (Lt : Rabs (mu - mu') + Rabs D + Rabs dV <= (G + C1 * G) * t) by (unfold G at 1; lra).
  assert (La1 : e1 * (Rabs (mu - mu') + Rabs D + Rabs dV) <= (G + C1 * G) * b).
  { replace ((G + C1 * G) * b) with (e1 * ((G + C1 * G) * t)) by (unfold b; ring); apply Rmult_le_compat_l; lra. }
  assert (La2 : (G + C1 * G) * b <= (G + C1 * G) * t) by (apply Rmult_le_compat_l; [lra|]; unfold b; rewrite <-
    (Rmult_1_l t) at 2; apply Rmult_le_compat_r; lra).
  pose proof (product Rt (D - h) Bt (H * b) (Rle_refl _) Dh) as Y2'; pose proof (product Rv (dV - qv) Bv _ (Rle_refl _)
    X1) as Y3. pose proof (product Rm (mu - mu') Bm t (Rle_refl _) Hmt) as Y4; pose proof (product Rt D Bt (Ct * t)
    (Rle_refl _) DB) as Y5; pose proof (product Rv dV Bv _ (Rle_refl _) LV') as Y6.
  assert (X2 : Rabs (dl - (Rm * (mu - mu') + Rt * h + Rv * qv)) <= K1 * b).
  { replace (dl - (Rm * (mu - mu') + Rt * h + Rv * qv)) with ((dl - (Rm * (mu - mu') + Rt * D + Rv * dV)) + (Rt * (D -
      h) + Rv * (dV - qv))) by ring. eapply Rle_trans; [apply Rabs_triang|]; pose proof (Rabs_triang (Rt * (D - h)) (Rv
      * (dV - qv))). replace (K1 * b) with ((G + C1 * G) * b + (Bt * (H * b) + Bv * ((G + A1 * H) * b))) by (unfold K1;
      ring); lra. }
  assert (X3 : Rabs dl <= K2 * t).
  { replace dl with ((dl - (Rm * (mu - mu') + Rt * D + Rv * dV)) + (Rm * (mu - mu') + Rt * D + Rv * dV)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; pose proof (Rabs_triang (Rm * (mu - mu') + Rt * D) (Rv * dV)); pose proof
      (Rabs_triang (Rm * (mu - mu')) (Rt * D)). replace (K2 * t) with (Bm * t + Bt * (Ct * t) + Bv * (C1 * G * t) + (G +
      C1 * G) * t) by (unfold K2; ring); lra. }
  set (p := s - e + rho) in *; set (p' := s' - e + rho) in *; assert (Epp : p - p' = D) by (unfold p, p', D; ring).
  assert (Tp : Rabs (p - rho) <= q) by (replace (p - rho) with (s - e) by (unfold p; ring); exact T1); assert (Tp' :
    Rabs (p' - rho) <= q) by (replace (p' - rho) with (s' - e) by (unfold p'; ring); exact T2).
  assert (Z0 : within 2 0 (minus (carry x' mu') (carry x' mu'))) by (intros i _; unfold minus; rewrite Rminus_eq_0,
    Rabs_R0; lra). assert (Wq : forall y r, within 2 q y -> q <= r -> within 2 r y) by (intros y r Hy Hr i Hi;
    specialize (Hy i Hi); lra).
  destruct (LipB (carry x' mu') (carry x' mu') mu' mu' 0 p' p) as [N1 N2]; try (apply Wq; [exact X' | lra]); try apply
    (Wi _ _ dB S'); trivial; try lra; try (rewrite Rminus_eq_0, Rabs_R0; lra).
  rewrite Rplus_0_l, (Rabs_minus_sym p'), Epp in N1, N2; assert (N3 : C2 * Rabs D <= C2 * Ct * t) by (rewrite
    Rmult_assoc; apply Rmult_le_compat_l; lra). rewrite E5 in N1; rewrite E6 in N2.
  assert (K3t : K3 * t = t + K2 * t + C2 * Ct * t) by (unfold K3; ring); assert (P3 : 0 <= K2 * t /\ 0 <= C2 * Ct * t)
    by (split; apply Rmult_le_pos; lra). pose proof (le_abs _ _ Tp) as Tp0.
  assert (XX : within 2 (@M F' * (K3 * t)) (minus (carry x mu) (carry x' mu'))).
  { apply (@nearby_back F' (carry x mu) (carry x' mu') mu mu' (K3 * t) p); [| | |lra].
    - rewrite E3; lra.
    - rewrite E4; replace (after_hit x mu - V2 (carry x' mu') mu' p) with (dl + (after_hit x' mu' - V2 (carry x' mu')
      mu' p)) by (unfold dl; ring). eapply Rle_trans; [apply Rabs_triang | lra].
    - lra. }
  set (t2 := @M F' * (K3 * t)) in *; assert (t2 >= t) by (unfold t2; assert (1 * t <= K3 * t) by (apply
    Rmult_le_compat_r; lra); assert (1 * (K3 * t) <= @M F' * (K3 * t)) by (apply Rmult_le_compat_r; lra); lra).
  destruct (proj2 (proj2 HA') (mu - mu') 0 (carry x mu 0%nat - carry x' mu' 0%nat) (carry x mu 1%nat - carry x' mu'
    1%nat)) as (z3 & w3 & Z3 & I3 & I4).
  destruct (Pt2 (carry x mu) (carry x' mu') mu mu' t2 p p' z3 w3) as [B3 B4]; try (apply Wq; [assumption | lra]); try
    apply (Wi _ _ d2 S); try apply (Wi _ _ d2 S'); trivial; try lra.
  rewrite E3, E5, Rminus_0_r, Rminus_0_l, Rabs_Ropp, Epp in B3; rewrite E4, E6, Epp in B4; fold u2 in B3; fold dl in B4.
  assert (Wb : e1 * (t2 + Rabs D) <= W * b).
  { replace (W * b) with (e1 * (@M F' * (K3 * t) + Ct * t)) by (unfold W, b; ring); apply Rmult_le_compat_l; [lra |
    unfold t2; lra]. }
  pose proof (product u2 (D - h) Bu (H * b) (Rle_refl _) Dh) as Y7; pose proof (product acc2 (D - h) A2 (H * b)
    (Rle_refl _) Dh) as Y8.
  assert (F1 : Rabs (z3 rho - z' rho) <= W * b + Bu * (H * b)).
  { replace (z3 rho - z' rho) with ((z3 rho + u2 * D) - u2 * (D - h) - (z' rho + u2 * h)) by ring; rewrite J2,
    Rminus_0_r; eapply Rle_trans; [apply apart | lra]. }
  assert (F2 : Rabs (w3 rho - w' rho) <= W * b + K1 * b + A2 * (H * b)).
  { replace (w3 rho - w' rho) with ((dl - (Rm * (mu - mu') + Rt * h + Rv * qv)) - (dl - (w3 rho + acc2 * D)) - acc2 * (D
    - h) + ((Rm * (mu - mu') + Rt * h + Rv * qv) - (w' rho + acc2 * h))) by ring. rewrite <- J3, Rminus_eq_0, Rplus_0_r;
    eapply Rle_trans; [apply apart|]; pose proof (apart (dl - (w' rho + acc2 * h)) (dl - (w3 rho + acc2 * D))); rewrite
      J3 in *; lra. }
  assert (Hu : S.linearized (@T F') kk' cc' ll' 0 (fun t => z3 t - z' t) (fun t => w3 t - w' t)).
  { intros u _; destruct (Z3 u) as [D1 D2], (Z' u) as [D3 D4]; split; [apply D_minus; assumption|]; eapply D_value;
    [apply D_minus; eassumption | ring]. }
  pose proof (S.linear_back (@T F') (@L F') kk' cc' ll' HL2 (proj1 HA') _ _ Hu rho ltac:(lra)) as Fin; cbv beta in Fin.
  set (kb := 2 * (1 + @L F') * exp ((2 * @L F' + 1) * @T F')) in *; assert (Mk : @M F' = 3 * kb) by reflexivity.
  assert (Sum : kb * (Rabs (z3 rho - z' rho) + Rabs (w3 rho - w' rho)) <= @M F' * ((2 * W + Bu * H + K1 + A2 * H) * b)).
  { pose proof (Rabs_pos (z3 rho - z' rho)); pose proof (Rabs_pos (w3 rho - w' rho)); apply Rmult_le_compat; lra. }
  assert (KKb : @M F' * ((2 * W + Bu * H + K1 + A2 * H) * b) <= eps * t).
  { apply Rle_trans with (KK * e1 * t); [|apply Rmult_le_compat_r; lra]; replace (KK * e1 * t) with (@M F' * ((2 * W +
    Bu * H + K1 + A2 * H) * b) + b) by (unfold KK, b; ring); lra. }
  pose proof (Rabs_pos (z3 0 - z' 0)); pose proof (Rabs_pos (w3 0 - w' 0)); rewrite <- I3, <- I4; split; lra.
Qed.
(** The derivative of [carry]: what the linearized equation makes of the state. *)
Lemma jump_exists m z w : exists z' w', lin' m z' w' /\ jump m z w z' w'.
Proof.
  pose proof (proj2 Hex) as U1; set (h := - z e / u1); destruct (proj2 (proj2 HA') m rho (- (u2 * h)) (Rm * m + Rt * h +
    Rv * (w e + acc1 * h) - acc2 * h)) as (z' & w' & Z & E1 & E2). exists z', w'; split; [exact Z|]; exists h; rewrite
    E1, E2; split; [unfold h; field; lra | split; ring].
Qed.
Theorem carry_matrix : exists (A : nat -> vec) (phi : vec), (forall i, (i < 2)%nat -> strict 2 (fun x mu => carry x mu
  i) (dot 2 (A i)) (phi i)) /\ forall m z w z' w', lin m z w -> lin' m z' w' -> jump m z w z' w' ->
  z' 0 = A 0%nat 0%nat * z 0 + A 0%nat 1%nat * w 0 + m * phi 0%nat /\
  w' 0 = A 1%nat 0%nat * z 0 + A 1%nat 1%nat * w 0 + m * phi 1%nat.
Proof.
  apply (matrix_exists F kk cc ll kk' cc' ll' HA carry jump).
  - exact carry_rest.
  - intros eps Hp; destruct (carry_strict eps Hp) as (d & Hd & H); exists d; split; [lra | exact H].
  - exact jump_exists.
  - intros m x y p1 q1 p2 q2 p3 q3 z1 w1 z2 w2 z3 w3 (h1 & X1 & X2 & X3) (h2 & X4 & X5 & X6) (h3 & X7 & X8 & X9).
    exists (x * h1 + y * h2 + m * h3); split; [|split].
    + replace (x * p1 e + y * p2 e + m * p3 e + u1 * (x * h1 + y * h2 + m * h3)) with (x * (p1 e + u1 * h1) + y * (p2 e
      + u1 * h2) + m * (p3 e + u1 * h3)) by ring; rewrite X1, X4, X7; ring.
    + replace (x * z1 rho + y * z2 rho + m * z3 rho + u2 * (x * h1 + y * h2 + m * h3)) with (x * (z1 rho + u2 * h1) + y
      * (z2 rho + u2 * h2) + m * (z3 rho + u2 * h3)) by ring; rewrite X2, X5, X8; ring.
    + replace (x * w1 rho + y * w2 rho + m * w3 rho + acc2 * (x * h1 + y * h2 + m * h3)) with (x * (w1 rho + acc2 * h1)
      + y * (w2 rho + acc2 * h2) + m * (w3 rho + acc2 * h3)) by ring; rewrite X3, X6, X9; ring.
  - intros m z w z2 w2 z' w' z2' w2' L L2 E1 E2 (h & Y1' & Y2' & Y3') (h' & Y4 & Y5 & Y6) Z Z'.
    destruct (lin_forward F kk cc ll HA m z w z2 w2 e L L2 ltac:(lra) E1 E2) as [E3 E4]; rewrite <- E3 in Y4; rewrite <-
      E4 in Y6. assert (Eh : h' = h) by (apply (Rmult_eq_reg_l u1); [|pose proof (proj2 Hex)]; lra); rewrite Eh in Y5,
      Y6. apply (@lin_same F' kk' cc' ll' HA' m z' w' z2' w2' rho Z Z'); lra.
Qed.
End Stage.
