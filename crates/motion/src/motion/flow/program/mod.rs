//! The equation of motion as a list of operations on Taylor series: one for every smooth force.
//!
//! Each row is the series of one part of the force in x = (t′ − t)/h. Row by row, coefficient i follows from
//! those of order up to i of rows before it (products, quotients, roots, and the functions whose derivative
//! is a product of known series; A. Griewank and A. Walther, Evaluating Derivatives, chapter 13). A
//! displacement's coefficient i + 2 is that of its acceleration, times h²/((i + 1)(i + 2)). All coordinates
//! share one list, so that what several forces have in common is there once. The rows hold numbers of any
//! kind: with [`Gradient`](super::scalar::Gradient) they carry derivatives by the start or a parameter.
//! Sums are one operation, whatever their length, and multiples of t inside a sine are turned instead of
//! convolved: a product is the only operation whose cost per coefficient grows with the order. Not here: how
//! the list is made from a system (`build`).

mod build;
mod tail;

pub(crate) use build::Outline;
pub(super) use tail::{harmonic, linear, radii, suited};

use super::{
    SHORTEST,
    scalar::{Primitive, Scalar},
};

/// Rows before those of operations, of one coordinate: q, u and t.
const INPUTS: usize = 3;

/// A constant and multiples of rows.
#[derive(Debug, Clone, PartialEq)]
struct Sum<S> {
    constant: S,
    terms: Vec<(S, usize)>,
}

/// What a row is made of.
#[derive(Debug, Clone, PartialEq)]
enum Op<S> {
    Sum(Sum<S>),
    Product(usize, usize),
    Square(usize),
    Quotient(usize, usize),
    Inverse(usize),
    Sqrt(usize),
    Exp(usize),
    Log(usize),
    /// The sine of a row; the next row is its cosine.
    Sin(usize),
    /// The cosine of a row; the row before is its sine.
    Cos(usize),
    /// The sine of kt + phase; the next row is its cosine.
    TurnSin(f64, S),
    /// Its cosine; the row before is its sine.
    TurnCos(f64, S),
    /// The hyperbolic tangent of a row; the next row is 1 less its square.
    Tanh(usize),
    /// 1 less the square of the row before; that row's argument.
    SquaredSech(usize),
    /// A row to a power above 1 that is no whole number.
    Raised(usize, f64),
}

/// How near to the branch point of a power, in radians of the motion, that is a straight line with the same
/// impulse instead of a power.
const THIN: f64 = 1e-10;

/// A base below 0 by more than this part of how it moves in a trial step, or of what it is added up from, is
/// negative.
const NEGATIVE: f64 = 1e-9;

/// The shortest step of a motion by powers: towards their branch points steps shrink, and beyond they grow.
const SHORTEST_RAISED: f64 = 1e-13;

impl<S> Op<S> {
    /// The rows that it needs; its partner among them.
    fn needs(&self, own: usize) -> Vec<usize> {
        match self {
            Op::Sum(sum) => sum.terms.iter().map(|term| term.1).collect(),
            Op::Product(a, b) | Op::Quotient(a, b) => vec![*a, *b],
            Op::Square(a) | Op::Inverse(a) | Op::Sqrt(a) | Op::Exp(a) | Op::Log(a) | Op::Raised(a, _) => {
                vec![*a]
            }
            Op::Sin(a) | Op::Tanh(a) => vec![*a, own + 1],
            Op::Cos(a) | Op::SquaredSech(a) => vec![*a, own - 1],
            Op::TurnSin(..) => vec![own + 1],
            Op::TurnCos(..) => vec![own - 1],
        }
    }

    /// Whether it is a sine of the time.
    fn turns(&self) -> bool {
        matches!(self, Op::TurnSin(..) | Op::TurnCos(..))
    }

    /// The row in whose zero it is not smooth; whether negative values are as bad.
    fn guard(&self) -> Option<(usize, bool)> {
        match self {
            Op::Quotient(_, row) | Op::Inverse(row) => Some((*row, false)),
            Op::Sqrt(row) | Op::Log(row) => Some((*row, true)),
            _ => None,
        }
    }
}

/// `cos` cos kt + `sin` sin kt.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Drive<S> {
    pub k: f64,
    pub cos: S,
    pub sin: S,
}

