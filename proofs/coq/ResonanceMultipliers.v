(** * det (I - M) near a boundary where Theorem 1 is silent, in the plane *)
From Coq Require Import Reals FunctionalExtensionality Lra Lia.
From Grazing Require Import StatementOrbits StatementUnstable StatementResonance StatementMultipliers.
From Grazing Require Import Derivatives Finite OrbitVectors Contraction OrbitRemainder Orbits OrbitsNear ResonanceMaps.
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

(** ** Two by two *)
Lemma algebra p00 p01 p10 p11 q0 q1 c0 c1 v0 v1 y k l h : 0 < y -> 0 <= h -> 1 <= l ->
  Rabs (q0 - (v0 - (p00 * v0 + p01 * v1))) <= h * y -> Rabs (q1 - (v1 - (p10 * v0 + p11 * v1))) <= h * y ->
  Rabs (c0 * v0 + c1 * v1 + 2 * y * (1 + k)) <= h * y -> Rabs (1 - p00) <= l -> Rabs p01 <= l -> Rabs p10 <= l ->
  Rabs (1 - p11) <= l -> Rabs c0 <= l -> Rabs c1 <= l -> Rabs ((1 - (p00 - q0 * c0 / (2 * y))) * (1 - (p11 - q1 * c1 /
  (2 * y))) - (p01 - q0 * c1 / (2 * y)) * (p10 - q1 * c0 / (2 * y)) + k * ((1 - p00) * (1 - p11) - p01 * p10)) <= 3 *
  (l * l) * h.
Proof.
  intros Hy Hh Hl B0 B1 Bc X0 X1 X2 X3 C0 C1; set (r0 := q0 - _) in B0; set (r1 := q1 - _) in B1; set (rc := _ + _ + _)
    in Bc. match goal with |- Rabs ?g <= _ => replace g with ((((1 - p00) * (1 - p11) * rc - p01 * p10 * rc) + ((1 -
    p11) * c0 * r0 + p01 * c0 * r1) + (p10 * c1 * r0 + (1 - p00) * c1 * r1)) / (2 * y)) by (unfold r0, r1, rc; field;
    lra) end.
  unfold Rdiv; rewrite Rabs_mult, (Rabs_pos_eq (/ (2 * y))) by (left; apply Rinv_0_lt_compat; lra).
  apply Rmult_le_reg_r with (2 * y); [lra|]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  replace (3 * (l * l) * h * (2 * y)) with (2 * (l * l * (h * y)) + 2 * (l * l * (h * y)) + 2 * (l * l * (h * y))) by
    ring.
  assert (T : forall a b r, Rabs a <= l -> Rabs b <= l -> Rabs r <= h * y -> - (l * l * (h * y)) <= a * b * r <= l * l *
    (h * y)) by (intros; apply le_abs, product; [apply product; assumption | assumption]).
  pose proof (T _ _ _ X0 X3 Bc); pose proof (T _ _ _ X1 X2 Bc); pose proof (T _ _ _ X3 C0 B0); pose proof (T _ _ _ X1 C0
    B1). pose proof (T _ _ _ X2 C1 B0); pose proof (T _ _ _ X0 C1 B1); apply Rabs_le; lra.
Qed.
Lemma det_near p00 p01 p10 p11 a00 a01 a10 a11 l h : Rabs (1 - p00) <= l -> Rabs p01 <= l -> Rabs (1 - a11) <= l ->
  Rabs a10 <= l -> Rabs (p00 - a00) <= h -> Rabs (p01 - a01) <= h -> Rabs (p10 - a10) <= h -> Rabs (p11 - a11) <= h ->
  Rabs ((1 - p00) * (1 - p11) - p01 * p10 - ((1 - a00) * (1 - a11) - a01 * a10)) <= 4 * l * h.
Proof.
  intros P0 P1 A1 A2 D0 D1 D2 D3; pose proof (product _ _ _ _ P0 D3) as E1; pose proof (product _ _ _ _ A1 D0) as E2.
  pose proof (product _ _ _ _ P1 D2) as E3; pose proof (product _ _ _ _ A2 D1) as E4; apply le_abs in E1, E2, E3, E4;
    apply Rabs_le; lra.
Qed.
Lemma real_multiplier D : det_less (mult 2 D) < 0 -> exists lambda v, 1 < lambda /\ (exists i, (i < 2)%nat /\ v i <> 0)
  /\ forall i, (i < 2)%nat -> mult 2 D v i = lambda * v i.
