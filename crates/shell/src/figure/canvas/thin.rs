//! Lines with fewer corners that look the same.

use super::At;

/// A corner is left out where the line stays this near to it, in points: a twentieth of a pixel on a screen.
const NEAR: f64 = 1.0 / 60.0;
/// Lines are thinned this many corners at a time, so that the cost stays proportional to their number.
const MOST: usize = 1000;

/// The corners of a line that are needed, by Douglas and Peucker: no other is farther than [`NEAR`] from the
/// line through them. The first and the last stay.
///
/// Cost: O(n) for n corners, times at most [`MOST`].
pub(super) fn thinned(line: &[At]) -> Vec<At> {
    if line.len() < 3 {
        return line.to_vec();
    }
    let mut kept = vec![line[0]];
    for first in (0..line.len() - 1).step_by(MOST) {
        let part = &line[first..line.len().min(first + MOST + 1)];
        let mut open = vec![(0, part.len() - 1)];
        while let Some((from, to)) = open.pop() {
            match farthest(part, from, to) {
                // The later half waits, so that corners are kept in order.
                Some(at) => open.extend([(at, to), (from, at)]),
                None => kept.push(part[to]),
            }
        }
    }
    kept
}

/// The corner between two that is farthest from the line between these, if it is not near to it. What is no
/// number is not near.
fn farthest(line: &[At], from: usize, to: usize) -> Option<usize> {
    let distances = (from + 1..to).map(|at| (at, distance(line[at], line[from], line[to])));
    let known =
        distances.map(|(at, distance)| (at, if distance.is_nan() { f64::INFINITY } else { distance }));
    let (at, distance) = known.max_by(|a, b| a.1.total_cmp(&b.1))?;
    (distance > NEAR).then_some(at)
}

/// How far a place is from a straight piece between two.
fn distance(at: At, from: At, to: At) -> f64 {
    let (across, down) = (to.0 - from.0, to.1 - from.1);
    let square = across * across + down * down;
    let along = ((at.0 - from.0) * across + (at.1 - from.1) * down) / square;
    // From one place to the same one there is no way along.
    let along = if square > 0.0 { along.clamp(0.0, 1.0) } else { 0.0 };
    (at.0 - from.0 - along * across).hypot(at.1 - from.1 - along * down)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn only_corners_that_are_seen_stay() {
        let line: Vec<At> = (0..=100).map(|i| (f64::from(i), if i == 50 { 0.001 } else { 0.0 })).collect();
        assert_eq!(thinned(&line), [(0.0, 0.0), (100.0, 0.0)]);
        // There and back again: the far end stays, though it is on the line.
        assert_eq!(thinned(&[(0.0, 0.0), (9.0, 0.0), (0.0, 0.0)]).len(), 3);
        for nowhere in [f64::NAN, -f64::NAN, f64::INFINITY] {
            assert_eq!(thinned(&[(0.0, 0.0), (nowhere, 0.0), (1.0, 0.0)]).len(), 3, "{nowhere}");
        }
    }

    proptest! {
        #[test]
        fn no_corner_is_far_from_what_is_left(
            places in proptest::collection::vec((0.0..3.0f64, 0.0..0.1f64), 2..2500),
        ) {
            let kept = thinned(&places);
            prop_assert_eq!((kept[0], kept[kept.len() - 1]), (places[0], places[places.len() - 1]));
            let mut piece = 0;
            for at in places {
                if piece + 2 < kept.len() && at == kept[piece + 1] {
                    piece += 1;
                }
                let [from, to] = [kept[piece], kept[piece + 1]];
                prop_assert!(distance(at, from, to) <= NEAR, "{:?}", at);
            }
        }
    }
}
