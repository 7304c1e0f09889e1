//! What certificates of ranges say of random oscillators, against their motions: random words have their
//! impacts in the boxes, as Newton's method and the simulator find them, and where there are said to be no
//! others, neither other words nor motions that begin at random show one.
//!
//! A sample for `cargo test`; as many oscillators as one likes with GRAZING_SAMPLES.

use crate::samples::samples;
use std::f64::consts::{PI, TAU};

use super::range_random::{Machine, Random, drawn};
use grazing_scenes::{
    certificate::{self, range::Certificate},
    motion::{Harmonic, Side, System, Time, Wall},
    one::simulate::{Event, Settings, Simulator},
    search::range::{RangeEffort, RangeProblem, born, prove, prove_alone},
};
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// The simulator counts no impact by which the gap falls to less below 0.
const SEEN: f64 = 1e-13;
/// From how many starts a motion that stays near is looked for, each nearer to the best.
const STARTS: usize = 600;

/// A certificate's numbers in floats.
struct Claim {
    /// Whether there are two walls, each the other's mirror image; then periods are half periods.
    mirrored: bool,
    machine: Machine,
    window: f64,
    periods: Vec<u64>,
    edges: Vec<[usize; 2]>,
    cells: Vec<Cell>,
    /// The rounds that do: what is said of an impact depends on twice as many before it and after it.
    rounds: usize,
}

struct Cell {
    /// Least and greatest ν.
    depth: [f64; 2],
    /// Of each edge.
    strengths: Vec<[f64; 2]>,
    /// S, where it is claimed that there are no others.
    alone: Option<f64>,
}

/// An oscillator at a depth, with lengths over ν.
struct At<'a> {
    claim: &'a Claim,
    cell: &'a Cell,
    depth: f64,
}

fn float(x: impl ToString) -> f64 {
    x.to_string().parse().unwrap()
}

impl Claim {
    fn of(machine: Machine, found: &Certificate) -> Claim {
        let next = |u: usize| found.letters[u].next.iter().map(move |&v| [u, v]);
        let mut from = 0.0;
        let mut cells = Vec::new();
        for cell in &found.cells {
            let to = cell.depth.p as f64 / cell.depth.q as f64;
            let strengths = cell.edges.iter().map(|edge| edge.strengths.map(float)).collect();
            let alone = cell.others.map(|others| float(others.strength));
            cells.push(Cell { depth: [from, to], strengths, alone });
            from = to;
        }
        let holds = |rounds: u64| {
            let mut fewer = found.clone();
            fewer.alone.iter_mut().for_each(|alone| alone.rounds = rounds);
            certificate::check(&mut fewer.to_string().as_bytes()).is_ok()
        };
        let rounds =
            found.alone.map_or(0, |alone| (1..alone.rounds).find(|&q| holds(q)).unwrap_or(alone.rounds));
        Claim {
            mirrored: found.mirrored,
            machine,
            window: float(found.window),
            periods: found.letters.iter().map(|letter| letter.periods).collect(),
            edges: (0..found.letters.len()).flat_map(next).collect(),
            cells,
            rounds: rounds as usize,
        }
    }

    /// At a depth of a cell, at random.
    fn at<'a>(&'a self, random: &mut Random, cell: &'a Cell) -> At<'a> {
        let [least, greatest] = cell.depth;
        let depth = random.between(least.max(greatest / 1000.0), greatest);
        At { claim: self, cell, depth }
    }

    /// A period, or half period.
    fn turn(&self) -> f64 {
        if self.mirrored { PI } else { TAU }
    }

    /// The letters of a random closed path.
    fn word(&self, random: &mut Random) -> Option<Vec<usize>> {
        let length = random.between(1.0, 13.0) as usize;
        let next = |u: usize, random: &mut Random| {
            let all: Vec<usize> = self.edges.iter().filter(|edge| edge[0] == u).map(|edge| edge[1]).collect();
            all[random.between(0.0, all.len() as f64) as usize]
        };
        let path = |_| {
            let mut path = vec![random.between(0.0, self.periods.len() as f64) as usize];
            for i in 1..length {
                path.push(next(path[i - 1], random));
            }
            self.edges.contains(&[path[length - 1], path[0]]).then_some(path)
        };
        (0..200).find_map(path)
    }

    /// The edge between legs of these periods.
    fn edge(&self, periods: [u64; 2]) -> Option<usize> {
        self.edges.iter().position(|edge| edge.map(|v| self.periods[v]) == periods)
    }
}

