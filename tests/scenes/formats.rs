//! The formats of scenes: 1 and 2 are read for ever, format 3 says the same, and the engine is the one for
//! which the system qualifies.

use std::{fs, path::Path};

use grazing_scenes::{
    Result,
    motion::Harmonic,
    num_rational::BigRational,
    run::{Job, Keeper, SeriesOf, SeriesPoint, StopEvent, Surroundings, run_task},
    scene::{Body, Engine, EngineKey, Scene, SceneFormat},
};
use serde_json::Value;

use crate::tasks;

/// All scenes among examples and test data.
fn files() -> Vec<(String, String)> {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let mut all = Vec::new();
    for folder in ["examples/scenes", "examples/machines", "tests/data"] {
        for file in fs::read_dir(root.join(folder)).unwrap() {
            let path = file.unwrap().path();
            let text = fs::read_to_string(&path).unwrap_or_default();
            if path.extension().is_some_and(|end| end == "toml") && text.contains("grazing-scene") {
                all.push((path.display().to_string(), text));
            }
        }
    }
    all
}

/// A linear force written as a formula is its coefficients, exactly, in any form, with a mass and in any unit
/// of time; what is not linear stays a formula.
#[test]
fn a_linear_formula_is_its_coefficients() {
    let scene = |keys: &str| {
        let text = format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\na = 0.7\nF = 3\nw = 5\n[system]\n{keys}\n\
             [[stops]]\nside = \"upper\"\noffset = 1\nrestitution = 0.8\n"
        );
        Scene::from_toml(&text, "s.toml").unwrap()
    };
    let keys =
        "damping = 0.1\nstiffness = \"a\"\nforcing = [{ cos = \"F\", sin = 2 }, { k = 3, sin = \"-a/4\" }]";
    for head in ["", "mass = 2\n", "period = \"2*pi/7\"\n", "period = \"2*pi/w\"\nmass = \"a\"\n"] {
        let force = |scene: &Scene| {
            let system = scene.exact(&[]).unwrap();
            let mut forcing: Vec<_> =
                system.forcing.iter().map(|all| (all.k, all.cos.clone(), all.sin.clone())).collect();
            forcing.sort();
            (system.damping, system.stiffness, system.force, forcing, system.rate, system.smooth.is_none())
        };
        let expected = force(&scene(&format!("{head}{keys}\nforce = \"w/3\"")));
        assert!(expected.5);
        for text in [
            "-u/10 - a*q + F*cos(t) + 2*sin(t) - a/4*sin(3*t) + w/3",
            "-(0.1*u + q*a) - cos(-t)*(-F) - 2*sin(-t) + a*sin(-3*t)/4 + w/3",
            "(F*cos(t) - q*a - u/10 + w/3 - (sin(t + 2*t) - 8*sin(t)/a)*a/4)^1",
            "q*0 - (q + u/(10*a))*a + F*cos(2*t/2) + 2*sin(t) + sin(3*(0 - t))*(a/4) + (w + 0)/3",
        ] {
            assert_eq!(force(&scene(&format!("{head}force = \"{text}\""))), expected, "{head}{text}");
        }
        // Beside the keys, which it adds to.
        let beside = "damping = 0.05\nforcing = [{ k = 3, sin = \"-a/4\" }, { cos = 1 }]\n\
                      force = \"-u/20 - a*q + (F - 1)*cos(t) + 2*sin(t) + w/3\"";
        assert_eq!(force(&scene(&format!("{head}{beside}"))), expected, "{head}");
    }
    for text in [
        "-q^3",
        "q*u",
        "cos(t)*q",
        "cos(t)^2",
        "sin(q)",
        "1/(2 + q)",
        "cos(q + t)",
        "exp(cos(t))",
        "q^2 - q^2",
        "log(a)*q",
        "tanh(a)*u",
    ] {
        let Body::Oscillator(system) = &scene(&format!("force = \"{text}\"")).body else { panic!("{text}") };
        assert!(system.smooth.is_some(), "{text}");
    }
    // A phase has no exact cosine, and is one in floats.
    let turned = scene("force = \"-q + 5*cos(t - 1)\"").plain(&[]).unwrap();
    let [Harmonic { k: 1, cos, sin }] = turned.forcing[..] else { panic!("{turned:?}") };
    assert!((cos - 5.0 * 1f64.cos()).abs() < 1e-15 && (sin - 5.0 * 1f64.sin()).abs() < 1e-15);
}

