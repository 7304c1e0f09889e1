//! The free motion: the exponential of one 2×2 matrix, and with it sine and cosine.
//!
//! q″ = −c q′ − k q is (q, q′)′ = A (q, q′) with A = [[0, 1], [−k, −c]] and A² = −cA − k. So E(t) = exp(tA) =
//! a + bA for two numbers, found by the power series without any case; its entries are [[a, b], [−kb, a −
//! cb]]. For c = 0 and k = 1 it is cos t + A sin t.

use super::Interval;

/// The coefficients of q″ = −c q′ − k q.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Flow {
    pub damping: Interval,
    pub stiffness: Interval,
}

/// E = a + bA, by the entries that are used.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Matrix {
    /// a = E₁₁.
    pub a: Interval,
    /// b = E₁₂.
    pub b: Interval,
}

/// cos t + A sin t.
const CIRCLE: Flow = Flow { damping: Interval::ZERO, stiffness: Interval::ONE };

/// For c = −1 and k = 0 it is 1 + (e^t − 1) A, A² = A.
const GROWTH: Flow = Flow { damping: Interval::MINUS_ONE, stiffness: Interval::ZERO };

/// Terms of the power series: at norms up to 1/4 the rest is below 2·4⁻¹⁴/14! < 2⁻⁶³, far less than a unit.
const TERMS: i128 = 13;

impl Flow {
    /// (a + bA)(a′ + b′A) = (aa′ − kbb′) + (ab′ + ba′ − cbb′) A.
    pub fn times(self, x: Matrix, y: Matrix) -> Matrix {
        let square = x.b * y.b;
        Matrix { a: x.a * y.a - self.stiffness * square, b: x.a * y.b + x.b * y.a - self.damping * square }
    }

    /// As [`times`](Flow::times) of a matrix with itself, where squares are not negative.
    fn squared(self, x: Matrix) -> Matrix {
        let (square, product) = (x.b.squared(), x.a * x.b);
        Matrix { a: x.a.squared() - self.stiffness * square, b: product + product - self.damping * square }
    }

    /// E(t) for every enclosed t. Of c and k that are intervals of some width a second enclosure is met with,
    /// so that the work is up to three times that of numbers.
    pub fn exp(self, t: Interval) -> Matrix {
        #[cfg(test)]
        EXPONENTIALS.set(EXPONENTIALS.get() + 1);
        let found = self.apart(t);
        let by_roots = if self.is_wide() { self.by_roots(t) } else { None };
        by_roots.map_or(found, |e| Matrix { a: found.a.meet(e.a), b: found.b.meet(e.b) })
    }

    /// Whether c or k is wider than some units.
    fn is_wide(self) -> bool {
        let narrow = |x: Interval| (x - x.middle()).magnitude().is_below(Interval::ONE.shifted_down(36));
        !(narrow(self.damping) && narrow(self.stiffness))
    }

    /// E(t), where squaring the series would make an interval of c or k wider each time: with ω² = k − c²/4
    /// it is e^−ct/2 (cos ωt + sin ωt/ω (A + c/2)), or so in cosh and sinh; none where the sign of ω² is not
    /// certain.
    fn by_roots(self, t: Interval) -> Option<Matrix> {
        let half = self.damping.half();
        let square = self.stiffness - half.squared();
        let growth = |x: Interval| {
            let e = GROWTH.apart(x);
            e.a + e.b
        };
        let (even, odd) = if square.is_positive() {
            let omega = square.roots();
            let (circle, decay) = (CIRCLE.apart(omega * t), growth(-(half * t)));
            (decay * circle.a, (decay * circle.b).over(omega))
        } else if (-square).is_positive() {
            let omega = (-square).roots();
            let [up, down] = [omega - half, -omega - half].map(|rate| growth(rate * t));
            ((up + down).half(), (up - down).half().over(omega))
        } else {
            return None;
        };
        Some(Matrix { a: even + half * odd, b: odd })
    }

    /// E(t), the middle of t apart, so that an interval of t is no wider than it must be.
    fn apart(self, t: Interval) -> Matrix {
        let middle = t.middle();
        let rest = t - middle;
        if rest == Interval::ZERO {
            self.series(middle)
        } else {
            self.times(self.series(middle), self.series(rest))
        }
    }

