//! README's picture: what is born and what is seen beyond the touch and before it, over what an engineer
//! knows of a machine.
//!
//! The cells are those of `words`, in other coordinates: across is s where γ > 0 and 1 − s where γ < 0, which
//! of a machine with one stop and constant coefficients is the frequency of its free vibration over that of
//! the drive, without its whole part; up is r. No such machine has real eigenvalues below 0.

use super::{
    FigurePlace,
    canvas::{Anchor, At, BLACK, COLUMN, Canvas, GREY, Paint, RED, WHITE, Words, line},
    frame::{Axis, PlotFrame},
    words::{Cell, cells, shade},
};
use crate::{
    error::Result,
    existence::Case,
    monitor::Monitor,
    study::{RESTITUTION, TouchSample},
};

/// The machine of README: q″ + q′/10 + 3q/10 = F cos t.
const MACHINE: (f64, f64) = (0.545_435_605_731_786, 0.730_402_691_048_646);

/// The width of the picture, the height of a panel, and what is above the first.
const WIDTH: f64 = 1.5 * COLUMN;
const PANEL: f64 = 159.0;
const HEAD: f64 = 83.0;
/// What stands above the frame of a panel.
const TITLE: f64 = 35.0;
const SMALL: f64 = 7.0;

/// Writes the picture and its data: the words of at most the areas of period ≤ `last`, and what is seen of
/// some machines.
///
/// # Errors
/// Those of `words`; an I/O error; the monitor's interruption.
pub fn touch(last: u64, samples: &[TouchSample], place: &FigurePlace, monitor: &dyn Monitor) -> Result<()> {
    let cells = cells(last, monitor)?;
    let born = cells.iter().map(|cell| {
        let periods: Vec<String> = cell.periods.iter().map(u64::to_string).collect();
        let entropy = cell.entropy.map_or(String::new(), |rate| format!("{rate:.10}"));
        let gamma = cell.case.sign_gamma().to_string();
        let mut row = vec![panel_of(cell.case).to_string(), "born".to_string(), gamma, cell.letters.clone()];
        row.extend([periods.join(" "), entropy]);
        row.resize(COLUMNS.len(), String::new());
        row
    });
    let of = |sample: &TouchSample| {
        [("before", &sample.before), ("beyond", &sample.beyond)].map(|(panel, sight)| {
            let mut row = vec![panel.to_string(), "seen".to_string()];
            row.resize(6, String::new());
            row.extend([sample.ratio, sample.remains].map(|x| format!("{x:.2}")));
            row.extend([sight.what.clone(), sight.motion.clone().unwrap_or_default()]);
            row.extend(
                [0, 1].map(|i| sight.extent.map_or(String::new(), |extent| format!("{:.4}", extent[i]))),
            );
            let parts = [Some(sample.free), sample.from_rest].map(|part| part.filter(|_| panel == "before"));
            row.extend(parts.map(|part| part.map_or(String::new(), |part| format!("{part:.4}"))));
            row
        })
    };
    let seen = samples.iter().flat_map(of);
    place.save(&draw(&cells, samples), &COLUMNS, &born.chain(seen).collect::<Vec<_>>())
}

/// The columns of the data: of what is born the cells, of what is seen the machines.
const COLUMNS: [&str; 14] = [
    "panel",
    "set",
    "sign_gamma",
    "word",
    "periods",
    "entropy",
    "across",
    "up",
    "what",
    "motion",
    "least",
    "greatest",
    "free_below",
    "hits_from_rest",
];

/// In which panel a case is: e opens the gap of the motion that grazes.
fn panel_of(case: Case) -> &'static str {
    if case.sign_emu() > 0 { "before" } else { "beyond" }
}

