(** * What follows, worked out by hand, from the statements on the second order of maps *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import Statement StatementOrbits StatementOrbitsPlane StatementPlane StatementUnstable.
From Grazing Require Import StatementResonance StatementMultipliers StatementFold Derivatives.
Open Scope R_scope.

(** The multipliers of orbits at resonance with s = 1/8, n = 4: A^4 = - I / 16, and det (I - A^4) = (17/16)^2. *)
Lemma fourth M gamma rate w : planar M (trace (1 / 2) (1 / 8)) ((1 / 2) ^ 2) gamma rate w -> forall x i, (i < 2)%nat ->
  power M 4 x i = - (1 / 16) * x i.
Proof.
  intros H x i Hi; pose proof (is_trace _ _ _ _ _ _ H) as T; pose proof (is_det _ _ _ _ _ _ H) as D.
  assert (T2 : trace (1 / 2) (1 / 8) ^ 2 = 1 / 2).
  { unfold trace; replace (2 * PI * (1 / 8)) with (PI / 4) by field; rewrite cos_PI4; set (s := sqrt 2).
    assert (S2 : s ^ 2 = 2) by (unfold s; rewrite pow2_sqrt; lra). replace ((2 * (1 / 2) * (1 / s)) ^ 2) with (1 / s ^
      2) by (field; intros Z; rewrite Z in S2; lra). rewrite S2; reflexivity. }
  rewrite T in T2; clear T; unfold power, mult; rewrite (is_plane _ _ _ _ _ _ H); cbn [Nat.iter nat_rect dot].
  set (a := Map.A M 0%nat 0%nat) in *; set (b := Map.A M 0%nat 1%nat) in *; set (c := Map.A M 1%nat 0%nat) in *.
  set (d := Map.A M 1%nat 1%nat) in *; assert (E : forall k z, (a + d) * ((a + d) ^ 2 - 2 * (a * d - b * c)) * k + (a *
    d - b * c) * (a * d - b * c - (a + d) ^ 2) * z = - (1 / 16) * z) by (intros k z; rewrite T2, <- D; field).
  destruct i as [|[|i]]; [| |lia]; fold a b c d; [rewrite <- (E (a * x 0%nat + b * x 1%nat)) | rewrite <- (E (c * x
    0%nat + d * x 1%nat))]; ring.
Qed.
Lemma det_2 L : det_less 2 L = (1 - L (axis 0) 0%nat) * (1 - L (axis 1) 1%nat) - L (axis 0) 1%nat * L (axis 1) 0%nat.
Proof. unfold det_less, minus, axis; cbn; ring. Qed.
Lemma multipliers_4 : Determinant_statement -> forall M gamma rate w V U Qh Q, planar M (trace (1 / 2) (1 / 8)) ((1 / 2)
  ^ 2) gamma rate w -> (forall i, (i < 2)%nat -> V i = 16 / 17 * Map.B M i /\ U i = 16 / 17 * Q i) -> second_order M w V
  rate 4 Qh Q -> let K := - (1 + Qh + across M U 4) / rate in exists d, 0 < d /\ forall mu x c q P, - d <= mu <= d ->
  single M 4 mu d x -> let y := speed_of M 4 mu x in flight_slopes M 4 mu y (x tt) c q P -> let D i j := P i j - q i * c
  j / (2 * y) in derivative_at 2 (Nat.iter 4 (StatementOrbits.step M mu)) D (x tt) /\ Rabs ((1 - D 0%nat 0%nat) * (1 - D
  1%nat 1%nat) - D 0%nat 1%nat * D 1%nat 0%nat + rate * K * (289 / 256)) <= 1 / 1000 /\ (1 / 100 < rate * K -> exists l
  v0 v1, 1 < l /\ (v0 <> 0 \/ v1 <> 0) /\ D 0%nat 0%nat * v0 + D 0%nat 1%nat * v1 = l * v0 /\ D 1%nat 0%nat * v0 + D
  1%nat 1%nat * v1 = l * v1).
Proof.
  intros S M gamma rate w V U Qh Q H HV H2 K; pose proof (fourth M gamma rate w H) as F; pose proof (is_plane _ _ _ _ _
    _ H) as N2. destruct (is_rate _ _ _ _ _ _ H) as [Er Ne].
  destruct (S M w V U rate 4%nat Qh Q (is_smooth _ _ _ _ _ _ H)) with (eps := 1 / 1000) as (d & Hd & A); rewrite ?N2;
    trivial; [apply (is_w _ _ _ _ _ _ H) | lia | | | | lra | ].
  - intros x Hx i Hi; specialize (Hx i Hi); rewrite F in Hx by exact Hi; lra.
  - intros i Hi; rewrite !F by exact Hi; destruct (HV i Hi); lra.
  - pose proof (is_CB _ _ _ _ _ _ H) as CB; unfold across; rewrite N2; cbn [dot] in *; rewrite !F by lia.
    rewrite (proj1 (HV 0%nat ltac:(lia))), (proj1 (HV 1%nat ltac:(lia))); lra.
  - exists d; split; [exact Hd|]; intros mu x c q P Hmu Ho y HS D; destruct (A mu x c q P (Rabs_le _ _ Hmu) Ho HS) as
    (A1 & A2 & A3); fold y K in A1, A2, A3; rewrite ?N2 in A1, A2, A3; split; [exact A1|].
    assert (E : forall v i, mult 2 (monodromy y c q P) v i = D i 0%nat * v 0%nat + D i 1%nat * v 1%nat) by (intros v i;
      unfold mult, monodromy; cbn; unfold D; ring).
    assert (E0 : det_less 2 (mult 2 (monodromy y c q P)) = (1 - D 0%nat 0%nat) * (1 - D 1%nat 1%nat) - D 0%nat 1%nat * D
      1%nat 0%nat) by (rewrite det_2, !E; cbn; ring).
    assert (E1 : det_less 2 (power M 4) = 289 / 256) by (rewrite det_2, !F by lia; cbn; field).
    rewrite E0, E1 in A2; split; [exact A2|]; intros Hk; rewrite E0 in A3; apply le_abs in A2.
    destruct A3 as (l & v & Hl & (i & Hi & Nv) & Ev); [lra|]; exists l, (v 0%nat), (v 1%nat); split; [exact Hl|].
    pose proof (Ev 0%nat ltac:(lia)) as V0; pose proof (Ev 1%nat ltac:(lia)) as V1; rewrite E in V0, V1; split; [|auto].
    destruct i as [|[|i]]; [left; exact Nv | right; exact Nv | lia].
Qed.
Lemma slopes_mean M mu y x c q P : flight_slopes M 2 mu y x c q P -> Map.N M = 1%nat -> exists r, 0 < r /\ forall s b t,
  0 <= t <= r -> - t <= s <= t -> - t <= b 0%nat - x 0%nat <= t -> let z b := Map.f M (Map.f M b mu) mu in
  Rabs (Map.h M (z b) mu - Map.h M (z x) mu - c 0%nat * (b 0%nat - x 0%nat)) <= 1 / 9 * t /\
  Rabs ((z b 0%nat + Map.kick M (z b) (y + s) mu 0%nat * (y + s)) - (z x 0%nat + Map.kick M (z x) y mu 0%nat * y) - (s *
  q 0%nat + P 0%nat 0%nat * (b 0%nat - x 0%nat))) <= 1 / 9 * t.
Proof.
  intros [A B] N1; destruct (A (1 / 9) ltac:(lra)) as (r & Hr & HA), (B 0%nat ltac:(lia) (1 / 9) ltac:(lra)) as (r' &
    Hr' & HB); rewrite N1 in HA, HB; exists (Rmin r r'); split; [apply Rmin_glb_lt; assumption|]; intros s b t Ht Hs Hb.
  pose proof (Rmin_l r r'); pose proof (Rmin_r r r'); assert (W : StatementOrbits.within 1 t (minus b x)) by (intros i
    Hi; replace i with 0%nat by lia; apply Rabs_le, Hb); specialize (HA (y + s) b t); specialize (HB (y + s) b t).
  replace (y + s - y) with s in HA, HB by ring; specialize (HA ltac:(lra) (Rabs_le _ _ Hs) W); specialize (HB ltac:(lra)
    (Rabs_le _ _ Hs) W). cbn [dot Nat.iter nat_rect] in HA, HB; unfold minus in HA, HB; split; [revert HA | revert HB];
    match goal with |- Rabs ?a <= _ -> Rabs ?b <= _ => replace b with a by ring; auto end.
Qed.

(** Three dimensions: A^5 is diagonal, with 1/2, - 1 and 2; then det (I - A^5) = - 1. *)
Lemma det_3 L : let a i j := (if Nat.eqb i j then 1 else 0) - L (axis j) i in det_less 3 L = a 0%nat 0%nat * (a 1%nat
  1%nat * a 2%nat 2%nat - a 1%nat 2%nat * a 2%nat 1%nat) - a 0%nat 1%nat * (a 1%nat 0%nat * a 2%nat 2%nat - a 1%nat
  2%nat * a 2%nat 0%nat) + a 0%nat 2%nat * (a 1%nat 0%nat * a 2%nat 1%nat - a 1%nat 1%nat * a 2%nat 0%nat).
Proof. unfold det_less, minus, axis; cbn; ring. Qed.
Lemma multipliers_of_three : Determinant_statement -> forall M w V U rate Qh Q, smooth M -> Map.N M = 3%nat -> (forall
  i, (i < 3)%nat -> w i = mult 3 (Map.A M) w i + Map.phi M i) -> rate = dot 3 (Map.C M) w + Map.eta M -> rate <> 0 ->
  (forall x, power M 5 x 0%nat = x 0%nat / 2 /\ power M 5 x 1%nat = - x 1%nat /\ power M 5 x 2%nat = 2 * x 2%nat) -> (V
  0%nat = 2 * Map.B M 0%nat /\ V 1%nat = Map.B M 1%nat / 2 /\ V 2%nat = - Map.B M 2%nat) -> (U 0%nat = 2 * Q 0%nat /\ U
  1%nat = Q 1%nat / 2 /\ U 2%nat = - Q 2%nat) -> second_order M w V rate 5 Qh Q -> across M V 5 = 0 -> let K := - (1 +
  Qh + across M U 5) / rate in exists d, 0 < d /\ forall mu x c q P, - d <= mu <= d -> single M 5 mu d x -> let y :=
  speed_of M 5 mu x in flight_slopes M 5 mu y (x tt) c q P -> let D i j := P i j - q i * c j / (2 * y) in let E := (1 -
  D 0%nat 0%nat) * ((1 - D 1%nat 1%nat) * (1 - D 2%nat 2%nat) - D 1%nat 2%nat * D 2%nat 1%nat) - D 0%nat 1%nat * (D
  1%nat 0%nat * (1 - D 2%nat 2%nat) + D 1%nat 2%nat * D 2%nat 0%nat) - D 0%nat 2%nat * (D 1%nat 0%nat * D 2%nat 1%nat +
  (1 - D 1%nat 1%nat) * D 2%nat 0%nat) in Rabs (E - rate * K) <= 1 / 1000 /\ (rate * K < - 1 / 100 -> exists l v i, 1 <
  l /\ (i < 3)%nat /\ v i <> 0 /\ D 2%nat 0%nat * v 0%nat + D 2%nat 1%nat * v 1%nat + D 2%nat 2%nat * v 2%nat = l * v
  2%nat).
Proof.
  intros S M w V U rate Qh Q HM N3 Hw He Ne F HV HU H2 V0 K; assert (T : forall i, (i < 3)%nat -> i = 0%nat \/ i = 1%nat
    \/ i = 2%nat) by (intros; lia).
  destruct (S M w V U rate 5%nat Qh Q HM) with (eps := 1 / 1000) as (d & Hd & A); rewrite ?N3; trivial; [lia | | | lra
    |].
  - intros x Hx i Hi; destruct (F x) as (F0 & F1 & F2); specialize (Hx i Hi); destruct (T i Hi) as [->|[->| ->]]; lra.
  - intros i Hi; destruct (F V) as (F0 & F1 & F2), (F U) as (G0 & G1 & G2); destruct (T i Hi) as [->|[->| ->]]; lra.
  - exists d; split; [exact Hd|]; intros mu x c q P Hmu Ho y HS D E; destruct (A mu x c q P (Rabs_le _ _ Hmu) Ho HS) as
      (_ & A2 & A3); fold y K in A2, A3; rewrite N3 in A2, A3.
    assert (E0 : forall v i, mult 3 (monodromy y c q P) v i = D i 0%nat * v 0%nat + D i 1%nat * v 1%nat + D i 2%nat * v
      2%nat) by (intros v i; unfold mult, monodromy; cbn; unfold D; ring).
    assert (E1 : det_less 3 (mult 3 (monodromy y c q P)) = E) by (rewrite det_3; cbv zeta; rewrite !E0; unfold E; cbn;
      ring).
    assert (E2 : det_less 3 (power M 5) = -1).
    { destruct (F (axis 0)) as (F0 & F1 & F2), (F (axis 1)) as (G0 & G1 & G2), (F (axis 2)) as (H0 & H1 & H3).
      rewrite det_3; cbv zeta; rewrite F0, F1, F2, G0, G1, G2, H0, H1, H3; cbn; field. }
    rewrite E1, E2 in A2; rewrite E1 in A3; split; [replace (E - rate * K) with (E + rate * K * -1) by ring; exact A2|].
    intros Hk; apply le_abs in A2; destruct A3 as (l & v & Hl & (i & Hi & Nv) & Ev); [lra|]; exists l, v, i.
    rewrite <- E0; repeat split; trivial; apply Ev; lia.
Qed.

(** The map x -> mu + c x^2 + mu x of the line with the height x and the kick y has slope 0, V = 1, U = c and K = - (1
  + c):
    the sign of 1 + c says on which side its fixed points with an impact are, one for each mu. *)
Definition parabola (c : R) : Map.t := Map.Build_t 1 (fun x mu _ => mu + c * x 0%nat ^ 2 + mu * x 0%nat) (fun x _ => x
  0%nat) (fun _ _ _ _ => 1) (fun _ _ => 0) (fun _ => 1) (fun _ => 1) 0 (fun _ => 1).
Lemma difference c d x x' t : Rabs (x + x') <= d -> Rabs (x - x') <= t -> Rabs (c * (x ^ 2 - x' ^ 2)) <= Rabs c * d * t.
Proof.
  intros H H'; replace (c * (x ^ 2 - x' ^ 2)) with (c * (x + x') * (x - x')) by ring; rewrite !Rabs_mult.
  pose proof (Rabs_pos (x + x')); pose proof (Rabs_pos (x - x')); pose proof (Rabs_pos c); apply Rmult_le_compat;
    trivial; [apply Rmult_le_pos; trivial | apply Rmult_le_compat_l; trivial].
