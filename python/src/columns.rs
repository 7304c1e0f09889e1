//! The numbers of many points, as arrays and lists from Python, each as the exact number that it stands for.

use grazing_scenes::{
    Error, Result,
    num_bigint::BigInt,
    num_rational::BigRational,
    number::{Angle, Circular, FloatInterval, Real, parse_rational},
};
use numpy::PyReadonlyArray1;
use pyo3::{exceptions::PyValueError, prelude::*};

use crate::exact::Exact;

/// 2⁶¹.
const ONE: f64 = (1u64 << 61) as f64;

/// Numbers one after the other, or one for all: `("binary", floats)`, `("decimal", floats)`, `("pairs",
/// (numerators, denominators))` or `("exact", list)`.
pub enum Column<'py> {
    /// Each the binary fraction that the float is.
    Binary(PyReadonlyArray1<'py, f64>),
    /// Each the float's shortest decimal.
    Decimal(PyReadonlyArray1<'py, f64>),
    /// Numerators and denominators.
    Pairs(PyReadonlyArray1<'py, i64>, PyReadonlyArray1<'py, i64>),
    /// As for a single point.
    Exact(Vec<Exact>),
}

impl<'a, 'py> FromPyObject<'a, 'py> for Column<'py> {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Column<'py>> {
        let (kind, numbers): (String, Bound<'py, PyAny>) = object.extract()?;
        Ok(match kind.as_str() {
            "binary" => Column::Binary(numbers.extract()?),
            "decimal" => Column::Decimal(numbers.extract()?),
            "pairs" => {
                let (numerators, denominators) = numbers.extract()?;
                Column::Pairs(numerators, denominators)
            }
            "exact" => Column::Exact(numbers.extract()?),
            other => return Err(PyValueError::new_err(format!("{other:?} is no kind of column"))),
        })
    }
}

impl Column<'_> {
    /// The numbers, which other threads can read.
    pub fn numbers(&self) -> PyResult<Numbers<'_>> {
        Ok(match self {
            Column::Binary(floats) => Numbers::Binary(floats.as_slice()?),
            Column::Decimal(floats) => Numbers::Decimal(floats.as_slice()?),
            Column::Pairs(numerators, denominators) => {
                Numbers::Pairs(numerators.as_slice()?, denominators.as_slice()?)
            }
            Column::Exact(numbers) => Numbers::Exact(numbers),
        })
    }
}

/// The same, borrowed.
pub enum Numbers<'a> {
    Binary(&'a [f64]),
    Decimal(&'a [f64]),
    Pairs(&'a [i64], &'a [i64]),
    Exact(&'a [Exact]),
}

impl Numbers<'_> {
    /// How many.
    pub fn len(&self) -> usize {
        match self {
            Numbers::Binary(floats) | Numbers::Decimal(floats) => floats.len(),
            Numbers::Pairs(numerators, denominators) => numerators.len().min(denominators.len()),
            Numbers::Exact(numbers) => numbers.len(),
        }
    }

    /// An enclosure of one of them, and of cos 2πx of it; `None` where the exact number is as good. Cost: no
    /// exact arithmetic but for `Exact`.
    pub fn enclosure(&self, i: usize, with_cosine: bool) -> Option<(FloatInterval, Option<FloatInterval>)> {
        let i = if self.len() == 1 { 0 } else { i };
        let cosine = |angle: Option<Angle>| angle.map(|angle| FloatInterval::cos(&angle, &()));
        // A float in 2⁻⁹ ≤ x < 2 is a multiple of 2⁻⁶¹.
        let of_float = |x: f64| {
            let small = (1.0 / 512.0..1.0).contains(&x);
            cosine(small.then(|| Angle::fraction((x * ONE) as u64 * 2, ONE as u64)).flatten())
        };
        let (x, found) = match self {
            Numbers::Binary(floats) => {
                let x = floats[i];
                (FloatInterval::from_bounds(x, x), with_cosine.then(|| of_float(x)).flatten())
            }
            // The shortest decimal is within half a unit in the last place of x; the cosine's slope is below
            // 7.
            Numbers::Decimal(floats) => {
                let x = floats[i];
                let unit = x.next_up() - x;
                let about = FloatInterval::from_bounds(-7.0 * unit, 7.0 * unit);
                let found = with_cosine.then(|| of_float(x)).flatten();
                (FloatInterval::from_bounds(x.next_down(), x.next_up()), found.map(|found| found + &about))
            }
            Numbers::Pairs(numerators, denominators) => {
                let (p, q) = (numerators[i], denominators[i]);
                // A float at or beside it.
                let [over, under] = [p, q].map(|x| match x as f64 {
                    float if x.unsigned_abs() <= 1 << 53 => FloatInterval::from_bounds(float, float),
                    float => FloatInterval::from_bounds(float.next_down(), float.next_up()),
                });
                let angle = || Angle::fraction(u64::try_from(p).ok()?.checked_mul(2)?, q.try_into().ok()?);
                (over / &under, with_cosine.then(|| cosine(angle())).flatten())
            }
            Numbers::Exact(numbers) => {
                let x = &numbers[i].0;
                let angle = || Angle::new(&(x * BigInt::from(2)));
                (FloatInterval::ratio(x, &()), with_cosine.then(|| cosine(Some(angle()))).flatten())
            }
        };
        (x.lo().is_finite() && x.hi().is_finite()).then_some((x, found))
    }

    /// One of them.
    ///
    /// # Errors
    /// An input error for a float that is not finite and for a denominator of 0.
    pub fn at(&self, i: usize) -> Result<BigRational> {
        let i = if self.len() == 1 { 0 } else { i };
        match self {
            Numbers::Binary(floats) => {
                BigRational::from_float(floats[i]).ok_or_else(|| not_finite(floats[i]))
            }
            // The shortest decimal that reads back as this float, without an exponent.
            Numbers::Decimal(floats) if floats[i].is_finite() => Ok(parse_rational(&floats[i].to_string())?),
            Numbers::Decimal(floats) => Err(not_finite(floats[i])),
            Numbers::Pairs(numerators, denominators) => match (numerators[i], denominators[i]) {
                (numerator, 0) => {
                    Err(Error::input(format!("{numerator}/0: a fraction has another denominator")))
                }
                (numerator, denominator) => Ok(BigRational::new(numerator.into(), denominator.into())),
            },
            Numbers::Exact(numbers) => Ok(numbers[i].0.clone()),
        }
    }
}

fn not_finite(x: f64) -> Error {
    Error::input(format!("{x} is not finite"))
}
