//! Krawczyk's test on boxes: a zero exists, is unique, or there is none.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::{Jet, Verdict};
use crate::{
    error::{Error, Result},
    number::{Ball, Precision, Real},
};

/// A map from Rⁿ to Rⁿ with derivatives, evaluated over a box.
pub(super) type Map<'a> = dyn Fn(&[Jet]) -> Result<Vec<Jet>> + 'a;

/// What the test says about the zeros of the map in a box.
#[derive(Debug)]
pub(super) enum Test {
    /// Exactly one, and it lies here.
    Unique(Vec<Ball>),
    /// None.
    Empty,
    /// Nothing.
    Open,
}

/// A square matrix of exact numbers that approximates an inverse.
pub(super) type Preconditioner = Vec<Vec<BigRational>>;

/// The zeros of `map` in the box of `radius` about `centre`: with C the preconditioner, y the centre and X
/// the box, all of them lie in K = y − C f(y) + (I − C f′(X))(X − y), and K inside X's interior proves that
/// there is exactly one.
pub(super) fn test(
    map: &Map,
    centre: &[BigRational],
    radius: &BigRational,
    inverse: &Preconditioner,
    precision: &Precision,
) -> Result<Test> {
    let region: Vec<Ball> =
        centre.iter().map(|y| Ball::between(&(y - radius), &(y + radius), precision)).collect();
    let image = image(map, centre, &region, inverse, precision)?;
    let mut inside = true;
    for (y, k) in centre.iter().zip(&image) {
        let Some((lo, hi)) = k.exact_bounds() else { return Ok(Test::Open) };
        if lo > y + radius || hi < y - radius {
            return Ok(Test::Empty);
        }
        inside &= lo > y - radius && hi < y + radius;
    }
    Ok(if inside { Test::Unique(tightened(map, image, inverse, precision)?) } else { Test::Open })
}

/// K. Cost: the map at a point and over the box, 2n³ operations.
fn image(
    map: &Map,
    centre: &[BigRational],
    region: &[Ball],
    inverse: &Preconditioner,
    precision: &Precision,
) -> Result<Vec<Ball>> {
    let n = centre.len();
    let exact = |value: &BigRational| Ball::ratio(value, precision);
    let points: Vec<Jet> = centre.iter().map(|y| Jet::constant(exact(y))).collect();
    let variables: Vec<Jet> =
        region.iter().enumerate().map(|(i, x)| Jet::variable(x.clone(), i, n, precision)).collect();
    let (residual, over) = (map(&points)?, map(&variables)?);
    let away: Vec<Ball> = region.iter().zip(centre).map(|(x, y)| x.clone() - &exact(y)).collect();
    let rows = inverse.iter().enumerate().map(|(i, row)| {
        let row: Vec<Ball> = row.iter().map(exact).collect();
        let mut value = exact(&centre[i]);
        for (c, f) in row.iter().zip(&residual) {
            value = value - &(c.clone() * &f.value);
        }
        for (j, away) in away.iter().enumerate() {
            let identity = Ball::integer(i32::from(i == j), precision);
            let product = row.iter().zip(&over).filter_map(|(c, f)| Some(c.clone() * f.slopes.get(j)?));
            value = value + &(product.fold(identity, |total, term| total - &term) * away);
        }
        value
    });
    Ok(rows.collect())
}

/// Images of images, as long as they shrink: each contains the zero.
fn tightened(
    map: &Map,
    mut region: Vec<Ball>,
    inverse: &Preconditioner,
    precision: &Precision,
) -> Result<Vec<Ball>> {
    loop {
        let centre: Vec<BigRational> = region.iter().filter_map(middle).collect();
        let next = image(map, &centre, &region, inverse, precision)?;
        let smaller = |(new, old): (&Ball, &Ball)| {
            Some(width(new)? * BigRational::from_integer(2.into()) < width(old)?)
        };
        if next.iter().zip(&region).any(|pair| smaller(pair) != Some(true)) {
            return Ok(region);
        }
        region = next;
    }
}

/// The midpoint, if anything is known.
pub(super) fn middle(x: &Ball) -> Option<BigRational> {
    let (lo, hi) = x.exact_bounds()?;
    Some((lo + hi) / BigRational::from_integer(2.into()))
}

/// The width, if anything is known.
pub(super) fn width(x: &Ball) -> Option<BigRational> {
    let (lo, hi) = x.exact_bounds()?;
    Some((hi - lo).abs())
}

/// A zero that is the only one in a box, with the box and what proved it.
pub(super) struct Search {
    pub centre: Vec<BigRational>,
    /// The box in which it is the only one has this radius.
    pub radius: BigRational,
    pub inverse: Preconditioner,
    pub found: Vec<Ball>,
}

/// Whether the map has exactly one zero, enclosed, or none in the box of `radius` about `centre`.
///
/// # Errors
/// Those of the map; an input error if the centre is not finite or the radius not positive.
pub(super) fn in_box(
    map: &Map,
    centre: &[f64],
    radius: &BigRational,
    precision: &Precision,
) -> Result<Verdict<Vec<Ball>>> {
    let centre: Option<Vec<BigRational>> = centre.iter().map(|&x| BigRational::from_float(x)).collect();
    let centre = centre.filter(|_| radius.is_positive());
    let centre = centre.ok_or_else(|| Error::input("a box has a finite centre and a positive radius"))?;
    let Some((_, inverse)) = linearised(map, &centre, precision)? else {
        return Ok(Verdict::Undecided("the equations' derivative is singular at the guess".into()));
    };
    Ok(match test(map, &centre, radius, &inverse, precision)? {
        Test::Unique(found) => Verdict::Proved(found),
        Test::Empty => Verdict::Refuted("the equations have no solution in the box".into()),
        Test::Open => Verdict::Undecided("Krawczyk's test says nothing about the box".into()),
    })
}

