(** * Words of a graph are counted by a vector: M v <= v bounds their number from above, M v >= v from below *)

From Coq Require Import Reals List Arith Bool Lra Lia.
From Grazing Require Import StatementGraphs.
Import ListNotations. Open Scope R_scope.

Fixpoint sum_of {T} (L : list T) (f : T -> R) : R := match L with [] => 0 | x :: L => f x + sum_of L f end.

Lemma sum_app {T} (L L' : list T) f : sum_of (L ++ L') f = sum_of L f + sum_of L' f.
Proof. induction L as [|x L IH]; cbn; [ring | rewrite IH; ring]. Qed.
Lemma sum_le {T} (L : list T) f g : (forall x, In x L -> f x <= g x) -> sum_of L f <= sum_of L g.
Proof. induction L as [|x L IH]; cbn; intros H; [lra|]; apply Rplus_le_compat; [apply H; auto | apply IH; auto]. Qed.
Lemma sum_scale {T} (L : list T) f c : sum_of L (fun x => c * f x) = c * sum_of L f.
Proof. induction L as [|x L IH]; cbn; [ring | rewrite IH; ring]. Qed.
Lemma sum_plus {T} (L : list T) f g : sum_of L (fun x => f x + g x) = sum_of L f + sum_of L g.
Proof. induction L as [|x L IH]; cbn; [ring | rewrite IH; ring]. Qed.
Lemma sum_ext {T} (L : list T) f g : (forall x, In x L -> f x = g x) -> sum_of L f = sum_of L g.
Proof. intros H; apply Rle_antisym; apply sum_le; intros x Hx; rewrite H by assumption; lra. Qed.
Lemma sum_pos {T} (L : list T) f : (forall x, In x L -> 0 <= f x) -> 0 <= sum_of L f.
Proof. induction L as [|x L IH]; cbn; intros H; [lra|]; pose proof (H x (or_introl eq_refl));
    pose proof (IH (fun y Hy => H y (or_intror Hy))); lra. Qed.
