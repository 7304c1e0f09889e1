(** * A damped spring moves freely by an explicit flow, and this gives its legs between impacts with a moving
  wall

    All lengths and velocities of legs are divided by nu. *)

From Coq Require Import Reals ZArith List Lra Lia.
From Grazing Require Import StatementOscillator StatementPaths Contraction.
From Grazing Require Export Derivatives.
From Grazing Require Flow.
Open Scope R_scope.

Section Wall.
Variable M : Machine.t.
Notation nu := (Machine.nu M).
Notation g := (g M).
Notation g1 := (g1 M).

(** ** The wall: its bend g'', with the other sign; periods *)

Definition bend (t : R) : R := over_harmonics (fun '(j, (a, b)) => IZR (Z.pos j * Z.pos j) *
  (a * cos (IZR (Z.pos j) * t) + b * sin (IZR (Z.pos j) * t))) (Machine.harmonics M).

Lemma total_ext f f' H : (forall h, f h = f' h) -> over_harmonics f H = over_harmonics f' H.
Proof. intros E; induction H as [|h H IH]; cbn [over_harmonics]; congruence. Qed.

Ltac by_harmonic := induction (Machine.harmonics _) as [|(j & a & b) H IH]; cbn [over_harmonics];
  [apply D_const | apply D_plus; [rewrite ?mult_IZR; derive_by fail; rewrite ?mult_IZR; ring | exact IH]].
Lemma D_g t : derivable_pt_lim g t (g1 t).
Proof. unfold StatementPaths.g, StatementPaths.g1; by_harmonic. Qed.
Lemma D_g1 t : derivable_pt_lim g1 t (- bend t).
Proof.
  apply (D_value _ _ (over_harmonics (fun '(j, (a, b)) =>
    - (IZR (Z.pos j * Z.pos j) * (a * cos (IZR (Z.pos j) * t) + b * sin (IZR (Z.pos j) * t)))) (Machine.harmonics M))).
  - unfold StatementPaths.g1; by_harmonic.
  - unfold bend; induction (Machine.harmonics M) as [|(j & a & b) H IH]; cbn [over_harmonics];
      [ring | rewrite IH; ring].
Qed.
Lemma bend_continuous t : continuity_pt bend t.
Proof.
  apply (D_continuous _ (over_harmonics (fun '(j, (a, b)) => IZR (Z.pos j * Z.pos j) * IZR (Z.pos j)
    * (b * cos (IZR (Z.pos j) * t) - a * sin (IZR (Z.pos j) * t))) (Machine.harmonics M))); unfold bend; by_harmonic.
Qed.
Lemma turned z x : cos (2 * PI * IZR z + x) = cos x /\ sin (2 * PI * IZR z + x) = sin x.
Proof. rewrite Rplus_comm, cos_periods, sin_periods; auto. Qed.
Lemma g_turned z x : g (2 * PI * IZR z + x) = g x /\ g1 (2 * PI * IZR z + x) = g1 x.
Proof.
  split; apply total_ext; intros (j & a & b); replace (IZR (Z.pos j) * (2 * PI * IZR z + x))
    with (2 * PI * IZR (Z.pos j * z) + IZR (Z.pos j) * x) by (rewrite mult_IZR; ring);
    destruct (turned (Z.pos j * z) (IZR (Z.pos j) * x)) as [-> ->]; reflexivity.
Qed.

(** ** The phase in the window at which the wall is so fast *)

Definition lies (w s t : R) : Prop := - w <= t <= w /\ g1 t = nu * s * (1 / 2).
Definition phase w s : R := the (lies w s).
(** An impact with s is inside the window. *)
Definition lands w s : Prop := Rabs (phase w s) < w /\ g1 (phase w s) = nu * s * (1 / 2).

Section Window.
Variable w : R.
Hypothesis Hb : forall t, - w <= t <= w -> 0 < bend t.
Hypothesis H0 : 0 < w.

