//! Backbone curves: against elliptic integrals by Gauss's mean, motions that come back, the same machine
//! under other drives, and where curves end.

use std::f64::consts::{PI, TAU};

use grazing_scenes::run::BackboneRow;

use super::responses::{found, reports, task};
use crate::tasks::{near, number};

/// The arithmetic-geometric mean.
pub(super) fn agm(mut a: f64, mut b: f64) -> f64 {
    while (a - b).abs() > 1e-15 * a {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    a
}

/// The backbone of a Duffing oscillator is that of Jacobi's cosine, and the response leans about it: where it
/// swings most it is on it.
#[test]
fn the_backbone_of_a_cubic_spring_is_jacobis() {
    let scene = format!(
        "[parameters]\nw = 1\n[system]\ndamping = \"0.02/w\"\nstiffness = \"1/w^2\"\ncubic = \"0.2/w^2\"\n\
         forcing = [{{ cos = \"0.06/w^2\" }}]\n{}",
        task("w", [0.8, 2.0], 61, "backbone = true\ntransient = 600\nsweep = \"up\"")
    );
    let found = found(&scene);
    let backbone = found.backbone.as_ref().unwrap();
    assert!(backbone.len() > 10);
    for row in backbone {
        let whole = 1.0 + 0.2 * row.swing * row.swing;
        let rate = whole.sqrt() * agm(1.0, (1.0 - 0.1 * row.swing * row.swing / whole).sqrt());
        near(row.value, rate, 1e-13);
    }
    // The same in other units, by the engine for formulas, too, and about a place of rest of a constant
    // force.
    let seconds = |engine: &str, stiffness: &str, force: &str| {
        format!(
            "engine = {engine:?}\n[parameters]\nf = 1\n[system]\nfrequency = \"f\"\nmass = 2\ndamping = 0.04\nstiffness = {stiffness}\n\
             cubic = 0.4\nforce = {force}\nforcing = [{{ cos = 0.12 }}]\n{}",
            task("f", [0.8 / TAU, 2.0 / TAU], 61, "backbone = true\nseen = false")
        )
    };
    for engine in ["one", "many"] {
        let other = self::found(&seconds(engine, "2", "0"));
        let other = other.backbone.as_ref().unwrap();
        assert!(other.len() > 3);
        for row in other {
            let same = backbone.iter().find(|known| (known.value - TAU * row.value).abs() < 1e-12).unwrap();
            near(row.swing, same.swing, 1e-10);
        }
        let pushed = self::found(&seconds(engine, "2", "0.1"));
        let pushed = pushed.backbone.as_ref().unwrap();
        assert!(pushed.iter().zip(other).any(|(a, b)| (a.swing - b.swing).abs() > 1e-6), "{pushed:?}");
        let report = reports(&seconds(engine, "-2", "0")).unwrap().remove(0).to_string();
        assert!(
            report.contains("failed: backbone = true") && report.contains("lead away from q = 0"),
            "{report}"
        );
    }
    let highest = &found.highest.as_ref().unwrap()[0];
    let off = |row: &&BackboneRow| (row.value - highest.value).abs();
    let on = backbone.iter().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap();
    assert!((on.swing - highest.swing).abs() < 0.05 * on.swing, "{on:?} {highest:?}");
}

/// A free vibration with a swing of the backbone is back after a period of the drive: of a machine with a
/// second spring, and of an oscillator below a stop; two where the frequency is twice the drive's.
#[test]
fn a_free_vibration_of_the_backbone_is_back_after_a_period() {
    let spring = "[parameters]\nf = 1\nF = 1\n[system]\nfrequency = \"f\"\nmass = 2\ndamping = \"0.3*F\"\nstiffness = 80\n\
                  forcing = [{ cos = \"F\" }, { k = 2, cos = \"F\" }]\n[[stops]]\nname = \"second\"\nrow = [-1]\n\
                  offset = -0.02\nstiffness = 300\ndamping = \"0.2*F\"\n";
    let stop = "[parameters]\nf = 1\nF = 1\n[system]\ndamping = \"F/(10*f)\"\nstiffness = \"40/f^2\"\n\
                forcing = [{ cos = \"F/f^2\" }, { k = 2, cos = \"F/f^2\" }]\n[[stops]]\nside = \"upper\"\noffset = 0.02\n\
                restitution = \"1 - F/10\"\n";
    // The least displacement of a vibration with this swing.
    let sprung = |swing: f64| {
        let off = |top: f64| {
            let deep = (top - 0.02).max(0.0);
            top + (top * top + 300.0 / 80.0 * deep * deep).sqrt() - 2.0 * swing
        };
        let (mut low, mut high) = (0.0, 2.0 * swing);
        for _ in 0..80 {
            let middle = (low + high) / 2.0;
            *(if off(middle) < 0.0 { &mut low } else { &mut high }) = middle;
        }
        low - 2.0 * swing
    };
    let stopped = |swing: f64| 0.02 - 2.0 * swing;
    for is_sprung in [true, false] {
        let (system, unit) = if is_sprung { (spring, 1.0) } else { (stop, TAU) };
        for (k, range) in [(1, [1.03, 1.3]), (2, [0.52, 0.65])] {
            let range = range.map(|end: f64| end * unit);
            let more = format!("harmonic = {k}\nbackbone = true\nseen = false");
            let found = found(&format!("{system}{}", task("f", range, 5, &more)));
            let backbone = found.backbone.unwrap();
            assert!(backbone.len() >= 4, "{backbone:?}");
            for row in backbone {
                let low = if is_sprung { sprung(row.swing) } else { stopped(row.swing) };
                let back = format!(
                    "{system}[[tasks]]\nname = \"it\"\nkind = \"simulate\"\nset = {{ f = {:?}, F = 0 }}\n\
                     start = {{ q = {low:?} }}\nperiods = 1\n",
                    row.value
                );
                let back = serde_json::to_value(&reports(&back).unwrap()[0]).unwrap();
                assert_eq!(back["impacts"], k, "{row:?} {back}");
                near(number(&back["q"][0]), low, 1e-11 * low.abs());
            }
        }
    }
    for (text, why) in [
        (
            "[parameters]\nf = 1\n[system]\nforce = \"-f*sin(q)*(1 + cos(t))\"\n".to_string(),
            "a term of it with velocity or time",
        ),
        (stop.replace("offset = 0.02", "offset = 0.02\nharmonics = [{ cos = 0.001 }]"), "a stop moves"),
    ] {
        let error = reports(&format!("{text}{}", task("f", [1.0, 2.0], 5, "backbone = true"))).unwrap_err();
        assert!(error.to_string().contains(why), "{error}");
    }
}

/// The amplitude A of u″ + u + u³ at a frequency: 2π f = √(1 + A²) M(1, √(1 − A²/(2 + 2A²))), by halving.
fn duffing_amplitude(frequency: f64) -> f64 {
    let (mut low, mut high) = (0.0, 10.0);
    for _ in 0..100 {
        let middle: f64 = (low + high) / 2.0;
        let whole = 1.0 + middle * middle;
        let rate = whole.sqrt() * agm(1.0, (1.0 - middle * middle / (2.0 * whole)).sqrt());
        *(if rate < TAU * frequency { &mut low } else { &mut high }) = middle;
    }
    low
}

/// A backbone is of the free machine: the same points without a drive, under one that is next to nothing, and
/// under one that is large, of a cube as a key and as a formula.
#[test]
fn a_backbone_depends_on_no_drive() {
    let task = task("f", [0.17, 0.3], 14, "backbone = true\nseen = false");
    near(duffing_amplitude(0.25), 1.416805854, 1e-9);
    let undriven = task.replace("seen = false", "");
    let forced = "stiffness = 1\ncubic = 1\nforcing = [{ cos = 1e-9 }]\ndamping = 0.001";
    for (system, task) in [
        ("stiffness = 1\ncubic = 1", &undriven),
        (forced, &task),
        (&forced.replace("1e-9", "30"), &task),
        ("force = \"-q - q^3\"", &undriven),
        ("force = \"-0.3*u - (q + 2*q^3/2 - 4*cos(t) + 0.2*u*q^2)\"", &task),
    ] {
        for engine in ["one", "many"] {
            let found = found(&format!(
                "engine = {engine:?}\n[parameters]\nf = 0.2\n[system]\nfrequency = \"f\"\n{system}\n{task}"
            ));
            let backbone = found.backbone.as_ref().unwrap();
            assert_eq!(backbone.len(), 14, "{system}");
            for row in backbone {
                near(row.swing, duffing_amplitude(row.value), 1e-12);
            }
            let ends: Vec<_> =
                found.backbone_ends.as_ref().unwrap().iter().map(|end| (end.value, end.why)).collect();
            assert_eq!(ends, [(0.17, "range"), (0.3, "range")]);
        }
    }
}

/// Where a backbone ends, and why.
fn ends(system: &str, range: [f64; 2]) -> Vec<(&'static str, f64, Option<f64>)> {
    let task = task("w", range, 6, "backbone = true");
    let found = found(&format!("[parameters]\nw = 1\n[system]\nperiod = \"2*pi/w\"\n{system}\n{task}"));
    found.backbone_ends.unwrap().into_iter().map(|end| (end.why, end.value, end.swing)).collect()
}

/// At the natural frequency, with the swing up to which all have it; where ever larger swings tend to.
#[test]
fn a_backbone_says_where_it_ends() {
    let cubic = ends("stiffness = 1\ncubic = 0.216", [0.9, 3.0]);
    let [("natural frequency", w, Some(0.0)), ("range", 3.0, Some(swing))] = cubic[..] else {
        panic!("{cubic:?}")
    };
    near(w, 1.0, 1e-11);
    near(swing, duffing_amplitude(3.0 / TAU) / 0.216f64.sqrt(), 1e-11);
    let stop = "stiffness = 1\n[[stops]]\nside = \"upper\"\noffset = 0.495\nrestitution = 0.9";
    let stopped = ends(stop, [0.9, 3.0]);
    let [("natural frequency", w, Some(touch)), ("largest swings", most, None)] = stopped[..] else {
        panic!("{stopped:?}")
    };
    near(w, 1.0, 1e-11);
    near(touch, 0.495, 1e-6);
    near(most, 2.0, 1e-5);
}

/// At a hill, which a pendulum slower than any that rounding knows comes to.
#[test]
fn a_backbone_ends_at_a_hill() {
    let pendulum = ends("force = \"-sin(q)\"", [0.01, 1.2]);
    let [("hill", slow, Some(top)), ("natural frequency", w, Some(0.0))] = pendulum[..] else {
        panic!("{pendulum:?}")
    };
    near(w, 1.0, 1e-11);
    near(top, PI, 4e-6);
    near(slow, agm(1.0, (5e-7 * PI).sin()), 1e-4);
}

/// Where two swings become one: k = 1, softer, then harder, the least frequency by the elliptic integral's
/// own quadrature.
#[test]
fn a_backbone_ends_where_it_turns_back() {
    let bent = ends("force = \"-q + 1.5*q^3 - q^5\"", [0.5, 1.5]);
    let [("turns back", least, Some(swing)), ("natural frequency", w, Some(0.0)), ("range", 1.5, Some(_))] =
        bent[..]
    else {
        panic!("{bent:?}")
    };
    near(w, 1.0, 1e-11);
    let rate = |a: f64| {
        let v = |q: f64| q * q / 2.0 - 1.5 * q.powi(4) / 4.0 + q.powi(6) / 6.0;
        let n = 4000;
        // q = a sin s, by the midpoint rule, which is exact to rounding for a period.
        let time = (0..n).map(|i| {
            let s = PI / 2.0 * (f64::from(i) + 0.5) / f64::from(n);
            a * s.cos() / (2.0 * (v(a) - v(a * s.sin()))).sqrt() * PI / 2.0 / f64::from(n)
        });
        PI / 2.0 / time.sum::<f64>()
    };
    near(rate(swing), least, 1e-8);
    assert!(rate(0.9 * swing) > least && rate(1.1 * swing) > least);
}

/// Nothing is found, and why: of a linear spring, and of one that is too fast for the range.
#[test]
fn a_backbone_without_points_is_not_done() {
    for (system, why) in [
        ("stiffness = 1\ndamping = 0.1\nforcing = [{ cos = 0.05 }]", "have one frequency"),
        ("stiffness = 25\ncubic = 1", "are faster at every value"),
        ("stiffness = 0.01\ncubic = -1", "are slower at every value"),
        ("force = 1", "no place of rest"),
    ] {
        let task = task("w", [0.9, 3.0], 4, "backbone = true");
        let report =
            reports(&format!("[parameters]\nw = 1\n[system]\nperiod = \"2*pi/w\"\n{system}\n{task}"));
        let report = report.unwrap().remove(0);
        assert_eq!(report.status.word(), "nothing found", "{report}");
        let reason = report.status.reason().unwrap_or_default();
        assert!(reason.contains("the backbone has no point") && reason.contains(why), "{reason}");
    }
}
