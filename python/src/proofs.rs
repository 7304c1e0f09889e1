//! Certificates, Theorem 2, its intervals, and the edges of the areas below them.

use std::{
    fs::File,
    io::{BufReader, Read},
    path::PathBuf,
};

use grazing_scenes::{
    Error, Monitor, Result,
    certificate::{Checked, Hashed, Rejection, check_until},
    existence::{Boundary, Enclosure, Interval, Lowest, intervals as list},
    num_rational::{BigRational, Ratio},
    search::{Proof, ProofMethod, prove_theorem2, write_theorem2},
};
use numpy::IntoPyArray;
use pyo3::{
    prelude::*,
    types::{PyDict, PyModule},
    wrap_pyfunction,
};
use rayon::prelude::*;

use crate::{
    exact::Exact,
    failure::raise,
    watch::{Watch, watched},
};

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(check_file, module)?)?;
    module.add_function(wrap_pyfunction!(check_text, module)?)?;
    module.add_function(wrap_pyfunction!(overflow, module)?)?;
    module.add_function(wrap_pyfunction!(verify, module)?)?;
    module.add_function(wrap_pyfunction!(intervals, module)?)?;
    module.add_function(wrap_pyfunction!(boundary, module)?)
}

/// What a checker found: (verdict, what is proved, SHA-256 of what was read, line, reason).
pub type Verdict = (&'static str, Option<Proved>, Option<String>, Option<u64>, Option<String>);

/// (kind, title, statement, first and last period if these are a range, details, lines).
pub type Proved =
    (&'static str, &'static str, &'static str, Option<(u64, u64)>, Vec<(&'static str, String)>, u64);

fn checked(watch: &Watch, mut stream: impl Read, name: &str) -> Result<Verdict> {
    let mut hashed = Hashed::new(&mut stream);
    let answer = check_until(&mut BufReader::with_capacity(1 << 16, &mut hashed), &mut || watch.is_over());
    verdict(answer, hashed.finish(), name)
}

/// What is told of the checker's answer to what was read.
pub fn verdict(answer: std::result::Result<Checked, Rejection>, hash: String, name: &str) -> Result<Verdict> {
    Ok(match answer {
        Ok(Checked { kind, title, statement, range, detail, lines }) => {
            let range = range.map(|range| range.into_inner());
            let proved = (kind, title, statement, range, detail, lines);
            ("proved", Some(proved), Some(hash), None, None)
        }
        Err(Rejection::Malformed { line, reason }) => ("malformed", None, None, Some(line), Some(reason)),
        Err(Rejection::False { line, reason }) => ("false", None, None, Some(line), Some(reason)),
        Err(Rejection::Undecided { line, reason }) => ("undecided", None, None, Some(line), Some(reason)),
        Err(Rejection::Unreadable { source, .. }) => {
            return Err(Error::io("read", name.as_ref(), source));
        }
        Err(Rejection::Interrupted { .. }) => return Err(Error::interrupted("interrupted")),
    })
}

/// Proves the certificate in a file again.
#[pyfunction]
fn check_file(py: Python<'_>, path: PathBuf) -> PyResult<Verdict> {
    watched(py, None, move |watch| {
        let file = File::open(&path).map_err(|error| Error::io("open", &path, error))?;
        checked(watch, file, &path.display().to_string())
    })
}

/// Proves a certificate again that is a text.
#[pyfunction]
fn check_text(py: Python<'_>, text: &[u8]) -> PyResult<Verdict> {
    let text = text.to_vec();
    watched(py, None, move |watch| checked(watch, &*text, "the certificate"))
}

/// Breaks off, if the checker was built to notice overflows, as it must be: for tests of a wheel.
#[pyfunction]
fn overflow(py: Python<'_>) -> PyResult<u64> {
    watched(py, None, |_| Ok(grazing_scenes::certificate::overflow()))
}

/// The largest period that is proved, as on the command line: deciding it takes minutes.
const LONGEST: u64 = 200_000;

/// Verdict, witness, counts, certificate.
pub type Answer<'py> = (&'static str, Option<String>, Bound<'py, PyDict>, Option<String>);

