(** * Proof of Theorem 1 for nonlinear oscillators: away from the orbit the force is changed, which no motion
    notices *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs Derivatives PlaneOrbits StatementWords StatementUnstable Headline.
From Grazing Require Import StatementNonlinear NonlinearSmooth NonlinearPicard.
From Grazing Require NonlinearFlow NonlinearTouch NonlinearKick NonlinearMotions NonlinearWords.
Import Nonlinear.
Open Scope R_scope.

(** Instability goes over to weaker demands on motions, and to the same impacts. *)
Lemma unstable_same (leg leg' : (Z -> R) -> (Z -> R -> R) -> (Z -> R -> R) -> Z -> Z -> Prop) t v t' v' :
  (forall t y v i j, leg t y v i j -> leg' t y v i j) -> (forall i, t' i = t i /\ v' i (t' i) = v i (t i)) ->
    unstable_motion leg t v -> unstable_motion leg' t' v'.
Proof.
  intros HL E (r & Hr & H); exists r; split; [exact Hr|]; intros j eps He; destruct (H j eps He) as (l & s & y & w & Hl
    & Lg & Nj & Nl); exists l, s, y, w; split; [exact Hl | split; [intros i Hi; apply HL, Lg, Hi|]].
  unfold near in *; destruct (E j) as [E1 E2], (E l) as [E3 E4]; rewrite E2, E4, E1, E3; auto.
Qed.

Section Clamp.
Variable r : R.
Hypothesis Hr : 0 < r.
Definition cl x := Rmax (- r) (Rmin r x).
Lemma cl_in x : Rabs (cl x) <= r.
Proof. unfold cl, Rmax, Rmin; repeat destruct Rle_dec; apply Rabs_le; lra. Qed.
Lemma cl_id x : Rabs x <= r -> cl x = x.
Proof. intros H; apply le_abs in H; unfold cl, Rmax, Rmin; repeat destruct Rle_dec; lra. Qed.
Lemma cl_lip x y : Rabs (cl x - cl y) <= Rabs (x - y).
Proof. unfold cl, Rmax, Rmin, Rabs; repeat destruct Rle_dec; repeat destruct Rcase_abs; lra. Qed.
End Clamp.

(** Continuous periodic functions are bounded. *)
Lemma periodic_bounded f T : 0 < T -> (forall t, continuity_pt f t) -> (forall t, f (t + T) = f t) -> exists B, 0 <=
  B /\ forall t, Rabs (f t) <= B.
Proof.
  intros HT C P; destruct (continuous_bounded f T HT C) as (B & HB & H); exists B; split; [exact HB|]; intros t;
    destruct (in_one_period T t HT) as (z & Hz). replace t with (t - T * IZR z + T * IZR z) by ring; rewrite whole by
    exact P; apply H, Rabs_le; lra.
Qed.

(** Theorem 1 of motions, and that they are unstable. *)
Definition decided (O : Nonlinear.t) (a1 a2 gamma rate : R) : Prop := forall n_max, exists d, d > 0 /\ forall eps, 0 <
  eps <= d -> exists mu0, mu0 > 0 /\
  forall (n : Z -> nat) (N : Z -> Z) e g mu, (forall i, (1 <= n i <= n_max)%nat /\ u a1 a2 (n i) <> 0) ->
  (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z -> sgn g * gamma > 0 -> 0 < sgn e * (rate * mu) < mu0 ->
  ((forall i, member a1 a2 e (n i) /\ edge a1 a2 e g (n i) (n (i + 1)%Z)) -> one_nonlinear_motion O mu eps N /\ forall
    t y v, nonlinear_motion O mu
    eps N t y v -> unstable_motion (leg O mu eps N) t v) /\
  ((exists i, breaks a1 a2 e g (n i) (n (i + 1)%Z)) -> forall t y v, ~ nonlinear_motion O mu d N t y v).

Section Main.
Variables (O : Nonlinear.t) (a1 a2 gamma rate : R).
Hypothesis HO : grazing_orbit O.
Hypothesis HG : generic O a1 a2 gamma rate.
Variables (L0 r : R).
Hypothesis Hr : 0 < r.
Hypothesis HLip : forall t y v mu t' y' v' mu', tube O r t y v -> tube O r t' y' v' -> Rabs mu <= r -> Rabs mu' <= r ->
  Rabs (a O t y v mu - a O t' y' v' mu') <= L0 * (Rabs (t - t') + Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu')).
Notation cl := (cl r).
Definition a' t y v mu := a O t (y0 O t + cl (y - y0 O t)) (v0 O t + cl (v - v0 O t)) (cl mu).
Lemma agree t y v mu : tube O r t y v -> Rabs mu <= r -> a' t y v mu = a O t y v mu.
Proof. intros [A B] C; unfold a'; rewrite !cl_id by assumption; f_equal; ring. Qed.
Lemma in_tube t y v : tube O r t (y0 O t + cl (y - y0 O t)) (v0 O t + cl (v - v0 O t)).
Proof. split; (match goal with |- Rabs (?u + ?w - ?u) <= _ => replace (u + w - u) with w by ring end; apply cl_in, Hr).
Qed.
Lemma on_orbit t : tube O r t (y0 O t) (v0 O t).
Proof. split; rewrite Rminus_eq_0, Rabs_R0; lra. Qed.

Lemma T_pos : 0 < T O.
Proof. apply HO. Qed.
Let L1 := Rabs L0.
Lemma L1_lip x y : 0 <= y -> x <= L0 * y -> x <= L1 * y.
Proof. intros H H'; apply Rle_trans with (1 := H'), Rmult_le_compat_r; [exact H | apply Rle_abs]. Qed.
Lemma C_orbit : (forall t, continuity_pt (y0 O) t) /\ (forall t, continuity_pt (v0 O) t).
Proof. split; intros t; destruct (orbit_moves O HO t) as [A B];
  [apply (D_continuous _ _ _ A) | apply (D_continuous _ _ _ B)]. Qed.
Lemma orbit_bound : exists B, 0 <= B /\ forall t, Rabs (v0 O t) <= B /\ Rabs (a O t (y0 O t) (v0 O t) 0) <= B. Proof.
  destruct C_orbit as [Cy Cv]; destruct (period O HO) as (HT & Pa & _ & Po).
  destruct (periodic_bounded (v0 O) (T O) HT Cv ltac:(intros t; apply Po)) as (B1 & P1 & H1).
  destruct (periodic_bounded (fun t => a O t (y0 O t) (v0 O t) 0) (T O) HT) as (B2 & P2 & H2).
  - intros t e He; assert (Pl : 0 <= L1) by apply Rabs_pos;
      assert (Pq : 0 < e / (4 * (L1 + 1))) by (apply Rdiv_lt_0_compat; lra); set (q := e / (4 * (L1 + 1))) in *.
    destruct (continuous_near _ t q (Cy t) Pq) as (d1 & D1 & N1), (continuous_near _ t q (Cv t) Pq) as (d2 & D2 & N2).
    destruct (two_least d1 d2 D1 D2) as (d3 & D3 & A1 & A2), (two_least d3 q D3 Pq) as (d & Hd & A3 & A4); exists d;
      split; [exact Hd|]. intros s [_ Hs]; cbn in *; unfold R_dist in *; specialize (N1 s ltac:(lra));
      specialize (N2 s ltac:(lra)). eapply Rle_lt_trans;
      [apply L1_lip; [|apply HLip; try apply on_orbit; rewrite Rabs_R0; lra]|].
    + pose proof (Rabs_pos (s - t)); pose proof (Rabs_pos (y0 O s - y0 O t)); pose proof (Rabs_pos (v0 O s - v0 O t));
        pose proof (Rabs_pos (0 - 0)); lra.
    + rewrite Rminus_0_r, Rabs_R0; apply Rle_lt_trans with ((L1 + 1) * (3 * q));
        [apply Rmult_le_compat; try lra|unfold q; replace ((L1 + 1) * (3 * (e / (4 * (L1 + 1))))) with (3 * e / 4)
          by (field; lra); lra]. pose proof (Rabs_pos (s - t)); pose proof (Rabs_pos (y0 O s - y0 O t));
        pose proof (Rabs_pos (v0 O s - v0 O t)); lra.
  - intros t; destruct (Po t) as [-> ->]; apply Pa.
  - exists (B1 + B2); split; [lra|]; intros t; specialize (H1 t); specialize (H2 t); lra.
Qed.
Lemma a'_Lipschitz : exists L, 1 <= L /\ (forall t y v mu t' y' v' mu', Rabs (a' t y v mu - a' t' y' v' mu') <=
  L * (Rabs (t - t') + Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu'))) /\ forall y v mu, exists A, forall t,
    Rabs (a' t y v mu) <= A.
Proof.
  destruct orbit_bound as (B & HB & Hb); assert (Pl : 0 <= L1) by apply Rabs_pos.
  assert (Yl : forall t t', Rabs (y0 O t - y0 O t') <= B * Rabs (t - t')) by (intros t t'; apply (mvt (y0 O) (v0 O));
    [intros s; apply (orbit_moves O HO) | intros s _; apply Hb]).
  assert (Vl : forall t t', Rabs (v0 O t - v0 O t') <= B * Rabs (t - t')) by (intros t t'; apply (mvt (v0 O) (fun s => a
    O s (y0 O s) (v0 O s) 0)); [intros s; apply (orbit_moves O HO) | intros s _; apply Hb]). exists (1 + L1 * (1 + 4 *
    B)); assert (0 <= L1 * (1 + 4 * B)) by (apply Rmult_le_pos; lra); split; [lra | split].
  - intros t y v mu t' y' v' mu'; pose proof (Rabs_pos (t - t')); pose proof (Rabs_pos (y - y')); pose proof (Rabs_pos
      (v - v')); pose proof (Rabs_pos (mu - mu')).
    assert (One : forall f u u', Rabs (f t - f t') <= B * Rabs (t - t') -> Rabs (f t + cl (u - f t) - (f t' + cl (u' - f
      t'))) <= 2 * B * Rabs (t - t') + Rabs (u - u')).
    { intros f u u' Hf; pose proof (cl_lip r Hr (u - f t) (u' - f t')) as Q; replace (u - f t - (u' - f t')) with ((u -
        u') - (f t - f t')) in Q by ring.
      pose proof (apart (u - u') (f t - f t')); replace (f t + cl (u - f t) - (f t' + cl (u' - f t'))) with ((f t - f
        t') + (cl (u - f t) - cl (u' - f t'))) by ring. eapply Rle_trans; [apply Rabs_triang | lra]. }
    pose proof (One (y0 O) y y' (Yl t t')) as Q1; pose proof (One (v0 O) v v' (Vl t t')) as Q2; pose proof (cl_lip r Hr
      mu mu') as Q3. unfold a'; eapply Rle_trans; [apply L1_lip; [|apply HLip; try apply in_tube; apply cl_in, Hr]|].
    + repeat apply Rplus_le_le_0_compat; apply Rabs_pos.
    + set (S := Rabs (t - t') + Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu')); apply Rle_trans with (L1 * ((1 + 4 *
        B) * S)).
      * apply Rmult_le_compat_l; [exact Pl|]; assert (0 <= B * Rabs (y - y')) by (apply Rmult_le_pos; lra); assert (0 <=
          B * Rabs (v - v')) by (apply Rmult_le_pos; lra); assert (0 <= B * Rabs (mu - mu')) by (apply Rmult_le_pos;
          lra); unfold S; lra.
      * assert (0 <= S) by (unfold S; lra); lra.
  - intros y v mu; exists (B + L1 * (3 * r)); intros t.
    replace (a' t y v mu) with ((a' t y v mu - a O t (y0 O t) (v0 O t) 0) + a O t (y0 O t) (v0 O t) 0) by ring; eapply
      Rle_trans; [apply Rabs_triang|]. destruct (Hb t) as [_ Hbt]; assert (Rabs (a' t y v mu - a O t (y0 O t) (v0 O t)
      0) <= L1 * (3 * r)); [|lra]. unfold a'; eapply Rle_trans; [apply L1_lip; [|apply HLip; [apply in_tube | apply
      on_orbit | apply cl_in, Hr | rewrite Rabs_R0; lra]]|].
    + repeat apply Rplus_le_le_0_compat; apply Rabs_pos.
    + apply Rmult_le_compat_l; [exact Pl|]; rewrite Rminus_eq_0, Rabs_R0, Rminus_0_r; pose proof (cl_in r Hr (y - y0 O
        t)); pose proof (cl_in r Hr (v - v0 O t)); pose proof (cl_in r Hr mu).
      replace (y0 O t + cl (y - y0 O t) - y0 O t) with (cl (y - y0 O t)) by ring; replace (v0 O t + cl (v - v0 O t) - v0
        O t) with (cl (v - v0 O t)) by ring; lra.
