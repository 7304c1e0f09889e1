(** * The conditions H0, E1 to E3, H4 and the links of docs/ranges.md in integers: a function from
  certificates to yes and no *)

From Coq Require Import QArith ZArith Bool List.
From Grazing Require Import StatementPaths StatementRanges ChaosInterval ChaosFunctions PathsCheck.
Import ListNotations.

(** An edge with its impacts, and the impact in the middle of them. *)
Record station : Type := { edge : (nat * nat) * Edge.t; whole : impact; centre : impact }.
(** A leg between two edges: H0, the velocities a and p in the middle and in general, minus their derivatives. *)
Record flight : Type := { from : station; to : station; holds : bool; mid_a : itv; mid_p : itv; all_a : itv;
  all_p : itv; by_s : (itv * itv) * (itv * itv) }.

Section Cell.
Variable D : cell.
Variable N : itv.

Definition station_of (e : (nat * nat) * Edge.t) (S : itv) : station :=
  {| edge := e; whole := impactI D N S; centre := impactI D N (at_point (middle S)) |}.
Definition apart (x : station) : itv := minus (strength (whole x)) (strength (centre x)).
Definition factor_of (x : station) : itv := fraction (Edge.factor (snd (edge x))).
Definition weight_of (x : station) : itv := fraction (Edge.weight (snd (edge x))).

(** The mean-value form narrows what is known of a and p, which the derivatives depend on. *)
Definition moved (x y : station) (d : itv * itv) : itv := plus (times (fst d) (apart x)) (times (snd d) (apart y)).
Definition narrow (all mid : leg) (x y : station) (ap : itv * itv) : itv * itv := let d := slopes all (snd ap) in
  (meet (fst ap) (minus (first_at mid) (moved x y (fst d))), meet (snd ap) (minus (last_at mid) (moved x y (snd
    d)))).
Definition flight_of (j : BinNums.positive) (x y : station) : flight :=
  let all := leg_between D j (whole x) (whole y) in
  let mid := leg_between D j (centre x) (centre y) in
  let ap := narrow all mid x y (narrow all mid x y (first_at all, last_at all)) in
  {| from := x; to := y; holds := lawful all && lawful mid; mid_a := first_at mid; mid_p := last_at mid;
    all_a := fst ap; all_p := snd ap; by_s := slopes all (snd ap) |}.

(** Over leg x to an edge and leg y from it: the derivatives of F by s, by s before, and by s after; and F. *)
Definition own (x y : flight) : itv := let m := factor_of (from y) in
  minus (minus unit m) (times m (sumI D (fst (fst (by_s y))) (snd (snd (by_s x))))).
Definition earlier (x y : flight) : itv :=
  opp (times (factor_of (from y)) (sumI D zero (fst (snd (by_s x))))).
Definition later (x y : flight) : itv :=
  opp (times (factor_of (from y)) (sumI D (snd (fst (by_s y))) zero)).
Definition image (x y : flight) : itv := let m := factor_of (from y) in
  plus (plus (times (minus unit m) (strength (centre (from y)))) (times m (sumI D (mid_a y) (mid_p x))))
    (plus (times (own x y) (apart (from y)))
      (plus (times (earlier x y) (apart (from x))) (times (later x y) (apart (to y))))).

(** Both legs are at the same impact: its edge, and the part of it. *)
Definition on_edge (e : (nat * nat) * Edge.t) (x : station) : bool :=
  Nat.eqb (fst (fst (edge x))) (fst (fst e)) && Nat.eqb (snd (fst (edge x))) (snd (fst e)).
Definition same (X Y : itv) : bool := match X, Y with
  | Some (a, b), Some (c, d) => Z.eqb a c && Z.eqb b d | None, None => true | _, _ => false end.
Definition meets (x y : flight) : bool :=
  on_edge (edge (from y)) (to x) && same (strength (whole (to x))) (strength (whole (from y))).

Definition contracts (x y : flight) : bool :=
  let w := weight_of (from y) in
  below (plus (times (size (own x y)) w) (plus (times (size (earlier x y)) (weight_of (from x)))
    (times (size (later x y)) (weight_of (to y))))) (times (Ka D) w).
Definition leaves (x y : flight) : bool :=
  let v := times (strength (whole (from y))) half in
  positive (minus (all_a y) v) || positive (minus v (all_p x)) || positive (minus (all_a y) (all_p x)).
(** E1 to E3. *)
Definition follows_well (x y : flight) : bool := if meets x y then
  inside (Edge.strengths (snd (edge (from y)))) (image x y) && contracts x y && leaves x y else true.

(** ** H4: pieces of time on which the gap is convex, rises or is positive carry it away from an impact *)

