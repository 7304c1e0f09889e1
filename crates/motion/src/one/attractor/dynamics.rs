//! Oscillators of one degree of freedom as this chapter sees them: their motions, and vectors carried by the
//! flow's derivative and by saltation matrices at impacts.

use super::{observe::observe, together::together};
use crate::{
    attractor::{
        cycle::Cycle,
        detection::{Detection, Fate},
        dynamics::{Dynamics, Motion, Range, SectionState, Tangents, orthonormalise},
        observe::{Attraction, Observation, ObservedMotion},
    },
    continuation::Multipliers,
    error::Result,
    monitor::Monitor,
    motion::{
        RunEnd, Side, State, Time,
        algebra::{IDENTITY, apply},
        flow::SHORTEST,
    },
    one::simulate::{Event, Run, Simulator},
};

/// (q, u).
impl SectionState for [f64; 2] {
    fn plane(&self) -> [f64; 2] {
        *self
    }

    fn coordinates(&self) -> &[f64] {
        self
    }
}

impl Motion for Run<'_> {
    type Point = [f64; 2];

    const CHUNK: u64 = 256;

    fn time(&self) -> Time {
        Run::time(self)
    }

    fn impacts(&self) -> u64 {
        Run::impacts(self)
    }

    fn point(&self) -> [f64; 2] {
        let state = self.state();
        [state.q, state.u]
    }

    fn pass(&mut self, until: Time) -> Result<RunEnd> {
        Ok(self.finish(until))
    }

    fn pass_seen(&mut self, until: Time, seen: &mut Range) -> Result<RunEnd> {
        loop {
            let event = self.next(until);
            seen.widen(self.state().q);
            if let Event::End(end) = event {
                return Ok(end);
            }
            seen.meet(event.velocity().map(|velocity| -velocity), self.rate());
        }
    }
}

impl Dynamics for Simulator {
    const TOGETHER: usize = 64;

    /// With the velocity as it is shown.
    type Start = State;
    /// With the velocity per radian.
    type Point = [f64; 2];
    type Motion<'a> = Run<'a>;
    type Tangents<'a> = Carried<'a>;

    fn dimension(&self) -> usize {
        2
    }

    fn begin(&self, start: &State) -> Result<Run<'_>> {
        self.start(Time::new(0, start.t), start.q, start.u / self.rate())
    }

    fn in_plane(&self, [q, u]: [f64; 2], phase: f64) -> State {
        State { t: phase, q, u }
    }

    fn drawn(&self, &[q, u]: &[f64; 2]) -> [f64; 2] {
        [q, u * self.rate()]
    }

    fn at(&self, coordinates: &[f64], phase: f64) -> State {
        State { t: phase, q: coordinates[0], u: coordinates[1] * self.rate() }
    }

    fn along<'a>(&'a self, run: Run<'a>) -> Carried<'a> {
        Carried { frame: IDENTITY.to_vec(), ..Carried::new(self, run, 2) }
    }

    fn multipliers(slope: &[Vec<f64>], determinant: Option<f64>) -> Option<Vec<(f64, f64)>> {
        let [[a, b], [c, d]] = [[slope[0][0], slope[0][1]], [slope[1][0], slope[1][1]]];
        // Neither the flow nor an impact turns an area over.
        let all = Multipliers { trace: a + d, determinant: determinant.unwrap_or(a * d - b * c) };
        [a, b, c, d].iter().all(|x| x.is_finite()).then(|| all.values().to_vec())
    }

    fn field(&self, run: &Run<'_>) -> Option<Vec<f64>> {
        let (flow, state) = (self.flow(), State { t: run.time().phase, ..run.state() });
        let moving =
            [Side::Lower, Side::Upper].map(|side| self.contact(side).map(|wall| wall.position.order()));
        let driven = flow.equation().is_driven() || moving.into_iter().flatten().any(|order| order > 0);
        (!driven).then(|| vec![state.u, flow.equation().acceleration(state)])
    }

    fn here(&self, run: &Run<'_>) -> State {
        self.as_start(State { t: run.time().phase, ..run.state() })
    }

    fn tangents<'a>(&'a self, run: Run<'a>, count: usize) -> Carried<'a> {
        Carried::new(self, run, count)
    }
}

