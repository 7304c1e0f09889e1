(** * Proof that (52) and (64) decide which words linear oscillators have near grazing *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import Defs StatementOrbitsPlane StatementOscillator Derivatives Flow PlaneLinear OscillatorTurns
  OscillatorStop OscillatorGap OscillatorLaw OscillatorMotion.
Open Scope R_scope.

Lemma sign_over s g a f : sgn g * a > 0 -> (sgn s * sgn g * f > 0 -> sgn s * (f / a) > 0) /\
  (sgn s * sgn g * f < 0 -> sgn s * (f / a) < 0).
Proof.
  intros H; assert (N : a <> 0) by (intros ->; lra).
  assert (E : sgn s * (f / a) = sgn s * sgn g * f * / (sgn g * a)) by (destruct g; cbn in *; field; exact N).
  rewrite E; assert (P : 0 < / (sgn g * a)) by (apply Rinv_0_lt_compat, H); split; intros Hs.
  - apply Rmult_lt_0_compat; assumption.
  - assert (0 < - (sgn s * sgn g * f) * / (sgn g * a)) by (apply Rmult_lt_0_compat; lra); lra.
Qed.

Lemma sign_abs s x : 0 < sgn s * x -> x = sgn s * Rabs x.
Proof. intros H; destruct s; cbn in *; [rewrite Rabs_pos_eq by lra | rewrite Rabs_left by lra]; lra. Qed.

(** x is within e of y, which is 0 or at least 2 e away from it. *)
Lemma sign_near s x y e : Rabs (x - y) <= e -> (y <> 0 -> 2 * e <= Rabs y) ->
  (sgn s * y > 0 -> e <= sgn s * x) /\ (sgn s * y < 0 -> sgn s * x <= - e).
Proof.
  intros H Hy; apply le_abs in H; split; intros Hs; assert (Ny : y <> 0) by (intros ->; lra); specialize (Hy Ny);
    destruct s; cbn in *; revert Hy; unfold Rabs; destruct Rcase_abs; lra.
Qed.

Section Words.
Variables (O : Oscillator.t) (m : sign) (a1 a2 gamma : R) (S V : R -> R).
Notation c := (Oscillator.c O).
Notation k := (Oscillator.k O).
Notation T := (turn m).
Hypothesis HO : grazing O m a1 a2 gamma.
Hypothesis HS : flow c k S V.
Variables (n_max : nat) (K mu h eps : R) (N : Z -> Z) (n : Z -> nat) (s g : sign).
Hypothesis HK : bounds c k m S V n_max K.
Hypothesis Hmu : 0 < sgn s * mu.
Hypothesis HN : forall i, N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\ (1 <= n i <= n_max)%nat /\ u a1 a2 (n i) <> 0.
Hypothesis Near : forall i x y, Rabs x <= h -> Rabs y <= h -> leg_near O m S V n_max (n i) eps mu x y.
Hypothesis Hg : sgn g * gamma > 0.
Hypothesis Heps : 0 < eps.
Hypothesis Mb : forall i j, (j <= n_max)%nat -> b a1 a2 (n i) j <> 0 -> 2 * eps <= Rabs (b a1 a2 (n i) j).
Hypothesis Mf : forall i j, let f := follows a1 a2 (n i) (n j) / gamma in f <> 0 -> 4 * eps <= Rabs f.
Let HA := is_matrix _ _ _ _ _ HO.
Let Hgam : gamma <> 0 := is_generic _ _ _ _ _ HO.
Let HT := is_touching _ _ _ _ _ HO.

Lemma all_regular i : regular m S n_max (n i).
Proof.
  destruct (HN i) as (_ & H & Hu); split; [exact H|]; rewrite (turned_S c k m S V HS a1 a2 gamma HA).
  apply Rmult_integral_contrapositive; auto.
Qed.
Lemma words i : N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\ regular m S n_max (n i).
Proof. split; [apply HN | apply all_regular]. Qed.
Lemma mu_not_0 : mu <> 0.
Proof. intros ->; lra. Qed.

Section Solution.
Variable x : Z -> R.
Hypothesis Hx : forall i, Rabs (x i) <= h.
Let place_of i j := mid O m S V (n i) j mu (x i) (x (i + 1)%Z).
Let jump i := aft O m S V (n (i + 1)%Z) mu (x (i + 1)%Z) (x (i + 1 + 1)%Z) - bef O m S V (n i) mu (x i) (x (i + 1)%Z).

Lemma jump_sign i : (sgn s * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) > 0 -> 0 < mu * jump i) /\
  (sgn s * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) < 0 -> mu * jump i < 0).
