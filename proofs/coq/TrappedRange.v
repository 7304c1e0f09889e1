(** * (v): where the numbers are no worse, the constants are no worse; B_n rises with n *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import StatementTrapped TrappedFlow TrappedReturn TrappedMain.
Open Scope R_scope.

Lemma div_mono x y c d : 0 <= x <= y -> 0 < d <= c -> x / c <= y / d.
Proof. intros; apply Rmult_le_compat; try lra; [left; apply Rinv_0_lt_compat; lra|apply Rinv_le_contravar; lra]. Qed.
Lemma mult_mono x y u v : 0 <= x <= y -> 0 <= u <= v -> x * u <= y * v. Proof. intros; apply Rmult_le_compat; lra. Qed.
Lemma pow2_mono x y : 0 <= x <= y -> x ^ 2 <= y ^ 2. Proof. intros; apply pow_incr; lra. Qed.

(** ** The constants, divided by mu or its root *)
Section Hats.
Variables (M : machine) (Z : R).
Notation a := (a M). Notation b := (b M). Notation tau := (tau M). Notation p := (p M). Notation W := (W M).
Notation mu := (mu M). Notation al0 := (al0 M). Notation al1 := (al1 M).
Definition zh : R := (b - a) / (exp ((b - a) * (p - W)) - 1).
Definition V1h : R := / ((1 + tau) * ell M 1).
Definition deeph : R := (1 - exp (- a * p)) + exp (- a * p) * (tau ^ 2 * V1h ^ 2 * mu / (2 * alb M)).
Definition vh : R := sqrt (2 * alM M * deeph).

(** What a machine's numbers are like. *)
Record usable : Prop := { u_ab : 0 < a < b; u_tau : 0 <= tau; u_mu : 0 < mu; u_W : 0 <= W < p;
  u_al : 0 < al0 <= al1; u_Z : 0 <= Z; u_zm : zm M = Z * mu }.
Hypothesis U : usable.
Hypothesis Hb : 0 < alb M.
Lemma flow_ab : 0 < a < b. Proof. apply U. Qed.
Lemma rise : 0 < exp ((b - a) * (p - W)) - 1.
Proof.
  destruct U; assert (0 < (b - a) * (p - W)) by (apply Rmult_lt_0_compat; lra). pose proof (exp_increasing 0 ((b - a)
    * (p - W)) ltac:(lra)); rewrite exp_0 in *; lra.
Qed.
Lemma zh_pos : 0 < zh. Proof. destruct U; apply Rdiv_lt_0_compat; [lra|apply rise]. Qed.
Lemma slip_hat : least_slip M = mu * zh. Proof. unfold least_slip, zh; pose proof rise; field; lra. Qed.
Lemma ell_pos n : 1 <= n -> 0 < ell M n.
Proof.
  intros Hn; destruct U; assert (p * 1 <= p * n) by (apply Rmult_le_compat_l; lra). unfold ell;
    apply Rmin_glb_lt; apply Rdiv_lt_0_compat; try lra; apply Rlt_Rminus, exp_increasing;
    [assert (0 < (b - a) * (p * n - W)) by (apply Rmult_lt_0_compat; lra)| assert (0 < (b - a) * (p * n + W)) by
    (apply Rmult_lt_0_compat; lra)]; lra.
Qed.
Lemma V1h_pos : 0 < V1h. Proof. destruct U; apply Rinv_0_lt_compat, Rmult_lt_0_compat; [lra|apply ell_pos; lra]. Qed.
Lemma V1_hat : V1 M = mu * V1h. Proof. reflexivity. Qed.
Lemma alM_pos : al1 <= alM M.
Proof.
  destruct U; unfold alM; rewrite u_zm0; assert (0 <= Z * mu / (b - a)) by (apply Rmult_le_pos; [apply Rmult_le_pos;
    lra|left; apply Rinv_0_lt_compat; lra]). assert (0 <= a ^ 2 * (mu + Z * mu / (b - a))) by (apply Rmult_le_pos;
    [apply pow2_ge_0|lra]); lra.
Qed.
Lemma decay_1 : 0 < exp (- a * p) < 1.
Proof.
  destruct U; split; [apply exp_pos|rewrite <- exp_0; apply exp_increasing].
  assert (0 < a * p) by (apply Rmult_lt_0_compat; lra); lra.
Qed.
Lemma deeph_pos : 0 < deeph.
Proof.
  pose proof decay_1; destruct U; unfold deeph; assert (0 <= exp (- a * p) * (tau ^ 2 * V1h ^ 2 * mu / (2 * alb M)));
    [|lra]. apply Rmult_le_pos; [lra|]; apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat; lra].
  apply Rmult_le_pos; [apply Rmult_le_pos; apply pow2_ge_0|lra].
Qed.
Lemma vh_pos : 0 < vh.
Proof. pose proof alM_pos; pose proof deeph_pos; destruct U; apply sqrt_lt_R0, Rmult_lt_0_compat; lra. Qed.
Lemma speed_hat : least_speed M = sqrt mu * vh.
Proof.
  pose proof alM_pos; pose proof deeph_pos; destruct U; unfold least_speed, vh; rewrite <- sqrt_mult; [|lra|].
  - f_equal; unfold deep, deeph; rewrite V1_hat; field; lra.
  - apply Rmult_le_pos; lra.
Qed.
Lemma root_pos : 0 < sqrt mu /\ sqrt mu * sqrt mu = mu.
Proof. destruct U; split; [apply sqrt_lt_R0; lra|apply sqrt_sqrt; lra]. Qed.
Variable S : R.
Hypothesis HS : 0 < S.
Hypothesis HV : Vm M = S * sqrt mu.
Definition topped : R := Rmax (S + sqrt mu * Z) (a * sqrt mu) ^ 2 / (2 * al0).
Lemma Ql_hat : Ql M = mu * (1 - topped).
Proof.
  pose proof root_pos as [r0 rr]; destruct U; unfold Ql, topped; rewrite HV, u_zm0; set (r := sqrt mu) in *.
  replace (S * r + Z * mu) with (r * (S + r * Z)) by (rewrite <- rr; ring). replace (a * mu) with (r * (a * r)) by
    (rewrite <- rr; ring); rewrite RmaxRmult by lra. replace ((r * Rmax (S + r * Z) (a * r)) ^ 2) with (r * r * Rmax
      (S
    + r * Z) (a * r) ^ 2) by ring. rewrite rr; field; lra.
Qed.
Lemma Vm_0 : 0 < Vm M. Proof. rewrite HV; apply Rmult_lt_0_compat; [exact HS|apply root_pos]. Qed.
Lemma sigma_0 : 0 < alo M -> 0 < sigma M.
Proof.
  intros Ho; pose proof Vm_0; destruct U; unfold sigma, alo in *. assert (0 <= al0 - b ^ 2 * zm M / (b - a)); [|assert
    (0 <= tau * (al0 - b ^ 2 * zm M / (b - a))) by (apply Rmult_le_pos; lra); lra].
  assert (b ^ 2 * zm M / (b - a) <= b ^ 2 * (zm M + (1 + tau) * Vm M) / (b - a)); [|lra].
  apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|apply Rmult_le_compat_l; [apply pow2_ge_0|]].
  assert (0 <= (1 + tau) * Vm M) by (apply Rmult_le_pos; lra); lra.
