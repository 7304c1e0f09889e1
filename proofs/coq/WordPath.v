(** * Along the path periods grow, each below s (D) or above it (U), as the signs of u say

    Combinatorics of words, and what follows from the signs of u along the path. *)

From Coq Require Import Reals List Arith Lra Lia.
From Grazing Require Import Defs Statement StatementPlane StatementWords Algebra InsideTriangle WordAlgebra.
Import ListNotations.
Open Scope R_scope.

(** ** Words as lists *)

(** The current pair after the letters w. *)
Fixpoint final (i j : nat) (w : list letter) : nat * nat :=
  match w with
  | [] => (i, j)
  | D :: w => final (i + j) j w
  | U :: w => final i (i + j) w
  end.

Lemma periods_snoc w x : forall i j, periods i j (w ++ [x]) =
  periods i j w ++ [((fst (final i j w) + snd (final i j w))%nat, x)].
Proof.
  induction w as [|y w IH]; intros i j; [destruct x; reflexivity|].
  destruct y; cbn [app periods final]; rewrite IH; reflexivity.
Qed.
Lemma final_snoc w x : forall i j, final i j (w ++ [x]) =
  let (i', j') := final i j w in
  match x with D => ((i' + j')%nat, j') | U => (i', (i' + j')%nat) end.
Proof. induction w as [|y w IH]; intros i j; [destruct x; reflexivity|]. destruct y; cbn [app final]; apply IH. Qed.
Lemma renewed_snoc i j w x : forall i' j', renewed i j i' j' (w ++ [x]) =
  match renewed i j i' j' w with
  | Some y => Some y
  | None => renewed i j (fst (final i' j' w)) (snd (final i' j' w)) [x]
  end.
Proof.
  induction w as [|y w IH]; intros i' j'; [reflexivity|].
  destruct y; cbn [app renewed final]; destruct Nat.eqb; trivial; apply IH.
Qed.
Lemma app_inj_last {T} (w w' : list T) x x' : w ++ [x] = w' ++ [x'] -> w = w' /\ x = x'.
Proof. apply app_inj_tail. Qed.

