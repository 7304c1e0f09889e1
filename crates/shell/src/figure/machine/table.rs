//! The data beside the picture: every number of the machine, a row each.

use num_traits::Zero;

use super::{
    MachinePicture,
    plan::{BOXES, Names, Plan},
};
use crate::{
    many::{
        NormalForce, StopLaw,
        elements::{Coupling, Elements, Evaluated},
    },
    motion::Harmonic,
};

pub(super) const COLUMNS: [&str; 9] =
    ["kind", "name", "from", "to", "quantity", "k", "value", "dimension", "drawn"];

struct Table<'a> {
    rows: Vec<Vec<String>>,
    names: &'a Names,
}

impl Table<'_> {
    fn row(&mut self, cells: [&str; 9]) {
        self.rows.push(cells.map(str::to_string).to_vec());
    }

    /// A number of something that has a name and is drawn as a whole.
    fn number(&mut self, [kind, name, quantity, dimension]: [&str; 4], from: &str, k: u32, x: &Evaluated) {
        let k = if k == 0 { String::new() } else { k.to_string() };
        let value = format!("{:?}", x.float());
        self.row([kind, name, from, "", quantity, &k, &value, dimension, "yes"]);
    }

    fn couplings(&mut self, kind: &str, dimension: &str, all: &[Coupling], modal: bool) {
        for one in all {
            let from = self.names.inner(one.first);
            let to = one.second.map_or("ground".to_string(), |second| self.names.inner(second));
            let to = if kind == "mass" { String::new() } else { to };
            let value = Evaluated { value: one.value.clone(), exact: true }.float();
            let drawn = match (modal, one.rounding, one.first.max(one.second.unwrap_or(0)) < BOXES) {
                (true, ..) => "in words",
                (_, true, _) => "no: rounding",
                (_, _, false) => "no: too many",
                _ => "yes",
            };
            self.row([kind, "", &from, &to, "", "", &format!("{value:?}"), dimension, drawn]);
        }
    }

    fn harmonics(&mut self, kind: &str, name: &str, all: &[Harmonic<Evaluated>], dimension: &str) {
        for h in all {
            self.number([kind, name, "cos", dimension], "", h.k, &h.cos);
            self.number([kind, name, "sin", dimension], "", h.k, &h.sin);
        }
    }

    fn row_of(&mut self, kind: &str, name: &str, row: &[Evaluated]) {
        for (i, x) in row.iter().enumerate().filter(|(_, x)| !x.value.is_zero()) {
            let from = self.names.point(i);
            self.number([kind, name, "row", "1"], &from, 0, x);
        }
    }
}

/// All rows, in the order of [`COLUMNS`].
pub(super) fn rows(
    picture: &MachinePicture,
    elements: &Elements,
    names: &Names,
    plan: &Plan,
    remarks: &[String],
) -> Vec<Vec<String>> {
    let machine = &picture.written.machine;
    let mut table = Table { rows: Vec::new(), names };
    table.number(["period", "", "", "time"], "", 0, &machine.period);
    let modal = !machine.shapes.is_empty();
    let (own, shared): (Vec<_>, Vec<_>) =
        elements.masses.iter().cloned().partition(|one| one.second.is_none());
    for (kind, dimension, all) in [
        ("mass", "mass", &own),
        ("shared inertia", "mass", &shared),
        ("spring", "force/length", &elements.springs.links),
        ("damper", "force time/length", &elements.dampers.links),
        ("circulatory", "force/length", &elements.springs.skew),
        ("gyroscopic", "force time/length", &elements.dampers.skew),
    ] {
        table.couplings(kind, dimension, all, modal);
    }
    for (i, ratio) in machine.damping_ratio.iter().enumerate() {
        let of =
            if machine.damping_ratio.len() == 1 { "all modes".into() } else { format!("mode {}", i + 1) };
        table.number(["damping ratio", "", "", "1"], &of, 0, ratio);
    }
    for (i, row) in machine.shapes.iter().enumerate() {
        for (j, x) in row.iter().enumerate() {
            let (from, to) = (names.point(i), names.inner(j));
            let value = format!("{:?}", x.float());
            table.row(["shape", "", &from, &to, "", "", &value, "mass^(-1/2)", "in words"]);
        }
    }
    for (i, x) in machine.force.iter().enumerate().filter(|(_, x)| !x.value.is_zero()) {
        table.number(["force", "", "", "force"], &names.point(i), 0, x);
    }
    for load in &machine.forcing {
        for (quantity, all) in [("cos", &load.cos), ("sin", &load.sin)] {
            for (i, x) in all.iter().enumerate().filter(|(_, x)| !x.value.is_zero()) {
                table.number(["drive", "", quantity, "force"], &names.point(i), load.k, x);
            }
        }
    }
    if let Some((_, direction)) = &machine.record {
        for (i, x) in direction.iter().enumerate() {
            table.number(["record", "", "factor", "1"], &names.point(i), 0, x);
        }
    }
    if let Some(file) = &picture.written.measured {
        table.row(["measured", "", "", "", "file", "", file, "", "in words"]);
    }
    for (number, (on, text)) in (1..).zip(&plan.formulas) {
        let name = format!("f{number}");
        table.row(["formula", &name, &names.point(*on), "", "", "", text, "force", "yes"]);
    }
    for stop in &machine.stops {
        let name = stop.name.as_str();
        table.row_of("stop", name, &stop.row);
        table.number(["stop", name, "offset", "length"], "", 0, &stop.wall.offset);
        table.harmonics("stop", name, &stop.wall.harmonics, "length");
        match &stop.law {
            StopLaw::Soft { stiffness, damping } => {
                table.number(["stop", name, "stiffness", "force/length"], "", 0, stiffness);
                table.number(["stop", name, "damping", "force time/length"], "", 0, damping);
            }
            StopLaw::Speed(law) => {
                table.row(["stop", name, "", "", "restitution", "", &law.text, "1", "in words"]);
            }
            StopLaw::Formula(law) => {
                table.row(["stop", name, "", "", "law", "", law.text(), "force", "in words"]);
            }
            _ => table.number(["stop", name, "restitution", "1"], "", 0, &stop.wall.restitution),
        }
    }
    for rub in &machine.friction {
        let name = rub.name.as_str();
        table.row_of("friction", name, &rub.row);
        match &rub.normal {
            NormalForce::Given(force) => table.number(["friction", name, "normal", "force"], "", 0, force),
            NormalForce::Stop { stop } => {
                let stop = machine.stops.get(*stop).map_or("", |stop| &stop.name);
                table.row(["friction", name, "", "", "stop", "", stop, "", "in words"]);
            }
        }
        match &rub.law {
            Some(law) => {
                table.row(["friction", name, "", "", "coefficient", "", law.text(), "1", "in words"])
            }
            None => table.number(["friction", name, "coefficient", "1"], "", 0, &rub.coefficient),
        }
        if rub.law.is_none() || !rub.static_coefficient.value.is_zero() {
            table.number(["friction", name, "static_coefficient", "1"], "", 0, &rub.static_coefficient);
        }
        table.number(["friction", name, "speed", "length/time"], "", 0, &rub.speed);
        table.harmonics("friction", name, &rub.harmonics, "length");
    }
    for remark in remarks {
        table.row(["remark", "", "", "", "", "", remark, "", "in words"]);
    }
    table.rows
}
