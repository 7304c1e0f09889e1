(** * Whatever certificate the check takes, every path of it is exactly one motion *)

From Coq Require Import Reals QArith Qreals ZArith Lra Lia Bool List.
From Grazing Require Import ChaosInterval ChaosFunctions PathsCheck PathsFlow PathsLegs PathsGaps StatementPaths Paths.
Open Scope R_scope.

Lemma less_lt p q : less p q = true -> Q2R p < Q2R q.
Proof.
  intros H; apply Qlt_Rlt, Qnot_le_lt; intros L; apply Qle_bool_iff in L; unfold less in H; rewrite L in H;
    discriminate.
Qed.
Lemma ordered_le X : ordered X = true -> Q2R (fst X) <= Q2R (snd X).
Proof. intros H; apply Qle_Rle, Qle_bool_iff, H. Qed.
Lemma Q2R_0 : Q2R 0 = 0. Proof. unfold Q2R; cbn; ring. Qed.
Lemma Q2R_1 : Q2R 1 = 1. Proof. unfold Q2R; cbn; field. Qed.

(** Some number bounds all sizes of boxes over their weights. *)
Lemma spread_over {A : Type} (f a : A -> R) L : (forall m, In m L -> 0 < a m) ->
  exists B, 0 <= B /\ forall m, In m L -> f m <= a m * B.
Proof.
  induction L as [|m L IH]; intros H; [exists 0; split; [lra | intros m []]|].
  destruct IH as (B & HB & F); [intros; apply H; right; assumption|]; pose proof (H m (or_introl eq_refl)) as P.
  exists (Rmax B (Rabs (f m) / a m)); split; [apply (Rle_trans _ _ _ HB), Rmax_l|]; intros x [<-|Hx].
  - apply (Rle_trans _ (a m * (Rabs (f m) / a m))); [|apply Rmult_le_compat_l; [lra | apply Rmax_r]].
    replace (a m * (Rabs (f m) / a m)) with (Rabs (f m)) by (field; lra); apply Rle_abs.
  - apply (Rle_trans _ _ _ (F x Hx)), Rmult_le_compat_l; [left; apply H; right; exact Hx | apply Rmax_l].
Qed.
Lemma followers_in X l l' : follows X l l' -> In l' (followers (Certificate.letters X) l).
Proof. intros (v & Hv & E); apply in_flat_map; exists v; split; [exact Hv|]; rewrite E; left; reflexivity. Qed.

(** ** A cell that passes *)

Section Cell.
Variables (D : cell) (L : list Letter.t) (N : itv) (M : Machine.t) (w kappa : R).
Hypothesis HD : in_cell D M w kappa.
Hypothesis HN : mem N (Machine.nu M).
Hypothesis Hnu : 0 < Machine.nu M.
Hypothesis Hg : g M 0 = 1 /\ g1 M 0 = 0.
Hypothesis HC : cell_ok D L N = true.

Lemma cell_facts : good M w /\ 0 < Machine.tau M /\ w <= PI /\ forall v n, nth_error L v = Some n ->
  letter_gap D n (followers L n) N (all_sI D (before_it L v) n) = true /\
  forall k, In k (followers L n) -> leg_ok D N (before_it L v) n k = true.
