//! A branch as JSON, and a labelled point of it read back to go on from.

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::{
    Bifurcation, Itinerary, OrbitBranch, PatternCurve, Strike, crossing,
    curve::{CurvePoint, dot, norm},
    problem::{FollowedOrbit, PatternFamily, PatternOf},
};
use crate::{
    error::{Error, Result},
    motion::event::Place,
};

/// What a branch's file calls its system, and how it names the contacts of a pattern.
#[derive(Debug, Clone, Copy)]
pub struct RecordForm<'n> {
    /// The format's name and version.
    pub format: &'static str,
    /// The names of walls or stops, by number.
    pub contacts: &'n [&'n str],
}

#[derive(Serialize, Deserialize)]
struct Struck {
    wall: String,
    periods: u32,
}

/// A point of a branch, as far as it is needed to go on from it.
#[derive(Debug, Clone, PartialEq)]
pub struct Label<P> {
    /// The pattern.
    pub itinerary: P,
    /// The bifurcation there, if its label is one of codimension one.
    pub event: Option<Bifurcation>,
    /// The names of the parameters of the branch.
    pub names: Vec<String>,
    /// The parameter, or both.
    pub parameters: Vec<f64>,
    /// The unknowns of the pattern: radians, and what the file's lengths and speeds are in.
    pub z: Vec<f64>,
    /// The branch's direction: of the unknowns, then of the parameters as they are, to any length.
    pub tangent: Vec<f64>,
}

/// A branch over parameters of these names as JSON: the pattern, every point with its label if it has one,
/// the ends.
pub fn record_as<O: FollowedOrbit>(branch: &OrbitBranch<O>, parameters: &[&str], form: RecordForm) -> Value {
    let points: Vec<Value> = branch
        .points
        .iter()
        .map(|point| {
            let orbit = &point.orbit;
            let natural = |values: &[f64]| -> Vec<f64> {
                let count = orbit.unknowns().len();
                let unit = |i: usize| if i < count { orbit.unit(i) } else { 1.0 };
                values.iter().enumerate().map(|(i, x)| x * unit(i)).collect()
            };
            json!({
                "label": point.label,
                "parameters": point.parameters,
                "unknowns": natural(&orbit.unknowns()),
                "tangent": natural(&point.tangent),
                "multipliers": orbit.multipliers(),
                "stable": orbit.is_stable(),
                "admissible": orbit.is_orbit(),
                "least_gap": orbit.least_gap().map(|gap| gap * orbit.length_unit()),
                "residual": orbit.residual(),
                "newton_steps": orbit.newton_steps(),
                "length": point.length,
            })
        })
        .collect();
    let struck = |strike: &Strike<O::Place>| Struck {
        wall: form.contacts[strike.place.number()].to_string(),
        periods: strike.periods,
    };
    let pattern: Vec<Struck> = branch.itinerary.strikes().iter().map(struck).collect();
    json!({
        "format": form.format,
        "parameters": parameters,
        "pattern": pattern,
        "period": branch.itinerary.periods(),
        "ends": branch.ends.each_ref().map(ToString::to_string),
        "points": points,
    })
}

impl<P> Label<P> {
    /// The same over parameters of these names: those that the branch did not go along have the values that
    /// `own` gives, and no part in its direction.
    ///
    /// # Errors
    /// Those of `own`.
    pub fn over(self, names: &[&str], own: impl Fn(&str) -> Result<f64>) -> Result<Self> {
        let mut tangent = self.tangent[..self.z.len()].to_vec();
        let mut parameters = Vec::new();
        for name in names {
            let place = self.names.iter().position(|known| known == name);
            parameters.push(place.map_or_else(|| own(name), |place| Ok(self.parameters[place]))?);
            tangent.push(place.map_or(0.0, |place| self.tangent[self.z.len() + place]));
        }
        let names = names.iter().map(ToString::to_string).collect();
        Ok(Label { names, parameters, tangent, ..self })
    }
}

