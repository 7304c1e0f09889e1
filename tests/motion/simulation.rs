//! The simulator against exact solutions, against itself by other routes, and in every special case.

use std::{
    f64::consts::{PI, TAU},
    io::Write,
    sync::atomic::{AtomicI64, Ordering},
};

use grazing_scenes::{
    Error, Monitor, Result,
    attractor::{
        basins::{BasinCell, BasinGrid, basins},
        detection::{Detection, Fate},
    },
    motion::{
        Contact, Counts, Effect, Flow, Harmonic, RunEnd, Side, State, System, Time, Wall, event::Impact,
        flow::Linear,
    },
    one::{
        attractor::lyapunov,
        simulate::{Event, Run, Settings, Simulator},
    },
};

mod batch;
mod forces;

fn bare(damping: f64, stiffness: f64) -> System<f64> {
    System { damping, stiffness, ..System::default() }
}

fn wall(offset: f64, restitution: f64, harmonics: &[(u32, f64, f64)]) -> Wall<f64> {
    let harmonics = harmonics.iter().map(|&(k, cos, sin)| Harmonic { k, cos, sin }).collect();
    Wall { offset, harmonics, restitution }
}

/// The paper's scene.
fn paper(d: f64, w: f64, mu: f64, tau: f64) -> System<f64> {
    System { lower: Some(wall(-1.0, tau, &[(1, 1.0 + mu, 0.0)])), ..bare(2.0 * d / w, 1.0 / (w * w)) }
}

/// A ball under gravity 1 on a fixed table at 0.
fn ball(tau: f64) -> System<f64> {
    System { force: -1.0, lower: Some(wall(0.0, tau, &[])), ..bare(0.0, 0.0) }
}

fn simulator(system: &System<f64>) -> Simulator {
    Simulator::new(system, &Settings::default()).unwrap()
}

/// The same by Taylor steps.
fn integrated(system: &System<f64>, tolerance: f64) -> Simulator {
    Simulator::new(system, &Settings { integrate: true, tolerance, ..Settings::default() }).unwrap()
}

fn events(run: &mut Run, until: Time) -> (Vec<Event>, RunEnd) {
    let mut events = Vec::new();
    let end = run.record(until, |event| events.push(event));
    (events, end)
}

fn impacts(run: &mut Run, until: Time) -> Vec<Impact<Side>> {
    let impact = |event: Event| if let Event::Impact(impact) = event { Some(impact) } else { None };
    events(run, until).0.into_iter().filter_map(impact).collect()
}

fn at(t: f64) -> Time {
    Time::new(0, t)
}

#[test]
fn a_ball_bounces_as_galileo_says() {
    // From height 1/2: impacts at 1, 3, 5, …, each with velocity 1.
    for simulator in [simulator(&ball(1.0)), integrated(&ball(1.0), 1e-13)] {
        let mut run = simulator.start(at(0.0), 0.5, 0.0).unwrap();
        for (i, impact) in impacts(&mut run, at(100.0)).iter().enumerate() {
            let off = impact.time.since(at(0.0)) - (2 * i + 1) as f64;
            assert!(off.abs() < 1e-12, "impact {i} is off by {off:e}");
            assert!((impact.velocity + 1.0).abs() < 1e-12);
            assert_eq!(impact.place, Side::Lower);
        }
        assert_eq!(run.impacts(), 50);
    }
}

#[test]
fn bounces_accumulate_at_the_exact_time_and_end_in_rest() {
    for tau in [0.3, 0.5, 0.9] {
        for simulator in [simulator(&ball(tau)), integrated(&ball(tau), 1e-13)] {
            let mut run = simulator.start(at(0.0), 0.5, 0.0).unwrap();
            let (events, end) = events(&mut run, at(1000.0));
            assert_eq!(end, RunEnd::Reached);
            let Some(Event::Stick(stick)) = events.last() else { panic!("{events:?}") };
            // 1 + 2τ + 2τ² + …
            let exact = 1.0 + 2.0 * tau / (1.0 - tau);
            let off = stick.time.since(at(0.0)) - exact;
            // Bounces as low as 1e-12 are timed to rounding over their velocity, 1e-16 / 1e-6.
            assert!(off.abs() < 1e-9, "τ = {tau}: off by {off:e}");
            assert!(events[..events.len() - 1].iter().all(|event| matches!(event, Event::Impact(_))));
            assert_eq!((run.state().q, run.state().u), (0.0, 0.0));
        }
    }
}

#[test]
fn restitution_zero_sticks_at_once() {
    let system = ball(0.0);
    let simulator = simulator(&system);
    let mut run = simulator.start(at(0.0), 0.5, 0.0).unwrap();
    let (events, _) = events(&mut run, at(50.0));
    let [Event::Impact(impact), Event::Stick(stick)] = events[..] else { panic!("{events:?}") };
    assert!(impact.time == stick.time && stick.rest == 0.0);
    assert!((impact.time.since(at(0.0)) - 1.0).abs() < 1e-15 + impact.radius);
}

