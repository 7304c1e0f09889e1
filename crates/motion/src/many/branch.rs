//! Machines as continuation sees them ([`branch`](crate::continuation)): their orbits over one
//! parameter and over two.
//!
//! With 2n multipliers the functions whose zeros are bifurcations are Π (1 − λ), Π (1 + λ) and, for
//! Neimark–Sacker points, every second modulus in descending order, less 1 ([`FollowedOrbit::circles`]). Over
//! two parameters a curve of Neimark–Sacker points is one of zeros of the least 1 − λ_iλ_j over pairs of
//! conjugates and of real multipliers, so that it goes on where a pair turns real. Which way a bifurcation
//! goes is in `normal_form`.

use std::{f64::consts::TAU, sync::Arc};

use super::{
    Family, Machine, State,
    contact::Contacts,
    critical::{nearest_pair, pairs, pairs_product, product, product_of_others, without},
    drift::Drifts,
    friction::check_given,
    normal_form::Local,
    orbit::{
        Admissibility, Between, Change, Itinerary, Orbit, StopEquations, check_stops, describe, multipliers,
    },
    simulate::{Settings, Simulator},
    sliding,
};
use crate::{
    continuation::{
        Bifurcation, Degeneracy, EventCurve, FollowedOrbit, Linearised, OrbitBranch, PatternFamily,
        PatternPlane, Root, STILL,
    },
    error::{Error, Result},
    many::LinearFlow,
    motion::{EffectTally, minimum::RELATIVE_DEPTH},
};
/// The orbits of one pattern of a machine at which one event happens, over two parameters.
pub type Events<'a> = EventCurve<'a, Plane<'a>>;
/// A branch of orbits of a machine.
pub type Branch = OrbitBranch<Orbit>;

/// What all orbits that are followed have in common.
#[derive(Debug, Clone)]
struct Common {
    /// The unit of lengths and speeds.
    scale: f64,
    /// The minimum depth of the simulator that tells orbits from other solutions.
    depth: f64,
    /// Where their work is added up.
    tally: Option<Arc<EffectTally>>,
}

impl Common {
    fn new(machine: &Machine<f64>, depth: Option<f64>, tally: Option<&Arc<EffectTally>>) -> Result<Common> {
        let settings = Settings::default();
        let simulator = Simulator::new(machine, &settings)?;
        let size = |size: f64| if size > 0.0 && size.is_finite() { size } else { 1.0 };
        let own = simulator.size();
        let gap = simulator.gap_scale();
        let (scale, gap) = (size(own), size(if gap > 0.0 { gap } else { own }));
        Ok(Common { scale, depth: depth.unwrap_or(RELATIVE_DEPTH * gap), tally: tally.cloned() })
    }

    fn orbit(&self, machine: &Machine<f64>, pattern: &Itinerary, root: Root) -> Result<Orbit> {
        let settings = Settings { minimum_depth: self.depth, ..Settings::default() };
        let simulator = Simulator::new(machine, &settings)?.counting_too(self.tally.as_ref());
        check_stops(pattern, simulator.contacts())?;
        describe(&simulator, pattern, self.scale, root)
    }

    fn count(machine_size: usize, pattern: &Itinerary) -> usize {
        2 * machine_size + 2 * pattern.strikes().len()
    }

    fn unit(&self, machine_size: usize, unknown: usize) -> f64 {
        if is_time(machine_size, unknown) { 1.0 } else { self.scale }
    }
}

/// The minimum depth of the simulator that tells orbits of a machine from other solutions.
pub(super) fn depth_of(machine: &Machine<f64>, depth: Option<f64>) -> Result<f64> {
    Ok(Common::new(machine, depth, None)?.depth)
}

fn is_time(machine_size: usize, unknown: usize) -> bool {
    unknown >= 2 * machine_size && unknown.is_multiple_of(2)
}

/// A machine ready for equations of orbits.
pub(super) struct Solved {
    pub flow: LinearFlow,
    pub contacts: Contacts,
    /// The machine passing through rigid stops, where it is not one linear machine.
    soft: Option<Simulator>,
    drifts: Option<Arc<Drifts>>,
}

