//! Windows with a stable orbit and gaps that are proved chaotic, over the parameter: above them the impacts
//! that motions come to.

use super::{
    FigurePlace,
    canvas::{Anchor, At, BLACK, BLUE, Canvas, Colour, GREY, ORANGE, Words, line},
    frame::{Axis, PlotFrame},
    legend::Legend,
    panels::WIDTH,
};
use crate::{
    error::Result,
    study::{Hit, Proved, Stretch},
};

/// The height of the strip under the impacts, and its place, in |V|/√ν.
const STRIP: [f64; 2] = [-0.13, -0.03];
/// What is behind the impacts is so light.
const LIGHT: f64 = 0.22;

fn ink(what: Proved) -> Colour {
    match what {
        Proved::Stable(_) => BLUE,
        Proved::Chaos(_) => ORANGE,
        Proved::Open => GREY,
    }
}

/// Draws what is proved between the least and the greatest µ, and impacts.
///
/// # Errors
/// An I/O error.
pub fn gaps(eigenvalue: f64, stretches: &[Stretch], hits: &[Hit], place: &FigurePlace) -> Result<()> {
    let row = |set: &str, [from, to]: [f64; 2], value: String| {
        vec![set.to_string(), from.to_string(), to.to_string(), value]
    };
    let mut rows = Vec::new();
    for Stretch { between, what } in stretches {
        rows.push(match what {
            Proved::Stable(periods) => row("stable", *between, periods.to_string()),
            Proved::Chaos(growth) => row("chaos", *between, growth.to_string()),
            Proved::Open => row("open", *between, String::new()),
        });
    }
    let digits = |x: f64| (x * 1e9).round() / 1e9;
    rows.extend(hits.iter().map(|[mu, speed]| row("impact", [digits(*mu); 2], speed.to_string())));
    place.save(&draw(eigenvalue, stretches, hits), &["set", "from", "to", "value"], &rows)
}

fn draw(eigenvalue: f64, stretches: &[Stretch], hits: &[Hit]) -> Canvas {
    let mut legend = Legend::default();
    for (what, name) in [
        (Proved::Stable(0), "an orbit of one impact in n periods is proved stable"),
        (Proved::Chaos(0.0), "proved: trapped, and no periodic motion is stable"),
        (Proved::Open, "neither is proved"),
    ] {
        legend.add(Words::plain(name), move |canvas: &mut Canvas, (x, y): At| {
            canvas.rectangle([x - 8.0, y - 3.5, x + 8.0, y + 3.5], ink(what));
        });
    }
    legend.add(Words::plain("impacts that are seen"), |canvas: &mut Canvas, (x, y): At| {
        canvas.discs((-2..=2).map(|i| (x + 2.0 * f64::from(i), y)).collect(), 0.8, BLACK);
    });
    let share = eigenvalue * eigenvalue;
    let mut canvas = Canvas::new(
        WIDTH,
        204.0 + legend.height(WIDTH - 8.0),
        "Windows and gaps beyond a touch",
        "The speeds of impacts, divided by the root of the depth, over the parameter on a logarithmic scale. \
         Windows with a stable orbit of n periods and gaps with chaos take turns, each as much smaller than the \
         one before as the square of an eigenvalue says. A strip below says what is proved of which values.",
    );
    let ends = stretches.iter().flat_map(|stretch| stretch.between);
    let (least, greatest) = ends.fold((f64::INFINITY, 0.0f64), |(lo, hi), end| (lo.min(end), hi.max(end)));
    let top = hits.iter().map(|hit| hit[1]).fold(0.8, f64::max);
    let (low, high) = (STRIP[0] - 0.03, 1.32 * top);
    let marks = |power: i32| [1, 2, 5].map(|digit| f64::from(digit) * 10f64.powi(power));
    let marks = (-8..0).flat_map(marks).filter(|mark| (least..=greatest).contains(mark));
    let heights = (0..=4).map(|i| 0.2 * f64::from(i));
    let frame = PlotFrame::new(
        [2.0, 4.0, WIDTH - 4.0, 202.0],
        Axis::marked(
            "µ",
            (least.log10(), greatest.log10()),
            true,
            marks.map(|mark| (mark.log10(), Words::plain(&format!("{mark}")))).collect(),
        ),
        Axis::marked(
            "|V|/√ν of impacts",
            (low, high),
            false,
            heights.map(|height| (height, Words::plain(&format!("{height:.1}")))).collect(),
        ),
    );
    let box_of = |[from, to]: [f64; 2], [low, high]: [f64; 2]| {
        let ((left, bottom), (right, top)) = (frame.at((from, low)), frame.at((to, high)));
        [left, top, right, bottom]
    };
    canvas.inside(frame.inside(), |canvas| {
        // What is of one colour is one shape, so that nothing shines through.
        for same in stretches.chunk_by(|one, other| ink(one.what) == ink(other.what)) {
            let (first, last) = (&same[0], &same[same.len() - 1]);
            let between = [last.between[0], first.between[1]];
            canvas.rectangle(box_of(between, [low, high]), ink(first.what).tint(LIGHT));
            canvas.rectangle(box_of(between, STRIP), ink(first.what));
        }
        canvas.discs(frame.path(hits.iter().map(|[mu, speed]| (*mu, *speed))), 0.3, BLACK);
    });
    let windows = stretches.iter().filter_map(|stretch| match stretch.what {
        Proved::Stable(periods) => Some((periods, stretch.between)),
        _ => None,
    });
    let windows: Vec<_> = windows.collect();
    for (i, (periods, [from, to])) in windows.iter().enumerate() {
        let name = if i == 0 { format!("n = {periods}") } else { periods.to_string() };
        canvas.text(Words::plain(&name), frame.at(((from * to).sqrt(), 1.26 * top)), Anchor::Middle);
    }
    // From the end of a window to that of the next.
    if let [.., (_, [_, before]), (_, [_, after])] = windows[..] {
        let [left, right] = [after, before].map(|mu| frame.at((mu, 1.07 * top)));
        canvas.lines(vec![vec![left, right]], line(BLACK, 0.5));
        let (x, y) = ((left.0 + right.0) / 2.0, left.1);
        for (end, side) in [(left, 3.0), (right, -3.0)] {
            canvas.line(vec![(end.0 + side, y - 2.0), end, (end.0 + side, y + 2.0)], line(BLACK, 0.5));
        }
        canvas.text(format!("λ_{{1}}^{{2}} = {share:.3}"), (x, y - 8.0), Anchor::Middle);
    }
    frame.draw(&mut canvas);
    legend.draw(&mut canvas, (4.0, 203.0), WIDTH - 8.0);
    canvas
}
