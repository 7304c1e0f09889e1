(** * Proof of the worked instances of [StatementWords] *)

From Coq Require Import Reals List Arith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementWords StatementExamples Algebra Coordinates
  WordAlgebra WordPath WordRegion3 WordPatterns WordPlane.
Import ListNotations. Open Scope R_scope.

Section Small.
Variables a1 a2 : R.
Hypothesis a1_nonzero : a1 <> 0.

Lemma u_3 : u a1 a2 3 = a1 ^ 2 - a2. Proof. rewrite u_SS, u_2, u_1; ring. Qed.
Lemma p_1 : p a1 a2 1 = a1 - 1. Proof. unfold p; rewrite u_2, u_1; field. Qed.
Lemma q_1 : q a1 a2 1 = a2. Proof. unfold q; cbn [Nat.sub]; rewrite u_1, u_0; field. Qed.
Lemma p_2 : p a1 a2 2 = (a1 ^ 2 - a2 - 1) / a1. Proof. unfold p; rewrite u_3, u_2; reflexivity. Qed.
Lemma q_2 : q a1 a2 2 = (a2 ^ 2 + a2) / a1.
Proof. unfold q; cbn [Nat.sub]; rewrite u_2, u_1; field; assumption. Qed.
Lemma b_2_1 : b a1 a2 2 1 = (a1 - 1 - a2) / a1.
Proof. unfold b; cbn [Nat.sub]; rewrite u_2, u_1; field; assumption. Qed.
End Small.

Lemma sign_quotient x y : y <> 0 -> (x / y > 0 <-> x * y > 0) /\ (x / y < 0 <-> x * y < 0).
Proof.
  intros Hy; assert (0 < y * y) by nra; assert (E : x * y = x / y * (y * y)) by (field; assumption).
  set (z := x / y) in *; clearbody z; rewrite E; split; split; intros; nra.
Qed.
Lemma pattern_1_2 a1 e g : -2 < a1 < 2 -> (pattern a1 1 e g [1; 2]%nat <-> 0 < a1 /\ e = Minus /\ g = Plus \/
  -1 < a1 < 0 /\ e = Plus /\ g = Plus \/ a1 < -1 /\ e = Plus /\ g = Minus).
