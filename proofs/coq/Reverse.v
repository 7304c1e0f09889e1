(** * Reversal of time: a1/a2 and 1/a2 have the orbits of a1 and a2, so that a2 > 1
    needs no theory of its own (section 3.2) *)

From Coq Require Import Reals Lra Lia.
From Grazing Require Import Defs Statement StatementPlane Algebra.
Open Scope R_scope.

Section Reversal.
Variables a1 a2 : R.
Hypothesis a2_pos : 0 < a2.
Notation u' := (u (a1 / a2) (/ a2)).
Notation u := (u a1 a2).

Lemma power_nonzero k : a2 ^ k <> 0. Proof. apply pow_nonzero; lra. Qed.

Lemma u_reversed k : u' k = a2 * u k / a2 ^ k.
Proof.
  induction k as [| |k IH IH'] using two_step; [rewrite !u_0; cbn; field | rewrite !u_1; cbn; field; lra |].
  rewrite !u_SS, IH, IH'; cbn [pow]; field; split; [apply power_nonzero | lra].
Qed.

Lemma u_reversed_zero n : u' n <> 0 <-> u n <> 0.
Proof.
  rewrite u_reversed; split; intros H E; apply H.
  - rewrite E; field; apply power_nonzero.
  - replace (u n) with (a2 * u n / a2 ^ n * (a2 ^ n / a2)) by (field; split; [lra | apply power_nonzero]).
    rewrite E; ring.
Qed.

Lemma b_reversed n k : u n <> 0 -> (k <= n)%nat -> b (a1 / a2) (/ a2) n k = b a1 a2 n (n - k).
Proof.
  intros Hu Hk; unfold b; rewrite !u_reversed, pow_inv; replace (n - (n - k))%nat with k by lia.
  replace (a2 ^ n) with (a2 ^ k * a2 ^ (n - k)) by (rewrite <- pow_add; f_equal; lia).
  field; repeat split; auto using power_nonzero; lra.
Qed.

Lemma c_reversed n : u n <> 0 -> c (a1 / a2) (/ a2) n = c a1 a2 n / a2.
Proof.
  intros Hu; unfold c, v; rewrite !u_reversed, pow_inv; cbn [pow]. field; repeat split; auto using power_nonzero; lra.
Qed.

(** A family of conditions on k = 1 .. n-1 is the same on n - k. *)
Lemma all_reversed (P : nat -> Prop) n : (forall k, (1 <= k <= n - 1)%nat -> P (n - k)%nat) <->
  (forall k, (1 <= k <= n - 1)%nat -> P k).
Proof. split; intros H k Hk; [|apply H; lia]. replace k with (n - (n - k))%nat by lia; apply H; lia. Qed.

Lemma orbit_reversed n e g : orbit (a1 / a2) (/ a2) n e g <-> orbit a1 a2 n e g.
Proof.
  unfold orbit; rewrite u_reversed_zero.
  assert (Hdep : forall P Q R : Prop, (P -> (Q <-> R)) -> (P /\ Q <-> P /\ R)) by tauto.
  apply Hdep; intros Hu; rewrite c_reversed by assumption. rewrite <- (all_reversed (fun k => sgn e * b a1 a2 n k > 0)).
  assert (Hb : forall k, (1 <= k <= n - 1)%nat -> (sgn e * b (a1 / a2) (/ a2) n k > 0 <-> sgn e * b a1 a2 n (n - k)
    > 0)) by (intros k Hk; rewrite b_reversed by (trivial; lia); tauto).
  assert (Hc : sgn e * sgn g * (c a1 a2 n / a2) > 0 <-> sgn e * sgn g * c a1 a2 n > 0).
  { replace (sgn e * sgn g * (c a1 a2 n / a2)) with (sgn e * sgn g * c a1 a2 n * / a2) by (unfold Rdiv; ring).
    pose proof (Rinv_0_lt_compat a2 a2_pos); split; intros; [nra|apply Rmult_lt_0_compat; lra]. }
  rewrite Hc; split; intros [H H']; (split; [intros k Hk; apply (Hb k Hk), (H k Hk)|assumption]).
Qed.

Lemma no_orbit_reversed n : no_orbit (a1 / a2) (/ a2) n <-> no_orbit a1 a2 n.
Proof.
  unfold no_orbit; rewrite u_reversed_zero; split; intros (Hu & k & k' & Hk & Hk' & H & H'); (split; [assumption|]);
    exists (n - k)%nat, (n - k')%nat; repeat split; try lia.
  - rewrite <- b_reversed by (trivial; lia); assumption.
  - rewrite <- b_reversed by (trivial; lia); assumption.
  - rewrite b_reversed by (trivial; lia); replace (n - (n - k))%nat with k by lia; assumption.
  - rewrite b_reversed by (trivial; lia); replace (n - (n - k'))%nat with k' by lia; assumption.
Qed.
End Reversal.

Theorem Reversal : Reversal_statement.
Proof.
  intros a1 a2 n H; split; [apply u_reversed_zero, H|split; [|split]].
  - intros Hu; split; [apply c_reversed; assumption|intros; apply b_reversed; assumption].
  - intros; apply orbit_reversed, H.
  - apply no_orbit_reversed, H.
Qed.
