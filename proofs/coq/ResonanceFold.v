(** * Where the curve of orbits with one impact begins with the slope 0, its second order says on which side it is *)
From Coq Require Import Reals FunctionalExtensionality Lra Lia Ranalysis5.
From Grazing Require Import StatementOrbits StatementResonance Derivatives Finite OrbitVectors Contraction
  OrbitRemainder.
From Grazing Require Import Orbits ResonanceCurve ResonanceMaps.
Open Scope R_scope.

Section Second.
Variables (M : Map.t) (w V U : vec) (e : R) (n : nat) (Qh : R) (Q : vec).
Hypothesis HM : smooth M.
Notation N := (Map.N M).
Notation pow k x := (Nat.iter k (mult N (Map.A M)) x).
Notation C := (dot N (Map.C M)).
Hypothesis Hw : forall i, (i < N)%nat -> w i = mult N (Map.A M) w i + Map.phi M i.
Hypothesis He : e = C w + Map.eta M.
Hypothesis Ne : e <> 0.
Hypothesis HV : forall i, (i < N)%nat -> V i = pow n V i + Map.B M i /\ U i = pow n U i + Q i.
Hypothesis H2 : second_order M w V e n Qh Q.
Hypothesis V0 : across M V n = 0.
Notation K := (- (1 + Qh + across M U n) / e).
Notation solves := (solves M w e n).
Notation point := (point w).
Notation left := (left M e n).
Variables (Ki W eps0 d beta : R).
Hypothesis HK : inverse_bound M e n Ki.
Hypothesis HW : 0 <= W /\ within N W w.
Hypothesis Hd : 0 < d.
Hypothesis He0 : 0 < eps0 /\ Ki * eps0 <= 1 / 2.
Hypothesis Hsm : small M w e n W eps0 d.
Hypothesis Hbeta : 0 <= beta /\ within N beta (Map.B M).
Notation P := (2 * Ki * beta + 2).
Let HV1 i (Hi : (i < N)%nat) := proj1 (HV i Hi).

(** What lies between two solutions: (0, V) to the first order, and K and U to the second. *)
Lemma first_order eps : 0 < eps -> exists r, 0 < r /\ forall y y' z z', 0 <= y < r -> 0 <= y' < r -> y <= d -> y' <= d
  ->
  within (S N) d z -> within (S N) d z' -> solves y z -> solves y' z' -> Rabs (z O - z' O) <= eps * Rabs (y - y') /\
  within N (eps * Rabs (y - y')) (fun i => (hat z i - hat z' i) - (y - y') * V i).