/// Many at once: faster, and the same to the bit.
impl Attraction for Simulator {
    fn fates(
        &self,
        starts: &[State],
        detection: &Detection,
        known: &[Cycle],
        monitor: &dyn Monitor,
    ) -> Result<Vec<Option<Fate>>> {
        together(self, starts, detection, known, monitor)
    }

    fn observe<'a>(
        motions: Vec<(&'a Self, Run<'a>)>,
        observation: &Observation,
        monitor: &dyn Monitor,
    ) -> Result<Vec<ObservedMotion<State, [f64; 2]>>> {
        observe(motions, observation, monitor)
    }
}

/// A motion with one or two vectors that its derivative carries along.
pub struct Carried<'a> {
    simulator: &'a Simulator,
    run: Run<'a>,
    frame: Vec<[f64; 2]>,
    state: State,
    now: Time,
    /// The longest stretch on which the vectors neither vanish in floats nor fall together, if that is the
    /// same everywhere; else no stretch is longer than a step of the flow.
    longest: f64,
}

impl<'a> Carried<'a> {
    fn new(simulator: &'a Simulator, run: Run<'a>, count: usize) -> Carried<'a> {
        // Any direction but, by ill luck, the stable one.
        let frame = [[0.6, 0.8], [-0.8, 0.6]][..count.min(2)].to_vec();
        let (state, now) = (run.state(), run.time());
        let most = if count < 2 { 600.0 } else { 20.0 };
        let equation = simulator.flow().equation();
        let linear = equation.constant_divergence().filter(|_| equation.is_linear());
        let longest = match (linear, equation.smooth.is_some()) {
            (Some(rate), _) => most / rate.abs(),
            // Neighbours of a motion that is not linear part at a rate of their own.
            (None, false) => 1.0,
            (None, true) => f64::INFINITY,
        };
        Carried { simulator, run, frame, state, now, longest }
    }

    /// The vectors on to `then`, and the state there: without impact.
    fn fly(&mut self, then: Time, growth: &mut [f64]) -> State {
        let flow = self.simulator.flow();
        loop {
            let left = then.since(self.now);
            let (state, matrix, gone) = flow.step_linearised(self.state, left.min(self.longest));
            self.frame.iter_mut().for_each(|v| *v = apply(&matrix, *v));
            // Where it cannot be followed the run ends, too.
            if gone >= left || gone.is_nan() || gone <= SHORTEST {
                return state;
            }
            self.now = self.now.after(gone);
            self.state = State { t: self.now.phase, ..state };
            orthonormalise(&mut self.frame, growth, 0.0);
        }
    }
}

impl Tangents for Carried<'_> {
    fn time(&self) -> Time {
        self.now
    }

    fn coordinates(&self) -> Vec<f64> {
        vec![self.state.q, self.state.u]
    }

    fn vectors(&self) -> Vec<Vec<f64>> {
        self.frame.iter().map(|vector| vector.to_vec()).collect()
    }

    fn impacts(&self) -> u64 {
        self.run.impacts()
    }

    fn grow(&mut self, goal: Time, growth: &mut [f64]) -> Result<RunEnd> {
        loop {
            let event = self.run.next(goal);
            let arrival = self.fly(event.time().unwrap_or(self.run.time()), growth);
            match event {
                Event::Impact(impact) => {
                    let contact = self.simulator.contact(impact.place).expect("a wall that was met");
                    let matrix = contact.saltation(self.simulator.flow(), arrival);
                    self.frame.iter_mut().for_each(|v| *v = apply(&matrix, *v));
                }
                Event::Stick(_) | Event::Release(_) => self.frame.fill([0.0; 2]),
                Event::Tangency(_)
                | Event::Touch(_)
                | Event::Reversal(_)
                | Event::Kink(_)
                | Event::End(_) => {}
            }
            orthonormalise(&mut self.frame, growth, 0.0);
            (self.state, self.now) = (self.run.state(), self.run.time());
            if let Event::End(end) = event {
                return Ok(end);
            }
        }
    }
}
