//! The minimum of a gap on a cell, by its first two derivatives.

/// Where z has a minimum on the cell from 0 to `width`, `at` being (z, z′, z″), `a` and `b` its values at
/// both ends: on it z″ is taken to change sign once at most, so z′ is monotone on either side of that point
/// and every root of z′ is found.
pub(crate) fn minimum_within(
    at: impl Fn(f64) -> [f64; 3],
    a: [f64; 3],
    b: [f64; 3],
    width: f64,
) -> Option<f64> {
    // The stretch on which z′ rises through zero, if there is one, with z′ and z″ at its ends.
    let (begin, end) = ((0.0, [a[1], a[2]]), (width, [b[1], b[2]]));
    let (lo, hi) = if a[1] < 0.0 && b[1] >= 0.0 {
        (begin, end)
    } else if a[2] * b[2] < 0.0 && (a[1] < 0.0) == (b[1] < 0.0) && (a[1] < 0.0) == (a[2] > 0.0) {
        let sign = b[2].signum();
        // The third derivative is not at hand: the slope of the last chord stands for it.
        let mut last = (0.0, a[2] * sign);
        let bend = |t: f64| {
            let here = (t, at(t)[2] * sign);
            let slope = (here.1 - last.1) / (here.0 - last.0);
            last = here;
            (here.1, slope)
        };
        let ends = ((0.0, a[2] * sign), (width, b[2] * sign));
        let turn = rising(bend, ends.0, ends.1, chord(ends.0, ends.1));
        let [_, middle, bend] = at(turn);
        match a[1] < 0.0 {
            true if middle >= 0.0 => (begin, (turn, [middle, bend])),
            false if middle < 0.0 => ((turn, [middle, bend]), end),
            _ => return None,
        }
    } else {
        return None;
    };
    let slope = |t: f64| {
        let [_, z1, z2] = at(t);
        (z1, z2)
    };
    Some(rising(slope, (lo.0, lo.1[0]), (hi.0, hi.1[0]), cubic(lo, hi)))
}

/// Where the chord between two points passes through 0.
fn chord(lo: (f64, f64), hi: (f64, f64)) -> f64 {
    lo.0 + (hi.0 - lo.0) * (lo.1 / (lo.1 - hi.1))
}

/// About where the cubic passes through 0 that has these values and slopes at two points.
fn cubic(lo: (f64, [f64; 2]), hi: (f64, [f64; 2])) -> f64 {
    let width = hi.0 - lo.0;
    let (from, to, rise) = (lo.1[1] * width, hi.1[1] * width, hi.1[0] - lo.1[0]);
    let (second, third) = (3.0 * rise - 2.0 * from - to, from + to - 2.0 * rise);
    let mut s = lo.1[0] / (lo.1[0] - hi.1[0]);
    for _ in 0..3 {
        let value = lo.1[0] + s * (from + s * (second + s * third));
        s -= value / (from + s * (2.0 * second + 3.0 * s * third));
    }
    lo.0 + width * s
}

/// A step this short against the bracket is the last one of Newton's method, whose error then is of the order
/// of the step's square, or of rounding.
const LAST_STEP: f64 = 1e-13;

/// The step after two steps of Newton's method is about the second times the square of its ratio to the
/// first. This short against the bracket, it is rounding's and not taken.
const NEXT_STEP: f64 = 1e-16;