/// So it is of a machine: of several coordinates, of modes, and beside what the other keys say. One formula
/// that is not linear keeps them all.
#[test]
fn linear_formulas_are_the_matrices_of_a_machine() {
    let read = |keys: &str| {
        let text = format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\nengine = \"many\"\n[parameters]\nF = 3\n[system]\nperiod = 4\n\
             {keys}\n[[stops]]\nrow = [1, -1]\noffset = -1\nrestitution = 0.8\n"
        );
        let machine = Scene::from_toml(&text, "s.toml").unwrap().machine(&[]).unwrap();
        let dense = |entries: &[(usize, usize, f64)]| {
            let mut all = [[0.0; 2]; 2];
            entries.iter().for_each(|&(i, j, x)| all[i][j] += x);
            all
        };
        let list = |all: &[f64]| if all.is_empty() { vec![0.0; 2] } else { all.to_vec() };
        let mut forcing: Vec<_> =
            machine.forcing.iter().map(|load| (load.k, list(&load.cos), list(&load.sin))).collect();
        forcing.sort_by_key(|load| load.0);
        let matrices = [&machine.mass, &machine.damping, &machine.stiffness].map(|all| dense(all));
        (matrices, list(&machine.force), forcing, machine.is_smooth())
    };
    let mass = "mass = [[2, 0.5], [0.5, 1]]\n";
    let expected = read(&format!(
        "{mass}damping = [[0.5, -0.25], [0, 1]]\nstiffness = [[3, -1], [-2, 4]]\nforce = [0.5, 0]\n\
         forcing = [{{ cos = [\"F\", -1] }}, {{ k = 3, sin = [0, \"F/4\"] }}]"
    ));
    assert!(!expected.3);
    for keys in [
        "force = [\"q2 - u1/2 - 3*q1 + u2/4 + 1/2 + F*cos(t)\", \"2*(q1 - 2*q2) - u2 - cos(t) + F/4*sin(3*t)\"]",
        "stiffness = [[1, 0], [0, 0]]\ndamping = { diagonal = [0, 1] }\nforcing = [{ cos = [\"F - 1\", 0] }]\n\
         force = [\"(u2 - 2*u1)/4 - 2*q1 + q2 + cos(-t) + 0.5\", \"2*q1 - 4*q2 - cos(t) - F*sin(-3*t)/4\"]",
    ] {
        assert_eq!(read(&format!("{mass}{keys}")), expected, "{keys}");
    }
    // Forces on the points 1 and 2 are in all entries of modes: rows of Φ are 1, 1 and 1, −1.
    let modes = "modes = { frequencies = [1, 2], ratios = 0, shapes = [[1, 1], [1, -1]] }\n";
    let ([_, none, own], ..) = read(modes);
    let ([_, damping, stiffness], _, forcing, is_smooth) =
        read(&format!("{modes}force = [\"-3*q1 - u2/2\", \"5*q1 + sin(t)\"]"));
    let more = [[-2.0, -2.0], [8.0, 8.0]];
    for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        assert_eq!(stiffness[i][j] - own[i][j], more[i][j], "{stiffness:?}");
        assert_eq!(damping[i][j] - none[i][j], [0.5, -0.5][j], "{damping:?}");
    }
    assert_eq!((forcing, is_smooth), (vec![(1, vec![0.0; 2], vec![0.0, 1.0])], false));
    // Ratios are of the modes of what the other keys say.
    let ratio = format!("{mass}stiffness = [[3, -1], [-1, 4]]\ndamping_ratio = 0.1\n");
    for (force, expected) in [
        ("[\"F*cos(t)\", 0]", false),
        ("[\"-u1\", 0]", true),
        ("[\"-q1\", 0]", true),
        ("[\"-q1\", \"-q2^3\"]", true),
    ] {
        let ratio = if force.contains('^') { mass } else { &ratio };
        assert_eq!(read(&format!("{ratio}force = {force}")).3, expected, "{force}");
    }
}

/// What a scene says, apart from the text it is read from.
fn said(scene: Scene) -> String {
    let Scene { title, parameters, body, stops, accuracy, tasks, engine, .. } = scene;
    format!("{title} {parameters:?} {body:?} {stops:?} {accuracy:?} {tasks:?} {:?}", engine.name)
}

