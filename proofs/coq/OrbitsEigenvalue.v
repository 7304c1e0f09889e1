(** * The eigenvalue of (35), (36): where each flight of an orbit near grazing has a derivative, this is nearly
      - (C A^n .) B / (2 y); so B is nearly an eigenvector of what they make together *)
From Coq Require Import Reals FunctionalExtensionality Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPeriodic StatementUniform StatementUnstable
  FreeFlight Finite OrbitVectors OrbitRemainder Orbits OrbitsNear Derivatives Contraction OrbitsUnstable.
Import Map.
Open Scope R_scope.

(** ** One flight *)
Section Flight.
Variables (M : Map.t) (w : vec) (e : R) (n_max k : nat) (m mc b eps small d mu r : R) (x : vec) (D : nat -> vec).
Notation N := (N M).
Notation power := (power M).
Notation hit k x := (h M (fly M mu k x) mu).
Hypothesis Hm : 1 <= m /\ forall k t x, (k <= n_max)%nat -> 0 <= t -> within N t x -> within N (m * t) (power k x).
Hypothesis Hc : 0 <= mc /\ forall t x, within N t x -> Rabs (dot N (C M) x) <= mc * t.
Hypothesis HB : 0 <= b /\ within N b (B M).
Hypothesis Heps : 0 < eps <= 1.
Hypothesis Hsmall : 0 < small <= eps.
Hypothesis HR : remainder M w e n_max eps d.
Hypothesis Hmu : Rabs mu <= d.
Hypothesis Hr : 0 < r.
Hypothesis Near : forall p, within N r (minus p x) -> slow M n_max small d mu k p /\
  forall i, (i < N)%nat -> Nat.iter k (step M mu) p i = go M mu k p i.
Hypothesis HD : derivative_at N (Nat.iter k (step M mu)) D x.
Let y := speed_at M mu k x.
Let K := mc * m + 1.
Let c v := dot N (C M) (power k v).
Lemma slow_here : slow M n_max small d mu k x.
Proof. apply Near; intros i _; unfold minus; rewrite Rminus_eq_0, Rabs_R0; lra. Qed.
Lemma y_pos : 0 < y /\ 2 * y <= eps.
Proof. pose proof slow_here as S; split; [apply (speed_square M n_max small d mu k x S) | destruct S as [_ _ _ [A _]];
  unfold y; lra]. Qed.
Lemma c_bound q v : 0 <= q -> within N q v -> Rabs (c v) <= mc * m * q.
Proof. intros Hq Hv; destruct slow_here as [[_ Hk] _ _ _]; rewrite Rmult_assoc; apply Hc, Hm; assumption. Qed.

Lemma finite_step v q delta : 0 <= q -> within N q v -> 0 < delta -> exists s, Rabs (s * (2 * y) + c v) <= eps * q +
  delta /\ forall i, (i < N)%nat -> Rabs (mult N D v i - s * B M i) <= eps * (q + Rabs s) + m * q + delta.
