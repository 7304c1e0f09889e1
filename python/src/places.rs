//! What holds at points (a₁, a₂) or (r, s): single orbits, words, values.

use std::sync::OnceLock;

use grazing::{
    Error, Monitor, Result,
    existence::{Existence, large_eigenvalue_sign, up_to},
    local::{Answer, Forward, Ladder, Plane, Point, Polar, Quantity},
    num_rational::BigRational,
    number::{Precision, Sign, ball_digits},
    search::{Certified, WordCertificate, WordPlace, certify_word},
    word::{ClosedWalks, Edge, Entropy, Extent, Relation, Word},
};
use numpy::{PyReadonlyArray1, PyReadwriteArray2, PyUntypedArrayMethods};
use pyo3::{prelude::*, types::PyModule, wrap_pyfunction};
use rayon::prelude::*;
use serde_json::{Value as Json, json};

use crate::{
    exact::Exact,
    failure::raise,
    watch::{watched, watched_here},
};

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(classify, module)?)?;
    module.add_function(wrap_pyfunction!(classify_many, module)?)?;
    module.add_function(wrap_pyfunction!(classify_exactly, module)?)?;
    module.add_function(wrap_pyfunction!(word, module)?)?;
    module.add_function(wrap_pyfunction!(evaluate, module)?)
}

/// The largest period of a classification, as on the command line.
const LONGEST: u64 = 100_000;

/// π to many bits is computed once.
fn ladder() -> &'static Ladder {
    static LADDER: OnceLock<Ladder> = OnceLock::new();
    LADDER.get_or_init(Ladder::default)
}

fn place(first: BigRational, second: BigRational, polar: bool) -> Result<Forward> {
    if polar { Forward::polar(first, second) } else { Forward::plane(first, second) }
}

fn check_last(last: u64) -> Result<()> {
    if (1..=LONGEST).contains(&last) {
        return Ok(());
    }
    Err(Error::input(format!("max_n = {last}: a whole number from 1 to {LONGEST}")))
}

