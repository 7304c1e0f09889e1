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
};
use crate::{
    certificate::single::Word,
    error::{Error, Result},
    motion::System,
    number::{Real, certain_digits, parse_rational},
    search::{
        chaos::{LetterGraph, RationalFunction},
        range::{
            Born, NothingProblem, ParameterRange, RangeEffort, RangeEnd, RangeProblem, RangeProof,
            SingleProblem, SingleProof, Touching, born, is_as_deep, parameter_range, prove, prove_alone,
            prove_farther, prove_nothing, prove_single, single_orbits,
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

/// The machine near the touch.
struct Near<'a> {
    point: &'a OscillatorGrazing<'a>,
    effort: RangeEffort,
    touching: Touching,
    /// Near the touch, and a small step.
    start: [BigRational; 2],
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
    if system.lower.is_some() && system.upper.is_some() {
        return Ok(Err("ranges are proved beside one stop; there are two".into()));
    }
    let exact = |x: f64| BigRational::from_float(x).ok_or_else(|| Error::input("not a number"));
    let unit = STEP * point.unit()? / point.event.map.e.abs();
    let start = [exact(point.event.parameter)?, exact(unit)?];
    let [at, unit] = &start;
    let touching =
        functions(point, &(at - unit), &(at + unit)).and_then(|system| Touching::of(&system, None));
    let touching = match touching {
        Ok(touching) if touching.parameters[2].is_positive() => touching,
        Ok(_) => return Ok(Err("ranges are proved for a restitution above 0".into())),
        Err(error) => return Ok(Err(error.to_string())),
    };
    let near = Near { point, effort, touching, start };
    let sides = [near.side(false)?, near.side(true)?];
    Ok(Ok(sides.into_iter().flatten().collect()))
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
    fn side(&self, behind: bool) -> Result<Vec<SideRange>> {
        let open = |verdict, reason: Option<&str>| {
            let row = RangeRow::open(behind, verdict, reason.map(String::from));
            Ok(vec![SideRange { row, text: None }])
        };
        let [damping, stiffness, _] = &self.touching.parameters;
        let (graph, whole) = match born([damping, stiffness], behind, LONGEST, self.point.job.monitor)? {
            None => return open("undecided", Some("the word theorem does not apply")),
            Some(Born { graph: None, whole: true }) if behind => return Ok(vec![self.nothing()?]),
            Some(Born { graph: None, whole: true }) => return open(NOTHING, None),
            Some(Born { graph: None, whole: false }) => {
                return open("undecided", Some("it is not decided what is born"));
            }
            Some(Born { graph: Some(graph), whole }) => (graph, whole),
        };
        let problem = RangeProblem {
            ranges: self.ranges(),
            behind,
            harmonics: self.touching.harmonics.clone(),
            graph,
            deepest: DEEPEST[usize::from(behind)],
        };
        let monitor = self.point.job.monitor;
        let found = prove(&problem, self.effort, monitor)?;
        let found = match found {
            Ok(proof) if whole => Ok(prove_alone(&problem, proof, self.effort, monitor)?),
            found => found,
        };
        let depth = found.as_ref().map_or(0.0, |proof| proof.depth.to_f64().unwrap_or(0.0));
        let mut all = vec![self.judged(behind, (ALL, &problem.graph, whole), found, self.effort)?];
        if let Some((graph, proof)) = prove_farther(&problem, depth, self.effort, monitor)? {
            all.push(self.judged(behind, (PART, &graph, false), Ok(proof), self.effort)?);
        }
        let orbits = single_orbits(&problem.graph);
        let part = RangeEffort(self.effort.0 / SHARE);
        for periods in orbits {
            let RangeProblem { ranges, harmonics, deepest, .. } = problem.clone();
            all.push(self.single(&SingleProblem { ranges, behind, harmonics, periods, deepest }, part)?);
        }
        Ok(all)
    }

    /// The orbit of one impact, along its curve.
    fn single(&self, problem: &SingleProblem, effort: RangeEffort) -> Result<SideRange> {
        let behind = problem.behind;
        let mut found = match prove_single(problem, effort, self.point.job.monitor)? {
            Err(end) => {
                let row = RangeRow::open(behind, "undecided", Some(why_single(&end, effort)));
                SideRange { row, text: None }
            }
            Ok(proof) => {
                let mut row = self.over(behind, &proof.depth, why_single(&proof.end, effort))?;
                let proved = row.verdict == PROVED;
                if proved {
                    row.stability = self.stability(behind, &proof)?;
                }
                SideRange { row, text: proved.then_some(proof.text) }
            }
        };
        (found.row.of, found.row.periods) = (ORBIT, vec![problem.periods]);
        Ok(found)
    }

    /// Where it is stable, over the parameter: parts that are shown to be in the proof's.
    fn stability(&self, behind: bool, proof: &SingleProof) -> Result<Vec<StabilityRow>> {
        let system = |from: &BigRational, to: &BigRational| functions(self.point, from, to);
        let mut all = Vec::new();
        let mut from: Option<&BigRational> = None;
        for (depth, word) in &proof.parts {
            let begin = from.replace(depth);
            let word = match word {
                Word::Stable => "stable",
                Word::Unstable => "unstable",
                Word::Open => continue,
            };
            let Some(to) = self.over(behind, depth, String::new())?.end else { continue };
            let Some(begin) = begin else {
                all.push(StabilityRow { word, from: None, to });
                continue;
            };
            // Beyond the greatest parameter up to the depth where it begins, by less and less.
            let Some(range) = self.parameters(behind, begin)? else { continue };
            let end = parse_rational(&to)?;
            let mut step = &range.end * BigRational::new(1.into(), 10u64.pow(DIGITS as u32).into());
            for _ in 0..STEPS {
                let value = if end > range.end { &range.end + step.abs() } else { &range.end - step.abs() };
                let text = inwards(&value, &end, DIGITS);
                let value = parse_rational(&text)?;
                let inside = if end > range.end { value < end } else { value > end };
                if inside && is_as_deep(&system, None, &value, begin, behind)? {
                    all.push(StabilityRow { word, from: Some(text), to });
                    break;
                }
                step *= BigRational::from_integer(10.into());
            }
        }
        Ok(all)
    }

    /// c, k and τ, known exactly.
    fn ranges(&self) -> [[BigRational; 2]; 3] {
        self.touching.parameters.each_ref().map(|x| [x.clone(), x.clone()])
    }

    /// Beyond the touch, where nothing is born: that no motion stays near.
    fn nothing(&self) -> Result<SideRange> {
        let deepest = DEEPEST[1];
        let harmonics = self.touching.harmonics.clone();
        let problem = NothingProblem { ranges: self.ranges(), harmonics, deepest };
        let (mut row, text) = match prove_nothing(&problem, self.effort, self.point.job.monitor)? {
            Err(end) => (RangeRow::open(true, NOTHING, Some(why(&end, self.effort))), None),
            Ok(proof) => {
                let mut row = self.over(true, &proof.depth, why(&proof.end, self.effort))?;
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
        found: std::result::Result<RangeProof, RangeEnd>,
        effort: RangeEffort,
    ) -> Result<SideRange> {
        let mut found = match found {
            Ok(proof) => self.proved(behind, proof, effort)?,
            Err(end) => {
                let row = RangeRow::open(behind, "undecided", Some(why(&end, effort)));
                SideRange { row, text: None }
            }
        };
        (found.row.of, found.row.periods, found.row.whole) = (of, graph.letters.clone(), whole);
        Ok(found)
    }

    /// A proof over depths as one over the parameter.
    fn proved(&self, behind: bool, proof: RangeProof, effort: RangeEffort) -> Result<SideRange> {
        let mut row = self.over(behind, &proof.depth, why(&proof.end, effort))?;
        if let Some(depth) = proof.alone.filter(|_| row.verdict == PROVED) {
            row.alone = self.over(behind, &depth, String::new())?.end;
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

    /// The values of the parameter with depths up to one.
    fn over(&self, behind: bool, depth: &BigRational, reason: String) -> Result<RangeRow> {
        let [_, unit] = &self.start;
        let open = |why: String| RangeRow::open(behind, "undecided", Some(why));
        Ok(match self.parameters(behind, depth) {
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
