(** * u, b and c are what powers of A and the equations (51), (54)-(60) say *)

From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import Defs StatementPlane Algebra.
Open Scope R_scope.

(** (56), with u_{k+1} - a1 u_k = -a2 u_{k-1} so that k = 0 is included. *)
Lemma power_of_A a1 a2 k : mpow (A a1 a2) k = Mat (u a1 a2 (S k)) (u a1 a2 k) (- a2 * u a1 a2 k)
  (u a1 a2 (S k) - a1 * u a1 a2 k).
Proof.
  induction k as [|k IH]; cbn [mpow].
  - rewrite u_1, u_0; unfold one; f_equal; ring.
  - rewrite IH; unfold mul, A; cbn [m11 m12 m21 m22]; rewrite !u_SS; f_equal; ring.
Qed.

Lemma single_impact_iff a1 a2 n X : u a1 a2 n <> 0 ->
  single_impact a1 a2 n X <-> X = (-1, (u a1 a2 (S n) - 1) / u a1 a2 n).
Proof.
  intros Hu; destruct X as [X1 X2]; unfold single_impact, apply. rewrite power_of_A; cbn [fst snd m11 m12]; split.
  - intros [E ->]; f_equal. apply Rmult_eq_reg_l with (u a1 a2 n); [|assumption].
    replace (u a1 a2 n * (_ / u a1 a2 n)) with (u a1 a2 (S n) - 1) by (field; assumption). lra.
  - intros E; injection E as -> ->; split; [field; assumption | reflexivity].
Qed.

Theorem Matrix_form : Matrix_statement.
Proof.
  intros a1 a2 n Hu; refine (conj _ (conj _ _)).
  - rewrite power_of_A, !u_SS; f_equal; ring.
  - eexists; apply single_impact_iff; [assumption | reflexivity].
  - intros X HX; apply single_impact_iff in HX; [subst X | assumption]. refine (conj eq_refl (conj _ _)).
    + intros k Hk; rewrite b_is_1_plus_x by assumption; unfold apply, orbit_x.
      rewrite power_of_A; cbn [fst snd m11 m12]; ring.
    + unfold apply; rewrite power_of_A; cbn [fst snd m21 m22]; unfold c, v.
      pose proof (u_Cassini a1 a2 n) as E; rewrite <- E; field; assumption.
Qed.

Theorem Trace_form : Trace_statement.
Proof.
  intros a1 a2 n; cbv zeta; rewrite power_of_A; cbn [m11 m12 m21 m22].
  rewrite <- (u_Cassini a1 a2 n); unfold v; split; ring.
Qed.
