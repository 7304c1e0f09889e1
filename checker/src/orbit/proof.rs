//! The proof itself: Krawczyk's test on two boxes, the pieces of each flight, Jury's conditions.

use super::{
    Fault, Side,
    fixed::Interval,
    motion::{Flight, Motion, Oscillator},
    text::{Certificate, Claim},
};

/// Asked now and then whether the work should go on.
type GoOn<'a> = &'a mut dyn FnMut() -> Result<(), Fault>;

/// What is being proved, over intervals.
pub(super) struct Proof<'a> {
    certificate: &'a Certificate,
    oscillator: Oscillator,
    centre: Vec<Interval>,
    inverse: Vec<Vec<Interval>>,
}

/// The flight from an impact to the next.
struct Leg {
    flight: Flight,
    from: Side,
    to: Side,
    duration: Interval,
    end: Interval,
}

/// 2πn.
fn turns(n: u64) -> Interval {
    Interval::integer(n) * (Interval::PI + Interval::PI)
}

impl<'a> Proof<'a> {
    /// Encloses what the certificate says.
    ///
    /// # Errors
    /// Says what the method cannot do with it.
    pub fn new(certificate: &'a Certificate) -> Result<Self, String> {
        let impacts = &certificate.impacts;
        let unknowns = impacts.iter().map(|i| i.phase).chain(impacts.iter().map(|i| i.velocity));
        Ok(Proof {
            certificate,
            oscillator: Oscillator::new(&certificate.system)?,
            centre: unknowns.map(|x| x.enclosed()).collect(),
            inverse: certificate
                .inverse
                .iter()
                .map(|row| row.iter().map(|c| c.enclosed()).collect())
                .collect(),
        })
    }

    /// Existence and uniqueness in the box, and then all claims about the orbit.
    pub fn run(&self, go_on: GoOn) -> Result<(), Fault> {
        let [radius, within] = [self.certificate.radius, self.certificate.within].map(|r| r.enclosed());
        if !within.is_positive() || !within.is_up_to(radius) {
            return Err(Fault::False("the smaller radius must be positive and at most the larger".into()));
        }
        self.krawczyk(radius, go_on)?;
        let unknowns = self.krawczyk(within, go_on)?;
        for (i, velocity) in unknowns[self.impacts()..].iter().enumerate() {
            if !velocity.is_positive() {
                return Err(Fault::False(format!("the speed of impact {} is not certainly positive", i + 1)));
            }
        }
        self.least_period(&unknowns).map_err(Fault::False)?;
        for index in 0..self.impacts() {
            self.admissible(index, &self.leg(&unknowns, index), go_on)?;
        }
        self.stability(&unknowns, go_on)
    }

    fn impacts(&self) -> usize {
        self.certificate.impacts.len()
    }

    /// The flight from impact i to the next.
    fn leg(&self, x: &[Interval], i: usize) -> Leg {
        let (m, impacts) = (self.impacts(), &self.certificate.impacts);
        let (impact, next) = (&impacts[i], (i + 1) % m);
        let periods = turns(impact.periods);
        Leg {
            flight: self.oscillator.depart(impact.side, x[i], x[m + i]),
            from: impact.side,
            to: impacts[next].side,
            // The phases cancel where they are one.
            duration: if m == 1 { periods } else { periods + x[next] - x[i] },
            end: x[next],
        }
    }

    /// z and z′ + V at the end of each flight.
    fn residual(&self, x: &[Interval], go_on: GoOn) -> Result<Vec<Interval>, Fault> {
        let m = self.impacts();
        let mut all = Vec::with_capacity(2 * m);
        for i in 0..m {
            go_on()?;
            let leg = self.leg(x, i);
            let [gap, speed, _] = self.oscillator.gap_at(leg.flight, leg.to, leg.duration, leg.end);
            all.extend([gap, speed + x[m + (i + 1) % m]]);
        }
        Ok(all)
    }

