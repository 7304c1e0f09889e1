//! A second solver for friction under the force of stops: the equations with all forces as unknowns at once,
//! contacts and modes by brute force. It shares no code with `src`, and nothing with `rough` but elimination.

use grazing_scenes::many::{Machine, NormalForce, StopLaw};

use super::super::second::{dot, extrapolated, falls};
use super::rough::solved;

/// A stop: open; pressing, rested on if it is rigid; let go of before it is open.
#[derive(Debug, Clone, Copy, PartialEq)]
enum At {
    Open,
    Pressing,
    Behind,
}

/// At a row with friction nothing presses.
const OPEN: i32 = 9;

/// Bounces after which the gap would rise by less end in rest.
const DEPTH: f64 = 1e-12;

pub struct Pressed<'a> {
    machine: &'a Machine<f64>,
    mass: Vec<Vec<f64>>,
    /// −1 or 1 where it slides, 0 where it sticks, [`OPEN`].
    modes: Vec<i32>,
    stops: Vec<At>,
    time: f64,
    pub x: Vec<f64>,
    /// What dampers, impacts and friction took.
    pub lost: f64,
    /// How often rest on a stop began.
    pub rests: usize,
}

type Told = (&'static str, usize, f64);

impl<'a> Pressed<'a> {
    pub fn new(machine: &'a Machine<f64>, q: &[f64], u: &[f64]) -> Self {
        let n = machine.size;
        let mut mass = vec![vec![0.0; n]; n];
        for &(i, j, x) in &machine.mass {
            mass[i][j] = x;
        }
        let x = q.iter().chain(u).copied().collect();
        let (modes, stops) = (vec![OPEN; machine.friction.len()], vec![At::Open; machine.stops.len()]);
        Pressed { machine, mass, modes, stops, time: 0.0, x, lost: 0.0, rests: 0 }
    }

    fn soft(&self, stop: usize) -> Option<(f64, f64)> {
        match self.machine.stops[stop].law {
            StopLaw::Soft { stiffness, damping } => Some((stiffness, damping)),
            _ => None,
        }
    }

    fn gap(&self, stop: usize, x: &[f64]) -> [f64; 2] {
        let (stop, n) = (&self.machine.stops[stop], self.machine.size);
        [dot(&stop.row, &x[..n]) - stop.wall.offset, dot(&stop.row, &x[n..])]
    }

    fn push(&self, stop: usize, x: &[f64]) -> f64 {
        let ([gap, rate], (k, c)) = (self.gap(stop, x), self.soft(stop).unwrap());
        -(k * gap + c * rate)
    }

    fn speed(&self, j: usize, x: &[f64]) -> f64 {
        let rub = &self.machine.friction[j];
        dot(&rub.row, &x[self.machine.size..]) - rub.speed
    }

    /// q″, the forces of friction, those of stops.
    fn solve(&self, modes: &[i32], stops: &[At], t: f64, x: &[f64]) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        let (n, m, s) = (self.machine.size, modes.len(), stops.len());
        let (q, u) = x.split_at(n);
        let mut force: Vec<f64> = (0..n).map(|i| self.machine.force.get(i).copied().unwrap_or(0.0)).collect();
        for load in &self.machine.forcing {
            let (sin, cos) = (f64::from(load.k) * t).sin_cos();
            for (i, force) in force.iter_mut().enumerate() {
                *force += load.cos.get(i).unwrap_or(&0.0) * cos + load.sin.get(i).unwrap_or(&0.0) * sin;
            }
        }
        self.machine.damping.iter().for_each(|&(i, j, c)| force[i] -= c * u[j]);
        self.machine.stiffness.iter().for_each(|&(i, j, k)| force[i] -= k * q[j]);
        let all = n + m + s;
        let (mut a, mut b) = (vec![vec![0.0; all]; all], vec![0.0; all]);
        for i in 0..n {
            a[i][..n].copy_from_slice(&self.mass[i]);
            (0..m).for_each(|j| a[i][n + j] = -self.machine.friction[j].row[i]);
            (0..s).for_each(|j| a[i][n + m + j] = -self.machine.stops[j].row[i]);
            b[i] = force[i];
        }
        for (j, mode) in modes.iter().enumerate() {
            let (rub, row) = (&self.machine.friction[j], n + j);
            match *mode {
                0 => a[row][..n].copy_from_slice(&rub.row),
                OPEN => a[row][row] = 1.0,
                way => {
                    a[row][row] = 1.0;
                    let lean = f64::from(way) * rub.coefficient;
                    match rub.normal {
                        NormalForce::Given(normal) => b[row] = -lean * normal,
                        NormalForce::Stop { stop } => a[row][n + m + stop] = lean,
                    }
                }
            }
        }
        for (j, at) in stops.iter().enumerate() {
            let row = n + m + j;
            match (at, self.soft(j)) {
                (At::Pressing, None) => a[row][..n].copy_from_slice(&self.machine.stops[j].row),
                (At::Pressing, Some(_)) => (a[row][row], b[row]) = (1.0, self.push(j, x)),
                _ => a[row][row] = 1.0,
            }
        }
        let mut found = solved(a, b);
        let normals = found.split_off(n + m);
        let forces = found.split_off(n);
        (found, forces, normals)
    }

    fn now(&self) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        self.solve(&self.modes, &self.stops, self.time, &self.x)
    }

    fn after(&self, h: f64) -> Vec<f64> {
        extrapolated(&self.x, h, |after, x| {
            let (a, ..) = self.solve(&self.modes, &self.stops, self.time + after, x);
            x[self.machine.size..].iter().copied().chain(a).collect()
        })
    }

    fn most(&self, j: usize, normals: &[f64]) -> f64 {
        let rub = &self.machine.friction[j];
        rub.static_coefficient
            * match rub.normal {
                NormalForce::Given(normal) => normal,
                NormalForce::Stop { stop } => normals[stop],
            }
    }

    /// What is positive as long as nothing happens.
    fn watched(&self, t: f64, x: &[f64]) -> Vec<f64> {
        let (_, forces, normals) = self.solve(&self.modes, &self.stops, t, x);
        let rubs = (0..self.modes.len()).map(|j| match self.modes[j] {
            0 => self.most(j, &normals) - forces[j].abs(),
            OPEN => 1.0,
            mode => f64::from(mode) * self.speed(j, x),
        });
        let stops = (0..self.stops.len()).map(|j| match (self.stops[j], self.soft(j)) {
            (At::Open, _) => self.gap(j, x)[0],
            (At::Pressing, _) => normals[j],
            (At::Behind, _) => -self.gap(j, x)[0],
        });
        rubs.chain(stops).collect()
    }

    fn presses(&self, j: usize) -> bool {
        match self.machine.friction[j].normal {
            NormalForce::Given(_) => true,
            NormalForce::Stop { stop } => self.stops[stop] == At::Pressing,
        }
    }

    /// Modes of what has no velocity; of `sure` what it slides to is known.
    fn decide(&mut self, sure: Option<(usize, i32)>) {
        let (m, x) = (self.modes.len(), self.x.clone());
        let still: Vec<bool> = (0..m).map(|j| self.speed(j, &x).abs() < 1e-9).collect();
        let mut all: Vec<Vec<i32>> = vec![vec![]];
        for (j, still) in still.iter().enumerate() {
            let own: Vec<i32> = match sure {
                _ if !self.presses(j) => vec![OPEN],
                Some((known, way)) if known == j => vec![way],
                _ if *still => vec![0, 1, -1],
                _ => vec![self.speed(j, &x).signum() as i32],
            };
            all = all.iter().flat_map(|known| own.iter().map(|one| [&known[..], &[*one]].concat())).collect();
        }
        let slides = |modes: &Vec<i32>| modes.iter().filter(|mode| mode.abs() == 1).count();
        all.sort_by_key(slides);
        let fits = |modes: &Vec<i32>| {
            let (a, forces, normals) = self.solve(modes, &self.stops, self.time, &x);
            (0..m).all(|j| {
                let bend = dot(&self.machine.friction[j].row, &a);
                let sure = sure.is_some_and(|known| known.0 == j);
                match modes[j] {
                    OPEN => true,
                    0 => forces[j].abs() <= self.most(j, &normals) + 1e-10,
                    way if still[j] && !sure => f64::from(way) * bend > -1e-10,
                    _ => true,
                }
            })
        };
        self.modes = all.iter().find(|modes| fits(modes)).expect("some modes fit").clone();
    }

    /// An impact on a rigid stop: the velocities after it, all impulses as unknowns at once.
    fn bounce(&mut self, stop: usize) {
        let n = self.machine.size;
        let resting: Vec<usize> = (0..self.stops.len())
            .filter(|&j| j != stop && self.soft(j).is_none() && self.stops[j] == At::Pressing)
            .collect();
        assert!(resting.is_empty(), "impacts among rests are not in these machines");
        let rubs: Vec<usize> = (0..self.modes.len())
            .filter(|&j| self.machine.friction[j].normal == NormalForce::Stop { stop })
            .collect();
        let tau = self.machine.stops[stop].wall.restitution;
        let rate = self.gap(stop, &self.x)[1];
        let mut choices: Vec<Vec<i32>> = vec![vec![]];
        for _ in &rubs {
            choices = choices
                .iter()
                .flat_map(|known| [0, 1, -1].map(|one| [&known[..], &[one]].concat()))
                .collect();
        }
        choices.sort_by_key(|modes| modes.iter().filter(|mode| **mode != 0).count());
        for modes in choices {
            let (m, all) = (rubs.len(), n + rubs.len() + 1);
            let (mut a, mut b) = (vec![vec![0.0; all]; all], vec![0.0; all]);
            for i in 0..n {
                a[i][..n].copy_from_slice(&self.mass[i]);
                (0..m).for_each(|j| a[i][n + j] = -self.machine.friction[rubs[j]].row[i]);
                a[i][n + m] = -self.machine.stops[stop].row[i];
                b[i] = dot(&self.mass[i], &self.x[n..]);
            }
            for (j, way) in modes.iter().enumerate() {
                let rub = &self.machine.friction[rubs[j]];
                if *way == 0 {
                    a[n + j][..n].copy_from_slice(&rub.row);
                    b[n + j] = rub.speed;
                } else {
                    (a[n + j][n + j], a[n + j][n + m]) = (1.0, f64::from(*way) * rub.coefficient);
                }
            }
            a[n + m][..n].copy_from_slice(&self.machine.stops[stop].row);
            b[n + m] = -tau * rate;
            let found = solved(a, b);
            let (after, impulse) = (&found[..n], found[n + m]);
            let fits = (0..m).all(|j| {
                let rub = &self.machine.friction[rubs[j]];
                let speed = dot(&rub.row, after) - rub.speed;
                match modes[j] {
                    0 => found[n + j].abs() <= rub.static_coefficient * impulse * (1.0 + 1e-12),
                    way => f64::from(way) * speed >= -1e-12,
                }
            });
            if fits && impulse > 0.0 {
                let energy = |u: &[f64]| (0..n).map(|i| 0.5 * u[i] * dot(&self.mass[i], u)).sum::<f64>();
                self.lost += energy(&self.x[n..]) - energy(after);
                self.x[n..].copy_from_slice(after);
                return;
            }
        }
        panic!("no impact fits");
    }

    /// Whether bounces on a stop are over: then the machine is brought to rest there, what slides with it.
    fn rests(&mut self, stop: usize) -> bool {
        let n = self.machine.size;
        let ([_, rate], (a, ..)) = (self.gap(stop, &self.x), self.now());
        let row = self.machine.stops[stop].row.clone();
        let bend = dot(&row, &a);
        if !(bend < 0.0 && rate * rate < -2.0 * bend * DEPTH) {
            return false;
        }
        let mut along = row.clone();
        let mut still: Vec<Vec<f64>> = Vec::new();
        for rub in &self.machine.friction {
            let speed = dot(&rub.row, &self.x[n..]) - rub.speed;
            if rub.normal != (NormalForce::Stop { stop }) {
                continue;
            }
            if speed.abs() > 1e-9 {
                along.iter_mut().zip(&rub.row).for_each(|(x, t)| *x -= speed.signum() * rub.coefficient * t);
            } else {
                still.push(rub.row.clone());
            }
        }
        // M δu = Σ impulses, w δu = −w′, t δu = 0 where it has no velocity along the stop.
        let all = n + 1 + still.len();
        let (mut a, mut b) = (vec![vec![0.0; all]; all], vec![0.0; all]);
        for i in 0..n {
            a[i][..n].copy_from_slice(&self.mass[i]);
            a[i][n] = -along[i];
            (0..still.len()).for_each(|j| a[i][n + 1 + j] = -still[j][i]);
        }
        a[n][..n].copy_from_slice(&row);
        b[n] = -rate;
        (0..still.len()).for_each(|j| a[n + 1 + j][..n].copy_from_slice(&still[j]));
        let change = solved(a, b);
        self.x[n..].iter_mut().zip(&change).for_each(|(u, change)| *u += change);
        true
    }

    /// On to a time: what happened, but for when rest on a stop begins.
    pub fn follow(&mut self, until: f64) -> Vec<Told> {
        let (m, s, mut all) = (self.modes.len(), self.stops.len(), Vec::new());
        self.decide(None);
        let (mut steps, most) = (0u32, (until / 0.02) as u32 + 3000);
        while self.time < until {
            steps += 1;
            assert!(steps < most, "no end at {}: {:?} {:?} {:?}", self.time, self.modes, self.stops, self.x);
            let h = 0.02f64.min(until - self.time);
            let watched = |h: f64| self.watched(self.time + h, &self.after(h));
            let Some((which, high)) = falls(h, watched) else {
                (self.x, self.time) = (self.after(h), self.time + h);
                continue;
            };
            let forces = self.solve(&self.modes, &self.stops, self.time + high, &self.after(high)).1;
            (self.x, self.time) = (self.after(high), self.time + high);
            let (was, mut sure) = (self.modes.clone(), None);
            if which < m && was[which] == 0 {
                sure = Some((which, if forces[which] > 0.0 { -1 } else { 1 }));
            }
            if let Some(stop) = which.checked_sub(m) {
                match (self.stops[stop], self.soft(stop)) {
                    (At::Open, Some(_)) => {
                        all.push(("touch", stop, self.time));
                        self.stops[stop] = At::Pressing;
                    }
                    (At::Open, None) => {
                        all.push(("impact", stop, self.time));
                        self.bounce(stop);
                        if self.rests(stop) {
                            self.stops[stop] = At::Pressing;
                            self.rests += 1;
                        }
                    }
                    (At::Pressing, soft) => {
                        all.push(("release", stop, self.time));
                        let behind = soft.is_some_and(|(_, c)| c > 0.0) && self.gap(stop, &self.x)[0] < 0.0;
                        self.stops[stop] = if behind { At::Behind } else { At::Open };
                    }
                    (At::Behind, _) => self.stops[stop] = At::Open,
                }
            }
            self.decide(sure);
            for (j, (was, is)) in was.iter().zip(&self.modes).enumerate() {
                let word = match (was, is) {
                    _ if was == is => continue,
                    (_, 0) => "stick",
                    (0, _) => "release",
                    (&OPEN, _) | (_, &OPEN) => continue,
                    _ => "reversal",
                };
                all.push((word, s + j, self.time));
            }
        }
        all
    }
}
