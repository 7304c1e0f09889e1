(** * Determinants: linear in each column and 0 where two are equal; with that of a sum with a matrix of rank one,
      Cramer's rule, and a vector that is sent to 0 where the determinant is 0 *)
From Coq Require Import Reals FunctionalExtensionality Lra Lia Ranalysis5.
From Grazing Require Import StatementOrbits StatementMultipliers.
From Grazing Require Import OrbitVectors OrbitRemainder SquareSystems Derivatives OrbitsNear.
Open Scope R_scope.

(** ** Sums *)
Lemma dot_terms N c x c1 x1 c2 x2 s t : (forall k, (k < N)%nat -> c k * x k = s * (c1 k * x1 k) + t * (c2 k * x2 k)) ->
  dot N c x = s * dot N c1 x1 + t * dot N c2 x2.
Proof. induction N as [|n IH]; intros H; cbn; [ring|]; rewrite IH, H by (intros; try apply H; lia); ring. Qed.
Lemma dot_same N c x c1 x1 : (forall k, (k < N)%nat -> c k * x k = c1 k * x1 k) -> dot N c x = dot N c1 x1.
Proof. intros H; rewrite (dot_terms N c x c1 x1 c1 x1 1 0); [ring|]; intros; rewrite H by assumption; ring. Qed.
Lemma dot_alone N c x j : (j < N)%nat -> (forall k, (k < N)%nat -> k <> j -> c k * x k = 0) -> dot N c x = c j * x j.
Proof.
  intros Hj H; assert (G : forall m, (m <= N)%nat -> dot m c x = if Nat.ltb j m then c j * x j else 0).
  { induction m as [|m IH]; intros Hm; [reflexivity|]; cbn [dot]; rewrite IH by lia.
    destruct (Nat.ltb_spec j m), (Nat.ltb_spec j (S m)); try lia; [rewrite (H m) by lia; ring | |rewrite (H m) by lia;
    ring]. replace m with j by lia; ring. }
  rewrite (G N) by lia; destruct (Nat.ltb_spec j N); [reflexivity | lia].
Qed.
Lemma dot_skip n p c x : (p <= n)%nat -> dot (S n) c x = dot n (fun k => c (skip p k)) (fun k => x (skip p k)) + c p * x
  p.
Proof.
  intros Hp; assert (G : forall m, (m <= n)%nat -> dot m (fun k => c (skip p k)) (fun k => x (skip p k)) = if Nat.leb m
    p then dot m c x else dot (S m) c x - c p * x p).
  { induction m as [|m IH]; intros Hm; [reflexivity|]; cbn [dot] in IH |- *; rewrite IH by lia; unfold skip.
    destruct (Nat.leb_spec m p), (Nat.leb_spec (S m) p), (Nat.ltb_spec m p); try lia; [ring | replace m with p by lia;
    ring | ring]. }
  rewrite (G n (le_n n)); cbn [dot]; destruct (Nat.leb_spec n p); [replace n with p by lia|]; ring.
Qed.

(** ** Linear in each column *)
Definition put (j : nat) (u : vec) (a : nat -> vec) : nat -> vec := fun k => if Nat.eqb k j then u else a k.
Ltac skips := unfold skip, put; repeat match goal with
  | |- context [Nat.ltb ?a ?b] => destruct (Nat.ltb_spec a b); try lia
  | |- context [Nat.eqb ?a ?b] => destruct (Nat.eqb_spec a b); try lia end; try lia.
Lemma det_ext N : forall a b, (forall j i, (j < N)%nat -> (i < N)%nat -> a j i = b j i) -> det N a = det N b.
Proof.
  induction N as [|n IH]; intros a b H; [reflexivity|]; cbn [det]; apply dot_same; intros k Hk.
  rewrite (H k O) by lia; f_equal; f_equal; apply IH; intros j i Hj Hi; apply H; [skips | lia].
Qed.
Lemma det_comb N : forall j s t u v a, (j < N)%nat ->
  det N (put j (comb s t u v) a) = s * det N (put j u a) + t * det N (put j v a).
Proof.
  induction N as [|n IH]; intros j s t u v a Hj; [lia|]; cbn [det]; apply dot_terms; intros k Hk.
  destruct (Nat.eq_dec k j) as [->|Nk].
  - assert (E : forall z, det n (fun k i => put j z a (skip j k) (S i)) = det n (fun k i => a (skip j k) (S i))) by
      (intros z; apply det_ext; intros l i _ _; skips; reflexivity).
    rewrite !E; unfold put, comb; rewrite Nat.eqb_refl; ring.
  - set (l := if Nat.ltb j k then j else (j - 1)%nat); set (m := fun k' i => a (skip k k') (S i)).
    assert (E : forall z : vec, det n (fun k' i => put j z a (skip k k') (S i)) = det n (put l (fun i => z (S i)) m)).
    { intros z; apply det_ext; intros k' i Hk' _; unfold m, l; destruct (Nat.ltb_spec j k); skips; reflexivity. }
    rewrite !E; change (fun i => comb s t u v (S i)) with (comb s t (fun i => u (S i)) (fun i => v (S i))).
    rewrite IH by (unfold l; destruct (Nat.ltb_spec j k); lia); skips; ring.