Section Gap.
Variables (Q A F : itv).
Definition flown (t : itv) : itv * itv := flightI D Q A (minus t F).
Definition gap_of (t : itv) (x : itv * itv) : itv := plus (minus unit (gI D t)) (times N (minus (fst x) (Sg D))).
Definition slope_of (t : itv) (x : itv * itv) : itv := minus (times N (snd x)) (g1I D t).
Definition bend_of (t : itv) (x : itv * itv) : itv :=
  plus (bendI D t) (times N (minus (times (opp (C D)) (snd x)) (times (K D) (fst x)))).
(** On a piece at whose beginning it moves away from the wall, if b says so: whether at its end it does, if
  that is known. In window k the wall is below its top. What fails so may do in the mean-value form about the
  middle. With [opp] for [sign] back from the impact after the leg. *)
Definition carries (sign : itv -> itv) (k : Z) (b : bool) (t : itv) : option bool :=
  let x := flown t in
  if b && positive (bend_of t x) then Some true else
  if positive (sign (slope_of t x)) then Some true else
  if positive (gap_of t x) || below (size (minus t (turns_on k))) (W D) && positive (minus (fst x) (Sg D)) then
    Some false else
  let m := at_point (middle t) in let y := flown m in let off := minus t m in
  let slope := meet (slope_of t x) (plus (slope_of m y) (times (bend_of t x) off)) in
  if positive (sign slope) then Some true else
  if positive (plus (gap_of m y) (times slope off)) then Some false else None.
End Gap.
End Cell.

(** How far pieces carry it from l to h: halves, as often as n says; then over times in their order, with windows. *)
Fixpoint walk (n : nat) (f : bool -> itv -> option bool) (l h : Z) (b : bool) : Z * option bool :=
  match f b (Some (l, h)) with Some b => (h, Some b) | None => match n with O => (l, None) | S n =>
    let m := Z.shiftr (l + h) 1 in match walk n f l m b with
      | (_, Some b) => walk n f m h b | stop => stop end end end.
Fixpoint along (f : Z -> bool -> itv -> option bool) (l : Z) (b : bool) (L : list (Z * Z)) : Z := match L with
  | [] => l
  | (h, k) :: L => if (h <=? l)%Z then along f l b L else
      match walk 7 (f k) l h b with (_, Some b) => along f h b L | (z, None) => z end end.
(** The ends of windows k, k + 1, and so on; and back from window k. *)
Definition sides D (k : Z) : Z * Z := match minus (turns_on k) (W D), plus (turns_on k) (W D) with
  | Some (_, l), Some (h, _) => (l, h) | _, _ => (0, 0)%Z end.
Fixpoint ahead D (n : nat) (k : Z) : list (Z * Z) := match n with O => [] | S n =>
  (snd (sides D k), k) :: (fst (sides D (k + 1)), k) :: ahead D n (k + 1) end.
Fixpoint back D (n : nat) (k : Z) : list (Z * Z) := match n with O => [] | S n =>
  (- fst (sides D k), k)%Z :: (- snd (sides D (k - 1)), k)%Z :: back D n (k - 1) end.
(** A leg of j turns from an impact on with velocity A to one at a phase in F. *)
Definition gap_open D N (j : BinNums.positive) (I : impact) (A F : itv) : bool :=
  match phase_at I, plus (turn j) F with
  | Some (l, _), Some (_, h) =>
    let f := carries D N (place_at I) A (phase_at I) in let n := Pos.to_nat j in
    let z := along (f (fun X => X)) l true (ahead D n 0 ++ [(h, Z.pos j)]) in
    if (h <=? z)%Z then true else
    (- along (fun k b t => f opp k b (opp t)) (- h) true (back D n (Z.pos j) ++ [(- l, 0)]) <=? z)%Z
  | _, _ => false end.

(** ** All legs between edges with these strengths *)

Notation named := ((nat * nat) * Edge.t)%type.
Definition edges_of (X : Range.t) (K : Cell.t) : list named := combine (Range.graph X) (Cell.edges K).
Definition stations D N (L : list (named * itv)) : list station := map (fun p => station_of D N (fst p) (snd p)) L.
Definition flights (X : Range.t) D (st : list station) : list (BinNums.positive * flight) :=
  flat_map (fun x => flat_map (fun y =>
    if Nat.eqb (snd (fst (edge x))) (fst (fst (edge y))) then
      match nth_error (Range.periods X) (snd (fst (edge x))) with Some j => [(j, flight_of D j x y)] | None =>
        [] end
    else []) st) st.
Definition all_hold (fl : list (BinNums.positive * flight)) : bool := forallb (fun x => holds (snd x)) fl.

(** ** Ranges in parts *)

Fixpoint pieces (k : nat) (l w h : Z) : list itv := match k with
  | O | S O => [Some (l, h)] | S k => Some (l, l + w)%Z :: pieces k (l + w)%Z w h end.
Definition parts (k : nat) (X : itv) : list itv := match X with
  | Some (l, h) => pieces k l ((h - l) / Z.of_nat k)%Z h | None => [None] end.
