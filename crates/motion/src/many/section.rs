//! Machines as the chapter on attractors follows them (`attractor`): sections seen in a plane,
//! starts, and one measure of how far apart two states are.
//!
//! States are told apart by the whole state, in coordinates in which the mass is 1, x = Lᵀq with M = L Lᵀ,
//! and velocities are per radian of the forcing: displacements and velocities of all parts have one unit
//! there. How close states are is measured by the motions themselves, whatever units a scene is in and
//! wherever stops are that no motion meets. States that differ by a drift alone are one: the one whose q has
//! no part along it.

use serde::{Deserialize, Serialize};

use super::{
    Machine, RealMatrix, RealVector, State,
    algebra::eigenvalues,
    contact::Watch,
    drift::Drifts,
    simulate::{Carried, Run, Simulator},
};
use crate::{
    attractor::{
        dynamics::{Dynamics, Motion, Range, SectionState},
        observe::Attraction,
    },
    error::{Error, Result},
    motion::{Event, RunEnd, Series, Time},
};

/// What of a machine's state is drawn on an axis.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub enum PlaneAxis {
    /// The displacement of this coordinate, from 0.
    Place(usize),
    /// Its velocity, per unit of time.
    Speed(usize),
    /// The gap of this stop, from 0.
    Gap(usize),
    /// The gap's rate, per unit of time.
    Rate(usize),
}

impl PlaneAxis {
    /// The axis as a functional of the state.
    ///
    /// # Errors
    /// A coordinate or a stop that the machine does not have; those of [`Machine::contacts`].
    fn watch(&self, machine: &Machine<f64>) -> Result<Watch> {
        let zero = || RealVector::zeros(machine.size);
        let missing = |what: &str, i: usize| Error::input(format!("the machine has no {what} {}", i + 1));
        match *self {
            PlaneAxis::Place(i) | PlaneAxis::Speed(i) => {
                if i >= machine.points() {
                    return Err(missing("coordinate", i));
                }
                let mut unit = vec![0.0; machine.points()];
                unit[i] = 1.0;
                let row = machine.vector("plane", &unit)?;
                let given = Series::ZERO;
                Ok(match self {
                    PlaneAxis::Place(_) => Watch { places: row, rates: zero(), given },
                    _ => Watch { places: zero(), rates: row * machine.rate(), given },
                })
            }
            PlaneAxis::Gap(j) | PlaneAxis::Rate(j) => {
                let contacts = machine.contacts()?;
                let contact = contacts.get(j).ok_or_else(|| missing("stop", j))?;
                let (row, place) = (contact.row.clone(), &contact.position);
                Ok(match self {
                    PlaneAxis::Gap(_) => {
                        Watch { places: row, rates: zero(), given: Series::combination(&[(-1.0, place)]) }
                    }
                    _ => {
                        let rate = machine.rate();
                        let given = Series::combination(&[(-rate, &place.derivative())]);
                        Watch { places: zero(), rates: row * rate, given }
                    }
                })
            }
        }
    }
}

/// A state on a section.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// In the plane, in the scene's units.
    pub at: [f64; 2],
    /// The whole state: Lᵀq, without what is along drifts, and Lᵀq′.
    pub whole: Vec<f64>,
}

impl SectionState for Point {
    fn plane(&self) -> [f64; 2] {
        self.at
    }

    fn coordinates(&self) -> &[f64] {
        &self.whole
    }
}

/// A state to start from: phase, displacements of the machine's own coordinates, velocities per unit of time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Start {
    /// The phase, in [0, 2π).
    pub t: f64,
    /// Displacements.
    pub q: Vec<f64>,
    /// Velocities, per unit of time.
    pub u: Vec<f64>,
}

impl State {
    /// The state as a start, `rate` being radians of the forcing in a unit of time.
    pub fn start(&self, rate: f64) -> Start {
        let u = self.u.iter().map(|u| u * rate).collect();
        Start { t: self.t, q: self.q.as_slice().to_vec(), u }
    }
}

/// A machine whose sections are seen in a plane.
#[derive(Debug)]
pub struct PlanarMachine {
    simulator: Simulator,
    plane: [Watch; 2],
    driven: bool,
    /// Starts in the plane: what they have besides, and what one more of each of the two numbers adds.
    base: [Vec<f64>; 2],
    directions: [[Vec<f64>; 2]; 2],
}

