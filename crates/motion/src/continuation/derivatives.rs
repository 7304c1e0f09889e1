//! Coefficients of the normal forms at bifurcations of a fixed point of a plane map, from its Taylor
//! expansion.
//!
//! With A the linear part, B and C the second and third derivatives, q the critical eigenvector of length 1
//! and p the left one, p·q = 1 (Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory, 5.4):
//!
//! ```text
//! fold             ξ ↦ ξ + a ξ²,      a = p·B(q,q)/2
//! pitchfork        ξ ↦ ξ + c ξ³,      c = p·(C(q,q,q) + 3 B(q,h))/6,   h = (I − A)⁻¹ B(q,q) off q
//! flip             ξ ↦ −ξ + b ξ³,     b = p·(C(q,q,q) + 3 B(q,h))/6,   h = (I − A)⁻¹ B(q,q)
//! Neimark–Sacker   ζ ↦ e^{iθ} ζ (1 + d |ζ|²),
//!     Re d = Re( e^{−iθ} p̄·(C(q,q,q̄) + 2 B(q,(I−A)⁻¹B(q,q̄)) + B(q̄,(e^{2iθ}I−A)⁻¹B(q,q))) )/2
//! ```
//!
//! What is born is stable (supercritical) if c < 0, b > 0 or Re d < 0 and the other multiplier is inside the
//! unit circle. A different scale of q multiplies a coefficient by a positive number, or a by any number:
//! signs count, sizes go with the coordinates. Not here: the expansion itself (`return_map`).

use super::Cubic;
use crate::motion::algebra::{add, divide, scale, times};

/// Which way an orbit's bifurcation goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Criticality {
    /// What is born is as stable as the orbit was: the change is soft.
    Supercritical,
    /// What meets the orbit is unstable: the change is hard.
    Subcritical,
}

impl Criticality {
    /// Its name.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Criticality::Supercritical => "supercritical",
            Criticality::Subcritical => "subcritical",
        }
    }
}

/// A complex number.
type Complex = [f64; 2];

/// The derivatives of a plane map at a fixed point.
pub struct Derivatives([Cubic; 2]);

impl Derivatives {
    /// Those of an expansion.
    pub fn of(map: &[Cubic; 2]) -> Derivatives {
        Derivatives(*map)
    }

    /// Each coefficient times a factor of its own, in the order of [`Cubic::of`], the first row's before the
    /// second's.
    #[must_use]
    pub(crate) fn scaled(self, factors: &[f64]) -> Derivatives {
        let mut factors = factors.iter();
        let mut next = |x: f64| factors.next().map_or(x, |factor| factor * x);
        Derivatives(self.0.map(|row| Cubic::of(row.coefficients().map(&mut next))))
    }

    /// A.
    pub fn linear(&self) -> [[f64; 2]; 2] {
        self.0.map(|row| [row.coefficient(1, 0), row.coefficient(0, 1)])
    }

    /// B(u, v), bilinear and symmetric.
    fn second(&self, u: [Complex; 2], v: [Complex; 2]) -> [Complex; 2] {
        self.0.map(|row| {
            let mixed = add(times(u[0], v[1]), times(u[1], v[0]));
            let terms = [
                (2.0 * row.coefficient(2, 0), times(u[0], v[0])),
                (row.coefficient(1, 1), mixed),
                (2.0 * row.coefficient(0, 2), times(u[1], v[1])),
            ];
            terms.into_iter().fold([0.0; 2], |sum, (factor, term)| add(sum, scale(term, factor)))
        })
    }

    /// C(u, v, w), trilinear and symmetric.
    fn third(&self, u: [Complex; 2], v: [Complex; 2], w: [Complex; 2]) -> [Complex; 2] {
        let product = |i: usize, j: usize, k: usize| times(times(u[i], v[j]), w[k]);
        let one = add(add(product(1, 0, 0), product(0, 1, 0)), product(0, 0, 1));
        let two = add(add(product(1, 1, 0), product(1, 0, 1)), product(0, 1, 1));
        self.0.map(|row| {
            let terms = [
                (6.0 * row.coefficient(3, 0), product(0, 0, 0)),
                (2.0 * row.coefficient(2, 1), one),
                (2.0 * row.coefficient(1, 2), two),
                (6.0 * row.coefficient(0, 3), product(1, 1, 1)),
            ];
            terms.into_iter().fold([0.0; 2], |sum, (factor, term)| add(sum, scale(term, factor)))
        })
    }