Lemma g1_decreases t t' : - w <= t <= w -> - w <= t' <= w -> t < t' -> g1 t' < g1 t.
Proof.
  intros Ht Ht' L; destruct (MVT_cor2 g1 (fun t => - bend t) t t' L) as (x & E & Hx); [intros; apply D_g1|].
  specialize (Hb x ltac:(lra)); nra.
Qed.
Lemma g1_order t t' : - w <= t <= w -> - w <= t' <= w -> g1 t' <= g1 t -> t <= t'.
Proof. intros Ht Ht' H; apply Rnot_lt_le; intros L; pose proof (g1_decreases t' t Ht' Ht L); lra. Qed.
Lemma phase_is s t : lies w s t -> phase w s = t.
Proof.
  intros H; apply the_spec; [exact H|]; intros y [Hy E]; destruct H as [Ht E'].
  apply Rle_antisym; apply g1_order; trivial; lra.
Qed.
Lemma phase_between s a b : - w <= a -> b <= w -> g1 b <= nu * s * (1 / 2) <= g1 a -> a <= w -> - w <= b ->
  lies w s (phase w s) /\ a <= phase w s <= b.
Proof.
  intros Ha Hb' H Ha' Hb''; assert (L : a <= b) by (apply g1_order; lra).
  destruct (IVT_cor (fun t => nu * s * (1 / 2) - g1 t) a b) as (t & Ht & E); trivial; [|nra|].
  { intros x; apply (D_continuous _ (bend x)); apply (D_value _ _ (0 - - bend x)); [|ring].
    apply D_minus; [apply D_const | apply D_g1]. }
  assert (P : lies w s t) by (split; lra). rewrite (phase_is s t P); auto.
Qed.
Lemma lands_lies s : lands w s -> lies w s (phase w s).
Proof. intros [H E]; apply Rabs_def2 in H; split; lra. Qed.
Lemma lands_is s t : Rabs t < w -> g1 t = nu * s * (1 / 2) -> phase w s = t /\ lands w s.
Proof.
  intros H E; assert (P : phase w s = t) by (apply phase_is; apply Rabs_def2 in H; split; lra).
  unfold lands; rewrite P; auto.
Qed.
Lemma phase_near s e : 0 < nu -> 0 < e -> lands w s -> exists d, 0 < d /\ forall s', Rabs (s' - s) < d ->
  lands w s' /\ Rabs (phase w s' - phase w s) < e.
