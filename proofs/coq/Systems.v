(** * Proof of Theorem 1 in the plane about oscillators and maps at once, and of what the signs of one impact
      and of patterns mean by it *)

From Coq Require Import Reals ZArith List Arith Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPlane StatementUnstable StatementWords
  StatementOscillator StatementNonlinear StatementBouncing NonlinearTube NonlinearMoves NonlinearBounces OrbitVectors
    PlaneOrbits Oscillators WordAlgebra Headline StatementSystems.
Import ListNotations.
Open Scope R_scope.

(** ** Theorem 1 *)
Lemma closer_motion O m mu d d' N t y v : d <= d' -> motion O m mu d N t y v -> motion O m mu d' N t y v.
Proof. intros Hd H i j Hj; destruct (H i j Hj); constructor; trivial; lra. Qed.

Lemma closer_orbit M mu d d' n x : d <= d' -> orbit_near M Z (fun i => i + 1)%Z n mu d x ->
  orbit_near M Z (fun i => i + 1)%Z n mu d' x.
Proof. intros Hd H i; destruct (H i) as [A B]; split; [|exact B]; intros k Hk; specialize (A k Hk); lra. Qed.

(** What is within eps of d is none if there is none within d; what is one within d and within eps is one
    there. *)
Lemma closer_none S mu d d' n : d <= d' -> none S mu d' n -> none S mu d n.
Proof.
  intros Hd; destruct S as [osc m|O rate|O rate|M rate w]; cbn [none].
  - intros H N t y v HN HM; apply (H N t y v HN); exact (closer_motion _ _ _ _ _ _ _ _ _ Hd HM).
  - intros H N t y v HN HM; apply (H N t y v HN); intros i j Hj; destruct (HM i j Hj) as [? ? ? L ? ? ? ? ?].
    constructor; trivial; try lra; intros x Hx; destruct (L x Hx); split; lra.
  - intros H N t y v HN HM; apply (H N t y v HN); intros i j Hj; destruct (HM i j Hj) as (r & p & q & [J1 J2 J3 J4 J5 J6
      J7 J8 J9 J10 J11 J12]); exists r, p, q; constructor; trivial.
    + intros l Hl; specialize (J3 l Hl); lra.
    + intros k Hk; specialize (J4 k Hk); lra.
    + intros k x Hk Hx; destruct (J8 k x Hk Hx); split; lra.
  - intros H x Hx; apply (H x); exact (closer_orbit _ _ _ _ _ _ Hd Hx).
Qed.

