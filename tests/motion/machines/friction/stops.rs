//! Friction under the force of a stop: at impacts, at rest, in contact.

use crate::samples::samples;
use std::collections::BTreeMap;

use grazing_scenes::many::{Friction, Load, Machine, NormalForce, StopLaw};

use super::{super::*, friction, numbers, pressed::Pressed, scene};

/// Friction along a row on a stop.
fn on(stop: usize, row: &[f64], [coefficient, static_coefficient]: [f64; 2]) -> Friction<f64> {
    Friction { normal: NormalForce::Stop { stop }, ..friction(row, 1.0, [coefficient, static_coefficient]) }
}

/// What happened but for when rest on a stop begins, by its word, place and time in radians.
fn told(events: &[Event], stops: usize) -> Vec<(&'static str, usize, f64)> {
    let one = |event: &Event| {
        let word = match event {
            Event::Stick(stick) if stick.place < stops => return None,
            Event::Stick(_) => "stick",
            Event::Release(_) => "release",
            Event::Reversal(_) => "reversal",
            Event::Impact(_) => "impact",
            Event::Touch(_) => "touch",
            _ => return None,
        };
        Some((word, event.place()?, TAU * event.time()?.periods()))
    };
    events.iter().filter_map(one).collect()
}

/// A mass of 2 thrown along a floor: q = (x, y), g = 8.
fn thrown(restitution: f64, coefficients: [f64; 2]) -> Machine<f64> {
    let mut thrown = machine(&[&[2.0, 0.0], &[0.0, 2.0]], &[], &[]);
    thrown.force = vec![0.0, -16.0];
    thrown.stops = vec![stop(&[0.0, 1.0], 0.0, restitution)];
    thrown.friction = vec![on(0, &[1.0, 0.0], coefficients)];
    thrown
}

/// Each impact at speed V takes μ(1 + τ)V of the velocity along the floor until there is none; what is left
/// when the bounces are over slides v²/(2μg) far.
#[test]
fn a_thrown_mass_slows_down_at_every_impact() {
    let (tau, mu, g) = (0.5, 0.1, 8.0);
    let thrown = thrown(tau, [mu, mu]);
    let simulator = simulator(&thrown);
    let mut run = simulator.start(at(0.0), &[0.0, 0.5], &[3.0, 0.0]).unwrap();
    // The first fall takes (2y/g)^(1/2), at speed (2yg)^(1/2).
    let (mut time, mut speed) = ((1.0f64 / g).sqrt(), g.sqrt());
    let (mut x, mut along) = (3.0 * time, 3.0);
    for i in 0..12 {
        let event = run.next(Time::new(5, 0.0));
        let Event::Impact(impact) = event else { panic!("{event:?}") };
        // What rounding leaves of the gap over the speed.
        assert!((TAU * impact.time.periods() - time).abs() < 1e-14 / speed, "{i}");
        along -= mu * (1.0 + tau) * speed;
        speed *= tau;
        assert!((run.state().u()[0] - along).abs() < 1e-11, "{i}: {} {along}", run.state().u()[0]);
        assert!((run.state().q()[0] - x).abs() < 1e-11, "{i}");
        time += 2.0 * speed / g;
        x += along * 2.0 * speed / g;
    }
    // Σ V over all impacts is V₀/(1 − τ), the time of all bounces 2V₀τ/(g(1 − τ)).
    let rest = run.next(Time::new(5, 0.0));
    let words: Vec<Event> = std::iter::successors(Some(rest), |_| Some(run.next(Time::new(5, 0.0))))
        .take_while(|event| !matches!(event, Event::End(_)))
        .collect();
    let v0 = g.sqrt();
    let left = 3.0 - mu * (1.0 + tau) * v0 / (1.0 - tau);
    let begins = (1.0f64 / g).sqrt() + 2.0 * v0 * tau / (g * (1.0 - tau));
    let stops = begins + left / (mu * g);
    let last = told(&words, 1);
    assert_eq!(last.last().map(|one| (one.0, one.1)), Some(("stick", 1)), "{words:?}");
    assert!((last[last.len() - 1].2 - stops).abs() < 1e-9, "{last:?} {stops}");
    assert!(run.state().u().iter().all(|u| u.abs() < 1e-12));
    // How far it came: by flights, each with its own velocity, then sliding.
    let mut wanted = 3.0 * (1.0f64 / g).sqrt();
    let (mut v, mut u) = (v0, 3.0);
    for _ in 0..80 {
        u -= mu * (1.0 + tau) * v;
        v *= tau;
        wanted += u * 2.0 * v / g;
    }
    wanted += left * left / (2.0 * mu * g);
    assert!((run.state().q()[0] - wanted).abs() < 1e-9, "{} {wanted}", run.state().q()[0]);
}

