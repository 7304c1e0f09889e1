//! How many machines are proved: drawn at random, with stops of one to three harmonics. Run with
//! `GRAZING_SAMPLES=100 cargo test -p grazing-prove --lib attractor::numbers::most -- --nocapture` for 600.

mod cells;
mod seen;

use std::{f64::consts::TAU, fmt};

use grazing_base::processor::thread_seconds;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use self::seen::Seen;
use super::{AttractorProblem, AttractorProof, Window, prove_attractor, windows};
use crate::{
    certificate::{self, single::Word},
    chaos::Term,
    range::{RangeEffort, SingleProblem, prove_single},
};

/// Numbers that look random, the same in every run (Knuth's MMIX generator).
struct Random(u64);

impl Random {
    fn part(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.part()
    }
}

/// So many, or more if that is asked for.
fn samples<T: TryFrom<u64, Error: std::fmt::Debug>>(number: u64) -> T {
    let times = std::env::var("GRAZING_SAMPLES").ok().and_then(|text| text.parse().ok()).unwrap_or(1u64);
    T::try_from(number * times).unwrap()
}

const DIGITS: f64 = 1e9;

fn exact(x: f64) -> BigRational {
    BigRational::new(BigInt::from((x * DIGITS).round() as i64), BigInt::from(DIGITS as i64))
}

/// A number, and all that are as near as twice a decimal's last digit.
fn about(x: f64) -> [BigRational; 2] {
    [exact(x - 2.0 / DIGITS), exact(x + 2.0 / DIGITS)]
}

/// A wall of so many harmonics as it is seen from its highest top.
fn wall(random: &mut Random, harmonics: u64) -> Vec<Term> {
    if harmonics == 1 {
        let number = |x: i64| [0, 1].map(|_| BigRational::from_integer(x.into()));
        return vec![(1, [number(1), number(0)])];
    }
    let all: Vec<(f64, f64, f64)> = (1..=harmonics)
        .map(|j| {
            let size = if j == 1 { 1.0 } else { random.between(0.0, 0.6 / (j * j) as f64) };
            (j as f64, size, random.between(0.0, TAU))
        })
        .collect();
    let at = |t: f64| all.iter().map(|(j, size, phase)| size * (j * t + phase).cos()).sum::<f64>();
    let slope = |t: f64| all.iter().map(|(j, size, phase)| -j * size * (j * t + phase).sin()).sum::<f64>();
    let first = (0..2000).map(|i| TAU * f64::from(i) / 2000.0).max_by(|x, y| at(*x).total_cmp(&at(*y)));
    let (mut lo, mut hi) = (first.unwrap() - TAU / 2000.0, first.unwrap() + TAU / 2000.0);
    for _ in 0..80 {
        let middle = 0.5 * (lo + hi);
        if slope(middle) > 0.0 { lo = middle } else { hi = middle }
    }
    let height = at(lo);
    let term = |(j, size, phase): &(f64, f64, f64)| {
        let (sin, cos) = (j * lo + phase).sin_cos();
        (*j as u64, [about(size / height * cos), about(-size / height * sin)])
    };
    all.iter().map(term).collect()
}

/// A machine with λ₁ between two numbers: d from 1.02 to 4, τ from 0.1 to 1.
fn machine(random: &mut Random, [least, greatest]: [f64; 2]) -> AttractorProblem {
    let (d, lambda) = (random.between(0.0, 1.37).exp() * 1.02, random.between(least, greatest));
    let w = TAU * (d - (d * d - 1.0).sqrt()) / -lambda.ln();
    let point = |x: f64| [0, 1].map(|_| exact(x));
    let ranges = [point(2.0 * d / w), point(1.0 / (w * w)), point(random.between(0.1, 1.0))];
    let harmonics = 1 + (3.0 * random.part()) as u64;
    AttractorProblem { ranges, harmonics: wall(random, harmonics), deepest: 0.0 }
}

