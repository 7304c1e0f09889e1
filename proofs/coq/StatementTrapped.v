(** * Statement: an overdamped linear oscillator above a stop of one hump is trapped beyond the touch, and no
    periodic motion there is stable

    x'' = - (a + b) x' - a b x between impacts, 0 < a < b, above a stop x >= Q t of period p; a force that
    depends on the time alone is part of Q. A contact is a time and the relative velocity V <= 0 there; after
    it the relative velocity is - tau V. V = 0 (a graze) changes nothing. zm and Vm are bounds of a set of
    contacts ([trapped]). Complete on this page, but for [free]. *)
From Coq Require Import Reals ZArith.
From Grazing Require Import StatementOscillator. (* for free only *)
Open Scope R_scope.

Record machine : Type := { a : R; b : R; tau : R; p : R; W : R; mu : R; al0 : R; al1 : R;
  zm : R; Vm : R; Q : R -> R; Q1 : R -> R; Q2 : R -> R }.

(** In each period the stop is >= 0 in [lo, hi] alone, is bent there, and reaches mu > 0. *)
Record hump (M : machine) (lo hi : R) : Prop := {
  overdamped : 0 < a M < b M;
  restitution : 0 <= tau M;
  beyond : 0 < mu M;
  period : forall t, Q M (t + p M) = Q M t;
  slope : forall t, derivable_pt_lim (Q M) t (Q1 M t);
  bend : forall t, derivable_pt_lim (Q1 M) t (Q2 M t);
  width : lo <= hi <= lo + W M;
  narrow : W M < p M;
  below : forall t, hi < t < lo + p M -> Q M t < 0;
  bent : forall t, lo <= t <= hi -> al0 M <= - Q2 M t <= al1 M;
  rounded : 0 < al0 M;
  highest : forall t, Q M t <= mu M;
  reached : exists t, Q M t = mu M }.

(** ** The constants

    The flow: x(T) = phi11 T x(0) + phi12 T x'(0), and x'(T) from phi21, phi22. [ell n] is the least value of
    phi12 on [p n - W, p n + W]. *)
Section Constants.
Variables (M : machine).
Definition phi11 (T : R) : R := (b M * exp (- a M * T) - a M * exp (- b M * T)) / (b M - a M).
Definition phi12 (T : R) : R := (exp (- a M * T) - exp (- b M * T)) / (b M - a M).
Definition phi21 (T : R) : R := - (a M * b M) * phi12 T.
Definition phi22 (T : R) : R := (b M * exp (- b M * T) - a M * exp (- a M * T)) / (b M - a M).
Definition ell (n : R) : R := Rmin (phi12 (p M * n - W M)) (phi12 (p M * n + W M)).

(** The least zm: what is left of a x + x' at the next contact. |V| <= V1 where that is one period on. How
    strongly the gap opens: alb, before a contact if one would follow the motion after it backwards, and alo,
    after a contact. [deep]: how far below the stop the motion before a contact would go; hence the least Vm.
    Ql: how high the stop is at a contact. *)
Definition least_slip : R := mu M * (b M - a M) / (exp ((b M - a M) * (p M - W M)) - 1).
Definition V1 : R := mu M / ((1 + tau M) * ell 1).
Definition alM : R := al1 M + a M ^ 2 * (mu M + zm M / (b M - a M)).
Definition alb : R := al0 M - b M ^ 2 * exp (b M * W M) * (zm M + (1 + tau M) * V1) / (b M - a M).
Definition deep : R :=
  (1 - exp (- a M * p M)) * mu M + exp (- a M * p M) * (tau M ^ 2 * V1 ^ 2 / (2 * alb)).
Definition least_speed : R := sqrt (2 * alM * deep).
Definition alo : R := al0 M - b M ^ 2 * (zm M + (1 + tau M) * Vm M) / (b M - a M).
Definition sigma : R := tau M * (al0 M - b M ^ 2 * zm M / (b M - a M)) + alo.
Definition Ql : R := mu M - Rmax (Vm M + zm M) (a M * mu M) ^ 2 / (2 * al0 M).

