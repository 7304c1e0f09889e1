(** * Statements: which orbits there are in the rest of the (a1, a2) plane, and what the definitions stand for

    Read [Defs] and [Statement] first. Regions as in section 3.2 of the paper. *)

From Coq Require Import Reals Arith.
From Grazing Require Import Defs Statement.
Open Scope R_scope.

(** ** Periods 1 and 2, wherever a1 and a2 are *)

Definition Period1_statement : Prop := forall a1 a2 e g,
  orbit a1 a2 1 e g <-> sgn e * sgn g * (a1 - (a2 + 1)) > 0.

Definition Period2_statement : Prop := forall a1 a2 e g, 0 < a2 ->
  (orbit a1 a2 2 e g <->
   a2 + 1 < a1 /\ e = Plus /\ g = Plus \/
   0 < a1 < a2 + 1 /\ e = Minus /\ g = Plus \/
   - (a2 + 1) < a1 < 0 /\ e = Plus /\ g = Plus \/
   a1 < - (a2 + 1) /\ e = Plus /\ g = Minus).

(** ** Appendix A: regions 1, 2 and 5, and the two lines where 1 or -1 is an eigenvalue *)

(** [orbit] says all signs: here all b_{n,k} > 0 and c_n > 0. *)
Definition Region1_statement : Prop := forall a1 a2 n,
  0 < a2 -> a2 + 1 < a1 -> (1 <= n)%nat -> u a1 a2 n > 0 /\ orbit a1 a2 n Plus Plus.

(** All b_{n,k} < 0 and c_n < 0. Equal eigenvalues, a1 = 2 sqrt a2, included. *)
Definition Region2_statement : Prop := forall a1 a2 n,
  0 < a2 < 1 -> 2 * sqrt a2 <= a1 < a2 + 1 -> (1 <= n)%nat ->
  u a1 a2 n > 0 /\ orbit a1 a2 n Minus Plus.

(** All b_{n,k} > 0 and c_n < 0. For odd n the line a1 = -(a2+1) goes with region 5. *)
Definition Region5_statement : Prop := forall a1 a2 n, 0 < a2 -> (1 <= n)%nat ->
  a1 < - (a2 + 1) \/ a1 = - (a2 + 1) /\ Nat.Odd n -> orbit a1 a2 n Plus Minus.

(** Elsewhere on the two lines Theorem 1 is silent: some b and c vanish. *)
Definition Lines_statement : Prop := forall a2 n, 0 < a2 -> (1 <= n)%nat ->
  u (a2 + 1) a2 n <> 0 /\ u (- (a2 + 1)) a2 n <> 0 /\
  c (a2 + 1) a2 n = 0 /\ (forall k, (1 <= k <= n - 1)%nat -> b (a2 + 1) a2 n k = 0) /\
  (Nat.Even n -> c (- (a2 + 1)) a2 n = 0 /\
   forall k, (1 <= k <= n - 1)%nat -> Nat.Even k -> b (- (a2 + 1)) a2 n k = 0).

(** ** Region 3 has coordinates: one (r, s) for each (a1, a2) with a1^2 < 4 a2 *)

Definition Coordinates_statement : Prop := forall a1 a2, a1 ^ 2 < 4 * a2 ->
  exists r s, 0 < r /\ 0 < s < 1 / 2 /\ a1 = trace r s /\ a2 = r ^ 2 /\
  forall r' s', 0 < r' -> 0 < s' < 1 / 2 -> a1 = trace r' s' -> a2 = r' ^ 2 ->
  r' = r /\ s' = s.

(** ** Section 3.7: the summary by period, 0 < a2 <= 1 *)

(** The areas of region 3: over one of Theorem 2's intervals, where b_{n,k} > 0 for the
    index k that decides there. *)
