//! A second integrator: extrapolated midpoint steps (Gragg, Bulirsch, Stoer), impacts by sign changes and
//! bisection. It shares no code with `src`.

use grazing_scenes::many::{Machine, StopLaw};

/// A force on all coordinates.
pub type Load = fn(f64, &[f64], &[f64]) -> Vec<f64>;

/// A motion under way.
#[derive(Clone)]
pub struct Motion<'a> {
    machine: &'a Machine<f64>,
    inverse: Vec<Vec<f64>>,
    time: f64,
    pub q: Vec<f64>,
    pub u: Vec<f64>,
    resting: Vec<bool>,
    soft: Vec<Soft>,
    /// The force beside the linear ones, by time, displacements and velocities.
    pub load: Option<Load>,
    /// The beginnings and ends of contact with soft stops: stop, time, the gap's rate, whether it begins.
    pub contacts: Vec<(usize, f64, f64, bool)>,
}

/// Where the motion is at a soft stop.
#[derive(Clone, Copy, PartialEq)]
enum Soft {
    /// It is rigid.
    Not,
    Open,
    In,
    /// Let go of, the gap still negative.
    Behind,
}

/// Bounces slower than this end in rest.
const SLOW: f64 = 1e-8;

impl<'a> Motion<'a> {
    pub fn new(machine: &'a Machine<f64>, q: &[f64], u: &[f64]) -> Self {
        let n = machine.size;
        let mut mass = vec![vec![0.0; 2 * n]; n];
        for &(i, j, x) in &machine.mass {
            mass[i][j] = x;
        }
        for (i, row) in mass.iter_mut().enumerate() {
            row[n + i] = 1.0;
        }
        for i in 0..n {
            let pivot = mass[i][i];
            mass[i].iter_mut().for_each(|x| *x /= pivot);
            for j in (0..n).filter(|&j| j != i) {
                let factor = mass[j][i];
                let row = mass[i].clone();
                mass[j].iter_mut().zip(&row).for_each(|(x, y)| *x -= factor * y);
            }
        }
        let inverse = mass.into_iter().map(|row| row[n..].to_vec()).collect();
        let mut motion = Motion {
            soft: vec![Soft::Not; machine.stops.len()],
            load: None,
            contacts: vec![],
            machine,
            inverse,
            time: 0.0,
            q: q.to_vec(),
            u: u.to_vec(),
            resting: vec![false; machine.stops.len()],
        };
        for stop in 0..machine.stops.len() {
            if matches!(machine.stops[stop].law, StopLaw::Soft { .. }) {
                let gap = motion.gap(stop, 0.0, q);
                let (force, _) = motion.push_of(stop, 0.0, q, u);
                motion.soft[stop] = match () {
                    () if gap >= 0.0 => Soft::Open,
                    () if force > 0.0 => Soft::In,
                    () => Soft::Behind,
                };
            }
        }
        motion
    }

    /// The force of a soft stop, of either sign, and the gap.
    fn push_of(&self, stop: usize, t: f64, q: &[f64], u: &[f64]) -> (f64, f64) {
        let StopLaw::Soft { stiffness, damping } = self.machine.stops[stop].law else { panic!("rigid") };
        let gap = self.gap(stop, t, q);
        (-stiffness * gap - damping * self.rate(stop, t, u), gap)
    }

    /// Short against the fastest motion: a radian's sixth.
    fn step(&self) -> f64 {
        let soft = self.machine.stops.iter().map(|stop| match stop.law {
            // Two coordinates at most are pushed.
            StopLaw::Soft { stiffness, damping } => 2.0 * stiffness.max(damping * damping),
            _ => 0.0,
        });
        let stiffest =
            self.machine.stiffness.iter().map(|known| known.2.abs()).chain(soft).fold(0.0, f64::max);
        let lightest = self.inverse.iter().flatten().fold(0.0f64, |most, x| most.max(x.abs()));
        (0.4 / (stiffest * lightest).sqrt().max(1.0)).min(0.02)
    }