Qed.
Lemma B_hat n : B_ M n = sigma M * (1 - topped - phi11 M (p * n - W)) / (((1 + tau) * S + sqrt mu * Z) * S).
Proof.
  pose proof root_pos as [r0 rr]; destruct U; unfold B_; rewrite Ql_hat, HV, u_zm0; set (r := sqrt mu) in *.
  assert (0 <= tau * S) by (apply Rmult_le_pos; lra); assert (0 <= r * Z) by (apply Rmult_le_pos; lra).
  rewrite <- rr; field; assert (0 < r * ((1 + tau) * S + r * Z)) by (apply Rmult_lt_0_compat; lra); repeat split; lra.
Qed.
Lemma B_rises n m : 0 < alo M -> 1 <= n <= m -> B_ M n <= B_ M m.
Proof.
  intros Ho Hn; pose proof root_pos as [r0 rr]; pose proof (sigma_0 Ho); rewrite !B_hat.
  destruct U; assert (0 <= tau * S) by (apply Rmult_le_pos; lra); assert (0 <= sqrt mu * Z) by (apply Rmult_le_pos;
    lra). apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra|apply Rmult_le_compat_l;
    [lra|]]. assert (p * 1 <= p * n) by (apply Rmult_le_compat_l; lra); assert (p * n <= p * m) by (apply
    Rmult_le_compat_l; lra). destruct (phi11_down M flow_ab (p * n - W) (p * m - W) ltac:(lra)) as [P _]; lra.
Qed.
End Hats.

