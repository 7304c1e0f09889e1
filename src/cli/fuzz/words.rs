//! `grazing fuzz --words`: look for a counterexample to the word theorem.

use std::{io::Write, path::Path, time::Instant};

use serde_json::json;

use super::{
    super::{Outcome, ReportFormat, in_pool, reported},
    Args, MOST, PAUSE, append,
};
use crate::{
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    output::{Destination, Journal, SavedRun, distinct, probe, say, torn},
    search::{
        Instance,
        fuzz::words::{SUPREMA, WordOptions, WordTally, fuzz_words, replayed},
    },
};

pub(super) fn run(args: &Args, definition_share: f64, interrupt: &Interrupt) -> Result<Outcome> {
    let (first, last) = (*args.n.0.start(), *args.n.0.end());
    if first != 1 {
        return Err(Error::input(format!("--words compares every period up to N: write --n 1..={last}")));
    }
    let options = WordOptions { last, cases: args.cases, seed: args.seed, definition_share };
    let files = [("--regressions", Some(args.regressions.as_path())), ("--resume", args.resume.as_deref())];
    distinct(&files.into_iter().filter_map(|(option, file)| Some((option, file?))).collect::<Vec<_>>())?;
    probe(&args.regressions)?;
    let (mut state, start) = match &args.resume {
        Some(path) => {
            let (state, start) = open(path, &options)?;
            interrupt.keeps(format!("what was counted is kept in {0}: --resume {0} goes on", path.display()));
            (Some(state), start)
        }
        None => (None, WordTally::default()),
    };
    let before = start.decided();
    let clock = Instant::now();
    let progress = Progress::new(interrupt, options.cases.saturating_sub(before), "points");
    let mut saved = Instant::now();
    let tally = in_pool(args.jobs, || {
        fuzz_words(&options, start, &progress, |tally| match &mut state {
            Some(state) if saved.elapsed() > PAUSE => {
                saved = Instant::now();
                state.replace(&json!(tally).to_string())
            }
            _ => Ok(()),
        })
    })?;
    drop(progress);
    if let Some(state) = &mut state {
        state.replace(&json!(tally).to_string())?;
    }
    let outcome = if !tally.disagreements.is_empty() || !tally.faults.is_empty() {
        Outcome::Refuted
    } else if tally.decided() < options.cases {
        Outcome::Interrupted
    } else if tally.undecided > 0 {
        Outcome::Undecided
    } else {
        Outcome::Done
    };
    let kept = match &tally.disagreements[..] {
        [] => Ok(()),
        found => append(&args.regressions, found),
    };
    if args.format == ReportFormat::Text {
        let rate = (tally.decided() - before) as f64 / clock.elapsed().as_secs_f64();
        let mut line = format!("{rate:.3e} points a second");
        if tally.sweep_seconds > 0.0 {
            let sweeps = (tally.units * options.block()) as f64 / tally.sweep_seconds;
            line += &format!("; per second of processor time {sweeps:.3e} in sweeps");
        }
        say(line);
    }
    let written = Destination::Stdout.write(|out| match args.format {
        ReportFormat::Text => text(out, args, &options, &tally, outcome),
        ReportFormat::Json => {
            let report = json!({
                "format": "grazing-fuzz 2",
                "verdict": match outcome {
                    Outcome::Done => "no disagreement",
                    other => other.word(),
                },
                "of": "words",
                "options": options,
                "block": options.block(),
                "tally": tally,
                "presumed_suprema": SUPREMA,
            });
            Ok(writeln!(out, "{report}")?)
        }
    });
    reported(outcome, kept.and(written))
}

/// The state of this run, and how far it has come.
fn open(path: &Path, options: &WordOptions) -> Result<(Journal, WordTally)> {
    let WordOptions { last, seed, definition_share, .. } = options;
    let words = format!("--words --n 1..={last} --seed {seed} --definition-share {definition_share}");
    let (state, found) = Journal::open(path, &SavedRun::new("fuzz", words, &options.canonical()), MOST)?;
    if found.torn > 0 {
        say(format_args!("note: {}", torn(path)));
    }
    let Some(record) = found.records.last() else { return Ok((state, WordTally::default())) };
    let tally: Result<WordTally> =
        serde_json::from_str(record).map_err(|error| Error::input(format!("no tally: {error}")));
    let tally = tally.and_then(|tally| tally.check(options).map(|()| tally));
    tally
        .map(|tally| (state, tally))
        .map_err(|error| error.context(format_args!("cannot resume from {}", path.display())))
}

fn text(
    out: &mut dyn Write,
    args: &Args,
    options: &WordOptions,
    tally: &WordTally,
    outcome: Outcome,
) -> Result<()> {
    let verdict = match outcome {
        Outcome::Refuted if tally.disagreements.is_empty() => {
            "An error of this program: two of its routes to one answer differ. Please report it.".to_string()
        }
        Outcome::Refuted => "Refuted: the definition and the word differ.".to_string(),
        Outcome::Interrupted => format!(
            "Interrupted: no disagreement found at {} of {} points. This is no proof.",
            tally.decided(),
            options.cases
        ),
        _ => "No disagreement found. This is no proof.".to_string(),
    };
    writeln!(out, "{verdict}")?;
    let rows = [
        (tally.decided(), "points decided both ways, every period up to the last, of which"),
        (tally.swept, "by f64 with proved bounds, in sweeps"),
        (tally.exact, "exactly, or by intervals and balls"),
        (tally.boundary, "on a boundary, where something is zero and the rest agrees"),
        (tally.undecided, "undecided, and not counted above"),
        (tally.weighted, "drawn near the places where something could fail"),
        (tally.repeated, "of sweeps decided again exactly"),
        (tally.pairs, "pairs of periods compared in sweeps"),
        (tally.words, "random words on r = 1 whose entropies were computed"),
    ];
    for (count, what) in rows {
        writeln!(out, "{count:>16}  {what}")?;
    }
    for (index, case) in ["(+,+)", "(+,-)"].into_iter().enumerate() {
        if tally.largest[index] > 0.0 {
            writeln!(
                out,
                "largest entropy in {case}: {:.9} ({}); thought to be below {:.9}, which is not proved",
                tally.largest[index], tally.largest_at[index], SUPREMA[index]
            )?;
        }
    }
    for line in &tally.beyond {
        writeln!(out, "an open question is answered: the supremum is larger than was thought; {line}")?;
    }
    writeln!(
        out,
        "Points come in blocks of about {}: the run ends with the block that reaches --cases.",
        options.block()
    )?;
    for fault in &tally.faults {
        writeln!(out, "{fault}")?;
    }
    for line in &tally.disagreements {
        let case: Instance = replayed(line)?;
        let arguments = case.arguments().replace(&format!(" --max-n {}", case.n), "");
        writeln!(
            out,
            "{line}\n  shown by: grazing word {arguments}, against grazing classify {}",
            case.arguments()
        )?;
    }
    if !tally.disagreements.is_empty() {
        writeln!(out, "appended to {}", args.regressions.display())?;
    }
    Ok(())
}
