//! Grazing bifurcations of true systems: where they are, the local map there, and that what Theorem 1 says is
//! so.

use std::f64::consts::TAU;

use grazing_scenes::{
    local::Region,
    motion::Side,
    number::parse_rational,
    one::{
        grazing::{Grazing, locate},
        orbit::*,
    },
    pattern::{Graph, Pattern, Patterns},
    scene::{Scene, SceneFamily},
    search::touch::{InTheory, leading_impacts},
};

fn paper(d: f64, w: f64) -> Scene {
    let text = include_str!("../../examples/scenes/nordmark-2001.toml");
    let text =
        text.replacen("d = 0.6 ", &format!("d = {d:e} "), 1).replacen("w = 4.9 ", &format!("w = {w:e} "), 1);
    Scene::from_toml(&text, "test").unwrap()
}

fn lower(periods: &[u32]) -> Itinerary {
    Itinerary::at(Side::Lower, periods).unwrap()
}

/// The grazing found from the orbit of an itinerary nearest to `start`.
fn graze(family: &dyn Family, itinerary: &Itinerary, start: &[f64], parameter: f64) -> Grazing {
    let orbit = find(&family.at(parameter).unwrap(), itinerary, start.to_vec()).unwrap();
    locate(family, &orbit, parameter).unwrap()
}

fn at_rest(family: &dyn Family, parameter: f64) -> Grazing {
    graze(family, &Itinerary::free(1).unwrap(), &[0.1, 0.1], parameter)
}

#[test]
fn the_paper_s_grazing_has_the_map_of_its_formulas() {
    for (d, w) in [(0.6_f64, 4.9), (0.2, 1.7), (0.999_999, 3.0), (1.3, 2.0)] {
        let scene = paper(d, w);
        let grazing = at_rest(&SceneFamily::new(&scene, "mu").unwrap(), -0.04);
        let map = &grazing.map;
        assert!(grazing.parameter.abs() < 1e-14 && grazing.admissible, "{grazing:?}");
        assert!(grazing.phase().min(TAU - grazing.phase()) < 1e-7);
        assert!((map.acceleration - 1.0).abs() < 1e-12 && (map.e + 1.0).abs() < 1e-12);
        assert!((map.b[1] - 2.0 * 2.0_f64.sqrt()).abs() < 1e-12);
        // (69)–(74).
        let root = (1.0 - d * d).abs().sqrt() * TAU / w;
        let decay = (-TAU * d / w).exp();
        let a1 = 2.0 * decay * if d < 1.0 { root.cos() } else { root.cosh() };
        assert!((map.trace() - a1).abs() < 1e-12 && (map.determinant - decay * decay).abs() < 1e-14);
        let gamma = if d < 1.0 { root.sin() } else { 1.0 };
        assert!(map.gamma().unwrap() * gamma > 0.0, "d = {d}, w = {w}");
        assert_eq!(map.region(), Some(if d < 1.0 { Region::Three } else { Region::Two }));
    }
}

#[test]
fn a_forced_oscillator_grazes_a_fixed_wall_at_its_amplitude() {
    for (side, offset) in [("lower", -0.7), ("upper", 0.7)] {
        let text = format!(
            "format = \"grazing-scene 1\"\ntitle = \"t\"\n[parameters]\nf = 0.3\n[system]\ndamping = 0.2\nstiffness = 0.4\n\
             force = 0.08\nforcing = [{{ cos = \"f\", sin = \"f/2\" }}]\n[[walls]]\nside = \"{side}\"\noffset = {offset}\nrestitution = 0.5"
        );
        let scene = Scene::from_toml(&text, "test").unwrap();
        let grazing = at_rest(&SceneFamily::new(&scene, "f").unwrap(), 0.2);
        let gain = (1.0 + 0.25_f64).sqrt() / (0.6_f64 * 0.6 + 0.2 * 0.2).sqrt();
        let room = if side == "lower" { 0.7 + 0.2 } else { 0.7 - 0.2 };
        assert!((grazing.parameter - room / gain).abs() < 1e-13, "{grazing:?}");
        // The gap is room − f gain at the nearest point, where z″ is the amplitude.
        assert!((grazing.map.e + gain).abs() < 1e-12 && (grazing.map.acceleration - room).abs() < 1e-12);
        assert_eq!(grazing.side().name(), side);
    }
}