/// The accelerations of n coordinates as functions of t, q₁, …, q_n and u₁, …, u_n, and whatever else is to
/// be known along the motion. Rows 0 to n − 1 are the displacements, n to 2n − 1 the velocities, 2n the time.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Program<S> {
    size: usize,
    ops: Vec<Op<S>>,
    /// The accelerations first.
    outputs: Vec<Output<S>>,
    guards: Vec<(usize, bool)>,
    /// Whether a power in it is not whole.
    raised: bool,
    /// Of the outputs those that are watched for their sign alone, and whether the accelerations say as much.
    signs: Vec<(usize, bool)>,
}

/// A sum of rows and harmonics.
#[derive(Debug, Clone, PartialEq)]
struct Output<S> {
    sum: Sum<S>,
    drive: Vec<Drive<S>>,
}

impl<S: Scalar> Program<S> {
    /// The row of the time.
    fn time(&self) -> usize {
        2 * self.size
    }

    /// Rows before those of operations.
    fn inputs(&self) -> usize {
        2 * self.size + 1
    }

    /// How many outputs there are.
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// Of these outputs only the sign matters; where the flag is set, it matters as that of an acceleration.
    pub fn watch(&mut self, signs: Vec<(usize, bool)>) {
        self.signs = signs;
    }

    /// Whether of an output only the sign matters, as [`watch`](Self::watch) has it.
    pub fn watched(&self, output: usize) -> Option<bool> {
        self.signs.iter().find(|known| known.0 == output).map(|known| known.1)
    }

    /// Whether the time enters.
    pub fn is_driven(&self) -> bool {
        let time = self.time();
        let summed = |output: &Output<S>| output.sum.terms.iter().any(|term| term.1 == time);
        self.outputs.iter().any(|output| !output.drive.is_empty() || summed(output))
            || self.ops.iter().any(|op| op.needs(usize::MAX - 1).contains(&time) || op.turns())
    }

    /// The factor of the velocity in the acceleration of one coordinate, if it stands nowhere else.
    pub fn rate_factor(&self) -> Option<S> {
        let rate = self.size;
        if self.ops.iter().any(|op| op.needs(usize::MAX - 1).contains(&rate)) {
            return None;
        }
        let known = self.outputs[0].sum.terms.iter().find(|term| term.1 == rate);
        Some(known.map_or(S::constant(0.0), |term| term.0))
    }

    /// Whether every output changes its sign under (q, q′, t) ↦ (−q, −q′, t + π), as far as the parity of its
    /// parts tells.
    pub fn is_mirrored(&self) -> bool {
        let mut parities = vec![Parity::Odd; self.inputs()];
        parities[self.time()] = Parity::None;
        for op in &self.ops {
            let of = |row: &usize| parities[*row];
            parities.push(match op {
                Op::Sum(sum) => sum.parity(&parities),
                Op::Product(a, b) | Op::Quotient(a, b) => of(a).times(of(b)),
                Op::Square(a) => of(a).times(of(a)),
                Op::Inverse(a) | Op::Sin(a) | Op::Tanh(a) => of(a),
                Op::Sqrt(a) | Op::Exp(a) | Op::Log(a) | Op::Raised(a, _) => of(a).even_only(),
                Op::Cos(a) | Op::SquaredSech(a) => of(a).times(of(a)),
                Op::TurnSin(k, _) | Op::TurnCos(k, _) => Parity::of_harmonic(*k),
            });
        }
        self.outputs.iter().all(|output| {
            let driven = output.drive.iter().all(|drive| Parity::of_harmonic(drive.k) == Parity::Odd);
            let still = output.sum.terms.is_empty() && output.sum.constant.is_zero();
            driven && (still || output.sum.parity(&parities) == Parity::Odd)
        })
    }

    /// The coefficients of x ↦ q(t + hx) and of every row, for a motion from (q, u); the first `count` of q.
    pub fn solve(&self, [q, u]: [S; 2], t: S, h: f64, count: usize) -> Rows<S> {
        self.solve_all(&[q, u], t, h, count, &[])
    }

    /// The same for n coordinates from (q₁, …, q_n, u₁, …, u_n); `given` is added to the outputs, a value and
    /// a slope by x for each, or none at all.
    pub fn solve_all(&self, from: &[S], t: S, h: f64, count: usize, given: &[[f64; 2]]) -> Rows<S> {
        if !self.raised {
            return self.solve_with(from, t, (h, count), given, Vec::new());
        }
        let frozen = self.solve_with(from, t, (h, 5), given, vec![f64::NAN; self.ops.len()]);
        self.solve_with(from, t, (h, count), given, self.thin(&frozen, h.abs()))
    }

