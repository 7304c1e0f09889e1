(** * Statement: the signs of u_n, b_{n,k}, c_n and the existence of orbits at rational
    (a1, a2), decided with integers alone

    a1 = x/z, a2 = y/z, z > 0. With U_k = z^(k-1) u_k every quantity of (59) and (60) is
    an integer over a positive one; no fraction is formed. [Oracle] extracts these
    functions, and `cargo test --test coq` compares what `grazing` prints with them. *)

From Coq Require Import Reals ZArith List Bool.
From Grazing Require Import Defs.
Open Scope Z_scope.

(** (U_k, U_{k+1}), U_{k+1} = x U_k - y z U_{k-1}. *)
Fixpoint pairZ (x y z : Z) (k : nat) : Z * Z :=
  match k with O => (0, 1) | S j => let (h, l) := pairZ x y z j in (l, x * l - y * z * h) end.

Definition uZ (x y z : Z) (k : nat) : Z := fst (pairZ x y z k).

(** The sign of b_{n,k}, of c_n and of 1 - v_n + a2^n: -1, 0 or 1. *)
Definition signB (x y z : Z) (n k : nat) : Z := Z.sgn (uZ x y z n) *
  Z.sgn (uZ x y z n - z ^ Z.of_nat (n - k) * uZ x y z k - y ^ Z.of_nat k * uZ x y z (n - k)).

Definition signD (x y z : Z) (n : nat) : Z :=
  Z.sgn (z ^ Z.of_nat n - (2 * uZ x y z (S n) - x * uZ x y z n) + y ^ Z.of_nat n).

Definition signC (x y z : Z) (n : nat) : Z := - (Z.sgn (uZ x y z n) * signD x y z n).

Definition sgnZ (e : sign) : Z := match e with Plus => 1 | Minus => -1 end.

Definition orbitZ (x y z : Z) (n : nat) (e g : sign) : bool :=
  negb (uZ x y z n =? 0) &&
  forallb (fun k => 0 <? sgnZ e * signB x y z n k) (seq 1 (n - 1)) &&
  (0 <? sgnZ e * sgnZ g * signC x y z n).

Definition no_orbitZ (x y z : Z) (n : nat) : bool :=
  negb (uZ x y z n =? 0) &&
  existsb (fun k => signB x y z n k <? 0) (seq 1 (n - 1)) &&
  existsb (fun k => 0 <? signB x y z n k) (seq 1 (n - 1)).

(** The sign of p_j - q_i, by which j may follow i, (64); membership, edges and patterns of [StatementWords].
    *)
Definition signE (x y z : Z) (i j : nat) : Z := Z.sgn (uZ x y z i) * (Z.sgn (uZ x y z j) *
  Z.sgn (uZ x y z (i + j) - z ^ Z.of_nat j * uZ x y z i - y ^ Z.of_nat i * uZ x y z j)).

Definition memberZ (x y z : Z) (e : sign) (n : nat) : bool :=
  negb (uZ x y z n =? 0) && forallb (fun k => 0 <? sgnZ e * signB x y z n k) (seq 1 (n - 1)).

Definition edgeZ (x y z : Z) (e g : sign) (i j : nat) : bool := 0 <? sgnZ e * sgnZ g * signE x y z i j.

Fixpoint walkZ (E : nat -> nat -> bool) (i : nat) (l : list nat) (j : nat) : bool :=
  match l with nil => E i j | cons k l => E i k && walkZ E k l j end.

Definition patternZ (x y z : Z) (e g : sign) (l : list nat) : bool := match l with nil => false
  | cons i l' => forallb (memberZ x y z e) l && walkZ (edgeZ x y z e g) i l' i end.

Open Scope R_scope.

(** h < 0, h = 0, h > 0 as t. *)
Definition sign_of (h : Z) (t : R) : Prop :=
  ((h < 0)%Z <-> t < 0) /\ (h = 0%Z <-> t = 0) /\ ((0 < h)%Z <-> 0 < t).

Definition Oracle_statement : Prop := forall x y z n, (0 < z)%Z ->
  let a1 := IZR x / IZR z in let a2 := IZR y / IZR z in
  (uZ x y z n = 0%Z <-> u a1 a2 n = 0) /\
  (u a1 a2 n <> 0 -> sign_of (signC x y z n) (c a1 a2 n) /\
   forall k, (k <= n)%nat -> sign_of (signB x y z n k) (b a1 a2 n k)) /\
  sign_of (signD x y z n) (1 - v a1 a2 n + a2 ^ n) /\
  (forall e g, orbitZ x y z n e g = true <-> orbit a1 a2 n e g) /\
  (no_orbitZ x y z n = true <-> no_orbit a1 a2 n).
