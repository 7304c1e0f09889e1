//! The orbits of a machine over a parameter.

use std::f64::consts::TAU;

use super::{
    super::{
        super::{
            Job, Measures,
            branch::{events, settled},
        },
        AnalysedEvent, Branches, Grazed, OrbitSource,
    },
    analysed, machine_orbits, named, names, speeds,
};
use crate::{
    continuation::{Bifurcation, FollowedOrbit, Label, Located, RecordForm, SearchReach, read_label_as},
    error::{Error, Result},
    many::{
        Family, Machine,
        attracting::attracting,
        branch::{Patterns, Plane},
        grazing::own_reach,
        measure::measure,
        normal_form::normal_form,
        orbit::{Itinerary, Orbit},
    },
    scene::{
        MachineSceneFamily,
        branches::{BranchOrigin, BranchStart, BranchTask},
        orbits::OrbitKeys,
    },
};

/// The format of a machine's branch in a file.
const FORMAT: &str = "grazing-machine-branch 1";

/// The form in which branches of a machine with stops of these names are written.
pub fn form<'n>(names: &'n [&'n str]) -> RecordForm<'n> {
    RecordForm { format: FORMAT, contacts: names }
}

/// The orbits of a scene's machine over a parameter.
pub struct MachineSource<'a> {
    family: &'a MachineSceneFamily<'a>,
    /// What is searched for orbits with given patterns.
    pub patterns: Patterns<'a>,
    machine: &'a Machine<f64>,
    job: &'a Job<'a>,
}

impl<'a> MachineSource<'a> {
    /// # Errors
    /// Those of [`Patterns::new`].
    pub fn new(
        family: &'a MachineSceneFamily<'a>,
        machine: &'a Machine<f64>,
        job: &'a Job<'a>,
    ) -> Result<MachineSource<'a>> {
        let depth = job.scene.machine_scene()?.minimum_depth;
        let patterns = Patterns::new(family, family.value(), depth)?;
        Ok(MachineSource { family, patterns, machine, job })
    }

    fn admissible(&self, keys: &OrbitKeys, machine: &Machine<f64>) -> Result<Vec<Orbit>> {
        let simulator = self.job.machine_simulator(machine, &[])?;
        let mut found = machine_orbits(keys, machine, &simulator, self.job)?.found;
        found.retain(FollowedOrbit::is_orbit);
        alone(&found, machine)?;
        Ok(found)
    }
}

/// Refuses orbits that are not alone: of what sticks all the time there is one for each place.
fn alone(orbits: &[Orbit], machine: &Machine<f64>) -> Result<()> {
    let Some(held) = orbits.iter().find_map(|orbit| orbit.held) else { return Ok(()) };
    Err(Error::input(format!(
        "friction {} sticks all the time: such orbits fill a stretch of places, and have no branch",
        machine.friction[held].name
    )))
}

impl<'a> OrbitSource for MachineSource<'a> {
    type Orbit = Orbit;
    type Family = Patterns<'a>;

    fn family(&self) -> &Patterns<'a> {
        &self.patterns
    }

    fn value(&self) -> f64 {
        self.family.value()
    }

    fn present(&self, keys: &OrbitKeys) -> Result<Vec<Orbit>> {
        self.admissible(keys, self.machine)
    }

    fn orbits(&self, start: &BranchStart, at: f64) -> Result<Vec<Orbit>> {
        let (machine, _) = self.family.at(at)?;
        match start.origin()? {
            BranchOrigin::Attractor(state) => {
                let from = self.job.scene.machine_state(state, &machine, "attractor")?;
                let planar = self.job.planar(&machine, std::slice::from_ref(&from), &[])?;
                let start = from.start(machine.rate());
                let found = attracting(&planar, &start, &settled(from.t), self.job.monitor)?;
                alone(std::slice::from_ref(&found), &machine)?;
                Ok(Some(found).filter(FollowedOrbit::is_orbit).into_iter().collect())
            }
            BranchOrigin::Orbit(keys) => self.admissible(keys, &machine),
            BranchOrigin::Restart(_) => Ok(Vec::new()),
        }
    }

    fn reaches(&self, reach: Option<f64>, orbits: &[Orbit]) -> Result<Vec<SearchReach>> {
        let unit = own_reach(self.family, self.value(), None)?;
        Ok(vec![SearchReach::Parameter { unit, reach: reach.unwrap_or(unit) }; orbits.len()])
    }

    fn analysed(
        &self,
        orbit: &Orbit,
        at: &[(&str, f64)],
        event: Option<Bifurcation>,
    ) -> Result<AnalysedEvent> {
        let (machine, form) = match at {
            &[(_, parameter)] => {
                let (machine, slope) = self.family.at(parameter)?;
                let form = event.map(|event| normal_form(&machine, &slope, orbit, event));
                (machine, form)
            }
            _ => (self.job.scene.machine(at)?, None),
        };
        Ok(AnalysedEvent { orbit: analysed(orbit, &machine, event), form })
    }

    fn measure(&self, orbit: &Orbit, at: &[(&str, f64)], is_far: bool) -> Result<Measures> {
        let machine = match *at {
            [(_, parameter)] => self.family.at(parameter)?.0,
            _ => self.job.scene.machine(at)?,
        };
        let depth = self.job.scene.machine_scene()?.minimum_depth;
        let (impulses, extents) = measure(&machine, depth, (orbit, is_far))?;
        Ok(Measures { period: machine.period, impulses, extents })
    }

    fn named_with_speeds(&self, orbit: &Orbit) -> (String, Vec<f64>) {
        (self.named(&orbit.itinerary), speeds(orbit, self.machine.rate()))
    }

    fn grazed(&self, at: &Located<Orbit>) -> Result<Option<Grazed>> {
        let (machine, _): (Machine<f64>, _) = self.family.at(at.parameter)?;
        let rate = machine.rate();
        Ok(at.orbit.least.map(|least| Grazed {
            parameter: at.parameter,
            stop: machine.stops[least.stop].name.clone(),
            phase: (least.phase / TAU).fract(),
            acceleration: least.acceleration * rate * rate,
            region: None,
            map: None,
            sound: true,
            residual: at.orbit.residual,
        }))
    }

    fn loci(&self, task: &BranchTask, second: &str) -> Result<Branches<Orbit>> {
        let at =
            |[first, other]: [f64; 2]| self.job.scene.machine(&[(&task.parameter, first), (second, other)]);
        let value = MachineSceneFamily::new(&self.job.scene, second)?.value();
        let depth = self.job.scene.machine_scene()?.minimum_depth;
        let plane = Plane::new(&at, [self.value(), value], depth, self.family.tally())?;
        events(task, second, (self, &plane), self.job)
    }

    fn label(&self, text: &str, label: &str) -> Result<Label<Itinerary>> {
        read_label_as(text, label, form(&names(self.machine)))
    }

    fn named(&self, pattern: &Itinerary) -> String {
        named(pattern, self.machine)
    }
}
