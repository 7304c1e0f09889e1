//! What a force can be evaluated in: floats, floats with derivatives, ranges.

use std::{
    fmt::Debug,
    ops::{Add, Mul, Neg, Sub},
};

use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::formula::{Formula, Function, Operation};

/// The functions of one number that forces are made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Primitive {
    Inverse,
    Sqrt,
    Exp,
    Log,
    Sin,
    Cos,
    Tanh,
    /// 1 − tanh².
    SquaredSech,
    /// x^p, p > 1, and 0 for x ≤ 0.
    Raise(f64),
}

impl Primitive {
    /// The value and the first three derivatives at x; NaN or infinite where it is not smooth.
    pub fn derivatives(self, x: f64) -> [f64; 4] {
        match self {
            Primitive::Inverse => {
                let y = 1.0 / x;
                [y, -y * y, 2.0 * y * y * y, -6.0 * y * y * y * y]
            }
            Primitive::Sqrt => {
                let y = x.sqrt();
                [y, 0.5 / y, -0.25 / (x * y), 0.375 / (x * x * y)]
            }
            Primitive::Exp => [x.exp(); 4],
            Primitive::Log => {
                let y = 1.0 / x;
                [x.ln(), y, -y * y, 2.0 * y * y * y]
            }
            Primitive::Sin => {
                let (s, c) = x.sin_cos();
                [s, c, -s, -c]
            }
            Primitive::Cos => {
                let (s, c) = x.sin_cos();
                [c, -s, -c, s]
            }
            Primitive::Tanh => {
                let (y, w) = (x.tanh(), squared_sech(x));
                [y, w, -2.0 * y * w, -2.0 * w * (w - 2.0 * y * y)]
            }
            Primitive::SquaredSech => {
                let (y, w) = (x.tanh(), squared_sech(x));
                [w, -2.0 * y * w, -2.0 * w * (w - 2.0 * y * y), 16.0 * y * w * w - 8.0 * y * y * y * w]
            }
            Primitive::Raise(_) if x <= 0.0 => [0.0; 4],
            Primitive::Raise(p) => {
                let y = x.powf(p);
                let slope = p * y / x;
                let bend = (p - 1.0) * slope / x;
                [y, slope, bend, (p - 2.0) * bend / x]
            }
        }
    }

    /// The value at x.
    pub fn at(self, x: f64) -> f64 {
        match self {
            Primitive::Inverse => 1.0 / x,
            Primitive::Sqrt => x.sqrt(),
            Primitive::Exp => x.exp(),
            Primitive::Log => x.ln(),
            Primitive::Sin => x.sin(),
            Primitive::Cos => x.cos(),
            Primitive::Tanh => x.tanh(),
            Primitive::SquaredSech => squared_sech(x),
            Primitive::Raise(p) => x.max(0.0).powf(p),
        }
    }
}

/// 1/cosh², without cancellation.
fn squared_sech(x: f64) -> f64 {
    let y = 1.0 / x.cosh();
    y * y
}

/// Numbers with what they carry along.
pub(crate) trait Scalar:
    Copy
    + PartialEq
    + Debug
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
{
    /// How many floats a step's length must suit: the value, and derivatives.
    const PARTS: usize;

    fn constant(value: f64) -> Self;

    fn scaled(self, factor: f64) -> Self;

    fn over(self, other: Self) -> Self {
        self * other.call(Primitive::Inverse)
    }

    fn call(self, function: Primitive) -> Self;

    fn part(&self, which: usize) -> f64;

    fn is_zero(&self) -> bool {
        *self == Self::constant(0.0)
    }
}

impl Scalar for f64 {
    const PARTS: usize = 1;

    fn constant(value: f64) -> f64 {
        value
    }

    fn scaled(self, factor: f64) -> f64 {
        self * factor
    }

    fn over(self, other: f64) -> f64 {
        self / other
    }

    fn call(self, function: Primitive) -> f64 {
        function.at(self)
    }

    fn part(&self, _: usize) -> f64 {
        *self
    }
}

/// A value, first, and its derivatives in N − 1 variables.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Gradient<const N: usize>(pub(crate) [f64; N]);

impl<const N: usize> Gradient<N> {
    /// The variable whose derivative stands at `place`.
    pub fn variable(value: f64, place: usize) -> Self {
        let mut all = Self::constant(value);
        all.0[place] = 1.0;
        all
    }