/// Theorem 2 for a range of periods.
#[pyfunction]
fn verify<'py>(
    py: Python<'py>,
    first: u64,
    last: u64,
    method: &str,
    certificate: bool,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<Answer<'py>> {
    let method = match method {
        "exact" => ProofMethod::Exact,
        "interval" => ProofMethod::Interval,
        "both" => ProofMethod::Both,
        other => {
            let message = format!("method = {other:?}: \"exact\", \"interval\" or \"both\"");
            return Err(raise(py, &Error::input(message)));
        }
    };
    if certificate && method == ProofMethod::Interval {
        let message = "a certificate holds what the exact method found: use method = \"exact\" or \"both\"";
        return Err(raise(py, &Error::input(message)));
    }
    let find = move |watch: &Watch| {
        if !(1..=LONGEST).contains(&first) || !(first..=LONGEST).contains(&last) {
            return Err(Error::input(format!(
                "the periods {first}..={last}: from 1 to {LONGEST}, and not empty"
            )));
        }
        let passes = if certificate { 2 } else { 1 };
        watch.begin(passes * (last - first + 1), "periods");
        prove_theorem2(first..=last, method, watch)
    };
    proved(py, (first, last), certificate, find, progress.as_ref())
}

/// What is told of the proof that `find` comes to; a certificate, if it is asked for and all is proved.
pub fn proved<'py>(
    py: Python<'py>,
    (first, last): (u64, u64),
    certificate: bool,
    find: impl FnOnce(&Watch) -> Result<Proof> + Send + 'static,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Answer<'py>> {
    let (proof, text) = watched(py, progress, move |watch| {
        let proof = find(watch)?;
        let whole = proof.pending == 0 && proof.undecided == 0;
        if !certificate || !whole || proof.refuted.is_some() || proof.contradiction.is_some() {
            return Ok((proof, None));
        }
        let mut text = Vec::new();
        write_theorem2(first..=last, &proof, &mut text, watch)?;
        Ok((proof, Some(String::from_utf8_lossy(&text).into_owned())))
    })?;
    let (verdict, witness) = match &proof {
        Proof { contradiction: Some(n), .. } => {
            let witness = format!("the exact method and enclosures find different orbits for n = {n}");
            ("refuted", Some(witness))
        }
        Proof { refuted: Some(decision), .. } => {
            let show = |interval: &Option<Interval>| {
                interval.as_ref().map_or("no further interval".to_string(), ToString::to_string)
            };
            let (decided, claimed) = decision.disagreement.clone().unwrap_or_default();
            let (decided, claimed) = (show(&decided), show(&claimed));
            ("refuted", Some(format!("n = {}: decided {decided}, claimed {claimed}", decision.n)))
        }
        Proof { pending: 0, undecided: 0, .. } => ("proved", None),
        Proof { pending: 0, .. } => ("undecided", None),
        _ => ("pending", None),
    };
    let counts = PyDict::new(py);
    for (name, count) in [
        ("periods", proof.periods),
        ("orbit_intervals", proof.orbits),
        ("stretches", proof.stretches),
        ("singular_points", proof.singular),
        ("boundary_points", proof.boundary),
        ("excluded_points", proof.excluded),
        ("undecided", proof.undecided),
        ("pending", proof.pending),
    ] {
        counts.set_item(name, count)?;
    }
    Ok((verdict, witness, counts, text))
}

/// The columns of a table of Theorem 2's intervals.
const COLUMNS: [&str; 9] = [
    "n",
    "m",
    "sign_emu",
    "sign_gamma",
    "left_numerator",
    "left_denominator",
    "right_numerator",
    "right_denominator",
    "deciding",
];

/// The most rows of a table: 4 GB.
const MOST_ROWS: usize = 50_000_000;

/// Theorem 2's intervals for a range of periods, as columns of int64; `deciding` is 0 where there is none.
#[pyfunction]
fn intervals<'py>(
    py: Python<'py>,
    first: u64,
    last: u64,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let columns = watched(py, progress.as_ref(), move |watch| {
        let mut columns: [Vec<i64>; 9] = Default::default();
        watch.begin((last + 1).saturating_sub(first), "periods");
        for n in first..=last {
            for (index, interval) in list(n)?.enumerate() {
                let Interval { m, case, left, right, deciding, .. } = interval;
                let row = [
                    n as i64,
                    m as i64,
                    case.sign_emu().into(),
                    case.sign_gamma().into(),
                    *left.numer() as i64,
                    *left.denom() as i64,
                    *right.numer() as i64,
                    *right.denom() as i64,
                    deciding.unwrap_or(0) as i64,
                ];
                for (column, cell) in columns.iter_mut().zip(row) {
                    column.push(cell);
                }
                if index % 4096 == 4095 {
                    watch.advance(0)?;
                }
            }
            if columns[0].len() > MOST_ROWS {
                return Err(Error::input(format!(
                    "the periods {first}..={last} have more than {MOST_ROWS} intervals: take fewer at a time"
                )));
            }
            watch.advance(1)?;
        }
        Ok(columns)
    })?;
    let table = PyDict::new(py);
    for (name, column) in COLUMNS.into_iter().zip(columns) {
        table.set_item(name, column.into_pyarray(py))?;
    }
    Ok(table)
}