impl PlanarMachine {
    /// The machine, which `simulator` simulates, with what is drawn of it.
    ///
    /// # Errors
    /// A coordinate or a stop that the machine does not have.
    pub fn new(machine: &Machine<f64>, simulator: Simulator, axes: &[PlaneAxis; 2]) -> Result<PlanarMachine> {
        let plane = [axes[0].watch(machine)?, axes[1].watch(machine)?];
        let none = || vec![0.0; machine.size];
        let directions = [[none(), none()], [none(), none()]];
        let driven = machine.is_driven();
        Ok(PlanarMachine { simulator, plane, driven, base: [none(), none()], directions })
    }

    /// The same, starts in the plane having displacements q and velocities u, of the coordinates of the scene
    /// and per unit of time, but for those of the axes.
    ///
    /// # Errors
    /// An axis that is a gap or its rate; points that do not tell the amplitudes of all modes; lists of
    /// another length.
    pub fn starting(
        self,
        machine: &Machine<f64>,
        axes: &[PlaneAxis; 2],
        [q, u]: [&[f64]; 2],
    ) -> Result<PlanarMachine> {
        let points = machine.points();
        if q.len() != points || u.len() != points {
            return Err(Error::input(format!("a start has {points} displacements and velocities")));
        }
        let mut base = [RealVector::from_column_slice(q), RealVector::from_column_slice(u)];
        let mut directions = self.directions.clone();
        for (axis, direction) in axes.iter().zip(&mut directions) {
            let (part, i) = match *axis {
                PlaneAxis::Place(i) => (0, i),
                PlaneAxis::Speed(i) => (1, i),
                _ => {
                    let message = "starts are given by displacements and velocities, not by gaps";
                    return Err(Error::input(message));
                }
            };
            base[part][i] = 0.0;
            let mut unit = RealVector::zeros(points);
            unit[i] = 1.0;
            direction[part] = machine.coordinates(&unit)?.as_slice().to_vec();
        }
        let own = |given: &RealVector| Ok::<_, Error>(machine.coordinates(given)?.as_slice().to_vec());
        Ok(PlanarMachine { base: [own(&base[0])?, own(&base[1])?], directions, ..self })
    }

    /// What simulates it.
    pub fn simulator(&self) -> &Simulator {
        &self.simulator
    }

    /// The state with these coordinates, those of a [`Point`], at a phase.
    pub(crate) fn state(&self, whole: &[f64], phase: f64) -> State {
        let lifted = self.simulator.drifts().map(|drifts| drifts.lifted(whole));
        let whole = lifted.as_deref().unwrap_or(whole);
        let (upper, n) = (self.simulator.equations().root().transpose(), whole.len() / 2);
        let part = |x: &[f64]| {
            let x = RealVector::from_column_slice(x);
            upper.solve_upper_triangular(&x).unwrap_or(x)
        };
        State { t: phase, q: part(&whole[..n]), u: part(&whole[n..]) }
    }

    /// A state as the section sees it; t is its phase.
    pub fn point(&self, state: &State) -> Point {
        let upper = self.simulator.equations().root().transpose();
        let drifts = self.simulator.drifts();
        let unmoved = drifts.map(|drifts| State { q: &state.q - drifts.part(&state.q), ..state.clone() });
        let state = unmoved.as_ref().unwrap_or(state);
        let (q, u) = (&upper * &state.q, &upper * &state.u);
        let whole: Vec<f64> = q.iter().chain(u.iter()).copied().collect();
        let whole = drifts.map_or(whole.clone(), |drifts| drifts.reduced(&whole));
        let axis = |watch: &Watch| {
            watch.places.dot(&state.q) + watch.rates.dot(&state.u) + watch.given.at(state.t)[0]
        };
        Point { at: [axis(&self.plane[0]), axis(&self.plane[1])], whole }
    }
}

/// A motion of a machine whose sections are seen in a plane.
pub struct PlanarRun<'a> {
    machine: &'a PlanarMachine,
    run: Run<'a>,
}

