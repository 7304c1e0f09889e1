//! The proof itself: Krawczyk's test on two boxes, what makes the solution an orbit, Jury's conditions.

use super::{
    super::motion::{
        Interval,
        cycle::Cycle,
        krawczyk::{Boxes, Equations},
        text::Coefficient,
    },
    Fault,
    text::{Certificate, Claim},
};
use crate::rejection::{GoOn, claim};

/// What is being proved, over intervals.
pub(super) struct Proof<'a, C> {
    certificate: &'a Certificate<C>,
    cycle: Cycle<'a, Interval>,
    boxes: Boxes,
}

impl<'a, C: Coefficient> Proof<'a, C> {
    /// Encloses what the certificate says.
    ///
    /// # Errors
    /// Says what the method cannot do with it.
    pub fn new(certificate: &'a Certificate<C>) -> Result<Self, String> {
        let impacts = &certificate.impacts;
        let unknowns = impacts.iter().map(|i| i.phase).chain(impacts.iter().map(|i| i.velocity));
        let centre: Vec<Interval> = unknowns.map(|x| x.enclosed()).collect();
        let (units, radii) = (vec![Interval::ONE; centre.len()], [certificate.radius, certificate.within]);
        Ok(Proof {
            certificate,
            cycle: Cycle::new(&certificate.system, impacts, Interval::ZERO)?,
            boxes: Boxes::new(centre, units, radii, &certificate.inverse),
        })
    }

    /// Existence and uniqueness in the box, and then all claims about the orbit.
    pub fn run(&self, go_on: GoOn) -> Result<(), Fault> {
        let unknowns = self.boxes.solution(self, go_on)?;
        self.cycle.is_orbit(&unknowns, &self.certificate.flights, None, go_on)?;
        self.certificate.claim.holds(self.cycle.multipliers(&unknowns, go_on)?)
    }
}

impl Claim {
    /// Whether it is true where these are the trace T and the determinant D of the linearised map once round:
    /// stable iff D < 1 and 1 + D ± T > 0, unstable if one is < 0.
    pub(crate) fn holds(self, [trace, determinant]: [Interval; 2]) -> Result<(), Fault> {
        let sum = Interval::ONE + determinant;
        let conditions = [Interval::ONE - determinant, sum - trace, sum + trace];
        let holds = match self {
            Claim::Stable => conditions.iter().all(|x| x.is_positive()),
            Claim::Unstable => conditions.iter().any(|&x| (-x).is_positive()),
            Claim::Open => true,
        };
        claim(holds, format_args!("the orbit is not certainly {self}"))
    }
}

impl<C: Coefficient> Equations for Proof<'_, C> {
    fn residual(&self, x: &[Interval], go_on: GoOn) -> Result<Vec<Interval>, Fault> {
        self.cycle.residual(x, go_on)
    }

    /// With z seen from the wall that is met next, a later end adds (z′,
    /// z″), a later start takes away what a flight makes of the velocity and acceleration after the impact
    /// relative to the wall left behind, and a greater V adds to that velocity.
    fn derivatives(&self, x: &[Interval], go_on: GoOn) -> Result<Vec<Vec<Interval>>, Fault> {
        let (m, ring, oscillator) = (self.cycle.impacts(), self.cycle.ring(), &self.cycle.oscillator);
        let mut rows = vec![vec![Interval::ZERO; 2 * m]; 2 * m];
        for i in 0..m {
            go_on()?;
            let (leg, next) = (self.cycle.leg(x, i), (i + 1) % m);
            let [_, speed, bend] = oscillator.gap_at(leg.flight, leg.to, leg.duration, leg.end);
            let flow = ring.exp(leg.duration);
            let tau = oscillator.restitution(leg.from);
            let (_, after) = self.cycle.bends(i, x);
            let start = [-(tau * x[m + i]), -after].map(|x| leg.from.inward(x));
            let by_phase = ring.apply(flow, start).map(|x| leg.to.inward(x));
            let by_speed = ring.apply(flow, [Interval::ZERO, leg.from.inward(tau)]).map(|x| leg.to.inward(x));
            for (row, end) in [speed, bend].into_iter().enumerate() {
                let row_entries = &mut rows[2 * i + row];
                row_entries[next] = row_entries[next] + end;
                row_entries[i] = row_entries[i] + by_phase[row];
                row_entries[m + i] = row_entries[m + i] + by_speed[row];
            }
            rows[2 * i + 1][m + next] = rows[2 * i + 1][m + next] + Interval::ONE;
        }
        Ok(rows)
    }
}
