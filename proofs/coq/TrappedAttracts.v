(** * The attractor of [Headline], from its parts *)
From Coq Require Import Reals ZArith Lra Lia.
From Grazing Require Import StatementTrapped TrappedFlow TrappedMain TrappedSeparate TrappedExists TrappedStarts
  TrappedCone TrappedAll TrappedExponent TrappedAlmost TrappedSmall.
From Grazing Require Headline.
Open Scope R_scope.

Theorem Attractor : Headline.Attractor_statement.
Proof.
  split.
  - intros M lo hi E X Ch Be; pose proof Ch as [O HE HN]; pose proof O as [H Hb Ho]; constructor.
    + intros t V Tr; destruct (Trapped M lo hi O t V Tr) as (Ex & k & _ & All); split; [exact Ex|]; intros t' V' x v
        L; apply (All t' V' x v L).
    + intros s x v; apply (Started M lo hi X s x v O Be).
    + intros t V t' V' x v d w d' w' Tr NV L [-> ->] C; destruct (Trapped M lo hi O t V Tr) as (_ & k & Hk & All);
        destruct (All t' V' x v L) as (_ & n & Hn & Pn); apply (Cone M lo hi O t V t' V' x v k n d w E Tr NV L Hk Pn
          (HN n Hn) C).
    + intros N t V x v t' V' x' v' i [HM Tr] [HM' Tr']; cbv zeta; set (s := t' (S i)); intros L Hx Hz; destruct
        (ordered_step M lo hi E H Hb Ho HE N HN i t V x v t' V' x' v' (x' i s - x i s) HM HM' Tr Tr' Hx) as (_ & O1 &
          O2 & _ & O3); unfold zet in *; [unfold ordered, zet; fold s|]; repeat split; lra.
    + intros T K P N t V x v; apply (No_stable M lo hi E Ch T).
    + apply (proj2 (Exponent M lo hi O) E Ch).
    + apply (proj1 (Exponent M lo hi O)).
    + intros s q; apply (Almost M lo hi X s q O Be).
  - intros d w tau Hd Hw Ht; set (l := exp _); intros Hl; assert (L1 : l < 1).
    { assert (0 < (d - sqrt (d ^ 2 - 1)) / w).
      { assert (sqrt (d ^ 2 - 1) < d) by (rewrite <- (sqrt_pow2 d) at 2 by lra; apply sqrt_lt_1_alt; nra); apply
          Rdiv_lt_0_compat; lra. } unfold l; rewrite <- exp_0; apply exp_increasing; cbn [a paper]; pose proof
      PI_RGT_0; assert (0 < (d - sqrt (d ^ 2 - 1)) / w * (2 * PI)) by (apply Rmult_lt_0_compat; lra); lra. } set (E :=
    (1 + l / (2 * (1 - l))) / 2); exists E; apply (Small d w tau E Hd Hw Ht); fold l; assert (1 < l / (2 * (1 - l)));
      [|unfold E; lra]. apply Rmult_lt_reg_r with (2 * (1 - l)); [lra|]; replace (l / (2 * (1 - l)) * (2 * (1 - l)))
      with l by (field; lra); lra.
Qed.
