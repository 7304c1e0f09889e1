(** * Intervals with integer ends contain the results of arithmetic and the square root

    An interval is a pair of integers in units of 2^-28, or None, of which nothing is known. Each operation
    rounds outwards; [mem_...] says so. The kernel computes with them. *)

From Coq Require Import Reals ZArith Lra Lia Bool.
Open Scope R_scope.

Definition itv : Type := option (Z * Z).
Definition one : Z := 268435456.
Definition mem (X : itv) (x : R) : Prop :=
  match X with Some (l, h) => IZR l <= x * IZR one <= IZR h | None => True end.

Lemma one_pos : 0 < IZR one. Proof. apply IZR_lt; reflexivity. Qed.

(** ** Arithmetic *)

Definition down (z : Z) : Z := Z.shiftr z 28.
Definition up (z : Z) : Z := (- down (- z))%Z.

Lemma down_le z : IZR (down z) * IZR one <= IZR z.
Proof.
  unfold down; rewrite Z.shiftr_div_pow2 by lia; change (2 ^ 28)%Z with one.
  rewrite <- mult_IZR; apply IZR_le; rewrite Z.mul_comm; apply Z.mul_div_le; reflexivity.
Qed.

Lemma up_ge z : IZR z <= IZR (up z) * IZR one.
Proof. unfold up; pose proof (down_le (- z)) as H; rewrite !opp_IZR in *; lra. Qed.

Definition constant (p : Z) (q : positive) : itv :=
  Some (p * one / Z.pos q, - ((- p * one) / Z.pos q))%Z.

Lemma quotient p q : (0 < q)%Z -> IZR (p / q) <= IZR p / IZR q <= IZR (- (- p / q)).
Proof.
  intros Hq; pose proof (IZR_lt _ _ Hq) as Hq'; split.
  - apply (Rmult_le_reg_r (IZR q)); [assumption|]. replace (IZR p / IZR q * IZR q) with (IZR p) by (field; lra).
    rewrite <- mult_IZR; apply IZR_le; rewrite Z.mul_comm; apply Z.mul_div_le; assumption.
  - apply (Rmult_le_reg_r (IZR q)); [assumption|]. replace (IZR p / IZR q * IZR q) with (IZR p) by (field; lra).
    rewrite <- mult_IZR; apply IZR_le. pose proof (Z.mul_div_le (- p) q Hq); lia.
Qed.

Lemma mem_constant p q : mem (constant p q) (IZR p / IZR (Z.pos q)).
Proof.
  cbn [mem constant]. pose proof (quotient (p * one) (Z.pos q) eq_refl) as H; rewrite mult_IZR in H.
  replace (- p * one)%Z with (- (p * one))%Z by ring. assert (IZR (Z.pos q) <> 0) by (apply not_0_IZR; discriminate).
  replace (IZR p / IZR (Z.pos q) * IZR one) with (IZR p * IZR one / IZR (Z.pos q)) by (field; assumption). exact H.
Qed.

Definition plus (X Y : itv) : itv := match X, Y with
  | Some (a, b), Some (c, d) => Some (a + c, b + d)%Z | _, _ => None end.
Definition opp (X : itv) : itv := match X with Some (a, b) => Some (- b, - a)%Z | None => None end.
Definition minus (X Y : itv) : itv := plus X (opp Y).
Definition times (X Y : itv) : itv := match X, Y with
  | Some (a, b), Some (c, d) =>
    if (0 <=? a)%Z then Some (down ((if 0 <=? c then a else b) * c), up ((if 0 <=? d then b else a) * d))%Z
      else
    if (0 <=? c)%Z then Some (down (a * d), up ((if 0 <=? b then d else c) * b))%Z else
    Some (down (Z.min (Z.min (a * c) (a * d)) (Z.min (b * c) (b * d))),
          up (Z.max (Z.max (a * c) (a * d)) (Z.max (b * c) (b * d))))
  | _, _ => None end.
(** The greatest magnitude from 0 on. *)
Definition size (X : itv) : itv := match X with
  | Some (a, b) => Some (0, Z.max (- a) b)%Z | None => None end.
(** Of positive numbers, then of negative. *)
Definition inverse_positive (X : itv) : itv := match X with
  | Some (a, b) => if (0 <? a)%Z then Some (one * one / b, - (- (one * one) / a))%Z else None
  | None => None end.
Definition inverse (X : itv) : itv := match X with
  | Some (_, b) => if (b <? 0)%Z then opp (inverse_positive (opp X)) else inverse_positive X
  | None => None end.
