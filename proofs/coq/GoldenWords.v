(** * Words of 0 and 1 without 00, words over {1, 2}, and whole numbers one or two apart, counted by the golden ratio *)

From Coq Require Import Reals ZArith List Arith Lra Lia Classical.
From Grazing Require Import StatementChaos StatementEntropy.
Import ListNotations. Open Scope R_scope.

(** ** The golden ratio, and two families of words that it counts *)

Lemma golden_facts : 1 < golden < 2 /\ golden ^ 2 = golden + 1.
Proof.
  assert (E : sqrt 5 * sqrt 5 = 5) by (apply sqrt_sqrt; lra); pose proof (sqrt_pos 5); unfold golden; split; nra.
Qed.

Lemma golden_SS k : golden ^ S (S k) = golden ^ S k + golden ^ k.
Proof. destruct golden_facts as [_ E]; cbn [pow] in *; rewrite <- Rmult_assoc; replace (golden * golden)
    with (golden + 1) by lra; ring. Qed.

(** Words of length k without two [false] in a row, and those of length k + 1. *)
Fixpoint marks (k : nat) : list (list bool) * list (list bool) :=
  match k with
  | O => ([[]], [[true]; [false]])
  | S k => let (a, b) := marks k in (b, map (cons true) b ++ map (fun w => false :: true :: w) a)
  end.

Lemma marks_count k : INR (length (fst (marks k))) <= golden ^ (k + 1) /\ INR (length (snd (marks k))) <= golden ^
  (k + 2).
Proof.
  pose proof golden_facts as [G E]; induction k as [|k [IH1 IH2]]; [cbn [marks fst snd length Nat.add INR pow] in *;
    lra|].
  cbn [marks]; destruct (marks k) as [a b]; cbn [fst snd] in *; split; [replace (S k + 1)%nat with (k + 2)%nat by lia;
    assumption|].
  rewrite app_length, !map_length, plus_INR; replace (S k + 2)%nat with (S (S (k + 1))) by lia; rewrite golden_SS.
  replace (S (k + 1)) with (k + 2)%nat by lia; lra.
Qed.

Definition no_00 (w : list bool) : Prop := forall j, (S j < length w)%nat -> nth j w true = true \/
  nth (S j) w true = true.

Lemma marks_complete k : forall w, no_00 w -> (length w = k -> In w (fst (marks k))) /\
  (length w = S k -> In w (snd (marks k))).