Definition area3 (a1 a2 : R) (n : nat) (g : sign) : Prop :=
  exists r s k lo hi, 0 < r /\ 0 < s < 1 / 2 /\ a1 = trace r s /\ a2 = r ^ 2 /\
  side n k g lo hi /\ lo < s < hi /\ b a1 a2 n k > 0.

(** The part of the leftmost area beyond region 3, n odd. *)
Definition area4 (a1 a2 : R) (n : nat) : Prop :=
  Nat.Odd n /\ - (a2 + 1) <= a1 <= - 2 * sqrt a2 /\ b a1 a2 n (n - 2) > 0.

Definition Summary_statement : Prop := forall a1 a2 n e g,
  0 < a2 <= 1 -> (3 <= n)%nat ->
  (orbit a1 a2 n e g <->
   a2 + 1 < a1 /\ e = Plus /\ g = Plus \/
   2 * sqrt a2 * cos (PI / INR n) < a1 < a2 + 1 /\ e = Minus /\ g = Plus \/
   area3 a1 a2 n g /\ e = Plus \/
   area4 a1 a2 n /\ e = Plus /\ g = Minus \/
   a1 < - (a2 + 1) /\ e = Plus /\ g = Minus).

(** For odd n the leftmost area and region 5 are one: at each determinant a single
    half-line, which ends where b_{n,n-2} = 0. *)
Definition Joined_statement : Prop := forall a2 n, 0 < a2 < 1 ->
  (3 <= n)%nat -> Nat.Odd n -> exists a1s,
  - (a2 + 1) < a1s < trace (sqrt a2) ((1 - 1 / INR n) / 2) /\
  u a1s a2 n <> 0 /\ b a1s a2 n (n - 2) = 0 /\
  forall a1, a1 < trace (sqrt a2) ((1 - 1 / INR n) / 2) ->
  (orbit a1 a2 n Plus Minus <-> a1 < a1s).

(** ** a2 > 1: the same in reversed time (section 3.2) *)

Definition Reversal_statement : Prop := forall a1 a2 n, 0 < a2 ->
  (u (a1 / a2) (/ a2) n <> 0 <-> u a1 a2 n <> 0) /\
  (u a1 a2 n <> 0 -> c (a1 / a2) (/ a2) n = c a1 a2 n / a2 /\
   forall k, (k <= n)%nat -> b (a1 / a2) (/ a2) n k = b a1 a2 n (n - k)) /\
  (forall e g, orbit (a1 / a2) (/ a2) n e g <-> orbit a1 a2 n e g) /\
  (no_orbit (a1 / a2) (/ a2) n <-> no_orbit a1 a2 n).

(** ** Section 3.6: the sign of the eigenvalue of largest modulus, formula (61) *)

Definition large (K gamma emu a1 a2 : R) (n : nat) : R :=
  K ^ 2 * gamma ^ 2 * u a1 a2 n ^ 2 / (2 * emu * (1 - v a1 a2 n + a2 ^ n)).

(** The last line: a1 = -(a2+1), n odd, with regions 2, 3 and 4. *)
Definition Large_statement : Prop := forall K gamma emu a1 a2 n,
  K <> 0 -> gamma <> 0 -> emu <> 0 -> 0 < a2 <= 1 -> (1 <= n)%nat -> u a1 a2 n <> 0 ->
  (a2 + 1 < a1 -> large K gamma emu a1 a2 n * emu < 0) /\
  (Rabs a1 < a2 + 1 -> large K gamma emu a1 a2 n * emu > 0) /\
  (a1 < - (a2 + 1) -> (-1) ^ (n + 1) * large K gamma emu a1 a2 n * emu > 0) /\
  (a1 = - (a2 + 1) -> Nat.Odd n -> large K gamma emu a1 a2 n * emu > 0).

(** ** The record form: one pass over u_j / (2 - v_j) decides every period *)

(** 0 where u_j = 0, which includes 2 - v_j = 0 when |a1| < a2 + 1 and a2 <= 1. *)
Definition f (a1 a2 : R) (j : nat) : R := u a1 a2 j / (2 - v a1 a2 j).

