//! How far ranges are proved of random oscillators, and how far the motions go on in truth.
//!
//!     cargo bench -p grazing-scenes --bench ranges -- 500 [SEED] [EFFORT] >ranges.csv
//!     cargo bench -p grazing-scenes --bench ranges -- 350..500 [SEED] [EFFORT] >>ranges.csv   (no head)
//!     cargo bench -p grazing-scenes --bench ranges -- ranges.csv
//!     cargo bench -p grazing-scenes --bench ranges -- orbits 500 [SEED] [EFFORT] >orbits.csv
//!     cargo bench -p grazing-scenes --bench ranges -- orbits.csv
//!
//! The second and the fourth command set the tables of docs/ranges.md from such files. Of each oscillator
//! (natural over drive frequency from 0.1 to 3 and damping ratio from 0.003 to 0.5, both log-uniform,
//! restitution from 0.3 to 1, one fixed stop, F cos t) both sides of the touch: a line per side for the whole
//! graph that is born, or for each orbit of one impact. The truth is followed in floats, by other formulas
//! than the library's (`truth`): periodic words of up to six impacts, from the touch to where the first of
//! them is no motion or no longer alone (a fold, a flip). Without a number of oscillators or a file it does
//! nothing. Cost: some 10 s of processor time for an oscillator.

#[path = "ranges/orbits.rs"]
mod orbits;
#[path = "ranges/summary.rs"]
mod summary;
#[path = "ranges/truth.rs"]
mod truth;

use std::env;

use grazing_scenes::{
    num_rational::BigRational,
    number::parse_rational,
    search::range::{
        Born, NothingProblem, RangeEffort, RangeEnd, RangeProblem, born, prove, prove_alone, prove_farther,
        prove_nothing,
    },
};
use num_traits::ToPrimitive;
use rayon::prelude::*;
use truth::{Floats, words};

/// The greatest depths that tasks ask for, before the touch and beyond it, and the longest letters.
const DEEPEST: [f64; 2] = [4.0, 0.999];
const LONGEST: u64 = 30;

/// c, k, τ as decimals.
struct Machine([String; 3]);

/// A line of the file.
struct Line {
    machine: usize,
    side: &'static str,
    /// "chaos", "one", "nothing", "open".
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

const HEAD: &str = "machine,side,what,proved,reached,proof_ends,motion_ends,part,alone";

impl std::fmt::Display for Line {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Line { machine, side, what, proved, reached, proof_ends, motion_ends, part, alone } = self;
        write!(
            f,
            "{machine},{side},{what},{proved:e},{reached:e},{proof_ends},{motion_ends},{part:e},{alone:e}"
        )
    }
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

fn lines(index: usize, machine: &Machine, effort: u64) -> Vec<Line> {
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
        let known = born(false, [&exact[0], &exact[1]], behind, LONGEST, &()).expect("no interruption");
        let (graph, whole) = match known {
            Some(Born { graph: Some(graph), whole, .. }) => (graph, whole),
            Some(Born { graph: None, whole: true, .. }) => {
                let problem = NothingProblem { mirrored: false, ranges, harmonics, deepest };
                let (proved, end) =
                    match prove_nothing(&problem, &RangeEffort::new(effort), &()).expect("no interruption") {
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
        let problem = RangeProblem { mirrored: false, ranges, behind, harmonics, graph, deepest };
        let depth = |x: &BigRational| x.to_f64().unwrap_or(0.0);
        let judge = |problem: &RangeProblem, effort: u64, whole: bool| match prove(
            problem,
            &RangeEffort::new(effort),
            &(),
        )
        .expect("no interruption")
        {
            Ok(proof) if whole => {
                let proof =
                    prove_alone(problem, proof, &RangeEffort::new(effort), &()).expect("no interruption");
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
        let part = prove_farther(&problem, proved, &RangeEffort::new(effort), &()).expect("no interruption");
        let part = part.map_or(0.0, |(_, proof)| depth(&proof.depth));
        line(what.into(), proved, least, end, [part, alone]);
    }
    all
}

fn said(end: &RangeEnd) -> String {
    match end {
        RangeEnd::Asked => "asked".into(),
        RangeEnd::Map => "map".into(),
        RangeEnd::Work => "work".into(),
        RangeEnd::Unbounded => "unbounded".into(),
        RangeEnd::Wide => "wide".into(),
        RangeEnd::Refused(why) => why.split(['(', ')']).nth(1).unwrap_or("refused").to_string(),
    }
}

/// The words that are no range.
fn plain(words: &[String]) -> impl Iterator<Item = &str> {
    words.iter().map(String::as_str).filter(|word| !word.contains(".."))
}

/// How many oscillators are run before their lines are printed.
const CHUNK: usize = 8;

fn main() {
    let words: Vec<String> = env::args().skip(1).collect();
    if let Some(file) = words.iter().find(|word| word.ends_with(".csv")) {
        let text = std::fs::read_to_string(file).expect("the file is there");
        return if text.starts_with(orbits::HEAD) { orbits::print(&text) } else { summary::print(&text) };
    }
    let single = words.iter().any(|word| word == "orbits");
    let (from, numbers) = match words.iter().find_map(|word| word.split_once("..")) {
        Some((from, to)) => {
            (from.parse().expect("a number before .."), [to].into_iter().chain(plain(&words)).collect())
        }
        None => (0, plain(&words).collect::<Vec<_>>()),
    };
    let numbers: Vec<u64> = numbers.iter().filter_map(|x| x.parse().ok()).collect();
    let Some(&count) = numbers.first() else { return };
    let seed = numbers.get(1).copied().unwrap_or(20);
    // For each claim.
    let effort = numbers.get(2).copied().unwrap_or(400_000);
    let one = |i: &u64| {
        let machine = machine(seed.wrapping_mul(1_000_003).wrapping_add(*i));
        let exact = machine.0.each_ref().map(|x| parse_rational(x).expect("a decimal"));
        let index = *i as usize;
        match single {
            true => orbits::lines(index, &exact, &machine, effort).iter().map(ToString::to_string).collect(),
            false => lines(index, &machine, effort).iter().map(ToString::to_string).collect::<Vec<_>>(),
        }
    };
    if from == 0 {
        println!("{}", if single { orbits::HEAD } else { HEAD });
    }
    for some in (from..count).collect::<Vec<_>>().chunks(CHUNK) {
        let all: Vec<String> = some.par_iter().flat_map_iter(one).collect();
        all.iter().for_each(|line| println!("{line}"));
    }
}
