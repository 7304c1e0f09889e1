//! Which impact patterns a grazing bifurcation gives birth to, over the (a₁, a₂) plane: each cell one word,
//! its colour the entropy.
//!
//! The cells for eµ > 0 are the areas of Conjecture 1 less those inside them: drawn from the lowest period
//! up, each over the ones that it lies in, so that every edge is the edge of an area. For eµ < 0 they are
//! sectors of s.

use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::{
    FigurePlace,
    canvas::{Anchor, BLACK, COLUMN, Canvas, Colour, GREY, Paint, WHITE, line},
    frame::{Axis, PlotFrame},
    iterate::{Curve, plane},
    title,
};
use crate::{
    error::{Error, Result},
    existence::{Boundary, Case, intervals},
    monitor::Monitor,
    word::{Entropy, Letter, Word},
};

/// Points of a curve s = const, and of an edge without a lower bound.
const STEPS: u32 = 60;
/// Points of the edge of an area within one strip of s.
const STRIP_STEPS: u64 = 24;
/// Bits of the entropies.
const BITS: u32 = 40;
/// Decimals of an edge.
const DECIMALS: u32 = 8;

/// A part of the plane with one word.
pub(super) struct Cell {
    pub case: Case,
    pub letters: String,
    pub periods: Vec<u64>,
    /// `None`: no pattern exists.
    pub entropy: Option<f64>,
    outline: Vec<Corner>,
}

/// A corner of a cell.
#[derive(Debug, Clone, Copy)]
struct Corner {
    /// (a₁, a₂).
    plane: (f64, f64),
    /// (s, r): r² = a₂, a₁ = 2r cos 2πs; beyond the parabola s is that of its nearer half.
    polar: (f64, f64),
}

impl Corner {
    fn polar(s: f64, r: f64) -> Corner {
        Corner { plane: (2.0 * r * (std::f64::consts::TAU * s).cos(), r * r), polar: (s, r) }
    }

    /// Of a₂ > 0.
    fn plane((a1, a2): (f64, f64)) -> Corner {
        let r = a2.sqrt();
        let s = (a1 / (2.0 * r)).clamp(-1.0, 1.0).acos() / std::f64::consts::TAU;
        Corner { plane: (a1, a2), polar: (s, r) }
    }
}

impl Cell {
    /// Its outline in the (s, r) plane: what is beyond the parabola lies on its edges.
    pub fn polar(&self) -> impl Iterator<Item = (f64, f64)> {
        self.outline.iter().map(|corner| corner.polar)
    }
}

/// Writes the picture and its data: the words of at most the areas of period ≤ `last`, for
/// the three cases in which patterns are born for |a₁| < 1 + a₂. Later periods are left out, so that colours
/// are lower bounds near a₂ = 1.
///
/// # Errors
/// An input error unless 3 ≤ `last` ≤ 30; an I/O error; the monitor's interruption.
pub fn words(last: u64, place: &FigurePlace, monitor: &dyn Monitor) -> Result<()> {
    let cells = cells(last, monitor)?;
    let rows: Vec<Vec<String>> = cells
        .iter()
        .map(|cell| {
            let periods: Vec<String> = cell.periods.iter().map(u64::to_string).collect();
            vec![
                cell.case.sign_emu().to_string(),
                cell.case.sign_gamma().to_string(),
                cell.letters.clone(),
                periods.join(" "),
                cell.entropy.map_or(String::new(), |rate| format!("{rate:.10}")),
            ]
        })
        .collect();
    let columns = ["sign_emu", "sign_gamma", "word", "periods", "entropy"];
    place.save(&draw(last, &cells), &columns, &rows)
}

/// The cells, each over those that it lies in.
///
/// # Errors
/// An input error unless 3 ≤ `last` ≤ 30; the monitor's interruption.
pub(super) fn cells(last: u64, monitor: &dyn Monitor) -> Result<Vec<Cell>> {
    if !(3..=30).contains(&last) {
        return Err(Error::input(format!(
            "N = {last}: this figure shows periods up to N, with N from 3 to 30"
        )));
    }
    let mut cells = Vec::new();
    sectors(last, &mut cells);
    for gamma in [true, false] {
        plain(gamma, last, &mut cells)?;
    }
    for n in 3..=last {
        monitor.advance(1)?;
        areas(n, &mut cells)?;
    }
    Ok(cells)
}

