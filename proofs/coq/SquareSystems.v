(** * A square linear system with trivial kernel is solvable, with a bound

    n equations in n + 1 unknowns have a nonzero solution; the rest follows. *)

From Coq Require Import Reals Arith Lra Lia.
From Grazing Require Import StatementOrbits OrbitVectors OrbitRemainder.
Open Scope R_scope.

Lemma dot_one_less n c x : dot (S n) c x = dot n c x + c n * x n. Proof. reflexivity. Qed.
Lemma dot_comb_l n c c' a a' x : dot n (comb a a' c c') x = a * dot n c x + a' * dot n c' x.
Proof. induction n as [|n IH]; cbn; [ring|]; rewrite IH; unfold comb; ring. Qed.
Lemma underdetermined n : forall a : nat -> vec, exists x : vec,
  (exists i, (i <= n)%nat /\ x i <> 0) /\ forall k, (k < n)%nat -> dot (S n) (a k) x = 0.
Proof.
  induction n as [|n IH]; intros a.
  - exists (fun _ => 1); split; [exists 0%nat; split; [lia | lra] | intros; lia].
  - destruct (Classical_Prop.classic (exists p, (p <= n)%nat /\ a p (S n) <> 0)) as [(p & Hp & Hne)|Hall].
    + pose (row k := if (k <? p)%nat then k else S k).
      destruct (IH (fun k => comb 1 (- (a (row k) (S n) / a p (S n))) (a (row k)) (a p))) as (x & (i & Hi & Hx) & Hk).
      pose (y := fun i => if (i <=? n)%nat then x i else - dot (S n) (a p) x / a p (S n)).
      assert (Ey : forall c, dot (S n) c y = dot (S n) c x).
      { intros c; apply dot_ext; intros j Hj; unfold y; destruct (Nat.leb_spec j n); [reflexivity | lia]. }
      assert (EyS : y (S n) = - dot (S n) (a p) x / a p (S n)) by (unfold y; destruct (Nat.leb_spec (S n) n);
        [lia | reflexivity]).
      exists y; split.
      * exists i; split; [lia|]; unfold y; destruct (Nat.leb_spec i n); [exact Hx | lia].
      * intros k Hkn; rewrite dot_one_less, Ey, EyS. destruct (Nat.eq_dec k p) as [->|Hkp]; [field; exact Hne|].
        assert (Hrow : exists k', (k' < n)%nat /\ row k' = k).
        { unfold row; destruct (Nat.lt_ge_cases k p) as [Hlt|Hge].
          - exists k; split; [lia|]; destruct (Nat.ltb_spec k p); [reflexivity | lia].
          - exists (k - 1)%nat; split; [lia|]; destruct (Nat.ltb_spec (k - 1) p); lia. }
        destruct Hrow as (k' & Hk' & <-); specialize (Hk k' Hk'); rewrite dot_comb_l in Hk.
        rewrite <- Hk; field; exact Hne.
    + exists (fun i => if (i =? S n)%nat then 1 else 0); split.
      * exists (S n); split; [lia|]; rewrite Nat.eqb_refl; lra.
      * intros k Hk; rewrite dot_one_less, Nat.eqb_refl. rewrite (dot_ext (S n) (a k) _ zero), dot_zero.
        -- destruct (Req_dec (a k (S n)) 0) as [->|Hne]; [ring|].
           exfalso; apply Hall; exists k; split; [lia | exact Hne].
        -- intros j Hj; unfold zero; destruct (Nat.eqb_spec j (S n)); [lia | reflexivity].
Qed.

Section Square.
Variables (n : nat) (a : nat -> vec).
Hypothesis Hker : forall x, (forall k, (k < n)%nat -> dot n (a k) x = 0) -> forall i, (i < n)%nat -> x i = 0.

Lemma solvable (r : vec) : exists x, forall k, (k < n)%nat -> dot n (a k) x = r k.
Proof.
  destruct (underdetermined n (fun k i => if (i <? n)%nat then a k i else - r k)) as (x & (i & Hi & Hx) & Hk).
  assert (E : forall k, (k < n)%nat -> dot n (a k) x = r k * x n).
  { intros k Hkn; specialize (Hk k Hkn); rewrite dot_one_less, Nat.ltb_irrefl in Hk.
    enough (dot n (fun i => if (i <? n)%nat then a k i else - r k) x = dot n (a k) x) by lra.
    assert (Hc : forall m c c', (forall i, (i < m)%nat -> c i = c' i) -> dot m c x = dot m c' x).
    { intros m c c'; induction m as [|m IHm]; intros H; [reflexivity|]; cbn.
      rewrite IHm, H by (intros; try apply H; lia); reflexivity. }
    apply Hc; intros j Hj; destruct (Nat.ltb_spec j n); [reflexivity | lia]. }
  destruct (Req_dec (x n) 0) as [H0|Hne].
  - exfalso; apply Hx; destruct (Nat.eq_dec i n) as [->|Hin]; [exact H0|].
    apply Hker; [|lia]; intros k Hkn; rewrite E, H0 by exact Hkn; ring.
  - exists (comb (/ x n) 0 x x); intros k Hkn; rewrite dot_comb, E by exact Hkn; field; exact Hne.
