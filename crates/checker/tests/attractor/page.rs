//! The numbers of a certificate against the page's formulas, as they stand there.

use std::f64::consts::TAU;

use super::machine;
use crate::common::{answer, float};

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
