//! The simulator on orbits that Newton's method found, and the orbits it settles on.

use std::f64::consts::TAU;

use grazing::{
    oscillator::{
        Side, Time,
        orbit::*,
        simulate::{Event, RunEnd, Settings, Simulator},
    },
    scene::{Scene, SceneFamily},
};

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

/// Runs for `rounds` periods of the orbit from half way along its first leg; the largest error of impact times and speeds.
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
    let error = |(i, seen): (usize, &grazing::oscillator::simulate::Impact)| {
        let impact = expected[(i + 1) % m];
        assert_eq!(seen.side, impact.side);
        let turn = (seen.time.phase - impact.phase).abs();
        turn.min(TAU - turn).max((seen.velocity + impact.speed).abs())
    };
    impacts.iter().enumerate().map(error).fold(0.0, f64::max)
}

#[test]
fn the_simulator_stays_on_orbits_as_long_as_their_multipliers_allow() {
    let paper = Scene::from_toml(include_str!("../examples/scenes/nordmark-2001.toml"), "test").unwrap();
    let rich = Scene::from_toml(RICH, "test").unwrap();
    let lower = |periods: &[u32]| Itinerary::at(Side::Lower, periods).unwrap();
    let strike = |side, periods| Strike { side, periods };
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
    for (scene, parameter, value, itinerary) in cases {
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
    assert!(stable > 1 && unstable > 6, "{stable} {unstable}");
}

#[test]
fn the_simulator_settles_on_the_stable_orbits() {
    let scene = Scene::from_toml(include_str!("../examples/scenes/nordmark-2001.toml"), "test").unwrap();
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
