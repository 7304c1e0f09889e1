//! Machines q″ + c q′ + k q = f(t) whose damping c and stiffness k are functions of some parameters, f with
//! period 2π.
//!
//! They turn by σ = √D per period, D = k − c²/4, and r = exp(−πc). On a cell, with slopes cᵢ, kᵢ that are
//! enclosed ([`Sloped`]), those of `expansion` are
//!
//! ```text
//! Dᵢ = kᵢ − c cᵢ/2,   r: −π cᵢ r,   θ: ±2π Dᵢ/(2σ)        c, r and σ anywhere on the cell
//! ```
//!
//! c and D are in their values by interval arithmetic and in those by the mean value theorem about the middle
//! of the cell, where both are exact. D ≤ 0 are the machines with real eigenvalues, in (0, 1) as k > 0.

use std::{collections::VecDeque, fmt::Debug, sync::Arc};

use num_rational::BigRational;
use num_traits::Signed;

use super::{
    cell::{At, Image, at_border, complex, half_width, nothing},
    expansion::{F, farthest, float, hull, short, widest},
    parameters::{Coordinates, ParameterBox},
    sloped::Sloped,
};
use crate::{
    error::{Error, Result},
    number::{Ball, Elementary, Precision, Real},
};

/// Damping c and stiffness k as functions of the parameters of a box.
pub trait Coefficients: Debug + Send + Sync {
    /// c and k where the parameters have these values, exactly.
    ///
    /// # Errors
    /// Where they are not defined, or not rational.
    fn at(&self, point: &[BigRational]) -> Result<[BigRational; 2]>;

    /// c and k on a cell.
    ///
    /// # Errors
    /// Where they are not defined.
    fn over(&self, cell: &[Sloped]) -> Result<[Sloped; 2]>;
}

/// Into how many cells a box is cut to see that its machines are covered.
const CELLS: usize = 1024;

impl ParameterBox {
    /// Machines of one degree of freedom, of mass 1 and with a drive of period 2π, that touch their stop once
    /// in it: c and k are functions of the parameters with these bounds, in this order. Beside one parameter
    /// they are given a second one, which is 0.
    ///
    /// # Errors
    /// An input error unless c ≥ 0 and k > 0 at all points, or where that is not shown; lower ends first.
    pub fn oscillator(of: Arc<dyn Coefficients>, bounds: &[[BigRational; 2]]) -> Result<ParameterBox> {
        let mut sides = bounds.to_vec();
        sides.resize(bounds.len().max(2), Default::default());
        let whole = ParameterBox::ordered(Coordinates::Oscillator(Functions(of)), sides)?;
        whole.check_covered()?;
        Ok(whole)
    }

    fn check_covered(&self) -> Result<()> {
        let Coordinates::Oscillator(Functions(of)) = &self.coordinates else { return Ok(()) };
        of.at(&self.middle())?;
        // The largest first.
        let mut open = VecDeque::from([self.clone()]);
        let mut cells = 0;
        while let Some(part) = open.pop_front() {
            cells += 1;
            let [c, k] = of.over(&parameters(&part, [None, None]))?;
            if c.value.lo() >= 0.0 && k.value.lo() > 0.0 {
                continue;
            }
            let [c, k] = of.at(&part.middle())?;
            let wrong = match () {
                () if c.is_negative() => Some(("damping", c, "at least 0")),
                () if !k.is_positive() => Some(("stiffness", k, "above 0")),
                () => None,
            };
            if let Some((what, value, least)) = wrong {
                return Err(Error::input(format!(
                    "the {what} is {value} for some machines; it must be {least}"
                )));
            }
            if cells + open.len() > CELLS || part.is_point() {
                return Err(Error::input(
                    "it is not shown that the damping is at least 0 and the stiffness above 0 for all machines",
                ));
            }
            // By its part of the box.
            let wide = |of: &ParameterBox, i: usize| &of.sides[i][1] - &of.sides[i][0];
            let mut axis = part.wide_axis(0);
            for i in axis + 1..part.sides.len() {
                if wide(&part, i) * wide(self, axis) > wide(&part, axis) * wide(self, i) {
                    axis = i;
                }
            }
            open.extend(part.halves(axis));
        }
        Ok(())
    }
}

/// Shared functions, the same if they are one and the same.
#[derive(Debug, Clone)]
pub(super) struct Functions(pub Arc<dyn Coefficients>);

