//! A machine as a linear system without forcing: time goes along in the state, as cos kt and sin kt.
//!
//! Y = (q, q′, 1, cos k₁t, sin k₁t, …) with Y′ = A Y, k₁, … all multiples in forces and stops. The gap to a
//! stop is a functional of Y, and so are its derivatives.

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::linear::{self, Matrix, apply, dot};
use crate::{
    certificate::machine::{self as listed, Decimal, Range},
    error::{Error, Result},
    number::{Ball, Elementary, FloatInterval, Plain, Precision, Real},
};

/// Bits of the balls.
const BITS: u32 = 192;

/// The system over one kind of number.
pub(super) struct Motion<T: Real> {
    /// n.
    pub(crate) size: usize,
    pub(crate) context: T::Context,
    /// A.
    a: Matrix<T>,
    /// The multiples k.
    multiples: Vec<i32>,
    /// For each stop: the functional that is its gap, and (1 + τ) M⁻¹wᵀ/(w M⁻¹wᵀ).
    pub(crate) stops: Vec<(Vec<T>, Vec<T>)>,
    /// A bound of the norm of A, about.
    norm: f64,
    /// Terms of the exponential's series.
    terms: i32,
}

/// Half the sum of both ends.
pub(super) fn middle(x: &Range) -> BigRational {
    (exact(&x.lower) + exact(&x.upper)) / BigRational::from_integer(2.into())
}

/// What a decimal is.
pub(super) fn exact(x: &Decimal) -> BigRational {
    BigRational::new(x.digits.into(), num_traits::pow(10.into(), x.places as usize))
}

impl Motion<Ball> {
    /// The machine in the middle of a certificate's intervals.
    ///
    /// # Errors
    /// An input error for a singular mass matrix or a stop that no motion reaches.
    pub(crate) fn new(machine: &listed::Machine) -> Result<Motion<Ball>> {
        let n = machine.size();
        let context = Precision::new(BITS);
        let ball = |x: &BigRational| Ball::ratio(x, &context);
        let rows = |rows: &[Vec<Range>]| -> Matrix<BigRational> {
            rows.iter().map(|row| row.iter().map(middle).collect()).collect()
        };
        let list = |list: &[Range]| -> Vec<BigRational> { list.iter().map(middle).collect() };
        let lower = rows(&machine.mass);
        let mass: Matrix<BigRational> =
            (0..n).map(|i| (0..n).map(|j| lower[i.max(j)][i.min(j)].clone()).collect()).collect();
        let size =
            |x: &BigRational| if x.is_zero() { 0.0 } else { x.abs().to_f64().unwrap_or(1.0).max(1e-300) };
        let inverse =
            linear::inverse(&mass, size, &()).ok_or_else(|| Error::input("the mass is singular"))?;
        let mut multiples: Vec<u64> = machine.forcing.iter().map(|load| load.k).collect();
        multiples.extend(machine.stops.iter().flat_map(|stop| &stop.harmonics).map(|h| h.k));
        multiples.sort_unstable();
        multiples.dedup();
        // The state is (q, q′, 1, cos k t, sin k t, …): with these beside it the motion is that of one
        // constant matrix.
        let place = |k: u64| 2 * n + 1 + 2 * multiples.iter().position(|&known| known == k).unwrap_or(0);
        let d = 2 * n + 1 + 2 * multiples.len();
        let two = ball(&BigRational::from_integer(2.into()));
        let unit = ball(&middle(&machine.period)) / &(Ball::pi(&context) * &two);
        let square = unit.clone() * &unit;
        let zero = Ball::integer(0, &context);
        let mut a = vec![vec![zero.clone(); d]; d];
        let stiffness = linear::times(&inverse, &rows(&machine.stiffness), &());
        let damping = linear::times(&inverse, &rows(&machine.damping), &());
        let accelerate = |force: &[Range]| apply(&inverse, &list(force), &());
        let constant = accelerate(&machine.force);
        for i in 0..n {
            a[i][n + i] = Ball::integer(1, &context);
            for j in 0..n {
                a[n + i][j] = -ball(&stiffness[i][j]) * &square;
                a[n + i][n + j] = -ball(&damping[i][j]) * &unit;
            }
            a[n + i][2 * n] = ball(&constant[i]) * &square;
        }
        for load in &machine.forcing {
            let (cos, sin, at) = (accelerate(&load.cos), accelerate(&load.sin), place(load.k));
            for i in 0..n {
                a[n + i][at] = a[n + i][at].clone() + &(ball(&cos[i]) * &square);
                a[n + i][at + 1] = a[n + i][at + 1].clone() + &(ball(&sin[i]) * &square);
            }
        }
        for &k in &multiples {
            let (at, k) = (place(k), Ball::integer(k as i32, &context));
            (a[at][at + 1], a[at + 1][at]) = (-k.clone(), k);
        }
        let stop = |stop: &listed::Stop| {
            let row = list(&stop.row);
            let push = apply(&inverse, &row, &());
            let mobility = dot(&row, &push, &());
            if mobility.is_zero() {
                return Err(Error::input("a stop's row is zero"));
            }
            let factor = (BigRational::from_integer(1.into()) + middle(&stop.restitution)) / mobility;
            let mut gap = vec![zero.clone(); d];
            row.iter().enumerate().for_each(|(i, w)| gap[i] = ball(w));
            gap[2 * n] = -ball(&middle(&stop.offset));
            for h in &stop.harmonics {
                let at = place(h.k);
                gap[at] = gap[at].clone() - &ball(&middle(&h.cos));
                gap[at + 1] = gap[at + 1].clone() - &ball(&middle(&h.sin));
            }
            Ok((gap, push.iter().map(|x| ball(&(x * &factor))).collect()))
        };
        let stops = machine.stops.iter().map(stop).collect::<Result<_>>()?;
        let multiples = multiples.iter().map(|&k| k as i32).collect();
        let sum = |row: &Vec<Ball>| row.iter().map(|x| float(x).abs()).sum::<f64>();
        let norm = a.iter().map(sum).fold(0.0, f64::max);
        Ok(Motion { size: n, context, a, multiples, stops, norm, terms: 32 })
    }

