(** * Statements for region 3 and region 4: S1-S5 and Theorem 2, for all n

    Read [Defs] first; nothing else is needed. The orbits are those of period n
    with a single impact, s lies in (0, 1/2), m is the integer nearest to n s. *)

From Coq Require Import Reals List Arith.
From Grazing Require Import Defs.
Open Scope R_scope.

(** ** At most one case, and not both [orbit] and [no_orbit] *)

Definition One_case_statement : Prop := forall a1 a2 n e g, (2 <= n)%nat ->
  orbit a1 a2 n e g ->
  ~ no_orbit a1 a2 n /\ forall e' g', orbit a1 a2 n e' g' -> e' = e /\ g' = g.

(** ** Region 3: complex eigenvalues r exp(+- 2 pi i s), 0 < r <= 1 *)

Definition trace (r s : R) : R := 2 * r * cos (2 * PI * s).
Definition u_at (r s : R) (n : nat) : R := u (trace r s) (r ^ 2) n.
Definition b_at (r s : R) (n k : nat) : R := b (trace r s) (r ^ 2) n k.
Definition c_at (r s : R) (n : nat) : R := c (trace r s) (r ^ 2) n.
Definition orbit_at (r s : R) (n : nat) := orbit (trace r s) (r ^ 2) n.
Definition no_orbit_at (r s : R) (n : nat) := no_orbit (trace r s) (r ^ 2) n.

(** A point of the disc where period n is decided, and m is nearest to n s. *)
Definition cell (r s : R) (n m : nat) : Prop :=
  0 < r <= 1 /\ 0 < s < 1 / 2 /\ u (trace r s) (r ^ 2) n <> 0 /\
  Rabs (INR n * s - INR m) < 1 / 2.

(** m+/n+ < m/n < m-/n- are the neighbours of m/n:
    m n+ - m+ n = 1, m n- - m- n = -1, 0 < n+, n- < n. *)
Definition neighbours (m n mp np mm nm : nat) : Prop :=
  (0 < np < n)%nat /\ (m * np = mp * n + 1)%nat /\
  (0 < nm < n)%nat /\ (m * nm + 1 = mm * n)%nat.

(** The same by name. *)
Record Farey (m n : nat) := {
  m_plus : nat; n_plus : nat; m_minus : nat; n_minus : nat;
  are_neighbours : neighbours m n m_plus n_plus m_minus n_minus }.
Arguments m_plus {m n}.
Arguments n_plus {m n}.
Arguments m_minus {m n}.
Arguments n_minus {m n}.
Arguments are_neighbours {m n}.

Definition Neighbours_statement : Prop := forall m n,
  (2 <= n)%nat -> Nat.gcd m n = 1%nat -> exists F : Farey m n,
  (m_plus F + m_minus F)%nat = m /\ (n_plus F + n_minus F)%nat = n /\
  forall F' : Farey m n, m_plus F' = m_plus F /\ n_plus F' = n_plus F /\
    m_minus F' = m_minus F /\ n_minus F' = n_minus F.

(** All b_{n,k} < 0 and c_n < 0. *)
Definition S1_statement : Prop := forall r s n,
  (2 <= n)%nat -> cell r s n 0 -> orbit_at r s n Minus Plus.

Definition S2_statement : Prop := forall r s n m,
  (2 <= n)%nat -> (1 <= m)%nat -> cell r s n m ->
  (exists k, (1 <= k <= n - 1)%nat /\ b_at r s n k > 0) /\
  (Nat.gcd m n <> 1%nat -> no_orbit_at r s n).

(** The sign of b_{n,d} decides, in the case (+, g); if it vanishes, the other b_{n,k}
    do not, a2 < 1: active boundaries do not cross. *)
Record decides (a1 a2 : R) (n d : nat) (g : sign) : Prop := {
  sign_of_c : sgn g * c a1 a2 n > 0;
  deciding : (1 <= d <= n - 1)%nat;
  if_positive : b a1 a2 n d > 0 -> orbit a1 a2 n Plus g;
  if_negative : b a1 a2 n d < 0 -> no_orbit a1 a2 n;
  if_zero : b a1 a2 n d = 0 -> a2 < 1 -> forall k, (1 <= k <= n - 1)%nat -> k <> d -> b a1 a2 n k > 0 }.