#[test]
fn a_table_lets_go_where_its_acceleration_passes_gravity() {
    // On Q = 2 sin t under gravity 1 contact is lost where 2 sin t = 1.
    for tau in [0.0, 0.4] {
        let system = System { lower: Some(wall(0.0, tau, &[(1, 0.0, 2.0)])), ..ball(tau) };
        for simulator in [simulator(&system), integrated(&system, 1e-13)] {
            let mut run = simulator.start(at(0.0), 0.0, 2.0).unwrap();
            let (events, _) = events(&mut run, at(2.0));
            let [Event::Stick(stick), Event::Release(release)] = events[..] else { panic!("{events:?}") };
            assert_eq!(stick.time, at(0.0));
            assert!((release.time.phase - PI / 6.0).abs() < 1e-14);
            let next = impacts(&mut run, at(20.0))[0];
            // Free flight from there: z = 1 + √3 s − s²/2 − 2 sin(π/6 + s).
            let s = next.time.since(release.time);
            let z = 1.0 + 3f64.sqrt() * s - s * s / 2.0 - 2.0 * (PI / 6.0 + s).sin();
            assert!(z.abs() < 1e-13, "{z:e}");
        }
    }
}

#[test]
fn starts_on_a_wall_are_impacts_rests_or_departures_and_behind_it_errors() {
    let simulator = simulator(&ball(0.5));
    let first = |q: f64, u: f64| simulator.start(at(1.0), q, u).unwrap().next(at(1.1));
    let Event::Impact(impact) = first(0.0, -1.0) else { panic!() };
    assert_eq!((impact.time, impact.velocity), (at(1.0), -1.0));
    assert!(matches!(first(0.0, 0.0), Event::Stick(stick) if stick.time == at(1.0)));
    assert_eq!(first(0.0, 1.0), Event::End(RunEnd::Reached));
    assert!(matches!(first(5e-13, -1.0), Event::Impact(_)));
    let error = simulator.start(at(1.0), -1e-9, 1.0).err().unwrap();
    assert!(error.is_input() && error.to_string().contains("lower wall"), "{error}");
    assert!(simulator.start(at(1.0), f64::NAN, 1.0).err().unwrap().is_input());
    // An impact at the initial time that sticks at once: both are told, in order.
    let still = Simulator::new(&ball(0.0), &Settings::default()).unwrap();
    let (events, _) = events(&mut still.start(at(1.0), 0.0, -1.0).unwrap(), at(2.0));
    assert!(matches!(events[..], [Event::Impact(_), Event::Stick(_)]), "{events:?}");
}

#[test]
fn two_walls_take_turns() {
    // Free flight between walls at ±1 with velocity 1: an impact every 2.
    let system =
        System { lower: Some(wall(-1.0, 1.0, &[])), upper: Some(wall(1.0, 1.0, &[])), ..bare(0.0, 0.0) };
    for simulator in [simulator(&system), integrated(&system, 1e-13)] {
        let mut run = simulator.start(at(0.0), 0.0, 1.0).unwrap();
        for (i, impact) in impacts(&mut run, at(200.0)).iter().enumerate() {
            assert!((impact.time.since(at(0.0)) - (2 * i + 1) as f64).abs() < 1e-11);
            assert_eq!(impact.place, if i % 2 == 0 { Side::Upper } else { Side::Lower });
        }
        assert_eq!(run.impacts(), 100);
    }
}

#[test]
fn walls_that_meet_and_values_out_of_range_are_refused() {
    let close = |gap: f64| System {
        lower: Some(wall(0.0, 1.0, &[(1, 1.0, 0.0)])),
        upper: Some(wall(2.0 + gap, 1.0, &[(1, 0.0, 0.0), (1, -1.0, 0.0)])),
        ..bare(0.0, 1.0)
    };
    let error = Simulator::new(&close(1e-13), &Settings::default()).unwrap_err();
    assert!(error.is_input() && error.to_string().contains("walls meet at phase"), "{error}");
    assert!(Simulator::new(&close(1e-9), &Settings::default()).is_ok());
    let negative = System { lower: Some(wall(0.0, -0.1, &[])), ..bare(0.0, 1.0) };
    assert!(Simulator::new(&negative, &Settings::default()).unwrap_err().to_string().contains("lower wall"));
    for minimum_depth in [0.0, -1e-12, f64::NAN, f64::INFINITY] {
        let settings = Settings { minimum_depth, ..Settings::default() };
        assert!(Simulator::new(&bare(0.0, 1.0), &settings).unwrap_err().is_input());
    }
    let fast = System { lower: Some(wall(-1.0, 1.0, &[])), ..bare(0.0, 1e12) };
    assert!(Simulator::new(&fast, &Settings::default()).unwrap_err().to_string().contains("frequency"));
}

#[test]
fn runs_end_for_a_reason() {
    let limited = Settings { impact_limit: 7, ..Settings::default() };
    let limited = Simulator::new(&ball(1.0), &limited).unwrap();
    let mut run = limited.start(at(0.0), 0.5, 0.0).unwrap();
    assert_eq!((run.finish(at(1e6)), run.impacts()), (RunEnd::ImpactLimit, 7));
    assert_eq!(run.next(at(1e6)), Event::End(RunEnd::ImpactLimit));
    // Negative stiffness, linear and cubic, away from the wall and without one.
    for cubic in [0.0, -1.0] {
        for lower in [None, Some(wall(-1.0, 1.0, &[]))] {
            let system = System { cubic, lower, ..bare(0.0, -1.0) };
            let simulator = simulator(&system);
            assert_eq!(
                simulator.start(at(0.0), 0.5, 0.0).unwrap().finish(at(1e4)),
                RunEnd::Escaped,
                "{system:?}"
            );
        }
    }
}

