//! How far from the touch of the motion without impacts what is born goes on, proved: for the task `grazing`.

mod cells;
mod rows;
mod said;
mod value;

use std::cell::{OnceCell, RefCell};

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::{
    super::super::range::{ALL, NOTHING, PART, RangeRow, SideRange, WantedProofs},
    SMALL,
    grazing::OscillatorGrazing,
    resonance::ResonantBirth,
    tolerated::AllMachines,
};
use crate::{
    error::{Error, Result},
    motion::System,
    number::Real,
    search::{
        chaos::{LetterGraph, RationalFunction, Term},
        range::{
            Born, ParameterRange, RangeEffort, RangeProblem, SingleProblem, TouchSide, Touching, born, prove,
            prove_alone, prove_farther, single_orbits,
        },
    },
};

/// The longest letters of a graph.
const LONGEST: u64 = 30;
/// The greatest depths that are asked for, before the touch and beyond it.
const DEEPEST: [f64; 2] = [4.0, 0.999];
/// Such parts of the work that is left are for all that is born, and for what else there is.
const ALL_BORN: u64 = 3;
const OTHERS: u64 = 4;
/// Steps of work for the values of the parameter up to a depth: some 125 at which the machine's coefficients
/// are enclosed.
const ENCLOSED: u64 = 500;
/// Where machines change with the parameter one in so many of the work is done that nobody asked for.
const MAIN_OF_CHANGING: u64 = 4;
/// How often a step from an end is made longer.
const STEPS: u32 = 6;
/// Next to a value of the parameter are those as near as one in so many of its way from the touch.
const NEXT_TO: u64 = 1_000_000;
/// Digits of ends, and of the touch, which is rounded into its side, too.
const DIGITS: i32 = 12;
const TOUCH: i32 = 17;

/// The ranges of c, k and τ.
type Ranges = [[BigRational; 2]; 3];

/// The machine near the touch.
struct Near<'a> {
    point: &'a OscillatorGrazing<'a>,
    /// Whether what is proved of all that is born will do.
    main: bool,
    /// The work allowed on a side, and what of it is done before the touch and beyond it.
    most: u64,
    efforts: [RangeEffort<'static>; 2],
    /// Whether both of two stops are touched, each the other's mirror image; then periods are half periods.
    mirrored: bool,
    /// The ranges of c, k and τ about the touch, and whether these are not the same elsewhere.
    about: Ranges,
    changes: bool,
    harmonics: Vec<Term>,
    of: Of<'a>,
    /// Near the touch, and a small step.
    start: [BigRational; 2],
    /// Before the touch and beyond it, what was asked for.
    known: [Known; 2],
}

/// What is known of a side once it is asked for.
#[derive(Default)]
struct Known {
    /// The touch; none where it is not shown.
    touch: OnceCell<Option<TouchSide>>,
    /// The parameters up to depths.
    ranges: RefCell<Vec<(BigRational, Option<ParameterRange>)>>,
}

/// What ranges are of.
enum Of<'a> {
    /// The scene's machine, with c and k about where it touches.
    One([BigRational; 2]),
    /// All machines that the task's tolerances allow.
    All(Box<AllMachines<'a>>),
}

/// Both sides, before the touch first, of each first what is proved of all that is born, then of a part that
/// goes farther, then of each orbit of one impact, and last that chaos attracts; or why no range is looked
/// for.
///
/// # Errors
/// An interruption.
pub(super) fn ranges(
    point: &OscillatorGrazing,
    wanted: WantedProofs,
) -> Result<std::result::Result<Vec<SideRange>, String>> {
    let (itinerary, system) = (&point.event.itinerary, point.job.system()?);
    if itinerary.strikes().len() != 1 || itinerary.periods() != 1 {
        return Ok(Err(
            "ranges are proved where the motion without impacts touches; another orbit does".into()
        ));
    }
    if system.lower.is_some() && system.upper.is_some() && point.half.is_none() {
        let why = "ranges are proved beside one stop, or between two that are each other's mirror images half a period \
                   later; there are two, and the machine is not known to be its own mirror image so";
        return Ok(Err(why.into()));
    }
    let written = &point.job.scene.system()?;
    if let (Some(lower), Some(upper)) = (&written.lower, &written.upper) {
        let both = [&lower.restitution, &upper.restitution];
        if both[0].to_string() != both[1].to_string() && !both.iter().all(|x| x.is_rational()) {
            return Ok(Err("the two stops' restitutions are not known to be one number".into()));
        }
    }
    let exact = |x: f64| BigRational::from_float(x).ok_or_else(|| Error::input("not a number"));
    let unit = SMALL * point.unit()? / point.event.map.e.abs();
    let start = [exact(point.event.parameter)?, exact(unit)?];
    if !point.task.tolerance.0.is_empty() {
        return of_all(point, wanted, start);
    }
    let [at, unit] = &start;
    let between = |from: &BigRational, to: &BigRational| {
        Touching::of(&functions(point, &RationalFunction::range(from, Some(to)))?, None)
    };
    let touching = between(&(at - unit), &(at + unit)).and_then(|near| Ok((near, between(at, at)?)));
    let (touching, [damping, stiffness, _]) = match touching {
        Ok((touching, there)) if touching.parameters[2][0].is_positive() => (touching, there.parameters),
        Ok(_) => return Ok(Err("ranges are proved for a restitution above 0".into())),
        Err(error) => return Ok(Err(error.to_string())),
    };
    let there = [damping, stiffness].map(|[value, _]| value);
    // Several depths are tried where the machines change.
    let changes = touching.changes;
    // Coefficients that change are enclosed, which takes more time than it counts for.
    let share = if wanted.main && changes { MAIN_OF_CHANGING } else { 1 };
    let most = wanted.range.unwrap_or(RangeEffort::DEFAULT) / share;
    let Touching { mirrored, parameters: about, harmonics, .. } = touching;
    Near {
        point,
        main: wanted.main,
        most,
        efforts: [most; 2].map(RangeEffort::new),
        mirrored,
        about,
        changes,
        harmonics,
        of: Of::One(there),
        start,
        known: Default::default(),
    }
    .sides(wanted)
    .map(Ok)
}

