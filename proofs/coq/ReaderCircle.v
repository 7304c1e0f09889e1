(** * The reader of certificates of kind theorem2 is right: signs of sines on r = 1 by whole parts *)

From Coq Require Import Reals ZArith List Bool Lra Lia.
From Grazing Require Import Defs Statement StatementCircleZ StatementReaders Algebra Polar Phase Above CircleZ.
Import ListNotations. Open Scope R_scope.

Lemma odd_true m : Z.odd m = true -> exists l, m = (2 * l + 1)%Z.
Proof. intros H; apply Zodd_bool_iff in H; apply Zodd_ex in H; exact H. Qed.
Lemma odd_false m : Z.odd m = false -> exists l, m = (2 * l)%Z.
Proof. rewrite <- Z.negb_even; intros H; apply negb_false_iff, Zeven_bool_iff, Zeven_ex in H; exact H. Qed.
Lemma sin_whole m : sin (PI * IZR m) = 0.
Proof. rewrite Rmult_comm; apply sin_eq_0_1; exists m; reflexivity. Qed.
Definition signed (negative : bool) (x : R) : Prop := if negative then x < 0 else 0 < x.
Lemma signed_product a b x y : signed a x -> signed b y -> signed (xorb a b) (x * y).
Proof. destruct a, b; cbn [signed xorb]; intros; nra. Qed.
Lemma signed_scale a x y t : 0 < t -> y * t = x -> signed a x -> signed a y.
Proof. destruct a; cbn [signed]; intros; nra. Qed.
Lemma signed_opp a x : signed a x -> signed (negb a) (- x). Proof. destruct a; cbn [signed negb]; lra. Qed.
Lemma signed_nonzero a x : signed a x -> x <> 0. Proof. destruct a; cbn [signed]; lra. Qed.
Lemma sin_floor m x : IZR m < x < IZR m + 1 -> signed (Z.odd m) (sin (PI * x)).
Proof.
  intros H; pose proof PI_RGT_0; destruct (Z.odd m) eqn:E; cbn [signed].
  - apply odd_true in E; destruct E as [l ->]; rewrite plus_IZR, mult_IZR in H.
    rewrite <- (proj2 (periods_Z (PI * x) l)); replace (PI * x - IZR l * (2 * PI))
      with (PI + PI * (x - (2 * IZR l + 1))) by ring.
    rewrite sin_plus, sin_PI, cos_PI; pose proof (sin_gt_0 (PI * (x - (2 * IZR l + 1)))); nra.
  - apply odd_false in E; destruct E as [l ->]; rewrite mult_IZR in H.
    rewrite <- (proj2 (periods_Z (PI * x) l)); apply sin_gt_0; nra.
Qed.

(** ** Whole parts *)
Definition steady (h : Z * Z) (s : R) (j : Z) : Prop := IZR (floorZ j h) < IZR j * s < IZR (floorZ j h) + 1.

Lemma whole_part j h : (0 < snd h)%Z -> IZR (floorZ j h) * IZR (snd h) <= IZR j * IZR (fst h) < (IZR (floorZ j h) + 1)
  * IZR (snd h) /\ (wholeZ j h = true <-> IZR j * IZR (fst h) = IZR (floorZ j h) * IZR (snd h)).
Proof.
  intros Hh; unfold floorZ, wholeZ; pose proof (Z.div_mod (j * fst h) (snd h) ltac:(lia)) as E;
    pose proof (Z.mod_pos_bound (j * fst h) (snd h) Hh) as B.
  set (m := (j * fst h / snd h)%Z) in *; set (l := ((j * fst h) mod snd h)%Z) in *.
  assert (ER : IZR j * IZR (fst h) = IZR (snd h) * IZR m + IZR l) by (rewrite <- !mult_IZR, <- plus_IZR; f_equal;
    exact E).
  destruct B as [B1 B2]; apply IZR_le in B1; apply IZR_lt in B2, Hh; rewrite Z.eqb_eq, ER; split; [lra|].
  split; [intros ->; lra | intros F; apply eq_IZR; lra].
Qed.
Lemma steady_inside h h' j s : (0 < snd h)%Z -> (0 < snd h')%Z -> (0 < j)%Z -> clearZ h h' j = true ->
  fraction h < s < fraction h' -> steady h s j.
