//! Oscillators of one degree of freedom as continuation sees them: their orbits, and the functions of their
//! bifurcations in two parameters.

use std::f64::consts::{PI, TAU};

use crate::{
    continuation::{
        Bifurcation, Degeneracy, Derivatives, FollowedOrbit, Linearised, Multipliers, PatternFamily,
        PatternPlane, Root, STILL,
    },
    error::{Error, Result},
    motion::Side,
    one::{
        grazing::{is_mirrored, local_map_of},
        orbit::{
            Family, Itinerary, Orbit, Oscillator, Strike, Unknowns, check, describe, linearise, monodromy,
            return_map,
        },
    },
};

/// Oscillators that differ in two parameters.
pub trait TwoParameterFamily: Sync {
    /// The oscillator at both values.
    ///
    /// # Errors
    /// An input error where the system is not defined.
    fn at(&self, parameters: [f64; 2]) -> Result<Oscillator>;
}

impl<F: Fn([f64; 2]) -> Result<Oscillator> + Sync> TwoParameterFamily for F {
    fn at(&self, parameters: [f64; 2]) -> Result<Oscillator> {
        self(parameters)
    }
}

/// What lengths and speeds are measured by along curves of orbits, by the walls that a pattern strikes.
#[derive(Debug, Clone, Copy)]
struct Units([f64; 4]);

impl Units {
    fn of(oscillator: &Oscillator) -> Result<Units> {
        let both = [Side::Lower, Side::Upper].map(|place| Strike { place, periods: 1 });
        let unit = |struck: &[Strike]| {
            let itinerary = match struck {
                [] => Itinerary::free(1),
                struck => Itinerary::new(struck.to_vec()),
            };
            Ok::<_, Error>(oscillator.unit(&itinerary?))
        };
        Ok(Units([unit(&[])?, unit(&both[..1])?, unit(&both[1..])?, unit(&both)?]))
    }

    fn length(&self, pattern: &Itinerary) -> f64 {
        let strikes = |side: Side| usize::from(pattern.strikes().iter().any(|strike| strike.place == side));
        self.0[strikes(Side::Lower) + 2 * strikes(Side::Upper)]
    }

    fn own(&self, pattern: &Itinerary, unknown: usize) -> f64 {
        Unknowns::unit(pattern, unknown, self.length(pattern))
    }

    /// The unknowns in the scene's unit.
    fn natural(&self, pattern: &Itinerary, u: &[f64]) -> Vec<f64> {
        u.iter().enumerate().map(|(i, u)| u * self.own(pattern, i)).collect()
    }

    fn orbit(&self, oscillator: &Oscillator, pattern: &Itinerary, root: Root) -> Result<Orbit> {
        let unit = self.length(pattern);
        let root = Root { z: self.natural(pattern, &root.z), residual: root.residual * unit, ..root };
        Ok(Orbit { unit, ..describe(oscillator, pattern, root)? })
    }
}

/// Orbits of oscillators over one parameter.
pub struct Patterns<'a> {
    family: &'a (dyn Family + 'a),
    units: Units,
}

impl<'a> Patterns<'a> {
    /// The orbits of a family. Lengths and speeds are measured by the size of the motion at one value of the
    /// parameter (`Oscillator::unit`).
    ///
    /// # Errors
    /// Where the system is not defined there.
    pub fn new(family: &'a (dyn Family + 'a), at: f64) -> Result<Patterns<'a>> {
        Ok(Patterns { family, units: Units::of(&family.at(at)?)? })
    }

    /// The oscillators.
    pub fn family(&self) -> &'a (dyn Family + 'a) {
        self.family
    }
}

/// Orbits of oscillators over two parameters.
pub struct Plane<'a> {
    plane: &'a (dyn TwoParameterFamily + 'a),
    units: Units,
}

impl<'a> Plane<'a> {
    /// The orbits of oscillators that differ in two parameters, measured as in [`Patterns::new`].
    ///
    /// # Errors
    /// Where the system is not defined at these values.
    pub fn new(plane: &'a (dyn TwoParameterFamily + 'a), at: [f64; 2]) -> Result<Plane<'a>> {
        Ok(Plane { plane, units: Units::of(&plane.at(at)?)? })
    }
}

