(** * The finite checks H0 to H4 in integers, and what they say about real numbers

    The boxes are those of the certificate `checker/tests/data/chaos-12.txt`;
      H0 to H4 are in docs/chaos.md. *)

From Coq Require Import Reals ZArith Lra Lia Bool List.
From Grazing Require Import ChaosInterval ChaosFunctions ChaosFlow.
Import ListNotations.
Open Scope R_scope.

(** ** The boxes of the letters 1 and 2, and the weights: numerators over 10000 *)

Definition a_lo (n : Z) : Z := if (n =? 1)%Z then 890 else 6150.
Definition a_hi (n : Z) : Z := if (n =? 1)%Z then 2440 else 10360.
Definition p_lo (n : Z) : Z := if (n =? 1)%Z then -1582 else -3670.
Definition p_hi (n : Z) : Z := if (n =? 1)%Z then -612 else -1400.
Definition alpha (n : Z) : Z := if (n =? 1)%Z then 2641 else 10000.
Definition beta (n : Z) : Z := if (n =? 1)%Z then 821 else 3104.
(** Of an impact between legs of m and n periods: s = a + p, and its weight. *)
Definition s_lo m n : Z := (a_lo n + p_lo m)%Z.
Definition s_hi m n : Z := (a_hi n + p_hi m)%Z.
Definition weight m n : Z := (alpha n + beta m)%Z.
Definition dec (z : Z) : R := IZR z / 10000.
Definition letter (n : Z) : Prop := n = 1%Z \/ n = 2%Z.
(** The contraction, 7/8. *)
Definition kappa : R := dec 8750.

Definition decimal (z : Z) : itv := constant z 10000.
Definition range (l h : Z) : itv := join (decimal l) (decimal h).

Lemma mem_decimal z : mem (decimal z) (dec z).
Proof. apply mem_constant. Qed.
Lemma mem_range l h x : dec l <= x <= dec h -> mem (range l h) x.
Proof. intros H; exact (mem_join _ _ _ _ _ (mem_decimal l) (mem_decimal h) H). Qed.
Lemma mem_integer z : mem (constant z 1) (IZR z).
Proof. pose proof (mem_constant z 1) as H; unfold Rdiv in H; rewrite Rinv_1, Rmult_1_r in H; exact H. Qed.

(** Membership by the form of an expression. *)
Global Opaque plus minus opp times inverse root size exponential cosine sine_small sine circle arcsine
  constant pi mem.
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
  | |- mem (arcsine _) _ => apply mem_arcsine; encl
  | |- mem (decimal _) _ => apply mem_decimal
  | |- mem pi _ => apply mem_pi
  | |- mem (constant _ _) (_ / _) => apply mem_constant
  | |- mem (constant _ _) _ => apply mem_integer
  | _ => assumption end.

(** ** An impact: phase, cosine, place *)

Definition phase nu s : R := - asin (nu * s * (1 / 2)).
Definition phaseI N S : itv := opp (arcsine (times (times N S) (constant 1 2))).
Definition cosI N S : itv :=
  let y := times (times N S) (constant 1 2) in root (minus (constant 1 1) (times y y)).
Definition placeI N S : itv := minus (constant 1 1)
  (times (times N (times (times S S) (constant 1 4))) (inverse (plus (constant 1 1) (cosI N S)))).

(** H0 in integers: |nu s/2| < 1. *)
Definition inside_circle N S : bool :=
  positive (minus (constant 1 1) (size (times (times N S) (constant 1 2)))).

Section Impact.
Variables (nu s : R).
Hypothesis Hnu : 0 < nu.
Hypothesis Hy : Rabs (nu * s * (1 / 2)) < 1.

Lemma sin_phase : - sin (phase nu s) / nu = s / 2.
Proof.
  unfold phase; apply Rabs_def2 in Hy; rewrite sin_neg, sin_asin by lra; field; lra.
Qed.