#[test]
fn an_upgraded_scene_says_the_same() {
    let mut formats = Vec::new();
    for (name, text) in files() {
        let old = Scene::from_toml(&text, &name).unwrap();
        let new = Scene::upgraded(&text, &name).unwrap();
        let read = Scene::from_toml(&new, &name).unwrap();
        assert_eq!(read.format, SceneFormat::Three);
        formats.push(old.format);
        assert_eq!(said(old), said(read), "{name}");
        // Comments and layout stay: at most a line is new.
        let comments = |text: &str| text.matches('#').count();
        assert_eq!(comments(&text), comments(&new), "{name}");
        let more = new.lines().count() - text.lines().count();
        assert_eq!(more, usize::from(new.contains("\nengine = ")), "{name}");
        assert_eq!(Scene::upgraded(&new, &name).unwrap(), new, "{name}");
    }
    for format in [SceneFormat::One, SceneFormat::Two] {
        assert!(formats.contains(&format), "no {format:?} among {formats:?}");
    }
}

const OLD: &str = r#"# A pair of walls.
format = "grazing-scene 1" # old
title = "t"
[system]
stiffness = 0.25
[[walls]] # below
side = "lower"
offset = -1
restitution = 1
[[walls]]
side = "upper"
offset = 1
harmonics = [{ cos = 0.5 }]
restitution = 1
[[tasks]]
name = "o"
kind = "orbit"
orbit = { walls = ["lower", "upper"], pattern = [1, 0], start = [ 0.0_1, 0.5, "1/3", 2 ] } # a start
[[tasks]]
name = "s"
kind = "section"
starts = [{ q = 0 }]
orbits = [{ pattern = [], start = [0.1, 0.2] }, { pattern = [1], walls = ["upper"], start = [3, 4] }]
frame = "upper"
"#;

#[test]
fn an_upgrade_changes_names_and_times_and_nothing_else() {
    let expected = OLD
        .replace("scene 1", "scene 3")
        .replace("walls]]", "stops]]")
        .replace("walls =", "stops =")
        .replace("0.0_1", "\"0.01 rad\"")
        .replace("\"1/3\"", "\"1/3 rad\"")
        .replace("[3, 4]", "[\"3 rad\", 4]");
    assert_eq!(Scene::upgraded(OLD, "s").unwrap(), expected);
}

#[test]
fn errors_have_the_words_of_the_file() {
    let newer = "write format = \"grazing-scene 3\" (`grazing run --upgrade` does)";
    for (from, to, message) in [
        ("offset = 1\n", "offset = x\n", "s.toml:12: "),
        ("offset = 1\n", "offset = \"x\"\n", "s.toml:12: walls[2].offset = \"x\": unknown parameter"),
        ("[system]", "[sistem]", "s.toml:4: unknown key \"sistem\"; the nearest known key is \"system\""),
        (
            "[[walls]] # below",
            "[[wals]]",
            "s.toml:6: unknown key \"wals\"; the nearest known key is \"walls\"",
        ),
        ("[[walls]] # below", "[[stops]]", "s.toml:6: unknown key \"stops\"; known here are walls"),
        (
            "walls = [\"lower\", \"upper\"]",
            "walls = [\"lower\"]",
            "s.toml:18: tasks[1].orbit.walls = [\"lower\"]: must name 2 walls, one for each impact",
        ),
        (
            "walls = [\"lower\", \"upper\"]",
            "walls = [\"lower\", \"uper\"]",
            "s.toml:18: tasks[1].orbit.walls[2] = \"uper\": is no wall of the scene; the nearest is \"upper\"",
        ),
        (
            "walls = [\"lower\", \"upper\"], ",
            "",
            "s.toml:18: tasks[1].orbit.pattern = [1, 0]: the scene has several walls: name that of each impact in `walls`, of lower, upper",
        ),
        ("\"1/3\"", "\"1/x\"", "s.toml:18: tasks[1].orbit.start[3] = \"1/x\": \"1/x\" is not a number"),
        (
            "stiffness",
            "mass = 2\nstiffness",
            &format!("s.toml:5: system: unknown key \"mass\": in format 1 the mass is 1; {newer}"),
        ),
        (
            "side = \"upper\"\n",
            "",
            "s.toml:10: walls[2] has no key side, which must be given: `\"lower\"` or `\"upper\"`",
        ),
        (
            "restitution = 1\n[[tasks]]",
            "restitution = \"1/(1 + v)\"\n[[tasks]]",
            "s.toml:14: walls[2].restitution = \"1/(1 + v)\": has a wall, upper, whose restitution depends on the speed v; write",
        ),
    ] {
        assert!(OLD.contains(from), "{from}");
        let error = Scene::from_toml(&OLD.replacen(from, to, 1), "s.toml").unwrap_err().to_string();
        assert!(error.starts_with(message), "{to}\n  found    {error}\n  expected {message}");
    }
}

