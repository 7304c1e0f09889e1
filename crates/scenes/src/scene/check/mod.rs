//! What only a whole scene can tell of its tasks: parameters that exist, ranges, stops that are there, starts
//! on the right side; and what only one of the engines does.

mod orbit;
mod tasks;

use num_rational::BigRational;

use super::{
    branches::BranchStart,
    format::SceneFormat,
    measured::MeasuredForce,
    scene::{Body, Scene},
    sections::Frame,
    simulate::Start,
    task::Task,
};
use crate::{
    continuation::Options,
    error::{Error, Result},
    many::{Machine, StopLaw, push::StopForce},
    motion::{Contact, Side, System},
    rounding::SUM,
};

/// Harmonics that leave more than this part of a stop's swing at a sample are told of.
const COARSE: f64 = 1e-3;

/// Samples of a record that no whole period has.
fn left_out(record: &MeasuredForce) -> Option<String> {
    let MeasuredForce { file, left_out, periods, .. } = record;
    (*left_out > 1).then(|| {
        format!(
            "the last {left_out} samples of {file} are beyond its last whole period and are left out: {periods} \
             whole periods are used"
        )
    })
}

/// How many points and periods may be looked at.
const LONGEST: u32 = 10_000;
const POINTS: u32 = 1_000_000;

/// What a scene's tasks work on, in floats.
enum Model {
    One(System<f64>),
    Many(Machine<f64>),
}

/// A task with what it is checked against: a scene with the task's parameters.
struct Checked<'a> {
    scene: &'a Scene,
    model: &'a Model,
    /// Where the task stands.
    path: &'a str,
}

impl Scene {
    /// A task's scene, with the values it sets and then `changes`, and without the list of tasks, which may
    /// be long; checks all that can be checked before running.
    ///
    /// # Errors
    /// As [`Scene::exact`]; an input error for what the task's kind forbids.
    pub fn for_task(&self, task: &Task, changes: &[(String, BigRational)]) -> Result<Scene> {
        let scene = self.alone(&task.set)?.with(changes)?;
        let model = match scene.body {
            Body::Oscillator(_) => Model::One(scene.rounded()?),
            Body::Machine(_) => Model::Many(scene.machine(&[])?),
        };
        scene.wear()?;
        Checked { scene: &scene, model: &model, path: &task.path }.kind(&task.kind)?;
        Ok(scene)
    }

    /// What is allowed and likely to be a mistake.
    pub(crate) fn warnings(&self) -> Vec<String> {
        let idle = self.idle.iter().map(|name| {
            format!("the parameter {name} acts on nothing: it stands in no expression of the scene")
        });
        idle.chain(self.doubtful()).chain(self.moved()).collect()
    }

