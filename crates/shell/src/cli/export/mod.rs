//! `grazing export`: a table of a run for MATLAB, NumPy or AUTO, each in a form that it loads with one line.

mod auto;
mod matlab;
mod numpy;
mod table;

use std::path::{Path, PathBuf};

use clap::Parser;

use super::Outcome;
use crate::{
    error::{Error, Result},
    output::{Destination, FileRegistry, read_text, say_to},
};
use table::Table;

/// Write a table of `grazing run` as MATLAB, NumPy or AUTO reads it: as the name of the file says.
///
/// NAME.mat: MATLAB and Octave, `load NAME.mat`, a matrix for each column. NAME.npz: Python,
/// `d = numpy.load("NAME.npz")`, then `d["q"]`. b.NAME: AUTO, the points of branches, `loadbd("NAME")`.
/// NAME.dat: AUTO, time and state of a motion, to start from: `dat="NAME"`.
///
/// Exit code 0: done; 2: wrong usage, a table that cannot be read or a file that cannot be written.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing run examples/scenes/bouncing-ball.toml --only bounces -o out
  grazing export out/bounces.csv -o bounces.mat
  grazing export out/bounces.csv -o bounces.npz")]
pub(super) struct Args {
    /// The table: a file NAME.csv or NAME-points.csv of a task.
    #[arg(value_name = "TABLE.csv")]
    table: PathBuf,
    /// The file: NAME.mat, NAME.npz, b.NAME or NAME.dat.
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

/// The longest table that is read, in bytes: memory holds several times as many.
const LONGEST: u64 = 1 << 30;

/// Who reads it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    Matlab,
    Numpy,
    AutoBranches,
    AutoMotion,
}

impl Form {
    /// The form that a file's name says.
    fn of(file: &Path) -> Option<Form> {
        let name = file.file_name()?.to_str()?;
        if name.starts_with("b.") && name.len() > 2 {
            return Some(Form::AutoBranches);
        }
        match file.extension()?.to_str()? {
            "mat" => Some(Form::Matlab),
            "npz" => Some(Form::Numpy),
            "dat" => Some(Form::AutoMotion),
            _ => None,
        }
    }
}

pub(super) fn run(args: &Args, files: &FileRegistry) -> Result<Outcome> {
    let form = Form::of(&args.output).ok_or_else(|| {
        Error::input(format!(
            "-o {}: the name says who reads it: NAME.mat (MATLAB), NAME.npz (NumPy), b.NAME or NAME.dat (AUTO)",
            args.output.display()
        ))
    })?;
    files.read("the table", &args.table)?;
    let file = files.write("-o", &args.output)?;
    let name = args.table.display();
    let table = Table::read(&read_text(&args.table, LONGEST)?, &name.to_string())?;
    let bytes = match form {
        Form::Matlab => matlab::write(&table),
        Form::Numpy => numpy::write(&table),
        Form::AutoBranches => auto::branches(&table),
        Form::AutoMotion => auto::motion(&table),
    };
    let bytes = bytes.map_err(|error| error.context(name.to_string()))?;
    file.write(|out| Ok(out.write_all(&bytes)?))?;
    let (name, rows) = (args.output.display(), table.rows);
    Destination::Stdout.write(|out| say_to(out, format_args!("wrote {name}: {rows} rows")))?;
    Ok(Outcome::Done)
}
