//! A machine as measured: the image of its tolerances in the plane, cell by cell in the colour of its word,
//! on both sides of the touch.
//!
//! The image of a box is curved, and thinner than the rectangle around it. Behind it, paler, are the words of
//! that rectangle: where the image would come if it were larger.

use std::f64::consts::TAU;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::{
    FigurePlace,
    canvas::{
        Anchor, At, BLACK, BLUE, COLUMN, Canvas, Colour, GREEN, ORANGE, PINK, Paint, SKY, Words, YELLOW, line,
    },
    frame::{Axis, PlotFrame, padded},
    labels::{DOT, Labels},
    legend::Legend,
};
use crate::{
    error::Result,
    monitor::Monitor,
    output::{decimal_above, decimal_below, decimal_near, decimal_or_fraction},
    tolerance::{Leaf, ParameterBox, Partition, Share, Spread, Statement},
    word::Word,
};

/// How many cells are looked at: of the box, and of the rectangle around its image.
const CELLS: u64 = 2_000;
const BEHIND: u64 = 1_000;

/// The colours of words, the one with the largest share first; the others have one together.
const WORDS: [Colour; 6] = [BLUE, ORANGE, GREEN, PINK, SKY, YELLOW];
const OTHERS: Colour = Colour(205, 205, 205);
const OPEN: Colour = Colour(125, 125, 125);
/// How much of its colour a word has in the image, so that a label can be read on it, and behind it.
const FULL: f64 = 0.75;
const PALE: f64 = 0.2;
/// The height of a panel without its legend.
const PANEL: f64 = 128.0;
/// Points on each side of the image.
const SIDE: u32 = 64;

/// Which plane is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Plane {
    /// Across s, up r: all eigenvalues are complex.
    Polar,
    /// Across a₁, up a₂.
    Trace,
}

impl Plane {
    fn of(names: [&str; 2], of: &ParameterBox) -> Plane {
        let one = BigRational::from_integer(1.into());
        if names[0] == "a1" || (names[0] == "ratio" && of.bounds()[1][1] >= one) {
            Plane::Trace
        } else {
            Plane::Polar
        }
    }

    /// Where the parameters of a box lead.
    fn at(self, of: &ParameterBox, parameters: [f64; 2]) -> (f64, f64) {
        let [a1, a2] = of.in_plane(parameters);
        if self == Plane::Trace {
            return (a1, a2);
        }
        let r = a2.sqrt();
        ((a1 / (2.0 * r)).clamp(-1.0, 1.0).acos() / TAU, r)
    }

    /// The image of a cell of a box, with so many points on each side.
    fn image(self, of: &ParameterBox, cell: &ParameterBox, side: u32) -> Vec<(f64, f64)> {
        let [[x0, x1], [y0, y1]] = floats(cell);
        let corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
        let along = |i: usize| {
            let (from, to) = (corners[i], corners[(i + 1) % 4]);
            (0..side).map(move |step| {
                let part = f64::from(step) / f64::from(side);
                self.at(of, [0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis])))
            })
        };
        (0..4).flat_map(along).collect()
    }

    /// The rectangle around points as a box, as far as the theory has one.
    fn around(self, [across, up]: [(f64, f64); 2]) -> Option<ParameterBox> {
        let least = 1e-6;
        let ends = |(from, to): (f64, f64), within: (f64, f64)| {
            let [from, to] = [from.max(within.0), to.min(within.1)].map(BigRational::from_float);
            Some([from?, to?])
        };
        match self {
            Plane::Polar => {
                ParameterBox::polar(ends(up, (least, 1.0))?, ends(across, (least, 0.5 - least))?).ok()
            }
            Plane::Trace => ParameterBox::plane(ends(across, (-9.0, 9.0))?, ends(up, (least, 1.0))?).ok(),
        }
    }
}

fn floats(cell: &ParameterBox) -> [[f64; 2]; 2] {
    cell.bounds().each_ref().map(|ends| ends.each_ref().map(|x| x.to_f64().unwrap_or(f64::NAN)))
}

