//! Certificates of kind attractor: what passes, what must be refused, and whether what those say that pass,
//! also the damaged ones, is true of motions in floats: of where they hit, and how fast they part.

use std::f64::consts::TAU;

use crate::common::{
    ATTRACTOR, ATTRACTOR_SEVERAL, ATTRACTOR_WIDE, Random, answer, are_refused, damage, damaged_so_are_true,
    float, flow, second_reader, with,
};
use crate::samples::{one_in, samples};
use grazing_check::attractor::STATEMENT;

const ALL: [&str; 3] = [ATTRACTOR, ATTRACTOR_WIDE, ATTRACTOR_SEVERAL];

/// A certificate's numbers.
struct Claim {
    /// c, k, τ, at both ends of their ranges.
    parameters: [[f64; 3]; 2],
    harmonics: Vec<[f64; 3]>,
    depth: f64,
    window: [f64; 2],
    bends: [f64; 2],
    speed: f64,
    slip: f64,
    growth: f64,
    start: f64,
    /// NU, R and L.
    exponent: Option<[f64; 3]>,
}

impl Claim {
    fn of(text: &str) -> Claim {
        let named = |name: &str| -> Vec<Vec<f64>> {
            let lines = text.lines().filter(|line| line.split(' ').next() == Some(name));
            lines.map(|line| line.split(' ').skip(1).map(float).collect()).collect()
        };
        let two = |name: &str| [named(name)[0][0], named(name)[0][1]];
        let [c, k, tau] = ["damping", "stiffness", "restitution"].map(two);
        let middle =
            |line: &Vec<f64>| [line[0], f64::midpoint(line[1], line[2]), f64::midpoint(line[3], line[4])];
        let exponent = (!text.ends_with("none\n")).then(|| named("exponent")[0].clone());
        Claim {
            parameters: [0, 1].map(|end| [c[end], k[end], tau[end]]),
            harmonics: named("harmonic").iter().map(middle).collect(),
            depth: named("depth")[0][0],
            window: two("window"),
            bends: two("bends"),
            speed: named("speed")[0][0],
            slip: named("slip")[0][0],
            growth: named("growth")[0][0],
            start: named("start")[0][0],
            exponent: exponent.map(|words| [words[0], words[1], words[2]]),
        }
    }

    /// The machine with parameters drawn from the ranges, and ν.
    fn machine(&self, random: &mut Random) -> Machine<'_> {
        let [lo, hi] = self.parameters;
        let [c, k, tau] =
            [0, 1, 2].map(|i| lo[i] + [0.0, 1.0, random.part()][random.below(3)] * (hi[i] - lo[i]));
        // The greatest depth, or a smaller one of any size.
        let nu = self.depth * [1.0, 10f64.powf(-6.0 * random.part())][random.below(2)];
        Machine { harmonics: &self.harmonics, c, k, tau, nu }
    }
}

/// q″ = −c q′ − k q above ν − 1 + g(t).
struct Machine<'a> {
    harmonics: &'a [[f64; 3]],
    c: f64,
    k: f64,
    tau: f64,
    nu: f64,
}

/// What a motion is just before it hits.
#[derive(Clone, Copy, Debug)]
struct Contact {
    time: f64,
    place: f64,
    velocity: f64,
}