    /// By Leibniz's rule.
    fn times(self, other: Self) -> Self {
        let (x, y) = (self.0[0], other.0[0]);
        let mut product = self.zip(other, |dx, dy| dx * y + x * dy);
        product.0[0] = x * y;
        product
    }

    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Gradient(std::array::from_fn(|i| f(self.0[i], other.0[i])))
    }
}

impl<const N: usize> Add for Gradient<N> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.zip(other, |x, y| x + y)
    }
}

impl<const N: usize> Sub for Gradient<N> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.zip(other, |x, y| x - y)
    }
}

impl<const N: usize> Neg for Gradient<N> {
    type Output = Self;

    fn neg(self) -> Self {
        Gradient(self.0.map(|x| -x))
    }
}

impl<const N: usize> Mul for Gradient<N> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        self.times(other)
    }
}

impl<const N: usize> Scalar for Gradient<N> {
    const PARTS: usize = N;

    fn constant(value: f64) -> Self {
        let mut all = [0.0; N];
        all[0] = value;
        Gradient(all)
    }

    fn scaled(self, factor: f64) -> Self {
        Gradient(self.0.map(|x| factor * x))
    }

    fn over(self, other: Self) -> Self {
        let (ratio, y) = (self.0[0] / other.0[0], other.0[0]);
        let mut quotient = self.zip(other, |dx, dy| (dx - ratio * dy) / y);
        quotient.0[0] = ratio;
        quotient
    }

    fn call(self, function: Primitive) -> Self {
        let [value, slope, ..] = function.derivatives(self.0[0]);
        // The root of 0 does not vary where its argument does not.
        let mut all = Gradient(self.0.map(|x| if x == 0.0 { 0.0 } else { slope * x }));
        all.0[0] = value;
        all
    }

    fn part(&self, which: usize) -> f64 {
        self.0[which]
    }
}

/// The value of a formula in numbers of any kind; of what chooses, on the side of the switch's value.
pub(crate) fn value<S: Scalar>(formula: &Formula, variables: &[S]) -> S {
    let of = |formula: &Formula| value(formula, variables);
    let float = |exact: &BigRational| exact.to_f64().unwrap_or(f64::NAN);
    match formula {
        Formula::Number(exact) => S::constant(float(exact)),
        Formula::Pi => S::constant(std::f64::consts::PI),
        Formula::Variable(place) => variables[*place],
        Formula::Negated(inner) => -of(inner),
        Formula::Binary(operation, parts) => {
            let [x, y] = parts.each_ref().map(of);
            match operation {
                Operation::Sum => x + y,
                Operation::Difference => x - y,
                Operation::Product => x * y,
                Operation::Quotient => x.over(y),
            }
        }
        Formula::Power(base, exponent) => {
            let base = of(base);
            let power = (0..exponent.unsigned_abs()).fold(S::constant(1.0), |power, _| power * base);
            if *exponent < 0 { power.call(Primitive::Inverse) } else { power }
        }
        Formula::Call(function, inner) => of(inner).call(match function {
            Function::Sqrt => Primitive::Sqrt,
            Function::Exp => Primitive::Exp,
            Function::Sin => Primitive::Sin,
            Function::Cos => Primitive::Cos,
            Function::Log => Primitive::Log,
            Function::Tanh => Primitive::Tanh,
        }),
        Formula::Choice(choice) => {
            of(if of(&choice.switch).part(0) >= 0.0 { &choice.above } else { &choice.below })
        }
        Formula::Raised(base, exponent) => of(base).call(Primitive::Raise(float(exponent))),
    }
}

/// All numbers between two, to be trusted up to rounding: bounds made of it are widened where they are used.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Range {
    pub low: f64,
    pub high: f64,
}

impl Range {
    pub fn new(low: f64, high: f64) -> Range {
        Range { low, high }
    }

    /// The largest modulus.
    pub fn size(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// Everything: of what is not smooth.
    const ALL: Range = Range { low: f64::NEG_INFINITY, high: f64::INFINITY };

    fn of(all: [f64; 4]) -> Range {
        if all.iter().any(|x| x.is_nan()) {
            return Range::ALL;
        }
        let (low, high) =
            all.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(*x), high.max(*x)));
        Range { low, high }
    }

    /// The values of a function that rises.
    fn rising(self, f: impl Fn(f64) -> f64) -> Range {
        Range::of([f(self.low), f(self.high), f(self.low), f(self.high)])
    }
}

