//! exp, and with it sin, cos and √: the exponential of one 2×2 matrix.
//!
//! The free motion q″ = −c q′ − k q is (q, q′)′ = A (q, q′) with A = [[0, 1], [−k, −c]], and A² = −cA − k. So
//! exp(tA) = a + bA for two numbers, found by the power series without any case: e^−ct/2 cos ωt and sin ωt
//! with ω = √(k − c²/4) if that is real, cosh and sinh if not. For c = 0 and k = 1 it is cos t + A sin t.
//! Entries: [[a, b], [−kb, a − cb]].

use super::number::Number;

/// The numbers a + bA for one A.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ring<N> {
    pub damping: N,
    pub stiffness: N,
}

/// a + bA.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Element<N> {
    pub a: N,
    pub b: N,
}

/// Terms of the power series: with x ≤ 1/4 the rest is below 2·4⁻²²/22! < 2⁻¹¹², far less than a unit.
const TERMS: i128 = 21;

impl<N: Number> Ring<N> {
    /// The circle: exp(tA) = cos t + A sin t.
    pub const CIRCLE: Ring<N> = Ring { damping: N::ZERO, stiffness: N::ONE };

    /// (a + bA)(a′ + b′A) = (aa′ − kbb′) + (ab′ + ba′ − cbb′) A.
    fn times(self, x: Element<N>, y: Element<N>) -> Element<N> {
        let square = x.b * y.b;
        Element { a: x.a * y.a - self.stiffness * square, b: x.a * y.b + x.b * y.a - self.damping * square }
    }

    /// exp(tA) for every enclosed t, its middle apart, so that an interval of t is no wider than it must be.
    pub fn exp(self, t: N) -> Element<N> {
        let middle = N::constant(t.value().middle());
        self.times(self.series(middle), self.series(t - middle))
    }

    /// (exp(tA/2^j))^(2^j) with ‖tA/2^j‖ ≤ 1/4, by rows: ‖A‖ ≤ max(1, |k| + |c|).
    fn series(self, t: N) -> Element<N> {
        let unknown = || Element { a: t.over(N::ZERO), b: t.over(N::ZERO) };
        let sizes = [self.damping, self.stiffness, t].map(|x| x.value().magnitude_bits());
        let [Some(damping), Some(stiffness), Some(size)] = sizes else { return unknown() };
        // In units: |c| + |k| < 2^(larger + 1), so that ‖tA‖ < 2^(size + norm − 2·96), wanted at most 2^(−2).
        let norm = (damping.max(stiffness) + 1).max(96);
        let halvings = (size + norm + 2).saturating_sub(192);
        let t = t.shifted_down(halvings);
        // 1 + tA (1 + tA/2 (1 + tA/3 (…))), where A (a + bA) = −kb + (a − cb) A.
        let mut sum = Element { a: N::ONE, b: N::ZERO };
        for n in (1..=TERMS).rev() {
            let factor = t.divided(n);
            let a = N::ONE - factor * self.stiffness * sum.b;
            sum = Element { a, b: factor * (sum.a - self.damping * sum.b) };
        }
        // a and b are entries of the matrix, the rest's are below its norm. With X = tA/2^j the rest's
        // derivative is Σ (X′X^(n−1) + …)/n! over n > 21, below ‖X′‖ (4⁻²¹/21! + …) < 2⁻¹⁰⁶ ‖X′‖, where ‖X′‖
        // ≤ |t′| ‖A‖ + |t| (|c′| + |k′|).
        let [most_t, most_c, most_k] = [t, self.damping, self.stiffness].map(|x| x.value().magnitude());
        let [along_t, along_c, along_k] = [t, self.damping, self.stiffness].map(|x| x.slope().magnitude());
        let bend = along_t * (most_c + most_k + super::Interval::ONE) + most_t * (along_c + along_k);
        let rest = bend.shifted_down(106);
        let sum = Element { a: sum.a.outwards(rest), b: sum.b.outwards(rest) };
        (0..halvings).fold(sum, |x, _| self.times(x, x))
    }

    /// The determinant of a + bA, which is a² − cab + kb².
    pub fn determinant(self, e: Element<N>) -> N {
        e.a.squared() - self.damping * e.a * e.b + self.stiffness * e.b.squared()
    }

    /// exp(tA) applied to (x, y).
    pub fn apply(self, e: Element<N>, [x, y]: [N; 2]) -> [N; 2] {
        [e.a * x + e.b * y, (e.a - self.damping * e.b) * y - self.stiffness * e.b * x]
    }
}

#[cfg(test)]
mod tests {
    use super::{
        super::{Interval, number::Dual},
        *,
    };

    /// Here nothing is rounded, so that what is seen is the rest of the series: in the derivative it grows
    /// with the speed at which the argument moves, 2²⁰.
    #[test]
    fn derivatives_hold_the_rest_of_the_series() {
        let t = Dual { value: Interval::ZERO, slope: Interval::integer(1 << 20) };
        let beyond = Ring::<Dual>::CIRCLE.series(t).b.slope - Interval::integer(1 << 20);
        let units = |n: i128| Interval::ratio(n, 1 << 96);
        // ‖X′‖ 4⁻²¹/21! for ‖X′‖ = 2²⁰ is above 2²⁰ 2⁻¹⁰⁸ = 2⁸ units of 2⁻⁹⁶.
        assert!(!beyond.is_within(units(1 << 8), Interval::ZERO));
        assert!(beyond.is_within(units(1 << 12), Interval::ZERO));
    }
}
