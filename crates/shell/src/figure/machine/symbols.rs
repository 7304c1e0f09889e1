//! The symbols, each from one place to another on a level.

use super::{
    super::canvas::{At, BLACK, Canvas, Colour, GREEN, GREY, ORANGE, PINK, RED, Stroke, WHITE, line},
    plan::Mark,
};

/// The width of lines.
pub(super) const PEN: f64 = 0.8;
/// How long a coil and a pot are at most.
const BODY: f64 = 34.0;
/// Half of the gap of a stop as it is drawn: not to scale.
const GAP: f64 = 4.0;

/// The left and the right end, and the level.
#[derive(Clone, Copy)]
pub(super) struct Level {
    pub left: f64,
    pub right: f64,
    pub y: f64,
}

impl Level {
    fn middle(self) -> f64 {
        (self.left + self.right) / 2.0
    }

    fn moved(self, down: f64) -> Level {
        Level { y: self.y + down, ..self }
    }

    /// A body in the middle and the lines that lead to it.
    fn with_body(self, canvas: &mut Canvas, longest: f64, stroke: Stroke) -> [f64; 2] {
        let half = (0.35 * (self.right - self.left)).min(longest / 2.0);
        let [from, to] = [self.middle() - half, self.middle() + half];
        canvas.lines(vec![self.part(self.left, from), self.part(to, self.right)], stroke);
        [from, to]
    }

    fn part(self, from: f64, to: f64) -> Vec<At> {
        vec![(from, self.y), (to, self.y)]
    }
}

/// A wall or floor: its line, and hatches to the right of it on its way.
pub(super) fn hatched(canvas: &mut Canvas, from: At, to: At) {
    let stroke = line(BLACK, PEN);
    canvas.line(vec![from, to], line(BLACK, 1.2));
    let length = (to.0 - from.0).hypot(to.1 - from.1);
    let (x, y) = ((to.0 - from.0) / length, (to.1 - from.1) / length);
    let count = (length / 3.0).floor().max(1.0) as usize;
    let hatch = |i: usize| {
        let at = (i as f64 + 0.8) * length / count as f64;
        let (px, py) = (from.0 + x * at, from.1 + y * at);
        vec![(px, py), (px - 3.0 * y - 2.0 * x, py + 3.0 * x - 2.0 * y)]
    };
    canvas.lines((0..count).map(hatch).collect(), stroke);
}

/// An arrow along a level: to the right for 1, to the left for −1, both for 0.
pub(super) fn arrow(canvas: &mut Canvas, level: Level, way: i8, ink: Colour) {
    let stroke = line(ink, PEN);
    canvas.line(level.part(level.left, level.right), stroke);
    let head = |tip: f64, back: f64| vec![(tip, level.y), (back, level.y - 1.8), (back, level.y + 1.8)];
    if way >= 0 {
        canvas.polygon(head(level.right, level.right - 3.6), ink);
    }
    if way <= 0 {
        canvas.polygon(head(level.left, level.left + 3.6), ink);
    }
}

fn spring(canvas: &mut Canvas, level: Level, half: f64, stroke: Stroke) {
    let [from, to] = level.with_body(canvas, BODY, stroke);
    let step = (to - from) / 12.0;
    let mut path = vec![(from, level.y)];
    path.extend((0..6).map(|i| {
        let side = if i % 2 == 0 { -half } else { half };
        (from + (2 * i + 1) as f64 * step, level.y + side)
    }));
    path.push((to, level.y));
    canvas.line(path, stroke);
}

fn damper(canvas: &mut Canvas, level: Level, half: f64, stroke: Stroke) {
    let [from, to] = level.with_body(canvas, 16.0, stroke);
    let (y, middle) = (level.y, (from + to) / 2.0);
    canvas.lines(
        vec![
            vec![(to, y - half), (from, y - half), (from, y + half), (to, y + half)],
            vec![(middle, y - half + 1.0), (middle, y + half - 1.0)],
            vec![(middle, y), (to, y)],
        ],
        stroke,
    );
}

/// A rod, or what gives way, from one end to the other.
fn rod(canvas: &mut Canvas, level: Level, soft: bool, damped: bool) {
    let stroke = line(BLACK, PEN);
    match (soft, damped) {
        (false, _) => canvas.line(level.part(level.left, level.right), line(BLACK, 1.4)),
        (true, false) => spring(canvas, level, 2.4, stroke),
        (true, true) => {
            spring(canvas, level.moved(-2.4), 1.8, stroke);
            damper(canvas, level.moved(2.6), 1.8, stroke);
        }
    }
}

