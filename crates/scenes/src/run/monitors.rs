//! Monitors of a branch: functions of its orbits, as columns of its table, where they are labelled, and what
//! is held.

use std::ops::Deref;

use serde::{Serialize, Serializer};

use super::{Analysed, BranchRow, Complex, Row, Shown, Tabular, engine::OrbitSource};
use crate::{
    continuation::{FollowedOrbit, Level},
    error::Result,
    number::{Plain, Real},
    scene::{
        Scene,
        branches::BranchTask,
        monitors::{Extent, Monitor, Quantity},
    },
};

/// What is measured of an orbit for monitors, in the scene's units.
pub struct Measures {
    /// The forcing period.
    pub(crate) period: f64,
    /// The impulse of each impact; none where the orbit touches a stop that gives way.
    pub(crate) impulses: Option<Vec<f64>>,
    /// The least and the greatest of each coordinate, where they are asked for.
    pub(crate) extents: Vec<[f64; 2]>,
}

/// A point of a branch, with the task's monitors.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MonitoredRow {
    /// The point.
    #[serde(flatten)]
    pub row: BranchRow,
    /// Each monitor's name and value; none where it has none.
    #[serde(skip_serializing_if = "Vec::is_empty", serialize_with = "by_name")]
    pub monitors: Vec<(String, Option<f64>)>,
}

fn by_name<S: Serializer>(
    all: &[(String, Option<f64>)],
    serializer: S,
) -> std::result::Result<S::Ok, S::Error> {
    serializer.collect_map(all.iter().map(|(name, value)| (name, value)))
}

impl Deref for MonitoredRow {
    type Target = BranchRow;

    fn deref(&self) -> &BranchRow {
        &self.row
    }
}

impl Tabular for Vec<MonitoredRow> {
    fn columns(&self) -> Vec<&str> {
        let monitors = self.first().into_iter().flat_map(|first| &first.monitors);
        BranchRow::fields().into_iter().chain(monitors.map(|(name, _)| name.as_str())).collect()
    }

    fn cells(&self, digits: Option<usize>) -> Vec<Vec<String>> {
        let own = |row: &MonitoredRow| row.monitors.iter().map(|(_, value)| value.set(digits)).collect();
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
    /// A parameter that the scene does not have.
    pub fn new(task: &'a BranchTask, source: &'a S, scene: &Scene) -> Result<Self> {
        let names = [&task.parameter].into_iter().chain(&task.second);
        let varied = names.map(|name| Ok((name.as_str(), scene.parameter(name)?))).collect::<Result<_>>()?;
        let own = scene.parameters.iter().map(|(_, value)| Plain::ratio(value, &()).0).collect();
        Ok(Watch { monitors: &task.monitors.0, source, varied, own })
    }

    /// Where monitors take these values.
    pub fn levels<'w>(&'w self, wanted: &[(String, f64)]) -> Vec<Level<'w, S::Orbit>> {
        let level = |(name, value): &(String, f64)| {
            let monitor = self.monitors.iter().find(|monitor| monitor.name == *name)?;
            let of = Box::new(move |orbit: &S::Orbit, at: &[f64]| self.value(monitor, orbit, at).ok());
            Some(Level { name: name.clone(), of, value: *value })
        };
        wanted.iter().filter_map(level).collect()
    }

    /// What each monitor is at an orbit, and in `empty` how often it is not anything, and why at first.
    pub fn row(&self, orbit: &S::Orbit, at: &[f64], empty: &mut Vec<Empty>) -> Vec<(String, Option<f64>)> {
        let one = |monitor: &Monitor| {
            let value = self.value(monitor, orbit, at).map_err(|why| {
                let name = &monitor.name;
                match empty.iter_mut().find(|known| known.name == *name) {
                    Some(known) => known.count += 1,
                    None => empty.push(Empty { name: name.clone(), count: 1, why }),
                }
            });
            (monitor.name.clone(), value.ok())
        };
        self.monitors.iter().map(one).collect()
    }

    /// A monitor's value, or why it has none.
    fn value(&self, monitor: &Monitor, orbit: &S::Orbit, at: &[f64]) -> std::result::Result<f64, String> {
        let mut variables = self.own.clone();
        self.varied.iter().zip(at).for_each(|((_, place), value)| variables[*place] = *value);
        variables.resize(self.own.len() + monitor.quantities.len(), f64::NAN);
        let at: Vec<(&str, f64)> = self.varied.iter().map(|one| one.0).zip(at.iter().copied()).collect();
        let asked: Vec<(usize, &str, Quantity)> = monitor.asked(self.own.len()).collect();
        if !asked.is_empty() {
            let extents = asked.iter().any(|one| matches!(one.2, Quantity::Extent(..)));
            let seen = self.source.analysed(orbit, &at, None).map_err(|error| error.to_string())?.orbit;
            let measures = self.source.measure(orbit, &at, extents).map_err(|error| error.to_string())?;
            let periods = orbit.pattern().periods();
            for (place, word, quantity) in asked {
                let found = measures.of(quantity, &seen, periods);
                variables[place] = found.map_err(|why| format!("{word}: {why}"))?;
            }
        }
        let value = monitor.formula.at(&variables)[0];
        if value.is_finite() { Ok(value) } else { Err("its value is not finite".to_string()) }
    }
}

