(** * To mu = 0.003 legs of one, two and three periods follow each other in every order *)

From Coq Require Import Reals QArith Qreals ZArith Lra Lia List.
From Grazing Require Import PathsFlow ChaosCertificates StatementPaths StatementChaos Chaos.
Open Scope R_scope.

Definition three_letters (n : Z) : Letter.t := if (n =? 1)%Z then one' else if (n =? 2)%Z then two' else
  three'.
Definition three_letters_of (N : Z -> Z) (i : Z) : Letter.t := three_letters (N (i + 1) - N i)%Z.

Lemma three_cases N : one_to_three N -> forall i, three_letters_of N i = one' /\ (N (i + 1) = N i + 1)%Z \/
  three_letters_of N i = two' /\ (N (i + 1) = N i + 2)%Z \/ three_letters_of N i = three' /\ (N (i + 1) = N i + 3)%Z.
Proof.
  intros H i; unfold three_letters_of, three_letters.
  destruct (H i) as [E|[E|E]]; rewrite E; [left | right; left | right; right]; split; trivial.
  - replace (N i + 1 - N i)%Z with 1%Z by lia; reflexivity.
  - replace (N i + 2 - N i)%Z with 2%Z by lia; reflexivity.
  - replace (N i + 3 - N i)%Z with 3%Z by lia; reflexivity.
Qed.

Lemma three_path N : one_to_three N -> leg_path chaos_123 (three_letters_of N) /\ turns (three_letters_of N) N.
Proof.
  intros H; pose proof (three_cases N H) as C; split; intros i; destruct (C i) as [[-> E]|[[-> E]|[-> E]]];
    try (rewrite E; reflexivity); (split; [cbn; tauto|]); (destruct (C (i + 1)%Z) as [[-> _]|[[-> _]|[-> _]]];
    [exists 0%nat | exists 1%nat | exists 2%nat]; cbn; tauto).
Qed.

Lemma three_covered mu : 0 < mu <= 3 / 1000 -> covers chaos_123 (machine mu).
Proof.
  intros H; pose proof (nu_range mu ltac:(lra)) as Hn; destruct (machine_wall mu 0) as (E1 & E2 & _).
  assert (G : g (machine mu) 0 = 1 /\ g1 (machine mu) 0 = 0) by (rewrite E1, E2, cos_0, sin_0; lra); clear E1 E2.
  assert (Hd : mu / (1 + mu) <= 3 / 1003).
  { apply (Rmult_le_reg_r (1 + mu)); [lra|]; unfold Rdiv at 1; rewrite Rmult_assoc, Rinv_l; lra. }
  constructor; try apply G; try (unfold in_interval, Q2R; cbn; lra).
  constructor; [|constructor]; unfold in_interval, Q2R; cbn; repeat split; lra.
Qed.

Lemma three_boxes mu N t v : mu > 0 -> one_to_three N ->
  (in_three_boxes mu N t v <-> in_boxes (machine mu) (three_letters_of N) t (scaled mu v)).
Proof.
  intros Hmu HN; pose proof (three_cases N HN) as C; unfold in_three_boxes, in_boxes, scaled.
  split; intros H i j E; specialize (H i j E); subst j.
  - rewrite !within_scaled by exact Hmu; destruct H as (H1 & H2 & H3), (C i) as [[-> E]|[[-> E]|[-> E]]];
      [specialize (H1 E) | specialize (H2 E) | specialize (H3 E)]; unfold Q2R; cbn; lra.
  - rewrite !within_scaled in H by exact Hmu.
    destruct (C i) as [[L E]|[[L E]|[L E]]]; rewrite L in H; unfold Q2R in H; cbn in H; (split; [|split]); intros E';
      try (rewrite E in E'; lia); lra.
Qed.

Theorem Chaos_three : Chaos_three_statement.
Proof.
  intros mu N Hmu HN; destruct (three_path N HN) as [HP HT]; assert (H0 : mu > 0) by lra.
  destruct (scaled_motion chaos_123 mu (three_letters_of N) N H0 checked_123 (three_covered mu Hmu) HP HT)
    as (t & y & v & HM & HB & H1).
  - unfold Q2R; cbn; lra.
  - intros t v HB i; apply (three_boxes mu N t v H0 HN) in HB; destruct (HB i _ eq_refl) as (B1 & B2 & B3).
    destruct (HB (i + 1)%Z _ eq_refl) as (C1 & C2 & C3); destruct (HN i) as [E|[E|E]];
      [specialize (B1 E) | specialize (B2 E) | specialize (B3 E)]; destruct (HN (i + 1)%Z) as [F|[F|F]];
      (specialize (C1 F) || specialize (C2 F) || specialize (C3 F)); apply Rabs_def1; lra.
  - exists t, y, v; split; [exact HM|]; split; [apply three_boxes; assumption|].
    intros t' y' v' HM' HB'; apply H1; [exact HM' | apply three_boxes; assumption].
Qed.
