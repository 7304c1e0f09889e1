//! What a run reports, every column of it, in one frame: the units, phases, sides and names of the scene that
//! a form was made from.

mod cells;

use std::collections::BTreeMap;

use cells::{Reader, axes, skeleton};

use grazing_scenes::{
    Result,
    run::{Job, Keeper, SeriesPoint, StopEvent, Surroundings, TaskReport, run_task},
    scene::Scene,
};
use serde_json::Value;
use toml::Table;

use super::{
    form,
    scene::{Unit, coordinates, is_machine, list, stops_key, text, with_names},
    scenes::NAME,
};

/// Columns that are not compared, and why.
pub const NOT_COMPARED: [(&str, &str); 33] = [
    ("task", "it is what rows are put together by"),
    ("kind", "it is in the scene"),
    ("place", "a line of the file"),
    ("engine", "forms are computed by either"),
    ("parameters", "as they stand in the scene"),
    ("effects", "work, not results: compared where the work is the same"),
    ("files", "nothing is kept"),
    ("certificates", "what the rows have, in words and in the units of a certificate"),
    ("residual", "what rounding left"),
    ("corner_gap", "what rounding left of 0"),
    ("distance", "what a search left of it"),
    ("newton_steps", "work"),
    ("searches", "work: starts are the engine's own; searches.rs compares both engines"),
    ("length", "of a curve whose metric is that of the form's unknowns"),
    ("points", "of such a curve"),
    ("minimum_depth", "a setting"),
    ("method", "work: the eigenvectors of one form or another"),
    ("condition", "of these eigenvectors"),
    ("oscillating", "of these modes"),
    ("grid", "as it stands in the scene"),
    ("plane", "as it stands in the scene"),
    ("varied", "as it stands in the scene"),
    ("width", "of an enclosure: `parameter` has its certain digits"),
    ("only_within", "the size of a box that the search chose"),
    ("first_impact", "the first of the events, which are compared"),
    (
        "seen",
        "not asked for: what attracts just beyond a touch may be chaotic; sweeps.rs compares two formats",
    ),
    ("hits", "of what is seen, and so not asked for"),
    ("influence", "not asked for: a form's parameters are not the scene's; touches.rs compares both engines"),
    ("in_words", "the numbers beside it, in sentences"),
    ("sentences", "the same"),
    ("bands_in_words", "one of these"),
    ("touch", "ends of an enclosure, by floats: `parameter` is compared"),
    ("touch_open", "engines know different machines: enclosed.rs compares both"),
];

/// Of proofs: texts of a file, and ends of enclosures that need not be the same to be true.
const OF_CERTIFICATES: [&str; 5] = ["certificate", "lower", "upper", "stability", "range_ends"];

/// How a form's report is read in the frame of the scene that it was made from.
#[derive(Debug, Clone)]
pub struct View {
    /// What a length, a time and a mass are in the form, if they are 1 in the scene.
    pub length: f64,
    pub time: f64,
    pub mass: f64,
    /// Whether displacements have the other sign.
    pub mirrored: bool,
    /// The time in the scene at which the form's is 0, as a fraction of the period.
    pub shift: f64,
    /// Periods of the scene in one of the form.
    pub rounds: f64,
    /// The form's names for the walls of the scene, in its order.
    pub walls: Vec<String>,
    /// The names of the form's walls, in its own order.
    pub own_walls: Vec<String>,
    /// The form's names for what rubs in the scene, in its order, and all its own.
    pub friction: Vec<String>,
    pub own_friction: Vec<String>,
    /// How long the form's rows of friction are, if those of the scene are 1.
    pub rubbing: f64,
    /// Whether the form's coordinates are those of `form::mixed`.
    pub mixed: bool,
    /// A wall of the form that is not the scene's.
    pub far: Option<String>,
    /// The form's names for the parameters of the scene.
    pub parameters: Vec<String>,
    /// Coordinates of the scene: further ones are not compared.
    pub coordinates: usize,
    /// Multipliers of further coordinates.
    pub further: Vec<[f64; 2]>,
    /// The scene's displacement and velocity where the form's are 0, by phase.
    pub moving: Vec<Moving>,
}

