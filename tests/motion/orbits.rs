//! Periodic orbits of the true system: equations and derivatives, Newton's method, exact formulas,
//! admissibility, bifurcations.

use std::f64::consts::{PI, SQRT_2, TAU};

use grazing_scenes::{
    continuation::{Bifurcation, BranchSearch, Options},
    motion::{Contact, Flow, Side, State},
    one::{branch::locate, orbit::*},
    scene::{Scene, SceneFamily},
};
use serde::Deserialize;

use crate::samples::samples;

const PAPER: &str = r#"
    format = "grazing-scene 1"
    title = "the paper's oscillator"
    [parameters]
    d = 0.6
    w = 4.9
    tau = 1
    mu = 0
    [system]
    damping = "2*d/w"
    stiffness = "1/w^2"
    [[walls]]
    side = "lower"
    offset = -1
    harmonics = [{ k = 1, cos = "1 + mu" }]
    restitution = "tau"
"#;

/// Forced, between two walls of which one moves, stiffness growing with displacement.
const RICH: &str = r#"
    format = "grazing-scene 1"
    title = "every effect"
    [parameters]
    p = 0.3
    [system]
    damping = "0.1 + p/10"
    stiffness = "0.7 + p^2"
    cubic = "p/2"
    force = "p/5"
    forcing = [{ k = 1, cos = "1 - p", sin = 0.2 }, { k = 2, sin = "p" }]
    [[walls]]
    side = "lower"
    offset = "-0.5 - p/7"
    harmonics = [{ k = 1, cos = "p/4", sin = 0.1 }]
    restitution = "0.8 - p/3"
    [[walls]]
    side = "upper"
    offset = 0.6
    restitution = "0.5 + p"
    [accuracy]
    tolerance = 1e-14
"#;

fn scene(text: &str) -> Scene {
    Scene::from_toml(text, "test").unwrap()
}

/// The paper's scene with other values.
fn paper(d: f64, w: f64, tau: f64) -> Scene {
    let values = [("d = 0.6", d), ("w = 4.9", w), ("tau = 1", tau)];
    let change = |text: String, (old, value): (&str, f64)| {
        text.replacen(old, &format!("{}= {value:e}", old.split('=').next().unwrap()), 1)
    };
    scene(&values.into_iter().fold(PAPER.to_string(), change))
}

fn at(scene: &Scene, parameter: &str, value: f64) -> Oscillator {
    SceneFamily::new(scene, parameter).unwrap().at(value).unwrap()
}

fn lower(periods: &[u32]) -> Itinerary {
    Itinerary::at(Side::Lower, periods).unwrap()
}

fn strikes(list: &[(Side, u32)]) -> Itinerary {
    Itinerary::new(list.iter().map(|&(side, periods)| Strike { place: side, periods }).collect()).unwrap()
}

fn near(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * (1.0 + b.abs())
}

