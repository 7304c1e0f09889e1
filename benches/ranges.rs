//! How far ranges are proved of random oscillators, and how far the motions go on in truth.
//!
//!     cargo bench --bench ranges -- 500 [SEED] [EFFORT] >ranges.csv
//!
//! Of each oscillator (natural over drive frequency from 0.1 to 3 and damping ratio from 0.003 to 0.5, both
//! log-uniform, restitution from 0.3 to 1, one fixed stop, F cos t) both sides of the touch: a line per side
//! for the whole graph that is born, and one for each orbit of one impact. The truth is followed in floats,
//! by other formulas than the library's: periodic words of up to six impacts, from the touch to where the
//! first of them is no motion or no longer alone (a fold, a flip). The summary goes to standard error.
//! Without a number of oscillators it does nothing. Cost: some 10 s of processor time for an
//! oscillator.

use std::env;

use grazing::{
    num_rational::BigRational,
    number::parse_rational,
    search::{
        chaos::LetterGraph,
        range::{
            Born, NothingProblem, RangeEffort, RangeEnd, RangeProblem, born, prove, prove_alone,
            prove_farther, prove_nothing, single_orbits,
        },
    },
};
use num_traits::ToPrimitive;
use rayon::prelude::*;

/// The greatest depths that tasks ask for, before the touch and beyond it, and the longest letters.
const DEEPEST: [f64; 2] = [4.0, 0.999];
const LONGEST: u64 = 30;
/// The most impacts of a word, and how many words are followed.
const IMPACTS: usize = 6;
const WORDS: usize = 100;

/// c, k, τ as decimals.
struct Machine([String; 3]);

/// The oscillator in floats: q'' = -c q' - k q above the wall σν - 1 + cos t, underdamped.
struct Floats {
    c: f64,
    k: f64,
    tau: f64,
    side: f64,
}

struct Line {
    machine: usize,
    side: &'static str,
    /// "chaos", "one", "nothing", "open"; of an orbit its period.
    what: String,
    proved: f64,
    reached: f64,
    proof_ends: String,
    motion_ends: &'static str,
    /// How far the graph without a letter goes, where that is farther.
    part: f64,
    /// How far it is all that stays near.
    alone: f64,
}

fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}

fn machine(seed: u64) -> Machine {
    let mut state = seed;
    let mut between = |lo: f64, hi: f64| lo + (hi - lo) * random(&mut state);
    let natural = between(0.1f64.ln(), 3f64.ln()).exp();
    let ratio = between(0.003f64.ln(), 0.5f64.ln()).exp();
    let tau = between(0.3, 1.0);
    Machine([2.0 * ratio * natural, natural * natural, tau].map(|x| format!("{x:.6}")))
}

impl Floats {
    /// E(T), by rows.
    fn flow(&self, time: f64) -> [f64; 4] {
        let (half, rate) = (self.c / 2.0, (self.k - self.c * self.c / 4.0).sqrt());
        let (left, (sin, cos)) = ((-half * time).exp(), (rate * time).sin_cos());
        let b = left * sin / rate;
        [left * cos + half * b, b, -self.k * b, left * cos - half * b]
    }

    fn phase(&self, depth: f64, s: f64) -> f64 {
        -(depth * s / 2.0).asin()
    }

    /// The wall over ν at a phase.
    fn place(&self, depth: f64, t: f64) -> f64 {
        self.side - 2.0 * (t / 2.0).sin().powi(2) / depth
    }

    /// The first and the last velocity of a leg, over ν.
    fn leg(&self, depth: f64, n: u64, from: f64, to: f64) -> [f64; 2] {
        let [t, u] = [from, to].map(|s| self.phase(depth, s));
        let [e11, e12, e21, e22] = self.flow(std::f64::consts::TAU * n as f64 + u - t);
        let a = (self.place(depth, u) - e11 * self.place(depth, t)) / e12;
        [a, e21 * self.place(depth, t) + e22 * a]
    }

    /// s - 2 (a + τ p)/(1 + τ), around a word.
    fn law(&self, depth: f64, word: &[u64], s: &[f64]) -> Vec<f64> {
        let m = word.len();
        let legs: Vec<[f64; 2]> = (0..m).map(|i| self.leg(depth, word[i], s[i], s[(i + 1) % m])).collect();
        let strength = |i: usize| 2.0 * (legs[i][0] + self.tau * legs[(i + m - 1) % m][1]) / (1.0 + self.tau);
        (0..m).map(|i| s[i] - strength(i)).collect()
    }

