(** * Orbits from impact to impact: the trap; what grows from impact to impact grows along the orbit *)
From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import StatementPlane.
From Grazing Require Import StatementAttractor AttractorAlgebra AttractorDerivative AttractorEigen.
Open Scope R_scope.

Section Map.
Variables l1 l2 b nu : R.
Hypothesis Hl : 0 < l2 < l1.
Hypothesis Hl1 : l1 < 1.
Hypothesis Hb : 0 < b.
Hypothesis Hnu : 0 < nu.
Notation height := (height l1 l2 nu).
Notation step := (step l1 l2 b nu).
Notation iterate := (iterate l1 l2 b nu).
Notation change := (change l1 l2).
Notation cone := (cone l1 l2).
Notation trap := (trap l1 l2 b nu).
Notation along := (along l1 l2 b nu).
Notation D := (D l1 l2 b nu).

Lemma step_wedge x : wedge x -> wedge (step x).
Proof.
  unfold wedge, StatementAttractor.step. intros H. destruct (Rle_dec 0 (height x)); simpl.
  - nra.
  - pose proof (sqrt_pos (- height x)). assert (0 <= b * sqrt (- height x)) by (apply Rmult_le_pos; lra). nra.
Qed.
Lemma iterate_wedge n x : wedge x -> wedge (iterate n x).
Proof. intros H. induction n as [|n IH]; [exact H|]. apply step_wedge. exact IH. Qed.
Lemma never_iterate n x : never_grazes l1 l2 b nu x -> never_grazes l1 l2 b nu (iterate n x).
Proof. intros H k. rewrite <- iterate_add. apply H. Qed.

Lemma free_step x : 0 <= height x -> step x = (l1 * fst x, l2 * snd x).
Proof. intros H. unfold StatementAttractor.step. destruct (Rle_dec 0 (height x)); [reflexivity|lra]. Qed.
Lemma impact x : height x <= 0 ->
  step x = (l1 * fst x + b * sqrt (- height x), l2 * snd x + b * sqrt (- height x)).
Proof.
  intros H. unfold StatementAttractor.step. destruct (Rle_dec 0 (height x)); [|reflexivity].
  replace (- height x) with 0 by lra. rewrite sqrt_0. f_equal; ring.
Qed.
Lemma free j x : (forall k, (k < j)%nat -> 0 <= height (iterate k x)) ->
  iterate j x = (l1 ^ j * fst x, l2 ^ j * snd x) /\ along j x = diag (l1 ^ j) (l2 ^ j).
Proof.
  induction j as [|j IH]; intros H.
  - simpl. split; [|reflexivity]. rewrite (surjective_pairing x) at 1. f_equal; ring.
  - destruct IH as [I1 I2]; [intros k Hk; apply H; lia|]. simpl. change (Nat.iter j step x) with (iterate j x).
    assert (H0 : 0 <= height (iterate j x)) by (apply H; lia). split.
    + change (iterate (S j) x) with (step (iterate j x)). rewrite free_step, I1 by exact H0. simpl. f_equal; ring.
    + unfold AttractorDerivative.D. destruct (Rle_dec 0 (height (iterate j x))); [|lra]. rewrite I2.
      unfold diag, mul; simpl. f_equal; ring.
Qed.

(** ** The next impact comes *)
Lemma first N x : wedge x -> l1 ^ S N * fst x < nu -> exists n, (n <= N)%nat /\ height (iterate n x) < 0 /\
  forall k, (k < n)%nat -> 0 <= height (iterate k x).
Proof.
  revert x. induction N as [|N IH]; intros x Hx HN; destruct (Rlt_or_le (height x) 0) as [C|C].
  - exists 0%nat. repeat split; [lia|exact C|intros; lia].
  - exfalso. unfold StatementAttractor.height, wedge in *. simpl in HN. nra.
  - exists 0%nat. repeat split; [lia|exact C|intros; lia].
  - destruct (IH (step x)) as (n & H1 & H2 & H3).
    + apply step_wedge. exact Hx.
    + rewrite free_step by exact C. simpl in *. lra.
    + exists (S n). split; [lia|]. split; [rewrite iterate_S; exact H2|]. intros [|k] Hk; [exact C|].
      rewrite iterate_S. apply H3. lia.
