//! `grazing accuracy`: what accuracy costs, on this machine.

use std::{io::Write, path::PathBuf, time::Duration};

use clap::{Parser, ValueEnum};
use num_rational::BigRational;

use super::Outcome;
use crate::{
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    figure::{
        FigurePlace, PictureFormat, accuracy_figure, accuracy_table, effects_table, flow_accuracy,
        flow_table, long_runs_table, machine_effects_table, sign_price_figure, sign_price_table,
    },
    local::{Ladder, Point, Quantity},
    monitor::Monitor,
    output::{Column, Destination, TableCell, TableFormat, TableWriter, make_folder, write_file},
    study::{
        DISTANCES, FAMILIES, QUICK_DISTANCES, SignMethod, SignPrice, ZERO_FAMILIES,
        effects::{effects, machine_effects},
        flow_accuracy::{long_runs, returning, tolerances},
        measure, sign_prices,
    },
};

/// Measure what accuracy costs in time, on this machine.
///
/// Of signs: the time to decide the sign of b_{n,k} or c_n by each method, from 1/10 to 10^-1000 away from
/// where it changes and exactly there, and the share of signs that plain floats get wrong, as signs.csv and
/// signs.svg. Of digits: the time, certain digits and decided signs of b_{n,k}, for each way to compute it
/// and each family of inputs, as accuracy.csv and accuracy.svg. Of simulations: the time and error of the
/// closed form and of the integrator at tolerances 1e-3 to 1e-13, as flow-accuracy.csv and .svg, and the
/// distance from exact motions after 1 to 10^6 periods, as long-runs.csv. Of effects: what each adds to the
/// time per period, with its evaluations counted, as effects.csv, and of machines as machine-effects.csv.
/// The table is also printed; of signs, what the ladder costs, which every command uses. Takes up to some
/// minutes.
///
/// Exit code 0: done; 2: a file that cannot be written; 3: interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing accuracy --of effects -o figures")]
pub(super) struct Args {
    /// What to measure.
    #[arg(long, value_enum, default_value_t = Subject::Signs)]
    of: Subject,
    /// The folder for the files.
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
    /// Fewer distances and inputs: signs in some seconds.
    #[arg(long)]
    quick: bool,
    /// Of signs: also write every point with its sign, as exact fractions, for other programs to decide.
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
    /// The effects of an oscillator.
    Effects,
    /// All of these.
    All,
}

pub(super) fn run(args: &Args, interrupt: &Interrupt) -> Result<Outcome> {
    for (given, option) in [(args.quick, "--quick"), (args.points.is_some(), "--points")] {
        if given && !matches!(args.of, Subject::Signs | Subject::All) {
            return Err(Error::input(format!("{option} is for --of signs or all: leave it out")));
        }
    }
    // Before the measurement rather than after it.
    make_folder(&args.output)?;
    match args.of {
        Subject::Signs => signs(args, interrupt),
        Subject::Digits => digits(args, interrupt),
        Subject::Simulations => simulations(args, interrupt),
        Subject::Effects => costs(args, interrupt),
        Subject::All => [signs, digits, simulations, costs].iter().try_for_each(|part| part(args, interrupt)),
    }?;
    Ok(Outcome::Done)
}

fn signs(args: &Args, interrupt: &Interrupt) -> Result<()> {
    let (distances, count, batch) = match args.quick {
        true => (&QUICK_DISTANCES[..], 4, Duration::from_micros(200)),
        false => (&DISTANCES[..], 8, Duration::from_millis(1)),
    };
    // Twelve methods at each distance and at 0.
    let steps = ZERO_FAMILIES.len() as u64 * (distances.len() as u64 + 1) * 12;
    let progress = Progress::new(interrupt, steps, "measurements");
    if let Some(file) = &args.points {
        write_file(file, |out| points(distances, count, interrupt, out))?;
    }
    let mut prices = Vec::new();
    for family in ZERO_FAMILIES {
        prices.extend(sign_prices(family, distances, count, batch, &progress)?);
    }
    // Of all the methods, the one that every command uses: the file has hundreds of rows.
    let shown: Vec<SignPrice> =
        prices.iter().filter(|price| price.method == SignMethod::Ladder).cloned().collect();
    Destination::Stdout.write(|out| sign_price_table(&shown, TableFormat::Table, out))?;
    sign_price_figure(
        &prices,
        &FigurePlace { folder: &args.output, name: "signs", format: PictureFormat::Svg },
    )
}

/// The points of the study, with their signs.
fn points(distances: &[u32], count: usize, monitor: &dyn Monitor, out: &mut dyn Write) -> Result<()> {
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

fn digits(args: &Args, interrupt: &Interrupt) -> Result<()> {
    let mut rows = Vec::new();
    for family in FAMILIES {
        interrupt.check()?;
        rows.extend(measure(family));
    }
    Destination::Stdout.write(|out| accuracy_table(&rows, TableFormat::Table, out))?;
    accuracy_figure(
        &rows,
        &FigurePlace { folder: &args.output, name: "accuracy", format: PictureFormat::Svg },
    )
}

fn simulations(args: &Args, interrupt: &Interrupt) -> Result<()> {
    let mut rows = Vec::new();
    for case in returning() {
        for tolerance in [None].into_iter().chain(tolerances().into_iter().map(Some)) {
            interrupt.check()?;
            rows.push(case.measure(tolerance)?);
        }
    }
    Destination::Stdout.write(|out| flow_table(&rows, TableFormat::Table, out))?;
    flow_accuracy(
        &rows,
        &FigurePlace { folder: &args.output, name: "flow-accuracy", format: PictureFormat::Svg },
    )?;
    let rows = long_runs(6)?;
    Destination::Stdout.write(|out| long_runs_table(&rows, TableFormat::Table, out))?;
    write_file(&args.output.join("long-runs.csv"), |out| long_runs_table(&rows, TableFormat::Csv, out))
}

fn costs(args: &Args, interrupt: &Interrupt) -> Result<()> {
    let mut rows = Vec::new();
    for effect in effects() {
        interrupt.check()?;
        rows.push(effect.measure()?);
    }
    Destination::Stdout.write(|out| effects_table(&rows, TableFormat::Table, out))?;
    write_file(&args.output.join("effects.csv"), |out| effects_table(&rows, TableFormat::Csv, out))?;
    let mut rows = Vec::new();
    for effect in machine_effects() {
        interrupt.check()?;
        rows.push(effect.measure()?);
    }
    Destination::Stdout.write(|out| machine_effects_table(&rows, TableFormat::Table, out))?;
    write_file(&args.output.join("machine-effects.csv"), |out| {
        machine_effects_table(&rows, TableFormat::Csv, out)
    })
}
