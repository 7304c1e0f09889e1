//! A motion with vectors that its derivative carries along: what Lyapunov exponents of machines rest on.
//!
//! In flight, and at rest on stops, vectors move by the homogeneous flow; where forces are formulas, by the
//! derivative of the flow along the motion. At an impact with incoming speed V
//! they take part in Newton's law, and a motion beside this one is hit later by δt = w·δq/V:
//!
//!   δq⁺ = δq + (q′⁻ − q′⁺) δt,  δq′⁺ = δq′ + (q″⁻ − q″⁺) δt + M⁻¹Wᵀ δΛ,
//!
//! δΛ being the change of the impulses with the rates of the gaps there. Where the machine comes to rest on
//! stops, what is not motion along them is gone. Rest ends without a jump: q″ is continuous there. So does
//! contact with a soft stop; where it begins at speed V, q″ jumps by cV M⁻¹wᵀ, c being the stop's damping,
//! and δq′⁺ = δq′ − c (w·δq) M⁻¹wᵀ, however small V is. Where friction changes, since what g(t, q, q′) tells
//! has fallen to 0, a motion beside this one comes there later by δt = −δg/g′, and δq′⁺ = δq′ + (q″⁻ − q″⁺)
//! δt: where it sticks from then on, what is left has no velocity there. A vector of several stops hit at one
//! instant by chance is that of the order in which the law takes them.
//!
//! Vectors are in coordinates in which the mass is 1, (Lᵀδq, Lᵀδq′); what of δq is along a drift
//! stays as it is, tells of nothing else, and is left out.

use std::sync::Arc;

use super::{Event, Simulator, holds::What, stage::Stage};
use crate::{
    attractor::dynamics::{Tangents, orthonormalise},
    error::Result,
    many::{Blow, Grip, RealVector, State, algebra::stacked, drift::Drifts, simulate::engine::Run},
    motion::{
        RunEnd, Time,
        event::{Impact, Touch},
        flow::SHORTEST,
    },
    random::Random,
};

/// What two motions differ by: (δq, δq′).
type Variation = (RealVector, RealVector);

/// A motion with vectors.
pub struct Carried<'a> {
    run: Run<'a>,
    simulator: &'a Simulator,
    stage: Arc<Stage>,
    state: State,
    now: Time,
    frame: Vec<Vec<f64>>,
    /// The longest stretch on which vectors neither vanish in floats nor fall together.
    longest: f64,
    /// Whether vectors are made orthonormal: then as many as the rank are left where rank is lost.
    ordered: bool,
}

/// What is left of a vector beside others after a longer stretch is rounding.
const FLOOR: f64 = 1e-14;

