(** * The impact: kick * y is strictly differentiable *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import StatementOrbits Contraction Derivatives NonlinearStrict NonlinearFlow NonlinearTouch.
From Grazing Require Import NonlinearSpeed.
Open Scope R_scope.

(** The law of impact; kk, cc, ll are the derivatives of a along the orbit, and p1, q1 to p3, q3 and zb, wb solutions
    of the linearized equation. *)
Definition solves (kk cc ll : R -> R) m z w := forall t, derivable_pt_lim z t (w t) /\
  derivable_pt_lim w t (kk t * z t + cc t * w t + ll t * m).
Class impact {F : force} (P : touch F) := { rebound : R -> R -> R -> R; tau : R;
  kk : R -> R; cc : R -> R; ll : R -> R; p1 : R -> R; q1 : R -> R; p2 : R -> R; q2 : R -> R; p3 : R -> R; q3 : R -> R;
  zb : R -> R; wb : R -> R;
  Hreb : 0 <= tau /\ (forall mu t, rebound mu t 0 = 0) /\ (forall mu t v, v < 0 -> 0 <= rebound mu t v) /\
    forall eps, 0 < eps -> exists d, 0 < d /\ forall mu t v mu' t' v', Rabs mu <= d -> Rabs (t - tG) <= d ->
    Rabs v <= d -> Rabs mu' <= d -> Rabs (t' - tG) <= d -> Rabs v' <= d ->
    Rabs (rebound mu t v - rebound mu' t' v' + tau * (v - v')) <=
      eps * (Rabs (mu - mu') + Rabs (t - t') + Rabs (v - v'));
  Hbound : forall x, 0 <= x <= T -> Rabs (kk x) <= L /\ Rabs (cc x) <= L /\ Rabs (ll x) <= L;
  Hstrict : forall eps, 0 < eps -> exists d, 0 < d /\ forall x y v mu y' v' mu', 0 <= x <= T ->
    Rabs (y - y0 x) <= d -> Rabs (v - v0 x) <= d -> Rabs mu <= d -> Rabs (y' - y0 x) <= d -> Rabs (v' - v0 x) <= d ->
      Rabs mu' <= d ->
    Rabs (a x y v mu - a x y' v' mu' - (kk x * (y - y') + cc x * (v - v') + ll x * (mu - mu'))) <=
    eps * (Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu'));
  Hfund : (solves kk cc ll 0 p1 q1 /\ p1 0 = 1 /\ q1 0 = 0) /\ (solves kk cc ll 0 p2 q2 /\ p2 0 = 0 /\ q2 0 = 1) /\
    (solves kk cc ll 1 p3 q3 /\ p3 0 = 0 /\ q3 0 = 0);
  Hzb : solves kk cc ll 0 zb wb /\ zb tG = 0 /\ wb tG = 1 }.
Section Kick.
Context {the_force : force} {the_touch : touch the_force} {the_window : near the_touch} {the_impact : impact the_touch}.
Let HT := HT. Let HL := HL. Let HtG := HtG. Let Hg := Hg. Let Hd0 := Hd0.
Notation lin := (solves kk cc ll).
Lemma lin_in m z w : lin m z w -> S.linearized T kk cc ll m z w.
Proof. intros H x _; apply H. Qed.

Definition impulse x y mu := rebound mu (tc x y mu) (V x mu (tc x y mu)) - V x mu (tc x y mu).
Definition after x y mu : vec := origin mu (tc x y mu) (Y x mu (tc x y mu))
  (rebound mu (tc x y mu) (V x mu (tc x y mu))).
Definition kick (x : vec) y mu : vec := fun i => (after x y mu i - x i) / y.

