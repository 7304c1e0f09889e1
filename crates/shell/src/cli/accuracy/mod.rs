//! `grazing accuracy`: what accuracy costs, on this machine.
//!
//! A part measures one thing: it writes its tables into the folder, then its picture. A part that is there
//! already, as [`kept`] knows, is not measured again.

mod digits;
mod effects;
mod kept;
mod proofs;
mod signs;
mod simulations;

use std::path::{Path, PathBuf};

use clap::{Parser, ValueEnum};

use super::Outcome;
use crate::{
    cli::progress::Interrupt,
    error::{Error, Result},
    figure::{GLANCE_TABLES, digits_figure, glance_figure, sign_price_figure, simulations_figure},
    output::{Destination, FileRegistry, FileUse, make_folder},
};
use kept::Kept;

/// Measure what accuracy costs in time, on this machine.
///
/// Of signs: the time to decide the sign of b_{n,k} or c_n by each method, from 1/10 to 10^-1000 away from
/// where it changes and exactly there, and the share of signs that plain floats get wrong, as signs.csv and
/// signs.svg. Of digits: the time and correct digits of b_{n,k} for each way to compute it and each family of
/// inputs, beside values by another program, as digits.csv and digits.svg. Of simulations: the time and error
/// of the closed form and of the integrator at tolerances 1e-3 to 1e-13, on six motions beside ends by
/// another program, as simulations.csv and .svg; on motions that return, as flow-accuracy.csv and .svg; after
/// 1 to 10^6 periods, as long-runs.csv. Tables signs-peers.csv, digits-peers.csv and simulations-peers.csv in
/// the folder, of other programs, are drawn, too. Of proofs: bits and time to prove an orbit, from 1/10 to
/// 10^-30 away from grazing and for periods up to 1000, and the size of certificates of every kind and the
/// time to check them, as proofs.csv and proofs.svg. Of effects: what each adds to the time per period, with
/// its evaluations counted, as effects.csv, and of machines as machine-effects.csv. The tables are also
/// printed; of signs, what the ladder costs, which every command uses. Where the tables of signs, digits and
/// simulations are all there, accuracy.svg shows them at a glance. Takes up to some minutes.
///
/// measured.csv says which program measured each file, with which options, on which machine and under which
/// load. What this program has measured before with the same options, and nobody has changed, is kept: an
/// interrupted command goes on when it is run again.
///
/// Exit code 0: done; 2: a file that cannot be written; 3: interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing accuracy --of effects -o figures
  grazing accuracy --of all --quick -o figures")]
pub(super) struct Args {
    /// What to measure.
    #[arg(long, value_enum, default_value_t = Subject::Signs)]
    of: Subject,
    /// The folder for the files.
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
    /// Fewer distances, inputs and repetitions: everything in about a minute.
    #[arg(long)]
    quick: bool,
    /// Measure again what is there already.
    #[arg(long)]
    again: bool,
    /// Of signs or digits: also write every point as exact fractions, for other programs; of signs with the
    /// sign.
    #[arg(long, value_name = "FILE")]
    points: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Subject {
    /// The price of a sign, by its distance to zero.
    Signs,
    /// b_{n,k}, by its certain digits.
    Digits,
    /// Motions.
    Simulations,
    /// Proofs: orbits near grazing, and certificates of every kind.
    Proofs,
    /// The effects of an oscillator.
    Effects,
    /// All of these.
    All,
}

/// What is measured by itself.
struct Part {
    subject: Subject,
    /// As the option has it.
    name: &'static str,
    /// The files that measuring writes.
    files: &'static [&'static str],
    /// Measures, prints and writes.
    measure: fn(&Args, &FileRegistry, &Interrupt) -> Result<()>,
    /// Draws its picture from the tables in a folder, ours and those of other programs beside them.
    draw: Option<fn(&Path) -> Result<()>>,
}

