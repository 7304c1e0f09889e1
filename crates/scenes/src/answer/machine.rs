//! A driven mass between a spring, a damper and a stop, from the few numbers that somebody types, as `m = 2
//! kg, k = 800 N/m, c = 3 N s/m, f = 4 Hz, gap = 10 mm, e = 0.6`: its scene, whose grammar and units read
//! them.

use std::f64::consts::TAU;

use num_traits::{Signed, ToPrimitive};

use crate::{
    error::{Error, Result},
    scene::Scene,
};

/// A number that a machine has.
struct Part {
    /// What it is called in the sentence.
    name: &'static str,
    /// And in the scene.
    key: &'static str,
    /// Other names.
    also: &'static [&'static str],
    /// What it is.
    about: &'static str,
    /// What it is in where no unit is written.
    unit: &'static str,
}

const fn part(
    name: &'static str,
    key: &'static str,
    also: &'static [&'static str],
    about: &'static str,
    unit: &'static str,
) -> Part {
    Part { name, key, also, about, unit }
}

const PARTS: [Part; 8] = [
    part("m", "m", &["mass"], "mass", "kg"),
    part("k", "k", &["stiffness"], "stiffness", "N/m"),
    part("c", "c", &["damping"], "damping", "N s/m"),
    part("ζ", "zeta", &["zeta", "ratio"], "damping ratio", ""),
    part("F", "F", &["force"], "amplitude of the force", "N"),
    part("f", "f", &["frequency", "drive"], "its frequency", "Hz"),
    part("gap", "gap", &["g", "offset", "stop"], "from rest to the stop", "m"),
    part("e", "e", &["restitution"], "restitution", ""),
];

/// What a machine has, as it is said where something is missing.
const ALL: &str = "a machine has its mass m, stiffness k, damping c (or ζ), the frequency f of the drive and its gap, and if \
                   you like the amplitude F of the force and the restitution e";

/// What the restitution is where none is typed.
const RESTITUTION: &str = "0.8";

/// The part of the touch's force that drives a machine for which none is typed: the motion without impacts is
/// there, and clear of the stop.
const DRIVEN: f64 = 0.9;

/// What errors of the scene begin with, which nobody has seen.
const FILE: &str = "machine.toml";

/// Whether a text is such a machine: names and numbers, and not the name of a file or a scene.
pub fn is_machine(text: &str) -> bool {
    let known = |sign: char| {
        let names = text.match_indices(sign).map(|(at, _)| name_before(text, at));
        names.filter(|name| PARTS.iter().any(|part| part.is(name))).count()
    };
    // A single colon may stand in the name of a file.
    !text.contains('[') && (known('=') > 0 || known(':') > 1)
}

/// The scene of a machine, with a task of kind `grazing` over the force; where no force is typed, of the
/// force that is nine tenths of what touches.
///
/// # Errors
/// An input error that names what is missing, what is none of a machine's numbers, or what is wrong with one.
pub fn scene_of(text: &str) -> Result<String> {
    let given = parts(&text.replace('\u{2212}', "-"))?;
    let has = |name: &str| given.iter().any(|(part, _)| part.name == name);
    if has("c") && has("ζ") {
        return Err(Error::input("c and ζ say the same of a machine: leave one out"));
    }
    let damping = if has("ζ") { "ζ" } else { "c" };
    let missing: Vec<&str> = ["m", "k", damping, "f", "gap"].into_iter().filter(|name| !has(name)).collect();
    if !missing.is_empty() {
        return Err(Error::input(format!("{}: missing; {ALL}", missing.join(", "))));
    }
    let without = written(&given, "1 N");
    let scene = Scene::from_toml(&without, FILE).map_err(|error| unfiled(&error))?;
    let exact = |name: &str| scene.parameters.iter().find(|known| known.0 == name).map(|known| &known.1);
    for (name, what) in [("gap", "the way from rest to the stop"), ("F", "what drives it")] {
        if let Some(value) = exact(name).filter(|value| !value.is_positive()) {
            return Err(Error::input(format!("{name} = {value}: {what} is above 0")));
        }
    }
    if has("F") {
        return Ok(without);
    }
    let value = |name: &str| exact(name).and_then(ToPrimitive::to_f64).unwrap_or(f64::NAN);
    // An angle over a time is one as it stands.
    let cycles = scene.unit("f").is_none_or(|unit| unit.dimension.angle == 0);
    let (m, k, w) = (value("m"), value("k"), value("f") * if cycles { TAU } else { 1.0 });
    let c = if damping == "c" { value("c") } else { 2.0 * value("zeta") * (k * m).sqrt() };
    let force = format!("{:.2e}", DRIVEN * value("gap") * (k - m * w * w).hypot(c * w));
    let force = force.parse::<f64>().map_or(force, |short| short.to_string());
    Ok(written(&given, &format!("{force} N")))
}