    /// q and p for an eigenvalue λ: A q = λ q, pᵀA = λ pᵀ, |q| = 1, pᵀq = 1; no conjugates in the products.
    fn eigenvectors(&self, eigenvalue: Complex) -> Option<([Complex; 2], [Complex; 2])> {
        let a = self.linear();
        let less = |i: usize| add([a[i][i], 0.0], scale(eigenvalue, -1.0));
        let real = |x: f64| [x, 0.0];
        let longer = |x: [Complex; 2], y: [Complex; 2]| if length(x) >= length(y) { x } else { y };
        // Normal to a row, or to a column, of A − λ: to the longer one.
        let q = longer([real(a[0][1]), scale(less(0), -1.0)], [scale(less(1), -1.0), real(a[1][0])]);
        let p = longer([real(a[1][0]), scale(less(0), -1.0)], [scale(less(1), -1.0), real(a[0][1])]);
        let size = length(q);
        let q = q.map(|x| scale(x, 1.0 / size));
        let along = dot(p, q);
        let p = p.map(|x| divide(x, along));
        let finite = q.iter().chain(&p).flatten().all(|x| x.is_finite());
        finite.then_some((q, p))
    }

    /// a at a multiplier 1.
    pub(crate) fn fold(&self) -> Option<f64> {
        let (q, p) = self.eigenvectors([1.0, 0.0])?;
        Some(dot(p, self.second(q, q))[0] / 2.0).filter(|a| a.is_finite())
    }

    /// a at a multiplier 1, the direction of q chosen so that it does not jump along a curve of folds (but
    /// where a column of A − I vanishes).
    pub(crate) fn fold_along(&self) -> Option<f64> {
        let (a, (q, _)) = (self.linear(), self.eigenvectors([1.0, 0.0])?);
        let (along, fold) = (q[0][0] * a[0][1] + q[1][0] * (1.0 - a[0][0]), self.fold()?);
        Some(fold.copysign(fold * along))
    }

    /// p, the left eigenvector of the multiplier 1.
    pub(crate) fn fold_normal(&self) -> Option<[f64; 2]> {
        Some(self.eigenvectors([1.0, 0.0])?.1.map(|x| x[0]))
    }

    /// c at a multiplier 1 where a = 0.
    pub(crate) fn pitchfork(&self) -> Option<f64> {
        let (q, p) = self.eigenvectors([1.0, 0.0])?;
        let bent = self.second(q, q);
        // B(q, q) less its part along q is an eigenvector of the other multiplier.
        let along = dot(p, bent);
        let off = [0, 1].map(|i| add(bent[i], scale(times(along, q[i]), -1.0)));
        let a = self.linear();
        let other = a[0][0] + a[1][1] - 1.0;
        let h = off.map(|x| scale(x, 1.0 / (1.0 - other)));
        self.cubic(q, p, h)
    }

    /// b at a multiplier −1.
    pub(crate) fn flip(&self) -> Option<f64> {
        let (q, p) = self.eigenvectors([-1.0, 0.0])?;
        let h = self.resolve([1.0, 0.0], self.second(q, q))?;
        self.cubic(q, p, h)
    }

    fn cubic(&self, q: [Complex; 2], p: [Complex; 2], h: [Complex; 2]) -> Option<f64> {
        let sum = add(dot(p, self.third(q, q, q)), scale(dot(p, self.second(q, h)), 3.0));
        Some(sum[0] / 6.0).filter(|c| c.is_finite())
    }