Proof.
  intros Hq Hv Hdl; pose proof y_pos as [Hy _]; pose proof slow_here as Sx; destruct Hm as [m1 Pw], Hc as [mc0 Cw].
  assert (HK : 1 <= K) by (assert (0 <= mc * m) by (apply Rmult_le_pos; lra); unfold K; lra).
  destruct (HD (delta / (q + 1))) as (r1 & Hr1 & Der); [apply Rdiv_lt_0_compat; lra|].
  destruct (small_enough r q Hr Hq) as (h1 & P1 & Q1), (small_enough r1 q Hr1 Hq) as (h2 & P2 & Q2),
    (small_enough delta ((K * q / y) * (K * q / y)) Hdl (Rle_0_sqr _)) as (h3 & P3 & Q3).
  destruct (two_least h1 h2 ltac:(lra) ltac:(lra)) as (h4 & P4 & L1 & L2), (two_least h4 h3 P4 ltac:(lra)) as (hh & Hh &
    L3 & L4).
  assert (Le : forall a g, 0 <= a -> hh <= g -> a * hh <= a * g) by (intros; apply Rmult_le_compat_l; assumption).
  set (p := comb 1 hh x v); assert (Ep : minus p x = comb hh 0 v v) by (extensionality i; unfold p, minus, comb; ring).
  assert (Wp : within N (hh * q) (minus p x)).
  { rewrite Ep; intros i Hi; unfold comb; replace (hh * v i + 0 * v i) with (hh * v i) by ring; rewrite Rabs_mult,
      (Rabs_pos_eq hh) by lra; apply Rmult_le_compat_l; [lra | apply Hv, Hi]. }
  destruct (Near p) as [Sp Gp]; [apply within_le with (hh * q); [pose proof (Le q h1 Hq ltac:(lra)); lra | exact Wp]|].
  destruct (Near x) as [_ Gx]; [intros i _; unfold minus; rewrite Rminus_eq_0, Rabs_R0; lra|].
  destruct (speed_square M n_max small d mu k x Sx) as [E _], (speed_square M n_max small d mu k p Sp) as [E' Y'].
  destruct Sx as [Hk Nx _ [_ Y1]], Sp as [_ Np _ [_ Y1']]; fold y in E, Y1; set (y' := speed_at M mu k p) in *; set (s
    := y' - y). assert (Hhq : 0 <= hh * q) by (apply Rmult_le_pos; lra).
  assert (Cp : dot N (C M) (power k (minus p x)) = hh * c v).
  { rewrite Ep; unfold c, StatementOrbits.power; rewrite power_comb, dot_comb; ring. }
  assert (Zm : Rabs (mu - mu) <= hh * q) by (rewrite Rminus_eq_0, Rabs_R0; lra).
  assert (H3 : Rabs (hit k p - hit k x - hh * c v) <= eps * (hh * q)).
  { destruct (HR k p x 0 0 mu mu (hh * q)) as (_ & _ & A); trivial; try lia; try (rewrite ?Rminus_eq_0, Rabs_R0; lra).
    rewrite Cp, Rminus_eq_0, Rmult_0_l, Rminus_0_r in A; exact A. }
  pose proof (c_bound q v Hq Hv) as Bc; assert (Es : s * (y + y') = - (hit k p - hit k x)) by (unfold s; lra).
  assert (Bs : Rabs s <= hh * (K * q / y)).
  { apply Rmult_le_reg_r with y; [exact Hy|]; replace (hh * (K * q / y) * y) with (hh * (mc * m * q) + 1 * (hh * q)) by
      (unfold K; field; lra). apply Rle_trans with (Rabs s * (y + y')); [apply Rmult_le_compat_l; [apply Rabs_pos |
        lra]|].
    rewrite <- (Rabs_pos_eq (y + y')), <- Rabs_mult, Es, Rabs_Ropp by lra.
    assert (hh * Rabs (c v) <= hh * (mc * m * q)) by (apply Rmult_le_compat_l; lra).
    assert (eps * (hh * q) <= 1 * (hh * q)) by (apply Rmult_le_compat_r; lra); rewrite <- (Rabs_pos_eq hh) in H by lra;
      rewrite <- Rabs_mult in H. rewrite (Rabs_pos_eq hh) in H by lra; apply from in H3; lra. }
  assert (Bss : s * s <= hh * delta).
  { assert (A : Rabs s * Rabs s <= hh * (K * q / y) * (hh * (K * q / y))) by (apply Rmult_le_compat; try apply Rabs_pos;
      assumption). rewrite <- Rabs_mult, Rabs_pos_eq in A by apply Rle_0_sqr. apply Rle_trans with (1 := A).
    replace (hh * (K * q / y) * (hh * (K * q / y))) with (hh * (K * q / y * (K * q / y) * hh)) by ring; apply
      Rmult_le_compat_l; [lra|]. apply Rle_trans with (2 := Q3), Le; [apply Rle_0_sqr | exact L4]. }
  pose proof (Rle_0_sqr s) as S0; unfold Rsqr in S0; exists (s / hh); split.
  - apply Rmult_le_reg_l with hh; [exact Hh|]; rewrite <- (Rabs_pos_eq hh) at 1 by lra; rewrite <- Rabs_mult.
    replace (hh * (s / hh * (2 * y) + c v)) with (- (hit k p - hit k x - hh * c v) - s * s) by (replace (s * s) with (s
      * (y + y')
      - s * (2 * y)) by (unfold s; ring); rewrite Es; field; lra). apply le_abs in H3; apply Rabs_le; lra.
  - intros i Hi; destruct (HR k p x y' y mu mu (hh * q + Rabs s)) as (R1 & _); pose proof (Rabs_pos s) as Ps; trivial;
      try lia; try (rewrite Rabs_pos_eq; lra); try (rewrite Rminus_eq_0, Rabs_R0; lra).
    { apply within_le with (2 := Wp); lra. } { unfold s in *; lra. }
    specialize (R1 i Hi); unfold rest1 in R1; rewrite (Rabs_pos_eq y), (Rabs_pos_eq y') in R1 by lra.
    specialize (Der p (hh * q) ltac:(pose proof (Le q h2 Hq ltac:(lra)); lra) Wp i Hi); cbv beta in Der; rewrite Gp, Gx
      in Der by exact Hi. assert (Em : mult N D (minus p x) i = hh * mult N D v i) by (rewrite Ep; unfold mult; rewrite
        dot_comb; ring).
    rewrite Em in Der; assert (Dq : delta / (q + 1) * (hh * q) <= delta * hh).
    { replace (delta / (q + 1) * (hh * q)) with (delta * hh * (q / (q + 1))) by (field; lra); rewrite <- (Rmult_1_r
        (delta * hh)) at 2; apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|]; apply Rmult_le_reg_r with (q + 1);
          [lra|];
        replace (q / (q + 1) * (q + 1)) with q by (field; lra); lra. }
    assert (Pk : power k p i - power k x i = hh * power k v i).
    { change (power k p i - power k x i) with (minus (power k p) (power k x) i); unfold StatementOrbits.power; rewrite
        <- power_minus, Ep, power_comb; unfold comb; ring. }
    pose proof (Pw k q v ltac:(lia) Hq Hv i Hi) as Bp; assert (Bp' : Rabs (hh * power k v i) <= hh * (m * q)) by
      (rewrite Rabs_mult, (Rabs_pos_eq hh) by lra; apply Rmult_le_compat_l; lra).
    unfold go in Der; fold y y' in Der; apply Rmult_le_reg_l with hh; [exact Hh|]; rewrite <- (Rabs_pos_eq hh) at 1 by
      lra; rewrite <- Rabs_mult. replace (hh * (mult N D v i - s / hh * B M i)) with (hh * mult N D v i - s * B M i) by
        (field; lra).
    assert (Ea : hh * Rabs (s / hh) = Rabs s) by (unfold Rdiv; rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq hh) by lra;
      field; lra).
    replace (hh * (eps * (q + Rabs (s / hh)) + m * q + delta)) with (eps * (hh * q + hh * Rabs (s / hh)) + hh * (m * q)
      + delta * hh) by ring; rewrite Ea. apply le_abs in R1, Der, Bp'; unfold s in *; apply Rabs_le; lra.
Qed.

(** Along B as the coordinate i0 tells. *)
Variable i0 : nat.
Hypothesis Hi0 : (i0 < N)%nat /\ B M i0 <> 0.
Let beta := Rabs (B M i0).
Let G := 1 + / beta + b / beta.
Definition part (D : nat -> vec) (v : vec) : R := mult N D v i0 / B M i0.
Lemma derivative_is v q : 0 <= q -> within N q v -> let E := eps + eps * (2 + K + m) * G in
  Rabs (2 * y * part D v + c v) <= E * q /\ forall i, (i < N)%nat -> Rabs (2 * y * (mult N D v i - part D v * B M i)) <=
    E * q.
Proof.
  intros Hq Hv E; pose proof y_pos as [Hy He]; destruct Hm as [m1 _], Hc as [mc0 _], HB as [b0 Bb], Hi0 as [N0 B0].
  assert (Pb : 0 < beta) by (apply Rabs_pos_lt, B0); assert (Pi : 0 < / beta) by (apply Rinv_0_lt_compat, Pb).
  assert (Pbb : 0 <= b / beta) by (apply Rmult_le_pos; lra); assert (HG : 1 <= G) by (unfold G; lra).
  assert (HK : 1 <= K) by (assert (0 <= mc * m) by (apply Rmult_le_pos; lra); unfold K; lra).
  set (F := eps * (2 + K + m)); assert (HF : 0 <= F * q) by (repeat apply Rmult_le_pos; lra).
  pose proof (c_bound q v Hq Hv) as Bc.
  assert (All : forall delta, 0 < delta -> Rabs (2 * y * part D v + c v) <= E * q + delta /\
    forall i, (i < N)%nat -> Rabs (2 * y * (mult N D v i - part D v * B M i)) <= E * q + delta).
  { intros delta Hdl; set (dl := delta / (3 * G)); assert (Hd' : 0 < dl) by (apply Rdiv_lt_0_compat; lra).
    assert (Ed : dl * (3 * G) = delta) by (unfold dl; field; lra).
    destruct (finite_step v q dl Hq Hv Hd') as (s & S1 & S2); assert (Bs : Rabs s * (2 * y) <= K * q + dl).
    { rewrite <- (Rabs_pos_eq (2 * y)), <- Rabs_mult by lra; replace (s * (2 * y)) with ((s * (2 * y) + c v) - c v) by
      ring. pose proof (apart (s * (2 * y) + c v) (c v)); assert (eps * q <= 1 * q) by (apply Rmult_le_compat_r; lra);
        unfold K; lra. }
    assert (S3 : forall i, (i < N)%nat -> Rabs (2 * y * (mult N D v i - s * B M i)) <= F * q + 2 * dl).
    { intros i Hi; specialize (S2 i Hi); rewrite Rabs_mult, (Rabs_pos_eq (2 * y)) by lra.
      apply Rle_trans with (2 * y * (eps * (q + Rabs s) + m * q + dl)); [apply Rmult_le_compat_l; lra|].
      replace (2 * y * (eps * (q + Rabs s) + m * q + dl)) with (eps * (2 * y * q + Rabs s * (2 * y)) + 2 * y * (m * q) +
        2 * y * dl) by ring.
      assert (2 * y * q <= 1 * q) by (apply Rmult_le_compat_r; lra); assert (2 * y * dl <= 1 * dl) by (apply
        Rmult_le_compat_r; lra). assert (0 <= m * q) by (apply Rmult_le_pos; lra); assert (2 * y * (m * q) <= eps * (m *
          q)) by (apply
        Rmult_le_compat_r; lra). assert (eps * (2 * y * q + Rabs s * (2 * y)) <= eps * (q + (K * q + dl))) by (apply
        Rmult_le_compat_l; lra). assert (eps * dl <= 1 * dl) by (apply Rmult_le_compat_r; lra); assert (0 <= eps * q) by
          (apply
        Rmult_le_pos; lra). unfold F; lra. }
    assert (S4 : Rabs (2 * y * (part D v - s)) <= (F * q + 2 * dl) * / beta).
    { apply Rmult_le_reg_r with beta; [exact Pb|]; replace ((F * q + 2 * dl) * / beta * beta) with (F * q + 2 * dl) by
        (field; lra); unfold beta; rewrite <- Rabs_mult. replace (2 * y * (part D v - s) * B M i0) with (2 * y * (mult N
          D v i0 - s * B M i0)) by (unfold part; field;
        exact B0). apply S3, N0. }
    assert (X0 : 0 <= dl * / beta) by (apply Rmult_le_pos; lra); assert (X1 : 0 <= dl * (b / beta)) by (apply
      Rmult_le_pos; lra).
    assert (Y0 : 0 <= F * q * / beta) by (apply Rmult_le_pos; lra); assert (Y1 : 0 <= F * q * (b / beta)) by (apply
      Rmult_le_pos; lra). assert (Z0 : 0 <= eps * q) by (apply Rmult_le_pos; lra).
    assert (EE : E * q + delta = eps * q + F * q + F * q * / beta + F * q * (b / beta) + 3 * dl + 3 * (dl * / beta) + 3
      * (dl * (b / beta))) by (rewrite <- Ed; unfold E, G; fold F; ring). rewrite EE; split.
    - replace (2 * y * part D v + c v) with ((s * (2 * y) + c v) + 2 * y * (part D v - s)) by ring; eapply Rle_trans;
        [apply Rabs_triang|]; lra.
    - intros i Hi; specialize (S3 i Hi); specialize (Bb i Hi).
      replace (2 * y * (mult N D v i - part D v * B M i)) with (2 * y * (mult N D v i - s * B M i) - 2 * y * (part D v -
        s) * B M i) by ring. pose proof (apart (2 * y * (mult N D v i - s * B M i)) (2 * y * (part D v - s) * B M i)) as
          A.
      pose proof (product _ _ _ _ S4 Bb) as A'; replace ((F * q + 2 * dl) * / beta * b) with (F * q * (b / beta) + 2 *
        (dl * (b / beta))) in A' by (field; lra). lra. }
  split; [apply le_epsilon; intros a Ha; apply (All a Ha) | intros i Hi; apply le_epsilon; intros a Ha; apply (All a
    Ha), Hi].
Qed.
End Flight.

(** ** All flights: B and a little, which contracts *)
Section Directions.
Variables (N : nat) (J : Type) (next prev : J -> J) (D : J -> nat -> vec) (B : vec) (i0 : nat) (tau : J -> R) (c : J ->
  vec -> R) (b K kappa rho E eps : R).
Notation part j := (fun v => mult N (D j) v i0 / B i0).
Hypothesis Hnext : forall j, prev (next j) = j /\ next (prev j) = j.
Hypothesis Htau : forall j, 0 < tau j.
Hypothesis Hlin : forall j u v, c j (comb 1 (-1) u v) = c j u - c j v.
Hypothesis Hcb : forall j q v, 0 <= q -> within N q v -> Rabs (c j v) <= K * q.
Hypothesis Hk : 0 < kappa /\ forall j, kappa <= Rabs (c j B).
Hypothesis HB : 0 <= b /\ within N b B.
Hypothesis HD : forall j v q, 0 <= q -> within N q v -> Rabs (tau j * part j v + c j v) <= E * q /\
  forall i, (i < N)%nat -> Rabs (tau j * (mult N (D j) v i - part j v * B i)) <= E * q.
Hypothesis HK : 0 <= K.
Hypothesis Hrho : 0 < rho <= 1 /\ K * rho <= kappa / 4 /\ K * rho <= eps / 2 /\ rho <= eps.
Hypothesis HE : 0 <= E <= 1 /\ 4 * (E * (b + 1)) <= kappa * rho /\ 8 * E <= kappa /\
  16 * (E * (b + 1) * (K + 1)) <= kappa * kappa /\ E * (b + 1) <= eps / 2.
Definition along (z : J * nat -> R) (j : J) : vec := fun i => B i + z (j, i).
Let g j v := tau j * part j v.
Let rest j v i := tau j * (mult N (D j) v i - part j v * B i).
Let T (z : J * nat -> R) (p : J * nat) : R := let j := prev (fst p) in rest j (along z j) (snd p) / g j (along z j).
Notation near := (near (J * nat) (fun p => (snd p < N)%nat)).
Notation o := (fun _ : J * nat => 0).
Lemma inside z j : near rho z o -> within N (b + 1) (along z j) /\ Rabs (g j (along z j) + c j B) <= K * rho + E * (b +
  1) /\ kappa / 2 <= Rabs (g j (along z j)) /\ forall i, (i < N)%nat -> Rabs (rest j (along z j) i) <= E * (b + 1).
Proof.
  intros Hz; destruct HB as [b0 Bb], Hk as [k0 Kb], HE as ((e0 & e1) & E1 & _), Hrho as ((r0 & r1) & R1 & _).
  assert (Wz : within N rho (fun i => z (j, i))) by (intros i Hi; specialize (Hz (j, i) Hi); rewrite Rminus_0_r in Hz;
    exact Hz).
  assert (W : within N (b + 1) (along z j)) by (intros i Hi; unfold along; apply triangle2; [apply Bb, Hi | apply
    Rle_trans with rho; [apply Wz, Hi | exact r1]]).
  destruct (HD j (along z j) (b + 1) ltac:(lra) W) as [A1 A2]; fold (g j (along z j)) in A1; pose proof (Kb j) as Kj.
  pose proof (Hcb j rho _ (Rlt_le _ _ r0) Wz) as Cz; assert (Ec : c j (along z j) - c j B = c j (fun i => z (j, i))).
  { rewrite <- Hlin; f_equal; extensionality i; unfold comb, along; ring. }
  assert (A3 : Rabs (g j (along z j) + c j B) <= K * rho + E * (b + 1)) by (apply le_abs in A1, Cz; apply Rabs_le; lra).
  assert (X : kappa * rho <= kappa * 1) by (apply Rmult_le_compat_l; lra).
  split; [exact W | split; [exact A3 | split; [|exact A2]]]; pose proof (apart (g j (along z j) + c j B) (g j (along z
    j))) as A4.
  replace (g j (along z j) + c j B - g j (along z j)) with (c j B) in A4 by ring; lra.
Qed.
Lemma over a x t : kappa / 2 <= Rabs x -> Rabs a <= t -> Rabs (a / x) <= 2 * t / kappa.
Proof.
  intros Hx Ha; destruct Hk as [k0 _]; pose proof (Rabs_pos a); unfold Rdiv; rewrite Rabs_mult, Rabs_inv.
  assert (/ Rabs x <= 2 * / kappa) by (replace (2 * / kappa) with (/ (kappa / 2)) by (field; lra); apply
    Rinv_le_contravar; lra). replace (2 * t * / kappa) with (t * (2 * / kappa)) by ring; apply Rmult_le_compat; trivial;
      left;
    apply Rinv_0_lt_compat; lra.
Qed.
Theorem directions : exists V lambda, forall j, within N eps (minus (V j) B) /\ (forall i, (i < N)%nat -> mult N (D j)
  (V j) i = lambda j * V (next j) i) /\ Rabs (lambda j * tau j + c j B) <= eps.
Proof.
  pose proof Hk as [k0 _]; pose proof HE as ((e0 & e1) & E1 & E2 & E3 & E4); pose proof Hrho as ((r0 & r1) & R1 & R2 &
    R3); pose proof HB as [b0 _].
  destruct (contraction (J * nat) (fun p => (snd p < N)%nat) T rho) as (z & Hz & Fix & _); [lra| | |].
  - intros a z z' Hz Hz' Hzz (j & i) Hi; cbn [snd] in Hi; unfold T; cbn [fst snd]; set (l := prev j); set (v := along z
      l); set (v' := along z' l). destruct (inside z l Hz) as (_ & _ & G1 & Q1), (inside z' l Hz') as (_ & _ & G2 & Q2);
        fold v in
      G1, Q1; fold v' in G2, Q2. assert (a0 : 0 <= a) by (eapply Rle_trans; [apply Rabs_pos | exact (Hzz (j, i) Hi)]).
    assert (W : within N a (comb 1 (-1) v v')).
    { intros h Hh; specialize (Hzz (l, h) Hh); unfold comb, v, v', along; replace (1 * (B h + z (l, h)) + -1 * (B h + z'
        (l, h))) with (z (l, h) - z' (l, h)) by ring; exact Hzz. }
    destruct (HD l _ a a0 W) as [A1 A2]; specialize (A2 i Hi); pose proof (Hcb l a _ a0 W) as A3.
    assert (Lg : tau l * part l (comb 1 (-1) v v') = g l v - g l v') by (unfold g, mult, Rdiv; rewrite dot_comb; ring).
    assert (Lr : tau l * (mult N (D l) (comb 1 (-1) v v') i - part l (comb 1 (-1) v v') * B i) = rest l v i - rest l v'
      i) by (unfold rest, mult, Rdiv; rewrite !dot_comb; ring). rewrite Lg in A1; rewrite Lr in A2.
    assert (N1 : g l v <> 0) by (intros Z; rewrite Z, Rabs_R0 in G1; lra);
      assert (N2 : g l v' <> 0) by (intros Z; rewrite Z, Rabs_R0 in G2; lra).
    replace (rest l v i / g l v - rest l v' i / g l v') with ((rest l v i - rest l v' i) / g l v - rest l v' i / g l v'
      * (g l v - g l v') / g l v) by (field; auto).
    assert (A4 : Rabs (g l v - g l v') <= (K + 1) * a).
    { assert (E * a <= 1 * a) by (apply Rmult_le_compat_r; lra); apply le_abs in A1, A3; apply Rabs_le; lra. }
    pose proof (over _ _ _ G1 A2) as B1; pose proof (product _ _ _ _ (over _ _ _ G2 (Q2 i Hi)) A4) as B2;
      pose proof (over _ _ _ G1 B2) as B3.
    eapply Rle_trans; [apply apart|]; apply Rle_trans with (2 * (E * a) / kappa + 2 * (2 * (E * (b + 1)) / kappa * ((K +
      1) * a)) / kappa); [lra|].
    apply Rmult_le_reg_r with (kappa * kappa); [apply Rmult_lt_0_compat; lra|].
    replace ((2 * (E * a) / kappa + 2 * (2 * (E * (b + 1)) / kappa * ((K + 1) * a)) / kappa) * (kappa * kappa)) with (a
      * (2 * E * kappa + 4 * (E * (b + 1) * (K + 1)))) by (field; lra). replace (a / 2 * (kappa * kappa)) with (a *
        (kappa * kappa / 2)) by
      field. apply Rmult_le_compat_l; [exact a0|]; assert (8 * E * kappa <= kappa * kappa) by (apply Rmult_le_compat_r;
        lra); lra.
  - intros (j & i) Hi; cbn [snd] in Hi; unfold T; cbn [fst snd]; rewrite Rminus_0_r; assert (Z : near rho o o) by
      (intros p _; rewrite Rminus_eq_0, Rabs_R0; lra). destruct (inside o (prev j) Z) as (_ & _ & G1 & Q1);
      apply Rle_trans with (1 := over _ _ _ G1 (Q1 i Hi)), Rmult_le_reg_r with kappa; [exact k0|].
    replace (2 * (E * (b + 1)) / kappa * kappa) with (2 * (E * (b + 1))) by (field; lra); lra.
  - exists (along z), (fun j => part j (along z j)); intros j; destruct (inside z j Hz) as (_ & A & G1 & _); split;
    [|split].
    + intros i Hi; specialize (Hz (j, i) Hi); rewrite Rminus_0_r in Hz; unfold minus, along; replace (B i + z (j, i) - B
        i) with (z (j, i)) by ring; lra.
    + intros i Hi; pose proof (Fix (next j, i) Hi) as F; unfold T in F; cbn [fst snd] in F; rewrite (proj1 (Hnext j)) in
      F. assert (N1 : g j (along z j) <> 0) by (intros Z; rewrite Z, Rabs_R0 in G1; lra); pose proof (Htau j).
      unfold along at 3; rewrite <- F; unfold g, rest in *; set (p := mult N (D j) (along z j) i0 / B i0) in *.
      assert (p <> 0) by (intros Z; apply N1; rewrite Z; ring); field; split; [assumption | lra].
    + unfold g in A; rewrite (Rmult_comm _ (tau j)); lra.
Qed.
End Directions.

Theorem Eigenvalue : Eigenvalue_statement.
Proof.
  intros M w HM Hw n_max kappa eps Hk He; destruct (power_bound (N M) (A M) n_max) as (m & m1 & Pw), (dot_bound (N M) (C
    M)) as (mc & mc0 & Cw), (within_exists (N M) (B M)) as (b & b0 & Bb).
  destruct (Classical_Prop.classic (exists i0, (i0 < N M)%nat /\ B M i0 <> 0)) as [(i0 & Hi0)|No].
  2:{ exists 1; split; [lra|]; intros J next prev n mu x D _ Hn _ _ _; exists (fun _ => B M), (fun _ => 0); intros j;
      exfalso. destruct (Hn j) as [Nj Cr]; assert (W : within (N M) 0 (B M)) by (intros i Hi; destruct (Req_dec (B M i)
        0) as [->|Z]; [rewrite Rabs_R0; lra | exfalso; apply No; exists i; auto]).
      pose proof (Cw _ _ (Pw (n j) 0 (B M) ltac:(lia) ltac:(lra) W)) as Q; unfold crossing in Cr; unfold
        StatementOrbits.power in *; lra. }
  set (K := mc * m + 1); set (G := 1 + / Rabs (B M i0) + b / Rabs (B M i0)); assert (Pb : 0 < / Rabs (B M i0)) by (apply
    Rinv_0_lt_compat, Rabs_pos_lt, Hi0). assert (HK : 1 <= K) by (assert (0 <= mc * m) by (apply Rmult_le_pos; lra);
      unfold K;
    lra). assert (HG : 1 <= G) by (assert (0 <= b / Rabs (B M i0)) by (apply Rmult_le_pos; lra); unfold G; lra).
  destruct (two_least (kappa / 4) (eps / 2) ltac:(lra) ltac:(lra)) as (q1 & Q1 & Q2 & Q3), (small_enough q1 K Q1
    ltac:(lra)) as (q2 & Q4 & Q5), (two_least q2 eps ltac:(lra) He) as (rho & Hrho & Q6 & Q7).
  assert (Krho : K * rho <= q1) by (apply Rle_trans with (2 := Q5), Rmult_le_compat_l; lra).
  assert (Pk : 0 < kappa * rho) by (apply Rmult_lt_0_compat; lra); assert (Pkk : 0 < kappa * kappa) by (apply
    Rmult_lt_0_compat; lra). destruct (two_least (kappa * rho) (kappa * kappa) Pk Pkk) as (s1 & S1 & S2 & S3),
    (two_least kappa eps Hk He) as (s2 & S4 & S5 & S6), (two_least s1 s2 S1 S4) as (s3 & S7 & S8 & S9), (two_least s3 1
      S7
    ltac:(lra)) as (s & Hs & S10 & S11).
  set (X := (b + 1) * (K + 1)); assert (HX : b + 1 <= X) by (unfold X; rewrite <- (Rmult_1_r (b + 1)) at 1; apply
    Rmult_le_compat_l; lra). assert (PG : 0 <= (2 + K + m) * G) by (apply Rmult_le_pos; lra).
  destruct (small_enough s (16 * X * (1 + (2 + K + m) * G)) Hs ltac:(apply Rmult_le_pos; lra)) as (ep & P1 & P2).
  set (E := ep + ep * (2 + K + m) * G); assert (HE : 16 * (E * X) <= s) by (replace (16 * (E * X)) with (16 * X * (1 +
    (2 + K + m) * G) * ep) by (unfold E; ring); exact P2). assert (E0 : 0 <= E) by (assert (0 <= ep * ((2 + K + m) * G))
      by (apply
    Rmult_le_pos; lra); unfold E; lra). assert (EX : E * (b + 1) <= E * X) by (apply Rmult_le_compat_l; lra).
  assert (E1 : E * 1 <= E * (b + 1)) by (apply Rmult_le_compat_l; lra).
  destruct (there M w n_max ep ep HM Hw ltac:(lra) ltac:(lra)) as (d1 & d & room & Hd & HR & Hroom & There); exists d;
    split;
    [lra|].
  intros J next prev n mu x D Hnext Hn Hmu Orb Der; set (y j := speed_at M mu (n j) (x j)).
  assert (All : forall j, 0 < y j /\ forall v q, 0 <= q -> within (N M) q v -> Rabs (dot (N M) (C M) (power M (n j) v))
    <= K * q /\ Rabs (2 * y j * part M i0 (D j) v + dot (N M) (C M) (power M (n j) v)) <= E * q /\ forall i, (i < N
      M)%nat ->
    Rabs (2 * y j * (mult (N M) (D j) v i - part M i0 (D j) v * B M i)) <= E * q).
  { intros j; destruct (orbit_clear M J next n mu d x j (fun j => proj1 (proj1 (Hn j))) Orb) as (cl & Hcl & Cl).
    set (r := room cl); pose proof (Hroom cl Hcl) as Hr; fold r in Hr. assert (Near : forall p, within (N M) r (minus
      p (x j))
      -> slow M n_max ep d1 mu (n j) p /\ forall i, (i < N M)%nat -> Nat.iter (n j) (step M mu) p i = go M mu (n j) p i)
      by (intros p Hp; destruct (There (n j) mu (x j) cl p (proj1 (Hn j)) Hmu (proj1 (Orb j)) Hcl Cl Hp) as (A & _ & B);
        auto). split.
    - apply (y_pos M n_max (n j) ep ep d1 mu r (x j)); trivial; lra.
    - intros v q Hq Hv; split; [|apply (derivative_is M w (dot (N M) (C M) w + eta M) n_max (n j) m mc b ep ep d1 mu r
        (x j) (D j)); trivial; try split; trivial; try lra; intros; apply Pw; trivial].
      pose proof (Cw _ _ (Pw (n j) q v (proj2 (proj1 (Hn j))) Hq Hv)) as Q; unfold K; rewrite <- Rmult_assoc in Q;
        unfold StatementOrbits.power in *; lra. }
  destruct (directions (N M) J next prev D (B M) i0 (fun j => 2 * y j) (fun j v => dot (N M) (C M) (power M (n j) v)) b
    K kappa rho E eps) as (V & lambda & HV); trivial.
  - intros j; destruct (All j); lra.
  - intros j u v; unfold StatementOrbits.power; rewrite power_comb, dot_comb; ring.
  - intros j q v Hq Hv; apply (proj2 (All j) v q Hq Hv).
  - split; [lra | intros j; destruct (Hn j) as [_ Cr]; unfold crossing in Cr; lra].
  - split; assumption.
  - intros j v q Hq Hv; apply (proj2 (All j) v q Hq Hv).
  - lra.
  - assert (Ex : E * (b + 1) * (K + 1) = E * X) by (unfold X; ring); repeat split; rewrite ?Ex; lra.
  - exists V, lambda; intros j; destruct (HV j) as (V1 & V2 & V3); split; [exact V1 | split; [exact V2|]].
    assert (HnJ : forall j, (1 <= n j)%nat) by (intros j'; apply Hn); destruct (orbit_zero M mu J next n HnJ d x Orb) as
      [Z S].
    destruct (proj1 (zero_meaning M mu J next n x (speed M mu J n x)) Z j) as [Eh _], (S j) as [Pos _]; assert (Ey : y j
      = speed M mu J n x j) by (unfold y, speed_at; rewrite Eh, Ropp_involutive; apply sqrt_square; lra).
    unfold speed in Ey, Pos; cbv zeta; rewrite <- Ey; split; [lra | exact V3].
Qed.
