(** * Statements: words, or which period may follow which: (64) decided for all periods

    Read [Defs], [trace] in [Statement], [single_impact] and A in [StatementPlane] first. *)

From Coq Require Import Reals List Arith.
From Grazing Require Import Defs Statement StatementPlane.
Import ListNotations. Open Scope R_scope.

(** ** Impact patterns: conditions (52) and (64) *)
(** The second coordinate just after the impact that starts a flight of n iterates and just
    before the one that ends it. Both need u_n <> 0, hence n >= 1. *)
Definition p (a1 a2 : R) (n : nat) : R := (u a1 a2 (S n) - 1) / u a1 a2 n.
Definition q (a1 a2 : R) (n : nat) : R := (a2 ^ n + a2 * u a1 a2 (n - 1)) / u a1 a2 n.
(** The flight of n iterates satisfies (52): V for e mu > 0, V- for e mu < 0. *)
Definition member (a1 a2 : R) (e : sign) (n : nat) : Prop :=
  u a1 a2 n <> 0 /\ forall k, (1 <= k <= n - 1)%nat -> sgn e * b a1 a2 n k > 0.
(** (64): j may follow i. An edge for the other sign of gamma: strictly, it may not. *)
Definition edge a1 a2 e g i j := sgn e * sgn g * (p a1 a2 j - q a1 a2 i) > 0.
(** From x through l to y; once round l. *)
Fixpoint walk {T} (E : T -> T -> Prop) (x : T) (l : list T) (y : T) : Prop :=
  match l with [] => E x y | z :: l' => E x z /\ walk E z l' y end.
Definition cyclic {T} (E : T -> T -> Prop) l := match l with [] => False | x :: l' => walk E x l' x end.
(** The pattern (n_1, ..., n_m) satisfies the conditions of Theorem 1 in the case (e, g). *)
Definition pattern a1 a2 e g l := Forall (member a1 a2 e) l /\ cyclic (edge a1 a2 e g) l.
(** X starts the flight and A^n X ends it; with one impact (64) is (53). *)
Definition Flight_statement : Prop := forall a1 a2 n, u a1 a2 n <> 0 ->
  (forall X, single_impact a1 a2 n X ->
   snd X = p a1 a2 n /\ snd (apply (mpow (A a1 a2) n) X) = q a1 a2 n) /\
  (forall e g, pattern a1 a2 e g [n] <-> orbit a1 a2 n e g).
(** I1 to I5; in I4 u_{n+k} = 0 is allowed, and the numerator is that of b_{n+k,k}. *)
Definition Identities_statement : Prop := forall a1 a2 n k,
  let u := u a1 a2 in let p := p a1 a2 in let q := q a1 a2 in let b := b a1 a2 in
  u n <> 0 -> u k <> 0 -> c a1 a2 n = p n - q n /\
  ((k <= n)%nat -> b n k = u k * (p n - p k) /\ a2 ^ k * b n (n - k)%nat = u k * (q k - q n)) /\
  p n - q k = (u (n + k)%nat - u k - a2 ^ k * u n) / (u n * u k) /\
  p n + q n - a1 = (a2 ^ n - 1) / u n.
(** Reversing time, a2 -> 1/a2, reverses every edge: a2 <= 1 is no restriction. *)
Definition Words_reversal_statement : Prop := forall a1 a2 i j,
  0 < a2 -> u a1 a2 i <> 0 -> u a1 a2 j <> 0 -> u (a1 / a2) (/ a2) i <> 0 /\
  p (a1 / a2) (/ a2) i - q (a1 / a2) (/ a2) j = (p a1 a2 j - q a1 a2 i) / a2 /\
  forall e, member (a1 / a2) (/ a2) e i <-> member a1 a2 e i.

