//! Integer polynomials in two variables, sparse.

use std::collections::BTreeMap;
use std::ops::{Add, Mul, Neg, Sub};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero, pow};

/// An integer polynomial in two variables: the non-zero coefficients by the pair of exponents.
///
/// What the variables are called is settled when it is printed. Sums cost one map operation per term,
/// products one per pair of terms.
///
/// ```
/// use grazing::symbol::Polynomial;
/// let (x, y) = (Polynomial::variable(0), Polynomial::variable(1));
/// let difference = &(&x * &x) - &(&y * &y);
/// assert_eq!(difference.divided_by(&(&x - &y)), Some(&x + &y));
/// assert_eq!(difference.divided_by(&(&x + &Polynomial::from(1))), None);
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Polynomial(BTreeMap<[u32; 2], BigInt>);

impl Polynomial {
    /// The first variable (`index` 0) or the second (any other).
    pub fn variable(index: usize) -> Self {
        Self::monomial(BigInt::one(), if index == 0 { [1, 0] } else { [0, 1] })
    }

    /// The polynomial with one term.
    pub fn monomial(coefficient: BigInt, exponents: [u32; 2]) -> Self {
        let mut terms = BTreeMap::new();
        if !coefficient.is_zero() {
            terms.insert(exponents, coefficient);
        }
        Polynomial(terms)
    }

    /// The terms with their exponents, highest power of the first variable first, then of the second.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (&[u32; 2], &BigInt)> + ExactSizeIterator {
        self.0.iter().rev()
    }

    /// The quotient, if nothing remains; `divisor` must be monic in the first variable.
    ///
    /// Under that condition division by the leading term decides divisibility. `None` where the condition
    /// fails or a remainder is left. Cost: terms of the quotient times terms of the divisor.
    pub fn divided_by(&self, divisor: &Polynomial) -> Option<Polynomial> {
        let (&[lead, second], coefficient) = divisor.terms().next()?;
        if second != 0 || !coefficient.is_one() {
            return None;
        }
        let (mut rest, mut quotient) = (self.clone(), Polynomial::default());
        while let Some((&[i, j], c)) = rest.0.last_key_value() {
            let term = Polynomial::monomial(c.clone(), [i.checked_sub(lead)?, j]);
            for (e, d) in term.0.iter() {
                for (f, b) in divisor.0.iter() {
                    rest.accumulate([e[0] + f[0], e[1] + f[1]], -(d * b));
                }
            }
            quotient.0.extend(term.0);
        }
        Some(quotient)
    }

    /// The value at a rational point, exactly. Cost: per term two powers and a sum, of fractions of d times
    /// the bits of the point, d the degree.
    pub fn evaluate(&self, at: &[BigRational; 2]) -> BigRational {
        let term = |(e, c): (&[u32; 2], &BigInt)| {
            let power = |i: usize| pow(at[i].clone(), e[i] as usize);
            BigRational::from(c.clone()) * power(0) * power(1)
        };
        self.terms().map(term).sum()
    }

    fn accumulate(&mut self, exponents: [u32; 2], value: BigInt) {
        let total = self.0.entry(exponents).or_default();
        *total += value;
        if total.is_zero() {
            self.0.remove(&exponents);
        }
    }
}

impl From<i32> for Polynomial {
    fn from(constant: i32) -> Self {
        Self::monomial(constant.into(), [0, 0])
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: Self) -> Polynomial {
        let mut sum = self.clone();
        other.0.iter().for_each(|(e, c)| sum.accumulate(*e, c.clone()));
        sum
    }
}

impl Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        Polynomial(self.0.iter().map(|(e, c)| (*e, -c)).collect())
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: Self) -> Polynomial {
        self + &-other
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: Self) -> Polynomial {
        let mut product = Polynomial::default();
        for (e, c) in &self.0 {
            for (f, d) in &other.0 {
                product.accumulate([e[0] + f[0], e[1] + f[1]], c * d);
            }
        }
        product
    }
}

impl std::iter::Product for Polynomial {
    fn product<I: Iterator<Item = Polynomial>>(factors: I) -> Polynomial {
        factors.fold(Polynomial::from(1), |product, factor| &product * &factor)
    }
}
