(** * Statement: certificates of kinds theorem2, word and word-by-theorem, read with integers alone

    What the lines of a certificate say is true where the reader takes them. [Oracle] extracts the readers,
    reader.ml parses the files, and `cargo test --test coq` holds their verdicts against the checker's. *)

From Coq Require Import Reals ZArith List Bool.
From Grazing Require Import Defs Statement StatementWords StatementZ StatementCircleZ.
Import ListNotations. Open Scope Z_scope.

(** ** Kind theorem2: one period on r = 1. A fraction h is fst h / snd h. *)
Inductive claim :=
| Orbit (h h' : Z * Z) (e g : sign)
| Opposite (h h' : Z * Z) (k k' : Z)
| Singular (h : Z * Z)
| Boundary (h : Z * Z) (k : Z)
| Excluded (h : Z * Z) (k k' : Z).

Definition floorZ (j : Z) (h : Z * Z) : Z := j * fst h / snd h.
Definition wholeZ (j : Z) (h : Z * Z) : bool := (j * fst h) mod snd h =? 0.
(** No whole number lies between j h and j h'. *)
Definition clearZ (h h' : Z * Z) (j : Z) : bool := j * fst h' <=? (floorZ j h + 1) * snd h'.
(** Whether cos(n pi s) and b_{n,k} are negative right of s = h, or at h. *)
Definition cosineZ (n : Z) (h : Z * Z) : bool := Z.odd ((floorZ (2 * n) h + 1) / 2).
Definition negativeZ (n : Z) (h : Z * Z) (k : Z) : bool :=
  negb (xorb (xorb (Z.odd (floorZ k h)) (Z.odd (floorZ (n - k) h))) (cosineZ n h)).
Definition plusZ (e : sign) : bool := match e with Plus => true | Minus => false end.
Definition indexZ (n k : Z) : bool := (1 <=? k) && (k <? n).
Definition oppositeZ (n : Z) (h : Z * Z) (k k' : Z) : bool :=
  indexZ n k && indexZ n k' && negb (negativeZ n h k) && negativeZ n h k'.

Definition claimZ (n : Z) (t : claim) : bool := match t with
  | Orbit h h' e g => clearZ h h' (2 * n) && forallb (clearZ h h') (rangeZ n) &&
      forallb (fun k => xorb (plusZ e) (negativeZ n h k)) (rangeZ n) &&
      Bool.eqb (xorb (plusZ e) (plusZ g)) (negb (xorb (Z.odd (floorZ (2 * n) h / 2)) (cosineZ n h)))
  | Opposite h h' k k' => clearZ h h' (2 * n) && forallb (clearZ h h') [k; n - k; k'; n - k'] &&
    oppositeZ n h k k'
  | Singular h => wholeZ (2 * n) h
  | Boundary h k => negb (wholeZ (2 * n) h) && indexZ n k && (wholeZ k h || wholeZ (n - k) h) &&
      (forallb (fun k => wholeZ k h || wholeZ (n - k) h || negativeZ n h k) (rangeZ n) ||
       forallb (fun k => wholeZ k h || wholeZ (n - k) h || negb (negativeZ n h k)) (rangeZ n))
  | Excluded h k k' => negb (wholeZ (2 * n) h) &&
    forallb (fun j => negb (wholeZ j h)) [k; n - k; k'; n - k'] && oppositeZ n h k k' end.

(** The claims tile (reached, 1/2): an interval, the point that ends it, the next interval. *)
Definition sameZ (h h' : Z * Z) : bool := (fst h =? fst h') && (snd h =? snd h').
Definition lessZ (h h' : Z * Z) : bool := fst h * snd h' <? fst h' * snd h.
Fixpoint tileZ (reached : Z * Z) (point : bool) (L : list claim) : bool := match L with
  | [] => point && sameZ reached (1, 2)
  | Orbit h h' _ _ :: L | Opposite h h' _ _ :: L => negb point && sameZ h reached && (0 <? snd h) &&
    (0 <? snd h') && lessZ h h' && negb (lessZ (1, 2) h') && tileZ h' true L
  | Singular h :: L | Boundary h _ :: L | Excluded h _ _ :: L => point && sameZ h reached && lessZ h (1, 2) &&
    tileZ reached false L
  end.
(** The intervals with an orbit are all of Theorem 2's. *)
Definition isZ (h h' : Z * Z) (e g : sign) (t : claim) : bool := match t with
  | Orbit l l' e' g' => sameZ h l && sameZ h' l' && Bool.eqb (plusZ e) (plusZ e') &&
    Bool.eqb (plusZ g) (plusZ g')
  | _ => false end.
Definition listedZ (n : Z) (L : list claim) : bool := let sides := sidesZ n in
  existsb (isZ (0, 1) (1, 2 * n) Minus Plus) L &&
  forallb (fun s : piece => match s with (_, g, h, h') => existsb (isZ h h' Plus g) L end) sides &&
  forallb (fun t => match t with
    | Orbit h h' Minus g => isZ (0, 1) (1, 2 * n) Minus Plus t
    | Orbit _ _ Plus _ => existsb (fun s : piece => match s with (_, g, h, h') => isZ h h' Plus g t end) sides
    | _ => true end) L.
Definition blockZ (n : Z) (L : list claim) : bool :=
  if n =? 1 then match L with
    | [Orbit (0, 1) (1, 2) Plus Minus; Orbit (0, 1) (1, 2) Minus Plus] => true | _ => false end
  else tileZ (0, 1) false L && forallb (claimZ n) L && ((n <? 3) || listedZ n L).

Open Scope R_scope.

(** s is where the claim speaks, and what it says there. *)
Definition there (t : claim) (s : R) : Prop := match t with
  | Orbit h h' _ _ | Opposite h h' _ _ => fraction h < s < fraction h'
  | Singular h | Boundary h _ | Excluded h _ _ => s = fraction h end.
Definition opposite (n : nat) (s : R) (k k' : Z) : Prop := u_at 1 s n <> 0 /\
  (1 <= k <= Z.of_nat n - 1)%Z /\ (1 <= k' <= Z.of_nat n - 1)%Z /\ b_at 1 s n (Z.to_nat k) > 0 /\
    b_at 1 s n (Z.to_nat k') < 0.
Definition says (n : nat) (s : R) (t : claim) : Prop := match t with
  | Orbit _ _ e g => orbit_at 1 s n e g
  | Opposite _ _ k k' | Excluded _ k k' => opposite n s k k'
  | Singular _ => u_at 1 s n = 0
  | Boundary _ k => u_at 1 s n <> 0 /\ (1 <= k <= Z.of_nat n - 1)%Z /\ b_at 1 s n (Z.to_nat k) = 0 /\
      forall j l, (1 <= j <= n - 1)%nat -> (1 <= l <= n - 1)%nat ->
        ~ (b_at 1 s n j < 0 /\ b_at 1 s n l > 0) end.

(** Every s in (0, 1/2) is spoken of, what is said is so, and the intervals with an orbit are Theorem 2's. *)
Definition Circle_reader_statement : Prop := forall n L, (1 <= n)%nat -> blockZ (Z.of_nat n) L = true ->
  (forall s, 0 < s < 1 / 2 -> (exists t, In t L /\ there t s) /\ forall t, In t L -> there t s ->
    says n s t) /\
  ((3 <= n)%nat -> forall e g lo hi, interval n e g lo hi <->
   exists h h', In (Orbit h h' e g) L /\ lo = fraction h /\ hi = fraction h').
