(** * The orbits of a map with one impact in n steps, near grazing: one for each small speed y of the impact

    (19) is solved for mu and the point, with y given. The unknowns are one vector z: mu, and then the point less
    mu w. *)
From Coq Require Import Reals FunctionalExtensionality Lra Lia Arith.
From Grazing Require Import StatementOrbits StatementResonance StatementFold Finite OrbitVectors Contraction.
From Grazing Require Import OrbitRemainder OrbitFixedPoint Orbits SquareSystems Derivatives.
Open Scope R_scope.

(** |a| <= e is |b| <= e, where a = b by [ring]. *)
Ltac same_as H := match goal with |- Rabs ?a <= _ => match type of H with Rabs ?b <= _ =>
  replace a with b by ring; exact H end end.

Section Curve.
Variables (M : Map.t) (w : vec) (e : R) (n : nat) (V : vec).
Notation N := (Map.N M).
Notation pow k x := (Nat.iter k (mult N (Map.A M)) x).
Notation C := (dot N (Map.C M)).
Hypothesis Z0 : forall k, Map.h M (fly M 0 k zero) 0 = 0 /\ forall i, (i < N)%nat -> fly M 0 k zero i = 0.
Hypothesis Ne : e <> 0.
Hypothesis Hdet : forall x, (forall i, (i < N)%nat -> x i = pow n x i) -> forall i, (i < N)%nat -> x i = 0.
Hypothesis HV : forall i, (i < N)%nat -> V i = pow n V i + Map.B M i.
Notation v k := (C (pow k V)).
Notation hit k mu x := (Map.h M (fly M mu k x) mu).

(** ** The linear part *)
Definition left (z : vec) : vec := rows (C (pow n (hat z)) + z O * e) (minus (hat z) (pow n (hat z))).
Lemma within_S t z : within (S N) t z <-> Rabs (z O) <= t /\ within N t (hat z).
Proof.
  split; [intros H; split; [apply H | intros i Hi; apply H]; lia|]; intros [H0 H] [|i] Hi; [exact H0 | apply H; lia].
Qed.
Lemma left_comb a b x y i : left (comb a b x y) i = a * left x i + b * left y i.
Proof.
  unfold left; change (hat (comb a b x y)) with (comb a b (hat x) (hat y)); rewrite power_comb, dot_comb.
  destruct i; unfold rows, minus, comb; ring.
Qed.
Lemma left_ext x y : (forall i, (i < S N)%nat -> x i = y i) -> forall i, (i < S N)%nat -> left x i = left y i.
Proof.
  intros H; assert (P : forall i, (i < N)%nat -> pow n (hat x) i = pow n (hat y) i) by (apply power_ext; intros; apply
    H; lia). intros [|i] Hi; unfold left, rows, minus.
  - rewrite (dot_ext N _ _ _ P), H by lia; reflexivity.
  - rewrite P by lia; unfold hat at 1 3; rewrite H by lia; reflexivity.
Qed.
Lemma left_kernel x : (forall i, (i < S N)%nat -> left x i = 0) -> forall i, (i < S N)%nat -> x i = 0.
Proof.
  intros H; assert (X : forall i, (i < N)%nat -> hat x i = 0).
  { apply Hdet; intros i Hi; specialize (H (S i) ltac:(lia)); unfold left, rows, minus in H; lra. }
  intros [|i] Hi; [|apply X; lia]; specialize (H O ltac:(lia)); unfold left, rows in H.
  rewrite (dot_ext N _ _ zero), dot_zero in H; [apply (Rmult_eq_reg_r e); lra|].
  intros i Hi'; rewrite (power_ext N (Map.A M) n (hat x) zero X i Hi'), power_zero; reflexivity.
Qed.

(** Its inverse, bounded by K. *)
Definition solved (Q : vec) : vec := fun i => the (fun a => exists x,
  (forall k, (k < S N)%nat -> left x k = Q k) /\ a = x i).
