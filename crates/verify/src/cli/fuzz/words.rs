//! How the fuzzing of the word theorem is told.

use serde_json::{Value, json};

use super::Told;
use crate::{
    error::Result,
    search::fuzz::{
        Campaign, Tally,
        words::{SUPREMA, WordOptions, WordTally, replayed},
    },
};

impl Told for WordOptions {
    const UNIT: &'static str = "points";
    const REFUTED: &'static str = "the definition and the word differ";

    fn arguments(&self) -> String {
        let WordOptions { last, seed, definition_share, .. } = self;
        format!("--words --n 1..={last} --seed {seed} --definition-share {definition_share}")
    }

    fn more(&self) -> Vec<(&'static str, Value)> {
        vec![("of", "words".into()), ("presumed_suprema", json!(SUPREMA))]
    }

    fn rates(&self, tally: &WordTally) -> Option<String> {
        let sweeps = (tally.units * self.block()) as f64 / tally.sweep_seconds;
        (tally.sweep_seconds > 0.0).then(|| format!("{sweeps:.3e} in sweeps"))
    }

    fn rows(&self, tally: &WordTally) -> Vec<(u64, &'static str)> {
        vec![
            (tally.decided(), "points decided both ways, every period up to the last, of which"),
            (tally.swept, "by f64 with proved bounds, in sweeps"),
            (tally.closer, "by pairs of floats with proved bounds, where f64 left them open"),
            (tally.exact, "exactly, or by intervals and balls"),
            (tally.boundary, "on a boundary, where something is zero and the rest agrees"),
            (tally.undecided, "undecided, and not counted above"),
            (tally.weighted, "drawn near the places where something could fail"),
            (tally.repeated, "of sweeps decided again exactly"),
            (tally.pairs, "pairs of periods compared there"),
            (tally.words, "random words on r = 1 whose entropies were computed"),
        ]
    }

    fn remarks(&self, tally: &WordTally) -> Vec<String> {
        let largest = ["(+,+)", "(+,-)"].into_iter().enumerate().filter(|(i, _)| tally.largest[*i] > 0.0);
        let largest = largest.map(|(i, case)| {
            format!(
                "largest entropy in {case}: {:.9} ({}); thought to be below {:.9}, which is not proved",
                tally.largest[i], tally.largest_at[i], SUPREMA[i]
            )
        });
        let beyond = tally.beyond.iter().map(|line| format!("the supremum is larger than is proved: {line}"));
        largest.chain(beyond).collect()
    }

    fn shown_by(&self, line: &str) -> Result<String> {
        let case = replayed(line)?;
        let point = case.arguments().replace(&format!(" --max-period {}", case.n), "");
        Ok(format!("grazing word {point}, against grazing classify {}", case.arguments()))
    }
}