impl<'a> Carried<'a> {
    /// The motion with `count` vectors, at least 1 and at most twice the number of coordinates.
    pub(crate) fn new(run: Run<'a>, count: usize) -> Carried<'a> {
        let simulator = run.simulator();
        let n = simulator.equations().size();
        let (stage, state, now) = (run.stage(), run.state(), run.time());
        let (frame, longest) = (first(n, count), f64::INFINITY);
        let mut all = Carried { run, simulator, stage, state, now, frame, longest, ordered: true };
        all.orthonormalise(&mut vec![0.0; count], 0.0);
        all.bound();
        all.project();
        all
    }

    /// The motion with a unit vector along each coordinate, in which the mass is 1, drifts left out.
    pub(crate) fn along(run: Run<'a>) -> Carried<'a> {
        let simulator = run.simulator();
        let drifts = simulator.drifts();
        let n = 2 * simulator.equations().size() - drifts.map_or(0, Drifts::count);
        let (stage, state, now) = (run.stage(), run.state(), run.time());
        let unit = |i: usize| (0..n).map(|j| f64::from(u8::from(i == j))).collect::<Vec<f64>>();
        let whole = |unit: Vec<f64>| drifts.map_or(unit.clone(), |drifts| drifts.lifted(&unit));
        let frame = (0..n).map(|i| whole(unit(i))).collect();
        let longest = f64::INFINITY;
        let mut all = Carried { run, simulator, stage, state, now, frame, longest, ordered: false };
        all.bound();
        all.project();
        all
    }

    /// The vectors made orthonormal, beside drifts.
    fn orthonormalise(&mut self, growth: &mut [f64], floor: f64) {
        if let Some(drifts) = self.simulator.drifts() {
            self.frame.iter_mut().for_each(|vector| *vector = drifts.lifted(&drifts.reduced(vector)));
        }
        orthonormalise(&mut self.frame, growth, floor);
    }

    /// What is left beside drifts.
    fn left(&self, whole: Vec<f64>) -> Vec<f64> {
        self.simulator.drifts().map_or(whole.clone(), |drifts| drifts.reduced(&whole))
    }

    /// The vector of (δq, δq′).
    fn close(&self, q: &RealVector, u: &RealVector) -> Vec<f64> {
        let lower = self.simulator.equations().root();
        let (q, u): (RealVector, RealVector) = (lower.tr_mul(q), lower.tr_mul(u));
        q.iter().chain(u.iter()).copied().collect()
    }

    /// What a map of (δq, δq′) makes of all vectors.
    fn mapped(&mut self, map: impl Fn(RealVector, RealVector) -> (RealVector, RealVector)) {
        self.mapped_together(|all| all.into_iter().map(|(q, u)| map(q, u)).collect());
    }

    /// What a map of all (δq, δq′) together makes of the vectors.
    fn mapped_together(&mut self, map: impl FnOnce(Vec<Variation>) -> Vec<Variation>) {
        // What has vanished does not come back.
        let left = |i: &usize| self.frame[*i].iter().any(|x| *x != 0.0);
        let left: Vec<usize> = (0..self.frame.len()).filter(left).collect();
        let upper = self.simulator.equations().root().transpose();
        let part = |x: &[f64]| {
            let x = RealVector::from_column_slice(x);
            upper.solve_upper_triangular(&x).unwrap_or(x)
        };
        let open = |i: &usize| {
            let (q, u) = self.frame[*i].split_at(self.frame[*i].len() / 2);
            (part(q), part(u))
        };
        let all = map(left.iter().map(open).collect());
        for (i, (q, u)) in left.into_iter().zip(all) {
            self.frame[i] = self.close(&q, &u);
        }
    }

    /// Vectors and state on by `longest` or less, without events; how far.
    fn advance(&mut self, longest: f64) -> f64 {
        let stage = self.stage.clone();
        let state = State { t: self.now.phase, ..self.state.clone() };
        let gone = match &stage.smooth {
            None => {
                self.mapped_together(|all| stage.carried(&all, longest));
                longest
            }
            // How fast motions decay is not known beforehand; over a step of the flow they cannot by much.
            Some(smooth) => {
                let (phi, gone) = smooth.step_transition(self.now, &state, longest);
                let n = state.q.len();
                self.mapped(|q, u| {
                    let x = &phi * stacked(&q, &u);
                    (x.rows(0, n).into_owned(), x.rows(n, n).into_owned())
                });
                gone
            }
        };
        (self.state, self.now) = (stage.after(self.now, &state, gone), self.now.after(gone));
        self.state.t = self.now.phase;
        gone
    }

    fn fly(&mut self, then: Time, growth: &mut [f64]) {
        loop {
            let left = then.since(self.now);
            let gone = self.advance(left.min(self.longest));
            // Where it cannot be followed the run ends, too.
            let shortest = self.stage.smooth.as_ref().map_or(SHORTEST, |smooth| smooth.flow.shortest());
            if gone >= left || gone.is_nan() || gone <= shortest {
                return;
            }
            self.orthonormalise(growth, FLOOR);
        }
    }

    /// The impacts at one instant, of which these were told; the state before is known, that after is the
    /// run's.
    fn saltation(&mut self, hits: &[Impact<usize>], before: &[usize]) -> Result<()> {
        let contacts = self.simulator.contacts();
        let (arrival, after, stage) = (self.state.clone(), self.run.state(), self.run.stage());
        // A stop that is touched as its gap opens takes part, and is not told of.
        let told = |stop: &usize| before.contains(stop) || hits.iter().any(|hit| hit.place == *stop);
        let opening = self.simulator.touched(&arrival).into_iter().filter(|stop| !told(stop));
        let opening = opening.map(|stop| (stop, contacts.all()[stop].gap(&arrival)[1]));
        let hit = hits.iter().map(|hit| (hit.place, hit.velocity)).chain(opening);
        let (all, rates): (Vec<usize>, Vec<f64>) = hit.chain(before.iter().map(|&j| (j, 0.0))).unzip();
        let sliding = self.simulator.sliding(&arrival);
        let blow = Blow { stops: &all, rates: &rates, sliding: &sliding, grips: &self.stage.holds.grips };
        let law = contacts.struck(&blow)?;
        let acting: Vec<usize> = (0..all.len()).filter(|&i| law.impulses[i] > 0.0).collect();
        let first = acting.iter().copied().min_by(|&a, &b| rates[a].total_cmp(&rates[b]));
        let Some(first) = first.filter(|&i| rates[i] < 0.0) else { return Ok(()) };
        let mut stops: Vec<usize> = acting.iter().map(|&i| all[i]).collect();
        // What sticks at the impact has no velocity after it.
        let stuck = contacts.rubbing(&stops).into_iter().filter(|&j| law.grips[j] == Grip::Stuck);
        let stuck: Vec<usize> = stuck.map(|j| contacts.rub_row(j)).collect();
        stops.extend(&stuck);
        let inner = contacts.among_along(&stops, &stops, &law.grips).lu();
        let now = Time::new(0, arrival.t);
        let (bend, bent) = (self.stage.acceleration(now, &arrival), stage.acceleration(now, &after));
        let (row, speed) = (contacts.all()[all[first]].row.clone(), -rates[first]);
        let rows: Vec<RealVector> = stops.iter().map(|&row| contacts.held_row(row).0.clone()).collect();
        let bends: Vec<f64> = stops.iter().map(|&row| contacts.felt_along(row, &bend, arrival.t)).collect();
        let factor = |&i: &usize| {
            if rates[i] < 0.0 { 1.0 + contacts.all()[all[i]].restitution_slope(-rates[i]) } else { 1.0 }
        };
        let factors: Vec<f64> = acting.iter().map(factor).chain(stuck.iter().map(|_| 1.0)).collect();
        let jump = &arrival.u - &after.u;
        let turn = bend - bent;
        self.mapped(|q, u| {
            let delay = row.dot(&q) / speed;
            let change =
                RealVector::from_fn(rows.len(), |i, _| -factors[i] * (rows[i].dot(&u) + bends[i] * delay));
            let impulses = inner.solve(&change).unwrap_or_else(|| RealVector::zeros(rows.len()));
            let u = u + &turn * delay + contacts.change_along(&stops, impulses.as_slice(), &law.grips);
            (q + &jump * delay, u)
        });
        Ok(())
    }

    /// Contact with a soft stop begins: the force jumps.
    fn touched(&mut self, touch: &Touch<usize>) {
        if touch.jump <= 0.0 {
            return;
        }
        let contacts = self.simulator.contacts();
        let row = &contacts.all()[touch.place].row;
        // By how much faster q″ turns, over the speed.
        let kick = if contacts.rubs().is_empty() {
            contacts.push(touch.place) * (touch.jump / -touch.velocity)
        } else {
            // What sticks may hold some of it, or let go.
            let (arrival, now) = (State { t: self.now.phase, ..self.state.clone() }, self.now);
            let bent = self.run.stage().acceleration(now, &arrival);
            (bent - self.stage.acceleration(now, &arrival)) / -touch.velocity
        };
        self.mapped(|q, u| {
            let u = u - &kick * row.dot(&q);
            (q, u)
        });
    }

    /// What the stage so far watched of friction has fallen to 0, and the motion goes on in another stage.
    fn rubbed(&mut self, what: What, stage: &Arc<Stage>) -> Result<()> {
        let (arrival, now) = (State { t: self.now.phase, ..self.state.clone() }, self.now);
        let (by_state, by_time) = self.stage.slopes(self.simulator.contacts(), what, &arrival)?;
        let bend = self.stage.acceleration(now, &arrival);
        let turn = &bend - stage.acceleration(now, &arrival);
        let rate = by_state.dot(&stacked(&arrival.u, &bend)) + by_time;
        // Where it goes on as before, it does not matter when; else it falls, or it would not have come to 0.
        // A switch may have turned unseen since, where it did not matter.
        let falls = rate < 0.0 || matches!(what, What::Kink(_)) && rate > 0.0;
        if turn.amax() > 0.0 && falls {
            self.mapped(|q, u| {
                let delay = -by_state.dot(&stacked(&q, &u)) / rate;
                (q, u + &turn * delay)
            });
        }
        Ok(())
    }

    /// The longest stretch on which vectors neither vanish in floats nor fall together; no bound where forces
    /// are formulas.
    fn bound(&mut self) {
        if self.stage.smooth.is_some() {
            self.longest = f64::INFINITY;
            return;
        }
        let count = self.frame.len();
        let decays = self.stage.flow.decays();
        let (most, slowest) = if count < 2 { (600.0, decays.first()) } else { (20.0, decays.get(count - 1)) };
        self.longest = slowest.filter(|decay| **decay > 0.0).map_or(f64::INFINITY, |decay| most / decay);
    }

    /// Of vectors only what moves along the stops that are rested on.
    fn project(&mut self) {
        if self.stage.outward().is_none() {
            return;
        }
        let stage = self.stage.clone();
        self.mapped_together(|all| stage.carried(&all, 0.0));
        if self.ordered {
            let rank = stage.rank().min(self.frame.len());
            self.frame[rank..].iter_mut().for_each(|vector| vector.fill(0.0));
        }
    }
}

impl Tangents for Carried<'_> {
    fn time(&self) -> Time {
        self.now
    }

    fn coordinates(&self) -> Vec<f64> {
        self.left(self.close(&self.state.q, &self.state.u))
    }

    fn vectors(&self) -> Vec<Vec<f64>> {
        self.frame.iter().map(|vector| self.left(vector.clone())).collect()
    }

    fn impacts(&self) -> u64 {
        self.run.impacts()
    }

    fn grow(&mut self, goal: Time, growth: &mut [f64]) -> Result<RunEnd> {
        loop {
            let event = self.run.next(goal);
            if let Some(error) = self.run.failure() {
                return Err(error);
            }
            // A rest is told when its bounces end; the run rests from where they are left out.
            self.fly(self.run.time(), growth);
            if let Event::Impact(hit) = event {
                let mut hits = vec![hit];
                hits.extend(self.run.others_at(hit.time));
                let resting = self.stage.holds.resting.clone();
                self.saltation(&hits, &resting)?;
            }
            if let Event::Touch(touch) = &event {
                self.touched(touch);
            }
            let stage = self.run.stage();
            if let Some(what) = self.run.rubbed() {
                self.rubbed(what, &stage)?;
            }
            (self.state, self.now) = (self.run.state(), self.run.time());
            if !Arc::ptr_eq(&stage, &self.stage) {
                let soft = stage.holds.soft != self.stage.holds.soft;
                self.stage = stage;
                if soft {
                    self.bound();
                }
                self.project();
            }
            self.orthonormalise(growth, FLOOR);
            if let Event::End(end) = event {
                return Ok(end);
            }
        }
    }
}

/// Vectors in no special direction; the first, for one coordinate, as for an oscillator.
fn first(n: usize, count: usize) -> Vec<Vec<f64>> {
    let mut random = Random::of_unit(1, 0);
    let mut part = || 1.0 + random.bits() as f64 / u64::MAX as f64;
    let mut frame = Vec::with_capacity(count);
    for k in 0..count.min(2 * n) {
        let sign = |i: usize| if k > 0 && (i + k) % 2 == 1 { -1.0 } else { 1.0 };
        let weights: Vec<f64> =
            (0..2 * n).map(|i| if n == 1 && k == 0 { 1.0 } else { part() * sign(i) }).collect();
        let scaled = |(i, x): (usize, &f64)| x * if i < n { 0.6 } else { 0.8 };
        frame.push(weights.iter().enumerate().map(scaled).collect());
    }
    frame
}

impl Stage {
    /// Each (δq, δq′) after a duration of motion in this stage; of (δq, δq′) only what the stage allows.
    pub(crate) fn carried(&self, all: &[Variation], duration: f64) -> Vec<Variation> {
        let inward = |(q, u): &Variation| {
            let (q, u) = self.lowered_vector(q, u);
            self.flow.inward(&q, &u)
        };
        let mut all: Vec<RealVector> = all.iter().map(inward).collect();
        if duration != 0.0 {
            self.flow.advance_all(&mut all, duration);
        }
        let outward = |y: &RealVector| {
            let x = self.flow.outward(y);
            let n = x.len() / 2;
            let (q, u) = (x.rows(0, n), x.rows(n, n));
            match self.outward() {
                None => (q.into_owned(), u.into_owned()),
                Some(free) => (free * q, free * u),
            }
        };
        all.iter().map(outward).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::{
        formula::{Formula, Operation, kink},
        many::{
            Friction, Load, Machine, NormalForce, Stop, StopLaw,
            simulate::Settings,
            smooth::{joined, number},
        },
        motion::{SmoothForce, Wall},
    };

    /// Two coupled masses on a rough row, with a stop that gives way; numbers from a seed.
    fn rough(random: &mut Random) -> Machine<f64> {
        let mut between = |low: f64, high: f64| low + (high - low) * (random.bits() as f64 / u64::MAX as f64);
        let coupled = between(-0.5, 0.5);
        let all = |a: f64, b: f64, c: f64| vec![(0, 0, a), (0, 1, b), (1, 0, b), (1, 1, c)];
        let (sliding, more) = (between(0.3, 1.6), between(1.0, 1.4));
        Machine {
            size: 2,
            period: TAU,
            mass: all(1.0, coupled, 0.7),
            damping: all(0.2, -0.02, 0.25),
            damping_ratio: vec![],
            stiffness: all(4.0, -1.5, 2.2),
            shapes: vec![],
            force: vec![],
            forcing: vec![Load {
                k: 1,
                cos: vec![between(0.2, 1.5), between(0.5, 1.5)],
                sin: vec![0.2, between(-0.5, 0.5)],
            }],
            smooth: vec![],
            record: None,
            stops: vec![Stop {
                name: "pad".into(),
                row: vec![0.0, 1.0],
                wall: Wall { offset: -between(0.1, 0.5), harmonics: vec![], restitution: 0.0 },
                law: StopLaw::Soft { stiffness: 12.0, damping: 1.5 },
            }],
            friction: vec![Friction {
                name: "ground".into(),
                row: vec![1.0, 0.0],
                normal: NormalForce::Given(1.0),
                coefficient: sliding,
                law: None,
                static_coefficient: sliding * more,
                speed: between(-0.2, 0.2),
                harmonics: vec![],
            }],
        }
    }

    /// The same pair where a floor and a pad rub, both under their own forces.
    fn leaning(random: &mut Random, rests: bool) -> Machine<f64> {
        let mut machine = rough(random);
        let mut between = |low: f64, high: f64| low + (high - low) * (random.bits() as f64 / u64::MAX as f64);
        machine.force = vec![between(-0.3, 0.3), -between(0.5, 1.5)];
        let restitution = if rests { 0.0 } else { between(0.6, 0.9) };
        let wall = Wall { offset: -0.3, harmonics: vec![], restitution };
        machine.stops[0].row = vec![1.0, 0.2];
        machine.stops.push(Stop { name: "floor".into(), row: vec![0.0, 1.0], wall, law: StopLaw::Newton });
        let own = machine.friction[0].clone();
        let tied = |name: &str, stop: usize, row: [f64; 2], coefficient: f64| Friction {
            name: name.into(),
            row: row.to_vec(),
            normal: NormalForce::Stop { stop },
            coefficient,
            static_coefficient: 1.2 * coefficient,
            ..own.clone()
        };
        machine.friction = vec![
            tied("floor", 1, [1.0, 0.0], between(0.05, 0.6)),
            tied("pad", 0, [0.1, 1.0], between(0.05, 0.3)),
        ];
        machine
    }

    /// How many numbers of a vector that is carried agree with differences of motions.
    fn compared(machine: &Machine<f64>, trial: u32) -> usize {
        let mut compared = 0;
        let simulator = Simulator::new(machine, &Settings::default()).unwrap();
        let begin = Time::new(0, 0.0);
        let (q, u) = ([0.1, 0.05], [0.0, 0.2]);
        let run = || simulator.start(begin, &q, &u).unwrap();
        let (mut carried, beside) = (Carried::new(run(), 1), Carried::new(run(), 1));
        let (dq, du) = carried.open(&carried.frame[0]);
        let after = |h: f64, goal: Time| {
            let moved = |x: &[f64], d: &RealVector| [x[0] + h * d[0], x[1] + h * d[1]];
            let mut run = simulator.start(begin, &moved(&q, &dq), &moved(&u, &du)).unwrap();
            let mut words = Vec::new();
            run.record(goal, |event| words.push((event.word(), event.place())));
            let State { q, u, .. } = run.state();
            (beside.close(&q, &u), words)
        };
        let mut growth = vec![0.0];
        for i in 1..=24 {
            let goal = Time::new(0, 0.5 * f64::from(i));
            carried.grow(goal, &mut growth).unwrap();
            let [plus, minus] = [1e-6, -1e-6].map(|h| after(h, goal));
            if plus.1 != minus.1 {
                // An event comes between them and the goal.
                continue;
            }
            let size = growth[0].exp();
            for (j, x) in carried.frame[0].iter().enumerate() {
                let wanted = (plus.0[j] - minus.0[j]) / 2e-6;
                let off = (x * size - wanted).abs();
                assert!(off < 1e-6 * (1.0 + size), "{trial}, {goal:?}: {off:e} of {wanted}, {:?}", plus.1);
                compared += 1;
            }
        }
        compared
    }

    /// A vector is the derivative of the motion in its direction, through stick and slip and through contact
    /// that begins while something sticks.
    #[test]
    fn vectors_are_differences_of_motions() {
        let mut random = Random::of_unit(7, 0);
        let compared: usize = (0..40).map(|trial| compared(&rough(&mut random), trial)).sum();
        assert!(compared > 3000, "{compared}");
    }

    /// The same where friction falls with the sliding speed.
    #[test]
    fn vectors_pass_a_law_of_the_sliding_speed() {
        let mut random = Random::of_unit(9, 0);
        let one = |trial: u32| {
            let mut machine = rough(&mut random);
            let [low, drop] = [0.3, 0.7].map(|part| number(part * machine.friction[0].coefficient));
            let speed = kink("abs", "abs(v)", vec![Formula::Variable(0)]).unwrap();
            let under = joined(Operation::Sum, number(1.0), joined(Operation::Product, number(4.0), speed));
            let formula = joined(Operation::Sum, low, joined(Operation::Quotient, drop, under));
            let (formula, text) = (Arc::new(formula), "mu".into());
            machine.friction[0].law = Some(SmoothForce { formula, text, coefficients: vec![] });
            compared(&machine, trial)
        };
        let compared: usize = (0..12).map(one).sum();
        assert!(compared > 800, "{compared}");
    }

    /// The same through impacts, rest and contact with friction under the stops' forces.
    #[test]
    fn vectors_pass_friction_on_stops() {
        let mut random = Random::of_unit(8, 0);
        let one = |trial: u32| compared(&leaning(&mut random, trial.is_multiple_of(2)), trial);
        let compared: usize = (0..40).map(one).sum();
        assert!(compared > 2000, "{compared}");
    }
}
