//! A grazing orbit is a solution of the pattern equations with one more impact, of speed 0, and the parameter
//! unknown.

use std::f64::consts::TAU;

use super::local_map::local_map;
use crate::{
    continuation::{KnownOrbits, Linearised, LocalMap, TWICE, newton},
    error::{Error, Result},
    motion::Side,
    one::orbit::{Family, Itinerary, Minimum, Orbit, Oscillator, Strike, Unknowns, check, linearise},
};

/// A periodic orbit that grazes a wall.
#[derive(Debug, Clone)]
pub struct Grazing {
    /// The parameter there.
    pub parameter: f64,
    /// The impacts once around, the first being the grazing one, with speed 0.
    pub itinerary: Itinerary,
    /// t and V of each, as in the pattern equations.
    pub z: Vec<f64>,
    /// The largest residual.
    pub residual: f64,
    /// Whether it is an orbit: its other impacts come in, and every other minimum of a gap is positive.
    pub admissible: bool,
    /// Another minimum of a gap that is zero to rounding: the orbit grazes twice, and the map is not the
    /// whole theory.
    pub second: Option<Minimum>,
    /// The map there.
    pub map: LocalMap,
}

impl Grazing {
    /// The wall that is grazed.
    pub fn side(&self) -> Side {
        self.itinerary.strikes()[0].place
    }

    /// t_G, in [0, 2π).
    pub fn phase(&self) -> f64 {
        self.z[0].rem_euclid(TAU)
    }
}

/// The grazing bifurcation near `orbit` at `parameter`: its least minimum of a gap becomes the grazing point,
/// its time and the parameter the last two unknowns. Quadratic convergence; nothing is differenced.
///
/// # Errors
/// An input error if the orbit has no minimum of a gap, as `newton`, or if det(I − A) = 0 there.
pub fn locate(family: &dyn Family, orbit: &Orbit, parameter: f64) -> Result<Grazing> {
    let least =
        orbit.least.ok_or_else(|| Error::input("the orbit has no minimum of a gap that could graze"))?;
    let (itinerary, mut start) = with_graze(orbit, least)?;
    // The speed of the first impact is 0: in its place stands the parameter.
    start[1] = parameter;
    let equations = |y: &[f64]| {
        let mut z = y.to_vec();
        z[1] = 0.0;
        let oscillator = family.at(y[1])?;
        let Linearised { residual, mut jacobian, slope } = linearise(&oscillator, &itinerary, &z)?;
        jacobian.iter_mut().zip(&slope).for_each(|(row, slope)| row[1] = *slope);
        Ok::<_, Error>(Linearised { residual, jacobian, slope })
    };
    // The parameter's unit is what moves a place or a speed by the motion's size.
    let unit = family.at(parameter)?.unit(&itinerary);
    let moves = equations(&start)?.slope.iter().fold(0.0, |most: f64, slope| most.max(slope.abs()));
    let of_parameter = if moves > 0.0 && moves.is_finite() { unit / moves } else { 1.0 };
    let own = |i: usize| if i == 1 { of_parameter } else { Unknowns::unit(&itinerary, i, unit) };
    // It is counted from where it begins: its own place has no meaning.
    let natural = |y: &[f64]| {
        let mut z: Vec<f64> = y.iter().enumerate().map(|(i, y)| y * own(i)).collect();
        z[1] += parameter;
        z
    };
    start[1] = 0.0;
    let scaled = start.iter().enumerate().map(|(i, y)| y / own(i)).collect();
    let root = newton(scaled, &KnownOrbits::default(), |y| Ok(equations(&natural(y))?.measured(unit, own)))?;
    let mut z = natural(&root.z);
    let parameter = std::mem::replace(&mut z[1], 0.0);
    let oscillator = family.at(parameter)?;
    let map = local_map(&oscillator, &itinerary, &z)?;
    let least = check(&oscillator, &itinerary, &z).least;
    let clear = least.is_none_or(|least| least.gap > 0.0);
    let second = least.filter(|least| least.gap.abs() <= TWICE * oscillator.unit(&itinerary));
    let admissible = clear && Unknowns::new(&itinerary, &z)?.speeds().skip(1).all(|speed| speed > 0.0);
    Ok(Grazing { parameter, itinerary, z, residual: root.residual * unit, admissible, second, map })
}

/// The map at an orbit whose least minimum of a gap is zero.
///
/// # Errors
/// An input error if it has none, or det(I − A) = 0.
pub(crate) fn local_map_of(oscillator: &Oscillator, orbit: &Orbit) -> Result<LocalMap> {
    let least = orbit.least.ok_or_else(|| Error::input("the orbit has no minimum of a gap"))?;
    let (itinerary, z) = with_graze(orbit, least)?;
    local_map(oscillator, &itinerary, &z)
}

/// The orbit's impacts with a first one of speed 0 at a minimum of a gap.
fn with_graze(orbit: &Orbit, at: Minimum) -> Result<(Itinerary, Vec<f64>)> {
    let (strikes, m) = (orbit.itinerary.strikes(), orbit.itinerary.strikes().len());
    if m == 0 {
        let phase = at.after.rem_euclid(TAU);
        return Ok((Itinerary::at(at.side, &[orbit.itinerary.periods()])?, vec![phase, 0.0]));
    }
    let turned = |i: usize| (at.leg + 1 + i) % m;
    // The impact before the minimum comes last; its periods are shared out between before and after.
    let last = strikes[at.leg];
    let before = ((at.after / TAU).round() as u32).min(last.periods);
    let mut all = vec![Strike { place: at.side, periods: last.periods - before }];
    let mut z = vec![orbit.z[2 * at.leg] + at.after - TAU * f64::from(before), 0.0];
    for i in 0..m {
        all.push(strikes[turned(i)]);
        z.extend(&orbit.z[2 * turned(i)..][..2]);
    }
    all[m].periods = before;
    Ok((Itinerary::new(all)?, z))
}