/// The same for all machines that the task's tolerances allow.
fn of_all(
    point: &OscillatorGrazing,
    wanted: WantedProofs,
    start: [BigRational; 2],
) -> Result<std::result::Result<Vec<SideRange>, String>> {
    let all = match AllMachines::new(point)? {
        Ok(all) => all,
        Err(why) => return Ok(Err(why)),
    };
    let (about, harmonics) = match all.oscillator(&start[0]) {
        Ok((about, _)) if !about[2][0].is_positive() => {
            return Ok(Err("ranges are proved for a restitution above 0".into()));
        }
        Ok(found) => found,
        Err(error) => return Ok(Err(error.to_string())),
    };
    let most = wanted.range.unwrap_or(RangeEffort::DEFAULT);
    Near {
        point,
        main: wanted.main,
        most,
        efforts: [most; 2].map(RangeEffort::new),
        mirrored: false,
        about,
        changes: false,
        harmonics,
        of: Of::All(Box::new(all)),
        start,
        known: Default::default(),
    }
    .sides(wanted)
    .map(Ok)
}

/// The scene's system where the task's parameter is this number, or runs through these.
pub(super) fn functions(
    point: &OscillatorGrazing,
    at: &RationalFunction,
) -> Result<System<RationalFunction>> {
    let (scene, varied) = (&point.job.scene, &point.task.parameter);
    let values: Vec<RationalFunction> = scene
        .parameters
        .iter()
        .map(|(name, value)| match name == varied {
            true => at.clone(),
            false => RationalFunction::ratio(value, &()),
        })
        .collect();
    let system = scene.system()?.in_radians();
    system.try_map(|expression| expression.evaluate(&values, &()))
}