Qed.
Lemma reach t : exists N, forall p, p <= t -> l1 ^ S N * p < nu.
Proof.
  destruct (pow_lt_1_zero l1 (Rabs_def1 _ _ Hl1 ltac:(lra)) (nu / (Rabs t + 1))) as (N & HN).
  { apply Rdiv_lt_0_compat; [lra|]. pose proof (Rabs_pos t). lra. }
  exists N. intros p Hp. specialize (HN (S N) ltac:(lia)). assert (HL : 0 < l1 ^ S N) by (apply pow_lt; lra).
  rewrite Rabs_pos_eq in HN by lra. pose proof (Rabs_pos t). pose proof (Rle_abs t). assert (l1 ^ S N * p <= l1 ^ S N
    * (Rabs t + 1)) by (apply Rmult_le_compat_l; lra). apply Rmult_lt_compat_r with (r := Rabs t + 1) in HN;
    [|lra]. replace (nu / (Rabs t + 1) * (Rabs t + 1)) with nu in HN by (field; lra). lra.
Qed.

(** ** Section coordinates *)
Definition first_return (n : nat) (x : R * R) : Prop := (1 <= n)%nat /\ height (iterate n x) < 0 /\
  forall k, (1 <= k < n)%nat -> 0 <= height (iterate k x).

Lemma flight_point n x : height x <= 0 -> (1 <= n)%nat -> (forall k, (1 <= k < n)%nat -> 0 <= height (iterate
  k x)) ->
  let c := height x + nu in let q := l2 * snd x in let sg := q + b * sqrt (- height x) in
  height (iterate n x) + nu = l1 ^ n * c + (l1 ^ n - l2 ^ n) * sg /\ l2 * snd (iterate n x) = l2 ^ n * sg.
Proof.
  intros Hx Hn Hk. destruct n as [|n]; [lia|]. rewrite iterate_S. destruct (free n (step x)) as [-> _].
  { intros k H. rewrite <- iterate_S. apply Hk. lia. }
  rewrite (impact x Hx). unfold StatementAttractor.height at 1 3. simpl. split; ring.
Qed.
Lemma return_point n x : height x <= 0 -> first_return n x ->
  let c := height x + nu in let q := l2 * snd x in let sg := q + b * sqrt (- height x) in
  height (iterate n x) + nu = l1 ^ n * c + (l1 ^ n - l2 ^ n) * sg /\ l2 * snd (iterate n x) = l2 ^ n * sg.
Proof. intros Hx (Hn & _ & Hk). exact (flight_point n x Hx Hn Hk). Qed.

