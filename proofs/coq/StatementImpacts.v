(** * Statements: formulas (61) and (64) and det D in the plane, from the linear problem (28)

    Read [Defs], [Statement] and [StatementPlane] (its last section) first. *)

From Coq Require Import Reals.
From Grazing Require Import Defs StatementPlane.
Open Scope R_scope.

(** (28) with B = (0, beta), C = (1 0): from impact j to the next in n_j steps. beta = C A B
    is K gamma in the notation of (45)-(47). *)
Definition impacts {J : Type} (next : J -> J) (n : J -> nat) (a1 a2 beta : R)
    (X : J -> R * R) (Y : J -> R) : Prop := forall j, let Z := apply (mpow (A a1 a2) (n j)) (X j) in
  fst Z = -1 /\ X (next j) = (fst Z, snd Z + beta * Y j).

(** (64): every X_j is the single-impact X of its n_j, and beta Y_j = (0 1)(X_{j+1} - A^{n_j} X_j). *)
Definition Impacts_statement : Prop := forall (J : Type) (next : J -> J) n a1 a2 beta X Y,
  (forall j, exists i, next i = j) -> (forall j, u a1 a2 (n j) <> 0) -> beta <> 0 ->
  (impacts next n a1 a2 beta X Y <-> forall j, single_impact a1 a2 (n j) (X j) /\
   Y j = (snd (X (next j)) - snd (apply (mpow (A a1 a2) (n j)) (X j))) / beta).

(** One impact, n steps: Y = c_n / beta. *)
Definition Single_impact_statement : Prop := forall a1 a2 beta n X Y, u a1 a2 n <> 0 -> beta <> 0 ->
  impacts (fun j : unit => j) (fun _ => n) a1 a2 beta (fun _ => X) (fun _ => Y) -> Y = c a1 a2 n / beta.

(** (61) is (36), - C A^n B / (2 y) with y = e mu Y, for one impact. *)
Definition Large_formula_statement : Prop := forall K gamma emu a1 a2 n X Y,
  K <> 0 -> gamma <> 0 -> emu <> 0 -> u a1 a2 n <> 0 -> 1 - v a1 a2 n + a2 ^ n <> 0 ->
  impacts (fun j : unit => j) (fun _ => n) a1 a2 (K * gamma) (fun _ => X) (fun _ => Y) ->
  - (m12 (mpow (A a1 a2) n) * (K * gamma)) / (2 * (emu * Y)) = large K gamma emu a1 a2 n.

(** The matrix D of (32) for one impact, unknowns X_1, X_2, Y: its determinant is u_n C A B. *)
Definition det3 (x1 x2 x3 y1 y2 y3 z1 z2 z3 : R) : R :=
  x1 * (y2 * z3 - y3 * z2) - x2 * (y1 * z3 - y3 * z1) + x3 * (y1 * z2 - y2 * z1).

Definition Det_D_statement : Prop := forall a1 a2 beta n, let M := mpow (A a1 a2) n in
  det3 (1 - m11 M) (- m12 M) 0
       (- m21 M) (1 - m22 M) (- beta)
       (m11 M) (m12 M) 0 = u a1 a2 n * beta.