#[test]
fn all_derivatives_of_the_equations_agree_with_differences() {
    use Side::{Lower, Upper};
    let (rich, simple) = (scene(RICH), scene(PAPER));
    let cases: [(&Scene, &str, f64, Itinerary, Vec<f64>); 7] = [
        (&rich, "p", 0.3, strikes(&[(Lower, 0), (Upper, 1)]), vec![0.3, 0.4, 2.9, 0.7]),
        (
            &rich,
            "p",
            0.3,
            strikes(&[(Lower, 1), (Lower, 0), (Upper, 1)]),
            vec![0.1, 0.2, 0.5, -0.3, 2.0, 0.0],
        ),
        (&rich, "p", 0.2, Itinerary::free(2).unwrap(), vec![0.1, -0.3]),
        (&rich, "p", 0.3, strikes(&[(Upper, 1)]), vec![4.0, 0.6]),
        (&simple, "w", 4.9, lower(&[3]), vec![-0.1, 0.2]),
        (&simple, "mu", 0.02, lower(&[2, 1]), vec![-0.1, 0.0, 0.2, -0.4]),
        (&simple, "tau", 0.9, lower(&[4]), vec![-0.1, 0.3]),
    ];
    for (scene, parameter, value, itinerary, z) in cases {
        let f = |z: &[f64], p: f64| linearise(&at(scene, parameter, p), &itinerary, z).unwrap();
        let exact = f(&z, value);
        let h = 1e-5;
        for j in 0..=z.len() {
            let moved = |h: f64| {
                let mut z = z.clone();
                let p = if j < z.len() {
                    z[j] += h;
                    value
                } else {
                    value + h
                };
                f(&z, p).residual
            };
            let (plus, minus) = (moved(h), moved(-h));
            for i in 0..z.len() {
                let difference = (plus[i] - minus[i]) / (2.0 * h);
                let entry = if j < z.len() { exact.jacobian[i][j] } else { exact.slope[i] };
                assert!(
                    near(difference, entry, 1e-7),
                    "{itinerary} {parameter} F{i} by {j}: {difference} {entry}"
                );
            }
        }
    }
}

/// The multipliers a second way: each leg takes (t_i, V_i) to (t_{i+1}, V_{i+1}), by the implicit function
/// theorem.
#[test]
fn the_multipliers_are_those_of_the_impact_map() {
    let rich = scene(RICH);
    let oscillator = at(&rich, "p", 0.3);
    let simple = at(&scene(PAPER), "mu", 0.0058);
    let cases = [
        (&oscillator, strikes(&[(Side::Lower, 0), (Side::Upper, 1)]), 1.5),
        (&simple, lower(&[3, 3]), 0.3),
        (&simple, lower(&[1, 2]), 0.3),
    ];
    for (oscillator, itinerary, speed) in cases {
        let found = search(oscillator, &itinerary, samples(100), speed);
        assert!(!found.is_empty(), "{itinerary}");
        for orbit in found {
            let jacobian = linearise(oscillator, &itinerary, &orbit.z).unwrap().jacobian;
            let block = |i: usize, j: usize| [0, 1].map(|r| [0, 1].map(|c| jacobian[2 * i + r][2 * j + c]));
            let step = |i: usize| {
                let (from, to) = (block(i, i), block(i, 1 - i));
                let det = to[0][0] * to[1][1] - to[0][1] * to[1][0];
                let inverse = [[to[1][1], -to[0][1]], [-to[1][0], to[0][0]]];
                product(inverse, from).map(|row| row.map(|x| -x / det))
            };
            let around = product(step(1), step(0));
            let trace = around[0][0] + around[1][1];
            let size = around.as_flattened().iter().fold(1.0, |most: f64, x| most.max(x.abs()));
            assert!((trace - orbit.multipliers.trace).abs() < 1e-9 * size, "{itinerary}: {trace} {orbit:?}");
            let det = around[0][0] * around[1][1] - around[0][1] * around[1][0];
            assert!((det - orbit.multipliers.determinant).abs() < 1e-9 * size * size, "{itinerary}: {det}");
        }
    }
}

fn product(a: [[f64; 2]; 2], b: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    [0, 1].map(|i| [0, 1].map(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j]))
}

#[derive(Deserialize)]
struct Cases {
    case: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    name: String,
    d: f64,
    w: f64,
    tau: f64,
    mu: f64,
    pattern: Vec<u32>,
    z: Vec<f64>,
    trace: f64,
    determinant: f64,
    least: Option<f64>,
    admissible: bool,
    tolerance: f64,
}

