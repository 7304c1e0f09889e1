(** * Proof that Theorem 2's list by integers is Theorem 2's, and decides at rational s on r = 1 *)

From Coq Require Import Reals ZArith List Bool Lra Lia.
From Grazing Require Import Defs Statement StatementCircleZ Polar Farey Above.
Import ListNotations. Open Scope R_scope.

Lemma in_range n m : In m (rangeZ (Z.of_nat n)) <-> exists l, m = Z.of_nat l /\ (1 <= l <= n - 1)%nat.
Proof.
  unfold rangeZ; rewrite Nat2Z.id, in_map_iff; split.
  - intros (l & <- & Hl); apply in_seq in Hl; exists l; split; [reflexivity | lia].
  - intros (l & -> & Hl); exists l; split; [reflexivity | apply in_seq; lia].
Qed.

(** What the search finds is n+, and something is found where m/n has neighbours. *)
Lemma found n m k : (3 <= n)%nat -> find (fun k => (Z.of_nat m * k) mod Z.of_nat n =? 1)%Z (rangeZ (Z.of_nat n)) = Some
  k -> (0 < m < n)%nat -> exists F : Farey m n, k = Z.of_nat (n_plus F) /\
  (Z.of_nat m * k / Z.of_nat n = Z.of_nat (m_plus F))%Z.
Proof.
  intros Hn H Hm; apply find_some in H; destruct H as [Hk E]; apply Z.eqb_eq in E.
  apply in_range in Hk; destruct Hk as (np & -> & Hnp).
  pose proof (Z.div_mod (Z.of_nat m * Z.of_nat np) (Z.of_nat n) ltac:(lia)) as D; rewrite E in D.
  set (l := (Z.of_nat m * Z.of_nat np / Z.of_nat n)%Z) in *; assert (Hl : (0 <= l)%Z) by (apply Z.div_pos; lia).
  assert (E1 : (m * np = Z.to_nat l * n + 1)%nat) by (apply Nat2Z.inj; rewrite Nat2Z.inj_add, !Nat2Z.inj_mul, Z2Nat.id;
    lia).
  assert (Hlm : (Z.to_nat l < m)%nat) by nia.
  assert (HF : neighbours m n (Z.to_nat l) np (m - Z.to_nat l) (n - np)).
  { split; [lia|]; split; [exact E1|]; split; [lia|]; rewrite Nat.mul_sub_distr_l, Nat.mul_sub_distr_r; nia. }
  exists (Build_Farey _ _ _ _ _ _ HF); cbn [n_plus m_plus]; split; [reflexivity | rewrite Z2Nat.id;
    [reflexivity | exact Hl]].
Qed.

Lemma is_found n m (F : Farey m n) : (3 <= n)%nat ->
  exists k, find (fun k => (Z.of_nat m * k) mod Z.of_nat n =? 1)%Z (rangeZ (Z.of_nat n)) = Some k.
Proof.
  intros Hn; destruct (find _ _) as [k|] eqn:E; [exists k; reflexivity | exfalso].
  pose proof (are_neighbours F) as (Hp & E1 & _ & _).
  pose proof (find_none _ _ E (Z.of_nat (n_plus F)) ltac:(apply in_range; exists (n_plus F); split;
    [reflexivity | lia])) as X.
  cbv beta in X; apply Z.eqb_neq in X; apply X; rewrite <- Nat2Z.inj_mul, E1, Nat2Z.inj_add, Nat2Z.inj_mul.
  rewrite Z.add_comm, Z.mod_add, Z.mod_small; lia.
Qed.

(** The two pieces beside m/n. *)
Definition left_piece m n (F : Farey m n) : piece := (Z.of_nat (n_minus F), Plus,
  (if (m =? 1)%nat then (1%Z, 2 * Z.of_nat n)%Z else (Z.of_nat (m_plus F), Z.of_nat (n_plus F))),
  (Z.of_nat m, Z.of_nat n)).
Definition right_piece m n (F : Farey m n) : piece := (Z.of_nat (n_plus F), Minus, (Z.of_nat m, Z.of_nat n),
  (Z.of_nat (m_minus F), Z.of_nat (n_minus F))).

