(** * Statement: the times of first return across a line, for complex eigenvalues of any modulus, are those of
    (52)

    Read [Defs], [trace] in [Statement], [A] in [StatementPlane], [member], [stern] and [vertices] in
    [StatementWords] first. A has the eigenvalues r exp(+- 2 pi i s), and C = (1 0). *)

From Coq Require Import Reals List Arith.
From Grazing Require Import Defs Statement StatementPlane StatementWords.
Import ListNotations. Open Scope R_scope.

(** Some point of the line C X = -1 is beyond the line, C X < -1, after n steps and not before. *)
Definition beyond (a1 a2 y : R) (k : nat) : Prop := fst (apply (mpow (A a1 a2) k) (-1, y)) < -1.
Definition return_time (a1 a2 : R) (n : nat) : Prop := (1 <= n)%nat /\
  exists y, beyond a1 a2 y n /\ forall k, (1 <= k <= n - 1)%nat -> ~ beyond a1 a2 y k.

(** The set of these times, and V, the periods with (52) for e mu > 0. *)
Definition T (r s : R) (n : nat) : Prop := return_time (trace r s) (r ^ 2) n.
Definition V (r s : R) (n : nat) : Prop := member (trace r s) (r ^ 2) Plus n.

(** An initial piece of the Stern-Brocot path to s from 0/1 and 1/K: 1 and K, and with a mediant all before
    it. *)
Definition initial_piece (s : R) (K : nat) (S : nat -> Prop) : Prop := S 1%nat /\ S K /\
  (forall n, S n -> n = 1%nat \/ n = K \/ exists w m1 n1 m2 n2, stern s K w m1 n1 m2 n2 /\
    n = (n1 + n2)%nat) /\
  forall w m1 n1 m2 n2, stern s K w m1 n1 m2 n2 -> S (n1 + n2)%nat -> Forall S (map fst (vertices K w)).

(** The tie: the mediant n of n1 and n2 shares its point with the parent on the other side, k is the sum of
    both. *)
Definition tie (a1 a2 : R) (n1 n2 k : nat) : Prop := let n := (n1 + n2)%nat in
  u a1 a2 n > 0 /\ p a1 a2 n = p a1 a2 n2 /\ k = (n + n2)%nat \/
  u a1 a2 n < 0 /\ p a1 a2 n = p a1 a2 n1 /\ k = (n + n1)%nat.

Record returns (r s : R) (K : nat) : Prop := {
  V_initial : initial_piece s K (V r s);
  T_initial : initial_piece s K (T r s);
  V_of_inverse : forall n, V r s n <-> V (/ r) s n;
  V_in_T : forall n, V r s n -> T r s n;
  T_is_V : r <= 1 -> forall n, T r s n <-> V r s n;
  V_all : r = 1 -> forall w m1 n1 m2 n2, stern s K w m1 n1 m2 n2 -> s * INR (n1 + n2) <> INR (m1 + m2) ->
    V r s (n1 + n2);
  T_beyond : 1 < r -> exists w m1 n1 m2 n2, stern s K w m1 n1 m2 n2 /\
    (forall k, V r s k <-> In k (map fst (vertices K w))) /\ ~ V r s (n1 + n2) /\
    forall k, T r s k <-> T (/ r) s k \/ k = (n1 + n2)%nat \/ tie (trace r s) (r ^ 2) n1 n2 k }.
Definition Returns_statement : Prop := forall r s K, 0 < r -> 0 < s < 1 / 2 ->
  2 * (INR K - 1) * s <= 1 < 2 * INR K * s -> returns r s K.
