//! Stops that give way: closed forms, energy, the rigid limit, a second integrator, grazing.

use grazing_scenes::motion::event::Touch;

use super::{second::Motion, *};
use crate::samples::one_in;
use grazing_scenes::many::SpeedLaw;

fn soft(row: &[f64], offset: f64, stiffness: f64, damping: f64) -> Stop<f64> {
    Stop { law: StopLaw::Soft { stiffness, damping }, ..stop(row, offset, 0.0) }
}

fn law(over: &[f64], under: &[f64]) -> StopLaw<f64> {
    StopLaw::Speed(SpeedLaw { text: "law".into(), over: over.to_vec(), under: under.to_vec() })
}

/// Bounces of a ball whose restitution depends on the speed: each by the law; those left out take the time of
/// the limit at speed 0.
#[test]
fn chatter_ends_with_the_restitution_of_speed_zero() {
    let mut ball = machine(&[&[1.0]], &[&[0.0]], &[&[0.0]]);
    ball.force = vec![-1.0];
    ball.stops = vec![Stop { law: law(&[0.6], &[1.0, 0.5]), ..stop(&[1.0], 0.0, 0.0) }];
    let settings = Settings { minimum_depth: 1e-6, ..Settings::default() };
    let simulator = Simulator::new(&ball, &settings).unwrap();
    let mut run = simulator.start(at(0.0), &[0.5], &[0.0]).unwrap();
    let (mut v, mut time, mut bounces) = (1.0f64, 1.0f64, 0);
    let stick = loop {
        match run.next(Time::new(5, 0.0)) {
            Event::Impact(hit) => {
                assert!((hit.velocity + v).abs() < 1e-12 && (TAU * hit.time.periods() - time).abs() < 1e-12);
                v *= 0.6 / (1.0 + v / 2.0);
                time += 2.0 * v;
                bounces += 1;
            }
            Event::Stick(stick) => break stick,
            event => panic!("{event:?}"),
        }
    };
    // v is that of the first bounce left out; τ = 0.6 from there on.
    let last = time - 2.0 * v;
    assert!(bounces > 5 && v * v < 2e-6, "{bounces} {v}");
    assert!((TAU * stick.time.periods() - (last + 2.0 * v / 0.4)).abs() < 1e-12);
}

/// Beginnings and ends of contact: stop, time, velocity at the beginning.
fn contacts(events: &[Event]) -> Vec<(usize, f64, Option<f64>)> {
    let one = |event: &Event| match event {
        Event::Touch(Touch { time, place, velocity, .. }) => {
            Some((*place, TAU * time.periods(), Some(*velocity)))
        }
        Event::Release(release) => Some((release.place, TAU * release.time.periods(), None)),
        _ => None,
    };
    events.iter().filter_map(one).collect()
}

/// By how much a mass is slower after contact with a stop that lets go where it would pull, alone in the
/// world: z″ = 0 there, at the time t of contact with ω t √(1 − ζ²) = π − 2 asin ζ.
fn restitution(ratio: f64) -> f64 {
    let angle = if ratio < 1.0 {
        2.0 * ratio.acos() / (1.0 - ratio * ratio).sqrt()
    } else if ratio > 1.0 {
        2.0 * ratio.acosh() / (ratio * ratio - 1.0).sqrt()
    } else {
        2.0
    };
    (-ratio * angle).exp()
}

/// The free oscillator between two soft stops moves in pieces of cosines: between them at frequency 1, in
/// contact at √(1 + k) about kg/(1 + k).
#[test]
fn the_bilinear_oscillator_moves_in_pieces_of_cosines() {
    for (gap, k, v) in [(0.5, 3.0, 1.0), (1e-3, 1e4, 2.0), (0.9, 0.02, 1.0), (0.5, 1e8, 1.0)] {
        let (gap, k, v): (f64, f64, f64) = (gap, k, v);
        let mut oscillator = machine(&[&[1.0]], &[&[0.0]], &[&[1.0]]);
        oscillator.stops = vec![soft(&[1.0], -gap, k, 0.0), soft(&[-1.0], -gap, k, 0.0)];
        let (out, omega) = ((gap / v).asin(), (1.0 + k).sqrt());
        let (start, speed) = (gap / (1.0 + k), (v * v - gap * gap).sqrt());
        let contact = 2.0 * (speed / omega).atan2(start) / omega;
        let whole = 4.0 * out + 2.0 * contact;
        let simulator = simulator(&oscillator);
        let rounds = 3;
        let found = contacts(&events(&simulator, (at(0.0), &[0.0], &[v]), at(f64::from(rounds) * whole)));
        assert_eq!(found.len(), 4 * rounds as usize, "{k}");
        let tolerance = 1e-13 * (1.0 + omega);
        for (i, (stop, time, velocity)) in found.iter().enumerate() {
            let half = f64::from(i as u32 / 2) * (2.0 * out + contact);
            let expected = half + out + if i % 2 == 0 { 0.0 } else { contact };
            assert_eq!(*stop, 1 - i / 2 % 2);
            assert!((time - expected).abs() < tolerance, "{k}: {time} {expected}");
            assert!(velocity.is_none_or(|u| (u + speed).abs() < tolerance), "{k}: {velocity:?} {speed}");
        }
    }
}