    /// What of the stops and of a measured force is likely to be a mistake.
    fn doubtful(&self) -> Vec<String> {
        let adds = |what: String, value: &dyn std::fmt::Display| {
            format!("the restitution of {what} is {value}, above 1: every impact there adds energy")
        };
        let Ok(scene) = self.machine_scene() else {
            let Ok(system) = self.rounded() else { return Vec::new() };
            let sides = [Side::Lower, Side::Upper].into_iter();
            let walls = sides.filter_map(|side| Some((side, system.wall(side)?.restitution)));
            let gains = walls.filter(|(_, restitution)| *restitution > 1.0).map(|(side, value)| {
                let stop = self.stops.iter().find(|stop| stop.side == Some(side));
                let name = stop.map_or(side.name(), |stop| &stop.name);
                adds(format!("{} {name}", self.format.stop()), &value)
            });
            // With a cubic spring or a formula both are common.
            let linear = system.cubic == 0.0 && system.smooth.is_none();
            let signs = [
                ("damping", system.damping, "it feeds energy in, and without impacts motions grow"),
                ("stiffness", system.stiffness, "the place of rest repels"),
            ];
            let signs = signs.into_iter().filter(|(_, value, _)| linear && *value < 0.0);
            return gains
                .chain(signs.map(|(key, _, means)| format!("the {key} is negative: {means}")))
                .collect();
        };
        let laws = self.machine(&[]).map(|machine| machine.stops).unwrap_or_default();
        let faster = laws.iter().filter_map(|stop| {
            let StopLaw::Speed(law) = &stop.law else { return None };
            let (name, v) = (&stop.name, law.above_one()?);
            let text = &law.text;
            Some(format!(
                "the restitution of stop {name}, {text}, is above 1 at the speed v = {v}: impacts there add energy"
            ))
        });
        let pushed = laws.iter().filter_map(|stop| {
            let StopLaw::Formula(law) = &stop.law else { return None };
            let (depth, speed) = StopForce::new(law, 1.0).gains()?;
            Some(format!(
                "the law of stop {}, {}, pushes harder as the stop is left than as it is entered, as at the depth {depth:e} \
                 with the speed {speed:e}: contacts there add energy",
                stop.name, law.text()
            ))
        });
        let stops = scene.machine.stops.iter();
        let gains = stops.filter_map(|stop| {
            let value = self.number(&stop.wall.restitution).ok().filter(|value| *value > 1.0)?;
            Some(adds(format!("stop {}", stop.name), &value))
        });
        let measured = scene.measured.iter().filter_map(left_out);
        gains.chain(faster).chain(pushed).chain(measured).collect()
    }

    /// What the harmonics of measured motions of stops leave out.
    fn moved(&self) -> impl Iterator<Item = String> {
        self.whole.moved.iter().flat_map(|(name, found)| {
            let MeasuredForce { file, residual, mean, harmonics, .. } = found;
            let swing = harmonics.iter().map(|[cos, sin]| cos.hypot(*sin)).sum::<f64>();
            let words = match harmonics.len() {
                1 => "1 harmonic says".to_string(),
                count => format!("{count} harmonics say"),
            };
            let off = (*residual > COARSE * swing + SUM * mean.abs()).then(|| {
                format!("the stop {name} moves as {words}, up to {residual:.3e} from a sample of {file}")
            });
            left_out(found).into_iter().chain(off)
        })
    }
}

