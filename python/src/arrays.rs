//! What the findings of a task leave out of JSON, as NumPy arrays that take over the library's memory.

use std::collections::BTreeMap;

use grazing_scenes::{
    Result,
    one::attractor::map::{MapCell, MapEnd},
    run::{
        BasinsFindings, DiagramFindings, Findings, Job, Keeper, MapFindings, ResponseFindings, ResponseRow,
        SectionFindings, SectionSet, SeriesOf, SeriesPoint, StopEvent,
    },
};
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::{prelude::*, types::PyDict};

/// An array of a result: its numbers row by row, and the lengths of its axes.
pub enum Array {
    Floats(Vec<f64>, Vec<usize>),
    Whole(Vec<i64>, Vec<usize>),
}

/// All that is kept of a task beside its report: arrays and texts by name.
#[derive(Default)]
pub struct Data {
    pub arrays: BTreeMap<&'static str, Array>,
    /// Certificates: file and text.
    pub certificates: Vec<(String, String)>,
    /// Rows of a table, as JSON.
    pub rows: Option<String>,
}

impl Data {
    fn floats(&mut self, name: &'static str, numbers: Vec<f64>) {
        let shape = vec![numbers.len()];
        self.arrays.insert(name, Array::Floats(numbers, shape));
    }

    fn whole(&mut self, name: &'static str, numbers: Vec<i64>) {
        let shape = vec![numbers.len()];
        self.arrays.insert(name, Array::Whole(numbers, shape));
    }

    fn table(&mut self, name: &'static str, numbers: Vec<f64>, columns: usize) {
        let rows = numbers.len().checked_div(columns).unwrap_or(0);
        self.arrays.insert(name, Array::Floats(numbers, vec![rows, columns]));
    }

    /// As a dict: no number is copied.
    pub fn into_dict<'py>(self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (name, array) in self.arrays {
            match array {
                Array::Floats(numbers, shape) => {
                    dict.set_item(name, numbers.into_pyarray(py).reshape(shape)?)?;
                }
                Array::Whole(numbers, shape) => {
                    dict.set_item(name, numbers.into_pyarray(py).reshape(shape)?)?;
                }
            }
        }
        Ok(dict)
    }
}

/// Collects a task's series, events and findings.
#[derive(Default)]
pub struct Collector {
    pub data: Data,
    time: Vec<f64>,
    q: Vec<f64>,
    u: Vec<f64>,
    coordinates: usize,
    event_time: Vec<f64>,
    event_kind: Vec<i64>,
    event_place: Vec<i64>,
    event_value: Vec<f64>,
}

impl Collector {
    fn series(&mut self) {
        let take = std::mem::take::<Vec<f64>>;
        let width = self.coordinates;
        let (time, q, u) = (take(&mut self.time), take(&mut self.q), take(&mut self.u));
        self.data.floats("time", time);
        if width == 1 {
            self.data.floats("q", q);
            self.data.floats("u", u);
        } else {
            self.data.table("q", q, width);
            self.data.table("u", u, width);
        }
        let times = take(&mut self.event_time);
        self.data.floats("event_time", times);
        let values = take(&mut self.event_value);
        self.data.floats("event_value", values);
        let kinds = std::mem::take(&mut self.event_kind);
        self.data.whole("event_kind", kinds);
        let places = std::mem::take(&mut self.event_place);
        self.data.whole("event_place", places);
    }
}

impl Keeper for Collector {
    fn begin(&mut self, of: &SeriesOf) -> Result<()> {
        self.coordinates = of.points;
        Ok(())
    }

    fn sample(&mut self, sample: &SeriesPoint) -> Result<()> {
        self.time.push(sample.time.periods());
        self.q.extend(sample.q);
        self.u.extend(sample.u);
        Ok(())
    }

    fn event(&mut self, event: &StopEvent) -> Result<()> {
        let (kind, value) = match event.event {
            "impact" => (0, event.velocity),
            "tangency" => (1, event.gap),
            "stick" => (2, event.rest),
            "release" => (3, None),
            "reversal" => (5, None),
            "kink" => (6, None),
            "upcrossing" => (7, None),
            "downcrossing" => (8, None),
            _ => (4, event.velocity),
        };
        self.event_time.push(event.time.periods());
        self.event_kind.push(kind);
        self.event_place.push(event.stop as i64);
        self.event_value.push(value.unwrap_or(0.0));
        Ok(())
    }