impl Motion for PlanarRun<'_> {
    type Point = Point;

    const CHUNK: u64 = 1;

    fn time(&self) -> Time {
        self.run.time()
    }

    fn impacts(&self) -> u64 {
        self.run.impacts()
    }

    fn point(&self) -> Point {
        self.machine.point(&State { t: self.run.time().phase, ..self.run.state() })
    }

    fn pass(&mut self, until: Time) -> Result<RunEnd> {
        let end = self.run.finish(until);
        self.run.failure().map_or(Ok(end), Err)
    }

    fn pass_seen(&mut self, until: Time, seen: &mut Range) -> Result<RunEnd> {
        let rate = self.machine.simulator.rate();
        loop {
            let event = self.run.next(until);
            seen.widen(self.point().at[0]);
            if let Event::End(end) = event {
                return self.run.failure().map_or(Ok(end), Err);
            }
            seen.meet(event.velocity().map(|velocity| -velocity), rate);
        }
    }
}

impl Dynamics for PlanarMachine {
    type Start = Start;
    type Point = Point;
    type Motion<'a> = PlanarRun<'a>;
    type Tangents<'a> = Carried<'a>;

    fn dimension(&self) -> usize {
        2 * self.simulator.equations().size() - self.simulator.drifts().map_or(0, Drifts::count)
    }

    fn begin(&self, start: &Start) -> Result<PlanarRun<'_>> {
        let rate = self.simulator.rate();
        let u: Vec<f64> = start.u.iter().map(|u| u / rate).collect();
        let run = self.simulator.start(Time::new(0, start.t), &start.q, &u)?;
        Ok(PlanarRun { machine: self, run })
    }

    fn in_plane(&self, at: [f64; 2], phase: f64) -> Start {
        let part = |part: usize| -> Vec<f64> {
            let [first, second] = [&self.directions[0][part], &self.directions[1][part]];
            let all = self.base[part].iter().zip(first.iter().zip(second));
            all.map(|(base, (first, second))| base + at[0] * first + at[1] * second).collect()
        };
        Start { t: phase, q: part(0), u: part(1) }
    }

    fn at(&self, coordinates: &[f64], phase: f64) -> Start {
        self.state(coordinates, phase).start(self.simulator.rate())
    }

    fn along<'a>(&'a self, motion: PlanarRun<'a>) -> Carried<'a> {
        Carried::along(motion.run)
    }

    fn multipliers(slope: &[Vec<f64>], determinant: Option<f64>) -> Option<Vec<(f64, f64)>> {
        let matrix = RealMatrix::from_fn(slope.len(), slope.len(), |i, j| slope[i][j]);
        // Used where there are two multipliers; then neither the flow nor an impact turns an area over.
        let determinant = determinant.unwrap_or_else(|| matrix.determinant());
        let finite = matrix.iter().all(|x| x.is_finite());
        if finite { eigenvalues(&matrix, determinant).ok() } else { None }
    }

    fn field(&self, motion: &PlanarRun<'_>) -> Option<Vec<f64>> {
        if self.driven {
            return None;
        }
        let (run, lower) = (&motion.run, self.simulator.equations().root());
        let state = State { t: run.time().phase, ..run.state() };
        let bend: RealVector = lower.tr_mul(&run.stage().acceleration(run.time(), &state));
        let rate: RealVector = lower.tr_mul(&state.u);
        let whole: Vec<f64> = rate.iter().chain(bend.iter()).copied().collect();
        Some(self.simulator.drifts().map_or(whole.clone(), |drifts| drifts.reduced(&whole)))
    }

    fn drift(&self, start: &Start, radians: f64) -> Result<Vec<f64>> {
        let Some(drifts) = self.simulator.drifts() else { return Ok(Vec::new()) };
        let mut motion = self.begin(start)?;
        let before = motion.run.state().q;
        let reached = motion.pass(Time::new(0, start.t).after(radians))? == RunEnd::Reached;
        let moved = drifts.seen(&(motion.run.state().q - before));
        Ok(if reached { moved.as_slice().to_vec() } else { Vec::new() })
    }

    fn here(&self, motion: &PlanarRun<'_>) -> Start {
        State { t: motion.run.time().phase, ..motion.run.state() }.start(self.simulator.rate())
    }

    fn tangents<'a>(&'a self, motion: PlanarRun<'a>, count: usize) -> Carried<'a> {
        Carried::new(motion.run, count)
    }
}

impl Attraction for PlanarMachine {}