/// The orbits of section 4.2 that come to graze, and one of a Duffing oscillator: e and tr A against their
/// neighbours.
#[test]
fn e_is_the_rate_at_which_the_gap_of_the_orbit_opens() {
    let duffing = r#"
        format = "grazing-scene 1"
        title = "Duffing"
        [parameters]
        a = 0.3
        [system]
        damping = 0.3
        stiffness = 1.5
        cubic = "1 + a"
        forcing = [{ cos = "a", sin = 0.1 }]
        [[walls]]
        side = "upper"
        offset = 0.55
        harmonics = [{ k = 1, sin = "a/9" }]
        restitution = 0.8
        [accuracy]
        tolerance = 1e-14
    "#;
    let (duffing, paper) = (Scene::from_toml(duffing, "test").unwrap(), paper(0.6, 4.9));
    let cases = [
        (&duffing, "a", Itinerary::free(1).unwrap(), vec![0.0, 0.0], 0.2),
        (&paper, "mu", lower(&[4]), vec![-0.77, 0.67], -0.026),
        (&paper, "mu", lower(&[3, 3]), vec![-0.0957, 0.0999, -0.008, 0.028], 0.0058),
    ];
    // Near that grazing, in the parameters of the flow and of the impact.
    let close = paper.with(&[("mu".to_string(), parse_rational("-0.0245").unwrap())]).unwrap();
    let others = [
        (&close, "tau", lower(&[4]), vec![-0.77, 0.67], 0.999),
        (&close, "w", lower(&[4]), vec![-0.77, 0.67], 4.901),
        (&close, "d", lower(&[4]), vec![-0.77, 0.67], 0.6),
    ];
    for (scene, parameter, itinerary, start, near) in cases.into_iter().chain(others) {
        let family = SceneFamily::new(scene, parameter).unwrap();
        let grazing = graze(&family, &itinerary, &start, near);
        assert!(grazing.admissible && grazing.residual < 1e-13, "{grazing:?}");
        let mut z = find(&family.at(near).unwrap(), &itinerary, start).unwrap().z;
        let mut orbit = |away: f64| {
            let found = find(&family.at(grazing.parameter + away).unwrap(), &itinerary, z.clone()).unwrap();
            z.clone_from(&found.z);
            found
        };
        let h = 1e-7;
        let (minus, plus) = (orbit(-h), orbit(h));
        let gaps = [minus.least.unwrap().gap, plus.least.unwrap().gap];
        let (e, slope) = (grazing.map.e, (gaps[1] - gaps[0]) / (2.0 * h));
        assert!((slope - e).abs() < 1e-6 * e.abs().max(1.0), "{itinerary}: {slope} {e}");
        assert!((gaps[0] + gaps[1]).abs() < 1e-6 * e.abs(), "the gap is 0 there: {gaps:?}");
        let trace = (minus.multipliers.trace + plus.multipliers.trace) / 2.0;
        assert!((trace - grazing.map.trace()).abs() < 1e-6 * (1.0 + trace.abs()), "{itinerary}: {trace}");
    }
}

/// Theorem 1 against the true system: near grazing the orbit of every pattern that is not singular can be
/// found by Newton's method from its leading-order solution, on both sides; it is an orbit exactly where the
/// theorem says.
#[test]
fn the_true_system_has_the_orbits_of_the_local_theory_and_no_others() {
    let scene = paper(0.6, 4.9);
    let family = SceneFamily::new(&scene, "mu").unwrap();
    let gr4 = graze(&family, &lower(&[4]), &[-0.77, 0.67], -0.026);
    let gr3 = graze(&family, &lower(&[3, 3]), &[-0.0957, 0.0999, -0.008, 0.028], 0.0058);
    for (grazing, last, distance) in [(&at_rest(&family, -0.1), 5, 1e-7), (&gr4, 4, 1e-8), (&gr3, 2, 1e-8)] {
        let graph = Graph::new(&grazing.map.to_map().unwrap(), last, false).unwrap();
        let e = grazing.map.e;
        let mut counts = [0; 2];
        for pattern in (1..=last).flat_map(Patterns::of_period).filter(Pattern::is_primitive) {
            let report = graph.judge(pattern.periods());
            for positive in [true, false] {
                let solve = |distance: f64| {
                    let away = if positive { distance } else { -distance } / e;
                    let parameter = grazing.parameter + away;
                    let impacts = leading_impacts(&report, pattern.periods()).unwrap();
                    let (itinerary, z) = grazing.start(&family, &impacts, parameter).unwrap();
                    let orbit = find(&family.at(parameter).unwrap(), &itinerary, z.clone())
                        .unwrap_or_else(|error| panic!("{pattern}: {error}"));
                    let error = z.iter().zip(&orbit.z).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                    (orbit, error)
                };
                let (orbit, close) = solve(distance);
                let exists = report.side() == Some(positive);
                assert_eq!(orbit.admissibility.is_admissible(), exists, "{pattern} {positive}: {orbit:?}");
                counts[usize::from(exists)] += 1;
                // The start is right to first order: its error is of second.
                let (_, far) = solve(4.0 * distance);
                assert!(
                    far < 2e-2 * distance.sqrt() && close < 0.15 * far + 1e-13,
                    "{pattern}: {close} {far}"
                );
                if exists {
                    let predicted = grazing.map.leading(pattern.periods()).unwrap()
                        / (if positive { distance } else { -distance }).powi(pattern.periods().len() as i32);
                    let ratio = orbit.multipliers.values()[0].0 / predicted;
                    assert!((ratio - 1.0).abs() < 0.1, "{pattern}: {ratio}");
                    let enclosed = report.orbit.as_ref().unwrap().leading.as_ref().unwrap().enclosure();
                    let leading = grazing.map.leading(pattern.periods()).unwrap();
                    assert!(enclosed.lo() <= leading && leading <= enclosed.hi(), "{pattern}");
                }
            }
        }
        assert!(counts[0] > 0 && counts[1] > 1, "{counts:?}");
    }
}

