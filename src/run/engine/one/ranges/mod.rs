//! How far from the touch of the motion without impacts what is born goes on, proved: for the task `grazing`.

use std::f64::consts::TAU;

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::{
    super::super::range::{
        ALL, NOTHING, ORBIT, PART, PROVED, RangeRow, SideRange, StabilityRow, downwards, inwards, why,
        why_single,
    },
    grazing::OscillatorGrazing,
    tolerated::AllMachines,
};
use crate::{
    certificate::single::Word,
    error::{Error, Result},
    motion::System,
    number::{Real, certain_digits, parse_rational},
    search::{
        chaos::{LetterGraph, RationalFunction, Term},
        range::{
            Born, NothingProblem, NothingProof, ParameterRange, RangeEffort, RangeEnd, RangeProblem,
            RangeProof, SingleProblem, SingleProof, Touching, born, is_as_deep, parameter_range, prove,
            prove_alone, prove_farther, prove_nothing, prove_single, single_orbits,
        },
    },
};

/// The longest letters of a graph.
const LONGEST: u64 = 30;
/// The greatest depths that are asked for, before the touch and beyond it.
const DEEPEST: [f64; 2] = [4.0, 0.999];
/// A small step of the parameter: it opens the gap by this part of the motion's size.
const STEP: f64 = 1e-6;
/// Each orbit of one impact has such a part of the effort of all that is born.
const SHARE: u64 = 4;
/// How often a step from an end is made longer.
const STEPS: u32 = 6;
/// Digits of ends.
const DIGITS: i32 = 12;
/// Where damping, stiffness or restitution change with the parameter: how many depths are tried, each with
/// such a part of the effort; after one at which nothing is proved, one so many times smaller; and how near
/// to all of it is all.
const TRIES: u32 = 7;
const PART_OF_EFFORT: u64 = 4;
const SMALLER: f64 = 16.0;
const NEARLY: f64 = 1e-3;

/// The ranges of c, k and τ.
type Ranges = [[BigRational; 2]; 3];
/// What is proved, or why nothing is.
type Reached<T> = std::result::Result<T, RangeEnd>;

/// The machines of a proof: all whose damping, stiffness and restitution are in these ranges.
#[derive(Clone)]
struct Machines {
    ranges: Ranges,
    /// Up to here their parameter is known to be among those; none where they do not change with it.
    until: Option<BigRational>,
}

/// To as many digits as a certificate's depth has, so that a proof can reach just that.
fn rounded(depth: f64) -> f64 {
    format!("{depth:.5e}").parse().unwrap_or(depth)
}

/// What is proved to a depth.
trait Deep {
    fn reached(&mut self) -> (&BigRational, &mut RangeEnd);
}

macro_rules! deep {
    ($($proof:ty),+) => {$(
        impl Deep for $proof {
            fn reached(&mut self) -> (&BigRational, &mut RangeEnd) {
                (&self.depth, &mut self.end)
            }
        }
    )+};
}
deep!(RangeProof, SingleProof, NothingProof);

/// The machine near the touch.
struct Near<'a> {
    point: &'a OscillatorGrazing<'a>,
    effort: RangeEffort,
    /// Whether both of two stops are touched, each the other's mirror image; then periods are half periods.
    mirrored: bool,
    /// The ranges of c, k and τ about the touch, and whether these are not the same elsewhere.
    about: Ranges,
    changes: bool,
    harmonics: Vec<Term>,
    of: Of<'a>,
    /// Near the touch, and a small step.
    start: [BigRational; 2],
}

/// What ranges are of.
enum Of<'a> {
    /// The scene's machine, with c and k about where it touches.
    One([BigRational; 2]),
    /// All machines that the task's tolerances allow.
    All(Box<AllMachines<'a>>),
}

