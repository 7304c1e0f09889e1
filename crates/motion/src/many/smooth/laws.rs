//! Stops whose force is a law of depth and speed, and friction that follows the sliding speed, as formulas in
//! the motion.
//!
//! What a machine is made of stands in such a formula as coefficients, so that it changes with a parameter
//! as they do. Where they are negative or positive is decided by kinks (`kinks`).

use std::sync::Arc;

use super::{SwitchOf, joined, number};
use crate::{
    error::{Error, Result},
    formula::{Choice, Formula, Function, Operation},
    many::{Friction, Machine, NormalForce, RealVector, Stop, StopLaw, stribeck::SlidingLaw},
    motion::{
        Harmonic, SmoothForce,
        flow::{Gradient, Scalar},
    },
};

/// A number with its derivative in a parameter.
type Dual = Gradient<2>;

/// The force of a stop or of friction.
pub(super) struct Law {
    /// What a force of 1 is on the points, and the derivative of that.
    pub row: [RealVector; 2],
    pub name: String,
    pub force: SmoothForce<f64>,
    /// What its coefficients change by.
    pub slopes: Vec<f64>,
    /// Its switches, and what they decide.
    pub roles: Vec<(Formula, SwitchOf)>,
}

/// The laws of a machine, and how many of them are those of stops, which come before those of friction. Where
/// the coefficients of the machine change at the rates `slope`, those of the laws do as `slopes` says.
///
/// # Errors
/// Those of [`Machine::rubs`]; an entry of a row that is 0 and changes.
pub(super) fn laws(machine: &Machine<f64>, slope: Option<&Machine<f64>>) -> Result<(Vec<Law>, usize)> {
    let mut all = Vec::new();
    let builder = || Builder::new(machine, slope);
    for (place, stop) in machine.stops.iter().enumerate() {
        let StopLaw::Formula(force) = &stop.law else { continue };
        all.push(builder().of_stop(place, (stop, force), slope.map(|slope| &slope.stops[place]))?);
    }
    let stops = all.len();
    let rubs = if machine.has_sliding_laws() { machine.rubs()? } else { Vec::new() };
    for (place, (rub, friction)) in rubs.iter().zip(&machine.friction).enumerate() {
        let (Some(law), Some(own)) = (&rub.law, &friction.law) else { continue };
        let change = slope.map(|slope| &slope.friction[place]);
        all.push(builder().of_friction(place, (friction, own, law), change)?);
    }
    Ok((all, stops))
}

/// A formula being made, with the coefficients so far.
struct Builder {
    points: usize,
    /// Ω.
    rate: Dual,
    numbers: Vec<Dual>,
}

impl Builder {
    fn new(machine: &Machine<f64>, slope: Option<&Machine<f64>>) -> Builder {
        let faster = slope.map_or(0.0, |slope| -machine.rate() * slope.period / machine.period);
        Builder { points: machine.points(), rate: Gradient([machine.rate(), faster]), numbers: Vec::new() }
    }

    /// The time's place among the variables.
    fn time(&self) -> usize {
        2 * self.points
    }

    /// A coefficient.
    fn number(&mut self, value: Dual) -> Formula {
        self.numbers.push(value);
        Formula::Variable(self.time() + self.numbers.len())
    }

    /// A law of these variables, with its own coefficients.
    fn applied(
        &mut self,
        formula: &Formula,
        (law, change): (&SmoothForce<f64>, Option<&SmoothForce<f64>>),
        variables: &[Formula],
    ) -> Formula {
        let mut own = Vec::new();
        for (i, value) in law.coefficients.iter().enumerate() {
            own.push(self.number(dual(*value, change.map(|change| change.coefficients[i]))));
        }
        formula.substituted(&|place| match place.checked_sub(variables.len()) {
            Some(coefficient) => own[coefficient].clone(),
            None => variables[place].clone(),
        })
    }

    /// Σ of multiples of formulas, but for those that are 0.
    fn sum(&mut self, terms: Vec<(Dual, Formula)>) -> Result<Formula> {
        let mut parts = Vec::new();
        for (factor, of) in terms {
            let Gradient([value, slope]) = factor;
            if value != 0.0 {
                parts.push(joined(Operation::Product, self.number(factor), of));
            } else if slope != 0.0 {
                return Err(Error::input(
                    "a number of a stop or of friction with a law of its own is 0 here and changes with the parameter: how the \
                     motion changes with that is not followed",
                ));
            }
        }
        let all = parts.into_iter().reduce(|sum, part| joined(Operation::Sum, sum, part));
        Ok(all.unwrap_or_else(|| number(0.0)))
    }

    /// The terms of a motion and those of its velocity per unit of time, times a sign.
    fn moved(&self, sign: f64, harmonics: &[Harmonic<f64>], change: Option<&[Harmonic<f64>]>) -> [Terms; 2] {
        let (mut place, mut speed) = (Vec::new(), Vec::new());
        for (i, h) in harmonics.iter().enumerate() {
            let own = change.map(|change| &change[i]);
            let cos = dual(h.cos, own.map(|own| own.cos)).scaled(sign);
            let sin = dual(h.sin, own.map(|own| own.sin)).scaled(sign);
            let by = self.rate.scaled(f64::from(h.k));
            let turn = |function| turn(function, h.k, self.time());
            place.extend([(cos, turn(Function::Cos)), (sin, turn(Function::Sin))]);
            speed.extend([(-(by * cos), turn(Function::Sin)), (by * sin, turn(Function::Cos))]);
        }
        [place, speed]
    }

