(** * The words of a finite graph grow like the inverse of the least root of det(I - M(z)) *)

From Coq Require Import Reals List Arith Bool Lra Lia Classical.
From Grazing Require Import StatementOrbits OrbitVectors OrbitRemainder SquareSystems StatementGraphs GraphWords.
Import ListNotations. Open Scope R_scope.

Lemma sum_to_le N f g : (forall i, (i < N)%nat -> f i <= g i) -> sum_to N f <= sum_to N g.
Proof.
  induction N as [|N IH]; cbn; intros H; [lra|]; apply Rplus_le_compat; [apply IH; intros; apply H|apply H]; lia.
Qed.
Lemma sum_to_ext N f g : (forall i, (i < N)%nat -> f i = g i) -> sum_to N f = sum_to N g.
Proof. intros H; apply Rle_antisym; apply sum_to_le; intros i Hi; rewrite H by assumption; lra. Qed.
Lemma sum_to_linear N a c f g : sum_to N (fun i => a * f i + c * g i) = a * sum_to N f + c * sum_to N g.
Proof. induction N as [|N IH]; cbn; [ring | rewrite IH; ring]. Qed.
Lemma sum_to_abs N f b : (forall i, (i < N)%nat -> Rabs (f i) <= b) -> Rabs (sum_to N f) <= INR N * b.
Proof.
  induction N as [|N IH]; intros H; [cbn; rewrite Rabs_R0; lra|]; cbn [sum_to]; rewrite S_INR.
  pose proof (Rabs_triang (sum_to N f) (f N)); pose proof (H N ltac:(lia));
    specialize (IH (fun i Hi => H i ltac:(lia))); lra.
Qed.
Lemma sum_filter N (E : nat -> bool) f : sum_of (filter E (seq 0 N)) f = sum_to N (fun j => if E j then f j else 0).
Proof.
  induction N as [|N IH]; [reflexivity|]; rewrite seq_S, filter_app, sum_app, IH; cbn [sum_to plus filter];
    destruct (E N); cbn [sum_of]; ring.
Qed.
Lemma least N f : (0 < N)%nat -> exists i, (i < N)%nat /\ forall j, (j < N)%nat -> f i <= f j.
Proof.
  induction N as [|N IH]; intros H; [lia|]; destruct (Nat.eq_dec N 0) as [->|Hne].
  - exists 0%nat; split; [lia|]; intros j Hj; assert (j = 0%nat) as -> by lia; lra.
  - destruct (IH ltac:(lia)) as (i & Hi & Hm); destruct (Rle_lt_dec (f i) (f N)) as [L|L]; [exists i | exists N];
      (split; [lia|]); intros j Hj.
    + destruct (Nat.eq_dec j N) as [->|]; [exact L | apply Hm; lia].
    + destruct (Nat.eq_dec j N) as [->|]; [lra | specialize (Hm j ltac:(lia)); lra].
Qed.
Lemma pow_apart k s t : 0 <= s <= 1 -> 0 <= t <= 1 -> Rabs (s ^ k - t ^ k) <= INR k * Rabs (s - t).
Proof.
  intros Hs Ht; induction k as [|k IH]; [cbn; rewrite Rminus_eq_0, Rabs_R0; lra|]; rewrite S_INR; cbn [pow].
  replace (s * s ^ k - t * t ^ k) with (s * (s ^ k - t ^ k) + (s - t) * t ^ k) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); rewrite !Rabs_mult, (Rabs_right s), (Rabs_right (t ^ k))
    by (try apply Rle_ge, pow_le; lra).
  assert (t ^ k <= 1) by (rewrite <- (pow1 k); apply pow_incr; lra); pose proof (Rabs_pos (s - t));
    pose proof (Rabs_pos (s ^ k - t ^ k)).
  assert (0 <= t ^ k) by (apply pow_le; lra); nra.
Qed.

Section Finite.
Variables (N : nat) (p : nat -> nat) (E : nat -> nat -> bool).
Hypothesis Hp : forall i, (i < N)%nat -> (1 <= p i)%nat.
Definition Mv (t : R) (v : nat -> R) (i : nat) : R := sum_to N (fun j => row p E t i j * v j).