impl Solved {
    /// # Errors
    /// Where the machine is not defined, or has not the pattern's stops.
    pub fn new(
        machine: &Machine<f64>,
        pattern: &Itinerary,
        depth: f64,
        tally: Option<&Arc<EffectTally>>,
    ) -> Result<Solved> {
        let flow = LinearFlow::new(machine.equations()?)?;
        check_given(machine.friction.iter().map(|friction| (&friction.name, friction.normal.stop())))?;
        let contacts = Contacts::new(flow.equations(), machine.contacts()?, machine.rubs()?);
        check_stops(pattern, &contacts)?;
        let soft = || contacts.all().iter().any(|contact| contact.soft.is_some());
        let soft = if machine.is_smooth() || !machine.friction.is_empty() || soft() {
            let settings = Settings { minimum_depth: depth, ..Settings::default() };
            Simulator::new(machine, &settings)?.counting_too(tally).through()?
        } else {
            None
        };
        let drifts = Drifts::of(machine, flow.equations())?;
        Ok(Solved { flow, contacts, soft, drifts })
    }

    pub fn equations<'s>(&'s self, pattern: &'s Itinerary, scale: f64) -> StopEquations<'s> {
        let (soft, drifts) = (self.soft.as_ref(), self.drifts.as_deref());
        let between = Between { flow: &self.flow, contacts: &self.contacts, soft, drifts };
        StopEquations::new(between, pattern, scale)
    }
}

/// Orbits of machines over one parameter.
pub struct Patterns<'a> {
    family: &'a dyn Family,
    size: usize,
    common: Common,
}

impl<'a> Patterns<'a> {
    /// The orbits of a family. Lengths are measured by the size of the gaps' motion at one value of the
    /// parameter; `depth` is the minimum depth of the simulator that tells orbits from other solutions, 10⁻¹²
    /// of that size if absent.
    ///
    /// # Errors
    /// Where the machine is not defined there.
    pub fn new(family: &'a dyn Family, at: f64, depth: Option<f64>) -> Result<Patterns<'a>> {
        let (machine, _) = family.at(at)?;
        let common = Common::new(&machine, depth, family.tally())?;
        Ok(Patterns { family, size: machine.size, common })
    }
}

impl Patterns<'_> {
    /// The gap to a stop when `phase` comes first after the first impact of an orbit.
    ///
    /// # Errors
    /// Where the machine is not defined.
    pub fn gap(&self, parameter: f64, orbit: &Orbit, stop: usize, phase: f64) -> Result<f64> {
        let contacts = self.family.at(parameter)?.0.contacts()?;
        Ok(contacts[stop].gap(&self.state(parameter, orbit, phase)?)[0])
    }

    /// The states of an orbit leg by leg, from just after an impact to just before the next, without impacts
    /// once around from phase 0: both ends, and evenly between, at least `places` for each period.
    ///
    /// # Errors
    /// Where the machine is not defined.
    pub fn legs(&self, parameter: f64, orbit: &Orbit, places: u32) -> Result<Vec<Vec<State>>> {
        let (machine, _) = self.family.at(parameter)?;
        let solved = Solved::new(&machine, &orbit.itinerary, self.common.depth, self.common.tally.as_ref())?;
        solved.equations(&orbit.itinerary, orbit.scale).legs(&orbit.z, places)
    }

    /// The state when `phase` comes first after the first impact of an orbit.
    ///
    /// # Errors
    /// Where the machine is not defined.
    pub fn state(&self, parameter: f64, orbit: &Orbit, phase: f64) -> Result<State> {
        let (machine, _) = self.family.at(parameter)?;
        let solved = Solved::new(&machine, &orbit.itinerary, self.common.depth, self.common.tally.as_ref())?;
        let equations = solved.equations(&orbit.itinerary, orbit.scale);
        equations.state(&orbit.z, (phase - orbit.state.t).rem_euclid(TAU))
    }
}

