(** * The theorem of docs/ranges.md at one depth: along a path on which H0, E1 to E3 and H4 hold exactly one
  motion has its strengths in the ranges *)

From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import StatementOscillator StatementPaths PathsFlow PathsGaps PathsLegs Contraction Motions.
Open Scope R_scope.

(** The strength that the law of impact gives; Newton's step, of s after u and before v, between legs of j and
  k turns. *)
Definition law (M : Machine.t) w j k u s v : R :=
  sum_of (Machine.tau M) (after M k (phase M w s) (phase M w v)) (before M j (phase M w u) (phase M w s)).
Definition step (M : Machine.t) w j k m u s v : R := s - m * (s - law M w j k u s v).

(** How fast it moves, where u, s and v move so fast. *)
Definition step_rate (M : Machine.t) w j k m u s v lu ls lv : R :=
  let r x l := - (Machine.nu M / 2) / bend M (phase M w x) * l in
  (1 - m) * ls + m * sum_of (Machine.tau M) (after_slope M k (phase M w s) (phase M w v) (r s ls) (r v lv))
    (before_slope M j (phase M w u) (phase M w s) (r u lu) (r s ls)).
Lemma D_step M w j k m U S V y lu ls lv : good M w -> 0 < Machine.tau M -> derivable_pt_lim U y lu ->
  derivable_pt_lim S y ls -> derivable_pt_lim V y lv -> lands M w (U y) -> lands M w (S y) -> lands M w (V y) ->
  E12 M (time j (phase M w (U y)) (phase M w (S y))) <> 0 -> E12 M (time k (phase M w (S y)) (phase M w (V y))) <> 0 ->
  derivable_pt_lim (fun y => step M w j k m (U y) (S y) (V y)) y (step_rate M w j k m (U y) (S y) (V y) lu ls lv).
Proof.
  intros HG Ht DU DS DV LU LS LV EU EV; pose proof (good_nu _ _ HG) as Hnu; pose proof (good_f _ _ HG) as Hf.
  pose proof (D_phase M w (good_b _ _ HG) U y lu Hnu LU DU) as PU.
  pose proof (D_phase M w (good_b _ _ HG) S y ls Hnu LS DS) as PS.
  pose proof (D_phase M w (good_b _ _ HG) V y lv Hnu LV DV) as PV. assert (N : Machine.nu M <> 0) by lra.
  pose proof (D_after M Hf k _ _ y _ _ N PS PV EV) as DA; pose proof (D_before M Hf j _ _ y _ _ N PU PS EU) as DB.
  cbv beta in DA, DB; unfold step, law, sum_of, Rdiv.
  eapply D_value; [apply D_minus; [exact DS|]; apply D_scale, D_minus; [exact DS|]|].
  - eapply (D_ext (fun y => / (1 + Machine.tau M) * (2 * (after M k (phase M w (S y)) (phase M w (V y)) + Machine.tau M
      * before M j (phase M w (U y)) (phase M w (S y)))))); [|intros; ring | reflexivity].
    apply D_scale, D_scale, D_plus; [exact DA | apply D_scale, DB].
  - unfold step_rate, sum_of, Rdiv; cbv zeta; field; lra.
Qed.