Definition in_parts (k : nat) (L : list (named * itv)) : list (named * itv) :=
  flat_map (fun p => map (fun S => (fst p, S)) (parts k (snd p))) L.

(** ** A cell *)

(** How often the depths are halved. *)
Definition halvings : nat := 10.
Definition with_ranges (L : list named) : list (named * itv) := map (fun e => (e, ranging (Edge.strengths (snd
  e)))) L.
Definition flights_at (X : Range.t) D (k : nat) (L : list (named * itv)) (N : itv) :
  list (BinNums.positive * flight) := flights X D (stations D N (in_parts k L)).
Definition contracts_at (X : Range.t) D (k : nat) (L : list named) (N : itv) : bool :=
  let fl := flights_at X D k (with_ranges L) N in
  if all_hold fl then forallb (fun x => forallb (fun y => follows_well D (snd x) (snd y)) fl) fl else false.
(** The first velocities of all legs between two edges. *)
Definition firsts (fl : list (BinNums.positive * flight)) (e e' : named) : itv := hull_all (flat_map (fun x =>
  if on_edge e (from (snd x)) && on_edge e' (to (snd x)) then [all_a (snd x)] else []) fl).
Definition open_at (X : Range.t) D (k : nat) (L : list named) (N : itv) : bool :=
  let fl := flights_at X D k (with_ranges L) N in
  let all := map (fun p => (fst p, impactI D N (snd p))) (with_ranges L) in
  if all_hold fl then forallb (fun x => forallb (fun y =>
    if Nat.eqb (snd (fst (fst x))) (fst (fst (fst y))) then
      match nth_error (Range.periods X) (snd (fst (fst x))) with
      | Some j => gap_open D N j (snd x) (firsts fl (fst x) (fst y)) (phase_at (snd y)) | None => false end
    else true) all) all else false.
Definition edge_ok (e : Edge.t) : bool := ordered (Edge.strengths e) && less 0 (Edge.weight e).
Definition cell_holds (X : Range.t) D (K : Cell.t) : bool :=
  let L := edges_of X K in let N := ranging (Cell.depth K) in let k := Cell.parts K in
  if Nat.eqb (length (Range.graph X)) (length (Cell.edges K)) && forallb edge_ok (Cell.edges K) then
    if cover halvings (contracts_at X D k L) N then cover halvings (open_at X D k L) N else false
  else false.

(** ** From cell to cell: edges with strengths, and with what the latter cell says of them *)

Definition image_of D (fl : list (BinNums.positive * flight)) (e : named) : itv :=
  hull_all (flat_map (fun x => if on_edge e (to (snd x)) then flat_map (fun y =>
    if meets (snd x) (snd y) then [image D (snd x) (snd y)] else []) fl else []) fl).
Definition narrowed (X : Range.t) D (k : nat) N (B : list ((named * itv) * Edge.t)) :
  option (list ((named * itv) * Edge.t)) :=
  let fl := flights_at X D k (map fst B) N in
  if all_hold fl then Some (map (fun b => let '((e, Y), e') := b in ((e, meet Y (image_of D fl e)), e')) B) else
    None.
Fixpoint linked (n : nat) (X : Range.t) D (k : nat) N (B : list ((named * itv) * Edge.t)) : bool :=
  if forallb (fun b => inside (Edge.strengths (snd b)) (snd (fst b))) B then true else match n with
  | O => false
  | S n => match narrowed X D k N B with Some B => linked n X D k N B | None => false end end.
Definition links (X : Range.t) D (K K' : Cell.t) : bool :=
  linked (Cell.steps K') X D (Cell.parts K) (fraction (snd (Cell.depth K)))
    (combine (with_ranges (edges_of X K)) (Cell.edges K')).

(** ** All cells, from a depth on *)

Fixpoint cells_hold (X : Range.t) D (q : Q) (L : list Cell.t) : bool := match L with
  | [] => true
  | K :: L => if Qeq_bool (fst (Cell.depth K)) q && less (fst (Cell.depth K)) (snd (Cell.depth K)) then
      if cell_holds X D K then
        if match L with [] => true | K' :: _ => links X D K K' end then cells_hold X D (snd (Cell.depth K)) L
          else false
      else false
    else false end.
Definition cell_of (X : Range.t) : cell := {| C := ranging (Range.damping X); K := ranging (Range.stiffness X);
  T := ranging (Range.restitution X); Sg := constant (if Range.behind X then 1 else -1) 1;
  H := rangings (Range.harmonics X); W := fraction (Range.window X); Ka := fraction (Range.contraction X) |}.
Definition check_range (X : Range.t) : bool :=
  if Qle_bool 0 (Range.contraction X) && less (Range.contraction X) 1 && wall_ok (cell_of X) then
    cells_hold X (cell_of X) 0 (Range.cells X)
  else false.