Lemma return_trap n x : wedge x -> height x <= 0 -> first_return n x -> trap (iterate n x).
Proof.
  intros Hw Hx Hr. pose proof (return_point n x Hx Hr) as [E1 E2]. simpl in E1, E2.
  destruct Hr as (Hn & Hh & Hk). pose proof (iterate_wedge n x Hw) as Hw'. set (y := sqrt (- height x)) in *.
  assert (Hy : 0 <= y) by apply sqrt_pos. assert (Hy2 : y ^ 2 = nu - (height x + nu)). { unfold y. simpl.
  rewrite Rmult_1_r, sqrt_sqrt by lra. ring. } set (c := height x + nu) in *. set (q := l2 * snd x) in *.
  assert (Hc : 0 <= c) by (unfold c, StatementAttractor.height, wedge in *; nra). assert (Hq : 0 <= q) by (unfold q,
    wedge in *; nra). assert (Hby : 0 <= b * y) by (apply Rmult_le_pos; lra). assert (HK : 0 < l2 ^ n) by (apply
    pow_lt; lra). assert (HL : 0 < l1 ^ n) by (apply pow_lt; lra). pose proof (power_ratio l1 l2 n Hl Hn) as HKL.
  split; [exact Hw'|]. split; [|split; [|lra]].
  - assert (T := trapped_q l1 l2 Hl nu (l1 ^ n) (l2 ^ n) c (height (iterate n x) + nu) (q + b * y) HK HKL HL Hc
      ltac:(lra) E1 ltac:(lra)). rewrite <- E2 in T. apply le_div; [lra|]. apply (Rmult_le_reg_l l2); lra.
  - destruct n as [|[|n]]; [lia| |].
    + apply (trapped_c l1 l2 Hl nu b y c _ q); try assumption; lra.
    + assert (H0 : 0 <= height (iterate (S n) x)) by (apply Hk; lia). change (iterate (S (S n)) x) with (step (iterate
        (S n) x)). rewrite (free_step _ H0). pose proof (iterate_wedge (S n) x Hw) as Hw2.
      set (z := iterate (S n) x) in *. assert (nu / ((l1 - l2) * b) ^ 2 > 0).
      { apply Rdiv_lt_0_compat; [lra|]. apply pow_lt. apply Rmult_lt_0_compat; lra. }
      set (ep := nu / ((l1 - l2) * b) ^ 2) in *. unfold StatementAttractor.height, wedge in *. simpl. assert (0 <= l1
        * (l1 * fst z - l2 * snd z - nu)) by (apply Rmult_le_pos; lra). assert (0 <= l2 * snd z) by nra. assert (0 <=
        (l1 - l2) * (l2 * snd z)) by (apply Rmult_le_pos; lra). assert (0 <= l1 * nu) by nra.
        assert (0 <= ep * (l1 * nu)) by (apply Rmult_le_pos; lra). nra.
Qed.

(** ** Trapping *)
Lemma bound : exists N, forall x, trap x -> exists n, (n <= S N)%nat /\ first_return n x.
Proof.
  destruct (reach (nu + l2 * (nu / (l1 - l2)) + b * sqrt nu)) as (N & HN). exists N. intros x (Hw & Hq & Hc1 & Hc2).
  assert (Hx : height x <= 0) by lra. destruct (first N (step x)) as (n & H1 & H2 & H3).
  - apply step_wedge. exact Hw.
  - apply HN. rewrite impact by exact Hx. simpl. assert (sqrt (- height x) <= sqrt nu).
    { apply sqrt_le_1_alt. unfold StatementAttractor.height, wedge in *. nra. }
    assert (b * sqrt (- height x) <= b * sqrt nu) by (apply Rmult_le_compat_l; lra). assert (l2 * snd x <= l2 * (nu /
      (l1 - l2))) by (apply Rmult_le_compat_l; lra). unfold StatementAttractor.height in *. lra.
  - exists (S n). split; [lia|]. split; [lia|]. rewrite iterate_S. split; [exact H2|]. intros [|k] Hk; [lia|].
    rewrite iterate_S. apply H3. lia.
Qed.
Lemma absorbed x : wedge x -> exists n, trap (iterate n x).
Proof.
  intros Hw. destruct (reach (fst x)) as (N & HN). destruct (first N x Hw (HN _ (Rle_refl _))) as (n & _ & Hn & _).
  set (z := iterate n x) in *. assert (Wz : wedge z) by (apply iterate_wedge; exact Hw).
  destruct (reach (fst (step z))) as (N' & HN'). destruct (first N' (step z) (step_wedge z Wz) (HN' _ (Rle_refl _)))
    as (m & _ & Hm & Hk). exists (S m + n)%nat. rewrite iterate_add. apply return_trap; [exact Wz|fold z;
    lra|]. split; [lia|]. rewrite iterate_S. split; [exact Hm|]. intros [|k] H; [lia|]. rewrite iterate_S.
  apply Hk. lia.
Qed.

(** ** What a return does to tangent vectors *)
Lemma return_vector n x v : height x < 0 -> first_return n x ->
  let s := b / (2 * sqrt (- height x)) in let dc := change v in let ds := l2 * snd v - s * dc in
  change (apply (along n x) v) = l1 ^ n * dc + (l1 ^ n - l2 ^ n) * ds /\
  l2 * snd (apply (along n x) v) = l2 ^ n * ds.
Proof.
  intros Hh (Hn & _ & Hk) s dc ds. assert (Ea : apply (along n x) v = (l1 ^ (n - 1) * (dc + ds), l2 ^ (n - 1) * ds)).
  { destruct n as [|n]; [lia|]. replace (S n - 1)%nat with n by lia. replace (S n) with (n + 1)%nat by lia.
    rewrite along_add. change (iterate 1 x) with (step x). destruct (free n (step x)) as [_ ->].
    { intros k H. rewrite <- iterate_S. apply Hk. lia. }
    simpl. unfold AttractorDerivative.D, StatementAttractor.iterate; simpl. destruct (Rle_dec 0 (height x)) as [Z|_];
      [lra|]. fold s. unfold ds, dc, StatementAttractor.change, apply, mul, diag, one; simpl. f_equal; ring. }
  rewrite Ea. unfold StatementAttractor.change at 1. destruct n as [|n]; [lia|]. replace (S n - 1)%nat with n by lia.
  simpl. split; ring.