Definition high (a1 a2 : R) (n : nat) : Prop :=
  forall k, (1 <= k <= n - 1)%nat -> f a1 a2 k < f a1 a2 n.
Definition low (a1 a2 : R) (n : nat) : Prop :=
  forall k, (1 <= k <= n - 1)%nat -> f a1 a2 n < f a1 a2 k.

Definition Record_identity_statement : Prop := forall a1 a2 n k, (k <= n)%nat ->
  2 * (u a1 a2 n - u a1 a2 k - a2 ^ k * u a1 a2 (n - k)) =
  u a1 a2 n * (2 - v a1 a2 k) - u a1 a2 k * (2 - v a1 a2 n).

(** Regions 2, 3 and 4, and the circle a2 = 1. *)
Definition Record_statement : Prop := forall a1 a2 n,
  0 < a2 <= 1 -> Rabs a1 < a2 + 1 -> (2 <= n)%nat ->
  (forall j, (1 <= j)%nat ->
   2 - v a1 a2 j > 0 \/ a2 = 1 /\ 2 - v a1 a2 j = 0 /\ u a1 a2 j = 0) /\
  (orbit a1 a2 n Plus Minus <-> high a1 a2 n /\ f a1 a2 n > 0) /\
  (orbit a1 a2 n Plus Plus <-> low a1 a2 n /\ f a1 a2 n < 0) /\
  (orbit a1 a2 n Minus Plus <-> low a1 a2 n /\ f a1 a2 n > 0) /\
  ~ orbit a1 a2 n Minus Minus.

(** ** Where u, b and c come from: equations (51), (54)-(60) *)

Record mat := Mat { m11 : R; m12 : R; m21 : R; m22 : R }.
Definition one : mat := Mat 1 0 0 1.
Definition mul (M N : mat) : mat :=
  Mat (m11 M * m11 N + m12 M * m21 N) (m11 M * m12 N + m12 M * m22 N)
      (m21 M * m11 N + m22 M * m21 N) (m21 M * m12 N + m22 M * m22 N).
Fixpoint mpow (M : mat) (k : nat) : mat :=
  match k with O => one | S j => mul M (mpow M j) end.
Definition apply (M : mat) (X : R * R) : R * R :=
  (m11 M * fst X + m12 M * snd X, m21 M * fst X + m22 M * snd X).

(** The normal form (45) of the linear part; C = (1 0). *)
Definition A (a1 a2 : R) : mat := Mat a1 1 (- a2) 0.

(** (51): C (I - A^n) X = 0 and C X = -1. *)
Definition single_impact (a1 a2 : R) (n : nat) (X : R * R) : Prop :=
  fst X - fst (apply (mpow (A a1 a2) n) X) = 0 /\ fst X = -1.

Definition Matrix_statement : Prop := forall a1 a2 n, u a1 a2 n <> 0 ->
  mpow (A a1 a2) (S n) = Mat (u a1 a2 (S (S n))) (u a1 a2 (S n))
                             (- a2 * u a1 a2 (S n)) (- a2 * u a1 a2 n) /\
  (exists X, single_impact a1 a2 n X) /\
  forall X, single_impact a1 a2 n X ->
  X = (-1, (u a1 a2 (S n) - 1) / u a1 a2 n) /\
  (forall k, (k <= n)%nat -> b a1 a2 n k = 1 + fst (apply (mpow (A a1 a2) k) X)) /\
  c a1 a2 n = snd X - snd (apply (mpow (A a1 a2) n) X).

(** v_n is the trace of A^n, and (60)'s numerator is det (I - A^n). *)
Definition Trace_statement : Prop := forall a1 a2 n,
  let M := mpow (A a1 a2) n in
  m11 M + m22 M = v a1 a2 n /\
  (1 - m11 M) * (1 - m22 M) - m12 M * m21 M = 1 - v a1 a2 n + a2 ^ n.
