//! One question asked by several tasks, and one motion from several starts: a touch and a fold have one place
//! each, whether a diagram, a response, a branch, an event or a grazing tells it, with any number of values,
//! in either engine; and what a motion leads to is what it leads to some periods later.

use grazing_scenes::{
    run::{Surroundings, run},
    scene::Scene,
};
use serde_json::Value;

use super::draw::Random;
use crate::samples::samples;

/// Places of one thing differ by no more than this part.
const PLACE: f64 = 1e-9;

/// q″ + c q′ + k q = F cos t below a stop at 1, with a period of its own.
struct Machine {
    damping: f64,
    stiffness: f64,
    restitution: f64,
    engine: &'static str,
    /// In units of 1/2π of its period.
    radian: f64,
}

impl Machine {
    /// By an engine and with a clock that go with its number.
    fn drawn(random: &mut Random, i: u32) -> Machine {
        let mut between = |low: f64, high: f64| low + (high - low) * random.part();
        let (damping, restitution) = (between(0.05, 0.3), between(0.4, 0.9));
        let stiffness = if between(0.0, 1.0) < 0.5 { between(0.15, 0.6) } else { between(1.8, 4.5) };
        Machine {
            damping,
            stiffness,
            restitution,
            engine: ["one", "many"][i as usize % 2],
            radian: if i.is_multiple_of(3) { 1.0 } else { 6.0 / std::f64::consts::TAU },
        }
    }

    /// Where the free motion touches: a formula.
    fn touch(&self) -> f64 {
        (self.stiffness - 1.0).hypot(self.damping)
    }