Proof.
  intros Ha; destruct (Req_dec a1 0) as [->|Hne].
  { split; [|lra]; intros [Hl _]; rewrite !Forall_cons_iff in Hl; destruct Hl as (_ & [Hu _] & _).
    rewrite u_2 in Hu; lra. }
  assert (Hb : b a1 1 2 1 = (a1 - 2) / a1) by (rewrite b_2_1 by assumption; f_equal; ring).
  assert (E1 : p a1 1 2 - q a1 1 1 = (a1 - 2) / a1 * (a1 + 1)) by (rewrite p_2, q_1 by assumption; field; assumption).
  assert (E2 : p a1 1 1 - q a1 1 2 = (a1 - 2) / a1 * (a1 + 1)) by (rewrite p_1, q_2 by assumption; field; assumption).
  assert (Hm : pattern a1 1 e g [1; 2]%nat <-> sgn e * ((a1 - 2) / a1) > 0 /\ sgn e * sgn g * ((a1 - 2) / a1 * (a1 + 1))
    > 0).
  { rewrite pattern_two; unfold edge, member; rewrite E1, E2, u_1, u_2; split.
    - intros (_ & [_ H] & H' & _); specialize (H 1%nat ltac:(lia)); rewrite Hb in H; tauto.
    - intros [H H']; split; [split; [lra | intros k Hk; lia]|]. split; [split; [assumption|]|tauto].
      intros k Hk; replace k with 1%nat by lia; rewrite Hb; assumption. }
  rewrite Hm; clear Hm Hb E1 E2; destruct (sign_quotient (a1 - 2) a1 Hne) as [Hp Hn].
  set (z := (a1 - 2) / a1) in *; clearbody z. destruct (Rdichotomy _ _ Hne) as [Hs|Hs].
  - assert (Hz : z > 0) by (apply Hp; nra); clear Hp Hn. destruct (Rtotal_order (a1 + 1) 0) as [H1|[H1|H1]].
    + assert (z * (a1 + 1) < 0) by nra.
      destruct e, g; cbn [sgn]; split; intros H0; try lra; intuition (congruence || lra).
    + rewrite H1, !Rmult_0_r; destruct e, g; cbn [sgn]; split; intros H0; try lra; intuition (congruence || lra).
    + assert (z * (a1 + 1) > 0) by nra.
      destruct e, g; cbn [sgn]; split; intros H0; try lra; intuition (congruence || lra).
  - assert (Hz : z < 0) by (apply Hn; nra); assert (z * (a1 + 1) < 0) by nra.
    destruct e, g; cbn [sgn]; split; intros H0; try lra; intuition (congruence || lra).
Qed.
Lemma trace_fifth : 0 < trace 1 (1 / 5) < 1.
Proof.
  unfold trace; pose proof PI_RGT_0; split.
  - assert (0 < cos (2 * PI * (1 / 5))) by (apply cos_gt_0; lra); lra.
  - assert (cos (2 * PI * (1 / 5)) < cos (PI / 3)) by (apply cos_decreasing_1; lra). rewrite cos_PI3 in *; lra.
Qed.
Theorem Pattern_1_2 : Pattern_1_2_statement.
Proof.
  split; [intros; apply pattern_1_2; assumption|]; intros e g; pose proof trace_fifth as Ht.
  split; [rewrite pattern_1_2 by lra; intuition lra|]. set (x := trace 1 (1 / 5)) in *; clearbody x.
  assert (Eu : u x 1 3 = x ^ 2 - 1) by apply u_3; assert (Hu : u x 1 3 < 0) by (rewrite Eu; nra).
  assert (Hb : b x 1 3 1 > 0 /\ b x 1 3 2 > 0).
  { assert (E1 : b x 1 3 1 * u x 1 3 = (x - 2) * (x + 1)) by (rewrite b_N by lra; unfold N; cbn [Nat.sub];
      rewrite Eu, u_1, u_2; ring).
    assert (E2 : b x 1 3 2 * u x 1 3 = (x - 2) * (x + 1)) by (rewrite b_N by lra; unfold N; cbn [Nat.sub];
      rewrite Eu, u_1, u_2; ring).
    assert ((x - 2) * (x + 1) < 0) by nra; split; nra. }
  assert (Hc : c x 1 3 > 0).
  { apply (sign_c x 1); try lra; rewrite Rabs_right; lra. }
  split.
  - intros (_ & H & H'); specialize (H 1%nat ltac:(lia)); destruct e, g; cbn [sgn] in *; intuition lra.
  - intros [-> ->]; split; [lra | split; [|cbn [sgn]; lra]]. intros k Hk; cbn [sgn]; rewrite Rmult_1_l.
    assert (k = 1 \/ k = 2)%nat as [->| ->] by lia; apply Hb.
Qed.

(** The periods below K where eµ < 0. *)
Lemma K_is_4 s : 3 * s <= 1 / 2 < 4 * s -> 2 * (INR 4 - 1) * s <= 1 < 2 * INR 4 * s.
Proof. cbn [INR]; lra. Qed.
Theorem Resonance : Resonance_statement.
Proof.
  intros r Hr; assert (Hs : 0 < 1 / 6 < 1 / 2) by lra.
  assert (HK : first_upper (trace r (1 / 6)) (r ^ 2) 4).
  { apply (proj2 (proj2 Path) r (1 / 6) 4%nat Hr Hs), K_is_4; lra. }
  assert (Et : trace r (1 / 6) = r).
  { unfold trace; replace (2 * PI * (1 / 6)) with (PI / 3) by field; rewrite cos_PI3; field. }
  assert (H0 : u (trace r (1 / 6)) (r ^ 2) 3 = 0) by (rewrite u_3, Et; ring).
  destruct (W4 _ _ _ HK) as (_ & _ & HM), (W3 _ _ _ HK) as (_ & _ & V4 & _). split; [intros l; rewrite HM|].
  - assert (E : forall n, (n < 4)%nat /\ u (trace r (1 / 6)) (r ^ 2) n <> 0 <-> n = 1%nat \/ n = 2%nat).
    { intros n; split.
      - intros [Hn Hu]; assert (n = 0 \/ n = 1 \/ n = 2 \/ n = 3)%nat as [->|[->|[->| ->]]] by lia;
          [rewrite u_0 in Hu; lra | tauto | tauto | lra].
      - intros [->| ->]; [rewrite u_1 | rewrite u_2, Et]; split; lia || lra. }
    split; [intros (_ & Hne & Hl) | intros [Hne Hl]; split; [reflexivity|]]; (split; [assumption|]); revert Hl;
      apply Forall_impl; intros n; apply E.
  - intros g; rewrite pattern_single, (orbit_case _ _ _ HK); pose proof (K_upper _ _ _ HK) as Hu.
    split; [intros (x & Hx & -> & _); destruct x; [cbn [on] in Hx; lra | reflexivity]|].
    intros ->; exists U; repeat split; trivial; apply V4.
Qed.
Theorem Oscillator : Oscillator_statement.
Proof.
  intros r l Hr; assert (Hs : 0 < 8 / 49 < 1 / 2) by lra.
  assert (HK : first_upper (trace r (8 / 49)) (r ^ 2) 4).
  { apply (proj2 (proj2 Path) r (8 / 49) 4%nat Hr Hs), K_is_4; lra. }
  destruct (W4 _ _ _ HK) as (_ & _ & HM); split.
  { intros Hl; apply HM in Hl; destruct Hl as [E _]; discriminate E. }
  rewrite HM.
  assert (E : forall n, (n < 4)%nat /\ u (trace r (8 / 49)) (r ^ 2) n <> 0 <-> (1 <= n <= 3)%nat).
  { intros n; split; [intros [Hn Hu]; pose proof (u_nonzero_pos _ _ _ Hu); lia|].
    intros Hn; split; [lia|]; apply Rgt_not_eq, (u_sign r (8 / 49) Hr Hs n 0).
    - assert (INR n <= INR 3) by (apply le_INR; lia); assert (INR 1 <= INR n) by (apply le_INR; lia).
      change (INR 0) with 0; cbn [INR] in *; apply Rabs_def1; lra.
    - assert (INR 1 <= INR n) by (apply le_INR; lia); change (INR 0) with 0; cbn [INR] in *; lra. }
  split; [intros (_ & Hne & Hl) | intros [Hne Hl]; split; [reflexivity|]]; (split; [assumption|]); revert Hl;
    apply Forall_impl; intros n; apply E.
Qed.

(** Numbers, one after the other. *)
Section Five.
Notation a1 := (-2 / 3).
Notation a2 := (8 / 9).
Notation u := (u a1 a2).

Lemma next k x y z : u k = x -> u (S k) = y -> z = a1 * y - a2 * x -> u (S (S k)) = z.
Proof. intros <- <- ->; apply u_SS. Qed.
Lemma u_values : u 2 = -2 / 3 /\ u 3 = -4 / 9 /\ u 4 = 8 / 9 /\ u 5 = -16 / 81 /\
  u 6 = -160 / 243 /\ u 7 = 448 / 729 /\ u 8 = 128 / 729.
Proof.
  assert (E2 : u 2 = -2 / 3) by apply u_2.
  assert (E3 : u 3 = -4 / 9) by (apply (next 1 1 (-2 / 3)); [apply u_1 | assumption | field]).
  assert (E4 : u 4 = 8 / 9) by (apply (next 2 _ _ _ E2 E3); field).
  assert (E5 : u 5 = -16 / 81) by (apply (next 3 _ _ _ E3 E4); field).
  assert (E6 : u 6 = -160 / 243) by (apply (next 4 _ _ _ E4 E5); field).
  assert (E7 : u 7 = 448 / 729) by (apply (next 5 _ _ _ E5 E6); field).
  assert (E8 : u 8 = 128 / 729) by (apply (next 6 _ _ _ E6 E7); field). tauto.
Qed.
Definition side_of (n : nat) : letter := match n with 2%nat | 3%nat => U | _ => D end.

Lemma five_word : first_upper a1 a2 2 /\ path a1 a2 2 [U; D; D] 7 3 /\
  Forall (fun x => member a1 a2 Plus (fst x)) (vertices 2 [U; D; D]) /\ ends a1 a2 7 3.
Proof.
  destruct u_values as (E2 & E3 & E4 & E5 & E6 & E7 & E8).
  assert (HK : first_upper a1 a2 2).
  { assert (4 / 9 < sqrt (8 / 9)).
    { rewrite <- (sqrt_pow2 (4 / 9)) by lra; apply sqrt_lt_1; lra. }
    repeat split; try lra; [cbn [on]; lra|]. intros [|[|k]] Hk; [rewrite u_0 | rewrite u_1 | lia]; lra. }
  assert (P4 : path a1 a2 2 [U; D] 4 3).
  { apply (path_D a1 a2 2 [U] 1 3); [apply (path_U a1 a2 2 [] 1 2); [constructor|]|]; cbn [on Nat.add]; lra. }
  assert (P7 : path a1 a2 2 [U; D; D] 7 3).
  { apply (path_D a1 a2 2 [U; D] 4 3); [assumption|]; cbn [on Nat.add]; lra. }
  assert (p3 : p a1 a2 3 = 1 / 4) by (unfold p; rewrite E4, E3; field).
  assert (q3 : q a1 a2 3 = -20 / 81) by (unfold q; cbn [Nat.sub]; rewrite E2, E3; field).
  assert (q4 : q a1 a2 4 = 188 / 729) by (unfold q; cbn [Nat.sub]; rewrite E3, E4; field).
  assert (p7 : p a1 a2 7 = -601 / 448) by (unfold p; rewrite E8, E7; field).
  assert (q7 : q a1 a2 7 = -10972 / 45927) by (unfold q; cbn [Nat.sub]; rewrite E6, E7; field).
  destruct (W5_neighbours a1 a2 2%nat _ _ _ HK P4) as (_ & [H7 _] & _).
  destruct (W5_neighbours a1 a2 2%nat _ _ _ HK P7) as ([_ HU] & [_ HD] & _).
  split; [assumption | split; [assumption | split]].
  - change (vertices 2 [U; D; D]) with (vertices 2 [U; D] ++ [(7%nat, D)]).
    destruct (H7 ltac:(lra)) as [V7 _]; destruct (W3 a1 a2 2%nat HK) as (_ & _ & _ & _ & HF).
    apply Forall_app; split; [|apply Forall_cons; [exact V7 | constructor]].
    specialize (HF _ _ _ P4 V7); revert HF; apply Forall_impl; tauto.
  - split; [|split; lra]; intros H10; destruct (Rdichotomy _ _ (proj1 H10)) as [Hs|Hs].
    + specialize (HU (conj H10 Hs)); lra.
    + specialize (HD (conj H10 Hs)); lra.
Qed.
Theorem Five_periods : Five_periods_statement.
Proof.
  destruct five_word as (HK & HP & HV & He); destruct (W5 a1 a2 2%nat _ _ _ HK HP HV) as [HE _].
  assert (Hall : forall n, In n five -> In (n, side_of n) (vertices 2 [U; D; D])).
  { intros n Hn; cbn [In five] in Hn; repeat destruct Hn as [<-|Hn]; cbn; tauto. }
  split.
  - intros n; split.
    + intros Hn; destruct (V_is_word a1 a2 2 HK (decided_everywhere _ _ _ HK) _ _ _ HP (proj1 He) n Hn)
        as (x & Hx & <-); cbn in Hx; repeat destruct Hx as [<-|Hx]; cbn; tauto.
    + intros Hn; rewrite Forall_forall in HV; apply (HV _ (Hall n Hn)).
  - intros i j Hi Hj; specialize (HE _ _ (Hall i Hi) (Hall j Hj) (or_introl He)); cbn [fst] in HE.
    cbn [In five] in Hi, Hj; repeat destruct Hi as [<-|Hi]; try tauto; repeat destruct Hj as [<-|Hj]; try tauto;
      cbn in HE; (split; intros H; [try exact HE | try exact HE]); exfalso; cbn in H; intuition congruence.
Qed.
End Five.

Theorem Boundary : Boundary_statement.
Proof.
  unfold Boundary_statement, edge, sgn; rewrite !p_1, !q_1, !p_2, !q_2, !u_3 by lra; unfold b; cbn [Nat.sub].
  rewrite !u_3, !u_2, !u_1; repeat split; try lra; field.
Qed.
