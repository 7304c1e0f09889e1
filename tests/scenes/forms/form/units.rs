//! Lengths, times and masses in other units.

use toml::{Table, Value};

use super::{Form, Level, form};
use crate::forms::scene::{What, each_number, exact, is_machine, renamed, substituted};

/// Powers of two change no digit: all is the same to the last bit.
pub(super) fn units(name: &'static str, base: &Table, [length, time, mass]: [f64; 3]) -> Option<Form> {
    // A record has its own times.
    let has = is_machine(base) && base["system"].get("measured").is_none();
    (has || (time, mass) == (1.0, 1.0)).then(|| in_units(name, base, [length, time, mass]))
}

/// The same whatever its period is then.
pub(super) fn in_units(name: &'static str, base: &Table, [length, time, mass]: [f64; 3]) -> Form {
    let modal = base["system"].get("modes").is_some();
    let mass = if modal { 1.0 } else { mass };
    let mut form = form(name, Level::Exact, base);
    each_number(&mut form.scene, &mut |mut slot| {
        let unit = slot.unit;
        let factor = length.powi(unit.0) * time.powi(unit.1) * mass.powi(unit.2);
        match slot.what {
            // In the variables of the other unit.
            What::Formula => {
                let (q, u) = (exact(1.0 / length), exact(time / length));
                let inner =
                    substituted(&slot.text(), &format!("({{}}*({q}))"), &format!("({{}}*({u}))"), "t");
                *slot.value = Value::String(format!("({})*({inner})", exact(factor)));
            }
            What::Law => {
                let (d, v) = (exact(1.0 / length), exact(time / length));
                let inner = renamed(&slot.text(), &|name| match name {
                    "d" => Some(format!("(d*({d}))")),
                    "v" => Some(format!("(v*({v}))")),
                    _ => None,
                });
                *slot.value = Value::String(format!("({})*({inner})", exact(factor)));
            }
            What::Restitution => {
                let speed = exact(time / length);
                let law = renamed(&slot.text(), &|name| (name == "v").then(|| format!("(v*({speed}))")));
                if slot.value.is_str() {
                    *slot.value = Value::String(law);
                }
            }
            _ => slot.scale(factor),
        }
    });
    (form.view.length, form.view.time, form.view.mass) = (length, time, mass);
    // Orbits that are born begin at the middle of an enclosure of the map's solution, whose width is in the
    // map's own units, and proofs in boxes of floats with decimals: Newton's method ends an ulp away.
    form.rounded = &["grazing.born", "validate"];
    form.other.push("coefficient");
    form
}
