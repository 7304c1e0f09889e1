//! A machine as a certificate lists it.

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::Bounds;
use crate::{
    certificate::machine::{self as listed, Harmonic, Load, Range},
    error::{Error, Result},
    many::{Machine, Stop},
    motion,
    number::{Ball, Elementary, Precision, Real},
    orbit::range_of,
};

/// The most coordinates and stops that a certificate holds.
const COORDINATES: usize = 8;
const STOPS: usize = 16;
/// Bits of balls.
const BITS: u32 = 256;

/// Numbers known to lie between bounds, added and multiplied in balls where they are not known exactly.
struct Numbers {
    precision: Precision,
}

impl Numbers {
    fn ball(&self, [lo, hi]: &Bounds) -> Ball {
        if lo == hi { Ball::ratio(lo, &self.precision) } else { Ball::between(lo, hi, &self.precision) }
    }

    fn bounds(&self, x: &Ball) -> Result<Bounds> {
        let (lo, hi) = x.exact_bounds().ok_or_else(|| Error::input("a coefficient is not bounded"))?;
        Ok([lo, hi])
    }

    /// The damping of one coordinate that has a ratio, c = 2 ζ √(km).
    ///
    /// # Errors
    /// Ratios of several coordinates.
    fn by_ratio(
        &self,
        machine: &Machine<Bounds>,
        stiffness: &[Vec<Bounds>],
        mass: &[Vec<Bounds>],
    ) -> Result<Option<Bounds>> {
        match &machine.damping_ratio[..] {
            [] => Ok(None),
            [ratio] if machine.size == 1 => {
                let root = (self.ball(&stiffness[0][0]) * &self.ball(&mass[0][0])).sqrt();
                let two = Ball::integer(2, &self.precision);
                self.bounds(&(self.ball(ratio) * &two * &root)).map(Some)
            }
            _ => Err(Error::input(
                "`damping_ratio` of several coordinates is not enclosed: give `damping`, or `modes` with `ratios`",
            )),
        }
    }

    /// Σ a b.
    fn dot(&self, pairs: &[(&Bounds, &Bounds)]) -> Result<Bounds> {
        if pairs.iter().all(|(a, b)| a[0] == a[1] && b[0] == b[1]) {
            let sum: BigRational = pairs.iter().map(|(a, b)| &a[0] * &b[0]).sum();
            return Ok([sum.clone(), sum]);
        }
        let zero = Ball::integer(0, &self.precision);
        self.bounds(&pairs.iter().fold(zero, |sum, (a, b)| sum + &(self.ball(a) * &self.ball(b))))
    }
}

fn check_symmetric(mass: &[Vec<Bounds>]) -> Result<()> {
    for (i, row) in mass.iter().enumerate() {
        if let Some(j) = (0..i).find(|&j| row[j] != mass[j][i]) {
            return Err(Error::input(format!(
                "the mass matrix is not exactly symmetric in row {}, column {}, and its proofs hold of symmetric ones",
                i + 1,
                j + 1
            )));
        }
    }
    Ok(())
}

/// The power of ten by which coefficients too large or too small for a certificate are divided, 0 if none is,
/// and that number.
fn common_unit<'b>(all: impl Iterator<Item = &'b Bounds>) -> Result<(i32, BigRational)> {
    let greatest = all.map(|x| x[0].abs().max(x[1].abs())).max().and_then(|x| x.to_f64()).unwrap_or(1.0);
    let unit = if (1e-3..1e8).contains(&greatest) { 0 } else { greatest.log10().floor() as i32 - 3 };
    if unit.abs() > 99 {
        return Err(Error::input("a coefficient is beyond the range of a certificate"));
    }
    let ten = num_traits::pow(BigRational::from_integer(10.into()), unit.unsigned_abs() as usize);
    Ok((unit, if unit < 0 { ten.recip() } else { ten }))
}

