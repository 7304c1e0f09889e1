//! The motion without impacts: its gaps, their minima, and how fast those open with a parameter.

use std::{f64::consts::TAU, sync::Arc};

use super::smooth;
use crate::{
    error::Result,
    many::{
        LinearEquations, Machine, Periodic, RealVector, Slope, State,
        contact::{Contacts, StopContact},
        response::Refined,
        simulate::Stage,
    },
    motion::{EffectTally, Series, minimum_within},
};

/// A local minimum of a stop's gap along the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeastGap {
    /// The stop.
    pub stop: usize,
    /// The phase, in [0, 2π).
    pub phase: f64,
    /// The gap, in the scene's unit.
    pub gap: f64,
}

/// The motion without impacts at one value of a parameter, with its derivatives.
#[derive(Debug, Clone)]
pub struct FreeMotion {
    pub(super) equations: LinearEquations,
    contacts: Contacts,
    motion: Periodic,
    /// The gap of each stop, and its derivative in the parameter.
    pub(super) gaps: Vec<[Series; 2]>,
    /// Where forces are formulas, what carries it.
    pub(super) stage: Option<Arc<Stage>>,
}

impl FreeMotion {
    /// The motion of a machine whose coefficients change at the rates `slope`.
    ///
    /// # Errors
    /// Those of [`Machine::equations`], [`Machine::contacts`], [`Slope::new`] and
    /// `LinearEquations::refined`; where forces are formulas, no periodic motion found by Newton's method.
    pub fn new(machine: &Machine<f64>, slope: &Machine<f64>) -> Result<FreeMotion> {
        FreeMotion::near(machine, slope, None, None)
    }

    /// The same; of several motions, which there may be where forces are formulas, the one that Newton's
    /// method finds from a state at phase 0. Steps by the formulas are counted in `tally`.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn near(
        machine: &Machine<f64>,
        slope: &Machine<f64>,
        near: Option<&State>,
        tally: Option<&Arc<EffectTally>>,
    ) -> Result<FreeMotion> {
        let found = if machine.is_smooth() { Some(smooth::find(machine, slope, near, tally)?) } else { None };
        let (equations, slope) = (machine.equations()?, Slope::new(machine, slope)?);
        machine.check_no_friction()?;
        let contacts = Contacts::new(&equations, machine.contacts()?, Vec::new());
        let (motion, drift, stage) = match found {
            Some(found) => (Refined::of(found.motion), Refined::of(found.drift), Some(found.stage)),
            None => {
                let [motion, drift] = equations.refined(&slope)?;
                (motion, drift, None)
            }
        };
        let gap = |(contact, (row, place)): (&StopContact, &(RealVector, Series))| {
            let gap = Series::combination(&[(1.0, &motion.series(&contact.row)?), (-1.0, &contact.position)]);
            let parts = [(1.0, &motion.series(row)?), (1.0, &drift.series(&contact.row)?), (-1.0, place)];
            Ok([gap, Series::combination(&parts)])
        };
        let gaps = contacts.all().iter().zip(&slope.stops).map(gap).collect::<Result<_>>()?;
        Ok(FreeMotion { equations, contacts, motion: motion.motion, gaps, stage })
    }

    /// The motion's displacements over a period.
    #[doc(hidden)]
    pub fn motion(&self) -> &Periodic {
        &self.motion
    }

    /// The stops.
    pub(crate) fn contacts(&self) -> &Contacts {
        &self.contacts
    }

    /// The minima of all gaps over a period, by stop. A gap that does not change has one, at phase 0.
    pub(crate) fn minima(&self) -> Vec<LeastGap> {
        let of = |(stop, [gap, _]): (usize, &[Series; 2])| {
            minima(gap).into_iter().map(move |(phase, gap)| LeastGap { stop, phase, gap })
        };
        self.gaps.iter().enumerate().flat_map(of).collect()
    }

    /// The least of them; none without stops.
    pub fn least(&self) -> Option<LeastGap> {
        self.minima().into_iter().min_by(|a, b| a.gap.total_cmp(&b.gap))
    }

    /// How fast a minimum of a gap opens with the parameter: at a minimum the phase may be held fixed.
    pub(crate) fn rate(&self, at: &LeastGap) -> f64 {
        self.gaps[at.stop][1].at(at.phase)[0]
    }

    /// The size of the gap's motion at the stop that it comes nearest to: what is much smaller is rounding. 0
    /// without stops.
    pub(crate) fn scale(&self) -> f64 {
        self.least().map_or(0.0, |least| size(&self.gaps[least.stop][0]))
    }

    /// The size of its derivative in the parameter.
    pub(super) fn drift_scale(&self) -> f64 {
        self.least().map_or(0.0, |least| size(&self.gaps[least.stop][1]))
    }
}

/// A bound of a sum that it comes near to.
fn size(z: &Series) -> f64 {
    z.mean().abs() + z.derivative_bound(0)
}

/// The minima of a trigonometric sum over a period, phase and value.
///
/// Cells are 1/32 of the fastest period; within one the second derivative is taken to change sign once at
/// most, so that every root of the first is found.
pub(in crate::many) fn minima(z: &Series) -> Vec<(f64, f64)> {
    if z.order() == 0 {
        return vec![(0.0, z.mean())];
    }
    let cells = 32 * z.order();
    let width = TAU / f64::from(cells);
    let mut found = Vec::new();
    for cell in 0..cells {
        let (lo, hi) = (f64::from(cell) * width, f64::from(cell + 1) * width);
        // The end of the last cell is the beginning of the first, to the bit.
        let [_, b, end] = z.at(if cell + 1 == cells { 0.0 } else { hi });
        if let Some(x) = minimum_within(|x| z.at(lo + x), z.at(lo), [z.at(hi)[0], b, end], hi - lo) {
            let t = lo + x;
            found.push((if t < TAU { t } else { 0.0 }, z.at(t)[0]));
        }
    }
    found
}
