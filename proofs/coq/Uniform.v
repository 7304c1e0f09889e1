(** * In any dimension the linear problem of all words has one bound, if the flights contract

    The points just before the impacts satisfy Z_j = onward (Z_{j-1}) + known: a contraction of bounded
    families. *)

From Coq Require Import Reals Arith FunctionalExtensionality Lra Lia Classical.
From Grazing Require Import Defs StatementOrbits StatementUniform OrbitVectors Contraction PlaneLinear.
Open Scope R_scope.

Section Uniform.
Variables (M : Map.t) (letters : nat -> Prop) (n_max L : nat).
Hypothesis alphabet : forall n, letters n -> (n <= n_max)%nat /\ crossing M n <> 0.
Hypothesis contracts : contracting M letters L.
Notation N := (Map.N M).
Notation B := (Map.B M).
Notation C := (Map.C M).
Notation power := (power M).
Notation within := (within N).
Notation dot := (dot N).

(** The flight of n steps from x, kicked so that C x = r at its end. *)
Definition kick (n : nat) (r : R) (x : vec) : R := (r - dot C (power n x)) / crossing M n.
Definition flight (n : nat) (r : R) (x : vec) : vec := power n (comb 1 (kick n r x) x B).

Lemma flight_end n r x : crossing M n <> 0 -> dot C (flight n r x) = r.
Proof.
  intros H; unfold flight, StatementOrbits.power; rewrite power_comb, dot_comb; unfold kick, crossing in *.
  unfold StatementOrbits.power in *; field; exact H.
Qed.

Lemma flight_minus n r x y : crossing M n <> 0 -> minus (flight n r x) (flight n r y) = onward M n (minus x y).
Proof.
  intros H; unfold flight, onward, StatementOrbits.power; rewrite <- power_minus; f_equal; extensionality i.
  unfold kick, StatementOrbits.power; rewrite power_minus, dot_minus; unfold minus, comb; field; exact H.
Qed.

(** Bounds over the alphabet. *)
Lemma bounds : exists b, 1 <= b /\ forall n r x t, letters n -> 0 <= t -> Rabs r <= t -> within t x ->
  Rabs (kick n r x) <= b * t /\ within (b * t) (flight n r x).
Proof.
  destruct (power_bound N (Map.A M) n_max) as (m & Hm & Hp), (dot_bound N C) as (c & Hc & Hd).
  destruct (finite_max (fun n => / crossing M n) (S n_max)) as (q & Hq & Hi), (within_exists N B) as (s & Hs & HB).
  set (k := (1 + c * m) * q); assert (Hcm : 0 <= c * m) by (apply Rmult_le_pos; lra).
  assert (Hk : 0 <= k) by (unfold k; apply Rmult_le_pos; lra); assert (Hks : 0 <= k * s) by (apply Rmult_le_pos;
    assumption).
  assert (Hmk : 0 <= m * (1 + k * s)) by (apply Rmult_le_pos; lra).
  exists (1 + k + m * (1 + k * s)); split; [lra|]; intros n r x t Hn Ht Hr Hx; destruct (alphabet n Hn) as [Hmax _].
  assert (HK : Rabs (kick n r x) <= k * t).
  { unfold kick, Rdiv; rewrite Rabs_mult; replace (k * t) with ((t + c * (m * t)) * q) by (unfold k; ring).
    apply Rmult_le_compat; try apply Rabs_pos; [|apply Hi; lia].
    unfold Rminus; eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_Ropp; apply Rplus_le_compat; [assumption|].
    apply Hd, Hp; assumption. }
  split.
  - apply Rle_trans with (k * t); [assumption|]; apply Rmult_le_compat_r; lra.
  - apply within_le with (m * ((1 + k * s) * t)).
    + rewrite <- Rmult_assoc; apply Rmult_le_compat_r; lra.
    + apply Hp; [assumption | apply Rmult_le_pos; lra|].
      apply within_le with (Rabs 1 * t + Rabs (kick n r x) * s); [|apply within_comb; assumption].
      rewrite Rabs_R1; apply Rmult_le_compat_r with (r := s) in HK; [lra | assumption].
Qed.