    /// Its derivatives. With z seen from the wall that is met next, a later end adds (z′, z″), a later start takes away what a flight makes of
    /// the velocity and acceleration after the impact relative to the wall left behind, and a greater V adds to that velocity.
    fn derivatives(&self, x: &[Interval], go_on: GoOn) -> Result<Vec<Vec<Interval>>, Fault> {
        let (m, ring) = (self.impacts(), self.oscillator.ring);
        let mut rows = vec![vec![Interval::ZERO; 2 * m]; 2 * m];
        for i in 0..m {
            go_on()?;
            let (leg, next) = (self.leg(x, i), (i + 1) % m);
            let [_, speed, bend] = self.oscillator.gap_at(leg.flight, leg.to, leg.duration, leg.end);
            let flow = ring.exp(leg.duration);
            let tau = self.oscillator.restitution(leg.from);
            let (_, after) = self.bends(i, x);
            let start = [-(tau * x[m + i]), -after].map(|x| leg.from.inward(x));
            let by_phase = ring.apply(flow, start).map(|x| leg.to.inward(x));
            let by_speed = ring.apply(flow, [Interval::ZERO, leg.from.inward(tau)]).map(|x| leg.to.inward(x));
            for (row, end) in [speed, bend].into_iter().enumerate() {
                let row_entries = &mut rows[2 * i + row];
                row_entries[next] = row_entries[next] + end;
                row_entries[i] = row_entries[i] + by_phase[row];
                row_entries[m + i] = row_entries[m + i] + by_speed[row];
            }
            rows[2 * i + 1][m + next] = rows[2 * i + 1][m + next] + Interval::ONE;
        }
        Ok(rows)
    }

    /// z″ just before and just after an impact.
    fn bends(&self, i: usize, x: &[Interval]) -> (Interval, Interval) {
        let (side, phase, velocity) = (self.certificate.impacts[i].side, x[i], x[self.impacts() + i]);
        let [position, speed, curvature]: Motion = self.oscillator.wall_motion(side, phase);
        let bend = |relative| {
            side.inward(
                self.oscillator.acceleration(position, speed + side.inward(relative), phase) - curvature,
            )
        };
        (bend(-velocity), bend(self.oscillator.restitution(side) * velocity))
    }

    /// K = y − C f(y) + (I − C f′(X))(X − y) on the box X of `radius` about y. Every solution in X lies in K, and K in the interior of X
    /// proves that there is exactly one.
    fn krawczyk(&self, radius: Interval, go_on: GoOn) -> Result<Vec<Interval>, Fault> {
        let region: Vec<Interval> = self.centre.iter().map(|y| y.widened(radius)).collect();
        let (residual, derivatives) =
            (self.residual(&self.centre, go_on)?, self.derivatives(&region, go_on)?);
        let mut image = Vec::with_capacity(region.len());
        for (i, row) in self.inverse.iter().enumerate() {
            go_on()?;
            let mut value = self.centre[i];
            for (c, f) in row.iter().zip(&residual) {
                value = value - *c * *f;
            }
            for (j, (x, y)) in region.iter().zip(&self.centre).enumerate() {
                let product =
                    row.iter().zip(&derivatives).fold(Interval::ZERO, |sum, (c, d)| sum + *c * d[j]);
                let identity = if i == j { Interval::ONE } else { Interval::ZERO };
                value = value + (identity - product) * (*x - *y);
            }
            image.push(value);
        }
        match image.iter().zip(&self.centre).position(|(k, y)| !k.is_within(radius, *y)) {
            None => Ok(image),
            Some(i) => Err(Fault::False(format!(
                "Krawczyk's test does not map the box into itself in unknown {}",
                i + 1
            ))),
        }
    }

    /// No smaller whole number of periods is one of the orbit. If one were, it would hold d of the m impacts, d a divisor of m, and every impact would come back d impacts
    /// later: on the same wall, with the same speed, d/m of all periods later. For each such d some impact does not.
    fn least_period(&self, x: &[Interval]) -> Result<(), String> {
        let (m, impacts) = (self.impacts(), &self.certificate.impacts);
        let apart = |a: Interval, b: Interval| (a - b).is_positive() || (b - a).is_positive();
        let total: u64 = impacts.iter().map(|impact| impact.periods).sum();
        for d in (1..m).filter(|&d| m.is_multiple_of(d) && (total * d as u64).is_multiple_of(m as u64)) {
            let shift = turns(total * d as u64 / m as u64);
            let comes_back = |i: usize| {
                let j = (i + d) % m;
                let between: u64 = (i..i + d).map(|l| impacts[l % m].periods).sum();
                let later = turns(between) + x[j] - x[i];
                impacts[i].side == impacts[j].side && !apart(later, shift) && !apart(x[m + i], x[m + j])
            };
            if (0..m).all(comes_back) {
                return Err(format!("the orbit may repeat itself after {d} of its {m} impacts"));
            }
        }
        Ok(())
    }

