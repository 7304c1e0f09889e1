//! From a system, or from any number of formulas, to the list of operations of its force: equal parts are
//! there once, what is linear is one sum, harmonics of the time are taken out; and back to coefficients where
//! nothing else is left.

use super::{Drive, INPUTS, Op, Output, Program, Sum};
use crate::{
    error::{Error, Result},
    formula::{Formula, Function, Operation},
    motion::{
        Q, SmoothForce, System, TIME, U,
        flow::{Primitive, Scalar},
    },
};

/// An output to be: a constant, multiples of rows of the inputs and of formulas, harmonics of the time.
#[derive(Debug, Clone)]
pub(crate) struct Outline<S> {
    pub constant: S,
    pub inputs: Vec<(S, usize)>,
    pub formulas: Vec<(S, usize)>,
    pub drive: Vec<Drive<S>>,
}

impl<S: Scalar> Outline<S> {
    /// 0.
    pub fn zero() -> Self {
        let constant = S::constant(0.0);
        Outline { constant, inputs: Vec::new(), formulas: Vec::new(), drive: Vec::new() }
    }

    /// Adds a multiple of another.
    pub fn add(&mut self, factor: S, other: &Outline<S>) {
        self.constant = self.constant + factor * other.constant;
        self.inputs.extend(other.inputs.iter().map(|(by, row)| (factor * *by, *row)));
        self.formulas.extend(other.formulas.iter().map(|(by, formula)| (factor * *by, *formula)));
        let driven =
            |drive: &Drive<S>| Drive { k: drive.k, cos: factor * drive.cos, sin: factor * drive.sin };
        self.drive.extend(other.drive.iter().map(driven));
    }
}

/// What is left of a program that is linear, but for a cubic term, and driven by harmonics.
pub(crate) struct Plain<S> {
    pub damping: S,
    pub stiffness: S,
    pub cubic: S,
    pub force: S,
    pub drive: Vec<Drive<S>>,
}

impl<S: Scalar> Program<S> {
    fn empty(size: usize) -> Program<S> {
        Program {
            size,
            ops: Vec::new(),
            outputs: Vec::new(),
            guards: Vec::new(),
            raised: false,
            signs: Vec::new(),
        }
    }

    /// The whole equation of motion of a system without its walls.
    ///
    /// # Errors
    /// A constant part of the force that is no number: a root of a negative one, a division by zero.
    pub fn new(system: &System<S>) -> Result<Program<S>> {
        let mut made = Program::empty(1);
        let mut root = Sum { constant: system.force, terms: Vec::new() };
        root.add(-system.damping, U);
        root.add(-system.stiffness, Q);
        if !system.cubic.is_zero() {
            let cube = made.power(Q, 3);
            root.add(-system.cubic, cube);
        }
        let mut drive = Vec::new();
        for harmonic in &system.forcing {
            let k = f64::from(harmonic.k);
            drive.push(Drive { k, cos: harmonic.cos, sin: harmonic.sin });
        }
        if let Some(force) = &system.smooth {
            let inputs = [Q, U, TIME].map(Sum::row);
            let sum = made.lower(&force.formula, (&inputs, &force.coefficients))?;
            root.constant = root.constant + sum.constant;
            sum.terms.into_iter().for_each(|(factor, row)| root.add(factor, row));
        }
        made.finish(vec![Output { sum: root, drive }]);
        Ok(made)
    }

    /// The outlines as outputs, the accelerations of `size` coordinates first. The formulas' variables but
    /// for the time, which comes last, are these multiples of inputs.
    ///
    /// # Errors
    /// As [`new`](Self::new), with the number of the formula, from 0.
    pub fn assemble(
        size: usize,
        variables: &[Vec<(S, usize)>],
        formulas: &[&SmoothForce<S>],
        outlines: &[Outline<S>],
    ) -> std::result::Result<Program<S>, (usize, Error)> {
        let mut made = Program::empty(size);
        let zero = || Sum::constant(S::constant(0.0));
        let summed = |terms: &Vec<(S, usize)>| {
            let mut sum = zero();
            terms.iter().for_each(|(factor, row)| sum.add(*factor, *row));
            sum
        };
        let mut inputs: Vec<Sum<S>> = variables.iter().map(summed).collect();
        inputs.push(Sum::row(made.time()));
        let mut lowered = Vec::new();
        for (i, force) in formulas.iter().enumerate() {
            lowered.push(made.lower(&force.formula, (&inputs, &force.coefficients)).map_err(|e| (i, e))?);
        }
        let output = |outline: &Outline<S>| {
            let mut sum = Sum::constant(outline.constant);
            outline.inputs.iter().for_each(|(factor, row)| sum.add(*factor, *row));
            for (factor, formula) in &outline.formulas {
                let part = lowered[*formula].clone().times(*factor);
                sum.constant = sum.constant + part.constant;
                part.terms.into_iter().for_each(|(factor, row)| sum.add(factor, row));
            }
            Output { sum, drive: outline.drive.clone() }
        };
        let outputs = outlines.iter().map(output).collect();
        made.finish(outputs);
        Ok(made)
    }