/// A term of what a form's displacements are counted from, per unit of the parameter F.
#[derive(Debug, Clone, Copy)]
pub struct Moving {
    pub k: f64,
    pub cos: f64,
    pub sin: f64,
}

impl View {
    /// The scene as it is.
    pub fn of(scene: &Table) -> View {
        let machine = is_machine(scene);
        let none = Vec::new();
        let walls = scene.get(stops_key(scene)).and_then(toml::Value::as_array).unwrap_or(&none);
        let key = if machine { "name" } else { "side" };
        let name = |(i, wall): (usize, &toml::Value)| {
            wall.get(key).and_then(toml::Value::as_str).map_or_else(|| format!("{}", i + 1), String::from)
        };
        let names: Vec<String> = walls.iter().enumerate().map(name).collect();
        let mut named = scene.clone();
        with_names(&mut named);
        let friction: Vec<String> =
            list(&mut named, "friction").map(|friction| text(&friction["name"])).collect();
        View {
            length: 1.0,
            time: 1.0,
            mass: 1.0,
            mirrored: false,
            shift: 0.0,
            rounds: 1.0,
            walls: names.clone(),
            own_walls: names,
            friction: friction.clone(),
            own_friction: friction,
            rubbing: 1.0,
            mixed: false,
            far: None,
            parameters: scene
                .get("parameters")
                .and_then(toml::Value::as_table)
                .map_or_else(Vec::new, |all| all.keys().cloned().collect()),
            coordinates: coordinates(scene),
            further: Vec::new(),
            moving: Vec::new(),
        }
    }

    fn in_units(&self, x: f64, Unit(length, time, mass): Unit) -> f64 {
        x / (self.length.powi(length) * self.time.powi(time) * self.mass.powi(mass))
    }

    fn signed(&self, x: f64, unit: Unit) -> f64 {
        self.in_units(if self.mirrored { -x } else { x }, unit)
    }

    /// The scene's displacements or velocities, of those that it has.
    fn state(&self, all: &[f64], unit: Unit) -> Vec<f64> {
        let mixed = |i: usize| match i.checked_sub(1).filter(|_| self.mixed) {
            Some(before) => all[i] + all[before] / 2.0,
            None => all[i],
        };
        (0..all.len().min(self.coordinates)).map(|i| self.signed(mixed(i), unit)).collect()
    }

    /// What rubs, by its place in the scene.
    fn rub(&self, name: &str) -> String {
        let place = self.friction.iter().position(|known| known == name);
        place.map_or_else(|| format!("unknown friction {name}"), |i| format!("friction {i}"))
    }

    /// What a motion's events are of, by the form's number of it: stops, then friction, then kinks.
    fn place(&self, number: usize) -> String {
        let (walls, friction) = (self.own_walls.len(), self.own_friction.len());
        match (self.own_walls.get(number), number.checked_sub(walls).and_then(|i| self.own_friction.get(i))) {
            (Some(wall), _) => self.wall(wall),
            (_, Some(name)) => self.rub(name),
            _ => format!("kink {}", number - walls - friction),
        }
    }

    /// A phase of the form as a fraction of the scene's period, from 0.
    fn phase(&self, x: f64) -> f64 {
        (x * self.rounds + self.shift).rem_euclid(1.0)
    }

    /// The wall's place in the scene.
    fn wall(&self, name: &str) -> String {
        match self.walls.iter().position(|wall| wall == name) {
            Some(i) => format!("wall {i}"),
            None if self.far.as_deref() == Some(name) => "far".into(),
            None => format!("unknown wall {name}"),
        }
    }
}

/// An impact of an orbit.
#[derive(Debug, Clone, PartialEq)]
pub struct Impact {
    /// A fraction of the period.
    pub phase: f64,
    /// Periods to the next impact.
    pub flight: f64,
    pub speed: f64,
    pub wall: String,
}

/// A number or word of a report.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    Number(f64, Unit),
    /// Modulo 1.
    Phase(f64),
    Word(String),
    /// In any order.
    Multipliers(Vec<[f64; 2]>),
    /// Of an orbit, whichever is called the first.
    Impacts(Vec<Impact>),
}

/// Cells by their columns.
pub type Row = BTreeMap<String, Cell>;

/// What is said of a task: its table "" has one row, of what is in no table.
pub type Answer = BTreeMap<String, Vec<Row>>;

