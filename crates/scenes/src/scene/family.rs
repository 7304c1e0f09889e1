//! The oscillators of a scene as one of its parameters varies.

use std::{convert::Infallible, sync::Arc};

use num_traits::ToPrimitive;

use super::{dual::Dual, scene::Scene};

use crate::{
    error::{Error, Result},
    many::{self, Machine},
    motion::{EffectTally, System},
    one::orbit::{Family, Oscillator},
};

/// A scene with one parameter free, the others at their values.
#[derive(Debug, Clone)]
pub struct SceneFamily<'s> {
    scene: &'s Scene,
    values: Vec<f64>,
    free: usize,
    /// The system's coefficients that the parameter does not stand in, in the order of
    /// [`System::try_map`](crate::motion::System::try_map).
    fixed: Vec<Option<Dual>>,
    tally: Option<Arc<EffectTally>>,
}

impl<'s> SceneFamily<'s> {
    /// The family over the parameter of this name.
    ///
    /// # Errors
    /// An input error if the scene has no such parameter.
    pub fn new(scene: &'s Scene, parameter: &str) -> Result<SceneFamily<'s>> {
        scene.system()?;
        let free = scene.parameter(parameter)?;
        let values = scene.parameters.iter().map(|(_, value)| value.to_f64().unwrap_or(f64::NAN)).collect();
        let mut family = SceneFamily { scene, values, free, fixed: Vec::new(), tally: None };
        let (mut fixed, values) = (Vec::new(), family.duals(family.value()));
        let point = String::new;
        let _ = scene.system()?.try_map(|expression| {
            let alone = !expression.mentions(&|place| place == free);
            // What has no value is left to fail where it is asked for.
            fixed.push(alone.then(|| scene.value(expression, &values, |x| x.value, &point).ok()).flatten());
            Ok::<(), Infallible>(())
        });
        family.fixed = fixed;
        Ok(family)
    }

    /// The same family, the work of its oscillators added up in `tally`.
    #[must_use]
    pub(crate) fn counting(self, tally: Arc<EffectTally>) -> SceneFamily<'s> {
        SceneFamily { tally: Some(tally), ..self }
    }

    /// The parameters' values with their derivatives in the free one.
    fn duals(&self, parameter: f64) -> Vec<Dual> {
        let mut values: Vec<Dual> = self.values.iter().map(|value| Dual::constant(*value)).collect();
        values[self.free] = Dual { value: parameter, slope: 1.0 };
        values
    }

    /// The scene's own value of the parameter.
    pub fn value(&self) -> f64 {
        self.values[self.free]
    }

    /// The system at a value of the parameter, and the derivatives of its coefficients.
    ///
    /// # Errors
    /// A coefficient that has no value there.
    pub(crate) fn systems(&self, parameter: f64) -> Result<[System<f64>; 2]> {
        let values = self.duals(parameter);
        let point = || self.scene.point(&values.iter().map(|value| value.value).collect::<Vec<_>>());
        self.scene.check_signs(&values, |x| x.value, &point)?;
        let mut fixed = self.fixed.iter();
        let mut slopes = Vec::with_capacity(self.fixed.len());
        let system = self.scene.system()?.try_map(|expression| {
            let Dual { value, slope } = match fixed.next() {
                Some(Some(value)) => *value,
                _ => self.scene.value(expression, &values, |x| x.value, &point)?,
            };
            slopes.push(slope);
            Ok::<_, Error>(value)
        })?;
        let mut slopes = slopes.into_iter();
        let slope = system.try_map(|_| Ok::<_, Error>(slopes.next().unwrap_or(0.0)))?;
        Ok([system, slope])
    }
}

impl Family for SceneFamily<'_> {
    /// Derivatives are exact to rounding: every coefficient is evaluated in dual numbers.
    fn at(&self, parameter: f64) -> Result<Oscillator> {
        let [system, slope] = self.systems(parameter)?;
        let oscillator = Oscillator::with_slope(system, &slope, self.scene.accuracy.tolerance)?;
        Ok(match &self.tally {
            Some(tally) => oscillator.counting(tally.clone()),
            None => oscillator,
        })
    }
}

/// The machine of a scene with one parameter free, the others at their values.
#[derive(Debug, Clone)]
pub struct MachineSceneFamily<'s> {
    scene: &'s Scene,
    name: String,
    values: Vec<f64>,
    free: usize,
    tally: Option<Arc<EffectTally>>,
}

