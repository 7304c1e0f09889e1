//! Whether chaos is born at a grazing bifurcation, and how much of it: the word theorem at the local map as
//! computed.

use super::{Lines, row};
use crate::{
    error::Result,
    monitor::Monitor,
    number::certain_digits,
    word::{Entropy, Extent, Rectangle, Word},
};

/// The most letters of a word that are followed.
const LETTERS: usize = 100;
/// Bits of an entropy.
const BITS: u32 = 64;

row! {
    /// What is born on one side of a grazing bifurcation: all impact patterns together.
    pub struct ChaosRow {
        /// The side of the parameter.
        pub side: String,
        /// The sign of eµ there.
        pub sign_emu: i32,
        /// The sign of γ.
        pub sign_gamma: i32,
        /// Whether infinitely many patterns are born with positive entropy; absent if that is not decided.
        pub chaos: Option<bool>,
        /// The topological entropy per period of the orbit that grazes (per half period where those are
        /// counted): certain digits; absent if no pattern is born, or none is certain.
        pub entropy: Option<String>,
        /// Whether the entropy is only a lower bound: the word may go on.
        pub at_least: bool,
        /// The periods, or half periods, that can occur between impacts, as far as they are certain.
        pub periods: Vec<u64>,
        /// Whether every period can occur.
        pub all_periods: bool,
    }
}

impl ChaosRow {
    /// The rows in words; `half` if periods are counted in halves.
    pub(super) fn sentences(rows: &[ChaosRow], half: bool, lines: &Lines) -> String {
        let per = if half { "half period" } else { "period" };
        rows.iter().map(|row| row.sentence(&lines.side(&row.side), per)).collect::<Vec<_>>().join("; ")
    }

    fn sentence(&self, side: &str, per: &str) -> String {
        let at_least = if self.at_least { "at least " } else { "" };
        match (self.chaos, &self.entropy) {
            (Some(true), Some(entropy)) => {
                format!(
                    "born for {side}, entropy {at_least}{entropy} per {per}; signs of e mu, gamma: {}",
                    self.case()
                )
            }
            (Some(_), Some(_)) => format!("none for {side}: the patterns born there do not branch"),
            (Some(_), None) => format!("none for {side}: no pattern is born"),
            (None, _) => format!("not decided for {side}"),
        }
    }

    fn case(&self) -> String {
        let sign = |sign: i32| if sign > 0 { '+' } else { '-' };
        format!("({},{})", sign(self.sign_emu), sign(self.sign_gamma))
    }
}

/// Both sides of a bifurcation with these a₁, a₂, γ and e, eµ > 0 first; `None` for a₂ ≤ 0, γ = 0 or e = 0,
/// where no word decides.
///
/// a₁ and a₂ are widened by 10⁻¹² of the larger of |a₁| and 1, as the map is for the table of patterns; what
/// is not the same on all of that box is not decided. For a₂ > 1 time is reversed, which changes no entropy.
///
/// # Errors
/// The monitor's interruption.
pub(super) fn all_patterns(
    [trace, determinant, gamma, e]: [f64; 4],
    side: impl Fn(bool) -> String,
    monitor: &dyn Monitor,
) -> Result<Option<Vec<ChaosRow>>> {
    if determinant.is_nan() || determinant <= 0.0 || gamma == 0.0 || e == 0.0 {
        return Ok(None);
    }
    let Some(rectangle) = Rectangle::about(trace, determinant) else { return Ok(None) };
    let gamma = gamma > 0.0;
    let rows = [true, false].into_iter().map(|positive| {
        let word = Word::in_rectangle(&rectangle, positive, LETTERS, monitor)?;
        let (entropy, at_least) = Entropy::of(&word, gamma, BITS)?;
        let chaos = match entropy {
            Entropy::Positive { .. } => Some(true),
            _ if at_least => None,
            _ => Some(false),
        };
        Ok(ChaosRow {
            side: side(positive),
            sign_emu: if positive { 1 } else { -1 },
            sign_gamma: if gamma { 1 } else { -1 },
            chaos,
            entropy: entropy
                .bounds()
                .map(|(lo, hi)| certain_digits(&lo, &hi, 15).unwrap_or_else(|| "0".into())),
            at_least,
            periods: word.vertices().iter().map(|vertex| vertex.period).collect(),
            all_periods: word.extent() == Extent::All,
        })
    });
    rows.collect::<Result<Vec<_>>>().map(Some)
}
