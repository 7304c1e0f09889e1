(** * Statement: certificates of kinds word and word-by-theorem, read with whole numbers alone

    For all points of a box at once: signs of u_n and of the numerators N_{n,k} come from affine forms in
    fixed point, zeros at one point from [uZ]. What the second kind lists is held against the theorems of
    [StatementWords]. *)

From Coq Require Import Reals ZArith List Bool.
From Grazing Require Import Defs Statement StatementWords StatementZ StatementCircleZ StatementReaders.
Import ListNotations. Open Scope Z_scope.

(** ** Affine forms: (v, d, d', e) is v + d x + d' y, off by e at most, for |x|, |y| <= 1, in units of 2^-W *)
Definition form : Type := (Z * Z * Z * Z)%type.
Definition sizeF (f : form) : Z := match f with (v, d, d', e) => Z.abs v + Z.abs d + Z.abs d' + e end.
Definition subF (f g : form) : form :=
  match f, g with (v, d, d', e), (w, h, h', l) => (v - w, d - h, d' - h', e + l) end.
Definition mulF (W : Z) (f g : form) : form := match f, g with (v, d, d', e), (w, h, h', l) =>
  let shift (t : Z) := Z.shiftr t W in (shift (v * w), shift (v * h + w * d), shift (v * h' + w * d'),
    shift ((Z.abs d + Z.abs d') * (Z.abs h + Z.abs h') + e * sizeF g + sizeF f * l) + 4) end.
Definition signF (f : form) : option Z := match f with (v, d, d', e) => let m := Z.abs d + Z.abs d' + e in
  if m <? v then Some 1 else if v <? - m then Some (-1) else None end.
(** What lies between two fractions, as a middle and half a width. *)
Definition middleF (W : Z) (h h' : Z * Z) : Z * Z :=
  let low := fst h * 2 ^ W / snd h in let high := - (- (fst h' * 2 ^ W) / snd h') in
  let v := (low + high) / 2 in (v, Z.max (high - v) (v - low)).

(** a1 between the first two fractions, a2 between the others. *)
Definition box : Type := ((Z * Z) * (Z * Z) * (Z * Z) * (Z * Z))%type.
Definition a1F (W : Z) (B : box) : form := match B with (h, h', _, _) => let (v, d) := middleF W h h' in
  (v, d, 0, 0) end.
Definition a2F (W : Z) (B : box) : form := match B with (_, _, h, h') => let (v, d) := middleF W h h' in
  (v, 0, d, 0) end.
Definition oneF (W : Z) : form := (2 ^ W, 0, 0, 0).
Definition zeroF : form := (0, 0, 0, 0).
(** u_n, ..., u_0 and a2^n, ..., a2^0. *)
Fixpoint uF (W : Z) (B : box) (n : nat) : list form :=
  match n with O => [zeroF] | S j => let us := uF W B j in
  (match us with f :: g :: _ => subF (mulF W (a1F W B) f) (mulF W (a2F W B) g) | _ => oneF W end) :: us end.
Fixpoint powF (W : Z) (B : box) (n : nat) : list form :=
  match n with O => [oneF W] | S j => let ps := powF W B j in
  (match ps with f :: _ => mulF W (a2F W B) f | _ => oneF W end) :: ps end.
(** The signs that are certain, from the two lists turned round. *)
Definition signU (us : list form) (n : nat) : option Z := signF (nth n us zeroF).
Definition signN (W : Z) (us ps : list form) (n k : nat) : option Z :=
  if (length ps <=? k)%nat || (length us <=? n)%nat || (n <? k)%nat then None else
  signF (subF (subF (nth n us zeroF) (nth k us zeroF)) (mulF W (nth k ps zeroF) (nth (n - k) us zeroF))).
(** u_n = 0, where the box is one point. *)
Definition vanishZ (B : box) (n : nat) : bool := match B with (h, h', l, l') =>
  sameZ h h' && sameZ l l' && (uZ (fst h * snd l) (fst l * snd h) (snd h * snd l) n =? 0) end.

(** ** Kind word: everything by its own sign *)
Inductive period := Occurs (x : letter) | Absent (k : nat) | Vanishes.
Definition isS (e : sign) (t : option Z) : bool := match t with Some t => 0 <? sgnZ e * t | None => false end.
Definition timesS (t t' : option Z) : option Z :=
  match t, t' with Some t, Some t' => Some (t * t') | _, _ => None end.
Definition flip (e : sign) : sign := match e with Plus => Minus | Minus => Plus end.

Record signs := Signs { on_u : nat -> option Z; on_N : nat -> nat -> option Z; on_zero : nat -> bool }.
Definition signsZ (W : Z) (B : box) (n : nat) : signs :=
  let us := rev (uF W B n) in let ps := rev (powF W B n) in Signs (signU us) (signN W us ps) (vanishZ B).

Definition periodZ (T : signs) (e : sign) (n : nat) (t : period) : bool := match t with
  | Occurs x => match on_u T n with Some _ => true | None => false end && (1 <=? n)%nat &&
      forallb (fun k => isS e (timesS (on_u T n) (on_N T n k))) (seq 1 (n - 1)) &&
        isS (case_of x) (on_N T (2 * n) n)
  | Absent k => (1 <=? k)%nat && (k <? n)%nat && isS (flip e) (timesS (on_u T n) (on_N T n k))
  | Vanishes => on_zero T n end.
Fixpoint occurring (n : nat) (L : list period) : list (nat * letter) := match L with [] => []
  | Occurs x :: L => (n, x) :: occurring (S n) L | _ :: L => occurring (S n) L end.
Fixpoint all2 {A B : Type} (f : A -> B -> bool) (l : list A) (l' : list B) : bool := match l, l' with
  | [], [] => true | h :: l, h' :: l' => f h h' && all2 f l l' | _, _ => false end.
(** The sign of p_j - q_i, or nothing. *)
Definition markZ (T : signs) (i j : nat * letter) (m : option sign) : bool := match m with None => true
  | Some g => isS g (timesS (on_N T (fst i + fst j) (fst i)) (timesS (on_u T (fst i)) (on_u T (fst j)))) end.

(** 0 < a2 <= 1, the ends are in order, and the denominators are positive. *)
Definition boxZ (B : box) : bool := match B with (h, h', l, l') =>
  (0 <? snd h) && (0 <? snd h') && (0 <? snd l) && (0 <? snd l') && (0 <? fst l) && negb (lessZ (1, 1) l') &&
  negb (lessZ h' h) && negb (lessZ l' l) end.
Definition wordZ (W : Z) (B : box) (e : sign) (L : list period) (rows : list (list (option sign))) : bool :=
  let T := signsZ W B (2 * length L) in let V := occurring 1 L in
  (0 <=? W) && boxZ B && all2 (periodZ T e) (seq 1 (length L)) L && all2 (fun i => all2 (markZ T i) V) V rows.

(** ** Kind word-by-theorem: the signs that the word theorem asks for, and the graph that it gives *)
Definition plus1 (h : Z * Z) : Z * Z := (fst h + snd h, snd h).
Definition minus (h : Z * Z) : Z * Z := (- fst h, snd h).
Definition square (h : Z * Z) : Z * Z := (fst h * fst h, snd h * snd h).
Definition four (h : Z * Z) : Z * Z := (4 * fst h, snd h).
(** The box lies in the paper's region 1 to 5; 34: in regions 3 and 4. *)
Definition regionZ (B : box) (k : Z) : bool := match B with (h, h', l, l') => boxZ B &&
  if k =? 1 then lessZ (plus1 l') h
  else if k =? 2 then (0 <? fst h) && negb (lessZ (square h) (four l')) && lessZ h' (plus1 l)
  else if k =? 3 then lessZ (square h) (four l) && lessZ (square h') (four l)
  else if k =? 4 then (fst h' <? 0) && negb (lessZ (square h') (four l')) && lessZ (minus h) (plus1 l)
  else if k =? 5 then lessZ (plus1 l') (minus h')
  else (k =? 34) && lessZ (minus h) (plus1 l) && ((fst h' <? 0) || lessZ (square h') (four l)) end.

Inductive ending := Ends (x : letter) | Ends_zero | Open.
Fixpoint stepsZ (T : signs) (i j : nat) (w : list letter) : option (nat * nat) :=
  match w with [] => Some (i, j)
  | D :: w => if isS Plus (on_u T (i + j)) && isS Plus (on_N T (i + j) i) then stepsZ T (i + j) j w else None
  | U :: w => if isS Minus (on_u T (i + j)) && isS Minus (on_N T (i + j) j)
    then stepsZ T i (i + j) w else None end.
Definition endZ (T : signs) (i j : nat) (z : ending) : bool := match z with
  | Ends D => isS Plus (on_u T (i + j)) && isS Minus (on_N T (i + j) i)
  | Ends U => isS Minus (on_u T (i + j)) && isS Plus (on_N T (i + j) j)
  | Ends_zero => on_zero T (i + j)
  | Open => true end.
(** Whether the edges of the last pair are told. *)
Definition toldZ (B : box) (z : ending) : bool :=
  match z with Ends _ => true | Ends_zero => lessZ (snd B) (1, 1) | Open => false end.
Definition mark_of (K : nat) (w : list letter) (told : bool) (i j : nat * letter) : option sign :=
  match i, j with
  | (_, U), (_, U) => Some Plus | (_, D), (_, D) => Some Minus
  | (i, D), (j, U) => match renewed i j 1 K w with Some U => Some Plus | Some D => Some Minus | None =>
    if told then Some Plus else None end
  | (j, U), (i, D) => match renewed i j 1 K w with Some U => Some Plus | Some D => Some Minus | None =>
    if told then Some Minus else None end
  end.
Definition same_mark (m m' : option sign) : bool := match m, m' with
  | Some g, Some g' => same_sign g g' | None, None => true | _, _ => false end.
Definition firstZ (T : signs) (K : nat) : bool := (2 <=? K)%nat && isS Minus (on_u T K) &&
  forallb (fun k => isS Plus (on_u T k) || (S k =? K)%nat && on_zero T k) (seq 1 (K - 1)).
Definition pathZ (W : Z) (B : box) (k : Z) (K last : nat) (w : list letter) (z : ending)
  (rows : list (list (option sign))) : bool := let T := signsZ W B last in let V := vertices K w in
  (0 <=? W) && ((k =? 3) || (k =? 4) && (K =? 2)%nat || (k =? 34)) && regionZ B k && firstZ T K &&
  match stepsZ T 1 K w with Some (i, j) => endZ T i j z | None => false end &&
  all2 (fun i => all2 (fun j => same_mark (mark_of K w (toldZ B z) i j)) V) V rows.
Definition belowZ (W : Z) (B : box) (k : Z) (n : nat) : bool := let T := signsZ W B (S n) in
  (0 <=? W) && ((k =? 3) || (k =? 34)) && regionZ B k && (1 <=? n)%nat &&
    forallb (fun l => isS Plus (on_u T l)) (seq 1 n) &&
  (isS Minus (on_u T (S n)) || on_zero T (S n)).
(** What is said of all periods at once: whether all occur or 1 alone, and with which letter. *)
Definition lonelyZ (B : box) (k : Z) (e : sign) : option (bool * letter) :=
  if negb (regionZ B k) then None else match e with
  | Plus => if k =? 1 then Some (true, U) else if k =? 2 then Some (false, D) else
    if k =? 5 then Some (true, D) else None
  | Minus => if k =? 1 then Some (false, U) else if k =? 2 then Some (true, D)
             else if (k =? 4) || (k =? 5) then Some (false, D) else None end.

(** ** A point given by r and s: 2 cos(2 pi s) between c and c', told by how often u_1, ..., u_n change their
    signs at a1 = c and a2 = 1, where s = m/n *)
Fixpoint turnsZ (x z : Z) (k : nat) : (Z * Z) * option Z := match k with O => ((0, 1), Some 0)
  | S j => let (hl, t) := turnsZ x z j in let (h, l) := hl in let n := x * l - z * z * h in
    ((l, n), match t with
      | Some t => if Z.sgn l * Z.sgn n =? 0 then None else Some (if Z.sgn l * Z.sgn n <? 0 then t + 1 else t)
      | None => None end) end.
Definition short (c : Z * Z) : bool := (0 <? snd c) && (fst c <? 2 * snd c) && (- (2 * snd c) <? fst c).
Definition timesF (h l : Z * Z) : Z * Z := (fst h * fst l, snd h * snd l).
Definition polarZ (r s c c' : Z * Z) : option box :=
  let changes (c : Z * Z) := snd (turnsZ (fst c) (snd c) (Z.to_nat (snd s) - 1)) in
  if (0 <? fst r) && (0 <? snd r) && (0 <? fst s) && (2 * fst s <? snd s) && short c && short c' &&
    match changes c, changes c' with Some t, Some t' => (2 * fst s <=? t) &&
      (t' + 1 <=? 2 * fst s) | _, _ => false end
  then Some (timesF r c, timesF r c', timesF r r, timesF r r) else None.

Open Scope R_scope.

Definition in_box (B : box) (a1 a2 : R) : Prop := match B with (h, h', l, l') =>
  fraction h <= a1 <= fraction h' /\ fraction l <= a2 <= fraction l' end.
(** The letter of n is the sign of p_n - q_n. *)
Definition lettered (a1 a2 : R) (n : nat) (x : letter) : Prop :=
  sgn (case_of x) * (p a1 a2 n - q a1 a2 n) > 0.
Definition period_says (a1 a2 : R) (e : sign) (n : nat) (t : period) : Prop := match t with
  | Occurs x => member a1 a2 e n /\ lettered a1 a2 n x
  | Absent k => u a1 a2 n <> 0 /\ (1 <= k <= n - 1)%nat /\ sgn e * b a1 a2 n k < 0
  | Vanishes => u a1 a2 n = 0 end.
Definition marked (a1 a2 : R) (i j : nat * letter) (m : option sign) : Prop := match m with None => True
  | Some g => sgn g * (p a1 a2 (fst j) - q a1 a2 (fst i)) > 0 end.
Definition rows_say (a1 a2 : R) (V : list (nat * letter)) (rows : list (list (option sign))) : Prop :=
  Forall2 (fun i => Forall2 (marked a1 a2 i) V) V rows.

Definition Word_reader_statement : Prop := forall W B e L rows a1 a2, wordZ W B e L rows = true ->
  in_box B a1 a2 -> Forall2 (period_says a1 a2 e) (seq 1 (length L)) L /\ rows_say a1 a2 (occurring 1 L) rows.

Definition Region_reader_statement : Prop := forall B k a1 a2, regionZ B k = true -> in_box B a1 a2 ->
  0 < a2 <= 1 /\
  (k = 1%Z /\ a2 + 1 < a1 \/ k = 2%Z /\ 2 * sqrt a2 <= a1 < a2 + 1 \/ k = 3%Z /\ a1 ^ 2 < 4 * a2 \/
   k = 4%Z /\ - (a2 + 1) < a1 <= - 2 * sqrt a2 \/ k = 5%Z /\ a1 < - (a2 + 1) \/
     k = 34%Z /\ - (a2 + 1) < a1 < 2 * sqrt a2).

Definition Path_reader_statement : Prop :=
  forall W B k K last w z rows a1 a2, pathZ W B k K last w z rows = true -> in_box B a1 a2 ->
  first_upper a1 a2 K /\ Forall (fun x => member a1 a2 Plus (fst x) /\
    lettered a1 a2 (fst x) (snd x)) (vertices K w) /\
  rows_say a1 a2 (vertices K w) rows /\ exists i j, path a1 a2 K w i j /\
  forall n, member a1 a2 Plus n -> In n (map fst (vertices K w)) \/ z = Open /\ (i + j <= n)%nat.
Definition Below_reader_statement : Prop := forall W B k n a1 a2, belowZ W B k n = true -> in_box B a1 a2 ->
  forall l,
  (member a1 a2 Minus l <-> (1 <= l <= n)%nat) /\ ((1 <= l <= n)%nat -> lettered a1 a2 l D).
Definition Lonely_reader_statement : Prop := forall B k e all x a1 a2, lonelyZ B k e = Some (all, x) ->
  in_box B a1 a2 -> forall n,
  (member a1 a2 e n <-> n = 1%nat \/ all = true /\ (1 <= n)%nat) /\ (member a1 a2 e n -> lettered a1 a2 n x).
Definition Polar_reader_statement : Prop := forall r s c c' B, polarZ r s c c' = Some B ->
  in_box B (trace (fraction r) (fraction s)) (fraction r ^ 2).
