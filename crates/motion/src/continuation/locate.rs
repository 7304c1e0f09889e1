//! The first bifurcation of a kind on the branch through an orbit: the branch followed both ways until it is
//! met.

use std::fmt;

use super::{
    Bifurcation, CurveEnd, CurvePoint, Followed, Options, PatternCurve, Step,
    follow::follow_until,
    problem::{FollowedOrbit, PatternFamily},
};
use crate::error::Result;

/// A bifurcation that was found.
#[derive(Debug, Clone)]
pub struct Located<O> {
    /// Which.
    pub bifurcation: Bifurcation,
    /// The parameter there.
    pub parameter: f64,
    /// The orbit there.
    pub orbit: O,
    /// How far along the branch, in the norm of times, speeds and parameter.
    pub length: f64,
}

/// What was met one way along a branch.
#[derive(Debug, Clone)]
pub(crate) struct OneWay {
    /// Every bifurcation that was passed, with its parameter.
    pub passed: Vec<(Bifurcation, f64)>,
    /// Why it was followed no further.
    pub end: CurveEnd,
    /// The parameter there.
    pub parameter: f64,
    /// How far that is.
    pub length: f64,
}

/// How far a bifurcation is looked for, both ways.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SearchReach {
    /// This far along the branch, in the norm of times, of speeds in units of the motion's size and of the
    /// parameter in a unit of its own, and as far in the parameter.
    Length {
        /// How far.
        reach: f64,
        /// The parameter's unit.
        unit: f64,
    },
    /// This far in the parameter, however long the branch is.
    Parameter {
        /// The parameter's unit of length along the branch.
        unit: f64,
        /// How far.
        reach: f64,
    },
}

impl SearchReach {
    /// From `start` to a value of the parameter, and a little farther.
    pub fn to(value: f64, start: f64) -> SearchReach {
        let way = (value - start).abs();
        SearchReach::Parameter { unit: way, reach: way + way / 8.0 }
    }

    /// How far.
    fn reach(self) -> f64 {
        match self {
            SearchReach::Length { reach, .. } | SearchReach::Parameter { reach, .. } => reach,
        }
    }
}

/// What a search came to.
#[derive(Debug, Clone)]
pub enum BranchSearch<O> {
    /// The nearest of the kind.
    Found(Box<Located<O>>),
    /// None of the kind: how far it was looked for, to smaller and to larger parameters.
    Nothing(Nothing),
}

/// Why a search found nothing.
#[derive(Debug, Clone)]
pub struct Nothing {
    /// What was looked for.
    pub(crate) bifurcation: Bifurcation,
    /// How far: see [`SearchReach`].
    pub(crate) reach: f64,
    /// Against the branch's direction, and along it: that of larger parameters at the start.
    pub(crate) sides: [OneWay; 2],
}

/// The bifurcation of a kind that is nearest along the branch through an orbit: followed both ways, no
/// further than `extent` says, and not beyond the branch's ends as one of orbits. Cost: as of the branch.
///
/// # Errors
/// An input error if the branch cannot be followed at the orbit itself.
pub fn nearest<F: PatternFamily + ?Sized>(
    family: &F,
    bifurcation: Bifurcation,
    orbit: &F::Orbit,
    parameter: f64,
    extent: SearchReach,
    options: &Options,
) -> Result<BranchSearch<F::Orbit>> {
    let (unit, far) = match extent {
        SearchReach::Length { reach, unit } => (unit, reach * unit),
        SearchReach::Parameter { unit, reach } => (unit, reach),
    };
    let orbits = PatternCurve::around(family, orbit.pattern().clone(), parameter, unit, far);
    let start = orbits.start_at(orbit, parameter, options)?;
    let (mut nearest, mut sides) = (None::<Located<F::Orbit>>, Vec::new());
    for start in [start.reversed(), start] {
        let (side, found) = one_way(&orbits, start, bifurcation, extent, options)?;
        sides.push(side);
        if let Some(found) = found
            && nearest.as_ref().is_none_or(|known| found.length < known.length)
        {
            nearest = Some(found);
        }
    }
    let sides: [OneWay; 2] = sides.try_into().unwrap_or_else(|_| unreachable!("both ways were gone"));
    Ok(match nearest {
        Some(found) => BranchSearch::Found(Box::new(found)),
        None => BranchSearch::Nothing(Nothing { bifurcation, reach: extent.reach(), sides }),
    })
}

fn one_way<F: PatternFamily + ?Sized>(
    orbits: &PatternCurve<'_, F>,
    start: CurvePoint,
    bifurcation: Bifurcation,
    extent: SearchReach,
    options: &Options,
) -> Result<(OneWay, Option<Located<F::Orbit>>)> {
    let wanted = |step: &Step<F::Orbit>| step.event.map(|event| Bifurcation::ALL[event]) == Some(bifurcation);
    let stop = |step: &Step<F::Orbit>| match () {
        () if matches!(extent, SearchReach::Length { reach, .. } if step.length > reach) => {
            Some(CurveEnd::Reach)
        }
        () if wanted(step) => Some(CurveEnd::Found),
        () => None,
    };
    // A start that is the bifurcation itself is passed from a little behind it.
    let start = if bifurcation.is_at(&orbits.view(&start)?) {
        options.corrector().step(orbits, &start, -options.step).unwrap_or(start)
    } else {
        start
    };
    let (steps, end) = follow_until(orbits, start, options, stop)?;
    let passed = steps
        .iter()
        .filter_map(|step| Some((Bifurcation::ALL[step.event?], orbits.parameter(&step.place.u))));
    let last = steps.last().unwrap_or_else(|| unreachable!("the start is there"));
    let (parameter, length) = (orbits.parameter(&last.place.u), last.length);
    // At the parameter's bound it has gone as far as was asked for too.
    let end = if end == CurveEnd::Bound { CurveEnd::Reach } else { end };
    let found = (end == CurveEnd::Found).then(|| Located {
        bifurcation,
        parameter,
        orbit: last.view.clone(),
        length,
    });
    Ok((OneWay { passed: passed.collect(), end, parameter, length }, found))
}

/// "no flip on the branch: ...".
impl fmt::Display for Nothing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no {} on the branch", self.bifurcation.name())?;
        for (side, way) in self.sides.iter().zip(["one way", "the other way"]) {
            let OneWay { passed, end, parameter, length } = side;
            write!(f, "; {way} ")?;
            match (end, passed.last()) {
                (CurveEnd::Reach, _) => {
                    write!(f, "it goes on beyond reach = {} (at {parameter:?})", self.reach)?
                }
                (CurveEnd::Fails, Some((what, at))) => write!(f, "it ends in a {} at {at:?}", what.name())?,
                _ => write!(f, "it ends at {parameter:?} ({end})")?,
            }
            write!(f, ", {length:.3} along")?;
            for (what, at) in passed.iter().filter(|(what, _)| *what == Bifurcation::Crossing) {
                write!(f, ", past a {} with another branch at {at:?}", what.name())?;
            }
        }
        if self.sides.iter().any(|side| side.end == CurveEnd::Reach) {
            f.write_str("; a larger reach looks further")?;
        }
        Ok(())
    }
}