impl At<'_> {
    fn phase(&self, s: f64) -> f64 {
        -(self.depth * s / 2.0).asin()
    }

    fn place(&self, t: f64) -> f64 {
        self.claim.machine.side - 2.0 * (t / 2.0).sin().powi(2) / self.depth
    }

    /// The first and the last velocity of a leg.
    fn leg(&self, n: u64, s: f64, next: f64) -> [f64; 2] {
        let [t, u] = [s, next].map(|s| self.phase(s));
        let sign = if self.claim.mirrored && n % 2 == 1 { -1.0 } else { 1.0 };
        let time = self.claim.turn() * n as f64 + u - t;
        let [e11, e12, e21, e22] = self.claim.machine.flow(time).map(|x| sign * x);
        let a = (self.place(u) - e11 * self.place(t)) / e12;
        [a, e21 * self.place(t) + e22 * a]
    }

    /// s − 2 (a + τp)/(1 + τ) round a word; the leg after impact i has periods word[i].
    fn law(&self, word: &[u64], s: &[f64]) -> Vec<f64> {
        let (m, tau) = (word.len(), self.claim.machine.parameters[2]);
        let legs: Vec<[f64; 2]> = (0..m).map(|i| self.leg(word[i], s[i], s[(i + 1) % m])).collect();
        (0..m).map(|i| s[i] - 2.0 * (legs[i][0] + tau * legs[(i + m - 1) % m][1]) / (1.0 + tau)).collect()
    }

    /// The strengths of a periodic word, by Newton's method.
    fn solve(&self, word: &[u64], mut s: Vec<f64>) -> Option<Vec<f64>> {
        for _ in 0..40 {
            let law = self.law(word, &s);
            if law.iter().all(|x| x.abs() < 1e-9 * s.iter().fold(1.0, |most: f64, s| most.max(s.abs()))) {
                return Some(s);
            }
            let slope = |j: usize| {
                let step = 1e-6 * (1.0 + s[j].abs());
                let at = |by: f64| {
                    let mut moved = s.clone();
                    moved[j] += by;
                    self.law(word, &moved)
                };
                at(step).iter().zip(at(-step)).map(|(x, y)| (x - y) / (2.0 * step)).collect::<Vec<f64>>()
            };
            let columns: Vec<Vec<f64>> = (0..s.len()).map(slope).collect();
            let matrix = nalgebra::DMatrix::from_fn(s.len(), s.len(), |i, j| columns[j][i]);
            let change = matrix.lu().solve(&nalgebra::DVector::from_vec(law))?;
            s.iter_mut().zip(change.iter()).for_each(|(s, by)| *s -= by);
            if s.iter().any(|s| !s.is_finite() || (self.depth * s / 2.0).abs() >= 1.0) {
                return None;
            }
        }
        None
    }

    fn simulator(&self) -> Simulator {
        let ([c, k, tau], side) = (self.claim.machine.parameters, self.claim.machine.side);
        let harmonics = vec![Harmonic { k: 1, cos: 1.0, sin: 0.0 }];
        let offset = side * self.depth - 1.0;
        // −w(t − π), g being the cosine.
        let upper = Wall { offset: -offset, harmonics: harmonics.clone(), restitution: tau };
        let (lower, upper) =
            (Some(Wall { offset, harmonics, restitution: tau }), self.claim.mirrored.then_some(upper));
        let (cubic, force, forcing, smooth) = (0.0, 0.0, vec![], None);
        let system =
            System { rate: None, damping: c, stiffness: k, cubic, force, forcing, smooth, lower, upper };
        let settings = Settings { minimum_depth: SEEN, ..Settings::default() };
        Simulator::new(&system, &settings).unwrap()
    }

    /// What the simulator does otherwise than this word says: begun after an impact, it is to meet the next.
    fn otherwise(&self, word: &[u64], s: &[f64]) -> Option<String> {
        let simulator = self.simulator();
        for (i, &n) in word.iter().enumerate() {
            let (s, next) = (s[i], s[(i + 1) % s.len()]);
            let ([a, p], t) = (self.leg(n, s, next), self.phase(s));
            let start = Time::new(0, t.rem_euclid(TAU));
            let mut run = simulator.start(start, self.depth * self.place(t) + 1e-15, self.depth * a).unwrap();
            let Event::Impact(impact) = run.next(Time::new(n as i64 + 2, 0.0)) else {
                return Some(format!("leg {i} does not end by an impact"));
            };
            let turns = if t < 0.0 { 1.0 } else { 0.0 };
            let at = TAU * (impact.time.period as f64 - turns) + impact.time.phase;
            let odd = self.claim.mirrored && n % 2 == 1;
            if impact.place != if odd { Side::Upper } else { Side::Lower } {
                return Some(format!("leg {i} ends at the other wall"));
            }
            let expected = self.claim.turn() * n as f64 + self.phase(next);
            let speed = self.depth * (next / 2.0 - p);
            let close = 1e-7 + 1e-11 / speed.max(1e-9);
            if (at - expected).abs() > close || (impact.velocity + speed).abs() > close {
                return Some(format!("leg {i}: {at} and {}, not {expected} and {}", impact.velocity, -speed));
            }
        }
        None
    }

    /// A random word of the graph has one motion, its impacts in the boxes.
    fn confirm(&self, random: &mut Random) {
        let Some(word) = self.claim.word(random) else { return };
        let m = word.len();
        let edge = |i: usize| {
            let ends = [word[(i + m - 1) % m], word[i]];
            self.cell.strengths[self.claim.edges.iter().position(|edge| *edge == ends).unwrap()]
        };
        let boxes: Vec<[f64; 2]> = (0..m).map(edge).collect();
        let periods: Vec<u64> = word.iter().map(|&v| self.claim.periods[v]).collect();
        let start = boxes.iter().map(|[lo, hi]| 0.5 * (lo + hi)).collect();
        let what = || format!("{:?} at {}: {periods:?}", self.claim.machine, self.depth);
        let s = self.solve(&periods, start).unwrap_or_else(|| panic!("{}: no motion", what()));
        for (s, [lo, hi]) in s.iter().zip(&boxes) {
            assert!(lo - 1e-7 <= *s && *s <= hi + 1e-7, "{}: {s} not in {lo} to {hi}", what());
            assert!(self.phase(*s).abs() < self.claim.window);
        }
        // An impact by which the gap would fall by less is a touch for the simulator: there Newton's method
        // alone says that it is one. The gap's acceleration is about 1 + k.
        let slow = (0..m).any(|i| {
            let next = s[(i + 1) % m];
            let speed = self.depth * (next / 2.0 - self.leg(periods[i], s[i], next)[1]);
            assert!(speed > 0.0, "{}: {s:?} leg {i}", what());
            speed * speed < 4.0 * SEEN * (1.0 + self.claim.machine.parameters[1])
        });
        if slow {
            return;
        }
        let otherwise = self.otherwise(&periods, &s);
        assert_eq!(otherwise, None, "{}: {s:?}", what());
    }

    /// Whether an impact is one of those that the certificate has.
    fn is_known(&self, periods: [u64; 2], s: f64) -> bool {
        self.claim.edge(periods).is_some_and(|edge| {
            let [lo, hi] = self.cell.strengths[edge];
            (lo - 1e-6..=hi + 1e-6).contains(&s)
        })
    }

    /// A random word, of any legs, from random strengths: whether it is a motion near. If so, it is known.
    fn finds(&self, random: &mut Random, strength: f64) -> bool {
        let longest = self.claim.periods.iter().max().unwrap() + 4;
        let word: Vec<u64> = (0..random.between(1.0, 5.0) as usize)
            .map(|_| random.between(1.0, longest as f64) as u64)
            .collect();
        let start = word.iter().map(|_| random.between(-strength, strength)).collect();
        let Some(s) = self.solve(&word, start) else { return false };
        let m = word.len();
        let near = s.iter().all(|s| s.abs() < strength && self.phase(*s).abs() < self.claim.window);
        let fast = (0..m).all(|i| self.leg(word[i], s[i], s[(i + 1) % m])[0] > s[i] / 2.0 + 1e-6);
        if !near || !fast || self.otherwise(&word, &s).is_some() {
            return false;
        }
        let known = (0..m).all(|i| self.is_known([word[(i + m - 1) % m], word[i]], s[i]));
        assert!(known, "{:?} at {}: {word:?} {s:?}", self.claim.machine, self.depth);
        true
    }

    /// The windows and strengths of the contacts of a motion that begins with an impact of a strength, by a
    /// velocity, while all are near; rest on the wall has no strength.
    fn stays(&self, simulator: &Simulator, [s, a]: [f64; 2], strength: f64) -> Vec<(i64, f64)> {
        let t = self.phase(s);
        let start = Time::new(1, t.rem_euclid(TAU));
        let mut run = simulator.start(start, self.depth * self.place(t) + 1e-15, self.depth * a).unwrap();
        let halves = if self.claim.mirrored { 2 } else { 1 };
        let mut all = vec![(halves * if t < 0.0 { 2 } else { 1 }, s)];
        while all.len() < 100 {
            let last = all[all.len() - 1].0;
            let (time, place, rests) = match run.next(Time::new(last + 200, 0.0)) {
                Event::Impact(impact) => (impact.time, impact.place, false),
                Event::Stick(stick) => (stick.time, stick.place, true),
                Event::Tangency(_) | Event::Release(_) => continue,
                _ => break,
            };
            let periods = time.period as f64 + time.phase / TAU;
            // Windows of the upper wall are half a period after those of the lower.
            let late = if place == Side::Upper { 0.5 } else { 0.0 };
            let window = (periods - late).round() + late;
            let phase = TAU * (periods - window);
            let s = -2.0 * phase.sin() / self.depth;
            if s.abs() > strength || phase.abs() > self.claim.window {
                break;
            }
            all.push(((halves as f64 * window) as i64, if rests { f64::NAN } else { s }));
        }
        all
    }

    /// A motion that stays near for long, looked for from a random start: how many of its impacts have so
    /// many others near before and after them that they must be known.
    fn follow(&self, random: &mut Random, strength: f64) -> usize {
        let simulator = self.simulator();
        let mut best = [random.between(-strength, strength), 0.0];
        best[1] = best[0] / 2.0 + random.between(0.0, 2.0 * strength);
        let mut longest = Vec::new();
        for step in 0..STARTS {
            let size = strength * 1e-16f64.powf(step as f64 / STARTS as f64);
            let [s, a] = best.map(|x| if step == 0 { x } else { x + random.between(-size, size) });
            if s.abs() > strength || a <= s / 2.0 {
                continue;
            }
            let found = self.stays(&simulator, [s, a], strength);
            if found.len() >= longest.len() {
                (best, longest) = ([s, a], found);
            }
        }
        let deep = 2 * self.claim.rounds;
        let judged = deep.max(1)..longest.len().saturating_sub(deep.max(1));
        for i in judged.clone() {
            let periods = [i - 1, i].map(|i| (longest[i + 1].0 - longest[i].0) as u64);
            let known = self.is_known(periods, longest[i].1);
            assert!(known, "{:?} at {}: {i} of {longest:?}", self.claim.machine, self.depth);
        }
        judged.len()
    }
}

