//! The key `law` of a stop: its force as a formula of depth and speed; and `coefficient` of friction: a
//! number, or a formula of the sliding speed.

use super::{
    expression::Expression,
    force::{ForceKey, Variables, read},
    keys::{Entry, Value},
};
use crate::{error::Result, motion::SmoothForce};

/// What stands under `law`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LawKey(pub SmoothForce<Expression>);

impl Value for LawKey {
    fn shape() -> String {
        "expression, also in d and v".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let text = entry.expression()?;
        let law = read(&text, entry.scope.names, &entry.path, &Variables::of_contact());
        match law.map_err(|error| entry.fail(&error.to_string()))? {
            ForceKey::Smooth(force) if force.mentions(&|place| place < 2) => Ok(LawKey(force)),
            _ => {
                let hides = |name: &&str| entry.scope.names.iter().any(|known| known == name);
                let hidden = ["d", "v"]
                    .into_iter()
                    .find(hides)
                    .map(|name| format!("; {name} is a parameter of the scene here: rename the parameter"));
                let hidden = hidden.unwrap_or_else(|| ": write k*d^1.5, or the like".to_string());
                Err(entry.fail(&format!("depends on neither the depth d nor the speed of closing v{hidden}")))
            }
        }
    }
}

/// What stands under `coefficient`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum CoefficientKey {
    /// A number.
    Constant(Expression),
    /// A formula in the sliding speed.
    Law(SmoothForce<Expression>),
}

impl Value for CoefficientKey {
    fn shape() -> String {
        "expression, also in v".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let (text, names) = (entry.expression()?, entry.scope.names);
        let key = read(&text, names, &entry.path, &Variables::of_sliding());
        match key.map_err(|error| entry.fail(&error.to_string()))? {
            ForceKey::Constant(whole) if whole.mentions(&|place| names[place] == "v") => Err(entry.fail(
                "is in v, the sliding speed, which is a parameter of the scene, too: rename the parameter",
            )),
            ForceKey::Constant(whole) => Ok(CoefficientKey::Constant(whole)),
            ForceKey::Smooth(law) => Ok(CoefficientKey::Law(law)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::Formula;

    #[test]
    fn laws_are_formulas_in_depth_and_speed() {
        let read = |text: &str, names: &[&str]| {
            let names: Vec<String> = names.iter().map(|name| (*name).to_string()).collect();
            read(text, &names, "", &Variables::of_contact())
        };
        let Ok(ForceKey::Smooth(law)) = read("k*d^1.5*(1 + c*v)", &["k", "c"]) else {
            panic!("depends on d")
        };
        assert_eq!((law.text(), law.coefficients.len()), ("k*d^1.5*(1+c*v)", 2));
        let Formula::Binary(..) = &*law.formula else { panic!("{law:?}") };
        assert!(read("k*d^1.5*v", &["k", "d"]).unwrap_err().to_string().contains("rename the parameter"));
        assert!(read("q + d", &[]).unwrap_err().to_string().contains("unknown parameter"));
        assert!(matches!(read("3", &[]), Ok(ForceKey::Constant(_))));
    }
}
