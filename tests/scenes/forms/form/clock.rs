//! An oscillator of period 2π with a clock of its own.

use toml::{Table, Value};

use super::{Form, Level, units::in_units, upgraded::upgraded};
use crate::forms::{report::View, scene::is_machine};

/// In a unit of time that is 1/`time` of it, in which its `period` is as given: a power of two changes no
/// digit.
pub(super) fn clock(
    base: &Table,
    (name, level): (&'static str, Level),
    period: &str,
    time: f64,
) -> Option<Form> {
    if is_machine(base) {
        return None;
    }
    let newer = upgraded(base)?;
    let mut form = Form { level, ..in_units(name, &newer.scene, [1.0, time, 1.0]) };
    // What is not rational a certificate of chaos has between decimals of 12 places.
    if level > Level::Exact {
        form.other.extend(["oscillator", "contraction"]);
    }
    // The names are those of the scene.
    form.view = View { time, ..View::of(base) };
    let system = form.scene["system"].as_table_mut().expect("a table");
    system.insert("period".into(), Value::String(period.into()));
    Some(form)
}