Section Worse.
Variables (L M : machine) (Z S : R).
Hypothesis UL : usable L Z.
Hypothesis UM : usable M Z.
Hypothesis Wo : worse L M.
Hypothesis HS : 0 < S.
Hypothesis HVL : Vm L = S * sqrt (mu L).
Hypothesis HVM : Vm M = S * sqrt (mu M).
Hypothesis Hb : 0 < alb L.
Hypothesis Ho : 0 < alo L.
Let Hab := flow_ab L Z UL.
Ltac same := destruct Wo as [[Ea Eb] [Et Ep] Wmu WW [W0 W1] _]; rewrite ?Ea, ?Eb, ?Et, ?Ep.

Lemma phis T : phi11 M T = phi11 L T /\ phi12 M T = phi12 L T.
Proof. unfold phi11, phi12; same; split; reflexivity. Qed.
Lemma zh_less : zh M <= zh L.
Proof.
  pose proof (rise L Z UL); destruct UL as [? ? ? [? ?] ? ? ?]; unfold zh; same; apply div_mono; [lra|]. split;
    [lra|]; apply Rplus_le_compat_r. destruct (Req_dec (W L) (W M)) as [->|N]; [lra|left;
    apply exp_increasing, Rmult_lt_compat_l; lra].
Qed.
Lemma zm_less : 0 <= zm M <= zm L.
Proof.
  rewrite (u_zm _ _ UM), (u_zm _ _ UL); destruct UM, UL; same; split; [apply Rmult_le_pos|apply Rmult_le_compat_l];
    lra.
Qed.
Lemma ell_more n : 1 <= n -> ell L n <= ell M n.
Proof.
  intros Hn; destruct UM as [? ? ? [? ?] ? ? ?]; unfold ell at 2; destruct (phis (p M * n - W M)) as [_ ->], (phis (p
    M *
    n + W M)) as [_ ->]. same; unfold ell; apply Rmin_glb; apply (phi12_between L Hab); lra.
Qed.
Lemma V1h_less : 0 < V1h M <= V1h L.
Proof.
  split; [apply (V1h_pos M Z UM)|]; pose proof (ell_more 1 ltac:(lra)); pose proof (ell_pos L Z UL 1 ltac:(lra)).
  destruct UL; unfold V1h; same; apply Rinv_le_contravar; [apply Rmult_lt_0_compat; lra|apply Rmult_le_compat_l; lra].
Qed.
Lemma V1_less : 0 <= V1 M <= V1 L.
Proof.
  rewrite !V1_hat; pose proof V1h_less; destruct UM, UL; same; split; [apply Rmult_le_pos; lra|apply mult_mono; lra].
Qed.
Lemma alM_less : alM M <= alM L.
Proof.
  pose proof zm_less; destruct UM, UL; unfold alM; same; apply Rplus_le_compat; [lra|].
  apply Rmult_le_compat_l; [apply pow2_ge_0|]; apply Rplus_le_compat; [lra|apply div_mono; lra].
Qed.
Lemma alb_more : alb L <= alb M.
Proof.
  pose proof zm_less; pose proof V1_less; destruct UM, UL; unfold alb; same. assert (0 <= (1 + tau L) * V1 M <= (1 +
    tau L) * V1 L) by (split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_l; lra]).
  assert (exp (b L * W M) <= exp (b L * W L)).
  { destruct (Req_dec (W L) (W M)) as [->|N]; [lra|left; apply exp_increasing, Rmult_lt_compat_l; lra]. }
  pose proof (exp_pos (b L * W M)); pose proof (pow2_ge_0 (b L)). assert (b L ^ 2 * exp (b L * W M) * (zm M + (1 + tau
    L) * V1 M) / (b L - a L) <= b L ^ 2 * exp (b L * W L) * (zm L + (1 + tau L) * V1 L) / (b L - a L)); [|lra].
  apply div_mono; [|lra]; split; [apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]|]. apply mult_mono; [|lra];
    split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_l; lra].
Qed.
Let HbM : 0 < alb M. Proof. pose proof alb_more; lra. Qed.
Lemma deeph_less : deeph M <= deeph L.
Proof.
  pose proof V1h_less; pose proof alb_more; pose proof (decay_1 L Z UL); destruct UM, UL; unfold deeph; same.
  apply Rplus_le_compat_l, Rmult_le_compat_l; [lra|]; pose proof (pow2_ge_0 (tau L)); pose proof (pow2_ge_0 (V1h M)).
  apply div_mono; [|lra]; split; [apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]|]. apply mult_mono; [|lra];
    split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_l; [lra|apply pow2_mono; lra]].