    /// For each operation within how much of 0 the base of a power is as good as 0, by how it moves; infinite
    /// with the other sign if it is negative.
    fn thin(&self, frozen: &Rows<S>, h: f64) -> Vec<f64> {
        let row_of = |row: usize| row.checked_sub(self.inputs()).map(|k| &self.ops[k]);
        let one = |op: &Op<S>| {
            let Op::Raised(base, _) = op else { return 0.0 };
            let row = &frozen.data[frozen.count * base..][..3];
            let [start, slope, bend] = [0, 1, 2].map(|i| row[i].part(0));
            let part = THIN / h;
            let size = match row_of(*base) {
                Some(Op::Sum(sum)) => sum.terms.iter().fold(sum.constant.part(0).abs(), |size, (by, row)| {
                    size + (*by * frozen.data[frozen.count * row]).part(0).abs()
                }),
                _ => 0.0,
            };
            if start < -NEGATIVE * (slope.abs() + bend.abs()).max(size) {
                return f64::NEG_INFINITY;
            }
            (slope.abs() + bend.abs() * part) * part
        };
        self.ops.iter().map(one).collect()
    }

    fn solve_with(
        &self,
        from: &[S],
        t: S,
        (h, count): (f64, usize),
        given: &[[f64; 2]],
        thin: Vec<f64>,
    ) -> Rows<S> {
        let n = self.size;
        let mut rows = self.rows(t, h, count);
        rows.thin = thin;
        let first = self.inputs() + self.ops.len();
        for (k, straight) in given.iter().enumerate() {
            for (i, part) in straight.iter().enumerate() {
                let place = &mut rows.data[count * (first + k) + i];
                *place = *place + S::constant(*part);
            }
        }
        for j in 0..n {
            rows.data[count * j] = from[j];
            rows.data[count * j + 1] = from[n + j].scaled(h);
        }
        for i in 0..count - 2 {
            for j in 0..n {
                rows.data[count * (n + j) + i] = rows.data[count * j + i + 1].scaled((i + 1) as f64 / h);
            }
            self.next(&mut rows, i, h);
            for j in 0..n {
                let here = rows.data[count * (first + j) + i];
                rows.data[count * j + i + 2] = here.scaled(h * h / ((i + 1) * (i + 2)) as f64);
            }
        }
        rows
    }

    /// The coefficients of the acceleration along a path of one coordinate whose own coefficients are given,
    /// as many as these.
    pub fn along(&self, q: &[S], u: &[S], t: S, h: f64) -> Vec<S> {
        let count = q.len();
        let mut rows = self.rows(t, h, count + 2);
        let output = (count + 2) * (self.inputs() + self.ops.len());
        (0..count)
            .map(|i| {
                rows.data[i] = q[i];
                rows.data[count + 2 + i] = u[i];
                self.next(&mut rows, i, h);
                rows.data[output + i]
            })
            .collect()
    }

    /// The acceleration of one coordinate at a state.
    pub fn at(&self, q: S, u: S, t: S) -> S {
        self.along(&[q], &[u], t, 1.0)[0]
    }

    /// All outputs at a state (q₁, …, q_n, u₁, …, u_n).
    pub fn all_at(&self, state: &[S], t: S) -> Vec<S> {
        let mut rows = self.rows(t, 1.0, 3);
        for (row, value) in state.iter().enumerate() {
            rows.data[3 * row] = *value;
        }
        self.next(&mut rows, 0, 1.0);
        let first = self.inputs() + self.ops.len();
        (0..self.outputs.len()).map(|k| rows.data[3 * (first + k)]).collect()
    }