fn is_flat(of: &ParameterBox) -> bool {
    of.bounds().iter().any(|[lower, upper]| lower == upper)
}

/// One side of the touch.
struct Side<'a> {
    positive: bool,
    partition: &'a Partition,
    /// The words that have a colour of their own.
    words: Vec<(Word, Share)>,
    others: usize,
}

impl<'a> Side<'a> {
    fn new(partition: &'a Partition, positive: bool) -> Side<'a> {
        let mut words = partition.words(positive);
        let others = words.len().saturating_sub(WORDS.len());
        words.truncate(WORDS.len());
        Side { positive, partition, words, others }
    }

    fn colour(&self, leaf: &Leaf) -> Colour {
        if !leaf.word(self.positive).is_whole() {
            return OPEN;
        }
        let own = |(word, _): &(Word, Share)| leaf.holds(Statement::Word(word)) == Some(true);
        self.words.iter().position(own).map_or(OTHERS, |place| WORDS[place])
    }

    /// The share of the box on which the word is open, at most.
    fn open(&self) -> f64 {
        let leaves = self.partition.leaves().iter();
        leaves
            .filter(|leaf| !leaf.word(self.positive).is_whole())
            .map(|leaf| 0.5f64.powi(leaf.depth as i32))
            .sum()
    }

    fn legend(&self, of: &ParameterBox) -> Legend<'static> {
        let mut legend = Legend::default();
        let mut add = |name: String, ink: Colour| {
            legend.add(Words::plain(&name), move |canvas: &mut Canvas, (x, y): At| {
                canvas.rectangle([x - 8.0, y - 3.5, x + 8.0, y + 3.5], tinted(ink, FULL));
            });
        };
        for ((word, share), ink) in self.words.iter().zip(WORDS) {
            let chaos = if self.is_chaotic(of, word) { "; chaos" } else { "" };
            add(format!("{} ({}): {}{chaos}", letters(word), periods(word), percent(share)), ink);
        }
        if self.others > 0 {
            let words = if self.others == 1 { "word" } else { "words" };
            add(format!("{} other {words}", self.others), OTHERS);
        }
        let open = self.open();
        if open > 0.0 {
            add(format!("open: {:.2} %", (open * 1e4).ceil() / 100.0), OPEN);
        }
        legend
    }

    /// Whether chaos is born with this word, whatever γ is that a machine with it has.
    fn is_chaotic(&self, of: &ParameterBox, word: &Word) -> bool {
        let leaves = self.partition.leaves().iter();
        let signs: Vec<_> = of.signs().into_iter().filter(|signs| signs.positive == self.positive).collect();
        leaves
            .filter(|leaf| leaf.holds(Statement::Word(word)) == Some(true))
            .all(|leaf| signs.iter().all(|signs| leaf.holds(signs.chaos()) == Some(true)))
    }
}

/// The most letters and periods of a word that are written.
const LETTERS: usize = 10;
const PERIODS: usize = 6;

fn letters(word: &Word) -> String {
    let all = word.letters();
    if all.chars().count() <= LETTERS { all } else { all.chars().take(LETTERS).chain(['…']).collect() }
}

fn periods(word: &Word) -> String {
    let all = word.vertices();
    if all.len() > 3 && !word.is_endless() && (1..).zip(all).all(|(n, vertex)| vertex.period == n) {
        return format!("1 to {}", all.len());
    }
    let shown: Vec<String> = all.iter().take(PERIODS).map(|vertex| vertex.period.to_string()).collect();
    let more = if all.len() > PERIODS || word.is_endless() { ", …" } else { "" };
    shown.join(", ") + more
}

fn percent(share: &Share) -> String {
    if share.spread() == Spread::Everywhere {
        return "all of it".into();
    }
    let [lower, upper] = [&share.lower, &share.upper].map(|end| end * BigInt::from(100));
    format!("{} to {} %", decimal_below(&lower, 1), decimal_above(&upper, 1))
}

