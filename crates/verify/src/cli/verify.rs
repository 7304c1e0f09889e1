//! `grazing verify`: prove Theorem 2 for given periods.

use std::{
    io::Write,
    ops::{Range, RangeInclusive},
    path::PathBuf,
    str::FromStr,
};

use clap::Parser;
use serde_json::json;

use super::{
    Outcome, ReportFormat, in_pool,
    range::Periods,
    reported,
    shards::{Certified, Merged, Part, ShardSet, certificate_line, certify, part_of, periods_of, task_of},
};
use crate::{
    certificate::check,
    cli::choice::{Choice, choice},
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    existence::Decision,
    number::parse_integer,
    output::{Destination, FileRegistry, OutputFile, Shard},
    search::{
        Proof, ProofMethod, assemble_theorem2, entropy_certificate, prove_theorem2, theorem2_blocks,
        write_theorem2,
    },
};

/// The largest period, as in certificates.
const LIMIT: u64 = 200_000;

/// Prove Theorem 2 for every period in a range, by exact decision, by enclosures, or both.
///
/// Exactly: for each n, (0, 1/2) is cut at every zero and pole of every b_{n,k} and c_n. Integer arithmetic
/// decides all signs, and the set where (52) and (53) hold is compared with the theorem's intervals. The
/// proof of the theorem is not used. Periods 1 and 2 are compared with the summary by period.
///
/// By enclosures: the arguments of (B1) and (B2) are bounded over whole closed stretches, and the sign of
/// each factor is proved on their interior. The two methods share no code for signs.
///
/// Exit code 0: proved for all; 1: refuted for some; 2: wrong usage or a file that cannot be written; 3:
/// undecided or interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing verify
  grazing verify 3..=100 --certificate theorem2.txt
  grazing verify 8 --method both --format json
  grazing verify --entropy --certificate entropy.txt")]
pub struct Args {
    /// The periods: N, or A..=B. At most 200000.
    #[arg(default_value = "3..=500", value_name = "N|A..=B")]
    periods: Periods,
    /// Prove instead, for every r <= 1 and s with e*mu > 0, the least upper bounds of the entropy of the
    /// patterns that are born, by finitely many beginnings of words. It rests on the word theorem.
    #[arg(long, conflicts_with_all = ["periods", "method", "shard", "jobs"])]
    entropy: bool,
    /// How signs are decided; with both, the methods must agree.
    #[arg(long, value_parser = choice::<ProofMethod>(), default_value = "exact")]
    method: ProofMethod,
    /// Write a certificate (of the exact method), which `grazing check` proves again without search.
    #[arg(long, value_name = "FILE")]
    certificate: Option<PathBuf>,
    /// Prove the I-th of N parts only, and write a shard of the certificate, for `grazing merge`.
    #[arg(long, value_name = "I/N", requires = "certificate", value_parser = Shard::from_str)]
    shard: Option<Shard>,
    /// The number of threads; default: one for each core.
    #[arg(long, value_name = "J", default_value_t = 0, hide_default_value = true, value_parser = parse_integer::<usize>)]
    jobs: usize,
    /// How the result is written.
    #[arg(long, value_enum, default_value_t = ReportFormat::Text)]
    pub(super) format: ReportFormat,
    /// Write the result to a file instead of standard output.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub(super) fn run(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    if args.entropy {
        return suprema(args, files, interrupt);
    }
    let range = args.periods.within(LIMIT, "verify")?;
    if args.method == ProofMethod::Interval && args.certificate.is_some() {
        return Err(Error::input(
            "a certificate holds what the exact method found: use --method exact or both",
        ));
    }
    let certificate =
        args.certificate.as_deref().map(|path| files.write("--certificate", path)).transpose()?;
    let output = files.destination(args.output.as_deref())?;
    in_pool(args.jobs, || verify(range, args, certificate, &output, interrupt))
}

