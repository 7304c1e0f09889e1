//! Tasks of kind `grazing` on machines: where the motion without impacts grazes a stop, and what is born
//! there.
//!
//! Phases are fractions of the period, everything else is in the scene's units: the section's coordinates are
//! (q, q̇).

use std::f64::consts::TAU;

use serde::Serialize;

use super::{
    ChaosRow, Complex, Finding, Job, Judgement, Lines, Status,
    birth::all_patterns_at,
    grazing::{GrazingSearch, beside, shown, side_open},
    machine_orbit as orbit, row,
};
use crate::{
    error::Result,
    many::{
        Machine, MachineFamily, RealMatrix, StopLaw,
        grazing::{MachineGrazing, MachineSearch, locate, own_reach},
        orbit::find,
    },
    one::grazing::region_of,
    pattern::{Analysis, Numbers, Pattern, Patterns, Report as Verdict},
    scene::{MachineSceneFamily, orbits::GrazingTask},
};

row! {
    /// What the local theory says of an impact pattern, and the orbit of the machine near by.
    pub struct MachineBornRow {
        /// The pattern, in periods of the forcing.
        pub pattern: String,
        /// On which side of the bifurcation an orbit is born, or what is open.
        pub side: String,
        /// The large multiplier of one round of the pattern is this times µ^{−m} to leading order, µ the
        /// parameter less its value at grazing.
        pub coefficient: Option<f64>,
        /// The parameter at which the orbit was found.
        pub found_at: Option<f64>,
        /// The phases of its impacts, as fractions of the period.
        pub phases: Option<Vec<f64>>,
        /// Their incoming speeds, in the scene's units.
        pub speeds: Option<Vec<f64>>,
        /// The multipliers of largest modulus, at most four.
        pub multipliers: Option<Vec<Complex>>,
        /// Whether it is an orbit.
        pub admissible: Option<Judgement>,
        /// Why not, or why nothing is decided.
        pub reason: Option<String>,
    }
}

/// What a search for a grazing of a machine came to.
pub type MachineGrazingFindings = GrazingSearch<MachineGrazingReport>;

/// A grazing bifurcation of a machine with its local map, and the patterns that are born there.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MachineGrazingReport {
    /// The parameter.
    pub varied: String,
    /// Its value at grazing.
    pub parameter: f64,
    /// The stop that is grazed.
    pub stop: String,
    /// t_G, as a fraction of the period.
    pub phase: f64,
    /// a_G: the second derivative of the gap there, per unit of time squared.
    pub acceleration: f64,
    /// A, by rows, in coordinates (q, q̇) less those of the motion.
    #[serde(rename = "A")]
    pub a: Vec<Vec<f64>>,
    /// B.
    #[serde(rename = "B")]
    pub b: Vec<f64>,
    /// C.
    #[serde(rename = "C")]
    pub c: Vec<f64>,
    /// e: how fast the least gap opens with the parameter.
    pub e: f64,
    /// The eigenvalues of A, the largest modulus first.
    pub eigenvalues: Vec<Complex>,
    /// a₁ = tr A; only of one degree of freedom.
    pub a1: Option<f64>,
    /// a₂ = det A; only of one degree of freedom.
    pub a2: Option<f64>,
    /// γ; only of one degree of freedom.
    pub gamma: Option<f64>,
    /// The region of the plane of (a₁, a₂), 1 to 5 or `line`; only of one degree of freedom, and for a₂ > 0.
    pub region: Option<String>,
    /// What is left of the gap.
    pub residual: f64,
    /// Whether the map is of half a period, for a symmetric machine that grazes a stop and its mirror:
    /// patterns count halves then, and the stops alternate with them.
    pub half: bool,
    /// Why the local theory does not apply, if it does not.
    pub open: Option<String>,
    /// Whether chaos is born, on either side, by all patterns together; absent where no word decides.
    pub chaos: Option<Vec<ChaosRow>>,
    /// Why it is not decided whether chaos is born.
    pub chaos_open: Option<String>,
    /// The patterns that are born or open.
    pub born: Vec<MachineBornRow>,
    /// How many of them are open.
    #[serde(skip)]
    undecided: usize,
}

/// A least gap that changes over the reach by less than this, relative to the gaps' motion, does not pass
/// through 0.
const FLAT: f64 = 1e-9;

/// A matrix of more rows than this is not shown in text.
const SHOWN: usize = 6;

impl Finding for MachineGrazingReport {
    fn status(&self) -> Status {
        match (&self.open, self.undecided) {
            (Some(reason), _) => Status::undecided(reason.clone()),
            (None, 0) => Status::Done,
            (None, open) => Status::undecided(format!("{open} patterns are open; the table has the reasons")),
        }
    }