    /// Takes the harmonics out of the sums and drops rows that nothing needs.
    fn finish(&mut self, mut outputs: Vec<Output<S>>) {
        let inputs = self.inputs();
        for output in &mut outputs {
            output.take_out(&self.ops, inputs);
        }
        // Every row costs in every term of every series: what no output needs any more goes.
        let mut live = vec![false; self.ops.len()];
        let mut open: Vec<usize> =
            outputs.iter().flat_map(|output| output.sum.terms.iter().map(|term| term.1)).collect();
        while let Some(row) = open.pop() {
            if row >= inputs && !std::mem::replace(&mut live[row - inputs], true) {
                open.extend(self.ops[row - inputs].needs(row));
            }
        }
        let mut place: Vec<usize> = (0..inputs).collect();
        let mut next = inputs;
        for alive in &live {
            place.push(next);
            next += usize::from(*alive);
        }
        let moved = |row: &mut usize| *row = place[*row];
        for op in &mut self.ops {
            match op {
                Op::Sum(sum) => sum.terms.iter_mut().for_each(|term| moved(&mut term.1)),
                Op::Product(a, b) | Op::Quotient(a, b) => {
                    moved(a);
                    moved(b);
                }
                Op::Square(a)
                | Op::Inverse(a)
                | Op::Sqrt(a)
                | Op::Exp(a)
                | Op::Log(a)
                | Op::Sin(a)
                | Op::Cos(a)
                | Op::Tanh(a)
                | Op::SquaredSech(a)
                | Op::Raised(a, _) => moved(a),
                Op::TurnSin(..) | Op::TurnCos(..) => {}
            }
        }
        for output in &mut outputs {
            output.sum.terms.iter_mut().for_each(|term| moved(&mut term.1));
        }
        let mut alive = live.iter();
        self.ops.retain(|_| *alive.next().expect("one for each"));
        self.guards = self.ops.iter().filter_map(Op::guard).collect();
        self.raised = self.ops.iter().any(|op| matches!(op, Op::Raised(..)));
        self.outputs = outputs;
    }

    /// The row of an operation, there once for all that need it.
    fn row(&mut self, op: Op<S>) -> usize {
        let known = self.ops.iter().position(|known| *known == op);
        self.inputs()
            + known.unwrap_or_else(|| {
                self.ops.push(op);
                self.ops.len() - 1
            })
    }

    /// The first row of two that need each other.
    fn pair(&mut self, one: Op<S>, other: Op<S>) -> usize {
        let row = self.row(one);
        self.row(other);
        row
    }

    /// A factor and a row for a sum without constant part, or with one.
    fn single(&mut self, sum: Sum<S>) -> (S, usize) {
        match &sum.terms[..] {
            [(factor, row)] if sum.constant.is_zero() => (*factor, *row),
            _ => (S::constant(1.0), self.row(Op::Sum(sum))),
        }
    }

    /// The row of a sum.
    fn whole(&mut self, sum: Sum<S>) -> usize {
        match &sum.terms[..] {
            [(factor, row)] if sum.constant.is_zero() && *factor == S::constant(1.0) => *row,
            _ => self.row(Op::Sum(sum)),
        }
    }

    fn product(&mut self, a: usize, b: usize) -> usize {
        self.row(if a == b { Op::Square(a) } else { Op::Product(a.max(b), a.min(b)) })
    }

    /// row^n, n ≥ 1, by squaring.
    fn power(&mut self, row: usize, n: u32) -> usize {
        match n {
            1 => row,
            n if n.is_multiple_of(2) => {
                let half = self.power(row, n / 2);
                self.product(half, half)
            }
            n => {
                let less = self.power(row, n - 1);
                self.product(less, row)
            }
        }
    }

