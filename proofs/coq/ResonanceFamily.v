(** * The fold of the curve of orbits with one impact, in a family of maps *)
From Coq Require Import Reals FunctionalExtensionality Lra Lia.
From Grazing Require Import StatementOrbits StatementResonance StatementFold Derivatives Finite OrbitVectors
  Contraction.
From Grazing Require Import OrbitRemainder Orbits PlaneLinear OrbitsNear ResonanceCurve ResonanceMaps ResonanceFold.
Open Scope R_scope.

(** ** The members, in the map that keeps nu *)
Lemma dot_rows N c x a b : dot (S N) (rows a c) (rows b x) = a * b + dot N c x.
Proof.
  induction N as [|N IH]; [cbn; ring|]; change (dot (S (S N)) (rows a c) (rows b x)) with (dot (S N) (rows a c) (rows b
  x) + c N * x N); rewrite IH; cbn [dot]; ring.
Qed.
Lemma dot_none N x : dot N zero x = 0.
Proof. induction N as [|N IH]; cbn; [reflexivity|]; rewrite IH; unfold zero; ring. Qed.
Section Members.
Variables (F : Family.t) (w : vec) (e : R).
Notation N := (Family.N F).
Notation member := (member F).
Hypothesis Hw : forall i, (i < N)%nat -> w i = mult N (Family.A F) w i + Family.phi F i.
Hypothesis He : e = dot N (Family.C F) w + Family.eta F.
Let W := StatementFold.whole F.
Variable rg : R.
Hypothesis HS : smooth W.
Hypothesis HZ : 0 < rg /\ forall nu x, Rabs nu <= rg -> (forall i, (i < N)%nat -> x i = 0) -> Family.h F nu x 0 = 0 /\
  forall i, (i < N)%nat -> Family.f F nu x 0 i = 0.
Lemma whole_fly nu mu k x : fly W mu k (rows nu x) = rows nu (fly (member nu) mu k x).
Proof.
  induction k as [|k IH]; [reflexivity|]; change (fly W mu (S k) (rows nu x)) with (Map.f W (fly W mu k (rows nu x))
    mu).
  rewrite IH; reflexivity.
Qed.
Lemma whole_power nu k x : power W k (rows nu x) = rows nu (power (member nu) k x).
Proof.
  induction k as [|k IH]; [reflexivity|].
  change (power W (S k) (rows nu x)) with (mult (S N) (Map.A W) (power W k (rows nu x))); rewrite IH.
  extensionality i; unfold mult; destruct i as [|i]; cbn [Map.A W StatementFold.whole]; rewrite dot_rows; cbn [rows];
    [rewrite dot_none; ring | rewrite Rmult_0_l, Rplus_0_l; reflexivity].
Qed.
Lemma whole_w i : (i < S N)%nat -> rows 0 w i = mult (S N) (Map.A W) (rows 0 w) i + Map.phi W i.
Proof.
  intros Hi; destruct i as [|i]; unfold mult; cbn [Map.A Map.phi W StatementFold.whole rows]; rewrite dot_rows; [rewrite
    dot_none; ring | rewrite Hw by lia; unfold mult; ring].