    /// Newton's method; with the determinant's sign at the end.
    fn solve(&self, depth: f64, word: &[u64], start: &[f64]) -> Option<(Vec<f64>, f64)> {
        let mut s = start.to_vec();
        for _ in 0..12 {
            let law = self.law(depth, word, &s);
            let mut rows: Vec<Vec<f64>> = vec![Vec::new(); s.len()];
            for j in 0..s.len() {
                let step = 1e-6 * (1.0 + s[j].abs());
                let at = |by: f64| {
                    let mut moved = s.clone();
                    moved[j] += by;
                    self.law(depth, word, &moved)
                };
                let (above, below) = (at(step), at(-step));
                rows.iter_mut()
                    .enumerate()
                    .for_each(|(i, row)| row.push((above[i] - below[i]) / (2.0 * step)));
            }
            let (change, sign) = eliminate(rows, law)?;
            s.iter_mut().zip(&change).for_each(|(s, by)| *s -= by);
            let size = s.iter().fold(1.0, |most: f64, s| most.max(s.abs()));
            if s.iter().any(|s| !s.is_finite()) {
                return None;
            }
            if change.iter().all(|by| by.abs() < 1e-9 * size) {
                return Some((s, sign));
            }
        }
        None
    }

    /// What is wrong with a solution, if it is no motion.
    fn fault(&self, depth: f64, word: &[u64], s: &[f64]) -> Option<&'static str> {
        let m = word.len();
        for i in 0..m {
            let (from, to) = (s[i], s[(i + 1) % m]);
            let [a, p] = self.leg(depth, word[i], from, to);
            if a <= from / 2.0 || p >= to / 2.0 {
                return Some("speed 0");
            }
            let [t, u] = [from, to].map(|s| self.phase(depth, s));
            let time = std::f64::consts::TAU * word[i] as f64 + u - t;
            let steps = 24 * word[i];
            let open = (1..steps).all(|j| {
                let after = time * j as f64 / steps as f64;
                let [e11, e12, ..] = self.flow(after);
                let q = e11 * self.place(depth, t) + e12 * a;
                q > self.place(depth, t + after)
            });
            if !open {
                return Some("touch");
            }
        }
        None
    }

    /// To which depth a word is a motion, alone, and what ends it.
    fn end(&self, word: &[u64], deepest: f64) -> (f64, &'static str) {
        let zeros = vec![0.0; word.len()];
        let (mut depth, mut step) = (1e-10, 1.1);
        let start: Vec<f64> = self.law(depth, word, &zeros).iter().map(|x| -x).collect();
        let Some((mut s, first)) = self.solve(depth, word, &start) else { return (0.0, "fold") };
        if let Some(fault) = self.fault(depth, word, &s) {
            return (0.0, fault);
        }
        let mut reason = "fold";
        while step > 1.00003 {
            if depth >= deepest {
                return (deepest, "asked");
            }
            let next = (depth * step).min(deepest);
            let found = match self.solve(next, word, &s) {
                None => Err("fold"),
                Some((there, _))
                    if there.iter().zip(&s).any(|(a, b)| (a - b).abs() > 0.3 * (1.0 + b.abs())) =>
                {
                    Err("fold")
                }
                Some((_, sign)) if sign != first => Err("fold or flip"),
                Some((there, _)) => self.fault(next, word, &there).map_or(Ok(there), Err),
            };
            match found {
                Ok(there) => (s, depth) = (there, next),
                Err(why) => {
                    reason = why;
                    step = step.sqrt();
                }
            }
        }
        (depth, reason)
    }
}

