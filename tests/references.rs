//! The simulator against impacts computed by another method (tests/data/make_events.py): random scenes, and scenes in which a minimum of
//! the gap lies 10⁻³ to 10⁻¹⁰ on either side of the wall.

use std::f64::consts::TAU;

use grazing::oscillator::{
    Harmonic, Side, System, Time, Wall,
    simulate::{Event, RunEnd, Settings, Simulator},
};

const DATA: &str = include_str!("data/events.csv");

fn number(text: &str) -> f64 {
    text.parse().unwrap_or_else(|_| panic!("{text:?}"))
}

fn harmonics(text: &str) -> Vec<Harmonic<f64>> {
    let one = |text: &str| {
        let parts: Vec<&str> = text.split(':').collect();
        Harmonic { k: parts[0].parse().unwrap(), cos: number(parts[1]), sin: number(parts[2]) }
    };
    text.split_whitespace().map(one).collect()
}

fn wall(text: &str) -> Option<Wall<f64>> {
    let parts: Vec<&str> = text.split('/').collect();
    (parts.len() == 3).then(|| Wall {
        offset: number(parts[0]),
        restitution: number(parts[1]),
        harmonics: harmonics(parts[2]),
    })
}

struct Expected {
    side: Side,
    time: f64,
    velocity: f64,
    tolerance: f64,
}

struct Reference {
    kind: &'static str,
    system: System<f64>,
    start: [f64; 3],
    until: f64,
    impacts: Vec<Expected>,
}

fn references() -> Vec<Reference> {
    let rows = DATA.lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.map(|line| {
        let cells: Vec<&'static str> = line.split(',').collect();
        assert_eq!(cells.len(), 14, "{line}");
        let impact = |text: &str| {
            let parts: Vec<&str> = text.split(':').collect();
            let side = if parts[0] == "l" { Side::Lower } else { Side::Upper };
            let [time, velocity, tolerance] = [1, 2, 3].map(|i| number(parts[i]));
            Expected { side, time, velocity, tolerance }
        };
        Reference {
            kind: cells[0],
            system: System {
                damping: number(cells[1]),
                stiffness: number(cells[2]),
                cubic: number(cells[3]),
                force: number(cells[4]),
                forcing: harmonics(cells[5]),
                lower: wall(cells[6]),
                upper: wall(cells[7]),
            },
            start: [8, 9, 10].map(|i| number(cells[i])),
            until: number(cells[11]),
            impacts: cells[13].split_whitespace().map(impact).collect(),
        }
    })
    .collect()
}

/// (wall, time, velocity) of each impact up to the reference's end.
fn simulated(reference: &Reference) -> Vec<(Side, f64, f64)> {
    let simulator = Simulator::new(&reference.system, &Settings::default()).unwrap();
    let [t, q, u] = reference.start;
    let mut found = Vec::new();
    let end =
        simulator.start(Time::new(0, t), q, u).unwrap().record(Time::new(0, reference.until), |event| {
            if let Event::Impact(impact) = event {
                let time = TAU * impact.time.period as f64 + impact.time.phase;
                found.push((impact.side, time, impact.velocity));
            }
        });
    assert_eq!(end, RunEnd::Reached);
    found
}

#[test]
fn every_reference_is_met() {
    let all = references();
    let count = |kind| all.iter().filter(|reference| reference.kind == kind).count();
    assert!(count("random") >= 241 && count("grazing") >= 109, "{} {}", count("random"), count("grazing"));
    let mut wrong = Vec::new();
    let mut impacts = 0;
    for (i, reference) in all.iter().enumerate() {
        let found = simulated(reference);
        impacts += found.len();
        // A reference's tolerance is what a change of 1e-13 at the start amounts to. A linear motion keeps to it. One with a cubic spring
        // is integrated, each of its up to 100 steps with an error of up to the integrator's tolerance of 1e-13.
        let steps = if reference.system.cubic == 0.0 { 1.0 } else { 100.0 };
        let met = |(have, want): (&(Side, f64, f64), &Expected)| {
            let tolerance = steps * want.tolerance;
            have.0 == want.side
                && (have.1 - want.time).abs() <= tolerance
                && (have.2 - want.velocity).abs() <= tolerance
        };
        if found.len() != reference.impacts.len() || !found.iter().zip(&reference.impacts).all(met) {
            let wanted: Vec<_> = reference.impacts.iter().map(|want| (want.side, want.time)).collect();
            wrong.push(format!("row {i}, {}: {found:?} for {wanted:?}", reference.kind));
        }
    }
    assert!(wrong.is_empty(), "{} of {}:\n{}", wrong.len(), all.len(), wrong.join("\n"));
    assert!(impacts > 1000, "{impacts}");
}
