//! Which way a bifurcation of a machine's orbit goes: the coefficient of its normal form, by the Poincaré map
//! to third order on the centre manifold.
//!
//! The formulas are those of the one-degree chapter (`oscillator::orbit::Derivatives`, after Yu. A.
//! Kuznetsov), in 2n dimensions. No third derivative is ever a tensor: with A the linear part and q the
//! critical eigenvector, the map's image of the curve ξq has B(q,q)/2 at ξ², and that of ξq + ξ²h/2, h being
//! the centre manifold's bend, has C(q,q,q)/6 + B(q,h)/2 at ξ³, of which p takes the coefficient. For a pair
//! of complex multipliers it is the same with the surface 2 Re ζq.
//!
//! **The unit of ξ.** Signs of coefficients count; their sizes go with the length of q. Here that is counted
//! at the first impact that the critical motion moves, as √(δ² + (δV/V)²), δ being the impact's delay in
//! radians and δV the change of its speed: no unit of a scene enters. With ξ > 0 the impact comes later.
//!
//! Not here: where bifurcations are (`branch`).

use nalgebra::{Complex, DMatrix, DVector};

use super::{
    Machine, RealMatrix, RealVector,
    branch::Solved,
    orbit::{Change, Image, Orbit, StopEquations, Surface},
};
use crate::{
    continuation::{
        Bifurcation, Cubic, DOUBLE, Estimate, FollowedOrbit, NOT_SMOOTH, NoForm, NormalForm, Sense, UNKNOWN,
    },
    error::Error,
    motion::minimum::RELATIVE_DEPTH,
};

type ComplexVector = DVector<Complex<f64>>;
type ComplexMatrix = DMatrix<Complex<f64>>;

/// Left and right eigenvectors as nearly orthogonal as this are those of a double multiplier: the critical
/// direction is no direction of its own, and the coefficients have no meaning.
const PARALLEL: f64 = 1e-7;

/// Multipliers as close as this to the critical one are one with it: along a branch the parameter is exact to
/// rounding where the branch turns back, a multiplier to its square root.
const BESIDE: f64 = 1e-4;

/// The normal form of a bifurcation of an orbit of a machine, whose coefficients change with the parameter at
/// the rates `slope`. Cost: O(n³).
///
/// # Errors
/// Why there is none: where contact or friction changes the Poincaré map is not smooth, without impacts
/// it is linear, up to a drift it is not told, at a double multiplier the critical direction is no
/// direction of its own, and the map's derivatives are not followed through stops that give way, friction,
/// forces that are formulas or a restitution that depends on the speed.
pub fn normal_form(
    machine: &Machine<f64>,
    slope: &Machine<f64>,
    orbit: &Orbit,
    bifurcation: Bifurcation,
) -> Result<NormalForm, NoForm> {
    if matches!(bifurcation, Bifurcation::Grazing | Bifurcation::Fade) || bifurcation.is_sliding() {
        return Err(NOT_SMOOTH);
    }
    let unknown = |_: Error| UNKNOWN;
    let solved =
        Solved::new(machine, &orbit.itinerary, RELATIVE_DEPTH * orbit.scale, None).map_err(unknown)?;
    let equations = solved.equations(&orbit.itinerary, orbit.scale);
    let own = |i: usize| equations.contact(i).law.is_some();
    if equations.between.soft.is_some() || (0..orbit.impacts.len()).any(own) {
        return Err("none: through soft stops, friction, formulas or a law of restitution");
    }
    if equations.between.drifts.is_some() {
        return Err("none: the orbit comes back up to a drift");
    }
    if orbit.impacts.is_empty() {
        return Err("none: without impacts the map is linear");
    }
    let to = match bifurcation {
        Bifurcation::Flip => Some(-1.0),
        Bifurcation::SaddleNode | Bifurcation::Crossing => Some(1.0),
        _ => None,
    };
    // Rounding moves a double multiplier by its square root, so near ones cannot be told from it.
    let near = |to: f64| orbit.multipliers.iter().filter(|(re, im)| (re - to).hypot(*im) <= BESIDE).count();
    if to.is_some_and(|to| near(to) > 1) {
        return Err(DOUBLE);
    }
    let estimate = |number: &dyn Fn(&Local) -> Option<f64>| {
        let at = |z: &[f64]| number(&Local::new(equations, z).ok()?);
        Estimate::of(&orbit.z, |unknown| orbit.is_time(unknown), at).ok_or(UNKNOWN)
    };
    Ok(match bifurcation {
        Bifurcation::SaddleNode => {
            let change = Change::new(machine, slope, &solved.flow, &solved.contacts).map_err(unknown)?;
            // The side on which the two orbits are is the sign of this product, which needs no sense of p.
            let turn = estimate(&|local| {
                let (a, p) = local.fold()?;
                Some(a * p.dot(&local.equations.drift(&local.z, &change).ok()?))
            })?;
            estimate(&|local| Some(local.fold()?.0))?.fold(turn)
        }
        Bifurcation::Crossing => {
            let a = estimate(&|local| Some(local.fold()?.0))?;
            if !a.is_zero() {
                return Ok(NormalForm { coefficient: a.value, kind: Sense::Transcritical });
            }
            estimate(&|local| local.cubic(1.0))?.born(|c| c < 0.0)
        }
        Bifurcation::Flip => estimate(&|local| local.cubic(-1.0))?.born(|b| b > 0.0),
        _ => estimate(&|local| local.torus(&orbit.multipliers))?.born(|d| d < 0.0),
    })
}