/// Without damping nothing is lost, not in 10⁴ contacts.
#[test]
fn soft_stops_without_damping_keep_the_energy() {
    let mut chain =
        machine(&[&[1.0, 0.0], &[0.0, 2.0]], &[&[0.0, 0.0], &[0.0, 0.0]], &[&[2.0, -1.0], &[-1.0, 2.0]]);
    let stops = [(&[-1.0, 1.0], -0.2, 30.0), (&[1.0, 0.0], -0.5, 400.0), (&[0.0, -1.0], -0.4, 5.0)];
    chain.stops = stops.iter().map(|(row, offset, k)| soft(*row, *offset, *k, 0.0)).collect();
    let energy = |q: &[f64], u: &[f64]| {
        let elastic = stops.iter().map(|(row, offset, k)| {
            let gap: f64 = row[0] * q[0] + row[1] * q[1] - offset;
            0.5 * k * gap.min(0.0).powi(2)
        });
        let own = 0.5 * (u[0] * u[0] + 2.0 * u[1] * u[1]) + q[0] * q[0] + q[1] * q[1] - q[0] * q[1];
        own + elastic.sum::<f64>()
    };
    let (q, u) = ([0.1, 0.0], [1.5, -0.7]);
    let simulator = simulator(&chain);
    let mut run = simulator.start(at(0.0), &q, &u).unwrap();
    let mut touches = 0;
    while touches < 10_000 {
        run.record(run.time().after(TAU), |event| {
            touches += i32::from(matches!(event, Event::Touch(_)));
        });
    }
    let state = run.state();
    let off = energy(state.q(), state.u()) / energy(&q, &u) - 1.0;
    println!("energy off by {off:e} after {touches} contacts");
    assert!(off.abs() < 1e-10, "{off:e}");
}

/// A mass alone leaves with the velocity of the closed form, whatever the stiffness and the damping.
#[test]
fn contact_ends_where_its_force_would_pull() {
    for k in [1e-6, 1.0, 1e4, 1e8, 1e12] {
        for ratio in [0.0, 1e-3, 0.3, 0.99, 1.0, 1.5, 8.0] {
            let (k, ratio): (f64, f64) = (k, ratio);
            let mut ball = machine(&[&[1.0]], &[&[0.0]], &[&[0.0]]);
            ball.stops = vec![soft(&[1.0], 0.0, k, 2.0 * ratio * k.sqrt())];
            let simulator = simulator(&ball);
            let until = Time::new(0, 0.0).after(1.0 + 20.0 * (1.0 + ratio) / k.sqrt());
            let mut run = simulator.start(at(0.0), &[1.0], &[-1.0]).unwrap();
            let mut told = Vec::new();
            run.record(until, |event| told.push(event));
            let found = contacts(&told);
            assert_eq!(found.len(), 2, "{k} {ratio}: {found:?}");
            let expected = restitution(ratio);
            // A rounding error of the gap is one of √k times as much in velocity.
            let off = (run.state().u()[0] / expected - 1.0).abs();
            assert!(off < 1e-12 + 1e-15 * k.sqrt(), "{k} {ratio}: {off:e}");
        }
    }
}