impl Checked<'_> {
    fn key(&self, key: &str) -> String {
        format!("{}.{key}", self.path)
    }

    /// What is wrong with a key of the task.
    fn fail<T>(&self, key: &str, message: &str) -> Result<T> {
        Err(self.scene.fail(&self.key(key), message))
    }

    /// Refuses what the engine `one` does alone.
    fn only_one(&self, key: &str, what: &str) -> Result<()> {
        match self.model {
            Model::One(_) => Ok(()),
            Model::Many(_) => self.fail(key, &self.scene.only_one(what)),
        }
    }

    /// How many coordinates a state has.
    fn coordinates(&self) -> usize {
        match self.model {
            Model::One(_) => 1,
            Model::Many(machine) => machine.points(),
        }
    }

    fn parameter(&self, name: &str) -> Result<()> {
        self.scene.check_parameter(name, &self.key("parameter"))
    }

    /// The parameter that `over` names, and its range; each a key of the task, with its value.
    fn range<T: PartialOrd>(
        &self,
        (over, parameter): (&str, &str),
        (key, range): (&str, &[T]),
    ) -> Result<()> {
        self.scene.check_parameter(parameter, &self.key(over))?;
        match range {
            [low, high] if low < high => Ok(()),
            _ => self.fail(key, "must hold two numbers, the smaller first"),
        }
    }

    fn within(&self, key: &str, value: u32, least: u32, most: u32) -> Result<()> {
        if (least..=most).contains(&value) {
            return Ok(());
        }
        self.fail(key, &format!("is outside {least} to {most}"))
    }

    fn positive(&self, key: &str, values: &[f64]) -> Result<()> {
        match values.iter().all(|value| *value > 0.0) {
            true => Ok(()),
            false => self.fail(key, "must be positive"),
        }
    }

    fn options(&self, options: &Options) -> Result<()> {
        options.checked().map(drop).or_else(|error| self.fail("options", &error.to_string()))
    }

    /// What reach and options must be.
    fn reach(&self, reach: Option<f64>, options: &Options) -> Result<()> {
        self.positive("reach", reach.as_slice())?;
        self.options(options)
    }

    /// Whether a state can be started from. Refuses starts behind a rigid stop.
    fn start(&self, start: &Start, key: &str) -> Result<()> {
        let (scene, path) = (self.scene, self.key(key));
        match self.model {
            Model::One(system) => {
                let state = scene.state(start)?;
                for contact in Contact::of(system)? {
                    let at = contact.position.at(state.t)[0];
                    // A start on the wall may be behind it by rounding.
                    if contact.gap(state)[0] < -1e-12 * (1.0 + at.abs()) {
                        let (q, side, stop) = (state.q, contact.side.name(), scene.format.stop());
                        let values = scene.where_parameters();
                        let message =
                            format!("starts at q = {q}, behind the {side} {stop}, which is at {at}{values}");
                        return Err(scene.fail(&path, &message));
                    }
                }
            }
            Model::Many(machine) => {
                let state = scene.machine_state(start, machine, &path)?;
                for contact in machine.contacts()? {
                    let gap = contact.gap(&state)[0];
                    let size = contact.position.at(state.t)[0].abs() + contact.row.amax() * state.q.amax();
                    // A start on the stop may be behind it by rounding; a compliant one may be pushed in.
                    if contact.soft.is_none() && gap < -1e-12 * size {
                        let message = format!("starts behind the stop {}: its gap is {gap:e}", contact.name);
                        return Err(scene.fail(&path, &message));
                    }
                }
            }
        }
        Ok(())
    }

    /// The plane of a section or a diagram.
    fn plane(&self, plane: &[String]) -> Result<()> {
        let names = [["q", "u"], ["q1", "u1"]];
        match self.model {
            Model::Many(machine) => self.scene.plane(plane, machine, &self.key("plane")).map(drop),
            Model::One(_) if plane.is_empty() || names.iter().any(|names| plane == names) => Ok(()),
            Model::One(_) => self.fail(
                "plane",
                "is q and u where the engine is \"one\": leave it out; with engine = \"many\" it may have the gap of a stop",
            ),
        }
    }

    /// A frame moves as a stop of the engine `one`.
    fn frame(&self, frame: Frame) -> Result<()> {
        let (scene, side) = (self.scene, frame.side());
        match self.model {
            Model::Many(_) if frame != Frame::Fixed => {
                let gap =
                    "the plane [\"gap NAME\", \"rate NAME\"] of a section or diagram has the gap of a stop";
                self.fail("frame", &format!("{}; {gap}", scene.only_one("moves with a stop")))
            }
            // Branches and diagrams of format 1 may name a wall that is not there.
            Model::One(system) if scene.format == SceneFormat::Three => match side {
                Some(side) if system.wall(side).is_none() => {
                    self.fail("frame", &format!("there is no {} stop", side.name()))
                }
                _ => Ok(()),
            },
            _ => Ok(()),
        }
    }

    /// That there is something to graze.
    fn stops(&self) -> Result<()> {
        if self.scene.stops.is_empty() && self.scene.format != SceneFormat::One {
            return self.fail("kind", "needs a stop that could be grazed: there is none");
        }
        Ok(())
    }

    fn branch_starts(&self, starts: &[BranchStart], key: &str) -> Result<()> {
        for (i, start) in (1..).zip(starts) {
            let key = format!("{key}[{i}]");
            let wrong = |error: Error| self.scene.fail(&self.key(&key), &error.to_string());
            start.origin().map_err(wrong)?;
            if let Some(orbit) = &start.orbit {
                self.orbit(orbit, &format!("{key}.orbit"))?;
            }
            if let (Some(start), Model::Many(_)) = (&start.attractor, self.model) {
                self.start(start, &format!("{key}.attractor"))?;
            }
        }
        Ok(())
    }
}
