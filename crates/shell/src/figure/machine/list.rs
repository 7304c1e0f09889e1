//! What is said below the drawing: stops, friction, formulas, modes, what is not drawn.

use num_traits::Zero;

use super::{
    MachinePicture,
    plan::{Names, Plan, harmonic},
};
use crate::{
    many::{
        Friction, NormalForce, Stop, StopLaw,
        elements::{Evaluated, Short},
    },
    motion::Harmonic,
};

/// Most modes of which the frequency is said.
const MODES: usize = 12;

/// A row times the coordinates, and a factor.
fn combination(row: &[Evaluated], factor: f64, names: &Names) -> String {
    let mut all = String::new();
    for (i, x) in row.iter().enumerate().filter(|(_, x)| !x.value.is_zero()) {
        let x = x.float() * factor;
        let sign = match (all.is_empty(), x < 0.0) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        let factor = if x.abs() == 1.0 { String::new() } else { format!("{} ", Short(x.abs())) };
        all += &format!("{sign}{factor}{}", names.point(i));
    }
    all
}

/// Where a wall or a surface is, times a factor.
fn place(offset: f64, harmonics: &[Harmonic<Evaluated>], factor: f64) -> String {
    let some = |x: &Evaluated| (!x.value.is_zero()).then(|| x.float() * factor);
    let moved = harmonics.iter().filter_map(|h| harmonic(h.k, some(&h.cos), some(&h.sin)));
    let mean = (offset != 0.0 || harmonics.is_empty()).then(|| Short(offset * factor).to_string());
    let terms: Vec<String> = mean.into_iter().chain(moved).collect();
    terms.join(" + ").replace("+ -", "- ")
}

fn stop(stop: &Stop<Evaluated>, names: &Names) -> String {
    let number = |x: &Evaluated| Short(x.float()).to_string();
    let law = match &stop.law {
        StopLaw::Newton => format!("rigid, restitution {}", number(&stop.wall.restitution)),
        StopLaw::Speed(law) => format!("rigid, restitution {} of the speed v", law.text),
        StopLaw::Soft { stiffness, damping } => {
            format!("compliant, stiffness {}, damping {}", number(stiffness), number(damping))
        }
        StopLaw::Formula(law) => format!("pushes by {} of the depth d and its speed v", law.text()),
        _ => "of another law".to_string(),
    };
    let closing = stop.row.iter().enumerate().filter(|(_, x)| !x.value.is_zero()).map(|(i, x)| {
        let way = if x.float() > 0.0 { "falls" } else { "rises" };
        format!("{} {way}", names.point(i))
    });
    let closing: Vec<String> = closing.collect();
    let offset = stop.wall.offset.float();
    // Of one coordinate its own place; of several the first with a plus.
    let first = stop.row.iter().map(Evaluated::float).find(|x| *x != 0.0).unwrap_or(1.0);
    let alone = stop.row.iter().filter(|x| !x.value.is_zero()).count() == 1;
    let factor = if alone { 1.0 / first } else { first.signum() };
    let behind = if offset > 0.0 && stop.wall.harmonics.is_empty() { "; q = 0 is behind it" } else { "" };
    format!(
        "{}: {law}; closes as {}, at {} = {}{behind}",
        stop.name,
        closing.join(" or "),
        combination(&stop.row, factor, names),
        place(offset, &stop.wall.harmonics, factor),
    )
}

fn friction(rub: &Friction<Evaluated>, stops: &[Stop<Evaluated>], names: &Names) -> String {
    let force = |coefficient: &Evaluated| match &rub.normal {
        NormalForce::Given(normal) => Short(normal.float() * coefficient.float()).to_string(),
        NormalForce::Stop { stop } => {
            let name = stops.get(*stop).map_or("a stop", |stop| &stop.name);
            format!("{} of {name}'s force", Short(coefficient.float()))
        }
    };
    let sliding = match (&rub.law, &rub.normal) {
        (Some(law), NormalForce::Given(normal)) => format!("{} of {}", law.text(), Short(normal.float())),
        _ => force(&rub.coefficient),
    };
    let sticking = match &rub.law {
        Some(_) if rub.static_coefficient.value.is_zero() => "that of v = 0".to_string(),
        _ => force(&rub.static_coefficient),
    };
    let speed = match rub.speed.value.is_zero() {
        true => String::new(),
        false => format!("; the surface runs at {}", Short(rub.speed.float())),
    };
    let moves = match rub.harmonics.is_empty() {
        true => String::new(),
        false => format!("; it vibrates by {}", place(0.0, &rub.harmonics, 1.0)),
    };
    format!(
        "{}: dry friction along {}, {sliding} sliding, up to {sticking} sticking{speed}{moves}",
        rub.name,
        combination(&rub.row, 1.0, names),
    )
}

/// A list of numbers, or the one that all are.
fn ratios(all: &[Evaluated]) -> String {
    let texts: Vec<String> = all.iter().take(MODES).map(|x| Short(x.float()).to_string()).collect();
    let more = if all.len() > MODES { ", …" } else { "" };
    format!("{}{more}", texts.join(", "))
}

/// The lines.
pub(super) fn lines(picture: &MachinePicture, names: &Names, plan: &Plan) -> Vec<String> {
    let machine = &picture.written.machine;
    let mut all = Vec::new();
    let moves = machine.stops.iter().any(|stop| !stop.wall.harmonics.is_empty());
    if !machine.forcing.is_empty() || moves {
        all.push(format!("Ω = 2π/T, T = {}", Short(machine.period.float())));
    }
    if let Some(file) = &picture.written.measured {
        all.push(format!("the force is measured: {file}"));
    }
    if !machine.shapes.is_empty() {
        let pairs = machine.stiffness.iter().filter(|(i, j, _)| i == j);
        let frequencies: Vec<String> = pairs
            .clone()
            .take(MODES)
            .map(|(_, _, k)| Short(k.float().sqrt() / std::f64::consts::TAU).to_string())
            .collect();
        let more = if pairs.count() > MODES { ", …" } else { "" };
        all.push(format!("frequencies of the modes: {}{more}", frequencies.join(", ")));
    }
    if !machine.damping_ratio.is_empty() {
        all.push(format!("damping ratios of the modes: {}", ratios(&machine.damping_ratio)));
    }
    all.extend(machine.stops.iter().map(|one| stop(one, names)));
    all.extend(machine.friction.iter().map(|rub| friction(rub, &machine.stops, names)));
    let mut used: Vec<&(String, f64)> = Vec::new();
    for (number, (on, text)) in (1..).zip(&plan.formulas) {
        all.push(format!("f{number} on {}: {text}", names.point(*on)));
        let word = |c: char| c.is_alphanumeric() || c == '_';
        for parameter in &picture.parameters {
            if text.split(|c| !word(c)).any(|name| name == parameter.0) && !used.contains(&parameter) {
                used.push(parameter);
            }
        }
    }
    if !used.is_empty() {
        let values: Vec<String> =
            used.iter().map(|(name, value)| format!("{name} = {}", Short(*value))).collect();
        all.push(format!("with {}", values.join(", ")));
    }
    all.extend(plan.left_out.iter().map(|what| format!("not drawn, but in the data: {what}")));
    all
}
