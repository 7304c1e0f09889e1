//! What accuracy costs in time, at a glance: a sign, the digits of a number, a motion. Time is up and
//! accuracy to the right; at most four lines per panel, each named at the line; crosses are wrong answers.

use std::path::Path;

use super::{
    FigurePlace,
    canvas::{Anchor, At, BLACK, BLUE, Canvas, Colour, GREEN, ORANGE, PINK, TYPE, Words, line},
    frame::{Axis, PlotFrame, power},
    panels::{PanelRow, WIDTH, caption, caption_height, cross, draw_caption, duration, rows},
};
use crate::error::Result;

/// The height of a panel, and the size of its points.
const HIGH: f64 = 128.0;
const POINT: f64 = 1.6;

/// The tables that it shows, each with that of other programs beside it.
pub const TABLES: [&str; 3] = ["signs", "digits", "simulations"];

/// Draws `accuracy.svg` from the tables of signs, digits and simulations in a folder.
///
/// # Errors
/// An I/O error; an input error if a table is none.
pub fn glance_figure(folder: &Path) -> Result<()> {
    let [signs, digits, motions] = tables(folder)?;
    FigurePlace::svg(folder, "accuracy").draw(&draw(&signs, &digits, &motions))
}

fn tables(folder: &Path) -> Result<[Vec<PanelRow>; 3]> {
    let of = |name: &str| rows(folder, &format!("{name}.csv"), &format!("{name}-peers.csv"));
    let [signs, digits, motions] = TABLES;
    Ok([of(signs)?, of(digits)?, of(motions)?])
}

/// What a method gives: how accurate, in how many nanoseconds, and whether the answer is wrong.
struct Mark {
    accuracy: f64,
    time: f64,
    wrong: bool,
}

/// A method: its name, its colour, and its marks from the left.
struct Method {
    name: &'static str,
    ink: Colour,
    marks: Vec<Mark>,
}

/// A panel: what it is about, its axis across, its methods.
struct Panel {
    title: &'static str,
    across: Axis,
    methods: Vec<Method>,
}

fn draw(signs: &[PanelRow], digits: &[PanelRow], motions: &[PanelRow]) -> Canvas {
    let all = signs.iter().chain(digits).chain(motions);
    let lines = caption(
        all,
        "Medians of one computation; of a motion, of one of its periods. A line ends where its method does not \
         answer any more. Crosses are wrong answers: of signs, at least one of 88; of the motion, impacts are \
         missed.",
    );
    let below = 8.0 + 3.0 * HIGH;
    let mut canvas = Canvas::new(
        WIDTH,
        below + caption_height(&lines),
        "What accuracy costs in time: a sign, digits, a motion",
        "Three panels. Up: the time, logarithmic. To the right: the accuracy. A line per method, named at the \
         line; crosses are wrong answers.",
    );
    for (place, panel) in [of_signs(signs), of_digits(digits), of_a_motion(motions)].into_iter().enumerate() {
        draw_panel(&mut canvas, panel, 4.0 + place as f64 * HIGH);
    }
    draw_caption(&mut canvas, lines, below);
    canvas
}

/// The median over all kinds of places, at each distance where every sign was decided.
fn of_signs(table: &[PanelRow]) -> Panel {
    let method = |name, ink, method: &str| {
        let mut marks: Vec<Mark> = Vec::new();
        for exponent in [1, 2, 4, 8, 16, 32, 64, 125, 250, 500, 1000] {
            let distance = format!("1e-{exponent}");
            let of = |row: &&PanelRow| row.text("method") == method && row.text("distance") == distance;
            let of: Vec<&PanelRow> = table.iter().filter(of).collect();
            if of.is_empty() || of.iter().any(|row| row.text("decided") != row.text("inputs")) {
                break;
            }
            let wrong = of.iter().any(|row| row.number("wrong") > Some(0.0));
            let mut times: Vec<f64> = of.iter().map(|row| row.times()[0]).collect();
            times.sort_by(f64::total_cmp);
            marks.push(Mark { accuracy: f64::from(exponent), time: times[times.len() / 2], wrong });
        }
        Method { name, ink, marks }
    };
    let marks = (0..=3).map(|e: u32| (f64::from(e), format!("10^{{−{}}}", 10u32.pow(e)).into())).collect();
    Panel {
        title: "The sign of b_{n,k} or c_{n}",
        across: Axis::marked("how near to where the sign changes", (-0.1, 3.1), true, marks),
        methods: vec![
            method("every command here", BLUE, "ladder"),
            method("Arb", GREEN, "Arb"),
            method("f64 intervals", BLACK, "f64 interval"),
            method("plain floats, by the paper's formulas", PINK, "f64, naive"),
        ],
    }
}

