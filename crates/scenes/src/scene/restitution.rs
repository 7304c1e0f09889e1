//! The key `restitution`: a constant, or a rational function of the speed of the impact.

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::{
    expression::Expression,
    keys::{Entry, Value},
};
use crate::{
    error::{Error, Result},
    formula::{Formula, Operation},
    many::{MOST_POWERS, SpeedLaw},
};

/// What stands under `restitution`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum RestitutionKey {
    /// An expression in the parameters.
    Constant(Expression),
    /// One in v, too.
    Speed(SpeedLaw<Expression>),
}

/// What the speed is called, unless a parameter is.
const SPEED: &str = "v";

impl Value for RestitutionKey {
    fn shape() -> String {
        "expression".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let text = entry.expression()?;
        read(&text, entry.scope.names, &entry.path).map_err(|error| entry.fail(&error.to_string()))
    }
}

fn read(text: &str, parameters: &[String], key: &str) -> Result<RestitutionKey> {
    let count = parameters.len();
    let named = parameters.iter().any(|name| name == SPEED);
    let names: Vec<String> = parameters.iter().cloned().chain((!named).then(|| SPEED.to_string())).collect();
    let speed = |place: usize| place >= count;
    let mut whole = Expression::parse(text, &names)?;
    whole.key = key.to_string();
    if !whole.mentions(&speed) {
        return Ok(RestitutionKey::Constant(whole));
    }
    let [over, under] = quotient(&whole.root, count)?;
    if over.len().max(under.len()) > MOST_POWERS + 1 {
        return Err(Error::input(format!("has powers of v above {MOST_POWERS}")));
    }
    let list = |all: Vec<Formula>| all.iter().map(|c| Expression::of(c, text, key)).collect();
    let text_alone = text.split_whitespace().collect();
    Ok(RestitutionKey::Speed(SpeedLaw { text: text_alone, over: list(over), under: list(under) }))
}

/// Coefficients, from the constant one on, as formulas in the parameters.
type Polynomial = Vec<Formula>;

fn number(value: i32) -> Formula {
    Formula::Number(BigRational::from_integer(value.into()))
}

/// Numerator and denominator in v, which is the variable at `place`.
fn quotient(formula: &Formula, place: usize) -> Result<[Polynomial; 2]> {
    if !formula.mentions(&|index| index == place) {
        return Ok([vec![formula.clone()], vec![number(1)]]);
    }
    let checked = |[over, under]: [Polynomial; 2]| {
        let size = |p: &Polynomial| p.iter().map(Formula::size).sum::<u64>();
        if over.len().max(under.len()) > 4 * MOST_POWERS || size(&over) + size(&under) > 4096 {
            return Err(Error::input("is too long a function of v: write it as a quotient of polynomials"));
        }
        Ok([over, under])
    };
    checked(match formula {
        Formula::Variable(_) => [vec![number(0), number(1)], vec![number(1)]],
        Formula::Negated(inner) => {
            let [over, under] = quotient(inner, place)?;
            [over.into_iter().map(|c| joined(Operation::Difference, number(0), c)).collect(), under]
        }
        Formula::Binary(operation, parts) => {
            let [a, b] = quotient(&parts[0], place)?;
            let [c, d] = quotient(&parts[1], place)?;
            match operation {
                Operation::Product => [times(&a, &c), times(&b, &d)],
                Operation::Quotient => [times(&a, &d), times(&b, &c)],
                sum => [plus(*sum, &times(&a, &d), &times(&c, &b)), times(&b, &d)],
            }
        }
        Formula::Power(inner, exponent) => {
            let [mut over, mut under] = quotient(inner, place)?;
            if *exponent < 0 {
                std::mem::swap(&mut over, &mut under);
            }
            let mut power = [vec![number(1)], vec![number(1)]];
            for _ in 0..exponent.unsigned_abs() {
                power = checked([times(&power[0], &over), times(&power[1], &under)])?;
            }
            power
        }
        _ => {
            return Err(Error::input(
                "is not a rational function of the speed v: v may stand under + - * / and whole powers",
            ));
        }
    })
}

