(** * Where the curve of orbits with one impact begins with the slope 0, its second order says on which side it is *)
From Coq Require Import Reals FunctionalExtensionality Lra Lia Ranalysis5.
From Grazing Require Import StatementOrbits StatementResonance StatementFold Derivatives Finite OrbitVectors.
From Grazing Require Import Contraction OrbitRemainder.
From Grazing Require Import Orbits ResonanceCurve ResonanceMaps.
Open Scope R_scope.

(** ** One radius for all coordinates *)
Definition bend (N : nat) (V : vec) (G : R -> R -> R -> vec -> R) (L : R -> R -> vec -> R) (p Q eps r : R) : Prop :=
  forall nu y mu x y' mu' x', Rabs nu <= r -> 0 <= y <= r -> 0 <= y' <= r -> beside N V r y mu x ->
  beside N V r y' mu' x' -> beside N V r (y - y') (mu - mu') (minus x x') ->
  Rabs (G nu y mu x - G nu y' mu' x' - L (y - y') (mu - mu') (minus x x') -
    (nu * p * (y - y') + Q * (y ^ 2 - y' ^ 2))) <= eps * ((Rabs nu + y + y') * Rabs (y - y')).
Lemma bend_down N V G L p Q eps r r' : bend N V G L p Q eps r -> 0 < r' <= r -> bend N V G L p Q eps r'.
Proof.
  intros B Hr; assert (Down : forall y mu x, beside N V r' y mu x -> beside N V r y mu x).
  { intros y mu x [A X]; assert (L' : r' * Rabs y <= r * Rabs y) by (apply Rmult_le_compat_r; [apply Rabs_pos | lra]).
    split; [lra | apply (within_le _ _ _ _ L' X)]. }
  intros nu y mu x y' mu' x' Hn Hy Hy' X X' XX; apply B; auto; lra.
Qed.
Lemma bends_as N V G L Q : bends N V G L Q -> bends_along N V (fun _ => G) L 0 Q.
Proof.
  intros B eps Heps; destruct (B eps Heps) as (r & Hr & H); exists r; split; [exact Hr|].
  intros nu y mu x y' mu' x' _ Hy Hy' X X' XX; rewrite Rmult_0_r, Rmult_0_l, Rplus_0_l.
  eapply Rle_trans; [apply H; assumption|]; apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_r; [apply Rabs_pos|].
  pose proof (Rabs_pos nu); lra.
Qed.
Lemma bend_all N V Gh Lh ph Qh (G : nat -> R -> R -> R -> vec -> R) L p Q : bends_along N V Gh Lh ph Qh -> (forall i, (i
  < N)%nat -> bends_along N V (G i) (L i) (p i) (Q i)) -> forall eps, 0 < eps -> exists r, 0 < r /\
  bend N V Gh Lh ph Qh eps r /\ forall i, (i < N)%nat -> bend N V (G i) (L i) (p i) (Q i) eps r.
Proof.
  intros Bh B eps Heps; destruct (Bh eps Heps) as (r1 & R1 & B1).
  destruct (common_bound (fun i r => bend N V (G i) (L i) (p i) (Q i) eps r) N) as (r2 & R2 & B2).
  - intros i r r' H Hr; exact (bend_down _ _ _ _ _ _ _ _ _ H Hr).
  - intros i Hi; destruct (B i Hi eps Heps) as (r & Hr & X); exists r; split; [exact Hr | exact X].
  - destruct (two_least r1 r2 R1 R2) as (r & Hr & L1 & L2); exists r; split; [exact Hr|]; split; [apply (bend_down _ _ _
      _ _ _ _ r1); [exact B1 | lra] | intros i Hi; apply (bend_down _ _ _ _ _ _ _ r2); [apply B2, Hi | lra]].
Qed.

(** ** Two solutions of a member of a family *)
Section Second.
Variables (M : Map.t) (w V T U : vec) (e : R) (n : nat) (ph Qh : R) (p Q : vec) (nu eps1 r0 : R).
Notation N := (Map.N M).
Notation pow k x := (Nat.iter k (mult N (Map.A M)) x).
Notation C := (dot N (Map.C M)).
Hypothesis Z0 : forall k, Map.h M (fly M 0 k zero) 0 = 0 /\ forall i, (i < N)%nat -> fly M 0 k zero i = 0.
Hypothesis Ne : e <> 0.
Hypothesis HV : forall i, (i < N)%nat -> V i = pow n V i + Map.B M i /\ T i = pow n T i + p i /\ U i = pow n U i + Q i.
Hypothesis V0 : across M V n = 0.
Notation S' := (- (ph + across M T n) / e).
Notation K := (- (1 + Qh + across M U n) / e).
Notation solves := (solves M w e n).
Notation point := (point w).
Notation left := (left M e n).
Hypothesis R0 : 0 < r0 /\ 0 < eps1.
Hypothesis Bend : forall y mu x y' mu' x', 0 <= y <= r0 -> 0 <= y' <= r0 -> beside N V r0 y mu x -> beside N V r0 y' mu'
  x' -> beside N V r0 (y - y') (mu - mu') (minus x x') -> let D p Q := nu * p * (y - y') + Q * (y ^ 2 - y' ^ 2) in
  let e' := eps1 * ((Rabs nu + y + y') * Rabs (y - y')) in let fl := fly M in
  Rabs (Map.h M (fl mu n x) mu - Map.h M (fl mu' n x') mu' - (across M (minus x x') n + (mu - mu') * (e - across M w n))
    - D ph Qh) <= e' /\ forall i, (i < N)%nat ->
  Rabs (fl mu n x i + Map.kick M (fl mu n x) y mu i * y - (fl mu' n x' i + Map.kick M (fl mu' n x') y' mu' i * y') -
    (pow n (minus x x') i + (y - y') * Map.B M i + (mu - mu') * (w i - pow n w i)) - D (p i) (Q i)) <= e'.
Variables (Ki W eps0 d d' beta : R).
Hypothesis HK : inverse_bound M e n Ki.
Hypothesis HW : 0 <= W /\ within N W w.
Hypothesis Hd : 0 < d.
Hypothesis He0 : 0 < eps0 /\ Ki * eps0 <= 1 / 2.
Hypothesis Hsm : small M w e n W eps0 d.
Hypothesis Hbeta : 0 <= beta /\ within N beta (Map.B M).
Notation P := (2 * Ki * beta + 2).
Hypothesis Hd' : 0 < d' <= d.
Hypothesis Sm : small M w e n W (r0 / (1 + W) / (P * Ki)) d'.
Let HV1 i (Hi : (i < N)%nat) := proj1 (HV i Hi).
Lemma cone a y m v x : 0 <= a -> Rabs m <= a * Rabs y -> within N (a * Rabs y) (fun i => v i - y * V i) ->
  (forall i, x i = v i + m * w i) -> beside N V ((1 + W) * a) y m x.
Proof.
  intros Ha Hm Hv Hx; pose proof (Rabs_pos y); assert (P0 : 0 <= a * Rabs y) by (apply Rmult_le_pos; lra).
  assert (P1 : 0 <= a * Rabs y * W) by (apply Rmult_le_pos; lra). split; [lra|]; intros i Hi; rewrite Hx.
  replace (v i + m * w i - y * V i) with ((v i - y * V i) + m * w i) by ring.
  replace ((1 + W) * a * Rabs y) with (a * Rabs y + a * Rabs y * W) by ring.
  apply triangle2; [apply Hv, Hi | apply Rabs_mult_le; [exact Hm | apply HW, Hi]].
Qed.
(** (0, V) to the first order, and nu (S, T) and (K, U) to the second. *)
Lemma second y y' z z' : 0 <= y <= r0 -> 0 <= y' <= r0 -> P * y <= d' -> P * y' <= d' ->
  within (S N) d z -> within (S N) d z' -> solves y z -> solves y' z' ->
  Rabs (z O - z' O - (nu * S' * (y - y') + K * (y ^ 2 - y' ^ 2))) <= Ki * eps1 * ((Rabs nu + y + y') * Rabs (y - y')).
Proof.
  intros Hy Hy' Hyd Hyd' Hz Hz' HS HS'; pose proof HK as (K1 & KB & _); set (a := r0 / (1 + W)).
  assert (Pa : 0 < a) by (apply Rdiv_lt_0_compat; lra); assert (Ea : (1 + W) * a = r0) by (unfold a; field; lra).
  assert (First : forall y y' z z', 0 <= y -> 0 <= y' -> P * y <= d' -> P * y' <= d' -> within (S N) d z -> within (S N)
    d z' -> solves y z -> solves y' z' -> Rabs (z O - z' O) <= a * Rabs (y - y') /\ within N (a * Rabs (y - y')) (fun i
    => (hat z i - hat z' i) - (y - y') * V i)).
  { intros s s' u u' X X' Xd Xd' Hu Hu' HSu HSu'; pose proof (first_order M w e n V Z0 Ne HV1 Ki W eps0 d beta HK Hd He0
      Hsm Hbeta a d' Pa Hd' Sm s s' u u' X X' Xd Xd' Hu Hu' HSu HSu') as F; apply within_S in F; destruct F as [B3 B4].
    split; [|exact B4]; unfold minus, line, rows in B3; change (C (pow n V)) with (across M V n) in B3; rewrite V0 in
      B3.
    replace (u O - u' O) with (u O - u' O - - (0 / e) * (s - s')) by (field; exact Ne); exact B3. }
  assert (Px : forall z i, point z i = hat z i + z O * w i) by (intros u i; unfold ResonanceCurve.point, comb; ring).
  assert (Cone : forall y z, 0 <= y -> P * y <= d' -> within (S N) d z -> solves y z -> beside N V r0 y (z O) (point
    z)).
  { intros t u Ht Htd Hu HSu; destruct (First t 0 u zero Ht ltac:(lra) Htd ltac:(lra) Hu ltac:(apply
    within_zero; lra) HSu (zero_solves M w e n Z0)) as [A B]; unfold zero in A; rewrite !Rminus_0_r in A.
    rewrite <- Ea; apply (cone a t (u O) (hat u)); [lra | exact A | | apply Px]; intros i Hi; specialize (B i Hi).
    unfold hat, zero in B; rewrite !Rminus_0_r in B; exact B. }
  assert (Diff : beside N V r0 (y - y') (z O - z' O) (minus (point z) (point z'))).
  { destruct (First y y' z z') as [A B]; trivial; try lra; rewrite <- Ea.
    apply (cone a (y - y') (z O - z' O) (fun i => hat z i - hat z' i)); [lra | exact A | exact B|].
    intros i; unfold minus; rewrite !Px; ring. }
  destruct (Bend y (z O) (point z) y' (z' O) (point z') Hy Hy' (Cone y z ltac:(lra) Hyd Hz HS) (Cone y'
    z' ltac:(lra) Hyd' Hz' HS') Diff) as [Bh Bi]; cbv zeta in Bh, Bi.
  apply (solves_is M w e n y z ltac:(lra)) in HS; apply (solves_is M w e n y' z' ltac:(lra)) in HS'.
  destruct HS as [Eh Ei], HS' as [Eh' Ei']; rewrite Eh, Eh' in Bh; set (D := y ^ 2 - y' ^ 2) in *.
  set (S2 := (Rabs nu + y + y') * Rabs (y - y')) in *; assert (PS : 0 <= S2) by (apply Rmult_le_pos; [pose proof
    (Rabs_pos nu); lra | apply Rabs_pos]).
  assert (Ep : minus (point z) (point z') = comb 1 (z O - z' O) (minus (hat z) (hat z')) w) by (extensionality i; unfold
    minus, comb; rewrite !Px; ring).
  assert (Pw : forall i, pow n (minus (point z) (point z')) i = pow n (hat z) i - pow n (hat z') i + (z O - z' O) * pow
    n w i) by (intros i; rewrite Ep, power_comb, power_minus; unfold comb, minus; ring).
  set (u := comb 1 (-1) (minus z z') (comb (y - y') 1 (rows 0 V) (comb (nu * (y - y')) D (rows S' T) (rows K U)))).
  assert (Lu : within (S N) (Ki * (eps1 * S2)) u).
  { apply KB; [apply Rmult_le_pos; lra|]; intros i Hi; unfold u.
    rewrite !left_comb, minus_comb, left_comb; destruct i as [|i]; unfold ResonanceCurve.left; cbn [rows];
      change (hat (rows 0 V)) with V; change (hat (rows S' T)) with T; change (hat (rows K U)) with U.
    - change (C (pow n V)) with (across M V n); change (C (pow n U)) with (across M U n); change (C (pow n T)) with
        (across M T n); rewrite V0.
      assert (Ed : across M (minus (point z) (point z')) n = C (pow n (hat z)) - C (pow n (hat z')) + (z O - z' O) *
        across M w n) by (unfold across, power; rewrite Ep, power_comb, power_minus, dot_comb, dot_minus; ring).
      rewrite Ed in Bh; match goal with |- Rabs ?g <= _ => match type of Bh with Rabs ?h <= _ => replace g with (- h) by
        (unfold D; field; exact Ne) end end. rewrite Rabs_Ropp; exact Bh.
    - unfold minus at 1 2 3 4 5; destruct (HV i ltac:(lia)) as (Ev & Et & Eu); specialize (Bi i ltac:(lia)); specialize
        (Ei i ltac:(lia)); specialize (Ei' i ltac:(lia)); rewrite Rabs_pos_eq in Ei, Ei' by lra; rewrite <- Ei, <- Ei',
      Pw, !Px in Bi. replace (V i - pow n V i) with (Map.B M i) by lra; replace (U i - pow n U i) with (Q i) by lra.
      replace (T i - pow n T i) with (p i) by lra; same_as Bi. }
  specialize (Lu O ltac:(lia)); unfold u, comb, minus, rows in Lu; rewrite <- (Rmult_assoc Ki) in Lu. match goal with |-
    Rabs ?g <= _ => match type of Lu with Rabs ?h <= _ => replace g with h by ring; exact Lu end end.
Qed.
End Second.

Theorem Side : Side_statement.
Proof.
  intros M w V U e n Qh Q HM N Hw He Ne Hn Hdet HVU H2 V0 Pos K NK; subst N; set (N := Map.N M) in *.
  destruct (inverse_exists M e n Ne Hdet) as (Ki & HK), (within_exists N w) as (W & HW & Wb), (within_exists N (Map.B
    M)) as (beta & Hb & Bb), (within_exists N V) as (v & Hv & Vb); pose proof (proj1 HK) as K1; pose proof (zeros M w
    e HM Hw He) as Z0.
  assert (He0 : 0 < / (2 * Ki) /\ Ki * / (2 * Ki) <= 1 / 2) by (split; [apply Rinv_0_lt_compat; lra | right; field;
    lra]).
  destruct (small_exists M w e HM Hw He n W HW Wb (/ (2 * Ki)) (proj1 He0)) as (d0 & Hd0 & Sm).
  specialize (Sm d0 (conj Hd0 (Rle_refl _))); assert (PK : 0 < Rabs K) by (apply Rabs_pos_lt, NK).
  assert (Pk : 0 < 2 * Ki * beta + 2) by (pose proof (P_pos M e n Ki beta HK (conj Hb Bb)); lra).
  assert (Ek : 0 < Rabs K / 2 / Ki) by (repeat apply Rdiv_lt_0_compat; lra).
  destruct (bend_all _ _ _ _ _ _ _ _ (fun _ => 0) Q (bends_as _ _ _ _ _ (second_height _ _ _ _ _ _ _ H2)) (fun i Hi =>
    bends_as _ _ _ _ _ (second_impact _ _ _ _ _ _ _ H2 i Hi)) _ Ek) as (r0 & Hr0 & Bh & Bi).
  destruct (small_exists M w e HM Hw He n W HW Wb (r0 / (1 + W) / ((2 * Ki * beta + 2) * Ki))) as (d3 & Hd3 & Sm3);
    [repeat apply Rdiv_lt_0_compat; try apply Rmult_lt_0_compat; lra|].
  destruct (two_least d0 d3 Hd0 Hd3) as (d' & Hd' & A7 & A8), (two_least r0 (d' / (2 * Ki * beta + 2)) Hr0) as (rs & Hrs
    & A9 & A10); [apply Rdiv_lt_0_compat; lra|].
  assert (Law : forall y y' z z', 0 <= y < rs -> 0 <= y' < rs -> within (S N) d0 z -> within (S N) d0 z' ->
    ResonanceCurve.solves M w e n y z -> ResonanceCurve.solves M w e n y' z' -> Rabs (z O - z' O - K * (y ^ 2 - y' ^ 2))
    <= Rabs K / 2 * ((y + y') * Rabs (y - y'))).
  { assert (R0' : Rabs 0 <= r0) by (rewrite Rabs_R0; lra); assert (Py : forall y, 0 <= y < rs -> (2 * Ki * beta + 2) * y
      <= d') by (intros y Hy; apply Rle_trans with ((2 * Ki * beta + 2) * (d' / (2 * Ki * beta + 2))); [apply
    Rmult_le_compat_l; lra | right; field; lra]). assert (HV3 : forall i, (i < N)%nat -> V i = power M n V i + Map.B M i
      /\ zero i = power M n zero i + 0 /\ U i = power M n U i + Q i) by (intros i Hi; destruct (HVU i Hi); repeat split;
      trivial; unfold power; rewrite power_zero; unfold zero; ring).
    intros y y' z z' Hy Hy' Hz Hz' HS HS'; pose proof (second M w V zero U e n 0 Qh (fun _ => 0) Q 0 (Rabs K / 2 / Ki)
      r0 Z0 Ne HV3 V0 (conj Hr0 Ek)) as L; cbv zeta in L; specialize (L (fun y mu x y' mu' x' X X' B B' BB => conj (Bh 0
      y mu x y' mu' x' R0' X X' B B' BB) (fun i Hi => Bi i Hi 0 y mu x y' mu' x' R0' X X' B B' BB)) Ki W _ d0 d' beta HK
      (conj HW Wb) Hd0 He0 Sm (conj Hb Bb) (conj Hd' A7) (Sm3 d' (conj Hd' A8)) y y' z z' ltac:(lra) ltac:(lra) (Py y
      Hy) (Py y' Hy') Hz Hz' HS HS'); rewrite Rabs_R0, !Rmult_0_l, !Rplus_0_l in L; fold K in L.
    replace (Rabs K / 2) with (Ki * (Rabs K / 2 / Ki)) by (field; lra); exact L. }
  destruct (Curve M w V e n HM Hw He Ne Hn Hdet (fun i Hi => proj1 (HVU i Hi))) as (dc & Hdc & Cv).
  destruct (curve_one _ _ _ _ _ _ Cv) as (rc & Hrc & One); [intros k Hk; rewrite V0; apply Pos, Hk|].
  destruct (curve_slope _ _ _ _ _ _ Cv 1 ltac:(lra)) as (rl & Hrl & Slope); cbv zeta in Slope; rewrite V0 in Slope.
  destruct (hit_bound M w e n HM Hw He) as (l & dl & Hdl & Hl & Lip).
  destruct (two_least rc rs Hrc Hrs) as (r1 & R1 & A1 & A2), (two_least r1 d0 R1 Hd0) as (r2 & R2 & A3 & A4), (two_least
    r2 rl R2 Hrl) as (r & Hr & A5 & A6).
  destruct (two_least dc dl Hdc Hdl) as (d1 & D1 & B1 & B2), (two_least (d0 / (1 + W)) (r / 2 * (r / 2) / l)) as (d2 &
    D2 & B3 & B4); [apply Rdiv_lt_0_compat; lra | apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra|].
  destruct (two_least d1 d2 D1 D2) as (d & Hd & B5 & B6).
  assert (E1 : (1 + W) * d <= d0) by (apply (Rle_trans _ ((1 + W) * (d0 / (1 + W)))); [apply Rmult_le_compat_l; lra |
    right; field; lra]).
  assert (E2 : l * d <= r / 2 * (r / 2)) by (apply (Rle_trans _ (l * (r / 2 * (r / 2) / l))); [apply Rmult_le_compat_l;
    lra | right; field; lra]).
  assert (Orb : forall mu x, Rabs mu <= d -> single M n mu d x -> let y := speed_of M n mu x in 0 < y < r /\
    within (S N) d0 (of w mu (x tt)) /\ ResonanceCurve.solves M w e n y (of w mu (x tt))).
  { intros mu x Hmu Ho; destruct (orbit_inside M w e n Hn W d0 l dl (r / 2) d (conj HW Wb) (conj Hl Lip) (conj (conj Hd
      (Rle_trans _ _ _ B5 B2)) E1) ltac:(lra) mu x Hmu Ho) as (Y & Z & S & _); cbv zeta in *; split; [lra | auto]. }
  assert (Law2 : forall mu x mu' x', Rabs mu <= d -> Rabs mu' <= d -> single M n mu d x -> single M n mu' d x' -> let y
    := speed_of M n mu x in let y' := speed_of M n mu' x' in Rabs (mu - mu' - K * (y ^ 2 - y' ^ 2)) <= Rabs K / 2 * ((y
    + y') * Rabs (y - y'))).
  { intros mu x mu' x' Hm Hm' Ho Ho' y y'; destruct (Orb mu x Hm Ho) as (Y & Z & S), (Orb mu' x' Hm' Ho') as (Y' & Z'
    & S').
    fold y in Y, S; fold y' in Y', S'. apply (Law y y' (of w mu (x tt)) (of w mu' (x' tt))); trivial; lra. }
  assert (Law1 : forall mu x, Rabs mu <= d -> single M n mu d x -> let y := speed_of M n mu x in K * K * (y * y) <= 2 *
    (K * mu) <= 3 * (K * K * (y * y)) /\ 0 < y < r).
  { intros mu x Hm Ho y; destruct (Orb mu x Hm Ho) as (Y & Z & S); fold y in Y, S; split; [|exact Y].
    pose proof (Law y 0 (of w mu (x tt)) zero ltac:(lra) ltac:(lra) Z ltac:(apply within_zero;
      lra) S (zero_solves M w e n Z0)) as L; change (of w mu (x tt) O) with mu in L; unfold zero in L.
    rewrite !Rminus_0_r, (Rabs_pos_eq y) in L by lra; replace (y ^ 2 - 0 ^ 2) with (y * y) in L by ring.
    apply (Rmult_le_compat_l (Rabs K)) in L; [|lra]; rewrite <- Rabs_mult in L.
    assert (E : Rabs K * (Rabs K / 2 * ((y + 0) * y)) = K * K * (y * y) / 2) by (rewrite <- (Rabs_pos_eq (K * K)),
      Rabs_mult by apply Rle_0_sqr; field). rewrite E in L; apply le_abs in L; lra. }
  assert (Wider : forall mu x a a', a <= a' -> single M n mu a x -> single M n mu a' x) by (intros mu x a a' Ha H j;
    destruct (H j) as [X Y]; split; [apply within_le with a; assumption | exact Y]).
  assert (Uniq : forall mu x mu' x', Rabs mu <= d -> Rabs mu' <= d -> single M n mu d x -> single M n mu' d x' ->
    speed_of M n mu x = speed_of M n mu' x' -> mu' = mu /\ forall i, (i < N)%nat -> x' tt i = x tt i).
  { intros mu x mu' x' Hm Hm' Ho Ho' E; destruct (Law1 mu x Hm Ho) as [_ Y].
    assert (Yc : 0 < speed_of M n mu x < rc) by lra; destruct (One _ Yc) as (m & z & _ & _ & _ & Only). destruct (Only
      mu x ltac:(lra) (Wider mu x d dc ltac:(lra) Ho) eq_refl) as [-> X], (Only mu' x' ltac:(lra) (Wider mu' x' d dc
      ltac:(lra) Ho') (eq_sym E)) as [-> X'].
    split; [reflexivity|]; intros i Hi; rewrite (X i Hi), (X' i Hi); reflexivity. }
  (* every small speed is one's *)
  destruct (two_least (r / 4) (d / (2 * (1 + W + v)))) as (b & Hb0 & C1 & C2); [lra | apply Rdiv_lt_0_compat; lra|].
  apply (Rmult_le_compat_l (2 * (1 + W + v))) in C2; [|lra].
  replace (2 * (1 + W + v) * (d / (2 * (1 + W + v)))) with d in C2 by (field; lra).
  set (m := fun y => the (fun mu => exists x, Rabs mu <= d /\ single M n mu d x /\ speed_of M n mu x = y)).
  assert (Ex : forall y, 0 < y <= 2 * b -> exists x, Rabs (m y) <= d /\ single M n (m y) d x /\ speed_of M n (m y) x =
    y).
  { intros y Hy; destruct (One y ltac:(lra)) as (mu & x & Hm & Ho & Ey & _); destruct (Slope mu x Hm Ho ltac:(lra)) as
    [S1 S2]; rewrite Ey in S1, S2. replace (mu + 0 / e * y) with mu in S1 by (field; exact Ne).
    assert (Wy : 0 <= y * W /\ 0 <= y * v) by (split; apply Rmult_le_pos; lra); assert (Yd : y * (1 + W + v) <= d).
    { apply Rle_trans with (2 * b * (1 + W + v)); [apply Rmult_le_compat_r; lra | lra]. }
    assert (Ho' : single M n mu d x).
    { intros []; destruct (Ho tt) as [_ Y]; split; [|exact Y]; intros i Hi; specialize (S2 i Hi); cbv beta in S2.
      replace (x tt i) with ((x tt i - mu * w i - y * V i) + mu * w i + y * V i) by ring.
      apply (Rle_trans _ (1 * y + 1 * y * W + y * v)); [|lra]; apply triangle3; [exact S2 | apply Rabs_mult_le; [lra |
        apply Wb, Hi] | apply Rabs_mult_le; [rewrite Rabs_pos_eq; lra | apply Vb, Hi]]. }
    exists x; assert (Em : m y = mu); [|rewrite Em; split; [lra | auto]]; apply the_spec; [exists x; split; [lra |
      auto]|].
    intros mu' (x' & Hm' & Hx' & Ey'); apply (Uniq mu x mu' x'); trivial; lra. }
  assert (Mono : forall y y', 0 < y <= 2 * b -> 0 < y' <= 2 * b -> Rabs (m y - m y') <= 8 * Rabs K * b * Rabs (y - y')).
  { intros y y' Hy Hy'; destruct (Ex y Hy) as (x & X1 & X2 & X3), (Ex y' Hy') as (x' & X1' & X2' & X3').
    pose proof (Law2 _ _ _ _ X1 X1' X2 X2') as L; cbv zeta in L; rewrite X3, X3' in L; apply from in L.
    assert (E : Rabs (K * (y ^ 2 - y' ^ 2)) = Rabs K * ((y + y') * Rabs (y - y'))) by (rewrite <- (Rabs_pos_eq (y +
      y')), <- !Rabs_mult by lra; f_equal; ring). rewrite E in L; pose proof (Rabs_pos (y - y')).
    assert (0 <= Rabs K * ((y + y') * Rabs (y - y'))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
    assert ((y + y') * Rabs (y - y') <= 4 * b * Rabs (y - y')) by (apply Rmult_le_compat_r; lra).
    apply Rle_trans with (2 * (Rabs K * ((y + y') * Rabs (y - y')))); [lra|]; apply Rle_trans with (2 * (Rabs K * (4 * b
      * Rabs (y - y')))); [|right; ring]; apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra. }
  assert (KK : 0 < K * K) by (rewrite <- (Rabs_pos_eq (K * K)), Rabs_mult by apply Rle_0_sqr; apply Rmult_lt_0_compat;
    lra).
  destruct (two_least d (Rabs K * (b * b) / 2)) as (mu0 & Hmu0 & F1 & F2); [lra | apply Rdiv_lt_0_compat; [apply
    Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra] | lra]|].
  exists d, mu0; split; [exact Hd | split; [exact Hmu0|]]; intros mu Hmu; split.
  - intros Hp; assert (Hk : K * mu < K * K * (b * b) / 2).
    { rewrite <- (Rabs_pos_eq (K * mu)), Rabs_mult by lra; apply Rlt_le_trans with (Rabs K * (Rabs K * (b * b) / 2));
        [apply Rmult_lt_compat_l; lra | right; rewrite <- (Rabs_pos_eq (K * K)), Rabs_mult by lra; field]. }
    set (a := Rmin (b / 2) (K * mu / (2 * (K * K) * b))). assert (Pb : 0 < 2 * (K * K) * b) by (apply Rmult_lt_0_compat;
      lra).
    assert (Ha : 0 < a) by (apply Rmin_glb_lt; [lra | apply Rdiv_lt_0_compat; lra]); assert (Hab : a <= b / 2) by apply
      Rmin_l. assert (Haa : K * K * (a * a) <= K * mu / 2).
    { apply Rle_trans with (K * K * (b * (K * mu / (2 * (K * K) * b)))); [|right; field; lra]; apply
      Rmult_le_compat_l; [lra|].
      apply Rmult_le_compat; try lra; apply Rmin_r. }
    assert (At : forall y, 0 < y <= 2 * b -> K * K * (y * y) <= 2 * (K * m y) <= 3 * (K * K * (y * y))) by (intros y Hy;
      destruct (Ex y Hy) as (x & X1 & X2 & X3); destruct (Law1 _ x X1 X2) as [L _]; cbv zeta in L; rewrite X3 in L;
      exact L).
    destruct (IVT_interv (fun y => K * m y - K * mu) a b) as (y & Hy & Ey); [ | lra | pose proof (At a ltac:(lra)); lra
      | pose proof (At b ltac:(lra)); lra|].
    { intros y Hy eps Heps; set (q := 8 * (K * K) * b + 1); assert (Hq : 0 < q) by (unfold q; lra).
      destruct (two_least a (eps / q) Ha ltac:(apply Rdiv_lt_0_compat; lra)) as (dy & Hdy & G1 & G2).
      exists dy; split; [exact Hdy|]; intros y' [_ D]; cbn in D |- *; unfold R_dist in *; pose proof (Rabs_def2 _ _ D).
      pose proof (Mono y' y ltac:(lra) ltac:(lra)) as L; apply (Rmult_le_compat_l (Rabs K)) in L; [|lra].
      replace (K * m y' - K * mu - (K * m y - K * mu)) with (K * (m y' - m y)) by ring; rewrite Rabs_mult.
      assert (E : Rabs K * (8 * Rabs K * b * Rabs (y' - y)) = (q - 1) * Rabs (y' - y)) by (unfold q; rewrite <-
        (Rabs_pos_eq (K * K)), Rabs_mult by lra; ring). rewrite E in L; apply (Rmult_le_compat_l q) in G2; [|lra].
      replace (q * (eps / q)) with eps in G2 by (field; lra); pose proof (Rabs_pos (y' - y)).
      assert (q * Rabs (y' - y) < q * dy) by (apply Rmult_lt_compat_l; lra); lra. }
    destruct (Ex y ltac:(lra)) as (x & X1 & X2 & X3); assert (Em : m y = mu) by (apply (Rmult_eq_reg_l K); lra).
    rewrite Em in X1, X2, X3; exists x; split; [exact X2|]; intros x' Hx'.
    apply (Uniq mu x mu x' X1 X1 X2 Hx'); pose proof (Law2 mu x mu x' X1 X1 X2 Hx') as L; cbv zeta in L.
    destruct (Law1 mu x X1 X2) as [_ Y], (Law1 mu x' X1 Hx') as [_ Y']; set (s := speed_of M n mu x) in *; set (s' :=
      speed_of M n mu x') in *. rewrite Rminus_eq_0, Rminus_0_l, Rabs_Ropp in L.
    assert (E : Rabs (K * (s ^ 2 - s' ^ 2)) = Rabs K * ((s + s') * Rabs (s - s'))) by (rewrite <- (Rabs_pos_eq (s +
      s')), <- !Rabs_mult by lra; f_equal; ring). rewrite E in L; apply Rminus_diag_uniq, Rabs_zero, Rnot_lt_le; intros
      Ne'.
    assert (0 < Rabs K * ((s + s') * Rabs (s - s'))) by (apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]);
      lra.
  - intros Hp x Ho; destruct (Law1 mu x ltac:(lra) Ho) as [L Y]; cbv zeta in L.
    assert (0 < K * K * (speed_of M n mu x * speed_of M n mu x)) by (apply Rmult_lt_0_compat; [lra | apply
      Rmult_lt_0_compat; lra]); lra.
Qed.