/// References in 50 digits by other means (tests/data/make_orbits.py).
#[test]
fn hard_cases_have_the_digits_of_their_references() {
    let cases: Cases = toml::from_str(include_str!("../data/orbits.toml")).unwrap();
    for case in cases.case {
        let scene = paper(case.d, case.w, case.tau);
        let oscillator = at(&scene, "mu", case.mu);
        let start = case.z.iter().map(|z| z * (1.0 + 1e-5)).collect();
        let orbit = find(&oscillator, &lower(&case.pattern), start)
            .unwrap_or_else(|error| panic!("{}: {error}", case.name));
        for (z, reference) in orbit.z.iter().zip(&case.z) {
            // Absolute errors of t and V are those of q and u, of size 1.
            assert!((z - reference).abs() <= case.tolerance, "{}: {z} {reference}", case.name);
        }
        let slow = case.z.iter().skip(1).step_by(2).fold(f64::INFINITY, |least, v| least.min(v.abs()));
        let close = |a: f64, b: f64, what: &str| {
            let error = case.tolerance.max(1e-14 / slow) * (1.0 + b.abs());
            assert!((a - b).abs() <= error, "{}: {what} {a} {b}", case.name);
        };
        close(orbit.multipliers.trace, case.trace, "trace");
        close(orbit.multipliers.determinant, case.determinant, "determinant");
        assert_eq!(orbit.admissibility.is_admissible(), case.admissible, "{}: {orbit:?}", case.name);
        assert_eq!(orbit.least.is_some(), case.least.is_some(), "{}: {orbit:?}", case.name);
        if let (Some(least), Some(reference)) = (orbit.least, case.least) {
            close(least.gap, reference, "least gap");
        }
        if let &[n] = &case.pattern[..] {
            let exact = SingleImpact::new(oscillator.system(), Side::Lower, n).unwrap();
            let Some(speed) =
                exact.speeds().into_iter().find(|v| (v - case.z[1]).abs() < 10.0 * case.tolerance)
            else {
                assert!(case.z[1] < 0.0, "{}: no exact speed", case.name);
                continue;
            };
            let phase = exact.phase(speed);
            assert!(
                (phase - case.z[0].rem_euclid(TAU)).abs() < 10.0 * case.tolerance,
                "{}: {phase}",
                case.name
            );
            close(exact.multipliers(speed).trace, case.trace, "exact trace");
            close(exact.multipliers(speed).determinant, case.determinant, "exact determinant");
        }
    }
}

/// Forcing in place of a moving wall, another harmonic, the upper wall, a load: the exact formulas and
/// Newton's method.
#[test]
fn exact_single_impact_orbits_solve_the_equations() {
    let scenes = [
        (
            "damping = 0.3\nstiffness = 0.2\nforce = 0.1\nforcing = [{ cos = 0.5, sin = 0.7 }]",
            "lower",
            "-0.2",
            "[]",
        ),
        (
            "damping = 0.3\nstiffness = 0.2\nforce = 0.1\nforcing = [{ cos = 0.5, sin = 0.7 }]",
            "upper",
            "0.4",
            "[]",
        ),
        (
            "damping = 0.1\nstiffness = 0.9\nforcing = [{ k = 2, sin = 0.6 }]",
            "upper",
            "0.1",
            "[{ k = 2, cos = 0.3 }]",
        ),
        ("damping = 1.5\nstiffness = 0.1", "lower", "-0.1", "[{ k = 3, cos = 0.2, sin = -0.3 }]"),
    ];
    for (system, side, offset, harmonics) in scenes {
        let text = format!(
            "format = \"grazing-scene 1\"\ntitle = \"t\"\n[system]\n{system}\n[[walls]]\nside = \"{side}\"\n\
             offset = {offset}\nharmonics = {harmonics}\nrestitution = 0.7"
        );
        let system = scene(&text).plain(&[]).unwrap();
        let side = if side == "lower" { Side::Lower } else { Side::Upper };
        let oscillator = Oscillator::new(system.clone(), 1e-12).unwrap();
        let mut orbits = 0;
        for n in 1..=5 {
            let exact = SingleImpact::new(&system, side, n).unwrap();
            for speed in exact.speeds() {
                let itinerary = Itinerary::at(side, &[n]).unwrap();
                let z = vec![exact.phase(speed), speed];
                let residual = linearise(&oscillator, &itinerary, &z).unwrap().residual;
                assert!(residual.iter().all(|x| x.abs() < 1e-13), "{text}\n{n} {speed}: {residual:?}");
                let orbit = find(&oscillator, &itinerary, z).unwrap();
                let multipliers = exact.multipliers(speed);
                assert!(near(orbit.multipliers.trace, multipliers.trace, 1e-11), "{text}\n{n} {speed}");
                assert!(near(orbit.multipliers.determinant, multipliers.determinant, 1e-12));
                assert!(near(exact.amplitude_at(speed), exact.amplitude(), 1e-13));
                orbits += 1;
            }
        }
        assert!(orbits > 3, "{text}: {orbits} orbits");
    }
}

