//! Texts beside points of a picture, with lines to those that they stand apart from.

use std::f64::consts::TAU;

use super::canvas::{Anchor, At, Canvas, GREY, TYPE, Words, line};

/// The size of labels inside a picture.
pub const SMALL: f64 = TYPE - 1.0;

/// A text and its place.
pub type TextAt = (At, String);

/// The radius of an event's dot.
pub const DOT: f64 = 1.6;

/// Texts beside points, placed where they cover no curve, no dot and no other text, as far as there is room.
pub struct Labels {
    /// Points of all curves, close together.
    pub points: Vec<At>,
    /// The events.
    pub dots: Vec<At>,
    /// The panel: left, top, right, bottom.
    panel: [f64; 4],
    /// Point and text.
    pub wanted: Vec<TextAt>,
}

/// A text with its left end, half-way up, and the line from its point where it stands apart.
struct Placed {
    text: String,
    at: At,
    leader: Option<[At; 2]>,
}

impl Labels {
    /// Labels in a panel that cover none of these lines, as far as there is room.
    pub fn new(paths: &[Vec<At>], panel: [f64; 4]) -> Labels {
        let between = |pair: &[At]| {
            let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
            let steps = ((x1 - x0).abs().max((y1 - y0).abs()).min(1e4) / 1.2).ceil().max(1.0) as usize;
            let part = move |i: usize| i as f64 / steps as f64;
            (0..=steps).map(move |i| (x0 + (x1 - x0) * part(i), y0 + (y1 - y0) * part(i)))
        };
        let points = paths.iter().flat_map(|path| path.windows(2).flat_map(between)).collect();
        Labels { points, dots: Vec::new(), panel, wanted: Vec::new() }
    }

    /// Writes them.
    pub fn draw(&self, canvas: &mut Canvas) {
        for Placed { text, at, leader } in self.placed() {
            if let Some(leader) = leader {
                canvas.line(leader.to_vec(), line(GREY, 0.4));
            }
            canvas.sized(Words::plain(&text), at, Anchor::Start, SMALL);
        }
    }

    fn placed(&self) -> Vec<Placed> {
        let mut boxes: Vec<[f64; 4]> = Vec::new();
        let mut leaders: Vec<[At; 2]> = Vec::new();
        let mut placed = Vec::new();
        for (point, text) in &self.wanted {
            let (x, y) = *point;
            let (wide, half) = (Words::plain(text).width(SMALL) + 1.0, 0.55 * SMALL);
            // All round the point, ever farther away.
            let ring = |step: u32| {
                let (r, around) = (4.0 + 4.0 * f64::from(step), 16);
                (0..around).map(move |i| {
                    let (sin, cos) = (f64::from(i) * TAU / f64::from(around)).sin_cos();
                    let left = x + r * cos - wide * (1.0 - 1.5 * cos).clamp(0.0, 2.0) / 2.0;
                    let middle = y + r * sin + half * (1.5 * sin).clamp(-1.0, 1.0);
                    (r, [left, left + wide, middle - half, middle + half])
                })
            };
            let cost = |(r, spot): &(f64, [f64; 4])| {
                let crossed = self.leader(*point, spot).map_or(0, |own| {
                    let meets = |other: &&[f64; 4]| passes(&own, other);
                    100 * boxes.iter().filter(meets).count()
                        + 50 * leaders.iter().filter(|other| cross(&own, other)).count()
                });
                let under = 100 * leaders.iter().filter(|one| passes(one, spot)).count();
                *r as usize / 2 + self.cost(spot, &boxes) + crossed + under
            };
            let best = (0..20).flat_map(ring).min_by_key(cost).map(|(_, best)| best);
            let Some(best) = best else { continue };
            let leader = self.leader(*point, &best);
            leaders.extend(leader);
            placed.push(Placed { text: text.clone(), at: (best[0], (best[2] + best[3]) / 2.0), leader });
            boxes.push(best);
        }
        placed
    }

    /// The line from a point to a text that stands apart from it, or nearer to another event than to its own.
    fn leader(&self, point: At, [left, right, top, bottom]: &[f64; 4]) -> Option<[At; 2]> {
        let end = (point.0.clamp(*left, *right), point.1.clamp(top + 2.0, bottom - 2.0));
        let apart = |dot: At| (dot.0 - dot.0.clamp(*left, *right)).hypot(dot.1 - dot.1.clamp(*top, *bottom));
        let own = apart(point);
        let other = |dot: &&At| (dot.0 - point.0).hypot(dot.1 - point.1) >= DOT && apart(**dot) <= own + 2.0;
        let event = self.dots.iter().any(|dot| (dot.0 - point.0).hypot(dot.1 - point.1) < DOT);
        (event && (own > 6.0 || self.dots.iter().any(|dot| other(&dot)))).then_some([point, end])
    }

    fn cost(&self, spot: &[f64; 4], boxes: &[[f64; 4]]) -> usize {
        let [left, right, top, bottom] = *spot;
        let edge = 1.0;
        let outside = left < self.panel[0] + edge
            || right > self.panel[2] - edge
            || top < self.panel[1] + edge
            || bottom > self.panel[3] - edge;
        let inside = |&&(x, y): &&At| (left..=right).contains(&x) && (top..=bottom).contains(&y);
        let covers = |&&(x, y): &&At| {
            (left - DOT..=right + DOT).contains(&x) && (top - DOT..=bottom + DOT).contains(&y)
        };
        let meets =
            |other: &&[f64; 4]| left < other[1] && other[0] < right && top < other[3] && other[2] < bottom;
        2000 * usize::from(outside)
            + 2 * self.points.iter().filter(inside).count()
            + 100 * self.dots.iter().filter(covers).count()
            + 300 * boxes.iter().filter(meets).count()
    }
}

/// Whether a line passes through a box.
fn passes([from, to]: &[At; 2], [left, right, top, bottom]: &[f64; 4]) -> bool {
    (1..20).map(|i| f64::from(i) / 20.0).any(|part| {
        let (x, y) = (from.0 + part * (to.0 - from.0), from.1 + part * (to.1 - from.1));
        (left..=right).contains(&&x) && (top..=bottom).contains(&&y)
    })
}

/// Whether two lines cross.
fn cross(one: &[At; 2], other: &[At; 2]) -> bool {
    let side = |line: &[At; 2], at: At| {
        let [a, b] = line;
        (b.0 - a.0) * (at.1 - a.1) - (b.1 - a.1) * (at.0 - a.0)
    };
    side(one, other[0]) * side(one, other[1]) < 0.0 && side(other, one[0]) * side(other, one[1]) < 0.0
}
