//! What a run reports, every column of it, in one frame: the units, phases, sides and names of the scene that
//! a form was made from.

use std::{collections::BTreeMap, f64::consts::TAU};

use grazing::{
    Result,
    run::{
        Findings, Job, Keeper, ResponseRow, SectionSet, SeriesPoint, StopEvent, Surroundings, TaskReport,
        run_task,
    },
    scene::Scene,
};
use serde_json::Value;
use toml::Table;

use super::{
    form,
    scene::{LENGTH, ONE, SPEED, Unit, coordinates, is_machine, list, stops_key, text, with_names},
    scenes::NAME,
};

/// Columns that are not compared, and why.
pub const NOT_COMPARED: [(&str, &str); 27] = [
    ("task", "it is what rows are put together by"),
    ("kind", "it is in the scene"),
    ("place", "a line of the file"),
    ("engine", "forms are computed by either"),
    ("parameters", "as they stand in the scene"),
    ("effects", "work, not results: compared where the work is the same"),
    ("files", "nothing is kept"),
    ("residual", "what rounding left"),
    ("corner_gap", "what rounding left of 0"),
    ("distance", "what a search left of it"),
    ("newton_steps", "work"),
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
];

/// Of proofs: texts of a file, and ends of enclosures that need not be the same to be true.
const OF_CERTIFICATES: [&str; 6] =
    ["certificate", "no_certificate", "lower", "upper", "stability", "range_ends"];

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
    let worked = if one.report.effects.is_empty() { "none" } else { "counted" };
    head.insert("work".into(), Cell::Word(worked.into()));
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

struct Reader<'a> {
    view: &'a View,
    texts: Texts,
    kind: &'a str,
}