Proof.
  induction k as [|k IH]; intros w Hw.
  - split; destruct w as [|x [|y w]]; cbn; try discriminate; [tauto | destruct x; tauto].
  - assert (Tail : forall x w', w = x :: w' -> no_00 w').
    { intros x w' -> j Hj; apply (Hw (S j)); cbn; lia. }
    cbn [marks]; destruct (marks k) as [a b] eqn:Em; cbn [fst snd] in *; split; [apply IH; assumption|].
    destruct w as [|x w]; [discriminate|]; intros Hl; injection Hl as Hl; specialize (Tail x w eq_refl).
    apply in_app_iff; destruct x; [left; apply in_map, IH; assumption | right].
    destruct w as [|y w]; [discriminate|]; assert (y = true) as -> by (destruct (Hw 0%nat); cbn in *;
      [lia | discriminate | assumption]).
    apply (in_map (fun w => false :: true :: w)), IH; [intros j Hj; apply (Tail (S j)); cbn; lia | injection Hl;
      trivial].
Qed.

(** Words over {1, 2} with the sum P, and with the sum P + 1. *)
Fixpoint legs (P : nat) : list (list Z) * list (list Z) :=
  match P with
  | O => ([[]], [[1%Z]])
  | S P => let (a, b) := legs P in (b, map (cons 1%Z) b ++ map (cons 2%Z) a)
  end.
Definition sum (w : list Z) : Z := fold_right Z.add 0%Z w.
Definition over_12 (w : list Z) : Prop := Forall (fun x => x = 1 \/ x = 2)%Z w.

Lemma legs_count P : golden ^ P <= INR (length (fst (legs P))) * golden /\ golden ^ P <= INR (length (snd (legs P))).
Proof.
  pose proof golden_facts as [G E]; induction P as [|P [IH1 IH2]]; [cbn [legs fst snd length INR pow] in *; lra|].
  cbn [legs]; destruct (legs P) as [a b]; cbn [fst snd] in *; split; [cbn [pow]; nra|].
  rewrite app_length, !map_length, plus_INR; apply (Rmult_le_reg_l golden); [lra|].
  pose proof (golden_SS P) as S; cbn [pow] in *; nra.
Qed.

Lemma NoDup_disjoint {A} (l l' : list A) : NoDup l -> NoDup l' -> (forall x, In x l -> ~ In x l') -> NoDup (l ++ l').
Proof.
  induction 1 as [|x l Hx _ IH]; intros H' D; [assumption|]; cbn [app]; constructor.
  - rewrite in_app_iff; intros [Hin|Hin]; [tauto | exact (D x (or_introl eq_refl) Hin)].
  - apply IH; [assumption | intros y Hy; apply D; right; assumption].
Qed.
Lemma NoDup_cons_map (c : Z) l : NoDup l -> NoDup (map (cons c) l).
Proof.
  induction 1 as [|x l Hx _ IH]; cbn [map]; constructor; [|assumption].
  intros Hin; apply in_map_iff in Hin; destruct Hin as (y & E & Hy); injection E as ->; tauto.
Qed.

Lemma legs_content P : (forall w, In w (fst (legs P)) -> sum w = Z.of_nat P /\ over_12 w) /\
  (forall w, In w (snd (legs P)) -> sum w = Z.of_nat (S P) /\ over_12 w) /\ NoDup (fst (legs P)) /\
  NoDup (snd (legs P)).
Proof.
  induction P as [|P (A & B & NA & NB)].
  - cbn; split; [|split; [|split; repeat constructor; auto]]; (intros w [<-|[]]; split;
      [reflexivity | repeat constructor; tauto]).
  - cbn [legs]; destruct (legs P) as [a b]; cbn [fst snd] in *; split; [exact B | split; [|split; [exact NB|]]].
    + intros w Hw; apply in_app_or in Hw; destruct Hw as [Hw|Hw]; apply in_map_iff in Hw; destruct Hw as (x & <- & Hx);
        [destruct (B x Hx) as [E O] | destruct (A x Hx) as [E O]]; (split; [cbn [sum fold_right]; fold (sum x); lia |
        constructor; auto]).
    + apply NoDup_disjoint; [apply NoDup_cons_map, NB | apply NoDup_cons_map, NA|].
      intros x Hx Hx'; apply in_map_iff in Hx, Hx'; destruct Hx as (y & <- & _), Hx' as (y' & E & _); discriminate.
Qed.

(** ** Whole numbers N_i, one or two apart *)

Section Steps.
Variable N : Z -> Z.
Hypothesis steps : one_or_two N.

Lemma increasing i j : (i <= j)%Z -> (N j >= N i + (j - i))%Z.
Proof.
  intros H; replace j with (i + Z.of_nat (Z.to_nat (j - i)))%Z by lia; generalize (Z.to_nat (j - i)) as k.
  induction k as [|k IH]; [rewrite Z.add_0_r; lia|].
  replace (i + Z.of_nat (S k))%Z with (i + Z.of_nat k + 1)%Z by lia; destruct (steps (i + Z.of_nat k)%Z); lia.
Qed.

(** There is an impact in period k. *)
Definition hit (k : Z) : Prop := exists i, N i = k.

Lemma skipped i : N (i + 1)%Z = (N i + 2)%Z -> ~ hit (N i + 1).
Proof.
  intros E (j & Hj); destruct (Z_le_gt_dec j i) as [L|L].
  - pose proof (increasing j i L); lia.
  - pose proof (increasing (i + 1) j ltac:(lia)); lia.
Qed.

Lemma last_unique k i i' : (N i <= k < N (i + 1))%Z -> (N i' <= k < N (i' + 1))%Z -> i = i'.
Proof.
  intros H H'; destruct (Z_lt_ge_dec i i') as [L|L]; [pose proof (increasing (i + 1) i' ltac:(lia)); lia|].
  destruct (Z_lt_ge_dec i' i) as [L'|L']; [pose proof (increasing (i' + 1) i ltac:(lia)); lia | lia].
Qed.

(** The index of the last impact up to period k, searched for from i upwards. *)
Fixpoint upto (d : nat) (i k : Z) : Z := match d with
  | O => i
  | S d => if (N (i + 1) <=? k)%Z then upto d (i + 1) k else i
  end.
Definition last (k : Z) : Z := let i := (- Z.abs (N 0 - k))%Z in upto (Z.to_nat (k - N i + 1)) i k.

Lemma last_spec k : (N (last k) <= k < N (last k + 1))%Z.
Proof.
  assert (Up : forall d i, (N i <= k)%Z -> (k - N i < Z.of_nat d)%Z -> (N (upto d i k) <= k < N (upto d i k + 1))%Z).
  { induction d as [|d IH]; intros i H1 H2; [lia|]; cbn [upto].
    destruct (Z.leb_spec (N (i + 1)%Z) k) as [L|L]; [apply IH; destruct (steps i); lia | lia]. }
  unfold last; set (i := (- Z.abs (N 0%Z - k))%Z); pose proof (increasing i 0 ltac:(lia)); apply Up; lia.
Qed.
Lemma last_exists k : exists i, (N i <= k < N (i + 1))%Z. Proof. exists (last k); apply last_spec. Qed.

(** The last impact up to period k is in k, or in the period before if there is none in k. *)
Lemma last_in k i : (N i <= k < N (i + 1))%Z -> (hit k -> N i = k) /\ (~ hit k -> N i = k - 1)%Z.
Proof.
  intros H; split; intros Hk.
  - destruct Hk as (j & Hj); destruct (Z_le_gt_dec j i) as [L|L]; [pose proof (increasing j i L); lia|].
    pose proof (increasing (i + 1) j ltac:(lia)); lia.
  - destruct (Z.eq_dec (N i) k) as [E|]; [exfalso; apply Hk; exists i; exact E | destruct (steps i); lia].
Qed.

Lemma one_of_two k : hit k \/ hit (k + 1).
Proof.
  destruct (last_exists k) as (i & H); destruct (classic (hit k)) as [|Hk]; [tauto | right].
  pose proof (proj2 (last_in k i H) Hk); exists (i + 1)%Z; destruct (steps i); lia.
Qed.
End Steps.

(** Where the impacts agree, so do the N. *)
Lemma agree N N' c m : one_or_two N -> one_or_two N' -> N 0%Z = c -> N' 0%Z = c ->
  (forall k, (c - 2 * Z.of_nat m <= k <= c + 2 * Z.of_nat m)%Z -> hit N k <-> hit N' k) ->
  forall i, (- Z.of_nat m <= i <= Z.of_nat m)%Z -> N i = N' i.
Proof.
  intros S S' E E' H; assert (Both : forall k : nat, (k <= m)%nat -> (N (Z.of_nat k) = N' (Z.of_nat k) /\
    N (Z.of_nat k) <= c + 2 * Z.of_nat k)%Z /\ (N (- Z.of_nat k) = N' (- Z.of_nat k) /\ N (- Z.of_nat k) >= c - 2
    * Z.of_nat k)%Z).
  { induction k as [|k IH]; intros Hk; [cbn; lia|]; destruct IH as [[U UB] [D DB]]; [lia|].
    set (i := Z.of_nat k) in *; replace (Z.of_nat (Datatypes.S k)) with (i + 1)%Z by lia.
    pose proof (increasing N S 0 i ltac:(lia)); pose proof (increasing N S (- i) 0 ltac:(lia)); split.
    - specialize (H (N i + 1)%Z ltac:(lia)); rewrite U in H at 2.
      assert (A : forall M, one_or_two M -> (M (i + 1) = M i + 1 <-> hit M (M i + 1))%Z).
      { intros M SM; split; [intros; exists (i + 1)%Z; assumption|]; intros Hh; destruct (SM i) as [|E2]; [assumption|].
        destruct (skipped M SM i E2 Hh). }
      pose proof (A N S) as B; pose proof (A N' S') as B'; destruct (S i), (S' i); intuition lia.
    - specialize (H (N (- i) - 1)%Z ltac:(lia)); rewrite D in H at 2.
      assert (A : forall M, one_or_two M -> (M (- i - 1) = M (- i) - 1 <-> hit M (M (- i) - 1))%Z).
      { intros M SM; split; [intros; exists (- i - 1)%Z; assumption|]; intros Hh.
        pose proof (SM (- i - 1)%Z) as C; replace (- i - 1 + 1)%Z with (- i)%Z in C by lia; destruct C as [|E2]; [lia|].
        destruct (skipped M SM (- i - 1)%Z); [replace (- i - 1 + 1)%Z with (- i)%Z by lia; exact E2|].
        replace (M (- i - 1) + 1)%Z with (M (- i) - 1)%Z by lia; exact Hh. }
      pose proof (A N S) as B; pose proof (A N' S') as B'.
      pose proof (S (- i - 1)%Z) as C; pose proof (S' (- i - 1)%Z) as C'; replace (- i - 1 + 1)%Z with (- i)%Z in C,
        C' by lia.
      replace (- (i + 1))%Z with (- i - 1)%Z by lia.
      assert (F : (N (- i - 1) = N (- i) - 1 \/ N (- i - 1) = N (- i) - 2)%Z) by lia.
      assert (F' : (N' (- i - 1) = N' (- i) - 1 \/ N' (- i - 1) = N' (- i) - 2)%Z) by lia.
      clear C C'; destruct F, F'; intuition lia. }
  intros i Hi; destruct (Both (Z.to_nat (Z.abs i)) ltac:(lia)) as [[A _] [B _]].
  destruct (Z_le_gt_dec 0 i); [replace i with (Z.of_nat (Z.to_nat (Z.abs i))) by lia; exact A|].
  replace i with (- Z.of_nat (Z.to_nat (Z.abs i)))%Z by lia; exact B.
Qed.
