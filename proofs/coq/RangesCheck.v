(** * The conditions H0, E1 to E3, H4 and the links of docs/ranges.md in integers: a function from certificates to
  yes and no *)

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

Definition same_edge (x y : flight) : bool :=
  let e := fst (edge (to x)) in let e' := fst (edge (from y)) in
  Nat.eqb (fst e) (fst e') && Nat.eqb (snd e) (snd e').

Definition contracts (x y : flight) : bool :=
  let w := weight_of (from y) in
  below (plus (times (size (own x y)) w) (plus (times (size (earlier x y)) (weight_of (from x)))
    (times (size (later x y)) (weight_of (to y))))) (times (Ka D) w).
Definition leaves (x y : flight) : bool :=
  let v := times (strength (whole (from y))) half in
  positive (minus (all_a y) v) || positive (minus v (all_p x)) || positive (minus (all_a y) (all_p x)).
(** E1 to E3. *)
Definition follows_well (x y : flight) : bool := if same_edge x y then
  inside (Edge.strengths (snd (edge (from y)))) (image x y) && contracts x y && leaves x y else true.

(** H4. *)
Definition openly (j : BinNums.positive) (x : flight) : bool :=
  existsb (fun q => let t := times (W D) (constant 1 q) in
    gap_box D j N (whole (from x)) (all_a x) t t [phase_at (whole (to x))]) [1; 2; 4]%positive.
End Cell.

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

(** ** A cell *)

Definition with_ranges (L : list named) : list (named * itv) := map (fun e => (e, ranging (Edge.strengths (snd
  e)))) L.
Definition contracts_at (X : Range.t) D (L : list named) (N : itv) : bool :=
  let fl := flights X D (stations D N (with_ranges L)) in
  if all_hold fl then forallb (fun x => forallb (fun y => follows_well D (snd x) (snd y)) fl) fl else false.
Definition open_at (X : Range.t) D (L : list named) (N : itv) : bool :=
  let fl := flights X D (stations D N (with_ranges L)) in
  if all_hold fl then forallb (fun x => openly D N (fst x) (snd x)) fl else false.
Definition edge_ok (e : Edge.t) : bool := ordered (Edge.strengths e) && less 0 (Edge.weight e).
Definition cell_holds (X : Range.t) D (K : Cell.t) : bool :=
  let L := edges_of X K in let N := ranging (Cell.depth K) in
  if Nat.eqb (length (Range.graph X)) (length (Cell.edges K)) && forallb edge_ok (Cell.edges K) then
    if cover fuel (contracts_at X D L) N then cover fuel (open_at X D L) N else false
  else false.

(** ** From cell to cell: edges with strengths, and with what the latter cell says of them *)

Definition image_of D (fl : list (BinNums.positive * flight)) (e : named) : itv :=
  let is z := Nat.eqb (fst (fst (edge z))) (fst (fst e)) && Nat.eqb (snd (fst (edge z))) (snd (fst e)) in
  hull_all (flat_map (fun x => flat_map (fun y =>
    if is (to (snd x)) && is (from (snd y)) then [image D (snd x) (snd y)] else []) fl) fl).
Definition narrowed (X : Range.t) D N (B : list ((named * itv) * Edge.t)) : option (list ((named * itv) *
  Edge.t)) :=
  let fl := flights X D (stations D N (map fst B)) in
  if all_hold fl then Some (map (fun b => let '((e, Y), e') := b in ((e, meet Y (image_of D fl e)), e')) B) else
    None.
Fixpoint linked (n : nat) (X : Range.t) D N (B : list ((named * itv) * Edge.t)) : bool :=
  if forallb (fun b => inside (Edge.strengths (snd b)) (snd (fst b))) B then true else match n with
  | O => false
  | S n => match narrowed X D N B with Some B => linked n X D N B | None => false end end.
Definition links (X : Range.t) D (K K' : Cell.t) : bool :=
  linked (Cell.steps K') X D (fraction (snd (Cell.depth K))) (combine (with_ranges (edges_of X K)) (Cell.edges
    K')).

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
