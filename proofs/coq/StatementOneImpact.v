(** * Statement: what a linear oscillator's motions with one impact in n turns need, for every mu

    Theorem 1 is about small mu, and needs that no b_{n,k} is 0. Here the stops of [StatementOscillator] may have any
    shape and be anywhere: k turns after such an impact, at its phase, the gap is a multiple of b_{n,k}. So (52) is
    needed for every mu, and where b_{n,k} = 0 the stop is met there. Read [swing] in [StatementOscillator] first. *)
From Coq Require Import Reals ZArith.
From Grazing Require Import Defs StatementOscillator.
Open Scope R_scope.

(** The impact after impact i is n turns later, and what follows it is the same; between two stops it is the mirror
    image if n is odd. *)
Record comes_again (O : Oscillator.t) (m : sign) (n : nat) (mu d : R) (N : Z -> Z) (t : Z -> R) (y v : Z -> R -> R)
  (i : Z) : Prop := {
  again_swing : swing O m mu d N t y v i (i + 1);
  again_turns : N (i + 1)%Z = (N i + Z.of_nat n)%Z;
  again_phase : t (i + 1)%Z = t i + turn m * INR n;
  again_velocity : facing m (Z.of_nat n) * v (i + 1)%Z (t (i + 1)%Z) = v i (t i) }.

(** The gap k turns after impact i; V < 0 is the speed of the impact after it. *)
Definition Gap_statement : Prop := forall O m a1 a2 gamma n mu d N t y v i,
  matrix (Oscillator.c O) (Oscillator.k O) m a1 a2 gamma -> u a1 a2 n <> 0 -> comes_again O m n mu d N t y v i ->
  let V := speed O m mu (N (i + 1)%Z) (v i) (t (i + 1)%Z) in forall k, (k <= n)%nat ->
  c a1 a2 n * gap O m mu (N i + Z.of_nat k) (y i) (t i + turn m * INR k) =
    - (1 + Oscillator.tau O) * V * gamma * b a1 a2 n k.

(** So b_{n,k} has the sign of gamma c_n for all k, or there is none: at no mu, of no speed. *)
Definition Every_mu_statement : Prop := forall O m a1 a2 gamma n,
  matrix (Oscillator.c O) (Oscillator.k O) m a1 a2 gamma -> 0 <= Oscillator.tau O ->
  u a1 a2 n <> 0 -> c a1 a2 n <> 0 ->
  forall k, (1 <= k <= n - 1)%nat -> gamma * c a1 a2 n * b a1 a2 n k <= 0 ->
  forall mu d N t y v i, ~ comes_again O m n mu d N t y v i.