/// In the order of `--of all`.
const PARTS: [Part; 5] = [
    Part {
        subject: Subject::Signs,
        name: "signs",
        files: &["signs.csv"],
        measure: signs::measure,
        draw: Some(sign_price_figure),
    },
    Part {
        subject: Subject::Digits,
        name: "digits",
        files: &["digits.csv"],
        measure: digits::measure,
        draw: Some(digits_figure),
    },
    Part {
        subject: Subject::Simulations,
        name: "simulations",
        files: &["simulations.csv", "flow-accuracy.csv", "flow-accuracy.svg", "long-runs.csv"],
        measure: simulations::measure,
        draw: Some(simulations_figure),
    },
    Part {
        subject: Subject::Proofs,
        name: "proofs",
        files: &["proofs.csv", "proofs.svg"],
        measure: proofs::measure,
        draw: None,
    },
    Part {
        subject: Subject::Effects,
        name: "effects",
        files: &["effects.csv", "machine-effects.csv"],
        measure: effects::measure,
        draw: None,
    },
];

/// The parts that are asked for.
fn chosen(args: &Args) -> impl Iterator<Item = &'static Part> {
    const ALL: &[Part] = &PARTS;
    let of = args.of;
    ALL.iter().filter(move |part| of == Subject::All || part.subject == of)
}

/// Names the files in the folder: those of the parts, tables of other programs, and what was measured before.
fn name(args: &Args, files: &FileRegistry) -> Result<()> {
    let claim = |name: &str, how| files.claim("-o", &args.output.join(name), how);
    claim(kept::NAME, FileUse::Continue)?;
    for part in chosen(args) {
        part.files.iter().try_for_each(|name| claim(name, FileUse::Write))?;
        if part.draw.is_some() {
            claim(&format!("{}.svg", part.name), FileUse::Write)?;
            claim(&format!("{}-peers.csv", part.name), FileUse::Read)?;
        }
    }
    if is_shown_at_a_glance(args) {
        claim("accuracy.svg", FileUse::Write)?;
    }
    Ok(())
}

/// Whether the picture of three panels changes: one of its tables is measured, and all are there then.
fn is_shown_at_a_glance(args: &Args) -> bool {
    let measured = |name: &str| chosen(args).any(|part| part.name == name);
    let there = |name: &str| measured(name) || args.output.join(format!("{name}.csv")).exists();
    GLANCE_TABLES.iter().any(|name| measured(name)) && GLANCE_TABLES.iter().all(|name| there(name))
}

pub(super) fn run(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    if args.points.is_some() && !matches!(args.of, Subject::Signs | Subject::Digits) {
        return Err(Error::input("--points is for --of signs or digits: leave it out"));
    }
    name(args, files)?;
    let points =
        args.points.as_deref().map(|file| files.claim("--points", file, FileUse::Write).map(|()| file));
    let points = points.transpose()?;
    // Before the measurement rather than after it.
    make_folder(&args.output)?;
    if let Some(file) = points {
        files.named(file)?.write(|out| match args.of {
            Subject::Digits => digits::write_points(out),
            _ => signs::write_points(args, interrupt, out),
        })?;
    }
    let options = if args.quick { "quick" } else { "full" };
    let mut kept = Kept::read(&args.output);
    let folder = args.output.display();
    interrupt.keeps(format!("the parts that are whole are in {folder}: the same command goes on from there"));
    for part in chosen(args) {
        if !args.again && kept.has(part, options) {
            let line =
                format!("{}: kept as this program measured it before; --again measures anew", part.name);
            Destination::Stdout.write(|out| Ok(writeln!(out, "{line}")?))?;
        } else {
            (part.measure)(args, files, interrupt)?;
            kept.keep(part, options, files)?;
        }
        // Also where it is kept: another program may have written its table since.
        part.draw.map_or(Ok(()), |draw| draw(&args.output))?;
    }
    if is_shown_at_a_glance(args) {
        glance_figure(&args.output)?;
    }
    Ok(Outcome::Done)
}
