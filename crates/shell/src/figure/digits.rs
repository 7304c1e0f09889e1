//! Digits against time: a panel per family of inputs, a line per method, both axes logarithmic.

use std::{io::Write, path::Path};

use super::{
    FigurePlace,
    canvas::{Anchor, At, BLACK, BLUE, Canvas, Colour, GREEN, GREY, ORANGE, PINK, RED, Stroke, Words, line},
    frame::{Axis, PlotFrame},
    legend::Legend,
    panels::{
        ACROSS, HIGH, PanelRow, PriceTable, WIDTH, caption, caption_height, corner, cross, draw_caption,
        labels, rows, sample, short, time_range, values, whisker,
    },
};
use crate::{
    error::Result,
    output::{TableCell, TableFormat},
    study::DigitsPrice,
};

/// Draws `digits.svg` from `digits.csv` and, if it is there, `digits-peers.csv`.
///
/// # Errors
/// An I/O error; an input error if a table is none.
pub fn digits_figure(folder: &Path) -> Result<()> {
    let rows = rows(folder, "digits.csv", "digits-peers.csv")?;
    FigurePlace::svg(folder, "digits").draw(&draw(&rows))
}

/// Writes the table behind the figure.
///
/// # Errors
/// An I/O error from `out`.
pub fn digits_table(prices: &[DigitsPrice], format: TableFormat, out: &mut dyn Write) -> Result<()> {
    let names = [
        "family",
        "method",
        "time_ns",
        "q25",
        "q75",
        "digits",
        "least",
        "log10_width",
        "bits_lost",
        "log10_condition",
        "decided",
        "wrong",
        "outside",
        "inputs",
        "load",
    ];
    let mut table = PriceTable::new(out, format, "grazing-digits 1", &names)?;
    for price in prices {
        let number =
            |x: Option<f64>| x.filter(|x| x.is_finite()).map_or(String::new(), |x| format!("{x:.1}"));
        let digits = price.digits.map(|x| if x == f64::INFINITY { "all".into() } else { number(Some(x)) });
        let (width, condition) = (number(price.width), number(Some(price.condition)));
        let load = price.load.map_or(String::new(), |load| format!("{load:.2}"));
        let [time, q25, q75] = price.time.map(|time| TableCell::Int(time.as_nanos() as i64));
        let count = |x: usize| TableCell::Int(x as i64);
        let method = price.method.name();
        table.row(&[
            TableCell::Text(price.family.name()),
            TableCell::Text(&method),
            time,
            q25,
            q75,
            TableCell::Text(&digits[0]),
            TableCell::Text(&digits[1]),
            TableCell::Text(&width),
            price.lost.map_or(TableCell::Empty, |lost| TableCell::Int(lost as i64)),
            TableCell::Text(&condition),
            count(price.decided),
            count(price.wrong),
            count(price.outside),
            count(price.inputs),
            TableCell::Text(&load),
        ])?;
    }
    table.finish()
}

/// How the points of a method are drawn.
#[derive(Clone, Copy, PartialEq)]
enum Mark {
    /// Of floats, which promise nothing.
    Cross,
    Ring,
    Disc,
    /// Joined by a line.
    Line(f64),
    /// A line across: all digits.
    Across,
}

/// Methods by the beginnings of their names, in the order of drawing.
const STYLES: [(&str, Mark, Colour); 7] = [
    ("fraction", Mark::Across, ORANGE),
    ("Arb", Mark::Line(0.8), GREEN),
    ("ladder", Mark::Line(1.4), RED),
    ("bits", Mark::Line(0.8), BLUE),
    ("f64 interval", Mark::Disc, BLACK),
    ("f64, naive", Mark::Cross, PINK),
    ("f64", Mark::Ring, GREY),
];

/// The style's place in [`STYLES`].
fn style(method: &str) -> usize {
    let name = |known: &str| match known {
        "bits" => method.ends_with(" bits") && !method.starts_with("Arb"),
        "f64" | "plain f64" => matches!(method, "f64" | "plain f64"),
        _ => method.starts_with(known),
    };
    STYLES.iter().position(|(known, ..)| name(known)).unwrap_or(STYLES.len() - 1)
}

