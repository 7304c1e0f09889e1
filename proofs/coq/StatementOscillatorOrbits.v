(** * Statement: S1-S5, Theorem 2, Conjecture 1, the summary, the record form, patterns and words about oscillators

    Impacts n turns apart for all time; patterns; words; and the paper's oscillator, with its equations as they stand
    there. Read [StatementOscillator] and the sources of each theorem first. *)
From Coq Require Import Reals ZArith List.
From Grazing Require Import Defs StatementAffine StatementOrbitsPlane StatementOrbitsAreas StatementWords StatementOscillator.
Import ListNotations.
Open Scope R_scope.

(** ** One impact per period *)
Definition every (n : nat) (i : Z) : Z := (i * Z.of_nat n)%Z.

(** For small mu of sign s exactly one motion has its impacts n turns apart; it is periodic, and tends to the touch. *)
Definition bounces (O : Oscillator.t) (m : sign) (n : nat) (s : sign) : Prop := exists d mu0 K, d > 0 /\ mu0 > 0 /\
  forall mu, 0 < sgn s * mu < mu0 -> one_motion O m mu d (every n) /\
  forall t q v, motion O m mu d (every n) t q v -> forall i x,
  Rabs (t i - turn m * IZR (every n i)) <= K * Rabs mu /\ t (i + 1)%Z = t i + turn m * INR n /\
  side m (Z.of_nat n) * q (i + 1)%Z (x + turn m * INR n) = q i x.
Definition not_bounces (O : Oscillator.t) (m : sign) (n : nat) (s : sign) : Prop := exists d mu0, d > 0 /\ mu0 > 0 /\
  forall mu t q v, 0 < sgn s * mu < mu0 -> ~ motion O m mu d (every n) t q v.

Definition Single_oscillator_statement : Prop := forall O m a1 a2 gamma n s g, grazing O m a1 a2 gamma ->
  (1 <= n)%nat -> u a1 a2 n <> 0 -> sgn g * gamma > 0 ->
  (orbit a1 a2 n s g -> bounces O m n s) /\ (fails a1 a2 n s g -> not_bounces O m n s).

(** Every oscillator with this trace and determinant has the motion in the case (s, g) alone; in none. *)
Definition exactly_oscillator (a1 a2 : R) (n : nat) (s g : sign) : Prop := forall O m gamma, grazing O m a1 a2 gamma ->
  (sgn g * gamma > 0 -> bounces O m n s) /\ forall s', ~ (s' = s /\ sgn g * gamma > 0) -> not_bounces O m n s'.
Definition none_oscillator (a1 a2 : R) (n : nat) : Prop := forall O m gamma s, grazing O m a1 a2 gamma -> not_bounces O m n s.

Definition S1_S3_oscillator_statement : Prop := S1_S3_about exactly_oscillator none_oscillator.
Definition Theorem2_oscillator_statement : Prop := Theorem2_about exactly_oscillator none_oscillator.
Definition Conjecture1_oscillator_statement : Prop := Conjecture1_about exactly_oscillator none_oscillator.
Definition Record_oscillator_statement : Prop := Record_about exactly_oscillator none_oscillator.
Definition Summary_oscillator_statement : Prop := Summary_about
  (fun a1 a2 n s g => forall O m gamma, grazing O m a1 a2 gamma -> sgn g * gamma > 0 -> bounces O m n s)
  (fun a1 a2 n s g => forall O m gamma, grazing O m a1 a2 gamma -> sgn g * gamma > 0 -> not_bounces O m n s).

(** ** Patterns and words *)
Definition cyclic_letter (l : list nat) (i : Z) : nat := nth (Z.to_nat (i mod Z.of_nat (length l))) l 0%nat.

(** The patterns of [StatementWords] over {n <= n_max : u_n <> 0}, with one mu0. *)
Definition Patterns_oscillator_statement : Prop := forall O m a1 a2 gamma, grazing O m a1 a2 gamma ->
  forall n_max, exists d mu0, d > 0 /\ mu0 > 0 /\ forall (l : list nat) (N : Z -> Z) s g mu,
  l <> [] -> Forall (fun n => (1 <= n <= n_max)%nat /\ u a1 a2 n <> 0) l ->
  (forall i, N (i + 1)%Z = (N i + Z.of_nat (cyclic_letter l i))%Z) ->
  sgn g * gamma > 0 -> 0 < sgn s * mu < mu0 -> pattern a1 a2 s g l -> one_motion O m mu d N.

(** Regions 3 and 4 with damping, mu > 0: one mu0 for all patterns. *)
Definition All_patterns_oscillator_statement : Prop := forall O m a1 a2 gamma K, grazing O m a1 a2 gamma ->
  first_upper a1 a2 K -> a2 < 1 -> exists d mu0, d > 0 /\ mu0 > 0 /\ forall (l : list nat) (N : Z -> Z) g mu,
  l <> [] -> (forall i, N (i + 1)%Z = (N i + Z.of_nat (cyclic_letter l i))%Z) ->
  sgn g * gamma > 0 -> 0 < mu < mu0 -> pattern a1 a2 Plus g l -> one_motion O m mu d N.

