//! The simulator on orbits that Newton's method found, and the orbits it settles on.

use std::f64::consts::TAU;

use grazing_scenes::{
    motion::{RunEnd, Side, Time, event::Impact},
    one::{
        orbit::*,
        simulate::{Event, Settings, Simulator},
    },
    run::{Findings, Surroundings, run},
    scene::{Scene, SceneFamily},
};

use crate::samples::one_in;

const RICH: &str = r#"
    format = "grazing-scene 1"
    title = "two walls, one moving, and a cubic spring"
    [parameters]
    cubic = 0.4
    [system]
    damping = 0.1
    stiffness = 0.6
    cubic = "cubic"
    forcing = [{ cos = 0.9, sin = 0.2 }]
    [[walls]]
    side = "lower"
    offset = -0.5
    harmonics = [{ k = 1, cos = 0.1 }]
    restitution = 0.8
    [[walls]]
    side = "upper"
    offset = 0.6
    restitution = 0.7
"#;

/// Runs for `rounds` periods of the orbit from half way along its first leg; the largest error of impact
/// times and speeds.
fn error(oscillator: &Oscillator, orbit: &Orbit, rounds: u32) -> f64 {
    let simulator = Simulator::new(oscillator.system(), &Settings::default()).unwrap();
    let t = orbit.z[0] + Unknowns::new(&orbit.itinerary, &orbit.z).unwrap().duration(0) / 2.0;
    let state = orbit.state(oscillator, t).unwrap();
    let start = Time::new(0, t);
    let mut run = simulator.start(start, state.q, state.u).unwrap();
    let mut impacts = Vec::new();
    let end = Time::new(i64::from(orbit.itinerary.periods() * rounds), t);
    let ended = run.record(end, |event| match event {
        Event::Impact(impact) => impacts.push(impact),
        other => panic!("{other:?} on {orbit:?}"),
    });
    assert_eq!(ended, RunEnd::Reached);
    let m = orbit.z.len() / 2;
    assert_eq!(impacts.len(), m * rounds as usize, "{orbit:?}");
    // The impacts follow in the orbit's order, the first being its second.
    let expected: Vec<OrbitImpact> = orbit.impacts().collect();
    let error = |(i, seen): (usize, &Impact<Side>)| {
        let impact = expected[(i + 1) % m];
        assert_eq!(seen.place, impact.side);
        let turn = (seen.time.phase - impact.phase).abs();
        turn.min(TAU - turn).max((seen.velocity + impact.speed).abs())
    };
    impacts.iter().enumerate().map(error).fold(0.0, f64::max)
}

#[test]
fn the_simulator_stays_on_orbits_as_long_as_their_multipliers_allow() {
    let paper = Scene::from_toml(include_str!("../../examples/scenes/nordmark-2001.toml"), "test").unwrap();
    let rich = Scene::from_toml(RICH, "test").unwrap();
    let lower = |periods: &[u32]| Itinerary::at(Side::Lower, periods).unwrap();
    let strike = |side, periods| Strike { place: side, periods };
    let both = Itinerary::new(vec![strike(Side::Lower, 0), strike(Side::Upper, 1)]).unwrap();
    let cases = [
        (&paper, "mu", -0.05, lower(&[4])),
        (&paper, "mu", 0.003, lower(&[1])),
        (&paper, "mu", 0.003, lower(&[2])),
        (&paper, "mu", 0.003, lower(&[1, 2])),
        (&paper, "mu", 0.003, lower(&[3])),
        (&paper, "mu", 0.007, lower(&[3])),
        (&paper, "mu", 0.0058, lower(&[3, 3])),
        (&rich, "cubic", 0.4, both.clone()),
        (&rich, "cubic", 0.0, both),
    ];
    let (mut stable, mut unstable) = (0, 0);
    for (scene, parameter, value, itinerary) in cases.into_iter().step_by(one_in(2)) {
        let oscillator = SceneFamily::new(scene, parameter).unwrap().at(value).unwrap();
        let orbits = search(&oscillator, &itinerary, 400, 1.5);
        let orbits: Vec<&Orbit> = orbits.iter().filter(|orbit| orbit.admissibility.is_admissible()).collect();
        assert!(!orbits.is_empty(), "{itinerary}");
        for orbit in orbits {
            if orbit.multipliers.is_stable() {
                stable += 1;
                assert!(error(&oscillator, orbit, 300) < 1e-9, "{orbit:?}");
            } else {
                unstable += 1;
                let (re, im) = orbit.multipliers.values()[0];
                // Once round, what Newton's method and rounding leave grows by the multiplier.
                assert!(error(&oscillator, orbit, 1) < 1e-12 * re.hypot(im), "{orbit:?}");
            }
        }
    }
    let least = if one_in(2) == 1 { (2, 7) } else { (1, 5) };
    assert!(stable >= least.0 && unstable >= least.1, "{stable} {unstable}");
}