impl Machine<'_> {
    /// Q, Q′ and Q″.
    fn wall(&self, t: f64) -> [f64; 3] {
        let mut wall = [self.nu, 0.0, 0.0];
        // 1 − g by what is small where it is.
        for &[j, a, b] in self.harmonics {
            let (sin, cos) = (j * t).sin_cos();
            let fall = 2.0 * (j * t / 2.0).sin().powi(2);
            wall[0] += b * sin - a * fall;
            wall[1] += j * (b * cos - a * sin);
            wall[2] -= j * j * (a * cos + b * sin);
        }
        wall
    }

    /// a.
    fn slow(&self) -> f64 {
        2.0 * self.k / (self.c + (self.c * self.c - 4.0 * self.k).sqrt())
    }

    fn after(&self, [q, u]: [f64; 2], t: f64) -> [f64; 2] {
        let [a, b, c, d] = flow([self.c, self.k], t);
        [a * q + b * u, c * q + d * u]
    }

    /// The first contact of a motion, in passes of the wall within a window about its tops.
    fn next(&self, from: f64, state: [f64; 2], [before, after]: [f64; 2]) -> Option<Contact> {
        let gap = |t: f64| {
            let ([q, u], [place, slope, _]) = (self.after(state, t - from), self.wall(t));
            [q - place, u - slope]
        };
        let first = ((from - after) / TAU).ceil();
        for n in 0..4000 {
            let top = TAU * (first + f64::from(n));
            let (mut low, step) = ((top - before).max(from + 1e-12), (before + after) / 50.0);
            while low < top + after {
                let high = low + step;
                let ([start, falls], [end, rises]) = (gap(low), gap(high));
                if start <= 0.0 {
                    return None;
                }
                if end < 0.0 {
                    return Some(self.hit(from, state, low, high));
                }
                // The gap is convex here, and may be below 0 for less than a step.
                if falls < 0.0 && rises > 0.0 {
                    let (mut l, mut r) = (low, high);
                    for _ in 0..60 {
                        let middle = f64::midpoint(l, r);
                        if gap(middle)[1] < 0.0 { l = middle } else { r = middle }
                    }
                    if gap(l)[0] < -1e-14 * self.nu {
                        return Some(self.hit(from, state, low, l));
                    }
                }
                low = high;
            }
        }
        None
    }

    fn hit(&self, from: f64, state: [f64; 2], mut lo: f64, mut hi: f64) -> Contact {
        for _ in 0..70 {
            let middle = f64::midpoint(lo, hi);
            if self.after(state, middle - from)[0] > self.wall(middle)[0] { lo = middle } else { hi = middle }
        }
        let [place, velocity] = self.after(state, lo - from);
        Contact { time: lo, place, velocity }
    }

    /// V, and aQ + Q′ + V.
    fn seen(&self, at: Contact) -> [f64; 2] {
        [at.velocity - self.wall(at.time)[1], self.slow() * at.place + at.velocity]
    }

    /// The state after an impact, and how the displacement (1, −a) is changed by it.
    fn impact(&self, at: Contact) -> ([f64; 2], [f64; 2]) {
        let [_, slope, bend] = self.wall(at.time);
        let relative = at.velocity - slope;
        let after = slope - self.tau * relative;
        let acceleration = |u: f64| -self.c * u - self.k * at.place - bend;
        let turn = self.tau * acceleration(at.velocity) + acceleration(after);
        let displaced = [-self.tau, self.tau * self.slow() + turn / relative];
        ([at.place, after], displaced)
    }
}

/// What is false of a certificate that is accepted, as far as some motions in floats tell.
fn lie(text: &str, motions: usize) -> Option<String> {
    let claim = Claim::of(text);
    let mut random = Random(11);
    let slack = 1.0 + 1e-6;
    // A window that is too short is seen before it is used.
    let machine = Machine { harmonics: &claim.harmonics, c: 1.0, k: 0.1, tau: 1.0, nu: claim.depth };
    for i in 0..=400 {
        let t = -TAU / 2.0 + TAU * f64::from(i) / 400.0;
        let inside = -claim.window[0] * slack <= t && t <= claim.window[1] * slack;
        if !inside && machine.wall(t)[0] > 1e-9 * claim.depth {
            return Some(format!("the wall is beyond rest at {t}"));
        }
        let bend = -machine.wall(t)[2];
        if machine.wall(t)[0] > 0.0 && !(claim.bends[0] <= bend * slack && bend <= claim.bends[1] * slack) {
            return Some(format!("the wall bends by {bend} at {t}"));
        }
    }
    for _ in 0..motions {
        let machine = claim.machine(&mut random);
        if machine.c * machine.c <= 4.0 * machine.k {
            return Some("not overdamped".into());
        }
        if let Some(lie) =
            trapped(&claim, &machine, &mut random).or_else(|| starts(&claim, &machine, &mut random))
        {
            return Some(format!("{lie} of {:?}", [machine.c, machine.k, machine.tau, machine.nu]));
        }
    }
    None
}

/// Whether a contact is in the trap, to a part in a million.
fn outside(claim: &Claim, machine: &Machine, at: Contact) -> Option<String> {
    let [velocity, slip] = machine.seen(at);
    let (fast, far) = (claim.speed * machine.nu.sqrt(), claim.slip * machine.nu);
    let slack = 1e-6;
    let holds = velocity >= -fast * (1.0 + slack) && at.place >= -slack * machine.nu && slip >= -slack * far;
    (!(holds && slip <= far * (1.0 + slack)))
        .then(|| format!("V = {velocity}, slip {slip}, Q = {} at {}", at.place, at.time))
}