    fn keep(&mut self, _: &Job, findings: &Findings) -> Result<Vec<String>> {
        let text = |rows: serde_json::Result<String>| rows.map_err(std::io::Error::other);
        let certificates = findings.certificates().into_iter();
        self.data.certificates =
            certificates.map(|one| (one.file.clone(), one.accepted.text().to_string())).collect();
        match findings {
            Findings::Simulation(_) => self.series(),
            Findings::Section(found) => section(found, &mut self.data),
            Findings::Basins(found) => basins(found, &mut self.data),
            Findings::Diagram(found) => diagram(found, &mut self.data),
            Findings::Response(found) => response(found, &mut self.data),
            Findings::Map(found) => map(found, &mut self.data),
            Findings::Branch(found) => self.data.rows = Some(text(serde_json::to_string(&found.rows))?),
            _ => {}
        }
        Ok(Vec::new())
    }
}

fn section(found: &SectionFindings, data: &mut Data) {
    let (mut points, mut attractor) = (Vec::new(), Vec::new());
    for (set, all) in &found.points {
        // Orbits count on below 0: the first is −1.
        let number = match set {
            SectionSet::Attractor(place) => *place as i64,
            SectionSet::Orbit(place) => -1 - *place as i64,
        };
        points.extend(all.iter().flatten());
        attractor.extend(all.iter().map(|_| number));
    }
    data.table("points", points, 2);
    data.whole("attractor", attractor);
}

fn basins(found: &BasinsFindings, data: &mut Data) {
    let grid = &found.grid;
    data.floats("q", (0..grid.columns).map(|column| grid.start(column, 0)[0]).collect());
    data.floats("u", (0..grid.rows).map(|row| grid.start(0, row)[1]).collect());
    let cells: Vec<i64> = found.cells.iter().map(|&cell| cell as i64).collect();
    data.arrays.insert("cells", Array::Whole(cells, vec![grid.rows, grid.columns]));
}

fn diagram(found: &DiagramFindings, data: &mut Data) {
    let (mut value, mut points, mut motion, mut period) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for slice in &found.slices {
        for (number, one) in slice.motions.iter().enumerate() {
            for point in &one.points {
                value.push(slice.value);
                points.extend(point);
                motion.push(number as i64);
                period.push(one.period.map_or(if one.undecided { -2 } else { 0 }, i64::from));
            }
        }
    }
    data.floats("value", value);
    data.table("points", points, 2);
    data.whole("motion", motion);
    data.whole("period", period);
}

/// The way of a row: 0 linear, 1 up, 2 down, 3 unstable; its coordinate or gap, counted from 0 as they come.
fn response(found: &ResponseFindings, data: &mut Data) {
    let mut names: Vec<&str> = Vec::new();
    let (mut way, mut coordinate) = (Vec::new(), Vec::new());
    for row in &found.rows {
        way.push(
            ["linear", "up", "down", "unstable"]
                .iter()
                .position(|word| *word == row.way)
                .map_or(-1, |i| i as i64),
        );
        let known = names.iter().position(|name| *name == row.coordinate);
        coordinate.push(known.unwrap_or(names.len()) as i64);
        if known.is_none() {
            names.push(&row.coordinate);
        }
    }
    data.whole("way", way);
    data.whole("coordinate", coordinate);
    let floats = |of: fn(&ResponseRow) -> f64| found.rows.iter().map(of).collect();
    data.floats("value", floats(|row| row.value));
    data.floats("swing", floats(|row| row.swing));
    data.floats("amplitude", floats(|row| row.amplitude));
    data.floats("lag", floats(|row| row.lag.unwrap_or(f64::NAN)));
    data.whole("period", found.rows.iter().map(|row| row.period.map_or(0, i64::from)).collect());
}

fn map(found: &MapFindings, data: &mut Data) {
    let [columns, rows] = &found.values;
    let shape = vec![rows.len(), columns.len()];
    data.floats("first", columns.clone());
    data.floats("second", rows.clone());
    let period = |cell: &MapCell| match cell.end {
        MapEnd::Periodic(period) => i64::from(period),
        MapEnd::NotPeriodic => 0,
        MapEnd::Unsettled => -2,
        _ => -1,
    };
    let cells = &found.cells;
    data.arrays.insert("period", Array::Whole(cells.iter().map(period).collect(), shape.clone()));
    let impacts = cells.iter().map(|cell| cell.impacts as i64).collect();
    data.arrays.insert("impacts", Array::Whole(impacts, shape.clone()));
    let exponents = cells.iter().map(|cell| cell.exponent.unwrap_or(f64::NAN)).collect();
    data.arrays.insert("exponent", Array::Floats(exponents, shape));
}