/// `--entropy`: the certificate is found, and proved by the checker.
fn suprema(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    if args.format == ReportFormat::Json {
        return Err(Error::input(
            "--entropy reports in text: write its --certificate, and `grazing check --format json` reports that",
        ));
    }
    let file = args.certificate.as_deref().map(|path| files.write("--certificate", path)).transpose()?;
    let output = files.destination(args.output.as_deref())?;
    let text = entropy_certificate(&Progress::new(interrupt, 0, "words"))?;
    let (outcome, mut report) = match check(&mut text.as_bytes()) {
        Ok(checked) => (Outcome::Done, format!("{checked}\n")),
        Err(rejection) => (Outcome::Undecided, format!("not proved: {rejection}\n")),
    };
    let kept = match &file {
        Some(file) if outcome == Outcome::Done => file.write(|out| Ok(out.write_all(text.as_bytes())?)),
        _ => Ok(()),
    };
    if let (Some(path), Outcome::Done, Ok(())) = (&args.certificate, outcome, &kept) {
        report += &certificate_line(path, None);
    }
    reported(outcome, kept.and(output.write(|out| Ok(out.write_all(report.as_bytes())?))))
}

/// What shards are parts of.
fn words(range: &RangeInclusive<u64>) -> [String; 2] {
    ["verify".into(), format!("{range:?}")]
}

/// The certificate from its shards.
pub(super) fn merge(args: &Args, set: &ShardSet, merged: &Merged, interrupt: &Interrupt) -> Result<Outcome> {
    let range = args.periods.within(LIMIT, "verify")?;
    set.expect(&task_of(words(&range)))?;
    let all = *range.start()..*range.end() + 1;
    certify(merged, set, all, &Blocks { range: &range, interrupt }, interrupt)
}

/// The periods of a campaign.
struct Blocks<'a> {
    range: &'a RangeInclusive<u64>,
    interrupt: &'a Interrupt,
}

impl Certified for Blocks<'_> {
    fn items(&self, shard: Shard) -> Range<u64> {
        part_of(self.range, 2, shard)
    }

    fn write(&self, items: Range<u64>, set: &ShardSet, out: &mut dyn Write) -> Result<()> {
        let mut lines = 0;
        set.texts(
            |shard| self.items(shard),
            |block| {
                lines += block.lines().count() as u64;
                self.interrupt.check()
            },
        )?;
        assemble_theorem2(&(items.start..=items.end - 1), lines, out, |out| {
            set.texts(|shard| self.items(shard), |block| Ok(out.write_all(block.as_bytes())?))
        })
    }
}

fn verify(
    range: RangeInclusive<u64>,
    args: &Args,
    certificate: Option<OutputFile>,
    output: &Destination,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    let task = task_of(words(&range));
    let range = periods_of(&range, 2, args.shard);
    let passes = if args.certificate.is_some() { 2 } else { 1 };
    let progress = Progress::new(interrupt, passes * range.clone().count() as u64, "periods");
    let proof = prove_theorem2(range.clone(), args.method, &progress)?;
    match (certificate, args.shard) {
        _ if outcome(&proof) != Outcome::Done => {}
        (Some(file), None) => file.write(|out| write_theorem2(range.clone(), &proof, out, &progress))?,
        (Some(file), Some(shard)) => Part { task, shard, file }.write(|out| {
            theorem2_blocks(range.clone(), &progress, |n, block| out.record(n, &json!(block).to_string()))
        })?,
        (None, _) => {}
    }
    drop(progress);
    let report = match args.format {
        ReportFormat::Text => text(&range, &proof, args),
        ReportFormat::Json => format!("{}\n", json_report(&range, &proof, args)),
    };
    reported(outcome(&proof), output.write(|out| Ok(out.write_all(report.as_bytes())?)))
}

