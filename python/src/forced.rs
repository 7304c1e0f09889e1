//! What the package is told where the work ends as it never did: a refutation, a disagreement of two methods,
//! an undecided sign. For tests, which see what users would be shown then. What is made up is the library's
//! finding; from there it goes the way of every finding.

use grazing_scenes::{certificate::Rejection, existence::decide, search::Proof};
use pyo3::{exceptions::PyValueError, prelude::*, types::PyModule, wrap_pyfunction};

use crate::{
    classify::each_kind,
    failure::raise,
    proofs::{proved, verdict},
};

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(forced, module)?)
}

/// What `verify` gives for a proof of period 5 of the kind `what` and with a certificate asked for,
/// `check_text` for a rejection of that kind, or `classify` and `classify_many` for every kind of row
/// ("existence").
#[pyfunction]
fn forced<'py>(py: Python<'py>, what: &str) -> PyResult<Bound<'py, PyAny>> {
    let reason = || "as forced".to_string();
    let rejection = match what {
        "malformed" => Rejection::Malformed { line: 7, reason: reason() },
        "false" => Rejection::False { line: 7, reason: reason() },
        "open" => Rejection::Undecided { line: 7, reason: reason() },
        "existence" => return Ok(each_kind(py)?.into_pyobject(py)?.into_any()),
        _ => return proof(py, what),
    };
    let answer = verdict(Err(rejection), String::new(), "the certificate").map_err(|error| raise(py, &error));
    Ok(answer?.into_pyobject(py)?.into_any())
}

fn proof<'py>(py: Python<'py>, what: &str) -> PyResult<Bound<'py, PyAny>> {
    let mut proof = Proof::default();
    proof.periods = 1;
    match what {
        "refuted" => {
            let mut decision = decide(5).map_err(|error| raise(py, &error))?;
            decision.disagreement =
                Some((grazing_scenes::existence::intervals(5).ok().and_then(|mut all| all.next()), None));
            proof.refuted = Some(decision);
        }
        "contradiction" => proof.contradiction = Some(5),
        "undecided" => proof.undecided = 1,
        "pending" => proof.pending = 1,
        other => return Err(PyValueError::new_err(format!("{other:?} is not forced"))),
    }
    Ok(proved(py, (5, 5), true, |_| Ok(proof), None)?.into_pyobject(py)?.into_any())
}
