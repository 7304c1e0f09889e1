//! Axes: a frame with marks, numbers and names, and where its numbers are in the picture.

use super::canvas::{Anchor, At, BLACK, Canvas, TYPE, Words, line};

/// An axis: its name, its range, its marks.
#[derive(Debug, Clone)]
pub struct Axis {
    name: Words,
    from: f64,
    to: f64,
    log: bool,
    /// Where marks may be left out for want of room: the most of them.
    most: Option<usize>,
    marks: Vec<(f64, Words)>,
}

impl Axis {
    /// An axis with at most about `most` marks, at multiples of 1, 2 or 5 times a power of ten.
    pub fn linear(name: impl Into<Words>, (from, to): (f64, f64), most: usize) -> Axis {
        Axis { name: name.into(), from, to, log: false, most: Some(most), marks: even(from, to, most) }
    }

    /// An axis with these marks, whose places are numbers or, if it is logarithmic, their logarithms to
    /// base 10.
    pub fn marked(
        name: impl Into<Words>,
        (from, to): (f64, f64),
        log: bool,
        marks: Vec<(f64, Words)>,
    ) -> Axis {
        Axis { name: name.into(), from, to, log, most: None, marks }
    }

    /// A logarithmic axis between two powers of ten, marked at each `step`-th.
    pub fn decades(name: impl Into<Words>, [from, to]: [i32; 2], step: i32) -> Axis {
        let marks =
            (from..=to).filter(|exponent| (exponent - from) % step == 0).map(|e| (f64::from(e), power(e)));
        Axis::marked(name, (f64::from(from), f64::from(to)), true, marks.collect())
    }

    /// Leaves out marks until the numbers have room beside one another on a length.
    fn thin(&mut self, length: f64) {
        let part = length / (self.to - self.from);
        let crowded = |marks: &[(f64, Words)]| {
            let room = |pair: &[(f64, Words)]| (pair[1].0 - pair[0].0) * part;
            let need =
                |pair: &[(f64, Words)]| (pair[0].1.width(TYPE) + pair[1].1.width(TYPE)) / 2.0 + 0.6 * TYPE;
            marks.windows(2).any(|pair| room(pair) < need(pair))
        };
        while let Some(most) = self.most.filter(|&most| most > 1 && crowded(&self.marks)) {
            self.most = Some(most - 1);
            self.marks = even(self.from, self.to, most - 1);
        }
    }

    /// Where a number is, from 0 to 1.
    fn share(&self, x: f64) -> f64 {
        let x = if self.log { x.log10() } else { x };
        (x - self.from) / (self.to - self.from)
    }
}

/// A power of ten.
pub fn power(exponent: i32) -> Words {
    match exponent {
        0 => "1".into(),
        1 => "10".into(),
        _ => format!("10^{{{exponent}}}").replace('-', "−").into(),
    }
}

/// Marks at multiples of a round step, with as many decimals as it has.
fn even(from: f64, to: f64, most: usize) -> Vec<(f64, Words)> {
    let size = to - from;
    if !(size > 0.0 && size.is_finite()) {
        return Vec::new();
    }
    let least = size / most.max(1) as f64;
    let mut exponent = least.log10().floor() as i32;
    let ten = 10f64.powi(exponent);
    let factor =
        [1.0, 2.0, 5.0, 10.0].into_iter().find(|factor| factor * ten >= 0.999 * least).unwrap_or(10.0);
    let step = factor * ten;
    if factor == 10.0 {
        exponent += 1;
    }
    let (first, last) = ((from / step - 1e-6).ceil(), (to / step + 1e-6).floor());
    let count = (last - first).clamp(-1.0, 100.0) as i64 + 1;
    let widest = from.abs().max(to.abs());
    let number = |x: f64| -> Words {
        let text = if (1e-4..1e5).contains(&widest) {
            format!("{x:.*}", (-exponent).max(0) as usize)
        } else {
            // As a number times a power of ten, by the step's digits.
            let digits = (widest.log10().floor() as i32 - exponent).clamp(0, 12) as usize;
            let text = format!("{x:.digits$e}");
            match text.split_once('e') {
                _ if x == 0.0 => "0".into(),
                Some((mantissa, power)) => format!("{mantissa}·10^{{{power}}}"),
                None => text,
            }
        };
        let zero = text.trim_start_matches('-').bytes().all(|byte| matches!(byte, b'0' | b'.'));
        let text = if zero { text.trim_start_matches('-').to_string() } else { text };
        text.replace('-', "−").into()
    };
    (0..count).map(|i| (first + i as f64) * step).map(|x| (x, number(x))).collect()
}

