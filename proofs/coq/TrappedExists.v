(** From every contact in D there is a motion for ever, and it stays in D. Instability with the motions that
    leave. *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Contraction StatementOscillator Flow.
From Grazing Require Import StatementTrapped TrappedFlow TrappedReturn TrappedMain TrappedSeparate
  TrappedUnstable.
Open Scope R_scope.

(** From the first contact of a motion others leave with almost its speed that are, at some time, eps away. *)
Definition departs M lo hi (t V : nat -> R) (x : nat -> R -> R) : Prop :=
  exists eps, 0 < eps /\ forall d, 0 < d -> exists N' t' V' x' v', stays M lo hi N' t' V' x' v' /\
  t' 0%nat = t 0%nat /\ Rabs (V' 0%nat - V 0%nat) <= d /\
  exists i j s, t i <= s <= t (S i) /\ t' j <= s <= t' (S j) /\ eps < Rabs (x' j s - x i s).

Theorem Exists_ : Exists_statement.
Proof.
  intros M lo hi [H Hb Ho] t0 V0 Tr0; destruct (flow_exists (a M + b M) (a M * b M)) as (S1 & U1 & HF).
  set (xx := fun t V => moved (a M + b M) S1 U1 t (Q M t) (Q1 M t - tau M * V)). set (vv := fun t V => moving (a M * b
    M) S1 U1 t (Q M t) (Q1 M t - tau M * V)). set (next := fun t V => the (fun t' => exists V', leg M t V t' V' (xx t
    V) (vv t V))). set (st := fix st i := match i with O => (t0, V0) | S i => let t := fst (st i) in let V := snd (st
    i) in (next t V, vv t V (next t V) - Q1 M (next t V)) end). assert (Step : forall t V, trapped M t V -> leg M t V
    (next t V) (vv t V (next t V) - Q1 M (next t V)) (xx t V) (vv t V)).
  { intros t V Tr; pose proof (moved_free _ _ _ _ HF t (Q M t) (Q1 M t - tau M * V)) as F.
    destruct (moved_start _ _ _ _ HF t (Q M t) (Q1 M t - tau M * V)) as [X0 W0]; fold (xx t V) in *;
      fold (vv t V) in *. destruct (pass_of M lo hi H t (proj1 Tr)) as (k & Hk).
    destruct (next_exists M _ _ (hump_shift M lo hi H k) t V (xx t V) (vv t V) _ _ Hk Tr F X0 W0 Ho) as (t' & V' & L).
    assert (En : next t V = t').
    { apply the_spec; [exists V'; exact L|]; intros y (V'' & L'). destruct L as [_ _ _ Lt Op e _];
        destruct L' as [_ _ _ Lt' Op' e' _]. destruct (Rtotal_order y t') as [C|[C|C]]; trivial; exfalso;
        [specialize (Op y ltac:(lra))|specialize (Op' t' ltac:(lra))]; lra. }
    rewrite En; destruct L as [h1 h2 h3 h4 h5 h6 h7]; repeat split; trivial; apply h1. }
  assert (All : forall i, trapped M (fst (st i)) (snd (st i))).
  { induction i as [|i IH]; [exact Tr0|]; cbn; destruct (pass_of M lo hi H _ (proj1 IH)) as (k & Hk).
    apply (return_trapped M lo hi H Hb Ho k _ _ _ _ _ _ Hk IH (Step _ _ IH)). }
  exists (fun i => (up ((fst (st i) - lo) / p M)%R - 1)%Z), (fun i => fst (st i)), (fun i => snd (st i)), (fun i => xx
    (fst (st i)) (snd (st i))), (fun i => vv (fst (st i)) (snd (st i))). split; [split;
    [|exact All]|split; reflexivity]. intros i; split; [apply (pass_at M lo hi H);
    apply All|apply (Step _ _ (All i))].
Qed.

Theorem margins_depart M lo hi E m N t V x v : chaotic M lo hi E -> 0 < tau M -> stays M lo hi N t V x v ->
  margin M lo hi m N t V x -> V 0%nat < 0 -> zeta M (t 0%nat) (V 0%nat) < zm M -> departs M lo hi t V x.
Proof.
  intros Ch Ht St Mg Neg Zs; destruct (unstable M lo hi E m N t V x v Ch Ht St Mg) as (eps & e0 & U).
  exists eps; split; trivial; destruct St as [HM Tr]. intros d Hd; set (c := Rmin d (Rmin (- V 0%nat) (zm M - zeta M
    (t 0%nat) (V 0%nat)))). assert (C : 0 < c /\ c <= d /\ c <= - V 0%nat /\ c <= zm M - zeta M (t 0%nat) (V 0%nat))
    by (unfold c; set (q := zm M - zeta M (t 0%nat) (V 0%nat)); assert (0 < q) by (unfold q; lra);
    pose proof (Rmin_l d (Rmin (- V 0%nat) q)); pose proof (Rmin_r d (Rmin (- V 0%nat) q));
    pose proof (Rmin_l (- V 0%nat) q); pose proof (Rmin_r (- V 0%nat) q); split; [repeat apply Rmin_glb_lt;
    lra|lra]). clearbody c; assert (T1 : trapped M (t 0%nat) (V 0%nat + c)).
  { destruct (Tr 0%nat) as (h1 & h2 & h3); destruct C as (c0 & c1 & c2 & c3); split; [trivial|split;
      unfold zeta in *; lra]. }
  destruct (Exists_ M lo hi (chaotic_opens _ _ _ _ Ch) _ _ T1) as (N' & t' & V' & x' & v' & St' & Et & EV).
  exists N', t', V', x', v'; split; trivial; split; trivial; split. { rewrite EV, Rabs_right; lra.
  } apply Classical_Prop.NNPP; intros No; apply (U N' t' V' x' v' St' Et); [rewrite EV; lra|].
  intros i j s Hi Hj; apply Rnot_lt_le; intros L; apply No; exists i, j, s; repeat split; trivial; lra.
Qed.
