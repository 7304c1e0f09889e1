//! Enclosures with first derivatives: forward differentiation over balls.

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_rational::BigRational;

use crate::number::{Ball, Elementary, Precision, Real, Sign};

/// A number and its derivatives by the unknowns, each enclosed. Of every operation the value and the
/// derivatives contain the true ones for all enclosed unknowns.
#[derive(Debug, Clone)]
pub struct Jet {
    /// The number.
    pub(crate) value: Ball,
    /// The derivatives; none at all for a constant.
    pub(crate) slopes: Vec<Ball>,
}

impl Jet {
    /// A number that depends on no unknown.
    pub(crate) fn constant(value: Ball) -> Jet {
        Jet { value, slopes: Vec::new() }
    }

    /// The unknown with this index among `count`.
    pub(crate) fn variable(value: Ball, index: usize, count: usize, precision: &Precision) -> Jet {
        let slopes = (0..count).map(|i| Ball::integer(i32::from(i == index), precision)).collect();
        Jet { value, slopes }
    }

    /// `value` with the chain rule's derivatives `outer`·self′.
    fn chained(&self, value: Ball, outer: &Ball) -> Jet {
        Jet { value, slopes: self.slopes.iter().map(|slope| slope.clone() * outer).collect() }
    }
}

/// Two lists of derivatives added up, where none at all stands for zeros.
fn sum(a: Vec<Ball>, b: &[Ball]) -> Vec<Ball> {
    match (a.is_empty(), b.is_empty()) {
        (true, _) => b.to_vec(),
        (_, true) => a,
        _ => a.into_iter().zip(b).map(|(a, b)| a + b).collect(),
    }
}

impl Neg for Jet {
    type Output = Jet;

    fn neg(self) -> Jet {
        Jet { value: -self.value, slopes: self.slopes.into_iter().map(Neg::neg).collect() }
    }
}

impl Add<&Jet> for Jet {
    type Output = Jet;

    fn add(self, other: &Jet) -> Jet {
        Jet { value: self.value + &other.value, slopes: sum(self.slopes, &other.slopes) }
    }
}

impl Sub<&Jet> for Jet {
    type Output = Jet;

    fn sub(self, other: &Jet) -> Jet {
        -(-self + other)
    }
}

impl Mul<&Jet> for Jet {
    type Output = Jet;

    fn mul(self, other: &Jet) -> Jet {
        let value = self.value.clone() * &other.value;
        let right = other.chained(self.value.clone(), &self.value);
        let left = self.chained(value, &other.value);
        Jet { value: left.value, slopes: sum(left.slopes, &right.slopes) }
    }
}

impl Div<&Jet> for Jet {
    type Output = Jet;

    /// Nothing is known of the quotient where the divisor may be zero.
    fn div(self, other: &Jet) -> Jet {
        // (a/b)′ = (a′ − (a/b) b′)/b.
        let value = self.value / &other.value;
        let right = other.chained(value.clone(), &-value.clone());
        let slopes = sum(self.slopes, &right.slopes).into_iter().map(|slope| slope / &other.value);
        Jet { value, slopes: slopes.collect() }
    }
}

impl Real for Jet {
    type Context = Precision;

    fn ratio(value: &BigRational, context: &Precision) -> Jet {
        Jet::constant(Ball::ratio(value, context))
    }

    fn integer(value: i32, context: &Precision) -> Jet {
        Jet::constant(Ball::integer(value, context))
    }

    /// The sign of the value.
    fn sign(&self) -> Option<Sign> {
        self.value.sign()
    }
}

impl Elementary for Jet {
    fn pi(context: &Precision) -> Jet {
        Jet::constant(Ball::pi(context))
    }

    fn exp(&self, context: &Precision) -> Jet {
        let value = self.value.exp(context);
        self.chained(value.clone(), &value)
    }

    fn sin_cos(&self, context: &Precision) -> (Jet, Jet) {
        let (sin, cos) = self.value.sin_cos(context);
        (self.chained(sin.clone(), &cos), self.chained(cos, &-sin))
    }

    fn sqrt(&self) -> Jet {
        // (√x)′ = x′/(2√x).
        let root = self.value.sqrt();
        let slopes = self.slopes.iter().map(|slope| slope.clone() / &(root.clone() + &root)).collect();
        Jet { value: root, slopes }
    }
}