Qed.

Lemma norm_free j x v : (forall k, (k < j)%nat -> 0 <= height (iterate k x)) ->
  norm (apply (along j x) v) <= norm v.
Proof.
  intros H. destruct (free j x H) as [_ ->]. apply norm_le. unfold apply, diag; simpl.
  assert (A : 0 <= l1 ^ j <= 1) by (split; [apply pow_le; lra|rewrite <- (pow1 j); apply pow_incr; lra]).
  assert (B : 0 <= l2 ^ j <= 1) by (split; [apply pow_le; lra|rewrite <- (pow1 j); apply pow_incr; lra]).
  pose proof (norm_fst v). pose proof (norm_snd v). pose proof (Rabs_pos (fst v)).
  pose proof (Rabs_pos (snd v)). rewrite !Rmult_0_l, Rplus_0_l, Rplus_0_r, !Rabs_mult, (Rabs_pos_eq (l1 ^ j)),
    (Rabs_pos_eq (l2 ^ j)) by lra. nra.
Qed.

Section Orbit.
Variables (E top : R) (weight : R * R -> R) (N : nat).
Hypothesis HE : 1 < E.
Hypothesis Hweight : forall x, trap x -> 0 < weight x <= top.
Hypothesis return_cone : forall n x v, trap x -> height x < 0 -> first_return n x -> cone v ->
  cone (apply (along n x) v) /\
  E * (weight x * Rabs (change v)) <= weight (iterate n x) * Rabs (change (apply (along n x) v)).
Hypothesis HN : (1 <= N)%nat.
Hypothesis Hret : forall x, trap x -> exists n, (n <= N)%nat /\ first_return n x.

Lemma orbit_growth j : forall i x v, trap x -> never_grazes l1 l2 b nu x -> cone v -> (N * i <= j)%nat ->
  E ^ i * (weight x * Rabs (change v)) <= 2 * top * norm (apply (along j x) v).
Proof.
  induction j as [j IH] using (well_founded_induction lt_wf). intros i x v Hx Hg Hv Hi. assert (Hh : height x < 0).
  { pose proof (Hg 0%nat) as H0. destruct Hx as (_ & _ & _ & H). simpl in H0. lra.
    }
  destruct (Hret x Hx) as (n & HnN & Hr). destruct (return_cone n x v Hx Hh Hr Hv) as [C1 C2].
  assert (Hx' : trap (iterate n x)) by (apply return_trap; [apply Hx|lra|exact Hr]).
  destruct (Hweight x Hx) as [W1 W2]. destruct (Hweight _ Hx') as [W3 W4]. assert (Pv : 0 <= weight x * Rabs (change
    v)) by (apply Rmult_le_pos; [lra|apply Rabs_pos]). destruct (le_lt_dec n j) as [Hnj|Hnj].
  - assert (Hn1 : (1 <= n)%nat) by apply Hr. replace j with (j - n + n)%nat by lia.
    rewrite along_add, apply_mul. assert (G : forall i', (N * i' <= j - n)%nat -> E ^ i' * (weight (iterate n x) *
      Rabs (change (apply (along n x) v))) <= 2 * top * norm (apply (along (j - n) (iterate n x)) (apply (along n x)
      v))).
    { intros i' Hi'. apply IH; try assumption; try lia. apply never_iterate. exact Hg. } destruct i as [|i].
    + specialize (G 0%nat ltac:(lia)). simpl in *. nra.
    + assert (Hi' : (N * i <= j - n)%nat) by nia. specialize (G i Hi'). assert (0 < E ^ i) by (apply pow_lt;
        lra). simpl. apply (Rmult_le_compat_l (E ^ i)) in C2; lra.
  - assert (i = 0)%nat as -> by nia. simpl. rewrite Rmult_1_l. destruct j as [|j].
    + pose proof (change_le l1 l2 Hl Hl1 v) as C. simpl. replace (apply one v) with v by (unfold apply, one;
        destruct v; simpl; f_equal; ring). pose proof (Rabs_pos (change v)). nra.
    + assert (Hk : forall k, (k < n - S j)%nat -> 0 <= height (iterate k (iterate (S j) x))).
      { intros k Hk. rewrite <- iterate_add. apply Hr. lia. }
      pose proof (norm_free (n - S j) (iterate (S j) x) (apply (along (S j) x) v) Hk) as F.
      rewrite <- apply_mul, <- along_add in F. replace (n - S j + S j)%nat with n in F by lia.
      pose proof (change_le l1 l2 Hl Hl1 (apply (along n x) v)) as C. pose proof (Rabs_pos (change (apply (along n x)
        v))) as Pc. assert (Q : weight (iterate n x) * Rabs (change (apply (along n x) v)) <= top * (2 * norm (apply
        (along (S j) x) v))) by (apply Rmult_le_compat; lra). assert (weight x * Rabs (change v) <= E * (weight x *
        Rabs (change v))) by nra. lra.
