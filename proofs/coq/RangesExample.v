(** * A certificate of README's machine passes the check inside Coq: the impacts one period apart that are
  born at its touch, up to nu = 1/50, are a theorem without conditions *)

From Grazing Require Import RangesCheck RangesLinks ConsequencesRanges.

Lemma checked_born : check_range born = true. Proof. vm_cast_no_check (eq_refl true). Qed.
Definition born_motion := a_motion check_range Ranges checked_born.
