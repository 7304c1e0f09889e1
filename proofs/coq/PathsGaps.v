(** * A leg contracts (H2), and the gap is positive on it (H4), from the checks *)

From Coq Require Import Reals QArith Qreals ZArith Lra Lia Bool List.
From Grazing Require Import StatementPaths ChaosInterval ChaosFunctions PathsCheck PathsFlow PathsLegs.
Open Scope R_scope.

(** ** A leg depends on s and s' with the bounds of H2 *)

Lemma between x a b c d : c <= a <= d -> c <= b <= d -> 0 <= x <= 1 -> c <= b + x * (a - b) <= d.
Proof. intros; split; nra. Qed.
Lemma sum_bound x x' l l' w w' d B : Rabs l <= w * d -> Rabs l' <= w' * d -> 0 <= d ->
  Rabs x * w + Rabs x' * w' <= B -> Rabs (- (x * l + x' * l')) <= B * d.
Proof.
  intros Hl Hl' Hd HB; rewrite Rabs_Ropp; apply (Rle_trans _ _ _ (Rabs_triang _ _)).
  rewrite !Rabs_mult; pose proof (Rabs_pos x); pose proof (Rabs_pos x').
  apply (Rle_trans _ (Rabs x * (w * d) + Rabs x' * (w' * d))); nra.
Qed.

Section Lipschitz.
Variables (M : Machine.t) (w kappa : R) (m n k : Letter.t).
Notation nu := (Machine.nu M).
Notation tau := (Machine.tau M).
Notation ph := (phase M w).
Notation j := (Letter.periods n).
Hypothesis HG : good M w.
Hypothesis HL : forall s s', s_lo tau m n <= s <= s_hi tau m n -> s_lo tau n k <= s' <= s_hi tau n k ->
  leg_holds M w kappa m n k s s'.

Lemma leg_lipschitz s1 s1' s2 s2' d : s_lo tau m n <= s1 <= s_hi tau m n -> s_lo tau m n <= s2 <= s_hi tau m n ->
  s_lo tau n k <= s1' <= s_hi tau n k -> s_lo tau n k <= s2' <= s_hi tau n k -> 0 <= d -> Rabs (s1 - s2) <= weight tau m
  n * d -> Rabs (s1' - s2') <= weight tau n k * d -> Rabs (after M j (ph s1) (ph s1') - after M j (ph s2) (ph s2'))
  <= kappa * alpha n * d /\ Rabs (before M j (ph s1) (ph s1') - before M j (ph s2) (ph s2')) <= kappa * beta n * d.
Proof.
  intros H1 H2 H1' H2' Hd Hl Hl'; pose proof (good_nu _ _ HG) as Hnu.
  set (c := fun x => s2 + x * (s1 - s2)); set (c' := fun x => s2' + x * (s1' - s2')).
  assert (Hleg : forall x, 0 <= x <= 1 -> leg_holds M w kappa m n k (c x) (c' x)).
  { intros x Hx; apply HL; apply between; assumption. }
  assert (Dc : forall x, derivable_pt_lim c x (s1 - s2) /\ derivable_pt_lim c' x (s1' - s2')).
  { intros x; split; [unfold c | unfold c']; derive_by fail; ring. }
  set (r := fun x => - (nu / 2) / bend M (ph (c x)) * (s1 - s2)).
  set (r' := fun x => - (nu / 2) / bend M (ph (c' x)) * (s1' - s2')).
  assert (Dt : forall x, 0 <= x <= 1 -> derivable_pt_lim (fun y => ph (c y)) x (r x) /\ derivable_pt_lim (fun y =>
    ph (c' y)) x (r' x) /\ E12 M (time j (ph (c x)) (ph (c' x))) <> 0).
  { intros x Hx; destruct (Hleg x Hx) as (L & L' & P & _); destruct (Dc x) as [A A'].
    split; [|split; [|exact P]]; apply D_phase; trivial; apply HG. }
  assert (E1 : c 1 = s1 /\ c' 1 = s1') by (unfold c, c'; lra).
  assert (E0 : c 0 = s2 /\ c' 0 = s2') by (unfold c, c'; lra).
  destruct E1 as [E1 E1'], E0 as [E0 E0']; pose proof (good_f _ _ HG) as Hf; split.
  - destruct (MVT_cor2 (fun x => after M j (ph (c x)) (ph (c' x))) (fun x => after_slope M j (ph (c x)) (ph (c' x))
      (r x) (r' x)) 0 1 Rlt_0_1) as (x & E & Hx).
    { intros x Hx; destruct (Dt x Hx) as (A & A' & P); apply (D_after M Hf j (fun y => ph (c y)) (fun y => ph (c' y)));
        trivial; lra. }
    cbn beta in E; rewrite E1, E1', E0, E0', Rminus_0_r, Rmult_1_r in E; rewrite E.
    destruct (Hleg x ltac:(lra)) as (_ & _ & _ & _ & _ & x1 & x1' & y1 & y1' & S & B & _).
    unfold r, r'; destruct (S (s1 - s2) (s1' - s2')) as [-> _]. apply (sum_bound _ _ _ _ _ _ _ _ Hl Hl' Hd B).
  - destruct (MVT_cor2 (fun x => before M j (ph (c x)) (ph (c' x))) (fun x => before_slope M j (ph (c x)) (ph (c' x))
      (r x) (r' x)) 0 1 Rlt_0_1) as (x & E & Hx).
    { intros x Hx; destruct (Dt x Hx) as (A & A' & P); apply (D_before M Hf j (fun y => ph (c y)) (fun y => ph (c' y)));
        trivial; lra. }
    cbn beta in E; rewrite E1, E1', E0, E0', Rminus_0_r, Rmult_1_r in E; rewrite E.
    destruct (Hleg x ltac:(lra)) as (_ & _ & _ & _ & _ & x1 & x1' & y1 & y1' & S & _ & B).
    unfold r, r'; destruct (S (s1 - s2) (s1' - s2')) as [_ ->]. apply (sum_bound _ _ _ _ _ _ _ _ Hl Hl' Hd B).
Qed.
End Lipschitz.

(** ** The gap is positive between impacts *)

Definition gap (M : Machine.t) phi q a t : R :=
  1 - g M t + Machine.nu M * (moved M phi q a t - Machine.sigma M).
Definition gap_bend (M : Machine.t) phi q a t : R :=
  bend M t + Machine.nu M * (- Machine.c M * moving M phi q a t - Machine.k M * moved M phi q a t).

Lemma D_gap M phi q a t : 0 < Machine.k M - Machine.c M * Machine.c M * (1 / 4) ->
  derivable_pt_lim (gap M phi q a) t (- g1 M t + Machine.nu M * moving M phi q a t) /\
  derivable_pt_lim (fun t => - g1 M t + Machine.nu M * moving M phi q a t) t (gap_bend M phi q a t).
Proof.
  intros Hf; destruct (moved_free M Hf phi q a t) as [H1 H2]; split.
  - unfold gap; derive_by ltac:(first [exact H1 | apply D_g]); ring.
  - eapply D_value; [apply D_plus; [eapply (D_ext (fun y => -1 * g1 M y)); [apply D_scale, D_g1 | intros; ring |
      reflexivity] | apply D_scale, H2]|]; unfold gap_bend; ring.
Qed.
Lemma windows_all f n z : windows f n z = true -> forall i, (z <= i < z + Z.of_nat n)%Z -> f i = true.
Proof.
  revert z; induction n as [|n IH]; intros z H i Hi; [lia|]; cbn [windows] in H; apply andb_prop in H;
    destruct H as [A B].
  destruct (Z.eq_dec i z) as [->|Ne]; [exact A | apply (IH _ B); lia].
Qed.

(** The turn whose window a time is in, or has left. *)
Lemma last_turn w t : exists j, 2 * PI * IZR j - w <= t < 2 * PI * IZR (j + 1) - w.
Proof.
  pose proof PI_RGT_0; destruct (archimed ((t + w) / (2 * PI))) as [A B];
    exists (Rdefinitions.up ((t + w) / (2 * PI)) - 1)%Z.
  replace (Rdefinitions.up ((t + w) / (2 * PI)) - 1 + 1)%Z with (Rdefinitions.up ((t + w) / (2 * PI))) by lia;
    rewrite minus_IZR.
  set (u := IZR (Rdefinitions.up _)) in *; set (x := (t + w) / (2 * PI)) in *.
  assert (E : t + w = 2 * PI * x) by (unfold x; field; lra); split; nra.
Qed.

Section Gap.
Variables (D : cell) (M : Machine.t) (w kappa : R) (j : BinNums.positive) (N A T1 T2 F' : itv) (I : impact)
  (ends : list itv).
Variables (s s' a t1 t2 : R).
Hypothesis HD : in_cell D M w kappa.
Hypothesis HG : good M w.
Hypothesis Hw : w <= PI.
Notation nu := (Machine.nu M).
Let phi := phase M w s.
Let phi' := phase M w s'.
Let x := place M phi.
Let last := 2 * PI * IZR (Z.pos j) + phi'.
Hypothesis HN : mem N nu.
Hypothesis HI : hits M w I s.
Hypothesis HF' : lands M w s' /\ mem F' phi' /\ In F' ends.
Hypothesis HA : mem A a.
Hypothesis HT1 : mem T1 t1 /\ t1 <= w.
Hypothesis HT2 : mem T2 t2 /\ t2 <= w.
Hypothesis HB : gap_box D j N I A T1 T2 ends = true.
Hypothesis Hv : s / 2 <= a.
Hypothesis Hx : moved M phi x a last = place M phi'.
Hypothesis Hv' : moving M phi x a last <= s' / 2.

Lemma mem_flight Q B q b J tau : mem Q q -> mem B b -> mem J tau -> mem (fst (flightI D Q B J))
  (E11 M tau * q + E12 M tau * b) /\ mem (snd (flightI D Q B J)) (E21 M tau * q + E22 M tau * b).
Proof.
  intros HQ Hb HJ; unfold flightI; cbv zeta; cbn [fst snd].
  destruct (flow_numbers M w HG tau) as (_ & _ & -> & E_12 & -> & ->); rewrite E_12.
  pose proof (mem_frequency D M w kappa HD); pose proof (in_C _ _ _ _ HD); pose proof (in_K _ _ _ _ HD).
  split; [|match goal with |- mem (minus ?I (times ?K ?J)) (- ?k * ?e * q + ?y) => replace (- k * e * q + y)
    with (y - k * (e * q)) by ring end]; encl.
Qed.

Let F := phase_at I.
Let Q := place_at I.
Lemma mem_flown t T : mem T t -> mem (fst (flightI D Q A (minus T F))) (moved M phi x a t) /\
  mem (snd (flightI D Q A (minus T F))) (moving M phi x a t).
Proof.
  intros HT; pose proof (hit_phase _ _ _ _ HI); pose proof (hit_place _ _ _ _ HI).
  apply mem_flight; [assumption | exact HA | apply mem_minus; assumption].
Qed.
Lemma convex_at t T : mem T t -> convex_piece D N Q A F T = true -> 0 < gap_bend M phi x a t.
Proof.
  intros HT B; apply (positive_lt _ _ B); destruct (mem_flown t T HT).
  pose proof (in_C _ _ _ _ HD); pose proof (in_K _ _ _ _ HD).
  pose proof (mem_bendI _ _ _ _ HD _ _ HT); unfold gap_bend; encl.
Qed.
Lemma open_at t T : mem T t -> open_piece D N Q A F T = true -> 0 < gap M phi x a t.
Proof.
  intros HT B; apply (positive_lt _ _ B); destruct (mem_flown t T HT) as [HM _].
  pose proof (mem_gI _ _ _ _ HD _ _ HT); pose proof (in_Sg _ _ _ _ HD); unfold gap; encl.
Qed.
(** In a window the wall is below its top. *)
Lemma high_at t T z : mem T t -> - w <= t - 2 * PI * IZR z <= w -> high_piece D Q A F T = true -> 0 < gap M phi x a t.
Proof.
  intros HT Ht B; destruct (mem_flown t T HT) as [HM _]; pose proof (in_Sg _ _ _ _ HD).
  assert (P : 0 < moved M phi x a t - Machine.sigma M) by (apply (positive_lt _ _ B); encl).
  pose proof (below_top M w (good_b _ _ HG) (good_w _ _ HG) (good_g _ _ HG) _ Ht) as G.
  rewrite <- (proj1 (g_turned M z _)) in G; replace (2 * PI * IZR z + (t - 2 * PI * IZR z)) with t in G by ring.
  pose proof (good_nu _ _ HG); unfold gap; nra.
Qed.
Lemma near_ends t : phi < t < last -> t <= t1 \/ 2 * PI * IZR (Z.pos j) - t2 <= t -> 0 < gap M phi x a t.
Proof.
  intros Ht E; pose proof (good_f _ _ HG) as Hf; pose proof (good_nu _ _ HG) as Hnu.
  destruct HT1 as [M1 _], HT2 as [M2 _], HF' as ([L' E'] & HP' & In'), (hit_lands _ _ _ _ HI) as [L E0].
  fold phi in L, E0; fold phi' in L', E'.
  assert (D1 : forall t, derivable_pt_lim (gap M phi x a) t (- g1 M t + nu * moving M phi x a t)) by (intros;
    apply (D_gap _ _ _ _ _ Hf)).
  assert (D2 : forall t, derivable_pt_lim (fun t => - g1 M t + nu * moving M phi x a t) t (gap_bend M phi x a t))
    by (intros; apply (D_gap _ _ _ _ _ Hf)).
  pose proof HB as B; unfold gap_box in B; cbv zeta in B; rewrite !andb_true_iff in B; destruct B as [[[C1 C2] _] _];
    destruct E as [E|E].
  - destruct (moved_start M Hf phi x a) as [M0 MV]. apply (convex_right _ _ _ D1 D2 phi t1); [right | | | lra].
    + unfold gap; rewrite M0; unfold x, place; field; lra.
    + rewrite MV, E0; nra.
    + intros y Hy; destruct (cover_one _ _ _ y C1 (mem_join _ _ _ _ _ (hit_phase _ _ _ _ HI) M1 Hy)) as (J & B & HJ).
      exact (convex_at y J HJ B).
  - assert (EL : g M last = g M phi' /\ g1 M last = g1 M phi') by apply g_turned; destruct EL as [EL EL'].
    apply (convex_left _ _ _ D1 D2 (2 * PI * IZR (Z.pos j) - t2) last); [right | | | lra].
    + unfold gap; rewrite Hx, EL; unfold place; field; lra.
    + rewrite EL', E'; nra.
    + intros y Hy; apply (proj1 (forallb_forall _ _)) with (x := F') in C2; [|exact In'].
      pose proof (mem_turns (Z.pos j) ltac:(lia)) as HT; rewrite Z.eqb_refl in C2.
      assert (HJ : mem (join (minus (turns_on (Z.pos j)) T2) (plus (turn j) F')) y).
      { apply (mem_join _ _ (2 * PI * IZR (Z.pos j) - t2) last); [encl | unfold last; apply mem_plus;
          [exact HT | exact HP'] | exact Hy]. }
      destruct (cover_one _ _ _ y C2 HJ) as (J & B & HJ'); exact (convex_at y J HJ' B).
Qed.

(** Between windows i and i + 1. *)
Lemma between_windows i t : (0 <= i < Z.pos j)%Z -> (if (i =? 0)%Z then t1 else 2 * PI * IZR i + w) <= t ->
  t <= 2 * PI * IZR (i + 1) - (if (i + 1 =? Z.pos j)%Z then t2 else w) -> 0 < gap M phi x a t.
Proof.
  intros Hi L U; pose proof HB as B; unfold gap_box in B; cbv zeta in B; rewrite !andb_true_iff in B;
    destruct B as [_ B].
  pose proof (windows_all _ _ _ B i ltac:(rewrite positive_nat_Z; lia)) as C; cbn beta in C.
  destruct HT1 as [M1 _], HT2 as [M2 _]; pose proof (in_W _ _ _ _ HD) as HW.
  pose proof (mem_turns i ltac:(lia)); pose proof (mem_turns (i + 1) ltac:(lia)).
  assert (HJ : mem (join (if (i =? 0)%Z then T1 else plus (turns_on i) (W D)) (minus (turns_on (i + 1))
    (if (i + 1 =? Z.pos j)%Z then T2 else W D))) t).
  { apply (mem_join _ _ _ _ _) with (3 := conj L U); [destruct (i =? 0)%Z; encl | destruct (i + 1 =? Z.pos j)%Z;
      encl]. }
  destruct (cover_one _ _ _ t C HJ) as (J & B' & HJ'); exact (open_at t J HJ' B').
Qed.
Lemma gap_positive : forall t, phi < t < last -> 0 < gap M phi x a t.
Proof.
  intros t Ht; destruct HT1 as [M1 L1], HT2 as [M2 L2]; pose proof PI_RGT_0 as HPI.
  destruct (Rle_lt_dec t t1) as [O1|O1]; [apply near_ends; auto|].
  destruct (Rle_lt_dec (2 * PI * IZR (Z.pos j) - t2) t) as [O2|O2]; [apply near_ends; auto|].
  destruct (last_turn w t) as (z & Z1 & Z2); rewrite plus_IZR in Z2.
  assert (J1 : 1 <= IZR (Z.pos j)) by (apply IZR_le; lia).
  destruct HF' as ([L' _] & _); fold phi' in L'; apply Rabs_def2 in L'.
  destruct (hit_lands _ _ _ _ HI) as [L _]; fold phi in L; apply Rabs_def2 in L.
  assert (Hz : (0 <= z <= Z.pos j)%Z).
  { split; apply Znot_gt_le; intros O.
    - assert (IZR (z + 1) <= 0) by (apply IZR_le; lia); rewrite plus_IZR in *; nra.
    - assert (IZR (Z.pos j) + 1 <= IZR z) by (rewrite <- plus_IZR; apply IZR_le; lia); unfold last in Ht; nra. }
  destruct (Z.eq_dec z (Z.pos j)) as [->|Nj].
  - apply (between_windows (Z.pos j - 1)); [lia | |].
    + rewrite minus_IZR; destruct (Z.eqb_spec (Z.pos j - 1) 0) as [E|E]; [lra | nra].
    + replace (Z.pos j - 1 + 1)%Z with (Z.pos j) by lia; rewrite Z.eqb_refl; lra.
  - destruct (Rle_lt_dec t (2 * PI * IZR z + w)) as [O3|O3].
    + destruct (Z.eq_dec z 0) as [->|N0].
      * apply (between_windows 0); [lia | cbn [Z.eqb]; lra|]; rewrite plus_IZR.
        destruct (Z.eqb_spec (0 + 1) (Z.pos j)) as [E|E]; [rewrite <- E, plus_IZR in O2; lra | nra].
      * pose proof HB as B; unfold gap_box in B; cbv zeta in B; rewrite !andb_true_iff in B; destruct B as [[_ C] _].
        pose proof (windows_all _ _ _ C z ltac:(rewrite Nat2Z.inj_sub, positive_nat_Z by lia; lia)) as B; cbn beta in B.
        destruct (Z.eqb_spec z 0) as [|_]; [lia|]; destruct (Z.eqb_spec z (Z.pos j)) as [|_]; [lia|].
        pose proof (mem_turns z ltac:(lia)); pose proof (in_W _ _ _ _ HD).
        assert (HJ : mem (join (minus (turns_on z) (W D)) (plus (turns_on z) (W D))) t).
        { apply (mem_join _ _ (2 * PI * IZR z - w) (2 * PI * IZR z + w)); [encl | encl | lra]. }
        destruct (cover_one _ _ _ t B HJ) as (J & B' & HJ'); apply orb_prop in B'; destruct B' as [B'|B'].
        { apply (high_at t J z HJ'); [lra | exact B']. }
        { exact (open_at t J HJ' B'). }
    + apply (between_windows z); [lia | |].
      * destruct (Z.eqb_spec z 0); lra.
      * rewrite plus_IZR; destruct (Z.eqb_spec (z + 1) (Z.pos j)) as [E|E]; [|lra]. rewrite <- E, plus_IZR in O2; lra.
Qed.
End Gap.