impl FollowedOrbit for Orbit {
    type Place = Side;

    fn pattern(&self) -> &Itinerary {
        &self.itinerary
    }

    fn unknowns(&self) -> Vec<f64> {
        self.z.iter().enumerate().map(|(i, z)| z / FollowedOrbit::unit(self, i)).collect()
    }

    fn moved(&self, unknowns: &[f64]) -> Orbit {
        let natural = unknowns.iter().enumerate().map(|(i, u)| u * FollowedOrbit::unit(self, i));
        self.with(&natural.collect::<Vec<_>>())
    }

    fn is_time(&self, unknown: usize) -> bool {
        Unknowns::is_time(&self.itinerary, unknown)
    }

    fn unit(&self, unknown: usize) -> f64 {
        Unknowns::unit(&self.itinerary, unknown, self.unit)
    }

    fn length_unit(&self) -> f64 {
        self.unit
    }

    fn speeds(&self) -> Vec<f64> {
        self.impacts().map(|impact| impact.speed / self.unit).collect()
    }

    fn least_gap(&self) -> Option<f64> {
        self.least.map(|least| least.gap / self.unit)
    }

    fn is_orbit(&self) -> bool {
        self.admissibility.is_admissible()
    }

    fn residual(&self) -> f64 {
        self.residual
    }

    fn newton_steps(&self) -> usize {
        self.steps
    }

    fn multipliers(&self) -> Vec<(f64, f64)> {
        self.multipliers.values().to_vec()
    }

    fn is_stable(&self) -> bool {
        self.multipliers.is_stable()
    }

    fn fold(&self) -> f64 {
        self.multipliers.fold()
    }

    fn flip(&self) -> f64 {
        self.multipliers.flip()
    }

    fn rotates(&self) -> bool {
        let Multipliers { trace, determinant } = self.multipliers;
        trace.abs() <= (1.0 + determinant) * (1.0 + 1e-9)
    }

    fn is_at(&self, bifurcation: Bifurcation) -> bool {
        let multipliers = &self.multipliers;
        let speeds = FollowedOrbit::speeds(self);
        let moving = speeds.iter().all(|speed| speed.abs() > STILL);
        let near = |test: f64, tolerance: f64| test.abs() <= tolerance * (1.0 + multipliers.determinant);
        match bifurcation {
            // A multiplier moves like the square root of the parameter there: half the digits.
            Bifurcation::SaddleNode | Bifurcation::Crossing => moving && near(multipliers.fold(), 1e-4),
            Bifurcation::Flip => moving && near(multipliers.flip(), 1e-6),
            Bifurcation::Torus => {
                moving
                    && near(multipliers.determinant - 1.0, 1e-9)
                    && multipliers.trace.abs() < 1.0 + multipliers.determinant
            }
            Bifurcation::Grazing => {
                moving && FollowedOrbit::least_gap(self).is_some_and(|gap| gap.abs() <= 1e-9)
            }
            Bifurcation::Fade => speeds.iter().any(|speed| speed.abs() <= 1e-9),
            _ => false,
        }
    }
}

