(** * S4 and Theorem 2 as stated: the deciding b has the sign of r - R(s), and outside
    the intervals there is no orbit *)

From Coq Require Import Reals ZArith Arith Lra Lia.
From Grazing Require Import Defs Statement Cases Farey Disc Sine Radius Count Graph.
Open Scope R_scope.

(** ** What decides over each interval *)

Definition decided (n k : nat) (g : sign) (lo hi : R) (j : nat) (d : R -> R) : Prop :=
  forall r s, lo < s < hi -> 0 < r <= 1 -> u_at r s n <> 0 /\
  decides (trace r s) (r ^ 2) n k g /\ same_sign (b_at r s n k) (h n j (d s) r).

Lemma side_decided n k g lo hi : (3 <= n)%nat -> side n k g lo hi ->
  exists j d, area n g lo hi j d /\ decided n k g lo hi j d.
Proof.
  intros Hn [m F Hm|m F Hm]; pose proof F as [mp np mm nm HF]; destruct F as [mp' np' mm' nm' HF'];
    cbn [m_plus n_plus m_minus n_minus]; clear mp np mm nm HF; rename mp' into mp, np' into np, mm' into mm,
    nm' into nm, HF' into HF; destruct (m_bounds n m Hn Hm) as (? & ? & ?).
  - eexists _, _; split; [exact (left_area n m mp np mm nm Hn Hm HF)|]; intros r s Hs Hr.
    apply (left_interval n m mp np mm nm s Hn Hm HF) in Hs as [(_ & _ & He) _].
    assert (Hc : cell r s n m) by (apply cell_of_distance; [assumption|split; nra|lra|apply Rabs_def1; lra]).
    split; [apply Hc|split; [|apply (b_left_h r s n m mp np mm nm Hn HF Hc); lra]].
    apply (S3_stated r s n m (Build_Farey _ _ _ _ _ _ HF)); trivial; lia || lra.
  - eexists _, _; split; [exact (right_area n m mp np mm nm Hn Hm HF)|]; intros r s Hs Hr.
    apply (right_interval n m mp np mm nm s Hn Hm HF) in Hs as [(_ & _ & He) _].
    assert (Hc : cell r s n m) by (apply cell_of_distance; [assumption|split; nra|lra|apply Rabs_def1; lra]).
    split; [apply Hc|split; [|apply (b_right_h r s n m mp np mm nm Hn HF Hc); lra]].
    apply (S3_stated r s n m (Build_Farey _ _ _ _ _ _ HF)); trivial; lia || lra.
Qed.

(** ** h at the radius *)

Section At.
Variables (n : nat) (g : sign) (lo hi : R) (j : nat) (d Rad : R -> R).
Hypothesis Hn : (3 <= n)%nat.
Hypothesis HA : area n g lo hi j d.
Hypothesis HR : radius n Plus g lo hi Rad.

Lemma at_radius s : lo < s < hi -> 0 < Rad s -> h n j (d s) (Rad s) = 0.
Proof.
  intros Hs H0; destruct (HR s Hs) as [Hx _].
  destruct (Rtotal_order (h n j (d s) (Rad s)) 0) as [Hl|[He|Hg]]; [|assumption|].
  - destruct (sign_near (fun r => - h n j (d s) r) (Rad s)) as (de & Hde & Hnear);
      [apply continuity_opp, h_continuous|lra|].
    set (r1 := Rmin 1 (Rad s + de / 2)).
    assert (Hr1 : Rad s < r1 <= 1 /\ r1 - Rad s < de) by (unfold r1, Rmin; destruct Rle_dec; lra).
    specialize (Hnear r1 ltac:(apply Rabs_def1; lra)).
    assert (0 < h n j (d s) r1) by (apply (radius_h n g lo hi j d Rad HA HR); lra || tauto); lra.
  - apply (radius_h n g lo hi j d Rad HA HR) in Hg; lra || tauto.
Qed.

Lemma sign_of_h s r : lo < s < hi -> 0 < r <= 1 -> same_sign (r - Rad s) (h n j (d s) r).
Proof.
  intros Hs Hr. pose proof (radius_h n g lo hi j d Rad HA HR s r Hs Hr) as Hiff.
  pose proof (below_radius n g lo hi j d Rad HA HR s r Hs) as Hb. pose proof (at_radius s Hs) as Ha.
  destruct (Rtotal_order r (Rad s)) as [Hl|[He|Hg]].
  - specialize (Hb ltac:(lra)); repeat split; intros; lra.
  - rewrite <- He in Ha; specialize (Ha ltac:(lra)); repeat split; intros; lra.
  - apply Hiff in Hg as Hp; repeat split; intros; lra.
Qed.
End At.

Lemma radius_above n k g lo hi Rad : (3 <= n)%nat -> side n k g lo hi ->
  radius n Plus g lo hi Rad -> above n k g lo hi Rad.
Proof.
  intros Hn HS HR s Hs; destruct (side_decided n k g lo hi Hn HS) as (j & d & HA & HD).
  split; [apply (HR s Hs)|split; [apply (radius_continuous n g lo hi j d Rad HA HR s Hs)|]]; intros r Hr.
  destruct (HD r s Hs Hr) as (Hu & [_ _ Hp Hneg Hz] & S1 & S2 & S3).
  destruct (sign_of_h n g lo hi j d Rad HA HR s r Hs Hr) as (T1 & T2 & T3).
  destruct (HR s Hs) as [Hx HI]; specialize (HI r Hr Plus g); unfold b_at in *; constructor.
  - assumption.
  - unfold orbit_at; tauto.
  - unfold b_at; rewrite S2, <- T2; split; intros; lra.
  - unfold b_at; rewrite S3, <- T3; split; intros; lra.
  - intros H; apply Hneg, S3, T3; lra.
  - intros <-; apply Hz; [apply S2, T2; lra|]. apply Rnot_le_lt; intros ?; nra.
Qed.

(** The graph is determined. *)
Lemma above_radius n k g lo hi Rad : (3 <= n)%nat -> side n k g lo hi ->
  above n k g lo hi Rad -> radius n Plus g lo hi Rad.
Proof.
  intros Hn HS HR s Hs; destruct (HR s Hs) as (Hx & _ & HI); split; [assumption|].
  intros r Hr e' g'; destruct (HI r Hr) as [_ H1 H2 H3 H4 _]; split.
  - intros Ho; destruct (Rtotal_order (Rad s) r) as [Hl|[He|Hg]].
    + destruct (proj2 (One_case _ _ n Plus g ltac:(lia) (proj1 H1 Hl)) e' g' Ho); tauto.
    + exfalso; apply H2 in He; destruct (side_decided n k g lo hi Hn HS) as (j & d & _ & HD).
      destruct (HD r s Hs Hr) as (_ & [_ Hk _ _ _] & _); destruct Ho as (_ & Hb & _).
      specialize (Hb k Hk); unfold b_at in He; rewrite He in Hb; lra.
    + destruct (proj1 (One_case _ _ n e' g' ltac:(lia) Ho) (H4 Hg)).
  - intros (-> & -> & Hl); apply H1, Hl.
Qed.

(** ** S4 and Theorem 2 *)

Lemma side_interval n k g lo hi : side n k g lo hi -> interval n Plus g lo hi. Proof. apply beside. Qed.

Lemma none_outside n r s : (3 <= n)%nat -> 0 < r <= 1 -> 0 < s < 1 / 2 -> u_at r s n <> 0 ->
  (forall e g lo hi, interval n e g lo hi -> ~ lo < s < hi) -> r < 1 \/ outside n s -> no_orbit_at r s n.
Proof.
  intros Hn Hr Hs Hu Hno Hor.
  destruct (place n r s Hn Hr Hs Hu) as [(e & g & lo & hi & HI & H)|[|(E & (e & g & lo & hi & HI & H) & _)]];
    [destruct (Hno e g lo hi HI H)|assumption|exfalso].
  destruct Hor as [|Hout]; [lra|]; specialize (Hout e g lo hi HI). destruct (interval_nonempty n e g lo hi Hn HI); lra.
Qed.

Lemma S4_stated : S4_statement.
Proof.
  intros n Hn; split; [|split].
  - intros r s Hr Hs; apply (first_orbits n r s Hn Hr Hs); tauto.
  - intros k g lo hi HS. destruct (proj1 (S4_proof n Hn) Plus g lo hi (beside n k g lo hi HS)) as (Rad & HR & _).
    exists Rad; apply radius_above; assumption.
  - intros; now apply none_outside.
Qed.

Lemma S4_ends_stated : S4_ends_statement.
Proof.
  intros n k g lo hi Rad Hn HS HA; apply (above_radius n k g lo hi Rad Hn HS) in HA.
  destruct (S4_graph_proof n g lo hi Rad Hn (side_interval _ _ _ _ _ HS) HA) as (_ & H1 & H2 & H3). tauto.
Qed.

Lemma Theorem2_stated : Theorem2_statement.
Proof.
  intros n s Hn Hs; split; [intros e g; now apply Theorem2_proof|].
  intros Hout Hu; apply none_outside; trivial; [lra| |tauto].
  intros e g lo hi HI H; specialize (Hout e g lo hi HI); lra.
Qed.

(** ** One deciding index for each interval, each k prime to n once *)

Lemma index_coprime n k g lo hi : (3 <= n)%nat -> side n k g lo hi -> (1 <= k <= n - 1)%nat /\ Nat.gcd k n = 1%nat.
Proof.
  intros Hn [m F Hm|m F Hm]; destruct F as [mp np mm nm HF]; cbn [n_plus n_minus]; destruct HF as (? & E & ? & E');
    (split; [lia|]); apply Nat.bezout_1_gcd; [exists (n - m)%nat, (nm - mm)%nat|exists m, mp]; lia || nia.
Qed.

Lemma index_exists n k : (3 <= n)%nat -> (1 <= k <= n - 1)%nat -> Nat.gcd k n = 1%nat ->
  exists g lo hi, side n k g lo hi.
Proof.
  intros Hn Hk Hg; destruct (neighbours_exist k n ltac:(lia) Hg) as (a & x & a' & x' & HF).
  assert (Hx : (2 * x <> n)%nat).
  { apply coprime_not_half; [assumption|]; destruct HF as (_ & E & _). apply Nat.bezout_1_gcd; exists k, a; lia. }
  assert (Hak : (a < k)%nat) by (destruct HF as (? & ? & _); nia).
  assert (Hax : (a < x)%nat) by (destruct HF as (? & ? & _); nia).
  destruct HF as (Hx0 & E & _); destruct (lt_dec (2 * x) n).
  - assert (HF : neighbours x n a k (x - a) (n - k)).
    { repeat split; lia. }
    eexists _, _, _; apply (right_side n x (Build_Farey _ _ _ _ _ _ HF)); lia.
  - assert (E' : ((n - x) * k + 1 = (k - a) * n)%nat).
    { rewrite !Nat.mul_sub_distr_r. assert (x * k <= n * k)%nat by (apply Nat.mul_le_mono_r; lia); lia. }
    assert (Hle : (k - a <= n - x)%nat) by nia.
    assert (HF : neighbours (n - x) n (n - x - (k - a)) (n - k) (k - a) k).
    { repeat split; try lia; rewrite Nat.mul_sub_distr_l, (Nat.mul_sub_distr_r (n - x)).
      assert ((n - x) * k <= (n - x) * n)%nat by (apply Nat.mul_le_mono_l; lia).
      assert ((k - a) * n <= (n - x) * n)%nat by (apply Nat.mul_le_mono_r; lia); lia. }
    eexists _, _, _; apply (left_side n (n - x) (Build_Farey _ _ _ _ _ _ HF)); lia.
Qed.

(** n divides no (m - m') k and no (m + m') k, 0 < m, m' < n/2. *)
Lemma numerator_unique n k m m' : (3 <= n)%nat -> (1 <= k <= n - 1)%nat -> Nat.gcd k n = 1%nat -> (0 < 2 * m < n)%nat ->
  (0 < 2 * m' < n)%nat -> (forall l : Z, ((Z.of_nat m - Z.of_nat m') * Z.of_nat k = l * Z.of_nat n)%Z -> m = m') /\
  (forall l : Z, ((Z.of_nat m + Z.of_nat m') * Z.of_nat k <> l * Z.of_nat n)%Z).