Proof.
  pose proof HC as H; apply andb_prop in H; destruct H as [A B].
  destruct (wall_facts D M w kappa HD Hnu Hg A) as (G & T & PW); repeat split; trivial; try apply G.
  all: apply (proj1 (forallb_forall _ _)) with (x := v) in B;
    [|apply in_seq; assert (v < length L)%nat by (apply nth_error_Some; congruence); lia]; unfold letter_in_cell in B;
    rewrite H in B; apply andb_prop in B; destruct B as [B B'].
  - exact B.
  - exact (proj1 (forallb_forall _ _) B').
Qed.

Let HG := proj1 cell_facts.

Lemma before_in m v : In m L -> In v (Letter.next m) -> In m (before_it L v).
Proof.
  intros Hm Hv; apply filter_In; split; [exact Hm|]; apply existsb_exists; exists v; split;
    [exact Hv | apply Nat.eqb_refl].
Qed.
Lemma leg_checked m v n k s s' : In m L -> In v (Letter.next m) -> nth_error L v = Some n -> In k (followers L n) ->
  s_lo (Machine.tau M) m n <= s <= s_hi (Machine.tau M) m n -> s_lo (Machine.tau M) n k <= s' <= s_hi (Machine.tau M) n
  k -> leg_holds M w kappa m n k s s'.
Proof.
  intros Hm Hv Hn Hk Hs Hs'; pose proof cell_facts as (_ & _ & _ & F); destruct (F v n Hn) as [_ B].
  pose proof (before_in m v Hm Hv) as Hb.
  pose proof (mem_all_sI D (before_it L v) m n s Hb (mem_sI D M w kappa HD _ _ _ Hs)) as MS.
  destruct (cover3_one _ _ _ _ _ _ _ _ (B k Hk) HN (mem_sI D M w kappa HD _ _ _ Hs') MS)
    as (N' & S' & S & B' & HN' & HS' & HS).
  exact (leg_box_holds D M w kappa HD HG (before_it L v) m n k s s' N' S S' Hb HN' HS HS' B').
Qed.
End Cell.

Lemma checked_path X M l : check X = true -> covers X M -> leg_path X l -> let W := Q2R (Certificate.window X) in
  (exists spread, chain M W (Q2R (Certificate.contraction X)) spread l) /\ open_gaps M W l.
Proof.
  intros HX [HC HK HT HV HSg Hnu HH Hg Hg1] HP W; unfold check in HX.
  destruct (Certificate.cells X) as [[[nc nk] nt] nn]; set (L := Certificate.letters X) in *.
  rewrite !andb_true_iff in HX; destruct HX as [[[K0 K1] KL] HX].
  destruct (cut_one _ _ _ _ HX (mem_ranging _ _ HC)) as (IC & HX1 & MC).
  destruct (cut_one _ _ _ _ HX1 (mem_ranging _ _ HK)) as (IK & HX2 & MK).
  destruct (cut_one _ _ _ _ HX2 (mem_ranging _ _ HT)) as (IT & HX3 & MT).
  destruct (cut_one _ _ _ _ HX3 (mem_ranging _ _ HV)) as (IN & HX4 & MN); clear HX HX1 HX2 HX3.
  set (kappa := Q2R (Certificate.contraction X)).
  match type of HX4 with cell_ok ?D _ _ = _ => set (D0 := D) in *; assert (HD : in_cell D0 M W kappa) end.
  { constructor; unfold D0; cbn; trivial; [rewrite HSg; apply side_mem | apply mem_fraction | apply mem_fraction |
      apply rangings_mem, HH]. }
  clearbody D0; destruct (cell_facts D0 L IN M W kappa HD Hnu (conj Hg Hg1) HX4) as (HG & Htau & HW & HF).
  assert (LO : forall m, In m L -> letter_ok L m = true) by (apply forallb_forall, KL).
  assert (LF : forall m, In m L -> Q2R (fst (Letter.after m)) <= Q2R (snd (Letter.after m)) /\
    Q2R (fst (Letter.before m)) <= Q2R (snd (Letter.before m)) /\ 0 < alpha m /\ 0 < beta m /\ forall n,
    In n (followers L m) -> Q2R (snd (Letter.before m)) < Q2R (fst (Letter.after n))).
  { intros m Hm; specialize (LO m Hm); unfold letter_ok in LO; rewrite !andb_true_iff in LO.
    destruct LO as [[[[A1 A2] A3] A4] A5]; apply less_lt in A3, A4; rewrite Q2R_0 in A3, A4.
    repeat split; auto using ordered_le; intros n Hn; apply less_lt; exact (proj1 (forallb_forall _ _) A5 n Hn). }
  destruct (spread_over (fun m => Q2R (snd (Letter.after m)) - Q2R (fst (Letter.after m))) alpha L) as (B1 & P1 & S1);
    [intros m Hm; apply (LF m Hm)|].
  destruct (spread_over (fun m => Q2R (snd (Letter.before m)) - Q2R (fst (Letter.before m))) beta L) as (B2 & P2 & S2);
    [intros m Hm; apply (LF m Hm)|].
  assert (HI : forall i, In (l i) L) by (intros i; apply HP).
  assert (HJ : forall i, In (l (i + 1)%Z) (followers L (l i))) by (intros i; apply followers_in, HP).
  assert (HJ' : forall i, In (l i) (followers L (l (i - 1)%Z))).
  { intros i; specialize (HJ (i - 1)%Z); replace (i - 1 + 1)%Z with i in HJ by lia; exact HJ. }
  assert (HV' : forall i, exists v, In v (Letter.next (l (i - 1)%Z)) /\ nth_error L v = Some (l i)).
  { intros i; destruct (HP (i - 1)%Z) as [_ X']; replace (i - 1 + 1)%Z with i in X' by lia; exact X'. }
  assert (HCh : chain M W kappa (B1 + B2) l).
  { constructor; trivial.
    - apply Qle_bool_iff, Qle_Rle in K0; apply less_lt in K1; rewrite Q2R_0 in K0; rewrite Q2R_1 in K1.
      split; assumption.
    - lra.
    - intros i; destruct (LF (l i) (HI i)) as (A & B & C & D & _); pose proof (S1 _ (HI i)); pose proof (S2 _ (HI i)).
      repeat split; trivial; nra.
    - intros i; apply (LF _ (HI (i - 1)%Z)), HJ'.
    - intros i s s' tau Hs Hs'; destruct (HV' i) as (v & V1 & V2).
      apply (leg_checked D0 L IN M W kappa HD MN Hnu (conj Hg Hg1) HX4 _ v); trivial. }
  split; [exists (B1 + B2); exact HCh|]; intros i s s' a tau Hs Hs' Ha phi x last Hv Hx Hv'.
  pose proof (chain_legs _ _ _ _ _ HCh i s s' Hs Hs') as (L1 & L2 & _).
  destruct (HV' i) as (v & V1 & V2); destruct (HF v _ V2) as [G _].
  pose proof (mem_all_sI D0 _ _ _ s (before_in L _ v (HI (i - 1)%Z) V1) (mem_sI D0 M W kappa HD _ _ _ Hs)) as MS.
  pose proof (mem_sI D0 M W kappa HD _ _ _ Hs') as MS'. pose proof (in_W _ _ _ _ HD) as HW'.
  apply (gap_positive D0 M W kappa _ IN (ranging (Letter.after (l i))) (PathsCheck.W D0) (PathsCheck.W D0)
    (phaseI D0 IN (sI D0 (l i) (l (i + 1)%Z))) (impactI D0 IN (all_sI D0 (before_it L v) (l i)))
    (map (fun k => phaseI D0 IN (sI D0 (l i) k)) (followers L (l i))) s s' a W W); trivial.
  - apply (impact_hits D0 M W kappa HD HG); trivial.
  - split; [exact L2|]; split; [apply (mem_phase_of D0 M W kappa HD HG); trivial |
      exact (in_map (fun k => phaseI D0 IN (sI D0 (l i) k)) _ _ (HJ i))].
  - apply mem_ranging, Ha.
  - split; [exact HW' | lra].
  - split; [exact HW' | lra].
Qed.
Theorem Paths : Paths_statement check.
Proof.
  intros X M l N HX HM HP HN W; destruct (checked_path X M l HX HM HP) as [[spread HC] HO].
  exact (one_motion M W _ spread l N HC HN HO).
Qed.
