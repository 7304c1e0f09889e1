(** * Statement: worked instances, with numbers found by hand: n = 8, and five of [StatementWords] *)

From Coq Require Import Reals List Arith.
From Grazing Require Import Defs Statement StatementWords.
Import ListNotations. Open Scope R_scope.

(** ** Theorem 2 for n = 8: the five intervals of the paper's figure 5 *)

Definition period_8_interval (e g : sign) (s : R) : Prop :=
  match e, g with
  | Minus, Plus => 0 < s < 1 / 16
  | Plus, Plus => 1 / 16 < s < 1 / 8 \/ 1 / 3 < s < 3 / 8
  | Plus, Minus => 1 / 8 < s < 1 / 7 \/ 3 / 8 < s < 2 / 5
  | Minus, Minus => False
  end.

Definition Period_8_statement : Prop := forall s e g, 0 < s < 1 / 2 ->
  (orbit_at 1 s 8 e g <-> period_8_interval e g s).

(** ** The pattern (1, 2) on r = 1, where twins fail: s = 1/5 *)

(** a1 = 0, -1 are s = 1/4, 1/3. At s = 1/5 period 3 has its orbit in (+,+), while (1, 2)
    has one in (-,+) only: its parts 1 and 2 do not coexist for e mu > 0. *)
Definition Pattern_1_2_statement : Prop :=
  (forall a1 e g, -2 < a1 < 2 -> (pattern a1 1 e g [1; 2]%nat <->
   0 < a1 /\ e = Minus /\ g = Plus \/ -1 < a1 < 0 /\ e = Plus /\ g = Plus \/
   a1 < -1 /\ e = Plus /\ g = Minus)) /\
  forall e g, (pattern (trace 1 (1 / 5)) 1 e g [1; 2]%nat <-> e = Minus /\ g = Plus) /\
              (orbit (trace 1 (1 / 5)) 1 3 e g <-> e = Plus /\ g = Plus).

(** ** The paper's oscillators, d = 0.6: w = 4.8 has s = 1/6, w = 4.9 has s = 8/49 *)

(** u_3 = 0; for e mu < 0 the periods 1 and 2 in any order, for e mu > 0 period 4. *)
Definition Resonance_statement : Prop := forall r, 0 < r <= 1 ->
  (forall l, pattern (trace r (1 / 6)) (r ^ 2) Minus Plus l <->
             l <> [] /\ Forall (fun n => n = 1%nat \/ n = 2%nat) l) /\
  forall g, pattern (trace r (1 / 6)) (r ^ 2) Plus g [4%nat] <-> g = Plus.
(** For e mu < 0 every word in 1, 2, 3, and no orbit at all if gamma < 0. *)
Definition Oscillator_statement : Prop := forall r l, 0 < r <= 1 ->
  ~ pattern (trace r (8 / 49)) (r ^ 2) Minus Minus l /\
  (pattern (trace r (8 / 49)) (r ^ 2) Minus Plus l <->
   l <> [] /\ Forall (fun n => 1 <= n <= 3)%nat l).

(** ** A point with five periods: K = 2 and the word U, D, D *)

Definition five_edges : list (nat * nat) :=
  [ (2, 2); (2, 3); (3, 2); (3, 3); (1, 2); (2, 1); (4, 2); (2, 4); (7, 2); (2, 7); (7, 3) ]%nat.
Definition five : list nat := [1; 2; 3; 4; 7]%nat.
Definition Five_periods_statement : Prop :=
  (forall n, member (-2 / 3) (8 / 9) Plus n <-> In n five) /\
  forall i j, In i five -> In j five ->
  (In (i, j) five_edges -> edge (-2 / 3) (8 / 9) Plus Plus i j) /\
  (~ In (i, j) five_edges -> edge (-2 / 3) (8 / 9) Plus Minus i j).

(** ** Undecided: on b_{3,2} = 0 one edge, where u_3 = 0 none if a2 < 1 and two if a2 = 1 *)

Definition Boundary_statement : Prop :=
  (b (-1 / 2) (1 / 2) 3 2 = 0 /\ u (-1 / 2) (1 / 2) 3 < 0 /\
   p (-1 / 2) (1 / 2) 1 = q (-1 / 2) (1 / 2) 2 /\ edge (-1 / 2) (1 / 2) Plus Plus 1 2) /\
  (u (-1 / 2) (1 / 4) 3 = 0 /\ edge (-1 / 2) (1 / 4) Plus Plus 1 2 /\
   edge (-1 / 2) (1 / 4) Plus Minus 2 1) /\
  (u (-1) 1 3 = 0 /\ p (-1) 1 1 = q (-1) 1 2 /\ p (-1) 1 2 = q (-1) 1 1).