Lemma within_ext t x y : (forall i, (i < N)%nat -> x i = y i) -> within t x -> within t y.
Proof. intros E H i Hi; rewrite <- E by assumption; apply H, Hi. Qed.

Lemma onward_ext n x y : (forall i, (i < N)%nat -> x i = y i) -> forall i, (i < N)%nat -> onward M n x i = onward M n y
  i.
Proof.
  intros E; unfold onward; apply power_ext; intros i Hi; rewrite (E i Hi).
  rewrite (dot_ext N C (power n x) (power n y)) by (apply power_ext, E); reflexivity.
Qed.
Lemma onward_zero n i : (i < N)%nat -> onward M n zero i = 0.
Proof.
  intros Hi; unfold onward, StatementOrbits.power; rewrite power_zero, dot_zero.
  transitivity (Nat.iter n (mult N (Map.A M)) zero i); [|rewrite power_zero; reflexivity].
  apply power_ext; [|exact Hi]; intros l _; unfold zero, Rdiv; ring.
Qed.

Section Word.
Variables (J : Type) (next prev : J -> J) (n : J -> nat).
Hypothesis Hnext : forall j, prev (next j) = j /\ next (prev j) = j.
Hypothesis Hn : forall j, letters (n j).

Definition back (j : J) (k : nat) : J := Nat.iter k prev j.
Lemma back_S j k : back (prev j) k = back j (S k).
Proof. unfold back; induction k as [|k IH]; [reflexivity | exact (f_equal prev IH)]. Qed.

(** Families that go on without kicks from outside die out. *)
Lemma through_family (D : J -> vec) k : (forall j i, (i < N)%nat -> D j i = onward M (n j) (D (prev j)) i) ->
  forall j i, (i < N)%nat -> D j i = through M k (fun l => n (back j l)) (D (back j k)) i.
Proof.
  intros H; induction k as [|k IH]; intros j i Hi; [reflexivity|]; cbn [through]; rewrite (H j i Hi).
  apply onward_ext; [|assumption]; intros l Hl; rewrite (IH (prev j) l Hl), back_S.
  replace (fun l0 => n (back (prev j) l0)) with (fun l0 => n (back j (S l0))); [reflexivity|].
  extensionality l0; rewrite back_S; reflexivity.
Qed.

Lemma halves_out (D : J -> vec) t : (forall j, within t (D j)) ->
  (forall j i, (i < N)%nat -> D j i = through M L (fun l => n (back j l)) (D (back j L)) i) -> forall j, within 0 (D j).
Proof.
  intros Ht HD; assert (H : forall m j, within (t / 2 ^ m) (D j)).
  { induction m as [|m IH]; intros j; [cbn [pow]; rewrite div_1; apply Ht|].
    apply (within_ext _ (through M L (fun l => n (back j l)) (D (back j L)))).
    - intros i Hi; symmetry; apply HD; assumption.
    - replace (t / 2 ^ S m) with (t / 2 ^ m / 2) by (cbn [pow]; field; apply pow_nonzero; lra).
      apply contracts; [intros; apply Hn | apply IH]. }
  intros j i Hi; apply (squeeze _ 0 t); intros m; rewrite Rplus_0_l; apply H, Hi.
Qed.

Lemma dies_out (D : J -> vec) t : (forall j, within t (D j)) ->
  (forall j i, (i < N)%nat -> D j i = onward M (n j) (D (prev j)) i) -> forall j, within 0 (D j).
Proof. intros Ht HD; apply (halves_out D t Ht), through_family, HD. Qed.

Lemma kernel_trivial t X Y : bounded M J t X Y -> linear M J next n X Y (fun _ => zero) (fun _ => 0) ->
  bounded M J 0 X Y.