Proof.
  intros Hn Hk Hg Hm Hm'; destruct (neighbours_exist k n ltac:(lia) Hg) as (? & ? & ? & ? & HF).
  split; intros l E; apply (multiple_zero _ _ _ _ _ _ HF) in E; lia.
Qed.

Lemma Farey_unique m n (F F' : Farey m n) : m_plus F' = m_plus F /\ n_plus F' = n_plus F /\
  m_minus F' = m_minus F /\ n_minus F' = n_minus F.
Proof.
  destruct F as [mp np mm nm H], F' as [mp' np' mm' nm' H']; cbn.
  pose proof (neighbours_unique _ _ _ _ _ _ H _ _ _ _ H') as E; inversion E; auto.
Qed.

Lemma deciding_indices_stated : Deciding_indices_statement.
Proof.
  intros n Hn; split.
  - intros k; split; [intros [Hk Hg]; now apply index_exists|].
    intros (g & lo & hi & HS); now apply (index_coprime n k g lo hi).
  - intros k g lo hi k' g' lo' hi' HS HS'. destruct (index_coprime n k g lo hi Hn HS) as [Hk Hg].
    destruct HS as [m F Hm|m F Hm], HS' as [m' F' Hm'|m' F' Hm']; destruct (numerator_unique n _ m m' Hn Hk Hg Hm Hm')
      as [U1 U2]; pose proof (are_neighbours F) as (_ & E1 & _ & E2); pose proof (are_neighbours F')
      as (_ & E1' & _ & E2'); split; intros E.
    + assert (m = m') as <- by (apply (U1 (Z.of_nat (m_minus F) - Z.of_nat (m_minus F'))%Z); nia).
      destruct (Farey_unique m n F F') as (-> & -> & _); reflexivity.
    + assert (Eh : INR m / INR n = INR m' / INR n) by congruence. apply fraction_inj in Eh; [|assumption]; subst m'.
      symmetry; apply (Farey_unique m n F F').
    + exfalso; apply (U2 (Z.of_nat (m_minus F) + Z.of_nat (m_plus F'))%Z); nia.
    + discriminate.
    + exfalso; apply (U2 (Z.of_nat (m_minus F') + Z.of_nat (m_plus F))%Z); nia.
    + discriminate.
    + assert (m = m') as <- by (apply (U1 (Z.of_nat (m_plus F) - Z.of_nat (m_plus F'))%Z); nia).
      destruct (Farey_unique m n F F') as (_ & _ & -> & ->); reflexivity.
    + assert (El : INR m / INR n = INR m' / INR n) by congruence. apply fraction_inj in El; [|assumption]; subst m'.
      symmetry; apply (Farey_unique m n F F').
Qed.
