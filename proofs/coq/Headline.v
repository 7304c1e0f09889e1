(** * Headline: Theorem 1 in the plane, Theorem 2, Conjecture 1, the word theorem, chaos and an attractor

    Everything else in this folder is a lemma for one of these, or says more about one. They are about
    oscillators, linear or not, with one stop or two, from the differential equation and the law of impact, and
    about smooth grazing maps of the plane, in one breath: [system]. Of the linear ones, region 3 and a1 >= 2
    sqrt a2 have some with one stop; regions 4 and 5 have none but those with two, and these with gamma < 0
    alone ([Reach_statement]). Definitions to read first, and no more:
    - [Defs]: u_n, b_{n,k}, c_n of (59) and (60), and signs;
    - [motion] and [grazing] in [StatementOscillator]: an oscillator and where its impacts are;
    - [grazing_orbit], [generic] and [nonlinear_motion] in [StatementNonlinear]: the same, nonlinear;
    - [bouncing_orbit], [generic_round], [bouncing_motion] in [StatementBouncing]: with other impacts, or two stops;
    - [orbit_near] in [StatementOrbits], [planar] and [one_orbit] in [StatementOrbitsPlane]: maps, orbits;
    - [unstable] and [unstable_motion] in [StatementUnstable];
    - [trace], [Farey], [interval], [outside] and [tends_to_1] in [Statement]: Theorem 2's intervals of s;
    - [member], [edge], [path], [vertices], [arrow] and [ends] in [StatementWords];
    - [chaos_motion] and [in_two_boxes] in [StatementChaos], [Nordmark] in [StatementNordmark];
    - [StatementTrapped], for the attractor: all of it up to [Exponent_statement].
    The proofs end in [Systems], [SystemsAreas], [Conjecture1], [SystemsWords], [Chaos] and [TrappedAttracts], in this
    order. *)
From Coq Require Import Reals ZArith List Arith.
From Grazing Require Import Defs Statement StatementOrbits StatementOrbitsPlane StatementUnstable StatementWords
  StatementChaos StatementOscillator StatementNonlinear StatementBouncing.
Import ListNotations.
Open Scope R_scope.

(** ** Motions of a linear oscillator with stops m and of nonlinear ones, orbits of a map *)
Inductive system :=
| Oscillates (oscillator : Oscillator.t) (m : sign)
| Moves (oscillator : Nonlinear.t) (rate : R)
| Bounces (oscillator : Bouncing.t) (rate : R)
| Steps (map : Map.t) (rate : R) (w : vec).

(** Its linear part has trace a1 and determinant a2; gamma is A_12 or C A B. *)
Definition grazes (S : system) (a1 a2 gamma : R) : Prop := match S with
  | Oscillates osc m => grazing osc m a1 a2 gamma
  | Moves osc rate => grazing_orbit osc /\ generic osc a1 a2 gamma rate
  | Bounces osc rate => bouncing_orbit osc /\ generic_round osc a1 a2 gamma rate
  | Steps M rate w => planar M a1 a2 gamma rate w end.
(** e mu, where e is (26); the stop of a linear oscillator is measured so that e = 1. *)
Definition e_mu (S : system) (mu : R) : R :=
  match S with Oscillates _ _ => mu | Moves _ rate | Bounces _ rate | Steps _ rate _ => rate * mu end.

(** Exactly one motion has its impacts, and no others, n i periods after one another and within d of grazing,
    and it is unstable; none. Between two stops, m = Minus, n i counts half periods: [motion] has impact i
    within d of [turn m] (N i). *)
