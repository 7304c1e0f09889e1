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
Notation newton := (newton O).
Notation aft0 := (aft0 c m S V).
Notation bef0 := (bef0 c k m S V).
Hypothesis HO : touching O.
Hypothesis Htau : 0 <= tau.
Hypothesis HS : flow c k S V.
Variables (n_max : nat) (K : R).
Hypothesis HK : bounds c k m S V n_max K.
Notation L := (6 * K ^ 5).

(** The place of an impact at the phase x; velocities just after it and before the one n turns later, at the
    phase y; and the place j turns on the way. For mu -> 0 the legs from -1 to -1, times mu. *)
Definition place mu x : R := - mu - G mu x.
Definition aft n mu x y := aft_leg c m S V n (y - x) (place mu x) (place mu y).
Definition bef n mu x y := bef_leg c k m S V n (y - x) (place mu x) (place mu y).
Definition mid n j mu x y := turned e11 j (- x) * place mu x + turned S j (- x) * aft n mu x y.
Definition mid0 n j := turned e11 j 0 * -1 + turned S j 0 * aft0 n.

Definition regular (n : nat) : Prop := (1 <= n <= n_max)%nat /\ turned S n 0 <> 0.

Lemma same x e : 0 <= e -> Rabs (x - x) <= e. Proof. rewrite Rminus_eq_0, Rabs_R0; trivial. Qed.
Lemma large : 6 <= L. Proof. pose proof (pow_R1_Rle K 5 (proj1 HK)); lra. Qed.

