(** * What the integers of RangesCheck say of F at an edge, between a leg to it and a leg from it *)

From Coq Require Import Reals QArith Qreals ZArith Lra Lia Bool List.
From Grazing Require Import StatementPaths StatementRanges ChaosInterval ChaosFunctions PathsCheck PathsFlow PathsLegs
  PathsGaps RangesCheck RangesLegs Ranges.
Open Scope R_scope.

Section Steps.
Variables (D : cell) (M : Machine.t) (w kappa : R).
Hypothesis HD : in_cell D M w kappa.
Hypothesis HG : good M w.
Hypothesis Htau : 0 < Machine.tau M.
Notation tau := (Machine.tau M).
Notation stands := (stands M w).
Notation within_ z := (mem (strength (whole z))).
Variables (j k : BinNums.positive) (d e f : station) (cd ce cf : R).
Hypothesis Hd : stands d cd.
Hypothesis He : stands e ce.
Hypothesis Hf : stands f cf.
Let x := flight_of D j d e.
Let y := flight_of D k e f.
Hypothesis Lx : holds x = true.
Hypothesis Ly : holds y = true.
Definition number_of (z : station) : R := Q2R (Edge.factor (snd (edge z))).
Definition wt_of (z : station) : R := Q2R (Edge.weight (snd (edge z))).
Let m := number_of e.
Let F u s v := step M w j k m u s v.

