//! Friction that follows the sliding speed: closed forms, energy, the second solver, orbits, refusals.

use std::collections::BTreeMap;

use grazing_scenes::many::{
    orbit::{Itinerary, find},
    simulate::Slid,
};

use super::{super::*, in_a_row, numbers, refusals::refusal, rough::Rough, scene, told};
use crate::samples::samples;

/// One mass, with a system and friction beside it.
fn alone(system: &str, friction: &str) -> Machine<f64> {
    scene(system, &format!("[[friction]]\n{friction}\n")).machine(&[]).unwrap()
}

/// A mass on a spring above a table that is rough by Stribeck's law, its period not that of a radian: numbers
/// of another program.
#[test]
fn stribecks_law_is_that_of_another_program() {
    let machine = alone(
        "period = 1\nmass = 1\nstiffness = 100\n",
        "normal = 10\ncoefficient = \"0.2 + 0.2*exp(-abs(v)/0.05)\"\nspeed = 0.1",
    );
    let simulator = simulator(&machine);
    let mut run = simulator.start(at(0.0), &[0.0], &[0.1 / machine.rate()]).unwrap();
    let mut words: BTreeMap<&str, u32> = BTreeMap::new();
    let end = run.record(Time::new(5, 0.0), |event| *words.entry(event.word()).or_default() += 1);
    // It sticks six times: from the beginning on, and five times more.
    assert_eq!((end, words["release"], words["stick"], words.len()), (RunEnd::Reached, 6, 5, 2), "{words:?}");
    let (q, u) = (run.state().q()[0], run.state().u()[0] * machine.rate());
    assert!((q - 0.033644940144).abs() < 1e-11 && (u + 0.223795295079).abs() < 1e-10, "{q} {u}");
}

/// q and q′ after t of q″ + c q′ + k q = f.
fn linear([c, k, f]: [f64; 3], [q, u]: [f64; 2], t: f64) -> [f64; 2] {
    let (omega, p) = ((k - c * c / 4.0).sqrt(), q - f / k);
    let ((sin, cos), fades) = ((omega * t).sin_cos(), (-c * t / 2.0).exp());
    let place = p * cos + (u + c * p / 2.0) / omega * sin;
    [f / k + fades * place, fades * (u * cos - (c * u / 2.0 + k * p) / omega * sin)]
}

/// The first time at which that has a velocity, from a little after its beginning on.
fn first(of: [f64; 3], from: [f64; 2], velocity: f64) -> f64 {
    let off = |t: f64| linear(of, from, t)[1] - velocity;
    let (mut low, step) = (1e-3, 1e-3);
    while off(low) * off(low + step) > 0.0 {
        low += step;
    }
    let mut high = low + step;
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if off(low) * off(middle) <= 0.0 { high = middle } else { low = middle }
    }
    low
}

/// A mass on a belt of speed V with µ = max(0.3, 0.5 − |v|): where v > −0.2 that is a damper below 0, then a
/// constant force.
#[test]
fn a_law_of_straight_pieces_is_closed() {
    let (k, v) = (4.0, 0.3);
    let machine = alone(
        &format!("period = \"2*pi\"\nmass = 1\nstiffness = {k:?}\n"),
        "normal = 1\ncoefficient = \"max(0.3, 0.5 - abs(2*v)/2)\"\nspeed = 0.3",
    );
    let (slow, fast) = ([-1.0, k, 0.5 - v], [0.0, k, 0.3]);
    let (mut state, mut now, mut expected) = ([0.5 / k, v], 0.0, vec![("release", 0.0)]);
    for _ in 0..4 {
        for (piece, until, word) in [(slow, v - 0.2, "kink"), (fast, v - 0.2, "kink"), (slow, v, "stick")] {
            let gone = first(piece, state, until);
            (state, now) = (linear(piece, state, gone), now + gone);
            expected.push((word, now));
        }
        (state, now) = ([0.5 / k, v], now + (0.5 / k - state[0]) / v);
        expected.push(("release", now));
    }
    let all = events(&simulator(&machine), (at(0.0), &[0.5 / k], &[v]), at(now + 0.1));
    let found = all.iter().filter(|event| !matches!(event, Event::End(_)));
    let found: Vec<(&str, f64)> =
        found.filter_map(|event| Some((event.word(), TAU * event.time()?.periods()))).collect();
    // It may begin by sticking for no time at all, and slides then.
    let expected = if found[0].0 == "release" { &expected[..] } else { &expected[1..] };
    assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
    for (one, known) in found.iter().zip(expected) {
        assert!(one.0 == known.0 && (one.1 - known.1).abs() < 1e-10, "{one:?} {known:?}");
    }
}

