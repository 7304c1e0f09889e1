//! The free motion of an overdamped oscillator, for all c and k of their ranges, with the bounds that its
//! rates of decay give.
//!
//! E₁₂(T) is ∫ e^−as e^−b(T − s) ds over 0 < s < T, and E₁₁(T) = 1 − ab ∫ E₁₂ is the chance that two times,
//! one of each rate, are longer than T together: both fall as a or b grow. So the bounds of either over the
//! ranges are its values at two corners of a and b, though no machine need be there.

use super::{Fault, Interval, claim};
use crate::motion::exponential::Ring;

/// a < b, and D = b − a, over all c and k.
pub(super) struct Rates {
    pub slow: Interval,
    pub fast: Interval,
    pub apart: Interval,
}

/// For c = −1 and k = 0 it is 1 + (e^t − 1) A, A² = A.
const GROWTH: Ring<Interval> = Ring { damping: Interval::MINUS_ONE, stiffness: Interval::ZERO };
/// Beyond this nothing is left of e^−x but what it is rounded to, below 2⁻⁷⁰.
const LONG: u64 = 64;

/// e^x, the middle of x apart: a product of two numbers above 0 is no wider than it must be.
pub(super) fn growth(x: Interval) -> Interval {
    let of = |x: Interval| {
        let e = GROWTH.exp(x);
        e.a + e.b
    };
    of(x.middle()) * of(x - x.middle())
}

/// e^−x for x ≥ 0.
pub(super) fn decay(x: Interval) -> Interval {
    let long = Interval::integer(LONG);
    let found = if long.is_up_to(x) { Interval::ZERO.hull(growth(-long)) } else { growth(-x) };
    found.meet(Interval::ZERO.hull(Interval::ONE))
}

impl Rates {
    /// A1 of c and k. With D = √(c² − 4k) it is b = (c + D)/2 and a = k/b: of each the least is where c is
    /// least or greatest and k the other way round, so that these intervals are no wider than they must be.
    pub fn new(damping: Interval, stiffness: Interval) -> Result<Rates, Fault> {
        let square = damping.squared() - stiffness * Interval::integer(4);
        let over = stiffness.is_positive() && damping.is_positive() && square.is_positive();
        claim(over, "the oscillator may not be overdamped (A1)")?;
        let apart = square.roots();
        let fast = (damping + apart).half();
        Ok(Rates { slow: stiffness.over(fast), fast, apart })
    }

    /// E₁₁ and E₁₂ at a time, of the rates' least numbers or of their greatest.
    fn corner(&self, time: Interval, greatest: bool) -> [Interval; 2] {
        let [a, b] = [self.slow, self.fast].map(|rate| if greatest { rate.greatest() } else { rate.least() });
        let [slow, fast] = [a, b].map(|rate| decay(rate * time));
        let reach = (slow - fast).over(b - a);
        [slow + a * reach, reach]
    }

    /// No E₁₂ is below this.
    pub fn least_reach(&self, time: Interval) -> Interval {
        self.corner(time, true)[1].least()
    }

    /// No E₁₁ is above this.
    pub fn greatest_rest(&self, time: Interval) -> Interval {
        self.corner(time, false)[0].greatest()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// E₁₁ and E₁₂ by the exponential of the matrix, at the corners of c and k and inside: they lie between
    /// the bounds, and where c and k are numbers the bounds are next to them.
    #[test]
    fn the_corners_bound_the_motion() {
        for ([c, k], time) in
            [([375, 15], 5984), ([375, 15], 60_000), ([900, 100], 700), ([5000, 30], 12_000)]
        {
            let at = |n: i128, more: i128| Interval::ratio(1000 * n + more, 1_000_000);
            let time = Interval::ratio(time, 1000);
            let all = [0, 900].map(|more| [at(c, more), at(k, more)]);
            let [damping, stiffness] = [0, 1].map(|i| all[0][i].hull(all[1][i]));
            let wide = Rates::new(damping, stiffness).unwrap();
            for [i, j] in [[0, 0], [0, 900], [900, 0], [900, 900], [450, 450]] {
                let ring = Ring { damping: at(c, i), stiffness: at(k, j) };
                let e = ring.exp(time);
                assert!(wide.least_reach(time).is_up_to(e.b) && e.a.is_up_to(wide.greatest_rest(time)));
                let narrow = Rates::new(ring.damping, ring.stiffness).unwrap();
                let [rest, reach] = narrow.corner(time, i > j);
                let near = Interval::ratio(1, 1 << 60);
                assert!(rest.is_within(near, e.a) && reach.is_within(near, e.b), "{rest:?} {e:?}");
                // a + b = c and ab = k.
                let [sum, product] = [narrow.slow + narrow.fast, narrow.slow * narrow.fast];
                assert!(sum.is_within(near, ring.damping) && product.is_within(near, ring.stiffness));
            }
        }
    }

    /// e^x and e^−x multiply to 1, also of wide intervals and long times.
    #[test]
    fn growth_undoes_decay() {
        for x in [0, 1, 700, 5000, 14_000] {
            let x = Interval::ratio(x, 1000);
            let one = growth(x) * decay(x);
            assert!(one.is_within(Interval::ratio(1, 1 << 40), Interval::ONE), "{one:?}");
            let wide = decay(x.hull(x + Interval::ONE));
            assert!(wide.common(decay(x)).is_some() && wide.common(decay(x + Interval::ONE)).is_some());
        }
        for long in [64, 70, 1 << 20] {
            let none = decay(Interval::integer(long));
            assert!(none.is_nonnegative() && none.is_below(Interval::ratio(1, 1 << 70)), "{none:?}");
        }
    }
}
