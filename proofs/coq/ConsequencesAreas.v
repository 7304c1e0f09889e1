(** * Numbers worked out by hand that follow from the statements about the areas, appendix B and the linear
    problem

    u_k at (1, 1), which is r = 1 and s = 1/6: 0, 1, 1, 0, -1, -1 and so on; at (3, 1/2): 0, 1, 3, 17/2, 24.
    *)

From Coq Require Import Reals List Arith ZArith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementB StatementImpacts StatementZ OrbitZ StatementCircleZ
  Farey.
Open Scope R_scope.

Ltac numbers := unfold c, v, b, u; simpl; lra.

Lemma trace_1_6 : trace 1 (1 / 6) = 1.
Proof. unfold trace; replace (2 * PI * (1 / 6)) with (PI / 3) by field; rewrite cos_PI3; field. Qed.
Lemma trace_1_3 r : trace r (1 / 3) = - r.
Proof.
  unfold trace; replace (2 * PI * (1 / 3)) with (PI - PI / 3) by field.
  rewrite Rtrigo_facts.cos_pi_minus, cos_PI3; field.
Qed.
Lemma point : orbit 3 (1 / 2) 3 Plus Plus.
Proof.
  replace 3 with (IZR 6 / IZR 2) by field; replace (1 / 2) with (IZR 1 / IZR 2) by field.
  apply orbitZ_orbit; reflexivity.
Qed.
Lemma One_case_numbers : One_case_statement ->
  ~ no_orbit 3 (1 / 2) 3 /\ ~ orbit 3 (1 / 2) 3 Minus Plus /\ ~ orbit 3 (1 / 2) 3 Plus Minus.
Proof.
  intros H; destruct (H _ _ 3%nat _ _ ltac:(lia) point) as [H1 H2]; split; [exact H1|].
  split; intros O; apply H2 in O; destruct O; discriminate.
Qed.

(** ** Neighbours *)
Definition Farey_3_8 : Farey 3 8 := Build_Farey 3 8 1 3 2 5 ltac:(unfold neighbours; lia).
Definition Farey_1_4 : Farey 1 4 := Build_Farey 1 4 0 1 1 3 ltac:(unfold neighbours; lia).
Definition Farey_1_3 : Farey 1 3 := Build_Farey 1 3 0 1 1 2 ltac:(unfold neighbours; lia).

Lemma Neighbours_numbers : Neighbours_statement -> (exists F : Farey 5 13, (n_plus F + n_minus F = 13 /\
  m_plus F + m_minus F = 5)%nat) /\ forall F : Farey 3 8, m_plus F = 1%nat /\ n_plus F = 3%nat /\ m_minus F = 2%nat /\
  n_minus F = 5%nat.
Proof.
  intros H; split; [destruct (H 5%nat 13%nat ltac:(lia) eq_refl) as (F & D & E & _); exists F; split; assumption|].
  intros F; destruct (H 3%nat 8%nat ltac:(lia) eq_refl) as (F0 & _ & _ & U).
  destruct (U F) as (-> & -> & -> & ->), (U Farey_3_8) as (<- & <- & <- & <-); repeat split.
Qed.
Lemma tree_numbers : Theorem2_tree_statement -> adjacent 1 3 2 5 /\ neighbours 3 8 1 3 2 5.
Proof.
  intros T; assert (A : adjacent 1 3 2 5).
  { apply (T 3%nat 8%nat 1%nat 3%nat 2%nat 5%nat); unfold neighbours; lia. }
  split; [exact A | apply T; auto].
Qed.

(** ** S1, S2, S3 at s = 1/6 and s = 1/3 *)
Lemma cell_means r s n m : cell r s n m -> 0 < r <= 1 /\ 0 < s < 1 / 2 /\ u (2 * r * cos (2 * PI * s)) (r ^ 2) n <> 0 /\
  - 1 < 2 * (INR n * s - INR m) < 1.
Proof. intros (A & B & C & D); repeat (split; [assumption|]); unfold Rabs in D; destruct Rcase_abs; lra. Qed.
Lemma S1_numbers : S1_statement -> orbit 1 1 2 Minus Plus.
Proof.
  intros H; pose proof (H 1 (1 / 6) 2%nat ltac:(lia)) as X; unfold orbit_at, cell in X.
  rewrite trace_1_6, pow1 in X; apply X; split; [lra|]; split; [lra|]; split; [numbers|]. apply Rabs_def1; simpl; lra.
Qed.

(** 14 s = 7/3, m = 2. *)
Lemma S2_numbers : S2_statement -> no_orbit 1 1 14 /\ exists k, (1 <= k <= 13)%nat /\ b 1 1 14 k > 0.
Proof.
  intros H; pose proof (H 1 (1 / 6) 14%nat 2%nat ltac:(lia) ltac:(lia)) as X.
  unfold no_orbit_at, b_at, cell in X; rewrite trace_1_6, pow1 in X; destruct X as [A B].
  - split; [lra|]; split; [lra|]; split; [numbers|]; apply Rabs_def1; simpl; lra.
  - split; [apply B; discriminate | exact A].
Qed.