    /// Room, with the time's own row and the harmonics' sums filled in.
    fn rows(&self, t: S, h: f64, count: usize) -> Rows<S> {
        let zero = S::constant(0.0);
        let first = self.inputs() + self.ops.len();
        let mut rows = Rows {
            count,
            first,
            trial: h,
            data: vec![zero; count * (first + self.outputs.len())],
            thin: Vec::new(),
        };
        rows.data[count * self.time()] = t;
        if count > 1 {
            rows.data[count * self.time() + 1] = S::constant(h);
        }
        for (k, output) in self.outputs.iter().enumerate() {
            let start = count * (first + k);
            let driven = &mut rows.data[start..start + count.saturating_sub(2)];
            for harmonic in &output.drive {
                let angle = t.scaled(harmonic.k);
                let (sin, cos) = (angle.call(Primitive::Sin), angle.call(Primitive::Cos));
                let mut even = harmonic.cos * cos + harmonic.sin * sin;
                let mut odd = harmonic.sin * cos - harmonic.cos * sin;
                let mut power = 1.0;
                for (i, coefficient) in driven.iter_mut().enumerate() {
                    *coefficient = *coefficient + even.scaled(power);
                    (even, odd) = (odd, -even);
                    power *= harmonic.k * h / (i + 1) as f64;
                }
            }
        }
        rows
    }

    /// Coefficient i of every row and of the outputs, those of the inputs being there.
    #[inline]
    fn next(&self, rows: &mut Rows<S>, i: usize, h: f64) {
        let (count, inputs, time) = (rows.count, self.inputs(), self.time());
        for (k, op) in self.ops.iter().enumerate() {
            let (before, own) = rows.data.split_at_mut(count * (inputs + k));
            let row = |a: usize| &before[count * a..count * a + i + 1];
            let (own, partner) = own.split_at_mut(count);
            own[i] = match op {
                Op::Sum(sum) => sum.coefficient(before, count, i),
                Op::Product(a, b) => convolve(row(*a), row(*b)),
                Op::Square(a) => square(row(*a)),
                Op::Quotient(a, b) => {
                    let (a, b) = (row(*a), row(*b));
                    (a[i] - convolve(&b[1..], &own[..i])).over(b[0])
                }
                Op::Inverse(a) => {
                    let a = row(*a);
                    if i == 0 {
                        a[0].call(Primitive::Inverse)
                    } else {
                        -(convolve(&a[1..], &own[..i]) * own[0])
                    }
                }
                Op::Sqrt(a) => {
                    let a = row(*a);
                    match i {
                        0 => a[0].call(Primitive::Sqrt),
                        1 => a[1].scaled(0.5).over(own[0]),
                        _ => (a[i] - square(&own[1..i])).scaled(0.5).over(own[0]),
                    }
                }
                Op::Exp(a) if i == 0 => row(*a)[0].call(Primitive::Exp),
                Op::Exp(a) => weighted(row(*a), &own[..i], i),
                Op::Log(a) => {
                    let a = row(*a);
                    match i {
                        0 => a[0].call(Primitive::Log),
                        1 => a[1].over(a[0]),
                        // Σ j l_j a_{i−j} over 0 < j < i.
                        _ => (a[i] - weighted(&own[..i], &a[1..], i)).over(a[0]),
                    }
                }
                Op::Sin(a) if i == 0 => row(*a)[0].call(Primitive::Sin),
                Op::Sin(a) => weighted(row(*a), &partner[..i], i),
                Op::Cos(a) if i == 0 => row(*a)[0].call(Primitive::Cos),
                Op::Cos(a) => {
                    let sine = &before[before.len() - count..][..i];
                    -weighted(row(*a), sine, i)
                }
                Op::TurnSin(k, phase) if i == 0 => {
                    (before[count * time].scaled(*k) + *phase).call(Primitive::Sin)
                }
                Op::TurnSin(k, _) => partner[i - 1].scaled(k * h / i as f64),
                Op::TurnCos(k, phase) if i == 0 => {
                    (before[count * time].scaled(*k) + *phase).call(Primitive::Cos)
                }
                Op::TurnCos(k, _) => {
                    let sine = before[before.len() - count + i - 1];
                    sine.scaled(-k * h / i as f64)
                }
                Op::Tanh(a) if i == 0 => row(*a)[0].call(Primitive::Tanh),
                Op::Tanh(a) => weighted(row(*a), &partner[..i], i),
                Op::SquaredSech(a) if i == 0 => row(*a)[0].call(Primitive::SquaredSech),
                Op::SquaredSech(_) => -square(&before[before.len() - count..][..i + 1]),
                Op::Raised(a, p) => raised(row(*a), *p, &own[..i], rows.thin.get(k).copied()),
            };
        }
        for (k, output) in self.outputs.iter().enumerate() {
            let place = count * (inputs + self.ops.len() + k) + i;
            let driven = rows.data[place];
            rows.data[place] = output.sum.coefficient(&rows.data, count, i) + driven;
        }
    }

