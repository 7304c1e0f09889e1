//! Tasks of kind `validate` on machines: orbits found as the task `orbit` does, each proved by the checker of
//! certificates.
//!
//! Phases are fractions of the period, speeds in the scene's units.

use super::{
    Job, Judgement,
    machine_orbit::{admissible, orbits, phases, speeds},
    validate::{ProofRow, ValidateFindings, digits},
};
use crate::{
    certificate::machine::Claim,
    error::Result,
    many::{
        Machine,
        orbit::{MachineAdmissibility, MachineOrbit},
    },
    number::{Ball, Elementary, Precision, Real},
    scene::validate::ValidateTask,
    search::{
        machine::{self, ProvedMachineOrbit},
        orbit::Verdict,
    },
};

/// Proves each orbit that is found.
///
/// # Errors
/// Where the machine is not defined; an interruption.
pub fn machine_validate(task: &ValidateTask, machine: &Machine<f64>, job: &Job) -> Result<ValidateFindings> {
    let mut found = ValidateFindings::default();
    // What no certificate can hold is said before the search.
    let enclosed = job.scene.enclosed_machine()?;
    let listed = match machine::listed(&enclosed) {
        Ok(listed) => listed,
        Err(error) => {
            found.nothing(Vec::new(), error.to_string());
            return Ok(found);
        }
    };
    let simulator = job.machine_simulator(machine, &[])?;
    let all = match orbits(&task.orbit, machine, &simulator, job) {
        Ok(all) => all,
        Err(error) if error.is_interrupted() => return Err(error),
        Err(error) => {
            found.nothing(Vec::new(), error.to_string());
            return Ok(found);
        }
    };
    if all.is_empty() {
        let (starts, speed) = (task.orbit.starts, task.orbit.speed);
        found.nothing(
            Vec::new(),
            match speed {
                Some(speed) => {
                    format!("no orbit of the pattern from {starts} starts with speeds up to {speed}")
                }
                None => format!(
                    "no orbit of the pattern from {starts} starts with speeds of the size of the motion"
                ),
            },
        );
        return Ok(found);
    }
    for orbit in &all {
        job.check()?;
        let verdict = prove(&listed, orbit, job)?;
        let solution =
            phases(orbit).into_iter().zip(speeds(orbit, simulator.rate())).flat_map(|(t, v)| [t, v]);
        let pattern = orbit.pattern.named(simulator.contacts().all());
        let mut row = ProofRow::of(&verdict, pattern, solution.collect());
        if let Verdict::Proved(proof) = verdict {
            fill(&mut row, &proof, &enclosed.period)?;
            found.certify(&mut row, &job.task.name, proof.text);
        }
        found.proofs.push(row);
    }
    Ok(found)
}

/// Proves an orbit that the simulator does not refuse.
fn prove(
    listed: &crate::certificate::machine::Machine,
    orbit: &MachineOrbit,
    job: &Job,
) -> Result<Verdict<ProvedMachineOrbit>> {
    if let MachineAdmissibility::No(_) = orbit.admissibility {
        let (_, why) = admissible(orbit);
        return Ok(Verdict::Undecided(format!(
            "by the simulator the solution is no orbit: {}",
            why.unwrap_or_default()
        )));
    }
    machine::orbit(listed, orbit, &mut || job.check().is_err())
}

/// What was proved, in the scene's units.
fn fill(row: &mut ProofRow, proof: &ProvedMachineOrbit, period: &machine::Bounds) -> Result<()> {
    let precision = Precision::new(192);
    let turn = Ball::pi(&precision) * &Ball::integer(2, &precision);
    let rate = turn / &Ball::between(&period[0], &period[1], &precision);
    let shown = |x: &Ball| digits(x).unwrap_or_else(|| "?".into());
    row.phases = Some(proof.phases.iter().map(shown).collect());
    row.speeds = Some(proof.speeds.iter().map(|speed| shown(&(speed.clone() * &rate))).collect());
    row.only_within = Some(proof.radius());
    row.stable = Some(match proof.certificate.claim {
        Claim::Stable => Judgement::Yes,
        Claim::Unstable => Judgement::No,
        Claim::Open => Judgement::Marginal,
    });
    Ok(())
}