(** Along a path: the turns of each leg; of each impact the range of s, the factor m and the weight. *)
Record contracting (M : Machine.t) (w kappa spread : R) (n : Z -> positive) (lo hi m wt : Z -> R) : Prop := {
  c_good : good M w; c_w : w <= PI; c_tau : 0 < Machine.tau M; c_kappa : 0 <= kappa < 1; c_spread : 0 <= spread;
  c_sizes : forall i, lo i <= hi i /\ 0 < wt i /\ m i <> 0 /\ hi i - lo i <= wt i * spread;
  (* H0 *)
  c_lands : forall s i, inside lo hi s -> lands M w (s i);
  c_legs : forall s i, inside lo hi s -> E12 M (time (n i) (phase M w (s i)) (phase M w (s (i + 1)%Z))) <> 0;
  (* E1 *)
  c_inside : forall s i, inside lo hi s ->
    lo i <= step M w (n (i - 1)%Z) (n i) (m i) (s (i - 1)%Z) (s i) (s (i + 1)%Z) <= hi i;
  (* E2 *)
  c_close : forall s s' d i, inside lo hi s -> inside lo hi s' -> 0 <= d ->
    (forall i, Rabs (s i - s' i) <= wt i * d) ->
    Rabs (step M w (n (i - 1)%Z) (n i) (m i) (s (i - 1)%Z) (s i) (s (i + 1)%Z) -
      step M w (n (i - 1)%Z) (n i) (m i) (s' (i - 1)%Z) (s' i) (s' (i + 1)%Z)) <= wt i * (kappa * d);
  (* E3 *)
  c_speed : forall s i, inside lo hi s -> sums M w n s i = s i -> befores M w n s (i - 1) < s i / 2;
  (* H4 *)
  c_gap : forall s i, inside lo hi s -> let a := afters M w n s i in let x := place M (phase M w (s i)) in
    let end_ := 2 * PI * IZR (Z.pos (n i)) + phase M w (s (i + 1)%Z) in s i / 2 <= a ->
    moved M (phase M w (s i)) x a end_ = place M (phase M w (s (i + 1)%Z)) ->
    moving M (phase M w (s i)) x a end_ <= s (i + 1)%Z / 2 ->
    forall t, phase M w (s i) < t < end_ -> 0 < gap M (phase M w (s i)) x a t }.

Section Path.
Variables (M : Machine.t) (w kappa spread : R) (n : Z -> positive) (lo hi m wt : Z -> R).
Hypothesis HC : contracting M w kappa spread n lo hi m wt.

Lemma law_sums s i : law M w (n (i - 1)%Z) (n i) (s (i - 1)%Z) (s i) (s (i + 1)%Z) = sums M w n s i.
Proof. unfold law, sums, afters, befores; rewrite (proj2 (previous i)); reflexivity. Qed.

Lemma solves s : inside lo hi s -> (forall i, sums M w n s i = s i) -> solution M w n s.
Proof.
  intros H E; constructor; [intros i; apply (c_lands _ _ _ _ _ _ _ _ _ HC), H | | exact E].
  intros i; apply (c_legs _ _ _ _ _ _ _ _ _ HC), H.
Qed.

Theorem one_solution : exists s, inside lo hi s /\ solution M w n s /\
  forall s', inside lo hi s' -> solution M w n s' -> forall i, s' i = s i.
Proof.
  destruct (one_fixed_point lo hi wt (fun s i => step M w (n (i - 1)%Z) (n i) (m i) (s (i - 1)%Z) (s i) (s (i + 1)%Z))
    kappa spread) as (s & Hs & HF & H1).
  - intros i; destruct (c_sizes _ _ _ _ _ _ _ _ _ HC i); lra.
  - intros i; apply (c_sizes _ _ _ _ _ _ _ _ _ HC i).
  - apply HC.
  - split; [apply HC | intros i; apply (c_sizes _ _ _ _ _ _ _ _ _ HC i)].
  - intros s Hs i; apply (c_inside _ _ _ _ _ _ _ _ _ HC); exact Hs.
  - intros d s s' Hd Hs Hs' E i; apply (c_close _ _ _ _ _ _ _ _ _ HC); assumption.
  - exists s; split; [exact Hs|]; split; [apply solves; [exact Hs|]|].
    + intros i; specialize (HF i); cbv beta in HF; unfold step in HF; rewrite law_sums in HF.
      destruct (c_sizes _ _ _ _ _ _ _ _ _ HC i) as (_ & _ & Hm & _). apply Rmult_eq_reg_l with (m i); [lra | exact Hm].
    + intros s' Hs' [_ _ E]; apply H1; [exact Hs'|]; intros i; unfold step; rewrite law_sums, E; lra.
Qed.

Variable N : Z -> Z.
Hypothesis HN : forall i, (N (i + 1) = N i + Z.pos (n i))%Z.

Lemma moves s : inside lo hi s -> solution M w n s ->
  machine_motion M w N (at_ M w N s) (leg_q M w n N s) (leg_v M w n N s).
Proof.
  intros H S; apply is_motion; try apply HC; trivial.
  - intros i; apply (c_speed _ _ _ _ _ _ _ _ _ HC); [exact H | apply (sums_at _ _ _ _ S)].
  - intros i; apply (c_gap _ _ _ _ _ _ _ _ _ HC s i H).
Qed.

(** A motion whose strengths are in the ranges is a solution. *)
Lemma motion_solves t q v : machine_motion M w N t q v -> (forall i, exists s, lo i <= s <= hi i /\
  g1 M (t i) = Machine.nu M * s / 2) -> inside lo hi (sums_of M t v) /\ solution M w n (sums_of M t v).
Proof.
  intros HM HS; pose proof (good_nu _ _ (c_good _ _ _ _ _ _ _ _ _ HC)) as Hnu.
  assert (I : inside lo hi (sums_of M t v)).
  { intros i; destruct (HS i) as (s & Hs & E).
    rewrite (strength_of M w N (c_good _ _ _ _ _ _ _ _ _ HC) (c_tau _ _ _ _ _ _ _ _ _ HC) t q v HM) in E.
    replace (sums_of M t v i) with s; [exact Hs|]; apply (Rmult_eq_reg_l (Machine.nu M)); lra. }
  split; [exact I|]; apply (is_solution M w n N) with (q := q); try apply HC; trivial.
  intros i; apply (c_legs _ _ _ _ _ _ _ _ _ HC), I.
Qed.
End Path.
