//! What is born at a touch of machines that are known up to tolerances: for the task `grazing`.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;
use serde::Serialize;

use super::{Lines, Status, range::inwards};
use crate::{
    error::Result,
    monitor::Monitor,
    output::{decimal_above, decimal_below, decimal_or_fraction},
    scene::{
        is_hidden,
        tolerated::{Tolerated, ToleratedMachines},
    },
    tolerance::{Partition, Share, Spread, Statement},
    word::Word,
};

/// Into how many cells a box is cut at most, and one of more than two parameters.
const CELLS: u64 = 2000;
const CELLS_OF_MORE: u64 = 8000;
/// How many letters of a word are followed.
const LETTERS: usize = 100;
/// The longest period whose resonance is told.
const RESONANCES: u64 = 60;
/// Decimals of shares.
const PLACES: u32 = 6;
/// The longest numbers in words, in characters, and the digits of others.
const LONGEST: usize = 18;
const DIGITS: i32 = 15;

/// A parameter and what its tolerance allows.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ToleratedParameter {
    /// Its name.
    pub name: String,
    /// Its least value, exactly.
    pub lower: String,
    /// Its greatest.
    pub upper: String,
    /// Whether damping or stiffness depend on it, and so what is born.
    pub moves: bool,
    /// Both in words, inwards where they have many digits: what is told is told of these, too.
    #[serde(skip)]
    pub(crate) shown: [String; 2],
}

/// What is born on one side of the touch.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ToleranceSide {
    /// `before` the touch, where the gap of the motion without impacts is open, or `beyond` it.
    pub side: &'static str,
    /// The sign of eµ there.
    pub sign_emu: i32,
    /// What the words of all machines begin with.
    pub word: String,
    /// The periods of these letters: each can occur between impacts, for all of them.
    pub periods: Vec<u64>,
    /// Whether it is the whole word of each.
    pub whole: bool,
    /// Why it ends there.
    pub word_ends: String,
    /// Of how many machines chaos is born: `everywhere`, `nowhere`, `differs` or `open`.
    pub chaos: &'static str,
    /// At least this share of the box has it, and at most this, every part counting by its size.
    pub share: [String; 2],
    /// A machine with it.
    pub with: Option<Vec<ParameterValue>>,
    /// One without.
    pub without: Option<Vec<ParameterValue>>,
}

/// A first resonance, s = 1/(2n) and u_n = 0, that some machines have, or may have. Beyond the touch the
/// orbit of one impact in n periods is born below it and at it, for γ > 0, and nowhere else.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ToleranceResonance {
    /// n.
    pub period: u64,
    /// At least this share of the box is below it, s < 1/(2n), and at most this.
    pub share: [String; 2],
    /// A machine below it.
    pub below: Option<Vec<ParameterValue>>,
    /// One above it.
    pub above: Option<Vec<ParameterValue>>,
}

/// A parameter of a machine.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ParameterValue {
    /// Its name.
    pub name: String,
    /// Its value, exactly.
    pub value: String,
}

/// What is born at a touch of all machines that tolerances allow, of each at its own.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ToleranceReport {
    /// The parameters with tolerances: the box.
    pub parameters: Vec<ToleratedParameter>,
    /// The sign of γ that all have; null if there is not one, or that is not certain.
    pub sign_gamma: Option<i32>,
    /// Before the touch, and beyond it.
    pub sides: [ToleranceSide; 2],
    /// The first resonances among the machines, of periods up to 60.
    pub resonances: Vec<ToleranceResonance>,
    /// How many cells the box was cut into, those that were cut again included.
    pub cells: u64,
    /// Whether more cells might tell more.
    pub cut: bool,
    /// On at least this share of the box both words are certain.
    pub settled: String,
    /// What is open on the largest cell on which something is, and where that is.
    pub open: Option<String>,
}

/// What a sign of eµ is called.
fn side(positive: bool) -> &'static str {
    if positive { "before" } else { "beyond" }
}

fn in_words(positive: bool) -> &'static str {
    if positive { "before the touch" } else { "beyond the touch" }
}