/// A rod that strikes a rough floor at an angle: the impulses as in the plane dynamics of rigid bodies.
#[test]
fn an_eccentric_impact_sticks_or_slides() {
    // A rod of mass 1 and length 2 at angle θ to the floor, about its middle: moment of inertia 1/3, the tip
    // at (−cos θ, −sin θ): with small rotations its velocity is (u + ω sin θ, v − ω cos θ).
    let (sin, cos) = (1.0f64).sin_cos();
    let mut slid = [false; 2];
    for (mu, u) in [(0.05, 1.0), (0.3, 1.0), (0.9, 0.2), (0.3, -0.4), (2.0, 0.1)] {
        let mut rod = machine(&[&[1.0, 0.0, 0.0], &[0.0, 1.0, 0.0], &[0.0, 0.0, 1.0 / 3.0]], &[], &[]);
        rod.stops = vec![stop(&[0.0, 1.0, -cos], 0.0, 0.4)];
        rod.friction = vec![on(0, &[1.0, 0.0, sin], [mu, mu])];
        let simulator = simulator(&rod);
        let mut run = simulator.start(at(0.0), &[0.0, 0.5, 0.0], &[u, -1.0, 0.0]).unwrap();
        let event = run.next(Time::new(5, 0.0));
        let Event::Impact(impact) = event else { panic!("{event:?}") };
        assert!((impact.velocity + 1.0).abs() < 1e-12);
        // Inverse masses of the tip.
        let (nn, tt, nt) = (1.0 + 3.0 * cos * cos, 1.0 + 3.0 * sin * sin, -3.0 * sin * cos);
        let stuck = {
            // w⁺ = 0.4, v_t⁺ = 0.
            let (a, b) = (1.4, -u);
            let det = nn * tt - nt * nt;
            [(tt * a - nt * b) / det, (nn * b - nt * a) / det]
        };
        let sticks = stuck[1].abs() <= mu * stuck[0];
        let [p, f] = if sticks {
            stuck
        } else {
            // It slides on, or back.
            let ways = [1.0, -1.0].map(|way| {
                let p = 1.4 / (nn - way * mu * nt);
                (way, [p, -way * mu * p])
            });
            let fits = |(way, [p, f]): &(f64, [f64; 2])| *p > 0.0 && way * (u + nt * p + tt * f) >= 0.0;
            ways.into_iter().find(fits).unwrap().1
        };
        slid[usize::from(sticks)] = true;
        let wanted = [u + f, -1.0 + p, 3.0 * (-cos * p + sin * f)];
        let off = apart(run.state().u(), &wanted);
        assert!(off < 1e-12, "{mu} {u}: {:?} {wanted:?}", run.state().u());
    }
    assert_eq!(slid, [true; 2]);
}

/// A mass pressed onto a spring stop and pulled along it: N oscillates about mg, and the mass slides where
/// the pull is more than μN.
#[test]
fn friction_follows_the_force_of_a_compliant_stop() {
    let (k, g, mu) = (90.0, 10.0, 0.4);
    let mut pressed = machine(&[&[1.0, 0.0], &[0.0, 1.0]], &[], &[]);
    pressed.force = vec![0.0, -g];
    pressed.stops =
        vec![Stop { law: StopLaw::Soft { stiffness: k, damping: 0.0 }, ..stop(&[0.0, 1.0], 0.0, 0.0) }];
    pressed.friction = vec![on(0, &[1.0, 0.0], [mu, mu])];
    let simulator = simulator(&pressed);
    // y = −g/k + a cos ωt, N = g − k a cos ωt > 0.
    let (a, omega, u) = (0.05, k.sqrt(), 5.0);
    let mut run = simulator.start(at(0.0), &[0.0, -g / k + a], &[u, 0.0]).unwrap();
    for t in [0.2, 0.5, 0.9, 1.2] {
        run.finish(at(t));
        let wanted = u - mu * (g * t - k * a * (omega * t).sin() / omega);
        assert!((run.state().u()[0] - wanted).abs() < 1e-12, "{t}: {} {wanted}", run.state().u()[0]);
    }
    assert!((run.state().q()[1] - (-g / k + a * (omega * 1.2).cos())).abs() < 1e-13);
}