Lemma beside_pieces m n (F : Farey m n) : (3 <= n)%nat -> (0 < 2 * m < n)%nat ->
  besideZ (Z.of_nat n) (Z.of_nat m) = [left_piece m n F; right_piece m n F].
Proof.
  intros Hn Hm; unfold besideZ; destruct (Z.ltb_spec (2 * Z.of_nat m) (Z.of_nat n)) as [_|]; [|lia].
  destruct (is_found n m F Hn) as [k E]; rewrite E; destruct (found n m k Hn E ltac:(lia)) as (F' & -> & ->).
  destruct (Farey_unique m n F F') as (E1 & E2 & E3 & E4); destruct (neighbours_sum _ _ _ _ _ _ (are_neighbours F)).
  unfold left_piece, right_piece; rewrite E1, E2.
  replace (Z.of_nat n - Z.of_nat (n_plus F))%Z with (Z.of_nat (n_minus F)) by lia.
  replace (Z.of_nat m - Z.of_nat (m_plus F))%Z with (Z.of_nat (m_minus F)) by lia.
  replace (Z.of_nat m =? 1)%Z with (m =? 1)%nat; [reflexivity|].
  destruct (Nat.eqb_spec m 1), (Z.eqb_spec (Z.of_nat m) 1); trivial; lia.
Qed.

Lemma in_sides n t : (3 <= n)%nat -> In t (sidesZ (Z.of_nat n)) <->
  exists m (F : Farey m n), (0 < 2 * m < n)%nat /\ (t = left_piece m n F \/ t = right_piece m n F).
Proof.
  intros Hn; unfold sidesZ; rewrite in_flat_map; split.
  - intros (m' & Hm & Ht); apply in_range in Hm; destruct Hm as (m & -> & Hm).
    assert (H : (2 * m < n)%nat).
    { unfold besideZ in Ht; destruct (Z.ltb_spec (2 * Z.of_nat m) (Z.of_nat n)); [lia | destruct Ht]. }
    assert (HF : exists F : Farey m n, True).
    { unfold besideZ in Ht; destruct (2 * Z.of_nat m <? Z.of_nat n)%Z; [|destruct Ht].
      destruct (find _ _) as [k|] eqn:E; [|destruct Ht]; destruct (found n m k Hn E ltac:(lia)) as (F & _); exists F;
        trivial. }
    destruct HF as [F _]; exists m, F; split; [lia|]; rewrite (beside_pieces m n F Hn ltac:(lia)) in Ht.
    destruct Ht as [<-|[<-|[]]]; auto.
  - intros (m & F & Hm & Ht); exists (Z.of_nat m); split; [apply in_range; exists m; split; [reflexivity | lia]|].
    rewrite (beside_pieces m n F Hn Hm); destruct Ht as [->| ->]; cbn; auto.
Qed.

Definition low (t : piece) : Z * Z := snd (fst t).
Definition high (t : piece) : Z * Z := snd t.

Lemma nat_fraction a b : fraction (Z.of_nat a, Z.of_nat b) = INR a / INR b.
Proof. unfold fraction; cbn [fst snd]; rewrite <- !INR_IZR_INZ; reflexivity. Qed.

Lemma low_left m n (F : Farey m n) : fraction (low (left_piece m n F)) =
  if (m =? 1)%nat then 1 / (2 * INR n) else INR (m_plus F) / INR (n_plus F).
Proof.
  unfold left_piece, low; cbn [fst snd]; destruct (m =? 1)%nat; [|apply nat_fraction].
  unfold fraction; cbn [fst snd]; rewrite mult_IZR, <- INR_IZR_INZ; reflexivity.
Qed.

Lemma positive_ends m n (F : Farey m n) : (3 <= n)%nat -> (0 < snd (low (left_piece m n F)))%Z /\
  (0 < snd (high (left_piece m n F)))%Z /\ (0 < snd (low (right_piece m n F)))%Z /\
  (0 < snd (high (right_piece m n F)))%Z.
Proof.
  intros Hn; pose proof (are_neighbours F) as (? & _ & ? & _); unfold low, high, left_piece, right_piece; cbn [fst snd].
  destruct (m =? 1)%nat; cbn [fst snd]; repeat split; lia.
Qed.

Theorem Sides : Sides_statement.
Proof.
  intros n k g lo hi Hn; split.
  - intros [m F Hm|m F Hm]; destruct (positive_ends m n F Hn) as (P1 & P2 & P3 & P4).
    + exists (low (left_piece m n F)), (high (left_piece m n F)); rewrite low_left.
      split; [apply in_sides; [exact Hn | exists m, F; split; [exact Hm | left; reflexivity]]|].
      split; [reflexivity|]; split; [symmetry; apply nat_fraction | split; assumption].
    + exists (low (right_piece m n F)), (high (right_piece m n F)).
      split; [apply in_sides; [exact Hn | exists m, F; split; [exact Hm | right; reflexivity]]|].
      split; [symmetry; apply nat_fraction|]; split; [symmetry; apply nat_fraction | split; assumption].
  - intros (h & h' & Hin & -> & -> & _); apply in_sides in Hin; [|exact Hn]. destruct Hin as (m & F & Hm & [E|E]).
    + assert (El : h = low (left_piece m n F)) by (rewrite <- E; reflexivity).
      unfold left_piece in E; injection E as Ek Eg _ Eh'; rewrite El, low_left; subst g h'; apply Nat2Z.inj in Ek;
        subst k.
      rewrite nat_fraction; exact (left_side n m F Hm).
    + unfold right_piece in E; injection E as Ek Eg Eh Eh'; subst g h h'; apply Nat2Z.inj in Ek; subst k.
      rewrite !nat_fraction; exact (right_side n m F Hm).
Qed.

(** ** Where x/z lies *)
Lemma between x z h : (0 < z)%Z -> (0 < snd h)%Z -> (fst h * z < x * snd h)%Z <-> fraction h < IZR x / IZR z.
Proof.
  intros Hz Hh; apply IZR_lt in Hz, Hh; destruct h as [a b]; unfold fraction; cbn [fst snd] in *.
  assert (E : IZR x / IZR z - IZR a / IZR b = (IZR (x * b) - IZR (a * z)) / (IZR z * IZR b)) by (rewrite !mult_IZR;
    field; lra).
  assert (P : 0 < IZR z * IZR b) by (apply Rmult_lt_0_compat; assumption); split; intros H.
  - apply IZR_lt in H; apply Rminus_gt_0_lt; rewrite E; apply Rdiv_lt_0_compat; lra.
  - apply lt_IZR; apply Rlt_Rminus in H; rewrite E in H.
    apply (Rmult_lt_compat_r (IZR z * IZR b)) in H; [|exact P]; unfold Rdiv in H.
    rewrite Rmult_0_l, Rmult_assoc, Rinv_l in H; lra.
Qed.

Lemma between' x z h : (0 < z)%Z -> (0 < snd h)%Z -> (x * snd h < fst h * z)%Z <-> IZR x / IZR z < fraction h.
Proof. intros Hz Hh; exact (between (fst h) (snd h) (x, z) Hh Hz). Qed.

Lemma same_sign_eq e g : same_sign e g = true <-> e = g. Proof. destruct e, g; cbn; split; congruence. Qed.

Section Point.
Variables (n : nat) (x z : Z).
Hypotheses (Hn : (3 <= n)%nat) (Hx : (0 < x)%Z) (Hz : (2 * x < z)%Z).
Let s := IZR x / IZR z.
Let L := sidesZ (Z.of_nat n).

Lemma s_range : 0 < s < 1 / 2.
Proof.
  assert (P : 0 < IZR z) by (apply IZR_lt; lia); pose proof (IZR_lt _ _ Hx) as P'; apply IZR_lt in Hz;
    rewrite mult_IZR in Hz.
  split; [apply Rdiv_lt_0_compat; lra|]; apply (Rmult_lt_reg_r (IZR z)); [exact P|].
  unfold s, Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Lemma inside_iff k g h h' : (0 < snd h)%Z -> (0 < snd h')%Z ->
  insideZ x z (k, g, h, h') = true <-> fraction h < s < fraction h'.
Proof.
  intros P P'; destruct h as [a b], h' as [a' b']; unfold insideZ; rewrite andb_true_iff, !Z.ltb_lt.
  pose proof (between x z (a, b) ltac:(lia) P) as A; pose proof (between' x z (a', b') ltac:(lia) P') as B.
  cbn [fst snd] in A, B; rewrite A, B; reflexivity.
Qed.

Lemma outside_iff k g h h' : (0 < snd h)%Z -> (0 < snd h')%Z ->
  outsideZ x z (k, g, h, h') = true <-> s < fraction h \/ fraction h' < s.
Proof.
  intros P P'; destruct h as [a b], h' as [a' b']; unfold outsideZ; rewrite orb_true_iff, !Z.ltb_lt.
  pose proof (between' x z (a, b) ltac:(lia) P) as A; pose proof (between x z (a', b') ltac:(lia) P') as B.
  cbn [fst snd] in A, B; rewrite A, B; reflexivity.
Qed.

Lemma first_end : fraction (1, 2 * Z.of_nat n)%Z = 1 / (2 * INR n).
Proof. unfold fraction; cbn [fst snd]; rewrite mult_IZR, <- INR_IZR_INZ; reflexivity. Qed.

Lemma first_iff : (2 * Z.of_nat n * x < z)%Z <-> s < 1 / (2 * INR n).
Proof.
  pose proof (between' x z (1, 2 * Z.of_nat n)%Z ltac:(lia) ltac:(cbn [snd]; lia)) as A; rewrite first_end in A.
  cbn [fst snd] in A; unfold s; rewrite <- A; lia.
Qed.

Lemma first_iff' : (z < 2 * Z.of_nat n * x)%Z <-> 1 / (2 * INR n) < s.
Proof.
  pose proof (between x z (1, 2 * Z.of_nat n)%Z ltac:(lia) ltac:(cbn [snd]; lia)) as A; rewrite first_end in A.
  cbn [fst snd] in A; unfold s; rewrite <- A; lia.
Qed.

Lemma in_interval e g : circleZ (Z.of_nat n) L x z e g = true <-> exists lo hi, interval n e g lo hi /\ lo < s < hi.
Proof.
  pose proof s_range as Hs; destruct e; unfold circleZ.
  - rewrite existsb_exists; split.
    + intros (t & Hin & H); destruct t as [[[k g'] h] h']; cbn [fst snd] in H; apply andb_true_iff in H;
        destruct H as [E H].
      apply same_sign_eq in E; subst g'; pose proof (proj1 (in_sides n _ Hn) Hin) as (m & F & Hm & Ht).
      destruct (positive_ends m n F Hn) as (P1 & P2 & P3 & P4).
      assert (Pk : exists k', k = Z.of_nat k') by (destruct Ht as [Ht|Ht]; injection Ht; intros; subst; eauto).
      destruct Pk as [k' ->].
      assert (P : (0 < snd h)%Z /\ (0 < snd h')%Z).
      { destruct Ht as [Ht|Ht]; [change h with (low (Z.of_nat k', g, h, h'));
          change h' with (high (Z.of_nat k', g, h, h')) at 2 | change h with (low (Z.of_nat k', g, h, h'));
          change h' with (high (Z.of_nat k', g, h, h')) at 2]; rewrite Ht; auto. }
      exists (fraction h), (fraction h'); split; [|apply (inside_iff (Z.of_nat k') g); tauto].
      apply (beside n k'); apply (Sides n k' g _ _ Hn); exists h, h'; tauto.
    + intros (lo & hi & HI & H); inversion HI as [|k g' lo' hi' HS]; subst.
      apply (Sides n k g lo hi Hn) in HS; destruct HS as (h & h' & Hin & -> & -> & P & P').
      exists (Z.of_nat k, g, h, h'); split; [exact Hin|]; cbn [fst snd]; apply andb_true_iff.
      split; [apply same_sign_eq; reflexivity | apply inside_iff; assumption].
  - rewrite andb_true_iff, same_sign_eq, Z.ltb_lt, first_iff; split.
    + intros [-> H]; exists 0, (1 / (2 * INR n)); split; [apply first | lra].
    + intros (lo & hi & HI & H); inversion HI; subst; split; [reflexivity | lra].
Qed.

Lemma u_sine : u_at 1 s n * sin (2 * PI * s) = sin (2 * PI * s * INR n).
Proof.
  pose proof (u_polar 1 (2 * PI * s) n) as H; unfold u_at, trace.
  rewrite (pow1 n), !Rmult_1_l in H; replace (2 * PI * s * INR n) with (INR n * (2 * PI * s)) by ring; exact H.
Qed.

Lemma u_zero : singularZ (Z.of_nat n) x z = true <-> u_at 1 s n = 0.
Proof.
  pose proof PI_RGT_0; pose proof s_range as Hs; assert (Pz : 0 < IZR z) by (apply IZR_lt; lia).
  assert (Hsin : sin (2 * PI * s) > 0).
  { apply sin_gt_0; [apply Rmult_lt_0_compat; lra|]; apply (Rlt_le_trans _ (2 * PI * (1 / 2)));
      [apply Rmult_lt_compat_l|]; lra. }
  assert (E : 2 * PI * s * INR n = IZR (2 * Z.of_nat n * x) / IZR z * PI) by (rewrite !mult_IZR, <- INR_IZR_INZ;
    unfold s; field; lra).
  unfold singularZ; rewrite Z.eqb_eq; split; [|].
  2: { intros Hu; pose proof u_sine as U; rewrite Hu, Rmult_0_l, E in U; symmetry in U; apply sin_eq_0_0 in U.
    destruct U as [k Hk]; apply Rmult_eq_reg_r in Hk; [|lra].
    assert (X : IZR (2 * Z.of_nat n * x) = IZR (k * z)).
    { rewrite (mult_IZR k); rewrite <- Hk; field; lra. }
    apply eq_IZR in X; rewrite X; apply Z.mod_mul; lia. }
  - intros Hm; apply Z.mod_divide in Hm; [|lia]; destruct Hm as [k Hk].
    assert (Z0 : sin (2 * PI * s * INR n) = 0).
    { rewrite E, Hk, mult_IZR; replace (IZR k * IZR z / IZR z * PI) with (IZR k * PI) by (field; lra); apply sin_eq_0_1;
        eauto. }
    pose proof u_sine as U; rewrite Z0 in U; apply Rmult_integral in U; destruct U; [assumption | lra].
Qed.

Lemma nothing : no_circleZ (Z.of_nat n) L x z = true -> no_orbit_at 1 s n.
Proof.
  intros H; unfold no_circleZ in H; rewrite !andb_true_iff, negb_true_iff, Z.ltb_lt, first_iff' in H.
  destruct H as [[Hu H1] H]; rewrite forallb_forall in H.
  apply (Theorem2_stated n s Hn s_range); [|intros E; apply u_zero in E; congruence].
  intros e g lo hi HI; inversion HI as [|k g' lo' hi' HS]; subst; [right; exact H1|].
  apply (Sides n k g lo hi Hn) in HS; destruct HS as (h & h' & Hin & -> & -> & P & P').
  apply (outside_iff (Z.of_nat k) g); trivial; apply H, Hin.
Qed.
End Point.

Theorem Circle : Circle_statement.
Proof.
  intros n x z Hn Hx Hz s L; assert (Hs : 0 < s < 1 / 2) by (eapply s_range; eassumption).
  split; [apply u_zero; assumption|]; split; [|apply nothing; assumption]. intros e g; split; intros H.
  - apply (proj1 (Theorem2_stated n s Hn Hs)), (in_interval n x z Hn Hx Hz e g), H.
  - apply (in_interval n x z Hn Hx Hz e g), (proj1 (Theorem2_stated n s Hn Hs)), H.
Qed.