    /// Every gap is positive during the flight, piece by piece.
    fn admissible(&self, index: usize, leg: &Leg, go_on: GoOn) -> Result<(), Fault> {
        let flight = index + 1;
        let wrong = |what: String| Err(Fault::False(what));
        if !leg.duration.is_positive() {
            return wrong(format!("flight {flight} does not certainly last"));
        }
        let ends = &self.certificate.flights[index];
        let last = ends.len() - 1;
        if !leg.duration.is_up_to(ends[last].enclosed()) {
            return wrong(format!("the pieces of flight {flight} stop before its end"));
        }
        let mut from = Interval::ZERO;
        for (number, to) in ends.iter().map(|end| end.enclosed()).enumerate() {
            go_on()?;
            if !(to - from).is_positive() {
                return wrong(format!("the pieces of flight {flight} do not follow one another"));
            }
            for side in self.oscillator.sides() {
                if !self.piece(leg, side, from, to, [number == 0, number == last]) {
                    let number = number + 1;
                    return wrong(format!(
                        "the gap on piece {number} of flight {flight} is not certainly positive"
                    ));
                }
            }
            from = to;
        }
        Ok(())
    }

    /// With r half the length and m the middle, z lies in z(m) + z′(m)[−r, r] + z″[0, r²/2] and z′ in z′(m) + z″[−r, r]. Enough is z > 0; for
    /// the wall just left, where z = 0 ≤ z′, on the first piece z′ > 0 or z″ > 0; for the wall met next, where z = 0, on the last piece z′ < 0.
    fn piece(&self, leg: &Leg, side: Side, from: Interval, to: Interval, [first, last]: [bool; 2]) -> bool {
        let whole = from.until(to);
        let middle = whole.middle();
        let away = whole - middle;
        let [gap, slope, _] = self.oscillator.gap(leg.flight, side, middle);
        let [_, _, curvature] = self.oscillator.gap(leg.flight, side, whole);
        let over = slope + curvature * away;
        let gap = gap + slope * away + curvature * away.squared().shifted_down(1);
        gap.is_positive()
            || (first && side == leg.from && (over.is_positive() || curvature.is_positive()))
            || (last && side == leg.to && (-over).is_positive())
    }

    /// The linearised map once round is a product of flights exp(τA) and of impacts [[−τ, 0], [−(τ z₋″ + z₊″)/V, −τ]], since an orbit δz farther
    /// from the wall meets it δz/V later. With T its trace and D its determinant: stable iff D < 1 and 1 + D ± T > 0, unstable if one is < 0.
    fn stability(&self, x: &[Interval], go_on: GoOn) -> Result<(), Fault> {
        let (m, ring) = (self.impacts(), self.oscillator.ring);
        let mut columns = [[Interval::ONE, Interval::ZERO], [Interval::ZERO, Interval::ONE]];
        for i in 0..m {
            go_on()?;
            let leg = self.leg(x, i);
            let tau = self.oscillator.restitution(leg.from);
            let (before, after) = self.bends(i, x);
            let kick = (tau * before + after).over(x[m + i]);
            let flow = ring.exp(leg.duration);
            columns = columns.map(|[z, w]| ring.apply(flow, [-(tau * z), -(kick * z) - tau * w]));
        }
        let [[a, c], [b, d]] = columns;
        let (trace, determinant) = (a + d, a * d - b * c);
        let sum = Interval::ONE + determinant;
        let conditions = [Interval::ONE - determinant, sum - trace, sum + trace];
        let holds = match self.certificate.claim {
            Claim::Stable => conditions.iter().all(|x| x.is_positive()),
            Claim::Unstable => conditions.iter().any(|&x| (-x).is_positive()),
            Claim::Open => true,
        };
        if holds {
            Ok(())
        } else {
            Err(Fault::False(format!("the orbit is not certainly {}", self.certificate.claim)))
        }
    }
}