/// Damping and stiffness written as a formula are the same oscillator.
#[test]
fn a_linear_formula_has_the_exact_orbits_of_its_coefficients() {
    let formula = PAPER.replace("damping = \"2*d/w\"", "force = \"-2*d/w*u - q/w^2\"");
    let formula = formula.replace("stiffness = \"1/w^2\"", "");
    assert!(formula.contains("q/w^2") && !formula.contains("stiffness"), "{formula}");
    let exact = |text: &str| SingleImpact::new(&scene(text).plain(&[]).unwrap(), Side::Lower, 4).unwrap();
    let (one, other) = (exact(PAPER), exact(&formula));
    assert_eq!(one.speeds(), other.speeds());
    assert!(one.fold().is_some() && one.fold() == other.fold() && one.flip() == other.flip());
}

/// At the resonances nθ = mπ of the paper's oscillator, section 4.1 and (77)–(81) among them: the orbit of
/// one impact hits where the stop is at height 0 and rises, both multipliers are τρ or −τρ with ρ =
/// exp(−2πdn/w), and for small µ it keeps clear of the stop at the first resonance alone, and for n = 1.
#[test]
fn at_resonances_the_orbit_is_known_for_every_amplitude() {
    let mut kept = Vec::new();
    for (n, d, tau) in
        [(1u32, 0.3, 0.8), (2, 0.6, 1.0), (3, 0.6, 1.0), (3, 0.2, 0.0), (4, 0.4, 0.5), (5, 0.1, 0.9)]
    {
        for m in 1..=2 * n {
            let w = 2.0 * f64::from(n) * f64::sqrt(1.0 - d * d) / f64::from(m);
            let rho = (-TAU * d * f64::from(n) / w).exp();
            let signed = if m % 2 == 1 { rho } else { -rho };
            for mu in [1e-2f64, 1e-4, 1e-6] {
                let text = PAPER
                    .replace("d = 0.6", &format!("d = {d}"))
                    .replace("w = 4.9", &format!("w = {w:?}"))
                    .replace("tau = 1", &format!("tau = {tau}"))
                    .replace("mu = 0", &format!("mu = {mu:e}"));
                let oscillator = Oscillator::new(scene(&text).plain(&[]).unwrap(), 1e-14).unwrap();
                // Q = 0 and Q′ > 0 at t₀ < 0.
                let rise = (2.0 * mu + mu * mu).sqrt();
                let phase = (-rise.atan()).rem_euclid(TAU);
                let speed = (1.0 + signed) * rise / (1.0 - tau * signed);
                let start = vec![phase * (1.0 + 1e-9), speed * (1.0 + 1e-6)];
                let orbit = find(&oscillator, &Itinerary::at(Side::Lower, &[n]).unwrap(), start).unwrap();
                let place = format!("n = {n}, m = {m}, d = {d}, tau = {tau}, mu = {mu}: {orbit:?}");
                assert!(near(orbit.z[0], phase, 1e-11) && (orbit.z[1] / speed - 1.0).abs() < 1e-8, "{place}");
                assert!(near(orbit.multipliers.trace, 2.0 * tau * signed, 1e-7), "{place}");
                assert!(near(orbit.multipliers.determinant, (tau * signed).powi(2), 1e-9), "{place}");
                if mu < 1e-3 {
                    assert_eq!(orbit.admissibility.is_admissible(), m == 1 || n == 1, "{place}");
                    kept.push(orbit.admissibility.is_admissible());
                }
            }
        }
    }
    assert!(kept.iter().filter(|kept| **kept).count() >= 12 && kept.len() > 60);
}

