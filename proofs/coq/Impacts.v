(** * Formulas (61) and (64) and det D from the linear problem of an impact pattern *)

From Coq Require Import Reals Lra.
From Grazing Require Import Defs Statement StatementPlane StatementImpacts MatrixForm.
Open Scope R_scope.

Theorem Impacts : Impacts_statement.
Proof.
  intros J next n a1 a2 beta X Y Hsur Hu Hb; unfold impacts, single_impact; cbv zeta; split.
  - intros H j; destruct (H j) as [E1 E2], (Hsur j) as [i Ei]. destruct (H i) as [F1 F2]; rewrite Ei in F2.
    assert (E : fst (X j) = -1) by (rewrite F2; exact F1). split; [rewrite E, E1; split; [ring | reflexivity]|].
    rewrite E2; cbn [snd]; field; assumption.
  - intros H j; destruct (H j) as [[E1 E2] E3]; destruct (H (next j)) as [[_ F] _].
    assert (E : fst (apply (mpow (A a1 a2) (n j)) (X j)) = -1) by lra; split; [assumption|].
    rewrite (surjective_pairing (X (next j))), F, E; f_equal. rewrite E3; field; assumption.
Qed.

Theorem Single_impact : Single_impact_statement.
Proof.
  intros a1 a2 beta n X Y Hu Hb H.
  destruct (proj1 (Impacts unit _ _ a1 a2 beta _ _ (fun j => ex_intro _ j eq_refl) (fun _ => Hu) Hb) H tt) as [HX ->];
    destruct (Matrix_form a1 a2 n Hu) as (_ & _ & E).
  destruct (E X HX) as (_ & _ & ->); reflexivity.
Qed.

Theorem Large_formula : Large_formula_statement.
Proof.
  intros K gamma emu a1 a2 n X Y HK Hg He Hu Hd H.
  assert (Hb : K * gamma <> 0) by (apply Rmult_integral_contrapositive; split; assumption).
  apply Single_impact in H; [subst Y | assumption..].
  rewrite power_of_A; cbn [m12]; unfold large, c; field; repeat split; lra || assumption.
Qed.

Theorem Det_D : Det_D_statement.
Proof. intros a1 a2 beta n M; unfold M; rewrite power_of_A; unfold det3; cbn [m11 m12 m21 m22]; ring. Qed.
