//! The keys of the oscillator: its equation of motion, its walls, the accuracy of its motions.

use super::{
    expression::Expression,
    force::ForceKey,
    keys::{Entry, Value, keys},
    restitution::RestitutionKey,
};
use crate::{
    error::Result,
    motion::{Harmonic, Side, System, Wall},
};

/// The highest multiple of the base frequency.
const LIMIT_K: u32 = 1000;

keys! {
    /// q″ = −`damping` q′ − `stiffness` q − `cubic` q³ + `force` + `forcing`(t), time in units in which the
    /// forcing's period is 2π.
    pub struct SystemKeys {
        /// the coefficient of the velocity
        damping: Expression = "0",
        /// the coefficient of the displacement
        stiffness: Expression = "0",
        /// the coefficient of the displacement cubed (Duffing)
        cubic: Expression = "0",
        /// an acceleration: a constant one, such as preload or gravity, or any smooth function of the
        /// displacement q, the velocity u and the time t, periodic in t with the forcing
        force: ForceKey = "0",
        /// the harmonics of the forcing
        forcing: Vec<HarmonicKeys> = "[]",
    }
}

keys! {
    /// A term `cos` cos kt + `sin` sin kt.
    pub struct HarmonicKeys {
        /// the multiple of the base frequency, 1 to 1000
        k: u32 = "1",
        /// the coefficient of cos kt
        cos: Expression = "0",
        /// the coefficient of sin kt
        sin: Expression = "0",
    }
}

keys! {
    /// A wall at `offset` + Σ `harmonics`; an impact turns the velocity relative to it into −`restitution`
    /// times itself.
    pub struct WallKeys {
        /// on which side of the oscillator
        side: Side,
        /// the mean position
        offset: Expression,
        /// its motion; none for a wall that stands still
        harmonics: Vec<HarmonicKeys> = "[]",
        /// at least 0: 0 for a wall that stops the motion, 1 for one that keeps the energy
        restitution: RestitutionKey,
    }
}

keys! {
    /// How accurately motions are computed.
    pub struct Accuracy {
        /// the integrator's tolerance, relative to the motion, for oscillators that are not linear; others
        /// need none
        tolerance: f64 = "1e-12",
        /// a minimum of the distance to a wall that is deeper than this is an impact; a shallower one is a
        /// tangency. In the scene's unit of length; without it 10⁻¹² of the size of the gap to the nearest
        /// wall
        minimum_depth: Option<f64>,
    }
}

impl Default for Accuracy {
    fn default() -> Self {
        Accuracy { tolerance: 1e-12, minimum_depth: None }
    }
}

impl Value for Side {
    fn shape() -> String {
        "`\"lower\"` or `\"upper\"`".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        entry.word(&[Side::Lower, Side::Upper].map(|side| (side.name(), side)))
    }
}

/// Refuses a multiple that is out of range or stands among those before.
pub(super) fn check_k(place: &Entry, k: u32, mut before: impl Iterator<Item = u32>) -> Result<()> {
    if !(1..=LIMIT_K).contains(&k) {
        return Err(place.fail(&format!("k is {k}; it goes from 1 to {LIMIT_K}")));
    }
    if before.any(|other| other == k) {
        return Err(place.fail(&format!("k = {k} stands here twice; add the two terms up")));
    }
    Ok(())
}

/// Harmonics, each multiple once.
pub(super) fn harmonics(
    file: &Entry,
    list: Vec<HarmonicKeys>,
    path: &str,
) -> Result<Vec<Harmonic<Expression>>> {
    for (i, harmonic) in list.iter().enumerate() {
        let place = file.at(&format!("{path}[{}]", i + 1));
        check_k(&place, harmonic.k, list[..i].iter().map(|other| other.k))?;
    }
    Ok(list.into_iter().map(|h| Harmonic { k: h.k, cos: h.cos, sin: h.sin }).collect())
}

/// The equation of motion and the walls, once every key is read.
pub(super) fn system(file: &Entry, keys: SystemKeys, walls: Vec<WallKeys>) -> Result<System<Expression>> {
    let (mut lower, mut upper) = (None, None);
    for (i, keys) in walls.into_iter().enumerate() {
        let path = format!("walls[{}]", i + 1);
        let place = match keys.side {
            Side::Lower => &mut lower,
            Side::Upper => &mut upper,
        };
        if place.is_some() {
            return Err(file.at(&format!("{path}.side")).fail("there is a wall on this side already"));
        }
        let harmonics = harmonics(file, keys.harmonics, &format!("{path}.harmonics"))?;
        let RestitutionKey::Constant(restitution) = keys.restitution else {
            return Err(file.at(&format!("{path}.restitution")).fail(
                "depends on the speed v: walls of format 1 have one restitution; write the oscillator as a machine, \
                 format = \"grazing-scene 2\" with period = \"2*pi\" and mass = 1",
            ));
        };
        *place = Some(Wall { offset: keys.offset, harmonics, restitution });
    }
    let (force, smooth) = keys.force.parts()?;
    Ok(System {
        damping: keys.damping,
        stiffness: keys.stiffness,
        cubic: keys.cubic,
        force,
        forcing: harmonics(file, keys.forcing, "system.forcing")?,
        smooth,
        lower,
        upper,
    })
}