/// `StatementOneImpact.v`: where one impact in n periods repeats, at any amplitude and whether or not the
/// motion runs through the wall, c_n times its gap k periods after the impact is (1 + τ)|V| γ b_{n,k}.
#[test]
fn k_periods_after_an_impact_the_gap_is_a_multiple_of_b() {
    let mut met = [0; 2];
    for (d, w, tau, mu) in [
        (0.6f64, 4.9f64, 1.0, 0.7),
        (0.05, 6.3, 0.4, -0.01),
        (0.0, 4.1, 0.8, 0.3),
        (-0.01, 5.2, 0.9, 1e-3),
        (1.7, 3.0, 0.5, -0.2),
    ] {
        let system = scene(
            &PAPER
                .replace("d = 0.6", &format!("d = {d:?}"))
                .replace("w = 4.9", &format!("w = {w:?}"))
                .replace("tau = 1", &format!("tau = {tau:?}"))
                .replace("mu = 0", &format!("mu = {mu:e}")),
        )
        .plain(&[])
        .unwrap();
        let oscillator = Oscillator::new(system.clone(), 1e-14).unwrap();
        // The free motion from (0, 1) after one period: γ; and the eigenvalues' sum and product.
        let (shrunk, angle) = ((-TAU * d / w).exp(), TAU * (1.0 - d * d).abs().sqrt() / w);
        let (cosine, sine) = if d < 1.0 { (angle.cos(), angle.sin()) } else { (angle.cosh(), angle.sinh()) };
        let (a1, a2, gamma) = (2.0 * shrunk * cosine, shrunk * shrunk, shrunk * sine * TAU / angle);
        let mut u = vec![0.0, 1.0];
        for k in 1..9 {
            u.push(a1 * u[k] - a2 * u[k - 1]);
        }
        for n in 2..=7 {
            let exact = SingleImpact::new(&system, Side::Lower, n as u32).unwrap();
            let power = |k: usize| a2.powi(k as i32);
            let c = -(1.0 - (2.0 * u[n + 1] - a1 * u[n]) + power(n)) / u[n];
            for speed in exact.speeds() {
                let phase = exact.phase(speed);
                let [height, slope] = [(1.0 + mu) * phase.cos() - 1.0, -(1.0 + mu) * phase.sin()];
                for k in 1..n {
                    let b = (u[n] - u[k] - power(k) * u[n - k]) / u[n];
                    let start = State { t: phase, q: height, u: slope + tau * speed };
                    let gap = oscillator.flow().advance(start, TAU * k as f64).q - height;
                    let wanted = (1.0 + tau) * speed * gamma * b / c;
                    assert!(near(gap, wanted, 1e-9), "d = {d}, n = {n}, k = {k}: {gap} {wanted}");
                    met[usize::from(wanted > 0.0)] += 1;
                }
            }
        }
    }
    assert!(met.iter().all(|count| *count > 20), "{met:?}");
}

