//! The proof itself: Krawczyk's test on two boxes, what makes the solution an orbit, where its multipliers
//! are.

use super::{
    super::{
        orbit::Claim,
        oscillator::{
            Interval,
            krawczyk::{self, GoOn},
        },
    },
    Fault,
    cycle::{Cycle, Leg, turns},
    linear::{self, Matrix, Solved, Vector},
    motion::Motion,
    text::{Certificate, Decimal},
};

/// Squarings of the map once round after which it is no longer asked whether its powers shrink.
const SQUARINGS: u32 = 30;

/// What is being proved, over intervals.
pub(super) struct Proof<'a> {
    certificate: &'a Certificate,
    cycle: Cycle<'a>,
    centre: Vector,
    /// The unit of each unknown.
    units: Vector,
    inverse: Matrix,
}

fn wrong<T>(what: String) -> Result<T, Fault> {
    Err(Fault::False(what))
}

impl<'a> Proof<'a> {
    /// Encloses what the certificate says.
    ///
    /// # Errors
    /// Says what the method cannot do with it.
    pub fn new(certificate: &'a Certificate) -> Result<Self, String> {
        let list = |list: &[Decimal]| -> Vector { list.iter().map(|x| x.enclosed()).collect() };
        let unknowns = |impact: &super::Impact| [vec![impact.phase.enclosed()], list(&impact.state)].concat();
        let units = [vec![Interval::ONE], list(&certificate.scales)].concat();
        Ok(Proof {
            certificate,
            cycle: Cycle { motion: Motion::new(&certificate.machine)?, impacts: &certificate.impacts },
            centre: certificate.impacts.iter().flat_map(unknowns).collect(),
            units: units.repeat(certificate.impacts.len()),
            inverse: certificate.inverse.iter().map(|row| list(row)).collect(),
        })
    }

    /// Existence and uniqueness in the box, and then all claims about the orbit.
    pub fn run(&self, go_on: GoOn) -> Result<(), Fault> {
        let [radius, within] = [self.certificate.radius, self.certificate.within].map(|r| r.enclosed());
        if !within.is_positive() || !within.is_up_to(radius) {
            return wrong("the smaller radius must be positive and at most the larger".into());
        }
        self.krawczyk(radius, go_on)?;
        let unknowns = self.krawczyk(within, go_on)?;
        for i in 0..self.cycle.impacts.len() {
            if !self.cycle.speed(&unknowns, i).is_positive() {
                return wrong(format!("the speed of impact {} is not certainly positive", i + 1));
            }
        }
        self.least_period(&unknowns).map_err(Fault::False)?;
        for (i, ends) in self.certificate.flights.iter().enumerate() {
            self.admissible(i, &self.cycle.leg(&unknowns, i), ends, go_on)?;
        }
        self.stability(&unknowns, go_on)
    }

    /// The only solution in the box of `radius`, enclosed.
    fn krawczyk(&self, radius: Interval, go_on: GoOn) -> Result<Vector, Fault> {
        let radii = linear::scaled(radius, &self.units);
        let residual = self.cycle.residual(&self.centre, go_on)?;
        let derivatives = self.cycle.derivatives(&krawczyk::around(&self.centre, &radii), go_on)?;
        krawczyk::image(&self.centre, &self.inverse, &residual, &derivatives, &radii, go_on)
    }

    /// No smaller whole number of periods is one of the orbit. If one were, it would hold d of the m impacts,
    /// d a divisor of m, and every impact would come back d impacts later: on the same stop, in the same
    /// state, d/m of all periods later. For each such d some impact does not.
    fn least_period(&self, x: &[Interval]) -> Result<(), String> {
        let impacts = self.cycle.impacts;
        let m = impacts.len();
        let apart = |a: Interval, b: Interval| (a - b).is_positive() || (b - a).is_positive();
        let total: u64 = impacts.iter().map(|impact| impact.periods).sum();
        for d in (1..m).filter(|&d| m.is_multiple_of(d) && (total * d as u64).is_multiple_of(m as u64)) {
            let shift = turns(total * d as u64 / m as u64);
            let comes_back = |i: usize| {
                let j = (i + d) % m;
                let between: u64 = (i..i + d).map(|l| impacts[l % m].periods).sum();
                let ((t, state), (later, other)) = (self.cycle.impact(x, i), self.cycle.impact(x, j));
                impacts[i].stop == impacts[j].stop
                    && !apart(turns(between) + later - t, shift)
                    && !state.iter().zip(other).any(|(&a, &b)| apart(a, b))
            };
            if (0..m).all(comes_back) {
                return Err(format!("the orbit may repeat itself after {d} of its {m} impacts"));
            }
        }
        Ok(())
    }

    /// Every gap is positive during flight i, piece by piece.
    fn admissible(&self, i: usize, leg: &Leg, ends: &[Decimal], go_on: GoOn) -> Result<(), Fault> {
        let (flight, last) = (i + 1, ends.len() - 1);
        if !leg.duration.is_positive() {
            return wrong(format!("flight {flight} does not certainly last"));
        }
        if !leg.duration.is_up_to(ends[last].enclosed()) {
            return wrong(format!("the pieces of flight {flight} stop before its end"));
        }
        let mut from = Interval::ZERO;
        for (number, to) in ends.iter().map(|end| end.enclosed()).enumerate() {
            go_on()?;
            if !(to - from).is_positive() {
                return wrong(format!("the pieces of flight {flight} do not follow one another"));
            }
            if let Some(stop) = self.doubtful(i, leg, from, to, [number == 0, number == last]) {
                return wrong(format!(
                    "the gap to stop {} on piece {} of flight {flight} is not certainly positive",
                    stop + 1,
                    number + 1
                ));
            }
            from = to;
        }
        Ok(())
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

    /// Stable: some power of the map once round has a norm below 1, in the certificate's units.
    /// Unstable: |det| > 1, or det(1 − P) < 0, so that the characteristic polynomial, positive far out, has a
    /// root above 1, or det(1 + P) < 0, so that it has one below −1.
    fn stability(&self, x: &[Interval], go_on: GoOn) -> Result<(), Fault> {
        let claim = self.certificate.claim;
        if claim == Claim::Open {
            return Ok(());
        }
        let map = self.cycle.monodromy(x, go_on)?;
        let n = map.len();
        let holds = if claim == Claim::Stable {
            let units = &self.units[1..=n];
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
        } else {
            let one = linear::identity(n);
            let det = |a: &Matrix| linear::solve(a, &one, true).map(|Solved { determinant, .. }| determinant);
            let minus: Matrix = one.iter().zip(&map).map(|(a, b)| linear::difference(a, b)).collect();
            let plus: Matrix = one.iter().zip(&map).map(|(a, b)| linear::sum(a, b)).collect();
            let below = |x: Option<Interval>| x.is_some_and(|x| (-x).is_positive());
            let beyond = det(&map).is_some_and(|x| (x.squared() - Interval::ONE).is_positive());
            beyond || below(det(&minus)) || below(det(&plus))
        };
        if holds { Ok(()) } else { wrong(format!("the orbit is not certainly {claim}")) }
    }
}