/// What is measured of certificates: how many there are, the longest, the longest search and check in seconds
/// of a processor, and proved growths over those that motions show.
#[derive(Default)]
struct Measured {
    proved: usize,
    size: usize,
    search: f64,
    check: f64,
    parts: Vec<f64>,
}

impl Measured {
    /// What a search finds.
    fn timed<T>(&mut self, search: impl FnOnce() -> T) -> T {
        let start = thread_seconds();
        let found = search();
        self.search = self.search.max(thread_seconds() - start);
        found
    }

    /// A certificate, which motions in floats must not refute.
    fn add(&mut self, text: &str, growth: f64, seen: &Seen) {
        let start = thread_seconds();
        assert!(certificate::check(&mut text.as_bytes()).is_ok());
        self.check = self.check.max(thread_seconds() - start);
        self.proved += 1;
        self.size = self.size.max(text.len());
        let seen = seen.least_growth(4, 150);
        assert!(growth < seen * (1.0 + 1e-6), "{growth} proved, {seen} seen");
        self.parts.push(growth / seen);
    }
}

impl fmt::Display for Measured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut parts = self.parts.clone();
        parts.sort_by(f64::total_cmp);
        let middle = parts.get(parts.len() / 2).copied().unwrap_or(f64::NAN);
        let Measured { size, search, check, .. } = self;
        write!(f, "{size} bytes, found in {search:.3} s, checked in {:.1} ms, ", 1e3 * check)?;
        write!(f, "in the median {middle:.3} of the growth that motions show")
    }
}

/// Whether of so many machines enough are proved for this share of all to be: fewer have a chance of 1/1000.
fn enough(proved: usize, number: usize, share: f64) -> bool {
    let ratio = (share / (1.0 - share)).ln();
    let mut log = number as f64 * (1.0 - share).ln();
    let mut chance = log.exp();
    for k in 1..=proved {
        log += ratio + ((number - k + 1) as f64 / k as f64).ln();
        chance += log.exp();
    }
    chance > 1e-3
}

#[test]
fn a_sample_is_enough_unless_it_is_unlikely() {
    // By hand: 1/16, 5/16 and 11/16 of four throws, all but 0.03² and 0.03 of two.
    for (proved, number, share, expected) in [
        (0, 4, 0.5, true),
        (0, 10, 0.5, false),
        (1, 10, 0.5, true),
        (0, 2, 0.97, false),
        (1, 2, 0.97, true),
        (965, 1000, 0.97, true),
        (950, 1000, 0.97, false),
        (1000, 1000, 0.97, true),
    ] {
        assert_eq!(enough(proved, number, share), expected, "{proved} of {number}, {share}");
    }
}

/// Machines with these λ₁: of how many a range is proved to 1.01 and to 1.001 times the value at the touch,
/// and with tolerances to some value; and how many have some range.
fn counted(seed: u64, trials: usize, lambdas: [f64; 2]) -> ([Measured; 3], usize) {
    let mut random = Random(seed);
    let (mut all, mut some) = ([(); 3].map(|()| Measured::default()), 0);
    for _ in 0..trials {
        let plain = machine(&mut random, lambdas);
        let mut wide = plain.clone();
        // d and w ± 0.1 %, where c = 2d/w and k = 1/w²; τ ± 1 %.
        for (range, part) in wide.ranges.iter_mut().zip([2e-3, 2e-3, 1e-2]) {
            let middle = range[0].to_f64().unwrap();
            *range = [exact(middle * (1.0 - part)), exact(middle * (1.0 + part))];
        }
        for (i, (machine, far)) in [(&plain, 1.01), (&plain, 1.001), (&wide, 1.01)].into_iter().enumerate() {
            let problem = AttractorProblem { deepest: 1.0 - 1.0 / far, ..machine.clone() };
            let Ok(proof) = all[i].timed(|| prove_attractor(&problem, &()).unwrap()) else { continue };
            some += usize::from(i == 0);
            if i == 2 || reaches(&proof, &problem) {
                let seen = Seen::new(&problem, &proof.certificate.setting, &[]);
                all[i].add(proof.accepted.text(), proof.growth, &seen);
            }
        }
    }
    (all, some)
}

