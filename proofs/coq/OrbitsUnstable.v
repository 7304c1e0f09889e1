(** * Near grazing two orbits with the same impacts separate: the difference along B is multiplied from impact to impact
    *)

From Coq Require Import Reals Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPeriodic StatementUniform StatementUnstable
  FreeFlight Finite OrbitVectors OrbitRemainder Orbits Derivatives.
Import Map.
Open Scope R_scope.

Lemma iter_add (T : Type) (F : T -> T) j k x : Nat.iter (j + k) F x = Nat.iter j F (Nat.iter k F x).
Proof. induction j as [|j IH]; [reflexivity|]; exact (f_equal F IH). Qed.

Section Unstable.
Variables (M : Map.t) (w : vec) (e : R).
Hypothesis HM : smooth M.
Hypothesis Hw : forall i, (i < N M)%nat -> w i = mult (N M) (A M) w i + phi M i.
Hypothesis He : e = dot (N M) (C M) w + eta M.
Notation N := (N M).
Notation power := (power M).
Variables (n_max : nat) (kappa m mc b theta eps eta' d mu : R).
Notation hit k x := (h M (fly M mu k x) mu).
Hypothesis Hm : 1 <= m /\ forall k t x, (k <= n_max)%nat -> 0 <= t -> within N t x -> within N (m * t) (power k x).
Hypothesis Hc : 0 <= mc /\ forall t x, within N t x -> Rabs (dot N (C M) x) <= mc * t.
Hypothesis HB : 0 <= b /\ within N b (B M).
Hypothesis Hk : 0 < kappa.
Hypothesis Ht : 0 < theta <= 1 /\ mc * (m * theta) <= kappa / 4.
Hypothesis Heps : 0 < eps <= 1 /\ eps * (b + 1) <= kappa / 4 /\ eps <= theta / 2.
Hypothesis Heta : 0 < eta' <= kappa / 4 /\ (m + 1) * (b + 1) * (2 * eta' / kappa) <= theta / 2.
Hypothesis Hd : 0 < d.
Hypothesis HR : remainder M w e n_max eps d.
Hypothesis Hmu : Rabs mu <= d.

(** What flight and impact make of x. *)
Definition speed_at (k : nat) (x : vec) : R := sqrt (- hit k x).
Definition go (k : nat) (x : vec) : vec := fun i =>
  fly M mu k x i + kick M (fly M mu k x) (speed_at k x) mu i * speed_at k x.
