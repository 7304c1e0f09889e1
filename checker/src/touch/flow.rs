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

    /// E(t) for every enclosed t, its middle apart, so that an interval of t is no wider than it must be.
    pub fn exp(self, t: Interval) -> Matrix {
        #[cfg(test)]
        EXPONENTIALS.set(EXPONENTIALS.get() + 1);
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