/// The certificates of both sides of a machine's touch: of all that is born, with no others where that is
/// found.
fn claims(mirrored: bool, exact: &[BigRational; 3], effort: u64) -> Vec<Claim> {
    let parameters = exact.each_ref().map(|x| x.to_f64().unwrap());
    let one = |x: &BigRational| [x.clone(), x.clone()];
    let [zero, unit] = [0, 1].map(|x| BigRational::from_integer(x.into()));
    let mut all = Vec::new();
    for (behind, side, deepest) in [(false, -1.0, 4.0), (true, 1.0, 0.95)] {
        let Some(born) = born(mirrored, [&exact[0], &exact[1]], behind, 30, &()).unwrap() else { continue };
        let Some(graph) = born.graph else { continue };
        let harmonics = vec![(1, [one(&unit), one(&zero)])];
        let ranges = exact.each_ref().map(one);
        let problem = RangeProblem { mirrored, ranges, behind, harmonics, graph, deepest };
        let Ok(mut proof) = prove(&problem, &RangeEffort::new(effort), &()).unwrap() else { continue };
        if born.whole {
            proof = prove_alone(&problem, proof, &RangeEffort::new(effort), &()).unwrap();
        }
        all.push(Claim::of(Machine { parameters, side }, &proof.certificate));
    }
    all
}