/// A motion from a contact of the trap, its next contacts and how it parts from its neighbours.
fn trapped(claim: &Claim, machine: &Machine, random: &mut Random) -> Option<String> {
    let wide = claim.window[0] + claim.window[1];
    let scale = (machine.nu / claim.depth).sqrt();
    let time = scale * (random.part() * wide - claim.window[0]);
    let [place, slope, _] = machine.wall(time);
    let slip = claim.slip * machine.nu * random.part();
    let velocity = slip - machine.slow() * place;
    let speed = slope - velocity;
    if place < 0.0 || speed <= 0.0 || speed > claim.speed * machine.nu.sqrt() {
        return None;
    }
    let mut at = Contact { time, place, velocity };
    for _ in 0..4 {
        let (state, displaced) = machine.impact(at);
        let Some(next) = machine.next(at.time, state, claim.window) else {
            return Some(format!("no contact after {at:?}"));
        };
        if let Some(lie) = outside(claim, machine, next) {
            return Some(lie);
        }
        let n = ((next.time - at.time) / TAU).round();
        let grown = machine.after(displaced, next.time - at.time)[0].abs();
        if grown * (1.0 + 1e-6) < claim.growth || n < 1.0 {
            return Some(format!("growth by {grown} over {n} periods"));
        }
        if let Some([least, rate, last]) = claim.exponent
            && machine.nu >= least
            && (grown.ln() / n * (1.0 + 1e-6) < rate || n > last)
        {
            return Some(format!("an exponent of {} over {n} periods", grown.ln() / n));
        }
        // A graze has no displacement after it.
        if machine.seen(next)[0] > -1e-6 * machine.nu.sqrt() {
            return None;
        }
        at = next;
    }
    None
}

/// A motion that starts as the certificate says, up to its third contact.
fn starts(claim: &Claim, machine: &Machine, random: &mut Random) -> Option<String> {
    let height = claim.start / machine.slow() * random.part();
    let state = [height, claim.start * [1.0, random.part()][random.below(2)] - machine.slow() * height];
    let mut at = machine.next(claim.window[1], state, claim.window)?;
    for _ in 0..2 {
        let Some(next) = machine.next(at.time, machine.impact(at).0, claim.window) else {
            return Some(format!("no contact after {at:?} from {state:?}"));
        };
        at = next;
    }
    outside(claim, machine, at).map(|lie| format!("from {state:?}: {lie}"))
}

/// The least growth from one contact to the next that is seen, of motions at the greatest depth.
fn least_growth(text: &str, motions: usize) -> f64 {
    let claim = Claim::of(text);
    let ([c, k, tau], nu) = (claim.parameters[0], claim.depth);
    let machine = Machine { harmonics: &claim.harmonics, c, k, tau, nu };
    let (mut random, mut least) = (Random(3), f64::INFINITY);
    for _ in 0..motions {
        let height = claim.start / machine.slow() * random.part();
        let state = [height, claim.start * random.part() - machine.slow() * height];
        let mut at = machine.next(claim.window[1], state, claim.window).unwrap();
        for i in 0..12 {
            let (state, displaced) = machine.impact(at);
            let next = machine.next(at.time, state, claim.window).unwrap();
            if i > 2 {
                least = least.min(machine.after(displaced, next.time - at.time)[0].abs());
            }
            at = next;
        }
    }
    least
}

/// d, w and τ of the paper's oscillator, as this kind has them: c, k and τ.
fn machine(ranges: [&str; 3], lines: &[(&str, &str)]) -> String {
    let names = ["damping", "stiffness", "restitution"];
    let whole = names.iter().zip(ranges).fold(ATTRACTOR.to_string(), |text, (name, range)| {
        let range = if range.contains(' ') { range.to_string() } else { format!("{range} {range}") };
        with(&text, name, &format!("{name} {range}"))
    });
    lines.iter().fold(whole, |text, (name, line)| with(&text, &format!("{name} "), &format!("{name} {line}")))
}

/// d = 3/2, w = 8, τ = 4/5 at some depth.
fn paper(lines: &[(&str, &str)]) -> String {
    machine(["3/8", "1/64", "4/5"], lines)
}

#[test]
fn what_is_written_passes_and_is_named() {
    let checked = answer(ATTRACTOR).unwrap();
    assert_eq!((checked.kind, checked.statement), ("attractor", STATEMENT));
    let said = checked.to_string();
    for part in [
        "proved, chaos that attracts",
        "overdamped",
        "depth: every nu with 0 < nu <= 1/100",
        "growth: 1.15 at each contact",
        "exponent: at least 0.005 in a period 2 pi for nu >= 1/10000",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }
    for text in ALL {
        assert_eq!(answer(text).map_err(|why| why.to_string()).err(), None);
        assert_eq!(lie(text, samples(40)), None);
    }
}