impl Add for Range {
    type Output = Range;

    fn add(self, other: Range) -> Range {
        Range { low: self.low + other.low, high: self.high + other.high }
    }
}

impl Sub for Range {
    type Output = Range;

    fn sub(self, other: Range) -> Range {
        self + -other
    }
}

impl Neg for Range {
    type Output = Range;

    fn neg(self) -> Range {
        Range { low: -self.high, high: -self.low }
    }
}

impl Mul for Range {
    type Output = Range;

    fn mul(self, other: Range) -> Range {
        Range::of([
            self.low * other.low,
            self.low * other.high,
            self.high * other.low,
            self.high * other.high,
        ])
    }
}

impl Scalar for Range {
    const PARTS: usize = 2;

    fn constant(value: f64) -> Range {
        Range { low: value, high: value }
    }

    fn scaled(self, factor: f64) -> Range {
        self * Range::constant(factor)
    }

    fn call(self, function: Primitive) -> Range {
        match function {
            Primitive::Inverse if self.low <= 0.0 && self.high >= 0.0 => Range::ALL,
            Primitive::Inverse => Range { low: 1.0 / self.high, high: 1.0 / self.low },
            Primitive::Sqrt | Primitive::Log if self.low.is_nan() || self.low <= 0.0 => Range::ALL,
            Primitive::Sqrt | Primitive::Log | Primitive::Exp | Primitive::Tanh | Primitive::Raise(_) => {
                self.rising(|x| function.at(x))
            }
            // No slope is steeper than 1.
            Primitive::Sin | Primitive::Cos | Primitive::SquaredSech => {
                let (middle, radius) =
                    (function.at((self.low + self.high) / 2.0), (self.high - self.low) / 2.0);
                let least = if function == Primitive::SquaredSech { 0.0 } else { -1.0 };
                if middle.is_nan() || radius.is_nan() {
                    return Range { low: least, high: 1.0 };
                }
                Range { low: (middle - radius).max(least), high: (middle + radius).min(1.0) }
            }
        }
    }

    fn part(&self, which: usize) -> f64 {
        if which == 0 { self.low } else { self.high }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Primitive; 9] = [
        Primitive::Inverse,
        Primitive::Sqrt,
        Primitive::Exp,
        Primitive::Log,
        Primitive::Sin,
        Primitive::Cos,
        Primitive::Tanh,
        Primitive::SquaredSech,
        Primitive::Raise(1.5),
    ];

    /// Each derivative by differences of the one before it.
    #[test]
    fn the_derivatives_of_functions_are_theirs() {
        for function in ALL {
            for x in [0.4, 0.9, 1.7] {
                let h = 1e-5;
                let (here, up, down) =
                    (function.derivatives(x), function.derivatives(x + h), function.derivatives(x - h));
                assert_eq!(here[0], function.at(x), "{function:?}");
                for k in 1..4 {
                    let slope = (up[k - 1] - down[k - 1]) / (2.0 * h);
                    assert!((slope - here[k]).abs() < 1e-7 * (1.0 + here[k].abs()), "{function:?}, {k}, {x}");
                }
            }
        }
    }

    #[test]
    fn a_range_holds_every_value() {
        for function in ALL {
            for (low, high) in [(0.1, 0.3), (0.5, 3.0), (-1.0, 2.0), (-0.5, 0.0), (2.0, 2.0)] {
                let range = Range::new(low, high).call(function);
                for i in 0..=100 {
                    let value = function.at(low + (high - low) * f64::from(i) / 100.0);
                    let inside = range.low - 1e-15 <= value && value <= range.high + 1e-15;
                    assert!(inside || (value.is_nan() && range == Range::ALL), "{function:?} {low} {high}");
                }
            }
        }
        let (x, y) = (Range::new(-1.0, 2.0), Range::new(-3.0, 0.5));
        assert_eq!(x * y, Range::new(-6.0, 3.0));
        assert_eq!(x - y, Range::new(-1.5, 5.0));
        assert_eq!(Range::constant(1.0).over(Range::new(-1.0, 1.0)), Range::ALL);
    }
}