    fn wall(&self, stop: usize, t: f64) -> [f64; 3] {
        let wall = &self.machine.stops[stop].wall;
        let mut all = [wall.offset, 0.0, 0.0];
        for h in &wall.harmonics {
            let k = f64::from(h.k);
            let (sin, cos) = (k * t).sin_cos();
            all[0] += h.cos * cos + h.sin * sin;
            all[1] += k * (h.sin * cos - h.cos * sin);
            all[2] -= k * k * (h.cos * cos + h.sin * sin);
        }
        all
    }

    fn push(&self, stop: usize) -> Vec<f64> {
        let row = &self.machine.stops[stop].row;
        self.inverse.iter().map(|line| dot(line, row)).collect()
    }

    fn gap(&self, stop: usize, t: f64, q: &[f64]) -> f64 {
        dot(&self.machine.stops[stop].row, q) - self.wall(stop, t)[0]
    }

    fn rate(&self, stop: usize, t: f64, u: &[f64]) -> f64 {
        dot(&self.machine.stops[stop].row, u) - self.wall(stop, t)[1]
    }

    /// q″ without rigid stops.
    fn free(&self, t: f64, q: &[f64], u: &[f64]) -> Vec<f64> {
        let n = q.len();
        let mut force: Vec<f64> = (0..n).map(|i| self.machine.force.get(i).copied().unwrap_or(0.0)).collect();
        for load in &self.machine.forcing {
            let (sin, cos) = (f64::from(load.k) * t).sin_cos();
            for (force, (a, b)) in force.iter_mut().zip(load.cos.iter().zip(&load.sin)) {
                *force += a * cos + b * sin;
            }
        }
        for &(i, j, c) in &self.machine.damping {
            force[i] -= c * u[j];
        }
        for &(i, j, k) in &self.machine.stiffness {
            force[i] -= k * q[j];
        }
        if let Some(load) = self.load {
            force.iter_mut().zip(load(t, q, u)).for_each(|(force, more)| *force += more);
        }
        for stop in (0..self.soft.len()).filter(|&stop| self.soft[stop] == Soft::In) {
            let (push, _) = self.push_of(stop, t, q, u);
            for (force, w) in force.iter_mut().zip(&self.machine.stops[stop].row) {
                *force += push * w;
            }
        }
        self.inverse.iter().map(|line| dot(line, &force)).collect()
    }

    /// The force of a stop that is rested on, one at a time.
    fn force(&self, stop: usize, t: f64, a: &[f64]) -> f64 {
        let row = &self.machine.stops[stop].row;
        (self.wall(stop, t)[2] - dot(row, a)) / dot(row, &self.push(stop))
    }

    fn derivative(&self, t: f64, x: &[f64]) -> Vec<f64> {
        let n = self.q.len();
        let (q, u) = x.split_at(n);
        let mut a = self.free(t, q, u);
        for stop in (0..self.resting.len()).filter(|&stop| self.resting[stop]) {
            let force = self.force(stop, t, &a);
            for (a, push) in a.iter_mut().zip(self.push(stop)) {
                *a += force * push;
            }
        }
        u.iter().copied().chain(a).collect()
    }

    /// The state after h.
    fn after(&self, h: f64) -> Vec<f64> {
        let x: Vec<f64> = self.q.iter().chain(&self.u).copied().collect();
        extrapolated(&x, h, |after, x| self.derivative(self.time + after, x))
    }

    /// What falls below 0 where a soft stop changes.
    fn until(&self, stop: usize, t: f64, q: &[f64], u: &[f64]) -> f64 {
        let (force, gap) = self.push_of(stop, t, q, u);
        match self.soft[stop] {
            Soft::In => force,
            Soft::Behind => (-force).min(-gap),
            _ => gap,
        }
    }