Qed.
Lemma vh_less : 0 < vh M <= vh L.
Proof.
  pose proof deeph_less; pose proof (deeph_pos M Z UM HbM); pose proof alM_less; pose proof (alM_pos M Z UM); destruct
    UM. split; [apply (vh_pos M Z); trivial|]; apply sqrt_le_1_alt, mult_mono; lra.
Qed.
Lemma root_less : 0 < sqrt (mu M) <= sqrt (mu L).
Proof. destruct UM; same; split; [apply sqrt_lt_R0; lra|apply sqrt_le_1_alt; lra]. Qed.
Lemma speed_less : 0 <= (1 + tau M) * Vm M <= (1 + tau L) * Vm L.
Proof.
  rewrite HVM, HVL; pose proof root_less; destruct UL; same. assert (0 <= S * sqrt (mu M)) by (apply Rmult_le_pos;
    lra). assert (S * sqrt (mu M) <= S * sqrt (mu L)) by (apply Rmult_le_compat_l; lra).
  split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_l; lra].
Qed.
Lemma alo_more : alo L <= alo M.
Proof.
  pose proof speed_less; pose proof zm_less; destruct UL; unfold alo; pose proof (pow2_ge_0 (b L)); revert H;
    same; intros H. assert (b L ^ 2 * (zm M + (1 + tau L) * Vm M) / (b L - a L) <= b L ^ 2 * (zm L + (1 + tau L) * Vm
    L) / (b L
    - a L)); [|lra].
  apply div_mono; [|lra]; split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_l; lra].
Qed.
Lemma sigma_more : sigma L <= sigma M.
Proof.
  pose proof alo_more; pose proof zm_less; destruct UL; unfold sigma; pose proof (pow2_ge_0 (b L)); same.
  apply Rplus_le_compat; [apply Rmult_le_compat_l; [lra|]|lra]. assert (b L ^ 2 * zm M / (b L - a L) <= b L ^ 2 * zm L
    / (b L - a L)); [|lra]. apply div_mono; [|lra]; split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_l; lra].
Qed.
Lemma topped_less : topped M Z S <= topped L Z S.
Proof.
  pose proof root_less; destruct UL; unfold topped; same. assert (0 <= sqrt (mu M) * Z) by (apply Rmult_le_pos; lra).
  assert (sqrt (mu M) * Z <= sqrt (mu L) * Z) by (apply Rmult_le_compat_r; lra). assert (a L * sqrt (mu M) <= a L *
    sqrt
    (mu L)) by (apply Rmult_le_compat_l; lra). apply div_mono; [|lra]; split; [apply pow2_ge_0|];
    apply pow2_mono; split.
  - eapply Rle_trans; [|apply Rmax_l]; lra.
  - apply Rmax_lub; [eapply Rle_trans; [|apply Rmax_l]; lra|eapply Rle_trans; [|apply Rmax_r]; lra].
Qed.
Lemma A_more n : 1 <= n -> A_ L n <= A_ M n.
Proof.
  intros Hn; pose proof (ell_more n Hn); pose proof (ell_pos L Z UL n Hn); pose proof (sigma_0 L Z UL S HS HVL Ho);
    pose proof sigma_more. pose proof (Vm_0 M Z UM S HS HVM); unfold A_; apply div_mono; [split; [apply Rmult_le_pos;
    lra|apply mult_mono; lra]|split; trivial]. rewrite HVM, HVL; pose proof root_less; apply Rmult_le_compat_l; lra.