Qed.
Lemma put_same j a : put j (a j) a = a.
Proof. extensionality k; unfold put; destruct (Nat.eqb_spec k j); subst; reflexivity. Qed.
Lemma put_swap j k u v a : j <> k -> put j u (put k v a) = put k v (put j u a).
Proof. intros H; extensionality l; skips; reflexivity. Qed.

(** ** Equal columns *)
Lemma det_adjacent N : forall j a, (S j < N)%nat -> (forall i, a j i = a (S j) i) -> det N a = 0.
Proof.
  induction N as [|n IH]; intros j a Hj H; [lia|]; cbn [det]; rewrite (dot_skip n j) by lia.
  rewrite (dot_alone n _ _ j); [| lia |].
  - replace (skip j j) with (S j) by skips; rewrite <- (H O).
    rewrite (det_ext n (fun k i => a (skip (S j) k) (S i)) (fun k i => a (skip j k) (S i))); [cbn [pow]; ring|].
    intros k i _ _; destruct (Nat.eq_dec k j) as [->|Nk]; [|skips; reflexivity].
    replace (skip (S j) j) with j by skips; replace (skip j j) with (S j) by skips; apply H.
  - intros k Hk Nk; set (l := if Nat.ltb k j then (j - 1)%nat else j).
    rewrite (IH l); [ring | unfold l; destruct (Nat.ltb_spec k j); lia|]; intros i; unfold l.
    destruct (Nat.ltb_spec k j).
    + replace (skip j k) with k by skips; replace (skip k (j - 1)) with j by skips; replace (skip k (S (j - 1))) with (S
        j) by skips; apply H.
    + replace (skip j k) with (S k) by skips; replace (skip (S k) j) with j by skips; replace (skip (S k) (S j)) with (S
        j) by skips; apply H.
Qed.
Lemma det_swap N j u v a : (S j < N)%nat -> det N (put j u (put (S j) v a)) = - det N (put j v (put (S j) u a)).
Proof.
  intros Hj; assert (Z : forall z, det N (put j z (put (S j) z a)) = 0) by (intros z; apply (det_adjacent N j); [exact
    Hj|]; intros i; skips; reflexivity).
  pose proof (Z (comb 1 1 u v)) as X; rewrite det_comb in X by lia; rewrite !(put_swap j (S j)) in X by lia.
  rewrite !det_comb in X by lia; rewrite <- !(put_swap j (S j)) in X by lia; rewrite !Z in X; lra.
