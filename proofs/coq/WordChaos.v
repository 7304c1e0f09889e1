(** * Where two cycles meet: the second lower and the second upper period *)

From Coq Require Import Reals List Arith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementWords Algebra
  Farey Disc Radius InsideTriangle WordAlgebra WordPath WordGraph WordPatterns WordRegion3 WordPlane.
Import ListNotations. Open Scope R_scope.

Section Chaos.
Variables (a1 a2 : R) (K : nat).
Hypothesis first : first_upper a1 a2 K.
Let Hd : decided a1 a2 K := decided_everywhere a1 a2 K first.

Lemma not_on_line : 0 < a2 <= 1 /\ Rabs a1 <> a2 + 1.
Proof. pose proof (a1_in a1 a2 K first); split; [apply first | lra]. Qed.
Lemma cycles_two_orbits e g : cycles a1 a2 e g <-> exists i j, i <> j /\ orbit a1 a2 i e g /\ orbit a1 a2 j e g.
Proof. destruct not_on_line; apply W6; assumption. Qed.
Lemma cycles_Minus : (cycles a1 a2 Minus Plus <-> 0 < a1) /\ ~ cycles a1 a2 Minus Minus.
Proof.
  pose proof (K_ge_2 a1 a2 K first) as HK2; pose proof (proj2 (proj2 (proj2 first))) as Hk.
  rewrite !cycles_two_orbits; split; [split|].
  - intros (i & j & Hne & Hi & Hj).
    assert (Hm : forall n, orbit a1 a2 n Minus Plus -> (n < K)%nat /\ u a1 a2 n <> 0) by (intros n Hn;
      apply (Minus_members a1 a2 K first Hd), (orbit_member_edge a1 a2 Minus Plus n), Hn).
    destruct (Hm i Hi) as [Hi1 Hi2], (Hm j Hj) as [Hj1 Hj2].
    pose proof (u_nonzero_pos a1 a2 i Hi2); pose proof (u_nonzero_pos a1 a2 j Hj2).
    pose proof (Hk 2%nat ltac:(lia)) as H2; rewrite u_2 in H2; destruct H2 as [H2|H2]; [assumption|exfalso].
    destruct (le_lt_dec K 3) as [HK3|HK3].
    + assert (i = 2 \/ j = 2)%nat as [->| ->] by lia; rewrite u_2 in *; lra.
    + pose proof (Hk 3%nat HK3) as H3; rewrite u_SS, u_2, u_1, <- H2 in H3; destruct first; lra.
  - intros Ha; exists 1%nat, 2%nat; split; [discriminate|].
    assert (HK : K <> 2%nat).
    { intros E; pose proof (K_upper a1 a2 K first) as H; rewrite E, u_2 in H; lra. }
    split; apply (Minus_orbit a1 a2 K first Hd), (Minus_members a1 a2 K first Hd).
    + rewrite u_1; split; lia || lra.
    + rewrite u_2; split; lia || lra.
  - intros (i & j & _ & Hi & _). assert (Hp : pattern a1 a2 Minus Minus [i]) by (apply pattern_single; assumption).
    apply (Minus_patterns a1 a2 K first Hd) in Hp; destruct Hp as [E _]; discriminate E.
Qed.
End Chaos.

Section Region3.
Variables r s : R.
Hypothesis r_in : 0 < r <= 1.
Hypothesis s_in : 0 < s < 1 / 2.
Notation a1 := (trace r s).
Notation a2 := (r ^ 2).
Variable K : nat.
Hypothesis half : next_half s K.
Let first : first_upper a1 a2 K := next_half_first r s r_in s_in K half.
Let Hd : decided a1 a2 K := decided_everywhere a1 a2 K first.

Lemma unit_neighbours n : (3 <= n)%nat -> neighbours 1 n 0 1 1 (n - 1).
Proof. intros Hn; unfold neighbours; lia. Qed.
Lemma unit_cell n : (3 <= n)%nat -> Rabs (INR n * s - 1) < 1 / 2 -> INR n * s <> 1 -> cell r s n 1.
Proof. intros Hn Hr Hne; apply cell_of_distance; trivial. Qed.

(** The first lower period after 1. *)
Lemma second_on_path w i j : path a1 a2 K w i j -> i = 1%nat \/
  exists n, (3 <= n)%nat /\ In (n, D) (vertices K w) /\ 1 < INR n * s /\ INR (n - 1) * s < 1.
Proof.
  induction 1 as [|w i j H IH Hon|w i j H IH Hon]; [tauto | right | ].
  - rewrite (vertices_snoc a1 a2 K w i j D H); destruct IH as [-> | (n & Hn & Hin & H1)].
    + pose proof (path_pos a1 a2 K w 1 j H); pose proof (K_ge_2 a1 a2 K first).
      apply (path_stern r s r_in s_in K half) in H as (m1 & m2 & H).
      destruct (stern_facts s s_in K half w m1 1 m2 j H) as (E & _ & _ & _ & L1 & L2).
      assert (m1 = 0)%nat as ->.
      { destruct m1 as [|m1]; [reflexivity|exfalso]; rewrite S_INR in L1; cbn [INR] in L1.
        pose proof (pos_INR m1); lra. }
      assert (m2 = 1)%nat as -> by lia. apply (stern_on r s r_in s_in K half w _ _ _ _ H) in Hon.
      exists (1 + j)%nat; split; [lia | split; [apply in_app_iff; right; left; reflexivity|]].
      replace (1 + j - 1)%nat with j by lia; change (INR (0 + 1)) with 1 in Hon; change (INR 1) with 1 in L2; lra.
    + exists n; split; [assumption | split; [apply in_app_iff; left|]; tauto].
  - rewrite (vertices_snoc a1 a2 K w i j U H); destruct IH as [-> | (n & Hn & Hin & H1)]; [tauto | right].
    exists n; split; [assumption | split; [apply in_app_iff; left|]; tauto].
