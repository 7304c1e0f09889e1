(** * Region 4, then regions 1, 2 and 5: the whole plane but two lines *)

From Coq Require Import Reals List Arith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementWords Algebra Cases RealEigenvalues AppendixA Region4
  Coordinates InsideTriangle WordAlgebra WordPath WordGraph WordPatterns WordRegion3.
Import ListNotations.
Open Scope R_scope.

(** ** Region 4: the path 1, 2, 3, 5, 7, ... *)

Section Region4.
Variables a1 a2 : R.
Hypothesis a2_in : 0 < a2 < 1.
Hypothesis a1_in : - (a2 + 1) < a1 <= - 2 * sqrt a2.
Notation u := (u a1 a2).

Lemma u_parity n : (1 <= n)%nat -> (Nat.Odd n -> 0 < u n) /\ (Nat.Even n -> u n < 0).
Proof.
  intros Hn; destruct (eigenvalues_region2 (- a1) a2) as (p & q & E1 & -> & Hq & Hp); try lra.
  assert (a1 = - (p + q)) as -> by lra. pose proof (u_pos p q n ltac:(lra) ltac:(lra) Hn); rewrite u_mirror.
  split; intros H'; [rewrite (sign_pow_odd _ H') | rewrite (sign_pow_even _ H')]; lra.
Qed.

Lemma first_is_2 K : first_upper a1 a2 K -> K = 2%nat.
Proof.
  intros H; pose proof (K_ge_2 a1 a2 K H); destruct (Nat.eq_dec K 2) as [|Hne]; [assumption|].
  pose proof (proj2 (proj2 (proj2 H)) 2%nat ltac:(lia)).
  destruct (u_parity 2 ltac:(lia)) as [_ He]; specialize (He ltac:(exists 1%nat; reflexivity)); lra.
Qed.

Lemma odd_plus_2 i : Nat.Odd i -> Nat.Odd (i + 2). Proof. intros [h ->]; exists (h + 1)%nat; lia. Qed.

Lemma path_odd w i j : path a1 a2 2 w i j -> Nat.Odd i /\ j = 2%nat.
Proof.
  induction 1 as [|w i j H [Hi ->] Hon|w i j H [Hi ->] Hon].
  - split; [exists 0%nat|]; reflexivity.
  - split; [apply odd_plus_2|]; trivial.
  - exfalso; destruct (u_parity (i + 2) ltac:(lia)) as [Ho _]. specialize (Ho (odd_plus_2 i Hi)); cbn [on] in Hon; lra.
Qed.

Lemma odd_path h : exists w, path a1 a2 2 w (2 * h + 1) 2.
Proof.
  induction h as [|h (w & Hw)]; [exists []; constructor|]; exists (w ++ [D]).
  replace (2 * S h + 1)%nat with (2 * h + 1 + 2)%nat by lia; constructor; [assumption|].
  apply (u_parity (2 * h + 1 + 2) ltac:(lia)), odd_plus_2; exists h; reflexivity.
Qed.

Lemma decided_region4 : decided a1 a2 2.
Proof.
  repeat split.
  - assumption.
  - intros k Hk; pose proof (u_nonzero_pos a1 a2 n H0); lia.
  - apply (on_nonzero a1 a2 (i + j) U); assumption.
  - exfalso; destruct (path_odd w i j H) as [Hi ->]. destruct (u_parity (i + 2) ltac:(lia)) as [Ho _].
    specialize (Ho (odd_plus_2 i Hi)); cbn [on] in *; lra.
  - apply (on_nonzero a1 a2 (i + j) D); assumption.
  - destruct (path_odd w i j H) as [Hi ->]; pose proof (path_pos a1 a2 2 w i 2 H).
    destruct (S5 a1 a2 (i + 2)%nat a2_in a1_in) as (_ & _ & HO).
    destruct (HO ltac:(lia) (odd_plus_2 i Hi)) as (_ & [_ _ Ho _ _]).
    replace (i + 2 - 2)%nat with i in Ho by lia; apply Ho; assumption.
  - intros n [Hu Hb]; pose proof (u_nonzero_pos a1 a2 n Hu). destruct (Nat.Even_or_Odd n) as [He|[h Hh]].
    + destruct (Nat.eq_dec n 2) as [|Hn2]; [tauto|exfalso]. destruct (S5 a1 a2 n a2_in a1_in) as (_ & HE & _).
      assert (4 <= n)%nat by (destruct He; lia). destruct (HE ltac:(assumption) He) as (_ & k & k' & Hk & _ & Hneg & _).
      specialize (Hb k Hk); cbn [sgn] in Hb; lra.
    + destruct h as [|h]; [left; lia|right; right].
      destruct (odd_path h) as (w & Hw); exists w, (2 * h + 1)%nat, 2%nat; split; [assumption|lia].
Qed.
End Region4.

(** ** Regions 3 and 4 together *)

Lemma real_is_region4 a1 a2 K : first_upper a1 a2 K -> a1 ^ 2 >= 4 * a2 ->
  0 < a2 < 1 /\ - (a2 + 1) < a1 <= - 2 * sqrt a2.
Proof.
  intros H H4; destruct (real_inside a1 a2 (WordPath.a2_in a1 a2 K H) (WordPath.a1_in a1 a2 K H) ltac:(lra))
    as [Hlt Hor]; destruct H as (H2 & H1 & _); split; lra.
Qed.

Lemma decided_everywhere a1 a2 K : first_upper a1 a2 K -> decided a1 a2 K.
Proof.
  intros H; destruct (Rlt_le_dec (a1 ^ 2) (4 * a2)) as [H4|H4].
  - destruct (Coordinates a1 a2 H4) as (r & s & Hr & Hs & -> & -> & _).
    assert (r <= 1) by (destruct H as (H2 & _); apply Rnot_lt_le; intros ?; nra).
    apply decided_region3; trivial; [lra|]; apply (first_next_half r s); trivial; lra.
  - destruct (real_is_region4 a1 a2 K H ltac:(lra)) as [H2 H1].
    rewrite (first_is_2 a1 a2 H2 H1 K H); apply decided_region4; assumption.
Qed.

Lemma first_exists a1 a2 : 0 < a2 <= 1 -> - (a2 + 1) < a1 < 2 * sqrt a2 -> exists K, first_upper a1 a2 K.
Proof.
  intros H2 H1; destruct (Rlt_le_dec (a1 ^ 2) (4 * a2)) as [H4|H4].
  - destruct (Coordinates a1 a2 H4) as (r & s & Hr & Hs & -> & -> & _).
    assert (r <= 1) by (apply Rnot_lt_le; intros ?; nra).
    destruct (next_half_exists s Hs) as (K & HK); exists K; apply next_half_first; trivial; lra.
  - exists 2%nat; refine (conj H2 (conj H1 (conj _ _))).
    + assert (Hs : sqrt a2 * sqrt a2 = a2) by (apply sqrt_sqrt; lra). assert (0 < sqrt a2) by (apply sqrt_lt_R0; lra).
      cbn [on]; rewrite u_2; apply Rnot_le_lt; intros ?; nra.
    + intros [|[|k]] Hk; [rewrite u_0 | rewrite u_1 | lia]; lra.
Qed.

Theorem Path : Path_statement.
Proof.
  split; [exact first_exists | split].
  - intros a1 a2 K H H4; destruct (real_is_region4 a1 a2 K H H4); apply (first_is_2 a1 a2); assumption.
  - intros r s K Hr Hs; split; [split; [apply first_next_half | apply next_half_first]; assumption|].
    intros H w n1 n2; apply path_stern; trivial; apply (first_next_half r s); assumption.
Qed.

Theorem W3 : W3_statement.
Proof.
  intros a1 a2 K H; pose proof (decided_everywhere a1 a2 K H) as Hd.
  split; [apply (Minus_members a1 a2 K H Hd) | split; [apply member_one | split; [apply member_K, H|]]].
  split; [apply Hd|]; intros w i j Hp HV; apply Forall_forall; intros [k x] Hk; cbn [fst snd].
  split; [apply (members_vertices a1 a2 K H Hd w i j Hp HV _ Hk) | apply (vertices_on a1 a2 K H w i j Hp _ _ Hk)].
Qed.

Theorem W5_neighbours : W5_neighbours_statement.
Proof.
  intros a1 a2 K w i j H Hp n p q; pose proof (decided_everywhere a1 a2 K H) as Hd.
  destruct (back_edge a1 a2 K H Hd w i j Hp) as [HU HD], (zeros a1 a2 K H Hd w i j Hp) as [ZU ZD].
  exact (conj HU (conj HD (conj ZU ZD))).
Qed.

Theorem W5 : W5_statement.
Proof.
  intros a1 a2 K w i j H Hp HV; pose proof (decided_everywhere a1 a2 K H) as Hd.
  split; [apply (word_edges a1 a2 K H Hd) | apply (word_patterns a1 a2 K H Hd)]; assumption.
Qed.

Theorem W4 : W4_statement.
Proof.
  intros a1 a2 K H; pose proof (decided_everywhere a1 a2 K H) as Hd; split; [|split].
  - intros w i j Hp g; split; [apply (twins a1 a2 K H Hd w), Hp|].
    intros k x y; apply (not_parents a1 a2 K H Hd w); assumption.
  - apply (ancestors_only a1 a2 K H Hd).
  - apply (Minus_patterns a1 a2 K H Hd).
Qed.

(** ** Regions 1, 2 and 5 *)

Section OneCase.
Variables (a1 a2 : R) (e g : sign).
Hypothesis a2_pos : 0 < a2.
Hypothesis all : forall n, (1 <= n)%nat -> orbit a1 a2 n e g.

Lemma only_sign n e' : (2 <= n)%nat -> member a1 a2 e' n -> e' = e.
Proof.
  intros Hn [_ H]; destruct (all n ltac:(lia)) as (_ & H' & _).
  specialize (H 1%nat ltac:(lia)); specialize (H' 1%nat ltac:(lia)).
  destruct e, e'; cbn [sgn] in *; trivial; exfalso; lra.
Qed.

Lemma only_case g' i j : (1 <= i)%nat -> (1 <= j)%nat -> edge a1 a2 e g' i j -> g' = g.
Proof. intros Hi Hj He; apply (edge_either _ _ _ _ _ _ _ He), full_shift; auto. Qed.

Lemma one_case_patterns l e' g' : Exists (le 2) l -> (pattern a1 a2 e' g' l <-> e' = e /\ g' = g /\ Forall (le 1) l).
Proof.
  intros Hex; split.
  - intros [Hl Hc].
    assert (H1 : Forall (le 1) l) by (revert Hl; apply Forall_impl; intros n [Hu _]; apply (u_nonzero_pos a1 a2), Hu).
    assert (e' = e) as ->.
    { apply Exists_exists in Hex as (n & Hin & Hn); rewrite Forall_forall in Hl.
      apply (only_sign n); [assumption | apply Hl, Hin]. }
    split; [reflexivity | split; [|assumption]]; destruct l as [|n l]; [destruct Hc|].
    destruct (walk_last _ _ _ _ Hc) as (k & Hk & Hin); rewrite Forall_forall in H1.
    apply (only_case g' k n); [apply H1; destruct Hin as [->|]; [left | right] | apply H1; left |]; trivial.
  - intros (-> & -> & H1); apply (proj2 (W1 a1 a2 e a2_pos)).
    + intros ->; inversion Hex.
    + revert H1; apply Forall_impl, all.
Qed.

Lemma one_case_lonely e' g' : (forall i j, orbit a1 a2 i e' g' -> orbit a1 a2 j e' g' -> i = j) -> exists t, forall i j,
  member a1 a2 e' i /\ member a1 a2 e' j /\ edge a1 a2 e' g' i j -> j = t.
Proof.
  intros Hone; exists 1%nat; intros i j (Hi & Hj & He).
  pose proof (u_nonzero_pos a1 a2 i (proj1 Hi)); pose proof (u_nonzero_pos a1 a2 j (proj1 Hj)).
  destruct (Nat.eq_dec j 1) as [|Hne]; [assumption|exfalso].
  assert (e' = e) as -> by (apply (only_sign j); [lia | assumption]).
  assert (g' = g) as -> by (apply (only_case g' i j); assumption).
  specialize (Hone 1%nat 2%nat (all 1 ltac:(lia)) (all 2 ltac:(lia))); discriminate.
Qed.
End OneCase.

Lemma one_case_regions a1 a2 e g : 0 < a2 -> a2 + 1 < a1 /\ e = Plus /\ g = Plus \/ a2 < 1 /\ 2 * sqrt a2 <= a1 < a2 + 1
  /\ e = Minus /\ g = Plus \/ a1 < - (a2 + 1) /\ e = Plus /\ g = Minus -> forall n, (1 <= n)%nat -> orbit a1 a2 n e g.
Proof.
  intros H2 [(H & -> & ->)|[(Hlt & H & -> & ->)|(H & -> & ->)]] n Hn.
  - apply (Region1 a1 a2 n); assumption.
  - apply (Region2 a1 a2 n); assumption || lra.
  - apply (Region5 a1 a2 n); tauto.
Qed.

Theorem Regions : Regions_statement.
Proof. intros a1 a2 e g H2 H l e' g'; apply one_case_patterns; [assumption|]. apply one_case_regions; assumption. Qed.

Theorem W6 : W6_statement.
Proof.
  intros a1 a2 e g H2 Hne; apply W6_from_lonely; [lra|].
  assert (Hcase : (exists e0 g0, forall n, (1 <= n)%nat -> orbit a1 a2 n e0 g0) \/ exists K, first_upper a1 a2 K).
  { destruct (Rlt_le_dec (a2 + 1) a1) as [H|H].
    { left; exists Plus, Plus; apply one_case_regions; [lra|]; tauto. }
    destruct (Rlt_le_dec a1 (- (a2 + 1))) as [H'|H'].
    { left; exists Plus, Minus; apply one_case_regions; [lra|]; tauto. }
    assert (- (a2 + 1) < a1 < a2 + 1) as H1.
    { unfold Rabs in Hne; destruct (Rcase_abs a1) in Hne; lra. }
    destruct (Rlt_le_dec a1 (2 * sqrt a2)) as [Hs|Hs]; [right; apply first_exists; lra|].
    left; exists Minus, Plus; apply one_case_regions; [lra|right; left; repeat split; try lra].
    destruct (Req_dec a2 1) as [->|]; [rewrite sqrt_1 in Hs|]; lra. }
  destruct Hcase as [(e0 & g0 & Hall)|(K & HK)].
  - apply (one_case_lonely a1 a2 e0 g0); [lra | assumption].
  - apply (lonely a1 a2 K HK (decided_everywhere a1 a2 K HK)).
Qed.
