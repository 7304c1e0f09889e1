(** * The motion of an orbit that others leave is left by their motions *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import StatementOrbits StatementUnstable OrbitVectors OrbitsNear OrbitsUnstable Derivatives.
From Grazing Require Import NonlinearGronwall NonlinearFlow NonlinearTouch NonlinearSpeed NonlinearKick NonlinearMap.
From Grazing Require Import NonlinearMotions.
Open Scope R_scope.
Section Unstable.
Context {the_force : force} {the_touch : touch the_force} {the_window : near the_touch} {the_impact : impact the_touch}.
Let HT := HT. Let HL := HL. Let HtG := HtG. Let Hg := Hg. Let Hd0 := Hd0.
Variables (n_max : nat) (dd mu : R) (n : Z -> nat) (N : Z -> Z).
Notation far := (far n_max).
Hypothesis Hn : forall i, (1 <= n i <= n_max)%nat.
Hypothesis HN : forall i, (N (i + 1) = N i + Z.of_nat (n i))%Z.
Hypothesis Hmu : Rabs mu <= dd.
Hypothesis S0 : 0 < dd.
Hypothesis S1 : far * dd <= d0.
Hypothesis S2 : 32 * (far * dd) < 3 * g * (r0 * r0).
Hypothesis S3 : forall t, 0 <= t <= T -> r0 <= Rabs (t - tG) -> far * dd < y0 t.
Hypothesis S4 : 16 * (far * dd) <= 3 * g * r0.
Variable D : R.
Hypothesis S5 : 8 * (far * dd) <= 3 * g * (D * D).
Hypothesis S6 : far * dd <= D /\ D <= r0 / 4.
Notation fl := (fl mu).
Notation flown := (flown dd mu n).
Notation hit := (hit mu n).

Lemma fl_lip k x x' e : within 2 e (minus x x') -> within 2 (M ^ k * e) (minus (fl k x) (fl k x')).
Proof.
  intros H; assert (He : 0 <= e) by (eapply Rle_trans; [apply Rabs_pos | apply (H 0%nat); lia]); induction k as [|k IH];
    [intros i Hi; specialize (H i Hi); cbn in *; lra|]. pose proof M_large as LM; assert (0 <= M ^ k * e) by (apply
    Rmult_le_pos; [apply pow_le; lra | exact He]).
  destruct (nearby _ _ mu mu _ T IH ltac:(here; rewrite Rminus_eq_0, Rabs_R0; lra) ltac:(here; lra)) as [A A'].
  change (fl (S k) x) with (f (fl k x) mu); change (fl (S k) x') with (f (fl k x') mu); cbn [pow]; rewrite Rmult_assoc.
  intros i Hi; unfold minus, f; destruct i as [|[|i]]; [| |lia]; match goal with |- Rabs ?u <= _ => match goal with A :
    Rabs ?v <= _ |- _ => replace u with v by ring; exact A end end.
Qed.

(** Time of an impact and velocity after it depend continuously on the flight, and determine the point. *)
Notation facts := (hit_facts n_max dd mu n Hn Hmu S0 S1 S2 S4 D S5 S6).
Lemma in_box x : within 2 dd x -> box x mu.
Proof.
  intros H; destruct (far_large n_max dd S0 0 ltac:(lia)) as (_ & P & _); cbn in P; split; [intros i Hi; specialize (H i
    Hi)|]; lra.
Qed.
Lemma after_near : exists Q, 0 < Q /\ forall x x' yy yy' p e, flown x yy p -> flown x' yy' p -> within 2 dd (x (p +
  1)%Z)
  -> within 2 e (minus (x' p) (x p)) -> Rabs (yy' p - yy p) <= e -> within 2 e (minus (x' (p + 1)%Z) (x (p + 1)%Z)) ->
  let c := hit x yy p in let c' := hit x' yy' p in Rabs (c' - c) <= Q * e /\
  Rabs (V (x' (p + 1)%Z) mu c' - V (x (p + 1)%Z) mu c) <= Q * e.
Proof.
  destruct tc_lip as (C & HC & Lip); pose proof M_large as LM; pose proof (pow_R1_Rle M n_max LM) as P1.
  assert (P2 : 1 <= C * M ^ n_max) by (rewrite <- (Rmult_1_l 1); apply Rmult_le_compat; lra).
  set (R := C * M ^ n_max) in *; assert (PR : 0 <= g * R) by (apply Rmult_le_pos; lra).
  exists (R + M + 5 / 4 * g * R); split; [lra|]; intros x x' yy yy' p e F F' Bx H Hy H1 c c'.
  destruct (facts x yy p (p + 1)%Z F eq_refl) as (B & Cw & Ci & _), (facts x' yy' p (p + 1)%Z F' eq_refl) as (B' & Cw' &
    Ci' & _); fold c in Cw, Ci; fold c' in Cw', Ci'.
  assert (He : 0 <= e) by (eapply Rle_trans; [apply Rabs_pos | exact Hy]).
  assert (Yb : forall x yy, flown x yy p -> ybox (yy p)) by (intros u yu [Ox Oy Oh _ _]; apply (low_y n_max dd mu Hmu S0
    S1 S2 S4 (n p) (u p)); [exact Ox | apply Hn | left; exact Oy | exact Oh]).
  assert (Pk : 1 <= M ^ n p /\ M ^ n p <= M ^ n_max) by (split; [apply pow_R1_Rle, LM | apply Rle_pow; [exact LM | apply
    Hn]]). assert (E1 : 1 * e <= M ^ n p * e /\ M ^ n p * e <= M ^ n_max * e) by (split; apply Rmult_le_compat_r; lra).
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
  destruct (facts x yy p (p + 1)%Z F eq_refl) as (_ & Cw & _ & _ & _ & E & _), (facts x' yy' p (p + 1)%Z F' eq_refl) as
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

Lemma iter_Z p k : Nat.iter k (fun j => j + 1)%Z p = (p + Z.of_nat k)%Z.
Proof.
  induction k as [|k IH]; [cbn; lia|]; change ((Nat.iter k (fun j => j + 1) p + 1)%Z = (p + Z.of_nat (Datatypes.S
    k))%Z).
  rewrite IH; lia.
Qed.

Theorem motion_left x yy : (forall j, flown x yy j) -> (forall j, within 2 (dd / 2) (x j)) ->
  leaving map Z (fun j => j + 1)%Z n mu x -> unstable_motion (leg_is mu D N) (at_ mu n N x yy) (legv mu N x).
Proof.
  intros F Hx Lv; destruct (Lv (dd / 2) ltac:(lra)) as (r & Hr & Leave); destruct after_near as (Q1 & P1 & Near),
    after_far as (Q2 & P2 & Far). exists (r / (Q2 + 1)); split; [apply Rdiv_lt_0_compat; lra|]; intros j eps He; set (p
    := (j - 1)%Z).
  destruct (two_least r (eps / Q1) ltac:(here; lra) ltac:(here; apply Rdiv_lt_0_compat; lra)) as (e & E0 & E1 & E2).
  apply (Rmult_le_compat_l Q1) in E2; [|lra]; replace (Q1 * (eps / Q1)) with eps in E2 by (field; lra).
  destruct (Leave p e E0) as (z & l & Z0 & Y0 & Z1 & Fly & Out).
  set (x' := fun i => z (Z.to_nat (i - p))); set (yy' := fun i => speed_at map mu (n i) (x' i)).
  assert (Ex : forall k, x' (p + Z.of_nat k)%Z = z k) by (intros k; unfold x'; f_equal; lia).
  assert (L2 : (2 <= l)%nat).
  { destruct l as [|[|l]]; [exfalso; apply Out; intros i Hi; exact (Rle_trans _ _ _ (Z0 i Hi) E1) | | lia].
    exfalso; apply Out; intros i Hi; exact (Rle_trans _ _ _ (Z1 i Hi) E1). }
  assert (F' : forall k, (k < l)%nat -> flown x' yy' (p + Z.of_nat k)%Z).
  { intros k Hk; destruct (Fly k Hk) as (In & Hit & Free & Next); rewrite iter_Z in In, Hit, Free, Next; set (i := (p +
      Z.of_nat k)%Z) in *; assert (Ei : x' i = z k) by apply Ex.
    assert (Ox : within 2 dd (x' i)) by (rewrite Ei; intros q Hq; specialize (In q Hq); pose proof (Hx i q Hq) as X;
      unfold minus in In; replace (z k q) with ((z k q - x i q) + x i q) by ring; eapply Rle_trans; [apply
      Rabs_triang|]; lra).
    assert (Py : 0 < yy' i) by (unfold yy', speed_at; rewrite Ei; apply sqrt_lt_R0; cbn in Hit |- *; lra).
    assert (Oh : Y (fl (n i) (x' i)) mu (low (fl (n i) (x' i)) mu) = - (yy' i * yy' i)).
    { unfold yy', speed_at; rewrite sqrt_sqrt, Ei by (rewrite Ei; lra); rewrite Ropp_involutive; reflexivity. }
    constructor; [exact Ox | exact Py | exact Oh | |].
    - rewrite Ei; exact Free.
    - intros q Hq; assert (Bz := proj1 (fl_near n_max dd mu Hmu S0 S1 S4 (n i) (x' i) Ox ltac:(here; apply Hn))).
      assert (Yb : ybox (yy' i)) by (apply (low_y n_max dd mu Hmu S0 S1 S2 S4 (n i) (x' i)); [exact Ox | apply Hn | lra
        | exact Oh]).
      replace (i + 1)%Z with (p + Z.of_nat (Datatypes.S k))%Z by (unfold i; lia); rewrite Ex, Next by exact Hq; unfold
        go.
      rewrite <- Ei; fold (yy' i); change (OrbitRemainder.fly map mu (n i) (x' i)) with (fl (n i) (x' i)).
      change (Map.kick map) with kick; rewrite kick_y by assumption; ring. }
  set (l' := (p + Z.of_nat l)%Z); exists l', (at_ mu n N x' yy'), (leg mu N x'), (legv mu N x').
  assert (Wx : forall i, within 2 dd (x i)) by (intros i; apply F).
  assert (Diff : forall i, at_ mu n N x' yy' i - at_ mu n N x yy i = hit x' yy' (i - 1) - hit x yy (i - 1)) by (intros
    i; unfold at_; ring).
  assert (Vel : forall u yu i, legv mu N u i (at_ mu n N u yu i) = V (u i) mu (hit u yu (i - 1))) by (intros u yu i;
    unfold legv, at_; f_equal; ring).
  split; [unfold l', p; lia | split; [|split]].
  - intros i Hi; apply (orbit_leg n_max dd mu n N Hn HN Hmu S0 S1 S2 S3 S4 D S5 S6 x' yy' i).
    + replace (i - 1)%Z with (p + Z.of_nat (Z.to_nat (i - 1 - p)))%Z by (unfold p; lia); apply F'; unfold l', p in *;
      lia.
    + replace i with (p + Z.of_nat (Z.to_nat (i - p)))%Z by (unfold p; lia); apply F'; unfold l', p in *; lia.
  - pose proof (F' 0%nat ltac:(lia)) as F0; cbn [Z.of_nat] in F0; rewrite Z.add_0_r in F0.
    assert (E0' : x' p = z 0%nat) by (rewrite <- (Z.add_0_r p); apply (Ex 0%nat)).
    destruct (Near x x' yy yy' p e (F p) F0 (Wx _)) as [A B].
    + rewrite E0'; exact Z0.
    + replace (yy p) with (speed_at map mu (n p) (x p)); [unfold yy'; rewrite E0'; exact Y0|].
      unfold speed_at; change (Map.h map (OrbitRemainder.fly map mu (n p) (x p)) mu) with (Y (fl (n p) (x p)) mu (low
        (fl (n p) (x p)) mu)); rewrite (Oh _ _ _ _ _ _ (F p)), Ropp_involutive; apply sqrt_square; left; apply (Oy _ _ _
        _ _ _ (F p)).
    + rewrite (Ex 1%nat : x' (p + 1)%Z = _); exact Z1.
    + unfold StatementUnstable.near; rewrite Diff, !Vel; replace (p + 1)%Z with j in B by (unfold p; lia); fold p;
      split; lra.
  - intros [A B]; rewrite Diff in A; rewrite !Vel in B; apply Out; rewrite iter_Z; fold l'.
    assert (El : x' l' = z l) by apply Ex; rewrite <- El; set (i := (l' - 1)%Z) in *.
    assert (Ei : l' = (i + 1)%Z) by (unfold i; lia); rewrite Ei in B |- *.
    assert (Fi : flown x' yy' i) by (replace i with (p + Z.of_nat (l - 1))%Z by (unfold i, l'; lia); apply F'; lia).
    apply (within_le 2 (Q2 * (r / (Q2 + 1)))); [|apply (Far x x' yy yy' i); auto].
    apply (Rmult_le_reg_r (Q2 + 1)); [lra|]; replace (Q2 * (r / (Q2 + 1)) * (Q2 + 1)) with (Q2 * r) by (field; lra);
      lra.
Qed.
End Unstable.
