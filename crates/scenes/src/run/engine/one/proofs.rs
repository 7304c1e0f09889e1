//! What is proved of oscillators: their orbits, and where in a parameter these bifurcate.

use std::f64::consts::TAU;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::{
    super::super::{
        Job, ProofRow, ValidateFindings,
        engine::{Proof, Prover, RangeProver, SEVERAL_PERIODS},
        stretch::Stretch,
        validate::{all, certified, digits, judged, starts},
    },
    Oscillators, named, speeds, turn,
};
use crate::{
    continuation::{Bifurcation, BranchSearch, nearest},
    error::{Error, Result},
    local::Rung,
    monitor::timed,
    motion::System,
    number::{Ball, Elementary, Precision, Real, parse_rational},
    one::{
        branch::Patterns,
        grazing,
        orbit::{Family, Itinerary, Orbit, Unknowns},
    },
    scene::{self, SceneFamily, validate::ValidateTask},
    search::{
        machine::Bounds,
        orbit::{
            self, BranchProblem, CertifiedOrbit, Condition, ExpectedImpact, Jet, ProvedBranch, Quotient,
            Verdict,
        },
    },
};

/// Proves orbits of one oscillator.
pub(super) struct OrbitProver<'e> {
    pub job: &'e Job<'e>,
    pub system: System<Bounds>,
    /// Radians in the scene's unit of time, enclosed.
    pub rate: Ball,
    pub precision: Precision,
}

impl OrbitProver<'_> {
    /// What is proved of the motion without impacts.
    fn free(&self, approximation: &Orbit) -> Result<Proof> {
        let OrbitProver { job, system, precision, .. } = self;
        let pattern = named(&approximation.itinerary, job);
        let verdict = match approximation.itinerary.periods() {
            1 => timed(job.monitor, Rung::Ball(precision.bits()), || orbit::free_motion(system, precision))?,
            _ => Verdict::Undecided(SEVERAL_PERIODS.into()),
        };
        let verdict = certified(verdict, |motion| orbit::free_certificate(system, motion));
        let [q, u] = [approximation.z[0], approximation.z[1] * approximation.rate];
        let mut row = ProofRow::of(&verdict, pattern, vec![q, u]);
        let Verdict::Proved((enclosed, certified)) = verdict else {
            return Ok(Proof { row, certificate: None });
        };
        row.proved.trace = digits(&enclosed.trace);
        row.proved.det = digits(&enclosed.determinant);
        row.proved.stable = Some(judged(certified.claim));
        Ok(Proof { row, certificate: Some(certified.accepted) })
    }
}

impl Prover<Orbit> for OrbitProver<'_> {
    fn prove(&self, approximation: &Orbit) -> Result<Proof> {
        let OrbitProver { job, system, precision, .. } = self;
        if approximation.itinerary.strikes().is_empty() {
            return self.free(approximation);
        }
        let guess = impacts(&approximation.itinerary, &approximation.z);
        let enclosed =
            timed(job.monitor, Rung::Ball(precision.bits()), || orbit::orbit(system, &guess, precision))?;
        let verdict = certified(enclosed, |orbit| orbit::certificate(system, orbit));
        let pattern = named(&approximation.itinerary, job);
        let solution = shown(&guess, approximation.rate).collect();
        let mut row = ProofRow::of(&verdict, pattern, solution);
        let Verdict::Proved((enclosed, certified)) = verdict else {
            return Ok(Proof { row, certificate: None });
        };
        impacts_of(&mut row, &certified, &self.rate, precision);
        row.proved.trace = digits(&enclosed.trace);
        row.proved.det = digits(&enclosed.determinant);
        row.proved.stable = Some(judged(certified.claim));
        Ok(Proof { row, certificate: Some(certified.accepted) })
    }
}

/// Where the impacts are, and no others, as the certificate has it.
fn impacts_of(row: &mut ProofRow, certified: &CertifiedOrbit, rate: &Ball, precision: &Precision) {
    row.proved.phases = Some(all(&turns(&certified.phases, precision)));
    row.proved.speeds = Some(all(&per_time(&certified.velocities, rate)));
    row.proved.only_within = Some(certified.radius);
}

/// Phases as parts of the period, each before its speed in the scene's unit of time.
fn shown(impacts: &[ExpectedImpact], rate: f64) -> impl Iterator<Item = f64> {
    impacts.iter().flat_map(move |impact| [turn(impact.phase), impact.velocity * rate])
}

/// Enclosed speeds per radian in the scene's unit of time.
fn per_time(speeds: &[Ball], rate: &Ball) -> Vec<Ball> {
    speeds.iter().map(|speed| speed.clone() * rate).collect()
}