Qed.

Lemma trap_cone m : forall x v, (1 <= m)%nat -> trap x -> never_grazes l1 l2 b nu x -> height (iterate m x) <
  0 -> cone v ->
  cone (apply (along m x) v) /\
  E * (weight x * Rabs (change v)) <= weight (iterate m x) * Rabs (change (apply (along m x) v)).
Proof.
  induction m as [m IH] using (well_founded_induction lt_wf). intros x v Hm Hx Hg Hmx Hv. assert (Hh : height x < 0).
    { pose proof (Hg 0%nat) as H0. destruct Hx as (_ & _ & _ & H). simpl in H0. lra.
    }
  destruct (Hret x Hx) as (n & _ & Hr). destruct (return_cone n x v Hx Hh Hr Hv) as [C1 C2].
  assert (Hx' : trap (iterate n x)) by (apply return_trap; [apply Hx|lra|exact Hr]). destruct (Hweight _ Hx') as [W3
    W4]. destruct (lt_eq_lt_dec n m) as [[H|H]|H].
  - replace m with (m - n + n)%nat by lia. rewrite along_add, apply_mul, (iterate_add l1 l2 b nu (m - n) n).
    assert (Hn1 : (1 <= n)%nat) by apply Hr. destruct (IH (m - n)%nat ltac:(lia) (iterate n x) (apply (along n x) v))
      as [D1 D2].
    + lia.
    + exact Hx'.
    + apply never_iterate. exact Hg.
    + rewrite <- iterate_add. replace (m - n + n)%nat with m by lia. exact Hmx.
    + exact C1.
    + split; [exact D1|]. eapply Rle_trans; [exact C2|]. eapply Rle_trans; [|exact D2].
      pose proof (Rabs_pos (change (apply (along n x) v))). assert (0 <= weight (iterate n x) * Rabs (change (apply
        (along n x) v))) by (apply Rmult_le_pos; lra). nra.
  - subst m. split; assumption.
  - exfalso. destruct Hr as (_ & _ & Hk). specialize (Hk m ltac:(lia)). lra.
Qed.
End Orbit.

Theorem growing E top weight : 1 < E -> (forall x, trap x -> 0 < weight x <= top) ->
  (forall n x v, trap x -> height x < 0 -> first_return n x -> cone v -> cone (apply (along n x) v) /\
   E * (weight x * Rabs (change v)) <= weight (iterate n x) * Rabs (change (apply (along n x) v))) ->
  exists N, (1 <= N)%nat /\ chaotic l1 l2 b nu E N.
