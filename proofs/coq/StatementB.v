(** * Statements: appendix B, the functions b_{n,k}(s) on r = 1

    Read [Defs] and [Statement] first. Where u_n = 0 the quotient (B1) has limits or
    poles in s, which say nothing about orbits but shape Theorem 2. *)

From Coq Require Import Reals ZArith.
From Grazing Require Import Defs Statement.
Open Scope R_scope.

(** (B1), and (B2) in [B_formulas_statement]. *)
Definition B (n k : nat) (s : R) : R :=
  - 2 * sin (INR k * PI * s) * sin (INR (n - k) * PI * s) / cos (INR n * PI * s).

Definition B_formulas_statement : Prop := forall s n k,
  0 < s < 1 / 2 -> (k <= n)%nat -> u (trace 1 s) (1 ^ 2) n <> 0 -> b_at 1 s n k = B n k s /\
  c_at 1 s n = - 2 * sin (2 * PI * s) * tan (INR n * PI * s).

(** Away from the odd multiples of 1/(2n): the zeros are m/k and m/(n-k). *)
Definition B_zeros_statement : Prop := forall n k s, cos (INR n * PI * s) <> 0 ->
  (B n k s = 0 <-> exists m : Z, INR k * s = IZR m \/ INR (n - k) * s = IZR m).

(** f(h) tends to l as h tends to 0, h <> 0. *)
Definition tends (f : R -> R) (l : R) : Prop := limit1_in f (fun h => h <> 0) l 0.

(** A zero of only one of the two kinds is simple. *)
Definition B_simple_zero_statement : Prop := forall n k s (m : Z),
  (1 <= k <= n - 1)%nat -> cos (INR n * PI * s) <> 0 ->
  (INR k * s = IZR m -> sin (INR (n - k) * PI * s) <> 0 ->
   exists d, d <> 0 /\ tends (fun h => B n k (s + h) / h) d) /\
  (INR (n - k) * s = IZR m -> sin (INR k * PI * s) <> 0 ->
   exists d, d <> 0 /\ tends (fun h => B n k (s + h) / h) d).

(** A zero of both kinds is double, and lies at a multiple of 1/n. *)
Definition B_double_zero_statement : Prop := forall n k s (m l : Z),
  (1 <= k <= n - 1)%nat -> INR k * s = IZR m -> INR (n - k) * s = IZR l -> INR n * s = IZR (m + l) /\
  (forall h, B n k (s + h) =
   - 2 * sin (INR k * PI * h) * sin (INR (n - k) * PI * h) / cos (INR n * PI * h)) /\
  tends (fun h => B n k (s + h) / h ^ 2) (- 2 * PI ^ 2 * INR k * INR (n - k)).

Definition B_at_multiples_statement : Prop := forall n k (m : Z),
  (1 <= n)%nat -> (k <= n)%nat -> B n k (IZR m / INR n) = 2 * sin (PI * INR k * IZR m / INR n) ^ 2.

(** At s = (2m+1)/(2n), with x = k (2m+1)/n: a simple pole unless x is an integer. *)
Definition B_at_odd_multiples_statement : Prop := forall n k (m : Z),
  (1 <= k <= n - 1)%nat -> let s := IZR (2 * m + 1) / (2 * INR n) in
  let x := INR k * IZR (2 * m + 1) / INR n in
  (forall h, sin (INR n * PI * h) <> 0 ->
   B n k (s + h) = 1 + sin (PI * x - (INR n - 2 * INR k) * PI * h) / sin (INR n * PI * h)) /\
  tends (fun h => h * B n k (s + h)) (sin (PI * x) / (PI * INR n)) /\
  (forall j : Z, x = IZR (2 * j + 1) -> tends (fun h => B n k (s + h)) (2 * INR (n - k) / INR n)) /\
  (forall j : Z, x = IZR (2 * j) -> tends (fun h => B n k (s + h)) (2 * INR k / INR n)).