#[test]
fn what_exact_orbits_do_not_cover_is_refused() {
    let refused = |edit: &str, with: &str, what: &str| {
        let system = scene(&PAPER.replace(edit, with)).plain(&[]).unwrap();
        let error = SingleImpact::new(&system, Side::Lower, 1).unwrap_err();
        assert!(error.is_input() && error.to_string().contains(what), "{error}");
    };
    refused("[system]", "[system]\ncubic = 1", "linear");
    refused("[system]", "[system]\nforce = \"sin(q)\"", "formula");
    refused("[system]", "[system]\nforcing = [{ k = 2, cos = 1 }]", "one harmonic");
    refused("\"1 + mu\"", "0", "nothing moves");
    refused("\"lower\"", "\"upper\"", "not there");
    refused("stiffness = \"1/w^2\"", "", "repeats");
}

#[test]
fn located_folds_and_flips_agree_with_the_formulas() {
    for (d, w, tau) in [(0.6, 4.9, 1.0), (0.6, 4.85, 0.9), (0.5, 4.9, 0.8), (0.3, 3.3, 1.0), (0.6, 4.7, 1.0)]
    {
        let scene = paper(d, w, tau);
        let family = SceneFamily::new(&scene, "mu").unwrap();
        let mut found = 0;
        for n in 1..=5 {
            let exact = SingleImpact::new(&scene.plain(&[]).unwrap(), Side::Lower, n).unwrap();
            let events = [(Bifurcation::SaddleNode, exact.fold()), (Bifurcation::Flip, exact.flip())];
            for (kind, speed) in events {
                let Some(speed) = speed.filter(|speed| (1e-3..1.0).contains(speed)) else { continue };
                // A start some way along the branch.
                let away = speed * 1.1;
                let mu = exact.amplitude_at(away) - 1.0;
                let start = SingleImpact::new(&scene.plain(&[("mu", mu)]).unwrap(), Side::Lower, n).unwrap();
                let orbit =
                    find(&family.at(mu).unwrap(), &lower(&[n]), vec![start.phase(away), away]).unwrap();
                // Some of these folds lie where the orbits run through the wall: the formulas hold there too.
                let options = Options { beyond: true, ..Options::default() };
                let found_there = locate(&family, kind, &orbit, mu, 0.5, &options).unwrap();
                let BranchSearch::Found(event) = found_there else { panic!("{kind:?} {n}: {found_there:?}") };
                let expected = exact.amplitude_at(speed) - 1.0;
                assert!(
                    (event.parameter - expected).abs() < 1e-13,
                    "{kind:?} {n}: {} {expected}",
                    event.parameter
                );
                assert!((event.orbit.z[1] - speed).abs() < 1e-9, "{kind:?} {n}: {:?} {speed}", event.orbit.z);
                // There, too, Newton's method ends: at a fold its Jacobian is singular.
                let again = find(&family.at(expected).unwrap(), &lower(&[n]), event.orbit.z.clone()).unwrap();
                assert!((again.z[1] - speed).abs() < 1e-6, "{kind:?} {n}: {:?}", again.z);
                found += 1;
            }
        }
        assert!(found > 0, "d = {d}, w = {w}, tau = {tau}");
    }
}

#[test]
fn past_its_end_an_orbit_is_flagged_and_newton_goes_on() {
    let scene = scene(PAPER);
    // Two impacts of period 6: gone from mu = 0.0061 on (section 4.2).
    let mut z = vec![-0.0957, 0.0999, -0.008, 0.028];
    let mut gaps = Vec::new();
    for mu in [0.0058, 0.00605, 0.00615, 0.0063] {
        let orbit = find(&at(&scene, "mu", mu), &lower(&[3, 3]), z).unwrap();
        assert!(orbit.residual < 1e-14);
        let least = orbit.least.unwrap();
        match orbit.admissibility {
            Admissibility::Admissible => assert!(mu < 0.0061 && least.gap > 0.0),
            Admissibility::Excursion(place) => assert!(mu > 0.0061 && place == least && least.gap < 0.0),
            _ => panic!("{orbit:?}"),
        }
        gaps.push(least.gap);
        z = orbit.z;
    }
    assert!(gaps.windows(2).all(|pair| pair[1] < pair[0]));
    // Beyond the grazing of the motion at rest the branch goes on with V < 0.
    let orbit = find(&at(&scene, "mu", 0.001), &lower(&[4]), vec![0.002, -0.002]).unwrap();
    assert_eq!(orbit.admissibility, Admissibility::Outgoing(0));
    assert!(orbit.z[1] < 0.0);
}

