//! Single orbits at one point and at many.

use grazing_scenes::{
    Error, Monitor, Result,
    existence::{Case, Existence, Resonance, by_enclosures, large_eigenvalue_sign, up_to},
    local::{Forward, Ladder},
    num_rational::BigRational,
};
use numpy::{PyReadonlyArray1, PyReadwriteArray2, PyUntypedArrayMethods};
use pyo3::{
    prelude::*,
    types::{PyModule, PyTuple},
    wrap_pyfunction,
};
use rayon::prelude::*;

use crate::{
    columns::{Column, Numbers},
    exact::Exact,
    places::{ladder, place},
    watch::{at_once, is_forked, watched, watched_here},
};

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(classify, module)?)?;
    module.add_function(wrap_pyfunction!(classify_many, module)?)
}

/// The largest period of a classification, as on the command line.
const LONGEST: u64 = 100_000;

/// Up to this period, at points with numbers of up to this many bits, a classification takes some
/// microseconds; where many signs are zero, at most some tenths of a second.
const SHORT: u64 = 64;
const SHORT_BITS: u64 = 256;

fn check_last(last: u64) -> Result<()> {
    if (1..=LONGEST).contains(&last) {
        return Ok(());
    }
    Err(Error::input(format!("max_n = {last}: a whole number from 1 to {LONGEST}")))
}

/// A point, classified.
struct Classified {
    place: Forward,
    found: Vec<Existence>,
}

/// Region, whether time was reversed, and a row for each period: n, the verdict, the cases as (sign eµ, sign
/// γ), the signs of their large eigenvalues, and the k with b_{n,k} positive, negative, zero.
type Classification<'py> = (String, bool, Vec<Bound<'py, PyTuple>>);

/// One period after the other at one point.
#[pyfunction]
fn classify<'py>(
    py: Python<'py>,
    first: Exact,
    second: Exact,
    polar: bool,
    max_n: u64,
) -> PyResult<Classification<'py>> {
    let is_short = |x: &BigRational| x.numer().bits().max(x.denom().bits()) <= SHORT_BITS;
    let classified = if max_n <= SHORT && is_short(&first.0) && is_short(&second.0) {
        at_once(py, move || {
            // What another thread was computing when this process was forked is never done here.
            let own = is_forked().then(Ladder::default);
            classified(own.as_ref().unwrap_or_else(|| ladder()), first, second, polar, max_n, || Ok(()))
        })
    } else {
        let work = move |watch: &crate::watch::Watch| {
            classified(ladder(), first, second, polar, max_n, || watch.advance(0))
        };
        watched(py, None, work)
    };
    told(py, &classified?)
}

fn classified(
    ladder: &Ladder,
    first: Exact,
    second: Exact,
    polar: bool,
    last: u64,
    check: impl FnMut() -> Result<()>,
) -> Result<Classified> {
    check_last(last)?;
    let place = place(first.0, second.0, polar)?;
    let found = up_to(ladder, &place.point, last, check)?;
    Ok(Classified { place, found })
}

fn told<'py>(py: Python<'py>, Classified { place, found }: &Classified) -> PyResult<Classification<'py>> {
    let rows = (1..).zip(found).map(|(n, existence)| {
        let [positive, negative, zero] = existence.indices().map(|k| k.map(|k| place.index(n, k)));
        let cases = existence.cases(n);
        let large = cases.iter().map(|&case| large_eigenvalue_sign(place.region, n, case));
        let large = PyTuple::new(py, large.collect::<Vec<i8>>())?;
        let cases = cases.iter().map(|case| (case.sign_emu(), case.sign_gamma()));
        let cases = PyTuple::new(py, cases.collect::<Vec<(i8, i8)>>())?;
        let resonance = Resonance::at(&place.point, n).map(Resonance::name);
        (n, existence.name(), cases, large, positive, negative, zero, resonance).into_pyobject(py)
    });
    Ok((place.region.to_string(), place.reversed, rows.collect::<PyResult<_>>()?))
}

