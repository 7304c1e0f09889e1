//! The project's figures: vector graphics with the data of each in a CSV file of the same name.
//!
//! A picture is as wide as a journal's column, 86 mm, and its text has 8 points. A figure fills a
//! [`canvas`] with shapes, mostly inside [frames](frame) with axes; it reads no scene and runs no
//! search.

mod branches;
mod canvas;
mod coexistence;
mod cover;
mod design;
mod digits;
mod entropy;
mod flow_accuracy;
mod frame;
mod gaps;
mod glance;
mod grid;
mod intervals;
mod iterate;
mod labels;
mod legend;
mod machine;
mod motion;
mod orbits;
mod panels;
mod proofs;
mod records;
mod regions;
mod response;
mod returns;
mod section;
mod shift;
mod sign_price;
mod simulations;
mod tips;
mod tolerance;
mod touch;
mod trapped;
mod view;
mod words;

pub use branches::{DrawnBranch, Said, Scatter, branches, orbits_of_branches};
pub use coexistence::coexistence;
pub use cover::{FINEST, areas};
pub use design::design;
pub use digits::{digits_figure, digits_table};
pub use entropy::entropy;
pub use flow_accuracy::{effects_table, flow_accuracy, flow_table, long_runs_table, machine_effects_table};
pub use gaps::gaps;
pub use glance::{TABLES as GLANCE_TABLES, glance_figure};
pub use grid::{Grid, ParameterMap, grid, parameter_map};
pub use intervals::intervals;
pub use iterate::iterate_boundaries;
pub use machine::{MachinePicture, machine};
pub use motion::{MotionPicture, motion};
pub use orbits::{orbit, orbits};
pub use proofs::{proof_figure, proof_table};
pub use records::records;
pub use regions::regions;
pub use response::response;
pub use returns::returns;
pub use section::{Mark, Points, section};
pub use shift::shift;
pub use sign_price::{sign_price_figure, sign_price_table};
pub use simulations::{simulations_figure, simulations_table};
pub use tips::tips;
pub use tolerance::tolerance;
pub use touch::touch;
pub use trapped::trapped;
pub use view::View;
pub use words::words;

use std::{
    fs,
    path::{Path, PathBuf},
};

use crate::{
    error::{Error, Result},
    existence::Case,
    output::{Column, TableCell, TableFormat, TableWriter, write_file},
};
use canvas::{BLUE, Canvas, Colour, GREEN, ORANGE, PINK};

/// What a picture is written as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PictureFormat {
    /// Vectors for screens.
    #[default]
    Svg,
    /// Vectors for print; with the feature `print`.
    Pdf,
    /// Pixels for print; with the feature `print`.
    Png,
}

impl PictureFormat {
    /// The format that the ending of a file's name says.
    pub fn of(file: &Path) -> Option<PictureFormat> {
        let ending = file.extension()?.to_str()?.to_ascii_lowercase();
        [PictureFormat::Svg, PictureFormat::Pdf, PictureFormat::Png]
            .into_iter()
            .find(|format| format.ending() == ending)
    }

    /// The ending of its files' names.
    pub fn ending(self) -> &'static str {
        match self {
            PictureFormat::Svg => "svg",
            PictureFormat::Pdf => "pdf",
            PictureFormat::Png => "png",
        }
    }

    /// Whether this program can write it.
    ///
    /// # Errors
    /// An input error for PDF and PNG without the feature `print`.
    pub fn check(self) -> Result<()> {
        if self == PictureFormat::Svg || cfg!(feature = "print") {
            return Ok(());
        }
        Err(Error::input(format!(
            "this grazing writes .svg, no .{}: build it with `cargo install --path crates/shell --features print` for that",
            self.ending()
        )))
    }
}

/// Where a figure goes: its folder, which is made if need be, and the name of its files without ending.
#[derive(Debug, Clone, Copy)]
pub struct FigurePlace<'a> {
    /// The folder.
    pub folder: &'a Path,
    /// The name.
    pub name: &'a str,
    /// What the picture is written as.
    pub format: PictureFormat,
    /// What of it the picture shows.
    pub view: View,
}

