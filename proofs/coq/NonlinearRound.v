(** * Once around with other impacts: k stages, from arc to arc, make a strictly differentiable map; motions
      near the orbit are the orbits of the grazing map that it makes *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOrbits StatementUnstable StatementWords Headline OrbitVectors Contraction
  Derivatives.
From Grazing Require Import NonlinearGronwall NonlinearFlow NonlinearTouch NonlinearSpeed NonlinearKick NonlinearMap.
From Grazing Require Import NonlinearFlights NonlinearWords NonlinearArc NonlinearTube NonlinearPoint NonlinearStage
  NonlinearChange NonlinearCompose.
Open Scope R_scope.

Section Round.
(** Arc m begins at its own time rho and ends at e m, at an impact where imp m, at a change of chart elsewhere; after k
    arcs all repeats itself. *)
Variables (k : nat) (F : nat -> force) (kk cc ll : nat -> R -> R) (e : nat -> R) (rho rho1 r1 : R) (imp : nat -> bool).
Variables (law : nat -> R -> R -> R -> R) (jy : nat -> R -> R -> R) (Rm Rt Rv Jm Jy : nat -> R).
Hypothesis Hk : (1 <= k)%nat.
Hypothesis HF : forall m, F (k + m)%nat = F m /\ e (k + m)%nat = e m /\ law (k + m)%nat = law m /\
  kk (k + m)%nat = kk m /\ cc (k + m)%nat = cc m /\ ll (k + m)%nat = ll m.
Hypothesis HF' : forall m, imp (k + m)%nat = imp m /\ jy (k + m)%nat = jy m /\
  (imp m = true -> forall mu y, jy m mu y = 0).
Hypothesis HA : forall m, @along_arc (F m) (kk m) (cc m) (ll m).
Hypothesis He : forall m, 0 < rho /\ 0 <= e m - rho /\ e m + rho <= @T (F m).
Hypothesis HT' : forall m, rho + rho <= @T (F m).
Hypothesis Hex : forall m, imp m = true -> @y0 (F m) (e m) = 0 /\ @v0 (F m) (e m) < 0.
Hypothesis Hen : forall m, @y0 (F (S m)) rho = jy m 0 (@y0 (F m) (e m)) /\
  @v0 (F (S m)) rho = law m 0 0 (@v0 (F m) (e m)).
Hypothesis Hjy : forall m eps, 0 < eps -> exists d, 0 < d /\ forall mu y mu' y', Rabs mu <= d -> Rabs mu' <= d ->
  Rabs (y - @y0 (F m) (e m)) <= d -> Rabs (y' - @y0 (F m) (e m)) <= d -> Rabs (jy m mu y - jy m mu' y' -
  (Jm m * (mu - mu') + Jy m * (y - y'))) <= eps * (Rabs (mu - mu') + Rabs (y - y')).
Hypothesis Hlaw : forall m eps, 0 < eps -> exists d, 0 < d /\ forall mu s v mu' s' v', Rabs mu <= d -> Rabs s <= d ->
  Rabs (v - @v0 (F m) (e m)) <= d -> Rabs mu' <= d -> Rabs s' <= d -> Rabs (v' - @v0 (F m) (e m)) <= d ->
  Rabs (law m mu s v - law m mu' s' v' - (Rm m * (mu - mu') + Rt m * (s - s') + Rv m * (v - v'))) <=
  eps * (Rabs (mu - mu') + Rabs (s - s') + Rabs (v - v')).
Hypothesis Hr1 : 0 < r1 /\ 0 < rho1 <= rho /\ forall m, imp m = true -> 2 * (@M (F m) * r1) < - @v0 (F m) (e m) * rho1.
Hypothesis Hsteep : forall m, imp m = true -> forall x mu s, within 2 r1 x -> Rabs mu <= r1 -> Rabs (s - e m) <= rho1 ->
  Rabs (@V (F m) x mu s - @v0 (F m) (e m)) <= - @v0 (F m) (e m) / 2.

Definition go (m : nat) : vec -> R -> vec := if imp m then carry (F m) (F (S m)) (e m) rho rho1 (law m)
  else pass (F m) (F (S m)) (e m) rho (jy m) (law m).
Definition leap (m : nat) : R -> (R -> R) -> (R -> R) -> (R -> R) -> (R -> R) -> Prop := if imp m
  then jump (F m) (F (S m)) (e m) rho (Rm m) (Rt m) (Rv m) else turnover (e m) rho (Jm m) (Jy m) (Rm m) (Rv m).
Fixpoint st (m : nat) (x : vec) (mu : R) : vec := match m with O => x | S m => go m (st m x mu) mu end.
Definition chain (n : nat) (m : R) (z w : nat -> R -> R) : Prop := (forall j, (j <= n)%nat -> solves (kk j) (cc j) (ll
  j) m (z j) (w j)) /\ forall j, (j < n)%nat -> leap j m (z j) (w j) (z (S j)) (w (S j)).
Lemma entry m : imp m = true -> @y0 (F (S m)) rho = 0 /\ @v0 (F (S m)) rho = law m 0 0 (@v0 (F m) (e m)).
Proof. intros I; destruct (Hen m) as [E1 E2], (HF' m) as (_ & _ & Z); rewrite (Z I) in E1; auto. Qed.
Definition Hr1' m (I : imp m = true) := conj (proj1 Hr1) (conj (proj1 (proj2 Hr1)) (proj2 (proj2 Hr1) m I)).
Lemma go_matrix m : exists A phi, smooth_map (go m) A phi /\ forall h z w z' w', solves (kk m) (cc m) (ll m) h z w ->
  solves (kk (S m)) (cc (S m)) (ll (S m)) h z' w' -> leap m h z w z' w' ->
  forall i, (i < 2)%nat -> pair (z' 0) (w' 0) i = applied A phi (pair (z 0) (w 0)) h i.
Proof.
  unfold go, leap, smooth_map; destruct (imp m) eqn:I.
  - destruct (carry_matrix (F m) (F (S m)) (kk m) (cc m) (ll m) (kk (S m)) (cc (S m)) (ll (S m)) (e m) rho r1 rho1 (Rm m)
      (Rt m) (Rv m) (law m) (HA m) (HA (S m)) (He m) (HT' (S m)) (Hex m I) (entry m I) (Hlaw m) (Hr1' m I) (Hsteep m I))
      as (A & phi & H1 & H2). exists A, phi; split; [exact H1|]; intros h z w z' w' Z Z' J [|[|i]] Hi; [| |lia]; apply
      (H2 h z w z' w' Z Z' J).
  - destruct (pass_matrix (F m) (F (S m)) (kk m) (cc m) (ll m) (kk (S m)) (cc (S m)) (ll (S m)) (e m) rho (Jm m) (Jy m)
      (Rm m) (Rt m) (Rv m) (jy m) (law m) (HA m) (HA (S m)) (He m) (HT' (S m)) (Hen m) (Hjy m) (Hlaw m)) as (A & phi &
      H1 & H2). exists A, phi; split; [exact H1|]; intros h z w z' w' Z Z' J [|[|i]] Hi; [| |lia]; apply (H2 h z w z' w'
      Z Z' J).
Qed.
Lemma st_matrix n : exists A phi, smooth_map (st n) A phi /\ forall h z w, chain n h z w -> forall i, (i < 2)%nat ->
  pair (z n 0) (w n 0) i = applied A phi (pair (z 0%nat 0) (w 0%nat 0)) h i.
Proof.
  induction n as [|n (A1 & phi1 & S1 & H1)].
  - exists (fun i j => if Nat.eq_dec i j then 1 else 0), zero; split.
    + intros i Hi; split; [reflexivity|]; intros eps Hp; exists 1; split; [lra|]; intros x x' mu mu' t _ _ _ _ _ Hm;
        assert (0 <= t) by (pose proof (Rabs_pos (mu - mu')); lra). destruct i as [|[|i]]; [| |lia]; cbn; unfold minus,
        zero; match goal with |- Rabs ?u <= _ => replace u with 0 by ring end; rewrite Rabs_R0; apply Rmult_le_pos; lra.
    + intros h z w _ i Hi; destruct i as [|[|i]]; [| |lia]; cbn; unfold applied, zero; cbn; ring.
  - destruct (go_matrix n) as (A2 & phi2 & S2 & H2); exists (times A2 A1), (applied A2 phi2 phi1 1); split; [exact
      (smooth_compose (st n) A1 phi1 (go n) A2 phi2 S1 S2)|].
    intros h z w [C1 C2] i Hi; rewrite (H2 h (z n) (w n) (z (S n)) (w (S n)) (C1 n ltac:(lia)) (C1 (S n) ltac:(lia)) (C2
      n ltac:(lia)) i Hi). assert (C3 : chain n h z w) by (split; intros j Hj; [apply C1 | apply C2]; lia). assert (E :=
          H1 h
      z w C3); unfold applied, times. rewrite (E 0%nat ltac:(lia)), (E 1%nat ltac:(lia)); unfold applied; cbn; ring.
Qed.
Lemma chain_exists n h z w : solves (kk 0%nat) (cc 0%nat) (ll 0%nat) h z w -> exists z' w', chain n h z' w' /\ z' 0%nat
  = z /\ w' 0%nat = w.
Proof.
  intros Z; induction n as [|n (z1 & w1 & [C1 C2] & <- & <-)].
  - exists (fun _ => z), (fun _ => w); split; [|auto]; split; [|lia]; intros j Hj; replace j with 0%nat by lia; exact Z.
  - assert (L : exists z2 w2, solves (kk (S n)) (cc (S n)) (ll (S n)) h z2 w2 /\ leap n h (z1 n) (w1 n) z2 w2).
    { unfold leap; destruct (imp n) eqn:I; [exact (jump_exists (F n) (F (S n)) (kk (S n)) (cc (S n)) (ll (S n)) (e n) rho
        (Rm n) (Rt n) (Rv n) (HA (S n)) (Hex n I) h (z1 n) (w1 n)) | apply (turnover_exists (F (S n)) _ _ _ _ _ _ _ _ _
        (HA (S n)))]. }
    destruct L as (z2 & w2 & Z2 & J).
    set (up := fun (u : nat -> R -> R) u2 j => if Nat.eq_dec j (S n) then u2 else u j).
    assert (U1 : forall u u2 j, (j <= n)%nat -> up u u2 j = u j) by (intros u u2 j Hj; unfold up; destruct Nat.eq_dec;
      [lia | reflexivity]). assert (U2 : forall u u2, up u u2 (S n) = u2) by (intros u u2; unfold up; destruct
      Nat.eq_dec; [reflexivity | lia]).
    exists (up z1 z2), (up w1 w2); rewrite !(U1 _ _ 0%nat) by lia; split; [|auto]; split; intros j Hj.
    + destruct (Nat.eq_dec j (S n)) as [->|N]; [rewrite !U2; exact Z2 | rewrite !U1 by lia; apply C1; lia].
    + destruct (Nat.eq_dec j n) as [->|N]; [rewrite !U2, !U1 by lia; exact J | rewrite !U1 by lia; apply C2; lia].
Qed.
(** One bound for all stages. *)
Lemma repeated (P : nat -> Prop) : (forall m, P m -> P (k + m)%nat) -> (forall m, (m < k)%nat -> P m) -> forall m, P m.
Proof.
  intros H H0 m; induction m as [m IH] using (well_founded_induction lt_wf); destruct (le_lt_dec k m) as [O|O]; [|apply
    H0, O]. replace m with (k + (m - k))%nat by lia; apply H, IH; lia.
Qed.
Lemma least (P : nat -> R -> Prop) n : (forall m d d', P m d -> 0 < d' <= d -> P m d') -> (forall m, (m < n)%nat ->
  exists d, 0 < d /\ P m d) -> exists d, 0 < d /\ forall m, (m < n)%nat -> P m d.
Proof.
  intros Down H; induction n as [|n IH]; [exists 1; split; [lra | lia]|].
  destruct IH as (d1 & D1 & H1); [intros m Hm; apply H; lia|]; destruct (H n ltac:(lia)) as (d2 & D2 & H2), (two_least
    d1 d2 D1 D2) as (d & Hd & L1 & L2); exists d; split; [exact Hd|]; intros m Hm.
  destruct (Nat.eq_dec m n) as [->|N]; [apply (Down n d2); [exact H2 | lra] | apply (Down m d1); [apply H1; lia | lra]].
Qed.
Lemma round_exists : exists rf Kf A phi, 0 < rf /\ (forall m, 1 <= @M (F m) <= Kf) /\ smooth_map (st k) A phi /\
  (forall h z w, chain k h z w -> forall i, (i < 2)%nat -> pair (z k 0) (w k 0) i = applied A phi (pair (z 0%nat 0) (w
  0%nat 0)) h i) /\ (forall x x' mu mu' t, small rf x mu -> small rf x' mu' -> within 2 t (minus x x') -> Rabs (mu -
      mu')
  <= t -> within 2 (Kf * t) (minus (st k x mu) (st k x' mu'))) /\
  forall j s x mu, (j <= k)%nat -> s <= rf -> small s x mu -> within 2 (Kf * s) (st j x mu).
Proof.
  destruct (st_matrix k) as (A & phi & HS & HC), (smooth_lip _ _ _ HS) as (d0 & C0 & Hd0 & HC0 & Lip).
  destruct (least (fun m d => @M (F m) <= / d) k) as (d1 & D1 & H1).
  { intros m d d' H Hd; apply Rle_trans with (1 := H), Rinv_le_contravar; lra. }
  { intros m _; pose proof (@M_large (F m)); exists (/ @M (F m)); split; [apply Rinv_0_lt_compat; lra | rewrite
      Rinv_inv; lra]. }
  destruct (least (fun m d => forall s x mu, s <= d -> small s x mu -> within 2 (/ d * s) (st m x mu)) (S k)) as (d2 &
    D2 & H2).
  { intros m d d' H Hd s x mu Hs Sx; specialize (H s x mu ltac:(lra) Sx); intros i Hi; specialize (H i Hi); assert (0 <=
      s) by (destruct Sx as [_ Q]; pose proof (Rabs_pos mu); lra). assert (/ d * s <= / d' * s) by (apply
      Rmult_le_compat_r; [lra | apply Rinv_le_contravar; lra]); lra. }
  { intros m _; destruct (st_matrix m) as (B & psi & HB & _), (smooth_lip _ _ _ HB) as (d & C & Hd & HC' & L0).
    destruct (two_least d (/ C) Hd ltac:(apply Rinv_0_lt_compat; lra)) as (q & Hq & Q1 & Q2); exists q; split; [exact
        Hq|].
    intros s x mu Hs [Sx Sm]; assert (0 <= s) by (pose proof (Rabs_pos mu); lra).
    assert (CI : C * s <= / q * s) by (apply Rmult_le_compat_r; [lra|]; rewrite <- (Rinv_inv C); apply
      Rinv_le_contravar; lra).
    pose proof (L0 x zero mu 0 s ltac:(intros i Hi; specialize (Sx i Hi); lra) ltac:(intros i _; unfold zero; rewrite
      Rabs_R0; lra) ltac:(lra) ltac:(rewrite Rabs_R0; lra) ltac:(intros i Hi; unfold minus, zero; rewrite Rminus_0_r;
      apply Sx, Hi) ltac:(rewrite Rminus_0_r; exact Sm)) as Q. intros i Hi; specialize (Q i Hi); unfold minus in Q; pose
      proof (proj1 (HB i Hi)) as E; cbv beta in E; rewrite E, Rminus_0_r in Q; lra. }
  destruct (two_least d0 d2 Hd0 D2) as (rf & Hrf & L1 & L2); exists rf, (C0 + / d1 + / d2), A, phi; pose proof
    (Rinv_0_lt_compat d1 D1); pose proof (Rinv_0_lt_compat d2 D2); split; [exact Hrf | split; [|split; [exact HS |
    split; [exact HC | split]]]].
  - intros m; split; [apply M_large|]; apply Rle_trans with (/ d1); [|lra]; revert m; apply (repeated (fun m => @M (F m)
      <= / d1)); [intros m; rewrite (proj1 (HF m)); auto | exact H1].
  - intros x x' mu mu' t [Sx Sm] [Sx' Sm'] Ht Htm; assert (0 <= t) by (pose proof (Rabs_pos (mu - mu')); lra).
    intros i Hi; eapply Rle_trans; [apply (Lip x x' mu mu' t); trivial; try lra; intros j Hj; [specialize (Sx j Hj) |
      specialize (Sx' j Hj)]; lra | apply Rmult_le_compat_r; lra].
  - intros j s x mu Hj Hs Sx; assert (0 <= s) by (destruct Sx as [_ Q]; pose proof (Rabs_pos mu); lra). intros i Hi;
      eapply Rle_trans; [apply (H2 j ltac:(lia) s x mu ltac:(lra) Sx i Hi) | apply Rmult_le_compat_r; lra].
Qed.

(** The map once around, for all states. *)
Variables (rf Kf : R) (A : nat -> vec) (phi : vec).
Hypothesis Hrf : 0 < rf.
Hypothesis HKf : forall m, 1 <= @M (F m) <= Kf.
Hypothesis HS : smooth_map (st k) A phi.
Hypothesis HC : forall h z w, chain k h z w -> forall i, (i < 2)%nat -> pair (z k 0) (w k 0) i = applied A phi (pair (z
  0%nat 0) (w 0%nat 0)) h i.
Hypothesis Hlip : forall x x' mu mu' t, small rf x mu -> small rf x' mu' -> within 2 t (minus x x') -> Rabs (mu - mu')
    <= t
  -> within 2 (Kf * t) (minus (st k x mu) (st k x' mu')).
Hypothesis Hsize : forall j s x mu, (j <= k)%nat -> s <= rf -> small s x mu -> within 2 (Kf * s) (st j x mu).
Definition tr (x : vec) : vec := pair (x 0%nat) (x 1%nat).
Definition once (x : vec) mu : vec := st k (pair (cl rf (x 0%nat)) (cl rf (x 1%nat))) (cl rf mu).
Lemma once_is x mu : small rf x mu -> once x mu = st k (tr x) mu.
Proof. intros [Hx Hm]; unfold once, tr; rewrite !cl_id by (first [exact Hrf | exact Hm | apply Hx; lia]);
  reflexivity. Qed.
Lemma once_lip x x' mu mu' t : within 2 t (minus x x') -> Rabs (mu - mu') <= t -> within 2 (Kf * t) (minus (once x mu)
  (once x' mu')).
Proof.
  intros Ht Hm; apply Hlip.
  - split; [|apply cl_in, Hrf]; intros i Hi; destruct i as [|[|i]]; [apply cl_in, Hrf | apply cl_in, Hrf | lia].
  - split; [|apply cl_in, Hrf]; intros i Hi; destruct i as [|[|i]]; [apply cl_in, Hrf | apply cl_in, Hrf | lia].
  - intros i Hi; destruct i as [|[|i]]; [| |lia]; unfold minus; cbn; (eapply Rle_trans; [apply cl_lip, Hrf | apply Ht;
      lia]).
  - eapply Rle_trans; [apply cl_lip, Hrf | exact Hm].
Qed.
Lemma once_strict : smooth_map once A phi.
Proof.
  intros i Hi; destruct (HS i Hi) as [E H]; split.
  - rewrite once_is; [|split; [intros j _; unfold zero|]; rewrite Rabs_R0; lra]. apply (smooth_zero (st k) A phi _ HS);
      [|exact Hi]; intros j Hj; unfold tr, zero; destruct j as [|[|j]]; [reflexivity | reflexivity | lia].
  - intros eps Hp; destruct (H eps Hp) as (d1 & Hd1 & Q), (two_least d1 rf Hd1 Hrf) as (d & Hd & L1 & L2); exists d;
      split; [exact Hd|]; intros x x' mu mu' t Hx Hx' Hm Hm' Ht Htm.
    rewrite !once_is by (split; [intros j Hj; first [specialize (Hx j Hj) | specialize (Hx' j Hj)]; first [pose proof
      (Hx j Hj) | idtac]; try (pose proof (Hx' j Hj)); lra | lra]).
    assert (W : forall y, within 2 d y -> within 2 d1 (tr y)) by (intros y Hy j Hj; destruct j as [|[|j]]; [apply
      Rle_trans with (1 := Hy 0%nat ltac:(lia)); lra | apply Rle_trans with (1 := Hy 1%nat ltac:(lia)); lra | lia]).
    apply (Q (tr x) (tr x') mu mu' t (W x Hx) (W x' Hx') ltac:(lra) ltac:(lra)); [|exact Htm].
    intros j Hj; destruct j as [|[|j]]; [exact (Ht 0%nat ltac:(lia)) | exact (Ht 1%nat ltac:(lia)) | lia].
Qed.
Lemma go_period m : go (k + m) = go m.
Proof.
  unfold go; destruct (HF m) as (E1 & E2 & E3 & _), (HF (S m)) as (E4 & _), (HF' m) as (E5 & E6 & _); rewrite
    Nat.add_succ_r in E4; rewrite E1, E2, E3, E4, E5, E6; reflexivity.
Qed.
Lemma periods (X : Type) (f : nat -> X) : (forall m, f (k + m)%nat = f m) -> forall q m, f (k * q + m)%nat = f m.
Proof.
  intros H q m; induction q as [|q IH]; [rewrite Nat.mul_0_r; reflexivity|]; replace (k * S q + m)%nat with (k + (k * q
    + m))%nat by lia; rewrite H; exact IH.
Qed.
Lemma st_split q m x mu : st (k * q + m) x mu = st m (st (k * q) x mu) mu.
Proof.
  induction m as [|m IH]; [rewrite Nat.add_0_r; reflexivity|]; rewrite Nat.add_succ_r; cbn [st]; rewrite IH, (periods _
    go go_period); reflexivity.
Qed.
Lemma tr_st m x mu : (1 <= m)%nat -> tr (st m x mu) = st m x mu.
Proof. destruct m as [|m]; [lia|]; intros _; apply FunctionalExtensionality.functional_extensionality; cbn [st]; unfold
  go; intros [|[|i]]; destruct (imp m); reflexivity. Qed.

(** ** Motions

    The touch is in arc 0. Away from contacts the arcs are at least ymin above the stop. *)
Definition first : force := F 0%nat.
Local Existing Instance first.
Context {To : touch first} {Wo : near To} {Io : impact To}.
Definition turned : turn first := @Build_turn first once Kf A phi (proj2 (HKf 0%nat)) once_lip once_strict.
Local Existing Instance turned.
Variables (ymin wmin sg : R).
Definition bare (m : nat) (s : R) : Prop := rho <= s <= e m /\ (imp m = true -> s <= e m - rho1) /\
  match m with O => rho + rho1 <= s | S m => imp m = true -> rho + rho1 <= s end.
Hypothesis Hym : 0 < ymin /\ forall m s, bare m s -> (forall q, m = (k * q)%nat -> r0 <= Rabs (s - tG)) ->
  ymin <= @y0 (F m) s.
Hypothesis Hwm : 0 < wmin /\ forall m, imp m = true -> wmin <= - @v0 (F m) (e m).
Hypothesis Hsteep' : forall m, imp m = true -> forall x mu s, within 2 r1 x -> Rabs mu <= r1 -> Rabs (s - rho) <= rho1 ->
  0 < @V (F (S m)) x mu s.
Hypothesis Hsep : rho + rho1 < tG - r0 /\ tG + r0 < e 0%nat - rho1 /\ forall m, rho + rho1 < e m - rho1.
Fixpoint base (m : nat) : R := match m with O => sg | S m => base m + e m - rho end.
Definition P := base k - sg.
Definition off (N : Z -> Z) (i : Z) (m : nat) : R := base m + P * IZR (N i).
Definition last (N : Z -> Z) (i j : Z) : nat := (k * Z.to_nat (N j - N i))%nat.
Lemma F_periods q m : F (k * q + m)%nat = F m /\ e (k * q + m)%nat = e m.
Proof. split; [apply (periods _ F) | apply (periods _ e)]; intros j; apply HF. Qed.
Lemma base_periods q m : base (k * q + m)%nat = P * INR q + base m.
Proof.
  assert (One : forall m, base (k + m)%nat = P + base m).
  { intros j; induction j as [|j IH]; [rewrite Nat.add_0_r; cbn; unfold P; ring|]; rewrite Nat.add_succ_r; cbn [base];
      rewrite IH; destruct (HF j) as (_ & -> & _); ring. }
  induction q as [|q IH]; [rewrite Nat.mul_0_r; cbn; ring|]; replace (k * S q + m)%nat with (k + (k * q + m))%nat by
    lia; rewrite One, IH, S_INR; ring.
Qed.
Definition arc_is (mu d : R) (m : nat) (lo hi : R) (p q : R -> R) : Prop := lo < hi /\ (forall s, lo <= s <= hi -> moves
  (@a (F m)) mu p q s /\ Rabs (p s - @y0 (F m) s) <= d /\ Rabs (q s - @v0 (F m) s) <= d) /\
  forall s, lo < s < hi -> 0 < p s.
(** From an impact near the touch to the next, in k arcs for each period; al and om are the times, of the
    arcs, at which they begin and end. *)
Record run mu d (N : Z -> Z) (t : Z -> R) (y v : Z -> R -> R) (i j : Z) (al om : nat -> R) (p q : nat -> R -> R) : Prop
    :=
  { run_from : al 0%nat = t i - (sg + P * IZR (N i));
  run_to : om (last N i j) = t j - (sg + P * IZR (N j));
  run_next : forall m, (m < last N i j)%nat -> al (S m) = om m - e m + rho;
  run_near : Rabs (al 0%nat - tG) <= d /\ Rabs (om (last N i j) - tG) <= d /\ forall m, (m < last N i j)%nat -> Rabs (om
    m - e m) <= d;
  run_arc : forall m, (m <= last N i j)%nat -> arc_is mu d m (al m) (om m) (p m) (q m);
  run_ends : forall m, (m <= last N i j)%nat -> if Nat.eq_dec m (last N i j) then p m (om m) = 0 /\ q m (om m) < 0 else
    if imp m then p m (om m) = 0 /\ q m (om m) < 0 else om m = e m;
  run_start : p 0%nat (al 0%nat) = 0;
  run_law : forall m, (m < last N i j)%nat -> p (S m) (al (S m)) = jy m mu (p m (om m)) /\
    q (S m) (al (S m)) = law m mu (om m - e m) (q m (om m));
  run_path : forall m s, (m <= last N i j)%nat -> al m <= s <= om m -> (s = om m -> m = last N i j) ->
    y i (off N i m + s) = p m s /\ v i (off N i m + s) = q m s;
  run_back : v j (t j) = rebound mu (om (last N i j)) (q (last N i j) (om (last N i j))) }.
Definition Leg mu d N t y v i j : Prop := exists al om p q, run mu d N t y v i j al om p q.
(** The states at the beginnings of the arcs, and when these end; for states that are not small, some time
    about there. *)
Definition X (x : vec) mu (m : nat) : vec := st m (tr x) mu.
Definition ends (x : vec) mu (m : nat) : R := if imp m then cross (F m) (e m) rho1 (X x mu m) mu else e m.
Definition until (x : vec) mu (m : nat) : R := Rmax (ends x mu m) (e m - rho1).
Lemma ends_imp x mu m : imp m = true -> ends x mu m = cross (F m) (e m) rho1 (X x mu m) mu.
Proof. intros I; unfold ends; rewrite I; reflexivity. Qed.
Lemma ends_cut x mu m : imp m = false -> ends x mu m = e m.
Proof. intros I; unfold ends; rewrite I; reflexivity. Qed.
Lemma entered x mu m : let s := ends x mu m - e m + rho in @Y (F (S m)) (X x mu (S m)) mu s = jy m mu (@Y (F m) (X x mu
  m) mu (ends x mu m)) /\ @V (F (S m)) (X x mu (S m)) mu s = law m mu (ends x mu m - e m) (@V (F m) (X x mu m) mu (ends
  x mu m)).
Proof.
  unfold ends, X; cbn [st]; unfold go; destruct (imp m) eqn:I.
  - destruct (HF' m) as (_ & _ & Z); rewrite (Z I); apply (carry_flow (F m) (F (S m)) (e m) rho rho1 (law m)).
  - cbv zeta; rewrite Rminus_eq_0, Rplus_0_l; apply origin_flow.
Qed.
Definition at_arc (n : Z -> nat) (N : Z -> Z) mu (x : Z -> vec) (i : Z) (u : R) (m : nat) : Prop := (m <= k * n i)%nat
  /\ (forall m', (m' < m)%nat -> off N i m' + until (x i) mu m' <= u) /\ ((m < k * n i)%nat -> u < off N i m + until (x
      i) mu m).
Definition Pl mu n N x i u : R := the (fun r => exists m, at_arc n N mu x i u m /\ r = @Y (F m) (X (x i) mu m) mu (u -
  off N i m)).
Definition Vl mu n N x i u : R := the (fun r => exists m, at_arc n N mu x i u m /\ r = @V (F m) (X (x i) mu m) mu (u -
  off N i m)).
Lemma at_one n N mu x i u m m' : at_arc n N mu x i u m -> at_arc n N mu x i u m' -> m = m'.
Proof.
  intros (A1 & A2 & A3) (B1 & B2 & B3); destruct (lt_eq_lt_dec m m') as [[O|O]|O]; [|exact O|].
  - specialize (B2 m O); specialize (A3 ltac:(lia)); lra.
  - specialize (A2 m' O); specialize (B3 ltac:(lia)); lra.
Qed.
Lemma placed n N mu x i u m : at_arc n N mu x i u m -> Pl mu n N x i u = @Y (F m) (X (x i) mu m) mu (u - off N i m) /\
  Vl mu n N x i u = @V (F m) (X (x i) mu m) mu (u - off N i m).
Proof.
  intros H; split; (apply the_spec; [exists m; auto|]; intros r (m' & H' & ->); rewrite (at_one _ _ _ _ _ _ _ _ H H');
    reflexivity).
Qed.
(** Which arc a time is in. *)
Lemma times_grow K (al om : nat -> R) N i : (forall m, (m < K)%nat -> al (S m) = om m - e m + rho) -> (forall m, (m <=
    K)%nat
  -> al m <= om m) -> forall m m', (m <= K)%nat -> (m' < m)%nat -> off N i m' + om m' <= off N i m + al m.
Proof.
  intros Hn Hl m m' Hm O; assert (One : forall j, (j < K)%nat -> off N i j + om j = off N i (S j) + al (S j)) by (intros
    j Hj; unfold off; cbn [base]; rewrite (Hn j Hj); ring).
  induction m as [|m IH]; [lia|]; rewrite <- (One m ltac:(lia)). destruct (Nat.eq_dec m' m) as [->|Ne]; [lra|].
  specialize (IH ltac:(lia) ltac:(lia)); specialize (Hl m ltac:(lia)); lra.
Qed.
Lemma find_arc K (al om : nat -> R) N i u : (forall m, (m < K)%nat -> al (S m) = om m - e m + rho) -> off N i 0 + al
  0%nat <= u <= off N i K + om K -> exists m, (m <= K)%nat /\ al m <= u - off N i m <= om m /\ (u - off N i m = om m ->
      m = K).
Proof.
  intros Hn [U0 U1]; assert (H : forall j, (j <= K)%nat -> off N i j + al j <= u \/ exists m, (m <= K)%nat /\ al m <= u
    - off N i m <= om m /\ (u - off N i m = om m -> m = K)).
  { intros j Hj; induction j as [|j IH]; [left; exact U0|]; destruct (IH ltac:(lia)) as [A'|A']; [|right; exact A'].
    destruct (Rle_lt_dec (off N i (S j) + al (S j)) u) as [O|O]; [left; exact O|]; right; exists j; unfold off in *; cbn
      [base] in O; rewrite (Hn j ltac:(lia)) in O; split; [lia | split; lra]. }
  destruct (H K (le_n K)) as [A'|A']; [|exact A']; exists K; split; [apply le_n | split; [lra | auto]].
Qed.

Section Sized.
Variables (n_max : nat) (dd mu : R) (n : Z -> nat) (N : Z -> Z) (D : R).
Notation far := (far n_max).
Definition Good : Prop := far * dd <= rf /\ Kf * (far * dd) <= r1 /\ Kf * (Kf * (far * dd)) <= D /\ 2 * (Kf * (Kf * (far
  * dd))) <= wmin * D /\ Kf * (Kf * (far * dd)) < ymin /\ D <= rho1.
Hypothesis HW : word n_max n N.
Hypothesis HZ : sized n_max dd D.
Hypothesis HG : Good.
Hypothesis Hmu : Rabs mu <= dd.
Let Hn := proj1 HW. Let HN := proj2 HW. Let S0 := proj1 HZ. Let S1 := proj1 (proj2 HZ).
Let S2 := proj1 (proj2 (proj2 HZ)). Let S4 := proj1 (proj2 (proj2 (proj2 HZ))).
Let S5 := proj1 (proj2 (proj2 (proj2 (proj2 HZ)))). Let S6 := proj2 (proj2 (proj2 (proj2 (proj2 HZ)))).
Notation E := (Kf * (far * dd)).
Notation fl := (fl mu).
Let Kf1 : 1 <= Kf. Proof. pose proof (HKf 0%nat); lra. Qed.
Lemma dd_far : dd <= far * dd /\ far * dd <= E /\ E <= Kf * E.
Proof.
  destruct (far_large n_max dd S0 0 ltac:(lia)) as (_ & Q & _); cbn in Q; assert (H : 0 <= far * dd) by lra.
  pose proof (Rmult_le_compat_r (far * dd) 1 Kf H Kf1); assert (H' : 0 <= E) by lra; pose proof (Rmult_le_compat_r E 1
    Kf H' Kf1); lra.
Qed.
Lemma fl_small q x : within 2 dd x -> (q <= n_max)%nat -> small (far * dd) (fl q x) mu.
Proof.
  intros Hx Hq; pose proof (fl_in n_max dd mu Hmu S0 q x Hx Hq) as I; destruct (far_large n_max dd S0 q Hq) as (_ & Q &
    _); pose proof dd_far; split; [intros i Hi; specialize (I i Hi)|]; lra.
Qed.
Lemma X_touch q x : within 2 dd x -> (q <= n_max)%nat -> X x mu (k * q) = tr (fl q x).
Proof.
  intros Hx; induction q as [|q IH]; intros Hq; [rewrite Nat.mul_0_r; reflexivity|].
  replace (k * S q)%nat with (k * q + k)%nat by lia; unfold X in *; rewrite st_split, IH by lia.
  change (fl (S q) x) with (once (fl q x) mu); rewrite once_is.
  - rewrite tr_st by exact Hk; reflexivity.
  - apply (small_less (far * dd)); [apply fl_small; [exact Hx | lia] | apply HG].
Qed.
Lemma X_small m x : within 2 dd x -> (m <= k * n_max)%nat -> small E (X x mu m) mu.
Proof.
  intros Hx Hm; set (q := (m / k)%nat); set (j := (m mod k)%nat); assert (Em : m = (k * q + j)%nat) by (apply
    Nat.div_mod; lia). assert (Hj : (j < k)%nat) by (apply Nat.mod_upper_bound; lia). assert (Hq : (q <= n_max)%nat) by
    (apply Nat.div_le_upper_bound; lia).
  rewrite Em; unfold X; rewrite st_split; pose proof (X_touch q x Hx Hq) as Q; unfold X in Q; rewrite Q.
  destruct (fl_small q x Hx Hq) as [B1 B2]; pose proof dd_far; split; [|lra]. apply Hsize; [lia | apply HG|].
  split; [|exact B2]; intros i Hi; destruct i as [|[|i]]; [apply B1; lia | apply B1; lia | lia].
Qed.
Section Flight.
Variable x : vec.
Hypothesis Hx : within 2 dd x.
Notation X := (X x mu). Notation ends := (ends x mu).
Lemma near_arc m s : (m <= k * n_max)%nat -> 0 <= s <= @T (F m) -> Rabs (@Y (F m) (X m) mu s - @y0 (F m) s) <= Kf * E /\
  Rabs (@V (F m) (X m) mu s - @v0 (F m) s) <= Kf * E.
Proof.
  intros Hm Hs; destruct (X_small m x Hx Hm) as [B1 B2]; destruct (@near_y0 (F m) (X m) mu E s B1 B2 Hs) as [A1 A2];
    pose proof dd_far; assert (@M (F m) * E <= Kf * E) by (apply Rmult_le_compat_r; [|apply HKf]; lra); lra.
Qed.
Lemma X_r1 m : (m <= k * n_max)%nat -> small r1 (X m) mu.
Proof. intros Hm; apply (small_less E); [apply X_small; assumption | apply HG]. Qed.
Definition ends_spec m (I : imp m = true) (Hm : (m <= k * n_max)%nat) := eq_ind_r (fun c => Rabs (c - e m) <= rho1 /\
  @Y (F m) (X m) mu c = 0 /\ @V (F m) (X m) mu c < 0 /\ (forall z, Rabs (z - e m) <= rho1 -> z < c -> 0 < @Y (F m) (X
  m) mu z) /\ forall z, Rabs (z - e m) <= rho1 -> @Y (F m) (X m) mu z = 0 -> z = c) (cross_spec (F m) (e m) rho r1 rho1
  (He m) (Hex m I) (Hr1' m I) (Hsteep m I) (X m) mu (X_r1 m Hm)) (ends_imp x mu m I).
Lemma ends_near m : (m <= k * n_max)%nat -> Rabs (ends m - e m) <= D.
Proof.
  intros Hm; destruct (imp m) eqn:I; [|rewrite (ends_cut x mu m I), Rminus_eq_0, Rabs_R0; destruct dd_far; destruct HG as (_ & _ & G3 & _); pose proof (Rabs_pos mu); lra].
  pose proof (cross_near (F m) (e m) rho r1 rho1 (He m) (Hex m I) (Hr1' m I) (Hsteep m I) E (X m) mu (X_small m x Hx
    Hm) (proj1 (proj2 HG))) as Q; rewrite <- (ends_imp x mu m I) in Q; destruct Hwm as [W0 W1]; specialize (W1 m I); pose
    proof dd_far.
  assert (@M (F m) * E <= Kf * E) by (apply Rmult_le_compat_r; [|apply HKf]; lra); destruct HG as (_ & _ & _ & G4 & _).
  pose proof (Rabs_pos (ends m - e m)); apply Rmult_le_reg_l with wmin; [exact W0|]. apply Rle_trans with (- @v0 (F m)
      (e m) * Rabs (ends m - e m)); [apply Rmult_le_compat_r; lra|]. lra.
Qed.
Lemma until_is m : (m <= k * n_max)%nat -> until x mu m = ends m.
Proof.
  intros Hm; pose proof (ends_near m Hm) as Q; apply le_abs in Q; apply Rmax_left; destruct HG as (_ & _ & _ & _ & _ &
    G6); lra.
Qed.
Lemma away m s : (m <= k * n_max)%nat -> bare m s -> (forall q, m = (k * q)%nat -> r0 <= Rabs (s -
    tG))
  -> 0 < @Y (F m) (X m) mu s.
Proof.
  intros Hm Hs Ht; pose proof (proj2 Hym m s Hs Ht) as Q; destruct Hr1 as (_ & R1 & _), (He m) as (H0 & H1 & H2), Hs as
    (Hs & _); destruct (near_arc m s Hm ltac:(lra)) as [A' _]; apply le_abs in A'; destruct HG as (_ & _ & _ & _ & G5 & _); lra.
Qed.
Lemma after_entry m s s' : imp m = true -> (S m <= k * n_max)%nat -> Rabs (s - rho) <= rho1 -> Rabs (s' - rho) <= rho1
  -> s < s' -> @Y (F (S m)) (X (S m)) mu s = 0 -> 0 < @Y (F (S m)) (X (S m)) mu s'.
Proof.
  intros I Hm Hs Hs' O Y0; set (o := S m) in *; destruct (@flow (F o) (X o) mu) as (Fl & _); apply le_abs in Hs, Hs'.
  destruct (MVT_cor2 (@Y (F o) (X o) mu) (@V (F o) (X o) mu) s s' O) as (z & Ez & Hz); [intros z _; apply Fl|].
  assert (Iz : Rabs (z - rho) <= rho1) by (apply Rabs_le; split; lra).
  destruct (X_r1 o Hm) as [B1 B2]; pose proof (Hsteep' m I (X o) mu z B1 B2 Iz) as Vp; fold o in Vp.
  assert (0 < @V (F o) (X o) mu z * (s' - s)) by (apply Rmult_lt_0_compat; lra); lra.
Qed.
(** In the arcs of the touch the states are those of the map. *)
Lemma arc_touch q s : (q <= n_max)%nat -> @Y (F (k * q)%nat) (X (k * q)%nat) mu s = Y (fl q x) mu s /\ @V (F (k *
  q)%nat) (X (k * q)%nat) mu s = V (fl q x) mu s /\ e (k * q)%nat = e 0%nat.
Proof.
  intros Hq; rewrite (X_touch q x Hx Hq); destruct (F_periods q 0) as [E1 E2]; rewrite Nat.add_0_r in E1, E2; rewrite
    E1, E2. destruct (@Y_ext (F 0%nat) (tr (fl q x)) (fl q x) mu s eq_refl eq_refl); auto.
Qed.
End Flight.
Notation flown := (flown dd mu n). Notation hit := (hit mu n).
Definition hits := hit_facts n_max dd mu n Hn Hmu S0 S1 S2 S4 D S5 S6.
Lemma last_is i : last N i (i + 1) = (k * n i)%nat.
Proof. unfold last; rewrite HN; replace (N i + Z.of_nat (n i) - N i)%Z with (Z.of_nat (n i)) by lia; rewrite Nat2Z.id;
  reflexivity. Qed.
Lemma last_max i : (1 <= k * n i <= k * n_max)%nat.
Proof. pose proof (Hn i); split; nia. Qed.
(** The velocity after an impact. *)
Lemma vel_start x yy j : flown x yy (j - 1) -> Vl mu n N x j (at_ mu n x yy P sg N j) = V (x j) mu (hit x yy (j - 1)).
Proof.
  intros F0; destruct (hits x yy (j - 1)%Z j F0 ltac:(lia)) as (_ & _ & _ & _ & _ & _ & _ & Cd); set (c := hit x yy (j -
    1)) in *; assert (Ej : at_ mu n x yy P sg N j = off N j 0 + c) by (unfold at_, off, c; cbn [base]; ring).
  assert (A0 : at_arc n N mu x j (at_ mu n x yy P sg N j) 0).
  { split; [lia | split; [intros m' O; lia|]]; intros _; rewrite Ej; destruct Hsep as (_ & P2 & _), S6 as [_ S6'];
      assert (e 0%nat - rho1 <= until (x j) mu 0) by apply Rmax_r; pose proof (proj1 Hwin) as Hr; apply le_abs in Cd;
          lra. }
  destruct (placed n N mu x j _ 0 A0) as [_ ->]; rewrite Ej; replace (off N j 0 + c - off N j 0) with c by ring.
  destruct (@Y_ext first (tr (x j)) (x j) mu c eq_refl eq_refl) as [_ Q]; exact Q.
Qed.
Section FromOrbit.
Variables (x : Z -> vec) (yy : Z -> R) (i : Z).
Hypothesis F0 : flown x yy (i - 1).
Hypothesis F1 : flown x yy i.
Notation K := (k * n i)%nat.
Notation X := (X (x i) mu). Notation ends := (ends (x i) mu).
Definition al (m : nat) : R := match m with O => hit x yy (i - 1) | S m => ends m - e m + rho end.
Definition om (m : nat) : R := if Nat.eq_dec m K then hit x yy i else ends m.
Let Hx : within 2 dd (x i) := Ox _ _ _ _ _ _ F1.
Lemma om_end : om K = hit x yy i. Proof. unfold om; destruct Nat.eq_dec; [reflexivity | lia]. Qed.
Lemma om_other m : (m < K)%nat -> om m = ends m. Proof. unfold om; destruct Nat.eq_dec; [lia | reflexivity]. Qed.
Lemma arc_open m s : (m <= K)%nat -> al m < s < om m -> 0 < @Y (F m) (X m) mu s.
Proof.
  intros Hm Hs; pose proof (last_max i) as LM; assert (Hm' : (m <= k * n_max)%nat) by lia; destruct Hsep as (P1 & P2 &
    P3); destruct Hr1 as (_ & R1 & _); destruct HG as (_ & _ & _ & _ & _ & G6); destruct S6 as [_ S6'].
  destruct (hits x yy (i - 1)%Z i F0 ltac:(lia)) as (_ & Cw & _ & _ & Vz & E1 & E2 & Cd), (hits x yy i (i + 1)%Z F1
    eq_refl) as (Bz' & Cw' & _ & Ez' & Vz' & _ & _ & Cd'); pose proof (le_abs _ _ Cd) as C1; pose proof (le_abs _ _ Cd')
    as C2.
  assert (Hal : (0 < m)%nat -> Rabs (al m - rho) <= D).
  { intros M0; destruct m as [|m]; [lia|]; cbn [al]. replace (ends m - e m + rho - rho) with
      (ends m - e m) by ring; apply ends_near; [exact Hx | lia]. }
  assert (Hom : (m < K)%nat -> Rabs (ends m - e m) <= D /\ om m = ends m) by (intros M0; split; [apply ends_near; [exact
    Hx | lia] | apply om_other, M0]).
  assert (Lo : rho - rho1 <= al m) by (destruct m as [|m]; [cbn [al]; lra | pose proof (Hal ltac:(lia)) as Q; apply
    le_abs in Q; lra]).
  assert (Up : om m <= e m + rho1).
  { destruct (Nat.eq_dec m K) as [->|Ne]; [|destruct (Hom ltac:(lia)) as [Q ->]; apply le_abs in Q; lra]. rewrite
      om_end; destruct (F_periods (n i) 0) as [_ Ee]; rewrite Nat.add_0_r in Ee; rewrite Ee; lra. }
  assert (A1 : 0 < @Y (F m) (X m) mu s \/ rho <= s /\ match m with O => rho + rho1 <= s | S m => imp m = true -> rho +
    rho1 <= s end).
  { destruct m as [|m]; [right; cbn [al] in Hs; lra|]; pose proof (Hal ltac:(lia)) as Q; destruct (imp m) eqn:I.
    - destruct (Rle_lt_dec (Rabs (s - rho)) rho1) as [A1|A1]; [left | right; unfold Rabs in A1; destruct (Rcase_abs (s -
        rho)); lra]. apply (after_entry (x i) Hx m (al (S m)) s I Hm'); [lra | exact A1 | lra|]; cbn [al]; rewrite (proj1
        (entered (x i) mu m)); destruct (HF' m) as (_ & _ & Z); apply Z, I.
    - right; cbn [al] in Hs; rewrite (ends_cut (x i) mu m I) in Hs; split; [lra | discriminate]. }
  destruct A1 as [A1|A1]; [exact A1|]; assert (A2 : 0 < @Y (F m) (X m) mu s \/ s <= e m /\ (imp m = true -> s <= e m -
    rho1)).
  { destruct (Nat.eq_dec m K) as [->|Ne].
    - right; rewrite om_end in Hs; destruct (F_periods (n i) 0) as [_ Ee]; rewrite Nat.add_0_r in Ee; rewrite Ee; lra.
    - destruct (Hom ltac:(lia)) as [Q1 Q2]; rewrite Q2 in Hs; destruct (imp m) eqn:I; [|rewrite (ends_cut (x i) mu m I) in
        Hs; right; split; [lra | discriminate]]. destruct (Rle_lt_dec (Rabs (s - e m)) rho1) as [A2|A2]; [left; destruct
        (ends_spec (x i) Hx m I Hm') as (_ & _ & _ & B & _); apply B; [exact A2 | apply Hs] | right]. apply le_abs in Q1;
        unfold Rabs in A2; destruct (Rcase_abs (s - e m)); lra. }
  destruct A2 as [A2|A2]; [exact A2|]; assert (A3 : bare m s) by (unfold bare; tauto).
  destruct (Nat.eq_dec (m mod k) 0) as [M0|M0].
  2: { apply away; [exact Hx | exact Hm' | exact A3|]; intros q Eq; exfalso; apply M0; rewrite Eq, Nat.mul_comm; apply
    Nat.mod_mul; lia. }
  assert (Em : m = (k * (m / k))%nat) by (apply Nat.div_exact; lia); set (q := (m / k)%nat) in *; assert (Hq : (q <= n
    i)%nat) by nia. assert (Hqn : (q <= n_max)%nat) by (pose proof (Hn i); lia).
  destruct (Rle_lt_dec r0 (Rabs (s - tG))) as [Far|Close].
  { apply away; [exact Hx | exact Hm' | exact A3|]; intros q' _; exact Far. }
  destruct (arc_touch (x i) Hx q s Hqn) as (T1 & T2 & _); rewrite Em, T1.
  destruct (fl_near n_max dd mu Hmu S0 S1 S4 q (x i) Hx Hqn) as (Bk & Lw & Ne).
  destruct (Nat.eq_dec q 0) as [Q0|Q0]; [|destruct (Nat.eq_dec q (n i)) as [Q1|Q1]].
  - rewrite Em, Q0, Nat.mul_0_r in Hs; cbn [al] in Hs; rewrite Q0 in Bk |- *; change (fl 0 (x i)) with (x i) in *.
      rewrite <- E1; apply rising; trivial; try lra; rewrite E2; apply (proj1 (proj2 (proj2 Hreb))), Vz.
  - rewrite Em, Q1, om_end in Hs; rewrite Q1 in Bk |- *; rewrite <- Ez'; apply (falling mu _ s (hit x yy i)); trivial;
      lra.
  - pose proof (Ok _ _ _ _ _ _ F1 q ltac:(lia)) as Po; pose proof (Y_above (fl q (x i)) mu s Bk ltac:(here; lra)) as Ab;
      cbv zeta in Ab. assert (0 <= 3 / 8 * g * ((s - low (fl q (x i)) mu) * (s - low (fl q (x i)) mu))) by (apply
      Rmult_le_pos; [destruct Hg; lra | apply Rle_0_sqr]); lra.
Qed.
Lemma orbit_arc m : (m <= K)%nat -> arc_is mu D m (al m) (om m) (@Y (F m) (X m) mu) (@V (F m) (X m) mu).
Proof.
  intros Hm; pose proof (last_max i) as LM; assert (Hm' : (m <= k * n_max)%nat) by lia; destruct Hsep as (P1 & P2 & P3);
    destruct Hr1 as (_ & R1 & _), (He m) as (H0 & H1 & H2); destruct HG as (_ & _ & G3 & _ & _ & G6); destruct S6 as [_
    S6'].
  destruct (hits x yy (i - 1)%Z i F0 ltac:(lia)) as (_ & Cw & _ & _ & Vz & E1 & E2 & Cd), (hits x yy i (i + 1)%Z F1
    eq_refl) as (Bz' & Cw' & _ & Ez' & Vz' & _ & _ & Cd'); pose proof (le_abs _ _ Cd) as C1; pose proof (le_abs _ _ Cd')
    as C2.
  destruct (F_periods (n i) 0) as [_ Ee]; rewrite Nat.add_0_r in Ee. pose proof (Hn i) as Hni.
  assert (Lo : rho - rho1 <= al m <= if Nat.eq_dec m 0 then tG + r0 else rho + rho1).
  { destruct m as [|m]; cbn [al]; [destruct Nat.eq_dec; [lra | lia]|]. pose proof (ends_near (x i) Hx m ltac:(lia)) as Q;
      apply le_abs in Q; destruct Nat.eq_dec; [lia | lra]. }
  assert (Up : (if Nat.eq_dec m K then tG - r0 else e m - rho1) <= om m <= e m + rho1).
  { destruct (Nat.eq_dec m K) as [->|Ne]; [rewrite om_end, Ee; lra|]. rewrite om_other by lia; pose proof (ends_near (x i)
      Hx m Hm') as Q; apply le_abs in Q; lra. }
  split; [|split].
  - specialize (P3 m); assert (P4 : m = 0%nat -> tG + r0 < e m - rho1) by (intros ->; exact P2); destruct (Nat.eq_dec m
      0) as [M0|M0], (Nat.eq_dec m K); [lia | specialize (P4 M0); lra | lra | lra].
  - intros s Hs; split; [apply (@flow (F m) (X m) mu)|]; destruct (near_arc (x i) Hx m s Hm' ltac:(lra)); lra.
  - intros s Hs; apply arc_open; assumption.
Qed.
Lemma orbit_ends m : (m <= K)%nat -> if Nat.eq_dec m K then @Y (F m) (X m) mu (om m) = 0 /\ @V (F m) (X m) mu (om m) < 0
  else if imp m then @Y (F m) (X m) mu (om m) = 0 /\ @V (F m) (X m) mu (om m) < 0 else om m = e m.
Proof.
  intros Hm; pose proof (last_max i) as LM; pose proof (Hn i) as Hni; destruct (Nat.eq_dec m K) as [->|Ne].
  - destruct (hits x yy i (i + 1)%Z F1 eq_refl) as (_ & _ & _ & Ez' & Vz' & _), (arc_touch (x i) Hx (n i) (hit x yy i)
      ltac:(lia)) as (T1 & T2 & _); rewrite om_end, T1, T2; auto.
  - rewrite om_other by lia; destruct (imp m) eqn:I; [|apply ends_cut, I]; destruct (ends_spec (x i) Hx m I ltac:(lia))
      as (_ & Q1 & Q2 & _); auto.
Qed.
Lemma orbit_run : run mu D N (at_ mu n x yy P sg N) (Pl mu n N x) (Vl mu n N x) i (i + 1) al om (fun m => @Y (F m) (X m)
  mu) (fun m => @V (F m) (X m) mu).
Proof.
  pose proof (last_max i) as LM; pose proof (Hn i) as Hni; destruct (hits x yy (i - 1)%Z i F0 ltac:(lia)) as (_ & _ & _
    & _ & _ & _ & _ & Cd), (hits x yy i (i + 1)%Z F1 eq_refl) as (_ & _ & _ & _ & Vz' & _ & E2' & Cd').
  assert (Place : forall m s, (m <= K)%nat -> al m <= s <= om m -> (s = om m -> m = K) -> at_arc n N mu x i (off N i m +
    s) m).
  { intros m s Hm Hs Hl; split; [exact Hm | split].
    - intros m' O; rewrite (until_is (x i) Hx) by lia; rewrite <- om_other by lia; pose proof (times_grow K al om N i
        ltac:(intros j Hj; cbn [al]; rewrite om_other by exact Hj; reflexivity) ltac:(intros j Hj; left; apply
            (orbit_arc j Hj)) m m' Hm O); lra.
    - intros O; rewrite (until_is (x i) Hx) by lia; rewrite <- om_other by exact O; destruct (Req_dec s (om m)) as
        [Q|Q]; [apply Hl in Q; lia | lra]. }
  constructor; rewrite ?last_is.
  - cbn [al]; unfold at_; ring.
  - rewrite om_end; unfold at_; replace (i + 1 - 1)%Z with i by lia; ring.
  - intros m Hm; cbn [al]; rewrite om_other by exact Hm; reflexivity.
  - split; [exact Cd | split; [rewrite om_end; exact Cd' | intros m Hm; rewrite om_other by exact Hm; apply ends_near;
      [exact Hx | lia]]].
  - apply orbit_arc.
  - apply orbit_ends.
  - destruct (hits x yy (i - 1)%Z i F0 ltac:(lia)) as (_ & _ & _ & _ & _ & E1 & _), (arc_touch (x i) Hx 0 (hit x yy (i -
      1)) ltac:(lia)) as (T3 & _); rewrite Nat.mul_0_r in T3; cbn [al]; rewrite T3; exact E1.
  - intros m Hm; cbn [al]; rewrite om_other by exact Hm; apply entered.
  - intros m s Hm Hs Hl; destruct (placed n N mu x i _ m (Place m s Hm Hs Hl)) as [-> ->]; replace (off N i m + s - off
      N i m) with s by ring; auto.
  - rewrite om_end; destruct (arc_touch (x i) Hx (n i) (hit x yy i) ltac:(lia)) as (_ & -> & _); rewrite <- E2'.
    replace (hit x yy i) with (hit x yy (i + 1 - 1)%Z) by (f_equal; lia); apply vel_start; replace (i + 1 - 1)%Z with i
      by lia; exact F1.
Qed.
End FromOrbit.

(** A motion near the orbit is an orbit of the map. *)
Definition follows (x : Z -> vec) (i : Z) (al om : nat -> R) (p q : nat -> R -> R) : Prop := (forall m s, (m <= k * n
    i)%nat
  -> al m <= s <= om m -> p m s = @Y (F m) (X (x i) mu m) mu s /\ q m s = @V (F m) (X (x i) mu m) mu s) /\
  forall m, (m < k * n i)%nat -> om m = ends (x i) mu m.
Definition Trace (x : Z -> vec) t y v : Prop := forall i, exists r al om p q, r <= r0 /\ run mu r N t y v i (i + 1) al
  om p q /\ follows x i al om p q.
Section FromMotion.
Variables (t : Z -> R) (y v : Z -> R -> R) (r : R).
Hypothesis HM : forall i, Leg mu r N t y v i (i + 1).
Hypothesis Hm : Rabs mu <= r.
Hypothesis Hr : Kf * r <= dd /\ r <= D.
Definition states (i : Z) : vec := origin mu (t i - (sg + P * IZR (N i))) (y i (t i)) (v i (t i)).
Notation x := states.
Section One.
Variables (i : Z) (al om : nat -> R) (p q : nat -> R -> R).
Hypothesis HR : run mu r N t y v i (i + 1) al om p q.
Notation K := (k * n i)%nat.
Notation X := (X (x i) mu). Notation ends := (ends (x i) mu).
Lemma begins : al 0%nat = t i - (sg + P * IZR (N i)) /\ y i (t i) = 0 /\ p 0%nat (al 0%nat) = 0 /\ v i (t i) = q 0%nat
  (al 0%nat) /\ Rabs (al 0%nat - tG) <= r.
Proof.
  destruct HR as [R1 R2 R3 R4 R5 _ Z R6 R7 R8]; rewrite last_is in *; destruct (R5 0%nat ltac:(lia)) as (O & _).
  destruct (R7 0%nat (al 0%nat) ltac:(lia) ltac:(lra) ltac:(intros Q; lra)) as [Q1 Q2]; replace (off N i 0 + al 0%nat)
    with (t i) in Q1, Q2 by (rewrite R1; unfold off; cbn [base]; ring). rewrite Q1, Q2; repeat split; trivial; apply R4.
Qed.
Lemma state_small : within 2 dd (x i).
Proof.
  destruct HR as [R1 R2 R3 R4 R5 RE _ R6 R7 R8]; destruct begins as (B1 & B2 & B3 & B4 & B5); destruct (R5 0%nat ltac:(lia))
    as (O & A5 & _). destruct (A5 (al 0%nat) ltac:(lra)) as (_ & N1 & N2); rewrite B3 in N1; rewrite <- B4 in N2.
  destruct (origin_flow mu (al 0%nat) (y i (t i)) (v i (t i))) as [E1 E2]; rewrite B1 in E1 at 1; rewrite B1 in E2 at 1;
    fold (x i) in E1, E2. pose proof (proj1 Hwin) as Hr0; destruct S6 as [_ S6']; destruct Hr as [Hr1' Hr2].
  pose proof (nearby_back (x i) zero mu 0 r (al 0%nat)) as NB; rewrite E1, E2, (proj1 (at_rest _)), (proj2 (at_rest _)),
    Rminus_0_r, B2 in NB. specialize (NB N1 N2 Hm). apply le_abs in B5; destruct Hsep as (P1 & P2 & _); destruct (He
    0%nat) as (H0 & H1 & H2), Hr1 as (_ & R9 & _).
  assert (I : 0 <= al 0%nat <= @T first) by (unfold first; lra); specialize (NB I); intros j Hj; specialize (NB j Hj);
    unfold minus, zero in NB; rewrite Rminus_0_r in NB. assert (@M first * r <= Kf * r) by (apply Rmult_le_compat_r;
    [pose proof (Rabs_pos mu); lra | apply HKf]); lra.
Qed.
Lemma same_arcs : follows x i al om p q.
Proof.
  pose proof (last_max i) as LM; pose proof state_small as Hx; pose proof HR as [R1 R2 R3 R4 R5 RE _ R6 R7 R8]; rewrite
    last_is in *; destruct begins as (B1 & B2 & B3 & B4 & B5); destruct HG as (_ & _ & _ & _ & _ & G6), Hr as [_ Hr2].
  assert (Arc : forall m, (m <= K)%nat -> @Y (F m) (X m) mu (al m) = p m (al m) -> @V (F m) (X m) mu (al m) = q m (al m)
    -> forall s, al m <= s <= om m -> p m s = @Y (F m) (X m) mu s /\ q m s = @V (F m) (X m) mu s).
  { intros m Hm' E1 E2; destruct (R5 m Hm') as (O & A5 & _); apply (@unique_on (F m) (al m) (om m) mu (p m) (q m) _ _
      (al m)); [|lra|symmetry; exact E1|symmetry; exact E2]. intros s Hs; split; [apply A5, Hs | apply (@flow (F m) (X
          m) mu)]. }
  assert (End : forall m, (m < K)%nat -> (forall s, al m <= s <= om m -> p m s = @Y (F m) (X m) mu s /\ q m s = @V (F m)
    (X m) mu s) -> om m = ends m).
  { intros m Hm' H; destruct (R5 m ltac:(lia)) as (O & _); pose proof (RE m ltac:(lia)) as Q; destruct (Nat.eq_dec m K);
      [lia|]. destruct (imp m) eqn:I; [|rewrite (ends_cut (x i) mu m I); exact Q]; destruct (ends_spec (x i) Hx m I
      ltac:(lia)) as (_ & _ & _ & _ & U); apply U; [pose proof (proj2 (proj2 R4) m Hm'); lra|]. rewrite <- (proj1 (H (om
      m) ltac:(lra))); apply Q. }
  assert (All : forall m, (m <= K)%nat -> forall s, al m <= s <= om m -> p m s = @Y (F m) (X m) mu s /\ q m s = @V (F m)
    (X m) mu s).
  { intros m; induction m as [|m IH]; intros Hm'.
    - destruct (origin_flow mu (al 0%nat) (y i (t i)) (v i (t i))) as [E1 E2]; rewrite B1 in E1 at 1; rewrite B1 in E2
        at 1; fold (x i) in E1, E2. destruct (@Y_ext first (tr (x i)) (x i) mu (al 0%nat) eq_refl eq_refl) as [E3 E4].
            apply Arc;
        [exact Hm' | |]; [transitivity (Y (x i) mu (al 0%nat)); [exact E3 | rewrite E1, B2, B3; reflexivity] |
            transitivity
        (V (x i) mu (al 0%nat)); [exact E4 | rewrite E2; exact B4]].
    - pose proof (IH ltac:(lia)) as H; pose proof (End m ltac:(lia) H) as Ee; destruct (R5 m ltac:(lia)) as (O & _), (R6 m
        ltac:(lia)) as [Z1 Z2]. destruct (H (om m) ltac:(lra)) as [Q1 Q2]; destruct (entered (x i) mu m) as [E1 E2]; apply
        Arc; [exact Hm' | |]; rewrite (R3 m ltac:(lia)), Ee; [rewrite E1 | rewrite E2].
      + rewrite <- Ee, <- Q1, <- (R3 m ltac:(lia)); symmetry; exact Z1.
      + rewrite <- Ee, <- Q2, <- (R3 m ltac:(lia)); symmetry; exact Z2. }
  split; [intros m s Hm' Hs; apply All; assumption | intros m Hm'; apply End; [exact Hm' | apply All; lia]].
Qed.
End One.
Theorem motion_orbit : exists yy, facts dd mu n x yy /\ Trace x t y v.
Proof.
  assert (Hx : forall i, within 2 dd (x i)) by (intros i; destruct (HM i) as (al & om & p & q & HR); exact (state_small
    i al om p q HR)). set (z i := fl (n i) (x i)); set (yy i := sqrt (- Y (z i) mu (low (z i) mu))); exists yy.
  destruct S6 as [_ S6']; destruct Hr as [_ Hr2]; pose proof (proj1 Hwin) as Hr0. split.
  2: { intros i; destruct (HM i) as (al & om & p & q & HR); exists r, al, om, p, q; split; [lra | split; [exact HR |
    exact (same_arcs i al om p q HR)]]. }
  intros i; pose proof (last_max i) as LM; pose proof (Hn i) as Hni; destruct (HM i) as (al & om & p & q & HR), (HM (i +
    1)%Z) as (al' & om' & p' & q' & HR'); destruct (same_arcs i al om p q HR) as [Sa Se]; destruct (begins (i + 1)%Z al'
    om' p' q' HR') as (B1 & B2 & _ & _ & B5); pose proof HR as [R1 R2 R3 R4 R5 RE _ R6 R7 R8]; rewrite last_is in *.
  set (K := (k * n i)%nat) in *; pose proof (RE K (le_n _)) as Z; destruct (Nat.eq_dec K K) as [_|]; [|lia]; destruct Z
    as [Z1 Z2], (R5 K (le_n _)) as (O & _); destruct (Sa K (om K) (le_n _) ltac:(lra)) as [E1 E2]. destruct (arc_touch
    (x i) (Hx i) (n i) (om K) ltac:(lia)) as (T1 & T2 & _); fold K in T1, T2; rewrite T1 in E1; rewrite T2 in E2. fold
    (z i) in E1, E2.
  assert (Ek : om K = al' 0%nat) by (rewrite B1, R2; reflexivity); rewrite <- Ek in B5.
  destruct (crossing_is n_max dd mu Hmu S0 S1 S2 S4 (x i) (n i) (om K) (Hx i) ltac:(lia) ltac:(lra)) as (C1 & C2 & C3).
  { change (Y (z i) mu (om K) = 0); rewrite <- E1; exact Z1. } { change (V (z i) mu (om K) < 0); rewrite <- E2; exact
      Z2. }
  change (0 < yy i) in C1; change (Y (z i) mu (low (z i) mu) = - (yy i * yy i)) in C2; change (tc (z i) (yy i) mu = om
    K) in C3. constructor; [apply Hx | exact C1 | exact C2 | |].
  - intros c Hc; assert (Hcn : (c <= n_max)%nat) by lia; destruct (fl_near n_max dd mu Hmu S0 S1 S4 c (x i) (Hx i) Hcn)
      as (Bk & Lw & _); set (l := low (fl c (x i)) mu) in *. destruct (arc_touch (x i) (Hx i) c l Hcn) as (T3 & _ & Ec).
    assert (Hm' : (0 < k * c < K)%nat) by (unfold K; nia); destruct Hsep as (P1 & P2 & _), HG as (_ & _ & _ & _ & _ &
        G6).
    assert (Ej : exists j, (k * c = S j)%nat) by (exists (k * c - 1)%nat; lia); destruct Ej as (j & Ej).
    assert (La : al (k * c)%nat < l) by (rewrite Ej, (R3 j ltac:(lia)); pose proof (proj2 (proj2 R4) j ltac:(lia)) as Q;
      apply le_abs in Q, Lw; lra).
    assert (Lb : l < om (k * c)%nat) by (pose proof (proj2 (proj2 R4) (k * c)%nat ltac:(lia)) as Q; rewrite Ec in Q;
      apply le_abs in Q, Lw; lra).
    destruct (R5 (k * c)%nat ltac:(lia)) as (_ & _ & Op); specialize (Op l (conj La Lb)); rewrite (proj1 (Sa
      (k * c)%nat l ltac:(lia) ltac:(lra))), T3 in Op; exact Op.
  - intros c Hc; unfold after; fold (z i); rewrite C3, <- E1, <- E2, Z1; unfold states; rewrite B2, R8, <- B1, <- Ek;
      reflexivity.
Qed.
End FromMotion.
(** Two motions with the same orbit are the same. *)
Lemma same_motion x yy x' yy' t y v t' y' v' : facts dd mu n x yy -> facts dd mu n x' yy' -> Trace x t y v -> Trace x'
  t' y' v' -> (forall j i, (i < 2)%nat -> x' j i = x j i) -> forall i, t' i = t i /\ forall u, t i <= u <= t (i + 1)%Z
      -> y' i u =
  y i u /\ v' i u = v i u.
Proof.
  intros Hf Hf' Tr Tr' Ex; assert (Xe : forall i m, X (x' i) mu m = X (x i) mu m) by (intros i m; unfold X, tr; rewrite
    !Ex by lia; reflexivity). assert (Et' : forall i, t' (i + 1)%Z = t (i + 1)%Z).
  { intros i; pose proof (Hn i) as Hni; destruct (Tr i) as (r & al & om & p & q & _ & HR & Sa & _), (Tr' i) as (r' & al'
      & om' & p' & q' & _ & HR' & Sa' & _), (Tr (i + 1)%Z) as (r1' & al1 & om1 & p1 & q1 & Hr1' & HR1 & _), (Tr' (i +
      1)%Z) as (r2 & al2 & om2 & p2 & q2 & Hr2 & HR2 & _).
    pose proof (run_near _ _ _ _ _ _ _ _ _ _ _ _ HR1) as [N1 _]; pose proof (run_near _ _ _ _ _ _ _ _ _ _ _ _ HR2) as
      [N2 _]; rewrite (run_from _ _ _ _ _ _ _ _ _ _ _ _ HR1) in N1; rewrite (run_from _ _ _ _ _ _ _ _ _ _ _ _ HR2) in
          N2.
    destruct HR as [_ R2 _ _ R5 RE _ _ _ _], HR' as [_ R2' _ _ R5' RE' _ _ _ _]; rewrite last_is in *; set (K := (k * n
        i)%nat) in *.
    specialize (RE K (le_n _)); specialize (RE' K (le_n _)); destruct (Nat.eq_dec K K) as [_|]; [|lia]; destruct RE as [Z1
      Z2], RE' as [Z1' Z2'], (R5 K (le_n _)) as (O & _), (R5' K (le_n _)) as (O' & _).
    rewrite (proj1 (Sa K (om K) (le_n _) ltac:(lra))) in Z1; rewrite (proj2 (Sa K (om K) (le_n _) ltac:(lra))) in Z2.
    rewrite (proj1 (Sa' K (om' K) (le_n _) ltac:(lra))), Xe in Z1'; rewrite (proj2 (Sa' K (om' K) (le_n _) ltac:(lra))),
      Xe in Z2'. pose proof (Ox _ _ _ _ _ _ (Hf i)) as Hx; destruct (arc_touch (x i) Hx (n i) (om K) ltac:(lia)) as (T1
      & T2 & _), (arc_touch (x i) Hx (n i) (om' K) ltac:(lia)) as (T3 & T4 & _); fold K in T1, T2, T3, T4.
    rewrite T1 in Z1; rewrite T2 in Z2; rewrite T3 in Z1'; rewrite T4 in Z2'.
    destruct (fl_near n_max dd mu Hmu S0 S1 S4 (n i) (x i) Hx ltac:(lia)) as (Bz & _).
    assert (W : Rabs (om K - tG) <= r0 /\ Rabs (om' K - tG) <= r0) by (rewrite R2, R2'; lra).
    pose proof (one_crossing _ _ _ _ Bz (proj1 W) (proj2 W) Z1 Z1' Z2 Z2') as Q; rewrite R2, R2' in Q; lra. }
  assert (Et : forall i, t' i = t i) by (intros i; replace i with (i - 1 + 1)%Z by lia; apply Et').
  intros i; split; [apply Et|]; intros u Hu; destruct (Tr i) as (r & al & om & p & q & _ & HR & Sa & Se), (Tr' i) as (r'
    & al' & om' & p' & q' & _ & HR' & Sa' & Se'). destruct HR as [R1 R2 R3 _ R5 _ _ _ R7 _], HR' as [R1' R2' R3' _ R5' _
    _ _ R7' _]; rewrite last_is in *; set (K := (k * n i)%nat) in *. rewrite Et in R1', R2'.
  assert (Om : forall m, (m <= K)%nat -> om' m = om m).
  { intros m Hm; destruct (Nat.eq_dec m K) as [->|Ne]; [rewrite R2, R2'; reflexivity|]. rewrite Se, Se' by (unfold K in
      *; lia); unfold ends; rewrite Xe; reflexivity. }
  assert (Al : forall m, (m <= K)%nat -> al' m = al m) by (intros [|m] Hm; [rewrite R1, R1'; reflexivity | rewrite R3,
    R3', Om by lia; reflexivity]).
  destruct (find_arc K al om N i u R3) as (m & Hm & Hs & Hl).
  { rewrite R1, R2; unfold off, K; rewrite <- (Nat.add_0_r (k * n i)), base_periods; cbn [base]; rewrite HN, plus_IZR,
      <- INR_IZR_INZ in *; rewrite Rmult_plus_distr_l; lra. }
  assert (Eu : u = off N i m + (u - off N i m)) by ring. destruct (R7 m (u - off N i m) Hm Hs Hl) as [Q1 Q2]; rewrite <-
    Eu in Q1, Q2. destruct (R7' m (u - off N i m) Hm ltac:(rewrite Om, Al by exact Hm; exact Hs) ltac:(rewrite Om by
    exact Hm; exact Hl)) as [Q3 Q4]; rewrite <- Eu in Q3, Q4. rewrite Q1, Q2, Q3, Q4; destruct (Sa m (u - off N i m) Hm
    Hs) as [-> ->]; destruct (Sa' m (u - off N i m) Hm ltac:(rewrite Om, Al by exact Hm; exact Hs)) as [-> ->]; rewrite
    Xe; auto.
Qed.
End Sized.

(** Theorem 1 for these motions. *)
Hypothesis Hio : @NonlinearKick.kk _ _ Io = kk 0%nat /\ @NonlinearKick.cc _ _ Io = cc 0%nat /\
  @NonlinearKick.ll _ _ Io = ll 0%nat.
Lemma good_exists n_max D : 0 < D <= rho1 -> exists dd, 0 < dd /\ Good n_max dd D /\ forall dd', 0 < dd' <= dd -> Good
  n_max dd' D.
Proof.
  intros HD; pose proof (HKf 0%nat) as HK1; destruct Hr1 as (Hr & _); assert (K1 : 1 <= Kf) by lra; assert (F1 : 1 <=
    far n_max) by (unfold far; change K with Kf; pose proof (pow_R1_Rle Kf n_max K1); rewrite <- (Rmult_1_l 1); apply
    Rmult_le_compat; lra).
  assert (PwD : 0 < wmin * D) by (apply Rmult_lt_0_compat; lra).
  destruct (two_least rf r1 Hrf Hr) as (b1 & B1 & L1 & L2), (two_least b1 D B1 (proj1 HD)) as (b2 & B2 & L3 & L4),
    (two_least b2 (wmin * D / 2) B2 ltac:(lra)) as (b3 & B3 & L5 & L6), (two_least b3 (ymin / 2) B3 ltac:(lra)) as (b &
        B & L7 & L8).
  set (W := Kf * Kf * far n_max); assert (HKK : 1 <= Kf * Kf) by (rewrite <- (Rmult_1_l 1); apply Rmult_le_compat; lra).
  assert (HW : 1 <= W) by (unfold W; rewrite <- (Rmult_1_l 1); apply Rmult_le_compat; lra).
  assert (Pb : 0 < b / W) by (apply Rdiv_lt_0_compat; lra); exists (b / W); split; [exact Pb|].
  assert (G : forall dd', 0 < dd' <= b / W -> Good n_max dd' D).
  { intros dd' Hd; assert (Q : Kf * (Kf * (far n_max * dd')) <= b).
    { replace (Kf * (Kf * (far n_max * dd'))) with (W * dd') by (unfold W; ring); apply Rle_trans with (W * (b / W));
        [apply Rmult_le_compat_l; lra | right; field; lra]. }
    assert (P0 : 0 <= far n_max * dd') by (apply Rmult_le_pos; lra); pose proof (Rmult_le_compat_r (far n_max * dd') 1
      Kf P0 ltac:(lra)) as Q1; assert (P1 : 0 <= Kf * (far n_max * dd')) by lra; pose proof (Rmult_le_compat_r (Kf *
      (far n_max * dd')) 1 Kf P1 ltac:(lra)) as Q2. unfold Good; repeat split; lra. }
  split; [apply G; lra | exact G].
Qed.
Theorem round_core A11 A21 A22 gamma z w : (forall z w, chain k 0 z w -> z k tG = A11 * z 0%nat tG + gamma * w 0%nat tG
  /\ w k tG = A21 * z 0%nat tG + A22 * w 0%nat tG) -> gamma <> 0 -> chain k 1 z w -> z k 0 = z 0%nat 0 -> w k 0 = w
      0%nat 0 -> z
  0%nat tG <> 0 -> let a1 := A11 + A22 in let a2 := A11 * A22 - gamma * A21 in forall n_max, exists d, d > 0 /\ forall
      eps, 0
  < eps <= d -> exists mu0, mu0 > 0 /\ forall (n : Z -> nat) (N : Z -> Z) e s mu, (forall i, (1 <= n i <= n_max)%nat /\
      u a1
  a2 (n i) <> 0) -> (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z -> sgn s * gamma > 0 -> 0 < sgn e * (z 0%nat tG * mu)
      <
  mu0 -> ((forall i, member a1 a2 e (n i) /\ edge a1 a2 e s (n i) (n (i + 1)%Z)) -> exists t y v, motion Leg mu eps N t
      y v /\
  unstable_motion (Leg mu eps N) t v /\ forall t' y' v', motion Leg mu eps N t' y' v' -> forall i, t' i = t i /\ forall
      x, t i
  <= x <= t (i + 1)%Z -> y' i x = y i x /\ v' i x = v i x) /\ ((exists i, breaks a1 a2 e s (n i) (n (i + 1)%Z)) ->
      forall t y
  v, ~ motion Leg mu d N t y v).
Proof.
  intros H1 Hg' Hz Ez Ew Hr' a1 a2 n_max; pose proof (proj1 Hwin) as Hr0; pose proof (HKf 0%nat) as HK1; destruct Hr1
    as (_ & R1 & _); destruct Hio as (I1 & I2 & I3).
  destruct (two_least (r0 / 4) rho1 ltac:(here; lra) ltac:(here; lra)) as (Dm & HDm & M1 & M2).
  assert (Lk : forall h z w, solves (kk k) (cc k) (ll k) h z w -> solves (@NonlinearKick.kk _ _ Io) (@NonlinearKick.cc _
    _ Io) (@NonlinearKick.ll _ _ Io) h z w).
  { intros h u v Hu; rewrite I1, I2, I3; destruct (HF 0) as (_ & _ & _ & E1 & E2 & E3); rewrite Nat.add_0_r in E1, E2,
      E3; rewrite <- E1, <- E2, <- E3; exact Hu. }
  apply (core P sg Dm Kf Leg Pl Vl Good (fun mu n N x t y v => Trace mu n N x t y v)) with (w := w 0%nat); trivial.
  - lra.
  - intros m D HD; apply good_exists; lra.
  - intros m dd mu n N D x yy i HW HZ HG Hmu F0 F1; exists (al mu n x yy i), (om mu n x yy i); eexists; eexists; exact
      (orbit_run m dd mu n N D HW HZ HG Hmu x yy i F0 F1).
  - intros m dd mu n N D x yy i HW HZ HG Hmu F0; exact (vel_start m dd mu n N D HW HZ Hmu x yy i F0).
  - intros m dd mu n N D r t y v HW HZ HG Hm Hk' Hd HM.
    assert (Hdd : Rabs mu <= dd) by (pose proof (Rabs_pos mu); assert (1 * r <= Kf * r) by (apply Rmult_le_compat_r;
        lra); lra).
    destruct (motion_orbit m dd mu n N D HW HZ HG Hdd t y v r (fun i => HM i _ eq_refl) Hm (conj Hk' Hd)) as (yy & F1 &
        F2).
    exists (states mu N t y v), yy; auto.
  - intros m dd mu n N D r x yy x' yy' t y v t' y' v' HW HZ HG Hm Hk' Hd _ _ F1 F2 T1 T2 Ex.
    assert (Hdd : Rabs mu <= dd) by (pose proof (Rabs_pos mu); assert (1 * r <= Kf * r) by (apply Rmult_le_compat_r;
        lra); lra).
    exact (same_motion m dd mu n N D HW HZ HG Hdd x yy x' yy' t y v t' y' v' F1 F2 T1 T2 Ex).
  - intros u v Hu; rewrite I1, I2, I3 in Hu; destruct (chain_exists k 0 u v Hu) as (z' & w' & C & <- & <-); exists (z'
      k), (w' k); split; [|apply H1, C]. split; [apply Lk, C; lia|]; split; [exact (HC 0 z' w' C 0%nat ltac:(lia)) |
      exact (HC 0 z' w' C 1%nat ltac:(lia))].
  - rewrite I1, I2, I3; apply Hz; lia.
  - split; [rewrite I1, I2, I3; apply Hz; lia|]; split; [rewrite <- Ez at 1; exact (HC 1 z w Hz 0%nat ltac:(lia)) |
      rewrite <- Ew at 1; exact (HC 1 z w Hz 1%nat ltac:(lia))].
Qed.
End Round.