/// Less than one digit has a column of its own, left of a broken line; this is its middle, as a logarithm,
/// and that of the line.
const NONE: f64 = -0.36;
const BREAK: f64 = -0.14;

fn draw(rows: &[PanelRow]) -> Canvas {
    let families = values(rows, "family");
    let lines = caption(
        rows.iter(),
        "Medians over the inputs of a family and over repetitions; bars: quartiles. Digits of enclosures are \
         certain, those of floats happen to be right.",
    );
    let key = key(rows);
    // In the place of a panel, or below them all.
    let free = !families.len().is_multiple_of(ACROSS);
    let panels = 4.0 + HIGH * families.len().div_ceil(ACROSS) as f64;
    let below = panels + 10.0 + if free { 0.0 } else { key.height(WIDTH - 12.0) + 4.0 };
    let mut canvas = Canvas::new(
        WIDTH,
        below + caption_height(&lines),
        "Digits against time: methods side by side",
        "A panel per family of inputs. Across: correct decimal digits of b, logarithmic. Up: the time of one \
         value, logarithmic. A line per method: balls of 128 to 4096 bits, the ladder to 10 to 1000 digits, Arb; \
         marks for floats and intervals; a line across for exact fractions.",
    );
    for (place, &family) in families.iter().enumerate() {
        let of: Vec<&PanelRow> = rows.iter().filter(|row| row.text("family") == family).collect();
        panel(&mut canvas, &of, family, corner(place), rows);
    }
    canvas.text("correct decimal digits", (WIDTH / 2.0, panels + 3.0), Anchor::Middle);
    if free {
        let (left, top) = corner(families.len());
        key.draw(&mut canvas, (left + 12.0, top + 10.0), WIDTH / ACROSS as f64 - 16.0);
    } else {
        key.draw(&mut canvas, (6.0, panels + 10.0), WIDTH - 12.0);
    }
    draw_caption(&mut canvas, lines, below);
    canvas
}

