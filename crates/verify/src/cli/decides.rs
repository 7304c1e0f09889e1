//! `grazing word --decides`: how far each parameter may go before a verdict changes.

use std::io::Write;

use num_rational::BigRational;
use num_traits::{Signed, Zero, pow};
use serde_json::{Value as Json, json};

use super::{
    Outcome,
    place::{self, Given, Parameter},
    pretty,
    progress::{Interrupt, Progress},
    reported,
    shares::{self, Limits, sign},
    word::Format,
};
use crate::{
    error::Result,
    output::{
        Caption, Column, Destination, Print, Setting, TableCell, TableFormat, TableWriter, decimal_above,
        decimal_below, decimal_near,
    },
    tolerance::{CaseSigns, Change, Excursion, Leaf, Statement, Toward},
    word::Word,
};

/// Significant digits of a value in text.
const DIGITS: usize = 6;

/// What is asked at the point, of one sign of eµ.
struct Question {
    what: &'static str,
    signs: CaseSigns,
    n: Option<u64>,
    /// Whether it holds there, where that is certain.
    holds: Option<bool>,
    rows: Vec<Row>,
}

/// What becomes of it as one parameter moves in one direction.
struct Row {
    parameter: usize,
    more: bool,
    /// Whether the other coordinate is anywhere in the box.
    whole: bool,
    change: Change,
    /// How far was looked.
    end: BigRational,
}

struct Report {
    given: Given,
    from: Leaf,
    questions: Vec<Question>,
    cells: u64,
}

/// The ways of one coordinate in one direction: with the other at its middle, and anywhere in the box.
struct Ways {
    middle: Excursion,
    whole: Option<Excursion>,
}

impl Ways {
    fn new(given: &Given, axis: usize, rises: bool, cells: u64) -> Result<Ways> {
        let way = |whole| Excursion::new(&given.of, &given.from, Toward { axis, rises, whole }, cells);
        let [lower, upper] = &given.of.bounds()[1 - axis];
        Ok(Ways { middle: way(false)?, whole: (lower != upper).then(|| way(true)).transpose()? })
    }

    /// Where a statement changes: first in all of the box, if it is the same on all of that up to its edge
    /// and the place is known well; else with the other coordinate at its middle.
    fn first(
        &mut self,
        statement: Statement,
        edge: &BigRational,
        progress: &Progress,
    ) -> Result<Option<(Change, bool, BigRational)>> {
        let start = self.middle.start().clone();
        if let Some(way) = &mut self.whole {
            let rises = way.end() > &start;
            let end = way.end().clone();
            let beyond = |x: &BigRational| if rises { x >= edge } else { x <= edge };
            if let Some(change) = way.first(statement, progress)?
                && !change.open
                && beyond(&change.before)
                && change.before != start
            {
                return Ok(Some((change, true, end)));
            }
        }
        let end = self.middle.end().clone();
        Ok(self.middle.first(statement, progress)?.map(|change| (change, false, end)))
    }
}

impl Report {
    fn new(given: Given, limits: &Limits, interrupt: &Interrupt) -> Result<Report> {
        limits.check()?;
        let progress = Progress::new(interrupt, 0, "cells");
        let mut ways = Vec::new();
        for axis in [0, 1] {
            for rises in [false, true] {
                ways.push(Ways::new(&given, axis, rises, limits.cells)?);
            }
        }
        let from = ways[0].middle.from().clone();
        let mut questions = asked(&given, &from, limits.last);
        for question in &mut questions {
            let word = from.word(question.signs.positive).clone();
            let statement = statement(question, &word);
            question.holds = from.holds(statement);
            for (index, parameter) in given.parameters.iter().enumerate() {
                for more in [true, false] {
                    let (axis, along) = parameter.moves();
                    let rises = more == along;
                    let edge = &given.of.bounds()[axis][usize::from(rises)];
                    let found = ways[2 * axis + usize::from(rises)].first(statement, edge, &progress)?;
                    if let Some((change, whole, end)) = found {
                        question.rows.push(Row { parameter: index, more, whole, change, end });
                    }
                }
            }
            question.rows.sort_by_cached_key(|row| given.size(row));
        }
        let cells =
            ways.iter().map(|ways| ways.middle.cells() + ways.whole.as_ref().map_or(0, Excursion::cells));
        Ok(Report { cells: cells.sum(), given, from, questions })
    }