impl Near<'_> {
    fn sides(&self, wanted: WantedProofs) -> Result<Vec<SideRange>> {
        let mut all = match wanted.range {
            Some(_) => [self.side(false)?, self.side(true)?].into_iter().flatten().collect(),
            None => Vec::new(),
        };
        if wanted.attractor {
            let mut side = self.attractor()?;
            let found = self.value(&side.row)?;
            if let Some(Err(why)) = &found {
                side.row.lacks(&self.point.task.parameter, why);
            }
            all.push(side);
            all.extend(found.and_then(std::result::Result::ok));
        }
        Ok(all)
    }

    /// What is born on one side.
    fn born(&self, behind: bool) -> Result<std::result::Result<Born, &'static str>> {
        Ok(match &self.of {
            Of::One([damping, stiffness]) => {
                let found =
                    born(self.mirrored, [damping, stiffness], behind, LONGEST, self.point.job.monitor)?;
                found.ok_or("the word theorem does not apply")
            }
            Of::All(all) => {
                let found = all.born(behind, LONGEST)?;
                found.ok_or("gamma has not one sign for all machines within the tolerances, or may be 0")
            }
        })
    }

    fn side(&self, behind: bool) -> Result<Vec<SideRange>> {
        let open = |verdict, reason: Option<&str>| {
            let row = RangeRow::open(behind, verdict, reason.map(String::from));
            Ok(vec![SideRange { row, proofs: Vec::new() }])
        };
        let beside = |mut rows: Vec<SideRange>| {
            rows.append(&mut self.orbits(behind, &[])?);
            Ok(rows)
        };
        let (graph, whole) = match self.born(behind)? {
            Err(why) => return beside(open("undecided", Some(why))?),
            Ok(Born { graph: None, whole: true }) if behind => return Ok(vec![self.nothing()?]),
            Ok(Born { graph: None, whole: true }) => return open(NOTHING, None),
            Ok(Born { graph: None, whole: false }) => {
                return beside(open("undecided", Some("it is not decided what is born"))?);
            }
            Ok(Born { graph: Some(graph), whole }) => (graph, whole),
        };
        let deepest = DEEPEST[usize::from(behind)];
        let harmonics = self.harmonics.clone();
        let ranges = self.about.clone();
        let mirrored = self.mirrored;
        let problem = RangeProblem { mirrored, ranges, behind, harmonics, graph, deepest };
        let monitor = self.point.job.monitor;
        let of = |graph: &LetterGraph, ranges: Ranges, deepest| RangeProblem {
            ranges,
            deepest,
            graph: graph.clone(),
            ..problem.clone()
        };
        let effort = self.effort(behind);
        let of_graph = |graph: &LetterGraph, effort: &RangeEffort| {
            self.cells(behind, effort, &|ranges, deepest, effort| {
                prove(&of(graph, ranges, deepest), effort, monitor)
            })
        };
        if self.main {
            let found = of_graph(&problem.graph, effort)?;
            return Ok(vec![self.judged(behind, (ALL, &problem.graph, whole), found)?]);
        }
        let mut found = of_graph(&problem.graph, &effort.part(ALL_BORN))?;
        if whole && let Ok(cells) = &mut found {
            let effort = effort.part(OTHERS);
            for (proof, machines) in cells {
                let problem = of(&problem.graph, machines.ranges.clone(), deepest);
                *proof = prove_alone(&problem, proof.clone(), &effort, monitor)?;
                if proof.alone.as_ref() != Some(&proof.depth) {
                    break;
                }
            }
        }
        let farthest = found.as_ref().ok().and_then(|cells| cells.last());
        let depth = farthest.and_then(|(proof, _)| proof.depth.to_f64()).unwrap_or(0.0);
        // Where the machines change with the depth, by one of them, the farthest.
        let ranges = self.machine_at(farthest.and_then(|(_, machines)| machines.until.as_ref()))?;
        let mut all = vec![self.judged(behind, (ALL, &problem.graph, whole), found)?];
        // Orbits need little, and go far: a part has what they leave.
        let mut orbits = self.orbits(behind, &single_orbits(&problem.graph))?;
        let farther = RangeProblem { ranges, ..problem.clone() };
        let share = if self.changes { 2 } else { 1 };
        if let Some((graph, proof)) = prove_farther(&farther, depth, &effort.part(share), monitor)? {
            let found =
                if self.changes { of_graph(&graph, effort)? } else { Ok(vec![(proof, self.fixed())]) };
            let part = self.judged(behind, (PART, &graph, false), found)?;
            if !self.changes || part.row.goes_farther_than(&all[0].row) {
                all.push(part);
            }
        }
        all.append(&mut orbits);
        Ok(all)
    }

    /// The orbits of one impact in these periods, and at resonances, of which the graph is not.
    fn orbits(&self, behind: bool, letters: &[u64]) -> Result<Vec<SideRange>> {
        let mut letters = letters.to_vec();
        if behind && !self.main && matches!(self.of, Of::One(_)) {
            for n in 1..=LONGEST {
                // Where γ = 0 floats may have its letter.
                let born = self.point.resonance(n)?;
                if matches!(born, Some(ResonantBirth::Orbit { .. })) && !letters.contains(&n) {
                    letters.push(n);
                }
            }
        }
        let (mirrored, deepest) = (self.mirrored, DEEPEST[usize::from(behind)]);
        let one = |(left, &periods): (u64, &u64)| {
            let (ranges, harmonics) = (self.about.clone(), self.harmonics.clone());
            let problem = SingleProblem { mirrored, ranges, behind, harmonics, periods, deepest };
            self.single(&problem, &self.effort(behind).part(left))
        };
        (2..letters.len() as u64 + 2).rev().zip(&letters).map(one).collect()
    }

    /// The work on a side.
    fn effort(&self, behind: bool) -> &RangeEffort<'static> {
        &self.efforts[usize::from(behind)]
    }

    /// c, k and τ next to a value of the parameter, in few digits, or about the touch.
    fn machine_at(&self, value: Option<&BigRational>) -> Result<Ranges> {
        let Some(at) = value else { return Ok(self.about.clone()) };
        let next = at + (&self.start[0] - at) * BigRational::new(1.into(), NEXT_TO.into());
        let (from, to) = if next < *at { (&next, at) } else { (at, &next) };
        Ok(Touching::of(&functions(self.point, &RationalFunction::range(from, Some(to)))?, None)?.parameters)
    }
}