Lemma sum_const {T} (L : list T) c : sum_of L (fun _ => c) = INR (length L) * c.
Proof. induction L as [|x L IH]; [cbn; ring | cbn [sum_of length]; rewrite IH, S_INR; ring]. Qed.
(** A part of a list of non-negative terms. *)
Lemma sum_incl {T} (L L' : list T) f : NoDup L -> incl L L' -> (forall x, In x L' -> 0 <= f x) -> sum_of L f <= sum_of
  L' f.
Proof.
  intros HN; revert L'; induction HN as [|x L Hx HN IH]; intros L' HI HP; [apply sum_pos, HP|].
  destruct (in_split x L' (HI x (or_introl eq_refl))) as (A & B & ->); rewrite sum_app; cbn [sum_of].
  specialize (IH (A ++ B)); rewrite sum_app in IH; enough (sum_of L f <= sum_of A f + sum_of B f) by lra; apply IH.
  - intros y Hy; specialize (HI y (or_intror Hy)); apply in_app_iff in HI; apply in_app_iff; cbn in HI.
    destruct HI as [HI|[<-|HI]]; tauto.
  - intros y Hy; apply HP; apply in_app_iff in Hy; apply in_app_iff; cbn; tauto.
Qed.

Section Graph.
Variables (G : graph) (z : R).
Hypothesis Hz : 0 < z <= 1.
Hypothesis Hp : forall i, vertex G i -> (1 <= periods_of G i)%nat.
Notation p := (periods_of G).
Definition weight (l : list nat) : R := z ^ total G l.

Lemma pow_z k : 0 < z ^ k. Proof. apply pow_lt; lra. Qed.
Lemma pow_z_le j k : (j <= k)%nat -> z ^ k <= z ^ j.
Proof.
  intros H; replace k with (j + (k - j))%nat by lia; rewrite pow_add; pose proof (pow_z j).
  assert (z ^ (k - j) <= 1) by (rewrite <- (pow1 (k - j)); apply pow_incr; lra); nra.
Qed.
Lemma exp_z k : exp (- ln z * INR k) * z ^ k = 1.
Proof.
  rewrite <- (exp_ln (z ^ k)) by apply pow_z; rewrite ln_pow by lra; rewrite <- exp_plus.
  replace (- ln z * INR k + INR k * ln z) with 0 by ring; apply exp_0.
Qed.
Lemma weight_cons x t : weight (x :: t) = z ^ p x * weight t.
Proof. unfold weight; cbn [total fold_right]; fold (total G t); apply pow_add. Qed.

(** ** Words by their first letter *)
Definition after (x : nat) (l : list nat) : list (list nat) := match l with [] => [] |
  y :: t => if (y =? x)%nat then [t] else [] end.
Definition tails (x : nat) (L : list (list nat)) : list (list nat) := flat_map (after x) L.
Definition is_nil (l : list nat) : bool := match l with [] => true | _ => false end.

Lemma in_tails x L t : In t (tails x L) <-> In (x :: t) L.
Proof.
  unfold tails; rewrite in_flat_map; split.
  - intros (l & Hl & Ht); destruct l as [|y l]; [destruct Ht|]; cbn in Ht; destruct (Nat.eqb_spec y x) as [->|];
      [destruct Ht as [->|[]]; exact Hl | destruct Ht].
  - intros H; exists (x :: t); split; [exact H|]; cbn; rewrite Nat.eqb_refl; left; reflexivity.
Qed.
Lemma tails_NoDup x L : NoDup L -> NoDup (tails x L).
Proof.
  induction 1 as [|l L Hl HN IH]; [constructor|]; cbn [tails flat_map]; fold (tails x L); destruct l as [|y t];
    [exact IH|]; cbn [after].
  destruct (Nat.eqb_spec y x) as [->|]; [|exact IH]; cbn [app]; constructor; [rewrite in_tails; exact Hl | exact IH].
Qed.
Lemma nil_once L : NoDup L -> INR (length (filter is_nil L)) <= 1.
Proof.
  intros HN; apply (le_INR _ 1); pose proof (NoDup_filter is_nil HN) as HF.
  assert (All : forall l, In l (filter is_nil L) -> l = []) by (intros [|y t] H; [reflexivity | apply filter_In in H;
    destruct H; discriminate]).
  destruct (filter is_nil L) as [|a [|b R]]; cbn; try lia; exfalso; rewrite (All a), (All b) in HF by (cbn; auto).
  inversion_clear HF as [|? ? X _]; apply X; left; reflexivity.
Qed.
Lemma sum_at (X : list nat) y c : NoDup X -> In y X -> sum_of X (fun x => if (y =? x)%nat then c else 0) = c.
Proof.
  induction 1 as [|x X Hx HN IH]; intros []; cbn [sum_of]; fold (sum_of X (fun x => if (y =? x)%nat then c else 0)).
  - subst x; rewrite Nat.eqb_refl; rewrite (sum_ext X _ (fun _ => 0)); [rewrite sum_const; ring|].
    intros x Hx'; destruct (Nat.eqb_spec y x) as [->|]; [contradiction | reflexivity].
  - destruct (Nat.eqb_spec y x) as [->|]; [contradiction | rewrite IH by assumption; ring].
Qed.
Lemma grouping L : forall X, NoDup X -> (forall y t, In (y :: t) L -> In y X) ->
  sum_of L weight = INR (length (filter is_nil L)) + sum_of X (fun x => z ^ p x * sum_of (tails x L) weight).
Proof.
  induction L as [|l L IH]; intros X HN HX.
  - cbn; rewrite (sum_ext X _ (fun _ => 0)) by (intros; ring); rewrite sum_const; ring.
  - specialize (IH X HN (fun y t H => HX y t (or_intror H))); cbn [sum_of]; rewrite IH; destruct l as [|y t].
    + cbn [filter is_nil length tails flat_map after app]; rewrite S_INR; unfold weight at 1;
        cbn [total fold_right pow]; unfold tails; ring.
    + cbn [filter is_nil]; rewrite (sum_ext X (fun x => z ^ p x * sum_of (tails x ((y :: t) :: L)) weight) (fun x =>
        z ^ p x * sum_of (tails x L) weight + (if (y =? x)%nat then weight (y :: t) else 0))).
      { rewrite sum_plus, sum_at; [ring | assumption | apply (HX y t); left; reflexivity]. }
      intros x _; cbn [tails flat_map after]; fold (tails x L); destruct (Nat.eqb_spec y x) as [->|];
        [|cbn [app]; ring].
      cbn [app sum_of]; rewrite weight_cons; ring.
Qed.

(** ** From above *)
Section Above.
Variables (v : nat -> R) (lo : R).
Hypotheses (Hlo : 0 < lo) (Hv : forall i, vertex G i -> lo <= v i).
(** v is at least M v. *)
Hypothesis Hsuper : forall i, vertex G i -> forall X, NoDup X -> (forall j, In j X -> vertex G j /\ joined G i j) ->
  sum_of X (fun j => z ^ p j * v j) <= v i.

Lemma weighed m : forall (next : nat -> Prop) val, lo <= val -> (forall X, NoDup X -> (forall j, In j X -> vertex G j /\
  next j) -> sum_of X (fun j => z ^ p j * v j) <= val) -> forall L, NoDup L -> Forall (fun l => (length l <= m)%nat /\
  match l with [] => True | j :: l' => vertex G j /\ next j /\ follows G j l' end) L -> sum_of L weight <= INR (S m)
  * val / lo.
Proof.
  induction m as [|m IH]; intros next val Hval Hnext L HN HL; rewrite Forall_forall in HL.
  all: set (X := nodup Nat.eq_dec (flat_map (fun l => match l with [] => [] | y :: _ => [y] end) L)).
  all: assert (HX : forall y, In y X <-> exists t, In (y :: t) L) by (intros y; unfold X; rewrite nodup_In, in_flat_map;
    split; [intros ([|x l] & Hl & Hy); [destruct Hy | destruct Hy as [->|[]]; eauto] | intros (t & Ht); exists (y :: t);
    cbn; auto]).
  all: rewrite (grouping L X (NoDup_nodup _ _) (fun y t H => proj2 (HX y) (ex_intro _ t H))); pose proof (nil_once L HN)
    as N1.
  all: assert (One : 1 <= val / lo) by (apply (Rmult_le_reg_r lo); [assumption|]; unfold Rdiv; rewrite Rmult_assoc,
    Rinv_l; lra).
  - rewrite (sum_ext X _ (fun _ => 0)); [rewrite sum_const; cbn [INR]; lra|]; intros x Hx; apply HX in Hx;
      destruct Hx as (t & Ht).
    destruct (HL _ Ht) as [Len _]; cbn in Len; lia.
  - assert (S1 : sum_of X (fun x => z ^ p x * sum_of (tails x L) weight) <= sum_of X (fun x =>
      INR (S m) / lo * (z ^ p x * v x))).
    { apply sum_le; intros x Hx; apply HX in Hx; destruct Hx as (t & Ht); destruct (HL _ Ht) as (_ & Vx & _).
      replace (INR (S m) / lo * (z ^ p x * v x)) with (z ^ p x * (INR (S m) * v x / lo)) by (field; lra).
      apply Rmult_le_compat_l; [left; apply pow_z|]; apply (IH (joined G x)); [apply Hv, Vx | apply Hsuper, Vx |
        apply tails_NoDup, HN|].
      apply Forall_forall; intros l Hl; apply in_tails in Hl; destruct (HL _ Hl) as (Len & _ & _ & F); cbn in Len;
        split; [lia|].
      destruct l as [|y l]; [trivial | cbn [follows] in F; tauto]. }
    rewrite sum_scale in S1; assert (S2 : sum_of X (fun x => z ^ p x * v x) <= val).
    { apply Hnext; [apply NoDup_nodup|]; intros x Hx; apply HX in Hx; destruct Hx as (t & Ht);
        destruct (HL _ Ht) as (_ & Vx & Nx & _); split; assumption. }
    assert (0 <= INR (S m) / lo) by (apply Rmult_le_pos; [apply pos_INR | left; apply Rinv_0_lt_compat; assumption]).
    apply Rle_trans with (val / lo + INR (S m) / lo * val); [|rewrite (S_INR (S m)); right; field; lra].
    pose proof (Rmult_le_compat_l _ _ _ H S2); lra.
Qed.
Lemma total_length i l : vertex G i -> follows G i l -> (length l <= total G l)%nat.
Proof. revert i; induction l as [|j l IH]; intros i Hi F; cbn in *; [lia|]; destruct F as (Vj & _ & F);
    specialize (IH j Vj F); specialize (Hp j Vj); unfold total in IH; lia. Qed.
Theorem from_above T : (forall X, NoDup X -> (forall j, In j X -> vertex G j) -> sum_of X (fun j => z ^ p j * v j) <= T)
  -> at_most G (- ln z).
Proof.
  intros HT h' Hh; set (eta := h' - - ln z); assert (He : 0 < eta) by (unfold eta; lra); set (val := Rmax lo T).
  assert (Hval : lo <= val) by apply Rmax_l; exists ((/ eta + 1) * (val / lo)); intros P L HN HL; rewrite Forall_forall
    in HL.
  assert (S1 : sum_of L weight <= INR (S P) * val / lo).
  { apply (weighed P (fun _ => True)); [assumption | | assumption |].
    - intros X HX HV; apply Rle_trans with T; [apply HT; [assumption | intros j Hj; apply (HV j Hj)] | apply Rmax_r].
    - apply Forall_forall; intros l Hl; destruct (HL l Hl) as [Tl Wl]; destruct l as [|j l];
        [split; [cbn; lia | trivial]|].
      destruct Wl as [Vj F]; split; [|tauto]; pose proof (total_length j l Vj F); pose proof (Hp j Vj); cbn in *;
        unfold total in H; lia. }
  assert (S2 : INR (length L) * z ^ P <= sum_of L weight).
  { rewrite <- sum_const; apply sum_le; intros l Hl; unfold weight; apply pow_z_le, (HL l Hl). }
  assert (Grow : INR (S P) <= (/ eta + 1) * exp (eta * INR P)).
  { pose proof (pos_INR P) as P0; pose proof (Rinv_0_lt_compat _ He) as I0;
      assert (X : 1 + eta * INR P <= exp (eta * INR P)).
    { destruct (Req_dec (eta * INR P) 0) as [->|Hne]; [rewrite exp_0; lra | left; apply exp_ineq1; exact Hne]. }
    apply Rle_trans with ((/ eta + 1) * (1 + eta * INR P)); [|apply Rmult_le_compat_l; lra].
    rewrite S_INR; replace ((/ eta + 1) * (1 + eta * INR P)) with (/ eta + INR P + 1 + eta * INR P) by (field; lra);
      nra. }
  pose proof (exp_z P) as EZ; replace (h' * INR P) with (eta * INR P + - ln z * INR P) by (unfold eta; ring);
    rewrite exp_plus.
  set (a := exp (eta * INR P)) in *; set (b := exp (- ln z * INR P)) in *; assert (Pb : 0 < b) by apply exp_pos.
  assert (V0 : 0 <= val / lo) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; assumption]).
  assert (S3 : INR (length L) * z ^ P <= (/ eta + 1) * a * (val / lo)).
  { apply Rle_trans with (1 := S2), Rle_trans with (1 := S1); unfold Rdiv; rewrite Rmult_assoc; apply Rmult_le_compat_r;
      assumption. }
  apply (Rmult_le_compat_r b) in S3; [|lra]; replace (INR (length L) * z ^ P * b) with (INR (length L) * (b * z ^ P))
    in S3 by ring.
  rewrite EZ in S3; lra.
Qed.
End Above.

(** ** From below *)
Section Below.
Variables (A : nat -> Prop) (succ : nat -> list nat) (w : nat -> R) (top : R) (pm : nat).
Hypotheses (Htop : 0 < top) (Hw : forall i, A i -> 0 <= w i <= top).
Hypothesis Hsucc : forall i, A i -> NoDup (succ i) /\ forall j, In j (succ i) -> A j /\ vertex G j /\ joined G i j /\
  (p j <= pm)%nat.
Hypothesis Hsub : forall i, A i -> w i <= sum_of (succ i) (fun j => z ^ p j * w j).

Lemma many P : forall i, A i -> exists L, NoDup L /\ Forall (fun l => follows G i l /\ (total G l <= P + pm)%nat) L /\
  w i <= INR (length L) * top * z ^ P.
Proof.
  induction P as [P IH] using lt_wf_ind; intros i Hi; destruct (Hsucc i Hi) as [HN HS].
  enough (Part : forall X, NoDup X -> incl X (succ i) -> exists L, NoDup L /\ Forall (fun l => exists j t, l = j :: t /\
    In j X /\ follows G i l /\ (total G l <= P + pm)%nat) L /\ sum_of X (fun j => z ^ p j * w j) <= INR (length L) * top
    * z ^ P).
  { destruct (Part (succ i) HN (incl_refl _)) as (L & N & F & S); exists L; split; [exact N|]; split.
    - revert F; apply Forall_impl; intros l (j & t & _ & _ & X); exact X.
    - apply Rle_trans with (1 := Hsub i Hi); exact S. }
  induction 1 as [|j X Hj HX IHX]; intros HI; [exists []; split; [constructor | split; [constructor | cbn; lra]]|].
  destruct IHX as (L' & N' & F' & S'); [intros x Hx; apply HI; right; exact Hx|].
  destruct (HS j (HI j (or_introl eq_refl))) as (Aj & Vj & Jj & Pj); pose proof (Hp j Vj) as P1.
  assert (Here : exists L, NoDup L /\ Forall (fun l => exists t, l = j :: t /\ follows G i l /\
    (total G l <= P + pm)%nat) L /\ z ^ p j * w j <= INR (length L) * top * z ^ P).
  { destruct (le_lt_dec (p j) P) as [LP|LP].
    - destruct (IH (P - p j)%nat ltac:(lia) j Aj) as (L & N & F & S); exists (map (cons j) L); rewrite map_length;
        split; [|split].
      + clear - N; induction N as [|l L Hl _ IHN]; cbn; constructor; [|exact IHN]; intros H; apply in_map_iff in H;
          destruct H as (t & E & Ht); injection E as ->; contradiction.
      + rewrite Forall_forall in F; apply Forall_forall; intros l Hl; apply in_map_iff in Hl;
          destruct Hl as (t & <- & Ht); destruct (F t Ht) as [F1 F2].
        exists t; split; [reflexivity|]; cbn [follows total fold_right]; fold (total G t); split; [tauto | lia].
      + replace P with (p j + (P - p j))%nat at 1 by lia; rewrite pow_add; pose proof (pow_z (p j)); nra.
    - exists [[j]]; split; [constructor; [intros [] | constructor]|]; split.
      + constructor; [|constructor]; exists []; cbn; repeat split; auto; lia.
      + cbn [length INR]; rewrite Rmult_1_l; pose proof (pow_z_le P (p j) ltac:(lia)); pose proof (Hw j Aj);
          pose proof (pow_z (p j)); nra. }
  destruct Here as (L & N & F & S); exists (L ++ L'); rewrite app_length, plus_INR; split; [|split].
  - rewrite Forall_forall in F, F'; clear - N N' F F' Hj; revert F; induction N as [|l L Hl _ IHN]; intros F;
      [exact N'|]; cbn; constructor.
    + rewrite in_app_iff; intros [H|H]; [contradiction|]; destruct (F l (or_introl eq_refl)) as (t & E & _), (F' l H)
        as (j' & t' & E' & I & _).
      rewrite E in E'; injection E' as <- _; contradiction.
    + apply IHN; intros x Hx; apply F; right; exact Hx.
  - apply Forall_app; split; [revert F | revert F']; apply Forall_impl.
    + intros l (t & E & X1); exists j, t; cbn; tauto.
    + intros l (j' & t & E & I & X1); exists j', t; cbn; tauto.
  - cbn [sum_of]; lra.
Qed.
Theorem from_below i : A i -> vertex G i -> 0 < w i -> at_least G (- ln z).
Proof.
  intros Ai Vi Wi h' Hh; set (c0 := (pm + p i)%nat); exists (w i / top * z ^ c0); assert (Q : 0 < w i / top)
    by (apply Rdiv_lt_0_compat; assumption).
  split; [apply Rmult_lt_0_compat; [exact Q | apply pow_z]|]; intros P; assert (Q1 : w i / top <= 1).
  { apply (Rmult_le_reg_r top); [assumption|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; pose proof (Hw i Ai);
      lra. }
  assert (Ex : exp (h' * INR P) * z ^ P <= 1).
  { rewrite <- (exp_z P); apply Rmult_le_compat_r; [left; apply pow_z|]; pose proof (pos_INR P);
      destruct (Req_dec (INR P) 0) as [->|Hne]; [rewrite !Rmult_0_r; lra|].
    left; apply exp_increasing; apply Rmult_lt_compat_r; lra. }
  pose proof (exp_pos (h' * INR P)) as E0; set (e := exp (h' * INR P)) in *; destruct (le_lt_dec c0 P) as [LP|LP].
  - destruct (many (P - c0) i Ai) as (L & N & F & S); exists (map (cons i) L); rewrite map_length; split; [|split].
    + clear - N; induction N as [|l L Hl _ IHN]; cbn; constructor; [|exact IHN]; intros H; apply in_map_iff in H;
        destruct H as (t & E & Ht); injection E as ->; contradiction.
    + rewrite Forall_forall in F; apply Forall_forall; intros l Hl; apply in_map_iff in Hl;
        destruct Hl as (t & <- & Ht); destruct (F t Ht) as [F1 F2].
      split; [cbn [total fold_right]; fold (total G t); unfold c0 in *; lia | split; assumption].
    + apply (Rmult_le_reg_r (top * z ^ (P - c0))); [apply Rmult_lt_0_compat; [assumption | apply pow_z]|].
      replace (w i / top * z ^ c0 * e * (top * z ^ (P - c0))) with (w i * (e * (z ^ c0 * z ^ (P - c0)))) by (field;
        lra).
      rewrite <- pow_add; replace (c0 + (P - c0))%nat with P by lia; nra.
  - exists [[]]; split; [constructor; [intros [] | constructor]|]; split;
      [constructor; [split; [cbn; lia | trivial] | constructor]|]; cbn [length INR].
    pose proof (pow_z_le P c0 ltac:(lia)); pose proof (pow_z c0); assert (z ^ c0 * e <= 1) by nra; nra.
Qed.
End Below.
End Graph.