/// Both sides, before the touch first, of each first what is proved of all that is born, then of a part that
/// goes farther, then of each orbit of one impact; or why no range is looked for.
///
/// # Errors
/// An interruption.
pub(super) fn ranges(
    point: &OscillatorGrazing,
    effort: RangeEffort,
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
    let exact = |x: f64| BigRational::from_float(x).ok_or_else(|| Error::input("not a number"));
    let unit = STEP * point.unit()? / point.event.map.e.abs();
    let start = [exact(point.event.parameter)?, exact(unit)?];
    if !point.task.tolerance.0.is_empty() {
        return of_all(point, effort, start);
    }
    let [at, unit] = &start;
    let between = |from: &BigRational, to: &BigRational| Touching::of(&functions(point, from, to)?, None);
    let touching = between(&(at - unit), &(at + unit)).and_then(|near| Ok((near, between(at, at)?)));
    let (touching, [damping, stiffness, _]) = match touching {
        Ok((touching, there)) if touching.parameters[2][0].is_positive() => (touching, there.parameters),
        Ok(_) => return Ok(Err("ranges are proved for a restitution above 0".into())),
        Err(error) => return Ok(Err(error.to_string())),
    };
    let there = [damping, stiffness].map(|[value, _]| value);
    // Several depths are tried where the machines change.
    let changes = touching.changes();
    let effort = if changes { RangeEffort(effort.0 / PART_OF_EFFORT) } else { effort };
    let Touching { mirrored, parameters: about, harmonics, .. } = touching;
    Near { point, effort, mirrored, about, changes, harmonics, of: Of::One(there), start }.sides().map(Ok)
}

/// The same for all machines that the task's tolerances allow.
fn of_all(
    point: &OscillatorGrazing,
    effort: RangeEffort,
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
    Near {
        point,
        effort,
        mirrored: false,
        about,
        changes: false,
        harmonics,
        of: Of::All(Box::new(all)),
        start,
    }
    .sides()
    .map(Ok)
}

/// The scene's system for all values of the task's parameter above one number, up to another.
fn functions(
    point: &OscillatorGrazing,
    from: &BigRational,
    to: &BigRational,
) -> Result<System<RationalFunction>> {
    let (scene, varied) = (&point.job.scene, &point.task.parameter);
    let values: Vec<RationalFunction> = scene
        .parameters
        .iter()
        .map(|(name, value)| match name == varied {
            true => RationalFunction::range(from, Some(to)),
            false => RationalFunction::ratio(value, &()),
        })
        .collect();
    scene.system()?.try_map(|expression| expression.evaluate(&values, &()))
}