Definition inverse_bound (K : R) : Prop := 1 <= K /\
  (forall t x, 0 <= t -> within (S N) t (left x) -> within (S N) (K * t) x) /\
  forall Q x, (forall i, (i < S N)%nat -> x i = solved Q i) -> forall k, (k < S N)%nat -> left x k = Q k.
Lemma inverse_exists : exists K, inverse_bound K.
Proof.
  destruct (linear_map_bounded (S N) left) as (K & HK & H); [intros; apply left_comb | exact left_ext | exact
    left_kernel|].
  assert (U : forall Q x y, (forall k, (k < S N)%nat -> left x k = Q k) -> (forall k, (k < S N)%nat -> left y k = Q k)
    -> forall i, (i < S N)%nat -> y i = x i).
  { intros Q x y Hx Hy i Hi; apply Rminus_diag_uniq; change (y i - x i) with (minus y x i); revert i Hi;
    apply left_kernel. intros i Hi; rewrite minus_comb, left_comb, Hy, Hx by exact Hi; ring. }
  exists (1 + K); split; [lra|]; split.
  - intros t x Ht Hx; destruct (H (left x) t Hx Ht) as (y & Hy & E); intros i Hi.
    rewrite (U (left x) y x E (fun _ _ => eq_refl) i Hi); apply (Rle_trans _ (K * t)); [apply Hy, Hi | lra].
  - intros Q x Hx; destruct (within_exists (S N) Q) as (t & Ht & HQ), (H Q t HQ Ht) as (y & _ & E); intros k Hk.
    rewrite (left_ext x y); [apply E, Hk | | exact Hk]; intros i Hi; rewrite Hx by exact Hi; apply the_spec; [exists y;
      auto|]. intros a (x' & E' & ->); apply (U Q); assumption.
Qed.

(** ** (19) at the speed y *)
Definition point (z : vec) : vec := comb 1 (z O) (hat z) w.
Definition right (y : R) (z : vec) : vec := rows (rest2 M (z O) n (point z) y + z O * (e - C (pow n w)))
  (fun i => y * Map.B M i + (rest1 M (z O) n (point z) y i - z O * (w i - pow n w i))).
Definition solves (y : R) (z : vec) : Prop := forall i, (i < S N)%nat -> left z i = right y z i.
Definition kicked (y : R) : vec := rows 0 (fun i => y * Map.B M i).
Definition of (mu : R) (x : vec) : vec := rows mu (fun i => x i - mu * w i).
Lemma point_of mu x : point (of mu x) = x.
Proof. extensionality i; unfold point, comb, hat, of, rows; ring. Qed.
Lemma solves_is y z : 0 <= y -> solves y z <-> hit n (z O) (point z) = - (y * y) /\ forall i, (i < N)%nat ->
  point z i = fly M (z O) n (point z) i + Map.kick M (fly M (z O) n (point z)) (Rabs y) (z O) i * y.
Proof.
  intros Hy; assert (P : pow n (point z) = comb 1 (z O) (pow n (hat z)) (pow n w)) by apply power_comb.
  assert (E1 : forall i, left z (S i) = right y z (S i) <-> point z i = fly M (z O) n (point z) i + Map.kick M (fly M (z
    O) n (point z)) (Rabs y) (z O) i * y).
  { intros i; unfold left, right, rows, rest1, minus, power; rewrite P; unfold comb.
    assert (pz : point z i = 1 * hat z i + z O * w i) by reflexivity; split; intros E; lra. }
  assert (E2 : left z O = right y z O <-> hit n (z O) (point z) = - (y * y)).
  { unfold left, right, rows, rest2, power; rewrite P, dot_comb; split; intros E; lra. }
  split; [intros H; split; [apply E2, H; lia | intros i Hi; apply E1, H; lia]|].
  intros [H1 H2] [|i] Hi; [apply E2, H1 | apply E1, H2; lia].
Qed.