    fn restitution(&self, stop: usize, rate: f64) -> f64 {
        let stop = &self.machine.stops[stop];
        let StopLaw::Speed(law) = &stop.law else { return stop.wall.restitution };
        let sum = |all: &[f64]| -> f64 { (0i32..).zip(all).map(|(i, c)| c * rate.abs().powi(i)).sum() };
        sum(&law.over) / sum(&law.under)
    }

    /// A soft stop changes now.
    fn pass(&mut self, stop: usize) {
        let (force, gap) = self.push_of(stop, self.time, &self.q, &self.u);
        let rate = self.rate(stop, self.time, &self.u);
        let before = self.soft[stop];
        self.soft[stop] = match before {
            Soft::In if gap < 0.0 && gap.abs() > 1e-13 => Soft::Behind,
            Soft::In => Soft::Open,
            Soft::Behind if force.abs() > gap.abs() => Soft::Open,
            _ => Soft::In,
        };
        if (before == Soft::In) != (self.soft[stop] == Soft::In) {
            self.contacts.push((stop, self.time, rate, self.soft[stop] == Soft::In));
        }
    }

    /// All impacts up to a time: stop, time, velocity.
    pub fn follow(&mut self, until: f64) -> Vec<(usize, f64, f64)> {
        let mut hits = Vec::new();
        let n = self.q.len();
        while self.time < until {
            assert!(
                hits.len() < 10_000,
                "the second integrator does not get on at {}: {:?}",
                self.time,
                &hits[9_990..]
            );
            let h = self.step().min(until - self.time);
            let end = self.after(h);
            // The first root of any gap that is not rested on, or of any force, within the step.
            let mut first: Option<(f64, usize, bool)> = None;
            for stop in 0..self.resting.len() {
                let value = |h: f64| {
                    let x = if h == 0.0 {
                        self.q.iter().chain(&self.u).copied().collect()
                    } else {
                        self.after(h)
                    };
                    let (q, u) = x.split_at(n);
                    if self.soft[stop] != Soft::Not {
                        self.until(stop, self.time + h, q, u)
                    } else if self.resting[stop] {
                        self.force(stop, self.time + h, &self.free(self.time + h, q, u))
                    } else {
                        self.gap(stop, self.time + h, q)
                    }
                };
                let at_end = if self.soft[stop] != Soft::Not {
                    self.until(stop, self.time + h, &end[..n], &end[n..])
                } else if self.resting[stop] {
                    self.force(stop, self.time + h, &self.free(self.time + h, &end[..n], &end[n..]))
                } else {
                    self.gap(stop, self.time + h, &end[..n])
                };
                if at_end < 0.0 {
                    let (mut low, mut high) = (0.0, h);
                    // Past the zero that an impact left behind.
                    let mut inner = h;
                    while inner > 1e-9 && value(inner) < 0.0 {
                        inner /= 2.0;
                    }
                    if value(inner) > 0.0 {
                        low = inner;
                    }
                    for _ in 0..60 {
                        let middle = (low + high) / 2.0;
                        if value(middle) > 0.0 { low = middle } else { high = middle }
                    }
                    if first.is_none_or(|known| high < known.0) {
                        first = Some((high, stop, self.resting[stop]));
                    }
                }
            }
            let Some((h, stop, released)) = first else {
                (self.q, self.u) = (end[..n].to_vec(), end[n..].to_vec());
                self.time += h;
                continue;
            };
            let x = self.after(h);
            (self.q, self.u) = (x[..n].to_vec(), x[n..].to_vec());
            self.time += h;
            if released {
                self.resting[stop] = false;
                continue;
            }
            if self.soft[stop] != Soft::Not {
                self.pass(stop);
                continue;
            }
            let rate = self.rate(stop, self.time, &self.u);
            hits.push((stop, self.time, rate));
            let push = self.push(stop);
            let row = self.machine.stops[stop].row.clone();
            let tau = self.restitution(stop, rate);
            let slow = tau * rate.abs() < SLOW;
            let factor = if slow { 1.0 } else { 1.0 + tau };
            let impulse = -factor * rate / dot(&row, &push);
            for (u, push) in self.u.iter_mut().zip(&push) {
                *u += impulse * push;
            }
            if slow {
                self.resting[stop] = true;
            }
        }
        hits
    }
}

