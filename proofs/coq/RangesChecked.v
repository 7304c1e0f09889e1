(** * Whatever certificate of a range the check takes, every path of it is exactly one motion at every depth *)

From Coq Require Import Reals QArith Qreals ZArith Lra Lia Bool List Arith.
From Grazing Require Import StatementPaths StatementRanges ChaosInterval ChaosFunctions PathsCheck PathsFlow
  PathsLegs
  PathsGaps PathsChecked Contraction Motions RangesCheck RangesLegs RangesSteps Ranges.
Import ListNotations.
Open Scope R_scope.

(** ** Lists of edges *)

Lemma edge_at_exists G E u v : In (u, v) G -> length G = length E -> exists e, edge_at G E u v = Some e.
Proof.
  revert E; induction G as [|(u', v') G IH]; intros [|e E] H L; try discriminate; [destruct H|].
  cbn [edge_at]; destruct (Nat.eqb u u' && Nat.eqb v v')%bool eqn:B; [exists e; reflexivity|].
  apply IH; [|injection L; auto]; destruct H as [[= -> ->]|H]; [rewrite !Nat.eqb_refl in B; discriminate | exact
    H].
Qed.
Lemma edge_at_in G E u v e : edge_at G E u v = Some e -> In ((u, v), e) (combine G E).
Proof.
  revert E; induction G as [|(u', v') G IH]; intros [|e0 E] H; try discriminate; cbn [edge_at combine] in *.
  destruct (Nat.eqb u u' && Nat.eqb v v')%bool eqn:B; [|right; apply IH, H].
  apply andb_prop in B; destruct B as [B B']; apply Nat.eqb_eq in B, B'; subst; injection H as ->; left;
    reflexivity.
Qed.
Lemma edge_at_both G E E' u v e e' : edge_at G E u v = Some e -> edge_at G E' u v = Some e' ->
  In ((((u, v), e), ranging (Edge.strengths e)), e') (combine (with_ranges (combine G E)) E').
Proof.
  revert E E'; induction G as [|(u', v') G IH]; intros [|e0 E] [|e1 E'] H H'; try discriminate;
    cbn [edge_at combine with_ranges map snd] in *.
  destruct (Nat.eqb u u' && Nat.eqb v v')%bool eqn:B; [|right; apply IH; assumption].
  apply andb_prop in B; destruct B as [B B']; apply Nat.eqb_eq in B, B'; subst; injection H as ->; injection H'
    as ->.
  left; reflexivity.
Qed.

Section Path.
Variables (X : Range.t) (D : cell) (M : Machine.t) (w kappa : R) (l : Z -> nat) (n : Z -> BinNums.positive).
Hypothesis HD : in_cell D M w kappa.
Hypothesis HG : good M w.
Hypothesis Htau : 0 < Machine.tau M.
Hypothesis Hw : w <= PI.
Hypothesis Hkappa : 0 <= kappa < 1.
Hypothesis HP : path X l.
Hypothesis Hn : forall i, nth_error (Range.periods X) (l i) = Some (n i).
Notation nu := (Machine.nu M).

(** ** Legs along the path between edges with these strengths *)

Definition key (i : Z) : nat * nat := (l (i - 1)%Z, l i).
Section Stations.
Variables (N : itv) (L : list (named * itv)) (e : Z -> Edge.t) (S : Z -> itv).
Hypothesis HN : mem N nu.
Hypothesis HL : forall i, In ((key i, e i), S i) L.
Hypothesis HS : forall i, exists s, mem (S i) s.
Let fl := flights X D (stations D N L).
Hypothesis Hfl : all_hold fl = true.

Definition at_edge (i : Z) : station := station_of D N (key i, e i) (S i).
Definition flight_at (i : Z) : flight := flight_of D (n i) (at_edge i) (at_edge (i + 1)).
Definition middle_at (i : Z) : R := IZR (middle (S i)) / IZR one.

Lemma flight_in i : In (n i, flight_at i) fl.
Proof.
  assert (HE : forall i, In (at_edge i) (stations D N L)).
  { intros k; apply in_map_iff; exists ((key k, e k), S k); split; [reflexivity | apply HL]. }
  apply in_flat_map; exists (at_edge i); split; [apply HE|]; apply in_flat_map; exists (at_edge (i + 1)).
  split; [apply HE|]; cbn [at_edge station_of edge fst snd key]; rewrite (proj1 (previous i)), Nat.eqb_refl, Hn.
  left; reflexivity.
Qed.
Lemma flight_holds i : holds (flight_at i) = true.
Proof. exact (proj1 (forallb_forall _ _) Hfl _ (flight_in i)). Qed.
Lemma edge_stands i : stands M w (at_edge i) (middle_at i).
Proof.
  destruct (HS i) as [s Hs]; apply (station_stands D M w kappa HD HG) with (s := s); trivial.
  pose proof (flight_holds i) as H; apply andb_prop in H; destruct H as [H _].
  exact (proj1 (leg_windows D _ _ _ H)).
Qed.
(** Before it, in the form of steps. *)
Lemma flight_before i : flight_at (i - 1) = flight_of D (n (i - 1)%Z) (at_edge (i - 1)) (at_edge i).
Proof. unfold flight_at; rewrite (proj2 (previous i)); reflexivity. Qed.
Lemma holds_before i : holds (flight_of D (n (i - 1)%Z) (at_edge (i - 1)) (at_edge i)) = true.
Proof. rewrite <- flight_before; apply flight_holds. Qed.
End Stations.

(** ** A cell *)

Section Cell.
Variables (K : Cell.t).
Hypothesis HK : cell_holds X D K = true.
Hypothesis Hnu : within (Cell.depth K) nu.

Definition none : Edge.t := {| Edge.strengths := (0, 0)%Q; Edge.factor := 0; Edge.weight := 0 |}.
Definition edge_of (i : Z) : Edge.t :=
  match edge_at (Range.graph X) (Cell.edges K) (l (i - 1)%Z) (l i) with Some e => e | None => none end.
Definition lo (i : Z) : R := Q2R (fst (Edge.strengths (edge_of i))).
Definition hi (i : Z) : R := Q2R (snd (Edge.strengths (edge_of i))).
Definition factor (i : Z) : R := Q2R (Edge.factor (edge_of i)).
Definition wt (i : Z) : R := Q2R (Edge.weight (edge_of i)).
Let L := with_ranges (edges_of X K).
Let S (i : Z) := ranging (Edge.strengths (edge_of i)).

Lemma cell_parts : length (Range.graph X) = length (Cell.edges K) /\ forallb edge_ok (Cell.edges K) = true /\
  (exists N, mem N nu /\ contracts_at X D (edges_of X K) N = true) /\
  exists N, mem N nu /\ open_at X D (edges_of X K) N = true.
Proof.
  pose proof HK as H; unfold cell_holds in H; cbv zeta in H.
  destruct (Nat.eqb _ _ && forallb _ _)%bool eqn:A; [|discriminate]; apply andb_prop in A; destruct A as [A A'].
  destruct (cover fuel (contracts_at X D _) _) eqn:B; [|discriminate].
  split; [apply Nat.eqb_eq, A|]; split; [exact A'|].
  destruct (cover_one _ _ _ _ B (mem_ranging _ _ Hnu)) as (N & E & HN).
  destruct (cover_one _ _ _ _ H (mem_ranging _ _ Hnu)) as (N' & E' & HN').
  split; [exists N | exists N']; auto.
Qed.
Lemma edge_there i : edge_at (Range.graph X) (Cell.edges K) (l (i - 1)%Z) (l i) = Some (edge_of i).
Proof.
  pose proof (HP (i - 1)%Z) as H; rewrite (proj2 (previous i)) in H.
  destruct (edge_at_exists _ _ _ _ H (proj1 cell_parts)) as [e E]; unfold edge_of; rewrite E; reflexivity.
Qed.
Lemma edge_listed i : In (key i, edge_of i) (edges_of X K).
Proof. apply edge_at_in, edge_there. Qed.
Lemma edge_in i : In ((key i, edge_of i), S i) L.
Proof. apply (in_map (fun e => (e, ranging (Edge.strengths (snd e))))), edge_listed. Qed.
Lemma edge_facts i : In (edge_of i) (Cell.edges K) /\ lo i <= hi i /\ 0 < wt i.
Proof.
  pose proof (in_combine_r _ _ _ _ (edge_listed i)) as I; split; [exact I|].
  pose proof (proj1 (forallb_forall _ _) (proj1 (proj2 cell_parts)) _ I) as E; apply andb_prop in E; destruct E
    as [A B].
  apply less_lt in B; rewrite Q2R_0 in B; split; [apply ordered_le, A | exact B].
Qed.
Lemma mem_S i s : lo i <= s <= hi i -> mem (S i) s.
Proof. intros H; apply mem_ranging, H. Qed.
Lemma some_S i : exists s, mem (S i) s.
Proof. exists (lo i); apply mem_S; pose proof (edge_facts i); lra. Qed.
Lemma spread_of : exists B, 0 <= B /\ forall i, hi i - lo i <= wt i * B.
Proof.
  destruct (spread_over (fun e => Q2R (snd (Edge.strengths e)) - Q2R (fst (Edge.strengths e)))
    (fun e => Q2R (Edge.weight e)) (Cell.edges K)) as (B & HB & F).
  - intros e I; pose proof (proj1 (forallb_forall _ _) (proj1 (proj2 cell_parts)) _ I) as E; apply andb_prop in E.
    destruct E as [_ E]; apply less_lt in E; rewrite Q2R_0 in E; exact E.
  - exists B; split; [exact HB|]; intros i; apply F, edge_facts.
Qed.

Section Contracts.
Variable N : itv.
Hypothesis HN : mem N nu.
Hypothesis HX : contracts_at X D (edges_of X K) N = true.
Let x := flight_at N edge_of S.

Lemma fl_holds : all_hold (flights X D (stations D N L)) = true.
Proof. pose proof HX as H; unfold contracts_at in H; cbv zeta in H; fold L in H; destruct (all_hold _);
  [reflexivity |
  discriminate]. Qed.
Let HS i := edge_stands N L edge_of S HN edge_in some_S fl_holds i.
Let HL i := flight_holds N L edge_of S edge_in fl_holds i.
Let HB i := holds_before N L edge_of S edge_in fl_holds i.

Lemma steps_at i : let y := flight_of D (n (i - 1)%Z) (at_edge N edge_of S (i - 1)) (at_edge N edge_of S i) in
  PathsCheck.inside (Edge.strengths (edge_of i)) (image D y (x i)) = true /\ contracts D y (x i) = true /\
    leaves y (x i) = true.
Proof.
  intros y; pose proof HX as H; unfold contracts_at in H; cbv zeta in H; fold L in H; destruct (all_hold _);
    [|discriminate].
  pose proof (flight_in N L edge_of S edge_in (i - 1)) as I; rewrite flight_before in I.
  apply (proj1 (forallb_forall _ _)) with (x := (n (i - 1)%Z, y)) in H; [|exact I].
  apply (proj1 (forallb_forall _ _)) with (x := (n i, x i)) in H; [|apply (flight_in N L edge_of S edge_in i)].
  cbn [snd] in H; unfold follows_well in H.
  replace (same_edge y (x i)) with true in H by (symmetry; unfold same_edge; cbn; rewrite !Nat.eqb_refl;
    reflexivity).
  rewrite !andb_true_iff in H; cbn [x y flight_at flight_of from edge at_edge station_of snd fst] in H; tauto.
Qed.

Lemma window_at i s : lo i <= s <= hi i -> lands M w s.
Proof. intros H; exact (hit_lands _ _ _ _ (stands_over _ _ _ _ (HS i) s (mem_S i s H))). Qed.
Lemma near_at s i : inside lo hi s -> mem (S (i - 1)%Z) (s (i - 1)%Z) /\ mem (S i) (s i) /\ mem (S (i + 1)%Z) (s
  (i + 1)%Z).
Proof. intros H; repeat split; apply mem_S, H. Qed.
End Contracts.

Lemma contracting_cell : exists spread, contracting M w kappa spread n lo hi factor wt.
Proof.
  destruct spread_of as (B & HB & F); destruct cell_parts as (_ & _ & (N & HN & HX) & (N' & HN' & HX')).
  set (HS := edge_stands N L edge_of S HN edge_in some_S (fl_holds N HX)).
  set (HL := flight_holds N L edge_of S edge_in (fl_holds N HX)).
  set (HB' := holds_before N L edge_of S edge_in (fl_holds N HX)).
  exists B; constructor; trivial.
  - intros i; destruct (edge_facts i) as (_ & A & A'); repeat split; trivial.
    pose proof (edge_facts (i - 1)); pose proof (edge_facts (i + 1)).
    destruct (steps_at N HX i) as (_ & C & _).
    apply (factor_not_0 D M w kappa HD HG Htau _ _ _ _ _ _ _ _ (HS (i - 1)%Z) (HS i) (HS (i + 1)%Z) (HB' i) (HL
      i) C);
      try lra; unfold wt_of; cbn; unfold wt in *; tauto.
  - intros i s; apply (window_at N HN HX).
  - intros i s v Hs Hv.
    apply (flight_leg D M w kappa HD HG _ _ _ _ _ (HS i) (HS (i + 1)%Z) (HL i)); split; apply mem_S; assumption.
  - intros s i Hs; destruct (near_at s i Hs) as (H1 & H2 & H3); destruct (steps_at N HX i) as (C & _).
    apply (inside_within _ _ _ C).
    apply (step_image D M w kappa HD HG Htau _ _ _ _ _ _ _ _ (HS (i - 1)%Z) (HS i) (HS (i + 1)%Z) (HB' i) (HL
      i)); trivial.
  - intros s s' d i Hs Hs' Hd E; destruct (near_at s i Hs) as (H1 & H2 & H3), (near_at s' i Hs') as (H1' & H2' &
    H3').
    destruct (steps_at N HX i) as (_ & C & _).
    apply (step_close D M w kappa HD HG Htau _ _ _ _ _ _ _ _ (HS (i - 1)%Z) (HS i) (HS (i + 1)%Z) (HB' i) (HL i));
      trivial; apply E.
  - intros s i Hs E; destruct (near_at s i Hs) as (H1 & H2 & H3); destruct (steps_at N HX i) as (_ & _ & C).
    unfold befores; rewrite (proj2 (previous i)).
    apply (step_leaves D M w kappa HD HG Htau _ _ _ _ _ _ _ _ (HS (i - 1)%Z) (HS i) (HS (i + 1)%Z) (HB' i) (HL i))
      with (v := s (i + 1)%Z); trivial.
    rewrite law_sums; exact E.
  - clear HS HL HB' HN HX N; rename N' into N, HN' into HN, HX' into HX.
    unfold open_at in HX; cbv zeta in HX; fold L in HX; destruct (all_hold _) eqn:Hfl; [|discriminate].
    intros s i Hs a x end_ G1 G2 G3; destruct (near_at s i Hs) as (_ & H2 & H3).
    pose proof (edge_stands N L edge_of S HN edge_in some_S Hfl) as HS.
    pose proof (flight_holds N L edge_of S edge_in Hfl) as HL.
    apply (proj1 (forallb_forall _ _)) with (x := (n i, flight_at N edge_of S i)) in HX; [|exact (flight_in N L
      edge_of S edge_in i)].
    cbn [fst snd] in HX; apply existsb_exists in HX; destruct HX as (q & Hq & HX).
    pose proof (stands_over _ _ _ _ (HS i) _ H2) as HI; pose proof (stands_over _ _ _ _ (HS (i + 1)%Z) _ H3) as
      HI'.
    destruct (flight_knows D M w kappa HD HG _ _ _ _ _ (HS i) (HS (i + 1)%Z) (HL i) _ _ (conj H2 H3)) as [HA _].
    pose proof (in_W _ _ _ _ HD) as HW; pose proof (good_w _ _ HG).
    assert (Hq' : w * (1 / IZR (Z.pos q)) <= w).
    { assert (1 <= IZR (Z.pos q)) by (apply IZR_le; lia).
      assert (1 / IZR (Z.pos q) <= 1); [|nra]; apply (Rmult_le_reg_r (IZR (Z.pos q))); [lra|].
      unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
    assert (HT : mem (times (W D) (constant 1 q)) (w * (1 / IZR (Z.pos q))) /\ w * (1 / IZR (Z.pos q)) <= w)
      by (split; [encl | exact Hq']).
    apply (gap_positive D M w kappa (n i) N _ _ _ (phase_at (whole (at_edge N edge_of S (i + 1)))) (whole
      (at_edge N edge_of S i))
      _ (s i) (s (i + 1)%Z) a _ _ HD HG Hw HN HI) with (5 := HX) (3 := HT) (4 := HT); trivial.
    split; [exact (hit_lands _ _ _ _ HI')|]; split; [exact (hit_phase _ _ _ _ HI') | left; reflexivity].
Qed.
End Cell.
End Path.