/// What is wrong, without the name and the line of a file.
fn unfiled(error: &Error) -> Error {
    let message = error.to_string();
    let behind = message.strip_prefix(FILE).and_then(|rest| rest.splitn(3, ':').nth(2));
    let told = behind.unwrap_or(&message).trim();
    Error::input(told.trim_start_matches("parameters."))
}

impl Part {
    fn is(&self, name: &str) -> bool {
        self.name == name || self.also.contains(&name)
    }
}

/// The word that ends before a place.
fn name_before(text: &str, at: usize) -> &str {
    let head = text[..at].trim_end();
    let word = |c: char| c.is_alphanumeric() || c == '_';
    let begin = head.char_indices().rev().take_while(|(_, c)| word(*c)).last();
    &head[begin.map_or(head.len(), |(begin, _)| begin)..]
}

/// The parts of a machine and their values, in the order in which they are typed.
fn parts(text: &str) -> Result<Vec<(&'static Part, String)>> {
    let space = |c: char| c.is_whitespace() || c == ',' || c == ';';
    let marks: Vec<usize> = text.match_indices(['=', ':']).map(|(at, _)| at).collect();
    let begin = |at: usize| text[..at].trim_end().len() - name_before(text, at).len();
    let left = text[..marks.first().map_or(text.len(), |at| begin(*at))].trim_matches(space);
    if !left.is_empty() {
        return Err(not_understood(left));
    }
    let mut found: Vec<(&Part, String)> = Vec::new();
    for (i, &at) in marks.iter().enumerate() {
        let name = name_before(text, at);
        let value =
            text[at + 1..marks.get(i + 1).map_or(text.len(), |next| begin(*next))].trim_matches(space);
        let part = PARTS.iter().find(|part| part.is(name));
        let part = part.ok_or_else(|| Error::input(format!("{name}: unknown; {ALL}")))?;
        if value.is_empty() || value.contains([',', ';', '\n']) {
            return Err(not_understood(&format!("{name} = {value}")));
        }
        if found.iter().any(|known| known.0.name == part.name) {
            return Err(Error::input(format!("{name} = {value}: {} is given twice", part.name)));
        }
        found.push((part, value.to_string()));
    }
    Ok(found)
}

fn not_understood(text: &str) -> Error {
    Error::input(format!(
        "\u{201c}{text}\u{201d} is not understood: write each as name = number unit, and decimals with a point, as in m = 2.5 kg"
    ))
}

/// A value as TOML has it: text, in a unit.
fn quoted(value: &str, unit: &str) -> String {
    let text = |value: &str| toml_edit::Value::from(value).to_string().trim().to_string();
    // What is written without a unit is in SI units.
    let bare = value.chars().all(|c| !c.is_alphabetic() || matches!(c, 'e' | 'E')) && !value.contains('%');
    if !bare || unit.is_empty() {
        return text(value);
    }
    let plain = value.chars().all(|c| c.is_ascii_digit() || matches!(c, '.' | '-'));
    text(&if plain { format!("{value} {unit}") } else { format!("({value}) {unit}") })
}

