(** * What the integers of RangesCheck say of the legs between two edges: mean values and where F leads *)

From Coq Require Import Reals QArith Qreals ZArith Lra Lia Bool List.
From Grazing Require Import StatementPaths StatementRanges ChaosInterval ChaosFunctions PathsCheck PathsFlow PathsLegs
  PathsGaps RangesCheck.
Open Scope R_scope.

Lemma mem_middle X x : mem X x -> mem X (IZR (middle X) / IZR one).
Proof.
  destruct X as [[l h]|]; [|trivial]; cbn [mem middle]; intros H; pose proof one_pos.
  assert (l <= h)%Z by (apply le_IZR; lra).
  replace (IZR (Z.shiftr (l + h) 1) / IZR one * IZR one) with (IZR (Z.shiftr (l + h) 1)) by (field; lra).
  rewrite Z.shiftr_div_pow2 by lia; change (2 ^ 1)%Z with 2%Z.
  split; apply IZR_le; [apply Z.div_le_lower_bound | apply Z.div_le_upper_bound]; lia.
Qed.
Lemma mem_between X a b x : mem X a -> mem X b -> 0 <= x <= 1 -> mem X (b + x * (a - b)).
Proof.
  destruct X as [[l h]|]; [|trivial]; cbn [mem]; intros Ha Hb Hx; pose proof one_pos.
  replace ((b + x * (a - b)) * IZR one) with (b * IZR one + x * (a * IZR one - b * IZR one)) by ring.
  apply between; assumption.
Qed.

Section Legs.
Variables (D : cell) (M : Machine.t) (w kappa : R).
Hypothesis HD : in_cell D M w kappa.
Hypothesis HG : good M w.
Notation nu := (Machine.nu M).
Notation ph := (phase M w).

(** What is known of all impacts. *)
Definition over (I : impact) : Prop := forall s, mem (strength I) s -> hits M w I s.

Section Leg.
Variables (j : BinNums.positive) (I I' : impact).
Hypothesis HI : over I.
Hypothesis HI' : over I'.
Let x := leg_between D j I I'.
Hypothesis HL : lawful x = true.
Let a s s' := after M j (ph s) (ph s').
Let p s s' := before M j (ph s) (ph s').
Definition both (s s' : R) : Prop := mem (strength I) s /\ mem (strength I') s'.