/// The solution of a linear system, and the sign of its determinant.
fn eliminate(mut rows: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<(Vec<f64>, f64)> {
    let n = right.len();
    let mut sign = 1.0;
    for i in 0..n {
        let pivot = (i..n).max_by(|&a, &b| rows[a][i].abs().total_cmp(&rows[b][i].abs()))?;
        if rows[pivot][i] == 0.0 || !rows[pivot][i].is_finite() {
            return None;
        }
        if pivot != i {
            rows.swap(pivot, i);
            right.swap(pivot, i);
            sign = -sign;
        }
        sign *= rows[i][i].signum();
        for j in i + 1..n {
            let factor = rows[j][i] / rows[i][i];
            let (above, below) = rows.split_at_mut(j);
            below[0][i..].iter_mut().zip(&above[i][i..]).for_each(|(x, y)| *x -= factor * y);
            right[j] -= factor * right[i];
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| rows[i][j] * right[j]).sum();
        right[i] = (right[i] - known) / rows[i][i];
    }
    Some((right, sign))
}

/// Closed paths of up to so many letters, each once, and the periods along them.
fn words(graph: &LetterGraph) -> Vec<Vec<u64>> {
    let mut all = Vec::new();
    let mut paths: Vec<Vec<usize>> = (0..graph.letters.len()).map(|v| vec![v]).collect();
    for _ in 0..IMPACTS {
        for path in &paths {
            let turned = (1..path.len()).map(|i| [&path[i..], &path[..i]].concat());
            if graph.next[path[path.len() - 1]].contains(&path[0])
                && turned.min().is_none_or(|least| *path <= least)
            {
                all.push(path.iter().map(|&v| graph.letters[v]).collect());
            }
        }
        if all.len() >= WORDS {
            break;
        }
        let longer = |path: &Vec<usize>| {
            let next = &graph.next[path[path.len() - 1]];
            next.iter().map(|&v| [path.clone(), vec![v]].concat()).collect::<Vec<_>>()
        };
        paths = paths.iter().flat_map(longer).collect();
    }
    all.truncate(WORDS);
    all
}

fn lines(index: usize, machine: &Machine, effort: RangeEffort) -> Vec<Line> {
    let exact = machine.0.each_ref().map(|x| parse_rational(x).expect("a decimal"));
    let [c, k, tau] = machine.0.each_ref().map(|x| x.parse::<f64>().expect("a decimal"));
    let both = |x: &BigRational| [x.clone(), x.clone()];
    let [one, zero] = [1, 0].map(|n| BigRational::from_integer(n.into()));
    let mut all = Vec::new();
    for behind in [false, true] {
        let side = if behind { "beyond" } else { "before" };
        let (deepest, floats) =
            (DEEPEST[usize::from(behind)], Floats { c, k, tau, side: if behind { 1.0 } else { -1.0 } });
        let mut line = |what: String,
                        proved: f64,
                        reached: (f64, &'static str),
                        proof_ends: String,
                        [part, alone]: [f64; 2]| {
            all.push(Line {
                machine: index,
                side,
                what,
                proved,
                reached: reached.0,
                proof_ends,
                motion_ends: reached.1,
                part,
                alone,
            });
        };
        let harmonics = vec![(1, [both(&one), both(&zero)])];
        let ranges = exact.each_ref().map(both);
        let known = born([&exact[0], &exact[1]], behind, LONGEST, &()).expect("no interruption");
        let (graph, whole) = match known {
            Some(Born { graph: Some(graph), whole, .. }) => (graph, whole),
            Some(Born { graph: None, whole: true, .. }) => {
                let problem = NothingProblem { ranges, harmonics, deepest };
                let (proved, end) = match prove_nothing(&problem, effort, &()).expect("no interruption") {
                    _ if !behind => (0.0, "not asked".into()),
                    Ok(proof) => (proof.depth.to_f64().unwrap_or(0.0), said(&proof.end)),
                    Err(end) => (0.0, said(&end)),
                };
                line("nothing".into(), proved, (0.0, ""), end, [0.0; 2]);
                continue;
            }
            _ => {
                line("open".into(), 0.0, (0.0, ""), String::new(), [0.0; 2]);
                continue;
            }
        };
        let problem = RangeProblem { ranges, behind, harmonics, graph, deepest };
        let depth = |x: &BigRational| x.to_f64().unwrap_or(0.0);
        let judge =
            |problem: &RangeProblem, effort: RangeEffort, whole: bool| match prove(problem, effort, &())
                .expect("no interruption")
            {
                Ok(proof) if whole => {
                    let proof = prove_alone(problem, proof, effort, &()).expect("no interruption");
                    (depth(&proof.depth), said(&proof.end), proof.alone.as_ref().map_or(0.0, depth))
                }
                Ok(proof) => (depth(&proof.depth), said(&proof.end), 0.0),
                Err(end) => (0.0, said(&end), 0.0),
            };
        let (proved, end, alone) = judge(&problem, effort, whole);
        let least = words(&problem.graph)
            .iter()
            .map(|word| floats.end(word, deepest))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .expect("a cycle");
        let what = if problem.graph.letters.len() == 1 { "one" } else { "chaos" };
        let part = prove_farther(&problem, proved, effort, &()).expect("no interruption");
        let part = part.map_or(0.0, |(_, proof)| depth(&proof.depth));
        line(what.into(), proved, least, end, [part, alone]);
        let orbits = single_orbits(&problem.graph);
        let share = RangeEffort(effort.0 / 4.max(orbits.len() as u64));
        for graph in orbits {
            let n = graph.letters[0];
            let (proved, end, _) = judge(&RangeProblem { graph, ..problem.clone() }, share, false);
            let (first, then) = (floats.end(&[n], deepest), floats.end(&[n, n], deepest));
            let reached = if then.0 < first.0 { (then.0, "flip") } else { first };
            line(n.to_string(), proved, reached, end, [0.0; 2]);
        }
    }
    all
}

fn said(end: &RangeEnd) -> String {
    match end {
        RangeEnd::Asked => "asked".into(),
        RangeEnd::Map => "map".into(),
        RangeEnd::Work => "work".into(),
        RangeEnd::Unbounded => "unbounded".into(),
        RangeEnd::Refused(why) => why.split(['(', ')']).nth(1).unwrap_or("refused").to_string(),
    }
}

/// The part of the drive's amplitude at the touch.
fn part(side: &str, depth: f64) -> f64 {
    if side == "beyond" { depth / (1.0 - depth) } else { depth / (1.0 + depth) }
}

fn quantiles(mut all: Vec<f64>) -> String {
    all.sort_by(f64::total_cmp);
    let at = |share: f64| {
        all.get((share * (all.len() as f64 - 1.0)).round() as usize).copied().unwrap_or(f64::NAN)
    };
    format!("{:.3} {:.3} {:.3} {:.3}", at(0.0), at(0.05), at(0.25), at(0.5))
}

fn main() {
    let numbers: Vec<u64> = env::args().skip(1).filter_map(|x| x.parse().ok()).collect();
    let Some(&count) = numbers.first() else { return };
    let seed = numbers.get(1).copied().unwrap_or(20);
    let effort = RangeEffort(numbers.get(2).copied().unwrap_or(RangeEffort::default().0));
    let one = |i: u64| lines(i as usize, &machine(seed.wrapping_mul(1_000_003).wrapping_add(i)), effort);
    let all: Vec<Line> = (0..count).into_par_iter().flat_map_iter(one).collect();
    println!("machine,side,what,proved,reached,proof_ends,motion_ends,part,alone");
    for Line { machine, side, what, proved, reached, proof_ends, motion_ends, part, alone } in &all {
        println!(
            "{machine},{side},{what},{proved:e},{reached:e},{proof_ends},{motion_ends},{part:e},{alone:e}"
        );
    }
    for side in ["before", "beyond"] {
        for what in ["chaos", "one", "nothing", "open", "orbits"] {
            let orbit = |line: &&Line| line.what.parse::<u64>().is_ok();
            let some: Vec<&Line> = all
                .iter()
                .filter(|line| line.side == side && (line.what == what || what == "orbits" && orbit(line)))
                .collect();
            let shares = [0.001, 0.01, 0.1, 0.5].map(|least| {
                let many = |f: &dyn Fn(&Line) -> f64| {
                    some.iter().filter(|line| part(side, f(line)) >= least).count()
                };
                format!("{}/{}", many(&|line| line.proved), many(&|line| line.reached))
            });
            let ratio = |line: &&Line| line.proved / line.reached;
            let long: Vec<&Line> =
                some.iter().copied().filter(|line| part(side, line.reached) >= 0.01).collect();
            eprintln!(
                "{side} {what}: {} sides; >= 0.1, 1, 10, 50 %: {}; proved/true, least, 5 %, quartile, median: {}; of those >= 1 %: {}",
                some.len(),
                shares.join(" "),
                quantiles(some.iter().filter(|line| line.reached > 0.0).map(ratio).collect()),
                quantiles(long.iter().map(|line| line.proved / line.reached).collect()),
            );
            let mut ends: Vec<(String, usize)> = Vec::new();
            for line in &some {
                let end = format!("{} ({})", line.proof_ends, line.motion_ends);
                match ends.iter_mut().find(|(known, _)| *known == end) {
                    Some((_, count)) => *count += 1,
                    None => ends.push((end, 1)),
                }
            }
            ends.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
            let ends: Vec<String> = ends.iter().map(|(end, count)| format!("{end} {count}")).collect();
            eprintln!("    {}", ends.join(", "));
            let farther = some.iter().filter(|line| line.part > line.proved).count();
            if farther > 0 {
                eprintln!("    a part goes farther: {farther}");
            }
            let alone: Vec<f64> =
                some.iter().filter(|line| line.proved > 0.0).map(|line| line.alone / line.proved).collect();
            if alone.iter().any(|&x| x > 0.0) {
                let from = alone.iter().filter(|&&x| x > 0.0).count();
                eprintln!(
                    "    alone from the touch on: {from}/{}; of the range proved: {}",
                    some.len(),
                    quantiles(alone)
                );
            }
        }
    }
}
