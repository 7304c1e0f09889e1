//! Polynomials of degree at most 3 in two variables: the arithmetic of a map's Taylor expansion, without
//! differences.

use std::ops::{Add, Mul, Neg, Sub};

use crate::motion::flow::{Primitive, Scalar};

/// How many monomials x^i y^j with i + j ≤ 3 there are.
const TERMS: usize = 10;

/// A polynomial in x and y; products are cut off after degree 3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cubic([f64; TERMS]);

/// Where the coefficient of x^i y^j stands: by degree, then by j.
const fn place(i: usize, j: usize) -> usize {
    let degree = i + j;
    degree * (degree + 1) / 2 + j
}

impl Cubic {
    /// A number.
    pub(crate) fn constant(value: f64) -> Cubic {
        let mut all = [0.0; TERMS];
        all[0] = value;
        Cubic(all)
    }

    /// `value` + x (0) or + y (1).
    pub(crate) fn variable(value: f64, which: usize) -> Cubic {
        let mut found = Cubic::constant(value);
        found.0[1 + which] = 1.0;
        found
    }

    /// Of these coefficients: of 1, x, y, x², xy, y², x³, x²y, xy², y³.
    pub(crate) fn of(coefficients: [f64; 10]) -> Cubic {
        Cubic(coefficients)
    }

    /// All coefficients, in the order of [`of`](Self::of).
    pub(crate) fn coefficients(&self) -> &[f64; 10] {
        &self.0
    }

    /// The coefficient of x^i y^j, i + j ≤ 3.
    pub fn coefficient(&self, i: usize, j: usize) -> f64 {
        self.0[place(i, j)]
    }

    /// The polynomial with one coefficient replaced.
    #[must_use]
    pub(crate) fn with(mut self, i: usize, j: usize, value: f64) -> Cubic {
        self.0[place(i, j)] = value;
        self
    }

    /// The value at (0, 0).
    pub(crate) fn value(&self) -> f64 {
        self.0[0]
    }

    /// What is left without the value at (0, 0): its powers from the fourth on vanish.
    #[must_use]
    pub(crate) fn without_value(self) -> Cubic {
        self.with(0, 0, 0.0)
    }

    /// `factor` times the polynomial.
    #[must_use]
    pub(crate) fn scaled(self, factor: f64) -> Cubic {
        Cubic(self.0.map(|x| factor * x))
    }

    /// 1/self; the value at (0, 0) must not be 0.
    #[must_use]
    pub(crate) fn inverse(self) -> Cubic {
        let value = self.value();
        let rest = self.without_value().scaled(-1.0 / value);
        polynomial(&[1.0; 4].map(Cubic::constant), rest).scaled(1.0 / value)
    }

    /// The largest modulus of a coefficient.
    pub fn size(&self) -> f64 {
        self.0.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
    }
}

/// Σ c_k x^k by Horner's rule.
pub(crate) fn polynomial(coefficients: &[Cubic], x: Cubic) -> Cubic {
    coefficients.iter().rev().fold(Cubic::constant(0.0), |sum, c| sum * x + *c)
}

impl Add for Cubic {
    type Output = Cubic;

    fn add(mut self, other: Cubic) -> Cubic {
        self.0.iter_mut().zip(other.0).for_each(|(x, y)| *x += y);
        self
    }
}

impl Sub for Cubic {
    type Output = Cubic;

    fn sub(self, other: Cubic) -> Cubic {
        self + -other
    }
}

impl Neg for Cubic {
    type Output = Cubic;

    fn neg(self) -> Cubic {
        self.scaled(-1.0)
    }
}

impl Mul for Cubic {
    type Output = Cubic;

    fn mul(self, other: Cubic) -> Cubic {
        let mut product = [0.0; TERMS];
        for a in 0..=3 {
            for b in 0..=3 - a {
                for i in 0..=a {
                    for j in 0..=b {
                        product[place(a + b - i - j, i + j)] +=
                            self.0[place(a - i, i)] * other.0[place(b - j, j)];
                    }
                }
            }
        }
        Cubic(product)
    }
}

/// Functions by their own Taylor polynomials.
impl Scalar for Cubic {
    const PARTS: usize = TERMS;

    fn constant(value: f64) -> Cubic {
        Cubic::constant(value)
    }

    fn scaled(self, factor: f64) -> Cubic {
        Cubic::scaled(self, factor)
    }

    fn call(self, function: Primitive) -> Cubic {
        let [value, first, second, third] = function.derivatives(self.value());
        let terms = [value, first, second / 2.0, third / 6.0].map(Cubic::constant);
        polynomial(&terms, self.without_value())
    }

    fn part(&self, which: usize) -> f64 {
        self.0[which]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_and_inverses_agree_with_the_binomial_series() {
        let (x, y) = (Cubic::variable(0.0, 0), Cubic::variable(0.0, 1));
        let sum = x + y.scaled(2.0);
        let cube = sum * sum * sum;
        for (j, want) in [1.0, 6.0, 12.0, 8.0].into_iter().enumerate() {
            assert_eq!(cube.coefficient(3 - j, j), want);
        }
        assert_eq!(cube * x, Cubic::constant(0.0));
        let inverse = (Cubic::constant(2.0) + sum).inverse();
        let product = inverse * (Cubic::constant(2.0) + sum);
        assert_eq!(product, Cubic::constant(1.0));
        assert_eq!(inverse.coefficient(0, 3), -0.5);
        assert_eq!(inverse.size(), 0.75);
    }
}