Lemma right_zero i : (i < S N)%nat -> right 0 zero i = 0.
Proof.
  assert (P0 : point zero = zero) by (extensionality j; unfold point, comb, hat, zero; ring).
  intros Hi; destruct i as [|i]; unfold right, rows; rewrite P0; change (zero O) with 0.
  - unfold rest2, power; rewrite (proj1 (Z0 n)), power_zero, dot_zero; ring.
  - unfold rest1, power; rewrite (proj2 (Z0 n) i) by lia; rewrite power_zero; unfold zero; ring.
Qed.
Lemma zero_solves : solves 0 zero.
Proof.
  intros i Hi; rewrite right_zero by exact Hi; unfold left; change (hat zero) with zero; rewrite power_zero, dot_zero.
  destruct i; unfold rows, minus, zero; ring.
Qed.

(** What remains on a ball of radius d; t bounds z, and y. *)
Record small (W eps d : R) : Prop := {
  small_two : forall y y' z z' t, 0 <= y <= d -> 0 <= y' <= d -> within (S N) d z -> within (S N) d z' -> 0 <= t ->
    within (S N) t (minus z z') -> Rabs (y - y') <= t ->
    within (S N) (eps * t) (minus (minus (right y z) (kicked y)) (minus (right y' z') (kicked y')));
  small_one : forall y z t, 0 <= y <= d -> within (S N) d z -> within (S N) t z -> y <= t ->
    within (S N) (eps * t) (minus (right y z) (kicked y)) /\
    forall k, (k <= n)%nat -> Rabs (hit k (z O) (point z) - C (pow k (hat z)) - z O * e) <= eps * t }.
Lemma point_within W z t : within N W w -> within (S N) t z -> within N ((1 + W) * t) (point z).
Proof.
  intros Wb Hz i Hi; unfold point, comb; rewrite Rmult_1_l, Rmult_plus_distr_r, Rmult_1_l, (Rmult_comm W).
  apply triangle2; [apply (Hz (S i)); lia | apply Rabs_mult_le; [apply Hz; lia | apply Wb, Hi]].
Qed.
Lemma small_of W eps d d1 : 0 <= W -> within N W w -> 0 < d -> (1 + W) * d <= d1 ->
  remainder M w e n (eps / (1 + W)) d1 -> small W eps d.
Proof.
  intros HW Wb Hd D1 Rem.
  assert (Up : forall t, 0 <= t -> t <= (1 + W) * t) by (intros t Ht; assert (0 <= W * t) by (apply Rmult_le_pos; lra);
    lra). pose proof (Up d ltac:(lra)) as Ud; assert (Pt := fun z t => point_within W z t Wb).
  assert (Two : forall y y' z z' t, 0 <= y <= d -> 0 <= y' <= d -> within (S N) d z -> within (S N) d z' -> 0 <= t ->
    within (S N) t (minus z z') -> Rabs (y - y') <= t -> within (S N) (eps * t) (minus (minus (right y z) (kicked y))
    (minus (right y' z') (kicked y'))) /\ forall k, (k <= n)%nat -> Rabs (hit k (z O) (point z) - hit k (z' O) (point
    z') - C (pow k (hat (minus z z'))) - (z O - z' O) * e) <= eps * t).
  { intros y y' z z' t Hy Hy' Hz Hz' Ht Hzz Hyy.
    assert (Ep : forall i, minus (point z) (point z') i = point (minus z z') i) by (intros i; unfold point, minus, comb,
      hat; ring).
    pose proof (Hz O ltac:(lia)) as ZN; pose proof (Hz' O ltac:(lia)) as ZN'; pose proof (Hzz O ltac:(lia)) as ZZ.
    pose proof (Up t Ht) as Ut; assert (Wd : forall z, within (S N) d z -> within N d1 (point z)) by (intros u Hu; apply
      (within_le N _ _ _ D1), Pt, Hu).
    assert (Wz : within N ((1 + W) * t) (minus (point z) (point z'))) by (intros i Hi; rewrite Ep; apply (Pt _ t Hzz i
      Hi)).
    assert (R := fun k Hk => Rem k (point z) (point z') y y' (z O) (z' O) ((1 + W) * t) Hk (Wd z Hz) (Wd z' Hz')
      ltac:(rewrite Rabs_pos_eq; lra) ltac:(rewrite Rabs_pos_eq; lra) ltac:(lra) ltac:(lra) Wz ltac:(lra) ltac:(unfold
      minus in ZZ; lra)).
    replace (eps / (1 + W) * ((1 + W) * t)) with (eps * t) in R by (field; lra); split.
    - destruct (R n (Nat.le_refl n)) as (R1 & R2 & _); unfold power in R1, R2.
      intros [|i] Hi; unfold minus, right, kicked, rows; [same_as R2 | specialize (R1 i ltac:(lia)); same_as R1].
    - intros k Hk; destruct (R k Hk) as (_ & _ & R3); unfold power in R3.
      assert (Ed : C (pow k (minus (point z) (point z'))) = C (pow k (hat (minus z z'))) + (z O - z' O) * C (pow k w)).
      { rewrite (dot_ext N _ _ (pow k (point (minus z z')))) by (apply power_ext; intros; apply Ep).
        unfold point; rewrite power_comb, dot_comb; unfold minus at 2; ring. } rewrite Ed in R3; same_as R3. }
  constructor.
  - intros y y' z z' t Hy Hy' Hz Hz' Ht Hzz Hyy; apply (Two y y' z z' t Hy Hy' Hz Hz' Ht Hzz Hyy).
  - intros y z t Hy Hz Htz Hyt; assert (P0 : point zero = zero) by (extensionality i; unfold point, comb, hat, zero;
    ring). destruct (Two y 0 z zero t Hy ltac:(lra) Hz ltac:(apply within_zero; lra) ltac:(lra)) as [B1 B2]; [intros i
      Hi; unfold minus, zero; rewrite Rminus_0_r; apply Htz, Hi | rewrite Rminus_0_r, Rabs_pos_eq; lra|].
    rewrite P0 in B2; change (zero O) with 0 in B2; split.
    + assert (Z : forall i, (i < S N)%nat -> minus (right 0 zero) (kicked 0) i = 0) by (intros i Hi; unfold minus;
        rewrite (right_zero i Hi); destruct i; unfold kicked, rows; ring).
      intros i Hi; specialize (B1 i Hi); unfold minus at 1 in B1; rewrite (Z i Hi), Rminus_0_r in B1; exact B1.
    + intros k Hk; specialize (B2 k Hk); rewrite (proj1 (Z0 k)) in B2.
      replace (hat (minus z zero)) with (hat z) in B2 by (extensionality i; unfold hat, minus, zero; ring); same_as B2.
Qed.

(** ** The solutions in a ball of radius d: they are at most P y, and nearly those of the linear problem *)
Section Ball.
Variables (K W eps0 d beta : R).
Hypothesis HK : inverse_bound K.
Hypothesis HW : 0 <= W /\ within N W w.
Hypothesis Hd : 0 < d.
Hypothesis He0 : 0 < eps0 /\ K * eps0 <= 1 / 2.
Hypothesis Hsm : small W eps0 d.
Hypothesis Hbeta : 0 <= beta /\ within N beta (Map.B M).
Notation P := (2 * K * beta + 2).
Lemma kicked_within y : 0 <= y -> within (S N) (beta * y) (kicked y).
Proof.
  intros Hy; apply within_S; unfold kicked; split; cbn [rows hat].
  - rewrite Rabs_R0; apply Rmult_le_pos; lra.
  - intros i Hi; unfold hat, rows; rewrite Rmult_comm; apply Rabs_mult_le; [apply Hbeta, Hi | rewrite Rabs_pos_eq; lra].
Qed.
Lemma P_pos : 2 <= P. Proof. destruct HK as [K1 _]; assert (0 <= K * beta) by (apply Rmult_le_pos; lra); lra. Qed.
(** Two solutions differ by at most P times what their speeds differ by. *)
Lemma Lipschitz y y' z z' : 0 <= y <= d -> 0 <= y' <= d -> within (S N) d z -> within (S N) d z' -> solves y z ->
  solves y' z' -> within (S N) (P * Rabs (y - y')) (minus z z').
Proof.
  intros Hy Hy' Hz Hz' S1 S2; destruct HK as (K1 & KB & _); pose proof (small_two _ _ _ Hsm) as Two; pose proof P_pos as
    P2.
  set (s := Rabs (y - y')); assert (Hs : 0 <= s) by apply Rabs_pos; assert (Ps : 2 * s <= P * s) by (apply
    Rmult_le_compat_r; lra). assert (H : forall m, within (S N) (P * s + 2 * d / 2 ^ m) (minus z z')).
  { induction m as [|m IH]; [apply (within_le _ (d + d)); [cbn; lra | apply (within_minus _ d d z z' Hz Hz')]|].
    assert (Pm : 0 < 2 ^ m) by (apply pow_lt; lra); assert (D : 0 < 2 * d / 2 ^ m) by (apply Rdiv_lt_0_compat; lra).
    set (t := P * s + 2 * d / 2 ^ m) in *; specialize (Two y y' z z' t Hy Hy' Hz Hz' ltac:(unfold t; lra) IH ltac:(fold
      s; unfold t; lra)). replace (2 * d / 2 ^ S m) with (2 * d / 2 ^ m / 2) by (cbn [Rpow_def.pow]; field; lra).
    apply (within_le _ (K * (beta * s + eps0 * t))); [assert (K * eps0 * t <= 1 / 2 * t) by (apply Rmult_le_compat_r;
      unfold t; lra); unfold t in *; lra|]. apply KB; [apply Rplus_le_le_0_compat; apply Rmult_le_pos; unfold t; lra|].
    intros i Hi; rewrite minus_comb, left_comb, S1, S2 by exact Hi; specialize (Two i Hi); unfold minus in Two.
    replace (1 * right y z i + -1 * right y' z' i) with ((kicked y i - kicked y' i) + (right y z i - kicked y i - (right
      y' z' i - kicked y' i))) by ring; apply triangle2; [|exact Two]. destruct i as [|i]; unfold kicked, rows.
    - rewrite Rminus_eq_0, Rabs_R0; apply Rmult_le_pos; lra.
    - replace (y * Map.B M i - y' * Map.B M i) with ((y - y') * Map.B M i) by ring; rewrite (Rmult_comm beta).
      apply Rabs_mult_le; [right; reflexivity | apply Hbeta; lia]. }
  intros i Hi; apply (squeeze _ _ (2 * d)); intros m; apply (H m i Hi).
Qed.
Lemma unique y z z' : 0 <= y <= d -> within (S N) d z -> within (S N) d z' -> solves y z -> solves y z' ->
  forall i, (i < S N)%nat -> z i = z' i.
Proof.
  intros Hy Hz Hz' S1 S2 i Hi; apply Rminus_diag_uniq, Rabs_zero; rewrite <- (Rmult_0_r P), <- Rabs_R0, <- (Rminus_eq_0
    y).
  exact (Lipschitz y y z z' Hy Hy Hz Hz' S1 S2 i Hi).
Qed.
Lemma size y z : 0 <= y <= d -> within (S N) d z -> solves y z -> within (S N) (P * y) z.
Proof.
  intros Hy Hz HS i Hi; pose proof (Lipschitz y 0 z zero Hy ltac:(lra) Hz ltac:(apply within_zero; lra) HS zero_solves i
    Hi) as L; unfold minus, zero in L; rewrite !Rminus_0_r, (Rabs_pos_eq y) in L by lra; exact L.
Qed.
Definition line (y : R) : vec := rows (- (v n / e) * y) (fun i => y * V i).
(** What lies between two solutions is, to the first order, what lies between those of the linear problem. *)
Lemma first_order eps d' : 0 < eps -> 0 < d' <= d -> small W (eps / (P * K)) d' -> forall y y' z z', 0 <= y -> 0 <= y'
  -> P * y <= d' -> P * y' <= d' -> within (S N) d z -> within (S N) d z' -> solves y z -> solves y' z' ->
  within (S N) (eps * Rabs (y - y')) (minus (minus z z') (line (y - y'))).
Proof.
  intros Heps Hd' Sm y y' z z' Hy0 Hy0' Hy Hy' Hz Hz' HS HS'; pose proof HK as (K1 & KB & _); pose proof P_pos as P2.
  assert (Up : forall y, 0 <= y -> y <= P * y) by (intros t Ht; rewrite <- (Rmult_1_l t) at 1; apply
    Rmult_le_compat_r; lra).
  pose proof (Up y Hy0); pose proof (Up y' Hy0'); pose proof (within_le _ _ _ _ Hy (size y z ltac:(lra) Hz HS)) as Z.
  pose proof (within_le _ _ _ _ Hy' (size y' z' ltac:(lra) Hz' HS')) as Z'.
  pose proof (Lipschitz y y' z z' ltac:(lra) ltac:(lra) Hz Hz' HS HS') as L.
  set (s := Rabs (y - y')) in *; assert (Hs : 0 <= s) by apply Rabs_pos; assert (Ps : 0 <= P * s) by (apply
    Rmult_le_pos; lra). assert (Ps' : 1 * s <= P * s) by (apply Rmult_le_compat_r; lra).
  pose proof (small_two _ _ _ Sm y y' z z' (P * s) ltac:(lra) ltac:(lra) Z Z' Ps L ltac:(fold s; lra)) as B.
  apply (within_le _ (K * (eps / (P * K) * (P * s)))); [right; field; lra|].
  apply KB; [apply Rmult_le_pos; [left; apply Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra] | exact Ps]|].
  assert (EL : hat (line (y - y')) = comb (y - y') 0 V V) by (extensionality i; unfold hat, line, rows, comb; ring).
  intros i Hi; specialize (B i Hi); rewrite minus_comb, left_comb, minus_comb, left_comb, HS, HS' by exact Hi.
  replace (left (line (y - y')) i) with (kicked y i - kicked y' i); [unfold minus in B; same_as B|].
  destruct i as [|i]; unfold left, kicked, rows; rewrite EL, power_comb.
  - rewrite dot_comb; unfold line, rows; field; exact Ne.
  - unfold minus, comb; rewrite (HV i) by lia; ring.
Qed.
(** mc and m bound C and the powers of A. *)
Definition bounds (mc m : R) : Prop := 0 <= mc /\ (forall t x, within N t x -> Rabs (C x) <= mc * t) /\ 1 <= m /\
  forall k t x, (k <= n)%nat -> 0 <= t -> within N t x -> within N (m * t) (pow k x).
Definition gain mc m := P + mc * m + Rabs e + 1.
Lemma near_line mc m eps d' : bounds mc m -> 0 < eps -> 0 < d' <= d -> small W (eps / gain mc m / (P * K)) d' -> small W
  (eps / gain mc m) d' -> forall y z, 0 <= y -> P * y <= d' -> within (S N) d z -> solves y z ->
  within (S N) (eps * y) (minus z (line y)) /\
  forall k, (k <= n)%nat -> Rabs (hit k (z O) (point z) - (v k - v n) * y) <= eps * y.
Proof.
  intros (Hmc & Cb & Hm & Pb) Heps Hd' Sm1 Sm2 y z Hy Y Hz HS; pose proof P_pos as P2; pose proof (Rabs_pos e) as Pe.
  assert (Hmm : 0 <= mc * m) by (apply Rmult_le_pos; lra); unfold gain in Sm1, Sm2.
  set (H := P + mc * m + Rabs e + 1) in *; pose proof (first_order (eps / H) d' ltac:(apply Rdiv_lt_0_compat; unfold H;
    lra) Hd' Sm1 y 0 z zero ltac:(lra) ltac:(lra) Y ltac:(lra) Hz ltac:(apply within_zero; lra) HS zero_solves) as B.
  replace (minus z zero) with z in B by (extensionality i; unfold minus, zero; ring); rewrite Rminus_0_r, (Rabs_pos_eq
    y) in B by lra. set (t := eps / H * y) in *; assert (Ht : 0 <= t) by (apply Rmult_le_pos; [left; apply
    Rdiv_lt_0_compat; unfold H; lra | lra]). assert (Et : (P + mc * m + Rabs e + 1) * t = eps * y) by (unfold t, H;
    field; lra).
  assert (0 <= P * t /\ 0 <= mc * m * t /\ 0 <= Rabs e * t) as (T1 & T2 & T3) by (repeat split; apply Rmult_le_pos;
    lra).
  split; [apply (within_le _ t); [lra | exact B]|]; intros k Hk; assert (Y' : 1 * y <= P * y) by (apply
    Rmult_le_compat_r; lra); pose proof (size y z ltac:(lra) Hz HS) as Sz.
  destruct (small_one _ _ _ Sm2 y z (P * y) ltac:(lra) (within_le _ _ _ _ Y Sz) Sz ltac:(lra)) as [_ B2].
  specialize (B2 k Hk); apply within_S in B; destruct B as [B3 B4]; pose proof (Cb _ _ (Pb k _ _ Hk Ht B4)) as B5.
  assert (E5 : hat (minus z (line y)) = comb 1 (- y) (hat z) V) by (extensionality i; unfold hat, minus, line, rows,
    comb; ring).
  rewrite E5, power_comb, dot_comb in B5; pose proof (Rabs_mult_le _ e _ _ B3 (Rle_refl _)) as B6; unfold minus, line,
    rows in B6.
  replace ((z O - - (v n / e) * y) * e) with (z O * e + v n * y) in B6 by (field; exact Ne).
  replace (hit k (z O) (point z) - (v k - v n) * y) with ((hit k (z O) (point z) - C (pow k (hat z)) - z O * e) + (1 * C
    (pow k (hat z)) + - y * v k) + (z O * e + v n * y)) by ring.
  apply (Rle_trans _ (eps / H * (P * y) + mc * (m * t) + t * Rabs e)); [apply triangle3; assumption|].
  replace (eps / H * (P * y)) with (P * t) by (unfold t; ring); lra.
Qed.
End Ball.
End Curve.

(** Of smooth maps. *)
Lemma bounds_exist M n : exists mc m, bounds M n mc m.
Proof.
  destruct (dot_bound (Map.N M) (Map.C M)) as (mc & Hmc & Cb), (power_bound (Map.N M) (Map.A M) n) as (m & Hm & Pb).
  exists mc, m; repeat split; trivial.
Qed.
Section Smooth.
Variables (M : Map.t) (w : vec) (e : R).
Hypothesis HM : smooth M.
Hypothesis Hw : forall i, (i < Map.N M)%nat -> w i = mult (Map.N M) (Map.A M) w i + Map.phi M i.
Hypothesis He : e = dot (Map.N M) (Map.C M) w + Map.eta M.
Lemma zeros k : Map.h M (fly M 0 k zero) 0 = 0 /\ forall i, (i < Map.N M)%nat -> fly M 0 k zero i = 0.
Proof. split; [exact (height_zero M w e HM Hw He k) | exact (fly_zero M w HM Hw k)]. Qed.
Lemma small_exists n W : 0 <= W -> within (Map.N M) W w -> forall eps, 0 < eps -> exists d0, 0 < d0 /\
  forall d, 0 < d <= d0 -> small M w e n W eps d.
Proof.
  intros HW Wb eps Heps.
  destruct (remainder_exists M w e HM Hw He n (eps / (1 + W))) as (d1 & Hd1 & Rem); [apply Rdiv_lt_0_compat; lra|].
  exists (d1 / (1 + W)); split; [apply Rdiv_lt_0_compat; lra|]; intros d [Hd Hd']; apply small_of with (d1 := d1);
    trivial; [exact zeros|]. apply (Rmult_le_compat_l (1 + W)) in Hd'; [|lra].
  replace ((1 + W) * (d1 / (1 + W))) with d1 in Hd' by (field; lra); exact Hd'.
Qed.
End Smooth.
