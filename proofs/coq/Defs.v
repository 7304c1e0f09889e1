(** * Definitions: the single-impact quantities of the planar grazing map

    The first thing to read. Everything is stated about the trace [a1] and the
    determinant [a2] of the linear part A, or about r and s with
    a1 = 2 r cos(2 pi s), a2 = r^2. Only the standard library is used. *)

From Coq Require Import Reals ZArith Znumtheory.
Open Scope R_scope.

(** u_0 = 0, u_1 = 1, u_{k+1} = a1 u_k - a2 u_{k-1}: [pair k] is (u_k, u_{k+1}). *)
Fixpoint pair (a1 a2 : R) (k : nat) : R * R :=
  match k with
  | O => (0, 1)
  | S j => let (x, y) := pair a1 a2 j in (y, a1 * y - a2 * x)
  end.

Definition u (a1 a2 : R) (k : nat) : R := fst (pair a1 a2 k).

(** v_n = lambda1^n + lambda2^n, the trace of A^n, n >= 0. *)
Definition v (a1 a2 : R) (n : nat) : R := 2 * u a1 a2 (S n) - a1 * u a1 a2 n.

(** (59) and (60); both need u_n <> 0. *)
Definition b (a1 a2 : R) (n k : nat) : R :=
  (u a1 a2 n - u a1 a2 k - a2 ^ k * u a1 a2 (n - k)) / u a1 a2 n.

Definition c (a1 a2 : R) (n : nat) : R :=
  - (1 - v a1 a2 n + a2 ^ n) / u a1 a2 n.

(** A case (sign e mu, sign gamma). *)
Inductive sign := Plus | Minus.
Definition sgn (x : sign) : R := match x with Plus => 1 | Minus => -1 end.

(** The conditions (52) and (53) hold: by Theorem 1 of the paper there is exactly one
    single-impact orbit of period n in the case (emu, gamma). *)
Definition orbit (a1 a2 : R) (n : nat) (emu gamma : sign) : Prop :=
  u a1 a2 n <> 0 /\
  (forall k : nat, (1 <= k <= n - 1)%nat -> sgn emu * b a1 a2 n k > 0) /\
  sgn emu * sgn gamma * c a1 a2 n > 0.

(** (52) or (53) fails strictly in every case: by Theorem 1 no such orbit. *)
Definition no_orbit (a1 a2 : R) (n : nat) : Prop :=
  u a1 a2 n <> 0 /\
  exists k k' : nat, (1 <= k <= n - 1)%nat /\ (1 <= k' <= n - 1)%nat /\
    b a1 a2 n k < 0 /\ b a1 a2 n k' > 0.