/// Enclosed times in radians as parts of the period.
fn turns(radians: &[Ball], precision: &Precision) -> Vec<Ball> {
    let whole = Ball::pi(precision) * &Ball::integer(2, precision);
    radians.iter().map(|time| time.clone() / &whole).collect()
}

/// Proves the event nearest to each admissible orbit of the task.
///
/// # Errors
/// Where the system is not defined; an interruption.
pub(super) fn events(
    task: &ValidateTask,
    event: Bifurcation,
    name: &str,
    engine: &Oscillators,
    found: &mut ValidateFindings,
) -> Result<()> {
    let job = engine.job;
    let precision = Precision::new(task.bits);
    let family = job.family(name)?;
    let start = family.value();
    let exact = |parameter: &Jet| system_at(job, name, parameter, &precision);
    found.event = Some(event.name());
    let mut known: Vec<BigRational> = Vec::new();
    for orbit in starts(task, engine, &family.at(start)?, found)? {
        job.check()?;
        if !orbit.admissibility.is_admissible() {
            found.nothing(speeds(&orbit), "the solution to begin with is not admissible".into());
            continue;
        }
        let (guess, parameter, condition) = match approximate(&family, event, &orbit, start, task) {
            Ok(found) => found,
            Err(error) => {
                found.nothing(speeds(&orbit), error.to_string());
                continue;
            }
        };
        let solution = shown(&guess, orbit.rate).chain([parameter]);
        let enclosed = timed(job.monitor, Rung::Ball(precision.bits()), || {
            orbit::event(exact, &guess, parameter, condition, &precision)
        })?;
        let verdict = certified(enclosed, |event| {
            let family = system_at(job, name, &Quotient::parameter(), &())?;
            orbit::event_certificate(&family, name, event)
        });
        let mut row = ProofRow::of(&verdict, named(&orbit.itinerary, job), solution.collect());
        if let Verdict::Proved((_, (certified, [lower, upper]))) = verdict {
            let [lo, hi] = [parse_rational(&lower)?, parse_rational(&upper)?];
            // The same event from another orbit of its branch.
            if known.iter().any(|other| lo <= *other && *other <= hi) {
                continue;
            }
            let parameter = Ball::between(&lo, &hi, &precision);
            let rate = rate_at(job, name, &parameter, &precision)?;
            impacts_of(&mut row, &certified, &rate, &precision);
            (row.parameter, row.width) = (digits(&parameter), (&hi - &lo).to_f64());
            (row.lower, row.upper) = (Some(lower), Some(upper));
            found.certify(&mut row, &job.task.name, certified.accepted);
            known.push((lo + hi) / BigRational::from_integer(2.into()));
        }
        found.proofs.push(row);
    }
    Ok(())
}

/// The oscillator at a value of a parameter, of whatever numbers.
pub(super) fn system_at<R: scene::Coefficient>(
    job: &Job,
    name: &str,
    parameter: &R,
    context: &R::Context,
) -> Result<System<R>> {
    let values = values_at(job, name, parameter, context);
    let system = job.scene.system()?.in_radians();
    system.try_map(|expression| expression.evaluate(&values, context))
}

/// The values of all parameters at one of a parameter.
fn values_at<R: Real>(job: &Job, name: &str, parameter: &R, context: &R::Context) -> Vec<R> {
    let all = job.scene.parameters.iter();
    all.map(|(other, value)| if other == name { parameter.clone() } else { R::ratio(value, context) })
        .collect()
}

/// Radians in the scene's unit of time at a value of a parameter.
fn rate_at(job: &Job, name: &str, parameter: &Ball, precision: &Precision) -> Result<Ball> {
    let values = values_at(job, name, parameter, precision);
    let one = || Ok(Ball::integer(1, precision));
    job.scene.system()?.rate.as_ref().map_or_else(one, |rate| rate.evaluate(&values, precision))
}

/// Proves orbits over ranges of a parameter.
pub(super) struct OverRange<'e> {
    job: &'e Job<'e>,
    name: &'e str,
    system: System<Quotient>,
    precision: Precision,
}

