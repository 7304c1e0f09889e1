(** * Statement: Theorem 2's list, and what exists at rational s on r = 1, decided with integers alone

    s = x/z. [Oracle] extracts these functions as well as those of [StatementZ]. *)

From Coq Require Import Reals ZArith List Bool.
From Grazing Require Import Defs Statement.
Import ListNotations. Open Scope Z_scope.

(** An interval of s: the index that decides, the case (+, g), its two ends. *)
Definition piece : Type := (Z * sign * (Z * Z) * (Z * Z))%type.
Definition rangeZ (n : Z) : list Z := map Z.of_nat (seq 1 (Z.to_nat n - 1)).

(** The two beside m/n; k = n+ is found by search, l = m+. *)
Definition besideZ (n m : Z) : list piece := if 2 * m <? n then
  match find (fun k => (m * k) mod n =? 1) (rangeZ n) with
  | Some k => let l := m * k / n in [ (n - k, Plus, (if m =? 1 then (1, 2 * n) else (l, k)), (m, n));
                                      (k, Minus, (m, n), (m - l, n - k)) ]
  | None => [] end else [].
Definition sidesZ (n : Z) : list piece := flat_map (besideZ n) (rangeZ n).

Definition insideZ (x z : Z) (t : piece) : bool := match t with (_, _, (l1, l2), (h1, h2)) =>
  (l1 * z <? x * l2) && (x * h2 <? h1 * z) end.
Definition outsideZ (x z : Z) (t : piece) : bool := match t with (_, _, (l1, l2), (h1, h2)) =>
  (x * l2 <? l1 * z) || (h1 * z <? x * h2) end.
Definition same_sign (e g : sign) : bool :=
  match e, g with Plus, Plus | Minus, Minus => true | _, _ => false end.

(** u_n = 0 at s = x/z. *)
Definition singularZ (n x z : Z) : bool := (2 * n * x) mod z =? 0.
(** What exists at s = x/z, and whether Theorem 1 says that nothing does; L is Theorem 2's list but for the
    first. *)
Definition circleZ (n : Z) (L : list piece) (x z : Z) (e g : sign) : bool := match e with
  | Minus => same_sign g Plus && (2 * n * x <? z)
  | Plus => existsb (fun t => same_sign g (snd (fst (fst t))) && insideZ x z t) L end.
Definition no_circleZ (n : Z) (L : list piece) (x z : Z) : bool :=
  negb (singularZ n x z) && (z <? 2 * n * x) && forallb (outsideZ x z) L.

Open Scope R_scope.

Definition fraction (h : Z * Z) : R := IZR (fst h) / IZR (snd h).

Definition Sides_statement : Prop := forall n k g lo hi, (3 <= n)%nat ->
  (side n k g lo hi <-> exists h h', In (Z.of_nat k, g, h, h') (sidesZ (Z.of_nat n)) /\
   lo = fraction h /\ hi = fraction h' /\ (0 < snd h)%Z /\ (0 < snd h')%Z).

Definition Circle_statement : Prop := forall n x z, (3 <= n)%nat -> (0 < x)%Z -> (2 * x < z)%Z ->
  let s := IZR x / IZR z in let L := sidesZ (Z.of_nat n) in
  (singularZ (Z.of_nat n) x z = true <-> u_at 1 s n = 0) /\
  (forall e g, circleZ (Z.of_nat n) L x z e g = true <-> orbit_at 1 s n e g) /\
  (no_circleZ (Z.of_nat n) L x z = true -> no_orbit_at 1 s n).
