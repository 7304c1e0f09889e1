(** * No point has the word D D D ..., nor U D U U U ...: with damping words end, and on r = 1 s would be 1/2 or 1/4 *)

From Coq Require Import Reals List Arith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementWords Coordinates WordPath WordGraph WordPlane
  WordFinite PatternSums.
Import ListNotations. Open Scope R_scope.

Lemma repeat_snoc {T} (x : T) a : repeat x a ++ [x] = repeat x (S a).
Proof. induction a as [|a IH]; [reflexivity | cbn in *; rewrite IH; reflexivity]. Qed.
Definition wa (a : nat) : list letter := U :: D :: repeat U a.
Lemma wa_snoc a : wa a ++ [U] = wa (S a). Proof. unfold wa; cbn [app]; rewrite repeat_snoc; reflexivity. Qed.

(** ** The Stern-Brocot paths *)
Lemma stern_last s K w x m1 n1 m2 n2 : stern s K (w ++ [x]) m1 n1 m2 n2 -> exists m1' n1' m2' n2',
  stern s K w m1' n1' m2' n2' /\ match x with D => (m1 = m1' + m2' /\ n1 = n1' + n2' /\ m2 = m2' /\ n2 = n2')%nat /\
  INR m1 < s * INR n1 | U => (m1 = m1' /\ n1 = n1' /\ m2 = m1' + m2' /\ n2 = n1' + n2')%nat /\ s * INR n2 < INR m2 end.
Proof.
  intros H; remember (w ++ [x]) as w' eqn:E; destruct H as [|w0 m1 n1 m2 n2 H L|w0 m1 n1 m2 n2 H L];
    [destruct w; discriminate| |]; apply app_inj_tail in E; destruct E as [-> <-]; exists m1, n1, m2, n2;
    (split; [exact H | split; [repeat split | exact L]]).
Qed.
Lemma stern_nil s K m1 n1 m2 n2 : stern s K [] m1 n1 m2 n2 -> (m1 = 0 /\ n1 = 1 /\ m2 = 1 /\ n2 = K)%nat.
Proof. intros H; remember [] as w eqn:E; destruct H as [|w|w]; [auto | destruct w; discriminate | destruct w;
    discriminate]. Qed.
Lemma stern_D_run s a : forall m1 n1 m2 n2, stern s 2 (repeat D a) m1 n1 m2 n2 ->
  (m1 = a /\ n1 = 2 * a + 1 /\ m2 = 1 /\ n2 = 2)%nat /\ (a <> 0%nat -> INR a < s * (2 * INR a + 1)).
Proof.
  induction a as [|a IH]; intros m1 n1 m2 n2 H; [apply stern_nil in H; split; [lia | congruence]|].
  rewrite <- repeat_snoc in H; apply stern_last in H; destruct H as (m1' & n1' & m2' & n2' & H & E & L); apply IH in H;
    destruct H as [H _].
  assert (m1 = S a) as -> by lia; assert (n1 = 2 * S a + 1)%nat as -> by lia; split; [lia|]; intros _; rewrite plus_INR,
    mult_INR in L; simpl (INR 2) in L; exact L.
Qed.
Lemma stern_U_run s a : forall m1 n1 m2 n2, stern s 2 (wa a) m1 n1 m2 n2 ->
  (m1 = 1 /\ n1 = 4 /\ m2 = a + 1 /\ n2 = 4 * a + 3)%nat /\ (a <> 0%nat -> s * (4 * INR a + 3) < INR a + 1).
