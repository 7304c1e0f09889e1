(** * Statement: S1-S5, Theorem 2, Conjecture 1, the summary and the record form about orbits

    Each says which orbits with one impact there are, first in the words [exactly] and [none], whatever these mean,
    then for every smooth grazing map of the plane, [planar] in [StatementOrbitsPlane]; for oscillators in
    [StatementOscillatorOrbits]. Read [Statement] and [StatementPlane] first. *)

From Coq Require Import Reals Arith.
From Grazing Require Import Defs Statement StatementPlane StatementOrbits StatementOrbitsPlane.
Open Scope R_scope.

(** Every map with this trace and determinant has the orbit in the case (s, g) alone; in none. *)
Definition exactly_in (a1 a2 : R) (n : nat) (s g : sign) : Prop := forall M gamma e w,
  planar M a1 a2 gamma e w -> born_in M gamma e n s g.
Definition in_none (a1 a2 : R) (n : nat) : Prop := forall M gamma e w,
  planar M a1 a2 gamma e w -> never_born M e n.

(** No quantity of (52), (53) is zero. *)
Definition no_zeros (a1 a2 : R) (n : nat) : Prop := u a1 a2 n <> 0 /\ c a1 a2 n <> 0 /\
  forall k, (1 <= k <= n - 1)%nat -> b a1 a2 n k <> 0.

(** b_{n,d} decides, in the case (+, g). *)
Definition decides_about (exactly : R -> R -> nat -> sign -> sign -> Prop) (none : R -> R -> nat -> Prop)
  (a1 a2 : R) (n d : nat) (g : sign) : Prop :=
  (b a1 a2 n d > 0 -> exactly a1 a2 n Plus g) /\ (b a1 a2 n d < 0 -> none a1 a2 n).

Definition S1_S3_about (exactly : R -> R -> nat -> sign -> sign -> Prop) (none : R -> R -> nat -> Prop) : Prop :=
  forall r s n m, (2 <= n)%nat -> cell r s n m ->
  let a1 := trace r s in let a2 := r ^ 2 in
  (m = 0%nat -> exactly a1 a2 n Minus Plus) /\
  ((1 <= m)%nat -> Nat.gcd m n <> 1%nat -> none a1 a2 n) /\
  ((1 <= m)%nat -> forall F : Farey m n,
   (INR n * s < INR m -> decides_about exactly none a1 a2 n (n_minus F) Plus) /\
   (INR n * s > INR m -> decides_about exactly none a1 a2 n (n_plus F) Minus)).

Definition Theorem2_about (exactly : R -> R -> nat -> sign -> sign -> Prop) (none : R -> R -> nat -> Prop) : Prop :=
  forall n s, (3 <= n)%nat -> 0 < s < 1 / 2 ->
  (forall e g lo hi, interval n e g lo hi -> lo < s < hi -> exactly (trace 1 s) (1 ^ 2) n e g) /\
  (outside n s -> u_at 1 s n <> 0 -> none (trace 1 s) (1 ^ 2) n).

(** S4 and S5: the areas in regions 3 and 4, above the graphs of the functions Rad of [Statement],
    and no others. *)
Definition Conjecture1_about (exactly : R -> R -> nat -> sign -> sign -> Prop) (none : R -> R -> nat -> Prop) : Prop :=
  forall n, (3 <= n)%nat ->
  (forall r s, 0 < r <= 1 -> 0 < s < 1 / (2 * INR n) -> exactly (trace r s) (r ^ 2) n Minus Plus) /\
  (forall k g lo hi, side n k g lo hi -> exists Rad, above n k g lo hi Rad /\
   forall r s, 0 < r <= 1 -> lo < s < hi ->
   (Rad s < r -> exactly (trace r s) (r ^ 2) n Plus g) /\
   (r < Rad s -> none (trace r s) (r ^ 2) n)) /\
  (forall r s, 0 < r <= 1 -> 0 < s < 1 / 2 -> u_at r s n <> 0 ->
   (forall e g lo hi, interval n e g lo hi -> ~ lo < s < hi) ->
   r < 1 \/ outside n s -> none (trace r s) (r ^ 2) n) /\
  (forall a1 a2, 0 < a2 < 1 -> - (a2 + 1) < a1 <= - 2 * sqrt a2 ->
   (Nat.Even n -> none a1 a2 n) /\ (Nat.Odd n -> decides_about exactly none a1 a2 n (n - 2) Minus)).

(** Section 3.7 and appendix A, n >= 2. *)
Definition listed (a1 a2 : R) (n : nat) (s g : sign) : Prop :=
  n = 2%nat /\
  (a2 + 1 < a1 /\ s = Plus /\ g = Plus \/ 0 < a1 < a2 + 1 /\ s = Minus /\ g = Plus \/
   - (a2 + 1) < a1 < 0 /\ s = Plus /\ g = Plus \/ a1 < - (a2 + 1) /\ s = Plus /\ g = Minus) \/
  (3 <= n)%nat /\
  (a2 + 1 < a1 /\ s = Plus /\ g = Plus \/
   2 * sqrt a2 * cos (PI / INR n) < a1 < a2 + 1 /\ s = Minus /\ g = Plus \/
   area3 a1 a2 n g /\ s = Plus \/ area4 a1 a2 n /\ s = Plus /\ g = Minus \/
   a1 < - (a2 + 1) /\ s = Plus /\ g = Minus).

Definition Summary_about (some no : R -> R -> nat -> sign -> sign -> Prop) : Prop := forall a1 a2 n s g, 0 < a2 <= 1 ->
  (sgn s * sgn g * (a1 - (a2 + 1)) > 0 -> some a1 a2 1%nat s g) /\
  (sgn s * sgn g * (a1 - (a2 + 1)) < 0 -> no a1 a2 1%nat s g) /\
  (listed a1 a2 n s g -> some a1 a2 n s g) /\
  ((2 <= n)%nat -> no_zeros a1 a2 n -> ~ listed a1 a2 n s g -> no a1 a2 n s g).

(** [f], [high] and [low] are those of [StatementPlane]. *)
Definition Record_about (exactly : R -> R -> nat -> sign -> sign -> Prop) (none : R -> R -> nat -> Prop) : Prop :=
  forall a1 a2 n,
  0 < a2 <= 1 -> Rabs a1 < a2 + 1 -> (2 <= n)%nat ->
  (high a1 a2 n -> f a1 a2 n > 0 -> exactly a1 a2 n Plus Minus) /\
  (low a1 a2 n -> f a1 a2 n < 0 -> exactly a1 a2 n Plus Plus) /\
  (low a1 a2 n -> f a1 a2 n > 0 -> exactly a1 a2 n Minus Plus) /\
  (~ high a1 a2 n -> ~ low a1 a2 n -> no_zeros a1 a2 n -> none a1 a2 n).

(** About maps. *)
Definition S1_S3_statement_orbits : Prop := S1_S3_about exactly_in in_none.
Definition Theorem2_statement_orbits : Prop := Theorem2_about exactly_in in_none.
Definition Conjecture1_statement_orbits : Prop := Conjecture1_about exactly_in in_none.
Definition Record_statement_orbits : Prop := Record_about exactly_in in_none.
Definition Summary_statement_orbits : Prop := forall M gamma e w,
  Summary_about (fun a1 a2 n s g => planar M a1 a2 gamma e w -> sgn g * gamma > 0 -> born M e n s)
                (fun a1 a2 n s g => planar M a1 a2 gamma e w -> sgn g * gamma > 0 -> not_born M e n s).
