//! Ranges of random oscillators from their touch on, against where their orbits of one impact end in floats.
//! A sample for `cargo test`; `benches/ranges.rs` does it for as many as one likes, against words of several
//! impacts.

use crate::samples::samples;
use std::f64::consts::TAU;

use grazing_scenes::search::{
    chaos::Term,
    range::{RangeEffort, RangeProblem, SingleProblem, born, prove, prove_single, single_orbits},
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// Numbers that look random, the same in every run (Knuth's MMIX generator).
pub(super) struct Random(pub u64);

impl Random {
    /// From one number to another.
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        lo + (hi - lo) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A fraction of so many places.
fn short(x: f64, places: u32) -> BigRational {
    let scale = 10i64.pow(places);
    BigRational::new(BigInt::from((x * scale as f64).round() as i64), scale.into())
}

/// c, k and τ: a natural frequency from 0.1 to 3 times the drive's, a damping ratio from 0.003 to 0.5.
pub(super) fn drawn(random: &mut Random) -> [BigRational; 3] {
    let (omega, ratio) = (random.between(0.1, 3.0), random.between(0.003f64.ln(), 0.5f64.ln()).exp());
    [short(2.0 * ratio * omega, 6), short(omega * omega, 6), short(random.between(0.3, 1.0), 3)]
}

/// An oscillator at its touch: c, k, τ and σ; g = cos t.
#[derive(Debug, Clone, Copy)]
pub(super) struct Machine {
    pub parameters: [f64; 3],
    pub side: f64,
}

impl Machine {
    pub fn flow(&self, t: f64) -> [f64; 4] {
        let [c, k, _] = self.parameters;
        let omega = (k - c * c / 4.0).sqrt();
        let decay = (-c * t / 2.0).exp();
        let b = decay * (omega * t).sin() / omega;
        let a = decay * (omega * t).cos() + c / 2.0 * b;
        [a, b, -k * b, a - c * b]
    }

    /// α and β of one impact every n periods: a = αQ, p = βQ.
    fn shares(&self, n: f64) -> [f64; 2] {
        let e = self.flow(TAU * n);
        let alpha = (1.0 - e[0]) / e[1];
        [alpha, e[2] + e[3] * alpha]
    }

    /// That orbit at a phase: σν = 1 − g + (1 + τ) g′/(α + τβ), Q, a, p.
    fn orbit(&self, n: f64, t: f64) -> [f64; 4] {
        let ([alpha, beta], tau) = (self.shares(n), self.parameters[2]);
        let depth = self.side * (1.0 - t.cos() - (1.0 + tau) * t.sin() / (alpha + tau * beta));
        let place = self.side - (1.0 - t.cos()) / depth;
        [depth, place, alpha * place, beta * place]
    }

    /// f at three strengths, at a depth.
    fn mean(&self, n: f64, depth: f64, [before, s, after]: [f64; 3]) -> f64 {
        let phase = |s: f64| -(depth * s / 2.0).asin();
        let place = |s: f64| self.side - (1.0 - phase(s).cos()) / depth;
        let leg = |s: f64, next: f64| {
            let e = self.flow(TAU * n + phase(next) - phase(s));
            let a = (place(next) - e[0] * place(s)) / e[1];
            [a, e[2] * place(s) + e[3] * a]
        };
        let tau = self.parameters[2];
        2.0 * (leg(s, after)[0] + tau * leg(before, s)[1]) / (1.0 + tau)
    }

    /// 1 − f_s + f_s⁻ + f_s⁺ on the orbit: 0 where a multiplier is −1.
    fn flip(&self, n: f64, t: f64) -> f64 {
        let [depth, _, a, p] = self.orbit(n, t);
        let tau = self.parameters[2];
        let s = 2.0 * (a + tau * p) / (1.0 + tau);
        let h = 1e-5 * s.abs().max(1e-3);
        let slope = |i: usize| {
            let at = |h: f64| {
                let mut all = [s; 3];
                all[i] += h;
                self.mean(n, depth, all)
            };
            (at(h) - at(-h)) / (2.0 * h)
        };
        1.0 - slope(1) + slope(0) + slope(2)
    }

    /// The depth where the orbit ends, or flips, if that counts: its curve folds, its speed or a gap is 0.
    fn end(&self, n: f64, flips: bool) -> (f64, &'static str) {
        let [alpha, beta] = self.shares(n);
        // g′ = −sin t has the sign of s.
        let way = -(self.side * (alpha + self.parameters[2] * beta)).signum();
        let start = self.flip(n, way * 1e-6).signum();
        let (mut last, mut step, mut t) = (0.0, 1e-9f64, 0.0);
        while t < 1.19 {
            t += step;
            step = (1.01 * step).min(5e-4);
            let [depth, place, a, p] = self.orbit(n, way * t);
            let gap = |i: i32| {
                let since = TAU * f64::from(i) / 200.0;
                let e = self.flow(since);
                1.0 - (way * t + since).cos() + depth * (e[0] * place + e[1] * a - self.side)
            };
            if depth <= last {
                return (last, "fold");
            }
            if a <= p {
                return (last, "speed");
            }
            if (1..200 * n as i32).any(|i| gap(i) < -1e-3 * depth) {
                return (last, "gap");
            }
            if flips && self.flip(n, way * t).signum() != start {
                return (last, "flip");
            }
            last = depth;
        }
        (last, "window")
    }
}

/// A side of a touch: what is born there, how far it is proved, in the amplitude, and how far it goes.
struct Row {
    kind: &'static str,
    proved: f64,
    share: Option<f64>,
}

fn row(machine: &Machine, exact: [&BigRational; 3], effort: u64) -> Option<Row> {
    let beyond = machine.side > 0.0;
    let graph = born(false, [exact[0], exact[1]], beyond, 40, &()).unwrap()?.graph?;
    let one = |x: &BigRational| [x.clone(), x.clone()];
    let [zero, unit] = [0, 1].map(|x| BigRational::from_integer(x.into()));
    let harmonics: Vec<Term> = vec![(1, [one(&unit), one(&zero)])];
    let letters = graph.letters.clone();
    let deepest = if beyond { 0.95 } else { 9.0 };
    for periods in single_orbits(&graph) {
        let (ranges, harmonics) = (exact.map(one), harmonics.clone());
        let problem = SingleProblem { mirrored: false, ranges, behind: beyond, harmonics, periods, deepest };
        let proof = prove_single(&problem, &RangeEffort::new(200_000), &()).unwrap();
        let depth = proof.as_ref().map_or(0.0, |proof| proof.depth.to_f64().unwrap());
        let (end, why) = machine.end(periods as f64, false);
        println!("{machine:?} {periods}: {depth}, {why} at {end}");
        // How near gaps are to 0 is seen at 200 times a period: smaller ends are not told so well.
        if why != "window" && end > 0.05 {
            let end = end.min(deepest);
            assert!(
                0.95 * end < depth && depth < 1.01 * end,
                "{machine:?} {periods}: {depth}, {why} at {end}"
            );
        }
    }
    let problem =
        RangeProblem { mirrored: false, ranges: exact.map(one), behind: beyond, harmonics, graph, deepest };
    let proof = prove(&problem, &RangeEffort::new(effort), &()).unwrap();
    let depth = proof.as_ref().map_or(0.0, |proof| proof.depth.to_f64().unwrap());
    // ν = 1 − F*/F beyond, F*/F − 1 before.
    let proved = if beyond { depth / (1.0 - depth) } else { depth / (1.0 + depth) };
    let share = (letters.len() == 1).then(|| {
        let (end, why) = machine.end(letters[0] as f64, true);
        assert!(depth <= end * 1.002 + 1e-9, "{machine:?} {letters:?}: {depth} beyond {why} at {end}");
        depth / end.min(deepest)
    });
    let kind = match (letters.len() > 1, beyond) {
        (true, true) => "beyond, several letters",
        (true, false) => "before, several letters",
        (false, true) => "beyond, one orbit",
        (false, false) => "before, one orbit",
    };
    let end = match &proof {
        Ok(proof) => format!("{:?}, {} cells", proof.end, proof.certificate.cells.len()),
        Err(end) => format!("{end:?}"),
    };
    println!("{kind}: {machine:?} {letters:?}: nu = {depth}, share {share:?}, {end}");
    Some(Row { kind, proved, share })
}

#[test]
fn ranges_of_random_oscillators_end_before_their_orbits_do() {
    let trials: u32 = samples(1);
    let mut random = Random(35);
    let (mut rows, mut nothing) = (Vec::new(), 0);
    for _ in 0..trials {
        let exact = drawn(&mut random);
        let parameters = exact.each_ref().map(|x| x.to_f64().unwrap());
        for side in [1.0, -1.0] {
            match row(&Machine { parameters, side }, exact.each_ref(), 60_000) {
                Some(row) => rows.push(row),
                None => nothing += 1,
            }
        }
    }
    println!("nothing born, or not decided: {nothing} sides");
    for kind in
        ["beyond, several letters", "before, several letters", "beyond, one orbit", "before, one orbit"]
    {
        let these: Vec<&Row> = rows.iter().filter(|row| row.kind == kind).collect();
        let at_least = |x: f64| these.iter().filter(|row| row.proved >= x).count();
        let counts = [1e-3, 1e-2, 1e-1, 0.5].map(at_least);
        let mut shares: Vec<f64> = these.iter().filter_map(|row| row.share).collect();
        shares.sort_by(f64::total_cmp);
        let of = |x: f64| shares.get((x * shares.len() as f64) as usize).copied();
        println!("{kind}: {} sides, {counts:?}, quartile and median {:?}", these.len(), [of(0.25), of(0.5)]);
    }
    assert!(rows.iter().any(|row| row.proved > 1e-2));
}