impl PatternFamily for Patterns<'_> {
    type Orbit = Orbit;

    fn count(&self, pattern: &Itinerary) -> usize {
        Common::count(self.size, pattern)
    }

    fn equations(&self, parameter: f64, pattern: &Itinerary, z: &[f64]) -> Result<Linearised> {
        let (machine, slope) = self.family.at(parameter)?;
        let solved = Solved::new(&machine, pattern, self.common.depth, self.common.tally.as_ref())?;
        let change = Change::new(&machine, &slope, &solved.flow, &solved.contacts)?;
        solved.equations(pattern, self.common.scale).linearise(z, Some(&change))
    }

    fn orbit(&self, parameter: f64, pattern: &Itinerary, root: Root) -> Result<Orbit> {
        self.common.orbit(&self.family.at(parameter)?.0, pattern, root)
    }

    /// The state after the first impact stays, the impacts come twice.
    fn twice(&self, _: &Itinerary, z: &[f64]) -> Vec<f64> {
        let (state, impacts) = z.split_at(2 * self.size);
        [state, impacts, impacts].concat()
    }

    fn once(&self, pattern: &Itinerary, z: &[f64]) -> Option<(Itinerary, Vec<f64>)> {
        let (state, impacts) = z.split_at(2 * self.size);
        let half = pattern.once(|first| impacts[2 * first] - impacts[0])?;
        Some((half, [state, &impacts[..impacts.len() / 2]].concat()))
    }

    fn is_time(&self, _: &Itinerary, unknown: usize) -> bool {
        is_time(self.size, unknown)
    }

    fn unit(&self, _: &Itinerary, unknown: usize) -> f64 {
        self.common.unit(self.size, unknown)
    }
}

impl FollowedOrbit for Orbit {
    type Place = usize;

    fn pattern(&self) -> &Itinerary {
        &self.itinerary
    }

    fn unknowns(&self) -> Vec<f64> {
        self.z.clone()
    }

    fn moved(&self, unknowns: &[f64]) -> Orbit {
        Orbit { z: unknowns.to_vec(), ..self.clone() }
    }

    fn is_time(&self, unknown: usize) -> bool {
        is_time(self.state.q.len(), unknown)
    }

    fn unit(&self, unknown: usize) -> f64 {
        if FollowedOrbit::is_time(self, unknown) { 1.0 } else { self.scale }
    }

    fn length_unit(&self) -> f64 {
        self.scale
    }

    fn speeds(&self) -> Vec<f64> {
        self.impacts.iter().map(|impact| impact.speed / self.scale).collect()
    }

    fn least_gap(&self) -> Option<f64> {
        self.least.map(|least| least.gap / self.scale)
    }

    fn is_orbit(&self) -> bool {
        let clear = self.least.is_none_or(|least| least.gap > 0.0);
        let comes_in = self.impacts.iter().all(|impact| impact.speed > 0.0);
        clear && comes_in && !matches!(self.admissibility, Admissibility::No(_))
    }

    fn residual(&self) -> f64 {
        self.residual
    }

    fn newton_steps(&self) -> usize {
        self.steps
    }

    fn multipliers(&self) -> Vec<(f64, f64)> {
        self.multipliers.clone()
    }

    fn slides_as(&self, other: &Orbit) -> bool {
        self.touches.contacts == other.touches.contacts
            && self.grips.len() == other.grips.len()
            && self.grips.iter().zip(&other.grips).all(|(a, b)| sliding::same(a, b))
    }

    fn begins_as(&self, other: &Orbit) -> bool {
        self.begins == other.begins
    }

    fn changed(&self, other: &Orbit) -> Bifurcation {
        // An impact that has lost its speed is what changes the order, if there is one.
        let slow = |orbit: &Orbit| FollowedOrbit::speeds(orbit).iter().any(|speed| speed.abs() <= 1e-9);
        if slow(self) || slow(other) {
            return Bifurcation::Fade;
        }
        if self.touches.contacts != other.touches.contacts {
            return Bifurcation::Grazing;
        }
        sliding::between(&self.grips, &other.grips)
    }

    fn is_stable(&self) -> bool {
        self.multipliers.iter().all(|(re, im)| re.hypot(*im) < 1.0)
    }

    fn fold(&self) -> f64 {
        product(&self.multipliers, -1.0)
    }

    fn flip(&self) -> f64 {
        product(&self.multipliers, 1.0)
    }

    fn rotates(&self) -> bool {
        nearest_pair(&self.multipliers).is_some_and(|pair| pair.sum.abs() <= 2.0 * (1.0 + 1e-7))
    }