    fn is_open(&self) -> bool {
        self.questions
            .iter()
            .any(|question| question.holds.is_none() || question.rows.iter().any(|row| row.change.open))
    }

    fn heading(&self) -> String {
        let all: Vec<String> = self
            .given
            .parameters
            .iter()
            .map(|parameter| {
                let at = self.given.at(parameter);
                let unit = parameter.unit.as_ref().map_or(String::new(), |unit| format!(" {}", unit.name));
                format!("{} = {}{unit}", place::spoken(parameter.name), place::short(&at))
            })
            .collect();
        let gamma = match (self.given.of.has_gamma(), self.from.gamma) {
            (false, _) => "",
            (true, Some(true)) => "; gamma > 0",
            (true, Some(false)) => "; gamma < 0",
            (true, None) => "; gamma is 0, or may be",
        };
        format!("At {}{gamma}", all.join(", "))
    }
}

impl Given {
    /// A parameter's value at the point, in its own unit.
    fn at(&self, parameter: &Parameter) -> BigRational {
        parameter.shown(&self.from[parameter.moves().0])
    }

    /// What sorts rows: those that change, the least change first.
    fn size(&self, row: &Row) -> (bool, BigRational) {
        let parameter = &self.parameters[row.parameter];
        let from = self.at(parameter);
        let by = (parameter.shown(&row.change.before) - &from).abs();
        (row.change.by.is_none(), if from.is_zero() { by } else { by / from.abs() })
    }

    /// Whether a change lies within the parameter's own tolerance; none if it has none.
    fn inside(&self, row: &Row) -> Option<bool> {
        let parameter = &self.parameters[row.parameter];
        let [lower, upper] = &parameter.bounds;
        let by = parameter.value(row.change.by.as_ref()?);
        (lower != upper).then(|| lower <= &by && &by <= upper)
    }
}

/// The questions: chaos, the words, and every period that occurs at the point.
fn asked(given: &Given, from: &Leaf, last: u64) -> Vec<Question> {
    let new = |what, signs, n| Question { what, signs, n, holds: None, rows: Vec::new() };
    let mut all: Vec<Question> =
        given.of.signs().into_iter().map(|signs| new("chaos", signs, None)).collect();
    for positive in [true, false] {
        let signs = CaseSigns { positive, gamma: None };
        all.push(new("word", signs, None));
        let word = from.word(positive);
        let periods = match word.is_endless() {
            true => word.up_to(last),
            false => word.vertices().iter().copied().filter(|vertex| vertex.period <= last).collect(),
        };
        let mut periods: Vec<u64> = periods.iter().map(|vertex| vertex.period).collect();
        periods.sort_unstable();
        all.extend(periods.into_iter().map(|n| new("period", signs, Some(n))));
    }
    all
}

fn statement<'w>(question: &Question, word: &'w Word) -> Statement<'w> {
    let positive = question.signs.positive;
    match (question.what, question.n) {
        ("chaos", _) => question.signs.chaos(),
        (_, Some(n)) => Statement::Period { positive, n },
        _ => Statement::Word(word),
    }
}

/// `grazing word --decides`.
pub(super) fn run(
    given: Given,
    limits: &Limits,
    format: Format,
    destination: &Destination,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    let format = format.of_table("--decides")?;
    let report = Report::new(given, limits, interrupt)?;
    let written = destination.write(|out| match format {
        TableFormat::Table => Ok(out.write_all(text(&report).as_bytes())?),
        TableFormat::Json => write_json(&report, out),
        table => write_table(&report, table, out),
    });
    reported(if report.is_open() { Outcome::Undecided } else { Outcome::Done }, written)
}

/// How many places have `DIGITS` significant digits of a value.
fn places(of: &BigRational) -> u32 {
    let enough = BigRational::from_integer(pow(10.into(), DIGITS - 1));
    let ten = |places: usize| BigRational::from_integer(pow(10.into(), places));
    (0..30).find(|&places| of.abs() * ten(places) >= enough).unwrap_or(DIGITS) as u32
}

/// A row's `before` and `by`, in the parameter's unit, rounded away from each other.
fn ends(given: &Given, row: &Row) -> (String, Option<String>) {
    let parameter = &given.parameters[row.parameter];
    let places = places(&given.at(parameter));
    let [near, far] = if row.more { [decimal_below, decimal_above] } else { [decimal_above, decimal_below] };
    let by = row.change.by.as_ref().map(|by| far(&parameter.shown(by), places));
    (near(&parameter.shown(&row.change.before), places), by)
}

