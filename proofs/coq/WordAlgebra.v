(** * The identities behind words, and W1, W2, which need nothing else

    p_n and q_n are the second coordinates just after the impact that starts a flight of
    n iterates and just before the one that ends it. Every region, every a2 > 0, but for W2. *)

From Coq Require Import Reals List Arith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementWords Algebra Cases
  MatrixForm InsideTriangle Reverse.
Import ListNotations.
Open Scope R_scope.

Section Identities.
Variables a1 a2 : R.
Notation u := (u a1 a2).
Notation b := (b a1 a2).
Notation p := (p a1 a2).
Notation q := (q a1 a2).

(** The numerator of b. *)
Definition N (n k : nat) : R := u n - u k - a2 ^ k * u (n - k).

Lemma u_nonzero_pos n : u n <> 0 -> (1 <= n)%nat. Proof. destruct n; [rewrite u_0; tauto | lia]. Qed.

(** The same q, with the next u instead of the last. *)
Lemma q_next n : u n <> 0 -> q n = (a2 ^ n + a1 * u n - u (S n)) / u n.
Proof.
  intros Hu; unfold StatementWords.q; destruct n as [|n]; [rewrite u_0 in Hu; tauto|].
  rewrite u_SS; replace (S n - 1)%nat with n by lia; f_equal; ring.
Qed.

Lemma I1 n : u n <> 0 -> c a1 a2 n = p n - q n.
Proof. intros Hu; rewrite q_next by assumption; unfold c, v, StatementWords.p; field; assumption. Qed.
Lemma b_N n k : u n <> 0 -> b n k * u n = N n k. Proof. intros Hu; unfold Defs.b, N; field; assumption. Qed.

Lemma I2 n k : (k <= n)%nat -> u n <> 0 -> u k <> 0 -> b n k = u k * (p n - p k).
Proof.
  intros Hk Hu Hv; rewrite b_is_1_plus_x by assumption. unfold orbit_x, StatementWords.p; field; split; assumption.
Qed.

Lemma I3 n k : (k <= n)%nat -> u n <> 0 -> u k <> 0 -> a2 ^ k * b n (n - k) = u k * (q k - q n).
Proof.
  intros Hk Hu Hv; rewrite !q_next by assumption.
  pose proof (u_addition a1 a2 (n - k) k) as E; replace (n - k + k)%nat with n in E by lia.
  unfold Defs.b; replace (n - (n - k))%nat with k by lia. apply (Rmult_eq_reg_r (u n)); [|assumption].
  transitivity (a2 ^ k * u n - a2 ^ k * u (n - k) - a2 ^ k * a2 ^ (n - k) * u k); [field; assumption|].
  rewrite E, <- pow_add; replace (k + (n - k))%nat with n by lia; field; split; assumption.
Qed.

Lemma u_sum i j : u (i + j) = u (S i) * u j + u i * (u (S j) - a1 * u j).
Proof.
  revert j; induction i as [|i IH]; intros j; [rewrite u_0, u_1; cbn [Nat.add]; ring|].
  replace (S i + j)%nat with (i + S j)%nat by lia; rewrite IH, !u_SS; ring.
Qed.

Lemma I4_product i j : u i <> 0 -> u j <> 0 -> (p i - q j) * (u i * u j) = N (i + j) j.
Proof.
  intros Hi Hj; rewrite q_next by assumption; unfold StatementWords.p, N.
  rewrite u_sum; replace (i + j - j)%nat with i by lia; field; split; assumption.
Qed.

Lemma I4 i j : u i <> 0 -> u j <> 0 -> p i - q j = N (i + j) j / (u i * u j).
Proof. intros Hi Hj; rewrite <- I4_product by assumption; field; split; assumption. Qed.
Lemma I5_product n : u n <> 0 -> (p n + q n - a1) * u n = a2 ^ n - 1.
Proof. intros Hu; rewrite q_next by assumption; unfold StatementWords.p; field; assumption. Qed.
Lemma I5 n : u n <> 0 -> p n + q n - a1 = (a2 ^ n - 1) / u n.
Proof. intros Hu; rewrite <- I5_product by assumption; field; assumption. Qed.