/// µ such that from rest, q = 0, the wall's summit comes `lift` short of the oscillator.
fn graze(lift: f64) -> (System<f64>, f64) {
    (paper(0.6, 4.9, -lift, 1.0), lift)
}

#[test]
fn what_grazes_is_told_apart_by_the_minimum_depth() {
    for (lift, tangent, impact) in [
        (0.0, true, false),
        (5e-13, true, false),
        (-5e-13, true, false),
        (2e-12, false, false),
        (-2e-12, false, true),
    ] {
        let (system, _) = graze(lift);
        let simulator = simulator(&system);
        let mut run = simulator.start(at(1.0), 0.0, 0.0).unwrap();
        let (events, _) = events(&mut run, at(12.0));
        match events[..] {
            [Event::Tangency(tangency)] => {
                assert!(tangent && (tangency.gap - lift).abs() < 1e-15, "{lift}: {tangency:?}");
                assert!(tangency.time.since(at(TAU)).abs() < 1e-7);
            }
            [Event::Impact(hit), ..] => {
                assert!(impact, "{lift}: {hit:?}");
                let exact = -(2.0 * -lift).sqrt();
                assert!((hit.velocity / exact - 1.0).abs() < 1e-3, "{} {exact}", hit.velocity);
            }
            ref other => assert!(!tangent && !impact && other.is_empty(), "{lift}: {other:?}"),
        }
    }
}

#[test]
fn impact_velocity_has_slope_one_half_at_grazing_and_one_away_from_it() {
    let velocity = |mu: f64| {
        let simulator = simulator(&paper(0.6, 4.9, mu, 1.0));
        impacts(&mut simulator.start(at(1.0), 0.0, 0.0).unwrap(), at(8.0))[0].velocity
    };
    let slope = |f: &dyn Fn(f64) -> f64, h: f64| (f(2.0 * h) / f(h)).ln() / 2f64.ln();
    for h in [1e-4, 1e-6, 1e-8] {
        assert!((slope(&velocity, h) - 0.5).abs() < 1e-3);
        let away = |h: f64| velocity(0.1 + h) - velocity(0.1);
        assert!((slope(&away, h) - 1.0).abs() < 1e-3, "{h:e}");
    }
}

#[test]
fn energy_is_kept_and_time_turned_back_without_losses() {
    let fixed = System { lower: Some(wall(-0.3, 1.0, &[])), ..bare(0.0, 1.7) };
    let energy = |q: f64, u: f64| u * u + 1.7 * q * q;
    let simulator = simulator(&fixed);
    let mut run = simulator.start(at(0.0), 1.0, 0.4).unwrap();
    assert_eq!(run.finish(Time::new(1000, 0.0)), RunEnd::Reached);
    assert!(run.impacts() > 1000);
    let end = run.state();
    assert!((energy(end.q, end.u) / energy(1.0, 0.4) - 1.0).abs() < 1e-11);

    // The paper's wall is even in time: from (q, −u) at −t the motion runs back. Chaotic, so for a few
    // periods.
    let moving = Simulator::new(&paper(0.0, 4.9, 0.003, 1.0), &Settings::default()).unwrap();
    let mut there = moving.start(at(-PI), 0.03, 0.01).unwrap();
    let forth = impacts(&mut there, Time::new(5, PI));
    let end = there.state();
    let mut back = moving.start(Time::new(-6, PI), end.q, -end.u).unwrap();
    let returned = impacts(&mut back, at(PI));
    assert_eq!(forth.len(), returned.len());
    assert!(forth.len() >= 2, "{forth:?}");
    for (a, b) in forth.iter().zip(returned.iter().rev()) {
        assert!((a.time.since(at(0.0)) + b.time.since(at(0.0))).abs() < 1e-9, "{a:?} {b:?}");
        assert!((a.velocity - b.velocity).abs() < 1e-9);
    }
    let home = back.state();
    assert!((home.q - 0.03).abs() < 1e-9 && (home.u + 0.01).abs() < 1e-9, "{home:?}");
}

#[test]
fn the_closed_form_and_the_integrator_see_the_same_impacts() {
    let two = System {
        lower: Some(wall(-0.6, 0.8, &[(2, 0.05, 0.0)])),
        upper: Some(wall(0.7, 0.6, &[])),
        forcing: vec![Harmonic { k: 1, cos: 0.8, sin: 0.0 }, Harmonic { k: 3, cos: 0.0, sin: 0.2 }],
        ..bare(0.1, 1.3)
    };
    for (system, q) in [(paper(0.6, 4.9, 0.003, 1.0), 0.01), (paper(0.6, 4.9, 0.05, 0.9), 0.3), (two, 0.1)] {
        let (closed, stepped) = (simulator(&system), integrated(&system, 1e-14));
        let a = impacts(&mut closed.start(at(1.0), q, 0.0).unwrap(), at(60.0));
        let b = impacts(&mut stepped.start(at(1.0), q, 0.0).unwrap(), at(60.0));
        assert_eq!(a.len(), b.len());
        assert!(!a.is_empty());
        for (a, b) in a.iter().zip(&b) {
            assert!(
                (a.time.since(b.time)).abs() < 1e-9 && (a.velocity - b.velocity).abs() < 1e-9,
                "{a:?} {b:?}"
            );
        }
    }
}