Lemma cos_phase : cos (phase nu s) = sqrt (1 - nu * s * (1 / 2) * (nu * s * (1 / 2))).
Proof. unfold phase; apply Rabs_def2 in Hy; rewrite cos_neg, cos_asin by lra; reflexivity. Qed.

Lemma cos_phase_pos : 0 < cos (phase nu s).
Proof.
  rewrite cos_phase; apply sqrt_lt_R0; apply Rabs_def2 in Hy; nra.
Qed.

Lemma place_phase : place nu (phase nu s) = 1 - nu * (s * s * (1 / 4)) * / (1 + cos (phase nu s)).
Proof.
  pose proof cos_phase_pos as Hc; unfold place.
  assert (E : (1 - cos (phase nu s)) * (1 + cos (phase nu s)) = nu * s * (1 / 2) * (nu * s * (1 / 2))).
  { rewrite cos_phase in *; set (w := 1 - nu * s * (1 / 2) * (nu * s * (1 / 2))).
    assert (Hw : 0 <= w) by (unfold w; apply Rabs_def2 in Hy; nra).
    pose proof (sqrt_sqrt w Hw); unfold w in *; lra. }
  set (c := cos _) in *; f_equal; apply (Rmult_eq_reg_r (nu * (1 + c))); [|nra].
  replace ((1 - c) / nu * (nu * (1 + c))) with ((1 - c) * (1 + c)) by (field; lra).
  rewrite E; field; lra.
Qed.

Variables N S : itv.
Hypothesis HN : mem N nu.
Hypothesis HS : mem S s.

Lemma mem_phaseI : mem (phaseI N S) (phase nu s).
Proof. unfold phaseI, phase; encl. Qed.

Lemma mem_cosI : mem (cosI N S) (cos (phase nu s)).
Proof. rewrite cos_phase; unfold cosI; cbv zeta; encl. Qed.

Lemma mem_placeI : mem (placeI N S) (place nu (phase nu s)).
Proof.
  rewrite place_phase; unfold placeI; pose proof mem_cosI; encl.
Qed.
End Impact.

(** ** H0 to H3 for a leg of n periods between legs of m and k *)

Definition turn (n : Z) : itv := times (times (constant 2 1) pi) (constant n 1).

Definition fits n (a p : itv) : bool :=
  below (decimal (a_lo n)) a && below a (decimal (a_hi n)) &&
  below (decimal (p_lo n)) p && below p (decimal (p_hi n)).
