//! Forces that are formulas: against the same machine by modes, against the oscillator of one degree of
//! freedom, against the second integrator, and where they are not smooth.

use grazing_scenes::{
    attractor::lyapunov::exponents,
    many::section::{PlanarMachine, PlaneAxis},
};

use super::{second::Motion, *};

fn scene(body: &str) -> Scene {
    let text = format!("format = \"grazing-scene 2\"\ntitle = \"formulas\"\n{body}");
    Scene::from_toml(&text, "formulas.toml").unwrap_or_else(|error| panic!("{error}"))
}

fn built(body: &str) -> Machine<f64> {
    scene(body).machine(&[]).unwrap()
}

const STOPS: &str = "\n[[walls]]\nname = \"rigid\"\nrow = [-1, 1]\noffset = -0.3\nrestitution = 0.5\n\
                     [[walls]]\nname = \"soft\"\nrow = [1, 0]\noffset = -0.4\nstiffness = 50\ndamping = 1\n\
                     [[walls]]\nname = \"rest\"\nrow = [0, -1]\noffset = -0.35\nrestitution = 0\n\
                     harmonics = [{ k = 1, sin = 0.05 }]";

/// A machine by modes and the same by formulas: its period is 4, so that units of time matter.
fn both() -> [Machine<f64>; 2] {
    let head = "[system]\nperiod = 4\nmass = [[2, 0.3], [0.3, 0.5]]\n";
    let modal = "stiffness = [[3, -1], [-1, 2]]\ndamping = [[0.4, -0.05], [-0.05, 0.3]]\nforce = [0.2, 0.8]\n\
                 forcing = [{ k = 1, cos = [1.5, -0.6] }, { k = 3, sin = [0.2, 0.5] }]";
    let formulas = "force = [\"-3*q1 + q2 - 0.4*u1 + 0.05*u2 + 0.2 + 1.5*cos(t) + 0.2*sin(3*t)\", \
                    \"q1 - 2*q2 + 0.05*u1 - 0.3*u2 + 0.8 - 0.6*cos(t) + 0.5*sin(3*t) + 0*exp(q1)\"]";
    [format!("{head}{modal}{STOPS}"), format!("{head}{formulas}{STOPS}")].map(|text| built(&text))
}

/// Kind, stop and time of events.
fn told(events: &[Event]) -> Vec<(&'static str, usize, f64)> {
    let one = |event: &Event| {
        let kind = match event {
            Event::Impact(_) => "impact",
            Event::Touch(_) => "touch",
            Event::Release(_) => "release",
            Event::Stick(_) => "stick",
            _ => return None,
        };
        Some((kind, event.place()?, TAU * event.time()?.periods()))
    };
    events.iter().filter_map(one).collect()
}

#[test]
fn a_linear_machine_as_formulas_moves_as_by_modes() {
    let machines = both();
    assert!(!machines[0].is_smooth() && machines[1].is_smooth());
    let [modal, smooth] = machines.each_ref().map(simulator);
    let (mut kinds, mut worst) = (std::collections::BTreeSet::new(), 0.0f64);
    for i in 0..24u32 {
        let start = |k: u32| f64::from((i * 7 + k * 5) % 11) / 11.0 - 0.5;
        let (phase, q, u) =
            (TAU * f64::from(i) / 24.0, [0.4 * start(1), 0.1 * start(2)], [start(3), start(4)]);
        let [a, b] = [&modal, &smooth].map(|simulator| {
            let mut all = Vec::new();
            let mut run = simulator.start(at(phase), &q, &u).unwrap();
            run.record(at(phase).after(1.5), |event| all.push(event));
            (told(&all), run.state())
        });
        assert_eq!(a.0.len(), b.0.len(), "{i}: {:?} {:?}", a.0, b.0);
        for (x, y) in a.0.iter().zip(&b.0) {
            assert_eq!((x.0, x.1), (y.0, y.1));
            kinds.insert(x.0);
            worst = worst.max((x.2 - y.2).abs());
            assert!((x.2 - y.2).abs() < 1e-11, "{i}: {x:?} {y:?}");
        }
        let off = apart(a.1.q(), b.1.q()).max(apart(a.1.u(), b.1.u()));
        if a.0.is_empty() {
            assert!(off < 1e-12, "{i}: {off:e}");
        }
        worst = worst.max(off);
        assert!(off < 1e-10, "{i}: {off:e} after {:?}", a.0);
    }
    println!("off by {worst:e}, {kinds:?}");
    assert_eq!(kinds.len(), 4, "{kinds:?}");
}