/// A driven oscillator's motion tends to that with the rigid stop of the closed form's restitution as 1/√k.
#[test]
fn stiff_stops_tend_to_rigid_ones() {
    for ratio in [0.0, 0.2, 0.6] {
        let mut oscillator = machine(&[&[1.0]], &[&[0.1]], &[&[0.3]]);
        oscillator.forcing = vec![Load { k: 1, cos: vec![1.0], sin: vec![0.0] }];
        let until = at(9.0);
        let end = |stop: Stop<f64>| {
            let simulator = simulator(&Machine { stops: vec![stop], ..oscillator.clone() });
            let mut run = simulator.start(at(0.0), &[0.0], &[0.3]).unwrap();
            let mut hits = 0;
            run.record(until, |event| {
                hits += i32::from(matches!(event, Event::Impact(_) | Event::Touch(_)));
            });
            (run.state().q()[0], run.state().u()[0], hits)
        };
        let rigid = end(stop(&[1.0], -0.5, restitution(ratio)));
        let off: Vec<f64> = [1e2f64, 1e4, 1e6, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13]
            .iter()
            .map(|k| {
                let soft = end(soft(&[1.0], -0.5, *k, 2.0 * ratio * k.sqrt()));
                assert_eq!(soft.2, rigid.2, "{ratio} {k}");
                (soft.0 - rigid.0).hypot(soft.1 - rigid.1)
            })
            .collect();
        println!("ratio {ratio}: off by {off:?} after {} contacts", rigid.2);
        assert!(rigid.2 > 0 && off[0] < 1.0 && off[3] < 2e-3, "{off:?}");
        let falls = |two: &[f64], by: f64| (0.7 * by..1.4 * by).contains(&(two[0] / two[1]));
        assert!(off[..4].windows(2).skip(1).all(|two| falls(two, 10.0)), "{off:?}");
        assert!(off[3..].windows(2).all(|two| falls(two, 10f64.sqrt())), "{off:?}");
    }
}

/// At ordinary stiffness the minimum depth moves a motion by about as much as itself, not by the force of a
/// stop that is that deep.
#[test]
fn the_minimum_depth_of_soft_stops_is_a_depth_and_no_force() {
    let mut oscillator = machine(&[&[1.0]], &[&[0.29]], &[&[5.69]]);
    oscillator.forcing = vec![Load { k: 1, cos: vec![1.0], sin: vec![0.0] }];
    oscillator.stops = vec![soft(&[1.0], -0.11, 4e4, 90.0), soft(&[-1.0], -0.1375, 4e4, 60.0)];
    let end = |minimum_depth: f64| {
        let settings = Settings { minimum_depth, ..Settings::default() };
        let simulator = Simulator::new(&oscillator, &settings).unwrap();
        let mut run = simulator.start(at(0.0), &[0.0], &[0.0]).unwrap();
        run.finish(at(2.0 * TAU));
        [run.state().q()[0], run.state().u()[0]]
    };
    let fine = end(1e-13);
    for depth in [1e-11, 1e-10, 1e-9, 1e-8] {
        let found = end(depth);
        let off = (found[0] - fine[0]).hypot(found[1] - fine[1]);
        println!("minimum depth {depth:e}: off by {off:e}");
        assert!(off < 30.0 * depth, "{depth:e}: {off:e}");
    }
}

