//! Digits of b_{n,k} against time.

use std::{io::Write, time::Duration};

use num_rational::BigRational;

use super::Args;
use crate::{
    cli::progress::{Interrupt, Progress},
    error::Result,
    figure::digits_table,
    local::Point,
    output::{Column, Destination, FileRegistry, TableCell, TableFormat, TableWriter},
    study::{FAMILIES, INPUTS, METHODS, digits_prices},
};

pub(super) fn measure(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<()> {
    let (count, bits, batch) = if args.quick {
        (3, 1024, Duration::from_micros(200))
    } else {
        (INPUTS, 4096, Duration::from_millis(2))
    };
    let progress = Progress::new(interrupt, FAMILIES.len() as u64 * METHODS, "measurements");
    let mut prices = Vec::new();
    for family in FAMILIES {
        prices.extend(digits_prices(family, count, bits, batch, &progress)?);
    }
    drop(progress);
    Destination::Stdout.write(|out| digits_table(&prices, TableFormat::Table, out))?;
    files.named(&args.output.join("digits.csv"))?.write(|out| digits_table(&prices, TableFormat::Csv, out))
}

/// Writes the inputs, for another program to find their values.
pub(super) fn write_points(out: &mut dyn Write) -> Result<()> {
    let names = ["family", "n", "k", "coordinates", "x", "y"];
    let columns = names.map(|name| Column::new(name, name, 0)).to_vec();
    let mut table = TableWriter::new(out, TableFormat::Csv, "", columns)?;
    for family in FAMILIES {
        for input in family.inputs(INPUTS) {
            let (coordinates, x, y) = match &input.point {
                Point::Polar(polar) => ("rs", polar.r(), polar.s()),
                Point::Plane(plane) => ("a1a2", plane.a1(), plane.a2()),
            };
            let fraction = |x: &BigRational| format!("{}/{}", x.numer(), x.denom());
            table.row(&[
                TableCell::Text(family.name()),
                TableCell::Int(input.n as i64),
                TableCell::Int(input.k as i64),
                TableCell::Text(coordinates),
                TableCell::Text(&fraction(x)),
                TableCell::Text(&fraction(y)),
            ])?;
        }
    }
    table.finish()
}
