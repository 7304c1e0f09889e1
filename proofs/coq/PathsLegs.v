(** * What the integers of PathsCheck say of the wall, of impacts and of a leg: H0 to H2 *)

From Coq Require Import Reals QArith Qreals ZArith Lra Lia Bool List.
From Grazing Require Import StatementPaths ChaosInterval ChaosFunctions PathsCheck PathsFlow.
Open Scope R_scope.

Lemma mem_fraction q : mem (fraction q) (Q2R q). Proof. exact (mem_constant _ _). Qed.
Lemma mem_ranging X x : in_interval X x -> mem (ranging X) x.
Proof. intros H; exact (mem_join _ _ _ _ _ (mem_fraction _) (mem_fraction _) H). Qed.
Lemma mem_integer z : mem (constant z 1) (IZR z).
Proof. pose proof (mem_constant z 1) as H; unfold Rdiv in H; rewrite Rinv_1, Rmult_1_r in H; exact H. Qed.
Lemma mem_half : mem half (1 / 2). Proof. exact (mem_constant 1 2). Qed.
Lemma mem_quarter : mem quarter (1 / 4). Proof. exact (mem_constant 1 4). Qed.
Lemma mem_zero : mem zero 0. Proof. exact (mem_integer 0). Qed.
Lemma mem_turn_1 : mem turn_1 (2 * PI). Proof. exact (mem_double _ _ mem_pi). Qed.
Lemma mem_unit : mem unit 1. Proof. exact (mem_integer 1). Qed.
Lemma mem_scaled j X x : mem X x -> mem (scaled j X) (IZR (Z.pos j) * x).
Proof.
  destruct X as [[l h]|]; [|trivial]; cbn [mem scaled]; rewrite !mult_IZR, Rmult_assoc; intros H.
  assert (0 < IZR (Z.pos j)) by (apply IZR_lt; reflexivity); split; apply Rmult_le_compat_l; lra.