fn draw(cells: &[Cell], samples: &[TouchSample]) -> Canvas {
    let mut canvas = Canvas::new(
        WIDTH,
        HEAD + 2.0 * PANEL + 4.0,
        "What a vibrating machine does when it first touches its stop",
        "Two panels, beyond the touch and before it, over the frequency of the machine's free vibration in units of the \
         drive's, without its whole part, and what damping leaves of a vibration in one period of the drive. White: \
         nothing is born; grey: motions, but no chaos; yellow to dark blue: chaos. Before the touch the free motion is \
         seen of a drive that is turned up slowly; labels say below which part of the touch no motion was found that \
         hits, and bars where it depends on how it is begun. Beyond it every motion hits; labels say how many times as \
         wide it swings.",
    );
    path(&mut canvas);
    key(&mut canvas, 44.0);
    let beyond = [
        "Beyond the touch",
        "Seen: the motion jumps, to a swing so many times as wide (labels); at ×1.0 it stays near.",
        "However it is begun, it always hits: the free motion is gone.",
    ];
    let before = [
        "Before the touch",
        "Seen, the drive turned up slowly: the free motion. What is born here (colours) is unstable.",
        "Begun otherwise it may hit, from these parts of the touch on (labels); below, none was found that does.",
    ];
    for (panel, titles, top) in [("beyond", beyond, HEAD), ("before", before, HEAD + PANEL)] {
        let frame = frame(top);
        cells_of(&mut canvas, &frame, cells, panel);
        titles_of(&mut canvas, titles, top);
        let tag = if panel == "beyond" { swing } else { bands };
        samples.iter().for_each(|sample| tag(&mut canvas, &frame, sample));
        own(&mut canvas, &frame);
    }
    canvas
}

/// Formulas and words in turn, the formulas first.
fn mixed(parts: &[&str]) -> Words {
    let words = |(i, part): (usize, &&str)| if i % 2 == 0 { Words::from(*part) } else { Words::plain(part) };
    Words(parts.iter().enumerate().flat_map(|(i, part)| words((i, part)).0).collect())
}

/// From the machine to its point.
fn path(canvas: &mut Canvas) {
    let lines = [
        mixed(&[
            "",
            "Your machine:  ",
            "m q″ + c q′ + k q = F cos Ω t",
            ",  and one stop. Its point in both panels is",
        ]),
        mixed(&[
            "",
            "across:  ",
            "√(k/m − (c/2m)²) / Ω",
            ",  less its whole part: the frequency of its free vibration over the drive's",
        ]),
        mixed(&[
            "",
            "up:  ",
            "exp(−π c/(m Ω))",
            ":  what damping leaves of a free vibration in one period of the drive",
        ]),
    ];
    for (text, y) in lines.into_iter().zip([8.0, 20.0, 31.0]) {
        canvas.sized(text, (4.0, y), Anchor::Start, if y < 10.0 { 8.0 } else { SMALL });
    }
}

/// What the colours mean.
fn key(canvas: &mut Canvas, top: f64) {
    let (outline, middle) = (line(BLACK, 0.4), top + 4.0);
    let mut x = 4.0;
    for (name, entropy, room) in [("nothing is born", None, 72.0), ("motions, no chaos", Some(0.0), 80.0)] {
        canvas.rectangle([x, top, x + 12.0, top + 8.0], shade(entropy));
        canvas.rectangle([x, top, x + 12.0, top + 8.0], outline);
        canvas.sized(Words::plain(name), (x + 15.0, middle), Anchor::Start, SMALL);
        x += room;
    }
    let (left, right) = (x, x + 60.0);
    for i in 0..64 {
        let share = f64::from(i) / 64.0;
        let ink = shade(Some((share * std::f64::consts::LN_2).max(1e-9)));
        canvas.rectangle([left + share * (right - left), top, right, top + 8.0], ink);
    }
    canvas.rectangle([left, top, right, top + 8.0], outline);
    canvas.sized(
        Words::plain("chaos is born, the darker, the richer"),
        (right + 3.0, middle),
        Anchor::Start,
        SMALL,
    );
    cross(canvas, (10.0, top + 16.0));
    canvas.sized(Words::plain("README's machine"), (19.0, top + 16.0), Anchor::Start, SMALL);
    canvas.rectangle([88.0, top + 11.5, 109.0, top + 20.5], line(GREY, 0.4));
    canvas.sized("×2.5", (98.5, top + 16.0), Anchor::Middle, SMALL);
    let how =
        format!("swing just beyond the touch over that before it; simulated, restitution {RESTITUTION}");
    canvas.sized(Words::plain(&how), (113.0, top + 16.0), Anchor::Start, SMALL);
    let mut x = 88.0;
    canvas.rectangle([x, top + 24.0, x + 21.0, top + 27.0], line(GREY, 0.4));
    canvas.rectangle([x + 15.0, top + 24.0, x + 21.0, top + 27.0], GREY);
    canvas.rectangle([x + 18.0, top + 24.0, x + 21.0, top + 27.0], RED);
    x += 25.0;
    let bar = "drive from 0 to the touch; grey: it depends on the start; red: from rest it hits";
    canvas.sized(Words::plain(bar), (x, top + 25.5), Anchor::Start, SMALL);
}

