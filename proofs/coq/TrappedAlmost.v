(** * Almost all motions never graze: of those with the same passes up to a graze there is one at each place and time

    The one below would graze first; then the other, above it, does not come down in this pass. So the passes up to a
    graze tell a motion, and there are countably many. *)
From Coq Require Import Reals ZArith Lra Lia Cantor.
From Grazing Require Import Contraction StatementOscillator.
From Grazing Require Import StatementTrapped TrappedCalculus TrappedFlow TrappedReturn TrappedMain TrappedUnstable
  TrappedStarts.
Open Scope R_scope.

(** Passes as numbers. *)
Definition number (z : Z) : nat := to_nat (Z.to_nat z, Z.to_nat (- z)).
Fixpoint code (N : nat -> Z) (k : nat) : nat := match k with O => number (N 0%nat) | S j =>
  to_nat (code N j, number (N k)) end.
Lemma to_nat_inj p q : to_nat p = to_nat q -> p = q.
Proof. intros E; rewrite <- (cancel_of_to p), E; apply cancel_of_to. Qed.
Lemma number_inj y z : number y = number z -> y = z.
Proof. unfold number; intros E; apply to_nat_inj in E; injection E; lia. Qed.
Lemma code_inj N N' k : code N k = code N' k -> forall i, (i <= k)%nat -> N i = N' i.
Proof.
  induction k as [|k IH]; intros E i Hi.
  - replace i with 0%nat by lia; apply number_inj, E.
  - cbn [code] in E; apply to_nat_inj in E; injection E as E1 E2; destruct (Nat.eq_dec i (S k)) as [->|Ne]; [apply
      number_inj, E2|apply IH; [exact E1|lia]].
Qed.

Section Almost.
Variables (M : machine) (lo hi z s q : R).
Hypothesis Ho : opens M lo hi.
Hypothesis B : begins M z.
Hypothesis Qs : Q M s <= 0 <= q.
Hypothesis Qq : Q M s < q.
Let H := is_hump _ _ _ Ho.
Let Hab := overdamped _ _ _ H.
Notation w := (sqrt (2 * (al1 M + a M ^ 2 * (mu M + z / (b M - a M))) * mu M)).
Notation motion_free := (free (a M + b M) (a M * b M)).
Let Op : 0 < al0 M - b M ^ 2 * (z + (1 + tau M) * w) / (b M - a M) := proj2 B.

Record run : Type := { ry : R -> R; ru : R -> R; rN : nat -> Z; rt : nat -> R; rV : nat -> R; rx : nat -> R -> R;
  rv : nat -> R -> R }.
Record runs (m : run) : Prop := { run_free : motion_free (ry m) (ru m); run_at : ry m s = q;
  run_slip : 0 <= a M * q + ru m s <= z; run_first : arrives M s (rt m 0%nat) (rV m 0%nat) (ry m) (ru m); run_on :
  motion M lo hi (rN m) (rt m) (rV m) (rx m) (rv m) }.
(** The arc before contact i, and from when on. *)
Definition arc m i := match i with O => ry m | S j => rx m j end.
Definition arc' m i := match i with O => ru m | S j => rv m j end.
Definition from m i := match i with O => s | S j => rt m j end.
Lemma run_within m i : runs m -> within M z w (rt m i) (rV m i).
Proof.
  intros [F A Z Ar Mo]; induction i as [|i IH].
  - apply (arrives_within M lo hi Ho z s (ry m) (ru m)); trivial; [lra|unfold zet; rewrite A; exact Z].
  - apply (stays_within M lo hi Ho z B _ _ _ _ _ _ IH (proj2 (Mo i))).
Qed.
Lemma run_arc m i : runs m -> motion_free (arc m i) (arc' m i) /\ from m i < rt m i /\ (forall r, from m i < r < rt m
  i -> Q M r < arc m i r) /\ arc m i (rt m i) = Q M (rt m i) /\ rV m i = arc' m i (rt m i) - Q1 M (rt m i).
Proof.
  intros [F A Z [L Cl To Hi _] Mo]; destruct i as [|i].
  - refine (conj F (conj _ (conj Cl (conj To Hi)))); destruct L as [L|L]; [exact L|]; cbn in *; rewrite <- L, A in To;
      lra.
  - destruct (Mo i) as [_ [F' _ _ L' Cl' To' Hi']]; exact (conj F' (conj L' (conj Cl' (conj To' Hi')))).