impl Reader<'_> {
    fn row(&self, row: &Value) -> Row {
        let mut cells = Row::new();
        for (name, value) in row.as_object().expect("a row") {
            self.cell(name, value, row, &mut cells);
        }
        cells
    }

    /// Whether the row is about a wall that the scene does not have.
    fn is_far(&self, row: &Row) -> bool {
        row.get("stop") == Some(&Cell::Word("far".into()))
    }

    fn number(&self, name: &str, value: &Value, unit: Unit, cells: &mut Row) {
        let Some(x) = value.as_f64() else { return self.word(name, value, cells) };
        cells.insert(name.into(), Cell::Number(self.view.in_units(x, unit), unit));
    }

    fn word(&self, name: &str, value: &Value, cells: &mut Row) {
        let word = value.as_str().map_or_else(|| value.to_string(), String::from);
        cells.insert(name.into(), Cell::Word(word));
    }

    fn text(&self, name: &str, value: &Value, cells: &mut Row) {
        let word = match (self.texts, value.as_str()) {
            (_, None) => value.to_string(),
            (Texts::Presence, Some(_)) => "a text".into(),
            (Texts::Words, Some(text)) => skeleton(text, self.view),
        };
        cells.insert(name.into(), Cell::Word(word));
    }

    /// A column, or several, of a row.
    fn cell(&self, name: &str, value: &Value, row: &Value, cells: &mut Row) {
        let view = self.view;
        if NOT_COMPARED.iter().any(|(known, _)| *known == name) {
            return;
        }
        match (self.kind, name) {
            // Format 1 says it but for the tangency.
            ("event", "admissible")
                if self.texts == Texts::Presence && row.get("acceleration").is_some_and(|x| !x.is_null()) => {
            }
            ("validate", "status" | "verdict")
                if self.texts == Texts::Presence && value.as_str() == Some("refuted") =>
            {
                self.word(name, &Value::from("undecided"), cells);
            }
            ("validate" | "branch", name) if OF_CERTIFICATES.contains(&name) => {}
            // Why a proof of a part of a branch goes no further tells of the checker's boxes.
            ("branch", "reason") if row.get("verdict").is_some() => {}
            ("validate", "phases" | "speeds" | "solution") => self.enclosed(name, value, cells),
            ("validate", "trace" | "det" | "parameter") | (_, "entropy") => {
                let number = value.as_str().and_then(|digits| digits.parse::<f64>().ok());
                self.number(name, &number.map_or(Value::Null, Value::from), ONE, cells);
            }
            (_, "pattern" | "orbit") if row.get("phases").is_none_or(Value::is_null) => {
                let Some(text) = value.as_str() else { return self.word(name, value, cells) };
                let mut strikes = self.strikes(text);
                strikes.sort();
                let walls: Vec<String> = strikes.iter().map(|(_, wall)| wall.clone()).collect();
                let periods: u32 = strikes.iter().map(|(periods, _)| periods).sum();
                // In halves the map of two walls counts either of them.
                cells.insert(name.into(), Cell::Word(format!("{periods} periods, {walls:?}")));
            }
            (_, "pattern" | "speeds") if row.get("phases").is_some_and(|all| !all.is_null()) => {}
            (_, "speeds") => {
                let mut all: Vec<f64> =
                    numbers(value).iter().map(|&speed| view.in_units(speed, SPEED)).collect();
                all.sort_by(f64::total_cmp);
                for (i, speed) in all.into_iter().enumerate() {
                    cells.insert(format!("speeds {i}"), Cell::Number(speed, SPEED));
                }
            }
            (_, "phases") if value.is_array() => {
                cells.insert("impacts".into(), Cell::Impacts(self.impacts(row)));
            }
            (_, "multipliers" | "eigenvalues") if value.is_array() => {
                let all: Vec<&Value> = value.as_array().expect("a list").iter().collect();
                cells.insert("multipliers".into(), self.multipliers(&all));
            }
            (_, "A") => self.matrix(value, cells),
            (_, "B" | "C") => self.vector(name, value, cells),
            ("section", "chaos") => self.word(name, value, cells),
            (_, "chaos") if value.is_array() => {
                for (i, side) in value.as_array().into_iter().flatten().enumerate() {
                    for (column, cell) in self.row(side) {
                        cells.insert(format!("chaos {i} {column}"), cell);
                    }
                }
            }
            (
                _,
                "reason" | "side" | "backward" | "forward" | "open" | "chaos_open" | "label" | "warnings",
            ) => match value.as_array() {
                Some(all) => {
                    (0..).zip(all).for_each(|(i, text)| self.text(&format!("{name} {i}"), text, cells))
                }
                None => self.text(name, value, cells),
            },
            (_, "stop" | "next_stop" | "nearest_stop") => match value.as_str() {
                Some(wall) if name == "nearest_stop" && view.far.as_deref() == Some(wall) => {
                    self.word(name, &Value::Null, cells);
                }
                Some(wall) => drop(cells.insert(name.into(), Cell::Word(view.wall(wall)))),
                None => self.word(name, value, cells),
            },
            (_, "parameter") if value.is_string() => {
                let word = skeleton(value.as_str().expect("a text"), view);
                cells.insert(name.into(), Cell::Word(word));
            }
            ("rest", "released" | "rested") => {
                for (i, phase) in numbers(value).into_iter().enumerate() {
                    cells.insert(format!("{name} {i}"), Cell::Phase(view.phase(phase)));
                }
            }
            ("rest", "stops") => {
                for (i, stop) in value.as_array().into_iter().flatten().filter_map(Value::as_str).enumerate()
                {
                    cells.insert(format!("{name} {i}"), Cell::Word(view.wall(stop)));
                }
            }
            ("response", "coordinate") => {
                let of = self.displacement(value.as_str().expect("a name"));
                if of.is_none() {
                    cells.insert("stop".into(), Cell::Word("far".into()));
                }
                cells.insert(name.into(), Cell::Word(of.unwrap_or_default()));
            }
            ("response", "sweep") if value.is_object() => self.sweep(value, cells),
            ("response", "amplitude" | "swing") => self.number(name, value, LENGTH, cells),
            ("response", "lag") => match value.as_f64() {
                Some(lag) => {
                    let gap = row["coordinate"].as_str().is_some_and(|name| name.starts_with("gap "));
                    let turned = if view.mirrored && !gap { 0.5 } else { 0.0 };
                    cells.insert(name.into(), Cell::Phase(view.phase(lag + turned)));
                }
                None => self.word(name, value, cells),
            },
            (_, "phase" | "next_phase") => match value.as_f64() {
                Some(phase) => drop(cells.insert(name.into(), Cell::Phase(view.phase(phase)))),
                None => self.word(name, value, cells),
            },
            ("simulate", "q" | "u" | "extent" | "impacts" | "tangencies" | "rests" | "stops") => {
                // In `simulated`, but for rows of stops.
                if row.get("stop").is_some() {
                    self.number(name, value, ONE, cells);
                }
            }
            ("simulate", "ended_at") => {}
            ("crisis", "corner_q" | "corner_u") => match value.as_f64() {
                Some(x) => {
                    let unit = if name == "corner_q" { LENGTH } else { SPEED };
                    cells.insert(name.into(), Cell::Number(self.view.signed(x, unit), unit));
                }
                None => self.word(name, value, cells),
            },
            ("crisis", "offset") => self.number(name, value, LENGTH, cells),
            ("chaos", "range") => self.text(name, value, cells),
            // An upper wall is told as a lower one, and that it is.
            ("chaos", "oscillator") if value.is_string() => {
                let normal = value.as_str().expect("a text").replace(", turned below by q -> -q", "");
                cells.insert(name.into(), Cell::Word(normal));
            }
            ("basins", "q") => self.at_start(name, value, LENGTH, cells),
            ("basins", "u") => self.at_start(name, value, SPEED, cells),
            (_, "parameter") | (_, "value" | "found_at" | "start" | "from" | "to") if value.is_f64() => {
                self.number(name, value, ONE, cells);
            }
            (_, "parameters") => {}
            (_, "measured") if value.is_object() => {
                for (key, one) in value.as_object().into_iter().flatten() {
                    self.cell(&format!("{name} {key}"), one, &Value::Null, cells);
                }
            }
            (_, "measured gap_change") => self.number(name, value, LENGTH, cells),
            (_, "acceleration") => self.number(name, value, Unit(1, -2, 0), cells),
            // What the further coordinate loses, where nothing else of the motion is left.
            (_, "lyapunov_per_period")
                if !view.further.is_empty()
                    && value.as_f64().is_some_and(|x| (x + 1.5 * TAU).abs() < 1e-9) =>
            {
                self.word(name, &Value::Null, cells);
            }
            ("simulate", "friction") => match value.as_str() {
                Some(rubs) => drop(cells.insert(name.into(), Cell::Word(view.rub(rubs)))),
                None => self.word(name, value, cells),
            },
            (_, "path") => {
                let length = value.as_f64().map_or(Value::Null, |x| Value::from(x / view.rubbing));
                self.number(name, &length, LENGTH, cells);
            }
            (_, "volume") => self.number(name, value, Unit(3, 0, 0), cells),
            ("simulate", "rate") => self.number(name, value, Unit(3, -1, 0), cells),
            (_, "least_gap") => self.gap(name, value, cells),
            (_, "e" | "largest_gap") => self.number(name, value, LENGTH, cells),
            (_, "fastest") => self.number(name, value, SPEED, cells),
            (_, "peak_force") => self.number(name, value, Unit(1, -2, 1), cells),
            (_, "strongest") => self.number(name, value, Unit(1, -1, 1), cells),
            (_, "longest") => self.number(name, value, Unit(0, 1, 0), cells),
            (_, "dissipated") => self.number(name, value, Unit(2, -2, 1), cells),
            (_, "gamma" | "period") if value.is_f64() => self.number(name, value, Unit(0, 1, 0), cells),
            (_, "frequency") => self.number(name, value, Unit(0, -1, 0), cells),
            (_, _) if value.is_f64() => self.number(name, value, ONE, cells),
            (_, _) if value.is_array() => {
                for (i, one) in value.as_array().into_iter().flatten().enumerate() {
                    self.cell(&format!("{name} {i}"), one, &Value::Null, cells);
                }
            }
            _ => self.word(name, value, cells),
        }
        // The parameters of a point, under the name of one.
        if name == "parameters" {
            for (i, one) in value.as_array().into_iter().flatten().enumerate() {
                self.number(&format!("parameter {i}"), one, ONE, cells);
            }
        }
    }

    /// What is seen as a parameter goes up and down, the columns of all rows one after the other.
    fn sweep(&self, value: &Value, cells: &mut Row) {
        for (table, rows) in value.as_object().into_iter().flatten() {
            for (i, row) in rows.as_array().into_iter().flatten().enumerate() {
                let Some(columns) = row.as_object() else {
                    self.number(&format!("{table} {i}"), row, ONE, cells);
                    continue;
                };
                for (column, value) in columns {
                    let name = format!("{table} {i} {column}");
                    match &**column {
                        "extent_before" | "extent_after" => {
                            let ends = numbers(value);
                            let width = ends.last().zip(ends.first()).map(|(to, from)| to - from);
                            self.number(&name, &width.map_or(Value::Null, Value::from), LENGTH, cells);
                        }
                        "speed_before" | "speed_after" => self.number(&name, value, SPEED, cells),
                        _ if value.is_f64() => self.number(&name, value, ONE, cells),
                        _ => self.word(&name, value, cells),
                    }
                }
            }
        }
    }

    /// A coordinate, or the gap of a wall, as the scene calls it, if the scene has it.
    fn displacement(&self, name: &str) -> Option<String> {
        match name.strip_prefix("gap ") {
            Some(wall) => {
                (self.view.far.as_deref() != Some(wall)).then(|| format!("gap {}", self.view.wall(wall)))
            }
            None if name == "q" => Some("q1".into()),
            None => name[1..].parse().is_ok_and(|i: usize| i <= self.view.coordinates).then(|| name.into()),
        }
    }

    /// A displacement or velocity where the form's phase is 0.
    fn at_start(&self, name: &str, value: &Value, unit: Unit, cells: &mut Row) {
        match value.as_f64() {
            Some(x) => {
                let x = self.view.signed(x, unit) + self.carried(name, self.view.shift);
                cells.insert(name.into(), Cell::Number(x, unit));
            }
            None => self.word(name, value, cells),
        }
    }

    /// Phases and speeds of a proof, numbers or digits.
    fn enclosed(&self, name: &str, value: &Value, cells: &mut Row) {
        let numbers: Vec<f64> = numbers(value);
        for (i, &x) in numbers.iter().enumerate() {
            let is_phase = name == "phases" || name == "solution" && i % 2 == 0;
            let cell = match is_phase {
                _ if name == "solution" && i + 1 == numbers.len() && i % 2 == 0 => Cell::Number(x, ONE),
                true => Cell::Phase(self.view.phase(x)),
                false => Cell::Number(self.view.in_units(x, SPEED), SPEED),
            };
            cells.insert(format!("{name} {i}"), cell);
        }
    }

    /// The periods and walls of a pattern; of an orbit without impacts its period.
    fn strikes(&self, pattern: &str) -> Vec<(u32, String)> {
        let strike = |text: &str| {
            if let Some(period) = text.strip_prefix("free ") {
                return (period.parse().expect("a period"), "free".to_string());
            }
            let (periods, wall) = text.split_once(' ').unwrap_or((text, ""));
            // Without a name: the only wall.
            let wall = match wall {
                "" => self.view.wall(self.view.walls.first().map_or("", String::as_str)),
                name => self.view.wall(name),
            };
            (periods.parse().unwrap_or_else(|_| panic!("{pattern}: no pattern")), wall)
        };
        pattern.split(',').map(strike).collect()
    }

    fn impacts(&self, row: &Value) -> Vec<Impact> {
        let phases: Vec<f64> = numbers(&row["phases"]);
        let speeds = numbers(&row["speeds"]);
        let strikes = self.strikes(row["pattern"].as_str().expect("a pattern"));
        (0..phases.len())
            .map(|i| {
                let next = phases[(i + 1) % phases.len()];
                let (periods, wall) = strikes.get(i % strikes.len()).cloned().expect("a strike");
                Impact {
                    phase: self.view.phase(phases[i]),
                    flight: (f64::from(periods) + next - phases[i]) * self.view.rounds,
                    speed: self.view.in_units(speeds[i], SPEED),
                    wall,
                }
            })
            .collect()
    }

    fn multipliers(&self, all: &[&Value]) -> Cell {
        let mut all: Vec<[f64; 2]> =
            all.iter().filter_map(|pair| Some([pair.get(0)?.as_f64()?, pair.get(1)?.as_f64()?])).collect();
        for further in &self.view.further {
            let far = |x: &[f64; 2]| (x[0] - further[0]).hypot(x[1] - further[1]);
            let nearest = (0..all.len()).min_by(|&i, &j| far(&all[i]).total_cmp(&far(&all[j])));
            if let Some(i) = nearest.filter(|&i| far(&all[i]) <= 1e-6 * further[0].hypot(further[1])) {
                all.remove(i);
            }
        }
        Cell::Multipliers(all)
    }

    /// A map in displacements, then velocities.
    fn matrix(&self, value: &Value, cells: &mut Row) {
        let rows: Vec<Vec<f64>> = value.as_array().into_iter().flatten().map(numbers).collect();
        let n = rows.len() / 2;
        let kept = |i: usize| i % n < self.view.coordinates;
        for (i, row) in rows.iter().enumerate().filter(|(i, _)| kept(*i)) {
            for (j, &x) in row.iter().enumerate().filter(|(j, _)| kept(*j)) {
                let unit = Unit(0, i32::from(j >= n) - i32::from(i >= n), 0);
                let name = format!("matrix {} {}", entry(i, n), entry(j, n));
                cells.insert(name, Cell::Number(self.view.in_units(x, unit), unit));
            }
        }
    }

    /// B, which takes the root of a length, or C.
    fn vector(&self, name: &str, value: &Value, cells: &mut Row) {
        let all = numbers(value);
        let n = all.len() / 2;
        for (i, &x) in all.iter().enumerate().filter(|(i, _)| i % n < self.view.coordinates) {
            let time = i32::from(i >= n) * if name == "B" { -1 } else { 1 };
            let root = if name == "B" { self.view.length.sqrt() } else { 1.0 };
            let x = self.view.signed(x / root, Unit(0, time, 0));
            cells.insert(format!("{name} {}", entry(i, n)), Cell::Number(x, Unit(0, time, 0)));
        }
    }

    /// The gap to a wall that the scene does not have says nothing.
    fn gap(&self, name: &str, value: &Value, cells: &mut Row) {
        let far = self.view.far.is_some() && value.as_f64().is_some_and(|gap| gap > 0.5 * FAR);
        self.number(name, if far { &Value::Null } else { value }, LENGTH, cells);
    }

    /// Counts, without those of a stop that is never met, and the last state.
    fn simulated(&self, whole: &Value, head: &mut Row, tables: &mut Answer) {
        for (name, unit) in [("q", LENGTH), ("u", SPEED)] {
            let all = self.view.state(&numbers(&whole[name]), unit);
            for (i, x) in all.into_iter().enumerate() {
                let x = x + self.carried(name, self.view.shift);
                head.insert(format!("{name} {i}"), Cell::Number(x, unit));
            }
        }
        for name in ["impacts", "tangencies", "rests"] {
            let stops = whole["stops"].as_array();
            let sum = |all: &Vec<Value>| all.iter().filter_map(|stop| stop[name].as_u64()).sum();
            let count = stops.map_or_else(|| whole[name].as_u64().unwrap_or(0), sum);
            head.insert(name.into(), Cell::Word(count.to_string()));
        }
        if self.view.coordinates != 1 || self.texts == Texts::Words {
            return;
        }
        // The engine `one` has no modes of formulas.
        tables.remove("modes");
    }

    /// What displacements and velocities of a moving frame lack, at a phase of the scene.
    fn carried(&self, name: &str, phase: f64) -> f64 {
        let term = |&Moving { k, cos, sin }: &Moving| {
            let (s, c) = (TAU * k * phase).sin_cos();
            if name == "q" { cos * c + sin * s } else { k * (sin * c - cos * s) }
        };
        self.view.moving.iter().map(term).sum()
    }

    /// Samples and events of a motion, times counted from its beginning.
    fn series(&self, series: &Series, head: &mut Row, tables: &mut Answer) {
        let from = series.samples.first().map_or(0.0, |sample| sample.0);
        let since = |time: f64| (time - from) * self.view.rounds;
        let mut samples = Vec::new();
        for (time, q, u) in &series.samples {
            let phase = since(*time) + self.view.shift;
            let mut row = Row::from([("time".to_string(), Cell::Number(since(*time), ONE))]);
            for (name, unit, all) in [("q", LENGTH, q), ("u", SPEED, u)] {
                for (i, x) in self.view.state(all, unit).into_iter().enumerate() {
                    let x = x + self.carried(name, phase);
                    row.insert(format!("{name} {i}"), Cell::Number(x, unit));
                }
            }
            samples.push(row);
        }
        let last = samples.last().and_then(|row: &Row| row.get("time").cloned());
        head.extend(last.map(|time| ("ended_at".to_string(), time)));
        tables.insert("samples".into(), samples);
        let mut events: Vec<(f64, String, &StopEvent)> = series
            .events
            .iter()
            .map(|event| (event.time.periods(), self.view.place(event.stop), event))
            .collect();
        // What changes at one instant is told in the order of the form's rows.
        let rubs = |event: &StopEvent| event.stop >= self.view.own_walls.len();
        events
            .chunk_by_mut(|(s, _, one), (t, _, other)| s == t && rubs(one) && rubs(other))
            .for_each(|all| all.sort_by(|(_, a, _), (_, b, _)| a.cmp(b)));
        let row = |(time, place, event): (f64, String, &StopEvent)| {
            let mut row = Row::from([
                ("event".to_string(), Cell::Word(format!("{} {place}", event.event))),
                ("time".to_string(), Cell::Number(since(time), ONE)),
            ]);
            let mut put = |name: &str, x: Option<f64>, unit: Unit| {
                if let Some(x) = x {
                    row.insert(name.into(), Cell::Number(self.view.in_units(x, unit), unit));
                }
            };
            put("speed", event.velocity.or(Some(0.0)), SPEED);
            put("leaving", event.leaving, SPEED);
            put("impulse", event.impulse, Unit(1, -1, 1));
            put("duration", event.duration, Unit(0, 1, 0));
            put("force", event.force, Unit(1, -2, 1));
            put("energy", event.energy, Unit(2, -2, 1));
            row
        };
        let events = events.into_iter().map(row).collect();
        tables.insert("events".into(), events);
    }

    /// Points on the section of periodic motions, and the ends of all starts of a grid.
    fn points(&self, one: &Reported, axes: [Unit; 2], tables: &mut Answer) {
        let at = |x: f64, unit: Unit, phase: f64| {
            let carried = self.carried(if unit == LENGTH { "q" } else { "u" }, phase);
            Cell::Number(self.view.signed(x, unit) + carried, unit)
        };
        let point = |set: String, [x, y]: [f64; 2], phase: f64| {
            Row::from([
                ("of".to_string(), Cell::Word(set)),
                ("q".to_string(), at(x, axes[0], phase)),
                ("u".to_string(), at(y, axes[1], phase)),
            ])
        };
        match &one.report.findings {
            Some(Findings::Section(found)) => {
                let mut rows = Vec::new();
                for (set, points) in &found.points {
                    let SectionSet::Attractor(i) = set else { continue };
                    let Some(period) = found.attractors[*i].period else { continue };
                    let set = format!("period {}", period as f64 * self.view.rounds);
                    rows.extend(points.iter().map(|&at| point(set.clone(), at, self.view.shift)));
                }
                tables.insert("points".into(), rows);
            }
            Some(Findings::Diagram(found)) => {
                let mut rows = Vec::new();
                for slice in &found.slices {
                    for motion in slice.motions.iter().filter(|motion| motion.period.is_some()) {
                        let set = format!("{} {:?}", slice.value, motion.period);
                        rows.extend(motion.points.iter().map(|&at| point(set.clone(), at, self.view.shift)));
                    }
                }
                tables.insert("points".into(), rows);
            }
            Some(Findings::Response(found)) => {
                let row = |row: &ResponseRow| {
                    let of = format!("{} {} {}", row.way, row.value, self.displacement(&row.coordinate)?);
                    let swing = Cell::Number(self.view.in_units(row.swing, LENGTH), LENGTH);
                    Some(Row::from([("of".to_string(), Cell::Word(of)), ("swing".to_string(), swing)]))
                };
                tables.insert("points".into(), found.rows.iter().filter_map(row).collect());
            }
            Some(Findings::Basins(found)) => {
                let end = |i: &usize| {
                    let row = &found.basins[*i];
                    format!("{} {:?} {:?}", row.end, row.period, row.impacts)
                };
                let mut ends: Vec<String> = found.cells.iter().map(end).collect();
                if self.view.mirrored {
                    ends.reverse();
                }
                let row = |(i, end): (usize, String)| Row::from([(format!("end {i}"), Cell::Word(end))]);
                let all = ends.into_iter().enumerate().flat_map(row).collect();
                tables.insert("cells".into(), vec![all]);
            }
            _ => {}
        }
    }
}