Definition S3_statement : Prop := forall r s n m (F : Farey m n),
  (2 <= n)%nat -> (1 <= m)%nat -> cell r s n m ->
  (INR n * s < INR m -> decides (trace r s) (r ^ 2) n (n_minus F) Plus) /\
  (INR n * s > INR m -> decides (trace r s) (r ^ 2) n (n_plus F) Minus).

(** ** Theorem 2's intervals of s *)

(** The two at m/n: its ends, its case (+, g) and the index that decides on it. *)
Inductive side (n : nat) : nat -> sign -> R -> R -> Prop :=
| left_side m (F : Farey m n) : (0 < 2 * m < n)%nat -> side n (n_minus F) Plus
    (if (m =? 1)%nat then 1 / (2 * INR n) else INR (m_plus F) / INR (n_plus F)) (INR m / INR n)
| right_side m (F : Farey m n) : (0 < 2 * m < n)%nat -> side n (n_plus F) Minus
    (INR m / INR n) (INR (m_minus F) / INR (n_minus F)).

(** All of them, each with its case (sign e mu, sign gamma). *)
Inductive interval (n : nat) : sign -> sign -> R -> R -> Prop :=
| first : interval n Minus Plus 0 (1 / (2 * INR n))
| beside k g lo hi : side n k g lo hi -> interval n Plus g lo hi.

(** On the closure of none: at an end, u_n = 0 or the deciding b_{n,k} = 0. *)
Definition outside (n : nat) (s : R) : Prop :=
  forall e g lo hi, interval n e g lo hi -> s < lo \/ hi < s.

Definition Theorem2_statement : Prop := forall n s, (3 <= n)%nat -> 0 < s < 1 / 2 ->
  (forall e g, orbit_at 1 s n e g <-> exists lo hi, interval n e g lo hi /\ lo < s < hi) /\
  (outside n s -> u_at 1 s n <> 0 -> no_orbit_at 1 s n).

Definition phi (n : nat) : nat :=
  length (filter (fun k => Nat.gcd k n =? 1)%nat (seq 1 n)).

Definition Theorem2_count_statement : Prop := forall n, (3 <= n)%nat ->
  exists L : list (sign * sign * R * R),
  length L = (phi n + 1)%nat /\ NoDup L /\
  (forall e g lo hi, In (e, g, lo, hi) L <-> interval n e g lo hi) /\
  (forall e g lo hi, interval n e g lo hi -> 0 <= lo < hi /\ hi <= 1 / 2) /\
  (forall e g lo hi e' g' lo' hi', interval n e g lo hi -> interval n e' g' lo' hi' ->
   (e, g, lo, hi) = (e', g', lo', hi') \/ hi <= lo' \/ hi' <= lo).

(** One deciding index for each interval but the first, and each k prime to n once. *)
Definition Deciding_indices_statement : Prop := forall n, (3 <= n)%nat ->
  (forall k, (1 <= k <= n - 1)%nat /\ Nat.gcd k n = 1%nat <->
             exists g lo hi, side n k g lo hi) /\
  (forall k g lo hi k' g' lo' hi', side n k g lo hi -> side n k' g' lo' hi' ->
   (k = k' <-> (g, lo, hi) = (g', lo', hi'))).

(** Neighbours at some stage of the Farey tree that grows from 0/1 and 1/2. *)
Inductive adjacent : nat -> nat -> nat -> nat -> Prop :=
| root : adjacent 0 1 1 2
| insert_left m1 n1 m2 n2 : adjacent m1 n1 m2 n2 -> adjacent m1 n1 (m1 + m2) (n1 + n2)
| insert_right m1 n1 m2 n2 : adjacent m1 n1 m2 n2 -> adjacent (m1 + m2) (n1 + n2) m2 n2.

