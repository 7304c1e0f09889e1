//! Where damping, stiffness or restitution change with the parameter: each of its values is another machine,
//! and a certificate is of ranges of them. The parameter is cut into cells, each with a certificate from the
//! touch to its own depth, so that where two cells meet both are of the same motions.

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::{DEEPEST, Near, Ranges, functions};
use crate::{
    error::Result,
    number::parse_rational,
    search::{
        Accepted,
        attractor::AttractorProof,
        chaos::RationalFunction,
        range::{NothingProof, ParameterRange, RangeEffort, RangeEnd, RangeProof, SingleProof, Touching},
    },
};

/// How many depths are tried for the first cell; after one at which nothing is proved, one so many times
/// smaller; how near to all of it is all; and how near to one that is not reached is enough.
const TRIES: u32 = 7;
const SMALLER: f64 = 16.0;
const NEARLY: f64 = 1e-3;
const ENOUGH: f64 = 0.3;
/// How many further cells are tried. The first of them is such a part of the first cell, each the longer
/// after one that is proved to its end, and the shorter after one that is not, until it is such a part of the
/// depth.
const FURTHER: u32 = 7;
const NEXT: f64 = 0.7;
const LONGER: f64 = 1.5;
const SHORTER: f64 = 0.4;
const SHORTEST: f64 = 0.01;
/// Such a part of the work is for the first cell; and of what is left such a part for each that is tried.
const FIRST: u64 = 2;
const EACH: u64 = 3;

/// What is proved, or why nothing is.
pub(super) type Reached<T> = std::result::Result<T, RangeEnd>;
/// What is proved, and of which machines: cell by cell, the first from the touch on. There is one at least.
pub(super) type Cells<T> = Vec<(T, Machines)>;
/// Proves what is asked for of machines to a depth, with an effort.
pub(super) type Prove<'a, T> = &'a dyn Fn(Ranges, f64, &RangeEffort) -> Result<Reached<T>>;

/// The machines of a proof: all whose damping, stiffness and restitution are in these ranges.
#[derive(Clone)]
pub(super) struct Machines {
    pub ranges: Ranges,
    /// Up to here their parameter is known to be among those; none where they do not change with it.
    pub until: Option<BigRational>,
}

/// To as many digits as a certificate's depth has, so that a proof can reach just that.
fn rounded(depth: f64) -> f64 {
    format!("{depth:.5e}").parse().unwrap_or(depth)
}

/// What is proved to a depth.
pub(super) trait Deep {
    fn depth(&self) -> &BigRational;
    /// Why it goes no further.
    fn end(&self) -> &RangeEnd;
    fn ends_by(&mut self, end: RangeEnd);
    /// The certificate.
    fn accepted(&self) -> &Accepted;
    /// Depths up to which more is said of the motions.
    fn marks(&self) -> Vec<BigRational>;
    /// Between which times after the touch the impacts are that make a motion the only one.
    fn window(&self) -> Option<[String; 2]>;
}

macro_rules! deep {
    ($($proof:ty: $window:expr, $marks:expr);+) => {$(
        impl Deep for $proof {
            fn depth(&self) -> &BigRational {
                &self.depth
            }
            fn end(&self) -> &RangeEnd {
                &self.end
            }
            fn ends_by(&mut self, end: RangeEnd) {
                self.end = end;
            }
            fn accepted(&self) -> &Accepted {
                &self.accepted
            }
            fn marks(&self) -> Vec<BigRational> {
                $marks(self)
            }
            fn window(&self) -> Option<[String; 2]> {
                $window(self)
            }
        }
    )+};
}
deep!(
    RangeProof: |proof: &RangeProof| {
        let window = proof.certificate.window;
        Some([format!("-{window}"), window.to_string()])
    }, |proof: &RangeProof| proof.alone.iter().cloned().collect();
    SingleProof: |proof: &SingleProof| {
        let last = proof.certificate.cells.last()?;
        let zero = String::from("0");
        Some(if proof.certificate.forward { [zero, last.to_string()] } else { [format!("-{last}"), zero] })
    }, |proof: &SingleProof| proof.parts.iter().map(|(depth, _)| depth.clone()).collect();
    NothingProof: |_| None, |_| Vec::new();
    AttractorProof: |_| None, |_| Vec::new()
);