(** One flight, one impact. *)
Lemma pattern_single e g n : pattern a1 a2 e g [n] <-> orbit a1 a2 n e g.
Proof.
  unfold pattern, member, orbit; cbn [cyclic walk]; unfold edge; rewrite Forall_cons_iff. split.
  - intros [[(Hu & Hb) _] Hc]; rewrite <- I1 in Hc by assumption; tauto.
  - intros (Hu & Hb & Hc); rewrite I1 in Hc by assumption. repeat split; (assumption || constructor).
Qed.

Lemma orbit_member_edge e g n : orbit a1 a2 n e g <-> member a1 a2 e n /\ edge a1 a2 e g n n.
Proof.
  rewrite <- pattern_single; unfold pattern; cbn [cyclic walk]; rewrite Forall_cons_iff.
  split; [tauto | intros [H H']; auto].
Qed.

End Identities.

Theorem Identities : Identities_statement.
Proof.
  intros a1 a2 n k u p q b Hn Hk; split; [apply I1; assumption|].
  split; [intros Hkn; split; [apply I2 | apply I3]; assumption|]. split; [|apply I5; assumption].
  unfold p, q, u; rewrite I4 by assumption; unfold N. replace (n + k - k)%nat with n by lia; reflexivity.
Qed.

Theorem Flight : Flight_statement.
Proof.
  intros a1 a2 n Hu; split; [|intros; apply pattern_single].
  destruct n as [|n]; [rewrite u_0 in Hu; tauto|]; intros X HX.
  destruct (Matrix_form a1 a2 (S n) Hu) as (_ & _ & HX'); destruct (HX' X HX) as (E & _ & Hc).
  rewrite I1 in Hc by assumption. assert (snd X = p a1 a2 (S n)) by (rewrite E; reflexivity); split; [assumption | lra].
Qed.

(** ** Time reversed *)

Theorem Words_reversal : Words_reversal_statement.
Proof.
  intros a1 a2 i j H Hi Hj. assert (Hi' := proj2 (u_reversed_zero a1 a2 H i) Hi).
  assert (Hj' := proj2 (u_reversed_zero a1 a2 H j) Hj). split; [assumption|split].
  - rewrite q_next, q_next by assumption; unfold p. rewrite !(u_reversed a1 a2 H), pow_inv; cbn [pow].
    field; repeat split; try apply pow_nonzero; lra.
  - intros e; unfold member; split; intros [_ Hb]; (split; [assumption|]); intros k Hk;
      specialize (Hb (i - k)%nat ltac:(lia)).
    + rewrite (b_reversed a1 a2 H) in Hb by (assumption || lia).
      replace (i - (i - k))%nat with k in Hb by lia; assumption.
    + rewrite (b_reversed a1 a2 H) by (assumption || lia); assumption.
Qed.

(** ** W1 *)

Section W1.
Variables (a1 a2 : R) (e : sign).
Hypothesis a2_pos : 0 < a2.
Notation u := (u a1 a2).
Notation p := (p a1 a2).
Notation q := (q a1 a2).

Lemma nested i j : (i < j)%nat -> member a1 a2 e j -> (sgn e * u i > 0 -> p i < p j /\ q j < q i) /\
  (sgn e * u i < 0 -> p j < p i /\ q i < q j).
Proof.
  intros Hij (Hj & Hb).
  assert (Hi : u i <> 0 -> 0 < sgn e * u i * (p j - p i) /\ 0 < sgn e * u i * (q i - q j)).
  { intros Hi; pose proof (u_nonzero_pos a1 a2 i Hi); pose proof (pow_lt a2 i a2_pos).
    pose proof (Hb i ltac:(lia)) as B; rewrite (I2 a1 a2 j i ltac:(lia) Hj Hi) in B.
    pose proof (Hb (j - i)%nat ltac:(lia)) as C. pose proof (I3 a1 a2 j i ltac:(lia) Hj Hi) as E; split; [lra|].
    replace (sgn e * u i * (q i - q j)) with (a2 ^ i * (sgn e * b a1 a2 j (j - i))) by (rewrite Rmult_assoc, <- E;
      ring).
    apply Rmult_lt_0_compat; assumption. }
  split; intros Hs; (destruct Hi as [H1 H2]; [intros E; rewrite E in Hs; lra|]); split; nra.
Qed.

Lemma full_shift g i j : orbit a1 a2 i e g -> orbit a1 a2 j e g -> edge a1 a2 e g i j.
Proof.
  rewrite !orbit_member_edge; intros [Vi Ei] [Vj Ej].
  destruct (lt_eq_lt_dec i j) as [[Hij|<-]|Hij]; [|assumption|]; pose proof (proj1 Vi) as Hi; pose proof (proj1 Vj)
    as Hj; unfold edge in *.
  - destruct (nested i j Hij Vj) as [H1 H2].
    destruct (Rdichotomy _ _ Hi); destruct e, g; cbn [sgn] in *; (destruct H1 as [? ?]; [lra|]) ||
      (destruct H2 as [? ?]; [lra|]); lra.
  - destruct (nested j i Hij Vi) as [H1 H2].
    destruct (Rdichotomy _ _ Hj); destruct e, g; cbn [sgn] in *; (destruct H1 as [? ?]; [lra|]) ||
      (destruct H2 as [? ?]; [lra|]); lra.
Qed.
End W1.

Lemma walk_all {T} (E : T -> T -> Prop) (P : T -> Prop) : (forall x y, P x -> P y -> E x y) ->
  forall l x y, P x -> Forall P l -> P y -> walk E x l y.
Proof.
  intros H; induction l as [|z l IH]; intros x y Hx Hl Hy; [apply H; assumption|].
  apply Forall_cons_iff in Hl as [Hz Hl]; split; [apply H | apply IH]; assumption.
Qed.

Theorem W1 : W1_statement.
Proof.
  intros a1 a2 e H; split; [intros; apply nested; assumption|]. intros g [|n l] Hne Hl; [tauto|]; split.
  - revert Hl; apply Forall_impl; intros i Hi; apply orbit_member_edge in Hi; tauto.
  - apply Forall_cons_iff in Hl as [Hn Hl]. apply (walk_all _ (fun n => orbit a1 a2 n e g)); try assumption.
    intros; apply full_shift; assumption.
Qed.

(** ** W2 *)

Section W2.
Variables a1 a2 : R.
Hypothesis a2_in : 0 < a2 <= 1.
Hypothesis a1_in : Rabs a1 < a2 + 1.
Notation u := (u a1 a2).
Notation p := (p a1 a2).
Notation q := (q a1 a2).

Lemma sign_c n : u n <> 0 -> (0 < u n -> c a1 a2 n < 0) /\ (u n < 0 -> c a1 a2 n > 0).
Proof.
  intros Hu; pose proof (u_nonzero_pos a1 a2 n Hu).
  pose proof (detIA_inside a1 a2 n a2_in a1_in ltac:(assumption) (or_intror Hu)).
  split; intros; [apply c_neg | apply c_pos]; nra.
Qed.

Lemma lower_pq i : 0 < u i -> p i < q i /\ p i + q i <= a1.
Proof.
  intros Hu; pose proof (proj1 (sign_c i ltac:(lra)) Hu) as Hc.
  rewrite I1 in Hc by lra; pose proof (I5_product a1 a2 i ltac:(lra)).
  pose proof (pow_at_most_1 a2 i a2_in); split; [lra | nra].
Qed.

Lemma upper_pq j : u j < 0 -> q j < p j /\ a1 <= p j + q j.
Proof.
  intros Hu; pose proof (proj2 (sign_c j ltac:(lra)) Hu) as Hc.
  rewrite I1 in Hc by lra; pose proof (I5_product a1 a2 j ltac:(lra)).
  pose proof (pow_at_most_1 a2 j a2_in); split; [lra | nra].
Qed.
End W2.

Theorem W2 : W2_statement.
Proof.
  intros a1 a2 H2 H1; split.
  - intros n []; cbn [on case_of sgn]; intros Hs; destruct (sign_c a1 a2 H2 H1 n ltac:(lra)) as [Hp Hm];
      specialize (Hp Hs) || specialize (Hm Hs); lra.
  - intros i j Hi Hj; cbn [on] in *.
    pose proof (lower_pq a1 a2 H2 H1 i Hi); pose proof (upper_pq a1 a2 H2 H1 j Hj); lra.
Qed.
