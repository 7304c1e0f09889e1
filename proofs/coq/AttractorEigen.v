(** * Expanding matrices: an eigenvector in the cone, and that it makes a fixed point unstable *)
From Coq Require Import Reals Lra Lia Arith.
From Grazing Require Import StatementPlane.
From Grazing Require Import StatementAttractor AttractorAlgebra AttractorDerivative.
Open Scope R_scope.

Section Eigen.
Variables l1 l2 : R.
Hypothesis Hl : 0 < l2 < l1.
Notation change := (change l1 l2).
Notation cone := (cone l1 l2).

Lemma eigenvector J E : 0 < E -> (forall v, cone v -> cone (apply J v) /\ Rabs (change (apply J v)) >= E *
  Rabs (change v)) ->
  exists v e, cone v /\ change v = 1 /\ apply J v = scale e v /\ Rabs e >= E.
Proof.
  intros HE HJ. set (M := 2 * l2 / (l1 - l2)). assert (PM : 0 < M) by (unfold M; apply Rdiv_lt_0_compat; lra).
  set (v := fun t => ((1 + t) / l1, t / l2)). assert (cv : forall t, change (v t) = 1).
  { intros t. unfold v, StatementAttractor.change; simpl. field. lra. }
  assert (qv : forall t, l2 * snd (v t) = t) by (intros t; unfold v; simpl; field; lra).
  assert (Hv : forall t, - M <= t <= M -> cone (v t)).
  { intros t Ht. unfold StatementAttractor.cone. rewrite cv, qv, Rabs_R1, Rmult_1_r. fold M. apply Rabs_le. lra. }
  set (f := fun t => change (apply J (v t))). set (q := fun t => l2 * snd (apply J (v t))).
  assert (Hf : forall t, - M <= t <= M -> Rabs (q t) <= M * Rabs (f t) /\ E <= Rabs (f t)).
  { intros t Ht. destruct (HJ (v t) (Hv t Ht)) as [H1 H2]. rewrite cv, Rabs_R1 in H2. split; [exact H1|].
    unfold f. lra. }
  set (g := fun t => q t - t * f t). assert (Hg : continuity g).
  { unfold g, q, f, v, StatementAttractor.change, apply; simpl. unfold Rdiv. reg. }
  assert (Haff : forall t, f t = ((M - t) * f (- M) + (t + M) * f M) / (2 * M)).
  { intros t. unfold f, v, StatementAttractor.change, apply; simpl. field. lra. } assert (Hs : 0 < f (- M) * f M).
  { destruct (Hf (- M)) as [_ A]; [lra|]. destruct (Hf M) as [_ B]; [lra|]. destruct (Rle_or_lt (f (- M) * f M) 0) as
      [C|C]; [exfalso|exact C]. assert (D : f (- M) - f M <> 0).
    { intros D. replace (f (- M)) with (f M) in C by lra. assert (0 < f M ^ 2). { rewrite <- pow2_abs.
      apply pow_lt. lra. } nra. }
    set (t := M * (f (- M) + f M) / (f (- M) - f M)). assert (Ft : f t = 0). { rewrite Haff. unfold t. field. lra.
    } assert (Ht : - M <= t <= M).
    { assert (D2 : 0 < (f (- M) - f M) ^ 2) by (rewrite <- pow2_abs; apply pow_lt; apply Rabs_pos_lt; lra).
      assert (S : (f (- M) + f M) ^ 2 <= (f (- M) - f M) ^ 2) by nra. assert (T : (t / M) ^ 2 <= 1).
      { replace ((t / M) ^ 2) with ((f (- M) + f M) ^ 2 / (f (- M) - f M) ^ 2) by (unfold t; field; lra).
        apply div_le; lra. }
      assert (- 1 <= t / M <= 1) by (split; nra). replace t with (t / M * M) by (field; lra). split; nra. }
    destruct (Hf t Ht) as [_ F]. rewrite Ft, Rabs_R0 in F. lra. }
  assert (Hc : g (- M) * g M <= 0).
  { destruct (Hf (- M)) as [A _]; [lra|]. destruct (Hf M) as [B _]; [lra|]. unfold g. destruct (Rle_or_lt 0 (f M)) as
      [C|C].
    - assert (0 <= f (- M)) by nra. rewrite (Rabs_pos_eq (f (- M))) in A by lra. rewrite (Rabs_pos_eq (f M)) in B by
        lra. apply Rabs_le_inv in A, B || (unfold Rabs in A, B; destruct (Rcase_abs (q (- M)));
        destruct (Rcase_abs (q M))); nra.
    - assert (f (- M) <= 0) by nra. rewrite (Rabs_left1 (f (- M))) in A by lra. rewrite (Rabs_left1 (f M)) in B by
        lra. unfold Rabs in A, B; destruct (Rcase_abs (q (- M))); destruct (Rcase_abs (q M)); nra. }
  destruct (IVT_cor g (- M) M Hg) as (t & Ht & Gt); [lra|exact Hc|]. exists (v t), (f t). split; [apply Hv;
    exact Ht|]. split; [apply cv|]. split; [|apply Rle_ge; apply Hf; exact Ht]. assert (Q : q t = t * f t) by (unfold
    g in Gt; lra). assert (S : snd (apply J (v t)) = t * f t / l2). { rewrite <- Q. unfold q. field. lra.
  } assert (F : fst (apply J (v t)) = (f t + t * f t) / l1).
  { replace (f t) with (l1 * fst (apply J (v t)) - l2 * snd (apply J (v t))) at 1 by reflexivity. rewrite S.
    field. lra. }
  rewrite (surjective_pairing (apply J (v t))), S, F. unfold scale, v; simpl. f_equal; field; lra.