(** Legs between the phases x and y, and x' and y', all at most d, which are e apart. *)
Lemma legs_beside z d mu n x y x' y' e : 0 <= z <= 1 -> 2 * d <= / K -> (forall x x', Rabs x <= d -> Rabs x' <= d ->
  Rabs (G mu x - G mu x') <= z * Rabs (x - x')) -> regular n -> Rabs x <= d -> Rabs y <= d -> Rabs x' <= d ->
  Rabs y' <= d -> Rabs (x - x') <= e -> Rabs (y - y') <= e -> let w := Rabs mu + z * d in turned S n (y - x) <> 0 /\
  beside (L * w) (L * (w * (2 * e) + z * e)) (aft n mu x y) (aft n mu x' y') /\
  beside (L * w) (L * (w * (2 * e) + z * e)) (bef n mu x y) (bef n mu x' y').
Proof.
  intros Hz Hd HG [Hn HSn] Hx Hy Hx' Hy' Ex Ey w; unfold aft, bef.
  assert (Pd : 0 <= d) by (eapply Rle_trans; [apply Rabs_pos | exact Hx]).
  assert (P : forall p, Rabs p <= d -> Rabs (place mu p) <= w).
  { intros p Hp; unfold place; eapply Rle_trans; [apply apart|]; rewrite Rabs_Ropp; apply Rplus_le_compat_l.
    pose proof (HG p 0 Hp ltac:(rewrite Rabs_R0; exact Pd)) as H; rewrite (touch _ HO), !Rminus_0_r in H.
    eapply Rle_trans; [exact H | apply Rmult_le_compat_l; lra]. }
  assert (Q : forall p p', Rabs p <= d -> Rabs p' <= d -> Rabs (p - p') <= e -> beside w (z * e) (place mu p) (place mu
    p')).
  { intros p p' Hp Hp' He; repeat split; [apply P, Hp | apply P, Hp'|]; unfold place.
    replace (_ - _) with (G mu p' - G mu p) by ring; rewrite Rabs_minus_sym.
    eapply Rle_trans; [apply HG; assumption | apply Rmult_le_compat_l; lra]. }
  apply (legs c k m S V n_max K HK); auto; try lia; try (eapply Rle_trans; [apply apart | lra]).
  replace (_ - _) with ((y - y') - (x - x')) by ring; eapply Rle_trans; [apply apart | lra].
Qed.

Record leg_near (n : nat) (eps mu x y : R) : Prop := {
  near_S : turned S n (y - x) <> 0;
  near_aft : Rabs (aft n mu x y - mu * aft0 n) <= eps * Rabs mu;
  near_bef : Rabs (bef n mu x y - mu * bef0 n) <= eps * Rabs mu;
  near_place : Rabs (place mu x) <= 2 * Rabs mu;
  bound_aft : Rabs (aft n mu x y) <= 2 * L * Rabs mu;
  near_mid : forall j, (j <= n_max)%nat -> Rabs (mid n j mu x y - mu * mid0 n j) <= eps * Rabs mu }.

(** Legs between phases of the size of mu. *)
Lemma legs_near h eps : 0 <= h -> 0 < eps -> exists d, 0 < d /\ forall n mu x y, regular n -> Rabs mu <= d ->
  Rabs x <= h * Rabs mu -> Rabs y <= h * Rabs mu -> leg_near n eps mu x y.
Proof.
  intros Hh He; pose proof large as HL; pose proof (inverse_K c k m S V n_max K HK) as IK; assert (K1 := proj1 HK).
  set (Q := 8 * K * L); assert (HQ : 0 < Q) by (apply Rmult_lt_0_compat; lra).
  destruct (two_least (/ K / 2) (eps / Q) ltac:(lra) ltac:(apply Rdiv_lt_0_compat; lra)) as (z & Hz & Z1 & Z2).
  apply (Rmult_le_compat_l Q) in Z2; [|lra]; replace (Q * (eps / Q)) with eps in Z2 by (field; lra).
  set (q := z / (h + 1)); assert (Eq : q * (h + 1) = z) by (unfold q; field; lra).
  assert (Pq : 0 < q) by (apply Rdiv_lt_0_compat; lra); destruct (flat O HO q Pq) as (d0 & D0 & F).
  destruct (two_least (d0 / (h + 1)) q ltac:(apply Rdiv_lt_0_compat; lra) Pq) as (d & Hd & D1 & D2).
  apply (Rmult_le_compat_r (h + 1)) in D1; [|lra]; replace (d0 / (h + 1) * (h + 1)) with d0 in D1 by (field; lra).
  apply (Rmult_le_compat_r (h + 1)) in D2; [|lra]; assert (Hhd : 0 <= h * d) by (apply Rmult_le_pos; lra).
  exists d; split; [exact Hd|]; intros n mu x y [Hn HSn] Hmu Hx Hy; pose proof (Rabs_pos mu) as Pm.
  assert (hd : h * Rabs mu <= h * d) by (apply Rmult_le_compat_l; lra).
  assert (small : forall p, Rabs p <= h * Rabs mu -> Rabs p <= z /\ beside (2 * Rabs mu) (z * Rabs mu) (place mu p) (-
    mu)).
  { intros p Hp; split; [lra|]; assert (A : Rabs (place mu p - - mu) <= z * Rabs mu).
    { unfold place; replace (_ - _) with (- G mu p) by ring; rewrite Rabs_Ropp.
      destruct (F mu p 0) as [A _]; [lra | lra | rewrite Rabs_R0; lra|]; rewrite (touch _ HO), !Rminus_0_r in A.
      eapply Rle_trans; [exact A|]; apply (Rle_trans _ (q * (h * Rabs mu))); [apply Rmult_le_compat_l; lra|].
      rewrite <- Eq, <- Rmult_assoc; apply Rmult_le_compat_r; lra. }
    assert (z * Rabs mu <= 1 * Rabs mu) by (apply Rmult_le_compat_r; lra).
    pose proof (from _ _ _ A) as B; rewrite Rabs_Ropp in B; repeat split; rewrite ?Rabs_Ropp; lra. }
  destruct (small x Hx) as [Zx Bx], (small y Hy) as [Zy By].
  assert (Ht : Rabs (y - x - 0) <= 2 * z) by (rewrite Rminus_0_r; eapply Rle_trans; [apply apart | lra]).
  destruct (legs c k m S V n_max K HK n (y - x) 0 _ _ _ _ _ _ _ (proj2 Hn) HSn ltac:(rewrite Rminus_0_r in Ht; lra)
    ltac:(rewrite Rabs_R0; lra) Ht Bx By) as (N & A & B).
  assert (Ea : aft_leg c m S V n 0 (- mu) (- mu) = mu * aft0 n).
  { unfold OscillatorTurns.aft0, aft_leg, aft_of, Rdiv; ring. }
  assert (Eb : bef_leg c k m S V n 0 (- mu) (- mu) = mu * bef0 n).
  { unfold OscillatorTurns.bef0, bef_leg, bef_of, aft_of, Rdiv; ring. }
  rewrite Ea in A; rewrite Eb in B.
  assert (Small : 5 * (L * (z * Rabs mu)) <= eps * Rabs mu /\ K * (3 * (z * Rabs mu) + 7 * (L * (z * Rabs mu))) <= eps
    * Rabs mu).
  { assert (0 <= z * Rabs mu) as Pz by (apply Rmult_le_pos; lra); assert (P6 := Rmult_le_compat_r _ _ _ Pz HL).
    assert (Q * (z * Rabs mu) <= eps * Rabs mu) as PQ by (rewrite <- Rmult_assoc; apply Rmult_le_compat_r; lra).
    assert (1 * (L * (z * Rabs mu)) <= K * (L * (z * Rabs mu))) by (apply Rmult_le_compat_r; lra).
    assert (K * (6 * (z * Rabs mu)) <= K * (L * (z * Rabs mu))) by (apply Rmult_le_compat_l; lra). unfold Q in PQ; lra.
      }
  constructor.
  - exact N.
  - destruct A as (_ & _ & A); eapply Rle_trans; [exact A | lra].
  - destruct B as (_ & _ & B); eapply Rle_trans; [exact B | lra].
  - apply Bx.
  - eapply Rle_trans; [apply A | lra].
  - intros j Hj; assert (E : forall f, entry c k S V f -> beside K (K * z) (turned f j (- x)) (turned f j 0)).
    { intros f Hf; apply (turned_beside c k m S V n_max K HK); trivial; rewrite ?Rminus_0_r, ?Rabs_Ropp, ?Rabs_R0; lra.
        }
    pose proof (beside_plus _ _ _ _ _ _ _ _ (beside_times _ _ _ _ _ _ _ _ (E e11 ltac:(left; reflexivity)) Bx)
      (beside_times _ _ _ _ _ _ _ _ (E S ltac:(right; left; reflexivity)) A)) as (_ & _ & M).
    unfold mid, mid0; fold (aft n mu x y) in M.
    replace (mu * _) with (turned e11 j 0 * - mu + turned S j 0 * (mu * aft0 n)) by ring.
    eapply Rle_trans; [exact M | lra].
Qed.

(** ** The law: phases x i are those of a motion *)
Definition law (n : Z -> nat) (mu : R) (x : Z -> R) : Prop := forall i, (1 + tau) * G1 mu (x i) =
  - (aft (n i) mu (x i) (x (i + 1)%Z) + tau * bef (n (i - 1)%Z) mu (x (i - 1)%Z) (x i)).
Definition next (n : Z -> nat) (mu : R) (x : Z -> R) (i : Z) : R := newton mu (x i) -
  (aft (n i) mu (x i) (x (i + 1)%Z) + tau * bef (n (i - 1)%Z) mu (x (i - 1)%Z) (x i)) / ((1 + tau) * g).

Lemma law_at n mu x i : (1 + tau) * G1 mu (x i) = - (aft (n i) mu (x i) (x (i + 1)%Z) + tau * bef (n (i - 1)%Z) mu (x (i
  - 1)%Z) (x i)) <-> next n mu x i = x i.
Proof.
  pose proof (g_pos O HO) as P; assert (N : 0 < (1 + tau) * g) by (apply Rmult_lt_0_compat; lra).
  assert (E : forall f s y, y - / g * f - s / ((1 + tau) * g) = y - ((1 + tau) * f + s) * / ((1 + tau) * g)) by (intros;
    field; lra).
  unfold next, OscillatorStop.newton; rewrite E; split; intros H.
  - rewrite H; ring.
  - assert (Z : ((1 + tau) * G1 mu (x i) + (aft (n i) mu (x i) (x (i + 1)%Z) + tau * bef (n (i - 1)%Z) mu (x (i - 1)%Z)
      (x i))) * / ((1 + tau) * g) = 0) by lra.
    apply Rmult_integral in Z; pose proof (Rinv_0_lt_compat _ N); lra.
Qed.
Lemma law_fixed n mu x : law n mu x <-> forall i, next n mu x i = x i.
Proof. split; intros H i; apply law_at, H. Qed.
Lemma weigh a b A : Rabs a <= A -> Rabs b <= A -> Rabs ((a + tau * b) / ((1 + tau) * g)) <= A / g.
Proof.
  intros Ha Hb; pose proof (g_pos O HO) as P; assert (N : 0 < (1 + tau) * g) by (apply Rmult_lt_0_compat; lra).
  replace (A / g) with ((1 + tau) * A * / ((1 + tau) * g)) by (field; lra); apply product.
  - eapply Rle_trans; [apply Rabs_triang|]; pose proof (product tau b _ _ (Rle_refl _) Hb) as Q.
    rewrite (Rabs_pos_eq tau) in Q by exact Htau; lra.
  - pose proof (Rinv_0_lt_compat _ N); rewrite Rabs_pos_eq; lra.
Qed.

(** Where two sequences of phases are e apart next to i, the law brings them nearer at i. *)
Definition nearer (d mu : R) : Prop := forall n x x' i e, (forall i, regular (n i)) ->
  (forall j, (i - 1 <= j <= i + 1)%Z -> Rabs (x j) <= d /\ Rabs (x' j) <= d /\ Rabs (x j - x' j) <= e) ->
  Rabs (next n mu x i - next n mu x' i) <= e / 2 /\
  Rabs (aft (n i) mu (x i) (x (i + 1)%Z) - aft (n i) mu (x' i) (x' (i + 1)%Z)) <= g * e /\
  Rabs (bef (n (i - 1)%Z) mu (x (i - 1)%Z) (x i) - bef (n (i - 1)%Z) mu (x' (i - 1)%Z) (x' i)) <= g * e /\
  Rabs (G1 mu (x i) - G1 mu (x' i)) <= 2 * g * e.

(** One d for all words and mu, and the phases have the size of mu. *)
Theorem one_solution : exists d mu0 C, 0 < d <= 1 /\ 2 * d <= / K /\ 0 < mu0 /\ 0 <= C /\
  (forall mu, Rabs mu <= mu0 -> nearer d mu) /\ forall n mu,
  (forall i, regular (n i)) -> Rabs mu <= mu0 -> exists x, (forall i, Rabs (x i) <= C * Rabs mu) /\ law n mu x /\
  forall x', (forall i, Rabs (x' i) <= d) -> law n mu x' -> forall i, x' i = x i.
Proof.
  pose proof (g_pos O HO) as P; destruct (steady_with O HO) as (B & HB & St); pose proof large as HL.
  pose proof (inverse_K c k m S V n_max K HK) as IK; pose proof (Rinv_0_lt_compat _ P) as Pi.
  set (Q := 20 * L); assert (HQ : 0 < Q) by (unfold Q; lra).
  destruct (two_least (1 / 4) (g / Q) ltac:(lra) ltac:(apply Rdiv_lt_0_compat; lra)) as (z & Hz & Z1 & Z2).
  apply (Rmult_le_compat_l Q) in Z2; [|lra]; replace (Q * (g / Q)) with g in Z2 by (field; lra).
  destruct (flat O HO z Hz) as (d0 & D0 & F), (two_least d0 (/ K / 2) ltac:(lra) ltac:(lra)) as (d & Hd & D1 & D2).
  set (C := (B + L) / g); assert (HC : 0 <= C) by (apply Rmult_le_pos; lra).
  destruct (two_least d z Hd Hz) as (d1 & E1 & E2 & E3).
  destruct (two_least d1 (d / (2 * (C + 1))) E1 ltac:(apply Rdiv_lt_0_compat; lra)) as (mu0 & M0 & M1 & M2).
  apply (Rmult_le_compat_l (2 * (C + 1))) in M2; [|lra].
  replace (2 * (C + 1) * (d / (2 * (C + 1)))) with d in M2 by (field; lra).
  assert (Nr : forall mu, Rabs mu <= mu0 -> nearer d mu).
  { intros mu Hmu n y y' i e Hn H; pose proof (Rabs_pos mu) as Pm; destruct (H i ltac:(lia)) as (N & N' & D).
    assert (Pe : 0 <= e) by (eapply Rle_trans; [apply Rabs_pos | exact D]).
    assert (Leg : forall n x y x' y', regular n -> Rabs x <= d -> Rabs y <= d -> Rabs x' <= d -> Rabs y' <= d -> Rabs (x
      - x') <= e -> Rabs (y - y') <= e -> Rabs (aft n mu x y - aft n mu x' y') <= g / 4 * e /\ Rabs (bef n mu x y - bef
      n mu x' y') <= g / 4 * e).
    { intros j p q p' q' Hj Hx Hy Hx' Hy' Ex Ey.
      destruct (legs_beside z d mu j p q p' q' e) as (_ & (_ & _ & A) & (_ & _ & A')); trivial; try lra.
      { intros t t' Ht Ht'; apply F; lra. }
      assert (zd : z * d <= z * 1) by (apply Rmult_le_compat_l; lra).
      assert ((Rabs mu + z * d) * (2 * e) <= 2 * z * (2 * e)) by (apply Rmult_le_compat_r; lra).
      assert (L * ((Rabs mu + z * d) * (2 * e) + z * e) <= L * (5 * (z * e))) by (apply Rmult_le_compat_l; lra).
      assert (Q * z * e <= g * e) as PQ by (apply Rmult_le_compat_r; lra); unfold Q in PQ; lra. }
    destruct (H (i + 1)%Z ltac:(lia)) as (N1 & N1' & D1'), (H (i - 1)%Z ltac:(lia)) as (N2 & N2' & D2').
    destruct (Leg (n i) _ _ _ _ (Hn i) N N1 N' N1' D D1') as [A _].
    destruct (Leg (n (i - 1)%Z) _ _ _ _ (Hn _) N2 N N2' N' D2' D) as [_ A'].
    destruct (F mu (y i) (y' i)) as [_ Nw]; [lra.. |].
    assert (Zs : z * Rabs (y i - y' i) <= 1 / 4 * e) by (apply Rmult_le_compat; [lra | apply Rabs_pos | exact Z1 | exact
      D]). assert (ge : 0 <= g * e) by (apply Rmult_le_pos; lra); split; [|split; [lra | split; [lra|]]].
    - pose proof (weigh _ _ _ A A') as W; unfold next.
      match type of W with Rabs ((?a - ?a' + tau * (?b - ?b')) / ?q) <= _ => match goal with |- Rabs (?f - _ - (?f' -
        _)) <= _ => replace (f - _ - (f' - _)) with (f - f' - (a - a' + tau * (b - b')) / q) by (unfold Rdiv; ring) end
        end.
      eapply Rle_trans; [apply apart|]; replace (g / 4 * e / g) with (e / 4) in W by (field; lra); lra.
    - unfold OscillatorStop.newton in Nw; replace (G1 mu (y i) - G1 mu (y' i)) with (g * ((y i - y' i) - (y i - / g * G1
        mu (y i) - (y' i - / g * G1 mu (y' i))))) by (field; lra).
      rewrite Rabs_mult, (Rabs_pos_eq g) by lra; replace (2 * g * e) with (g * (2 * e)) by ring.
      apply Rmult_le_compat_l; [lra|]; eapply Rle_trans; [apply apart | lra]. }
  exists d, mu0, (2 * C); repeat (split; [lra|]); split; [exact Nr|]; intros n mu Hn Hmu; pose proof (Rabs_pos mu) as
    Pm.
  assert (Cd : C * Rabs mu <= C * mu0) by (apply Rmult_le_compat_l; lra).
  assert (Start : forall i, Rabs (next n mu (fun _ => 0) i) <= C * Rabs mu).
  { intros i; unfold next; assert (A : forall n, regular n -> Rabs (aft n mu 0 0) <= L * Rabs mu /\ Rabs (bef n mu 0 0)
      <= L * Rabs mu).
    { intros j [Hj HSj]; assert (E : beside (Rabs mu) 0 (place mu 0) (place mu 0)).
      { unfold place; rewrite (touch _ HO), Rminus_0_r, <- (Rabs_Ropp mu); repeat split; try lra; apply same; lra. }
      destruct (legs c k m S V n_max K HK j (0 - 0) (0 - 0) _ _ _ _ _ _ 0 (proj2 Hj) HSj ltac:(apply same; lra)
        ltac:(apply same; lra) ltac:(apply same; lra) E E) as (_ & A & A'); split; [apply A | apply A']. }
    pose proof (weigh _ _ _ (proj1 (A _ (Hn i))) (proj2 (A _ (Hn (i - 1)%Z)))) as W; eapply Rle_trans; [apply apart|].
    destruct (St mu 0 ltac:(lra)) as (_ & S1 & _); rewrite (G1_0 O HO), Rminus_0_r in S1.
    unfold OscillatorStop.newton; replace (0 - / g * G1 mu 0) with (- / g * G1 mu 0) by ring.
    pose proof (product (- / g) _ _ _ (Rle_refl _) S1) as N; rewrite Rabs_Ropp, (Rabs_pos_eq (/ g)) in N by lra.
    replace (C * Rabs mu) with (/ g * (B * Rabs mu) + L * Rabs mu / g) by (unfold C; field; lra); lra. }
  pose proof (contraction Z (fun _ => True) (next n mu) d) as H; cbv zeta in H; destruct H as (x & Hx & Fx & U).
  - lra.
  - intros e y y' Hy Hy' He i _; apply (Nr mu Hmu n y y' i e Hn); intros j _; specialize (Hy j Logic.I); specialize (Hy'
      j Logic.I); rewrite Rminus_0_r in Hy, Hy'; auto.
  - intros i _; rewrite Rminus_0_r; specialize (Start i); lra.
  - exists x; split; [|split; [apply law_fixed; auto|]].
    + intros i; specialize (U (fun _ => 0) (C * Rabs mu)); unfold near in U.
      rewrite <- (Rminus_0_r (x i)), Rmult_assoc; apply U; [intros; apply same; lra | | exact Logic.I].
      intros j _; rewrite Rminus_0_r; apply Start.
    + intros x' Hx' L' i; rewrite law_fixed in L'; symmetry; apply Rminus_diag_uniq, Rabs_zero.
      rewrite <- (Rmult_0_r 2); apply (U x' 0); [|intros j _; rewrite L'; apply same; lra | exact Logic.I].
      intros j _; rewrite Rminus_0_r; apply Hx'.
Qed.

(** ** What a motion says about its phases, whatever they are *)
Definition phase (N : Z -> Z) (t : Z -> R) (i : Z) : R := t i - T * IZR (N i).

Section Motion.
Variables (mu d : R) (N : Z -> Z) (n : Z -> nat) (t : Z -> R) (q v : Z -> R -> R).
Hypothesis HM : motion O m mu d N t q v.
Hypothesis Hd : 2 * d <= / K.
Hypothesis HN : forall i, N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\ regular (n i).
Let x := phase N t.
Let a i := aft (n i) mu (x i) (x (i + 1)%Z).
Let b i := bef (n i) mu (x i) (x (i + 1)%Z).

Lemma motion_leg i : Rabs (x i) <= d /\ q i (t i) = facing m (N i) * place mu (x i) /\
  v i (t i) = facing m (N i) * a i /\ facing m (N (i + 1)%Z) * v i (t (i + 1)%Z) = b i.
Proof.
  assert (Ph : forall j, Rabs (x j) <= d) by (intros j; apply (HM j _ eq_refl)).
  destruct (HM i _ eq_refl) as [Hf _ _ Q0 Q1 _ _ _], (HN i) as (E & Hn & HSn); split; [apply Ph|].
  destruct (free_moved c k S V HS _ _ (t i) (t (i + 1)%Z) Hf) as [A B]; unfold moved, moving in A, B.
  unfold gap in Q0, Q1; fold (phase N t i) (phase N t (i + 1)%Z) in Q0, Q1; fold x in Q0, Q1.
  assert (ET : t (i + 1)%Z - t i = T * INR (n i) + (x (i + 1)%Z - x i)).
  { unfold x, phase; rewrite E, plus_IZR, <- INR_IZR_INZ; ring. }
  set (s := x (i + 1)%Z - x i) in *; assert (NS : turned S (n i) s <> 0).
  { intros Z; pose proof (proj2 (proj2 HK) (n i) s (proj2 Hn) HSn) as P; rewrite Z, Rabs_R0 in P.
    pose proof (inverse_K c k m S V n_max K HK); pose proof (Ph i); pose proof (Ph (i + 1)%Z); pose proof (apart (x (i +
      1)%Z) (x i)) as Q; fold s in P, Q; lra. }
  set (f := facing m (N i)) in *; assert (Sq : f * f = 1) by apply side_square.
  assert (E0 : q i (t i) = f * place mu (x i)).
  { replace (place mu (x i)) with (f * q i (t i)) by (unfold place; lra); rewrite <- Rmult_assoc, Sq; ring. }
  rewrite E, facing_plus in Q1 |- *; fold f in Q1 |- *; set (h := facing m (Z.of_nat (n i))) in *.
  rewrite ET, E0 in A, B.
  assert (out : forall y y' z z', f * h * (y * (f * z) + y' * z') = h * y * z + h * y' * (f * z')).
  { intros; replace (_ * (_ + _)) with (f * f * (h * y * z) + h * y' * (f * z')) by ring; rewrite Sq; ring. }
  assert (Ea : f * v i (t i) = a i).
  { unfold a, aft, aft_leg, aft_of; fold s; apply (Rmult_eq_reg_r (turned S (n i) s)); [|exact NS].
    unfold Rdiv; rewrite (Rmult_assoc _ (/ _)), Rinv_l by exact NS.
    replace (place mu (x (i + 1)%Z)) with (f * h * q i (t (i + 1)%Z)) by (unfold place; lra).
    rewrite A, out; unfold OscillatorTurns.turned; fold h; ring. }
  split; [exact E0|]; split; [rewrite <- Ea, <- Rmult_assoc, Sq; ring|]; unfold b, bef, bef_leg, bef_of; fold s.
  change (aft_of _ _ _ _) with (a i); rewrite <- Ea, B, out; reflexivity.
Qed.
Lemma motion_law : law n mu x /\ forall i, b i < a (i + 1)%Z.
Proof.
  assert (Imp : forall i, b i + G1 mu (x (i + 1)%Z) < 0 /\ a (i + 1)%Z + G1 mu (x (i + 1)%Z) = - tau
    * (b i + G1 mu (x (i + 1)%Z))).
  { intros i; destruct (HM i _ eq_refl) as [_ _ _ _ _ _ V1 V2]; unfold speed in V1, V2.
    destruct (motion_leg i) as (_ & _ & _ & B), (motion_leg (i + 1)) as (_ & _ & A & _).
    rewrite A, <- Rmult_assoc, side_square, Rmult_1_l, B in V2; rewrite B in V1; auto. }
  split; intros i.
  - destruct (Imp (i - 1)%Z) as [_ E]; unfold a, b in E; replace (i - 1 + 1)%Z with i in E by lia; lra.
  - destruct (Imp i) as [A E]; pose proof (Rmult_le_compat_l tau _ 0 Htau (Rlt_le _ _ A)); lra.
Qed.
End Motion.
End Law.
