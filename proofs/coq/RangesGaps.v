(** * Pieces of time carry the gap away from both impacts of a leg, until they meet: H4 from the checks *)

From Coq Require Import Reals QArith Qreals ZArith Lra Lia Bool List.
From Grazing Require Import StatementPaths StatementRanges ChaosInterval ChaosFunctions PathsCheck RangesCheck
  RangesLegs PathsFlow PathsLegs PathsGaps.
Import ListNotations.
Open Scope R_scope.

(** ** Away from an impact, where z = 0 and z' >= 0 *)

Section Away.
Variables z z1 z2 : R -> R.
Hypothesis D1 : forall t, derivable_pt_lim z t (z1 t).
Hypothesis D2 : forall t, derivable_pt_lim z1 t (z2 t).
Variable phi : R.
Hypothesis H0 : z phi = 0.
Hypothesis H1 : 0 <= z1 phi.

(** Up to t; and at t it moves away, if b says so. *)
Definition away (b : bool) (t : R) : Prop :=
  (forall x, phi < x <= t -> 0 < z x) /\ (b = true -> phi < t -> 0 < z1 t).

Lemma starts b l : away b l -> 0 <= z (Rmax phi l) /\ (b = true -> 0 <= z1 (Rmax phi l)).
Proof.
  intros [A B]; unfold Rmax; destruct Rle_dec as [L|L]; [|split; intros; lra].
  destruct (Rle_lt_or_eq_dec _ _ L) as [P|<-]; [|split; intros; lra].
  specialize (A l ltac:(lra)); split; [lra | intros E; specialize (B E P); lra].
Qed.
Lemma away_rising b l h : l <= h -> away b l -> (forall x, l <= x <= h -> 0 < z1 x) -> away true h.
Proof.
  intros L A R; pose proof (proj1 (starts b l A)) as S; split; [|intros _ _; apply R; lra].
  intros x Hx; destruct (Rle_lt_dec x l) as [X|X]; [apply A; lra|].
  pose proof (Rmax_r phi l); assert (Q : Rmax phi l < x) by (apply Rmax_lub_lt; lra).
  destruct (MVT_cor2 z z1 _ _ Q) as (y & E & Hy); [auto|]; specialize (R y ltac:(lra)); nra.
Qed.
Lemma away_convex l h : l <= h -> away true l -> (forall x, l <= x <= h -> 0 < z2 x) -> away true h.
Proof.
  intros L A R; destruct (starts true l A) as [S S1]; specialize (S1 eq_refl); pose proof (Rmax_r phi l) as G.
  set (s := Rmax phi l) in *; split.
  - intros x Hx; destruct (Rle_lt_dec x l) as [X|X]; [apply A; lra|]. assert (Q : s < x) by (apply Rmax_lub_lt; lra).
    apply (convex_right z z1 z2 D1 D2 s h x); trivial; [intros; apply R; lra | lra].
  - intros _ Hh; destruct (Rle_lt_dec h l) as [X|X].
    { replace h with l in Hh |- * by lra; apply A; trivial. }
    assert (Q : s < h) by (apply Rmax_lub_lt; lra).
    destruct (MVT_cor2 z1 z2 _ _ Q) as (y & E & Hy); [auto|]; specialize (R y ltac:(lra)); nra.
Qed.
Lemma away_open b l h : away b l -> (forall x, l <= x <= h -> 0 < z x) -> away false h.
Proof. intros A R; split; [|discriminate]; intros x Hx; destruct (Rle_lt_dec x l); [apply A | apply R]; lra. Qed.

(** ** Walks *)

Notation at_ i := (IZR i / IZR one).
Definition sound (f : bool -> itv -> option bool) : Prop := forall b l h b', f b (Some (l, h)) = Some b' ->
  (l <= h)%Z -> away b (at_ l) -> away b' (at_ h).

Lemma walk_away f n l h b z' r : sound f -> (l <= h)%Z -> away b (at_ l) -> walk n f l h b = (z', r) ->
  (exists c, away c (at_ z')) /\ forall c, r = Some c -> away c (at_ h).
Proof.
  intros F; revert l h b z' r; induction n as [|n IH]; intros l h b z' r L A E; cbn [walk] in E;
    (destruct (f b (Some (l, h))) as [c|] eqn:B; [injection E as <- <-; pose proof (F b l h c B L A); split;
    [exists c; trivial | congruence]|]).
  - injection E as <- <-; split; [exists b; exact A | discriminate].
  - set (m := Z.shiftr (l + h) 1) in *; assert (Hm : (l <= m <= h)%Z).
    { unfold m; rewrite Z.shiftr_div_pow2 by lia; change (2 ^ 1)%Z with 2%Z.
      split; [apply Z.div_le_lower_bound | apply Z.div_le_upper_bound]; lia. }
    destruct (walk n f l m b) as [z0 [c|]] eqn:W; destruct (IH l m b _ _ (proj1 Hm) A W) as [W1 W2].
    + exact (IH m h c _ _ (proj2 Hm) (W2 c eq_refl) E).
    + injection E as <- <-; split; [exact W1 | discriminate].
Qed.
Lemma along_away f L l b : (forall k, sound (f k)) -> away b (at_ l) -> exists c, away c (at_ (along f l b L)).
Proof.
  intros F; revert l b; induction L as [|(h & k) L IH]; intros l b A; cbn [along]; [exists b; exact A|].
  destruct (Z.leb_spec h l) as [|Lh]; [apply IH, A|].
  destruct (walk 7 (f k) l h b) as [z' [c|]] eqn:W; destruct (walk_away (f k) 7 l h b _ _ (F k) (Z.lt_le_incl _ _ Lh) A
    W) as [W1 W2]; [apply IH, W2 | exact W1]; reflexivity.
Qed.
Lemma along_positive f L l : (forall k, sound (f k)) -> at_ l <= phi ->
  forall x, phi < x <= at_ (along f l true L) -> 0 < z x.
Proof.
  intros F H; destruct (along_away f L l true F) as [c [A _]]; [split; [intros; lra | intros _ ?; lra] | exact A].
Qed.
End Away.

(** ** The gap over a leg *)

Section Gap.
Variables (D : cell) (M : Machine.t) (w kappa : R).
Hypothesis HD : in_cell D M w kappa.
Hypothesis HG : good M w.
Notation nu := (Machine.nu M).
Variables (j : BinNums.positive) (N A F' : itv) (I : impact) (s s' a : R).
Let phi := phase M w s.
Let phi' := phase M w s'.
Let x := place M phi.
Let last := 2 * PI * IZR (Z.pos j) + phi'.
Hypothesis HN : mem N nu.
Hypothesis HI : hits M w I s.
Hypothesis HL : lands M w s'.
Hypothesis HF' : mem F' phi'.
Hypothesis HA : mem A a.
Let F := phase_at I.
Let Q := place_at I.
Let z t := gap M phi x a t.
Let z1 t := - g1 M t + nu * moving M phi x a t.
Let z2 t := gap_bend M phi x a t.

Lemma D_z t : derivable_pt_lim z t (z1 t). Proof. apply (D_gap _ _ _ _ _ (good_f _ _ HG)). Qed.
Lemma D_z1 t : derivable_pt_lim z1 t (z2 t). Proof. apply (D_gap _ _ _ _ _ (good_f _ _ HG)). Qed.
Lemma mem_flown_ T t : mem T t -> mem (fst (flown D Q A F T)) (moved M phi x a t) /\
  mem (snd (flown D Q A F T)) (moving M phi x a t).
Proof.
  intros HT; pose proof (hit_phase _ _ _ _ HI); pose proof (hit_place _ _ _ _ HI).
  apply (mem_flight D M w kappa HD HG); [assumption | exact HA | apply mem_minus; assumption].
Qed.
Lemma mem_gap T t : mem T t -> mem (gap_of D N T (flown D Q A F T)) (z t).
Proof.
  intros HT; destruct (mem_flown_ T t HT) as [HM _]; pose proof (mem_gI _ _ _ _ HD _ _ HT).
  pose proof (in_Sg _ _ _ _ HD); unfold z, gap, gap_of; encl.
Qed.
Lemma mem_slope T t : mem T t -> mem (slope_of D N T (flown D Q A F T)) (z1 t).
Proof.
  intros HT; destruct (mem_flown_ T t HT) as [_ HM]; pose proof (mem_g1I _ _ _ _ HD _ _ HT).
  unfold z1, slope_of; replace (- g1 M t + nu * moving M phi x a t) with (nu * moving M phi x a t - g1 M t) by ring.
  encl.
Qed.
Lemma mem_bend T t : mem T t -> mem (bend_of D N T (flown D Q A F T)) (z2 t).
Proof.
  intros HT; destruct (mem_flown_ T t HT); pose proof (mem_bendI _ _ _ _ HD _ _ HT).
  pose proof (in_C _ _ _ _ HD); pose proof (in_K _ _ _ _ HD); unfold z2, gap_bend, bend_of; encl.
Qed.

(** About a point of the same piece. *)
Lemma mean_value f f' T u v : (forall t, derivable_pt_lim f t (f' t)) -> mem T u -> mem T v ->
  exists y, mem T y /\ f u = f v + f' y * (u - v).
