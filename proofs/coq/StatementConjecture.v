(** * Statement: Conjecture 1 of the paper, its five bullets in its order

    Read [Defs] and [Statement] first. "Left" and "right" are those of the (a1, a2)
    plane: at a fixed determinant a1 falls as s grows. *)

From Coq Require Import Reals Arith.
From Grazing Require Import Defs Statement.
Open Scope R_scope.

(** A fixed circle r < 1 meets the area over (lo, hi) in one interval (lo', hi'). *)
Definition connected_sections (n : nat) (g : sign) (lo hi : R) : Prop :=
  forall r, 0 < r < 1 -> exists lo' hi', lo <= lo' /\ hi' <= hi /\
  forall s, lo < s < hi -> (orbit_at r s n Plus g <-> lo' < s < hi').

(** The interval (lo, hi) of the circle r = 1 extends to an area, reached by no circle of
    small radius near its ends, and bounded by b_{n,k} = 0, on which no other b vanishes. *)
Definition extends (n k : nat) (g : sign) (lo hi : R) : Prop := exists Rad,
  above n k g lo hi Rad /\ tends_to_1 Rad lo hi lo /\ tends_to_1 Rad lo hi hi /\
  connected_sections n g lo hi.

Definition Conjecture1_statement : Prop := forall n, (3 <= n)%nat ->
  let N := INR n in
  (** (0, 1/(2n)) extends to a (-,+) area bounded by 0 < s < 1/(2n). *)
  (forall r s, 0 < r <= 1 -> 0 < s < 1 / (2 * N) -> orbit_at r s n Minus Plus) /\
  (** (1/(2n), 1/n) extends to a (+,+) area bounded to the left by b_{n,n-1} = 0 and to
      the right by s = 1/(2n). *)
  (exists Rad, above n (n - 1) Plus (1 / (2 * N)) (1 / N) Rad /\
   tends_to_1 Rad (1 / (2 * N)) (1 / N) (1 / N) /\
   (forall s, 1 / (2 * N) < s <= 1 / (2 * (N - 1)) -> Rad s = 0) /\
   forall r, 0 < r < 1 -> exists s', 1 / (2 * N) < s' <= 1 / N /\
   forall s, 1 / (2 * N) < s < 1 / N -> (orbit_at r s n Plus Plus <-> s < s')) /\
  (** ((n-1)/(2n), 1/2), n odd, extends to a (+,-) area bounded to the left by
      -(a2+1) < a1 and to the right by b_{n,n-2} = 0, regions 3 and 4 together. *)
  (Nat.Odd n ->
   (exists Rad, above n (n - 2) Minus ((N - 1) / (2 * N)) (1 / 2) Rad /\
    tends_to_1 Rad ((N - 1) / (2 * N)) (1 / 2) ((N - 1) / (2 * N))) /\
   forall a2, 0 < a2 < 1 -> let a1l := trace (sqrt a2) ((N - 1) / (2 * N)) in
   exists a1s, - (a2 + 1) < a1s < a1l /\ forall a1, - (a2 + 1) < a1 < a1l ->
   u a1 a2 n <> 0 /\ decides a1 a2 n (n - 2) Minus /\
   (a1 < a1s <-> b a1 a2 n (n - 2) > 0) /\ (a1 = a1s <-> b a1 a2 n (n - 2) = 0)) /\
  (** (m+/n+, m/n), m+/n+ not 0/1, extends to a (+,+) area bounded by b_{n,n-n+} = 0. *)
  (forall m (F : Farey m n), (0 < 2 * m < n)%nat -> m_plus F <> 0%nat ->
   extends n (n - n_plus F) Plus (INR (m_plus F) / INR (n_plus F)) (INR m / N)) /\
  (** (m/n, m-/n-), m-/n- not 1/2, extends to a (+,-) area bounded by b_{n,n-n-} = 0. *)
  (forall m (F : Farey m n), (0 < 2 * m < n)%nat -> (2 * m_minus F <> n_minus F)%nat ->
   extends n (n - n_minus F) Minus (INR m / N) (INR (m_minus F) / INR (n_minus F))) /\
  (** There are no others: these are all the intervals of Theorem 2, and over none of
      them, or in region 4 for even n, there is no orbit. *)
  (forall e g lo hi, interval n e g lo hi ->
   (e, g, lo, hi) = (Minus, Plus, 0, 1 / (2 * N)) \/
   (e, g, lo, hi) = (Plus, Plus, 1 / (2 * N), 1 / N) \/
   Nat.Odd n /\ (e, g, lo, hi) = (Plus, Minus, (N - 1) / (2 * N), 1 / 2) \/
   exists m (F : Farey m n), (0 < 2 * m < n)%nat /\
   (m_plus F <> 0%nat /\ (e, g, lo, hi) = (Plus, Plus, INR (m_plus F) / INR (n_plus F), INR m / N) \/
    (2 * m_minus F <> n_minus F)%nat /\
    (e, g, lo, hi) = (Plus, Minus, INR m / N, INR (m_minus F) / INR (n_minus F)))) /\
  (forall r s, 0 < r < 1 -> 0 < s < 1 / 2 -> u_at r s n <> 0 ->
   (forall e g lo hi, interval n e g lo hi -> ~ lo < s < hi) -> no_orbit_at r s n) /\
  (forall a1 a2, 0 < a2 < 1 -> - (a2 + 1) < a1 <= - 2 * sqrt a2 -> Nat.Even n ->
   no_orbit a1 a2 n).