Lemma known s s' : both s s' -> leg_known M w x j s s'.
Proof. intros [H H']; apply (leg_between_known D M w kappa HD HG); auto. Qed.

(** Along a segment. *)
Lemma leg_mean P s1 s1' s2 s2' : (forall s s', both s s' -> mem P (p s s')) -> both s1 s1' -> both s2 s2' ->
  (exists b b', mem (fst (fst (slopes x P))) b /\ mem (snd (fst (slopes x P))) b' /\ a s1 s1' - a s2 s2' =
  - (b * (s1 - s2) + b' * (s1' - s2'))) /\ (exists d d', mem (fst (snd (slopes x P))) d /\ mem (snd (snd (slopes x P)))
  d' /\ p s1 s1' - p s2 s2' = - (d * (s1 - s2) + d' * (s1' - s2'))).
Proof.
  intros HP [H1 H1'] [H2 H2']; pose proof (good_nu _ _ HG) as Hnu; pose proof (good_f _ _ HG) as Hf.
  set (c := fun y => s2 + y * (s1 - s2)); set (c' := fun y => s2' + y * (s1' - s2')).
  assert (Hb : forall y, 0 <= y <= 1 -> both (c y) (c' y)) by (intros; split; apply mem_between; assumption).
  assert (Dc : forall y, derivable_pt_lim c y (s1 - s2) /\ derivable_pt_lim c' y (s1' - s2')).
  { intros y; split; [unfold c | unfold c']; derive_by fail; ring. }
  set (r := fun y => - (nu / 2) / bend M (ph (c y)) * (s1 - s2)).
  set (r' := fun y => - (nu / 2) / bend M (ph (c' y)) * (s1' - s2')).
  assert (Dt : forall y, 0 <= y <= 1 -> derivable_pt_lim (fun z => ph (c z)) y (r y) /\ derivable_pt_lim (fun z =>
    ph (c' z)) y (r' y) /\ E12 M (time j (ph (c y)) (ph (c' y))) <> 0).
  { intros y Hy; pose proof (Hb y Hy) as B; destruct (known _ _ B) as (P0 & _); destruct B as [B B'].
    destruct (Dc y) as [A A']; split; [|split; [|exact P0]]; apply D_phase; trivial; try apply HG.
    - exact (hit_lands _ _ _ _ (HI _ B)).
    - exact (hit_lands _ _ _ _ (HI' _ B')). }
  assert (E1 : c 1 = s1 /\ c' 1 = s1') by (unfold c, c'; lra).
  assert (E0 : c 0 = s2 /\ c' 0 = s2') by (unfold c, c'; lra).
  destruct E1 as [E1 E1'], E0 as [E0 E0']; unfold a, p; split.
  - destruct (MVT_cor2 (fun y => after M j (ph (c y)) (ph (c' y))) (fun y => after_slope M j (ph (c y)) (ph (c' y))
      (r y) (r' y)) 0 1 Rlt_0_1) as (y & E & Hy).
    { intros y Hy; destruct (Dt y Hy) as (A & A' & P0); apply (D_after M Hf j (fun y => ph (c y)) (fun y => ph (c' y)));
        trivial; lra. }
    cbn beta in E; rewrite E1, E1', E0, E0', Rminus_0_r, Rmult_1_r in E; rewrite E.
    destruct (known _ _ (Hb y ltac:(lra))) as (_ & _ & _ & X).
    destruct (X P (HP _ _ (Hb y ltac:(lra)))) as (b & b' & d & d' & Mb & Mb' & _ & _ & S).
    exists b, b'; split; [exact Mb|]; split; [exact Mb'|]; apply (S (s1 - s2) (s1' - s2')).
  - destruct (MVT_cor2 (fun y => before M j (ph (c y)) (ph (c' y))) (fun y => before_slope M j (ph (c y)) (ph (c' y))
      (r y) (r' y)) 0 1 Rlt_0_1) as (y & E & Hy).
    { intros y Hy; destruct (Dt y Hy) as (A & A' & P0);
        apply (D_before M Hf j (fun y => ph (c y)) (fun y => ph (c' y))); trivial; lra. }
    cbn beta in E; rewrite E1, E1', E0, E0', Rminus_0_r, Rmult_1_r in E; rewrite E.
    destruct (known _ _ (Hb y ltac:(lra))) as (_ & _ & _ & X).
    destruct (X P (HP _ _ (Hb y ltac:(lra)))) as (b & b' & d & d' & _ & _ & Md & Md' & S).
    exists d, d'; split; [exact Md|]; split; [exact Md'|]; apply (S (s1 - s2) (s1' - s2')).
Qed.
End Leg.

(** ** Stations and flights *)

(** An edge with the middle of its strengths. *)
Record stands (x : station) (c : R) : Prop := {
  stands_over : over (whole x); stands_in : mem (strength (whole x)) c; stands_centre : hits M w (centre x) c }.

Lemma station_stands N e S s : mem N nu -> mem S s -> in_window D (impactI D N S) = true ->
  stands (station_of D N e S) (IZR (middle S) / IZR one).
Proof.
  intros HN HS HW; assert (O : over (impactI D N S)).
  { intros u Hu; apply (impact_hits D M w kappa HD HG); trivial; apply (window_lands D M w kappa HD HG N S); trivial. }
  pose proof (mem_middle S s HS) as Hm; constructor; cbn [station_of whole centre strength impactI]; trivial.
  apply (impact_hits D M w kappa HD HG); trivial; [apply mem_at_point | exact (hit_lands _ _ _ _ (O _ Hm))].
Qed.

Section Flight.
Variables (j : BinNums.positive) (x y : station) (c c' : R).
Hypothesis Hx : stands x c.
Hypothesis Hy : stands y c'.
Let f := flight_of D j x y.
Hypothesis HL : holds f = true.
Let all := leg_between D j (whole x) (whole y).
Let mid := leg_between D j (centre x) (centre y).
Let a s s' := after M j (ph s) (ph s').
Let p s s' := before M j (ph s) (ph s').
Notation both := (both (whole x) (whole y)).

Lemma laws : lawful all = true /\ lawful mid = true. Proof. apply andb_prop, HL. Qed.
Lemma mem_apart z d s : stands z d -> mem (strength (whole z)) s -> mem (apart z) (s - d).
Proof. intros H Hs; apply mem_minus; [exact Hs | apply (hit_s _ _ _ _ (stands_centre _ _ H))]. Qed.
Lemma centres : both c c'. Proof. split; [apply (stands_in _ _ Hx) | apply (stands_in _ _ Hy)]. Qed.
Lemma mids : mem (first_at mid) (a c c') /\ mem (last_at mid) (p c c').
Proof.
  destruct (leg_between_known D M w kappa HD HG j _ _ _ _ (stands_centre _ _ Hx) (stands_centre _ _ Hy) (proj2 laws))
    as (_ & A & P & _); auto.
Qed.
Definition knows (ap : itv * itv) : Prop := forall s s', both s s' -> mem (fst ap) (a s s') /\ mem (snd ap) (p s
  s').
Lemma narrow_knows ap : knows ap -> knows (narrow all mid x y ap).
Proof.
  intros H s s' B; destruct (H _ _ B) as [HA HP]; destruct mids as [MA MP].
  destruct (leg_mean j _ _ (stands_over _ _ Hx) (stands_over _ _ Hy) (proj1 laws) (snd ap) s s' c c' (fun u u' Hu =>
    proj2 (H u u' Hu)) B centres) as [(b & b' & Mb & Mb' & E) (d & d' & Md & Md' & E')].
  fold (a s s') (a c c') in E; fold (p s s') (p c c') in E'; fold all in Mb, Mb', Md, Md'.
  pose proof (mem_apart x c s Hx (proj1 B)); pose proof (mem_apart y c' s' Hy (proj2 B)).
  unfold narrow; cbn [fst snd]; split; apply mem_meet; trivial; unfold moved.
  - replace (a s s') with (a c c' - (b * (s - c) + b' * (s' - c'))) by lra; encl.
  - replace (p s s') with (p c c' - (d * (s - c) + d' * (s' - c'))) by lra; encl.
Qed.
Lemma flight_knows : knows (all_a f, all_p f).
Proof.
  assert (K : knows (first_at all, last_at all)).
  { intros s s' B; destruct (known j _ _ (stands_over _ _ Hx) (stands_over _ _ Hy) (proj1 laws) s s' B)
      as (_ & A & P & _); auto. }
  intros s s' B; exact (narrow_knows _ (narrow_knows _ K) s s' B).
Qed.
Lemma flight_leg s s' : both s s' -> E12 M (time j (ph s) (ph s')) <> 0.
Proof. intros B; apply (known j _ _ (stands_over _ _ Hx) (stands_over _ _ Hy) (proj1 laws) s s' B). Qed.
Lemma flight_slopes s s' : both s s' -> exists b b' d d', mem (fst (fst (by_s f))) b /\ mem (snd (fst (by_s f))) b' /\
  mem (fst (snd (by_s f))) d /\ mem (snd (snd (by_s f))) d' /\ forall l l', let r := - (nu / 2) / bend M (ph s) * l
  in let r' := - (nu / 2) / bend M (ph s') * l' in after_slope M j (ph s) (ph s') r r' = - (b * l + b' * l') /\
  before_slope M j (ph s) (ph s') r r' = - (d * l + d' * l').
Proof.
  intros B; destruct (known j _ _ (stands_over _ _ Hx) (stands_over _ _ Hy) (proj1 laws) s s' B) as (_ & _ & _ & X).
  exact (X (all_p f) (proj2 (flight_knows s s' B))).
Qed.
Lemma flight_mean s1 s1' s2 s2' : both s1 s1' -> both s2 s2' -> (exists b b', mem (fst (fst (by_s f))) b /\
  mem (snd (fst (by_s f))) b' /\ a s1 s1' - a s2 s2' = - (b * (s1 - s2) + b' * (s1' - s2'))) /\
  (exists d d', mem (fst (snd (by_s f))) d /\ mem (snd (snd (by_s f))) d' /\ p s1 s1' - p s2 s2' =
  - (d * (s1 - s2) + d' * (s1' - s2'))).
Proof.
  apply (leg_mean j _ _ (stands_over _ _ Hx) (stands_over _ _ Hy) (proj1 laws) (all_p f)).
  intros s s' B; apply (flight_knows s s' B).
Qed.
End Flight.
End Legs.