/// A word, which may go on.
fn spelled(word: &Word) -> String {
    format!("{}{}", word.letters(), if word.is_whole() { "" } else { "..." })
}

fn text(report: &Report) -> String {
    let given = &report.given;
    let mut text = format!(
        "{}\nHow far each parameter may go alone. The first change is between the two numbers of a line.\n",
        report.heading()
    );
    for question in &report.questions {
        text += &format!("\n{}\n", title(report, question));
        for row in &question.rows {
            text += &line(given, question, row);
        }
    }
    text
}

/// What is asked, what is true at the point, and which parameters decide it within their tolerances.
fn title(report: &Report, question: &Question) -> String {
    let name = shares::spoken(question.signs);
    let is = |yes, no| match question.holds {
        Some(true) => yes,
        Some(false) => no,
        None => "not decided at this point",
    };
    let mut title = match (question.what, question.n) {
        ("chaos", _) => format!("Chaos, {name}: {}", is("born", "not born")),
        (_, Some(n)) => format!("Period {n}, {name}: {}", is("occurs", "does not occur")),
        _ => {
            let word = report.from.word(question.signs.positive);
            let open = if question.holds.is_none() { ", not decided at this point" } else { "" };
            format!("Word, {name}: {}{open}", spelled(word))
        }
    };
    let mut decide: Vec<&str> = Vec::new();
    for row in question.rows.iter().filter(|row| report.given.inside(row) == Some(true)) {
        let name = place::spoken(report.given.parameters[row.parameter].name);
        if !decide.contains(&name) {
            decide.push(name);
        }
    }
    if !decide.is_empty() {
        title += &format!(" (decided within its tolerance by: {})", decide.join(", "));
    }
    title
}

fn line(given: &Given, question: &Question, row: &Row) -> String {
    let parameter = &given.parameters[row.parameter];
    let name = place::spoken(parameter.name);
    let unit = parameter.unit.as_ref().map_or(String::new(), |unit| format!(" {}", unit.name));
    let way = if row.more { "up" } else { "down" };
    let end = place::short(&parameter.shown(&row.end));
    let others = if row.whole { ", for all of the box" } else { "" };
    let (before, by) = ends(given, row);
    let Some(by) = by else {
        return match row.change.open {
            true => format!("  {name} {way} to {before}{unit}{others}: the same; beyond, to {end}, open\n"),
            false => format!("  {name} {way} to {end}{unit}{others}: the same\n"),
        };
    };
    let from = given.at(parameter);
    let part = if from.is_zero() {
        String::new()
    } else {
        let hundred = BigRational::from_integer(100.into());
        let part = (parameter.shown(&row.change.before) - &from) / from.abs() * hundred;
        let plus = if part.is_negative() { "" } else { "+" };
        format!(" ({plus}{} %)", decimal_near(&part, 3))
    };
    let open = if row.change.open { "; open between" } else { "" };
    let becomes = becomes(question, row);
    format!("  {name} {before} to {by}{unit}{part}{others}: {becomes}{open}\n")
}

/// What a statement becomes.
fn becomes(question: &Question, row: &Row) -> String {
    let positive = question.signs.positive;
    let Some(after) = &row.change.after else { return String::new() };
    let words =
        format!("{}, then {}", spelled(row.change.until.word(positive)), spelled(after.word(positive)));
    match (question.what, row.change.turns) {
        ("chaos", Some(gamma)) => {
            let born = match after.holds(question.signs.chaos()) {
                Some(true) => "born",
                Some(false) => "not born",
                None => "open",
            };
            format!("gamma {} 0, and chaos {born}", if gamma { '>' } else { '<' })
        }
        ("chaos", None) => format!("{} ({words})", if row.change.holds { "no more" } else { "born" }),
        ("period", _) => format!("gone ({words})"),
        _ => words,
    }
}

fn verdict(row: &Row) -> &'static str {
    match (row.change.open, &row.change.by) {
        (true, _) => "open",
        (false, Some(_)) => "changes",
        (false, None) => "same",
    }
}

