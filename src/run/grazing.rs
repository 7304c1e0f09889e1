//! Tasks of kind `grazing`: a grazing bifurcation, and what is born there.

use serde::Serialize;

use super::{ChaosRow, Complex, Finding, Job, Judgement, Lines, Status, birth::all_patterns, orbit, row};
use crate::{
    continuation::{Bifurcation, BranchSearch, nearest},
    error::{Error, Result},
    one::{
        branch::OscillatorPatterns,
        grazing::{self, Grazing, LocalMap},
        orbit::{Family, find},
    },
    pattern::{Graph, Pattern, PatternExistence, Patterns, Report as Verdict},
    scene::{SceneFamily, orbits::GrazingTask},
};

row! {
    /// What the local theory says of an impact pattern, and the orbit of the true system near by.
    pub struct BornRow {
        /// The pattern, in periods of the orbit that grazes.
        pub pattern: String,
        /// On which side of the bifurcation an orbit is born, or what is open.
        pub side: String,
        /// L: the large multiplier of one round of the pattern is L µ^{−m} to leading order, µ the parameter
        /// less its value at grazing.
        pub coefficient: Option<f64>,
        /// The parameter at which the orbit was found.
        pub found_at: Option<f64>,
        /// The times of its impacts, as its pattern counts them, the first in [0, 2π).
        pub phases: Option<Vec<f64>>,
        /// Their incoming relative speeds.
        pub speeds: Option<Vec<f64>>,
        /// The larger multiplier.
        pub lambda1: Option<Complex>,
        /// The smaller.
        pub lambda2: Option<Complex>,
        /// Whether it is an orbit.
        pub admissible: Option<Judgement>,
        /// Why not, or why nothing is decided.
        pub reason: Option<String>,
    }
}

/// What a search for a grazing came to.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum GrazingSearch<R> {
    /// One was found.
    Found(Box<R>),
    /// None within reach, or no orbit to begin with.
    Nothing {
        /// The parameter.
        varied: String,
        /// Its value at the start.
        start: f64,
        /// Why.
        #[serde(skip)]
        reason: String,
    },
}

/// What a search for a grazing bifurcation of an oscillator came to.
pub type GrazingFindings = GrazingSearch<GrazingReport>;

impl<R: Finding> Finding for GrazingSearch<R> {
    fn status(&self) -> Status {
        match self {
            GrazingSearch::Found(found) => found.status(),
            GrazingSearch::Nothing { reason, .. } => Status::nothing(reason.clone()),
        }
    }

    fn lines(&self, lines: &mut Lines) {
        match self {
            GrazingSearch::Found(found) => found.lines(lines),
            GrazingSearch::Nothing { varied, start, .. } => {
                lines.say("start", format!("{varied} = {start:?}"));
            }
        }
    }
}

/// A grazing bifurcation with its local map, and the patterns that are born there.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GrazingReport {
    /// The parameter.
    pub varied: String,
    /// Its value at grazing.
    pub parameter: f64,
    /// The pattern of the orbit that grazes.
    pub orbit: String,
    /// The wall that is grazed.
    pub wall: &'static str,
    /// t_G, in [0, 2π).
    pub phase: f64,
    /// a_G.
    pub acceleration: f64,
    /// A, by rows.
    pub matrix: [[f64; 2]; 2],
    /// a₁ = tr A.
    pub a1: f64,
    /// a₂ = det A.
    pub a2: f64,
    /// The larger eigenvalue of A.
    pub lambda1: Complex,
    /// The smaller.
    pub lambda2: Complex,
    /// The region of the plane of (a₁, a₂), 1 to 5 or `line`; none for a₂ ≤ 0.
    pub region: Option<String>,
    /// γ.
    pub gamma: f64,
    /// e.
    pub e: f64,
    /// Whether the orbit is one but for the tangency.
    pub admissible: Judgement,
    /// What is left of the equations.
    pub residual: f64,
    /// Whether patterns are counted in half periods: the orbit is symmetric, grazes both walls, and the map
    /// is that of half its period followed by the mirror; A and what follows from it are that map's.
    pub half: bool,
    /// Why the local theory does not apply, if it does not.
    pub open: Option<String>,
    /// Whether chaos is born, on either side, by all patterns together; none for a₂ ≤ 0, where patterns are
    /// only listed.
    pub chaos: Option<Vec<ChaosRow>>,
    /// The patterns that are born or open.
    pub born: Vec<BornRow>,
    /// How many of them are open.
    #[serde(skip)]
    undecided: usize,
}