Proof.
  unfold det_less, mult; cbn; set (a := D 0%nat 0%nat); set (b := D 0%nat 1%nat); set (c := D 1%nat 0%nat); set (d := D
    1%nat 1%nat); intros H; set (t := a + d); set (z := (a - d) ^ 2 + 4 * (b * c)).
  assert (Z : (t - 2) ^ 2 < z) by (unfold t, z; lra); pose proof (pow2_ge_0 (t - 2)); set (s := sqrt z).
  assert (Es : s * s = z) by (apply sqrt_sqrt; lra); assert (S0 : 0 <= s) by apply sqrt_pos.
  assert (S1 : 2 - t < s) by (apply Rnot_le_lt; intros F; nra); set (e := (t + s) / 2); exists e.
  assert (Ce : (e - a) * (e - d) = b * c) by (unfold e, t, z in *; nra); assert (He : 1 < e) by (unfold e; lra).
  assert (W : forall x y, (x <> 0 \/ y <> 0) -> a * x + b * y = e * x -> c * x + d * y = e * y -> exists v, 1 < e /\
    (exists i, (i < 2)%nat /\ v i <> 0) /\ forall i, (i < 2)%nat -> 0 + D i 0%nat * v 0%nat + D i 1%nat * v 1%nat = e *
    v i).
  { intros x y N E0 E1; exists (fun i => if Nat.eqb i 0 then x else y); split; [exact He | split].
    - destruct N as [N|N]; [exists 0%nat | exists 1%nat]; split; trivial; lia.
    - intros [|[|i]] Hi; [| |lia]; cbn; fold a b c d; lra. }
  destruct (Req_dec b 0) as [B|B]; [|apply (W b (e - a)); [auto | ring | lra]].
  destruct (Req_dec (e - d) 0) as [A|A]; [apply (W 0 1); [right; lra | rewrite B; ring | lra]|].
  apply (W (e - d) c); [auto | | ring]; assert (X : (e - a) * (e - d) = 0) by (rewrite Ce, B; ring); rewrite B.
  apply Rmult_integral in X; destruct X as [X|X]; [|contradiction]; replace e with a by lra; ring.
Qed.

