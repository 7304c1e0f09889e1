(** * In the plane the linear problem is solved letter by letter

    In the coordinates C x and C A x: the first is known from the impact before, the second from the height of
    the next impact, and the speed is what remains. Its inverse is bounded in terms of the letters alone. *)

From Coq Require Import Reals Arith Lra Lia.
From Grazing Require Import Defs Algebra StatementOrbits StatementOrbitsPlane
  Finite OrbitVectors Contraction OrbitRemainder.
Open Scope R_scope.

(** (64), without the signs: positive if a flight of j steps may follow one of i steps. *)
Definition follows (a1 a2 : R) (i j : nat) : R :=
  (u a1 a2 (S j) - 1) / u a1 a2 j - (a2 ^ i + a2 * u a1 a2 (i - 1)) / u a1 a2 i.

Lemma finite_max (F : nat -> R) n : exists m, 1 <= m /\ forall k, (k < n)%nat -> Rabs (F k) <= m.
Proof.
  destruct (common_bound (fun k d => Rabs (F k) <= / d) n) as (d & Hd & H).
  - intros k d d' H Hd; apply Rle_trans with (/ d); [exact H | apply Rinv_le_contravar; lra].
  - intros k _; exists (/ (1 + Rabs (F k))); pose proof (Rabs_pos (F k)).
    rewrite Rinv_inv; split; [apply Rinv_0_lt_compat; lra | lra].
  - exists (1 + / d); assert (0 < / d) by (apply Rinv_0_lt_compat, Hd); split; [lra|].
    intros k Hk; specialize (H k Hk); cbn beta in H; lra.
Qed.

(** The least of finitely many absolute values, zeros left out. *)
Lemma margin (F : nat -> nat -> R) n : exists d, 0 < d /\
  forall i j, (i < n)%nat -> (j < n)%nat -> F i j <> 0 -> d <= Rabs (F i j).
Proof.
  destruct (common_bound (fun i d => forall j, (j < n)%nat -> F i j <> 0 -> d <= Rabs (F i j)) n) as (d & Hd & H);
    [| |exists d; split; [exact Hd | intros; apply H; assumption]].
  - intros i d d' H Hd j Hj Hne; specialize (H j Hj Hne); lra.
  - intros i _.
    destruct (common_bound (fun j d => F i j <> 0 -> d <= Rabs (F i j)) n) as (d & Hd & H);
      [| |exists d; split; assumption].
    + intros j d d' H Hd Hne; specialize (H Hne); lra.
    + intros j _; destruct (Req_dec (F i j) 0) as [E|Hne]; [exists 1; split; [lra | contradiction]|].
      exists (Rabs (F i j)); split; [apply Rabs_pos_lt, Hne | intros _; lra].
Qed.

Section Plane.
Variables (M : Map.t) (a1 a2 gamma e : R) (w : vec).
Hypothesis HP : planar M a1 a2 gamma e w.
Notation A := (Map.A M).
Notation C := (Map.C M).
Notation B := (Map.B M).
Notation u := (u a1 a2).

(** C A^k x *)
Definition row (k : nat) (x : vec) : R := dot 2 C (Nat.iter k (mult 2 A) x).

Lemma row_cayley k x : row (S (S k)) x = a1 * row (S k) x - a2 * row k x.
Proof.
  unfold row; set (y := Nat.iter k (mult 2 A) x).
  change (dot 2 C (mult 2 A (mult 2 A y)) = a1 * dot 2 C (mult 2 A y) - a2 * dot 2 C y).
  rewrite (is_trace _ _ _ _ _ _ HP), (is_det _ _ _ _ _ _ HP); unfold mult; cbn [dot]; ring.
Qed.

Lemma row_u k x : row k x = u k * row 1 x + (u (S k) - a1 * u k) * row 0 x.
Proof.
  induction k using two_step; [rewrite u_1, u_0; ring | rewrite u_SS, u_1, u_0; ring|].
  rewrite row_cayley, IHk, IHk0, !u_SS; ring.
Qed.

Lemma row_power j k x : row j (Nat.iter k (mult 2 A) x) = row (j + k) x.
Proof.
  unfold row; f_equal; induction j as [|j IH]; [reflexivity|].
  change (mult 2 A (Nat.iter j (mult 2 A) (Nat.iter k (mult 2 A) x)) = mult 2 A (Nat.iter (j + k) (mult 2 A) x)).
  rewrite IH; reflexivity.
Qed.