    /// A formula as a constant and multiples of rows; `known` is what its variables are, and its
    /// coefficients.
    fn lower(&mut self, formula: &Formula, known: (&[Sum<S>], &[S])) -> Result<Sum<S>> {
        let one = Sum::row;
        Ok(match formula {
            Formula::Number(value) => Sum::constant(S::constant(float(value))),
            Formula::Pi => Sum::constant(S::constant(std::f64::consts::PI)),
            Formula::Variable(place) => match place.checked_sub(known.0.len()) {
                None => known.0[*place].clone(),
                Some(coefficient) => Sum::constant(known.1[coefficient]),
            },
            Formula::Negated(inner) => self.lower(inner, known)?.times(S::constant(-1.0)),
            Formula::Binary(operation, parts) => {
                let (left, right) = (self.lower(&parts[0], known)?, self.lower(&parts[1], known)?);
                self.binary(*operation, left, right)?
            }
            Formula::Power(_, 0) => Sum::constant(S::constant(1.0)),
            Formula::Power(base, exponent) => {
                let base = self.lower(base, known)?;
                let n = exponent.unsigned_abs();
                let raised = |x: S| (1..n).fold(x, |power, _| power * x);
                if base.terms.is_empty() {
                    let power = raised(base.constant);
                    if *exponent > 0 {
                        return Ok(Sum::constant(power));
                    }
                    return Ok(Sum::constant(checked(power.call(Primitive::Inverse), "divides by zero")?));
                }
                let (factor, row) = self.single(base);
                let (power, factor) = (self.power(row, n), raised(factor));
                if *exponent > 0 {
                    one(power).times(factor)
                } else {
                    one(self.row(Op::Inverse(power))).times(factor.call(Primitive::Inverse))
                }
            }
            Formula::Call(function, inner) => {
                let argument = self.lower(inner, known)?;
                self.call(*function, argument)?
            }
            Formula::Raised(base, exponent) => {
                let (base, p) = (self.lower(base, known)?, float(exponent));
                if base.terms.is_empty() {
                    let value = base.constant.part(0);
                    if value < 0.0 {
                        return Err(Error::input("raises a negative number to a power that is not whole"));
                    }
                    return Ok(Sum::constant(base.constant.call(Primitive::Raise(p))));
                }
                let row = self.whole(base);
                one(self.row(Op::Raised(row, p)))
            }
            // Which of its branches it is has been decided before.
            Formula::Choice(choice) => {
                return Err(Error::input(format!(
                    "{} has a kink, where a smooth force is needed",
                    choice.text
                )));
            }
        })
    }

    /// An operation on two sums.
    fn binary(&mut self, operation: Operation, left: Sum<S>, mut right: Sum<S>) -> Result<Sum<S>> {
        Ok(match operation {
            Operation::Sum | Operation::Difference => {
                if operation == Operation::Difference {
                    right = right.times(S::constant(-1.0));
                }
                let mut sum = left;
                sum.constant = sum.constant + right.constant;
                right.terms.into_iter().for_each(|(factor, row)| sum.add(factor, row));
                sum
            }
            Operation::Product if left.terms.is_empty() => right.times(left.constant),
            Operation::Product if right.terms.is_empty() => left.times(right.constant),
            Operation::Product => {
                let ((f, a), (g, b)) = (self.single(left), self.single(right));
                Sum::row(self.product(a, b)).times(f * g)
            }
            Operation::Quotient if right.terms.is_empty() => {
                let inverse = checked(right.constant.call(Primitive::Inverse), "divides by zero")?;
                if left.terms.is_empty() {
                    return Ok(Sum::constant(left.constant.over(right.constant)));
                }
                left.times(inverse)
            }
            Operation::Quotient if left.terms.is_empty() => {
                let (f, row) = self.single(right);
                Sum::row(self.row(Op::Inverse(row))).times(left.constant.over(f))
            }
            Operation::Quotient => {
                let ((f, a), (g, b)) = (self.single(left), self.single(right));
                Sum::row(self.row(Op::Quotient(a, b))).times(f.over(g))
            }
        })
    }