/// The most of a table of edges, as on the command line.
const MAX_EDGE: u64 = 100_000;
const MAX_DIGITS: u32 = 1000;

/// Bounds of a number.
type Bounds = (BigRational, BigRational);

/// n, m, sign eµ, sign γ, deciding k, what the bounds are of, s, bounds of r.
type Edge = (u64, u64, i8, i8, Option<u64>, &'static str, Option<Bounds>, Option<Bounds>);

/// The lowest point of each area of a range of periods, or its lower edge at each of the places `at` that lie
/// within its interval.
#[pyfunction]
#[pyo3(signature = (first, last, m, at, digits, progress))]
fn boundary(
    py: Python<'_>,
    first: u64,
    last: u64,
    m: Option<u64>,
    at: Option<Vec<Exact>>,
    digits: u32,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Vec<Edge>> {
    watched(py, progress.as_ref(), move |watch| {
        if first < 2 || last > MAX_EDGE || first > last {
            return Err(Error::input(format!(
                "the periods {first}..={last}: from 2 (period 1 has no b to forbid it) to {MAX_EDGE}, and not empty"
            )));
        }
        if !(1..=MAX_DIGITS).contains(&digits) {
            return Err(Error::input(format!("digits = {digits}: from 1 to {MAX_DIGITS}")));
        }
        watch.begin(last - first + 1, "periods");
        let mut all = Vec::new();
        for n in first..=last {
            let wanted = |interval: &Interval| m.is_none_or(|m| m == interval.m);
            let areas: Vec<Boundary> = list(n)?.filter(wanted).map(Boundary::new).collect();
            if let (Some(m), true) = (m, areas.is_empty()) {
                return Err(Error::input(format!(
                    "period {n} has no area at m = {m}: m is 0, or at most {} and coprime to {n}",
                    n / 2
                )));
            }
            for portion in areas.chunks(64) {
                let found: Result<Vec<Vec<Edge>>> = portion
                    .par_iter()
                    .map(|area| match &at {
                        None => Ok(vec![lowest(area, digits)]),
                        Some(places) => edges(area, places, digits),
                    })
                    .collect();
                all.extend(found?.into_iter().flatten());
                watch.advance(0)?;
            }
            watch.advance(1)?;
        }
        Ok(all)
    })
}

fn edge(area: &Boundary, kind: &'static str, s: Option<Bounds>, r: Option<Bounds>) -> Edge {
    let Interval { n, m, case, deciding, .. } = area.interval();
    (*n, *m, case.sign_emu(), case.sign_gamma(), *deciding, kind, s, r)
}

fn lowest(area: &Boundary, digits: u32) -> Edge {
    let pair = |enclosure: Enclosure| (enclosure.lower, enclosure.upper);
    let zero = || pair(Enclosure::zero());
    match area.lowest(digits) {
        None => edge(area, "not certified", None, None),
        Some(Lowest::Zero { left, right }) => edge(area, "interval", Some((left, right)), Some(zero())),
        Some(Lowest::Region4) => edge(area, "region4", None, Some(zero())),
        Some(Lowest::Tip(tip)) => edge(area, "tip", Some(pair(tip.s)), Some(pair(tip.r))),
    }
}

fn edges(area: &Boundary, places: &[Exact], digits: u32) -> Result<Vec<Edge>> {
    let big = |x: &Ratio<u64>| BigRational::new((*x.numer()).into(), (*x.denom()).into());
    let (left, right) = (big(&area.interval().left), big(&area.interval().right));
    let inside = places.iter().map(|Exact(s)| s).filter(|s| &left < *s && *s < &right);
    inside
        .map(|s| {
            let r = area.at(s, digits)?.map(|enclosure| (enclosure.lower, enclosure.upper));
            let kind = if r.is_some() { "edge" } else { "not certified" };
            Ok(edge(area, kind, Some((s.clone(), s.clone())), r))
        })
        .collect()
}