fn frame(top: f64) -> PlotFrame {
    PlotFrame::new(
        [2.0, top + TITLE, WIDTH - 4.0, top + PANEL],
        Axis::linear(Words::plain("frequency ratio, less its whole part"), (0.0, 1.0), 10),
        Axis::linear(Words::plain("left after a period"), (0.0, 1.0), 5),
    )
}

fn cells_of(canvas: &mut Canvas, frame: &PlotFrame, cells: &[Cell], panel: &str) {
    canvas.inside(frame.inside(), |canvas| {
        for cell in cells.iter().filter(|cell| panel_of(cell.case) == panel) {
            let across = |s: f64| if cell.case.sign_gamma() > 0 { s } else { 1.0 - s };
            let ink = shade(cell.entropy);
            let paint = Paint { fill: Some(ink), stroke: Some(line(ink, 0.12)) };
            canvas.polygon(frame.path(cell.polar().map(|(s, r)| (across(s), r))), paint);
        }
        canvas.line(frame.path([(0.5, 0.0), (0.5, 1.0)]), line(GREY, 0.6));
    });
    frame.draw(canvas);
}

fn titles_of(canvas: &mut Canvas, [title, seen, begun]: [&str; 3], top: f64) {
    canvas.sized(Words::plain(title), (4.0, top + 9.0), Anchor::Start, 11.0);
    canvas.sized(Words::plain(seen), (4.0, top + 21.0), Anchor::Start, SMALL);
    canvas.sized(Words::plain(begun), (4.0, top + 30.0), Anchor::Start, SMALL);
}

/// Below which part of its touch no motion of a machine was found that hits; below it a bar from no drive to
/// the touch, dark where it depends on how the machine is begun, red from where on it hits begun at rest.
fn bands(canvas: &mut Canvas, frame: &PlotFrame, sample: &TouchSample) {
    let (x, y) = frame.at((sample.ratio, sample.remains));
    let [left, top, right, bottom] = [x - 10.5, y - 6.0, x + 10.5, y + 6.0];
    canvas.rectangle([left, top, right, bottom], WHITE);
    canvas.sized(format!("{:.2}", sample.free), (x, y - 1.7), Anchor::Middle, SMALL);
    let mut bar = |from: f64, ink| {
        canvas.rectangle([left + from * (right - left), bottom - 3.0, right, bottom], ink);
    };
    bar(sample.free, GREY);
    if let Some(rest) = sample.from_rest {
        bar(rest, RED);
    }
    canvas.rectangle([left, top, right, bottom], line(GREY, 0.4));
}

/// How wide a machine swings beyond its touch, in swings before it.
fn swing(canvas: &mut Canvas, frame: &PlotFrame, sample: &TouchSample) {
    let words = match sample.beyond.extent {
        Some([low, high]) => format!("×{:.1}", (high - low) / 2.0),
        None => "lost".to_string(),
    };
    let (x, y) = frame.at((sample.ratio, sample.remains));
    canvas.rectangle([x - 10.5, y - 4.5, x + 10.5, y + 4.5], WHITE);
    canvas.rectangle([x - 10.5, y - 4.5, x + 10.5, y + 4.5], line(GREY, 0.4));
    canvas.sized(words, (x, y), Anchor::Middle, SMALL);
}

/// README's machine.
fn own(canvas: &mut Canvas, frame: &PlotFrame) {
    cross(canvas, frame.at(MACHINE));
}

fn cross(canvas: &mut Canvas, (x, y): At) {
    canvas.disc((x, y), 5.0, WHITE);
    canvas.disc((x, y), 5.0, line(BLACK, 0.4));
    let d = 2.6;
    let strokes = vec![vec![(x - d, y - d), (x + d, y + d)], vec![(x - d, y + d), (x + d, y - d)]];
    canvas.lines(strokes, line(RED, 1.4));
}