impl Near<'_> {
    /// What is proved as far as it goes, and of which machines.
    pub(super) fn cells<T: Deep>(
        &self,
        behind: bool,
        effort: &RangeEffort,
        prove: Prove<T>,
    ) -> Result<Reached<Cells<T>>> {
        let deepest = DEEPEST[usize::from(behind)];
        if !self.changes {
            let machines = self.fixed();
            return Ok(prove(machines.ranges.clone(), deepest, effort)?.map(|proof| vec![(proof, machines)]));
        }
        let mut cells = match self.widest(behind, &effort.part(FIRST), prove)? {
            Ok(first) => vec![first],
            Err(end) => return Ok(Err(end)),
        };
        self.go_on(behind, effort, prove, &mut cells)?;
        Ok(Ok(cells))
    }

    /// The first cell. A proof is of all machines on the way to a depth: the deeper that is, the more these
    /// are and the sooner the proof ends, so that a depth is looked for that is just reached.
    fn widest<T: Deep>(
        &self,
        behind: bool,
        effort: &RangeEffort,
        prove: Prove<T>,
    ) -> Result<Reached<(T, Machines)>> {
        let deepest = DEEPEST[usize::from(behind)];
        let (mut best, mut farthest): (Option<(T, Machines)>, f64) = (None, 0.0);
        // All of the first is reached, not all of the second.
        let (mut reached, mut asked, mut above, mut last) = (0.0f64, deepest, deepest, 0.0);
        let mut end = RangeEnd::Wide;
        for _ in 0..TRIES {
            let found = self.tried(behind, None, asked, &effort.part(EACH), prove)?;
            let depth = match found {
                Err(why) => {
                    end = why;
                    0.0
                }
                Ok((cell, depth)) => {
                    if depth > farthest {
                        (best, farthest) = (Some(cell), depth);
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
            if settled || reached >= above * ENOUGH || effort.is_spent() {
                break;
            }
            asked = rounded(if reached > 0.0 { (reached * above).sqrt() } else { above / SMALLER });
        }
        Ok(best.ok_or(if effort.is_spent() { RangeEnd::Work } else { end }))
    }

    /// Cells beyond the first.
    fn go_on<T: Deep>(
        &self,
        behind: bool,
        effort: &RangeEffort,
        prove: Prove<T>,
        cells: &mut Cells<T>,
    ) -> Result<()> {
        let deepest = DEEPEST[usize::from(behind)];
        let Some((first, _)) = cells.first() else { return Ok(()) };
        let mut last = first.depth().to_f64().unwrap_or(deepest);
        let mut width = NEXT * last;
        for _ in 0..FURTHER {
            if last >= deepest * (1.0 - NEARLY) || width < SHORTEST * last {
                break;
            }
            let Some((proof, machines)) = cells.last_mut() else { break };
            if effort.is_spent() {
                proof.ends_by(RangeEnd::Work);
                break;
            }
            // Where the row says that the last cell ends: what is rounded there is the next one's.
            let row = self.over(behind, proof.depth(), machines, String::new())?;
            let Some(from) = row.end.and_then(|end| parse_rational(&end).ok()) else { break };
            let asked = rounded((last + width).min(deepest));
            let end = match self.tried(behind, Some(from), asked, &effort.part(EACH), prove)? {
                Ok((cell, depth)) if depth >= last * (1.0 + 0.5 * SHORTEST) => {
                    width *= if depth >= asked * (1.0 - NEARLY) { LONGER } else { SHORTER };
                    cells.push(cell);
                    last = depth;
                    continue;
                }
                Ok(((proof, _), _)) => proof.end().clone(),
                Err(end) => end,
            };
            width *= SHORTER;
            if let Some((proof, _)) = cells.last_mut() {
                proof.ends_by(end);
            }
        }
        Ok(())
    }

    /// One cell and how deep it goes, of machines from a value of the parameter, or from the touch, to where
    /// the depth is `asked`.
    fn tried<T: Deep>(
        &self,
        behind: bool,
        from: Option<BigRational>,
        asked: f64,
        effort: &RangeEffort,
        prove: Prove<T>,
    ) -> Result<Reached<((T, Machines), f64)>> {
        let Some(machines) = self.machines(behind, from, asked)? else { return Ok(Err(RangeEnd::Wide)) };
        Ok(prove(machines.ranges.clone(), asked, effort)?.map(|mut proof| {
            // More could be asked for, of other machines.
            if asked < DEEPEST[usize::from(behind)] && *proof.end() == RangeEnd::Asked {
                proof.ends_by(RangeEnd::Wide);
            }
            let depth = proof.depth().to_f64().unwrap_or(0.0);
            ((proof, machines), depth)
        }))
    }

    /// The machine where nothing but the wall changes with the parameter.
    pub(super) fn fixed(&self) -> Machines {
        Machines { ranges: self.about.clone(), until: None }
    }

    /// The machines from a value of the parameter, or from the touch, to a depth; none if these are not
    /// known.
    fn machines(&self, behind: bool, from: Option<BigRational>, depth: f64) -> Result<Option<Machines>> {
        let Some(depth) = BigRational::from_float(depth) else { return Ok(None) };
        let found = self.parameters(behind, &depth).and_then(|range| {
            let Some(ParameterRange { touch: [lo, hi], end }) = range else { return Ok(None) };
            let above = end > hi;
            let near = from.unwrap_or(if above { lo } else { hi });
            if (end > near) != above {
                return Ok(None);
            }
            let (least, greatest) = if above { (near, end.clone()) } else { (end.clone(), near) };
            let over = RationalFunction::range(&least, Some(&greatest));
            let ranges = Touching::of(&functions(self.point, &over)?, None)?.parameters;
            Ok(ranges[2][0].is_positive().then_some(Machines { ranges, until: Some(end) }))
        });
        match found {
            Err(error) if error.is_interrupted() => Err(error),
            // A machine on the way that is none, as one without a spring.
            Err(_) => Ok(None),
            Ok(machines) => Ok(machines),
        }
    }
}