/// On an incline a mass at rest stays where tan α ≤ μ_s, and else slides with g(sin α − μ_k cos α).
#[test]
fn a_mass_on_an_incline_stays_or_slides() {
    let g = 9.81;
    for (alpha, stays) in [(0.3f64, true), (0.4, false)] {
        let mut block = machine(&[&[1.0, 0.0], &[0.0, 1.0]], &[], &[]);
        block.force = vec![g * alpha.sin(), -g * alpha.cos()];
        block.stops = vec![stop(&[0.0, 1.0], 0.0, 0.0)];
        let (kinetic, holding) = (0.2, (0.35f64).tan());
        block.friction = vec![on(0, &[1.0, 0.0], [kinetic, holding])];
        let simulator = simulator(&block);
        let mut run = simulator.start(at(0.0), &[0.0, 0.0], &[0.0, 0.0]).unwrap();
        run.finish(at(2.0));
        let bend = if stays { 0.0 } else { g * (alpha.sin() - kinetic * alpha.cos()) };
        assert!(apart(run.state().q(), &[2.0 * bend, 0.0]) < 1e-12, "{alpha}: {:?}", run.state());
    }
}

/// Painlevé's rod: a slender rod that slides with μ above 4/3 has positions in which the floor would have to
/// pull; the run ends and says so.
#[test]
fn painleve_s_paradox_ends_the_run() {
    let (sin, cos) = (1.0f64).sin_cos();
    let rod = |mu: f64| {
        let mut rod = machine(&[&[1.0, 0.0, 0.0], &[0.0, 1.0, 0.0], &[0.0, 0.0, 1.0 / 3.0]], &[], &[]);
        rod.force = vec![0.0, -1.0, 0.0];
        rod.stops = vec![stop(&[0.0, 1.0, -cos], 0.0, 0.0)];
        rod.friction = vec![on(0, &[1.0, 0.0, sin], [mu, mu])];
        rod
    };
    // w M⁻¹(w − σμt) = 1 + 3cos² + 3σμ sin cos changes its sign with σ = −1.
    let critical = (1.0 + 3.0 * cos * cos) / (3.0 * sin * cos);
    for (mu, ends) in [(0.9 * critical, false), (1.1 * critical, true)] {
        let rod = rod(mu);
        let simulator = simulator(&rod);
        let start = simulator.start(at(0.0), &[0.0; 3], &[-1.0, 0.0, 0.0]);
        match start {
            Ok(mut run) => {
                run.finish(at(0.01));
                let failure = run.failure().map(|error| error.to_string());
                assert_eq!(failure.is_some(), ends, "{mu}: {failure:?}");
                assert!(failure.is_none_or(|text| text.contains("Painlevé")));
            }
            Err(error) => assert!(ends && error.to_string().contains("Painlevé"), "{mu}: {error}"),
        }
    }
}

