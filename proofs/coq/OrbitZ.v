(** * The functions over Z decide what [Defs] says over R: proof of [Oracle_statement] *)

From Coq Require Import Reals ZArith List Bool Lra Lia.
From Grazing Require Import Defs Algebra StatementZ.
Open Scope R_scope.

(** ** Signs *)

Lemma sign_of_scaled z x d : 0 < d -> IZR z = d * x -> sign_of (Z.sgn z) x.
Proof.
  intros Hd E; destruct (Ztrichotomy z 0) as [H|[H|H]].
  - rewrite (Z.sgn_neg z H); apply IZR_lt in H. assert (0 < - x) by (apply (Rmult_lt_reg_l d); lra).
    repeat split; intros; lia || lra.
  - rewrite H in *; assert (x = 0) by (apply (Rmult_eq_reg_l d); lra). repeat split; intros; simpl in *; lia || lra.
  - rewrite (Z.sgn_pos z ltac:(lia)); apply Z.gt_lt, IZR_lt in H. assert (0 < x) by (apply (Rmult_lt_reg_l d); lra).
    repeat split; intros; lia || lra.
Qed.

Lemma sign_of_cases z x : sign_of z x -> (-1 <= z <= 1)%Z ->
  z = (-1)%Z /\ x < 0 \/ z = 0%Z /\ x = 0 \/ z = 1%Z /\ 0 < x.
Proof.
  intros (H1 & H2 & H3) H; assert (z = -1 \/ z = 0 \/ z = 1)%Z as [E|[E|E]] by lia.
  - left; split; [assumption|apply H1; lia].
  - right; left; split; [assumption|apply H2, E].
  - right; right; split; [assumption|apply H3; lia].
Qed.

Lemma sgn_range z : (-1 <= Z.sgn z <= 1)%Z. Proof. destruct z; simpl; lia. Qed.

(** The sign of a quotient is the product of the signs. *)
Lemma sign_of_quotient y z a x : sign_of (Z.sgn y) a -> sign_of (Z.sgn z) x -> x <> 0 ->
  sign_of (Z.sgn z * Z.sgn y) (a / x).
Proof.
  intros Ha Hx H0.
  destruct (sign_of_cases _ _ Ha (sgn_range y)) as [[-> ?]|[[-> ->]|[-> ?]]];
    destruct (sign_of_cases _ _ Hx (sgn_range z)) as [[-> ?]|[[-> ?]|[-> ?]]]; try tauto; assert (x < 0 -> / x < 0)
    by apply Rinv_lt_0_compat; assert (0 < x -> 0 < / x) by apply Rinv_0_lt_compat; unfold Rdiv; set (i := / x) in *;
    repeat split; intros; simpl in *; try lia; try nra.
Qed.

Lemma sign_of_opp z x : sign_of z x -> sign_of (- z) (- x).
Proof.
  intros (H1 & H2 & H3); split; [|split]; split; intros H.
  - assert (0 < x) by (apply H3; lia); lra.
  - assert (0 < z)%Z by (apply H3; lra); lia.
  - assert (x = 0) by (apply H2; lia); lra.
  - assert (z = 0%Z) by (apply H2; lra); lia.
  - assert (x < 0) by (apply H1; lia); lra.
  - assert (z < 0)%Z by (apply H1; lra); lia.
Qed.

Section At.
Variables p s q : Z.
Hypothesis q_pos : (0 < q)%Z.
Notation a1 := (IZR p / IZR q).
Notation a2 := (IZR s / IZR q).

Lemma q_R : 0 < IZR q. Proof. apply IZR_lt, q_pos. Qed.

Lemma uZ_u k : IZR (uZ p s q k) = IZR q ^ k / IZR q * u a1 a2 k.
Proof.
  pose proof q_R; assert (E : IZR (uZ p s q k) * IZR q = IZR q ^ k * u a1 a2 k).
  { unfold uZ; induction k as [| |k IH0 IH1] using two_step.
    - rewrite u_0; cbn; ring.
    - rewrite u_1; cbn; ring.
    - rewrite u_SS; cbn [pairZ] in *; destruct (pairZ p s q k) as [x y]; cbn [fst] in *. rewrite minus_IZR, !mult_IZR.
      transitivity (IZR p * (IZR y * IZR q) - IZR s * IZR q * (IZR x * IZR q)); [ring|].
      rewrite IH0, IH1; cbn [pow]; field; lra. }
  apply (Rmult_eq_reg_r (IZR q)); [rewrite E; field; lra|lra].
Qed.

Lemma scale_pos n : 0 < IZR q ^ n / IZR q.
Proof. pose proof q_R; apply Rdiv_lt_0_compat; [apply pow_lt|]; lra. Qed.
Lemma sign_u n : sign_of (Z.sgn (uZ p s q n)) (u a1 a2 n).
Proof. exact (sign_of_scaled _ _ _ (scale_pos n) (uZ_u n)). Qed.
Lemma uZ_zero n : uZ p s q n = 0%Z <-> u a1 a2 n = 0.
Proof. rewrite <- (proj1 (proj2 (sign_u n))); symmetry; apply Z.sgn_null_iff. Qed.
Lemma pow_s k : IZR s ^ k = IZR q ^ k * a2 ^ k.
Proof. pose proof q_R; rewrite <- Rpow_mult_distr; f_equal; field; lra. Qed.

