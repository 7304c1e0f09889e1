//! What is true of all points of a box of a₁ and a₂, or of r and s; and in which share of it, where that
//! differs. The numbers are those of `grazing word --shares`.

use grazing_scenes::{
    Error, Result,
    internals::output::{decimal_above, decimal_below, decimal_or_fraction},
    num_rational::BigRational,
    number::parse_rational,
    tolerance::{MOST_CELLS, ParameterBox, Partition, Share, Subject},
};
use serde_json::{Value as Json, json};

use super::chart::integer;

/// Cells of a box and periods that are looked at where nothing else is asked for, as on the command line.
const CELLS: u64 = 2000;
const LAST: u64 = 12;

/// The names of both parameters and their bounds.
type Bounds = [(&'static str, [BigRational; 2]); 2];

fn asked(request: &Json) -> Result<(ParameterBox, Bounds)> {
    let ends = |name: &'static str| -> Result<(&'static str, [BigRational; 2])> {
        let end = |i: usize| match &request[name][i] {
            Json::String(text) => parse_rational(text).map_err(Error::from),
            _ => Err(Error::input(format!("{name}: two exact numbers as text are wanted"))),
        };
        Ok((name, [end(0)?, end(1)?]))
    };
    let bounds = if request["a1"].is_null() { [ends("r")?, ends("s")?] } else { [ends("a1")?, ends("a2")?] };
    let [first, second] = [&bounds[0].1, &bounds[1].1].map(Clone::clone);
    let of = match bounds[0].0 {
        "r" => ParameterBox::polar(first, second)?,
        _ => ParameterBox::plane(first, second)?,
    };
    Ok((of, bounds))
}

/// Its verdict, bounds of the share in hundredths that lie on the right side, and where it is so and not.
fn with_share(mut what: Json, share: &Share) -> Json {
    let at = |point: &Option<Vec<BigRational>>| {
        point.as_ref().map(|point| point.iter().map(decimal_or_fraction).collect::<Vec<_>>())
    };
    what["verdict"] = json!(share.spread().word());
    what["percent"] = json!([
        decimal_below(&(&share.lower * integer(100)), 2),
        decimal_above(&(&share.upper * integer(100)), 2)
    ]);
    what["with"] = json!(at(&share.with));
    what["without"] = json!(at(&share.without));
    what
}

fn sign(positive: bool) -> i64 {
    if positive { 1 } else { -1 }
}

/// What is certain on a box.
///
/// # Errors
/// An input error for what is no box with a₂ ≤ 1, or r ≤ 1 and 0 < s < ½.
pub fn shares(request: &Json) -> Result<Json> {
    let (of, bounds) = asked(request)?;
    let cells = request["cells"].as_u64().unwrap_or(CELLS);
    if !(1..=MOST_CELLS).contains(&cells) {
        return Err(Error::input(format!("{cells} cells: from 1 to {MOST_CELLS}")));
    }
    let partition = Partition::new(&of, cells, &())?;
    let (mut chaos, mut periods, mut words) = (Vec::new(), Vec::new(), Vec::new());
    for one in partition.verdicts(of.signs(), LAST) {
        match &one.subject {
            Subject::Chaos(signs) => chaos.push(with_share(
                json!({ "sign_emu": sign(signs.positive), "sign_gamma": signs.gamma.map(sign) }),
                &one.share,
            )),
            Subject::Period { positive, n } => {
                periods.push(with_share(json!({ "sign_emu": sign(*positive), "n": n }), &one.share));
            }
            Subject::Word { positive, word } => words.push(with_share(
                json!({
                    "sign_emu": sign(*positive),
                    "letters": word.letters(),
                    "periods": word.vertices().iter().map(|vertex| vertex.period).collect::<Vec<_>>(),
                    "endless": word.is_endless(),
                }),
                &one.share,
            )),
        }
    }
    let side = |positive| if positive { "eµ > 0" } else { "eµ < 0" };
    let open = partition.open().map(|leaf| {
        json!({
            "why": leaf.why_open(side).unwrap_or_default(),
            "cell": leaf.cell.bounds().each_ref().map(|ends| ends.each_ref().map(decimal_or_fraction)),
        })
    });
    let range = |(name, [lower, upper]): &(&str, [BigRational; 2])| {
        format!("--{name}={}..={}", decimal_or_fraction(lower), decimal_or_fraction(upper))
    };
    let more = if cells == CELLS { String::new() } else { format!(" --cells {cells}") };
    Ok(json!({
        "names": bounds.each_ref().map(|(name, _)| *name),
        "bounds": bounds.each_ref().map(|(_, ends)| ends.each_ref().map(decimal_or_fraction)),
        "cells": partition.cells(),
        "cut": partition.is_cut(),
        "settled": decimal_below(&(partition.settled() * integer(100)), 2),
        "last": LAST,
        "chaos": chaos,
        "periods": periods,
        "words": words,
        "open": open,
        "options": format!("{} {} --shares{more}", range(&bounds[0]), range(&bounds[1])),
    }))
}
