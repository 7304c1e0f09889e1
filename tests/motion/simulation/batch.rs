//! A batch tells every event of every motion as the scalar engine does, bit for bit.

use crate::samples::samples;
use std::sync::Arc;

use grazing_scenes::{
    attractor::{
        basins::{BasinCell, BasinGrid, Basins, basins},
        cycle::Cycle,
        detection::{Detection, Fate},
        diagram::{DiagramPlan, Look, sweep},
        observe::{Attraction, Observation},
    },
    motion::{Effect, EffectTally, Harmonic, RunEnd, State, System, Time, Wall},
    one::{
        attractor::{
            lyapunov,
            map::{MapCell, MapEnd, MapPlan, map},
        },
        simulate::{Event, Settings, Simulator, batch::Batch},
    },
};
use rayon::prelude::*;

/// The same choices on every machine: SplitMix64.
struct Choices(u64);

impl Choices {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in [low, high).
    fn number(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn one_in(&mut self, n: u64) -> bool {
        self.next().is_multiple_of(n)
    }
}

fn wall(offset: f64, moving: f64, restitution: f64) -> Option<Wall<f64>> {
    let harmonics = if moving == 0.0 { vec![] } else { vec![Harmonic { k: 1, cos: moving, sin: 0.0 }] };
    Some(Wall { offset, harmonics, restitution })
}

fn system(damping: f64, stiffness: f64, force: f64, cos: f64) -> System<f64> {
    let forcing = if cos == 0.0 { vec![] } else { vec![Harmonic { k: 1, cos, sin: 0.0 }] };
    System { damping, stiffness, force, forcing, ..System::default() }
}

/// The paper's oscillator.
fn paper(mu: f64, tau: f64) -> System<f64> {
    System { lower: wall(-1.0, 1.0 + mu, tau), ..system(1.2 / 4.9, 1.0 / (4.9 * 4.9), 0.0, 0.0) }
}

/// Oscillators of every kind that a batch may meet: moving and resting walls below, above and on both sides,
/// forced, falling on a table, sticking, beyond every bound, in and near resonance.
fn systems(choices: &mut Choices) -> System<f64> {
    let tau = if choices.one_in(3) { choices.number(0.0, 1.0) } else { 1.0 };
    let mu = choices.number(-0.06, 0.06);
    match choices.next() % 9 {
        0 | 1 => paper(mu, tau),
        2 => System { upper: wall(1.0, -1.0 - mu, tau), ..paper(mu, tau) }.without_lower(),
        3 => System { upper: wall(choices.number(0.2, 1.5), 0.0, 0.9), ..paper(mu, tau) }
            .with_offset(choices.number(-3.5, -2.5)),
        4 => System { upper: wall(0.8, 0.0, tau), lower: wall(-0.9, 0.0, 0.7), ..system(0.1, 0.3, 0.0, 0.9) },
        5 => System { lower: wall(0.0, 0.0, tau), ..system(0.0, 0.0, -1.0, 0.0) },
        6 => System { lower: wall(0.0, 0.3, tau.min(0.6)), ..system(0.0, 0.0, -0.2, 0.0) },
        7 => System { lower: wall(-1.0, 0.0, tau), ..system(-0.3, 1.1, 0.0, 0.2) },
        _ => System { upper: wall(0.5, 0.0, 0.8), ..system(0.05, 9.0, 0.0, 1.5) },
    }
}

trait Changed {
    fn without_lower(self) -> Self;
    fn with_offset(self, offset: f64) -> Self;
}

impl Changed for System<f64> {
    fn without_lower(self) -> Self {
        System { lower: None, ..self }
    }