/// How often a monitor has no value.
#[derive(Debug, Clone, PartialEq)]
pub struct Empty {
    name: String,
    count: usize,
    why: String,
}

impl Empty {
    /// The same in a sentence, of so many points.
    pub(super) fn told(&self, points: usize) -> String {
        let Empty { name, count, why } = self;
        format!(
            "monitor {name} has no value at {count} of {points} points, whose cells are empty; at the first of them {why}"
        )
    }
}

impl Measures {
    /// A quantity of an orbit of so many periods, or why there is none.
    fn of(&self, quantity: Quantity, seen: &Analysed, periods: u32) -> std::result::Result<f64, String> {
        let none = |why: &str| why.to_string();
        let of_impact = |values: &[f64], i: Option<usize>, all: fn(&[f64]) -> f64| match (values, i) {
            ([], _) => Err(none("the orbit has no impacts")),
            (values, None) => Ok(all(values)),
            (values, Some(i)) => {
                let count = values.len();
                values.get(i).copied().ok_or_else(|| format!("the orbit has impacts 1 to {count}"))
            }
        };
        match quantity {
            Quantity::Period => Ok(self.period * f64::from(periods)),
            Quantity::LeastGap => {
                seen.least_gap.ok_or_else(|| none("no gap has a minimum away from the impacts"))
            }
            Quantity::Speed(i) => {
                of_impact(&seen.speeds, i, |all| all.iter().copied().fold(f64::NEG_INFINITY, f64::max))
            }
            Quantity::Phase(i) => of_impact(&seen.phases, Some(i), |_| f64::NAN),
            Quantity::Impulse(i) => {
                let all = self.impulses.as_deref();
                let all = all.ok_or_else(|| none("the orbit touches a stop that gives way"))?;
                of_impact(all, i, |all| all.iter().sum())
            }
            Quantity::Multiplier(i) => {
                let found = seen.multipliers.get(i).map(|Complex(re, im)| re.hypot(*im));
                found.ok_or_else(|| format!("there are multipliers 1 to {}", seen.multipliers.len()))
            }
            Quantity::Extent(i, what) => {
                let [least, greatest] =
                    *self.extents.get(i.unwrap_or(0)).ok_or_else(|| none("no coordinate"))?;
                Ok(match what {
                    Extent::Least => least,
                    Extent::Greatest => greatest,
                    Extent::Swing => 0.5 * (greatest - least),
                })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::monitors::COLUMNS;

    #[test]
    fn no_monitor_is_called_like_a_column() {
        assert_eq!(BranchRow::fields(), COLUMNS);
    }
}