Qed.
End Eigen.

(** ** Instability of a fixed point with one multiplier outside the unit circle *)
Lemma unstable_fixed G x J v e : G x = x -> derivative G x J -> v <> (0, 0) -> apply J v = scale e v ->
  1 < Rabs e ->
  Rabs (det J) <= 1 -> exists r, r > 0 /\ forall eps, eps > 0 -> exists z i,
  norm (sub z x) < eps /\ norm (sub (Nat.iter i G z) x) > r.
Proof.
  intros Hx HG Hv HJ He Hdet. set (n2 := fst v ^ 2 + snd v ^ 2). assert (Hn : 0 < n2).
  { unfold n2. pose proof (pow2_ge_0 (fst v)). pose proof (pow2_ge_0 (snd v)). destruct (Rle_or_lt (fst v ^ 2 + snd v
      ^ 2) 0) as [C|C]; [exfalso|exact C]. apply Hv. rewrite (surjective_pairing v). f_equal; nra. }
  set (nv := norm v). assert (Hnv : 0 < nv).
  { unfold nv. destruct (Rle_or_lt (norm v) 0) as [C|C]; [exfalso|exact C]. apply norm_le in C.
    destruct C as [C1 C2]. unfold n2 in Hn. rewrite <- (pow2_abs (fst v)), <- (pow2_abs (snd v)) in Hn.
    pose proof (Rabs_pos (fst v)). pose proof (Rabs_pos (snd v)). nra. }
  set (a := fun h : R * R => (fst h * fst v + snd h * snd v) / n2). set (bt := fun h : R * R => (snd h * fst v - fst h
    * snd v) / n2). assert (Hf : forall h, fst h = a h * fst v - bt h * snd v) by (intros h; unfold a, bt, n2 in *;
    field; lra). assert (Hg : forall h, snd h = a h * snd v + bt h * fst v) by (intros h;
      unfold a, bt, n2 in *; field; lra). assert (Jv1 : m11 J * fst v + m12 J * snd v = e * fst v) by (apply (f_equal
      fst) in HJ; exact HJ). assert (Jv2 : m21 J * fst v + m22 J * snd v = e * snd v) by (apply (f_equal snd) in HJ;
      exact HJ). set (k := a (apply J (- snd v, fst v))). assert (He0 : e <> 0). { intros C.
    rewrite C, Rabs_R0 in He. lra. } assert (Ja : forall h, a (apply J h) = e * a h + k * bt h).
  { assert (A : forall al be, a (apply J (al * fst v - be * snd v, al * snd v + be * fst v)) = e * al + k * be).
    { intros al be. replace (e * al) with ((al * (e * fst v) * fst v + al * (e * snd v) * snd v) / n2) by (unfold n2
        in *; field; lra). rewrite <- Jv1, <- Jv2. unfold k, a, apply; simpl. field. lra. }
    intros h. rewrite (surjective_pairing h) at 1. rewrite (Hf h), (Hg h) at 1. apply A. }
  assert (Jb : forall h, e * bt (apply J h) = det J * bt h).
  { intros h. unfold bt, apply, det; simpl. replace (e * (((m21 J * fst h + m22 J * snd h) * fst v - (m11 J * fst h +
      m12 J * snd h) * snd v) / n2)) with (((m21 J * fst h + m22 J * snd h) * (e * fst v) - (m11 J * fst h + m12 J *
      snd h) * (e * snd v)) / n2) by (field; lra). rewrite <- Jv1, <- Jv2. field. lra. }
  set (ae := Rabs e) in *. assert (Jb' : forall h, ae * Rabs (bt (apply J h)) <= Rabs (bt h)).
  { intros h. unfold ae. rewrite <- Rabs_mult, Jb, Rabs_mult. pose proof (Rabs_pos (bt h)). nra. }
  (* the cone and the error *)
  set (th := (ae - 1) / (4 * (Rabs k + 1))). pose proof (Rabs_pos k) as Pk. assert (Hth : 0 < th) by (unfold th;
    apply Rdiv_lt_0_compat; lra). assert (Hth' : Rabs k * th <= (ae - 1) / 4).
  { replace ((ae - 1) / 4) with ((Rabs k + 1) * th) by (unfold th; field; lra). nra. }
  set (k1 := Rmin ((ae - 1) / 4) (th * (1 - / ae))). assert (Hinv : 0 < / ae < 1).
  { split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_lt_contravar; lra. }
  assert (Hk1 : 0 < k1). { unfold k1. apply Rmin_glb_lt; [lra|]. apply Rmult_lt_0_compat; lra.
  } assert (Hk1a : k1 <= (ae - 1) / 4) by apply Rmin_l. assert (Hk1b : k1 <= th * (1 - / ae)) by apply Rmin_r.
  set (Ca := 2 * nv / n2). assert (HCa : 0 < Ca) by (unfold Ca; apply Rdiv_lt_0_compat; lra).
  assert (Hab : forall h, Rabs (a h) <= Ca * norm h /\ Rabs (bt h) <= Ca * norm h).
  { intros h. unfold a, bt, Ca, Rdiv. rewrite !Rabs_mult, (Rabs_pos_eq (/ n2)) by (left; apply Rinv_0_lt_compat;
      lra). pose proof (norm_fst h). pose proof (norm_snd h). pose proof (norm_fst v). pose proof (norm_snd v).
    fold nv in H1, H2. pose proof (Rabs_pos (fst h)). pose proof (Rabs_pos (snd h)).
    pose proof (Rabs_pos (fst v)). pose proof (Rabs_pos (snd v)). assert (P : forall p q, 0 <= p <= norm h -> 0 <= q
      <= nv -> p * q <= nv * norm h) by (intros p q Hp Hq; rewrite (Rmult_comm nv); apply Rmult_le_compat;
      lra). assert (I : 0 < / n2) by (apply Rinv_0_lt_compat; lra). split; replace (2 * nv * / n2 * norm h) with ((nv
      * norm h + nv * norm h) * / n2) by ring; apply Rmult_le_compat_r; try lra.
    - eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult. pose proof (P (Rabs (fst h)) (Rabs (fst v))).
      pose proof (P (Rabs (snd h)) (Rabs (snd v))). lra.
    - unfold Rminus. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp, !Rabs_mult.
      pose proof (P (Rabs (snd h)) (Rabs (fst v))). pose proof (P (Rabs (fst h)) (Rabs (snd v))). lra. }
  set (Cn := (1 + th) * nv). assert (HCn : 0 < Cn) by (unfold Cn; apply Rmult_lt_0_compat; lra).
  assert (Hcn : forall h, Rabs (bt h) <= th * Rabs (a h) -> norm h <= Cn * Rabs (a h)).
  { intros h Hh. pose proof (norm_fst v) as F1. pose proof (norm_snd v) as F2. fold nv in F1, F2.
    pose proof (Rabs_pos (a h)) as Pa. pose proof (Rabs_pos (bt h)) as Pb. pose proof (Rabs_pos (fst v)).
    pose proof (Rabs_pos (snd v)). assert (B : Rabs (a h) * nv + Rabs (bt h) * nv <= Cn * Rabs (a h)) by (unfold Cn;
      nra). apply norm_le. rewrite (Hf h), (Hg h). unfold Rminus. split.
    - eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp, !Rabs_mult. assert (Rabs (a h) * Rabs (fst v) <= Rabs
        (a h) * nv) by (apply Rmult_le_compat_l; lra). assert (Rabs (bt h) * Rabs (snd v) <= Rabs (bt h) * nv) by
        (apply Rmult_le_compat_l; lra). lra.
    - eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult. assert (Rabs (a h) * Rabs (snd v) <= Rabs (a h) *
        nv) by (apply Rmult_le_compat_l; lra). assert (Rabs (bt h) * Rabs (fst v) <= Rabs (bt h) * nv) by (apply
        Rmult_le_compat_l; lra). lra. }
  set (eta := k1 / (Ca * Cn)). assert (HCC : 0 < Ca * Cn) by (apply Rmult_lt_0_compat; lra).
  assert (Heta : 0 < eta) by (unfold eta; apply Rdiv_lt_0_compat; lra). destruct (HG eta Heta) as (d & Hd & Hder).
  set (gr := (ae - 1) / 2).
  (* one step *)
  assert (One : forall z, norm (sub z x) <= d -> Rabs (bt (sub z x)) <= th * Rabs (a (sub z x)) -> Rabs (bt (sub (G z)
    x)) <= th * Rabs (a (sub (G z) x)) /\ (1 + gr) * Rabs (a (sub z x)) <= Rabs (a (sub (G z) x))).
  { intros z Hz Hc. set (h := sub z x) in *. pose proof (Hder z Hz) as Hr. fold h in Hr. rewrite Hx in Hr.
    set (h' := sub (G z) x) in *. set (rho := sub h' (apply J h)) in *. destruct (Hab rho) as [Ra Rb].
    pose proof (Hcn h Hc) as Hn'. pose proof (Rabs_pos (a h)) as Pa. assert (Hrho : Ca * norm rho <= k1 * Rabs (a h)).
    { replace (k1 * Rabs (a h)) with (Ca * (eta * (Cn * Rabs (a h)))) by (unfold eta; field; lra).
      apply Rmult_le_compat_l; [lra|]. eapply Rle_trans; [exact Hr|]. apply Rmult_le_compat_l; lra. }
    assert (Ea : a h' = e * a h + (k * bt h + a rho)).
    { rewrite <- Rplus_assoc, <- Ja. unfold rho, a, sub; simpl. field. lra. }
    assert (Eb : bt h' = bt (apply J h) + bt rho) by (unfold rho, bt, sub; simpl; field; lra).
    assert (Kb : Rabs (k * bt h) <= (ae - 1) / 4 * Rabs (a h)).
    { rewrite Rabs_mult. assert (Rabs k * Rabs (bt h) <= Rabs k * (th * Rabs (a h))) by (apply Rmult_le_compat_l;
        lra). assert (Rabs k * th * Rabs (a h) <= (ae - 1) / 4 * Rabs (a h)) by (apply Rmult_le_compat_r; lra). lra. }
    assert (K1 : k1 * Rabs (a h) <= (ae - 1) / 4 * Rabs (a h)) by (apply Rmult_le_compat_r; lra).
    assert (G1 : (1 + gr) * Rabs (a h) <= Rabs (a h')).
    { assert (ae * Rabs (a h) <= Rabs (a h') + Rabs (k * bt h + a rho)).
      { unfold ae. rewrite <- Rabs_mult. replace (e * a h) with (a h' + - (k * bt h + a rho)) by (rewrite Ea;
          ring). eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
      pose proof (Rabs_triang (k * bt h) (a rho)). unfold gr. lra. }
    split; [|exact G1]. assert (B1 : Rabs (bt (apply J h)) <= / ae * (th * Rabs (a h))).
    { apply (Rmult_le_reg_l ae); [lra|]. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra. eapply Rle_trans;
        [apply Jb'|exact Hc]. }
    assert (B2 : k1 * Rabs (a h) <= th * (1 - / ae) * Rabs (a h)) by (apply Rmult_le_compat_r; lra).
    rewrite Eb. eapply Rle_trans; [apply Rabs_triang|]. assert (Rabs (a h) <= Rabs (a h')).
    { assert (0 <= gr * Rabs (a h)) by (apply Rmult_le_pos; unfold gr; lra). lra. } assert (th * Rabs (a h) <= th *
      Rabs (a h')) by (apply Rmult_le_compat_l; lra). lra. }
  exists d. split; [exact Hd|]. intros eps Heps. set (tau := eps / (2 * nv)). assert (Htau : 0 < tau) by (unfold tau;
    apply Rdiv_lt_0_compat; lra). set (z := add x (scale tau v)). assert (Ez : sub z x = scale tau v) by (unfold z,
    sub, add, scale; simpl; f_equal; ring). assert (Nz : norm (sub z x) < eps).
  { rewrite Ez. apply Rle_lt_trans with (tau * nv).
    - apply norm_le. unfold scale; simpl. rewrite !Rabs_mult, !(Rabs_pos_eq tau) by lra.
      pose proof (norm_fst v) as F1. pose proof (norm_snd v) as F2. fold nv in F1, F2. split;
        apply Rmult_le_compat_l; lra.
    - replace (tau * nv) with (eps / 2) by (unfold tau; field; lra). lra. }
  assert (A0 : a (sub z x) = tau) by (rewrite Ez; unfold a, scale, n2 in *; simpl; field; lra).
  assert (B0 : bt (sub z x) = 0) by (rewrite Ez; unfold bt, scale; simpl; field; lra). assert (All : forall i, (exists
    j, norm (sub (Nat.iter j G z) x) > d) \/ Rabs (bt (sub (Nat.iter i G z) x)) <= th * Rabs (a (sub (Nat.iter i G z)
    x)) /\ (1 + gr) ^ i * tau <= Rabs (a (sub (Nat.iter i G z) x))).
  { intros i. induction i as [|i [IH|[IH1 IH2]]].
    - right. simpl. rewrite A0, B0, Rabs_R0, (Rabs_pos_eq tau) by lra. split; nra.
    - left. exact IH.
    - destruct (Rle_or_lt (norm (sub (Nat.iter i G z) x)) d) as [C|C].
      + right. destruct (One _ C IH1) as [O1 O2]. simpl. split; [exact O1|]. assert ((1 + gr) * ((1 + gr) ^ i * tau)
          <= (1 + gr) * Rabs (a (sub (Nat.iter i G z) x))) by (apply Rmult_le_compat_l; [unfold gr; lra|lra]). lra.
      + left. exists i. exact C. }
  assert (exists i, INR i > Ca * d / (tau * gr)) as (i & Hi).
  { set (t := Ca * d / (tau * gr)). destruct (archimed_cor1 (/ (Rabs t + 1))) as (i & Hi & Hi0).
    { apply Rinv_0_lt_compat. pose proof (Rabs_pos t). lra. }
    exists i. pose proof (Rabs_pos t). pose proof (Rle_abs t). apply lt_0_INR in Hi0.
    apply Rinv_lt_contravar in Hi; [rewrite !Rinv_inv in Hi; lra|]. apply Rmult_lt_0_compat;
      apply Rinv_0_lt_compat; lra. }
  destruct (All i) as [(j & Hj)|[_ Hbig]].
  - exists z, j. split; assumption.
  - exists z, i. split; [exact Nz|]. destruct (Rle_or_lt (norm (sub (Nat.iter i G z) x)) d) as [C|C];
      [exfalso|exact C]. destruct (Hab (sub (Nat.iter i G z) x)) as [Q _]. assert (Ca * norm (sub (Nat.iter i G z) x)
      <= Ca * d) by (apply Rmult_le_compat_l; lra). assert (Hgr : 0 < gr) by (unfold gr; lra).
    pose proof (poly i gr Hgr) as P. assert (T : 0 < tau * gr) by (apply Rmult_lt_0_compat; lra).
    apply Rmult_gt_compat_r with (r := tau * gr) in Hi; [|lra]. replace (Ca * d / (tau * gr) * (tau * gr)) with (Ca *
      d) in Hi by (field; split; lra). assert ((1 + INR i * gr) * tau <= (1 + gr) ^ i * tau) by (apply
      Rmult_le_compat_r; lra). nra.
Qed.