(** Period 4: 4 s = 2/3 < 1, and b_{4,3} = 2; at (-1/2, 1/4) 4 s = 4/3 > 1, and b_{4,1} = -7. *)
Lemma S3_numbers : S3_statement -> orbit 1 1 4 Plus Plus /\ no_orbit (-1 / 2) (1 / 4) 4.
Proof.
  intros H; pose proof (H 1 (1 / 6) 4%nat 1%nat Farey_1_4 ltac:(lia) ltac:(lia)) as X.
  pose proof (H (1 / 2) (1 / 3) 4%nat 1%nat Farey_1_4 ltac:(lia) ltac:(lia)) as Y; unfold cell in X, Y.
  rewrite trace_1_6, pow1 in X; rewrite trace_1_3 in Y; replace (- (1 / 2)) with (-1 / 2) in Y by field.
  replace ((1 / 2) ^ 2) with (1 / 4) in Y by field; cbn [n_minus n_plus Farey_1_4] in X, Y; split.
  - destruct X as [X _]; [split; [lra|]; split; [lra|]; split; [numbers|]; apply Rabs_def1; simpl; lra|].
    destruct X as [_ _ X _ _]; [simpl; lra|]; apply X; numbers.
  - destruct Y as [_ Y]; [split; [lra|]; split; [lra|]; split; [numbers|]; apply Rabs_def1; simpl; lra|].
    destruct Y as [_ _ _ Y _]; [simpl; lra|]; apply Y; numbers.
Qed.

(** ** S4: the area of period 4 over (1/8, 1/4), where b_{4,3} decides *)
Lemma side_4 : side 4 3 Plus (1 / (2 * INR 4)) (INR 1 / INR 4).
Proof. exact (left_side 4 1 Farey_1_4 ltac:(lia)). Qed.
Lemma S4_ends_numbers : S4_statement -> S4_ends_statement -> (forall r, 0 < r <= 1 -> orbit_at r (1 / 6) 4 Plus Plus) /\
  exists s, 1 / 8 < s < 1 / 4 /\ no_orbit_at (9 / 10) s 4.
Proof.
  intros S E; destruct (S 4%nat ltac:(lia)) as (_ & A & _); destruct (A _ _ _ _ side_4) as [Rad HR].
  destruct (E 4%nat _ _ _ _ Rad ltac:(lia) side_4 HR) as (_ & E2 & E3); split.
  - intros r Hr; destruct (HR (1 / 6)) as (_ & _ & H); [simpl; lra|]; apply (H r Hr).
    rewrite E3; [lra | reflexivity | simpl; lra | simpl; lra].
  - destruct (E2 ltac:(simpl; lra) (9 / 10) ltac:(lra)) as (d & Hd & T).
    set (s := Rmax (3 / 16) (1 / 4 - d / 2)); pose proof (Rmax_l (3 / 16) (1 / 4 - d / 2)) as M1.
    pose proof (Rmax_r (3 / 16) (1 / 4 - d / 2)) as M2; assert (M3 : s < 1 / 4) by (apply Rmax_lub_lt; lra).
    fold s in M1, M2; exists s; split; [lra|]. assert (Hs : 1 / (2 * INR 4) < s < INR 1 / INR 4) by (simpl; lra).
    destruct (HR s Hs) as (_ & _ & H); apply (H (9 / 10) ltac:(lra)); apply T; [exact Hs|]. apply Rabs_def1; simpl; lra.
Qed.

(** A circle meets the area of period 4 over (1/4, 1/3) in one interval. *)
Lemma S4_section_numbers : S4_section_statement -> forall r s1 s2 s3, 0 < r < 1 -> 1 / 4 < s1 < s2 ->
  s2 < s3 < 1 / 3 -> orbit_at r s1 4 Plus Minus -> orbit_at r s3 4 Plus Minus -> orbit_at r s2 4 Plus Minus.
Proof.
  intros S r s1 s2 s3 Hr H1 H3 O1 O3.
  pose proof (beside 4 _ _ _ _ (right_side 4 1 Farey_1_4 ltac:(lia))) as I; cbn [m_minus n_minus Farey_1_4] in I.
  destruct (S 4%nat Plus Minus _ _ r ltac:(lia) I Hr) as (lo & hi & _ & _ & _ & H).
  apply H in O1; [|simpl; lra]; apply H in O3; [|simpl; lra]; apply H; simpl; lra.
Qed.

(** ** S5: b_{3,1} = (a1 + 1)(a1 - a2 - 1)/(a1^2 - a2), so the leftmost area of period 3 ends at a1 = -1 *)
Lemma trace_half : trace (sqrt (1 / 4)) ((1 - 1 / INR 3) / 2) = - 1 / 2.
Proof.
  replace (1 / 4) with (1 / 2 * (1 / 2)) by field; rewrite sqrt_square by lra.
  replace ((1 - 1 / INR 3) / 2) with (1 / 3) by (simpl; field); rewrite trace_1_3; field.
Qed.
Lemma S5_section_numbers : S5_section_statement -> orbit (-11 / 10) (1 / 4) 3 Plus Minus /\
  no_orbit (-9 / 10) (1 / 4) 3.
Proof.
  intros S; destruct (S (1 / 4) 3%nat ltac:(lra) ltac:(lia) ltac:(exists 1%nat; reflexivity)) as (a1s & H1 & H).
  rewrite trace_half in *; cbn [Nat.sub] in H.
  assert (E : -1 = a1s) by (apply (H (-1) ltac:(lra)); numbers); subst a1s; split.
  - destruct (H (-11 / 10) ltac:(lra)) as (_ & [_ _ D _ _] & L & _); apply D, L; lra.
  - destruct (H (-9 / 10) ltac:(lra)) as (_ & [_ _ _ D _] & L & Z); apply D.
    destruct (Rtotal_order (b (-9 / 10) (1 / 4) 3 1) 0) as [B|[B|B]]; [exact B | apply Z in B; lra | apply L in B; lra].
Qed.
Lemma Joined_numbers : Joined_statement -> orbit (-3) (1 / 4) 3 Plus Minus /\ orbit (-5 / 4) (1 / 4) 3 Plus Minus /\
  ~ orbit (-9 / 10) (1 / 4) 3 Plus Minus.
