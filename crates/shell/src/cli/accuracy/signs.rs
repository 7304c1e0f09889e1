//! The price of a sign.

use std::{io::Write, time::Duration};

use num_rational::BigRational;

use super::Args;
use crate::{
    cli::progress::{Interrupt, Progress},
    error::Result,
    figure::sign_price_table,
    local::{Ladder, Point, Quantity},
    monitor::Monitor,
    output::{Column, Destination, FileRegistry, TableCell, TableFormat, TableWriter},
    study::{DISTANCES, QUICK_DISTANCES, SignMethod, SignPrice, ZERO_FAMILIES, sign_prices},
};

/// The distances, and how many places of each family.
fn extent(args: &Args) -> (&'static [u32], usize) {
    if args.quick { (&QUICK_DISTANCES, 4) } else { (&DISTANCES, 8) }
}

pub(super) fn measure(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<()> {
    let (distances, count) = extent(args);
    let batch = Duration::from_micros(if args.quick { 200 } else { 1000 });
    // Twelve methods at each distance and at 0.
    let steps = ZERO_FAMILIES.len() as u64 * (distances.len() as u64 + 1) * 12;
    let progress = Progress::new(interrupt, steps, "measurements");
    let mut prices = Vec::new();
    for family in ZERO_FAMILIES {
        prices.extend(sign_prices(family, distances, count, batch, &progress)?);
    }
    // Of all the methods, the one that every command uses: the file has hundreds of rows.
    let shown: Vec<SignPrice> =
        prices.iter().filter(|price| price.method == SignMethod::Ladder).cloned().collect();
    Destination::Stdout.write(|out| sign_price_table(&shown, TableFormat::Table, out))?;
    files.named(&args.output.join("signs.csv"))?.write(|out| sign_price_table(&prices, TableFormat::Csv, out))
}

/// Writes the points of the study, with their signs.
pub(super) fn write_points(args: &Args, monitor: &dyn Monitor, out: &mut dyn Write) -> Result<()> {
    let (distances, count) = extent(args);
    let names = ["family", "distance", "quantity", "n", "k", "coordinates", "x", "y", "sign"];
    let columns = names.map(|name| Column::new(name, name, name.len()));
    let mut table = TableWriter::new(out, TableFormat::Csv, "grazing-sign-points 1", columns.to_vec())?;
    let ladder = Ladder::default();
    for family in ZERO_FAMILIES {
        let places = family.places(count, monitor)?;
        for digits in distances.iter().copied().map(Some).chain([None]) {
            let distance = digits.map_or("0".to_string(), |digits| format!("1e-{digits}"));
            for at in places.iter().filter_map(|place| place.at(digits)) {
                let (name, n, k) = match at.quantity {
                    Quantity::B { n, k } => ("b", n, k),
                    Quantity::C { n } => ("c", n, 1),
                };
                let (coordinates, x, y) = match &at.point {
                    Point::Polar(polar) => ("rs", polar.r(), polar.s()),
                    Point::Plane(plane) => ("a1a2", plane.a1(), plane.a2()),
                };
                let fraction = |x: &BigRational| format!("{}/{}", x.numer(), x.denom());
                let sign = ladder.sign(&at.point, at.quantity).answer.to_string();
                table.row(&[
                    TableCell::Text(family.name()),
                    TableCell::Text(&distance),
                    TableCell::Text(name),
                    TableCell::Int(n as i64),
                    TableCell::Int(k as i64),
                    TableCell::Text(coordinates),
                    TableCell::Text(&fraction(x)),
                    TableCell::Text(&fraction(y)),
                    TableCell::Text(&sign),
                ])?;
            }
        }
    }
    table.finish()
}
