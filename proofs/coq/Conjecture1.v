(** * Conjecture 1 about motions and orbits: its bullets, read off S4, S5 and their sections *)

From Coq Require Import Reals Arith Lra Lia.
From Grazing Require Import Defs Statement Headline StatementSystems Systems Farey Radius Count Graph Above Sections
  Region4 LeftmostSection.
Open Scope R_scope.

Section Bullets.
Variable n : nat.
Hypothesis Hn : (3 <= n)%nat.
Notation N := (INR n).

Lemma N_at_least_3 : 3 <= N. Proof. apply le_INR in Hn; simpl in Hn; lra. Qed.

(** What lies above the graph exists, and nothing below it. *)
Lemma above_area k g lo hi Rad : above n k g lo hi Rad -> Headline.area n k g lo hi Rad.
Proof.
  intros H s Hs; destruct (H s Hs) as (Hx & Hc & Hall); split; [exact Hx | split; [exact Hc|]]; intros r Hr.
  destruct (Hall r Hr) as [Hu Habove Hzero _ Hbelow Hothers]; unfold orbit_at, no_orbit_at in *.
  split; [exact Hu|]; split; [intros L; apply born_exactly; [lia | apply Habove, L]|].
  split; [intros L; apply no_orbit_never; [lia | exact (Hbelow L)] | split; [exact Hzero | exact Hothers]].
Qed.

Lemma sections k g lo hi Rad : side n k g lo hi -> above n k g lo hi Rad -> forall r, 0 < r < 1 ->
  exists lo' hi', lo <= lo' /\ hi' <= hi /\ (lo = 1 / (2 * N) -> lo' = lo /\ lo < hi') /\
  forall s, lo < s < hi -> (Rad s < r <-> lo' < s < hi').
Proof.
  intros HS HR r Hr; destruct (S4_section_proof n Plus g lo hi r Hn (side_interval _ _ _ _ _ HS) Hr)
    as (lo' & hi' & H1 & H2 & H3 & H4); exists lo', hi'; split; [exact H1|]; split; [exact H2|]; split; [exact H3|].
  intros s Hs; rewrite <- (H4 s Hs); destruct (HR s Hs) as (_ & _ & Hall); apply (Hall r); lra.
Qed.

Lemma side_extends k g lo hi : side n k g lo hi -> lo <> 1 / (2 * N) -> hi <> 1 / 2 -> extends n k g lo hi.
Proof.
  intros HS Hlo Hhi; destruct (S4_stated n Hn) as (_ & H & _); destruct (H k g lo hi HS) as (Rad & HR).
  destruct (S4_ends_stated n k g lo hi Rad Hn HS HR) as (E1 & E2 & _).
  exists Rad; split; [apply above_area, HR | split; [auto | split; [auto|]]]; intros r Hr.
  destruct (sections k g lo hi Rad HS HR r Hr) as (lo' & hi' & H1 & H2 & _ & H3); eauto 6.
Qed.

(** m = 1 *)
Lemma around_1 : neighbours 1 n 0 1 1 (n - 1). Proof. repeat split; lia. Qed.
Lemma first_side : side n (n - 1) Plus (1 / (2 * N)) (1 / N).
Proof. exact (left_side n 1 (Build_Farey _ _ _ _ _ _ around_1) ltac:(lia)). Qed.

(** m = (n-1)/2 *)
Lemma last_side : Nat.Odd n -> side n (n - 2) Minus ((N - 1) / (2 * N)) (1 / 2).
Proof.
  intros [h Hh]; pose proof (last_neighbours h ltac:(lia)) as HF; rewrite <- Hh in HF.
  pose proof (right_side n h (Build_Farey _ _ _ _ _ _ HF) ltac:(lia)) as HS. cbn [n_plus n_minus m_minus] in HS.
  assert (E : N = 2 * INR h + 1) by (rewrite Hh, plus_INR, mult_INR; simpl; ring).
  replace ((N - 1) / (2 * N)) with (INR h / N); [exact HS|].
  pose proof N_at_least_3; apply (Rmult_eq_reg_r (2 * N)); [|lra]. field_simplify; lra.
Qed.

Lemma left_end_not_first m (F : Farey m n) : (0 < 2 * m < n)%nat -> m_plus F <> 0%nat ->
  m <> 1%nat /\ INR (m_plus F) / INR (n_plus F) <> 1 / (2 * N).