impl<'e> OverRange<'e> {
    pub fn new(job: &'e Job<'e>, name: &'e str, bits: u32) -> Result<OverRange<'e>> {
        let system = system_at(job, name, &Quotient::parameter(), &())?;
        Ok(OverRange { job, name, system, precision: Precision::new(bits) })
    }
}

impl RangeProver<Orbit> for OverRange<'_> {
    fn prove(
        &self,
        approximation: &Orbit,
        at: &BigRational,
        over: [BigRational; 2],
    ) -> Result<Verdict<ProvedBranch>> {
        let OverRange { job, name, system, precision } = self;
        let impacts = impacts(&approximation.itinerary, &approximation.z);
        let family = |parameter: &Jet| system_at(job, name, parameter, precision);
        let (at, precision) = (at.clone(), precision.clone());
        let rung = Rung::Ball(precision.bits());
        let problem = BranchProblem { family: &family, system, name, impacts: &impacts, at, over, precision };
        timed(job.monitor, rung, || orbit::branch(&problem, job.monitor))
    }

    fn holds(&self, proof: &ProvedBranch, approximation: &Orbit, at: f64) -> bool {
        proof.holds(&impacts(&approximation.itinerary, &approximation.z), at)
    }
}

/// Proves each admissible orbit of the task over the range of its parameter.
///
/// # Errors
/// Where the system is not defined; an interruption.
pub(super) fn branches(
    task: &ValidateTask,
    name: &str,
    engine: &Oscillators,
    found: &mut ValidateFindings,
) -> Result<()> {
    let job = engine.job;
    let prover = OverRange::new(job, name, task.bits)?;
    let (_, at) = &job.scene.parameters[job.scene.parameter(name)?];
    let floats = job.family(name)?;
    for orbit in starts(task, engine, &floats.at(floats.value())?, found)? {
        job.check()?;
        if !orbit.admissibility.is_admissible() {
            found.nothing(speeds(&orbit), "the solution to begin with is not admissible".into());
            continue;
        }
        let over = [&task.from, &task.to].map(|end| end.clone().unwrap_or_else(|| at.clone()));
        let verdict = prover.prove(&orbit, at, over)?;
        let impacts = impacts(&orbit.itinerary, &orbit.z);
        let solution = shown(&impacts, orbit.rate).collect();
        let mut row = ProofRow::of(&verdict, named(&orbit.itinerary, job), solution);
        if let Verdict::Proved(proof) = verdict {
            let stretch = Stretch::of(&proof);
            row.proved.stable = stretch.stable;
            (row.lower, row.upper) = (Some(stretch.lower), Some(stretch.upper));
            (row.stability, row.range_ends) = (stretch.stability, stretch.ends);
            found.certify(&mut row, &job.task.name, proof.accepted);
        }
        found.proofs.push(row);
    }
    Ok(())
}

/// Impacts, parameter and condition near which the event is expected.
fn approximate(
    family: &SceneFamily,
    event: Bifurcation,
    orbit: &Orbit,
    start: f64,
    task: &ValidateTask,
) -> Result<(Vec<ExpectedImpact>, f64, Condition)> {
    let (patterns, extent) = (Patterns::new(family, start)?, task.extent(&family.at(start)?, orbit));
    let found = match nearest(&patterns, event, orbit, start, extent, &task.options.checked()?)? {
        BranchSearch::Found(found) => found,
        BranchSearch::Nothing(nothing) => return Err(Error::input(nothing.to_string())),
    };
    if event == Bifurcation::Grazing {
        let found = grazing::locate(family, &found.orbit, found.parameter)?;
        // The tangency is the first of its impacts: what comes before it flies on to what comes after.
        let mut all = impacts(&found.itinerary, &found.z);
        let touch = all.remove(0);
        let Some(last) = all.last_mut() else {
            return Ok((
                all,
                found.parameter,
                Condition::Grazing { after: 0, side: touch.side, time: touch.phase },
            ));
        };
        let time = TAU * f64::from(last.periods) + touch.phase - last.phase;
        last.periods += touch.periods;
        let after = all.len() - 1;
        return Ok((all, found.parameter, Condition::Grazing { after, side: touch.side, time }));
    }
    let condition = if event == Bifurcation::Flip { Condition::Flip } else { Condition::SaddleNode };
    Ok((impacts(&found.orbit.itinerary, &found.orbit.z), found.parameter, condition))
}

/// The impacts of a solution of the pattern equations.
fn impacts(itinerary: &Itinerary, z: &[f64]) -> Vec<ExpectedImpact> {
    let Ok(unknowns) = Unknowns::new(itinerary, z) else { return Vec::new() };
    let strikes = itinerary.strikes().iter().enumerate();
    strikes
        .map(|(i, strike)| ExpectedImpact {
            side: strike.place,
            periods: strike.periods,
            phase: unknowns.phase(i),
            velocity: unknowns.speed(i),
        })
        .collect()
}