Qed.
Lemma det_twice N : forall d p q a, (q = S p + d)%nat -> (q < N)%nat -> a p = a q -> det N a = 0.
Proof.
  induction d as [|d IH]; intros p q a E Hq H.
  - replace q with (S p) in * by lia; apply (det_adjacent N p a Hq); intros i; rewrite H; reflexivity.
  - set (j := (p + S d)%nat); assert (Ea : a = put j (a j) (put (S j) (a q) a)).
    { extensionality k; skips; f_equal; lia. }
    rewrite Ea, det_swap by lia; rewrite (IH p j); [ring | lia | lia | skips; exact H].
Qed.
Lemma det_equal N p q a : (p < N)%nat -> (q < N)%nat -> p <> q -> a p = a q -> det N a = 0.
Proof.
  intros Hp Hq Ne H; destruct (Nat.lt_ge_cases p q); [apply (det_twice N (q - S p) p q) | apply (det_twice N (p - S q) q
    p)]; auto; lia.
Qed.
Lemma det_put N j k a : (j < N)%nat -> (k < N)%nat -> det N (put j (a k) a) = if Nat.eqb k j then det N a else 0.
Proof.
  intros Hj Hk; destruct (Nat.eqb_spec k j) as [->|Ne]; [rewrite put_same; reflexivity|].
  apply (det_equal N j k); auto; skips; reflexivity.
Qed.