impl<'a> FigurePlace<'a> {
    /// A whole picture as SVG.
    pub fn svg(folder: &'a Path, name: &'a str) -> FigurePlace<'a> {
        FigurePlace { folder, name, format: PictureFormat::Svg, view: View::default() }
    }

    /// The picture's file.
    pub fn picture(&self) -> PathBuf {
        self.folder.join(format!("{}.{}", self.name, self.format.ending()))
    }

    /// The file of the data beside it.
    pub fn data(&self) -> PathBuf {
        self.folder.join(format!("{}.csv", self.name))
    }

    /// Writes the picture.
    fn draw(&self, canvas: &Canvas) -> Result<()> {
        fs::create_dir_all(self.folder).map_err(|error| Error::io("create", self.folder, error))?;
        self.format.check()?;
        let picture = match self.format {
            #[cfg(feature = "print")]
            PictureFormat::Pdf => canvas.pdf(),
            #[cfg(feature = "print")]
            PictureFormat::Png => {
                canvas.png().ok_or_else(|| Error::input(format!("{}: too large to draw", self.name)))?
            }
            _ => canvas.svg().into_bytes(),
        };
        write_file(&self.picture(), |out| Ok(out.write_all(&picture)?))
    }

    /// Writes the picture and the data beside it.
    fn save(&self, canvas: &Canvas, columns: &[&'static str], rows: &[Vec<String>]) -> Result<()> {
        self.draw(canvas)?;
        write_file(&self.data(), |out| {
            let columns = columns.iter().map(|name| Column::new(name, name, 0)).collect();
            let mut table = TableWriter::new(out, TableFormat::Csv, "", columns)?;
            for row in rows {
                let cells: Vec<TableCell> = row.iter().map(|cell| TableCell::Text(cell)).collect();
                table.row(&cells)?;
            }
            table.finish()
        })
    }
}

/// How wide a text is set at a size of type, in points: for tests of pictures.
pub fn text_width(text: &str, size: f64) -> f64 {
    canvas::Words::plain(text).width(size)
}

/// The picture of this name in the documentation is what `draw` makes of the table beside it;
/// GRAZING_REDRAW=1 draws it anew.
#[cfg(test)]
fn assert_shows_its_table<T>(
    name: &str,
    row: impl Fn(&csv::StringRecord) -> T,
    draw: impl Fn(&[T]) -> Canvas,
) {
    let place = FigurePlace::svg(Path::new("../../docs"), name);
    let rows: Vec<T> =
        csv::Reader::from_path(place.data()).unwrap().records().map(|one| row(&one.unwrap())).collect();
    let canvas = draw(&rows);
    if std::env::var_os("GRAZING_REDRAW").is_some() {
        place.draw(&canvas).unwrap();
    }
    assert!(fs::read_to_string(place.picture()).unwrap() == canvas.svg(), "{name}");
}

/// The same of a table NAME.csv and, if it is there, NAME-peers.csv.
#[cfg(test)]
fn assert_shows_its_tables(name: &str, draw: impl Fn(&[panels::PanelRow]) -> Canvas) {
    let place = FigurePlace::svg(Path::new("../../docs"), name);
    let [table, beside] = ["", "-peers"].map(|end| format!("{name}{end}.csv"));
    let canvas = draw(&panels::rows(place.folder, &table, &beside).unwrap());
    if std::env::var_os("GRAZING_REDRAW").is_some() {
        place.draw(&canvas).unwrap();
    }
    assert!(fs::read_to_string(place.picture()).unwrap() == canvas.svg(), "{name}");
}

/// The colour of a case.
fn colour(case: Case) -> Colour {
    match case {
        Case::MinusPlus => BLUE,
        Case::PlusPlus => ORANGE,
        Case::PlusMinus => GREEN,
        Case::MinusMinus => PINK,
    }
}

/// A case in words, for a panel's title or a legend: on which side of the touch, the sign of γ, and its sign.
fn title(case: Case) -> String {
    let side = if case.sign_emu() > 0 { "before" } else { "beyond" };
    let gamma = if case.sign_gamma() > 0 { '>' } else { '<' };
    format!("{side} the touch, γ {gamma} 0: {}", label(case))
}

/// A case as it is printed.
fn label(case: Case) -> String {
    case.to_string().replace('-', "−")
}
