//! Theorem 1 for a map of any dimension, and the search for counterexamples of Conjecture 1.

use grazing_scenes::{
    Error, Monitor, Result,
    pattern::{
        Analysis, Graph, MAX_GRAPH_PERIOD, Map, Numbers, Pattern, PatternExistence, Patterns, Report, Value,
    },
    search::fuzz::{Campaign, FuzzOptions, FuzzTally, fuzz as run_fuzz},
};
use pyo3::{prelude::*, types::PyModule, wrap_pyfunction};
use rayon::prelude::*;
use serde_json::{Value as Json, json};

use crate::watch::watched;

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(existence, module)?)?;
    module.add_function(wrap_pyfunction!(fuzz, module)?)
}

/// The most rows of a list, as on the command line.
const MOST_ROWS: usize = 10_000_000;

/// Patterns judged between two looks at Ctrl-C.
const CHUNK: usize = 1024;

/// What Theorem 1 says of one pattern, or of all patterns up to a period: JSON, and notes on the map.
#[pyfunction]
#[pyo3(signature = (text, name, pattern, max_period, existing, exact, progress))]
#[allow(clippy::too_many_arguments)]
fn existence(
    py: Python<'_>,
    text: String,
    name: String,
    pattern: Option<Vec<u64>>,
    max_period: u64,
    existing: bool,
    exact: bool,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<(String, Vec<String>)> {
    watched(py, progress.as_ref(), move |watch| {
        let map = Map::from_toml(&text, &name)?;
        let notes = map.notes().to_vec();
        if exact && !map.is_exact() {
            return Err(Error::input(format!("exact = True needs a map without intervals; {name} has some")));
        }
        let pattern = match pattern {
            None => None,
            Some(periods) => Some(
                Pattern::new(&periods)
                    .filter(|_| periods.iter().all(|n| (1..=MAX_GRAPH_PERIOD).contains(n)))
                    .ok_or_else(|| {
                        Error::input(format!(
                            "{periods:?} is not a pattern: periods from 1 to {MAX_GRAPH_PERIOD}"
                        ))
                    })?,
            ),
        };
        if !(1..=MAX_GRAPH_PERIOD).contains(&max_period) {
            return Err(Error::input(format!("max_period = {max_period}: from 1 to {MAX_GRAPH_PERIOD}")));
        }
        let last = pattern.as_ref().and_then(|pattern| pattern.periods().iter().copied().max());
        let last = last.unwrap_or(max_period);
        let numbers = if exact { Numbers::Exact } else { Numbers::Enclosed };
        let graph = if map.dimension() == 2 { Some(Graph::new(&map, last, exact)?) } else { None };
        let analysis = if graph.is_none() { Some(Analysis::new(&map, last, numbers)) } else { None };
        let judge = |pattern: &Pattern| match (&graph, &analysis) {
            (Some(graph), _) => Some(graph.judge(pattern.periods())),
            (None, Some(analysis)) => Some(analysis.judge(pattern.periods())),
            (None, None) => None,
        };
        let mut rows: Vec<Json> = Vec::new();
        let mut look = |chunk: &[Pattern]| -> Result<()> {
            let judged: Vec<Option<Report>> = chunk.par_iter().map(judge).collect();
            for (pattern, report) in chunk.iter().zip(judged) {
                let Some(report) = report else { continue };
                if !existing || report.side().is_some() || report.is_open() {
                    rows.push(row(pattern, &report));
                }
            }
            if rows.len() > MOST_ROWS {
                return Err(Error::input(format!(
                    "max_period = {max_period} gives more than {MOST_ROWS} rows: give a smaller one"
                )));
            }
            watch.advance(chunk.len() as u64)
        };
        watch.begin(0, "patterns");
        match &pattern {
            Some(pattern) => look(std::slice::from_ref(pattern))?,
            None => {
                let mut chunk = Vec::with_capacity(CHUNK);
                for period in 1..=max_period {
                    let all: Box<dyn Iterator<Item = Pattern>> = match &graph {
                        Some(graph) if existing => {
                            Box::new(Patterns::walks(period, |from, to| graph.may_follow(from, to)))
                        }
                        _ => Box::new(Patterns::of_period(period)),
                    };
                    for pattern in all {
                        chunk.push(pattern);
                        if chunk.len() == CHUNK {
                            look(&chunk)?;
                            chunk.clear();
                        }
                    }
                }
                look(&chunk)?;
            }
        }
        Ok((Json::Array(rows).to_string(), notes))
    })
}

fn word(existence: PatternExistence) -> &'static str {
    match existence {
        PatternExistence::Orbit => "orbit",
        PatternExistence::NoOrbit => "no orbit",
        PatternExistence::Open => "open",
    }
}

/// An exact number as text, an enclosure as its two ends.
fn value(value: &Value) -> Json {
    match value {
        Value::Exact(x) => json!(x.to_string()),
        enclosed => {
            let interval = enclosed.enclosure();
            json!([interval.lo(), interval.hi()])
        }
    }
}

fn row(pattern: &Pattern, report: &Report) -> Json {
    let side = report.side();
    let orbit = report.orbit.as_ref();
    let eigenvalue = side.filter(|_| report.flat.is_none()).and_then(|side| orbit?.eigenvalue_sign(side));
    json!({
        "pattern": pattern.periods(),
        "primitive": pattern.is_primitive(),
        "plus": word(report.plus),
        "minus": word(report.minus),
        "leading": orbit.and_then(|orbit| orbit.leading.as_ref()).map(value),
        "sign_eigenvalue": eigenvalue.map(|sign| sign.to_string()),
        "reason": report.reason.map(|reason| reason.to_string()),
        "X": orbit.map(|orbit| orbit.x.iter().map(|x| x.iter().map(value).collect()).collect::<Vec<Json>>()),
        "Y": orbit.map(|orbit| orbit.y.iter().map(value).collect::<Vec<Json>>()),
    })
}

/// Compares definition and claim at random points: the tally, as JSON.
#[pyfunction]
fn fuzz(
    py: Python<'_>,
    first: u64,
    last: u64,
    cases: u64,
    seed: u64,
    definition_share: f64,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<String> {
    watched(py, progress.as_ref(), move |watch| {
        if !(0.0..=1.0).contains(&definition_share) {
            return Err(Error::input(format!("definition_share = {definition_share}: from 0 to 1")));
        }
        if first == 0 || first > last {
            return Err(Error::input(format!("the periods {first}..={last}: from 1, and not empty")));
        }
        let options = FuzzOptions { first, last, cases, seed, definition_share };
        options.check_range()?;
        watch.begin(options.units().saturating_mul(options.block()), "cases");
        let tally = run_fuzz(&options, 0..options.units(), FuzzTally::default(), watch, |_| Ok(()))?;
        Ok(serde_json::to_string(&tally).map_err(std::io::Error::other)?)
    })
}