fn plate(canvas: &mut Canvas, x: f64, y: f64) {
    canvas.line(vec![(x, y - 4.5), (x, y + 4.5)], line(BLACK, 1.6));
}

/// Two plates with a gap, the left one on what stands at the left.
fn stop(canvas: &mut Canvas, level: Level, soft: bool, damped: bool, soft_left: bool) {
    let middle = level.middle();
    let [left, right] = [Level { right: middle - GAP, ..level }, Level { left: middle + GAP, ..level }];
    rod(canvas, left, soft && soft_left, damped);
    rod(canvas, right, soft && !soft_left, damped);
    plate(canvas, middle - GAP, level.y);
    plate(canvas, middle + GAP, level.y);
}

/// The symbol of a mark; `ground_left` says where the ground is, if it is at an end.
pub(super) fn draw(canvas: &mut Canvas, mark: Mark, level: Level, wrong: bool, ground_left: Option<bool>) {
    let ink = if wrong { RED } else { BLACK };
    let stroke = line(ink, if wrong { 1.4 } else { PEN });
    match mark {
        Mark::Spring => spring(canvas, level, 3.2, stroke),
        Mark::Damper => damper(canvas, level, 3.0, stroke),
        Mark::Formula => {
            spring(canvas, level, 3.2, line(GREEN, PEN));
            let (x, y) = (level.middle(), level.y);
            canvas.line(vec![(x - 7.0, y + 5.0), (x + 7.0, y - 5.0)], line(GREEN, PEN));
            canvas.polygon(vec![(x + 8.5, y - 6.0), (x + 4.2, y - 5.2), (x + 6.6, y - 2.2)], GREEN);
        }
        Mark::Inertia => {
            let dashed = Stroke { dashes: Some([3.0, 2.0]), ..line(ORANGE, 1.2) };
            canvas.line(level.part(level.left, level.right), dashed);
            canvas.disc((level.middle(), level.y), 2.6, ORANGE);
        }
        Mark::Skew => {
            let middle = level.middle();
            arrow(canvas, Level { left: middle, ..level }.moved(-1.8), 1, RED);
            arrow(canvas, Level { right: middle, ..level }.moved(1.8), -1, RED);
        }
        Mark::Modes => {
            let dashed = Stroke { dashes: Some([2.0, 2.0]), ..line(GREY, PEN) };
            canvas.line(level.part(level.left, level.right), dashed);
        }
        Mark::Stop { soft, damped, moving } => {
            stop(canvas, level, soft, damped, ground_left.unwrap_or(true));
            if moving {
                let middle = level.middle() + if ground_left == Some(true) { -GAP } else { GAP };
                arrow(canvas, Level { left: middle - 7.0, right: middle + 7.0, y: level.y + 7.0 }, 0, BLACK);
            }
        }
        Mark::Strap { soft, damped } => {
            // Each end is a hook about the other's plate.
            let middle = level.middle();
            let left = Level { right: middle + GAP, ..level }.moved(-2.5);
            let right = Level { left: middle - GAP, ..level }.moved(2.5);
            rod(canvas, left, soft, damped);
            rod(canvas, right, false, false);
            plate(canvas, middle + GAP, level.y);
            plate(canvas, middle - GAP, level.y);
        }
        Mark::Lever { soft } => {
            let dashed = Stroke { dashes: Some([4.0, 1.5]), ..line(PINK, 1.2) };
            canvas.line(level.part(level.left, level.right), dashed);
            let x = level.middle();
            let fill = if soft { WHITE } else { PINK };
            let corners = vec![(x, level.y - 4.0), (x - 4.0, level.y + 3.0), (x + 4.0, level.y + 3.0)];
            canvas.polygon(corners.clone(), fill);
            canvas.polygon(corners, line(PINK, PEN));
        }
        Mark::Rub => {
            let [from, to] = level.with_body(canvas, 22.0, stroke);
            canvas.line(vec![(from, level.y - 1.4), (to, level.y - 1.4)], line(BLACK, 1.4));
            rough(canvas, Level { left: from, right: to, y: level.y + 1.4 });
        }
    }
}

/// A rough surface.
pub(super) fn rough(canvas: &mut Canvas, level: Level) {
    let count = ((level.right - level.left) / 2.5).round().max(2.0) as usize;
    let step = (level.right - level.left) / count as f64;
    let at = |i: usize| (level.left + i as f64 * step, level.y + if i.is_multiple_of(2) { 0.0 } else { 1.6 });
    canvas.line((0..=count).map(at).collect(), line(BLACK, PEN));
}