Proof.
  intros Hnu He [L E]; set (t := phase w s) in *; apply Rabs_def2 in L.
  destruct (two_least (e / 2) ((w - t) / 2) ltac:(lra) ltac:(lra)) as (e1 & P1 & A1 & A2).
  destruct (two_least e1 ((w + t) / 2) ltac:(lra) ltac:(lra)) as (r & Pr & B1 & B2).
  pose proof (g1_decreases (t - r) t ltac:(lra) ltac:(lra) ltac:(lra)).
  pose proof (g1_decreases t (t + r) ltac:(lra) ltac:(lra) ltac:(lra)).
  destruct (two_least (g1 (t - r) - g1 t) (g1 t - g1 (t + r)) ltac:(lra) ltac:(lra)) as (m & Pm & C1 & C2).
  exists (m / nu); split; [apply Rdiv_lt_0_compat; lra|]; intros s' Hs; apply Rabs_def2 in Hs.
  assert (Es : nu * (m / nu) = m) by (field; lra).
  destruct (phase_between s' (t - r) (t + r)) as [[_ E'] F]; [lra | lra | split; nra | lra | lra|].
  split; [split; [apply Rabs_def1; lra | exact E'] | apply Rabs_def1; lra].
Qed.
Lemma D_phase_at s : 0 < nu -> lands w s -> derivable_pt_lim (phase w) s (- (nu / 2) / bend (phase w s)).
Proof.
  intros Hnu L; set (t := phase w s); pose proof (lands_lies s L) as [Ht E]; fold t in Ht, E.
  pose proof (Hb t Ht) as Pb.
  assert (Cb : continuity_pt (fun x => - (nu / 2) / bend x) t).
  { apply (continuity_pt_div (fun _ => - (nu / 2)) bend); [apply continuity_pt_const; intros x y; reflexivity |
      apply bend_continuous | lra]. }
  intros eps Heps; destruct (continuous_near _ t (eps / 2) Cb ltac:(lra)) as (e & He & Hc).
  destruct (phase_near s e Hnu He L) as (d & Hd & N); exists (mkposreal d Hd); intros h Hh Hhd; cbn [pos] in Hhd.
  destruct (N (s + h)) as [L' F]; [replace (s + h - s) with h by ring; exact Hhd|]; fold t in F |- *.
  pose proof (lands_lies _ L') as [Ht' E']; set (t' := phase w (s + h)) in *.
  assert (X : exists x, g1 t' - g1 t = - bend x * (t' - t) /\ Rabs (x - t) < e /\ - w <= x <= w).
  { apply Rabs_def2 in F; destruct (Rtotal_order t t') as [O|[O|O]].
    - destruct (MVT_cor2 g1 (fun t => - bend t) t t' O) as (x & Ex & Hx); [intros; apply D_g1|].
      exists x; split; [exact Ex|]; split; [apply Rabs_def1; lra | lra].
    - exfalso; rewrite <- O in E'; assert (nu * h = 0) by lra; apply Rmult_integral in H; destruct H; lra.
    - destruct (MVT_cor2 g1 (fun t => - bend t) t' t O) as (x & Ex & Hx); [intros; apply D_g1|].
      exists x; split; [lra|]; split; [apply Rabs_def1; lra | lra]. }
  destruct X as (x & Ex & Hx & Wx); pose proof (Hb x Wx) as Px.
  replace ((t' - t) / h) with (- (nu / 2) / bend x); [specialize (Hc x (Rlt_le _ _ Hx)); lra|].
  assert (Eh : nu * h * (1 / 2) = - bend x * (t' - t)) by lra.
  apply (Rmult_eq_reg_r (bend x * h)); [|apply Rmult_integral_contrapositive_currified; lra].
  replace (- (nu / 2) / bend x * (bend x * h)) with (- (nu * h * (1 / 2))) by (field; lra); rewrite Eh; field; exact Hh.
Qed.
Lemma D_phase f x l : 0 < nu -> lands w (f x) -> derivable_pt_lim f x l ->
  derivable_pt_lim (fun y => phase w (f y)) x (- (nu / 2) / bend (phase w (f x)) * l).
Proof. intros Hnu L D; exact (D_of f (phase w) _ _ _ D (D_phase_at _ Hnu L)). Qed.

(** How far the wall is below its top, in a window about 0. *)
Hypothesis G0 : g 0 = 1 /\ g1 0 = 0.

Lemma drop t : - w <= t <= w -> exists x, Rmin 0 t <= x <= Rmax 0 t /\ (1 - g t) * (2 * bend x) = g1 t * g1 t.
Proof.
  destruct G0 as [Ga Gb]; intros Ht. set (h := fun u => (1 - g u) * (g1 t * g1 t) - (1 - g t) * (g1 u * g1 u)).
  set (h' := fun u => - g1 u * (g1 t * g1 t) + (1 - g t) * (2 * g1 u * bend u)).
  assert (D : forall u, derivable_pt_lim h u (h' u)).
  { intros u; unfold h; derive_by ltac:(first [apply D_g | apply D_g1]); unfold h'; ring. }
  assert (Z0 : h 0 = 0) by (unfold h; rewrite Ga, Gb; ring); assert (Zt : h t = 0) by (unfold h; ring).
  assert (F : forall x, h' x = 0 -> g1 x <> 0 -> (1 - g t) * (2 * bend x) = g1 t * g1 t).
  { intros x E N; unfold h' in E; apply (Rmult_eq_reg_l (g1 x)); [lra | exact N]. }
  destruct (Rtotal_order t 0) as [L|[->|L]].
  - destruct (MVT_cor2 h h' t 0 L) as (x & E & Hx); [intros; apply D|]; exists x.
    rewrite Rmin_right, Rmax_left by lra; split; [lra|]; apply F; [nra|].
    pose proof (g1_decreases x 0 ltac:(lra) ltac:(lra) ltac:(lra)); lra.
  - exists 0; rewrite Rmin_left, Rmax_left by lra; split; [lra|]; rewrite Ga, Gb; ring.
  - destruct (MVT_cor2 h h' 0 t L) as (x & E & Hx); [intros; apply D|]; exists x.
    rewrite Rmin_left, Rmax_right by lra; split; [lra|]; apply F; [nra|].
    pose proof (g1_decreases 0 x ltac:(lra) ltac:(lra) ltac:(lra)); lra.
Qed.
Lemma below_top t : - w <= t <= w -> g t <= 1.
Proof.
  intros Ht; destruct (drop t Ht) as (x & Hx & E).
  assert (- w <= x <= w) by (revert Hx; unfold Rmin, Rmax; repeat destruct Rle_dec; lra).
  specialize (Hb x ltac:(lra)); nra.
Qed.
End Window.
End Wall.

Section Damped.
Variable M : Machine.t.
Notation c := (Machine.c M).
Notation k := (Machine.k M).
Notation sigma := (Machine.sigma M).
Notation nu := (Machine.nu M).
Notation g := (g M).
Notation g1 := (g1 M).

(** ** The flow; [frequency] is that of the damped spring, below critical damping *)

Definition frequency : R := sqrt (k - c * c * (1 / 4)).
Definition E12 : R -> R := Flow.damped_S c (fun T => / frequency * sin (frequency * T)).
Definition E22 : R -> R := Flow.damped_V c (fun T => / frequency * sin (frequency * T)) (fun T => cos
  (frequency * T)).
Definition E11 : R -> R := Flow.e11 c E12 E22.
Definition E21 : R -> R := Flow.e21 k E12.

(** ** Legs: phases t and t' of the impacts, n periods between *)

Definition place t := sigma - (1 - g t) / nu.
Definition time (n : positive) t t' := 2 * PI * IZR (Z.pos n) + t' - t.
Definition after n t t' := (place t' - E11 (time n t t') * place t) / E12 (time n t t').
Definition before n t t' := E21 (time n t t') * place t + E22 (time n t t') * after n t t'.

(** The derivatives when t and t' move with velocities l, l'; the places move with g'/nu. *)
Definition after_slope n t t' l l' := (l * (before n t t' - E11 (time n t t') * (g1 t / nu)) +
  l' * (g1 t' / nu - before n t t')) / E12 (time n t t').
Definition before_slope n t t' l l' :=
  let acc := - c * before n t t' - k * place t' in
  E21 (time n t t') * (g1 t / nu) * l + E22 (time n t t') * after_slope n t t' l l' + acc * (l' - l).

(** The free motion from a place x with velocity u at time t0. *)
Definition moved : R -> R -> R -> R -> R := Flow.moved c E12 E22.
Definition moving : R -> R -> R -> R -> R := Flow.moving k E12 E22.

Lemma moved_scaled a t0 x u t : moved t0 (a * x) (a * u) t = a * moved t0 x u t /\
  moving t0 (a * x) (a * u) t = a * moving t0 x u t.
Proof. unfold moved, moving, Flow.moved, Flow.moving; split; ring. Qed.
Lemma moved_shifted T t0 x u t : moved (T + t0) x u t = moved t0 x u (t - T) /\
  moving (T + t0) x u t = moving t0 x u (t - T).
Proof. unfold moved, moving, Flow.moved, Flow.moving; replace (t - (T + t0)) with (t - T - t0) by ring; auto. Qed.

Hypothesis Hf : 0 < k - c * c * (1 / 4).

Lemma frequency_pos : 0 < frequency. Proof. apply sqrt_lt_R0, Hf. Qed.
Lemma E_flow : Flow.flow c k E12 E22.
Proof.
  pose proof frequency_pos as H; pose proof (sqrt_sqrt _ (Rlt_le _ _ Hf) : frequency * frequency = _) as E.
  pose proof (Flow.damped c _ _ _ (Flow.undamped_circular frequency ltac:(lra))) as F.
  replace (c * c / 4 + frequency * frequency) with k in F by lra; exact F.
Qed.
Lemma moved_free t0 x u : free c k (moved t0 x u) (moving t0 x u).
Proof. apply (Flow.moved_free _ _ _ _ E_flow). Qed.
Lemma moved_start t0 x u : moved t0 x u t0 = x /\ moving t0 x u t0 = u.
Proof. apply (Flow.moved_start _ _ _ _ E_flow). Qed.
Lemma free_moved q v t0 t : free c k q v -> q t = moved t0 (q t0) (v t0) t /\ v t = moving t0 (q t0) (v t0) t.
Proof. apply (Flow.free_moved _ _ _ _ E_flow). Qed.

Section Leg.
Variables (n : positive) (t t' : R -> R) (x l l' : R).
Hypothesis Hnu : nu <> 0.
Hypothesis Ht : derivable_pt_lim t x l.
Hypothesis Ht' : derivable_pt_lim t' x l'.
Hypothesis HE : E12 (time n (t x) (t' x)) <> 0.

Lemma D_place f m : derivable_pt_lim f x m -> derivable_pt_lim (fun y => place (f y)) x (g1 (f x) / nu * m).
Proof. intros Hm; unfold place, Rdiv; derive_by ltac:(exact (D_of _ g _ _ _ Hm (D_g M _))); field; exact Hnu. Qed.
Lemma D_time : derivable_pt_lim (fun y => time n (t y) (t' y)) x (l' - l).
Proof. unfold time; derive_by ltac:(first [exact Ht | exact Ht']); ring. Qed.
Lemma D_flow f m : (forall T, derivable_pt_lim f T (m T)) ->
  derivable_pt_lim (fun y => f (time n (t y) (t' y))) x (m (time n (t x) (t' x)) * (l' - l)).
Proof. intros H; apply (D_of _ f _ _ _ D_time (H _)). Qed.
Lemma D_after : derivable_pt_lim (fun y => after n (t y) (t' y)) x (after_slope n (t x) (t' x) l l').
Proof.
  unfold after; eapply D_ext.
  - apply (D_over (fun y => place (t' y) - E11 (time n (t y) (t' y)) * place (t y)) (fun y =>
      E12 (time n (t y) (t' y)))); [exact HE| |apply D_flow, (Flow.D_S _ _ _ _ E_flow)].
    apply D_minus; [apply D_place, Ht'|].
    apply D_times; [apply D_flow, (Flow.D_e11 _ _ _ _ E_flow) | apply D_place, Ht].
  - reflexivity.
  - unfold after_slope, before, after, E21; cbn beta. set (T := time _ _ _) in *; field; split; assumption.
Qed.
Lemma D_before : derivable_pt_lim (fun y => before n (t y) (t' y)) x (before_slope n (t x) (t' x) l l').
Proof.
  unfold before; eapply D_ext.
  - apply D_plus; apply D_times.
    + apply D_flow, (Flow.D_e21 _ _ _ _ E_flow).
    + apply D_place, Ht.
    + apply D_flow, (Flow.D_V _ _ _ _ E_flow).
    + apply D_after.
  - reflexivity.
  - unfold before_slope, before; cbn beta; set (d := after_slope _ _ _ _ _).
    unfold after; set (T := time _ _ _) in *; unfold E21, E11, Flow.e21, Flow.e11; field; split; assumption.
Qed.
End Leg.

(** The leg hits the second place. *)
Lemma leg_hits n t t' : E12 (time n t t') <> 0 ->
  E11 (time n t t') * place t + E12 (time n t t') * after n t t' = place t'.
Proof. intros H; unfold after; field; exact H. Qed.
End Damped.