impl PatternFamily for Patterns<'_> {
    type Orbit = Orbit;

    fn count(&self, pattern: &Itinerary) -> usize {
        Unknowns::count(pattern)
    }

    fn equations(&self, parameter: f64, pattern: &Itinerary, z: &[f64]) -> Result<Linearised> {
        let (unit, z) = (self.units.length(pattern), self.units.natural(pattern, z));
        let found = linearise(&self.family.at(parameter)?, pattern, &z)?;
        Ok(found.measured(unit, |i| self.units.own(pattern, i)))
    }

    fn orbit(&self, parameter: f64, pattern: &Itinerary, root: Root) -> Result<Orbit> {
        self.units.orbit(&self.family.at(parameter)?, pattern, root)
    }

    fn twice(&self, pattern: &Itinerary, z: &[f64]) -> Vec<f64> {
        z.repeat(if pattern.strikes().is_empty() { 1 } else { 2 })
    }

    fn once(&self, pattern: &Itinerary, z: &[f64]) -> Option<(Itinerary, Vec<f64>)> {
        let half = pattern.once(|first| z[2 * first] - z[0])?;
        let kept = if pattern.strikes().is_empty() { z.len() } else { z.len() / 2 };
        Some((half, z[..kept].to_vec()))
    }

    fn is_time(&self, pattern: &Itinerary, unknown: usize) -> bool {
        Unknowns::is_time(pattern, unknown)
    }

    fn unit(&self, pattern: &Itinerary, unknown: usize) -> f64 {
        self.units.own(pattern, unknown)
    }
}

impl PatternPlane for Plane<'_> {
    type Orbit = Orbit;

    fn count(&self, pattern: &Itinerary) -> usize {
        Unknowns::count(pattern)
    }

    fn is_time(&self, pattern: &Itinerary, unknown: usize) -> bool {
        Unknowns::is_time(pattern, unknown)
    }

    fn unit(&self, pattern: &Itinerary, unknown: usize) -> f64 {
        self.units.own(pattern, unknown)
    }

    fn values(
        &self,
        event: Option<Bifurcation>,
        parameters: [f64; 2],
        pattern: &Itinerary,
        z: &[f64],
    ) -> Result<Vec<f64>> {
        let (oscillator, unit, u) = (self.plane.at(parameters)?, self.units.length(pattern), z);
        let z = &self.units.natural(pattern, u)[..];
        let mut values = linearise(&oscillator, pattern, z)?.residual;
        values.iter_mut().for_each(|x| *x /= unit);
        if event == Some(Bifurcation::Crossing) {
            symmetric(&oscillator, pattern, u, &mut values)?;
        }
        let unknowns = Unknowns::new(pattern, u)?;
        let speeds = || unknowns.speeds();
        let scale: f64 = speeds().product();
        let multipliers = || {
            let matrix = monodromy(&oscillator, pattern, z)?;
            Multipliers::new(&matrix, &oscillator, pattern, z)
        };
        let Some(event) = event else { return Ok(values) };
        values.push(match event {
            Bifurcation::SaddleNode | Bifurcation::Crossing => multipliers()?.fold() * scale,
            Bifurcation::Flip => multipliers()?.flip() * scale,
            Bifurcation::Torus => multipliers()?.determinant - 1.0,
            Bifurcation::Grazing => {
                let least = check(&oscillator, pattern, z).least;
                least.ok_or_else(|| Error::input("no minimum of a gap to graze at"))?.gap / unit
            }
            Bifurcation::Fade => speeds().min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0),
            _ => return Err(Error::input("oscillators have no dry friction")),
        });
        Ok(values)
    }

    fn orbit(&self, parameters: [f64; 2], pattern: &Itinerary, root: Root) -> Result<Orbit> {
        self.units.orbit(&self.plane.at(parameters)?, pattern, root)
    }

    fn degeneracies(
        &self,
        event: Bifurcation,
        parameters: [f64; 2],
        tangent: &[f64],
        orbit: &Orbit,
        factors: &[f64],
    ) -> Vec<Option<f64>> {
        let mut all = vec![None; Degeneracy::ALL.len()];
        let (trace, det) = (orbit.multipliers.trace, orbit.multipliers.determinant);
        let oscillator = || self.plane.at(parameters).ok();
        let expansion = || {
            let map = return_map(&oscillator()?, &orbit.itinerary, &orbit.z).ok()?;
            Some(Derivatives::of(&map).scaled(factors))
        };
        let mut set = |what: Degeneracy, value: Option<f64>| {
            all[what as usize] = value.filter(|value| value.is_finite());
        };
        match event {
            Bifurcation::SaddleNode => {
                set(Degeneracy::Cusp, expansion().and_then(|map| map.fold_along()));
                set(Degeneracy::Resonance1, Some(det - 1.0));
            }
            Bifurcation::Flip => {
                set(Degeneracy::GeneralisedFlip, expansion().and_then(|map| map.flip()));
                set(Degeneracy::Resonance2, Some(det - 1.0));
            }
            Bifurcation::Torus => {
                let varies = |it: &Oscillator| it.flow().equation().constant_divergence().is_none();
                if oscillator().is_some_and(|oscillator| varies(&oscillator)) {
                    set(Degeneracy::Chenciner, expansion().and_then(|map| map.torus()));
                }
                set(Degeneracy::Resonance1, Some(trace - 2.0));
                set(Degeneracy::Resonance2, Some(trace + 2.0));
                set(Degeneracy::Resonance3, Some(trace + 1.0));
                set(Degeneracy::Resonance4, Some(trace));
            }
            Bifurcation::Grazing => {
                // Along the curve e dp + e′ dp′ = 0, with e′ that of the second parameter.
                set(Degeneracy::NoDrift, tangent.last().copied());
                let gamma = oscillator().and_then(|oscillator| local_map_of(&oscillator, orbit).ok());
                set(Degeneracy::NoGamma, gamma.and_then(|map| map.gamma()));
                // u_n without the factors that it shares with u_d, d a divisor of n.
                let square = trace * trace;
                set(Degeneracy::Resonant2, Some(trace));
                set(Degeneracy::Resonant3, Some(square - det));
                set(Degeneracy::Resonant4, Some(square - 2.0 * det));
                set(Degeneracy::Resonant5, Some(square * square - 3.0 * square * det + det * det));
                set(Degeneracy::Resonant6, Some(square - 3.0 * det));
            }
            // One multiplier is 1 all along, the other is their product.
            Bifurcation::Crossing => {
                set(Degeneracy::Resonance1, Some(det - 1.0));
                set(Degeneracy::DegeneratePitchfork, expansion().and_then(|map| map.pitchfork()));
            }
            _ => {}
        }
        all
    }

    /// Two zeros of one u_n are not to lie within a step: for n ≤ 6 they are at least π/5 apart in θ, trace =
    /// 2 √det cos θ.
    fn leaps(&self, event: Bifurcation, before: &Orbit, after: &Orbit) -> bool {
        let angle = |orbit: &Orbit| {
            let Multipliers { trace, determinant } = orbit.multipliers;
            (trace / (2.0 * determinant.sqrt())).clamp(-1.0, 1.0).acos()
        };
        event == Bifurcation::Grazing && (angle(before) - angle(after)).abs() > PI / 6.0
    }
}

