(** * Flights of the map and where they end: what does not depend on how a state is carried around; Theorem 1
      of whatever motions are its orbits *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane StatementUnstable StatementWords Headline
  OrbitVectors OrbitRemainder PlaneOrbits Orbits OrbitsNear OrbitsUnstable Contraction Derivatives.
From Grazing Require Orbits.
From Grazing Require Import NonlinearGronwall NonlinearFlow NonlinearTouch NonlinearSpeed NonlinearKick NonlinearMap.
Open Scope R_scope.
Section Flights.
Context {the_force : force} {the_touch : touch the_force} {the_window : near the_touch} {the_impact : impact the_touch}
  {the_turn : turn the_force}.
Let HT := HT. Let HL := HL. Let HtG := HtG. Let Hg := Hg. Let Hd0 := Hd0.
Lemma K_large : 1 <= K.
Proof. pose proof M_large; pose proof HK; lra. Qed.

Section Words.
Variables (n_max : nat) (dd mu : R) (n : Z -> nat).
Definition far := K * K ^ n_max.
Hypothesis Hn : forall i, (1 <= n i <= n_max)%nat.
Hypothesis Hmu : Rabs mu <= dd.
Hypothesis S0 : 0 < dd.
Hypothesis S1 : far * dd <= d0.
Hypothesis S2 : 32 * (far * dd) < 3 * g * (r0 * r0).
Hypothesis S4 : 16 * (far * dd) <= 3 * g * r0.
Definition fl (k : nat) (x : vec) : vec := Nat.iter k (fun x => f x mu) x.

Lemma far_large k : (k <= n_max)%nat -> 1 <= K ^ k /\ K ^ k * dd <= far * dd /\ K * (K ^ k * dd) <= far * dd.
Proof.
  intros Hk; pose proof K_large as LM; pose proof (pow_R1_Rle K k LM) as P; pose proof (Rle_pow K k n_max LM Hk) as Q;
    split; [exact P|]. assert (A : K * (K ^ k * dd) <= far * dd).
  { unfold far; replace (K * K ^ n_max * dd) with (K * (K ^ n_max * dd)) by ring; apply Rmult_le_compat_l; [lra|]; apply
      Rmult_le_compat_r; lra. }
  split; [|exact A]; apply Rle_trans with (2 := A); rewrite <- (Rmult_1_l (K ^ k * dd)) at 1; apply Rmult_le_compat_r;
    [apply Rmult_le_pos; lra | lra].
Qed.
Lemma fl_lip k x x' e : within 2 e (minus x x') -> within 2 (K ^ k * e) (minus (fl k x) (fl k x')).
Proof.
  intros H; assert (He : 0 <= e) by (eapply Rle_trans; [apply Rabs_pos | apply (H 0%nat); lia]); induction k as [|k IH];
    [intros i Hi; specialize (H i Hi); cbn in *; lra|]. pose proof K_large as LM; assert (0 <= K ^ k * e) by (apply
    Rmult_le_pos; [apply pow_le; lra | exact He]).
  change (fl (S k) x) with (f (fl k x) mu); change (fl (S k) x') with (f (fl k x') mu); cbn [pow]; rewrite Rmult_assoc.
  apply f_lip; [exact IH | rewrite Rminus_eq_0, Rabs_R0; lra].
Qed.
Lemma fl_in k x : within 2 dd x -> (k <= n_max)%nat -> within 2 (K ^ k * dd) (fl k x).
Proof.
  intros Hx; induction k as [|k IH]; intros Hk; [intros i Hi; specialize (Hx i Hi); cbn; lra|].
  destruct (far_large k ltac:(lia)) as (P & _); assert (dd <= K ^ k * dd) by (rewrite <- (Rmult_1_l dd) at 1; apply
    Rmult_le_compat_r; lra). specialize (IH ltac:(lia)).
  pose proof (f_lip (fl k x) zero mu 0 (K ^ k * dd) ltac:(intros i Hi; unfold minus, zero; rewrite Rminus_0_r; apply
    IH, Hi) ltac:(here; rewrite Rminus_0_r; lra)) as A.
  change (fl (S k) x) with (f (fl k x) mu); cbn [pow]; rewrite Rmult_assoc; intros i Hi; specialize (A i Hi);
    unfold minus in A; rewrite (proj1 (f_strict i Hi)), Rminus_0_r in A; exact A.
Qed.
Lemma fl_near k x : within 2 dd x -> (k <= n_max)%nat -> box (fl k x) mu /\ Rabs (low (fl k x) mu - tG) <= r0 / 4 /\
  forall u, 0 <= u <= T -> Rabs (Y (fl k x) mu u - y0 u) <= far * dd /\ Rabs (V (fl k x) mu u - v0 u) <= far * dd.
Proof.
  intros Hx Hk; pose proof (fl_in k x Hx Hk) as I; destruct (far_large k Hk) as (P & Q & Q'); assert (D1 : dd <= K ^ k *
    dd) by (rewrite <- (Rmult_1_l dd) at 1; apply Rmult_le_compat_r; lra).
  assert (MK : M * (K ^ k * dd) <= K * (K ^ k * dd)) by (pose proof HK; apply Rmult_le_compat_r; [apply Rmult_le_pos|];
    lra).
  assert (Bz : box (fl k x) mu) by (split; [intros i Hi; specialize (I i Hi)|]; lra); split; [exact Bz|]; split.
  - destruct zero_box as (B0 & _).
    pose proof (low_lip (fl k x) mu zero 0 (K ^ k * dd) Bz B0 ltac:(here; intros i Hi; unfold minus, zero; rewrite
      Rminus_0_r; apply I, Hi) ltac:(here; rewrite Rminus_0_r; lra)) as A. rewrite low_rest in A; apply Rmult_le_reg_l
      with (3 * g); lra.
  - intros u Hu; destruct (near_y0 (fl k x) mu (K ^ k * dd) u I ltac:(here; lra) Hu); lra.
Qed.
Lemma above_touch u : Rabs (u - tG) <= r0 -> 3 / 8 * g * ((u - tG) * (u - tG)) <= y0 u.
Proof.
  intros Hu; destruct zero_box as (B0 & _); pose proof (Y_above zero 0 u B0 Hu) as A; cbv zeta in A; rewrite
    low_rest, !(proj1 (at_rest _)), (proj1 Htouch) in A; lra.
Qed.
Lemma low_y k x yy : within 2 dd x -> (k <= n_max)%nat -> 0 <= yy -> Y (fl k x) mu (low (fl k x) mu) = - (yy * yy) ->
  ybox yy.
Proof.
  intros Hx Hk Hy E; destruct (fl_near k x Hx Hk) as (Bz & Lo & Ne); pose proof Hwin as (Hr & R1 & R2 & _).
  pose proof (above_touch (low (fl k x) mu) ltac:(here; lra)) as U; pose proof (Rle_0_sqr (low (fl k x) mu - tG)) as P;
    unfold Rsqr in P; apply (Rmult_le_compat_l (3 / 8 * g)) in P; [|lra]. apply le_abs in Lo.
  destruct (Ne (low (fl k x) mu) ltac:(here; lra)) as [A _]; rewrite E in A; apply le_abs in A.
  split; [exact Hy | lra].
Qed.

(** Signs near the touch. *)
Lemma falling x u t : box x mu -> Rabs (u - tG) <= r0 -> Rabs (t - tG) <= r0 -> u < t -> V x mu t <= 0 ->
  V x mu u < 0 /\ Y x mu t < Y x mu u.
Proof.
  intros Bx Hu Ht O Vt; destruct (flow x mu) as (A & _). assert (Vn : forall q, u <= q < t -> V x mu q < 0).
  { intros q Hq; assert (Iq : Rabs (q - tG) <= r0) by (apply le_abs in Hu, Ht; apply Rabs_le; lra).
    pose proof (V_rises x mu q t Bx Iq Ht ltac:(here; lra)); assert (0 < 3 / 4 * g * (t - q)) by (apply
      Rmult_lt_0_compat; lra); lra. }
  destruct (MVT_cor2 (Y x mu) (V x mu) u t O) as (q & E & Hq); [intros q _; apply A|]; split; [apply Vn; lra|].
  specialize (Vn q ltac:(here; lra)); assert (0 < (- V x mu q) * (t - u)) by (apply Rmult_lt_0_compat; lra); lra.
Qed.
Lemma rising x u t : box x mu -> Rabs (u - tG) <= r0 -> Rabs (t - tG) <= r0 -> u < t -> 0 <= V x mu u ->
  Y x mu u < Y x mu t.
Proof.
  intros Bx Hu Ht O Vt; destruct (flow x mu) as (A & _); destruct (MVT_cor2 (Y x mu) (V x mu) u t O) as (q & E & Hq);
    [intros q _; apply A|]. assert (Iq : Rabs (q - tG) <= r0) by (apply le_abs in Hu, Ht; apply Rabs_le; lra).
  pose proof (V_rises x mu u q Bx Hu Iq ltac:(here; lra)); assert (0 < 3 / 4 * g * (q - u)) by (apply Rmult_lt_0_compat;
    lra).
  assert (0 < V x mu q * (t - u)) by (apply Rmult_lt_0_compat; lra); lra.
Qed.
Lemma before_low x u : box x mu -> Rabs (u - tG) <= r0 -> V x mu u < 0 -> u < low x mu.
Proof.
  intros Bx Hu Vu; destruct (low_spec x mu Bx) as (P & E & _); pose proof (proj1 Hwin); apply Rnot_le_lt; intros O.
  pose proof (V_rises x mu (low x mu) u Bx ltac:(here; lra) Hu O); assert (0 <= 3 / 4 * g * (u - low x mu)) by (apply
    Rmult_le_pos; lra); lra.
Qed.
Lemma one_crossing x u t : box x mu -> Rabs (u - tG) <= r0 -> Rabs (t - tG) <= r0 -> Y x mu u = 0 -> Y x mu t = 0 ->
  V x mu u < 0 -> V x mu t < 0 -> u = t.
Proof.
  intros Bx Hu Ht Eu Et Vu Vt; destruct (Rtotal_order u t) as [O|[O|O]]; [|exact O|].
  - destruct (falling x u t Bx Hu Ht O ltac:(here; lra)); lra.
  - destruct (falling x t u Bx Ht Hu O ltac:(here; lra)); lra.
Qed.

Variable D : R.
Hypothesis S5 : 8 * (far * dd) <= 3 * g * (D * D).
Hypothesis S6 : far * dd <= D /\ D <= r0 / 4.
Lemma D_pos : 0 < D.
Proof. destruct (far_large 0 ltac:(lia)) as (_ & P & _); cbn in P; lra. Qed.
Lemma close_touch u : Rabs (u - tG) <= r0 -> y0 u <= far * dd -> Rabs (u - tG) <= D.
Proof.
  intros Hu Hy; pose proof (above_touch u Hu) as A. pose proof D_pos; rewrite <- (Rabs_pos_eq D) by lra; apply
    Rsqr_le_abs_0; unfold Rsqr. apply Rmult_le_reg_l with (3 / 8 * g); lra.
Qed.

(** What x j does in its flight, and at the impact after it, of speed yy j. *)
Record flown (x : Z -> vec) (yy : Z -> R) (j : Z) : Prop := {
  Ox : within 2 dd (x j);
  Oy : 0 < yy j;
  Oh : Y (fl (n j) (x j)) mu (low (fl (n j) (x j)) mu) = - (yy j * yy j);
  Ok : forall k, (1 <= k < n j)%nat -> 0 < Y (fl k (x j)) mu (low (fl k (x j)) mu);
  On : forall i, (i < 2)%nat -> x (j + 1)%Z i = after (fl (n j) (x j)) (yy j) mu i }.

Section FromOrbit.
Variables (x : Z -> vec) (yy : Z -> R).
Notation flown := (flown x yy).
Definition hit (j : Z) : R := tc (fl (n j) (x j)) (yy j) mu.
(** Impact j is at this time, if the period is P and the time of the arc of the touch begins at sg. *)
Definition at_ (P sg : R) (N : Z -> Z) (j : Z) : R := sg + P * IZR (N j) + hit (j - 1).
Lemma hit_facts p i : flown p -> i = (p + 1)%Z -> let z := fl (n p) (x p) in let c := hit p in box z mu /\ Rabs (c -
  tG) <= r0 /\
  0 <= c <= T /\
  Y z mu c = 0 /\ V z mu c < 0 /\ Y (x i) mu c = 0 /\ V (x i) mu c = rebound mu c (V z mu c) /\ Rabs (c - tG) <= D.
Proof.
  intros [Ox Oy Oh Ok On] -> z c; destruct (fl_near (n p) (x p) Ox ltac:(here; apply Hn)) as (Bz & Lo & Ne); fold z in
    Bz, Lo, Ne.
  assert (Yb : ybox (yy p)) by (apply (low_y (n p) (x p)); [apply Ox | apply Hn | lra | apply Oh]).
  destruct (tc_in z (yy p) mu Bz Yb) as [Ti Tw]; change (tc z (yy p) mu) with c in Ti, Tw; destruct (off_spec z (yy p)
    mu Bz Yb) as (Os & Oe & Op & _). destruct (low_spec z mu Bz) as (Lw & Le & _); pose proof (proj1 Hwin) as Hr. assert
    (Ez : Y z mu c = 0).
  { assert (Q : Y z mu (low z mu) = - (yy p * yy p)) by apply Oh; rewrite Q in Oe; change (low z mu + -1 * off z (yy p)
      mu) with c in Oe; lra. }
  assert (cl : c < low z mu) by (specialize (Op ltac:(here; lra)); unfold c, hit, tc; fold z; lra).
  assert (Vz : V z mu c < 0) by (apply (falling z c (low z mu)); trivial; lra).
  destruct (after_flow z (yy p) mu) as [A1 A2]; change (tc z (yy p) mu) with c in A1, A2.
  destruct (Y_ext (x (p + 1)%Z) (after z (yy p) mu) mu c (On 0%nat ltac:(lia)) (On 1%nat ltac:(lia))) as [E1 E2].
  refine (conj Bz (conj Tw (conj Ti (conj Ez (conj Vz (conj _ (conj _ _))))))).
  - rewrite E1, A1; exact Ez.
  - rewrite E2, A2; reflexivity.
  - apply close_touch; [exact Tw|]; destruct (Ne c Ti) as [A _]; rewrite Ez in A; apply le_abs in A; lra.
Qed.
End FromOrbit.
Definition facts (x : Z -> vec) (yy : Z -> R) : Prop := forall j, flown x yy j.
(** A crossing near the touch is the one that tc names. *)
Lemma crossing_is x (k : nat) c : within 2 dd x -> (k <= n_max)%nat -> let z := fl k x in
  let yy := sqrt (- Y z mu (low z mu)) in Rabs (c - tG) <= r0 / 4 -> Y z mu c = 0 -> V z mu c < 0 ->
  0 < yy /\ Y z mu (low z mu) = - (yy * yy) /\ tc z yy mu = c.
Proof.
  intros Hx Hk z yy Hc E1 Vn; destruct (fl_near k x Hx Hk) as (Bz & Lo & Ne); fold z in Bz, Lo, Ne; pose proof (proj1
    Hwin) as Hr.
  assert (O : c < low z mu) by (apply before_low; trivial; lra); destruct (low_spec z mu Bz) as (_ & El & _).
  assert (Dn : Y z mu (low z mu) < 0) by (rewrite <- E1; apply (falling z); trivial; lra).
  assert (Py : 0 < yy) by (apply sqrt_lt_R0; lra); assert (Oh : Y z mu (low z mu) = - (yy * yy)) by (unfold yy; rewrite
    sqrt_sqrt by lra; ring). split; [exact Py | split; [exact Oh|]].
  assert (Yb : ybox yy) by (apply (low_y k x); trivial; lra).
  destruct (off_spec z yy mu Bz Yb) as (_ & _ & _ & U); apply le_abs in Lo, Hc.
  specialize (U (low z mu - c) ltac:(here; lra)); replace (low z mu + -1 * (low z mu - c)) with c in U by ring.
  rewrite E1, Oh in U; specialize (U ltac:(here; ring)); unfold tc; rewrite <- U; ring.
Qed.

(** Orbits of the map, as Theorem 1 has them. *)
Lemma facts_orbit x yy : facts x yy -> orbit_near map Z (fun j => j + 1)%Z n mu dd x.
Proof.
  intros F; apply (Orbits.zero_orbit map mu Z (fun j => j + 1)%Z n (fun j => proj1 (Hn j)) dd x yy (fun j => Ox _ _ _ (F
    j))).
  - apply Orbits.zero_meaning; intros j; destruct (F j) as [Ox Oy Oh Ok On]; split; [cbn; change (OrbitRemainder.fly map
      mu (n j) (x j)) with (fl (n j) (x j)); rewrite Oh; ring|]. intros i Hi; cbn in Hi; change (Map.kick map) with
      kick; change (OrbitRemainder.fly map mu (n j) (x j)) with (fl (n j) (x j)).
    assert (Bz := proj1 (fl_near (n j) (x j) Ox ltac:(here; apply Hn))); assert (Yb : ybox (yy j)) by (apply (low_y (n
      j) (x j)); [apply Ox | apply Hn | left; apply Oy | apply Oh]).
    rewrite (Rabs_pos_eq (yy j)) by (left; apply Oy); rewrite kick_y, On by assumption; ring.
  - intros j; destruct (F j) as [Ox Oy Oh Ok On]; split; [apply Oy|]; intros k Hk; cbn; change (OrbitRemainder.fly map
    mu k (x j)) with (fl k (x j)); specialize (Ok k Hk); lra.
Qed.
Lemma orbit_facts x : orbit_near map Z (fun j => j + 1)%Z n mu dd x -> exists yy, facts x yy.
Proof.
  intros H; destruct (Orbits.orbit_zero map mu Z (fun j => j + 1)%Z n (fun j => proj1 (Hn j)) dd x H) as [Hz Hs].
  exists (Orbits.speed map mu Z n x); set (yy := Orbits.speed map mu Z n x) in *; pose proof (proj1 (Orbits.zero_meaning
    map mu Z (fun j => j + 1)%Z n x yy) Hz) as Zm.
  assert (Ox : forall j, within 2 dd (x j)) by (intros j; apply (proj1 (H j))).
  assert (Oh : forall j, Y (fl (n j) (x j)) mu (low (fl (n j) (x j)) mu) = - (yy j * yy j)).
  { intros j; destruct (Zm j) as [E _]; cbn in E; change (OrbitRemainder.fly map mu (n j) (x j)) with (fl (n j) (x j))
      in E; lra. }
  assert (Oy : forall j, 0 < yy j) by (intros j; apply (Hs j)). intros j; constructor; [apply Ox | apply Oy | apply Oh |
    |].
  - intros k Hk; pose proof (proj2 (Hs j) k Hk) as P; cbn in P; change (OrbitRemainder.fly map mu k (x j)) with (fl k (x
      j)) in P; lra.
  - intros i Hi; destruct (Zm j) as [_ E]; specialize (E i Hi); change (Map.kick map) with kick in E; change
      (OrbitRemainder.fly map mu (n j) (x j)) with (fl (n j) (x j)) in E.
    assert (Bz := proj1 (fl_near (n j) (x j) (Ox j) ltac:(here; apply Hn))); assert (Yb : ybox (yy j)) by (apply (low_y
      (n j) (x j)); [apply Ox | apply Hn | left; apply Oy | apply Oh]).
    rewrite (Rabs_pos_eq (yy j)) in E by (left; apply Oy); rewrite kick_y in E by assumption; rewrite E; ring.
Qed.

(** Time of an impact and velocity after it depend continuously on the flight, and determine the point. *)
Notation hits := hit_facts.
Lemma in_box x : within 2 dd x -> box x mu.
Proof.
  intros H; destruct (far_large 0 ltac:(lia)) as (_ & P & _); cbn in P; split; [intros i Hi; specialize (H i Hi)|]; lra.
Qed.
Lemma after_near : exists Q, 0 < Q /\ forall x x' yy yy' p e, flown x yy p -> flown x' yy' p -> within 2 dd (x (p +
  1)%Z)
  -> within 2 e (minus (x' p) (x p)) -> Rabs (yy' p - yy p) <= e -> within 2 e (minus (x' (p + 1)%Z) (x (p + 1)%Z)) ->
  let c := hit x yy p in let c' := hit x' yy' p in Rabs (c' - c) <= Q * e /\
  Rabs (V (x' (p + 1)%Z) mu c' - V (x (p + 1)%Z) mu c) <= Q * e.
Proof.
  destruct tc_lip as (C & HC & Lip); pose proof M_large as LM0; pose proof K_large as LM; pose proof (pow_R1_Rle K n_max
      LM) as P1.
  assert (P2 : 1 <= C * K ^ n_max) by (rewrite <- (Rmult_1_l 1); apply Rmult_le_compat; lra).
  set (R := C * K ^ n_max) in *; assert (PR : 0 <= g * R) by (apply Rmult_le_pos; lra).
  exists (R + M + 5 / 4 * g * R); split; [lra|]; intros x x' yy yy' p e F F' Bx H Hy H1 c c'.
  destruct (hits x yy p (p + 1)%Z F eq_refl) as (B & Cw & Ci & _), (hits x' yy' p (p + 1)%Z F' eq_refl) as (B' & Cw' &
    Ci' & _); fold c in Cw, Ci; fold c' in Cw', Ci'.
  assert (He : 0 <= e) by (eapply Rle_trans; [apply Rabs_pos | exact Hy]).
  assert (Yb : forall x yy, flown x yy p -> ybox (yy p)) by (intros u yu [Ox Oy Oh _ _]; apply (low_y (n p) (u p));
      [exact Ox | apply Hn | left; exact Oy | exact Oh]).
  assert (Pk : 1 <= K ^ n p /\ K ^ n p <= K ^ n_max) by (split; [apply pow_R1_Rle, LM | apply Rle_pow; [exact LM | apply
    Hn]]). assert (E1 : 1 * e <= K ^ n p * e /\ K ^ n p * e <= K ^ n_max * e) by (split; apply Rmult_le_compat_r; lra).
  assert (Rce : Rabs (c' - c) <= R * e).
  { unfold R; rewrite Rmult_assoc; apply (Lip (fl (n p) (x' p)) (yy' p) mu (fl (n p) (x p)) (yy p) mu); try lra;
    [exact B' | exact B | apply (Yb x' yy' F') | apply (Yb x yy F) | |].
    - intros i Hi; apply Rle_trans with (1 := fl_lip (n p) _ _ e H i Hi); lra.
    - rewrite Rminus_eq_0, Rabs_R0; lra. }
  assert (0 <= (M + 5 / 4 * g * R) * e /\ 0 <= R * e /\ 0 <= M * e) as (Q1 & Q2 & Q3) by (repeat split; apply
    Rmult_le_pos; lra). split; [lra|].
  destruct (nearby _ _ mu mu e c' H1 ltac:(here; rewrite Rminus_eq_0, Rabs_R0; lra) Ci') as [_ A].
  destruct (Y_lip (x (p + 1)%Z) mu c' c (in_box _ Bx) Cw' Cw) as [_ A'].
  replace (V (x' (p + 1)%Z) mu c' - V (x (p + 1)%Z) mu c) with ((V (x' (p + 1)%Z) mu c' - V (x (p + 1)%Z) mu c') + (V (x
    (p + 1)%Z) mu c' - V (x (p + 1)%Z) mu c)) by ring. eapply Rle_trans; [apply Rabs_triang|].
  assert (5 / 4 * g * Rabs (c' - c) <= 5 / 4 * g * (R * e)) by (apply Rmult_le_compat_l; lra); lra.
Qed.
Lemma after_far : exists Q, 0 < Q /\ forall x x' yy yy' p e, flown x yy p -> flown x' yy' p -> within 2 dd (x (p +
  1)%Z) ->
  let c := hit x yy p in let c' := hit x' yy' p in Rabs (c' - c) <= e ->
  Rabs (V (x' (p + 1)%Z) mu c' - V (x (p + 1)%Z) mu c) <= e -> within 2 (Q * e) (minus (x' (p + 1)%Z) (x (p + 1)%Z)).
Proof.
  pose proof M_large as LM; pose proof (proj1 Hwin) as Hr; assert (Pr : 0 < g * r0) by (apply Rmult_lt_0_compat; lra).
  set (q := 1 + 5 / 2 * g * r0 + 5 / 4 * g); exists (M * q); split; [apply Rmult_lt_0_compat; unfold q; lra|].
  intros x x' yy yy' p e F F' Bx c c' Hc Hv; assert (He : 0 <= e) by (eapply Rle_trans; [apply Rabs_pos | exact Hc]).
  destruct (hits x yy p (p + 1)%Z F eq_refl) as (_ & Cw & _ & _ & _ & E & _), (hits x' yy' p (p + 1)%Z F' eq_refl) as
    (_ & Cw' & Ci' & _ & _ & E' & _); fold c in Cw, E; fold c' in Cw', Ci', E'.
  destruct (Y_lip (x (p + 1)%Z) mu c' c (in_box _ Bx) Cw' Cw) as [A A']; rewrite E, Rminus_0_r in A.
  assert (K1 : 5 / 2 * g * r0 * Rabs (c' - c) <= 5 / 2 * g * r0 * e) by (apply Rmult_le_compat_l; lra).
  assert (K2 : 5 / 4 * g * Rabs (c' - c) <= 5 / 4 * g * e) by (apply Rmult_le_compat_l; lra).
  assert (0 <= g * r0 * e /\ 0 <= g * e) as [K3 K4] by (split; apply Rmult_le_pos; lra).
  rewrite Rmult_assoc; apply (nearby_back _ _ mu mu (q * e) c'); [ | | |exact Ci'].
  - rewrite E', Rminus_0_l, Rabs_Ropp; unfold q; lra.
  - replace (V (x' (p + 1)%Z) mu c' - V (x (p + 1)%Z) mu c') with ((V (x' (p + 1)%Z) mu c' - V (x (p + 1)%Z) mu c) -
    (V (x (p + 1)%Z) mu c' - V (x (p + 1)%Z) mu c)) by ring. eapply Rle_trans; [apply apart|]; unfold q; lra.
  - rewrite Rminus_eq_0, Rabs_R0; apply Rmult_le_pos; unfold q; lra.
Qed.

End Words.
End Flights.
