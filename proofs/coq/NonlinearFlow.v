(** * The flow of y'' = a (t, y, y', mu) on [0, T]: its solutions as functions of the state at the time 0 and of mu,
      Lipschitz in both; where a has period T, the state one period later is again one at the time 0 *)
From Coq Require Import Reals Lra Lia.
From Grazing Require Import StatementOrbits Contraction Derivatives NonlinearGronwall.
From Grazing Require NonlinearStrict.
Module S := NonlinearStrict.
Open Scope R_scope.

(** A solution at the time t. *)
Definition moves (a : R -> R -> R -> R -> R) mu (y v : R -> R) t :=
  derivable_pt_lim y t (v t) /\ derivable_pt_lim v t (a t (y t) (v t) mu).
Definition runs a mu y v := forall t, moves a mu y v t.
(** Given: that a is Lipschitz, that solutions exist, and a solution y0, v0 at mu = 0; and that all has period T. *)
Class force := { a : R -> R -> R -> R -> R; T : R; L : R; y0 : R -> R; v0 : R -> R; HT : 0 < T; HL : 1 <= L;
  Ha : forall t y v mu t' y' v' mu', Rabs (a t y v mu - a t' y' v' mu') <=
    L * (Rabs (t - t') + Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu'));
  Horb : runs a 0 y0 v0;
  Hflow : forall mu s p r, exists y v, runs a mu y v /\ y s = p /\ v s = r }.
(** What the context has of the classes here and below, where a term that is being read leaves it open. *)
Ltac here := repeat match goal with |- context [?e] => is_evar e; let t := type of e in let i :=
  constr:(_ : t) in unify e i end.
Section Flow.
Context {the_force : force}.
Let HT := HT. Let HL := HL.
Notation at_time := (moves a).
Notation sol := (runs a).

Lemma Ha0 t y v y' v' mu : Rabs (a t y v mu - a t y' v' mu) <= L * (Rabs (y - y') + Rabs (v - v')).
Proof. pose proof (Ha t y v mu t y' v' mu) as H; rewrite !Rminus_eq_0, Rabs_R0 in H; lra. Qed.

(** Solutions that agree at one time of an interval agree on it. *)
Lemma unique_on lo hi mu y v y' v' s : (forall t, lo <= t <= hi -> at_time mu y v t /\ at_time mu y' v' t) ->
  lo <= s <= hi -> y s = y' s -> v s = v' s -> forall t, lo <= t <= hi -> y t = y' t /\ v t = v' t.
Proof.
  intros H Hs Ey Ev t Ht. assert (Z : Rabs (y t - y' t) + Rabs (v t - v' t) <= 0).
  { destruct (Rle_dec s t) as [O|O].
    - pose proof (gronwall2 (fun x => y (s + x) - y' (s + x)) (fun x => v (s + x) - v' (s + x)) (fun x => v (s + x) -
        v' (s + x)) (fun x => a (s + x) (y (s + x)) (v (s + x)) mu - a (s + x) (y' (s + x)) (v' (s + x)) mu) L 0 (t - s)
        ltac:(here; lra) ltac:(here; lra)) as G. cbv beta in G; rewrite !Rplus_0_r, Ey, Ev, !Rminus_eq_0, Rabs_R0 in G;
        specialize (fun A B => G A B (t - s)). replace (s + (t - s)) with t in G by ring; eapply Rle_trans; [apply G|];
        try lra.
      + intros x Hx; destruct (H (s + x) ltac:(here; lra)) as [[A B] [A' B']]; split; apply D_minus; apply D_on;
          assumption.
      + intros x Hx; pose proof (Ha0 (s + x) (y (s + x)) (v (s + x)) (y' (s + x)) (v' (s + x)) mu).
        pose proof (Rabs_pos (y (s + x) - y' (s + x))); pose proof (Rabs_pos (v (s + x) - v' (s + x))); split; nra.
    - pose proof (gronwall2 (fun x => y (s - x) - y' (s - x)) (fun x => - v (s - x) - - v' (s - x))
        (fun x => v (s - x) - v' (s - x)) (fun x => - a (s - x) (y (s - x)) (v (s - x)) mu - - a (s - x) (y' (s - x))
        (v' (s - x)) mu) L 0 (s - t) ltac:(here; lra) ltac:(here; lra)) as G. cbv beta in G;
        rewrite !Rplus_0_r, !Rminus_0_r, Ey, Ev, !Rminus_eq_0, Rabs_R0 in G; specialize (fun A B => G A B (s - t)).
      replace (s - (s - t)) with t in G by ring; eapply Rle_trans; [apply G|]; try lra.
      + intros x Hx; destruct (H (s - x) ltac:(here; lra)) as [[A B] [A' B']]; split; apply D_minus; apply D_back;
          assumption.
      + intros x Hx; pose proof (Ha0 (s - x) (y (s - x)) (v (s - x)) (y' (s - x)) (v' (s - x)) mu).
        replace (- v (s - x) - - v' (s - x)) with (- (v (s - x) - v' (s - x))) by ring.
        replace (- a (s - x) (y (s - x)) (v (s - x)) mu - - a (s - x) (y' (s - x)) (v' (s - x)) mu)
          with (- (a (s - x) (y (s - x)) (v (s - x)) mu - a (s - x) (y' (s - x)) (v' (s - x)) mu)) by ring.
        rewrite !Rabs_Ropp. pose proof (Rabs_pos (y (s - x) - y' (s - x)));
          pose proof (Rabs_pos (v (s - x) - v' (s - x))); split; nra. }
  pose proof (Rabs_pos (y t - y' t)); pose proof (Rabs_pos (v t - v' t)). split; apply Rminus_diag_uniq, Rabs_zero; lra.
Qed.
Lemma unique mu y v y' v' s : sol mu y v -> sol mu y' v' -> y s = y' s -> v s = v' s -> forall t, y t = y' t /\
  v t = v' t.
Proof.
  intros H H' Ey Ev t; apply (unique_on (Rmin s t) (Rmax s t) mu y v y' v' s); auto.
  - split; [apply Rmin_l | apply Rmax_l].
  - split; [apply Rmin_r | apply Rmax_r].
Qed.

Definition starts mu (x : vec) y v := sol mu y v /\ y 0 = y0 0 + x 0%nat /\ v 0 = v0 0 + x 1%nat.
Definition Y (x : vec) mu t := the (fun r => exists y v, starts mu x y v /\ r = y t).
Definition V (x : vec) mu t := the (fun r => exists y v, starts mu x y v /\ r = v t).
Lemma starts_is mu x y v : starts mu x y v -> forall t, Y x mu t = y t /\ V x mu t = v t.
Proof.
  intros H t; split; (apply the_spec; [exists y, v; auto|]; intros r (y' & v' & (S' & P & Q) & ->)); destruct H as (S0 &
    P0 & Q0); destruct (unique mu y' v' y v 0 S' S0 ltac:(here; congruence) ltac:(here; congruence) t); assumption.
Qed.
Lemma flow x mu : starts mu x (Y x mu) (V x mu).
Proof.
  destruct (Hflow mu 0 (y0 0 + x 0%nat) (v0 0 + x 1%nat)) as (y & v & H & P & Q).
  assert (E := starts_is mu x y v (conj H (conj P Q))); split; [|rewrite (proj1 (E 0)), (proj2 (E 0)); auto]. intros t;
    unfold moves; destruct (H t) as [A B]; rewrite (proj1 (E t)), (proj2 (E t)). split;
    [apply (D_ext _ _ _ _ _ A) | apply (D_ext _ _ _ _ _ B)]; trivial; intros s; symmetry; apply E.
Qed.
Lemma Y_ext x x' mu t : x 0%nat = x' 0%nat -> x 1%nat = x' 1%nat -> Y x mu t = Y x' mu t /\ V x mu t = V x' mu t.
Proof. intros E E'; apply starts_is; destruct (flow x' mu) as (A & B & C); split; [exact A|]; rewrite E, E'; auto. Qed.

(** The state at the time 0 of the solution that is at p, r at the time s. *)
Definition state (y v : R -> R) : vec := fun i => match i with O => y 0 - y0 0 | _ => v 0 - v0 0 end.
Lemma state_starts mu y v : sol mu y v -> starts mu (state y v) y v.
Proof. intros H; split; [exact H|]; unfold state; split; ring. Qed.
Definition origin mu s p r : vec := fun i => the (fun q => exists y v, sol mu y v /\ y s = p /\ v s = r /\
  q = state y v i).
Lemma origin_is mu s y v i : sol mu y v -> origin mu s (y s) (v s) i = state y v i.
Proof.
  intros H; unfold origin; apply the_spec; [exists y, v; auto|]; intros q (y' & v' & H' & E & E' & ->).
  destruct (unique mu y' v' y v s H' H E E' 0) as [A B]; unfold state; rewrite A, B; reflexivity.
Qed.
Lemma origin_flow mu s p r : Y (origin mu s p r) mu s = p /\ V (origin mu s p r) mu s = r.
Proof.
  destruct (Hflow mu s p r) as (y & v & H & <- & <-).
  destruct (Y_ext (origin mu s (y s) (v s)) (state y v) mu s) as [-> ->]; try apply origin_is; trivial.
  apply starts_is, state_starts, H.
Qed.
Lemma origin_same x mu s i : (i < 2)%nat -> origin mu s (Y x mu s) (V x mu s) i = x i.
Proof.
  intros Hi; destruct (flow x mu) as (A & B & C); rewrite origin_is by exact A; unfold state. destruct i as [|[|i]];
    [rewrite B; ring | rewrite C; ring | lia].
Qed.


(** Lipschitz bounds over one period. *)
Definition M := 3 * (2 * (1 + L) * exp ((2 * L + 1) * T)).
Lemma M_large : 1 <= M.
Proof.
  unfold M; assert (P : 1 < exp ((2 * L + 1) * T)) by (rewrite <- exp_0 at 1; apply exp_increasing; apply
    Rmult_lt_0_compat; lra). pose proof (Rmult_le_compat_l (1 + L) 1 _ ltac:(here; lra) (Rlt_le _ _ P)); lra.
Qed.
Lemma Hlip x y v mu y' v' mu' : 0 <= x <= T ->
  Rabs (a x y v mu - a x y' v' mu') <= L * (Rabs (y - y') + Rabs (v - v') + Rabs (mu - mu')).
Proof. intros _; pose proof (Ha x y v mu x y' v' mu') as H; rewrite Rminus_eq_0, Rabs_R0 in H; lra. Qed.
Lemma sol_in mu y v : sol mu y v -> S.solution a T mu y v.
Proof. intros H x _; apply H. Qed.
Lemma nearby x x' mu mu' r s : within 2 r (minus x x') -> Rabs (mu - mu') <= r -> 0 <= s <= T ->
  Rabs (Y x mu s - Y x' mu' s) <= M * r /\ Rabs (V x mu s - V x' mu' s) <= M * r.
Proof.
  intros Hx Hm Hs; destruct (flow x mu) as (A & B & C), (flow x' mu') as (A' & B' & C').
  pose proof (S.close a T L HL Hlip _ _ _ _ _ _ (sol_in _ _ _ A) (sol_in _ _ _ A') s Hs) as H;
    rewrite B, C, B', C' in H. pose proof (Hx 0%nat ltac:(lia)) as X0; pose proof (Hx 1%nat ltac:(lia)) as X1;
    unfold minus in X0, X1. replace (y0 0 + x 0%nat - (y0 0 + x' 0%nat)) with (x 0%nat - x' 0%nat) in H by ring.
  replace (v0 0 + x 1%nat - (v0 0 + x' 1%nat)) with (x 1%nat - x' 1%nat) in H by ring. pose proof M_large as LM;
    unfold M in *; set (k := 2 * (1 + L) * exp ((2 * L + 1) * T)) in *.
  assert (k * (Rabs (x 0%nat - x' 0%nat) + Rabs (x 1%nat - x' 1%nat) + Rabs (mu - mu')) <= k * (3 * r))
    by (apply Rmult_le_compat_l; lra). pose proof (Rabs_pos (Y x mu s - Y x' mu' s));
    pose proof (Rabs_pos (V x mu s - V x' mu' s)); split; lra.
Qed.
Lemma nearby_back x x' mu mu' r s : Rabs (Y x mu s - Y x' mu' s) <= r -> Rabs (V x mu s - V x' mu' s) <= r ->
  Rabs (mu - mu') <= r -> 0 <= s <= T -> within 2 (M * r) (minus x x').
Proof.
  intros Hy Hv Hm Hs; destruct (flow x mu) as (A & B & C), (flow x' mu') as (A' & B' & C').
  pose proof (S.close_back a T L HL Hlip _ _ _ _ _ _ (sol_in _ _ _ A) (sol_in _ _ _ A') s Hs) as H;
    rewrite B, C, B', C' in H. replace (y0 0 + x 0%nat - (y0 0 + x' 0%nat)) with (x 0%nat - x' 0%nat) in H by ring.
  replace (v0 0 + x 1%nat - (v0 0 + x' 1%nat)) with (x 1%nat - x' 1%nat) in H by ring. pose proof M_large as LM;
    unfold M in *; set (k := 2 * (1 + L) * exp ((2 * L + 1) * T)) in *.
  assert (k * (Rabs (Y x mu s - Y x' mu' s) + Rabs (V x mu s - V x' mu' s) + Rabs (mu - mu')) <= k * (3 * r))
    by (apply Rmult_le_compat_l; lra). pose proof (Rabs_pos (x 0%nat - x' 0%nat));
    pose proof (Rabs_pos (x 1%nat - x' 1%nat)). intros i Hi; unfold minus; destruct i as [|[|i]]; [lra | lra | lia].
Qed.
Lemma at_rest t : Y zero 0 t = y0 t /\ V zero 0 t = v0 t.
Proof. apply starts_is; split; [exact Horb|]; unfold zero; split; ring. Qed.
Lemma near_y0 x mu r s : within 2 r x -> Rabs mu <= r -> 0 <= s <= T ->
  Rabs (Y x mu s - y0 s) <= M * r /\ Rabs (V x mu s - v0 s) <= M * r.
Proof.
  intros Hx Hm Hs; destruct (at_rest s) as [<- <-]; apply nearby; [|rewrite Rminus_0_r; exact Hm | exact Hs].
  intros i Hi; unfold minus, zero; rewrite Rminus_0_r; apply Hx, Hi.
Qed.
End Flow.