    fn is_at(&self, bifurcation: Bifurcation) -> bool {
        let speeds = FollowedOrbit::speeds(self);
        let moving = speeds.iter().all(|speed| speed.abs() > STILL);
        let nearest = |to: f64| {
            self.multipliers.iter().map(|(re, im)| (re - to).hypot(*im)).fold(f64::INFINITY, f64::min)
        };
        match bifurcation {
            // A multiplier moves like the square root of the parameter there: half the digits.
            Bifurcation::SaddleNode | Bifurcation::Crossing => moving && nearest(1.0) <= 1e-4,
            Bifurcation::Flip => moving && nearest(-1.0) <= 1e-6,
            Bifurcation::Torus => {
                let mut pairs = pairs(&self.multipliers);
                moving && pairs.any(|pair| pair.complex && pair.off.abs() <= 1e-8)
            }
            Bifurcation::Grazing => {
                let gaps = self.least.iter().chain(&self.touches.nearest);
                moving && gaps.map(|found| found.gap / self.scale).any(|gap| gap.abs() <= 1e-9)
            }
            Bifurcation::Fade => speeds.iter().any(|speed| speed.abs() <= 1e-9),
            // Known by what lies on both sides.
            _ => false,
        }
    }
}

/// A machine at both of two values.
type AtBoth<'a> = dyn Fn([f64; 2]) -> Result<Machine<f64>> + 'a;

/// Orbits of machines over two parameters.
pub struct Plane<'a> {
    at: &'a AtBoth<'a>,
    size: usize,
    common: Common,
}

impl<'a> Plane<'a> {
    /// The orbits of the machines that `at` gives at two values, their work added up in `tally`; the others
    /// as in [`Patterns::new`].
    ///
    /// # Errors
    /// Where the machine is not defined there.
    pub fn new(
        at: &'a AtBoth<'a>,
        place: [f64; 2],
        depth: Option<f64>,
        tally: Option<&Arc<EffectTally>>,
    ) -> Result<Plane<'a>> {
        let machine = at(place)?;
        Ok(Plane { at, size: machine.size, common: Common::new(&machine, depth, tally)? })
    }
}