(** Inserting the mediant m/n gives exactly the neighbours used above. *)
Definition Theorem2_tree_statement : Prop := forall m n mp np mm nm,
  (0 < 2 * m < n)%nat /\ neighbours m n mp np mm nm <->
  adjacent mp np mm nm /\ m = (mp + mm)%nat /\ n = (np + nm)%nat.

(** ** S4: each area of region 3 is what lies above a graph *)

(** Above the graph of Rad the orbit exists, on it b_{n,k} = 0 and the other b are > 0,
    below it b_{n,k} < 0 and there is no orbit. *)
Record decided (n k : nat) (g : sign) (x r s : R) : Prop := {
  not_singular : u_at r s n <> 0;
  above_it : x < r <-> orbit_at r s n Plus g;
  on_it : x = r <-> b_at r s n k = 0;
  below_it : r < x <-> b_at r s n k < 0;
  none_below : r < x -> no_orbit_at r s n;
  alone : x = r -> forall j, (1 <= j <= n - 1)%nat -> j <> k -> b_at r s n j > 0 }.
Definition above (n k : nat) (g : sign) (lo hi : R) (Rad : R -> R) : Prop := forall s, lo < s < hi ->
  0 <= Rad s < 1 /\ continuity_pt Rad s /\ forall r, 0 < r <= 1 -> decided n k g (Rad s) r s.

(** Rad s tends to 1 as s in (lo, hi) tends to x0. *)
Definition tends_to_1 (Rad : R -> R) (lo hi x0 : R) : Prop := forall x, x < 1 ->
  exists d, d > 0 /\ forall s, lo < s < hi -> Rabs (s - x0) < d -> x < Rad s.

Definition S4_statement : Prop := forall n, (3 <= n)%nat ->
  (forall r s, 0 < r <= 1 -> 0 < s < 1 / (2 * INR n) -> orbit_at r s n Minus Plus) /\
  (forall k g lo hi, side n k g lo hi -> exists Rad, above n k g lo hi Rad) /\
  (forall r s, 0 < r <= 1 -> 0 < s < 1 / 2 -> u_at r s n <> 0 ->
   (forall e g lo hi, interval n e g lo hi -> ~ lo < s < hi) ->
   r < 1 \/ outside n s -> no_orbit_at r s n).

(** Rad tends to 1 at each end but two: at 1/(2n), where it is 0 on
    (1/(2n), 1/(2(n-1))], and at 1/2, where region 4 continues. *)
Definition S4_ends_statement : Prop := forall n k g lo hi Rad, (3 <= n)%nat ->
  side n k g lo hi -> above n k g lo hi Rad ->
  (lo <> 1 / (2 * INR n) -> tends_to_1 Rad lo hi lo) /\
  (hi <> 1 / 2 -> tends_to_1 Rad lo hi hi) /\
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
  (n = 2%nat -> orbit a1 a2 n Plus Plus) /\
  ((4 <= n)%nat -> Nat.Even n -> no_orbit a1 a2 n) /\
  ((3 <= n)%nat -> Nat.Odd n -> u a1 a2 n <> 0 /\ decides a1 a2 n (n - 2) Minus).

(** The area of n odd at s = 1/2: regions 3 and 4 at a fixed determinant. *)
Definition S5_section_statement : Prop := forall a2 n, 0 < a2 < 1 ->
  (3 <= n)%nat -> Nat.Odd n -> exists a1s,
  - (a2 + 1) < a1s < trace (sqrt a2) ((1 - 1 / INR n) / 2) /\
  forall a1, - (a2 + 1) < a1 < trace (sqrt a2) ((1 - 1 / INR n) / 2) ->
  u a1 a2 n <> 0 /\ decides a1 a2 n (n - 2) Minus /\
  (a1 < a1s <-> b a1 a2 n (n - 2) > 0) /\ (a1 = a1s <-> b a1 a2 n (n - 2) = 0).

(** ** Depth (not in the paper): how far down each area reaches at least *)

Definition Depth_statement : Prop := forall n k g lo hi Rad, (3 <= n)%nat ->
  side n k g lo hi -> above n k g lo hi Rad ->
  exists s, lo < s < hi /\ Rad s < 1 - 4 / (PI * INR n ^ 3).