Lemma row_pos t i j : 0 <= t -> 0 <= row p E t i j.
Proof. intros H; unfold row; destruct (E i j); [apply pow_le, H | lra]. Qed.
Lemma Mv_le t v w i : 0 <= t -> (forall j, (j < N)%nat -> v j <= w j) -> Mv t v i <= Mv t w i.
Proof. intros Ht H; apply sum_to_le; intros j Hj; apply Rmult_le_compat_l; [apply row_pos, Ht | apply H, Hj]. Qed.
Lemma Mv_linear t a c v w i : Mv t (comb a c v w) i = a * Mv t v i + c * Mv t w i.
Proof. unfold Mv; rewrite <- sum_to_linear; apply sum_to_ext; intros j _; unfold comb; ring. Qed.
Lemma Mv_less s t v i : 0 <= s <= t -> (forall j, (j < N)%nat -> 0 <= v j) -> Mv s v i <= Mv t v i.
Proof.
  intros H Hv; apply sum_to_le; intros j Hj; apply Rmult_le_compat_r; [apply Hv, Hj|]; unfold row; destruct (E i j);
    [apply pow_incr, H | lra].
Qed.

(** v is more than M v. *)
Definition above (t : R) (v : nat -> R) : Prop := forall i, (i < N)%nat -> 1 <= v i /\ Mv t v i + 1 <= v i.

Lemma positive t v d : 0 <= t -> above t v -> (forall i, (i < N)%nat -> Mv t d i <= d i) -> forall i, (i < N)%nat ->
  0 <= d i.
Proof.
  intros Ht Hv Hd i Hi; destruct (least N (fun i => d i / v i) ltac:(lia)) as (k & Hk & Hm); set (r := d k / v k) in *.
  destruct (Hv k Hk) as [V1 V2]; assert (Low : forall j, (j < N)%nat -> r * v j <= d j).
  { intros j Hj; specialize (Hm j Hj); destruct (Hv j Hj) as [V _]; apply (Rmult_le_compat_r (v j)) in Hm; [|lra];
      unfold Rdiv in Hm.
    rewrite Rmult_assoc, Rinv_l in Hm by lra; lra. }
  assert (R0 : 0 <= r).
  { apply Rnot_lt_le; intros Neg; pose proof (Mv_le t (comb r 0 v v) d k Ht) as Q; rewrite Mv_linear in Q;
      specialize (Hd k Hk).
    assert (Ek : d k = r * v k) by (unfold r; field; lra).
    assert (Q' : r * Mv t v k + 0 * Mv t v k <= Mv t d k) by (apply Q; intros j Hj; unfold comb; specialize (Low j Hj);
      lra); nra. }
  specialize (Low i Hi); destruct (Hv i Hi); nra.
Qed.

Variable z : R.
Hypotheses (Hz : 0 < z <= 1) (Hfree : forall t, 0 < t < z -> ~ singular N p E t).

Lemma bounded_inverse t : 0 < t < z -> exists K, 0 <= K /\ (forall x b, 0 <= b -> within N b (fun i => x i - Mv t x i)
  -> within N (K * b) x) /\ exists x, forall i, (i < N)%nat -> x i - Mv t x i = 1.
Proof.
  intros Ht; assert (Ker : forall x, (forall k, (k < N)%nat -> x k - Mv t x k = 0) -> forall i, (i < N)%nat -> x i = 0).
  { intros x Hx i Hi; apply NNPP; intros Hne; apply (Hfree t Ht); exists x; split; [eauto|]; intros k Hk;
      specialize (Hx k Hk); unfold Mv in Hx; lra. }
  destruct (linear_map_bounded N (fun x i => x i - Mv t x i)) as (K & HK & H); [| |exact Ker|].
  - intros a c x y k _; rewrite Mv_linear; unfold comb; ring.
  - intros x y Hxy k Hk; rewrite Hxy by exact Hk; f_equal; apply sum_to_ext; intros j Hj; rewrite Hxy by exact Hj;
      reflexivity.
  - exists K; split; [exact HK|]; split.
    + intros x b Hb Hx; destruct (H _ b Hx Hb) as (y & Hy & Ey); intros i Hi; replace (x i) with (y i); [apply Hy, Hi|].
      assert (D : comb 1 (-1) y x i = 0); [|unfold comb in D; lra].
      apply Ker; [|exact Hi]; intros k Hk; rewrite Mv_linear; specialize (Ey k Hk); unfold comb; lra.
    + destruct (H (fun _ => 1) 1) as (x & _ & Ex); [intros i _; rewrite Rabs_R1; lra | lra | exists x; exact Ex].
Qed.
Lemma Mv_apart pb s t x b i : (forall j, (j < N)%nat -> (p j <= pb)%nat) -> 0 <= s <= 1 -> 0 <= t <= 1 -> 0 <= b ->
  (forall j, (j < N)%nat -> Rabs (x j) <= b) -> Rabs (Mv s x i - Mv t x i) <= INR N * (INR pb * Rabs (s - t) * b).
