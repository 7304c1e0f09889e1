(** * With d = 3/2, w = 8, tau = 4/5 every return separates, for all mu to 1/10: the check by intervals *)
From Coq Require Import Reals ZArith List Lra Lia Bool.
From Grazing Require Import StatementTrapped TrappedRange TrappedPaper ChaosInterval ChaosFunctions.
Open Scope R_scope.

Definition quo (X Y : itv) : itv := times X (inverse Y).
Lemma mem_quo X Y x y : mem X x -> mem Y y -> mem (quo X Y) (x / y).
Proof. intros; apply mem_times, mem_inverse; trivial. Qed.
Lemma mem_whole z : mem (constant z 1) (IZR z).
Proof. pose proof (mem_constant z 1) as H; replace (IZR z / 1) with (IZR z) in H by field; exact H. Qed.
Fixpoint power (X : itv) (n : nat) : itv := match n with O => constant 1 1 | S n => times X (power X n) end.
Lemma mem_power X x n : mem X x -> mem (power X n) (x ^ n).
Proof. intros H; induction n as [|n IH]; [exact mem_1|apply mem_times; trivial]. Qed.
(** By the form of the interval: nothing is unfolded, nothing computed. *)
Ltac contained := match goal with
  | H : mem ?X ?x |- mem ?X ?x => exact H
  | |- mem (power _ _) _ => apply mem_power; contained
  | |- mem (quo _ _) _ => apply mem_quo; contained
  | |- mem (plus _ _) _ => apply mem_plus; contained
  | |- mem (minus _ _) _ => apply mem_minus; contained
  | |- mem (times _ _) _ => apply mem_times; contained
  | |- mem (opp _) _ => apply mem_opp; contained
  | |- mem (root _) _ => apply mem_root; contained
  | |- mem (constant _ 1) _ => apply mem_whole
  | |- mem (constant _ _) _ => apply mem_constant end.