Proof.
  intros J; destruct (J (1 / 4) 3%nat ltac:(lra) ltac:(lia) ltac:(exists 1%nat; reflexivity))
    as (a1s & H1 & H2 & H3 & H).
  rewrite trace_half in *; cbn [Nat.sub] in H3.
  assert (E : a1s = -1).
  { unfold b in H3; apply (Rmult_eq_compat_r (u a1s (1 / 4) 3)) in H3; unfold Rdiv in H3.
    rewrite Rmult_assoc, Rinv_l, Rmult_0_l in H3 by exact H2; unfold u in H3; simpl in H3.
    assert (F : (a1s + 1) * (a1s - 5 / 4) = 0) by lra; apply Rmult_integral in F; lra. }
  subst a1s; repeat split; try (apply H; lra); intros O; apply H in O; lra.
Qed.

(** ** The area of period 3 over (1/3, 1/2) reaches below 1 - 4/(27 PI). *)
Lemma Depth_numbers : S4_statement -> Depth_statement -> exists r s, 0 < r <= 1 - 4 / (PI * 27) /\
  1 / 3 < s < 1 / 2 /\ orbit_at r s 3 Plus Minus.
Proof.
  intros S D; pose proof (right_side 3 1 Farey_1_3 ltac:(lia)) as I; cbn [n_plus m_minus n_minus Farey_1_3] in I.
  destruct (S 3%nat ltac:(lia)) as (_ & A & _); destruct (A _ _ _ _ I) as [Rad HR].
  destruct (D 3%nat _ _ _ _ Rad ltac:(lia) I HR) as (s & Hs & L); pose proof PI2_1; pose proof PI_4.
  replace (INR 3 ^ 3) with 27 in L by (simpl; ring). assert (X : 0 < 4 / (PI * 27)) by (apply Rdiv_lt_0_compat; lra).
  destruct (HR s Hs) as (P & _ & HA); exists (1 - 4 / (PI * 27)), s; split; [lra|]; split; [simpl in Hs; lra|].
  apply (HA (1 - 4 / (PI * 27))); lra.
Qed.

(** ** The definitions, and what the statements on all intervals say of any n *)
Lemma decides_means a1 a2 n d g : decides a1 a2 n d g -> (0 < d < n)%nat /\ sgn g * c a1 a2 n > 0 /\
  (0 < b a1 a2 n d -> orbit a1 a2 n Plus g) /\ (0 > b a1 a2 n d -> no_orbit a1 a2 n) /\
  forall k, (0 < k < n)%nat -> k <> d -> b a1 a2 n d = 0 -> a2 < 1 -> 0 < b a1 a2 n k.
Proof.
  intros [A B C D E]; split; [lia|]; split; [exact A|]; split; [exact C|]; split; [exact D|].
  intros k Hk Hd Hb Ha; apply (E Hb Ha k); [lia | exact Hd].
Qed.
Lemma above_means n k g lo hi Rad : above n k g lo hi Rad -> forall r s, lo < s < hi -> 0 < r <= 1 ->
  (0 <= Rad s /\ Rad s < 1 /\ continuity_pt Rad s) /\ u_at r s n <> 0 /\ (orbit_at r s n Plus g <-> r > Rad s) /\
  (b_at r s n k = 0 <-> r = Rad s) /\ (b_at r s n k < 0 <-> r < Rad s) /\ (r < Rad s -> no_orbit_at r s n) /\
  forall j, (0 < j < n)%nat -> j <> k -> r = Rad s -> 0 < b_at r s n j.
Proof.
  intros H r s Hs Hr; destruct (H s Hs) as (A & B & P); destruct (P r Hr) as [U X Y Z W V].
  split; [repeat split; try lra; exact B|]; split; [exact U|]; split; [split; intros E; apply X, E|].
  split; [split; intros E; [symmetry; apply Y, E | apply Y; symmetry; exact E]|]; split; [split; intros E; apply Z, E|].
  split; [exact W|]; intros j Hj Hk E; apply (V (eq_sym E) j); [lia | exact Hk].
