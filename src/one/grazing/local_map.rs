//! The local map at a grazing orbit: A, B, C, e, γ, a_G, from flow and saltation matrices.

use num_rational::BigRational;

use crate::{
    continuation::Multipliers,
    error::{Error, Result},
    local::Region,
    motion::{
        Flow,
        algebra::{IDENTITY, Matrix2, add, apply, product, resolve},
    },
    one::orbit::{Itinerary, Leg, Oscillator, Unknowns, flow_determinant},
    pattern::{Entry, Map},
};

/// (40)–(44) in the coordinates x = ±(q − Q, u − Q′) at the phase of grazing: C = (1, 0), B = (0,
/// √(2a_G)(1+τ))ᵀ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalMap {
    /// A: the linearisation of the grazing orbit's full period, its other impacts included.
    pub a: Matrix2,
    /// a₁ = λ₁ + λ₂ = tr A and a₂ = λ₁λ₂ = det A, the latter without cancellation.
    pub multipliers: Multipliers,
    /// a_G: the relative acceleration at the grazing point.
    pub acceleration: f64,
    /// τ of the wall that is grazed.
    pub restitution: f64,
    /// The derivative in the parameter of the orbit's x at the phase of grazing; the first entry is e (26).
    pub drift: [f64; 2],
}

/// How far entries may be off that were computed in floats: relative to the largest of A's.
const ERROR: f64 = 1e-12;

impl LocalMap {
    /// The map at a solution whose first impact has speed 0.
    pub(super) fn new(oscillator: &Oscillator, itinerary: &Itinerary, z: &[f64]) -> Result<LocalMap> {
        let strikes = itinerary.strikes();
        let touch = oscillator.touch(strikes[0].place, z[0])?;
        let (sign, graze) = (touch.wall.side.sign(), touch.leaving(z[0], 0.0));
        let (mut a, mut shift) = (IDENTITY, [0.0; 2]);
        for passage in Unknowns::new(itinerary, z)?.passages(oscillator) {
            let passage = passage?;
            let Leg { matrix, slope, .. } = passage.fly();
            a = product(&matrix, &a);
            shift = add(apply(&matrix, shift), slope);
            if passage.next != 0 {
                let (jump, slope) = passage.saltation();
                a = product(&jump, &a);
                shift = add(apply(&jump, shift), slope);
            }
        }
        // x̃ = A x̃ + shift, from which the wall's own motion is taken.
        let moved =
            resolve(&a, shift).ok_or_else(|| Error::input("det(I − A) = 0 at the grazing orbit (23)"))?;
        // The grazing impact itself does nothing: its factor τ² is left out.
        let flow = flow_determinant(oscillator, itinerary, z)?;
        Ok(LocalMap {
            a,
            multipliers: Multipliers::with(&a, flow, oscillator, &strikes[1..]),
            acceleration: sign * (oscillator.flow().acceleration(graze) - touch.motion[2]),
            restitution: touch.wall.restitution,
            drift: [0, 1].map(|i| sign * (moved[i] - touch.slope[i])),
        })
    }

    /// e: how fast the orbit's gap opens with the parameter (26).
    pub fn e(&self) -> f64 {
        self.drift[0]
    }

    /// γ = A₁₂ (44).
    pub fn gamma(&self) -> f64 {
        self.a[0][1]
    }

    /// √(2a_G)(1+τ): B's second entry; V = √(2a_G) y.
    pub fn kick(&self) -> f64 {
        self.speed_scale() * (1.0 + self.restitution)
    }

    pub(super) fn speed_scale(&self) -> f64 {
        (2.0 * self.acceleration).sqrt()
    }

    /// The region of (a₁, a₂), taken as they are computed; after reversing time if a₂ > 1. `None` for a₂ ≤ 0.
    pub fn region(&self) -> Option<Region> {
        Region::at(self.multipliers.trace, self.multipliers.determinant)
    }

    /// L = Π −C A^{n_i} B / (2 Y_i) of a pattern: the large eigenvalue is L (eµ)^{−m} to leading order (36),
    /// by (57) in floats; `None` on a singular boundary.
    pub fn leading(&self, periods: &[u64]) -> Option<f64> {
        let power = |n: u64| (0..n).fold(IDENTITY, |power, _| product(&self.a, &power));
        let powers: Vec<Matrix2> = periods.iter().map(|&n| power(n)).collect();
        let x = |a: &Matrix2| [-1.0, (a[0][0] - 1.0) / a[0][1]];
        let product: f64 = (0..powers.len())
            .map(|i| {
                let (a, next) = (&powers[i], &powers[(i + 1) % powers.len()]);
                let y = (x(next)[1] - apply(a, x(a))[1]) / self.kick();
                -a[0][1] * self.kick() / (2.0 * y)
            })
            .product();
        product.is_finite().then_some(product)
    }

    /// The map for the local theory, every computed entry widened by 10⁻¹² of the largest: far more than its
    /// error where Newton's method has converged, but no proof.
    ///
    /// # Errors
    /// An input error if a_G is not positive, and those of [`Map::new`].
    pub fn to_map(&self) -> Result<Map> {
        if self.acceleration.is_nan() || self.acceleration <= 0.0 {
            let message = format!("a_G = {} at the grazing point; it must be positive", self.acceleration);
            return Err(Error::input(message));
        }
        let largest = self.a.as_flattened().iter().fold(1.0, |most: f64, x| most.max(x.abs()));
        let wide = |x: f64| {
            let exact = |x: f64| BigRational::from_float(x).ok_or_else(|| Error::input("A is not finite"));
            let radius = ERROR * largest.max(x.abs());
            Entry::between(exact(x - radius)?, exact(x + radius)?)
        };
        let integer = |n: i32| Entry::from(BigRational::from_integer(n.into()));
        let a = self.a.iter().map(|row| row.iter().map(|&x| wide(x)).collect()).collect::<Result<_>>()?;
        Map::new(a, vec![integer(0), wide(self.kick())?], vec![integer(1), integer(0)], wide(self.e())?, None)
    }
}
