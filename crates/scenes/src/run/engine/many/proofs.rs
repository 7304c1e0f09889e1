//! What is proved of machines: their orbits, by the checker of certificates.

use super::{
    super::super::{
        Job, ProofRow, Proved,
        engine::{Proof, Prover, SEVERAL_PERIODS},
        validate::{digits, judged},
    },
    admissible, named, phases, speeds,
};
use crate::{
    certificate::machine::Machine as ListedMachine,
    error::Result,
    many::{
        Machine,
        orbit::{Admissibility, Orbit},
    },
    number::{Ball, Elementary, Precision, Real},
    search::{
        machine::{self, Bounds, ProvedMachineOrbit},
        orbit::Verdict,
    },
};

/// Proves orbits of one machine.
pub(super) struct MachineProver<'e> {
    pub job: &'e Job<'e>,
    pub machine: Machine<f64>,
    pub listed: ListedMachine,
    /// The enclosed period.
    pub period: Bounds,
}

impl Prover<Orbit> for MachineProver<'_> {
    fn prove(&self, orbit: &Orbit) -> Result<Proof> {
        if orbit.itinerary.strikes().is_empty() {
            return self.free(orbit);
        }
        let verdict = self.verdict(orbit, machine::orbit)?;
        let numbers = phases(orbit).into_iter().zip(speeds(orbit, self.machine.rate()));
        let solution = numbers.flat_map(|(t, v)| [t, v]).collect();
        let mut row = ProofRow::of(&verdict, named(&orbit.itinerary, &self.machine), solution);
        let Verdict::Proved(proof) = verdict else { return Ok(Proof { row, certificate: None }) };
        fill(&mut row.proved, &proof, &self.period)?;
        Ok(Proof { row, certificate: Some(proof.accepted) })
    }
}

/// What finds the proof of an orbit.
type Search<T> = fn(&ListedMachine, &Orbit, &mut dyn FnMut() -> bool) -> Result<Verdict<T>>;

impl MachineProver<'_> {
    /// What is proved of the motion without impacts.
    fn free(&self, orbit: &Orbit) -> Result<Proof> {
        let verdict = match orbit.itinerary.periods() {
            1 => self.verdict(orbit, machine::free_motion)?,
            _ => Verdict::Undecided(SEVERAL_PERIODS.into()),
        };
        let (q, u) = (&orbit.state.q, &orbit.state.u);
        let solution = q.iter().copied().chain(u.iter().map(|u| u * self.machine.rate())).collect();
        let mut row = ProofRow::of(&verdict, named(&orbit.itinerary, &self.machine), solution);
        let Verdict::Proved(proof) = verdict else { return Ok(Proof { row, certificate: None }) };
        row.proved.stable = Some(judged(proof.certificate.claim));
        Ok(Proof { row, certificate: Some(proof.accepted) })
    }

    /// Of an orbit that the simulator does not refuse.
    fn verdict<T>(&self, orbit: &Orbit, search: Search<T>) -> Result<Verdict<T>> {
        if let Admissibility::No(_) = orbit.admissibility {
            let (_, why) = admissible(orbit, None);
            return Ok(Verdict::Undecided(format!(
                "by the simulator the solution is no orbit: {}",
                why.unwrap_or_default()
            )));
        }
        search(&self.listed, orbit, &mut || self.job.check().is_err())
    }
}

/// What was proved, in the scene's units.
fn fill(row: &mut Proved, proof: &ProvedMachineOrbit, period: &Bounds) -> Result<()> {
    let precision = Precision::new(192);
    let turn = Ball::pi(&precision) * &Ball::integer(2, &precision);
    let rate = turn / &Ball::between(&period[0], &period[1], &precision);
    let shown = |x: &Ball| digits(x).unwrap_or_else(|| "?".into());
    row.phases = Some(proof.phases.iter().map(shown).collect());
    row.speeds = Some(proof.speeds.iter().map(|speed| shown(&(speed.clone() * &rate))).collect());
    row.only_within = Some(proof.radius());
    row.stable = Some(judged(proof.certificate.claim));
    Ok(())
}