/// Cost: some 50 µs per cell, of which there are at most 2000; of more than two parameters 8000.
///
/// # Errors
/// The monitor's interruption.
pub(super) fn told(machines: &ToleratedMachines, monitor: &dyn Monitor) -> Result<ToleranceReport> {
    let ToleratedMachines { parameters, of } = machines;
    // What is no parameter of the scene is known well.
    let parameters: Vec<Tolerated> = parameters.iter().filter(|one| !is_hidden(&one.name)).cloned().collect();
    let parameters = &parameters[..];
    let cells = if of.sides().count() > 2 { CELLS_OF_MORE } else { CELLS };
    let partition = Partition::new(of, cells, monitor)?;
    let place = |point: &Option<Vec<BigRational>>| point.as_ref().map(|point| named(parameters, point));
    let shares = |share: &Share| [decimal_below(&share.lower, PLACES), decimal_above(&share.upper, PLACES)];
    let one = |positive: bool| -> Result<ToleranceSide> {
        let word: Word = of.word(positive, LETTERS, monitor)?;
        let share = partition.share(Statement::ChaosAt { positive });
        Ok(ToleranceSide {
            side: side(positive),
            sign_emu: if positive { 1 } else { -1 },
            word: word.letters(),
            periods: word.vertices().iter().map(|vertex| vertex.period).collect(),
            whole: word.is_whole(),
            word_ends: word.extent().in_words(),
            chaos: share.spread().word(),
            share: shares(&share),
            with: place(&share.with),
            without: place(&share.without),
        })
    };
    // For eµ < 0 the periods that occur are those with s < 1/(2n).
    let resonance = |period: u64| {
        let share = partition.share(Statement::Period { positive: false, n: period });
        matches!(share.spread(), Spread::Differs | Spread::Open).then(|| ToleranceResonance {
            period,
            share: shares(&share),
            below: place(&share.with),
            above: place(&share.without),
        })
    };
    let open = partition.open().and_then(|leaf| {
        let why = leaf.why_open(in_words)?;
        let within = |one: &Tolerated| {
            let [lower, upper] = leaf.cell.sides().nth(one.axis?)?;
            Some(between(&one.name, lower, upper))
        };
        let place: Vec<String> = parameters.iter().filter_map(within).collect();
        Some(format!("{why}, at {}", place.join(", ")))
    });
    Ok(ToleranceReport {
        parameters: parameters.iter().map(ToleratedParameter::of).collect(),
        sign_gamma: of.gamma_is_positive().map(|positive| if positive { 1 } else { -1 }),
        sides: [one(true)?, one(false)?],
        resonances: (2..=RESONANCES).filter_map(resonance).collect(),
        cells: partition.cells(),
        cut: partition.is_cut(),
        settled: decimal_below(&partition.settled(), PLACES),
        open,
    })
}

/// A machine by the parameters that move it.
fn named(parameters: &[Tolerated], point: &[BigRational]) -> Vec<ParameterValue> {
    let value = |one: &Tolerated| {
        let value = decimal_or_fraction(&point[one.axis?]);
        Some(ParameterValue { name: one.name.clone(), value })
    };
    parameters.iter().filter_map(value).collect()
}

/// A number in few digits, which is towards another if it has more.
fn short(x: &BigRational, other: &BigRational) -> String {
    let exactly = decimal_or_fraction(x);
    if exactly.len() <= LONGEST { exactly } else { inwards(x, other, DIGITS) }
}

/// A cell's side, outwards where its ends have many digits.
fn between(name: &str, lower: &BigRational, upper: &BigRational) -> String {
    let far = lower.abs() + upper.abs();
    format!("{} <= {name} <= {}", short(lower, &(lower - &far)), short(upper, &(upper + &far)))
}

impl ToleratedParameter {
    fn of(one: &Tolerated) -> ToleratedParameter {
        let [from, to] = &one.bounds;
        let [lower, upper] = [from, to].map(decimal_or_fraction);
        let shown = [short(from, to), short(to, from)];
        ToleratedParameter { name: one.name.clone(), lower, upper, moves: one.axis.is_some(), shown }
    }
}

impl ToleranceSide {
    fn word_in_words(&self) -> String {
        let (side, word, ends) = (in_words(self.sign_emu > 0), &self.word, &self.word_ends);
        match (self.whole, word.as_str()) {
            (true, "") => format!("{side} none, of all of them: {ends}"),
            (true, _) => format!("{side} {word}, of all of them: {ends}"),
            (false, "") => format!("{side} nothing that all have in common: {ends}"),
            (false, _) => format!("{side} {word} is what all begin with: {ends}"),
        }
    }