Proof.
  intros Hh Hh' Hj H [L U]; unfold steady, fraction in *; destruct (whole_part j h Hh) as [[B _] _]; unfold clearZ in H;
    apply Z.leb_le, IZR_le in H.
  rewrite !mult_IZR, plus_IZR in H; apply IZR_lt in Hh, Hh', Hj.
  assert (X : IZR (fst h) < s * IZR (snd h)).
  { apply (Rmult_lt_compat_r (IZR (snd h))) in L; [|assumption]; unfold Rdiv in L; rewrite Rmult_assoc, Rinv_l in L;
      lra. }
  assert (Y : s * IZR (snd h') < IZR (fst h')).
  { apply (Rmult_lt_compat_r (IZR (snd h'))) in U; [|assumption]; unfold Rdiv in U; rewrite Rmult_assoc, Rinv_l in U;
      lra. }
  split; [apply (Rmult_lt_reg_r (IZR (snd h))) | apply (Rmult_lt_reg_r (IZR (snd h')))]; trivial.
  - apply Rle_lt_trans with (1 := B); rewrite Rmult_assoc; apply Rmult_lt_compat_l; lra.
  - apply Rlt_le_trans with (2 := H); rewrite Rmult_assoc; apply Rmult_lt_compat_l; lra.
Qed.
Lemma at_fraction j h : (0 < snd h)%Z -> IZR j * fraction h * IZR (snd h) = IZR j * IZR (fst h).
Proof. intros Hh; apply IZR_lt in Hh; unfold fraction; field; lra. Qed.
Lemma steady_at h j : (0 < snd h)%Z -> wholeZ j h = false -> steady h (fraction h) j.
Proof.
  intros Hh H; destruct (whole_part j h Hh) as [[B C] W]; rewrite <- (at_fraction j h Hh) in *; apply IZR_lt in Hh.
  split; apply (Rmult_lt_reg_r (IZR (snd h))); trivial.
  destruct B as [B|B]; [exact B | symmetry in B; apply W in B; congruence].
Qed.
Lemma whole_at h j : (0 < snd h)%Z -> wholeZ j h = true -> IZR j * fraction h = IZR (floorZ j h).
Proof.
  intros Hh H; destruct (whole_part j h Hh) as [_ W]; apply W in H; rewrite <- (at_fraction j h Hh) in H.
  apply IZR_lt in Hh; apply (Rmult_eq_reg_r (IZR (snd h))); lra.
Qed.

(** ** Signs at one s *)
Section At.
Variables (n : nat) (h : Z * Z) (s : R).
Hypotheses (Hn : (1 <= n)%nat) (Hs : 0 < s < 1 / 2).
Let N := Z.of_nat n.
Notation at_ := (steady h s).

Lemma theta_pos : 0 < sin (2 * PI * s). Proof. pose proof PI_RGT_0; apply sin_gt_0; nra. Qed.
Lemma u_half : u_at 1 s n * sin (2 * PI * s) = 2 * sin (PI * (IZR N * s)) * cos (PI * (IZR N * s)).
Proof.
  pose proof theta_pos as HT; pose proof (u_polar 1 (2 * PI * s) n) as E; rewrite !pow1 in E; rewrite !Rmult_1_l in E.
  unfold u_at, trace; rewrite pow1, E, <- sin_2a; f_equal; unfold N; rewrite <- INR_IZR_INZ; ring.
Qed.
Lemma b_half k : (1 <= k <= n - 1)%nat -> u_at 1 s n <> 0 ->
  b_at 1 s n k * cos (PI * (IZR N * s)) = - 2 * sin (PI * (INR k * s)) * sin (PI * (INR (n - k) * s)).
Proof.
  intros Hk Hu; pose proof theta_pos as HT; pose proof (b_polar 1 (2 * PI * s) n k ltac:(lia) Hu) as E.
  change (b (2 * 1 * cos (2 * PI * s)) (1 ^ 2) n k) with (b_at 1 s n k) in E; rewrite !pow1 in E;
    rewrite !Rmult_1_l in E.
  pose proof u_half as UH; set (A := PI * (INR k * s)) in *; set (B := PI * (INR (n - k) * s)) in *.
  assert (EN : PI * (IZR N * s) = A + B).
  { unfold A, B, N; rewrite <- INR_IZR_INZ, <- (Nat.sub_add k n) at 1 by lia; rewrite plus_INR; ring. }
  replace (INR n * (2 * PI * s)) with (2 * (A + B)) in E by (rewrite <- EN; unfold N; rewrite <- INR_IZR_INZ; ring).
  replace (INR k * (2 * PI * s)) with (2 * A) in E by (unfold A; ring).
  replace (INR (n - k) * (2 * PI * s)) with (2 * B) in E by (unfold B; ring).
  rewrite EN in *; apply (Rmult_eq_reg_l (2 * sin (A + B))).
  2: { intros Z0; assert (Z1 : 2 * sin (A + B) * cos (A + B) = 0) by (rewrite Z0; ring); rewrite Z1 in UH;
         apply Rmult_integral in UH; lra. }
  rewrite !sin_2a, sin_plus, cos_plus in E; rewrite sin_plus, cos_plus.
  pose proof (sin2_cos2 A) as SA; pose proof (sin2_cos2 B) as SB; unfold Rsqr in SA, SB.
  set (x := b_at 1 s n k) in *; set (sa := sin A) in *; set (ca := cos A) in *; set (sb := sin B) in *;
    set (cb := cos B) in *.
  transitivity (x * (2 * (sa * cb + ca * sb) * (ca * cb - sa * sb))); [ring|]; rewrite E.
  replace (2 * (sa * cb + ca * sb) * (ca * cb - sa * sb) - 2 * sa * ca - 2 * sb * cb)
    with (2 * sa * ca * (cb * cb - 1) + 2 * sb * cb * (ca * ca - 1) - 2 * sa * sa * sb * cb - 2 * sb * sb * sa * ca)
    by ring.
  replace (cb * cb - 1) with (- (sb * sb)) by lra; replace (ca * ca - 1) with (- (sa * sa)) by lra; ring.
Qed.
Lemma c_half : u_at 1 s n <> 0 -> c_at 1 s n * cos (PI * (IZR N * s)) = - 2 * sin (2 * PI * s) * sin (PI * (IZR N * s)).
Proof.
  intros Hu; pose proof theta_pos as HT; pose proof (c_polar 1 (2 * PI * s) ltac:(lra) HT n Hu) as E;
    pose proof u_half as UH.
  change (c (2 * 1 * cos (2 * PI * s)) (1 ^ 2) n) with (c_at 1 s n) in E; rewrite !pow1 in E.
  replace (INR n * (2 * PI * s)) with (2 * (PI * (IZR N * s))) in E by (unfold N; rewrite <- INR_IZR_INZ; ring).
  set (A := PI * (IZR N * s)) in *; rewrite sin_2a, cos_2a_sin in E. apply (Rmult_eq_reg_l (2 * sin A)); [lra|].
  intros Z0; assert (Z1 : 2 * sin A * cos A = 0) by (rewrite Z0; ring); rewrite Z1 in UH; apply Rmult_integral in UH;
    lra.
Qed.

Hypothesis H2 : at_ (2 * N).

Lemma cosine : signed (cosineZ N h) (cos (PI * (IZR N * s))).
Proof.
  unfold steady in H2; rewrite mult_IZR in H2; set (l := floorZ (2 * N) h) in *; unfold cosineZ; fold l.
  rewrite <- sin_shift; replace (PI / 2 - PI * (IZR N * s)) with (PI - PI * (IZR N * s + 1 / 2)) by field.
  rewrite sin_PI_x; apply sin_floor; pose proof (Z.div_mod (l + 1) 2 ltac:(lia)) as E;
    pose proof (Z.mod_pos_bound (l + 1) 2 ltac:(lia)) as B.
  set (m := ((l + 1) / 2)%Z) in *; assert (C : (2 * m - 1 <= l <= 2 * m)%Z) by lia; destruct C as [C1 C2];
    apply IZR_le in C1, C2.
  rewrite minus_IZR, mult_IZR in C1; rewrite mult_IZR in C2; lra.
Qed.
Lemma sine : signed (Z.odd (floorZ (2 * N) h / 2)) (sin (PI * (IZR N * s))).
Proof.
  unfold steady in H2; rewrite mult_IZR in H2; set (l := floorZ (2 * N) h) in *.
  apply sin_floor; pose proof (Z.div_mod l 2 ltac:(lia)) as E; pose proof (Z.mod_pos_bound l 2 ltac:(lia)) as B.
  set (m := (l / 2)%Z) in *; assert (C : (2 * m <= l <= 2 * m + 1)%Z) by lia; destruct C as [C1 C2]; apply IZR_le in C1,
    C2.
  rewrite mult_IZR in C1; rewrite plus_IZR, mult_IZR in C2; lra.
Qed.
Lemma u_steady : u_at 1 s n <> 0.
Proof.
  intros E; pose proof u_half as UH; rewrite E in UH; pose proof (signed_nonzero _ _ cosine);
    pose proof (signed_nonzero _ _ sine).
  assert (sin (PI * (IZR N * s)) * cos (PI * (IZR N * s)) <> 0) by (apply Rmult_integral_contrapositive; tauto); lra.
Qed.
Lemma negative k : (1 <= k <= n - 1)%nat -> at_ (Z.of_nat k) -> at_ (N - Z.of_nat k) ->
  signed (negativeZ N h (Z.of_nat k)) (b_at 1 s n k).
Proof.
  intros Hk Sk Sl; pose proof (b_half k Hk u_steady) as E; pose proof cosine as C; unfold negativeZ.
  pose proof (sin_floor _ _ Sk) as A; pose proof (sin_floor _ _ Sl) as B; rewrite <- INR_IZR_INZ in A.
  replace (N - Z.of_nat k)%Z with (Z.of_nat (n - k)) in B |- * by (unfold N; lia); rewrite <- INR_IZR_INZ in B.
  pose proof (signed_product _ _ _ _ (signed_product _ _ _ _ A B) C) as P; apply signed_opp in P; revert P.
  apply signed_scale with (t := cos (PI * (IZR N * s)) ^ 2 / 2); [pose proof (signed_nonzero _ _ C) as NZ;
    pose proof (Rsqr_pos_lt _ NZ); unfold Rsqr in *; nra|].
  set (x := cos _) in *; replace (b_at 1 s n k * (x ^ 2 / 2)) with (b_at 1 s n k * x * (x / 2)) by field; rewrite E;
    field.
Qed.
Lemma c_steady : signed (negb (xorb (Z.odd (floorZ (2 * N) h / 2)) (cosineZ N h))) (c_at 1 s n).
Proof.
  pose proof (c_half u_steady) as E; pose proof cosine as C; pose proof (signed_product _ _ _ _ sine C) as P;
    apply signed_opp in P; revert P.
  pose proof theta_pos; pose proof (signed_nonzero _ _ C) as NZ; pose proof (Rsqr_pos_lt _ NZ) as Q; unfold Rsqr in Q.
  set (x := cos _) in *; apply signed_scale with (t := x ^ 2 / (2 * sin (2 * PI * s))); [apply Rdiv_lt_0_compat; lra|].
  replace (c_at 1 s n * (x ^ 2 / (2 * sin (2 * PI * s)))) with (c_at 1 s n * x * (x / (2 * sin (2 * PI * s))))
    by (field; lra).
  rewrite E; field; lra.
Qed.
End At.

(** ** What is claimed is so *)

Definition ends_positive (t : claim) : Prop := match t with
  | Orbit h h' _ _ | Opposite h h' _ _ => (0 < snd h)%Z /\ (0 < snd h')%Z
  | Singular h | Boundary h _ | Excluded h _ _ => (0 < snd h)%Z end.

Lemma forall_range n f : (1 <= n)%nat -> forallb f (rangeZ (Z.of_nat n)) = true -> forall k, (1 <= k <= n - 1)%nat ->
  f (Z.of_nat k) = true.
Proof. intros Hn H k Hk; rewrite forallb_forall in H; apply H, in_range; exists k; split; [reflexivity | lia]. Qed.
Lemma opposite_true n h s k k' : (1 <= n)%nat -> 0 < s < 1 / 2 -> steady h s (2 * Z.of_nat n) ->
  (indexZ (Z.of_nat n) k = true -> steady h s k /\ steady h s (Z.of_nat n - k)) -> (indexZ (Z.of_nat n) k' = true ->
  steady h s k' /\ steady h s (Z.of_nat n - k')) -> oppositeZ (Z.of_nat n) h k k' = true -> opposite n s k k'.
Proof.
  intros Hn Hs H2 Hk Hk' H; unfold oppositeZ in H; rewrite !andb_true_iff, negb_true_iff in H;
    destruct H as [[[I I'] Neg] Neg'].
  destruct (Hk I) as [S1 S2], (Hk' I') as [S3 S4]; unfold indexZ in I, I'; rewrite andb_true_iff, Z.leb_le, Z.ltb_lt
    in I, I'.
  split; [apply (u_steady n h s Hn Hs H2)|]; split; [lia|]; split; [lia|].
  pose proof (negative n h s Hn Hs H2 (Z.to_nat k) ltac:(lia)) as A;
    pose proof (negative n h s Hn Hs H2 (Z.to_nat k') ltac:(lia)) as B.
  rewrite Z2Nat.id in A, B by lia; rewrite Neg in A; rewrite Neg' in B; split; [exact (A S1 S2) | exact (B S3 S4)].
Qed.
Lemma claim_true n t s : (1 <= n)%nat -> 0 < s < 1 / 2 -> ends_positive t -> claimZ (Z.of_nat n) t = true ->
  there t s -> says n s t.
Proof.
  intros Hn Hs Hp H Ht; destruct t as [h h' e g|h h' k k'|h|h k|h k k']; cbn [ends_positive claimZ there says] in *.
  - destruct Hp as [Hh Hh']; rewrite !andb_true_iff in H; destruct H as [[[C2 Cj] Hb] Hc].
    pose proof (steady_inside h h' (2 * Z.of_nat n) s Hh Hh' ltac:(lia) C2 Ht) as H2.
    split; [apply (u_steady n h s Hn Hs H2)|]; split.
    + intros k Hk; pose proof (forall_range n _ Hn Hb k Hk) as Bk; cbv beta in Bk.
      pose proof (steady_inside h h' (Z.of_nat k) s Hh Hh' ltac:(lia) (forall_range n _ Hn Cj k Hk) Ht) as S1.
      pose proof (steady_inside h h' (Z.of_nat (n - k)) s Hh Hh' ltac:(lia)
        (forall_range n _ Hn Cj (n - k)%nat ltac:(lia)) Ht) as S2.
      replace (Z.of_nat (n - k)) with (Z.of_nat n - Z.of_nat k)%Z in S2 by lia.
      pose proof (negative n h s Hn Hs H2 k Hk S1 S2) as B; change (b (trace 1 s) (1 ^ 2) n k) with (b_at 1 s n k).
      destruct e, (negativeZ (Z.of_nat n) h (Z.of_nat k)); cbn [plusZ xorb signed sgn] in *; discriminate || lra.
    + pose proof (c_steady n h s Hn Hs H2) as C; change (c (trace 1 s) (1 ^ 2) n) with (c_at 1 s n).
      apply eqb_prop in Hc; rewrite <- Hc in C; destruct e, g; cbn [plusZ xorb signed sgn] in *; lra.
  - destruct Hp as [Hh Hh']; rewrite !andb_true_iff in H; destruct H as [[C2 Cj] Ho].
    apply (opposite_true n h s k k' Hn Hs (steady_inside h h' (2 * Z.of_nat n) s Hh Hh' ltac:(lia) C2 Ht));
      [| |exact Ho]; cbn [forallb] in Cj; rewrite !andb_true_iff in Cj; destruct Cj as (J1 & J2 & J3 & J4 & _);
      intros I; unfold indexZ in I; rewrite andb_true_iff, Z.leb_le, Z.ltb_lt in I; split; apply (steady_inside h h');
      assumption || lia.
  - pose proof (whole_at h _ Hp H) as W; rewrite <- Ht, mult_IZR in W; set (l := floorZ _ h) in *.
    pose proof (u_half n s Hs) as UH; rewrite Rmult_assoc, <- Rmult_assoc, <- sin_2a in UH || (rewrite <- sin_2a in UH).
    replace (2 * (PI * (IZR (Z.of_nat n) * s))) with (PI * IZR l) in UH by (rewrite <- W; ring);
      rewrite sin_whole in UH.
    pose proof (theta_pos s Hs); apply Rmult_integral in UH; lra.
  - rewrite !andb_true_iff, negb_true_iff, !orb_true_iff in H; destruct H as [[[Hw I] Hz] Hall]; subst s.
    pose proof (steady_at h _ Hp Hw) as H2; pose proof (u_steady n h _ Hn Hs H2) as Hu; unfold indexZ in I.
    rewrite andb_true_iff, Z.leb_le, Z.ltb_lt in I; split; [exact Hu|]; split; [lia|].
    assert (Zero : forall j, (1 <= j <= n - 1)%nat -> wholeZ (Z.of_nat j) h = true \/ wholeZ (Z.of_nat n - Z.of_nat j) h
      = true -> b_at 1 (fraction h) n j = 0).
    { intros j Hj Hor; pose proof (b_half n _ Hn Hs j Hj Hu) as E.
      pose proof (signed_nonzero _ _ (cosine n h _ Hn H2)) as NZ;
        apply (Rmult_eq_reg_r (cos (PI * (IZR (Z.of_nat n) * fraction h)))); [|exact NZ].
      rewrite E, Rmult_0_l; rewrite !INR_IZR_INZ, Nat2Z.inj_sub by lia; destruct Hor as [W|W];
        rewrite (whole_at h _ Hp W), sin_whole; ring. }
    split; [replace k with (Z.of_nat (Z.to_nat k)) in Hz by lia; apply Zero; [lia | exact Hz]|].
    assert (Sign : forall j, (1 <= j <= n - 1)%nat -> b_at 1 (fraction h) n j <> 0 -> wholeZ (Z.of_nat j) h = false /\
      wholeZ (Z.of_nat n - Z.of_nat j) h = false /\ signed (negativeZ (Z.of_nat n) h (Z.of_nat j))
      (b_at 1 (fraction h) n j)).
    { intros j Hj HZ; destruct (wholeZ (Z.of_nat j) h) eqn:W1; [destruct (HZ (Zero j Hj (or_introl W1)))|].
      destruct (wholeZ (Z.of_nat n - Z.of_nat j) h) eqn:W2; [destruct (HZ (Zero j Hj (or_intror W2)))|].
      split; [reflexivity|]; split; [reflexivity|]; apply (negative n h _ Hn Hs H2 j Hj); apply steady_at; assumption. }
    intros j l Hj Hl [N1 N2]; destruct (Sign j Hj ltac:(lra)) as (A1 & A2 & A3), (Sign l Hl ltac:(lra))
      as (B1 & B2 & B3).
    destruct Hall as [Hall|Hall].
    + pose proof (forall_range n _ Hn Hall l Hl) as F; cbv beta in F; rewrite B1, B2 in F; cbn [orb] in F;
        rewrite F in B3; cbn [signed] in B3; lra.
    + pose proof (forall_range n _ Hn Hall j Hj) as F; cbv beta in F; rewrite A1, A2 in F; cbn [orb] in F.
      apply negb_true_iff in F; rewrite F in A3; cbn [signed] in A3; lra.
  - rewrite !andb_true_iff, negb_true_iff in H; destruct H as [[Hw Hj] Ho]; subst s; cbn [forallb] in Hj.
    rewrite !andb_true_iff, !negb_true_iff in Hj; destruct Hj as (J1 & J2 & J3 & J4 & _).
    apply (opposite_true n h _ k k' Hn Hs (steady_at h _ Hp Hw)); [| |exact Ho]; intros _; split; apply steady_at;
      assumption.
Qed.

(** ** The claims tile (0, 1/2) *)

Lemma same_true h h' : sameZ h h' = true -> h = h'.
Proof. unfold sameZ; rewrite andb_true_iff, !Z.eqb_eq; destruct h, h'; cbn; intros [-> ->]; reflexivity. Qed.
Lemma fraction_less h h' : (0 < snd h)%Z -> (0 < snd h')%Z -> lessZ h h' = true <-> fraction h < fraction h'.
Proof. intros Hh Hh'; unfold lessZ; rewrite Z.ltb_lt; destruct h' as [a b]; exact (between a b h Hh' Hh). Qed.
Lemma tiled L : forall reached point, (0 < snd reached)%Z -> tileZ reached point L = true -> Forall ends_positive L /\
  forall s, (if point then fraction reached <= s else fraction reached < s) -> s < 1 / 2 -> exists t, In t L /\
  there t s.
Proof.
  induction L as [|t L IH]; intros reached point Hr H.
  - cbn [tileZ] in H; rewrite andb_true_iff in H; destruct H as [-> H]; apply same_true in H; subst reached.
    split; [constructor|]; intros s A B; exfalso; unfold fraction in A; cbn [fst snd] in A; lra.
  - assert (Interval : forall h h', negb point && sameZ h reached && (0 <? snd h)%Z && (0 <? snd h')%Z && lessZ h h' &&
      negb (lessZ (1, 2)%Z h') && tileZ h' true L = true -> ((0 < snd h)%Z /\ (0 < snd h')%Z) /\ Forall ends_positive L
      /\ forall s, (if point then fraction reached <= s else fraction reached < s) -> s < 1 / 2 ->
      fraction h < s < fraction h' \/ exists t, In t L /\ there t s).
    { intros h h' X; rewrite !andb_true_iff, !negb_true_iff, !Z.ltb_lt in X; destruct X as [[[[[[-> E] A] B] _] _] T].
      apply same_true in E; subst h; split; [tauto|]; destruct (IH h' true B T) as [F C]; split; [exact F|];
        intros s S1 S2.
      destruct (Rlt_le_dec s (fraction h')) as [U|U]; [left; split; assumption | right; apply C; assumption]. }
    assert (Point : forall h, point && sameZ h reached && lessZ h (1, 2)%Z && tileZ reached false L = true ->
      (0 < snd h)%Z /\ Forall ends_positive L /\ forall s, (if point then fraction reached <= s else fraction reached
      < s) -> s < 1 / 2 -> s = fraction h \/ exists t, In t L /\ there t s).
    { intros h X; rewrite !andb_true_iff in X; destruct X as [[[-> E] _] T]; apply same_true in E; subst h; split;
        [exact Hr|].
      destruct (IH reached false Hr T) as [F C]; split; [exact F|]; intros s S1 S2.
      destruct S1 as [S1| ->]; [right; apply C; assumption | left; reflexivity]. }
    assert (Finish : forall P : R -> Prop, (forall s, P s -> there t s) ->
      (forall s, (if point then fraction reached <= s else fraction reached < s) -> s < 1 / 2 -> P s \/ exists t,
      In t L /\ there t s) -> forall s, (if point then fraction reached <= s else fraction reached < s) -> s < 1 / 2 ->
      exists t', In t' (t :: L) /\ there t' s).
    { intros P HP C s S1 S2; destruct (C s S1 S2) as [X|(t' & I & X)]; [exists t | exists t'];
        (split; [cbn; tauto | auto]). }
    destruct t as [h h' e g|h h' k k'|h|h k|h k k']; cbn [tileZ] in H.
    1, 2: destruct (Interval h h' H) as (P & F & C); split; [constructor; assumption |
      apply (Finish _ (fun s X => X) C)].
    1, 2, 3: destruct (Point h H) as (P & F & C); split; [constructor; assumption | apply (Finish _ (fun s X => X) C)].
Qed.

(** ** Its intervals are those of Theorem 2 *)

Lemma plus_same e e' : Bool.eqb (plusZ e) (plusZ e') = true -> e = e'.
Proof. destruct e, e'; cbn; congruence. Qed.
Lemma is_true h h' e g t : isZ h h' e g t = true <-> t = Orbit h h' e g.
Proof.
  unfold isZ; split; [|intros ->; destruct h, h', e, g; unfold sameZ; cbn; rewrite !Z.eqb_refl; reflexivity].
  destruct t; try discriminate; rewrite !andb_true_iff; intros [[[A B] C] D].
  apply same_true in A, B; apply plus_same in C, D; subst; reflexivity.
Qed.
Lemma listed_intervals n L : (3 <= n)%nat -> listedZ (Z.of_nat n) L = true -> forall e g lo hi, interval n e g lo hi <->
  exists h h', In (Orbit h h' e g) L /\ lo = fraction h /\ hi = fraction h'.
Proof.
  intros Hn H; unfold listedZ in H.
  rewrite !andb_true_iff, !forallb_forall, existsb_exists in H; destruct H as [[(t0 & I0 & E0) HS] HL];
    apply is_true in E0; subst t0.
  assert (First : fraction (0, 1)%Z = 0 /\ fraction (1, 2 * Z.of_nat n)%Z = 1 / (2 * INR n)).
  { split; [unfold fraction; cbn [fst snd]; field | apply first_end]. }
  destruct First as [F0 F1]; intros e g lo hi; split.
  - intros [|k g' lo' hi' X]; [exists (0, 1)%Z, (1, 2 * Z.of_nat n)%Z; rewrite F0, F1; auto|].
    apply (Sides n k g' lo' hi' Hn) in X; destruct X as (h & h' & I & El & Eh & _); exists h, h'; split; [|auto].
    specialize (HS _ I); cbv beta iota in HS; rewrite existsb_exists in HS; destruct HS as (t & It & Et);
      apply is_true in Et; subst t; exact It.
  - intros (h & h' & I & -> & ->); specialize (HL _ I); cbv beta iota in HL; destruct e.
    + rewrite existsb_exists in HL; destruct HL as ([[[k g'] l] l'] & Ip & Et); apply is_true in Et;
        injection Et as <- <- <-.
      assert (Pos : exists k', k = Z.of_nat k' /\ (0 < snd h)%Z /\ (0 < snd h')%Z).
      { apply in_sides in Ip; [|exact Hn]; destruct Ip as (m & F & _ & E); pose proof (positive_ends m n F Hn)
          as (P1 & P2 & P3 & P4).
        destruct E as [E|E]; [exists (n_minus F); rewrite <- E in P1, P2 | exists (n_plus F); rewrite <- E in P3, P4];
          apply (f_equal (fun t : piece => fst (fst (fst t)))) in E; auto. }
      destruct Pos as (k' & -> & P1 & P2); apply (beside n k'), (Sides n k' g (fraction h) (fraction h') Hn); eauto 8.
    + apply is_true in HL; assert (E : (h, h', g) = ((0, 1), (1, 2 * Z.of_nat n), Plus)%Z) by congruence.
      apply pair_equal_spec in E; destruct E as [E ->]; apply pair_equal_spec in E; destruct E as [-> ->].
      rewrite F0, F1; constructor.
Qed.
Theorem Circle_reader : Circle_reader_statement.
Proof.
  intros n L Hn H; unfold blockZ in H; destruct (Z.eqb_spec (Z.of_nat n) 1) as [E|E].
  - assert (n = 1%nat) as -> by lia; split; [|lia].
    assert (EL : L = [Orbit (0, 1)%Z (1, 2)%Z Plus Minus; Orbit (0, 1)%Z (1, 2)%Z Minus Plus]).
    { revert H; repeat (let d := match goal with |- context [match ?x with _ => _ end] => x end in destruct d;
        try discriminate); reflexivity. }
    subst L; intros s Hs; assert (Half : fraction (0, 1)%Z < s < fraction (1, 2)%Z) by (unfold fraction; cbn [fst snd];
      lra).
    assert (Hc : c_at 1 s 1 < 0).
    { unfold c_at, c, trace; rewrite v_1, u_1, !pow1; pose proof (COS_bound (2 * PI * s)) as [_ B].
      pose proof (sin2_cos2 (2 * PI * s)) as Q; pose proof (theta_pos s Hs); unfold Rsqr in Q.
      assert (cos (2 * PI * s) < 1) by nra; unfold Rdiv; rewrite Rinv_1; lra. }
    assert (Hu : u (trace 1 s) (1 ^ 2) 1 <> 0) by (rewrite u_1; lra).
    split; [exists (Orbit (0, 1)%Z (1, 2)%Z Plus Minus); split; [left; reflexivity | exact Half]|].
    intros t [<-|[<-|[]]] _; cbn [says]; (split; [exact Hu | split; [intros; lia | fold (c_at 1 s 1); cbn [sgn]; lra]]).
  - rewrite !andb_true_iff in H; destruct H as [[T C] Li]; destruct (tiled L (0, 1)%Z false ltac:(reflexivity) T)
      as [F Cov].
    rewrite Forall_forall in F; rewrite forallb_forall in C; split.
    + intros s Hs; split; [apply Cov; unfold fraction; cbn [fst snd]; lra|]. intros t It Ht; apply claim_true; auto.
    + intros H3; apply listed_intervals; [exact H3|]; destruct (Z.ltb_spec (Z.of_nat n) 3); [lia | exact Li].
Qed.