Lemma zero_box : box zero 0 /\ ybox 0 /\ tc zero 0 0 = tG /\ V zero 0 tG = 0.
Proof.
  pose proof Hwin as (Hr & _ & _ & Hd & _).
  assert (B0 : box zero 0) by (split; [intros i _; unfold zero; rewrite Rabs_R0; lra | rewrite Rabs_R0; lra]).
  assert (V0 : V zero 0 tG = 0) by (rewrite (proj2 (at_rest tG)); apply Htouch).
  assert (E : low zero 0 = tG) by (destruct (low_spec zero 0 B0) as (_ & _ & U); symmetry; apply U;
    [rewrite Rminus_eq_0, Rabs_R0; lra | exact V0]).
  assert (Y0 : ybox 0) by (split; [lra|]; rewrite Rmult_0_r; assert (0 < g * (r0 * r0)) by (apply Rmult_lt_0_compat;
    [lra | nra]); lra). repeat split; try apply B0; try apply Y0; trivial; unfold tc; rewrite E.
  pose proof (off_small zero 0 0 B0 Y0) as A; destruct (off_spec zero 0 0 B0 Y0) as ([A0 _] & _).
  assert (off zero 0 0 = 0); [|lra]; apply Rle_antisym; [|exact A0]; apply Rmult_le_reg_l with g; lra.
Qed.
Lemma tc_in x y mu : box x mu -> ybox y -> 0 <= tc x y mu <= T /\ Rabs (tc x y mu - tG) <= r0.
Proof.
  intros B Hy; destruct (off_spec x y mu B Hy) as (Hs & _), (low_spec x mu B) as (P & _); apply le_abs in P;
    pose proof Hwin as (Hr & R1 & R2 & _). unfold tc; split; [lra | apply Rabs_le; lra].
Qed.
Lemma after_flow x y mu : Y (after x y mu) mu (tc x y mu) = Y x mu (tc x y mu) /\
  V (after x y mu) mu (tc x y mu) = rebound mu (tc x y mu) (V x mu (tc x y mu)).
Proof. apply origin_flow. Qed.
Lemma kick_y x y mu i : box x mu -> ybox y -> (i < 2)%nat -> kick x y mu i * y = after x y mu i - x i.
Proof.
  intros B Hy Hi; unfold kick; destruct (Req_dec y 0) as [->|N]; [|field; exact N]. rewrite Rmult_0_r; symmetry;
    apply Rminus_diag_eq; destruct (off_spec x 0 mu B Hy) as ([A0 _] & _); pose proof (off_small x 0 mu B Hy) as A.
  assert (E : tc x 0 mu = low x mu) by (unfold tc; assert (off x 0 mu = 0) by (apply Rle_antisym; [|exact A0]; apply
    Rmult_le_reg_l with g; lra); lra). unfold after; rewrite E, (proj1 (proj2 (low_spec x mu B))), (proj1 (proj2 Hreb)).
    rewrite <- (proj1 (proj2 (low_spec x mu B))); apply origin_same, Hi.
Qed.