#[test]
fn a_pattern_that_no_motion_can_have_is_an_error() {
    let oscillator = at(&scene(PAPER), "mu", 0.01);
    let error = |itinerary: &Itinerary, z: Vec<f64>| find(&oscillator, itinerary, z).unwrap_err().to_string();
    assert!(error(&strikes(&[(Side::Upper, 1)]), vec![0.0, 0.1]).contains("no such wall"));
    assert!(error(&lower(&[0, 1]), vec![1.0, 0.1, 0.5, 0.1]).contains("before"));
    assert!(error(&lower(&[1]), vec![1.0]).contains("unknowns"));
    assert!(Itinerary::at(Side::Lower, &[0]).is_err() && Itinerary::free(0).is_err());
    // Nothing moves: no phase is better than another.
    let still = scene(&PAPER.replace("\"1 + mu\"", "0"));
    assert!(find(&at(&still, "mu", 0.0), &lower(&[1]), vec![0.0, 0.1]).is_err());
}

#[test]
fn tasks_about_orbits_refuse_what_does_not_fit_the_scene() {
    let two = "[[walls]]\nside = \"upper\"\noffset = 3\nrestitution = 1\n";
    let refused = |extra: &str, task: &str, what: &str| {
        let text = format!("{PAPER}{extra}[[tasks]]\nname = \"t\"\n{task}");
        let error = Scene::from_toml(&text, "scene.toml").unwrap_err();
        assert!(error.is_input() && error.to_string().contains(what), "{what}: {error}");
    };
    let orbit = |keys: &str| format!("kind = \"orbit\"\norbit = {{ {keys} }}");
    refused("", &orbit("pattern = [0]"), "pattern");
    refused("", &orbit("pattern = [3], walls = [\"upper\"]"), "is no wall of the scene");
    refused("", &orbit("pattern = [3], walls = [\"lower\", \"lower\"]"), "1 walls");
    refused("", &orbit("pattern = [3], start = [1]"), "2 numbers");
    refused("", &orbit("patern = [3]"), "pattern");
    refused(two, &orbit("pattern = [3]"), "several walls");
    refused("", "kind = \"orbit\"\nparameter = \"mu\"\norbit = { pattern = [3] }", "both or neither");
    refused("", "kind = \"event\"\nevent = \"fold\"\nparameter = \"mu\"\norbit = {}", "flip");
    refused("", "kind = \"event\"\nevent = \"flip\"\nparameter = \"nu\"\norbit = {}", "\"mu\"");
    refused("", "kind = \"grazing\"\nparameter = \"mu\"\nmax_period = 0", "1 to 12");
}

/// The map from the phase of grazing to itself at an impact, by the true flow: h and g of (2), (3).
fn impact_map(oscillator: &Oscillator, x: [f64; 2]) -> Option<(f64, [f64; 2])> {
    let (wall, flow): (&Contact, _) = (&oscillator.walls()[0], oscillator.flow());
    let [place, speed, _] = wall.position.at(0.0);
    let start = State { t: 0.0, q: place + x[0], u: speed + x[1] };
    let gap = |t: f64| wall.gap(flow.advance(start, t));
    let bisect = |mut lo: f64, mut hi: f64, f: &dyn Fn(f64) -> f64| {
        for _ in 0..100 {
            let middle = (lo + hi) / 2.0;
            if f(middle) < 0.0 { lo = middle } else { hi = middle }
        }
        lo
    };
    let least = bisect(-0.5, 0.5, &|t| gap(t)[1]);
    let h = gap(least)[0];
    if h >= 0.0 {
        return None;
    }
    let impact = bisect(least - 0.5, least, &|t| -gap(t)[0]);
    let after = flow.advance(wall.bounce(flow.advance(start, impact)), -impact);
    Some((h, [after.q - place, after.u - speed]))
}

