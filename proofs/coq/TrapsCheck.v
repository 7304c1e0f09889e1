(** * The rules A1 to A7 of certificates of kind attractor in integers: a function to yes and no *)
From Coq Require Import QArith ZArith Bool List.
From Grazing Require Import StatementPaths StatementTraps ChaosInterval ChaosFunctions PathsCheck.
Import ListNotations.

(** ** A2 to A5: from enclosures of a, b, b - a, tau, nu, the window, both bends, S and Z *)

Definition quo (X Y : itv) : itv := times X (inverse Y).
Definition low (X : itv) : itv := match X with Some (l, _) => at_point l | None => None end.
Definition high (X : itv) : itv := match X with Some (_, h) => at_point h | None => None end.
(** A number that is at most both; at least both. *)
Definition lesser (X Y : itv) : itv := match X, Y with Some (a, _), Some (c, _) => at_point (Z.min a c) | _, _ =>
  None end.
Definition greater (X Y : itv) : itv := match X, Y with Some (_, b), Some (_, d) => at_point (Z.max b d) | _, _ =>
  None end.
(** exp (- x), x >= 0: squared three times more, at both ends; beyond 22 it is less than a unit. *)
Definition exp_at (z : Z) : itv := squares 3 (exponential (times (at_point z) (constant 1 8))).
Definition fallI (X : itv) : itv := match X with
  | Some (l, h) => if (22 * one <=? l)%Z then join zero (exp_at (-22 * one)) else join (exp_at (- h)) (exp_at (- l))
  | None => None end.

Record inputs : Type := { aI : itv; bI : itv; dI : itv; tI : itv; nI : itv; wI : itv; lowI : itv; topI : itv;
  speedI : itv; slipI : itv }.
Section Function.
Variable I : inputs.
Definition reachI (T : itv) : itv := let x := high (aI I) in let y := high (bI I) in
  quo (minus (fallI (times x T)) (fallI (times y T))) (minus y x).
Definition restI (T : itv) : itv := let x := low (aI I) in let y := low (bI I) in let e := fallI (times x T) in
  plus e (times x (quo (minus e (fallI (times y T))) (minus y x))).
Definition ellI (n : BinNums.positive) : itv := lesser (reachI (minus (turn n) (wI I))) (reachI (plus (turn n) (wI I))).
Definition rI : itv := root (nI I).
Definition shareI : itv := quo (times (bI I) (bI I)) (dI I).
Definition bothI : itv := plus unit (tI I).
Definition wholeI : itv := inverse (ellI 1).
Definition earlyI : itv := minus (lowI I) (times (times shareI (inverse (fallI (times (bI I) (wI I)))))
  (times (nI I) (plus (slipI I) wholeI))).
Definition fallenI : itv := let v := quo wholeI bothI in minus unit (times (fallI (times (aI I) (turn 1)))
  (minus unit (quo (times (times (tI I) (tI I)) (times (nI I) (times v v))) (double earlyI)))).
Definition mostI : itv := plus (topI I) (times (times (aI I) (aI I)) (times (nI I) (plus unit (quo (slipI I) (dI I))))).
Definition quickI : itv := times rI (speedI I).
Definition lateI : itv := minus (lowI I) (times shareI (plus (times (nI I) (slipI I)) (times bothI quickI))).
Definition strengthI : itv := plus (times (tI I) (minus (lowI I) (times shareI (times (nI I) (slipI I))))) lateI.
Definition steepI : itv := greater (plus (speedI I) (times rI (slipI I))) (times (aI I) rI).
Definition heightI : itv := minus unit (quo (times steepI steepI) (double (lowI I))).
Definition wayI : itv := times (plus (times bothI (speedI I)) (times rI (slipI I))) (speedI I).
Definition by_A (s e : itv) (n : BinNums.positive) : bool := below e (times s (ellI n)).
Definition by_B (s h e : itv) (n : BinNums.positive) : bool := below e (times s (minus h (restI (minus
  (turn n) (wI
  I))))).
(** Growth by e over n periods, the numbers s, h, q and w being found. *)
Definition by_either (s h q w e : itv) (n : BinNums.positive) : bool :=
  by_A s (times e q) n || by_B s h (times e w) n.
Definition slip_holds : bool := let f := fallI (times (low (dI I)) (minus (turn 1) (wI I))) in
  positive (low (dI I)) && positive (minus unit f) && below (times (low (dI I)) f) (times (slipI I) (minus
    unit f)).
Definition numbers_hold (E : itv) (last : BinNums.positive) : bool :=
  positive (minus (turn 1) (wI I)) && positive (lowI I) && positive (minus (high (bI I)) (high (aI I))) &&
  positive (low (aI I)) && positive (minus (low (bI I)) (low (aI I))) && positive (ellI 1) && slip_holds &&
  positive earlyI && below (double (times mostI fallenI)) (times (speedI I) (speedI I)) && positive lateI
    &&
  positive (speedI I) && positive (slipI I) && positive (minus E unit) &&
  let s := strengthI in let h := heightI in let q := quickI in let w := wayI in
  forallb (fun n => by_either s h q w E (Pos.of_nat n)) (seq 1 (Pos.to_nat last - 1)) &&
  by_B s h (times E w) last.