/// The point with a label in a branch written as JSON; "row 7" is the seventh of all.
///
/// # Errors
/// An input error for text of another format, or a label that is not there, with those that are; a
/// contact whose name is not among the form's; a pattern without a period.
pub fn read_label_as<P: Place>(text: &str, label: &str, form: RecordForm) -> Result<Label<Itinerary<P>>> {
    #[derive(Deserialize)]
    struct File {
        format: String,
        parameters: Vec<String>,
        pattern: Vec<Struck>,
        period: u32,
        points: Vec<Point>,
    }
    #[derive(Deserialize)]
    struct Point {
        label: Option<String>,
        parameters: Vec<f64>,
        unknowns: Vec<f64>,
        tangent: Vec<f64>,
    }
    let bad = |what: &dyn std::fmt::Display| Error::input(format!("not a branch that grazing wrote: {what}"));
    let file: File = serde_json::from_str(text).map_err(|error| bad(&error))?;
    if file.format != form.format {
        return Err(bad(&format_args!("its format is {:?}, not {:?}", file.format, form.format)));
    }
    let labels: Vec<&str> = file.points.iter().filter_map(|point| point.label.as_deref()).collect();
    let row = || file.points.get(label.strip_prefix("row ")?.parse::<usize>().ok()?.checked_sub(1)?);
    let labelled = file.points.iter().find(|point| point.label.as_deref() == Some(label));
    let point = labelled.or_else(row).ok_or_else(|| {
        let (rows, labels) = (file.points.len(), labels.join(", "));
        Error::input(format!("the branch has no label {label:?}; it has {labels}, row 1 to row {rows}"))
    })?;
    let event = point.label.as_deref().and_then(|label| Bifurcation::named(label.rsplit_once(' ')?.0));
    let strike = |struck: &Struck| {
        let contact = form.contacts.iter().position(|known| *known == struck.wall);
        let contact = contact.ok_or_else(|| bad(&format_args!("it has a wall {:?}", struck.wall)))?;
        Ok(Strike { place: P::numbered(contact), periods: struck.periods })
    };
    let strikes = file.pattern.iter().map(strike).collect::<Result<Vec<_>>>()?;
    let named = point.parameters.len() == file.parameters.len();
    if !named
        || point.parameters.is_empty()
        || point.tangent.len() != point.unknowns.len() + point.parameters.len()
    {
        return Err(bad(&"a point's unknowns, tangent and parameters do not fit"));
    }
    Ok(Label {
        itinerary: if strikes.is_empty() { Itinerary::free(file.period) } else { Itinerary::new(strikes) }?,
        event,
        names: file.parameters,
        parameters: point.parameters.clone(),
        z: point.unknowns.clone(),
        tangent: point.tangent.clone(),
    })
}

impl<F: PatternFamily + ?Sized> PatternCurve<'_, F> {
    /// The point of this curve at a label.
    ///
    /// # Errors
    /// An input error if Newton's method does not come back to it, as when the scene has changed.
    pub fn restart(
        &self,
        label: &Label<PatternOf<F::Orbit>>,
        options: &super::Options,
    ) -> Result<CurvePoint> {
        let count = self.family.count(&self.itinerary);
        if self.itinerary != label.itinerary || label.z.len() != count {
            return Err(Error::input(format!(
                "the label has {} unknowns; its pattern takes {count} here",
                label.z.len()
            )));
        }
        if !self.contains(label.parameters[0]) {
            let (low, high) = self.range();
            return Err(Error::input(format!(
                "the label's parameter, {}, is not in the range from {low} to {high}",
                label.parameters[0]
            )));
        }
        let own = |values: &[f64]| -> Vec<f64> {
            let unit = |i: usize| if i < count { self.family.unit(&self.itinerary, i) } else { 1.0 };
            values.iter().enumerate().map(|(i, x)| x / unit(i)).collect()
        };
        let u = self.unknowns(&own(&label.z), label.parameters[0]);
        let gone = |error: Error| {
            let what = label.event.map_or("point", Bifurcation::name);
            error.context(format!("the {what} is not on this branch; has the scene changed?"))
        };
        let mut tangent = own(&label.tangent);
        if label.event != Some(Bifurcation::Crossing) {
            let place = self.place(&u, options).map_err(gone)?;
            // Where a branch turns back no way is that of larger parameters: it is followed as it was.
            let turned = label.event == Some(Bifurcation::SaddleNode)
                && dot(&place.tangent[..count], &tangent[..count]) < 0.0;
            return Ok(if turned { place.reversed() } else { place });
        }
        // The tangent of the branch that the label is on tells it from the one that crosses.
        tangent.truncate(count + 1);
        let last = tangent.last_mut().ok_or_else(|| Error::input("the label has no tangent"))?;
        *last /= self.unit();
        let length = norm(&tangent);
        tangent.iter_mut().for_each(|x| *x /= length);
        let near = CurvePoint { u, tangent, residual: 0.0, steps: 0 };
        Ok(crossing::locate(self, &near).map_err(gone)?.place)
    }
}