fn panel(canvas: &mut Canvas, rows: &[&PanelRow], family: &str, (left, top): At, all: &[PanelRow]) {
    let digits = |row: &PanelRow| row.number("digits");
    let found = || all.iter().filter_map(digits);
    let least = found().fold(1e4, f64::min);
    // With room for a time behind the last point.
    let most = found().fold(10.0, f64::max).log10() + 0.9;
    let mut marks: Vec<(f64, Words)> = vec![];
    let from = if least < 1.0 {
        marks.push((NONE, "< 1".into()));
        2.0 * NONE - BREAK
    } else {
        least.log10() - 0.05
    };
    marks.extend((0..4).map(|e| (f64::from(e), format!("{}", 10u64.pow(e as u32)).into())));
    marks.retain(|(place, _)| (from..most).contains(place));
    let (times, time_marks) = time_range(all);
    let wide = WIDTH / ACROSS as f64;
    let frame = PlotFrame::new(
        [left + 4.0, top + 10.0, left + wide - 4.0, top + HIGH - 4.0],
        Axis::marked("", (from, most), true, marks),
        Axis::marked("", times, true, time_marks),
    );
    // A lone letter is a symbol, but for the article.
    let title = family.replace("->", "→");
    let title = if family.contains(" a ") { Words::plain(&title) } else { title.into() };
    canvas.text(title, (frame.left, top + 5.0), Anchor::Start);
    let ends = [times.0, times.1].map(|t| 10f64.powf(t));
    if least < 1.0 {
        let gap = frame.path(ends.map(|t| (10f64.powf(BREAK), t)));
        canvas.line(gap, Stroke { dashes: Some([2.0, 2.0]), ..line(GREY, 0.4) });
    }
    let x = |row: &PanelRow| {
        let digits = digits(row).unwrap_or(0.0);
        if digits < 1.0 { 10f64.powf(NONE) } else { digits }
    };
    let (mut lines, mut marks, mut texts) = (Vec::new(), Vec::new(), Vec::new());
    for (index, (_, mark, ink)) in STYLES.into_iter().enumerate() {
        let of: Vec<&&PanelRow> = rows.iter().filter(|row| style(row.text("method")) == index).collect();
        let points: Vec<At> = of.iter().map(|row| frame.at((x(row), row.times()[0]))).collect();
        match mark {
            Mark::Across => {
                for row in &of {
                    let time = row.times()[0];
                    let ends = [from, most].map(|digits| (10f64.powf(digits), time));
                    canvas.line(frame.path(ends), Stroke { dashes: Some([4.0, 2.0]), ..line(ink, 1.0) });
                    lines.push(frame.path(ends));
                    texts.push((frame.at((3.0, time)), format!("fraction {}", short(time))));
                }
                continue;
            }
            Mark::Line(width) => {
                canvas.line(points.clone(), line(ink, width));
                canvas.discs(points.clone(), 1.3, ink);
                lines.push(points.clone());
            }
            Mark::Disc => canvas.discs(points.clone(), 2.0, ink),
            Mark::Ring => canvas.discs(points.clone(), 2.0, line(ink, 0.9)),
            Mark::Cross => points.iter().for_each(|&at| cross(canvas, at, ink)),
        }
        for row in &of {
            whisker(canvas, &frame, x(row), row.times(), ink);
            let [_, low, high] = row.times();
            lines.push(frame.path([(x(row), low), (x(row), high)]));
        }
        marks.extend(points);
    }
    // The values that matter: an interval's time, and that of the longest balls here and there.
    let last = |index: usize| rows.iter().rfind(|row| style(row.text("method")) == index);
    let at = |row: &PanelRow| frame.at((x(row), row.times()[0]));
    texts.extend([4, 3, 1].into_iter().filter_map(last).map(|row| (at(row), short(row.times()[0]))));
    labels(canvas, &frame, &lines, &marks, texts);
    frame.draw(canvas);
}

fn key(rows: &[PanelRow]) -> Legend<'static> {
    let names = [
        "exact fraction: all digits",
        "Arb, 128 to 4096 bits",
        "ladder, to 10 to 1000 digits",
        "balls of 128 to 4096 bits",
        "f64 interval",
        "f64, the paper's formulas",
        "f64, these forms",
    ];
    let mut legend = Legend::default();
    for (index, (name, (_, mark, ink))) in names.into_iter().zip(STYLES).enumerate() {
        if !rows.iter().any(|row| style(row.text("method")) == index) {
            continue;
        }
        legend.add(Words::plain(name), move |canvas: &mut Canvas, (x, y): At| match mark {
            Mark::Across => canvas.line(
                vec![(x - 8.0, y), (x + 8.0, y)],
                Stroke { dashes: Some([4.0, 2.0]), ..line(ink, 1.0) },
            ),
            Mark::Line(_) => sample(canvas, (x, y), ink),
            Mark::Disc => canvas.disc((x, y), 2.0, ink),
            Mark::Ring => canvas.disc((x, y), 2.0, line(ink, 0.9)),
            Mark::Cross => cross(canvas, (x, y), ink),
        });
    }
    legend
}

#[cfg(test)]
mod tests {
    use super::{super::assert_shows_its_tables, *};

    #[test]
    fn the_checked_in_picture_shows_the_checked_in_tables() {
        assert_shows_its_tables("digits", draw);
    }

    #[test]
    fn each_method_has_its_style() {
        let known = |method: &str| STYLES[style(method)].0;
        for (method, name) in [
            ("f64", "f64"),
            ("plain f64", "f64"),
            ("f64, naive", "f64, naive"),
            ("f64 interval", "f64 interval"),
            ("128 bits", "bits"),
            ("Arb, 128 bits", "Arb"),
            ("ladder to 30 digits", "ladder"),
            ("fraction", "fraction"),
        ] {
            assert_eq!(known(method), name, "{method}");
        }
    }
}
