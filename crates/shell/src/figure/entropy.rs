//! The entropy of the patterns born at a grazing bifurcation without damping, r = 1, over the angle s: steps
//! between Farey fractions.

use num_rational::{BigRational, Ratio};
use num_traits::ToPrimitive;

use super::{
    FigurePlace,
    canvas::{Anchor, COLUMN, Canvas, Colour, GREY, TYPE, WHITE, Words, line},
    colour,
    frame::{Axis, PlotFrame},
};
use crate::{
    error::{Error, Result},
    existence::Case,
    farey::Sequence,
    local::{Ladder, Point, Polar},
    monitor::Monitor,
    word::{ClosedWalks, Relation, Word},
};

/// Bits of the entropies.
const BITS: u32 = 40;
/// The most letters of a word: a path to a fraction of denominator 4N² has fewer.
const LETTERS: usize = 2000;

/// An interval of s on which the periods up to N have one word.
struct Step {
    left: Ratio<u64>,
    right: Ratio<u64>,
    case: Case,
    periods: Vec<u64>,
    letters: String,
    /// Of the patterns over these periods; `None` if none exists.
    entropy: Option<f64>,
    /// Whether longer periods occur, too: then the entropy over all periods is at least this one.
    cut: bool,
}

impl Step {
    /// Whether the periods up to the last say nothing: what there is, if anything, has longer ones.
    fn is_open(&self) -> bool {
        self.cut && self.entropy.is_none_or(|rate| rate == 0.0)
    }
}

/// Writes the picture and its data: for r = 1 and the three cases in which patterns are
/// born, the entropy of the patterns over periods up to `last`, rounded down. It is a lower bound of that
/// over all periods.
///
/// # Errors
/// An input error unless 3 ≤ `last` ≤ 100; an I/O error; the monitor's interruption.
pub fn entropy(last: u64, place: &FigurePlace, monitor: &dyn Monitor) -> Result<()> {
    if !(3..=100).contains(&last) {
        return Err(Error::input(format!(
            "N = {last}: this figure shows periods up to N, with N from 3 to 100"
        )));
    }
    let steps = steps(last, monitor)?;
    let rows: Vec<Vec<String>> = steps
        .iter()
        .map(|step| {
            let periods: Vec<String> = step.periods.iter().map(u64::to_string).collect();
            vec![
                step.case.sign_emu().to_string(),
                step.case.sign_gamma().to_string(),
                format!("{}/{}", step.left.numer(), step.left.denom()),
                format!("{}/{}", step.right.numer(), step.right.denom()),
                step.letters.clone(),
                periods.join(" "),
                step.entropy.map_or(String::new(), |rate| format!("{rate:.10}")),
                if step.cut { "yes" } else { "no" }.to_string(),
            ]
        })
        .collect();
    let columns = ["sign_emu", "sign_gamma", "left", "right", "word", "periods", "entropy", "cut"];
    place.save(&draw(last, &steps), &columns, &rows)
}

/// The steps between neighbours of F_N and the multiples 1/(2k), where the first U changes.
fn steps(last: u64, monitor: &dyn Monitor) -> Result<Vec<Step>> {
    let half = Ratio::new(1, 2);
    let mut ends: Vec<Ratio<u64>> = Sequence::new(last, &Ratio::new(0, 1), &half)?.collect();
    ends.extend((1..=last).map(|k| Ratio::new(1, 2 * k)));
    ends.sort();
    ends.dedup();
    let ladder = Ladder::default();
    let mut steps = Vec::new();
    for pair in ends.windows(2) {
        monitor.advance(1)?;
        let (left, right) = (pair[0], pair[1]);
        // Any s between them does; u_n = 0 at its own denominator only, beyond N.
        let between = |[a, b]: [u64; 2]| {
            let s = BigRational::new(
                (a * left.numer() + b * right.numer()).into(),
                (a * left.denom() + b * right.denom()).into(),
            );
            Ok::<_, Error>(Point::Polar(Polar::new(BigRational::from_integer(1.into()), s)?))
        };
        for case in [Case::PlusPlus, Case::PlusMinus, Case::MinusPlus] {
            let word_at = |weights| Word::at(&ladder, &between(weights)?, case.sign_emu() > 0, LETTERS, &());
            let word = word_at([1, 1])?;
            // The word of the mediant ends there; those on both sides go on, if longer periods occur.
            let mut cut = false;
            for weights in [[2, 1], [1, 2]] {
                cut |= word_at(weights)?.vertices().iter().any(|vertex| vertex.period > last);
            }
            let relation = Relation::new(&word, case.sign_gamma() > 0, false, last)?;
            let bounds = ClosedWalks::new(&relation).entropy(BITS).bounds();
            let shown = word.up_to(last);
            steps.push(Step {
                left,
                right,
                case,
                periods: shown.iter().map(|vertex| vertex.period).collect(),
                letters: word.letters().chars().take(shown.len()).collect(),
                entropy: bounds.and_then(|(low, _)| low.to_f64()),
                cut,
            });
        }
    }
    Ok(steps)
}