    /// E(t/2^j)^(2^j) with ‖tA/2^j‖ ≤ 1/4, by rows: ‖A‖ ≤ max(1, |k| + |c|).
    fn series(self, t: Interval) -> Matrix {
        let unknown = Matrix { a: Interval::WHOLE, b: Interval::WHOLE };
        let (Some(damping), Some(stiffness), Some(size)) =
            (self.damping.magnitude_bits(), self.stiffness.magnitude_bits(), t.magnitude_bits())
        else {
            return unknown;
        };
        // |c| + |k| ≤ 2^(larger + 1) and 1 = 2⁴⁸ units, so ‖tA‖ ≤ 2^(size + norm − 96), wanted at most 2⁻².
        let norm = (damping.max(stiffness) + 1).max(48);
        let halvings = (size + norm + 2).saturating_sub(96);
        let t = t.shifted_down(halvings);
        // 1 + tA (1 + tA/2 (1 + tA/3 (…))), where A (a + bA) = −kb + (a − cb) A.
        let mut sum = Matrix { a: Interval::ONE, b: Interval::ZERO };
        for n in (1..=TERMS).rev() {
            let factor = t.divided(n);
            let a = Interval::ONE - factor * self.stiffness * sum.b;
            sum = Matrix { a, b: factor * (sum.a - self.damping * sum.b) };
        }
        // a and b are entries of the matrix, the rest's are below its norm.
        let sum = Matrix { a: sum.a.outwards(), b: sum.b.outwards() };
        (0..halvings).fold(sum, |x, _| self.squared(x))
    }

    /// (q, q′) a time after (q, u), given E.
    pub fn apply(self, e: Matrix, q: Interval, u: Interval) -> (Interval, Interval) {
        (e.a * q + e.b * u, self.velocity(e) * u - self.stiffness * (e.b * q))
    }

    /// E₁₁ + E₂₂ and E₁₁E₂₂ − E₁₂E₂₁.
    pub fn invariants(self, e: Matrix) -> [Interval; 2] {
        let velocity = self.velocity(e);
        [e.a + velocity, e.a * velocity + self.stiffness * e.b.squared()]
    }

    /// E₂₂.
    pub fn velocity(self, e: Matrix) -> Interval {
        e.a - self.damping * e.b
    }
}

/// The cosines of an interval, and the sines.
pub(crate) fn circle(t: Interval) -> (Interval, Interval) {
    let e = CIRCLE.exp(t);
    (e.a, e.b)
}

#[cfg(test)]
thread_local! {
    /// How many exponentials were taken on this thread.
    pub(crate) static EXPONENTIALS: std::cell::Cell<u64> = const { std::cell::Cell::new(0) };
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of intervals of c and k all is enclosed that their numbers give, often less than half as wide as by
    /// the series alone.
    #[test]
    fn wide_coefficients_are_enclosed_closely() {
        let mut state = 7u64;
        let mut random = |below: i128| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            i128::from(state >> 33) % below
        };
        let thousandth = |x: i128| Interval::ratio(x, 1000);
        let width = |x: Interval| (x - x.middle()).magnitude();
        let (mut waves, mut growths, mut closer) = (0, 0, 0);
        for _ in 0..300 {
            let [c, k, t] = [random(800) - 100, random(2000) - 300, random(20_000)];
            let of = |x: i128, by: i128| thousandth(x) + Interval::ratio(by, 10_000_000);
            let wide = Flow { damping: of(c, 0).hull(of(c, 10)), stiffness: of(k, 0).hull(of(k, 10)) };
            let time = thousandth(t);
            let Some(roots) = wide.by_roots(time) else { continue };
            if 4 * k * 1000 > c * c {
                waves += 1
            } else {
                growths += 1
            }
            for _ in 0..4 {
                let [by, other] = [random(11), random(11)];
                let one = Flow { damping: of(c, by), stiffness: of(k, other) }.apart(time);
                assert!(holds(roots.a, one.a) && holds(roots.b, one.b), "{c} {k} {t}");
                let met = wide.exp(time);
                assert!(holds(met.a, one.a) && holds(met.b, one.b), "{c} {k} {t}");
            }
            if width(roots.b).is_below(width(wide.apart(time).b).half()) {
                closer += 1;
            }
        }
        assert!(waves > 150 && growths > 20 && closer > 60, "{waves} {growths} {closer}");
    }

    /// Whether a narrow interval's middle is in another.
    fn holds(all: Interval, one: Interval) -> bool {
        all.common(one.middle()).is_some()
    }
}
