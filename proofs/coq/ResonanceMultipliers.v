(** * det (I - M) near a boundary where Theorem 1 is silent *)
From Coq Require Import Reals FunctionalExtensionality Lra Lia.
From Grazing Require Import StatementOrbits StatementUnstable StatementResonance StatementMultipliers.
From Grazing Require Import Derivatives Finite OrbitVectors Contraction OrbitRemainder Orbits OrbitsNear ResonanceMaps.
From Grazing Require Import Determinants.
Import Map.
Open Scope R_scope.

(** ** Derivatives from differences along a line *)
Lemma quotient N G y x q p a v l b k r : slopes N G y x q p -> 0 < r -> 0 <= k -> (forall t, 0 < t <= r ->
  Rabs (G (y + t * a) (comb 1 t x v) - G y x - t * l) <= (b + k * t) * t) -> Rabs (a * q + dot N p v - l) <= b.
Proof.
  intros HG Hr Hk H; destruct (within_exists N v) as (m & Hm & Bv); pose proof (Rabs_pos a) as Pa.
  set (s := Rabs a + m); assert (Hs : 0 <= s) by (unfold s; lra); apply le_epsilon; intros eps Heps.
  destruct (HG (eps / (2 * (s + 1)))) as (r1 & R1 & D); [apply Rdiv_lt_0_compat; lra|].
  destruct (small_enough r1 s R1 Hs) as (t1 & T1 & U1), (small_enough (eps / 2) k ltac:(lra) Hk) as (t2 & T2 & U2).
  destruct (two_least t1 t2) as (t3 & T3 & L1 & L2); try lra; destruct (two_least t3 r T3 Hr) as (t & Ht & L3 & L4).
  specialize (H t ltac:(lra)); assert (Em : minus (comb 1 t x v) x = comb t 0 v v) by (extensionality i; unfold minus,
    comb; ring).
  assert (S1 : s * t <= r1) by (apply Rle_trans with (2 := U1), Rmult_le_compat_l; lra).
  assert (K1 : k * t <= eps / 2) by (apply Rle_trans with (2 := U2), Rmult_le_compat_l; lra).
  specialize (D (y + t * a) (comb 1 t x v) (s * t)); rewrite Em, dot_comb in D.
  assert (St : 0 <= s * t) by (apply Rmult_le_pos; lra); assert (At : 0 <= t * Rabs a /\ 0 <= t * m) by (split; apply
    Rmult_le_pos; lra). specialize (D ltac:(lra)); replace (y + t * a - y) with (t * a) in D by ring; rewrite Rabs_mult,
    (Rabs_pos_eq t) in D by lra. specialize (D ltac:(unfold s; lra)).
  assert (W : within N (s * t) (comb t 0 v v)).
  { intros i Hi; unfold comb; replace (t * v i + 0 * v i) with (t * v i) by ring; rewrite Rabs_mult, (Rabs_pos_eq t) by
    lra. apply Rle_trans with (t * m); [apply Rmult_le_compat_l; [lra | apply Bv, Hi] | unfold s; lra]. }
  specialize (D W); assert (E : eps / (2 * (s + 1)) * (s * t) <= eps / 2 * t).
  { replace (eps / (2 * (s + 1)) * (s * t)) with (eps / 2 * t * (s / (s + 1))) by (field; lra); rewrite <- (Rmult_1_r
    (eps / 2 * t)) at 2; apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|]. apply (Rmult_le_reg_r (s + 1)); [lra|].
    replace (s / (s + 1) * (s + 1)) with s by (field; lra); lra. }
  apply Rmult_le_reg_l with t; [exact Ht|]; rewrite <- (Rabs_pos_eq t) at 1 by lra; rewrite <- Rabs_mult.
  assert (K2 : k * t * t <= eps / 2 * t) by (apply Rmult_le_compat_r; lra).
  apply le_abs in H, D; apply Rabs_le; lra.
Qed.

Lemma bend_slope N V G L Q eps : bends N V G L Q -> 0 < eps -> exists r, 0 < r /\ forall y mu x v q p l, 0 < y <= r ->
  beside N V r y mu x -> within N r (minus v V) -> (forall t, L (y + t - y) (mu - mu) (minus (comb 1 t x v) x) = t * l)
  -> slopes N (fun y x => G y mu x) y x q p -> Rabs (q + dot N p v - (l + 2 * y * Q)) <= eps * y.
