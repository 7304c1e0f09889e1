(** * Gronwall's inequality for pairs of functions, forwards and backwards in time *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import Derivatives.
Open Scope R_scope.

(** E' <= M E + k on [0, T]. *)
Lemma gronwall E E' M k T : 0 < M -> (forall x, 0 <= x <= T -> derivable_pt_lim E x (E' x)) ->
  (forall x, 0 <= x <= T -> E' x <= M * E x + k) -> forall t, 0 <= t <= T -> E t + k / M <= (E 0 + k / M) * exp (M * t).
Proof.
  intros HM D H t Ht; destruct (Req_dec t 0) as [-> | N]; [rewrite Rmult_0_r, exp_0; lra|].
  set (F x := (E x + k / M) * exp (- M * x));
    set (F' x := (E' x + 0) * exp (- M * x) + (E x + k / M) * (exp (- M * x) * (- M * 1))).
  assert (DF : forall x, 0 <= x <= t -> derivable_pt_lim F x (F' x)).
  { intros x Hx; apply (derivable_pt_lim_mult (fun x => E x + k / M) (fun x => exp (- M * x))).
    - apply (derivable_pt_lim_plus E (fun _ => k / M)); [apply D; lra | apply derivable_pt_lim_const].
    - apply (derivable_pt_lim_comp (fun x => - M * x) exp); [|apply derivable_pt_lim_exp].
      apply derivable_pt_lim_scal, derivable_pt_lim_id. }
  destruct (MVT_cor2 F F' 0 t ltac:(lra) DF) as (x & E1 & Hx). assert (F' x <= 0).
  { unfold F'; pose proof (exp_pos (- M * x)) as P; pose proof (H x ltac:(lra)) as Q.
    replace ((E' x + 0) * exp (- M * x) + (E x + k / M) * (exp (- M * x) * (- M * 1)))
      with ((E' x - (M * E x + k)) * exp (- M * x)) by (field; lra). nra. }
  assert (F t <= F 0) by nra; unfold F in *; rewrite Rmult_0_r, exp_0, Rmult_1_r in *.
  assert (P : exp (- M * t) * exp (M * t) = 1) by (rewrite <- exp_plus; replace (- M * t + M * t) with 0 by ring;
    apply exp_0). pose proof (exp_pos (M * t));
    replace (E t + k / M) with ((E t + k / M) * exp (- M * t) * exp (M * t)) by (rewrite Rmult_assoc, P; ring).
  apply Rmult_le_compat_r; lra.
Qed.

(** For a pair whose derivatives are at most L times its norm, and e. *)
Lemma gronwall2 p p' q q' L e T : 0 <= L -> 0 <= e -> (forall x, 0 <= x <= T -> derivable_pt_lim p x (p' x) /\
  derivable_pt_lim q x (q' x)) -> (forall x, 0 <= x <= T -> Rabs (p' x) <= L * (Rabs (p x) + Rabs (q x)) + e /\
  Rabs (q' x) <= L * (Rabs (p x) + Rabs (q x)) + e) -> forall t, 0 <= t <= T -> Rabs (p t) + Rabs (q t) <= 2 * (Rabs (p
  0) + Rabs (q 0) + e) * exp ((2 * L + 1) * T).
Proof.
  intros HL He D H t Ht; set (M := 4 * L + 2). set (E x := p x * p x + q x * q x);
    set (E' x := p' x * p x + p x * p' x + (q' x * q x + q x * q' x)).
  assert (G : E t + 2 * (e * e) / M <= (E 0 + 2 * (e * e) / M) * exp (M * t)).
  { apply (gronwall E E' M (2 * (e * e)) T); unfold M; [lra | | | exact Ht].
    - intros x Hx; destruct (D x Hx); apply (derivable_pt_lim_plus (fun x => p x * p x) (fun x => q x * q x));
        apply derivable_pt_lim_mult; assumption.
    - intros x Hx; destruct (H x Hx) as [A B]; unfold E', E. pose proof (Rabs_pos (p x)); pose proof (Rabs_pos (q x)).
      assert (S1 : p x * p' x <= Rabs (p x) * Rabs (p' x)) by (rewrite <- Rabs_mult; apply Rle_abs).
      assert (S2 : q x * q' x <= Rabs (q x) * Rabs (q' x)) by (rewrite <- Rabs_mult; apply Rle_abs).
      assert (E1 : p x * p x = Rabs (p x) * Rabs (p x)) by (rewrite <- Rabs_mult, Rabs_pos_eq; [ring | nra]).
      assert (E2 : q x * q x = Rabs (q x) * Rabs (q x)) by (rewrite <- Rabs_mult, Rabs_pos_eq; [ring | nra]).
      rewrite E1, E2; set (a := Rabs (p x)) in *; set (b := Rabs (q x)) in *.
      assert (p x * p' x <= a * (L * (a + b) + e)) by (apply Rle_trans with (1 := S1), Rmult_le_compat_l; lra).
      assert (q x * q' x <= b * (L * (a + b) + e)) by (apply Rle_trans with (1 := S2), Rmult_le_compat_l; lra).
      assert (0 <= (a - b) * (a - b) * L) by (apply Rmult_le_pos; [apply Rle_0_sqr | lra]).
      pose proof (Rle_0_sqr (a - e)) as U1; pose proof (Rle_0_sqr (b - e)) as U2; unfold Rsqr in U1, U2. nra. }
  assert (HM : 2 <= M) by (unfold M; lra); set (K := exp ((2 * L + 1) * T)). assert (X : exp (M * t) <= K * K).
  { unfold K; rewrite <- exp_plus; destruct (Req_dec t T) as [-> | N]; [right; f_equal; unfold M; ring|]. left;
      apply exp_increasing; unfold M; nra. }
  assert (HK : 0 < K) by apply exp_pos. assert (Hk : 0 <= 2 * (e * e) / M <= e * e).
  { split; [apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; lra]|]. apply Rmult_le_reg_r with M; [lra|];
      unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; nra. }
  set (n0 := Rabs (p 0) + Rabs (q 0)); pose proof (Rabs_pos (p 0)) as P0; pose proof (Rabs_pos (q 0)) as Q0.
  assert (Z : E 0 <= n0 * n0).
  { unfold E, n0;
      assert (E1 : p 0 * p 0 = Rabs (p 0) * Rabs (p 0)) by (rewrite <- Rabs_mult, Rabs_pos_eq; [ring | nra]).
    assert (E2 : q 0 * q 0 = Rabs (q 0) * Rabs (q 0)) by (rewrite <- Rabs_mult, Rabs_pos_eq; [ring | nra]).
    rewrite E1, E2; assert (0 <= Rabs (p 0) * Rabs (q 0)) by (apply Rmult_le_pos; lra); lra. }
  assert (HE0 : 0 <= E 0) by (unfold E; nra). assert (Y : E t <= (n0 + e) * (n0 + e) * (K * K)).
  { apply Rle_trans with ((E 0 + 2 * (e * e) / M) * (K * K)).
    - apply Rle_trans with ((E 0 + 2 * (e * e) / M) * exp (M * t)); [lra|]; apply Rmult_le_compat_l; lra.
    - apply Rmult_le_compat_r; [nra|]; assert (0 <= n0) by (unfold n0; lra); nra. }
  set (s := Rabs (p t) + Rabs (q t)); pose proof (Rabs_pos (p t)) as Pt; pose proof (Rabs_pos (q t)) as Qt.
  assert (W : s * s <= 2 * E t).
  { unfold E, s; assert (E1 : p t * p t = Rabs (p t) * Rabs (p t)) by (rewrite <- Rabs_mult, Rabs_pos_eq; [ring | nra]).
    assert (E2 : q t * q t = Rabs (q t) * Rabs (q t)) by (rewrite <- Rabs_mult, Rabs_pos_eq; [ring | nra]).
    rewrite E1, E2; pose proof (Rle_0_sqr (Rabs (p t) - Rabs (q t))) as U; unfold Rsqr in U; lra. }
  assert (0 <= n0) by (unfold n0; lra). fold n0 s; apply Rsqr_incr_0_var; unfold Rsqr;
    [|apply Rmult_le_pos; [lra | lra]].
  replace (2 * (n0 + e) * K * (2 * (n0 + e) * K)) with (4 * ((n0 + e) * (n0 + e) * (K * K))) by ring; nra.
Qed.

Lemma gronwall2_back L T f f' g g' e : 0 <= L -> 0 <= e -> (forall x, 0 <= x <= T -> derivable_pt_lim f x (f' x) /\
  derivable_pt_lim g x (g' x)) -> (forall x, 0 <= x <= T -> Rabs (f' x) <= L * (Rabs (f x) + Rabs (g x)) + e /\
  Rabs (g' x) <= L * (Rabs (f x) + Rabs (g x)) + e) -> forall t, 0 <= t <= T -> Rabs (f 0) + Rabs (g 0) <= 2 * (Rabs (f
  t) + Rabs (g t) + e) * exp ((2 * L + 1) * T).
Proof.
  intros HL He D H t Ht.
  assert (Db : forall h h' s, derivable_pt_lim h (t - s) (h' (t - s)) ->
    derivable_pt_lim (fun s => h (t - s)) s (- h' (t - s))).
  { intros h h' s Df; replace (- h' (t - s)) with (h' (t - s) * (0 - 1)) by ring.
    apply (derivable_pt_lim_comp (fun s => t - s) h); [|exact Df]. apply derivable_pt_lim_minus;
      [apply derivable_pt_lim_const | apply derivable_pt_lim_id]. }
  pose proof (gronwall2 (fun s => f (t - s)) (fun s => - f' (t - s)) (fun s => g (t - s)) (fun s => - g' (t - s)) L e t
    ltac:(lra) He) as G; cbv beta in G; rewrite !Rminus_0_r in G.
  specialize (G ltac:(intros s Hs; destruct (D (t - s) ltac:(lra)); split; apply Db; assumption) ltac:(intros s Hs;
    rewrite !Rabs_Ropp; apply H; lra) t ltac:(lra)); replace (t - t) with 0 in G by ring. eapply Rle_trans; [exact G|];
    apply Rmult_le_compat_l; [pose proof (Rabs_pos (f t)); pose proof (Rabs_pos (g t)); lra|].
  destruct (Req_dec t T) as [-> | N]; [lra|]; left; apply exp_increasing; apply Rmult_lt_compat_l; lra.
Qed.

(** Both ways, where the derivatives are at most L times the norm and m. *)
Lemma bound L T z w w' m : 1 <= L -> 0 <= m -> (forall x, 0 <= x <= T -> derivable_pt_lim z x (w x) /\
  derivable_pt_lim w x (w' x) /\ Rabs (w' x) <= L * (Rabs (z x) + Rabs (w x) + m)) -> forall x, 0 <= x <= T ->
  let K := 2 * (1 + L) * exp ((2 * L + 1) * T) in Rabs (z x) + Rabs (w x) <= K * (Rabs (z 0) + Rabs (w 0) + m) /\
  Rabs (z 0) + Rabs (w 0) <= K * (Rabs (z x) + Rabs (w x) + m).
Proof.
  intros HL Hm H x Hx K; assert (D : forall s, 0 <= s <= T -> derivable_pt_lim z s (w s) /\ derivable_pt_lim w s (w' s))
    by (intros s Hs; destruct (H s Hs) as (A & B & _); auto).
  assert (B : forall s, 0 <= s <= T -> Rabs (w s) <= L * (Rabs (z s) + Rabs (w s)) + L * m /\ Rabs (w' s) <=
    L * (Rabs (z s) + Rabs (w s)) + L * m).
  { intros s Hs; destruct (H s Hs) as (_ & _ & Q); pose proof (Rabs_pos (z s)); pose proof (Rabs_pos (w s)); split; nra.
    }
  assert (E : forall n, 0 <= n -> 2 * (n + L * m) * exp ((2 * L + 1) * T) <= K * (n + m)).
  { intros n Hn; unfold K; replace (2 * (1 + L) * exp ((2 * L + 1) * T) * (n + m)) with (2 * ((1 + L) * (n + m)) * exp
      ((2 * L + 1) * T)) by ring. pose proof (exp_pos ((2 * L + 1) * T)); apply Rmult_le_compat_r; [lra | nra]. }
  assert (P : forall s, 0 <= Rabs (z s) + Rabs (w s)) by (intros s; pose proof (Rabs_pos (z s));
    pose proof (Rabs_pos (w s)); lra). split; (eapply Rle_trans; [|apply E, P]);
    [apply (gronwall2 z w w w' L (L * m) T) | apply (gronwall2_back L T z w w w' (L * m))]; trivial; nra.
Qed.
(** [mvt] on [0, T]. *)
Lemma mvt_on T f f' B x y : 0 <= x <= T -> 0 <= y <= T -> (forall s, 0 <= s <= T -> derivable_pt_lim f s (f' s) /\
  Rabs (f' s) <= B) -> Rabs (f x - f y) <= B * Rabs (x - y).
Proof.
  intros Hx Hy H; destruct (Rtotal_order x y) as [O | [-> | O]].
  - destruct (MVT_cor2 f f' x y O) as (s & E & Hs); [intros s Hs; apply H; lra|]. rewrite <- Rabs_Ropp;
      replace (- (f x - f y)) with (f y - f x) by ring; rewrite E, Rabs_mult, (Rabs_minus_sym x y).
    apply Rmult_le_compat_r; [apply Rabs_pos | apply H; lra].
  - replace (f y - f y) with 0 by ring; replace (y - y) with 0 by ring; rewrite !Rabs_R0; lra.
  - destruct (MVT_cor2 f f' y x O) as (s & E & Hs); [intros s Hs; apply H; lra|]. rewrite E, Rabs_mult;
      apply Rmult_le_compat_r; [apply Rabs_pos | apply H; lra].
Qed.
