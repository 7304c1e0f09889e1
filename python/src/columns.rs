//! The numbers of many points, as arrays and lists from Python, each as the exact number that it stands for.

use grazing_scenes::{Error, Result, num_rational::BigRational, number::parse_rational};
use numpy::PyReadonlyArray1;
use pyo3::{exceptions::PyValueError, prelude::*};

use crate::exact::Exact;

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