/// The entropy of a word's case, in f64 for the picture; `None` if no pattern exists.
fn rate(word: &Word, gamma: bool) -> Result<Option<f64>> {
    let (entropy, _) = Entropy::of(word, gamma, BITS)?;
    Ok(entropy.bounds().and_then(|(low, _)| low.to_f64()))
}

fn cell(word: &Word, case: Case, outline: Vec<Corner>) -> Result<Cell> {
    Ok(Cell {
        case,
        letters: word.letters(),
        periods: word.vertices().iter().map(|vertex| vertex.period).collect(),
        entropy: rate(word, case.sign_gamma() > 0)?,
        outline,
    })
}

/// The word of an area; that there is one is known.
fn of_area(n: u64, m: u64, letter: Letter, first: u64) -> Result<Word> {
    Word::of_area(n, m, letter, first)
        .ok_or_else(|| Error::input(format!("no word belongs to the area of {m}/{n} with K = {first}")))
}

/// a₁ = 2r cos 2πs, a₂ = r² for r from 0 to 1.
fn ray(s: f64) -> Vec<Corner> {
    (0..=STEPS).map(|i| Corner::polar(s, f64::from(i) / f64::from(STEPS))).collect()
}

fn between(first: Vec<Corner>, second: Vec<Corner>) -> Vec<Corner> {
    first.into_iter().chain(second.into_iter().rev()).collect()
}

/// |a₁| = 1 + a₂.
fn lower_edge(sign: f64) -> Vec<Corner> {
    let s = if sign > 0.0 { 0.0 } else { 0.5 };
    vec![Corner { plane: (sign, 0.0), polar: (s, 0.0) }, Corner { plane: (sign * 2.0, 1.0), polar: (s, 1.0) }]
}

/// eµ < 0, γ > 0: region 2, and the sectors 1/(2(n + 1)) ≤ s < 1/(2n) of the words 1, …, n.
fn sectors(last: u64, cells: &mut Vec<Cell>) {
    let full = |n: u64, outline| {
        let periods: Vec<u64> = (1..=n).collect();
        let all = vec![vec![true; periods.len()]; periods.len()];
        let entropy = crate::word::ClosedWalks::from_edges(&periods, &all).entropy(BITS);
        let entropy = entropy.bounds().and_then(|(lo, _)| lo.to_f64());
        Cell { case: Case::MinusPlus, letters: "D".repeat(periods.len()), periods, entropy, outline }
    };
    // Each over the ones to its right, so that nothing shines through between them; beyond the last, and in
    // region 2, all periods: log 2.
    let from = |s: f64| between(lower_edge(-1.0), ray(s));
    let mut rest = full(last, between(lower_edge(-1.0), lower_edge(1.0)));
    (rest.letters, rest.periods, rest.entropy) = ("D...".into(), Vec::new(), Some(std::f64::consts::LN_2));
    cells.push(rest);
    let mut narrow = full(last, from(0.0));
    narrow.letters += "...";
    cells.push(narrow);
    cells.extend((1..=last).rev().map(|n| full(n, from(1.0 / (2 * n + 2) as f64))));
}

/// eµ > 0: what lies under all areas. Period 1 alone in region 2; 1 and K elsewhere, K > `last` next to it.
fn plain(gamma: bool, last: u64, cells: &mut Vec<Cell>) -> Result<()> {
    let case = if gamma { Case::PlusPlus } else { Case::PlusMinus };
    let whole = between(lower_edge(-1.0), lower_edge(1.0));
    cells.push(Cell {
        case,
        letters: "D".into(),
        periods: vec![1],
        entropy: (!gamma).then_some(0.0),
        outline: whole,
    });
    let narrow = between(ray(0.0), ray(1.0 / (2 * last) as f64));
    cells.push(Cell { case, letters: "DU...".into(), periods: vec![1], entropy: Some(0.0), outline: narrow });
    let word = of_area(2, 1, Letter::U, 2)?;
    cells.push(cell(&word, case, between(lower_edge(-1.0), ray(0.25)))?);
    Ok(())
}

