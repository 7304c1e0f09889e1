//! What accuracy costs: time against certain digits, both axes logarithmic.

use std::{fs, io::Write, path::Path};

use plotters::prelude::*;

use crate::{
    error::{Error, Result},
    local::Rung,
    output::{Column, TableCell, TableFormat, TableWriter, write_file},
    study::{Evaluation, FAMILIES, Measured},
};

/// Writes `accuracy.svg` and `accuracy.csv` into `folder`.
///
/// # Errors
/// An I/O error.
pub fn accuracy_figure(rows: &[Measured], folder: &Path) -> Result<()> {
    fs::create_dir_all(folder).map_err(|error| Error::io("create", folder, error))?;
    let picture = draw(rows).map_err(|error| Error::from(std::io::Error::other(error.to_string())))?;
    write_file(&folder.join("accuracy.svg"), |out| Ok(out.write_all(picture.as_bytes())?))?;
    write_file(&folder.join("accuracy.csv"), |out| accuracy_table(rows, TableFormat::Csv, out))
}

/// Writes the table behind the figure.
///
/// # Errors
/// An I/O error from `out`.
pub fn accuracy_table(rows: &[Measured], format: TableFormat, out: &mut dyn Write) -> Result<()> {
    let columns = [
        "family",
        "rung",
        "time_ns",
        "digits",
        "log10_width",
        "bits_lost",
        "log10_condition",
        "decided",
        "wrong",
        "inputs",
    ]
    .map(|name| Column::new(name, name, name.len()));
    let mut table = TableWriter::new(out, format, "grazing-accuracy 1", columns.to_vec())?;
    for row in rows {
        let number =
            |x: Option<f64>| x.filter(|x| x.is_finite()).map_or(String::new(), |x| format!("{x:.1}"));
        let (digits, width, condition) = (number(row.digits), number(row.width), number(Some(row.condition)));
        table.row(&[
            TableCell::Text(row.family.name()),
            TableCell::Text(&method(row.method)),
            TableCell::Int(row.time.as_nanos() as i64),
            TableCell::Text(&digits),
            TableCell::Text(&width),
            row.lost.map_or(TableCell::Empty, |lost| TableCell::Int(lost as i64)),
            TableCell::Text(&condition),
            TableCell::Int(row.decided as i64),
            TableCell::Int(row.wrong as i64),
            TableCell::Int(row.inputs as i64),
        ])?;
    }
    table.finish()
}

fn method(method: Evaluation) -> String {
    match method {
        Evaluation::Naive => "f64, naive".into(),
        Evaluation::Rung(Rung::Plain) => "f64".into(),
        Evaluation::Rung(Rung::Interval) => "f64 interval".into(),
        Evaluation::Rung(Rung::Ball(bits)) => format!("{bits} bits"),
        Evaluation::Rung(Rung::Exact) => "exact".into(),
    }
}

const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 0, 0),
    RGBColor(0, 114, 178),
    RGBColor(86, 180, 233),
    RGBColor(204, 121, 167),
    RGBColor(213, 94, 0),
    RGBColor(230, 159, 0),
    RGBColor(0, 158, 115),
];

fn draw(rows: &[Measured]) -> std::result::Result<String, Box<dyn std::error::Error>> {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, (860, 600)).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root)
        .margin(20)
        .margin_top(60)
        .x_label_area_size(52)
        .y_label_area_size(84)
        .build_cartesian_2d((0.8f64..8000.0).log_scale(), (10f64..1e9).log_scale())?;
    let duration = |ns: &f64| match *ns {
        ns if ns < 1e3 => format!("{ns:.0} ns"),
        ns if ns < 1e6 => format!("{:.0} µs", ns / 1e3),
        ns if ns < 1e9 => format!("{:.0} ms", ns / 1e6),
        ns => format!("{:.0} s", ns / 1e9),
    };
    chart
        .configure_mesh()
        .light_line_style(RGBColor(240, 240, 240))
        .bold_line_style(RGBColor(215, 215, 215))
        .x_desc("certain decimal digits of b_{n,k}")
        .y_desc("time of one evaluation")
        .x_label_formatter(&|digits| format!("{digits:.0}"))
        .y_label_formatter(&duration)
        .label_style(("sans-serif", 14))
        .axis_desc_style(("sans-serif", 16))
        .draw()?;
    for (family, colour) in FAMILIES.into_iter().zip(COLOURS) {
        let of_family = || rows.iter().filter(move |row| row.family == family);
        // Less than one digit is drawn at the left edge.
        let place = |row: &Measured| Some((row.digits?.max(0.8), row.time.as_nanos() as f64));
        let enclosed =
            |row: &&Measured| !matches!(row.method, Evaluation::Naive | Evaluation::Rung(Rung::Plain));
        let line: Vec<(f64, f64)> = of_family().filter(enclosed).filter_map(place).collect();
        chart
            .draw_series(LineSeries::new(line.iter().copied(), colour.stroke_width(2)))?
            .label(family.name())
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 22, y)], colour.stroke_width(3)));
        chart.draw_series(line.into_iter().map(|at| Circle::new(at, 4, colour.filled())))?;
        let plain = |method| of_family().filter(move |row| row.method == method).filter_map(place);
        chart.draw_series(
            plain(Evaluation::Rung(Rung::Plain)).map(|at| Circle::new(at, 5, colour.stroke_width(2))),
        )?;
        chart.draw_series(plain(Evaluation::Naive).map(|at| Cross::new(at, 5, colour.stroke_width(2))))?;
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .background_style(WHITE.mix(0.9))
        .border_style(RGBColor(200, 200, 200))
        .label_font(("sans-serif", 15))
        .draw()?;
    root.draw(&Text::new(
        "What accuracy costs: b_{n,k} by rung and family of inputs",
        (84, 10),
        ("sans-serif", 18),
    ))?;
    let key = "lines: f64 interval, then 128, 256, 1024, 4096, 16384 bits;   ○ plain f64, ✕ naive formula: digits that happen to be right";
    root.draw(&Text::new(key, (84, 36), ("sans-serif", 13)))?;
    root.present()?;
    drop(chart);
    drop(root);
    Ok(svg)
}
