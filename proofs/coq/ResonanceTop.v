(** * A stop of one top, risen to the height nu: where it is 0, and how steep it is there *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOscillator StatementResonance Derivatives OscillatorStop ResonanceHop.
Open Scope R_scope.

Section Top.
Variable O : Oscillator.t.
Hypothesis HO : touching O.
Notation G := (Oscillator.G O).
Notation G1 := (Oscillator.G1 O).
Notation G2 := (Oscillator.G2 O).

Lemma is_any_stop : any_stop O. Proof. destruct HO; constructor; assumption. Qed.

(** Near its tops, within r, the stop is bent by at least a; elsewhere it is below - g. Where it is 0, it is
    within d of a top, and its slope is at most e. *)
Record shaped (a r g d e nu : R) : Prop := {
  shaped_before : forall t, stop O nu t < 0;
  shaped_away : forall t, r <= Rabs t <= PI -> stop O (- nu) t <= - g;
  shaped_bent : forall t, Rabs t <= r -> a <= G2 (- nu) t;
  shaped_top : forall t, Rabs t <= r -> stop O (- nu) t <= 2 * nu;
  shaped_zero : forall t, Rabs t <= PI -> stop O (- nu) t = 0 -> Rabs t <= d /\ Rabs (stop1 O (- nu) t) <= e }.

Theorem shapes : exists a r0, 0 < a /\ 0 < r0 <= 1 /\ forall r, 0 < r <= r0 -> exists g, 0 < g /\
  forall d e, 0 < d <= r -> 0 < e -> exists mu0, 0 < mu0 /\ forall nu, 0 < nu < mu0 -> shaped a r g d e nu.
Proof.
  pose proof PI2_3_2 as HP; destruct (curved O HO) as (r1 & Hr1 & Cv), (steady_with O HO) as (K & HK & St).
  pose proof (g_pos O HO) as Pg; set (g2 := G2 0 0) in *.
  destruct (two_least r1 (/ (K + 1)) ltac:(lra) ltac:(apply Rinv_0_lt_compat; lra)) as (r0 & Hr0 & L1 & L2).
  exists (g2 / 4), r0; split; [lra|]; split; [lra|]; intros r Hr; destruct (low O HO r ltac:(lra)) as (g & Hg & Low).
  exists (g / 2); split; [lra|]; intros d' e Hd' He.
  destruct (continuous_near (G1 0) 0 (e / 2) (D_continuous _ _ _ (bend _ HO 0 0)) ltac:(lra)) as (d1 & Hd1 & C).
  destruct (two_least d' d1 ltac:(lra) Hd1) as (d & Hd & L3 & L4), (low O HO d ltac:(lra)) as (gd & Hgd & Lowd).
  set (X := K + 1); assert (HX : 1 <= X) by (unfold X; lra).
  destruct (two_least (g / 2) (gd / 2) ltac:(lra) ltac:(lra)) as (b1 & B1 & M1 & M2).
  destruct (two_least (g2 / 4) (e / 2) ltac:(lra) ltac:(lra)) as (b2 & B2 & M3 & M4), (two_least b1 b2 B1 B2)
    as (b & B & M5 & M6).
  destruct (two_least 1 (b / X) ltac:(lra) ltac:(apply Rdiv_lt_0_compat; lra)) as (mu0 & M0 & M7 & M8).
  exists mu0; split; [exact M0|]; intros nu Hnu; assert (Xn : K * nu + nu < b).
  { replace (K * nu + nu) with (X * nu) by (unfold X; ring); apply (Rlt_le_trans _ (X * (b / X))).
    - apply Rmult_lt_compat_l; lra.
    - right; field; lra. } assert (0 <= K * nu) by (apply Rmult_le_pos; lra).
  assert (An : forall s, s = nu \/ s = - nu -> Rabs s = nu).
  { intros s [->| ->]; rewrite ?Rabs_Ropp; apply Rabs_pos_eq; lra. }
  assert (St' : forall s t, s = nu \/ s = - nu -> Rabs (G s t - G 0 t) <= K * nu /\
    Rabs (G1 s t - G1 0 t) <= K * nu /\ Rabs (G2 s t - G2 0 t) <= K * nu).
  { intros s t Hs; pose proof (An s Hs) as E; specialize (St s t ltac:(lra)); rewrite E in St; exact St. }
  assert (Kr : K * nu * r <= nu).
  { replace (K * nu * r) with (nu * (K * r)) by ring; rewrite <- (Rmult_1_r nu) at 2; apply Rmult_le_compat_l; [lra|].
    apply (Rle_trans _ (X * / X)); [|right; apply Rinv_r; lra]; unfold X; apply Rmult_le_compat; lra. }
  assert (Top : forall s t, s = nu \/ s = - nu -> Rabs t <= r -> - nu < G s t \/ s = - nu /\ - nu <= G s t).
  { intros s t Hs Ht; pose proof (steady_near O HO K s t) as N; rewrite (An s Hs) in N.
    specialize (N (fun t => proj1 (proj2 (St' s t Hs)))); pose proof (G_low O HO t ltac:(lra)).
    assert (K * nu * Rabs t <= K * nu * r) by (apply Rmult_le_compat_l; lra); apply le_abs in N.
    destruct (Req_dec t 0) as [->|Nt]; [rewrite (touch _ HO); left; lra|].
    destruct (Req_dec s nu) as [E|E]; [left|right; split; [tauto | lra]].
    assert (0 < G 0 t); [|lra]; apply le_abs in Ht; destruct (Rtotal_order t 0) as [L|[L|L]]; [|contradiction|].
    - rewrite <- (period _ HO 0 t); apply (below _ HO); lra.
    - apply (below _ HO); lra. }
  assert (Far : forall s t, s = nu \/ s = - nu -> r <= Rabs t <= PI -> g / 2 + nu <= G s t).
  { intros s t Hs Ht; destruct (St' s t Hs) as (A & _); apply le_abs in A; specialize (Low t Ht); lra. }
  constructor.
  - intros t; destruct (nearest t) as [z Hz]; set (x := t - 2 * PI * IZR z) in *.
    destruct (stop_later O nu is_any_stop z x) as [E _]; replace (x + _) with t in E by (unfold x; ring); rewrite E.
    unfold stop; destruct (Rle_lt_dec r (Rabs x)) as [L|L].
    + specialize (Far nu x (or_introl eq_refl) ltac:(lra)); lra.
    + destruct (Top nu x (or_introl eq_refl) ltac:(lra)) as [A|[A _]]; lra.
  - intros t Ht; specialize (Far (- nu) t (or_intror eq_refl) Ht); unfold stop; lra.
  - intros t Ht; destruct (St' (- nu) t (or_intror eq_refl)) as (_ & _ & A); apply le_abs in A.
    specialize (Cv t ltac:(lra)); lra.
  - intros t Ht; destruct (Top (- nu) t (or_intror eq_refl) Ht) as [A|[_ A]]; unfold stop; lra.
  - intros t Ht Z; destruct (St' (- nu) t (or_intror eq_refl)) as (A & A1 & _); apply le_abs in A.
    unfold stop in Z; destruct (Rle_lt_dec d (Rabs t)) as [L|L]; [specialize (Lowd t (conj L Ht)); lra|].
    split; [lra|]; specialize (C t ltac:(rewrite Rminus_0_r; lra)); rewrite (G1_0 O HO), Rminus_0_r in C.
    unfold stop1; rewrite Rabs_Ropp; apply from in A1; lra.
Qed.

Section Shaped.
Variables (a r g d e nu : R).
Hypothesis Ha : 0 < a.
Hypothesis Hr : 0 < d <= r.
Hypothesis Hg : 0 < g.
Hypothesis Hnu : 0 < nu.
Hypothesis HS : shaped a r g d e nu.
Notation Q := (stop O (- nu)).
Notation Q1 := (stop1 O (- nu)).

Lemma D_stop t : derivable_pt_lim Q t (Q1 t).
Proof. unfold stop, stop1; derive_by ltac:(apply (slope _ HO)); ring. Qed.
Lemma stop_0 : Q 0 = nu. Proof. unfold stop; rewrite (touch _ HO); ring. Qed.
Lemma falls t t' : - r <= t -> t < t' -> t' <= r -> Q1 t' < Q1 t.
Proof.
  intros L1 L2 L3; destruct (MVT_cor2 (G1 (- nu)) (G2 (- nu)) t t' L2 (fun x _ => bend _ HO _ x)) as (x & E & Hx).
  pose proof (shaped_bent _ _ _ _ _ _ HS x ltac:(apply Rabs_le; lra)).
  assert (0 < G2 (- nu) x * (t' - t)) by (apply Rmult_lt_0_compat; lra); unfold stop1; lra.
Qed.
(** Its zeros: it rises through 0 before the top and falls after it. *)
Lemma zero_is t : Rabs t <= PI -> Q t = 0 ->
  - d <= t <= d /\ (t < 0 /\ nu <= Q1 t * - t /\ Q1 t <= e \/ 0 < t /\ Q1 t < 0).
Proof.
  intros Ht Z; destruct (shaped_zero _ _ _ _ _ _ HS t Ht Z) as [D E]; apply le_abs in D, E; split; [exact D|].
  pose proof stop_0 as T; destruct (Rtotal_order t 0) as [L|[->|L]]; [left|lra|right]; split; trivial.
  - destruct (MVT_cor2 Q Q1 t 0 L (fun x _ => D_stop x)) as (x & F & Hx); pose proof (falls t x ltac:(lra) ltac:(lra)
      ltac:(lra)) as P. assert (Q1 x * - t < Q1 t * - t) by (apply Rmult_lt_compat_r; lra); lra.
  - destruct (MVT_cor2 Q Q1 0 t L (fun x _ => D_stop x)) as (x & F & Hx); pose proof (falls x t ltac:(lra) ltac:(lra)
      ltac:(lra)) as P.
    assert (Q1 x < 0); [|lra]; apply Rnot_le_lt; intros N; assert (0 <= Q1 x * (t - 0)) by (apply Rmult_le_pos;
      lra); lra.
Qed.
Lemma rising_unique t t' : Rabs t <= PI -> Rabs t' <= PI -> Q t = 0 -> Q t' = 0 -> 0 < Q1 t -> 0 < Q1 t' -> t = t'.
Proof.
  assert (L : forall t t', Rabs t <= PI -> Rabs t' <= PI -> Q t = 0 -> Q t' = 0 -> 0 < Q1 t' -> ~ t < t').
  { clear t t'; intros t t' Ht Ht' Z Z' P L; destruct (zero_is t Ht Z) as [D _], (zero_is t' Ht' Z') as [D' _].
    destruct (MVT_cor2 Q Q1 t t' L (fun x _ => D_stop x)) as (x & F & Hx).
    pose proof (falls x t' ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (0 < Q1 x * (t' - t)) by (apply Rmult_lt_0_compat; lra); lra. }
  intros Ht Ht' Z Z' P P'; pose proof (L t t' Ht Ht' Z Z' P'); pose proof (L t' t Ht' Ht Z' Z P); lra.
Qed.
Lemma rising_exists : r <= PI -> exists t, - d <= t < 0 /\ Q t = 0.
Proof.
  intros Hp; destruct (IVT Q (- r) 0) as (t & It & Z).
  - intros x; exact (D_continuous _ _ _ (D_stop x)).
  - lra.
  - pose proof (shaped_away _ _ _ _ _ _ HS (- r)) as A; rewrite Rabs_Ropp, Rabs_pos_eq in A by lra.
    specialize (A ltac:(lra)); lra.
  - rewrite stop_0; exact Hnu.
  - exists t; split; [|exact Z]; destruct (zero_is t ltac:(apply Rabs_le; lra) Z) as [D [C|C]]; lra.
Qed.
End Shaped.
End Top.
