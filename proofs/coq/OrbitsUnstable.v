(** * Near grazing two orbits with the same impacts separate: the difference along B is multiplied from impact to impact
    *)

From Coq Require Import Reals Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementOrbitsPeriodic StatementUniform StatementUnstable
  Finite OrbitVectors OrbitRemainder Orbits OrbitsNear Derivatives.
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

Notation speed_at := (speed_at M mu).
Notation go := (go M mu).
Notation slow := (slow M n_max eta' d mu).
(** The difference is nearly s B. *)
Definition along (s : R) (v : vec) : Prop := within N (theta * Rabs s) (fun i => v i - s * B M i).

Lemma along_size s v : along s v -> within N ((b + 1) * Rabs s) v.
Proof.
  intros H i Hi; specialize (H i Hi); cbv beta in H; destruct HB as [b0 Bb]; specialize (Bb i Hi); pose proof (Rabs_pos
    s). replace (v i) with ((v i - s * B M i) + s * B M i) by ring.
  replace ((b + 1) * Rabs s) with (1 * Rabs s + Rabs s * b) by ring; apply triangle2.
  - apply Rle_trans with (theta * Rabs s); [exact H|apply Rmult_le_compat_r; lra].
  - apply Rabs_mult_le; [lra|exact Bb].
Qed.
Lemma speed_square k x : slow k x -> speed_at k x * speed_at k x = - hit k x /\ 0 < speed_at k x.
Proof. intros [_ _ S _]; split; [apply sqrt_sqrt; lra|apply sqrt_lt_R0; lra]. Qed.

Lemma separates k x x' s : slow k x -> slow k x' -> along s (minus x' x) -> Rabs (crossing M k) >= kappa ->
  let s' := speed_at k x' - speed_at k x in 2 * Rabs s <= Rabs s' /\ Rabs s' <= eta' /\ along s' (minus (go k x') (go k
    x)) /\ Rabs s' * speed_at k x <= (Rabs (crossing M k) + kappa) * Rabs s.
Proof.
  intros S S' Al Cr s'; destruct (speed_square k x S) as [E Y0]; destruct (speed_square k x' S') as [E' Y0'].
  destruct S as [K Nx _ [Y1 Y2]]; destruct S' as [_ Nx' _ [Y1' Y2']]; pose proof (along_size s _ Al) as Sz.
  set (y := speed_at k x) in *; set (y' := speed_at k x') in *; pose proof (Rabs_pos s) as P; destruct HB as [b0 _].
    destruct Hm as [m1 Pw]; destruct Hc as [mc0 Cw]; set (v := minus x' x) in *.
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
    rewrite Ev in H3; pose proof (Cw _ _ (Pw k (theta * Rabs s) v0 ltac:(lia) ltac:(apply Rmult_le_pos; lra) Al)) as H4.
      replace (hit k x' - hit k x - s * crossing M k) with ((hit k x' - hit k x - (dot N (C M) (power k v0) + s *
      crossing M k) - (mu - mu) * (e - dot N (C M) (power k w))) + dot N (C M) (power k v0)) by ring.
    replace (kappa / 2 * Rabs s) with (kappa / 4 * Rabs s + kappa / 4 * Rabs s) by field; apply triangle2.
    - apply Rle_trans with (1 := H3); rewrite <- Rmult_assoc; apply Rmult_le_compat_r; lra.
    - apply Rle_trans with (1 := H4). replace (mc * (m * (theta * Rabs s))) with (mc * (m * theta) * Rabs s) by ring;
        apply Rmult_le_compat_r; lra. }
  assert (T' : Rabs (hit k x' - hit k x) = Rabs s' * (y + y')).
  { rewrite <- (Rabs_pos_eq (y + y')), <- Rabs_mult, <- Rabs_Ropp by lra; f_equal; unfold s'; lra. }
  assert (H2 : kappa / 2 * Rabs s <= Rabs s' * (y + y')).
  { assert (Q : kappa * Rabs s <= Rabs (s * crossing M k)).
    { rewrite Rabs_mult, Rmult_comm; apply Rmult_le_compat_l; lra. }
    assert (T : Rabs (s * crossing M k) <= Rabs (s * crossing M k - (hit k x' - hit k x)) + Rabs (hit k x' - hit k x)).
    { replace (s * crossing M k) with ((s * crossing M k - (hit k x' - hit k x)) + (hit k x' - hit k x)) at 1 by ring.
      apply Rabs_triang. }
    rewrite T', Rabs_minus_sym in T; lra. }
  pose proof (Rabs_pos s') as P'; assert (H5 : Rabs s' * (y + y') <= Rabs s' * eta') by (apply Rmult_le_compat_l; lra).
    assert (Big : Rabs s <= 2 * eta' / kappa * Rabs s').
  { apply (Rmult_le_reg_l (kappa / 2)); [lra|]. replace (kappa / 2 * (2 * eta' / kappa * Rabs s')) with (Rabs s' * eta')
      by (field; lra); lra. }
  split; [|split; [|split]].
  4:{ apply from in H1; rewrite T', Rabs_mult in H1; assert (0 <= Rabs s' * y') by (apply Rmult_le_pos; lra). assert (0
    <= kappa * Rabs s) by (apply Rmult_le_pos; lra); lra. }
  - apply (Rmult_le_reg_l (kappa / 4)); [lra|]; assert (Rabs s' * eta' <= kappa / 4 * Rabs s') by (rewrite Rmult_comm;
      apply Rmult_le_compat_r; lra); lra.
  - unfold s'; apply Rabs_le; lra.
  - intros i Hi; cbv beta; pose proof (Rmax_l ((b + 1) * Rabs s) (Rabs s')) as M1; pose proof (Rmax_r ((b + 1) * Rabs s)
      (Rabs s')) as M2. set (t := Rmax ((b + 1) * Rabs s) (Rabs s')) in *. destruct (HR k x' x y' y mu mu t) as (R1 &
      _); trivial; try lia; try (rewrite Rabs_pos_eq; lra).
    { apply within_le with (2 := Sz); exact M1. }
    specialize (R1 i Hi); unfold rest1 in R1; rewrite (Rabs_pos_eq y), (Rabs_pos_eq y') in R1 by lra.
    pose proof (Pw k ((b + 1) * Rabs s) v ltac:(lia) ltac:(apply Rmult_le_pos; lra) Sz i Hi) as R2.
    assert (Ep : power k v i = power k x' i - power k x i) by (unfold v, StatementOrbits.power; rewrite power_minus;
      reflexivity). match type of R1 with Rabs ?X <= _ => replace (minus (go k x') (go k x) i - s' * B M i) with (X +
      power k v i) end.
    2:{ rewrite Ep; unfold minus, go, s'; fold y y'; ring. }
    apply Rle_trans with (eps * t + m * ((b + 1) * Rabs s)); [apply triangle2; assumption|].
    assert (T1 : eps * t <= eps * Rabs s' + eps * ((b + 1) * Rabs s)).
    { rewrite <- Rmult_plus_distr_l; apply Rmult_le_compat_l; [lra|]; assert (0 <= (b + 1) * Rabs s) by (apply
        Rmult_le_pos; lra). unfold t, Rmax; destruct Rle_dec; lra. }
    assert (T2 : eps * ((b + 1) * Rabs s) <= 1 * ((b + 1) * Rabs s)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos;
      lra|lra]). assert (T3 : (m + 1) * (b + 1) * Rabs s <= (m + 1) * (b + 1) * (2 * eta' / kappa
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
  intros Sp Sq Ex Cr i Hi; destruct (separates k q p 0 Sq Sp) as (_ & _ & A1 & _).
  { intros l Hl; unfold minus; rewrite Ex, Rabs_R0 by exact Hl; replace (q l - q l - 0 * B M l) with 0 by ring; rewrite
      Rabs_R0; lra. }
  { exact Cr. }
  destruct (HR k p q 0 0 mu mu 0) as (_ & _ & H3); [apply Sp|apply Sp|apply Sq|rewrite Rabs_R0; lra| rewrite Rabs_R0;
    lra|exact Hmu|exact Hmu| |rewrite Rminus_eq_0, Rabs_R0; lra|rewrite Rminus_eq_0, Rabs_R0; lra|].
  { intros l Hl; unfold minus; rewrite Ex by exact Hl; rewrite Rminus_eq_0, Rabs_R0; lra. }
  assert (Ed : dot N (C M) (power k (minus p q)) = 0).
  { unfold StatementOrbits.power; rewrite power_minus, dot_minus. rewrite (dot_ext N (C M) _ (Nat.iter k (mult N (A M))
      q)); [ring|apply power_ext, Ex]. }
  rewrite Ed, Rminus_eq_0, Rmult_0_l, Rmult_0_r in H3; assert (Eh : hit k p = hit k q).
  { revert H3; unfold Rabs; destruct Rcase_abs; lra. }
  assert (Es : speed_at k p - speed_at k q = 0) by (unfold speed_at; rewrite Eh; ring). rewrite Es in A1; specialize (A1
    i Hi); rewrite Rabs_R0, Rmult_0_r, Rmult_0_l, Rminus_0_r in A1. revert A1; unfold minus, Rabs; destruct Rcase_abs;
    lra.
Qed.

(** The impacts from z on, with the flights of the orbit from j on. As long as they are within r of it, the difference
    doubles at each. *)
Notation onto j i := (Nat.iter i next j).
Fixpoint path (j : J) (z : vec) (i : nat) : vec := match i with O => z | S k => Nat.iter (n (onto j k)) (step M mu)
  (path
  j z k) end.
Lemma doubles j z s l : along s (minus z (x j)) -> (forall i, (i < l)%nat -> within N r (minus (path j z i) (x (onto j
  i)))) -> exists s', along s' (minus (path j z l) (x (onto j l))) /\ 2 ^ l * Rabs s <= Rabs s' /\ (l <> 0%nat ->
  Rabs s' <= eta').
Proof.
  intros Al; induction l as [|l IH]; intros In; [exists s; split; [exact Al | split; [cbn; lra | intros F; elim F;
    reflexivity]]|]. destruct IH as (s1 & A1 & D1 & _); [intros i Hi; apply In; lia|]. set (k := onto j l) in *.
  destruct (Near k (x k) (within_self r (x k) ltac:(lra))) as [Sx Gx], (Near k (path j z l) (In l ltac:(lia))) as [Sz
    Gz], (Hn k) as [_ Cr]. destruct (separates (n k) (x k) (path j z l) s1 Sx Sz A1 Cr) as (E1 & E2 & E3 & _).
  exists (speed_at (n k) (path j z l) - speed_at (n k) (x k)); split; [|split; [|intros _; exact E2]].
  - apply (along_ext _ (minus (go (n k) (path j z l)) (go (n k) (x k)))); [|exact E3]; intros i Hi; unfold minus.
    change (path j z (S l)) with (Nat.iter (n k) (step M mu) (path j z l)); change (onto j (S l)) with (next k).
    rewrite Gz, <- Orb, Gx by exact Hi; reflexivity.
  - apply Rle_trans with (2 := E1); cbn [pow]; lra.
Qed.
Lemma leaves j ep : 0 < ep -> exists z l, within N ep (minus z (x j)) /\ Rabs (speed_at (n j) z - speed_at (n j) (x j))
  <= ep /\ within N ep (minus (path j z 1) (x (next j))) /\ (forall i, (i < l)%nat -> within N r (minus (path j z i) (x
  (onto j i)))) /\ ~ within N r (minus (path j z l) (x (onto j l))).
Proof.
  intros Hep; destruct HB as [b0 Bb], (Near j (x j) (within_self r (x j) ltac:(lra))) as [Sx Gx], (Hn j) as [_ Cr].
  pose proof (proj2 (speed_square _ _ Sx)) as Py; set (y := speed_at (n j) (x j)) in *; set (q := Rabs (crossing M (n
    j)) + kappa). assert (Pq : 0 < q) by (pose proof (Rabs_pos (crossing M (n j))); unfold q; lra).
  destruct (two_least ep r Hep Hr) as (e0 & E0 & E1 & E2); assert (P1 : 0 < e0 / (b + 1)) by (apply Rdiv_lt_0_compat;
    lra).
  assert (P2 : 0 < e0 * y / ((b + 1) * q)) by (apply Rdiv_lt_0_compat; apply Rmult_lt_0_compat; lra).
  destruct (two_least _ _ P1 P2) as (s & S0 & S1 & S2); apply (Rmult_le_compat_r (b + 1)) in S1; [|lra].
  replace (e0 / (b + 1) * (b + 1)) with e0 in S1 by (field; lra); apply (Rmult_le_compat_r ((b + 1) * q)) in S2; [|apply
    Rmult_le_pos; lra].
  replace (e0 * y / ((b + 1) * q) * ((b + 1) * q)) with (e0 * y) in S2 by (field; lra).
  set (z := fun i => x j i + s * B M i). assert (Z : within N e0 (minus z (x j))).
  { intros i Hi; unfold minus, z; replace (x j i + s * B M i - x j i) with (s * B M i) by ring; specialize (Bb i Hi).
    apply Rle_trans with (s * (b + 1)); [|exact S1]; rewrite Rabs_mult, (Rabs_pos_eq s) by lra; apply Rmult_le_compat_l;
      lra. }
  assert (Al : along s (minus z (x j))).
  { intros l Hl; unfold minus, z; replace (x j l + s * B M l - x j l - s * B M l) with 0 by ring; rewrite Rabs_R0; apply
      Rmult_le_pos; [lra|apply Rabs_pos]. }
  destruct (Near j z (within_le _ _ _ _ E2 Z)) as [Sz Gz], (separates (n j) (x j) z s Sx Sz Al Cr) as (_ & _ & A1 & U).
  fold y q in A1, U; set (s' := speed_at (n j) z - y) in *; rewrite (Rabs_pos_eq s) in U by lra.
  assert (Us : (b + 1) * Rabs s' <= e0) by (apply (Rmult_le_reg_r y); [exact Py|]; apply (Rmult_le_compat_l (b + 1)) in
    U; lra). assert (Us' : Rabs s' <= ep) by (pose proof (Rabs_pos s'); assert (0 <= b * Rabs s') by (apply
    Rmult_le_pos; lra); lra).
  assert (Z1 : within N ep (minus (path j z 1) (x (next j)))).
  { apply within_le with (1 := Rle_trans _ _ _ Us E1), (along_size s'), (along_ext s' (minus (go (n j) z) (go (n j) (x
      j)))); [|exact A1]; intros i Hi; unfold minus; cbn [path Nat.iter nat_rect]; rewrite Gz, <- Orb, Gx by exact Hi;
      reflexivity. }
  apply Classical_Prop.NNPP; intros No; assert (In : forall l i, (i < l)%nat -> within N r (minus (path j z i) (x (onto
    j i)))).
  { induction l as [|l IH]; intros i Hi; [lia|]; destruct (Nat.eq_dec i l) as [->|Ne]; [|apply IH; lia].
    apply Classical_Prop.NNPP; intros F; apply No; exists z, l; split; [exact (within_le _ _ _ _ E1 Z) | auto]. }
  destruct (Pow_x_infinity 2 ltac:(rewrite Rabs_pos_eq; lra) ((eta' + 1) / s)) as (i & Hi); specialize (Hi (S i)
    ltac:(lia)). rewrite Rabs_pos_eq in Hi by (apply pow_le; lra).
  destruct (doubles j z s (S i) Al (In (S i))) as (s2 & _ & F1 & F2).
  specialize (F2 ltac:(discriminate)); rewrite (Rabs_pos_eq s) in F1 by lra. apply Rge_le, (Rmult_le_compat_r s) in Hi;
    [|lra]; replace ((eta' + 1) / s * s) with (eta' + 1) in Hi by (field; lra); lra.
Qed.
Lemma path_step j z l : exists i, path j z l = Nat.iter i (step M mu) z /\ forall q, (q < N)%nat ->
  Nat.iter i (step M mu) (x j) q = x (onto j l) q.
Proof.
  induction l as [|l (i & E & F)]; [exists 0%nat; split; reflexivity|]; exists (n (onto j l) + i)%nat; cbn [path].
  rewrite E, !iter_add; split; [reflexivity|]; intros q Hq; set (p := Nat.iter i (step M mu) (x j)) in *.
  assert (Np : within N r (minus p (x (onto j l)))) by (intros q' Hq'; unfold minus; rewrite F, Rminus_eq_0, Rabs_R0 by
    exact Hq'; lra). destruct (Near _ p Np) as [Sp Gp], (Near _ (x (onto j l)) (within_self r _ ltac:(lra))) as [Sx Gx].
  change (onto j (S l)) with (next (onto j l)); rewrite Gp, <- Orb, Gx by exact Hq; apply (go_same (n (onto j l)));
    trivial; apply Hn.
Qed.
Lemma goes_away j : unstable M mu (x j).
Proof.
  exists r; split; [lra|]; intros ep Hep; destruct (leaves j ep Hep) as (z & l & Z & _ & _ & _ & F), (path_step j z l)
    as (i & E & G). exists z, i; split; [exact Z|]; intros F'; apply F; intros q Hq; specialize (F' q Hq); unfold minus
    in *.
  rewrite E, <- G by exact Hq; exact F'.
Qed.
End Unstable.

(** Orbits z that start as near to x j as one likes go away, with the flights of x, and that not far. *)
Definition leaving (M : Map.t) (J : Type) (next : J -> J) (n : J -> nat) (mu : R) (x : J -> vec) : Prop :=
  forall r0, 0 < r0 -> exists r, 0 < r <= r0 /\ forall j ep, 0 < ep -> exists z l, let onto i := Nat.iter i next j in
  within (N M) ep (minus (z 0%nat) (x j)) /\ Rabs (speed_at M mu (n j) (z 0%nat) - speed_at M mu (n j) (x j)) <= ep /\
  within (N M) ep (minus (z 1%nat) (x (next j))) /\ (forall i, (i < l)%nat -> within (N M) r (minus (z i) (x (onto
    i))) /\
  h M (fly M mu (n (onto i)) (z i)) mu < 0 /\ (forall k, (1 <= k < n (onto i))%nat -> 0 < h M (fly M mu k (z i)) mu) /\
  forall k, (k < N M)%nat -> z (S i) k = go M mu (n (onto i)) (z i) k) /\ ~ within (N M) r (minus (z l) (x (onto l))).
(** An orbit whose heights stay off 0 is unstable. *)
Theorem orbits_leave M w : smooth M -> (forall i, (i < N M)%nat -> w i = mult (N M) (A M) w i + phi M i) ->
  forall n_max kappa, kappa > 0 -> exists d, d > 0 /\ forall J next n mu x c,
  (forall j : J, (1 <= n j <= n_max)%nat /\ Rabs (crossing M (n j)) >= kappa) -> Rabs mu <= d ->
  orbit_near M J next n mu d x -> 0 < c -> (forall j, clear_at M mu (n j) (x j) c) ->
  (forall j, unstable M mu (x j)) /\ leaving M J next n mu x.
Proof.
  intros HM Hw n_max kappa Hk; set (e := dot (N M) (C M) w + eta M). destruct (power_bound (N M) (A M) n_max) as (m & m1
    & Pw); destruct (dot_bound (N M) (C M)) as (mc & mc0 & Cw). destruct (within_exists (N M) (B M)) as (b & b0 & Bb).
    assert (MM : 0 <= mc * m) by (apply Rmult_le_pos; lra). destruct (small_enough (kappa / 4) (mc * m) ltac:(lra) MM)
    as (theta & Ht & Ht'). destruct (two_least (kappa / 4) (theta / 2) ltac:(lra) ltac:(lra)) as (q & q0 & q1 & q2).
    destruct (small_enough q (b + 1) q0 ltac:(lra)) as (eps & Hep & Hep').
  assert (MB : 0 <= (m + 1) * (b + 1) * (2 / kappa)).
  { apply Rmult_le_pos; [apply Rmult_le_pos; lra|left; apply Rdiv_lt_0_compat; lra]. }
  destruct (small_enough (theta / 2) ((m + 1) * (b + 1) * (2 / kappa)) ltac:(lra) MB) as (q3 & q4 & q5).
  destruct (two_least q3 (kappa / 4) ltac:(lra) ltac:(lra)) as (eta' & e0 & e1 & e2).
  assert (Eps2 : eps <= theta / 2).
  { assert (0 <= b * eps) by (apply Rmult_le_pos; lra); lra. }
  assert (Eta2 : (m + 1) * (b + 1) * (2 * eta' / kappa) <= theta / 2).
  { replace ((m + 1) * (b + 1) * (2 * eta' / kappa)) with ((m + 1) * (b + 1) * (2 / kappa) * eta') by (field; lra).
      apply Rle_trans with (2 := q5); apply Rmult_le_compat_l; lra. }
  destruct (there M w n_max eps eta' HM Hw ltac:(lra) e0) as (d1 & d & rho & Hd & HR & Hrho & There); exists d; split;
    [lra|]; intros J next n mu x c Hn Hmu Orb Hc Cl.
  assert (Near : forall r, 0 < r <= rho c -> forall j p, within (N M) r (minus p (x j)) -> slow M n_max eta' d1 mu (n j)
    p /\ (forall i, (1 <= i < n j)%nat -> 0 < h M (fly M mu i p) mu) /\ forall i, (i < N M)%nat -> Nat.iter (n j) (step
    M mu) p i = go M mu (n j) p i).
  { intros r Hr j p Hp; apply (There (n j) mu (x j) c p); trivial; [apply Hn | apply Orb | apply within_le with r;
    trivial; lra]. }
  assert (Near' : forall r, 0 < r <= rho c -> forall j p, within (N M) r (minus p (x j)) -> slow M n_max eta' d1 mu (n
    j) p /\ forall i, (i < N M)%nat -> Nat.iter (n j) (step M mu) p i = go M mu (n j) p i) by (intros r Hr j p Hp;
    destruct (Near r Hr j p Hp) as (A & _ & B); auto).
  assert (Back : forall j i, (i < N M)%nat -> Nat.iter (n j) (step M mu) (x j) i = x (next j) i) by (intros j i Hi;
    apply Orb, Hi).
  assert (Pm : 1 <= m /\ forall k t x, (k <= n_max)%nat -> 0 <= t -> within (N M) t x -> within (N M) (m * t) (power M k
    x)) by (split; [exact m1 | intros k t v; apply Pw]). pose proof (conj b0 Bb) as Pb; pose proof (conj mc0 Cw) as Pc.
  pose proof (Hrho c Hc) as Pr; split.
  - intros j; apply (goes_away M w e n_max kappa m mc b theta eps eta' d1 mu) with (next := next) (n := n) (r := rho c);
      trivial; try lra; apply (Near' (rho c)); lra.
  - intros r0 Hr0; destruct (two_least r0 (rho c) Hr0 Pr) as (r & Hr & R1 & R2); exists r; split; [lra|]; intros j near0
      Hq.
    destruct (leaves M w e n_max kappa m mc b theta eps eta' d1 mu) with (next := next) (n := n) (x := x) (r := r) (j :=
      j) (ep := near0) as (z & l & Z & Z0 & Z1 & In & Out); trivial; try lra; [apply (Near' r); lra|].
    exists (path M mu J next n j z), l; split; [exact Z | split; [exact Z0 | split; [exact Z1 | split; [|exact Out]]]];
      intros i Hi; specialize (In i Hi).
    destruct (Near r ltac:(lra) _ _ In) as (Sl & Fr & Go); split; [exact In | split; [apply Sl | split; [exact Fr|]]].
    intros k Hk'; cbn [path]; apply Go, Hk'.
Qed.

Theorem Unstable : Unstable_statement.
Proof.
  intros M w HM Hw n_max kappa Hk; destruct (orbits_leave M w HM Hw n_max kappa Hk) as (d & Hd & H); exists d; split;
    [exact Hd|]; intros J next n mu x (cnt & at_ & index & Fin & _) Hn Hmu Orb.
  destruct (common_bound (fun c r => clear_at M mu (n (at_ c)) (x (at_ c)) r) cnt) as (r & r0 & Hr).
  - intros c a a' [F G] Ha; split; [intros i Hi; specialize (F i Hi)|]; lra.
  - intros c _; apply (orbit_clear M J next n mu d x); [intros j; apply Hn | exact Orb].
  - apply (H J next n mu x r Hn Hmu Orb r0); intros j; destruct (Fin j) as [F1 F2]; rewrite <- F2; apply Hr, F1.
Qed.