fn scene(rest: &str) -> String {
    format!("format = \"grazing-scene 3\"\ntitle = \"t\"\n{rest}")
}

fn engine(rest: &str) -> Engine {
    Scene::from_toml(&scene(rest), "s.toml").unwrap_or_else(|error| panic!("{rest}: {error}")).engine
}

const LOWER: &str = "[[stops]]\noffset = -1\nrestitution = 0.5\n";

#[test]
fn the_engine_is_one_where_the_system_qualifies() {
    for system in [
        "",
        "mass = 2\nstiffness = 1",
        "period = \"2*pi\"",
        "period = \"-w*pi/(-w)*2\"",
        "frequency = \"1/(2*pi)\"",
        "frequency = \"w/(2*w*pi)\"",
        "cubic = 1",
        "force = \"-sin(q1) + cos(t)\"",
        "stiffness = \"sqrt(9/4)\"",
        "stiffness = \"sqrt(2)\"",
        "stiffness = 1\ndamping_ratio = 0.1",
        "period = 1",
        "frequency = 4\nmass = 2",
        "frequency = \"w\"",
    ] {
        let found = engine(&format!("[parameters]\nw = 1\n[system]\n{system}\n{LOWER}"));
        assert_eq!(found.name, EngineKey::One, "{system}: {found:?}");
    }
    for stop in ["side = \"upper\"", "side = \"lower\"", "row = [1]", "row = [-1]", "row = \"1/1\"", ""] {
        let found = engine(&format!("[system]\n[[stops]]\noffset = -1\nrestitution = 1\n{stop}\n"));
        assert_eq!(found.name, EngineKey::One, "{stop}: {found:?}");
    }
}

#[test]
fn the_engine_is_many_for_a_reason() {
    let stop = |law: &str| format!("[system]\n[[stops]]\nname = \"seat\"\noffset = -1\n{law}\n");
    for (rest, why) in [
        ("[system]\nmass = [[1, 0], [0, 1]]", "has 2 degrees of freedom"),
        (
            "[system]\nmass = 1\nstiffness = \"2^-1/2\"\n[accuracy]\nminimum_depth = 1e-9\n[[stops]]\noffset = -1\nstiffness = 1",
            "has a compliant stop, 1",
        ),
        ("[system]\nmodes = { frequencies = [1] }", "has `modes`"),
        (&stop("stiffness = 10"), "has a compliant stop, seat"),
        (&stop("restitution = \"1/(1 + v)\""), "has a stop, seat, whose restitution depends on the speed v"),
        (&stop("restitution = 1\nrow = [2]"), "has a stop, seat, whose row is not 1 or −1"),
        (&format!("[system]\n{LOWER}{LOWER}"), "has two stops on the lower side"),
    ] {
        let found = engine(rest);
        assert_eq!((found.name, found.reason), (EngineKey::Many, format!("the system {why}")), "{rest}");
        let asked = Scene::from_toml(&scene(&format!("engine = \"one\"\n{rest}")), "s.toml").unwrap_err();
        assert!(asked.to_string().contains(why), "{asked}");
        // What only `one` does is refused with what disqualifies the system.
        let task = "\n[[tasks]]\nname = \"m\"\nkind = \"crisis\"\nparameter = \"a\"\nbracket = [0, 1]\norbit = {}\nphase = 0\nstart = { q = 0 }\n";
        let error =
            Scene::from_toml(&scene(&format!("[parameters]\na = 1\n{rest}{task}")), "s.toml").unwrap_err();
        let (error, kind) =
            (error.to_string(), "tasks[1].kind = \"crisis\": works with one degree of freedom");
        assert!(error.contains(kind) && error.ends_with(why), "{error}");
    }
    let asked = engine("engine = \"many\"\n[system]\n");
    assert_eq!((asked.name, asked.reason.as_str()), (EngineKey::Many, "the scene asks for it"));
}

