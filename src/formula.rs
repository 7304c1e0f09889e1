//! Formulas as trees: what the scenes' grammar reads, and what forces are made of.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// A formula in variables that are known by their places in a list.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Formula {
    /// An exact number.
    Number(BigRational),
    /// The variable at a place.
    Variable(usize),
    /// −x.
    Negated(Box<Formula>),
    /// x ∘ y.
    Binary(Operation, Box<[Formula; 2]>),
    /// x^n.
    Power(Box<Formula>, i32),
    /// π.
    Pi,
    /// f(x).
    Call(Function, Box<Formula>),
}

/// What joins two formulas.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Operation {
    /// x + y.
    Sum,
    /// x − y.
    Difference,
    /// x y.
    Product,
    /// x / y.
    Quotient,
}

/// A function of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Function {
    /// √x.
    Sqrt,
    /// e^x.
    Exp,
    /// sin x, in radians.
    Sin,
    /// cos x, in radians.
    Cos,
    /// The natural logarithm.
    Log,
    /// The hyperbolic tangent.
    Tanh,
}

impl Function {
    /// All, with their names.
    pub(crate) const ALL: [(&'static str, Function); 6] = [
        ("sqrt", Function::Sqrt),
        ("exp", Function::Exp),
        ("sin", Function::Sin),
        ("cos", Function::Cos),
        ("log", Function::Log),
        ("tanh", Function::Tanh),
    ];

    /// Its name in a formula.
    pub(crate) fn name(self) -> &'static str {
        Function::ALL.into_iter().find(|known| known.1 == self).map_or("", |known| known.0)
    }

    /// The value at an exact number where it is rational.
    pub(crate) fn exactly(self, x: &BigRational) -> Option<BigRational> {
        match self {
            Function::Sqrt if !x.is_negative() => {
                let root = BigRational::new(x.numer().sqrt(), x.denom().sqrt());
                (&root * &root == *x).then_some(root)
            }
            Function::Sin | Function::Tanh if x.is_zero() => Some(BigRational::zero()),
            Function::Exp | Function::Cos if x.is_zero() => Some(BigRational::one()),
            Function::Log if x.is_one() => Some(BigRational::zero()),
            _ => None,
        }
    }
}

impl Formula {
    /// Its factors and terms, powers written out.
    pub fn size(&self) -> u64 {
        match self {
            Formula::Number(_) | Formula::Variable(_) | Formula::Pi => 1,
            Formula::Call(_, inner) => inner.size().saturating_add(1),
            Formula::Negated(inner) => inner.size(),
            Formula::Binary(_, parts) => parts[0].size() + parts[1].size(),
            Formula::Power(base, exponent) => {
                base.size().saturating_mul(exponent.unsigned_abs().into()).clamp(1, 1 << 32)
            }
        }
    }

    /// The same with a formula in place of each variable.
    pub fn substituted(&self, variables: &dyn Fn(usize) -> Formula) -> Formula {
        let inside = |inner: &Formula| Box::new(inner.substituted(variables));
        match self {
            Formula::Number(_) | Formula::Pi => self.clone(),
            Formula::Variable(index) => variables(*index),
            Formula::Negated(inner) => Formula::Negated(inside(inner)),
            Formula::Power(inner, exponent) => Formula::Power(inside(inner), *exponent),
            Formula::Call(function, inner) => Formula::Call(*function, inside(inner)),
            Formula::Binary(operation, parts) => {
                let parts = parts.each_ref().map(|part| part.substituted(variables));
                Formula::Binary(*operation, Box::new(parts))
            }
        }
    }

    /// Whether a variable of these stands in it.
    pub fn mentions(&self, which: &dyn Fn(usize) -> bool) -> bool {
        match self {
            Formula::Number(_) | Formula::Pi => false,
            Formula::Variable(index) => which(*index),
            Formula::Negated(inner) | Formula::Power(inner, _) | Formula::Call(_, inner) => {
                inner.mentions(which)
            }
            Formula::Binary(_, parts) => parts.iter().any(|part| part.mentions(which)),
        }
    }

    /// Whether it is made of numbers and variables by + − · / and whole powers alone.
    pub fn is_rational(&self) -> bool {
        match self {
            Formula::Number(_) | Formula::Variable(_) => true,
            Formula::Pi | Formula::Call(..) => false,
            Formula::Negated(inner) | Formula::Power(inner, _) => inner.is_rational(),
            Formula::Binary(_, parts) => parts.iter().all(Formula::is_rational),
        }
    }
}
