(** * In regions 1, 2 and 5 all b_{n,k} have one sign, and on the lines a1 = a2 + 1,
    a1 = -(a2+1) some vanish; periods 1 and 2 everywhere *)

From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import Defs Statement StatementPlane Algebra RealEigenvalues Cases.
Open Scope R_scope.

Lemma sqrt_bounds a2 : 0 < a2 < 1 -> a2 < sqrt a2 < 1 /\ sqrt a2 ^ 2 = a2.
Proof.
  intros H; assert (E : sqrt a2 * sqrt a2 = a2) by (apply sqrt_sqrt; lra).
  assert (0 < sqrt a2) by (apply sqrt_lt_R0; lra); split; [split; nra | lra].
Qed.

Lemma both_pos p q : q <= p -> 0 < p * q -> 0 < p + q -> 0 < q /\ 0 < p.
Proof.
  intros; destruct (Rle_lt_dec q 0); [|split; lra]. destruct (Rle_lt_dec p 0); [lra | assert (p * q <= 0) by nra; lra].
Qed.

(** Region 1 has 0 < q < 1 < p, region 2 (and the mirror image of 4) 0 < q <= p < 1. *)
Lemma eigenvalues_region1 a1 a2 : 0 < a2 -> a2 + 1 < a1 -> exists p q, a1 = p + q /\ a2 = p * q /\ 0 < q < 1 /\ 1 < p.
Proof.
  intros H2 H1; destruct (eigenvalues_exist a1 a2) as (p & q & -> & -> & Hpq).
  { assert (0 < (a1 - (a2 + 1)) * (a1 + (a2 + 1))) by (apply Rmult_lt_0_compat; lra).
    pose proof (pow2_ge_0 (a2 - 1)); lra. }
  destruct (both_pos p q) as [Hq Hp]; [assumption | assumption | lra |]. assert ((1 - q) * (1 - p) < 0) by lra.
  assert (q < 1) by (apply Rnot_le_lt; intros ?; nra). assert (1 < p) by (apply Rnot_le_lt; intros ?; nra).
  exists p, q; repeat split; assumption.
Qed.

Lemma eigenvalues_region2 a1 a2 : 0 < a2 < 1 -> 2 * sqrt a2 <= a1 < a2 + 1 ->
  exists p q, a1 = p + q /\ a2 = p * q /\ 0 < q < 1 /\ 0 < p < 1.
Proof.
  intros H2 H1; destruct (sqrt_bounds a2 H2) as [Hs Es].
  destruct (eigenvalues_exist a1 a2) as (p & q & -> & -> & Hpq); [nra|].
  destruct (both_pos p q) as [Hq Hp]; [assumption | apply H2 | lra |]. assert (0 < (1 - q) * (1 - p)) by lra.
  assert (p < 1) by (apply Rnot_le_lt; intros ?; nra). exists p, q; repeat split; lra.
Qed.

Lemma u_pos p q k : 0 < p -> 0 < q -> (1 <= k)%nat -> 0 < u (p + q) (p * q) k.
Proof.
  intros Hp Hq; destruct k as [|k]; [lia | intros _]. induction k as [|k IH]; [rewrite u_1; lra | rewrite u_step].
  pose proof (pow_lt q (S k) Hq); nra.
Qed.

Lemma pow_above_1 p n : 1 < p -> (1 <= n)%nat -> 1 < p ^ n.
Proof. intros; apply Rlt_pow_R1; [assumption | lia]. Qed.

Definition all_b_plane (P : R -> Prop) (a1 a2 : R) (n : nat) : Prop :=
  forall k, (1 <= k <= n - 1)%nat -> P (b a1 a2 n k).

Section BetweenEnds.
Variables p q : R.
Notation y := (fun n k => - orbit_x (p + q) (p * q) n k).

Lemma y_recurrence n k : y n (S (S k)) = (q + p) * y n (S k) - q * p * y n k.
Proof. cbn beta; rewrite x_SS; ring. Qed.

Lemma b_pos_region1 n k : 0 < q < 1 -> 1 < p -> (1 <= k <= n - 1)%nat -> b (p + q) (p * q) n k > 0.
Proof.
  intros Hq Hp Hk. assert (Hu : u (p + q) (p * q) n <> 0) by (apply Rgt_not_eq, u_pos; lra || lia).
  rewrite b_is_1_plus_x by (assumption || lia).
  pose proof (sag q p (y n) n k Hq Hp (y_recurrence n)) as H; cbn beta in H.
  rewrite x_0, x_n in H by assumption; specialize (H ltac:(lra) eq_refl ltac:(lia)); lra.