/// Room between marks and their numbers, and the length of a mark.
const GAP: f64 = 2.0;
const MARK: f64 = 2.5;

/// A rectangle with two axes.
#[derive(Debug, Clone)]
pub struct PlotFrame {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
    x: Axis,
    y: Axis,
}

impl PlotFrame {
    /// A frame that, with its numbers and names, fills a rectangle: left, top, right, bottom.
    pub fn new([left, top, right, bottom]: [f64; 4], x: Axis, y: Axis) -> PlotFrame {
        let mut frame = PlotFrame { left, top, right, bottom, x, y };
        frame.left += frame.name_width() + frame.numbers_width() + MARK + GAP;
        frame.bottom -= MARK + GAP + TYPE + if frame.x.name.0.is_empty() { 0.0 } else { 1.4 * TYPE };
        frame.x.thin(frame.right - frame.left - 2.0 * TYPE);
        // The last number under the axis may stand out on the right, the highest one beside it above.
        let over = |(x, words): &(f64, Words)| {
            words.width(TYPE) / 2.0 - (1.0 - share_of(&frame.x, *x)) * (frame.right - frame.left)
        };
        frame.right -= frame.x.marks.iter().map(over).fold(0.5, f64::max);
        frame.top += 0.4 * TYPE;
        frame
    }

    /// The same, its left side moved: for frames below one another.
    pub fn with_left(self, left: f64) -> PlotFrame {
        PlotFrame { left, ..self }
    }

    fn numbers_width(&self) -> f64 {
        self.y.marks.iter().map(|(_, words)| words.width(TYPE)).fold(0.0, f64::max)
    }

    /// A short name stands upright, a long one is turned.
    fn name_width(&self) -> f64 {
        match self.y.name.width(TYPE) {
            0.0 => 0.0,
            width if width < 2.0 * TYPE => width + 4.0,
            _ => 1.5 * TYPE,
        }
    }

    /// Where a point is.
    pub fn at(&self, (x, y): (f64, f64)) -> At {
        let (x, y) = (self.x.share(x), self.y.share(y));
        (self.left + x * (self.right - self.left), self.bottom - y * (self.bottom - self.top))
    }

    /// Where points are.
    pub fn path(&self, points: impl IntoIterator<Item = (f64, f64)>) -> Vec<At> {
        points.into_iter().map(|point| self.at(point)).collect()
    }

    /// The rectangle inside: left, top, right, bottom.
    pub fn inside(&self) -> [f64; 4] {
        [self.left, self.top, self.right, self.bottom]
    }

    /// Whether a place is inside, its edge included.
    pub fn holds(&self, (x, y): At) -> bool {
        let slack = 0.01;
        (self.left - slack..=self.right + slack).contains(&x)
            && (self.top - slack..=self.bottom + slack).contains(&y)
    }

    /// Draws the frame, its marks, numbers and names.
    pub fn draw(&self, canvas: &mut Canvas) {
        let stroke = line(BLACK, 0.6);
        canvas.rectangle(self.inside(), stroke);
        let along = |axis: &Axis, from: f64, to: f64, x: f64| from + share_of(axis, x) * (to - from);
        let mut marks = Vec::new();
        for (x, words) in &self.x.marks {
            let x = along(&self.x, self.left, self.right, *x);
            marks.push(vec![(x, self.bottom), (x, self.bottom + MARK)]);
            canvas.text(words.clone(), (x, self.bottom + MARK + GAP + 0.4 * TYPE), Anchor::Middle);
        }
        for (y, words) in &self.y.marks {
            let y = along(&self.y, self.bottom, self.top, *y);
            marks.push(vec![(self.left - MARK, y), (self.left, y)]);
            canvas.text(words.clone(), (self.left - MARK - GAP, y), Anchor::End);
        }
        canvas.lines(marks, stroke);
        let (middle, centre) = ((self.left + self.right) / 2.0, (self.top + self.bottom) / 2.0);
        let below = self.bottom + MARK + GAP + 1.7 * TYPE;
        canvas.text(self.x.name.clone(), (middle, below), Anchor::Middle);
        let beside = self.left - MARK - GAP - self.numbers_width() - 4.0;
        if self.y.name.width(TYPE) < 2.0 * TYPE {
            canvas.text(self.y.name.clone(), (beside, centre), Anchor::End);
        } else {
            canvas.turned(self.y.name.clone(), (beside - 0.5 * TYPE, centre));
        }
    }
}

