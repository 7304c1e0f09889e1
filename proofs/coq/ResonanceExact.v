(** * The motions with one impact in n periods: they are the hops that come again *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOscillator StatementResonance Derivatives Flow AppendixA ResonanceHop.
Open Scope R_scope.

Lemma half_turns m x : sin (INR m * PI + x) = (-1) ^ m * sin x /\ cos (INR m * PI + x) = (-1) ^ m * cos x.
Proof.
  revert x; induction m as [|m IH]; intros x; [cbn; rewrite Rmult_0_l, Rplus_0_l; lra|].
  rewrite S_INR; replace ((INR m + 1) * PI + x) with (INR m * PI + (x + PI)) by ring.
  destruct (IH (x + PI)) as [-> ->]; rewrite neg_sin, neg_cos; cbn [pow]; split; ring.
Qed.

Section Exact.
Variables (O : Oscillator.t) (n m : nat).
Hypothesis HO : any_stop O.
Hypothesis HR : resonant O n m.
Notation c := (Oscillator.c O).
Notation k := (Oscillator.k O).
Notation tau := (Oscillator.tau O).
Notation om := (omega O).
Notation q := (q O n m).
Notation T := (2 * PI * INR n).
Notation N := (fun i => Z.of_nat n * i)%Z.

(** The flow. *)
Definition S : R -> R := damped_S c (fun t => / om * sin (om * t)).
Definition V : R -> R := damped_V c (fun t => / om * sin (om * t)) (fun t => cos (om * t)).
Lemma omega_pos : 0 < om.
Proof. apply sqrt_lt_R0; pose proof (res_oscillates _ _ _ HR); lra. Qed.
Lemma is_flow : flow c k S V.
Proof.
  pose proof omega_pos as P; pose proof (damped c _ _ _ (undamped_circular om ltac:(lra))) as F.
  replace (c * c / 4 + om * om) with k in F; [exact F|].
  unfold omega; rewrite sqrt_sqrt; [field | pose proof (res_oscillates _ _ _ HR); lra].
Qed.
Lemma flow_turned x : S (T + x) = q * S x /\ V (T + x) = q * V x.
Proof.
  assert (E : exp (- c / 2 * (T + x)) = exp (- PI * c * INR n) * exp (- c / 2 * x)) by (rewrite <- exp_plus; f_equal;
    field). assert (A : om * (T + x) = INR m * PI + om * x) by (rewrite <- (res_angle _ _ _ HR); ring).
  unfold S, V, damped_S, damped_V, StatementResonance.q; rewrite E, A; destruct (half_turns m (om * x)) as [-> ->].
  split; ring.
Qed.
Lemma S_is w x : S x * w = arc O w x.
Proof. pose proof omega_pos; unfold S, damped_S, arc; field; lra. Qed.
Lemma q_range : -1 <= q <= 1 /\ q <> 0.
Proof.
  assert (E : 0 < exp (- PI * c * INR n) <= 1).
  { split; [apply exp_pos|]; rewrite <- exp_0; pose proof PI_RGT_0; pose proof (pos_INR n).
    assert (X : - PI * c * INR n <= 0) by (pose proof (proj1 (res_oscillates _ _ _ HR)); assert (0 <= PI * c * INR n)
      by (apply Rmult_le_pos; nra); lra).
    destruct X as [X| ->]; [left; apply exp_increasing, X | right; reflexivity]. }
  unfold StatementResonance.q; destruct (sign_pow m) as [-> | ->]; split; lra.
Qed.
Lemma tau_q : regular O n m -> q < 1 /\ -1 < tau * q < 1.
Proof.
  intros [N1 N2]; pose proof q_range as [B _]; pose proof (res_law _ _ _ HR) as L.
  assert (-1 <= tau * q <= tau) by nra; split; [lra|]; split; [lra|].
  destruct (Req_dec (tau * q) 1) as [E|E]; [|lra]; exfalso; apply N1; nra.
Qed.

Section At.
Variable mu : R.
Notation Q := (stop O mu).
Notation Q1 := (stop1 O mu).
Notation hops := (hop c k S V Q Q1 T tau).
Let HS := is_flow.
Let HT := period_pos O n m HR.
Let HQ : forall x, Q (x + T) = Q x := fun x => proj1 (turn_1 O n mu HO x).

Lemma once_hop d t y v : once O n mu d t y v -> let s := t 0%Z in let w := v 0%Z s in
  hops s w s w /\ Rabs s <= d /\
  forall i x, y i (t i + x) = place c S V Q s w x /\ v i (t i + x) = velocity k S V Q s w x.
Proof.
  intros [Hm Ha] s w; destruct (swing_hop O n S V mu HO HS d t y v 0 (Hm 0%Z _ eq_refl)) as (H & D & E).
  change (0 + 1)%Z with 1%Z in H; rewrite Rmult_0_r, Rminus_0_r in H, D, E; fold s w in H, D, E.
  destruct (Ha 1%Z s) as (E1 & _ & F1); cbv zeta in *; rewrite Rmult_1_r in *; fold s in E1.
  rewrite E1, F1 in H; fold w in H; replace (s + T - T) with s in H by ring.
  split; [exact H|]; split; [exact D|]; intros i x; destruct (Ha i (s + x)) as (E2 & F2 & G2); cbv zeta in *.
  rewrite E2; fold s; replace (s + _ + x) with (s + x + T * IZR i) by ring; rewrite F2, G2; apply E.
Qed.
Lemma hop_once d s w : hops s w s w -> Rabs s <= d ->
  exists t y v, once O n mu d t y v /\ t 0%Z = s /\ v 0%Z s = w.
Proof.
  intros H D; set (s' := fun _ : Z => s); set (w' := fun _ : Z => w); exists (times n s'), (flights O n S V mu s' w'),
    (speeds O n S V mu s' w').
  assert (E0 : times n s' 0 = s) by (unfold times, s'; ring); split; [split|split; [exact E0|]].
  - intros i j ->; apply (hop_swing O n S V mu HO HS); assumption.
  - intros i x; cbv zeta; unfold flights, speeds, moved, moving, times, s'.
    assert (E : x + T * IZR i - (s + T * IZR i) = x - (s + T * 0)) by ring; rewrite E; repeat split; ring.
  - rewrite <- E0, <- (Rplus_0_r (times n s' 0)), (proj2 (flight_is O n S V mu s' w' 0 0)).
    apply (place_0 c k S V HS).
Qed.

Theorem exact_at d : exact O n m mu d.
Proof.
  pose proof (res_law _ _ _ HR) as L; pose proof q_range as [B N0]; pose proof flow_turned as Hq. constructor.
  - intros [N1 N2] t0; pose proof (hop_again c k S V HS Q Q1 T q tau HT Hq t0 (after O n m mu t0) L B N1 N2) as I;
    split.
    + intros (t & y & v & H & <-); destruct (once_hop d t y v H) as (A & D & _).
      destruct (proj1 (hop_again c k S V HS Q Q1 T q tau HT Hq _ _ L B N1 N2) A) as (Z & P & W & C).
      repeat split; trivial; intros s Hs; rewrite <- S_is; unfold after; rewrite <- W; apply C, Hs.
    + intros (D & Z & P & C); destruct (hop_once d t0 (after O n m mu t0)) as (t & y & v & H & E & _); [|exact D|].
      * apply I; repeat split; trivial; intros x Hx; rewrite S_is; apply C, Hx.
      * exists t, y, v; auto.
  - intros [N1 N2] t y v H i; destruct (once_hop d t y v H) as (A & D & E); cbv zeta in *.
    destruct (proj1 (hop_again c k S V HS Q Q1 T q tau HT Hq _ _ L B N1 N2) A) as (Z & P & W & C).
    set (t0 := t 0%Z) in *; set (w := v 0%Z t0) in *; split.
    + rewrite (speed_is O mu HO); destruct (once_again _ _ _ _ _ _ _ H (i + 1) 0) as (-> & _).
      destruct (once_again _ _ _ _ _ _ _ H i 0) as (Ti & _); cbv zeta in *; fold t0 in Ti |- *.
      rewrite (proj2 (turns O n mu HO _ _)); replace (t0 + T * IZR (i + 1)) with (t i + (T + 0)) by
        (rewrite Ti, plus_IZR; ring).
      rewrite (proj2 (E i _)), (velocity_later k S V Q T q Hq), (proj2 (place_0 c k S V HS Q t0 w)), W.
      field; pose proof (tau_q (conj N1 N2)); lra.
    + intros s; rewrite (proj1 (E i s)); unfold place; rewrite Z, <- S_is; unfold after; rewrite <- W; ring.
  - intros E t y v H; destruct (once_hop d t y v H) as (A & _).
    revert A; apply (hop_even c k S V HS Q Q1 T q tau Hq); trivial; lra.
  - intros E t y v H; destruct (once_hop d t y v H) as (A & _).
    apply (hop_odd c k S V HS Q Q1 T q tau Hq (t 0%Z) (v 0%Z (t 0%Z))); trivial; nra.
Qed.
End At.
End Exact.

Theorem Exact : Exact_statement.
Proof. intros O n m mu d HO HR; apply exact_at; assumption. Qed.
