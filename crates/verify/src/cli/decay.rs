//! `grazing decay`: natural frequency and damping ratio with their deviations, from a free decay.

use std::{
    io::Write,
    path::{Path, PathBuf},
};

use clap::{Parser, ValueEnum};
use serde_json::json;

use super::{Outcome, ReportFormat, pretty, reported};
use crate::{
    error::{Error, Result},
    output::{FileRegistry, SampleColumns, SampleLine, WrongLine, read_text, samples},
    printable::Printable,
    tolerance::{Decay, Estimate},
};

/// The longest file, in bytes.
const LONGEST: u64 = 64 << 20;

/// Find a machine's natural frequency and damping ratio, with their deviations, from a free decay.
///
/// The file has a time and a displacement (or velocity, acceleration, strain) in two columns, named in the
/// first line or not. x(t) = c + exp(-zeta omega t) (A cos w t + B sin w t), w = omega sqrt(1 - zeta^2), is
/// fitted by least squares. A record that this does not fit is refused with the reason: it grows, is
/// overdamped, has too few periods, or leaves residuals with a structure, as where damping depends on the
/// amplitude. At the end stand the options for `grazing word`.
///
/// Exit code 0: done; 2: wrong usage, or a record that does not fit.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing decay examples/decay.csv
  grazing decay examples/decay.csv --from 0.2 --until 2 --format json")]
pub struct Args {
    /// The record, or - for standard input.
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// The column of the displacement, if there are more than two.
    #[arg(long, value_name = "NAME")]
    column: Option<String>,
    /// Leave out what is before this time: the decay is free from here on.
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = finite)]
    from: Option<f64>,
    /// Leave out what is after this time.
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = finite)]
    until: Option<f64>,
    /// The unit of time in the file.
    #[arg(long, value_enum, default_value_t = TimeUnit::S)]
    unit: TimeUnit,
    /// How the result is written.
    #[arg(long, value_enum, default_value_t = ReportFormat::Text)]
    pub(super) format: ReportFormat,
    /// Write to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum TimeUnit {
    /// Seconds: the frequency is in Hz.
    S,
    /// Milliseconds.
    Ms,
    /// Microseconds.
    Us,
    /// None: the frequency is per unit of time.
    None,
}

impl TimeUnit {
    /// Its name, and that of the frequency; how many of it are a second.
    fn names(self) -> (&'static str, &'static str, f64) {
        match self {
            TimeUnit::S => (" s", "Hz", 1.0),
            TimeUnit::Ms => (" ms", "Hz", 1e3),
            TimeUnit::Us => (" us", "Hz", 1e6),
            TimeUnit::None => ("", "", 1.0),
        }
    }
}

fn finite(text: &str) -> Result<f64> {
    let value = text.trim().parse().ok().filter(|value: &f64| value.is_finite());
    value.ok_or_else(|| Error::input(format!("{text:?} is not a finite number, as 0.25 is")))
}

/// The columns of the time and of the displacement.
fn columns(names: &[String], wanted: Option<&str>) -> std::result::Result<SampleColumns, String> {
    let named = !names.iter().all(|name| name.parse::<f64>().is_ok());
    if !named {
        return match (names.len(), wanted) {
            (2, None) => Ok(SampleColumns { time: 0, value: 1, named }),
            (2, Some(_)) => Err("does not name the columns: leave out --column".into()),
            (count, _) => Err(format!(
                "has {count} columns without names: times and displacements are needed, or names in the first line"
            )),
        };
    }
    let here = names.join(", ");
    let is_time = |name: &&String| {
        *name == "t" || name.strip_prefix("time").is_some_and(|rest| !rest.starts_with(char::is_alphanumeric))
    };
    let time = names.iter().position(|name| is_time(&name));
    let time = time.ok_or_else(|| {
        format!("has no column \"time\" or \"t\"; here are {here}: call that of the times so")
    })?;
    let others: Vec<usize> = (0..names.len()).filter(|&i| i != time).collect();
    let value = match (wanted, &others[..]) {
        (Some(wanted), _) => others.iter().copied().find(|&i| names[i] == wanted.trim().to_lowercase()),
        (None, [only]) => Some(*only),
        (None, _) => return Err(format!("name the displacement by --column; here are {here}")),
    };
    let value =
        value.ok_or_else(|| format!("has no column {:?}; here are {here}", wanted.unwrap_or_default()))?;
    Ok(SampleColumns { time, value, named })
}

pub(super) fn run(args: &Args, files: &FileRegistry) -> Result<Outcome> {
    files.read("FILE", &args.file)?;
    let destination = files.destination(args.output.as_deref())?;
    let decay = read(args, &args.file)?;
    let written = destination.write(|out| match args.format {
        ReportFormat::Text => Ok(out.write_all(text(args, &decay).as_bytes())?),
        ReportFormat::Json => write_json(args, &decay, out),
    });
    reported(Outcome::Done, written)
}