Qed.

Lemma v0_touch : v0 O (tG O) = 0.
Proof.
  destruct (touches O HO) as [HtG Z]; pose (D := (exist _ (v0 O (tG O)) (proj1 (orbit_moves O HO (tG O)))) :
    derivable_pt (y0 O) (tG O)).
  change (derive_pt (y0 O) (tG O) D = 0); apply (deriv_minimum (y0 O) 0 (T O)); try lra; intros x H1 H2. rewrite Z;
    destruct (Req_dec x (tG O)) as [->|Ne]; [lra | left; apply (open_elsewhere O HO); lra].
Qed.

Lemma linear_solutions m s p q : exists z w, NonlinearKick.solves (k O) (c O) (l O) m z w /\ z s = p /\ w s = q.
Proof.
  pose proof T_pos as HT; pose proof (along_facts O HO) as C.
  destruct (periodic_bounded (k O) (T O) HT ltac:(intros t; apply C) ltac:(intros t; apply C)) as (B1 & P1 & H1).
  destruct (periodic_bounded (c O) (T O) HT ltac:(intros t; apply C) ltac:(intros t; apply C)) as (B2 & P2 & H2).
  destruct (periodic_bounded (l O) (T O) HT ltac:(intros t; apply C) ltac:(intros t; apply C)) as (B3 & P3 & H3).
  apply (linear_picard _ _ _ (B1 + B2 + B3)); intros t; [destruct (C t) as (C1 & C2 & C3 & _); auto|].
  specialize (H1 t); specialize (H2 t); specialize (H3 t); lra.