Proof.
  intros Hpb Hs Ht Hb Hx; replace (Mv s x i - Mv t x i)
    with (sum_to N (fun j => (row p E s i j - row p E t i j) * x j)).
  2: { unfold Mv; transitivity (1 * sum_to N (fun j => row p E s i j * x j) + (-1) * sum_to N (fun j =>
         row p E t i j * x j)); [|ring].
       rewrite <- sum_to_linear; apply sum_to_ext; intros; ring. }
  apply sum_to_abs; intros j Hj; rewrite Rabs_mult; pose proof (Rabs_pos (s - t)); apply Rmult_le_compat;
    try apply Rabs_pos; [|apply Hx, Hj].
  unfold row; pose proof (pos_INR pb); destruct (E i j); [|rewrite Rminus_eq_0, Rabs_R0; nra].
  apply Rle_trans with (1 := pow_apart (p j) s t Hs Ht); apply Rmult_le_compat_r; [assumption | apply le_INR, Hpb, Hj].
Qed.
Lemma periods_bounded : exists pb, forall j, (j < N)%nat -> (p j <= pb)%nat.
Proof.
  clear; induction N as [|n [pb H]]; [exists 0%nat; intros; lia|]; exists (pb + p n)%nat; intros j Hj.
  destruct (Nat.eq_dec j n) as [->|]; [lia | specialize (H j ltac:(lia)); lia].
Qed.
Lemma above_less s t v : 0 <= s <= t -> above t v -> above s v.
Proof.
  intros H Hv i Hi; destruct (Hv i Hi) as [V1 V2]; split; [exact V1|]; pose proof (Mv_less s t v i H) as Q.
  assert (Mv s v i <= Mv t v i) by (apply Q; intros j Hj; destruct (Hv j Hj); lra); lra.
Qed.