    /// The terms of a row times a sign, of the variables from a place on.
    fn row(&self, sign: f64, [row, change]: &[RealVector; 2], from: usize) -> Terms {
        let term = |i: usize| (Gradient([sign * row[i], sign * change[i]]), Formula::Variable(from + i));
        (0..row.len()).map(term).collect()
    }

    fn made(self, name: String, row: [RealVector; 2], text: &str, formula: Formula, roles: Roles) -> Law {
        let (values, slopes) = self.numbers.iter().map(|Gradient([value, slope])| (*value, *slope)).unzip();
        let force = SmoothForce { formula: Arc::new(formula), text: text.into(), coefficients: values };
        Law { row, name, force, slopes, roles }
    }

    /// 0 where its depth is negative, or its force.
    fn of_stop(
        mut self,
        place: usize,
        (stop, force): (&Stop<f64>, &SmoothForce<f64>),
        change: Option<&Stop<f64>>,
    ) -> Result<Law> {
        let row = rows(&stop.row, change.map(|change| &change.row[..]));
        let harmonics = change.map(|change| &change.wall.harmonics[..]);
        let [surface, speed] = self.moved(1.0, &stop.wall.harmonics, harmonics);
        let offset = self.number(dual(stop.wall.offset, change.map(|change| change.wall.offset)));
        let terms = [self.row(-1.0, &row, 0), surface].concat();
        let depth = joined(Operation::Sum, offset, self.sum(terms)?);
        let terms = [self.row(-1.0, &row, self.points), speed].concat();
        let closing = self.sum(terms)?;
        let own = change.and_then(|change| match &change.law {
            StopLaw::Formula(own) => Some(own),
            _ => None,
        });
        let variables = [depth.clone(), closing, Formula::Variable(self.time())];
        let known = self.applied(&force.formula, (force, own), &variables);
        let (zero, name) = (number(0.0), &stop.name);
        let chosen = |what: &str, switch: &Formula, above: Formula| {
            let (text, below) = (format!("{what} of {name}"), zero.clone());
            Formula::Choice(Box::new(Choice { text, switch: switch.clone(), above, below }))
        };
        let whole = chosen("depth", &depth, chosen("force", &known, known.clone()));
        let roles = vec![(depth, SwitchOf::Depth(place)), (known, SwitchOf::Push(place))];
        Ok(self.made(format!("law of stop {name}"), row, &force.text, whole, roles))
    }

    /// What friction is beside Coulomb's; the sliding speed is per unit of time.
    fn of_friction(
        mut self,
        place: usize,
        (friction, own, law): (&Friction<f64>, &SmoothForce<f64>, &SlidingLaw),
        change: Option<&Friction<f64>>,
    ) -> Result<Law> {
        let row = rows(&friction.row, change.map(|change| &change.row[..]));
        let harmonics = change.map(|change| &change.harmonics[..]);
        let [_, surface] = self.moved(-1.0, &friction.harmonics, harmonics);
        let terms = [self.row(1.0, &row, self.points), surface].concat();
        let seen = self.sum(terms)?;
        let speed = self.number(dual(friction.speed, change.map(|change| change.speed)));
        let v = joined(Operation::Difference, seen, speed);
        let given = |normal: &NormalForce<f64>| match normal {
            NormalForce::Given(force) => *force,
            NormalForce::Stop { .. } => 0.0,
        };
        let normal = dual(given(&friction.normal), change.map(|change| given(&change.normal)));
        let normal = self.number(normal);
        let change = change.and_then(|change| change.law.as_ref());
        let formula = law.beside_coulomb(&v, normal, &mut |formula, speed| {
            self.applied(formula, (own, change), &[speed, number(0.0)])
        });
        let (name, roles) =
            (format!("coefficient of friction {}", friction.name), vec![(v, SwitchOf::Slide(place))]);
        Ok(self.made(name, row, &own.text, formula, roles))
    }
}

type Terms = Vec<(Dual, Formula)>;
type Roles = Vec<(Formula, SwitchOf)>;

fn dual(value: f64, slope: Option<f64>) -> Dual {
    Gradient([value, slope.unwrap_or(0.0)])
}

/// A row and its derivative.
fn rows(row: &[f64], change: Option<&[f64]>) -> [RealVector; 2] {
    let change = change.map_or_else(|| RealVector::zeros(row.len()), RealVector::from_column_slice);
    [RealVector::from_column_slice(row), change]
}

/// cos kt or sin kt, the time standing at a place.
fn turn(function: Function, k: u32, time: usize) -> Formula {
    let angle = joined(Operation::Product, number(f64::from(k)), Formula::Variable(time));
    Formula::Call(function, Box::new(angle))
}
