//! A second solver for dry friction. It shares no code with `src`.

use grazing_scenes::many::{Friction, Machine, NormalForce};

use super::super::second::{dot, extrapolated, falls};

/// A second solver: the equations as they stand, extrapolated midpoint steps, modes by brute force.
pub struct Rough<'a> {
    machine: &'a Machine<f64>,
    mass: Vec<Vec<f64>>,
    /// −1 or 1 where it slides, 0 where it sticks.
    modes: Vec<i32>,
    time: f64,
    pub x: Vec<f64>,
    pub load: fn(&[f64], &[f64]) -> Vec<f64>,
    /// Of each row µ₀, µ₁ and s, where its coefficient is µ₀ + µ₁ exp(−|v|/s); empty where they are numbers.
    pub stribeck: Vec<[f64; 3]>,
    /// How often each velocity changed its sign, and the sign that it had last.
    pub turns: Vec<usize>,
    signs: Vec<f64>,
}

/// x of a x = b, by elimination with pivots.
pub fn solved(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for i in 0..n {
        let pivot = (i..n).max_by(|&p, &q| a[p][i].abs().total_cmp(&a[q][i].abs())).unwrap();
        a.swap(i, pivot);
        b.swap(i, pivot);
        for j in i + 1..n {
            let factor = a[j][i] / a[i][i];
            let row = a[i].clone();
            a[j].iter_mut().zip(row).for_each(|(x, y)| *x -= factor * y);
            b[j] -= factor * b[i];
        }
    }
    for i in (0..n).rev() {
        let left: f64 = (i + 1..n).map(|j| a[i][j] * b[j]).sum();
        b[i] = (b[i] - left) / a[i][i];
    }
    b
}

/// The normal force at a row, which is given here.
fn normal(rub: &Friction<f64>) -> f64 {
    match rub.normal {
        NormalForce::Given(force) => force,
        NormalForce::Stop { .. } => panic!("the force of a stop: see `pressed`"),
    }
}

impl<'a> Rough<'a> {
    pub fn new(machine: &'a Machine<f64>, q: &[f64], u: &[f64]) -> Self {
        let n = machine.size;
        let mut mass = vec![vec![0.0; n]; n];
        for &(i, j, x) in &machine.mass {
            mass[i][j] = x;
        }
        let x = q.iter().chain(u).copied().collect();
        let modes = vec![1; machine.friction.len()];
        let mut all = Rough {
            machine,
            mass,
            modes,
            time: 0.0,
            x,
            load: |q, _| vec![0.0; q.len()],
            stribeck: vec![],
            turns: vec![0; n],
            signs: u.to_vec(),
        };
        all.decide(None);
        all
    }

    /// The surface's velocity and acceleration.
    fn surface(&self, j: usize, t: f64) -> [f64; 2] {
        let rub = &self.machine.friction[j];
        let mut all = [rub.speed, 0.0];
        for h in &rub.harmonics {
            let k = f64::from(h.k);
            let (sin, cos) = (k * t).sin_cos();
            all[0] += k * (h.sin * cos - h.cos * sin);
            all[1] -= k * k * (h.cos * cos + h.sin * sin);
        }
        all
    }

    /// The largest force that holds.
    fn most(&self, j: usize) -> f64 {
        let rub = &self.machine.friction[j];
        let rest = self.stribeck.get(j).map_or(0.0, |[low, drop, _]| low + drop);
        rub.static_coefficient.max(rest) * normal(rub)
    }

    fn speed(&self, j: usize, t: f64, x: &[f64]) -> f64 {
        dot(&self.machine.friction[j].row, &x[self.machine.size..]) - self.surface(j, t)[0]
    }

    /// q″ and the forces of friction in some modes, all unknowns at once.
    fn solve(&self, modes: &[i32], t: f64, x: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let n = self.machine.size;
        let (q, u) = x.split_at(n);
        let mut force: Vec<f64> = (0..n).map(|i| self.machine.force.get(i).copied().unwrap_or(0.0)).collect();
        for load in &self.machine.forcing {
            let (sin, cos) = (f64::from(load.k) * t).sin_cos();
            for (i, force) in force.iter_mut().enumerate() {
                let part = |of: &[f64]| of.get(i).copied().unwrap_or(0.0);
                *force += part(&load.cos) * cos + part(&load.sin) * sin;
            }
        }
        self.machine.damping.iter().for_each(|&(i, j, c)| force[i] -= c * u[j]);
        self.machine.stiffness.iter().for_each(|&(i, j, k)| force[i] -= k * q[j]);
        force.iter_mut().zip((self.load)(q, u)).for_each(|(force, more)| *force += more);
        let m = modes.len();
        let mut a = vec![vec![0.0; n + m]; n + m];
        for (i, (row, mass)) in a.iter_mut().zip(&self.mass).enumerate() {
            row[..n].copy_from_slice(mass);
            for (j, rub) in self.machine.friction.iter().enumerate() {
                row[n + j] = -rub.row[i];
            }
        }
        let mut b = force;
        for (j, rub) in self.machine.friction.iter().enumerate() {
            if modes[j] == 0 {
                a[n + j][..n].copy_from_slice(&rub.row);
                b.push(self.surface(j, t)[1]);
            } else {
                a[n + j][n + j] = 1.0;
                let way = f64::from(modes[j]);
                let falls =
                    |[low, drop, scale]: &[f64; 3]| low + drop * (-way * self.speed(j, t, x) / scale).exp();
                let coefficient = self.stribeck.get(j).map_or(rub.coefficient, falls);
                b.push(-way * coefficient * normal(rub));
            }
        }
        let mut found = solved(a, b);
        let forces = found.split_off(n);
        (found, forces)
    }