Definition root (X : itv) : itv := match X with
  | Some (a, b) => if (0 <=? a)%Z then Some (Z.sqrt (a * one), Z.sqrt (b * one) + 1)%Z else None
  | None => None end.

Lemma mem_plus X Y x y : mem X x -> mem Y y -> mem (plus X Y) (x + y).
Proof. destruct X as [[]|], Y as [[]|]; cbn; trivial; rewrite !plus_IZR; lra. Qed.
Lemma mem_opp X x : mem X x -> mem (opp X) (- x).
Proof. destruct X as [[]|]; cbn; trivial; rewrite !opp_IZR; lra. Qed.
Lemma mem_minus X Y x y : mem X x -> mem Y y -> mem (minus X Y) (x - y).
Proof. intros; apply mem_plus, mem_opp; assumption. Qed.

Lemma corner a b c d x y m : a <= x <= b -> c <= y <= d ->
  m <= a * c -> m <= a * d -> m <= b * c -> m <= b * d -> m <= x * y.
Proof.
  intros Hx Hy H1 H2 H3 H4. assert (Ha : m <= a * y) by (destruct (Rle_lt_dec 0 a); nra).
  assert (Hb : m <= b * y) by (destruct (Rle_lt_dec 0 b); nra). destruct (Rle_lt_dec 0 y); nra.
Qed.

Lemma mem_times X Y x y : mem X x -> mem Y y -> mem (times X Y) (x * y).
Proof.
  destruct X as [[a b]|], Y as [[c d]|]; cbn [mem times]; trivial; intros Hx Hy. pose proof one_pos as H1.
  assert (B : forall u v, IZR u <= (x * IZR one) * (y * IZR one) <= IZR v -> IZR (down u) <= x * y * IZR one <= IZR
    (up v)).
  { intros u v H; pose proof (down_le u); pose proof (up_ge v). split; apply (Rmult_le_reg_r (IZR one)); trivial; nra. }
  destruct (Z.leb_spec 0 a) as [Sa|Sa]; [|destruct (Z.leb_spec 0 c) as [Sc|Sc]].
  - apply IZR_le in Sa; apply B; destruct (Z.leb_spec 0 c) as [Sc|Sc], (Z.leb_spec 0 d) as [Sd|Sd];
      (apply IZR_le in Sc || apply IZR_lt in Sc); (apply IZR_le in Sd || apply IZR_lt in Sd); rewrite !mult_IZR; split;
      nra.
  - apply IZR_lt in Sa; apply IZR_le in Sc; apply B; destruct (Z.leb_spec 0 b) as [Sb|Sb];
      (apply IZR_le in Sb || apply IZR_lt in Sb); rewrite !mult_IZR; split; nra.
  - clear B. set (m := Z.min _ _); set (M := Z.max _ _).
  assert (L : IZR m <= (x * IZR one) * (y * IZR one)).
  { apply (corner _ _ _ _ _ _ _ Hx Hy); rewrite <- mult_IZR; apply IZR_le; unfold m; lia. }
  assert (U : - IZR M <= (- (x * IZR one)) * (y * IZR one)).
  { apply (corner (- IZR b) (- IZR a) (IZR c) (IZR d)); try lra; rewrite <- !opp_IZR, <- mult_IZR; apply IZR_le;
      unfold M; lia. }
  pose proof (down_le m); pose proof (up_ge M). split; apply (Rmult_le_reg_r (IZR one)); trivial; nra.
Qed.

Lemma mem_size X x : mem X x -> mem (size X) (Rabs x).
Proof.
  destruct X as [[a b]|]; cbn [mem size]; trivial; intros Hx. pose proof one_pos as H1; pose proof (Rabs_pos x).
  replace (Rabs x * IZR one) with (Rabs (x * IZR one)).
  2: { rewrite Rabs_mult, (Rabs_pos_eq (IZR one)); lra. }
  split; [apply Rabs_pos|]. assert (IZR b <= IZR (Z.max (- a) b)) by (apply IZR_le; lia).
  assert (IZR (- a) <= IZR (Z.max (- a) b)) by (apply IZR_le; lia). rewrite opp_IZR in *; apply Rabs_le; lra.
Qed.

