//! The project's figures: vector graphics with the data of each in a CSV file of the same name.
//!
//! A picture is 2000 units wide and meant for a journal's column of 86 mm, where its text has about 7 points.

mod accuracy;
mod axes;
mod branches;
mod cover;
mod entropy;
mod flow_accuracy;
mod grid;
mod intervals;
mod iterate;
mod motion;
mod orbits;
mod records;
mod regions;
mod section;
mod tips;
mod words;

pub use accuracy::{accuracy_figure, accuracy_table};
pub use branches::{DrawnBranch, Scatter, branches};
pub use cover::{FINEST, areas};
pub use entropy::entropy;
pub use flow_accuracy::{effects_table, flow_accuracy, flow_table, long_runs_table};
pub use grid::{Grid, grid};
pub use intervals::intervals;
pub use iterate::iterate_boundaries;
pub use motion::{MotionPicture, motion};
pub use orbits::{orbit, orbits};
pub use records::records;
pub use regions::regions;
pub use section::{Mark, Points, section};
pub use tips::tips;
pub use words::words;

use std::{fs, path::Path};

use plotters::{
    prelude::*,
    style::text_anchor::{HPos, Pos, VPos},
};

use crate::{
    error::{Error, Result},
    existence::Case,
    output::{Column, TableCell, TableFormat, TableWriter, write_file},
};

/// A picture as SVG text.
type Picture = std::result::Result<String, Box<dyn std::error::Error>>;

const WIDTH: u32 = 2000;
/// The library writes 1/1.24 of this.
const FONT: i32 = 70;
const GREY: RGBColor = RGBColor(150, 150, 150);

/// The colour of a case, from the palette of Okabe and Ito, which colour-blind readers can tell apart.
fn colour(case: Case) -> RGBColor {
    match case {
        Case::MinusPlus => RGBColor(0, 114, 178),
        Case::PlusPlus => RGBColor(230, 159, 0),
        Case::PlusMinus => RGBColor(0, 158, 115),
        Case::MinusMinus => RGBColor(204, 121, 167),
    }
}

/// The text style of the column-wide figures.
fn style(size: i32, horizontal: HPos, vertical: VPos) -> TextStyle<'static> {
    ("sans-serif", size).into_font().color(&BLACK).pos(Pos::new(horizontal, vertical))
}

/// A case as it is printed.
fn label(case: Case) -> String {
    case.to_string().replace('-', "−")
}

/// Writes `name`.svg into `folder`, which is made if need be.
fn save_picture(folder: &Path, name: &str, picture: Picture) -> Result<()> {
    let picture = picture.map_err(|error| Error::from(std::io::Error::other(error.to_string())))?;
    fs::create_dir_all(folder).map_err(|error| Error::io("create", folder, error))?;
    write_file(&folder.join(format!("{name}.svg")), |out| Ok(out.write_all(picture.as_bytes())?))
}

/// Writes `name`.svg and `name`.csv into `folder`, which is made if need be.
fn save(
    folder: &Path,
    name: &str,
    picture: Picture,
    columns: &[&'static str],
    rows: &[Vec<String>],
) -> Result<()> {
    save_picture(folder, name, picture)?;
    write_file(&folder.join(format!("{name}.csv")), |out| {
        let columns = columns.iter().map(|name| Column::new(name, name, 0)).collect();
        let mut table = TableWriter::new(out, TableFormat::Csv, "", columns)?;
        for row in rows {
            let cells: Vec<TableCell> = row.iter().map(|cell| TableCell::Text(cell)).collect();
            table.row(&cells)?;
        }
        table.finish()
    })
}
