(** * Identities of u_k and v_k that follow from the recurrence alone

    No sign, no region, no division: identities in a1 and a2, and the same with
    eigenvalues p, q when a1 = p + q and a2 = p q. *)

From Coq Require Import Reals Lra Lia.
From Grazing Require Import Defs.
Open Scope R_scope.

Lemma snd_pair a1 a2 k : snd (pair a1 a2 k) = u a1 a2 (S k).
Proof. unfold u; cbn; destruct (pair a1 a2 k); reflexivity. Qed.
Lemma u_0 a1 a2 : u a1 a2 0 = 0. Proof. reflexivity. Qed.
Lemma u_1 a1 a2 : u a1 a2 1 = 1. Proof. reflexivity. Qed.
Lemma u_SS a1 a2 k : u a1 a2 (S (S k)) = a1 * u a1 a2 (S k) - a2 * u a1 a2 k.
Proof.
  rewrite <- (snd_pair a1 a2 (S k)), <- (snd_pair a1 a2 k); unfold u; cbn. destruct (pair a1 a2 k); reflexivity.
Qed.
Lemma u_2 a1 a2 : u a1 a2 2 = a1. Proof. rewrite u_SS, u_1, u_0; ring. Qed.

(** A property of k that follows from the two before it. *)
Lemma two_step (P : nat -> Prop) : P 0%nat -> P 1%nat -> (forall k, P k -> P (S k) -> P (S (S k))) -> forall k, P k.
Proof.
  intros H0 H1 HS k; enough (P k /\ P (S k)) by tauto. induction k; [tauto | split; [tauto | apply HS; tauto]].
Qed.

Section Identities.
Variables a1 a2 : R.
Notation u := (u a1 a2).
Notation v := (v a1 a2).

Lemma u_addition j k : a2 ^ k * u j = u (j + k) * u (S k) - u (S (j + k)) * u k.
Proof.
  induction k as [|k IH].
  - rewrite Nat.add_0_r, u_0, u_1; cbn; ring.
  - rewrite Nat.add_succ_r, !u_SS; cbn [pow]. rewrite Rmult_assoc, IH; ring.
Qed.
Lemma u_Cassini k : u (S k) ^ 2 - a1 * u (S k) * u k + a2 * u k ^ 2 = a2 ^ k.
Proof. pose proof (u_addition 1 k) as H; cbn [Nat.add] in H. rewrite u_SS, u_1 in H; lra. Qed.
Lemma v_0 : v 0 = 2. Proof. unfold Defs.v; rewrite u_0, u_1; ring. Qed.
Lemma v_1 : v 1 = a1. Proof. unfold Defs.v; rewrite u_2, u_1; ring. Qed.
Lemma v_SS k : v (S (S k)) = a1 * v (S k) - a2 * v k. Proof. unfold Defs.v; rewrite !u_SS; ring. Qed.

(** The paper's v_n = u_{n+1} - a2 u_{n-1}. *)
Lemma v_neighbours k : v (S k) = u (S (S k)) - a2 * u k. Proof. unfold Defs.v; rewrite u_SS; ring. Qed.
Lemma v_discriminant k : v k ^ 2 = 4 * a2 ^ k + (a1 ^ 2 - 4 * a2) * u k ^ 2.
Proof. unfold Defs.v; rewrite <- u_Cassini; ring. Qed.
Lemma u_v_cross j k : u (j + k) * v k - u k * v (j + k) = 2 * (a2 ^ k * u j).
Proof. unfold Defs.v; rewrite u_addition; ring. Qed.

End Identities.

(** Changing the sign of a1 changes the sign of both eigenvalues. *)
Lemma u_mirror a1 a2 k : u (- a1) a2 k = - (-1) ^ k * u a1 a2 k.
Proof.
  induction k using two_step; [rewrite !u_0; ring | rewrite !u_1; cbn; ring |]. rewrite !u_SS, IHk, IHk0; cbn; ring.
Qed.
Lemma v_mirror a1 a2 k : v (- a1) a2 k = (-1) ^ k * v a1 a2 k.
Proof. unfold v; rewrite !u_mirror; cbn; ring. Qed.

(** With eigenvalues. *)
Lemma u_step p q k : u (p + q) (p * q) (S k) = p * u (p + q) (p * q) k + q ^ k.
Proof.
  induction k as [|k IH]; [rewrite u_1, u_0; cbn; ring |]. rewrite u_SS; cbn [pow].
  replace (q ^ k) with (u (p + q) (p * q) (S k) - p * u (p + q) (p * q) k) by lra. ring.
Qed.
Lemma v_eigenvalues p q k : v (p + q) (p * q) k = p ^ k + q ^ k.
Proof.
  induction k using two_step; [rewrite v_0; cbn; ring | rewrite v_1; cbn; ring |]. rewrite v_SS, IHk, IHk0; cbn; ring.
Qed.

(** 1 - v_n + a2^n = (lambda1^n - 1) (lambda2^n - 1) = det (I - A^n), whose sign makes
    that of c_n and of the large eigenvalue. *)
Definition detIA (a1 a2 : R) (n : nat) : R := 1 - v a1 a2 n + a2 ^ n.

Lemma detIA_eigenvalues p q n : detIA (p + q) (p * q) n = (1 - p ^ n) * (1 - q ^ n).
Proof. unfold detIA; rewrite v_eigenvalues, Rpow_mult_distr; ring. Qed.
Lemma eigenvalues_exist a1 a2 : 4 * a2 <= a1 ^ 2 -> exists p q, a1 = p + q /\ a2 = p * q /\ q <= p.
Proof.
  intros H; set (d := sqrt (a1 ^ 2 - 4 * a2)). assert (Hd : d * d = a1 ^ 2 - 4 * a2) by (apply sqrt_sqrt; lra).
  assert (0 <= d) by apply sqrt_pos. exists ((a1 + d) / 2), ((a1 - d) / 2); repeat split; lra.
Qed.

(** ** The sequence x_k = C A^k X, which starts and ends at -1

    X = (-1, g) with g = (u_{n+1} - 1) / u_n, and b_{n,k} = 1 + x_k. *)
Definition orbit_x (a1 a2 : R) (n k : nat) : R :=
  u a1 a2 k * ((u a1 a2 (S n) - 1) / u a1 a2 n) - u a1 a2 (S k).

Lemma x_0 a1 a2 n : orbit_x a1 a2 n 0 = -1. Proof. unfold orbit_x; rewrite u_0, u_1; ring. Qed.
Lemma x_n a1 a2 n : u a1 a2 n <> 0 -> orbit_x a1 a2 n n = -1.
Proof. intros; unfold orbit_x; field; assumption. Qed.
Lemma x_SS a1 a2 n k : orbit_x a1 a2 n (S (S k)) = a1 * orbit_x a1 a2 n (S k) - a2 * orbit_x a1 a2 n k.
Proof. unfold orbit_x; rewrite !u_SS; ring. Qed.
Lemma b_is_1_plus_x a1 a2 n k : (k <= n)%nat -> u a1 a2 n <> 0 -> b a1 a2 n k = 1 + orbit_x a1 a2 n k.
Proof.
  intros Hk Hn; unfold b, orbit_x. pose proof (u_addition a1 a2 (n - k) k) as H.
  replace (n - k + k)%nat with n in H by lia. rewrite H; field; assumption.
Qed.
