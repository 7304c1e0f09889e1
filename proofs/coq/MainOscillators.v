(** * The theorems about linear oscillators near grazing, by name *)

From Grazing Require Import StatementOscillator Oscillators OscillatorUses StatementOscillatorOrbits OscillatorOrbits.

Theorem Word_oscillator : Word_oscillator_statement. Proof. exact Oscillators.Word_oscillator. Qed.
Theorem Periodic_oscillator : Periodic_oscillator_statement. Proof. exact OscillatorUses.Periodic_oscillator. Qed.
Theorem Reach : Reach_statement. Proof. exact OscillatorUses.Reach. Qed.
Theorem Single_oscillator : Single_oscillator_statement. Proof. exact OscillatorOrbits.Single_oscillator. Qed.

(** The theorems about signs, about motions. *)
Theorem S1_to_S5_for_oscillators : S1_S3_oscillator_statement /\ Theorem2_oscillator_statement /\
  Conjecture1_oscillator_statement.
Proof. exact (conj S1_S3_oscillator (conj Theorem2_oscillator Conjecture1_oscillator)). Qed.
Theorem Summary_and_record_for_oscillators : Summary_oscillator_statement /\ Record_oscillator_statement.
Proof. exact (conj Summary_oscillator Record_oscillator). Qed.
Theorem Words_for_oscillators : Patterns_oscillator_statement /\ All_patterns_oscillator_statement /\
  Shift_oscillator_statement /\ Graph_oscillator_statement.
Proof.
  exact (conj Patterns_oscillator (conj All_patterns_oscillator (conj Shift_oscillator Graph_oscillator))).
Qed.

Theorem Oscillators_exist : Nordmark_statement /\ Harmonics_statement.
Proof. exact (conj Nordmark_oscillator Harmonics). Qed.