Qed.
Lemma solvable_bounded : exists K, 0 <= K /\ forall r t, within n t r -> 0 <= t ->
  exists x, within n (K * t) x /\ forall k, (k < n)%nat -> dot n (a k) x = r k.
Proof.
  assert (H : forall m, (m <= n)%nat -> exists K, 0 <= K /\ forall r t, within n t r -> 0 <= t -> exists x,
    within n (K * t) x /\ forall k, (k < n)%nat -> dot n (a k) x = if (k <? m)%nat then r k else 0).
  { induction m as [|m IH]; intros Hm.
    - exists 0; split; [lra|]; intros r t _ Ht; exists zero; split; [apply within_zero; lra|].
      intros k _; apply dot_zero.
    - destruct (IH ltac:(lia)) as (K & HK & H), (solvable (fun k => if (k =? m)%nat then 1 else 0)) as (y & Hy).
      destruct (within_exists n y) as (Y & HY & Hyb); exists (K + Y); split; [lra|]; intros r t Hr Ht.
      destruct (H r t Hr Ht) as (x & Hx & Hk); exists (comb 1 (r m) x y); split.
      + intros i Hi; unfold comb; rewrite Rmult_1_l, Rmult_plus_distr_r, (Rmult_comm Y).
        apply triangle2; [apply Hx, Hi | apply Rabs_mult_le; [apply Hr; lia | apply Hyb, Hi]].
      + intros k Hkn; rewrite dot_comb, (Hk k Hkn), (Hy k Hkn).
        destruct (Nat.ltb_spec k m), (Nat.eqb_spec k m), (Nat.ltb_spec k (S m)); subst; try lia; ring. }
  destruct (H n (le_n n)) as (K & HK & HS); exists K; split; [exact HK|]; intros r t Hr Ht.
  destruct (HS r t Hr Ht) as (x & Hx & Hk); exists x; split; [exact Hx|]; intros k Hkn.
  rewrite (Hk k Hkn); destruct (Nat.ltb_spec k n); [reflexivity | lia].
Qed.
End Square.

(** The same for a linear map instead of a matrix. *)
Lemma linear_map_bounded n (T : vec -> vec) : (forall a c x y k, (k < n)%nat -> T (comb a c x y) k = a * T x k + c * T y
  k) -> (forall x y, (forall i, (i < n)%nat -> x i = y i) -> forall k, (k < n)%nat -> T x k = T y k) ->
  (forall x, (forall k, (k < n)%nat -> T x k = 0) -> forall i, (i < n)%nat -> x i = 0) -> exists K, 0 <= K /\
  forall r t, within n t r -> 0 <= t -> exists x, within n (K * t) x /\ forall k, (k < n)%nat -> T x k = r k.
Proof.
  intros Hlin Hext Hker; pose (unit i := (fun j => if (j =? i)%nat then 1 else 0) : vec).
  assert (E : forall x k, (k < n)%nat -> T x k = dot n (fun i => T (unit i) k) x).
  { intros x k Hk.
    assert (H : forall m, (m <= n)%nat -> T (fun i => if (i <? m)%nat then x i else 0) k = dot m (fun i => T (unit i) k)
      x).
    { induction m as [|m IH]; intros Hm.
      - cbn [dot]; transitivity (T (comb 0 0 zero zero) k).
        + apply Hext; [|exact Hk]; intros i _; unfold comb, zero; destruct (Nat.ltb_spec i 0); [lia | ring].
        + rewrite Hlin by exact Hk; ring.
      - rewrite dot_one_less, <- IH by lia.
        transitivity (T (comb 1 (x m) (fun i => if (i <? m)%nat then x i else 0) (unit m)) k);
          [|rewrite Hlin by exact Hk; ring].
        apply Hext; [|exact Hk]; intros i _; unfold comb, unit.
        destruct (Nat.ltb_spec i (S m)), (Nat.ltb_spec i m), (Nat.eqb_spec i m); subst; try lia; ring. }
    rewrite <- (H n (le_n n)); apply Hext; [|exact Hk]; intros i Hi. destruct (Nat.ltb_spec i n); [reflexivity | lia]. }
  destruct (solvable_bounded n (fun k i => T (unit i) k)) as (K & HK & H).
  - intros x Hx; apply Hker; intros k Hk; rewrite E by exact Hk; apply Hx, Hk.
  - exists K; split; [exact HK|]; intros r t Hr Ht; destruct (H r t Hr Ht) as (x & Hx & Hk).
    exists x; split; [exact Hx|]; intros k Hkn; rewrite E by exact Hkn; apply Hk, Hkn.
Qed.