/// Such a part of the growth that is seen is proved, at least.
const PARTS: [f64; 5] = [0.7, 0.7, 0.7, 0.75, 0.75];

/// The depths, growths and exponents that the formulas give in floats, for µ = ν/(1 − ν) in the paper's
/// units.
#[test]
fn the_formulas_reach_what_they_should() {
    let rows = [
        (
            "1/11",
            "0.4297",
            "0.909090909",
            "0.72232",
            "0.0786482",
            ["1.0051 11", "1.0052 11"],
            "1/11 0.01508 10",
        ),
        (
            "3/103",
            "0.241946",
            "0.97087378",
            "0.720656",
            "0.0688807",
            ["1.2319 13", "1.2320 13"],
            "3/103 0.02124 12",
        ),
        (
            "1/101",
            "0.140836",
            "0.990099",
            "0.720201",
            "0.0642257",
            ["1.3212 14", "1.3213 14"],
            "1/101 0.04204 13",
        ),
        (
            "1/1001",
            "0.0447028",
            "0.99900099",
            "0.72",
            "0.0601423",
            ["1.3997 18", "1.3998 18"],
            "1/1001 0.03125 17",
        ),
        ("1/10001", "0.0141416", "0.9999", "0.71998", "0.0589088", ["1.4204 22", "1.4205 22"], "none"),
    ];
    for ((depth, window, bend, speed, slip, growths, exponent), part) in rows.into_iter().zip(PARTS) {
        let (window, bends) = (format!("{window} {window}"), format!("{bend} 1"));
        let lines = |growth| {
            paper(&[
                ("depth", depth),
                ("window", &window),
                ("bends", &bends),
                ("speed", speed),
                ("slip", slip),
                ("growth", growth),
                ("start", "1.5"),
                ("exponent", exponent),
            ])
        };
        let text = lines(growths[0]);
        assert_eq!(answer(&text).map_err(|why| why.to_string()).err(), None, "{depth}");
        assert_eq!(lie(&text, 40), None);
        // What is proved of all depths below, over what motions do at the greatest.
        let seen = least_growth(&text, samples(8));
        let proved = float(growths[0].split(' ').next().unwrap());
        println!("nu = {depth}: {proved} proved, {seen:.4} seen, {:.3} of it", proved / seen);
        assert!((part..1.0).contains(&(proved / seen)), "{depth}: {proved} {seen}");
        let why = answer(&lines(&growths[1].replace("1.2320", "1.233").replace("0 1", "01 1"))).unwrap_err();
        assert!(why.to_string().contains("(A5)"), "{depth}: {why}");
    }
}

/// An exponent is the least over all returns, here that of eleven periods.
#[test]
fn each_return_bounds_the_exponent() {
    let lines = |exponent| {
        paper(&[
            ("depth", "1/11"),
            ("window", "0.4297 0.4297"),
            ("bends", "0.909090909 1"),
            ("speed", "0.72232"),
            ("slip", "0.0786482"),
            ("growth", "1.0051 11"),
            ("start", "1.5"),
            ("exponent", exponent),
        ])
    };
    assert!(answer(&lines("1/1000 0.00046 17")).is_ok());
    let why = answer(&lines("1/1000 0.0005 17")).unwrap_err().to_string();
    assert!(why.contains("over 11 periods (A7)"), "{why}");
}

#[test]
fn weaker_claims_pass() {
    for (name, line) in [
        ("depth", "1/200"),
        ("window", "0.15 0.142"),
        ("bends", "0.981 1"),
        ("speed", "0.74"),
        ("slip", "0.075"),
        ("growth", "1.15 20"),
        ("growth", "1.01 100"),
        ("start", "0.01"),
        ("exponent", "none"),
        ("exponent", "1/5000 0.001 50"),
        ("restitution", "79/100 4/5"),
    ] {
        let text = paper(&[("growth", "1.14 15"), (name, line)]);
        assert_eq!(answer(&text).map_err(|why| why.to_string()).err(), None, "{name} {line}");
        assert_eq!(lie(&text, 20), None);
    }
}

/// d = 3/2, w = 5, where λ₁ = 0.62 < 2/3, at a small depth, with a trap that holds.
fn slower(growth: &str) -> String {
    let lines = [
        ("depth", "1/1001"),
        ("window", "0.0448 0.0448"),
        ("bends", "0.999 1"),
        ("speed", "0.8744"),
        ("slip", "0.03"),
        ("growth", growth),
        ("start", "0.2"),
        ("exponent", "none"),
    ];
    machine(["3/5", "1/25", "4/5"], &lines)
}