    fn lines(&self, lines: &mut Lines) {
        lines.say("grazing", format!("{} = {:?}", self.varied, self.parameter));
        lines.say("stop", self.stop.as_str());
        if self.half {
            let what = "of half a period, then the mirror: the stop and its mirror are grazed; patterns count halves";
            lines.say("map", what);
        }
        lines.say("t_G", self.phase);
        lines.say("a_G", self.acceleration);
        if self.b.len() <= SHOWN {
            for (name, row) in std::iter::repeat("A").zip(&self.a) {
                lines.say(name, row.clone());
            }
            lines.say("B", self.b.clone());
            lines.say("C", self.c.clone());
        }
        lines.say("e", self.e);
        lines.say("eigenvalues", self.eigenvalues.iter().copied().take(SHOWN).collect::<Vec<_>>());
        if self.eigenvalues.len() > SHOWN {
            lines.say("more_eigenvalues", self.eigenvalues.len() - SHOWN);
        }
        if let (Some(a1), Some(a2), Some(gamma)) = (self.a1, self.a2, self.gamma) {
            lines.say("a1", a1);
            lines.say("a2", a2);
            lines.say("region", self.region.as_deref().unwrap_or("none"));
            lines.say("gamma", gamma);
        }
        lines.say("residual", self.residual);
        if let Some(open) = &self.open {
            lines.say("open", open.as_str());
        }
        if let Some(rows) = &self.chaos {
            lines.say("chaos", ChaosRow::sentences(rows, self.half));
        }
        if let Some(reason) = &self.chaos_open {
            lines.say("chaos", format!("not decided: {reason}"));
        }
        lines.table("born", &self.born);
    }
}

/// Follows the motion without impacts to the nearest grazing, and asks the local theory there.
///
/// # Errors
/// Those of [`locate`], of the local map and of the machine; an interruption.
pub fn machine_grazing(task: &GrazingTask, job: &Job) -> Result<MachineGrazingFindings> {
    let family = job.machine_family(&task.parameter)?;
    let start = family.value();
    let reach = task.reach.map_or_else(|| own_reach(&family, start), Ok)?;
    let event = match locate(&family, start, reach)? {
        MachineSearch::Found(found) => *found,
        MachineSearch::Nothing(reason) => {
            let varied = task.parameter.clone();
            return Ok(MachineGrazingFindings::Nothing { varied, start, reason });
        }
    };
    job.check()?;
    let (machine, _) = family.at(event.parameter)?;
    let rate = machine.rate();
    let map = event.local();
    let (n, one) = (machine.size, machine.size == 1);
    // From velocities per radian to velocities per unit of time.
    let unit = |i: usize| if i < n { 1.0 } else { rate };
    let scaled = RealMatrix::from_fn(2 * n, 2 * n, |i, j| map.a[(i, j)] * unit(i) / unit(j));
    let name = |stop: usize| machine.stops[stop].name.clone();
    let phase = event.at.phase / TAU;
    let mut found = MachineGrazingReport {
        varied: task.parameter.clone(),
        parameter: event.parameter,
        stop: name(event.at.stop),
        phase: if phase < 1.0 { phase } else { 0.0 },
        acceleration: map.acceleration * rate * rate,
        a: scaled.row_iter().map(|row| row.iter().copied().collect()).collect(),
        b: (0..2 * n).map(|i| map.b[i] * unit(i)).collect(),
        c: map.c.iter().copied().collect(),
        e: map.e,
        eigenvalues: map.eigenvalues.iter().map(|&x| Complex::from(x)).collect(),
        a1: one.then(|| map.a.trace()),
        a2: one.then_some(map.determinant),
        gamma: map.gamma().map(|gamma| gamma / rate),
        residual: event.at.gap.abs(),
        half: event.half.is_some(),
        region: one
            .then(|| region_of(map.a.trace(), map.determinant).map(|region| region.to_string()))
            .flatten(),
        open: None,
        chaos: None,
        chaos_open: None,
        born: Vec::new(),
        undecided: 0,
    };
    found.open = open(task, &event, &machine, reach);
    if found.open.is_none() {
        found.ask(task, job, &family, &event)?;
    }
    Ok(MachineGrazingFindings::Found(Box::new(found)))
}

/// Why the local theory is not for this grazing, looked for over `reach`; `None` where it is.
fn open(task: &GrazingTask, event: &MachineGrazing, machine: &Machine<f64>, reach: f64) -> Option<String> {
    let (map, rate) = (event.local(), machine.rate());
    let name = |stop: usize| &machine.stops[stop].name;
    if let StopLaw::Soft { damping, .. } = machine.stops[event.at.stop].law {
        return Some(format!(
            "stop {} gives way: what a contact of depth d changes is of the order of d{}, so the local map has no square \
             root, and the local theory is not for it",
            name(event.at.stop),
            if damping > 0.0 { "" } else { "^(3/2)" }
        ));
    }
    if let Some(other) = event.others.first().filter(|_| event.half.is_none()) {
        return Some(if other.stop == event.at.stop {
            format!(
                "the motion grazes stop {} more than once in its period: the local theory is for one grazing",
                name(other.stop)
            )
        } else {
            format!(
                "the motion grazes several stops in its period, {} and {} among them: the local theory is for one grazing",
                name(event.at.stop),
                name(other.stop)
            )
        });
    }
    if map.acceleration.is_nan() || map.acceleration <= 0.0 {
        return Some(format!(
            "a_G = {} at the touch: the local theory is for a positive one",
            map.acceleration * rate * rate
        ));
    }
    if map.e.is_nan() || map.e.abs() * reach <= FLAT * event.scale {
        return Some(format!(
            "e = {:e}: the least gap only touches 0 as {} varies, and the local theory is for one that passes through it",
            map.e, task.parameter
        ));
    }
    (event.at.gap.abs() > 1e-9 * event.scale).then(|| {
        format!("the least gap passes through 0 without being found there: {:e} is left", event.at.gap)
    })
}