/// Generic inputs: the digits that are right.
fn of_digits(table: &[PanelRow]) -> Panel {
    let method = |name, ink, is: &dyn Fn(&str) -> bool| {
        let of = table.iter().filter(|row| row.text("family") == "generic" && is(row.text("method")));
        let mark = |row: &PanelRow| {
            Some(Mark { accuracy: row.number("digits")?, time: row.times()[0], wrong: false })
        };
        Method { name, ink, marks: sorted(of.filter_map(mark)) }
    };
    let marks = (1..=3).map(|e: i32| (f64::from(e), 10u32.pow(e as u32).to_string().as_str().into()));
    Panel {
        title: "The number b_{n,k}",
        across: Axis::marked("digits that are right", (0.9, 3.3), true, marks.collect()),
        methods: vec![
            method("balls here", BLUE, &|name| name.ends_with(" bits") && !name.starts_with("Arb")),
            method("Arb", GREEN, &|name| name.starts_with("Arb")),
            method("f64 interval", BLACK, &|name| name == "f64 interval"),
            method("plain floats: nothing promised", PINK, &|name| name == "f64, naive"),
        ],
    }
}

/// The nearly grazing motion, after ten periods.
fn of_a_motion(table: &[PanelRow]) -> Panel {
    let method = |name, ink, method: &str| {
        let of =
            table.iter().filter(|row| row.text("motion") == "near grazing" && row.text("method") == method);
        let mark = |row: &PanelRow| {
            let accuracy = -row.number("error")?.max(1e-16).log10();
            Some(Mark { accuracy, time: row.times()[0], wrong: row.number("missed") != Some(0.0) })
        };
        Method { name, ink, marks: sorted(of.filter_map(mark)) }
    };
    let marks = [0, 3, 6, 9, 12].map(|e| (f64::from(e), power(-e)));
    Panel {
        title: "Motion that nearly grazes its stop, ten impacts",
        across: Axis::marked("error of the state after ten periods", (-0.4, 13.9), false, marks.to_vec()),
        methods: vec![
            method("SciPy DOP853", GREEN, "SciPy DOP853"),
            method("loop in C, RK4", ORANGE, "C, RK4"),
            method("this integrator", BLUE, "integrator"),
            method("closed form", BLACK, "closed form"),
        ],
    }
}

fn sorted(marks: impl Iterator<Item = Mark>) -> Vec<Mark> {
    let mut marks: Vec<Mark> = marks.collect();
    marks.sort_by(|a, b| a.accuracy.total_cmp(&b.accuracy));
    marks
}

fn draw_panel(canvas: &mut Canvas, panel: Panel, top: f64) {
    let times = panel.methods.iter().flat_map(|method| &method.marks).map(|mark| mark.time.log10());
    let (low, high) = times.fold((9.0f64, 1.0f64), |(low, high), t| (low.min(t), high.max(t)));
    let (low, high) = (low - 0.8, high + 0.6);
    let inside = low.ceil() as i32..=high.floor() as i32;
    let step = if inside.clone().count() > 5 { 2 } else { 1 };
    let marks = inside.step_by(step).map(|e| (f64::from(e), Words::plain(&duration(e)))).collect();
    let frame = PlotFrame::new(
        [4.0, top + 11.0, WIDTH - 4.0, top + HIGH - 4.0],
        panel.across,
        Axis::marked("time", (low, high), true, marks),
    );
    // All panels begin at one place.
    let frame = frame.with_left(46.0);
    canvas.text(panel.title, (frame.left, top + 6.0), Anchor::Start);
    let mut taken: Vec<[f64; 4]> = Vec::new();
    let at = |mark: &Mark| frame.at((mark.accuracy, mark.time));
    let paths: Vec<Vec<At>> =
        panel.methods.iter().map(|method| method.marks.iter().map(at).collect()).collect();
    for (method, path) in panel.methods.iter().zip(&paths) {
        canvas.line(path.clone(), line(method.ink, 0.9));
        for (mark, &place) in method.marks.iter().zip(path) {
            match mark.wrong {
                true => cross(canvas, place, method.ink),
                false => canvas.disc(place, POINT, method.ink),
            }
        }
    }
    for (method, path) in panel.methods.iter().zip(&paths) {
        let words = Words::plain(method.name);
        let place = beside(path, words.width(TYPE), &paths, &frame, &taken);
        taken.push(boxed(place, words.width(TYPE)));
        canvas.inked(words, place, Anchor::Middle, TYPE, method.ink);
    }
    frame.draw(canvas);
}