/// Of a period that is no number, or not positive, is said where it stands.
#[test]
fn a_period_is_positive() {
    const NONE: &str = "makes no period: it must be positive";
    for (period, is) in [
        ("0", NONE),
        ("-1", "makes the period -1; it must be positive"),
        ("\"w - 1\"", NONE),
        ("\"1/(w - 1)\"", NONE),
    ] {
        let text = scene(&format!("[parameters]\nw = 1\n[system]\nperiod = {period}\n"));
        let error = Scene::from_toml(&text, "s.toml").unwrap_err().to_string();
        assert!(error.contains("system.period") && error.contains(is), "{error}");
    }
}

/// A mass and a row −1 become coefficients of mass 1 and an upper wall, exactly.
#[test]
fn masses_and_rows_are_made_into_the_oscillator_exactly() {
    let text = scene(
        "[parameters]\nm = 3\n[system]\nmass = \"m\"\ndamping = 1\nstiffness = \"1 + 1\"\ncubic = \"-1\"\nforce = \"1 - 1/4\"\n\
         forcing = [{ k = 2, sin = 5 }]\n[[stops]]\nrow = [-1]\noffset = \"-m\"\nharmonics = [{ cos = 1 }]\nrestitution = 1\n",
    );
    let system = Scene::from_toml(&text, "s.toml").unwrap().exact(&[]).unwrap();
    let third = |n: i64| BigRational::new(n.into(), 3.into());
    let coefficients = [system.damping, system.stiffness, system.cubic, system.force];
    assert_eq!(coefficients, [third(1), third(2), third(-1), third(3) / BigRational::from_integer(4.into())]);
    assert_eq!((system.forcing[0].k, &system.forcing[0].sin), (2, &third(5)));
    let upper = system.upper.unwrap();
    assert_eq!((upper.offset, upper.harmonics[0].cos.clone()), (third(9), third(-3)));
    assert!(system.lower.is_none());
}

/// All that a series is kept of.
#[derive(Default)]
struct Kept {
    of: Option<SeriesOf>,
    points: Vec<f64>,
    events: Vec<StopEvent>,
}

impl Keeper for Kept {
    fn begin(&mut self, of: &SeriesOf) -> Result<()> {
        self.of = Some(of.clone());
        Ok(())
    }

    fn sample(&mut self, point: &SeriesPoint) -> Result<()> {
        self.points.extend([point.time.periods(), point.q[0], point.u[0]]);
        self.points.extend(point.gaps.as_flattened());
        Ok(())
    }

    fn event(&mut self, event: &StopEvent) -> Result<()> {
        self.events.push(*event);
        Ok(())
    }
}

/// Where a stop stands at an impact and how fast it moves is told in the scene's own time, whatever the
/// period.
#[test]
fn a_stop_moves_in_the_scenes_own_time() {
    let rest = "[system]\nperiod = 0.25\nmass = 2\ndamping = 3\nstiffness = 900\nforcing = [{ cos = 500 }]\n\
                [[stops]]\nside = \"upper\"\noffset = 0.25\nharmonics = [{ sin = 0.125 }]\nrestitution = 0.75\n\
                [[tasks]]\nname = \"m\"\nkind = \"simulate\"\nstart = { q = 0, u = 1 }\nperiods = 5\n";
    let scene = Scene::from_toml(&scene(rest), "s.toml").unwrap();
    let job = Job::new(&scene, &scene.tasks[0], Surroundings::default()).unwrap();
    let mut kept = Kept::default();
    run_task(&job, &mut kept);
    assert!(kept.events.len() > 3, "{:?}", kept.events);
    for event in &kept.events {
        let (sin, cos) = (std::f64::consts::TAU * event.time.periods()).sin_cos();
        let expected = [0.25 + 0.125 * sin, 0.125 * std::f64::consts::TAU / 0.25 * cos];
        for (told, expected) in event.place.unwrap().into_iter().zip(expected) {
            assert!((told - expected).abs() < 1e-9 * expected.abs().max(1.0), "{told} {expected} {event:?}");
        }
    }
}

