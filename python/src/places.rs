//! What holds at a point (a₁, a₂) or (r, s): words, values. Single orbits are in `classify`.

use std::sync::OnceLock;

use grazing_scenes::{
    Error, Monitor, Result,
    existence::Resonance,
    local::{Answer, Forward, Ladder, Plane, Point, Polar, Quantity},
    num_rational::BigRational,
    number::{Precision, Sign, ball_digits},
    search::{Certified, WordCertificate, WordPlace, certify_word},
    word::{ClosedWalks, Edge, Entropy, Extent, Relation, Word},
};
use pyo3::{prelude::*, types::PyModule, wrap_pyfunction};
use serde_json::{Value as Json, json};

use crate::{
    exact::Exact,
    failure::raise,
    watch::{Watch, watched},
};

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(word, module)?)?;
    module.add_function(wrap_pyfunction!(evaluate, module)?)
}

/// π to many bits is computed once.
pub fn ladder() -> &'static Ladder {
    static LADDER: OnceLock<Ladder> = OnceLock::new();
    LADDER.get_or_init(Ladder::default)
}

/// The point with these coordinates, (r, s) or (a₁, a₂).
pub fn place(first: BigRational, second: BigRational, polar: bool) -> Result<Forward> {
    if polar { Forward::polar(first, second) } else { Forward::plane(first, second) }
}

/// The most letters and the largest period that are counted, as on the command line.
const LETTERS: usize = 2000;
const COUNTED: u64 = 400;

/// Words as JSON, a certificate, why there is none.
pub type Told = (String, Option<String>, Option<String>);

/// Refuses more periods and letters than are counted.
pub fn check_limits(max_period: u64, letters: usize) -> Result<()> {
    if !(1..=COUNTED).contains(&max_period) {
        return Err(Error::input(format!("max_period = {max_period}: from 1 to {COUNTED}")));
    }
    if !(1..=LETTERS).contains(&letters) {
        return Err(Error::input(format!("letters = {letters}: from 1 to {LETTERS}")));
    }
    Ok(())
}

/// The kind of certificate of this name.
pub fn certificate_kind(name: &str, last: u64) -> Result<WordCertificate> {
    match name {
        "signs" => Ok(WordCertificate::BySigns { last }),
        "theorem" => Ok(WordCertificate::ByTheorem),
        other => Err(Error::input(format!("certificate = {other:?}: \"signs\" or \"theorem\""))),
    }
}

/// A report of words with the certificate of them, or why there is none.
pub fn certified(
    report: String,
    at: WordPlace,
    words: &[Word],
    kind: WordCertificate,
    watch: &Watch,
) -> Result<Told> {
    let words: Vec<&Word> = words.iter().collect();
    Ok(match certify_word(at, &words, kind, &mut || watch.is_over())? {
        Certified::Text(text) => (report, Some(text), None),
        Certified::Undecided(why) => (report, None, Some(why)),
    })
}

/// The words at a point, and a certificate if one is asked for.
#[pyfunction]
fn word(
    py: Python<'_>,
    first: Exact,
    second: Exact,
    polar: bool,
    max_period: u64,
    letters: usize,
    certificate: Option<String>,
) -> PyResult<Told> {
    watched(py, None, move |watch| {
        check_limits(max_period, letters)?;
        let place = place(first.0, second.0, polar)?;
        let mut words = Vec::new();
        for positive in [true, false] {
            words.push(Word::at(ladder(), &place.point, positive, letters, watch)?);
        }
        let sides: Vec<Json> =
            words.iter().map(|word| side(word, place.reversed, max_period)).collect::<Result<_>>()?;
        let found = Resonance::up_to(&place.point, max_period);
        let report = json!({
            "region": place.region,
            "reversed": place.reversed,
            "words": sides,
            "resonances": found,
            "born_there": Resonance::in_words(&found),
        });
        let Some(certificate) = certificate else { return Ok((report.to_string(), None, None)) };
        let kind = certificate_kind(&certificate, max_period)?;
        if place.reversed {
            return Err(Error::input(
                "a certificate for a2 > 1: certify the time-reversed system, at a1/a2 and 1/a2 (or 1/r and s)",
            ));
        }
        certified(report.to_string(), WordPlace::Point(&place.point), &words, kind, watch)
    })
}

/// A word and its graphs, as JSON.
pub fn side(word: &Word, reversed: bool, last: u64) -> Result<Json> {
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