Proof.
  intros Hm H0; assert (Hm1 : m <> 1%nat).
  { intros ->; pose proof (are_neighbours F) as (? & E & _); apply H0.
    destruct (m_plus F) as [|q]; [reflexivity|]; simpl in E; lia. }
  split; [assumption|]; exact (left_lo_not_first n m _ _ _ _ Hn (are_neighbours F) Hm1).
Qed.

Lemma right_end_not_half m (F : Farey m n) : (2 * m_minus F <> n_minus F)%nat ->
  INR (m_minus F) / INR (n_minus F) <> 1 / 2.
Proof.
  intros H E; apply H, INR_eq; rewrite mult_INR; pose proof (are_neighbours F) as (_ & _ & Hp & _).
  assert (0 < INR (n_minus F)) by (apply lt_0_INR; lia). apply (f_equal (Rmult (2 * INR (n_minus F)))) in E.
  replace (2 * INR (n_minus F) * (INR (m_minus F) / INR (n_minus F))) with (2 * INR (m_minus F)) in E by (field; lra).
  simpl; lra.
Qed.

(** m-/n- = 1/2 only for odd n, m = (n-1)/2. *)
Lemma half_is_last m (F : Farey m n) : (2 * m_minus F = n_minus F)%nat ->
  Nat.Odd n /\ INR m / N = (N - 1) / (2 * N) /\ INR (m_minus F) / INR (n_minus F) = 1 / 2.
Proof.
  intros H; pose proof (are_neighbours F) as (_ & _ & Hp & E); pose proof N_at_least_3.
  assert (m_minus F = 1)%nat as E1.
  { destruct (m_minus F) as [|[|q]]; [lia|reflexivity|exfalso]; rewrite <- H in E.
    destruct (le_lt_dec n (2 * m)) as [Hle|Hle]; apply (Nat.mul_le_mono_l _ _ (S (S q))) in Hle; lia. }
  rewrite <- H, E1 in *; assert (En : (n = 2 * m + 1)%nat) by lia.
  split; [exists m; assumption|]; apply (f_equal INR) in En.
  rewrite plus_INR, mult_INR in En; simpl in En; simpl; split; [|lra].
  apply (Rmult_eq_reg_r (2 * N)); [|lra]; field_simplify; lra.
Qed.

Lemma intervals_listed e g lo hi : interval n e g lo hi -> (e, g, lo, hi) = (Minus, Plus, 0, 1 / (2 * N)) \/
  (e, g, lo, hi) = (Plus, Plus, 1 / (2 * N), 1 / N) \/ Nat.Odd n /\ (e, g, lo, hi) = (Plus, Minus, (N - 1) / (2 * N),
  1 / 2) \/ exists m (F : Farey m n), (0 < 2 * m < n)%nat /\ (m_plus F <> 0%nat /\ (e, g, lo, hi) = (Plus, Plus,
  INR (m_plus F) / INR (n_plus F), INR m / N) \/ (2 * m_minus F <> n_minus F)%nat /\ (e, g, lo, hi) = (Plus, Minus,
  INR m / N, INR (m_minus F) / INR (n_minus F))).