/// Where a mark is, from 0 to 1: its place is a logarithm already.
fn share_of(axis: &Axis, mark: f64) -> f64 {
    (mark - axis.from) / (axis.to - axis.from)
}

/// The symbol that a parameter's name spells, as in `mu`, with what follows an underscore as an index, or the
/// name; a unit in parentheses behind it, as in `F (N)`, stays there.
pub fn symbol(name: &str) -> Words {
    const LETTERS: [(&str, &str); 16] = [
        ("alpha", "α"),
        ("beta", "β"),
        ("gamma", "γ"),
        ("delta", "δ"),
        ("epsilon", "ε"),
        ("zeta", "ζ"),
        ("theta", "θ"),
        ("lambda", "λ"),
        ("mu", "µ"),
        ("nu", "ν"),
        ("rho", "ρ"),
        ("sigma", "σ"),
        ("tau", "τ"),
        ("phi", "φ"),
        ("psi", "ψ"),
        ("omega", "ω"),
    ];
    if let Some((bare, unit)) = name.split_once(" (") {
        let mut words = symbol(bare);
        words.0.extend(Words::plain(&format!(" ({unit}")).0);
        return words;
    }
    let letter = |name: &str| LETTERS.iter().find(|(word, _)| *word == name).map(|(_, letter)| *letter);
    let (base, index) = name.split_once('_').unwrap_or((name, ""));
    let digits = base.len() - base.trim_start_matches(|c: char| !c.is_ascii_digit()).len();
    let (base, number) = base.split_at(digits.max(1).min(base.len()));
    let base = letter(base).unwrap_or(base);
    let is_symbol = base.chars().count() == 1;
    let index = format!("{number}{index}");
    let simple = index.chars().all(|c| c.is_alphanumeric());
    match (is_symbol && simple, index.as_str()) {
        // A formula, not a parameter.
        _ if !name.is_ascii() => name.into(),
        (true, "") => base.into(),
        (true, index) => format!("{base}_{{{index}}}").into(),
        _ => Words::plain(name),
    }
}

/// The range of some numbers with a margin, never empty.
pub fn padded(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values
        .filter(|value| value.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    if low > high {
        return (-1.0, 1.0);
    }
    // One value, to rounding, is shown by its own size.
    let alone = high - low <= 1e-9 * high.abs();
    let margin = match alone {
        true if high == 0.0 => 1.0,
        true => 0.1 * high.abs(),
        false => 0.06 * (high - low),
    };
    (low - margin, high + margin)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(marks: &[(f64, Words)]) -> Vec<String> {
        marks.iter().map(|(_, words)| words.0.iter().map(|run| run.text.as_str()).collect()).collect()
    }

    #[test]
    fn marks_are_even_and_short() {
        assert_eq!(texts(&even(0.0, 1.0, 6)), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(texts(&even(-2.0, 2.0, 5)), ["−2", "−1", "0", "1", "2"]);
        assert_eq!(
            texts(&even(-0.0247, -0.0224, 5)),
            ["−0.0245", "−0.0240", "−0.0235", "−0.0230", "−0.0225"]
        );
        assert_eq!(texts(&even(0.0, 6e-7, 4)), ["0", "2·10−7", "4·10−7", "6·10−7"]);
        assert_eq!(texts(&even(1000.0, 1001.0, 3)), ["1000.0", "1000.5", "1001.0"]);
        assert!(even(1.0, 1.0, 5).is_empty() && even(0.0, f64::INFINITY, 5).is_empty());
        for most in 2..9 {
            let marks = even(-0.317, 12.9, most);
            assert!((1..=most + 1).contains(&marks.len()), "{most}: {:?}", texts(&marks));
        }
    }

    #[test]
    fn names_become_symbols() {
        let shown = |name| symbol(name).0.iter().map(|run| run.text.clone()).collect::<Vec<_>>().join("|");
        assert_eq!(shown("mu"), "µ");
        assert_eq!(shown("a1"), "a|1");
        assert_eq!(shown("mu_gr"), "µ|gr");
        assert_eq!(shown("speed_max"), "speed_max");
        assert_eq!(shown("F0"), "F|0");
        assert_eq!(shown("F0 (kg m/s^2)"), "F|0| (kg m/s^2)");
        assert_eq!(shown("w"), "w");
        assert_eq!(shown(""), "");
    }
}