Qed.

Lemma b_neg_region2 n k : 0 < q < 1 -> 0 < p < 1 -> (1 <= k <= n - 1)%nat -> b (p + q) (p * q) n k < 0.
Proof.
  intros Hq Hp Hk. assert (Hu : u (p + q) (p * q) n <> 0) by (apply Rgt_not_eq, u_pos; lra || lia).
  rewrite b_is_1_plus_x by (assumption || lia).
  pose proof (arch q p (y n) n k Hq Hp (y_recurrence n)) as H; cbn beta in H.
  rewrite x_0, x_n in H by assumption; specialize (H ltac:(lra) eq_refl ltac:(lia)); lra.
Qed.
End BetweenEnds.

Lemma region1_signs a1 a2 n : 0 < a2 -> a2 + 1 < a1 -> (1 <= n)%nat -> u a1 a2 n > 0 /\ all_b_plane (fun x => x > 0) a1
  a2 n /\ c a1 a2 n > 0 /\ ((2 <= n)%nat -> exists_iff a1 a2 n Plus Plus True).
Proof.
  intros H2 H1 Hn. destruct (eigenvalues_region1 a1 a2 H2 H1) as (p & q & -> & -> & Hq & Hp).
  assert (Hu : 0 < u (p + q) (p * q) n) by (apply u_pos; lra || lia).
  assert (Hb : all_b_plane (fun x => x > 0) (p + q) (p * q) n) by (intros k Hk; apply b_pos_region1; assumption).
  assert (Hc : c (p + q) (p * q) n > 0).
  { apply c_pos; rewrite detIA_eigenvalues. pose proof (pow_below_1 q n Hq Hn); pose proof (pow_above_1 p n Hp Hn).
    assert ((1 - p ^ n) * (1 - q ^ n) < 0) by nra; nra. }
  refine (conj Hu (conj Hb (conj Hc _))); intros. apply exists_Plus; [lra | assumption | assumption | cbn; lra].
Qed.

Lemma region2_signs a1 a2 n : 0 < a2 < 1 -> 2 * sqrt a2 <= a1 < a2 + 1 -> (1 <= n)%nat -> u a1 a2 n > 0 /\
  all_b_plane (fun x => x < 0) a1 a2 n /\ c a1 a2 n < 0 /\ ((2 <= n)%nat -> exists_iff a1 a2 n Minus Plus True).
Proof.
  intros H2 H1 Hn. destruct (eigenvalues_region2 a1 a2 H2 H1) as (p & q & -> & -> & Hq & Hp).
  assert (Hu : 0 < u (p + q) (p * q) n) by (apply u_pos; lra || lia).
  assert (Hb : all_b_plane (fun x => x < 0) (p + q) (p * q) n) by (intros k Hk; apply b_neg_region2; assumption).
  assert (Hc : c (p + q) (p * q) n < 0).
  { apply c_neg; rewrite detIA_eigenvalues. pose proof (pow_below_1 q n Hq Hn); pose proof (pow_below_1 p n Hp Hn).
    assert (0 < (1 - p ^ n) * (1 - q ^ n)) by (apply Rmult_lt_0_compat; lra); nra. }
  refine (conj Hu (conj Hb (conj Hc _))); intros. apply exists_Minus_Plus; [lra | assumption..].
Qed.

(** ** Region 5 mirrors region 1, with alternating signs *)

Lemma sign_pow k : (-1) ^ k = 1 \/ (-1) ^ k = -1.
Proof. induction k as [|k [H|H]]; cbn; [tauto | rewrite H.. ]; [right | left]; ring. Qed.
Lemma sign_pow_square k : (-1) ^ k * (-1) ^ k = 1. Proof. destruct (sign_pow k) as [-> | ->]; ring. Qed.
Lemma sign_pow_odd n : Nat.Odd n -> (-1) ^ n = -1.
Proof. intros [h ->]; rewrite Nat.add_1_r; apply pow_1_odd. Qed.
Lemma sign_pow_even n : Nat.Even n -> (-1) ^ n = 1. Proof. intros [h ->]; apply pow_1_even. Qed.

Lemma b_mirror a1 a2 n k : (k <= n)%nat -> u a1 a2 n <> 0 -> b (- a1) a2 n k = (u a1 a2 n - (-1) ^ (n - k) * u a1 a2 k
  - (-1) ^ k * (a2 ^ k * u a1 a2 (n - k))) / u a1 a2 n.
