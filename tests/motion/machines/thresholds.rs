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