/// The steps of a ball's parabola know nothing of the table, which moves through more than a period in the
/// longest of them.
#[test]
fn steps_are_short_enough_for_a_fast_wall() {
    let system = System { lower: Some(wall(0.0, 0.9, &[(9, 0.0, 0.005)])), ..ball(0.9) };
    let found = [simulator(&system), integrated(&system, 1e-13)]
        .map(|simulator| impacts(&mut simulator.start(at(0.0), 0.5, 0.0).unwrap(), at(12.0)));
    assert!(found[0].len() > 5 && found[0].len() == found[1].len(), "{found:?}");
    for (a, b) in found[0].iter().zip(&found[1]) {
        assert!(a.time.since(b.time).abs() < 1e-10 && (a.velocity - b.velocity).abs() < 1e-10, "{a:?} {b:?}");
    }
}

/// Strong force between near walls: one piece of the free flight crosses both, and only the first is met.
#[test]
fn the_first_of_two_walls_on_a_piece_is_met() {
    for sign in [1.0, -1.0] {
        let (lower, upper) = (Some(wall(-0.1, 1.0, &[])), Some(wall(0.1, 1.0, &[])));
        let system = System { force: -100.0 * sign, lower, upper, ..bare(0.0, 0.0) };
        for simulator in [simulator(&system), integrated(&system, 1e-13)] {
            let impact = impacts(&mut simulator.start(at(0.0), 0.0, 5.0 * sign).unwrap(), at(0.7))[0];
            assert_eq!(impact.place, if sign > 0.0 { Side::Upper } else { Side::Lower });
            // 5t − 50t² = 1/10
            assert!((impact.time.phase - (5.0 - 5f64.sqrt()) / 100.0).abs() < 1e-14);
        }
    }
}

/// With τ near 1 the bounces would last until after the table's acceleration has passed gravity: no rest is
/// made of them.
#[test]
fn bounces_are_not_summed_beyond_a_change_of_force() {
    let system = System { lower: Some(wall(0.0, 1.0 - 1e-7, &[(1, 0.0, 2.0)])), ..ball(1.0) };
    let simulator = simulator(&system);
    let first = simulator.start(at(0.0), 0.0, 2.0 + 1e-7).unwrap().next(at(5.0));
    assert!(matches!(first, Event::Impact(impact) if (impact.time.phase - 2e-7).abs() < 1e-8), "{first:?}");
}

#[test]
fn the_linearised_cubic_flow_is_its_difference_quotient() {
    let flow = simulator(&System { cubic: 0.8, ..bare(0.1, -0.5) }).flow().clone();
    let from = |dq: f64, du: f64| State { t: 0.3, q: 0.9 + dq, u: 0.4 + du };
    let (_, matrix) = flow.advance_linearised(from(0.0, 0.0), 2.0);
    let h = 1e-4;
    for (column, [dq, du]) in [[h, 0.0], [0.0, h]].into_iter().enumerate() {
        let (a, b) = (flow.advance(from(dq, du), 2.0), flow.advance(from(-dq, -du), 2.0));
        for (row, difference) in [a.q - b.q, a.u - b.u].into_iter().enumerate() {
            assert!((matrix[row][column] - difference / (2.0 * h)).abs() < 1e-6, "{matrix:?}");
        }
    }
}

#[test]
fn a_wall_never_touched_changes_no_event() {
    let with = paper(0.6, 4.9, 0.003, 1.0);
    let both = System { upper: Some(wall(50.0, 0.5, &[])), ..with.clone() };
    let (one, two) = (simulator(&with), simulator(&both));
    let (mut a, mut b) = (one.start(at(1.0), 0.01, 0.0).unwrap(), two.start(at(1.0), 0.01, 0.0).unwrap());
    assert_eq!(events(&mut a, Time::new(200, 0.0)), events(&mut b, Time::new(200, 0.0)));
    assert_eq!(a.state(), b.state());
    // A moving one, without harmonics in the other system.
    let free = simulator(&bare(0.3, 1.0));
    let far = simulator(&System { lower: Some(wall(-50.0, 0.5, &[(2, 1.0, 0.0)])), ..bare(0.3, 1.0) });
    let (mut a, mut b) = (free.start(at(1.0), 0.4, 0.0).unwrap(), far.start(at(1.0), 0.4, 0.0).unwrap());
    assert_eq!((a.finish(at(30.0)), b.finish(at(30.0))), (RunEnd::Reached, RunEnd::Reached));
    assert!((a.state().q - b.state().q).abs() < 1e-15 && (a.state().u - b.state().u).abs() < 1e-15);
}

#[test]
fn zero_and_absent_give_the_same_bits() {
    let plain = paper(0.6, 4.9, 0.003, 1.0);
    let mut zeros = System { cubic: -0.0, force: -0.0, ..plain.clone() };
    zeros.forcing = vec![Harmonic { k: 7, cos: 0.0, sin: -0.0 }];
    zeros.lower.as_mut().unwrap().harmonics.push(Harmonic { k: 1, cos: 0.0, sin: 0.0 });
    let (plain, zeros) = (simulator(&plain), simulator(&zeros));
    let (mut a, mut b) = (plain.start(at(1.0), 0.01, 0.0).unwrap(), zeros.start(at(1.0), 0.01, 0.0).unwrap());
    assert_eq!(events(&mut a, Time::new(300, 0.0)), events(&mut b, Time::new(300, 0.0)));
    assert_eq!(format!("{:?}", a.state()), format!("{:?}", b.state()));
}