    /// The same over other numbers.
    fn mapped<T: Real>(&self, context: T::Context, one: impl Fn(&Ball) -> T) -> Motion<T> {
        let list = |list: &Vec<Ball>| list.iter().map(&one).collect::<Vec<T>>();
        Motion {
            size: self.size,
            a: self.a.iter().map(list).collect(),
            multiples: self.multiples.clone(),
            stops: self.stops.iter().map(|(gap, kick)| (list(gap), list(kick))).collect(),
            norm: self.norm,
            terms: 18,
            context,
        }
    }

    /// In floats.
    pub(crate) fn plain(&self) -> Motion<Plain> {
        self.mapped((), |x| Plain(float(x)))
    }

    /// In intervals of floats.
    pub(crate) fn intervals(&self) -> Motion<FloatInterval> {
        self.mapped((), |x| {
            let Some((lo, hi)) = x.exact_bounds() else { return FloatInterval::WHOLE };
            FloatInterval::from_bounds(
                FloatInterval::ratio(&lo, &()).lo(),
                FloatInterval::ratio(&hi, &()).hi(),
            )
        })
    }
}

/// The middle of a ball.
pub(super) fn float(x: &Ball) -> f64 {
    let middle =
        |(lo, hi): (BigRational, BigRational)| ((lo + hi) / BigRational::from_integer(2.into())).to_f64();
    x.exact_bounds().and_then(middle).unwrap_or(f64::NAN)
}

impl<T: Real> Motion<T> {
    /// exp(τA), |τ| being at most about `most`.
    pub(crate) fn flow(&self, tau: &T, most: f64) -> Matrix<T> {
        linear::exp(&self.a, tau, self.norm * most, self.terms, &self.context)
    }

    /// A Y.
    pub(crate) fn field(&self, y: &[T]) -> Vec<T> {
        apply(&self.a, y, &self.context)
    }

    /// Y at phase t.
    pub(crate) fn lifted(&self, state: &[T], t: &T, most: f64) -> Vec<T> {
        let integer = |x: i32| T::integer(x, &self.context);
        let mut y = state.to_vec();
        y.push(integer(1));
        for &k in &self.multiples {
            let turn = vec![vec![integer(0), integer(-k)], vec![integer(k), integer(0)]];
            let turned = linear::exp(&turn, t, f64::from(k) * most, self.terms, &self.context);
            y.extend([turned[0][0].clone(), turned[1][0].clone()]);
        }
        y
    }

    /// The gap to a stop and its rate.
    pub(crate) fn gap(&self, stop: usize, y: &[T]) -> [T; 2] {
        let gap = &self.stops[stop].0;
        [dot(gap, y, &self.context), dot(gap, &self.field(y), &self.context)]
    }

    /// Y just after an impact.
    pub(crate) fn kicked(&self, stop: usize, y: &[T]) -> Vec<T> {
        let [_, rate] = self.gap(stop, y);
        let mut after = y.to_vec();
        for (u, kick) in after[self.size..2 * self.size].iter_mut().zip(&self.stops[stop].1) {
            *u = u.clone() - &(kick.clone() * &rate);
        }
        after
    }
}
