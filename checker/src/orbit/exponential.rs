//! exp, and with it sin, cos and √: the exponential of one 2×2 matrix.
//!
//! The free motion q″ = −c q′ − k q is (q, q′)′ = A (q, q′) with A = [[0, 1], [−k, −c]], and A² = −cA − k. So exp(tA) = a + bA for two
//! numbers, found by the power series without any case: e^−ct/2 cos ωt and sin ωt with ω = √(k − c²/4) if that is real, cosh and sinh if
//! not. For c = 0 and k = 1 it is cos t + A sin t. Entries: [[a, b], [−kb, a − cb]].

use super::fixed::Interval;

/// The numbers a + bA for one A.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ring {
    pub damping: Interval,
    pub stiffness: Interval,
}

/// a + bA.
#[derive(Debug, Clone, Copy)]
pub(super) struct Element {
    pub a: Interval,
    pub b: Interval,
}

/// Terms of the power series: with x ≤ 1/4 the rest is below 2·4⁻²²/22! < 2⁻¹¹², far less than a unit.
const TERMS: i128 = 21;

/// The circle: exp(tA) = cos t + A sin t.
pub(super) const CIRCLE: Ring = Ring { damping: Interval::ZERO, stiffness: Interval::ONE };

impl Ring {
    /// (a + bA)(a′ + b′A) = (aa′ − kbb′) + (ab′ + ba′ − cbb′) A.
    fn times(self, x: Element, y: Element) -> Element {
        let square = x.b * y.b;
        Element { a: x.a * y.a - self.stiffness * square, b: x.a * y.b + x.b * y.a - self.damping * square }
    }

    /// exp(tA) for every enclosed t, its middle apart, so that an interval of t is no wider than it must be.
    pub fn exp(self, t: Interval) -> Element {
        let middle = t.middle();
        self.times(self.series(middle), self.series(t - middle))
    }

    /// (exp(tA/2^j))^(2^j) with ‖tA/2^j‖ ≤ 1/4, by rows: ‖A‖ ≤ max(1, |k| + |c|).
    fn series(self, t: Interval) -> Element {
        let unknown = || Element { a: t.over(Interval::ZERO), b: t.over(Interval::ZERO) };
        let sizes = [self.damping, self.stiffness, t].map(Interval::magnitude_bits);
        let [Some(damping), Some(stiffness), Some(size)] = sizes else { return unknown() };
        // In units: |c| + |k| < 2^(larger + 1), so that ‖tA‖ < 2^(size + norm − 2·96), wanted at most 2^(−2).
        let norm = (damping.max(stiffness) + 1).max(96);
        let halvings = (size + norm + 2).saturating_sub(192);
        let t = t.shifted_down(halvings);
        // 1 + tA (1 + tA/2 (1 + tA/3 (…))), where A (a + bA) = −kb + (a − cb) A.
        let mut sum = Element { a: Interval::ONE, b: Interval::ZERO };
        for n in (1..=TERMS).rev() {
            let factor = t.divided(n);
            let a = Interval::ONE - factor * self.stiffness * sum.b;
            sum = Element { a, b: factor * (sum.a - self.damping * sum.b) };
        }
        // a and b are entries of the matrix, the rest's are below its norm.
        let sum = Element { a: sum.a.outwards(), b: sum.b.outwards() };
        (0..halvings).fold(sum, |x, _| self.times(x, x))
    }

    /// exp(tA) applied to (x, y).
    pub fn apply(self, e: Element, [x, y]: [Interval; 2]) -> [Interval; 2] {
        [e.a * x + e.b * y, (e.a - self.damping * e.b) * y - self.stiffness * e.b * x]
    }
}