Lemma mem_inverse_positive X x : mem X x -> mem (inverse_positive X) (/ x).
Proof.
  destruct X as [[a b]|]; cbn [mem inverse_positive]; trivial; intros [Ha Hb].
  destruct (Z.ltb_spec 0 a) as [Ha'|]; [|exact I]. apply IZR_lt in Ha'; pose proof one_pos as H1.
  assert (Hx : 0 < x) by nra. assert (Hb' : (0 < b)%Z) by (apply lt_IZR; lra).
  assert (Ha'' : (0 < a)%Z) by (apply lt_IZR; lra).
  pose proof (quotient (one * one) b Hb') as [P _]; pose proof (quotient (one * one) a Ha'') as [_ P'].
  rewrite mult_IZR in P, P'; apply IZR_lt in Hb'. cbn [mem]; split.
  - apply (Rle_trans _ _ _ P), (Rmult_le_reg_r (IZR b * x)); [nra|].
    replace (IZR one * IZR one / IZR b * (IZR b * x)) with (IZR one * (x * IZR one)) by (field; lra).
    replace (/ x * IZR one * (IZR b * x)) with (IZR one * IZR b) by (field; lra); nra.
  - apply (fun H => Rle_trans _ _ _ H P'), (Rmult_le_reg_r (IZR a * x)); [nra|].
    replace (IZR one * IZR one / IZR a * (IZR a * x)) with (IZR one * (x * IZR one)) by (field; lra).
    replace (/ x * IZR one * (IZR a * x)) with (IZR one * IZR a) by (field; lra); nra.
Qed.

Lemma mem_inverse X x : mem X x -> mem (inverse X) (/ x).
Proof.
  intros H; pose proof (mem_inverse_positive _ _ H) as P.
  pose proof (mem_opp _ _ (mem_inverse_positive _ _ (mem_opp _ _ H))) as N; rewrite Rinv_opp, Ropp_involutive in N.
  destruct X as [[a b]|]; [cbn [inverse]; destruct (b <? 0)%Z; assumption | exact I].
Qed.

Lemma mem_root X x : mem X x -> mem (root X) (sqrt x).
Proof.
  destruct X as [[a b]|]; cbn [mem root]; trivial; intros [Ha Hb].
  destruct (Z.leb_spec 0 a) as [Ha'|]; [|exact I]; cbn [mem]. pose proof one_pos as H1; pose proof (IZR_le _ _ Ha').
  assert (Hx : 0 <= x) by nra. assert (Hb' : (0 <= b)%Z) by (apply le_IZR; lra).
  pose proof (sqrt_pos x); pose proof (sqrt_sqrt x Hx) as Hs. assert (Ho : (0 <= one)%Z) by (unfold one; lia).
  destruct (Z.sqrt_spec (a * one)) as [P _]; [apply Z.mul_nonneg_nonneg; assumption|].
  destruct (Z.sqrt_spec (b * one)) as [_ P']; [apply Z.mul_nonneg_nonneg; assumption|].
  pose proof (IZR_le _ _ (Z.sqrt_nonneg (a * one))); pose proof (IZR_le _ _ (Z.sqrt_nonneg (b * one))).
  apply IZR_le in P; apply IZR_lt in P'; unfold Z.succ in P'; rewrite !mult_IZR, ?plus_IZR in *. set (r := sqrt x) in *.
  assert (0 <= r * IZR one) by nra.
  assert (E : r * IZR one * (r * IZR one) = x * IZR one * IZR one) by (rewrite <- Hs; ring).
  split; apply Rnot_lt_le; intros L.
  - assert (r * IZR one * (r * IZR one) < IZR (Z.sqrt (a * one)) * IZR (Z.sqrt (a * one))) by nra; nra.
  - assert ((IZR (Z.sqrt (b * one)) + 1) * (IZR (Z.sqrt (b * one)) + 1) < r * IZR one * (r * IZR one)) by nra; nra.
Qed.

(** ** Comparisons *)

Definition below (X Y : itv) : bool := match X, Y with
  | Some (_, b), Some (c, _) => (b <=? c)%Z | _, _ => false end.
Definition positive (X : itv) : bool := match X with Some (a, _) => (0 <? a)%Z | None => false end.

Lemma below_le X Y x y : below X Y = true -> mem X x -> mem Y y -> x <= y.
Proof.
  destruct X as [[a b]|], Y as [[c d]|]; cbn; try discriminate; intros H.
  apply Z.leb_le, IZR_le in H; intros; apply (Rmult_le_reg_r (IZR one)); [exact one_pos | lra].
Qed.

Lemma positive_lt X x : positive X = true -> mem X x -> 0 < x.
Proof.
  destruct X as [[a b]|]; cbn; try discriminate; intros H.
  apply Z.ltb_lt, IZR_lt in H; intros; apply (Rmult_lt_reg_r (IZR one)); [exact one_pos | lra].
Qed.

(** ** Cutting an interval into k parts of width w *)

Fixpoint all (f : itv -> bool) (l w : Z) (k : nat) : bool := match k with
  | O => false | S O => f (Some (l, l + w)%Z) | S k => f (Some (l, l + w)%Z) && all f (l + w) w k end.
Definition cut (f : itv -> bool) (k : nat) (X : itv) : bool := match X with
  | Some (l, h) => all f l (- ((l - h) / Z.of_nat k)) k | None => false end.

Lemma all_one f l w k x : all f l w k = true -> IZR l <= x * IZR one <= IZR (l + w * Z.of_nat k) ->
  exists X, f X = true /\ mem X x.
Proof.
  revert l; induction k as [|k IH]; [discriminate|]; intros l H Hx.
  destruct (Rle_lt_dec (x * IZR one) (IZR (l + w))) as [Hle|Hlt].
  - exists (Some (l, l + w)%Z); split; [|cbn; lra].
    destruct k; cbn in H; [|apply andb_prop in H; destruct H]; assumption.
  - destruct k as [|k].
    + replace (l + w * Z.of_nat 1)%Z with (l + w)%Z in Hx by lia; lra.
    + apply andb_prop in H; destruct H as [_ H]; apply (IH (l + w)%Z H).
      replace (l + w + w * Z.of_nat (S k))%Z with (l + w * Z.of_nat (S (S k)))%Z by lia; lra.
Qed.

Lemma cut_one f k X x : cut f k X = true -> mem X x -> exists Y, f Y = true /\ mem Y x.
Proof.
  destruct X as [[l h]|]; [|discriminate]; cbn [cut mem]; intros H Hx.
  apply (all_one _ _ _ _ _ H); split; [lra|]; apply (Rle_trans _ (IZR h)); [lra|]; apply IZR_le.
  destruct k as [|k]; [discriminate|]. pose proof (Z.mul_div_le (l - h) (Z.of_nat (S k))); lia.
Qed.

(** ** Halving intervals until a check passes, at most some times *)

Definition halves (X : itv) : itv * itv := match X with
  | Some (l, h) => let m := Z.shiftr (l + h) 1 in (Some (l, m), Some (m, h)) | None => (X, X) end.
Fixpoint cover (n : nat) (f : itv -> bool) (X : itv) : bool := if f X then true else match n with
  | O => false | S n => if cover n f (fst (halves X)) then cover n f (snd (halves X)) else false end.
(** Three in turn. *)
Fixpoint cover3 (n : nat) (f : itv -> itv -> itv -> bool) (X Y Z : itv) : bool :=
  if f X Y Z then true else match n with
  | O => false
  | S n => let g X := cover3 n (fun Y Z X => f X Y Z) Y Z X in
    if g (fst (halves X)) then g (snd (halves X)) else false end.

Lemma mem_halves X x : mem X x -> mem (fst (halves X)) x \/ mem (snd (halves X)) x.
Proof.
  destruct X as [[l h]|]; [|left; exact I]; cbn [halves fst snd]; set (m := Z.shiftr _ _); cbn [mem]; intros Hx.
  destruct (Rle_lt_dec (x * IZR one) (IZR m)); [left | right]; lra.
Qed.

Lemma cover_one n f X x : cover n f X = true -> mem X x -> exists Y, f Y = true /\ mem Y x.
Proof.
  revert X; induction n as [|n IH]; intros X H Hx; cbn [cover] in H; (destruct (f X) eqn:E; [exists X; auto|]).
  - discriminate.
  - destruct (cover n f (fst _)) eqn:H1; [|discriminate]; destruct (mem_halves _ _ Hx) as [M|M];
      [apply (IH _ H1 M) | apply (IH _ H M)].
Qed.

Lemma cover3_one n f X Y Z x y z : cover3 n f X Y Z = true -> mem X x -> mem Y y -> mem Z z ->
  exists X Y Z, f X Y Z = true /\ mem X x /\ mem Y y /\ mem Z z.
Proof.
  revert f X Y Z x y z; induction n as [|n IH]; intros f X Y Z x y z H Hx Hy Hz; cbn [cover3] in H;
    (destruct (f X Y Z) eqn:E; [exists X, Y, Z; auto|]).
  - discriminate.
  - cbv zeta beta in H; destruct (cover3 n _ Y Z (fst (halves X))) eqn:H1; [|discriminate].
    destruct (mem_halves _ _ Hx) as [M|M]; [destruct (IH _ _ _ _ _ _ _ H1 Hy Hz M) as (Y' & Z' & X' & A & B & C & D) |
      destruct (IH _ _ _ _ _ _ _ H Hy Hz M) as (Y' & Z' & X' & A & B & C & D)]; exists X', Y', Z'; auto.
Qed.