/// In flight nothing amplifies: eleven digits after ten periods, of the derivative, too.
#[test]
fn exponents_by_formulas_are_those_by_modes() {
    let [modal, smooth] = both().map(|machine| {
        let machine = Machine { stops: machine.stops[..2].to_vec(), ..machine };
        let simulator = simulator(&machine);
        let axes = [PlaneAxis::Place(0), PlaneAxis::Speed(0)];
        let planar = PlanarMachine::new(&machine, simulator, &axes).unwrap();
        let start = State::new(0.0, &[0.1, 0.0], &[0.0, 0.2]);
        let monitor = ();
        let all = exponents(&planar, &start.start(machine.rate()), 4, 0, 12, &monitor).unwrap();
        all.iter().map(|one| one.rate).collect::<Vec<_>>()
    });
    for (a, b) in modal.iter().zip(&smooth) {
        assert!((a - b).abs() < 1e-9 * a.abs().max(0.1), "{modal:?} {smooth:?}");
    }
}

#[test]
fn a_machine_of_one_coordinate_moves_as_the_oscillator_with_its_formula() {
    let force = "-0.2*u + 0.6*q - q^3 - 0.1*tanh(3*u)/(2 + cos(q)) + 0.8*cos(t)";
    let wall = "offset = 1.1\nrestitution = 0.7";
    let text = format!(
        "format = \"grazing-scene 1\"\ntitle = \"one\"\n[system]\nforce = \"{force}\"\n[[walls]]\nside = \"upper\"\n{wall}"
    );
    let oscillator = Scene::from_toml(&text, "one.toml").unwrap().plain(&[]).unwrap();
    let settings = alone::Settings { tolerance: 1e-15, ..alone::Settings::default() };
    let single = alone::Simulator::new(&oscillator, &settings).unwrap();
    let machine = built(&format!(
        "[system]\nperiod = \"2*pi\"\nmass = 1\nforce = \"{force}\"\n[[walls]]\nrow = [-1]\noffset = -1.1\nrestitution = 0.7"
    ));
    let simulator = simulator(&machine);
    let mut run = simulator.start(at(0.0), &[0.3], &[0.5]).unwrap();
    let mut other = single.start(at(0.0), 0.3, 0.5).unwrap();
    let (mut impacts, mut amplified) = (0, 1e-13);
    while impacts < 12 {
        let Event::Impact(hit) = run.next(Time::new(40, 0.0)) else { panic!("an impact") };
        let alone::Event::Impact(known) = other.next(Time::new(40, 0.0)) else { panic!("an impact") };
        amplified *= 4.0;
        let off = hit.time.since(known.time).abs().max((hit.velocity - known.velocity).abs());
        assert!(off < amplified, "impact {impacts}: {off:e}");
        impacts += 1;
    }
}

fn duffing(_: f64, q: &[f64], _: &[f64]) -> Vec<f64> {
    let between = 0.8 * (q[1] - q[0]).powi(3);
    vec![between - 0.5 * q[0].powi(3), -between - 0.3 * q[1].sin()]
}

const DUFFING: &str = "[system]\nperiod = \"2*pi\"\nmass = [[1, 0.1], [0.1, 0.4]]\n\
                       stiffness = [[1.2, -0.4], [-0.4, 0.4]]\ndamping = [[0.1, -0.02], [-0.02, 0.06]]\n\
                       force = [\"0.8*(q2 - q1)^3 - 0.5*q1^3\", \"-0.8*(q2 - q1)^3 - 0.3*sin(q2)\"]\n\
                       forcing = [{ k = 1, cos = [0.9, 0.1], sin = [0, 0] }]\n";

/// A coupled Duffing pair: rigid, soft and resting contact.
#[test]
fn coupled_formulas_agree_with_a_second_integrator() {
    for (stops, rests) in [
        ("[[walls]]\nrow = [0, -1]\noffset = -0.6\nrestitution = 0.7", false),
        (
            "[[walls]]\nrow = [0, -1]\noffset = -0.6\nrestitution = 0.7\n[[walls]]\nrow = [1, 0]\noffset = -0.5\n\
             stiffness = 30\ndamping = 0.5",
            false,
        ),
        ("[[walls]]\nrow = [0, -1]\noffset = -0.5\nrestitution = 0", true),
    ] {
        let machine = built(&format!("{DUFFING}{stops}"));
        let simulator = simulator(&machine);
        let (q, u) = ([0.2, 0.1], [0.3, 0.9]);
        let until = 6.0;
        let all = told(&events(&simulator, (at(0.0), &q, &u), at(until)));
        let mut motion = Motion::new(&machine, &q, &u);
        motion.load = Some(duffing);
        let hits = motion.follow(until);
        let mut run = simulator.start(at(0.0), &q, &u).unwrap();
        run.finish(at(until));
        let state = run.state();
        let off = apart(state.q(), &motion.q).max(apart(state.u(), &motion.u));
        println!("{all:?}: off by {off:e}");
        let impacts: Vec<f64> = all.iter().filter(|event| event.0 == "impact").map(|event| event.2).collect();
        assert!(!impacts.is_empty());
        assert_eq!(impacts.len(), hits.len(), "{impacts:?} {hits:?}");
        assert!((impacts[0] - hits[0].1).abs() < 1e-12, "{impacts:?} {hits:?}");
        assert_eq!(all.iter().any(|event| event.0 == "stick"), rests);
        assert_eq!(all.iter().any(|event| event.0 == "touch"), !motion.contacts.is_empty());
        assert!(off < 1e-11 * (1.0 + all.len() as f64), "{off:e}");
    }
}