/// A name, a machine, and its displacements and velocities at the start.
type Case = (&'static str, Machine<f64>, Vec<f64>, Vec<f64>);

/// Machines with several soft stops at once, rigid ones among them, that start free, on a stop, in contact.
fn cases() -> Vec<Case> {
    let load = |cos: &[f64]| vec![Load { k: 1, cos: cos.to_vec(), sin: vec![0.0; cos.len()] }];
    let mut one = machine(&[&[1.0]], &[&[0.05]], &[&[0.4]]);
    one.forcing = load(&[1.0]);
    one.stops = vec![soft(&[1.0], -0.3, 40.0, 1.5), soft(&[-1.0], -0.6, 7.0, 0.0)];
    let mut moving = one.clone();
    moving.stops[0].wall.harmonics = vec![Harmonic { k: 2, cos: 0.1, sin: 0.05 }];
    let mut overdamped = one.clone();
    overdamped.stops = vec![soft(&[1.0], -0.3, 4.0, 30.0)];
    let mut within = one.clone();
    within.stops[0] = soft(&[1.0], 0.4, 40.0, 1.5);
    let mut pair =
        machine(&[&[2.0, 0.3], &[0.3, 0.5]], &[&[0.2, -0.05], &[-0.05, 0.1]], &[&[3.0, -1.0], &[-1.0, 2.0]]);
    pair.forcing = load(&[2.0, -1.0]);
    pair.stops = vec![
        soft(&[-1.0, 1.0], -0.1, 60.0, 0.8),
        soft(&[1.0, 0.0], -0.2, 25.0, 0.5),
        soft(&[0.0, -1.0], -0.3, 90.0, 0.0),
    ];
    let mut mixed = pair.clone();
    mixed.stops[2] = stop(&[0.0, -1.0], -0.3, 0.6);
    let mut by_speed = mixed.clone();
    by_speed.stops[2].law = law(&[0.9, 0.1], &[1.0, 0.5, 0.05]);
    // Both rigid: as long as it rests on neither, which the second integrator would not follow.
    let mut two_laws = by_speed.clone();
    two_laws.stops[1] = stop(&[1.0, 0.0], -0.2, 0.6);
    two_laws.stops[1].law = law(&[0.9, 0.1], &[1.0, 0.5, 0.05]);
    let mut gyroscopic = pair.clone();
    gyroscopic.damping.extend([(0, 1, 0.6), (1, 0, -0.6)]);
    vec![
        ("two stops", one.clone(), vec![0.0], vec![0.0]),
        ("a stop touched at first", one.clone(), vec![-0.3], vec![0.0]),
        ("a stop hit at first", one.clone(), vec![-0.3], vec![-1.0]),
        ("a moving stop", moving, vec![0.0], vec![0.1]),
        ("overdamped contact", overdamped, vec![0.0], vec![0.0]),
        ("in contact at first", within, vec![0.0], vec![0.0]),
        ("a pair with three stops", pair, vec![0.0, 0.0], vec![0.2, 0.0]),
        ("soft and rigid stops", mixed, vec![0.0, 0.0], vec![0.2, 0.0]),
        ("restitution by the speed", by_speed, vec![0.0, 0.0], vec![0.2, 0.0]),
        ("two rigid stops with laws", two_laws, vec![0.0, 0.0], vec![0.2, 0.0]),
        ("gyroscopic", gyroscopic, vec![0.0, 0.0], vec![0.2, 0.1]),
    ]
}

/// Every beginning and end of contact, and the state at the end, to 10⁻¹² times the amplification.
#[test]
fn soft_contacts_agree_with_a_second_integrator() {
    let mut together = 0;
    for (name, machine, q, u) in cases().into_iter().step_by(one_in(3)) {
        let until = 2.0 * TAU;
        let simulator = simulator(&machine);
        let mut run = simulator.start(at(0.0), &q, &u).unwrap();
        let mut told = Vec::new();
        run.record(Time::new(2, 0.0), |event| told.push(event));
        let mut found = contacts(&told);
        found.retain(|one| matches!(machine.stops[one.0].law, StopLaw::Soft { .. }));
        let follow = |nudge: f64| {
            let q: Vec<f64> = q.iter().map(|q| q + nudge).collect();
            let mut motion = Motion::new(&machine, &q, &u);
            let hits = motion.follow(until);
            (motion, hits)
        };
        let (motion, hits) = follow(0.0);
        let (near, _) = follow(1e-8);
        let growth = (0..q.len()).fold(1.0f64, |most, i| {
            most.max((near.q[i] - motion.q[i]).abs().max((near.u[i] - motion.u[i]).abs()) / 1e-8)
        });
        assert_eq!(found.len(), motion.contacts.len(), "{name}: {found:?} {:?}", motion.contacts);
        // Of chatter each leaves out what is slow to it.
        let fast = |event: &&Event| matches!(event, Event::Impact(hit) if hit.velocity < -1e-4);
        let impacts = told.iter().filter(fast).count();
        assert_eq!(impacts, hits.iter().filter(|hit| hit.2 < -1e-4).count(), "{name}");
        let bound = 1e-12 * growth.max(1.0) + 1e-12;
        for (one, (stop, time, rate, begins)) in found.iter().zip(&motion.contacts) {
            assert_eq!((one.0, one.2.is_some()), (*stop, *begins), "{name}");
            // A force that falls slowly to 0 tells its time less well.
            assert!((one.1 - time).abs() < 30.0 * bound, "{name}: {one:?} {time}");
            assert!(one.2.is_none_or(|velocity| (velocity - rate).abs() < 10.0 * bound), "{name}");
        }
        let state = run.state();
        let off = (0..q.len()).fold(0.0f64, |most, i| {
            most.max((state.q()[i] - motion.q[i]).abs()).max((state.u()[i] - motion.u[i]).abs())
        });
        println!(
            "{name}: {} contacts, {impacts} impacts, off by {off:.1e}, amplified {growth:.1e}",
            found.len()
        );
        assert!(off < bound, "{name}: {off:e}, amplified {growth:e}");
        let mut open = 0;
        for one in &found {
            open += if one.2.is_some() { 1 } else { -1 };
            together += i32::from(open > 1);
        }
    }
    assert!(together > 0, "some contact begins during another's");
}

/// Pressed into a stop by its weight a mass stays where it is; dropped, it comes to rest there.
#[test]
fn a_mass_rests_where_the_stop_carries_it() {
    for k in [1e-3, 10.0, 1e6, 1e12] {
        let mut heavy = machine(&[&[1.0]], &[&[0.0]], &[&[0.0]]);
        heavy.force = vec![-2.0];
        heavy.stops = vec![soft(&[1.0], 0.0, k, 2.0 * 0.4 * f64::sqrt(k))];
        let simulator = simulator(&heavy);
        let mut run = simulator.start(at(0.0), &[-2.0 / k], &[0.0]).unwrap();
        let end = run.record(Time::new(20, 0.0), |event| panic!("{k}: {event:?}"));
        assert_eq!((end, run.pushing()), (RunEnd::Reached, &[0usize][..]));
        assert!((run.state().q()[0] * k + 2.0).abs() < 1e-9, "{k}");
        if k < 1.0 {
            continue;
        }
        let mut run = simulator.start(at(0.0), &[0.1], &[0.0]).unwrap();
        let mut told = 0;
        run.record(Time::new(20, 0.0), |_| told += 1);
        assert!(told > 0 && (run.state().q()[0] + 2.0 / k).abs() < 1e-11, "{k}: {told} {:?}", run.state());
    }
}

/// A stop too weak to matter changes nothing but is told.
#[test]
fn a_weak_stop_is_felt_as_little_as_it_pushes() {
    let mut free = machine(&[&[1.0]], &[&[0.1]], &[&[0.5]]);
    free.forcing = vec![Load { k: 1, cos: vec![1.0], sin: vec![0.0] }];
    let weak = Machine { stops: vec![soft(&[1.0], -0.2, 1e-12, 1e-13)], ..free.clone() };
    let end = |machine: &Machine<f64>| {
        let simulator = simulator(machine);
        let mut run = simulator.start(at(0.0), &[0.0], &[0.0]).unwrap();
        let mut touches = 0;
        run.record(Time::new(3, 0.0), |event| touches += i32::from(matches!(event, Event::Touch(_))));
        (run.state(), touches)
    };
    let ((weak, touches), (free, _)) = (end(&weak), end(&free));
    assert!(touches > 0 && (weak.q()[0] - free.q()[0]).abs() < 1e-11);
}

/// A gap that dips to −d twice a period is met for every d above the minimum depth, with the speed √(2d).
#[test]
fn contacts_of_any_depth_are_found() {
    for damping in [0.0, 0.5] {
        for depth in [1e-2, 1e-4, 1e-6, 1e-9, 1e-11, 4e-12] {
            let mut near = machine(&[&[1.0]], &[&[0.0]], &[&[0.0]]);
            near.stops = vec![soft(&[1.0], 0.0, 1.0, damping)];
            near.stops[0].wall.harmonics = vec![Harmonic { k: 1, cos: 1.0, sin: 0.0 }];
            // The mass stands still; the stop comes to it.
            let simulator = simulator(&near);
            let found = contacts(&events(&simulator, (at(1.0), &[1.0 - depth], &[0.0]), at(TAU + 1.0)));
            assert_eq!(found.len(), 2, "{damping} {depth}: {found:?}");
            let speed = found[0].2.unwrap().abs();
            let rounding = 1e-15 / depth;
            assert!(
                (speed / f64::sqrt(2.0 * depth) - 1.0).abs() < depth + rounding,
                "{damping} {depth}: {speed}"
            );
        }
    }
}

/// What a shallow contact changes goes with the power 3/2 of its depth, with damping with the power 1.
#[test]
fn shallow_contacts_change_a_motion_by_a_power_of_their_depth() {
    for (damping, power) in [(0.0, 1.5), (0.7, 1.0)] {
        let change = |depth: f64| {
            let mut near = machine(&[&[1.0]], &[&[0.0]], &[&[0.0]]);
            near.stops = vec![soft(&[1.0], 0.0, 1.0, damping)];
            near.stops[0].wall.harmonics = vec![Harmonic { k: 1, cos: 1.0, sin: 0.0 }];
            let simulator = simulator(&near);
            let mut run = simulator.start(at(1.0), &[1.0 - depth], &[0.0]).unwrap();
            run.finish(at(TAU + 1.0));
            run.state().u()[0]
        };
        let [deep, shallow] = [change(1e-5), change(1e-7)];
        let found = (deep / shallow).log10() / 2.0;
        assert!((found - power).abs() < 0.01, "{damping}: {found}");
    }
}