Proof.
  intros Hk Hu; unfold b; rewrite !u_mirror.
  replace ((-1) ^ n) with ((-1) ^ (n - k) * (-1) ^ k) by (rewrite <- pow_add; f_equal; lia).
  pose proof (sign_pow_square k); pose proof (sign_pow_square (n - k)).
  destruct (sign_pow k) as [Ek|Ek], (sign_pow (n - k)) as [El|El]; rewrite Ek, El; field; assumption.
Qed.

Lemma mirrored_b_pos a1 a2 n k : 0 < a2 -> (1 <= k <= n - 1)%nat -> (forall j, (1 <= j)%nat -> 0 < u a1 a2 j) ->
  0 < b a1 a2 n k \/ b a1 a2 n k = 0 /\ Nat.Odd n -> 0 < b (- a1) a2 n k.
Proof.
  intros H2 Hk Hu Hb; assert (Hn : 0 < u a1 a2 n) by (apply Hu; lia). rewrite b_mirror by (lia || lra); unfold b in Hb.
  pose proof (Hu k ltac:(lia)).
  assert (0 < a2 ^ k * u a1 a2 (n - k)) by (apply Rmult_lt_0_compat; [apply pow_lt | apply Hu; lia]; assumption).
  set (w := a2 ^ k * u a1 a2 (n - k)) in *; set (d := u a1 a2 n - u a1 a2 k - w) in *.
  assert (Hd : 0 < d \/ d = 0 /\ Nat.Odd n).
  { replace d with (d / u a1 a2 n * u a1 a2 n) by (field; lra).
    destruct Hb as [Hb|[-> Ho]]; [left; nra | right; split; [ring | assumption]]. }
  apply Rdiv_lt_0_compat; [|assumption]. destruct Hd as [Hd|[Hd Ho]]; unfold d in Hd.
  - destruct (sign_pow k) as [-> | ->], (sign_pow (n - k)) as [-> | ->]; lra.
  - apply sign_pow_odd in Ho. replace n with (n - k + k)%nat in Ho by lia; rewrite pow_add in Ho.
    destruct (sign_pow k) as [E|E], (sign_pow (n - k)) as [E'|E']; rewrite E, E' in Ho |- *; lra.
Qed.

Lemma detIA_mirror a1 a2 n : detIA (- a1) a2 n = 1 - (-1) ^ n * v a1 a2 n + a2 ^ n.
Proof. unfold detIA; rewrite v_mirror; reflexivity. Qed.

Lemma c_neg_odd p q n : 0 < p -> 0 < q -> Nat.Odd n -> c (- (p + q)) (p * q) n < 0.
Proof.
  intros Hp Hq Ho; assert (1 <= n)%nat by (destruct Ho; lia).
  apply c_neg; rewrite detIA_mirror, u_mirror, sign_pow_odd, v_eigenvalues by assumption.
  pose proof (u_pos p q n Hp Hq ltac:(assumption)). pose proof (pow_lt p n Hp); pose proof (pow_lt q n Hq).
  pose proof (pow_lt (p * q) n ltac:(nra)); apply Rmult_lt_0_compat; lra.
Qed.

Lemma c_neg_region5 p q n : 0 < q < 1 -> 1 < p -> (1 <= n)%nat -> c (- (p + q)) (p * q) n < 0.
Proof.
  intros Hq Hp Hn; destruct (Nat.Even_or_Odd n) as [He|Ho]; [|apply c_neg_odd; lra || assumption].
  apply c_neg; rewrite detIA_mirror, u_mirror, sign_pow_even by assumption.
  replace (1 - 1 * v (p + q) (p * q) n + (p * q) ^ n) with (detIA (p + q) (p * q) n) by (unfold detIA; ring).
  rewrite detIA_eigenvalues. pose proof (u_pos p q n ltac:(lra) ltac:(lra) ltac:(assumption)).
  pose proof (pow_below_1 q n Hq Hn); pose proof (pow_above_1 p n Hp Hn).
  assert ((1 - p ^ n) * (1 - q ^ n) < 0) by nra; nra.
Qed.

(** ** The lines: a1 = a2 + 1 has eigenvalues 1 and a2 *)

