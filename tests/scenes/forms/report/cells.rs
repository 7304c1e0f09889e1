//! The cells of a report, each in the frame of the scene: what a column's numbers and words mean.

use std::f64::consts::TAU;

use grazing_scenes::run::{Findings, ResponseRow, SectionSet, StopEvent};
use serde_json::Value;

use super::{
    super::scene::{LENGTH, ONE, SPEED, Unit},
    Answer, Cell, FAR, Impact, Moving, NOT_COMPARED, OF_CERTIFICATES, Reported, Row, Series, Texts, View,
};

/// Where a hint begins that engines have which know the machine for a linear one.
const HINT: &str = "; the motion without impacts touches ";

/// Reads a report's cells.
pub(super) struct Reader<'a> {
    pub view: &'a View,
    pub texts: Texts,
    pub kind: &'a str,
}

impl Reader<'_> {
    pub fn row(&self, row: &Value) -> Row {
        let mut cells = Row::new();
        for (name, value) in row.as_object().expect("a row") {
            self.cell(name, value, row, &mut cells);
        }
        cells
    }

    /// Whether the row is about a wall that the scene does not have.
    pub fn is_far(&self, row: &Row) -> bool {
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
    pub fn cell(&self, name: &str, value: &Value, row: &Value, cells: &mut Row) {
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
            // Where a linear machine is touched, a formula does not tell.
            (_, "reason") if value.as_str().is_some_and(|text| text.contains(HINT)) => {
                let (text, _) = value.as_str().expect("a text").split_once(HINT).expect("it is in it");
                self.text(name, &Value::from(text), cells);
            }
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
            ("rest", "warnings") => {}
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
            ("rest", "released" | "rested" | "stops" | "held" | "q" | "u") => {
                self.rested(name, value, row, cells);
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
            (_, "strongest" | "impulse") => self.number(name, value, Unit(1, -1, 1), cells),
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
    /// Of a motion that rests; its rests from the one that ends first in the scene's period on. Where that is
    /// not the form's first, and where it rests for ever, the form says its state at another time.
    fn rested(&self, name: &str, value: &Value, row: &Value, cells: &mut Row) {
        let released: Vec<f64> =
            numbers(&row["released"]).into_iter().map(|phase| self.view.phase(phase)).collect();
        let first = (0..released.len()).min_by(|&i, &j| released[i].total_cmp(&released[j])).unwrap_or(0);
        let turned = |i: usize| (i + released.len() - first) % released.len();
        let words = value.as_array().into_iter().flatten().filter_map(Value::as_str);
        match name {
            "released" | "rested" => {
                for (i, phase) in numbers(value).into_iter().enumerate() {
                    cells.insert(format!("{name} {}", turned(i)), Cell::Phase(self.view.phase(phase)));
                }
            }
            "stops" => {
                for (i, stop) in words.enumerate() {
                    cells.insert(format!("{name} {}", turned(i)), Cell::Word(self.view.wall(stop)));
                }
            }
            "held" => {
                let mut all: Vec<String> = words.map(|stop| self.view.wall(stop)).collect();
                all.sort_unstable();
                cells.insert(name.into(), Cell::Word(all.join(" ")));
            }
            _ if first > 0 || released.is_empty() => {}
            _ => {
                let unit = if name == "q" { LENGTH } else { SPEED };
                for (i, x) in self.view.state(&numbers(value), unit).into_iter().enumerate() {
                    let x = x + self.carried(name, released[0]);
                    cells.insert(format!("{name} {i}"), Cell::Number(x, unit));
                }
            }
        }
    }

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
                        "extent_before" | "extent_after" | "gap_before" | "gap_after" => {
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
    pub fn simulated(&self, whole: &Value, head: &mut Row, tables: &mut Answer) {
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
    pub fn series(&self, series: &Series, head: &mut Row, tables: &mut Answer) {
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
    pub fn points(&self, one: &Reported, axes: [Unit; 2], tables: &mut Answer) {
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
pub(super) fn axes(report: &Value) -> [Unit; 2] {
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
pub(super) fn skeleton(text: &str, view: &View) -> String {
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