#[test]
fn absent_effects_are_never_evaluated() {
    let all = [
        Effect::Piece,
        Effect::Drive,
        Effect::Cubic,
        Effect::Smooth,
        Effect::LowerGap,
        Effect::UpperGap,
        Effect::Search,
        Effect::Release,
    ];
    let force = vec![Harmonic { k: 1, cos: 0.3, sin: 0.0 }];
    let (low, high) = (Some(wall(-0.2, 0.9, &[])), Some(wall(0.2, 0.9, &[])));
    let one = bare(0.02, 1.1);
    use Effect::{Cubic, Drive, LowerGap, Piece, Search, UpperGap};
    let cases: [(System<f64>, &[Effect]); 7] = [
        (one.clone(), &[]),
        (System { forcing: force.clone(), ..one.clone() }, &[]),
        (System { lower: low.clone(), ..one.clone() }, &[Piece, LowerGap, Search]),
        (System { upper: high.clone(), ..one.clone() }, &[Piece, UpperGap, Search]),
        (
            System { lower: low.clone(), forcing: force.clone(), ..one.clone() },
            &[Piece, Drive, LowerGap, Search],
        ),
        (System { lower: low.clone(), upper: high, ..one.clone() }, &[Piece, LowerGap, UpperGap, Search]),
        (System { lower: low, cubic: 1.0, ..one.clone() }, &[Piece, Cubic, LowerGap, Search]),
    ];
    for (system, present) in cases {
        let mut counts = Counts::default();
        let simulator = simulator(&system);
        let mut run = simulator.start_counting(at(0.0), 0.1, 1.0, &mut counts).unwrap();
        assert_eq!(run.finish(at(12.0)), RunEnd::Reached);
        drop(run);
        for effect in all {
            assert_eq!(counts.of(effect) > 0, present.contains(&effect), "{effect:?} in {system:?}");
        }
    }
}

#[test]
fn impacts_obey_the_law_and_stay_outside_the_wall() {
    let system = paper(0.6, 4.9, 0.05, 0.9);
    let simulator = simulator(&system);
    let contact: &Contact = simulator.contacts().next().unwrap();
    let mut run = simulator.start(at(1.0), 0.4, 0.0).unwrap();
    let mut before = run.state();
    let mut time = run.time();
    for _ in 0..200 {
        let Event::Impact(impact) = run.next(Time::new(10_000, 0.0)) else { panic!("impacts go on") };
        let arrival = simulator.flow().advance(before, impact.time.since(time));
        let [z, velocity] = contact.gap(arrival);
        assert!(z.abs() < 1e-13 && (velocity - impact.velocity).abs() < 1e-13, "{z:e}");
        assert!(impact.radius < 1e-8);
        (before, time) = (run.state(), run.time());
        let [z, out] = contact.gap(before);
        assert!(z.abs() < 1e-13 && (out + 0.9 * impact.velocity).abs() < 1e-13);
    }
}

#[test]
fn attractors_are_detected_with_period_and_impacts() {
    // µ = 0.0058: beyond the flip of period 3, which is stable there; µ < 0: rest, without impacts.
    let fate = |mu: f64| {
        let simulator = simulator(&paper(0.6, 4.9, mu, 1.0));
        let mut run = simulator.start(at(1.0), 0.004, 0.0).unwrap();
        Detection::default().detect(&simulator, &mut run, &()).unwrap()
    };
    let Fate::Periodic(cycle) = fate(0.0058) else { panic!("{:?}", fate(0.0058)) };
    assert_eq!((cycle.period(), cycle.impacts), (3, 1));
    let Fate::Periodic(rest) = fate(-0.2) else { panic!() };
    assert_eq!((rest.period(), rest.impacts), (1, 0));
    assert_eq!(fate(0.003), Fate::Irregular);
    // A slow turn round an ellipse: points are near their successors where it is flat, and not for long.
    let turning = simulator(&bare(0.0, 1.001 * 1.001));
    // A part of the extent, which is 2: the same distance as 5·10⁻³.
    let near = Detection { transient: 0, longest: 1, tolerance: 2.5e-3, confirm: 60, ..Detection::default() };
    let mut run = turning.start(at(0.0), 0.5f64.sqrt(), -0.5f64.sqrt()).unwrap();
    assert_eq!(near.detect(&turning, &mut run, &()).unwrap(), Fate::Irregular);
    assert!(Detection { longest: 0, ..Detection::default() }.check().unwrap_err().is_input());
}