/// Where branches cross the pattern equations are singular, and in two parameters they cross along a curve
/// only where a symmetry is lost: at pitchforks of symmetric orbits. Among those the equations are regular:
/// the second half of the pattern, in place of its own equations, is the mirror of the first, half a period
/// later.
fn symmetric(oscillator: &Oscillator, pattern: &Itinerary, z: &[f64], values: &mut [f64]) -> Result<()> {
    let strikes = pattern.strikes();
    let half = strikes.len() / 2;
    let (first, second) = strikes.split_at(half);
    let opposite = first.iter().zip(second).all(|(a, b)| a.place != b.place);
    let lag = PI * f64::from(pattern.periods());
    let off = |i: usize| {
        let [late, faster] = [0, 1].map(|j| z[2 * (i + half) + j] - z[2 * i + j]);
        [(late - lag + PI).rem_euclid(TAU) - PI, faster]
    };
    let symmetric = (0..half).all(|i| off(i).iter().all(|x| x.abs() < 1e-3));
    if half == 0 || first.len() != second.len() || !opposite || !symmetric || !is_mirrored(oscillator) {
        return Err(Error::input(
            "crossings are followed in two parameters only as pitchforks of orbits that are their own mirror image half a period \
             later, with impacts; this one is not",
        ));
    }
    (0..half).for_each(|i| values[2 * (i + half)..][..2].copy_from_slice(&off(i)));
    Ok(())
}