(** ** W1: within one case every pattern exists, in every region, for every a2 > 0 *)
Definition W1_statement : Prop := forall a1 a2 e, 0 < a2 ->
  (forall i j, (i < j)%nat -> member a1 a2 e j ->
   (sgn e * u a1 a2 i > 0 -> p a1 a2 i < p a1 a2 j /\ q a1 a2 j < q a1 a2 i) /\
   (sgn e * u a1 a2 i < 0 -> p a1 a2 j < p a1 a2 i /\ q a1 a2 i < q a1 a2 j)) /\
  forall g l, l <> [] -> Forall (fun n => orbit a1 a2 n e g) l -> pattern a1 a2 e g l.

(** ** W2: one condition instead of two. Sides: below s (D) and above s (U) *)
Inductive letter := D | U.
Definition on (a1 a2 : R) (n : nat) (x : letter) : Prop :=
  match x with D => 0 < u a1 a2 n | U => u a1 a2 n < 0 end.
Definition case_of (x : letter) : sign := match x with U => Plus | D => Minus end.
Definition W2_statement : Prop := forall a1 a2, 0 < a2 <= 1 -> Rabs a1 < a2 + 1 ->
  (forall n x, on a1 a2 n x -> sgn (case_of x) * c a1 a2 n > 0) /\
  forall i j, on a1 a2 i D -> on a1 a2 j U -> p a1 a2 i < a1 / 2 < p a1 a2 j /\
  (q a1 a2 j < p a1 a2 i -> q a1 a2 i < p a1 a2 j) /\
  (p a1 a2 j < q a1 a2 i -> p a1 a2 i < q a1 a2 j).

(** ** The path and its words, regions 3 and 4. K is the first upper period. *)
Definition first_upper (a1 a2 : R) (K : nat) : Prop :=
  0 < a2 <= 1 /\ - (a2 + 1) < a1 < 2 * sqrt a2 /\
  on a1 a2 K U /\ forall k, (k < K)%nat -> 0 <= u a1 a2 k.
(** After the letters w the last lower period is i, the last upper one j; i + j is next. *)
Inductive path (a1 a2 : R) (K : nat) : list letter -> nat -> nat -> Prop :=
| path_start : path a1 a2 K [] 1 K
| path_D w i j : path a1 a2 K w i j -> on a1 a2 (i + j) D -> path a1 a2 K (w ++ [D]) (i + j) j
| path_U w i j : path a1 a2 K w i j -> on a1 a2 (i + j) U -> path a1 a2 K (w ++ [U]) i (i + j).
(** The periods, each with its side, that the letters w spell. *)
Fixpoint periods (i j : nat) (w : list letter) : list (nat * letter) :=
  match w with [] => [] | D :: w => ((i + j)%nat, D) :: periods (i + j) j w
               | U :: w => ((i + j)%nat, U) :: periods i (i + j) w end.
Definition vertices (K : nat) (w : list letter) := (1%nat, D) :: (K, U) :: periods 1 K w.
(** In region 3 it is the Stern-Brocot path to s, from 0/1 and 1/K. *)
Inductive stern (s : R) (K : nat) : list letter -> nat -> nat -> nat -> nat -> Prop :=
| stern_start : stern s K [] 0 1 1 K
| stern_D w m1 n1 m2 n2 : stern s K w m1 n1 m2 n2 -> INR (m1 + m2) < s * INR (n1 + n2) ->
    stern s K (w ++ [D]) (m1 + m2) (n1 + n2) m2 n2
| stern_U w m1 n1 m2 n2 : stern s K w m1 n1 m2 n2 -> s * INR (n1 + n2) < INR (m1 + m2) ->
    stern s K (w ++ [U]) m1 n1 (m1 + m2) (n1 + n2).
Definition Path_statement : Prop :=
  (forall a1 a2, 0 < a2 <= 1 -> - (a2 + 1) < a1 < 2 * sqrt a2 -> exists K, first_upper a1 a2 K) /\
  (forall a1 a2 K, first_upper a1 a2 K -> a1 ^ 2 >= 4 * a2 -> K = 2%nat) /\
  forall r s K, 0 < r <= 1 -> 0 < s < 1 / 2 ->
  (first_upper (trace r s) (r ^ 2) K <-> 2 * (INR K - 1) * s <= 1 < 2 * INR K * s) /\
  (first_upper (trace r s) (r ^ 2) K -> forall w n1 n2,
   path (trace r s) (r ^ 2) K w n1 n2 <-> exists m1 m2, stern s K w m1 n1 m2 n2).

