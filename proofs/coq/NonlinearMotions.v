(** * Where all has one period: the period map; motions of the equation with impacts are orbits of the map *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementUnstable StatementWords Headline Contraction Derivatives.
From Grazing Require Import NonlinearGronwall NonlinearFlow NonlinearTouch NonlinearSpeed NonlinearKick NonlinearMap.
From Grazing Require Import NonlinearFlights NonlinearWords.
Open Scope R_scope.
Class unbroken {F : force} {To : touch F} (I : impact To) := { Hperiodic : periodic F;
  Hopen : forall t, 0 <= t <= T -> t <> tG -> 0 < y0 t;
  Hkper : forall t, kk (t + T) = kk t /\ cc (t + T) = cc t /\ ll (t + T) = ll t;
  Hrper : forall t mu v, rebound mu (t + T) v = rebound mu t v }.
Section Motions.
Context {the_force : force} {the_touch : touch the_force} {the_window : near the_touch} {the_impact : impact the_touch}
  {the_period : unbroken the_impact}.
Let HT := HT. Let HL := HL. Let HtG := HtG. Let Hg := Hg. Let Hd0 := Hd0.
Existing Instance Hperiodic.
Notation at_time := (moves a). Notation sol := (runs a).
Notation lin := (solves kk cc ll).
Lemma period_lip x x' mu mu' r : within 2 r (minus x x') -> Rabs (mu - mu') <= r ->
  within 2 (M * r) (minus (period_map x mu) (period_map x' mu')).
Proof.
  intros Hx Hm; destruct (nearby x x' mu mu' r T Hx Hm ltac:(here; lra)) as [A A'].
  intros i Hi; unfold minus, period_map; destruct i as [|[|i]]; [| |lia]; match goal with |- Rabs ?u <= _ => match goal
    with A : Rabs ?v <= _ |- _ => replace u with v by ring; exact A end end.
Qed.
Lemma closes : y0 T = y0 0 /\ v0 T = v0 0.
Proof. destruct (Hyper 0) as [A B]; rewrite Rplus_0_l in A, B; auto. Qed.
Definition around : turn the_force := {| f := period_map; K := M;
  FA := fun i => match i with O => pair (p1 T) (p2 T) | _ => pair (q1 T) (q2 T) end; Fphi := pair (p3 T) (q3 T);
  HK := Rle_refl M; f_lip := period_lip; f_strict := period_strict (proj1 closes) (proj2 closes) |}.
Existing Instance around.
Lemma lin_shift m z w : lin m z w -> lin m (fun t => z (t + T)) (fun t => w (t + T)).
Proof.
  intros H t; destruct (H (t + T)) as [A A'], (Hkper t) as (K1 & K2 & K3); split; apply D_later; [exact A|];
    rewrite K1, K2, K3 in A'; exact A'.
Qed.
Lemma carried_shift m z w : lin m z w -> carried m z w (fun t => z (t + T)) (fun t => w (t + T)).
Proof.
  intros H; split; [apply lin_shift, H|]; destruct (lin_comb m z w T H ltac:(here; lra)) as [E1 E2]; cbv beta;
    rewrite !Rplus_0_l; cbn; lra.
Qed.
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
Variables (n_max : nat) (dd mu : R) (n : Z -> nat) (N : Z -> Z) (D : R).
Hypothesis HW : word n_max n N.
Hypothesis HS : sized n_max dd D.
Notation far := (far n_max).
Hypothesis S3 : forall t, 0 <= t <= T -> r0 <= Rabs (t - tG) -> far * dd < y0 t.
Hypothesis Hmu : Rabs mu <= dd.
Let Hn := proj1 HW. Let HN := proj2 HW. Let S0 := proj1 HS. Let S1 := proj1 (proj2 HS).
Let S2 := proj1 (proj2 (proj2 HS)). Let S4 := proj1 (proj2 (proj2 (proj2 HS))).
Let S5 := proj1 (proj2 (proj2 (proj2 (proj2 HS)))). Let S6 := proj2 (proj2 (proj2 (proj2 (proj2 HS)))).
Notation fl := (fl mu). Notation flown := (flown dd mu n). Notation hit := (hit mu n).
Lemma fl_flow k x t : Y (fl k x) mu t = Y x mu (t + T * INR k) /\ V (fl k x) mu t = V x mu (t + T * INR k).
Proof. apply iterates, _. Qed.
Definition fl_near := fl_near n_max dd mu Hmu S0 S1 S4.
Definition low_y := low_y n_max dd mu Hmu S0 S1 S2 S4.
Definition hit_facts := hit_facts n_max dd mu n Hn Hmu S0 S1 S2 S4 D S5 S6.
Definition hit_near := hit_near n_max dd mu n Hn Hmu S0 S1 S2 S4 D S5 S6.

(** An orbit of the map is a motion. *)
Lemma which_period m s : 0 <= s < T * (INR m + 1) -> exists k u, (k <= m)%nat /\ 0 <= u < T /\ s = u + T * INR k.
Proof.
  revert s; induction m as [|m IH]; intros s Hs; [exists 0%nat, s; cbn in *; split; [lia | split; [lra | ring]]|].
  destruct (Rlt_dec s T) as [O|O]; [exists 0%nat, s; cbn; split; [lia | split; [lra | ring]]|].
  destruct (IH (s - T)) as (k & u & A & B' & C).
  - rewrite S_INR in Hs; split; [lra|]; replace (T * (INR m + 1)) with (T * (INR m + 1 + 1) - T) by ring; lra.
  - exists (S k), u; split; [lia | split; [exact B'|]]; rewrite S_INR; lra.
Qed.

Section FromOrbit.
Variables (x : Z -> vec) (yy : Z -> R).
Notation flown := (flown x yy). Notation hit := (hit x yy). Notation at_ := (at_ mu n x yy T 0 N).
Definition leg (j : Z) (t : R) : R := Y (x j) mu (t - T * IZR (N j)).
Definition legv (j : Z) (t : R) : R := V (x j) mu (t - T * IZR (N j)).
Lemma leg_near i s : flown i -> 0 <= s < T * (INR (n i) + 1) -> Rabs (Y (x i) mu s - y0 s) <= far * dd /\
  Rabs (V (x i) mu s - v0 s) <= far * dd.
Proof.
  intros F Hs; destruct (which_period (n i) s Hs) as (k & u & Hk & Hu & ->). destruct (fl_flow k (x i) u) as [<- <-];
    rewrite INR_IZR_INZ; destruct (y0_periods (Z.of_nat k) u) as [-> ->]. apply (fl_near k (x i) (Ox _ _ _ _ _ _ F));
        [pose
    proof (Hn i); lia | lra].
Qed.
Lemma leg_open i s : flown (i - 1) -> flown i -> hit (i - 1) < s < T * INR (n i) + hit i -> 0 < Y (x i) mu s.
Proof.
  intros F0 F Hs; destruct (hit_facts x yy (i - 1) i F0 ltac:(lia)) as (_ & Cw & Ci & _ & Vz & E1 & E2 & _); destruct
    (hit_facts x yy i (i + 1)%Z F eq_refl) as (Bz' & Cw' & Ci' & Ez' & Vz' & _). set (c := hit (i - 1)) in *; set (c' :=
        hit i)
    in *; destruct (which_period (n i) s) as (k & u & Hk & Hu & ->); [split; [lra|]; rewrite Rmult_plus_distr_l; pose
    proof (hit_near x yy i F) as A; fold c' in A; apply le_abs in A; destruct S6 as [_ S6']; pose proof Hwin; lra|].
        destruct (fl_flow k
    (x i) u) as [<- _]; assert (Hkm : (k <= n_max)%nat) by (pose proof (Hn i); lia).
  destruct (fl_near k (x i) (Ox _ _ _ _ _ _ F) Hkm) as (Bk & Lo & Ne). destruct (Rle_lt_dec r0 (Rabs (u - tG))) as
    [Far|Close].
  { specialize (S3 u ltac:(here; lra) Far); destruct (Ne u ltac:(here; lra)) as [A _]; apply le_abs in A; lra. }
  destruct (Nat.eq_dec k 0) as [->|K0]; [|destruct (Nat.eq_dec k (n i)) as [->|K1]].
  - cbn [INR] in Hs; rewrite Rmult_0_r, Rplus_0_r in Hs; change (fl 0 (x i)) with (x i) in *. rewrite <- E1; apply
      rising; trivial; try lra; rewrite E2; apply (proj1 (proj2 (proj2 Hreb))), Vz.
  - rewrite <- Ez'; apply (falling mu _ u c'); trivial; lra.
  - pose proof (Ok _ _ _ _ _ _ F k ltac:(lia)) as P; pose proof (Y_above (fl k (x i)) mu u Bk ltac:(here; lra)) as A;
    cbv zeta in A.
    assert (0 <= 3 / 8 * g * ((u - low (fl k (x i)) mu) * (u - low (fl k (x i)) mu))) by (apply Rmult_le_pos; [lra |
      apply Rle_0_sqr]); lra.
Qed.

Theorem orbit_leg i : flown (i - 1) -> flown i -> leg_is mu D N at_ leg legv i (i + 1).
Proof.
  intros P0 P1; destruct (hit_facts x yy (i - 1) i P0 ltac:(lia)) as (_ & Cw & Ci & _ & Vz & E1 & E2 & Cd); destruct
    (hit_facts x yy i (i + 1)%Z P1 eq_refl) as (Bz' & Cw' & Ci' & Ez' & Vz' & E1' & E2' & Cd').
  assert (Ej : at_ (i + 1) = T * IZR (N (i + 1)%Z) + hit i) by (unfold at_; replace (i + 1 - 1)%Z with i by lia;
    ring).
  assert (EN : T * IZR (N (i + 1)%Z) = T * IZR (N i) + T * INR (n i)) by (rewrite HN, plus_IZR, <- INR_IZR_INZ; ring).
  assert (Ei : at_ i = T * IZR (N i) + hit (i - 1)) by (unfold at_; ring); pose proof Hwin as (Hr & R1 & R2 & _);
    destruct S6 as [_ S6']. apply le_abs in Cd, Cd'; assert (Tn : T <= T * INR (n i)) by (rewrite <- (Rmult_1_r T) at 1;
        apply
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
Notation facts := (facts dd mu n).
Definition is_of (x : Z -> vec) (t : Z -> R) (y v : Z -> R -> R) : Prop := forall i u, t i <= u <= t (i + 1)%Z ->
  y i u = Y (x i) mu (u - T * IZR (N i)) /\ v i u = V (x i) mu (u - T * IZR (N i)).
Theorem motion_orbit t y v Dm : motion mu Dm N t y v -> M * Dm <= dd -> Rabs mu <= Dm -> Dm <= r0 / 4 -> exists x yy,
  facts x yy /\ is_of x t y v.
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
  assert (Cross : forall i, 0 < yy i /\ Y (z i) mu (low (z i) mu) = - (yy i * yy i) /\ tc (z i) (yy i) mu =
    s (i + 1)%Z).
  { intros i; destruct (End i) as (Bz & Lo & E1 & E2 & Vn), (Hs (i + 1)%Z) as [Hsi _].
    apply (crossing_is n_max dd mu Hmu S0 S1 S2 S4 (x i) (n i)); [apply Ox | apply Hn | lra | exact E1 |
      exact (eq_ind_r (fun r => r < 0) Vn E2)]. }
  assert (Oy : forall i, 0 < yy i) by (intros i; apply Cross).
  assert (Oh : forall i, Y (z i) mu (low (z i) mu) = - (yy i * yy i)) by (intros i; apply Cross).
  assert (Tc : forall i, tc (z i) (yy i) mu = s (i + 1)%Z) by (intros i; apply Cross).
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
  facts x yy -> facts x' yy' -> is_of x t y v -> is_of x' t' y' v' -> (forall j i, (i < 2)%nat -> x' j i = x j i) ->
      forall i,
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
    destruct (fl_near (n i) (x i) (Ox _ _ _ _ _ _ (F i)) ltac:(here; apply Hn)) as (Bz & _).
    assert (Sh : forall w, w - T * IZR (N i) = (w - T * IZR (N (i + 1)%Z)) + T * INR (n i)) by (intros w; rewrite HN,
      plus_IZR, <- INR_IZR_INZ; ring). rewrite Sh in E, Vn, E', Vn'; destruct (fl_flow (n i) (x i) (t (i + 1)%Z - T *
      IZR (N (i + 1)%Z))) as [G1 G2], (fl_flow (n i) (x i) (t' (i + 1)%Z - T * IZR (N (i + 1)%Z))) as [G1' G2']. rewrite
      <- G1 in E; rewrite <- G2 in Vn; rewrite <- G1' in E'; rewrite <- G2' in Vn'.
    assert (W : forall w, Rabs (w - (tG + T * IZR (N (i + 1)%Z))) <= Dm -> Rabs (w - T * IZR (N (i + 1)%Z) - tG) <= r0).
    { intros w Hw; replace (w - T * IZR (N (i + 1)%Z) - tG) with (w - (tG + T * IZR (N (i + 1)%Z))) by ring; lra. }
    pose proof (one_crossing _ _ _ _ Bz (W _ A) (W _ A') E E' Vn Vn'); lra. }
  assert (Et' : forall i, t' i = t i) by (intros i; replace i with (i - 1 + 1)%Z by lia; apply Et). intros i; split;
    [apply Et'|]; intros u Hu; destruct (Leg i u Hu) as [-> ->]; rewrite <- !Et' in Hu; destruct (Leg' i u Hu) as [->
    ->]; apply Ey.
Qed.
End Words.

Lemma far_from_touch : exists ym, 0 < ym /\ forall t, 0 <= t <= T -> r0 <= Rabs (t - tG) -> ym <= y0 t.
Proof.
  pose proof Hwin as (Hr & R1 & R2 & _).
  assert (C : forall t, continuity_pt y0 t) by (intros t; apply (D_continuous _ _ _ (proj1 (Horb t)))).
  destruct (continuity_ab_min y0 0 (tG - r0) ltac:(here; lra) (fun t _ => C t)) as (u1 & U1 & I1).
  destruct (continuity_ab_min y0 (tG + r0) T ltac:(here; lra) (fun t _ => C t)) as (u2 & U2 & I2).
  destruct (two_least (y0 u1) (y0 u2)) as (ym & P & L1 & L2); [apply Hopen; lra | apply Hopen; lra|]. exists ym; split;
    [exact P|]; intros t Ht Far; unfold Rabs in Far; destruct (Rcase_abs (t - tG)).
  - specialize (U1 t ltac:(here; lra)); lra.
  - specialize (U2 t ltac:(here; lra)); lra.
Qed.
Theorem unbroken_core A11 A21 A22 gamma z w : (forall z w, lin 0 z w -> z (tG + T) = A11 * z tG + gamma * w tG /\
  w (tG + T) = A21 * z tG + A22 * w tG) -> gamma <> 0 -> lin 1 z w -> z T = z 0 -> w T = w 0 -> z tG <> 0 -> let a1 :=
  A11 + A22 in let a2 := A11 * A22 - gamma * A21 in forall n_max, exists d, d > 0 /\ forall eps, 0 < eps <= d ->
  exists mu0, mu0 > 0 /\ forall (n : Z -> nat) (N : Z -> Z) e s mu, (forall i, (1 <= n i <= n_max)%nat /\
  u a1 a2 (n i) <> 0) -> (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z -> sgn s * gamma > 0 ->
  0 < sgn e * (z tG * mu) < mu0 -> ((forall i, member a1 a2 e (n i) /\ edge a1 a2 e s (n i) (n (i + 1)%Z)) ->
  exists t y v, motion mu eps N t y v /\ unstable_motion (leg_is mu eps N) t v /\ forall t' y' v', motion mu eps N t'
    y' v' -> forall i, t' i = t i /\ forall x,
  t i <= x <= t (i + 1)%Z -> y' i x = y i x /\ v' i x = v i x) /\ ((exists i, breaks a1 a2 e s (n i) (n (i + 1)%Z)) ->
  forall t y v, ~ motion mu d N t y v).
Proof.
  intros HA Hgam Hz Ez Ew Hr a1 a2 n_max; pose proof M_large as LM; pose proof (proj1 Hwin) as Hr0.
  pose (Good := fun (n_max : nat) (dd D : R) => forall t, 0 <= t <= T -> r0 <= Rabs (t - tG) -> far n_max * dd < y0 t).
  pose (Trace := fun (mu : R) (n : Z -> nat) N x t y v => is_of mu N x t y v).
  apply (core T 0 (r0 / 4) M leg_is (fun mu _ N x => leg mu N x) (fun mu _ N x => legv mu N x) Good Trace) with (w :=
      w).
  - lra.
  - intros m D HD; destruct far_from_touch as (ym & Hy & Ym); destruct (size_exists m D (ym / 2) ltac:(here; lra)
      ltac:(here; lra)) as (dd & Hdd & HS & Hf). exists dd; split; [lra|].
    assert (G : forall dd', 0 < dd' <= dd -> Good m dd' D).
    { intros dd' Hd t Ht Far; specialize (Ym t Ht Far); destruct (size_less m dd dd' D HS Hd) as (_ & _ & _ & _ & _ &
        _).
      assert (0 <= far m) by (unfold far; apply Rmult_le_pos; [|apply pow_le]; pose proof K_large; lra).
      assert (far m * dd' <= far m * dd) by (apply Rmult_le_compat_l; lra); lra. }
    split; [apply G; lra | exact G].
  - intros m dd mu n N D x yy i HW HS HG Hmu F0 F1; exact (orbit_leg m dd mu n N D HW HS HG Hmu x yy i F0 F1).
  - intros m dd mu n N D x yy i _ _ _ _ _; unfold legv, at_; f_equal; ring.
  - intros m dd mu n N D r t y v HW HS HG Hm Hk Hr' HM; assert (Hd : r <= M * r) by (rewrite <- (Rmult_1_l r) at 1;
      apply Rmult_le_compat_r; [pose proof (Rabs_pos mu); lra | lra]).
    pose proof HS as (S0 & S1 & S2 & S4 & S5 & S6); apply (motion_orbit m dd mu n N D HW HS ltac:(here; lra) t y v r
      HM); lra.
  - intros m dd mu n N D r x yy x' yy' t y v t' y' v' HW HS HG Hm Hk Hr' HM HM' F F' Tr Tr' Ex; assert (Hd : r <= M * r)
      by (rewrite <- (Rmult_1_l r) at 1; apply Rmult_le_compat_r; [pose proof (Rabs_pos mu); lra | lra]).
    pose proof HS as (S0 & S1 & S2 & S4 & S5 & S6). apply (same_motion m dd mu n N D HW HS ltac:(here; lra) t y v t' y'
      v' r x yy x' yy' HM HM'); trivial; lra.
  - intros u v Hu; exists (fun t => u (t + T)), (fun t => v (t + T)); split; [apply carried_shift, Hu | apply HA, Hu].
  - exact Hgam.
  - exact Hz.
  - destruct (carried_shift 1 z w Hz) as (_ & E1 & E2); split; [exact Hz|]; cbv beta in E1, E2; rewrite Rplus_0_l in
      E1, E2; rewrite Ez in E1; rewrite Ew in E2; auto.
  - exact Hr.
Qed.
End Motions.