/// Of a period: n, the verdict, the cases as (sign eµ, sign γ, sign of the large eigenvalue), and the k with
/// b_{n,k} positive, negative, zero.
type Row = (u64, &'static str, Vec<(i8, i8, i8)>, Option<u64>, Option<u64>, Option<u64>);

/// One period after the other at one point: (region, whether time was reversed, rows).
#[pyfunction]
fn classify(
    py: Python<'_>,
    first: Exact,
    second: Exact,
    polar: bool,
    max_n: u64,
) -> PyResult<(String, bool, Vec<Row>)> {
    watched(py, None, move |watch| {
        check_last(max_n)?;
        let place = place(first.0, second.0, polar)?;
        let found = up_to(ladder(), &place.point, max_n, || watch.advance(0))?;
        let rows = (1..).zip(found).map(|(n, existence)| {
            let [positive, negative, zero] = existence.indices().map(|k| k.map(|k| place.index(n, k)));
            let large = |case| large_eigenvalue_sign(place.region, n, case);
            let cases = existence.cases(n).into_iter();
            let cases = cases.map(|case| (case.sign_emu(), case.sign_gamma(), large(case))).collect();
            (n, existence.name(), cases, positive, negative, zero)
        });
        Ok((place.region.to_string(), place.reversed, rows.collect()))
    })
}

/// A bit for each case, then one for a boundary and one for what is undecided.
fn bits(existence: Existence, n: u64) -> u8 {
    let case = |case: grazing::existence::Case| match (case.sign_emu(), case.sign_gamma()) {
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

/// Many points, each float the binary fraction that it is: `found[i, n − 1]` for period n at point i.
#[pyfunction]
fn classify_many<'py>(
    py: Python<'py>,
    first: PyReadonlyArray1<'py, f64>,
    second: PyReadonlyArray1<'py, f64>,
    polar: bool,
    mut found: PyReadwriteArray2<'py, u8>,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<()> {
    let (first, second) = (first.as_slice()?, second.as_slice()?);
    let at = |i: usize| {
        let (x, y) = (first[i], second[i]);
        let (x_exact, y_exact) = (BigRational::from_float(x), BigRational::from_float(y));
        x_exact.zip(y_exact).ok_or_else(|| Error::input(format!("({x}, {y}) is not finite")))
    };
    classify_each(py, at, polar, &mut found, progress)
}

/// The same at points that are given exactly, which must be as many as `found` has rows.
#[pyfunction]
fn classify_exactly<'py>(
    py: Python<'py>,
    first: Vec<Exact>,
    second: Vec<Exact>,
    polar: bool,
    mut found: PyReadwriteArray2<'py, u8>,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<()> {
    let at = |i: usize| match (first.get(i), second.get(i)) {
        (Some(x), Some(y)) => Ok((x.0.clone(), y.0.clone())),
        _ => Err(Error::input("there are more rows than points")),
    };
    classify_each(py, at, polar, &mut found, progress)
}

/// A row for each point, which `at` tells by its number.
fn classify_each<'py>(
    py: Python<'py>,
    at: impl Fn(usize) -> Result<(BigRational, BigRational)> + Send + Sync,
    polar: bool,
    found: &mut PyReadwriteArray2<'py, u8>,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<()> {
    let [points, last] = [found.shape()[0], found.shape()[1]];
    let found = found.as_slice_mut()?;
    watched_here(py, progress.as_ref(), move |watch| {
        check_last(last as u64)?;
        watch.begin(points as u64, "points");
        let portions = found.par_chunks_mut(PORTION * last).enumerate();
        portions.try_for_each(|(portion, rows)| {
            for (i, row) in (portion * PORTION..).zip(rows.chunks_mut(last)) {
                let place = at(i).and_then(|(x, y)| place(x, y, polar));
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

/// The most letters and the largest period that are counted, as on the command line.
const LETTERS: usize = 2000;
const COUNTED: u64 = 400;

/// The words at a point, as JSON, and a certificate if one is asked for.
#[pyfunction]
fn word(
    py: Python<'_>,
    first: Exact,
    second: Exact,
    polar: bool,
    max_period: u64,
    letters: usize,
    certificate: Option<String>,
) -> PyResult<(String, Option<String>, Option<String>)> {
    watched(py, None, move |watch| {
        if !(1..=COUNTED).contains(&max_period) {
            return Err(Error::input(format!("max_period = {max_period}: from 1 to {COUNTED}")));
        }
        if !(1..=LETTERS).contains(&letters) {
            return Err(Error::input(format!("letters = {letters}: from 1 to {LETTERS}")));
        }
        let place = place(first.0, second.0, polar)?;
        let mut words = Vec::new();
        for positive in [true, false] {
            words.push(Word::at(ladder(), &place.point, positive, letters, watch)?);
        }
        let sides: Vec<Json> =
            words.iter().map(|word| side(word, place.reversed, max_period)).collect::<Result<_>>()?;
        let report = json!({
            "region": place.region,
            "reversed": place.reversed,
            "words": sides,
        });
        let kind = match certificate.as_deref() {
            None => return Ok((report.to_string(), None, None)),
            Some("signs") => WordCertificate::BySigns { last: max_period },
            Some("theorem") => WordCertificate::ByTheorem,
            Some(other) => {
                return Err(Error::input(format!("certificate = {other:?}: \"signs\" or \"theorem\"")));
            }
        };
        if place.reversed {
            return Err(Error::input(
                "a certificate for a2 > 1: certify the time-reversed system, at a1/a2 and 1/a2 (or 1/r and s)",
            ));
        }
        let all: Vec<&Word> = words.iter().collect();
        Ok(match certify_word(WordPlace::Point(&place.point), &all, kind, &mut || watch.is_over())? {
            Certified::Text(text) => (report.to_string(), Some(text), None),
            Certified::Undecided(why) => (report.to_string(), None, Some(why)),
        })
    })
}

fn side(word: &Word, reversed: bool, last: u64) -> Result<Json> {
    let (end, next) = match word.extent() {
        Extent::All => ("all", None),
        Extent::Complete { next } => ("complete", next),
        Extent::Boundary { next, deciding: Some(_) } => ("boundary", Some(next)),
        Extent::Boundary { next, deciding: None } => ("singular", Some(next)),
        Extent::Undecided { next, .. } => ("undecided", Some(next)),
        Extent::Straddled { next } => ("straddled", Some(next)),
        Extent::Cut => ("cut", None),
        Extent::Odd => ("odd", None),
        _ => ("line", None),
    };
    let cases = [true, false].map(|gamma| case(word, gamma, reversed, last));
    let [plus, minus] = cases;
    let vertices = word.vertices();
    Ok(json!({
        "sign_emu": if word.is_positive() { 1 } else { -1 },
        "letters": word.letters(),
        "periods": vertices.iter().map(|vertex| vertex.period).collect::<Vec<_>>(),
        "numerators": vertices.iter().map(|vertex| vertex.numerator).collect::<Vec<_>>(),
        "end": end,
        "next": next,
        "cases": [plus?, minus?],
    }))
}

fn case(word: &Word, gamma: bool, reversed: bool, last: u64) -> Result<Json> {
    let counted = ClosedWalks::new(&Relation::new(word, gamma, reversed, last)?).count(last);
    let (entropy, at_least) = Entropy::of(word, gamma, 64)?;
    // Over all periods the relation is shown on those counted.
    let shown = if word.is_endless() { last } else { u64::MAX };
    let relation = Relation::new(word, gamma, reversed, shown)?;
    let pairs = |wanted: Edge| {
        let rows = relation.edges().iter().zip(relation.periods());
        rows.flat_map(|(row, from)| {
            let follows = row.iter().zip(relation.periods()).filter(|(edge, _)| **edge == wanted);
            follows.map(|(_, to)| [*from, *to]).collect::<Vec<_>>()
        })
        .collect::<Vec<_>>()
    };
    let kind = match &entropy {
        Entropy::Empty => "none",
        Entropy::Zero => "zero",
        _ => "positive",
    };
    Ok(json!({
        "sign_gamma": relation.case().sign_gamma(),
        "edges": pairs(Edge::Yes),
        "open": pairs(Edge::Open),
        "loops": relation.loops(),
        "all": counted.iter().map(|row| row.all.to_string()).collect::<Vec<_>>(),
        "primitive": counted.iter().map(|row| row.primitive.to_string()).collect::<Vec<_>>(),
        "entropy": kind,
        "rate": entropy.bounds().map(|(lo, hi)| [lo.to_string(), hi.to_string()]),
        "lower_bound": at_least,
    }))
}

/// The largest period for which all b_{n,k} are listed.
const LIST: u64 = 100_000;

/// b_{n,k} and c_n: for each its k (none for c), sign, what decided it, certain digits.
#[pyfunction]
#[allow(clippy::type_complexity)]
fn evaluate(
    py: Python<'_>,
    first: Exact,
    second: Exact,
    polar: bool,
    n: u64,
    k: Option<u64>,
    bits: u32,
) -> PyResult<Vec<(Option<u64>, String, String, Option<String>)>> {
    if n == 0 {
        return Err(raise(py, &Error::input("n = 0: a period is at least 1")));
    }
    watched(py, None, move |watch| {
        let range = match k {
            Some(k) if k == 0 || k >= n => {
                return Err(Error::input(format!("k = {k} is outside 1 <= k < n = {n}")));
            }
            Some(k) => k..k + 1,
            None if n > LIST => {
                return Err(Error::input(format!(
                    "n = {n}: all b_{{n,k}} are listed up to n = {LIST}; choose one by k"
                )));
            }
            None => 1..n,
        };
        if !(16..=65536).contains(&bits) {
            return Err(Error::input(format!("bits = {bits}: from 16 to 65536")));
        }
        let point = if polar {
            Point::Polar(Polar::new(first.0, second.0)?)
        } else {
            Point::Plane(Plane::new(first.0, second.0)?)
        };
        let precision = Precision::new(bits);
        let quantities = range.map(|k| (Some(k), Quantity::B { n, k })).chain([(None, Quantity::C { n })]);
        let mut rows = Vec::new();
        for (k, quantity) in quantities {
            let decision = ladder().sign_watched(&point, quantity, watch)?;
            watch.advance(0)?;
            let digits = if decision.answer == Answer::Sign(Sign::Zero) {
                Some("0".into())
            } else {
                let ball = point.evaluate_closely(quantity, &precision);
                ball.and_then(|ball| ball_digits(&ball, bits * 3 / 10))
            };
            rows.push((k, decision.answer.to_string(), decision.rung.to_string(), digits));
        }
        Ok(rows)
    })
}
