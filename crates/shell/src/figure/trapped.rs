//! The impacts of a motion beyond a touch, each with the speed of the next: the trap that is proved, and how
//! steep the branches are.

use super::{
    FigurePlace,
    canvas::{Anchor, At, BLACK, BLUE, COLUMN, Canvas, Colour, GREEN, GREY, ORANGE, PINK, Words, line},
    frame::{Axis, PlotFrame},
    legend::Legend,
};
use crate::{error::Result, search::attractor::AttractorProof};

/// Of the periods until the next impact, in turn.
const COLOURS: [Colour; 4] = [ORANGE, GREEN, PINK, BLUE];

/// An impact's speed, that of the next, and how many periods are between: speeds relative to the stop,
/// divided by √ν.
pub type Return = ([f64; 2], u64);

/// Draws what is proved of a trap, and returns of a motion in it.
///
/// # Errors
/// An I/O error.
pub fn trapped(proof: &AttractorProof, returns: &[Return], place: &FigurePlace) -> Result<()> {
    let speed: f64 = proof.certificate.setting.speed.to_string().parse().unwrap_or(f64::NAN);
    let mut rows = vec![vec!["trap".into(), speed.to_string(), speed.to_string(), String::new()]];
    for ([before, after], periods) in returns {
        rows.push(vec!["impact".into(), before.to_string(), after.to_string(), periods.to_string()]);
    }
    place.save(&draw(speed, proof.growth, returns), &["set", "speed", "next", "periods"], &rows)
}

fn draw(speed: f64, growth: f64, returns: &[Return]) -> Canvas {
    let periods = |n: usize| {
        let least = returns.iter().map(|(_, n)| *n).min().unwrap_or(1);
        least + n as u64
    };
    let mut legend = Legend::default();
    for (i, colour) in COLOURS.into_iter().enumerate() {
        let rest = if i + 1 == COLOURS.len() { ", and so on" } else { "" };
        let name = Words::plain(&format!("the next after {} periods{rest}", periods(i)));
        legend.add(name, move |canvas: &mut Canvas, (x, y): At| {
            canvas.discs((-2..=2).map(|i| (x + 2.0 * f64::from(i), y)).collect(), 0.8, colour);
        });
    }
    legend.add(Words::plain("the trap that is proved"), |canvas: &mut Canvas, (x, y): At| {
        canvas.rectangle([x - 4.0, y - 3.0, x + 4.0, y + 3.0], line(BLACK, 0.7));
    });
    let mut canvas = Canvas::new(
        COLUMN,
        224.0 + legend.height(COLUMN - 8.0),
        "Impacts beyond a touch: each with the next",
        "The speed of an impact over that of the next, divided by the root of the depth. All lie in a square, \
         the trap. Each number of periods between has a branch, and all are steep: chaos that attracts.",
    );
    let range = (0.0, 1.08 * speed);
    let frame = PlotFrame::new(
        [2.0, 14.0, COLUMN - 14.0, 222.0],
        Axis::linear("|V|/√ν of an impact", range, 6),
        Axis::linear("of the next", range, 6),
    );
    canvas.inside(frame.inside(), |canvas| {
        let ((left, bottom), (right, top)) = (frame.at((0.0, 0.0)), frame.at((speed, speed)));
        canvas.line(vec![(left, bottom), (right, top)], line(GREY, 0.5));
        for (i, colour) in COLOURS.into_iter().enumerate() {
            let own = returns.iter().filter(|(_, n)| (n - periods(0)) as usize % COLOURS.len() == i);
            canvas.discs(frame.path(own.map(|(speeds, _)| (speeds[0], speeds[1]))), 0.7, colour);
        }
        canvas.rectangle([left, top, right, bottom], line(BLACK, 0.7));
    });
    frame.draw(&mut canvas);
    canvas.text(format!("E = {growth}"), frame.at((0.98 * speed, 0.03 * speed)), Anchor::End);
    legend.draw(&mut canvas, (4.0, 223.0), COLUMN - 8.0);
    canvas
}
