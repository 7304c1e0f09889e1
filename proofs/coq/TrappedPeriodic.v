(** A periodic motion that impacts has margins; with [Not_stable]: no periodic motion in D is stable. *)
From Coq Require Import Reals ZArith Lra Lia Wf_nat.
From Grazing Require Import Derivatives StatementOscillator.
From Grazing Require Import StatementTrapped TrappedCalculus TrappedFlow TrappedReturn TrappedMain
  TrappedSeparate TrappedUnstable TrappedExists.
Open Scope R_scope.

Section Periodic.
Variables (M : machine) (lo hi : R).
Hypothesis H : hump M lo hi.
Hypothesis Hb : 0 < alb M /\ least_slip M <= zm M /\ least_speed M <= Vm M.
Hypothesis Ho : 0 < alo M.
Variables (K : nat) (P : Z) (N : nat -> Z) (t V : nat -> R) (x v : nat -> R -> R).
Hypothesis HK : (1 <= K)%nat.
Hypothesis HM : motion M lo hi N t V x v.
Hypothesis Tr : forall i, trapped M (t i) (V i).
Hypothesis Per : periodic M K P N t V.
Notation p := (p M). Notation Q := (Q M). Notation Q1 := (Q1 M).

Lemma again_free i s : x (i + K)%nat (s + p * IZR P) = x i s.
Proof.
  pose proof (overdamped _ _ _ H) as Hab; destruct (Per i) as (_ & Et & EV). destruct (HM i) as [_ [F X0 V0 _ _ _ _]];
    destruct (HM (i + K)%nat) as [_ [F' X0' V0' _ _ _ _]]. rewrite (x_flow M Hab _ _ F (t i) s), (x_flow M Hab _ _ F'
    (t (i + K)%nat)), X0, X0', V0, V0', Et, EV, (Q_whole M lo hi H). rewrite (whole Q1 p (periodic_slope Q Q1 p
    (period _ _ _ H) (slope _ _ _ H))). replace (s + p * IZR P - (t i + p * IZR P)) with (s - t i) by ring; ring.
Qed.
Definition good m i : Prop := (V i = 0 \/ V i <= - m) /\
  forall k s, in_pass M lo hi k s -> (N i < k < N (S i))%Z -> Q s + m <= x i s.
Lemma good_less m m' i : m' <= m -> good m i -> good m' i.
Proof. intros L [[A|A] B]; split; [left; trivial| |right; lra|]; intros k s Hs Hk; specialize (B k s Hs Hk); lra. Qed.
Lemma good_shift m i : good m i -> good m (i + K).
Proof.
  intros [A B]; destruct (Per i) as (EN & Et & EV); destruct (Per (S i)) as (EN1 & _); split; [rewrite EV;
    trivial|]. intros k s Hs Hk; replace (S (i + K)) with (S i + K)%nat in Hk by lia; rewrite EN, EN1 in Hk.
  assert (Ps : in_pass M lo hi (k - P) (s - p * IZR P)) by (unfold in_pass in *; rewrite minus_IZR; lra).
  specialize (B (k - P)%Z (s - p
    * IZR P) Ps ltac:(lia)). pose proof (again_free i (s - p * IZR P)) as E; replace (s - p * IZR P + p * IZR P) with
    s in E by ring. pose proof (Q_whole M lo hi H P (s - p * IZR P)) as EQ; replace (s - p * IZR P + p * IZR P) with s
      in EQ by ring; lra.
Qed.
Lemma good_one i : exists m, 0 < m /\ good m i.
Proof.
  assert (A : exists m, 0 < m /\ (V i = 0 \/ V i <= - m)).
  { destruct (Tr i) as (_ & h & _); destruct (Req_dec (V i) 0) as [Z|Z]; [exists 1; split; [lra|left;
      trivial]|]. exists (- V i); split; [lra|right; lra]. }
  destruct A as (m1 & m1p & A); destruct (HM i) as [Pi [F _ _ Lt Op _ _]]; destruct (HM (S i)) as [Pi1 _].
  destruct (Z_lt_le_dec (N i + 1) (N (S i))) as [L|L].
  - set (c := lo + p * IZR (N i + 1)); set (d := hi + p * IZR (N (S i) - 1)). destruct (sizes M _ _ H) as [w1 w2].
    assert (Cd : c <= d).
    { unfold c, d; assert (IZR (N i + 1) <= IZR (N (S i) - 1)) by (apply IZR_le; lia). assert (p * IZR (N i + 1) <= p
        * IZR (N (S i) - 1)) by (apply Rmult_le_compat_l; lra); lra. }
    assert (In : t i < c /\ d < t (S i)).
    { split; [apply (pass_order M lo hi H (N i) (N i + 1))|apply (pass_order M lo hi H (N (S i) - 1) (N (S i)))];
        trivial; try lia; unfold in_pass, c, d; lra. }
    destruct (continuity_ab_min (fun s => x i s - Q s) c d Cd) as (y & Hy & Hi).
    { intros s _; apply continuity_pt_minus; [eapply D_continuous, F|eapply D_continuous, (slope _ _ _ H)]. }
    specialize (Op y ltac:(lra)); destruct (two_least m1 (x i y - Q y) m1p ltac:(lra)) as (m & m0 & l1 & l2).
    exists m; split; trivial; split; [destruct A; [left; trivial|right; lra]|]. intros k s Hs Hk;
      assert (c <= s <= d); [|specialize (Hy s H0); lra]. unfold c, d, in_pass in *; assert (IZR (N i + 1) <= IZR k)
      by (apply IZR_le; lia). assert (IZR k <= IZR (N (S i) - 1)) by (apply IZR_le; lia).
    assert (p * IZR (N i + 1) <= p * IZR k) by (apply Rmult_le_compat_l; lra). assert (p * IZR k <= p * IZR (N (S i) -
      1)) by (apply Rmult_le_compat_l; lra); lra.
  - exists m1; split; trivial; split; trivial; intros; lia.
Qed.
Lemma good_all : exists m, 0 < m /\ forall i, good m i.
Proof.
  assert (F : forall n, exists m, 0 < m /\ forall i, (i < n)%nat -> good m i).
  { induction n as [|n (m1 & p1 & G1)]; [exists 1; split; [lra|intros; lia]|]. destruct (good_one n) as (m2 & p2 &
      G2); destruct (two_least m1 m2 p1 p2) as (m & m0 & l1 & l2). exists m; split; trivial; intros i Hi;
      destruct (Nat.eq_dec i n) as [->|Ne]; [apply (good_less m2); trivial|]. apply (good_less m1); trivial;
      apply G1; lia. }
  destruct (F K) as (m & m0 & G); exists m; split; trivial; intros i; induction i as [i IH]
    using (well_founded_induction lt_wf). destruct (Nat.lt_ge_cases i K) as [L|L]; [apply G, L|].
  replace i with (i - K + K)%nat by lia; apply good_shift, IH; lia.
Qed.
Lemma margins : V 0%nat < 0 -> exists m, margin M lo hi m N t V x.
Proof.
  intros Neg; destruct good_all as (m & m0 & G); exists m; split; trivial.
  - intros i; apply G.
  - assert (Z : forall q, V (q * K)%nat = V 0%nat).
    { induction q as [|q IH]; [reflexivity|]; cbn; rewrite Nat.add_comm; rewrite (proj2 (proj2 (Per _))); trivial. }
    intros i; exists (i * K - i)%nat; replace (i + (i * K - i))%nat with (i * K)%nat by nia; rewrite Z; trivial.
  - intros i k s Hs Hk; apply (proj2 (G i) k s Hs Hk).
Qed.
End Periodic.

(** (iv) where the first contact is an impact with zeta < zm. *)
Theorem periodic_departs M lo hi E K P N t V x v : chaotic M lo hi E -> 0 < tau M -> (1 <= K)%nat ->
  stays M lo hi N t V x v -> periodic M K P N t V -> V 0%nat < 0 -> zeta M (t 0%nat) (V 0%nat) < zm M ->
  departs M lo hi t V x.
Proof.
  intros Ch Ht HK St Per Neg Zs; pose proof Ch as [[H Hb Ho] _ _]; pose proof St as [HM Tr].
  destruct (margins M lo hi H K P N t V x v HK HM Tr Per Neg) as (m & Mg). apply (margins_depart M lo hi E m N t V x v
    Ch Ht St Mg Neg Zs).
Qed.