/// The same by matrices and by formulas, and mirrored; in units that are powers of two to the last bit.
#[test]
fn friction_on_stops_in_other_forms_is_the_same() {
    let mut base =
        machine(&[&[1.0, 0.2], &[0.2, 0.8]], &[&[0.1, 0.0], &[0.0, 0.1]], &[&[2.0, 0.3], &[0.3, 0.5]]);
    base.force = vec![0.1, -1.5];
    base.forcing = vec![Load { k: 1, cos: vec![1.2, 1.3], sin: vec![-0.3, 0.6] }];
    let soft = StopLaw::Soft { stiffness: 30.0, damping: 0.5 };
    let pad = Stop { name: "pad".into(), law: soft, ..stop(&[-1.0, 0.0], -0.5, 0.0) };
    base.stops = vec![stop(&[0.0, 1.0], 0.0, 0.3), pad];
    base.friction = vec![on(0, &[1.0, 0.0], [0.3, 0.4]), on(1, &[0.2, 1.0], [0.2, 0.2])];
    base.friction[1].name = "on the pad".into();
    base.friction[0].speed = 0.05;
    let (q, u) = ([0.1, 0.3], [0.2, -0.1]);
    let asked = |machine: &Machine<f64>, q: &[f64], u: &[f64]| {
        let simulator = Simulator::suited(machine, None, &[State::new(0.0, q, u)]).unwrap();
        let mut run = simulator.start(at(0.0), q, u).unwrap();
        let mut all = Vec::new();
        assert_eq!(run.record(at(5.0 * TAU), |event| all.push(event)), RunEnd::Reached);
        (told(&all, 0), [run.state().q(), run.state().u()].concat())
    };
    let known = asked(&base, &q, &u);
    let near = |found: &(Vec<(&'static str, usize, f64)>, Vec<f64>), state: &[f64]| {
        let words =
            |all: &[(&'static str, usize, f64)]| all.iter().map(|one| (one.0, one.1)).collect::<Vec<_>>();
        assert_eq!(words(&found.0), words(&known.0));
        assert!(apart(&found.1, state) < 1e-8, "{:?} {state:?}", found.1);
    };
    let words: BTreeMap<&str, usize> = known.0.iter().map(|one| (one.0, one.1)).collect();
    assert!(words.len() == 5 || (words.len() == 4 && known.0.len() > 40), "{words:?}");
    for factor in [2f64.powi(30), 2f64.powi(-30), -1.0] {
        let (mut form, size) = (base.clone(), factor.abs());
        form.force.iter_mut().for_each(|x| *x *= factor);
        let Load { cos, sin, .. } = &mut form.forcing[0];
        cos.iter_mut().chain(sin).for_each(|x| *x *= factor);
        for rub in &mut form.friction {
            rub.row.iter_mut().for_each(|x| *x *= factor.signum());
            rub.speed *= size;
        }
        for stop in &mut form.stops {
            stop.row.iter_mut().for_each(|x| *x *= factor.signum());
            stop.wall.offset *= size;
        }
        let found = asked(&form, &q.map(|x| x * factor), &u.map(|x| x * factor));
        if factor < 0.0 {
            near(&found, &known.1.iter().map(|x| -x).collect::<Vec<_>>());
            continue;
        }
        assert_eq!(found.0, known.0, "{factor}");
        found.1.iter().zip(&known.1).for_each(|(a, b)| assert_eq!(*a, b * factor, "{factor}"));
    }
    let text = "mass = [[1, 0.2], [0.2, 0.8]]\nperiod = \"2*pi\"\nforce = [\"0.1 - 0.1*u1 - 2*q1 - 0.3*q2 + 1.2*cos(t) - \
                0.3*sin(t) + 0*exp(q1)\", \"-1.5 - 0.1*u2 - 0.3*q1 - 0.5*q2 + 1.3*cos(t) + 0.6*sin(t)\"]\n";
    let rest = "[[stops]]\nname = \"floor\"\nrow = [0, 1]\noffset = 0\nrestitution = 0.3\n[[stops]]\nname = \"pad\"\n\
                row = [-1, 0]\noffset = -0.5\nstiffness = 30\ndamping = 0.5\n[[friction]]\nname = \"a\"\nrow = [1, 0]\n\
                stop = \"floor\"\ncoefficient = 0.3\nstatic_coefficient = 0.4\nspeed = 0.05\n[[friction]]\nname = \"b\"\n\
                row = [0.2, 1]\nstop = \"pad\"\ncoefficient = 0.2\n";
    let smooth = scene(text, rest).machine(&[]).unwrap();
    assert!(smooth.is_smooth());
    near(&asked(&smooth, &q, &u), &known.1);
}

/// What a thrown mass has is taken by impacts, by the friction in them, and by that at rest, also where the
/// floor gives way; a scene says so, and where its keys are wrong.
#[test]
fn the_energy_on_stops_is_accounted_for() {
    use grazing_scenes::run::{Findings, Surroundings, run};
    let system = "period = 1\nmass = [[2, 0], [0, 2]]\nforce = [0, -16]\n";
    let rigid = "restitution = 0.5\n";
    let soft = "stiffness = 400\ndamping = 12\n";
    let tasks = "[[tasks]]\nname = \"thrown\"\nkind = \"simulate\"\nstart = { q = [0, 0.5], u = [3, 0] }\nperiods = 12\n";
    for law in [rigid, soft] {
        let rest = format!(
            "[[stops]]\nname = \"floor\"\nrow = [0, 1]\noffset = 0\n{law}[[friction]]\nrow = [1, 0]\nstop = \"floor\"\n\
             coefficient = 0.1\nstatic_coefficient = 0.2\n{tasks}"
        );
        let reports = run(&scene(system, &rest), Surroundings::default(), &mut ()).unwrap();
        let Some(Findings::Simulation(found)) = &reports[0].findings else { panic!("{}", reports[0].status) };
        let found = serde_json::to_value(found).unwrap();
        let taken = |key: &str| found[key][0]["dissipated"].as_f64().unwrap();
        // Into the floor that gives way it sinks by 16/400, and the spring holds half of what that gives.
        let lost = if law == rigid { 17.0 } else { 17.0 + 0.5 * 16.0 * 16.0 / 400.0 };
        let off = taken("stops") + taken("friction") - lost;
        // The bounces that end in rest are not followed one by one.
        assert!(
            off.abs() < if law == rigid { 1e-5 } else { 1e-9 },
            "{law}: {off:e}, {} {}",
            found["stops"],
            found["friction"]
        );
        assert_eq!(found["friction"][0]["at_end"], "sticks for ever", "{}", found["friction"]);
        assert!(taken("friction") > 0.5);
    }
    for (keys, wanted) in [
        ("stop = \"flor\"\n", vec!["friction[1].stop", "\"flor\"", "nearest is \"floor\""]),
        ("", vec!["neither `normal` nor `stop`"]),
        ("normal = 1\nstop = \"floor\"\n", vec!["has `normal` and `stop`"]),
    ] {
        let text = format!(
            "format = \"grazing-scene 3\"\ntitle = \"wrong\"\n[system]\n{system}[[stops]]\nname = \"floor\"\nrow = [0, 1]\n\
             offset = 0\nrestitution = 0\n[[friction]]\nrow = [1, 0]\ncoefficient = 0.1\n{keys}"
        );
        let error = Scene::from_toml(&text, "wrong.toml").unwrap_err().to_string();
        wanted.iter().for_each(|part| assert!(error.contains(part), "{error}"));
    }
    let along = "[[stops]]\nname = \"floor\"\nrow = [0, 1]\noffset = 0\nrestitution = 0\n[[friction]]\nrow = [0, -2]\n\
                 stop = \"floor\"\ncoefficient = 0.1\n";
    let text = format!("format = \"grazing-scene 3\"\ntitle = \"wrong\"\n[system]\n{system}{along}");
    let error = Scene::from_toml(&text, "wrong.toml").unwrap_err().to_string();
    assert!(error.contains("friction[1].row") && error.contains("moves across its gap"), "{error}");
}

/// A body on two feet slides as a mass under its whole weight, however the weight and the friction are shared
/// between the feet, whose velocities along the floor are one.
#[test]
fn a_body_on_two_feet_is_one_mass() {
    for (height, amplitude) in [(0.0, 6.0), (0.4, 6.0), (-0.3, 4.5), (0.4, 2.5)] {
        let (g, mu) = (9.81, 0.3);
        let mut body = machine(&[&[1.0, 0.0, 0.0], &[0.0, 1.0, 0.0], &[0.0, 0.0, 0.5]], &[], &[]);
        body.force = vec![0.0, -g, 0.0];
        body.forcing =
            vec![Load { k: 1, cos: vec![amplitude, 0.0, -height * amplitude], sin: vec![0.3, 0.0, 0.0] }];
        body.stops = vec![stop(&[0.0, 1.0, -1.0], 0.0, 0.0), stop(&[0.0, 1.0, 1.0], 0.0, 0.0)];
        body.stops[1].name = "right".into();
        // The feet are 0.5 below the middle.
        body.friction = vec![on(0, &[1.0, 0.0, 0.5], [mu, mu]), on(1, &[1.0, 0.0, 0.5], [mu, mu])];
        body.friction[1].name = "other".into();
        let mut mass = machine(&[&[1.0]], &[], &[]);
        mass.forcing = vec![Load { k: 1, cos: vec![amplitude], sin: vec![0.3] }];
        mass.friction = vec![friction(&[1.0], g, [mu, mu])];
        let (body, mass) = (simulator(&body), simulator(&mass));
        let mut run = body.start(at(0.0), &[0.0; 3], &[0.8, 0.0, 0.0]).unwrap();
        let mut other = mass.start(at(0.0), &[0.0], &[0.8]).unwrap();
        for i in 1..60 {
            let until = at(0.3 * f64::from(i));
            assert_eq!(run.finish(until), RunEnd::Reached, "{height}: {:?}", run.failure());
            other.finish(until);
            let off = apart(&run.state().q()[..1], other.state().q());
            let rate = apart(&run.state().u()[..1], other.state().u());
            assert!(off < 1e-10 && rate < 1e-10, "{height} {amplitude} {i}: {off:e} {rate:e}");
            assert!(apart(&run.state().q()[1..], &[0.0, 0.0]) < 1e-11);
        }
    }
}

/// Two rows along one stop, or under given forces, that cannot but move together are one: nothing turns back
/// while they stick, and both do.
#[test]
fn rows_that_move_together_stick_together() {
    let mut block = machine(&[&[1.0, 0.2], &[0.2, 1.0]], &[], &[]);
    block.force = vec![0.0, -10.0];
    block.forcing = vec![Load { k: 1, cos: vec![6.0, 1.0], sin: vec![0.0, 0.0] }];
    block.stops = vec![stop(&[0.0, 1.0], 0.0, 0.0)];
    let given = |coefficient: f64| friction(&[1.0, 0.0], 10.0, [coefficient, coefficient]);
    for under in [true, false] {
        let rub =
            |coefficient: f64| if under { on(0, &[1.0, 0.0], [coefficient; 2]) } else { given(coefficient) };
        let told = |rubs: &[Friction<f64>]| {
            let mut one = block.clone();
            one.friction = rubs.to_vec();
            one.friction.iter_mut().enumerate().for_each(|(j, rub)| rub.name = format!("rub {j}"));
            let simulator = simulator(&one);
            let mut run = simulator.start(at(0.0), &[0.0, 0.0], &[0.5, 0.0]).unwrap();
            let mut all = Vec::new();
            assert_eq!(run.record(at(5.0 * TAU), |event| all.push(event)), RunEnd::Reached);
            (told(&all, 0), [run.state().q(), run.state().u()].concat())
        };
        let (alone, both) = (told(&[rub(0.5)]), told(&[rub(0.3), rub(0.2)]));
        assert!(apart(&alone.1, &both.1) < 1e-10, "{under}: {alone:?} {both:?}");
        assert!(alone.0.iter().filter(|one| one.0 == "stick").count() > 4, "{alone:?}");
        // What one does, both do, at the same time.
        let of = |row: usize| -> Vec<(&str, f64)> {
            both.0.iter().filter(|one| one.1 == row).map(|one| (one.0, one.2)).collect()
        };
        let wanted: Vec<(&str, f64)> =
            alone.0.iter().filter(|one| one.1 == 1).map(|one| (one.0, one.2)).collect();
        for row in [1, 2] {
            assert_eq!(of(row).len(), wanted.len(), "{under} {row}: {:?} {wanted:?}", of(row));
            for (one, known) in of(row).iter().zip(&wanted) {
                assert!(one.0 == known.0 && (one.1 - known.1).abs() < 1e-9, "{under}: {one:?} {known:?}");
            }
        }
    }
}

/// Random machines on a floor and a pad with friction on both, against the second solver.
#[test]
fn random_machines_agree_with_a_second_solver() {
    let trials: u32 = samples(1);
    let mut words: BTreeMap<&str, u32> = BTreeMap::new();
    let (mut worst, mut apart_by) = (0.0f64, 0.0f64);
    let mut random = numbers(0x9e37_79b9_7f4a_7c15);
    for trial in 0..trials {
        let mut between = |low: f64, high: f64| random(low, high);
        let mixed = between(-0.25, 0.25);
        let (first, second) = (between(0.8, 1.5), between(0.8, 1.5));
        let third = between(-0.2, 0.2);
        let mass: [&[f64]; 3] = [&[first, mixed, 0.1], &[mixed, second, third], &[0.1, third, 1.1]];
        let mut rough = machine(&mass, &[], &[]);
        rough.stiffness = vec![(0, 0, between(0.5, 4.0)), (1, 1, between(0.0, 1.0)), (2, 2, 2.0)];
        rough.damping = vec![(0, 0, between(0.0, 0.2)), (1, 1, between(0.0, 0.2)), (2, 2, 0.1)];
        rough.force = vec![between(-0.3, 0.3), -between(0.5, 3.0), 0.0];
        rough.forcing = vec![Load {
            k: 1,
            cos: vec![between(0.2, 2.0), between(-2.5, 2.5), 0.7],
            sin: vec![between(-0.5, 0.5), between(-1.0, 1.0), -0.4],
        }];
        let floor = match trial % 3 {
            0 => StopLaw::Soft { stiffness: between(20.0, 80.0), damping: between(0.0, 1.5) },
            _ => StopLaw::Newton,
        };
        let tau = if trial % 3 == 1 { 0.0 } else { between(0.1, 0.6) };
        rough.stops = vec![Stop { law: floor, ..stop(&[0.0, 1.0, 0.0], 0.0, tau) }];
        if trial % 4 == 3 {
            let law = StopLaw::Soft { stiffness: between(10.0, 40.0), damping: between(0.0, 1.0) };
            rough.stops.push(Stop {
                name: "pad".into(),
                law,
                ..stop(&[-1.0, 0.0, 0.0], -between(0.2, 0.8), 0.0)
            });
            let mu = between(0.05, 0.3);
            rough.friction.push(on(1, &[0.0, 0.0, 1.0], [mu, mu]));
        }
        if trial % 5 == 0 && trial % 4 != 3 {
            let mu = between(0.05, 0.4);
            rough.friction.push(on(0, &[0.0, 0.0, 1.0], [mu, mu]));
        }
        let (mu, more) = (between(0.05, 0.6), between(0.0, 0.3));
        let speed = if trial % 2 == 0 { 0.0 } else { between(-0.3, 0.3) };
        rough.friction.push(Friction { speed, ..on(0, &[1.0, 0.0, 0.0], [mu, mu + more]) });
        for (j, friction) in rough.friction.iter_mut().enumerate() {
            friction.name = format!("rub {j}");
        }
        let (q, u) =
            ([between(-0.2, 0.2), between(0.05, 0.6), 0.1], [between(-0.6, 0.6), between(-0.5, 0.5), 0.2]);
        let (simulator, stops) = (simulator(&rough), rough.stops.len());
        let until = 5.0 * TAU;
        let all = events(&simulator, (at(0.0), &q, &u), at(until));
        let found = told(&all, stops);
        let rested = all.iter().filter(|event| matches!(event, Event::Stick(stick) if stick.place < stops));
        let mut other = Pressed::new(&rough, &q, &u);
        let mut expected = other.follow(until);
        // What comes to rest on a stop with friction sticks there, too, or slides on: that is among the rest.
        assert_eq!(rested.count(), other.rests, "{trial}");
        *words.entry("rest").or_default() += other.rests as u32;
        let mut found = found;
        for all in [&mut found, &mut expected] {
            // What happens at one instant is told in the order of rows.
            for i in 1..all.len() {
                if all[i].2 - all[i - 1].2 < 1e-12 && all[i].1 < all[i - 1].1 && all[i].0 == all[i - 1].0 {
                    all.swap(i - 1, i);
                }
            }
        }
        let short = |all: &[(&str, usize, f64)]| format!("{:?}", &all[..all.len().min(60)]);
        assert_eq!(
            found.iter().map(|one| (one.0, one.1)).collect::<Vec<_>>(),
            expected.iter().map(|one| (one.0, one.1)).collect::<Vec<_>>(),
            "{trial}: {}\n{}",
            short(&found),
            short(&expected)
        );
        for (one, known) in found.iter().zip(&expected) {
            // A slow impact divides by its speed what rounding leaves of the motion.
            assert!((one.2 - known.2).abs() < 1e-7, "{trial}: {one:?} {known:?}");
            apart_by = apart_by.max((one.2 - known.2).abs());
            *words.entry(one.0).or_default() += 1;
        }
        let mut run = simulator.start(at(0.0), &q, &u).unwrap();
        run.finish(at(until));
        let off = apart(&[run.state().q(), run.state().u()].concat(), &other.x);
        worst = worst.max(off);
        assert!(off < 1e-7, "{trial}: {off:e}");
    }
    println!("{trials} machines, {words:?}, times apart by at most {apart_by:e}, the ends by {worst:e}");
    let all = ["stick", "release", "reversal", "impact", "touch", "rest"];
    assert!(all.iter().filter(|word| words.contains_key(*word)).count() + 2 >= all.len(), "{words:?}");
    assert!(trials < 3 || words.len() == all.len(), "{words:?}");
}
