(** (i), two bounds on a return, and (iii) for finite displacements: ordered motions separate. *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Derivatives StatementOscillator Flow.
From Grazing Require Import StatementTrapped TrappedCalculus TrappedFlow TrappedReturn.
Open Scope R_scope.

Section Main.
Variables (M : machine) (lo hi : R).
Hypothesis H : hump M lo hi.
Hypothesis Hb : 0 < alb M /\ least_slip M <= zm M /\ least_speed M <= Vm M.
Hypothesis Ho : 0 < alo M.
Notation a := (a M). Notation b := (b M). Notation tau := (tau M). Notation p := (p M). Notation W := (W M).
Notation mu := (mu M). Notation Q := (Q M). Notation Q1 := (Q1 M). Notation Q2 := (Q2 M).
Notation D := (StatementTrapped.b M - StatementTrapped.a M).
Let Hab := overdamped _ _ _ H.
Let Htau := restitution _ _ _ H.

Lemma one_pass j k t : in_pass M lo hi j t -> in_pass M lo hi k t -> j = k.
Proof.
  intros J K; destruct (Z.lt_total j k) as [L|[E|L]]; trivial; exfalso.
  - pose proof (pass_order M lo hi H j k t t J K L); lra.
  - pose proof (pass_order M lo hi H k j t t K J L); lra.
Qed.
Lemma shift_pass k n t : in_pass M (lo + p * IZR k) (hi + p * IZR k) n t <-> in_pass M lo hi (k + n) t.
Proof. unfold in_pass; rewrite plus_IZR; split; lra. Qed.

(** P1 to P5 from any pass, for any bounds z, w. *)
Lemma return_to k t V t' V' x v z w : in_pass M lo hi k t -> within M z w t V ->
  0 < al0 M - b ^ 2 * (z + (1 + tau) * w) / D -> leg M t V t' V' x v ->
  0 <= Q t' /\ V' <= 0 /\ 0 <= zeta M t' V' <= zm M /\ (zeta M t V <= zm M -> - Vm M <= V') /\
  exists n, (1 <= n)%Z /\ in_pass M lo hi (k + n) t'.
Proof.
  intros Hk Hw Al [F X0 V0 N1 N2 N3 N4]; pose proof (hump_shift M lo hi H k) as Hs. destruct (next_pass M _ _ Hs t V x
    v z w Hk Hw F X0 V0 Al t' N1 N3) as (n & Hn & Pn). repeat split.
  - rewrite <- N3; apply (x_pos M _ _ Hs t V x v z w Hw F X0 V0); lra.
  - apply (speed_sign M _ _ Hs t x v F t' V' N1 N2 N3 N4).
  - apply (next_zeta M _ _ Hs t V x v z w Hk Hw F X0 V0 Al t' V' N1 N3 N4).
  - pose proof (next_zeta M _ _ Hs t V x v z w Hk Hw F X0 V0 Al t' V' N1 N3 N4); lra.
  - intros Hz; apply (next_speed M _ _ Hs t V x v z w Hk Hw F X0 V0 Al t' V' N1 N2 N3 N4 Hz Hb n Hn Pn).
  - exists n; split; trivial; apply shift_pass, Pn.
Qed.

Lemma return_trapped k t V t' V' x v : in_pass M lo hi k t -> trapped M t V -> leg M t V t' V' x v ->
  trapped M t' V' /\ exists n, (1 <= n)%Z /\ in_pass M lo hi (k + n) t'.
Proof.
  intros Hk Hw L; destruct (return_to k t V t' V' x v (zm M) (Vm M) Hk Hw Ho L) as (h1 & h2 & h3 & h4 & h5).
  split; trivial; split; trivial; split; trivial; split; trivial; apply h4, Hw.
Qed.

Lemma free_from t X Y : exists x v, free (a + b) (a * b) x v /\ x t = X /\ v t = Y.
Proof.
  destruct (flow_exists (a + b) (a * b)) as (S & U & HF). eexists; eexists; split; [apply (moved_free _ _ S U HF t X
    Y)|apply (moved_start _ _ S U HF t X Y)].
Qed.

Lemma next_leg z w t V : within M z w t V -> 0 < al0 M - b ^ 2 * (z + (1 + tau) * w) / D ->
  exists t' V' x v, leg M t V t' V' x v.
Proof.
  intros Hw Al; destruct (pass_of M lo hi H t (proj1 Hw)) as (k & Hk). destruct (free_from t (Q t) (Q1 t - tau * V))
    as (x & v & F & X0 & V0). destruct (next_exists M _ _ (hump_shift M lo hi H k) t V x v _ _ Hk Hw F X0 V0 Al) as
    (t' &
    V' & L). exists t', V', x, v; trivial.
Qed.

(** *** Bounds *)
Lemma zm_pos : 0 <= zm M.
Proof.
  destruct (positives M lo hi H), (sizes M lo hi H); apply Rle_trans with (least_slip M); [|lra]; apply Rmult_le_pos;
    [apply Rmult_le_pos; lra|].
  assert (1 < exp (D * (p - W))); [rewrite <- exp_0; apply exp_increasing; apply Rmult_lt_0_compat; lra|]. left;
    apply Rinv_0_lt_compat; lra.
Qed.
Lemma Vm_pos : 0 < Vm M.
Proof.
  destruct (positives M lo hi H), (sizes M lo hi H); pose proof zm_pos; apply Rlt_le_trans with (least_speed M);
    [|lra]; apply sqrt_lt_R0. assert (0 < deep M).
  { apply Rlt_le_trans with ((1 - exp (- a * p)) * mu); [|apply (deep_pos M Hb)]. apply Rmult_lt_0_compat;
      [|lra]; assert (exp (- a * p) < 1); [|lra]. rewrite <- exp_0; apply exp_increasing;
      assert (0 < a * p) by (apply Rmult_lt_0_compat; lra); lra. }
  assert (0 <= zm M / D) by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]).
  assert (0 <= a ^ 2 * (mu + zm M / D)) by (apply Rmult_le_pos; [apply pow2_ge_0|lra]).
  pose proof (bent _ _ _ H lo ltac:(lra)); assert (0 < alM M) by (unfold alM; lra). apply Rmult_lt_0_compat; lra.
Qed.
Lemma al_in : alo M <= al0 M - b ^ 2 * zm M / D.
Proof.
  unfold alo; pose proof Vm_pos; assert (b ^ 2 * zm M / D <= b ^ 2 * (zm M + (1 + tau) * Vm M) / D); [|lra].
  apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|apply Rmult_le_compat_l; [apply pow2_ge_0|]].
  assert (0 <= (1 + tau) * Vm M) by (apply Rmult_le_pos; lra); lra.
Qed.
Lemma sigma_pos : 0 < sigma M.
Proof.
  pose proof al_in; unfold sigma; assert (0 <= tau * (al0 M - b ^ 2 * zm M / D)) by (apply Rmult_le_pos; lra); lra.
Qed.

(** Below its highest value the stop lies over a parabola. *)
Lemma parabola t : 0 <= Q t -> exists s, Q s = mu /\ - Q t + - Q1 t * (s - t) + al0 M / 2 * (s - t) ^ 2 <= - Q s.
Proof.
  intros h1; destruct (pass_of M lo hi H t h1) as (k & Hk); pose proof (hump_shift M lo hi H k) as Hs.
  destruct (reached _ _ _ H) as (s0 & E0); destruct (positives M lo hi H) as [hmu hal].
  destruct (pass_of M _ _ Hs s0 ltac:(lra)) as (j & Hj). set (s := s0 + p * IZR (- j));
    assert (Es : Q s = mu) by (unfold s; rewrite (Q_whole M lo hi H); trivial). assert (Hs' : lo + p * IZR k <= s <=
    hi + p * IZR k) by (unfold s, in_pass in *; rewrite opp_IZR; lra). assert (Dm1 : forall t, derivable_pt_lim (fun t
    => - Q t) t (- Q1 t)) by (intros; apply derivable_pt_lim_opp, (slope _ _ _ H)).
  assert (Dm2 : forall t, derivable_pt_lim (fun t => - Q1 t) t (- Q2 t)) by (intros; apply derivable_pt_lim_opp, (bend
    _ _ _ H)). exists s; split; [exact Es|].
  unfold in_pass in Hk; destruct (Rle_or_lt t s) as [L|L].
  - apply (above_right _ _ _ Dm1 Dm2); trivial; intros y Hy; apply (bent _ _ _ Hs); lra.
  - apply (above_left _ _ _ Dm1 Dm2); [lra|]; intros y Hy; apply (bent _ _ _ Hs); lra.
Qed.
(** Ql: how high a contact is. *)
Lemma height t V : trapped M t V -> Ql M <= Q t.
Proof.
  intros (h1 & h2 & h3); destruct (parabola t h1) as (s & Es & G); destruct (positives M lo hi H) as [hmu hal].
  rewrite Es in G; unfold Ql; pose proof (Rmax_l (Vm M + zm M) (a * mu)); pose proof (Rmax_r (Vm M + zm M) (a
    * mu)).
  set (X := Rmax (Vm M + zm M) (a * mu)) in *. assert (B : Q1 t ^ 2 <= X ^ 2).
  { pose proof (highest _ _ _ H t); unfold zeta in h3; assert (a * Q t <= a * mu) by (apply Rmult_le_compat_l;
      lra). assert (0 <= a * Q t) by (apply Rmult_le_pos; lra). assert (- X <= Q1 t <= X) by lra; nra. }
  assert (mu - Q t <= X ^ 2 / (2 * al0 M)); [|lra]. apply Rmult_le_reg_r with (2 * al0 M); [lra|]; replace (X ^ 2 / (2
    * al0 M) * (2 * al0 M)) with (X ^ 2) by (field; lra). pose proof (pow2_ge_0 (al0 M * (s - t) - Q1 t)); nra.
Qed.
Lemma apart_pass k n s t : in_pass M lo hi k s -> in_pass M lo hi (k + n) t -> p * IZR n - W <= t - s <= p *
  IZR n + W.
Proof. unfold in_pass; rewrite plus_IZR; destruct (sizes M lo hi H); lra. Qed.
(** The bound in B_n. *)
Lemma far' k n t V t' V' x v : (1 <= n)%Z -> in_pass M lo hi k t -> in_pass M lo hi (k + n) t' ->
  trapped M t V ->
  trapped M t' V' -> free (a + b) (a * b) x v -> x t = Q t -> v t = Q1 t - tau * V -> x t' = Q t' ->
  Ql M - phi11 M (p * IZR n - W) * mu <= phi12 M (t' - t) * ((1 + tau) * Vm M + zm M).
Proof.
  intros Hn Hk Hk' Tr Tr' F X0 V0 N3; pose proof (height _ _ Tr') as He. pose proof (apart_pass _ _ _ _ Hk Hk') as Ap;
    rewrite <- N3, (x_flow M Hab x v F t t'), X0, V0 in He. destruct (sizes M lo hi H), (positives M lo hi H);
    assert (1 <= IZR n) by (apply (IZR_le 1); lia). assert (p * 1 <= p * IZR n) by (apply Rmult_le_compat_l;
    lra). destruct (phi11_down M Hab (p * IZR n - W) (t' - t) ltac:(lra)) as [P1 P2]; pose proof (phi12_pos M Hab (t'
    - t) ltac:(lra)).
  destruct Tr as (h1 & h2 & h3); pose proof (highest _ _ _ H t); unfold zeta in h3. assert (phi11 M (t' - t) * Q t <=
    phi11 M (p * IZR n - W) * mu) by (apply Rmult_le_compat; lra). assert (0 <= a * Q t) by (apply Rmult_le_pos;
    lra). assert (tau * - V <= tau * Vm M) by (apply Rmult_le_compat_l; lra). assert (phi12 M (t' - t) * (Q1 t - tau *
    V) <= phi12 M (t' - t) * ((1 + tau) * Vm M + zm M)) by (apply Rmult_le_compat_l; lra); lra.
Qed.
Lemma far k n t V t' V' x v : (1 <= n)%Z -> in_pass M lo hi k t -> in_pass M lo hi (k + n) t' ->
  trapped M t V ->
  trapped M t' V' -> leg M t V t' V' x v ->
  Ql M - phi11 M (p * IZR n - W) * mu <= phi12 M (t' - t) * ((1 + tau) * Vm M + zm M).
Proof. intros Hn Hk Hk' Tr Tr' [F X0 V0 _ _ N3 _]; eapply far'; eauto. Qed.

(** *** Two motions at an impact; (x, v) hits first *)
Lemma acc_forward x v t s B : free (a + b) (a * b) x v -> 0 <= x t -> 0 <= zet M x v t <= B -> t <= s ->
  - (b ^ 2 * B / D) <= - (a + b) * v s - a * b * x s.
Proof.
  intros F Hx Hz L; rewrite (acc_of M Hab x v), (zet_flow M x v F t s), (eta_flow M x v F t s), (eta_zet M x v t).
  assert (Dp : 0 <= / D) by (left; apply Rinv_0_lt_compat; lra); assert (0 <= D * x t) by (apply Rmult_le_pos;
    lra). assert (0 <= a ^ 2 * ((zet M x v t + D * x t) * exp (- a * (s - t))) / D).
  { apply Rmult_le_pos; trivial; apply Rmult_le_pos; [apply pow2_ge_0|apply Rmult_le_pos; [lra|left; apply exp_pos]].
      }
  assert (b ^ 2 * (zet M x v t * exp (- b * (s - t))) / D <= b ^ 2 * B / D); [|lra]. apply Rmult_le_compat_r;
    trivial; apply Rmult_le_compat_l; [apply pow2_ge_0|]. pose proof (exp_down b 0 (s - t) ltac:(lra) ltac:(lra)) as
    X; rewrite Rmult_0_r, exp_0 in X. pose proof (exp_pos (- b * (s - t))); nra.
Qed.

Definition strength (z w : R) : R := tau * (al0 M - b ^ 2 * z / D) + (al0 M - b ^ 2 * (z + (1 + tau) * w) / D).
Section Impact.
Variables (z w0 : R) (k : Z) (t1 t2 U1 U2 : R) (x v y w X X' Y Y' : R -> R).
Hypothesis P1 : in_pass M lo hi k t1.
Hypothesis P2 : in_pass M lo hi k t2.
Hypothesis L : t1 <= t2.
Hypothesis Tr : within M z w0 t1 U1.
Hypothesis Op : 0 < al0 M - b ^ 2 * (z + (1 + tau) * w0) / D.
Hypothesis Fx : free (a + b) (a * b) x v.
Hypothesis FX : free (a + b) (a * b) X X'.
Hypothesis x1 : x t1 = Q t1.
Hypothesis v1 : U1 = v t1 - Q1 t1.
Hypothesis y2 : y t2 = Q t2.
Hypothesis w2 : U2 = w t2 - Q1 t2.
Hypothesis X1 : X t1 = Q t1.
Hypothesis X1' : X' t1 = Q1 t1 - tau * U1.
Hypothesis Y2 : Y t2 = Q t2.
Hypothesis Y2' : Y' t2 = Q1 t2 - tau * U2.

Lemma impact : tau * (y t2 - x t2) <= X t2 - Y t2 /\
  strength z w0 * (t2 - t1) + tau * (zet M y w t2 - zet M x v t2) <= zet M X X' t2 - zet M Y Y' t2 /\ y t2 - x t2 <=
  w0 * (t2 - t1).
Proof.
  pose proof (hump_shift M lo hi H k) as Hs; destruct Tr as (h1 & h2 & h3).
  assert (Ai : al0 M - b ^ 2 * (z + (1 + tau) * w0) / D <= al0 M - b ^ 2 * z / D).
  { assert (0 <= (1 + tau) * w0) by (apply Rmult_le_pos; lra); assert (b ^ 2 * z / D <= b ^ 2 * (z + (1 + tau) * w0) /
      D); [|lra]. apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|apply Rmult_le_compat_l; [apply
      pow2_ge_0|lra]]. } assert (Sp : 0 < strength z w0) by (assert (0 <= tau * (al0 M - b ^ 2 * z / D)) by (apply
  Rmult_le_pos; lra); unfold strength; lra). assert (In : forall s, t1 <= s <= t2 -> al0 M - b ^ 2 * z / D <= - (a +
    b) * v s - a * b * x s - Q2 s).
  { intros s Hs'; pose proof (bent _ _ _ Hs s ltac:(unfold in_pass in *; lra)).
    assert (Ez : zet M x v t1 = zeta M t1 U1) by (unfold zet, zeta; rewrite x1, v1; ring).
    pose proof (acc_forward x v t1 s z Fx ltac:(lra) ltac:(lra) ltac:(lra)); lra. } assert (Out : forall s, t1 <= s <=
  t2 -> al0 M - b ^ 2 * (z + (1 + tau) * w0) / D <= - (a + b) * X' s - a * b * X s
    - Q2 s).
  { intros s Hs'; apply (opening M _ _ Hs t1 U1 X X' z w0 P1 Tr FX X1 X1'); unfold in_pass in *; lra. }
  assert (Dx : forall s, derivable_pt_lim (fun s => x s - Q s) s (v s - Q1 s)) by (intros s; apply D_minus;
    [apply Fx|apply (slope _ _ _ H)]). assert (Dv : forall s, derivable_pt_lim (fun s => v s - Q1 s) s (- (a + b) * v
    s - a * b * x s - Q2 s)) by (intros s; apply D_minus; [apply Fx|apply (bend _ _ _ H)]).
  assert (DX : forall s, derivable_pt_lim (fun s => (X s - Q s) + tau * (x s - Q s)) s ((X' s - Q1 s) + tau * (v s -
    Q1 s))).
  { intros s; apply D_plus; [apply D_minus; [apply FX|apply (slope _ _ _ H)]|apply D_scale, Dx]. }
  assert (DV : forall s, derivable_pt_lim (fun s => (X' s - Q1 s) + tau * (v s - Q1 s)) s ((- (a + b) * X' s - a * b *
    X s - Q2 s) + tau * (- (a + b) * v s - a * b * x s - Q2 s))).
  { intros s; apply D_plus; [apply D_minus; [apply FX|apply (bend _ _ _ H)]|apply D_scale, Dv]. }
  assert (K2 : forall s, t1 <= s <= t2 -> strength z w0 <= (- (a + b) * X' s - a * b * X s - Q2 s) + tau * (- (a + b)
    * v s
    - a * b * x s - Q2 s)).
  { intros s Hs'; specialize (In s Hs'); specialize (Out s Hs'); unfold strength. assert (tau * (al0 M - b ^ 2 * z /
      D) <= tau * (- (a + b) * v s - a * b * x s - Q2 s)) by (apply Rmult_le_compat_l; lra). lra. }
  pose proof (above_right _ _ _ DX DV (strength z w0) t1 t2 L K2) as A; cbv beta in A. pose proof (slope_right _ _ DV
    (strength z w0) t1 t2 L K2) as S; cbv beta in S. pose proof (above_right _ _ _ Dx Dv (al0 M - b ^ 2 * z / D) t1 t2
    L In) as G; cbv beta in G. assert (S2 : 0 <= (t2 - t1) ^ 2) by apply pow2_ge_0. assert (G2 : 0 <= (al0 M - b ^ 2 *
    z / D) / 2 * (t2 - t1) ^ 2) by (apply Rmult_le_pos; lra). assert (A2 : 0 <= strength z w0 / 2 * (t2 - t1) ^ 2) by
      (apply
    Rmult_le_pos; lra). rewrite X1, X1', x1, <- v1 in A; rewrite X1', <- v1 in S; rewrite x1, <- v1 in G.
  replace (Q t1 - Q t1 + tau * (Q t1 - Q t1) + (Q1 t1 - tau * U1 - Q1 t1 + tau * U1) * (t2 - t1)) with 0 in A by ring.
  replace (Q1 t1 - tau * U1 - Q1 t1 + tau * U1) with 0 in S by ring. split; [rewrite Y2, y2; lra|split].
  - unfold zet; rewrite Y2, Y2', y2, w2. assert (0 <= a * (X t2 - Q t2 + tau * (x t2 - Q t2))) by (apply Rmult_le_pos;
      lra); lra.
  - rewrite y2; assert (- U1 * (t2 - t1) <= w0 * (t2 - t1)) by (apply
      Rmult_le_compat_r; lra); lra.
Qed.
End Impact.

(** In the order of the cone, a free motion keeps above the other. *)
Lemma keep x v y w s t : free (a + b) (a * b) x v -> free (a + b) (a * b) y w -> s <= t ->
  y t - x t = exp (- a * (t - s)) * (y s - x s) + phi12 M (t - s) * (zet M y w s - zet M x v s) /\
  zet M y w t - zet M x v t = exp (- b * (t - s)) * (zet M y w s - zet M x v s).
Proof.
  intros F F' L; split.
  - rewrite (x_flow' M Hab x v F s t), (x_flow' M Hab y w F' s t); ring.
  - rewrite (zet_flow M x v F s t), (zet_flow M y w F' s t); ring.
Qed.
Lemma keep_order x v y w s t : free (a + b) (a * b) x v -> free (a + b) (a * b) y w -> s <= t ->
  0 <= y s - x s -> 0 <= zet M y w s - zet M x v s -> 0 <= y t - x t /\ 0 <= zet M y w t - zet M x v t.
Proof.
  intros F F' L h1 h2; destruct (keep x v y w s t F F' L) as [-> ->]; pose proof (phi12_pos M Hab (t - s) ltac:(lra)).
  pose proof (exp_pos (- a * (t - s))); pose proof (exp_pos (- b * (t - s))). split;
    [apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra|apply Rmult_le_pos; lra].
Qed.
End Main.
