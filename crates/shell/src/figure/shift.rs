//! The impacts of a shift that is proved, as velocities before and after: bands of letters, where their legs
//! take them, the boxes where both meet, and the impacts of an attractor among them.

use super::{
    FigurePlace,
    canvas::{Anchor, At, BLACK, BLUE, COLUMN, Canvas, Colour, GREEN, ORANGE, PINK, SKY, Words, line},
    frame::{Axis, PlotFrame},
    legend::Legend,
};
use crate::{
    error::{Error, Result},
    search::chaos::{Problem, ShiftProof},
};

/// Of letters, in turn.
const COLOURS: [Colour; 4] = [ORANGE, GREEN, PINK, SKY];
/// Steps along a strip.
const STEPS: usize = 200;

/// A strip: for each velocity after an impact, between which velocities before it lies.
type Strip = Vec<(f64, [f64; 2])>;

/// Draws the bands, boxes and strips of a proved shift at the
/// greatest depth of its problem, and the impacts of an attractor, pairs of velocities before and after. All
/// velocities are divided by ν; both axes are logarithmic, that of velocities before being −p. Impacts
/// far from all boxes are left out.
///
/// # Errors
/// An input error if a letter's velocities after are not positive or those before not negative; an I/O error.
pub fn shift(
    problem: &Problem,
    proof: &ShiftProof,
    impacts: &[(f64, f64)],
    place: &FigurePlace,
) -> Result<()> {
    let boxes = &proof.boxes;
    if boxes.iter().any(|[after, before]| after.lo <= 0.0 || before.hi >= 0.0) {
        return Err(Error::input("figure chaos: a velocity of the boxes may be 0, which has no logarithm"));
    }
    let ends = |axis: usize, around: [f64; 2]| {
        let spans = boxes.iter().map(|pair| pair[1 - axis]);
        let ends = spans.flat_map(|span| [span.lo.abs(), span.hi.abs()]);
        let [lo, hi] = ends.fold([f64::INFINITY, 0.0], |[lo, hi]: [f64; 2], x| [lo.min(x), hi.max(x)]);
        [lo / around[0], hi * around[1]]
    };
    // The impacts of an attractor have high speeds.
    let (before, after) = (ends(0, [2.0, 12.0]), ends(1, [1.5, 3.0]));
    let inside = |range: [f64; 2], x: f64| range[0] <= x && x <= range[1];
    let impacts: Vec<(f64, f64)> = impacts.iter().map(|(p, a)| (-p, *a)).collect();
    let impacts: Vec<(f64, f64)> =
        impacts.into_iter().filter(|(p, a)| inside(before, *p) && inside(after, *a)).collect();
    let heights: Vec<f64> =
        (0..=STEPS).map(|i| after[0] * (after[1] / after[0]).powf(i as f64 / STEPS as f64)).collect();
    let shown = |strip: Strip| -> Strip {
        strip.into_iter().filter(|(_, ends)| ends.iter().all(|p| inside(before, -p))).collect()
    };
    let strips: Vec<Strip> =
        (0..boxes.len()).map(|letter| shown(problem.arrivals(proof, letter, &heights))).collect();
    let mut rows: Vec<Vec<String>> = Vec::new();
    let mut row = |set: String, p: f64, a: f64| rows.push(vec![set, p.to_string(), a.to_string()]);
    for (letter, [after, before]) in problem.letters.iter().zip(boxes) {
        for (p, a) in [(before.lo, after.lo), (before.hi, after.hi)] {
            row(format!("corner of box {letter}"), p, a);
        }
    }
    for (letter, strip) in problem.letters.iter().zip(&strips) {
        for &(a, ends) in strip {
            ends.into_iter().for_each(|p| row(format!("edge of strip {letter}"), p, a));
        }
    }
    impacts.iter().for_each(|&(p, a)| row("attractor".into(), -p, a));
    let canvas = draw(&problem.letters, proof, &strips, &impacts, [before, after]);
    place.save(&canvas, &["set", "before", "after"], &rows)
}

