//! An event followed in two parameters: the pattern equations with one more, that the event's function is zero.

use super::{
    OrbitCurve,
    curve::{Curve, Equations, Foot},
    follow::Followed,
    orbits::{Event, monitors},
};
use crate::{
    error::{Error, Result},
    oscillator::orbit::{
        Itinerary, Multipliers, Orbit, Oscillator, Root, check, describe, linearise, monodromy,
    },
};

/// Oscillators that differ in two parameters.
pub trait Plane: Sync {
    /// The oscillator at both values.
    ///
    /// # Errors
    /// An input error where the system is not defined.
    fn at(&self, parameters: [f64; 2]) -> Result<Oscillator>;
}

impl<F: Fn([f64; 2]) -> Result<Oscillator> + Sync> Plane for F {
    fn at(&self, parameters: [f64; 2]) -> Result<Oscillator> {
        self(parameters)
    }
}

/// The orbits of a pattern at which one event happens: the unknowns are those of the pattern and both parameters as
/// fractions of their ranges.
pub struct Events<'a> {
    /// The oscillators.
    pub plane: &'a dyn Plane,
    /// The pattern.
    pub itinerary: Itinerary,
    /// What happens.
    pub event: Event,
    /// The bounds of both parameters.
    pub ranges: [(f64, f64); 2],
}

impl Events<'_> {
    fn split<'u>(&self, u: &'u [f64]) -> (&'u [f64], [f64; 2]) {
        let (z, last) = u.split_at(u.len() - 2);
        (z, [0, 1].map(|i| self.ranges[i].0 + last[i] * (self.ranges[i].1 - self.ranges[i].0)))
    }

    /// The point near an orbit at both parameter values, on the way to larger values of the second.
    ///
    /// # Errors
    /// An input error if Newton's method does not end, or outside the ranges.
    pub fn start(&self, z: &[f64], parameters: [f64; 2], options: &super::Options) -> Result<Foot> {
        let fraction = |i: usize| {
            let (low, high) = self.ranges[i];
            let at = (parameters[i] - low) / (high - low);
            if (0.0..=1.0).contains(&at) {
                Ok(at)
            } else {
                Err(Error::input(format!(
                    "the start, {}, is not in the range from {low} to {high}",
                    parameters[i]
                )))
            }
        };
        let u: Vec<f64> = z.iter().copied().chain([fraction(0)?, fraction(1)?]).collect();
        options.corrector().start(self, &u, u.len() - 1)
    }

    /// F and the event's function.
    fn values(&self, u: &[f64]) -> Result<Vec<f64>> {
        let (z, parameters) = self.split(u);
        let oscillator = self.plane.at(parameters)?;
        let mut values = linearise(&oscillator, &self.itinerary, z)?.residual;
        let speeds = || z.chunks(2).take(self.itinerary.strikes().len()).map(|impact| impact[1]);
        let scale: f64 = speeds().product();
        let multipliers = || {
            let matrix = monodromy(&oscillator, &self.itinerary, z)?;
            Ok::<_, Error>(Multipliers::new(&matrix, &oscillator, &self.itinerary))
        };
        values.push(match self.event {
            Event::SaddleNode | Event::Crossing => multipliers()?.fold() * scale,
            Event::Flip => multipliers()?.flip() * scale,
            Event::Torus => multipliers()?.determinant - 1.0,
            Event::Grazing => {
                let least = check(&oscillator, &self.itinerary, z).least;
                least.ok_or_else(|| Error::input("no minimum of a gap to graze at"))?.gap
            }
            Event::Fade => speeds().min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0),
        });
        Ok(values)
    }
}

impl Curve for Events<'_> {
    /// Derivatives by central differences: the zeros are as exact as the functions, only the approach is slower.
    fn equations(&self, u: &[f64]) -> Result<Equations> {
        let residual = self.values(u)?;
        let mut jacobian = vec![vec![0.0; u.len()]; residual.len()];
        for column in 0..u.len() {
            let shifted = |by: f64| {
                let mut u = u.to_vec();
                u[column] += by;
                self.values(&u)
            };
            let (ahead, behind) = (shifted(DIFFERENCE)?, shifted(-DIFFERENCE)?);
            for (row, (a, b)) in jacobian.iter_mut().zip(ahead.iter().zip(&behind)) {
                row[column] = (a - b) / (2.0 * DIFFERENCE);
            }
        }
        Ok(Equations { residual, jacobian })
    }
}

/// The cube root of the rounding error, where central differences are best.
const DIFFERENCE: f64 = 6e-6;

impl Followed for Events<'_> {
    type View = Orbit;

    fn view(&self, foot: &Foot) -> Result<Orbit> {
        let (z, parameters) = self.split(&foot.u);
        let root = Root { z: z.to_vec(), residual: foot.residual, steps: foot.steps as usize };
        describe(&self.plane.at(parameters)?, &self.itinerary, root)
    }

    /// The other events: points where two things happen at once.
    fn monitors(&self, _: &Foot, orbit: &Orbit) -> Vec<Option<f64>> {
        let mut all = monitors(orbit, None);
        match self.event {
            Event::Fade => all.truncate(Event::Fade as usize),
            event => all[event as usize] = None,
        }
        if self.event == Event::Crossing {
            all[Event::SaddleNode as usize] = None;
        }
        all
    }

    /// At an event that ends a branch the orbit is just no orbit any more: here that does not count.
    fn holds(&self, orbit: &Orbit) -> bool {
        match self.event {
            Event::Fade => {
                orbit.z.chunks(2).take(self.itinerary.strikes().len()).all(|impact| impact[1] > -1e-9)
            }
            Event::Grazing => orbit.impacts().all(|impact| impact.speed > 0.0),
            _ => orbit.admissibility.is_admissible(),
        }
    }

    fn bounds(&self) -> Vec<(usize, f64, f64)> {
        let first = (2 * self.itinerary.strikes().len()).max(2);
        vec![(first, 0.0, 1.0), (first + 1, 0.0, 1.0)]
    }
}

impl OrbitCurve for Events<'_> {
    fn itinerary(&self) -> &Itinerary {
        &self.itinerary
    }

    fn parameters(&self, u: &[f64]) -> Vec<f64> {
        self.split(u).1.to_vec()
    }
}
