(** (iii) at a contact: the matrices of impact and flight keep the cone and stretch. *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Derivatives StatementOscillator.
From Grazing Require Import StatementTrapped TrappedCalculus TrappedFlow TrappedReturn TrappedMain
  TrappedSeparate.
Open Scope R_scope.

Section Cone.
Variables (M : machine) (lo hi : R).
Hypothesis H : hump M lo hi.
Hypothesis Hb : 0 < alb M /\ least_slip M <= zm M /\ least_speed M <= Vm M.
Hypothesis Ho : 0 < alo M.
Notation a := (a M). Notation b := (b M). Notation tau := (tau M). Notation Q := (Q M). Notation Q1 := (Q1 M).
Notation D := (StatementTrapped.b M - StatementTrapped.a M).
Let Hab := overdamped _ _ _ H.
Let Htau := restitution _ _ _ H.

Lemma acc_least t k u z : in_pass M lo hi k t -> 0 <= Q t -> 0 <= a * Q t + u <= z ->
  al0 M - b ^ 2 * z / D <= acc M t u.
Proof.
  intros Hk HQ Hz; destruct (free_from M t (Q t) u) as (x & v & F & X0 & V0). pose proof (acc_forward M lo hi H x v t
    t z F ltac:(lra) ltac:(unfold zet; rewrite X0, V0; trivial) ltac:(lra)) as A. pose proof (bent _ _ _ (hump_shift M
    lo hi H k) t Hk); rewrite X0, V0 in A; unfold acc; lra.
Qed.
Lemma jump_least t k V : in_pass M lo hi k t -> trapped M t V -> sigma M <= jump M t V.
Proof.
  intros Hk (h1 & h2 & h3); unfold jump, sigma, zeta in *. assert (A : al0 M - b ^ 2 * zm M / D <= acc M t (Q1 t + V))
    by (apply (acc_least t k); trivial; lra). assert (tau * - V <= tau * Vm M) by (apply Rmult_le_compat_l;
    lra); assert (0 <= tau * - V) by (apply Rmult_le_pos; lra). assert (B : alo M <= acc M t (Q1 t - tau * V)) by
    (apply (acc_least t k); trivial; lra). assert (tau * (al0 M - b ^ 2 * zm M / D) <= tau * acc M t (Q1 t + V)) by
    (apply Rmult_le_compat_l; lra); lra.
Qed.

Lemma upper_half V T d w E S : V < 0 -> - Vm M <= V -> 0 <= T -> sigma M <= S -> E * Vm M <= sigma M * phi12 M
  T ->
  0 <= d -> 0 <= a * d + w ->
  let d1 := - tau * d in let w1 := - tau * w + S * d / V in
  let d2 := phi11 M T * d1 + phi12 M T * w1 in let w2 := phi21 M T * d1 + phi22 M T * w1 in
  (d1 <= 0 /\ a * d1 + w1 <= 0) /\ (d2 <= 0 /\ a * d2 + w2 <= 0) /\ E * d <= - d2.
Proof.
  intros HV HVm HT HS HE Hd Hz d1 w1 d2 w2. pose proof (sigma_pos M lo hi H Hb Ho) as Sp;
    pose proof (Vm_pos M lo hi H Hb) as Vp; pose proof (phi12_pos M Hab T HT) as Pp. pose proof (exp_pos (- a * T)) as
    Ea; pose proof (exp_pos (- b
    * T)) as Eb. assert (Iv : 0 < / - V) by (apply Rinv_0_lt_compat; lra). assert (T1 : 0 <= tau * d) by (apply
    Rmult_le_pos; lra); assert (T2 : 0 <= tau * (a * d + w)) by (apply Rmult_le_pos; lra).
    set (r := S * d * / - V); assert (R0 : 0 <= r) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]).
    assert (E1 : a * d1 + w1 = - (tau * (a * d + w)) - r) by (unfold d1, w1, r; field; lra).
    assert (E2 : d2 = exp (- a * T) * d1 + phi12 M T * (a * d1 + w1)) by (unfold d2, phi11, phi12; field; lra).
    assert (E3 : a * d2 + w2 = exp (- b * T) * (a * d1 + w1)) by (unfold d2, w2, phi11, phi12, phi21, phi22, phi12;
      field; lra). assert (Hr : E * d <= phi12 M T * r).
  { destruct (Rle_or_lt E 0) as [NE|PE].
    - assert (0 <= phi12 M T * r) by (apply Rmult_le_pos; trivial); nra.
    - unfold r; apply Rmult_le_reg_r with (- V); [lra|]. replace (phi12 M T * (S * d * / - V) * - V) with (S * phi12 M
        T * d) by (field; lra). assert (E * - V <= E * Vm M) by (apply Rmult_le_compat_l; lra).
      assert (sigma M * phi12 M T <= S * phi12 M T) by (apply Rmult_le_compat_r; lra). replace (E * d * - V) with (E *
        - V * d) by ring; apply Rmult_le_compat_r; lra. }
  assert (F1 : exp (- a * T) * d1 <= 0) by (unfold d1; assert (0 <= exp (- a * T) * (tau * d)) by (apply Rmult_le_pos;
    lra); lra). assert (F2 : 0 <= phi12 M T * (tau * (a * d + w))) by (apply Rmult_le_pos; lra).
  assert (F3 : phi12 M T * (a * d1 + w1) = - (phi12 M T * (tau * (a * d + w))) - phi12 M T * r) by (rewrite E1;
    ring). assert (F4 : 0 <= phi12 M T * r) by (apply Rmult_le_pos; trivial). assert (F5 : 0 <= exp (- b * T) * (tau *
    (a * d + w) + r)) by (apply Rmult_le_pos; lra). repeat split; try lra; [unfold d1; lra|rewrite E3, E1; lra].
