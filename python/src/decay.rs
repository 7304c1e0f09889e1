//! Frequency and damping ratio from a free decay.

use grazing_scenes::tolerance::{Decay, Estimate};
use numpy::PyReadonlyArray1;
use pyo3::{prelude::*, types::PyModule, wrap_pyfunction};
use serde_json::json;

use crate::watch::at_once;

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(decay, module)?)
}

/// What a record says, as JSON; both arrays have the same length.
#[pyfunction]
fn decay(
    py: Python<'_>,
    times: PyReadonlyArray1<'_, f64>,
    displacements: PyReadonlyArray1<'_, f64>,
) -> PyResult<String> {
    let (times, displacements) = (times.as_array(), displacements.as_array());
    let samples: Vec<(f64, f64)> = times.iter().copied().zip(displacements.iter().copied()).collect();
    let found = at_once(py, move || Decay::fit(&samples))?;
    let both = |one: Estimate| json!({ "value": one.value, "deviation": one.deviation });
    let report = json!({
        "samples": found.samples,
        "duration": found.duration,
        "periods": found.periods,
        "frequency": both(found.frequency),
        "damping_ratio": both(found.damping_ratio),
        "correlation": found.correlation,
        "offset": both(found.offset),
        "amplitude": found.amplitude,
        "rms": found.rms,
        "runs": found.runs,
        "expected_runs": found.expected_runs,
        "durbin_watson": found.durbin_watson,
    });
    Ok(report.to_string())
}