(** Where no vector is fixed below t < z, one is above its image at t. *)
Lemma above_exists t : 0 < t < z -> exists v, above t v.
Proof.
  intros Ht; apply NNPP; intros No; destruct periods_bounded as [pb Hpb]; pose proof (pos_INR N) as N0;
    pose proof (pos_INR pb) as P0.
  set (good := fun s => 0 < s <= 1 /\ exists v, above s v); assert (Bound : forall s, good s -> s <= t).
  { intros s [Hs (v & Hv)]; apply Rnot_lt_le; intros L; apply No; exists v; apply (above_less t s); [lra | exact Hv]. }
  assert (Some : exists s, good s).
  { exists (/ (2 * (INR N + 1))); assert (I0 : 0 < / (2 * (INR N + 1))) by (apply Rinv_0_lt_compat; lra).
    assert (I1 : / (2 * (INR N + 1)) <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra); split; [lra|].
    exists (fun _ => 2); intros i Hi; split; [lra|]; set (s := / (2 * (INR N + 1))) in *.
    assert (S1 : Mv s (fun _ => 2) i <= INR N * (2 * s)).
    { rewrite <- (Rabs_right (Mv _ _ _)); [apply sum_to_abs|].
      - intros j Hj; rewrite Rabs_right by (apply Rle_ge, Rmult_le_pos; [apply row_pos|]; lra); unfold row;
          destruct (E i j); [|lra].
        specialize (Hp j Hj); destruct (p j) as [|q]; [lia|]; cbn [pow]; assert (s ^ q <= 1) by (rewrite <- (pow1 q);
          apply pow_incr; lra).
        assert (0 <= s ^ q) by (apply pow_le; lra); nra.
      - unfold Mv; apply Rle_ge, Rle_trans with (sum_to N (fun _ => 0)); [clear; induction N; cbn; lra|];
          apply sum_to_le; intros j _.
        apply Rmult_le_pos; [apply row_pos|]; lra. }
    assert (E2 : (INR N + 1) * (2 * s) = 1) by (unfold s; field; lra); nra. }
  destruct (completeness good (ex_intro _ t Bound) Some) as (X & Up & Least); destruct Some as (s0 & Gs0).
  assert (HX : 0 < X <= t) by (pose proof (Up s0 Gs0); pose proof (Least t Bound); destruct Gs0; lra).
  destruct (bounded_inverse X ltac:(lra)) as (K & K0 & Inv & _).
  set (D := / (8 * (INR N + 1) * (INR pb + 1) * (K + 1))).
  assert (DN : 0 < (INR N + 1) * (INR pb + 1) * (K + 1)) by (repeat apply Rmult_lt_0_compat; lra).
  assert (D0 : 0 < D) by (apply Rinv_0_lt_compat; lra).
  assert (DE : 8 * ((INR N + 1) * ((INR pb + 1) * D)) * (K + 1) = 1) by (unfold D; field; repeat split; lra).
  assert (Close : exists s, good s /\ X - D < s).
  { apply NNPP; intros NC; assert (X <= X - D); [|lra]; apply Least; intros s Gs; apply Rnot_lt_le; intros L; apply NC;
      eauto. }
  destruct Close as (s & Gs & Ls); destruct (Gs) as [Hs (v & Hv)]; pose proof (Up s Gs) as Us.
  destruct (bounded_inverse s ltac:(lra)) as (_ & _ & _ & (x & Ex)).
  assert (Px : forall i, (i < N)%nat -> 0 <= x i) by (apply (positive s v x); [lra | exact Hv | intros i Hi;
    specialize (Ex i Hi); lra]).
  destruct (Nat.eq_dec N 0) as [EN|EN]; [apply No; exists v; intros i Hi; lia|].
  destruct (least N (fun i => - x i) ltac:(lia)) as (k & Hk & Hmax); set (b := x k); assert (B0 : 0 <= b)
    by (apply Px, Hk).
  assert (Bx : forall j, (j < N)%nat -> Rabs (x j) <= b) by (intros j Hj; rewrite Rabs_right by (apply Rle_ge, Px, Hj);
    specialize (Hmax j Hj); cbv beta in Hmax; unfold b; lra).
  set (e := INR N * (INR pb * D)); assert (E0 : 0 <= e) by (unfold e; repeat apply Rmult_le_pos; lra).
  assert (Ee : e <= (INR N + 1) * ((INR pb + 1) * D)) by (unfold e; apply Rmult_le_compat; [lra | apply Rmult_le_pos;
    lra | lra | apply Rmult_le_compat_r; lra]).
  assert (B2 : b <= 2 * K).
  { assert (W : within N (1 + e * b) (fun i => x i - Mv X x i)).
    { intros i Hi; replace (x i - Mv X x i) with (1 + (Mv s x i - Mv X x i)) by (specialize (Ex i Hi); lra).
      apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_R1; apply Rplus_le_compat_l.
      apply Rle_trans with (1 := Mv_apart pb s X x b i Hpb ltac:(lra) ltac:(lra) B0 Bx); unfold e.
      replace (INR N * (INR pb * D) * b) with (INR N * (INR pb * D * b)) by ring; apply Rmult_le_compat_l; [lra|];
        apply Rmult_le_compat_r; [lra|].
      apply Rmult_le_compat_l; [lra|]; rewrite Rabs_left1; lra. }
    assert (0 <= e * b) by (apply Rmult_le_pos; lra); pose proof (Inv x (1 + e * b) ltac:(lra) W k Hk) as Q;
      rewrite Rabs_right in Q by (apply Rle_ge, Px, Hk).
    fold b in Q; assert (8 * (e * K) <= 1) by nra; assert (8 * (K * (e * b)) <= b) by nra; lra. }
  set (s'' := Rmin (X + D) ((X + z) / 2)); assert (S2 : X < s'' < z /\ s'' <= X + D).
  { unfold s''; split; [split|]; [apply Rmin_glb_lt; lra | apply Rle_lt_trans with (1 := Rmin_r _ _); lra |
      apply Rmin_l]. }
  assert (G2 : good s''); [|pose proof (Up s'' G2); lra]; split; [lra|]; exists (comb 2 0 x x); intros i Hi;
    rewrite Mv_linear; unfold comb.
  pose proof (Mv_apart pb s'' s x b i Hpb ltac:(lra) ltac:(lra) B0 Bx) as Q; rewrite (Rabs_right (s'' - s)) in Q by lra.
  assert (Q2 : INR N * (INR pb * (s'' - s) * b) <= 1 / 2).
  { apply Rle_trans with (2 * e * b); [|assert (8 * (e * K) <= 1) by nra; nra]; unfold e.
    replace (2 * (INR N * (INR pb * D)) * b) with (INR N * (INR pb * (2 * D) * b)) by ring; apply Rmult_le_compat_l;
      [lra|]; apply Rmult_le_compat_r; [lra|].
    apply Rmult_le_compat_l; lra. }
  assert (Q3 : Mv s'' x i - Mv s x i <= 1 / 2) by (apply Rle_trans with (1 := Rle_abs _); lra); specialize (Ex i Hi).
  assert (0 <= Mv s'' x i) by (unfold Mv; apply Rle_trans with (sum_to N (fun _ => 0)); [clear; induction N; cbn; lra|];
    apply sum_to_le; intros j Hj; apply Rmult_le_pos; [apply row_pos; lra | apply Px, Hj]); lra.
