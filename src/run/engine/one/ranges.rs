//! How far from the touch of the motion without impacts what is born goes on, proved: for the task `grazing`.

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::{
    super::super::range::{RangeRow, SideRange, inwards, why},
    grazing::OscillatorGrazing,
};
use crate::{
    error::{Error, Result},
    motion::System,
    number::{Real, certain_digits},
    search::{
        chaos::RationalFunction,
        range::{Born, RangeEffort, RangeProblem, RangeProof, Touching, born, parameter_range, prove},
    },
};

/// The longest letters of a graph.
const LONGEST: u64 = 30;
/// The greatest depths that are asked for, before the touch and beyond it.
const DEEPEST: [f64; 2] = [4.0, 0.999];
/// A small step of the parameter: it opens the gap by this part of the motion's size.
const STEP: f64 = 1e-6;
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

/// Both sides, before the touch first; or why no range is looked for.
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
    let unit = STEP * point.unit()? / point.event.map.e().abs();
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
    [false, true].into_iter().map(|behind| near.side(behind)).collect::<Result<_>>().map(Ok)
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
    fn side(&self, behind: bool) -> Result<SideRange> {
        let open = |verdict, reason: Option<&str>| {
            let row = RangeRow::open(behind, verdict, reason.map(String::from));
            Ok(SideRange { row, text: None })
        };
        let [damping, stiffness, _] = &self.touching.parameters;
        let (graph, whole) = match born([damping, stiffness], behind, LONGEST, self.point.job.monitor)? {
            None => return open("undecided", Some("the word theorem does not apply")),
            Some(Born { graph: None, whole: true }) => return open("nothing born", None),
            Some(Born { graph: None, whole: false }) => {
                return open("undecided", Some("it is not decided what is born"));
            }
            Some(Born { graph: Some(graph), whole }) => (graph, whole),
        };
        let periods = graph.letters.clone();
        let [one, zero] = [1, 0].map(|n| BigRational::from_integer(n.into()));
        let both = |x: &BigRational| [x.clone(), x.clone()];
        let problem = RangeProblem {
            ranges: self.touching.parameters.each_ref().map(both),
            behind,
            harmonics: vec![(1, [both(&one), both(&zero)])],
            graph,
            deepest: DEEPEST[usize::from(behind)],
        };
        let mut found = match prove(&problem, self.effort, self.point.job.monitor)? {
            Ok(proof) => self.proved(behind, proof)?,
            Err(end) => return open("undecided", Some(&why(&end, self.effort))),
        };
        (found.row.periods, found.row.whole) = (periods, whole);
        Ok(found)
    }

    /// A proof over depths as one over the parameter.
    fn proved(&self, behind: bool, proof: RangeProof) -> Result<SideRange> {
        let [at, unit] = &self.start;
        let system = |from: &BigRational, to: &BigRational| functions(self.point, from, to);
        let reason = Some(why(&proof.end, self.effort));
        let row = match parameter_range(&system, None, [at, unit], &proof.depth, behind) {
            Err(error) if error.is_interrupted() => return Err(error),
            Err(error) => RangeRow::open(behind, "undecided", Some(error.to_string())),
            Ok(None) => {
                let why = "the depth is not shown to increase with the parameter from the touch on";
                RangeRow::open(behind, "undecided", Some(why.into()))
            }
            Ok(Some(range)) if range.touch[0].is_positive() != range.touch[1].is_positive() => {
                RangeRow::open(behind, "undecided", Some("the touch is not told from 0".into()))
            }
            Ok(Some(range)) => {
                let [lo, hi] = &range.touch;
                let inner = if range.end > *hi { hi } else { lo };
                let width = (&range.end - inner) / inner.abs().max(unit.clone());
                RangeRow {
                    touch: certain_digits(lo, hi, 17),
                    end: Some(inwards(&range.end, inner, DIGITS)),
                    share: width.abs().to_f64().filter(|_| inner.abs() > *unit),
                    depth: Some(proof.depth.to_string()),
                    ..RangeRow::open(behind, "proved", reason)
                }
            }
        };
        let text = (row.verdict == "proved").then_some(proof.text);
        Ok(SideRange { row, text })
    }
}