/// The box of a text about its middle.
fn boxed((x, y): At, width: f64) -> [f64; 4] {
    [x - width / 2.0, y - 0.5 * TYPE, x + width / 2.0, y + 0.5 * TYPE]
}

/// Where a line is named: nearest to its own marks where the name is inside the frame, on no line and on no
/// other name, as far as there is such a place.
fn beside(path: &[At], width: f64, paths: &[Vec<At>], frame: &PlotFrame, taken: &[[f64; 4]]) -> At {
    let [left, top, right, bottom] = frame.inside();
    let cost = |place: At, far: f64| {
        let [l, t, r, b] = boxed(place, width);
        let over =
            |of: &[f64; 4]| (r.min(of[2]) - l.max(of[0])).max(0.0) * (b.min(of[3]) - t.max(of[1])).max(0.0);
        let outside = [left + 2.0 - l, top + 2.0 - t, r - right + 2.0, b - bottom + 2.0];
        let crossed = paths
            .iter()
            .flat_map(|path| samples(path))
            .filter(|&(x, y)| (l - 2.0..=r + 2.0).contains(&x) && (t - POINT..=b + POINT).contains(&y));
        let names: f64 = taken.iter().map(over).sum();
        far + 30.0 * names
            + 40.0 * crossed.count() as f64
            + outside.iter().map(|out| 1e3 * out.max(0.0)).sum::<f64>()
    };
    let mut best = ((left + right) / 2.0, (top + bottom) / 2.0);
    let mut least = f64::INFINITY;
    for (i, &(x, y)) in path.iter().enumerate() {
        for across in [0.0, 0.5, -0.5f64] {
            for up in [-1.0, 1.0, -1.6, 1.6, -2.4, 2.4, 0.0] {
                let beside = if up == 0.0 { 4.0 * across.signum() } else { 0.0 };
                let place = (x + across * width + beside, y + up * TYPE);
                // The end of a line is the better place, and so is the nearer one.
                let far = 6.0 * f64::abs(up) + 2.0 * (path.len() - 1 - i) as f64;
                let cost = cost(place, far);
                if cost < least {
                    (best, least) = (place, cost);
                }
            }
        }
    }
    best
}

/// Points along a line, close together.
fn samples(path: &[At]) -> Vec<At> {
    let mut all = path.to_vec();
    for pair in path.windows(2) {
        let [(x, y), (to_x, to_y)] = [pair[0], pair[1]];
        let steps = ((to_x - x).hypot(to_y - y) / 2.0).ceil().max(1.0);
        all.extend(
            (1..steps as usize).map(|i| i as f64 / steps).map(|s| (x + s * (to_x - x), y + s * (to_y - y))),
        );
    }
    all
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn the_checked_in_picture_shows_the_checked_in_tables() {
        let folder = Path::new("../../docs");
        let [signs, digits, motions] = tables(folder).unwrap();
        let canvas = draw(&signs, &digits, &motions);
        if std::env::var_os("GRAZING_REDRAW").is_some() {
            glance_figure(folder).unwrap();
        }
        assert!(fs::read_to_string(folder.join("accuracy.svg")).unwrap() == canvas.svg());
    }

    /// Wrong answers are marked, and only these; a line ends where its method does.
    #[test]
    fn what_is_wrong_is_a_cross() {
        let [signs, _, motions] = tables(Path::new("../../docs")).unwrap();
        let of = |panel: &Panel, name: &str| -> Vec<bool> {
            let method = panel.methods.iter().find(|method| method.name == name).unwrap();
            method.marks.iter().map(|mark| mark.wrong).collect()
        };
        let panel = of_signs(&signs);
        assert!(of(&panel, "every command here").iter().all(|wrong| !wrong));
        let plain = of(&panel, "plain floats, by the paper's formulas");
        assert!(!plain[0] && *plain.last().unwrap(), "{plain:?}");
        assert!(of(&panel, "f64 intervals").len() < of(&panel, "Arb").len());
        let panel = of_a_motion(&motions);
        assert!(of(&panel, "SciPy DOP853").iter().all(|wrong| *wrong));
        assert_eq!(of(&panel, "closed form"), [false]);
    }
}