Theorem signB_b n k : u a1 a2 n <> 0 -> (k <= n)%nat -> sign_of (signB p s q n k) (b a1 a2 n k).
Proof.
  intros Hu Hk; apply sign_of_quotient; [|apply sign_u|assumption].
  apply (sign_of_scaled _ _ _ (scale_pos n)); pose proof q_R. rewrite !minus_IZR, !mult_IZR, <- !pow_IZR, !uZ_u, pow_s.
  replace (IZR q ^ n) with (IZR q ^ (n - k) * IZR q ^ k) by (rewrite <- pow_add; f_equal; lia). field; lra.
Qed.

Theorem signD_det n : sign_of (signD p s q n) (1 - v a1 a2 n + a2 ^ n).
Proof.
  pose proof q_R; apply (sign_of_scaled _ _ (IZR q ^ n)); [apply pow_lt; lra|].
  rewrite plus_IZR, !minus_IZR, !mult_IZR, <- !pow_IZR, !uZ_u, pow_s; cbn [pow]; unfold v; field; lra.
Qed.

Theorem signC_c n : u a1 a2 n <> 0 -> sign_of (signC p s q n) (c a1 a2 n).
Proof.
  intros Hu; unfold signC, c.
  replace (- (1 - v a1 a2 n + a2 ^ n) / u a1 a2 n) with (- ((1 - v a1 a2 n + a2 ^ n) / u a1 a2 n)) by (unfold Rdiv;
    ring).
  apply sign_of_opp; unfold signD; apply sign_of_quotient; [apply signD_det|apply sign_u|assumption].
Qed.

Lemma sgnZ_sgn e z x : sign_of z x -> ((0 < sgnZ e * z)%Z <-> sgn e * x > 0).
Proof.
  intros (H1 & H2 & H3); destruct e; cbn [sgnZ sgn]; split; intros H.
  - rewrite Rmult_1_l; apply H3; lia.
  - assert (0 < z)%Z by (apply H3; lra); lia.
  - assert (x < 0) by (apply H1; lia); lra.
  - assert (z < 0)%Z by (apply H1; lra); lia.
Qed.

Lemma sgnZ_sgn_sgn e g z x : sign_of z x -> ((0 < sgnZ e * sgnZ g * z)%Z <-> sgn e * sgn g * x > 0).
Proof.
  intros H; destruct e; cbn [sgnZ sgn]; [rewrite Z.mul_1_l, Rmult_1_l; now apply sgnZ_sgn|].
  destruct g; cbn [sgnZ sgn]; [rewrite Z.mul_1_r, Rmult_1_r; exact (sgnZ_sgn Minus z x H)|].
  replace (-1 * -1 * x) with (1 * x) by ring; exact (sgnZ_sgn Plus z x H).
Qed.

Lemma nonzero n : negb (uZ p s q n =? 0)%Z = true <-> u a1 a2 n <> 0.
Proof. rewrite negb_true_iff, Z.eqb_neq, uZ_zero; reflexivity. Qed.
Lemma and_iff_dependent (P Q S : Prop) : (P -> (Q <-> S)) -> (P /\ Q <-> P /\ S). Proof. tauto. Qed.

Theorem orbitZ_orbit n e g : orbitZ p s q n e g = true <-> orbit a1 a2 n e g.
Proof.
  unfold orbitZ, orbit; rewrite !andb_true_iff, nonzero, and_assoc, forallb_forall, Z.ltb_lt.
  apply and_iff_dependent; intros Hu; split; intros [Hb Hc]; split.
  - intros k Hk; apply (sgnZ_sgn e (signB p s q n k)); [apply signB_b; trivial; lia|]. apply Z.ltb_lt, Hb, in_seq; lia.
  - apply (sgnZ_sgn_sgn e g _ _ (signC_c n Hu)), Hc.
  - intros k Hk; apply in_seq in Hk; apply Z.ltb_lt, (sgnZ_sgn e _ (b a1 a2 n k));
      [apply signB_b; trivial; lia|apply Hb; lia].
  - apply (sgnZ_sgn_sgn e g _ _ (signC_c n Hu)), Hc.
Qed.

Theorem no_orbitZ_no_orbit n : no_orbitZ p s q n = true <-> no_orbit a1 a2 n.
Proof.
  unfold no_orbitZ, no_orbit; rewrite !andb_true_iff, nonzero, and_assoc, !existsb_exists.
  apply and_iff_dependent; intros Hu; split.
  - intros [(k & Hk & H) (k' & Hk' & H')]; apply in_seq in Hk, Hk'; apply Z.ltb_lt in H, H'.
    exists k, k'; repeat split; try lia; [apply (signB_b n k Hu ltac:(lia)), H|apply (signB_b n k' Hu ltac:(lia)), H'].
  - intros (k & k' & Hk & Hk' & H & H'); split; [exists k|exists k']; (split; [apply in_seq; lia|apply Z.ltb_lt]);
      [apply (signB_b n k Hu ltac:(lia)), H|apply (signB_b n k' Hu ltac:(lia)), H'].
Qed.
End At.

Theorem Oracle : Oracle_statement.
Proof.
  intros p s q n Hq; cbv zeta; split; [apply uZ_zero, Hq|].
  split; [intros Hu; split; [now apply signC_c|intros; now apply signB_b]|].
  split; [now apply signD_det|split; [intros; now apply orbitZ_orbit|now apply no_orbitZ_no_orbit]].
Qed.