(** x is near 0, and its impact after k steps is slow. *)
Record slow (k : nat) (x : vec) : Prop := {
  slow_steps : (1 <= k <= n_max)%nat;
  slow_near : within N d x;
  slow_hits : hit k x < 0;
  slow_speed : speed_at k x <= eta' / 2 /\ speed_at k x <= d }.
(** The difference is nearly s B. *)
Definition along (s : R) (v : vec) : Prop := within N (theta * Rabs s) (fun i => v i - s * B M i).

Lemma along_size s v : along s v -> within N ((b + 1) * Rabs s) v.
Proof.
  intros H i Hi; specialize (H i Hi); cbv beta in H; destruct HB as [b0 Bb]; specialize (Bb i Hi);
    pose proof (Rabs_pos s). replace (v i) with ((v i - s * B M i) + s * B M i) by ring.
  replace ((b + 1) * Rabs s) with (1 * Rabs s + Rabs s * b) by ring; apply triangle2.
  - apply Rle_trans with (theta * Rabs s); [exact H|apply Rmult_le_compat_r; lra].
  - apply Rabs_mult_le; [lra|exact Bb].
Qed.
Lemma speed_square k x : slow k x -> speed_at k x * speed_at k x = - hit k x /\ 0 < speed_at k x.
Proof. intros [_ _ S _]; split; [apply sqrt_sqrt; lra|apply sqrt_lt_R0; lra]. Qed.

Lemma separates k x x' s : slow k x -> slow k x' -> along s (minus x' x) -> Rabs (crossing M k) >= kappa ->
  let s' := speed_at k x' - speed_at k x in 2 * Rabs s <= Rabs s' /\ Rabs s' <= eta' /\ along s' (minus (go k x') (go k
    x)).
Proof.
  intros S S' Al Cr s'; destruct (speed_square k x S) as [E Y0]; destruct (speed_square k x' S') as [E' Y0'].
  destruct S as [K Nx _ [Y1 Y2]]; destruct S' as [_ Nx' _ [Y1' Y2']]; pose proof (along_size s _ Al) as Sz.
  set (y := speed_at k x) in *; set (y' := speed_at k x') in *; pose proof (Rabs_pos s) as P;
    destruct HB as [b0 _]. destruct Hm as [m1 Pw]; destruct Hc as [mc0 Cw]; set (v := minus x' x) in *.
  assert (Z0 : Rabs (mu - mu) <= (b + 1) * Rabs s).
  { rewrite Rminus_eq_0, Rabs_R0; apply Rmult_le_pos; lra. }
  (* the heights *)
  assert (H1 : Rabs (hit k x' - hit k x - s * crossing M k) <= kappa / 2 * Rabs s).
  { destruct (HR k x' x 0 0 mu mu ((b + 1) * Rabs s)) as (_ & _ & H3); trivial; try lia. 1, 2: rewrite Rabs_R0; lra.
    1: rewrite Rminus_eq_0, Rabs_R0; apply Rmult_le_pos; lra. fold v in H3; set (v0 := fun i => v i - s * B M i) in *.
    assert (Ev : dot N (C M) (power k v) = dot N (C M) (power k v0) + s * crossing M k).
    { unfold crossing, StatementOrbits.power; replace v0 with (comb 1 (- s) v (B M)).
      - rewrite power_comb, dot_comb; ring.
      - apply FunctionalExtensionality.functional_extensionality; intros i; unfold comb, v0; ring. }
    rewrite Ev in H3; pose proof (Cw _ _ (Pw k (theta * Rabs s) v0 ltac:(lia) ltac:(apply Rmult_le_pos;
      lra) Al)) as H4. replace (hit k x' - hit k x - s * crossing M k) with ((hit k x' - hit k x - (dot N (C M) (power
      k v0) + s * crossing M k) - (mu - mu) * (e - dot N (C M) (power k w))) + dot N (C M) (power k v0)) by ring.
    replace (kappa / 2 * Rabs s) with (kappa / 4 * Rabs s + kappa / 4 * Rabs s) by field; apply triangle2.
    - apply Rle_trans with (1 := H3); rewrite <- Rmult_assoc; apply Rmult_le_compat_r; lra.
    - apply Rle_trans with (1 := H4). replace (mc * (m * (theta * Rabs s))) with (mc * (m * theta) * Rabs s) by ring;
        apply Rmult_le_compat_r; lra. }
  assert (H2 : kappa / 2 * Rabs s <= Rabs s' * (y + y')).
  { assert (Q : kappa * Rabs s <= Rabs (s * crossing M k)).
    { rewrite Rabs_mult, Rmult_comm; apply Rmult_le_compat_l; lra. }
    assert (T : Rabs (s * crossing M k) <= Rabs (s * crossing M k - (hit k x' - hit k x)) + Rabs (hit k x' - hit k
      x)).
    { replace (s * crossing M k) with ((s * crossing M k - (hit k x' - hit k x)) + (hit k x' - hit k x)) at 1 by ring.
      apply Rabs_triang. }
    assert (T' : Rabs (hit k x' - hit k x) = Rabs s' * (y + y')).
    { rewrite <- (Rabs_pos_eq (y + y')), <- Rabs_mult, <- Rabs_Ropp by lra; f_equal; unfold s'; lra. }
    rewrite T', Rabs_minus_sym in T; lra. }
  pose proof (Rabs_pos s') as P'; assert (H5 : Rabs s' * (y + y') <= Rabs s' * eta') by (apply Rmult_le_compat_l;
    lra). assert (Big : Rabs s <= 2 * eta' / kappa * Rabs s').
  { apply (Rmult_le_reg_l (kappa / 2)); [lra|]. replace (kappa / 2 * (2 * eta' / kappa * Rabs s')) with (Rabs s' *
      eta') by (field; lra); lra. }
  split; [|split].
  - apply (Rmult_le_reg_l (kappa / 4)); [lra|]; assert (Rabs s' * eta' <= kappa / 4 * Rabs s') by (rewrite Rmult_comm;
      apply Rmult_le_compat_r; lra); lra.
  - unfold s'; apply Rabs_le; lra.
  - intros i Hi; cbv beta; pose proof (Rmax_l ((b + 1) * Rabs s) (Rabs s')) as M1; pose proof (Rmax_r ((b + 1) * Rabs
      s) (Rabs s')) as M2. set (t := Rmax ((b + 1) * Rabs s) (Rabs s')) in *. destruct (HR k x' x y' y mu mu t) as (R1
      & _); trivial; try lia; try (rewrite Rabs_pos_eq; lra).
    { apply within_le with (2 := Sz); exact M1. }
    specialize (R1 i Hi); unfold rest1 in R1; rewrite (Rabs_pos_eq y), (Rabs_pos_eq y') in R1 by lra.
    pose proof (Pw k ((b + 1) * Rabs s) v ltac:(lia) ltac:(apply Rmult_le_pos; lra) Sz i Hi) as R2.
    assert (Ep : power k v i = power k x' i - power k x i) by (unfold v, StatementOrbits.power;
      rewrite power_minus; reflexivity). match type of R1 with Rabs ?X <= _ => replace (minus (go k x') (go k x) i -
      s' * B M i) with (X + power k v i) end.
    2:{ rewrite Ep; unfold minus, go, s'; fold y y'; ring. }
    apply Rle_trans with (eps * t + m * ((b + 1) * Rabs s)); [apply triangle2; assumption|].
    assert (T1 : eps * t <= eps * Rabs s' + eps * ((b + 1) * Rabs s)).
    { rewrite <- Rmult_plus_distr_l; apply Rmult_le_compat_l; [lra|]; assert (0 <= (b + 1) * Rabs s) by (apply
        Rmult_le_pos; lra). unfold t, Rmax; destruct Rle_dec; lra. }
    assert (T2 : eps * ((b + 1) * Rabs s) <= 1 * ((b + 1) * Rabs s)) by (apply Rmult_le_compat_r;
      [apply Rmult_le_pos; lra|lra]). assert (T3 : (m + 1) * (b + 1) * Rabs s <= (m + 1) * (b + 1) * (2 * eta' / kappa
      * Rabs s')).
    { apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|exact Big]. }
    assert (T4 : (m + 1) * (b + 1) * (2 * eta' / kappa) * Rabs s' <= theta / 2 * Rabs s') by (apply Rmult_le_compat_r;
      lra). assert (T5 : eps * Rabs s' <= theta / 2 * Rabs s') by (apply Rmult_le_compat_r; lra); lra.
Qed.

(** ** A periodic orbit, and the points near it *)
Variables (J : Type) (next : J -> J) (n : J -> nat) (x : J -> vec) (r : R).
Hypothesis Hn : forall j, (1 <= n j <= n_max)%nat /\ Rabs (crossing M (n j)) >= kappa.
(** Points within r of x j have its flight, and impact slowly. *)
Hypothesis Near : forall j p, within N r (minus p (x j)) -> slow (n j) p /\ forall i, (i < N)%nat ->
  Nat.iter (n j) (step M mu) p i = go (n j) p i.
Hypothesis Orb : forall j i, (i < N)%nat -> Nat.iter (n j) (step M mu) (x j) i = x (next j) i.
Hypothesis Hr : 0 < r.

Lemma within_self t y : 0 <= t -> within N t (minus y y).
Proof. intros H i _; unfold minus; rewrite Rminus_eq_0, Rabs_R0; exact H. Qed.
Lemma along_ext s u v : (forall i, (i < N)%nat -> u i = v i) -> along s u -> along s v.
Proof. intros Ex H i Hi; rewrite <- Ex by exact Hi; apply H, Hi. Qed.
(** The same point but for coordinates beyond N. *)
Lemma go_same k p q : slow k p -> slow k q -> (forall i, (i < N)%nat -> p i = q i) -> Rabs (crossing M k) >= kappa ->
  forall i, (i < N)%nat -> go k p i = go k q i.
Proof.
  intros Sp Sq Ex Cr i Hi; destruct (separates k q p 0 Sq Sp) as (_ & _ & A1).
  { intros l Hl; unfold minus; rewrite Ex, Rabs_R0 by exact Hl; replace (q l - q l - 0 * B M l) with 0 by ring;
      rewrite Rabs_R0; lra. }
  { exact Cr. }
  destruct (HR k p q 0 0 mu mu 0) as (_ & _ & H3); [apply Sp|apply Sp|apply Sq|rewrite Rabs_R0;
    lra| rewrite Rabs_R0; lra|exact Hmu|exact Hmu| |rewrite Rminus_eq_0, Rabs_R0; lra|rewrite Rminus_eq_0, Rabs_R0;
    lra|].
  { intros l Hl; unfold minus; rewrite Ex by exact Hl; rewrite Rminus_eq_0, Rabs_R0; lra. }
  assert (Ed : dot N (C M) (power k (minus p q)) = 0).
  { unfold StatementOrbits.power; rewrite power_minus, dot_minus. rewrite (dot_ext N (C M) _ (Nat.iter k (mult N (A
      M)) q)); [ring|apply power_ext, Ex]. }
  rewrite Ed, Rminus_eq_0, Rmult_0_l, Rmult_0_r in H3; assert (Eh : hit k p = hit k q).
  { revert H3; unfold Rabs; destruct Rcase_abs; lra. }
  assert (Es : speed_at k p - speed_at k q = 0) by (unfold speed_at; rewrite Eh; ring). rewrite Es in A1;
    specialize (A1 i Hi); rewrite Rabs_R0, Rmult_0_r, Rmult_0_l, Rminus_0_r in A1. revert A1;
    unfold minus, Rabs; destruct Rcase_abs; lra.
Qed.

(** As long as z is within r of the orbit, the difference doubles at each impact. *)
Lemma doubles i : forall j p z s, (forall l, (l < N)%nat -> p l = x j l) -> along s (minus z p) ->
  (forall q, within N r (minus (Nat.iter q (step M mu) z) (Nat.iter q (step M mu) p))) ->
  exists s', 2 ^ i * Rabs s <= Rabs s' /\ (i <> 0%nat -> Rabs s' <= eta').
Proof.
  induction i as [|i IH]; intros j p z s Ex Al In; [exists s; split; [cbn; lra|intros F; elim F;
    reflexivity]|]. assert (Np : within N r (minus p (x j))).
  { intros l Hl; unfold minus; rewrite Ex by exact Hl; rewrite Rminus_eq_0, Rabs_R0; lra. }
  assert (Nz : within N r (minus z (x j))).
  { intros l Hl; unfold minus; rewrite <- Ex by exact Hl; apply (In 0%nat l Hl). }
  destruct (Near j p Np) as [Sp Gp]; destruct (Near j z Nz) as [Sz Gz]; destruct (Hn j) as [K Cr].
  destruct (Near j (x j) (within_self r (x j) ltac:(lra))) as [Sx Gx]. destruct (separates (n j) p z s Sp Sz Al Cr) as
    (D1 & D2 & D3); set (s' := speed_at (n j) z - speed_at (n j) p) in *. destruct (IH (next j) (Nat.iter (n j) (step
    M mu) p) (Nat.iter (n j) (step M mu) z) s') as (s2 & F1 & F2).
  - intros l Hl; rewrite Gp, <- Orb, Gx by exact Hl; apply (go_same (n j)); trivial.
  - apply (along_ext s' (minus (go (n j) z) (go (n j) p))); trivial; intros l Hl; unfold minus;
      rewrite Gz, Gp by exact Hl; reflexivity.
  - intros q; specialize (In (q + n j)%nat); rewrite !iter_add in In; exact In.
  - destruct i as [|i]; [exists s'; split; [cbn; lra|intros _; exact D2]|]. exists s2; split; [|intros _;
      apply F2; discriminate]. apply Rle_trans with (2 := F1); replace (2 ^ S (S i) * Rabs s) with (2 ^ S i * (2 *
      Rabs s)) by (cbn; ring). apply Rmult_le_compat_l; [apply pow_le; lra|exact D1].
Qed.
Lemma goes_away j : unstable M mu (x j).
Proof.
  exists r; split; [lra|]; intros ep Hep; destruct HB as [b0 Bb]; set (s := ep / (b + 1)).
  assert (S0 : 0 < s) by (apply Rdiv_lt_0_compat; lra); set (z := fun i => x j i + s * B M i).
  apply Classical_Prop.NNPP; intros No. assert (In : forall q, within N r (minus (Nat.iter q (step M mu) z) (Nat.iter
    q (step M mu) (x j)))).
  { intros q; apply Classical_Prop.NNPP; intros F; apply No; exists z, q; split; [|exact F]. intros i Hi;
      unfold minus, z; replace (x j i + s * B M i - x j i) with (s * B M i) by ring. replace ep with (s * (b + 1)) by
      (unfold s; field; lra); rewrite Rabs_mult, (Rabs_pos_eq s) by lra. apply Rmult_le_compat_l; [lra|];
      specialize (Bb i Hi); lra. }
  destruct (Pow_x_infinity 2 ltac:(rewrite Rabs_pos_eq; lra) ((eta' + 1) / s)) as (i & Hi);
    specialize (Hi (S i) ltac:(lia)). rewrite Rabs_pos_eq in Hi by (apply pow_le; lra).
  destruct (doubles (S i) j (x j) z s) as (s' & F1 & F2); trivial.
  { intros l Hl; unfold minus, z; replace (x j l + s * B M l - x j l - s * B M l) with 0 by ring;
      rewrite Rabs_R0. apply Rmult_le_pos; [lra|apply Rabs_pos]. }
  specialize (F2 ltac:(discriminate)); rewrite (Rabs_pos_eq s) in F1 by lra. apply Rge_le, (Rmult_le_compat_r s) in
    Hi; [|lra]; replace ((eta' + 1) / s * s) with (eta' + 1) in Hi by (field; lra); lra.
Qed.
End Unstable.

Section Near.
Variables (M : Map.t) (w : vec) (e : R).
Hypothesis HM : smooth M.
Hypothesis Hw : forall i, (i < N M)%nat -> w i = mult (N M) (A M) w i + phi M i.
Hypothesis He : e = dot (N M) (C M) w + eta M.
Notation N := (N M).
Variables (n_max : nat) (l d1 d eta' mu : R).
Notation hit k x := (h M (fly M mu k x) mu).
Hypothesis Hl : 1 <= l.
Hypothesis HL : forall k x x' mu mu' t, (k <= n_max)%nat -> within N d1 x -> within N d1 x' -> Rabs mu <= d1 ->
  Rabs mu' <= d1 -> within N t (minus x x') -> Rabs (mu - mu') <= t ->
  within N (l * t) (minus (fly M mu k x) (fly M mu' k x')) /\ Rabs (h M (fly M mu k x) mu - h M (fly M mu' k x') mu') <=
    l * t.
Hypothesis Hd : 0 < d <= d1.
Hypothesis Hs : 0 < eta' /\ l * d <= (eta' / 2) ^ 2 /\ l * d <= d1 ^ 2.
Hypothesis Hmu : Rabs mu <= d.

Lemma slow_there k p : (1 <= k <= n_max)%nat -> within N d p -> hit k p < 0 -> slow M n_max eta' d1 mu k p.
Proof.
  intros K Np Hh; split; trivial; [apply within_le with d; trivial; lra|]. destruct (HL k p zero mu 0 d) as [_ B];
    try lia; try (rewrite ?Rabs_R0, ?Rminus_0_r; lra).
  { apply within_le with d; trivial; lra. } { apply within_zero; lra. }
  { intros i Hi; unfold minus, zero; rewrite Rminus_0_r; apply Np, Hi. }
  rewrite (height_zero M w e HM Hw He k), Rminus_0_r in B; apply le_abs in B; unfold speed_at. split;
    [rewrite <- (sqrt_pow2 (eta' / 2)) by lra|rewrite <- (sqrt_pow2 d1) by lra]; apply sqrt_le_1_alt; lra.
Qed.
Lemma flight_there k p : (1 <= k <= n_max)%nat -> (forall i, (1 <= i < k)%nat -> 0 < hit i p) -> hit k p < 0 ->
  forall i, (i < N)%nat -> Nat.iter k (step M mu) p i = go M mu k p i.
Proof.
  intros K Hf Hh i Hi; destruct k as [|k]; [lia|]. assert (E : forall j, (j <= k)%nat -> height M mu p j = hit (S j)
    p).
  { intros j Hj; unfold height; rewrite (iterates_free _ _ (fun x => f M x mu) (fun z => 0 < h M z mu));
      [reflexivity|apply step_free|]; intros a Ha; apply (Hf (S a)); lia. }
  rewrite (iterate_impact M mu p k).
  - unfold go, speed_at; rewrite E by lia; reflexivity.
  - intros a Ha; rewrite E by lia; apply Hf; lia.
  - rewrite E by lia; exact Hh.
Qed.
Lemma near_there k x : (1 <= k <= n_max)%nat -> within N (d / 2) x -> (forall i, (1 <= i < k)%nat -> 0 < hit i x) ->
  hit k x < 0 -> exists r, 0 < r /\ forall p, within N r (minus p x) -> slow M n_max eta' d1 mu k p /\
  forall i, (i < N)%nat -> Nat.iter k (step M mu) p i = go M mu k p i.
Proof.
  intros K Nx Hf Hh. destruct (common_bound (fun i r => r <= d / 2 /\ ((1 <= i < k)%nat -> l * r < hit i x) /\ (i = k
    -> l * r < - hit k x)) (S k)) as (r & Hr & Hall).
  - intros i a a' (h1 & h2 & h3) Ha; split; [lra|]; assert (l * a' <= l * a) by (apply Rmult_le_compat_l; lra).
    split; intros Hi; [specialize (h2 Hi)|specialize (h3 Hi)]; lra.
  - intros i _; set (c := if Nat.eq_dec i k then - hit k x else if le_lt_dec 1 i then (if lt_dec i k then hit i x else
      1) else 1). assert (Hc : 0 < c).
    { unfold c; destruct (Nat.eq_dec i k); [lra|]; destruct (le_lt_dec 1 i); [|lra]; destruct (lt_dec i k);
        [|lra]. apply Hf; lia. }
    exists (Rmin (d / 2) (c / (2 * l))); split; [apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]|].
    pose proof (Rmin_l (d / 2) (c / (2 * l))); pose proof (Rmin_r (d / 2) (c / (2 * l))) as Q.
    apply (Rmult_le_compat_l l) in Q; [|lra]; replace (l * (c / (2 * l))) with (c / 2) in Q by (field; lra).
    split; [lra|split; intros Hi].
    + assert (Ec : c = hit i x); [|lra]. unfold c; destruct (Nat.eq_dec i k); [lia|];
        destruct (le_lt_dec 1 i); [|lia]; destruct (lt_dec i k); [reflexivity|lia].
    + assert (Ec : c = - hit k x); [|lra]; unfold c; destruct (Nat.eq_dec i k); [reflexivity|contradiction].
  - exists r; split; [exact Hr|]; intros p Np; destruct (Hall k ltac:(lia)) as (r1 & _ & r2);
      specialize (r2 eq_refl). assert (Npd : within N d p).
    { intros i Hi; specialize (Nx i Hi); specialize (Np i Hi); unfold minus in Np. replace (p i) with ((p i - x i) + x
        i) by ring; eapply Rle_trans; [apply Rabs_triang|lra]. }
    assert (Close : forall i, (i <= k)%nat -> Rabs (hit i p - hit i x) <= l * r).
    { intros i Hi; apply (HL i p x mu mu r); trivial; try lia; try lra.
      - apply within_le with d; trivial; lra.
      - apply within_le with (d / 2); trivial; lra.
      - rewrite Rminus_eq_0, Rabs_R0; lra. }
    assert (Hp : hit k p < 0) by (pose proof (Close k (le_n k)) as Q; apply le_abs in Q; lra).
    assert (Hfp : forall i, (1 <= i < k)%nat -> 0 < hit i p).
    { intros i Hi; destruct (Hall i ltac:(lia)) as (_ & r3 & _); specialize (r3 Hi). pose proof (Close i ltac:(lia))
        as Q; apply le_abs in Q; lra. }
    split; [apply slow_there; assumption|apply flight_there; assumption].
Qed.
End Near.

Lemma small_enough a c : 0 < a -> 0 <= c -> exists t, 0 < t <= 1 /\ c * t <= a.
Proof.
  intros Ha Hc; exists (Rmin 1 (a / (c + 1))); split.
  - split; [apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]|apply Rmin_l].
  - apply Rle_trans with (c * (a / (c + 1))); [apply Rmult_le_compat_l; [lra|apply Rmin_r]|].
    replace (c * (a / (c + 1))) with (a * (c / (c + 1))) by (field; lra); rewrite <- (Rmult_1_r a) at 2.
    apply Rmult_le_compat_l; [lra|]; apply (Rmult_le_reg_r (c + 1)); [lra|]. replace (c / (c + 1) * (c + 1)) with c by
      (field; lra); lra.
Qed.

(** Points near an orbit near grazing have its flights. *)
Lemma there M w n_max eps small : smooth M -> (forall i, (i < N M)%nat -> w i = mult (N M) (A M) w i + phi M i) -> 0 <
  eps -> 0 < small -> exists d1 d, 0 < d <= d1 /\ remainder M w (dot (N M) (C M) w + eta M) n_max eps d1 /\ forall J
    next n mu x,
  (forall j, (1 <= n j <= n_max)%nat) -> Rabs mu <= d -> orbit_near M J next n mu d x -> forall j, exists r, 0 < r /\
  forall p, within (N M) r (minus p (x j)) -> slow M n_max small d1 mu (n j) p /\
  forall i, (i < N M)%nat -> Nat.iter (n j) (step M mu) p i = go M mu (n j) p i.
Proof.
  intros HM Hw Hep Hsm; set (e := dot (N M) (C M) w + eta M).
  destruct (remainder_exists M w e HM Hw eq_refl n_max eps) as (dr & dr0 & HR); [lra|].
  destruct (Lipschitz_fly M w e HM Hw eq_refl n_max) as (l & dl & l1 & dl0 & HL). destruct (two_least dr dl dr0 dl0)
    as (d1 & d10 & d1r & d1l). destruct (two_least ((small / 2) ^ 2) (d1 ^ 2)) as (sq & s0 & s1 & s2);
    [apply pow_lt; lra|apply pow_lt; lra|]. destruct (small_enough sq l s0 ltac:(lra)) as (d2 & d20 & d21).
  destruct (two_least d1 d2 d10 ltac:(lra)) as (d & d0 & da & db). assert (HL1 : forall k x x' mu mu' t, (k <=
    n_max)%nat -> within (N M) d1 x -> within (N M) d1 x' -> Rabs mu <= d1 -> Rabs mu' <= d1 -> within (N M) t (minus
    x x') -> Rabs (mu - mu') <= t -> within (N M) (l * t) (minus (fly M mu k x) (fly M mu' k x')) /\ Rabs (h M (fly M
    mu k x) mu - h M (fly M mu' k x') mu') <= l * t).
  { intros k x x' mu mu' t K X X' Mu Mu' T T'; apply HL; trivial; try lra; apply within_le with d1; trivial; lra. }
  assert (Ld : l * d <= sq) by (apply Rle_trans with (2 := d21); apply Rmult_le_compat_l; lra). exists d1, (d / 2);
    split; [lra | split; [apply (remainder_down M w e n_max eps dr); trivial|]]; intros J next n mu x Hn Hmu Orb j.
  assert (HnJ : forall j, (1 <= n j)%nat) by (intros j'; apply Hn).
  destruct (orbit_zero M mu J next n HnJ (d / 2) x Orb) as [Z S].
  apply (near_there M w e HM Hw eq_refl n_max l d1 d small mu l1 HL1); try lra; try apply Hn; [apply Orb|apply S|].
  destruct (proj1 (zero_meaning M mu J next n x (speed M mu J n x)) Z j) as [Eh _]; rewrite Eh. destruct (S j) as [Pos
    _]; assert (0 < speed M mu J n x j * speed M mu J n x j) by (apply Rmult_lt_0_compat; exact Pos); lra.
Qed.

Theorem Unstable : Unstable_statement.
Proof.
  intros M w HM Hw n_max kappa Hk; set (e := dot (N M) (C M) w + eta M). destruct (power_bound (N M) (A M) n_max) as
    (m & m1 & Pw); destruct (dot_bound (N M) (C M)) as (mc & mc0 & Cw). destruct (within_exists (N M) (B M)) as (b &
    b0 & Bb). assert (MM : 0 <= mc * m) by (apply Rmult_le_pos; lra). destruct (small_enough (kappa / 4) (mc * m)
    ltac:(lra) MM) as (theta & Ht & Ht'). destruct (two_least (kappa / 4) (theta / 2) ltac:(lra) ltac:(lra)) as (q &
    q0 & q1 & q2). destruct (small_enough q (b + 1) q0 ltac:(lra)) as (eps & Hep & Hep').
  assert (MB : 0 <= (m + 1) * (b + 1) * (2 / kappa)).
  { apply Rmult_le_pos; [apply Rmult_le_pos; lra|left; apply Rdiv_lt_0_compat; lra]. }
  destruct (small_enough (theta / 2) ((m + 1) * (b + 1) * (2 / kappa)) ltac:(lra) MB) as (q3 & q4 & q5).
  destruct (two_least q3 (kappa / 4) ltac:(lra) ltac:(lra)) as (eta' & e0 & e1 & e2).
  assert (Eps2 : eps <= theta / 2).
  { assert (0 <= b * eps) by (apply Rmult_le_pos; lra); lra. }
  assert (Eta2 : (m + 1) * (b + 1) * (2 * eta' / kappa) <= theta / 2).
  { replace ((m + 1) * (b + 1) * (2 * eta' / kappa)) with ((m + 1) * (b + 1) * (2 / kappa) * eta') by (field;
      lra). apply Rle_trans with (2 := q5); apply Rmult_le_compat_l; lra. }
  destruct (there M w n_max eps eta' HM Hw ltac:(lra) e0) as (d1 & d & Hd & HR & There); exists d; split; [lra|];
    intros J next n mu x (cnt & at_ & index & Fin & _) Hn Hmu Orb.
  destruct (common_bound (fun c r => forall p, within (N M) r (minus p (x (at_ c))) -> slow M n_max eta' d1 mu (n (at_
    c)) p /\ forall i, (i < N M)%nat -> Nat.iter (n (at_ c)) (step M mu) p i = go M mu (n (at_ c)) p i) cnt) as (r & r0
      & Hr).
  - intros c a a' H Ha p Hp; apply H, within_le with a'; trivial; lra.
  - intros c _; apply (There J next n mu x (fun j => proj1 (Hn j)) Hmu Orb).
  - apply (goes_away M w e n_max kappa m mc b theta eps eta' d1 mu) with (next := next) (n := n) (r := r);
      trivial; try lra.
    + split; [exact m1|]; intros k t v; apply Pw.
    + split; trivial.
    + split; trivial.
    + intros j p Hp; destruct (Fin j) as [F1 F2]; specialize (Hr (index j) F1); rewrite F2 in Hr; apply Hr, Hp.
    + intros j i Hi; apply Orb; exact Hi.
Qed.
