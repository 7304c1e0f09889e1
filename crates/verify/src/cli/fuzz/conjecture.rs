//! How the fuzzing of Conjecture 1 is told.

use super::Told;
use crate::{
    error::Result,
    search::{
        Instance,
        fuzz::{FuzzOptions, FuzzTally, Tally},
    },
};

impl Told for FuzzOptions {
    const UNIT: &'static str = "cases";
    const REFUTED: &'static str = "the definition and the claim disagree";

    fn arguments(&self) -> String {
        let FuzzOptions { first, last, seed, definition_share, .. } = self;
        format!("--n {first}..={last} --seed {seed} --definition-share {definition_share}")
    }

    fn rates(&self, tally: &FuzzTally) -> Option<String> {
        let cases = [tally.decided().saturating_sub(tally.weighted), tally.weighted];
        let seconds = [tally.sweep_seconds, tally.weighted_seconds];
        let [sweeps, weighted] = [0, 1].map(|i| cases[i] as f64 / seconds[i]);
        let told = seconds.iter().all(|&seconds| seconds > 0.0);
        told.then(|| format!("{sweeps:.3e} in sweeps, {weighted:.3e} weighted"))
    }

    fn rows(&self, tally: &FuzzTally) -> Vec<(u64, &'static str)> {
        vec![
            (tally.decided(), "cases (n, point) decided both ways, of which"),
            (tally.swept, "by f64 with proved bounds, in sweeps over all n"),
            (tally.interval, "by f64 intervals"),
            (tally.ball, "by multi-precision balls"),
            (tally.exact, "by integers alone"),
            (tally.boundary, "on a boundary, where nothing is claimed"),
            (tally.undecided, "undecided, and not counted above"),
            (tally.weighted, "weighted cases, near the places where something could fail"),
            (tally.repeated, "sweep results decided again by the definition, k by k"),
        ]
    }

    fn shown_by(&self, line: &str) -> Result<String> {
        let case: Instance = line.parse()?;
        Ok(format!("grazing classify {}", case.arguments()))
    }
}