Qed.
Lemma mem_at_point z : mem (at_point z) (IZR z / IZR one). Proof. exact (mem_point z). Qed.
Lemma mem_hull X Y x y z : mem X x -> mem Y y -> Rmin x y <= z <= Rmax x y -> mem (hull X Y) z.
Proof.
  destruct X as [[a b]|], Y as [[c d]|]; cbn [hull]; trivial; intros Hx Hy Hz; apply ends in Hx, Hy.
  pose proof one_pos as H1; assert (E : forall z, IZR z / IZR one * IZR one = IZR z) by (intros; field; lra).
  assert (A : IZR (Z.min a c) <= IZR a /\ IZR (Z.min a c) <= IZR c) by (split; apply IZR_le; lia).
  assert (B : IZR b <= IZR (Z.max b d) /\ IZR d <= IZR (Z.max b d)) by (split; apply IZR_le; lia).
  assert (Hz' : Rmin x y * IZR one <= z * IZR one <= Rmax x y * IZR one) by (split; apply Rmult_le_compat_r; lra).
  destruct Hx as [X1 X2], Hy as [Y1 Y2].
  apply (Rmult_le_compat_r (IZR one)) in X1, X2, Y1, Y2; try lra; rewrite E in X1, X2, Y1, Y2.
  cbn [mem]; revert Hz'; unfold Rmin, Rmax; destruct Rle_dec; lra.
Qed.
Lemma mem_meet X Y x : mem X x -> mem Y x -> mem (meet X Y) x.
Proof.
  destruct X as [[a b]|], Y as [[c d]|]; cbn [meet mem]; trivial; intros H H'.
  split; [apply Z.max_case_strong | apply Z.min_case_strong]; intros _; lra.
Qed.
Lemma mem_nothing x : mem None x. Proof. exact I. Qed.
Lemma nothing_positive X : positive (minus X (size None)) = false.
Proof. destruct X as [[]|]; reflexivity. Qed.
Lemma mem_hull_left X Y x : mem X x -> mem (hull X Y) x.
Proof.
  destruct X as [[a b]|], Y as [[c d]|]; cbn [hull mem]; trivial; intros H.
  assert (IZR (Z.min a c) <= IZR a) by (apply IZR_le; lia); assert (IZR b <= IZR (Z.max b d)) by (apply IZR_le; lia);
    lra.
Qed.
Lemma mem_hull_right X Y x : mem Y x -> mem (hull X Y) x.
Proof.
  destruct X as [[a b]|], Y as [[c d]|]; cbn [hull mem]; trivial; intros H.
  assert (IZR (Z.min a c) <= IZR c) by (apply IZR_le; lia); assert (IZR d <= IZR (Z.max b d)) by (apply IZR_le; lia);
    lra.
Qed.
Lemma mem_hull_all L X x : In X L -> mem X x -> mem (hull_all L) x.
Proof.
  destruct L as [|Y L]; [intros []|]; cbn [hull_all]; induction L as [|Z L IH]; cbn [fold_right In]; intros HX Hx.
  - destruct HX as [->|[]]; exact Hx.
  - destruct HX as [->|[->|HX]]; [apply mem_hull_right, IH; cbn; auto | apply mem_hull_left, Hx | apply mem_hull_right,
      IH; cbn; auto].
Qed.

(** Membership by the form of an expression. *)
Global Opaque plus minus opp times inverse root size exponential cosine sine circle angle constant pi mem
  half unit
  quarter zero double scaled turn_1 fraction ranging.
Ltac encl := lazymatch goal with
  | |- mem (plus _ _) _ => apply mem_plus; encl
  | |- mem (minus _ _) _ => apply mem_minus; encl
  | |- mem (opp _) _ => apply mem_opp; encl
  | |- mem (times _ _) _ => apply mem_times; encl
  | |- mem (inverse _) _ => apply mem_inverse; encl
  | |- mem (root _) _ => apply mem_root; encl
  | |- mem (size _) _ => apply mem_size; encl
  | |- mem (exponential _) _ => apply mem_exponential; encl
  | |- mem (cosine _) _ => apply mem_cosine; encl
  | |- mem (sine _) _ => apply mem_sine; encl
  | |- mem (fraction _) _ => apply mem_fraction
  | |- mem (double _) _ => apply mem_double; encl
  | |- mem (scaled _ _) _ => apply mem_scaled; encl
  | |- mem quarter _ => apply mem_quarter
  | |- mem zero _ => apply mem_zero
  | |- mem half _ => apply mem_half
  | |- mem unit _ => apply mem_unit
  | |- mem pi _ => apply mem_pi
  | |- mem (constant _ _) (_ / _) => apply mem_constant
  | |- mem (constant _ _) _ => apply mem_integer
  | _ => assumption end.

(** Of an impact between legs m and n: the ends of s, and its weight. *)
Definition sum_of (tau a p : R) : R := 2 * (a + tau * p) * / (1 + tau).
Definition s_lo tau (m n : Letter.t) : R := sum_of tau (Q2R (fst (Letter.after n))) (Q2R (fst (Letter.before
  m))).
Definition s_hi tau (m n : Letter.t) : R := sum_of tau (Q2R (snd (Letter.after n))) (Q2R (snd (Letter.before
  m))).
Definition alpha (n : Letter.t) : R := Q2R (fst (Letter.weights n)).
Definition beta (n : Letter.t) : R := Q2R (snd (Letter.weights n)).
Definition weight tau (m n : Letter.t) : R := sum_of tau (alpha n) (beta m).

(** What a leg n between legs m and k from s to s' satisfies: H0, H1 and, with x, x' and y,
  y' for derivatives, H2. *)
Definition leg_holds (M : Machine.t) w kappa (m n k : Letter.t) s s' : Prop :=
  let nu := Machine.nu M in let tau := Machine.tau M in
  let t := phase M w s in let t' := phase M w s' in let j := Letter.periods n in
  lands M w s /\ lands M w s' /\ E12 M (time j t t') <> 0 /\
  in_interval (Letter.after n) (after M j t t') /\ in_interval (Letter.before n) (before M j t t') /\
  exists x x' y y',
  (forall l l', let r := - (nu / 2) / bend M t * l in let r' := - (nu / 2) / bend M t' * l' in
    after_slope M j t t' r r' = - (x * l + x' * l') /\ before_slope M j t t' r r' = - (y * l + y' * l')) /\
  Rabs x * weight tau m n + Rabs x' * weight tau n k <= kappa * alpha n /\
  Rabs y * weight tau m n + Rabs y' * weight tau n k <= kappa * beta n.

(** A machine in a cell, but for nu. *)
Record in_cell (D : cell) (M : Machine.t) (w kappa : R) : Prop := {
  in_C : mem (C D) (Machine.c M); in_K : mem (K D) (Machine.k M); in_T : mem (T D) (Machine.tau M);
  in_Sg : mem (Sg D) (Machine.sigma M); in_W : mem (W D) w; in_Ka : mem (Ka D) kappa;
  in_H : Forall2 (fun '(i, (A, B)) '(j, (a, b)) => i = j /\ mem A a /\ mem B b) (H D) (Machine.harmonics M) }.
(** What is true of it, and asked of the cell as a whole. *)
Record good (M : Machine.t) (w : R) : Prop := {
  good_nu : 0 < Machine.nu M; good_f : 0 < Machine.k M - Machine.c M * Machine.c M * (1 / 4); good_w : 0 < w;
  good_b : forall t, - w <= t <= w -> 0 < bend M t; good_g : g M 0 = 1 /\ g1 M 0 = 0 }.

Section Cell.
Variables (D : cell) (M : Machine.t) (w kappa : R).
Hypothesis HD : in_cell D M w kappa.
Notation nu := (Machine.nu M).
Notation tau := (Machine.tau M).

Lemma mem_sum A P a p : mem A a -> mem P p -> mem (sumI D A P) (sum_of tau a p).
Proof. intros; pose proof (in_T _ _ _ _ HD); unfold sumI, sum_of; encl. Qed.
Lemma mem_sI m n s : s_lo tau m n <= s <= s_hi tau m n -> mem (sI D m n) s.
Proof. intros Hs; unfold sI; refine (mem_join _ _ _ _ _ _ _ Hs); apply mem_sum; encl. Qed.
Lemma mem_all_sI ms m n s : In m ms -> mem (sI D m n) s -> mem (all_sI D ms n) s.
Proof. intros Hm; apply mem_hull_all, (in_map (fun m => sI D m n)), Hm. Qed.
Lemma mem_weightI m n : mem (weightI D m n) (weight tau m n). Proof. apply mem_sum; encl. Qed.
Lemma mem_turn n : mem (turn n) (2 * PI * IZR (Z.pos n)).
Proof. rewrite Rmult_comm; unfold turn; apply mem_scaled, mem_turn_1. Qed.
Lemma mem_turns z : (0 <= z)%Z -> mem (turns_on z) (2 * PI * IZR z).
Proof. destruct z as [|z|z]; [intros _; rewrite Rmult_0_r; apply mem_zero | intros _; apply mem_turn | lia].
  Qed.

(** ** The wall *)

Lemma mem_total fI f : (forall i A B a b, mem A a -> mem B b -> mem (fI (i, (A, B))) (f (i, (a, b)))) ->
  mem (totalI fI (H D)) (over_harmonics f (Machine.harmonics M)).
Proof.
  intros F; pose proof (in_H _ _ _ _ HD) as L.
  induction L as [|(i & A & B) (j & a & b) HI HR (<- & HA & HB) _ IH]; cbn [totalI over_harmonics]; [encl|].
  apply mem_plus; [apply F; assumption | exact IH].
Qed.
Lemma mem_times_of f f' A X a x : (forall Y y, mem Y y -> mem (f Y) (f' y)) -> mem A a -> mem X x ->
  mem (times_of f A X) (a * f' x).
Proof.
  intros F HA HX; unfold times_of; destruct (PathsCheck.none A) eqn:E; [|apply mem_times; auto].
  destruct A as [[[] []]|]; try discriminate.
  apply ends in HA; pose proof one_pos; unfold Rdiv in HA; rewrite !Rmult_0_l in HA.
  replace (a * f' x) with 0; [apply mem_zero|]; replace a with 0 by lra; ring.
Qed.
Ltac harmonics := apply mem_total; intros; repeat first [apply mem_plus | apply mem_minus |
  apply mem_times_of; [first [exact mem_cosine | exact mem_sine] | assumption|] | apply mem_scaled]; encl.
Lemma mem_gI X x : mem X x -> mem (gI D X) (g M x). Proof. intros; unfold gI, g; harmonics. Qed.
Lemma mem_g1I X x : mem X x -> mem (g1I D X) (g1 M x). Proof. intros; unfold g1I, g1; harmonics. Qed.
Lemma mem_bendI X x : mem X x -> mem (bendI D X) (bend M x).
Proof. intros; unfold bendI, bend; harmonics. Qed.

(** ** Impacts *)

Hypothesis HG : good M w.
Let Hb := good_b _ _ HG.
Let Hw := good_w _ _ HG.

Lemma off_phase off Y s a b : mem Y (nu * s * (1 / 2)) -> phase_off D off Y = Some (a, b) ->
  lies M w s (phase M w s) /\ IZR a / IZR one <= phase M w s <= IZR b / IZR one.
Proof.
  intros HY E; unfold phase_off in E; destruct Y as [[l h]|]; [|discriminate]; cbv zeta in E.
  set (a' := (newton D 3 h 0 - off)%Z) in E; set (b' := (newton D 3 l 0 + off)%Z) in E.
  destruct (below _ _ && _ && _ && _ && _) eqn:B; [|discriminate]; injection E as <- <-.
  rewrite !andb_true_iff in B; destruct B as [[[[B1 B2] B3] B4] B5]; pose proof (in_W _ _ _ _ HD) as HW.
  pose proof (below_le _ _ _ _ B1 (mem_opp _ _ HW) (mem_at_point a')) as A1.
  pose proof (below_le _ _ _ _ B2 (mem_at_point b') HW) as A2.
  pose proof (below_le _ _ _ _ B3 (mem_at_point a') (mem_at_point b')) as A3.
  pose proof (below_le _ _ _ _ B4 HY (mem_g1I _ _ (mem_at_point a'))) as A4.
  pose proof (below_le _ _ _ _ B5 (mem_g1I _ _ (mem_at_point b')) HY) as A5. apply (phase_between M w Hb); lra.
Qed.
Lemma mem_y N S s : mem N nu -> mem S s -> mem (times (times N S) half) (nu * s * (1 / 2)).
Proof. intros; encl. Qed.

(** What the computation finds is the phase; there is one if what it finds lies in the window. *)
Lemma found_phase N S s : mem N nu -> mem S s -> phaseI D N S <> None ->
  lies M w s (phase M w s) /\ mem (phaseI D N S) (phase M w s).
Proof.
  intros HN HS; pose proof (mem_y _ _ _ HN HS) as HY; unfold phaseI; cbv zeta; intros X.
  destruct (phase_off D (one / 1000000) (times (times N S) half)) as [[a b]|] eqn:E1;
    [|destruct (phase_off D (one / 100000) (times (times N S) half)) as [[a b]|] eqn:E2;
    [|destruct (phase_off D (one / 5000) (times (times N S) half)) as [[a b]|] eqn:E3; [|congruence]]];
    [destruct (off_phase _ _ _ _ _ HY E1) as [L B] | destruct (off_phase _ _ _ _ _ HY E2) as [L B] |
    destruct (off_phase _ _ _ _ _ HY E3) as [L B]];
    (split; [exact L|]; apply (mem_join _ _ _ _ _ (mem_at_point a) (mem_at_point b) B)).
Qed.
Lemma mem_phase_of N S s : mem N nu -> mem S s -> mem (phaseI D N S) (phase M w s).
Proof.
  intros HN HS; pose proof (found_phase N S s HN HS) as X; destruct (phaseI D N S) as [F|]; [|apply mem_nothing].
  apply X; discriminate.
Qed.
Lemma mem_phase N S s : mem N nu -> mem S s -> positive (minus (W D) (size (phaseI D N S))) = true ->
  lands M w s /\ mem (phaseI D N S) (phase M w s).
Proof.
  intros HN HS P; pose proof (found_phase N S s HN HS) as X.
  destruct (phaseI D N S) as [F|]; [|rewrite nothing_positive in P; discriminate].
  destruct (X ltac:(discriminate)) as [L HF]; split; [|exact HF].
  assert (0 < w - Rabs (phase M w s)); [|split; [lra | apply L]].
  pose proof (in_W _ _ _ _ HD); apply (positive_lt _ _ P); encl.
Qed.
Lemma mem_rateI N F t : mem N nu -> mem F t -> mem (rateI D N F) (nu * (1 / 2) * / bend M t).
Proof. intros HN HF; pose proof (mem_bendI _ _ HF); unfold rateI; encl. Qed.
Lemma mem_placeI N S F s : mem N nu -> mem S s -> mem F (phase M w s) -> lands M w s ->
  mem (placeI D N S F) (place M (phase M w s)).
Proof.
  intros HN HS HF L; pose proof (lands_lies M w s L) as [Ht E]; set (t := phase M w s) in *.
  destruct (drop M w Hb Hw (good_g _ _ HG) t Ht) as (x & Hx & Ex); rewrite E in Ex.
  assert (HB : mem (bendI D (hull (constant 0 1) F)) (bend M x)).
  { apply mem_bendI, (mem_hull _ _ 0 t); [encl | exact HF | exact Hx]. }
  assert (Px : 0 < bend M x) by (apply Hb; revert Hx; unfold Rmin, Rmax; destruct Rle_dec; lra).
  pose proof (good_nu _ _ HG) as Hnu; pose proof (in_Sg _ _ _ _ HD).
  pose proof (mem_gI _ _ HF); unfold placeI, place; apply mem_minus; [assumption|].
  apply mem_meet; [|unfold Rdiv; encl].
  replace ((1 - g M t) / nu) with (nu * (s * (1 / 2) * (s * (1 / 2))) * (1 / 2 * / bend M x)); [encl|].
  apply (Rmult_eq_reg_r (nu * (2 * bend M x))); [|nra].
  replace ((1 - g M t) / nu * (nu * (2 * bend M x))) with ((1 - g M t) * (2 * bend M x)) by (field; lra).
  rewrite Ex; field; lra.
Qed.

(** What is known of the impact with s. *)
Record hits (I : impact) (s : R) : Prop := {
  hit_lands : lands M w s; hit_s : mem (strength I) s; hit_phase : mem (phase_at I) (phase M w s);
  hit_place : mem (place_at I) (place M (phase M w s));
  hit_rate : mem (rate I) (nu * (1 / 2) * / bend M (phase M w s)) }.
Lemma impact_hits N S s : mem N nu -> mem S s -> lands M w s -> hits (impactI D N S) s.
Proof.
  intros HN HS L; pose proof (mem_phase_of N S s HN HS) as HF.
  constructor; cbn [impactI strength phase_at place_at rate]; auto using mem_placeI, mem_rateI.
Qed.
Lemma window_lands N S s : mem N nu -> mem S s -> in_window D (impactI D N S) = true -> lands M w s.
Proof. intros HN HS H; apply (mem_phase N S s HN HS H). Qed.

(** ** Legs *)

Lemma inside_within X A a : inside X A = true -> mem A a -> in_interval X a.
Proof.
  intros H HA; apply andb_prop in H; destruct H as [B B'].
  split; [exact (below_le _ _ _ _ B (mem_fraction _) HA) | exact (below_le _ _ _ _ B' HA (mem_fraction _))].
Qed.

(** By sin and cos. *)
Section Numbers.
Variables (c k om si co ex Q Q' : R).
Hypothesis Hom : om * om = k - c * c * (1 / 4).
Hypothesis Hsc : om * om * (si * si) + co * co = 1.
Hypothesis Hex : 0 < ex.
Hypothesis Hsi : si <> 0.
Let h := c * (1 / 2).
Let e11 := / ex * (co + h * si).
Let e12 := / ex * si.
Let e22 := / ex * (co - h * si).
Let a := ex * / si * Q' - (co * / si + h) * Q.

Lemma after_number : (Q' - e11 * Q) / e12 = a. Proof. unfold a, e11, e12, h; field; lra. Qed.
Lemma before_number : - k * e12 * Q + e22 * a = (co * / si - h) * Q' - / ex * / si * Q.
Proof.
  replace (/ ex * / si * Q) with (/ ex * / si * Q * (om * om * (si * si) + co * co)) by (rewrite Hsc; ring).
  rewrite Hom; unfold a, e12, e22, h; field; lra.
Qed.
End Numbers.

Lemma flow_numbers T : let om := frequency M in let si := / om * sin (om * T) in let co := cos (om * T) in let h :=
  Machine.c M * (1 / 2) in let ei := exp (- h * T) in om * om = Machine.k M - Machine.c M * Machine.c M * (1 / 4) /\
  om * om * (si * si) + co * co = 1 /\ E11 M T = ei * (co + h * si) /\ E12 M T = ei * si /\ E22 M T = ei * (co - h * si)
  /\ E21 M T = - Machine.k M * E12 M T.
Proof.
  intros om si co h ei; pose proof (frequency_pos M (good_f _ _ HG)) as Pom; fold om in Pom.
  assert (A : E12 M T = ei * si).
  { unfold E12, Flow.damped_S, ei, si, h, om; do 2 f_equal; field. }
  assert (B : E22 M T = ei * (co - h * si)).
  { unfold E22, Flow.damped_V; fold om; unfold ei, si, co, h.
    replace (- Machine.c M / 2 * T) with (- (Machine.c M * (1 / 2)) * T) by field; unfold Rdiv; ring. }
  split; [apply sqrt_sqrt; pose proof (good_f _ _ HG); lra|]; split;
    [|split; [|split; [exact A | split; [exact B | reflexivity]]]].
  - pose proof (sin2_cos2 (om * T)) as E; unfold Rsqr in E; rewrite <- E; unfold si, co; field; lra.
  - unfold E11, Flow.e11; rewrite A, B; unfold h; field.
Qed.
Lemma mem_frequency : mem (frequencyI D) (frequency M).
Proof. pose proof (in_C _ _ _ _ HD); pose proof (in_K _ _ _ _ HD); unfold frequencyI, frequency; encl. Qed.

(** H0 of a leg, its velocities, and with p in a range their derivatives. *)
Definition leg_known (x : leg) (j : BinNums.positive) (s s' : R) : Prop :=
  let t := phase M w s in let t' := phase M w s' in
  E12 M (time j t t') <> 0 /\ mem (first_at x) (after M j t t') /\ mem (last_at x) (before M j t t') /\
  forall P, mem P (before M j t t') -> exists b b' d d',
  mem (fst (fst (slopes x P))) b /\ mem (snd (fst (slopes x P))) b' /\
  mem (fst (snd (slopes x P))) d /\ mem (snd (snd (slopes x P))) d' /\
  forall l l', let r := - (nu / 2) / bend M t * l in let r' := - (nu / 2) / bend M t' * l' in
  after_slope M j t t' r r' = - (b * l + b' * l') /\ before_slope M j t t' r r' = - (d * l + d' * l').

Lemma leg_windows j I I' : lawful (leg_between D j I I') = true -> in_window D I = true /\ in_window D I' = true.
Proof. intros H; apply andb_prop in H; destruct H as [H _]; apply andb_prop in H; exact H. Qed.
Lemma leg_between_known j I I' s s' : hits I s -> hits I' s' -> lawful (leg_between D j I I') = true ->
  leg_known (leg_between D j I I') j s s'.
Proof.
  intros [L HS HF HQ HJ] [L' HS' HF' HQ' HJ'] H; unfold leg_known; cbv zeta.
  assert (Es : g1 M (phase M w s) / nu = s / 2) by (rewrite (proj2 L); pose proof (good_nu _ _ HG); field; lra).
  assert (Es' : g1 M (phase M w s') / nu = s' / 2) by (rewrite (proj2 L'); pose proof (good_nu _ _ HG); field; lra).
  assert (Pb : 0 < bend M (phase M w s)) by (apply Hb, (lands_lies M w s L)).
  assert (Pb' : 0 < bend M (phase M w s')) by (apply Hb, (lands_lies M w s' L')).
  unfold before_slope, after_slope; cbv zeta; rewrite Es, Es'; clear Es Es' L L'.
  unfold leg_between in *; cbv zeta in *. set (t := phase M w s) in *; set (t' := phase M w s') in *.
  destruct I as [S F IQ J], I' as [S' F' IQ' J']; cbn [strength phase_at place_at rate] in *.
  pose proof (mem_turn j) as Ht; assert (HT : mem (minus (plus (turn j) F') F) (time j t t')) by (unfold time; encl).
  set (LI := minus _ F) in *; clearbody LI; set (T := time j t t') in *; pose proof mem_frequency as Hom.
  pose proof (in_C _ _ _ _ HD) as HC; pose proof (in_K _ _ _ _ HD) as HK.
  destruct (flow_numbers T) as (Eom & Hsc & E_11 & E_12 & E_22 & E_21).
  destruct (mem_angle _ _ (mem_times _ _ _ _ Hom HT)) as [Hco Hsn].
  pose proof (mem_times _ _ _ _ (mem_inverse _ _ Hom) Hsn) as Hsi.
  assert (Hex : mem (exponential (times (times (C D) half) LI)) (exp (Machine.c M * (1 / 2) * T))) by encl.
  assert (Eei : exp (- (Machine.c M * (1 / 2)) * T) = / exp (Machine.c M * (1 / 2) * T)).
  { rewrite <- exp_Ropp; f_equal; ring. }
  rewrite Eei in *; pose proof (exp_pos (Machine.c M * (1 / 2) * T)) as Pex.
  unfold before, after; fold T; unfold leg_with in *; cbv zeta in *.
  cbn [lawful first_at last_at slopes strength phase_at place_at rate fst snd] in *.
  set (om := frequency M) in *; set (si := / om * sin (om * T)) in *; set (co := cos (om * T)) in *.
  set (ex := exp (Machine.c M * (1 / 2) * T)) in *.
  set (Isi := times (inverse (frequencyI D)) _) in *; set (Ico := fst _) in *; set (Iex := exponential _) in *.
  set (Q := place M t) in *; set (Q' := place M t') in *. clearbody Isi Ico Iex Q Q' si co ex T om.
  apply andb_prop in H; destruct H as [_ H0].
  assert (Nsi : si <> 0).
  { apply orb_prop in H0; destruct H0 as [H0|H0]; [apply positive_lt with (x := si) in H0 |
      apply positive_lt with (x := - si) in H0]; try lra; encl. }
  clear H0; rewrite E_21, E_11, E_12, E_22, (after_number (Machine.c M) si co ex Q Q' Pex Nsi).
  rewrite (before_number (Machine.c M) (Machine.k M) om si co ex Q Q' Eom Hsc Pex Nsi).
  set (h := Machine.c M * (1 / 2)) in *; assert (Hh : mem (times (C D) half) h) by (unfold h; encl).
  set (hI := times (C D) half) in *; clearbody h hI.
  assert (Ne : / ex * si <> 0).
  { apply Rmult_integral_contrapositive_currified; [apply Rinv_neq_0_compat; lra | exact Nsi]. }
  split; [exact Ne|]; split; [encl|]; split; [encl|].
  set (a := ex * / si * Q' - (co * / si + h) * Q); set (p := (co * / si - h) * Q' - / ex * / si * Q).
  intros IP HP; clearbody a p.
  assert (M11 : mem (times (inverse Iex) (plus Ico (times hI Isi))) (/ ex * (co + h * si))) by encl.
  assert (M12 : mem (times (inverse Iex) Isi) (/ ex * si)) by encl.
  assert (M22 : mem (times (inverse Iex) (minus Ico (times hI Isi))) (/ ex * (co - h * si))) by encl.
  assert (Mu : mem (times Iex (inverse Isi)) (/ (/ ex * si))).
  { replace (/ (/ ex * si)) with (ex * / si) by (field; lra); encl. }
  set (I11 := times _ (plus Ico _)) in *; set (I12 := times (inverse Iex) Isi) in *.
  set (I22 := times _ (minus Ico _)) in *; set (Iu := times Iex _) in *; clearbody I11 I12 I22 Iu.
  set (e11 := / ex * (co + h * si)) in *; set (e12 := / ex * si) in *; set (e22 := / ex * (co - h * si)) in *.
  clearbody e11 e12 e22. set (r := nu * (1 / 2) * / bend M t) in *; set (r' := nu * (1 / 2) * / bend M t') in *.
  set (acc := - Machine.c M * p - Machine.k M * Q').
  exists (r * ((p - e11 * (s * (1 / 2))) * / e12)), (r' * ((s' * (1 / 2) - p) * / e12)).
  exists (r * (e22 * ((p - e11 * (s * (1 / 2))) * / e12) - Machine.k M * (e12 * (s * (1 / 2))) - acc)).
  exists (r' * (e22 * ((s' * (1 / 2) - p) * / e12) + acc)); unfold acc.
  split; [encl|]; split; [encl|]; split; [encl|]; split; [encl|].
  intros l l'; unfold r, r'; split; field; repeat split; trivial; lra.
Qed.
Lemma leg_box_holds ms m n k s s' N S S' : In m ms -> mem N nu -> mem S s -> mem S' s' ->
  leg_box D ms n k N S S' = true -> leg_holds M w kappa m n k s s'.
Proof.
  intros Hm HN HS HS' H; unfold leg_box in H; cbv zeta in H.
  rewrite !andb_true_iff in H; destruct H as [[HL [H1 H1']] H2].
  apply (proj1 (forallb_forall _ _)) with (x := m) in H2; [|exact Hm]; cbv beta in H2.
  destruct (leg_windows _ _ _ HL) as [B B']. pose proof (impact_hits _ _ _ HN HS (window_lands _ _ _ HN HS B)) as HI.
  pose proof (impact_hits _ _ _ HN HS' (window_lands _ _ _ HN HS' B')) as HI'.
  destruct (leg_between_known _ _ _ _ _ HI HI' HL) as (P & HA & HP & HX).
  destruct (HX _ HP) as (x & x' & y & y' & Mx & Mx' & My & My' & E).
  split; [apply HI|]; split; [apply HI'|]; split; [exact P|].
  split; [exact (inside_within _ _ _ H1 HA)|]; split; [exact (inside_within _ _ _ H1' HP)|].
  unfold contracts in H2; cbv zeta in H2; apply andb_prop in H2; destruct H2 as [H2 H3].
  pose proof (mem_weightI m n) as Hmn; pose proof (mem_weightI n k) as Hnk; pose proof (in_Ka _ _ _ _ HD).
  exists x, x', y, y'; split; [exact E|]; unfold alpha, beta; split; [refine (below_le _ _ _ _ H2 _ _) |
    refine (below_le _ _ _ _ H3 _ _)]; encl.
Qed.
End Cell.

(** ** What is asked of a cell as a whole *)

Lemma rangings_mem R H : Forall2 (fun '(i, (A, B)) '(j, (a, b)) => i = j /\ in_interval A a /\ in_interval B b) R H ->
  Forall2 (fun '(i, (A, B)) '(j, (a, b)) => i = j /\ mem A a /\ mem B b) (rangings R) H.
Proof.
  intros HH; induction HH as [|(i & A & B) (j & a & b) H1 H2 (E & Ha & Hb) _ IH]; cbn; constructor; trivial.
  split; [exact E | split; apply mem_ranging; assumption].
Qed.
Lemma side_mem (b : bool) : mem (constant (if b then 1 else -1) 1) (if b then 1 else -1).
Proof. destruct b; apply mem_integer. Qed.
Lemma wall_facts D M w kappa : in_cell D M w kappa -> 0 < Machine.nu M -> g M 0 = 1 /\ g1 M 0 = 0 ->
  wall_ok D = true -> good M w /\ 0 < Machine.tau M /\ w <= PI.
Proof.
  intros HD Hnu Hg H; unfold wall_ok in H; rewrite !andb_true_iff in H; destruct H as [[[[A1 A2] A3] A4] A5].
  pose proof HD as [HCc HK HT HSg HW HKa HH].
  assert (P1 : 0 < Machine.k M - Machine.c M * Machine.c M * (1 / 4)) by (apply (positive_lt _ _ A1); encl).
  assert (P2 : 0 < w) by exact (positive_lt _ _ A3 HW).
  split; [constructor; trivial|split; [exact (positive_lt _ _ A2 HT) | exact (below_le _ _ _ _ A4 HW mem_pi)]].
  intros t Ht; destruct (cover_one _ _ _ t A5 (mem_join _ _ _ _ _ (mem_opp _ _ HW) HW Ht)) as (I & B & HI).
  exact (positive_lt _ _ B (mem_bendI D M w kappa HD _ _ HI)).
Qed.