/// Zeros are enclosed within this much of a box's centre, 10⁻¹⁸, before they are enclosed more tightly.
pub(super) fn near() -> BigRational {
    BigRational::new(1.into(), 1_000_000_000_000_000_000i64.into())
}

impl Search {
    /// Finds a zero near the start by Newton's method, and the largest box of radius 1/2, 1/5, 1/10, … about
    /// it in which it is the only one.
    pub fn run(map: &Map, start: &[f64], precision: &Precision) -> Result<Verdict<Search>> {
        let Some((centre, inverse)) = newton(map, start, precision)? else {
            return Ok(Verdict::Undecided("Newton's method does not converge from this guess".into()));
        };
        let Test::Unique(found) = test(map, &centre, &near(), &inverse, precision)? else {
            return Ok(Verdict::Undecided("the approximate solution does not pass Krawczyk's test".into()));
        };
        // A large box may reach where the map is not defined: then a smaller one is tried.
        let unique = |radius: &BigRational| {
            matches!(test(map, &centre, radius, &inverse, precision), Ok(Test::Unique(_)))
        };
        let radius = radii().find(unique).unwrap_or_else(near);
        Ok(Verdict::Proved(Search { centre, radius, inverse, found }))
    }
}

/// 1/2, 1/5, 1/10, 1/20, … down to 10⁻¹².
pub(crate) fn radii() -> impl Iterator<Item = BigRational> {
    (0..12).flat_map(|power| {
        let ten = num_traits::pow(BigInt::from(10), power);
        [2, 5, 10].map(|part| BigRational::new(1.into(), &ten * part))
    })
}

/// A zero near `start` to about the precision, by Newton's method without any guarantee, and an approximate
/// inverse of the derivative there; `None` if it does not converge.
pub(super) fn newton(
    map: &Map,
    start: &[f64],
    precision: &Precision,
) -> Result<Option<(Vec<BigRational>, Preconditioner)>> {
    let Some(mut point) = start.iter().map(|&x| BigRational::from_float(x)).collect::<Option<Vec<_>>>()
    else {
        return Ok(None);
    };
    for _ in 0..STEPS {
        let Some((residual, inverse)) = linearised(map, &point, precision)? else { return Ok(None) };
        let mut largest = 0.0;
        for (x, row) in point.iter_mut().zip(&inverse) {
            let step: BigRational = row.iter().zip(&residual).map(|(c, f)| c * f).sum();
            largest = step.abs().to_f64().unwrap_or(f64::INFINITY).max(largest);
            *x = rounded(&(&*x - step), PLACES);
        }
        if largest < SMALL {
            return Ok(Some((point, inverse)));
        }
        if largest > LARGE {
            break;
        }
    }
    Ok(None)
}

/// The map at a point and an approximate inverse of its derivative there, without any guarantee; `None` if
/// there is none.
pub(super) fn linearised(
    map: &Map,
    point: &[BigRational],
    precision: &Precision,
) -> Result<Option<(Vec<BigRational>, Preconditioner)>> {
    let n = point.len();
    let variable = |(i, x): (usize, &BigRational)| Jet::variable(Ball::ratio(x, precision), i, n, precision);
    let values = map(&point.iter().enumerate().map(variable).collect::<Vec<_>>())?;
    let residual: Option<Vec<BigRational>> = values.iter().map(|value| middle(&value.value)).collect();
    let float = |x: &Ball| middle(x).and_then(|x| x.to_f64());
    let slopes = values.iter().map(|value| value.slopes.iter().map(float).collect());
    let inverse = slopes.collect::<Option<Vec<Vec<f64>>>>().and_then(invert);
    Ok(residual.zip(inverse))
}

/// Newton steps before giving up, the steps at which it has converged or is lost, and the decimals that are
/// kept.
const STEPS: u32 = 60;
const SMALL: f64 = 1e-22;
const LARGE: f64 = 1e9;
const PLACES: u32 = 24;
/// Decimals of a preconditioner's entries: it need only be near the inverse.
const COARSE: u32 = 9;

/// The nearest number of so many decimals.
pub(crate) fn rounded(x: &BigRational, places: u32) -> BigRational {
    let scale = BigRational::from_integer(num_traits::pow(BigInt::from(10), places as usize));
    (x * &scale).round() / scale
}

/// The inverse by Gauss and Jordan with partial pivoting, rounded to [`COARSE`] decimals; `None` if it is
/// singular.
fn invert(mut matrix: Vec<Vec<f64>>) -> Option<Preconditioner> {
    let n = matrix.len();
    for (i, row) in matrix.iter_mut().enumerate() {
        row.extend((0..n).map(|j| f64::from(i == j)));
    }
    for column in 0..n {
        let pivot =
            (column..n).max_by(|&a, &b| matrix[a][column].abs().total_cmp(&matrix[b][column].abs()))?;
        matrix.swap(column, pivot);
        let scale = matrix[column][column].recip();
        matrix[column].iter_mut().for_each(|x| *x *= scale);
        let above = matrix[column].clone();
        for (_, row) in matrix.iter_mut().enumerate().filter(|(i, _)| *i != column) {
            let factor = row[column];
            row.iter_mut().zip(&above).for_each(|(x, p)| *x -= factor * p);
        }
    }
    let exact = |x: &f64| Some(rounded(&BigRational::from_float(*x)?, COARSE));
    matrix.iter().map(|row| row[n..].iter().map(exact).collect()).collect()
}
