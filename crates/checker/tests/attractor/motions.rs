//! Motions in floats, by the formulas of their flow: what they refute of a certificate, how fast they part.

use std::f64::consts::TAU;

use crate::common::{Random, float, flow};

/// A certificate's numbers.
struct Claim {
    /// c, k, τ, at both ends of their ranges.
    parameters: [[f64; 3]; 2],
    harmonics: Vec<[f64; 3]>,
    /// The least, 0 of version 1, and the greatest.
    depths: [f64; 2],
    window: [f64; 2],
    bends: [f64; 2],
    speed: f64,
    slip: f64,
    growth: f64,
    start: f64,
    /// NU, R and L.
    exponent: Option<[f64; 3]>,
    /// The ends of cells and their weights; one of version 1.
    cells: Vec<[f64; 2]>,
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
        let numbers = |words: &[f64]| [words[0], words[1], words[2]];
        let (growth, speed) = (named("growth")[0].clone(), named("speed")[0][0]);
        let (depths, exponent, cells) = if text.contains("\nkind attractor 2\n") {
            let depths = two("depths");
            let cells = named("cell").iter().map(|line| [line[0], line[1]]).collect();
            (depths, Some([depths[0], growth[1], growth[2]]), cells)
        } else {
            let exponent = (!text.ends_with("none\n")).then(|| numbers(&named("exponent")[0]));
            ([0.0, named("depth")[0][0]], exponent, vec![[speed, 1.0]])
        };
        Claim {
            parameters: [0, 1].map(|end| [c[end], k[end], tau[end]]),
            harmonics: named("harmonic").iter().map(middle).collect(),
            depths,
            window: two("window"),
            bends: two("bends"),
            speed,
            slip: named("slip")[0][0],
            growth: growth[0],
            start: named("start")[0][0],
            exponent,
            cells,
        }
    }

    fn depth(&self) -> f64 {
        self.depths[1]
    }

    /// What displacements weigh where a contact is so fast, in units of √ν.
    fn weight(&self, speed: f64) -> f64 {
        self.cells.iter().find(|[end, _]| speed <= *end).or(self.cells.last()).unwrap()[1]
    }

    /// The machine with parameters drawn from the ranges, and ν.
    fn machine(&self, random: &mut Random) -> Machine<'_> {
        let [lo, hi] = self.parameters;
        let [c, k, tau] =
            [0, 1, 2].map(|i| lo[i] + [0.0, 1.0, random.part()][random.below(3)] * (hi[i] - lo[i]));
        // The greatest depth, or a smaller one of any size.
        let [least, greatest] = self.depths;
        let smaller = match least > 0.0 {
            true => least + (greatest - least) * random.part(),
            false => greatest * 10f64.powf(-6.0 * random.part()),
        };
        let nu = [greatest, smaller][random.below(2)];
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
pub fn lie(text: &str, motions: usize) -> Option<String> {
    let claim = Claim::of(text);
    let mut random = Random(11);
    let slack = 1.0 + 1e-6;
    // A window that is too short is seen before it is used.
    let machine = Machine { harmonics: &claim.harmonics, c: 1.0, k: 0.1, tau: 1.0, nu: claim.depth() };
    for i in 0..=400 {
        let t = -TAU / 2.0 + TAU * f64::from(i) / 400.0;
        let inside = -claim.window[0] * slack <= t && t <= claim.window[1] * slack;
        if !inside && machine.wall(t)[0] > 1e-9 * claim.depth() {
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
    let scale = (machine.nu / claim.depth()).sqrt();
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
        let stretched = machine.after(displaced, next.time - at.time)[0].abs();
        let [from, to] = [at, next].map(|one| claim.weight(-machine.seen(one)[0] / machine.nu.sqrt()));
        let grown = stretched * to / from;
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
pub fn least_growth(text: &str, motions: usize) -> f64 {
    let claim = Claim::of(text);
    let ([c, k, tau], nu) = (claim.parameters[0], claim.depth());
    let machine = Machine { harmonics: &claim.harmonics, c, k, tau, nu };
    let (mut random, mut least) = (Random(3), f64::INFINITY);
    let weight = |at: Contact| claim.weight(-machine.seen(at)[0] / nu.sqrt());
    for _ in 0..motions {
        let height = claim.start / machine.slow() * random.part();
        let state = [height, claim.start * random.part() - machine.slow() * height];
        let mut at = machine.next(claim.window[1], state, claim.window).unwrap();
        for i in 0..12 {
            let (state, displaced) = machine.impact(at);
            let next = machine.next(at.time, state, claim.window).unwrap();
            if i > 2 {
                let grown = machine.after(displaced, next.time - at.time)[0].abs();
                least = least.min(grown * weight(next) / weight(at));
            }
            at = next;
        }
    }
    least
}

/// Of contacts with |V| = s√ν and some slips up to the greatest: the least growth to the next ones, and the
/// least and greatest |V|/√ν of those.
pub fn returns(text: &str, s: f64) -> [f64; 3] {
    let claim = Claim::of(text);
    let ([c, k, tau], nu) = (claim.parameters[0], claim.depth());
    let machine = Machine { harmonics: &claim.harmonics, c, k, tau, nu };
    let mut all = [f64::INFINITY, f64::INFINITY, 0.0f64];
    for i in 0..=20 {
        let slip = claim.slip * nu * f64::from(i) / 20.0;
        // The slope falls with the time.
        let (mut lo, mut hi) = (-claim.window[0], claim.window[1]);
        for _ in 0..80 {
            let middle = f64::midpoint(lo, hi);
            let [place, slope, _] = machine.wall(middle);
            if slope + machine.slow() * place - slip > s * nu.sqrt() { lo = middle } else { hi = middle }
        }
        let place = machine.wall(lo)[0];
        let at = Contact { time: lo, place, velocity: slip - machine.slow() * place };
        let (state, displaced) = machine.impact(at);
        let next = machine.next(at.time, state, claim.window).unwrap();
        let speed = -machine.seen(next)[0] / nu.sqrt();
        let grown = machine.after(displaced, next.time - at.time)[0].abs();
        all = [all[0].min(grown), all[1].min(speed), all[2].max(speed)];
    }
    all
}
