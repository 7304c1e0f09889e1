(** * Chaos between the windows: the proof *)
From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import StatementPlane.
From Grazing Require Import StatementAttractor AttractorAlgebra AttractorDerivative AttractorEigen
  AttractorOrbit AttractorGapAlgebra.
Open Scope R_scope.

Lemma root_facts d mu0 : 0 < d <= 1 / 6 -> 1 < (1 - d) ^ 3 * mu0 -> let E1 := sqrt ((1 - d) * mu0) in
  1 <= E1 /\ E1 ^ 2 = (1 - d) * mu0 /\ 1 < (1 - d) * E1.
Proof.
  intros Hd Hmu E1. assert (P : 1 < (1 - d) * mu0).
  { assert (Q : (1 - d) ^ 2 * ((1 - d) * mu0) > 1) by (replace ((1 - d) ^ 2 * ((1 - d) * mu0)) with ((1 - d) ^ 3 *
      mu0) by ring; lra). assert (0 < (1 - d) ^ 2 <= 1). { split; [apply pow_lt; lra|rewrite <- (pow1 2);
      apply pow_incr; lra]. } apply Rnot_le_lt; intros F. nra. }
  assert (S : E1 ^ 2 = (1 - d) * mu0) by (unfold E1; simpl; rewrite Rmult_1_r; apply sqrt_sqrt; lra).
  assert (P0 : 0 <= E1) by apply sqrt_pos. assert (A : 1 < (1 - d) * E1).
  { apply Rnot_le_lt; intros F. assert (0 <= (1 - d) * E1) by (apply Rmult_le_pos; lra).
    assert (((1 - d) * E1) ^ 2 <= 1 ^ 2) by (apply pow_incr; lra). replace (((1 - d) * E1) ^ 2) with ((1 - d) ^ 2 * E1
      ^ 2) in * by ring. rewrite S in *. replace ((1 - d) ^ 2 * ((1 - d) * mu0)) with ((1 - d) ^ 3 * mu0) in * by
      ring. lra. }
  split; [|split; assumption]. assert (0 <= d * E1) by (apply Rmult_le_pos; lra). lra.
Qed.

Section Map.
Variables l1 l2 b d mu0 g0 g1 nu : R.
Variable m : nat.
Hypothesis Hl : 0 < l2 < l1.
Hypothesis Hl1 : l1 < 1.
Hypothesis Hb : 0 < b.
Hypothesis Hd : 0 < d <= 1 / 6.
Hypothesis Hmu : 1 < (1 - d) ^ 3 * mu0.
Hypothesis Hnu : 0 < nu.
Hypothesis Hm : (1 <= m)%nat.
Let M := 2 * l2 / (l1 - l2).
Let E1 := sqrt ((1 - d) * mu0).
Let be := b / sqrt nu.
Let B := be * l1 ^ m.
Let ep := nu / ((l1 - l2) * b) ^ 2.
Hypothesis Hg : 0 < g0 < g1.
Hypothesis Hep0 : 1 / 4 <= l1 * (1 - ep).
Hypothesis Hep : 1 - l1 * (1 - ep) <= g0.
Hypothesis HB1 : mu0 * 2 / sqrt 3 <= B.
Hypothesis HB2 : B ^ 2 * g1 <= 1.
Hypothesis HLm : l1 ^ m * (l1 / (l1 - l2)) < (1 - g0 / g1) / 2.
Hypothesis Hpow : forall k, (1 <= k <= m)%nat -> (1 - d) * l1 ^ m <= l1 ^ k - l2 ^ k.
Hypothesis HS1 : M + 2 * l1 / (l1 - l2) <= be / 2.
Hypothesis HS2 : M + (30 * E1 ^ 2 + 1) * l1 / (d / 96 * (l1 - l2) ^ 2) <= be / 2.
Notation height := (height l1 l2 nu).
Notation iterate := (iterate l1 l2 b nu).
Notation change := (change l1 l2).
Notation cone := (cone l1 l2).
Notation trap := (trap l1 l2 b nu).
Notation along := (along l1 l2 b nu).
Notation first_return := (first_return l1 l2 b nu).