fn outcome(proof: &Proof) -> Outcome {
    match proof {
        Proof { refuted: Some(_), .. } | Proof { contradiction: Some(_), .. } => Outcome::Refuted,
        Proof { pending: 0, undecided: 0, .. } => Outcome::Done,
        Proof { pending: 0, .. } => Outcome::Undecided,
        _ => Outcome::Interrupted,
    }
}

fn text(range: &RangeInclusive<u64>, proof: &Proof, args: &Args) -> String {
    if let Some(n) = proof.contradiction {
        return format!("Refuted: the exact method and enclosures find different orbits for n = {n}.\n");
    }
    if let Some(decision) = &proof.refuted {
        return format!(
            "Refuted: Theorem 2 and the signs of b_{{n,k}} and c_n disagree for n = {}.\n{}\n",
            decision.n,
            witness(decision)
        );
    }
    let how = match args.method {
        ProofMethod::Exact => "by exact decision",
        ProofMethod::Interval => "by enclosures",
        ProofMethod::Both => "by exact decision and by enclosures, which agree",
    };
    let mut text = match (proof.pending, proof.undecided) {
        (0, 0) => format!("Proved: Theorem 2 for {}, {how}.\n", periods(range)),
        (0, undecided) => format!(
            "Undecided: Theorem 2 is proved for {} of the periods in {range:?}, enclosures leave {undecided} open.\n",
            proof.periods
        ),
        (pending, _) => format!(
            "Interrupted: Theorem 2 is proved for {} of the periods in {range:?}, {pending} are pending.\n",
            proof.periods
        ),
    };
    let rows = [
        (proof.orbits, "open intervals with an orbit: every b_{n,k} and c_n of the sign required"),
        (proof.stretches, "open stretches without an orbit: two b_{n,k} of opposite sign on each"),
        (proof.singular, "break points where u_n = 0 (singular: Theorem 1 is silent)"),
        (proof.boundary, "break points where some b_{n,k} = 0, the rest of one sign (boundary)"),
        (proof.excluded, "break points where two b_{n,k} have opposite signs (no orbit)"),
    ];
    for (count, what) in rows {
        text += &format!("{count:>12}  {what}\n");
    }
    if let (Some(path), Outcome::Done) = (&args.certificate, outcome(proof)) {
        text += &certificate_line(path, args.shard);
    }
    text
}

fn periods(range: &RangeInclusive<u64>) -> String {
    if range.is_empty() {
        "no period: this part is empty".to_string()
    } else if range.start() == range.end() {
        format!("period n = {}", range.start())
    } else {
        format!("every period n in {}..={}", range.start(), range.end())
    }
}

fn witness(decision: &Decision) -> String {
    let Some((decided, claimed)) = &decision.disagreement else { return String::new() };
    let show = |interval: &Option<crate::existence::Interval>| match interval {
        Some(i) => format!("{} on ({}, {})", i.case, i.left, i.right),
        None => "no further interval".to_string(),
    };
    format!("Decided: {}; claimed: {}.", show(decided), show(claimed))
}

fn json_report(range: &RangeInclusive<u64>, proof: &Proof, args: &Args) -> serde_json::Value {
    json!({
        "format": "grazing-verify 1",
        "statement": "theorem2",
        "verdict": match outcome(proof) {
            Outcome::Done => "proved",
            other => other.word(),
        },
        "method": args.method.word(),
        "range": [range.start(), range.end()],
        "periods": proof.periods,
        "pending": proof.pending,
        "undecided": proof.undecided,
        "orbit_intervals": proof.orbits,
        "stretches": proof.stretches,
        "singular_points": proof.singular,
        "boundary_points": proof.boundary,
        "excluded_points": proof.excluded,
        "witness": proof.refuted.as_ref().map(|decision| json!({ "n": decision.n, "reason": witness(decision) })),
        "contradiction": proof.contradiction,
        "shard": args.shard.map(|shard| shard.to_string()),
        "certificate": args.certificate.as_ref().filter(|_| outcome(proof) == Outcome::Done),
    })
}