(** A7: returns take no more periods, from the depth nu on, and in each motions part by exp R. *)
Definition exponent_holds (nu R : itv) (last : BinNums.positive) : bool :=
  let T := minus (turn last) (wI I) in let kick := plus (quo (times bothI (speedI I)) (root nu)) (slipI I) in
  positive (minus unit (plus (restI T) (times (quo (fallI (times (aI I) T)) (dI I)) kick))) &&
  let s := strengthI in let h := heightI in let q := quickI in let w := wayI in
  forallb (fun n => let n := Pos.of_nat n in by_either s h q w (inverse (fallI (scaled n R))) n)
    (seq 1 (Pos.to_nat last)).
End Function.


(** ** Certificates *)

Section Certificate.
Variable X : Trap.t.
Definition inputs_of : inputs :=
  let c := ranging (Trap.damping X) in let k := ranging (Trap.stiffness X) in
  let d := root (minus (times c c) (times (constant 4 1) k)) in let b := times half (plus c d) in
  {| aI := quo k b; bI := b; dI := d; tI := ranging (Trap.restitution X); nI := fraction (Trap.depth X);
    wI := plus (fraction (fst (Trap.window X))) (fraction (snd (Trap.window X)));
    lowI := fraction (fst (Trap.bends X)); topI := fraction (snd (Trap.bends X));
    speedI := fraction (Trap.speed X); slipI := fraction (Trap.slip X) |}.
Definition overdamped_all : bool :=
  let c := ranging (Trap.damping X) in let k := ranging (Trap.stiffness X) in
  positive c && positive k && positive (minus (times c c) (times (constant 4 1) k)).

(** A6. *)
Definition starts (I : inputs) : bool :=
  let x := fraction (Trap.start X) in let bend := plus (topI I) (times (times (aI I) (aI I)) (plus (nI I) (quo x
    (dI I)))) in
  below (times (nI I) (slipI I)) x && positive (minus (lowI I) (times (shareI I) (plus x (times (bothI I) (root
    (double (times (nI I) bend))))))).

(** A7. *)
Definition exponent_is (I : inputs) : bool := match Trap.exponent X with None => true
  | Some ((nu, R), m) => less 0 nu && exponent_holds I (fraction nu) (fraction R) m end.

(** A1: the cosine; or any g that is concave where it is said, and lower elsewhere. *)
Definition wall_cell : cell := {| C := None; K := None; T := None; Sg := None; H := rangings (Trap.harmonics X);
  W := None; Ka := None |}.
(** 1 - g at u, or at - u, not beyond 1: by the series alone, since windows end where this is hardly above the
    depth. *)
Definition sin_small (Y : itv) : itv := let Z := times Y Y in
  let step q X := minus unit (times (times Z (constant 1 q)) X) in
  let series X := times Y (step 6 (step 20 (step 42 X)))%positive in join (series unit) (series (step 72%positive
    unit)).
Definition drop_at (after : bool) (u : itv) : itv := totalI (fun '(j, (A, B)) =>
  let s := times B (sin_small (scaled j u)) in
  minus (times A (minus unit (cos_small (scaled j u)))) (if after then s else opp s)) (H wall_cell).
Definition low_at (after : bool) (u : itv) : bool := let nu := fraction (Trap.depth X) in
  below nu (minus unit (gI wall_cell (if after then u else opp u))) ||
  forallb (fun h => positive (scaled (fst h) u) && below (scaled (fst h) u) unit) (H wall_cell) && below nu (drop_at
    after u).
Definition pieces_of (f : itv -> bool) (l h : itv) : bool := cover 11 f (join l h).
Definition is_cosine : bool := match Trap.harmonics X with
  | [(xH, ((a, b), (c, d)))] => Qeq_bool a 1 && Qeq_bool b 1 && Qeq_bool c 0 && Qeq_bool d 0
  | _ => false end.
Definition cosine_holds : bool :=
  let far e := below (fraction e) pi && below (cosine (fraction e)) (minus unit (fraction (Trap.depth X)))
    in
  is_cosine && less (Trap.depth X) 1 && far (fst (Trap.window X)) && far (snd (Trap.window X)) &&
  less 0 (fst (Trap.window X)) && less 0 (snd (Trap.window X)) &&
  Qle_bool (fst (Trap.bends X)) (1 - Trap.depth X) && Qle_bool 1 (snd (Trap.bends X)).
Definition several_hold (V : Q * Q) : bool :=
  let l := opp (fraction (fst V)) in let h := fraction (snd V) in
  let l' := opp (fraction (fst (Trap.window X))) in let h' := fraction (snd (Trap.window X)) in
  let nu := fraction (Trap.depth X) in
  less 0 (Trap.depth X) && less 0 (fst (Trap.window X)) && less 0 (snd (Trap.window X)) &&
  Qle_bool (fst (Trap.window X)) (fst V) && Qle_bool (snd (Trap.window X)) (snd V) &&
  below h (plus l turn_1) && low_at false (fraction (fst (Trap.window X))) && low_at true h' &&
  pieces_of (fun t => positive (bendI wall_cell t)) l h &&
  pieces_of (fun t => positive (minus (minus unit (gI wall_cell t)) nu)) h (plus l turn_1) &&
  pieces_of (fun t => let b := bendI wall_cell t in below (lowI inputs_of) b && below b (topI inputs_of)) l' h'.
Definition check_trap : bool :=
  let I := inputs_of in
  match Trap.concave X with None => cosine_holds | Some V => several_hold V end && overdamped_all &&
  Qle_bool 0 (fst (Trap.restitution X)) && less 0 (Trap.depth X) &&
  Qle_bool (fst (Trap.bends X)) (snd (Trap.bends X)) &&
  numbers_hold I (fraction (Trap.growth X)) (Trap.last X) && starts I && exponent_is I.
End Certificate.
