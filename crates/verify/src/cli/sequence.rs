//! `grazing sequence`: whole numbers of the theory, as b-files.

use std::{collections::HashSet, path::PathBuf};

use clap::{Parser, ValueEnum};
use num_rational::BigRational;

use super::Outcome;
use crate::{
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    existence::{Boundary, Lowest, intervals, measure},
    local::{Ladder, Plane, Point},
    monitor::Monitor,
    number::parse_integer,
    output::FileRegistry,
    word::{ClosedWalks, Relation, Word, two_impacts_of},
};

/// List a sequence of whole numbers, one line "n a(n)" for each n from its first up to N: the form of b-files
/// of the On-Line Encyclopedia of Integer Sequences.
///
/// docs/sequences.md defines each, and says which are known.
///
/// Exit code 0: done; 2: wrong usage or a file that cannot be written; 3: interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing sequence two-impacts 26
  grazing sequence measure-numerator 40 -o b.txt")]
pub struct Args {
    /// Which sequence.
    #[arg(value_enum)]
    name: Sequence,
    /// The last n.
    #[arg(value_name = "N", value_parser = parse_integer::<u64>)]
    last: u64,
    /// Write to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Sequence {
    /// The number of open intervals of s in Theorem 2 for period n, from n = 3.
    Intervals,
    /// The numerator of their total length L_n in lowest terms, from n = 3.
    MeasureNumerator,
    /// The denominator of L_n, from n = 3.
    MeasureDenominator,
    /// The number of open intervals of s, all cases together, on which on r = 1 a pattern of two impacts i <
    /// j with i + j = n exists, over all i and j; from n = 3.
    TwoImpacts,
    /// The number of impact patterns of period n, up to rotation, where every period may follow every period;
    /// from n = 1.
    Patterns,
    /// The same without those that run through a shorter one several times.
    PrimitivePatterns,
    /// The number of words of n letters, 1 and K counted, over all K; from n = 2.
    Words,
    /// The number of areas of period n in Conjecture 1 with a tip, that is, a least r above 0; from n = 3.
    Tips,
}

impl Sequence {
    /// Its first and its largest n: what takes some seconds.
    fn range(self) -> [u64; 2] {
        match self {
            Sequence::Intervals => [3, 100_000],
            Sequence::MeasureNumerator | Sequence::MeasureDenominator => [3, 10_000],
            Sequence::TwoImpacts => [3, 2000],
            Sequence::Patterns | Sequence::PrimitivePatterns => [1, 400],
            Sequence::Words => [2, 20],
            Sequence::Tips => [3, 200],
        }
    }
}

pub(super) fn run(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    let [first, most] = args.name.range();
    if !(first..=most).contains(&args.last) {
        return Err(Error::input(format!(
            "N = {}: this sequence is listed for N from {first} to {most}",
            args.last
        )));
    }
    let destination = files.destination(args.output.as_deref())?;
    let progress = Progress::new(interrupt, args.last - first + 1, "terms");
    let patterns = match args.name {
        Sequence::Patterns | Sequence::PrimitivePatterns => full_shift(args.last)?,
        _ => Vec::new(),
    };
    destination.list(|out| {
        (first..=args.last).try_for_each(|n| {
            progress.advance(1)?;
            let term = match args.name {
                Sequence::Intervals => intervals(n)?.count().to_string(),
                Sequence::MeasureNumerator => measure(n)?.numer().to_string(),
                Sequence::MeasureDenominator => measure(n)?.denom().to_string(),
                Sequence::TwoImpacts => two_impacts_of(n)?.count().to_string(),
                Sequence::Patterns => patterns[n as usize - 1].0.clone(),
                Sequence::PrimitivePatterns => patterns[n as usize - 1].1.clone(),
                Sequence::Words => words(n as usize).to_string(),
                Sequence::Tips => tips(n)?.to_string(),
            };
            Ok(writeln!(out, "{n} {term}")?)
        })
    })?;
    Ok(Outcome::Done)
}

/// The numbers of patterns, all and primitive, in region 1, where every period is born and may follow every
/// period.
fn full_shift(last: u64) -> Result<Vec<(String, String)>> {
    let number = |p: i32| BigRational::new(p.into(), 2.into());
    let point = Point::Plane(Plane::new(number(6), number(1))?);
    let word = Word::at(&Ladder::default(), &point, true, 1, &())?;
    let counted = ClosedWalks::new(&Relation::new(&word, true, false, last)?).count(last);
    Ok(counted.iter().map(|row| (row.all.to_string(), row.primitive.to_string())).collect())
}

/// The different words of so many letters, as strings: those of all areas whose periods have as many
/// ancestors. For K the letter of the period k of a word U…U is U up to 2K − 2 and D at 2K.
fn words(letters: usize) -> usize {
    let mut all = HashSet::new();
    for first in 2..=letters + 1 {
        let mut begun = vec![String::from("DU")];
        while let Some(word) = begun.pop() {
            if word.len() == letters {
                all.insert(word);
                continue;
            }
            let run = word[2..].bytes().all(|letter| letter == b'U').then_some(first + word.len() - 1);
            if run != Some(2 * first) {
                begun.push(format!("{word}U"));
            }
            if run.is_none_or(|k| k > 2 * first - 2) {
                begun.push(format!("{word}D"));
            }
        }
    }
    all.len()
}

/// The areas of a period whose lowest point lies above r = 0.
fn tips(n: u64) -> Result<usize> {
    // As many as tell 1 − r, which is of the order n⁻³.
    let digits = 8 + 3 * n.to_string().len() as u32;
    let mut count = 0;
    for interval in intervals(n)?.filter(|interval| interval.deciding.is_some()) {
        match Boundary::new(interval).lowest(digits) {
            Some(lowest) => count += usize::from(matches!(lowest, Lowest::Tip(_))),
            None => {
                return Err(Error::input(format!("n = {n}: {digits} digits do not tell where an area ends")));
            }
        }
    }
    Ok(count)
}