fn forgeries() -> Vec<(String, &'static str)> {
    let mut all = Vec::new();
    for (name, line, reason) in [
        // One digit too far.
        ("growth", "1.17 14", "(A5)"),
        ("growth", "1.15 13", "over 13 periods or more (A5)"),
        ("growth", "1.15 1", "over 1 periods or more (A5)"),
        ("growth", "1.17 100", "(A5)"),
        ("window", "0.1415 0.15", "outside the window (A1)"),
        ("window", "0.15 0.1415", "outside the window (A1)"),
        ("window", "0.14154 6.2", "outside the window (A1)"),
        ("window", "3.14159 3.15", "outside the window (A1)"),
        ("window", "3.1415926 3.1416", "outside the window (A1)"),
        ("window", "3.1 3.1", "the slip may be greater (A2)"),
        ("bends", "0.99000001 1.01", "bend otherwise in the window (A1)"),
        ("bends", "0.98 0.99999999", "bend otherwise in the window (A1)"),
        ("speed", "0.72", "contacts may be faster (A3)"),
        ("slip", "0.064", "the slip may be greater (A2)"),
        ("slip", "300", "convex before a contact (A3)"),
        ("start", "2.4", "(A6)"),
        ("start", "0.000699", "less than what is trapped (A6)"),
        ("start", "100", "(A6)"),
        ("exponent", "1/10000 0.02 25", "the exponent may be less over"),
        ("exponent", "1/10000 0.005 20", "may be after more periods (A7)"),
        ("exponent", "1/1000000 0.005 25", "may be after more periods (A7)"),
        ("exponent", "1/10000 0.5 25", "periods (A7)"),
        // Deeper, and other machines: of another λ₁, not overdamped, with more at an impact.
        ("depth", "1/88", "(A1)"),
        ("depth", "2/1", "(A1)"),
        ("damping", "1/4 1/4", "overdamped (A1)"),
        ("damping", "1/5 3/8", "overdamped (A1)"),
        ("damping", "-3/8 -3/8", "overdamped (A1)"),
        ("stiffness", "1/64 3/64", "overdamped (A1)"),
        ("stiffness", "0/1 1/64", "overdamped (A1)"),
        ("stiffness", "-1/64 1/64", "overdamped (A1)"),
        ("damping", "3/8 2/5", ""),
        ("damping", "10/1 10/1", "(A3)"),
        ("restitution", "4/5 1/1", ""),
        ("restitution", "1/2 4/5", ""),
        ("restitution", "20/1 20/1", ""),
    ] {
        all.push((with(ATTRACTOR, &format!("{name} "), &format!("{name} {line}")), reason));
    }
    for (name, line, reason) in [
        ("depth", "1/190", "outside the window (A1)"),
        ("window", "0.0874 0.088059", "outside the window (A1)"),
        ("window", "0.087467 0.088", "outside the window (A1)"),
        ("window", "1.3 0.088059", "concave in the window (A1)"),
        ("window", "0.087467 1.2", "concave in the window (A1)"),
        ("bends", "1.27 1.324", "bend otherwise in the window (A1)"),
        ("bends", "1.257 1.31", "bend otherwise in the window (A1)"),
        ("concave", "1.3 1.14", "may not be concave (A1)"),
        ("concave", "1.21 1.3", "may not be concave (A1)"),
        ("concave", "0.09 0.09", "outside the window (A1)"),
        ("concave", "3.2 3.2", "longer than a period (A1)"),
        ("pieces", "3", "(A1)"),
        ("slip", "0.0619", "(A2)"),
        ("speed", "0.827", "(A3)"),
        ("growth", "1.3 16", "(A5)"),
    ] {
        all.push((with(ATTRACTOR_SEVERAL, &format!("{name} "), &format!("{name} {line}")), reason));
    }
    // Fast rates, and more speed after an impact than before.
    let strong = [
        ("depth", "1/10000"),
        ("window", "0.01415 0.01415"),
        ("bends", "0.9999 1"),
        ("speed", "0.6"),
        ("slip", "0.001"),
        ("growth", "1.3 46"),
        ("start", "0.001"),
        ("exponent", "none"),
    ];
    all.push((machine(["40/1", "7/20", "5/1"], &strong), "convex after a contact (A4)"));
    all.push((slower("1.00001 40"), "growth may be less over"));
    all.push((slower("1.00001 9"), "growth may be less over"));
    // µ beyond µ₁: what the formulas would reach there is below 1.
    let deep = [
        ("depth", "1/10"),
        ("window", "0.45103 0.45103"),
        ("bends", "0.9 1"),
        ("speed", "0.73"),
        ("slip", "0.08"),
        ("growth", "1.00001 11"),
        ("start", "1"),
        ("exponent", "none"),
    ];
    all.push((paper(&deep), "(A5)"));
    all
}

