//! What a motion tends to: its stroboscopic section, period, impacts and Lyapunov exponent, and which starts lead there.
//!
//! Found by following the motion, so by its kind not proved: a long transient can look like an attractor, and a period beyond the
//! longest looked for like none.

use super::{
    Contact, Time,
    flow::{Flow, Free, Matrix, State},
    simulate::{End, Event, Simulator},
};
use crate::error::Result;

/// Where and for how long to look.
#[derive(Debug, Clone, PartialEq)]
pub struct Look {
    /// The phase of the section, 0 ≤ phase < 2π.
    pub phase: f64,
    /// Periods that pass before.
    pub transient: u64,
    /// Points of the section, one a period.
    pub points: u32,
    /// The longest period looked for; one is found only if it goes round twice within the points.
    pub longest: u32,
}

/// What a motion came to after the transient.
#[derive(Debug, Clone, PartialEq)]
pub struct Attractor {
    /// The states at the phase, period after period; for a periodic motion once round.
    pub points: Vec<State>,
    /// After how many forcing periods it repeats, if it does.
    pub period: Option<u32>,
    /// Impacts in these points' time; bounces that were summed into a rest are not among them.
    pub impacts: u64,
    /// Rests on a wall in that time.
    pub rests: u64,
    /// The largest Lyapunov exponent, per forcing period; −∞ where a rest on a wall forgets the past.
    pub lyapunov: f64,
    /// Why it ended, if before all points were seen: [`End::Reached`] if not.
    pub end: End,
}

/// Two states nearer than this, in units of 1 + their size, are one.
const NEAR: f64 = 1e-7;

impl Attractor {
    /// Follows the motion from `start`. `every` hears of each period and may end it.
    ///
    /// # Errors
    /// A start behind a wall; what `every` says.
    pub fn of(
        simulator: &Simulator,
        start: State,
        look: &Look,
        mut every: impl FnMut() -> Result<()>,
    ) -> Result<Attractor> {
        let mut run = simulator.start(Time::new(0, start.t), start.q, start.u)?;
        let soonest = i64::from(look.phase < start.t);
        let first = soonest + look.transient as i64;
        for period in soonest..first {
            every()?;
            run.finish(Time::new(period, look.phase));
        }
        let mut end = run.finish(Time::new(first, look.phase));
        let mut tangent = Tangent::new(simulator, run.state());
        let (mut points, mut tally) = (vec![run.state()], vec![(0, 0)]);
        while points.len() < look.points as usize && end == End::Reached {
            every()?;
            let until = Time::new(first + points.len() as i64, look.phase);
            let (mut impacts, mut rests) = (0, 0);
            let mut last = run.time();
            end = loop {
                let event = run.next(until);
                let now = event.time().unwrap_or(run.time());
                tangent.flow(now.since(last));
                last = now;
                match event {
                    Event::End(end) => break end,
                    Event::Impact(impact) => {
                        impacts += 1;
                        tangent.strike(simulator.contacts().find(|contact| contact.side == impact.side));
                    }
                    Event::Stick(_) => {
                        rests += 1;
                        tangent.forget();
                    }
                    Event::Tangency(_) | Event::Release(_) => {}
                }
                tangent.at = run.state();
            };
            tangent.at = run.state();
            tangent.renew();
            points.push(run.state());
            tally.push((impacts, rests));
        }
        let periods = points.len() - 1;
        let lyapunov = tangent.sum / periods.max(1) as f64;
        let period = repeats(&points, look.longest as usize).filter(|_| end == End::Reached);
        let length = period.unwrap_or(periods);
        let (impacts, rests) =
            tally[points.len() - length..].iter().fold((0, 0), |sum, here| (sum.0 + here.0, sum.1 + here.1));
        if let Some(period) = period {
            points.drain(..points.len() - period);
        }
        Ok(Attractor { points, period: period.map(|p| p as u32), impacts, rests, lyapunov, end })
    }

    /// Whether both are the same periodic motion.
    pub fn is(&self, other: &Attractor) -> bool {
        self.period == other.period
            && self.impacts == other.impacts
            && self.points.first().is_some_and(|point| other.goes_through(point))
    }

    /// Whether it is periodic and meets the section near a state: within what may be left of a transient, not within rounding.
    pub fn goes_through(&self, state: &State) -> bool {
        let near = 1e3 * NEAR * (1.0 + state.q.abs() + state.u.abs());
        self.period.is_some() && self.points.iter().any(|point| distance(point, state) < near)
    }
}

/// The shortest shift, up to `longest`, by which the later half of the points, or more, repeats.
fn repeats(points: &[State], longest: usize) -> Option<usize> {
    let n = points.len();
    let same = |a: &State, b: &State| distance(a, b) < NEAR * (1.0 + a.q.abs() + a.u.abs());
    (1..=longest.min(n / 2)).find(|&p| {
        let from = (n / 2).min(n - 2 * p);
        (from..n - p).all(|i| same(&points[i], &points[i + p]))
    })
}

fn distance(a: &State, b: &State) -> f64 {
    (a.q - b.q).abs() + (a.u - b.u).abs()
}

/// A tangent vector carried along a motion.
struct Tangent<'a> {
    flow: &'a Free,
    at: State,
    vector: [f64; 2],
    /// The logarithm of how much it has grown.
    sum: f64,
}

impl<'a> Tangent<'a> {
    fn new(simulator: &'a Simulator, at: State) -> Self {
        Tangent { flow: simulator.flow(), at, vector: [0.6, 0.8], sum: 0.0 }
    }

    fn turn(&mut self, m: &Matrix) {
        let [x, y] = self.vector;
        self.vector = [m[0][0] * x + m[0][1] * y, m[1][0] * x + m[1][1] * y];
    }

    fn flow(&mut self, duration: f64) {
        let (at, matrix) = self.flow.advance_linearised(self.at, duration);
        self.at = at;
        self.turn(&matrix);
    }

    /// Through an impact, at which it stands before the bounce.
    fn strike(&mut self, wall: Option<&Contact>) {
        if let Some(wall) = wall {
            let matrix = wall.saltation(self.flow, self.at);
            self.turn(&matrix);
        }
    }

    fn forget(&mut self) {
        self.vector = [0.0; 2];
    }

    /// Takes the growth to the sum and starts again at length 1.
    fn renew(&mut self) {
        let length = self.vector[0].hypot(self.vector[1]);
        self.sum += length.ln();
        self.vector = if length > 0.0 { self.vector.map(|x| x / length) } else { [0.6, 0.8] };
    }
}