    /// A function of a sum.
    fn call(&mut self, function: Function, argument: Sum<S>) -> Result<Sum<S>> {
        let time = self.time();
        if argument.terms.is_empty() {
            let (primitive, wrong) = match function {
                Function::Sqrt => (Primitive::Sqrt, "takes the root of a negative number"),
                Function::Log => (Primitive::Log, "takes the logarithm of a number that is not positive"),
                Function::Exp => (Primitive::Exp, "has a part beyond the range of floats"),
                Function::Sin => (Primitive::Sin, "has a part beyond the range of floats"),
                Function::Cos => (Primitive::Cos, "has a part beyond the range of floats"),
                Function::Tanh => (Primitive::Tanh, "has a part beyond the range of floats"),
            };
            return Ok(Sum::constant(checked(argument.constant.call(primitive), wrong)?));
        }
        let turn = match &argument.terms[..] {
            [(k, row)] if *row == time => Some(k.part(0)),
            _ => None,
        };
        let phase = argument.constant;
        Ok(Sum::row(match (function, turn) {
            (Function::Sin, Some(k)) => self.pair(Op::TurnSin(k, phase), Op::TurnCos(k, phase)),
            (Function::Cos, Some(k)) => self.pair(Op::TurnSin(k, phase), Op::TurnCos(k, phase)) + 1,
            _ => {
                let row = self.whole(argument);
                match function {
                    Function::Sin => self.pair(Op::Sin(row), Op::Cos(row)),
                    Function::Cos => self.pair(Op::Sin(row), Op::Cos(row)) + 1,
                    Function::Tanh => self.pair(Op::Tanh(row), Op::SquaredSech(row)),
                    Function::Sqrt => self.row(Op::Sqrt(row)),
                    Function::Exp => self.row(Op::Exp(row)),
                    Function::Log => self.row(Op::Log(row)),
                }
            }
        }))
    }
}

impl<S: Scalar> Output<S> {
    /// Takes the harmonics out of the sum.
    fn take_out(&mut self, ops: &[Op<S>], inputs: usize) {
        let drive = &mut self.drive;
        self.sum.terms.retain(|(factor, row)| {
            let Some(op) = row.checked_sub(inputs).map(|i| &ops[i]) else { return true };
            // f sin(kt + c) = (f sin c) cos kt + (f cos c) sin kt, and a quarter on for the cosine.
            let (k, cos, sin) = match op {
                Op::TurnSin(k, phase) => (k, phase.call(Primitive::Sin), phase.call(Primitive::Cos)),
                Op::TurnCos(k, phase) => (k, phase.call(Primitive::Cos), -phase.call(Primitive::Sin)),
                _ => return true,
            };
            drive.push(Drive { k: *k, cos: *factor * cos, sin: *factor * sin });
            false
        });
        for harmonic in drive.iter_mut().filter(|harmonic| harmonic.k < 0.0) {
            (harmonic.k, harmonic.sin) = (-harmonic.k, -harmonic.sin);
        }
        drive.retain(|harmonic| !harmonic.cos.is_zero() || !harmonic.sin.is_zero());
    }
}

impl<S: Scalar> Program<S> {
    /// The coefficients of an equation that needs no program.
    pub(crate) fn plain(&self) -> Option<Plain<S>> {
        let mut found = Plain {
            damping: S::constant(0.0),
            stiffness: S::constant(0.0),
            cubic: S::constant(0.0),
            force: self.outputs[0].sum.constant,
            drive: self.outputs[0].drive.clone(),
        };
        for (factor, row) in &self.outputs[0].sum.terms {
            match row.checked_sub(INPUTS).map(|i| &self.ops[i]) {
                None if *row == Q => found.stiffness = -*factor,
                None if *row == U => found.damping = -*factor,
                Some(Op::Product(a, Q)) if *a >= INPUTS && self.ops[*a - INPUTS] == Op::Square(Q) => {
                    found.cubic = -*factor;
                }
                _ => return None,
            }
        }
        let whole = |drive: &Drive<S>| drive.k >= 1.0 && drive.k == drive.k.round();
        found.drive.iter().all(whole).then_some(found)
    }
}

fn checked<S: Scalar>(value: S, wrong: &str) -> Result<S> {
    if (0..S::PARTS).all(|k| value.part(k).is_finite()) { Ok(value) } else { Err(Error::input(wrong)) }
}

fn float(value: &num_rational::BigRational) -> f64 {
    num_traits::ToPrimitive::to_f64(value).unwrap_or(f64::NAN)
}