/// The names of a box's parameters in the data, and in words.
fn named(name: &str) -> ([[&'static str; 2]; 2], [&'static str; 2]) {
    match name {
        "ratio" => (
            [["ratio_lower", "ratio_upper"], ["damping_lower", "damping_upper"]],
            ["natural frequency / drive frequency", "damping ratio"],
        ),
        "r" => ([["r_lower", "r_upper"], ["s_lower", "s_upper"]], ["r", "s"]),
        _ => ([["a1_lower", "a1_upper"], ["a2_lower", "a2_upper"]], ["a₁", "a₂"]),
    }
}

/// Writes the picture of a box whose parameters have these names, and its data: a row per cell.
///
/// # Errors
/// An I/O error; the monitor's interruption.
pub fn tolerance(
    of: &ParameterBox,
    names: [&'static str; 2],
    place: &FigurePlace,
    monitor: &dyn Monitor,
) -> Result<()> {
    let partition = Partition::new(of, CELLS, monitor)?;
    let plane = Plane::of(names, of);
    let whole = plane.image(of, of, SIDE);
    let limits = [padded(whole.iter().map(|at| at.0)), padded(whole.iter().map(|at| at.1))];
    let behind = plane.around(limits);
    let behind = behind.map(|rectangle| Partition::new(&rectangle, BEHIND, monitor)).transpose()?;
    let word = |leaf: &Leaf, positive: bool| {
        let word = leaf.word(positive);
        if word.is_whole() { word.letters() } else { String::new() }
    };
    let row = |leaf: &Leaf| {
        let bounds = leaf.cell.bounds().iter().flatten().map(decimal_or_fraction);
        let gamma = leaf.gamma.map_or("", |positive| if positive { "1" } else { "-1" });
        let rest = [leaf.depth.to_string(), gamma.into(), word(leaf, true), word(leaf, false)];
        bounds.chain(rest).collect()
    };
    let rows: Vec<Vec<String>> = partition.leaves().iter().map(row).collect();
    let (columns, _) = named(names[0]);
    let columns =
        [columns.as_flattened(), &["halvings", "sign_gamma", "word_before", "word_beyond"]].concat();
    let picture = Picture { of, plane, whole, limits, behind, heading: heading(of, names[0]) };
    place.save(&picture.draw(&partition), &columns, &rows)
}

/// The bounds of a box in words, a line for each parameter.
fn heading(of: &ParameterBox, name: &str) -> [String; 2] {
    let (_, words) = named(name);
    [0, 1].map(|i| {
        let [lower, upper] = &of.bounds()[i];
        let flat = lower == upper;
        // To two digits of how far the ends are apart, or of the number itself.
        let size = if flat { upper.abs() } else { upper - lower };
        let told = |places: &u32| &size * BigInt::from(10).pow(*places) >= BigInt::from(100).into();
        let places = (6..=40).find(told).unwrap_or(if size.is_zero() { 6 } else { 40 });
        let number = |x: &BigRational| {
            let text = decimal_near(x, places);
            text.trim_end_matches('0').trim_end_matches('.').replace('-', "−")
        };
        match flat {
            true => format!("{}: {}", words[i], number(lower)),
            false => format!("{}: {} to {}", words[i], number(lower), number(upper)),
        }
    })
}

/// What is open is darker than any word.
fn tinted(ink: Colour, share: f64) -> Colour {
    ink.tint(if ink == OPEN { (2.0 * share).min(1.0) } else { share })
}

/// The same corners in one direction, so that shapes that overlap do not cancel each other.
fn turned(mut corners: Vec<At>) -> Vec<At> {
    let pairs = corners.iter().zip(corners.iter().cycle().skip(1));
    if pairs.map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum::<f64>() < 0.0 {
        corners.reverse();
    }
    corners
}

struct Picture<'a> {
    of: &'a ParameterBox,
    plane: Plane,
    /// The outline of the image.
    whole: Vec<(f64, f64)>,
    limits: [(f64, f64); 2],
    /// The rectangle around it.
    behind: Option<Partition>,
    heading: [String; 2],
}

impl Picture<'_> {
    fn draw(&self, partition: &Partition) -> Canvas {
        let sides = [true, false].map(|positive| Side::new(partition, positive));
        let legends = sides.each_ref().map(|side| side.legend(self.of));
        let width = COLUMN - 8.0;
        let heights = legends.each_ref().map(|legend| legend.height(width) + 8.0);
        let mut canvas = Canvas::new(
            COLUMN,
            26.0 + 2.0 * PANEL + heights.iter().sum::<f64>(),
            "A machine known up to tolerances, and its words",
            "Two panels, before the touch and beyond it: the image of all that the tolerances allow, coloured by \
             the word, which lists the periods that can occur between impacts; paler, the words around it.",
        );
        for (line, y) in self.heading.iter().zip([6.0, 16.0]) {
            canvas.text(Words::plain(line), (4.0, y), Anchor::Start);
        }
        let mut top = 26.0;
        for ((side, legend), height) in sides.iter().zip(&legends).zip(heights) {
            self.panel(&mut canvas, top, side);
            legend.draw(&mut canvas, (4.0, top + PANEL), width);
            top += PANEL + height;
        }
        canvas
    }

    fn panel(&self, canvas: &mut Canvas, top: f64, side: &Side) {
        let [across, up] = if self.plane == Plane::Polar { ["s", "r"] } else { ["a₁", "a₂"] };
        let frame = PlotFrame::new(
            [2.0, top + 11.0, COLUMN - 2.0, top + PANEL - 2.0],
            Axis::linear(across, self.limits[0], 5),
            Axis::linear(up, self.limits[1], 5),
        );
        let title = if side.positive { "before the touch: eµ > 0" } else { "beyond the touch: eµ < 0" };
        canvas.text(title, (frame.left, top + 5.0), Anchor::Start);
        canvas.inside(frame.inside(), |canvas| {
            if let Some(behind) = &self.behind {
                let of = &behind.leaves()[0].cell;
                self.cells(canvas, &frame, side, (of, behind), PALE);
            }
            self.cells(canvas, &frame, side, (self.of, side.partition), FULL);
            if !is_flat(self.of) {
                canvas.polygon(frame.path(self.whole.iter().copied()), line(BLACK, 0.6));
            }
        });
        frame.draw(canvas);
        let mut outline = frame.path(self.whole.iter().copied());
        outline.extend(outline.first().copied());
        let mut labels = Labels::new(&[outline], frame.inside());
        for (word, _) in &side.words {
            let own = |leaf: &&Leaf| leaf.holds(Statement::Word(word)) == Some(true);
            let Some(leaf) = side.partition.leaves().iter().find(own) else { continue };
            let centre = leaf.cell.centre().map(|x| x.to_f64().unwrap_or(f64::NAN));
            let at = frame.at(self.plane.at(self.of, centre));
            labels.dots.push(at);
            labels.wanted.push((at, periods(word)));
        }
        canvas.discs(labels.dots.clone(), DOT, BLACK);
        labels.draw(canvas);
    }

    /// All cells of one colour are one shape.
    fn cells(
        &self,
        canvas: &mut Canvas,
        frame: &PlotFrame,
        side: &Side,
        (of, partition): (&ParameterBox, &Partition),
        tint: f64,
    ) {
        let mut colours: Vec<(Colour, Vec<Vec<At>>)> = Vec::new();
        for leaf in partition.leaves() {
            let ink = side.colour(leaf);
            // The smaller, the straighter.
            let points = (SIDE >> (leaf.depth / 2).min(6)).max(1);
            let shape = turned(frame.path(self.plane.image(of, &leaf.cell, points)));
            match colours.iter_mut().find(|(known, _)| *known == ink) {
                Some((_, shapes)) => shapes.push(shape),
                None => colours.push((ink, vec![shape])),
            }
        }
        for (ink, shapes) in colours {
            let ink = tinted(ink, tint);
            // A parameter without a tolerance leaves a line.
            let seam = line(ink, if is_flat(of) { 1.5 } else { 0.12 });
            canvas.polygons(shapes, Paint { fill: Some(ink), stroke: Some(seam) });
        }
    }
}