impl Near<'_> {
    fn sides(&self) -> Result<Vec<SideRange>> {
        Ok([self.side(false)?, self.side(true)?].into_iter().flatten().collect())
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
            Ok(vec![SideRange { row, text: None }])
        };
        let (graph, whole) = match self.born(behind)? {
            Err(why) => return open("undecided", Some(why)),
            Ok(Born { graph: None, whole: true }) if behind => return Ok(vec![self.nothing()?]),
            Ok(Born { graph: None, whole: true }) => return open(NOTHING, None),
            Ok(Born { graph: None, whole: false }) => {
                return open("undecided", Some("it is not decided what is born"));
            }
            Ok(Born { graph: Some(graph), whole }) => (graph, whole),
        };
        let deepest = DEEPEST[usize::from(behind)];
        let harmonics = self.harmonics.clone();
        let ranges = self.about.clone();
        let mirrored = self.mirrored;
        let problem = RangeProblem { mirrored, ranges, behind, harmonics, graph, deepest };
        let monitor = self.point.job.monitor;
        let of = |ranges: Ranges, deepest| RangeProblem { ranges, deepest, ..problem.clone() };
        let mut found = self.widest(behind, self.effort, &|ranges, deepest, effort| {
            prove(&of(ranges, deepest), effort, monitor)
        })?;
        let mut depth = 0.0;
        if let Ok((proof, machines)) = &mut found {
            depth = proof.depth.to_f64().unwrap_or(0.0);
            if whole {
                let problem = of(machines.ranges.clone(), deepest);
                *proof = prove_alone(&problem, proof.clone(), self.effort, monitor)?;
            }
        }
        let mut all = vec![self.judged(behind, (ALL, &problem.graph, whole), found)?];
        // Where the machines change with the depth, those of the whole are no measure for a part.
        if !self.changes
            && let Some((graph, proof)) = prove_farther(&problem, depth, self.effort, monitor)?
        {
            let found = Ok((proof, self.fixed()));
            all.push(self.judged(behind, (PART, &graph, false), found)?);
        }
        for periods in single_orbits(&problem.graph) {
            let RangeProblem { ranges, harmonics, deepest, .. } = problem.clone();
            all.push(self.single(&SingleProblem {
                mirrored,
                ranges,
                behind,
                harmonics,
                periods,
                deepest,
            })?);
        }
        Ok(all)
    }

    /// What is proved as far as it goes, and of which machines. Where damping, stiffness and restitution
    /// change with the parameter, a proof is of all machines on the way to a depth: the deeper that is, the
    /// more these are and the sooner the proof ends, so that a depth is looked for that is just reached.
    fn widest<T: Deep>(
        &self,
        behind: bool,
        effort: RangeEffort,
        prove: &dyn Fn(Ranges, f64, RangeEffort) -> Result<Reached<T>>,
    ) -> Result<Reached<(T, Machines)>> {
        let deepest = DEEPEST[usize::from(behind)];
        if !self.changes {
            let machines = self.fixed();
            return Ok(prove(machines.ranges.clone(), deepest, effort)?.map(|proof| (proof, machines)));
        }
        let (mut best, mut farthest): (Option<(T, Machines)>, f64) = (None, 0.0);
        // All of the first is reached, not all of the second.
        let (mut reached, mut asked, mut above, mut last) = (0.0f64, deepest, deepest, 0.0);
        let mut end = RangeEnd::Wide;
        for _ in 0..TRIES {
            let found = match self.machines(behind, asked)? {
                Some(machines) => {
                    prove(machines.ranges.clone(), asked, effort)?.map(|proof| (proof, machines))
                }
                None => Err(RangeEnd::Wide),
            };
            let depth = match found {
                Err(why) => {
                    end = why;
                    0.0
                }
                Ok((mut proof, machines)) => {
                    let (depth, end) = proof.reached();
                    let depth = depth.to_f64().unwrap_or(0.0);
                    if asked < deepest && *end == RangeEnd::Asked {
                        *end = RangeEnd::Wide;
                    }
                    if depth > farthest {
                        (best, farthest) = (Some((proof, machines)), depth);
                    }
                    depth
                }
            };
            // Narrower ranges of the machines do not make the proof go farther.
            let settled = (depth - last).abs() <= 10.0 * NEARLY * depth && depth > 0.0 && depth < 0.5 * asked;
            last = depth;
            if depth >= asked * (1.0 - NEARLY) {
                reached = asked;
            } else {
                (reached, above) = (reached.max(depth), asked);
            }
            if settled || reached >= above * (1.0 - 10.0 * NEARLY) {
                break;
            }
            asked = rounded(if reached > 0.0 { (reached * above).sqrt() } else { above / SMALLER });
        }
        Ok(best.ok_or(end))
    }

    /// The machine where nothing but the wall changes with the parameter.
    fn fixed(&self) -> Machines {
        Machines { ranges: self.about.clone(), until: None }
    }

    /// The machines from the touch to a depth; none if these are not known.
    fn machines(&self, behind: bool, depth: f64) -> Result<Option<Machines>> {
        let Some(depth) = BigRational::from_float(depth) else { return Ok(None) };
        let found = self.parameters(behind, &depth).and_then(|range| {
            let Some(ParameterRange { touch: [lo, hi], end }) = range else { return Ok(None) };
            let (from, to) = if end > hi { (lo, end.clone()) } else { (end.clone(), hi) };
            let touching = Touching::of(&functions(self.point, &from, &to)?, None)?;
            let ranges = touching.parameters;
            Ok(ranges[2][0].is_positive().then_some(Machines { ranges, until: Some(end) }))
        });
        match found {
            Err(error) if error.is_interrupted() => Err(error),
            // A machine on the way that is none, as one without a spring.
            Err(_) => Ok(None),
            Ok(machines) => Ok(machines),
        }
    }

    /// The orbit of one impact, along its curve.
    fn single(&self, problem: &SingleProblem) -> Result<SideRange> {
        let behind = problem.behind;
        let effort = RangeEffort(self.effort.0 / SHARE);
        let found = self.widest(behind, effort, &|ranges, deepest, effort| {
            prove_single(
                &SingleProblem { ranges, deepest, ..problem.clone() },
                effort,
                self.point.job.monitor,
            )
        })?;
        let mut found = match found {
            Err(end) => {
                let row = RangeRow::open(behind, "undecided", Some(why_single(&end, effort)));
                SideRange { row, text: None }
            }
            Ok((proof, machines)) => {
                let mut row = self.over(behind, &proof.depth, &machines, why_single(&proof.end, effort))?;
                let proved = row.verdict == PROVED;
                if proved {
                    row.stability = self.stability(behind, &proof, &machines)?;
                }
                SideRange { row, text: proved.then_some(proof.text) }
            }
        };
        (found.row.of, found.row.periods) = (ORBIT, vec![problem.periods]);
        Ok(found)
    }

    /// Where it is stable, over the parameter: parts that are shown to be in the proof's.
    fn stability(&self, behind: bool, proof: &SingleProof, machines: &Machines) -> Result<Vec<StabilityRow>> {
        let mut all = Vec::new();
        let mut from: Option<&BigRational> = None;
        for (depth, word) in &proof.parts {
            let begin = from.replace(depth);
            let word = match word {
                Word::Stable => "stable",
                Word::Unstable => "unstable",
                Word::Open => continue,
            };
            let Some(to) = self.over(behind, depth, machines, String::new())?.end else { continue };
            let Some(begin) = begin else {
                all.push(StabilityRow { word, from: None, to });
                continue;
            };
            // Beyond the greatest parameter up to the depth where it begins, by less and less.
            let end = parse_rational(&to)?;
            let Some(last) = self.last(behind, begin, &end)? else { continue };
            let mut step = &last * BigRational::new(1.into(), 10u64.pow(DIGITS as u32).into());
            for _ in 0..STEPS {
                let value = if end > last { &last + step.abs() } else { &last - step.abs() };
                let text = inwards(&value, &end, DIGITS);
                let value = parse_rational(&text)?;
                let inside = if end > last { value < end } else { value > end };
                if inside && self.is_as_deep(&value, begin, behind)? {
                    all.push(StabilityRow { word, from: Some(text), to });
                    break;
                }
                step *= BigRational::from_integer(10.into());
            }
        }
        Ok(all)
    }

    /// About the last value of the parameter with depths up to one; of all machines the first from which each
    /// is as deep, up to `end`.
    fn last(&self, behind: bool, depth: &BigRational, end: &BigRational) -> Result<Option<BigRational>> {
        match &self.of {
            Of::One(_) => Ok(self.parameters(behind, depth)?.map(|range| range.end)),
            Of::All(all) => Ok(all.deep_from(end, depth, behind)),
        }
    }

    fn is_as_deep(&self, parameter: &BigRational, depth: &BigRational, behind: bool) -> Result<bool> {
        let system = |from: &BigRational, to: &BigRational| functions(self.point, from, to);
        match &self.of {
            Of::One(_) => is_as_deep(&system, None, parameter, depth, behind),
            Of::All(all) => Ok(all.are_as_deep(parameter, depth, behind)),
        }
    }

    /// Beyond the touch, where nothing is born: that no motion stays near.
    fn nothing(&self) -> Result<SideRange> {
        let harmonics = &self.harmonics;
        let found = self.widest(true, self.effort, &|ranges, deepest, effort| {
            let problem =
                NothingProblem { mirrored: self.mirrored, ranges, harmonics: harmonics.clone(), deepest };
            prove_nothing(&problem, effort, self.point.job.monitor)
        })?;
        let (mut row, text) = match found {
            Err(end) => (RangeRow::open(true, NOTHING, Some(why(&end, self.effort))), None),
            Ok((proof, machines)) => {
                let mut row = self.over(true, &proof.depth, &machines, why(&proof.end, self.effort))?;
                if row.verdict == PROVED {
                    (row.leaves, row.zone) = (Some(proof.periods), Some(downwards(proof.zone() / TAU)));
                }
                (row, Some(proof.text))
            }
        };
        let text = text.filter(|_| row.verdict == PROVED);
        (row.verdict, row.whole) = (NOTHING, true);
        Ok(SideRange { row, text })
    }

    /// What is found of a graph.
    fn judged(
        &self,
        behind: bool,
        (of, graph, whole): (&'static str, &LetterGraph, bool),
        found: Reached<(RangeProof, Machines)>,
    ) -> Result<SideRange> {
        let mut found = match found {
            Ok((proof, machines)) => self.proved(behind, proof, &machines)?,
            Err(end) => {
                let row = RangeRow::open(behind, "undecided", Some(why(&end, self.effort)));
                SideRange { row, text: None }
            }
        };
        (found.row.of, found.row.periods, found.row.whole) = (of, graph.letters.clone(), whole);
        Ok(found)
    }

    /// A proof over depths as one over the parameter.
    fn proved(&self, behind: bool, proof: RangeProof, machines: &Machines) -> Result<SideRange> {
        let mut row = self.over(behind, &proof.depth, machines, why(&proof.end, self.effort))?;
        if let Some(depth) = proof.alone.filter(|_| row.verdict == PROVED) {
            row.alone = self.over(behind, &depth, machines, String::new())?.end;
        }
        let text = (row.verdict == PROVED).then_some(proof.text);
        Ok(SideRange { row, text })
    }

    /// The values of the parameter with depths up to one, exactly.
    fn parameters(&self, behind: bool, depth: &BigRational) -> Result<Option<ParameterRange>> {
        let [at, unit] = &self.start;
        let system = |from: &BigRational, to: &BigRational| functions(self.point, from, to);
        parameter_range(&system, None, [at, unit], depth, behind)
    }

    /// The values of the parameter with depths up to one, of machines of a proof.
    fn over(
        &self,
        behind: bool,
        depth: &BigRational,
        machines: &Machines,
        reason: String,
    ) -> Result<RangeRow> {
        let [at, unit] = &self.start;
        let open = |why: String| RangeRow::open(behind, "undecided", Some(why));
        if let Of::All(all) = &self.of {
            return match all.range([at, unit], depth, behind) {
                Err(error) if error.is_interrupted() => Err(error),
                Err(error) => Ok(open(error.to_string())),
                Ok(None) => Ok(open("it is not shown where all machines within the tolerances touch".into())),
                Ok(Some(range)) => Ok(RangeRow::of_all(behind, &range, depth, unit, reason)),
            };
        }
        let known = |range: ParameterRange| match &machines.until {
            Some(until) if (*until > range.touch[1]) == (range.end > *until) => {
                ParameterRange { end: until.clone(), ..range }
            }
            _ => range,
        };
        Ok(match self.parameters(behind, depth).map(|range| range.map(known)) {
            Err(error) if error.is_interrupted() => return Err(error),
            Err(error) => open(error.to_string()),
            Ok(None) => {
                open("the depth is not shown to increase with the parameter from the touch on".into())
            }
            Ok(Some(range)) if range.touch[0].is_positive() != range.touch[1].is_positive() => {
                open("the touch is not told from 0".into())
            }
            Ok(Some(range)) => {
                let [lo, hi] = &range.touch;
                let inner = if range.end > *hi { hi } else { lo };
                let width = (&range.end - inner) / inner.abs().max(unit.clone());
                RangeRow {
                    touch: certain_digits(lo, hi, 17),
                    end: Some(inwards(&range.end, inner, DIGITS)),
                    share: width.abs().to_f64().filter(|_| inner.abs() > *unit),
                    depth: Some(depth.to_string()),
                    ..RangeRow::open(behind, PROVED, Some(reason))
                }
            }
        })
    }
}