Proof.
  induction a as [|a IH]; intros m1 n1 m2 n2 H.
  - change (wa 0) with (([] ++ [U]) ++ [D]) in H; apply stern_last in H;
      destruct H as (m1' & n1' & m2' & n2' & H & E & _).
    apply stern_last in H; destruct H as (m1'' & n1'' & m2'' & n2'' & H & E' & _); apply stern_nil in H; split;
      [lia | congruence].
  - rewrite <- wa_snoc in H; apply stern_last in H; destruct H as (m1' & n1' & m2' & n2' & H & E & L); apply IH in H;
      destruct H as [H _].
    assert (m2 = S a + 1)%nat as -> by lia; assert (n2 = 4 * S a + 3)%nat as -> by lia; split; [lia|]; intros _.
    rewrite !plus_INR, mult_INR in L; simpl (INR 4) in L; simpl (INR 3) in L; simpl (INR 1) in L; lra.
Qed.

(** A whole number at which a line that falls is below 0. *)
Lemma line_falls b c : 0 < b -> exists a, a <> 0%nat /\ c - b * INR a < 0.
Proof.
  intros Hb; destruct (archimed (Rabs (c / b))) as [A _]; pose proof (Rabs_pos (c / b)) as P;
    set (z := up (Rabs (c / b))) in *.
  assert (Z0 : (0 < z)%Z) by (apply lt_IZR; lra); exists (Z.to_nat z); split; [lia|]; rewrite INR_IZR_INZ, Z2Nat.id
    by lia; pose proof (Rle_abs (c / b)).
  assert (b * (c / b) < b * IZR z) by (apply Rmult_lt_compat_l; lra); replace (b * (c / b)) with c in * by (field; lra);
    lra.
Qed.

Section Point.
Variables a1 a2 : R.
Hypothesis first : first_upper a1 a2 2.
Notation in_word := (in_word a1 a2 2).

(** Words w 0, w 1, ..., each with a letter x more: without damping, and on r = 1. *)
Lemma endless w i j x : (forall a, in_word (w a) (i a) (j a)) -> (forall a, w a ++ [x] = w (S a)) ->
  (forall a, (a <= i a + j a)%nat) -> exists s, 1 / 4 < s < 1 / 2 /\ forall a, exists m1 m2, stern s 2 (w a) m1 (i a) m2
  (j a).
Proof.
  intros HW Hx Hl; destruct (first) as ((A0 & A1) & B & _); assert (E : a2 = 1).
  { destruct (Rle_lt_or_eq_dec a2 1 A1) as [L|E]; [exfalso | exact E]; destruct (V_finite a1 a2 2%nat first L)
      as [N HN]; destruct (HW (S (S N))) as [_ HV].
    rewrite <- (Hx (S N)), (vertices_snoc a1 a2 2 _ _ _ x (proj1 (HW (S N)))), Forall_app in HV; destruct HV as [_ HV];
      apply Forall_inv in HV.
    specialize (Hl (S N)); cbn [fst] in HV; apply (HN (i (S N) + j (S N))%nat); [lia | exact HV]. }
  rewrite E in B; rewrite sqrt_1 in B; destruct (Coordinates a1 a2 ltac:(rewrite E; nra))
    as (r & s & Hr & Hs & E1 & E2 & _).
  assert (r = 1) by nra; subst r; destruct (proj2 (proj2 Path) 1 s 2%nat ltac:(lra) Hs) as [F P]; rewrite <- E1,
    <- E2 in F, P; apply (proj1 F) in first as S2.
  exists s; split; [simpl in S2; lra|]; intros a; apply (P first), HW.
Qed.
Theorem no_D_without_end : ~ forall a, in_word (repeat D a) (2 * a + 1) 2.
Proof.
  intros H; destruct (endless (repeat D) (fun a => 2 * a + 1)%nat (fun _ => 2%nat) D H (repeat_snoc D) ltac:(intros;
    cbv beta; lia)) as (s & Hs & P).
  destruct (line_falls (1 - 2 * s) s ltac:(lra)) as (a & A & L); destruct (P a) as (m1 & m2 & Q);
    apply stern_D_run in Q; destruct Q as [_ Q]; specialize (Q A); lra.
Qed.
Theorem no_U_without_end : ~ forall a, in_word (wa a) 4 (4 * a + 3).
Proof.
  intros H; destruct (endless wa (fun _ => 4%nat) (fun a => 4 * a + 3)%nat U H wa_snoc ltac:(intros; cbv beta; lia))
    as (s & Hs & P).
  destruct (line_falls (4 * s - 1) (1 - 3 * s) ltac:(lra)) as (a & A & L); destruct (P a) as (m1 & m2 & Q);
    apply stern_U_run in Q; destruct Q as [_ Q]; specialize (Q A); lra.
Qed.
End Point.