Qed.
End Cone.

Theorem Cone : Cone_statement.
Proof.
  intros M lo hi [H Hb Ho] t V t' V' x v k n d w E Tr HV L Hk Hk' HE HC d1 w1 d2 w2. destruct (return_trapped M lo hi
    H Hb Ho k t V t' V' x v Hk Tr L) as (Tr' & n' & Hn & Pn). assert (En : (k + n)%Z = (k + n')%Z) by apply (one_pass
    M lo hi H _ _ _ Hk' Pn); assert (1 <= n)%Z by lia. pose proof (far M lo hi H k n t V t' V' x v ltac:(trivial) Hk
    Hk' Tr Tr' L) as F. pose proof (apart_pass M lo hi H k n t t' Hk Hk') as Ap; destruct L as [_ _ _ Lt _ _ _].
  pose proof (rate M lo hi E H Hb Ho (IZR n) (t' - t) (t' - t) (t' - t) HE Ap ltac:(lra) ltac:(lra) F F) as R.
  pose proof (jump_least M lo hi H t k V Hk Tr) as J; assert (Hv : - Vm M <= V) by apply Tr.
  destruct HC as [[c1 c2]|[c1 c2]].
  - destruct (upper_half M lo hi H Hb Ho V (t' - t) d w E (jump M t V) HV Hv ltac:(lra) J R c1 c2) as (q1 & q2 & q3).
    fold d1 w1 in q1, q2, q3; fold d2 w2 in q2, q3; split; [right; trivial|split; [right; trivial|]].
    rewrite (Rabs_right d), (Rabs_left1 d2); lra.
  - destruct (upper_half M lo hi H Hb Ho V (t' - t) (- d) (- w) E (jump M t V) HV Hv ltac:(lra) J R ltac:(lra)
      ltac:(lra)) as (q1 & q2 & q3). assert (e1 : - tau M * - d = - d1) by (unfold d1; ring).
    assert (e2 : - tau M * - w + jump M t V * - d / V = - w1) by (unfold w1; field; lra). rewrite e1, e2 in *.
    assert (e3 : phi11 M (t' - t)
      * - d1 + phi12 M (t' - t) * - w1 = - d2) by (unfold d2; ring). assert (e4 : phi21 M (t' - t) * - d1 + phi22 M
      (t' - t) * - w1 = - w2) by (unfold w2; ring). rewrite e3, e4 in *; split; [left; lra|split; [left;
        lra|]]. rewrite (Rabs_left1 d), (Rabs_right d2); lra.
Qed.