Proof.
  intros [|k g' lo' hi' [m F Hm|m F Hm]]; [tauto| |]; right.
  - destruct (Nat.eqb_spec m 1) as [->|Hm1]; [left; reflexivity|].
    right; right; exists m, F; split; [assumption|left; split; [|reflexivity]].
    intros E0; pose proof (are_neighbours F) as (? & E & _); rewrite E0 in E; nia.
  - right; destruct (Nat.eq_dec (2 * m_minus F) (n_minus F)) as [E|E].
    + left; destruct (half_is_last m F E) as (Ho & -> & ->); tauto.
    + right; exists m, F; tauto.
Qed.
End Bullets.

(** The area at s = 1/2 at a fixed determinant, from S5's section. *)
Lemma leftmost n a2 : (3 <= n)%nat -> Nat.Odd n -> 0 < a2 < 1 ->
  ends_left a2 (trace (sqrt a2) ((1 - 1 / INR n) / 2)) n (n - 2).
Proof.
  intros Hn Ho H2; destruct (S5_section a2 n H2 Hn Ho) as (a1s & Hs & H); exists a1s; split; [exact Hs|].
  intros a1 Ha1; destruct (H a1 Ha1) as (Hu & [_ _ Hpos Hneg Hzero] & Hlt & Heq); split; [exact Hu|].
  split; [|split; [|split]].
  - intros L; apply born_exactly; [lia | apply Hpos, Hlt, L].
  - intros L; apply no_orbit_never; [lia|]; apply Hneg.
    destruct (Rtotal_order (b a1 a2 n (n - 2)) 0) as [B|[B|B]]; [exact B | apply Heq in B; lra | apply Hlt in B; lra].
  - rewrite <- Heq; split; congruence.
  - intros E; apply Hzero; [apply Heq; congruence | lra].
Qed.

Theorem Conjecture_1 : Conjecture_1_statement.
Proof.
  intros n Hn; set (N := INR n); pose proof (N_at_least_3 n Hn) as HN; fold N in HN; assert (Hn2 : (2 <= n)%nat) by lia.
  destruct (S4_stated n Hn) as (Hfirst & Habove & Hnone). constructor.
  - intros r s Hr Hs; apply (born_exactly _ _ _ _ _ Hn2), Hfirst; assumption.
  - pose proof (first_side n Hn) as HS; fold N in HS.
    destruct (Habove _ _ _ _ HS) as (Rad & HR); exists Rad; split; [apply (above_area n Hn), HR|].
    destruct (S4_ends_stated n _ _ _ _ Rad Hn HS HR) as (_ & E2 & E3); fold N in E3.
    assert (Hlt : 1 / (2 * (N - 1)) < 1 / N) by (apply fraction_lt; lra).
    assert (Hhalf : 1 / N < 1 / 2) by (apply fraction_lt; lra).
    split; [apply E2; lra|split; [intros s Hs; apply E3; lra|]]; intros r Hr.
    destruct (sections n Hn _ _ _ _ Rad HS HR r Hr) as (lo' & hi' & _ & Hhi & Hlo & H).
    destruct (Hlo eq_refl) as [-> Hl]; exists hi'; split; [lra|]; intros s Hs; rewrite (H s Hs); tauto.
  - intros Ho; pose proof (last_side n Hn Ho) as HS; fold N in HS; split.
    + destruct (Habove _ _ _ _ HS) as (Rad & HR); exists Rad; split; [apply (above_area n Hn), HR|].
      apply (S4_ends_stated n _ _ _ _ Rad Hn HS HR); fold N; intros E. apply (f_equal (Rmult (2 * N))) in E.
      replace (2 * N * ((N - 1) / (2 * N))) with (N - 1) in E by (field; lra).
      replace (2 * N * (1 / (2 * N))) with 1 in E by (field; lra); lra.
    + intros a2 H2; replace ((N - 1) / (2 * N)) with ((1 - 1 / N) / 2) by (field; lra). exact (leftmost n a2 Hn Ho H2).
  - intros m F Hm H0; destruct (left_end_not_first n Hn m F Hm H0) as [Hm1 Hlo].
    pose proof (left_side n m F Hm) as HS; destruct (Nat.eqb_spec m 1) as [|_]; [tauto|].
    destruct (neighbours_sum _ _ _ _ _ _ (are_neighbours F)) as [_ Sn].
    replace (n - n_plus F)%nat with (n_minus F) by lia.
    apply (side_extends n Hn); trivial; apply Rlt_not_eq, fraction_lt; [lra|lra|].
    apply proj2, lt_INR in Hm; rewrite mult_INR in Hm; simpl in Hm; fold N in Hm; lra.
  - intros m F Hm H0; pose proof (right_side n m F Hm) as HS.
    destruct (neighbours_sum _ _ _ _ _ _ (are_neighbours F)) as [_ Sn].
    replace (n - n_minus F)%nat with (n_plus F) by lia.
    apply (side_extends n Hn); trivial; [exact (right_lo_not_first n m Hn Hm)|exact (right_end_not_half n Hn m F H0)].
  - apply intervals_listed, Hn.
  - intros r s Hr Hs Hu Hno; apply (no_orbit_never _ _ _ Hn2), Hnone; trivial; [lra|left; lra].
  - intros a1 a2 H2 H1 He; apply (no_orbit_never _ _ _ Hn2).
    apply (proj1 (proj2 (S5 a1 a2 n H2 H1))); [destruct He; lia|assumption].
Qed.