impl<'s> MachineSceneFamily<'s> {
    /// The family over the parameter of this name.
    ///
    /// # Errors
    /// An input error if the scene has no such parameter, or no machine.
    pub fn new(scene: &'s Scene, parameter: &str) -> Result<MachineSceneFamily<'s>> {
        scene.machine_scene()?;
        let free = scene.parameter(parameter)?;
        let values = scene.parameters.iter().map(|(_, value)| value.to_f64().unwrap_or(f64::NAN)).collect();
        Ok(MachineSceneFamily { scene, name: parameter.to_string(), values, free, tally: None })
    }

    /// The same family, the work on its machines added up in `tally`.
    #[must_use]
    pub(crate) fn counting(self, tally: Arc<EffectTally>) -> MachineSceneFamily<'s> {
        MachineSceneFamily { tally: Some(tally), ..self }
    }

    /// The scene's own value of the parameter.
    pub fn value(&self) -> f64 {
        self.values[self.free]
    }
}

impl many::Family for MachineSceneFamily<'_> {
    /// Derivatives are exact to rounding: every coefficient is evaluated in dual numbers.
    fn at(&self, parameter: f64) -> Result<(Machine<f64>, Machine<f64>)> {
        let machine = self.scene.machine(&[(&self.name, parameter)])?;
        let mut values: Vec<Dual> = self.values.iter().map(|value| Dual::constant(*value)).collect();
        values[self.free] = Dual { value: parameter, slope: 1.0 };
        let point = || self.scene.point(&values.iter().map(|value| value.value).collect::<Vec<_>>());
        let slope = self.scene.machine_scene()?.machine.try_map(|expression| {
            self.scene.value(expression, &values, |x| x.value, &point).map(|value| value.slope)
        })?;
        Ok((machine, slope))
    }

    fn tally(&self) -> Option<&Arc<EffectTally>> {
        self.tally.as_ref()
    }
}

#[cfg(test)]
mod tests {
    use num_rational::BigRational;

    use super::*;

    /// Coefficients in which the parameter stands, or another, or none; a force; and one that has no value.
    #[test]
    fn what_is_evaluated_once_is_what_would_be_evaluated_again() {
        let text = r#"
format = "grazing-scene 1"
title = "All kinds of coefficients"

[parameters]
a = 0.25
b = 3
c = "1/3"

[system]
damping = "a/7"
stiffness = "b*b"
cubic = "a*c"
force = "1/3"
forcing = [{ k = 1, cos = "c", sin = "a" }, { k = 2, cos = "1/7" }]

[[walls]]
side = "lower"
offset = "-1 - c"
harmonics = [{ k = 1, cos = "b*c" }, { k = 3, sin = "c*a" }]
restitution = "a"

[[walls]]
side = "upper"
offset = "9 + b"
restitution = 0.5
"#;
        let scene = Scene::from_toml(text, "scene.toml").unwrap();
        for (name, fixed) in [("a", 11), ("b", 13), ("c", 11)] {
            let family = SceneFamily::new(&scene, name).unwrap();
            let known = family.fixed.iter().flatten().count();
            assert_eq!(known, fixed, "{name}: {:?}", family.fixed);
            let plain = SceneFamily { fixed: Vec::new(), ..family.clone() };
            for parameter in [0.25, 0.7, 1.0] {
                let (one, other) = (family.at(parameter).unwrap(), plain.at(parameter).unwrap());
                assert_eq!(format!("{one:?}"), format!("{other:?}"));
            }
        }
    }

    /// A parameter set anew can take a coefficient its value.
    #[test]
    fn what_has_no_value_fails_where_it_is_asked_for() {
        let text = "format = \"grazing-scene 1\"\ntitle = \"t\"\n[parameters]\na = 2\nb = 1\n\
                    [system]\nstiffness = \"1/a\"\ndamping = \"b\"\n";
        let mut scene = Scene::from_toml(text, "scene.toml").unwrap();
        scene.parameters[0].1 = BigRational::from_integer(0.into());
        let family = SceneFamily::new(&scene, "b").unwrap();
        let plain = SceneFamily { fixed: Vec::new(), ..family.clone() };
        let [one, other] = [family, plain].map(|family| family.at(2.0).unwrap_err().to_string());
        assert_eq!(one, other);
        assert!(one.contains("divides by zero (with a = 0, b = 2)"), "{one}");
    }
}
