//! Formulas as trees: what the scenes' grammar reads, and what forces are made of.

use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// A formula in variables that are known by their places in a list.
#[derive(Debug, Clone, PartialEq)]
pub enum Formula {
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
    /// One formula where another, the switch, is positive, and a third where that is negative.
    Choice(Box<Choice>),
    /// x^p for a p > 1 that is no whole number: of x ≥ 0.
    Raised(Box<Formula>, BigRational),
}

/// What has a kink or a jump where a switch is 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// As it was written, without spaces.
    pub text: String,
    /// Whose sign chooses.
    pub switch: Formula,
    /// Where it is positive.
    pub above: Formula,
    /// Where it is negative.
    pub below: Formula,
}

impl Choice {
    /// The switch and both branches.
    pub fn parts(&self) -> [&Formula; 3] {
        [&self.switch, &self.above, &self.below]
    }

    /// The same with other parts.
    pub fn mapped(&self, mut map: impl FnMut(&Formula) -> Formula) -> Choice {
        let [switch, above, below] = self.parts().map(&mut map);
        Choice { text: self.text.clone(), switch, above, below }
    }
}

/// Functions with kinks and jumps, each with how many arguments it has.
pub const KINKS: [(&str, usize); 4] = [("abs", 1), ("sign", 1), ("max", 2), ("min", 2)];

/// One of [`KINKS`] of its arguments.
pub fn kink(name: &str, text: &str, arguments: Vec<Formula>) -> Option<Formula> {
    let whole = |n: i32| Formula::Number(BigRational::from_integer(n.into()));
    let negated = |x: &Formula| Formula::Negated(Box::new(x.clone()));
    let (switch, above, below) = match (name, &arguments[..]) {
        ("abs", [x]) => (x.clone(), x.clone(), negated(x)),
        ("sign", [x]) => (x.clone(), whole(1), whole(-1)),
        ("max", [x, y]) => (difference(x, y), x.clone(), y.clone()),
        ("min", [x, y]) => (difference(x, y), y.clone(), x.clone()),
        _ => return None,
    };
    let text = text.split_whitespace().collect();
    Some(Formula::Choice(Box::new(Choice { text, switch, above, below })))
}

/// x − y.
fn difference(x: &Formula, y: &Formula) -> Formula {
    if matches!(y, Formula::Number(zero) if zero.is_zero()) {
        return x.clone();
    }
    Formula::Binary(Operation::Difference, Box::new([x.clone(), y.clone()]))
}