    fn with_offset(mut self, offset: f64) -> Self {
        self.lower.as_mut().unwrap().offset = offset;
        self
    }
}

/// Follows the motions both ways and compares everything; how many events there were.
fn compare(simulators: &[Simulator], starts: &[(usize, Time, f64, f64)], phase: f64, periods: u32) -> u64 {
    let begin = |&(which, time, q, u): &(usize, Time, f64, f64)| simulators[which].start(time, q, u).ok();
    let run = |start| begin(start).map(|run| (&simulators[start.0], run));
    let (motions, kept): (Vec<_>, Vec<_>) =
        starts.iter().filter_map(|start| Some((run(start)?, start))).unzip();
    let mut batch = Batch::new(phase, motions);
    let mut scalar: Vec<_> = kept.iter().map(|start| begin(start).unwrap()).collect();
    let mut goals: Vec<Time> = kept
        .iter()
        .map(|start| Time::new(start.1.period + i64::from(start.1.phase >= phase), phase))
        .collect();
    let mut count = 0;
    for _ in 0..periods {
        let mut told: Vec<Vec<Event>> = vec![Vec::new(); kept.len()];
        batch.record(|motion, event| told[motion].push(event));
        for (i, run) in scalar.iter_mut().enumerate() {
            let mut events = Vec::new();
            let end = run.record(goals[i], |event| events.push(event));
            assert_eq!(told[i], events, "motion {i} from {:?}", kept[i]);
            assert_eq!(batch.end(i), end, "motion {i} from {:?}", kept[i]);
            assert_eq!(batch.impacts(i), run.impacts());
            let state = run.state();
            let ([q, u], same) = (batch.point(i), |a: f64, b: f64| a == b || a.is_nan() && b.is_nan());
            assert!(same(q, state.q) && same(u, state.u), "motion {i}: {q} {u}, {state:?}");
            goals[i].period += 1;
            count += events.len() as u64;
        }
    }
    count
}

/// Starts over the plane, a quarter of them on motions that only just graze the wall if nothing else happens.
fn starts(choices: &mut Choices, simulators: &[Simulator], count: usize) -> Vec<(usize, Time, f64, f64)> {
    let mut all = Vec::new();
    for _ in 0..count {
        let which = choices.next() as usize % simulators.len();
        let t = choices.number(0.0, 6.2);
        let contact = simulators[which].contacts().next();
        if let (Some(contact), true) = (contact, choices.one_in(4)) {
            let [place, speed, _] = contact.position.at(t);
            let off = contact.side.sign() * 10f64.powf(choices.number(-14.0, -3.0));
            let (q, u) = if choices.one_in(2) { (place + off, speed) } else { (place, speed + off) };
            all.push((which, Time::new(0, t), q, u));
        } else {
            all.push((which, Time::new(0, t), choices.number(-1.0, 3.0), choices.number(-2.0, 2.0)));
        }
    }
    all
}

fn some(seed: u64, systems_count: usize, motions: usize, periods: u32) -> u64 {
    let mut choices = Choices(seed);
    let depth = if seed.is_multiple_of(3) { 1e-6 } else { 1e-12 };
    // A ball that bounces without loss may do so very often.
    let settings = Settings { minimum_depth: depth, impact_limit: 2000, ..Settings::default() };
    let simulators: Vec<Simulator> =
        (0..systems_count).filter_map(|_| Simulator::new(&systems(&mut choices), &settings).ok()).collect();
    let starts = starts(&mut choices, &simulators, motions);
    let phase = if choices.one_in(2) { 0.0 } else { choices.number(0.0, 6.25) };
    compare(&simulators, &starts, phase, periods)
}

#[test]
fn every_event_is_the_scalar_engines() {
    let mut events = 0;
    for seed in 0..12 {
        // One system, several, one for each motion; all counts around a vector's width.
        let (systems, motions) = [(1, 16), (3, 37), (17, 17), (1, 1), (2, 8), (9, 9)][seed as usize % 6];
        events += some(seed, systems, motions, 6);
    }
    assert!(events > 300, "{events} events were compared");
}

/// On all cores. tests/README.md has the figure for millions of them: `GRAZING_SAMPLES=200 cargo test
/// --release --test motion simulation:: -- --ignored every_event_of --nocapture`.
#[test]
#[ignore = "minutes; scaled by GRAZING_SAMPLES"]
fn every_event_of_very_many_motions_is_the_scalar_engines() {
    let motions: u64 = samples(10_000);
    let rounds = motions.div_ceil(500);
    let round = |seed: u64| some(seed, [1, 5, 200][seed as usize % 3], 500, 12);
    let events: u64 = (1000..1000 + rounds).into_par_iter().map(round).sum();
    println!("{} motions, {events} events, all equal", 500 * rounds);
    assert!(events > 500 * rounds / 4);
}

/// What decays to nothing becomes nothing, the same bits in both engines: numbers too small to count would
/// slow them down.
#[test]
fn motions_that_decay_come_to_rest_at_zero() {
    let systems = [
        System { lower: wall(-1.0, 0.0, 0.9), ..system(2.0, 1.5, 0.0, 0.0) },
        System { lower: wall(-1.0, 0.0, 0.9), ..system(2.0, 1.5, 0.0, 0.1) },
        System { lower: wall(-2.0, 0.3, 0.9), upper: wall(2.0, 0.0, 0.9), ..system(1.0, 0.25, 0.0, 0.0) },
    ];
    for (i, system) in systems.iter().enumerate() {
        let simulator = Simulator::new(system, &Settings::default()).unwrap();
        let start = |j: u32| simulator.start(Time::new(0, 0.3), 0.1 * f64::from(j), 0.5).unwrap();
        let mut batch = Batch::new(0.0, (0..9).map(|j| (&simulator, start(j))).collect());
        let mut runs: Vec<_> = (0..9).map(start).collect();
        let mut sizes = Vec::new();
        for period in 1..=600 {
            batch.pass();
            for (j, run) in runs.iter_mut().enumerate() {
                run.finish(Time::new(period, 0.0));
                let (state, point) = (run.state(), batch.point(j));
                assert_eq!([state.q, state.u], point, "system {i}, motion {j}, period {period}");
            }
            let [q, u] = batch.point(0);
            sizes.push(q.abs() + u.abs());
        }
        // The second is forced, and comes to rest nowhere.
        if i != 1 {
            // Not before it is far below everything that counts.
            let last = sizes.iter().rposition(|&size| size > 0.0).unwrap();
            assert!(sizes[599] == 0.0 && (1e-160..1e-140).contains(&sizes[last]), "{i}: {:e}", sizes[last]);
        }
        // Then all are on one motion, to the last bit.
        assert!((1..9).all(|j| batch.point(j) == batch.point(0)), "{i}");
    }
}

#[test]
fn a_batch_may_be_empty_and_motions_end_one_by_one() {
    let mut empty = Batch::new(0.0, Vec::new());
    empty.pass();
    // Beyond every bound, at rest, at the limit of impacts, and one that never meets the wall.
    let limit = Settings { impact_limit: 3, ..Settings::default() };
    let escaping = System { lower: wall(-1.0, 0.0, 1.0), ..system(-3.0, 0.1, 0.0, 0.0) };
    let simulators = [
        Simulator::new(&escaping, &Settings::default()).unwrap(),
        Simulator::new(&System { lower: wall(0.0, 0.0, 0.5), ..system(0.0, 0.0, -1.0, 0.0) }, &limit)
            .unwrap(),
        Simulator::new(&System { lower: wall(-50.0, 0.0, 0.5), ..system(0.1, 1.3, 0.0, 0.3) }, &limit)
            .unwrap(),
        Simulator::new(&System { lower: wall(0.0, 0.0, 0.0), ..system(0.0, 0.0, -1.0, 0.0) }, &limit)
            .unwrap(),
    ];
    let start = |which, q, u| (which, Time::new(0, 0.5), q, u);
    let all =
        [start(0, 0.3, 5.0), start(1, 0.5, 0.0), start(2, 0.4, 0.1), start(3, 0.0, 0.0), start(3, 0.7, 1e99)];
    assert!(compare(&simulators, &all, 0.0, 80) > 0);
    let mut batch =
        Batch::new(0.0, vec![(&simulators[0], simulators[0].start(Time::new(0, 0.5), 0.3, 5.0).unwrap())]);
    (0..80).for_each(|_| batch.pass());
    assert_eq!(batch.end(0), RunEnd::Escaped);
    batch.drop(0);
    batch.pass();
}

#[test]
fn numbers_beyond_all_measure_are_left_to_the_scalar_engine() {
    let huge = System { lower: wall(-1e60, 1e59, 1.0), ..system(0.1, 0.2, 0.0, 1e150) };
    let simulators = [
        Simulator::new(&huge, &Settings::default()).unwrap(),
        Simulator::new(&paper(0.003, 1.0), &Settings { integrate: true, ..Settings::default() }).unwrap(),
    ];
    let all = [(0, Time::new(0, 0.5), 0.3, 5.0), (1, Time::new(0, 1.0), 0.1, 0.0)];
    compare(&simulators, &all, 0.0, 3);
}

#[test]
fn the_work_is_counted_as_the_scalar_engine_counts_it() {
    let mut choices = Choices(7);
    for kind in 0..12 {
        let system = systems(&mut choices);
        let count = |vector: bool| {
            let tally = Arc::new(EffectTally::default());
            let simulator = Simulator::new(&system, &Settings::default()).unwrap().counting(tally.clone());
            let run = |i: u32| simulator.start(Time::new(0, 0.5), 1.0 + f64::from(i) / 10.0, 0.0);
            let runs: Vec<_> = (0..9).filter_map(|i| run(i).ok()).collect();
            if vector {
                let mut batch = Batch::new(0.0, runs.into_iter().map(|run| (&simulator, run)).collect());
                (0..20).for_each(|_| batch.pass());
                drop(batch);
            } else {
                // Period by period, as the batch goes.
                for mut run in runs {
                    (1..=20)
                        .for_each(|period| assert!(run.finish(Time::new(period, 0.0)) != RunEnd::NotSmooth));
                }
            }
            Effect::ALL.map(|effect| tally.of(effect))
        };
        assert_eq!(count(true), count(false), "system {kind}: {system:?}");
    }
}

#[test]
fn what_is_observed_of_motions_is_the_same_together_and_one_by_one() {
    let mut choices = Choices(21);
    let (mut periodic, mut others, mut ended, mut shown, mut early) = (0, 0, 0, 0, 0);
    for round in 0..9 {
        let settings = Settings { impact_limit: 300, integrate: round == 8, ..Settings::default() };
        let count = [1, 5, 30][round % 3];
        let simulators: Vec<Simulator> =
            (0..count).filter_map(|_| Simulator::new(&systems(&mut choices), &settings).ok()).collect();
        let phase = if choices.one_in(2) { 0.0 } else { choices.number(0.0, 6.25) };
        let observation = Observation {
            phase,
            transient: [0, 30][round % 2],
            longest: 6,
            points: [25, 0, 7][round / 3],
            round: round / 3 > 0,
            every: 1 + round as u32 % 3,
        };
        let starts = starts(&mut choices, &simulators, 30);
        let begin = |&(which, time, q, u): &(usize, Time, f64, f64)| {
            let simulator = &simulators[which];
            simulator.start(time, q, u).ok().map(|run| (simulator, run))
        };
        let together = Simulator::observe(starts.iter().filter_map(begin).collect(), &observation, &());
        let starts_that_begin: Vec<_> = starts.iter().filter(|start| begin(start).is_some()).collect();
        for (i, (motion, found)) in starts.iter().filter_map(begin).zip(together.unwrap()).enumerate() {
            let alone = Simulator::observe(vec![motion], &observation, &()).unwrap().remove(0);
            // As text, which tells every bit, and is equal where there is no number.
            assert_eq!(format!("{found:?}"), format!("{alone:?}"), "round {round}, motion {i}");
            match found {
                Ok(observed) => {
                    *(if observed.cycle.is_some() { &mut periodic } else { &mut others }) += 1;
                    shown += observed.points.len();
                    // What is told early is where it comes to in the end.
                    let Some(cycle) = &observed.cycle else { continue };
                    let (_, mut run) = begin(starts_that_begin[i]).expect("it has begun");
                    let now = run.time().period;
                    early += usize::from(
                        run.finish(Time::new(now + 4_000, phase)) == RunEnd::Reached
                            && !cycle.passes(&[run.state().q, run.state().u]),
                    );
                }
                Err(_) => ended += 1,
            }
        }
    }
    assert!(periodic > 100 && others > 0 && ended > 2 && shown > 100, "{periodic} {others} {ended} {shown}");
    assert!(early < 3, "{early} of {periodic}");
}

#[test]
fn a_diagram_is_that_of_its_values_and_starts_one_by_one() {
    let start = |q, u| State { t: 1.0, q, u };
    let plan = DiagramPlan {
        values: (0..9).map(|i| -0.05 + 0.01 * f64::from(i)).collect(),
        starts: vec![start(1.5, 0.0), start(0.0, 0.0), start(-3.0, 0.0), start(2.6, 0.3)],
        look: Look { phase: 2.0, transient: 60, points: 30, longest: 8 },
        every: 2,
    };
    let system = |mu| Simulator::new(&paper(mu, 1.0), &Settings::default());
    // On one thread the motions of all values are followed together.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let slices = pool.install(|| sweep(&plan, system, "", None, &()).unwrap());
    let mut several = 0;
    for slice in &slices {
        let mut motions = Vec::new();
        for start in &plan.starts {
            let one = DiagramPlan { values: vec![slice.value], starts: vec![*start], ..plan.clone() };
            let alone = sweep(&one, system, "", None, &()).unwrap().remove(0);
            motions.extend(alone.motions);
        }
        assert_eq!(slice.lost, 1);
        // An attractor is kept as the first motion that leads to it has it.
        let mut next = motions.iter();
        assert_eq!(slice.motions[0], motions[0]);
        assert!(slice.motions.iter().all(|motion| next.any(|other| other == motion)), "{slice:?}");
        several += usize::from(slice.motions.len() > 1);
    }
    assert!(several > 1, "at {several} of 9 values attractors coexist");
}

/// Basins by the scalar engine alone, start by start.
fn one_by_one(simulator: &Simulator, grid: &BasinGrid, detection: &Detection) -> Basins {
    let (mut attractors, mut cells): (Vec<Cycle>, Vec<BasinCell>) = (Vec::new(), Vec::new());
    for place in 0..grid.rows * grid.columns {
        let [q, u] = grid.start(place % grid.columns, place / grid.columns);
        cells.push(match simulator.start(Time::new(0, detection.phase), q, u) {
            Err(_) => BasinCell::Behind,
            Ok(mut run) => {
                // The transient, and then the first point.
                let later = Time::new(detection.transient as i64, detection.phase);
                let end = run.finish(later);
                assert_eq!(end, RunEnd::Reached);
                let settled = Detection { transient: 0, ..detection.clone() };
                match settled.detect(simulator, &mut run, &()).unwrap() {
                    Fate::Periodic(cycle) => {
                        let known = attractors.iter().position(|other| other.is(&cycle));
                        BasinCell::Attractor(known.unwrap_or_else(|| {
                            attractors.push(cycle);
                            attractors.len() - 1
                        }))
                    }
                    _ => BasinCell::Irregular,
                }
            }
        });
    }
    Basins { attractors, cells }
}

#[test]
fn basins_are_those_found_start_by_start() {
    let grid = BasinGrid { q: [-0.2, 3.0], u: [-2.0, 2.0], columns: 23, rows: 21 };
    // A resting motion and an orbit of period 4; one chaotic attractor.
    for mu in [-0.05, 0.003] {
        let simulator = Simulator::new(&paper(mu, 1.0), &Settings::default()).unwrap();
        let detection = Detection { transient: 100, longest: 8, ..Detection::default() };
        let found = basins(&simulator, &grid, &detection, "", None, &()).unwrap();
        let expected = one_by_one(&simulator, &grid, &detection);
        assert_eq!(found.cells, expected.cells, "{mu}");
        assert!(found.cells.contains(&BasinCell::Behind));
        for (one, other) in found.attractors.iter().zip(&expected.attractors) {
            assert!(one.is(other), "{mu}");
        }
    }
}

/// Periods in which a vector turns to the direction that grows most, whole rounds of the orbits that occur.
const ALIGNED: u64 = 720;

#[test]
fn a_map_is_that_of_its_points_one_by_one() {
    let look = Look { phase: 0.0, transient: 200, points: 60, longest: 16 };
    let plan = MapPlan {
        columns: (0..7).map(|i| -0.06 + 0.012 * f64::from(i)).collect(),
        rows: vec![0.3, 0.8, 1.0],
        start: State { t: 1.0, q: 1.5, u: 0.0 },
        look: look.clone(),
    };
    let settings = Settings::default();
    let system = |mu: f64, tau: f64| Simulator::new(&paper(mu, tau), &settings);
    let cells = map(&plan, system, "", None, &()).unwrap();
    let (mut periodic, mut unsettled) = (0, 0u32);
    for (i, cell) in cells.iter().enumerate() {
        let mut aligned = false;
        let simulator = system(plan.columns[i % 7], plan.rows[i / 7]).unwrap();
        let mut run = simulator.start(Time::new(0, 1.0), 1.5, 0.0).unwrap();
        assert_eq!(run.finish(Time::new(201, 0.0)), RunEnd::Reached);
        let state = run.state();
        let before = run.impacts();
        let mut again = simulator.start(Time::new(0, 0.0), state.q, state.u).unwrap();
        let detection = Detection { transient: 0, longest: 16, ..Detection::default() };
        // Its first point is a period later: no matter on an attractor.
        let expected = match detection.detect(&simulator, &mut again, &()).unwrap() {
            Fate::Periodic(cycle) => {
                periodic += 1;
                // Where the largest multiplier is alone, a vector gets its direction, and grows by it.
                if let &[large, small] = &cycle.multipliers[..] {
                    let [large, rounds] =
                        [large.0.hypot(large.1), (ALIGNED as usize / cycle.period()) as f64];
                    aligned = small.1 == 0.0 && rounds * (small.0.abs() / large).ln() < -25.0;
                }
                (MapEnd::Periodic(cycle.period() as u32), cycle.impacts)
            }
            _ => {
                run.finish(Time::new(261, 0.0));
                // A map looks for so many periods, and may leave open what more of them decide.
                unsettled += u32::from(cell.end == MapEnd::Unsettled);
                let end = if cell.end == MapEnd::Unsettled { cell.end } else { MapEnd::NotPeriodic };
                (end, run.impacts() - before)
            }
        };
        assert_eq!((cell.end, cell.impacts), expected, "point {i}");
        // Two multipliers of one modulus turn the vector: by how much it then grows or shrinks in all, a
        // factor of at most e¹⁰ here, is divided by the time. Where one is alone, what the first rounds do to
        // the vector cancels between two means. Started anew from the state a chaotic motion differs by
        // rounding, which chaos enlarges within 60 periods.
        let mean = |periods: u64| {
            let found = lyapunov(&simulator, Time::new(0, 0.0), [state.q, state.u], 0, periods, &()).unwrap();
            found.rate * std::f64::consts::TAU
        };
        let (exponent, tolerance) = match cell.end {
            MapEnd::Periodic(_) if aligned => (2.0 * mean(ALIGNED * 4) - mean(ALIGNED * 2), 1e-9),
            MapEnd::Periodic(_) => (mean(20_000), 10.0 / 20_000.0),
            _ => (mean(60), 1e-3),
        };
        match cell.exponent {
            Some(found) => assert!((found - exponent).abs() < tolerance, "point {i}: {found} {exponent}"),
            None => assert!(!exponent.is_finite(), "point {i}: {exponent}"),
        }
    }
    assert!(periodic > 3, "{periodic} points are periodic");
    // One is left open, whose transient is longer than what a map looks at; more would be a weaker detector.
    assert!(unsettled <= 1, "{unsettled} points are not settled");
    // A start behind the wall, and a motion beyond every bound.
    let behind = MapPlan { start: State { t: 0.0, q: -3.0, u: 0.0 }, ..plan.clone() };
    let all = map(&behind, system, "", None, &()).unwrap();
    assert!(all.iter().all(|cell| *cell == MapCell { end: MapEnd::BehindAWall, impacts: 0, exponent: None }));
    let escaping = |_: f64, _: f64| {
        Simulator::new(
            &System { lower: wall(-1.0, 0.0, 1.0), ..self::system(-3.0, 0.1, 0.0, 0.0) },
            &settings,
        )
    };
    let all = map(&plan, escaping, "", None, &()).unwrap();
    assert!(all.iter().all(|cell| cell.end == MapEnd::Ended(RunEnd::Escaped)));
}