Lemma impulse_strict : forall eps, 0 < eps -> exists d, 0 < d <= d0 /\ forall x y mu x' y' mu' t, within 2 d x ->
  within 2 d x' -> 0 <= y <= d -> 0 <= y' <= d -> Rabs mu <= d -> Rabs mu' <= d -> within 2 t (minus x x') ->
  Rabs (y - y') <= t -> Rabs (mu - mu') <= t -> ybox y /\ ybox y' /\ box x mu /\ box x' mu' /\
  Rabs (impulse x y mu - impulse x' y' mu' - (1 + tau) * cg * (y - y')) <= eps * t.
Proof.
  intros eps He; destruct tc_lip as (C & HC & Lip); pose proof cg_pos as Hc; destruct Hreb as (Ht0 & _ & _ & Reb).
  set (W := 1 + C + (1 + cg)); assert (HW : 0 < W) by (unfold W; lra).
  destruct (Reb (eps / (2 * W))) as (db & Hdb & R1); [apply Rdiv_lt_0_compat; lra|].
  destruct (two_least 1 (eps / (2 * (1 + tau))) ltac:(here; lra) ltac:(here; apply Rdiv_lt_0_compat; lra))
    as (e1 & E0 & E1 & E2). destruct (tc_speed e1 E0) as (d1 & Hd1 & Sp).
  destruct (two_least d1 (db / W) ltac:(here; lra) ltac:(here; apply Rdiv_lt_0_compat; lra)) as (d & Hd & L1 & L2).
  assert (Wd : W * d <= db) by (apply Rle_trans with (W * (db / W)); [apply Rmult_le_compat_l; lra | right; field;
    lra]). exists d; split; [lra|]; intros x y mu x' y' mu' t Hx Hx' Hy Hy' Hm Hm' Hxt Hyt Hmt;
    pose proof (Rabs_pos (mu - mu')) as Pm.
  assert (Wi : forall x, within 2 d x -> within 2 d1 x) by (intros z Hz i Hi; specialize (Hz i Hi); lra).
  destruct (Sp x y mu x' y' mu' t (Wi x Hx) (Wi x' Hx') ltac:(here; lra) ltac:(here; lra) ltac:(here; lra) ltac:(here;
    lra) Hxt Hyt Hmt) as (Yy & Yy' & B & B' & Q). split;
    [exact Yy | split; [exact Yy' | split; [exact B | split; [exact B'|]]]]. destruct zero_box as (B0 & Yz & Tz & Vz).
  assert (Near : forall x y mu, within 2 d x -> 0 <= y <= d -> Rabs mu <= d -> ybox y -> box x mu ->
    Rabs (tc x y mu - tG) <= db /\ Rabs (V x mu (tc x y mu)) <= db).
  { intros z s n Hz Hs Hn Ys Bz.
    assert (Z1 : within 2 d (minus z zero)) by (intros i Hi; unfold minus, zero; rewrite Rminus_0_r; apply Hz, Hi).
    assert (Z2 : Rabs (s - 0) <= d) by (rewrite Rminus_0_r, Rabs_pos_eq; lra);
      assert (Z3 : Rabs (n - 0) <= d) by (rewrite Rminus_0_r; exact Hn).
    pose proof (Lip z s n zero 0 0 d Bz B0 Ys Yz Z1 Z2 Z3) as A; rewrite Tz in A.
    destruct (Sp z s n zero 0 0 d (Wi z Hz)) as (_ & _ & _ & _ & A'); trivial; try lra; try (rewrite Rabs_R0; lra).
    { intros i Hi; unfold zero; rewrite Rabs_R0; lra. }
    rewrite Tz, Vz, Rmult_0_r, Rplus_0_r, Rminus_0_r in A'; assert (C * d <= W * d) by (apply Rmult_le_compat_r; unfold
      W; lra); split; [lra|]. apply le_abs in A'; assert (e1 * d <= 1 * d) by (apply Rmult_le_compat_r; lra); assert (0
      <= cg * s <= cg * d) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_l]; lra). apply Rabs_le; assert (0 <=
      C * d) by (apply Rmult_le_pos; lra); unfold W in Wd; lra. }
  destruct (Near x y mu Hx Hy Hm Yy B) as [N1 N2], (Near x' y' mu' Hx' Hy' Hm' Yy' B') as [N3 N4].
  assert (db0 : d <= W * d) by (rewrite <- (Rmult_1_l d) at 1; apply Rmult_le_compat_r; unfold W; lra).
  pose proof (R1 mu (tc x y mu) (V x mu (tc x y mu)) mu' (tc x' y' mu') (V x' mu' (tc x' y' mu')) ltac:(here;
    lra) N1 N2 ltac:(here; lra) N3 N4) as R2. pose proof (Lip x y mu x' y' mu' t B B' Yy Yy' Hxt Hyt Hmt) as L3;
    unfold impulse. set (v := V x mu (tc x y mu)) in *; set (v' := V x' mu' (tc x' y' mu')) in *;
    set (b := rebound mu (tc x y mu) v) in *; set (b' := rebound mu' (tc x' y' mu') v') in *.
  assert (Vv : Rabs (v - v') <= (1 + cg) * t).
  { replace (v - v') with ((v + cg * y - (v' + cg * y')) - cg * (y - y')) by ring; eapply Rle_trans; [apply apart|];
      rewrite Rabs_mult, (Rabs_pos_eq cg) by lra. assert (e1 * t <= 1 * t) by (apply Rmult_le_compat_r; lra);
      assert (cg * Rabs (y - y') <= cg * t) by (apply Rmult_le_compat_l; lra); lra. }
  replace (b - v - (b' - v') - (1 + tau) * cg * (y - y')) with ((b - b' + tau * (v - v')) - (1 + tau) * (v + cg * y -
    (v' + cg * y'))) by ring. eapply Rle_trans; [apply apart|]; rewrite Rabs_mult, (Rabs_pos_eq (1 + tau)) by lra.
  assert (X1 : (1 + tau) * Rabs (v + cg * y - (v' + cg * y')) <= eps / 2 * t).
  { apply Rle_trans with ((1 + tau) * (eps / (2 * (1 + tau)) * t)); [|right; field; lra]; apply Rmult_le_compat_l;
      [lra|]. apply Rle_trans with (1 := Q), Rmult_le_compat_r; lra. }
  assert (X2 : eps / (2 * W) * (Rabs (mu - mu') + Rabs (tc x y mu - tc x' y' mu') + Rabs (v - v')) <= eps / 2 * t).
  { apply Rle_trans with (eps / (2 * W) * (W * t)); [|right; field; lra]; apply Rmult_le_compat_l;
      [left; apply Rdiv_lt_0_compat; lra|]; unfold W; lra. }
  lra.
Qed.

Definition B : vec := fun i => (1 + tau) * cg * match i with O => zb 0 | _ => wb 0 end.
Lemma kick_strict : forall eps, 0 < eps -> exists d, 0 < d <= d0 /\ forall x x' y y' mu mu' t i, (i < 2)%nat ->
  within 2 d x -> within 2 d x' -> 0 <= y <= d -> 0 <= y' <= d -> Rabs mu <= d -> Rabs mu' <= d ->
  within 2 t (minus x x') -> Rabs (y - y') <= t -> Rabs (mu - mu') <= t -> Rabs (kick x y mu i * y - kick x' y' mu' i *
  y' - (y - y') * B i) <= eps * t.
Proof.
  intros eps He; destruct tc_lip as (C & HC & Lip); pose proof cg_pos as Hc; assert (Ht0 := proj1 Hreb);
    pose proof M_large as LM. set (W := 1 + C + (1 + tau) * cg);
    assert (Htc : 0 <= tau * cg) by (apply Rmult_le_pos; lra); assert (HW : 1 <= W) by (unfold W; lra).
  pose proof Hwin as (Hr & R1 & R2 & Hd0' & _); pose proof (proj1 Hzb) as Zb;
    destruct Hfund as ((F1 & F2) & (F3 & F4) & (F5 & F6)).
  destruct (S.kick_strict a T L y0 v0 kk cc ll HL Hlip Hbound Hstrict (sol_in 0 y0 v0 Horb) tG p1 q1 p2 q2 p3 q3
    ltac:(here; lra) (conj (conj (lin_in _ _ _ F1) F2) (conj (conj (lin_in _ _ _ F3) F4) (conj (lin_in _ _ _ F5) F6)))
    zb wb (lin_in _ _ _ Zb) (proj1 (proj2 Hzb)) (proj2 (proj2 Hzb)) (eps / (2 * W))) as (d1 & Hd1 & K1);
    [apply Rdiv_lt_0_compat; lra|]. set (Bb := Rabs (zb 0) + Rabs (wb 0) + 1);
    assert (HB : 1 <= Bb) by (unfold Bb; pose proof (Rabs_pos (zb 0)); pose proof (Rabs_pos (wb 0)); lra).
  destruct (two_least 1 (eps / (2 * Bb)) ltac:(here; lra) ltac:(here; apply Rdiv_lt_0_compat; lra))
    as (e1 & E0 & E1 & E2). destruct (impulse_strict e1 E0) as (d2 & Hd2 & Imp).
  set (Z := 1 + C + M * (1 + (1 + tau) * cg));
    assert (HZ0 : 0 <= M * (1 + (1 + tau) * cg)) by (apply Rmult_le_pos; lra); assert (HZ : 1 <= Z) by (unfold Z; lra).
  destruct (two_least d2 (d1 / Z) ltac:(here; lra) ltac:(here; apply Rdiv_lt_0_compat; lra)) as (d & Hd & L1 & L2).
  assert (Zd : Z * d <= d1) by (apply Rle_trans with (Z * (d1 / Z)); [apply Rmult_le_compat_l; lra | right; field;
    lra]).
  assert (dd1 : d <= d1) by (apply Rle_trans with (2 := Zd); rewrite <- (Rmult_1_l d) at 1; apply Rmult_le_compat_r;
    lra). exists d; split; [lra|]; intros x x' y y' mu mu' t i Hi Hx Hx' Hy Hy' Hm Hm' Hxt Hyt Hmt;
    pose proof (Rabs_pos (mu - mu')) as Pm.
  assert (Wi : forall x, within 2 d x -> within 2 d2 x) by (intros z Hz j Hj; specialize (Hz j Hj); lra).
  destruct (Imp x y mu x' y' mu' t (Wi x Hx) (Wi x' Hx') ltac:(here; lra) ltac:(here; lra) ltac:(here; lra) ltac:(here;
    lra) Hxt Hyt Hmt) as (Yy & Yy' & Bx & Bx' & Q). destruct zero_box as (B0 & Yz & Tz & Vz).
  (* the state after the impact is near, too *)
  assert (Near : forall x y mu, within 2 d x -> 0 <= y <= d -> Rabs mu <= d -> ybox y -> box x mu ->
    Rabs (tc x y mu - tG) <= d1 /\ within 2 d1 (after x y mu)).
  { intros z s n Hz Hs Hn Ys Bz.
    assert (Z1 : within 2 d (minus z zero)) by (intros j Hj; unfold minus, zero; rewrite Rminus_0_r; apply Hz, Hj).
    assert (Z2 : Rabs (s - 0) <= d) by (rewrite Rminus_0_r, Rabs_pos_eq; lra);
      assert (Z3 : Rabs (n - 0) <= d) by (rewrite Rminus_0_r; exact Hn).
    pose proof (Lip z s n zero 0 0 d Bz B0 Ys Yz Z1 Z2 Z3) as A; rewrite Tz in A; split.
    { apply Rle_trans with (1 := A), Rle_trans with (2 := Zd), Rmult_le_compat_r; unfold Z; lra. }
    destruct (Imp z s n zero 0 0 d (Wi z Hz)) as (_ & _ & _ & _ & A'); trivial; try lra; try (rewrite Rabs_R0; lra).
    { intros j Hj; unfold zero; rewrite Rabs_R0; lra. }
    assert (I0 : impulse zero 0 0 = 0) by (unfold impulse; rewrite Tz, Vz, (proj1 (proj2 Hreb)); ring);
      rewrite I0, !Rminus_0_r in A'. assert (J : Rabs (impulse z s n) <= (1 + (1 + tau) * cg) * d).
    { replace (impulse z s n) with ((impulse z s n - (1 + tau) * cg * s) + (1 + tau) * cg * s) by ring; eapply
        Rle_trans; [apply Rabs_triang|]. assert (e1 * d <= 1 * d) by (apply Rmult_le_compat_r; lra); assert (0 <= (1 +
        tau) * cg * s <= (1 + tau) * cg * d) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_l]; lra).
      rewrite (Rabs_pos_eq ((1 + tau) * cg * s)) by lra; lra. }
    destruct (after_flow z s n) as [G1 G2]; destruct (tc_in z s n Bz Ys) as [Ti _].
    assert (P0 : 0 <= (1 + (1 + tau) * cg) * d) by (apply Rmult_le_pos; lra).
    pose proof (nearby_back (after z s n) z n n ((1 + (1 + tau) * cg) * d) (tc z s n)) as NB.
    rewrite G1, G2, !Rminus_eq_0, Rabs_R0 in NB; fold (impulse z s n) in NB; specialize (NB P0 J P0 Ti). intros j Hj;
      specialize (NB j Hj); specialize (Hz j Hj); unfold minus in NB.
    replace (after z s n j) with ((after z s n j - z j) + z j) by ring; eapply Rle_trans; [apply Rabs_triang|].
    assert (0 <= C * d) by (apply Rmult_le_pos; lra); unfold Z in Zd; lra. }
  destruct (Near x y mu Hx Hy Hm Yy Bx) as [N1 N2], (Near x' y' mu' Hx' Hy' Hm' Yy' Bx') as [N3 N4].
  destruct (flow x mu) as (S1 & I1 & I2), (flow x' mu') as (S1' & I1' & I2'), (flow (after x y mu) mu)
    as (S2 & I3 & I4), (flow (after x' y' mu') mu') as (S2' & I3' & I4').
  destruct (after_flow x y mu) as [G1 G2], (after_flow x' y' mu') as [G1' G2'];
    destruct (tc_in x y mu Bx Yy) as [Ti _], (tc_in x' y' mu' Bx' Yy') as [Ti' _].
  pose proof (K1 mu mu' _ _ _ _ _ _ _ _ (tc x y mu) (tc x' y' mu') (W * t) (sol_in _ _ _ S1) (sol_in _ _ _ S2)
    (sol_in _ _ _ S1') (sol_in _ _ _ S2')) as K2. cbv zeta in K2;
    rewrite I1, I2, I3, I4, I1', I2', I3', I4', G1, G2, G1', G2' in K2; fold (impulse x y mu) (impulse x' y' mu') in K2.
  assert (Ct : 0 <= C * t) by (apply Rmult_le_pos; lra);
    assert (Kt : 0 <= (1 + tau) * cg * t) by (apply Rmult_le_pos; lra). assert (tW : t <= W * t) by (unfold W; lra).
  assert (D1 : forall u v, u + v - u = v) by (intros; ring); assert (D2 : forall u v w, u + v - (u + w) = v - w) by
    (intros; ring). rewrite !D1, !D2 in K2; pose proof (Lip x y mu x' y' mu' t Bx Bx' Yy Yy' Hxt Hyt Hmt) as L3. pose
    proof (Hxt 0%nat ltac:(lia)) as X0; pose proof (Hxt 1%nat ltac:(lia)) as X1; unfold minus in X0, X1.
  assert (Ji : Rabs (impulse x y mu - impulse x' y' mu') <= W * t).
  { replace (impulse x y mu - impulse x' y' mu')
      with ((impulse x y mu - impulse x' y' mu' - (1 + tau) * cg * (y - y')) + (1 + tau) * cg * (y - y')) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; rewrite (Rabs_mult ((1 + tau) * cg)), (Rabs_pos_eq ((1 + tau) * cg)) by lra.
    assert (e1 * t <= 1 * t) by (apply Rmult_le_compat_r; lra);
      assert ((1 + tau) * cg * Rabs (y - y') <= (1 + tau) * cg * t) by (apply Rmult_le_compat_l; lra); unfold W; lra. }
  assert (In : forall z, within 2 d z -> Rabs (z 0%nat) <= d1 /\ Rabs (z 1%nat) <= d1)
    by (intros z Hz; pose proof (Hz 0%nat ltac:(lia)); pose proof (Hz 1%nat ltac:(lia)); lra).
  specialize (K2 ltac:(here; lra) ltac:(here; lra) (proj1 (In x Hx)) (proj2 (In x Hx)) (N2 0%nat ltac:(lia))
    (N2 1%nat ltac:(lia)) (proj1 (In x' Hx')) (proj2 (In x' Hx')) (N4 0%nat ltac:(lia)) (N4 1%nat ltac:(lia)) Ti Ti' N1
    N3 eq_refl eq_refl ltac:(here; lra) ltac:(here; lra) ltac:(here; lra) Ji ltac:(here; unfold W; lra)).
  replace (eps / (2 * W) * (W * t)) with (eps / 2 * t) in K2 by (field; lra). rewrite !kick_y by assumption;
    set (J := impulse x y mu - impulse x' y' mu') in *; set (k := (1 + tau) * cg * (y - y')) in *.
  assert (Fin : forall b, Rabs b <= Bb -> Rabs ((J - k) * b) <= eps / 2 * t).
  { intros b Hb; rewrite Rabs_mult; apply Rle_trans with (e1 * t * Bb);
      [apply Rmult_le_compat; try apply Rabs_pos; assumption|]. apply Rle_trans with (eps / (2 * Bb) * t * Bb);
      [apply Rmult_le_compat_r; [lra|]; apply Rmult_le_compat_r; lra | right; field; lra]. }
  pose proof (Rabs_pos (zb 0)); pose proof (Rabs_pos (wb 0)). destruct i as [|[|i]]; [| |lia]; unfold B.
  - pose proof (Fin (zb 0) ltac:(here; unfold Bb; lra)).
    match type of K2 with Rabs ?u + Rabs ?w <= _ => pose proof (Rabs_pos w); match goal with |- Rabs ?e <= _ => replace
      e with (u + (J - k) * zb 0) by (unfold k; ring) end end; eapply Rle_trans; [apply Rabs_triang | lra].
  - pose proof (Fin (wb 0) ltac:(here; unfold Bb; lra)).
    match type of K2 with Rabs ?u + Rabs ?w <= _ => pose proof (Rabs_pos u); match goal with |- Rabs ?e <= _ => replace
      e with (w + (J - k) * wb 0) by (unfold k; ring) end end; eapply Rle_trans; [apply Rabs_triang | lra].
Qed.
End Kick.
