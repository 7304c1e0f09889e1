//! The proof itself: Krawczyk's test of the extended equations on two boxes, and what makes the solution an
//! orbit.

use super::{
    super::motion::{
        Interval,
        cycle::{Cycle, Touch},
        krawczyk::{Boxes, Equations},
        number::{Dual, Number},
        text::Coefficient,
    },
    Certificate, Contact, Event, Fault,
};
use crate::rejection::{GoOn, claim};

/// What is being proved, over intervals.
pub(super) struct Proof<'a, C> {
    certificate: &'a Certificate<C>,
    /// Of all phases, all speeds, the parameter, the time of the contact.
    boxes: Boxes,
}

impl<'a, C: Coefficient> Proof<'a, C> {
    /// Encloses what the certificate says.
    pub fn new(certificate: &'a Certificate<C>) -> Self {
        let impacts = &certificate.impacts;
        let unknowns = impacts.iter().map(|i| i.phase).chain(impacts.iter().map(|i| i.velocity));
        let contact = match &certificate.event {
            Event::Grazing(contact) => Some(contact.time),
            Event::SaddleNode | Event::Flip => None,
        };
        let unknowns = unknowns.chain([certificate.parameter]).chain(contact);
        let centre: Vec<Interval> = unknowns.map(|x| x.enclosed()).collect();
        let (units, radii) = (vec![Interval::ONE; centre.len()], [certificate.radius, certificate.within]);
        Proof { certificate, boxes: Boxes::new(centre, units, radii, &certificate.inverse) }
    }

    /// Existence, uniqueness and regularity in the box, and that the solution is an orbit.
    pub fn run(&self, go_on: GoOn) -> Result<(), Fault> {
        let unknowns = self.boxes.solution(self, go_on)?;
        let m = self.certificate.impacts.len();
        let cycle = self.cycle(unknowns[2 * m])?;
        claim(cycle.oscillator.restitutions_are_nonnegative(), "a restitution is not certainly at least 0")?;
        claim(m > 0 || cycle.oscillator.is_alone(), "1 may be a multiplier of the motion without impacts")?;
        let touch = match &self.certificate.event {
            Event::Grazing(Contact { after, side, .. }) => {
                let time = unknowns[2 * m + 1];
                let touch = match m {
                    // The response is followed from half a period before the contact on.
                    0 => Touch { side: *side, time: Interval::PI, phase: time },
                    _ => Touch { side: *side, time, phase: unknowns[*after] + time },
                };
                Some((*after, touch))
            }
            Event::SaddleNode | Event::Flip => None,
        };
        cycle.is_orbit(&unknowns, &self.certificate.flights, touch, go_on)
    }

    /// The pattern at a value of the parameter.
    fn cycle<N: Number>(&self, parameter: N) -> Result<Cycle<'a, N>, Fault> {
        Cycle::new(&self.certificate.system, &self.certificate.impacts, parameter).map_err(Fault::False)
    }

    /// The left sides of all equations.
    fn equations<N: Number>(&self, x: &[N], go_on: GoOn) -> Result<Vec<N>, Fault> {
        let m = self.certificate.impacts.len();
        let cycle = self.cycle(x[2 * m])?;
        let mut all = cycle.residual(x, go_on)?;
        if let Event::Grazing(Contact { after, side, .. }) = &self.certificate.event {
            let [gap, speed, _] = if m == 0 {
                cycle.oscillator.gap(cycle.oscillator.steady(x[1]), *side, N::ZERO)
            } else {
                cycle.oscillator.gap(cycle.leg(x, *after).flight, *side, x[2 * m + 1])
            };
            all.extend([gap, speed]);
        } else {
            let [trace, determinant] = cycle.multipliers(x, go_on)?;
            let trace = if self.certificate.event == Event::Flip { trace } else { -trace };
            all.push(N::ONE + determinant + trace);
        }
        Ok(all)
    }
}

impl<C: Coefficient> Equations for Proof<'_, C> {
    fn residual(&self, x: &[Interval], go_on: GoOn) -> Result<Vec<Interval>, Fault> {
        self.equations(x, go_on)
    }

    /// By each unknown in turn.
    fn derivatives(&self, region: &[Interval], go_on: GoOn) -> Result<Vec<Vec<Interval>>, Fault> {
        let mut rows = vec![Vec::with_capacity(region.len()); region.len()];
        for j in 0..region.len() {
            let direction = |i| if i == j { Interval::ONE } else { Interval::ZERO };
            let x: Vec<Dual> =
                region.iter().enumerate().map(|(i, &value)| Dual { value, slope: direction(i) }).collect();
            for (row, value) in rows.iter_mut().zip(self.equations(&x, go_on)?) {
                row.push(value.slope);
            }
        }
        Ok(rows)
    }
}
