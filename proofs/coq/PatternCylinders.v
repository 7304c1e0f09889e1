(** * A vector checked by whole numbers bounds all words that begin alike: their later periods are one vertex *)

From Coq Require Import Reals ZArith List Arith Bool Lra Lia.
From Grazing Require Import Defs Statement StatementWords StatementGraphs StatementReaderWords WordAlgebra WordPath
  WordGraph WordPatterns GraphWords.
From Grazing Require Import StatementSuprema PatternSums.
Import ListNotations. Open Scope R_scope.

(** Sum over a word's periods of z^n v_n. *)
Definition weighed_sum (z : R) (vv : nat -> R) (V : list (nat * letter)) : R :=
  sum_of V (fun y => z ^ fst y * vv (fst y)).

Lemma between_bounds (V : list (nat * letter)) (vv : nat -> R) vs : 0 < vs -> (forall x, In x V -> 0 < vv (fst x)) ->
  exists lo hi, 0 < lo /\ lo <= vs <= hi /\ forall x, In x V -> lo <= vv (fst x) <= hi.
Proof.
  intros Hs; induction V as [|x V IH]; intros H;
    [exists vs, vs; split; [lra | split; [lra | intros y Hy; destruct Hy]]|].
  destruct (IH (fun y Hy => H y (or_intror Hy))) as (lo & hi & L & B & All); specialize (H x (or_introl eq_refl)).
  exists (Rmin lo (vv (fst x))), (Rmax hi (vv (fst x))); pose proof (Rmin_l lo (vv (fst x)));
    pose proof (Rmin_r lo (vv (fst x))); pose proof (Rmax_l hi (vv (fst x))); pose proof (Rmax_r hi (vv (fst x)));
    split; [apply Rmin_glb_lt; assumption|]; split; [lra|].
  intros y [<-|Hy]; [lra | specialize (All y Hy); lra].
Qed.

Section Cylinder.
Variables (a1 a2 : R) (K : nat).
Hypothesis first : first_upper a1 a2 K.

Theorem cylinder z g vv vs t w i j : in_word a1 a2 K w i j -> 0 < z < 1 -> 0 < vs -> (forall x, In x (vertices K w) ->
  0 < vv (fst x)) -> (forall X, NoDup X -> (forall n, In n X -> later a1 a2 K w n) -> sum_of X (fun k => z ^ k) <= t) ->
  (forall x, In x (vertices K w) -> weighed_sum z vv (filter (allowed K w g x) (vertices K w)) + t * vs <= vv (fst x))
  -> weighed_sum z vv (vertices K w) + t * vs <= vs -> at_most (patterns a1 a2 Plus g) (- ln z).
Proof.
  intros HW Hz Hs Hv Ht Hrow Hstar; destruct (between_bounds (vertices K w) vv vs Hs Hv) as (lo & hi & L & B & All).
  set (V := vertices K w) in *; set (v := fun n => if in_dec Nat.eq_dec n (map fst V) then vv n else vs).
  assert (Vin : forall n, In n (map fst V) -> v n = vv n) by (intros n Hn; unfold v;
    destruct (in_dec Nat.eq_dec n (map fst V)); [reflexivity | contradiction]).
  assert (Vout : forall n, ~ In n (map fst V) -> v n = vs) by (intros n Hn; unfold v;
    destruct (in_dec Nat.eq_dec n (map fst V)); [contradiction | reflexivity]).
  apply (bounded a1 a2 z g v lo hi Hz L).
  { intros n _; unfold v; destruct (in_dec Nat.eq_dec n (map fst V)) as [I|]; [|lra]; apply in_map_iff in I;
      destruct I as (x & <- & Hx); apply All, Hx. }
  intros x Hx X HN HX; set (inside := fun n => if in_dec Nat.eq_dec n (map fst V) then true else false).
  assert (Ins : forall n, inside n = true <-> In n (map fst V)) by (intros n; unfold inside;
    destruct (in_dec Nat.eq_dec n (map fst V)); split; intros; tauto || discriminate).
  rewrite (sum_filter_two inside X).
  assert (Late : sum_of (filter (fun n => negb (inside n)) X) (fun y => z ^ y * v y) <= t * vs).
  { rewrite (sum_ext _ _ (fun y => vs * z ^ y)).
    - rewrite sum_scale, Rmult_comm; apply Rmult_le_compat_r; [lra|]; apply Ht; [apply NoDup_filter, HN|]; intros n Hn;
        apply filter_In in Hn; destruct Hn as [Hn No].
      destruct (member_cases a1 a2 K first w i j n (proj1 HW) (proj1 (HX n Hn))) as [I|I]; [|exact I]; fold V in I;
        apply Ins in I; rewrite I in No; discriminate.
    - intros n Hn; apply filter_In in Hn; destruct Hn as [_ No]; rewrite Vout; [ring|]; intros I; apply Ins in I;
        rewrite I in No; discriminate. }
  assert (Early : forall F, (forall y, In y X -> In y (map fst V) -> In y (map fst F)) -> incl F V ->
    sum_of (filter inside X) (fun y => z ^ y * v y) <= weighed_sum z vv F).
  { intros F HF HFV; unfold weighed_sum; rewrite <- (sum_map fst F (fun y => z ^ y * vv y)).
    apply Rle_trans with (sum_of (map fst F) (fun y => z ^ y * v y)).
    - apply sum_incl; [apply NoDup_filter, HN | intros y Hy; apply filter_In in Hy; destruct Hy as [Hy I]; apply HF;
        [exact Hy | apply Ins, I]|].
      intros y Hy; apply Rmult_le_pos; [apply pow_le; lra|]; apply in_map_iff in Hy; destruct Hy as (p & <- & Hp).
      rewrite Vin by (apply in_map, HFV, Hp); left; apply Hv, HFV, Hp.
    - apply sum_le; intros y Hy; apply in_map_iff in Hy; destruct Hy as (p & <- & Hp);
        rewrite Vin by (apply in_map, HFV, Hp); lra. }
  destruct (in_dec Nat.eq_dec x (map fst V)) as [I|I].
  - rewrite (Vin x I); apply in_map_iff in I; destruct I as (vx & <- & Hvx); specialize (Hrow vx Hvx).
    specialize (Early (filter (allowed K w g vx) V)); apply Rle_trans with (2 := Hrow); apply Rplus_le_compat;
      [|exact Late]; apply Early.
    + intros y Hy Iy; apply in_map_iff in Iy; destruct Iy as (vy & <- & Hvy); apply in_map, filter_In; split;
        [exact Hvy|].
      apply (edge_allowed a1 a2 K first w i j g vx vy HW Hvx Hvy), (HX _ Hy).
    + intros y Hy; apply filter_In in Hy; apply Hy.
  - rewrite (Vout x I); apply Rle_trans with (2 := Hstar); apply Rplus_le_compat; [|exact Late]; apply Early;
      [auto | intros y Hy; exact Hy].
Qed.
End Cylinder.

(** ** Vectors of whole numbers, at a/b *)
Definition entry (l : list (nat * Z)) (n : nat) : Z := match find (fun x => (fst x =? n)%nat) l with Some x => snd x |
  None => 0%Z end.
Definition scaledZ (a b : Z) (M : nat) (l : list (nat * Z)) (F : list (nat * letter)) : Z :=
  fold_right (fun y s => (a ^ Z.of_nat (fst y) * b ^ Z.of_nat (M - fst y) * entry l (fst y) + s)%Z) 0%Z F.
Definition certZ (a b : Z) (K : nat) (w : list letter) (g : sign) (vv : list Z) (vs : Z) : bool := let V := vertices K w
  in let l := combine (map fst V) vv in let (i, j) := final 1 K w in let M := (i + j)%nat in let m := Nat.min i j
  in let holds F x := (a ^ Z.of_nat M * b ^ Z.of_nat m * vs <=? (b ^ Z.of_nat m - a ^ Z.of_nat m)
  * (x * b ^ Z.of_nat M - scaledZ a b M l F))%Z in ((0 <? a) && (a <? b) && (0 <? vs))%Z && (1 <=? m)%nat && forallb
  (fun x => (0 <? entry l (fst x))%Z && (fst x <=? M)%nat) V && forallb (fun x => holds (filter (allowed K w g x) V)
  (entry l (fst x))) V && holds V vs.

Lemma scaled_sum a b M l F : (0 < b)%Z -> (forall y, In y F -> (fst y <= M)%nat) ->
  IZR (scaledZ a b M l F) = IZR b ^ M * weighed_sum (IZR a / IZR b) (fun n => IZR (entry l n)) F.
Proof.
  intros Hb HM; apply IZR_lt in Hb; induction F as [|y F IH]; [cbn; ring|]; unfold weighed_sum in *;
    cbn [scaledZ fold_right sum_of]; fold (scaledZ a b M l F).
  rewrite plus_IZR, !mult_IZR, IH by (intros x Hx; apply HM; right; exact Hx); specialize (HM y (or_introl eq_refl));
    rewrite <- !pow_IZR.
  rewrite Rmult_plus_distr_l; f_equal; replace M with (fst y + (M - fst y))%nat at 2 by lia; rewrite pow_add;
    unfold Rdiv; rewrite Rpow_mult_distr, pow_inv.
  field; apply pow_nonzero; lra.
Qed.

Theorem cert_sound a b K w g vv vs : certZ a b K w g vv vs = true -> forall a1 a2 i j z, first_upper a1 a2 K ->
  in_word a1 a2 K w i j -> 0 < z < IZR a / IZR b -> below (patterns a1 a2 Plus g) (- ln z).
Proof.
  intros H a1 a2 i j z first HW Hz; exists (- ln (IZR a / IZR b)); split; [apply Ropp_lt_contravar, ln_increasing;
    lra|]; clear z Hz; unfold certZ in H; rewrite (path_final a1 a2 K w i j (proj1 HW)) in H; cbv zeta in H.
  set (V := vertices K w) in *; set (l := combine (map fst V) vv) in *; set (M := (i + j)%nat) in *;
    set (m := Nat.min i j) in *.
  rewrite !andb_true_iff, !forallb_forall, !Z.ltb_lt, Nat.leb_le in H;
    destruct H as [[[[[[A0 AB] S0] M1] HV] Hrow] Hstar].
  assert (HV' : forall x, In x V -> (0 < entry l (fst x))%Z /\ (fst x <= M)%nat) by (intros x Hx; specialize (HV x Hx);
    rewrite andb_true_iff, Z.ltb_lt, Nat.leb_le in HV; exact HV).
  pose proof (IZR_lt _ _ A0) as A0r; pose proof (IZR_lt _ _ AB) as ABr; pose proof (IZR_lt _ _ S0) as S0r;
    set (q := IZR a / IZR b) in *.
  assert (Hq : 0 < q < 1) by (unfold q; split; [apply Rdiv_lt_0_compat; lra | apply (Rmult_lt_reg_r (IZR b)); [lra|];
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra]).
  assert (Hmq : 0 < 1 - q ^ m) by (assert (q ^ m < 1) by (apply pow_lt_1_compat; [lra | lia]); lra).
  assert (Qb : forall k, q ^ k * IZR b ^ k = IZR a ^ k) by (intros k; rewrite <- Rpow_mult_distr; f_equal; unfold q;
    field; lra).
  set (t := q ^ M / (1 - q ^ m)).
  assert (Row : forall F x, incl F V -> (a ^ Z.of_nat M * b ^ Z.of_nat m * vs <=? (b ^ Z.of_nat m - a ^ Z.of_nat m)
    * (x * b ^ Z.of_nat M - scaledZ a b M l F))%Z = true -> weighed_sum q (fun n => IZR (entry l n)) F + t * IZR vs
    <= IZR x).
  { intros F x HF Hx; apply Z.leb_le, IZR_le in Hx; rewrite !mult_IZR, !minus_IZR, !mult_IZR, <- !pow_IZR in Hx.
    rewrite (scaled_sum a b M l F ltac:(lia)) in Hx by (intros y Hy; apply HV', HF, Hy); fold q in Hx.
    set (S := weighed_sum q _ F) in *; rewrite <- (Qb M), <- (Qb m) in Hx; set (bM := IZR b ^ M) in *;
      set (bm := IZR b ^ m) in *.
    assert (0 < bM) by (apply pow_lt; lra); assert (0 < bm) by (apply pow_lt; lra).
    assert (X : q ^ M * IZR vs <= (1 - q ^ m) * (IZR x - S)).
    { apply (Rmult_le_reg_r (bM * bm)); [apply Rmult_lt_0_compat; assumption|];
        apply Rle_trans with (q ^ M * bM * bm * IZR vs); [lra|].
      apply Rle_trans with (1 := Hx); right; ring. }
    assert (Y : t * IZR vs <= IZR x - S); [|lra].
    { apply (Rmult_le_reg_l (1 - q ^ m)); [assumption|]; replace ((1 - q ^ m) * (t * IZR vs)) with (q ^ M * IZR vs)
        by (unfold t; field; lra); exact X. } }
  apply (cylinder a1 a2 K first q g (fun n => IZR (entry l n)) (IZR vs) t w i j HW); [lra | lra | | | |].
  - intros x Hx; apply IZR_lt, HV', Hx.
  - intros X HN HX; apply (later_sum a1 a2 K first q w i j X); [lra | apply HW | exact HN | exact HX].
  - intros x Hx; apply Row; [intros y Hy; apply filter_In in Hy; apply Hy | apply Hrow, Hx].
  - apply Row; [intros y Hy; exact Hy | exact Hstar].
Qed.