impl Finding for GrazingReport {
    fn status(&self) -> Status {
        match (&self.open, self.undecided) {
            (Some(reason), _) => Status::undecided(reason.clone()),
            (None, 0) if self.admissible == Judgement::No => {
                Status::undecided("the orbit that grazes is not one: what is born there is not decided")
            }
            (None, 0) => Status::Done,
            (None, open) => Status::undecided(format!("{open} patterns are open; the table has the reasons")),
        }
    }

    fn lines(&self, lines: &mut Lines) {
        lines.say("grazing", format!("{} = {:?}", self.varied, self.parameter));
        lines.say("orbit", self.orbit.as_str());
        lines.say("wall", self.wall);
        if self.half {
            lines.say(
                "map",
                "of half a period, then the mirror: both walls are grazed; patterns count halves",
            );
        }
        lines.say("t_G", self.phase);
        lines.say("a_G", self.acceleration);
        lines.say("A", self.matrix);
        lines.say("a1", self.a1);
        lines.say("a2", self.a2);
        lines.say("lambda1", self.lambda1);
        lines.say("lambda2", self.lambda2);
        lines.say("region", self.region.as_deref().unwrap_or("none"));
        lines.say("gamma", self.gamma);
        lines.say("e", self.e);
        lines.say("admissible", self.admissible);
        lines.say("residual", self.residual);
        if let Some(open) = &self.open {
            lines.say("open", open.as_str());
        }
        if self.open.is_none() {
            let words = match &self.chaos {
                Some(rows) => ChaosRow::sentences(rows, self.half),
                None => "not decided: that needs a2 > 0 and gamma, e other than 0".into(),
            };
            lines.say("chaos", words);
        }
        lines.table("born", &self.born);
    }
}

/// Follows the branch of the orbit to the nearest grazing, and asks the local theory there.
///
/// # Errors
/// Those of the orbit's search, of the branch and of the local theory; an interruption.
pub fn grazing(task: &GrazingTask, job: &Job) -> Result<GrazingFindings> {
    let family = job.family(&task.parameter)?;
    let start = family.value();
    let orbits = task.orbit.orbits(&family.at(start)?)?;
    let nothing =
        |reason: String| Ok(GrazingFindings::Nothing { varied: task.parameter.clone(), start, reason });
    let Some(orbit) = orbits.iter().find(|orbit| orbit.admissibility.is_admissible()) else {
        return nothing(format!("no admissible orbit to begin with at {} = {start}", task.parameter));
    };
    job.check()?;
    let (patterns, extent) =
        (OscillatorPatterns::new(&family, start)?, task.extent(&family.at(start)?, orbit));
    let located =
        match nearest(&patterns, Bifurcation::Grazing, orbit, start, extent, &task.options.checked()?)? {
            BranchSearch::Found(found) => found,
            BranchSearch::Nothing(why) => return nothing(why.to_string()),
        };
    let event = grazing::locate(&family, &located.orbit, located.parameter)?;
    // Two grazings in a period are the theory's business only if a symmetry makes them one.
    let half = event.half_map(&family.at(event.parameter)?);
    let map = half.as_ref().unwrap_or(&event.map);
    let [lambda1, lambda2] = map.multipliers.values().map(Complex::from);
    let mut found = GrazingReport {
        varied: task.parameter.clone(),
        parameter: event.parameter,
        orbit: orbit.itinerary.to_string(),
        wall: event.side().name(),
        phase: event.phase(),
        acceleration: map.acceleration,
        matrix: map.a,
        a1: map.multipliers.trace,
        a2: map.multipliers.determinant,
        lambda1,
        lambda2,
        region: map.region().map(|region| region.to_string()),
        gamma: map.gamma(),
        e: map.e(),
        admissible: match (event.second, event.admissible) {
            (Some(_), _) if half.is_none() => Judgement::Marginal,
            (Some(_), _) => Judgement::Yes,
            (None, true) => Judgement::Yes,
            (None, false) => Judgement::No,
        },
        residual: event.residual,
        half: half.is_some(),
        open: event.second.filter(|_| half.is_none()).map(|second| {
            format!(
                "the orbit grazes twice in its period, also at the {} wall: the local theory is for one grazing",
                second.side.name()
            )
        }),
        chaos: None,
        born: Vec::new(),
        undecided: 0,
    };
    if found.open.is_some() {
        return Ok(GrazingFindings::Found(Box::new(found)));
    }
    let side = |positive: bool| {
        let above = positive == (map.e() > 0.0);
        format!("{} {} {}", task.parameter, if above { '>' } else { '<' }, shown(event.parameter))
    };
    found.chaos = all_patterns(map, side, job.monitor)?;
    let local = map.to_map()?;
    let size = family.at(event.parameter)?.unit(&event.itinerary);
    let graph = Graph::new(&local, task.max_period.into(), false)?;
    let patterns = (1..=task.max_period).flat_map(|period| Patterns::of_period(period.into()));
    for pattern in patterns.filter(Pattern::is_primitive) {
        job.check()?;
        let verdict = graph.judge(pattern.periods());
        if verdict.side().is_some() || verdict.is_open() {
            found.born.push(born(task, &family, (&event, half.as_ref(), size), &pattern, &verdict)?);
        }
        found.undecided += usize::from(verdict.is_open());
    }
    Ok(GrazingFindings::Found(Box::new(found)))
}

