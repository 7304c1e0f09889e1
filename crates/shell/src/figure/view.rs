//! What part of a plane a picture shows, and whether a displacement that is an angle is shown within one
//! turn. Only the picture: the data beside it are whole.

use std::f64::consts::{PI, TAU};

use crate::error::{Error, Result};

/// What of its plane a picture shows; by default all.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct View {
    /// From where to where across.
    pub x: Option<(f64, f64)>,
    /// From where to where up.
    pub y: Option<(f64, f64)>,
    /// Whether displacements q are shown modulo 2π, from 0 on.
    pub turns: bool,
}

/// A point of a curve, and what is said of it.
type Point<T> = (f64, f64, T);

impl View {
    /// Whether it shows all, as it is.
    pub fn is_whole(&self) -> bool {
        *self == View::default()
    }

    /// The same view in a plane with these axes.
    ///
    /// # Errors
    /// An input error if an angle is asked for and neither is a displacement.
    pub fn on(&self, axes: [&str; 2]) -> Result<PlaneView> {
        let turned = axes.map(|name| self.turns && name.starts_with('q'));
        if self.turns && turned == [false; 2] {
            return Err(Error::input(format!(
                "--q-modulo-2pi: neither {} nor {} is a displacement q; leave it out",
                axes[0], axes[1]
            )));
        }
        let all = (f64::NEG_INFINITY, f64::INFINITY);
        Ok(PlaneView { limits: [self.x.unwrap_or(all), self.y.unwrap_or(all)], turned })
    }
}

/// A view of a plane whose axes are known.
pub struct PlaneView {
    limits: [(f64, f64); 2],
    turned: [bool; 2],
}

impl PlaneView {
    /// Whether an axis is an angle.
    pub fn turns(&self) -> bool {
        self.turned.contains(&true)
    }

    /// Where a point is shown.
    pub fn of(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let turn = |x: f64, turned: bool| if turned { x.rem_euclid(TAU) } else { x };
        (turn(x, self.turned[0]), turn(y, self.turned[1]))
    }

    /// Whether a place is in the picture.
    pub fn holds(&self, (x, y): (f64, f64)) -> bool {
        let [across, up] = self.limits;
        (across.0..=across.1).contains(&x) && (up.0..=up.1).contains(&y)
    }

    /// The points that are in the picture, where they are shown.
    pub fn points(&self, all: &[(f64, f64)]) -> Vec<(f64, f64)> {
        all.iter().map(|&at| self.of(at)).filter(|&at| self.holds(at)).collect()
    }

    /// The parts of a curve that are in the picture, cut at its edges and where a turn ends.
    pub fn pieces<T: Copy>(&self, curve: &[Point<T>]) -> Vec<Vec<Point<T>>> {
        let mut pieces: Vec<Vec<Point<T>>> = vec![Vec::new()];
        // Whether the last piece ends at the point before.
        let (mut before, mut open): (Option<Point<T>>, bool) = (None, false);
        for &(x, y, what) in curve {
            let (x, y) = self.of((x, y));
            let now = (x, y, what);
            let beside = before.filter(|&(x0, y0, _)| !self.leaps((x0, y0), (x, y)));
            match beside.map(|before| (before, self.part((before.0, before.1), (x, y)))) {
                Some((from, Some([begin, end]))) => {
                    let at = |t: f64, what| (from.0 + t * (x - from.0), from.1 + t * (y - from.1), what);
                    if begin > 0.0 || !open {
                        pieces.push(vec![at(begin, what)]);
                    }
                    let piece = pieces.last_mut().expect("there is always one");
                    open = end >= 1.0;
                    piece.push(if open { now } else { at(end, from.2) });
                }
                Some((_, None)) => open = false,
                None => {
                    open = self.holds((x, y));
                    if open {
                        pieces.push(vec![now]);
                    }
                }
            }
            before = Some(now);
        }
        pieces.retain(|piece| !piece.is_empty());
        pieces
    }

    /// Whether two places are on both sides of the end of a turn.
    fn leaps(&self, (x0, y0): (f64, f64), (x1, y1): (f64, f64)) -> bool {
        (self.turned[0] && (x1 - x0).abs() > PI) || (self.turned[1] && (y1 - y0).abs() > PI)
    }

    /// Which part of the line from one place to another is in the picture, from 0 to 1.
    fn part(&self, from: (f64, f64), to: (f64, f64)) -> Option<[f64; 2]> {
        let (mut begin, mut end): (f64, f64) = (0.0, 1.0);
        for (i, (a, b)) in [(from.0, to.0), (from.1, to.1)].into_iter().enumerate() {
            let (low, high) = self.limits[i];
            if a == b {
                if !(low..=high).contains(&a) {
                    return None;
                }
                continue;
            }
            let (one, other) = ((low - a) / (b - a), (high - a) / (b - a));
            (begin, end) = (begin.max(one.min(other)), end.min(one.max(other)));
        }
        (begin < end || (begin == end && begin == 0.0)).then_some([begin, end])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_are_cut_at_the_edges_of_a_picture() {
        let view = View { x: Some((0.0, 1.0)), y: Some((-1.0, 1.0)), turns: false };
        let plane = view.on(["mu", "q"]).unwrap();
        // In from the left, out at the top; a leg outside; in again from the right.
        let curve = [(-1.0, 0.0, 'a'), (0.5, 0.0, 'b'), (0.5, 4.0, 'c'), (3.0, 0.5, 'd'), (0.5, 0.5, 'e')];
        let pieces = plane.pieces(&curve);
        assert_eq!(
            pieces,
            [vec![(0.0, 0.0, 'b'), (0.5, 0.0, 'b'), (0.5, 1.0, 'b')], vec![(1.0, 0.5, 'e'), (0.5, 0.5, 'e')]]
        );
        // A point on the edge belongs to what goes on inside, and to nothing that went out before.
        let edge = [(0.5, 0.0, 'a'), (-1.0, 0.0, 'b'), (0.0, 0.0, 'c'), (0.5, 0.5, 'd')];
        assert_eq!(
            plane.pieces(&edge),
            [vec![(0.5, 0.0, 'a'), (0.0, 0.0, 'a')], vec![(0.0, 0.0, 'd'), (0.5, 0.5, 'd')]]
        );
        assert_eq!(plane.points(&[(0.5, 0.0), (2.0, 0.0), (1.0, -1.0)]), [(0.5, 0.0), (1.0, -1.0)]);
        assert_eq!(View::default().on(["mu", "q"]).unwrap().pieces(&curve), [curve.to_vec()]);
    }

    #[test]
    fn angles_are_within_a_turn_and_curves_are_cut_where_it_ends() {
        let view = View { turns: true, ..View::default() };
        let plane = view.on(["mu", "q"]).unwrap();
        let curve: Vec<_> = (0..8).map(|i| (f64::from(i), f64::from(i), ())).collect();
        let pieces = plane.pieces(&curve);
        assert_eq!(pieces.iter().map(Vec::len).collect::<Vec<_>>(), [7, 1]);
        assert!((pieces[1][0].1 - (7.0 - TAU)).abs() < 1e-15);
        assert_eq!(plane.of((9.0, -1.0)), (9.0, TAU - 1.0));
        assert!(view.on(["F", "gap"]).is_err());
    }
}