fn draw(
    letters: &[u64],
    proof: &ShiftProof,
    strips: &[Strip],
    impacts: &[(f64, f64)],
    [before, after]: [[f64; 2]; 2],
) -> Canvas {
    let legend = legend(letters);
    let mut canvas = Canvas::new(
        COLUMN,
        204.0 + legend.height(COLUMN - 8.0),
        "A proved shift: bands of letters, and strips that cross them",
        "The velocity after an impact over the speed towards the wall before it, both logarithmic. Each strip, \
         where legs of one letter end, crosses every band, where legs of a letter begin; the boxes of the proof \
         are where they cross. An attractor's impacts lie near the last strip and beyond.",
    );
    let axis = |name: &str, [from, to]: [f64; 2]| {
        let exponents = from.log10().ceil() as i32..=to.log10().floor() as i32;
        let mark = |e: i32| (f64::from(e), Words::from(10f64.powi(e).to_string()));
        Axis::marked(name, (from.log10(), to.log10()), true, exponents.map(mark).collect())
    };
    let frame = PlotFrame::new(
        [2.0, 14.0, COLUMN - 14.0, 202.0],
        axis("−p before an impact", before),
        axis("a after it", after),
    );
    let corners = |p: [f64; 2], a: [f64; 2]| {
        let ((left, bottom), (right, top)) = (frame.at((p[0], a[0])), frame.at((p[1], a[1])));
        [left, top, right, bottom]
    };
    canvas.inside(frame.inside(), |canvas| {
        for (i, [own, _]) in proof.boxes.iter().enumerate() {
            canvas.rectangle(corners(before, [own.lo, own.hi]), COLOURS[i % 4].tint(0.35));
        }
        for (i, strip) in strips.iter().enumerate() {
            let edge = |side: usize| frame.path(strip.iter().map(|&(a, ends)| (-ends[side], a)));
            let (left, right) = (edge(0), edge(1));
            let outline = left.iter().chain(right.iter().rev()).copied().collect();
            canvas.polygon(outline, COLOURS[i % 4]);
            // Thin strips are still seen.
            canvas.lines(vec![left, right], line(COLOURS[i % 4], 1.1));
        }
        let pairs = proof.boxes.iter().flat_map(|own| proof.boxes.iter().map(move |last| (own, last)));
        for ([own, _], [_, last]) in pairs {
            canvas.rectangle(corners([-last.hi, -last.lo], [own.lo, own.hi]), line(BLACK, 0.7));
        }
        canvas.discs(frame.path(impacts.iter().copied()), 0.6, BLUE);
    });
    frame.draw(&mut canvas);
    for (letter, [own, last]) in letters.iter().zip(&proof.boxes) {
        let (_, y) = frame.at((before[0], (own.lo * own.hi).sqrt()));
        canvas.text(format!("A_{{{letter}}}"), (frame.right + 3.0, y), Anchor::Start);
        let (x, _) = frame.at(((last.lo * last.hi).sqrt(), after[0]));
        canvas.text(format!("P_{{{letter}}}"), (x, frame.top - 7.0), Anchor::Middle);
    }
    legend.draw(&mut canvas, (4.0, 203.0), COLUMN - 8.0);
    canvas
}

/// An entry for each colour, one for the boxes, one for the dots.
fn legend<'a>(letters: &[u64]) -> Legend<'a> {
    let mut legend = Legend::default();
    for (i, letter) in letters.iter().enumerate() {
        let periods = if *letter == 1 { "1 period".into() } else { format!("{letter} periods") };
        let name = Words::plain(&format!("a leg of {periods} begins (band), ends (strip)"));
        legend.add(name, move |canvas: &mut Canvas, (x, y): At| {
            canvas.rectangle([x - 9.0, y - 3.0, x + 1.0, y + 3.0], COLOURS[i % 4].tint(0.35));
            canvas.rectangle([x + 5.0, y - 3.5, x + 7.0, y + 3.5], COLOURS[i % 4]);
        });
    }
    legend.add(Words::plain("boxes of the proof"), |canvas: &mut Canvas, (x, y): At| {
        canvas.rectangle([x - 4.0, y - 3.0, x + 4.0, y + 3.0], line(BLACK, 0.7));
    });
    legend.add(Words::plain("impacts of the attractor"), |canvas: &mut Canvas, (x, y): At| {
        canvas.discs((-3..=3).map(|i| (x + 2.0 * f64::from(i), y)).collect(), 0.6, BLUE);
    });
    legend
}
