//! Orbits of one impact: how far each is proved along its curve, and how far it goes on in truth.

use std::f64::consts::TAU;

use grazing_scenes::{
    certificate::single::Word,
    num_rational::BigRational,
    search::range::{Born, RangeEffort, SingleProblem, born, prove_single, single_orbits},
};
use num_traits::ToPrimitive;

use super::{DEEPEST, LONGEST, Machine, said, summary::share, truth::Floats};

/// A line of the file.
pub struct Line {
    pub machine: usize,
    pub side: &'static str,
    pub periods: u64,
    pub proved: f64,
    pub reached: f64,
    pub proof_ends: String,
    pub motion_ends: &'static str,
    /// The flip, and between which depths it is proved to be.
    pub flip: f64,
    pub flips: [f64; 2],
    /// Cells of the certificate.
    pub cells: usize,
}

pub const HEAD: &str =
    "machine,side,periods,proved,reached,proof_ends,motion_ends,flip,flip_from,flip_to,cells";

impl std::fmt::Display for Line {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Line { machine, side, periods, proved, reached, proof_ends, motion_ends, flip, flips, cells } =
            self;
        let [from, to] = flips;
        write!(
            f,
            "{machine},{side},{periods},{proved:e},{reached:e},{proof_ends},{motion_ends},{flip:e},{from:e},{to:e},{cells}"
        )
    }
}

impl Floats {
    /// On the curve of the orbit of n periods: to which depth it is a motion, what ends it, and the depth at
    /// which it flips, 0 if it does not. By a walk along the phase, with the law of impact in velocities.
    fn curve(&self, n: u64, deepest: f64) -> (f64, &'static str, f64) {
        const SAMPLES: u64 = 240;
        let time = TAU * n as f64;
        let [e11, e12, e21, e22] = self.flow(time);
        let first = (1.0 - e11) / e12;
        let last = e21 + e22 * first;
        let law = (1.0 + self.tau) / (first + self.tau * last);
        let way = -self.side * law.signum();
        let motion: Vec<(f64, f64)> = (0..=SAMPLES * n)
            .map(|i| {
                let u = time * i as f64 / (SAMPLES * n) as f64;
                let [a, b, ..] = self.flow(u);
                (u, a + b * first)
            })
            .collect();
        let depth = |t: f64| self.side * (1.0 - t.cos() - law * t.sin());
        // Along the curve the multipliers' product is fixed, their sum is as on a stroboscopic map.
        let flips = |t: f64| {
            let place = -law * t.sin();
            let bend = self.c * t.sin() - self.k * place + t.cos();
            let jump = (first - last) * place;
            let sum = -self.tau * (e11 + e22) - e12 * (1.0 + self.tau).powi(2) * bend / jump;
            1.0 + sum + self.tau * self.tau * (-self.c * time).exp()
        };
        let fault = |t: f64| {
            if self.side * way * (t.sin() - law * t.cos()) <= 0.0 {
                return Some("fold");
            }
            let place = -law * t.sin();
            if place * (first - last) <= 0.0 {
                return Some("speed 0");
            }
            let small = depth(t) < 1e-5;
            let margin = if small { 0.0 } else { 1e-3 };
            let at = |u: f64, x: f64| place * (x - 1.0) + t.cos() - (t + u).cos();
            let gap: Vec<f64> = motion.iter().map(|&(u, x)| at(u, x)).collect();
            let touches = gap.windows(3).zip(motion.windows(3)).any(|(three, times)| {
                let [a, b, c] = [three[0], three[1], three[2]];
                // The least of the parabola through three samples, if it is between them, says where to look;
                // of small depths it says all, for what is looked at is of their square.
                let bend = a - 2.0 * b + c;
                let slope = (c - a) / 2.0;
                let near =
                    bend > 0.0 && slope.abs() <= bend && b - slope * slope / (2.0 * bend) <= margin * bend;
                let (from, to) = (times[0].0, times[2].0);
                near && (small
                    || (1..400).any(|i| {
                        let u = from + (to - from) * f64::from(i) / 400.0;
                        let [e11, e12, ..] = self.flow(u);
                        u > 0.0 && u < time && at(u, e11 + e12 * first) <= 0.0
                    }))
            });
            let open = gap[1..gap.len() - 1].iter().all(|&z| z > 0.0);
            (touches || !open).then_some("touch")
        };
        let (mut t, mut step, mut reason, mut flip) = (1e-8, 1.1, "fold", 0.0);
        if let Some(fault) = fault(way * t) {
            return (0.0, fault, 0.0);
        }
        while step > 1.0 + 1e-7 {
            if depth(way * t) >= deepest {
                return (deepest, "asked", flip);
            }
            if t > 3.1 {
                return (depth(way * t), "asked", flip);
            }
            let next = t * step;
            match fault(way * next) {
                None => {
                    if flip == 0.0 && flips(way * t) * flips(way * next) < 0.0 {
                        let (mut lo, mut hi) = (t, next);
                        for _ in 0..60 {
                            let middle = (lo + hi) / 2.0;
                            if flips(way * lo) * flips(way * middle) < 0.0 {
                                hi = middle
                            } else {
                                lo = middle
                            }
                        }
                        flip = depth(way * lo);
                    }
                    t = next;
                }
                Some(why) => {
                    reason = why;
                    step = step.sqrt();
                }
            }
        }
        (depth(way * t), reason, flip)
    }
}

