(** * Proof of the word theorem, and that with damping one mu0 serves all patterns *)

From Coq Require Import Reals ZArith List Arith Lra Lia.
From Grazing Require Import Defs StatementWords WordAlgebra WordPath WordGraph WordPatterns WordPlane WordFinite
  Headline StatementSystems Systems.
Import ListNotations.
Open Scope R_scope.

Lemma vertex_bound a1 a2 K w i j : first_upper a1 a2 K -> path a1 a2 K w i j ->
  forall x, In x (vertices K w) -> (fst x <= i + j)%nat.
Proof.
  intros HK Hp [k []] Hk; cbn [fst]; destruct (pairs a1 a2 K HK (decided_everywhere _ _ _ HK) w i j Hp)
    as (H1 & H2 & _); [specialize (H1 k Hk) | specialize (H2 k Hk)]; lia.
Qed.

Theorem Words : Words_statement.
Proof.
  intros a1 a2 K HK; split; [intros H2; exact (word_ends a1 a2 K HK H2)|].
  intros w i j Hp HV He; pose proof (decided_everywhere _ _ _ HK) as Hdec.
  assert (HV' : forall x, In x (vertices K w) -> member a1 a2 Plus (fst x)) by (apply Forall_forall; assumption).
  split.
  { intros n; rewrite in_map_iff; split; [|intros (x & <- & Hx); apply HV', Hx].
    intros Hn; destruct (V_is_word a1 a2 K HK Hdec w i j Hp (proj1 He) n Hn) as (x & Hx & <-); eauto. }
  intros S gamma HS; destruct (Theorem_1 S a1 a2 gamma HS (i + j)%nat) as (d & Hd & H).
  exists d; split; [exact Hd|]; intros eps Heps; destruct (H eps Heps) as (mu0 & Hm & W).
  exists mu0; split; [exact Hm|]; intros n g mu Hn Hg Hmu.
  assert (HE : forall l, edge a1 a2 Plus (if arrow K w (n l) (n (l + 1)%Z) then Plus else Minus) (fst (n l))
    (fst (n (l + 1)%Z))).
  { intros l; apply (word_edges a1 a2 K HK Hdec w i j Hp HV); [apply Hn..|left; exact He]. }
  destruct (W (fun l => fst (n l)) Plus g mu) as [Hex Hno]; [| exact Hg | cbn [sgn]; lra | split].
  - intros l; destruct (HV' _ (Hn l)) as [Hu _]; pose proof (u_nonzero_pos _ _ _ Hu).
    pose proof (vertex_bound a1 a2 K w i j HK Hp _ (Hn l)); tauto.
  - intros Hwalk; apply Hex; intros l; split; [apply (HV' _ (Hn l))|]. specialize (HE l); rewrite Hwalk in HE; exact HE.
  - intros [l Hne]; apply Hno; exists l; right; specialize (HE l); unfold edge in HE.
    destruct (arrow K w (n l) (n (l + 1)%Z)), g; cbn [sgn] in *; tauto || lra.
Qed.

Theorem V_finite : V_finite_statement.
Proof.
  intros a1 a2 K HK H2; destruct (WordFinite.V_finite a1 a2 K HK H2) as [L HL]; exists L; intros n Hn.
  destruct (le_lt_dec n L) as [H|H]; [exact H | exfalso; apply (HL n); [lia | exact Hn]].
Qed.

Theorem All_patterns : All_patterns_statement.
Proof.
  intros S a1 a2 gamma K HS HK H2; destruct (V_finite a1 a2 K HK H2) as [L HL].
  destruct (Patterns S a1 a2 gamma HS L) as (d & Hd & H); exists d; split; [exact Hd|].
  intros eps Heps; destruct (H eps Heps) as (mu0 & Hm & W); exists mu0; split; [exact Hm|].
  intros l g mu Hg Hmu Hp; apply (W l Plus g mu); try assumption.
  - intros ->; destruct Hp as [_ []].
  - destruct Hp as [Hv _]; revert Hv; apply Forall_impl; intros n Hn; destruct (Hn) as [Hu _].
    pose proof (u_nonzero_pos _ _ _ Hu); specialize (HL n Hn); tauto.
  - cbn [sgn]; lra.
Qed.