(** H2, t and t' being the derivatives of the phases without their sign. *)
Definition contracts m n k (S S' t t' e11 e12 e22 u p Q' : itv) : bool :=
  let h := constant 1 2 in
  let acc := minus (times (constant (-12) 49) p) (times (constant 100 2401) Q') in
  let b := times (minus p (times e11 (times S h))) u in
  let b' := times (minus (times S' h) p) u in
  let d := minus (minus (times e22 b) (times (constant 100 2401) (times e12 (times S h)))) acc in
  let d' := plus (times e22 b') acc in
  let w := decimal (weight m n) in let w' := decimal (weight n k) in
  below (plus (times (size (times t b)) w) (times (size (times t' b')) w'))
        (times (decimal 8750) (decimal (alpha n))) &&
  below (plus (times (size (times t d)) w) (times (size (times t' d')) w'))
        (times (decimal 8750) (decimal (beta n))).
Definition leg_with m n k (N S S' Q Q' t t' co si ex : itv) : bool :=
  let ei := inverse ex in let is := inverse si in
  let cot := times (constant 8 49) (times co is) in
  let u := times (constant 8 49) (times ex is) in
  let a := minus (times u Q') (times (plus cot (constant 6 49)) Q) in
  let p := minus (times (minus cot (constant 6 49)) Q') (times (times (constant 8 49) (times ei is)) Q) in
  let e11 := times ei (plus co (times (constant 3 4) si)) in
  let e12 := times ei (times (constant 49 8) si) in
  let e22 := times ei (minus co (times (constant 3 4) si)) in
  positive si && fits n a p && contracts m n k S S' t t' e11 e12 e22 u p Q'.
Definition leg_box m n k (N S S' : itv) : bool :=
  let T := minus (plus (turn n) (phaseI N S')) (phaseI N S) in
  let cs := circle (times (constant 8 49) T) in
  let t := times (times N (constant 1 2)) (inverse (cosI N S)) in
  let t' := times (times N (constant 1 2)) (inverse (cosI N S')) in
  inside_circle N S && inside_circle N S' &&
  leg_with m n k N S S' (placeI N S) (placeI N S') t t' (fst cs) (snd cs)
    (exponential (times (constant 6 49) T)).

(** All s, s' and nu at once, but for one triple, where the ranges of s and of nu are halved. *)
Definition leg_checked (x : Z * Z * Z) : bool := let '(m, n, k) := x in
  let parts := if ((m =? 2) && (n =? 1) && (k =? 2))%Z then 2%nat else 1%nat in
  cut (fun N => cut (fun S => leg_box m n k N S (range (s_lo n k) (s_hi n k))) parts (range (s_lo m n) (s_hi
    m n)))
    parts (range 0 10000).

Definition triples : list (Z * Z * Z) :=
  [(1, 1, 1); (1, 1, 2); (1, 2, 1); (1, 2, 2); (2, 1, 1); (2, 1, 2); (2, 2, 1); (2, 2, 2)]%Z.

Lemma legs_checked : forallb leg_checked triples = true.
Proof. vm_compute; reflexivity. Qed.

Lemma in_triples m n k : letter m -> letter n -> letter k -> In (m, n, k) triples.
Proof. intros [->| ->] [->| ->] [->| ->]; cbn; tauto. Qed.

(** What it says: H0, H1 and, with x, x' and y, y' for the derivatives, H2. *)
Definition leg_holds m n k nu s s' : Prop :=
  let t := phase nu s in let t' := phase nu s' in
  Rabs (nu * s * (1 / 2)) < 1 /\ Rabs (nu * s' * (1 / 2)) < 1 /\ 0 < E12 (time n t t') /\
  dec (a_lo n) <= after n nu t t' <= dec (a_hi n) /\
  dec (p_lo n) <= before n nu t t' <= dec (p_hi n) /\
  exists x x' y y',
  (forall l l', let r := - (nu / 2) / cos t * l in let r' := - (nu / 2) / cos t' * l' in
    after_slope n nu t t' r r' = - (x * l + x' * l') /\ before_slope n nu t t' r r' = - (y * l + y' * l')) /\
  Rabs x * dec (weight m n) + Rabs x' * dec (weight n k) <= kappa * dec (alpha n) /\
  Rabs y * dec (weight m n) + Rabs y' * dec (weight n k) <= kappa * dec (beta n).

Lemma leg_box_holds m n k nu s s' N S S' : 0 < nu -> mem N nu -> mem S s -> mem S' s' ->
  leg_box m n k N S S' = true -> leg_holds m n k nu s s'.
Proof.
  intros Hnu HN HS HS' H; unfold leg_box in H; cbv zeta in H.
  apply andb_prop in H; destruct H as [H HL]; apply andb_prop in H; destruct H as [C C'].
  assert (Hy : forall s S, mem S s -> inside_circle N S = true -> Rabs (nu * s * (1 / 2)) < 1).
  { intros r R HR B; pose proof (positive_lt _ (1 - Rabs (nu * r * (1 / 2))) B) as P.
    assert (0 < 1 - Rabs (nu * r * (1 / 2))) by (apply P; encl); lra. }
  pose proof (Hy _ _ HS C) as Ys; pose proof (Hy _ _ HS' C') as Ys'; clear C C' Hy.
  unfold leg_holds; cbv zeta; split; [exact Ys|]; split; [exact Ys'|].
  pose proof (mem_placeI nu s Hnu Ys _ _ HN HS) as HQ;
    pose proof (mem_placeI nu s' Hnu Ys' _ _ HN HS') as HQ'.
  pose proof (mem_cosI nu s Ys _ _ HN HS) as Hc; pose proof (mem_cosI nu s' Ys' _ _ HN HS') as Hc'.
  pose proof (mem_phaseI nu s _ _ HN HS) as Ht; pose proof (mem_phaseI nu s' _ _ HN HS') as Ht'.
  pose proof (cos_phase_pos nu s Ys) as Pc; pose proof (cos_phase_pos nu s' Ys') as Pc'.
  pose proof (sin_phase nu s Hnu Ys) as Es; pose proof (sin_phase nu s' Hnu Ys') as Es'.
  unfold before_slope, after_slope; cbv zeta; rewrite Es, Es'; clear Es Es'.
  set (t := phase nu s) in *; set (t' := phase nu s') in *.
  assert (HT : mem (minus (plus (turn n) (phaseI N S')) (phaseI N S)) (time n t t'))
    by (unfold time, turn; encl).
  set (T := time n t t') in *; set (TI := minus _ (phaseI N S)) in *.
  assert (Hth : mem (times (constant 8 49) TI) (8 / 49 * T)) by encl.
  destruct (mem_circle _ _ Hth) as [Hco Hsi].
  assert (Hex : mem (exponential (times (constant 6 49) TI)) (exp (6 / 49 * T))) by encl.
  assert (Htt : mem (times (times N (constant 1 2)) (inverse (cosI N S))) (nu * (1 / 2) * / cos t)) by encl.
  assert (Htt' : mem (times (times N (constant 1 2)) (inverse (cosI N S'))) (nu * (1 / 2) * / cos t'))
    by encl.
  unfold before, after; fold T.
  set (Q := place nu t) in *; set (Q' := place nu t') in *.
  set (si := sin (8 / 49 * T)) in *; set (co := cos (8 / 49 * T)) in *; set (ex := exp (6 / 49 * T)) in *.
  assert (Eei : exp (- (6 / 49) * T) = / ex).
  { unfold ex; rewrite <- exp_Ropp; f_equal; ring. }
  assert (Hsc : si * si + co * co = 1) by (unfold si, co; exact (sin2_cos2 (8 / 49 * T))).
  assert (Pex : 0 < ex) by apply exp_pos.
  assert (E_11 : E11 T = / ex * (co + 3 / 4 * si)) by (rewrite E11_is, Eei; reflexivity).
  assert (E_12 : E12 T = / ex * (49 / 8 * si)) by (unfold E12; rewrite Eei; reflexivity).
  assert (E_22 : E22 T = / ex * (co - 3 / 4 * si)) by (unfold E22; rewrite Eei; reflexivity).
  clearbody si co ex Q Q'; clear Eei.
  revert HL; generalize dependent (placeI N S); generalize dependent (placeI N S').
  generalize dependent (exponential (times (constant 6 49) TI)).
  generalize dependent (fst (circle (times (constant 8 49) TI))).
  generalize dependent (snd (circle (times (constant 8 49) TI))).
  generalize dependent (times (times N (constant 1 2)) (inverse (cosI N S))).
  generalize dependent (times (times N (constant 1 2)) (inverse (cosI N S'))).
  intros J' Htt' J Htt Isi Hsi Ico Hco Iex Hex IQ' HQ' IQ HQ HL.
  unfold leg_with in HL; cbv zeta in HL.
  apply andb_prop in HL; destruct HL as [HL H2]; apply andb_prop in HL; destruct HL as [H0 H1].
  apply positive_lt with (x := si) in H0; [|exact Hsi].
  set (a := 8 / 49 * (ex * / si) * Q' - (8 / 49 * (co * / si) + 6 / 49) * Q).
  set (p := (8 / 49 * (co * / si) - 6 / 49) * Q' - 8 / 49 * (/ ex * / si) * Q).
  match type of H1 with fits _ ?A ?P = _ =>
    assert (HA : mem A a) by (unfold a; encl); assert (HP : mem P p) by (unfold p; encl);
    set (IA := A) in *; set (IP := P) in * end.
  assert (Ea : (Q' - E11 T * Q) / E12 T = a) by (rewrite E_11, E_12; unfold a; field; lra).
  rewrite Ea.
  assert (Ep : E21 T * Q + E22 T * a = p).
  { unfold E21, Flow.e21, p; replace (8 / 49 * (/ ex * / si) * Q)
    with (8 / 49 * (/ ex * / si) * Q * (si * si + co * co))
      by (rewrite Hsc; ring); rewrite E_12, E_22; unfold a; field; lra. }
  rewrite Ep.
  assert (P12 : 0 < E12 T).
  { rewrite E_12; apply Rmult_lt_0_compat; [apply Rinv_0_lt_compat, Pex | lra]. }
  split; [exact P12|].
  unfold fits in H1; rewrite !andb_true_iff in H1; destruct H1 as [[[B1 B2] B3] B4].
  split; [split; [exact (below_le _ _ _ _ B1 (mem_decimal _) HA) | exact (below_le _ _ _ _ B2 HA
    (mem_decimal _))]|].
  split; [split; [exact (below_le _ _ _ _ B3 (mem_decimal _) HP) | exact (below_le _ _ _ _ B4 HP
    (mem_decimal _))]|].
  clear B1 B2 B3 B4 Ea Ep.
  assert (M11 : mem (times (inverse Iex) (plus Ico (times (constant 3 4) Isi))) (E11 T)) by (rewrite E_11;
    encl).
  assert (M12 : mem (times (inverse Iex) (times (constant 49 8) Isi)) (E12 T)) by (rewrite E_12; encl).
  assert (M22 : mem (times (inverse Iex) (minus Ico (times (constant 3 4) Isi))) (E22 T))
    by (rewrite E_22; encl).
  assert (Mu : mem (times (constant 8 49) (times Iex (inverse Isi))) (/ E12 T)).
  { replace (/ E12 T) with (8 / 49 * (ex * / si)) by (rewrite E_12; field; lra); encl. }
  clear E_11 E_12 E_22; revert H2 M11 M12 M22 Mu;
    generalize (times (constant 8 49) (times Iex (inverse Isi))).
  generalize (times (inverse Iex) (plus Ico (times (constant 3 4) Isi))).
  generalize (times (inverse Iex) (times (constant 49 8) Isi)).
  generalize (times (inverse Iex) (minus Ico (times (constant 3 4) Isi))).
  intros I22 I12 I11 Iu H2 M11 M12 M22 Mu; clearbody IA IP a p; unfold E21, Flow.e21.
  set (e11 := E11 T) in *; set (e12 := E12 T) in *; set (e22 := E22 T) in *; clearbody e11 e12 e22.
  unfold contracts in H2; cbv zeta in H2; apply andb_prop in H2; destruct H2 as [H2 H3].
  set (r := nu * (1 / 2) * / cos t) in *; set (r' := nu * (1 / 2) * / cos t') in *.
  set (acc := -12 / 49 * p - 100 / 2401 * Q').
  exists (r * ((p - e11 * (s * (1 / 2))) * / e12)), (r' * ((s' * (1 / 2) - p) * / e12)).
  exists (r * (e22 * ((p - e11 * (s * (1 / 2))) * / e12) - 100 / 2401 * (e12 * (s * (1 / 2))) - acc)).
  exists (r' * (e22 * ((s' * (1 / 2) - p) * / e12) + acc)).
  split; [|split].
  - intros l l'; unfold r, r', acc; split; field; lra.
  - refine (below_le _ _ _ _ H2 _ _); unfold kappa; encl.
  - refine (below_le _ _ _ _ H3 _ _); unfold kappa, acc; encl.
Qed.

Lemma leg_checks m n k nu s s' : letter m -> letter n -> letter k -> 0 < nu <= 1 ->
  dec (s_lo m n) <= s <= dec (s_hi m n) -> dec (s_lo n k) <= s' <= dec (s_hi n k) -> leg_holds m n k nu s s'.
Proof.
  intros Hm Hn Hk Hnu Hs Hs'.
  pose proof (proj1 (forallb_forall _ _) legs_checked _ (in_triples m n k Hm Hn Hk)) as H.
  unfold leg_checked in H; cbv zeta in H.
  assert (HN : mem (range 0 10000) nu) by (apply mem_range; unfold dec; lra).
  destruct (cut_one _ _ _ _ H HN) as (N & H1 & HN'); clear H.
  destruct (cut_one _ _ _ _ H1 (mem_range _ _ _ Hs)) as (S & H2 & HS'); clear H1.
  apply (leg_box_holds m n k nu s s' N S (range (s_lo n k) (s_hi n k))); trivial; [lra|].
  apply mem_range, Hs'.
Qed.

(** ** H4: the gap 1 - cos t + nu (x - 1) on a leg of n periods after one of m, the place x being moved from
  Q *)

Definition flightI (Q A tau : itv) : itv * itv :=
  let ei := exponential (times (constant (-6) 49) tau) in
  let th := times (constant 8 49) tau in let co := cosine th in let si := sine th in
  let e12 := times ei (times (constant 49 8) si) in
  (plus (times (times ei (plus co (times (constant 3 4) si))) Q) (times e12 A),
   minus (times (times ei (minus co (times (constant 3 4) si))) A) (times (constant 100 2401) (times e12 Q))).
Definition convex_piece N Q A phi (t : itv) : bool :=
  let x := flightI Q A (minus t phi) in
  positive (plus (cosine t) (times N (minus (times (constant (-12) 49) (snd x)) (times (constant 100 2401)
    (fst x))))).
Definition open_piece N Q A phi (t : itv) : bool :=
  let x := minus (fst (flightI Q A (minus t phi))) (constant 1 1) in
  positive x || positive (plus (minus (constant 1 1) (cosine t)) (times N x)).
Definition gap_checked (x : Z * Z) : bool := let '(m, n) := x in
  let N := range 0 10000 in let S := range (s_lo m n) (s_hi m n) in let A := range (a_lo n) (a_hi n) in
  let phi := phaseI N S in let Q := placeI N S in
  let from := constant 1 1 in let till := minus (turn n) (constant 1 1) in
  inside_circle N S && below phi (constant 3 20) &&
  cut (convex_piece N Q A phi) 2 (join phi from) && cut (open_piece N Q A phi) 8 (join from till) &&
  cut (convex_piece N Q A phi) 2 (join till (plus (turn n) (constant 3 20))).

Definition pairs : list (Z * Z) := [(1, 1); (1, 2); (2, 1); (2, 2)]%Z.

Lemma gaps_checked : forallb gap_checked pairs = true.
Proof. vm_compute; reflexivity. Qed.

Lemma mem_flight I A J q a tau : mem I q -> mem A a -> mem J tau ->
  mem (fst (flightI I A J)) (E11 tau * q + E12 tau * a) /\
    mem (snd (flightI I A J)) (E21 tau * q + E22 tau * a).
Proof.
  intros HI HA HJ; unfold flightI; cbv zeta; cbn [fst snd].
  assert (HE : mem (exponential (times (constant (-6) 49) J)) (exp (- (6 / 49) * tau))).
  { replace (- (6 / 49) * tau) with (-6 / 49 * tau) by field; encl. }
  replace (E21 tau * q + E22 tau * a) with (E22 tau * a - 100 / 2401 * (E12 tau * q)) by (unfold E21, Flow.e21; ring).
  rewrite E11_is; unfold E12, E22; revert HE; generalize (exp (- (6 / 49) * tau)) (exponential (times (constant (-6)
    49) J)).
  intros e IE HE; split; encl.
Qed.

Definition bend nu phi q a t : R :=
  cos t + nu * (-12 / 49 * moving phi q a t - 100 / 2401 * moved phi q a t).
Definition gap nu phi q a t : R := 1 - cos t + nu * (moved phi q a t - 1).

Lemma gap_checks m n nu s a : letter m -> letter n -> 0 < nu <= 1 ->
  dec (s_lo m n) <= s <= dec (s_hi m n) -> dec (a_lo n) <= a <= dec (a_hi n) ->
  let phi := phase nu s in let q := place nu phi in let end_ := 2 * PI * IZR n in
  phi <= 3 / 20 /\
  (forall t, phi <= t <= 1 -> 0 < bend nu phi q a t) /\
  (forall t, 1 <= t <= end_ - 1 -> 0 < gap nu phi q a t) /\
  (forall t, end_ - 1 <= t <= end_ + 3 / 20 -> 0 < bend nu phi q a t).
Proof.
  intros Hm Hn Hnu Hs Ha phi q end_.
  assert (H : In (m, n) pairs) by (destruct Hm as [->| ->], Hn as [->| ->]; cbn; tauto).
  apply (proj1 (forallb_forall _ _) gaps_checked) in H; unfold gap_checked in H; cbv zeta in H.
  set (N := range 0 10000) in H; set (S := range _ _) in H; set (A := range (a_lo n) _) in H.
  set (PH := phaseI N S) in H; set (Q := placeI N S) in H.
  assert (HN : mem N nu) by (apply mem_range; unfold dec; lra).
  assert (HS : mem S s) by exact (mem_range _ _ _ Hs).
  assert (HA : mem A a) by exact (mem_range _ _ _ Ha).
  rewrite !andb_true_iff in H; destruct H as [[[[C0 C1] C2] C3] C4].
  assert (Hy : Rabs (nu * s * (1 / 2)) < 1).
  { assert (0 < 1 - Rabs (nu * s * (1 / 2))) by (apply (positive_lt _ _ C0); encl); lra. }
  pose proof (mem_phaseI nu s N S HN HS : mem PH phi) as HP.
  pose proof (mem_placeI nu s (proj1 Hnu) Hy N S HN HS : mem Q q) as HQ.
  clearbody N S A PH Q q.
  assert (HX : forall t I, mem I t -> mem (fst (flightI Q A (minus I PH))) (moved phi q a t) /\
    mem (snd (flightI Q A (minus I PH))) (moving phi q a t)).
  { intros t I HI; apply mem_flight; encl. }
  assert (HB : forall t I, mem I t -> convex_piece N Q A PH I = true -> 0 < bend nu phi q a t).
  { intros t I HI B; apply (positive_lt _ _ B); destruct (HX t I HI); unfold bend; encl. }
  assert (HG : forall t I, mem I t -> open_piece N Q A PH I = true -> 0 < gap nu phi q a t).
  { intros t I HI B; destruct (HX t I HI) as [HM _]; unfold open_piece in B; cbv zeta in B; unfold gap.
    assert (HM1 : mem (minus (fst (flightI Q A (minus I PH))) (constant 1 1)) (moved phi q a t - 1)) by encl.
    apply orb_prop in B; destruct B as [B|B].
    - apply positive_lt with (x := moved phi q a t - 1) in B; [|exact HM1].
      pose proof (COS_bound t); nra.
    - apply (positive_lt _ _ B); encl. }
  assert (HT : mem (turn n) end_) by (unfold turn, end_; encl).
  assert (H1 : mem (constant 1 1) 1) by encl.
  assert (HT' : mem (minus (turn n) (constant 1 1)) (end_ - 1)) by encl.
  assert (HT2 : mem (plus (turn n) (constant 3 20)) (end_ + 3 / 20)) by encl.
  split; [|split; [|split]].
  - apply (below_le _ _ _ _ C1 HP); encl.
  - intros t Ht; destruct (cut_one _ _ _ t C2 (mem_join _ _ _ _ _ HP H1 Ht)) as (I & B & HI).
    exact (HB t I HI B).
  - intros t Ht; destruct (cut_one _ _ _ t C3 (mem_join _ _ _ _ _ H1 HT' Ht)) as (I & B & HI).
    exact (HG t I HI B).
  - intros t Ht; destruct (cut_one _ _ _ t C4 (mem_join _ _ _ _ _ HT' HT2 Ht)) as (I & B & HI).
    exact (HB t I HI B).
Qed.