Proof.
  intros HB He; destruct (HB (eps / 2)) as (r & Hr & B); [lra|]; exists (r / 2); split; [lra|].
  intros y mu x v q p l Hy [Bm Bx] Bv HL HS; rewrite <- (Rmult_1_l q); rewrite (Rabs_pos_eq y) in Bm, Bx by lra.
  pose proof (Rabs_pos Q) as PQ; apply (quotient N _ y x q p 1 v (l + 2 * y * Q) _ (eps / 2 + Rabs Q) (r / 2) HS); [lra
    | lra|]; intros t Ht.
  rewrite Rmult_1_r; assert (Ed : minus (comb 1 t x v) x = comb t 0 v v) by (extensionality i; unfold minus, comb;
    ring).
  assert (Pt : 0 <= r / 2 * y /\ 0 <= r / 2 * t) by (split; apply Rmult_le_pos; lra).
  specialize (B (y + t) mu (comb 1 t x v) y mu x ltac:(lra) ltac:(lra)); rewrite HL in B.
  assert (X : Rabs (G (y + t) mu (comb 1 t x v) - G y mu x - t * l - Q * ((y + t) ^ 2 - y ^ 2)) <= eps / 2 * ((y + t +
    y) * Rabs (y + t - y))).
  { apply B; unfold beside; rewrite ?Rminus_eq_0, ?Rabs_R0, ?Ed; replace (y + t - y) with t by ring; rewrite
    ?(Rabs_pos_eq y), ?(Rabs_pos_eq t), ?(Rabs_pos_eq (y + t)) by lra; (split; [lra|]); intros i Hi; specialize (Bx i
    Hi); specialize (Bv i Hi); cbv beta in Bx; unfold minus in Bv.
    - replace (comb 1 t x v i - (y + t) * V i) with ((x i - y * V i) + t * (v i - V i)) by (unfold comb; ring).
      apply Rle_trans with (r / 2 * y + t * (r / 2)); [|lra]; apply triangle2; [exact Bx|]; apply Rabs_mult_le; [rewrite
        Rabs_pos_eq; lra | exact Bv].
    - lra.
    - replace (comb t 0 v v i - t * V i) with (t * (v i - V i)) by (unfold comb; ring).
      apply Rle_trans with (t * (r / 2)); [|lra]; apply Rabs_mult_le; [rewrite Rabs_pos_eq; lra | exact Bv]. }
  clear B; replace (y + t - y) with t in X by ring; rewrite (Rabs_pos_eq t) in X by lra.
  pose proof (Rle_abs Q); pose proof (Rle_abs (- Q)) as Q'; rewrite Rabs_Ropp in Q'; assert (0 <= t * t) by nra.
  assert (- (Rabs Q * (t * t)) <= Q * (t * t) <= Rabs Q * (t * t)) by (split; nra).
  apply le_abs in X; apply Rabs_le; lra.
Qed.

(** ** n steps from a point near an orbit have the derivative M *)
Lemma dot_row N y c q P v i : y <> 0 -> mult N (monodromy y c q P) v i = dot N (P i) v - q i * (dot N c v / (2 * y)).
Proof. intros Hy; unfold mult, monodromy; induction N as [|N IH]; cbn; [|rewrite IH]; field; exact Hy. Qed.
Lemma step_slopes M n mu x c q P F : let y := speed_at M mu n x in 0 < y -> h M (fly M mu n x) mu = - (y * y) ->
  flight_slopes M n mu y x c q P -> (forall i, (i < N M)%nat -> F x i = go M mu n x i) ->
  (exists r, 0 < r /\ forall p, within (N M) r (minus p x) -> h M (fly M mu n p) mu < 0 /\
  forall i, (i < N M)%nat -> F p i = go M mu n p i) -> derivative_at (N M) F (monodromy y c q P) x.