(** By what two motions separate from one contact to the next, n periods on: either number is a lower bound.
    *)
Definition A_ (n : R) : R := sigma * ell n / Vm M.
Definition B_ (n : R) : R := sigma * (Ql - phi11 (p M * n - W M) * mu M) / (((1 + tau M) * Vm M + zm M) * Vm M).
Definition stretches (E : R) (n : Z) : Prop := E <= A_ (IZR n) \/ E <= B_ (IZR n).

(** ** The set of contacts, and motions from contact to contact *)
Definition zeta (t V : R) : R := a M * Q M t + Q1 M t + V.
Definition within (z w t V : R) : Prop := 0 <= Q M t /\ - w <= V <= 0 /\ 0 <= zeta t V <= z.
Definition trapped (t V : R) : Prop := within (zm M) (Vm M) t V.

(** From the contact (t, V) the free motion x, v leads to the next, (t', V'). *)
Record leg (t V t' V' : R) (x v : R -> R) : Prop := {
  leg_free : free (a M + b M) (a M * b M) x v;
  leg_from : x t = Q M t;
  leg_back : v t = Q1 M t - tau M * V;
  leg_on : t < t';
  leg_clear : forall s, t < s < t' -> Q M s < x s;
  leg_to : x t' = Q M t';
  leg_hits : V' = v t' - Q1 M t' }.
End Constants.

(** Pass k is the interval [lo, hi] shifted by k periods. *)
Definition in_pass (M : machine) (lo hi : R) (k : Z) (t : R) : Prop :=
  lo + p M * IZR k <= t <= hi + p M * IZR k.
(** A motion from a first contact on: contacts t i, V i in pass N i, the motion x i, v i after them. *)
Definition motion (M : machine) (lo hi : R) (N : nat -> Z) (t V : nat -> R) (x v : nat -> R -> R) : Prop :=
  forall i, in_pass M lo hi (N i) (t i) /\ leg M (t i) (V i) (t (S i)) (V (S i)) (x i) (v i).
(** One that stays in the set. *)
Definition stays (M : machine) (lo hi : R) (N : nat -> Z) (t V : nat -> R) (x v : nat -> R -> R) : Prop :=
  motion M lo hi N t V x v /\ forall i, trapped M (t i) (V i).
(** K contacts and P periods on, the motion is the same. *)
Definition periodic (M : machine) (K : nat) (P : Z) (N : nat -> Z) (t V : nat -> R) : Prop :=
  forall i, N (i + K)%nat = (N i + P)%Z /\ t (i + K)%nat = t i + p M * IZR P /\ V (i + K)%nat = V i.

(** ** (i): the set is kept. The next contact exists, lies in a later pass and is in the set *)
Record opens (M : machine) (lo hi : R) : Prop := {
  is_hump : hump M lo hi;
  opens_before : 0 < alb M /\ least_slip M <= zm M /\ least_speed M <= Vm M;
  opens_after : 0 < alo M }.
Definition Trapped_statement : Prop := forall M lo hi, opens M lo hi -> forall t V, trapped M t V ->
  (exists t' V' x v, leg M t V t' V' x v) /\ exists k, in_pass M lo hi k t /\
  forall t' V' x v, leg M t V t' V' x v ->
  trapped M t' V' /\ exists n, (1 <= n)%Z /\ in_pass M lo hi (k + n) t'.
(** So each of its contacts is the first of a motion that stays. *)
Definition Exists_statement : Prop := forall M lo hi, opens M lo hi -> forall t0 V0, trapped M t0 V0 ->
  exists N t V x v, stays M lo hi N t V x v /\ t 0%nat = t0 /\ V 0%nat = V0.

(** ** (ii): it absorbs. From a contact within bounds z, w the next but one is in the set *)
Definition Absorbed_statement : Prop := forall M lo hi z w t V t1 V1 x v t2 V2 y u,
  opens M lo hi -> let fast := sqrt (2 * alM M * mu M) in
  0 < al0 M - b M ^ 2 * (z + (1 + tau M) * w) / (b M - a M) ->
  0 < al0 M - b M ^ 2 * (zm M + (1 + tau M) * fast) / (b M - a M) ->
  within M z w t V -> leg M t V t1 V1 x v -> leg M t1 V1 t2 V2 y u ->
  within M (zm M) fast t1 V1 /\ trapped M t2 V2.
(** A motion that begins at the time s, where the stop is not above 0, with x >= 0 and 0 <= a x + x' <= z,
    comes to a first contact (t, V), then to a second, and the third is in the set. *)
Definition begins (M : machine) (z : R) : Prop := zm M <= z /\ 0 < al0 M - b M ^ 2 * (z + (1 + tau M) *
  sqrt (2 * (al1 M + a M ^ 2 * (mu M + z / (b M - a M))) * mu M)) / (b M - a M).
Record arrives (M : machine) (s t V : R) (x v : R -> R) : Prop := {
  arrives_on : s <= t;
  arrives_clear : forall r, s < r < t -> Q M r < x r;
  arrives_to : x t = Q M t;
  arrives_hits : V = v t - Q1 M t;
  arrives_down : V <= 0 }.
Definition third (M : machine) (t V : R) : Prop := (exists t1 V1 x v, leg M t V t1 V1 x v) /\
  forall t1 V1 x v, leg M t V t1 V1 x v -> (exists t2 V2 y u, leg M t1 V1 t2 V2 y u) /\
  forall t2 V2 y u, leg M t1 V1 t2 V2 y u -> trapped M t2 V2.
Definition Started_statement : Prop := forall M lo hi z s x v, opens M lo hi -> begins M z -> Q M s <= 0 ->
  free (a M + b M) (a M * b M) x v -> 0 <= x s -> 0 <= a M * x s + v s <= z ->
  (exists t V, arrives M s t V x v) /\ forall t V, arrives M s t V x v -> third M t V.

(** At one time and place, above the stop, motions that begin so are told apart by their velocities u s. All
    but countably many never graze. *)
Definition few_graze (M : machine) (lo hi z s q : R) : Prop := exists f : nat -> R, forall y u N t V x v,
  free (a M + b M) (a M * b M) y u -> y s = q -> 0 <= a M * q + u s <= z ->
  arrives M s (t 0%nat) (V 0%nat) y u -> motion M lo hi N t V x v ->
  (exists i, V i = 0) -> exists n, u s = f n.
Definition Almost_statement : Prop := forall M lo hi z s q, opens M lo hi -> begins M z ->
  Q M s <= 0 <= q -> Q M s < q -> few_graze M lo hi z s q.

(** ** (iii): displacements (d, w) of position and velocity at fixed time, in a cone

    At the contact they change as by the law of impact, and then as the flow says, to just before the next. *)
Definition cone (M : machine) (d w : R) : Prop := 0 <= d /\ 0 <= a M * d + w \/ d <= 0 /\ a M * d + w <= 0.
Definition acc (M : machine) (t v : R) : R := - (a M + b M) * v - a M * b M * Q M t - Q2 M t.
Definition jump (M : machine) (t V : R) : R := tau M * acc M t (Q1 M t + V) + acc M t (Q1 M t - tau M * V).
Definition Cone_statement : Prop := forall M lo hi, opens M lo hi ->
  forall t V t' V' x v k n d w E, trapped M t V -> V < 0 -> leg M t V t' V' x v -> in_pass M lo hi k t ->
  in_pass M lo hi (k + n) t' -> stretches M E n -> cone M d w ->
  let d1 := - tau M * d in let w1 := - tau M * w + jump M t V * d / V in
  let d2 := phi11 M (t' - t) * d1 + phi12 M (t' - t) * w1 in
  let w2 := phi21 M (t' - t) * d1 + phi22 M (t' - t) * w1 in
  cone M d1 w1 /\ cone M d2 w2 /\ E * Rabs d <= Rabs d2.

(** This is what a small displacement (d, w) of the motion before an impact, at its time t, does to the one
    after it: the derivative. [through]: x before the contact, X after it, both as if they were free. *)
Definition through (M : machine) (t : R) (x v X U : R -> R) : Prop :=
  free (a M + b M) (a M * b M) x v /\ free (a M + b M) (a M * b M) X U /\
  x t = Q M t /\ X t = Q M t /\ U t = Q1 M t - tau M * (v t - Q1 M t).
Definition Derivative_statement : Prop := forall M lo hi t V x v X U, hump M lo hi -> through M t x v X U ->
  V = v t - Q1 M t -> V < 0 -> forall eps, 0 < eps -> exists r, 0 < r /\
  forall t1 y u Y W, through M t1 y u Y W -> Rabs (t1 - t) <= r -> let d := y t - x t in let w := u t - v t in
  Rabs (Y t - X t - - tau M * d) <= eps * (Rabs d + Rabs w) /\
  Rabs (W t - U t - (- tau M * w + jump M t V * d / V)) <= eps * (Rabs d + Rabs w).

(** ** (iii) and (iv), where all returns stretch by E > 1 *)
Record chaotic (M : machine) (lo hi E : R) : Prop := {
  chaotic_opens : opens M lo hi;
  chaotic_more : 1 < E;
  chaotic_stretches : forall n, (1 <= n)%Z -> stretches M E n }.
(** Two motions in the order of the cone that are not the same separate: they cannot have the same passes for
    ever, grazing or not. *)
Definition Separate_statement : Prop := forall M lo hi E, chaotic M lo hi E ->
  forall N t V x v t' V' x' v', stays M lo hi N t V x v -> stays M lo hi N t' V' x' v' ->
  forall s, t 0%nat <= s < t 1%nat -> t' 0%nat <= s < t' 1%nat ->
  0 <= x' 0%nat s - x 0%nat s -> 0 <= a M * (x' 0%nat s - x 0%nat s) + (v' 0%nat s - v 0%nat s) ->
  x' 0%nat s = x 0%nat s /\ v' 0%nat s = v 0%nat s.
(** No periodic motion, grazing or not, is stable in Lyapunov's sense: at one of its contacts motions leave
    with almost its speed that are, at some time, eps away. *)
Definition not_stable (M : machine) (lo hi : R) (t V : nat -> R) (x : nat -> R -> R) : Prop :=
  exists i0 eps, 0 < eps /\ forall d, 0 < d -> exists N' t' V' x' v', stays M lo hi N' t' V' x' v' /\
  t' 0%nat = t i0 /\ Rabs (V' 0%nat - V i0) <= d /\
  exists i j s, t i <= s <= t (S i) /\ t' j <= s <= t' (S j) /\ eps < Rabs (x' j s - x i s).
Definition No_stable_statement : Prop := forall M lo hi E, chaotic M lo hi E -> 0 < tau M ->
  forall K P N t V x v, (1 <= K)%nat -> stays M lo hi N t V x v -> periodic M K P N t V ->
  not_stable M lo hi t V x.

(** ** (iv), the exponent: along a motion that never grazes, displacements of the cone grow by exp (theta) a
    period

    [returns]: what (iii) does to a displacement, from just before a contact to just before the next. [brief]:
    the next contact is at most m passes on. *)
Record returns (M : machine) (T t V d w d' w' : R) : Prop := {
  return_d : d' = phi11 M T * (- tau M * d) + phi12 M T * (- tau M * w + jump M t V * d / V);
  return_w : w' = phi21 M T * (- tau M * d) + phi22 M T * (- tau M * w + jump M t V * d / V) }.
Record brief (M : machine) (m : Z) : Prop := {
  some_pass : (1 <= m)%Z;
  is_low : let T := p M * IZR m - W M in
    phi11 M T * mu M + exp (- a M * T) * ((1 + tau M) * Vm M + zm M) / (b M - a M) < mu M }.
Definition grow (M : machine) (lo hi theta : R) : Prop :=
  forall N t V x v d w, stays M lo hi N t V x v -> (forall i, V i < 0) ->
  (forall i, returns M (t (S i) - t i) (t i) (V i) (d i) (w i) (d (S i)) (w (S i))) ->
  cone M (d 0%nat) (w 0%nat) ->
  forall i, exp (theta * IZR (N i - N 0%nat)) * Rabs (d 0%nat) <= Rabs (d i).
Definition by_passes (M : machine) (theta : R) (m : Z) : Prop :=
  brief M m /\ forall n, (1 <= n <= m)%Z -> stretches M (exp (theta * IZR n)) n.
Definition Exponent_statement : Prop := forall M lo hi, opens M lo hi ->
  (forall theta m, by_passes M theta m -> grow M lo hi theta) /\
  forall E, chaotic M lo hi E -> exists theta, 0 < theta /\ grow M lo hi theta.

(** ** (v): finitely many n decide, and for all smaller mu at once

    The constants depend on the numbers of a machine alone. L has worse ones than M: they need not be a
    machine's. The set is measured by mu and its root. *)
Record worse (L M : machine) : Prop := {
  same_flow : a M = a L /\ b M = b L;
  same_law : tau M = tau L /\ p M = p L;
  more_mu : mu M <= mu L;
  more_W : W M <= W L;
  more_bent : al0 L <= al0 M /\ al1 M <= al1 L;
  same_set : exists Z S, zm M = Z * mu M /\ zm L = Z * mu L /\ Vm M = S * sqrt (mu M) /\
    Vm L = S * sqrt (mu L) }.
Record checked (L : machine) (E : R) (m : Z) : Prop := {
  is_narrow : W L < p L;
  is_rounded : 0 < al0 L;
  is_open_before : 0 < alb L /\ least_slip L <= zm L /\ least_speed L <= Vm L;
  is_open_after : 0 < alo L;
  is_more : 1 < E;
  is_some : (1 <= m)%Z;
  first_ones : forall n, (1 <= n < m)%Z -> stretches L E n;
  all_others : E <= B_ L (IZR m) }.
Definition Range_statement : Prop := forall L E m M lo hi, checked L E m -> hump M lo hi -> worse L M ->
  chaotic M lo hi E.

(** ** The paper's oscillator (65)-(67), overdamped; its mu is minus ours *)
Definition paper (d w tau mu Z S : R) : machine := {|
  a := (d - sqrt (d ^ 2 - 1)) / w; b := (d + sqrt (d ^ 2 - 1)) / w; tau := tau; p := 2 * PI;
  W := 2 * acos (/ (1 + mu)); mu := mu; al0 := 1; al1 := 1 + mu; zm := Z * mu; Vm := S * sqrt mu;
  Q := fun t => (1 + mu) * cos t - 1; Q1 := fun t => - (1 + mu) * sin t; Q2 := fun t => - (1 + mu) * cos t |}.
Definition Paper_statement : Prop := forall d w tau mu Z S, 1 < d -> 0 < w -> 0 <= tau -> 0 < mu ->
  let M := paper d w tau mu Z S in a M + b M = 2 * d / w /\ a M * b M = 1 / w ^ 2 /\
  hump M (- acos (/ (1 + mu))) (acos (/ (1 + mu))).
(** An example, by numbers: d = 3/2, w = 8, tau = 4/5, to mu = 1/10. *)
Definition Example_statement : Prop := forall mu, 0 < mu <= 1 / 10 ->
  chaotic (paper (3 / 2) 8 (4 / 5) mu (78665 / 1000000) (757575 / 1000000)) (- acos (/ (1 + mu)))
    (acos (/ (1 + mu))) (201 / 200).

(** ** (vi): for small mu, all E < l / (2 (1 - l)), where l is what a period leaves of a slow motion. There
    are such E > 1 if l > 2/3 *)
Definition Small_statement : Prop := forall d w tau E, 1 < d -> 0 < w -> 0 <= tau ->
  let l := exp (- a (paper d w tau 1 1 1) * (2 * PI)) in 1 < E < l / (2 * (1 - l)) ->
  exists Z S mu1, mu1 > 0 /\ forall mu, 0 < mu <= mu1 ->
  chaotic (paper d w tau mu Z S) (- acos (/ (1 + mu))) (acos (/ (1 + mu))) E.