Let C (x : R * R) : R := (height x + nu) / nu.
Definition weight (x : R * R) : R := phi E1 (C x) / C x.

Lemma E1_facts : 1 <= E1 /\ E1 ^ 2 = (1 - d) * mu0 /\ 1 < (1 - d) * E1. Proof. exact (root_facts d mu0 Hd Hmu). Qed.
Lemma C_trap x : trap x -> 1 / 4 <= C x <= 1 /\ 1 - C x <= g0.
Proof.
  intros (_ & _ & H1 & H2). fold ep in H1. assert (A : C x * nu = height x + nu) by (unfold C; field; lra). assert (l1
    * (1 - ep) <= C x) by (apply (Rmult_le_reg_r nu); lra). assert (C x <= 1) by (apply (Rmult_le_reg_r nu); lra).
    lra.
Qed.

Lemma return_cone n x v : trap x -> height x < 0 -> first_return n x -> cone v ->
  cone (apply (along n x) v) /\ (1 - d) * E1 * (weight x * Rabs (change v)) <=
  weight (iterate n x) * Rabs (change (apply (along n x) v)).
Proof.
  intros Hx Hh Hr Hv. destruct E1_facts as (F1 & F2 & F3). assert (Ht : trap (iterate n x)) by exact (return_trap l1
    l2 b nu Hl Hb Hnu n x (proj1 Hx) ltac:(lra) Hr). destruct (C_trap x Hx) as [[C1 C2] C3].
  destruct (C_trap _ Ht) as [[C1' C2'] C3']. pose proof (return_point l1 l2 b nu n x ltac:(lra) Hr) as [E2 _].
  simpl in E2. destruct (return_vector l1 l2 b nu n x v Hh Hr) as [Ec Es]. destruct Hx as (Hw & Hq & _ & _).
  pose proof Hr as (Hn & Hh' & Hk). assert (Hsn : 0 < sqrt nu) by (apply sqrt_lt_R0; lra).
  assert (Esn : sqrt nu * sqrt nu = nu) by (apply sqrt_sqrt; lra). set (y := sqrt (- height x)) in *.
  assert (Hy : 0 < y) by (apply sqrt_lt_R0; lra). assert (Ey : y
    * y = - height x) by (apply sqrt_sqrt; lra). set (u := y / sqrt nu). assert (Hu : 0 < u) by (unfold u; apply
    Rdiv_lt_0_compat; lra). assert (Eu : u ^ 2 = 1 - C x).
  { unfold u, C. replace ((y / sqrt nu) ^ 2) with (y * y / (sqrt nu * sqrt nu)) by (field; lra).
    rewrite Ey, Esn. field. lra. }
  set (s := b / (2 * y)) in *. assert (Hs : 2 * s * u = be) by (unfold s, u, be; field; split; lra).
  assert (Hby : forall q, (q + b * y) / nu = q / nu + be * u).
  { intros q. unfold be, u. rewrite <- Esn at 1 2. field. lra. } set (q := l2 * snd x / nu). assert (Hq0 : 0 <= q).
  { unfold q. apply Rmult_le_pos; [apply Rmult_le_pos; [lra|apply Hw]|]. left. apply Rinv_0_lt_compat. lra. }
  assert (Hq1 : q * (l1 - l2) <= l2).
  { unfold q. replace (l2 * snd x / nu * (l1 - l2)) with (l2 * (snd x * (l1 - l2)) / nu) by (field; lra).
    apply div_le; [lra|]. apply Rmult_le_compat_l; [lra|]. apply (Rmult_le_compat_r (l1 - l2)) in Hq; [|lra].
    replace (nu / (l1 - l2) * (l1 - l2)) with nu in Hq by (field; lra). exact Hq. }
  assert (EC : C (iterate n x) = l1 ^ n * C x + (l1 ^ n - l2 ^ n) * (q + be * u)).
  { unfold C at 1. rewrite E2. unfold q. rewrite <- Hby. unfold C. field. lra. } assert (HC'1 : C (iterate n x) < 1).
  { apply (Rmult_lt_reg_r nu); [lra|]. replace (C (iterate n x) * nu) with (height (iterate n x) + nu) by (unfold C;
      field; lra). lra. }
  assert (HK : 0 < l2 ^ n) by (apply pow_lt; lra). assert (HL : 0 < l1 ^ n) by (apply pow_lt; lra).
  assert (HL1 : l1 ^ n <= l1).
  { destruct n as [|n]; [lia|]. simpl. assert (l1 ^ n <= 1) by (rewrite <- (pow1 n); apply pow_incr; lra).
    apply Rle_trans with (l1 * 1); [apply Rmult_le_compat_l; lra|lra]. }
  pose proof (power_ratio l1 l2 n Hl Hn) as HKL. assert (Hbe : 0 < be) by (unfold be; apply Rdiv_lt_0_compat;
    lra). assert (Hbu : 0 < be * u) by (apply Rmult_lt_0_compat; lra). assert (Hlm : 0 < l1 ^ m) by (apply pow_lt;
    lra).
  (* the branch: n <= m *)
  assert (Hnm : (n <= m)%nat).
  { destruct (le_lt_dec n m) as [Z|Z]; [exact Z|exfalso]. assert (H0 : 0 <= height (iterate m x)) by (apply Hk;
      lia). destruct (flight_point l1 l2 b nu m x ltac:(lra) Hm) as [G _]; [intros k Hk'; apply Hk; lia|].
    fold y in G. assert (G' : 1 <= l1 ^ m * C x + (l1 ^ m - l2 ^ m) * (q + be * u)).
    { unfold q. rewrite <- Hby. unfold C. apply (Rmult_le_reg_r nu); [lra|]. replace ((l1 ^ m * ((height x + nu) / nu)
        + (l1 ^ m - l2 ^ m) * ((l2 * snd x + b * y) / nu)) * nu) with (l1 ^ m * (height x + nu) + (l1 ^ m - l2 ^ m) *
        (l2 * snd x + b * y)) by (field; lra). rewrite <- G. lra. }
    assert (0 < l2 ^ m) by (apply pow_lt; lra). assert (D1 : l1 ^ m * (C x + q) <= l1 ^ m * (l1 / (l1 - l2))).
    { apply Rmult_le_compat_l; [lra|]. apply le_div; [lra|]. assert (C x * (l1 - l2) <= 1 * (l1 - l2)) by (apply
        Rmult_le_compat_r; lra). lra. }
    assert (D2 : (B * u) ^ 2 <= g0 / g1).
    { replace ((B * u) ^ 2) with (B ^ 2 * u ^ 2) by ring. rewrite Eu. apply le_div; [lra|].
      assert (0 <= B ^ 2) by apply pow2_ge_0. assert (B ^ 2 * (1 - C x) <= B ^ 2 * g0) by (apply Rmult_le_compat_l;
        lra). assert (g0 * (B ^ 2 * g1) <= g0 * 1) by (apply Rmult_le_compat_l; lra).
      assert (B ^ 2 * (1 - C x) * g1 <= B ^ 2 * g0 * g1) by (apply Rmult_le_compat_r; lra). lra. }
    assert (D3 : B * u <= (1 + g0 / g1) / 2). { pose proof (pow2_ge_0 (1 - B * u)). lra.
    } assert (D4 : 0 <= l2 ^ m * (q + be * u)) by (apply Rmult_le_pos; lra). unfold B in D3. lra. }
  assert (HWW : E1 ^ 2 <= W (C x) * W (C (iterate n x))).
  { rewrite F2. assert (1 <= (1 - d) * mu0) by (rewrite <- F2, <- (pow1 2); apply pow_incr; lra).
    apply (W_pair (C x) u); try assumption; try lra. assert (H3 : 0 < sqrt 3) by (apply sqrt_lt_R0; lra).
    replace ((1 - d) * mu0 * (2 * u / sqrt 3)) with ((1 - d) * u * (mu0 * 2 / sqrt 3)) by (field; lra).
    apply Rle_trans with ((1 - d) * u * B). { apply Rmult_le_compat_l; [|exact HB1]. apply Rmult_le_pos; lra.
    } rewrite EC. specialize (Hpow n ltac:(lia)). apply (Rmult_le_compat_r (be * u)) in Hpow; [|lra].
    assert (0 <= l1 ^ n * C x) by (apply Rmult_le_pos; lra). assert (0 < l1 ^ n - l2 ^ n).
    { apply (Rmult_lt_reg_r l1); [lra|]. assert (0 < l1 ^ n * (l1 - l2)) by (apply Rmult_lt_0_compat; lra). lra. }
    assert (0 <= (l1 ^ n - l2 ^ n) * q) by (apply Rmult_le_pos; lra). unfold B. lra. }
  assert (Hs2 : be / 2 <= s).
  { assert (u <= 1).
    { apply Rnot_lt_le; intros F. assert (0 < (u - 1) * (u + 1)) by (apply Rmult_lt_0_compat; lra). lra. }
    assert (0 < s) by (unfold s; apply Rdiv_lt_0_compat; lra). assert (s * u <= s * 1) by (apply Rmult_le_compat_l;
      lra). lra. }
  assert (Gr := gap_growth l1 l2 d E1 Hl Hl1 F1 Hd (l1 ^ n) (l2 ^ n) be u (C x) (C (iterate n x)) q s HK ltac:(lra)
    HKL Hu Eu Hs C1 Hq0 Hq1 ltac:(lra) EC HWW ltac:(fold M; lra)). fold M in Gr. set (dc := change v) in *.
  set (dq := l2 * snd v) in *. destruct (cone_growth l1 l2 Hl (l1 ^ n) (l2 ^ n) s dc dq HK HL HKL ltac:(fold M;
    lra) Hv) as [G1 G2]. fold M in G1, G2. split.
  - unfold StatementAttractor.cone. rewrite Es, Ec. exact G1.
  - rewrite Ec. fold (weight x) in Gr. fold (weight (iterate n x)) in Gr. assert (PW : 0 <= weight (iterate n x)).
    { unfold weight. destruct (phi_bounds l1 l2 E1 Hl Hl1 F1 (C (iterate n x))) as [P _]. apply Rmult_le_pos;
        [lra|]. left. apply Rinv_0_lt_compat. lra. }
    pose proof (Rabs_pos dc) as Pa. apply (Rmult_le_compat_r (Rabs dc)) in Gr; [|exact Pa].
    apply (Rmult_le_compat_l (weight (iterate n x))) in G2; [|exact PW]. lra.
Qed.

Lemma gap : exists N, (1 <= N)%nat /\ chaotic l1 l2 b nu ((1 - d) * E1) N.
Proof.
  destruct E1_facts as (F1 & F2 & F3). apply (growing l1 l2 b nu Hl Hl1 Hb Hnu ((1 - d) * E1) (12 * E1) weight F3).
  - intros x Hx. destruct (C_trap x Hx) as [[C1 C2] _]. destruct (phi_bounds l1 l2 E1 Hl Hl1 F1 (C x)) as [P1 P2].
    unfold weight. split; [apply Rdiv_lt_0_compat; lra|]. apply div_le; [lra|]. assert (12 * E1 * (1 / 4) <= 12 * E1
      * C x) by (apply Rmult_le_compat_l; lra). lra.
  - exact return_cone.
Qed.
End Map.

(** ** All n from some n0 on *)
Definition eventually (P : nat -> Prop) : Prop := exists n0, forall n, (n0 <= n)%nat -> P n.
Lemma eventually_and P Q : eventually P -> eventually Q -> eventually (fun n => P n /\ Q n).
Proof. intros [n1 H1] [n2 H2]. exists (n1 + n2)%nat. intros n Hn. split; [apply H1|apply H2]; lia. Qed.
Lemma eventually_small l t : 0 < l < 1 -> 0 < t -> eventually (fun n => l ^ n <= t).
Proof.
  intros Hl Ht. destruct (pow_lt_1_zero l) with (y := t) as (n0 & H); [rewrite Rabs_pos_eq; lra|lra|].
  exists n0. intros n Hn. specialize (H n ltac:(lia)). rewrite Rabs_pos_eq in H by (apply pow_le; lra). lra.
Qed.
Lemma eventually_pow l1 l2 d : 0 < l2 < l1 -> l1 < 1 -> 0 < d < 1 ->
  eventually (fun n => forall k, (1 <= k <= n)%nat -> (1 - d) * l1 ^ n <= l1 ^ k - l2 ^ k).
Proof.
  intros Hl Hl1 Hd. destruct (eventually_small (l2 / l1) d) as (m0 & Hm0); [split;
    [apply Rdiv_lt_0_compat; lra|]|lra|].
  { apply (Rmult_lt_reg_r l1); [lra|]. replace (l2 / l1 * l1) with l2 by (field; lra). lra. }
  assert (P0 : 0 < l1 ^ m0) by (apply pow_lt; lra). destruct (eventually_small l1 (l1 ^ m0 * (l1 - l2) / l1)) as (n0 &
    Hn0); [lra| |].
  { apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|lra]. } exists n0. intros n Hn k Hk.
  assert (PL : 0 < l1 ^ k) by (apply pow_lt; lra). assert (PN : 0 < l1 ^ n) by (apply pow_lt; lra).
  destruct (le_lt_dec m0 k) as [C|C].
  - specialize (Hm0 k C). unfold Rdiv in Hm0. rewrite Rpow_mult_distr, pow_inv in Hm0. assert (l2 ^ k <= d * l1 ^ k).
    { apply (Rmult_le_compat_r (l1 ^ k)) in Hm0; [|lra]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r in Hm0 by lra.
      exact Hm0. }
    assert (l1 ^ n <= l1 ^ k).
    { replace n with (n - k + k)%nat by lia. rewrite pow_add. assert (l1 ^ (n - k) <= 1) by (rewrite <- (pow1 (n -
        k)); apply pow_incr; lra). nra. }
    assert ((1 - d) * l1 ^ n <= (1 - d) * l1 ^ k) by (apply Rmult_le_compat_l; lra). lra.
  - specialize (Hn0 n Hn). pose proof (power_ratio l1 l2 k Hl ltac:(lia)) as R. assert (l1 ^ m0 <= l1 ^ k).
    { replace m0 with (m0 - k + k)%nat by lia. rewrite pow_add. assert (l1 ^ (m0 - k) <= 1) by (rewrite <- (pow1 (m0 -
        k)); apply pow_incr; lra). nra. }
    assert (l1 ^ m0 * (l1 - l2) / l1 <= l1 ^ k - l2 ^ k).
    { apply div_le; [lra|]. assert (l1 ^ m0 * (l1 - l2) <= l1 ^ k * (l1 - l2)) by (apply Rmult_le_compat_r; lra). lra.
        }
    assert (0 <= d * l1 ^ n) by (apply Rmult_le_pos; lra). lra.
Qed.

Theorem gaps : Gaps_statement.
Proof.
  intros l1 l2 b g1 g2 Hl Hl1 Hb Hg1 Hg2. set (mu0 := sqrt (3 / (4 * g2))). assert (Pq : 1 < 3 / (4 * g2)).
  { apply (Rmult_lt_reg_r (4 * g2)); [lra|]. replace (3 / (4 * g2) * (4 * g2)) with 3 by (field; lra). lra. }
  assert (Emu : mu0 ^ 2 = 3 / (4 * g2)) by (unfold mu0; simpl; rewrite Rmult_1_r; apply sqrt_sqrt; lra).
  assert (Hmu : 1 < mu0). { unfold mu0. rewrite <- sqrt_1. apply sqrt_lt_1_alt. lra.
  } set (d := (mu0 - 1) / (6 * mu0)). assert (Ed : 6 * mu0 * d = mu0 - 1) by (unfold d; field; lra).
  assert (Hd : 0 < d <= 1 / 6). { split; [unfold d; apply Rdiv_lt_0_compat; lra|unfold d; apply div_le; lra].
  } assert (Hmu3 : 1 < (1 - d) ^ 3 * mu0).
  { assert (1 - 3 * d <= (1 - d) ^ 3) by (assert (0 <= d ^ 2 * (3 - d)) by (apply Rmult_le_pos;
      [apply pow2_ge_0|lra]); lra). assert ((1 - 3 * d) * mu0 <= (1 - d) ^ 3 * mu0) by (apply Rmult_le_compat_r;
      lra). lra. }
  set (E1 := sqrt ((1 - d) * mu0)). set (g0 := (1 - l1 + g1) / 2). assert (Hg0 : 0 < g0 < g1 /\ g0 = (1 - l1 + g1) /
    2) by (unfold g0; lra). destruct Hg0 as [Hg0 Eg0]. assert (Hr : g0 / g1 < 1). { apply (Rmult_lt_reg_r g1);
    [lra|]. replace (g0 / g1 * g1) with g0 by (field; lra). lra. } set (M := 2 * l2 / (l1 - l2)).
  set (S0 := M + 2 * l1 / (l1
    - l2) + (30 * E1 ^ 2 + 1) * l1 / (d / 96 * (l1 - l2) ^ 2)). assert (PM : 0 < M) by (unfold M; apply
    Rdiv_lt_0_compat; lra). assert (PT : 0 < 2 * l1 / (l1 - l2)) by (apply Rdiv_lt_0_compat; lra).
    assert (PE : 0 <= E1 ^ 2) by apply pow2_ge_0. assert (PU : 0 < (30 * E1 ^ 2 + 1) * l1 / (d / 96 * (l1 - l2) ^ 2)).
  { apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|]. apply Rmult_lt_0_compat; [lra|apply pow_lt; lra].
    }
  assert (PS : 0 < S0) by (unfold S0; lra).
  (* eps is at most e0 once l1^n <= (l1 - l2) sqrt e0; we take e0 <= 1 and use (l1^n / (l1-l2))^2 <= l1^n /
      (l1-l2) *)
  set (e0 := Rmin 1 (g1 - (1 - l1)) / 2). assert (He0 : 0 < e0 /\ e0 <= 1 / 2 /\ e0 <= (g1 - (1 - l1)) / 2).
  { assert (0 < Rmin 1 (g1 - (1 - l1))) by (apply Rmin_glb_lt; lra). pose proof (Rmin_l 1 (g1 - (1 - l1))).
    pose proof (Rmin_r 1 (g1 - (1 - l1))). unfold e0. lra. }
  destruct (eventually_and _ _ (eventually_pow l1 l2 d Hl Hl1 ltac:(lra)) (eventually_and _ _ (eventually_small l1 (e0
    * (l1 - l2)) ltac:(lra) ltac:(apply Rmult_lt_0_compat; lra)) (eventually_and _ _ (eventually_small l1 ((1 - g0 /
    g1) / 4 * ((l1 - l2) / l1)) ltac:(lra) ltac:(apply Rmult_lt_0_compat; [lra|apply Rdiv_lt_0_compat;
      lra])) (eventually_small l1 (/ (2 * S0)) ltac:(lra) ltac:(apply Rinv_0_lt_compat;
      lra))))) as (n0 & Hn0). destruct (root_facts d mu0 Hd Hmu3) as (F1 & F2 & F3). fold E1 in F1, F2, F3.
    exists ((1 - d) * E1), (S n0). split; [lra|]. intros n nu Hn [Hn1 Hn2]. destruct (Hn0 n ltac:(lia)) as (Hpow & A1
      & A2 & A3). assert (PL : 0 < l1 ^ n) by (apply pow_lt; lra). assert (Pbl : 0 < (b * l1 ^ n) ^ 2) by (apply
      pow_lt; apply Rmult_lt_0_compat; lra). assert (Hnu : 0 < nu) by (assert (0 < g1 * (b * l1 ^ n) ^ 2) by (apply
      Rmult_lt_0_compat; lra); lra). assert (Hsn : 0 < sqrt nu) by (apply sqrt_lt_R0; lra).
    assert (Esn : sqrt nu ^ 2 = nu) by (simpl; rewrite Rmult_1_r; apply sqrt_sqrt; lra).
    set (be := b / sqrt nu). assert (Pbe : 0 < be) by (unfold be; apply Rdiv_lt_0_compat; lra).
    set (B := be * l1 ^ n). assert (PB : 0 < B) by (apply Rmult_lt_0_compat; lra). assert (EB : B ^ 2 * nu = (b * l1 ^
      n) ^ 2). { unfold B, be. rewrite <- Esn at 2. field. lra. } assert (HB2 : B ^ 2 * g1 <= 1).
  { apply (Rmult_le_reg_r nu); [lra|]. replace (B ^ 2 * g1 * nu) with (g1 * (B ^ 2 * nu)) by ring. rewrite EB. lra. }
  assert (HB1 : 1 <= B ^ 2 * g2).
  { apply (Rmult_le_reg_r nu); [lra|]. replace (B ^ 2 * g2 * nu) with (g2 * (B ^ 2 * nu)) by ring. rewrite EB. lra. }
  assert (HBone : 1 <= B).
  { apply Rnot_lt_le. intros F. assert (B ^ 2 <= 1) by (rewrite <- (pow1 2); apply pow_incr; lra).
    assert (B ^ 2 * g2 <= 1 * g2) by (apply Rmult_le_compat_r; lra). lra. }
  assert (Hep : nu / ((l1 - l2) * b) ^ 2 <= e0).
  { replace (nu / ((l1 - l2) * b) ^ 2) with ((l1 ^ n / (l1 - l2)) ^ 2 / B ^ 2).
    2:{ unfold B, be. rewrite <- Esn at 2. field. repeat split; lra. }
    assert (R1 : l1 ^ n / (l1 - l2) <= e0) by (apply div_le; lra). assert (R0 : 0 < l1 ^ n / (l1 - l2)) by (apply
      Rdiv_lt_0_compat; lra). apply div_le; [apply pow_lt; lra|]. assert (1 <= B ^ 2) by (rewrite <- (pow1 2);
      apply pow_incr; lra). apply Rle_trans with (e0 ^ 2); [apply pow_incr; lra|]. assert (e0 * e0 <= e0 * B ^ 2) by
      (apply Rmult_le_compat_l; lra). lra. }
  assert (Pep : 0 < nu / ((l1 - l2) * b) ^ 2).
  { apply Rdiv_lt_0_compat; [lra|]. apply pow_lt. apply Rmult_lt_0_compat; lra. }
  set (ep := nu / ((l1 - l2) * b) ^ 2) in *. assert (Lep : l1 * ep <= 1 * ep) by (apply Rmult_le_compat_r;
    lra). assert (Hbe2 : S0 <= be / 2).
  { assert (Q : l1 ^ n * (2 * S0) <= 1).
    { apply (Rmult_le_compat_r (2 * S0)) in A3; [|lra]. rewrite Rinv_l in A3 by lra. exact A3. }
    assert (be * l1 ^ n >= 1) by (fold B; lra). apply (Rmult_le_reg_r (l1 ^ n)); [lra|]. lra. }
  assert (H3 : 0 < sqrt 3) by (apply sqrt_lt_R0; lra). assert (E3 : sqrt 3 ^ 2 = 3) by (simpl;
    rewrite Rmult_1_r; apply sqrt_sqrt; lra). apply (gap l1 l2 b d mu0 g0 g1 nu n); try assumption;
    fold ep M E1 be B; try lia; try lra.
  - apply Rnot_lt_le. intros F. assert (PX : 0 < mu0 * 2 / sqrt 3) by (apply Rdiv_lt_0_compat; lra). assert (X : (mu0
      * 2 / sqrt 3) ^ 2 = 1 / g2).
    { replace ((mu0 * 2 / sqrt 3) ^ 2) with (mu0 ^ 2 * 4 / sqrt 3 ^ 2) by (field; lra). rewrite Emu, E3. field. lra. }
    assert (Y : 0 < (mu0 * 2 / sqrt 3 - B) * (mu0 * 2 / sqrt 3 + B)) by (apply Rmult_lt_0_compat; lra).
    assert (Z : 1 / g2 <= B ^ 2) by (apply div_le; lra). rewrite <- X in Z. lra.
  - apply (Rmult_le_compat_r (l1 / (l1 - l2))) in A2; [|left; apply Rdiv_lt_0_compat; lra]. replace ((1 - g0 / g1) / 4
      * ((l1 - l2) / l1) * (l1 / (l1 - l2))) with ((1 - g0 / g1) / 4) in A2 by (field; repeat split; lra). lra.
  - unfold S0 in Hbe2. lra.
  - unfold S0 in Hbe2. lra.
Qed.