Qed.
Lemma count_means : Theorem2_count_statement -> forall n, (3 <= n)%nat -> (forall e g lo hi, interval n e g lo hi ->
  0 <= lo /\ lo < hi /\ 2 * hi <= 1) /\ (forall e g lo hi e' g' lo' hi', interval n e g lo hi -> interval n e' g' lo'
  hi' -> lo < lo' -> hi <= lo') /\ exists L, length L = S (phi n) /\ NoDup L /\ forall e g lo hi, interval n e g lo hi
  <-> In (e, g, lo, hi) L.
Proof.
  intros T n Hn; destruct (T n Hn) as (L & E & N & I & A & D); split; [intros e g lo hi HI; destruct (A e g lo hi HI);
    lra|].
  split; [|exists L; split; [lia | split; [exact N|]]; intros; symmetry; apply I].
  intros e g lo hi e' g' lo' hi' H H' L'; destruct (D _ _ _ _ _ _ _ _ H H') as [X|[X|X]]; [injection X; lra | exact X|].
  destruct (A _ _ _ _ H), (A _ _ _ _ H'); lra.
Qed.
Lemma indices_mean : Deciding_indices_statement -> forall n, (3 <= n)%nat -> (forall k, (0 < k < n)%nat ->
  Nat.gcd k n = 1%nat -> exists g lo hi, side n k g lo hi) /\ (forall k g lo hi, side n k g lo hi -> (0 < k < n)%nat /\
  Nat.gcd k n = 1%nat) /\ forall k g lo hi k' g' lo' hi', side n k g lo hi -> side n k' g' lo' hi' -> k = k' <->
  g = g' /\ lo = lo' /\ hi = hi'.
Proof.
  intros D n Hn; destruct (D n Hn) as [A B]; split; [intros k Hk Hg; apply A; split; [lia | exact Hg]|]; split.
  - intros k g lo hi H; destruct (proj2 (A k)) as [X Y]; [exists g, lo, hi; exact H | split; [lia | exact Y]].
  - intros k g lo hi k' g' lo' hi' H H'; rewrite (B _ _ _ _ _ _ _ _ H H'); split; [intros E; injection E; auto |
      intros (-> & -> & ->); reflexivity].
Qed.
Lemma S4_means : S4_statement -> S4_ends_statement -> forall n, (3 <= n)%nat -> (forall r s, 0 < r <= 1 ->
  0 < s < 1 / (2 * INR n) -> orbit_at r s n Minus Plus) /\ forall k g lo hi, side n k g lo hi -> exists Rad,
  above n k g lo hi Rad /\ (lo <> 1 / (2 * INR n) -> tends_to_1 Rad lo hi lo) /\
  (hi <> 1 / 2 -> tends_to_1 Rad lo hi hi) /\ (lo = 1 / (2 * INR n) -> forall s, lo < s < hi ->
  s <= 1 / (2 * (INR n - 1)) -> Rad s = 0).
Proof.
  intros S E n Hn; destruct (S n Hn) as (A & B & _); split; [exact A|]; intros k g lo hi H; destruct (B _ _ _ _ H)
    as [Rad HR].
  exists Rad; split; [exact HR | apply (E n k g lo hi Rad Hn H HR)].
Qed.
Lemma tends_means Rad lo hi x0 : tends_to_1 Rad lo hi x0 -> exists d, d > 0 /\ forall s, lo < s < hi ->
  Rabs (s - x0) < d -> Rad s > 9 / 10.
Proof. intros H; destruct (H (9 / 10) ltac:(lra)) as (d & Hd & T); exists d; split; [exact Hd | exact T]. Qed.
Lemma section_means : S4_section_statement -> forall n e g lo hi r, (3 <= n)%nat -> interval n e g lo hi -> 0 < r < 1 ->
  exists lo' hi', (lo <= lo' /\ hi' <= hi) /\ (lo = 1 / (2 * INR n) -> lo < hi' /\ lo' = lo) /\
  forall s, lo < s < hi -> lo' < s < hi' <-> orbit_at r s n e g.
Proof.
  intros H n e g lo hi r Hn HI Hr; destruct (H n e g lo hi r Hn HI Hr) as (lo' & hi' & A & B & C & D); exists lo', hi'.
  split; [split; assumption|]; split; [intros E; destruct (C E); split; assumption | intros s Hs; symmetry;
    apply D, Hs].
Qed.
Lemma S5_means : S5_statement -> S5_section_statement -> (forall a1 a2, 0 < a2 < 1 -> - (a2 + 1) < a1 <= - 2 * sqrt a2
  -> orbit a1 a2 2 Plus Plus /\ (forall n, (4 <= n)%nat -> Nat.Even n -> no_orbit a1 a2 n) /\ forall n, (3 <= n)%nat ->
  Nat.Odd n -> u a1 a2 n <> 0 /\ decides a1 a2 n (n - 2) Minus) /\ forall a2 n, 0 < a2 < 1 -> (3 <= n)%nat ->
  Nat.Odd n -> let hi := trace (sqrt a2) ((1 - 1 / INR n) / 2) in exists a1s, - (a2 + 1) < a1s < hi /\ forall a1,
  - (a2 + 1) < a1 < hi -> (u a1 a2 n <> 0 /\ decides a1 a2 n (n - 2) Minus) /\ (b a1 a2 n (n - 2) > 0 <-> a1 < a1s) /\
  (b a1 a2 n (n - 2) = 0 <-> a1 = a1s).
Proof.
  intros H K; split.
  - intros a1 a2 H2 H1; split; [apply (H a1 a2 2%nat H2 H1); reflexivity|]; split; intros n Hn; apply (H a1 a2 n H2 H1),
      Hn.
  - intros a2 n H2 Hn Ho hi; destruct (K a2 n H2 Hn Ho) as (a1s & A & B); exists a1s; split; [exact A|]; intros a1 Ha.
    destruct (B a1 Ha) as (U & D & L & Z); split; [split; assumption|]; split; split; intros E;
      first [apply L, E | apply Z, E].
Qed.
Lemma Depth_means : Depth_statement -> forall n k g lo hi Rad, (3 <= n)%nat -> side n k g lo hi -> above n k g lo hi Rad
  -> exists s, lo < s /\ s < hi /\ Rad s + 4 / (PI * INR n ^ 3) < 1.
Proof. intros D n k g lo hi Rad Hn H A; destruct (D n k g lo hi Rad Hn H A) as (s & Hs & L); exists s; lra. Qed.
Lemma S3_means : S3_statement -> forall r s n m (F : Farey m n), (2 <= n)%nat -> (1 <= m)%nat -> cell r s n m ->
  (INR n * s > INR m -> decides (trace r s) (r ^ 2) n (n_plus F) Minus) /\
  (INR n * s < INR m -> decides (trace r s) (r ^ 2) n (n_minus F) Plus).
Proof. intros H r s n m F Hn Hm HC; split; apply (H r s n m F Hn Hm HC). Qed.

(** ** The rest of the plane *)
Lemma Coordinates_numbers : Coordinates_statement -> (forall r s, 0 < r -> 0 < s < 1 / 2 -> trace r s = 1 ->
  r ^ 2 = 1 -> r = 1 /\ s = 1 / 6) /\ exists r s, 0 < r /\ 0 < s < 1 / 2 /\ trace r s = - 1 / 3 /\ r ^ 2 = 1 / 7.
Proof.
  intros C; split.
  - intros r s Hr Hs E1 E2; destruct (C 1 1 ltac:(lra)) as (r0 & s0 & _ & _ & _ & _ & U).
    destruct (U r s Hr Hs) as [-> ->]; [congruence..|].
    destruct (U 1 (1 / 6)) as [<- <-]; [lra | lra | symmetry; apply trace_1_6 | ring | split; reflexivity].
  - destruct (C (- 1 / 3) (1 / 7) ltac:(lra)) as (r & s & Hr & Hs & E1 & E2 & _); exists r, s; auto.
Qed.
Lemma Summary_numbers : Summary_statement -> orbit 3 (1 / 2) 9 Plus Plus /\ ~ orbit 3 (1 / 2) 9 Minus Plus /\
  orbit (3 / 4) (1 / 4) 3 Minus Plus /\ orbit (-11 / 10) (1 / 4) 3 Plus Minus /\ orbit (-3) (1 / 2) 4 Plus Minus.
Proof.
  assert (E : sqrt (1 / 4) = 1 / 2).
  { replace (1 / 4) with (1 / 2 * (1 / 2)) by field; apply sqrt_square; lra. }
  intros S; split; [apply S; [lra | lia | intuition lra]|]; split.
  { intros O; destruct (S 3 (1 / 2) 9%nat Plus Plus ltac:(lra) ltac:(lia)) as [_ H]; apply S in O; [|lra|lia].
    destruct O as [(_ & X & _)|[(X & _)|[(_ & X)|[(_ & X & _)|(X & _)]]]]; try discriminate; lra. }
  split; [apply S; [lra | lia | right; left; rewrite E; replace (PI / INR 3) with (PI / 3) by (simpl; field);
    rewrite cos_PI3; intuition lra]|].
  split; [|apply S; [lra | lia | intuition lra]].
  apply S; [lra | lia|]; right; right; right; left; split; [|split; reflexivity].
  split; [exists 1%nat; reflexivity|]; split; [rewrite E; lra | cbn [Nat.sub]; numbers].
Qed.
Lemma Record_identity_numbers : Record_identity_statement ->
  u 3 (1 / 2) 3 * (2 - v 3 (1 / 2) 1) - u 3 (1 / 2) 1 * (2 - v 3 (1 / 2) 3) = 12.
Proof. intros R; rewrite <- (R 3 (1 / 2) 3%nat 1%nat ltac:(lia)); numbers. Qed.
Lemma Matrix_numbers : Matrix_statement -> mpow (A 3 (1 / 2)) 3 = Mat 24 (17 / 2) (- 17 / 4) (- 3 / 2) /\
  exists X, single_impact 3 (1 / 2) 3 X /\ X = (-1, 46 / 17) /\ 1 + fst (apply (A 3 (1 / 2)) X) = 12 / 17.
Proof.
  intros M; destruct (M 3 (1 / 2) 2%nat ltac:(numbers)) as (E & _).
  destruct (M 3 (1 / 2) 3%nat ltac:(numbers)) as (_ & (X & HX) & U); split.
  - rewrite E; f_equal; numbers.
  - exists X; destruct (U X HX) as (EX & B & _); split; [exact HX|]; split; [rewrite EX; f_equal; numbers|].
    pose proof (B 1%nat ltac:(lia)) as B1; rewrite EX in *; revert B1; unfold b, u; cbn; intros; lra.
Qed.
Lemma Trace_numbers : Trace_statement -> m11 (mpow (A 3 (1 / 2)) 3) + m22 (mpow (A 3 (1 / 2)) 3) = 45 / 2 /\
  1 - v 3 (1 / 2) 3 + (1 / 2) ^ 3 = - 171 / 8.
Proof. intros T; destruct (T 3 (1 / 2) 3%nat) as [-> <-]; split; [numbers | cbn; lra]. Qed.

(** ** Appendix B *)
Lemma cos_5_6 : cos (5 * PI * (1 / 3)) = 1 / 2.
Proof.
  replace (5 * PI * (1 / 3)) with (- (PI / 3) + 2 * PI) by field.
  rewrite cos_plus, cos_2PI, sin_2PI, cos_neg, cos_PI3; field.
Qed.
Lemma B_formulas_numbers : B_formulas_statement -> B 4 2 (1 / 6) = 3.
Proof.
  intros F; destruct (F (1 / 6) 4%nat 2%nat ltac:(lra) ltac:(lia)) as [<- _]; unfold b_at; rewrite trace_1_6, pow1;
    numbers.
Qed.
Lemma B_zeros_numbers : B_zeros_statement -> B 5 2 (1 / 3) = 0 /\ B 5 1 (1 / 3) <> 0.
Proof.
  intros Z; assert (C : cos (INR 5 * PI * (1 / 3)) <> 0).
  { replace (INR 5) with 5 by (simpl; ring); rewrite cos_5_6; lra. }
  split; [apply (Z 5%nat 2%nat (1 / 3) C); exists 1%Z; right; simpl; lra|].
  intros H; apply (Z 5%nat 1%nat (1 / 3) C) in H; destruct H as (m & [H|H]); simpl in H.
  - assert (E : IZR (3 * m) = IZR 1) by (rewrite mult_IZR; lra); apply eq_IZR in E; lia.
  - assert (E : IZR (3 * m) = IZR 4) by (rewrite mult_IZR; lra); apply eq_IZR in E; lia.
Qed.

(** Of the two factors only the one of n - k = 3 vanishes at 1/3. *)
Lemma B_simple_zero_numbers : B_simple_zero_statement -> exists d, d <> 0 /\ tends (fun h => B 5 2 (1 / 3 + h) / h) d.
Proof.
  intros S; destruct (S 5%nat 2%nat (1 / 3) 1%Z ltac:(lia)) as [_ H].
  - replace (INR 5) with 5 by (simpl; ring); rewrite cos_5_6; lra.
  - apply H; [simpl; lra|]; replace (INR 2 * PI * (1 / 3)) with (PI - PI / 3) by (simpl; field).
    rewrite Rtrigo_facts.sin_pi_minus; apply Rgt_not_eq, sin_gt_0; pose proof PI_RGT_0; lra.
Qed.
Lemma B_at_multiples_numbers : B_at_multiples_statement -> B 6 1 (1 / 6) = 1 / 2.
Proof.
  intros H; pose proof (H 6%nat 1%nat 1%Z ltac:(lia) ltac:(lia)) as X; replace (INR 6) with 6 in X by (simpl; ring).
  rewrite X; replace (PI * INR 1 * 1 / 6) with (PI / 6) by (simpl; field); rewrite sin_PI6; field.
Qed.

(** n = 2, k = 1, s = 1/4: a pole; n = 3, k = 1, s = 1/2: the limit 4/3. *)
Lemma B_at_odd_multiples_numbers : B_at_odd_multiples_statement ->
  tends (fun h => h * B 2 1 (IZR (2 * 0 + 1) / (2 * INR 2) + h)) (1 / (PI * 2)) /\
  tends (fun h => B 3 1 (IZR (2 * 1 + 1) / (2 * INR 3) + h)) (4 / 3).
Proof.
  intros H; pose proof PI_RGT_0; split.
  - destruct (H 2%nat 1%nat 0%Z ltac:(lia)) as (_ & T & _).
    replace (1 / (PI * 2)) with (sin (PI * (INR 1 * IZR (2 * 0 + 1) / INR 2)) / (PI * INR 2)); [exact T|].
    replace (PI * (INR 1 * IZR (2 * 0 + 1) / INR 2)) with (PI / 2) by (simpl; field); rewrite sin_PI2; simpl; field;
      lra.
  - destruct (H 3%nat 1%nat 1%Z ltac:(lia)) as (_ & _ & T & _).
    replace (4 / 3) with (2 * INR (3 - 1) / INR 3) by (simpl; field); apply (T 0%Z); simpl; field.
Qed.

(** ** The linear problem: (1, 1/4), beta = 1, impacts 1 and 2 steps apart: p = 0, -1/4, q = 1/4, 5/16 *)
Definition next_of (x : bool) : bool := negb x.
Definition steps_of (x : bool) : nat := if x then 1%nat else 2%nat.

Lemma Impacts_numbers : Impacts_statement -> impacts next_of steps_of 1 (1 / 4) 1 (fun x => if x then (-1, 0) else (-1,
  - 1 / 4)) (fun x => if x then - 1 / 2 else - 5 / 16).
Proof.
  intros I; apply I; [intros x; exists (negb x); destruct x; reflexivity | intros []; cbn [steps_of]; numbers | lra|].
  intros []; (split; [split|]); cbn; try lra.
Qed.

(** c_3 = 171/68 at (3, 1/2). *)
Lemma Single_impact_numbers : Single_impact_statement -> forall X Y,
  impacts (fun j : unit => j) (fun _ => 3%nat) 3 (1 / 2) 2 (fun _ => X) (fun _ => Y) -> Y = 171 / 136.
Proof. intros S X Y H; apply S in H; [rewrite H | | lra]; numbers. Qed.
Lemma Large_formula_numbers : Large_formula_statement -> forall X Y, impacts (fun j : unit => j) (fun _ => 1%nat) 3
  (1 / 2) (1 * 1) (fun _ => X) (fun _ => Y) -> - (m12 (mpow (A 3 (1 / 2)) 1) * (1 * 1)) / (2 * (1 * Y)) = - 1 / 3.
Proof.
  intros L X Y H; rewrite (L 1 1 1 3 (1 / 2) 1%nat X Y); try lra; [unfold large | numbers | numbers | exact H]; numbers.
Qed.
Lemma Det_D_numbers : Det_D_statement -> let M := mpow (A 3 (1 / 2)) 2 in
  det3 (1 - m11 M) (- m12 M) 0 (- m21 M) (1 - m22 M) (- 5) (m11 M) (m12 M) 0 = 15.
Proof. intros D M; transitivity (u 3 (1 / 2) 2 * 5); [exact (D 3 (1 / 2) 5 2%nat) | numbers]. Qed.

(** ** Theorem 2's list by integers: two intervals for n = 3 beside the first, four for n = 5 *)
Lemma Sides_numbers : Sides_statement -> side 5 3 Minus (fraction (2, 5)%Z) (fraction (1, 2)%Z) /\
  ~ exists k, side 4 k Plus (fraction (1, 3)%Z) (fraction (1, 2)%Z).
Proof.
  intros S; split.
  - apply S; [lia|]; exists (2, 5)%Z, (1, 2)%Z; split; [vm_compute; tauto | repeat split].
  - intros [k H]; apply S in H; [|lia]; destruct H as (h & h' & Hin & E & E' & _); vm_compute in Hin.
    destruct Hin as [H|[H|[]]]; [|discriminate H]; injection H as _ <- <-; unfold fraction in E'; cbn in E'; lra.
Qed.

(** s = 7/20 and s = 9/20 for n = 5; s = 2/5: u_5 = 0; s = 9/20 for n = 4: nothing. *)
Lemma Circle_numbers : Circle_statement -> orbit_at 1 (IZR 7 / IZR 20) 5 Plus Plus /\
  ~ orbit_at 1 (IZR 7 / IZR 20) 5 Plus Minus /\ orbit_at 1 (IZR 9 / IZR 20) 5 Plus Minus /\
  u_at 1 (IZR 2 / IZR 5) 5 = 0 /\ no_orbit_at 1 (IZR 9 / IZR 20) 4 /\ orbit_at 1 (IZR 1 / IZR 20) 5 Minus Plus.
Proof.
  intros C; destruct (C 5%nat 7%Z 20%Z) as (_ & A & _); try lia; destruct (C 5%nat 9%Z 20%Z) as (_ & B & _); try lia.
  destruct (C 5%nat 2%Z 5%Z) as (U & _); try lia; destruct (C 4%nat 9%Z 20%Z) as (_ & _ & N); try lia.
  destruct (C 5%nat 1%Z 20%Z) as (_ & D & _); try lia.
  split; [apply A; reflexivity|]; split; [intros H; apply A in H; discriminate H|]; split; [apply B; reflexivity|].
  split; [apply U; reflexivity|]; split; [apply N; reflexivity | apply D; reflexivity].
Qed.

(** ** What definitions mean, and what statements say beyond the numbers above: each of their clauses *)
Ltac parts H := hnf in H; decompose [and] H; repeat match goal with |- _ /\ _ => split end; assumption.
Lemma orbit_means a1 a2 n e g : orbit a1 a2 n e g -> sgn e * sgn g * c a1 a2 n > 0 /\ u a1 a2 n <> 0 /\
  forall k, (0 < k < n)%nat -> sgn e * b a1 a2 n k > 0.
Proof. intros (A & B & C); split; [exact C|]; split; [exact A|]; intros k Hk; apply B; lia. Qed.
Lemma no_orbit_means a1 a2 n : no_orbit a1 a2 n -> u a1 a2 n <> 0 /\
  exists k k', (0 < k < n)%nat /\ (0 < k' < n)%nat /\ b a1 a2 n k < 0 < b a1 a2 n k'.
Proof. intros (A & k & k' & B & C & D & E); split; [exact A|]; exists k, k'; repeat split; lia || lra. Qed.
Lemma regions_mean : Region1_statement -> Region2_statement -> Lines_statement -> forall a1 a2 n, 0 < a2 ->
  (1 <= n)%nat -> (a2 + 1 < a1 -> orbit a1 a2 n Plus Plus /\ u a1 a2 n > 0) /\ (a2 < 1 -> 2 * sqrt a2 <= a1 < a2 + 1 ->
  orbit a1 a2 n Minus Plus /\ u a1 a2 n > 0) /\ (u (- (a2 + 1)) a2 n <> 0 /\ u (a2 + 1) a2 n <> 0 /\
  c (a2 + 1) a2 n = 0) /\ (forall k, (0 < k < n)%nat -> b (a2 + 1) a2 n k = 0) /\
  (Nat.Even n -> c (- (a2 + 1)) a2 n = 0 /\ forall k, (0 < k < n)%nat -> Nat.Even k -> b (- (a2 + 1)) a2 n k = 0).
Proof.
  intros R1 R2 L a1 a2 n H2 Hn; destruct (L a2 n H2 Hn) as (A & B & C & D & E).
  split; [intros H; split; apply (R1 a1 a2 n); assumption|].
  split; [intros H H1; split; apply (R2 a1 a2 n (conj H2 H) H1 Hn)|]; split; [auto|].
  split; [intros k Hk; apply D; lia|]; intros He; destruct (E He) as [F G]; split; [exact F|]; intros k Hk; apply G;
    lia.
Qed.
Lemma areas_mean a1 a2 n g : (area3 a1 a2 n g -> exists r s k lo hi, (0 < r /\ 0 < s < 1 / 2) /\
   (a2 = r ^ 2 /\ a1 = trace r s) /\ b a1 a2 n k > 0 /\ side n k g lo hi /\ lo < s < hi) /\
  (area4 a1 a2 n -> b a1 a2 n (n - 2) > 0 /\ Nat.Odd n /\ - (a2 + 1) <= a1 <= - 2 * sqrt a2).
Proof. split; [intros (r & s & k & lo & hi & H); exists r, s, k, lo, hi | intros H]; parts H. Qed.
Lemma Reversal_means : Reversal_statement -> forall a1 a2 n, 0 < a2 -> (u a1 a2 n <> 0 -> u (a1 / a2) (/ a2) n <> 0 /\
  c (a1 / a2) (/ a2) n = c a1 a2 n / a2 /\ forall k, (k <= n)%nat -> b (a1 / a2) (/ a2) n (n - k) = b a1 a2 n
  (n - (n - k))) /\ (no_orbit a1 a2 n -> no_orbit (a1 / a2) (/ a2) n).
Proof.
  intros R a1 a2 n H2; destruct (R a1 a2 n H2) as (A & B & _ & D); split; [|apply D].
  intros Hu; destruct (B Hu) as [E F]; split; [apply A, Hu|]; split; [exact E|]; intros k Hk; apply F; lia.
Qed.
Lemma Large_5 : Large_statement -> (-1) ^ (2 + 1) * large 1 1 1 (-3) (1 / 2) 2 * 1 > 0.
Proof. intros H; apply (H 1 1 1 (-3) (1 / 2) 2%nat); try lra; try lia; unfold u; simpl; lra. Qed.
Lemma Record_means : Record_statement -> forall a1 a2 n, 0 < a2 <= 1 -> Rabs a1 < a2 + 1 -> (2 <= n)%nat ->
  ~ orbit a1 a2 n Minus Minus /\ (high a1 a2 n -> f a1 a2 n > 0 -> orbit a1 a2 n Plus Minus) /\
  (low a1 a2 n -> f a1 a2 n < 0 -> orbit a1 a2 n Plus Plus) /\ (orbit a1 a2 n Minus Plus -> low a1 a2 n) /\
  forall j, (0 < j)%nat -> 2 - v a1 a2 j <= 0 -> (u a1 a2 j = 0 /\ 2 - v a1 a2 j = 0) /\ a2 = 1.
Proof.
  intros H a1 a2 n H2 H1 Hn; destruct (H a1 a2 n H2 H1 Hn) as (P & Q1 & Q2 & Q3 & Q4); split; [exact Q4|].
  split; [intros X Y; apply Q1; auto|]; split; [intros X Y; apply Q2; auto|]; split; [intros X; apply Q3, X|].
  intros j Hj L; destruct (P j ltac:(lia)) as [G|(E1 & E2 & E3)]; [lra | auto].
Qed.
Lemma Matrix_means : Matrix_statement -> forall a1 a2 n X, u a1 a2 n <> 0 -> single_impact a1 a2 n X ->
  fst X = -1 /\ fst (apply (mpow (A a1 a2) n) X) = fst X /\ c a1 a2 n = snd X - snd (apply (mpow (A a1 a2) n) X).
Proof.
  intros M a1 a2 n X Hu HX; destruct (M a1 a2 n Hu) as (_ & _ & U), (U X HX) as (_ & _ & E), HX as [P Q].
  split; [exact Q|]; split; [lra | exact E].
Qed.
Lemma impacts_mean n a1 a2 beta X Y : impacts S n a1 a2 beta X Y -> forall j,
  snd (X (S j)) = snd (apply (mpow (A a1 a2) (n j)) (X j)) + beta * Y j /\ fst (apply (mpow (A a1 a2) (n j)) (X j)) =
  -1.
Proof. intros H j; destruct (H j) as [P Q]; rewrite Q; split; [reflexivity | exact P]. Qed.
Lemma B_means : B_formulas_statement -> B_simple_zero_statement -> B_double_zero_statement ->
  (forall s, 0 < s < 1 / 2 -> u_at 1 s 4 <> 0 -> c_at 1 s 4 = - 2 * sin (2 * PI * s) * tan (INR 4 * PI * s)) /\
  (exists d, d <> 0 /\ tends (fun h => B 5 3 (1 / 3 + h) / h) d) /\
  forall n k s m l, (1 <= k <= n - 1)%nat -> INR k * s = IZR m -> INR (n - k) * s = IZR l -> INR n * s = IZR (m + l) /\
  forall h, B n k (s + h) = - 2 * sin (INR k * PI * h) * sin (INR (n - k) * PI * h) / cos (INR n * PI * h).
Proof.
  intros F S D; split; [intros s Hs Hu; apply (F s 4%nat 0%nat Hs ltac:(lia) Hu)|]; split.
  - destruct (S 5%nat 3%nat (1 / 3) 1%Z ltac:(lia)) as [H _].
    + replace (INR 5) with 5 by (simpl; ring); rewrite cos_5_6; lra.
    + apply H; [simpl; lra|]; replace (INR (5 - 3) * PI * (1 / 3)) with (PI - PI / 3) by (simpl; field).
      rewrite Rtrigo_facts.sin_pi_minus; apply Rgt_not_eq, sin_gt_0; pose proof PI_RGT_0; lra.
  - intros n k s m l Hk E1 E2; destruct (D n k s m l Hk E1 E2) as (A & C & _); split; assumption.
Qed.
(** n = 4, k = 2 at s = 1/8 + h and, for the even integer, k = 4/3 of n = 3 at s = 1/2. *)
Lemma B_odd_means : B_at_odd_multiples_statement -> tends (fun h => B 3 2 (IZR (2 * 1 + 1) / (2 * INR 3) + h)) (4 / 3)
  /\ forall h, sin (INR 4 * PI * h) <> 0 -> B 4 2 (IZR (2 * 0 + 1) / (2 * INR 4) + h) = 1
  + sin (PI * (INR 2 * IZR (2 * 0 + 1) / INR 4) - (INR 4 - 2 * INR 2) * PI * h) / sin (INR 4 * PI * h).
Proof.
  intros H; split; [|apply (H 4%nat 2%nat 0%Z ltac:(lia))]; destruct (H 3%nat 2%nat 1%Z ltac:(lia)) as (_ & _ & _ & T).
  replace (4 / 3) with (2 * INR 2 / INR 3) by (simpl; field); apply (T 1%Z); simpl; field.
Qed.
Lemma sign_means h t : sign_of h t -> (t = 0 -> h = 0%Z) /\ (0 < t -> (0 < h)%Z) /\ (t < 0 -> (h < 0)%Z).
Proof. intros (A & B & C); split; [apply B|]; split; [apply C | apply A]. Qed.
Lemma Oracle_means : Oracle_statement -> forall x y z n, (0 < z)%Z -> let a1 := IZR x / IZR z in let a2 := IZR y / IZR z
  in (u a1 a2 n <> 0 -> sign_of (signC x y z n) (c a1 a2 n)) /\ sign_of (signD x y z n) (1 - v a1 a2 n + a2 ^ n) /\
  (u a1 a2 n = 0 -> uZ x y z n = 0%Z).
Proof.
  intros O x y z n Hz a1 a2; destruct (O x y z n Hz) as (A & B & C & _); split; [intros Hu; apply B, Hu|].
  split; [exact C | apply A].
Qed.
