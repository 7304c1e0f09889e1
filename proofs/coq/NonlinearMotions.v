(** * Motions of the equation with impacts are orbits of the map, and Theorem 1 is about them *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane StatementWords Headline OrbitRemainder.
From Grazing Require Import PlaneOrbits Contraction Derivatives.
From Grazing Require Orbits.
From Grazing Require Import NonlinearGronwall NonlinearFlow NonlinearTouch NonlinearSpeed NonlinearKick NonlinearMap.
Open Scope R_scope.
Section Motions.
Context {the_force : force} {the_touch : touch the_force} {the_window : near the_touch} {the_impact : impact the_touch}.
Let HT := HT. Let HL := HL. Let HtG := HtG. Let Hg := Hg. Let Hd0 := Hd0.
Notation at_time := (moves a). Notation sol := (runs a).
Notation lin := (solves kk cc ll).
Lemma y0_periods z t : y0 (t + T * IZR z) = y0 t /\ v0 (t + T * IZR z) = v0 t.
Proof. split; apply whole; intros s; apply Hyper. Qed.
Lemma shifted x mu z : sol mu (fun t => Y x mu (t - T * IZR z)) (fun t => V x mu (t - T * IZR z)).
Proof.
  intros t; destruct (flow x mu) as (A & _); destruct (A (t - T * IZR z)) as [D1 D2]. split; [eapply D_value; [apply
    (D_of (fun t => t - T * IZR z) (Y x mu)); [apply D_shift | exact D1] | ring]|].
  eapply D_value; [apply (D_of (fun t => t - T * IZR z) (V x mu)); [apply D_shift | exact D2]|].
  pose proof (whole (fun s => a s (Y x mu (t - T * IZR z)) (V x mu (t - T * IZR z)) mu) T (fun s => Hper _ _ _ _) z (t -
    T * IZR z)) as E; cbv beta in E. rewrite <- E; replace (t - T * IZR z + T * IZR z) with t by ring; ring.
Qed.

Definition leg_is mu d (N : Z -> Z) (t : Z -> R) (y v : Z -> R -> R) (i j : Z) : Prop := t i < t j /\
  Rabs (t i - (tG + T * IZR (N i))) <= d /\
  (forall x, t i <= x <= t j -> at_time mu (y i) (v i) x /\ Rabs (y i x - y0 x) <= d /\ Rabs (v i x - v0 x) <= d) /\
  y i (t i) = 0 /\ y i (t j) = 0 /\ (forall x, t i < x < t j -> 0 < y i x) /\ v i (t j) < 0 /\
    v j (t j) = rebound mu (t j) (v i (t j)).
Definition motion mu d N t y v : Prop := forall i j, j = (i + 1)%Z -> leg_is mu d N t y v i j.

Section Words.
Variables (n_max : nat) (dd mu : R) (n : Z -> nat) (N : Z -> Z).
Definition far := M * M ^ n_max.
Hypothesis Hn : forall i, (1 <= n i <= n_max)%nat.
Hypothesis HN : forall i, (N (i + 1) = N i + Z.of_nat (n i))%Z.
Hypothesis Hmu : Rabs mu <= dd.
Hypothesis S0 : 0 < dd.
Hypothesis S1 : far * dd <= d0.
Hypothesis S2 : 32 * (far * dd) < 3 * g * (r0 * r0).
Hypothesis S3 : forall t, 0 <= t <= T -> r0 <= Rabs (t - tG) -> far * dd < y0 t.
Hypothesis S4 : 16 * (far * dd) <= 3 * g * r0.
Definition fl (k : nat) (x : vec) : vec := Nat.iter k (fun x => f x mu) x.

Lemma far_large k : (k <= n_max)%nat -> 1 <= M ^ k /\ M ^ k * dd <= far * dd /\ M * (M ^ k * dd) <= far * dd.
Proof.
  intros Hk; pose proof M_large as LM; pose proof (pow_R1_Rle M k LM) as P; pose proof (Rle_pow M k n_max LM Hk) as Q;
    split; [exact P|]. assert (A : M * (M ^ k * dd) <= far * dd).
  { unfold far; replace (M * M ^ n_max * dd) with (M * (M ^ n_max * dd)) by ring; apply Rmult_le_compat_l; [lra|]; apply
      Rmult_le_compat_r; lra. }
  split; [|exact A]; apply Rle_trans with (2 := A); rewrite <- (Rmult_1_l (M ^ k * dd)) at 1; apply Rmult_le_compat_r;
    [apply Rmult_le_pos; lra | lra].
Qed.
Lemma fl_in k x : within 2 dd x -> (k <= n_max)%nat -> within 2 (M ^ k * dd) (fl k x).
Proof.
  intros Hx; induction k as [|k IH]; intros Hk; [intros i Hi; specialize (Hx i Hi); cbn; lra|].
  destruct (far_large k ltac:(lia)) as (P & _); assert (dd <= M ^ k * dd) by (rewrite <- (Rmult_1_l dd) at 1; apply
    Rmult_le_compat_r; lra).
  destruct (near_y0 (fl k x) mu (M ^ k * dd) T (IH ltac:(lia)) ltac:(here; lra) ltac:(here; lra)) as [A A']; destruct
    (Hyper 0) as [P1 P2]; rewrite Rplus_0_l in P1, P2; rewrite P1 in A; rewrite P2 in A'.
  change (fl (S k) x) with (f (fl k x) mu); cbn [pow]; intros i Hi; rewrite Rmult_assoc; destruct i as [|[|i]]; [exact A
    | exact A' | lia].
Qed.
Lemma fl_near k x : within 2 dd x -> (k <= n_max)%nat -> box (fl k x) mu /\ Rabs (low (fl k x) mu - tG) <= r0 / 4 /\
  forall u, 0 <= u <= T -> Rabs (Y (fl k x) mu u - y0 u) <= far * dd /\ Rabs (V (fl k x) mu u - v0 u) <= far * dd.
Proof.
  intros Hx Hk; pose proof (fl_in k x Hx Hk) as I; destruct (far_large k Hk) as (P & Q & Q'); assert (D1 : dd <= M ^ k *
    dd) by (rewrite <- (Rmult_1_l dd) at 1; apply Rmult_le_compat_r; lra).
  assert (Bz : box (fl k x) mu) by (split; [intros i Hi; specialize (I i Hi)|]; lra); split; [exact Bz|]; split.
  - destruct zero_box as (B0 & _).
    pose proof (low_lip (fl k x) mu zero 0 (M ^ k * dd) Bz B0 ltac:(here; intros i Hi; unfold minus, zero; rewrite
      Rminus_0_r; apply I, Hi) ltac:(here; rewrite Rminus_0_r; lra)) as A. rewrite low_rest in A; apply Rmult_le_reg_l
      with (3 * g); lra.
  - intros u Hu; destruct (near_y0 (fl k x) mu (M ^ k * dd) u I ltac:(here; lra) Hu); lra.
Qed.
Lemma fl_flow k x t : Y (fl k x) mu t = Y x mu (t + T * INR k) /\ V (fl k x) mu t = V x mu (t + T * INR k).
Proof. apply iterates. Qed.
Lemma low_y k x yy : within 2 dd x -> (k <= n_max)%nat -> 0 <= yy -> Y (fl k x) mu (low (fl k x) mu) = - (yy * yy) ->
  ybox yy.
Proof.
  intros Hx Hk Hy E; destruct (fl_near k x Hx Hk) as (Bz & Lo & Ne); pose proof Hwin as (Hr & R1 & R2 & _); apply le_abs
    in Lo. destruct (Ne (low (fl k x) mu) ltac:(here; lra)) as [A _]; rewrite E in A; apply le_abs in A.
  assert (0 <= y0 (low (fl k x) mu)).
  { destruct (Req_dec (low (fl k x) mu) tG) as [->|Hne]; [rewrite (proj1 Htouch); lra | left; apply Hopen; lra]. }
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

(** An orbit of the map is a motion. *)
Lemma which_period m s : 0 <= s < T * (INR m + 1) -> exists k u, (k <= m)%nat /\ 0 <= u < T /\ s = u + T * INR k.
Proof.
  revert s; induction m as [|m IH]; intros s Hs; [exists 0%nat, s; cbn in *; split; [lia | split; [lra | ring]]|].
  destruct (Rlt_dec s T) as [O|O]; [exists 0%nat, s; cbn; split; [lia | split; [lra | ring]]|].
  destruct (IH (s - T)) as (k & u & A & B' & C).
  - rewrite S_INR in Hs; split; [lra|]; replace (T * (INR m + 1)) with (T * (INR m + 1 + 1) - T) by ring; lra.
  - exists (S k), u; split; [lia | split; [exact B'|]]; rewrite S_INR; lra.
Qed.
Variable D : R.
Hypothesis S5 : 8 * (far * dd) <= 3 * g * (D * D).
Hypothesis S6 : far * dd <= D /\ D <= r0 / 4.
Lemma D_pos : 0 < D.
Proof. destruct (far_large 0 ltac:(lia)) as (_ & P & _); cbn in P; lra. Qed.
Lemma close_touch u : Rabs (u - tG) <= r0 -> y0 u <= far * dd -> Rabs (u - tG) <= D.
Proof.
  intros Hu Hy; destruct zero_box as (B0 & _); pose proof (Y_above zero 0 u B0 Hu) as A; cbv zeta in A; rewrite
    low_rest, !(proj1 (at_rest _)), (proj1 Htouch) in A. pose proof D_pos; rewrite <- (Rabs_pos_eq D) by lra; apply
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
Definition at_ (j : Z) : R := T * IZR (N j) + hit (j - 1).
Definition leg (j : Z) (t : R) : R := Y (x j) mu (t - T * IZR (N j)).
Definition legv (j : Z) (t : R) : R := V (x j) mu (t - T * IZR (N j)).

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
Lemma leg_near i s : flown i -> 0 <= s < T * (INR (n i) + 1) -> Rabs (Y (x i) mu s - y0 s) <= far * dd /\
  Rabs (V (x i) mu s - v0 s) <= far * dd.
Proof.
  intros F Hs; destruct (which_period (n i) s Hs) as (k & u & Hk & Hu & ->). destruct (fl_flow k (x i) u) as [<- <-];
    rewrite INR_IZR_INZ; destruct (y0_periods (Z.of_nat k) u) as [-> ->]. apply (fl_near k (x i) (Ox _ _ _ F)); [pose
    proof (Hn i); lia | lra].
Qed.
Lemma hit_near j : flown j -> Rabs (hit j - tG) <= D.
Proof. intros F; apply (hit_facts j (j + 1) F eq_refl). Qed.
Lemma leg_open i s : flown (i - 1) -> flown i -> hit (i - 1) < s < T * INR (n i) + hit i -> 0 < Y (x i) mu s.
Proof.
  intros F0 F Hs; destruct (hit_facts (i - 1) i F0 ltac:(lia)) as (_ & Cw & Ci & _ & Vz & E1 & E2 & _); destruct
    (hit_facts i (i + 1) F eq_refl) as (Bz' & Cw' & Ci' & Ez' & Vz' & _). set (c := hit (i - 1)) in *; set (c' := hit i)
    in *; destruct (which_period (n i) s) as (k & u & Hk & Hu & ->); [split; [lra|]; rewrite Rmult_plus_distr_l; pose
    proof (hit_near i F) as A; fold c' in A; apply le_abs in A; destruct S6; pose proof Hwin; lra|]. destruct (fl_flow k
    (x i) u) as [<- _]; assert (Hkm : (k <= n_max)%nat) by (pose proof (Hn i); lia).
  destruct (fl_near k (x i) (Ox _ _ _ F) Hkm) as (Bk & Lo & Ne). destruct (Rle_lt_dec r0 (Rabs (u - tG))) as
    [Far|Close].
  { specialize (S3 u ltac:(here; lra) Far); destruct (Ne u ltac:(here; lra)) as [A _]; apply le_abs in A; lra. }
  destruct (Nat.eq_dec k 0) as [->|K0]; [|destruct (Nat.eq_dec k (n i)) as [->|K1]].
  - cbn [INR] in Hs; rewrite Rmult_0_r, Rplus_0_r in Hs; change (fl 0 (x i)) with (x i) in *. rewrite <- E1; apply
      rising; trivial; try lra; rewrite E2; apply (proj1 (proj2 (proj2 Hreb))), Vz.
  - rewrite <- Ez'; apply (falling _ u c'); trivial; lra.
  - pose proof (Ok _ _ _ F k ltac:(lia)) as P; pose proof (Y_above (fl k (x i)) mu u Bk ltac:(here; lra)) as A; cbv
    zeta in A.
    assert (0 <= 3 / 8 * g * ((u - low (fl k (x i)) mu) * (u - low (fl k (x i)) mu))) by (apply Rmult_le_pos; [lra |
      apply Rle_0_sqr]); lra.
Qed.

Theorem orbit_leg i : flown (i - 1) -> flown i -> leg_is mu D N at_ leg legv i (i + 1).
Proof.
  intros P0 P1; destruct (hit_facts (i - 1) i P0 ltac:(lia)) as (_ & Cw & Ci & _ & Vz & E1 & E2 & Cd); destruct
    (hit_facts i (i + 1) P1 eq_refl) as (Bz' & Cw' & Ci' & Ez' & Vz' & E1' & E2' & Cd').
  assert (Ej : at_ (i + 1) = T * IZR (N (i + 1)%Z) + hit i) by (unfold at_; replace (i + 1 - 1)%Z with i by lia;
    reflexivity).
  assert (EN : T * IZR (N (i + 1)%Z) = T * IZR (N i) + T * INR (n i)) by (rewrite HN, plus_IZR, <- INR_IZR_INZ; ring).
  assert (Ei : at_ i = T * IZR (N i) + hit (i - 1)) by reflexivity; pose proof Hwin as (Hr & R1 & R2 & _); destruct S6
    as [_ S6']. apply le_abs in Cd, Cd'; assert (Tn : T <= T * INR (n i)) by (rewrite <- (Rmult_1_r T) at 1; apply
    Rmult_le_compat_l; [lra | apply (le_INR 1), Hn]).
  assert (Loc : forall s, leg i (T * IZR (N i) + s) = Y (x i) mu s /\ legv i (T * IZR (N i) + s) = V (x i) mu s).
  { intros s; unfold leg, legv; replace (T * IZR (N i) + s - T * IZR (N i)) with s by ring; auto. }
  destruct (fl_flow (n i) (x i) (hit i)) as [F1 F2]; rewrite Rplus_comm in F1, F2.
  assert (Eend : at_ (i + 1) = T * IZR (N i) + (T * INR (n i) + hit i)) by lra. split; [lra|]; split; [rewrite Ei;
    replace (T * IZR (N i) + hit (i - 1) - (tG + T * IZR (N i))) with (hit (i - 1) - tG) by ring; apply Rabs_le; lra|].
    split; [|split; [|split; [|split; [|split]]]].
  - intros t Ht; split; [apply shifted|]; replace t with (T * IZR (N i) + (t - T * IZR (N i))) by ring; destruct (Loc (t
      - T * IZR (N i))) as [-> ->].
    replace (T * IZR (N i) + (t - T * IZR (N i))) with (t - T * IZR (N i) + T * IZR (N i)) by ring; destruct (y0_periods
      (N i) (t - T * IZR (N i))) as [-> ->]. destruct (leg_near i (t - T * IZR (N i)) P1) as [A A']; [|lra]; split;
      [lra|]; rewrite Rmult_plus_distr_l; lra.
  - rewrite Ei, (proj1 (Loc _)); exact E1.
  - rewrite Eend, (proj1 (Loc _)), <- F1; exact Ez'.
  - intros t Ht; replace t with (T * IZR (N i) + (t - T * IZR (N i))) by ring; rewrite (proj1 (Loc _)); apply leg_open;
      trivial; lra.
  - rewrite Eend, (proj2 (Loc _)), <- F2; exact Vz'.
  - assert (Ev : legv i (at_ (i + 1)) = V (fl (n i) (x i)) mu (hit i)) by (rewrite Eend, (proj2 (Loc _)), <- F2;
      reflexivity). rewrite Ev, Ej; unfold legv.
    replace (T * IZR (N (i + 1)%Z) + hit i - T * IZR (N (i + 1)%Z)) with (hit i) by ring; rewrite E2'.
    pose proof (whole (fun t => rebound mu t (V (fl (n i) (x i)) mu (hit i))) T (fun t => Hrper t mu _) (N (i + 1)%Z)
      (hit i)) as P; cbv beta in P. rewrite Rplus_comm; symmetry; exact P.
Qed.
End FromOrbit.

(** A motion near the grazing orbit is an orbit of the map. *)
Definition facts (x : Z -> vec) (yy : Z -> R) : Prop := forall j, flown x yy j.
Theorem motion_orbit t y v Dm : motion mu Dm N t y v -> M * Dm <= dd -> Rabs mu <= Dm -> Dm <= r0 / 4 -> exists x yy,
  facts x yy /\ forall i u, t i <= u <= t (i + 1)%Z -> y i u = Y (x i) mu (u - T * IZR (N i)) /\
  v i u = V (x i) mu (u - T * IZR (N i)).
Proof.
  intros HM HD Hm HDr; pose proof Hwin as (Hr & R1 & R2 & _); pose proof M_large as LM.
  set (s i := t i - T * IZR (N i)); set (x i := origin mu (s i) (y i (t i)) (v i (t i))).
  assert (Hs : forall i, Rabs (s i - tG) <= Dm /\ 0 <= s i <= T).
  { intros i; destruct (HM i _ eq_refl) as (_ & A & _); replace (t i - (tG + T * IZR (N i))) with (s i - tG) in A by
      (unfold s; ring). split; [exact A | apply (in_period r0); lra]. }
  assert (Leg : forall i u, t i <= u <= t (i + 1)%Z -> y i u = Y (x i) mu (u - T * IZR (N i)) /\ v i u = V (x i) mu (u -
    T * IZR (N i))).
  { intros i u Hu; destruct (HM i _ eq_refl) as (O & _ & A & _).
    destruct (origin_flow mu (s i) (y i (t i)) (v i (t i))) as [E1 E2]; fold (x i) in E1, E2.
    apply (unique_on (t i) (t (i + 1)%Z) mu (y i) (v i) (fun u => Y (x i) mu (u - T * IZR (N i))) (fun u => V (x i) mu
      (u - T * IZR (N i))) (t i)); trivial; [|lra|symmetry; exact E1|symmetry; exact E2].
    intros w Hw; split; [apply A, Hw | apply shifted]. }
  assert (Ox : forall i, within 2 dd (x i)).
  { intros i; destruct (HM i _ eq_refl) as (O & _ & A & _); destruct (A (t i) ltac:(here; lra)) as (_ & A1 & A2).
    destruct (origin_flow mu (s i) (y i (t i)) (v i (t i))) as [E1 E2]; fold (x i) in E1, E2; destruct (Hs i) as [_
      Hsi].
    assert (P : y0 (t i) = y0 (s i) /\ v0 (t i) = v0 (s i)) by (replace (t i) with (s i + T * IZR (N i)) by (unfold s;
      ring); apply y0_periods). rewrite (proj1 P) in A1; rewrite (proj2 P) in A2.
    pose proof (nearby_back (x i) zero mu 0 Dm (s i)) as NB; rewrite E1, E2, (proj1 (at_rest _)), (proj2 (at_rest _)),
      Rminus_0_r in NB. specialize (NB A1 A2 Hm Hsi); intros j Hj; specialize (NB j Hj); unfold minus, zero in NB;
      rewrite Rminus_0_r in NB; lra. }
  set (z i := fl (n i) (x i)); set (yy i := sqrt (- Y (z i) mu (low (z i) mu))).
  assert (End : forall i, box (z i) mu /\ Rabs (low (z i) mu - tG) <= r0 / 4 /\ Y (z i) mu (s (i + 1)%Z) = 0 /\ V (z i)
    mu (s (i + 1)%Z) = v i (t (i + 1)%Z) /\ v i (t (i + 1)%Z) < 0).
  { intros i; destruct (HM i _ eq_refl) as (O & _ & _ & _ & E & _ & Vn & _); destruct (fl_near (n i) (x i) (Ox i)
      ltac:(here; apply Hn)) as (Bz & Lo & _).
    destruct (fl_flow (n i) (x i) (s (i + 1)%Z)) as [F1 F2]; destruct (Leg i (t (i + 1)%Z) ltac:(here; lra)) as [L1 L2].
    replace (s (i + 1)%Z + T * INR (n i)) with (t (i + 1)%Z - T * IZR (N i)) in F1, F2 by (unfold s; rewrite HN,
      plus_IZR, <- INR_IZR_INZ; ring). split; [exact Bz | split; [exact Lo|]]; unfold z; rewrite F1, F2, <- L1, <- L2;
      auto. }
  assert (Down : forall i, s (i + 1)%Z < low (z i) mu /\ Y (z i) mu (low (z i) mu) < 0).
  { intros i; destruct (End i) as (Bz & Lo & E1 & E2 & Vn); destruct (Hs (i + 1)%Z) as [Hsi _].
    assert (O : s (i + 1)%Z < low (z i) mu) by (apply before_low; trivial; lra); split; [exact O|].
    destruct (low_spec (z i) mu Bz) as (_ & El & _); rewrite <- E1; apply (falling (z i)); trivial; lra. }
  assert (Oy : forall i, 0 < yy i) by (intros i; apply sqrt_lt_R0; destruct (Down i); lra).
  assert (Oh : forall i, Y (z i) mu (low (z i) mu) = - (yy i * yy i)) by (intros i; unfold yy; rewrite sqrt_sqrt by
    (destruct (Down i); lra); ring). assert (Tc : forall i, tc (z i) (yy i) mu = s (i + 1)%Z).
  { intros i; destruct (End i) as (Bz & Lo & E1 & _), (Down i) as [O _], (Hs (i + 1)%Z) as [Hsi _].
    assert (Yb : ybox (yy i)) by (apply (low_y (n i) (x i)); [apply Ox | apply Hn | left; apply Oy | apply Oh]).
    destruct (off_spec (z i) (yy i) mu Bz Yb) as (_ & _ & _ & U); apply le_abs in Lo, Hsi.
    specialize (U (low (z i) mu - s (i + 1)%Z) ltac:(here; lra)); replace (low (z i) mu + -1 * (low (z i) mu - s (i +
      1)%Z)) with (s (i + 1)%Z) in U by ring. rewrite E1, Oh in U; specialize (U ltac:(here; ring)); unfold tc; rewrite
      <- U; ring. }
  exists x, yy; split; [|exact Leg]; intros i; constructor; [apply Ox | apply Oy | apply Oh | |].
  - intros k Hk; destruct (fl_near k (x i) (Ox i) ltac:(here; pose proof (Hn i); lia)) as (Bk & Lo & _); set (l := low
      (fl k (x i)) mu) in *. destruct (fl_flow k (x i) l) as [-> _]; destruct (HM i _ eq_refl) as (_ & _ & _ & _ & _ &
      Op & _). destruct (Hs i) as [S0' _], (Hs (i + 1)%Z) as [S1' _]; apply le_abs in S0', S1', Lo.
    assert (E : t (i + 1)%Z = s (i + 1)%Z + T * IZR (N i) + T * INR (n i)) by (unfold s; rewrite HN, plus_IZR, <-
      INR_IZR_INZ; ring).
    assert (K1 : T <= T * INR k) by (rewrite <- (Rmult_1_r T) at 1; apply Rmult_le_compat_l; [lra | apply (le_INR 1);
      lia]).
    assert (K2 : T * INR k + T <= T * INR (n i)) by (replace (T * INR k + T) with (T * INR (k + 1)) by (rewrite
      plus_INR; cbn [INR]; ring); apply Rmult_le_compat_l; [lra | apply le_INR; lia]).
    assert (Ei : t i = s i + T * IZR (N i)) by (unfold s; ring).
    assert (In : t i < l + T * INR k + T * IZR (N i) < t (i + 1)%Z) by lra.
    destruct (Leg i (l + T * INR k + T * IZR (N i)) ltac:(here; lra)) as [Q _]; specialize (Op _ In); rewrite Q in Op.
    replace (l + T * INR k + T * IZR (N i) - T * IZR (N i)) with (l + T * INR k) in Op by ring; exact Op.
  - intros k Hk; fold (z i); unfold after; rewrite Tc; destruct (End i) as (_ & _ & E1 & E2 & _); rewrite E1, E2.
    destruct (HM i _ eq_refl) as (_ & _ & _ & _ & _ & _ & _ & Im); destruct (HM (i + 1)%Z _ eq_refl) as (_ & _ & _ & Z &
      _). unfold x; rewrite Z, Im.
    pose proof (whole (fun u => rebound mu u (v i (t (i + 1)%Z))) T (fun u => Hrper u mu _) (N (i + 1)%Z) (s (i + 1)%Z))
      as P; cbv beta in P. replace (s (i + 1)%Z + T * IZR (N (i + 1)%Z)) with (t (i + 1)%Z) in P by (unfold s; ring);
      rewrite P; reflexivity.
Qed.

(** Two motions with the same orbit are the same. *)
Lemma same_motion t y v t' y' v' Dm x yy x' yy' : motion mu Dm N t y v -> motion mu Dm N t' y' v' -> Dm <= r0 / 4 ->
  facts x yy -> facts x' yy' -> (forall i u, t i <= u <= t (i + 1)%Z -> y i u = Y (x i) mu (u - T * IZR (N i)) /\
  v i u = V (x i) mu (u - T * IZR (N i))) -> (forall i u, t' i <= u <= t' (i + 1)%Z -> y' i u = Y (x' i) mu (u - T * IZR
  (N i)) /\ v' i u = V (x' i) mu (u - T * IZR (N i))) -> (forall j i, (i < 2)%nat -> x' j i = x j i) -> forall i,
  t' i = t i /\ forall u, t i <= u <= t (i + 1)%Z -> y' i u = y i u /\ v' i u = v i u.
Proof.
  intros HM HM' HD F F' Leg Leg' Ex; pose proof (proj1 Hwin) as Hr.
  assert (Ey : forall i u, Y (x' i) mu u = Y (x i) mu u /\ V (x' i) mu u = V (x i) mu u) by (intros i u; apply Y_ext;
    apply Ex; lia). assert (Et : forall i, t' (i + 1)%Z = t (i + 1)%Z).
  { intros i; destruct (HM i _ eq_refl) as (O & _ & _ & _ & E & _ & Vn & _), (HM' i _ eq_refl) as (O' & _ & _ & _ & E' &
      _ & Vn' & _).
    destruct (HM (i + 1)%Z _ eq_refl) as (_ & A & _), (HM' (i + 1)%Z _ eq_refl) as (_ & A' & _).
    rewrite (proj1 (Leg i _ ltac:(here; split; [left; exact O | right; reflexivity]))) in E; rewrite (proj2 (Leg i _
      ltac:(here; split; [left; exact O | right; reflexivity]))) in Vn.
    rewrite (proj1 (Leg' i _ ltac:(here; split; [left; exact O' | right; reflexivity]))), (proj1 (Ey _ _)) in E';
      rewrite (proj2 (Leg' i _ ltac:(here; split; [left; exact O' | right; reflexivity]))), (proj2 (Ey _ _)) in Vn'.
    destruct (fl_near (n i) (x i) (Ox _ _ _ (F i)) ltac:(here; apply Hn)) as (Bz & _).
    assert (Sh : forall w, w - T * IZR (N i) = (w - T * IZR (N (i + 1)%Z)) + T * INR (n i)) by (intros w; rewrite HN,
      plus_IZR, <- INR_IZR_INZ; ring). rewrite Sh in E, Vn, E', Vn'; destruct (fl_flow (n i) (x i) (t (i + 1)%Z - T *
      IZR (N (i + 1)%Z))) as [G1 G2], (fl_flow (n i) (x i) (t' (i + 1)%Z - T * IZR (N (i + 1)%Z))) as [G1' G2']. rewrite
      <- G1 in E; rewrite <- G2 in Vn; rewrite <- G1' in E'; rewrite <- G2' in Vn'.
    assert (W : forall w, Rabs (w - (tG + T * IZR (N (i + 1)%Z))) <= Dm -> Rabs (w - T * IZR (N (i + 1)%Z) - tG) <= r0).
    { intros w Hw; replace (w - T * IZR (N (i + 1)%Z) - tG) with (w - (tG + T * IZR (N (i + 1)%Z))) by ring; lra. }
    pose proof (one_crossing _ _ _ Bz (W _ A) (W _ A') E E' Vn Vn'); lra. }
  assert (Et' : forall i, t' i = t i) by (intros i; replace i with (i - 1 + 1)%Z by lia; apply Et). intros i; split;
    [apply Et'|]; intros u Hu; destruct (Leg i u Hu) as [-> ->]; rewrite <- !Et' in Hu; destruct (Leg' i u Hu) as [->
    ->]; apply Ey.
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
End Words.
End Motions.