fn malformed() -> Vec<(String, &'static str)> {
    let lines = [
        ("depth", "0/1", "positive"),
        ("depth", "-1/100", "positive"),
        ("window", "0 0.2", "positive"),
        ("window", "0.2", "expected"),
        ("window", "0.2 0.2 0.2", "unexpected"),
        ("bends", "-1 1", "positive"),
        ("speed", "0", "positive"),
        ("slip", "0", "positive"),
        ("slip", "0.10", "decimal"),
        ("growth", "1 14", "above 1"),
        ("growth", "0.9 14", "above 1"),
        ("growth", "1.3 0", "at least 1"),
        ("growth", "1.3 1001", "1000"),
        ("start", "0", "positive"),
        ("exponent", "0/1 0.01 21", "positive"),
        ("exponent", "1/10000 0 21", "positive"),
        ("exponent", "1/10000 0.01 0", "at least 1"),
        ("exponent", "1/10000 0.01 2001", "2000"),
        ("exponent", "1/99 0.01 21", "up to the greatest"),
        ("exponent", "none none", "unexpected"),
        ("restitution", "0/1 4/5", "positive"),
        ("harmonic", "1 9/10 9/10 0/1 0/1", "sum to 1"),
        ("harmonic", "2 1/1 1/1 0/1 0/1", "expected a line \"concave"),
        ("harmonic", "1 1/1 1/1 -1/10 1/10", "expected a line \"concave"),
    ];
    let change = |(name, line, reason): (&str, &str, _)| {
        (with(ATTRACTOR, &format!("{name} "), &format!("{name} {line}")), reason)
    };
    let mut all: Vec<(String, &'static str)> = lines.into_iter().map(change).collect();
    all.push((format!("{ATTRACTOR}exponent none\n"), "goes on"));
    all.push((with(ATTRACTOR, "statement", "statement"), "word for word"));
    all.push((with(ATTRACTOR, "start", "pieces 10\nstart 2"), "start"));
    all
}

#[test]
fn forgeries_are_refused() {
    are_refused(&forgeries(), &malformed());
}

/// The reader in Python, written from the form and the theorem alone, gives the same verdicts.
#[test]
fn two_readers_agree() {
    let right = ALL.map(String::from).into_iter().chain([paper(&[("growth", "1.01 100")])]);
    let wrong = forgeries().into_iter().chain(malformed()).map(|(text, _)| text).step_by(one_in(3));
    let mut random = Random(7);
    let damaged =
        ALL.map(|text| (0..samples::<usize>(12)).map(|_| damage(&mut random, text)).collect::<Vec<_>>());
    let all: Vec<String> = right.chain(wrong).chain(damaged.into_iter().flatten()).collect();
    let Some(verdicts) = second_reader("attractor.py", &all) else { return };
    let mut accepted = 0;
    for (text, line) in all.iter().zip(&verdicts) {
        let ours = answer(text);
        accepted += usize::from(ours.is_ok());
        assert_eq!(ours.is_ok(), line.ends_with(": proved, chaos that attracts"), "{ours:?}, {line}\n{text}");
    }
    assert!(accepted > ALL.len(), "{accepted}");
}

/// GRAZING_SAMPLES times as many of them.
#[test]
fn what_is_accepted_of_damaged_certificates_is_true() {
    for (seed, text) in (4..).zip(ALL) {
        damaged_so_are_true((seed, samples(120), samples::<usize>(120) / 50), text, damage, |text| {
            lie(text, 12)
        });
    }
}

/// The floats see what is false: each number of a certificate, changed by more than it has room for.
#[test]
fn floats_notice_lies() {
    for (name, line, what) in [
        ("window", "0.12 0.14154", "the wall is beyond rest"),
        ("bends", "0.999 1", "the wall bends"),
        ("bends", "0.98 0.995", "the wall bends"),
        ("speed", "0.5", "V ="),
        ("slip", "0.005", "slip"),
        ("growth", "2.5 14", "growth by"),
        ("exponent", "1/10000 0.3 25", "an exponent of"),
        ("exponent", "1/10000 0.01 3", "an exponent of"),
        ("damping", "1/5 1/5", "not overdamped"),
        ("depth", "1/2", "beyond rest"),
    ] {
        let text = with(ATTRACTOR, &format!("{name} "), &format!("{name} {line}"));
        let found = lie(&text, 400).unwrap_or_default();
        assert!(found.contains(what), "{name} {line}: {found:?}");
    }
}

/// (1) to (10) of `proofs/attractor.md` in floats, as they stand there.
struct Page {
    a: f64,
    b: f64,
    tau: f64,
    mu: f64,
    window: [f64; 2],
    bends: [f64; 2],
}

impl Page {
    fn wide(&self) -> f64 {
        self.window[0] + self.window[1]
    }

    /// φ₁₁ and φ₁₂.
    fn motion(&self, t: f64) -> [f64; 2] {
        let reach = ((-self.a * t).exp() - (-self.b * t).exp()) / (self.b - self.a);
        [(-self.a * t).exp() + self.a * reach, reach]
    }

    fn reach(&self, n: f64) -> f64 {
        let [early, late] = [-1.0, 1.0].map(|side| self.motion(TAU * n + side * self.wide())[1]);
        early.min(late)
    }

    /// (1).
    fn slip(&self) -> f64 {
        let d = self.b - self.a;
        self.mu * d / ((d * (TAU - self.wide())).exp() - 1.0)
    }

    /// (2) to (5).
    fn speed(&self, slip: f64) -> f64 {
        let Page { a, b, tau, mu, bends: [least, greatest], .. } = self;
        let d = b - a;
        let first = mu / ((1.0 + tau) * self.reach(1.0));
        let bend = greatest + a * a * (mu + slip / d);
        let early = least - b * b * (b * self.wide()).exp() * (slip + (1.0 + tau) * first) / d;
        assert!(early > 0.0, "{early}");
        let share = (-a * TAU).exp();
        (2.0 * bend * ((1.0 - share) * mu + share * (tau * first).powi(2) / (2.0 * early))).sqrt()
    }

    /// (6) to (10).
    fn growths(&self, slip: f64, speed: f64, n: f64) -> [f64; 2] {
        let Page { a, b, tau, mu, bends: [least, _], .. } = self;
        let pull = |x: f64| least - b * b * x / (b - a);
        let strength = tau * pull(slip) + pull(slip + (1.0 + tau) * speed);
        let height = mu - (speed + slip).max(a * mu).powi(2) / (2.0 * least);
        let rest = self.motion(TAU * n - self.wide())[0] * mu;
        let way = ((1.0 + tau) * speed + slip) * speed;
        [strength * self.reach(n) / speed, strength * (height - rest) / way]
    }

    /// (ii).
    fn is_trapped(&self, start: f64) -> bool {
        let Page { a, b, tau, mu, bends: [least, greatest], .. } = self;
        let d = b - a;
        let fastest = (2.0 * mu * (greatest + a * a * (mu + start / d))).sqrt();
        *least > b * b * (start + (1.0 + tau) * fastest) / d
    }

    /// Whether no return takes more than n periods where the depth is less than µ, of the same S and Z.
    fn returns(&self, [slip, speed]: [f64; 2], n: f64, mu: f64) -> bool {
        let [slip, speed] = [slip * mu / self.mu, speed * (mu / self.mu).sqrt()];
        let time = TAU * n - self.wide();
        let kick = (1.0 + self.tau) * speed + slip;
        self.motion(time)[0] * mu + (-self.a * time).exp() * kick / (self.b - self.a) < mu
    }
}

/// About where a condition that holds below ceases to, or one that holds above begins.
fn between(mut lo: f64, mut hi: f64, below: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..100 {
        let middle = f64::midpoint(lo, hi);
        if below(middle) { lo = middle } else { hi = middle }
    }
    lo
}

/// Each term of the formulas counts: what a certificate lists may be a little above the page's numbers, or
/// below those of which that is weaker, and not a little on the other side.
#[test]
fn the_numbers_are_those_of_the_page() {
    let short = |x: f64| format!("{x:.12}").trim_end_matches('0').trim_end_matches('.').to_string();
    let more = 1.0 + 3e-8;
    let mut tried = [0; 3];
    for ([c, k, tau], parts, window, [least, greatest]) in [
        (["3/8", "1/64", "4/5"], "1/11", [0.43, 0.44], ["0.905", "1.01"]),
        (["3/8", "1/64", "4/5"], "1/400", [0.071, 0.08], ["0.98", "1.02"]),
        (["1/1", "1/30", "9/10"], "1/40", [0.23, 0.226], ["0.97", "1.01"]),
        (["1/1", "1/30", "1/5"], "1/90", [0.15, 0.16], ["0.98", "1"]),
        (["2/1", "3/10", "1/2"], "1/200", [0.11, 0.102], ["0.98", "1.02"]),
        (["3/10", "1/200", "2/1"], "1/50", [0.21, 0.21], ["0.97", "1"]),
    ] {
        let [damping, stiffness, law, mu] = [c, k, tau, parts].map(float);
        let d = (damping * damping - 4.0 * stiffness).sqrt();
        let (b, bends) = (0.5 * (damping + d), [float(least), float(greatest)]);
        let page = Page { a: stiffness / b, b, tau: law, mu, window, bends };
        let root = mu.sqrt();
        let (slip, [before, after]) = (page.slip() * 1.01, window.map(short));
        let speed = page.speed(slip) * 1.001;
        let lines = |changes: &[(&str, String)]| {
            let own = [
                ("depth", parts.to_string()),
                ("window", format!("{before} {after}")),
                ("bends", format!("{least} {greatest}")),
                ("slip", short(slip / mu)),
                ("speed", short(speed / root)),
                ("growth", "1.0001 300".into()),
                ("start", short(slip * 1.1)),
                ("exponent", "none".into()),
            ];
            let lines: Vec<(&str, &str)> =
                own.iter().chain(changes).map(|(name, line)| (*name, line.as_str())).collect();
            machine([c, k, tau], &lines)
        };
        // Whether a certificate gets past a rule.
        let passes = |rule: &str, changes: &[(&str, String)]| {
            answer(&lines(changes)).err().is_none_or(|why| !why.to_string().contains(rule))
        };
        let sharp = |rule: &str, weak: &[(&str, String)], strong: &[(&str, String)]| {
            assert!(
                passes(rule, weak) && !passes(rule, strong),
                "{c} {k} {tau} {parts}: {weak:?} {strong:?}"
            );
        };
        let at = |name, x: f64| [(name, short(x))];
        sharp("(A2)", &at("slip", page.slip() / mu * more), &at("slip", page.slip() / mu / more));
        let fastest = page.speed(slip) / root;
        sharp("faster (A3)", &at("speed", fastest * more), &at("speed", fastest / more));
        let greater = |n: u32| page.growths(slip, speed, f64::from(n)).into_iter().fold(0.0, f64::max);
        let last = |n: u32| page.growths(slip, speed, f64::from(n))[1];
        // Returns one by one up to where they are over, and by the last alone.
        for n in [3, 8, 12, 300] {
            let found = (1..n).map(greater).fold(last(n), f64::min);
            if found < 1.01 {
                continue;
            }
            let grows = |x: f64| [("growth", format!("{} {n}", short(x)))];
            sharp("(A5)", &grows(found / more), &grows(found * more));
            tried[if found == last(n) { 0 } else { 1 }] += 1;
        }
        if (1..300).map(greater).fold(last(300), f64::min) < 1.01 {
            continue;
        }
        let start = between(0.0, 100.0, |x| page.is_trapped(x));
        sharp("(A6)", &at("start", start / more), &at("start", start * more));
        sharp("(A6)", &at("start", slip * more), &at("start", slip / more));
        // The least depth from which returns take so many periods, and the exponent there.
        let n = (3..).find(|n| page.returns([slip, speed], f64::from(*n), mu / 10.0)).unwrap();
        let depth = between(0.0, mu, |x| !page.returns([slip, speed], f64::from(n), x));
        let rate = (1..=n).map(|n| greater(n).ln() / f64::from(n)).fold(f64::INFINITY, f64::min);
        let exponent = |depth: f64, rate: f64| {
            let (p, q) = ((depth * 1e12).round() as u64, 1_000_000_000_000u64);
            let common =
                (1..=40).rev().map(|i| 1 << i).chain([1]).find(|two| p % two == 0 && q % two == 0).unwrap();
            let (mut p, mut q) = (p / common, q / common);
            while p % 5 == 0 && q % 5 == 0 {
                (p, q) = (p / 5, q / 5);
            }
            [("exponent", format!("{p}/{q} {} {n}", short(rate)))]
        };
        sharp(
            "periods (A7)",
            &exponent(depth * (1.0 + 1e-6), rate / 2.0),
            &exponent(depth / (1.0 + 1e-6), rate / 2.0),
        );
        sharp("exponent may", &exponent(depth * 1.01, rate / more), &exponent(depth * 1.01, rate * more));
        tried[2] += 1;
    }
    assert!(tried.iter().all(|count| *count > 2), "{tried:?}");
}