Proof.
  destruct (Near i (x i) (x (i + 1)%Z) (Hx _) (Hx _)) as [_ _ Hb _ _].
  destruct (Near (i + 1)%Z (x (i + 1)%Z) (x (i + 1 + 1)%Z) (Hx _) (Hx _)) as [_ Ha _ _ _].
  pose proof (limit_follows c k m S V HS a1 a2 gamma HA (n i) (n (i + 1)%Z) Hgam (proj2 (proj2 (HN i)))
    (proj2 (proj2 (HN (i + 1)%Z))) (proj1 (proj1 (proj2 (HN i))))) as E.
  destruct (sign_near s (jump i) (follows a1 a2 (n i) (n (i + 1)%Z) / gamma) (2 * eps)) as [P Q].
  { rewrite <- E; unfold jump; match goal with |- Rabs (?a - ?p - (?a' - ?p')) <= _ =>
      replace (a - p - (a' - p')) with ((a - a') - (p - p')) by ring end.
    eapply Rle_trans; [apply apart|]; lra. }
  { intros H; specialize (Mf i (i + 1)%Z H); lra. }
  destruct (sign_over s g gamma (follows a1 a2 (n i) (n (i + 1)%Z)) Hg) as [P' Q'].
  rewrite (sign_abs s mu Hmu); pose proof (Rabs_pos_lt mu mu_not_0) as R; split; intros H.
  - replace (sgn s * Rabs mu * jump i) with (Rabs mu * (sgn s * jump i)) by ring.
    apply Rmult_lt_0_compat; [exact R|]; specialize (P (P' H)); lra.
  - assert (0 < Rabs mu * - (sgn s * jump i)) by (apply Rmult_lt_0_compat; [exact R|]; specialize (Q (Q' H)); lra);
      lra.
Qed.

Lemma here_mid i j : facing m (Z.of_nat j) * here O m S V mu n x i (T * INR j) = mu * place_of i j.
Proof.
  unfold here, moved, place_of, mid, turned; replace (T * INR j + - (mu * x i)) with (T * INR j - mu * x i)
    by ring; ring.
Qed.

Lemma mid_sign i j : (1 <= j <= n i - 1)%nat ->
  (sgn s * b a1 a2 (n i) j > 0 -> eps * Rabs mu <= facing m (Z.of_nat j) * here O m S V mu n x i (T * INR j) + mu) /\
  (sgn s * b a1 a2 (n i) j < 0 -> facing m (Z.of_nat j) * here O m S V mu n x i (T * INR j) + mu < 0).
Proof.
  intros Hj; destruct (HN i) as (_ & Hn & Hu); destruct (Near i (x i) (x (i + 1)%Z) (Hx _) (Hx _)) as [_ _ _ _ Hm].
  specialize (Hm j ltac:(lia)); fold (place_of i j) in Hm.
  pose proof (limit_b c k m S V HS a1 a2 gamma HA (n i) j Hgam Hu ltac:(lia)) as E; fold (mid0 O m S V (n i) j) in E.
  destruct (sign_near s (place_of i j + 1) (b a1 a2 (n i) j) eps) as [P Q].
  { rewrite <- E; replace (_ - _) with (place_of i j - mid0 O m S V (n i) j) by ring; exact Hm. }
  { apply Mb; lia. }
  rewrite here_mid; replace (mu * place_of i j + mu) with (mu * (place_of i j + 1)) by ring.
  rewrite (sign_abs s mu Hmu) at 2 3; pose proof (Rabs_pos_lt mu mu_not_0) as R.
  replace (sgn s * Rabs mu * (place_of i j + 1)) with (sgn s * (place_of i j + 1) * Rabs mu) by ring; split; intros H.
  - apply Rmult_le_compat_r; [lra | apply P, H].
  - assert (0 < - (sgn s * (place_of i j + 1)) * Rabs mu) by (apply Rmult_lt_0_compat; [specialize (Q H)|]; lra); lra.
Qed.
End Solution.

(** Every motion comes from a solution of the law, and satisfies (52) and (64) as far as they are decided. *)
Lemma motion_solution d t q v : motion O m mu d N t q v -> (forall i, Rabs (phase m N t i) <= h * Rabs mu) ->
  exists x, (forall i, Rabs (x i) <= h) /\ law O m S V n mu x /\ (forall i, t i = at_ m mu N x i /\
  forall y, q i y = leg_q O m S V mu N n x i y /\ v i y = leg_v O m S V mu N n x i y).
Proof.
  intros HM Hp; destruct (motion_law O m S V (is_restitution _ _ _ _ _ HO)
    HS n_max mu h eps N n mu_not_0 words Near d t q v HM Hp)
    as (Sx & L & Vx); set (x := fun i => phase m N t i / mu) in *.
  exists x; split; [exact Sx|]; split; [exact L|]; intros i.
  assert (Et : t i = at_ m mu N x i) by (unfold at_, x, phase; field; apply mu_not_0).
  split; [exact Et|]; intros y; destruct (Vx i) as (Eq & Ev & _); destruct (HM i _ eq_refl) as (F & _).
  destruct (free_moved c k S V HS _ _ (t i) y F) as [-> ->]; rewrite Eq, Ev, Et; split; reflexivity.
Qed.

Lemma word_fails i : (exists j, (1 <= j <= n i - 1)%nat /\ sgn s * b a1 a2 (n i) j < 0) \/
  sgn s * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) < 0 -> forall d t q v, h * Rabs mu <= 1 ->
  motion O m mu d N t q v -> (forall i, Rabs (phase m N t i) <= h * Rabs mu) -> False.
Proof.
  intros Hs d t q v H1 HM Hp.
  destruct (motion_law O m S V (is_restitution _ _ _ _ _ HO)
    HS n_max mu h eps N n mu_not_0 words Near d t q v HM Hp) as (Sx & _ & Vx).
  destruct Hs as [(j & Hj & Hs)|Hs].
  - destruct (motion_solution d t q v HM Hp) as (x & Hx & _ & E); destruct (mid_sign x Hx i j Hj) as [_ Q];
      specialize (Q Hs).
    destruct (HM i _ eq_refl) as (_ & _ & _ & _ & _ & Open & _); pose proof (turn_large m) as HT3.
    assert (At : forall l, - 1 <= t l - T * IZR (N l) <= 1) by (intros l; apply le_abs; specialize (Hp l);
      unfold phase in Hp; lra).
    assert (1 <= INR j <= INR (n i) - 1).
    { split; [apply (le_INR 1); lia|]; pose proof (le_INR (1 + j) (n i) ltac:(lia)) as P; rewrite plus_INR in P;
        cbn in P; lra. }
    assert (T * 1 <= T * INR j <= T * (INR (n i) - 1)) by (split; apply Rmult_le_compat_l; lra).
    assert (E1 := At i); assert (E2 := At (i + 1)%Z); rewrite (proj1 (HN i)), plus_IZR, <- INR_IZR_INZ in E2.
    specialize (Open (N i + Z.of_nat j)%Z (T * IZR (N i) + T * INR j) ltac:(split; lra)).
    replace (gap O m mu (N i + Z.of_nat j) (q i) (T * IZR (N i) + T * INR j)) with
      (gap O m mu (N i + Z.of_nat j) (leg_q O m S V mu N n x i) (T * IZR (N i) + T * INR j)) in Open
      by (unfold gap; rewrite (proj1 (proj2 (E i) _)); reflexivity).
    rewrite (proj1 (gap_here O m S V mu N n x i _ _)) in Open; unfold gap in Open.
    rewrite <- INR_IZR_INZ, Rminus_eq_0, (touch _ HT) in Open; lra.
  - destruct (jump_sign _ Sx i) as [_ Q]; specialize (Q Hs); destruct (Vx i) as (_ & _ & P); lra.
Qed.
End Words.

(** Theorem 1 for oscillators: one d, one mu0 and one K for all words over {n <= n_max : u_n <> 0}. *)
Theorem Word_oscillator : forall O m a1 a2 gamma, grazing O m a1 a2 gamma ->
  forall n_max, exists d mu0 K, d > 0 /\ mu0 > 0 /\ forall (N : Z -> Z) (n : Z -> nat) s g mu,
  (forall i, N (i + 1)%Z = (N i + Z.of_nat (n i))%Z /\ (1 <= n i <= n_max)%nat /\ u a1 a2 (n i) <> 0) ->
  sgn g * gamma > 0 -> 0 < sgn s * mu < mu0 ->
  ((forall i, (forall j, (1 <= j <= n i - 1)%nat -> sgn s * b a1 a2 (n i) j > 0) /\
              sgn s * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) > 0) -> one_motion O m mu d N) /\
  (forall i, (exists j, (1 <= j <= n i - 1)%nat /\ sgn s * b a1 a2 (n i) j < 0) \/
             sgn s * sgn g * follows a1 a2 (n i) (n (i + 1)%Z) < 0 ->
   forall t q v, ~ motion O m mu d N t q v) /\
  forall t q v, motion O m mu d N t q v -> forall i, Rabs (t i - turn m * IZR (N i)) <= K * Rabs mu.
Proof.
  intros O m a1 a2 gamma HO n_max; destruct (flow_exists (Oscillator.c O) (Oscillator.k O)) as (S & V & HS).
  pose proof (is_touching _ _ _ _ _ HO) as HT; pose proof (is_restitution _ _ _ _ _ HO) as Htau.
  destruct (bounded _ _ m S V HS n_max) as (K & HK).
  destruct (phases_small O m S V HT Htau HS n_max K HK) as (d & C & Hd & HC & Small).
  destruct (one_solution O m S V HT Htau n_max K HK) as (h0 & Hh0 & One).
  destruct (legs_near O m S V HT n_max K HK) as (B & HB & Near).
  destruct (margin (fun n j => b a1 a2 n j) (1 + n_max)) as (k1 & K1 & Mb).
  destruct (margin (fun i j => follows a1 a2 i j / gamma) (1 + n_max)) as (k2 & K2 & Mf).
  destruct (two_least (k1 / 2) (k2 / 4) ltac:(lra) ltac:(lra)) as (eps & He & He1 & He2).
  set (h := h0 + C + 1); set (M := 6 * K ^ 5 + eps).
  assert (HM : 0 < M) by (unfold M; destruct HK; pose proof (pow_R1_Rle K 5 ltac:(assumption)); lra).
  set (X := (1 + Rabs (Oscillator.c O) + Rabs (Oscillator.k O)) * (K * 2 + K * M)); assert (HX : 0 < X).
  { destruct HK; pose proof (Rabs_pos (Oscillator.c O)); pose proof (Rabs_pos (Oscillator.k O)).
    apply Rmult_lt_0_compat; [lra|]; apply Rplus_lt_0_compat; apply Rmult_lt_0_compat; lra. }
  destruct (One h ltac:(unfold h; lra)) as (d1 & D1 & Sol), (Near h eps ltac:(unfold h; lra) He) as (d2 & D2 & Leg).
  destruct (gap_open O HT m h X eps ltac:(unfold h; lra) HX He) as (d3 & D3 & Open).
  destruct (two_least d1 d2 ltac:(lra) ltac:(lra)) as (d4 & D4 & L1 & L2).
  destruct (two_least d4 d3 D4 D3) as (d5 & D5 & L3 & L4), (two_least d 1 Hd ltac:(lra)) as (d6 & D6 & L5 & L6).
  destruct (two_least d5 (d6 / h) D5 ltac:(apply Rdiv_lt_0_compat; unfold h; lra)) as (mu0 & Hmu0 & L7 & L8).
  exists d, mu0, C; split; [exact Hd|]; split; [exact Hmu0|]; intros N n s g mu Hw Hg Hmu.
  assert (NZ : mu <> 0) by (intros ->; lra); pose proof (Rabs_pos_lt mu NZ) as R.
  assert (Er : Rabs mu < mu0) by (destruct s; cbn in Hmu; unfold Rabs; destruct Rcase_abs; lra).
  assert (Hr : h * Rabs mu <= d6).
  { apply (Rle_trans _ (h * (d6 / h))); [apply Rmult_le_compat_l; unfold h in *; lra | right; field; unfold h; lra]. }
  assert (Reg : forall i, regular m S n_max (n i)) by (intros i;
    apply (all_regular O m a1 a2 gamma S V HO HS n_max N n Hw)).
  assert (Near' : forall i x y, Rabs x <= h -> Rabs y <= h -> leg_near O m S V n_max (n i) eps mu x y)
    by (intros i x y Hx Hy; apply (Leg (n i) mu x y (Reg i)); trivial; lra).
  assert (Mb' : forall i j, (j <= n_max)%nat -> b a1 a2 (n i) j <> 0 -> 2 * eps <= Rabs (b a1 a2 (n i) j)).
  { intros i j Hj Hne; destruct (Reg i); pose proof (Mb (n i) j ltac:(lia) ltac:(lia) Hne); lra. }
  assert (Mf' : forall i j, let f := follows a1 a2 (n i) (n j) / gamma in f <> 0 -> 4 * eps <= Rabs f).
  { intros i j f Hne; destruct (Reg i), (Reg j); pose proof (Mf (n i) (n j) ltac:(lia) ltac:(lia) Hne) as P;
      fold f in P; lra. }
  assert (Ph : forall t q v, motion O m mu d N t q v -> forall i, Rabs (phase m N t i) <= C * Rabs mu).
  { intros t q v HM'; apply (Small mu N n t q v); [lra | intros i; split; [apply Hw | apply Reg] | exact HM']. }
  assert (Ph' : forall t q v, motion O m mu d N t q v -> forall i, Rabs (phase m N t i) <= h * Rabs mu).
  { intros t q v HM' i; eapply Rle_trans; [apply (Ph t q v HM')|]; apply Rmult_le_compat_r; unfold h; lra. }
  split; [|split; [|exact Ph]].
  - intros Hs; destruct (Sol n mu Reg ltac:(lra)) as (x & Hx & Law & Only).
    exists (at_ m mu N x), (leg_q O m S V mu N n x), (leg_v O m S V mu N n x); split.
    + apply (solution_motion O m S V Htau HS n_max K mu h eps N n HK NZ (fun i => conj (proj1 (Hw i)) (Reg i))
        Near' x Law Hx d M eps);
        try lra.
      * intros i; apply (jump_sign O m a1 a2 gamma S V HO HS n_max mu h eps N n s g (proj1 Hmu)
          Hw Near' Hg He Mf' x Hx i), Hs.
      * intros i; destruct (Near' i (x i) (x (i + 1)%Z) (Hx _) (Hx _)) as [_ A _ _ _]; apply from in A.
        destruct (Reg i) as [Hn HSn]; destruct (one_leg _ _ m S V n_max K HK (n i) 0 0 1 (-1) (-1)) as (_ & A0 & _);
          trivial; try lia; try (rewrite ?Rabs_R0; left; apply Rinv_0_lt_compat; destruct HK; lra);
          try (rewrite Rabs_left; lra).
        change (aft_leg _ _ _ _ _ _ _ _) with (aft0 (Oscillator.c O) m S V (n i)) in A0; unfold M; lra.
      * intros n' q v w phi psi; apply Open; lra.
      * intros i j Hj; apply (mid_sign O m a1 a2 gamma S V HO HS n_max mu h eps N n s (proj1 Hmu)
          Hw Near' He Mb' x Hx i j Hj).
        apply Hs, Hj.
    + intros t' q' v' HM' i y.
      destruct (motion_solution O m a1 a2 gamma S V HO HS n_max mu h eps N n s (proj1 Hmu)
        Hw Near' d t' q' v' HM' (Ph' _ _ _ HM'))
        as (x' & Hx' & Law' & E).
      pose proof (Only x' Hx' Law') as Ex; destruct (E i) as [-> E']; destruct (E' y) as [-> ->].
      unfold leg_q, leg_v, at_; rewrite !Ex; auto.
  - intros i Hs t q v HM'.
    apply (word_fails O m a1 a2 gamma S V HO HS n_max mu h eps N n s g (proj1 Hmu)
      Hw Near' Hg He Mb' Mf' i Hs d t q v); [lra | exact HM' | exact (Ph' t q v HM')].
Qed.
