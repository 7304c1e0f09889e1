//! The proof itself: Krawczyk's test on two boxes, what makes the solution an orbit, where its multipliers
//! are.

use super::{
    super::{
        motion::{
            Interval,
            krawczyk::{Boxes, enclosed},
            pattern::{apart, follow, least_period},
        },
        orbit::Claim,
    },
    Fault,
    cycle::{Cycle, Leg},
    linear::{self, Matrix, Solved, Vector},
    motion::Motion,
    text::Certificate,
};
use crate::rejection::{GoOn, claim};

/// Squarings of the map once round after which it is no longer asked whether its powers shrink.
const SQUARINGS: u32 = 30;

/// What is being proved, over intervals.
pub(super) struct Proof<'a> {
    certificate: &'a Certificate,
    cycle: Cycle<'a>,
    boxes: Boxes,
}

impl<'a> Proof<'a> {
    /// Encloses what the certificate says.
    ///
    /// # Errors
    /// Says what the method cannot do with it.
    pub fn new(certificate: &'a Certificate, go_on: GoOn) -> Result<Self, Fault> {
        let unknowns =
            |impact: &super::Impact| [vec![impact.phase.enclosed()], enclosed(&impact.state)].concat();
        let centre = certificate.impacts.iter().flat_map(unknowns).collect();
        let units = [vec![Interval::ONE], enclosed(&certificate.scales)].concat();
        let units = units.repeat(certificate.impacts.len());
        let radii = [certificate.radius, certificate.within];
        Ok(Proof {
            certificate,
            cycle: Cycle { motion: Motion::new(&certificate.machine, go_on)?, impacts: &certificate.impacts },
            boxes: Boxes::new(centre, units, radii, &certificate.inverse),
        })
    }

    /// Existence and uniqueness in the box, and then all claims about the orbit.
    pub fn run(&self, go_on: GoOn) -> Result<(), Fault> {
        let unknowns = self.boxes.solution(&self.cycle, go_on)?;
        for i in 0..self.cycle.impacts.len() {
            let holds = self.cycle.speed(&unknowns, i).is_positive();
            claim(holds, format_args!("the speed of impact {} is not certainly positive", i + 1))?;
        }
        let impacts = self.cycle.impacts;
        let at = |i: usize| self.cycle.impact(&unknowns, i);
        let known: Vec<_> = (0..impacts.len()).map(|i| (impacts[i].periods, at(i).0)).collect();
        let same = |i: usize, j: usize| {
            impacts[i].stop == impacts[j].stop && !at(i).1.iter().zip(at(j).1).any(|(&a, &b)| apart(a, b))
        };
        least_period(&known, same).map_err(Fault::False)?;
        for (i, ends) in self.certificate.flights.iter().enumerate() {
            let leg = self.cycle.leg(&unknowns, i);
            follow(i + 1, leg.duration, ends, go_on, |from, to, edges| {
                self.doubtful(i, &leg, from, to, edges).map(|stop| format!("the gap to stop {}", stop + 1))
            })?;
        }
        self.stability(&unknowns, go_on)
    }

    /// A stop whose gap z is not shown to be positive on a piece. With r half its length and m its middle, z
    /// lies in z(m) + z′(m)[−r, r] + z″[0, r²/2] and z′ in z′(m) + z″[−r, r]. Enough is z > 0; for the stop
    /// just left, where z = 0 ≤ z′, on the first piece z′ > 0 or z″ > 0; for the stop met next, where z = 0,
    /// on the last piece z′ < 0.
    fn doubtful(
        &self,
        i: usize,
        leg: &Leg,
        from: Interval,
        to: Interval,
        [first, last]: [bool; 2],
    ) -> Option<usize> {
        let impacts = self.cycle.impacts;
        let (left, met) = (impacts[i].stop, impacts[(i + 1) % impacts.len()].stop);
        let whole = from.until(to);
        let middle = whole.middle();
        let away = whole - middle;
        let [at_middle, over_all] = [middle, whole].map(|tau| (self.cycle.state(leg, tau), leg.phase + tau));
        (0..self.cycle.motion.contacts.len()).find(|&stop| {
            let [gap, slope, _] = self.cycle.motion.gap(stop, &at_middle.0, at_middle.1);
            let [_, _, bend] = self.cycle.motion.gap(stop, &over_all.0, over_all.1);
            let over = slope + bend * away;
            let gap = gap + slope * away + bend * away.squared().shifted_down(1);
            let leaves = first && stop == left && (over.is_positive() || bend.is_positive());
            let meets = last && stop == met && (-over).is_positive();
            !(gap.is_positive() || leaves || meets)
        })
    }

    /// The claim about the multipliers, the certificate's scales being the units.
    fn stability(&self, x: &[Interval], go_on: GoOn) -> Result<(), Fault> {
        if self.certificate.claim == Claim::Open {
            return Ok(());
        }
        let map = self.cycle.monodromy(x, go_on)?;
        multipliers_are(self.certificate.claim, &map, &self.boxes.units[1..=map.len()], go_on)
    }
}

/// Whether the eigenvalues of a matrix are as is claimed.
/// Stable: some power of it has a norm below 1, in these units.
/// Unstable: |det| > 1, or det(1 − P) < 0, so that the characteristic polynomial, positive far out, has a
/// root above 1, or det(1 + P) < 0, so that it has one below −1.
pub(super) fn multipliers_are(
    wanted: Claim,
    map: &Matrix,
    units: &[Interval],
    go_on: GoOn,
) -> Result<(), Fault> {
    let holds = match wanted {
        Claim::Open => true,
        Claim::Stable => {
            let in_units = |row: &Vector, unit: Interval| -> Vector {
                row.iter().zip(units).map(|(&x, &other)| (x * other).over(unit)).collect()
            };
            let mut power: Matrix = map.iter().zip(units).map(|(row, &unit)| in_units(row, unit)).collect();
            let mut shrinks = false;
            for _ in 0..SQUARINGS {
                go_on()?;
                shrinks = linear::norm(&power).is_below(Interval::ONE);
                if shrinks {
                    break;
                }
                power = linear::times(&power, &power);
            }
            shrinks
        }
        Claim::Unstable => {
            let one = linear::identity(map.len());
            let plus: Matrix = one.iter().zip(map).map(|(a, b)| linear::sum(a, b)).collect();
            let below = |x: Option<Interval>| x.is_some_and(|x| (-x).is_positive());
            let beyond = determinant(map).is_some_and(|x| (x.squared() - Interval::ONE).is_positive());
            beyond || below(without_one(map)) || below(determinant(&plus))
        }
    };
    claim(holds, format_args!("the orbit is not certainly {wanted}"))
}

/// det P; `None` where P may be singular.
fn determinant(matrix: &Matrix) -> Option<Interval> {
    linear::solve(matrix, &linear::identity(matrix.len()), true).map(|Solved { determinant, .. }| determinant)
}

/// det(1 − P), which is not 0 unless 1 is an eigenvalue of P; `None` where it may be 0.
pub(super) fn without_one(map: &Matrix) -> Option<Interval> {
    let one = linear::identity(map.len());
    determinant(&one.iter().zip(map).map(|(a, b)| linear::difference(a, b)).collect())
}