Qed.
Lemma whole_e : e = dot (S N) (Map.C W) (rows 0 w) + Map.eta W.
Proof. cbn [Map.C Map.eta W StatementFold.whole]; rewrite dot_rows, He; ring. Qed.
Lemma within_rows t nu x : Rabs nu <= t -> within N t x -> within (S N) t (rows nu x).
Proof. intros Hn Hx [|i] Hi; [exact Hn | apply Hx; lia]. Qed.
Lemma minus_rows nu x x' : minus (rows nu x) (rows nu x') = rows 0 (minus x x').
Proof. extensionality i; destruct i; unfold minus, rows; ring. Qed.
Lemma member_remainder n eps d nu : remainder W (rows 0 w) e n eps d -> Rabs nu <= d -> remainder (member nu) w e n eps
  d.
Proof.
  intros H Hnu k x x' y y' mu mu' t Hk Hx Hx' Hy Hy' Hm Hm' Ht Hyt Hmt; pose proof (Rabs_nonneg _ _ Hmt) as T0.
  destruct (H k (rows nu x) (rows nu x') y y' mu mu' t) as (A & B & C); trivial; try (apply within_rows; assumption).
  { rewrite minus_rows; apply within_rows; [rewrite Rabs_R0; exact T0 | exact Ht]. }
  unfold rest1, rest2 in *; rewrite minus_rows, !whole_fly, !whole_power in *; cbn [Map.C Map.N W StatementFold.whole]
    in B, C; rewrite !dot_rows, !Rmult_0_l, !Rplus_0_l in B, C; rewrite dot_rows, Rmult_0_l, Rplus_0_l in B.
  split; [intros i Hi; specialize (A (S i) (proj1 (Nat.succ_lt_mono _ _) Hi)); exact A | split; [exact B | exact C]].
Qed.
Lemma member_zeros nu : Rabs nu <= rg -> forall k, Map.h (member nu) (fly (member nu) 0 k zero) 0 = 0 /\ forall i, (i <
  N)%nat -> fly (member nu) 0 k zero i = 0.
Proof.
  intros Hnu k; assert (Z : forall i, (i < N)%nat -> fly (member nu) 0 k zero i = 0).
  { induction k as [|k IH]; [reflexivity|]; apply (proj2 HZ nu _ Hnu IH). }
  split; [apply (proj2 HZ nu _ Hnu Z) | exact Z].
Qed.
Lemma members_small n b : 0 <= b -> within N b w -> forall eps, 0 < eps -> exists d, 0 < d /\ forall nu d', Rabs nu <= d
  -> 0 < d' <= d -> small (member nu) w e n b eps d'.
Proof.
  intros Hb Wb eps Heps; destruct (remainder_exists W (rows 0 w) e HS whole_w whole_e n (eps / (1 +
    b))) as (d1 & Hd1 & Rem); [apply Rdiv_lt_0_compat; lra|]; destruct (small_enough d1 (1 + b)) as (d2 & Hd2 & D'), HZ
    as [Hg _]; try lra. destruct (two_least d2 rg ltac:(lra) Hg) as (d & Hd & L1 & L2).
  assert (D : (1 + b) * d <= d1) by (apply Rle_trans with (2 := D'), Rmult_le_compat_l; lra).
  exists d; split; [lra|]; intros nu d' Hnu Hd'; assert (d' <= d1 /\ d <= d1 /\ (1 + b) * d' <= (1 + b) * d) by (assert
    (0 <= b * d /\ 0 <= b * d') by (split; apply Rmult_le_pos; lra); repeat split; try lra; apply Rmult_le_compat_l;
      lra).
  apply small_of with (d1 := d1); trivial; try lra; [apply member_zeros; lra | apply member_remainder; [exact Rem |
    lra]].
Qed.
Lemma members_hit n : exists l d, 0 < d /\ 1 <= l /\ forall nu, Rabs nu <= d -> forall mu x t, 0 <= t <= d -> Rabs mu <=
  t -> within N t x -> Rabs (Map.h (member nu) (fly (member nu) mu n x) mu) <= l * t.
Proof.
  destruct (Lipschitz_fly W (rows 0 w) e HS whole_w whole_e n) as (l & d1 & Hl & Hd1 & Lip), HZ as [Hg _].
  destruct (two_least d1 rg Hd1 Hg) as (d & Hd & L1 & L2); exists l, d; split; [exact Hd | split; [exact Hl|]]; intros
    nu Hnu mu x t Ht Hmu Hx.
  assert (Z : within (S N) d1 (rows nu zero)) by (apply within_rows; [lra | apply within_zero; lra]).
  destruct (Lip n (rows nu x) (rows nu zero) mu 0 t (Nat.le_refl n)) as [_ B]; rewrite ?Rminus_0_r, ?Rabs_R0; trivial;
    try lra.
  - apply within_rows; [lra | apply within_le with t; [lra | exact Hx]].
  - rewrite minus_rows; apply within_rows; [rewrite Rabs_R0; lra|]; intros i Hi; unfold minus, zero; rewrite
      Rminus_0_r; apply Hx, Hi.
  - rewrite !whole_fly in B; change (Rabs (Map.h (member nu) (fly (member nu) mu n x) mu - Map.h (member nu) (fly
      (member nu) 0 n zero) 0) <= l * t) in B; rewrite (proj1 (member_zeros nu ltac:(lra) n)), Rminus_0_r in B; exact B.
Qed.
End Members.

(** ** Where mu turns, by [turn_law] *)
Lemma turning S K c eps nu mu mu' y y' : K <> 0 -> 0 < eps -> Rabs (S / K) <= c -> 0 < y' < y ->
  Rabs (mu - mu' - (nu * S * (y - y') + K * (y ^ 2 - y' ^ 2))) <= Rabs K / (2 * (1 + (c + 1) / (2 * eps))) * ((Rabs nu +
  y + y') * Rabs (y - y')) -> let s := - (nu * S) / (2 * K) in (y <= s - eps * Rabs nu -> K * mu < K * mu') /\
  (s + eps * Rabs nu <= y' -> K * mu' < K * mu).
Proof.
  intros NK He Hc Hy L s; set (k := 1 + (c + 1) / (2 * eps)) in *; set (v := y + y' - 2 * s); pose proof (Rabs_pos nu)
    as Pn; pose proof (Rabs_pos (S / K)); assert (Hk : 1 <= k) by (unfold k; assert (0 < (c + 1) / (2 * eps)) by (apply
    Rdiv_lt_0_compat; lra); lra).
  assert (Bs : Rabs (2 * s) <= c * Rabs nu).
  { replace (2 * s) with (- (S / K * nu)) by (unfold s; field; exact NK); rewrite Rabs_Ropp, Rabs_mult; apply
    Rmult_le_compat_r; assumption. }
  assert (KK : Rabs K * Rabs K = K * K) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
  assert (PK : 0 < K * K) by (rewrite <- KK; apply Rmult_lt_0_compat; apply Rabs_pos_lt, NK).
  assert (Ek : forall t, k * t = t + (c + 1) / (2 * eps) * t) by (intros; unfold k; ring).
  assert (Wide : forall t, 2 * (eps * Rabs nu) <= t -> (c + 1) * Rabs nu <= (c + 1) / (2 * eps) * t) by (intros t Ht;
    replace ((c + 1) * Rabs nu) with ((c + 1) / (2 * eps) * (2 * (eps * Rabs nu))) by (field; lra); apply
    Rmult_le_compat_l; [left; apply Rdiv_lt_0_compat; lra | exact Ht]).
  apply (Rmult_le_compat_l (Rabs K)) in L; [|apply Rabs_pos]; rewrite <- Rabs_mult in L.
  replace (K * (mu - mu' - (nu * S * (y - y') + K * (y ^ 2 - y' ^ 2)))) with (K * mu - K * mu' - K * K * v * (y - y'))
    in L by (unfold v, s; field; exact NK).
  assert (Main : Rabs nu + y + y' <= k * Rabs v -> Rabs (K * mu - K * mu' - K * K * v * (y - y')) <= K * K * Rabs v / 2
    * (y - y')).
  { intros B; eapply Rle_trans; [exact L|]; rewrite (Rabs_pos_eq (y - y')) by lra.
    replace (Rabs K * (Rabs K / (2 * k) * ((Rabs nu + y + y') * (y - y')))) with (Rabs K * Rabs K / (2 * k) * ((Rabs nu
      + y + y') * (y - y'))) by (field; lra). rewrite KK; apply Rle_trans with (K * K / (2 * k) * (k * Rabs v * (y -
      y'))); [|right; field; lra]. apply Rmult_le_compat_l; [left; apply Rdiv_lt_0_compat; lra|]; apply
      Rmult_le_compat_r; lra. }
  assert (En : 0 <= eps * Rabs nu) by (apply Rmult_le_pos; lra); apply le_abs in Bs; split; intros Hs.
  - assert (V : v <= - (y - y') /\ 2 * (eps * Rabs nu) <= - v) by (unfold v; lra); pose proof (Wide (- v) (proj2 V)).
    rewrite (Rabs_left v), Ek in Main by lra; specialize (Main ltac:(lra)); apply le_abs in Main.
    assert (0 < K * K * - v * (y - y')) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra); lra.
  - assert (V : y - y' <= v /\ 2 * (eps * Rabs nu) <= v) by (unfold v; lra); pose proof (Wide v (proj2 V)).
    rewrite (Rabs_pos_eq v), Ek in Main by lra; specialize (Main ltac:(unfold v in *; lra)); apply le_abs in Main.
    assert (0 < K * K * v * (y - y')) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra); lra.
Qed.

Theorem Fold : Fold_statement.
Proof.
  intros F w V T U e n ph Qh p Q HF N M Hw He Ne Hn Hdet HV H2 V0 Pos; set (S0 := - (ph + across M T n) / e).
  set (K := - (1 + Qh + across M U n) / e); destruct (inverse_exists M e n Ne Hdet) as (Ki & HK), (within_exists N w) as
    (W & HW & Wb), (within_exists N (Family.B F)) as (beta & Hb & Bb), (bounds_exist M n) as (mc & m & Bds); pose proof
    (proj1 HK) as K1; pose proof (P_pos M e n Ki beta HK (conj Hb Bb)) as P2; set (P := 2 * Ki * beta + 2) in *.
  assert (PG : 0 < gain e Ki beta mc m).
  { destruct Bds as (B1 & _ & B2 & _); pose proof (Rabs_pos e); assert (0 <= mc * m) by (apply Rmult_le_pos; lra).
    unfold gain; fold P; lra. }
  set (eps0 := / (2 * Ki)); assert (He0 : 0 < eps0 /\ Ki * eps0 <= 1 / 2) by (unfold eps0; split; [apply
    Rinv_0_lt_compat; lra | right; field; lra]).
  destruct (family_grazes F HF) as (rg & Hrg & Gz); pose proof (members_small F w e Hw He rg (family_smooth F HF) (conj
    Hrg Gz) n W HW Wb) as Small; pose proof (member_zeros F rg (conj Hrg Gz)) as Z0.
  assert (PK : 0 < P * Ki) by (apply Rmult_lt_0_compat; lra); assert (PB : 0 < Ki * (beta + eps0)) by (apply
    Rmult_lt_0_compat; lra).
  destruct (margin (fun k _ => across M V k - across M V n) n) as (g & Hg & Mg).
  destruct (Small eps0 (proj1 He0)) as (d0 & Hd0 & Sm0), (members_hit F w e Hw He rg (family_smooth F HF) (conj Hrg Gz)
    n) as (l & dl & Hdl & Hl & Lip).
  destruct (Small (g / 2 / gain e Ki beta mc m / (P * Ki))) as (d1 & Hd1 & Sm1); [repeat apply Rdiv_lt_0_compat; lra|].
  destruct (Small (g / 2 / gain e Ki beta mc m)) as (d2 & Hd2 & Sm2); [repeat apply Rdiv_lt_0_compat; lra|].
  destruct (two_least d1 d2 Hd1 Hd2) as (d3 & Hd3 & A1 & A2), (two_least d0 d3 Hd0 Hd3) as (da & Hda & A3 & A4),
    (two_least da dl Hda Hdl) as (rm & Hrm & A5 & A6).
  destruct (two_least rm rg Hrm Hrg) as (rn & Hrn & A7 & A8).
  assert (Py : forall y a, 0 < a -> y <= a / P -> P * y <= a) by (intros y a Ha Hy; apply (Rmult_le_compat_l P) in Hy;
    [|lra]; replace (P * (a / P)) with a in Hy by (field; lra); exact Hy).
  assert (HV1 : forall i, (i < N)%nat -> V i = power M n V i + Map.B M i) by (intros i Hi; apply HV, Hi).
  assert (Near : forall nu, Rabs nu <= rn -> forall y z, 0 <= y < da / P -> within (S N) d0 z -> ResonanceCurve.solves
    (member F nu) w e n y z -> forall k, (k <= n)%nat -> Rabs (Map.h (member F nu) (fly (member F nu) (z O) k (point w
    z)) (z O) - (across M V k - across M V n) * y) <= g / 2 * y).
  { intros nu Hnu y z Hy Hz HS; apply (near_line (member F nu) w e n V (Z0 nu ltac:(lra)) Ne HV1 Ki W eps0 d0 beta HK
      Hd0 He0 (Sm0 nu d0 ltac:(lra) ltac:(lra)) (conj Hb Bb) mc m (g / 2) da Bds ltac:(lra) ltac:(lra) (Sm1 nu da
      ltac:(lra) ltac:(lra)) (Sm2 nu da ltac:(lra) ltac:(lra)) y z (proj1 Hy) (Py y da Hda (Rlt_le _ _ (proj2 Hy))) Hz
    HS). }
  destruct (sizes W (Ki * (beta + eps0)) P l d0 rn (da / P)) as (h & d & r & Hd & Hh & Hr); trivial; try lra; [apply
    Rdiv_lt_0_compat; lra|].
  assert (Lip' : forall nu, Rabs nu <= rn -> 1 <= l /\ forall mu x d, 0 <= d <= rn -> Rabs mu <= d -> within N d x ->
    Rabs (Map.h (member F nu) (fly (member F nu) mu n x) mu) <= l * d) by (intros nu Hnu; split; [exact Hl|]; intros mu
    x t Ht; apply (Lip nu ltac:(lra)); lra).
  assert (Law : forall eps, 0 < eps -> exists rr, 0 < rr /\ forall nu mu x y mu' x' y', Rabs nu < rr -> y < rr -> y' <
    rr -> one_impact F n d nu mu x y -> one_impact F n d nu mu' x' y' -> (0 < y /\ 0 < y') /\ Rabs (mu - (nu * S0 * y +
    K * y ^ 2)) <= eps * ((Rabs nu + y) * y) /\ Rabs (mu - mu' - (nu * S0 * (y - y') + K * (y ^ 2 - y' ^ 2))) <= eps *
    ((Rabs nu + y + y') * Rabs (y - y'))).
  { intros eps Heps; assert (E1 : 0 < eps / Ki) by (apply Rdiv_lt_0_compat; lra).
    destruct (bend_all _ _ _ _ _ _ _ _ p Q (mixed_height _ _ _ _ _ _ _ _ _ H2) (mixed_impact _ _ _ _ _ _ _ _ _ H2) _
      E1) as (rb & Hrb & Bh & Bi).
    destruct (Small (rb / (1 + W) / (P * Ki))) as (d4 & Hd4 & Sm4); [repeat apply Rdiv_lt_0_compat; lra|].
    destruct (two_least d0 d4 Hd0 Hd4) as (d5 & Hd5 & C1 & C2), (two_least rb (d5 / P) Hrb) as (r1 & R1 & C3 & C4);
      [apply Rdiv_lt_0_compat; lra|]; destruct (two_least r1 d5 R1 Hd5) as (r2 & R2 & C5 & C6), (two_least r2 rn) as (rr
      & Hrr & C7 & C8); try lra.
    exists rr; split; [exact Hrr|]; intros nu mu x y mu' x' y' Hnu Hy Hy' (X1 & X2 & X3) (X1' & X2' & X3').
    pose proof (Rabs_pos nu); assert (Orb : forall mu x, Rabs mu <= d -> single (member F nu) n mu d x -> let y :=
      speed_of (member F nu) n mu x in 0 < y <= h /\ within (S N) d0 (of w mu (x tt)) /\ ResonanceCurve.solves (member F
      nu) w e n y (of w mu (x tt))) by (intros a b Ha Hb'; destruct (orbit_inside (member F nu) w e n Hn W d0 l rn h d
      (conj HW Wb) (Lip' nu ltac:(lra)) Hd Hh a b Ha Hb') as (O1 & O2 & O3 & _); auto).
    destruct (Orb mu x X1 X2) as (Y & Z & HS), (Orb mu' x' X1' X2') as (Y' & Z' & HS'); rewrite X3 in Y, HS; rewrite X3'
      in Y', HS'. split; [lra|].
    pose proof (second (member F nu) w V T U e n ph Qh p Q nu (eps / Ki) rb (Z0 nu ltac:(lra)) Ne HV V0 (conj Hrb E1))
      as Sec.
    cbv zeta in Sec; specialize (Sec (fun y mu x y' mu' x' Y Y' B B' BB => conj (Bh nu y mu x y' mu' x' ltac:(lra) Y Y'
      B B' BB) (fun i Hi => Bi i Hi nu y mu x y' mu' x' ltac:(lra) Y Y' B B' BB)) Ki W eps0 d0 d5 beta HK (conj HW Wb)
      Hd0 He0 (Sm0 nu d0 ltac:(lra) ltac:(lra)) (conj Hb Bb) (conj Hd5 C1) (Sm4 nu d5 ltac:(lra) ltac:(lra))).
    replace (Ki * (eps / Ki)) with eps in Sec by (field; lra); fold P S0 K in Sec.
    pose proof (Py y d5 Hd5 ltac:(lra)); pose proof (Py y' d5 Hd5 ltac:(lra)); split.
    - pose proof (Sec y 0 (of w mu (x tt)) zero ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) Z ltac:(apply within_zero;
        lra) HS (zero_solves (member F nu) w e n (Z0 nu ltac:(lra)))) as L; change (of w mu (x tt) O) with mu in L;
          unfold zero in L.
      rewrite !Rminus_0_r, Rplus_0_r, (Rabs_pos_eq y) in L by lra; replace (y ^ 2 - 0 ^ 2) with (y ^ 2) in L by ring.
      exact L.
    - exact (Sec y y' _ _ ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) Z Z' HS HS'). }
  exists d; split; [apply Hd|]; constructor.
  - destruct (two_least r rn) as (r' & Hr' & C1 & C2); [apply Hr | exact Hrn|]; exists r'; split; [exact Hr'|]; intros
      nu y Hnu Hy.
    destruct (part_one (member F nu) w e n V (Z0 nu ltac:(lra)) Hn) with (K := Ki) (W := W) (eps0 := eps0) (d0 := d0)
      (beta := beta) (l := l) (dl := rn) (h := h) (d := d) (g := g) (r0 := da / P) (r := r) (y := y) as (mu & x & X1 &
      X2 & X3 & Only); auto; try lra.
    + apply Sm0; lra.
    + apply Lip'; lra.
    + apply Near; lra.
    + split; [exact Hg | intros k Hk; apply (Mg k 0%nat); lia].
    + intros k Hk; change (across M V n < across M V k); rewrite V0; apply Pos, Hk.
    + exists mu, x; split; [exact (conj X1 (conj X2 X3))|]; intros mu' x' (Y1 & Y2 & Y3); apply Only; trivial.
  - intros eps Heps; destruct (Law eps Heps) as (rr & Hrr & L); exists rr; split; [exact Hrr|]; intros; apply L with (x
      := x) (x' := x'); assumption.
  - intros NK eps Heps; pose proof (Rabs_pos (S0 / K)); destruct (Law (Rabs K / (2 * (1 + (Rabs (S0 / K) + 1) / (2 *
      eps))))) as (rr & Hrr & L).
    { assert (0 < (Rabs (S0 / K) + 1) / (2 * eps)) by (apply Rdiv_lt_0_compat; lra); apply Rdiv_lt_0_compat; [apply
      Rabs_pos_lt, NK | lra]. }
    exists rr; split; [exact Hrr|]; intros nu mu x y mu' x' y' Hnu Hy O1 O2 Hyy; destruct (L nu mu x y mu' x' y' Hnu Hy
      ltac:(lra) O1 O2) as (Y & _ & L2); apply turning with (c := Rabs (S0 / K)); trivial; [apply Rle_refl | lra].
Qed.