#[test]
fn the_simulator_settles_on_the_stable_orbits() {
    let scene = Scene::from_toml(include_str!("../../examples/scenes/nordmark-2001.toml"), "test").unwrap();
    for (mu, n) in [(-0.05, 4), (0.0065, 3)] {
        let oscillator = SceneFamily::new(&scene, "mu").unwrap().at(mu).unwrap();
        let orbits = search(&oscillator, &Itinerary::at(Side::Lower, &[n]).unwrap(), 200, 1.0);
        let orbit = orbits.iter().find(|orbit| orbit.multipliers.is_stable()).unwrap();
        let simulator = Simulator::new(oscillator.system(), &Settings::default()).unwrap();
        // Not quite on it.
        let t = orbit.z[0] + 1.0;
        let state = orbit.state(&oscillator, t).unwrap();
        let mut run = simulator.start(Time::new(0, t), state.q + 1e-3, state.u - 1e-3).unwrap();
        assert_eq!(run.finish(Time::new(4000 * i64::from(n), 0.0)), RunEnd::Reached);
        let Event::Impact(impact) = run.next(Time::new(4001 * i64::from(n), 0.0)) else {
            panic!("no impact")
        };
        assert!(
            (impact.time.phase - orbit.impacts().next().unwrap().phase).abs() < 1e-11,
            "{impact:?} {orbit:?}"
        );
    }
}

/// The paper's oscillator at µ = −0.05: a node, a saddle, both with pattern (4), and their section with the
/// saddle's manifolds.
const SADDLE: &str = r#"
    format = "grazing-scene 1"
    title = "a saddle"
    [system]
    damping = "12/49"
    stiffness = "100/2401"
    [[walls]]
    side = "lower"
    offset = -1
    harmonics = [{ cos = "95/100" }]
    restitution = 1
    [[tasks]]
    name = "manifolds"
    kind = "section"
    starts = [{ q = 0 }]
    phase = "1/2"
    points = 100
    orbits = [{ pattern = [4] }]
    manifolds = true
"#;

/// How far a point is from a curve in pieces.
fn distance(at: [f64; 2], pieces: &[&Vec<[f64; 2]>]) -> f64 {
    let segments = pieces.iter().flat_map(|piece| piece.windows(2));
    let to = |segment: &[[f64; 2]]| {
        let [a, b] = [segment[0], segment[1]];
        let (along, from) = ([b[0] - a[0], b[1] - a[1]], [at[0] - a[0], at[1] - a[1]]);
        let length = along[0] * along[0] + along[1] * along[1];
        let part = ((from[0] * along[0] + from[1] * along[1]) / length.max(1e-300)).clamp(0.0, 1.0);
        (from[0] - part * along[0]).hypot(from[1] - part * along[1])
    };
    segments.map(to).fold(f64::INFINITY, f64::min)
}

#[test]
fn manifolds_are_invariant_and_leave_the_saddle_along_its_eigenvectors() {
    let scene = Scene::from_toml(SADDLE, "test").unwrap();
    let reports = run(&scene, Surroundings::default(), &mut ()).unwrap();
    let Some(Findings::Section(found)) = &reports[0].findings else { panic!("{:?}", reports[0].status) };
    let half = |wanted: bool| -> Vec<&Vec<[f64; 2]>> {
        found.manifolds.iter().filter(|(stable, _)| *stable == wanted).map(|(_, piece)| piece).collect()
    };
    let (unstable, stable) = (half(false), half(true));
    // Four points of the saddle, from each two halves of either manifold.
    assert!(unstable.len() >= 8 && stable.len() >= 8, "{} {}", unstable.len(), stable.len());
    let simulator = Simulator::new(&scene.exact(&[]).unwrap().rounded(), &Settings::default()).unwrap();
    let four = |[q, u]: [f64; 2]| {
        let mut run = simulator.start(Time::new(0, TAU / 2.0), q, u).ok()?;
        (run.finish(Time::new(4, TAU / 2.0)) == RunEnd::Reached).then(|| [run.state().q, run.state().u])
    };
    let away = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
    let size = |v: [f64; 2]| v[0].hypot(v[1]);
    let (mut followed, mut halves) = (0, 0);
    for (pieces, is_stable) in [(&unstable, false), (&stable, true)] {
        for piece in pieces {
            // Only the first piece of a half begins at the saddle itself.
            let saddle = piece[0];
            let Some(image) = four(saddle) else { continue };
            if size(away(image, saddle)) > 1e-9 {
                continue;
            }
            halves += 1;
            // The matrix of four periods by differences, and the multiplier and direction of this half by its
            // trace and determinant.
            let column = |by: [f64; 2]| {
                let at = |sign: f64| four([saddle[0] + sign * by[0], saddle[1] + sign * by[1]]).unwrap();
                away(at(1.0), at(-1.0)).map(|x| x / 2e-7)
            };
            let [a, b] = [column([1e-7, 0.0]), column([0.0, 1e-7])];
            let (trace, det) = (a[0] + b[1], a[0] * b[1] - b[0] * a[1]);
            let larger = trace / 2.0 + (trace * trace / 4.0 - det).sqrt().copysign(trace);
            let multiplier = if is_stable { det / larger } else { larger };
            let start = away(piece[1], saddle);
            let moved = [
                a[0] * start[0] + b[0] * start[1] - multiplier * start[0],
                a[1] * start[0] + b[1] * start[1] - multiplier * start[1],
            ];
            assert!(size(moved) < 1e-3 * larger.abs() * size(start), "{is_stable}: {moved:?} {start:?}");
        }
        // Points of the unstable manifold map onto it; of the stable one back to it, nearer to the saddle.
        for point in pieces.iter().flat_map(|piece| &piece[..piece.len() / 2]).step_by(25) {
            let Some(image) = four(*point) else { continue };
            followed += 1;
            let off = distance(image, pieces);
            assert!(off < 4e-3, "{is_stable}: {point:?} leads to {image:?}, {off} off");
        }
    }
    assert!(halves >= 16 && followed > 60, "{halves} {followed}");
}