(** Worse numbers than those of the paper's oscillators with 0 < mu <= 1/10. *)
Definition limit : machine := {| a := (3 / 2 - sqrt ((3 / 2) ^ 2 - 1)) / 8; b := (3 / 2 + sqrt ((3 / 2) ^ 2 -
  1)) / 8;
  tau := 4 / 5; p := 2 * PI; W := 43 / 50; mu := 1 / 10; al0 := 1; al1 := 11 / 10;
  Q := fun _ => 0; Q1 := fun _ => 0; Q2 := fun _ => 0 |}.

Definition rI := root (constant 5 4).
Definition aI := quo (minus (constant 3 2) rI) (constant 8 1).
Definition bI := quo (plus (constant 3 2) rI) (constant 8 1).
Definition pI := times (constant 2 1) pi.
Definition DI := minus bI aI.
Definition tI := plus (constant 1 1) (constant 4 5).
(** exp (- a p), exp (- b p), exp (a W), exp (b W). *)
Definition laI := exponential (times (opp aI) pI).
Definition kaI := exponential (times (opp bI) pI).
Definition eaI := exponential (times aI (constant 43 50)).
Definition ebI := exponential (times bI (constant 43 50)).
Definition lowI n := quo (minus (times (power laI n) eaI) (times (power kaI n) ebI)) DI.
Definition highI n := quo (minus (quo (power laI n) eaI) (quo (power kaI n) ebI)) DI.
Definition startI n := quo (minus (times bI (times (power laI n) eaI)) (times aI (times (power kaI n) ebI)))
  DI.
Definition zmI := quo (times (constant 1 10) DI) (minus (quo (times laI eaI) (times kaI ebI)) (constant 1 1)).
Definition V1I := quo (constant 1 10) (times tI (lowI 1)).
Definition alMI := plus (constant 11 10) (times (power aI 2) (plus (constant 1 10) (quo zmI DI))).
Definition albI := minus (constant 1 1) (quo (times (times (power bI 2) ebI) (plus zmI (times tI V1I))) DI).
Definition deepI := plus (times (minus (constant 1 1) laI) (constant 1 10))
  (times laI (quo (times (power (constant 4 5) 2) (power V1I 2)) (times (constant 2 1) albI))).
Definition VmI := root (times (times (constant 2 1) alMI) deepI).
Definition aloI := minus (constant 1 1) (quo (times (power bI 2) (plus zmI (times tI VmI))) DI).
Definition sigmaI := plus (times (constant 4 5) (minus (constant 1 1) (quo (times (power bI 2) zmI) DI)))
  aloI.
Definition QlI := minus (constant 1 10) (quo (power (plus VmI zmI) 2) (times (constant 2 1) (constant 1 1))).
Definition denI := times (plus (times tI VmI) zmI) VmI.

Lemma m_a : mem aI (a limit).
Proof. cbn [a limit]; replace ((3 / 2) ^ 2 - 1) with (5 / 4) by field; unfold aI, rI; contained. Qed.
Lemma m_b : mem bI (b limit).
Proof. cbn [b limit]; replace ((3 / 2) ^ 2 - 1) with (5 / 4) by field; unfold bI, rI; contained. Qed.
Lemma m_p : mem pI (p limit). Proof. apply mem_times; [apply mem_whole|exact mem_pi]. Qed.
Lemma m_D : mem DI (b limit - a limit). Proof. apply mem_minus; [exact m_b|exact m_a]. Qed.
Lemma m_t : mem tI (1 + tau limit). Proof. apply mem_plus; [exact mem_1|apply mem_constant]. Qed.
Definition la := exp (- a limit * p limit). Definition ka := exp (- b limit * p limit).
Definition ea := exp (a limit * W limit). Definition eb := exp (b limit * W limit).
Lemma m_la : mem laI la. Proof. apply mem_exponential, mem_times; [apply mem_opp, m_a|exact m_p]. Qed.
Lemma m_ka : mem kaI ka. Proof. apply mem_exponential, mem_times; [apply mem_opp, m_b|exact m_p]. Qed.
Lemma m_ea : mem eaI ea. Proof. apply mem_exponential, mem_times; [apply m_a|apply mem_constant]. Qed.
Lemma m_eb : mem ebI eb. Proof. apply mem_exponential, mem_times; [apply m_b|apply mem_constant]. Qed.

Lemma exp_times x n : exp (INR n * x) = exp x ^ n.
Proof.
  induction n as [|n IH]; [rewrite Rmult_0_l; apply exp_0|]. rewrite S_INR; replace ((INR n + 1) * x) with (x + INR n
    * x) by ring; rewrite exp_plus, IH; reflexivity.
Qed.
Lemma parts n : exp (- a limit * (p limit * INR n - W limit)) = la ^ n * ea /\
  exp (- b limit * (p limit * INR n - W limit)) = ka ^ n * eb /\
  exp (- a limit * (p limit * INR n + W limit)) = la ^ n / ea /\
  exp (- b limit * (p limit * INR n + W limit)) = ka ^ n / eb.
Proof. unfold la, ka, ea, eb, Rdiv; rewrite <- !exp_times, <- !exp_Ropp, <- !exp_plus; repeat split; f_equal; ring. Qed.
Lemma m_low n : mem (lowI n) (phi12 limit (p limit * INR n - W limit)).
Proof.
  unfold lowI, phi12; destruct (parts n) as (-> & -> & _); pose proof m_D; pose proof m_la; pose proof m_ka;
    pose proof m_ea; pose proof m_eb. contained.
Qed.
Lemma m_high n : mem (highI n) (phi12 limit (p limit * INR n + W limit)).
Proof.
  unfold highI, phi12; destruct (parts n) as (_ & _ & -> & ->); pose proof m_D; pose proof m_la; pose proof m_ka;
    pose proof m_ea; pose proof m_eb. contained.
Qed.
Lemma m_start n : mem (startI n) (phi11 limit (p limit * INR n - W limit)).
Proof.
  unfold startI, phi11; destruct (parts n) as (-> & -> & _); pose proof m_D; pose proof m_la; pose proof m_ka;
    pose proof m_ea; pose proof m_eb. pose proof m_a; pose proof m_b; contained.
Qed.
Lemma m_zm : mem zmI (zm limit).
Proof.
  assert (E : exp ((b limit - a limit) * (p limit - W limit)) = la * ea / (ka * eb)).
  { unfold la, ka, ea, eb, Rdiv; rewrite <- !exp_plus, <- exp_Ropp, <- exp_plus; f_equal; ring. }
  pose proof m_D; pose proof m_la; pose proof m_ka; pose proof m_ea; pose proof m_eb. unfold zm; rewrite E;
    unfold zmI; cbn [mu limit]; contained.
Qed.
Lemma ell_first : ell limit 1 = phi12 limit (p limit * INR 1 - W limit).
Proof.
  unfold ell; apply Rmin_left; change 1 with (INR 1); apply (below_le (lowI 1) (highI 1));
    [vm_compute; reflexivity|apply m_low|apply m_high].
Qed.
Lemma m_V1 : mem V1I (V1 limit).
Proof. pose proof m_t; pose proof (m_low 1); unfold V1; rewrite ell_first; unfold V1I; cbn [mu limit]. contained. Qed.
Lemma m_alM : mem alMI (alM limit).
Proof. pose proof m_zm; pose proof m_D; pose proof m_a; unfold alM, alMI; cbn [mu al1 limit]; contained. Qed.
Lemma m_alb : mem albI (alb limit).
Proof.
  pose proof m_zm; pose proof m_D; pose proof m_b; pose proof m_V1; pose proof m_eb; pose proof m_t.
  unfold alb, albI; fold eb; cbn [al0 limit]; contained.
Qed.
Lemma m_deep : mem deepI (deep limit).
Proof. pose proof m_la; pose proof m_V1; pose proof m_alb; unfold deep, deepI; fold la; cbn [mu tau limit];
  contained. Qed.
Lemma m_Vm : mem VmI (Vm limit). Proof. pose proof m_deep; pose proof m_alM; unfold Vm, VmI; contained. Qed.
Lemma m_alo : mem aloI (alo limit).
Proof.
  pose proof m_zm; pose proof m_D; pose proof m_b; pose proof m_Vm; pose proof m_t. unfold alo, aloI;
    cbn [al0 limit]; contained.
Qed.
Lemma m_sigma : mem sigmaI (sigma limit).
Proof.
  pose proof m_zm; pose proof m_D; pose proof m_b; pose proof m_alo; unfold sigma, sigmaI;
    cbn [al0 tau limit]; contained.
Qed.
Lemma m_Ql : mem QlI (Ql limit).
Proof.
  pose proof m_zm; pose proof m_Vm; pose proof m_a; unfold Ql; rewrite Rmax_left.
  - unfold QlI; cbn [mu al0 limit]; contained.
  - apply (below_le (times aI (constant 1 10)) (plus VmI zmI)); [vm_compute; reflexivity| |];
      cbn [mu limit]; contained.
Qed.
Lemma m_den : mem denI (((1 + tau limit) * Vm limit + zm limit) * Vm limit).
Proof. pose proof m_zm; pose proof m_Vm; pose proof m_t; unfold denI; contained. Qed.

(** The checks: E Vm <= sigma phi12 at both ends, and E times B's denominator at most its numerator. *)
Definition by_A (e : itv) (n : nat) : bool :=
  below (times e VmI) (times sigmaI (lowI n)) && below (times e VmI) (times sigmaI (highI n)).
Definition by_B (e : itv) (n : nat) : bool :=
  below (times e denI) (times sigmaI (minus QlI (times (startI n) (constant 1 10)))).
Lemma above_A e E n : mem e E -> by_A e n = true -> E <= A_ limit (INR n).
Proof.
  intros He H; apply andb_prop in H; destruct H as [H1 H2]; pose proof m_Vm; pose proof m_sigma.
  assert (V : 0 < Vm limit) by (apply (positive_lt VmI); [vm_compute; reflexivity|exact m_Vm]).
  assert (S : 0 < sigma limit) by (apply (positive_lt sigmaI); [vm_compute; reflexivity|exact m_sigma]).
  pose proof (m_low n); pose proof (m_high n). assert (X1 : E * Vm limit <= sigma limit * phi12 limit (p limit * INR n
    - W limit)) by (apply (below_le _ _ _ _ H1); contained). assert (X2 : E * Vm limit <= sigma limit * phi12 limit (p
    limit * INR n + W limit)) by (apply (below_le _ _ _ _ H2); contained). unfold A_, ell;
    apply Rmult_le_reg_r with (Vm limit); [exact V|]. replace (sigma limit * Rmin (phi12 limit (p limit * INR n - W
    limit)) (phi12 limit (p limit * INR n + W limit)) / Vm limit
    * Vm limit) with (sigma limit * Rmin (phi12 limit (p limit * INR n - W limit)) (phi12 limit (p limit * INR n + W
        limit)))
    by (field; lra).
  unfold Rmin; destruct Rle_dec; lra.
Qed.
Lemma above_B e E n : mem e E -> by_B e n = true -> E <= B_ limit (INR n).
Proof.
  intros He H1; pose proof m_den as Hd; pose proof m_sigma; pose proof m_Ql; pose proof (m_start n).
  set (q := ((1 + tau limit) * Vm limit + zm limit) * Vm limit) in *. assert (V : 0 < q) by (apply (positive_lt denI);
    [vm_compute; reflexivity|exact m_den]). assert (X1 : E * q <= sigma limit * (Ql limit - phi11 limit (p limit * INR
    n - W limit)
    * mu limit)).
  { apply (below_le _ _ _ _ H1); cbn [mu limit] in *; contained. }
  unfold B_; fold q; apply Rmult_le_reg_r with q; [exact V|]. replace (sigma limit * (Ql limit - phi11 limit (p limit
    * INR n - W limit) * mu limit) / q * q) with (sigma limit * (Ql limit - phi11 limit (p limit * INR n - W limit) *
    mu limit)) by (field; lra); exact X1.
Qed.
Lemma limit_checked : checked limit (201 / 200) 11.
Proof.
  constructor; try lia; try lra.
  - cbn; pose proof PI_RGT_0; pose proof PI2_3_2; lra.
  - cbn; lra.
  - apply (positive_lt albI); [vm_compute; reflexivity|exact m_alb].
  - apply (positive_lt aloI); [vm_compute; reflexivity|exact m_alo].
  - intros n Hn; left; rewrite <- (Z2Nat.id n), <- INR_IZR_INZ by lia. apply (above_A (constant 201 200));
      [apply mem_constant|]. assert (F : forallb (by_A (constant 201 200)) (seq 1 10) = true) by (vm_compute;
      reflexivity). rewrite forallb_forall in F; apply F, in_seq; lia.
  - change 11%Z with (Z.of_nat 11); rewrite <- INR_IZR_INZ. apply (above_B (constant 201 200));
      [apply mem_constant|vm_compute; reflexivity].
Qed.

Theorem Example : Example_statement.
Proof.
  intros mu Hm; apply (Range limit _ 11%Z); [exact limit_checked|apply Paper; lra|]. constructor; cbn; try lra.
  set (h := acos (/ (1 + mu))). assert (I : 10 / 11 <= / (1 + mu) <= 1).
  { split; [replace (10 / 11) with (/ (11 / 10)) by field|rewrite <- Rinv_1]; apply Rinv_le_contravar; lra. }
  assert (C : cos h = / (1 + mu)) by (apply cos_acos; lra); destruct (acos_bound (/ (1 + mu))) as [b1 b2];
    fold h in b1, b2. assert (K : cos (43 / 100) <= 10 / 11).
  { apply (below_le (cosine (constant 43 100)) (constant 10 11)); [vm_compute; reflexivity|apply mem_cosine|];
      apply mem_constant. }
  apply Rnot_lt_le; intros F; pose proof PI2_3_2; assert (cos h < cos (43 / 100)); [|lra].
  apply cos_decreasing_1; lra.
Qed.
