//! The orbits of an oscillator over a parameter.

use std::f64::consts::TAU;

use super::{
    super::{
        super::{
            Job, Measures,
            branch::{events, settled},
        },
        AnalysedEvent, Branches, Grazed, OrbitSource,
    },
    analysed, named, speeds, turn,
};
use crate::{
    continuation::{Bifurcation, Label, Located, NormalForm, SearchReach, extents},
    error::Result,
    one::{
        attractor::attracting,
        branch::{Patterns, Plane, read_label},
        grazing,
        orbit::{Family, Itinerary, Orbit, OrbitImpact, Oscillator},
    },
    scene::{
        SceneFamily,
        branches::{BranchOrigin, BranchStart, BranchTask},
        orbits::{OrbitKeys, extent},
    },
    search::touch::InTheory as _,
};

/// The orbits of a scene's oscillator over a parameter.
pub struct OscillatorSource<'a> {
    family: &'a SceneFamily<'a>,
    patterns: Patterns<'a>,
    job: &'a Job<'a>,
}

impl<'a> OscillatorSource<'a> {
    /// # Errors
    /// Those of [`Patterns::new`].
    pub fn new(family: &'a SceneFamily<'a>, job: &'a Job<'a>) -> Result<OscillatorSource<'a>> {
        Ok(OscillatorSource { family, patterns: Patterns::new(family, family.value())?, job })
    }

    fn admissible(&self, keys: &OrbitKeys, oscillator: &Oscillator) -> Result<Vec<Orbit>> {
        let mut orbits = keys.orbits(oscillator, || self.job.check())?.found;
        orbits.retain(|orbit| orbit.admissibility.is_admissible());
        Ok(orbits)
    }
}

impl<'a> OrbitSource for OscillatorSource<'a> {
    type Orbit = Orbit;
    type Family = Patterns<'a>;

    fn family(&self) -> &Patterns<'a> {
        &self.patterns
    }

    fn value(&self) -> f64 {
        self.family.value()
    }

    fn present(&self, keys: &OrbitKeys) -> Result<Vec<Orbit>> {
        self.admissible(keys, &self.family.at(self.value())?)
    }

    fn orbits(&self, start: &BranchStart, at: f64) -> Result<Vec<Orbit>> {
        let oscillator = self.family.at(at)?;
        match start.origin()? {
            BranchOrigin::Attractor(state) => {
                let from = self.job.scene.state(state)?;
                Ok(vec![attracting(
                    &oscillator,
                    from,
                    &settled(from.t),
                    &self.job.settings()?,
                    self.job.monitor,
                )?])
            }
            BranchOrigin::Orbit(keys) => self.admissible(keys, &oscillator),
            BranchOrigin::Restart(_) => Ok(Vec::new()),
        }
    }

    fn reaches(&self, reach: Option<f64>, orbits: &[Orbit]) -> Result<Vec<SearchReach>> {
        let oscillator = self.family.at(self.value())?;
        Ok(orbits.iter().map(|orbit| extent(reach, &oscillator, orbit)).collect())
    }

    fn analysed(
        &self,
        orbit: &Orbit,
        at: &[(&str, f64)],
        event: Option<Bifurcation>,
    ) -> Result<AnalysedEvent> {
        let form = match (event, at) {
            (Some(event), &[(_, parameter)]) => {
                Some(NormalForm::at(&self.family.at(parameter)?, orbit, event))
            }
            _ => None,
        };
        Ok(AnalysedEvent { orbit: analysed(orbit, self.job, event), form })
    }

    fn measure(&self, orbit: &Orbit, at: &[(&str, f64)], is_far: bool) -> Result<Measures> {
        let oscillator = match *at {
            [(_, parameter)] => self.family.at(parameter)?,
            _ => self.job.oscillator(self.job.scene.plain(at)?)?,
        };
        let mass = self.job.scene.mass_at(at)?;
        let restitution = |side| oscillator.system().wall(side).map_or(f64::NAN, |wall| wall.restitution);
        let impulse = |hit: OrbitImpact| mass * (1.0 + restitution(hit.side)) * hit.speed * orbit.rate;
        let first = orbit.impacts().next().map_or(0.0, |_| orbit.z[0]);
        let seen = |t: f64| orbit.state(&oscillator, first + t).map(|state| vec![[state.q, state.u]]);
        Ok(Measures {
            period: TAU / orbit.rate,
            impulses: orbit.impacts().map(impulse).collect(),
            extents: if is_far { extents(orbit, seen)? } else { Vec::new() },
        })
    }

    fn named_with_speeds(&self, orbit: &Orbit) -> (String, Vec<f64>) {
        (self.named(&orbit.itinerary), speeds(orbit))
    }

    fn grazed(&self, at: &Located<Orbit>) -> Result<Option<Grazed>> {
        let event = grazing::locate(self.family, &at.orbit, at.parameter)?;
        let (map, rate) = (&event.map, at.orbit.rate);
        Ok(Some(Grazed {
            parameter: event.parameter,
            stop: self.job.stop(event.side()),
            phase: turn(event.phase()),
            acceleration: map.acceleration * rate * rate,
            region: map.region().map(|region| region.to_string()),
            map: map.gamma().map(|gamma| [gamma / rate, map.e]),
            sound: event.admissible,
            residual: event.residual,
        }))
    }

    fn loci(&self, task: &BranchTask, second: &str) -> Result<Branches<Orbit>> {
        let plane = |[first, other]: [f64; 2]| {
            let system = self.job.scene.plain(&[(&task.parameter, first), (second, other)])?;
            self.job.oscillator(system)
        };
        let value = SceneFamily::new(&self.job.scene, second)?.value();
        let plane = Plane::new(&plane, [self.value(), value])?;
        events(task, second, (self, &plane), self.job)
    }

    fn label(&self, text: &str, label: &str) -> Result<Label<Itinerary>> {
        read_label(text, label)
    }

    fn named(&self, pattern: &Itinerary) -> String {
        named(pattern, self.job)
    }
}