Lemma row_comb k a c x y : row k (comb a c x y) = a * row k x + c * row k y.
Proof. unfold row; rewrite power_comb, dot_comb; reflexivity. Qed.

Lemma row_B : row 0 B = 0 /\ row 1 B = gamma /\ gamma <> 0.
Proof.
  split; [exact (is_CB _ _ _ _ _ _ HP)|]; destruct (is_gamma _ _ _ _ _ _ HP) as [E H].
  split; [symmetry; exact E | exact H].
Qed.

(** C and C A are coordinates. *)
Definition rA (i : nat) : R := C 0%nat * A 0%nat i + C 1%nat * A 1%nat i.
Definition D : R := C 0%nat * rA 1 - C 1%nat * rA 0.

Lemma row_0 x : row 0 x = C 0%nat * x 0%nat + C 1%nat * x 1%nat. Proof. unfold row; cbn; ring. Qed.
Lemma row_1 x : row 1 x = rA 0 * x 0%nat + rA 1 * x 1%nat. Proof. unfold row, rA, mult; cbn; ring. Qed.

Lemma D_nonzero : D <> 0.
Proof.
  destruct row_B as (H0 & H1 & Hg); rewrite row_0 in H0; rewrite row_1 in H1; intros HD.
  assert (E0 : C 0%nat * gamma = 0).
  { rewrite <- H1; transitivity (B 1%nat * D + rA 0 * (C 0%nat * B 0%nat + C 1%nat * B 1%nat));
      [unfold D; ring | rewrite HD, H0; ring]. }
  assert (E1 : C 1%nat * gamma = 0).
  { rewrite <- H1; transitivity (- B 0%nat * D + rA 1 * (C 0%nat * B 0%nat + C 1%nat * B 1%nat));
      [unfold D; ring | rewrite HD, H0; ring]. }
  apply Rmult_integral in E0, E1; destruct E0 as [E0|]; [|contradiction]; destruct E1 as [E1|]; [|contradiction].
  apply Hg; rewrite <- H1; unfold rA; rewrite E0, E1; ring.
Qed.

Definition vector (xi zeta : R) : vec := fun i => match i with
  | O => (xi * rA 1 - zeta * C 1%nat) / D | _ => (C 0%nat * zeta - rA 0 * xi) / D end.

Lemma vector_spec xi zeta : row 0 (vector xi zeta) = xi /\ row 1 (vector xi zeta) = zeta.
Proof. rewrite row_0, row_1; unfold vector; pose proof D_nonzero; unfold D in *; split; field; assumption. Qed.

Lemma coordinates x y : row 0 x = row 0 y -> row 1 x = row 1 y -> forall i, (i < 2)%nat -> x i = y i.
Proof.
  rewrite !row_0, !row_1; intros H0 H1; pose proof D_nonzero as HD.
  assert (E0 : x 0%nat = y 0%nat).
  { apply (Rmult_eq_reg_l D); [|exact HD]; unfold D.
    transitivity (rA 1 * (C 0%nat * x 0%nat + C 1%nat * x 1%nat) - C 1%nat * (rA 0 * x 0%nat + rA 1 * x 1%nat));
      [ring | rewrite H0, H1; ring]. }
  assert (E1 : x 1%nat = y 1%nat).
  { apply (Rmult_eq_reg_l D); [|exact HD]; unfold D.
    transitivity (C 0%nat * (rA 0 * x 0%nat + rA 1 * x 1%nat) - rA 0 * (C 0%nat * x 0%nat + C 1%nat * x 1%nat));
      [ring | rewrite H0, H1; ring]. }
  intros [|[|i]] Hi; [exact E0 | exact E1 | lia].
Qed.

Lemma row_bound k : exists m, 0 <= m /\ forall t x, 0 <= t -> within 2 t x -> Rabs (row k x) <= m * t.
Proof.
  destruct (dot_bound 2 C) as (mc & Hmc & Hc), (power_bound 2 A k) as (m & Hm & Hp).
  exists (mc * m); split; [apply Rmult_le_pos; lra|]; intros t x Ht Hx. rewrite Rmult_assoc; apply Hc, Hp; trivial.
Qed.

Lemma vector_bound : exists m, 0 <= m /\ forall xi zeta a c, Rabs xi <= a -> Rabs zeta <= c ->
  within 2 (m * (a + c)) (vector xi zeta).
