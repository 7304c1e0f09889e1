(** * Statements: Theorem 2 and Conjecture 1, for all n

    Read [Defs] first; nothing else is needed. The orbits are those of period n
    with a single impact, s lies in (0, 1/2), m is the integer nearest to n s. *)

From Coq Require Import Reals List Arith.
From Grazing Require Import Defs.
Open Scope R_scope.

(** ** Region 3: complex eigenvalues r exp(+- 2 pi i s), 0 < r <= 1 *)
Definition trace (r s : R) : R := 2 * r * cos (2 * PI * s).
Definition b_at (r s : R) (n k : nat) : R := b (trace r s) (r ^ 2) n k.
Definition c_at (r s : R) (n : nat) : R := c (trace r s) (r ^ 2) n.
Definition orbit_at (r s : R) (n : nat) := orbit (trace r s) (r ^ 2) n.

(** A point of the disc where period n is decided, and m is nearest to n s. *)
Definition cell (r s : R) (n m : nat) : Prop :=
  0 < r <= 1 /\ 0 < s < 1 / 2 /\ u (trace r s) (r ^ 2) n <> 0 /\
  Rabs (INR n * s - INR m) < 1 / 2.

Definition all_b (P : R -> Prop) (r s : R) (n : nat) : Prop :=
  forall k, (1 <= k <= n - 1)%nat -> P (b_at r s n k).

(** The orbit exists in the case (e, g) if P holds, and in no other case. *)
Definition exists_iff (a1 a2 : R) (n : nat) (e g : sign) (P : Prop) : Prop :=
  forall e' g', orbit a1 a2 n e' g' <-> e' = e /\ g' = g /\ P.

(** m+/n+ < m/n < m-/n- are the neighbours of m/n:
    m n+ - m+ n = 1, m n- - m- n = -1, 0 < n+, n- < n. *)
Definition neighbours (m n mp np mm nm : nat) : Prop :=
  (0 < np < n)%nat /\ (m * np = mp * n + 1)%nat /\
  (0 < nm < n)%nat /\ (m * nm + 1 = mm * n)%nat.

Definition Neighbours_statement : Prop := forall m n,
  (2 <= n)%nat -> Nat.gcd m n = 1%nat -> exists mp np mm nm,
  neighbours m n mp np mm nm /\ (mp + mm = m)%nat /\ (np + nm = n)%nat /\
  forall mp' np' mm' nm', neighbours m n mp' np' mm' nm' ->
  (mp', np', mm', nm') = (mp, np, mm, nm).

Definition S1_statement : Prop := forall r s n,
  (2 <= n)%nat -> cell r s n 0 ->
  all_b (fun x => x < 0) r s n /\ c_at r s n < 0 /\
  exists_iff (trace r s) (r ^ 2) n Minus Plus True.

Definition S2_statement : Prop := forall r s n m,
  (2 <= n)%nat -> (1 <= m)%nat -> cell r s n m ->
  (exists k, (1 <= k <= n - 1)%nat /\ b_at r s n k > 0) /\
  (Nat.gcd m n <> 1%nat -> no_orbit (trace r s) (r ^ 2) n).

(** Index d decides, in the case (+, g); two b do not vanish together if r < 1. *)
Definition decides (r s : R) (n d : nat) (g : sign) : Prop :=
  (all_b (fun x => x > 0) r s n <-> b_at r s n d > 0) /\
  exists_iff (trace r s) (r ^ 2) n Plus g (b_at r s n d > 0) /\
  (b_at r s n d < 0 -> no_orbit (trace r s) (r ^ 2) n) /\
  (b_at r s n d = 0 -> r < 1 ->
   forall k, (1 <= k <= n - 1)%nat -> k <> d -> b_at r s n k > 0).

Definition S3_statement : Prop := forall r s n m mp np mm nm,
  (2 <= n)%nat -> (1 <= m)%nat -> neighbours m n mp np mm nm -> cell r s n m ->
  (INR n * s < INR m -> c_at r s n > 0 /\ decides r s n nm Plus) /\
  (INR n * s > INR m -> c_at r s n < 0 /\ decides r s n np Minus).