/// A motion as it was kept.
#[derive(Default)]
struct Series {
    samples: Vec<(f64, Vec<f64>, Vec<f64>)>,
    events: Vec<StopEvent>,
}

impl Keeper for Series {
    fn sample(&mut self, sample: &SeriesPoint) -> Result<()> {
        self.samples.push((sample.time.periods(), sample.q.to_vec(), sample.u.to_vec()));
        Ok(())
    }

    fn event(&mut self, event: &StopEvent) -> Result<()> {
        self.events.push(*event);
        Ok(())
    }
}

/// What a scene's run reports of each task, and why others are refused, by their names.
pub struct Reports(pub Vec<Reported>, pub BTreeMap<String, String>);

impl Reports {
    /// Why a task is refused, in the words of the scene.
    pub fn refusal(&self, task: &str, view: &View) -> Option<String> {
        // Kinks are written in the form's own words, and of several rows of friction the first is told.
        let reason = self.1.get(task)?;
        let mut words = reason.clone();
        for what in ["a force has kinks (", "there is dry friction ("] {
            if let Some((before, after)) = words.split_once(what) {
                words = format!("{before}{}{}", &what[..what.len() - 2], closed(after));
            }
        }
        Some(skeleton(&words, view))
    }
}

/// What a run reports of a task.
pub struct Reported {
    pub report: TaskReport,
    series: Series,
}

impl Reported {
    /// Whether the motion without impacts has more harmonics than a machine's grazing is looked for in: a
    /// machine says so, and an oscillator integrates.
    pub fn many_harmonics(&self) -> bool {
        self.report.status.reason().unwrap_or_default().contains("too many harmonics")
    }

    /// Whether it is not decided to what some motion leads, as it is not settled.
    pub fn unsettled(&self) -> bool {
        self.report.status.reason().unwrap_or_default().contains("not settled")
    }

    /// Whether an event was not found within its reach.
    pub fn beyond_reach(&self) -> bool {
        let reason = self.report.status.reason().unwrap_or_default();
        ["event", "grazing"].contains(&self.report.kind) && reason.contains("beyond reach")
    }

    /// How many orbits a search found, of a task that tells it.
    pub fn orbits(&self) -> Option<u64> {
        let report = serde_json::to_value(&self.report).expect("a report");
        let orbits = report.get("orbits")?;
        orbits.as_u64().or(orbits.as_array().map(|all| all.len() as u64))
    }

    /// Times in periods and speeds of the impacts of a motion, as its format has them.
    pub fn impacts(&self) -> Vec<[f64; 2]> {
        let impact = |event: &StopEvent| {
            let speed = event.velocity.unwrap_or(0.0).abs();
            (event.event == "impact").then_some([event.time.periods(), speed])
        };
        self.series.events.iter().filter_map(impact).collect()
    }

    /// All that there is, but for what depends on where the task stands, as text.
    pub fn whole(&self) -> String {
        let TaskReport { task, status, findings, warnings, effects, .. } = &self.report;
        // As it prints itself, a failed task has its line.
        let status = (status.word(), status.reason());
        // Of a parameter that is written into the expressions it cannot be said that it stands in none.
        let warnings: Vec<_> = warnings.iter().filter(|text| !text.contains(" acts on nothing")).collect();
        format!("{task} {status:?} {findings:?} {warnings:?} {effects:?}")
    }
}

/// What follows the parenthesis that is open at first.
fn closed(text: &str) -> &str {
    let mut open = 1;
    let end = text.find(|c| {
        open += i32::from(c == '(') - i32::from(c == ')');
        open == 0
    });
    end.map_or("", |end| &text[end + 1..])
}

/// Why tasks are refused, each asked alone.
pub fn refusals(scene: &Table) -> BTreeMap<String, String> {
    let alone = |task: String| {
        let text = toml::to_string(&form::only(scene, &task)).expect("a table");
        let refusal = Scene::from_toml(&text, NAME).err()?.to_string();
        Some((task, refusal))
    };
    form::names(scene).into_iter().filter_map(alone).collect()
}