/// Free flight for two periods, from rest, and with masses and lengths of any size: the tolerance is relative
/// to the motion alone.
#[test]
fn formulas_know_no_unit() {
    let machine = |length: f64, mass: f64| {
        let force = mass * length;
        built(&format!(
            "[system]\nperiod = \"2*pi\"\nmass = [[{mass:e}, 0], [0, {mass:e}]]\n\
             force = [\"{force:e}*(cos(t) - tanh(q1/{length:e}) + 0.1*(q2/{length:e})^3)\", \
             \"{force:e}*(-q2/{length:e} - 0.3*(q2 - q1)/{length:e} - 0.1*u2/{length:e})\"]"
        ))
    };
    let end = |length: f64, mass: f64| {
        let machine = machine(length, mass);
        let simulator = simulator(&machine);
        let mut run = simulator.start(at(0.0), &[0.0; 2], &[0.0; 2]).unwrap();
        assert_eq!(run.finish(Time::new(2, 0.0)), RunEnd::Reached);
        let state = run.state();
        state.q().iter().chain(state.u()).map(|x| x / length).collect::<Vec<f64>>()
    };
    let known = end(1.0, 1.0);
    let scale = known.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    for (length, mass) in [(1e-9, 1.0), (1e12, 1e-6), (1e-3, 1e7), (1e-40, 1e30)] {
        for (a, b) in known.iter().zip(end(length, mass)) {
            assert!((a - b).abs() < 1e-12 * scale, "{length:e} {mass:e}: {a} {b}");
        }
    }
}

/// The first coordinate moves at speed 1 to where the force on the second has no value.
#[test]
fn a_force_that_is_not_smooth_ends_the_motion_where_it_is_not() {
    for force in ["log(1 - q1)", "1/(q1 - 1)", "sqrt(1 - q1)", "q2/(1 - q1)^2 - 1"] {
        let machine =
            built(&format!("[system]\nperiod = \"2*pi\"\nmass = [[1, 0], [0, 1]]\nforce = [0, \"{force}\"]"));
        let simulator = simulator(&machine);
        let mut run = simulator.start(at(0.0), &[0.0, 0.0], &[1.0, 0.0]).unwrap();
        assert_eq!(run.finish(Time::new(3, 0.0)), RunEnd::NotSmooth, "{force}");
        let (time, state) = (TAU * run.time().periods(), run.state());
        assert!((time - 1.0).abs() < 1e-5 && (state.q()[0] - 1.0).abs() < 1e-5, "{force}: {time} {state:?}");
    }
}

#[test]
fn bad_formulas_are_named_with_their_key() {
    let head = "[system]\nperiod = 1\nmass = [[1, 0], [0, 1]]\n";
    for (force, wrong) in [
        ("[\"q1\"]", "has 1 entries; the machine has 2 coordinates"),
        ("\"q1*q2\"", "has 1 entries; the machine has 2 coordinates"),
        ("[\"q3\", 0]", "q3"),
        ("[\"q\", 0]", "q"),
        ("[0, \"cos(t/2)\"]", "is not periodic in t"),
        ("[0, \"q1*t\"]", "system.force[2]"),
        ("[0, \"q1*sqrt(0 - 1)\"]", "root of a negative number"),
    ] {
        let text = format!("format = \"grazing-scene 2\"\ntitle = \"bad\"\n{head}force = {force}");
        let error = Scene::from_toml(&text, "bad.toml").and_then(|scene| scene.machine(&[])).unwrap_err();
        let error = error.to_string();
        assert!(error.contains(wrong) && error.contains("system.force"), "{force}: {error}");
    }
}
