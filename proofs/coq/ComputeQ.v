(** * Values at fixed rational points, to be compared with another program

    Two lists of integers are printed. Twelve for each point and k: the numerators and
    denominators of a1 and a2, n, k, and those of u_n, b_{n,k} and c_n in lowest terms.
    Nine for each point and each period up to its n: a1, a2, the period, and 1 or 0 for
    each case in which the orbit does or does not exist. *)

From Coq Require Import QArith List.
From Grazing Require Import Defs DefsQ.
Import ListNotations.

(** Regions 1 to 5, equal eigenvalues of both signs, and a2 = 1; u_n <> 0 at each. *)
Definition points : list (Q * Q * nat) :=
  [ (5 # 2, 3 # 4, 7%nat); (7 # 4, 13 # 16, 8%nat); (3 # 2, 9 # 16, 6%nat);
    (6 # 5, 81 # 100, 8%nat); (-1 # 3, 99 # 100, 11%nat); (-7 # 5, 1 # 2, 9%nat);
    (-7 # 5, 49 # 100, 7%nat); (-13 # 8, 5 # 8, 12%nat); (-3 # 1, 1 # 2, 7%nat);
    (17 # 10, 1 # 1, 10%nat); (-123 # 100, 999 # 1000, 9%nat) ].

Definition fraction (x : Q) : list Z := [Qnum x; Z.pos (Qden x)].

Definition row (a1 a2 : Q) (n k : nat) : list Z :=
  fraction a1 ++ fraction a2 ++ [Z.of_nat n; Z.of_nat k] ++
  fraction (uQ a1 a2 n) ++ fraction (bQ a1 a2 n k) ++ fraction (cQ a1 a2 n).

Definition rows : list Z :=
  flat_map (fun '(a1, a2, n) => flat_map (row a1 a2 n) (seq 1 (n - 1))) points.

Definition cases (a1 a2 : Q) (n : nat) : list Z :=
  fraction a1 ++ fraction a2 ++ [Z.of_nat n] ++
  map (fun '(e, g) => if orbitQ a1 a2 n e g then 1%Z else 0%Z)
    [(Plus, Plus); (Plus, Minus); (Minus, Plus); (Minus, Minus)].

Definition existence : list Z :=
  flat_map (fun '(a1, a2, n) => flat_map (cases a1 a2) (seq 1 n)) points.

Open Scope Z_scope.
Eval vm_compute in rows.
Eval vm_compute in existence.