impl PatternPlane for Plane<'_> {
    type Orbit = Orbit;

    fn count(&self, pattern: &Itinerary) -> usize {
        Common::count(self.size, pattern)
    }

    fn is_time(&self, _: &Itinerary, unknown: usize) -> bool {
        is_time(self.size, unknown)
    }

    fn unit(&self, _: &Itinerary, unknown: usize) -> f64 {
        self.common.unit(self.size, unknown)
    }

    fn values(
        &self,
        event: Option<Bifurcation>,
        parameters: [f64; 2],
        pattern: &Itinerary,
        z: &[f64],
    ) -> Result<Vec<f64>> {
        let machine = (self.at)(parameters)?;
        let solved = Solved::new(&machine, pattern, self.common.depth, self.common.tally.as_ref())?;
        let equations = solved.equations(pattern, self.common.scale);
        let mut values = equations.linearise(z, None)?.residual;
        let speeds = || z[2 * self.size..].iter().skip(1).step_by(2);
        let scale: f64 = speeds().product();
        let multipliers = || multipliers(&equations, z);
        let Some(event) = event else { return Ok(values) };
        values.push(match event {
            Bifurcation::SaddleNode => product(&multipliers()?, -1.0) * scale,
            Bifurcation::Flip => product(&multipliers()?, 1.0) * scale,
            Bifurcation::Torus => nearest_pair(&multipliers()?).map_or(f64::NAN, |pair| pair.off),
            Bifurcation::Grazing => {
                let (least, touches) = equations.extremes(z)?;
                let gaps = least.iter().chain(&touches.nearest).map(|found| found.gap);
                let nearest = gaps.min_by(|a, b| a.abs().total_cmp(&b.abs()));
                let nearest = nearest.ok_or_else(|| Error::input("no minimum of a gap to graze at"))?;
                nearest / self.common.scale
            }
            Bifurcation::Fade => *speeds().min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(&0.0),
            Bifurcation::Crossing => {
                return Err(Error::input(
                    "crossings of branches of a machine are not followed in two parameters",
                ));
            }
            _ => return Err(Error::input("what friction changes is not followed in two parameters")),
        });
        Ok(values)
    }

    fn orbit(&self, parameters: [f64; 2], pattern: &Itinerary, root: Root) -> Result<Orbit> {
        self.common.orbit(&(self.at)(parameters)?, pattern, root)
    }

    /// Resonant grazings are those of one degree of freedom.
    fn degeneracies(
        &self,
        event: Bifurcation,
        parameters: [f64; 2],
        tangent: &[f64],
        orbit: &Orbit,
        _: &[f64],
    ) -> Vec<Option<f64>> {
        let mut all = vec![None; Degeneracy::ALL.len()];
        let multipliers = &orbit.multipliers;
        let coefficient = |of: &dyn Fn(&Local) -> Option<f64>| {
            let machine = (self.at)(parameters).ok()?;
            let solved =
                Solved::new(&machine, &orbit.itinerary, self.common.depth, self.common.tally.as_ref())
                    .ok()?;
            let equations = solved.equations(&orbit.itinerary, orbit.scale);
            of(&Local::new(equations, &orbit.z).ok()?)
        };
        let mut set =
            |what: Degeneracy, value: f64| all[what as usize] = Some(value).filter(|x| x.is_finite());
        match event {
            Bifurcation::SaddleNode => {
                let a = coefficient(&|local| local.fold_along(tangent));
                set(Degeneracy::Cusp, a.unwrap_or(f64::NAN));
                set(Degeneracy::Resonance1, product_of_others(multipliers, -1.0));
                set(Degeneracy::FoldFlip, product(multipliers, 1.0));
                set(Degeneracy::FoldTorus, pairs_product(&without(multipliers, &[(1.0, 0.0)])));
            }
            Bifurcation::Flip => {
                let b = coefficient(&|local| local.cubic(-1.0));
                set(Degeneracy::GeneralisedFlip, b.unwrap_or(f64::NAN));
                set(Degeneracy::Resonance2, product_of_others(multipliers, 1.0));
                set(Degeneracy::FoldFlip, product(multipliers, -1.0));
                set(Degeneracy::FlipTorus, pairs_product(&without(multipliers, &[(-1.0, 0.0)])));
            }
            Bifurcation::Torus => {
                if let Some(pair) = nearest_pair(multipliers) {
                    let d = coefficient(&|local| local.torus(multipliers));
                    set(Degeneracy::Chenciner, d.unwrap_or(f64::NAN));
                    set(Degeneracy::Resonance1, pair.sum - 2.0);
                    set(Degeneracy::Resonance2, pair.sum + 2.0);
                    set(Degeneracy::Resonance3, pair.sum + 1.0);
                    set(Degeneracy::Resonance4, pair.sum);
                    let others = without(multipliers, &pair.both());
                    set(Degeneracy::FoldTorus, product(&others, -1.0));
                    set(Degeneracy::FlipTorus, product(&others, 1.0));
                    set(Degeneracy::DoubleTorus, pairs_product(&others));
                }
            }
            // Along the curve e dp + e′ dp′ = 0, with e′ that of the second parameter.
            Bifurcation::Grazing => {
                set(Degeneracy::NoDrift, tangent.last().copied().unwrap_or(f64::NAN));
            }
            _ => {}
        }
        all
    }

    /// Two real multipliers whose product is 1 are those of a saddle that keeps areas.
    fn is_genuine(&self, event: Bifurcation, degeneracy: Degeneracy, orbit: &Orbit) -> bool {
        let critical = match (event, degeneracy) {
            (Bifurcation::SaddleNode, Degeneracy::FoldTorus) => vec![(1.0, 0.0)],
            (Bifurcation::Flip, Degeneracy::FlipTorus) => vec![(-1.0, 0.0)],
            (Bifurcation::Torus, Degeneracy::FoldTorus | Degeneracy::FlipTorus) => {
                return nearest_pair(&orbit.multipliers).is_some_and(|pair| pair.complex);
            }
            (Bifurcation::Torus, Degeneracy::DoubleTorus) => {
                let Some(pair) = nearest_pair(&orbit.multipliers).filter(|pair| pair.complex) else {
                    return false;
                };
                pair.both().to_vec()
            }
            _ => return true,
        };
        nearest_pair(&without(&orbit.multipliers, &critical)).is_some_and(|pair| pair.complex)
    }
}