/// The same scene by either engine: the same motion, and the same told of it, with the mass in its impulses.
#[test]
fn both_engines_read_one_grammar() {
    let rest = "[system]\nmass = 2\ndamping = 0.5\nstiffness = 1\ncubic = 0.25\nforce = \"0.1*u\"\nforcing = [{ cos = 3 }]\n\
                [[stops]]\nside = \"upper\"\noffset = 0.5\nharmonics = [{ sin = 0.25 }]\nrestitution = 0.75\n\
                [[tasks]]\nname = \"m\"\nkind = \"simulate\"\nstart = { q = 0, u = 1 }\nperiods = 3\n";
    let [(one, kept), (many, other)] = ["one", "many"].map(|engine| {
        let scene = Scene::from_toml(&scene(&format!("engine = \"{engine}\"\n{rest}")), "s.toml").unwrap();
        assert_eq!(matches!(scene.body, Body::Oscillator(_)), engine == "one");
        let job = Job::new(&scene, &scene.tasks[0], Surroundings::default()).unwrap();
        let mut kept = Kept::default();
        (serde_json::to_value(run_task(&job, &mut kept)).unwrap(), kept)
    });
    let near = |a: f64, b: f64, what: &str| assert!((a - b).abs() < 1e-8, "{what}: {a} {b}");
    for key in ["q", "u", "extent"] {
        let numbers = |report: &Value| -> Vec<f64> {
            report[key].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
        };
        assert_eq!(numbers(&one).len(), numbers(&many).len(), "{one} {many}");
        numbers(&one).iter().zip(numbers(&many)).for_each(|(a, b)| near(*a, b, key));
    }
    let (row, known) = (&one["stops"][0], &many["stops"][0]);
    assert!(row["impacts"].as_u64() > Some(2) && one["impacts"] == many["impacts"], "{one} {many}");
    for (name, value) in row.as_object().unwrap() {
        match value.as_f64() {
            Some(x) => near(x, known[name].as_f64().unwrap(), name),
            None => assert_eq!(value, &known[name], "{name}"),
        }
    }
    assert_eq!(kept.of, other.of);
    assert_eq!((kept.points.len(), kept.events.len()), (other.points.len(), other.events.len()));
    kept.points.iter().zip(&other.points).for_each(|(a, b)| near(*a, *b, "a point"));
    for (a, b) in kept.events.iter().zip(&other.events) {
        assert_eq!(
            (a.event, a.stop, a.together, a.order_matters),
            (b.event, b.stop, b.together, b.order_matters)
        );
        near(a.time.periods(), b.time.periods(), "time");
        let numbers = |event: &StopEvent| {
            [event.velocity, event.leaving, event.impulse, event.gap, event.rest, event.energy]
        };
        for (x, y) in numbers(a).into_iter().zip(numbers(b)) {
            assert_eq!(x.is_some(), y.is_some(), "{a:?} {b:?}");
            x.zip(y).into_iter().for_each(|(x, y)| near(x, y, a.event));
        }
        let place = |event: &StopEvent| event.place.unwrap();
        place(a).iter().zip(place(b)).for_each(|(x, y)| near(*x, y, "the stop's place"));
        // The impulse of one impact is the mass times what the velocity changes by.
        if let (Some(v), Some(w), Some(impulse)) = (a.velocity, a.leaving, a.impulse) {
            near(impulse, 2.0 * (w - v), "impulse");
        }
    }
}

/// A start has the scene's velocity at every frequency that is looked at, whatever the engine counts time in:
/// nothing damps, so that every point tells where the motion began.
#[test]
fn a_start_is_the_same_at_every_frequency() {
    let points = |engine: &str| -> Vec<f64> {
        let text = format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\nengine = {engine:?}\n[parameters]\nf = 4\n[system]\n\
             frequency = \"f\"\nstiffness = 401\nforcing = [{{ cos = 3 }}]\n"
        );
        let keys = "parameter = \"f\"\nrange = [3, 6]\ncount = 4\ntransient = 0\npoints = 3\n\
                    starts = [{ q = 0.3, u = 20 }]";
        let folder = tempfile::tempdir().unwrap();
        let (report, code, error) = tasks::run(&text, &[tasks::task("d", "diagram", keys)], folder.path());
        assert_eq!(code, 0, "{error} {report}");
        let rows = std::fs::read_to_string(folder.path().join("d.csv")).unwrap();
        let cells = rows.lines().skip(1).flat_map(|row| row.split(','));
        cells.filter_map(|cell| cell.parse().ok()).collect()
    };
    let [one, many] = ["one", "many"].map(points);
    assert!(one.len() == many.len() && one.len() == 24, "{one:?} {many:?}");
    for (x, y) in one.iter().zip(&many) {
        assert!((x - y).abs() <= 1e-9 * (1.0 + y.abs()), "{one:?} {many:?}");
    }
}