Proof.
  intros y Hy Eh [SH SI] Fx (r0 & R0 & Near) eps Heps; destruct (dot_bound (N M) c) as (mc & Hmc & Bc).
  destruct (within_exists (N M) q) as (mq & Hmq & Bq); set (k := (mc + 1) / y); assert (Hk : 0 < k) by (apply
    Rdiv_lt_0_compat; lra). set (e1 := eps / (2 * (k + 1))); assert (He1 : 0 < e1) by (apply Rdiv_lt_0_compat; lra).
  destruct (small_enough (eps * y / 2) mq) as (e3 & He3 & L3); [apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra
    | exact Hmq|]. destruct (SH e3 ltac:(lra)) as (r1 & R1 & DH).
  destruct (common_bound (fun i r => forall y' x' t, 0 <= t <= r -> Rabs (y' - y) <= t -> within (N M) t (minus x' x) ->
    let G y x := let z := fly M mu n x in z i + kick M z y mu i * y in Rabs (G y' x' - G y x - (y' - y) * q i - dot (N
    M) (P i) (minus x' x)) <= e1 * t) (N M)) as (r2 & R2 & DI).
  { intros i a a' H Ha y' x' t Ht; apply H; lra. } { intros i Hi; apply (SI i Hi e1 He1). }
  destruct (small_enough r2 (k + 1) R2 ltac:(lra)) as (t1 & T1 & U1), (small_enough e3 (k * k) ltac:(lra) ltac:(nra)) as
    (t2 & T2 & U2).
  destruct (two_least t1 t2) as (t3 & T3 & L4 & L5); try lra; destruct (two_least r0 r1 R0 R1) as (t4 & T4 & L6 & L7).
  destruct (two_least t3 t4 T3 T4) as (r & Hr & L8 & L9); exists r; split; [exact Hr|]; intros p t Ht Hp i Hi.
  destruct (Near p) as [Hh Fp]; [apply (within_le _ t); [lra | exact Hp]|]; rewrite Fp, Fx by exact Hi; unfold go; fold
    y.
  set (y' := speed_at M mu n p); set (s := y' - y); set (v := minus p x) in *; set (cv := dot (N M) c v).
  assert (Ey : y' * y' = - h M (fly M mu n p) mu) by (apply sqrt_sqrt; lra); assert (Y' : 0 <= y') by apply sqrt_pos.
  specialize (DH y p t ltac:(lra) ltac:(rewrite Rminus_eq_0, Rabs_R0; lra) Hp); fold v cv in DH; change (Rabs (h M (fly
    M mu n p) mu - h M (fly M mu n x) mu - (y - y) * 0 - cv) <= e3 * t) in DH; rewrite Eh in DH.
  pose proof (Bc t v Hp) as Bv; fold cv in Bv; assert (Es : s * (y' + y) = - (h M (fly M mu n p) mu + y * y)) by (unfold
    s; lra). assert (E3 : e3 * t <= 1 * t) by (apply Rmult_le_compat_r; lra).
  assert (Bs : Rabs s <= k * t).
  { apply Rmult_le_reg_r with y; [exact Hy|]; replace (k * t * y) with ((mc + 1) * t) by (unfold k; field; lra).
    apply Rle_trans with (Rabs s * (y' + y)); [apply Rmult_le_compat_l; [apply Rabs_pos | lra]|].
    rewrite <- (Rabs_pos_eq (y' + y)), <- Rabs_mult, Es by lra; apply le_abs in DH, Bv; apply Rabs_le; lra. }
  assert (Ss : 0 <= s * s <= e3 * t).
  { split; [nra|]; replace (s * s) with (Rabs s * Rabs s) by (rewrite <- Rabs_mult; apply Rabs_pos_eq; nra).
    apply Rle_trans with (k * t * (k * t)); [apply Rmult_le_compat; trivial; apply Rabs_pos|].
    replace (k * t * (k * t)) with (k * k * t * t) by ring; apply Rmult_le_compat_r; [lra|].
    apply Rle_trans with (2 := U2), Rmult_le_compat_l; nra. }
  assert (Bd : Rabs (s + cv / (2 * y)) <= e3 * t / y).
  { apply Rmult_le_reg_l with (2 * y); [lra|]; rewrite <- (Rabs_pos_eq (2 * y)) at 1 by lra; rewrite <- Rabs_mult.
    replace (2 * y * (s + cv / (2 * y))) with (- (h M (fly M mu n p) mu - - (y * y) - (y - y) * 0 - cv) - s * s) by
      (unfold s; replace ((y' - y) * (y' - y)) with (y' * y' - 2 * y * y' + y * y) by ring; rewrite Ey; field; lra).
    replace (2 * y * (e3 * t / y)) with (2 * (e3 * t)) by (field; lra); apply le_abs in DH; apply Rabs_le; lra. }
  assert (Kt : 0 <= k * t) by (apply Rmult_le_pos; lra).
  specialize (DI i Hi y' p ((k + 1) * t)); cbv zeta in DI; fold s v in DI; assert (W : within (N M) ((k + 1) * t) v) by
    (apply (within_le _ t); [lra | exact Hp]). assert (T : 0 <= (k + 1) * t <= r2) by (split; [lra|]; apply Rle_trans
    with (2 := U1), Rmult_le_compat_l; lra). specialize (DI T ltac:(lra) W).
  replace (e1 * ((k + 1) * t)) with (eps / 2 * t) in DI by (unfold e1; field; lra).
  rewrite dot_row by lra; fold cv; pose proof (Rabs_mult_le _ _ _ _ Bd (Bq i Hi)) as B2; assert (E2 : e3 * t / y * mq <=
    eps / 2 * t).
  { replace (e3 * t / y * mq) with (mq * e3 * (t / y)) by (field; lra); replace (eps / 2 * t) with (eps * y / 2 * (t /
    y)) by (field; lra); apply Rmult_le_compat_r; [apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat, Hy] | exact
    L3]. }
  apply le_abs in DI, B2; apply Rabs_le; lra.
Qed.

(** ** With q = (I - P) v and c v = - 2 y (1 + k), nearly, det (I - P + q c / (2 y)) is nearly - k det (I - P) *)
Lemma dot_within N l t c x : 0 <= l -> 0 <= t -> within N l c -> within N t x ->
  Rabs (dot N c x) <= INR N * (l * t).
Proof.
  intros Hl Ht Hc Hx; induction N as [|N IH]; [cbn; rewrite Rabs_R0; lra|]; rewrite S_INR; cbn [dot].
  rewrite Rmult_plus_distr_r, Rmult_1_l; apply triangle2; [apply IH; intros i Hi; [apply Hc | apply Hx]; lia|].
  apply product; [apply Hc | apply Hx]; lia.
Qed.
Lemma algebra N l : 0 <= l -> exists m, 0 <= m /\ forall P A c q v y k h h1, 0 < y -> 0 <= h -> 0 <= h1 -> h * y <= l ->
  (forall i, (i < N)%nat -> Rabs (q i - (v i - dot N (P i) v)) <= h * y) -> Rabs (dot N c v + 2 * y * (1 + k)) <= h * y
  -> within N l c -> (forall j i, (j < N)%nat -> (i < N)%nat -> Rabs (A j i) <= l /\
  Rabs (axis j i - P i j) <= l /\ Rabs (axis j i - P i j - A j i) <= h1) ->
  Rabs (det_less N (mult N (monodromy y c q P)) + k * det N A) <= m * h + Rabs k * m * h1.
Proof.
  intros Hl; destruct (det_near N l Hl) as (m & Hm & Near); pose proof (pos_INR N) as N0.
  assert (N1 : 0 <= INR N * (l * m)) by (repeat apply Rmult_le_pos; lra).
  exists (m + INR N * (l * m)); split; [lra|]; intros P A c q v y k h h1 Hy Hh Hh1 Hl' Bq Bc Cl HA.
  set (X := fun j i => axis j i - P i j); set (r := fun i => q i - (v i - dot N (P i) v)).
  assert (Wl : within N l r) by (intros i Hi; eapply Rle_trans; [apply (Bq i Hi) | exact Hl']).
  assert (Hy0 : 0 <= h * y) by (apply Rmult_le_pos; lra).
  assert (WX : forall j, (j < N)%nat -> within N l (X j)) by (intros j Hj i Hi; apply HA; assumption).
  destruct (Near X A h1) as [DX DA]; [|exact Hh1|].
  { intros j Hj; split; [apply WX, Hj|]; split; intros i Hi; apply (HA j i Hj Hi). }
  assert (Zero : forall j, (j < N)%nat -> det N (put j zero X) = 0).
  { intros j Hj; replace zero with (comb 0 0 zero zero) by (extensionality i; unfold comb, zero; ring).
    rewrite det_comb by exact Hj; ring. }
  assert (Dr : within N (m * (h * y)) (fun j => det N (put j r X))).
  { intros j Hj; destruct (Near (put j r X) (put j zero X) (h * y)) as [_ B]; [|exact Hy0 | rewrite Zero, Rminus_0_r in
    B by exact Hj; exact B]. intros k' Hk; unfold put; destruct (Nat.eqb_spec k' j) as [->|_].
    - split; [exact Wl | split; [apply within_zero, Hl|]]; intros i Hi; unfold minus, zero; rewrite Rminus_0_r.
      apply (Bq i Hi).
    - split; [apply WX, Hk | split; [apply WX, Hk|]]; intros i Hi; unfold minus; rewrite Rminus_eq_0, Rabs_R0; exact
        Hy0. }
  assert (Dq : forall j, (j < N)%nat -> det N (put j q X) = v j * det N X + det N (put j r X)).
  { intros j Hj; rewrite <- (det_cramer N j X v Hj); set (Xv := fun i => dot N (fun k => X k i) v).
    transitivity (1 * det N (put j Xv X) + 1 * det N (put j r X)); [rewrite <- det_comb by exact Hj | ring].
    apply det_ext; intros k' i _ Hi; unfold put.
    destruct (Nat.eqb_spec k' j); [|reflexivity]; unfold comb, r, Xv, X.
    rewrite (dot_terms N _ v (axis i) v (P i) v 1 (-1)), (dot_alone N (axis i) v i Hi).
    - unfold axis; rewrite Nat.eqb_refl; ring.
    - intros l' _ Nl; unfold axis; destruct (Nat.eqb_spec l' i); [contradiction | ring].
    - intros l' _; unfold axis; rewrite (Nat.eqb_sym i l'); ring. }
  assert (E : det_less N (mult N (monodromy y c q P)) = det N X + / (2 * y) * (det N X * dot N c v + dot N c (fun j =>
    det N (put j r X)))).
  { unfold det_less; rewrite (det_ext N _ (fun j => comb 1 (c j / (2 * y)) (X j) q)).
    - rewrite det_rank_one; f_equal; rewrite (dot_terms N _ _ c v c (fun j => det N (put j r X)) (/ (2 * y) * det N X)
        (/ (2 * y))); [ring|]. intros j Hj; rewrite Dq by exact Hj; field; lra.
    - intros j i Hj _; unfold minus, mult; rewrite (dot_axis N (monodromy y c q P i) j Hj); unfold monodromy, comb, X;
      field; lra. }
  pose proof (dot_within N l _ c _ Hl (Rmult_le_pos _ _ Hm Hy0) Cl Dr) as B2.
  pose proof (product _ _ _ _ DX Bc) as B1; pose proof (product _ _ _ _ (Rle_refl (Rabs k)) DA) as B3.
  replace (det_less _ _ + _) with (/ (2 * y) * (det N X * (dot N c v + 2 * y * (1 + k)) + dot N c (fun j => det N (put
    j r X))) - k * (det N X - det N A)) by (rewrite E; field; lra).
  eapply Rle_trans; [apply apart|]; apply Rplus_le_compat; [|eapply Rle_trans; [exact B3|]].
  - rewrite Rabs_mult, Rabs_pos_eq by (left; apply Rinv_0_lt_compat; lra); apply (Rmult_le_reg_l (2 * y)); [lra|].
    rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra; eapply Rle_trans; [apply Rabs_triang|].
    assert (0 <= (m + INR N * (l * m)) * (h * y)) by (apply Rmult_le_pos; lra); lra.
  - rewrite Rmult_assoc, <- (Rmult_assoc (Rabs k)); rewrite Rmult_assoc; apply Rmult_le_compat_l; [apply Rabs_pos|].
    apply Rmult_le_compat_r; lra.
Qed.

Theorem Determinant : Determinant_statement.
Proof.
  intros M w V U e n Qh Q HM N Hw He Ne Hn Hdet HVU H2 V0 K eps Heps; subst N; set (N := Map.N M) in *.
  assert (Pl : forall x, 0 <= Rabs x) by apply Rabs_pos; destruct (power_bound N (Map.A M) n) as (ma & Hma & BA).
  destruct (dot_bound N (C M)) as (mc & Hc & BC); set (cA v := dot N (C M) (power M n v)); set (l := mc * ma + ma + 2).
  assert (Hl : 0 <= mc * ma) by (apply Rmult_le_pos; lra).
  destruct (algebra N l ltac:(unfold l; lra)) as (m & Hm & Alg).
  destruct (small_enough (eps / 2) m ltac:(lra) Hm) as (h & Hh & L1).
  destruct (small_enough (eps / 2) (Rabs (e * K) * m)) as (h1 & Hh1 & L2); [lra | apply Rmult_le_pos; [apply Pl |
    lra]|].
  destruct (bend_slope _ _ _ _ _ h (second_height _ _ _ _ _ _ _ H2) ltac:(lra)) as (rh & Rh & BH).
  destruct (common_bound (fun i r => forall y mu x v q p l, 0 < y <= r -> beside N V r y mu x -> within N r (minus v V)
    -> (forall t, power M n (minus (comb 1 t x v) x) i + (y + t - y) * B M i + (mu - mu) * (w i - power M n w i) = t *
    l) -> slopes N (fun y x => let z := Nat.iter n (fun x => f M x mu) x in z i + kick M z y mu i * y) y x q p -> Rabs
    (q + dot N p v - (l + 2 * y * Q i)) <= h * y) N) as (ri & Ri & BI).
  { intros i a a' H Ha y mu x v q p g Hy [X1 X2] Hv; apply H; [lra | | apply (within_le _ a'); [lra | exact Hv]].
    assert (a' * Rabs y <= a * Rabs y) by (apply Rmult_le_compat_r; [apply Pl | lra]); split; [lra | apply (within_le _
      (a' * Rabs y)); assumption]. }
  { intros i Hi; pose proof (second_impact _ _ _ _ _ _ _ H2 i) as X; destruct (bend_slope _ _ _ _ _ h
    (X Hi) ltac:(lra)) as (r & Hr & X'); exists r; split; [exact Hr | exact X']. }
  destruct (two_least rh ri Rh Ri) as (r & Hr & R1 & R2), (within_exists N w) as (W & HW & Bw), (within_exists N U) as
    (u & Hu & Bu).
  destruct (Curve M w V e n HM) as (dc & Hdc & Cv); trivial; [intros i Hi; apply HVU, Hi|].
  destruct (curve_slope _ _ _ _ _ _ Cv (r / (1 + W))) as (rs & Rs & Slope); [apply Rdiv_lt_0_compat; lra|].
  destruct (small_enough r (2 * u) Hr ltac:(lra)) as (y1 & Hy1 & L3), (two_least rs y1 Rs ltac:(lra)) as (y2 & Hy2 & L4
    & L5), (two_least r y2 Hr Hy2) as (y3 & Hy3 & L6 & L7).
  destruct (there M w n h1 y3 HM Hw ltac:(lra) Hy3) as (d1 & d2 & rho & Hd & HR & Hrho & There).
  destruct (two_least dc d2 Hdc ltac:(lra)) as (d & Hd0 & D1 & D2); exists d; split; [exact Hd0|].
  intros mu x c q P Hmu Ho y HS D; destruct (orbit_clear M unit (fun j => j) (fun _ => n) mu d x tt (fun _ => Hn) Ho) as
    (cl & Hcl & Cl). destruct (Ho tt) as (Hx & Hf & _).
  assert (Ey : y = speed_at M mu n (x tt)) by (unfold y, speed_of, speed_at; rewrite (heights M mu (x tt) n Hf) by lia;
    replace (S (n - 1)) with n by lia; reflexivity).
  assert (Near : forall p, within N (rho cl) (minus p (x tt)) -> slow M n y3 d1 mu n p /\ forall i, (i < N)%nat ->
    Nat.iter n (step M mu) p i = go M mu n p i).
  { intros p Hp; destruct (There n mu (x tt) cl p) as (S1 & _ & S2); trivial; try lia; try lra; [apply
    (within_le _ d); [lra | exact Hx] | auto]. }
  specialize (Hrho cl Hcl); destruct (Near (x tt)) as [Sx Gx]; [intros i _; unfold minus; rewrite Rminus_eq_0, Rabs_R0;
    lra|].
  pose proof (slow_near _ _ _ _ _ _ _ Sx) as Nx; pose proof (slow_hits _ _ _ _ _ _ _ Sx) as Hx0; destruct (slow_speed _
    _ _ _ _ _ _ Sx) as [Sy Sy']; rewrite <- Ey in Sy, Sy'.
  assert (Yy : y * y = - Map.h M (fly M mu n (x tt)) mu) by (rewrite Ey; apply sqrt_sqrt; lra).
  assert (Py : 0 < y) by (rewrite Ey; apply sqrt_lt_R0; lra).
  (* to the first order *) assert (One : forall e' t, (forall j, (j < N)%nat -> Rabs (e' j) <= 1) -> 0 < t <= rho cl ->
    let p := comb 1 t (x tt) e' in within N d1 p /\ within N t (minus p (x tt)) /\ minus p (x tt) = comb t 0 e' e').
  { intros e' t H1 Ht p; assert (E : minus p (x tt) = comb t 0 e' e') by (extensionality j; unfold p, minus, comb;
    ring).
    assert (Wt : within N t (minus p (x tt))).
    { rewrite E; intros j Hj; unfold comb; replace (t * e' j + 0 * e' j) with (t * e' j) by ring; rewrite Rabs_mult,
      (Rabs_pos_eq t) by lra. rewrite <- (Rmult_1_r t) at 2; apply Rmult_le_compat_l; [lra | apply H1, Hj]. }
    split; [|auto]; destruct (Near p) as [Sp _]; [apply (within_le _ t); [lra | exact Wt]|]; pose proof (slow_near _ _ _
      _ _ _ _ Sp) as X; exact X. }
  assert (First : forall e', (forall j, (j < N)%nat -> Rabs (e' j) <= 1) -> Rabs (dot N c e' - cA e') <= h1 /\ forall i,
    (i < N)%nat -> Rabs (dot N (P i) e' - power M n e' i) <= h1).
  { intros e' H1; assert (Rx : forall t, 0 < t <= rho cl -> let p := comb 1 t (x tt) e' in Rabs (Map.h M (fly M mu n p)
    mu - Map.h M (fly M mu n (x tt)) mu - t * cA e') <= h1 * t /\ forall i, (i < N)%nat -> Rabs ((fly M mu n p i + kick
    M (fly M mu n p) y mu i * y) - (fly M mu n (x tt) i + kick M (fly M mu n (x tt)) y mu i * y) - t * power M n e' i)
    <= h1 * t).
    { intros t Ht p; destruct (One e' t H1 Ht) as (O1 & O2 & O3); fold p in O1, O2, O3.
      destruct (HR n p (x tt) y y mu mu t) as (B1 & _ & B3); trivial; try (rewrite ?Rminus_eq_0, ?Rabs_R0;
        lra); try (rewrite Rabs_pos_eq; lra); try lra. unfold cA, power in *; fold N in B1, B3 |- *.
      assert (Ep : forall v, Nat.iter n (mult N (Map.A M)) (comb t 0 v v) = comb t 0 (Nat.iter n (mult N (Map.A M)) v)
        (Nat.iter n (mult N (Map.A M)) v)) by (intros v; apply power_comb).
      split; [rewrite O3, Ep, dot_comb in B3; ResonanceCurve.same_as B3|]; intros i Hi; specialize (B1 i Hi); unfold
        rest1, power in B1; rewrite (Rabs_pos_eq y) in B1 by lra.
      assert (Ei : Nat.iter n (mult N (Map.A M)) p i - Nat.iter n (mult N (Map.A M)) (x tt) i = t * Nat.iter n (mult N
        (Map.A M)) e' i) by (change (minus (Nat.iter n (mult N (Map.A M)) p) (Nat.iter n (mult N (Map.A M)) (x tt)) i =
        t * Nat.iter n (mult N (Map.A M)) e' i); rewrite <- power_minus, O3, Ep; unfold comb; ring).
      rewrite <- Ei; fold N in B1; ResonanceCurve.same_as B1. }
    destruct HS as [SH SI]; split.
    - pose proof (quotient _ _ _ _ _ _ 0 e' (cA e') h1 0 (rho cl) SH Hrho (Rle_refl 0)) as X; rewrite Rmult_0_l,
      Rplus_0_l in X; apply X; intros t Ht; rewrite Rmult_0_l, Rplus_0_r; apply (Rx t Ht).
    - intros i Hi; pose proof (quotient _ _ _ _ _ _ 0 e' (power M n e' i) h1 0 (rho cl) (SI i Hi) Hrho (Rle_refl 0)) as
      X; rewrite Rmult_0_l, Rplus_0_l in X; apply X; intros t Ht; replace (y + t * 0) with y by ring; replace (h1 + 0 *
      t) with h1 by ring; apply (Rx t Ht), Hi. }
  (* to the second, in the direction v *) destruct (Slope mu x ltac:(lra)) as [S1 S2].
  { intros []; destruct (Ho tt) as [_ Y]; split; [apply (within_le _ d); [lra | exact Hx] | exact Y]. }
  { fold y; lra. }
  fold y in S1, S2; rewrite V0 in *; replace (mu + 0 / e * y) with mu in S1 by (field; exact Ne).
  assert (Ra : r / (1 + W) * y * (1 + W) = r * y) by (field; lra); assert (Rp : 0 <= r / (1 + W) * y) by (apply
    Rmult_le_pos; [left; apply Rdiv_lt_0_compat|]; lra). assert (Rw : 0 <= r / (1 + W) * y * W) by (apply Rmult_le_pos;
    lra).
  assert (Bes : beside N V r y mu (x tt)).
  { split; rewrite (Rabs_pos_eq y) by lra; [lra|]; intros i Hi; specialize (S2 i Hi); cbv beta in S2.
    replace (x tt i - y * V i) with ((x tt i - mu * w i - y * V i) + mu * w i) by ring.
    apply Rle_trans with (r / (1 + W) * y + r / (1 + W) * y * W); [apply triangle2; [exact S2 | apply Rabs_mult_le;
      [exact S1 | apply Bw, Hi]] | lra]. }
  set (v := comb 1 (2 * y) V U); assert (Bv : within N r (minus v V)).
  { intros i Hi; unfold minus, v, comb; replace (1 * V i + 2 * y * U i - V i) with (2 * y * U i) by ring; apply
    Rle_trans with (2 * y * u); [apply Rabs_mult_le; [rewrite Rabs_pos_eq; lra | apply Bu, Hi]|].
    apply Rle_trans with (2 := L3); assert (2 * u * y <= 2 * u * y1) by (apply Rmult_le_compat_l; lra); lra. }
  assert (Pv : forall t, power M n (minus (comb 1 t (x tt) v) (x tt)) = comb t 0 (power M n v) (power M n v)).
  { intros t; unfold power; rewrite <- power_comb; f_equal; extensionality i; unfold minus, comb; ring. }
  assert (Av : power M n v = comb 1 (2 * y) (power M n V) (power M n U)) by apply power_comb.
  pose proof HS as HS'; destruct HS' as [SH SI].
  assert (Down : forall a, r <= a -> beside N V a y mu (x tt) /\ within N a (minus v V)).
  { intros a Ha; destruct Bes as [X1 X2]; assert (r * Rabs y <= a * Rabs y) by (apply Rmult_le_compat_r; [apply Pl |
    lra]); split; [split; [lra | apply (within_le _ (r * Rabs y)); assumption] | apply (within_le _ r); assumption]. }
  destruct (Down rh R1) as [X1 X2], (Down ri R2) as [X3 X4].
  pose proof (BH y mu (x tt) v 0 c (across M v n) ltac:(lra) X1 X2) as Bh.
  assert (Bc : Rabs (dot N c v + 2 * y * (1 + e * K)) <= h * y).
  { replace (dot N c v + 2 * y * (1 + e * K)) with (0 + dot N c v - (across M v n + 2 * y * Qh)).
    - apply Bh; [|exact SH]; intros t; unfold across; rewrite Pv, dot_comb; ring.
    - assert (Ea : across M v n = across M V n + 2 * y * across M U n) by (unfold across; rewrite Av, dot_comb; ring).
      rewrite Ea, V0; unfold K; field; exact Ne. }
  assert (Bq : forall i, (i < N)%nat -> Rabs (q i - (v i - dot N (P i) v)) <= h * y).
  { intros i Hi; replace (q i - (v i - dot N (P i) v)) with (q i + dot N (P i) v - (power M n v i + B M i + 2 * y * Q
    i)).
    - apply (BI i Hi y mu (x tt) v); trivial; [lra | | apply SI, Hi]; intros t; rewrite Pv; unfold comb; ring.
    - rewrite Av; destruct (HVU i Hi) as [EV EU]; generalize (dot N (P i) v); intros z; unfold v, comb; rewrite EV, EU;
      ring. }
  assert (F0 : forall j, (j < N)%nat -> Rabs (c j - cA (axis j)) <= h1 /\ forall i, (i < N)%nat -> Rabs (P i j - power M
    n (axis j) i) <= h1).
  { intros j Hj; destruct (First (axis j)) as [X Y]; [apply within_axis|]; rewrite dot_axis in X by exact Hj; split;
    [exact X|]; intros i Hi; specialize (Y i Hi); rewrite dot_axis in Y by exact Hj; exact Y. }
  split; [|split; [|apply real_multiplier]].
  { rewrite Ey in HS |- *; apply step_slopes with (n := n); rewrite <- ?Ey; trivial; [lra | rewrite Ey; exact HS|].
    exists (rho cl); split; [exact Hrho|]; intros p Hp; destruct (Near p Hp) as [Sp Gp]; split; [apply Sp | exact Gp]. }
  assert (B1 : forall j, within N ma (power M n (axis j))) by (intros j; rewrite <- (Rmult_1_r ma);
    apply BA; [lia | lra | apply within_axis]).
  apply Rle_trans with (m * h + Rabs (e * K) * m * h1); [|lra]; apply (Alg P (fun j => minus (axis j) (power M n (axis
    j))) c q v); trivial; try lra.
  - apply Rle_trans with (1 * 1); [apply Rmult_le_compat; lra | unfold l; lra].
  - intros j Hj; destruct (F0 j Hj) as [X _]; apply from in X; pose proof (BC _ _ (B1 j)); unfold cA in X.
    unfold l; lra.
  - intros j i Hj Hi; destruct (F0 j Hj) as [_ X]; specialize (X i Hi); pose proof (B1 j i Hi) as Y; pose proof
      (within_axis N j i Hi) as Z; unfold minus. pose proof (apart (axis j i) (power M n (axis j) i)); pose proof
      (from _ _ _ X); pose proof (apart (axis j i) (P i j)); split; [unfold l; lra | split; [unfold l; lra|]].
    replace (_ - _) with (- (P i j - power M n (axis j) i)) by ring; rewrite Rabs_Ropp; exact X.
Qed.
