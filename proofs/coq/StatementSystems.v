(** * Statements about the motions of oscillators and the orbits of maps: what [orbit] and [no_orbit] of
    [Defs] mean, S1-S3, the summary by period, the record form, impact patterns

    Each is a statement about signs, of [Statement], [StatementPlane] and [StatementWords], said of every
    [system] of [Headline]: read these first. *)

From Coq Require Import Reals ZArith List Arith.
From Grazing Require Import Defs Statement StatementPlane StatementWords Headline.
Import ListNotations.
Open Scope R_scope.

(** ** One impact per period *)

(** (52) or (53) fails strictly in the case (e, g). *)
Definition fails (a1 a2 : R) (n : nat) (e g : sign) : Prop :=
  (exists k, (1 <= k <= n - 1)%nat /\ sgn e * b a1 a2 n k < 0) \/ sgn e * sgn g * c a1 a2 n < 0.

Definition Single_statement : Prop := forall S a1 a2 gamma n e g, grazes S a1 a2 gamma ->
  (1 <= n)%nat -> u a1 a2 n <> 0 -> sgn g * gamma > 0 ->
  (orbit a1 a2 n e g -> born S n e) /\ (fails a1 a2 n e g -> unborn S n e) /\ ~ (born S n e /\ unborn S n e).

Definition Meaning_statement : Prop := forall a1 a2 n, (2 <= n)%nat ->
  (forall e g, orbit a1 a2 n e g -> exactly a1 a2 n e g) /\ (no_orbit a1 a2 n -> never a1 a2 n).

(** S1, S2 and S3. *)
Definition S1_S3_statement : Prop := forall r s n m, (2 <= n)%nat -> cell r s n m ->
  let a1 := trace r s in let a2 := r ^ 2 in
  (m = 0%nat -> exactly a1 a2 n Minus Plus) /\
  ((1 <= m)%nat -> Nat.gcd m n <> 1%nat -> never a1 a2 n) /\
  ((1 <= m)%nat -> forall F : Farey m n,
   (INR n * s < INR m -> (b a1 a2 n (n_minus F) > 0 -> exactly a1 a2 n Plus Plus) /\
                         (b a1 a2 n (n_minus F) < 0 -> never a1 a2 n)) /\
   (INR n * s > INR m -> (b a1 a2 n (n_plus F) > 0 -> exactly a1 a2 n Plus Minus) /\
                         (b a1 a2 n (n_plus F) < 0 -> never a1 a2 n))).

(** No quantity of (52), (53) is zero. *)
Definition no_zeros (a1 a2 : R) (n : nat) : Prop := u a1 a2 n <> 0 /\ c a1 a2 n <> 0 /\
  forall k, (1 <= k <= n - 1)%nat -> b a1 a2 n k <> 0.

(** Section 3.7 and appendix A, n >= 2. *)
Definition listed (a1 a2 : R) (n : nat) (e g : sign) : Prop :=
  n = 2%nat /\
  (a2 + 1 < a1 /\ e = Plus /\ g = Plus \/ 0 < a1 < a2 + 1 /\ e = Minus /\ g = Plus \/
   - (a2 + 1) < a1 < 0 /\ e = Plus /\ g = Plus \/ a1 < - (a2 + 1) /\ e = Plus /\ g = Minus) \/
  (3 <= n)%nat /\
  (a2 + 1 < a1 /\ e = Plus /\ g = Plus \/
   2 * sqrt a2 * cos (PI / INR n) < a1 < a2 + 1 /\ e = Minus /\ g = Plus \/
   area3 a1 a2 n g /\ e = Plus \/ area4 a1 a2 n /\ e = Plus /\ g = Minus \/
   a1 < - (a2 + 1) /\ e = Plus /\ g = Minus).

Definition Summary_systems_statement : Prop := forall S a1 a2 gamma n e g, grazes S a1 a2 gamma ->
  0 < a2 <= 1 -> sgn g * gamma > 0 ->
  (sgn e * sgn g * (a1 - (a2 + 1)) > 0 -> born S 1 e) /\
  (sgn e * sgn g * (a1 - (a2 + 1)) < 0 -> unborn S 1 e) /\
  (listed a1 a2 n e g -> born S n e) /\
  ((2 <= n)%nat -> no_zeros a1 a2 n -> ~ listed a1 a2 n e g -> unborn S n e).

(** [f], [high] and [low] are those of [StatementPlane]. *)
Definition Record_systems_statement : Prop := forall a1 a2 n,
  0 < a2 <= 1 -> Rabs a1 < a2 + 1 -> (2 <= n)%nat ->
  (high a1 a2 n -> f a1 a2 n > 0 -> exactly a1 a2 n Plus Minus) /\
  (low a1 a2 n -> f a1 a2 n < 0 -> exactly a1 a2 n Plus Plus) /\
  (low a1 a2 n -> f a1 a2 n > 0 -> exactly a1 a2 n Minus Plus) /\
  (~ high a1 a2 n -> ~ low a1 a2 n -> no_zeros a1 a2 n -> never a1 a2 n).

(** ** Patterns: closed walks in the graph of (52) and (64) *)
Definition cyclic_letter (l : list nat) (i : Z) : nat := nth (Z.to_nat (i mod Z.of_nat (length l))) l 0%nat.

(** All patterns over {n <= n_max : u_n <> 0}, with one mu0. *)
Definition Patterns_statement : Prop := forall S a1 a2 gamma, grazes S a1 a2 gamma -> forall n_max,
  exists d, d > 0 /\ forall eps, 0 < eps <= d -> exists mu0, mu0 > 0 /\ forall l e g mu,
  l <> [] -> Forall (fun n => (1 <= n <= n_max)%nat /\ u a1 a2 n <> 0) l ->
  sgn g * gamma > 0 -> 0 < sgn e * e_mu S mu < mu0 ->
  (pattern a1 a2 e g l -> one S mu eps (cyclic_letter l)) /\
  ((exists i, breaks a1 a2 e g (cyclic_letter l i) (cyclic_letter l (i + 1))) ->
    none S mu d (cyclic_letter l)).

(** Regions 3 and 4 with damping, e mu > 0: one mu0 for all patterns; the caveat that ends the paper's section
    2.5 falls there. *)
Definition All_patterns_statement : Prop := forall S a1 a2 gamma K, grazes S a1 a2 gamma ->
  first_upper a1 a2 K -> a2 < 1 -> exists d, d > 0 /\ forall eps, 0 < eps <= d -> exists mu0, mu0 > 0 /\
  forall l g mu, sgn g * gamma > 0 -> 0 < e_mu S mu < mu0 -> pattern a1 a2 Plus g l ->
    one S mu eps (cyclic_letter l).

(** Every region: all sequences of periods up to n_max that are born in one case. *)
Definition Shift_statement : Prop := forall S a1 a2 gamma, grazes S a1 a2 gamma -> 0 < a2 -> forall n_max,
  exists d, d > 0 /\ forall eps, 0 < eps <= d -> exists mu0, mu0 > 0 /\ forall (n : Z -> nat) e g mu,
  (forall i, (n i <= n_max)%nat /\ orbit a1 a2 (n i) e g) ->
  sgn g * gamma > 0 -> 0 < sgn e * e_mu S mu < mu0 -> one S mu eps n.
