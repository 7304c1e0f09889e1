(** * The law of impact is a contraction of sequences of phases, and all impacts near the touch are in its domain *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOscillator Derivatives Flow OscillatorTurns OscillatorStop Contraction.
Open Scope R_scope.

Section Law.
Variables (O : Oscillator.t) (m : sign) (S V : R -> R).
Notation c := (Oscillator.c O).
Notation k := (Oscillator.k O).
Notation tau := (Oscillator.tau O).
Notation G := (Oscillator.G O).
Notation G1 := (Oscillator.G1 O).
Notation g := (Oscillator.G2 O 0 0).
Notation e11 := (e11 c S V).
Notation turned := (turned m).
Notation T := (turn m).
Notation place := (place O).
Notation chord := (chord O).
Notation aft0 := (aft0 c m S V).
Notation bef0 := (bef0 c k m S V).
Hypothesis HO : touching O.
Hypothesis Htau : 0 <= tau.
Hypothesis HS : flow c k S V.
Variables (n_max : nat) (K : R).
Hypothesis HK : bounds c k m S V n_max K.

(** Velocities just after an impact at the time mu x, before the one n turns and mu y later, and the place j turns
    on the way; in units of mu. *)
Definition aft n mu x y := aft_leg c m S V n (mu * (y - x)) (place mu x) (place mu y).
Definition bef n mu x y := bef_leg c k m S V n (mu * (y - x)) (place mu x) (place mu y).
Definition mid n j mu x y := turned e11 j (- (mu * x)) * place mu x + turned S j (- (mu * x)) * aft n mu x y.
Definition mid0 n j := turned e11 j 0 * -1 + turned S j 0 * aft0 n.

Definition regular (n : nat) : Prop := (1 <= n <= n_max)%nat /\ turned S n 0 <> 0.

Record leg_near (n : nat) (eps mu x y : R) : Prop := {
  near_S : turned S n (mu * (y - x)) <> 0;
  near_aft : Rabs (aft n mu x y - aft0 n) <= eps;
  near_bef : Rabs (bef n mu x y - bef0 n) <= eps;
  near_place : Rabs (place mu x) <= 2;
  near_mid : forall j, (j <= n_max)%nat -> Rabs (mid n j mu x y - mid0 n j) <= eps }.

Lemma legs_near : exists B, 0 <= B /\ forall h eps, 0 <= h -> 0 < eps -> exists d, 0 < d <= 1 /\
  forall n mu x y, regular n -> 0 < Rabs mu <= d -> Rabs x <= h -> Rabs y <= h ->
  leg_near n eps mu x y /\ Rabs (chord mu x) <= B + eps /\
  forall x' y' r, Rabs x' <= h -> Rabs y' <= h -> Rabs (x - x') <= r -> Rabs (y - y') <= r ->
  Rabs (aft n mu x y - aft n mu x' y') <= eps * r /\ Rabs (bef n mu x y - bef n mu x' y') <= eps * r /\
  Rabs (chord mu x - chord mu x') <= eps * r.
Proof.
  destruct (places O HO) as (B & HB & P); exists B; split; [exact HB|]; intros h eps Hh He.
  assert (K1 : 1 <= K) by apply HK; assert (IK : 0 < / K) by (apply Rinv_0_lt_compat; lra).
  set (L := 18 * K ^ 5); assert (HL : 18 <= L) by (unfold L; pose proof (pow_R1_Rle K 5 K1); lra).
  destruct (two_least eps (/ K) He IK) as (e0 & E0 & L1 & L2).
  set (Y := (h + 1) * (K * (3 + 3 * L))); assert (HY : 0 < Y) by (unfold Y; repeat apply Rmult_lt_0_compat; lra).
  set (e := e0 / Y); assert (Ee : 0 < e) by (apply Rdiv_lt_0_compat; lra).
  set (z := e * (h + 1)); assert (Ez : z * (K * (3 + 3 * L)) = e0).
  { replace (z * (K * (3 + 3 * L))) with (e0 / Y * Y) by (unfold z, e, Y; ring); field; lra. }
  assert (eh : 0 <= e * h) by (apply Rmult_le_pos; lra); assert (Zp : 0 < z /\ e <= z /\ e * h <= z) by (unfold z;
    lra).
  assert (ZK : z <= K * z) by (rewrite <- (Rmult_1_l z) at 1; apply Rmult_le_compat_r; lra).
  assert (Lz : 18 * z <= L * z) by (apply Rmult_le_compat_r; lra).
  assert (ZL : L * z <= K * (L * z)) by (rewrite <- (Rmult_1_l (L * z)) at 1; apply Rmult_le_compat_r; lra).
  assert (Sum : 3 * (K * z) + 3 * (K * (L * z)) = e0) by (rewrite <- Ez; ring).
  destruct (P h e Hh Ee) as (d1 & D1 & P1); destruct (two_least d1 (e / 2) ltac:(lra) ltac:(lra))
    as (d & Hd & D2 & D3).
  exists d; split; [lra|]; intros n mu x y [Hn HSn] Hmu Hx Hy.
  assert (Time : forall x y, Rabs x <= h -> Rabs y <= h -> Rabs (mu * (y - x)) <= z).
  { intros a b Ha Hb; apply (Rle_trans _ (e / 2 * (h + h))); [|lra]; apply product; [lra|].
    pose proof (apart b a); lra. }
  assert (Place : forall x, Rabs x <= h -> Rabs (place mu x - -1) <= z /\ Rabs (place mu x) <= 2).
  { intros a Ha; destruct (P1 mu a a ltac:(lra) Ha Ha) as (_ & Q & _);
      replace (place mu a - -1) with (place mu a + 1) by ring.
    split; [lra|]; replace (place mu a) with (place mu a + 1 - 1) by ring.
    pose proof (apart (place mu a + 1) 1) as A; rewrite Rabs_R1 in A; assert (/ K <= 1); [|lra].
    rewrite <- Rinv_1; apply Rinv_le_contravar; lra. }
  destruct (Place x Hx) as [Px Px2], (Place y Hy) as [Py Py2]; pose proof (Time x y Hx Hy) as Tx.
  assert (T0 : Rabs 0 <= / K) by (rewrite Rabs_R0; lra).
  destruct (two_legs c k m S V n_max K HK n (mu * (y - x)) 0 (place mu x) (place mu y) (-1) (-1) z) as (N & A & A');
    trivial; try lra; [lia | rewrite Rminus_0_r; exact Tx|].
  assert (Aft : Rabs (aft n mu x y - aft0 n) <= L * z) by exact A;
    assert (Bef : Rabs (bef n mu x y - bef0 n) <= L * z) by exact A'.
  split; [constructor|split].
  - exact N.
  - lra.
  - lra.
  - exact Px2.
  - intros j Hj; unfold mid, mid0; assert (Sx : Rabs (- (mu * x) - 0) <= z).
    { rewrite Rminus_0_r, Rabs_Ropp; pose proof (Time 0 x ltac:(rewrite Rabs_R0; lra) Hx) as Q.
      rewrite Rminus_0_r in Q; exact Q. }
    assert (S2 : Rabs (- (mu * x)) <= 2) by (rewrite Rminus_0_r in Sx; assert (/ K <= 1); [|lra];
      rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
    assert (Z2 : Rabs 0 <= 2) by (rewrite Rabs_R0; lra).
    destruct (turned_bounds c k m S V n_max K HK e11 j (- (mu * x)) 0 ltac:(left;
      reflexivity) Hj S2 Z2) as (_ & B1 & B2).
    destruct (turned_bounds c k m S V n_max K HK S j (- (mu * x)) 0 ltac:(right; left;
      reflexivity) Hj S2 Z2) as (B3 & _ & B4).
    destruct (one_leg c k m S V n_max K HK n 0 0 1 (-1) (-1)) as (_ & B5 & _); trivial; try lia;
      try (rewrite Rabs_left; lra).
    change (aft_leg c m S V n 0 (-1) (-1)) with (aft0 n) in B5.
    set (a := aft n mu x y) in *; set (t := - (mu * x)) in *.
    replace (_ - _) with ((turned e11 j t - turned e11 j 0) * place mu x + turned e11 j 0 * (place mu x - -1) +
      (turned S j t * (a - aft0 n) + (turned S j t - turned S j 0) * aft0 n)) by ring.
    assert (Q : K * Rabs (t - 0) <= K * z) by (apply Rmult_le_compat_l; lra).
    assert (Q2 : Rabs (turned e11 j t - turned e11 j 0) <= K * z) by lra.
    assert (Q4 : Rabs (turned S j t - turned S j 0) <= K * z) by lra.
    assert (Q5 : Rabs (aft0 n) <= L) by (unfold L; pose proof (pow_R1_Rle K 5 K1); lra).
    pose proof (product _ _ _ _ Q2 Px2); pose proof (product _ _ _ _ B1 Px); pose proof (product _ _ _ _ B3 Aft).
    pose proof (product _ _ _ _ Q4 Q5).
    eapply Rle_trans; [apply Rabs_triang|]; eapply Rle_trans; [apply Rplus_le_compat; apply Rabs_triang|]; lra.
  - destruct (P1 mu x x ltac:(lra) Hx Hx) as (_ & _ & _ & Q); lra.
  - intros x' y' r Hx' Hy' Rx Ry; destruct (P1 mu x x' ltac:(lra) Hx Hx') as (Qx & _ & C & _).
    destruct (P1 mu y y' ltac:(lra) Hy Hy') as (Qy & _).
    assert (Hr : 0 <= r) by (eapply Rle_trans; [apply Rabs_pos | exact Rx]).
    assert (e * Rabs (x - x') <= e * r) by (apply Rmult_le_compat_l; lra).
    assert (e * Rabs (y - y') <= e * r) by (apply Rmult_le_compat_l; lra).
    assert (Dt : Rabs (mu * (y - x) - mu * (y' - x')) <= e * r).
    { replace (_ - _) with (mu * ((y - y') - (x - x'))) by ring; apply (Rle_trans _ (e / 2 * (r + r))); [|lra].
      apply product; [lra|]; pose proof (apart (y - y') (x - x')); lra. }
    destruct (two_legs c k m S V n_max K HK n (mu * (y - x)) (mu * (y' - x')) (place mu x) (place mu y)
      (place mu x') (place mu y') (e * r)) as (_ & D & D'); trivial; try lra;
        [lia | pose proof (Time x' y' Hx' Hy'); lra|].
    fold L in D, D'; assert (L * (e * r) <= eps * r).
    { rewrite <- Rmult_assoc; apply Rmult_le_compat_r; [exact Hr|].
      apply (Rle_trans _ (L * z)); [apply Rmult_le_compat_l; lra | lra]. }
    assert (e * r <= eps * r) by (apply Rmult_le_compat_r; lra).
    unfold aft, bef; repeat split; lra.
Qed.

(** ** The law: phases mu (x i) are those of a motion *)
Definition law (n : Z -> nat) (mu : R) (x : Z -> R) : Prop := forall i, (1 + tau) * (G1 mu (mu * x i) / mu) =
  - (aft (n i) mu (x i) (x (i + 1)%Z) + tau * bef (n (i - 1)%Z) mu (x (i - 1)%Z) (x i)).
Definition next (n : Z -> nat) (mu : R) (x : Z -> R) (i : Z) : R := chord mu (x i) -
  (aft (n i) mu (x i) (x (i + 1)%Z) + tau * bef (n (i - 1)%Z) mu (x (i - 1)%Z) (x i)) / ((1 + tau) * g).

Lemma law_fixed n mu x : law n mu x <-> forall i, next n mu x i = x i.
Proof.
  pose proof (g_pos O HO) as P; unfold law, next, OscillatorStop.chord.
  assert (E : forall f s y, y - f / g - s / ((1 + tau) * g) - y = - ((1 + tau) * f + s) / ((1 + tau) * g))
    by (intros; field; lra).
  assert (N : 0 < (1 + tau) * g) by (apply Rmult_lt_0_compat; lra).
  split; intros H i; specialize (H i).
  - apply Rminus_diag_uniq; rewrite E, H; field; lra.
  - apply Rminus_diag_eq in H; rewrite E in H; apply (f_equal (fun y => y * ((1 + tau) * g))) in H.
    unfold Rdiv in H; rewrite Rmult_assoc, Rinv_l in H; lra.
Qed.

Lemma weigh a b A : Rabs a <= A -> Rabs b <= A -> Rabs ((a + tau * b) / ((1 + tau) * g)) <= A / g.
Proof.
  intros Ha Hb; pose proof (g_pos O HO) as P; assert (N : 0 < (1 + tau) * g) by (apply Rmult_lt_0_compat; lra).
  unfold Rdiv at 1; rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq ((1 + tau) * g)) by lra.
  apply (Rle_trans _ (((1 + tau) * A) * / ((1 + tau) * g))); [|right; field; lra].
  apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat, N|].
  eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_mult, (Rabs_pos_eq tau) by lra.
  assert (tau * Rabs b <= tau * A) by (apply Rmult_le_compat_l; lra); lra.
Qed.

Lemma same x : Rabs (x - x) <= 0.
Proof. rewrite Rminus_eq_0, Rabs_R0; lra. Qed.

Theorem one_solution : exists h0, 0 <= h0 /\ forall h, h0 <= h -> exists d, 0 < d <= 1 /\ forall n mu,
  (forall i, regular (n i)) -> 0 < Rabs mu <= d -> exists x, (forall i, Rabs (x i) <= h) /\ law n mu x /\
  forall x', (forall i, Rabs (x' i) <= h) -> law n mu x' -> forall i, x' i = x i.
Proof.
  pose proof (g_pos O HO) as P; destruct legs_near as (B & HB & Near).
  assert (K1 : 1 <= K) by apply HK; pose proof (pow_R1_Rle K 5 K1) as K5;
    assert (Pi : 0 < / g) by (apply Rinv_0_lt_compat, P).
  set (M := 6 * K ^ 5); assert (Mg : 0 <= (M + 1) / g) by (apply Rmult_le_pos; unfold M; lra).
  assert (HM : forall n, regular n -> Rabs (aft0 n) <= M /\ Rabs (bef0 n) <= M).
  { intros n [Hn HSn]; destruct (one_leg c k m S V n_max K HK n 0 0 1 (-1) (-1)) as (_ & A & A' & _); trivial;
      try lia;
      try (rewrite ?Rabs_R0, ?Rabs_Ropp, ?Rabs_R1; (lra || left; apply Rinv_0_lt_compat; lra));
      try (rewrite Rabs_left; lra).
    fold M in A, A'; rewrite Rmult_1_r in A, A'; split; assumption. }
  exists (B + (M + 1) / g + 1); split; [lra|]; intros h Hh.
  destruct (two_least (1 / 4) (g / 4) ltac:(lra) ltac:(lra)) as (eps & He & He1 & He2).
  destruct (Near h eps ltac:(lra) He) as (d & Hd & Leg); exists d; split; [exact Hd|]; intros n mu Hn Hmu.
  assert (Heg : eps / g <= 1 / 4) by (apply (Rmult_le_reg_r g); [exact P|]; unfold Rdiv at 1;
    rewrite Rmult_assoc, Rinv_l; lra).
  set (lo := fun _ : Z => - h); set (hi := fun _ : Z => h).
  assert (small : forall x, inside lo hi x <-> forall i, Rabs (x i) <= h).
  { intros x; unfold inside, lo, hi; split; intros H j; specialize (H j); [apply Rabs_le; lra | apply le_abs, H]. }
  destruct (one_fixed_point lo hi (fun _ => 1) (next n mu) (1 / 2) (2 * h)) as (x & I & F & U).
  - intros i; unfold lo, hi; lra.
  - intros; lra.
  - lra.
  - unfold lo, hi; split; [lra | intros; lra].
  - intros x I; rewrite small in *; intros i; unfold next.
    destruct (Leg (n i) mu (x i) (x (i + 1)%Z) (Hn i) Hmu (I i) (I (i + 1)%Z)) as ([_ A _ _ _] & C & _).
    destruct (Leg (n (i - 1)%Z) mu (x (i - 1)%Z) (x i) (Hn _) Hmu (I _) (I _)) as ([_ _ A' _ _] & _).
    apply from in A, A'; pose proof (HM _ (Hn i)); pose proof (HM _ (Hn (i - 1)%Z)).
    eapply Rle_trans; [apply apart|].
    pose proof (weigh (aft (n i) mu (x i) (x (i + 1)%Z)) (bef (n (i - 1)%Z) mu (x (i - 1)%Z) (x i)) (M + 1)
      ltac:(lra) ltac:(lra)); lra.
  - intros r x x' Hr I I' D i; rewrite small in I, I'.
    assert (D' : forall i, Rabs (x i - x' i) <= r) by (intros j; specialize (D j); lra).
    destruct (Leg (n i) mu (x i) (x (i + 1)%Z) (Hn i) Hmu (I i) (I _)) as (_ & _ & Q).
    destruct (Q (x' i) (x' (i + 1)%Z) r) as (A & _ & C); auto.
    destruct (Leg (n (i - 1)%Z) mu (x (i - 1)%Z) (x i) (Hn _) Hmu (I _) (I _)) as (_ & _ & Q').
    destruct (Q' (x' (i - 1)%Z) (x' i) r) as (_ & A' & _); auto.
    pose proof (weigh _ _ _ A A') as W; unfold next.
    match goal with |- Rabs (?e - ?f / ?q - (?e' - ?f' / _)) <= _ =>
      replace (e - f / q - (e' - f' / q)) with ((e - e') - ((f - f') / q)) by (unfold Rdiv; ring) end.
    eapply Rle_trans; [apply apart|].
    match type of W with Rabs (?f / _) <= _ => match goal with |- _ + Rabs (?f' / _)
      <= _ => replace f' with f by ring end end.
    assert (eps * r / g <= 1 / 4 * r).
    { replace (eps * r / g) with (eps / g * r) by (field; lra); apply Rmult_le_compat_r; lra. }
    assert (eps * r <= 1 / 4 * r) by (apply Rmult_le_compat_r; lra); lra.
  - exists x; split; [exact (proj1 (small x) I)|]; split; [apply law_fixed, F|].
    intros x' I' L'; apply U; [exact (proj2 (small x') I') | apply law_fixed, L'].
Qed.

(** ** What a motion says about its phases, whatever they are *)
Definition phase (N : Z -> Z) (t : Z -> R) (i : Z) : R := t i - T * IZR (N i).

Lemma motion_leg mu d N n t q v i : motion O m mu d N t q v -> N (i + 1)%Z = (N i + Z.of_nat n)%Z ->
  let p j := phase N t j in let W j := - mu - G mu (p j) in
  let a := facing m (N i) * v i (t i) in let a' := facing m (N (i + 1)%Z) * v (i + 1)%Z (t (i + 1)%Z) in
  let b := facing m (N (i + 1)%Z) * v i (t (i + 1)%Z) in
  let s := p (i + 1)%Z - p i in
  Rabs (p i) <= d /\ q i (t i) = facing m (N i) * W i /\
  W (i + 1)%Z = turned e11 n s * W i + turned S n s * a /\ b = turned (e21 k S) n s * W i + turned V n s * a /\
  b + G1 mu (p (i + 1)%Z) < 0 /\ a' + G1 mu (p (i + 1)%Z) = - tau * (b + G1 mu (p (i + 1)%Z)).
Proof.
  intros H HN p W a a' b s; destruct (H i _ eq_refl) as (Hf & Hd & _ & Q0 & Q1 & _ & V1 & V2).
  destruct (free_moved c k S V HS _ _ (t i) (t (i + 1)%Z) Hf) as [A B]; unfold moved, moving in A, B.
  unfold gap in Q0, Q1; unfold speed in V1, V2; fold (phase N t i) (phase N t (i + 1)%Z) in Q0, Q1, V1, V2;
    fold (p i) (p (i + 1)%Z) in Q0, Q1, V1, V2.
  assert (ET : t (i + 1)%Z - t i = T * INR n + s).
  { unfold s, p, phase; rewrite HN, plus_IZR, <- INR_IZR_INZ; ring. }
  rewrite ET in A, B; pose proof (side_square m (N i)) as Sq.
  assert (E0 : q i (t i) = facing m (N i) * W i).
  { replace (W i) with (facing m (N i) * q i (t i)) by (unfold W; lra); rewrite <- Rmult_assoc, Sq; ring. }
  rewrite E0 in A, B; rewrite HN, facing_plus in *.
  assert (Ea : v i (t i) = facing m (N i) * a) by (unfold a; rewrite <- Rmult_assoc, Sq; ring).
  rewrite Ea in A, B; unfold OscillatorTurns.turned.
  set (si := facing m (N i)) in *; set (sn := facing m (Z.of_nat n)) in *.
  assert (out : forall f f' y z, si * sn * (f * (si * y) + f' * (si * z)) = sn * f * y + sn * f' * z).
  { intros f f' y z; replace (si * sn * _) with (si * si * (sn * f * y + sn * f' * z)) by ring; rewrite Sq; ring. }
  split; [exact Hd|]; split; [exact E0|]; split; [|split; [|split]].
  - rewrite <- out, <- A; unfold W; lra.
  - rewrite <- out, <- B; unfold b; rewrite HN, facing_plus; reflexivity.
  - unfold b; rewrite HN, facing_plus; exact V1.
  - unfold a', b; rewrite HN, facing_plus; exact V2.
Qed.

Lemma phases_small : exists d C, 0 < d /\ 0 <= C /\ forall mu N n t q v, Rabs mu <= 1 ->
  (forall i, N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\ regular (n i)) ->
  motion O m mu d N t q v -> forall i, Rabs (phase N t i) <= C * Rabs mu.
Proof.
  pose proof (g_pos O HO) as P; destruct (steady_with O HO) as (B & HB & St).
  assert (K1 : 1 <= K) by apply HK; pose proof (pow_R1_Rle K 5 K1) as K5;
    assert (IK : 0 < / K) by (apply Rinv_0_lt_compat; lra).
  set (L := 6 * K ^ 5); assert (HL : 6 <= L) by (unfold L; lra).
  assert (HG4 : 0 < g / (4 * L)) by (apply Rdiv_lt_0_compat; lra).
  assert (G0 : 0 < 2 / g) by (apply Rdiv_lt_0_compat; lra).
  destruct (near_top O HO (g / (4 * L)) HG4) as (d1 & H1 & Near).
  destruct (two_least (/ K / 2) d1 ltac:(lra) H1) as (d & Hd & Hd1 & Hd2).
  set (C := 2 * (2 / g * (L * (1 + B) + B))); assert (C0 : 0 <= C).
  { unfold C; repeat apply Rmult_le_pos; try lra; apply Rplus_le_le_0_compat; [apply Rmult_le_pos|]; lra. }
  exists d, C; split; [exact Hd|]; split; [exact C0|].
  intros mu N n t q v Hmu Hn HM; set (p := phase N t) in *.
  assert (Le : forall j, Rabs (p j) <= d) by (intros j; apply (motion_leg mu d N (n j) t q v j HM), Hn).
  assert (Step : forall D, (forall j, Rabs (p j) <= D) -> forall i, Rabs (p i) <= C / 2 * Rabs mu + D / 2).
  { intros D HD i; set (w := (1 + B) * Rabs mu + g / (4 * L) * D).
    assert (HW : forall j, Rabs (- mu - G mu (p j)) <= w).
    { intros j; eapply Rle_trans; [apply apart|]; rewrite Rabs_Ropp; destruct (St mu (p j) Hmu) as (S0 & _).
      apply from in S0; destruct (Near (p j) ltac:(specialize (Le j); lra)) as [Q _].
      assert (g / (4 * L) * Rabs (p j) <= g / (4 * L) * D) by (apply Rmult_le_compat_l; [lra | apply HD]);
        unfold w; lra. }
    assert (Leg : forall j, Rabs (facing m (N j) * v j (t j)) <= L * w /\
      Rabs (facing m (N (j + 1)%Z) * v j (t (j + 1)%Z)) <= L * w).
    { intros j; destruct (Hn j) as (HN & Hj & HSj).
      destruct (motion_leg mu d N (n j) t q v j HM HN) as (_ & _ & X & Y & _); fold p in X, Y.
      assert (Hs : Rabs (p (j + 1)%Z - p j) <= / K).
      { eapply Rle_trans; [apply apart|]; pose proof (Le j); pose proof (Le (j + 1)%Z); lra. }
      destruct (one_leg c k m S V n_max K HK (n j) _ _ w _ _ (proj2 Hj) HSj Hs Hs (HW j) (HW (j + 1)%Z))
        as (NS & A & A' & _).
      fold L in A, A'; set (a := facing m (N j) * v j (t j)) in *.
      assert (Ea : aft_leg c m S V (n j) (p (j + 1)%Z - p j) (- mu - G mu (p j)) (- mu - G mu (p (j + 1)%Z)) = a).
      { unfold aft_leg, aft_of; rewrite X; field; exact NS. }
      rewrite Ea in A; split; [exact A|]; rewrite Y.
      unfold bef_leg, bef_of in A'; change (aft_of _ _ _ _) with (aft_leg c m S V (n j) (p (j + 1)%Z - p j)
        (- mu - G mu (p j)) (- mu - G mu (p (j + 1)%Z))) in A'; rewrite Ea in A'; exact A'. }
    replace i with (i - 1 + 1)%Z by lia; set (j := (i - 1)%Z).
    destruct (motion_leg mu d N (n j) t q v j HM (proj1 (Hn j))) as (_ & _ & _ & _ & _ & Law); fold p in Law.
    destruct (Leg j) as [_ LB], (Leg (j + 1)%Z) as [LA _].
    set (x := p (j + 1)%Z) in *; set (a := facing m (N (j + 1)%Z) * v (j + 1)%Z _) in *;
      set (b := facing m _ * v j _) in *.
    assert (X : Rabs (G1 mu x) <= L * w).
    { apply (Rmult_le_reg_l (1 + tau)); [lra|]; rewrite <- (Rabs_pos_eq (1 + tau)) at 1 by lra; rewrite <- Rabs_mult.
      replace ((1 + tau) * G1 mu x) with (- a - tau * b) by lra; eapply Rle_trans; [apply apart|].
      rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq tau) by lra.
      assert (tau * Rabs b <= tau * (L * w)) by (apply Rmult_le_compat_l; lra); lra. }
    destruct (Near x) as [_ N2]; [unfold x; specialize (Le (j + 1)%Z); lra|].
    destruct (St mu x Hmu) as (_ & S1 & _); rewrite Rabs_minus_sym in S1; apply from in S1.
    apply (Rle_trans _ (2 / g * (L * w + B * Rabs mu))).
    - eapply Rle_trans; [exact N2|]; apply Rmult_le_compat_l; lra.
    - right; unfold w, C; field; lra. }
  intros i; apply (squeeze _ _ d); intros j; revert i; induction j as [|j IH]; intros i.
  - cbn [pow]; rewrite div_1; specialize (Le i); assert (0 <= C * Rabs mu) by (apply Rmult_le_pos;
      [exact C0 | apply Rabs_pos]); lra.
  - eapply Rle_trans; [apply (Step _ IH)|]; right; cbn [pow]; field; apply pow_nonzero; lra.
Qed.
End Law.