impl PartialEq for Functions {
    fn eq(&self, other: &Functions) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// The parameters anywhere on a cell, two of them with their slopes.
fn parameters(of: &ParameterBox, sloped: [Option<usize>; 2]) -> Vec<Sloped> {
    let one = |(i, [lower, upper]): (usize, &[BigRational; 2])| {
        let value = hull(float(lower), float(upper));
        let place = sloped.iter().position(|axis| *axis == Some(i));
        place.map_or(Sloped::constant(value), |place| Sloped::parameter(place, value))
    };
    of.sides().enumerate().map(one).collect()
}

/// c and k on a cell, and the slopes of both in each parameter.
type Slopes = ([F; 2], Vec<[F; 2]>);

/// Slopes are found for two parameters at a time.
fn slopes(of: &dyn Coefficients, cell: &ParameterBox) -> Result<Slopes> {
    let count = cell.sides.len();
    let mut slopes = Vec::with_capacity(count);
    let mut values = [F::WHOLE; 2];
    for first in (0..count).step_by(2) {
        let [c, k] = of.over(&parameters(cell, [Some(first), Some(first + 1)]))?;
        values = [c.value, k.value];
        slopes.extend([0, 1].map(|i| [c.slope[i], k.slope[i]]).into_iter().take(count - first));
    }
    Ok((values, slopes))
}

/// Both enclose it.
fn meet(one: F, other: F) -> F {
    F::from_bounds(one.lo().max(other.lo()), one.hi().min(other.hi()))
}

/// The image of a box of machines, and whether γ > 0 on all of it.
pub(super) fn image(of: &dyn Coefficients, cell: &ParameterBox) -> (Image, Option<bool>) {
    let half: Vec<F> = cell.sides().map(half_width).collect();
    let (Ok(([c, k], by)), Ok([c0, k0])) = (slopes(of, cell), of.at(&cell.middle())) else {
        return (nothing(widest(half.iter().copied(), &half)), None);
    };
    let two = F::integer(2, &());
    let quarter = BigRational::new(1.into(), 4.into());
    let d0 = k0 - &c0 * &c0 * quarter;
    let squares = by.iter().map(|[by_c, by_k]| *by_k - &(c * by_c / &two));
    // About the middle, as far as slopes lead.
    let about = |middle: &BigRational, reach: F| float(middle) + &hull(-reach, reach);
    let damping = meet(c, about(&c0, farthest(by.iter().map(|[by_c, _]| *by_c), &half)));
    let square = meet(k - &(c * &c / &F::integer(4, &())), about(&d0, farthest(squares.clone(), &half)));
    if square.hi() <= 0.0 {
        return (Image::Two, Some(true));
    }
    let axis = widest(squares.clone(), &half);
    let precision = Precision::new(super::cell::BITS);
    let exact = |x: f64| BigRational::from_float(x).map(|x| Ball::ratio(&x, &precision));
    let Some((least, greatest)) = exact(square.lo().max(0.0)).zip(exact(square.hi())) else {
        return (nothing(axis), None);
    };
    // σ, in half turns.
    let half_turns = two * &hull(short(&least.sqrt()), short(&greatest.sqrt()));
    let real_too = square.lo() <= 0.0;
    let band = half_turns.lo().floor();
    if real_too || half_turns.lo() <= band || half_turns.hi() >= band + 1.0 {
        let gamma = (real_too && half_turns.hi() < 1.0).then_some(true);
        return (at_border(half_turns, band, real_too, axis), gamma);
    }
    let pi = Ball::pi(&precision);
    let (turn, once) = (two * &short(&pi), short(&pi));
    let decay = |c: &Ball| (-(pi.clone() * c)).exp(&precision);
    let Some((slow, fast)) = exact(damping.lo().max(0.0)).zip(exact(damping.hi())) else {
        return (nothing(axis), None);
    };
    let radius = hull(short(&decay(&slow)), short(&decay(&fast)));
    let slope = by.iter().zip(squares);
    let slope = slope.map(|([by_c, _], square)| [-(once * by_c * &radius), turn * &square / &half_turns]);
    let exactly = |x: &BigRational| Ball::ratio(x, &precision);
    let at = At {
        angle: pi.clone() * &Ball::integer(2, &precision) * &exactly(&d0).sqrt(),
        radius: decay(&exactly(&c0)),
    };
    complex(half, half_turns, band, slope.collect(), &at, radius, axis)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tolerance::{Partition, Spread, Statement, cell::Cell};

    /// c = 2ζρ and k = ρ² of the machine with these two parameters.
    #[derive(Debug)]
    struct Machine;

    impl Coefficients for Machine {
        fn at(&self, point: &[BigRational]) -> Result<[BigRational; 2]> {
            let [ratio, damping] = [&point[0], &point[1]];
            Ok([ratio * damping * BigRational::from_integer(2.into()), ratio * ratio])
        }

        fn over(&self, cell: &[Sloped]) -> Result<[Sloped; 2]> {
            let [ratio, damping] = [&cell[0], &cell[1]];
            Ok([Sloped::integer(2, &()) * ratio * damping, *ratio * ratio])
        }
    }

    fn q(p: i64, d: i64) -> BigRational {
        BigRational::new(p.into(), d.into())
    }

    fn boxes() -> impl Iterator<Item = [[BigRational; 2]; 2]> {
        let ratios = [(3, 10), (49, 100), (61, 100), (98, 100), (123, 100), (2, 1)];
        let dampings = [(0, 1), (1, 50), (1, 5), (9, 10), (101, 100)];
        let wide = [(1, 10_000), (1, 100), (1, 20)];
        ratios.into_iter().flat_map(move |r| {
            dampings.into_iter().flat_map(move |d| {
                wide.into_iter().map(move |(p, d1)| {
                    let (ratio, damping) = (q(r.0, r.1), q(d.0, d.1));
                    let more = |x: &BigRational| x + q(p, d1);
                    [[ratio.clone(), more(&ratio)], [damping.clone(), more(&damping)]]
                })
            })
        })
    }

    /// The same machines in frequency ratio and damping ratio, by `cell`'s own formulas: no sign contradicts
    /// another, and few are open in one and not in the other.
    #[test]
    fn machines_have_the_signs_of_their_own_coordinates() {
        let mut told = [0, 0];
        for bounds in boxes() {
            let own = ParameterBox::machine(bounds[0].clone(), bounds[1].clone()).unwrap();
            let same = ParameterBox::oscillator(Arc::new(Machine), &bounds).unwrap();
            let [own, same] = [&own, &same].map(Cell::new);
            let mut agree = |one: Option<bool>, other: Option<bool>, what: &str| {
                assert!(one.is_none() || other.is_none() || one == other, "{what} {bounds:?}");
                told[0] += usize::from(one.is_some());
                told[1] += usize::from(other.is_some());
            };
            let positive =
                |sign: Option<crate::number::Sign>| sign.map(|sign| sign == crate::number::Sign::Positive);
            agree(own.gamma, same.gamma, "gamma");
            for n in 1..12 {
                agree(positive(own.u(n)), positive(same.u(n)), "u");
                for k in 1..n {
                    agree(positive(own.numerator(n, k)), positive(same.numerator(n, k)), "N");
                }
            }
        }
        assert!(told[0] > 3000 && told[1] * 100 > told[0] * 95, "{told:?}");
    }

    #[test]
    fn shares_are_those_of_the_same_machines() {
        let bounds = [[q(12_177, 10_000), q(12_423, 10_000)], [q(16, 1000), q(24, 1000)]];
        let own = ParameterBox::machine(bounds[0].clone(), bounds[1].clone()).unwrap();
        let same = ParameterBox::oscillator(Arc::new(Machine), &bounds).unwrap();
        let [own, same] = [own, same]
            .map(|of| Partition::new(&of, 2000, &()).unwrap().share(Statement::ChaosAt { positive: true }));
        assert_eq!(same.spread(), Spread::Differs);
        assert!(own.lower <= same.upper && same.lower <= own.upper);
        assert!(&same.upper - &same.lower < q(1, 100), "{} {}", same.lower, same.upper);
    }

    #[test]
    fn machines_that_are_not_covered_are_refused() {
        let at = |ratio: [BigRational; 2], damping: [BigRational; 2]| {
            ParameterBox::oscillator(Arc::new(Machine), &[ratio, damping]).map_err(|error| error.to_string())
        };
        assert!(at([q(1, 2), q(1, 1)], [q(0, 1), q(1, 10)]).is_ok());
        let error = at([q(1, 2), q(1, 1)], [q(-1, 10), q(1, 100)]).unwrap_err();
        assert!(error.contains("damping is -"), "{error}");
        let error = at([q(0, 1), q(1, 1)], [q(1, 10), q(1, 5)]).unwrap_err();
        assert!(error.contains("it is not shown"), "{error}");
        assert!(at([q(1, 1), q(1, 2)], [q(0, 1), q(0, 1)]).is_err());
    }
}
