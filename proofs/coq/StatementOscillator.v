(** * Statement: linear oscillators near grazing, their motions, and which (a1, a2) they have

    y'' = - c y' - k y between impacts, above a stop that moves with period 2 pi, or between two stops of
    which each is the mirror image of the other, half a period later. Lengths are measured from the motion
    without stops; for mu = 0 that motion touches. Complete on this page, but for [sign]. That the signs of
    (52) and (64) decide about the impacts is Theorem 1 of [Headline]. *)
From Coq Require Import Reals ZArith.
From Grazing Require Import Defs. (* for sign and sgn only *)
Open Scope R_scope.

(** The stop is - mu - G mu t, of velocity - G1 mu t; restitution tau. *)
Module Oscillator. Record t : Type := {
  c : R; k : R; tau : R; G : R -> R -> R; G1 : R -> R -> R; G2 : R -> R -> R }.
End Oscillator.

(** The stop has its one top at the time 0, for mu = 0 at positive acceleration relative to the motion; it may
    change its shape with mu. *)
Record touching (O : Oscillator.t) : Prop := {
  period : forall mu t, Oscillator.G O mu (t + 2 * PI) = Oscillator.G O mu t;
  slope : forall mu t, derivable_pt_lim (Oscillator.G O mu) t (Oscillator.G1 O mu t);
  bend : forall mu t, derivable_pt_lim (Oscillator.G1 O mu) t (Oscillator.G2 O mu t);
  touch : forall mu, Oscillator.G O mu 0 = 0;
  below : forall t, 0 < t < 2 * PI -> 0 < Oscillator.G O 0 t;
  sharp : continuity_pt (Oscillator.G2 O 0) 0 /\ 0 < Oscillator.G2 O 0 0;
  steady : exists K, forall mu t, Rabs mu <= 1 ->
    Rabs (Oscillator.G O mu t - Oscillator.G O 0 t) <= K * Rabs mu /\
    Rabs (Oscillator.G1 O mu t - Oscillator.G1 O 0 t) <= K * Rabs mu /\
    Rabs (Oscillator.G2 O mu t - Oscillator.G2 O 0 t) <= K * Rabs mu }.

(** m = Plus: one stop. m = Minus: two; those with odd z are above. Stop z touches at the time [turn m] z. *)
Definition turn (m : sign) : R := match m with Plus => 2 * PI | Minus => PI end.
Definition facing (m : sign) (z : Z) : R :=
  match m with Plus => 1 | Minus => if Z.even z then 1 else -1 end.
Definition gap (O : Oscillator.t) (m : sign) (mu : R) (z : Z) (y : R -> R) (t : R) : R :=
  facing m z * y t + mu + Oscillator.G O mu (t - turn m * IZR z).
Definition speed (O : Oscillator.t) (m : sign) (mu : R) (z : Z) (v : R -> R) (t : R) : R :=
  facing m z * v t + Oscillator.G1 O mu (t - turn m * IZR z).

Definition free (c k : R) (y v : R -> R) : Prop := forall t, derivable_pt_lim y t (v t) /\
  derivable_pt_lim v t (- c * v t - k * y t).

(** Between impact i, at the time t i, and the next, j, the oscillator moves as y i, v i. Impact i is on stop
    N i, within d of the time of touch; its speed V < 0 becomes - tau V. Strictly between impacts every gap is
    open. *)
Record swing (O : Oscillator.t) (m : sign) (mu d : R) (N : Z -> Z) (t : Z -> R) (y v : Z -> R -> R)
  (i j : Z) : Prop := {
  swing_free : free (Oscillator.c O) (Oscillator.k O) (y i) (v i);
  swing_near : Rabs (t i - turn m * IZR (N i)) <= d;
  swing_on : t i < t j;
  swing_from : gap O m mu (N i) (y i) (t i) = 0;
  swing_to : gap O m mu (N j) (y i) (t j) = 0;
  swing_clear : forall z x, t i < x < t j -> 0 < gap O m mu z (y i) x;
  swing_hits : speed O m mu (N j) (v i) (t j) < 0;
  swing_back : speed O m mu (N j) (v j) (t j) = - Oscillator.tau O * speed O m mu (N j) (v i) (t j) }.
Definition motion (O : Oscillator.t) (m : sign) (mu d : R) (N : Z -> Z) (t : Z -> R)
  (y v : Z -> R -> R) : Prop := forall i j, j = (i + 1)%Z -> swing O m mu d N t y v i j.
Definition one_motion (O : Oscillator.t) (m : sign) (mu d : R) (N : Z -> Z) : Prop := exists t y v,
  motion O m mu d N t y v /\ forall t' y' v', motion O m mu d N t' y' v' ->
  forall i x, t' i = t i /\ y' i x = y i x /\ v' i x = v i x.

(** The matrix A of one turn, reflected if there are two stops: its trace, its determinant and
    gamma = A_12. *)
Definition matrix (c k : R) (m : sign) (a1 a2 gamma : R) : Prop := exists A11 A21 A22,
  a1 = A11 + A22 /\ a2 = A11 * A22 - gamma * A21 /\ forall y v, free c k y v ->
  facing m 1 * y (turn m) = A11 * y 0 + gamma * v 0 /\ facing m 1 * v (turn m) = A21 * y 0 + A22 * v 0.
Record grazing (O : Oscillator.t) (m : sign) (a1 a2 gamma : R) : Prop := {
  is_touching : touching O;
  is_restitution : 0 <= Oscillator.tau O;
  is_matrix : matrix (Oscillator.c O) (Oscillator.k O) m a1 a2 gamma;
  is_generic : gamma <> 0 }.

(** Where the word is periodic, so is the one motion; between two stops it may be its own mirror image. *)
Definition Periodic_oscillator_statement : Prop := forall O m mu d N t y v (h P : Z), touching O ->
  one_motion O m mu d N -> motion O m mu d N t y v -> (forall i, N (i + h) = N i + P)%Z ->
  forall i x, t (i + h)%Z = t i + turn m * IZR P /\
  facing m P * y (i + h)%Z (x + turn m * IZR P) = y i x /\
    facing m P * v (i + h)%Z (x + turn m * IZR P) = v i x.

(** Which (a1, a2) occur. One stop: region 3 with either sign of gamma, a1 >= 2 sqrt a2 with gamma > 0, and
    nothing else: regions 4 and 5 are no one-stop oscillator's. With two stops they are some oscillator's. *)
Record reach : Prop := {
  one_stop : forall c k, exists a1 a2 gamma, matrix c k Plus a1 a2 gamma;
  reach_3 : forall r s g, 0 < r -> 0 < s < 1 / 2 -> exists c k gamma,
    matrix c k Plus (2 * r * cos (2 * PI * s)) (r ^ 2) gamma /\ sgn g * gamma > 0;
  reach_1_2 : forall a1 a2, 0 < a2 -> 2 * sqrt a2 <= a1 -> exists c k gamma,
    matrix c k Plus a1 a2 gamma /\ gamma > 0;
  no_more : forall c k a1 a2 gamma, matrix c k Plus a1 a2 gamma -> gamma <> 0 ->
    0 < a2 /\ - 2 * sqrt a2 < a1 /\ (2 * sqrt a2 <= a1 -> gamma > 0);
  reach_4_5 : forall a1 a2, 0 < a2 -> a1 <= - 2 * sqrt a2 -> exists c k gamma,
    matrix c k Minus a1 a2 gamma /\ gamma < 0 }.
Definition Reach_statement : Prop := reach.
