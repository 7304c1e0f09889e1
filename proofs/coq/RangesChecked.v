(** * Whatever certificate of a range the check takes, every path of it is exactly one motion at every depth *)

From Coq Require Import Reals QArith Qreals ZArith Lra Lia Bool List Arith.
From Grazing Require Import StatementPaths StatementRanges ChaosInterval ChaosFunctions PathsCheck PathsFlow PathsLegs
  PathsGaps PathsChecked Contraction Motions RangesCheck RangesLegs RangesGaps RangesSteps Ranges.
Import ListNotations.
Open Scope R_scope.

(** ** Lists of edges *)

Lemma edge_at_exists G E u v : In (u, v) G -> length G = length E -> exists e, edge_at G E u v = Some e.
Proof.
  revert E; induction G as [|(u', v') G IH]; intros [|e E] H L; try discriminate; [destruct H|].
  cbn [edge_at]; destruct (Nat.eqb u u' && Nat.eqb v v')%bool eqn:B; [exists e; reflexivity|].
  apply IH; [|injection L; auto]; destruct H as [[= -> ->]|H]; [rewrite !Nat.eqb_refl in B; discriminate | exact H].
Qed.
Lemma edge_at_in G E u v e : edge_at G E u v = Some e -> In ((u, v), e) (combine G E).
Proof.
  revert E; induction G as [|(u', v') G IH]; intros [|e0 E] H; try discriminate; cbn [edge_at combine] in *.
  destruct (Nat.eqb u u' && Nat.eqb v v')%bool eqn:B; [|right; apply IH, H].
  apply andb_prop in B; destruct B as [B B']; apply Nat.eqb_eq in B, B'; subst; injection H as ->; left; reflexivity.
Qed.
Lemma edge_at_both G E E' u v e e' : edge_at G E u v = Some e -> edge_at G E' u v = Some e' ->
  In ((((u, v), e), ranging (Edge.strengths e)), e') (combine (with_ranges (combine G E)) E').
Proof.
  revert E E'; induction G as [|(u', v') G IH]; intros [|e0 E] [|e1 E'] H H'; try discriminate;
    cbn [edge_at combine with_ranges map snd] in *.
  destruct (Nat.eqb u u' && Nat.eqb v v')%bool eqn:B; [|right; apply IH; assumption].
  apply andb_prop in B; destruct B as [B B']; apply Nat.eqb_eq in B, B'; subst; injection H as ->; injection H' as ->.
  left; reflexivity.
Qed.

(** ** Parts *)

(** The first that holds a number. *)
Fixpoint piece_of (k : nat) (l w h : Z) (x : R) : itv := match k with
  | O | S O => Some (l, h)
  | S k => if Rle_lt_dec (x * IZR one) (IZR (l + w)) then Some (l, l + w)%Z else piece_of k (l + w)%Z w h x end.
Definition part_of (k : nat) (I : itv) (x : R) : itv := match I with
  | Some (l, h) => piece_of k l ((h - l) / Z.of_nat k)%Z h x | None => None end.
Lemma part_found k I x : mem I x -> In (part_of k I x) (parts k I) /\ mem (part_of k I x) x.
Proof.
  destruct I as [[l h]|]; [|split; [left; reflexivity | exact I]]; cbn [part_of parts]; set (w := (_ / _)%Z).
  clearbody w; cbn [mem]; intros A.
  assert (O : forall l h, IZR l <= x * IZR one <= IZR h -> mem (Some (l, h)) x) by (intros; cbn [mem]; assumption).
  revert l A; induction k as [|k IH]; intros l A; cbn [piece_of pieces]; [split; [left; reflexivity | auto]|].
  destruct k as [|k]; [split; [left; reflexivity | auto]|].
  destruct (Rle_lt_dec _ _) as [B|B]; [split; [left; reflexivity | apply O; lra]|].
  destruct (IH (l + w)%Z) as [I1 I2]; [lra|]; split; [right; exact I1 | exact I2].
Qed.
Lemma in_parts_found k L e S x : In (e, S) L -> mem S x -> In (e, part_of k S x) (in_parts k L).
Proof.
  intros H HS; apply in_flat_map; exists (e, S); split; [exact H|]; cbn [fst snd].
  apply (in_map (fun T => (e, T))), part_found, HS.
Qed.
Lemma same_refl I : same I I = true.
Proof. destruct I as [[a b]|]; [|reflexivity]; cbn [same]; rewrite !Z.eqb_refl; reflexivity. Qed.
Lemma on_edge_refl D e S N : on_edge e (station_of D N e S) = true.
Proof. unfold on_edge; cbn; rewrite !Nat.eqb_refl; reflexivity. Qed.

Section Path.
Variables (X : Range.t) (D : cell) (M : Machine.t) (w kappa : R) (l : Z -> nat) (n : Z -> BinNums.positive).
Hypothesis HD : in_cell D M w kappa.
Hypothesis HG : good M w.
Hypothesis Htau : 0 < Machine.tau M.
Hypothesis Hw : w <= PI.
Hypothesis Hkappa : 0 <= kappa < 1.
Hypothesis HP : edge_path X l.
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
  pose proof (flight_holds i) as H; apply andb_prop in H; destruct H as [H _]. exact (proj1 (leg_windows D _ _ _ H)).
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
Hypothesis Hnu : in_interval (Cell.depth K) nu.

Definition none : Edge.t := {| Edge.strengths := (0, 0)%Q; Edge.factor := 0; Edge.weight := 0 |}.
Definition edge_of (i : Z) : Edge.t :=
  match edge_at (Range.graph X) (Cell.edges K) (l (i - 1)%Z) (l i) with Some e => e | None => none end.
Definition lo (i : Z) : R := Q2R (fst (Edge.strengths (edge_of i))).
Definition hi (i : Z) : R := Q2R (snd (Edge.strengths (edge_of i))).
Definition factor (i : Z) : R := Q2R (Edge.factor (edge_of i)).
Definition wt (i : Z) : R := Q2R (Edge.weight (edge_of i)).
Notation k := (Cell.parts K).
Let L := in_parts k (with_ranges (edges_of X K)).
Let S (i : Z) := ranging (Edge.strengths (edge_of i)).

Lemma cell_parts : length (Range.graph X) = length (Cell.edges K) /\ forallb edge_ok (Cell.edges K) = true /\
  (exists N, mem N nu /\ contracts_at X D k (edges_of X K) N = true) /\
  exists N, mem N nu /\ open_at X D k (edges_of X K) N = true.
Proof.
  pose proof HK as H; unfold cell_holds in H; cbv zeta in H.
  destruct (Nat.eqb _ _ && forallb _ _)%bool eqn:A; [|discriminate]; apply andb_prop in A; destruct A as [A A'].
  destruct (cover halvings (contracts_at X D _ _) _) eqn:B; [|discriminate].
  split; [apply Nat.eqb_eq, A|]; split; [exact A'|].
  destruct (cover_one _ _ _ _ B (mem_ranging _ _ Hnu)) as (N & E & HN).
  destruct (cover_one _ _ _ _ H (mem_ranging _ _ Hnu)) as (N' & E' & HN'). split; [exists N | exists N']; auto.
Qed.
Lemma edge_there i : edge_at (Range.graph X) (Cell.edges K) (l (i - 1)%Z) (l i) = Some (edge_of i).
Proof.
  pose proof (HP (i - 1)%Z) as H; rewrite (proj2 (previous i)) in H.
  destruct (edge_at_exists _ _ _ _ H (proj1 cell_parts)) as [e E]; unfold edge_of; rewrite E; reflexivity.
Qed.
Lemma edge_listed i : In (key i, edge_of i) (edges_of X K). Proof. apply edge_at_in, edge_there. Qed.
Lemma edge_in i : In ((key i, edge_of i), S i) (with_ranges (edges_of X K)).
Proof. apply (in_map (fun e => (e, ranging (Edge.strengths (snd e))))), edge_listed. Qed.
Lemma edge_facts i : In (edge_of i) (Cell.edges K) /\ lo i <= hi i /\ 0 < wt i.
Proof.
  pose proof (in_combine_r _ _ _ _ (edge_listed i)) as I; split; [exact I|].
  pose proof (proj1 (forallb_forall _ _) (proj1 (proj2 cell_parts)) _ I) as E; apply andb_prop in E;
    destruct E as [A B].
  apply less_lt in B; rewrite Q2R_0 in B; split; [apply ordered_le, A | exact B].
Qed.
Lemma mem_S i s : lo i <= s <= hi i -> mem (S i) s. Proof. intros H; apply mem_ranging, H. Qed.
Lemma lowest : inside lo hi lo. Proof. intros i; pose proof (edge_facts i); lra. Qed.
Lemma spread_of : exists B, 0 <= B /\ forall i, hi i - lo i <= wt i * B.
Proof.
  destruct (spread_over (fun e => Q2R (snd (Edge.strengths e)) - Q2R (fst (Edge.strengths e))) (fun e =>
    Q2R (Edge.weight e)) (Cell.edges K)) as (B & HB & F).
  - intros e I; pose proof (proj1 (forallb_forall _ _) (proj1 (proj2 cell_parts)) _ I) as E; apply andb_prop in E.
    destruct E as [_ E]; apply less_lt in E; rewrite Q2R_0 in E; exact E.
  - exists B; split; [exact HB|]; intros i; apply F, edge_facts.
Qed.

(** In the parts that hold these strengths. *)
Section Strengths.
Variable s : Z -> R.
Hypothesis Hs : inside lo hi s.
Definition part (i : Z) : itv := part_of k (S i) (s i).
Lemma in_part i : mem (part i) (s i). Proof. apply part_found, mem_S, Hs. Qed.
Lemma part_in i : In ((key i, edge_of i), part i) L.
Proof. apply in_parts_found; [apply edge_in | apply mem_S, Hs]. Qed.
Lemma some_part i : exists s, mem (part i) s. Proof. exists (s i); apply in_part. Qed.

Variable N : itv.
Hypothesis HN : mem N nu.

Section Contracts.
Hypothesis HX : contracts_at X D k (edges_of X K) N = true.
Notation station_at := (at_edge N edge_of part).
Notation x := (flight_at N edge_of part).

Lemma fl_holds : all_hold (flights X D (stations D N L)) = true.
Proof.
  pose proof HX as H; unfold contracts_at in H; cbv zeta in H; unfold flights_at in H; fold L in H.
  destruct (all_hold _); [reflexivity | discriminate].
Qed.
Lemma stands_at i : stands M w (station_at i) (middle_at part i).
Proof. exact (edge_stands N L edge_of part HN part_in some_part fl_holds i). Qed.
Lemma holds_at i : holds (x i) = true. Proof. exact (flight_holds N L edge_of part part_in fl_holds i). Qed.
Lemma before_at i : holds (flight_of D (n (i - 1)%Z) (station_at (i - 1)) (station_at i)) = true.
Proof. exact (holds_before N L edge_of part part_in fl_holds i). Qed.
Lemma steps_at i : let y := flight_of D (n (i - 1)%Z) (station_at (i - 1)) (station_at i) in PathsCheck.inside
  (Edge.strengths (edge_of i)) (image D y (x i)) = true /\ contracts D y (x i) = true /\ leaves y (x i) = true.
Proof.
  intros y; pose proof HX as H; unfold contracts_at in H; cbv zeta in H; unfold flights_at in H; fold L in H.
  destruct (all_hold _); [|discriminate].
  pose proof (flight_in N L edge_of part part_in (i - 1)) as I; rewrite flight_before in I.
  apply (proj1 (forallb_forall _ _)) with (x := (n (i - 1)%Z, y)) in H; [|exact I].
  apply (proj1 (forallb_forall _ _)) with (x := (n i, x i)) in H; [|apply (flight_in N L edge_of part part_in i)].
  cbn [snd] in H; unfold follows_well in H.
  assert (Em : meets y (x i) = true).
  { change (on_edge (key i, edge_of i) (station_of D N (key i, edge_of i) (part i)) && same (part i) (part i)
      = true)%bool.
    rewrite on_edge_refl; apply same_refl. }
  rewrite Em in H; clear Em.
  rewrite !andb_true_iff in H; cbn [y flight_at flight_of from edge at_edge station_of snd fst] in H; tauto.
Qed.
Lemma lands_at i : lands M w (s i).
Proof. exact (hit_lands _ _ _ _ (stands_over _ _ _ _ (stands_at i) _ (in_part i))). Qed.
Lemma leg_there i : E12 M (time (n i) (phase M w (s i)) (phase M w (s (i + 1)%Z))) <> 0.
Proof.
  apply (flight_leg D M w kappa HD HG _ _ _ _ _ (stands_at i) (stands_at (i + 1)) (holds_at i)). split; apply in_part.
Qed.
Lemma image_at i : lo i <= step M w (n (i - 1)%Z) (n i) (factor i) (s (i - 1)%Z) (s i) (s (i + 1)%Z) <= hi i.
Proof.
  destruct (steps_at i) as (C & _); apply (inside_within _ _ _ C).
  apply (step_image D M w kappa HD HG Htau _ _ _ _ _ _ _ _ (stands_at (i - 1)) (stands_at i) (stands_at (i + 1))
    (before_at i) (holds_at i)); apply in_part.
Qed.
Lemma rate_at i lu ls lv b : 0 <= b -> Rabs lu <= wt (i - 1) * b -> Rabs ls <= wt i * b -> Rabs lv <= wt (i + 1) * b ->
  Rabs (step_rate M w (n (i - 1)%Z) (n i) (factor i) (s (i - 1)%Z) (s i) (s (i + 1)%Z) lu ls lv) <= wt i * (kappa * b).
Proof.
  intros Hb Bu Bs Bv; destruct (steps_at i) as (_ & C & _).
  apply (step_rate_bound D M w kappa HD HG Htau _ _ _ _ _ _ _ _ (stands_at (i - 1)) (stands_at i) (stands_at (i + 1))
    (before_at i) (holds_at i)); trivial; apply in_part.
Qed.
Lemma factor_at i : factor i <> 0.
Proof.
  destruct (steps_at i) as (_ & C & _); pose proof (edge_facts (i - 1)); pose proof (edge_facts i).
  pose proof (edge_facts (i + 1)).
  apply (factor_not_0 D M w kappa HD HG Htau _ _ _ _ _ _ _ _ (stands_at (i - 1)) (stands_at i) (stands_at (i + 1))
    (before_at i) (holds_at i) C); try lra; unfold wt_of; cbn; unfold wt in *; tauto.
Qed.
Lemma speed_at i : sums M w n s i = s i -> befores M w n s (i - 1) < s i / 2.
Proof.
  intros E; destruct (steps_at i) as (_ & _ & C); unfold befores; rewrite (proj2 (previous i)).
  apply (step_leaves D M w kappa HD HG Htau _ _ _ _ _ _ _ _ (stands_at (i - 1)) (stands_at i) (stands_at (i + 1))
    (before_at i) (holds_at i)) with (v := s (i + 1)%Z); trivial; [apply in_part | apply in_part | apply in_part |
    rewrite law_sums; exact E].
Qed.
End Contracts.

Lemma gap_at i : open_at X D k (edges_of X K) N = true -> lands M w (s i) -> lands M w (s (i + 1)%Z) -> let a :=
  afters M w n s i in let x := place M (phase M w (s i)) in let end_ := 2 * PI * IZR (Z.pos (n i)) + phase M w
  (s (i + 1)%Z) in s i / 2 <= a -> PathsFlow.moved M (phase M w (s i)) x a end_ = place M (phase M w (s (i + 1)%Z)) ->
  moving M (phase M w (s i)) x a end_ <= s (i + 1)%Z / 2 -> forall t, phase M w (s i) < t < end_ ->
  0 < gap M (phase M w (s i)) x a t.
Proof.
  intros HX L1 L2 a x end_; unfold open_at in HX; cbv zeta in HX; unfold flights_at in HX; fold L in HX.
  destruct (all_hold _) eqn:Hfl; [|discriminate]; set (fl := flights X D (stations D N L)) in *.
  set (all := map _ _) in HX; set (I := fun i => impactI D N (S i)).
  assert (HI : forall i, In ((key i, edge_of i), I i) all).
  { intros c; apply in_map_iff; exists ((key c, edge_of c), S c); split; [reflexivity | apply edge_in]. }
  apply (proj1 (forallb_forall _ _)) with (x := ((key i, edge_of i), I i)) in HX; [|apply HI].
  apply (proj1 (forallb_forall _ _)) with (x := ((key (i + 1), edge_of (i + 1)), I (i + 1)%Z)) in HX; [|apply HI].
  assert (Em : Nat.eqb (snd (key i)) (fst (key (i + 1))) = true).
  { cbn [key fst snd]; rewrite (proj1 (previous i)); apply Nat.eqb_refl. }
  cbn [fst snd] in HX; rewrite Em, (Hn i : nth_error _ (snd (key i)) = _) in HX; clear Em.
  set (A := firsts _ _ _) in HX. pose proof (edge_stands N L edge_of part HN part_in some_part Hfl) as HS.
  pose proof (flight_holds N L edge_of part part_in Hfl) as HL.
  assert (HA : mem A a).
  { destruct (flight_knows D M w kappa HD HG _ _ _ _ _ (HS i) (HS (i + 1)%Z) (HL i) (s i) (s (i + 1)%Z)) as [HA _];
      [split; apply in_part|]; refine (mem_hull_all _ _ _ _ HA); apply in_flat_map.
    exists (n i, flight_at N edge_of part i); split; [exact (flight_in N L edge_of part part_in i)|].
    cbn [snd flight_at flight_of from to]; rewrite (on_edge_refl D (key i, edge_of i) (part i) N : on_edge _
      (at_edge N edge_of part i) = _), (on_edge_refl D (key (i + 1), edge_of (i + 1)) (part (i + 1)) N : on_edge _
      (at_edge N edge_of part (i + 1)) = _); left; reflexivity. }
  pose proof (impact_hits D M w kappa HD HG N (S i) (s i) HN (mem_S i _ (Hs i)) L1) as H1.
  pose proof (hit_phase _ _ _ _ (impact_hits D M w kappa HD HG N _ _ HN (mem_S (i + 1)%Z _ (Hs (i + 1)%Z)) L2)) as H2.
  intros G1 G2 G3; exact (gap_open_positive D M w kappa HD HG (n i) N A _ (I i) (s i) (s (i + 1)%Z) a HN H1 L2 H2 HA HX
    G1 G2 G3).
Qed.
End Strengths.

(** E2 along the segment between two sequences of strengths. *)
Lemma close_at N s s' d i : mem N nu -> contracts_at X D k (edges_of X K) N = true -> inside lo hi s ->
  inside lo hi s' -> 0 <= d -> (forall i, Rabs (s i - s' i) <= wt i * d) ->
  Rabs (step M w (n (i - 1)%Z) (n i) (factor i) (s (i - 1)%Z) (s i) (s (i + 1)%Z) - step M w (n (i - 1)%Z) (n i)
  (factor i) (s' (i - 1)%Z) (s' i) (s' (i + 1)%Z)) <= wt i * (kappa * d).
Proof.
  intros HN HX Hs Hs' Hd E; set (c := fun y j => s' j + y * (s j - s' j)).
  assert (Hc : forall y, 0 <= y <= 1 -> inside lo hi (c y)).
  { intros y Hy j; specialize (Hs j); specialize (Hs' j); unfold c; apply between; assumption. }
  assert (Dc : forall j y, derivable_pt_lim (fun y => c y j) y (s j - s' j)).
  { intros j y; unfold c; derive_by fail; ring. }
  set (f := fun y => step M w (n (i - 1)%Z) (n i) (factor i) (c y (i - 1)%Z) (c y i) (c y (i + 1)%Z)).
  destruct (MVT_cor2 f (fun y => step_rate M w (n (i - 1)%Z) (n i) (factor i) (c y (i - 1)%Z) (c y i) (c y (i + 1)%Z)
    (s (i - 1)%Z - s' (i - 1)%Z) (s i - s' i) (s (i + 1)%Z - s' (i + 1)%Z)) 0 1 Rlt_0_1) as (y & Ey & Hy).
  { intros y Hy; specialize (Hc y Hy); pose proof (lands_at (c y) Hc N HN HX) as HL.
    pose proof (leg_there (c y) Hc N HN HX (i - 1)) as HE; rewrite (proj2 (previous i)) in HE.
    apply (D_step M w _ _ _ (fun y => c y (i - 1)%Z) (fun y => c y i) (fun y => c y (i + 1)%Z)); trivial.
    apply (leg_there (c y) Hc N HN HX). }
  assert (E1 : forall j, c 1 j = s j) by (intros; unfold c; ring).
  assert (E0 : forall j, c 0 j = s' j) by (intros; unfold c; ring).
  unfold f in Ey; rewrite !E1, !E0, Rminus_0_r, Rmult_1_r in Ey; rewrite Ey.
  apply (rate_at (c y) (Hc y ltac:(lra)) N HN HX); trivial.
Qed.
Lemma contracting_cell : exists spread, contracting M w kappa spread n lo hi factor wt.
Proof.
  destruct spread_of as (B & HB & F); destruct cell_parts as (_ & _ & (N & HN & HX) & (N' & HN' & HX')).
  exists B; constructor; trivial.
  - intros i; destruct (edge_facts i) as (_ & A & A'); repeat split; trivial. exact (factor_at lo lowest N HN HX i).
  - intros s i Hs; exact (lands_at s Hs N HN HX i).
  - intros s i Hs; exact (leg_there s Hs N HN HX i).
  - intros s i Hs; exact (image_at s Hs N HN HX i).
  - intros s s' d i Hs Hs' Hd E; exact (close_at N s s' d i HN HX Hs Hs' Hd E).
  - intros s i Hs; exact (speed_at s Hs N HN HX i).
  - intros s i Hs; exact (gap_at s Hs N' HN' i HX' (lands_at s Hs N HN HX i) (lands_at s Hs N HN HX (i + 1)%Z)).
Qed.
End Cell.
End Path.