/// Of both sides every letter that may follow itself.
pub fn lines(machine: usize, exact: &[BigRational; 3], floats: &Machine, effort: u64) -> Vec<Line> {
    let [c, k, tau] = floats.0.each_ref().map(|x| x.parse::<f64>().expect("a decimal"));
    let both = |x: &BigRational| [x.clone(), x.clone()];
    let [one, zero] = [1, 0].map(|n| BigRational::from_integer(n.into()));
    let mut all = Vec::new();
    for behind in [false, true] {
        let deepest = DEEPEST[usize::from(behind)];
        let floats = Floats { c, k, tau, side: if behind { 1.0 } else { -1.0 } };
        let known = born(false, [&exact[0], &exact[1]], behind, LONGEST, &()).expect("no interruption");
        let Some(Born { graph: Some(graph), .. }) = known else { continue };
        let loops = single_orbits(&graph);
        let share = effort / 4;
        for periods in loops {
            let problem = SingleProblem {
                mirrored: false,
                ranges: exact.each_ref().map(both),
                behind,
                harmonics: vec![(1, [both(&one), both(&zero)])],
                periods,
                deepest,
            };
            let (reached, motion_ends, flip) = floats.curve(periods, deepest);
            let side = if behind { "beyond" } else { "before" };
            let depth = |x: &BigRational| x.to_f64().unwrap_or(0.0);
            let mut line = Line {
                machine,
                side,
                periods,
                proved: 0.0,
                reached,
                proof_ends: String::new(),
                motion_ends,
                flip,
                flips: [0.0; 2],
                cells: 0,
            };
            match prove_single(&problem, &RangeEffort::new(share), &()).expect("no interruption") {
                Err(end) => line.proof_ends = said(&end),
                Ok(proof) => {
                    line.proved = depth(&proof.depth);
                    line.proof_ends = said(&proof.end);
                    line.cells = proof.certificate.cells.len();
                    let mut from = 0.0;
                    for three in proof.parts.windows(2) {
                        let [(to, word), (_, next)] = three else { continue };
                        if *word == Word::Unstable && *next != Word::Unstable {
                            from = depth(to);
                        }
                        if *word != Word::Stable && *next == Word::Stable && line.flips == [0.0; 2] {
                            line.flips = [from, depth(to)];
                        }
                    }
                }
            }
            all.push(line);
        }
    }
    all
}

/// The table of docs/ranges.md, from the lines of a file.
pub fn print(text: &str) {
    struct Row<'a>(Vec<&'a str>);
    impl Row<'_> {
        fn number(&self, i: usize) -> f64 {
            self.0[i].parse().expect("a number")
        }
        fn ratio(&self) -> f64 {
            self.number(3) / self.number(4)
        }
    }
    let rows: Vec<Row> = text.lines().skip(1).map(|line| Row(line.split(',').collect())).collect();
    println!(
        "| orbits of one impact | born | proved to 0.95 of their end | to 0.99 | ends: fold / touch / not before the greatest depth asked | flips | flip proved | to 1 % |"
    );
    println!("| --- | ---: | ---: | ---: | --- | ---: | ---: | ---: |");
    for side in ["before", "beyond"] {
        let own: Vec<&Row> = rows.iter().filter(|row| row.0[1] == side && row.number(4) > 0.0).collect();
        let count = |some: &dyn Fn(&Row) -> bool| own.iter().filter(|row| some(row)).count();
        let flips = count(&|row| row.number(7) > 0.0);
        let found = count(&|row| row.number(9) > 0.0);
        let close =
            count(&|row| row.number(9) > 0.0 && row.number(9) - row.number(8) <= 0.01 * row.number(9));
        println!(
            "| {side} | {} | {} | {} | {} / {} / {} | {flips} | {found} | {close} |",
            own.len(),
            share(count(&|row| row.ratio() >= 0.95), own.len()),
            share(count(&|row| row.ratio() >= 0.99), own.len()),
            count(&|row| row.0[6] == "fold"),
            count(&|row| row.0[6] == "touch"),
            count(&|row| row.0[6] == "asked"),
        );
    }
    let farther = rows.iter().filter(|row| row.ratio() > 1.0001).count();
    let contradicted = rows
        .iter()
        .filter(|row| row.number(9) > 0.0 && !(row.number(8)..=row.number(9)).contains(&row.number(7)))
        .count();
    println!(
        "\nProved beyond the true end: {farther}. A proved flip that is not where the floats have it: {contradicted}."
    );
}