Proof.
  set (m := (Rabs (C 0%nat) + Rabs (C 1%nat) + Rabs (rA 0) + Rabs (rA 1)) * Rabs (/ D)).
  pose proof (Rabs_pos (C 0%nat)); pose proof (Rabs_pos (C 1%nat)); pose proof (Rabs_pos (rA 0));
    pose proof (Rabs_pos (rA 1)); pose proof (Rabs_pos (/ D)) as HD.
  assert (Hm : 0 <= m) by (apply Rmult_le_pos; lra). exists m; split; [exact Hm|]; intros xi zeta a c Ha Hc.
  assert (Ha0 : 0 <= a) by (apply (Rabs_nonneg xi), Ha); assert (Hc0 : 0 <= c) by (apply (Rabs_nonneg zeta), Hc).
  assert (H' : forall p q, Rabs p + Rabs q <= Rabs (C 0%nat) + Rabs (C 1%nat) + Rabs (rA 0) + Rabs (rA 1) ->
    Rabs ((xi * p - zeta * q) / D) <= m * (a + c)).
  { intros p q Hpq; unfold Rdiv; rewrite Rabs_mult; unfold m.
    replace (_ * Rabs (/ D) * (a + c)) with ((Rabs (C 0%nat) + Rabs (C 1%nat) + Rabs (rA 0) + Rabs (rA 1)) * (a + c)
      * Rabs (/ D)) by ring.
    apply Rmult_le_compat_r; [exact HD|]. apply Rle_trans with (a * Rabs p + c * Rabs q).
    - unfold Rminus; apply triangle2; [|rewrite Rabs_Ropp]; apply Rabs_mult_le; trivial; lra.
    - pose proof (Rabs_pos p); pose proof (Rabs_pos q).
      apply Rle_trans with ((Rabs p + Rabs q) * (a + c)); [|apply Rmult_le_compat_r; lra].
      assert (0 <= Rabs p * c) by (apply Rmult_le_pos; lra). assert (0 <= Rabs q * a) by (apply Rmult_le_pos;
        lra); lra. }
  intros [|i] _; unfold vector; [apply H'; lra|].
  replace (C 0%nat * zeta - rA 0 * xi) with (xi * - rA 0 - zeta * - C 0%nat) by ring. apply H'; rewrite !Rabs_Ropp; lra.
Qed.

Section Word.
Variables (n_max : nat) (J : Type) (next prev : J -> J) (n : J -> nat).
Hypothesis Hnext : forall j, prev (next j) = j /\ next (prev j) = j.
Hypothesis Hn : forall j, (1 <= n j <= n_max)%nat /\ u (n j) <> 0.

(** [linear] in coordinates. *)
Lemma linear_rows X Y Q q : linear M J next n X Y Q q <-> forall j, row (n j) (X j) = q j /\ row 0 (X (next j)) - row
  (n j) (X j) = row 0 (Q j) /\ row 1 (X (next j)) - row (S (n j)) (X j) - Y j * gamma = row 1 (Q j).
Proof.
  unfold linear, power; rewrite (is_plane _ _ _ _ _ _ HP); destruct row_B as (HB0 & HB1 & _).
  assert (E : forall k j, row k (comb 1 (-1) (X (next j)) (comb 1 (Y j) (Nat.iter (n j) (mult 2 A) (X j)) B)) = row k
    (X (next j)) - row (k + n j) (X j) - Y j * row k B).
  { intros k j; rewrite !row_comb, row_power; ring. }
  pose proof (fun j => E 0%nat j) as E0; pose proof (fun j => E 1%nat j) as E1; clear E.
  setoid_rewrite HB0 in E0; setoid_rewrite HB1 in E1; cbn [Nat.add] in E0, E1.
  split; intros H j; destruct (H j) as [H1 H2].
  - assert (H3 : forall k, row k (comb 1 (-1) (X (next j)) (comb 1 (Y j) (Nat.iter (n j) (mult 2 A) (X j)) B)) = row k
      (Q j)).
    { intros k; unfold row; apply dot_ext, power_ext; intros i Hi; unfold comb; rewrite <- (H2 i Hi); ring. }
    pose proof (H3 0%nat) as H30; pose proof (H3 1%nat) as H31; rewrite E0 in H30; rewrite E1 in H31.
    split; [exact H1 | split; lra].
  - destruct H2 as [H2 H3]; split; [exact H1|]; intros i Hi.
    transitivity (comb 1 (-1) (X (next j)) (comb 1 (Y j) (Nat.iter (n j) (mult 2 A) (X j)) B) i); [unfold comb; ring|].
    apply coordinates; [rewrite E0 | rewrite E1 |]; trivial; lra.
Qed.

Lemma kernel X Y : linear M J next n X Y (fun _ => zero) (fun _ => 0) -> bounded M J 0 X Y.
Proof.
  intros H; pose proof (proj1 (linear_rows _ _ _ _) H) as Hr; clear H.
  assert (Hz : forall k, row k zero = 0) by (intros k; unfold row; rewrite power_zero, dot_zero; reflexivity).
  destruct row_B as (_ & _ & Hg).
  assert (H0 : forall j, row 0 (X j) = 0).
  { intros j; destruct (Hr (prev j)) as (H1 & H2 & _); rewrite (proj2 (Hnext j)), Hz in H2; lra. }
  assert (H1 : forall j, row 1 (X j) = 0).
  { intros j; destruct (Hr j) as (H1 & _); rewrite row_u, H0 in H1. apply (Rmult_eq_reg_l (u (n j)));
      [lra | apply Hn]. }
  intros j; split.
  - rewrite (is_plane _ _ _ _ _ _ HP); intros i Hi.
    rewrite (coordinates (X j) zero) by (rewrite ?Hz; auto); unfold zero; rewrite Rabs_R0; lra.
  - destruct (Hr j) as (_ & _ & H); rewrite (row_u (S (n j)) (X j)), !H0, !H1, Hz in H.
    assert (E : Y j * gamma = 0) by lra; apply Rmult_integral in E; destruct E as [->|]; [|contradiction].
    rewrite Rabs_R0; lra.
Qed.

(** The solution of (32): its heights are b_{n,k} - 1, its speeds come from (64). *)
Lemma solution_rows X Y : linear M J next n X Y (fun _ => zero) (fun _ => -1) -> forall j, (forall k, (k <= n j)%nat ->
  row k (X j) + 1 = b a1 a2 (n j) k) /\ gamma * Y j = follows a1 a2 (n j) (n (next j)).
Proof.
  intros H; pose proof (proj1 (linear_rows _ _ _ _) H) as Hr; clear H.
  assert (Hz : forall k, row k zero = 0) by (intros k; unfold row; rewrite power_zero, dot_zero; reflexivity).
  assert (H0 : forall j, row 0 (X j) = -1).
  { intros j; destruct (Hr (prev j)) as (H1 & H2 & _); rewrite (proj2 (Hnext j)), Hz in H2; lra. }
  assert (H1 : forall j, row 1 (X j) = (u (S (n j)) - 1) / u (n j) - a1).
  { intros j; destruct (Hr j) as (H1 & _); rewrite row_u, H0 in H1. apply (Rmult_eq_reg_l (u (n j))); [|apply Hn].
    replace (u (n j) * ((u (S (n j)) - 1) / u (n j) - a1)) with (u (S (n j)) - 1 - a1 * u (n j)) by (field; apply Hn);
      lra. }
  assert (Hk : forall j k, row k (X j) = orbit_x a1 a2 (n j) k) by (intros j k; rewrite row_u, H0, H1; unfold orbit_x;
    ring).
  intros j; split.
  - intros k Hkn; rewrite Hk, b_is_1_plus_x by (trivial; apply Hn); ring.
  - destruct (Hr j) as (_ & _ & H); rewrite H1, Hk, Hz in H.
    replace (gamma * Y j) with ((u (S (n (next j))) - 1) / u (n (next j)) - a1 - orbit_x a1 a2 (n j) (S (n j))) by lra.
    unfold follows, orbit_x; destruct (Hn j) as [[Hj _] Huj], (Hn (next j)) as [_ Hul].
    pose proof (u_Cassini a1 a2 (n j)) as E; rewrite <- E; destruct (n j) as [|m]; [lia|].
    cbn [Nat.sub]; rewrite Nat.sub_0_r; rewrite !u_SS in *; field; split; assumption.
Qed.
End Word.

(** One K for all words over the letters up to n_max. *)
Lemma inverse n_max : exists K, forall (J : Type) (next prev : J -> J) n, (forall j, prev (next j) = j /\
  next (prev j) = j) -> (forall j, (1 <= n j <= n_max)%nat /\ u (n j) <> 0) -> invertible M J next n K.
Proof.
  destruct (row_bound 0) as (m0 & Hm0 & Hrow0), (row_bound 1) as (m1 & Hm1 & Hrow1).
  destruct vector_bound as (mv & Hmv & Hvec). destruct (finite_max (fun k => / u k) (S n_max)) as (U & HU & Hinv).
  destruct (finite_max u (S (S (S n_max)))) as (V & HV & Hu).
  destruct (finite_max (fun k => u (S k) - a1 * u k) (S (S (S n_max)))) as (W & HW & Huu).
  destruct row_B as (_ & _ & Hg); set (G := Rabs (/ gamma)); assert (HG : 0 <= G) by apply Rabs_pos.
  set (a := 1 + m0); set (c := (1 + W * a) * U). assert (Ha : 0 <= a) by (unfold a; lra).
  assert (HWa : 0 <= W * a) by (apply Rmult_le_pos; lra). assert (Hc : 0 <= c) by (unfold c; apply Rmult_le_pos; lra).
  set (K1 := mv * (a + c)); set (K2 := (c + (V * c + W * a) + m1) * G).
  assert (HVc : 0 <= V * c) by (apply Rmult_le_pos; lra). assert (HK1 : 0 <= K1) by (apply Rmult_le_pos; lra).
  assert (HK2 : 0 <= K2) by (apply Rmult_le_pos; lra).
  exists (K1 + K2); intros J next prev n Hnext Hn; split;
    [|intros t X Y _; apply (kernel n_max J next prev n Hnext Hn)].
  intros t Q q HQ. pose (xi := fun j => q (prev j) + row 0 (Q (prev j))).
  pose (zeta := fun j => (q j - (u (S (n j)) - a1 * u (n j)) * xi j) * / u (n j)).
  pose (X := fun j => vector (xi j) (zeta j)).
  pose (Y := fun j => (zeta (next j) - row (S (n j)) (X j) - row 1 (Q j)) * / gamma). exists X, Y.
  assert (EX : forall j, row 0 (X j) = xi j /\ row 1 (X j) = zeta j) by (intros j; apply vector_spec).
  assert (Ht : J -> 0 <= t) by (intros j; apply (Rabs_nonneg (q j)), HQ).
  assert (Hxi : forall j, Rabs (xi j) <= a * t).
  { intros j; unfold xi, a; replace ((1 + m0) * t) with (t + m0 * t) by ring.
    apply triangle2; [apply HQ | apply Hrow0; [apply Ht, j|]].
    destruct (HQ (prev j)) as [H _]; rewrite (is_plane _ _ _ _ _ _ HP) in H; exact H. }
  assert (Hzeta : forall j, Rabs (zeta j) <= c * t).
  { intros j; unfold zeta; pose proof (Ht j) as Htj; destruct (Hn j) as [Hj _].
    replace (c * t) with ((t + W * (a * t)) * U) by (unfold c; ring). apply Rabs_mult_le; [|apply Hinv; lia].
    unfold Rminus at 1; apply triangle2; [apply HQ | rewrite Rabs_Ropp].
    apply Rabs_mult_le; [apply (Huu (n j)); lia | apply Hxi]. }
  split.
  - intros j; pose proof (Ht j) as Htj; destruct (Hn j) as [Hj _]; split.
    + rewrite (is_plane _ _ _ _ _ _ HP); apply within_le with (mv * (a * t + c * t)).
      * replace (mv * (a * t + c * t)) with (K1 * t) by (unfold K1; ring). apply Rmult_le_compat_r; lra.
      * apply Hvec; [apply Hxi | apply Hzeta].
    + apply Rle_trans with (K2 * t); [|apply Rmult_le_compat_r; lra].
      replace (K2 * t) with ((c * t + (V * (c * t) + W * (a * t)) + m1 * t) * G) by (unfold K2; ring).
      unfold Y; apply Rabs_mult_le; [|apply Rle_refl].
      unfold Rminus; apply triangle3; [apply Hzeta | rewrite Rabs_Ropp | rewrite Rabs_Ropp].
      * rewrite row_u, (proj1 (EX j)), (proj2 (EX j)); apply triangle2; apply Rabs_mult_le; auto.
        -- apply Hu; lia.
        -- apply (Huu (S (n j))); lia.
      * apply Hrow1; [exact Htj|]; destruct (HQ j) as [H _]; rewrite (is_plane _ _ _ _ _ _ HP) in H; exact H.
  - apply linear_rows; intros j; destruct (Hn j) as [_ Huj].
    assert (Erow : row (n j) (X j) = q j).
    { rewrite row_u, (proj1 (EX j)), (proj2 (EX j)); unfold zeta; field; exact Huj. }
    split; [exact Erow | split].
    + rewrite Erow, (proj1 (EX (next j))); unfold xi; rewrite (proj1 (Hnext j)); ring.
    + rewrite (proj2 (EX (next j))); unfold Y; field; exact Hg.
Qed.
End Plane.