Proof.
  intros Heps; destruct (ResonanceCurve.first_order M w e n V HM Hw He Ne HV1 Ki W eps0 d beta HK HW Hd He0 Hsm Hbeta
    eps Heps) as (r & Hr & F); exists r; split; [exact Hr|]; intros y y' z z' Hy Hy' Hyd Hyd' Hz Hz' HS HS'.
  destruct (proj1 (within_S M _ _) (F y y' z z' Hy Hy' Hyd Hyd' Hz Hz' HS HS')) as [B3 B4]; split; [|exact B4].
  unfold minus, line, rows in B3; change (dot N (Map.C M) (pow n V)) with (across M V n) in B3; rewrite V0 in B3.
  replace (z O - z' O) with (z O - z' O - - (0 / e) * (y - y')) by (field; exact Ne); exact B3.
Qed.
Lemma cone a y m v x : 0 <= a -> Rabs m <= a * Rabs y -> within N (a * Rabs y) (fun i => v i - y * V i) ->
  (forall i, x i = v i + m * w i) -> beside N V ((1 + W) * a) y m x.
Proof.
  intros Ha Hm Hv Hx; pose proof (Rabs_pos y); assert (P0 : 0 <= a * Rabs y) by (apply Rmult_le_pos; lra).
  assert (P1 : 0 <= a * Rabs y * W) by (apply Rmult_le_pos; lra). split; [lra|]; intros i Hi; rewrite Hx.
  replace (v i + m * w i - y * V i) with ((v i - y * V i) + m * w i) by ring.
  replace ((1 + W) * a * Rabs y) with (a * Rabs y + a * Rabs y * W) by ring.
  apply triangle2; [apply Hv, Hi | apply Rabs_mult_le; [exact Hm | apply HW, Hi]].
Qed.
Lemma bends_all eps : 0 < eps -> exists r, 0 < r /\ forall y mu x y' mu' x', 0 <= y <= r -> 0 <= y' <= r ->
  beside N V r y mu x -> beside N V r y' mu' x' -> beside N V r (y - y') (mu - mu') (minus x x') -> let D := y ^ 2 -
    y' ^ 2
  in let e' := eps * ((y + y') * Rabs (y - y')) in let fl := fly M in Rabs (Map.h M (fl mu n x) mu - Map.h M (fl mu' n
    x') mu'
  - (across M (minus x x') n + (mu - mu') * (e - across M w n)) - Qh * D) <= e' /\ forall i, (i < N)%nat ->
  Rabs (fl mu n x i + Map.kick M (fl mu n x) y mu i * y - (fl mu' n x' i + Map.kick M (fl mu' n x') y' mu' i * y') -
    (pow n
  (minus x x') i + (y - y') * Map.B M i + (mu - mu') * (w i - pow n w i)) - Q i * D) <= e'.
Proof.
  intros He'; destruct H2 as [Hh Hi]; destruct (Hh eps He') as (r1 & R1 & B1).
  assert (Down : forall r r' y mu x, r' <= r -> beside N V r' y mu x -> beside N V r y mu x).
  { intros r r' y mu x Hr [A B]; assert (r' * Rabs y <= r * Rabs y) by (apply Rmult_le_compat_r; [apply Rabs_pos |
    exact Hr]).
    split; [lra | apply (within_le _ _ _ _ H B)]. }
  destruct (common_bound (fun i r => (i < N)%nat -> forall y mu x y' mu' x', 0 <= y <= r -> 0 <= y' <= r -> beside N V r
    y mu x -> beside N V r y' mu' x' -> beside N V r (y - y') (mu - mu') (minus x x') -> Rabs (fly M mu n x i + Map.kick
    M (fly M mu n x) y mu i * y - (fly M mu' n x' i + Map.kick M (fly M mu' n x') y' mu' i * y') - (pow n (minus x x') i
    + (y - y') * Map.B M i + (mu - mu') * (w i - pow n w i)) - Q i * (y ^ 2 - y' ^ 2)) <= eps * ((y + y') * Rabs (y -
    y'))) N) as (r2 & R2 & B2).
  - intros i r r' H Hr HiN y mu x y' mu' x' Hy Hy' X X' XX; apply (H HiN); try lra; apply (Down r r'); trivial; lra.
  - intros i HiN; destruct (Hi i HiN eps He') as (r & Hr & B); exists r; split; [exact Hr | intros _; exact B].
  - destruct (two_least r1 r2 R1 R2) as (r & Hr & L1 & L2); exists r; split; [exact Hr|]; intros y mu x y' mu' x' Hy
    Hy' X X' XX; cbv zeta; split; [apply B1 | intros i HiN; apply (B2 i HiN HiN)]; try lra; apply (Down _ r); trivial.
Qed.
Lemma second eps : 0 < eps -> exists r, 0 < r /\ forall y y' z z', 0 <= y < r -> 0 <= y' < r -> y <= d -> y' <= d ->
  within (S N) d z -> within (S N) d z' -> solves y z -> solves y' z' ->
  Rabs (z O - z' O - K * (y ^ 2 - y' ^ 2)) <= eps * ((y + y') * Rabs (y - y')).
Proof.
  intros Heps; pose proof HK as (K1 & KB & _); destruct (bends_all (eps / Ki) ltac:(apply Rdiv_lt_0_compat; lra)) as (r0
    & R0 & Bend). set (a := r0 / (1 + W)); assert (Pa : 0 < a) by (apply Rdiv_lt_0_compat; lra); assert (Ea : (1 + W) *
    a = r0) by (unfold a; field; lra). destruct (first_order a Pa) as (r1 & R1 & First), (two_least r0 r1 R0 R1) as (r &
    Hr & L1 & L2).
  exists r; split; [exact Hr|]; intros y y' z z' Hy Hy' Hyd Hyd' Hz Hz' HS HS'.
  assert (Px : forall z i, point z i = hat z i + z O * w i) by (intros u i; unfold ResonanceCurve.point, comb; ring).
  assert (Cone : forall y z, 0 <= y < r -> y <= d -> within (S N) d z -> solves y z -> beside N V r0 y (z O) (point z)).
  { intros t u Ht Htd Hu HSu; destruct (First t 0 u zero ltac:(lra) ltac:(lra) Htd ltac:(lra) Hu ltac:(apply
    within_zero; lra) HSu (zero_solves M w e n HM Hw He)) as [A B]; unfold zero in A; rewrite !Rminus_0_r in A.
    rewrite <- Ea; apply (cone a t (u O) (hat u)); [lra | exact A | | apply Px]; intros i Hi; specialize (B i Hi).
    unfold hat, zero in B; rewrite !Rminus_0_r in B; exact B. }
  assert (Diff : beside N V r0 (y - y') (z O - z' O) (minus (point z) (point z'))).
  { destruct (First y y' z z') as [A B]; trivial; try lra; rewrite <- Ea.
    apply (cone a (y - y') (z O - z' O) (fun i => hat z i - hat z' i)); [lra | exact A | exact B|].
    intros i; unfold minus; rewrite !Px; ring. }
  destruct (Bend y (z O) (point z) y' (z' O) (point z') ltac:(lra) ltac:(lra) (Cone y z ltac:(lra) Hyd Hz HS) (Cone y'
    z' ltac:(lra) Hyd' Hz' HS') Diff) as [Bh Bi]; cbv zeta in Bh, Bi.
  apply (solves_is M w e n y z ltac:(lra)) in HS; apply (solves_is M w e n y' z' ltac:(lra)) in HS'.
  destruct HS as [Eh Ei], HS' as [Eh' Ei']; rewrite Eh, Eh' in Bh; set (D := y ^ 2 - y' ^ 2) in *.
  set (S2 := (y + y') * Rabs (y - y')) in *; assert (PS : 0 <= S2) by (apply Rmult_le_pos; [lra | apply Rabs_pos]).
  assert (Ep : minus (point z) (point z') = comb 1 (z O - z' O) (minus (hat z) (hat z')) w) by (extensionality i; unfold
    minus, comb; rewrite !Px; ring).
  assert (Pw : forall i, pow n (minus (point z) (point z')) i = pow n (hat z) i - pow n (hat z') i + (z O - z' O) * pow
    n w i) by (intros i; rewrite Ep, power_comb, power_minus; unfold comb, minus; ring).
  set (u := comb 1 (-1) (minus z z') (comb (y - y') D (rows 0 V) (rows K U))).
  assert (Lu : within (S N) (Ki * (eps / Ki * S2)) u).
  { apply KB; [apply Rmult_le_pos; [left; apply Rdiv_lt_0_compat; lra | exact PS]|]; intros i Hi; unfold u.
    rewrite left_comb, left_comb, minus_comb, left_comb; destruct i as [|i]; unfold ResonanceCurve.left, rows at 1 3.
    - change (hat (rows 0 V)) with V; change (hat (rows K U)) with U; cbn [rows].
      change (C (pow n V)) with (across M V n); change (C (pow n U)) with (across M U n); rewrite V0.
      assert (Ed : across M (minus (point z) (point z')) n = C (pow n (hat z)) - C (pow n (hat z')) + (z O - z' O) *
        across M w n) by (unfold across, power; rewrite Ep, power_comb, power_minus, dot_comb, dot_minus; ring).
      rewrite Ed in Bh; match goal with |- Rabs ?g <= _ => match type of Bh with Rabs ?h <= _ => replace g with (- h) by
        (unfold D; field; exact Ne) end end. rewrite Rabs_Ropp; exact Bh.
    - change (hat (rows 0 V)) with V; change (hat (rows K U)) with U; cbn [rows]; unfold minus at 1 2 3 4.
      destruct (HV i ltac:(lia)) as [Ev Eu]; specialize (Bi i ltac:(lia)); specialize (Ei i ltac:(lia)); specialize (Ei'
        i ltac:(lia)); rewrite Rabs_pos_eq in Ei, Ei' by lra; rewrite <- Ei, <- Ei', Pw, !Px in Bi.
      replace (V i - pow n V i) with (Map.B M i) by lra; replace (U i - pow n U i) with (Q i) by lra; same_as Bi. }
  specialize (Lu O ltac:(lia)); unfold u, comb, minus, rows in Lu; replace (Ki * (eps / Ki * S2)) with (eps * S2) in Lu
    by (field; lra). match goal with |- Rabs ?g <= _ => match type of Lu with Rabs ?h <= _ => replace g with h by ring;
    exact Lu end end.
Qed.
End Second.

Theorem Side : Side_statement.
Proof.
  intros M w V U e n Qh Q HM N Hw He Ne Hn Hdet HVU H2 V0 Pos K NK; subst N; set (N := Map.N M) in *.
  destruct (inverse_exists M e n Ne Hdet) as (Ki & HK), (within_exists N w) as (W & HW & Wb), (within_exists N (Map.B
    M)) as (beta & Hb & Bb), (within_exists N V) as (v & Hv & Vb); pose proof (proj1 HK) as K1.
  assert (He0 : 0 < / (2 * Ki) /\ Ki * / (2 * Ki) <= 1 / 2) by (split; [apply Rinv_0_lt_compat; lra | right; field;
    lra]).
  destruct (small_exists M w e n HM Hw He W HW Wb (/ (2 * Ki)) (proj1 He0)) as (d0 & Hd0 & Sm).
  specialize (Sm d0 (conj Hd0 (Rle_refl _))); assert (PK : 0 < Rabs K) by (apply Rabs_pos_lt, NK).
  destruct (second M w V U e n Qh Q HM Hw He Ne HVU H2 V0 Ki W _ d0 beta HK (conj HW Wb) Hd0 He0 Sm (conj Hb Bb) (Rabs K
    / 2) ltac:(lra)) as (rs & Hrs & Law); fold K in Law.
  destruct (Curve M w V e n HM Hw He Ne Hn Hdet (fun i Hi => proj1 (HVU i Hi))) as (dc & Hdc & Cv).
  destruct (curve_one _ _ _ _ _ _ Cv) as (rc & Hrc & One); [intros k Hk; rewrite V0; apply Pos, Hk|].
  destruct (curve_slope _ _ _ _ _ _ Cv 1 ltac:(lra)) as (rl & Hrl & Slope); cbv zeta in Slope; rewrite V0 in Slope.
  destruct (orbit_inside M w e n HM Hw He Hn W HW Wb) as (l & dl & Hl & Hdl & Inside).
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
  { intros mu x Hmu Ho; destruct (Inside d0 d (r / 2) mu x ltac:(lra) E1 ltac:(lra) E2 Hmu Ho) as (Y & Z & S & _); cbv
    zeta
      in *; split; [lra | auto]. }
  assert (Law2 : forall mu x mu' x', Rabs mu <= d -> Rabs mu' <= d -> single M n mu d x -> single M n mu' d x' -> let y
    := speed_of M n mu x in let y' := speed_of M n mu' x' in Rabs (mu - mu' - K * (y ^ 2 - y' ^ 2)) <= Rabs K / 2 * ((y
    + y') * Rabs (y - y'))).
  { intros mu x mu' x' Hm Hm' Ho Ho' y y'; destruct (Orb mu x Hm Ho) as (Y & Z & S), (Orb mu' x' Hm' Ho') as (Y' & Z'
    & S').
    fold y in Y, S; fold y' in Y', S'. apply (Law y y' (of w mu (x tt)) (of w mu' (x' tt))); trivial; lra. }
  assert (Law1 : forall mu x, Rabs mu <= d -> single M n mu d x -> let y := speed_of M n mu x in K * K * (y * y) <= 2
    * (K *
    mu) <= 3 * (K * K * (y * y)) /\ 0 < y < r).
  { intros mu x Hm Ho y; destruct (Orb mu x Hm Ho) as (Y & Z & S); fold y in Y, S; split; [|exact Y].
    pose proof (Law y 0 (of w mu (x tt)) zero ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) Z ltac:(apply within_zero;
      lra) S (zero_solves M w e n HM Hw He)) as L; change (of w mu (x tt) O) with mu in L; unfold zero in L.
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