/// Runs all tasks; a scene is refused if one of them is, and so these are told by asking each alone.
///
/// # Errors
/// The refusal of a scene without tasks.
pub fn reports(text: &str, around: Surroundings) -> std::result::Result<Reports, String> {
    let mut refused = BTreeMap::new();
    let scene = Scene::from_toml(text, NAME).or_else(|_| {
        let table: Table = toml::from_str(text).expect("it was a table");
        refused = refusals(&table);
        let rest = form::without(&table, refused.keys());
        Scene::from_toml(&toml::to_string(&rest).expect("a table"), NAME)
    });
    let scene = scene.map_err(|error| error.to_string())?;
    let mut all = Vec::new();
    for task in &scene.tasks {
        let job = Job::new(&scene, task, around).map_err(|error| error.to_string())?;
        let mut series = Series::default();
        all.push(Reported { report: run_task(&job, &mut series), series });
    }
    Ok(Reports(all, refused))
}

/// How far the wall is that is never met.
pub const FAR: f64 = 1_048_576.0;

/// Which texts say the same in another form.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Texts {
    /// Their words, numbers apart.
    Words,
    /// That there is one.
    Presence,
}

/// A report in the frame of the scene.
pub fn answer(one: &Reported, view: &View, texts: Texts) -> Answer {
    let reader = Reader { view, texts, kind: one.report.kind };
    let whole = serde_json::to_value(&one.report).expect("a report");
    let mut tables = Answer::new();
    let mut head = Row::new();
    for (name, value) in whole.as_object().expect("an object") {
        let rows = value.as_array().filter(|all| all.first().is_some_and(Value::is_object) || is_table(name));
        match rows {
            Some(_) if NOT_COMPARED.iter().any(|(known, _)| known == name) => {}
            Some(rows) => {
                let rows = rows.iter().map(|row| reader.row(row)).filter(|row| !reader.is_far(row));
                let mut rows: Vec<Row> = rows.collect();
                // Kinks are written in the form's own words.
                if name == "kinks" {
                    (0..).zip(&mut rows).for_each(|(i, row): (usize, _)| {
                        row.insert("kink".into(), Cell::Word(format!("kink {i}")));
                    });
                }
                tables.insert(name.clone(), rows);
            }
            None => reader.cell(name, value, &whole, &mut head),
        }
    }
    // How much work it was differs, that there was some does not.
    if one.report.kind != "rest" {
        let worked = if one.report.effects.is_empty() { "none" } else { "counted" };
        head.insert("work".into(), Cell::Word(worked.into()));
    }
    if one.report.kind == "simulate" {
        reader.simulated(&whole, &mut head, &mut tables);
        reader.series(&one.series, &mut head, &mut tables);
    }
    reader.points(one, axes(&whole), &mut tables);
    tables.insert(String::new(), vec![head]);
    tables
}

/// Without the means over a finite time that are told of a motion that is not periodic: the vectors that are
/// followed have all coordinates of a form, also further ones.
pub fn without_means(answer: &mut Answer) {
    let null = Cell::Word("null".into());
    let rows = answer.get_mut("attractors").into_iter().flatten();
    for row in rows.filter(|row| row.get("period") == Some(&null)) {
        row.remove("lyapunov_per_period");
        row.remove("standard_error");
    }
    // Exponents that are means have an error.
    for row in answer.get_mut("exponents").into_iter().flatten() {
        if row.get("standard_error").is_some_and(|error| *error != null) {
            row.remove("per_period");
            row.remove("standard_error");
        }
    }
}

/// Without the rows of a response about coordinates that are not those of the scene.
pub fn without_mixed(answer: &mut Answer) {
    let is_mixed = |cell: &Cell| matches!(cell, Cell::Word(word) if word.starts_with('q') && word != "q1" || word.contains(" q") && !word.contains(" q1"));
    for rows in answer.values_mut() {
        rows.retain(|row| !["coordinate", "of"].iter().any(|name| row.get(*name).is_some_and(is_mixed)));
    }
}

/// Names of tables, empty or not.
fn is_table(name: &str) -> bool {
    ["orbits", "missing", "attractors", "further_orbits", "found", "without", "born", "basins", "windows"]
        .contains(&name)
        || [
            "coexisting",
            "starts",
            "labels",
            "proofs",
            "stops",
            "modes",
            "exponents",
            "friction",
            "kinks",
            "wear",
        ]
        .contains(&name)
}