Qed.
Definition under (A A' C C' : R -> R) (r : R) : Prop := 0 <= C r - A r /\ 0 <= zet M C C' r - zet M A A' r /\
  (0 < C r - A r \/ 0 < zet M C C' r - zet M A A' r).
Lemma above A A' C C' r y : motion_free A A' -> motion_free C C' -> under A A' C C' r -> r < y -> A y < C y.
Proof.
  intros FA FC (U1 & U2 & U3) L; destruct (keep M lo hi H A A' C C' r y FA FC ltac:(lra)) as [K _].
  pose proof (phi12_strict M lo hi H (y - r) ltac:(lra)); pose proof (exp_pos (- a M * (y - r))); destruct U3 as
    [U3|U3].
  - assert (0 < exp (- a M * (y - r)) * (C r - A r)) by (apply Rmult_lt_0_compat; lra); assert (0 <= phi12 M (y - r) *
      (zet M C C' r - zet M A A' r)) by (apply Rmult_le_pos; lra); lra.
  - assert (0 <= exp (- a M * (y - r)) * (C r - A r)) by (apply Rmult_le_pos; lra); assert (0 < phi12 M (y - r) * (zet
      M C C' r - zet M A A' r)) by (apply Rmult_lt_0_compat; lra); lra.
Qed.
Definition below m m' i : Prop := exists r, from m i <= r < rt m i /\ from m' i <= r < rt m' i /\
  under (arc m i) (arc' m i) (arc m' i) (arc' m' i) r.
Lemma rising m i : runs m -> (rN m i < rN m (S i))%Z.
Proof.
  intros R; pose proof (run_within m i R) as Hw; destruct (run_on m R i) as [P L], (run_on m R (S i)) as [P1 _].
  destruct (return_to M lo hi H (opens_before _ _ _ Ho) (rN m i) _ _ _ _ _ _ z w P Hw Op L) as (_ & _ & _ & _ & n & Hn
    & Pn). rewrite (one_pass M lo hi H _ _ _ P1 Pn); lia.
Qed.
Lemma step m m' i : runs m -> runs m' -> below m m' i -> rN m i = rN m' i -> rV m i <> 0 /\
  (rN m (S i) = rN m' (S i) -> below m' m (S i)).
Proof.
  intros R R' (r & L & L' & U) EN; destruct (run_arc m i R) as (F & _ & Cl & To & Hi), (run_arc m' i R') as (F' & _ &
    Cl' & To' & Hi'). pose proof (run_within m i R) as W; destruct (run_on m R i) as [P Leg], (run_on m' R' i) as [P'
    Leg']; rewrite <- EN in P'. pose proof (fun y => above _ _ _ _ r y F F' U) as Ab; assert (LT : rt m i < rt m' i).
  { apply Rnot_le_lt; intros C; specialize (Ab (rt m' i) ltac:(lra)); destruct C as [C|C]; [specialize (Cl (rt m' i)
      ltac:(lra)); lra|rewrite <- C in To; lra]. } split.
  - intros V0; pose proof (open_after M _ _ (hump_shift M lo hi H (rN m i)) (rt m i) (rV m i) (arc m i) (arc' m i) z w
      P W F To ltac:(rewrite V0 in *; lra) Op (rt m' i)) as G. destruct (sizes M lo hi H); unfold in_pass in P';
        specialize (G ltac:(lra)); specialize (Ab (rt m' i) ltac:(lra)); lra.
  - intros EN1; pose proof (rising m i R) as Ri; destruct (run_on m R (S i)) as [P1 _]; destruct Leg as [FX X0 X0' Lt
      _ _ _], Leg' as [FY Y0 Y0' Lt' _ _ _]. assert (Lx : rt m' i < rt m (S i)) by (apply (pass_order M lo hi H (rN m
      i) (rN m (S i))); trivial). destruct (keep_order M lo hi H _ _ _ _ r (rt m' i) F F' ltac:(lra) (proj1 U) (proj1
      (proj2 U))) as [K1 K2]. destruct (impact M lo hi H z w (rN m i) (rt m i) (rt m' i) (rV m i) (rV m' i) (arc m i)
      (arc' m i) (arc m' i) (arc' m' i) (rx m i) (rv m i) (rx m' i) (rv m' i) P P' ltac:(lra) W Op F FX To Hi To' Hi'
      X0 X0' Y0 Y0') as (I1 & I2 & _). pose proof (restitution _ _ _ H) as Ht; assert (0 <= tau M * (arc m' i (rt m'
      i) - arc m i (rt m' i))) by (apply Rmult_le_pos; lra); assert (0 <= tau M * (zet M (arc m' i) (arc' m' i) (rt m'
      i) - zet M (arc m i) (arc' m i) (rt m' i))) by (apply Rmult_le_pos; lra). assert (Sp : 0 < strength M z w).
    { destruct W as (_ & w1 & _); assert (Ai : 0 <= al0 M - b M ^ 2 * z / (b M - a M)).
      { assert (0 <= (1 + tau M) * w) by (apply Rmult_le_pos; lra); assert (b M ^ 2 * z / (b M - a M) <= b M ^ 2 * (z
          + (1 + tau M) * w) / (b M - a M)); [|lra]. apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|apply
          Rmult_le_compat_l; [apply pow2_ge_0|lra]]. } assert (0 <= tau M * (al0 M - b M ^ 2 * z / (b M - a M))) by
      (apply Rmult_le_pos; lra); unfold strength; lra. } assert (0 < strength M z w * (rt m' i - rt m i)) by (apply
    Rmult_lt_0_compat; lra).
    exists (rt m' i); cbn [from arc arc']; repeat split; try lra; right; lra.
Qed.
Lemma told m m' k : runs m -> runs m' -> (forall i, (i <= k)%nat -> rN m i = rN m' i) -> rV m k = 0 -> rV m' k = 0 ->
  ru m s = ru m' s.
Proof.
  assert (No : forall m m', runs m -> runs m' -> (forall i, (i <= k)%nat -> rN m i = rN m' i) -> rV m k = 0 -> rV m' k
    = 0 -> ~ ru m s < ru m' s).
  { clear m m'; intros m m' R R' EN V0 V0' C; assert (All : forall i, (i <= k)%nat -> below m m' i \/ below m' m i).
    { induction i as [|i IH]; intros Hi.
      - left; destruct (run_arc m 0 R) as (_ & l0 & _), (run_arc m' 0 R') as (_ & l1 & _); exists s; cbn [from arc
          arc'] in
          *; unfold under, zet; rewrite (run_at m R), (run_at m' R'); repeat split; try lra; right; lra.
      - destruct (IH ltac:(lia)) as [X|X]; [right; apply (step m m' i R R' X)|left; apply (step m' m i R' R X)]; try
          apply EN; try (symmetry; apply EN); lia. } destruct (All k (le_n k)) as [X|X]; [apply (step m m' k R R' X
    (EN k (le_n k))), V0|apply (step m' m k R' R X (eq_sym (EN k (le_n k)))), V0']. } intros R R' EN V0 V0'; destruct
  (Rtotal_order (ru m s) (ru m' s)) as [C|[C|C]]; [exfalso; apply (No m m'); trivial|exact C|exfalso; apply (No m' m);
    trivial; intros; symmetry; auto].
Qed.
Lemma few : few_graze M lo hi z s q.
Proof.
  set (P := fun n y => exists m k, runs m /\ rV m k = 0 /\ n = to_nat (k, code (rN m) k) /\ y = ru m s).
  exists (fun n => the (P n)); intros y u N t V x v F A Z Ar Mo [k V0].
  set (m := {| ry := y; ru := u; rN := N; rt := t; rV := V; rx := x; rv := v |}); assert (R : runs m) by (constructor;
    assumption). exists (to_nat (k, code N k)); symmetry; apply the_spec; [exists m, k; repeat (split; trivial); apply
    R|]. intros y' (m' & k' & R' & V0' & E & ->); apply to_nat_inj in E; injection E as E1 E2; subst k'; apply (told
      m' m k); trivial. apply code_inj; symmetry; exact E2.
Qed.
End Almost.

Theorem Almost : Almost_statement.
Proof. intros M lo hi z s q O B Qs Qq; apply few; trivial. Qed.
