//! The simulator against impacts computed by another method (tests/data/make_events.py): random scenes, and
//! scenes in which a minimum of the gap lies 10⁻³ to 10⁻¹⁰ on either side of the wall.

use std::f64::consts::TAU;

use grazing_scenes::{
    motion::{Counts, Effect, Harmonic, RunEnd, Side, State, System, Time, Wall},
    one::simulate::{Event, Settings, Simulator},
};

const DATA: &str = include_str!("../data/events.csv");

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
    /// A change that is small beside the least depth of a minimum.
    nudge: f64,
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
                ..System::default()
            },
            start: [8, 9, 10].map(|i| number(cells[i])),
            until: number(cells[11]),
            nudge: if cells[0] == "grazing" { number(cells[12]) / 100.0 } else { 1e-9 },
            impacts: cells[13].split_whitespace().map(impact).collect(),
        }
    })
    .collect()
}

/// (wall, time, velocity) of an impact.
type Seen = (Side, f64, f64);

/// The impacts of a motion up to the reference's end.
fn impacts(simulator: &Simulator, start: [f64; 3], until: f64, counts: &mut Counts) -> Vec<Seen> {
    let [t, q, u] = start;
    let mut found = Vec::new();
    let mut run = simulator.start_counting(Time::new(0, t), q, u, counts).unwrap();
    let end = run.record(Time::new(0, until), |event| {
        if let Event::Impact(impact) = event {
            let time = TAU * impact.time.period as f64 + impact.time.phase;
            found.push((impact.place, time, impact.velocity));
        }
    });
    assert_eq!(end, RunEnd::Reached);
    found
}

fn simulator(reference: &Reference, tolerance: f64) -> Simulator {
    Simulator::new(&reference.system, &Settings { tolerance, ..Settings::default() }).unwrap()
}

/// The rows whose impacts, with the integrator at a tolerance, are not the reference's to within `allowed`,
/// one number per impact.
fn wrong(tolerance: f64, allowed: impl Fn(&Reference) -> Vec<f64>) -> Vec<String> {
    let mut wrong = Vec::new();
    let mut seen = 0;
    for (i, reference) in references().iter().enumerate() {
        let mut counts = Counts::default();
        let simulator = simulator(reference, tolerance);
        let found = impacts(&simulator, reference.start, reference.until, &mut counts);
        seen += found.len();
        let allowed = allowed(reference);
        let met = |((have, want), allowed): ((&Seen, &Expected), &f64)| {
            have.0 == want.side
                && (have.1 - want.time).abs() <= *allowed
                && (have.2 - want.velocity).abs() <= *allowed
        };
        let pairs = || found.iter().zip(&reference.impacts).zip(&allowed);
        if found.len() != reference.impacts.len() || !pairs().all(met) {
            let off = pairs().map(|((have, want), allowed)| (have.1 - want.time, allowed));
            wrong.push(format!("row {i}, {}: {:?}", reference.kind, off.collect::<Vec<_>>()));
        }
    }
    assert!(seen > 1000, "{seen}");
    wrong
}

#[test]
fn every_reference_is_met() {
    let all = references();
    let count = |kind| all.iter().filter(|reference| reference.kind == kind).count();
    assert!(count("random") >= 241 && count("grazing") >= 109, "{} {}", count("random"), count("grazing"));
    // A reference's tolerance is what a change of 1e-13 at the start amounts to by then. A linear motion has
    // no other error than rounding; one with a cubic spring is integrated, here to rounding too.
    let wrong = wrong(1e-15, |reference| reference.impacts.iter().map(|want| want.tolerance).collect());
    assert!(wrong.is_empty(), "{} of {}:\n{}", wrong.len(), all.len(), wrong.join("\n"));
}

/// What the integrator's errors may amount to by each impact: the number of its steps, times the error
/// allowed to a step, times the most that a change of q or of u at any time before grows to by that impact.
/// The growth is measured, by motions that start beside this one every half unit of time.
fn accumulated(reference: &Reference, tolerance: f64) -> Vec<f64> {
    let mut counts = Counts::default();
    impacts(&simulator(reference, tolerance), reference.start, reference.until, &mut counts);
    let steps = counts.of(Effect::Cubic) as f64;
    let exact = simulator(reference, 1e-15);
    let [t, q, u] = reference.start;
    let mut run = exact.start(Time::new(0, t), q, u).unwrap();
    let whole = impacts(&exact, reference.start, reference.until, &mut Counts::default());
    let mut growth = vec![1.0_f64; whole.len()];
    let mut size = 0.0_f64;
    let mut at = t;
    while at < reference.until {
        assert_eq!(run.finish(Time::new(0, at)), RunEnd::Reached);
        let State { q, u, .. } = run.state();
        size = size.max(1.0 + q.abs() + u.abs());
        let passed = whole.iter().take_while(|impact| impact.1 <= at).count();
        for (dq, du) in [(1.0, 0.0), (0.0, 1.0)] {
            // Up, or down where that is behind a wall.
            let beside = |nudge: f64| [at, q + nudge * dq, u + nudge * du];
            let starts = |[_, q, u]: &[f64; 3]| exact.start(Time::new(0, at), *q, *u).is_ok();
            let nudge = reference.nudge;
            let start = [beside(nudge), beside(-nudge)].into_iter().find(starts).unwrap();
            let beside = impacts(&exact, start, reference.until, &mut Counts::default());
            // Just before or after an impact the motion beside may have one more or less: the last ones
            // belong together.
            for (i, impact) in whole.iter().enumerate().skip(passed).rev() {
                let Some(j) = (beside.len() + i).checked_sub(whole.len()) else { break };
                if beside[j].0 == impact.0 {
                    let moved = (beside[j].1 - impact.1).abs().max((beside[j].2 - impact.2).abs());
                    growth[i] = growth[i].max(moved / nudge);
                }
            }
        }
        at += 0.5;
    }
    growth.iter().map(|growth| steps * tolerance * size * growth).collect()
}

/// At the default tolerance, too, motions with a cubic spring are as good as their integrator promises, and
/// that says something.
#[test]
fn an_integrated_motion_is_as_good_as_its_tolerance() {
    let tolerance = Settings::default().tolerance;
    let bounds = std::cell::RefCell::new(Vec::new());
    let wrong = wrong(tolerance, |reference| {
        if reference.system.cubic == 0.0 {
            return reference.impacts.iter().map(|want| want.tolerance).collect();
        }
        let bound = accumulated(reference, tolerance);
        bounds.borrow_mut().extend(bound.iter().copied());
        bound
    });
    assert!(wrong.is_empty(), "{}:\n{}", wrong.len(), wrong.join("\n"));
    let mut bounds = bounds.into_inner();
    bounds.sort_by(f64::total_cmp);
    // Half of the impacts are told to 10⁻⁹; the few bounds above 10⁻⁵ are those of motions that nearly graze
    // again and again.
    let share = |bound: f64| bounds.iter().filter(|b| **b < bound).count() as f64 / bounds.len() as f64;
    let shares = [1e-9, 1e-7, 1e-5].map(share);
    assert!(bounds.len() > 200 && shares[0] > 0.5 && shares[1] > 0.9 && shares[2] > 0.97, "{shares:?}");
}