/// eµ > 0: the areas of period n.
fn areas(n: u64, cells: &mut Vec<Cell>) -> Result<()> {
    for interval in intervals(n)?.filter(|interval| interval.deciding.is_some()) {
        let (m, k) = (interval.m, interval.deciding.unwrap_or_default());
        let letter = if interval.case == Case::PlusPlus { Letter::U } else { Letter::D };
        let mut add = |first, outline: Vec<Corner>| -> Result<()> {
            let word = of_area(n, m, letter, first)?;
            for case in [Case::PlusPlus, Case::PlusMinus] {
                cells.push(cell(&word, case, outline.clone())?);
            }
            Ok(())
        };
        if m == 1 && letter == Letter::U {
            // 1/(2n) < s < 1/n: K is anything from ⌊n/2⌋ + 1 to n.
            let boundary = Boundary::new(interval);
            (n / 2 + 1..=n).try_for_each(|first| add(first, strip(n, first, &boundary)?))?;
            continue;
        }
        let curve = Curve::new(interval)?;
        let mut edge: Vec<Corner> = curve.points.iter().map(|point| Corner::plane(plane(point))).collect();
        // The leftmost area is bounded by the line.
        if k == n - 2 && letter == Letter::D {
            edge.extend(lower_edge(-1.0));
        }
        // s ≈ m/n and 1/(2s) is no integer on the area.
        add(n.div_ceil(2 * m).max(2), edge)?;
    }
    Ok(())
}

/// The part of the area of 1/n on its upper side where K = `first`: 1/(2K) < s < 1/(2(K − 1)), s < 1/n.
fn strip(n: u64, first: u64, boundary: &Boundary) -> Result<Vec<Corner>> {
    let ratio = |p: u64, q: u64| BigRational::new(p.into(), q.into());
    let low = ratio(1, 2 * first);
    let high = ratio(1, 2 * first - 2).min(ratio(1, n));
    let float = |x: &BigRational| x.to_f64().unwrap_or(f64::NAN);
    if first == n {
        // R = 0 up to 1/(2(n − 1)).
        return Ok(between(ray(float(&low)), ray(float(&high))));
    }
    let mut lower = Vec::new();
    for i in 0..=STRIP_STEPS {
        let s = &low + (&high - &low) * ratio(i, STRIP_STEPS);
        // The edge begins in 0 at 1/(2(n − 1)) and ends in 1 at 1/n.
        let r = if s == ratio(1, 2 * (n - 1)) {
            BigRational::zero()
        } else if s == ratio(1, n) {
            BigRational::one()
        } else {
            let edge = boundary.at(&s, DECIMALS)?;
            edge.ok_or_else(|| {
                Error::input(format!("the edge of the area of 1/{n} at s = {s} was not certified"))
            })?
            .middle()
        };
        lower.push((float(&s), float(&r)));
    }
    let (begin, end) = (lower[0], lower[lower.len() - 1]);
    let up = |(s, r0): (f64, f64)| {
        let r = |i| r0 + (1.0 - r0) * f64::from(i) / f64::from(STEPS);
        (0..=STEPS).map(|i| Corner::polar(s, r(i))).collect::<Vec<_>>()
    };
    let mut outline: Vec<Corner> = lower.iter().map(|&(s, r)| Corner::polar(s, r)).collect();
    outline.extend(up(end));
    outline.extend(up(begin).into_iter().rev());
    Ok(outline)
}

/// From white (nothing) over grey (patterns, but no chaos) to a dark blue at log 2.
pub(super) fn shade(entropy: Option<f64>) -> Colour {
    let Some(rate) = entropy else { return WHITE };
    if rate <= 0.0 {
        return Colour(226, 226, 226);
    }
    // Yellow, green, blue: apart in lightness as well as in hue.
    let stops = [(253.0, 231.0, 120.0), (120.0, 198.0, 121.0), (44.0, 127.0, 184.0), (37.0, 32.0, 110.0)];
    let t = (rate / std::f64::consts::LN_2).clamp(0.0, 1.0) * 3.0;
    let i = (t as usize).min(2);
    let mix = |a: f64, b: f64| (a + (b - a) * (t - i as f64)).round() as u8;
    let (a, b) = (stops[i], stops[i + 1]);
    Colour(mix(a.0, b.0), mix(a.1, b.1), mix(a.2, b.2))
}

/// The height of a panel.
const PANEL: f64 = 139.0;
/// Of which so much is its title's.
const TITLE: f64 = 11.0;

