//! Numbers in coefficients that are not rational, as parameters known between two others: what is proved of
//! all between them is proved of the scene's own.

use std::{cell::RefCell, sync::Arc};

use num_rational::BigRational;

use super::{
    expression::Expression,
    scene::{Body, Scene},
    tolerance::{Tolerance, Tolerances},
};
use crate::{
    error::{Error, Result},
    formula::Formula,
    number::{Ball, Precision, Real},
};

/// What the names of such parameters begin with: no scene can have one of that name.
const HIDDEN: char = '\u{3c0}';

/// The bits to which they are known then.
const BITS: u32 = 128;

/// Whether a parameter is none of the scene's.
pub(crate) fn is_hidden(name: &str) -> bool {
    name.starts_with(HIDDEN)
}

/// The numbers found so far, with their bounds, and which parameters of the scene vary.
struct Hiding<'a> {
    scene: &'a Scene,
    varies: &'a dyn Fn(usize) -> bool,
    found: RefCell<Vec<(Formula, [BigRational; 2])>>,
}

impl Hiding<'_> {
    /// The formula with a variable for each of its numbers that is not rational and does not vary.
    fn hide(&self, formula: &Formula) -> Formula {
        let inside = |inner: &Formula| Box::new(self.hide(inner));
        match formula {
            Formula::Pi | Formula::Call(..) => self.variable(formula).unwrap_or_else(|| formula.clone()),
            Formula::Negated(inner) => Formula::Negated(inside(inner)),
            Formula::Power(inner, exponent) => Formula::Power(inside(inner), *exponent),
            Formula::Binary(operation, parts) => {
                Formula::Binary(*operation, Box::new(parts.each_ref().map(|part| self.hide(part))))
            }
            other => other.clone(),
        }
    }

    fn variable(&self, formula: &Formula) -> Option<Formula> {
        if formula.mentions(self.varies) {
            return None;
        }
        let (first, mut found) = (self.scene.parameters.len(), self.found.borrow_mut());
        if let Some(known) = found.iter().position(|(other, _)| other == formula) {
            return Some(Formula::Variable(first + known));
        }
        let (expression, precision) = (Expression::of(formula, "", ""), Precision::new(BITS));
        let exact: Vec<BigRational> = self.scene.parameters.iter().map(|(_, value)| value.clone()).collect();
        if let Ok(value) = expression.evaluate(&exact, &()) {
            return Some(Formula::Number(value));
        }
        let balls: Vec<Ball> = exact.iter().map(|value| Ball::ratio(value, &precision)).collect();
        let (lower, upper) = expression.evaluate(&balls, &precision).ok()?.exact_bounds()?;
        found.push((formula.clone(), [lower, upper]));
        Some(Formula::Variable(first + found.len() - 1))
    }
}

impl Scene {
    /// The same scene with a parameter more for each number of its coefficients that is not rational, such as
    /// π, and does not depend on `varied` nor on what has a tolerance; and the tolerances with those of these
    /// parameters. None where there are no such numbers.
    ///
    /// # Errors
    /// Where the engine is `many`.
    pub(crate) fn with_hidden(
        &self,
        varied: Option<&str>,
        Tolerances(given): &Tolerances,
    ) -> Result<Option<(Scene, Tolerances)>> {
        let names = given.iter().map(|(name, _)| name.as_str()).chain(varied);
        let free = names.map(|name| self.parameter(name)).collect::<Result<Vec<_>>>()?;
        let varies = |place: usize| free.contains(&place);
        let hiding = Hiding { scene: self, varies: &varies, found: RefCell::default() };
        let hidden = |expression: &Expression| {
            let root = hiding.hide(&expression.root);
            Ok::<_, Error>(Expression::of(&root, &expression.text, &expression.key))
        };
        // Nothing is proved of forces that are formulas, nor of velocities.
        let system = self.system()?.in_radians().try_map(hidden)?;
        let found = hiding.found.into_inner();
        if found.is_empty() {
            return Ok(None);
        }
        let (mut scene, mut tolerances) = (self.alone(&[])?, given.clone());
        scene.body = Body::Oscillator(Arc::new(system));
        for (i, (_, [lower, upper])) in found.into_iter().enumerate() {
            let (name, middle) =
                (format!("{HIDDEN}{i}"), (&lower + &upper) / BigRational::from_integer(2.into()));
            scene.parameters.push((name.clone(), middle));
            tolerances.push((name, Tolerance::Between([lower, upper])));
        }
        Ok(Some((scene, Tolerances(tolerances))))
    }
}