/// So many random oscillators with one wall, or two.
fn motions_are_those_of_ranges(mirrored: bool, trials: u32, seed: u64) {
    let trials: u32 = samples(trials.into());
    let mut random = Random(crate::samples::seed(seed));
    let [mut ranges, mut words, mut alone, mut others, mut starts, mut judged] = [0; 6];
    for _ in 0..trials {
        for claim in claims(mirrored, &drawn(&mut random), 40_000) {
            // The simulator's distances are absolute: at small depths all of a motion is lost in them.
            let cells: Vec<&Cell> = claim.cells.iter().filter(|cell| cell.depth[1] > 1e-4).collect();
            ranges += usize::from(!cells.is_empty());
            for cell in &cells {
                for _ in 0..10 {
                    claim.at(&mut random, cell).confirm(&mut random);
                    words += 1;
                }
                let Some(strength) = cell.alone else { continue };
                alone += 1;
                for _ in 0..20 {
                    others += usize::from(claim.at(&mut random, cell).finds(&mut random, strength));
                }
                judged += claim.at(&mut random, cell).follow(&mut random, strength);
                starts += STARTS;
            }
        }
    }
    println!(
        "{ranges} ranges, {words} random words; {alone} cells without others, {others} words found there, {starts} starts, {judged} impacts judged"
    );
    assert!(crate::samples::tried(ranges, 0) && crate::samples::tried(words, 0));
    assert!(trials < 4 || ranges > 2 && alone > 2 && others > 10 && judged > 0);
}

#[test]
fn motions_of_random_oscillators_are_those_of_their_ranges() {
    motions_are_those_of_ranges(false, 2, 36);
}

#[test]
fn motions_between_mirrored_walls_are_those_of_their_ranges() {
    motions_are_those_of_ranges(true, 3, 37);
}