/// Whether a proof goes as far as is asked for.
fn reaches(proof: &AttractorProof, problem: &AttractorProblem) -> bool {
    proof.depth.to_f64().unwrap() >= 0.999 * problem.deepest
}

#[test]
fn most_machines_above_two_thirds_are_proved() {
    let samples = samples::<usize>(1);
    for (lambdas, number, least) in [
        ([0.667, 0.7], samples, [0.1, 0.35, 0.75, 0.98]),
        ([0.7, 0.75], 2 * samples, [0.5, 0.93, 0.87, 0.995]),
        ([0.75, 0.8], samples, [0.88, 0.98, 0.9, 0.995]),
        ([0.8, 0.95], 2 * samples, [0.97, 0.99, 0.99, 0.995]),
    ] {
        let (ranges, some) = counted(7, number, lambdas);
        let share = |count: usize| 100.0 * count as f64 / number as f64;
        println!("lambda_1 {lambdas:?}: of {number} machines {:.1} % to some value", share(some));
        for (measured, what) in ranges.iter().zip(["to 1.01 of the touch", "to 1.001", "with tolerances"]) {
            println!("  {:.1} % {what}: {measured}", share(measured.proved));
        }
        let [far, near, wide] = ranges.map(|measured| measured.proved);
        for (count, least) in [far, near, wide, some].into_iter().zip(least) {
            assert!(enough(count, number, least), "{lambdas:?}: {count} of {number}, {least}");
        }
    }
}

/// Between which depths the orbit of a window is proved stable.
fn stable(problem: &AttractorProblem, window: &Window) -> Option<[f64; 2]> {
    let single = SingleProblem {
        mirrored: false,
        ranges: problem.ranges.clone(),
        behind: true,
        harmonics: problem.harmonics.clone(),
        periods: window.periods,
        deepest: 1.3 * window.depths[1],
    };
    let proof = prove_single(&single, &RangeEffort::new(100_000), &()).unwrap().ok()?;
    let ends: Vec<f64> = proof.parts.iter().map(|(depth, _)| depth.to_f64().unwrap()).collect();
    let stable = proof.parts.iter().position(|(_, word)| *word == Word::Stable)?;
    Some([if stable == 0 { 0.0 } else { ends[stable - 1] }, ends[stable]])
}

/// Whether it is at a depth.
fn stable_there(problem: &AttractorProblem, window: &Window, depth: f64) -> bool {
    stable(problem, window).is_some_and(|[from, to]| from < depth && depth < to)
}

/// Of machines with λ₁ between 1/4 and 2/3 the windows that are told, to leading order, are where the orbit
/// of one impact is proved stable, by the certificate of its kind; and nothing is proved to attract there.
#[test]
fn the_orbit_is_proved_stable_in_the_windows_that_are_told() {
    let samples = samples::<usize>(1);
    let mut random = Random(11);
    let (mut told, mut proved, mut farthest) = (0, 0, 0f64);
    for i in 0..samples {
        let mut problem = machine(&mut random, [0.3, 0.62]);
        if i % 2 == 0 {
            problem.harmonics = wall(&mut random, 1);
        }
        for window in windows(&problem).into_iter().skip(1).take(1) {
            told += 1;
            let Some([from, to]) = stable(&problem, &window) else { continue };
            proved += 1;
            let apart = |found: f64, told: f64| (found / told - 1.0).abs();
            farthest = farthest.max(apart(from, window.depths[0])).max(apart(to, window.depths[1]));
            let deep = AttractorProblem { deepest: window.depths[0], ..problem.clone() };
            assert!(prove_attractor(&deep, &()).unwrap().is_err(), "both are proved");
        }
    }
    println!("of {told} windows {proved} have a proved orbit, ends within {farthest:.3} of those told");
    assert!(proved * 2 >= told && told > 0 && farthest < 0.1, "{proved} of {told}: {farthest}");
}
