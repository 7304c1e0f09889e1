(** * Finitely many conditions that ask for something small are met by one number *)

From Coq Require Import Reals Lra Lia.
Open Scope R_scope.

(** P k d says that d is small enough for the k-th condition. *)
Lemma common_bound (P : nat -> R -> Prop) n : (forall k d d', P k d -> 0 < d' <= d -> P k d') ->
  (forall k, (k < n)%nat -> exists d, 0 < d /\ P k d) -> exists d, 0 < d /\ forall k, (k < n)%nat -> P k d.
Proof.
  intros Hdown; induction n as [|n IH]; intros H; [exists 1; split; [lra | lia]|].
  destruct IH as (d & Hd & Hall); [intros; apply H; lia|]. destruct (H n (Nat.lt_succ_diag_r n)) as (d' & Hd' & Hn).
  assert (Hmin : 0 < Rmin d d') by (apply Rmin_glb_lt; assumption).
  exists (Rmin d d'); split; [assumption|]; intros k Hk. destruct (Nat.eq_dec k n) as [->|Hne].
  - apply (Hdown n d'); [assumption | split; [assumption | apply Rmin_r]].
  - apply (Hdown k d); [apply Hall; lia | split; [assumption | apply Rmin_l]].
Qed.