/// Where f passes through 0 between `lo` and `hi`, each with its value, f(lo) < 0 ≤ f(hi): Newton's method
/// with the slope that f gives beside its value, from `guess` if that is between them, else from the zero of
/// the chord. A step that leaves the bracket, or is more than half as long as the one before, is a bisection
/// instead. So it ends, whatever the slopes are; in some 5 evaluations where they are good, in 2 or 3 where
/// the guess is, too.
fn rising(mut f: impl FnMut(f64) -> (f64, f64), lo: (f64, f64), hi: (f64, f64), guess: f64) -> f64 {
    let (width, chord) = (hi.0 - lo.0, chord(lo, hi));
    let (mut lo, mut hi) = (lo.0, hi.0);
    let inside = |t: &f64| *t > lo && *t < hi;
    let mut t = [guess, chord].into_iter().find(inside).unwrap_or(lo + width / 2.0);
    let (mut last, mut quick_before) = (width, false);
    // Of two steps one at least halves the bracket or the step: down to 10⁻¹³ in 90.
    for _ in 0..100 {
        let (value, slope) = f(t);
        if value == 0.0 {
            return t;
        }
        *(if value < 0.0 { &mut lo } else { &mut hi }) = t;
        let newton = t - value / slope;
        let quick = (lo..=hi).contains(&newton) && (newton - t).abs() <= last / 2.0;
        let next = if quick { newton } else { lo + (hi - lo) / 2.0 };
        let step = (next - t).abs();
        t = next;
        let converged = quick && quick_before && step * (step / last).powi(2) <= NEXT_STEP * width;
        if converged || step <= LAST_STEP * width {
            break;
        }
        (last, quick_before) = (step, quick);
    }
    t
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By bisection to the last digit, another way.
    fn bisected(f: impl Fn(f64) -> f64, mut lo: f64, mut hi: f64) -> f64 {
        for _ in 0..200 {
            let middle = lo + (hi - lo) / 2.0;
            *(if f(middle) < 0.0 { &mut lo } else { &mut hi }) = middle;
        }
        hi
    }

    /// Straight, steep, flat at the root, with a slope that is zero, wrong or not a number, and a jump.
    #[test]
    fn roots_are_those_of_bisection() {
        type Case = (fn(f64) -> f64, fn(f64) -> f64);
        let cases: [Case; 8] = [
            (|t| t - 0.3, |_| 1.0),
            (|t| (20.0 * (t - 0.7)).tanh(), |t| 20.0 / (20.0 * (t - 0.7)).cosh().powi(2)),
            (|t| (t - 0.6).powi(3), |t| 3.0 * (t - 0.6).powi(2)),
            (|t| (t - 0.6).powi(5), |t| 5.0 * (t - 0.6).powi(4)),
            (|t| t.exp() - 1.5, |_| 0.0),
            (|t| t.exp() - 1.5, |_| -1.0),
            (|t| t.exp() - 1.5, |_| f64::NAN),
            (|t| if t < 0.4 { -1.0 } else { 2.0 }, |_| 1.0),
        ];
        for (index, (f, slope)) in cases.into_iter().enumerate() {
            let mut evaluations = 0;
            let found = rising(
                |t| {
                    evaluations += 1;
                    (f(t), slope(t))
                },
                (0.0, f(0.0)),
                (1.0, f(1.0)),
                f64::NAN,
            );
            let expected = bisected(f, 0.0, 1.0);
            assert!((found - expected).abs() < 1e-12, "{index}: {found} {expected}");
            assert!(evaluations <= if index < 2 { 8 } else { 100 }, "{index}: {evaluations}");
        }
    }

    /// A cell whose z′ has one sign at both ends, and passes through 0 twice in between.
    #[test]
    fn a_minimum_beside_a_maximum_is_found() {
        // z′ = ±(t − a)(b − t), with the minimum where z′ rises.
        for (a, b) in [(0.2, 0.5), (0.45, 0.5), (0.499_999, 0.5)] {
            for falls in [true, false] {
                let sign = if falls { 1.0 } else { -1.0 };
                let at = |t: f64| {
                    let z2 = sign * (a + b - 2.0 * t);
                    [0.0, sign * (t - a) * (b - t), z2]
                };
                let found = minimum_within(at, at(0.0), at(1.0), 1.0).unwrap();
                let expected = if falls { a } else { b };
                assert!((found - expected).abs() < 1e-9, "{a} {b} {falls}: {found}");
            }
        }
        let none = |t: f64| [0.0, -1e-9 - (t - 0.4).powi(2), -2.0 * (t - 0.4)];
        assert_eq!(minimum_within(none, none(0.0), none(1.0), 1.0), None);
    }
}