    fn chaos_in_words(&self) -> String {
        let side = in_words(self.sign_emu > 0);
        match (self.chaos, &self.with, &self.without) {
            ("everywhere", ..) => format!("{side} born in all of them"),
            ("nowhere", ..) => format!("{side} born in none of them"),
            (_, Some(with), Some(without)) => {
                let [with, without] = [with, without].map(|point| told_of(point));
                format!("{side} born in {} of them: so at {with}, not at {without}", per_cent(&self.share))
            }
            _ => format!("{side} open: born in {} of them", per_cent(&self.share)),
        }
    }
}

/// A machine in words.
fn told_of(point: &[ParameterValue]) -> String {
    let all = point.iter().map(|ParameterValue { name, value }| format!("{name} = {value}"));
    all.collect::<Vec<_>>().join(", ")
}

/// Two shares in per cent.
fn per_cent(share: &[String; 2]) -> String {
    let [lower, upper] = share.each_ref().map(|end| {
        let number = crate::number::parse_rational(end);
        number.map_or_else(|_| BigRational::from_integer(0.into()), |x| x * BigInt::from(100))
    });
    format!("{} % to {} %", decimal_below(&lower, 2), decimal_above(&upper, 2))
}

impl ToleranceResonance {
    /// Where it is; whether it is among the machines is certain if one is below it and one above.
    fn place_in_words(&self) -> String {
        let (n, twice) = (self.period, 2 * self.period);
        match (&self.below, &self.above) {
            (Some(below), Some(above)) => {
                let [below, above] = [below, above].map(|point| told_of(point));
                let part = per_cent(&self.share);
                format!(
                    "n = {n}: s < 1/{twice} for {part} of them, so at {below}, and s > 1/{twice} at {above}"
                )
            }
            _ => format!("n = {n}: s = 1/{twice} may be among them"),
        }
    }

    /// What is born of one impact on both sides of all of them, and there.
    fn born_in_words(gamma: Option<i32>) -> String {
        let none = "where s = 1/(2n) or next to it";
        if gamma == Some(-1) {
            return format!("of one impact in n periods no orbit is born, {none}");
        }
        let some = "of one impact in n periods one orbit is born beyond the touch where s < 1/(2n), and where s = 1/(2n), there \
                    with a speed like the root of the distance, stable, both multipliers tau r^n (damped, restitution at \
                    most 1); none where s > 1/(2n), but next to it one before the touch";
        match gamma {
            Some(_) => some.into(),
            None => format!("for gamma > 0 {some}; for gamma < 0 none, {none}"),
        }
    }
}

impl ToleranceReport {
    /// Whether a verdict is open.
    pub(super) fn status(&self) -> Status {
        match self.sides.iter().find(|side| side.chaos == "open") {
            Some(side) => Status::undecided(format!(
                "whether chaos is born {} of all machines within the tolerances is open",
                in_words(side.sign_emu > 0)
            )),
            None => Status::Done,
        }
    }

    pub(super) fn lines(&self, lines: &mut Lines) {
        let shown = |moves: bool| {
            let some = self.parameters.iter().filter(move |one| one.moves == moves);
            some.map(|one| format!("{} <= {} <= {}", one.shown[0], one.name, one.shown[1]))
                .collect::<Vec<_>>()
                .join(", ")
        };
        let (moving, others) = (shown(true), shown(false));
        let all =
            if moving.is_empty() { "all machines".into() } else { format!("all machines with {moving}") };
        let gamma = match self.sign_gamma {
            Some(sign) if sign > 0 => "gamma > 0 for all of them",
            Some(_) => "gamma < 0 for all of them",
            None => "gamma has not one sign, or may be 0",
        };
        let rest = match others.as_str() {
            "" => String::new(),
            others => format!("; what is born does not depend on {others}"),
        };
        lines.say("tolerance", format!("{all}, where each touches the stop once a period: {gamma}{rest}"));
        for side in &self.sides {
            lines.say("tolerance_word", side.word_in_words());
        }
        if !self.resonances.is_empty() {
            let places: Vec<String> =
                self.resonances.iter().map(ToleranceResonance::place_in_words).collect();
            let born = ToleranceResonance::born_in_words(self.sign_gamma);
            lines.say("tolerance_resonance", format!("u_n = 0 at s = 1/(2n), {}: {born}", places.join("; ")));
        }
        for side in &self.sides {
            lines.say("tolerance_chaos", side.chaos_in_words());
        }
        lines.say_known("tolerance_open", &self.open);
    }
}
