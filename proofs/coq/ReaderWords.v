(** * The readers of certificates of words are right: by signs alone, and by the word theorem *)

From Coq Require Import Reals ZArith List Bool Arith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementWords StatementZ StatementCircleZ StatementReaders
  StatementReaderWords Algebra AppendixA Summary WordAlgebra WordPath WordGraph WordPatterns WordPlane OrbitZ CircleZ
  ReaderCircle ReaderForms.
Import ListNotations. Open Scope R_scope.

Lemma all2_Forall2 {A B} (f : A -> B -> bool) (P : A -> B -> Prop) l : forall l', all2 f l l' = true ->
  (forall x y, In x l -> f x y = true -> P x y) -> Forall2 P l l'.
Proof.
  induction l as [|x l IH]; intros [|y l'] H HP; try discriminate; constructor; cbn [all2] in H; rewrite andb_true_iff
    in H; destruct H as [H1 H2].
  - apply HP; [left; reflexivity | exact H1].
  - apply IH; [exact H2 | intros; apply HP; [right|]; assumption].
Qed.

(** Signs at one point, told by T. *)
Section Signs.
Variables (T : signs) (a1 a2 : R).
Hypotheses (HU : forall k, told (on_u T k) (u a1 a2 k)) (HN : forall l k, told (on_N T l k) (N a1 a2 l k))
  (HZ : forall k, on_zero T k = true -> u a1 a2 k = 0).

Lemma b_told e n k : isS e (timesS (on_u T n) (on_N T n k)) = true -> u a1 a2 n <> 0 /\ sgn e * b a1 a2 n k > 0.
Proof.
  intros H; pose proof (told_is _ _ _ (told_times _ _ _ _ (HU n) (HN n k)) H) as S.
  assert (Hu : u a1 a2 n <> 0) by (intros E; rewrite E in S; lra); split; [exact Hu|].
  rewrite <- (b_N a1 a2 n k Hu) in S; pose proof (Rsqr_pos_lt _ Hu) as Q; unfold Rsqr in Q.
  assert (0 < sgn e * b a1 a2 n k * (u a1 a2 n * u a1 a2 n)) by lra; nra.
Qed.
Lemma letter_told n x : u a1 a2 n <> 0 -> isS (case_of x) (on_N T (2 * n) n) = true -> lettered a1 a2 n x.
Proof.
  intros Hu H; pose proof (told_is _ _ _ (HN (2 * n) n) H) as S; unfold lettered; replace (2 * n)%nat with (n + n)%nat
    in S by lia.
  rewrite <- (I4_product a1 a2 n n Hu Hu) in S; pose proof (Rsqr_pos_lt _ Hu) as Q; unfold Rsqr in Q.
  assert (0 < sgn (case_of x) * (p a1 a2 n - q a1 a2 n) * (u a1 a2 n * u a1 a2 n)) by lra; nra.
Qed.
Lemma period_told e n t : periodZ T e n t = true -> period_says a1 a2 e n t.
Proof.
  destruct t as [x|k|]; cbn [periodZ period_says]; rewrite ?andb_true_iff.
  - intros [[[Hu Hn] Hb] Hx]; destruct (on_u T n) as [z|] eqn:E; [|discriminate].
    pose proof (told_some _ _ _ (HU n) E) as NZ; split; [|apply letter_told; assumption]; split; [exact NZ|].
    intros k Hk; rewrite forallb_forall in Hb; rewrite <- E in Hb; apply b_told, Hb, in_seq; lia.
  - intros [[H1 H2] H]; apply Nat.leb_le in H1; apply Nat.ltb_lt in H2; apply b_told in H; destruct H as [Hu H].
    split; [exact Hu|]; split; [lia|]; destruct e; cbn [flip sgn] in *; lra.
  - apply HZ.
Qed.
Lemma mark_told i j m : u a1 a2 (fst i) <> 0 -> u a1 a2 (fst j) <> 0 -> markZ T i j m = true -> marked a1 a2 i j m.
Proof.
  intros Hi Hj; destruct m as [g|]; cbn [markZ marked]; [|trivial]; intros H.
  pose proof (told_is _ _ _ (told_times _ _ _ _ (HN _ _) (told_times _ _ _ _ (HU (fst i)) (HU (fst j)))) H) as S.
  rewrite (Nat.add_comm (fst i)), <- (I4_product a1 a2 (fst j) (fst i) Hj Hi) in S.
  set (ui := u a1 a2 (fst i)) in *; set (uj := u a1 a2 (fst j)) in *; pose proof (Rsqr_pos_lt _ Hi) as Qi;
    pose proof (Rsqr_pos_lt _ Hj) as Qj; unfold Rsqr in *.
  pose proof (Rmult_lt_0_compat _ _ Qi Qj) as Q; set (x := p a1 a2 (fst j) - q a1 a2 (fst i)) in *.
  assert (0 < sgn g * x * (ui * ui * (uj * uj))) by lra; nra.
Qed.
Lemma occurring_true e L : forall m, Forall2 (period_says a1 a2 e) (seq m (length L)) L -> forall v,
  In v (occurring m L) -> u a1 a2 (fst v) <> 0.
Proof.
  induction L as [|t L IH]; intros m H v Hv; [destruct Hv|]; cbn [length seq] in H;
    inversion_clear H as [|? ? ? ? Ht HL].
  destruct t as [x|k|]; cbn [occurring] in Hv; [destruct Hv as [<-|Hv]; [apply Ht|]|..]; apply (IH (S m) HL v Hv).
Qed.
End Signs.

Theorem Word_reader : Word_reader_statement.
Proof.
  intros W B e L rows a1 a2 H Hin; unfold wordZ in H; cbv zeta in H; rewrite !andb_true_iff, Z.leb_le in H;
    destruct H as [[[HW HB] HL] HR].
  destruct (signs_told W B (2 * length L) a1 a2 HW HB Hin) as (HU & HN & HZ); set (T := signsZ W B (2 * length L)) in *.
  assert (P : Forall2 (period_says a1 a2 e) (seq 1 (length L)) L).
  { apply (all2_Forall2 _ _ _ _ HL); intros n t _ Ht; apply (period_told T a1 a2 HU HN HZ), Ht. }
  split; [exact P|]; pose proof (occurring_true a1 a2 e L 1 P) as NZ; apply (all2_Forall2 _ _ _ _ HR);
    intros i row Hi Hr.
  assert (Row : forall V, (forall v, In v V -> u a1 a2 (fst v) <> 0) -> all2 (markZ T i) V row = true ->
    Forall2 (marked a1 a2 i) V row).
  { intros V HV HVr; apply (all2_Forall2 _ _ _ _ HVr); intros j m Hj Hm; apply (mark_told T a1 a2 HU HN); auto. }
  apply Row; assumption.
Qed.

(** ** Regions *)

Lemma fraction_plus1 h : (0 < snd h)%Z -> fraction (plus1 h) = fraction h + 1.
Proof. intros H; apply IZR_lt in H; unfold fraction, plus1; cbn [fst snd]; rewrite plus_IZR; field; lra. Qed.
Lemma fraction_minus h : fraction (minus h) = - fraction h.
Proof. unfold fraction, minus; cbn [fst snd]; rewrite opp_IZR; unfold Rdiv; ring. Qed.
Lemma fraction_square h : (0 < snd h)%Z -> fraction (square h) = fraction h ^ 2.
Proof. intros H; apply IZR_lt in H; unfold fraction, square; cbn [fst snd]; rewrite !mult_IZR; field; lra. Qed.
Lemma fraction_four h : fraction (four h) = 4 * fraction h.
Proof. unfold fraction, four; cbn [fst snd]; rewrite mult_IZR; unfold Rdiv; ring. Qed.
Lemma fraction_sign h : (0 < snd h)%Z -> ((0 < fst h)%Z -> 0 < fraction h) /\ ((fst h < 0)%Z -> fraction h < 0).
Proof.
  intros H; apply IZR_lt in H; split; intros F; apply IZR_lt in F; unfold fraction, Rdiv;
    pose proof (Rinv_0_lt_compat _ H); nra.
Qed.
Lemma not_less h h' : (0 < snd h)%Z -> (0 < snd h')%Z -> lessZ h h' = false -> fraction h' <= fraction h.
Proof. intros H H' E; apply Rnot_lt_le; intros Q; apply (fraction_less h h' H H') in Q; congruence. Qed.
Theorem Region_reader : Region_reader_statement.
Proof.
  intros B k a1 a2 H Hin; destruct B as [[[h h'] l] l'] eqn:EB; cbn [regionZ] in H; rewrite <- EB in H;
    rewrite andb_true_iff in H; destruct H as [HB H].
  rewrite <- EB in Hin; destruct (box_true B a1 a2 HB Hin) as [HP H2]; subst B; cbn [positive_box in_box] in *; split;
    [exact H2|].
  destruct HP as (A & A' & C & C'), Hin as [I J]; destruct (sqrt_square a2 ltac:(lra)) as [S0 S2].
  assert (D : (0 < snd (square h) /\ 0 < snd (square h'))%Z) by (unfold square; cbn [snd]; nia); destruct D as [D D'].
  destruct (Z.eqb_spec k 1) as [E|_]; [left; split; [exact E|]|].
  { apply (fraction_less (plus1 l') h C' A) in H; rewrite fraction_plus1 in H by assumption; lra. }
  destruct (Z.eqb_spec k 2) as [E|_]; [right; left; split; [exact E|]|].
  { rewrite !andb_true_iff, Z.ltb_lt, negb_true_iff in H; destruct H as [[P Q] F]; apply (fraction_sign h A) in P.
    apply (not_less (square h) (four l') D C') in Q; rewrite fraction_square, fraction_four in Q by assumption.
    apply (fraction_less h' (plus1 l) A' C) in F; rewrite fraction_plus1 in F by assumption; split; [|lra].
    apply Rnot_lt_le; intros X; nra. }
  destruct (Z.eqb_spec k 3) as [E|_]; [right; right; left; split; [exact E|]|].
  { rewrite !andb_true_iff in H; destruct H as [P Q]; apply (fraction_less (square h) (four l) D C) in P;
      apply (fraction_less (square h') (four l) D' C) in Q.
    rewrite fraction_square, fraction_four in P, Q by assumption; destruct (Rle_lt_dec 0 a1); nra. }
  destruct (Z.eqb_spec k 4) as [E|_]; [right; right; right; left; split; [exact E|]|].
  { rewrite !andb_true_iff, Z.ltb_lt, negb_true_iff in H; destruct H as [[P Q] F]; apply (fraction_sign h' A') in P.
    apply (not_less (square h') (four l') D' C') in Q; rewrite fraction_square, fraction_four in Q by assumption.
    apply (fraction_less (minus h) (plus1 l) A C) in F; rewrite fraction_plus1, fraction_minus in F by assumption;
      split; [lra|].
    apply Rnot_lt_le; intros X; nra. }
  destruct (Z.eqb_spec k 5) as [E|_]; [right; right; right; right; left; split; [exact E|]|].
  { apply (fraction_less (plus1 l') (minus h') C' A') in H; rewrite fraction_plus1, fraction_minus in H by assumption;
      lra. }
  rewrite !andb_true_iff, orb_true_iff, Z.eqb_eq in H; destruct H as [[E F] Q]; right; right; right; right; right;
    split; [exact E|].
  apply (fraction_less (minus h) (plus1 l) A C) in F; rewrite fraction_plus1, fraction_minus in F by assumption; split;
    [lra|].
  destruct Q as [Q|Q]; [apply Z.ltb_lt, (fraction_sign h' A') in Q; lra|].
  apply (fraction_less (square h') (four l) D' C) in Q; rewrite fraction_square, fraction_four in Q by assumption.
  apply Rnot_le_lt; intros X; nra.
Qed.
Lemma region_between B k a1 a2 : (k = 3 \/ k = 4 \/ k = 34)%Z -> regionZ B k = true -> in_box B a1 a2 ->
  0 < a2 <= 1 /\ - (a2 + 1) < a1 < 2 * sqrt a2.
Proof.
  intros Hk H Hin; destruct (Region_reader B k a1 a2 H Hin) as [H2 R]; split; [exact H2|].
  destruct (sqrt_square a2 ltac:(lra)) as [S0 S2]; pose proof (pow2_ge_0 (sqrt a2 - 1)).
  destruct R as [[E _]|[[E _]|[[_ R]|[[_ R]|[[E _]|[_ R]]]]]]; try (exfalso; lia); [|lra|exact R].
  pose proof (region3_between a1 a2 ltac:(lra) R); lra.
Qed.

(** ** By the word theorem *)

Section Path.
Variables (T : signs) (a1 a2 : R) (K : nat).
Hypotheses (HU : forall k, told (on_u T k) (u a1 a2 k)) (HN : forall l k, told (on_N T l k) (N a1 a2 l k))
  (HZ : forall k, on_zero T k = true -> u a1 a2 k = 0).

Lemma first_told : 0 < a2 <= 1 /\ - (a2 + 1) < a1 < 2 * sqrt a2 -> firstZ T K = true -> first_upper a1 a2 K.
Proof.
  intros Hreg H; unfold firstZ in H; rewrite !andb_true_iff, Nat.leb_le, forallb_forall in H; destruct H as [[H2 HK] H].
  split; [apply Hreg | split; [apply Hreg|]]; apply (told_is _ _ _ (HU K)) in HK; cbn [sgn on] in *; split; [lra|].
  intros k Hk; destruct k as [|k]; [rewrite u_0; lra|]; specialize (H (S k) ltac:(apply in_seq; lia));
    apply orb_true_iff in H.
  destruct H as [H|H]; [apply (told_is _ _ _ (HU _)) in H; cbn [sgn] in H; lra|].
  apply andb_true_iff in H; rewrite (HZ _ (proj2 H)); lra.
Qed.

Hypothesis first : first_upper a1 a2 K.
Let dec := decided_everywhere a1 a2 K first.

Lemma times_sign x t y : 0 < t -> x * t = - y -> (y < 0 -> 0 < x) /\ (0 < y -> x < 0).
Proof. clear; intros Ht E; split; intros H; apply Rnot_le_lt; intros L; nra. Qed.
Lemma mediant i j w : path a1 a2 K w i j -> let n := (i + j)%nat in (u a1 a2 n < 0 -> N a1 a2 n j < 0 ->
  member a1 a2 Plus n) /\ (u a1 a2 n > 0 -> N a1 a2 n i > 0 -> member a1 a2 Plus n) /\
  (u a1 a2 n < 0 -> N a1 a2 n j > 0 -> ends a1 a2 i j) /\ (u a1 a2 n > 0 -> N a1 a2 n i < 0 -> ends a1 a2 i j) /\
  (u a1 a2 n = 0 -> ~ member a1 a2 Plus n /\ (a2 < 1 -> ends a1 a2 i j)).
Proof.
  intros Hp n; destruct (path_sides a1 a2 K first w i j Hp) as [Si Sj]; destruct (DU a1 a2 i j Si Sj)
    as (t & Ht & E & E'); fold n in E, E'.
  destruct (W5_neighbours a1 a2 K w i j first Hp) as (A & B & C & D); fold n in A, B, C, D; cbn [on] in *; unfold ends;
    fold n.
  assert (X : forall x, u a1 a2 n = x -> member a1 a2 Plus n -> x <> 0) by (intros x <- [Y _]; exact Y).
  destruct (times_sign _ _ _ Ht E) as [P1 P2], (times_sign _ _ _ Ht E') as [Q1 Q2]. split; [|split; [|split; [|split]]].
  - intros Hu HNn; apply A; specialize (P1 HNn); lra.
  - intros Hu HNn; apply B; specialize (Q2 HNn); lra.
  - intros Hu HNn; specialize (P2 HNn); split; [|split; [lra|]]; [intros M; assert (p a1 a2 i > q a1 a2 j) by (apply A;
      auto); lra|].
    intros F; apply D in F; lra.
  - intros Hu HNn; specialize (Q1 HNn); split; [|split; [|lra]]; [intros M; assert (p a1 a2 j < q a1 a2 i) by (apply B;
      auto); lra|].
    intros F; apply C in F; lra.
  - intros Hu; assert (NM : ~ member a1 a2 Plus n) by (intros M; apply (X 0 Hu M); reflexivity); split; [exact NM|];
      intros L.
    split; [exact NM|]; split; intros F; [apply C in F | apply D in F]; lra.
Qed.
Lemma steps_told w : forall w0 i j i' j', path a1 a2 K w0 i j -> stepsZ T i j w = Some (i', j') ->
  path a1 a2 K (w0 ++ w) i' j' /\ Forall (fun x => member a1 a2 Plus (fst x)) (periods i j w).
Proof.
  induction w as [|x w IH]; intros w0 i j i' j' Hp H; cbn [stepsZ periods] in *.
  - injection H as <- <-; rewrite app_nil_r; split; [exact Hp | constructor].
  - replace (w0 ++ x :: w) with ((w0 ++ [x]) ++ w) by (rewrite <- app_assoc; reflexivity); destruct (mediant i j w0 Hp)
      as (MU & MD & _).
    destruct x.
    + destruct (isS Plus (on_u T (i + j))) eqn:E1; [|discriminate]; destruct (isS Plus (on_N T (i + j) i)) eqn:E2;
        [|discriminate].
      apply (told_is _ _ _ (HU _)) in E1; apply (told_is _ _ _ (HN _ _)) in E2; cbn [sgn andb] in *.
      destruct (IH (w0 ++ [D]) (i + j)%nat j i' j' (path_D _ _ _ _ _ _ Hp ltac:(cbn [on]; lra)) H) as [P F]; split;
        [exact P|].
      constructor; [apply MD; lra | exact F].
    + destruct (isS Minus (on_u T (i + j))) eqn:E1; [|discriminate]; destruct (isS Minus (on_N T (i + j) j)) eqn:E2;
        [|discriminate].
      apply (told_is _ _ _ (HU _)) in E1; apply (told_is _ _ _ (HN _ _)) in E2; cbn [sgn andb] in *.
      destruct (IH (w0 ++ [U]) i (i + j)%nat i' j' (path_U _ _ _ _ _ _ Hp ltac:(cbn [on]; lra)) H) as [P F]; split;
        [exact P|].
      constructor; [apply MU; lra | exact F].
Qed.
Lemma end_told w i j z : path a1 a2 K w i j -> endZ T i j z = true -> match z with Open => True
  | Ends_zero => ~ member a1 a2 Plus (i + j) /\ (a2 < 1 -> ends a1 a2 i j) | Ends _ => ends a1 a2 i j end.
Proof.
  intros Hp H; destruct (mediant i j w Hp) as (_ & _ & EU & ED & EZ); destruct z as [[]| |]; cbn [endZ] in H; trivial;
    rewrite ?andb_true_iff in H.
  - destruct H as [H1 H2]; apply (told_is _ _ _ (HU _)) in H1; apply (told_is _ _ _ (HN _ _)) in H2; cbn [sgn] in *;
      apply ED; lra.
  - destruct H as [H1 H2]; apply (told_is _ _ _ (HU _)) in H1; apply (told_is _ _ _ (HN _ _)) in H2; cbn [sgn] in *;
      apply EU; lra.
  - apply EZ, HZ, H.
Qed.
Lemma vertex_letter w i j v : path a1 a2 K w i j -> In v (vertices K w) -> on a1 a2 (fst v) (snd v) /\
  lettered a1 a2 (fst v) (snd v).
Proof.
  intros Hp Hv; destruct v as [n x]; pose proof (vertices_on a1 a2 K first w i j Hp n x Hv) as Hon; cbn [fst snd];
    split; [exact Hon|].
  unfold lettered; pose proof (a2_in a1 a2 K first) as H2; pose proof (a1_in a1 a2 K first) as H1; destruct x;
    cbn [on case_of sgn] in *; [pose proof (lower_pq a1 a2 H2 H1 n Hon) | pose proof (upper_pq a1 a2 H2 H1 n Hon)]; lra.
Qed.

(** The marks of the theorem. *)
Lemma marks_true w i j told : path a1 a2 K w i j -> Forall (fun x => member a1 a2 Plus (fst x)) (vertices K w) ->
  (told = true -> ends a1 a2 i j) -> forall v v' m, In v (vertices K w) -> In v' (vertices K w) ->
  mark_of K w told v v' = m -> marked a1 a2 v v' m.
Proof.
  intros Hp HV Ht v v' m Hv Hv' <-; pose proof (word_table a1 a2 K first dec w i j Hp HV) as Tab.
  destruct (vertex_letter w i j v Hp Hv) as [Ov _], (vertex_letter w i j v' Hp Hv') as [Ov' _]; rewrite Forall_forall
    in HV.
  pose proof (proj2 (orbit_on a1 a2 K first _ _ Ov) (HV v Hv)) as Orb;
    pose proof (proj2 (orbit_on a1 a2 K first _ _ Ov') (HV v' Hv')) as Orb'.
  pose proof (a2_in a1 a2 K first) as [P2 _].
  destruct v as [n x], v' as [n' x']; cbn [fst snd] in *; destruct (W5_neighbours a1 a2 K w i j first Hp)
    as (A & B & _).
  destruct x, x'; cbn [mark_of marked case_of fst snd sgn] in *.
  - pose proof (full_shift a1 a2 Plus P2 Minus n n' Orb Orb') as E; unfold edge in E; cbn [sgn] in E; lra.
  - specialize (Tab n n' Hv Hv'); destruct (renewed n n' 1 K w) as [[]|]; cbn [marked fst snd sgn]; [lra | lra |].
    destruct Tab as [-> ->]; destruct told; [|exact I]; destruct (Ht eq_refl) as (NM & N1 & N2);
      cbn [marked fst snd sgn].
    assert (~ p a1 a2 j < q a1 a2 i) by (intros F; apply B in F; tauto); lra.
  - specialize (Tab n' n Hv' Hv); destruct (renewed n' n 1 K w) as [[]|]; cbn [marked fst snd sgn]; [lra | lra |].
    destruct Tab as [-> ->]; destruct told; [|exact I]; destruct (Ht eq_refl) as (NM & N1 & N2);
      cbn [marked fst snd sgn].
    assert (~ p a1 a2 i > q a1 a2 j) by (intros F; apply A in F; tauto); lra.
  - pose proof (full_shift a1 a2 Plus P2 Plus n n' Orb Orb') as E; unfold edge in E; cbn [sgn] in E; lra.
Qed.
End Path.

Lemma same_mark_true m m' : same_mark m m' = true -> m = m'.
Proof. destruct m as [[]|], m' as [[]|]; cbn; congruence. Qed.
Theorem Path_reader : Path_reader_statement.
Proof.
  intros W B k K last w z rows a1 a2 H Hin; unfold pathZ in H; cbv zeta in H; rewrite !andb_true_iff, !orb_true_iff,
    !andb_true_iff, Z.leb_le, !Z.eqb_eq in H.
  destruct H as [[[[[HW Hk] HR] HF] HS] Hrows].
  assert (HB : boxZ B = true) by (destruct B as [[[h h'] l] l']; cbn [regionZ] in HR; rewrite andb_true_iff in HR;
    apply HR).
  destruct (signs_told W B last a1 a2 HW HB Hin) as (HU & HN & HZ); set (T := signsZ W B last) in *.
  pose proof (region_between B k a1 a2 ltac:(tauto) HR Hin) as Hreg; pose proof (first_told T a1 a2 K HU HZ Hreg HF)
    as first.
  split; [exact first|]; destruct (stepsZ T 1 K w) as [[i j]|] eqn:ES; [|discriminate].
  destruct (steps_told T a1 a2 K HU HN first w [] 1 K i j (path_start _ _ _) ES) as [Hp Fm]; cbn [app] in Hp.
  assert (HV : Forall (fun x => member a1 a2 Plus (fst x)) (vertices K w)).
  { constructor; [apply member_one | constructor; [apply member_K, first | exact Fm]]. }
  pose proof (end_told T a1 a2 K HU HN HZ first w i j z Hp HS) as HE; pose proof (decided_everywhere a1 a2 K first)
    as dec; split; [|split].
  - apply Forall_forall; intros v Hv; rewrite Forall_forall in HV; split;
      [apply HV, Hv | apply (vertex_letter a1 a2 K first w i j v Hp Hv)].
  - assert (Told : toldZ B z = true -> ends a1 a2 i j).
    { destruct z; cbn [toldZ]; intros Ht; [exact HE | | discriminate]; apply HE; destruct B as [[[h h'] l] l'];
        cbn [snd boxZ in_box] in *.
      rewrite !andb_true_iff, !Z.ltb_lt in HB; destruct HB as [[[[[[[_ _] _] Hl'] _] _] _] _], Hin as [_ [_ U2]].
      apply (fraction_less l' (1, 1)%Z Hl' ltac:(reflexivity)) in Ht; unfold fraction at 2 in Ht; cbn [fst snd] in Ht;
        lra. }
    pose proof (marks_true a1 a2 K first w i j (toldZ B z) Hp HV Told) as M; unfold rows_say.
    apply (all2_Forall2 _ _ _ _ Hrows); intros v row Hv Hrow; apply (all2_Forall2 _ _ _ _ Hrow); intros v' m Hv' Hm.
    apply (M v v' m Hv Hv'), same_mark_true, Hm.
  - exists i, j; split; [exact Hp|]; intros n Hn; rewrite in_map_iff.
    assert (Closed : ~ member a1 a2 Plus (i + j) -> exists x, fst x = n /\ In x (vertices K w)).
    { intros NM; destruct (V_is_word a1 a2 K first dec w i j Hp NM n Hn) as (x & Hx & E); exists x; auto. }
    destruct z as [x| |]; [left; apply Closed, (proj1 HE) | left; apply Closed, (proj1 HE)|].
    destruct (W3 a1 a2 K first) as (_ & _ & _ & On & _); destruct (On n Hn) as [->|[->|(w' & i' & j' & Hp' & ->)]];
      [left; exists (1%nat, D); cbn; auto | left; exists (K, U); cbn; auto|].
    destruct (paths_agree a1 a2 K first w i j w' i' j' Hp Hp') as [(t & ->)|(x & t & ->)].
    + right; split; [reflexivity|]; clear - first Hp Hp'; destruct t as [|x t].
      * rewrite app_nil_r in Hp'; destruct (path_unique a1 a2 K w i j i' j' Hp Hp'); lia.
      * destruct (path_prefix a1 a2 K first w x t i' j' Hp') as (i0 & j0 & Hp0 & _ & _ & L1 & L2);
          destruct (path_unique a1 a2 K w i j i0 j0 Hp Hp0) as [<- <-].
        destruct x; cbn [final fst snd] in *; lia.
    + left; exists ((i' + j')%nat, x); split; [reflexivity | apply (vertex_K_or_later a1 a2 K w' i' j' Hp')].
Qed.
Theorem Below_reader : Below_reader_statement.
Proof.
  intros W B k n a1 a2 H Hin l; unfold belowZ in H; cbv zeta in H; rewrite !andb_true_iff, !orb_true_iff, Z.leb_le,
    !Z.eqb_eq, Nat.leb_le, forallb_forall in H.
  destruct H as [[[[[HW Hk] HR] Hn] HF] HE].
  assert (HB : boxZ B = true) by (destruct B as [[[h h'] l'] l'']; cbn [regionZ] in HR; rewrite andb_true_iff in HR;
    apply HR).
  destruct (signs_told W B (S n) a1 a2 HW HB Hin) as (HU & HN & HZ); set (T := signsZ W B (S n)) in *.
  destruct (region_between B k a1 a2 ltac:(tauto) HR Hin) as [H2 H1].
  assert (Pos : forall m, (1 <= m <= n)%nat -> u a1 a2 m > 0).
  { intros m Hm; specialize (HF m ltac:(apply in_seq; lia)); apply (told_is _ _ _ (HU m)) in HF; cbn [sgn] in HF; lra. }
  assert (HK : exists K, first_upper a1 a2 K /\ ((n < K)%nat /\ forall m, (n < m < K)%nat -> u a1 a2 m = 0)).
  { destruct HE as [HE|HE].
    - apply (told_is _ _ _ (HU _)) in HE; cbn [sgn] in HE; exists (S n); split; [|split; [lia | intros; lia]].
      split; [exact H2 | split; [exact H1 | cbn [on]; split; [lra|]]]; intros m Hm; destruct m as [|m];
        [rewrite u_0; lra|].
      left; apply Pos; lia.
    - apply HZ in HE; exists (S (S n)); split; [|split; [lia | intros m Hm; replace m with (S n) by lia; exact HE]].
      split; [exact H2 | split; [exact H1 | cbn [on]; split]]; [rewrite u_SS, HE; specialize (Pos n ltac:(lia)); nra|].
      intros m Hm; destruct m as [|m]; [rewrite u_0; lra|]; destruct (Nat.eq_dec (S m) (S n)) as [->|];
        [lra | left; apply Pos; lia]. }
  destruct HK as (K & first & LK & Zero); assert (M : member a1 a2 Minus l <-> (1 <= l <= n)%nat).
  { rewrite (Minus_members a1 a2 K first (decided_everywhere a1 a2 K first)); split; [intros [L NZ] | intros L;
      specialize (Pos l L); split; [lia | lra]].
    destruct l as [|l]; [rewrite u_0 in NZ; lra|]; destruct (le_lt_dec (S l) n) as [Q|Q];
      [lia | destruct (NZ (Zero (S l) ltac:(lia)))]. }
  split; [exact M|]; intros Hl; specialize (Pos l Hl); unfold lettered; cbn [case_of sgn].
  destruct (lower_pq a1 a2 H2 (a1_in a1 a2 K first) l Pos); lra.
Qed.
Lemma lonely_told a1 a2 e g e' (all : bool) x : (forall n, (1 <= n)%nat -> orbit a1 a2 n e g) -> sgn (case_of x) = sgn e
  * sgn g -> (if all then e' = e else e' <> e) -> forall n, (member a1 a2 e' n <-> n = 1%nat \/ all = true /\
  (1 <= n)%nat) /\ (member a1 a2 e' n -> lettered a1 a2 n x).
Proof.
  intros H Hx He n; assert (M : member a1 a2 e' n <-> n = 1%nat \/ all = true /\ (1 <= n)%nat).
  { split.
    - intros Hm; pose proof (u_nonzero_pos a1 a2 n (proj1 Hm)); destruct all; [tauto|]; destruct (Nat.eq_dec n 1)
        as [|Hn]; [tauto | exfalso].
      apply He, (only_sign a1 a2 e g H n e' ltac:(lia) Hm).
    - intros [->|[-> Hn]]; [apply member_one | subst e'; apply (orbit_member_edge a1 a2 e g n), H, Hn]. }
  split; [exact M|]; intros Hm; pose proof (u_nonzero_pos a1 a2 n (proj1 Hm)) as Hn; destruct (H n Hn) as (Hu & _ & Hc).
  unfold lettered; rewrite Hx, <- (I1 a1 a2 n Hu); exact Hc.
Qed.
Theorem Lonely_reader : Lonely_reader_statement.
Proof.
  intros B k e all x a1 a2 H Hin; unfold lonelyZ in H; destruct (regionZ B k) eqn:HR; [|discriminate]; cbn [negb] in H.
  destruct (Region_reader B k a1 a2 HR Hin) as [H2 R].
  assert (R1 : k = 1%Z -> forall n, (1 <= n)%nat -> orbit a1 a2 n Plus Plus) by (intros Hk n Hn; apply Region1;
    [lra | decompose [or and] R; try (exfalso; lia); lra | exact Hn]).
  assert (R2 : k = 2%Z -> forall n, (1 <= n)%nat -> orbit a1 a2 n Minus Plus).
  { intros Hk n Hn; assert (Q : 2 * sqrt a2 <= a1 < a2 + 1) by (decompose [or and] R; try (exfalso; lia); lra).
    apply Region2; [|exact Q|exact Hn]; destruct (sqrt_square a2 ltac:(lra)) as [S0 S2]; split; [lra|].
    apply Rnot_le_lt; intros Q1; assert (sqrt a2 = 1) by (replace a2 with 1 by lra; apply sqrt_1); lra. }
  assert (R5 : k = 5%Z -> forall n, (1 <= n)%nat -> orbit a1 a2 n Plus Minus) by (intros Hk n Hn; apply Region5;
    [lra | exact Hn | left; decompose [or and] R; try (exfalso; lia); lra]).
  destruct e.
  - destruct (Z.eqb_spec k 1) as [E|_]; [injection H as <- <-; apply (lonely_told a1 a2 Plus Plus); auto;
      cbn [case_of sgn]; lra|].
    destruct (Z.eqb_spec k 2) as [E|_]; [injection H as <- <-; apply (lonely_told a1 a2 Minus Plus); auto;
      [cbn [case_of sgn]; lra | congruence]|].
    destruct (Z.eqb_spec k 5) as [E|_]; [|discriminate]; injection H as <- <-; apply (lonely_told a1 a2 Plus Minus);
      auto; cbn [case_of sgn]; lra.
  - destruct (Z.eqb_spec k 1) as [E|_]; [injection H as <- <-; apply (lonely_told a1 a2 Plus Plus); auto;
      [cbn [case_of sgn]; lra | congruence]|].
    destruct (Z.eqb_spec k 2) as [E|_]; [injection H as <- <-; apply (lonely_told a1 a2 Minus Plus); auto;
      cbn [case_of sgn]; lra|].
    destruct (Z.eqb_spec k 5) as [E|_]; [rewrite orb_true_r in H; injection H as <- <-;
      apply (lonely_told a1 a2 Plus Minus); auto; [cbn [case_of sgn]; lra | congruence]|].
    destruct (Z.eqb_spec k 4) as [E|_]; [|discriminate]; injection H as <- <-.
    destruct (region_between B k a1 a2 ltac:(tauto) HR Hin) as [_ H1]; destruct (first_exists a1 a2 H2 H1) as [K first].
    assert (K = 2%nat) as ->. { apply (proj1 (proj2 Path) a1 a2 K first); destruct (sqrt_square a2 ltac:(lra));
                                  decompose [or and] R; try (exfalso; lia); nra. }
    assert (M : forall n, member a1 a2 Minus n <-> n = 1%nat \/ false = true /\ (1 <= n)%nat).
    { intros n; rewrite (Minus_members a1 a2 2 first (decided_everywhere a1 a2 2 first)); split.
      - intros [L NZ]; destruct n as [|n]; [rewrite u_0 in NZ; lra | left; lia].
      - intros [->|[X _]]; [split; [lia | rewrite u_1; lra] | discriminate]. }
    intros n; split; [apply M|]; intros Hm; apply M in Hm; destruct Hm as [->|[X _]]; [|discriminate].
    unfold lettered; cbn [case_of sgn]; destruct (lower_pq a1 a2 H2 (a1_in a1 a2 2 first) 1 ltac:(rewrite u_1; lra));
      lra.
Qed.