    /// Whether some divisor, or argument of a root or a logarithm, is within 1000 times its change on [0, x]
    /// of its zero, or has no value that could be used at 0.
    pub fn is_near_pole(&self, rows: &Rows<S>, x: f64) -> bool {
        self.guards.iter().any(|(row, negative)| {
            let row = rows.row(*row);
            let (first, change) = (row[0].part(0), rest(row, x));
            let far = first.abs() > 1e3 * change && !(*negative && first < 0.0);
            !far
        })
    }

    /// Steps this short end a motion that needs them.
    pub fn shortest(&self) -> f64 {
        if self.raised { SHORTEST_RAISED } else { SHORTEST }
    }

    /// What keeps a motion from going on where a step of x is too short to go on by.
    pub fn obstacle(&self, rows: &Rows<S>, x: f64) -> Obstacle {
        if self.is_near_pole(rows, x) || rows.thin.contains(&f64::NEG_INFINITY) {
            return Obstacle::Pole;
        }
        let (mut place, mut speed, mut bend, mut along) = (0.0, 0.0, 0.0, 0.0);
        for j in 0..self.size {
            let row = rows.place(j);
            let [q, u, a] =
                [row[0].part(0), row[1].part(0) / rows.trial, 2.0 * row[2].part(0) / rows.trial.powi(2)];
            (place, speed, bend, along) = (place + q.abs(), speed + u.abs(), bend + a.abs(), along + u * a);
        }
        Obstacle::of_growth(place, speed, bend, along * rows.trial)
    }
}

/// What keeps a motion from going on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Obstacle {
    /// It leaves every bound.
    Escape,
    /// A pole, or a root or a logarithm of 0.
    Pole,
    /// The force changes too fast.
    Steep,
}

impl Obstacle {
    /// What it is where no pole is near, by the sizes of displacement, velocity and acceleration and by
    /// whether the speed grows. A motion that escapes within the time of the shortest step has a speed that
    /// grows by a good part of itself in it, and goes a good part of its way; a force that is merely steep
    /// changes neither by much.
    pub fn of_growth(place: f64, speed: f64, bend: f64, growth: f64) -> Obstacle {
        let grows = growth > 0.0 && bend * SHORTEST > 1e-3 * speed && speed * SHORTEST > 1e-5 * place;
        if grows || !bend.is_finite() { Obstacle::Escape } else { Obstacle::Steep }
    }
}

/// Σ |a_i| x^i over i ≥ 1.
fn rest<S: Scalar>(row: &[S], x: f64) -> f64 {
    row.iter().skip(1).rev().fold(0.0, |sum, a| (sum + a.part(0).abs()) * x)
}

/// The series of every part of a force; that of q first.
#[derive(Debug, Clone)]
pub(crate) struct Rows<S> {
    count: usize,
    /// The row of the first output.
    first: usize,
    /// The trial step, whose part x is.
    trial: f64,
    data: Vec<S>,
    /// For each operation what [`Program::thin`] says; empty where only values are asked for.
    thin: Vec<f64>,
}

impl<S: Scalar> Rows<S> {
    fn row(&self, row: usize) -> &[S] {
        &self.data[self.count * row..][..self.count.saturating_sub(2).max(1)]
    }

    /// The trial step.
    pub fn trial(&self) -> f64 {
        self.trial
    }

    /// The coefficients of q, of one coordinate.
    pub fn q(&self) -> &[S] {
        self.place(0)
    }

    /// The same in the room of all.
    pub fn into_q(mut self) -> Vec<S> {
        self.data.truncate(self.count);
        self.data
    }

    /// Those of a coordinate.
    pub fn place(&self, coordinate: usize) -> &[S] {
        &self.data[self.count * coordinate..][..self.count]
    }

    /// Those of an output, two fewer.
    pub fn output(&self, output: usize) -> &[S] {
        &self.data[self.count * (self.first + output)..][..self.count - 2]
    }
}

/// What a mirror half a period later does to a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Parity {
    Even,
    Odd,
    /// Neither, or not known.
    None,
}

impl Parity {
    fn times(self, other: Parity) -> Parity {
        match (self, other) {
            (Parity::None, _) | (_, Parity::None) => Parity::None,
            (one, other) if one == other => Parity::Even,
            _ => Parity::Odd,
        }
    }

