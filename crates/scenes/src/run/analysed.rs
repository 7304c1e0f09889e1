//! What is known of a periodic orbit, in a report's units and words, whichever engine found it.

use super::{Complex, Judgement, row};

row! {
    /// What is known of a periodic orbit.
    pub struct Analysed {
        /// The impact pattern.
        pub pattern: String,
        /// The phases of its impacts, as its pattern counts them, the first within one period: impact i + 1
        /// is n_i periods and t_{i+1} − t_i after impact i. As fractions of the period.
        pub phases: Vec<f64>,
        /// Their incoming relative speeds, in the scene's units.
        pub speeds: Vec<f64>,
        /// The multipliers of largest modulus, at most four, the largest first; without the 1 of each drift.
        pub multipliers: Vec<Complex>,
        /// Whether all are inside the unit circle.
        pub stable: Judgement,
        /// Whether it is an orbit: its impacts come in, and there is no other contact.
        pub admissible: Judgement,
        /// Why not.
        pub reason: Option<String>,
        /// How far each coordinate comes per forcing period, along directions in which nothing holds the
        /// machine: up to that the motion is periodic. Empty where all is held.
        pub drift: Vec<f64>,
        /// The stop with the least minimum of its gap away from the impacts.
        pub nearest_stop: Option<String>,
        /// That minimum, in the scene's units.
        pub least_gap: Option<f64>,
        /// What is left of the equations; of a machine, relative to the size of the motion.
        pub residual: f64,
        /// Newton steps taken.
        pub newton_steps: usize,
    }
}