fn times(a: &[Formula], b: &[Formula]) -> Polynomial {
    let mut all = vec![number(0); a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            let product = joined(Operation::Product, x.clone(), y.clone());
            all[i + j] = joined(Operation::Sum, all[i + j].clone(), product);
        }
    }
    all
}

fn plus(operation: Operation, a: &[Formula], b: &[Formula]) -> Polynomial {
    let get = |all: &[Formula], i: usize| all.get(i).cloned().unwrap_or_else(|| number(0));
    (0..a.len().max(b.len())).map(|i| joined(operation, get(a, i), get(b, i))).collect()
}

/// x ∘ y, numbers being computed, and 0 and 1 left out.
fn joined(operation: Operation, x: Formula, y: Formula) -> Formula {
    let zero = |x: &Formula| matches!(x, Formula::Number(value) if value.is_zero());
    let one = |x: &Formula| matches!(x, Formula::Number(value) if value.is_one());
    match (operation, &x, &y) {
        (Operation::Sum, Formula::Number(a), Formula::Number(b)) => Formula::Number(a + b),
        (Operation::Difference, Formula::Number(a), Formula::Number(b)) => Formula::Number(a - b),
        (Operation::Product, Formula::Number(a), Formula::Number(b)) => Formula::Number(a * b),
        (Operation::Sum, ..) if zero(&x) => y,
        (Operation::Sum | Operation::Difference, ..) if zero(&y) => x,
        (Operation::Product, ..) if zero(&x) || one(&y) => x,
        (Operation::Product, ..) if zero(&y) || one(&x) => y,
        _ => Formula::Binary(operation, Box::new([x, y])),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn laws_have_the_values_of_their_text() {
        let names = ["e".to_string(), "mu".to_string()];
        let values = [0.7, 0.3].map(|x| BigRational::from_float(x).unwrap());
        let (e, mu) = (0.7, 0.3);
        for (text, expected) in [
            ("1/(1 + v/2)", (|v: f64, _, _| 1.0 / (1.0 + v / 2.0)) as fn(f64, f64, f64) -> f64),
            ("e - mu*v/(1 + v)^2", |v, e, mu| e - mu * v / (1.0 + v).powi(2)),
            ("-(-e)/(1 + v)^-1/(2 + v^2)", |v, e, _| e * (1.0 + v) / (2.0 + v * v)),
            ("e*(1 - v/(mu + v))", |v, e, mu| e * (1.0 - v / (mu + v))),
        ] {
            let RestitutionKey::Speed(law) = read(text, &names, "").unwrap() else { panic!("{text}") };
            let law = law.try_map(&mut |c| c.evaluate(&values, &())).unwrap();
            let law = law.try_map(&mut |c| num_traits::ToPrimitive::to_f64(c).ok_or(())).unwrap();
            for v in [0.0, 0.1, 1.0, 7.0] {
                let ([tau, slope], h) = (law.at(v), 1e-5);
                assert!((tau - expected(v, e, mu)).abs() < 1e-12, "{text} at {v}: {tau}");
                let difference = (expected(v + h, e, mu) - expected(v - h, e, mu)) / (2.0 * h);
                assert!((slope - difference).abs() < 1e-8, "{text} at {v}: {slope} {difference}");
            }
        }
        assert!(matches!(read("0.8*e", &names, ""), Ok(RestitutionKey::Constant(_))));
        // A parameter of that name is the parameter.
        assert!(matches!(read("v/2", &["v".to_string()], ""), Ok(RestitutionKey::Constant(_))));
        assert!(read("sqrt(v)", &names, "").unwrap_err().to_string().contains("not a rational function"));
        assert!(read("v^9", &names, "").unwrap_err().to_string().contains("above 8"));
        assert!(read("w*v", &names, "").unwrap_err().to_string().contains("unknown parameter \"w\""));
    }
}
