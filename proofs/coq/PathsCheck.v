(** * The conditions H0 to H4 of proofs/chaos.md in integers: a function from certificates to yes and no *)

From Coq Require Import QArith ZArith Bool List.
From Grazing Require Import StatementPaths ChaosInterval ChaosFunctions.
Import ListNotations.

Definition fraction (q : Q) : itv := constant (Qnum q) (Qden q).
Definition ranging (X : Q * Q) : itv := join (fraction (fst X)) (fraction (snd X)).
Definition inside (X : Q * Q) (A : itv) : bool := below (fraction (fst X)) A && below A (fraction (snd X)).
Definition quarter : itv := constant 1 4.
Definition zero : itv := constant 0 1.
(** A whole multiple. *)
Definition scaled (j : BinNums.positive) (X : itv) : itv := match X with
  | Some (l, h) => Some (Z.pos j * l, Z.pos j * h)%Z | None => None end.

(** Ranges of what is not nu: c, k, tau, sigma, the harmonics, the window, the contraction. *)
Record cell : Type := { C : itv; K : itv; T : itv; Sg : itv; H : list (BinNums.positive * (itv * itv));
  W : itv; Ka : itv }.

Section Cell.
Variable D : cell.

(** ** The wall *)

Definition none (X : itv) : bool := match X with Some (Z0, Z0) => true | _ => false end.
Definition times_of (f : itv -> itv) (A Y : itv) : itv := if none A then zero else times A (f Y).
Fixpoint totalI (f : BinNums.positive * (itv * itv) -> itv) (H : list (BinNums.positive * (itv * itv))) : itv
  :=
  match H with nil => zero | cons h H => plus (f h) (totalI f H) end.
Definition gI (X : itv) : itv := totalI (fun '(j, (A, B)) => let Y := scaled j X in
  plus (times_of cosine A Y) (times_of sine B Y)) (H D).
Definition g1I (X : itv) : itv := totalI (fun '(j, (A, B)) => let Y := scaled j X in
  scaled j (minus (times_of cosine B Y) (times_of sine A Y))) (H D).
(** The bend g'', with the other sign. *)
Definition bendI (X : itv) : itv := totalI (fun '(j, (A, B)) => let Y := scaled j X in
  scaled (j * j) (plus (times_of cosine A Y) (times_of sine B Y))) (H D).