Theorem Determinant : Determinant_statement.
Proof.
  intros M w V U e n Qh Q HM E2 N Hw He Ne Hn Hdet HVU H2 V0 K eps Heps; subst N; rewrite E2 in *.
  set (e0 := fun j => if Nat.eqb j 0 then 1 else 0); set (e1 := fun j => if Nat.eqb j 0 then 0 else 1).
  set (A i j := power M n j i); set (cA v := dot 2 (C M) (power M n v)).
  set (l := 2 + Rabs (A 0%nat e0) + Rabs (A 0%nat e1) + Rabs (A 1%nat e0) + Rabs (A 1%nat e1) + Rabs (cA e0) + Rabs (cA
    e1)). assert (Pl : forall x, 0 <= Rabs x) by apply Rabs_pos; assert (Hl : 2 <= l).
  { pose proof (Pl (A 0%nat e0)); pose proof (Pl (A 0%nat e1)); pose proof (Pl (A 1%nat e0)); pose proof (Pl (A 1%nat
    e1)); pose proof (Pl (cA e0)); pose proof (Pl (cA e1)); unfold l; lra. }
  destruct (small_enough (eps / 2) (3 * (l * l)) ltac:(lra) ltac:(nra)) as (h & Hh & L1).
  destruct (small_enough (eps / 2) (Rabs (e * K) * (4 * l))) as (h1 & Hh1 & L2); [lra | apply Rmult_le_pos; [apply Pl |
    lra]|].
  destruct (bend_slope _ _ _ _ _ h (second_height _ _ _ _ _ _ _ H2) ltac:(lra)) as (rh & Rh & BH).
  destruct (common_bound (fun i r => forall y mu x v q p l, 0 < y <= r -> beside 2 V r y mu x -> within 2 r (minus v V)
    -> (forall t, power M n (minus (comb 1 t x v) x) i + (y + t - y) * B M i + (mu - mu) * (w i - power M n w i) = t *
    l) -> slopes 2 (fun y x => let z := Nat.iter n (fun x => f M x mu) x in z i + kick M z y mu i * y) y x q p -> Rabs
    (q + dot 2 p v - (l + 2 * y * Q i)) <= h * y) 2) as (ri & Ri & BI).
  { intros i a a' H Ha y mu x v q p g Hy [X1 X2] Hv; apply H; [lra | | apply (within_le _ a'); [lra | exact Hv]].
    assert (a' * Rabs y <= a * Rabs y) by (apply Rmult_le_compat_r; [apply Pl | lra]); split; [lra | apply (within_le _
      (a' * Rabs y)); assumption]. }
  { intros i Hi; pose proof (second_impact _ _ _ _ _ _ _ H2 i) as X; rewrite E2 in X; destruct (bend_slope _ _ _ _ _ h
    (X Hi) ltac:(lra)) as (r & Hr & X'); exists r; split; [exact Hr | exact X']. }
  destruct (two_least rh ri Rh Ri) as (r & Hr & R1 & R2), (within_exists 2 w) as (W & HW & Bw), (within_exists 2 U) as
    (u & Hu & Bu).
  destruct (Curve M w V e n HM) as (dc & Hdc & Cv); rewrite ?E2; trivial; [intros i Hi; apply HVU, Hi|].
  destruct (curve_slope _ _ _ _ _ _ Cv (r / (1 + W))) as (rs & Rs & Slope); [apply Rdiv_lt_0_compat; lra|].
  destruct (small_enough r (2 * u) Hr ltac:(lra)) as (y1 & Hy1 & L3), (two_least rs y1 Rs ltac:(lra)) as (y2 & Hy2 & L4
    & L5), (two_least r y2 Hr Hy2) as (y3 & Hy3 & L6 & L7).
  destruct (there M w n h1 y3 HM ltac:(rewrite E2; exact Hw) ltac:(lra) Hy3) as (d1 & d2 & rho & Hd & HR & Hrho &
    There).
  destruct (two_least dc d2 Hdc ltac:(lra)) as (d & Hd0 & D1 & D2); exists d; split; [exact Hd0|].
  intros mu x c q P Hmu Ho y HS D; destruct (orbit_clear M unit (fun j => j) (fun _ => n) mu d x tt (fun _ => Hn) Ho) as
    (cl & Hcl & Cl). destruct (Ho tt) as (Hx & Hf & _); rewrite E2 in Hx.
  assert (Ey : y = speed_at M mu n (x tt)) by (unfold y, speed_of, speed_at; rewrite (heights M mu (x tt) n Hf) by lia;
    replace (S (n - 1)) with n by lia; reflexivity).
  assert (Near : forall p, within 2 (rho cl) (minus p (x tt)) -> slow M n y3 d1 mu n p /\ forall i, (i < 2)%nat ->
    Nat.iter n (step M mu) p i = go M mu n p i).
  { intros p Hp; destruct (There n mu (x tt) cl p) as (S1 & _ & S2); trivial; try lia; try lra; rewrite ?E2 in *; [apply
    (within_le _ d); [lra | exact Hx] | exact Hp | auto]. }
  specialize (Hrho cl Hcl); destruct (Near (x tt)) as [Sx Gx]; [intros i _; unfold minus; rewrite Rminus_eq_0, Rabs_R0;
    lra|].
  pose proof (slow_near _ _ _ _ _ _ _ Sx) as Nx; pose proof (slow_hits _ _ _ _ _ _ _ Sx) as Hx0; destruct (slow_speed _
    _ _ _ _ _ _ Sx) as [Sy Sy']; rewrite <- Ey in Sy, Sy'; rewrite E2 in Nx.
  assert (Yy : y * y = - Map.h M (fly M mu n (x tt)) mu) by (rewrite Ey; apply sqrt_sqrt; lra).
  assert (Py : 0 < y) by (rewrite Ey; apply sqrt_lt_R0; lra).
  (* to the first order *) assert (One : forall e' t, (forall j, (j < 2)%nat -> Rabs (e' j) <= 1) -> 0 < t <= rho cl ->
    let p := comb 1 t (x tt) e' in within 2 d1 p /\ within 2 t (minus p (x tt)) /\ minus p (x tt) = comb t 0 e' e').
  { intros e' t H1 Ht p; assert (E : minus p (x tt) = comb t 0 e' e') by (extensionality j; unfold p, minus, comb;
    ring).
    assert (Wt : within 2 t (minus p (x tt))).
    { rewrite E; intros j Hj; unfold comb; replace (t * e' j + 0 * e' j) with (t * e' j) by ring; rewrite Rabs_mult,
      (Rabs_pos_eq t) by lra. rewrite <- (Rmult_1_r t) at 2; apply Rmult_le_compat_l; [lra | apply H1, Hj]. }
    split; [|auto]; destruct (Near p) as [Sp _]; [apply (within_le _ t); [lra | exact Wt]|]; pose proof (slow_near _ _ _
      _ _ _ _ Sp) as X; rewrite E2 in X; exact X. }
  assert (First : forall e', (forall j, (j < 2)%nat -> Rabs (e' j) <= 1) -> Rabs (dot 2 c e' - cA e') <= h1 /\ forall i,
    (i < 2)%nat -> Rabs (dot 2 (P i) e' - power M n e' i) <= h1).
  { intros e' H1; assert (Rx : forall t, 0 < t <= rho cl -> let p := comb 1 t (x tt) e' in Rabs (Map.h M (fly M mu n p)
    mu - Map.h M (fly M mu n (x tt)) mu - t * cA e') <= h1 * t /\ forall i, (i < 2)%nat -> Rabs ((fly M mu n p i + kick
    M (fly M mu n p) y mu i * y) - (fly M mu n (x tt) i + kick M (fly M mu n (x tt)) y mu i * y) - t * power M n e' i)
    <= h1 * t).
    { intros t Ht p; destruct (One e' t H1 Ht) as (O1 & O2 & O3); fold p in O1, O2, O3.
      destruct (HR n p (x tt) y y mu mu t) as (B1 & _ & B3); rewrite ?E2; trivial; try (rewrite ?Rminus_eq_0, ?Rabs_R0;
        lra); try (rewrite Rabs_pos_eq; lra); try lra. unfold cA, power in *; rewrite E2 in *.
      assert (Ep : forall v, Nat.iter n (mult 2 (Map.A M)) (comb t 0 v v) = comb t 0 (Nat.iter n (mult 2 (Map.A M)) v)
        (Nat.iter n (mult 2 (Map.A M)) v)) by (intros v; apply power_comb).
      split; [rewrite O3, Ep, dot_comb in B3; ResonanceCurve.same_as B3|]; intros i Hi; specialize (B1 i Hi); unfold
        rest1, power in B1; rewrite E2, (Rabs_pos_eq y) in B1 by lra.
      assert (Ei : Nat.iter n (mult 2 (Map.A M)) p i - Nat.iter n (mult 2 (Map.A M)) (x tt) i = t * Nat.iter n (mult 2
        (Map.A M)) e' i) by (change (minus (Nat.iter n (mult 2 (Map.A M)) p) (Nat.iter n (mult 2 (Map.A M)) (x tt)) i =
        t * Nat.iter n (mult 2 (Map.A M)) e' i); rewrite <- power_minus, O3, Ep; unfold comb; ring).
      rewrite <- Ei; ResonanceCurve.same_as B1. }
    destruct HS as [SH SI]; rewrite E2 in SH, SI; split.
    - pose proof (quotient _ _ _ _ _ _ 0 e' (cA e') h1 0 (rho cl) SH Hrho (Rle_refl 0)) as X; rewrite Rmult_0_l,
      Rplus_0_l in X; apply X; intros t Ht; rewrite Rmult_0_l, Rplus_0_r; apply (Rx t Ht).
    - intros i Hi; pose proof (quotient _ _ _ _ _ _ 0 e' (power M n e' i) h1 0 (rho cl) (SI i Hi) Hrho (Rle_refl 0)) as
      X; rewrite Rmult_0_l, Rplus_0_l in X; apply X; intros t Ht; replace (y + t * 0) with y by ring; replace (h1 + 0 *
      t) with h1 by ring; apply (Rx t Ht), Hi. }
  (* to the second, in the direction v *) destruct (Slope mu x ltac:(lra)) as [S1 S2].
  { intros []; destruct (Ho tt) as [_ Y]; split; [rewrite E2; apply (within_le _ d); [lra | exact Hx] | exact Y]. }
  { fold y; lra. }
  fold y in S1, S2; rewrite V0, E2 in *; replace (mu + 0 / e * y) with mu in S1 by (field; exact Ne).
  assert (Ra : r / (1 + W) * y * (1 + W) = r * y) by (field; lra); assert (Rp : 0 <= r / (1 + W) * y) by (apply
    Rmult_le_pos; [left; apply Rdiv_lt_0_compat|]; lra). assert (Rw : 0 <= r / (1 + W) * y * W) by (apply Rmult_le_pos;
    lra).
  assert (Bes : beside 2 V r y mu (x tt)).
  { split; rewrite (Rabs_pos_eq y) by lra; [lra|]; intros i Hi; specialize (S2 i Hi); cbv beta in S2.
    replace (x tt i - y * V i) with ((x tt i - mu * w i - y * V i) + mu * w i) by ring.
    apply Rle_trans with (r / (1 + W) * y + r / (1 + W) * y * W); [apply triangle2; [exact S2 | apply Rabs_mult_le;
      [exact S1 | apply Bw, Hi]] | lra]. }
  set (v := comb 1 (2 * y) V U); assert (Bv : within 2 r (minus v V)).
  { intros i Hi; unfold minus, v, comb; replace (1 * V i + 2 * y * U i - V i) with (2 * y * U i) by ring; apply
    Rle_trans with (2 * y * u); [apply Rabs_mult_le; [rewrite Rabs_pos_eq; lra | apply Bu, Hi]|].
    apply Rle_trans with (2 := L3); assert (2 * u * y <= 2 * u * y1) by (apply Rmult_le_compat_l; lra); lra. }
  assert (Pv : forall t, power M n (minus (comb 1 t (x tt) v) (x tt)) = comb t 0 (power M n v) (power M n v)).
  { intros t; unfold power; rewrite <- power_comb; f_equal; extensionality i; unfold minus, comb; ring. }
  assert (Av : power M n v = comb 1 (2 * y) (power M n V) (power M n U)) by apply power_comb.
  pose proof HS as HS'; destruct HS' as [SH SI]; rewrite E2 in SH, SI.
  assert (Down : forall a, r <= a -> beside 2 V a y mu (x tt) /\ within 2 a (minus v V)).
  { intros a Ha; destruct Bes as [X1 X2]; assert (r * Rabs y <= a * Rabs y) by (apply Rmult_le_compat_r; [apply Pl |
    lra]); split; [split; [lra | apply (within_le _ (r * Rabs y)); assumption] | apply (within_le _ r); assumption]. }
  destruct (Down rh R1) as [X1 X2], (Down ri R2) as [X3 X4].
  rewrite ?E2 in BH; pose proof (BH y mu (x tt) v 0 c (across M v n) ltac:(lra) X1 X2) as Bh.
  assert (Bc : Rabs (dot 2 c v + 2 * y * (1 + e * K)) <= h * y).
  { replace (dot 2 c v + 2 * y * (1 + e * K)) with (0 + dot 2 c v - (across M v n + 2 * y * Qh)).
    - apply Bh; [|exact SH]; intros t; unfold across; rewrite Pv, E2, dot_comb; ring.
    - assert (Ea : across M v n = across M V n + 2 * y * across M U n) by (unfold across; rewrite Av, dot_comb; ring).
      rewrite Ea, V0; unfold K; field; exact Ne. }
  assert (Bq : forall i, (i < 2)%nat -> Rabs (q i - (v i - dot 2 (P i) v)) <= h * y).
  { intros i Hi; replace (q i - (v i - dot 2 (P i) v)) with (q i + dot 2 (P i) v - (power M n v i + B M i + 2 * y * Q
    i)).
    - apply (BI i Hi y mu (x tt) v); trivial; [lra | | apply SI, Hi]; intros t; rewrite Pv; unfold comb; ring.
    - rewrite Av; destruct (HVU i Hi) as [EV EU]; generalize (dot 2 (P i) v); intros z; unfold v, comb; rewrite EV, EU;
      ring. }
  assert (I0 : forall j, (j < 2)%nat -> Rabs (e0 j) <= 1 /\ Rabs (e1 j) <= 1) by (intros j _; unfold e0, e1; destruct
    (Nat.eqb j 0); rewrite ?Rabs_R0, ?Rabs_R1; lra).
  destruct (First e0 (fun j Hj => proj1 (I0 j Hj))) as [Fc0 F0], (First e1 (fun j Hj => proj2 (I0 j Hj))) as [Fc1 F1].
  split; [|split; [|apply real_multiplier]].
  { rewrite Ey in HS |- *; rewrite <- E2; apply step_slopes with (n := n); rewrite <- ?Ey, ?E2; trivial; [lra | rewrite
    Ey; exact HS|]; exists (rho cl); split; [exact Hrho|]; intros p Hp; destruct (Near p Hp) as [Sp Gp]; split; [apply
    Sp | exact Gp]. }
  assert (Ee : forall b, dot 2 b e0 = b 0%nat /\ dot 2 b e1 = b 1%nat) by (intros b; unfold e0, e1; cbn; split; ring).
  assert (Lm : forall z b, Rabs (z - b) <= h1 -> Rabs b <= l - 2 -> Rabs z <= l /\ Rabs (1 - z) <= l).
  { intros z b Z1 Z2; apply le_abs in Z1, Z2; split; apply Rabs_le; lra. }
  pose proof (Pl (A 0%nat e0)); pose proof (Pl (A 0%nat e1)); pose proof (Pl (A 1%nat e0)); pose proof (Pl (A 1%nat
    e1)).
  pose proof (Pl (cA e0)); pose proof (Pl (cA e1)); pose proof (F0 0%nat ltac:(lia)) as F00; pose proof (F1 0%nat
    ltac:(lia)) as F01; pose proof (F0 1%nat ltac:(lia)) as F10; pose proof (F1 1%nat ltac:(lia)) as F11.
  rewrite ?(proj1 (Ee _)), ?(proj2 (Ee _)) in *.
  destruct (Lm _ _ F00) as [G0 G1]; [change (power M n e0 0%nat) with (A 0%nat e0); unfold l; lra|].
  destruct (Lm _ _ F01) as [G2 G3]; [change (power M n e1 0%nat) with (A 0%nat e1); unfold l; lra|].
  destruct (Lm _ _ F10) as [G4 G5]; [change (power M n e0 1%nat) with (A 1%nat e0); unfold l; lra|].
  destruct (Lm _ _ F11) as [G6 G7]; [change (power M n e1 1%nat) with (A 1%nat e1); unfold l; lra|].
  destruct (Lm _ _ Fc0) as [G8 _]; [unfold l; lra|]; destruct (Lm _ _ Fc1) as [G9 _]; [unfold l; lra|].
  cbn [dot] in Bc, Bq; rewrite Rplus_0_l in Bc; pose proof (Bq 0%nat ltac:(lia)) as Q0; pose proof (Bq 1%nat ltac:(lia))
    as Q1; rewrite Rplus_0_l in Q0, Q1.
  pose proof (algebra _ _ _ _ _ _ _ _ _ _ y (e * K) l h Py ltac:(lra) ltac:(lra) Q0 Q1 Bc G1 G2 G4 G7 G8 G9) as B1.
  assert (Ga : Rabs (1 - power M n e1 1%nat) <= l /\ Rabs (power M n e0 1%nat) <= l).
  { change (power M n e1 1%nat) with (A 1%nat e1); change (power M n e0 1%nat) with (A 1%nat e0); split; [|unfold l;
    lra]. eapply Rle_trans; [apply apart|]; rewrite Rabs_R1; unfold l; lra. }
  pose proof (det_near _ _ _ _ _ _ _ _ l h1 G1 G2 (proj1 Ga) (proj2 Ga) F00 F01 F10 F11) as B2.
  apply (Rmult_le_compat_l (Rabs (e * K))) in B2; [|apply Pl]; rewrite <- Rabs_mult in B2.
  assert (ED : det_less D = (1 - (P 0%nat 0%nat - q 0%nat * c 0%nat / (2 * y))) * (1 - (P 1%nat 1%nat - q 1%nat * c
    1%nat / (2 * y))) - (P 0%nat 1%nat - q 0%nat * c 1%nat / (2 * y)) * (P 1%nat 0%nat - q 1%nat * c 0%nat / (2 * y)))
    by (unfold det_less, D, mult, monodromy; cbn; field; lra).
  assert (EA : det_less (power M n) = (1 - power M n e0 0%nat) * (1 - power M n e1 1%nat) - power M n e1 0%nat * power M
    n e0 1%nat) by reflexivity.
  rewrite ED, EA; apply le_abs in B1, B2; apply Rabs_le; lra.
Qed.
