//! A pattern of impacts: the equations that its orbits solve, when a solution is an orbit, and the
//! multipliers.
//!
//! The unknowns are the phases T₁, …, T_m, then the incoming relative speeds V₁, …, V_m. Impact i + 1 comes
//! 2πN_i + T_{i+1} − T_i after impact i, and impact 1 after the last. There the gap z to the wall met is 0
//! and closes at its speed: z = 0, z′ + V_{i+1} = 0.

use super::{
    Fault, Interval,
    exponential::Ring,
    number::Number,
    oscillator::{Flight, Motion, Oscillator},
    pattern::{apart, follow, least_period, turns},
    text::{Coefficient, Decimal, Impact, Side, System},
};
use crate::rejection::{GoOn, claim};

/// An oscillator and a pattern of impacts.
pub(crate) struct Cycle<'a, N> {
    pub oscillator: Oscillator<N>,
    impacts: &'a [Impact],
}

/// The flight from an impact to the next.
pub(crate) struct Leg<N> {
    pub flight: Flight<N>,
    pub from: Side,
    pub to: Side,
    pub duration: N,
    pub end: N,
}

/// A contact during a flight, where the gap is 0 and so is its derivative.
#[derive(Clone, Copy)]
pub(crate) struct Touch {
    pub side: Side,
    /// How long after the flight's start.
    pub time: Interval,
    /// Its phase.
    pub phase: Interval,
}

impl<'a, N: Number> Cycle<'a, N> {
    /// The system at a value of its parameter, if it has one.
    ///
    /// # Errors
    /// Says what the method cannot do with it.
    pub fn new<C: Coefficient>(
        system: &System<C>,
        impacts: &'a [Impact],
        parameter: N,
    ) -> Result<Self, String> {
        Ok(Cycle { oscillator: Oscillator::new(system, parameter)?, impacts })
    }

    pub fn impacts(&self) -> usize {
        self.impacts.len()
    }

    pub fn ring(&self) -> Ring<N> {
        self.oscillator.ring
    }

    /// The flight from impact i to the next.
    pub fn leg(&self, x: &[N], i: usize) -> Leg<N> {
        let m = self.impacts();
        let (impact, next) = (&self.impacts[i], (i + 1) % m);
        let periods = N::constant(turns(impact.periods));
        Leg {
            flight: self.oscillator.depart(impact.side, x[i], x[m + i]),
            from: impact.side,
            to: self.impacts[next].side,
            // The phases cancel where they are one.
            duration: if m == 1 { periods } else { periods + x[next] - x[i] },
            end: x[next],
        }
    }

    /// A period of the response without impacts, of which the middle is at phase t.
    pub fn free(&self, t: N) -> Leg<N> {
        let half = N::constant(Interval::PI);
        let flight = self.oscillator.steady(t - half);
        // It leaves no wall and meets none: what stands here is not asked for.
        Leg { flight, from: Side::Lower, to: Side::Lower, duration: half + half, end: t + half }
    }