/// What joins two formulas.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operation {
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
    pub const ALL: [(&'static str, Function); 6] = [
        ("sqrt", Function::Sqrt),
        ("exp", Function::Exp),
        ("sin", Function::Sin),
        ("cos", Function::Cos),
        ("log", Function::Log),
        ("tanh", Function::Tanh),
    ];

    /// Its name in a formula.
    pub fn name(self) -> &'static str {
        Function::ALL.into_iter().find(|known| known.1 == self).map_or("", |known| known.0)
    }

    /// The value at x.
    fn at(self, x: f64) -> f64 {
        match self {
            Function::Sqrt => x.sqrt(),
            Function::Exp => x.exp(),
            Function::Sin => x.sin(),
            Function::Cos => x.cos(),
            Function::Log => x.ln(),
            Function::Tanh => x.tanh(),
        }
    }

    /// The value at an exact number where it is rational.
    pub fn exactly(self, x: &BigRational) -> Option<BigRational> {
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
            Formula::Choice(choice) => {
                choice.parts().iter().fold(0, |sum: u64, part| sum.saturating_add(part.size()))
            }
            Formula::Raised(base, _) => base.size().saturating_add(1),
        }
    }

    /// The same with a formula in place of each variable.
    pub fn substituted(&self, variables: &dyn Fn(usize) -> Formula) -> Formula {
        self.replaced(&|leaf| match leaf {
            Formula::Variable(index) => variables(*index),
            other => other.clone(),
        })
    }

    /// The same with a formula in place of each number, variable and π.
    pub fn replaced(&self, leaves: &dyn Fn(&Formula) -> Formula) -> Formula {
        match self {
            Formula::Number(_) | Formula::Pi | Formula::Variable(_) => leaves(self),
            _ => self.mapped(&mut |part| part.replaced(leaves)),
        }
    }

    /// The same with other parts; a number, a variable and π have none.
    pub fn mapped(&self, map: &mut dyn FnMut(&Formula) -> Formula) -> Formula {
        match self {
            Formula::Number(_) | Formula::Pi | Formula::Variable(_) => self.clone(),
            Formula::Negated(inner) => Formula::Negated(Box::new(map(inner))),
            Formula::Power(inner, exponent) => Formula::Power(Box::new(map(inner)), *exponent),
            Formula::Call(function, inner) => Formula::Call(*function, Box::new(map(inner))),
            Formula::Binary(operation, parts) => {
                Formula::Binary(*operation, Box::new(parts.each_ref().map(map)))
            }
            Formula::Choice(choice) => Formula::Choice(Box::new(choice.mapped(map))),
            Formula::Raised(inner, exponent) => Formula::Raised(Box::new(map(inner)), exponent.clone()),
        }
    }

    /// Whether a variable of these stands in it.
    pub fn mentions(&self, which: &dyn Fn(usize) -> bool) -> bool {
        match self {
            Formula::Number(_) | Formula::Pi => false,
            Formula::Variable(index) => which(*index),
            Formula::Negated(inner)
            | Formula::Power(inner, _)
            | Formula::Call(_, inner)
            | Formula::Raised(inner, _) => inner.mentions(which),
            Formula::Binary(_, parts) => parts.iter().any(|part| part.mentions(which)),
            Formula::Choice(choice) => choice.parts().iter().any(|part| part.mentions(which)),
        }
    }

    /// Whether it is made of numbers and variables by + − · / and whole powers alone.
    pub fn is_rational(&self) -> bool {
        match self {
            Formula::Number(_) | Formula::Variable(_) => true,
            Formula::Pi | Formula::Call(..) | Formula::Choice(_) | Formula::Raised(..) => false,
            Formula::Negated(inner) | Formula::Power(inner, _) => inner.is_rational(),
            Formula::Binary(_, parts) => parts.iter().all(Formula::is_rational),
        }
    }

    /// Whether it has kinks or jumps, or powers that need not be whole.
    pub fn has_kinks(&self) -> bool {
        match self {
            Formula::Number(_) | Formula::Variable(_) | Formula::Pi => false,
            Formula::Negated(inner) | Formula::Power(inner, _) | Formula::Call(_, inner) => inner.has_kinks(),
            Formula::Binary(_, parts) => parts.iter().any(Formula::has_kinks),
            Formula::Choice(_) | Formula::Raised(..) => true,
        }
    }

    /// Whether it has kinks or jumps.
    pub fn chooses(&self) -> bool {
        match self {
            Formula::Number(_) | Formula::Variable(_) | Formula::Pi => false,
            Formula::Negated(inner)
            | Formula::Power(inner, _)
            | Formula::Call(_, inner)
            | Formula::Raised(inner, _) => inner.chooses(),
            Formula::Binary(_, parts) => parts.iter().any(Formula::chooses),
            Formula::Choice(_) => true,
        }
    }

    /// Its value, and the sum of the moduli of what that was added up from.
    pub fn at(&self, variables: &[f64]) -> [f64; 2] {
        let float = |value: &BigRational| value.to_f64().unwrap_or(f64::NAN);
        let alone = |x: f64| [x, x.abs()];
        match self {
            Formula::Number(value) => alone(float(value)),
            Formula::Pi => alone(std::f64::consts::PI),
            Formula::Variable(place) => alone(variables[*place]),
            Formula::Negated(inner) => {
                let [x, size] = inner.at(variables);
                [-x, size]
            }
            Formula::Binary(operation, parts) => {
                let [[x, a], [y, b]] = parts.each_ref().map(|part| part.at(variables));
                match operation {
                    Operation::Sum => [x + y, a + b],
                    Operation::Difference => [x - y, a + b],
                    Operation::Product => [x * y, a * b],
                    Operation::Quotient => [x / y, a / y.abs()],
                }
            }
            Formula::Power(base, exponent) => {
                let [x, size] = base.at(variables);
                [
                    x.powi(*exponent),
                    if *exponent < 0 { x.powi(*exponent).abs() } else { size.powi(*exponent) },
                ]
            }
            Formula::Call(function, inner) => alone(function.at(inner.at(variables)[0])),
            Formula::Choice(choice) => {
                let chosen =
                    if choice.switch.at(variables)[0] >= 0.0 { &choice.above } else { &choice.below };
                chosen.at(variables)
            }
            Formula::Raised(base, exponent) => alone(base.at(variables)[0].max(0.0).powf(float(exponent))),
        }
    }
}