/// The machine as a certificate lists it: in the scene's units, or M, C, K and forces in units of a power of
/// ten where they are too large or small.
///
/// # Errors
/// An input error for dry friction, more than 8 coordinates or 16 stops, damping ratios beside a mass matrix
/// of several coordinates, M that is not symmetric, and numbers beyond the range of a certificate.
pub fn listed(machine: &Machine<Bounds>) -> Result<listed::Machine> {
    machine.check_no_friction()?;
    let (n, numbers) = (machine.size, Numbers { precision: Precision::new(BITS) });
    if n > COORDINATES || machine.stops.len() > STOPS {
        return Err(Error::input(format!(
            "the machine has {n} coordinates and {} stops; proofs hold up to {COORDINATES} and {STOPS}",
            machine.stops.len()
        )));
    }
    let zero = || [BigRational::zero(), BigRational::zero()];
    let matrix = |entries: &[(usize, usize, Bounds)]| -> Vec<Vec<Bounds>> {
        let mut rows = vec![vec![zero(); n]; n];
        for (i, j, x) in entries {
            let entry = &mut rows[*i][*j];
            *entry = [&entry[0] + &x[0], &entry[1] + &x[1]];
        }
        rows
    };
    let (mass, stiffness) = (matrix(&machine.mass), matrix(&machine.stiffness));
    let mut damping = matrix(&machine.damping);
    check_symmetric(&mass)?;
    if let Some(alone) = numbers.by_ratio(machine, &stiffness, &mass)? {
        damping[0][0] = alone;
    }
    // Forces and rows of stops are given for the points q = Φη.
    let seen = |list: &[Bounds]| -> Result<Vec<Bounds>> {
        if list.is_empty() {
            return Ok(vec![zero(); n]);
        }
        if machine.shapes.is_empty() {
            return Ok(list.to_vec());
        }
        let column = |j: usize| -> Vec<(&Bounds, &Bounds)> {
            list.iter().zip(&machine.shapes).map(|(x, row)| (x, &row[j])).collect()
        };
        (0..n).map(|j| numbers.dot(&column(j))).collect()
    };
    let force = seen(&machine.force)?;
    let mut forcing = Vec::new();
    for load in &machine.forcing {
        forcing.push((load.k, seen(&load.cos)?, seen(&load.sin)?));
    }
    // All of these may be divided by one number.
    let forces = forcing.iter().flat_map(|(_, cos, sin)| cos.iter().chain(sin)).chain(&force);
    let all = [&mass, &damping, &stiffness].into_iter().flatten().flatten().chain(forces);
    let (unit, ten) = common_unit(all)?;
    let scaled = |x: &Bounds| range_of(&(&x[0] / &ten), &(&x[1] / &ten));
    let list = |list: &[Bounds]| list.iter().map(scaled).collect::<Result<Vec<Range>>>();
    let rows = |rows: &[Vec<Bounds>]| rows.iter().map(|row| list(row)).collect::<Result<Vec<_>>>();
    let plain = |x: &Bounds| range_of(&x[0], &x[1]);
    let stop = |stop: &Stop<Bounds>| -> Result<listed::Stop> {
        let motion::Wall { offset, harmonics, restitution } = &stop.wall;
        let harmonic = |h: &motion::Harmonic<Bounds>| -> Result<Harmonic<Range>> {
            Ok(Harmonic { k: h.k.into(), cos: plain(&h.cos)?, sin: plain(&h.sin)? })
        };
        Ok(listed::Stop {
            row: seen(&stop.row)?.iter().map(plain).collect::<Result<_>>()?,
            offset: plain(offset)?,
            restitution: plain(restitution)?,
            harmonics: harmonics.iter().map(harmonic).collect::<Result<_>>()?,
        })
    };
    Ok(listed::Machine {
        period: plain(&machine.period)?,
        unit,
        mass: (0..n).map(|i| list(&mass[i][..=i])).collect::<Result<_>>()?,
        damping: rows(&damping)?,
        stiffness: rows(&stiffness)?,
        force: list(&force)?,
        forcing: forcing
            .iter()
            .map(|(k, cos, sin)| Ok(Load { k: (*k).into(), cos: list(cos)?, sin: list(sin)? }))
            .collect::<Result<_>>()?,
        stops: machine.stops.iter().map(stop).collect::<Result<_>>()?,
    })
}