Lemma size_bound z o c b : Rabs z <= c * b -> 0 <= b -> Rabs (o * z) <= Rabs o * c * b.
Proof. intros H Hb; rewrite Rabs_mult, Rmult_assoc; apply Rmult_le_compat_l; [apply Rabs_pos | exact H]. Qed.
Lemma slopes_of a a' p p' : mem (fst (fst (by_s y))) a -> mem (snd (fst (by_s y))) a' ->
  mem (fst (snd (by_s x))) p -> mem (snd (snd (by_s x))) p' -> mem (own D x y) (1 - m - m * sum_of tau a p') /\
  mem (earlier D x y) (- (m * sum_of tau 0 p)) /\ mem (later D x y) (- (m * sum_of tau a' 0)).
Proof.
  intros Ma Ma' Mp Mp'; pose proof (mem_fraction (Edge.factor (snd (edge e)))) as Hm; fold (number_of e) m in Hm.
  pose proof (mem_sum D M w kappa HD _ _ _ _ Ma Mp') as H1.
  pose proof (mem_sum D M w kappa HD _ _ _ _ mem_zero Mp) as H2.
  pose proof (mem_sum D M w kappa HD _ _ _ _ Ma' mem_zero) as H3; fold y in H1, H3; fold x in H1, H2.
  split; [unfold own, factor_of; cbn [from y flight_of] in *; encl|].
  split; [unfold earlier, factor_of; encl | unfold later, factor_of; encl].
Qed.
Lemma step_difference u s v u' s' v' : within_ d u -> within_ e s -> within_ f v -> within_ d u' -> within_ e s' ->
  within_ f v' -> exists o b r, mem (own D x y) o /\ mem (earlier D x y) b /\ mem (later D x y) r /\ (m = 0 -> o = 1) /\
  F u s v - F u' s' v' = o * (s - s') + b * (u - u') + r * (v - v').
Proof.
  intros Hu Hs Hv Hu' Hs' Hv'.
  destruct (flight_mean D M w kappa HD HG k e f ce cf He Hf Ly s v s' v' (conj Hs Hv) (conj Hs' Hv'))
    as [(a & a' & Ma & Ma' & Ea) _].
  destruct (flight_mean D M w kappa HD HG j d e cd ce Hd He Lx u s u' s' (conj Hu Hs) (conj Hu' Hs'))
    as [_ (p & p' & Mp & Mp' & Ep)].
  exists (1 - m - m * sum_of tau a p'), (- (m * sum_of tau 0 p)), (- (m * sum_of tau a' 0)).
  destruct (slopes_of _ _ _ _ Ma Ma' Mp Mp') as (Mo & Mb & Mr).
  split; [exact Mo|]; split; [exact Mb|]; split; [exact Mr|]. split; [intros ->; ring|]. unfold F, step, law.
  replace (after M k (phase M w s) (phase M w v)) with (after M k (phase M w s') (phase M w v')
    - (a * (s - s') + a' * (v - v'))) by lra.
  replace (before M j (phase M w u) (phase M w s)) with (before M j (phase M w u') (phase M w s')
    - (p * (u - u') + p' * (s - s'))) by lra.
  unfold sum_of; field; lra.
Qed.
Lemma step_image u s v : within_ d u -> within_ e s -> within_ f v -> mem (image D x y) (F u s v).
Proof.
  intros Hu Hs Hv; destruct (step_difference u s v cd ce cf Hu Hs Hv (stands_in _ _ _ _ Hd) (stands_in _ _ _ _ He)
    (stands_in _ _ _ _ Hf)) as (o & b & r & Mo & Mb & Mr & _ & E).
  pose proof (mem_apart M w d cd u Hd Hu) as Hdu; pose proof (mem_apart M w e ce s He Hs) as Hes.
  pose proof (mem_apart M w f cf v Hf Hv) as Hfv. pose proof (mids D M w kappa HD HG k e f ce cf He Hf Ly) as [MA _].
  pose proof (mids D M w kappa HD HG j d e cd ce Hd He Lx) as [_ MP].
  pose proof (mem_sum D M w kappa HD _ _ _ _ MA MP) as MS.
  pose proof (mem_fraction (Edge.factor (snd (edge e)))) as Hm; fold (number_of e) m in Hm.
  pose proof (hit_s _ _ _ _ (stands_centre _ _ _ _ He)) as Hc.
  replace (F u s v) with ((1 - m) * ce + m * sum_of tau (after M k (phase M w ce) (phase M w cf))
    (before M j (phase M w cd) (phase M w ce)) + (o * (s - ce) + (b * (u - cd) + r * (v - cf)))).
  - unfold image, factor_of; cbv zeta; apply mem_plus; [|encl]. apply mem_plus; apply mem_times; trivial; encl.
  - replace (F u s v) with (F cd ce cf + (o * (s - ce) + b * (u - cd) + r * (v - cf))) by lra.
    unfold F, step, law; ring.
Qed.

(** E2: how fast F moves, where u, s and v move so fast. *)
Lemma step_rate_bound u s v lu ls lv b : contracts D x y = true -> within_ d u -> within_ e s -> within_ f v ->
  0 <= b -> Rabs lu <= wt_of d * b -> Rabs ls <= wt_of e * b -> Rabs lv <= wt_of f * b ->
  Rabs (step_rate M w j k m u s v lu ls lv) <= wt_of e * (kappa * b).
Proof.
  intros HX Hu Hs Hv Hb Bu Bs Bv.
  destruct (flight_slopes D M w kappa HD HG k e f ce cf He Hf Ly s v (conj Hs Hv))
    as (a & a' & q & q' & Ma & Ma' & _ & _ & Ea).
  destruct (flight_slopes D M w kappa HD HG j d e cd ce Hd He Lx u s (conj Hu Hs))
    as (z & z' & p & p' & _ & _ & Mp & Mp' & Ep).
  destruct (slopes_of _ _ _ _ Ma Ma' Mp Mp') as (Mo & Mc & Mr); pose proof (in_Ka _ _ _ _ HD) as HK.
  set (o := 1 - m - m * sum_of tau a p') in *; set (c := - (m * sum_of tau 0 p)) in *.
  set (r := - (m * sum_of tau a' 0)) in *.
  assert (E : step_rate M w j k m u s v lu ls lv = o * ls + c * lu + r * lv).
  { unfold step_rate; rewrite (proj1 (Ea ls lv)), (proj2 (Ep lu ls)); unfold o, c, r, sum_of; field; lra. }
  assert (B : Rabs o * wt_of e + (Rabs c * wt_of d + Rabs r * wt_of f) <= kappa * wt_of e).
  { apply (below_le _ _ _ _ HX); unfold weight_of, wt_of; cbv zeta; encl. }
  rewrite E; apply (Rle_trans _ _ _ (Rabs_triang _ _)); pose proof (Rabs_triang (o * ls) (c * lu)) as T.
  pose proof (size_bound _ o _ _ Bs Hb); pose proof (size_bound _ c _ _ Bu Hb); pose proof (size_bound _ r _ _ Bv Hb).
  apply (Rmult_le_compat_r b) in B; [|exact Hb]; lra.
Qed.
Lemma factor_not_0 : contracts D x y = true -> kappa < 1 -> 0 < wt_of e -> 0 < wt_of d -> 0 < wt_of f -> m <> 0.
Proof.
  intros HX Hk Pe Pd Pf Em; pose proof (stands_in _ _ _ _ Hd) as Hu; pose proof (stands_in _ _ _ _ He) as Hs.
  pose proof (stands_in _ _ _ _ Hf) as Hv.
  destruct (step_difference cd ce cf cd ce cf Hu Hs Hv Hu Hs Hv) as (o & c & r & Mo & Mc & Mr & E1 & _).
  rewrite (E1 Em) in Mo; pose proof (in_Ka _ _ _ _ HD) as HK.
  assert (B : Rabs 1 * wt_of e + (Rabs c * wt_of d + Rabs r * wt_of f) <= kappa * wt_of e).
  { apply (below_le _ _ _ _ HX); unfold weight_of, wt_of; cbv zeta; encl. }
  rewrite Rabs_R1 in B; pose proof (Rabs_pos c); pose proof (Rabs_pos r); nra.
Qed.

(** E3: s is a mean of 2a and 2p. *)
Lemma step_leaves u s v : leaves x y = true -> within_ d u -> within_ e s -> within_ f v -> law M w j k u s v = s ->
  before M j (phase M w u) (phase M w s) < s / 2.
Proof.
  intros HX Hu Hs Hv E. destruct (flight_knows D M w kappa HD HG k e f ce cf He Hf Ly s v (conj Hs Hv)) as [HA _].
  destruct (flight_knows D M w kappa HD HG j d e cd ce Hd He Lx u s (conj Hu Hs)) as [_ HP].
  unfold law, sum_of in E; set (a := after _ _ _ _) in *; set (p := before _ _ _ _) in *.
  assert (E' : s * (1 + tau) = 2 * (a + tau * p)) by (rewrite <- E at 1; field; lra).
  assert (X : 0 < a - s * (1 / 2) \/ 0 < s * (1 / 2) - p \/ 0 < a - p).
  { apply orb_prop in HX; destruct HX as [HX|HX]; [apply orb_prop in HX; destruct HX as [HX|HX]|].
    - left; apply (positive_lt _ _ HX); cbn [fst] in HA; encl.
    - right; left; apply (positive_lt _ _ HX); encl.
    - right; right; apply (positive_lt _ _ HX); encl. }
  destruct X as [X|[X|X]]; nra.
Qed.
End Steps.