Proof.
  intros HE Hweight return_cone. destruct bound as (N0 & HB). exists (S N0). split; [lia|].
  assert (Der : forall k x, never_grazes l1 l2 b nu x -> derivative (iterate k) x (along k x)).
  { intros k x Hg. apply derivative_iterate; try assumption. intros j _. apply Hg. }
  assert (Trap : trapping l1 l2 b nu (S N0)).
  { constructor; [exact step_wedge|exact absorbed|]. intros x Hx. destruct (HB x Hx) as (n & Hn & Hr).
    exists n. assert (trap (iterate n x)) by (apply return_trap; [apply Hx|destruct Hx as (_ & _ & _ & H);
      lra|exact Hr]). destruct Hr as (H1 & H2 & H3). repeat split; try assumption; apply H. }
  assert (Expo : exponent l1 l2 b nu E (S N0)).
  { intros x Hw Hg. destruct (absorbed x Hw) as (n & Hn). set (z := iterate n x) in *. set (B := along n x).
    assert (HdB : 0 < det B) by (unfold B; rewrite det_along; apply pow_lt; nra). set (w := (1 / l1, 0)).
    assert (Hw0 : change w = 1) by (unfold w, StatementAttractor.change; simpl; field; lra). assert (Hcw : cone w).
    { unfold StatementAttractor.cone. rewrite Hw0. unfold w; simpl. rewrite Rmult_0_r, Rabs_R0, Rabs_R1. assert (0 < 2
        * l2 / (l1 - l2)) by (apply Rdiv_lt_0_compat; lra). lra. }
    set (v := apply (Mat (m22 B / det B) (- m12 B / det B) (- m21 B / det B) (m11 B / det B)) w).
    assert (HBv : apply B v = w).
    { transitivity (fst w, snd w); [|reflexivity]. unfold v, apply; cbn [fst snd m11 m12 m21 m22].
      unfold det in *. f_equal; field; lra. }
    destruct (Hweight z Hn) as [W1 W2]. assert (Pn : 0 < E ^ n) by (apply pow_lt; lra).
    assert (Hlate : forall k i, (n <= k)%nat -> (S N0 * i <= k)%nat -> weight z / (2 * top * E ^ n) * E ^ i <= norm
      (apply (along k x) v)).
    { intros k i Hk Hi. replace k with (k - n + n)%nat by lia. rewrite along_add, apply_mul. fold z B.
      rewrite HBv. assert (G : E ^ (i - n) * (weight z * Rabs (change w)) <= 2 * top * norm (apply (along (k - n) z)
        w)).
      { apply (orbit_growth E top weight (S N0) HE Hweight return_cone ltac:(lia) HB); try assumption;
          [apply never_iterate; exact Hg|nia]. }
      rewrite Hw0, Rabs_R1, Rmult_1_r in G. apply (Rmult_le_reg_l (2 * top)); [lra|]. eapply Rle_trans;
        [|exact G]. replace (2 * top * (weight z / (2 * top * E ^ n) * E ^ i)) with (weight z * (E ^ i / E ^ n)) by
        (field; lra). rewrite (Rmult_comm _ (weight z)). apply Rmult_le_compat_l; [lra|]. apply div_le;
        [exact Pn|]. rewrite <- pow_add. apply Rle_pow; [lra|lia]. }
    assert (Hearly : forall m, (m <= n)%nat -> exists K, 0 < K /\ forall k i, (k < m)%nat -> (S N0 * i <= k)%nat -> K
      * E ^ i <= norm (apply (along k x) v)).
    { induction m as [|m IH]; intros Hm; [exists 1; split; [lra|intros; lia]|]. destruct IH as (K & HK & HKk);
        [lia|]. assert (Pm : 0 < norm (apply (along m x) v)).
      { pose proof (norm_pos (apply (along m x) v)) as P0. destruct (Rle_lt_or_eq_dec _ _ P0) as [P|P];
          [exact P|exfalso]. assert (Z : norm (apply (along (n - m) (iterate m x)) (apply (along m x) v)) <= 0).
        { eapply Rle_trans; [apply norm_apply|]. rewrite <- P. lra. }
        rewrite <- apply_mul, <- along_add in Z. replace (n - m + m)%nat with n in Z by lia. fold B in Z.
        rewrite HBv in Z. pose proof (norm_fst w) as F. unfold w in F at 1; simpl in F.
        assert (0 < 1 / l1) by (apply Rdiv_lt_0_compat; lra). rewrite Rabs_pos_eq in F; lra. }
      assert (PE : 0 < E ^ m) by (apply pow_lt; lra). exists (Rmin K (norm (apply (along m x) v) / E ^ m)). split.
      { apply Rmin_glb_lt; [exact HK|]. apply Rdiv_lt_0_compat; assumption. }
      intros k i Hk Hi. assert (Pi : 0 < E ^ i) by (apply pow_lt; lra). destruct (Nat.eq_dec k m) as [->|Hne].
      - apply Rle_trans with (norm (apply (along m x) v) / E ^ m * E ^ i).
        + apply Rmult_le_compat_r; [lra|apply Rmin_r].
        + apply Rle_trans with (norm (apply (along m x) v) / E ^ m * E ^ m).
          * apply Rmult_le_compat_l; [left; apply Rdiv_lt_0_compat; assumption|]. apply Rle_pow; [lra|nia].
          * right. field. lra.
      - apply Rle_trans with (K * E ^ i); [apply Rmult_le_compat_r; [lra|apply Rmin_l]|]. apply HKk; [lia|exact Hi]. }
    destruct (Hearly n (le_n n)) as (K & HK & HKk). exists v, (Rmin K (weight z / (2 * top * E ^ n))). split.
    { apply Rmin_glb_lt; [exact HK|]. apply Rdiv_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; lra. }
    intros k. exists (along k x). split; [apply Der; exact Hg|]. intros i Hi. apply Rle_ge.
    assert (Pi : 0 < E ^ i) by (apply pow_lt; lra). destruct (le_lt_dec n k) as [C|C].
    + eapply Rle_trans; [apply Rmult_le_compat_r; [lra|apply Rmin_r]|]. apply Hlate; assumption.
    + eapply Rle_trans; [apply Rmult_le_compat_r; [lra|apply Rmin_l]|]. apply HKk; assumption. }
  enough (Both : forall x m, periodic l1 l2 b nu x m -> (exists J v e, derivative (iterate m) x J /\ v <> (0, 0) /\
    apply J v = scale e v /\ Rabs e >= E) /\ exists r, r > 0 /\ forall eps, eps > 0 -> exists z i, norm (sub z x) <
    eps /\ norm (sub (iterate (i * m) z) x) > r).
  { constructor; [exact Trap|exact Expo|intros x m P; apply Both, P|intros x m P; apply Both, P]. }
  - intros x m [Hw Hg Hm Hp]. destruct (absorbed x Hw) as (n & Hn). assert (Hper : forall t, iterate (t * m) x = x).
    { induction t as [|t IH]; [reflexivity|]. simpl. rewrite iterate_add, IH. exact Hp. }
    set (z := iterate n x) in *. assert (Gz : never_grazes l1 l2 b nu z) by (apply never_iterate; exact Hg).
    assert (Hz : iterate m z = z). { unfold z. rewrite <- iterate_add, Nat.add_comm, iterate_add, Hp. reflexivity.
    } assert (Hzh : height (iterate m z) < 0).
    { rewrite Hz. pose proof (Gz 0%nat) as H0. destruct Hn as (_ & _ & _ & H). simpl in H0. lra. }
    destruct (eigenvector l1 l2 Hl (along m z) E ltac:(lra)) as (u & e & Cu & Du & Eu & He).
    { intros w Hcw. destruct (trap_cone E top weight (S N0) HE Hweight return_cone ltac:(lia) HB m z w Hm Hn Gz Hzh
        Hcw) as [C1 C2]. split; [exact C1|]. rewrite Hz in C2. destruct (Hweight z Hn) as [W1 W2]. apply Rle_ge.
      apply (Rmult_le_reg_l (weight z)); lra. }
    set (a := (n * m - n)%nat). assert (Ha : (a + n = n * m)%nat) by (unfold a; nia).
    assert (Hzx : iterate a z = x) by (unfold z; rewrite <- iterate_add, Ha; apply Hper).
    set (v := apply (along a z) u). assert (Hv : apply (along m x) v = scale e v).
    { unfold v. rewrite <- apply_mul. rewrite <- Hzx at 1. rewrite <- along_add, Nat.add_comm, along_add, Hz,
        apply_mul, Eu. unfold apply, scale; simpl. f_equal; ring. }
    assert (Hv0 : v <> (0, 0)).
    { intros C. pose proof (orbit_growth E top weight (S N0) HE Hweight return_cone ltac:(lia) HB a 0 z u Hn Gz Cu
        ltac:(lia)) as G. fold v in G. destruct (Hweight z Hn) as [W1 W2]. rewrite C, Du, Rabs_R1 in G.
      unfold norm in G; simpl in G. rewrite Rabs_R0, Rmax_left in G; lra. }
    split.
    + exists (along m x), v, e. split; [apply Der; exact Hg|]. split; [exact Hv0|]. split; [exact Hv|exact He].
    + destruct (unstable_fixed (iterate m) x (along m x) v e Hp (Der m x Hg) Hv0 Hv ltac:(lra)) as (r & Hr & Hall).
      { rewrite det_along, Rabs_pos_eq by (apply pow_le; nra). rewrite <- (pow1 m). apply pow_incr. nra. }
      exists r. split; [exact Hr|]. intros eps Hep. destruct (Hall eps Hep) as (z' & i & H1 & H2).
      exists z', i. split; [exact H1|]. replace (iterate (i * m) z') with (Nat.iter i (iterate m) z');
        [exact H2|]. clear. induction i as [|i IH]; [reflexivity|]. simpl. rewrite iterate_add, <- IH. reflexivity.
Qed.
End Map.
