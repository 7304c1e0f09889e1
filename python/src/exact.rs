//! Exact numbers from Python: whole numbers, fractions, decimals and the texts of the command line.
//!
//! A float is refused: 0.2 is not 1/5, and on a boundary the difference decides the answer. The error says
//! how to write either.

use grazing_scenes::num_bigint::BigInt;
use grazing_scenes::num_rational::BigRational;
use grazing_scenes::number::{LIMIT_BITS, parse_rational};
use pyo3::{
    exceptions::{PyTypeError, PyZeroDivisionError},
    prelude::*,
    sync::PyOnceLock,
    types::{PyBool, PyFloat, PyInt, PyString, PyType},
};

use crate::failure::input;

/// An exact number.
pub struct Exact(pub BigRational);

impl<'a, 'py> FromPyObject<'a, 'py> for Exact {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Exact> {
        let py = object.py();
        if let Ok(text) = object.cast::<PyString>() {
            let text = text.to_string();
            return parse_rational(&text)
                .map(Exact)
                .map_err(|error| crate::failure::raise(py, &error.into()));
        }
        if let Some((numerator, denominator)) = plain(object)? {
            return fraction(py, numerator, denominator);
        }
        let shown = || object.repr().map(|text| text.to_string());
        if object.cast::<PyBool>().is_ok() {
            return Err(PyTypeError::new_err(format!("{} is not a number", shown()?)));
        }
        // NumPy's float64 is one, its other floats are numbers with a dtype.
        if object.cast::<PyFloat>().is_ok() || object.hasattr("dtype")? && !object.hasattr("__index__")? {
            let decimal = object.str()?;
            let float = object.call_method0("__float__").and_then(|float| float.repr()?.extract::<String>());
            return Err(PyTypeError::new_err(format!(
                "{decimal} is a float, and this number must be exact: write \"{decimal}\" for the decimal, or \
                 Fraction({}) for the binary fraction that the float is",
                float.unwrap_or_else(|_| decimal.to_string())
            )));
        }
        let (numerator, denominator) = if object.hasattr("__index__")? {
            (whole(&object.call_method0("__index__")?)?, BigInt::from(1))
        } else if let Some(parts) = parts(object)? {
            parts
        } else if object.hasattr("as_integer_ratio")? {
            // 10^1000000000 would be made before it is refused.
            if let Ok(exponent) = object.call_method0("as_tuple").and_then(|parts| parts.getattr("exponent"))
                && exponent.extract::<i64>().is_ok_and(|exponent| exponent.unsigned_abs() > LIMIT_BITS.into())
            {
                return Err(too_long(py));
            }
            object.call_method0("as_integer_ratio")?.extract::<(BigInt, BigInt)>()?
        } else {
            let kind = object.get_type().name()?;
            return Err(PyTypeError::new_err(format!(
                "{} is of type {kind}; an exact number is an int, a Fraction, a Decimal, or text as \"3/8+2^-200\"",
                shown()?
            )));
        };
        fraction(py, numerator, denominator)
    }
}

static FRACTION: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// The parts of Python's own integers and fractions, by which questions of all others are spared.
fn plain(object: Borrowed<'_, '_, PyAny>) -> PyResult<Option<(BigInt, BigInt)>> {
    if object.cast_exact::<PyInt>().is_ok() {
        return Ok(Some((whole(&object)?, BigInt::from(1))));
    }
    if !object.get_type().is(FRACTION.import(object.py(), "fractions", "Fraction")?) {
        return Ok(None);
    }
    Ok(Some((whole(&object.getattr("numerator")?)?, whole(&object.getattr("denominator")?)?)))
}

/// Numerator and denominator by the names that fractions of other packages have for them: `numerator` and
/// `denominator`, or `p` and `q`.
fn parts(object: Borrowed<'_, '_, PyAny>) -> PyResult<Option<(BigInt, BigInt)>> {
    for names in [["numerator", "denominator"], ["p", "q"]] {
        if !object.hasattr(names[0])? || !object.hasattr(names[1])? {
            continue;
        }
        let [numerator, denominator] = names.map(|name| object.getattr(name));
        let (numerator, denominator) = (numerator?, denominator?);
        // What are methods in one version of a package may be numbers in another.
        if numerator.hasattr("__index__")? && denominator.hasattr("__index__")? {
            let part = |part: Bound<'_, PyAny>| whole(&part.call_method0("__index__")?);
            return Ok(Some((part(numerator)?, part(denominator)?)));
        }
    }
    Ok(None)
}

/// An integer; those of 64 bits without a detour.
fn whole(object: &Bound<'_, PyAny>) -> PyResult<BigInt> {
    match object.extract::<i64>() {
        Ok(small) => Ok(small.into()),
        Err(_) => object.extract(),
    }
}

fn fraction(py: Python<'_>, numerator: BigInt, denominator: BigInt) -> PyResult<Exact> {
    if denominator == BigInt::ZERO {
        return Err(PyZeroDivisionError::new_err("a fraction with the denominator 0"));
    }
    if numerator.bits().max(denominator.bits()) > LIMIT_BITS.into() {
        return Err(too_long(py));
    }
    Ok(Exact(BigRational::new(numerator, denominator)))
}

fn too_long(py: Python<'_>) -> PyErr {
    input(py, &format!("a number of more than {LIMIT_BITS} bits: give a shorter one"))
}