    /// What tasks report.
    fn reports(&self, drive: f64, tasks: &str) -> Vec<Value> {
        let r = self.radian;
        let period = if r == 1.0 { "\"2*pi\"".to_string() } else { "6".to_string() };
        let text = format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\nengine = {:?}\n[parameters]\nF = {drive:?}\n[system]\nperiod = {period}\n\
             damping = {:?}\nstiffness = {:?}\nforcing = [{{ cos = \"F*{:?}\" }}]\n[[stops]]\nside = \"upper\"\noffset = 1\n\
             restitution = {:?}\n{tasks}",
            self.engine,
            self.damping / r,
            self.stiffness / (r * r),
            1.0 / (r * r),
            self.restitution
        );
        let scene = Scene::from_toml(&text, "t.toml").unwrap_or_else(|error| panic!("{error}\n{text}"));
        let reports =
            run(&scene, Surroundings::default(), &mut ()).unwrap_or_else(|error| panic!("{error}\n{text}"));
        reports.iter().map(|report| serde_json::to_value(report).unwrap()).collect()
    }
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("no number: {value}"))
}

/// The parameters of the labels of a kind on the branches of a report.
fn labelled(branch: &Value, kind: &str) -> Vec<f64> {
    let rows = branch["labels"].as_array().unwrap_or_else(|| panic!("{branch}")).iter();
    rows.filter(|row| row["label"].as_str().is_some_and(|label| label.starts_with(kind)))
        .map(|row| number(&row["parameters"][0]))
        .collect()
}

/// Whether a motion with one impact a period ends at a fold, going down.
fn is_fold(jump: &Value) -> bool {
    jump["ends"] == "saddle-node" && jump["sweep"] == "down" && jump["before"] == "period 1, 1 impact"
}

#[test]
fn a_touch_and_a_fold_have_one_place_in_all_tasks() {
    let mut random = Random(21);
    let (mut jumped, mut folded, drawn) = (0, 0, samples(2));
    for i in 0..drawn {
        let machine = Machine::drawn(&mut random, i);
        let (touch, count) = (machine.touch(), 3 + (9.0 * random.part()) as u32);
        let (low, high) = (0.6 * touch, touch * (1.1 + 0.4 * random.part()));
        let at = touch * (0.9 + 0.08 * random.part());
        let sweep = format!(
            "[[tasks]]\nname = \"sweep\"\nkind = \"diagram\"\nparameter = \"F\"\nrange = [{low:?}, {high:?}]\ncount = {count}\n\
             starts = [{{ q = 0 }}]\nsweep = \"both\"\npoints = 20\n"
        );
        let tasks = format!(
            "{sweep}[[tasks]]\nname = \"grazing\"\nkind = \"grazing\"\nparameter = \"F\"\nmax_period = 2\nrange = false\n\
             reach = 0.5\n\
             [[tasks]]\nname = \"event\"\nkind = \"event\"\nevent = \"grazing\"\nparameter = \"F\"\nreach = 0.5\norbit = {{}}\n\
             [[tasks]]\nname = \"branch\"\nkind = \"branch\"\nparameter = \"F\"\nrange = [{low:?}, {high:?}]\nstarts = [{{ orbit = {{}} }}]\n\
             [[tasks]]\nname = \"response\"\nkind = \"response\"\nparameter = \"F\"\nrange = [{low:?}, {high:?}]\ncount = {}\n",
            count + 2
        );
        let found = machine.reports(at, &tasks);
        let told = |what: &str, place: f64| {
            assert!((place / touch - 1.0).abs() <= PLACE, "{what}: {place} for {touch}, drawn {i}");
        };
        told("grazing", number(&found[1]["parameter"]));
        told("event", number(&found[2]["found"][0]["parameter"]));
        let labels = labelled(&found[3], "grazing");
        assert_eq!(labels.len(), 1, "the branch goes past the touch: {}, drawn {i}", found[3]);
        told("branch", labels[0]);
        let of = |report: &Value| {
            report["sweep"]["jumps"].as_array().unwrap_or_else(|| panic!("{report}")).clone()
        };
        let jumps = [of(&found[0]), of(&found[4])].concat();
        for jump in jumps.iter().filter(|jump| jump["ends"] == "grazing" && jump["sweep"] == "up") {
            told("stays", number(&jump["stays"]));
            told("left", number(&jump["left"]));
            jumped += 1;
        }
        // Where the motion that hits ends, going down: the fold of its branch.
        for jump in jumps.iter().filter(|jump| is_fold(jump)) {
            let stays = number(&jump["stays"]);
            let event = "[[tasks]]\nname = \"fold\"\nkind = \"event\"\nevent = \"saddle-node\"\nparameter = \"F\"\nreach = 2\n\
                         orbit = { pattern = [1] }\n";
            let all = &machine.reports(stays * 1.02, event)[0];
            let places = all["found"]
                .as_array()
                .map_or(Vec::new(), |all| all.iter().map(|e| number(&e["parameter"])).collect());
            let near = places.iter().map(|place| (place / stays - 1.0).abs()).fold(f64::INFINITY, f64::min);
            assert!(near <= 1e-8, "{stays} for {places:?}, drawn {i}");
            folded += 1;
        }
    }
    assert!(jumped > 0 && (folded > 0 || drawn < 4), "{jumped} and {folded} of the drawn machines jump");
}

/// From any state that a motion passes the motion leads to the same.
#[test]
fn a_motion_leads_where_it_leads_some_periods_later() {
    let mut random = Random(22);
    for i in 0..samples(4) {
        let machine = Machine::drawn(&mut random, i);
        let drive = machine.touch() * (0.7 + 0.6 * random.part());
        let mut between = |low: f64, high: f64| low + (high - low) * random.part();
        let start = [between(-2.0, 0.9), between(-2.0, 2.0)];
        let periods = 1 + (6.0 * random.part()) as u32;
        let section = |[q, u]: [f64; 2]| {
            format!(
                "[[tasks]]\nname = \"section\"\nkind = \"section\"\nstarts = [{{ q = {q:?}, u = {u:?} }}]\npoints = 50\n"
            )
        };
        let run = format!(
            "{}[[tasks]]\nname = \"run\"\nkind = \"simulate\"\nstart = {{ q = {:?}, u = {:?} }}\nperiods = {periods}\n",
            section(start),
            start[0],
            start[1]
        );
        let first = machine.reports(drive, &run);
        let later = [&first[1]["q"], &first[1]["u"]].map(|x| number(if x.is_array() { &x[0] } else { x }));
        let then = &machine.reports(drive, &section(later))[0];
        let told = |report: &Value| {
            let all = report["attractors"].as_array().unwrap();
            assert_eq!(all.len(), 1, "{report}");
            (all[0]["periodic"].clone(), all[0]["period"].clone(), all[0]["impacts"].clone())
        };
        assert_eq!(told(&first[0]), told(then), "{periods} periods from {start:?}, drawn {i} at {drive}");
    }
}
