//! The oscillators of a scene as one of its parameters varies.

use num_traits::ToPrimitive;

use super::scene::Scene;

use crate::{
    error::Result,
    machine::{Machine, MachineFamily},
    number::Dual,
    oscillator::{
        System,
        orbit::{Family, Oscillator},
    },
};

/// A scene with one parameter free, the others at their values.
#[derive(Debug, Clone)]
pub struct SceneFamily<'s> {
    scene: &'s Scene,
    values: Vec<f64>,
    free: usize,
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
        Ok(SceneFamily { scene, values, free })
    }

    /// The scene's own value of the parameter.
    pub fn value(&self) -> f64 {
        self.values[self.free]
    }
}

impl Family for SceneFamily<'_> {
    /// Derivatives are exact to rounding: every coefficient is evaluated in dual numbers.
    fn at(&self, parameter: f64) -> Result<Oscillator> {
        let mut values: Vec<Dual> = self.values.iter().map(|value| Dual::constant(*value)).collect();
        values[self.free] = Dual { value: parameter, slope: 1.0 };
        let point = || self.scene.point(&values.iter().map(|value| value.value).collect::<Vec<_>>());
        let dual = self
            .scene
            .system()?
            .try_map(|expression| self.scene.value(expression, &values, |x| x.value, &point))?;
        let part = |part: fn(&Dual) -> f64| -> Result<System<f64>> { dual.try_map(|x| Ok(part(x))) };
        Oscillator::with_slope(part(|x| x.value)?, &part(|x| x.slope)?, self.scene.accuracy.tolerance)
    }
}

/// The machine of a scene with one parameter free, the others at their values.
#[derive(Debug, Clone)]
pub struct MachineSceneFamily<'s> {
    scene: &'s Scene,
    name: String,
    values: Vec<f64>,
    free: usize,
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
        Ok(MachineSceneFamily { scene, name: parameter.to_string(), values, free })
    }

    /// The scene's own value of the parameter.
    pub fn value(&self) -> f64 {
        self.values[self.free]
    }
}

impl MachineFamily for MachineSceneFamily<'_> {
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
}
