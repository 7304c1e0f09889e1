//! What accuracy costs in a simulation: time against error, both axes logarithmic; and the tables of that
//! study.

use std::{fs, io::Write, path::Path};

use plotters::prelude::*;

use crate::{
    error::{Error, Result},
    oscillator::Effect,
    output::{Column, TableCell, TableFormat, TableWriter, write_file},
    study::{
        effects::{EffectCost, PERIODS},
        flow_accuracy::{FlowMeasured, LongRun},
    },
};

/// Writes `flow-accuracy.svg` and `flow-accuracy.csv` into `folder`.
///
/// # Errors
/// An I/O error.
pub fn flow_accuracy(rows: &[FlowMeasured], folder: &Path) -> Result<()> {
    let picture = draw(rows).map_err(|error| Error::from(std::io::Error::other(error.to_string())))?;
    fs::create_dir_all(folder).map_err(|error| Error::io("create", folder, error))?;
    write_file(&folder.join("flow-accuracy.svg"), |out| Ok(out.write_all(picture.as_bytes())?))?;
    write_file(&folder.join("flow-accuracy.csv"), |out| flow_table(rows, TableFormat::Csv, out))
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
pub fn effects_table(rows: &[EffectCost], format: TableFormat, out: &mut dyn Write) -> Result<()> {
    let names: Vec<&str> =
        ["effect", "time_ns", "impacts"].into_iter().chain(Effect::ALL.map(Effect::name)).collect();
    let mut table = TableWriter::new(out, format, "grazing-effects 1", columns(&names))?;
    for row in rows {
        let per_period = |count: u64| format!("{}", count as f64 / PERIODS as f64);
        let mut cells = vec![row.name.to_string(), row.time.as_nanos().to_string(), per_period(row.impacts)];
        cells.extend(row.counts.map(per_period));
        table.row(&cells.iter().map(|cell| TableCell::Text(cell)).collect::<Vec<_>>())?;
    }
    table.finish()
}

const COLOURS: [RGBColor; 4] =
    [RGBColor(0, 158, 115), RGBColor(0, 114, 178), RGBColor(230, 159, 0), RGBColor(213, 94, 0)];
/// Where an error of 0 is drawn.
const LEAST: f64 = 1e-17;

fn draw(rows: &[FlowMeasured]) -> std::result::Result<String, Box<dyn std::error::Error>> {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, (860, 600)).into_drawing_area();
    root.fill(&WHITE)?;
    let times = rows.iter().map(|row| row.time.as_nanos() as f64);
    let (fastest, slowest) = times.fold((f64::MAX, 1.0f64), |(low, high), t| (low.min(t), high.max(t)));
    let errors = rows.iter().map(|row| row.error.max(LEAST));
    let worst = errors.fold(LEAST, f64::max);
    let mut chart = ChartBuilder::on(&root)
        .margin(20)
        .margin_top(60)
        .x_label_area_size(52)
        .y_label_area_size(84)
        .build_cartesian_2d((LEAST..worst * 10.0).log_scale(), (fastest / 2.0..slowest * 3.0).log_scale())?;
    let duration = |ns: &f64| match *ns {
        ns if ns < 1e3 => format!("{ns:.0} ns"),
        ns if ns < 1e6 => format!("{:.0} µs", ns / 1e3),
        ns => format!("{:.0} ms", ns / 1e6),
    };
    chart
        .configure_mesh()
        .light_line_style(RGBColor(240, 240, 240))
        .bold_line_style(RGBColor(215, 215, 215))
        .x_desc("error after ten periods")
        .y_desc("time of a period")
        .x_label_formatter(&|error| format!("{error:.0e}"))
        .y_label_formatter(&duration)
        .label_style(("sans-serif", 14))
        .axis_desc_style(("sans-serif", 16))
        .draw()?;
    let mut names: Vec<&'static str> = rows.iter().map(|row| row.name).collect();
    names.dedup();
    for (name, colour) in names.into_iter().zip(COLOURS.into_iter().cycle()) {
        let place = |row: &FlowMeasured| (row.error.max(LEAST), row.time.as_nanos() as f64);
        let of = |integrated: bool| {
            rows.iter()
                .filter(move |row| row.name == name && row.tolerance.is_some() == integrated)
                .map(place)
        };
        chart
            .draw_series(LineSeries::new(of(true), colour.stroke_width(2)))?
            .label(name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 22, y)], colour.stroke_width(3)));
        chart.draw_series(of(true).map(|at| Circle::new(at, 4, colour.filled())))?;
        chart.draw_series(of(false).map(|at| Circle::new(at, 7, colour.stroke_width(3))))?;
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::LowerRight)
        .background_style(WHITE.mix(0.9))
        .border_style(RGBColor(200, 200, 200))
        .label_font(("sans-serif", 15))
        .draw()?;
    root.draw(&Text::new(
        "What accuracy costs: simulation, error against time",
        (84, 10),
        ("sans-serif", 18),
    ))?;
    let key = "○ closed form;   lines: integrator, tolerances 1e-3 (right) to 1e-13 (left)";
    root.draw(&Text::new(key, (84, 36), ("sans-serif", 13)))?;
    root.present()?;
    drop(chart);
    drop(root);
    Ok(svg)
}