impl MachineGrazingReport {
    /// What the local theory says: of chaos in two dimensions, of every pattern up to the task's period.
    fn ask(
        &mut self,
        task: &GrazingTask,
        job: &Job,
        family: &MachineSceneFamily,
        event: &MachineGrazing,
    ) -> Result<()> {
        let map = event.local();
        match map.gamma() {
            None => {
                let unit = if self.half { "half periods" } else { "periods" };
                self.chaos_open = Some(format!(
                    "the local map has {} dimensions and the word theorem is for two; the table has the patterns of up \
                     to {} {unit}",
                    map.a.nrows(),
                    task.max_period
                ));
            }
            Some(gamma) => {
                let side = |positive: bool| {
                    let above = positive == (map.e > 0.0);
                    let sign = if above { '>' } else { '<' };
                    format!("{} {sign} {}", task.parameter, shown(event.parameter))
                };
                let plane = [map.a.trace(), map.determinant];
                self.chaos = all_patterns_at(plane, gamma, map.e, side, job.monitor)?;
                if self.chaos.is_none() {
                    self.chaos_open = Some("that needs a2 > 0 and gamma other than 0".into());
                }
            }
        }
        let local = map.to_map()?;
        let analysis = Analysis::new(&local, task.max_period.into(), Numbers::Enclosed);
        let patterns = (1..=task.max_period).flat_map(|period| Patterns::of_period(period.into()));
        for pattern in patterns.filter(Pattern::is_primitive) {
            job.check()?;
            let verdict = analysis.judge(pattern.periods());
            if verdict.side().is_some() || verdict.is_open() {
                self.born.push(born(task, (job, family), event, &pattern, &verdict)?);
            }
            self.undecided += usize::from(verdict.is_open());
        }
        Ok(())
    }
}

/// A row: what the local theory says of a pattern, and the orbit of the machine at the distance asked for.
fn born(
    task: &GrazingTask,
    (job, family): (&Job, &MachineSceneFamily),
    event: &MachineGrazing,
    pattern: &Pattern,
    verdict: &Verdict,
) -> Result<MachineBornRow> {
    let mut row = MachineBornRow {
        pattern: pattern.to_string(),
        side: String::new(),
        coefficient: None,
        found_at: None,
        phases: None,
        speeds: None,
        multipliers: None,
        admissible: None,
        reason: verdict.reason.map(|reason| reason.to_string()),
    };
    let Some(side) = verdict.side() else {
        row.side = side_open(verdict).into();
        return Ok(row);
    };
    let distance = task.distance_at(event.scale);
    let away = if side { distance } else { -distance } / event.map.e;
    row.coefficient = verdict.orbit.as_ref().and_then(|orbit| orbit.leading.as_ref()).map(|leading| {
        let enclosed = leading.enclosure();
        let middle = enclosed.lo() + (enclosed.hi() - enclosed.lo()) / 2.0;
        middle / event.map.e.powi(pattern.periods().len() as i32)
    });
    row.side =
        format!("{} {} {}", task.parameter, if away > 0.0 { '>' } else { '<' }, shown(event.parameter));
    let parameter = match beside(&task.parameter, event.parameter, away) {
        Ok(parameter) => parameter,
        Err(error) => return Ok(MachineBornRow { reason: Some(error.to_string()), ..row }),
    };
    row.found_at = Some(parameter);
    let (machine, _): (Machine<f64>, _) = family.at(parameter)?;
    let simulator = job.machine_simulator(&machine, &[])?;
    let (strikes, start) = event.start(pattern.periods(), verdict, away)?;
    match find(&simulator, &strikes, &start) {
        Ok(found) => {
            let (admissible, why) = orbit::admissible(&found);
            row.multipliers = Some(orbit::multipliers(&found.multipliers));
            row.phases = Some(orbit::phases(&found));
            row.speeds = Some(orbit::speeds(&found, simulator.rate()));
            row.admissible = Some(admissible);
            row.reason = row.reason.or(why);
        }
        Err(error) => row.reason = Some(error.to_string()),
    }
    Ok(row)
}
