//! A branch as JSON, and a labelled point of it read back to go on from.

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::{
    Bifurcation, Branch, OrbitCurve, Orbits, crossing,
    curve::{CurvePoint, norm},
};
use crate::{
    error::{Error, Result},
    oscillator::{
        Side,
        orbit::{Itinerary, Strike},
    },
};

const FORMAT: &str = "grazing-branch 2";

#[derive(Serialize, Deserialize)]
struct Struck {
    wall: String,
    periods: u32,
}

/// A labelled point of a branch, as far as it is needed to go on from it.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// The pattern.
    pub itinerary: Itinerary,
    /// What happens there.
    pub event: Bifurcation,
    /// The parameter, or both.
    pub parameters: Vec<f64>,
    /// The unknowns of the pattern.
    pub z: Vec<f64>,
    /// The branch's direction: of the unknowns, then of the parameters as they are, to any length.
    pub tangent: Vec<f64>,
}

/// A branch over parameters of these names as JSON: the pattern, every point with its label if it has one,
/// the ends.
pub fn record(branch: &Branch, parameters: &[&str]) -> Value {
    let points: Vec<Value> = branch
        .points
        .iter()
        .map(|point| {
            json!({
                "label": point.label,
                "parameters": point.parameters,
                "unknowns": point.orbit.z,
                "tangent": point.tangent,
                "multipliers": point.orbit.multipliers.values(),
                "stable": point.orbit.multipliers.is_stable(),
                "admissible": point.orbit.admissibility.is_admissible(),
                "least_gap": point.orbit.least.map(|least| least.gap),
                "residual": point.orbit.residual,
                "newton_steps": point.orbit.steps,
                "length": point.length,
            })
        })
        .collect();
    let strikes = branch.itinerary.strikes().iter();
    let pattern: Vec<Struck> = strikes
        .map(|strike| Struck { wall: strike.side.name().to_string(), periods: strike.periods })
        .collect();
    json!({
        "format": FORMAT,
        "parameters": parameters,
        "pattern": pattern,
        "period": branch.itinerary.periods(),
        "ends": branch.ends.each_ref().map(ToString::to_string),
        "points": points,
    })
}

/// The point with a label in a branch written as JSON.
///
/// # Errors
/// An input error for text of another format, or a label that is not there, with those that are.
pub fn read_label(text: &str, label: &str) -> Result<Label> {
    #[derive(Deserialize)]
    struct File {
        format: String,
        pattern: Vec<Struck>,
        period: u32,
        points: Vec<BranchOrbit>,
    }
    #[derive(Deserialize)]
    struct BranchOrbit {
        label: Option<String>,
        parameters: Vec<f64>,
        unknowns: Vec<f64>,
        tangent: Vec<f64>,
    }
    let bad = |what: &dyn std::fmt::Display| Error::input(format!("not a branch that grazing wrote: {what}"));
    let file: File = serde_json::from_str(text).map_err(|error| bad(&error))?;
    if file.format != FORMAT {
        return Err(bad(&format_args!("its format is {:?}, not {FORMAT:?}", file.format)));
    }
    let labels: Vec<&str> = file.points.iter().filter_map(|point| point.label.as_deref()).collect();
    let point = file.points.iter().find(|point| point.label.as_deref() == Some(label)).ok_or_else(|| {
        Error::input(format!("the branch has no label {label:?}; it has {}", labels.join(", ")))
    })?;
    let event = label.rsplit_once(' ').and_then(|(name, _)| Bifurcation::named(name));
    let side = |name: &str| [Side::Lower, Side::Upper].into_iter().find(|side| side.name() == name);
    let strike = |struck: &Struck| {
        let side = side(&struck.wall).ok_or_else(|| bad(&format_args!("it has a wall {:?}", struck.wall)))?;
        Ok(Strike { side, periods: struck.periods })
    };
    let strikes = file.pattern.iter().map(strike).collect::<Result<Vec<_>>>()?;
    let free = strikes.is_empty();
    Ok(Label {
        itinerary: if free { Itinerary::free(file.period)? } else { Itinerary::new(strikes)? },
        event: event.ok_or_else(|| bad(&format_args!("it has a label {label:?}")))?,
        parameters: point.parameters.clone(),
        z: point.unknowns.clone(),
        tangent: point.tangent.clone(),
    })
}

impl Orbits<'_> {
    /// The point of this curve at a label.
    ///
    /// # Errors
    /// An input error if Newton's method does not come back to it, as when the scene has changed.
    pub fn restart(&self, label: &Label, options: &super::Options) -> Result<CurvePoint> {
        debug_assert_eq!(self.itinerary(), &label.itinerary);
        let u = self.unknowns(&label.z, label.parameters[0]);
        if !self.contains(label.parameters[0]) {
            let (low, high) = self.range();
            return Err(Error::input(format!(
                "the label's parameter, {}, is not in the range from {low} to {high}",
                label.parameters[0]
            )));
        }
        let gone = |error: Error| {
            error.context(format!("the {} is not on this branch; has the scene changed?", label.event.name()))
        };
        if label.event != Bifurcation::Crossing {
            return self.place(&u, options).map_err(gone);
        }
        // The tangent of the branch that the label is on tells it from the one that crosses.
        let mut tangent = label.tangent.clone();
        let last = tangent.last_mut().ok_or_else(|| Error::input("the label has no tangent"))?;
        *last /= self.unit();
        let length = norm(&tangent);
        tangent.iter_mut().for_each(|x| *x /= length);
        let near = CurvePoint { u, tangent, residual: 0.0, steps: 0 };
        Ok(crossing::locate(self, &near).map_err(gone)?.place)
    }
}
