(** * Statement: the signs of u_n, b_{n,k}, c_n and the existence of orbits at rational
    (a1, a2), decided with integers alone

    a1 = p/q, a2 = s/q, q > 0. With U_k = q^(k-1) u_k every quantity of (59) and (60) is
    an integer over a positive one; no fraction is formed. [Oracle] extracts these
    functions, and `cargo test --test coq` compares what `grazing` prints with them. *)

From Coq Require Import Reals ZArith List Bool.
From Grazing Require Import Defs.
Open Scope Z_scope.

(** (U_k, U_{k+1}), U_{k+1} = p U_k - s q U_{k-1}. *)
Fixpoint pairZ (p s q : Z) (k : nat) : Z * Z :=
  match k with O => (0, 1) | S j => let (x, y) := pairZ p s q j in (y, p * y - s * q * x) end.

Definition uZ (p s q : Z) (k : nat) : Z := fst (pairZ p s q k).

(** The sign of b_{n,k}, of c_n and of 1 - v_n + a2^n: -1, 0 or 1. *)
Definition signB (p s q : Z) (n k : nat) : Z := Z.sgn (uZ p s q n) *
  Z.sgn (uZ p s q n - q ^ Z.of_nat (n - k) * uZ p s q k - s ^ Z.of_nat k * uZ p s q (n - k)).

Definition signD (p s q : Z) (n : nat) : Z :=
  Z.sgn (q ^ Z.of_nat n - (2 * uZ p s q (S n) - p * uZ p s q n) + s ^ Z.of_nat n).

Definition signC (p s q : Z) (n : nat) : Z := - (Z.sgn (uZ p s q n) * signD p s q n).

Definition sgnZ (x : sign) : Z := match x with Plus => 1 | Minus => -1 end.

Definition orbitZ (p s q : Z) (n : nat) (e g : sign) : bool :=
  negb (uZ p s q n =? 0) &&
  forallb (fun k => 0 <? sgnZ e * signB p s q n k) (seq 1 (n - 1)) &&
  (0 <? sgnZ e * sgnZ g * signC p s q n).

Definition no_orbitZ (p s q : Z) (n : nat) : bool :=
  negb (uZ p s q n =? 0) &&
  existsb (fun k => signB p s q n k <? 0) (seq 1 (n - 1)) &&
  existsb (fun k => 0 <? signB p s q n k) (seq 1 (n - 1)).

(** The sign of p_j - q_i, by which j may follow i, (64); membership, edges and patterns of [StatementWords]. *)
Definition signE (p s q : Z) (i j : nat) : Z := Z.sgn (uZ p s q i) * (Z.sgn (uZ p s q j) *
  Z.sgn (uZ p s q (i + j) - q ^ Z.of_nat j * uZ p s q i - s ^ Z.of_nat i * uZ p s q j)).

Definition memberZ (p s q : Z) (e : sign) (n : nat) : bool :=
  negb (uZ p s q n =? 0) && forallb (fun k => 0 <? sgnZ e * signB p s q n k) (seq 1 (n - 1)).

Definition edgeZ (p s q : Z) (e g : sign) (i j : nat) : bool := 0 <? sgnZ e * sgnZ g * signE p s q i j.

Fixpoint walkZ (E : nat -> nat -> bool) (x : nat) (l : list nat) (y : nat) : bool :=
  match l with nil => E x y | cons z l => E x z && walkZ E z l y end.

Definition patternZ (p s q : Z) (e g : sign) (l : list nat) : bool := match l with nil => false
  | cons x l' => forallb (memberZ p s q e) l && walkZ (edgeZ p s q e g) x l' x end.

Open Scope R_scope.

(** z < 0, z = 0, z > 0 as x. *)
Definition sign_of (z : Z) (x : R) : Prop :=
  ((z < 0)%Z <-> x < 0) /\ (z = 0%Z <-> x = 0) /\ ((0 < z)%Z <-> 0 < x).

Definition Oracle_statement : Prop := forall p s q n, (0 < q)%Z ->
  let a1 := IZR p / IZR q in let a2 := IZR s / IZR q in
  (uZ p s q n = 0%Z <-> u a1 a2 n = 0) /\
  (u a1 a2 n <> 0 -> sign_of (signC p s q n) (c a1 a2 n) /\
   forall k, (k <= n)%nat -> sign_of (signB p s q n k) (b a1 a2 n k)) /\
  sign_of (signD p s q n) (1 - v a1 a2 n + a2 ^ n) /\
  (forall e g, orbitZ p s q n e g = true <-> orbit a1 a2 n e g) /\
  (no_orbitZ p s q n = true <-> no_orbit a1 a2 n).