/// A row: what the local theory says of a pattern, and the orbit of the true system at the distance asked
/// for.
fn born(
    task: &GrazingTask,
    family: &SceneFamily,
    (event, half, size): (&Grazing, Option<&LocalMap>, f64),
    pattern: &Pattern,
    verdict: &Verdict,
) -> Result<BornRow> {
    let map = half.unwrap_or(&event.map);
    let e = map.e();
    let mut row = BornRow {
        pattern: pattern.to_string(),
        side: String::new(),
        coefficient: None,
        found_at: None,
        phases: None,
        speeds: None,
        lambda1: None,
        lambda2: None,
        admissible: None,
        reason: verdict.reason.map(|reason| reason.to_string()),
    };
    let Some(side) = verdict.side() else {
        row.side = side_open(verdict).into();
        return Ok(row);
    };
    let away = if side { task.distance_at(size) } else { -task.distance_at(size) } / e;
    let periods: Vec<u64> = pattern.periods().to_vec();
    row.coefficient = map.leading(&periods).map(|leading| leading / e.powi(periods.len() as i32));
    row.side =
        format!("{} {} {}", task.parameter, if away > 0.0 { '>' } else { '<' }, shown(event.parameter));
    let parameter = match beside(&task.parameter, event.parameter, away) {
        Ok(parameter) => parameter,
        Err(error) => return Ok(BornRow { reason: Some(error.to_string()), ..row }),
    };
    row.found_at = Some(parameter);
    let (itinerary, z) = match half {
        Some(map) => event.half_start(map, &periods, verdict, parameter)?,
        None => event.start(family, &periods, verdict, parameter)?,
    };
    match find(&family.at(parameter)?, &itinerary, z) {
        Ok(found) => {
            let [lambda1, lambda2] = found.multipliers.values().map(Complex::from);
            (row.lambda1, row.lambda2) = (Some(lambda1), Some(lambda2));
            row.phases = Some(orbit::phases(&found));
            row.speeds = Some(orbit::speeds(&found));
            row.admissible = Some(orbit::admissible(&found, None));
            row.reason = row.reason.or(orbit::obstacle(&found, None));
        }
        Err(error) => row.reason = Some(error.to_string()),
    }
    Ok(row)
}

/// The parameter at a distance from a grazing.
///
/// # Errors
/// A distance of which too little is left beside the parameter, rounded.
pub(super) fn beside(name: &str, parameter: f64, away: f64) -> Result<f64> {
    let there = parameter + away;
    if ((there - parameter) / away - 1.0).abs() < 0.01 {
        return Ok(there);
    }
    let message = format!(
        "not looked for: in floating point {name} = {parameter:?} hardly changes by {away:e}, the task's `distance`: take a larger one"
    );
    Err(Error::input(message))
}

/// What of a pattern is open.
pub(super) fn side_open(verdict: &Verdict) -> &'static str {
    match (verdict.plus, verdict.minus) {
        (PatternExistence::NoOrbit, _) => "open for e mu < 0",
        (_, PatternExistence::NoOrbit) => "open for e mu > 0",
        _ => "open",
    }
}

/// A parameter value for reading: rounding's leavings at 0 left out.
pub(super) fn shown(value: f64) -> String {
    if value.abs() < 1e-14 { "0".into() } else { format!("{value:.6}") }
}