/// What the two numbers of points are: displacements and velocities, unless the plane says otherwise.
fn axes(report: &Value) -> [Unit; 2] {
    let names = report["plane"].as_array().into_iter().flatten().filter_map(Value::as_str);
    let units: Vec<Unit> = names
        .map(|name| if name.starts_with('u') || name.starts_with("rate ") { SPEED } else { LENGTH })
        .collect();
    units.try_into().unwrap_or([LENGTH, SPEED])
}

fn entry(i: usize, n: usize) -> String {
    format!("{}{}", if i < n { 'q' } else { 'u' }, i % n + 1)
}

/// Numbers of a list, also as digits.
fn numbers(value: &Value) -> Vec<f64> {
    let number = |value: &Value| value.as_f64().or_else(|| value.as_str()?.parse().ok());
    value.as_array().into_iter().flatten().filter_map(number).collect()
}

/// A text without its numbers, walls and parameters by their places.
fn skeleton(text: &str, view: &View) -> String {
    let named: Vec<&String> = view.walls.iter().chain(&view.parameters).chain(&view.friction).collect();
    // What friction without a name is called is a word of every sentence about it.
    let named: Vec<&String> = named.into_iter().filter(|name| !name.starts_with("friction")).collect();
    let mut out = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let boundary = out.chars().last().is_none_or(|c| !c.is_alphanumeric());
        let wall = named.iter().position(|wall| {
            boundary
                && rest
                    .strip_prefix(wall.as_str())
                    .is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric()))
        });
        if let Some(i) = wall {
            out += &format!("name{i}");
            rest = &rest[named[i].len()..];
        } else if c.is_ascii_digit() && boundary {
            let end =
                rest.find(|c: char| !c.is_ascii_alphanumeric() && !".+-".contains(c)).unwrap_or(rest.len());
            out.push('#');
            rest = &rest[end..];
        } else {
            if c != '-' || !rest[1..].starts_with(|c: char| c.is_ascii_digit()) {
                out.push(c);
            }
            rest = &rest[c.len_utf8()..];
        }
    }
    // Patterns of format 1 name the upper wall only.
    for i in 0..named.len() {
        out = out.replace(&format!("# name{i}"), "#");
    }
    out
}