Theorem Theorem_1 : Theorem_1_statement.
Proof.
  intros S a1 a2 gamma HS n_max; destruct S as [osc m|O rate|O rate|M rate w]; cbn [grazes e_mu one none] in *.
  - destruct (Word_oscillator osc m a1 a2 gamma HS n_max) as (d & mu0 & K & Hd & Hm & W).
    exists d; split; [exact Hd|]; intros eps Heps; pose proof (Rabs_pos K) as HK.
    exists (Rmin mu0 (eps / (Rabs K + 1))); split; [apply Rmin_glb_lt; [|apply Rdiv_lt_0_compat]; lra|].
    intros n e g mu Hn Hg [P0 P1].
    assert (Hmu : 0 < sgn e * mu < mu0) by (split; [|eapply Rlt_le_trans; [|apply Rmin_l]]; eassumption).
    assert (Small : K * Rabs mu <= eps).
    { assert (L : Rabs mu < eps / (Rabs K + 1)).
      { replace (Rabs mu) with (sgn e * mu); [eapply Rlt_le_trans; [exact P1 | apply Rmin_r]|].
        destruct e; cbn [sgn] in *; [rewrite Rabs_pos_eq | rewrite Rabs_left]; lra. }
      apply (Rmult_lt_compat_l (Rabs K + 1)) in L; [|lra].
      replace ((Rabs K + 1) * (eps / (Rabs K + 1))) with eps in L by (field; lra).
      pose proof (Rle_abs K); pose proof (Rabs_pos mu).
      assert (K * Rabs mu <= Rabs K * Rabs mu) by (apply Rmult_le_compat_r; assumption); lra. }
    assert (W' := fun N (HN : forall i, (N (i + 1) = N i + Z.of_nat (n i))%Z) => W N n e g mu (fun i => conj (HN i) (Hn
      i)) Hg Hmu); clear W; split.
    + intros Hall N HN; destruct (W' N HN) as (E & _ & B).
      destruct (E (fun i => conj (proj2 (proj1 (Hall i))) (proj2 (Hall i)))) as [(t & y & v & HM & Only) Un]; split.
      * exists t, y, v; split.
        -- intros i j Hj; destruct (HM i j Hj); constructor; trivial.
           eapply Rle_trans; [apply (B t y v HM i) | lra].
        -- intros t' y' v' HM'; apply Only; exact (closer_motion _ _ _ _ _ _ _ _ _ (proj2 Heps) HM').
      * intros t' y' v' HM'; apply (closer_motion _ _ _ _ _ _ _ _ _ (proj2 Heps)) in HM'.
        apply (unstable_same (swing osc m mu (K * Rabs mu) N) _ t' v'); [|auto | exact (Un t' y' v' HM')].
        intros s p q i j [? Nr ? ? ? ? ? ?]; constructor; trivial; lra.
    + intros [i Hi] N t y v HN; destruct (W' N HN) as (_ & F & _); exact (F i Hi t y v).
  - destruct HS as [HO HG], (nonlinear O a1 a2 gamma rate HO HG n_max) as (d & Hd & H); exists d; split; [exact Hd|].
    intros eps Heps; destruct (H eps Heps) as (mu0 & Hm & W); exists mu0; split; [exact Hm|].
    intros n e g mu Hn Hg Hmu; split; [intros Hall N HN | intros Hb N t y v HN]; apply (W n N e g mu Hn HN Hg Hmu);
      assumption.
  - destruct HS as [HO HG], (bouncing O a1 a2 gamma rate HO HG n_max) as (d & Hd & H); exists d; split; [exact Hd|].
    intros eps Heps; destruct (H eps Heps) as (mu0 & Hm & W); exists mu0; split; [exact Hm|].
    intros n e g mu Hn Hg Hmu; split; [intros Hall N HN | intros Hb N t y v HN]; apply (W n N e g mu Hn HN Hg Hmu);
      assumption.
  - destruct (Theorem1_plane M a1 a2 gamma rate w HS n_max) as (d & mu0 & Hd & Hm & W & Tends).
    destruct (plane_leave M a1 a2 gamma rate w HS n_max) as (dL & HdL & Leave).
    exists d; split; [exact Hd|]; intros eps Heps; destruct (Tends (Rmin eps dL)) as (mu2 & Hm2 & Near); [apply
      Rmin_glb_lt; lra|]; set (mu1 := Rmin mu2 dL); assert (Hm1 : 0 < mu1) by (apply Rmin_glb_lt; lra).
    destruct (is_rate _ _ _ _ _ _ HS) as [_ Hr]; assert (Pr : 0 < Rabs rate) by (apply Rabs_pos_lt, Hr).
    exists (Rmin mu0 (Rabs rate * mu1)); split; [apply Rmin_glb_lt; [lra | apply Rmult_lt_0_compat; lra]|].
    intros n e g mu Hn Hg [P0 P1].
    assert (Hmu : 0 < sgn e * (rate * mu) < mu0) by (split; [|eapply Rlt_le_trans; [|apply Rmin_l]]; eassumption).
    assert (Hmu1 : 0 < Rabs mu < mu1) by (apply (small_mu rate e); [exact Hr | split; [exact P0 | eapply Rlt_le_trans;
      [exact P1 | apply Rmin_r]]]).
    assert (Hnext : forall j : Z, (j + 1 - 1 = j /\ j - 1 + 1 = j)%Z) by (intros; lia).
    destruct (W Z (fun i => i + 1)%Z (fun i => i - 1)%Z n e g mu Hnext Hn Hg Hmu) as [Hex Hno]; split.
    + intros Hall; destruct Hex as (x & Hx & Only); [intros i; exact (conj (proj2 (proj1 (Hall i))) (proj2 (Hall i)))|].
      assert (Tiny : forall x, orbit_near M Z (fun i => i + 1)%Z n mu d x -> forall r, Rmin eps dL <= r -> orbit_near M
        Z (fun i => i + 1)%Z n mu r x).
      { intros x' Hx' r Hrr i; split; [|apply (Hx' i)]; rewrite (is_plane _ _ _ _ _ _ HS).
        apply within_le with (1 := Hrr), (Near Z (fun i => i + 1)%Z (fun i => i - 1)%Z n mu x' Hnext Hn); [|exact Hx'].
        split; [apply Hmu1 | eapply Rlt_le_trans; [apply Hmu1 | apply Rmin_l]]. }
      assert (Wide : forall x, orbit_near M Z (fun i => i + 1)%Z n mu eps x -> orbit_near M Z (fun i => i + 1)%Z n mu d
        x) by (intros x'; exact (closer_orbit _ _ _ _ _ _ (proj2 Heps))). split.
      * exists x; split; [apply Tiny; [exact Hx | apply Rmin_l]|]; intros x' Hx'; apply Only, Wide, Hx'.
      * intros x' i Hx'; apply Wide in Hx'; destruct (proj2 (Only x' Hx')) as (c & Hc & Cl).
        apply (Leave Z (fun i => i + 1)%Z n mu x' c Hn); trivial; [|apply Tiny; [exact Hx' | apply Rmin_r]].
        left; eapply Rlt_le_trans; [apply Hmu1 | apply Rmin_r].
    + intros [i Hi]; exact (Hno i Hi).
Qed.

(** ** One impact per period *)
Lemma some_sign S a1 a2 gamma : grazes S a1 a2 gamma -> exists g, sgn g * gamma > 0.
Proof.
  intros HS; assert (gamma <> 0) by (destruct S; [exact (is_generic _ _ _ _ _ HS) | exact (gamma_not_0 _ _ _ _ _ (proj2
    HS)) | exact (its_gamma _ _ _ _ _ (proj2 HS)) | exact (proj2 (is_gamma _ _ _ _ _ _ HS))]).
  destruct (Rlt_le_dec gamma 0); [exists Minus | exists Plus]; cbn [sgn]; lra.
Qed.

Lemma difference_is_c a1 a2 n : (1 <= n)%nat -> u a1 a2 n <> 0 -> p a1 a2 n - q a1 a2 n = c a1 a2 n.
Proof. exact (follows_itself a1 a2 n). Qed.

(** There is no parameter for which there is one and none. *)
Lemma one_or_none S mu d d' n : d <= d' -> one S mu d n -> none S mu d' n -> (exists N, forall i,
  (N (i + 1) = N i + Z.of_nat (n i))%Z) -> False.
Proof.
  intros Hd H1 H0 [N HN]; apply (closer_none _ _ _ _ _ Hd) in H0; destruct S as [osc m|O rate|O rate|M rate w]; cbn [one
    none] in *.
  - destruct (H1 N HN) as [(t & y & v & HM & _) _]; exact (H0 N t y v HN HM).
  - destruct (H1 N HN) as [(t & y & v & HM & _) _]; exact (H0 N t y v HN HM).
  - destruct (H1 N HN) as [(t & y & v & HM & _) _]; exact (H0 N t y v HN HM).
  - destruct H1 as [(x & Hx & _) _]; exact (H0 x Hx).
Qed.

Lemma every_parameter S a1 a2 gamma t : grazes S a1 a2 gamma -> exists mu, e_mu S mu = t.
Proof.
  destruct S as [osc m|O rate|O rate|M rate w]; cbn [grazes e_mu]; intros HS; [exists t; reflexivity| | |]; exists (t /
    rate); field.
  - exact (rate_not_0 _ _ _ _ _ (proj2 HS)).
  - exact (its_rate_not_0 _ _ _ _ _ (proj2 HS)).
  - exact (proj2 (is_rate _ _ _ _ _ _ HS)).
Qed.

Theorem Single : Single_statement.
Proof.
  intros S a1 a2 gamma n e g HS Hn Hu Hg; destruct (Theorem_1 S a1 a2 gamma HS n) as (d & Hd & H).
  assert (Hall : Z -> (1 <= n <= n)%nat /\ u a1 a2 n <> 0) by (intros _; split; [lia | exact Hu]). split; [|split].
  - intros (_ & Hb & Hc); exists d; split; [exact Hd|]; intros eps Heps; destruct (H eps Heps) as (mu0 & Hm & W).
    exists mu0; split; [exact Hm|]; intros mu Hmu; apply (W (fun _ => n) e g mu Hall Hg Hmu); intros _.
    split; [exact (conj Hu Hb)|]; unfold edge; rewrite difference_is_c by assumption; exact Hc.
  - intros Hf; destruct (H d ltac:(lra)) as (mu0 & Hm & W); exists d, mu0; split; [exact Hd|].
    split; [exact Hm|]; intros mu Hmu; apply (W (fun _ => n) e g mu Hall Hg Hmu); exists 0%Z; unfold breaks.
    rewrite difference_is_c by assumption; exact Hf.
  - intros [(d1 & Hd1 & B) (d2 & m2 & Hd2 & Hm2 & U)].
    destruct (B (Rmin d1 d2)) as (m1 & Hm1 & O1); [split; [apply Rmin_glb_lt; assumption | apply Rmin_l]|].
    set (t := Rmin m1 m2 / 2); assert (Ht : 0 < t /\ t < m1 /\ t < m2).
    { assert (0 < Rmin m1 m2) by (apply Rmin_glb_lt; assumption).
      pose proof (Rmin_l m1 m2); pose proof (Rmin_r m1 m2); unfold t; lra. }
    destruct (every_parameter S a1 a2 gamma (sgn e * t) HS) as [mu E].
    assert (Hmu : sgn e * e_mu S mu = t) by (rewrite E; destruct e; cbn [sgn]; ring).
    apply (one_or_none S mu (Rmin d1 d2) d2 (fun _ => n)); [apply Rmin_r | apply O1; lra | apply U; lra|].
    exists (fun i => i * Z.of_nat n)%Z; intros; ring.
Qed.

Theorem Meaning : Meaning_statement.
Proof.
  intros a1 a2 n Hn; assert (Hn1 : (1 <= n)%nat) by lia; split.
  - intros e g Ho S gamma HS; pose proof Ho as (Hu & Hb & Hc); split.
    + intros Hg; apply (Single S a1 a2 gamma n e g HS Hn1 Hu Hg), Ho.
    + intros e' Hne; destruct (some_sign S a1 a2 gamma HS) as [g' Hg'].
      apply (Single S a1 a2 gamma n e' g' HS Hn1 Hu Hg'); specialize (Hb 1%nat ltac:(lia)).
      destruct e, e'; try (left; exists 1%nat; split; [lia | cbn [sgn] in *; lra]); right; destruct g, g'; cbn [sgn] in
        *; try lra; exfalso; apply Hne; split; trivial; lra.
  - intros (Hu & k & k' & Hk & Hk' & Hb & Hb') S gamma e HS; destruct (some_sign S a1 a2 gamma HS) as [g Hg].
    apply (Single S a1 a2 gamma n e g HS Hn1 Hu Hg); left.
    destruct e; [exists k | exists k']; split; trivial; cbn [sgn]; lra.
Qed.

Lemma born_exactly a1 a2 n e g : (2 <= n)%nat -> orbit a1 a2 n e g -> exactly a1 a2 n e g.
Proof. intros Hn; apply (Meaning a1 a2 n Hn). Qed.
Lemma no_orbit_never a1 a2 n : (2 <= n)%nat -> no_orbit a1 a2 n -> never a1 a2 n.
Proof. intros Hn; apply (Meaning a1 a2 n Hn). Qed.
Lemma all_fail_never a1 a2 n : (2 <= n)%nat -> u a1 a2 n <> 0 -> (forall e g, fails a1 a2 n e g) -> never a1 a2 n.
Proof.
  intros Hn Hu Hf S gamma e HS; destruct (some_sign S a1 a2 gamma HS) as [g Hg].
  apply (Single S a1 a2 gamma n e g HS ltac:(lia) Hu Hg), Hf.
Qed.

(** ** Patterns *)

(** A walk, step by step. *)
Lemma walk_nth {T} (E : T -> T -> Prop) (z : T) x l y : walk E x l y ->
  forall k, (k <= length l)%nat -> E (nth k (x :: l) z) (nth k (l ++ [y]) z).
Proof.
  revert x; induction l as [|x' l IH]; intros x H k Hk; cbn in *.
  - replace k with 0%nat by lia; exact H.
  - destruct H as [H1 H2]; destruct k as [|k]; [exact H1 | apply (IH x' H2 k); lia].
Qed.

Lemma letter_in l i : l <> [] -> In (cyclic_letter l i) l.
Proof.
  intros Hl; assert (L : (0 < length l)%nat) by (destruct l; [contradiction | cbn; lia]).
  pose proof (Z.mod_pos_bound i (Z.of_nat (length l)) ltac:(lia)); apply nth_In; lia.
Qed.

Lemma cyclic_edge (E : nat -> nat -> Prop) l i : cyclic E l -> E (cyclic_letter l i) (cyclic_letter l (i + 1)).
Proof.
  destruct l as [|x l]; [contradiction|]; intros H; unfold cyclic_letter; cbn [length].
  set (L := Z.of_nat (S (length l))); assert (HL : (L = Z.of_nat (length l) + 1)%Z) by lia.
  pose proof (Z.mod_pos_bound i L ltac:(lia)) as B; set (k := (i mod L)%Z) in *.
  pose proof (walk_nth E 0%nat x l x H (Z.to_nat k) ltac:(lia)) as Hw.
  replace (nth (Z.to_nat ((i + 1) mod L)) (x :: l) 0%nat) with (nth (Z.to_nat k) (l ++ [x]) 0%nat); [exact Hw|].
  assert (E1 : ((i + 1) mod L = (k + 1) mod L)%Z) by (unfold k; rewrite Zplus_mod_idemp_l; reflexivity).
  rewrite E1; destruct (Z.eq_dec k (Z.of_nat (length l))) as [Hk|Hk].
  - replace (k + 1)%Z with L by lia; rewrite Z_mod_same_full, app_nth2 by lia.
    replace (Z.to_nat k - length l)%nat with 0%nat by lia; reflexivity.
  - rewrite Z.mod_small, app_nth1 by lia; replace (Z.to_nat (k + 1)) with (S (Z.to_nat k)) by lia; reflexivity.
Qed.

Theorem Patterns : Patterns_statement.
Proof.
  intros S a1 a2 gamma HS n_max; destruct (Theorem_1 S a1 a2 gamma HS n_max) as (d & Hd & H).
  exists d; split; [exact Hd|]; intros eps Heps; destruct (H eps Heps) as (mu0 & Hm & W).
  exists mu0; split; [exact Hm|]; intros l e g mu Hl Hall Hg Hmu; rewrite Forall_forall in Hall.
  destruct (W (cyclic_letter l) e g mu (fun i => Hall _ (letter_in l i Hl)) Hg Hmu) as [Hex Hno]; split; [|exact Hno].
  intros [Hv Hc]; rewrite Forall_forall in Hv; apply Hex; intros i; split; [apply Hv, letter_in, Hl|].
  exact (cyclic_edge _ l i Hc).
Qed.

Theorem Shift : Shift_statement.
Proof.
  intros S a1 a2 gamma HS H2 n_max; destruct (Theorem_1 S a1 a2 gamma HS n_max) as (d & Hd & H).
  exists d; split; [exact Hd|]; intros eps Heps; destruct (H eps Heps) as (mu0 & Hm & W).
  exists mu0; split; [exact Hm|]; intros n e g mu Hn Hg Hmu; apply (W n e g mu); trivial.
  - intros i; destruct (Hn i) as (Hle & Hu & _); pose proof (u_nonzero_pos _ _ _ Hu); tauto.
  - intros i; split; [split; apply (Hn i) | apply (full_shift a1 a2 e H2 g); apply Hn].
Qed.