Proof.
  intros Hb Hl; destruct bounds as (b & Hb1 & Hbd); set (Z := fun j => power (n j) (X j)).
  assert (Ht : J -> 0 <= t) by (intros j; apply Rle_trans with (Rabs (Y j)); [apply Rabs_pos | apply Hb]).
  assert (EX : forall j i, (i < N)%nat -> X (next j) i = comb 1 (Y j) (Z j) B i).
  { intros j i Hi; destruct (Hl j) as [_ H]; specialize (H i Hi); unfold zero in H; unfold comb, Z; lra. }
  assert (EY : forall j, Y j = kick (n (next j)) 0 (Z j)).
  { intros j; destruct (Hl (next j)) as [H _]; destruct (alphabet _ (Hn (next j))) as [_ Hc].
    assert (E : dot C (power (n (next j)) (comb 1 (Y j) (Z j) B)) = 0).
    { rewrite <- H; apply dot_ext, power_ext; intros i Hi; symmetry; apply EX, Hi. }
    unfold StatementOrbits.power in E; rewrite power_comb, dot_comb in E; unfold kick, crossing, StatementOrbits.power
      in *.
    apply (Rmult_eq_reg_r (dot C (Nat.iter (n (next j)) (mult N (Map.A M)) B))); [|exact Hc]; field_simplify;
      [lra | exact Hc]. }
  assert (EZ : forall j i, (i < N)%nat -> Z j i = onward M (n j) (Z (prev j)) i).
  { intros j; apply power_ext; intros i Hi; rewrite <- (proj2 (Hnext j)) at 1; rewrite (EX (prev j) i Hi), EY,
      (proj2 (Hnext j)).
    unfold comb, kick; destruct (alphabet _ (Hn j)) as [_ Hc]; field; exact Hc. }
  assert (Z0 : forall j, within 0 (Z j)).
  { destruct (power_bound N (Map.A M) n_max) as (m & Hm & Hp).
    apply (dies_out Z (m * t)); [|exact EZ]; intros j; apply Hp; [apply alphabet, Hn | apply Ht, j | apply Hb]. }
  assert (Y0 : forall j, Rabs (Y j) <= 0).
  { intros j; rewrite EY; apply Rle_trans with (b * 0); [|lra].
    apply Hbd; [apply Hn | lra | rewrite Rabs_R0; lra | apply Z0]. }
  intros j; split; [|apply Y0]; rewrite <- (proj2 (Hnext j)).
  apply (within_ext _ (comb 1 (Y (prev j)) (Z (prev j)) B)); [intros i Hi; symmetry; apply EX, Hi|].
  destruct (within_exists N B) as (s & Hs & HB); specialize (Y0 (prev j)).
  apply within_le with (Rabs 1 * 0 + Rabs (Y (prev j)) * s); [|apply within_comb; [apply Z0 | exact HB]].
  pose proof (Rabs_pos (Y (prev j))); replace (Rabs (Y (prev j))) with 0 by lra; lra.
Qed.

(** Existence: families as numbers indexed by J and the coordinates. *)
Variables (Q : J -> vec) (r : J -> R) (t : R).
Hypothesis HQ : bounded M J t Q r.
Definition family (z : J * nat -> R) (j : J) : vec := fun i => z (j, i).
Definition F (z : J * nat -> R) (p : J * nat) : R := let (j, i) := p in flight (n j) (r j) (comb 1 1 (family z (prev j))
  (Q (prev j))) i.
Let P (p : J * nat) : Prop := (snd p < N)%nat.
Let o : J * nat -> R := fun _ => 0.