/// The Poincaré map near an orbit.
pub(super) struct Local<'s> {
    equations: StopEquations<'s>,
    z: Vec<f64>,
    /// A.
    linear: RealMatrix,
}

impl<'s> Local<'s> {
    /// # Errors
    /// Those of [`StopEquations::monodromy`].
    pub fn new(equations: StopEquations<'s>, z: &[f64]) -> Result<Local<'s>, Error> {
        let linear = equations.between.flow.reduced(&equations.monodromy(z)?);
        Ok(Local { equations, z: z.to_vec(), linear })
    }

    /// a at a multiplier 1, and p.
    fn fold(&self) -> Option<(f64, RealVector)> {
        let (q, p) = self.eigenvectors(1.0)?;
        Some((self.square(&q, &p)?, p))
    }

    /// a at a multiplier 1, with ξ growing along a curve on which the unknowns change like this.
    pub fn fold_along(&self, change: &[f64]) -> Option<f64> {
        let (q, p) = self.eigenvectors(1.0)?;
        let along = q.dot(&self.equations.displacement(&self.z, change));
        Some(self.square(&q, &p)? * along.signum())
    }

    fn square(&self, q: &RealVector, p: &RealVector) -> Option<f64> {
        let none = RealVector::zeros(q.len());
        let image = self.image(&Surface::plane(q, &none))?;
        Some(p.dot(&image.surface.0.column(2))).filter(|a| a.is_finite())
    }

    /// c at a multiplier 1 where a = 0, b at a multiplier −1.
    pub fn cubic(&self, multiplier: f64) -> Option<f64> {
        let (q, p) = self.eigenvectors(multiplier)?;
        let none = RealVector::zeros(q.len());
        let line = Surface::plane(&q, &none);
        // B(q, q) less its part along q, which A − 1 does not reach.
        let mut bent = self.image(&line)?.surface.0.column(2) * 2.0;
        let mut resolved = RealMatrix::identity(q.len(), q.len()) - &self.linear;
        if multiplier > 0.0 {
            bent.axpy(-p.dot(&bent), &q, 1.0);
            // Along q the inverse may be anything: (I − A + q pᵀ) h = B gives p·h = 0.
            resolved += &q * p.transpose();
        }
        let h = resolved.lu().solve(&bent)?;
        let image = self.image(&line.bent(&(h / 2.0), &none, &none))?;
        Some(p.dot(&image.surface.0.column(5))).filter(|c| c.is_finite())
    }

    /// Re d at the pair of complex multipliers nearest to the unit circle.
    pub fn torus(&self, multipliers: &[(f64, f64)]) -> Option<f64> {
        let pairs = multipliers.iter().filter(|(_, im)| *im > 0.0);
        let off = |x: &(f64, f64)| (x.0.hypot(x.1) - 1.0).abs();
        let &(re, im) = pairs.min_by(|a, b| off(a).total_cmp(&off(b)))?;
        let lambda = Complex::new(re, im);
        let (q, p) = self.complex_eigenvectors(lambda)?;
        // ζq + its conjugate, ζ = x + iy.
        let plane = Surface::plane(&q.map(|z| 2.0 * z.re), &q.map(|z| -2.0 * z.im));
        let image = self.image(&plane)?.surface.0;
        let [xx, xy, yy] = [2, 3, 4].map(|j| image.column(j).into_owned());
        // B(q, q) and B(q, q̄): twice the coefficient of ζ², and that of ζζ̄.
        let double =
            ComplexVector::from_fn(q.len(), |i, _| Complex::new((xx[i] - yy[i]) / 2.0, -xy[i] / 2.0));
        let mean = (xx + yy) / 2.0;
        let a = self.linear.map(|x| Complex::new(x, 0.0));
        let square = lambda * lambda;
        let h = (ComplexMatrix::identity(q.len(), q.len()) * square - &a).lu().solve(&double)?;
        let g = (RealMatrix::identity(q.len(), q.len()) - &self.linear).lu().solve(&mean)?;
        // Re hζ² + gζζ̄.
        let [even, odd] = [h.map(|z| z.re), h.map(|z| -2.0 * z.im)];
        let image = self.image(&plane.bent(&(&g + &even), &odd, &(&g - &even)))?;
        // The coefficient of ζ²ζ̄ in x³, x²y, xy², y³.
        let weights = [(0.375, 0.0), (0.0, -0.125), (0.125, 0.0), (0.0, -0.375)];
        let sum: Complex<f64> = weights
            .iter()
            .enumerate()
            .map(|(j, (re, im))| {
                let column = image.surface.0.column(5 + j);
                let along = p.iter().zip(column.iter()).map(|(p, x)| p * *x).sum::<Complex<f64>>();
                along * Complex::new(*re, *im)
            })
            .sum();
        Some((sum / lambda).re).filter(|d| d.is_finite())
    }

    fn image(&self, surface: &Surface) -> Option<Image> {
        self.equations.image(&self.z, surface).ok()
    }

    /// q and p for a real eigenvalue near this: p·q = 1, q of length 1 as it is counted here.
    fn eigenvectors(&self, eigenvalue: f64) -> Option<(RealVector, RealVector)> {
        let (q, p) = self.complex_eigenvectors(Complex::new(eigenvalue, 0.0))?;
        Some((q.map(|z| z.re), p.map(|z| z.re)))
    }

    /// The same for any eigenvalue; no conjugates in the product.
    fn complex_eigenvectors(&self, eigenvalue: Complex<f64>) -> Option<(ComplexVector, ComplexVector)> {
        let a = self.linear.map(|x| Complex::new(x, 0.0));
        let mut q = eigenvector(&a, eigenvalue)?;
        let mut p = eigenvector(&a.transpose(), eigenvalue)?;
        if p.dot(&q).norm() <= PARALLEL {
            return None;
        }
        let plane = Surface::plane(&q.map(|z| z.re), &q.map(|z| z.im));
        let impacts = self.image(&plane)?.impacts;
        let linear = |one: &Cubic| Complex::new(one.coefficient(1, 0), one.coefficient(0, 1));
        let moved: Vec<[Complex<f64>; 2]> =
            impacts.iter().map(|one| [linear(&one.delay), linear(&one.speed) / one.speed.value()]).collect();
        let length = |[delay, faster]: &[Complex<f64>; 2]| delay.norm().hypot(faster.norm());
        let most = moved.iter().map(length).fold(0.0, f64::max);
        let first = moved.iter().find(|one| length(one) >= 1e-6 * most)?;
        // A direction that no impact sees has no nonlinear motion.
        if !(most > 1e-12 * q.norm() && most.is_finite()) {
            return None;
        }
        let later = if first[0].norm() > 1e-9 * length(first) { first[0] } else { first[1] };
        q *= later.conj() / later.norm() / length(first);
        let along = p.dot(&q);
        p /= along;
        Some((q, p))
    }
}

/// How far beside an eigenvalue inverse iteration begins, as parts of it: where rounding makes the matrix
/// singular all the same, the next does.
const SHIFTS: [f64; 3] = [1e-13, 3e-13, 1e-12];

/// The eigenvector of length 1 whose eigenvalue is nearest to this, by inverse iteration.
fn eigenvector(a: &ComplexMatrix, eigenvalue: Complex<f64>) -> Option<ComplexVector> {
    SHIFTS.iter().find_map(|by| nearest(a, eigenvalue * (1.0 + by)))
}

/// The same, for a number that is no eigenvalue.
fn nearest(a: &ComplexMatrix, shift: Complex<f64>) -> Option<ComplexVector> {
    let n = a.nrows();
    let lu = (a - ComplexMatrix::identity(n, n) * shift).lu();
    let mut x = ComplexVector::from_fn(n, |i, _| Complex::new(1.0 + (i as f64 * 0.618).fract(), 0.0));
    for _ in 0..4 {
        x = lu.solve(&x)?;
        let norm = x.iter().map(Complex::norm_sqr).sum::<f64>().sqrt();
        if !(norm > 0.0 && norm.is_finite()) {
            return None;
        }
        x /= Complex::new(norm, 0.0);
    }
    Some(x)
}

#[cfg(test)]
mod tests {
    use super::{Complex, ComplexMatrix, SHIFTS, eigenvector};

    /// Rounding puts an eigenvalue exactly where the iteration begins.
    #[test]
    fn an_eigenvector_is_found_where_the_shifted_matrix_is_singular() {
        for by in SHIFTS[..2].iter().chain(&[0.0]) {
            let number = |x: f64| Complex::new(x, 0.0);
            let at = number(-1.0) * (1.0 + by);
            let a = ComplexMatrix::from_row_slice(2, 2, &[at, number(1.0), number(0.0), number(-0.997)]);
            let x = eigenvector(&a, number(-1.0)).expect("an eigenvector");
            assert!((x[0].norm() - 1.0).abs() < 1e-12 && x[1].norm() < 1e-9, "{by}: {x}");
        }
    }
}
