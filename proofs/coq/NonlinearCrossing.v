(** * The relative speed at the crossing is sqrt (2 a) y up to a small Lipschitz remainder, in y and
      in the trajectory. p (x) is the gap x before (or after) its lowest point, above its lowest value: y = sqrt (p x).
      *)
From Coq Require Import Reals Lra.
From Grazing Require Import Derivatives.
Open Scope R_scope.

Definition bowl (a e rho : R) (p p1 p2 : R -> R) : Prop := p 0 = 0 /\ p1 0 = 0 /\ forall x, 0 <= x <= rho ->
  derivable_pt_lim p x (p1 x) /\ derivable_pt_lim p1 x (p2 x) /\ Rabs (p2 x - a) <= e.

(** f' between B - d and B + d. *)
Lemma between f f' B d x y : (forall s, x <= s <= y -> derivable_pt_lim f s (f' s) /\ Rabs (f' s - B) <= d) -> x <= y ->
  Rabs (f y - f x - B * (y - x)) <= d * (y - x).
Proof.
  intros H [L | ->]; [|replace (f y - f y - B * (y - y)) with 0 by ring; rewrite Rabs_R0; lra].
  destruct (MVT_cor2 f f' x y L) as (s & E & Hs); [intros s Hs; apply H, Hs|]; rewrite E.
  replace (f' s * (y - x) - B * (y - x)) with ((f' s - B) * (y - x)) by ring;
    rewrite Rabs_mult, (Rabs_pos_eq (y - x)) by lra. apply Rmult_le_compat_r; [lra | apply H; lra].
Qed.

(** |f'| <= d x on [0, rho] and f 0 = 0 give |f| <= d x^2 / 2. *)
Lemma square f f' d rho : 0 <= d -> f 0 = 0 -> (forall x, 0 <= x <= rho -> derivable_pt_lim f x (f' x) /\
  Rabs (f' x) <= d * x) -> forall x, 0 <= x <= rho -> Rabs (f x) <= d * (x * x) / 2.
Proof.
  intros Hd H0 H x [[Hx | <-] Hr]; [|rewrite H0, Rabs_R0; lra].
  assert (Sq : forall s, derivable_pt_lim (fun s => d / 2 * (s * s)) s (d / 2 * (1 * s + s * 1))) by (intros s; apply
    derivable_pt_lim_scal, (derivable_pt_lim_mult (fun s => s) (fun s => s)); apply derivable_pt_lim_id).
  destruct (MVT_cor2 (fun s => f s - d / 2 * (s * s)) (fun s => f' s - d / 2 * (1 * s + s * 1)) 0 x Hx) as (s & E & Hs).
  { intros s Hs; apply derivable_pt_lim_minus; [apply H; lra | apply Sq]. }
  destruct (MVT_cor2 (fun s => f s + d / 2 * (s * s)) (fun s => f' s + d / 2 * (1 * s + s * 1)) 0 x Hx)
    as (r & E' & Hr').
  { intros r Hr'; apply derivable_pt_lim_plus; [apply H; lra | apply Sq]. }
  cbv beta in *; rewrite H0 in *; pose proof (le_abs _ _ (proj2 (H s ltac:(lra))));
    pose proof (le_abs _ _ (proj2 (H r ltac:(lra)))). apply Rabs_le; split; nra.
Qed.

Section Bowls.
Variables (a e rho : R).
Hypothesis Ha : 0 < a.
Hypothesis He : 0 <= e /\ 4 * e <= a.
Let c := sqrt (2 * a).
Lemma c_pos : 0 < c /\ c * c = 2 * a.
Proof. unfold c; split; [apply sqrt_lt_R0; lra | apply sqrt_sqrt; lra]. Qed.

Section One.
Variables (p p1 p2 : R -> R).
Hypothesis HP : bowl a e rho p p1 p2.

Lemma slope x : 0 <= x <= rho -> (a - e) * x <= p1 x <= (a + e) * x.
Proof.
  intros Hx; destruct HP as (_ & H1 & H); pose proof (between p1 p2 a e 0 x) as B; rewrite H1 in B.
  specialize (B ltac:(intros s Hs; destruct (H s ltac:(lra)) as (_ & ? & ?); auto) ltac:(lra)); apply le_abs in B; lra.
Qed.
Lemma height x : 0 <= x <= rho -> (a - e) * (x * x) / 2 <= p x <= (a + e) * (x * x) / 2.
Proof.
  intros Hx; destruct HP as (H0 & H1 & H).
  pose proof (square (fun s => p s - a / 2 * (s * s)) (fun s => p1 s - a / 2 * (1 * s + s * 1)) e rho) as S.
  specialize (S (proj1 He) ltac:(cbv beta; rewrite H0; ring)).
  assert (B : Rabs (p x - a / 2 * (x * x)) <= e * (x * x) / 2).
  { apply S; [|exact Hx]; intros s Hs; split.
    - apply derivable_pt_lim_minus; [apply H, Hs|].
      apply derivable_pt_lim_scal, (derivable_pt_lim_mult (fun s => s) (fun s => s)); apply derivable_pt_lim_id.
    - pose proof (slope s Hs); apply Rabs_le; lra. }
  apply le_abs in B; lra.
Qed.
Lemma height_pos x : 0 < x <= rho -> 0 < p x.
Proof. intros Hx; pose proof (height x ltac:(lra)); assert (0 < (a - e) * (x * x)) by (apply Rmult_lt_0_compat; nra);
  lra. Qed.

(** The derivative of c sqrt p. *)
Lemma ratio x : 0 < x <= rho -> a - 3 * e <= c * (p1 x / (2 * sqrt (p x))) <= a + 3 * e.
Proof.
  intros Hx; pose proof (height_pos x Hx) as Hp; pose proof (slope x ltac:(lra)) as Sl;
    pose proof (height x ltac:(lra)) as Hh. destruct c_pos as [C0 C2]; set (s := sqrt (p x));
    assert (S0 : 0 < s) by (apply sqrt_lt_R0, Hp). assert (S2 : s * s = p x) by (apply sqrt_sqrt; lra);
    destruct He as [E0 E4]. assert (X2 : 0 < x * x) by nra; assert (U0 : 0 <= (a - e) * x) by (apply Rmult_le_pos; lra);
    assert (P0 : 0 <= p1 x) by lra. assert (Up : p1 x * p1 x <= (a + e) * (a + e) * (x * x)).
  { replace ((a + e) * (a + e) * (x * x)) with ((a + e) * x * ((a + e) * x)) by ring; apply Rmult_le_compat; lra. }
  assert (Lo : (a - e) * (a - e) * (x * x) <= p1 x * p1 x).
  { replace ((a - e) * (a - e) * (x * x)) with ((a - e) * x * ((a - e) * x)) by ring; apply Rmult_le_compat; lra. }
  assert (T : 0 <= e * (a * a) /\ 0 <= e * e * a /\ e * e * e <= e * e * a / 4 /\ e * e * a <= e * (a * a) / 4).
  { assert (0 <= e * e) by (apply Rmult_le_pos; lra); assert (0 <= a * a) by (apply Rmult_le_pos; lra).
    assert (e * e * (4 * e) <= e * e * a) by (apply Rmult_le_compat_l; lra).
    assert (e * a * (4 * e) <= e * a * a) by (apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra). split;
      [apply Rmult_le_pos; lra|]; split; [apply Rmult_le_pos; lra|]; split; lra. }
  assert (I1 : a * ((a + e) * (a + e)) <= (a - e) * ((a + 3 * e) * (a + 3 * e))) by lra.
  assert (I2 : (a + e) * ((a - 3 * e) * (a - 3 * e)) <= a * ((a - e) * (a - e))) by lra.
  assert (R1 : c * p1 x <= (a + 3 * e) * (2 * s)).
  { apply Rsqr_incr_0_var; [unfold Rsqr | nra]. replace (c * p1 x * (c * p1 x)) with (c * c * (p1 x * p1 x)) by ring.
    replace ((a + 3 * e) * (2 * s) * ((a + 3 * e) * (2 * s))) with (4 * ((a + 3 * e) * (a + 3 * e)) * (s * s)) by ring.
    rewrite C2, S2; apply Rle_trans with (2 * (a * ((a + e) * (a + e))) * (x * x)); [nra|].
    apply Rle_trans with (2 * ((a - e) * ((a + 3 * e) * (a + 3 * e))) * (x * x)); [nra|].
    assert (0 <= (a + 3 * e) * (a + 3 * e)) by nra; nra. }
  assert (R2 : (a - 3 * e) * (2 * s) <= c * p1 x).
  { apply Rsqr_incr_0_var; [unfold Rsqr | nra]. replace (c * p1 x * (c * p1 x)) with (c * c * (p1 x * p1 x)) by ring.
    replace ((a - 3 * e) * (2 * s) * ((a - 3 * e) * (2 * s))) with (4 * ((a - 3 * e) * (a - 3 * e)) * (s * s)) by ring.
    rewrite C2, S2; apply Rle_trans with (2 * ((a + e) * ((a - 3 * e) * (a - 3 * e))) * (x * x)).
    - assert (0 <= (a - 3 * e) * (a - 3 * e)) by nra; nra.
    - apply Rle_trans with (2 * (a * ((a - e) * (a - e))) * (x * x)); nra. }
  replace (c * (p1 x / (2 * s))) with (c * p1 x / (2 * s)) by (field; lra). split; apply Rmult_le_reg_r with (2 * s);
    try lra; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra.
Qed.
Lemma D_root x : 0 < x <= rho -> derivable_pt_lim (fun s => sqrt (p s)) x (p1 x / (2 * sqrt (p x))).
Proof.
  intros Hx; pose proof (height_pos x Hx) as Hp; destruct HP as (_ & _ & H); destruct (H x ltac:(lra)) as (D & _).
  pose proof (derivable_pt_lim_comp p sqrt x _ _ D (derivable_pt_lim_sqrt (p x) Hp)) as Q.
  replace (p1 x / (2 * sqrt (p x))) with (/ (2 * sqrt (p x)) * p1 x) by (unfold Rdiv; ring); exact Q.
Qed.

Lemma speed x y : 0 < x <= rho -> 0 < y <= rho -> Rabs (p1 x - c * sqrt (p x) - (p1 y - c * sqrt (p y))) <= 4 * e * Rabs
  (x - y) /\ (a - 3 * e) * Rabs (x - y) <= c * Rabs (sqrt (p x) - sqrt (p y)).
Proof.
  assert (W : forall x y, 0 < x -> x <= y -> y <= rho -> Rabs (p1 y - c * sqrt (p y) - (p1 x - c * sqrt (p x))) <=
    4 * e * (y - x) /\ (a - 3 * e) * (y - x) <= c * (sqrt (p y) - sqrt (p x))).
  { intros x' y' X XY Y; destruct HP as (_ & _ & H); split.
    - pose proof (between (fun s => p1 s - c * sqrt (p s)) (fun s => p2 s - c * (p1 s / (2 * sqrt (p s)))) 0 (4 * e) x'
        y') as B. rewrite Rmult_0_l, Rminus_0_r in B; apply B; [|exact XY]; intros s Hs;
        destruct (H s ltac:(lra)) as (_ & D & A); split.
      + apply derivable_pt_lim_minus; [exact D | apply derivable_pt_lim_scal, D_root; lra].
      + pose proof (ratio s ltac:(lra)); apply le_abs in A; apply Rabs_le; lra.
    - pose proof (between (fun s => c * sqrt (p s)) (fun s => c * (p1 s / (2 * sqrt (p s)))) a (3 * e) x' y') as B.
      specialize (B ltac:(intros s Hs; split; [apply derivable_pt_lim_scal, D_root;
        lra | pose proof (ratio s ltac:(lra)); apply Rabs_le; lra]) XY). cbv beta in B; apply le_abs in B; lra. }
  intros Hx Hy; destruct c_pos as [C0 _]; destruct (Rle_dec x y) as [L | L].
  - destruct (W x y ltac:(lra) L ltac:(lra)) as [A B]; rewrite (Rabs_minus_sym x y), (Rabs_pos_eq (y - x)) by lra.
    rewrite (Rabs_minus_sym (sqrt (p x))), (Rabs_minus_sym (p1 x - _)); split; [exact A|].
    apply Rle_trans with (1 := B), Rmult_le_compat_l; [lra | apply Rle_abs].
  - destruct (W y x ltac:(lra) ltac:(lra) ltac:(lra)) as [A B]; rewrite (Rabs_pos_eq (x - y)) by lra; split; [exact A|].
    apply Rle_trans with (1 := B), Rmult_le_compat_l; [lra | apply Rle_abs].
Qed.
End One.

(** Two trajectories whose accelerations differ by at most l, at the same distance from their lowest points. *)
Lemma together p p1 p2 q q1 q2 l : bowl a e rho p p1 p2 -> bowl a e rho q q1 q2 -> 0 <= l ->
  (forall x, 0 <= x <= rho -> Rabs (p2 x - q2 x) <= l) -> forall x, 0 < x <= rho ->
  Rabs (p1 x - q1 x) <= l * x /\ c * Rabs (sqrt (p x) - sqrt (q x)) <= 3 * (l * x).
Proof.
  intros HP HQ Hl H x Hx; destruct c_pos as [C0 C2]; destruct He as [E0 E4].
  assert (D1 : forall s, 0 <= s <= rho -> Rabs (p1 s - q1 s) <= l * s).
  { intros s Hs; destruct HP as (_ & P1 & P); destruct HQ as (_ & Q1 & Q).
    pose proof (between (fun s => p1 s - q1 s) (fun s => p2 s - q2 s) 0 l 0 s) as B; cbv beta in B; rewrite P1, Q1 in B.
    replace (p1 s - q1 s) with (p1 s - q1 s - (0 - 0) - 0 * (s - 0)) by ring. rewrite <- (Rminus_0_r s) at 4; apply B;
      [|lra]; intros r Hr; destruct (P r ltac:(lra)) as (_ & ? & _); destruct (Q r ltac:(lra)) as (_ & ? & _). split;
      [apply derivable_pt_lim_minus; assumption | rewrite Rminus_0_r; apply H; lra]. }
  assert (D0 : Rabs (p x - q x) <= l * (x * x) / 2).
  { apply (square (fun s => p s - q s) (fun s => p1 s - q1 s) l rho); [exact Hl | | | lra].
    - destruct HP as (-> & _); destruct HQ as (-> & _); ring.
    - intros s Hs; split; [|apply D1, Hs]; destruct HP as (_ & _ & P); destruct HQ as (_ & _ & Q).
      apply derivable_pt_lim_minus; [apply P, Hs | apply Q, Hs]. }
  split; [apply D1; lra|]. pose proof (height_pos p p1 p2 HP x Hx) as Pp; pose proof (height_pos q q1 q2 HQ x Hx) as Qp.
  pose proof (height p p1 p2 HP x ltac:(lra)) as Hp; set (s := sqrt (p x)) in *; set (r := sqrt (q x)).
  assert (S0 : 0 < s) by (apply sqrt_lt_R0, Pp); assert (R0 : 0 < r) by (apply sqrt_lt_R0, Qp).
  assert (S2 : s * s = p x) by (apply sqrt_sqrt; lra); assert (R2 : r * r = q x) by (apply sqrt_sqrt; lra).
  assert (Cx : c * x <= 6 * s).
  { apply Rsqr_incr_0_var; [unfold Rsqr | lra]; replace (c * x * (c * x)) with (c * c * (x * x)) by ring.
    replace (6 * s * (6 * s)) with (36 * (s * s)) by ring; rewrite C2, S2; assert (0 < x * x) by nra; nra. }
  apply Rmult_le_reg_r with (s + r); [lra|]. replace (c * Rabs (s - r) * (s + r)) with (c * Rabs (p x - q x)).
  - apply Rle_trans with (c * (l * (x * x) / 2)); [apply Rmult_le_compat_l; lra|]. assert (0 <= l * x) by nra;
      replace (c * (l * (x * x) / 2)) with (l * x * (c * x) / 2) by field; nra.
  - rewrite <- S2, <- R2; replace (s * s - r * r) with ((s - r) * (s + r)) by ring;
      rewrite Rabs_mult, (Rabs_pos_eq (s + r)) by lra; ring.
Qed.
(** Their speeds; at the crossing of the second the factor e is small. *)
Theorem crossing p p1 p2 q q1 q2 l : bowl a e rho p p1 p2 -> bowl a e rho q q1 q2 -> 0 <= l ->
  (forall x, 0 <= x <= rho -> Rabs (p2 x - q2 x) <= l) -> forall x y, 0 < x <= rho -> 0 < y <= rho ->
  Rabs (p1 x - c * sqrt (p x) - (q1 y - c * sqrt (q y))) <= 16 * l * x + 4 * e * c / (a - 3 * e) *
    Rabs (sqrt (p x) - sqrt (q y)).
Proof.
  intros HP HQ Hl H x y Hx Hy; destruct c_pos as [C0 C2]; destruct He as [E0 E4].
  destruct (together p p1 p2 q q1 q2 l HP HQ Hl H x Hx) as [D SR]; set (s := sqrt (p x)) in *;
    set (r := sqrt (q x)) in *. destruct (speed q q1 q2 HQ x y Hx Hy) as [A B]; fold r in A, B;
    set (t := sqrt (q y)) in *. set (f := 4 * e / (a - 3 * e)). assert (F : 0 <= f <= 4).
  { unfold f; split; [apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]|].
    apply Rmult_le_reg_r with (a - 3 * e); [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra. }
  assert (X : 4 * e * Rabs (x - y) <= f * (c * Rabs (r - t))).
  { replace (4 * e * Rabs (x - y)) with (f * ((a - 3 * e) * Rabs (x - y))) by (unfold f; field; lra);
      apply Rmult_le_compat_l; lra. }
  assert (Y : Rabs (r - t) <= Rabs (s - r) + Rabs (s - t)).
  { replace (r - t) with (- (s - r) + (s - t)) by ring; eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_Ropp; lra.
    }
  assert (Z : f * (c * Rabs (r - t)) <= 4 * (3 * (l * x)) + f * c * Rabs (s - t)).
  { apply Rle_trans with (f * (c * (Rabs (s - r) + Rabs (s - t))));
      [apply Rmult_le_compat_l; [lra | apply Rmult_le_compat_l; lra]|].
    assert (0 <= c * Rabs (s - r)) by (apply Rmult_le_pos; [lra | apply Rabs_pos]); nra. }
  replace (4 * e * c / (a - 3 * e)) with (f * c) by (unfold f; field; lra).
  replace (p1 x - c * s - (q1 y - c * t)) with ((p1 x - q1 x) + (- (c * (s - r)) + (q1 x - c * r - (q1 y - c * t))))
    by ring. eapply Rle_trans; [apply Rabs_triang|]; eapply Rle_trans; [apply Rplus_le_compat_l, Rabs_triang|].
  rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq c) by lra; lra.
Qed.

(** The same where one of the two is at its lowest point. *)
Lemma root p p1 p2 x : bowl a e rho p p1 p2 -> 0 <= x <= rho ->
  Rabs (p1 x - c * sqrt (p x)) <= 4 * e * x /\ (a - 3 * e) * x <= c * sqrt (p x).
Proof.
  intros HP Hx; destruct c_pos as [C0 C2]; destruct He as [E0 E4]. pose proof (slope p p1 p2 HP x Hx) as Sl;
    pose proof (height p p1 p2 HP x Hx) as Hh. assert (X2 : 0 <= x * x) by nra; assert (P0 : 0 <= p x).
  { apply Rle_trans with ((a - e) * (x * x) / 2); [|lra]; assert (0 <= (a - e) * (x * x)) by (apply Rmult_le_pos; lra);
      lra. }
  pose proof (sqrt_pos (p x)) as S0; assert (S2 : sqrt (p x) * sqrt (p x) = p x) by (apply sqrt_sqrt; lra).
  set (s := sqrt (p x)) in *; assert (Q : (c * s) * (c * s) = 2 * a * p x) by (rewrite <- C2, <- S2; ring).
  assert (0 <= e * x) by (apply Rmult_le_pos; lra); assert (0 <= (a - e) * x) by (apply Rmult_le_pos; lra).
  assert (Cs : 0 <= c * s) by (apply Rmult_le_pos; lra).
  assert (A : 2 * a * p x <= a * ((a + e) * (x * x))) by (replace (a * ((a + e) * (x * x)))
    with (2 * a * ((a + e) * (x * x) / 2)) by field; apply Rmult_le_compat_l; lra).
  assert (A' : a * ((a - e) * (x * x)) <= 2 * a * p x) by (replace (a * ((a - e) * (x * x)))
    with (2 * a * ((a - e) * (x * x) / 2)) by field; apply Rmult_le_compat_l; lra).
  assert (Ex : 0 <= e * (x * x) /\ 0 <= (a + e) * (e * (x * x)) /\ 0 <= (a - e) * (e * (x * x))).
  { assert (0 <= e * (x * x)) by (apply Rmult_le_pos; lra); split; [assumption|]; split; apply Rmult_le_pos; lra. }
  assert (Up : c * s <= (a + e) * x) by (apply Rsqr_incr_0_var; [unfold Rsqr; lra | lra]).
  assert (Lo : (a - e) * x <= c * s) by (apply Rsqr_incr_0_var; [unfold Rsqr; lra | lra]). split;
    [apply Rabs_le; lra | lra].
Qed.
Lemma fraction x s : 0 <= x -> (a - 3 * e) * x <= c * s -> 4 * e * x <= 4 * e * c / (a - 3 * e) * s.
Proof.
  intros Hx H; destruct He as [E0 E4];
    replace (4 * e * c / (a - 3 * e) * s) with (4 * e * ((c * s) / (a - 3 * e))) by (field; lra).
  apply Rmult_le_compat_l; [lra|]; apply Rmult_le_reg_r with (a - 3 * e); [lra|]; unfold Rdiv;
    rewrite (Rmult_assoc (c * s)), Rinv_l by lra; lra.
Qed.
Theorem crossing' p p1 p2 q q1 q2 l : bowl a e rho p p1 p2 -> bowl a e rho q q1 q2 -> 0 <= l ->
  (forall x, 0 <= x <= rho -> Rabs (p2 x - q2 x) <= l) -> forall x y, 0 <= x <= rho -> 0 <= y <= rho ->
  Rabs (p1 x - c * sqrt (p x) - (q1 y - c * sqrt (q y))) <= 16 * l * x + 4 * e * c / (a - 3 * e) *
    Rabs (sqrt (p x) - sqrt (q y)).
Proof.
  intros HP HQ Hl H x y [[Hx|<-] Hx'] [[Hy|<-] Hy'].
  - apply (crossing p p1 p2 q q1 q2 l HP HQ Hl H); lra.
  - destruct (root p p1 p2 x HP ltac:(lra)) as [A B]; destruct HQ as (-> & -> & _);
      rewrite sqrt_0, Rmult_0_r, !Rminus_0_r. rewrite (Rabs_pos_eq (sqrt (p x))) by apply sqrt_pos;
      pose proof (fraction x _ ltac:(lra) B); assert (0 <= l * x) by nra; lra.
  - destruct (root q q1 q2 y HQ ltac:(lra)) as [A B]; destruct HP as (-> & -> & _);
      rewrite sqrt_0, !Rmult_0_r, Rminus_0_r, !Rminus_0_l, !Rabs_Ropp.
    rewrite (Rabs_pos_eq (sqrt (q y))) by apply sqrt_pos; pose proof (fraction y _ ltac:(lra) B); lra.
  - destruct HP as (-> & -> & _), HQ as (-> & -> & _); rewrite sqrt_0, !Rmult_0_r, !Rminus_eq_0, Rabs_R0; lra.
Qed.

Theorem offsets p p1 p2 q q1 q2 l : bowl a e rho p p1 p2 -> bowl a e rho q q1 q2 -> 0 <= l ->
  (forall x, 0 <= x <= rho -> Rabs (p2 x - q2 x) <= l) -> forall x y, 0 <= x <= rho -> 0 <= y <= rho ->
  (a - 3 * e) * Rabs (x - y) <= 3 * (l * x) + c * Rabs (sqrt (p x) - sqrt (q y)).
Proof.
  intros HP HQ Hl H x y [[Hx|<-] Hx'] [[Hy|<-] Hy']; destruct c_pos as [C0 C2].
  - destruct (together p p1 p2 q q1 q2 l HP HQ Hl H x ltac:(lra)) as [_ A];
      destruct (speed q q1 q2 HQ x y ltac:(lra) ltac:(lra)) as [_ B]. apply Rle_trans with (1 := B);
      replace (sqrt (q x) - sqrt (q y)) with (- (sqrt (p x) - sqrt (q x)) + (sqrt (p x) - sqrt (q y))) by ring.
    apply Rle_trans with (c * (Rabs (sqrt (p x) - sqrt (q x)) + Rabs (sqrt (p x) - sqrt (q y)))); [|lra].
    apply Rmult_le_compat_l; [lra|]; eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_Ropp; lra.
  - destruct (root p p1 p2 x HP ltac:(lra)) as [_ B]; destruct HQ as (-> & _); rewrite sqrt_0, !Rminus_0_r, (Rabs_pos_eq
      x) by lra. rewrite Rabs_pos_eq by apply sqrt_pos; assert (0 <= l * x) by nra; lra.
  - destruct (root q q1 q2 y HQ ltac:(lra)) as [_ B]; destruct HP as (-> & _);
      rewrite sqrt_0, !Rminus_0_l, !Rabs_Ropp, (Rabs_pos_eq y) by lra. rewrite Rabs_pos_eq by apply sqrt_pos; lra.
  - rewrite Rminus_eq_0, Rabs_R0; pose proof (Rabs_pos (sqrt (p 0) - sqrt (q 0)));
      assert (0 <= c * Rabs (sqrt (p 0) - sqrt (q 0))) by (apply Rmult_le_pos; lra); lra.
Qed.
End Bowls.