/// A bit for each case, then one for a boundary and one for what is undecided.
fn bits(existence: Existence, n: u64) -> u8 {
    let case = |case: Case| match (case.sign_emu(), case.sign_gamma()) {
        (1, 1) => 1,
        (1, _) => 2,
        (_, 1) => 4,
        _ => 8,
    };
    match existence {
        Existence::Orbit(_) => existence.cases(n).into_iter().map(case).sum(),
        Existence::None { .. } => 0,
        Existence::Singular | Existence::Iterate(_) | Existence::SignBoundary => 16,
        Existence::Undecided => 32,
    }
}

/// Points classified between two looks at Ctrl-C.
const PORTION: usize = 64;

/// What enclosures say of point `i`, if they decide all of it: a₁ = 2r cos 2πs and a₂ = r² for a point with r
/// > 0 and 0 < s < ½.
fn quickly(columns: &[Numbers; 2], i: usize, polar: bool, last: u64) -> Option<Vec<Existence>> {
    let ((first, _), (second, cosine)) = (columns[0].enclosure(i, false)?, columns[1].enclosure(i, polar)?);
    if !polar {
        return by_enclosures(&first, &second, last);
    }
    let within = first.lo() > 0.0 && second.lo() > 0.0 && second.hi() < 0.5;
    let twice = first + &first;
    within.then(|| by_enclosures(&(twice * &cosine?), &(first * &first), last))?
}

/// Many points: `found[i, n − 1]` for period n at point i. The columns, unless they have one number
/// for all, and `skipped`, which says at which points not to look, must be as long as `found`.
#[pyfunction]
#[pyo3(signature = (first, second, polar, skipped, found, progress))]
fn classify_many<'py>(
    py: Python<'py>,
    first: Column<'py>,
    second: Column<'py>,
    polar: bool,
    skipped: Option<PyReadonlyArray1<'py, bool>>,
    mut found: PyReadwriteArray2<'py, u8>,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<()> {
    let [points, last] = [found.shape()[0], found.shape()[1]];
    let columns = [first.numbers()?, second.numbers()?];
    let skipped = skipped.as_ref().map(|skipped| skipped.as_slice()).transpose()?;
    let found = found.as_slice_mut()?;
    watched_here(py, progress.as_ref(), move |watch| {
        check_last(last as u64)?;
        if columns.iter().any(|column| ![1, points].contains(&column.len()))
            || skipped.is_some_and(|skipped| skipped.len() != points)
        {
            return Err(Error::input(format!("the columns do not have {points} points each")));
        }
        watch.begin(points as u64, "points");
        let portions = found.par_chunks_mut(PORTION * last).enumerate();
        portions.try_for_each(|(portion, rows)| {
            for (i, row) in (portion * PORTION..).zip(rows.chunks_mut(last)) {
                if skipped.is_some_and(|skipped| skipped[i]) {
                    continue;
                }
                if let Some(kinds) = quickly(&columns, i, polar, last as u64) {
                    for (n, (cell, kind)) in (1..).zip(row.iter_mut().zip(kinds)) {
                        *cell = bits(kind, n);
                    }
                    continue;
                }
                let [first, second] = [&columns[0], &columns[1]].map(|column| column.at(i));
                let place = first.and_then(|first| place(first, second?, polar));
                let place = place.map_err(|error| error.context(format!("point {i}")))?;
                let kinds = up_to(ladder(), &place.point, last as u64, || watch.advance(0))?;
                for (n, (cell, kind)) in (1..).zip(row.iter_mut().zip(kinds)) {
                    *cell = bits(kind, n);
                }
            }
            watch.advance((rows.len() / last) as u64)
        })
    })
}

/// One row of each kind that there is, for [`crate::forced`]: as `classify` gives them, and as bits.
pub fn each_kind<'py>(py: Python<'py>) -> PyResult<(Classification<'py>, Vec<u8>)> {
    let place = place(BigRational::from_integer(1.into()), BigRational::new(1.into(), 7.into()), true);
    let place = place.map_err(|error| crate::failure::raise(py, &error))?;
    let found = vec![
        Existence::None { positive: 2, negative: 1 },
        Existence::Singular,
        Existence::Iterate(1),
        Existence::SignBoundary,
        Existence::Undecided,
    ];
    let bits = (1..).zip(&found).map(|(n, &kind)| bits(kind, n)).collect();
    Ok((told(py, &Classified { place, found })?, bits))
}