Lemma b_line a2 n k : (k <= n)%nat -> u (a2 + 1) a2 n - u (a2 + 1) a2 k - a2 ^ k * u (a2 + 1) a2 (n - k) = 0.
Proof.
  intros Hk; replace n with (n - k + k)%nat by lia.
  replace (n - k + k - k)%nat with (n - k)%nat by lia; generalize (n - k)%nat as j; intros j.
  assert (S : forall i, u (a2 + 1) a2 (S i) = u (a2 + 1) a2 i + a2 ^ i).
  { intros i; pose proof (u_step 1 a2 i) as H. rewrite !Rmult_1_l, (Rplus_comm 1) in H; exact H. }
  induction j as [|j IH]; [cbn [Nat.add]; rewrite u_0; ring|]. cbn [Nat.add]; rewrite !S, pow_add; lra.
Qed.

Lemma detIA_line a2 n : detIA (a2 + 1) a2 n = 0.
Proof. pose proof (detIA_eigenvalues 1 a2 n) as H. rewrite Rmult_1_l, (Rplus_comm 1), pow1 in H; lra. Qed.

Theorem Lines : Lines_statement.
Proof.
  intros a2 n H2 Hn.
  assert (Hu : u (a2 + 1) a2 n > 0).
  { pose proof (u_pos 1 a2 n ltac:(lra) H2 Hn) as H. rewrite Rmult_1_l, (Rplus_comm 1) in H; exact H. }
  split; [lra|split; [rewrite u_mirror; destruct (sign_pow n) as [-> | ->]; lra|]].
  split; [|split; [|intros He; split]].
  - rewrite c_detIA, detIA_line; unfold Rdiv; ring.
  - intros k Hk'; assert (Hk : (k <= n)%nat) by lia; unfold b; rewrite b_line by assumption; unfold Rdiv; ring.
  - pose proof (detIA_line a2 n) as H; unfold detIA in H.
    rewrite c_detIA, detIA_mirror, sign_pow_even, Rmult_1_l, H by assumption. unfold Rdiv; ring.
  - intros k Hk' Hke; assert (Hk : (k <= n)%nat) by lia; unfold b; rewrite !u_mirror.
    assert (Hme : Nat.Even (n - k)).
    { destruct He as [h Hh], Hke as [l Hl]; exists (h - l)%nat; lia. }
    rewrite !sign_pow_even by assumption. replace (_ - _ - _) with 0; [unfold Rdiv; ring|].
    pose proof (b_line a2 n k Hk); lra.
Qed.

Lemma region5_signs a1 a2 n : 0 < a2 -> (1 <= n)%nat -> a1 < - (a2 + 1) \/ a1 = - (a2 + 1) /\ Nat.Odd n ->
  u a1 a2 n <> 0 /\ all_b_plane (fun x => x > 0) a1 a2 n /\ c a1 a2 n < 0 /\
  ((2 <= n)%nat -> exists_iff a1 a2 n Plus Minus True).
Proof.
  intros H2 Hn H1.
  assert (exists p q, a1 = - (p + q) /\ a2 = p * q /\ 0 < p /\ 0 < q /\ (0 < q < 1 /\ 1 < p \/ p = 1 /\ Nat.Odd n))
    as (p & q & -> & -> & Hp & Hq & H).
  { destruct H1 as [H1 | [H1 Ho]].
    - destruct (eigenvalues_region1 (- a1) a2) as (p & q & E1 & E2 & H); try lra. exists p, q; repeat split; lra.
    - exists 1, a2; repeat split; try lra; right; split; [reflexivity | assumption]. }
  assert (Hpos : forall j, (1 <= j)%nat -> 0 < u (p + q) (p * q) j) by (intros; apply u_pos; assumption).
  assert (Hu : u (- (p + q)) (p * q) n <> 0).
  { rewrite u_mirror; specialize (Hpos n Hn); destruct (sign_pow n) as [-> | ->]; lra. }
  assert (Hb : all_b_plane (fun x => x > 0) (- (p + q)) (p * q) n).
  { intros k Hk; apply mirrored_b_pos; try assumption.
    destruct H as [[Hq1 Hp1] | [-> Ho]]; [left; apply b_pos_region1; assumption|]. right; split; [|assumption].
    rewrite Rmult_1_l, (Rplus_comm 1); unfold b. rewrite b_line by lia; unfold Rdiv; ring. }
  assert (Hc : c (- (p + q)) (p * q) n < 0).
  { destruct H as [[Hq1 Hp1] | [_ Ho]]; [apply c_neg_region5 | apply c_neg_odd]; assumption. }
  refine (conj Hu (conj Hb (conj Hc _))); intros. apply exists_Plus; [assumption | assumption | assumption | cbn; lra].
