//! What accuracy costs in a simulation: time against error, both axes logarithmic; and the tables of that
//! study.

use std::io::Write;

use super::{
    FigurePlace,
    canvas::{At, BLUE, COLUMN, Canvas, Colour, GREEN, GREY, ORANGE, RED, Stroke, Words, line},
    frame::{Axis, PlotFrame, power},
    legend::Legend,
    panels::{duration, sample},
};
use crate::{
    error::Result,
    motion::Effect,
    output::{Column, TableCell, TableFormat, TableWriter, write_file},
    study::{
        effects::EffectCost,
        flow_accuracy::{FlowMeasured, LongRun},
    },
};

/// Writes the picture and its data.
///
/// # Errors
/// An I/O error.
pub fn flow_accuracy(rows: &[FlowMeasured], place: &FigurePlace) -> Result<()> {
    let shown: Vec<Shown> = rows.iter().map(Shown::from).collect();
    place.draw(&draw(&shown))?;
    write_file(&place.data(), |out| flow_table(rows, TableFormat::Csv, out))
}

fn columns(names: &[&'static str]) -> Vec<Column> {
    names.iter().map(|name| Column::new(name, name, 8)).collect()
}

/// Writes the table of times and errors.
///
/// # Errors
/// An I/O error from `out`.
pub fn flow_table(rows: &[FlowMeasured], format: TableFormat, out: &mut dyn Write) -> Result<()> {
    let names = ["oscillator", "method", "time_ns", "error", "energy_error"];
    let mut table = TableWriter::new(out, format, "grazing-flow-accuracy 1", columns(&names))?;
    for row in rows {
        let method = row.tolerance.map_or("closed form".to_string(), |tolerance| format!("{tolerance:.0e}"));
        table.row(&[
            TableCell::Text(row.name),
            TableCell::Text(&method),
            TableCell::Int(row.time.as_nanos() as i64),
            TableCell::Text(&format!("{:.1e}", row.error)),
            TableCell::Text(&row.energy.map_or(String::new(), |energy| format!("{energy:.1e}"))),
        ])?;
    }
    table.finish()
}

/// Writes the table of long runs.
///
/// # Errors
/// An I/O error from `out`.
pub fn long_runs_table(rows: &[LongRun], format: TableFormat, out: &mut dyn Write) -> Result<()> {
    let names = ["motion", "periods", "distance", "energy_error"];
    let mut table = TableWriter::new(out, format, "grazing-long-runs 1", columns(&names))?;
    for row in rows {
        table.row(&[
            TableCell::Text(row.name),
            TableCell::Int(row.periods),
            TableCell::Text(&format!("{:.1e}", row.distance)),
            TableCell::Text(&row.energy.map_or(String::new(), |energy| format!("{energy:.1e}"))),
        ])?;
    }
    table.finish()
}

/// Writes the table of what effects cost: time and evaluations of a period.
///
/// # Errors
/// An I/O error from `out`.
pub fn effects_table(
    rows: &[EffectCost<{ Effect::ALL.len() }>],
    format: TableFormat,
    out: &mut dyn Write,
) -> Result<()> {
    costs("grazing-effects 1", &Effect::ALL, rows, format, out)
}

/// The same of machines.
///
/// # Errors
/// An I/O error from `out`.
pub fn machine_effects_table(
    rows: &[EffectCost<{ Effect::OF_MACHINES.len() }>],
    format: TableFormat,
    out: &mut dyn Write,
) -> Result<()> {
    costs("grazing-machine-effects 1", &Effect::OF_MACHINES, rows, format, out)
}

fn costs<const N: usize>(
    name: &'static str,
    effects: &[Effect; N],
    rows: &[EffectCost<N>],
    format: TableFormat,
    out: &mut dyn Write,
) -> Result<()> {
    let names: Vec<&str> = ["effect", "time_ns", "impacts"]
        .into_iter()
        .chain(effects.iter().map(|effect| effect.name()))
        .collect();
    let mut table = TableWriter::new(out, format, name, columns(&names))?;
    for row in rows {
        let per_period = |count: u64| format!("{}", count as f64 / row.periods as f64);
        let mut cells = vec![row.name.to_string(), row.time.as_nanos().to_string(), per_period(row.impacts)];
        cells.extend(row.counts.map(per_period));
        table.row(&cells.iter().map(|cell| TableCell::Text(cell)).collect::<Vec<_>>())?;
    }
    table.finish()
}

/// What is drawn of a measurement.
struct Shown {
    name: String,
    integrated: bool,
    /// Nanoseconds.
    time: f64,
    error: f64,
}

impl From<&FlowMeasured> for Shown {
    fn from(row: &FlowMeasured) -> Shown {
        Shown {
            name: row.name.into(),
            integrated: row.tolerance.is_some(),
            time: row.time.as_nanos() as f64,
            // As the table has it.
            error: format!("{:.1e}", row.error).parse().unwrap_or(row.error),
        }
    }
}

const COLOURS: [Colour; 4] = [GREEN, BLUE, ORANGE, RED];
/// An error of 0 has a column of its own, left of a broken line, here: logarithms.
const NONE: f64 = -18.0;
const BREAK: f64 = -17.2;

fn draw(rows: &[Shown]) -> Canvas {
    let mut names: Vec<&str> = rows.iter().map(|row| row.name.as_str()).collect();
    names.dedup();
    let mut legend = Legend::default();
    for (name, ink) in names.iter().zip(COLOURS.into_iter().cycle()) {
        legend.add(Words::plain(name), move |canvas: &mut Canvas, at: At| sample(canvas, at, ink));
    }
    if rows.iter().any(|row| !row.integrated) {
        legend.add("closed form", |canvas: &mut Canvas, at: At| canvas.disc(at, 2.4, line(GREY, 0.9)));
    }
    let high = legend.height(COLUMN - 8.0);
    let mut canvas = Canvas::new(
        COLUMN,
        176.0 + high,
        "What accuracy costs in a simulation: error against time",
        "Time of a forcing period over the error after ten, both logarithmic, a line per oscillator: the integrator \
         with tolerances from 1e-3, on the right, to 1e-13. Rings are closed forms.",
    );
    let of = |pick: fn(&Shown) -> f64| rows.iter().map(pick).filter(|x| *x > 0.0).map(f64::log10);
    let worst = of(|row| row.error).fold(-16.0, f64::max).ceil();
    let (fastest, slowest) =
        of(|row| row.time).fold((9.0, 0.0), |(a, b): (f64, f64), t| (a.min(t), b.max(t)));
    let (fastest, slowest) = (fastest.floor() as i32, slowest.ceil() as i32);
    let exact = rows.iter().any(|row| row.error == 0.0);
    let least = if exact { -18.8 } else { -16.0 };
    let mut errors: Vec<(f64, Words)> = if exact { vec![(NONE, "0".into())] } else { Vec::new() };
    errors.extend((-16..=worst as i32).step_by(4).map(|e| (f64::from(e), power(e))));
    let times = (fastest..=slowest).map(|e| (f64::from(e), Words::plain(&duration(e)))).collect();
    let frame = PlotFrame::new(
        [2.0, 2.0, COLUMN - 4.0, 174.0],
        Axis::marked("error after ten periods", (least, worst + 0.4), true, errors),
        Axis::marked("time per period", (f64::from(fastest), f64::from(slowest)), true, times),
    );
    if exact {
        let ends = [fastest, slowest].map(|e| (10f64.powf(BREAK), 10f64.powi(e)));
        canvas.line(frame.path(ends), Stroke { dashes: Some([2.0, 2.0]), ..line(GREY, 0.4) });
    }
    for (&name, ink) in names.iter().zip(COLOURS.into_iter().cycle()) {
        let of = |integrated: bool| -> Vec<At> {
            let of = rows.iter().filter(|row| row.name == name && row.integrated == integrated);
            of.map(|row| frame.at((row.error.max(10f64.powf(NONE)), row.time))).collect()
        };
        canvas.line(of(true), line(ink, 0.8));
        canvas.discs(of(true), 1.4, ink);
        canvas.discs(of(false), 2.4, line(ink, 0.9));
    }
    frame.draw(&mut canvas);
    legend.draw(&mut canvas, (4.0, 175.0), COLUMN - 8.0);
    canvas
}

#[cfg(test)]
mod tests {
    use super::{super::assert_shows_its_table, Shown, draw};

    #[test]
    fn the_checked_in_picture_shows_the_checked_in_table() {
        let row = |row: &csv::StringRecord| Shown {
            name: row[0].into(),
            integrated: &row[1] != "closed form",
            time: row[2].parse().unwrap(),
            error: row[3].parse().unwrap(),
        };
        assert_shows_its_table("flow-accuracy", row, draw);
    }
}
