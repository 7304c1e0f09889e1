//! Branches of periodic orbits of oscillators of one degree of freedom.

mod family;
mod normal_form;

use serde_json::Value;

pub use family::{Patterns, Plane, TwoParameterFamily};

use crate::{
    continuation::{
        Bifurcation, BranchPoint, BranchSearch, CurvePoint, EventCurve, Label, Options, OrbitBranch,
        PatternCurve, RecordForm, SearchReach, nearest, read_label_as, record_as,
    },
    error::Result,
    one::orbit::{Family, Itinerary, Orbit, find},
};

/// A point of a branch.
pub type BranchOrbit = BranchPoint<Orbit>;

/// A branch.
pub type Branch = OrbitBranch<Orbit>;

/// A curve of orbits over a parameter.
pub type Orbits<'a> = PatternCurve<'a, Patterns<'a>>;

/// A curve of bifurcations over two.
pub type Events<'a> = EventCurve<'a, Plane<'a>>;

impl Orbits<'_> {
    /// The orbit near `guess` at a parameter value, to start from; its tangent points to larger parameters.
    ///
    /// # Errors
    /// Those of [`find`]; an input error at a saddle-node, or outside the range.
    pub fn start(&self, guess: Vec<f64>, parameter: f64, options: &Options) -> Result<CurvePoint> {
        self.check_range(parameter)?;
        let orbit = find(&self.family.family().at(parameter)?, &self.itinerary, guess)?;
        self.start_at(&orbit, parameter, options)
    }
}

/// The bifurcation of a kind that is nearest along the branch through an orbit: followed both ways, no
/// further than `reach` in the norm of times, speeds and parameter ([`SearchReach::Length`], the parameter's
/// unit being 1), and not beyond the branch's ends as one
/// of orbits. Cost: as of the branch.
///
/// # Errors
/// An input error if the branch cannot be followed at the orbit itself.
pub fn locate(
    family: &dyn Family,
    bifurcation: Bifurcation,
    orbit: &Orbit,
    parameter: f64,
    reach: f64,
    options: &Options,
) -> Result<BranchSearch<Orbit>> {
    let patterns = Patterns::new(family, parameter)?;
    nearest(&patterns, bifurcation, orbit, parameter, SearchReach::Length { reach, unit: 1.0 }, options)
}

/// That of oscillators of one degree of freedom: lower wall, upper wall.
const OSCILLATOR: RecordForm = RecordForm { format: "grazing-branch 2", contacts: &["lower", "upper"] };

/// A branch over parameters of these names as JSON: the pattern, every point with its label if it has one,
/// the ends.
pub fn record(branch: &Branch, parameters: &[&str]) -> Value {
    record_as(branch, parameters, OSCILLATOR)
}

/// The point with a label in a branch written as JSON.
///
/// # Errors
/// An input error for text of another format, or a label that is not there, with those that are.
pub fn read_label(text: &str, label: &str) -> Result<Label<Itinerary>> {
    read_label_as(text, label, OSCILLATOR)
}
