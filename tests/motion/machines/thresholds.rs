//! Thresholds of functions of the motion: closed forms, beside kinks, ends of runs, refusals.

use grazing_scenes::{
    Result,
    run::{Job, Keeper, SeriesOf, StopEvent, Surroundings, TaskReport, run_task},
};

use super::*;

/// Events as they come: word, place by its name, time in radians.
#[derive(Default)]
struct Kept {
    places: Vec<String>,
    events: Vec<(&'static str, String, f64)>,
}

impl Keeper for Kept {
    fn begin(&mut self, of: &SeriesOf) -> Result<()> {
        self.places = of.places();
        Ok(())
    }

    fn event(&mut self, event: &StopEvent) -> Result<()> {
        self.events.push((event.event, self.places[event.stop].clone(), TAU * event.time.periods()));
        Ok(())
    }
}

fn read(body: &str) -> Result<Scene> {
    Scene::from_toml(&format!("format = \"grazing-scene 3\"\ntitle = \"t\"\n{body}"), "t.toml")
}

/// What the one task of a scene tells.
fn told(body: &str) -> (TaskReport, Kept) {
    let scene = read(body).unwrap_or_else(|error| panic!("{error}"));
    let job = Job::new(&scene, &scene.tasks[0], Surroundings::default()).unwrap();
    let mut kept = Kept::default();
    (run_task(&job, &mut kept), kept)
}

const SYSTEM: &str = "[system]\nperiod = \"2*pi\"\nmass = 1\nstiffness = 1\n";
const TASK: &str = "[[tasks]]\nname = \"m\"\nkind = \"simulate\"\nstart = { q = 1 }\nperiods = 2\n";

fn event(of: &str) -> String {
    format!("[[events]]\nof = \"{of}\"\n")
}

/// q = cos t passes 1/2, qq′ = −sin(2t)/2 passes 1/4, its own copy does, and cos(t) passes 0, beside a stop
/// that is not met and friction without a force.
#[test]
fn crossings_are_where_closed_forms_have_them() {
    let beside = "[[stops]]\nname = \"far\"\noffset = -2\nrestitution = 1\n[[friction]]\nnormal = 0\ncoefficient = 1\n";
    let beside = format!("{beside}{TASK}");
    let events = [event("q - 1/2"), event("q*u - 1/4"), event("q*u - 1/4"), event("cos(t)")].concat();
    let (report, kept) = told(&format!("{SYSTEM}{events}{beside}"));
    let mut expected = Vec::new();
    let (up, down) = ("upcrossing", "downcrossing");
    for turn in [0.0, TAU] {
        let mut add =
            |word: &'static str, name: &str, t: f64| expected.push((word, name.to_string(), turn + t));
        add(down, "event 1", PI / 3.0);
        add(up, "event 1", 5.0 * PI / 3.0);
        add(down, "event 4", PI / 2.0);
        add(up, "event 4", 3.0 * PI / 2.0);
        for name in ["event 2", "event 3"] {
            for half in [0.0, PI] {
                add(up, name, half + 7.0 * PI / 12.0);
                add(down, name, half + 11.0 * PI / 12.0);
            }
        }
    }
    let mut found: Vec<_> =
        kept.events.iter().filter(|event| event.1.starts_with("event")).cloned().collect();
    let order = |a: &(&str, String, f64), b: &(&str, String, f64)| {
        (a.1.as_str(), a.2).partial_cmp(&(b.1.as_str(), b.2)).unwrap()
    };
    found.sort_by(order);
    expected.sort_by(order);
    assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
    for (one, known) in found.iter().zip(&expected) {
        assert!(
            (one.0, &one.1) == (known.0, &known.1) && (one.2 - known.2).abs() < 1e-11,
            "{one:?} {known:?}"
        );
    }
    let shown = report.to_string();
    assert!(shown.contains("far") && shown.contains("event 4") && !shown.contains("kinks"), "{shown}");
}

/// A kink of a force and a threshold of the same function are both told, each as its own.
#[test]
fn a_threshold_at_a_kink_is_told_beside_it() {
    let system = SYSTEM.replace("stiffness = 1", "force = \"-q - abs(q)/2\"");
    let (_, kept) = told(&format!("{system}{}{TASK}", event("q")));
    let times = |name: &str| -> Vec<f64> {
        kept.events.iter().filter(|event| event.1 == name).map(|event| event.2).collect()
    };
    let (kinks, own) = (times("abs(q)"), times("event"));
    assert!(kinks.len() > 2 && kinks.len() == own.len() && apart(&kinks, &own) < 1e-12, "{:?}", kept.events);
    // A quarter of the vibration under −3q/2, then halves.
    assert!((own[0] - PI / 2.0 / 1.5f64.sqrt()).abs() < 1e-12, "{own:?}");
}

#[test]
fn a_run_ends_where_a_threshold_says() {
    let (report, kept) = told(&format!("{SYSTEM}{}end = true\n{TASK}", event("q - 1/2")));
    assert_eq!(report.status.outcome().code(), 0, "{report}");
    assert_eq!(kept.events.len(), 1, "{:?}", kept.events);
    let shown = report.to_string();
    assert!(shown.contains("ended_at         0.1666666666") && shown.contains("0.5"), "{shown}");
}

#[test]
fn what_is_no_threshold_is_refused_with_its_place() {
    let orbit = "[[tasks]]\nname = \"o\"\nkind = \"orbit\"\norbit = { pattern = [] }\n";
    for (body, answers) in [
        (format!("{SYSTEM}{}{TASK}", event("1/2")), ["events[1].of", "passes 0 nowhere"]),
        (format!("{SYSTEM}{}{TASK}", event("q2")), ["events[1].of", "unknown parameter"]),
        (format!("{SYSTEM}{}{orbit}", event("q")), ["events", "`simulate`"]),
        (format!("engine = \"one\"\n{SYSTEM}{}{TASK}", event("q")), ["engine", "has events"]),
        (
            format!("{SYSTEM}{0}name = \"a\"\n{0}name = \"a\"\n{TASK}", event("q")),
            ["events[2].name", "earlier event"],
        ),
    ] {
        let error = read(&body).map(drop).unwrap_err().to_string();
        assert!(answers.iter().all(|answer| error.contains(answer)), "{answers:?}: {error}");
    }
}

/// Each attractor of a section with how often it passes a threshold: in closed form, also where that is at
/// the section's own phase; of a motion that hits, as `simulate` counts it.
#[test]
fn sections_say_how_often_attractors_pass() {
    let driven = "[system]\nmass = 1\nstiffness = 2\ndamping = 0.2\nforcing = [{ cos = 1 }]\n";
    let section = "[[tasks]]\nname = \"s\"\nkind = \"section\"\nstarts = [{ q = 0 }]\n";
    let rows = |body: &str| -> Vec<(u64, String, f64, f64)> {
        let value = serde_json::to_value(told(body).0).unwrap();
        let rows = value["events"].as_array().unwrap_or_else(|| panic!("{value}"));
        let row = |row: &serde_json::Value| {
            let number = |key: &str| row[key].as_f64().unwrap();
            let event = row["event"].as_str().unwrap().to_string();
            (row["attractor"].as_u64().unwrap(), event, number("up_per_period"), number("down_per_period"))
        };
        rows.iter().map(row).collect()
    };
    // q is 0.98 cos(t − φ).
    let known = [("q - 1/2", 1.0), ("q*u - 1/4", 2.0), ("q - 2", 0.0), ("sin(t)", 1.0), ("sin(3*t)", 3.0)];
    let events: String = known.iter().map(|(of, _)| event(of)).collect();
    let found = rows(&format!("{driven}{events}{section}"));
    assert_eq!(found.len(), known.len(), "{found:?}");
    for (i, (attractor, name, up, down)) in found.into_iter().enumerate() {
        assert_eq!((attractor, name), (1, format!("event {}", i + 1)));
        assert_eq!((up, down), (known[i].1, known[i].1), "{}", known[i].0);
    }
    // A machine that hits its stop in every period.
    let machine = "[system]\nmass = 1\ndamping = 0.1\nstiffness = 0.3\nforcing = [{ cos = 0.8 }]\n[[stops]]\nside = \"upper\"\n\
                offset = 1\nrestitution = 0.8\n";
    let event = event("q + 2");
    let start = "{ q = 0 }";
    let counted = rows(&format!(
        "{machine}{event}[[tasks]]\nname = \"s\"\nkind = \"section\"\nstarts = [{start}]\ntransient = 3000\n"
    ));
    let simulate = format!(
        "[[tasks]]\nname = \"m\"\nkind = \"simulate\"\nstart = {start}\ntransient = 3000\nperiods = 1000\n"
    );
    let (_, kept) = told(&format!("{machine}{event}{simulate}"));
    let seen = |word: &str| kept.events.iter().filter(|event| event.0 == word).count() as f64 / 1000.0;
    println!("{counted:?} {} {}", seen("upcrossing"), seen("downcrossing"));
    let (_, _, up, down) = &counted[0];
    assert!(seen("upcrossing") > 0.4 && (up - seen("upcrossing")).abs() < 2e-3, "{counted:?}");
    assert!((down - seen("downcrossing")).abs() < 2e-3, "{counted:?}");
}