Qed.
Lemma parabola_smooth c : smooth (parabola c).
Proof.
  split; [|split]; [intros i _ | | intros e He; exists 1; split; [lra|]; intros x x' y y' mu mu' t i _ _ _ _ _ _ _ _ Ht
    _]; [| |cbn; rewrite !Rmult_1_l, Rmult_1_r, Rminus_eq_0, Rabs_R0; pose proof (Rabs_pos (y - y')); apply
    Rmult_le_pos; lra].
  - split; [cbn; unfold zero; ring|]; intros e He; pose proof (Rabs_pos c); exists (e / (2 * (Rabs c + 1))).
    assert (D : 0 < e / (2 * (Rabs c + 1))) by (apply Rdiv_lt_0_compat; lra); set (d := e / _) in *; split; [exact D|].
    intros x x' mu mu' t X X' Mu _ Ht Mt; specialize (X 0%nat ltac:(cbn; lia)); specialize (X' 0%nat ltac:(cbn; lia)).
    specialize (Ht 0%nat ltac:(cbn; lia)); unfold minus in Ht; cbn [Map.f parabola Map.A Map.phi Map.N dot].
    set (a := x 0%nat) in *; set (a' := x' 0%nat) in *; match goal with |- Rabs ?g <= _ => replace g with (c * (a ^ 2 -
      a' ^ 2) + (mu * (a - a') + (mu - mu') * a')) by (unfold minus; fold a a'; ring) end.
    assert (E : (Rabs c + 1) * (2 * d) = e) by (unfold d; field; lra); pose proof (product _ _ _ _ Mu Ht) as P1; pose
      proof (product _ _ _ _ Mt X') as P2. assert (P0 : Rabs (c * (a ^ 2 - a' ^ 2)) <= Rabs c * (2 * d) * t) by (apply
      difference; [eapply Rle_trans; [apply Rabs_triang | lra] | exact Ht]).
    eapply Rle_trans; [apply Rabs_triang|]; pose proof (Rabs_triang (mu * (a - a')) ((mu - mu') * a')); rewrite <- E;
      lra.
  - split; [reflexivity|]; intros e He; exists 1; split; [lra|]; intros x x' mu mu' t _ _ _ _ Ht _; cbn; unfold minus.
    match goal with |- Rabs ?g <= _ => replace g with 0 by ring end; rewrite Rabs_R0; apply Rmult_le_pos; [lra|].
    eapply Rle_trans; [apply Rabs_pos | apply (Ht 0%nat); cbn; lia].
Qed.
Lemma parabola_bends c k : bends 1 (fun _ => 1) (fun y mu x => mu + c * x 0%nat ^ 2 + mu * x 0%nat + k * y) (fun y mu _
  => mu + k * y) c.
Proof.
  intros e He; pose proof (Rabs_pos c); destruct (two_least 1 (e / (3 * (Rabs c + 1)))) as (r & Hr & L1 & L2); [lra |
    apply Rdiv_lt_0_compat; lra|]. exists r; split; [exact Hr|]; intros y mu x y' mu' x' Hy Hy' [_ X] [M' X'] [MM XX].
  specialize (X 0%nat ltac:(lia)); specialize (X' 0%nat ltac:(lia)); specialize (XX 0%nat ltac:(lia)); cbv beta in *.
  unfold minus in XX; rewrite Rmult_1_r in X, X', XX; rewrite (Rabs_pos_eq y) in X by lra; rewrite (Rabs_pos_eq y') in
    X', M' by lra; set (a := x 0%nat) in *; set (a' := x' 0%nat) in *; set (s := Rabs (y - y')) in *.
  assert (Hs : 0 <= s) by apply Rabs_pos; assert (Sy : Rabs (a + a' - (y + y')) <= r * (y + y')) by (replace (a + a' -
    (y + y')) with ((a - y) + (a' - y')) by ring; eapply Rle_trans; [apply Rabs_triang | lra]).
  assert (Up : forall z q, 0 <= q -> Rabs (z - q) <= r * q -> Rabs z <= 2 * q) by (intros z q Hq Hz; apply from in Hz;
    rewrite (Rabs_pos_eq q) in Hz by lra; assert (r * q <= 1 * q) by (apply Rmult_le_compat_r; lra); lra).
  pose proof (product _ _ _ _ (Up _ (y + y') ltac:(lra) Sy) XX) as P1; pose proof (product _ _ _ _ Sy (Rle_refl s)) as
    P2.
  fold s in P2; pose proof (product _ _ _ _ MM (Up _ y ltac:(lra) X)) as P3; assert (Sa : Rabs (a - a') <= 2 * s) by
    (apply from in XX; fold s in XX; assert (r * s <= 1 * s) by (apply Rmult_le_compat_r; lra); lra).
  pose proof (product _ _ _ _ M' Sa) as P4; set (p := (a + a') * (a - a' - (y - y')) + (a + a' - (y + y')) * (y - y')).
  assert (Pp : Rabs (c * p) <= Rabs c * (3 * (r * (y + y') * s))) by (rewrite Rabs_mult; apply Rmult_le_compat_l;
    [lra|]; eapply Rle_trans; [apply Rabs_triang | lra]).
  match goal with |- Rabs ?g <= _ => replace g with (c * p + ((mu - mu') * a + mu' * (a - a'))) by (unfold p, minus;
    ring) end. pose proof (Rabs_triang ((mu - mu') * a) (mu' * (a - a'))); eapply Rle_trans; [apply Rabs_triang|].
  assert (E : (Rabs c + 1) * (3 * r) <= e) by (apply (Rmult_le_compat_l (3 * (Rabs c + 1))) in L2; [|lra]; replace (3 *
    (Rabs c + 1) * (e / (3 * (Rabs c + 1)))) with e in L2 by (field; lra); lra).
  assert (S0 : 0 <= (y + y') * s) by (apply Rmult_le_pos; lra); apply (Rmult_le_compat_r _ _ _ S0) in E.
  assert (0 <= r * ((y + y') * s)) by (apply Rmult_le_pos; lra); lra.
Qed.
Lemma parabola_order c : let M := parabola c in (forall i, (i < 1)%nat -> 1 = mult 1 (Map.A M) (fun _ => 1) i + Map.phi
  M i) /\ 1 = dot 1 (Map.C M) (fun _ => 1) + Map.eta M /\ (forall x, (forall i, (i < 1)%nat -> x i = power M 1 x i) ->
  forall i, (i < 1)%nat -> x i = 0) /\ (forall i, (i < 1)%nat -> 1 = power M 1 (fun _ => 1) i + Map.B M i /\ c = power M
  1 (fun _ => c) i + c) /\ second_order M (fun _ => 1) (fun _ => 1) 1 1 c (fun _ => c) /\ across M (fun _ => 1) 1 = 0.
Proof.
  refine (conj _ (conj _ (conj _ (conj _ (conj _ _))))); try (intros; try split; unfold across, power, mult; cbn; ring).
  - intros x Hx i Hi; rewrite (Hx i Hi); unfold power, mult; cbn; ring.
  - constructor; [|intros i Hi]; intros e He; [destruct (parabola_bends c 0 e He) as (r & Hr & B) | destruct
    (parabola_bends c 1 e He) as (r & Hr & B)]; exists r; (split; [exact Hr|]); intros y mu x y' mu' x' Hy Hy' X X' XX;
      specialize (B y mu x y' mu' x' Hy Hy' X X' XX); unfold across, power, mult; cbn in B |- *; match goal with |- Rabs
      ?g <= _ => match type of B with Rabs ?h <= _ => replace g with h by ring; exact B end end.
Qed.
Lemma parabola_side c : Side_statement -> 1 + c <> 0 -> exists d mu0, 0 < d /\ 0 < mu0 /\ forall mu, - mu0 < mu < mu0 ->
  (0 < - (1 + c) * mu -> exists x, single (parabola c) 1 mu d x /\ forall x', single (parabola c) 1 mu d x' ->
   x' tt 0%nat = x tt 0%nat) /\ (- (1 + c) * mu <= 0 -> forall x, ~ single (parabola c) 1 mu d x).
Proof.
  intros S Nc; destruct (parabola_order c) as (O1 & O2 & O3 & O4 & O5 & O6).
  destruct (S (parabola c) (fun _ => 1) (fun _ => 1) (fun _ => c) 1 1%nat c (fun _ => c)) as (d & mu0 & Hd & Hm & H);
    trivial; try exact R1_neq_R0; try lia; [apply parabola_smooth | unfold across, power, mult; cbn; intros E; apply Nc;
      lra |].
  exists d, mu0; split; [exact Hd | split; [exact Hm|]]; intros mu Hmu; destruct (H mu) as [A B]; [apply Rabs_def1;
    lra|].
  assert (E : - (1 + c + across (parabola c) (fun _ => c) 1) / 1 = - (1 + c)) by (unfold across, power, mult; cbn;
    field).
  rewrite E in A, B; split; [|exact B]; intros P; destruct (A P) as (x & X & Only); exists x; split; [exact X|].
  intros x' X'; apply (Only x' X' 0%nat); cbn; lia.
Qed.

(** So their one multiplier tends to - c. *)
Lemma parabola_multiplier c : Determinant_statement -> exists d, 0 < d /\ forall mu x a q P, - d <= mu <= d ->
  single (parabola c) 1 mu d x -> let y := speed_of (parabola c) 1 mu x in
  flight_slopes (parabola c) 1 mu y (x tt) a q P -> Rabs (P 0%nat 0%nat - q 0%nat * a 0%nat / (2 * y) + c) <= 1 / 1000.
Proof.
  intros S; destruct (parabola_order c) as (O1 & O2 & O3 & O4 & O5 & O6).
  destruct (S (parabola c) (fun _ => 1) (fun _ => 1) (fun _ => c) 1 1%nat c (fun _ => c)) with (eps := 1 /
    1000) as (d & Hd & A); trivial; try lra; try lia; [apply parabola_smooth|].
  exists d; split; [exact Hd|]; intros mu x a q P Hmu Ho y HS; destruct (A mu x a q P (Rabs_le _ _ Hmu) Ho HS) as (_ & B
    & _); fold y in B; unfold det_less, across, power, mult, minus, axis, monodromy in B; cbn in B.
  set (z := q 0%nat * a 0%nat / (2 * y)) in *; rewrite <- Rabs_Ropp; match goal with |- Rabs ?g <= _ => match type of B
    with Rabs ?h <= _ => replace g with h by field; exact B end end.
Qed.

(** ** A fold: x -> mu + mu x + nu x on the line, with the height x and the kick y, has V = T = 1, U = 0, S = K = - 1:
    mu is about - y (y + nu) *)
Definition bent : Family.t := Family.Build_t 1 (fun nu x mu _ => mu + mu * x 0%nat + nu * x 0%nat) (fun _ x _ => x
  0%nat) (fun _ _ _ _ _ => 1) (fun _ _ => 0) (fun _ => 1) (fun _ => 1) 0 (fun _ => 1).
Lemma bent_smooth : smooth_family bent.
Proof.
  constructor; [|exists 1; split; [exact Rlt_0_1|]; intros nu x _ Hx; specialize (Hx 0%nat ltac:(cbn; lia)); cbn;
    rewrite Hx; split; [|intros _ _]; ring].
  assert (Flat : forall e g t, 0 < e -> g = 0 -> 0 <= t -> Rabs g <= e * t) by (intros e g t He -> Ht; rewrite Rabs_R0;
    apply Rmult_le_pos; lra).
  split; [|split]; [intros [|[|i]] Hi; [| |cbn in Hi; lia] | |intros e He; exists 1; split; [lra|]; intros x x' y y' mu
    mu' t [|[|i]] Hi _ _ _ _ _ _ _ Ht _; [| |cbn in Hi; lia]; (apply Flat; [exact He | cbn; ring | eapply Rle_trans;
    [apply Rabs_pos | exact Ht]])].
  1, 3: split; [reflexivity|]; intros e He; exists 1; split; [lra|]; intros x x' mu mu' t _ _ _ _ Ht Mt; (apply Flat;
    [exact He | cbn; unfold zero, minus, hat; ring | eapply Rle_trans; [apply Rabs_pos | exact Mt]]).
  split; [cbn; unfold zero; ring|]; intros e He; exists (e / 4); split; [lra|]; intros x x' mu mu' t X X' Mu _ Ht Mt.
  pose proof (X 0%nat ltac:(cbn; lia)) as X0; pose proof (X' 1%nat ltac:(cbn; lia)) as X1; pose proof (Ht 0%nat
    ltac:(cbn; lia)) as T0; pose proof (Ht 1%nat ltac:(cbn; lia)) as T1; unfold minus in T0, T1.
  pose proof (product _ _ _ _ Mu T1); pose proof (product _ _ _ _ Mt X1); pose proof (product _ _ _ _ X0 T1); pose proof
    (product _ _ _ _ T0 X1).
  match goal with |- Rabs ?g <= _ => replace g with ((mu * (x 1%nat - x' 1%nat) + (mu - mu') * x' 1%nat) + (x 0%nat * (x
    1%nat - x' 1%nat) + (x 0%nat - x' 0%nat) * x' 1%nat)) by (cbn; unfold hat, minus, zero; ring) end.
  eapply Rle_trans; [apply Rabs_triang|]; eapply Rle_trans; [apply Rplus_le_compat; apply Rabs_triang|]; lra.
Qed.
Lemma bent_bends k : bends_along 1 (fun _ => 1) (fun nu y mu x => mu + mu * x 0%nat + nu * x 0%nat + k * y) (fun y mu _
  => mu + k * y) 1 0.
Proof.
  intros e He; exists (Rmin 1 (e / 2)); pose proof (Rmin_l 1 (e / 2)); pose proof (Rmin_r 1 (e / 2)).
  assert (Hr : 0 < Rmin 1 (e / 2)) by (apply Rmin_glb_lt; lra); set (r := Rmin 1 (e / 2)) in *; split; [exact Hr|].
  intros nu y mu x y' mu' x' _ Hy Hy' [_ X] [M' X'] [MM XX]; specialize (X 0%nat ltac:(lia)); specialize (XX 0%nat
    ltac:(lia)); cbv beta in *; unfold minus in XX; rewrite Rmult_1_r in X, XX; rewrite (Rabs_pos_eq y) in X by lra.
  rewrite (Rabs_pos_eq y') in M' by lra; set (a := x 0%nat) in *; set (a' := x' 0%nat) in *; set (s := Rabs (y - y')) in
    *; assert (Hs : 0 <= s) by apply Rabs_pos; pose proof (Rabs_pos nu).
  assert (Sa : Rabs a <= 2 * y) by (apply from in X; rewrite (Rabs_pos_eq y) in X by lra; assert (r * y <= 1 * y) by
    (apply Rmult_le_compat_r; lra); lra). assert (Sd : Rabs (a - a') <= 2 * s) by (apply from in XX; fold s in XX;
    assert (r * s <= 1 * s) by (apply Rmult_le_compat_r; lra); lra).
  pose proof (product _ _ _ _ MM Sa); pose proof (product _ _ _ _ M' Sd); pose proof (product _ _ _ _ (Rle_refl (Rabs
    nu)) XX).
  match goal with |- Rabs ?g <= _ => replace g with (((mu - mu') * a + mu' * (a - a')) + nu * (a - a' - (y - y'))) by
    (unfold minus; fold a a'; ring) end.
  eapply Rle_trans; [apply Rabs_triang|]; eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang|].
  assert (P0 : 0 <= (Rabs nu + y + y') * s) by (apply Rmult_le_pos; lra); assert (L : 2 * r <= e) by lra; apply
    (Rmult_le_compat_r _ _ _ P0) in L. assert (0 <= r * (Rabs nu * s)) by (apply Rmult_le_pos; [lra | apply
    Rmult_le_pos; lra]); lra.
Qed.
Lemma bent_folds : Fold_statement -> exists d r, 0 < d /\ 0 < r /\ (forall nu y, - r < nu < r -> 0 < y < r -> exists mu
  x, - d <= mu <= d /\ single (member bent nu) 1 mu d x /\ speed_of (member bent nu) 1 mu x = y /\ - (Rabs nu + y) * y /
  100 <= mu + y * (y + nu) <= (Rabs nu + y) * y / 100 /\ forall mu' x', one_impact bent 1 d nu mu' x' y -> mu' = mu /\
  x' tt 0%nat = x tt 0%nat) /\ forall nu mu x y mu' x' y', - r < nu < r -> y < r -> one_impact bent 1 d nu mu x y ->
  one_impact bent 1 d nu mu' x' y' -> y' < y -> - (Rabs nu + y + y') * (y - y') / 100 <= mu - mu' + (y - y') * (y + y' +
  nu) <= (Rabs nu + y + y') * (y - y') / 100 /\ (nu < 0 -> (y <= 49 / 100 * - nu -> mu' < mu) /\ (51 / 100 * - nu <= y'
  -> mu < mu')) /\ (0 <= nu -> 0 <= y' -> mu < mu').
Proof.
  intros St; destruct (St bent (fun _ => 1) (fun _ => 1) (fun _ => 1) (fun _ => 0) 1 1%nat 1 0 (fun _ => 1) (fun _ =>
    0)) as (d & Hd & [One Law Where]); try exact R1_neq_R0.
  - exact bent_smooth.
  - intros i _; unfold mult; cbn; ring.
  - cbn; ring.
  - lia.
  - intros x Hx i Hi; rewrite (Hx i Hi); unfold power, mult; cbn; ring.
  - intros i _; unfold power, mult; cbn; repeat split; ring.
  - constructor; [|intros i Hi]; intros e He; [destruct (bent_bends 0 e He) as (r & Hr & B) | destruct (bent_bends 1 e
    He) as (r & Hr & B)]; exists r; (split; [exact Hr|]); intros nu y mu x y' mu' x' Hn Hy Hy' X X' XX; specialize (B nu
    y mu x y' mu' x' Hn Hy Hy' X X' XX); unfold across, power, mult; cbn in B |- *; match goal with |- Rabs ?g <= _ =>
    match type of B with Rabs ?h <= _ => replace g with h by ring; exact B end end.
  - unfold across, power, mult; cbn; ring.
  - intros k Hk; lia.
  - assert (ES : - (1 + across (member bent 0) (fun _ => 1) 1) / 1 = -1) by (unfold across, power, mult; cbn; field).
    assert (EK : - (1 + 0 + across (member bent 0) (fun _ => 0) 1) / 1 = -1) by (unfold across, power, mult; cbn;
      field).
    rewrite ES, EK in Law, Where; destruct One as (r1 & R1 & H1), (Law (1 / 100) ltac:(lra)) as (r2 & R2 & H2), (Where
      ltac:(lra) (1 / 100) ltac:(lra)) as (r3 & R3 & H3).
    destruct (two_least r1 r2 R1 R2) as (r4 & R4 & L1 & L2), (two_least r4 r3 R4 R3) as (r & Hr & L3 & L4).
    exists d, r; split; [exact Hd | split; [exact Hr | split]].
    + intros nu y Hnu Hy; assert (An : Rabs nu < r) by (apply Rabs_def1; lra); destruct (H1 nu y ltac:(lra) ltac:(lra))
        as (mu & x & O & Only); destruct (H2 nu mu x y mu x y ltac:(lra) ltac:(lra) ltac:(lra) O O) as [B _].
      exists mu, x; destruct O as (O1 & O2 & O3); apply le_abs in O1, B; split; [exact O1 | split; [exact O2 | split;
        [exact O3 | split; [lra|]]]]. intros mu' x' O'; destruct (Only mu' x' O') as [E X]; split; [exact E | apply X;
        cbn; lia].
    + intros nu mu x y mu' x' y' Hnu Hy O O' Hyy; assert (An : Rabs nu < r) by (apply Rabs_def1; lra).
      destruct (H2 nu mu x y mu' x' y' ltac:(lra) ltac:(lra) ltac:(lra) O O') as [_ B]; rewrite (Rabs_pos_eq (y - y'))
        in B by lra. destruct (H3 nu mu x y mu' x' y' ltac:(lra) ltac:(lra) O O' Hyy) as [C D]; cbv zeta in C, D.
      replace (- (nu * -1) / (2 * -1)) with (- nu / 2) in C, D by field; apply le_abs in B; split; [lra|].
      split; [intros Hn; rewrite Rabs_left in C, D by lra; split; intros S; [specialize (C ltac:(lra)) | specialize (D
        ltac:(lra))]; lra | intros Hn Hp; rewrite Rabs_pos_eq in D by lra; specialize (D ltac:(lra)); lra].
Qed.