/// Fractions that are marked on every panel.
const MARKED: [(u64, u64); 6] = [(1, 6), (1, 5), (1, 4), (1, 3), (2, 5), (1, 2)];
/// The height of a panel.
const PANEL: f64 = 116.0;

/// Where the periods shown decide nothing.
const OPEN: Colour = Colour(222, 222, 222);

/// Both ends of a step.
fn ends(step: &Step) -> [f64; 2] {
    [step.left, step.right].map(|x| *x.numer() as f64 / *x.denom() as f64)
}

fn draw(last: u64, steps: &[Step]) -> Canvas {
    let mut canvas = Canvas::new(
        COLUMN,
        26.0 + 3.0 * PANEL,
        &format!("Entropy of the patterns born without damping, periods up to {last}"),
        "Three panels, one per case: the entropy per forcing period at r = 1 over s, a step function between \
         fractions. It is 0 where no chaos is born. Grey: only longer periods could make chaos there.",
    );
    let title = format!("entropy per period at r = 1; periods ≤ {last}; grey: cut there");
    canvas.text(title, (COLUMN / 2.0, 7.0), Anchor::Middle);
    let cases = [Case::PlusPlus, Case::PlusMinus, Case::MinusPlus];
    for (case, top) in cases.into_iter().zip((0..).map(|i| 22.0 + PANEL * f64::from(i))) {
        // Above every step there is room for the title.
        let high = match case {
            Case::PlusPlus => 0.55,
            Case::PlusMinus => 0.75,
            _ => 0.8,
        };
        let name = if case == Case::MinusPlus { "s" } else { "" };
        let bottom = if case == Case::MinusPlus { top + PANEL + 4.0 } else { top + PANEL - 4.0 };
        let frame = PlotFrame::new(
            [2.0, top, COLUMN - 2.0, bottom],
            Axis::linear(name, (0.0, 0.5), 5),
            Axis::linear("", (0.0, high), 4),
        )
        .with_left(22.0);
        for step in steps.iter().filter(|step| step.case == case && step.is_open()) {
            let [left, right] = ends(step);
            let corners = [(left, 0.0), (left, high), (right, high), (right, 0.0)];
            canvas.inside(frame.inside(), |canvas| canvas.polygon(frame.path(corners), OPEN));
        }
        // One outline of all steps, so that nothing shines through between them.
        let mut outline = vec![(0.0, 0.0)];
        for step in steps.iter().filter(|step| step.case == case) {
            let height = step.entropy.unwrap_or(0.0);
            outline.extend(ends(step).map(|s| (s, height)));
        }
        outline.push((0.5, 0.0));
        outline.dedup();
        canvas.inside(frame.inside(), |canvas| canvas.polygon(frame.path(outline), colour(case)));
        for (p, q) in MARKED {
            let s = p as f64 / q as f64;
            canvas.line(frame.path([(s, 0.0), (s, high)]), line(GREY, 0.4));
            if case == cases[0] {
                let (x, y) = frame.at((s, high));
                canvas.sized(format!("{p}/{q}"), (x, y - 5.0), Anchor::Middle, 7.0);
            }
        }
        frame.draw(&mut canvas);
        let name = Words::from(super::title(case));
        let (x, y) = frame.at((0.004, high * 0.93));
        canvas.rectangle([x, y - 5.0, x + name.width(TYPE) + 4.0, y + 5.0], WHITE);
        canvas.text(name, (x + 2.0, y), Anchor::Start);
    }
    canvas
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps cover (0, ½) for each case; a full shift has its known entropy.
    #[test]
    fn steps_cover_the_line() {
        let steps = steps(6, &()).unwrap();
        for case in [Case::PlusPlus, Case::PlusMinus, Case::MinusPlus] {
            let of: Vec<&Step> = steps.iter().filter(|step| step.case == case).collect();
            assert_eq!((of[0].left, of[of.len() - 1].right), (Ratio::new(0, 1), Ratio::new(1, 2)));
            assert!(of.windows(2).all(|pair| pair[0].right == pair[1].left));
        }
        // 1/6 < s < 1/4: the periods with 2ns < 1 are 1 and 2, freely combined: z + z² = 1.
        let golden = ((1.0 + 5f64.sqrt()) / 2.0).ln();
        let inside = |step: &&Step| {
            step.case == Case::MinusPlus && step.left >= Ratio::new(1, 6) && step.right <= Ratio::new(1, 4)
        };
        assert!(steps.iter().filter(inside).all(|step| (step.entropy.unwrap() - golden).abs() < 1e-9));
        assert!(steps.iter().any(|step| inside(&step)));
        // With periods up to 6 only, those that go on with longer ones have no entropy at both ends in case
        // (+,+); where 2s > 1/2 no period but 1 occurs for eµ < 0: there it is 0 and nothing is cut.
        let open = |case| steps.iter().filter(move |step| step.case == case && step.is_open());
        let half = Ratio::new(1, 2);
        assert!(open(Case::PlusPlus).any(|step| step.left == Ratio::new(0, 1)));
        assert!(open(Case::PlusPlus).any(|step| step.right == half));
        assert_eq!(open(Case::MinusPlus).count(), 0);
    }
}
