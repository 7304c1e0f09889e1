//! Stops whose force is a formula of their depth and of the speed with which they close.

use crate::motion::SmoothForce;

/// The force of a stop as a formula of its depth and of the speed with which it closes.
#[derive(Debug, Clone, PartialEq)]
pub struct StopForce {
    law: SmoothForce<f64>,
    rate: f64,
}

impl StopForce {
    /// Of a law, velocities per radian times `rate` being those of the scene.
    pub fn new(law: &SmoothForce<f64>, rate: f64) -> StopForce {
        StopForce { law: law.clone(), rate }
    }

    /// The force at z and z′, per radian.
    pub(crate) fn at(&self, [gap, rate]: [f64; 2]) -> f64 {
        if gap > 0.0 {
            return 0.0;
        }
        self.whole(-gap, -rate * self.rate).max(0.0)
    }

    /// What the formula says at a depth and a speed of closing.
    fn whole(&self, depth: f64, speed: f64) -> f64 {
        let motion = [depth, speed, 0.0].into_iter();
        let variables: Vec<f64> = motion.chain(self.law.coefficients().iter().copied()).collect();
        self.law.formula.at(&variables)[0]
    }

    /// Whether it pulls at rest at all depths looked at, which is a mistake in its sign.
    pub(crate) fn pulls(&self) -> bool {
        decades().all(|depth| self.whole(depth, 0.0) < 0.0)
    }

    /// A depth and a speed at which it pushes harder as the stop is left than as it is entered, of those
    /// looked at.
    pub fn gains(&self) -> Option<(f64, f64)> {
        let more = |&(depth, speed): &(f64, f64)| {
            let [enters, leaves] = [speed, -speed].map(|speed| self.whole(depth, speed).max(0.0));
            leaves > enters * (1.0 + 1e-9)
        };
        decades().flat_map(|depth| decades().map(move |speed| (depth, speed))).find(more)
    }
}

/// Depths and speeds in all units: a stop's law is looked at there for what is likely to be a mistake.
fn decades() -> impl Iterator<Item = f64> {
    (-9..=6).map(|power| 10f64.powi(power))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::formula::{Formula, Operation};

    /// k d + c v and nothing else, by its coefficients.
    fn law(k: f64, c: f64) -> StopForce {
        let times = |place: usize, coefficient: usize| {
            Formula::Binary(Operation::Product, Box::new([place, coefficient].map(Formula::Variable)))
        };
        let formula = Formula::Binary(Operation::Sum, Box::new([times(0, 3), times(1, 4)]));
        let law = SmoothForce { formula: Arc::new(formula), text: String::new(), coefficients: vec![k, c] };
        StopForce::new(&law, 1.0)
    }

    #[test]
    fn a_law_that_never_pushes_and_one_that_adds_energy_are_told() {
        assert!(law(-5.0, 1.0).pulls() && !law(5.0, 1.0).pulls() && !law(0.0, 0.0).pulls());
        assert_eq!(law(5.0, 1.0).gains(), None);
        assert_eq!(law(5.0, 0.0).gains(), None);
        let (depth, speed) = law(5.0, -1.0).gains().unwrap();
        assert!(5.0 * depth + speed > (5.0 * depth - speed).max(0.0));
    }
}