(** Every region: all sequences of periods up to n_max that have a motion in one case. *)
Definition Shift_oscillator_statement : Prop := forall O m a1 a2 gamma, grazing O m a1 a2 gamma -> 0 < a2 ->
  forall n_max, exists d mu0, d > 0 /\ mu0 > 0 /\ forall (N : Z -> Z) (n : Z -> nat) s g mu,
  (forall i, N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\ (n i <= n_max)%nat /\ orbit a1 a2 (n i) s g) ->
  sgn g * gamma > 0 -> 0 < sgn s * mu < mu0 -> one_motion O m mu d N.

(** Regions 3 and 4, mu > 0: where the word ends in w, the sequences over all of V that have a motion are those that
    follow the arrows (for gamma < 0, that follow none). *)
Definition Graph_oscillator_statement : Prop := forall O m a1 a2 gamma, grazing O m a1 a2 gamma ->
  forall K w i j, first_upper a1 a2 K -> path a1 a2 K w i j ->
  Forall (fun x => member a1 a2 Plus (fst x)) (vertices K w) -> ends a1 a2 i j ->
  exists d mu0, d > 0 /\ mu0 > 0 /\ forall (N : Z -> Z) (n : Z -> nat * letter) g mu,
  (forall l, N (l + 1)%Z = (N l + Z.of_nat (fst (n l)))%Z /\ In (n l) (vertices K w)) ->
  sgn g * gamma > 0 -> 0 < mu < mu0 ->
  ((forall l, (if arrow K w (n l) (n (l + 1)%Z) then Plus else Minus) = g) -> one_motion O m mu d N) /\
  forall l, (if arrow K w (n l) (n (l + 1)%Z) then Plus else Minus) <> g ->
  forall t q v, ~ motion O m mu d N t q v.

(** ** The paper's oscillator, (65)-(67); its mu is minus ours, and e = -1 *)
Definition Nordmark (d w tau : R) : Oscillator.t := {|
  Oscillator.c := 2 * d / w; Oscillator.k := 1 / w ^ 2; Oscillator.tau := tau;
  Oscillator.G := fun mu t => (1 - mu) * (1 - cos t); Oscillator.G1 := fun mu t => (1 - mu) * sin t;
  Oscillator.G2 := fun mu t => (1 - mu) * cos t |}.

(** (72)-(74) for d < 1, and a motion word for word. *)
Definition Nordmark_statement : Prop := forall d w tau, 0 < w -> 0 <= tau ->
  (forall sigma, d < 1 -> 0 <= d -> sigma = sqrt (1 - d ^ 2) / w -> sin (2 * PI * sigma) <> 0 ->
   exists gamma, grazing (Nordmark d w tau) Plus (2 * exp (- 2 * PI * d / w) * cos (2 * PI * sigma))
     (exp (- 4 * PI * d / w)) gamma /\ 0 < gamma * sin (2 * PI * sigma)) /\
  forall mu r N t q v, motion (Nordmark d w tau) Plus (- mu) r N t q v <-> forall i j, j = (i + 1)%Z ->
  (forall x, derivable_pt_lim (q i) x (v i x) /\
   derivable_pt_lim (v i) x (- (2 * d / w) * v i x - 1 / w ^ 2 * q i x)) /\
  Rabs (t i - 2 * PI * IZR (N i)) <= r /\ t i < t j /\
  q i (t i) = (1 + mu) * cos (t i) - 1 /\ q i (t j) = (1 + mu) * cos (t j) - 1 /\
  (forall x, t i < x < t j -> q i x > (1 + mu) * cos x - 1) /\
  v i (t j) < - ((1 + mu) * sin (t j)) /\ v j (t j) = - tau * v i (t j) - (1 + tau) * (1 + mu) * sin (t j).

(** Stops with any harmonics, a_j (1 - cos j t) + b_j sin j t summed over a list of (a_j, b_j), that have their one
    top at 0. *)
Fixpoint harmonics (j : nat) (l : list (R * R)) (t : R) : R := match l with [] => 0
  | (a, b) :: l => a * (1 - cos (INR j * t)) + b * sin (INR j * t) + harmonics (S j) l t end.
Fixpoint weighted (j : nat) (l : list (R * R)) : R := match l with [] => 0
  | (a, _) :: l => INR j ^ 2 * a + weighted (S j) l end.
Definition Harmonics_statement : Prop := forall c k tau l, (forall t, 0 < t < 2 * PI -> 0 < harmonics 1 l t) ->
  0 < weighted 1 l -> exists O, touching O /\ Oscillator.c O = c /\ Oscillator.k O = k /\ Oscillator.tau O = tau /\
  forall mu t, Oscillator.G O mu t = harmonics 1 l t.
