(** * At the depth that two cells share both have the same motion; and all cells together *)

From Coq Require Import Reals QArith Qreals ZArith Lra Lia Bool List Arith.
From Grazing Require Import StatementPaths StatementRanges ChaosInterval ChaosFunctions PathsCheck PathsFlow PathsLegs
  PathsGaps PathsChecked Contraction Motions RangesCheck RangesLegs RangesSteps Ranges RangesChecked.
Import ListNotations.
Open Scope R_scope.

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
Notation ranged K := (inside (lo X l K) (hi X l K)).

Section Link.
Variables (k : nat) (N : itv) (s : Z -> R) (e e' : Z -> Edge.t).
Hypothesis HN : mem N nu.
Hypothesis Hs : solution M w n s.

(** The strengths are in the sets. *)
Definition inside_sets (B : list ((named * itv) * Edge.t)) : Prop := exists S : Z -> itv,
  forall i, In (((key l i, e i), S i), e' i) B /\ mem (S i) (s i).

Lemma image_holds B S i : (forall i, In ((key l i, e i), S i) B /\ mem (S i) (s i)) ->
  let fl := flights_at X D k B N in all_hold fl = true -> mem (image_of D fl (key l i, e i)) (s i).
Proof.
  intros HB fl Hfl; set (P := fun i => part_of k (S i) (s i)).
  assert (HL : forall i, In ((key l i, e i), P i) (in_parts k B)) by (intros; apply in_parts_found; apply HB).
  assert (HM : forall i, mem (P i) (s i)) by (intros; apply part_found, HB).
  assert (some : forall i, exists s, mem (P i) s) by (intros c; exists (s c); apply HM).
  pose proof (edge_stands X D M w kappa l n HD HG Hn N _ e P HN HL some Hfl) as HS.
  pose proof (flight_in X D l n Hn N _ e P HL) as HI. pose proof (HI (i - 1)%Z) as HI'; rewrite flight_before in HI'.
  set (y := flight_of D (n (i - 1)%Z) _ _) in HI'; set (x := flight_at D l n N e P i).
  apply (mem_hull_all _ (image D y x)).
  - apply in_flat_map; exists (n (i - 1)%Z, y); split; [exact HI'|]; cbn [snd].
    rewrite (on_edge_refl D (key l i, e i) (P i) N : on_edge _ (to y) = _).
    apply in_flat_map; exists (n i, x); split; [apply HI|]; cbn [snd].
    assert (Em : meets y x = true).
    { change (on_edge (key l i, e i) (station_of D N (key l i, e i) (P i)) && same (P i) (P i) = true)%bool.
      rewrite on_edge_refl; apply same_refl. }
    rewrite Em; left; reflexivity.
  - replace (s i) with (step M w (n (i - 1)%Z) (n i) (number_of (at_edge D l N e P i)) (s (i - 1)%Z) (s i)
      (s (i + 1)%Z)).
    + apply (step_image D M w kappa HD HG Htau _ _ _ _ _ _ _ _ (HS (i - 1)%Z) (HS i) (HS (i + 1)%Z)); try apply HM.
      * exact (holds_before X D l n Hn N _ e P HL Hfl i).
      * exact (flight_holds X D l n Hn N _ e P HL Hfl i).
    + unfold step; rewrite law_sums, (sums_at _ _ _ _ Hs); ring.
Qed.
Lemma narrowed_inside B B' : inside_sets B -> narrowed X D k N B = Some B' -> inside_sets B'.
Proof.
  intros [S HB] E; unfold narrowed in E; cbv zeta in E; destruct (all_hold _) eqn:Hfl; [|discriminate].
  injection E as <-; set (fl := flights_at X D k (map fst B) N) in *.
  exists (fun i => meet (S i) (image_of D fl (key l i, e i))); intros i; split.
  - apply in_map_iff; exists (((key l i, e i), S i), e' i); split; [reflexivity | apply HB].
  - apply mem_meet; [apply HB|]; apply (image_holds (map fst B) S); [|exact Hfl]; intros c; destruct (HB c) as [I HM].
    split; [exact (in_map fst _ _ I) | exact HM].
Qed.
Lemma linked_inside m B : linked m X D k N B = true -> inside_sets B -> forall i, in_interval (Edge.strengths (e' i))
  (s i).
Proof.
  revert B; induction m as [|m IH]; intros B H HB i; cbn [linked] in H; (destruct (forallb _ B) eqn:A;
    [destruct HB as [S HB]; destruct (HB i) as [I HM]; exact (inside_within _ _ _ (proj1 (forallb_forall _ _) A _ I)
    HM)|]); [discriminate|].
  destruct (narrowed X D k N B) as [B'|] eqn:E; [|discriminate]; exact (IH B' H (narrowed_inside B B' HB E) i).
Qed.
End Link.

Lemma links_same K K' s : cell_holds X D K = true -> cell_holds X D K' = true -> links X D K K' = true ->
  nu = Q2R (snd (Cell.depth K)) -> in_interval (Cell.depth K) nu -> in_interval (Cell.depth K') nu ->
  ranged K s -> solution M w n s -> ranged K' s.
Proof.
  intros HK HK' HL E H H' R S i; unfold lo, hi.
  apply (linked_inside (Cell.parts K) (fraction (snd (Cell.depth K))) s (edge_of X l K) (edge_of X l K')) with (2 := S)
    (3 := HL).
  - rewrite E; apply mem_fraction.
  - exists (fun i => ranging (Edge.strengths (edge_of X l K i))); intros c; split.
    + apply edge_at_both; [apply (edge_there X D M l HP K HK H) | apply (edge_there X D M l HP K' HK' H')].
    + apply mem_ranging, R.
Qed.

(** ** All cells *)

Lemma cells_from q L : cells_hold X D q L = true -> forall K, In K L -> Q2R q <= Q2R (fst (Cell.depth K)) /\
  Q2R (fst (Cell.depth K)) < Q2R (snd (Cell.depth K)) /\ cell_holds X D K = true.
Proof.
  revert q; induction L as [|K L IH]; intros q H K'; [intros []|]; cbn [cells_hold] in H.
  destruct (_ && _)%bool eqn:A; [|discriminate]; destruct (cell_holds X D K) eqn:B; [|discriminate].
  destruct (match L with [] => _ | _ => _ end); [|discriminate]; apply andb_prop in A; destruct A as [A A'].
  apply Qeq_bool_iff, Qeq_eqR in A; apply less_lt in A'.
  intros [<-|I]; [repeat split; trivial; lra|]; destruct (IH _ H K' I) as (F & F' & F''); repeat split; trivial; lra.
Qed.
Lemma some_cell q L : cells_hold X D q L = true -> Q2R q <= nu ->
  (exists K, In K L /\ nu <= Q2R (snd (Cell.depth K))) -> exists K, In K L /\ in_interval (Cell.depth K) nu.
Proof.
  revert q; induction L as [|K L IH]; intros q H Hq (K' & I & U); [destruct I|]; cbn [cells_hold] in H.
  destruct (_ && _)%bool eqn:A; [|discriminate]; apply andb_prop in A; destruct A as [A _].
  apply Qeq_bool_iff, Qeq_eqR in A; destruct (cell_holds X D K); [|discriminate].
  destruct (match L with [] => _ | _ => _ end); [|discriminate].
  destruct (Rle_lt_dec nu (Q2R (snd (Cell.depth K)))) as [B|B].
  - exists K; split; [left; reflexivity | split; lra].
  - destruct I as [<-|I]; [lra|]; destruct (IH _ H ltac:(lra)) as (K1 & I1 & W1); [eauto|].
    exists K1; split; [right; exact I1 | exact W1].
Qed.
Lemma cell_solution K : cell_holds X D K = true -> in_interval (Cell.depth K) nu ->
  exists s, ranged K s /\ solution M w n s /\ forall s', ranged K s' -> solution M w n s' -> forall i, s' i = s i.
Proof.
  intros HK H; destruct (contracting_cell X D M w kappa l n HD HG Htau Hw Hkappa HP Hn K HK H) as [spread HC].
  exact (one_solution _ _ _ _ _ _ _ _ _ HC).
Qed.
Lemma common_solution q L : cells_hold X D q L = true ->
  exists s, forall K, In K L -> in_interval (Cell.depth K) nu -> ranged K s /\ solution M w n s.
Proof.
  revert q; induction L as [|K L IH]; intros q H; [exists (fun _ => 0); intros K []|].
  pose proof (cells_from q _ H) as HF; destruct (HF K (or_introl eq_refl)) as (F1 & F2 & F3).
  clear F3; cbn [cells_hold] in H; destruct (_ && _)%bool; [|discriminate].
  destruct (cell_holds X D K) eqn:F3; [|discriminate].
  destruct (match L with [] => _ | _ => _ end) eqn:HL; [|discriminate]; pose proof (cells_from _ _ H) as HR.
  destruct (Rlt_le_dec (Q2R (snd (Cell.depth K))) nu) as [A|A].
  - destruct (IH _ H) as [s Hs]; exists s; intros K' [<-|I] W; [destruct W; lra | apply Hs; assumption].
  - destruct (Rlt_le_dec nu (Q2R (fst (Cell.depth K)))) as [B|B].
    { exists (fun _ => 0); intros K' [<-|I] [W _]; [lra|]; destruct (HR K' I) as (G & _); lra. }
    destruct (cell_solution K F3 (conj B A)) as (s & Hs & S & _); exists s; intros K' [<-|I] W; [auto|].
    destruct (HR K' I) as (G1 & G2 & G3); assert (E : nu = Q2R (snd (Cell.depth K))) by (destruct W; lra).
    split; [|exact S]; destruct L as [|K1 L]; [destruct I|].
    destruct I as [<-|I]; [apply (links_same K K1 s); trivial; split; assumption|].
    cbn [cells_hold] in H; destruct (_ && _)%bool eqn:Z1; [|discriminate]; destruct (cell_holds X D K1);
      [|discriminate].
    destruct (match L with [] => _ | _ => _ end); [|discriminate]; apply andb_prop in Z1; destruct Z1 as [_ Z1].
    destruct (cells_from _ _ H K' I) as (G & _); apply less_lt in Z1; destruct (HR K1 (or_introl eq_refl)) as (G' & _).
    destruct W; lra.
Qed.
End Path.

Theorem Ranges : Ranges_statement check_range.
Proof.
  intros X M l N HX [HC HK HT HSg Hnu HV HH Hg Hg1] HP HN W; unfold check_range in HX.
  destruct (_ && _)%bool eqn:A; [|discriminate]; rewrite !andb_true_iff in A; destruct A as [[K0 K1] AW].
  set (D := cell_of X) in *; set (kappa := Q2R (Range.contraction X)).
  assert (HD : in_cell D M W kappa).
  { constructor; unfold D; cbn; try apply mem_ranging; trivial; [rewrite HSg; apply side_mem | apply mem_fraction |
      apply mem_fraction | apply rangings_mem, HH]. }
  destruct (wall_facts D M W kappa HD Hnu (conj Hg Hg1) AW) as (HG & Htau & Hw).
  assert (Hkappa : 0 <= kappa < 1).
  { apply Qle_bool_iff, Qle_Rle in K0; apply less_lt in K1; rewrite Q2R_0 in K0; rewrite Q2R_1 in K1; split;
      assumption. }
  set (n := fun i => match nth_error (Range.periods X) (l i) with Some n => n | None => xH end).
  assert (Hn : forall i, nth_error (Range.periods X) (l i) = Some (n i)).
  { intros i; destruct (HN i) as (m & E & _); unfold n; rewrite E; reflexivity. }
  assert (HN' : forall i, (N (i + 1) = N i + Z.pos (n i))%Z).
  { intros i; destruct (HN i) as (m & E & E'); unfold n; rewrite E; exact E'. }
  pose proof (contracting_cell X D M W kappa l n HD HG Htau Hw Hkappa HP Hn) as CC.
  pose proof (cells_from X D 0 _ HX) as HF.
  destruct (some_cell X D M 0 _ HX ltac:(rewrite Q2R_0; lra) HV) as (K' & I' & W').
  split; [exists K'; split; assumption|].
  destruct (common_solution X D M W kappa l n HD HG Htau Hw Hkappa HP Hn 0 _ HX) as [s Hs].
  exists (at_ M W N s), (leg_q M W n N s), (leg_v M W n N s).
  destruct (Hs K' I' W') as [R' S']; destruct (HF K' I') as (_ & _ & HK').
  split; [destruct (CC K' HK' W') as [spread HC']; exact (moves _ _ _ _ _ _ _ _ _ HC' N HN' s R' S')|].
  intros K [I HW']; destruct (Hs K I HW') as [R S]; destruct (HF K I) as (_ & _ & HK0).
  destruct (CC K HK0 HW') as [spread HC0]; pose proof (edge_there X D M l HP K HK0 HW') as ET; split.
  - intros i j ->; exists (edge_of X l K (i + 1)%Z), (s (i + 1)%Z); split; [|split; [apply R|]].
    + rewrite <- (ET (i + 1)%Z), (proj1 (previous i)); reflexivity.
    + rewrite (proj2 (wall_at M W n N HG s S (i + 1)%Z)); field.
  - intros t' y' v' HM HI.
    destruct (motion_solves _ _ _ _ _ _ _ _ _ HC0 N HN' t' y' v' HM) as [R1 S1].
    { intros i; destruct (HI (i - 1)%Z i ltac:(lia)) as (e & z & E & Hz & Ez); exists z; split; [|exact Ez].
      rewrite ET in E; injection E as <-; exact Hz. }
    destruct (one_solution _ _ _ _ _ _ _ _ _ HC0) as (s0 & R0 & S0 & U).
    apply (motion_determined M W n N HG Htau HN' t' y' v' HM (legs_at _ _ _ _ S1)).
    intros i; rewrite (U _ R1 S1), (U _ R S); reflexivity.
Qed.