Qed.
Lemma cycles_Plus_Minus : cycles a1 a2 Plus Minus <->
  exists n, (3 <= n)%nat /\ 1 < INR n * s /\ INR (n - 1) * s < 1 /\ b_at r s n 1 > 0.
Proof.
  rewrite (cycles_two_orbits a1 a2 K first); split.
  - intros (i & j & Hne & Hi & Hj).
    assert (exists k, k <> 1%nat /\ orbit a1 a2 k Plus Minus) as (k & Hk & Ho) by (destruct (Nat.eq_dec i 1) as [->|];
      [exists j; auto | eauto]).
    apply (orbit_case a1 a2 K first) in Ho as (x & Hx & E & HV); destruct x; [|discriminate].
    destruct (proj2 (proj2 (proj2 Hd)) k HV) as [->|[->|(w & i' & j' & Hp & ->)]]; [tauto| |].
    { pose proof (K_upper a1 a2 K first); cbn [on] in Hx; lra. }
    pose proof (path_pos a1 a2 K w i' j' Hp); pose proof (K_ge_2 a1 a2 K first).
    destruct (second_on_path _ _ _ (path_D a1 a2 K w i' j' Hp Hx)) as [?|(n & Hn & Hin & H1 & H2)]; [lia|].
    exists n; repeat split; trivial.
    assert (Hn' : member a1 a2 Plus n).
    { rewrite (vertices_snoc a1 a2 K w i' j' D Hp), in_app_iff in Hin; destruct Hin as [Hin|[E'|[]]].
      - apply (members_vertices a1 a2 K first Hd w i' j' Hp HV _ Hin).
      - injection E' as <-; assumption. }
    destruct Hn' as [_ Hb]; specialize (Hb 1%nat ltac:(lia)); cbn [sgn] in Hb; unfold b_at; lra.
  - intros (n & Hn & H1 & H2 & Hb); exists 1%nat, n; split; [lia|].
    split; [apply (orbit_on a1 a2 K first D); [apply on_one | apply member_one]|].
    rewrite minus_INR in H2 by lia; cbn [INR] in H2.
    assert (Hcell : cell r s n 1) by (apply unit_cell; [assumption | apply Rabs_def1; lra | lra]).
    destruct (S3_stated r s n 1%nat (Build_Farey _ _ _ _ _ _ (unit_neighbours n Hn)) ltac:(lia) ltac:(lia) Hcell)
      as [_ HS]; cbn [INR] in HS; destruct (HS ltac:(lra)) as [_ _ Ho _ _]; apply Ho, Hb.
Qed.
Lemma cycles_Plus_Plus : s < 1 / 4 -> (cycles a1 a2 Plus Plus <-> b_at r s (K + 1) K > 0).
Proof.
  intros Hs; pose proof (K_ge_2 a1 a2 K first) as HK2.
  assert (HK3 : (3 <= K + 1)%nat) by lia; pose proof half as [H1 H2]. rewrite (cycles_two_orbits a1 a2 K first); split.
  - intros (i & j & Hne & Hi & Hj).
    assert (exists k, k <> K /\ orbit a1 a2 k Plus Plus) as (k & Hk & Ho) by (destruct (Nat.eq_dec i K) as [->|];
      [exists j; auto | eauto]).
    apply (orbit_case a1 a2 K first) in Ho as (x & Hx & E & HV); destruct x; [discriminate|].
    destruct (proj2 (proj2 (proj2 Hd)) k HV) as [->|[->|(w & i' & j' & Hp & ->)]]; [|tauto|].
    { pose proof (on_one a1 a2); cbn [on] in *; lra. }
    assert (HV1 : member a1 a2 Plus (1 + K)).
    { destruct w as [|x w].
      - destruct (path_unique a1 a2 K _ _ _ _ _ Hp (path_start a1 a2 K)) as [-> ->]; assumption.
      - apply (members_vertices a1 a2 K first Hd _ _ _ Hp HV ((1 + K)%nat, x)).
        apply (vertex_K_or_later a1 a2 K [] 1 K (path_start a1 a2 K)). }
    destruct HV1 as [_ Hb]; specialize (Hb K ltac:(lia)); cbn [sgn] in Hb. rewrite (Nat.add_comm K 1); unfold b_at; lra.
  - intros Hb; exists K, (K + 1)%nat; split; [lia|].
    split; [apply (orbit_on a1 a2 K first U); [apply K_upper, first | apply member_K, first]|].
    assert (Hcell : cell r s (K + 1) 1).
    { apply unit_cell; [assumption | |]; rewrite plus_INR; cbn [INR]; [apply Rabs_def1|]; lra. }
    destruct (S3_stated r s (K + 1)%nat 1%nat (Build_Farey _ _ _ _ _ _ (unit_neighbours _ HK3)) ltac:(lia) ltac:(lia)
      Hcell) as [HS _]; rewrite plus_INR in HS; cbn [INR] in HS; destruct (HS ltac:(lra)) as [_ _ Ho _ _].
    apply Ho; cbn [n_minus]; replace (K + 1 - 1)%nat with K by lia; exact Hb.
Qed.
End Region3.

Theorem Cycles : Cycle_statement.
Proof.
  split; [intros a1 a2 K H; apply (cycles_Minus a1 a2 K H)|]; intros r s Hr Hs. split.
  - destruct (next_half_exists s Hs) as (K & HK); apply (cycles_Plus_Minus r s Hr Hs K HK).
  - intros K HK; apply (cycles_Plus_Plus r s Hr Hs K HK).
Qed.