Qed.

(** ** As stated *)

Theorem Region1 : Region1_statement.
Proof.
  intros a1 a2 n H2 H1 Hn; destruct (region1_signs a1 a2 n H2 H1 Hn) as (Hu & Hb & Hc & _).
  split; [assumption|split; [lra|]]; cbn [sgn]; split; [|lra]. intros k Hk; specialize (Hb k Hk); cbn beta in Hb; lra.
Qed.

Theorem Region2 : Region2_statement.
Proof.
  intros a1 a2 n H2 H1 Hn; destruct (region2_signs a1 a2 n H2 H1 Hn) as (Hu & Hb & Hc & _).
  split; [assumption|split; [lra|]]; cbn [sgn]; split; [|lra]. intros k Hk; specialize (Hb k Hk); cbn beta in Hb; lra.
Qed.

Theorem Region5 : Region5_statement.
Proof.
  intros a1 a2 n H2 Hn H1; destruct (region5_signs a1 a2 n H2 Hn H1) as (Hu & Hb & Hc & _).
  split; [assumption|]; cbn [sgn]; split; [|lra]. intros k Hk; specialize (Hb k Hk); cbn beta in Hb; lra.
Qed.

(** ** Periods 1 and 2 *)

Theorem Period1 : Period1_statement.
Proof.
  intros a1 a2 e g. assert (E : c a1 a2 1 = a1 - (a2 + 1)) by (unfold c; rewrite v_1, u_1, pow_1; field).
  unfold orbit; rewrite E, u_1; split; [tauto|]. intros H; repeat split; [lra | intros; lia | assumption].
Qed.

Theorem Period2 : Period2_statement.
Proof.
  intros a1 a2 e g H2.
  assert (Eb : b a1 a2 2 1 = (a1 - (a2 + 1)) / a1) by (unfold b; cbn [Nat.sub]; rewrite u_2, u_1, pow_1; unfold Rdiv;
    ring).
  assert (Ec : c a1 a2 2 = (a1 - (a2 + 1)) / a1 * (a1 + (a2 + 1))).
  { unfold c; rewrite v_SS, v_1, v_0, u_2; unfold Rdiv; ring. }
  assert (Hk : forall P : nat -> Prop, (forall k, (1 <= k <= 2 - 1)%nat -> P k) <-> P 1%nat).
  { intros P; split; [intros H; apply H; lia|]. intros H k Hk; replace k with 1%nat by lia; assumption. }
  unfold orbit; rewrite u_2, (Hk (fun k => sgn e * b a1 a2 2 k > 0)), Eb, Ec.
  assert (Hlt : a1 - (a2 + 1) < 0 -> 0 < a1 -> (a1 - (a2 + 1)) / a1 < 0).
  { intros; assert (0 < / a1) by (apply Rinv_0_lt_compat; assumption). unfold Rdiv; nra. }
  assert (Hpp : 0 < (a1 - (a2 + 1)) * a1 -> 0 < (a1 - (a2 + 1)) / a1) by apply quotient_pos.
  destruct (Req_dec a1 (a2 + 1)) as [->|Hne].
  { replace (a2 + 1 - (a2 + 1)) with 0 by ring; unfold Rdiv; rewrite Rmult_0_l, !Rmult_0_r.
    split; [|lra]; intros (_ & H & _); lra. }
  set (B := (a1 - (a2 + 1)) / a1) in *; clearbody B.
  assert (Hg : sgn e * B > 0 -> (sgn e * sgn g * (B * (a1 + (a2 + 1))) > 0 <-> sgn g * (a1 + (a2 + 1)) > 0)).
  { intros HB; replace (sgn e * sgn g * (B * (a1 + (a2 + 1)))) with (sgn e * B * (sgn g * (a1 + (a2 + 1)))) by ring;
      split; intros; nra. }
  assert (HB : (a1 < 0 \/ a2 + 1 < a1) /\ B > 0 \/ 0 < a1 < a2 + 1 /\ B < 0 \/ a1 = 0).
  { destruct (Rtotal_order a1 0) as [H | [H | H]]; [left | tauto |].
    - split; [tauto | apply Hpp; nra].
    - destruct (Rlt_le_dec a1 (a2 + 1)) as [Hl|Hl]; [right; left; split; lra | left].
      split; [right | apply Hpp; nra]; lra. }
  clear Hlt Hpp; destruct e, g; cbn [sgn] in *; intuition (lra || discriminate).
Qed.
