//! What holds at all points of a box of parameters: words, and shares of the box.

use grazing_scenes::{
    Error, Monitor, Result,
    existence::Resonance,
    local::Region,
    num_rational::BigRational,
    search::WordPlace,
    tolerance::{LAST_PERIOD, MOST_CELLS, ParameterBox, Partition, Share, Subject, SubjectVerdict},
    word::{Rectangle, Word},
};
use pyo3::{prelude::*, types::PyModule, wrap_pyfunction};
use serde_json::{Value as Json, json};

use crate::{
    exact::Exact,
    places::{Told, certificate_kind, certified, check_limits, side},
    watch::{Watch, watched},
};

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(word_in_box, module)?)?;
    module.add_function(wrap_pyfunction!(shares, module)?)
}

/// The ends of a parameter.
type Ends = (Exact, Exact);

fn ends((lower, upper): Ends) -> [BigRational; 2] {
    [lower.0, upper.0]
}

fn of(kind: &str, first: [BigRational; 2], second: [BigRational; 2]) -> Result<ParameterBox> {
    match kind {
        "plane" => ParameterBox::plane(first, second),
        "polar" => ParameterBox::polar(first, second),
        _ => ParameterBox::machine(first, second),
    }
}

/// What the words of all points of a box have in common, as `word` has it of a point.
#[pyfunction]
fn word_in_box(
    py: Python<'_>,
    first: Ends,
    second: Ends,
    kind: String,
    max_period: u64,
    letters: usize,
    certificate: Option<String>,
) -> PyResult<Told> {
    watched(py, None, move |watch| {
        check_limits(max_period, letters)?;
        let (first, second) = (ends(first), ends(second));
        // Of (a₁, a₂) as the command line: a rectangle may meet several regions, and has certificates.
        let rectangle =
            (kind == "plane").then(|| Rectangle::new(first.clone(), second.clone())).transpose()?;
        let of = of(&kind, first, second)?;
        let words = [true, false].map(|positive| match &rectangle {
            Some(rectangle) => Word::in_rectangle(rectangle, positive, letters, watch),
            None => of.word(positive, letters, watch),
        });
        let [ahead, behind] = words;
        let words = [ahead?, behind?];
        let region = match &rectangle {
            Some(rectangle) => rectangle.region(),
            None => (!of.has_gamma()).then_some(Region::Three),
        };
        let sides: Vec<Json> =
            words.iter().map(|word| side(word, false, max_period)).collect::<Result<_>>()?;
        let met = words[1].straddled_resonance();
        let report = json!({
            "region": region,
            "reversed": false,
            "words": sides,
            "resonances": met.iter().map(|n| (n, Resonance::First)).collect::<Vec<_>>(),
            "born_there": met.map(Resonance::across).iter().collect::<Vec<_>>(),
        });
        let report = report.to_string();
        let Some(certificate) = certificate else { return Ok((report, None, None)) };
        let Some(rectangle) = &rectangle else {
            return Err(Error::input(
                "a certificate is for a point, or a box of a1 and a2; there is none yet of others",
            ));
        };
        let kind = certificate_kind(&certificate, max_period)?;
        certified(report, WordPlace::Rectangle(rectangle), &words, kind, watch)
    })
}

/// The shares of a box in which chaos is born, each period occurs, each word is that of the point: JSON.
#[pyfunction]
fn shares(
    py: Python<'_>,
    first: Ends,
    second: Ends,
    kind: String,
    cells: u64,
    last: u64,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<String> {
    watched(py, progress.as_ref(), move |watch| {
        if !(1..=MOST_CELLS).contains(&cells) {
            return Err(Error::input(format!("cells = {cells}: from 1 to {MOST_CELLS}")));
        }
        if !(1..=LAST_PERIOD).contains(&last) {
            return Err(Error::input(format!("max_period = {last}: from 1 to {LAST_PERIOD} of a box")));
        }
        Ok(all_shares(&of(&kind, ends(first), ends(second))?, cells, last, watch)?.to_string())
    })
}

fn all_shares(of: &ParameterBox, cells: u64, last: u64, watch: &Watch) -> Result<Json> {
    watch.begin(0, "cells");
    let partition = Partition::new(of, cells, watch)?;
    let sign = |positive: bool| if positive { 1 } else { -1 };
    let gamma = of.gamma_is_positive();
    let row = |SubjectVerdict { subject, share }| {
        let (what, positive, more) = match subject {
            Subject::Chaos(signs) => {
                let gamma = signs.gamma.or(gamma).map(sign);
                ("chaos", signs.positive, json!({ "sign_gamma": gamma }))
            }
            Subject::Period { positive, n } => ("period", positive, json!({ "n": n })),
            Subject::Word { positive, word } => {
                let periods: Vec<u64> = word.vertices().iter().map(|vertex| vertex.period).collect();
                let more =
                    json!({ "letters": word.letters(), "periods": periods, "endless": word.is_endless() });
                ("word", positive, more)
            }
        };
        let mut row = told(&share);
        row["what"] = json!(what);
        row["sign_emu"] = json!(sign(positive));
        if let (Json::Object(row), Json::Object(more)) = (&mut row, more) {
            row.extend(more);
        }
        row
    };
    let rows: Vec<Json> = partition.verdicts(of.signs(), last).into_iter().map(row).collect();
    Ok(json!({
        "sign_gamma": gamma.map(sign),
        "cells": partition.cells(),
        "cut": partition.is_cut(),
        "settled": partition.settled().to_string(),
        "rows": rows,
    }))
}

fn told(share: &Share) -> Json {
    let point = |at: &Option<Vec<BigRational>>| {
        at.as_ref().map(|at| at.iter().map(ToString::to_string).collect::<Vec<_>>())
    };
    json!({
        "verdict": share.spread().word(),
        "lower": share.lower.to_string(),
        "upper": share.upper.to_string(),
        "with": point(&share.with),
        "without": point(&share.without),
    })
}