fn read(args: &Args, file: &Path) -> Result<Decay> {
    let name = Printable(&file.display().to_string()).to_string();
    let text = read_text(file, LONGEST)?;
    let all = samples(&text, &|names| columns(names, args.column.as_deref()));
    let all = all.map_err(|(line, message): WrongLine| Error::input(format!("{name}:{line}: {message}")))?;
    let within = |sample: &&SampleLine| {
        args.from.is_none_or(|from| from <= sample.1) && args.until.is_none_or(|until| sample.1 <= until)
    };
    let used: Vec<(f64, f64)> = all.iter().filter(within).map(|&(_, t, x)| (t, x)).collect();
    if used.is_empty() {
        let [first, last] = [&all[0], &all[all.len() - 1]].map(|sample| sample.1);
        let end = |option: &str, given: Option<f64>| given.map(|time| format!(" --{option} {time}"));
        let ends = [end("from", args.from), end("until", args.until)].into_iter().flatten();
        return Err(Error::input(format!(
            "{name} has times from {first} to {last}: no sample is left with{}",
            ends.collect::<String>()
        )));
    }
    let mut decay = Decay::fit(&used).map_err(|error| error.context(name))?;
    // Per second.
    let (_, _, per_second) = args.unit.names();
    decay.frequency.value *= per_second;
    decay.frequency.deviation *= per_second;
    Ok(decay)
}

/// Numbers whose first digit stands so far from the point are written with an exponent.
const PLAIN: [f64; 2] = [-5.0, 14.0];

fn is_plain(x: f64) -> bool {
    (PLAIN[0]..=PLAIN[1]).contains(&x.log10().floor())
}

/// A value and its deviation, with two digits of the latter; not below a rounding error.
fn rounded(estimate: Estimate) -> [String; 2] {
    let Estimate { value, deviation } = estimate;
    let deviation = deviation.max(1e-12 * value.abs());
    if deviation == 0.0 {
        return ["0", "0"].map(String::from);
    }
    let last = deviation.log10().floor();
    if is_plain(value.abs().max(deviation)) {
        let places = (1.0 - last).max(0.0) as usize;
        return [value, deviation].map(|x| format!("{x:.places$}"));
    }
    // The value to the deviation's second digit; none of its own is left where it is far below that.
    let digits =
        if value == 0.0 { 0.0 } else { (value.abs().log10().floor() - last + 1.0).max(0.0) } as usize;
    [format!("{value:.digits$e}"), format!("{deviation:.1e}")]
}

/// The values of `--frequency` and `--damping-ratio` of `grazing word`.
fn options(args: &Args, decay: &Decay) -> [String; 2] {
    let (_, unit, _) = args.unit.names();
    let both = |estimate, unit: &str| {
        let [value, deviation] = rounded(estimate);
        format!("{value}{unit}±{deviation}{unit}")
    };
    [both(decay.frequency, unit), both(decay.damping_ratio, "")]
}

fn text(args: &Args, decay: &Decay) -> String {
    let (time, unit, _) = args.unit.names();
    let [frequency, ratio, offset] =
        [decay.frequency, decay.damping_ratio, decay.offset].map(|one| rounded(one).join(" ± "));
    let [given, given_ratio] = options(args, decay);
    // In four digits or so.
    let [amplitude, rms] = [decay.amplitude, decay.rms].map(|value| {
        let [value, _] = rounded(Estimate { value, deviation: value / 1e3 });
        value
    });
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    let lasts = decay.duration;
    let duration = if is_plain(lasts) { format!("{lasts}") } else { format!("{lasts:e}") };
    format!(
        "Free decay: {} samples in {}{time}, {:.1} periods\n\
         \x20 natural frequency  {frequency}{unit}\n\
         \x20 damping ratio      {ratio}\n\
         \x20 place of rest      {offset}, amplitude at the first sample {amplitude}\n\
         ± is one standard deviation\n\
         Residuals: rms {rms}, {:.2} % of the amplitude; {} runs of one sign where {:.0} are expected, \
         Durbin-Watson {:.2}: as if independent\n\
         \n\
         Go on, F being the frequency of the drive, with\n\
         \x20 grazing word --frequency {given} --damping-ratio {given_ratio} --drive F --shares --normal\n",
        decay.samples,
        duration,
        decay.periods,
        100.0 * decay.rms / decay.amplitude,
        decay.runs,
        decay.expected_runs,
        decay.durbin_watson,
    )
}

fn write_json(args: &Args, decay: &Decay, out: &mut dyn Write) -> Result<()> {
    let (_, unit, _) = args.unit.names();
    let both = |one: Estimate| json!({ "value": one.value, "deviation": one.deviation });
    let [frequency, damping_ratio] = options(args, decay);
    let report = json!({
        "format": "grazing-decay 1",
        "samples": decay.samples,
        "duration": decay.duration,
        "periods": decay.periods,
        "unit": (!unit.is_empty()).then_some(unit),
        "frequency": both(decay.frequency),
        "damping_ratio": both(decay.damping_ratio),
        "correlation": decay.correlation,
        "offset": both(decay.offset),
        "amplitude": decay.amplitude,
        "residuals": {
            "rms": decay.rms,
            "runs": decay.runs,
            "expected_runs": decay.expected_runs,
            "durbin_watson": decay.durbin_watson,
        },
        "options": { "frequency": frequency, "damping_ratio": damping_ratio },
    });
    pretty(&report, out)
}
