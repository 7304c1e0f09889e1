(** * Theorem 1 for motions that are the orbits of the map: which words are motions, and that these are
    unstable *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane StatementWords StatementUnstable Headline
  OrbitVectors PlaneOrbits Orbits OrbitsNear OrbitsUnstable Derivatives.
From Grazing Require Import NonlinearGronwall NonlinearFlow NonlinearTouch NonlinearSpeed NonlinearKick NonlinearMap.
From Grazing Require Import NonlinearFlights.
Open Scope R_scope.
Section Words.
Context {the_force : force} {the_touch : touch the_force} {the_window : near the_touch} {the_impact : impact the_touch}
  {the_turn : turn the_force}.
Let HT := HT. Let HL := HL. Let HtG := HtG. Let Hg := Hg. Let Hd0 := Hd0.
Notation lin := (solves kk cc ll).

(** How small the states must be, for at most n_max turns and impacts within D of the touch. *)
Definition sized (n_max : nat) (dd D : R) : Prop := 0 < dd /\ far n_max * dd <= d0 /\
  32 * (far n_max * dd) < 3 * g * (r0 * r0) /\ 16 * (far n_max * dd) <= 3 * g * r0 /\
  8 * (far n_max * dd) <= 3 * g * (D * D) /\ far n_max * dd <= D /\ D <= r0 / 4.
Lemma size_exists n_max D b : 0 < D <= r0 / 4 -> 0 < b -> exists dd, 0 < dd <= b /\ sized n_max dd D /\
  far n_max * dd <= b.
Proof.
  intros HD Hb; pose proof Hwin as (Hr & _ & _ & Hd0' & _); pose proof K_large as LM.
  assert (F1 : 1 <= far n_max) by (unfold far; pose proof (pow_R1_Rle K n_max LM); rewrite <- (Rmult_1_l 1); apply
    Rmult_le_compat; lra).
  assert (P1 : 0 < g * (r0 * r0)) by (apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]); assert (P2 : 0 < g
    * r0) by (apply Rmult_lt_0_compat; lra).
  assert (P3 : 0 < g * (D * D)) by (apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]).
  destruct (two_least d0 (g * (r0 * r0) / 32) Hd0' ltac:(here; lra)) as (e1 & E1 & A1 & B1), (two_least e1 b E1 Hb) as
    (e2 & E2 & A2 & B2).
  destruct (two_least e2 (g * r0 / 16) E2 ltac:(here; lra)) as (e3 & E3 & A3 & B3), (two_least e3 (g * (D * D) / 8) E3
    ltac:(here; lra)) as (e4 & E4 & A4 & B4).
  destruct (two_least e4 D E4 ltac:(here; lra)) as (e5 & E5 & A5 & B5), (two_least b (e5 / far n_max) Hb ltac:(here;
    apply Rdiv_lt_0_compat; lra)) as (dd & Hdd & A6 & B6).
  assert (Q : far n_max * dd <= e5) by (apply Rle_trans with (far n_max * (e5 / far n_max)); [apply Rmult_le_compat_l;
    lra | right; field; lra]). exists dd; unfold sized; repeat split; lra.
Qed.
Lemma size_less n_max dd dd' D : sized n_max dd D -> 0 < dd' <= dd -> sized n_max dd' D.
Proof.
  intros (A & B & C & E & F & G & H) Hd; pose proof K_large as LM; assert (F1 : 1 <= far n_max) by (unfold far; pose
    proof (pow_R1_Rle K n_max LM); rewrite <- (Rmult_1_l 1); apply Rmult_le_compat; lra).
  assert (far n_max * dd' <= far n_max * dd) by (apply Rmult_le_compat_l; lra); unfold sized; repeat split; lra.
Qed.

(** Given: what a motion is from impact to impact, the period P, the time sg at which the arc of the touch
    begins, and for states x after impacts which motion they make,
    where they are as small as [sized] and [Good] say; and what it means that a motion is the one of x. *)
Variables (P sg Dm Km : R) (Leg : R -> R -> (Z -> Z) -> (Z -> R) -> (Z -> R -> R) -> (Z -> R -> R) -> Z -> Z -> Prop).
Variables (Pl Vl : R -> (Z -> nat) -> (Z -> Z) -> (Z -> vec) -> Z -> R -> R) (Good : nat -> R -> R -> Prop).
Variable Trace : R -> (Z -> nat) -> (Z -> Z) -> (Z -> vec) -> (Z -> R) -> (Z -> R -> R) -> (Z -> R -> R) -> Prop.
Definition word (n_max : nat) (n : Z -> nat) (N : Z -> Z) : Prop :=
  (forall i, (1 <= n i <= n_max)%nat) /\ forall i, (N (i + 1) = N i + Z.of_nat (n i))%Z.
Definition motion mu D N t y v : Prop := forall i j, j = (i + 1)%Z -> Leg mu D N t y v i j.
Hypothesis HDm : 0 < Dm <= r0 / 4 /\ 1 <= Km.
Hypothesis Hgood : forall n_max D, 0 < D <= Dm -> exists dd, 0 < dd /\ Good n_max dd D /\
  forall dd', 0 < dd' <= dd -> Good n_max dd' D.
Hypothesis Hleg : forall n_max dd mu n N D x yy i, word n_max n N -> sized n_max dd D -> Good n_max dd D ->
  Rabs mu <= dd -> flown dd mu n x yy (i - 1) -> flown dd mu n x yy i ->
  Leg mu D N (at_ mu n x yy P sg N) (Pl mu n N x) (Vl mu n N x) i (i + 1).
Hypothesis Hvel : forall n_max dd mu n N D x yy i, word n_max n N -> sized n_max dd D -> Good n_max dd D ->
  Rabs mu <= dd -> flown dd mu n x yy (i - 1) -> Vl mu n N x i (at_ mu n x yy P sg N i) = V (x i) mu (hit mu n x yy (i -
      1)).
Hypothesis Hmotion : forall n_max dd mu n N D r t y v, word n_max n N -> sized n_max dd D -> Good n_max dd D ->
  Rabs mu <= r -> Km * r <= dd -> r <= D -> motion mu r N t y v -> exists x yy, facts dd mu n x yy /\
  Trace mu n N x t y v.
Hypothesis Hsame : forall n_max dd mu n N D r x yy x' yy' t y v t' y' v', word n_max n N -> sized n_max dd D ->
  Good n_max dd D -> Rabs mu <= r -> Km * r <= dd -> r <= D -> motion mu r N t y v -> motion mu r N t' y' v' ->
  facts dd mu n x yy -> facts dd mu n x' yy' -> Trace mu n N x t y v -> Trace mu n N x' t' y' v' ->
  (forall j i, (i < 2)%nat -> x' j i = x j i) ->
  forall i, t' i = t i /\ forall u, t i <= u <= t (i + 1)%Z -> y' i u = y i u /\ v' i u = v i u.
Lemma both_sizes n_max D b : 0 < D <= Dm -> 0 < b -> exists dd, 0 < dd <= b /\ sized n_max dd D /\ Good n_max dd D.
Proof.
  intros HD Hb; destruct (size_exists n_max D b ltac:(here; lra) Hb) as (d1 & H1 & H2 & _), (Hgood n_max D HD) as (d2 &
    H3 & _ & H4). destruct (two_least d1 d2 (proj1 H1) H3) as (dd & H5 & H6 & H7); exists dd; split; [lra|]; split;
    [apply (size_less n_max d1); [exact H2 | lra] | apply H4; lra].
Qed.

Lemma iter_Z p k : Nat.iter k (fun j => j + 1)%Z p = (p + Z.of_nat k)%Z.
Proof.
  induction k as [|k IH]; [cbn; lia|]; change ((Nat.iter k (fun j => j + 1) p + 1)%Z = (p + Z.of_nat (Datatypes.S
    k))%Z).
  rewrite IH; lia.
Qed.

(** The motion of an orbit that others leave is left by their motions. *)
Theorem motion_left n_max dd mu n N D x yy : word n_max n N -> sized n_max dd D -> Good n_max dd D -> Rabs mu <= dd ->
  (forall j, flown dd mu n x yy j) -> (forall j, within 2 (dd / 2) (x j)) ->
  leaving map Z (fun j => j + 1)%Z n mu x -> unstable_motion (Leg mu D N) (at_ mu n x yy P sg N) (Vl mu n N x).
Proof.
  intros HW HS HG Hmu F Hx Lv; pose proof HS as (S0 & S1 & S2 & S4 & S5 & S6); destruct HW as [Hn HN].
  destruct (Lv (dd / 2) ltac:(lra)) as (r & Hr & Leave); destruct (after_near n_max dd mu n Hn Hmu S0 S1 S2 S4 D S5 S6)
    as (Q1 & P1 & Near), (after_far n_max dd mu n Hn Hmu S0 S1 S2 S4 D S5 S6) as (Q2 & P2 & Far). exists (r / (Q2 + 1));
    split; [apply Rdiv_lt_0_compat; lra|]; intros j eps He; set (p := (j - 1)%Z).
  destruct (two_least r (eps / Q1) ltac:(here; lra) ltac:(here; apply Rdiv_lt_0_compat; lra)) as (e & E0 & E1 & E2).
  apply (Rmult_le_compat_l Q1) in E2; [|lra]; replace (Q1 * (eps / Q1)) with eps in E2 by (field; lra).
  destruct (Leave p e E0) as (z & l & Z0 & Y0 & Z1 & Fly & Out).
  set (x' := fun i => z (Z.to_nat (i - p))); set (yy' := fun i => speed_at map mu (n i) (x' i)).
  assert (Ex : forall k, x' (p + Z.of_nat k)%Z = z k) by (intros k; unfold x'; f_equal; lia).
  assert (L2 : (2 <= l)%nat).
  { destruct l as [|[|l]]; [exfalso; apply Out; intros i Hi; exact (Rle_trans _ _ _ (Z0 i Hi) E1) | | lia].
    exfalso; apply Out; intros i Hi; exact (Rle_trans _ _ _ (Z1 i Hi) E1). }
  assert (F' : forall k, (k < l)%nat -> flown dd mu n x' yy' (p + Z.of_nat k)%Z).
  { intros k Hk; destruct (Fly k Hk) as (In & Hit & Free & Next); rewrite iter_Z in In, Hit, Free, Next; set (i := (p +
      Z.of_nat k)%Z) in *; assert (Ei : x' i = z k) by apply Ex.
    assert (Ox : within 2 dd (x' i)) by (rewrite Ei; intros q Hq; specialize (In q Hq); pose proof (Hx i q Hq) as X;
      unfold minus in In; replace (z k q) with ((z k q - x i q) + x i q) by ring; eapply Rle_trans; [apply
      Rabs_triang|]; lra).
    assert (Py : 0 < yy' i) by (unfold yy', speed_at; rewrite Ei; apply sqrt_lt_R0; cbn in Hit |- *; lra).
    assert (Oh : Y (fl mu (n i) (x' i)) mu (low (fl mu (n i) (x' i)) mu) = - (yy' i * yy' i)).
    { unfold yy', speed_at; rewrite sqrt_sqrt, Ei by (rewrite Ei; lra); rewrite Ropp_involutive; reflexivity. }
    constructor; [exact Ox | exact Py | exact Oh | |].
    - rewrite Ei; exact Free.
    - intros q Hq; assert (Bz := proj1 (fl_near n_max dd mu Hmu S0 S1 S4 (n i) (x' i) Ox ltac:(here; apply Hn))).
      assert (Yb : ybox (yy' i)) by (apply (low_y n_max dd mu Hmu S0 S1 S2 S4 (n i) (x' i)); [exact Ox | apply Hn | lra
        | exact Oh]).
      replace (i + 1)%Z with (p + Z.of_nat (Datatypes.S k))%Z by (unfold i; lia); rewrite Ex, Next by exact Hq; unfold
        go.
      rewrite <- Ei; fold (yy' i); change (OrbitRemainder.fly map mu (n i) (x' i)) with (fl mu (n i) (x' i)).
      change (Map.kick map) with kick; rewrite kick_y by assumption; ring. }
  set (l' := (p + Z.of_nat l)%Z); exists l', (at_ mu n x' yy' P sg N), (Pl mu n N x'), (Vl mu n N x').
  assert (Wx : forall i, within 2 dd (x i)) by (intros i; apply F).
  assert (Diff : forall i, at_ mu n x' yy' P sg N i - at_ mu n x yy P sg N i = hit mu n x' yy' (i - 1) - hit mu n x yy
    (i - 1)) by (intros i; unfold at_; ring).
  assert (Vel : forall u yu i, flown dd mu n u yu (i - 1) -> Vl mu n N u i (at_ mu n u yu P sg N i) = V (u i) mu (hit mu
    n u yu (i - 1))) by (intros u yu i; apply (Hvel n_max dd mu n N D u yu i (conj Hn HN) HS HG Hmu)).
  split; [unfold l', p; lia | split; [|split]].
  - intros i Hi; apply (Hleg n_max dd mu n N D x' yy' i (conj Hn HN) HS HG Hmu).
    + replace (i - 1)%Z with (p + Z.of_nat (Z.to_nat (i - 1 - p)))%Z by (unfold p; lia); apply F'; unfold l', p in *;
      lia.
    + replace i with (p + Z.of_nat (Z.to_nat (i - p)))%Z by (unfold p; lia); apply F'; unfold l', p in *; lia.
  - pose proof (F' 0%nat ltac:(lia)) as F0; cbn [Z.of_nat] in F0; rewrite Z.add_0_r in F0.
    assert (E0' : x' p = z 0%nat) by (rewrite <- (Z.add_0_r p); apply (Ex 0%nat)).
    destruct (Near x x' yy yy' p e (F p) F0 (Wx _)) as [A B].
    + rewrite E0'; exact Z0.
    + replace (yy p) with (speed_at map mu (n p) (x p)); [unfold yy'; rewrite E0'; exact Y0|].
      unfold speed_at; change (Map.h map (OrbitRemainder.fly map mu (n p) (x p)) mu) with (Y (fl mu (n p) (x p)) mu (low
        (fl mu (n p) (x p)) mu)); rewrite (Oh _ _ _ _ _ _ (F p)), Ropp_involutive; apply sqrt_square; left; apply (Oy _
        _ _ _ _ _ (F p)).
    + rewrite (Ex 1%nat : x' (p + 1)%Z = _); exact Z1.
    + unfold StatementUnstable.near; rewrite Diff, (Vel x' yy' j F0), (Vel x yy j (F _)); replace (p + 1)%Z with j in B
      by (unfold p; lia); fold p; split; lra.
  - intros [A B]; rewrite Diff in A; apply Out; rewrite iter_Z; fold l'.
    assert (El : x' l' = z l) by apply Ex; rewrite <- El; set (i := (l' - 1)%Z) in *.
    assert (Ei : l' = (i + 1)%Z) by (unfold i; lia); rewrite Ei in B |- *.
    assert (Fi : flown dd mu n x' yy' i) by (replace i with (p + Z.of_nat (l - 1))%Z by (unfold i, l'; lia); apply F';
        lia).
    assert (Fi' : flown dd mu n x' yy' (i + 1 - 1)) by (replace (i + 1 - 1)%Z with i by lia; exact Fi).
    rewrite (Vel x' yy' _ Fi'), (Vel x yy _ (F _)) in B; replace (i + 1 - 1)%Z with i in B by lia.
    apply (within_le 2 (Q2 * (r / (Q2 + 1)))); [|apply (Far x x' yy yy' i); auto].
    apply (Rmult_le_reg_r (Q2 + 1)); [lra|]; replace (Q2 * (r / (Q2 + 1)) * (Q2 + 1)) with (Q2 * r) by (field; lra);
      lra.
Qed.

Theorem core A11 A21 A22 gamma z w : (forall z w, lin 0 z w -> exists z' w', carried 0 z w z' w' /\
  z' tG = A11 * z tG + gamma * w tG /\ w' tG = A21 * z tG + A22 * w tG) -> gamma <> 0 -> lin 1 z w ->
  carried 1 z w z w -> z tG <> 0 -> let a1 :=
  A11 + A22 in let a2 := A11 * A22 - gamma * A21 in forall n_max, exists d, d > 0 /\ forall eps, 0 < eps <= d ->
  exists mu0, mu0 > 0 /\ forall (n : Z -> nat) (N : Z -> Z) e s mu, (forall i, (1 <= n i <= n_max)%nat /\
  u a1 a2 (n i) <> 0) -> (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z -> sgn s * gamma > 0 ->
  0 < sgn e * (z tG * mu) < mu0 -> ((forall i, member a1 a2 e (n i) /\ edge a1 a2 e s (n i) (n (i + 1)%Z)) ->
  exists t y v, motion mu eps N t y v /\ unstable_motion (Leg mu eps N) t v /\ forall t' y' v', motion mu eps N t'
    y' v' -> forall i, t' i = t i /\ forall x,
  t i <= x <= t (i + 1)%Z -> y' i x = y i x /\ v' i x = v i x) /\ ((exists i, breaks a1 a2 e s (n i) (n (i + 1)%Z)) ->
  forall t y v, ~ motion mu d N t y v).
Proof.
  intros HA Hgam Hz Ez Hr a1 a2 n_max; pose proof (map_planar A11 A21 A22 gamma z w HA Hgam Hz Ez Hr) as HP; fold a1 a2
    in HP. pose proof cg_pos as Hc; assert (Ht0 := proj1 Hreb); pose proof (proj1 Hwin) as Hr0.
  destruct (Theorem1_plane map a1 a2 _ _ _ HP n_max) as (dT & muT & HdT & HmT & W & Tends), (plane_leave map a1 a2 _ _ _
    HP n_max) as (dL & HdL & Leave). destruct (two_least dT dL HdT HdL) as (dS & HdS & LT & LL).
  destruct (both_sizes n_max Dm dS ltac:(here; lra) HdS) as (dd & Hdd & HS & HG); pose proof HS as (_ & S1 & S2 & S4 &
      _).
  destruct (two_least (dd / Km) Dm ltac:(here; apply Rdiv_lt_0_compat; lra) ltac:(here; lra)) as (d & Hd & L1 & L2).
  assert (Md : Km * d <= dd) by (apply Rle_trans with (Km * (dd / Km)); [apply Rmult_le_compat_l; lra | right; field;
    lra]). assert (d <= Km * d) by (rewrite <- (Rmult_1_l d) at 1; apply Rmult_le_compat_r; lra). exists d; split;
    [exact Hd|]; intros eps Heps.
  destruct (both_sizes n_max eps dd ltac:(here; lra) (proj1 Hdd)) as (de & Hde & HSe & HGe); pose proof HSe as (_ & E1 &
    E2 & E4 & E5 & E6).
  destruct (Tends (de / 2) ltac:(here; lra)) as (mu1 & Hm1 & Near); assert (Pr : 0 < Rabs (z tG)) by (apply Rabs_pos_lt,
    Hr).
  destruct (two_least mu1 de Hm1 (proj1 Hde)) as (m2 & M2 & N1 & N2), (two_least m2 eps M2 (proj1 Heps)) as (m3 & M3 &
    N3 & N4).
  destruct (two_least muT (Rabs (z tG) * m3) HmT ltac:(here; apply Rmult_lt_0_compat; assumption)) as (mu0 & Hmu0 & N5 &
    N6). exists mu0; split; [exact Hmu0|]; intros n N e s mu Hn HN Hs Hmu.
  assert (Sm : 0 < Rabs mu < m3) by (apply (small_mu (z tG) e); [exact Hr | lra]).
  assert (Hn' : forall i, (1 <= n i <= n_max)%nat) by (intros i; apply Hn). assert (HW : word n_max n N) by (split;
    assumption).
  assert (Hg' : sgn s * ((1 + tau) * cg * gamma) > 0).
  { replace (sgn s * ((1 + tau) * cg * gamma)) with ((1 + tau) * cg * (sgn s * gamma)) by ring; apply Rmult_lt_0_compat;
      [apply Rmult_lt_0_compat|]; lra. }
  assert (Hnext : forall j : Z, (j + 1 - 1 = j /\ j - 1 + 1 = j)%Z) by (intros; lia).
  destruct (W Z (fun i => i + 1)%Z (fun i => i - 1)%Z n e s mu Hnext Hn Hg' ltac:(here; lra)) as [Hex Hno].
  assert (Closer : forall r r' x, r <= r' -> orbit_near map Z (fun i => i + 1)%Z n mu r x -> orbit_near map Z (fun i =>
    i + 1)%Z n mu r' x).
  { intros r r' x Hrr H1 i; destruct (H1 i) as [P' Q]; split; [|exact Q]; intros k Hk; specialize (P' k Hk); lra. }
  (* what a motion gives *)
  assert (Rd : forall r, r <= d -> Km * r <= dd) by (intros r Hrd; apply Rle_trans with (2 := Md), Rmult_le_compat_l;
    lra).
  assert (Orb : forall r t y v, motion mu r N t y v -> eps <= r <= d -> exists x yy, facts dd mu n x yy /\ Trace mu n N
    x t y v /\ orbit_near map Z (fun i => i + 1)%Z n mu dT x).
  { intros r t y v HM Hrd; destruct (Hmotion n_max dd mu n N Dm r t y v HW HS HG ltac:(here; lra) (Rd r (proj2 Hrd))
      ltac:(here; lra) HM) as (x & yy & F & Lg).
    exists x, yy; split; [exact F | split; [exact Lg|]]; apply (Closer dd); [lra|].
    apply (facts_orbit n_max dd mu n Hn' ltac:(here; lra) (proj1 Hdd) S1 S2 S4 x yy F). }
  split.
  - intros Hall; destruct Hex as (x & Hx & Only); [intros i; exact (conj (proj2 (proj1 (Hall i))) (proj2 (Hall i)))|].
    assert (Hx2 : forall i, within 2 (de / 2) (x i)) by (intros i; exact (Near Z (fun i => i + 1)%Z (fun i => i - 1)%Z n
      mu x Hnext Hn ltac:(here; lra) Hx i)).
    assert (Hxe : orbit_near map Z (fun i => i + 1)%Z n mu de x).
    { intros i; split; [intros q Hq; specialize (Hx2 i q Hq); lra | apply (Hx i)]. }
    destruct (orbit_facts n_max de mu n Hn' ltac:(here; lra) (proj1 Hde) E1 E2 E4 x Hxe) as (yy & F). assert (HM :
      motion mu eps N (at_ mu n x yy P sg N) (Pl mu n N x) (Vl mu n N x)) by (intros i j ->; apply (Hleg n_max de mu n N
      eps x yy i HW HSe HGe ltac:(here; lra) (F _) (F _))).
    destruct (proj2 (Only x Hx)) as (low0 & Hlow & Cl).
    destruct (Leave Z (fun i => i + 1)%Z n mu x low0 Hn ltac:(here; lra) (Closer de dL x ltac:(here; lra) Hxe) Hlow Cl)
      as [_ Lv].
    eexists; eexists; eexists; split; [exact HM|]; split; [exact (motion_left n_max de mu n N eps x yy HW HSe HGe
      ltac:(here; lra) F Hx2 Lv)|]; intros t' y' v' HM'.
    destruct (Orb eps _ _ _ HM ltac:(here; lra)) as (x1 & yy1 & F1 & Lg1 & O1), (Orb eps _ _ _ HM' ltac:(here; lra)) as
      (x2 & yy2 & F2 & Lg2 & O2).
    apply (Hsame n_max dd mu n N Dm eps x1 yy1 x2 yy2 _ _ _ _ _ _ HW HS HG ltac:(here; lra) (Rd eps ltac:(here; lra))
      ltac:(here; lra) HM HM' F1 F2 Lg1 Lg2). intros j i Hi; rewrite (proj1 (Only x1 O1) j i Hi), (proj1 (Only x2 O2) j
      i Hi); reflexivity.
  - intros [i Hi] t y v HM; destruct (Orb d _ _ _ HM ltac:(here; lra)) as (x & yy & F & Lg & O); exact (Hno i Hi x O).
Qed.
End Words.