Qed.
Lemma finite_above : at_most (finite N p E) (- ln z).
Proof.
  intros h' Hh; set (t := z * exp (- ((h' - - ln z) / 2))); assert (Et : 0 < exp (- ((h' - - ln z) / 2)) < 1).
  { split; [apply exp_pos | rewrite <- exp_0; apply exp_increasing; lra]. }
  assert (Ht : 0 < t < z) by (unfold t; split; nra); destruct (above_exists t Ht) as (v & Hv).
  assert (Lt : - ln t < h') by (unfold t; rewrite ln_mult, ln_exp by lra; lra).
  assert (Pv : forall j, In j (seq 0 N) -> 0 <= t ^ p j * v j).
  { intros j Hj; apply in_seq in Hj; destruct (Hv j ltac:(lia)); apply Rmult_le_pos; [apply pow_le|]; lra. }
  apply (from_above (finite N p E) t ltac:(lra) Hp v 1 ltac:(lra) (fun i Hi => proj1 (Hv i Hi)))
    with (T := sum_of (seq 0 N) (fun j => t ^ p j * v j)); [| |exact Lt].
  - intros i Hi X HX Hj; destruct (Hv i Hi) as [_ V2]; apply Rle_trans with (sum_of (filter (E i) (seq 0 N)) (fun j =>
      t ^ p j * v j)).
    + apply sum_incl; [exact HX | intros j Ij; destruct (Hj j Ij) as [J1 J2]; apply filter_In; split;
        [apply in_seq; cbn in J1; lia | exact J2] |].
      intros j Ij; apply filter_In in Ij; apply Pv, Ij.
    + rewrite sum_filter; replace (sum_to N _) with (Mv t v i); [lra|]; apply sum_to_ext; intros j _; unfold row;
        destruct (E i j); ring.
  - intros X HX Hj; apply sum_incl; [exact HX | intros j Ij; apply in_seq; specialize (Hj j Ij); cbn in Hj; lia |
      exact Pv].
Qed.
Lemma finite_below : singular N p E z -> at_least (finite N p E) (- ln z).
Proof.
  intros (v & (i & Hi & Vi) & Ev); destruct periods_bounded as [pb Hpb]; set (w := fun i => Rabs (v i)).
  destruct (least N (fun i => - w i) ltac:(lia)) as (k & Hk & Hm); cbv beta in Hm.
  assert (Wi : 0 < w i) by (apply Rabs_pos_lt, Vi); assert (Wk : 0 < w k) by (specialize (Hm i Hi); lra).
  apply (from_below (finite N p E) z Hz Hp (fun i => (i < N)%nat) (fun i => filter (E i) (seq 0 N)) w (w k) pb Wk)
    with (i := i); try assumption.
  - intros j Hj; specialize (Hm j Hj); split; [apply Rabs_pos | lra].
  - intros j Hj; split; [apply NoDup_filter, seq_NoDup|]; intros l Hl; apply filter_In in Hl; destruct Hl as [Hl El];
      apply in_seq in Hl.
    cbn; repeat split; try lia; [exact El | apply Hpb; lia].
  - intros j Hj; rewrite sum_filter; unfold w at 1; rewrite (Ev j Hj).
    assert (Tri : forall n f, Rabs (sum_to n f) <= sum_to n (fun l => Rabs (f l))).
    { clear; induction n as [|n IH]; intros f; cbn; [rewrite Rabs_R0; lra|];
        apply Rle_trans with (1 := Rabs_triang _ _); specialize (IH f); lra. }
    apply Rle_trans with (1 := Tri _ _); apply sum_to_le; intros l _; rewrite Rabs_mult; unfold row, w;
      destruct (E j l); [|rewrite Rabs_R0; lra].
    rewrite (Rabs_right (z ^ p l)); [right; reflexivity | apply Rle_ge, pow_le; lra].
Qed.
End Finite.

Theorem Graph_entropy : Graph_entropy_statement.
Proof. intros N p E z Hp Hz Hs Hf; split; [apply finite_above | apply finite_below]; assumption. Qed.