(** ** Theorem 2's intervals of s, each with its case (sign e mu, sign gamma) *)

Inductive interval (n : nat) : sign -> sign -> R -> R -> Prop :=
| first : interval n Minus Plus 0 (1 / (2 * INR n))
| left_of m mp np mm nm : (0 < 2 * m < n)%nat -> neighbours m n mp np mm nm ->
    interval n Plus Plus
      (if (m =? 1)%nat then 1 / (2 * INR n) else INR mp / INR np) (INR m / INR n)
| right_of m mp np mm nm : (0 < 2 * m < n)%nat -> neighbours m n mp np mm nm ->
    interval n Plus Minus (INR m / INR n) (INR mm / INR nm).

Definition Theorem2_statement : Prop := forall n s e g,
  (3 <= n)%nat -> 0 < s < 1 / 2 ->
  (orbit_at 1 s n e g <-> exists lo hi, interval n e g lo hi /\ lo < s < hi).

Definition phi (n : nat) : nat :=
  length (filter (fun k => Nat.gcd k n =? 1)%nat (seq 1 n)).

Definition Theorem2_count_statement : Prop := forall n, (3 <= n)%nat ->
  exists L : list (sign * sign * R * R),
  length L = (phi n + 1)%nat /\ NoDup L /\
  (forall e g lo hi, In (e, g, lo, hi) L <-> interval n e g lo hi) /\
  (forall e g lo hi, interval n e g lo hi -> 0 <= lo < hi /\ hi <= 1 / 2) /\
  (forall e g lo hi e' g' lo' hi', interval n e g lo hi -> interval n e' g' lo' hi' ->
   (e, g, lo, hi) = (e', g', lo', hi') \/ hi <= lo' \/ hi' <= lo).

(** Neighbours at some stage of the Farey tree that grows from 0/1 and 1/2. *)
Inductive adjacent : nat -> nat -> nat -> nat -> Prop :=
| root : adjacent 0 1 1 2
| insert_left m1 n1 m2 n2 : adjacent m1 n1 m2 n2 -> adjacent m1 n1 (m1 + m2) (n1 + n2)
| insert_right m1 n1 m2 n2 : adjacent m1 n1 m2 n2 -> adjacent (m1 + m2) (n1 + n2) m2 n2.

(** Inserting the mediant m/n gives exactly the neighbours used above. *)
Definition Theorem2_tree_statement : Prop := forall m n mp np mm nm,
  (0 < 2 * m < n)%nat /\ neighbours m n mp np mm nm <->
  adjacent mp np mm nm /\ m = (mp + mm)%nat /\ n = (np + nm)%nat.

(** ** Conjecture 1 in region 3: each area is the set above a graph *)

(** For s in the interval and 0 < r <= 1 the orbit exists iff Rad s < r. *)
Definition radius (n : nat) (e g : sign) (lo hi : R) (Rad : R -> R) : Prop :=
  forall s, lo < s < hi -> 0 <= Rad s < 1 /\
  forall r, 0 < r <= 1 -> exists_iff (trace r s) (r ^ 2) n e g (Rad s < r).

Definition S4_statement : Prop := forall n, (3 <= n)%nat ->
  (forall e g lo hi, interval n e g lo hi -> exists Rad,
   radius n e g lo hi Rad /\ (e = Minus -> forall s, Rad s = 0)) /\
  (forall s, 0 < s < 1 / 2 ->
   (forall e g lo hi, interval n e g lo hi -> ~ lo < s < hi) ->
   forall r e g, 0 < r <= 1 -> ~ orbit_at r s n e g).

(** Rad is continuous; it tends to 1 at each end but two: at 1/(2n), where it
    is 0 on (1/(2n), 1/(2(n-1))], and at 1/2, where region 4 continues. *)
Definition S4_graph_statement : Prop := forall n g lo hi Rad, (3 <= n)%nat ->
  interval n Plus g lo hi -> radius n Plus g lo hi Rad ->
  (forall s, lo < s < hi -> continuity_pt Rad s) /\
  (forall x, x < 1 -> hi <> 1 / 2 -> exists d, d > 0 /\
   forall s, lo < s < hi -> hi - d < s -> x < Rad s) /\
  (forall x, x < 1 -> lo <> 1 / (2 * INR n) -> exists d, d > 0 /\
   forall s, lo < s < hi -> s < lo + d -> x < Rad s) /\
  (lo = 1 / (2 * INR n) ->
   forall s, lo < s < hi -> s <= 1 / (2 * (INR n - 1)) -> Rad s = 0).

(** For fixed r the s of one area form one interval (empty if hi' <= lo'). *)
Definition S4_section_statement : Prop := forall n e g lo hi r, (3 <= n)%nat ->
  interval n e g lo hi -> 0 < r < 1 -> exists lo' hi', lo <= lo' /\ hi' <= hi /\
  (lo = 1 / (2 * INR n) -> lo' = lo /\ lo < hi') /\
  forall s, lo < s < hi -> (orbit_at r s n e g <-> lo' < s < hi').

(** ** Region 4: -1 < lambda1 <= lambda2 < 0 *)

Definition S5_statement : Prop := forall a1 a2 n,
  0 < a2 < 1 -> - (a2 + 1) < a1 <= - 2 * sqrt a2 ->
  (n = 2%nat -> exists_iff a1 a2 n Plus Plus True) /\
  ((4 <= n)%nat -> Nat.Even n -> no_orbit a1 a2 n) /\
  ((3 <= n)%nat -> Nat.Odd n ->
   exists_iff a1 a2 n Plus Minus (b a1 a2 n (n - 2) > 0) /\ c a1 a2 n < 0 /\
   (b a1 a2 n (n - 2) < 0 -> no_orbit a1 a2 n) /\
   (b a1 a2 n (n - 2) = 0 -> forall k,
    (1 <= k <= n - 1)%nat -> k <> (n - 2)%nat -> b a1 a2 n k > 0)).

(** The area of n odd at s = 1/2: regions 3 and 4 at a fixed determinant. *)
Definition S5_section_statement : Prop := forall a2 n, 0 < a2 < 1 ->
  (3 <= n)%nat -> Nat.Odd n -> exists a1s,
  - (a2 + 1) < a1s < trace (sqrt a2) ((1 - 1 / INR n) / 2) /\
  b a1s a2 n (n - 2) = 0 /\
  forall a1, - (a2 + 1) < a1 < trace (sqrt a2) ((1 - 1 / INR n) / 2) ->
  (orbit a1 a2 n Plus Minus <-> a1 < a1s).
