//! exp, and with it sin, cos and √: the exponential of one 2×2 matrix.
//!
//! The free motion q″ = −c q′ − k q is (q, q′)′ = A (q, q′) with A = [[0, 1], [−k, −c]], and A² = −cA − k. So
//! exp(tA) = a + bA for two numbers, found by the power series without any case: e^−ct/2 cos ωt and sin ωt
//! with ω = √(k − c²/4) if that is real, cosh and sinh if not. For c = 0 and k = 1 it is cos t + A sin t.
//! Entries: [[a, b], [−kb, a − cb]].

use super::{Interval, number::Number};

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

    /// For c = −1 and k = 0 it is 1 + (e^t − 1) A, A² = A.
    const GROWTH: Ring<N> = Ring { damping: N::MINUS_ONE, stiffness: N::ZERO };

    /// exp(tA) for every enclosed t, its middle apart, so that an interval of t is no wider than it must be.
    pub fn exp(self, t: N) -> Element<N> {
        if let Some(found) = self.by_roots(t) {
            return found;
        }
        let middle = N::constant(t.value().middle());
        self.times(self.series(middle), self.series(t - middle))
    }

    /// The same where c or k is an interval of some width, which the squares of the series would make wider
    /// each time: with ω² = k − c²/4 it is e^−ct/2 (cos ωt + sin ωt/ω (A + c/2)), or so in cosh and sinh;
    /// none where the sign of ω² is not certain.
    fn by_roots(self, t: N) -> Option<Element<N>> {
        let narrow = |x: N| {
            let x = x.value();
            (x - x.middle()).magnitude().is_below(Interval::ONE.shifted_down(60))
        };
        if narrow(self.damping) && narrow(self.stiffness) {
            return None;
        }
        let half = self.damping.shifted_down(1);
        let square = self.stiffness - half.squared();
        let growth = |x: N| {
            let e = Self::GROWTH.exp(x);
            e.a + e.b
        };
        let (even, odd) = if square.value().is_positive() {
            let omega = square.root();
            let (circle, decay) = (Self::CIRCLE.exp(omega * t), growth(-(half * t)));
            (decay * circle.a, (decay * circle.b).over(omega))
        } else if (-square.value()).is_positive() {
            let omega = (-square).root();
            let [up, down] = [omega - half, -omega - half].map(|rate| growth(rate * t));
            ((up + down).shifted_down(1), (up - down).shifted_down(1).over(omega))
        } else {
            return None;
        };
        Some(Element { a: even + half * odd, b: odd })
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
        let bend = along_t * (most_c + most_k + Interval::ONE) + most_t * (along_c + along_k);
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

    /// By roots all is enclosed that the series gives at points of the intervals, with its derivatives, and
    /// little else: some times what these move.
    #[test]
    fn roots_enclose_the_series() {
        let mut state = 5u64;
        let mut random = |below: i128| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            i128::from(state >> 33) % below
        };
        let (mut wave, mut growth) = (0, 0);
        for _ in 0..400 {
            let [c, k, t] = [random(2000), random(3000), random(20_000)];
            let [dc, dk] = [random(2000) - 1000, random(2000) - 1000];
            // Each number a thousandth, its slope too; wide by a millionth on both sides.
            let wide = Interval::ratio(1, 1_000_000);
            let dual = |x: i128, slope: i128, width: Interval| Dual {
                value: Interval::ratio(x, 1000).widened(width),
                slope: Interval::ratio(slope, 1000),
            };
            let ring = |width: Interval| Ring { damping: dual(c, dc, width), stiffness: dual(k, dk, width) };
            let time = dual(t, 0, Interval::ZERO);
            let Some(found) = ring(wide).by_roots(time) else { continue };
            (wave, growth) = if 4000 * k > c * c { (wave + 1, growth) } else { (wave, growth + 1) };
            for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
                let shift = |i: i128| Interval::ratio(i - 1, 1_100_000);
                let mut point = ring(Interval::ZERO);
                point.damping.value = point.damping.value + shift(i);
                point.stiffness.value = point.stiffness.value + shift(j);
                let series = point.exp(time);
                for (all, one) in [(found.a, series.a), (found.b, series.b)] {
                    let holds = |all: Interval, one: Interval| all.common(one) == Some(one);
                    assert!(
                        holds(all.value, one.value) && holds(all.slope, one.slope),
                        "{c} {k} {t}: {all:?} {one:?}"
                    );
                    let (width, critical) =
                        ((all.value - all.value.middle()).magnitude(), (4000 * k - c * c).abs() < 100_000);
                    assert!(critical || width.is_below(Interval::ratio(1, 200)), "{c} {k} {t}: {all:?}");
                }
            }
        }
        assert!(wave > 100 && growth > 30, "{wave} {growth}");
        assert!(Ring::<Dual>::CIRCLE.by_roots(Dual::ONE).is_none());
    }

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
