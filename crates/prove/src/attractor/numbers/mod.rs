//! How many machines are proved: drawn at random, with stops of one to three harmonics. Run with
//! `GRAZING_SAMPLES=100 cargo test -p grazing-prove --lib attractor::numbers -- --nocapture` for 500.

mod cells;
mod seen;

use std::f64::consts::TAU;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::{AttractorProblem, Window, prove_attractor, windows};
use crate::{
    certificate::single::Word,
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

/// Of machines with these λ₁ how many are proved chaotic up to 1.01 and 1.001 of the value at the touch, and
/// with tolerances of c, k and τ; and the longest text.
fn counted(seed: u64, trials: usize, lambdas: [f64; 2]) -> [usize; 5] {
    let mut random = Random(seed);
    let mut found = [0; 5];
    for _ in 0..trials {
        let mut problem = machine(&mut random, lambdas);
        let mut proved = |problem: &AttractorProblem, depth: f64| {
            let proof =
                prove_attractor(&AttractorProblem { deepest: depth, ..problem.clone() }, &()).unwrap();
            let Ok(proof) = proof else { return [false; 2] };
            found[4] = found[4].max(proof.accepted.text().len());
            [proof.depth.to_f64().unwrap() >= 0.999 * depth, true]
        };
        let [far, some] = proved(&problem, 1.0 - 1.0 / 1.01);
        let [near, _] = proved(&problem, 1.0 - 1.0 / 1.001);
        // c = 2d/w and k = 1/w².
        for (range, part) in problem.ranges.iter_mut().zip([2e-3, 2e-3, 1e-2]) {
            let middle = range[0].to_f64().unwrap();
            *range = [exact(middle * (1.0 - part)), exact(middle * (1.0 + part))];
        }
        let [_, wide] = proved(&problem, 1.0 - 1.0 / 1.01);
        for (count, holds) in found.iter_mut().zip([far, near, some, wide]) {
            *count += usize::from(holds);
        }
    }
    found
}

#[test]
fn most_machines_above_two_thirds_are_proved() {
    let samples = samples::<usize>(1);
    let each = 5 * samples;
    for (lambdas, most, least) in [
        ([0.667, 0.7], each / 5, [0.0, 0.3, 0.9, 0.5]),
        ([0.7, 0.75], each * 2 / 5, [0.5, 0.8, 0.95, 0.8]),
        ([0.75, 0.8], each / 5, [0.7, 0.9, 1.0, 0.9]),
        ([0.8, 0.95], each * 2 / 5, [0.9, 0.9, 1.0, 0.95]),
    ] {
        let [far, near, some, wide, size] = counted(7, most, lambdas);
        let share = |count: usize| 100.0 * count as f64 / most as f64;
        println!(
            "lambda_1 {lambdas:?}: of {most} machines {:.1} % to 1.01 of the touch, {:.1} % to 1.001, {:.1} % to some \
             value, {:.1} % with tolerances; {size} bytes",
            share(far),
            share(near),
            share(some),
            share(wide)
        );
        for (count, least) in [far, near, some, wide].into_iter().zip(least) {
            assert!(count as f64 >= least * most as f64 - 1.0, "{lambdas:?}: {count} of {most}");
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
