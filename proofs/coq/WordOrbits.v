(** * The walks of the graph are orbits: Theorem 1 in the plane and the word theorem *)

From Coq Require Import Reals List Arith Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane StatementWords
  StatementWordOrbits PlaneOrbits WordAlgebra WordPath WordGraph WordPatterns WordPlane.
Import ListNotations. Open Scope R_scope.

Theorem Shift_orbits : Shift_orbits_statement.
Proof.
  intros M a1 a2 gamma e w0 HM H2 n_max.
  destruct (Theorem1_plane M a1 a2 gamma e w0 HM n_max) as (d & mu0 & Hd & Hmu & H & _).
  exists d, mu0; split; [assumption | split; [assumption|]].
  intros J next prev n s g mu Hbij Hg Hs Hn.
  destruct (H J next prev n s g mu Hbij) as [Hex _]; trivial.
  - intros j; destruct (Hn j) as [Hle [Hu _]]; pose proof (u_nonzero_pos _ _ _ Hu); tauto.
  - apply Hex; intros j; destruct (Hn j) as [_ Ho]; split; [apply Ho|].
    apply (full_shift a1 a2 s H2 g); apply Hn.
Qed.

Lemma vertex_bound a1 a2 K w i j : first_upper a1 a2 K -> path a1 a2 K w i j ->
  forall x, In x (vertices K w) -> (fst x <= i + j)%nat.
Proof.
  intros HK Hp [k []] Hk; cbn [fst];
    destruct (pairs a1 a2 K HK (decided_everywhere _ _ _ HK) w i j Hp) as (H1 & H2 & _);
    [specialize (H1 k Hk) | specialize (H2 k Hk)]; lia.
Qed.

Theorem Word_orbits : Word_orbits_statement.
Proof.
  intros M a1 a2 gamma e w0 HM K w i j HK Hp HV He; pose proof (decided_everywhere _ _ _ HK) as Hdec.
  assert (HV' : forall x, In x (vertices K w) -> member a1 a2 Plus (fst x))
    by (apply Forall_forall; assumption).
  split.
  { intros n; rewrite in_map_iff; split; [|intros (x & <- & Hx); apply HV', Hx].
    intros Hn; destruct (V_is_word a1 a2 K HK Hdec w i j Hp (proj1 He) n Hn) as (x & Hx & <-); eauto. }
  destruct (Theorem1_plane M a1 a2 gamma e w0 HM (i + j)%nat) as (d & mu0 & Hd & Hmu & H & _).
  exists d, mu0; split; [assumption | split; [assumption|]].
  intros J next prev n g mu Hbij Hg Hs Hn.
  assert (HE : forall k, edge a1 a2 Plus (if arrow K w (n k) (n (next k)) then Plus else Minus)
    (fst (n k)) (fst (n (next k)))).
  { intros k; apply (word_edges a1 a2 K HK Hdec w i j Hp HV); [apply Hn..|left; exact He]. }
  destruct (H J next prev (fun k => fst (n k)) Plus g mu Hbij) as [Hex Hno]; trivial.
  { intros k; destruct (HV' _ (Hn k)) as [Hu _]; pose proof (u_nonzero_pos _ _ _ Hu).
    pose proof (vertex_bound a1 a2 K w i j HK Hp _ (Hn k)); tauto. }
  { cbn [sgn]; lra. }
  split.
  - intros Hwalk; apply Hex; intros k; split; [apply (HV' _ (Hn k))|].
    specialize (HE k); rewrite Hwalk in HE; exact HE.
  - intros k Hne; apply (Hno k); right; specialize (HE k); unfold edge in HE; unfold follows.
    unfold p, q in HE; destruct (arrow K w (n k) (n (next k))), g; cbn [sgn] in *; tauto || lra.
Qed.