/// With light damping and a stop that takes nothing irregular motion lasts for thousands of periods, and
/// comes to an orbit all the same: before it has, nothing else is said.
#[test]
fn a_long_irregular_transient_is_not_called_what_it_tends_to() {
    let system = System {
        forcing: vec![Harmonic { k: 1, cos: 1.0, sin: 0.0 }],
        lower: Some(Wall { offset: -0.421875, restitution: 1.0, harmonics: Vec::new() }),
        ..bare(1.0 / 2048.0, 3.125)
    };
    let simulator = simulator(&system);
    let fate = |q: f64, u: f64, transient: u64| {
        let mut run = simulator.start(at(0.0), q, u).unwrap();
        Detection { transient, ..Detection::default() }.detect(&simulator, &mut run, &()).unwrap()
    };
    for (q, u) in [(0.0, 0.0), (0.052734375, 0.00164794921875), (0.2109375, 0.421875)] {
        let Fate::Periodic(cycle) = fate(q, u, 10_000) else { panic!("{q}, {u}") };
        assert!([2, 4].contains(&cycle.period()), "{q}, {u}: {cycle:?}");
        for transient in [200, 1000, 3000] {
            let early = fate(q, u, transient);
            let is_right = matches!(&early, Fate::Unsettled) || matches!(&early, Fate::Periodic(_));
            assert!(is_right, "{q}, {u} after {transient}: {early:?}");
        }
    }
}

#[test]
fn lyapunov_exponents_match_what_is_known() {
    // Without impacts: −c/2. At rest on a wall: −∞. On the stable orbit of period 3 below 0, in chaos above.
    let free = lyapunov(&simulator(&bare(0.2, 1.0)), at(0.0), [1.0, 0.0], 10, 2000, &()).unwrap();
    assert!((free.rate + 0.1).abs() < 1e-4, "{free:?}");
    // Overdamped: once the tangent has turned, exactly the slow eigenvalue.
    let slow = lyapunov(&simulator(&bare(3.0, 1.0)), at(0.0), [1.0, 0.0], 0, 20, &()).unwrap();
    assert!((slow.second_half - (5f64.sqrt() - 3.0) / 2.0).abs() < 1e-10, "{slow:?}");
    // Impacts at 1, 3, 5, …: 32 of them from 20π to 40π.
    assert_eq!(lyapunov(&simulator(&ball(1.0)), at(0.0), [0.5, 0.0], 10, 10, &()).unwrap().impacts, 32);
    let rest = lyapunov(&simulator(&ball(0.5)), at(0.0), [0.5, 0.0], 0, 10, &()).unwrap();
    assert_eq!(rest.rate, f64::NEG_INFINITY);
    assert!(
        lyapunov(&simulator(&bare(0.2, 1.0)), at(0.0), [1.0, 0.0], 0, 1, &())
            .unwrap()
            .standard_error
            .is_nan()
    );
    let exponent =
        |mu| lyapunov(&simulator(&paper(0.6, 4.9, mu, 1.0)), at(1.0), [0.004, 0.0], 3000, 3000, &()).unwrap();
    assert!(exponent(0.0058).rate < -0.001);
    let chaos = exponent(0.003);
    // Two stretches of the motion's length differ by about their errors; a multiplier's exponent has next to
    // none.
    assert!((1e-4..0.03).contains(&chaos.standard_error), "{chaos:?}");
    assert!((chaos.rate - chaos.second_half).abs() < 4.0 * chaos.standard_error, "{chaos:?}");
    assert!(free.standard_error < 1e-4, "{free:?}");
    assert!(chaos.rate > 0.01 && (chaos.rate / chaos.second_half - 1.0).abs() < 0.2, "{chaos:?}");
}

/// Ends the work after so many units.
struct After(AtomicI64);

impl Monitor for After {
    fn advance(&self, units: u64) -> Result<()> {
        let left = self.0.fetch_sub(units as i64, Ordering::Relaxed) - units as i64;
        if left <= 0 { Err(Error::interrupted("enough")) } else { Ok(()) }
    }
}

/// Counts units and notes.
#[derive(Default)]
struct Rows(AtomicI64, AtomicI64);

impl Monitor for Rows {
    fn note(&self, what: &str) {
        assert!(what.contains("basins.json: dropped the last line"), "{what}");
        self.1.fetch_add(1, Ordering::Relaxed);
    }

    fn advance(&self, units: u64) -> Result<()> {
        self.0.fetch_add(units as i64, Ordering::Relaxed);
        Ok(())
    }
}

#[test]
fn basins_tell_starts_apart() {
    let simulator = simulator(&paper(0.6, 4.9, -0.05, 1.0));
    let frame = BasinGrid { q: [-0.2, 1.2], u: [-0.5, 0.5], columns: 15, rows: 5 };
    let detection = Detection { transient: 300, ..Detection::default() };
    let basins = basins(&simulator, &frame, &detection, "", None, &()).unwrap();
    assert_eq!(basins.cells.len(), 75);
    // At phase 0 the wall is at −0.05: the first column lies behind it.
    assert!((0..5).all(|row| basins.cells[15 * row] == BasinCell::Behind));
    assert!(basins.cells.contains(&BasinCell::Attractor(0)));
    assert!(basins.attractors.iter().any(|cycle| cycle.impacts == 0));
    // Interrupted after some rows and resumed: the same.
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("basins.json");
    let tall = BasinGrid { rows: 40, ..frame };
    let run = |file: Option<&std::path::Path>, monitor: &dyn Monitor| {
        grazing_scenes::attractor::basins::basins(&simulator, &tall, &detection, "", file, monitor)
    };
    let whole = run(None, &()).unwrap();
    assert!(run(Some(&file), &After(20.into())).unwrap_err().is_interrupted());
    std::fs::OpenOptions::new().append(true).open(&file).unwrap().write_all(b"0123456789abc").unwrap();
    let rows = Rows::default();
    assert_eq!(run(Some(&file), &rows).unwrap(), whole);
    assert_eq!(rows.0.into_inner(), 40, "rows of the checkpoint and of the rest");
    assert_eq!(rows.1.into_inner(), 1, "a note of the torn line");
}