/// x after h by its slope at a time from the beginning: midpoint rule with 2, 4, …, 16 steps, extrapolated in
/// the square of the step.
pub fn extrapolated(x: &[f64], h: f64, slope: impl Fn(f64, &[f64]) -> Vec<f64>) -> Vec<f64> {
    let add =
        |x: &[f64], d: &[f64], h: f64| -> Vec<f64> { x.iter().zip(d).map(|(x, d)| x + h * d).collect() };
    let mut table: Vec<Vec<f64>> = Vec::new();
    for i in 1..=8usize {
        let (steps, step) = (2 * i, h / (2 * i) as f64);
        let mut before = x.to_vec();
        let mut now = add(x, &slope(0.0, x), step);
        for j in 1..steps {
            let next = add(&before, &slope(j as f64 * step, &now), 2.0 * step);
            (before, now) = (now, next);
        }
        let end = add(&before, &slope(h, &now), step);
        // Aitken–Neville: table[j] is extrapolated from the j + 1 latest step counts.
        let mut last: Vec<f64> = now.iter().zip(&end).map(|(a, b)| (a + b) / 2.0).collect();
        let mut next = vec![last.clone()];
        for (j, old) in table.iter().enumerate() {
            let ratio = (i as f64 / (i - 1 - j) as f64).powi(2);
            last = last.iter().zip(old).map(|(new, old)| new + (new - old) / (ratio - 1.0)).collect();
            next.push(last.clone());
        }
        table = next;
    }
    table.pop().expect("eight rows")
}

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Numbers from a seed, evenly between two.
pub fn numbers(mut seed: u64) -> impl FnMut(f64, f64) -> f64 {
    move |low, high| {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        low + (high - low) * ((seed >> 11) as f64 / (1u64 << 53) as f64)
    }
}

/// When the first of some values falls below 0 in a step of h, by samples and bisection: a value that is 0 at
/// the beginning may rise. Which it is, and just after when.
pub fn falls(h: f64, values: impl Fn(f64) -> Vec<f64>) -> Option<(usize, f64)> {
    let mut before = (0.0, values(0.0));
    let mut hit = None;
    for part in 1..=6 {
        let now = h * f64::from(part) / 6.0;
        let seen = values(now);
        if (0..seen.len()).any(|i| seen[i] < 0.0 && before.1[i] > -1e-9) {
            hit = Some((before.0, now));
            break;
        }
        before = (now, seen);
    }
    let (mut low, mut high): (f64, f64) = hit?;
    let negative = |h: f64| values(h).iter().position(|value| *value < 0.0);
    if low == 0.0 {
        let mut inner = high / 2.0;
        while inner > 1e-9 && negative(inner).is_some() {
            inner /= 2.0;
        }
        low = if negative(inner).is_none() { inner } else { 0.0 };
    }
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        if negative(middle).is_some() { high = middle } else { low = middle }
    }
    negative(high).map(|which| (which, high))
}

/// Two masses of 1 on springs, driven, with a formula for the force on each.
pub fn pair_with(forces: [String; 2]) -> String {
    format!(
        "[system]\nperiod = \"2*pi\"\nmass = [[1, 0], [0, 1]]\nstiffness = [[2, -0.5], [-0.5, 1.5]]\n\
         damping = [[0.2, 0], [0, 0.3]]\nforcing = [{{ cos = [1, 0] }}]\nforce = [\"{}\", \"{}\"]",
        forces[0], forces[1]
    )
}
