//! Steep forces on two coordinates against the second integrator's extrapolation, with steps that follow the
//! layers.

use super::{
    second::{extrapolated, pair_with},
    *,
};
use crate::samples::samples;

fn built(body: &str) -> Machine<f64> {
    let text = format!("format = \"grazing-scene 3\"\ntitle = \"steep\"\n{body}");
    let scene = Scene::from_toml(&text, "steep.toml").unwrap_or_else(|error| panic!("{body}: {error}"));
    scene.machine(&[]).unwrap()
}

/// A steep force: its text and what it is, of tanh of linear functions over widths, nested, and high powers
/// of cosines.
#[derive(Clone)]
struct Steep {
    /// Factor, kind, width, and two linear functions of q1, q2, u1 and u2 with constants.
    terms: Vec<(f64, u32, f64, [[f64; 5]; 2])>,
}

impl Steep {
    fn text(&self) -> String {
        let of = |[a, b, c, d, e]: [f64; 5]| format!("({a:?})*q1+({b:?})*q2+({c:?})*u1+({d:?})*u2+({e:?})");
        let one = |(factor, kind, width, [x, y]): &(f64, u32, f64, [[f64; 5]; 2])| match kind {
            0 => format!("({factor:?})*tanh(({})/{width:?})", of(*x)),
            1 => format!("({factor:?})*tanh(({} + 0.3*tanh(({})/{width:?}))/{width:?})", of(*x), of(*y)),
            2 => format!("({factor:?})*tanh(({})/{width:?})*({})", of(*x), of(*y)),
            _ => format!("({factor:?})*cos(6*({}))^8", of(*x)),
        };
        self.terms.iter().map(one).collect::<Vec<_>>().join(" + ")
    }

    /// Its value, and how long the motion takes to come anywhere else in it.
    fn at(&self, x: &[f64], rate: &[f64]) -> [f64; 2] {
        let linear = |by: &[f64; 5], x: &[f64], constant: f64| {
            by[..4].iter().zip(x).map(|(a, b)| a * b).sum::<f64>() + by[4] * constant
        };
        let (mut sum, mut time) = (0.0, f64::INFINITY);
        for (factor, kind, width, [first, second]) in &self.terms {
            let (a, b) = (linear(first, x, 1.0), linear(second, x, 1.0));
            let (da, db) = (linear(first, rate, 0.0).abs(), linear(second, rate, 0.0).abs());
            let inner = (b / width).tanh();
            sum += factor
                * match kind {
                    0 => (a / width).tanh(),
                    1 => ((a + 0.3 * inner) / width).tanh(),
                    2 => (a / width).tanh() * b,
                    _ => (6.0 * a).cos().powi(8),
                };
            // How far it is to each layer, over how fast that is gone.
            let mut layer = |apart: f64, speed: f64, own: f64| {
                time = time.min((own + 0.3 * apart.abs()) / (speed + 1e-9));
            };
            match kind {
                1 => {
                    layer(b, db, *width);
                    layer(a + 0.3 * inner, da + 0.3 * db * (1.0 - inner * inner) / width, *width);
                }
                3 => layer(0.0, da, 0.03),
                _ => layer(a, da, *width),
            }
        }
        [sum, time]
    }
}

/// The bound on a step looks at all coordinates: where what is infinite of one hid that of another, steps
/// leapt over layers.
#[test]
fn steep_forces_on_two_coordinates_are_not_leapt_over() {
    let mut state = 77u64;
    let mut random = |low: f64, high: f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let x = (state >> 11) as f64 / (1u64 << 53) as f64;
        ((low + (high - low) * x) * 1e4).round() / 1e4
    };
    let trials: u64 = samples(4);
    let (mut wrong, mut ended, mut open, mut worst) = (vec![], 0, 0, 0.0f64);
    for case in 0..trials {
        let mut force = || Steep {
            terms: (0..2)
                .map(|_| {
                    let linear =
                        |random: &mut dyn FnMut(f64, f64) -> f64| std::array::from_fn(|_| random(-1.0, 1.0));
                    let width = 10f64.powi(-(random(1.0, 4.999).floor() as i32));
                    let kind = random(0.0, 3.999).floor() as u32;
                    (random(-0.5, 0.5), kind, width, [linear(&mut random), linear(&mut random)])
                })
                .collect(),
        };
        let forces = [force(), force()];
        let text = pair_with([forces[0].text(), forces[1].text()]);
        let machine = built(&text);
        let simulator = simulator(&machine);
        let (begin, until) = ([0.7, -0.3, 0.2, 0.4], 3.0);
        let mut run = simulator.start(at(0.0), &begin[..2], &begin[2..]).unwrap();
        if run.finish(at(0.0).after(until)) != RunEnd::Reached {
            ended += 1;
            continue;
        }
        let slope = |t: f64, x: &[f64]| {
            let [a, b] = forces.each_ref().map(|force| force.at(x, x)[0]);
            vec![
                x[2],
                x[3],
                a - 2.0 * x[0] + 0.5 * x[1] - 0.2 * x[2] + t.cos(),
                b + 0.5 * x[0] - 1.5 * x[1] - 0.3 * x[3],
            ]
        };
        let follow = |share: f64, begin: [f64; 4]| {
            let (mut t, mut x) = (0.0, begin.to_vec());
            while t < until {
                let rate = slope(t, &x);
                let time = forces.iter().map(|force| force.at(&x, &rate)[1]).fold(0.05, f64::min);
                let h = (share * time).max(1e-9).min(until - t);
                x = extrapolated(&x, h, |after, x| slope(t + after, x));
                t += h;
            }
            x
        };
        let (known, coarse) = (follow(0.1, begin), follow(0.2, begin));
        let beside = |by: [f64; 4]| {
            let moved = std::array::from_fn(|i| begin[i] + 1e-10 * by[i]);
            apart(&known, &follow(0.2, moved)) / 1e-10
        };
        let amplified = beside([1.0; 4]).max(beside([1.0, -1.0, 1.0, -1.0])).max(1.0);
        // What the second integrator does not know itself says nothing.
        let unknown = apart(&known, &coarse) / amplified;
        if unknown > 1e-10 {
            open += 1;
            continue;
        }
        let off = apart(run.state().q(), &known[..2]).max(apart(run.state().u(), &known[2..])) / amplified;
        worst = worst.max(off);
        if off > 1e-9 {
            wrong.push((case, off, text));
        }
    }
    println!(
        "of {trials} steep forces {ended} ended with a warning, {open} are not known; off by at most {worst:e}"
    );
    assert!(wrong.is_empty() && ended + open < trials / 2, "{ended} ended, {open} not known; {wrong:?}");
}
