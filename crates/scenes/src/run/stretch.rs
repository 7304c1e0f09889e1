//! What a proof of an orbit over a range of a parameter says, for the rows of tasks `validate` and `branch`.

use super::{Judgement, StabilityRow, validate::judged};
use crate::{certificate::orbit::Claim, search::orbit::ProvedBranch};

/// What a proof over a range says.
pub(super) struct Stretch {
    /// The least and the greatest value of the parameter.
    pub lower: String,
    pub upper: String,
    /// Whether the orbit is stable; none if that differs.
    pub stable: Option<Judgement>,
    pub stability: Vec<StabilityRow>,
    /// Why it goes no further, if it does not.
    pub ends: Option<String>,
}

impl Stretch {
    /// Of a proof.
    pub fn of(proof: &ProvedBranch) -> Stretch {
        let parts = proof.parts();
        let end = |part: Option<&(Claim, [String; 2])>, end: usize| {
            part.map_or_else(String::new, |(_, ends)| ends[end].clone())
        };
        let stable = match parts[..] {
            [(claim, _)] => Some(judged(claim)),
            _ => None,
        };
        let (lower, upper) = (end(parts.first(), 0), end(parts.last(), 1));
        let said = |(claim, [from, to]): (Claim, [String; 2])| {
            let word = match claim {
                Claim::Stable => "stable",
                Claim::Unstable => "unstable",
                Claim::Open => return None,
            };
            Some(StabilityRow { word, from: Some(from), to })
        };
        let stability = parts.into_iter().filter_map(said).collect();
        let ways = ["down", "up"].iter().zip(&proof.ends);
        let short: Vec<String> =
            ways.filter_map(|(way, end)| Some(format!("{way}: {}", end.as_ref()?))).collect();
        let ends = (!short.is_empty()).then(|| short.join("; "));
        Stretch { lower, upper, stable, stability, ends }
    }
}