Lemma F_minus z z' j : minus (family (F z) j) (family (F z') j) = onward M (n j) (minus (family z (prev j))
  (family z' (prev j))).
Proof.
  change (minus (flight (n j) (r j) (comb 1 1 (family z (prev j)) (Q (prev j))))
    (flight (n j) (r j) (comb 1 1 (family z' (prev j)) (Q (prev j)))) = onward M (n j) (minus (family z (prev j))
    (family z' (prev j)))).
  rewrite flight_minus by (apply alphabet, Hn); f_equal; extensionality i; unfold minus, comb; ring.
Qed.

Lemma iter_minus k z z' : forall j, minus (family (Nat.iter k F z) j) (family (Nat.iter k F z') j) =
  through M k (fun l => n (back j l)) (minus (family z (back j k)) (family z' (back j k))).
Proof.
  induction k as [|k IH]; intros j; [reflexivity|].
  change (minus (family (F (Nat.iter k F z)) j) (family (F (Nat.iter k F z')) j) = onward M (n j)
    (through M k (fun l => n (back j (S l))) (minus (family z (back j (S k))) (family z' (back j (S k)))))).
  rewrite F_minus, IH, back_S; f_equal; f_equal; extensionality l; rewrite back_S; reflexivity.
Qed.
Variable b : R.
Hypothesis b_1 : 1 <= b.
Hypothesis b_bounds : forall n r x t, letters n -> 0 <= t -> Rabs r <= t -> within t x ->
  Rabs (kick n r x) <= b * t /\ within (b * t) (flight n r x).

(** What k flights from 0 can reach, in units of t. *)
Fixpoint reach (k : nat) : R := match k with O => 0 | S k => b * (reach k + 1) end.
Lemma reach_pos k : 0 <= reach k.
Proof. induction k as [|k IH]; cbn [reach]; [lra | apply Rmult_le_pos; lra]. Qed.

Lemma arrival_bound (Z : J -> vec) c j : 0 <= c -> 0 <= t -> within (c * t) (Z (prev j)) ->
  let x := comb 1 1 (Z (prev j)) (Q (prev j)) in within ((c + 1) * t) x /\
  Rabs (kick (n j) (r j) x) <= b * ((c + 1) * t) /\ within (b * ((c + 1) * t)) (flight (n j) (r j) x).
Proof.
  intros Hc Ht HZ x; assert (Hct : 0 <= c * t) by (apply Rmult_le_pos; assumption); destruct (HQ (prev j)) as [HQj _].
  assert (Hx : within ((c + 1) * t) x).
  { apply within_le with (Rabs 1 * (c * t) + Rabs 1 * t); [rewrite Rabs_R1; lra | apply within_comb; assumption]. }
  split; [assumption | apply b_bounds; [apply Hn | lra | | assumption]]; destruct (HQ j) as [_ Hr]; lra.
Qed.

Lemma iter_reach k : 0 <= t -> near (J * nat) P (reach k * t) (Nat.iter k F o) o.
Proof.
  intros Ht; induction k as [|k IH]; intros [j i] Hi; unfold P in Hi; cbn [snd] in Hi.
  - change (Rabs (0 - 0) <= 0 * t); rewrite Rminus_0_r, Rabs_R0; lra.
  - unfold o at 2; rewrite Rminus_0_r; replace (reach (S k) * t) with (b * ((reach k + 1) * t)) by (cbn [reach]; ring).
    destruct (arrival_bound (family (Nat.iter k F o)) (reach k) j) as (_ & _ & H); [apply reach_pos | assumption | |
      exact (H i Hi)].
    intros l Hl; specialize (IH (prev j, l) Hl); unfold o at 2 in IH; rewrite Rminus_0_r in IH; exact IH.
Qed.

Lemma solvable : exists X Y, linear M J next n X Y Q r /\ forall s, 0 <= s -> within s B ->
  bounded M J ((2 * reach L + 1) * (1 + b + b * s) * t) X Y.
Proof.
  destruct (classic (exists j : J, True)) as [[j0 _]|Empty].
  2: { exists (fun _ => zero), (fun _ => 0); split; [intros j | intros s _ _ j]; exfalso; eauto. }
  assert (Ht : 0 <= t) by (apply Rle_trans with (Rabs (r j0)); [apply Rabs_pos | apply HQ]).
  pose proof (reach_pos L) as Hc; set (c := reach L) in *; set (d := 2 * c * t).
  assert (Hd : 0 <= d) by (unfold d; apply Rmult_le_pos; lra).
  assert (HT : forall e z z', near _ P d z o -> near _ P d z' o -> near _ P e z z' -> near _ P (e / 2) (Nat.iter L F z)
    (Nat.iter L F z')).
  { intros e z z' _ _ He [j i] Hi; change (Rabs (minus (family (Nat.iter L F z) j) (family (Nat.iter L F z') j) i) <= e
      / 2).
    rewrite iter_minus; refine (contracts (fun l => n (back j l)) e _ _ _ i Hi); [intros; apply Hn|].
    intros l Hl; exact (He (back j L, l) Hl). }
  assert (H0 : near _ P (d / 2) (Nat.iter L F o) o) by (replace (d / 2) with (c * t) by (unfold d; field);
    apply iter_reach, Ht).
  destruct (contraction (J * nat) P (Nat.iter L F) d Hd HT H0) as (z & Hz & Hfix & _); set (Z := family z).
  assert (HZ : forall j, within (2 * c * t) (Z j)).
  { intros j i Hi; specialize (Hz (j, i) Hi); unfold o in Hz; rewrite Rminus_0_r in Hz; exact Hz. }
  assert (EZ : forall j i, (i < N)%nat -> flight (n j) (r j) (comb 1 1 (Z (prev j)) (Q (prev j))) i = Z j i).
  { set (D := fun j => minus (family (F z) j) (family z j)).
    assert (HD : forall j, within 0 (D j)).
    { apply (halves_out D (b * ((2 * c + 1) * t) + 2 * c * t)).
      - intros j; apply within_minus; [|apply HZ]; apply (arrival_bound Z (2 * c) j); [lra | assumption | apply HZ].
      - intros j i Hi; unfold D; rewrite <- (iter_minus L (F z) z j); unfold minus.
        replace (family (Nat.iter L F z) j i) with (family z j i) by (symmetry; exact (Hfix (j, i) Hi)).
        f_equal; assert (E : forall k, Nat.iter k F (F z) = F (Nat.iter k F z)).
        { induction k as [|k IH]; [reflexivity | exact (f_equal F IH)]. }
        rewrite E; apply Rminus_diag_uniq; change (family (F z) j i - family (F (Nat.iter L F z)) j i)
          with (minus (family (F z) j) (family (F (Nat.iter L F z)) j) i); rewrite F_minus.
        rewrite (onward_ext (n j) _ zero); [apply onward_zero; assumption | | assumption].
        intros l Hl; unfold minus, zero; replace (family (Nat.iter L F z) (prev j) l) with (family z (prev j) l)
          by (symmetry; exact (Hfix (prev j, l) Hl)); ring. }
    intros j i Hi; specialize (HD j i Hi); apply Rabs_zero in HD; unfold D, minus in HD; apply Rminus_diag_uniq in HD;
      exact HD. }
  set (x := fun j => comb 1 1 (Z (prev j)) (Q (prev j))); set (k := fun j => kick (n j) (r j) (x j)).
  exists (fun j => comb 1 (k j) (x j) B), (fun j => k (next j)); split.
  - intros j; split; [apply flight_end, alphabet, Hn|]; intros i Hi.
    change (power (n j) (comb 1 (k j) (x j) B) i) with (flight (n j) (r j) (x j) i); unfold x at 2;
      rewrite EZ by assumption.
    unfold comb, x, comb; rewrite (proj1 (Hnext j)); ring.
  - intros s Hs HB j; pose proof (fun j => arrival_bound Z (2 * c) j ltac:(lra) Ht (HZ (prev j))) as HA.
    assert (Hct : 0 <= (2 * c + 1) * t) by (apply Rmult_le_pos; lra); set (g := (2 * c + 1) * t) in *.
    replace ((2 * c + 1) * (1 + b + b * s) * t) with (g + b * g + b * g * s) by (unfold g; ring).
    assert (Hbg : 0 <= b * g) by (apply Rmult_le_pos; lra); assert (0 <= b * g * s) by (apply Rmult_le_pos; lra); split.
    + destruct (HA j) as (Hx & Hk & _); apply within_le with (Rabs 1 * g + Rabs (k j) * s);
        [|apply within_comb; assumption].
      rewrite Rabs_R1; apply Rmult_le_compat_r with (r := s) in Hk; [|assumption]; unfold k, x in *; lra.
    + destruct (HA (next j)) as (_ & Hk & _); unfold k, x; lra.
Qed.
End Word.

Lemma uniform : exists K, forall (J : Type) (next prev : J -> J) n, (forall j, prev (next j) = j /\ next (prev j) = j)
  -> (forall j, letters (n j)) -> invertible M J next n K.
Proof.
  destruct bounds as (b & Hb & Hbd), (within_exists N B) as (s & Hs & HB).
  exists ((2 * reach b L + 1) * (1 + b + b * s)); intros J next prev n Hnext Hn; split.
  - intros t Q r HQ; destruct (solvable J next prev n Hnext Hn Q r t HQ b Hb Hbd) as (X & Y & Hl & HXY); exists X, Y;
      auto.
  - intros t X Y; apply (kernel_trivial J next prev n Hnext Hn).
Qed.
End Uniform.

Theorem Uniform : Uniform_statement. Proof. exact uniform. Qed.