/// (75), (76), the second-order expansion at the paper's grazing, with remainders of the orders claimed;
/// (40), (41) are its lead.
#[test]
fn the_local_map_is_the_true_one_to_the_orders_claimed() {
    for (d, w, tau) in [(0.6, 4.9, 1.0), (0.3, 2.2, 0.6), (1.4, 3.0, 0.9)] {
        let scene = paper(d, w, tau);
        for (a, c) in [(0.7, 0.4), (-1.1, 0.9), (0.2, -1.3)] {
            let errors = |size: f64| {
                let (x, mu) = ([-size * size, a * size], c * size);
                let (h, after) = impact_map(&at(&scene, "mu", mu), x).unwrap();
                let y = (-h).sqrt();
                let b = [0, 1].map(|i| (after[i] - x[i]) / y);
                let predicted = [
                    (1.0 + tau) * (2.0 * y + SQRT_2 * x[1]),
                    (1.0 + tau)
                        * (SQRT_2 - 4.0 * d / w * y - 3.0 * SQRT_2 * d / w * x[1]
                            + SQRT_2 / 2.0 * (w * w - 1.0) / (w * w) * mu),
                ];
                // Grazing's h, and b as (41) alone has it.
                let leading = [b[0], b[1] - SQRT_2 * (1.0 + tau)].map(f64::abs);
                let second = (x[0] - x[1] * x[1] / 2.0 - h).abs();
                ([second, (b[0] - predicted[0]).abs(), (b[1] - predicted[1]).abs()], leading)
            };
            let ((far, far_lead), (close, close_lead)) = (errors(0.02), errors(0.01));
            for (i, order) in [3.0, 2.0, 2.0].into_iter().enumerate() {
                let seen = (far[i] / close[i]).log2();
                // A remainder may happen to be of higher order, never of lower.
                assert!(seen > order - 0.35, "d {d} a {a}: {i} of order {seen}");
            }
            for i in [0, 1] {
                let seen = (far_lead[i] / close_lead[i]).log2();
                assert!((seen - 1.0).abs() < 0.35, "the first order is really there: {seen}");
            }
        }
    }
}

/// Section 4.1: on the branch of period 3 both multipliers are tau r^3, and V goes with the root of mu
/// (77)-(81).
#[test]
fn the_resonant_branch_starts_as_a_square_root() {
    for tau in [1.0, 0.7] {
        let scene = paper(0.6, 4.8, tau);
        let cube = (-0.75 * PI).exp();
        let expected = SQRT_2 * (1.0 + cube) / (1.0 - tau * cube);
        let mut errors = Vec::new();
        for mu in [1e-2, 1e-4, 1e-6] {
            let mu: f64 = mu;
            let found = search(&at(&scene, "mu", mu), &lower(&[3]), 200, 4.0 * mu.sqrt());
            let [orbit] = &found[..] else { panic!("{} orbits at {mu}", found.len()) };
            assert!(orbit.admissibility.is_admissible() && orbit.multipliers.is_stable());
            assert!(near(orbit.multipliers.trace, 2.0 * tau * cube, 1e-10 / mu.sqrt()), "{orbit:?}");
            assert!(near(orbit.multipliers.determinant, (tau * cube).powi(2), 1e-12));
            errors.push((orbit.z[1] / mu.sqrt() - expected).abs());
        }
        assert!(
            errors[0] < 0.05 && errors[1] < 0.1 * errors[0] + 1e-9 && errors[2] < 0.1 * errors[1] + 1e-9,
            "{errors:?}"
        );
        assert!(search(&at(&scene, "mu", -1e-3), &lower(&[3]), 200, 0.3).is_empty());
    }
}