Proof.
  intros Df Hu Hv; destruct (Rtotal_order u v) as [L|[<-|L]]; [|exists u; split; [exact Hu | ring]|].
  - destruct (MVT_cor2 f f' u v L) as (y & E & Hy); [auto|]; exists y; split; [|lra].
    replace y with (v + (v - y) / (v - u) * (u - v)) by (field; lra); apply mem_between; trivial.
    split; [apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]|].
    apply (Rmult_le_reg_r (v - u)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
  - destruct (MVT_cor2 f f' v u L) as (y & E & Hy); [auto|]; exists y; split; [|lra].
    replace y with (v + (y - v) / (u - v) * (u - v)) by (field; lra); apply mem_between; trivial.
    split; [apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]|].
    apply (Rmult_le_reg_r (u - v)); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
Qed.

(** In a window the wall is below its top. *)
Lemma below_the_top k T t : mem T t -> below (size (minus T (turns_on k))) (W D) = true ->
  positive (minus (fst (flown D Q A F T)) (Sg D)) = true -> 0 < z t.
Proof.
  intros Ht E3 E4; pose proof (in_W _ _ _ _ HD) as HW.
  assert (Hk : mem (turns_on k) (2 * PI * IZR (Z.max 0 k))).
  { destruct k as [|k|k]; [apply mem_turns; lia | apply mem_turns; lia | exact (mem_turns 0 ltac:(lia))]. }
  set (i := Z.max 0 k) in *; assert (Hw : Rabs (t - 2 * PI * IZR i) <= w).
  { apply (below_le _ _ _ _ E3); [encl | exact HW]. }
  assert (Ht' : - w <= t - 2 * PI * IZR i <= w) by (revert Hw; unfold Rabs; destruct Rcase_abs; lra).
  assert (P : 0 < moved M phi x a t - Machine.sigma M).
  { pose proof (in_Sg _ _ _ _ HD); destruct (mem_flown_ T t Ht); apply (positive_lt _ _ E4); encl. }
  pose proof (below_top M w (good_b _ _ HG) (good_w _ _ HG) (good_g _ _ HG) _ Ht') as G.
  rewrite <- (proj1 (g_turned M i _)) in G. replace (2 * PI * IZR i + (t - 2 * PI * IZR i)) with t in G by ring.
  pose proof (good_nu _ _ HG); unfold z, gap; nra.
Qed.
Lemma carries_says sign k b T b' : carries D N Q A F sign k b T = Some b' -> (b = true /\ b' = true /\ forall t,
  mem T t -> 0 < z2 t) \/ (b' = true /\ exists S, positive (sign S) = true /\ forall t, mem T t -> mem S (z1 t)) \/
  (b' = false /\ forall t, mem T t -> 0 < z t).
Proof.
  unfold carries; cbv zeta; set (m := at_point (middle T)); set (y := flown _ _ _ _ m); set (S := meet _ _).
  destruct (b && _)%bool eqn:E1.
  { intros [= <-]; apply andb_prop in E1; destruct E1 as [-> E1]; left; repeat split; intros t Ht.
    apply (positive_lt _ _ E1), mem_bend, Ht. }
  destruct (positive (sign (slope_of _ _ _ _))) eqn:E2.
  { intros [= <-]; right; left; split; [reflexivity|]; exists (slope_of D N T (flown D Q A F T)); split; [exact E2|].
    exact (mem_slope T). }
  destruct (_ || _)%bool eqn:E3.
  { intros [= <-]; right; right; split; [reflexivity|]; intros t Ht; apply orb_prop in E3; destruct E3 as [E3|E3].
    - exact (positive_lt _ _ E3 (mem_gap T t Ht)).
    - apply andb_prop in E3; destruct E3 as [E3 E4]; exact (below_the_top k T t Ht E3 E4). }
  assert (HS : forall t, mem T t -> mem S (z1 t)).
  { intros t Ht; apply mem_meet; [apply mem_slope, Ht|]; pose proof (mem_middle T t Ht) as Hm.
    destruct (mean_value z1 z2 T t _ D_z1 Ht Hm) as (u & Hu & ->).
    pose proof (mem_at_point (middle T)) as Hp; pose proof (mem_bend T u Hu); pose proof (mem_slope m _ Hp).
    apply mem_plus; [assumption|]; apply mem_times; [assumption | apply mem_minus; assumption]. }
  destruct (positive (sign S)) eqn:E4; [intros [= <-]; right; left; split; [reflexivity | exists S; auto]|].
  destruct (positive (plus _ _)) eqn:E5; [|discriminate]; intros [= <-]; right; right; split; [reflexivity|].
  intros t Ht; apply (positive_lt _ _ E5); pose proof (mem_middle T t Ht) as Hm.
  destruct (mean_value z z1 T t _ D_z Ht Hm) as (u & Hu & ->); pose proof (mem_at_point (middle T)) as Hp.
  pose proof (mem_gap m _ Hp); apply mem_plus; [assumption|].
  apply mem_times; [apply HS, Hu | apply mem_minus; assumption].
Qed.

Hypothesis HB : gap_open D N j I A F' = true.
Hypothesis Hv : s / 2 <= a.
Hypothesis Hx : moved M phi x a last = place M phi'.
Hypothesis Hv' : moving M phi x a last <= s' / 2.

(** The ends of pieces, in the order of time. *)
Lemma piece l h t : IZR l / IZR one <= t <= IZR h / IZR one -> mem (Some (l, h)) t.
Proof. intros H; exact (mem_join _ _ _ _ _ (mem_at_point l) (mem_at_point h) H). Qed.
Lemma order l h : (l <= h)%Z -> IZR l / IZR one <= IZR h / IZR one.
Proof. intros H; apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat, one_pos | apply IZR_le, H]. Qed.
Lemma start : z phi = 0 /\ 0 <= z1 phi.
Proof.
  pose proof (good_nu _ _ HG); destruct (hit_lands _ _ _ _ HI) as [_ E]; fold phi in E.
  destruct (moved_start M (good_f _ _ HG) phi x a) as [M0 MV]; unfold z, z1, gap; rewrite M0, MV, E.
  split; [unfold x, place; field; lra | nra].
Qed.
Lemma sound_ahead k : sound z z1 phi (carries D N Q A F (fun X => X) k).
Proof.
  intros b l h b' E L Aw; apply order in L.
  destruct start as [S0 S1]; destruct (carries_says _ _ _ _ _ E) as [(-> & -> & C)|[(-> & S & PS & C)|(-> & C)]].
  - apply (away_convex z z1 z2 D_z D_z1 phi S0 S1 _ _ L Aw); intros; apply C, piece; assumption.
  - apply (away_rising z z1 D_z phi S0 S1 b _ _ L Aw); intros; apply (positive_lt _ _ PS), C, piece; assumption.
  - apply (away_open z z1 phi b _ _ Aw); intros; apply C, piece; assumption.
Qed.

(** Back in time. *)
Let y t := z (- t).
Let y1 t := - z1 (- t).
Let y2 t := z2 (- t).
Lemma D_opp t : derivable_pt_lim Ropp t (-1).
Proof. eapply D_ext; [apply (D_scale (fun u => u) t 1 (-1)), D_id | intros u; cbv beta; ring | ring]. Qed.
Lemma D_y t : derivable_pt_lim y t (y1 t).
Proof. eapply D_value; [exact (D_of Ropp z t _ _ (D_opp t) (D_z (- t))) | unfold y1; ring]. Qed.
Lemma D_y1 t : derivable_pt_lim y1 t (y2 t).
Proof.
  eapply D_ext; [exact (D_scale _ t _ (-1) (D_of Ropp z1 t _ _ (D_opp t) (D_z1 (- t)))) | intros u; unfold y1; ring |
    unfold y2; ring].
Qed.
Lemma end_ : y (- last) = 0 /\ 0 <= y1 (- last).
Proof.
  pose proof (good_nu _ _ HG) as Hnu; destruct HL as [_ E]; fold phi' in E.
  assert (EL : g M last = g M phi' /\ g1 M last = g1 M phi') by apply g_turned; destruct EL as [EL EL'].
  unfold y, y1, z, z1, gap; rewrite Ropp_involutive, Hx, EL, EL', E. split; [unfold place; field; lra | nra].
Qed.
Lemma sound_back k : sound y y1 (- last) (fun b t => carries D N Q A F opp k b (opp t)).
Proof.
  intros b l h b' E L Aw; apply order in L; assert (P : forall t, IZR l / IZR one <= t <= IZR h / IZR one ->
    mem (opp (Some (l, h))) (- t)) by (intros; apply mem_opp, piece; assumption).
  destruct end_ as [S0 S1]; destruct (carries_says _ _ _ _ _ E) as [(-> & -> & C)|[(-> & S & PS & C)|(-> & C)]].
  - apply (away_convex y y1 y2 D_y D_y1 (- last) S0 S1 _ _ L Aw); intros; apply C, P; assumption.
  - apply (away_rising y y1 D_y (- last) S0 S1 b _ _ L Aw); intros.
    apply (positive_lt _ _ PS), mem_opp, C, P; assumption.
  - apply (away_open y y1 (- last) b _ _ Aw); intros; apply C, P; assumption.
Qed.
Lemma gap_open_positive : forall t, phi < t < last -> 0 < gap M phi x a t.
Proof.
  intros t Ht; change (0 < z t); pose proof (hit_phase _ _ _ _ HI) as HP; fold phi in HP.
  assert (HE : mem (plus (turn j) F') last) by (apply mem_plus; [apply mem_turn | exact HF']).
  pose proof HB as B; unfold gap_open in B; fold Q F in B, HP.
  destruct F as [[l l']|] eqn:EF; [|discriminate]; destruct (plus (turn j) F') as [[h' h]|]; [|discriminate].
  rewrite <- EF in B; apply ends in HP, HE; cbv zeta in B. set (L := _ ++ _) in B; set (v := along _ l true L) in B.
  pose proof (along_positive z z1 phi _ L l sound_ahead (proj1 HP)) as P; fold v in P.
  destruct (Z.leb_spec h v) as [Hh|_]; [apply order in Hh; apply P; lra|].
  set (L' := _ ++ _) in B; set (u := along _ (- h) true L') in B; apply Z.leb_le, order in B.
  assert (O : IZR (- h) / IZR one <= - last) by (rewrite opp_IZR; unfold Rdiv in *; lra).
  pose proof (along_positive y y1 (- last) _ L' (- h) sound_back O) as P'; fold u in P'.
  destruct (Rle_lt_dec t (IZR v / IZR one)) as [T|T]; [apply P; lra|].
  replace (z t) with (y (- t)) by (unfold y; f_equal; ring); apply P'; rewrite opp_IZR in B; unfold Rdiv in *; lra.
Qed.
End Gap.