Definition one (S : system) (mu d : R) (n : Z -> nat) : Prop := match S with
  | Oscillates osc m => forall N, (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z -> one_motion osc m mu d N /\
    forall t y v, motion osc m mu d N t y v -> unstable_motion (swing osc m mu d N) t v
  | Moves osc _ => forall N, (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z -> one_nonlinear_motion osc mu d N /\
    forall t y v, nonlinear_motion osc mu d N t y v -> unstable_motion (leg osc mu d N) t v
  | Bounces osc _ => forall N, (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z -> one_bouncing_motion osc mu d N /\
    forall t y v, bouncing_motion osc mu d N t y v -> unstable_motion (bounces osc mu d N) t v
  | Steps M _ _ => one_orbit M Z (fun i => i + 1)%Z n mu d /\
    forall x i, orbit_near M Z (fun i => i + 1)%Z n mu d x -> unstable M mu (x i) end.
Definition none (S : system) (mu d : R) (n : Z -> nat) : Prop := match S with
  | Oscillates osc m => forall N t y v, (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z ->
    ~ motion osc m mu d N t y v
  | Moves osc _ => forall N t y v, (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z ->
    ~ nonlinear_motion osc mu d N t y v
  | Bounces osc _ => forall N t y v, (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z ->
    ~ bouncing_motion osc mu d N t y v
  | Steps M _ _ => forall x, ~ orbit_near M Z (fun i => i + 1)%Z n mu d x end.

(** ** Theorem 1 in the plane *)

(** (52) or (64) fails strictly where a flight of j periods follows one of i. *)
Definition breaks (a1 a2 : R) (e g : sign) (i j : nat) : Prop :=
  (exists k, (1 <= k <= i - 1)%nat /\ sgn e * b a1 a2 i k < 0) \/ sgn e * sgn g * (p a1 a2 j - q a1 a2 i) < 0.

(** One d, and for each eps one mu0, for all words over {n <= n_max : u_n <> 0}, periodic or not: the signs
    decide, and what they say there is lies within eps of grazing. *)
Definition Theorem_1_statement : Prop := forall S a1 a2 gamma, grazes S a1 a2 gamma -> forall n_max,
  exists d, d > 0 /\ forall eps, 0 < eps <= d -> exists mu0, mu0 > 0 /\ forall (n : Z -> nat) e g mu,
  (forall i, (1 <= n i <= n_max)%nat /\ u a1 a2 (n i) <> 0) -> sgn g * gamma > 0 ->
    0 < sgn e * e_mu S mu < mu0 ->
  ((forall i, member a1 a2 e (n i) /\ edge a1 a2 e g (n i) (n (i + 1)%Z)) -> one S mu eps n) /\
  ((exists i, breaks a1 a2 e g (n i) (n (i + 1)%Z)) -> none S mu d n).

(** Period n with one impact is born, or not, at mu = 0 on the side e: exactly in the case (e, g); in none. *)
Definition born (S : system) (n : nat) (e : sign) : Prop := exists d, d > 0 /\ forall eps, 0 < eps <= d ->
  exists mu0, mu0 > 0 /\ forall mu, 0 < sgn e * e_mu S mu < mu0 -> one S mu eps (fun _ => n).
Definition unborn (S : system) (n : nat) (e : sign) : Prop := exists d mu0, d > 0 /\ mu0 > 0 /\
  forall mu, 0 < sgn e * e_mu S mu < mu0 -> none S mu d (fun _ => n).
Definition exactly (a1 a2 : R) (n : nat) (e g : sign) : Prop := forall S gamma, grazes S a1 a2 gamma ->
  (sgn g * gamma > 0 -> born S n e) /\ forall e', ~ (e' = e /\ sgn g * gamma > 0) -> unborn S n e'.
Definition never (a1 a2 : R) (n : nat) : Prop := forall S gamma e, grazes S a1 a2 gamma -> unborn S n e.

(** ** Theorem 2: eigenvalues exp(+- 2 pi i s). Like Theorem 1 it is silent where u_n = 0, and where a b_{n,k}
    = 0 and no two of them have opposite signs: at the ends of the intervals. *)
Definition Theorem_2_statement : Prop := forall n s, (3 <= n)%nat -> 0 < s < 1 / 2 ->
  (forall e g lo hi, interval n e g lo hi -> lo < s < hi -> exactly (2 * cos (2 * PI * s)) 1 n e g) /\
  (outside n s -> u (2 * cos (2 * PI * s)) 1 n <> 0 -> never (2 * cos (2 * PI * s)) 1 n).

(** ** Conjecture 1: eigenvalues r exp(+- 2 pi i s), a1 = trace r s and a2 = r^2, and region 4. On the
    boundary of an area, where its b_{n,k} = 0, nothing is said of orbits. *)

(** The area over lo < s < hi is what lies above the graph of Rad, where b_{n,k} = 0 and no other b_{n,j}. *)
Definition area (n k : nat) (g : sign) (lo hi : R) (Rad : R -> R) : Prop := forall s, lo < s < hi ->
  0 <= Rad s < 1 /\ continuity_pt Rad s /\ forall r, 0 < r <= 1 -> u_at r s n <> 0 /\
  (Rad s < r -> exactly (trace r s) (r ^ 2) n Plus g) /\ (r < Rad s -> never (trace r s) (r ^ 2) n) /\
  (Rad s = r <-> b_at r s n k = 0) /\
  (Rad s = r -> forall j, (1 <= j <= n - 1)%nat -> j <> k -> b_at r s n j > 0).
(** It reaches no small r near its ends, and a circle meets it in one interval (lo', hi'). *)
Definition extends (n k : nat) (g : sign) (lo hi : R) : Prop := exists Rad,
  area n k g lo hi Rad /\ tends_to_1 Rad lo hi lo /\ tends_to_1 Rad lo hi hi /\
  forall r, 0 < r < 1 -> exists lo' hi', lo <= lo' /\ hi' <= hi /\
  forall s, lo < s < hi -> (Rad s < r <-> lo' < s < hi').
(** In a1 < hi, at a fixed determinant, the area is what lies left of a point, where b_{n,k} = 0 alone. *)
Definition ends_left (a2 hi : R) (n k : nat) : Prop := exists a1s, - (a2 + 1) < a1s < hi /\
  forall a1, - (a2 + 1) < a1 < hi -> u a1 a2 n <> 0 /\
  (a1 < a1s -> exactly a1 a2 n Plus Minus) /\ (a1s < a1 -> never a1 a2 n) /\ (a1s = a1 <-> b a1 a2 n k = 0) /\
  (a1s = a1 -> forall j, (1 <= j <= n - 1)%nat -> j <> k -> b a1 a2 n j > 0).

(** N is n. *)
Record areas (n : nat) (N : R) : Prop := {
  (** (0, 1/(2n)) extends to a (-,+) area bounded by 0 < s < 1/(2n). *)
  first_area : forall r s, 0 < r <= 1 -> 0 < s < 1 / (2 * N) -> exactly (trace r s) (r ^ 2) n Minus Plus;
  (** (1/(2n), 1/n) extends to a (+,+) area bounded to the left by b_{n,n-1} = 0, to the right by
      s = 1/(2n). *)
  second_area : exists Rad, area n (n - 1) Plus (1 / (2 * N)) (1 / N) Rad /\
    tends_to_1 Rad (1 / (2 * N)) (1 / N) (1 / N) /\
    (forall s, 1 / (2 * N) < s <= 1 / (2 * (N - 1)) -> Rad s = 0) /\
    forall r, 0 < r < 1 -> exists s', 1 / (2 * N) < s' <= 1 / N /\
    forall s, 1 / (2 * N) < s < 1 / N -> (Rad s < r <-> s < s');
  (** ((n-1)/(2n), 1/2), n odd, extends to a (+,-) area in regions 3 and 4, bounded to the left by
      -(a2+1) < a1 and to the right by b_{n,n-2} = 0. *)
  leftmost_area : Nat.Odd n -> (exists Rad, area n (n - 2) Minus ((N - 1) / (2 * N)) (1 / 2) Rad /\
      tends_to_1 Rad ((N - 1) / (2 * N)) (1 / 2) ((N - 1) / (2 * N))) /\
    forall a2, 0 < a2 < 1 -> ends_left a2 (trace (sqrt a2) ((N - 1) / (2 * N))) n (n - 2);
  (** (m+/n+, m/n), m+/n+ not 0/1, extends to a (+,+) area bounded by b_{n,n-n+} = 0. *)
  left_areas : forall m (F : Farey m n), (0 < 2 * m < n)%nat -> m_plus F <> 0%nat ->
    extends n (n - n_plus F) Plus (INR (m_plus F) / INR (n_plus F)) (INR m / N);
  (** (m/n, m-/n-), m-/n- not 1/2, extends to a (+,-) area bounded by b_{n,n-n-} = 0. *)
  right_areas : forall m (F : Farey m n), (0 < 2 * m < n)%nat -> (2 * m_minus F <> n_minus F)%nat ->
    extends n (n - n_minus F) Minus (INR m / N) (INR (m_minus F) / INR (n_minus F));
  (** There are no others: these are all of Theorem 2's intervals, and elsewhere in regions 3 and 4 there
      is none. *)
  no_others : forall e g lo hi, interval n e g lo hi -> (e, g, lo, hi) = (Minus, Plus, 0, 1 / (2 * N)) \/
    (e, g, lo, hi) = (Plus, Plus, 1 / (2 * N), 1 / N) \/
    Nat.Odd n /\ (e, g, lo, hi) = (Plus, Minus, (N - 1) / (2 * N), 1 / 2) \/
    exists m (F : Farey m n), (0 < 2 * m < n)%nat /\
    (m_plus F <> 0%nat /\ (e, g, lo, hi) = (Plus, Plus, INR (m_plus F) / INR (n_plus F), INR m / N) \/
     (2 * m_minus F <> n_minus F)%nat /\
       (e, g, lo, hi) = (Plus, Minus, INR m / N, INR (m_minus F) / INR (n_minus F)));
  none_in_3 : forall r s, 0 < r < 1 -> 0 < s < 1 / 2 -> u_at r s n <> 0 ->
    (forall e g lo hi, interval n e g lo hi -> ~ lo < s < hi) -> never (trace r s) (r ^ 2) n;
  none_in_4 : forall a1 a2, 0 < a2 < 1 -> - (a2 + 1) < a1 <= - 2 * sqrt a2 -> Nat.Even n -> never a1 a2 n }.
Definition Conjecture_1_statement : Prop := forall n, (3 <= n)%nat -> areas n (INR n).

(** ** Words, regions 3 and 4, e mu > 0. K is the first n with u_n < 0, w the way to s in the Stern-Brocot
    tree as long as the flights on it satisfy (52); with damping it ends. Its vertices are all that do, and
    its arrows say which may follow which: for gamma < 0, those that are none. *)
Definition Words_statement : Prop := forall a1 a2 K, first_upper a1 a2 K ->
  (a2 < 1 -> exists w i j, path a1 a2 K w i j /\ Forall (fun x => member a1 a2 Plus (fst x)) (vertices K w) /\
   ~ member a1 a2 Plus (i + j)) /\
  forall w i j, path a1 a2 K w i j -> Forall (fun x => member a1 a2 Plus (fst x)) (vertices K w) ->
    ends a1 a2 i j ->
  (forall n, member a1 a2 Plus n <-> In n (map fst (vertices K w))) /\
  forall S gamma, grazes S a1 a2 gamma -> exists d, d > 0 /\ forall eps, 0 < eps <= d ->
    exists mu0, mu0 > 0 /\
  forall (n : Z -> nat * letter) g mu, (forall l, In (n l) (vertices K w)) ->
  sgn g * gamma > 0 -> 0 < e_mu S mu < mu0 ->
  ((forall l, (if arrow K w (n l) (n (l + 1)%Z) then Plus else Minus) = g) ->
    one S mu eps (fun l => fst (n l))) /\
  ((exists l, (if arrow K w (n l) (n (l + 1)%Z) then Plus else Minus) <> g) ->
    none S mu d (fun l => fst (n l))).

(** ** Chaos: for every mu > 0 the paper's oscillator has impacts one or two periods apart in any order *)
Definition Chaos_statement : Prop := forall mu N, mu > 0 -> one_or_two N ->
  exists t y v, chaos_motion mu N t y v /\ in_two_boxes mu N t v /\
  forall t' y' v', chaos_motion mu N t' y' v' -> in_two_boxes mu N t' v' ->
  forall i x, t' i = t i /\ y' i x = y i x /\ v' i x = v i x.

(** ** The attractor: overdamped, above a stop of one hump, beyond the touch

    A machine M of [StatementTrapped]; x is measured from its motion without the stop. The fields are the
    sentences that `grazing check` prints of a certificate of kind attractor (STATEMENT in
    crates/checker/src/attractor/mod.rs), each before its field. Its q, Q and D are x, Q M and [trapped M]: S sqrt
    nu and Z nu are Vm M and zm M; its X is [starts]. "Small displacements" change by the matrices of
    [returns], which are derivatives ([Derivative_statement]); [D_parts] says the same of two motions. "Almost
    all" is said of the velocities at each time and place, and means all but countably many. Of certificates with
    cells (version 2) nothing is here. *)
From Grazing Require Import StatementTrapped.

Record attracts (M : machine) (lo hi E starts : R) : Prop := {
  (** "After a contact in D the motion is free for a time, until a next contact, which is in D." *)
  D_kept : forall t V, trapped M t V -> (exists t' V' x v, leg M t V t' V' x v) /\
    forall t' V' x v, leg M t V t' V' x v -> trapped M t' V';
  (** "Every motion that begins at a time at which Q <= 0, with q >= 0 and 0 <= a q + q' <= X, is in D from its
      third contact on." *)
  D_catches : forall s x v, Q M s <= 0 -> free (a M + b M) (a M * b M) x v -> 0 <= x s ->
    0 <= a M * x s + v s <= starts ->
    (exists t V, arrives M s t V x v) /\ forall t V, arrives M s t V x v -> third M t V;
  (** "Small displacements of q and q' at a fixed time, just before a contact in D that is no graze, for which
      neither that of q nor that of a q + q' is below 0, become, but for their sign, such displacements just
      before the next contact, and that of q grows E-fold at least." *)
  D_stretches : forall t V t' V' x v d w d' w', trapped M t V -> V < 0 -> leg M t V t' V' x v ->
    returns M (t' - t) t V d w d' w' -> cone M d w -> cone M d' w' /\ E * Rabs d <= Rabs d';
  (** Two motions x <= x' with the same passes, just before the later one has hit: they change order and part. *)
  D_parts : forall N t V x v t' V' x' v' i, stays M lo hi N t V x v -> stays M lo hi N t' V' x' v' ->
    let s := t' (S i) in t (S i) <= s -> 0 <= x' i s - x i s ->
    0 <= a M * (x' i s - x i s) + (v' i s - v i s) ->
    let r := t (S (S i)) in t' (S (S i)) <= r /\ E * (x' i s - x i s) <= x (S i) r - x' (S i) r /\
    0 <= a M * (x (S i) r - x' (S i) r) + (v (S i) r - v' (S i) r);
  (** "No periodic motion whose contacts are in D, grazing or not, is stable in Lyapunov's sense." *)
  D_unstable : 0 < tau M -> forall K P N t V x v, (1 <= K)%nat -> stays M lo hi N t V x v ->
    periodic M K P N t V -> not_stable M lo hi t V x;
  (** "Every motion whose contacts are in D and no grazes has a positive Lyapunov exponent;" *)
  D_grows : exists theta, 0 < theta /\ grow M lo hi theta;
  (** "where an exponent R is listed with a nu, from that nu on it is at least R in each period 2 pi." *)
  D_grows_by : forall theta m, by_passes M theta m -> grow M lo hi theta;
  (** "Of the motions that begin as said almost all never graze." *)
  D_grazes : forall s q, Q M s <= 0 <= q -> Q M s < q -> few_graze M lo hi starts s q }.
(** Where all returns stretch; and such are (65)-(67), d > 1, for all small mu, if a period leaves more than 2/3
    of a slow motion. *)
Definition Attractor_statement : Prop :=
  (forall M lo hi E starts, chaotic M lo hi E -> begins M starts -> attracts M lo hi E starts) /\
  forall d w tau, 1 < d -> 0 < w -> 0 <= tau -> 2 / 3 < exp (- a (paper d w tau 1 1 1) * (2 * PI)) ->
  exists E Z S mu1, mu1 > 0 /\ forall mu, 0 < mu <= mu1 ->
  chaotic (paper d w tau mu Z S) (- acos (/ (1 + mu))) (acos (/ (1 + mu))) E.
