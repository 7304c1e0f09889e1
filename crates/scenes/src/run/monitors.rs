//! Monitors of a branch: functions of its orbits, as columns of its table, where they are labelled, and what
//! is held.

use std::{collections::BTreeMap, ops::Deref};

use serde::Serialize;

use super::{Analysed, BranchRow, Complex, Row, Shown, Tabular, engine::OrbitSource};
use crate::{
    continuation::{FollowedOrbit, Level},
    error::{Error, Result},
    number::{Plain, Real},
    scene::{
        Scene,
        branches::BranchTask,
        monitors::{Asked, Monitor},
    },
};

/// What is measured of an orbit for monitors, in the scene's units.
pub struct Measures {
    /// The forcing period.
    pub(crate) period: f64,
    /// The impulse of each impact; empty where the orbit touches a stop that gives way.
    pub(crate) impulses: Vec<f64>,
    /// The least and the greatest of each coordinate, where they are asked for.
    pub(crate) extents: Vec<[f64; 2]>,
}

/// A point of a branch, with the task's monitors.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MonitoredRow {
    /// The point.
    #[serde(flatten)]
    pub row: BranchRow,
    /// Each monitor's value by its name; none where it has none.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub monitors: BTreeMap<String, Option<f64>>,
}

impl Deref for MonitoredRow {
    type Target = BranchRow;

    fn deref(&self) -> &BranchRow {
        &self.row
    }
}

impl Tabular for Vec<MonitoredRow> {
    fn columns(&self) -> Vec<&str> {
        let monitors = self.first().into_iter().flat_map(|first| first.monitors.keys());
        BranchRow::fields().into_iter().chain(monitors.map(String::as_str)).collect()
    }

    fn cells(&self, digits: Option<usize>) -> Vec<Vec<String>> {
        let own = |row: &MonitoredRow| row.monitors.values().map(|value| value.set(digits)).collect();
        self.iter().map(|row| [row.row.cells(digits), own(row)].concat()).collect()
    }
}

/// The monitors of a task, on the orbits of a source.
pub(super) struct Watch<'a, S> {
    monitors: &'a [Monitor],
    source: &'a S,
    /// The parameters that vary, with their places in the scene.
    varied: Vec<(&'a str, usize)>,
    /// The scene's own values.
    own: Vec<f64>,
}

impl<'a, S: OrbitSource> Watch<'a, S> {
    /// # Errors
    /// A parameter that the scene does not have; a monitor that is called like another column.
    pub fn new(task: &'a BranchTask, source: &'a S, scene: &Scene) -> Result<Self> {
        let names = [&task.parameter].into_iter().chain(&task.second);
        let varied = names.map(|name| Ok((name.as_str(), scene.parameter(name)?))).collect::<Result<_>>()?;
        let own = scene.parameters.iter().map(|(_, value)| Plain::ratio(value, &()).0).collect();
        let mut monitors = task.monitors.0.iter().map(|monitor| monitor.name.as_str());
        match monitors.find(|name| BranchRow::fields().contains(name)) {
            None => Ok(Watch { monitors: &task.monitors.0, source, varied, own }),
            Some(name) => {
                Err(Error::input(format!("{name} is a column already: call the monitor otherwise")))
            }
        }
    }

    /// Where monitors take these values.
    pub fn levels<'w>(&'w self, wanted: impl Iterator<Item = &'w (String, f64)>) -> Vec<Level<'w, S::Orbit>> {
        let level = |(name, value): &(String, f64)| {
            let monitor = self.monitors.iter().find(|monitor| monitor.name == *name)?;
            let of = Box::new(move |orbit: &S::Orbit, at: &[f64]| self.value(monitor, orbit, at).ok());
            Some(Level { name: name.clone(), of, value: *value })
        };
        wanted.filter_map(level).collect()
    }

    /// What each monitor is at an orbit; in `empty` why one has had no value at first.
    pub fn row(
        &self,
        orbit: &S::Orbit,
        at: &[f64],
        empty: &mut BTreeMap<String, String>,
    ) -> BTreeMap<String, Option<f64>> {
        let one = |monitor: &Monitor| {
            let value = self.value(monitor, orbit, at).map_err(|why| {
                empty.entry(monitor.name.clone()).or_insert(why);
            });
            (monitor.name.clone(), value.ok())
        };
        self.monitors.iter().map(one).collect()
    }

    /// A monitor's value, or why it has none.
    fn value(&self, monitor: &Monitor, orbit: &S::Orbit, at: &[f64]) -> std::result::Result<f64, String> {
        let mut variables = self.own.clone();
        self.varied.iter().zip(at).for_each(|((_, place), value)| variables[*place] = *value);
        let at: Vec<(&str, f64)> = self.varied.iter().map(|one| one.0).zip(at.iter().copied()).collect();
        let is_asked = |i: &usize| monitor.formula.mentions(&|place| place == self.own.len() + i);
        let asked: Vec<usize> = (0..monitor.asked.len()).filter(is_asked).collect();
        variables.resize(self.own.len() + monitor.asked.len(), f64::NAN);
        let is_far = asked.iter().any(|&i| ["swing", "q_min", "q_max"].contains(&monitor.asked[i].kind));
        if !asked.is_empty() {
            let seen = self.source.analysed(orbit, &at, None).map(|found| found.orbit);
            let both = seen.and_then(|seen| Ok((seen, self.source.measure(orbit, &at, is_far)?)));
            let (seen, measures) = both.map_err(|error| error.to_string())?;
            for i in asked {
                let of = (&seen, &measures, orbit.pattern().periods());
                variables[self.own.len() + i] = quantity(&monitor.asked[i], of)?;
            }
        }
        let value = monitor.formula.at(&variables)[0];
        if value.is_finite() { Ok(value) } else { Err("its value is not finite".to_string()) }
    }
}

/// A quantity of an orbit of so many periods, or that it has none.
fn quantity(
    asked: &Asked,
    (seen, measures, periods): (&Analysed, &Measures, u32),
) -> std::result::Result<f64, String> {
    let extents = measures.extents.iter();
    let all: Vec<f64> = match asked.kind {
        "period" => vec![measures.period * f64::from(periods)],
        "least_gap" => seen.least_gap.into_iter().collect(),
        "speed" => seen.speeds.clone(),
        "phase" => seen.phases.clone(),
        "impulse" => measures.impulses.clone(),
        "multiplier" => seen.multipliers.iter().map(|Complex(re, im)| re.hypot(*im)).collect(),
        "q_min" => extents.map(|ends| ends[0]).collect(),
        "q_max" => extents.map(|ends| ends[1]).collect(),
        _ => extents.map(|ends| 0.5 * (ends[1] - ends[0])).collect(),
    };
    let found = match (asked.kind, asked.number) {
        ("speed", None) => all.iter().copied().reduce(f64::max),
        ("impulse", None) => all.iter().copied().reduce(|sum, x| sum + x),
        (_, number) => all.get(number.unwrap_or(1) - 1).copied(),
    };
    found.ok_or_else(|| format!("{} is not there: the orbit has {} of its kind", asked.word, all.len()))
}