/// Grazing at the section, in normal form (45): the coefficient of the large eigenvalue by (61).
#[test]
fn the_large_eigenvalue_s_coefficient_is_that_of_the_formula() {
    let (d, w) = (0.6_f64, 4.9_f64);
    let map = at_rest(&SceneFamily::new(&paper(d, w), "mu").unwrap(), -0.1).map;
    let (r, theta) = ((-TAU * d / w).exp(), TAU * (1.0 - d * d).sqrt() / w);
    for n in 1..=7 {
        let k = f64::from(n);
        let u = r.powi(n - 1) * (k * theta).sin() / theta.sin();
        let product = 1.0 - 2.0 * r.powi(n) * (k * theta).cos() + r.powi(2 * n);
        let kick = 8.0_f64.sqrt();
        let expected = kick * kick * map.gamma().unwrap().powi(2) * u * u / (2.0 * product);
        let found = map.leading(&[n as u64]).unwrap();
        assert!((found / expected - 1.0).abs() < 1e-10, "{n}: {found} {expected}");
    }
}

/// An oscillator with two stops that mirror each other, or one, its force given as keys or as a formula.
fn stopped(system: &str, both: bool) -> Scene {
    let wall =
        |side: &str, at: i32| format!("[[walls]]\nside = \"{side}\"\noffset = {at}\nrestitution = 0.8\n");
    let lower = if both { wall("lower", -1) } else { String::new() };
    let text = format!(
        "format = \"grazing-scene 1\"\ntitle = \"t\"\n[parameters]\nF = 0.6\n[system]\n{system}\n{}{lower}",
        wall("upper", 1)
    );
    Scene::from_toml(&text, "test").unwrap()
}

/// One equation in two forms has one local map, whose a₂ is e^{−0.1·2π}; half a period's is e^{−0.1·π}.
#[test]
fn damping_in_a_formula_is_in_the_local_map() {
    let forms = [
        "damping = \"1/10\"\nstiffness = \"3/10\"\nforcing = [{ cos = \"F\" }]",
        "force = \"-u/10 - 3/10*q + F*cos(t)\"",
        // No longer linear as far as its form tells.
        "force = \"-u/10 - 3/10*q + F*cos(t) + 0*exp(q)*u + 0*sin(u)\"",
    ];
    for both in [false, true] {
        let maps = forms.map(|form| {
            let scene = stopped(form, both);
            let family = SceneFamily::new(&scene, "F").unwrap();
            let grazing = at_rest(&family, 0.6);
            let half = grazing.half_map(&family.at(grazing.parameter).unwrap());
            assert_eq!(half.is_some(), both, "{form}");
            (grazing, half)
        });
        for (grazing, half) in &maps {
            let (known, other) = (&maps[0].0, &grazing.map);
            assert!((other.determinant - (-0.1 * TAU).exp()).abs() < 1e-13, "{other:?}");
            assert!((other.trace() - known.map.trace()).abs() < 1e-12);
            assert!((grazing.parameter - known.parameter).abs() < 1e-12);
            assert_eq!(other.region(), known.map.region());
            if let Some(half) = half {
                assert!((half.determinant - (-0.05 * TAU).exp()).abs() < 1e-13, "{half:?}");
            }
        }
    }
}

/// q = −cos t touches both stops at F = 0.7; what is added vanishes on it, and is the same on both sides.
#[test]
fn a_force_that_is_not_its_mirror_image_has_no_map_of_half_a_period() {
    for (added, symmetric) in
        [("", true), ("*q", true), ("*cos(2*t)*u", true), ("*1", false), ("*cos(t)*q", false)]
    {
        let extra = if added.is_empty() { String::new() } else { format!("+ 0.1*(q^2 + u^2 - 1){added}") };
        let scene = stopped(&format!("force = \"-0.3*q + F*cos(t) {extra}\""), true);
        let family = SceneFamily::new(&scene, "F").unwrap();
        let grazing = graze(&family, &Itinerary::free(1).unwrap(), &[-1.0, 0.0], 0.7);
        assert!((grazing.parameter - 0.7).abs() < 1e-10, "{added}: {}", grazing.parameter);
        let half = grazing.half_map(&family.at(grazing.parameter).unwrap());
        assert_eq!(half.is_some(), symmetric, "{added}");
    }
}