fn written(given: &[(&Part, String)], force: &str) -> String {
    let value = |part: &Part| given.iter().find(|known| known.0.name == part.name).map(|known| &*known.1);
    let line = |part: &Part| {
        let (value, about) = match (value(part), part.name) {
            (Some(value), _) => (value, part.about.to_string()),
            (None, "F") => (force, format!("{}: nine tenths of what touches", part.about)),
            (None, "e") => (RESTITUTION, format!("{}: none was given", part.about)),
            _ => return None,
        };
        Some(format!("{} = {}    # {about}\n", part.key, quoted(value, part.unit)))
    };
    let parameters: String = PARTS.iter().filter_map(line).collect();
    let is_ratio = given.iter().any(|known| known.0.name == "ζ");
    let damped = if is_ratio { "damping_ratio = \"zeta\"" } else { "damping = \"c\"" };
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
restitution = "e"

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

    #[test]
    fn a_machine_is_read_in_any_units() {
        let wanted = 0.9 * 0.001 * (800.0 - 2.0 * (4.0 * TAU).powi(2)).hypot(3.0 * 4.0 * TAU);
        for text in [
            "m = 2 kg, k = 0.8 kN/m, c = 3 N s/m, f = 240 rpm, gap = 1 mm",
            "m=2;k=800;c=3;f=4;gap=1e-3",
            "mass: 2000 g k: 800 damping: 3 kg/s frequency: 25.1327412 rad/s stop: 1000 µm e: 80 %",
        ] {
            assert!(is_machine(text), "{text}");
            let scene = Scene::from_toml(&scene_of(text).unwrap(), "s.toml").unwrap();
            let force = scene.parameters.iter().find(|known| known.0 == "F").unwrap().1.to_f64().unwrap();
            assert!((force / wanted - 1.0).abs() < 5e-3, "{force} {wanted}");
            assert_eq!(scene.unit("F").unwrap().own, "N");
        }
        // By its damping ratio, 3/(2 √1600), with a minus that is none of ASCII.
        let text = scene_of("m = 2, k = 800, ζ = 3.75 %, f = 4, gap = 1e\u{2212}3").unwrap();
        let scene = Scene::from_toml(&text, "s.toml").unwrap();
        let force = scene.parameters.iter().find(|known| known.0 == "F").unwrap().1.to_f64().unwrap();
        assert!((force / wanted - 1.0).abs() < 5e-3, "{force} {wanted}");
    }

    #[test]
    fn what_is_wrong_is_told_by_its_name() {
        for (text, told) in [
            ("m = 2 lb", "m = \"2 lb\": there is no unit \"lb\""),
            ("m = 2 N", "is a force; here stands a mass, in kg or the like"),
            ("m = 2,5 kg", "decimals with a point"),
            ("m = 2 kg, m = 3 kg", "m is given twice"),
            ("a big m = 2 kg", "“a big” is not understood"),
            ("m = 2 kg, ζ = 2 %", "c and ζ say the same"),
            ("m = 2 kg, lambda = 2", "lambda: unknown; a machine has its mass m"),
            ("m =", "“m = ” is not understood"),
            ("m = 2, F = 0 N", "F = 0: what drives it is above 0"),
            ("", "m: missing; a machine has"),
        ] {
            let text = format!("{text}, k = 800 N/m, c = 3 N s/m, f = 4 Hz, gap = 1 mm");
            let message = scene_of(&text).unwrap_err().to_string();
            assert!(message.contains(told) && !message.contains(".toml"), "{text}: {message}");
        }
        let message = scene_of("m = 2 kg, k = 800 N/m, c = 3 N s/m, f = 4 Hz, gap = -1 mm").unwrap_err();
        assert!(message.to_string().contains("the way from rest to the stop is above 0"), "{message}");
        let message = scene_of("m = 2 kg, k = 800 N/m, c = 3 N s/m, f = 4 s, gap = 1 mm").unwrap_err();
        assert!(message.to_string().contains("is a time; here stands a frequency, in Hz"), "{message}");
        assert!(scene_of("m = 2 kg").unwrap_err().to_string().starts_with("k, c, f, gap: missing"));
        assert!(is_machine("m = 2 kg"));
        for text in ["machine.toml", "c:\\machine.toml", "[parameters]\nm = 2\nk = 3", "a1 = 1, a2 = 2"] {
            assert!(!is_machine(text), "{text}");
        }
    }
}
