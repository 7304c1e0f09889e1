(** * Iterates of the map are nearly linear near 0, uniformly up to n_max steps

    Strict differentiability passes from f and h to f^k and h o f^k, and to the equations
    (19): what remains after their linear part has a Lipschitz constant as small as wished. *)

From Coq Require Import Reals Lra Lia.
From Grazing Require Import StatementOrbits Finite OrbitVectors.
Import Map.
Open Scope R_scope.

Lemma triangle3 x y z a c e : Rabs x <= a -> Rabs y <= c -> Rabs z <= e -> Rabs (x + y + z) <= a + c + e.
Proof.
  intros; eapply Rle_trans; [apply Rabs_triang|]; apply Rplus_le_compat; [|assumption].
  eapply Rle_trans; [apply Rabs_triang|]; apply Rplus_le_compat; assumption.
Qed.
Lemma triangle2 x y a c : Rabs x <= a -> Rabs y <= c -> Rabs (x + y) <= a + c.
Proof. intros; eapply Rle_trans; [apply Rabs_triang|]; apply Rplus_le_compat; assumption. Qed.
Lemma Rabs_mult_le x y a c : Rabs x <= a -> Rabs y <= c -> Rabs (x * y) <= a * c.
Proof. intros; rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos. Qed.
Lemma Rabs_nonneg x a : Rabs x <= a -> 0 <= a.
Proof. intros H; eapply Rle_trans; [apply Rabs_pos | exact H]. Qed.

Section Strict.
Variable N : nat.
Notation within := (within N).
Notation dot := (dot N).

Definition nearly (F : vec -> R -> R) (L : vec -> R) (p eps d : R) : Prop :=
  forall x x' mu mu' t, within d x -> within d x' -> Rabs mu <= d -> Rabs mu' <= d ->
  within t (minus x x') -> Rabs (mu - mu') <= t ->
  Rabs (F x mu - F x' mu' - L (minus x x') - (mu - mu') * p) <= eps * t.

Lemma nearly_down F L p eps d d' : nearly F L p eps d -> d' <= d -> nearly F L p eps d'.
Proof. intros H Hd x x' mu mu' t Hx Hx' Hm Hm'. apply H; try lra; eapply within_le; eassumption. Qed.
Lemma nearly_up F L p eps eps' d : nearly F L p eps d -> eps <= eps' -> nearly F L p eps' d.
Proof.
  intros H He x x' mu mu' t Hx Hx' Hm Hm' Ht Hmt; eapply Rle_trans; [apply H; eassumption|].
  apply Rmult_le_compat_r; [exact (Rabs_nonneg _ _ Hmt) | exact He].
Qed.
Lemma strict_nearly F L p eps : strict N F L p -> 0 < eps -> exists d, 0 < d /\ nearly F L p eps d.
Proof. intros [_ H] He; exact (H eps He). Qed.