#[test]
fn two_attractors_have_a_basin_each() {
    // Two wells at ±1; from rest the damped motion stays in its own.
    let system = System { cubic: 1.0, ..bare(0.5, -1.0) };
    let frame = BasinGrid { q: [-1.3, 1.3], u: [0.0, 0.0], columns: 6, rows: 1 };
    let detection = Detection { transient: 20, longest: 2, ..Detection::default() };
    let basins = basins(&simulator(&system), &frame, &detection, "", None, &()).unwrap();
    assert_eq!(basins.cells, [0, 0, 0, 1, 1, 1].map(BasinCell::Attractor));
    assert!(
        basins.attractors.iter().zip([-1.0, 1.0]).all(|(cycle, q)| (cycle.points[0][0] - q).abs() < 1e-6)
    );
}

#[test]
fn a_duffing_oscillator_keeps_its_energy_at_an_elastic_wall() {
    let system = System { cubic: 0.8, lower: Some(wall(-0.4, 1.0, &[])), ..bare(0.0, -0.5) };
    let energy = |q: f64, u: f64| u * u / 2.0 - 0.25 * q * q + 0.2 * q.powi(4);
    let mut last = f64::INFINITY;
    for (tolerance, most) in [(1e-3, 1e-2), (1e-6, 1e-5), (1e-9, 1e-8), (1e-13, 1e-12)] {
        let simulator = Simulator::new(&system, &Settings { tolerance, ..Settings::default() }).unwrap();
        let mut run = simulator.start(at(0.0), 1.3, 0.2).unwrap();
        assert_eq!(run.finish(Time::new(20, 0.0)), RunEnd::Reached);
        assert!(run.impacts() > 10);
        let off = (energy(run.state().q, run.state().u) - energy(1.3, 0.2)).abs();
        assert!(off < most && off <= last, "{tolerance:e}: {off:e}");
        last = off.max(1e-14);
    }
}

#[test]
fn a_stable_orbit_is_met_to_rounding_after_many_periods() {
    // The exact orbit of period 3 with one impact at µ = 0.0058, by the matrices of its three periods of
    // flight.
    let mu = 0.0058;
    let system = paper(0.6, 4.9, mu, 1.0);
    let e = Linear::new(&system).unwrap().matrix(3.0 * TAU);
    let (a, b, c, d) = (1.0 - e[0][0], -e[0][1], -e[1][0], 1.0 - e[1][1]);
    let (x, y, det) = (2.0 * e[0][1], 2.0 * e[1][1], a * d - b * c);
    let (p, r) = ((d * x - b * y) / det, 1.0 + (a * y - c * x) / det);
    let rest = mu * (2.0 + mu);
    let velocity = rest / (p + (p * p + (p * p + r * r) * rest).sqrt());
    let phase = (-(r * velocity)).atan2(1.0 + p * velocity).rem_euclid(TAU);
    let simulator = simulator(&system);
    let mut run = simulator.start(at(1.0), 0.004, 0.0).unwrap();
    run.finish(Time::new(30_000, 0.0));
    for impact in impacts(&mut run, Time::new(30_030, 0.0)) {
        assert!(
            (impact.time.phase - phase).abs() < 1e-13 && (impact.velocity + velocity).abs() < 1e-13,
            "{impact:?}"
        );
    }
}

/// tests/data/impacts.toml, written by make_impacts.py beside it.
mod references {
    use serde::Deserialize;

    #[derive(Deserialize)]
    pub struct File {
        pub case: Vec<Case>,
    }

    #[derive(Deserialize)]
    pub struct Case {
        pub name: String,
        pub tolerance: f64,
        pub damping: f64,
        pub stiffness: f64,
        pub force: f64,
        pub forcing: Vec<(u32, f64, f64)>,
        pub lower: Option<Wall>,
        pub upper: Option<Wall>,
        pub start: [f64; 3],
        pub until: f64,
        pub impacts: Vec<(f64, String, f64)>,
    }

    #[derive(Deserialize)]
    pub struct Wall {
        pub offset: f64,
        pub restitution: f64,
        pub harmonics: Vec<(u32, f64, f64)>,
    }
}

#[test]
fn hard_cases_have_the_impacts_of_their_references() {
    let file: references::File = toml::from_str(include_str!("../data/impacts.toml")).unwrap();
    assert_eq!(file.case.len(), 18);
    for case in file.case {
        let given = |w: references::Wall| wall(w.offset, w.restitution, &w.harmonics);
        let forcing = case.forcing.iter().map(|&(k, cos, sin)| Harmonic { k, cos, sin }).collect();
        let (lower, upper) = (case.lower.map(given), case.upper.map(given));
        let system =
            System { force: case.force, forcing, lower, upper, ..bare(case.damping, case.stiffness) };
        for (route, simulator) in [("closed", simulator(&system)), ("integrated", integrated(&system, 1e-15))]
        {
            let [t, q, u] = case.start;
            let found = impacts(&mut simulator.start(at(t), q, u).unwrap(), at(case.until));
            let name = format!("{}, {route}", case.name);
            assert_eq!(found.len(), case.impacts.len(), "{name}: {found:?}");
            for (impact, (t, side, velocity)) in found.iter().zip(&case.impacts) {
                let off = (impact.time.since(at(0.0)) - t).abs().max((impact.velocity - velocity).abs());
                assert!(off < case.tolerance, "{name}: off by {off:e} at {t}");
                assert_eq!(impact.place.name(), side);
            }
        }
    }
}