(** The phase in the window at which g' is in Y: a guess, a little off, confirmed. *)
Definition middle (X : itv) : Z := match X with Some (l, h) => Z.shiftr (l + h) 1 | None => 0 end.
Definition at_point (z : Z) : itv := Some (z, z).
(** About cos t and sin t for small t, not trusted. *)
Definition about (t : Z) : Z * Z :=
  let z := down (t * t) in let step x q := (one - down (z * x) / q)%Z in
  (step (step (step one 30) 12) 2, down (t * step (step (step one 42) 20) 6))%Z.
Definition slope_and_bend (t : Z) : Z * Z := fold_right (fun '(j, (A, B)) s =>
  let '(co, si) := about (Z.pos j * t) in let a := middle A in let b := middle B in
  (fst s + Z.pos j * down (b * co - a * si), snd s + Z.pos j * Z.pos j * down (a * co + b * si)))%Z (0,
    0)%Z (H D).
Fixpoint newton (n : nat) (y t : Z) : Z := match n with
  | O => t
  | S n => let '(s, b) := slope_and_bend t in newton n y (t + (s - y) * one / b)%Z end.
Definition phase_off (off : Z) (Y : itv) : itv := match Y with
  | Some (l, h) =>
    let a := (newton 3 h 0 - off)%Z in let b := (newton 3 l 0 + off)%Z in
    if below (opp (W D)) (at_point a) && below (at_point b) (W D) && below (at_point a) (at_point b) &&
       below Y (g1I (at_point a)) && below (g1I (at_point b)) Y then Some (a, b) else None
  | None => None end.
Definition phaseI (N S : itv) : itv :=
  let Y := times (times N S) half in
  match phase_off (one / 1000000) Y with Some X => Some X | None =>
    match phase_off (one / 100000) Y with Some X => Some X | None => phase_off (one / 5000) Y end end.

Definition hull (X Y : itv) : itv := match X, Y with
  | Some (a, b), Some (c, d) => Some (Z.min a c, Z.max b d) | _, _ => None end.
Definition hull_all (L : list itv) : itv := match L with [] => None | X :: L => fold_right hull X L end.
(** What both know, of numbers in both. *)
Definition meet (X Y : itv) : itv := match X, Y with
  | Some (a, b), Some (c, d) => Some (Z.max a c, Z.min b d) | None, Y => Y | X, None => X end.
(** Of an impact at a phase in F: where, with (1 - g)/g'^2 by the bend, or g itself away from the touch; and
  minus the derivative of the phase. *)
Definition placeI (N S F : itv) : itv := minus (Sg D) (meet
  (times (times N (times (times S half) (times S half))) (times half (inverse (bendI (hull zero F)))))
  (times (minus unit (gI F)) (inverse N))).
Definition rateI (N F : itv) : itv := times (times N half) (inverse (bendI F)).

(** An impact: s, the phase, the place, and minus the derivative of the phase. *)
Record impact : Type := { strength : itv; phase_at : itv; place_at : itv; rate : itv }.
Definition impactI (N S : itv) : impact := let F := phaseI N S in
  {| strength := S; phase_at := F; place_at := placeI N S F; rate := rateI N F |}.
Definition in_window (I : impact) : bool := positive (minus (W D) (size (phase_at I))).

(** ** Legs *)

Definition sumI (A P : itv) : itv := times (double (plus A (times (T D) P))) (inverse (plus unit (T D))).
Definition turn_1 : itv := double pi.
Definition turn (n : BinNums.positive) : itv := scaled n turn_1.
Definition frequencyI : itv := root (minus (K D) (times (times (C D) (C D)) quarter)).

(** H0; the velocities a and p; with p in a range, minus the derivatives of a by s and s', and those of p. *)
Record leg : Type := { lawful : bool; first_at : itv; last_at : itv;
  slopes : itv -> (itv * itv) * (itv * itv) }.
(** With sin/frequency, cos, and exp of half the damping. *)
Definition leg_with (I I' : impact) (co si ex : itv) : leg :=
  let h := times (C D) half in
  let ei := inverse ex in let is := inverse si in
  let cot := times co is in
  let u := times ex is in
  let Q := place_at I in let Q' := place_at I' in
  let e11 := times ei (plus co (times h si)) in
  let e12 := times ei si in
  let e22 := times ei (minus co (times h si)) in
  let v := times (strength I) half in let v' := times (strength I') half in
  {| lawful := in_window I && in_window I' && (positive si || positive (opp si));
     first_at := minus (times u Q') (times (plus cot h) Q);
     last_at := minus (times (minus cot h) Q') (times (times ei is) Q);
     slopes := fun p =>
       let acc := minus (times (opp (C D)) p) (times (K D) Q') in
       let b := times (minus p (times e11 v)) u in
       let b' := times (minus v' p) u in
       ((times (rate I) b, times (rate I') b'),
        (times (rate I) (minus (minus (times e22 b) (times (K D) (times e12 v))) acc),
         times (rate I') (plus (times e22 b') acc))) |}.
Definition leg_between (j : BinNums.positive) (I I' : impact) : leg :=
  let L := minus (plus (turn j) (phase_at I')) (phase_at I) in
  let cs := angle (times frequencyI L) in
  leg_with I I' (fst cs) (times (inverse frequencyI) (snd cs)) (exponential (times (times (C D) half) L)).

(** ** The gap (H4) over j turns from an impact with velocity A to others: convex till t1, from t2 before the
  end on, and positive between *)

Definition flightI (Q A tau : itv) : itv * itv :=
  let h := times (C D) half in
  let ei := exponential (times (opp h) tau) in
  let th := times frequencyI tau in let co := cosine th in let si := times (inverse frequencyI) (sine th) in
  (plus (times (times ei (plus co (times h si))) Q) (times (times ei si) A),
   minus (times (times ei (minus co (times h si))) A) (times (K D) (times (times ei si) Q))).
Definition convex_piece N Q A F (t : itv) : bool :=
  let x := flightI Q A (minus t F) in
  positive (plus (bendI t) (times N (minus (times (opp (C D)) (snd x)) (times (K D) (fst x))))).
Definition open_piece N Q A F (t : itv) : bool :=
  let x := minus (fst (flightI Q A (minus t F))) (Sg D) in
  positive (plus (minus unit (gI t)) (times N x)).
(** In the window j turns on. *)
Definition high_piece Q A F (t : itv) : bool := positive (minus (fst (flightI Q A (minus t F))) (Sg D)).

Definition depth_of_cover : nat := 8.
Definition covered := cover depth_of_cover.
Fixpoint windows (f : Z -> bool) (n : nat) (j : Z) : bool := match n with
  | O => true | S n => f j && windows f n (j + 1)%Z end.
Definition turns_on (j : Z) : itv := match j with Zpos j => turn j | _ => zero end.
Definition gap_box (j : BinNums.positive) N (I : impact) (A t1 t2 : itv) (ends : list itv) : bool :=
  let F := phase_at I in let Q := place_at I in
  let from i := if (i =? 0)%Z then t1 else plus (turns_on i) (W D) in
  let till i := minus (turns_on i) (if (i =? Z.pos j)%Z then t2 else W D) in
  covered (convex_piece N Q A F) (join F t1) &&
  forallb (fun F' => covered (convex_piece N Q A F) (join (till (Z.pos j)) (plus (turn j) F'))) ends &&
  windows (fun i => covered (fun t => high_piece Q A F t || open_piece N Q A F t) (join (till i) (from i)))
    (Pos.to_nat j - 1) 1 &&
  windows (fun i => covered (open_piece N Q A F) (join (from i) (till (i + 1)%Z))) (Pos.to_nat j) 0.

(** ** Certificates of boxes: H0 to H2 for a leg n after each of ms, before k; and H4 *)

Definition sI (m n : Letter.t) : itv :=
  join (sumI (fraction (fst (Letter.after n))) (fraction (fst (Letter.before m))))
       (sumI (fraction (snd (Letter.after n))) (fraction (snd (Letter.before m)))).
Definition weightI (m n : Letter.t) : itv :=
  sumI (fraction (fst (Letter.weights n))) (fraction (snd (Letter.weights m))).
Definition contracts (m n k : Letter.t) (x : (itv * itv) * (itv * itv)) : bool :=
  let w := weightI m n in let w' := weightI n k in
  below (plus (times (size (fst (fst x))) w) (times (size (snd (fst x))) w'))
        (times (Ka D) (fraction (fst (Letter.weights n)))) &&
  below (plus (times (size (fst (snd x))) w) (times (size (snd (snd x))) w'))
        (times (Ka D) (fraction (snd (Letter.weights n)))).
Definition leg_box (ms : list Letter.t) (n k : Letter.t) (N S S' : itv) : bool :=
  let x := leg_between (Letter.periods n) (impactI N S) (impactI N S') in
  lawful x && (inside (Letter.after n) (first_at x) && inside (Letter.before n) (last_at x)) &&
  let d := slopes x (last_at x) in forallb (fun m => contracts m n k d) ms.
Definition letter_gap (n : Letter.t) (ks : list Letter.t) (N S : itv) : bool :=
  gap_box (Letter.periods n) N (impactI N S) (ranging (Letter.after n)) (W D) (W D)
    (map (fun k => phaseI N (sI n k)) ks).
End Cell.

Definition followers (L : list Letter.t) (l : Letter.t) : list Letter.t :=
  flat_map (fun v => match nth_error L v with Some l' => [l'] | None => [] end) (Letter.next l).

(** ** A cell, and all *)

Definition fuel : nat := 12.
(** All that s is where a leg n follows one of ms. *)
Definition all_sI D (ms : list Letter.t) (n : Letter.t) : itv := hull_all (map (fun m => sI D m n) ms).
Definition leg_ok D N (ms : list Letter.t) (n k : Letter.t) : bool :=
  cover3 fuel (fun N S' S => leg_box D ms n k N S S') N (sI D n k) (all_sI D ms n).
Definition before_it (L : list Letter.t) (v : nat) : list Letter.t :=
  filter (fun m => existsb (Nat.eqb v) (Letter.next m)) L.
Definition letter_in_cell D N (L : list Letter.t) (v : nat) : bool := match nth_error L v with
  | None => true
  | Some n => letter_gap D n (followers L n) N (all_sI D (before_it L v) n) &&
      forallb (leg_ok D N (before_it L v) n) (followers L n) end.
(** The machine; and that the wall bends in the window. *)
Definition wall_ok D : bool :=
  positive (minus (K D) (times (times (C D) (C D)) quarter)) && positive (T D) && positive (W D) &&
  below (W D) pi && covered (fun X => positive (bendI D X)) (join (opp (W D)) (W D)).
Definition cell_ok D (L : list Letter.t) (N : itv) : bool :=
  wall_ok D && forallb (letter_in_cell D N L) (seq 0 (length L)).

Definition less (p q : Q) : bool := negb (Qle_bool q p).
Definition ordered (X : Q * Q) : bool := Qle_bool (fst X) (snd X).
(** The form of a letter; and H3 for those that follow. *)
Definition letter_ok (L : list Letter.t) (m : Letter.t) : bool :=
  ordered (Letter.after m) && ordered (Letter.before m) && less 0 (fst (Letter.weights m)) &&
  less 0 (snd (Letter.weights m)) &&
  forallb (fun n => less (snd (Letter.before m)) (fst (Letter.after n))) (followers L m).

Definition rangings : list (BinNums.positive * ((Q * Q) * (Q * Q))) -> list (BinNums.positive * (itv * itv)) :=
  map (fun '(j, (A, B)) => (j, (ranging A, ranging B))).
Definition check (X : Certificate.t) : bool :=
  let L := Certificate.letters X in
  let '(c, k, t, n) := Certificate.cells X in
  let H := rangings (Certificate.harmonics X) in
  Qle_bool 0 (Certificate.contraction X) && less (Certificate.contraction X) 1 && forallb (letter_ok L) L &&
  cut (fun C => cut (fun K => cut (fun T => cut (fun N =>
    cell_ok {| C := C; K := K; T := T; Sg := constant (if Certificate.behind X then 1 else -1) 1; H := H;
      W := fraction (Certificate.window X); Ka := fraction (Certificate.contraction X) |} L N)
    n (ranging (Certificate.depth X))) t (ranging (Certificate.restitution X))) k (ranging
      (Certificate.stiffness X)))
    c (ranging (Certificate.damping X)).