(** A Lipschitz constant. *)
Lemma nearly_Lipschitz F L p d m : nearly F L p 1 d -> (forall e x, 0 <= e -> within e x -> Rabs (L x) <= m * e) ->
  forall x x' mu mu' t, within d x -> within d x' -> Rabs mu <= d -> Rabs mu' <= d -> within t (minus x x') ->
  Rabs (mu - mu') <= t -> Rabs (F x mu - F x' mu') <= (m + 1 + Rabs p) * t.
Proof.
  intros H HL x x' mu mu' t Hx Hx' Hm Hm' Ht Hmt; pose proof (Rabs_nonneg _ _ Hmt) as Ht0.
  replace (F x mu - F x' mu') with ((F x mu - F x' mu' - L (minus x x') - (mu - mu') * p) + L (minus x x') + (mu - mu')
    * p) by ring.
  replace ((m + 1 + Rabs p) * t) with (1 * t + m * t + t * Rabs p) by ring.
  apply triangle3; [apply H | apply HL | apply Rabs_mult_le]; trivial; lra.
Qed.

(** On one neighbourhood all coordinates of F are as near to their derivatives as is wanted, and F is Lipschitz. *)
Lemma nearly_all F (L : vec -> vec) q m Q : (forall i, (i < N)%nat -> strict N (fun x mu => F x mu i) (fun x => L x i)
  (q i)) -> (forall e x, 0 <= e -> within e x -> within (m * e) (L x)) -> (forall i, (i < N)%nat -> Rabs (q i) <= Q) ->
  forall eps, 0 < eps -> exists d, 0 < d /\ (forall i, (i < N)%nat -> nearly (fun x mu => F x mu i) (fun x => L x i)
  (q i) eps d) /\ forall x x' mu mu' t, within d x -> within d x' -> Rabs mu <= d -> Rabs mu' <= d ->
  within t (minus x x') -> Rabs (mu - mu') <= t -> within ((m + 1 + Q) * t) (minus (F x mu) (F x' mu')).
Proof.
  intros HF HL Hq eps He.
  destruct (common_bound (fun i d => nearly (fun x mu => F x mu i) (fun x => L x i) (q i) (Rmin eps 1) d) N)
    as (d & Hd & H).
  - intros i d d' H Hd'; apply (nearly_down _ _ _ _ d); [exact H | lra].
  - intros i Hi; apply strict_nearly; [apply HF, Hi | apply Rmin_glb_lt; lra].
  - exists d; split; [exact Hd | split].
    + intros i Hi; apply (nearly_up _ _ _ (Rmin eps 1)); [apply H, Hi | apply Rmin_l].
    + intros x x' mu mu' t Hx Hx' Hmu Hmu' Ht Hmt i Hi; unfold minus at 1. pose proof (Rabs_nonneg _ _ Hmt) as Ht0.
      apply Rle_trans with ((m + 1 + Rabs (q i)) * t).
      * apply (nearly_Lipschitz (fun x mu => F x mu i) (fun x => L x i) (q i) d); trivial.
        -- apply (nearly_up _ _ _ (Rmin eps 1)); [apply H, Hi | apply Rmin_r].
        -- intros e v He0 Hv; apply HL; assumption.
      * apply Rmult_le_compat_r; [exact Ht0|]; specialize (Hq i Hi); lra.
Qed.
Lemma strict_compose G c p F (L : vec -> vec) q m : strict N G (dot c) p -> (forall i, (i < N)%nat ->
  strict N (fun x mu => F x mu i) (fun x => L x i) (q i)) -> 0 <= m -> (forall e x, 0 <= e -> within e x ->
  within (m * e) (L x)) -> strict N (fun x mu => G (F x mu) mu) (fun x => dot c (L x)) (dot c q + p).
Proof.
  intros HG HF Hm HL. destruct (dot_bound N c) as (mc & Hmc & Hc), (within_exists N q) as (Q & HQ & Hq).
  set (l := m + 1 + Q); assert (Hl : 1 <= l) by (unfold l; lra).
  pose proof (nearly_all F L q m Q HF HL Hq) as Hboth; change (m + 1 + Q) with l in Hboth.
  assert (HF0 : within 0 (F zero 0)) by (intros i Hi; rewrite (proj1 (HF i Hi)), Rabs_R0; lra).
  assert (HF0' : within 0 (minus (F zero 0) zero)) by (intros i Hi; unfold minus, zero at 2; rewrite Rminus_0_r;
    apply HF0, Hi).
  split.
  - destruct (strict_nearly _ _ _ 1 HG) as (d & Hd & H); [lra|].
    pose proof (H (F zero 0) zero 0 0 0) as E; rewrite (proj1 HG) in E.
    pose proof (Hc 0 (minus (F zero 0) zero) HF0') as E'; rewrite Rmult_0_r in E'.
    assert (E0 : Rabs (G (F zero 0) 0) <= 0); [|revert E0; unfold Rabs; destruct Rcase_abs; lra].
    replace (G (F zero 0) 0) with ((G (F zero 0) 0 - 0 - dot c (minus (F zero 0) zero) - (0 - 0) * p) + dot c
      (minus (F zero 0) zero)) by ring.
    replace 0 with (1 * 0 + 0) at 8 by ring; apply triangle2; [|exact E'].
    apply E; rewrite ?Rminus_0_r, ?Rabs_R0; try lra; try (apply within_zero; lra);
      [apply within_le with 0; [lra | exact HF0] | exact HF0'].
  - intros eps He; destruct (Hboth (eps / (2 * (mc + 1)))) as (dF & HdF & HnF & HlF).
    { apply Rdiv_lt_0_compat; lra. }
    destruct (strict_nearly _ _ _ (eps / (2 * l)) HG) as (dG & HdG & HnG); [apply Rdiv_lt_0_compat; lra|].
    exists (Rmin dF (dG / l)); split.
    { apply Rmin_glb_lt; [|apply Rdiv_lt_0_compat]; lra. }
    set (d := Rmin dF (dG / l)).
    assert (Hd : 0 < d /\ d <= dF /\ l * d <= dG).
    { assert (0 < dG / l) by (apply Rdiv_lt_0_compat; lra); unfold d.
      split; [apply Rmin_glb_lt; lra | split; [apply Rmin_l|]].
      apply (Rmult_le_reg_l (/ l)); [apply Rinv_0_lt_compat; lra|].
      replace (/ l * (l * Rmin dF (dG / l))) with (Rmin dF (dG / l)) by (field; lra). rewrite Rmult_comm;
        apply Rmin_r. }
    assert (HdG' : d <= dG).
    { apply Rle_trans with (l * d); [|apply Hd]; rewrite <- (Rmult_1_l d) at 1. apply Rmult_le_compat_r; lra. }
    assert (Hin : forall x mu, within d x -> Rabs mu <= d -> within dG (F x mu)).
    { intros x mu Hx Hmu i Hi; apply Rle_trans with (l * d); [|apply Hd].
      pose proof (HlF x zero mu 0 d) as E; replace (F x mu i) with (minus (F x mu) (F zero 0) i).
      - apply E; trivial; rewrite ?Rabs_R0, ?Rminus_0_r; try lra; try (apply within_zero; lra).
        + apply within_le with d; [lra | exact Hx].
        + intros j Hj; unfold minus, zero; rewrite Rminus_0_r; apply Hx, Hj.
      - unfold minus; rewrite (proj1 (HF i Hi)); ring. }
    intros x x' mu mu' t Hx Hx' Hmu Hmu' Ht Hmt; pose proof (Rabs_nonneg _ _ Hmt) as Ht0.
    assert (Hlt : t <= l * t) by (rewrite <- (Rmult_1_l t) at 1; apply Rmult_le_compat_r; assumption).
    set (D := minus (F x mu) (F x' mu')). set (E := comb 1 (-1) D (comb 1 (mu - mu') (L (minus x x')) q)).
    replace (G (F x mu) mu - G (F x' mu') mu' - dot c (L (minus x x')) - (mu - mu') * (dot c q + p))
      with ((G (F x mu) mu - G (F x' mu') mu' - dot c D - (mu - mu') * p) + dot c E) by (unfold E; rewrite !dot_comb;
      ring).
    replace (eps * t) with (eps / (2 * l) * (l * t) + eps / 2 * t) by (field; lra). apply triangle2.
    + apply HnG; try lra; try (apply Hin; assumption).
      apply HlF; trivial; try lra; apply within_le with d; trivial; lra.
    + apply Rle_trans with (mc * (eps / (2 * (mc + 1)) * t)).
      * apply Hc; intros i Hi; unfold E, comb, D, minus at 1.
        replace (1 * (F x mu i - F x' mu' i) + -1 * (1 * L (minus x x') i + (mu - mu') * q i))
          with (F x mu i - F x' mu' i - L (minus x x') i - (mu - mu') * q i) by ring.
        apply (HnF i Hi); trivial; try lra; apply within_le with d; trivial; lra.
      * replace (mc * (eps / (2 * (mc + 1)) * t)) with ((mc / (mc + 1)) * (eps / 2 * t)) by (field; lra).
        rewrite <- (Rmult_1_l (eps / 2 * t)) at 2; apply Rmult_le_compat_r; [apply Rmult_le_pos; lra|].
        apply (Rmult_le_reg_r (mc + 1)); [lra|]. replace (mc / (mc + 1) * (mc + 1)) with mc by (field; lra); lra.
Qed.
End Strict.

Section Iterates.
Variables (M : Map.t) (w : vec) (e : R).
Hypothesis HM : smooth M.
Hypothesis Hw : forall i, (i < N M)%nat -> w i = mult (N M) (A M) w i + phi M i.
Hypothesis He : e = dot (N M) (C M) w + eta M.
Notation N := (N M).
Notation within := (within N).
Notation dot := (dot N).
Notation power := (power M).

(** f^k( . , mu) *)
Definition fly (mu : R) (k : nat) : vec -> vec := Nat.iter k (fun x => f M x mu).

Lemma strict_fly k i : (i < N)%nat -> strict N (fun x mu => fly mu k x i) (fun x => power k x i) (w i - power k w i).
Proof.
  revert i; induction k as [|k IH]; intros i Hi.
  - split; [reflexivity|]; intros eps Heps; exists 1; split; [lra|].
    intros x x' mu mu' t _ _ _ _ _ Hmt; cbn; unfold minus.
    replace (x i - x' i - (x i - x' i) - (mu - mu') * (w i - w i)) with 0 by ring.
    rewrite Rabs_R0; apply Rmult_le_pos; [lra | exact (Rabs_nonneg _ _ Hmt)].
  - destruct (power_bound N (A M) k) as (m & Hm & Hpow).
    pose proof (strict_compose N (fun x mu => f M x mu i) (A M i) (phi M i) (fun x mu => fly mu k x) (power k)
      (minus w (power k w)) m (proj1 HM i Hi) IH) as H.
    replace (w i - power (S k) w i) with (dot (A M i) (minus w (power k w)) + phi M i).
    + apply H; [lra|]; intros e0 x; apply Hpow; lia.
    + rewrite dot_minus, (Hw i Hi); unfold mult. change (power (S k) w i) with (dot (A M i) (power k w)); ring.
Qed.
Lemma strict_height k : strict N (fun x mu => h M (fly mu k x) mu) (fun x => dot (C M) (power k x))
  (e - dot (C M) (power k w)).
Proof.
  destruct (power_bound N (A M) k) as (m & Hm & Hpow).
  pose proof (strict_compose N (h M) (C M) (eta M) (fun x mu => fly mu k x) (power k) (minus w (power k w)) m
    (proj1 (proj2 HM)) (strict_fly k)) as H.
  replace (e - dot (C M) (power k w)) with (dot (C M) (minus w (power k w)) + eta M).
  - apply H; [lra|]; intros e0 x; apply Hpow; lia.
  - rewrite dot_minus, He; ring.
Qed.

(** What remains of (19) for n_j = k after the part linear in x and y. *)
Definition rest1 (mu : R) (k : nat) (x : vec) (y : R) : vec := fun i =>
  fly mu k x i + kick M (fly mu k x) (Rabs y) mu i * y - power k x i - y * B M i.
Definition rest2 (mu : R) (k : nat) (x : vec) (y : R) : R :=
  dot (C M) (power k x) - h M (fly mu k x) mu - y * y.

Definition close_fly (n : nat) (eps d : R) : Prop := forall k x x' mu mu' t, (k <= n)%nat ->
  within d x -> within d x' -> Rabs mu <= d -> Rabs mu' <= d ->
  within t (minus x x') -> Rabs (mu - mu') <= t ->
  (forall i, (i < N)%nat -> Rabs (fly mu k x i - fly mu' k x' i - power k (minus x x') i
                                - (mu - mu') * (w i - power k w i)) <= eps * t) /\
  Rabs (h M (fly mu k x) mu - h M (fly mu' k x') mu' - dot (C M) (power k (minus x x'))
        - (mu - mu') * (e - dot (C M) (power k w))) <= eps * t.

Lemma close_fly_exists n eps : 0 < eps -> exists d, 0 < d /\ close_fly n eps d.
Proof.
  intros Heps.
  pose (P k d := (forall i, (i < N)%nat -> nearly N (fun x mu => fly mu k x i) (fun x => power k x i)
    (w i - power k w i) eps d) /\ nearly N (fun x mu => h M (fly mu k x) mu) (fun x => dot (C M) (power k x))
    (e - dot (C M) (power k w)) eps d).
  destruct (common_bound P (S n)) as (d & Hd & H).
  - intros k d d' [H1 H2] Hd'; split; [intros i Hi|]; apply nearly_down with d; trivial; try lra. apply H1, Hi.
  - intros k _.
    destruct (common_bound (fun i d => nearly N (fun x mu => fly mu k x i) (fun x => power k x i) (w i - power k w i)
      eps d) N) as (d1 & Hd1 & H1).
    + intros i d d' H Hd'; apply nearly_down with d; [exact H | lra].
    + intros i Hi; apply strict_nearly; [apply strict_fly, Hi | exact Heps].
    + destruct (strict_nearly N _ _ _ eps (strict_height k) Heps) as (d2 & Hd2 & H2).
      exists (Rmin d1 d2); split; [apply Rmin_glb_lt; assumption|]; split.
      * intros i Hi; apply nearly_down with d1; [apply H1, Hi | apply Rmin_l].
      * apply nearly_down with d2; [exact H2 | apply Rmin_r].
  - exists d; split; [exact Hd|]; intros k x x' mu mu' t Hk Hx Hx' Hmu Hmu' Ht Hmt.
    destruct (H k ltac:(lia)) as [H1 H2]; split; [intros i Hi; apply (H1 i Hi) | apply H2]; trivial.
Qed.
Lemma fly_zero k i : (i < N)%nat -> fly 0 k zero i = 0.
Proof. intros Hi; exact (proj1 (strict_fly k i Hi)). Qed.
Lemma height_zero k : h M (fly 0 k zero) 0 = 0. Proof. exact (proj1 (strict_height k)). Qed.
Lemma Lipschitz_fly n : exists l d, 1 <= l /\ 0 < d /\ forall k x x' mu mu' t, (k <= n)%nat -> within d x ->
  within d x' -> Rabs mu <= d -> Rabs mu' <= d -> within t (minus x x') -> Rabs (mu - mu') <= t ->
  within (l * t) (minus (fly mu k x) (fly mu' k x')) /\ Rabs (h M (fly mu k x) mu - h M (fly mu' k x') mu') <= l * t.
Proof.
  destruct (close_fly_exists n 1) as (d & Hd & H); [lra|].
  destruct (power_bound N (A M) n) as (m & Hm & Hpow), (within_exists N w) as (W & HW & Hwb).
  destruct (dot_bound N (C M)) as (mc & Hmc & Hc). assert (HmW : 0 <= m * W) by (apply Rmult_le_pos; lra).
  assert (Hmcm : 0 <= mc * m) by (apply Rmult_le_pos; lra).
  assert (HmcmW : 0 <= mc * (m * W)) by (apply Rmult_le_pos; lra). pose proof (Rabs_pos e) as Habs.
  exists (1 + (m + mc * m) + (W + m * W + (Rabs e + mc * (m * W)))), d. split; [lra | split; [exact Hd|]].
  intros k x x' mu mu' t Hk Hx Hx' Hmu Hmu' Ht Hmt; pose proof (Rabs_nonneg _ _ Hmt) as Ht0.
  destruct (H k x x' mu mu' t) as [H1 H2]; trivial. pose proof (Hpow k t _ Hk Ht0 Ht) as Hp.
  pose proof (Hpow k W w Hk HW Hwb) as Hpw.
  assert (Hbig : forall a c, a <= m + mc * m -> c <= W + m * W + (Rabs e + mc * (m * W)) -> 1 * t + a * t + t * c
    <= (1 + (m + mc * m) + (W + m * W + (Rabs e + mc * (m * W)))) * t).
  { intros a c Ha Hc'; rewrite (Rmult_comm t c), <- !Rmult_plus_distr_r. apply Rmult_le_compat_r; lra. }
  split.
  - intros i Hi; unfold minus at 1.
    replace (fly mu k x i - fly mu' k x' i) with ((fly mu k x i - fly mu' k x' i - power k (minus x x') i - (mu - mu')
      * (w i - power k w i)) + power k (minus x x') i + (mu - mu') * (w i - power k w i)) by ring.
    eapply Rle_trans; [|apply (Hbig m (W + m * W)); lra].
    apply triangle3; [apply H1, Hi | apply Hp, Hi | apply Rabs_mult_le; [exact Hmt|]].
    apply (within_minus N W (m * W) w (power k w) Hwb Hpw i Hi).
  - replace (h M (fly mu k x) mu - h M (fly mu' k x') mu')
      with ((h M (fly mu k x) mu - h M (fly mu' k x') mu' - dot (C M) (power k (minus x x')) - (mu - mu')
      * (e - dot (C M) (power k w))) + dot (C M) (power k (minus x x')) + (mu - mu') * (e - dot (C M) (power k w)))
      by ring.
    eapply Rle_trans; [|apply (Hbig (mc * m) (Rabs e + mc * (m * W))); lra].
    apply triangle3; [exact H2 | | apply Rabs_mult_le; [exact Hmt|]].
    + rewrite Rmult_assoc; apply Hc, Hp.
    + unfold Rminus; apply triangle2; [lra | rewrite Rabs_Ropp; apply Hc, Hpw].
Qed.

(** The impact term b y is nearly B y. *)
Lemma kick_close n eps : 0 < eps -> exists d, 0 < d /\ forall k x x' y y' mu mu' t, (k <= n)%nat -> within d x ->
  within d x' -> Rabs y <= d -> Rabs y' <= d -> Rabs mu <= d -> Rabs mu' <= d -> within t (minus x x') ->
  Rabs (y - y') <= t -> Rabs (mu - mu') <= t -> forall i, (i < N)%nat ->
  Rabs (kick M (fly mu k x) (Rabs y) mu i * y - kick M (fly mu' k x') (Rabs y') mu' i * y' - (y - y') * B M i) <= eps
  * t.
Proof.
  intros Heps; destruct (Lipschitz_fly n) as (l & dl & Hl & Hdl & Hfly).
  destruct (proj2 (proj2 HM) (eps / l)) as (db & Hdb & H); [apply Rdiv_lt_0_compat; lra|].
  set (d := Rmin dl (db / l)); assert (Hd : 0 < d /\ d <= dl /\ l * d <= db).
  { assert (H1 : 0 < db / l) by (apply Rdiv_lt_0_compat; lra).
    split; [apply Rmin_glb_lt; assumption|]; split; [apply Rmin_l|].
    pose proof (Rmin_r dl (db / l)) as H3; apply (Rmult_le_compat_l l) in H3; [|lra].
    replace (l * (db / l)) with db in H3 by (field; lra); exact H3. }
  exists d; split; [apply Hd|]; destruct Hd as (Hd0 & Hd1 & Hd2).
  intros k x x' y y' mu mu' t Hk Hx Hx' Hy Hy' Hmu Hmu' Ht Hyt Hmt i Hi.
  pose proof (Rabs_nonneg _ _ Hmt) as Ht0; assert (Hld : d <= l * d).
  { rewrite <- (Rmult_1_l d) at 1; apply Rmult_le_compat_r; lra. }
  assert (Hlt : t <= l * t) by (rewrite <- (Rmult_1_l t) at 1; apply Rmult_le_compat_r; assumption).
  assert (Hin : forall z m, within d z -> Rabs m <= d -> within db (fly m k z)).
  { intros z m Hz Hm j Hj; destruct (Hfly k z zero m 0 d) as [G _]; trivial;
      rewrite ?Rminus_0_r, ?Rabs_R0; try lra; try (apply within_zero; lra).
    - apply within_le with d; assumption.
    - intros s Hs; unfold minus, zero; rewrite Rminus_0_r; apply Hz, Hs.
    - specialize (G j Hj); unfold minus in G; rewrite fly_zero, Rminus_0_r in G by exact Hj; lra. }
  assert (Hzz : within (l * t) (minus (fly mu k x) (fly mu' k x')))
    by (apply (Hfly k x x' mu mu' t Hk); try lra; trivial; apply within_le with d; assumption).
  pose proof (Hin x mu Hx Hmu) as Z1; pose proof (Hin x' mu' Hx' Hmu') as Z2.
  set (z := fly mu k x) in *; set (z' := fly mu' k x') in *; clearbody z z'.
  (* one y at a time, from 0 *)
  assert (One : forall z y mu, within db z -> 0 <= y <= d -> Rabs mu <= d ->
    Rabs (kick M z y mu i * y - y * B M i) <= eps / l * y).
  { intros w0 s m Hw0 Hs Hm; pose proof (H w0 w0 s 0 m m s i Hi Hw0 Hw0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra))
      as G.
    rewrite Rmult_0_r, !Rminus_0_r, Rminus_eq_0, Rabs_R0 in G; apply G; try lra.
    - intros j _; unfold minus; rewrite Rminus_eq_0, Rabs_R0; lra.
    - rewrite Rabs_pos_eq; lra. }
  assert (E : eps / l * (l * t) = eps * t) by (field; lra).
  assert (El : eps / l <= eps) by (apply Rmult_le_reg_r with l; [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra;
    nra).
  pose proof (Rle_abs y); pose proof (Rle_abs y'); pose proof (Rle_abs (- y)) as NA; rewrite Rabs_Ropp in NA.
  pose proof (Rle_abs (- y')) as NA'; rewrite Rabs_Ropp in NA'.
  destruct (Rle_lt_dec 0 y) as [P|P], (Rle_lt_dec 0 y') as [P'|P'];
    rewrite ?(Rabs_pos_eq y), ?(Rabs_pos_eq y'), ?(Rabs_left y), ?(Rabs_left y') in * by assumption.
  - rewrite <- E; apply H; trivial; lra.
  - pose proof (One z y mu Z1 ltac:(lra) Hmu) as G; pose proof (One z' (- y') mu' Z2 ltac:(lra) Hmu') as G'.
    replace (_ - _ - _) with ((kick M z y mu i * y - y * B M i) + (kick M z' (- y') mu' i * - y' - - y' * B M i))
      by ring.
    rewrite (Rabs_pos_eq (y - y')) in Hyt by lra; eapply Rle_trans; [apply Rabs_triang|].
    apply Rle_trans with (eps / l * (y - y')); [lra|]; apply Rmult_le_compat; try lra.
    apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra].
  - pose proof (One z (- y) mu Z1 ltac:(lra) Hmu) as G; pose proof (One z' y' mu' Z2 ltac:(lra) Hmu') as G'.
    replace (_ - _ - _) with (- ((kick M z (- y) mu i * - y - - y * B M i) + (kick M z' y' mu' i * y' - y' * B M i)))
      by ring.
    rewrite (Rabs_left (y - y')) in Hyt by lra; rewrite Rabs_Ropp; eapply Rle_trans; [apply Rabs_triang|].
    apply Rle_trans with (eps / l * (y' - y)); [lra|]; apply Rmult_le_compat; try lra.
    apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra].
  - rewrite <- E; replace (_ - _ - _) with
      (- (kick M z (- y) mu i * - y - kick M z' (- y') mu' i * - y' - (- y - - y') * B M i)) by ring.
    rewrite Rabs_Ropp; apply H; trivial; try lra.
    replace (- y - - y') with (- (y - y')) by ring; rewrite Rabs_Ropp; lra.
Qed.

(** Everything that the fixed point argument needs, in a ball of radius d. *)
Definition remainder (n : nat) (eps d : R) : Prop := forall k x x' y y' mu mu' t, (k <= n)%nat ->
  within d x -> within d x' -> Rabs y <= d -> Rabs y' <= d -> Rabs mu <= d -> Rabs mu' <= d ->
  within t (minus x x') -> Rabs (y - y') <= t -> Rabs (mu - mu') <= t ->
  (forall i, (i < N)%nat -> Rabs (rest1 mu k x y i - rest1 mu' k x' y' i
                                  - (mu - mu') * (w i - power k w i)) <= eps * t) /\
  Rabs (rest2 mu k x y - rest2 mu' k x' y' + (mu - mu') * (e - dot (C M) (power k w))) <= eps * t /\
  Rabs (h M (fly mu k x) mu - h M (fly mu' k x') mu' - dot (C M) (power k (minus x x'))
        - (mu - mu') * (e - dot (C M) (power k w))) <= eps * t.

Lemma remainder_down n eps d d' : remainder n eps d -> d' <= d -> remainder n eps d'.
Proof.
  intros H Hd k x x' y y' mu mu' t Hk Hx Hx' Hy Hy' Hmu Hmu'.
  apply H; trivial; try lra; apply within_le with d'; assumption.
Qed.
Lemma remainder_exists n eps : 0 < eps -> exists d, 0 < d /\ remainder n eps d.
Proof.
  intros Heps; destruct (close_fly_exists n (eps / 2)) as (d1 & Hd1 & H1); [lra|].
  destruct (kick_close n (eps / 2)) as (d2 & Hd2 & H2); [lra|]. set (d := Rmin (Rmin d1 d2) (eps / 4)).
  assert (Hd : 0 < d /\ d <= d1 /\ d <= d2 /\ d <= eps / 4).
  { split; [repeat apply Rmin_glb_lt; lra|]; split; [|split; [|apply Rmin_r]]; (eapply Rle_trans; [apply Rmin_l|]);
      [apply Rmin_l | apply Rmin_r]. }
  exists d; split; [apply Hd|]; intros k x x' y y' mu mu' t Hk Hx Hx' Hy Hy' Hmu Hmu' Ht Hyt Hmt.
  pose proof (Rabs_nonneg _ _ Hmt) as Ht0.
  destruct (H1 k x x' mu mu' t) as [Hf Hh]; trivial; try lra; try (apply within_le with d; trivial; lra).
  assert (Hb := H2 k x x' y y' mu mu' t Hk). split; [|split].
  - intros i Hi; unfold rest1.
    replace (fly mu k x i + kick M (fly mu k x) (Rabs y) mu i * y - power k x i - y * B M i - (fly mu' k x' i + kick M
      (fly mu' k x') (Rabs y') mu' i * y' - power k x' i - y' * B M i) - (mu - mu') * (w i - power k w i))
      with ((fly mu k x i - fly mu' k x' i - power k (minus x x') i - (mu - mu') * (w i - power k w i))
      + (kick M (fly mu k x) (Rabs y) mu i * y - kick M (fly mu' k x') (Rabs y') mu' i * y' - (y - y') * B M i)).
    + replace (eps * t) with (eps / 2 * t + eps / 2 * t) by field.
      apply triangle2; [apply Hf, Hi | apply Hb; trivial; try lra; apply within_le with d; trivial; lra].
    + unfold StatementOrbits.power; rewrite power_minus; unfold minus; ring.
  - unfold rest2.
    replace (dot (C M) (power k x) - h M (fly mu k x) mu - y * y - (dot (C M) (power k x') - h M (fly mu' k x') mu' - y'
      * y') + (mu - mu') * (e - dot (C M) (power k w)))
      with (- (h M (fly mu k x) mu - h M (fly mu' k x') mu' - dot (C M) (power k (minus x x')) - (mu - mu')
      * (e - dot (C M) (power k w))) + - ((y - y') * (y + y'))).
    + replace (eps * t) with (eps / 2 * t + t * (eps / 2)) by field.
      apply triangle2; rewrite Rabs_Ropp; [exact Hh|]; apply Rabs_mult_le; [exact Hyt|].
      apply Rle_trans with (d + d); [apply triangle2; assumption | lra].
    + unfold StatementOrbits.power; rewrite power_minus, dot_minus; ring.
  - apply Rle_trans with (eps / 2 * t); [exact Hh | apply Rmult_le_compat_r; lra].
Qed.
End Iterates.