fn panel(canvas: &mut Canvas, top: f64, cells: &[Cell], case: Case, lowest: bool) {
    let bottom = if lowest { top + PANEL + 8.0 } else { top + PANEL - 4.0 };
    let frame = PlotFrame::new(
        [2.0, top + TITLE, COLUMN - 4.0, bottom],
        Axis::linear(if lowest { "a₁" } else { "" }, (-2.0, 2.0), 4),
        Axis::linear("a₂", (0.0, 1.0), 5),
    );
    canvas.inside(frame.inside(), |canvas| {
        for cell in cells.iter().filter(|cell| cell.case == case) {
            // With a thin outline of its own colour: neighbours need not share vertices where they share a
            // side.
            let ink = shade(cell.entropy);
            let paint = Paint { fill: Some(ink), stroke: Some(line(ink, 0.12)) };
            canvas.polygon(frame.path(cell.outline.iter().map(|corner| corner.plane)), paint);
        }
        let parabola = (-100..=100).map(|i| f64::from(i) / 50.0).map(|a1| (a1, a1 * a1 / 4.0));
        canvas.line(frame.path(parabola), line(GREY, 0.4));
        for sign in [-1.0, 1.0] {
            let edge = lower_edge(sign).into_iter().map(|corner| corner.plane);
            canvas.line(frame.path(edge), line(BLACK, 0.5));
        }
    });
    frame.draw(canvas);
    canvas.text(title(case), (frame.left, top + 0.5 * TITLE), Anchor::Start);
}

/// What the colours mean: nothing, no chaos, a scale.
fn key(canvas: &mut Canvas, last: u64) {
    let mut x = 4.0;
    let outline = line(BLACK, 0.4);
    for (name, entropy) in [("nothing", None), ("no chaos", Some(0.0))] {
        canvas.rectangle([x, 4.0, x + 12.0, 12.0], shade(entropy));
        canvas.rectangle([x, 4.0, x + 12.0, 12.0], outline);
        canvas.text(name, (x + 15.0, 8.0), Anchor::Start);
        x += if entropy.is_none() { 50.0 } else { 58.0 };
    }
    let (left, right) = (x, COLUMN - 8.0);
    // Each piece reaches to the end, so that nothing shines through between them.
    for i in 0..128 {
        let share = f64::from(i) / 128.0;
        let ink = shade(Some((share * std::f64::consts::LN_2).max(1e-9)));
        canvas.rectangle([left + share * (right - left), 4.0, right, 12.0], ink);
    }
    canvas.rectangle([left, 4.0, right, 12.0], outline);
    for (rate, name) in [(0.0, "0"), (0.2, "0.2"), (0.4, "0.4")] {
        let at = left + rate / std::f64::consts::LN_2 * (right - left);
        canvas.line(vec![(at, 12.0), (at, 14.0)], outline);
        canvas.sized(name, (at, 18.5), Anchor::Middle, 7.0);
    }
    canvas.sized("log 2", (COLUMN - 4.0, 18.5), Anchor::End, 7.0);
    let what = format!("entropy per forcing period; areas of period ≤ {last}");
    canvas.text(what, (COLUMN - 4.0, 28.0), Anchor::End);
}

fn draw(last: u64, cells: &[Cell]) -> Canvas {
    let mut canvas = Canvas::new(
        COLUMN,
        36.0 + 3.0 * PANEL + 10.0,
        "Which impact patterns a grazing bifurcation gives birth to",
        "Three panels, one per case, show the (a1, a2) plane for 0 < a2 < 1. White: no pattern is born; grey: \
         patterns, but no chaos; from yellow to dark blue: chaos, of entropy up to log 2.",
    );
    key(&mut canvas, last);
    let cases = [Case::PlusPlus, Case::PlusMinus, Case::MinusPlus];
    for (case, top) in cases.into_iter().zip((0..).map(|i| 36.0 + PANEL * f64::from(i))) {
        panel(&mut canvas, top, cells, case, case == Case::MinusPlus);
    }
    canvas
}

#[cfg(test)]
mod tests {
    use num_integer::Integer;

    use super::*;

    #[test]
    fn numerators_and_firsts_give_words() {
        for n in 3..=20u64 {
            for m in (1..n.div_ceil(2)).filter(|m| m.gcd(&n) == 1) {
                assert!(Word::of_area(n, m, Letter::U, n.div_ceil(2 * m).max(2)).is_some());
            }
        }
    }
}
