(** * The theorems about oscillators near grazing, by name *)

From Grazing Require Import StatementOscillator StatementNordmark OscillatorUses Nordmark.
From Grazing Require Import StatementStops StatementNonlinearExamples NonlinearStops NonlinearExamples.
From Grazing Require Import StatementBouncingExample NonlinearBouncingExample.
From Grazing Require Import StatementOneImpact OneImpact.
From Grazing Require StatementRattling NonlinearRattling NonlinearDuffing.
From Grazing Require StatementResonance ResonanceExact ResonanceStable ResonanceBirth ResonanceMaps ResonanceFold.
From Grazing Require StatementMultipliers ResonanceMultipliers StatementFold ResonanceFamily.

Theorem Periodic_oscillator : Periodic_oscillator_statement. Proof. exact OscillatorUses.Periodic_oscillator. Qed.
Theorem Reach : Reach_statement. Proof. exact OscillatorUses.Reach. Qed.
Theorem Oscillators_exist : Nordmark_statement /\ Harmonics_statement.
Proof. exact (conj Nordmark_oscillator Harmonics). Qed.
Theorem Two_stops : Stops_statement. Proof. exact NonlinearStops.Two_stops. Qed.
Theorem Driven : Driven_statement. Proof. exact NonlinearExamples.Driven. Qed.
Theorem Duffing : Duffing_statement. Proof. exact NonlinearDuffing.Duffing. Qed.
Theorem Bouncing_example : Bouncing_example_statement. Proof. exact NonlinearBouncingExample.Bouncing_example. Qed.
Theorem One_impact : Gap_statement /\ Every_mu_statement. Proof. exact (conj OneImpact.Gap OneImpact.Every_mu). Qed.
Theorem Rattling : StatementRattling.Rattling_statement. Proof. exact NonlinearRattling.Rattling. Qed.

(** At resonance. *)
Theorem At_resonance : StatementResonance.Exact_statement /\ StatementResonance.Multipliers_statement /\
  StatementResonance.Stable_statement /\ StatementResonance.Birth_statement.
Proof. exact (conj ResonanceExact.Exact (conj ResonanceStable.Multipliers (conj ResonanceStable.Stable
  ResonanceBirth.Birth))). Qed.
Theorem Maps_at_resonance : StatementResonance.Curve_statement /\ StatementResonance.Side_statement /\
  StatementResonance.Plane_statement.
Proof. exact (conj ResonanceMaps.Curve (conj ResonanceFold.Side ResonanceMaps.Plane)). Qed.
Theorem Multipliers_of_maps : StatementMultipliers.Determinant_statement.
Proof. exact ResonanceMultipliers.Determinant. Qed.
Theorem Fold_of_maps : StatementFold.Fold_statement. Proof. exact ResonanceFamily.Fold. Qed.