    /// The state after h.
    fn after(&self, h: f64) -> Vec<f64> {
        extrapolated(&self.x, h, |after, x| {
            let (a, _) = self.solve(&self.modes, self.time + after, x);
            x[self.machine.size..].iter().copied().chain(a).collect()
        })
    }

    /// What is positive as long as nothing happens: velocities, what could be held more, gaps.
    fn watched(&self, t: f64, x: &[f64]) -> Vec<f64> {
        let (_, forces) = self.solve(&self.modes, t, x);
        let rubs = (0..self.modes.len()).map(|j| match self.modes[j] {
            0 => self.most(j) - forces[j].abs(),
            mode => f64::from(mode) * self.speed(j, t, x),
        });
        let gaps = self.machine.stops.iter().map(|stop| dot(&stop.row, x) - stop.wall.offset);
        rubs.chain(gaps).collect()
    }

    /// The modes of what has no velocity; of `sure` what it slides to is known.
    pub fn decide(&mut self, sure: Option<(usize, i32)>) {
        let (m, t, x) = (self.modes.len(), self.time, self.x.clone());
        let still: Vec<bool> = (0..m).map(|j| self.speed(j, t, &x).abs() < 1e-9).collect();
        let mut all: Vec<Vec<i32>> = vec![vec![]];
        for (j, still) in still.iter().enumerate() {
            let own: Vec<i32> = match sure {
                Some((known, way)) if known == j => vec![way],
                _ if *still => vec![0, 1, -1],
                _ => vec![self.speed(j, t, &x).signum() as i32],
            };
            all = all.iter().flat_map(|known| own.iter().map(|one| [&known[..], &[*one]].concat())).collect();
        }
        let before = self.modes.clone();
        let released = |modes: &Vec<i32>| (0..m).filter(|&j| before[j] == 0 && modes[j] != 0).count();
        all.sort_by_key(|modes| (modes.iter().filter(|mode| **mode != 0).count(), released(modes)));
        let fits = |modes: &Vec<i32>| {
            let (a, forces) = self.solve(modes, t, &x);
            (0..m).all(|j| {
                let bend = dot(&self.machine.friction[j].row, &a) - self.surface(j, t)[1];
                let sure = sure.is_some_and(|known| known.0 == j);
                match modes[j] {
                    0 => forces[j].abs() <= self.most(j) + 1e-10,
                    way if still[j] && !sure => f64::from(way) * bend > -1e-10,
                    _ => true,
                }
            })
        };
        self.modes = all.iter().find(|modes| fits(modes)).expect("some modes fit").clone();
    }

    /// Looks at the signs of velocities.
    fn turned(&mut self) {
        for (i, u) in self.x[self.machine.size..].iter().enumerate().filter(|(_, u)| u.abs() > 1e-9) {
            self.turns[i] += usize::from(u.signum() != self.signs[i].signum());
            self.signs[i] = *u;
        }
    }

    /// On to a time: what happened.
    pub fn follow(&mut self, until: f64) -> Vec<(&'static str, usize, f64)> {
        let (n, stops, mut all) = (self.machine.size, self.machine.stops.len(), Vec::new());
        while self.time < until {
            let h = 0.05f64.min(until - self.time);
            let watched = |h: f64| self.watched(self.time + h, &self.after(h));
            let Some((which, high)) = falls(h, watched) else {
                (self.x, self.time) = (self.after(h), self.time + h);
                self.turned();
                continue;
            };
            let forces = self.solve(&self.modes, self.time + high, &self.after(high)).1;
            (self.x, self.time) = (self.after(high), self.time + high);
            let (m, was) = (self.modes.len(), self.modes.clone());
            let mut sure = None;
            if which >= m {
                let stop = &self.machine.stops[which - m];
                let push = solved(self.mass.clone(), stop.row.clone());
                let impulse =
                    -(1.0 + stop.wall.restitution) * dot(&stop.row, &self.x[n..]) / dot(&stop.row, &push);
                self.x[n..].iter_mut().zip(&push).for_each(|(u, push)| *u += impulse * push);
                all.push(("impact", which - m, self.time));
            } else if was[which] == 0 {
                sure = Some((which, if forces[which] > 0.0 { -1 } else { 1 }));
            }
            self.decide(sure);
            for (j, (was, is)) in was.iter().zip(&self.modes).enumerate() {
                let word = match (was, is) {
                    _ if was == is => continue,
                    (_, 0) => "stick",
                    (0, _) => "release",
                    _ => "reversal",
                };
                all.push((word, stops + j, self.time));
            }
        }
        all
    }
}
