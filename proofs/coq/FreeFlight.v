(** * While nothing impacts, the iterates of a map with impacts are those without *)

From Coq Require Import Arith Lia.

Section Free.
Variables (T : Type) (F f : T -> T) (free : T -> Prop).
Hypothesis HF : forall x, free (f x) -> F x = f x.

(** Both readings of "nothing impacts" are needed. *)
Lemma iterates_free x m : (forall k, (k < m)%nat -> free (Nat.iter (S k) f x)) -> Nat.iter m F x = Nat.iter m f x.
Proof.
  induction m as [|m IH]; intros H; [reflexivity|]. change (F (Nat.iter m F x) = f (Nat.iter m f x)).
  rewrite IH by (intros; apply H; lia); apply HF, (H m); lia.
Qed.

Lemma iterates_free' x m : (forall k, (k < m)%nat -> free (f (Nat.iter k F x))) -> Nat.iter m F x = Nat.iter m f x.
Proof.
  induction m as [|m IH]; intros H; [reflexivity|]. pose proof (H m (Nat.lt_succ_diag_r m)) as Hm.
  change (F (Nat.iter m F x) = f (Nat.iter m f x)). rewrite IH in * by (intros; apply H; lia); apply HF, Hm.
Qed.
End Free.
