//! A driven mass between a spring, a damper and a stop, from the few numbers that a reader types: its scene,
//! whose grammar and units read them.

use std::f64::consts::TAU;

use grazing_scenes::{Error, Result, scene::Scene};
use num_traits::ToPrimitive;
use serde_json::{Value, json};

use crate::{
    answer::{Fault, requested},
    motion::{in_unit, quoted, toml},
};

/// Names, what they are, and their units for numbers that have none.
const PARTS: [(&str, &str, &str); 8] = [
    ("m", "mass", "kg"),
    ("k", "stiffness", "N/m"),
    ("c", "damping", "N s/m"),
    ("ζ", "damping ratio", ""),
    ("F", "amplitude of the force", "N"),
    ("f", "its frequency", "Hz"),
    ("gap", "from rest to the stop", "m"),
    ("e", "restitution", ""),
];

/// Of a JSON object of names and texts, as `{"m": "2 kg"}`, the text of the scene: `{"scene"}`. It is driven
/// to nine tenths of what touches, where no force is given.
pub fn machine(named: &str) -> String {
    requested(named, |named| match scene(&named) {
        Ok(scene) => Ok(json!({ "scene": scene })),
        // The reader has seen no file: what is told begins behind its name and line.
        Err(error) => {
            let message = error.to_string();
            let told = message.splitn(3, ':').nth(2).filter(|_| message.starts_with(NAME));
            Err(Fault::new(told.unwrap_or(&message).trim().trim_start_matches("parameters.")))
        }
    })
}

const NAME: &str = "machine.toml:";

fn scene(named: &Value) -> Result<String> {
    let given = |name: &str| named[name].as_str();
    let damping = if given("ζ").is_some() { "ζ" } else { "c" };
    let missing: Vec<&str> =
        ["m", "k", damping, "f", "gap"].into_iter().filter(|name| given(name).is_none()).collect();
    if !missing.is_empty() {
        return Err(Error::input(format!(
            "{}: missing. A machine has its mass m, stiffness k, damping c (or ζ), the frequency f of the drive \
             and its gap.",
            missing.join(", ")
        )));
    }
    let all = named.as_object().into_iter().flatten().map(|(name, _)| name.as_str());
    let other = if damping == "c" { "ζ" } else { "c" };
    if let Some(name) =
        all.into_iter().find(|name| *name == other || PARTS.iter().all(|part| part.0 != *name))
    {
        return Err(Error::input(format!(
            "{name}: a machine has m, k, c or ζ, f, gap, F and e (restitution)"
        )));
    }
    let without = text(named, damping, "1 N");
    let scene = Scene::from_toml(&without, NAME.trim_end_matches(':'))?;
    if given("F").is_some() {
        return Ok(without);
    }
    let value = |name: &str| {
        let value = scene.parameters.iter().find(|known| known.0 == name);
        value.and_then(|known| known.1.to_f64()).unwrap_or(f64::NAN)
    };
    let cycles = scene.unit("f").is_none_or(|unit| unit.dimension.angle == 0);
    let (m, k, w) = (value("m"), value("k"), value("f") * if cycles { TAU } else { 1.0 });
    let c = if damping == "c" { value("c") } else { 2.0 * value("zeta") * (k * m).sqrt() };
    let touch = 0.9 * value("gap") * (k - m * w * w).hypot(c * w);
    Ok(text(named, damping, &format!("{} N", format!("{touch:.2e}").parse::<f64>().unwrap_or(touch))))
}

fn text(named: &Value, damping: &str, force: &str) -> String {
    let line = |(name, about, unit): (&str, &str, &str)| {
        let value = named[name].as_str().or((name == "F").then_some(force))?;
        // What is written without a unit is in SI units.
        let bare = value.chars().all(|c| !c.is_alphabetic() || matches!(c, 'e' | 'E'));
        let value = if bare && !unit.is_empty() { quoted(&in_unit(value, unit)) } else { toml(value) };
        Some(format!("{} = {value}    # {about}\n", if name == "ζ" { "zeta" } else { name }))
    };
    let parameters: String = PARTS.into_iter().filter(|part| part.0 != "e").filter_map(line).collect();
    let restitution = toml(named["e"].as_str().unwrap_or("0.8"));
    let damped = if damping == "c" { "damping = \"c\"" } else { "damping_ratio = \"zeta\"" };
    format!(
        r#"format = "grazing-scene 3"
title = "A driven mass and a stop"

[parameters]
{parameters}
[system]                     # m q'' + c q' + k q = F cos 2πft
frequency = "f"
mass = "m"
{damped}
stiffness = "k"
forcing = [{{ cos = "F" }}]

[[stops]]
side = "upper"
offset = "gap"
restitution = {restitution}

[[tasks]]
name = "first-touch"
kind = "grazing"
parameter = "F"
"#
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ask(named: Value) -> Value {
        serde_json::from_str(&machine(&named.to_string())).unwrap()
    }

    #[test]
    fn a_machine_is_read_in_any_units() {
        let wanted = 0.9 * 0.001 * (800.0 - 2.0 * (4.0 * TAU).powi(2)).hypot(3.0 * 4.0 * TAU);
        for named in [
            json!({ "m": "2 kg", "k": "0.8 kN/m", "c": "3 N s/m", "f": "240 rpm", "gap": "1 mm" }),
            json!({ "m": "2", "k": "800", "c": "3", "f": "4", "gap": "1e-3" }),
            json!({ "m": "2000 g", "k": "800", "c": "3 kg/s", "f": "25.1327412 rad/s", "gap": "1000 µm", "e": "80 %" }),
        ] {
            let text = ask(named);
            let scene = Scene::from_toml(text["scene"].as_str().unwrap(), "s.toml").unwrap();
            let force = scene.parameters.iter().find(|known| known.0 == "F").unwrap().1.to_f64().unwrap();
            assert!((force / wanted - 1.0).abs() < 5e-3, "{force} {wanted}");
            assert_eq!(scene.unit("F").unwrap().own, "N");
        }
        for (name, value, told) in [
            ("m", "2 lb", "m = \"2 lb\": there is no unit \"lb\""),
            ("m", "2 N", "is a force; here stands a mass, in kg or the like"),
            ("f", "4 s", "is a time; here stands a frequency, in Hz or the like"),
            ("ζ", "2 %", "c: a machine has m, k, c or ζ"),
            ("lambda", "2", "lambda: a machine has m, k, c or ζ"),
        ] {
            let mut named =
                json!({ "m": "2 kg", "k": "800 N/m", "c": "3 N s/m", "f": "4 Hz", "gap": "1 mm" });
            named[name] = value.into();
            let found = ask(named);
            let message = found["error"]["message"].as_str().unwrap_or_else(|| panic!("{found}"));
            assert!(message.contains(told) && !message.contains(".toml"), "{message}");
        }
        assert!(
            ask(json!({ "m": "2 kg" }))["error"]["message"]
                .as_str()
                .unwrap()
                .starts_with("k, c, f, gap: missing")
        );
    }
}