/// Between two walls that each give 19 % more speed, until the terms of a step overflow: an end with a
/// reason, and no state that is not a number.
#[test]
fn a_motion_that_gains_at_every_impact_escapes() {
    let system = System {
        cubic: 1.8,
        lower: Some(wall(-0.4, 1.19, &[])),
        upper: Some(wall(0.4, 1.19, &[])),
        ..bare(0.0, 0.0)
    };
    let simulator =
        Simulator::new(&system, &Settings { impact_limit: 100_000, ..Settings::default() }).unwrap();
    let mut run = simulator.start(at(0.5), 0.0, 2.1).unwrap();
    let end = loop {
        let event = run.next(at(60.0));
        let State { q, u, .. } = run.state();
        assert!(q.abs() < 0.41 && u.is_finite(), "{q} {u} after {} impacts", run.impacts());
        if let Event::End(end) = event {
            break end;
        }
    };
    assert_eq!(end, RunEnd::Escaped);
    assert!(run.impacts() > 50, "{}", run.impacts());
}

mod properties {
    use proptest::prelude::*;

    use super::*;

    fn harmonics(size: f64) -> impl Strategy<Value = Vec<(u32, f64, f64)>> {
        prop::collection::vec((1u32..6, -size..size, -size..size), 0..3)
    }

    fn walls() -> impl Strategy<Value = (Option<Wall<f64>>, Option<Wall<f64>>)> {
        let one = |offset| {
            let restitution = prop_oneof![Just(0.0), Just(1.0), 0.0..1.2f64];
            prop::option::weighted(
                0.8,
                (offset, restitution, harmonics(0.1))
                    .prop_map(|(offset, tau, moving)| wall(offset, tau, &moving)),
            )
        };
        (one(-2.0..-0.4f64), one(0.4..2.0f64))
    }

    prop_compose! {
        fn systems()(
            damping in prop_oneof![Just(0.0), 0.0..3.0f64],
            stiffness in prop_oneof![Just(0.0), Just(1.0), -0.5..4.0f64, Just(30.0)],
            cubic in prop_oneof![3 => Just(0.0), 1 => 0.0..2.0f64],
            force in prop_oneof![Just(0.0), -1.0..1.0f64],
            forcing in harmonics(1.5),
            (lower, upper) in walls(),
        ) -> System<f64> {
            let forcing = forcing.into_iter().map(|(k, cos, sin)| Harmonic { k, cos, sin }).collect();
            System { rate: None, damping, stiffness, cubic, force, forcing, smooth: None, lower, upper }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(256))]

        #[test]
        fn nothing_passes_through_a_wall_and_every_impact_closes(system in systems(), q in -0.1..0.1f64, u in -3.0..3.0f64) {
            let settings = Settings { minimum_depth: 1e-10, impact_limit: 500, ..Settings::default() };
            let simulator = Simulator::new(&system, &settings).unwrap();
            let mut run = simulator.start(at(0.5), q, u).unwrap();
            let mut last = run.time();
            let mut next = at(0.5);
            loop {
                // Looked at on a fine grid of times, too, not only at events.
                match run.next(next) {
                    Event::End(RunEnd::Reached) => next = next.after(0.0437),
                    Event::End(_) => break,
                    Event::Impact(impact) => {
                        prop_assert!(impact.velocity <= 0.0 && impact.radius.is_finite());
                        prop_assert!(impact.time >= last);
                        last = impact.time;
                    }
                    _ => {}
                }
                let state = run.state();
                let size = 1.0 + state.q.abs() + state.u.abs();
                for contact in simulator.contacts() {
                    let [z, _] = contact.gap(state);
                    prop_assert!(z > -1.01e-10 - 1e-13 * size, "behind a wall by {:e} at {:?}", -z, run.time());
                }
                if next > at(60.0) {
                    break;
                }
            }
        }

        #[test]
        fn where_one_stops_to_look_changes_nothing(system in systems(), u in -3.0..3.0f64, stop in 0.6..10.0f64) {
            let settings = Settings { impact_limit: 20, ..Settings::default() };
            let simulator = Simulator::new(&system, &settings).unwrap();
            let mut straight = simulator.start(at(0.5), 0.0, u).unwrap();
            let mut stopped = simulator.start(at(0.5), 0.0, u).unwrap();
            let (mut a, mut b) = (Vec::new(), Vec::new());
            straight.record(at(12.0), |event| a.push(event));
            stopped.record(at(stop), |event| b.push(event));
            stopped.record(at(12.0), |event| b.push(event));
            prop_assert_eq!(a.len(), b.len());
            for (a, b) in a.iter().zip(&b) {
                prop_assert!(a.time().unwrap().since(b.time().unwrap()).abs() < 1e-9, "{:?} {:?}", a, b);
            }
        }
    }
}
