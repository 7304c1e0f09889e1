(** * A point given by r and s lies in its box: how often u_k changes its sign tells c from 2 cos(2 pi s) *)

From Coq Require Import Reals ZArith List Bool Lra Lia.
From Grazing Require Import Defs Statement StatementZ StatementCircleZ StatementReaders StatementReaderWords Algebra
  Polar OrbitZ ReaderCircle.
Open Scope R_scope.

Lemma turns_pair x z k : fst (turnsZ x z k) = pairZ x z z k.
Proof.
  induction k as [|k IH]; [reflexivity|]; cbn [turnsZ pairZ]; destruct (turnsZ x z k) as [[h l] t]; cbn [fst] in IH;
    rewrite <- IH; reflexivity.
Qed.

Section Turns.
Variables (x z : Z).
Hypotheses (Hz : (0 < z)%Z) (Hx : (x < 2 * z)%Z) (Hx' : (- (2 * z) < x)%Z).
Let c := IZR x / IZR z.
Let phi := acos (c / 2).

Lemma c_range : -1 < c / 2 < 1.
Proof.
  apply IZR_lt in Hz, Hx, Hx'; rewrite opp_IZR, mult_IZR in Hx'; rewrite mult_IZR in Hx; unfold c.
  split; apply (Rmult_lt_reg_r (IZR z)); try assumption; replace (IZR x / IZR z / 2 * IZR z) with (IZR x / 2) by (field;
    lra); lra.
Qed.
Lemma phi_range : 0 < phi < PI. Proof. apply acos_bound_lt, c_range. Qed.
Lemma cos_phi : 2 * cos phi = c. Proof. unfold phi; rewrite cos_acos by (pose proof c_range; lra); field. Qed.
Lemma u_sign k : sign_of (Z.sgn (uZ x z z k)) (sin (INR k * phi)).
Proof.
  pose proof (sign_u x z z Hz k) as S; fold c in S; replace (IZR z / IZR z) with 1 in S by (field; apply IZR_lt in Hz;
    lra).
  pose proof (u_polar 1 phi k) as E; rewrite !pow1 in E; rewrite !Rmult_1_l in E; replace (2 * 1 * cos phi) with c in E
    by (rewrite <- cos_phi; ring).
  pose proof phi_range as P; pose proof (sin_gt_0 phi (proj1 P) (proj2 P)) as Q; destruct S as (A & B & C);
    rewrite <- E; unfold sign_of; rewrite A, B, C.
  split; [split; intros; nra|]; split; [|split; intros; nra]; split; intros H;
    [rewrite H; ring | apply Rmult_integral in H; destruct H; [assumption | lra]].
Qed.
Lemma turns_floor k : forall t, snd (turnsZ x z k) = Some t -> IZR t < INR (S k) * phi / PI < IZR t + 1.
Proof.
  pose proof PI_RGT_0 as HP; pose proof phi_range as [P1 P2]; induction k as [|k IH]; intros t H.
  - cbn in H; injection H as <-; change (INR 1) with 1; rewrite Rmult_1_l; split; [apply Rdiv_lt_0_compat; assumption|].
    apply (Rmult_lt_reg_r PI); [assumption|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
  - pose proof (turns_pair x z k) as TP; cbn [turnsZ] in H; destruct (turnsZ x z k) as [[h l] o] eqn:ET;
      cbn [fst snd] in *.
    destruct o as [t0|]; [|discriminate]; specialize (IH t0 eq_refl); set (X := INR (S k) * phi / PI) in *.
    assert (EU : uZ x z z (S k) = l /\ uZ x z z (S (S k)) = (x * l - z * z * h)%Z) by (unfold uZ; cbn [pairZ];
      rewrite <- TP; split; reflexivity).
    pose proof (u_sign (S k)) as S1; pose proof (u_sign (S (S k))) as S2; rewrite (proj1 EU) in S1;
      rewrite (proj2 EU) in S2; set (n := (x * l - z * z * h)%Z) in *.
    assert (EX : INR (S k) * phi = PI * X) by (unfold X; field; lra);
      assert (EY : INR (S (S k)) * phi = PI * (X + phi / PI)) by (rewrite (S_INR (S k)), Rmult_plus_distr_r, EX; field;
      lra).
    rewrite EX in S1; rewrite EY in S2; replace (INR (S (S k)) * phi / PI) with (X + phi / PI) by (rewrite EY; field;
      lra).
    assert (Step : 0 < phi / PI < 1) by (split; [apply Rdiv_lt_0_compat; assumption|]; apply (Rmult_lt_reg_r PI);
      [assumption|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra).
    set (Y := X + phi / PI) in *; assert (XY : X < Y < X + 1) by (unfold Y; lra); pose proof (sin_floor t0 X IH) as F1;
      destruct (Z.eqb_spec (Z.sgn l * Z.sgn n) 0) as [|NZ]; [discriminate|].
    assert (N2 : sin (PI * Y) <> 0) by (intros E; destruct S2 as (_ & S2 & _); apply S2 in E; rewrite E in NZ; lia).
    assert (Mid : Y <> IZR t0 + 1) by (intros E; apply N2; rewrite E, <- plus_IZR; apply sin_whole).
    assert (Low : Y < IZR t0 + 1 -> signed (Z.odd t0) (sin (PI * Y))) by (intros L; apply sin_floor; lra).
    assert (High : IZR t0 + 1 < Y -> signed (negb (Z.odd t0)) (sin (PI * Y))).
    { intros L; replace (negb (Z.odd t0)) with (Z.odd (t0 + 1)) by (rewrite Z.odd_add; destruct (Z.odd t0);
        reflexivity); apply sin_floor; rewrite plus_IZR; lra. }
    assert (R1 : (Z.sgn l = -1 \/ Z.sgn l = 0 \/ Z.sgn l = 1)%Z) by lia;
      assert (R2 : (Z.sgn n = -1 \/ Z.sgn n = 0 \/ Z.sgn n = 1)%Z) by lia.
    destruct S1 as (A1 & _ & C1), S2 as (A2 & _ & C2); destruct (Rtotal_order Y (IZR t0 + 1)) as [L|[L|L]];
      [specialize (Low L); clear High | contradiction | specialize (High L); clear Low].
    + assert (E : (0 < Z.sgn l * Z.sgn n)%Z).
      { destruct (Z.odd t0); cbn [signed] in F1, Low; [apply A1 in F1; apply A2 in Low | apply C1 in F1;
          apply C2 in Low]; nia. }
      destruct (Z.ltb_spec (Z.sgn l * Z.sgn n) 0); [lia|]; injection H as <-; lra.
    + assert (E : (Z.sgn l * Z.sgn n < 0)%Z).
      { destruct (Z.odd t0); cbn [signed negb] in F1, High; [apply A1 in F1; apply C2 in High | apply C1 in F1;
          apply A2 in High]; nia. }
      destruct (Z.ltb_spec (Z.sgn l * Z.sgn n) 0); [|lia]; injection H as <-; rewrite plus_IZR; lra.
Qed.

(** Against theta = 2 pi m/n. *)
Lemma compare_turns m n t : (0 < m)%Z -> (2 * m < n)%Z -> snd (turnsZ x z (Z.to_nat n - 1)) = Some t ->
  ((2 * m <= t)%Z -> c <= 2 * cos (2 * PI * (IZR m / IZR n))) /\
  ((t + 1 <= 2 * m)%Z -> 2 * cos (2 * PI * (IZR m / IZR n)) <= c).
Proof.
  intros Hm Hn H; apply turns_floor in H; replace (S (Z.to_nat n - 1)) with (Z.to_nat n) in H by lia;
    rewrite INR_IZR_INZ, Z2Nat.id in H by lia.
  pose proof PI_RGT_0 as HP; pose proof phi_range as [P1 P2]; set (th := 2 * PI * (IZR m / IZR n));
    pose proof (IZR_lt 0 m Hm); pose proof (IZR_lt _ _ Hn) as Hn'; rewrite mult_IZR in Hn'.
  assert (TH : IZR n * th / PI = 2 * IZR m) by (unfold th; field; split; lra); assert (T1 : 0 <= th <= PI).
  { split; apply (Rmult_le_reg_l (IZR n)); try lra; replace (IZR n * th) with (2 * PI * IZR m) by (unfold th; field;
      lra); nra. }
  rewrite <- cos_phi; split; intros Ht; apply IZR_le in Ht; rewrite ?plus_IZR, mult_IZR in Ht.
  - assert (L : th <= phi); [|destruct L as [L|L]; [pose proof (cos_decreasing_1 th phi); lra | rewrite L; lra]].
    apply (Rmult_le_reg_l (IZR n / PI)); [apply Rdiv_lt_0_compat; lra|]; replace (IZR n / PI * th)
      with (IZR n * th / PI) by (field; lra).
    replace (IZR n / PI * phi) with (IZR n * phi / PI) by (field; lra); lra.
  - assert (L : phi <= th); [|destruct L as [L|L]; [pose proof (cos_decreasing_1 phi th); lra | rewrite L; lra]].
    apply (Rmult_le_reg_l (IZR n / PI)); [apply Rdiv_lt_0_compat; lra|]; replace (IZR n / PI * th)
      with (IZR n * th / PI) by (field; lra).
    replace (IZR n / PI * phi) with (IZR n * phi / PI) by (field; lra); lra.
Qed.
End Turns.

Theorem Polar_reader : Polar_reader_statement.
Proof.
  intros r s c c' B H; unfold polarZ, short in H; cbv zeta in H.
  destruct (snd (turnsZ (fst c) (snd c) _)) as [t|] eqn:E; [|rewrite andb_false_r in H; discriminate].
  destruct (snd (turnsZ (fst c') (snd c') _)) as [t'|] eqn:E'; [|rewrite andb_false_r in H; discriminate].
  match type of H with (if ?b then _ else _) = _ => destruct b eqn:EB end; [|discriminate]; injection H as <-.
  rewrite !andb_true_iff, !Z.ltb_lt, !Z.leb_le in EB; destruct EB as [[[[[[R1 R2] M1] M2] [[C1 C2] C3]] [[D1 D2] D3]]
    [T1 T2]].
  pose proof (proj1 (compare_turns _ _ C1 C2 C3 _ _ t M1 M2 E) T1) as A;
    pose proof (proj2 (compare_turns _ _ D1 D2 D3 _ _ t' M1 M2 E') T2) as Bd.
  assert (Times : forall h l, (0 < snd h)%Z -> (0 < snd l)%Z -> fraction (timesF h l) = fraction h * fraction l).
  { intros h l Hh Hl; apply IZR_lt in Hh, Hl; unfold fraction, timesF; cbn [fst snd]; rewrite !mult_IZR; field; split;
      lra. }
  assert (Rp : 0 < fraction r) by (apply IZR_lt in R1, R2; apply Rdiv_lt_0_compat; assumption); unfold in_box;
    rewrite !Times by assumption.
  unfold trace; fold (fraction s) in A, Bd; fold (fraction c) in A; fold (fraction c') in Bd;
    set (x := 2 * cos (2 * PI * fraction s)) in *.
  replace (2 * fraction r * cos (2 * PI * fraction s)) with (fraction r * x) by (unfold x; ring); split;
    [split; apply Rmult_le_compat_l; lra | cbn [pow]; rewrite Rmult_1_r; split; lra].
Qed.