    /// z and z′ + V at the end of each flight.
    pub fn residual(&self, x: &[N], go_on: GoOn) -> Result<Vec<N>, Fault> {
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

    /// z″ just before and just after an impact.
    pub fn bends(&self, i: usize, x: &[N]) -> (N, N) {
        let (side, phase, velocity) = (self.impacts[i].side, x[i], x[self.impacts() + i]);
        let [position, speed, curvature]: Motion<N> = self.oscillator.wall_motion(side, phase);
        let bend = |relative| {
            side.inward(
                self.oscillator.acceleration(position, speed + side.inward(relative), phase) - curvature,
            )
        };
        (bend(-velocity), bend(self.oscillator.restitution(side) * velocity))
    }

    /// Trace and determinant of the linearised map once round. It is a product of flights exp(τA) and of
    /// impacts [[−τ, 0], [−(τ z₋″ + z₊″)/V, −τ]], since an orbit δz farther from the wall meets it δz/V
    /// later. The determinant is that of the factors, Π τ² det exp(tA): near grazing the entries grow like
    /// 1/V, and their products would cancel.
    pub fn multipliers(&self, x: &[N], go_on: GoOn) -> Result<[N; 2], Fault> {
        let (m, ring) = (self.impacts(), self.ring());
        let mut columns = [[N::ONE, N::ZERO], [N::ZERO, N::ONE]];
        let mut determinant = N::ONE;
        for i in 0..m {
            go_on()?;
            let leg = self.leg(x, i);
            let tau = self.oscillator.restitution(leg.from);
            let (before, after) = self.bends(i, x);
            let kick = (tau * before + after).over(x[m + i]);
            let flow = ring.exp(leg.duration);
            determinant = determinant * tau.squared() * ring.determinant(flow);
            columns = columns.map(|[z, w]| ring.apply(flow, [-(tau * z), -(kick * z) - tau * w]));
        }
        let [[a, _], [_, d]] = columns;
        Ok([a + d, determinant])
    }
}

impl Cycle<'_, Interval> {
    /// Whether the solution in the box `x` is an orbit: every speed is positive, it does not repeat itself,
    /// and between impacts every gap is positive, but for a `touch` in the flight with that index. The pieces
    /// of flight i end at the times `ends[i]`.
    ///
    /// # Errors
    /// A false claim, where this is not certain.
    pub fn is_orbit(
        &self,
        x: &[Interval],
        ends: &[Vec<Decimal>],
        touch: Option<(usize, Touch)>,
        go_on: GoOn,
    ) -> Result<(), Fault> {
        for (i, velocity) in x[self.impacts()..2 * self.impacts()].iter().enumerate() {
            let holds = velocity.is_positive();
            claim(holds, format_args!("the speed of impact {} is not certainly positive", i + 1))?;
        }
        let m = self.impacts();
        let known: Vec<_> =
            self.impacts.iter().zip(x).map(|(impact, &phase)| (impact.periods, phase)).collect();
        let same =
            |i: usize, j: usize| self.impacts[i].side == self.impacts[j].side && !apart(x[m + i], x[m + j]);
        least_period(&known, same).map_err(Fault::False)?;
        for (index, ends) in ends.iter().enumerate() {
            let touch = touch.filter(|touch| touch.0 == index).map(|touch| touch.1);
            let leg = match (self.impacts(), touch) {
                (0, Some(touch)) => self.free(touch.phase),
                _ => self.leg(x, index),
            };
            self.admissible(index + 1, &leg, ends, touch, go_on)?;
        }
        Ok(())
    }

    /// Every gap is positive during the flight with this number, piece by piece.
    fn admissible(
        &self,
        flight: usize,
        leg: &Leg<Interval>,
        ends: &[Decimal],
        touch: Option<Touch>,
        go_on: GoOn,
    ) -> Result<(), Fault> {
        if let Some(Touch { time, .. }) = touch
            && !(time.is_positive() && time.is_below(leg.duration))
        {
            return Err(Fault::False(format!("the contact is not certainly during flight {flight}")));
        }
        let impacts = self.impacts() > 0;
        follow(flight, leg.duration, ends, go_on, |from, to, [first, last]| {
            let here = touch.filter(|touch| from.is_below(touch.time) && touch.time.is_below(to));
            let shown = |side| {
                let touched = here.is_some_and(|touch| touch.side == side);
                self.piece(leg, side, from, to, [impacts && first, impacts && last, touched])
            };
            (!self.oscillator.sides().all(shown)).then(|| "the gap".into())
        })
    }

    /// With r half the length and m the middle, z lies in z(m) + z′(m)[−r, r] + z″[0, r²/2] and z′ in z′(m) +
    /// z″[−r, r]. Enough is z > 0; for the wall just left, where z = 0 ≤ z′, on the first piece z′ > 0 or
    /// z″ > 0; for the wall met next, where z = 0 > z′, on the last piece z′ < 0 or z″ > 0 (then z′ < 0
    /// before); for a wall that is touched during the piece, where z = z′ = 0 at one time, z″ > 0.
    fn piece(
        &self,
        leg: &Leg<Interval>,
        side: Side,
        from: Interval,
        to: Interval,
        [first, last, touched]: [bool; 3],
    ) -> bool {
        let whole = from.until(to);
        let middle = whole.middle();
        let away = whole - middle;
        let [gap, slope, _] = self.oscillator.gap(leg.flight, side, middle);
        let [_, _, curvature] = self.oscillator.gap(leg.flight, side, whole);
        let over = slope + curvature * away;
        let gap = gap + slope * away + curvature * away.squared().shifted_down(1);
        gap.is_positive()
            || (first && side == leg.from && (over.is_positive() || curvature.is_positive()))
            || (last && side == leg.to && ((-over).is_positive() || curvature.is_positive()))
            || (touched && curvature.is_positive())
    }
}