Qed.
Lemma B_more n : 1 <= n -> 0 < B_ L n -> B_ L n <= B_ M n.
Proof.
  intros Hn; rewrite (B_hat L Z UL S HS HVL), (B_hat M Z UM S HS HVM); intros Pos; pose proof (sigma_0 L Z UL S HS HVL
    Ho) as S0; pose proof sigma_more. pose proof topped_less; pose proof root_less. destruct (phis (p M * n - W M)) as
      [-> _]. set (q := 1 - topped L Z S - phi11 L (p L * n - W L)) in *; set (q' := 1 - topped M Z S - phi11 L (p M *
    n - W M)). assert (Q' : q <= q').
  { unfold q, q'; destruct UL as [? ? ? [? ?] ? ? ?]; same; assert (p L * 1 <= p L * n) by (apply Rmult_le_compat_l;
      lra). destruct (phi11_down L Hab (p L * n - W L) (p L * n - W M) ltac:(lra)) as [P _]; lra. }
  assert (C : 0 < ((1 + tau M) * S + sqrt (mu M) * Z) * S <= ((1 + tau L) * S + sqrt (mu L) * Z) * S).
  { destruct UM, UL; same; assert (0 <= tau L * S) by (apply Rmult_le_pos; lra); assert (0 <= sqrt (mu M) * Z) by
      (apply Rmult_le_pos; lra). assert (sqrt (mu M) * Z <= sqrt (mu L) * Z) by (apply Rmult_le_compat_r; lra); split;
      [apply Rmult_lt_0_compat; lra|apply Rmult_le_compat_r; lra]. } set (c := ((1 + tau L) * S + sqrt (mu L) * Z) *
  S) in *; assert (Q0 : 0 < q).
  { apply Rnot_le_lt; intros F; assert (0 <= sigma L * - q) by (apply Rmult_le_pos; lra).
    assert (0 <= sigma L * - q / c) by (apply Rmult_le_pos; [trivial|left; apply Rinv_0_lt_compat; lra]).
    replace (sigma L * - q / c) with (- (sigma L * q / c)) in * by (field; lra); lra. }
  apply div_mono; [split; [apply Rmult_le_pos; lra|apply mult_mono; lra]|exact C].
Qed.
Lemma stretches_more n e : (1 <= n)%Z -> 0 < e -> stretches L e n -> stretches M e n.
Proof.
  intros Hn He [X|X]; [left|right]; apply Rle_trans with (1 := X); [apply A_more|apply B_more]; try lra; apply (IZR_le
    1), Hn.
Qed.
End Worse.

Theorem Range : Range_statement.
Proof.
  intros L E m M lo hi [w0 a0 [Hb [Hz Hv]] Ho HE Hm HA HB] H Wo; pose proof (same_set _ _ Wo) as (Z & S & E1 & E2 & E3
    & E4). assert (Z0 : 0 <= Z).
  { destruct Wo as [[? ?] [? ?] ? ? _ _], H; assert (0 < (b L - a L) * (p L - W L)) by (apply Rmult_lt_0_compat; lra);
      pose proof (exp_increasing 0 ((b L - a L) * (p L - W L)) ltac:(lra)) as X; rewrite exp_0 in X. assert (0 <
      least_slip L) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra). apply Rnot_lt_le; intros F; assert
        (0 <
      - Z * mu L) by (apply Rmult_lt_0_compat; lra); lra. } assert (UM : usable M Z).
  { destruct H; destruct reached as (t & Et); assert (al0 M <= al1 M) by (pose proof (bent lo ltac:(lra)); lra);
      constructor; trivial; lra. } assert (UL : usable L Z) by (destruct UM, Wo as [[? ?] [? ?] ? ? [? ?] _];
  constructor; trivial; lra).
  destruct (root_pos L Z UL) as [r0 _], (root_pos M Z UM) as [r1 _]; rewrite (slip_hat L Z UL), E2 in Hz; rewrite
    (speed_hat L Z UL Hb), E4 in Hv; pose proof (vh_pos L Z UL Hb) as v0. assert (Zh : zh L <= Z) by (apply
    Rmult_le_reg_r with (mu L); [apply UL|lra]). assert (Vh : vh L <= S) by (apply Rmult_le_reg_r with (sqrt (mu L));
    lra); assert (HS : 0 < S) by lra. assert (Hm1 : 1 <= IZR m) by (apply (IZR_le 1); lia); pose proof (alb_more L M Z
      UL UM Wo) as Ab; constructor; [constructor| |]; trivial.
  - pose proof (zh_less L M Z UL Wo); pose proof (vh_less L M Z UL UM Wo Hb); split; [lra|]; rewrite (slip_hat M Z
      UM), (speed_hat M Z UM ltac:(lra)), E1, E3, (Rmult_comm Z), (Rmult_comm S); split; apply Rmult_le_compat_l; try
      lra; left; apply UM.
  - pose proof (alo_more L M Z S UL UM Wo HS E4 E3); lra.
  - intros n Hn; apply (stretches_more L M Z S UL UM Wo HS E4 E3 Ho); [exact Hn|lra|].
    destruct (Z_lt_le_dec n m) as [C|C]; [apply HA; lia|right]; apply Rle_trans with (1 := HB).
    apply (B_rises L Z UL S HS E4); trivial; split; [apply (IZR_le 1)|apply IZR_le]; lia.
Qed.