(** ** W3: V is an initial piece of the path; V- is what precedes K *)
Definition W3_statement : Prop := forall a1 a2 K, first_upper a1 a2 K ->
  (forall n, member a1 a2 Minus n <-> (n < K)%nat /\ u a1 a2 n <> 0) /\
  member a1 a2 Plus 1 /\ member a1 a2 Plus K /\
  (forall n, member a1 a2 Plus n -> n = 1%nat \/ n = K \/
   exists w i j, path a1 a2 K w i j /\ n = (i + j)%nat) /\
  forall w i j, path a1 a2 K w i j -> member a1 a2 Plus (i + j) ->
  Forall (fun x => member a1 a2 Plus (fst x) /\ on a1 a2 (fst x) (snd x)) (vertices K w).

(** ** W5: the word decides. Neighbours i, j with mediant n = i + j: the edges j -> i and,
    for gamma < 0, i -> j, and where they are undecided *)
Definition W5_neighbours_statement : Prop := forall a1 a2 K w i j, first_upper a1 a2 K ->
  path a1 a2 K w i j -> let n := (i + j)%nat in let p := p a1 a2 in let q := q a1 a2 in
  (p i > q j <-> member a1 a2 Plus n /\ on a1 a2 n U) /\
  (p j < q i <-> member a1 a2 Plus n /\ on a1 a2 n D) /\
  (p i = q j <-> on a1 a2 n U /\ b a1 a2 n j = 0 \/ u a1 a2 n = 0 /\ a2 = 1) /\
  (p j = q i <-> on a1 a2 n D /\ b a1 a2 n i = 0 \/ u a1 a2 n = 0 /\ a2 = 1).
(** Which of i (lower) and j (upper) is the first to be renewed by the letters w. *)
Fixpoint renewed (i j i' j' : nat) (w : list letter) : option letter :=
  match w with [] => None | D :: w => if i' =? i then Some D else renewed i j (i' + j') j' w
               | U :: w => if j' =? j then Some U else renewed i j i' (i' + j') w end.
(** The graph of the word for e mu > 0, gamma > 0; for gamma < 0 it is the complement. *)
Definition arrow (K : nat) (w : list letter) (x y : nat * letter) : bool :=
  match x, y with (_, U), (_, U) => true | (_, D), (_, D) => false
  | (i, D), (j, U) => match renewed i j 1 K w with Some D => false | _ => true end
  | (j, U), (i, D) => match renewed i j 1 K w with Some U => true | _ => false end end.
(** The word ends after w, and no deciding quantity is zero. *)
Definition ends a1 a2 i j :=
  ~ member a1 a2 Plus (i + j) /\ p a1 a2 i <> q a1 a2 j /\ p a1 a2 j <> q a1 a2 i.
Definition W5_statement : Prop := forall a1 a2 K w i j, first_upper a1 a2 K ->
  path a1 a2 K w i j -> Forall (fun x => member a1 a2 Plus (fst x)) (vertices K w) ->
  (forall x y, In x (vertices K w) -> In y (vertices K w) ->
   ends a1 a2 i j \/ (fst x + fst y <> i + j)%nat ->
   edge a1 a2 Plus (if arrow K w x y then Plus else Minus) (fst x) (fst y)) /\
  (ends a1 a2 i j -> forall g l, pattern a1 a2 Plus g l <-> exists l', l = map fst l' /\
   incl l' (vertices K w) /\ cyclic (fun x y => (if arrow K w x y then Plus else Minus) = g) l').