    fn even_only(self) -> Parity {
        if self == Parity::Even { Parity::Even } else { Parity::None }
    }

    fn of_harmonic(k: f64) -> Parity {
        match k.rem_euclid(2.0) {
            0.0 => Parity::Even,
            1.0 => Parity::Odd,
            _ => Parity::None,
        }
    }
}

impl<S: Scalar> Sum<S> {
    fn parity(&self, of: &[Parity]) -> Parity {
        let constant = (!self.constant.is_zero()).then_some(Parity::Even);
        let mut all = constant.into_iter().chain(self.terms.iter().map(|term| of[term.1]));
        let first = all.next().unwrap_or(Parity::Even);
        if all.all(|parity| parity == first) { first } else { Parity::None }
    }

    fn constant(constant: S) -> Self {
        Sum { constant, terms: Vec::new() }
    }

    fn row(row: usize) -> Self {
        Sum { constant: S::constant(0.0), terms: vec![(S::constant(1.0), row)] }
    }

    fn add(&mut self, factor: S, row: usize) {
        match self.terms.iter_mut().find(|term| term.1 == row) {
            Some(term) => term.0 = term.0 + factor,
            None => self.terms.push((factor, row)),
        }
        self.terms.retain(|term| !term.0.is_zero());
    }

    fn times(mut self, factor: S) -> Self {
        self.constant = self.constant * factor;
        self.terms.iter_mut().for_each(|term| term.0 = term.0 * factor);
        self.terms.retain(|term| !term.0.is_zero());
        self
    }

    #[inline]
    fn coefficient(&self, data: &[S], count: usize, i: usize) -> S {
        let first = if i == 0 { self.constant } else { S::constant(0.0) };
        self.terms.iter().fold(first, |sum, (factor, row)| sum + *factor * data[count * row + i])
    }
}

/// Σ a_j b_{n−j}, n one less than the shorter length.
#[inline]
fn convolve<S: Scalar>(a: &[S], b: &[S]) -> S {
    a.iter().zip(b.iter().rev()).fold(S::constant(0.0), |sum, (x, y)| sum + *x * *y)
}

/// Σ a_j a_{n−j}, n + 1 the length: each product once.
#[inline]
fn square<S: Scalar>(a: &[S]) -> S {
    let half = a.len() / 2;
    let sum = convolve(&a[..half], &a[a.len() - half..]).scaled(2.0);
    if a.len().is_multiple_of(2) { sum } else { sum + a[half] * a[half] }
}

/// Σ j a_j b_{i−j} / i over 1 ≤ j, `b` holding i coefficients: those from 0 on, or from 1 on if `a` ends
/// before i.
#[inline]
fn weighted<S: Scalar>(a: &[S], b: &[S], i: usize) -> S {
    let last = a.len() - 1;
    let sum = (1..=last).fold(S::constant(0.0), |sum, j| sum + (a[j] * b[last - j]).scaled(j as f64));
    sum.scaled(1.0 / i as f64)
}

/// The next coefficient of a^p, `own` being those before: i a₀ z_i = Σ (pj − i + j) a_j z_{i−j} over 1 ≤ j ≤
/// i; where a₀ is as good as 0, that of the straight line through 0 with the same impulse up to `thin`. It
/// stays as it is where that is not known yet.
fn raised<S: Scalar>(a: &[S], p: f64, own: &[S], thin: Option<f64>) -> S {
    let (i, start) = (own.len(), a[0].part(0));
    match thin {
        Some(thin) if thin.is_nan() && i > 0 => S::constant(0.0),
        Some(f64::NEG_INFINITY) => S::constant(f64::NAN),
        Some(thin) if start <= thin => a[i].scaled(straight(thin, p)),
        _ if i == 0 => a[0].call(Primitive::Raise(p)),
        _ => {
            let term = |j: usize| (a[j] * own[i - j]).scaled((p + 1.0) * j as f64 - i as f64);
            let sum = (1..=i).fold(S::constant(0.0), |sum, j| sum + term(j));
            sum.scaled(1.0 / i as f64).over(a[0])
        }
    }
}

/// The slope of the line that has the integral of x^p from 0 to `thin`.
fn straight(thin: f64, p: f64) -> f64 {
    if thin > 0.0 { 2.0 * thin.powf(p - 1.0) / (p + 1.0) } else { 0.0 }
}