    /// Re d at multipliers e^{±iθ}, θ not 0, π, 2π/3 or π/2.
    pub(crate) fn torus(&self) -> Option<f64> {
        let a = self.linear();
        let cos = (a[0][0] + a[1][1]) / 2.0;
        let eigenvalue = [cos, (1.0 - cos * cos).max(0.0).sqrt()];
        let (q, p) = self.eigenvectors(eigenvalue)?;
        let conjugate = q.map(|x| [x[0], -x[1]]);
        let mean = self.resolve([1.0, 0.0], self.second(q, conjugate))?;
        let double = self.resolve(times(eigenvalue, eigenvalue), self.second(q, q))?;
        let sum = add(
            add(dot(p, self.third(q, q, conjugate)), scale(dot(p, self.second(q, mean)), 2.0)),
            dot(p, self.second(conjugate, double)),
        );
        let turned = times([eigenvalue[0], -eigenvalue[1]], sum);
        Some(turned[0] / 2.0).filter(|d| d.is_finite())
    }

    /// (μ I − A)⁻¹ b.
    fn resolve(&self, mu: Complex, b: [Complex; 2]) -> Option<[Complex; 2]> {
        let a = self.linear();
        let m = [0, 1].map(|i| {
            [0, 1].map(|j| {
                let entry = [-a[i][j], 0.0];
                if i == j { add(mu, entry) } else { entry }
            })
        });
        let difference = |x: Complex, y: Complex| add(x, scale(y, -1.0));
        let det = difference(times(m[0][0], m[1][1]), times(m[0][1], m[1][0]));
        let found = [
            divide(difference(times(m[1][1], b[0]), times(m[0][1], b[1])), det),
            divide(difference(times(m[0][0], b[1]), times(m[1][0], b[0])), det),
        ];
        found.iter().flatten().all(|x| x.is_finite()).then_some(found)
    }
}

fn dot(a: [Complex; 2], b: [Complex; 2]) -> Complex {
    add(times(a[0], b[0]), times(a[1], b[1]))
}

fn length(a: [Complex; 2]) -> f64 {
    a.iter().flatten().map(|x| x * x).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The map with these coefficients of (x, y, x², xy, y², x³, x²y, xy², y³).
    fn map(rows: [[f64; 9]; 2]) -> Derivatives {
        const PLACES: [(usize, usize); 9] =
            [(1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3)];
        let row = |row: [f64; 9]| {
            let zero = Cubic::constant(0.0);
            PLACES.into_iter().zip(row).fold(zero, |sum, ((i, j), value)| sum.with(i, j, value))
        };
        Derivatives::of(&rows.map(row))
    }

    #[test]
    fn maps_of_one_variable_have_the_textbook_coefficients() {
        // x ↦ λ x + a₂x² + a₃x³, y ↦ y/3.
        let one = |linear: f64, two: f64, three: f64| {
            map([
                [linear, 0.0, two, 0.0, 0.0, three, 0.0, 0.0, 0.0],
                [0.0, 1.0 / 3.0, 0., 0., 0., 0., 0., 0., 0.],
            ])
        };
        // f(f(x)) = x − 2(a₂² + a₃)x³ + …, so b = a₂² + a₃.
        assert_eq!(one(-1.0, 2.0, 0.5).flip(), Some(4.5));
        assert_eq!(one(1.0, -0.75, 0.0).fold(), Some(-0.75));
        assert_eq!(one(1.0, 0.0, -0.25).pitchfork(), Some(-0.25));
    }

    #[test]
    fn the_other_direction_takes_part_as_the_centre_manifold_says() {
        // x ↦ ∓x + xy, y ↦ μ y + x²: on the centre manifold y = x²/(1 − μ), so the cubic term is 1/(1 − μ).
        for (linear, other) in [(-1.0, 0.5), (1.0, 0.5), (-1.0, -0.25)] {
            let found = map([
                [linear, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                [0.0, other, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            ]);
            let found = if linear < 0.0 { found.flip() } else { found.pitchfork() };
            assert!((found.unwrap() - 1.0 / (1.0 - other)).abs() < 1e-15);
        }
    }

    #[test]
    fn the_delayed_logistic_map_has_a_stable_circle() {
        // (x, y) ↦ (2x(1 − y), x) at its fixed point (1/2, 1/2): θ = π/3. In Kuznetsov's coordinates, in
        // which |q|² = 2, Re d = −2.
        let found =
            map([[1.0, -1.0, 0.0, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0], [1.0, 0., 0., 0., 0., 0., 0., 0., 0.]]);
        let value = found.torus().unwrap();
        assert!((value + 1.0).abs() < 1e-14, "{value}");
    }
}