Qed.

Theorem main : decided O a1 a2 gamma rate.
Proof.
  intros n_max.
  destruct a'_Lipschitz as (La & HLa & Lip & Bd); pose proof T_pos as HT; pose proof (along_facts O HO) as C; destruct
    (period O HO) as (_ & Pa & Pr & Po); destruct (touches O HO) as [HtG Z0].
  destruct (periodic_bounded (k O) (T O) HT ltac:(intros t; apply C) ltac:(intros t; apply C)) as (B1 & P1 & H1).
  destruct (periodic_bounded (c O) (T O) HT ltac:(intros t; apply C) ltac:(intros t; apply C)) as (B2 & P2 & H2).
  destruct (periodic_bounded (l O) (T O) HT ltac:(intros t; apply C) ltac:(intros t; apply C)) as (B3 & P3 & H3).
  set (L := La + B1 + B2 + B3); assert (HL : 1 <= L) by (unfold L; lra).
  assert (Lip' : forall t y v mu t' y' v' mu', Rabs (a' t y v mu - a' t' y' v' mu') <= L * (Rabs (t - t') + Rabs (y -
    y') + Rabs (v - v') + Rabs (mu - mu'))).
  { intros t y v mu t' y' v' mu'; apply Rle_trans with (1 := Lip t y v mu t' y' v' mu'), Rmult_le_compat_r; [repeat
      apply Rplus_le_le_0_compat; apply Rabs_pos | unfold L; lra]. }
  assert (Per : forall t y v mu, a' (t + T O) y v mu = a' t y v mu) by (intros t y v mu; unfold a'; destruct (Po t) as
    [-> ->]; apply Pa). assert (Orb : NonlinearFlow.runs a' 0 (y0 O) (v0 O)).
  { intros t; destruct (orbit_moves O HO t) as [A B]; split; [exact A|]; rewrite agree; [exact B | apply on_orbit |
      rewrite Rabs_R0; lra]. }
  assert (Flow : forall mu s p q, exists y v, NonlinearFlow.runs a' mu y v /\ y s = p /\ v s = q).
  { intros mu s p q; apply (picard (fun t y v => a' t y v mu) L); [lra | | |intros y v; apply Bd].
    - intros t y v y' v'; pose proof (Lip' t y v mu t y' v' mu) as Q; rewrite !Rminus_eq_0, Rabs_R0 in Q; lra.
    - intros t y v x Hx; exists (x / (2 * L)); split; [apply Rdiv_lt_0_compat; lra|]; intros s' [_ Hs]; cbn in *; unfold
        R_dist in *. pose proof (Lip' s' y v mu t y v mu) as Q; rewrite !Rminus_eq_0, Rabs_R0 in Q; eapply Rle_lt_trans;
        [exact Q|]. apply Rle_lt_trans with (L * (x / (2 * L))); [apply Rmult_le_compat_l; lra | replace (L * (x / (2 *
        L))) with (x / 2) by (field; lra); lra]. }
  set (gg := a' (tG O) 0 0 0); pose proof v0_touch as V0. assert (Hg : 0 < gg /\ gg = a' (tG O) 0 0 0).
  { split; [|reflexivity]; unfold gg; rewrite agree; [apply (aG O HO) | | rewrite Rabs_R0; lra]; split; rewrite ?Z0,
      ?V0, Rminus_0_r, Rabs_R0; lra. }
  pose (Fo := NonlinearFlow.Build_force a' (T O) L (y0 O) (v0 O) HT HL Lip' Orb Flow).
  pose (To := NonlinearTouch.Build_touch Fo (tG O) gg HtG (conj Z0 V0) Hg).
  destruct (@NonlinearTouch.window_exists Fo To (gg / 4) ltac:(lra)) as (r0 & d1 & Win).
  pose proof (@NonlinearFlow.M_large Fo) as LM; set (M := @NonlinearFlow.M Fo) in *. assert (Hr0 : 0 < r0) by apply Win;
    assert (Hd1 : 0 < d1) by apply Win.
  destruct (two_least d1 (gg * r0 / (8 * M)) Hd1 ltac:(apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra)) as (d0
    & Hd0 & A1 & A2).
  assert (Hd0' : 8 * (M * d0) <= gg * r0) by (apply Rle_trans with (8 * (M * (gg * r0 / (8 * M)))); [apply
    Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra | right; field; lra]).
  pose (Wo := NonlinearTouch.Build_near Fo To r0 d0 (@NonlinearTouch.window_down Fo To (gg / 4) r0 d1 r0 d0 Win
    ltac:(lra) ltac:(lra)) Hd0').
  destruct (linear_solutions 0 0 1 0) as (p1 & q1 & F1), (linear_solutions 0 0 0 1) as (p2 & q2 & F2), (linear_solutions
    1 0 0 0) as (p3 & q3 & F3), (linear_solutions 0 (tG O) 0 1) as (zb & wb & Fb).
  destruct (has_matrix O a1 a2 gamma rate HG) as (A11 & A21 & A22 & Ea1 & Ea2 & HA); rewrite (Rmult_comm A21) in Ea2;
    destruct (has_rate O a1 a2 gamma rate HG) as (z & w & Hz & Pz & Ez).
  assert (Str : forall eps, 0 < eps -> exists d, 0 < d /\ forall x y v mu y' v' mu', 0 <= x <= T O -> Rabs (y - y0 O x)
    <= d -> Rabs (v - v0 O x) <= d -> Rabs mu <= d -> Rabs (y' - y0 O x) <= d -> Rabs (v' - v0 O x) <= d -> Rabs mu' <=
    d -> Rabs (a' x y v mu - a' x y' v' mu' - (k O x * (y - y') + c O x * (v - v') + l O x * (mu - mu'))) <= eps * (Rabs
    (y - y') + Rabs (v - v') + Rabs (mu - mu'))).
  { intros eps He; destruct (derivatives O HO eps He) as (dd & Hdd & H); destruct (two_least dd r Hdd Hr) as (d & Hd &
      Q1 & Q2); exists d; split; [exact Hd|].
    intros x y v mu y' v' mu' Xt X1 X2 X3 X4 X5 X6; rewrite !agree by (first [split; lra | lra]); apply H; first [exact
      Xt | split; lra | lra]. }
  pose (Io := NonlinearKick.Build_impact Fo To (rebound O) (tau O) (k O) (c O) (l O) p1 q1 p2 q2 p3 q3 zb wb (impact O
    HO) ltac:(intros x _; specialize (H1 x); specialize (H2 x); specialize (H3 x); unfold NonlinearFlow.L, Fo, L; lra)
    Str (conj F1 (conj F2 F3)) Fb).
  pose (Po' := NonlinearMotions.Build_unbroken Fo To Io (NonlinearFlow.Build_periodic Fo Per Po) (open_elsewhere O HO)
    ltac:(intros t; destruct (C t) as (_ & _ & _ & K); exact K) Pr).
  pose proof (@NonlinearMotions.unbroken_core Fo To Wo Io Po' A11 A21 A22 gamma z w HA (gamma_not_0 _ _ _ _ _ HG) Hz
    ltac:(destruct (Pz 0) as [Q _]; rewrite Rplus_0_l in Q; exact Q) ltac:(destruct (Pz 0) as [_ Q]; rewrite Rplus_0_l
        in Q; exact Q)
    ltac:(change (z (tG O) <> 0); rewrite <- Ez; apply (rate_not_0 _ _ _ _ _ HG)) n_max) as Core; cbv zeta in Core;
    change (@NonlinearTouch.tG Fo To) with (tG O) in Core; rewrite <- Ea1, <- Ea2, <- Ez in Core.
  (* near the orbit motions of the two equations are the same *)
  assert (SameLeg : forall mu d N t y v i j, d <= r -> Rabs mu <= r -> leg O mu d N t y v i j <->
    @NonlinearMotions.leg_is Fo To Io mu d N t y v i j).
  { intros mu d N t y v i j Hdr Hm; split.
    - intros [K1 K2 K3 K4 K5 K6 K7 K8 K9]; repeat (split; [assumption|]); split; [|repeat (split; [assumption|]);
        assumption]. intros x Hx; destruct (K3 x Hx) as [M1 M2], (K4 x Hx) as [Q1 Q2]; split; [|split; assumption];
        split; [exact M1|]. cbn; rewrite agree; [exact M2 | split; lra | exact Hm].
    - intros (K1 & K2 & K3 & K5 & K6 & K7 & K8 & K9); constructor; try assumption; intros x Hx; destruct (K3 x Hx) as
        ([M1 M2] & Q1 & Q2).
      + split; [exact M1|]; cbn in M2; rewrite agree in M2; [exact M2 | split; apply (Rle_trans _ d); assumption | exact
          Hm].
      + split; assumption. }
  assert (Same : forall mu d N t y v, d <= r -> Rabs mu <= r -> nonlinear_motion O mu d N t y v <->
    @NonlinearWords.motion (@NonlinearMotions.leg_is Fo To Io) mu d N t y v) by (intros mu d N t y v Hdr Hm; split;
        intros H i j Hj; apply
    SameLeg; trivial; apply H, Hj).
  destruct Core as (d & Hd & Core); destruct (two_least d r Hd Hr) as (d' & Hd' & Q1 & Q2); exists d'; split; [exact
    Hd'|]; intros eps Heps. destruct (Core eps ltac:(lra)) as (mu0 & Hmu0 & W); pose proof (rate_not_0 _ _ _ _ _ HG) as
    Hrate; assert (Pra : 0 < Rabs rate) by (apply Rabs_pos_lt, Hrate).
  destruct (two_least mu0 (Rabs rate * r) Hmu0 ltac:(apply Rmult_lt_0_compat; lra)) as (mu1 & Hmu1 & Q3 & Q4); exists
    mu1; split; [exact Hmu1|]. intros n N e g mu Hn HN Hs Hmu; assert (Sm : 0 < Rabs mu < r) by (apply (small_mu rate
    e); [exact Hrate | lra]).
  destruct (W n N e g mu Hn HN Hs ltac:(lra)) as [Ex No]; split.
  - intros Hall; destruct (Ex Hall) as (t & y & v & HM & Un & Only); split.
    + exists t, y, v; split; [apply Same; [lra | lra | exact HM]|]. intros t' y' v' HM'; apply Only, Same; [lra | lra |
        exact HM'].
    + intros t' y' v' HM'; apply Same in HM'; [|lra|lra]; assert (At := Only t' y' v' HM'); revert Un; apply
      unstable_same.
      * intros s p q i j Hl; apply SameLeg; [lra | lra | exact Hl].
      * intros i; destruct (At i) as [E F], (HM i _ eq_refl) as (Lt & _); split; [exact E|]; rewrite E; apply F; lra.
  - intros Hb t y v HM; apply Same in HM; [|lra|lra]; apply (No Hb t y v). intros i j Hj; destruct (HM i j Hj) as (X1 &
      X2 & X3 & X4); split; [exact X1 | split; [eapply Rle_trans; [exact X2 | lra] | split; [|exact X4]]]; intros x Hx;
      destruct (X3 x Hx) as (Y1 & Y2 & Y3); split; [exact Y1 | split; (eapply Rle_trans; [eassumption | lra])].
Qed.
End Main.

Theorem nonlinear O a1 a2 gamma rate : grazing_orbit O -> generic O a1 a2 gamma rate -> decided O a1 a2 gamma rate.
Proof. intros HO HG; destruct (Lipschitz O HO) as (L & r & Hr & HL); apply (main O a1 a2 gamma rate HO HG L r Hr HL).
  Qed.