(** Two words agree as far as both go, or differ first at some letter. *)
Lemma compare_words (w : list letter) : forall w', (exists t, w' = w ++ t) \/ (exists x t, w = w' ++ x :: t) \/
  exists c x y t t', x <> y /\ w = c ++ x :: t /\ w' = c ++ y :: t'.
Proof.
  induction w as [|x w IH]; intros [|y w'].
  - left; exists []; reflexivity.
  - left; exists (y :: w'); reflexivity.
  - right; left; exists x, w; reflexivity.
  - destruct x, y; try (right; right; exists [], D, U, w, w'; repeat split; congruence);
      try (right; right; exists [], U, D, w, w'; repeat split; congruence);
      (destruct (IH w') as [[t ->]|[(z & t & ->)|(c & z & z' & t & t' & Hz & -> & ->)]]; [left; exists t; reflexivity |
      right; left; exists z, t; reflexivity | right; right; eexists (_ :: c), z, z', t, t'; repeat split; assumption]).
Qed.

Section Path.
Variables (a1 a2 : R) (K : nat).
Hypothesis first : first_upper a1 a2 K.
Notation u := (u a1 a2).
Notation b := (b a1 a2).
Notation p := (p a1 a2).
Notation q := (q a1 a2).
Notation on := (on a1 a2).
Notation member := (member a1 a2).
Notation edge := (edge a1 a2).
Notation path := (path a1 a2 K).

Lemma a2_in : 0 < a2 <= 1. Proof. apply first. Qed.
Lemma a1_in : Rabs a1 < a2 + 1.
Proof.
  destruct first as (H2 & H1 & _); pose proof (sqrt_sqrt a2 ltac:(lra)).
  pose proof (pow2_ge_0 (1 - sqrt a2)); apply Rabs_def1; lra.
Qed.
Lemma K_upper : u K < 0. Proof. apply first. Qed.
Lemma K_ge_2 : (2 <= K)%nat.
Proof. pose proof K_upper; destruct K as [|[|k]]; [rewrite u_0 in *; lra | rewrite u_1 in *; lra | lia]. Qed.
Lemma on_one : on 1 D. Proof. cbn [StatementWords.on]; rewrite u_1; lra. Qed.
Lemma on_nonzero n x : on n x -> u n <> 0. Proof. destruct x; cbn [StatementWords.on]; lra. Qed.
Lemma member_one e : member e 1. Proof. split; [rewrite u_1; lra | intros; lia]. Qed.

(** All u_k before K are >= 0 and u_K < 0: every term of u_K - u_k - a2^k u_{K-k} is. *)
Lemma member_K : member Plus K.
Proof.
  pose proof K_upper as HK; destruct first as (H2 & _ & _ & Hk); split; [lra|].
  intros k Hk'; cbn [sgn]; rewrite Rmult_1_l. pose proof (Hk k ltac:(lia)); pose proof (Hk (K - k)%nat ltac:(lia)).
  pose proof (pow_lt a2 k ltac:(lra)); pose proof (b_N a1 a2 K k ltac:(lra)) as E. unfold N in E; nra.
Qed.
Lemma path_final w i j : path w i j -> final 1 K w = (i, j).
Proof. induction 1 as [|w i j H IH Hon|w i j H IH Hon]; [reflexivity|..]; rewrite final_snoc, IH; reflexivity. Qed.
Lemma vertices_snoc w i j x : path w i j -> vertices K (w ++ [x]) = vertices K w ++ [((i + j)%nat, x)].
Proof. intros H; unfold vertices; rewrite periods_snoc, (path_final _ _ _ H); reflexivity. Qed.
Lemma path_sides w i j : path w i j -> 0 < u i /\ u j < 0.
Proof.
  induction 1 as [|w i j H IH Hon|w i j H IH Hon]; cbn [StatementWords.on] in *; [|tauto..].
  split; [apply on_one | apply K_upper].
Qed.
Lemma path_pos w i j : path w i j -> (1 <= i)%nat /\ (K <= j)%nat. Proof. induction 1; lia. Qed.
Lemma path_prefix w x t : forall i j, path (w ++ x :: t) i j ->
  exists i' j', path w i' j' /\ on (i' + j') x /\ path (w ++ [x]) (fst (final i' j' [x])) (snd (final i' j' [x])) /\
  (fst (final i' j' [x]) <= i)%nat /\ (snd (final i' j' [x]) <= j)%nat.
Proof.
  induction t as [|y t IH] using rev_ind; intros i j H.
  - inversion H as [E|w' i' j' H' Hon E|w' i' j' H' Hon E]; subst.
    + destruct w; discriminate.
    + apply app_inj_last in E as [-> <-]; exists i', j; cbn [final fst snd].
      refine (conj H' (conj Hon (conj H _))); lia.
    + apply app_inj_last in E as [-> <-]; exists i, j'; cbn [final fst snd].
      refine (conj H' (conj Hon (conj H _))); lia.
  - rewrite app_comm_cons, app_assoc in H. inversion H as [E|w' i' j' H' Hon E|w' i' j' H' Hon E]; subst.
    + destruct (w ++ x :: t); discriminate.
    + apply app_inj_last in E as [-> <-]; destruct (IH _ _ H') as (i0 & j0 & H0 & H1 & H2 & H3).
      exists i0, j0; repeat split; trivial; lia.
    + apply app_inj_last in E as [-> <-]; destruct (IH _ _ H') as (i0 & j0 & H0 & H1 & H2 & H3).
      exists i0, j0; repeat split; trivial; lia.
Qed.
Lemma path_unique w i j i' j' : path w i j -> path w i' j' -> i = i' /\ j = j'.
Proof. intros H H'; apply path_final in H, H'; rewrite H in H'; inversion H'; auto. Qed.

(** There is one path. *)
Lemma paths_agree w i j w' i' j' : path w i j -> path w' i' j' ->
  (exists t, w' = w ++ t) \/ (exists x t, w = w' ++ x :: t).
Proof.
  intros H H'; destruct (compare_words w w') as [E|[E|(c & x & y & t & t' & Hxy & -> & ->)]]; [tauto..|exfalso].
  apply path_prefix in H as (i0 & j0 & H0 & Hx & _), H' as (i1 & j1 & H1 & Hy & _).
  destruct (path_unique _ _ _ _ _ H0 H1) as [<- <-]. destruct x, y; cbn [StatementWords.on] in *; congruence || lra.
Qed.
Lemma vertices_on w i j : path w i j -> forall k x, In (k, x) (vertices K w) -> on k x.
Proof.
  induction 1 as [|w i j H IH Hon|w i j H IH Hon]; intros k x Hk.
  - destruct Hk as [E|[E|[]]]; injection E as <- <-; [apply on_one | apply K_upper].
  - rewrite (vertices_snoc _ _ _ _ H), in_app_iff in Hk.
    destruct Hk as [Hk|[E|[]]]; [apply IH, Hk | injection E as <- <-; assumption].
  - rewrite (vertices_snoc _ _ _ _ H), in_app_iff in Hk.
    destruct Hk as [Hk|[E|[]]]; [apply IH, Hk | injection E as <- <-; assumption].
Qed.

(** ** Lower and upper periods *)

Lemma lower_upper i j : 0 < u i -> u j < 0 -> p i < p j /\ (q j < p i -> q i < p j) /\ (p j < q i -> p i < q j).
Proof.
  intros Hi Hj; destruct (W2 a1 a2 a2_in a1_in) as [_ H].
  destruct (H i j Hi Hj) as (? & ? & ?); repeat split; trivial; lra.
Qed.
Lemma orbit_on x n : on n x -> (orbit a1 a2 n Plus (case_of x) <-> member Plus n).
Proof.
  intros Hx; destruct (sign_c a1 a2 a2_in a1_in n (on_nonzero _ _ Hx)) as [H1 H2].
  unfold orbit, StatementWords.member; destruct x; cbn [StatementWords.on sgn case_of] in *; specialize (H1 Hx) ||
    specialize (H2 Hx); split; intros; repeat split; try tauto; lra.
Qed.
Lemma orbit_case n g : orbit a1 a2 n Plus g <-> exists x, on n x /\ g = case_of x /\ member Plus n.
Proof.
  split; [|intros (x & Hx & -> & H); apply orbit_on; assumption].
  intros (Hu & Hb & Hc); destruct (sign_c a1 a2 a2_in a1_in n Hu) as [H1 H2].
  destruct (Rdichotomy _ _ Hu) as [Hs|Hs]; [exists U; specialize (H2 Hs) | exists D; specialize (H1 Hs)];
    (destruct g; cbn [sgn] in Hc; try (exfalso; lra)); repeat split; assumption.
Qed.

(** The numerators N_{n,j}, N_{n,i} of the mediant n = i + j tell the edges. *)
Lemma DU i j : 0 < u i -> u j < 0 -> let n := (i + j)%nat in
  exists t, 0 < t /\ (p i - q j) * t = - N a1 a2 n j /\ (p j - q i) * t = - N a1 a2 n i.
Proof.
  intros Hi Hj n; exists (u i * - u j); split; [nra|]. pose proof (I4_product a1 a2 i j ltac:(lra) ltac:(lra)) as E.
  pose proof (I4_product a1 a2 j i ltac:(lra) ltac:(lra)) as E'. rewrite (Nat.add_comm j i) in E'; fold n in E, E'; lra.
Qed.

(** u_n = 0: both numerators are those of 1 - u_{n+1}, and u_{n+1}^2 = a2^n. *)
Lemma singular i j : 0 < u i -> u j < 0 -> u (i + j) = 0 ->
  p i <= q j /\ q i <= p j /\ (p i = q j <-> a2 = 1) /\ (p j = q i <-> a2 = 1).
Proof.
  intros Hi Hj H0; destruct (DU i j Hi Hj) as (t & Ht & E & E'). set (n := (i + j)%nat) in *; set (w := u (S n)).
  pose proof (u_nonzero_pos a1 a2 i ltac:(lra)) as Hi1.
  assert (F : a2 ^ j * u i = - w * u j).
  { rewrite u_addition; fold n w; rewrite H0; ring. }
  assert (F' : a2 ^ i * u j = - w * u i).
  { rewrite u_addition; replace (j + i)%nat with n by (unfold n; lia); fold w; rewrite H0; ring. }
  assert (Hw : 0 < w) by (pose proof (pow_lt a2 j ltac:(apply a2_in)); nra).
  assert (Ew : w * w = a2 ^ n) by (pose proof (u_Cassini a1 a2 n) as C; rewrite H0 in C; fold w in C; lra).
  unfold N in E, E'; replace (n - j)%nat with i in E by (unfold n; lia).
  replace (n - i)%nat with j in E' by (unfold n; lia); rewrite F in E; rewrite F' in E'; rewrite H0 in *.
  pose proof (pow_at_most_1 a2 n a2_in); assert (w <= 1) by nra.
  assert (Hone : a2 = 1 <-> w = 1).
  { split; [intros ->; rewrite pow1 in Ew; nra|intros Hw1]. destruct (Req_dec a2 1) as [|Hne]; [assumption|exfalso].
    pose proof (RealEigenvalues.pow_below_1 a2 n ltac:(pose proof a2_in; lra) ltac:(unfold n; lia)).
    rewrite Hw1 in Ew; lra. }
  assert (G : p i - q j = - (1 - w) * (- u j / t)) by (field_simplify_eq; lra).
  assert (G' : p j - q i = (1 - w) * (u i / t)) by (field_simplify_eq; lra).
  assert (0 < - u j / t) by (apply Rdiv_lt_0_compat; lra). assert (0 < u i / t) by (apply Rdiv_lt_0_compat; lra).
  set (x := - u j / t) in *; set (y := u i / t) in *; rewrite Hone. repeat split; intros; try nra.
Qed.

(** The mediant's two b cannot both be <= 0. *)
Lemma not_both i j : 0 < u i -> u j < 0 -> u (i + j) <> 0 -> b (i + j) i <= 0 -> b (i + j) j <= 0 -> False.
Proof.
  intros Hi Hj Hn; destruct (lower_upper i j Hi Hj) as [HM _].
  rewrite (I2 a1 a2 (i + j) i), (I2 a1 a2 (i + j) j) by (lia || lra); intros.
  assert (p (i + j) <= p i) by nra; assert (p j <= p (i + j)) by nra; lra.
Qed.
End Path.
