(** * The walks of the graph are orbits: Theorem 1 in the plane and the word theorem *)

From Coq Require Import Reals List Arith Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane StatementWords
  StatementWordOrbits StatementOrbitsPatterns PlaneOrbits PatternOrbits WordAlgebra WordPath WordGraph
  WordPatterns WordPlane WordFinite.
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

(** A pattern over V is one over {n <= L : u_n <> 0}. *)
Lemma pattern_letters a1 a2 s g l L : (forall n, member a1 a2 s n -> (n <= L)%nat) -> pattern a1 a2 s g l ->
  Forall (fun n => (1 <= n <= L)%nat /\ u a1 a2 n <> 0) l.
Proof.
  intros HL [Hv _]; revert Hv; apply Forall_impl; intros n Hn; destruct (Hn) as [Hu _].
  pose proof (u_nonzero_pos _ _ _ Hu); specialize (HL n Hn); tauto.
Qed.

Lemma V_bounded a1 a2 K : first_upper a1 a2 K -> a2 < 1 -> exists L, forall n, member a1 a2 Plus n -> (n <= L)%nat.
Proof.
  intros HK H2; destruct (WordFinite.V_finite a1 a2 K HK H2) as [L HL]; exists L; intros n Hn.
  destruct (le_lt_dec n L) as [H|H]; [exact H | exfalso; apply (HL n); [lia | exact Hn]].
Qed.

Theorem V_finite : V_finite_statement.
Proof.
  intros a1 a2 K HK H2; destruct (V_bounded a1 a2 K HK H2) as [L HL]; split; [exists L; exact HL|].
  intros M gamma e w0 HM; destruct (Patterns_orbits M a1 a2 gamma e w0 HM L) as (d & mu0 & Hd & Hm & H).
  exists d, mu0; split; [exact Hd|]; split; [exact Hm|]; intros l g mu Hg Hmu Hp.
  apply (H l Plus g mu Hg ltac:(cbn [sgn]; lra) (pattern_letters a1 a2 Plus g l L HL Hp)), Hp.
Qed.