(** ** A + q c, and Cramer's rule *)
Lemma det_cramer N j a v : (j < N)%nat -> det N (put j (fun i => dot N (fun k => a k i) v) a) = v j * det N a.
Proof.
  intros Hj; assert (G : forall m, (m <= N)%nat -> det N (put j (fun i => dot m (fun k => a k i) v) a) = if Nat.ltb j m
    then v j * det N a else 0).
  { induction m as [|m IH]; intros Hm.
    - rewrite <- (Rmult_0_l (det N a)); replace (fun i => dot 0 (fun k => a k i) v) with (comb 0 0 (a j) (a j)) by
        (extensionality i; unfold comb; cbn; ring). rewrite det_comb, put_same by exact Hj; skips; ring.
    - replace (fun i => dot (S m) (fun k => a k i) v) with (comb 1 (v m) (fun i => dot m (fun k => a k i) v) (a m)) by
        (extensionality i; unfold comb; cbn; ring). rewrite det_comb, IH, det_put by lia; skips; subst; ring. }
  rewrite (G N (le_n N)); skips; reflexivity.
Qed.
Lemma det_rank_one N a c q : det N (fun j => comb 1 (c j) (a j) q) = det N a + dot N c (fun j => det N (put j q a)).
Proof.
  set (b m j := if Nat.ltb j m then comb 1 (c j) (a j) q else a j).
  assert (Eb : forall m, b (S m) = put m (comb 1 (c m) (a m) q) (b m)) by (intros m; extensionality k; unfold b; skips;
    subst; trivial).
  (* beside q, multiples of q do not count *)
  assert (Q : forall p m, (p < N)%nat -> (m <= p)%nat -> det N (put p q (b m)) = det N (put p q a)).
  { intros p; induction m as [|m IH]; intros Hp Hm; [reflexivity|]; rewrite Eb, put_swap, det_comb by lia.
    rewrite <- (IH Hp) by lia; replace (put m (a m) (put p q (b m))) with (put p q (b m)) by (extensionality k; unfold
      b; skips; subst; trivial).
    rewrite (det_equal N p m (put m q _)); try lia; [ring | skips; reflexivity]. }
  assert (G : forall m, (m <= N)%nat -> det N (b m) = det N a + dot m c (fun j => det N (put j q a))).
  { induction m as [|m IH]; intros Hm; [cbn; rewrite Rplus_0_r; reflexivity|]; rewrite Eb, det_comb, Q by lia.
    replace (put m (a m) (b m)) with (b m) by (extensionality k; unfold b; skips; subst; trivial).
    rewrite IH by lia; cbn [dot]; ring. }
  rewrite <- (G N (le_n N)); apply det_ext; intros j i Hj _; unfold b; skips; reflexivity.
Qed.

(** ** det = 0: a kernel *)
Lemma det_kernel N : forall a, det N a = 0 -> exists x, (exists i, (i < N)%nat /\ x i <> 0) /\
  forall i, (i < N)%nat -> dot N (fun j => a j i) x = 0.
Proof.
  induction N as [|n IH]; intros a H; [cbn in H; lra|].
  destruct (Classical_Prop.classic (exists p, (p <= n)%nat /\ a p O <> 0)) as [(p & Hp & Np)|All].
  - set (c j := if Nat.eqb j p then 0 else - (a j O / a p O)); set (b := fun j => comb 1 (c j) (a j) (a p)).
    assert (B0 : forall j, j <> p -> b j O = 0) by (intros j Hj; unfold b, c, comb; skips; field; exact Np).
    assert (Eb : det (S n) b = 0).
    { unfold b; rewrite det_rank_one, H, (dot_same _ _ _ zero zero), dot_zero; [ring|]; intros k Hk.
      rewrite det_put by lia; unfold c, zero; skips; ring. }
    cbn [det] in Eb; rewrite (dot_alone _ _ _ p) in Eb; [| lia | intros k _ Nk; rewrite B0 by exact Nk; ring].
    assert (Bp : b p O = a p O) by (unfold b, c, comb; skips; ring); rewrite Bp in Eb.
    destruct (IH (fun k i => b (skip p k) (S i))) as (y & (i & Hi & Ny) & Hy).
    { apply Rmult_integral in Eb; destruct Eb as [Eb|Eb]; [|contradiction]; apply Rmult_integral in Eb.
      destruct Eb as [Eb|Eb]; [exfalso; revert Eb; apply pow_nonzero; lra | exact Eb]. }
    set (s := dot n (fun k => a (skip p k) O) y).
    set (x j := if Nat.eqb j p then - (s / a p O) else y (if Nat.ltb j p then j else (j - 1)%nat)).
    assert (Ex : forall k, x (skip p k) = y k) by (intros k; unfold x; skips; f_equal; lia).
    assert (Xp : x p = - (s / a p O)) by (unfold x; rewrite Nat.eqb_refl; reflexivity).
    exists x; split; [exists (skip p i); split; [skips | rewrite Ex; exact Ny]|]; intros k Hk.
    rewrite (dot_skip n p) by exact Hp; rewrite Xp.
    rewrite (dot_same n _ (fun k => x (skip p k)) (fun j => a (skip p j) k) y) by (intros l _; rewrite Ex; reflexivity).
    destruct k as [|k]; [fold s; field; exact Np|]; specialize (Hy k ltac:(lia)).
    rewrite (dot_terms n _ y (fun j => a (skip p j) (S k)) y (fun j => a (skip p j) O) y 1 (- (a p (S k) / a p O))) in
      Hy; [fold s in Hy; lra|].
    intros l _; assert (Nl : skip p l <> p) by skips; unfold b, c, comb; skips; field; exact Np.
  - destruct (underdetermined n (fun k j => a j (S k))) as (x & (i & Hi & Nx) & Hx); exists x.
    split; [exists i; split; [lia | exact Nx]|]; intros [|k] Hk; [|apply Hx; lia].
    rewrite (dot_same _ _ _ zero zero), dot_zero; [reflexivity|]; intros j Hj; unfold zero.
    destruct (Req_dec (a j O) 0) as [->|Nj]; [ring | exfalso; apply All; exists j; split; [lia | exact Nj]].
Qed.

(** ** Continuity *)
Lemma det_near N l : 0 <= l -> exists m, 0 <= m /\ forall a b h, (forall j, (j < N)%nat -> within N l (a j) /\ within N
  l (b j) /\ within N h (minus (a j) (b j))) -> 0 <= h -> Rabs (det N a) <= m /\ Rabs (det N a - det N b) <= m * h.
Proof.
  intros Hl; induction N as [|n (m & Hm & IH)].
  { exists 1; split; [lra|]; intros a b h _ Hh; cbn; rewrite Rminus_eq_0, Rabs_R0, Rabs_R1; lra. }
  assert (N0 : 0 <= INR (S n)) by apply pos_INR; assert (Lm : 0 <= l * m) by (apply Rmult_le_pos; lra).
  exists (INR (S n) * (l * m + m)); split; [apply Rmult_le_pos; lra|]; intros a b h H Hh.
  assert (T : forall k, (k <= S n)%nat -> let s a := dot k (fun j => (-1) ^ j * det n (fun k i => a (skip j k) (S i)))
    (fun j => a j O) in Rabs (s a) <= INR k * (l * m + m) /\ Rabs (s a - s b) <= INR k * ((l * m + m) * h)).
  { induction k as [|k IHk]; intros Hk s; [unfold s; cbn; rewrite Rminus_eq_0, Rabs_R0; lra|].
    destruct (IHk ltac:(lia)) as [S1 S2]; unfold s; cbn [dot]; rewrite S_INR, !(Rmult_plus_distr_r (INR k)), !Rmult_1_l.
    destruct (IH (fun l i => a (skip k l) (S i)) (fun l i => b (skip k l) (S i)) h) as [D1 D2]; [|exact Hh|].
    { intros j Hj; destruct (H (skip k j)) as (A & B & C); [skips|]; repeat split; intros i Hi; [apply (A (S i)) | apply
      (B (S i)) | apply (C (S i))]; lia. }
    destruct (H k ltac:(lia)) as (A & B & C); specialize (A O ltac:(lia)); specialize (B O ltac:(lia)); specialize (C O
      ltac:(lia)); unfold minus in C; set (da := det n _) in D1, D2 |- *; set (db := det n (fun l i => b _ _)) in D2 |-
        *.
    assert (P : Rabs ((-1) ^ k) <= 1) by (rewrite pow_1_abs; lra).
    split; [eapply Rle_trans; [apply Rabs_triang|]; apply Rplus_le_compat; [exact S1|] |].
    - pose proof (product _ _ _ _ (product _ _ _ _ P D1) A); lra.
    - match goal with |- Rabs ?g <= _ => replace g with ((dot k (fun j => (-1) ^ j * det n (fun k i => a (skip j k) (S
      i))) (fun j => a j O) - dot k (fun j => (-1) ^ j * det n (fun k i => b (skip j k) (S i))) (fun j => b j O)) +
      ((-1) ^ k * (da - db) * b k O + (-1) ^ k * da * (a k O - b k O))) by ring end.
      pose proof (product _ _ _ _ (product _ _ _ _ P D2) B); pose proof (product _ _ _ _ (product _ _ _ _ P D1) C).
      eapply Rle_trans; [apply Rabs_triang|]; apply Rplus_le_compat; [exact S2|]; eapply Rle_trans; [apply
      Rabs_triang|]; lra. }
  destruct (T (S n) (le_n _)) as [T1 T2]; split; [exact T1 | rewrite Rmult_assoc; exact T2].
Qed.
Lemma det_axis N : det N axis = 1.
Proof.
  induction N as [|n IH]; [reflexivity|]; cbn [det]; rewrite (dot_alone _ _ _ O); [| lia |].
  - rewrite (det_ext n _ axis), IH; [unfold axis; cbn; ring | reflexivity].
  - intros k _ Nk; unfold axis at 2; destruct (Nat.eqb_spec 0 k); [lia | ring].
Qed.
Lemma dot_axis N b j : (j < N)%nat -> dot N b (axis j) = b j.
Proof.
  intros Hj; rewrite (dot_alone N b _ j Hj); [unfold axis; rewrite Nat.eqb_refl; ring|].
  intros k _ Nk; unfold axis; destruct (Nat.eqb_spec k j); [contradiction | ring].
Qed.
Lemma within_axis N j : within N 1 (axis j).
Proof. intros i _; unfold axis; destruct (Nat.eqb i j); rewrite ?Rabs_R0, ?Rabs_R1; lra. Qed.

(** det (I - t D) is 1 at t = 0; where it is negative at t = 1, it is 0 between them. *)
Lemma real_multiplier N D : det_less N (mult N D) < 0 -> exists lambda v, 1 < lambda /\ (exists i, (i < N)%nat /\ v i <>
  0) /\ forall i, (i < N)%nat -> mult N D v i = lambda * v i.
Proof.
  intros H; set (f t := det N (fun j => comb 1 (- t) (axis j) (mult N D (axis j)))).
  assert (F1 : f 1 = det_less N (mult N D)) by (apply det_ext; intros; unfold comb, minus; ring).
  assert (F0 : f 0 = 1) by (rewrite <- (det_axis N); apply det_ext; intros; unfold comb; ring).
  destruct (mult_bound N D) as (m & Hm & Bd), (det_near N (1 + 2 * m)) as (K & HK & Near); [lra|].
  assert (Cf : forall t, 0 <= t <= 1 -> continuity_pt (fun t => - f t) t).
  { intros t Ht; apply continuity_pt_opp; intros eps Heps; destruct (small_enough (eps / 2) (K * m)) as (r & Hr & Lr);
      [lra | apply Rmult_le_pos; lra|].
    exists r; split; [lra|]; intros s [_ Hs]; cbn in Hs |- *; unfold R_dist in *; apply Rabs_def2 in Hs.
    assert (Bu : forall j, within N m (mult N D (axis j))) by (intros j; rewrite <- (Rmult_1_r m); apply
      Bd; [lra | apply within_axis]).
    destruct (Near (fun j => comb 1 (- s) (axis j) (mult N D (axis j))) (fun j => comb 1 (- t) (axis j) (mult N D (axis
      j))) (m * r)) as [_ B]; [| apply Rmult_le_pos; lra | unfold f; replace (K * (m * r)) with (K * m * r) in B by
      ring; lra].
    assert (One : forall u j, Rabs u <= 2 -> within N (1 + 2 * m) (comb 1 u (axis j) (mult N D (axis j)))) by (intros u
      j Hu i Hi; unfold comb; rewrite Rmult_1_l; apply triangle2; [apply (within_axis N j i Hi) | apply product; [exact
      Hu | apply Bu, Hi]]).
    intros j Hj; split; [apply One, Rabs_le; lra | split; [apply One, Rabs_le; lra|]]; intros i Hi; unfold minus, comb.
    replace (_ - _) with (mult N D (axis j) i * (t - s)) by ring; apply product; [apply Bu, Hi | apply Rabs_le; lra]. }
  destruct (IVT_interv (fun t => - f t) 0 1 Cf) as (z & Hz & Ez); [lra | rewrite F0; lra | rewrite F1; lra|].
  destruct (det_kernel N (fun j => comb 1 (- z) (axis j) (mult N D (axis j)))) as (v & Hv & Kv); [fold (f z); lra|].
  assert (Z0 : z <> 0) by (intros ->; lra); assert (Z1 : z <> 1) by (intros ->; lra); exists (/ z), v.
  split; [rewrite <- Rinv_1; apply Rinv_lt_contravar; lra | split; [exact Hv|]]; intros i Hi; specialize (Kv i Hi).
  rewrite (dot_terms N _ v (axis i) v (D i) v 1 (- z)) in Kv.
  - rewrite (dot_alone N (axis i) v i Hi) in Kv; [|intros k _ Nk; unfold axis; destruct (Nat.eqb_spec k i);
      [contradiction | ring]]. unfold axis in Kv; rewrite Nat.eqb_refl in Kv; unfold mult.
    apply (Rmult_eq_reg_l z); [field_simplify; lra | exact Z0].
  - intros k Hk; unfold comb; replace (mult N D (axis k) i) with (D i k) by (symmetry; apply dot_axis, Hk).
    unfold axis; rewrite (Nat.eqb_sym i k); ring.
Qed.