(** ** W4: two impacts. The first line is twins: the pattern (i, j) and period i + j. *)
Definition W4_statement : Prop := forall a1 a2 K, first_upper a1 a2 K ->
  (forall w i j, path a1 a2 K w i j -> forall g,
   (pattern a1 a2 Plus g [i; j] <-> orbit a1 a2 (i + j) Plus g) /\
   forall k x y, In (k, x) (vertices K w) -> on a1 a2 (i + j) y -> x = y \/ k <> i /\ k <> j ->
   (pattern a1 a2 Plus g [k; (i + j)%nat] <-> member a1 a2 Plus (i + j) /\ g = case_of x)) /\
  (forall k n g, (k < n)%nat -> pattern a1 a2 Plus g [k; n] -> k = 1%nat /\ n = K \/
   exists w i j x, path a1 a2 K w i j /\ n = (i + j)%nat /\ In (k, x) (vertices K w)) /\
  forall g l, pattern a1 a2 Minus g l <->
  g = Plus /\ l <> [] /\ Forall (fun n => (n < K)%nat /\ u a1 a2 n <> 0) l.

(** ** W6: two cycles through one vertex iff two single-impact periods *)
Definition two_cycles {T} (E : T -> T -> Prop) : Prop := exists v l l', l <> l' /\
  ~ In v l /\ ~ In v l' /\ walk E v l v /\ walk E v l' v.
Definition W6_statement : Prop := forall a1 a2 e g, 0 < a2 <= 1 -> Rabs a1 <> a2 + 1 ->
  (two_cycles (fun i j => member a1 a2 e i /\ member a1 a2 e j /\ edge a1 a2 e g i j) <->
   exists i j, i <> j /\ orbit a1 a2 i e g /\ orbit a1 a2 j e g).

(** ** Regions 1, 2 and 5: one case, and everything in it *)
Definition Regions_statement : Prop := forall a1 a2 e g, 0 < a2 ->
  a2 + 1 < a1 /\ e = Plus /\ g = Plus \/
  a2 < 1 /\ 2 * sqrt a2 <= a1 < a2 + 1 /\ e = Minus /\ g = Plus \/
  a1 < - (a2 + 1) /\ e = Plus /\ g = Minus -> forall l e' g', Exists (le 2) l ->
  (pattern a1 a2 e' g' l <-> e' = e /\ g' = g /\ Forall (le 1) l).

(** ** Finitely many vertices, and where two cycles meet *)

(** With damping V is finite for e mu > 0. *)
Definition V_finite_statement : Prop := forall a1 a2 K, first_upper a1 a2 K -> a2 < 1 ->
  exists L, forall n, member a1 a2 Plus n -> (n <= L)%nat.

(** Where two cycles meet. e mu < 0, regions 3 and 4: for gamma > 0 where a1 > 0, for gamma < 0
    nowhere. e mu > 0, region 3: for gamma < 0 on the (+,-) areas of the 1/n, for gamma > 0 and
    s < 1/4 on the (+,+) areas of the 1/n (K + 1 follows K). *)
Definition cycles (a1 a2 : R) (e g : sign) : Prop :=
  two_cycles (fun i j => member a1 a2 e i /\ member a1 a2 e j /\ edge a1 a2 e g i j).
Definition Cycle_statement : Prop :=
  (forall a1 a2 K, first_upper a1 a2 K ->
   (cycles a1 a2 Minus Plus <-> 0 < a1) /\ ~ cycles a1 a2 Minus Minus) /\
  forall r s, 0 < r <= 1 -> 0 < s < 1 / 2 ->
  (cycles (trace r s) (r ^ 2) Plus Minus <->
   exists n, (3 <= n)%nat /\ 1 < INR n * s /\ INR (n - 1) * s < 1 /\ b_at r s n 1 > 0) /\
  forall K, 2 * (INR K - 1) * s <= 1 < 2 * INR K * s -> s < 1 / 4 ->
  (cycles (trace r s) (r ^ 2) Plus Plus <-> b_at r s (K + 1) K > 0).