fn write_json(report: &Report, out: &mut dyn Write) -> Result<()> {
    let given = &report.given;
    let words = |leaf: &Leaf, positive| spelled(leaf.word(positive));
    let row = |question: &Question, row: &Row| -> Json {
        let parameter = &given.parameters[row.parameter];
        let value = |x: &BigRational| parameter.shown(x).to_string();
        let positive = question.signs.positive;
        let after = row.change.after.as_ref();
        json!({
            "parameter": parameter.name,
            "direction": if row.more { 1 } else { -1 },
            "verdict": verdict(row),
            "unchanged_to": value(&row.change.before),
            "changed_by": row.change.by.as_ref().map(value),
            "looked_to": value(&row.end),
            "inside": given.inside(row),
            "whole_box": row.whole,
            "word_before": words(&row.change.until, positive),
            "word_after": after.map(|leaf| words(leaf, positive)),
            "gamma_after": after.and_then(|leaf| leaf.gamma).map(sign),
            "at": after.map(|leaf| leaf.cell.short_point().iter().map(ToString::to_string).collect::<Vec<_>>()),
        })
    };
    let questions: Vec<Json> = report
        .questions
        .iter()
        .map(|question| {
            json!({
                "what": question.what,
                "sign_emu": sign(question.signs.positive),
                "sign_gamma": question.signs.gamma.or(report.from.gamma.filter(|_| question.what == "chaos")).map(sign),
                "n": question.n,
                "holds": question.holds,
                "changes": question.rows.iter().map(|r| row(question, r)).collect::<Vec<_>>(),
            })
        })
        .collect();
    let parameters: Vec<Json> = given
        .parameters
        .iter()
        .map(|parameter| {
            json!({
                "name": parameter.name,
                "unit": parameter.unit.as_ref().map(|unit| &unit.name),
                "value": given.at(parameter).to_string(),
                "bounds": parameter.tolerance().map(|end| end.to_string()),
            })
        })
        .collect();
    let both = [true, false].map(|positive| words(&report.from, positive));
    let all = json!({
        "format": "grazing-decides 1",
        "at": report.heading(),
        "parameters": parameters,
        "sign_gamma": report.from.gamma.map(sign),
        "words": both,
        "cells": report.cells,
        "questions": questions,
    });
    pretty(&all, out)
}

fn write_table(report: &Report, format: TableFormat, out: &mut dyn Write) -> Result<()> {
    let print = format.is_print();
    let given = &report.given;
    let mut columns = vec![Column::new("what", "", 0).print(Print::Left)];
    columns.extend(shares::signs_columns(print));
    columns.extend([
        Column::new("n", "$n$", 0),
        Column::new("parameter", "parameter", 0).print(Print::Left),
        Column::new("unit", "", 0).print(Print::Left),
        Column::new("unchanged_to", "the same to", 0),
        Column::new("changed_by", "other by", 0),
        Column::new("verdict", "", 0).print(Print::Left),
        Column::new("word_after", "word", 0).print(Print::Left),
    ]);
    let caption = Caption {
        text: format!(
            "How far each parameter may go alone from the middle of {} before chaos, the word or a period is \
             another: the first change is between the two values.",
            place::in_latex(&given.bounds)
        ),
        label: "tab:decides".into(),
    };
    let setting = Setting { caption: Some(&caption), ..Setting::default() };
    let mut table = TableWriter::set(out, format, "grazing-decides 1", columns, setting)?;
    for question in &report.questions {
        let signs = question.signs;
        let case = shares::in_maths(signs);
        for row in &question.rows {
            let (before, by) = ends(given, row);
            let parameter = &given.parameters[row.parameter];
            let word = row.change.after.as_ref().map(|leaf| spelled(leaf.word(signs.positive)));
            let mut cells = vec![TableCell::Text(question.what)];
            cells.extend(shares::signs_cells(print, Some((signs.positive, signs.gamma)), &case));
            cells.extend([
                question.n.map_or(TableCell::Empty, |n| TableCell::Int(n as i64)),
                TableCell::Text(place::spoken(parameter.name)),
                parameter.unit.as_ref().map_or(TableCell::Empty, |unit| TableCell::Text(&unit.name)),
                TableCell::Text(&before),
                by.as_deref().map_or(TableCell::Empty, TableCell::Text),
                TableCell::Text(verdict(row)),
                word.as_deref().map_or(TableCell::Empty, TableCell::Text),
            ]);
            table.row(&cells)?;
        }
    }
    table.finish()
}