/// What friction takes is what is missing.
#[test]
fn the_energy_of_a_law_is_what_is_missing() {
    let machine = alone(
        "period = 3\nmass = 2\nstiffness = 3\n",
        "normal = 0.7\ncoefficient = \"0.1 + 0.2*exp(-(v/0.3)^2) + 0.05*abs(v)^1.5\"",
    );
    let (simulator, rate) = (simulator(&machine), machine.rate());
    let energy = |q: f64, u: f64| 0.5 * (2.0 * (rate * u).powi(2) + 3.0 * q * q);
    let mut run = simulator.start(at(0.0), &[0.2], &[1.0]).unwrap();
    let mut slid = Slid::new(&run);
    while !matches!(run.next(Time::new(2, 0.0)), Event::End(_)) {
        slid.flown(&run);
    }
    slid.flown(&run);
    assert!(run.failure().is_none());
    let (taken, state) = (slid.rows().next().unwrap().2, run.state());
    let missing = energy(0.2, 1.0) - energy(state.q()[0], state.u()[0]);
    assert!(missing > 0.3 && (taken - missing).abs() < 1e-9, "{taken} {missing}");
}

/// Random machines of one or two coordinates with one or two rows by Stribeck's law, some on belts: every
/// stick, release and reversal, its time, and the state at the end.
#[test]
fn random_machines_with_stribecks_law_agree_with_a_second_solver() {
    let trials: u32 = samples(3);
    let mut random = numbers(1_442_695_040_888_963_407);
    let mut words: BTreeMap<&str, u32> = BTreeMap::new();
    let mut worst = 0.0f64;
    for trial in 0..trials {
        let mut between = |low: f64, high: f64| random(low, high);
        let n = 1 + trial as usize % 2;
        let [k, l, m] = [between(0.5, 5.0), between(0.5, 2.0), between(0.5, 2.0)];
        let matrices = in_a_row(n, [k, l, m]);
        let cos: Vec<f64> = (0..n).map(|_| between(0.5, 2.0)).collect();
        let system = format!("period = \"2*pi\"\n{matrices}forcing = [{{ cos = {cos:?} }}]\n");
        let mut laws = Vec::new();
        let mut rub = |row: &[f64], most: f64, speed: f64, more: f64, scale: f64| {
            let [low, drop] = [0.4 * most, 0.6 * most];
            laws.push([low, drop, scale]);
            let held =
                if more > 1.0 { format!("static_coefficient = {:?}\n", most * more) } else { String::new() };
            format!(
                "[[friction]]\nrow = {row:?}\nnormal = 1\nspeed = {speed:?}\n{held}coefficient = \"{low:?} + \
                 {drop:?}*exp(-abs(v)/{scale:?})\"\n"
            )
        };
        let speed = if trial % 5 > 2 { between(-0.4, 0.4) } else { 0.0 };
        let more = if trial % 3 == 2 { between(1.01, 1.5) } else { 1.0 };
        let first: Vec<f64> = (0..n).map(|i| f64::from(u8::from(i == 0))).collect();
        let mut rubs = rub(&first, between(0.5, 1.1), speed, more, between(0.1, 1.0));
        if n == 2 && trial % 4 == 3 {
            rubs += &rub(&[-1.0, 1.0], between(0.1, 0.5), 0.0, more, between(0.1, 1.0));
        }
        let rough = scene(&system, &rubs).machine(&[]).unwrap();
        let simulator = simulator(&rough);
        let (q, u): (Vec<f64>, Vec<f64>) = (0..n).map(|_| (between(-0.3, 0.3), between(-0.5, 0.5))).unzip();
        let until = 4.0 * TAU;
        let found = told(&events(&simulator, (at(0.0), &q, &u), at(until)));
        let mut other = Rough::new(&rough, &q, &u);
        other.stribeck = laws;
        other.decide(None);
        let expected = other.follow(until);
        let names =
            |all: &[(&'static str, usize, f64)]| all.iter().map(|one| (one.0, one.1)).collect::<Vec<_>>();
        assert_eq!(names(&found), names(&expected), "{trial}: {found:?}\n{expected:?}\n{system}{rubs}");
        for (one, known) in found.iter().zip(&expected) {
            assert!((one.2 - known.2).abs() < 1e-7, "{trial}: {one:?} {known:?}");
            *words.entry(one.0).or_default() += 1;
        }
        let mut run = simulator.start(at(0.0), &q, &u).unwrap();
        run.finish(at(until));
        let off = apart(&[run.state().q(), run.state().u()].concat(), &other.x);
        worst = worst.max(off);
        assert!(off < 1e-7, "{trial}: {off:e}");
    }
    println!("{trials} machines, {words:?}, at the end apart by at most {worst:e}");
    let all = ["stick", "release", "reversal"];
    assert!(all[..2].iter().all(|word| words.contains_key(word)), "{words:?}");
    assert!(trials < 12 || words.contains_key(all[2]), "{words:?}");
}

/// An orbit comes back, and its multipliers are those of differences of motions.
#[test]
fn orbits_with_a_law_have_the_multipliers_of_differences() {
    let machine = alone(
        "period = 6\nmass = 1\nstiffness = 2.6\nforcing = [{ cos = 1 }]\n",
        "normal = 1\ncoefficient = \"0.2 + 0.15*exp(-abs(v)/0.3)\"",
    );
    let simulator = simulator(&machine);
    let orbit = find(&simulator, &Itinerary::free(1).unwrap(), &[]).unwrap();
    let after = |q: f64, u: f64| {
        let mut run = simulator.start(at(0.0), &[q], &[u]).unwrap();
        run.finish(Time::new(1, 0.0));
        [run.state().q()[0], run.state().u()[0]]
    };
    let (q, u, h) = (orbit.state.q()[0], orbit.state.u()[0], 1e-6);
    assert!(apart(&after(q, u), &[q, u]) < 1e-11 && u != 0.0);
    let slope = |a: [f64; 2], b: [f64; 2]| [0, 1].map(|i| (a[i] - b[i]) / (2.0 * h));
    let columns = [slope(after(q + h, u), after(q - h, u)), slope(after(q, u + h), after(q, u - h))];
    let [a, b] = [orbit.multipliers[0], orbit.multipliers[1]];
    let wanted =
        [columns[0][0] + columns[1][1], columns[0][0] * columns[1][1] - columns[0][1] * columns[1][0]];
    let found = [a.0 + b.0, a.0 * b.0 - a.1 * b.1];
    assert!(apart(&found, &wanted) < 1e-7, "{found:?} {wanted:?}");
}

/// What a law is not, with its place and what to do.
#[test]
fn laws_that_are_not_taken_are_refused_with_their_place() {
    let body = |normal: &str, coefficient: &str| {
        format!(
            "[parameters]\nF = 1\nv = 1\n[system]\nmass = [[1, 0], [0, 1]]\nforcing = [{{ cos = [\"F\", 1] }}]\n\
             stiffness = [[2, 0], [0, 3]]\n[[stops]]\nname = \"floor\"\nrow = [0, 1]\noffset = -1\nrestitution = 0.5\n\
             [[friction]]\nname = \"foot\"\nrow = [1, 0]\n{normal}\ncoefficient = {coefficient}\n"
        )
    };
    let law = "\"0.2 + 0.2*exp(-abs(v)/0.05)\"";
    let (given, on_stop) = ("normal = 1", "stop = \"floor\"");
    for (normal, coefficient, answers) in [
        (given, "\"0.3 + v\"", ["friction[1].coefficient", "the same both ways", "abs(v)"]),
        (given, "\"0.4 - abs(v)\"", ["friction[1].coefficient", "v = 0.5", "at least 0"]),
        (given, "\"log(abs(v))\"", ["friction[1].coefficient", "v = 0", "at least 0"]),
        (on_stop, law, ["friction[1].coefficient", "normal force alone", "give `normal`"]),
        (given, &format!("{law}\nstatic_coefficient = 0.3"), ["static_coefficient", "below", "0.4"]),
    ] {
        let error = refusal(3, &body(normal, coefficient).replace("v = 1\n[system]", "[system]"));
        assert!(answers.iter().all(|answer| error.contains(answer)), "{answers:?}: {error}");
    }
    let error = refusal(3, &body(given, law));
    assert!(error.contains("friction[1].coefficient") && error.contains("rename the parameter"), "{error}");
}

/// The speed has units where the scene has.
#[test]
fn a_law_in_units_is_the_same_in_others() {
    let scene = |length: &str, scale: &str| {
        let text = format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\nunits = {{ length = \"{length}\", time = \"s\", mass = \"kg\" }}\n\
             [system]\nfrequency = \"1 Hz\"\nmass = \"1 kg\"\nstiffness = \"100 N/m\"\n[[friction]]\nnormal = \"10 N\"\n\
             coefficient = \"0.2 + 0.2*exp(-abs(v)/({scale}))\"\nspeed = \"10 cm/s\"\n"
        );
        let machine =
            Scene::from_toml(&text, "t.toml").unwrap_or_else(|error| panic!("{error}")).machine(&[]);
        let machine = machine.unwrap();
        let unit = machine.friction[0].speed / 0.1;
        let simulator = simulator(&machine);
        let mut run = simulator.start(at(0.0), &[0.0], &[unit * 0.1 / machine.rate()]).unwrap();
        run.finish(Time::new(5, 0.0));
        run.state().q()[0] / unit
    };
    assert!((scene("m", "5 cm/s") - 0.033644940144).abs() < 1e-10);
    assert!((scene("mm", "0.05 m/s") - 0.033644940144).abs() < 1e-10);
}
