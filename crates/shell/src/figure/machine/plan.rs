//! What stands where: boxes in a row, and what is between them, on the ground or below.

use num_traits::{Signed, Zero};

use super::MachinePicture;
use crate::{
    many::{
        Machine, Stop, StopLaw,
        elements::{Coupling, Elements, Evaluated, Short},
    },
    motion::SmoothForce,
};

/// Most boxes in the row, and most that stands in one place.
pub(super) const BOXES: usize = 12;
const LANES: usize = 16;
/// Most harmonics that stand over a box.
const HARMONICS: usize = 3;

/// What coordinates are called.
pub(super) struct Names {
    points: usize,
    modal: bool,
}

impl Names {
    pub fn of(machine: &Machine<Evaluated>) -> Names {
        Names { points: machine.points(), modal: !machine.shapes.is_empty() }
    }

    /// A coordinate of forces and stops.
    pub fn point(&self, i: usize) -> String {
        if self.points == 1 { "q".to_string() } else { format!("q{}", i + 1) }
    }

    /// A coordinate of the matrices.
    pub fn inner(&self, i: usize) -> String {
        if self.modal { format!("mode {}", i + 1) } else { self.point(i) }
    }
}

/// A symbol.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Mark {
    Spring,
    Damper,
    /// A force that is a formula.
    Formula,
    /// An inertia that two coordinates share.
    Inertia,
    /// What is not symmetric.
    Skew,
    /// The modes that make a coordinate.
    Modes,
    Stop {
        soft: bool,
        damped: bool,
        moving: bool,
    },
    /// A stop between two masses that meets when they part.
    Strap {
        soft: bool,
        damped: bool,
    },
    /// A stop of any other row.
    Lever {
        soft: bool,
    },
    /// Friction that is not that of one coordinate on the ground.
    Rub,
}

/// Where it stands.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Ends {
    /// Between a box and the ground.
    Ground { at: usize, left: bool },
    /// Between two, the one of the smaller number first.
    Pair(usize, usize),
    /// At several.
    Many(Vec<usize>),
}

/// One thing drawn.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Item {
    pub mark: Mark,
    pub ends: Ends,
    pub label: String,
    /// Whether it is to be seen at once.
    pub wrong: bool,
}

/// A force over a box: how its arrow points, 0 to and fro, and its text.
pub(super) type Arrow = (i8, String);

/// A mass, or a point of a machine of modes.
pub(super) struct MassBox {
    pub lines: Vec<String>,
    pub above: Vec<Arrow>,
    /// The friction on the ground: its text, and which way a belt runs, if it does.
    pub below: Vec<(String, i8)>,
}

/// All of the picture but its places.
pub(super) struct Plan {
    pub boxes: Vec<MassBox>,
    pub items: Vec<Item>,
    /// What is not drawn, by kind.
    pub left_out: Vec<String>,
    /// The formulas, with the coordinate on which each acts.
    pub formulas: Vec<(usize, String)>,
}

/// The entries of a row that are not 0.
fn taken(row: &[Evaluated]) -> Vec<usize> {
    (0..row.len()).filter(|&i| !row[i].value.is_zero()).collect()
}

impl Plan {
    pub fn of(picture: &MachinePicture, elements: &Elements, names: &Names) -> Plan {
        let machine = &picture.written.machine;
        let mut plan =
            Plan { boxes: Vec::new(), items: Vec::new(), left_out: Vec::new(), formulas: Vec::new() };
        plan.boxes = (0..machine.points()).map(|i| plan.mass_box(picture, elements, names, i)).collect();
        if machine.shapes.is_empty() {
            plan.couplings(elements);
        } else {
            let count = machine.size;
            let label = if count == 1 { "1 mode".to_string() } else { format!("{count} modes") };
            let one = |at| Item {
                mark: Mark::Modes,
                ends: Ends::Ground { at, left: true },
                label: label.clone(),
                wrong: false,
            };
            plan.items.extend((0..machine.points()).map(one));
        }
        plan.smooth(picture);
        plan.items.extend(machine.stops.iter().filter_map(stop));
        for rub in &machine.friction {
            let at = taken(&rub.row);
            let ends = match at[..] {
                [] | [_] => continue,
                [i, j] => Ends::Pair(i, j),
                _ => Ends::Many(at),
            };
            plan.items.push(Item { mark: Mark::Rub, ends, label: rub.name.clone(), wrong: false });
        }
        plan.limit(names);
        plan
    }

    fn mass_box(&self, picture: &MachinePicture, elements: &Elements, names: &Names, i: usize) -> MassBox {
        let machine = &picture.written.machine;
        let mut lines = vec![format!("{} →", names.point(i))];
        if machine.shapes.is_empty() {
            let own = elements.masses.iter().find(|one| one.first == i && one.second.is_none());
            let mass = own.map_or(0.0, |one| Evaluated { value: one.value.clone(), exact: true }.float());
            lines.push(format!("m = {}", Short(mass)));
        }
        let mut above = Vec::new();
        if let Some((_, direction)) = &machine.record
            && let Some(factor) = direction.get(i).filter(|factor| !factor.value.is_zero())
        {
            above.push((0, format!("{} · record", Short(factor.float()))));
        }
        let at = |all: &[Evaluated]| all.get(i).filter(|one| !one.value.is_zero()).map(Evaluated::float);
        if let Some(constant) = at(&machine.force) {
            above.push((if constant < 0.0 { -1 } else { 1 }, Short(constant.abs()).to_string()));
        }
        let harmonics: Vec<String> = machine
            .forcing
            .iter()
            .filter_map(|load| harmonic(load.k, at(&load.cos), at(&load.sin)))
            .collect();
        above.extend(harmonics.iter().take(HARMONICS).map(|text| (0, text.clone())));
        if harmonics.len() > HARMONICS {
            above.push((0, format!("… {} more harmonics", harmonics.len() - HARMONICS)));
        }
        let rubs = machine.friction.iter().filter(|rub| taken(&rub.row) == [i]);
        let below = rubs.map(|rub| {
            let along = rub.row[i].float();
            let speed = rub.speed.float() / along;
            let text = match speed == 0.0 {
                true => rub.name.clone(),
                false => format!("{}, speed {}", rub.name, Short(speed)),
            };
            (
                text,
                if speed == 0.0 {
                    0
                } else if speed > 0.0 {
                    1
                } else {
                    -1
                },
            )
        });
        MassBox { lines, above, below: below.collect() }
    }

    /// Springs, dampers, shared inertias and what is not symmetric.
    fn couplings(&mut self, elements: &Elements) {
        let ends = |one: &Coupling| match one.second {
            None => Ends::Ground { at: one.first, left: true },
            Some(second) => Ends::Pair(one.first, second),
        };
        let value = |one: &Coupling| Short(Evaluated { value: one.value.clone(), exact: true }.float());
        let all = [
            (Mark::Spring, "k", &elements.springs.links),
            (Mark::Damper, "c", &elements.dampers.links),
            (Mark::Skew, "K skew", &elements.springs.skew),
            (Mark::Skew, "C skew", &elements.dampers.skew),
        ];
        for (mark, letter, couplings) in all {
            for one in couplings.iter().filter(|one| !one.rounding) {
                let label = format!("{letter} = {}", value(one));
                let wrong = mark == Mark::Skew || one.value.is_negative();
                self.items.push(Item { mark, ends: ends(one), label, wrong });
            }
        }
        for one in elements.masses.iter().filter(|one| one.second.is_some() && !one.rounding) {
            let label = format!("shared m = {}", value(one));
            self.items.push(Item { mark: Mark::Inertia, ends: ends(one), label, wrong: false });
        }
    }

    /// Forces that are formulas: of what stands in one, it is between that and the coordinate.
    fn smooth(&mut self, picture: &MachinePicture) {
        let machine = &picture.written.machine;
        if let Some(cubic) = picture.written.cubic.as_ref().filter(|cubic| !cubic.value.is_zero()) {
            self.formulas.push((0, format!("-({})*q^3", Short(cubic.float()))));
            self.formula(0, vec![0]);
        }
        for (i, force) in machine.smooth.iter().enumerate() {
            let Some(force) = force else { continue };
            // What `cubic` is added to, where it is nothing.
            let text = force.text();
            self.formulas.push((i, text.strip_prefix("(0)").unwrap_or(text).to_string()));
            self.formula(i, seen_in(force, machine.points()));
        }
    }

    /// The last formula, which acts on a coordinate and has these in it.
    fn formula(&mut self, on: usize, seen: Vec<usize>) {
        let label = format!("f{}", self.formulas.len());
        if seen.is_empty() {
            self.boxes[on].above.push((0, format!("{label}(t)")));
            return;
        }
        let mut at = seen;
        if !at.contains(&on) {
            at.push(on);
            at.sort_unstable();
        }
        let ends = match at[..] {
            [at] => Ends::Ground { at, left: true },
            [i, j] => Ends::Pair(i, j),
            _ => Ends::Many(at),
        };
        // Two forces between the same two masses are one spring.
        let known = self.items.iter_mut().find(|item| item.mark == Mark::Formula && item.ends == ends);
        match known {
            Some(item) => item.label = format!("{}, {label}", item.label),
            None => self.items.push(Item { mark: Mark::Formula, ends, label, wrong: false }),
        }
    }

    /// Leaves out what there is no room for, and says so.
    fn limit(&mut self, names: &Names) {
        let count = self.boxes.len();
        if count > BOXES {
            self.boxes.truncate(BOXES);
            let (from, to) = (names.point(BOXES), names.point(count - 1));
            self.left_out.push(format!("coordinates {from} to {to} and what stands at them"));
            self.items.retain(|item| match &item.ends {
                Ends::Ground { at, .. } => *at < BOXES,
                Ends::Pair(_, j) => *j < BOXES,
                Ends::Many(all) => all.iter().all(|at| *at < BOXES),
            });
        }
        let mut places = std::collections::BTreeMap::new();
        let before = self.items.len();
        self.items.retain(|item| {
            let place = match &item.ends {
                Ends::Ground { at, left } => Some(at + usize::from(!left)),
                Ends::Pair(i, j) if j - i == 1 => Some(*j),
                _ => None,
            };
            let count = places.entry(place).or_insert(0);
            *count += 1;
            // A sign that may be wrong is never what is left out.
            *count <= LANES || item.wrong && *count <= 4 * LANES
        });
        if self.items.len() < before {
            self.left_out.push(format!("{} springs, dampers, stops or formulas", before - self.items.len()));
        }
    }
}

/// The coordinates in a formula of so many, by their displacements or velocities.
fn seen_in(force: &SmoothForce<Evaluated>, points: usize) -> Vec<usize> {
    (0..points).filter(|&i| force.mentions(&|place| place == i || place == points + i)).collect()
}

/// a cos kΩt + b sin kΩt, as it is written over a box or about a wall.
pub(super) fn harmonic(k: u32, cos: Option<f64>, sin: Option<f64>) -> Option<String> {
    let angle = if k == 1 { "Ωt".to_string() } else { format!("{k}Ωt") };
    match (cos, sin) {
        (None, None) => None,
        (Some(a), None) => Some(format!("{} cos {angle}", Short(a))),
        (None, Some(b)) => Some(format!("{} sin {angle}", Short(b))),
        (Some(a), Some(b)) => {
            let sign = if b < 0.0 { "-" } else { "+" };
            Some(format!("{} cos {angle} {sign} {} sin {angle}", Short(a), Short(b.abs())))
        }
    }
}

/// A stop on the side on which its gap closes.
fn stop(stop: &Stop<Evaluated>) -> Option<Item> {
    let at = taken(&stop.row);
    let soft = matches!(stop.law, StopLaw::Soft { .. });
    let damped = matches!(&stop.law, StopLaw::Soft { damping, .. } if !damping.value.is_zero());
    let moving = !stop.wall.harmonics.is_empty();
    let whole = Mark::Stop { soft, damped, moving };
    let size = |i: usize| stop.row[i].value.abs();
    let (mark, ends) = match at[..] {
        [] => return None,
        [at] => (whole, Ends::Ground { at, left: stop.row[at].value.is_positive() }),
        [i, j] if size(i) == size(j) && stop.row[i].value == -&stop.row[j].value => {
            let apart = stop.row[i].value.is_negative();
            (if apart { whole } else { Mark::Strap { soft, damped } }, Ends::Pair(i, j))
        }
        _ => (Mark::Lever { soft }, Ends::Many(at.clone())),
    };
    let label = match mark {
        Mark::Lever { .. } => stop.name.clone(),
        _ => {
            let gap = -stop.wall.offset.float() / stop.row[at[0]].float().abs();
            format!("{}: gap {}", stop.name, Short(gap))
        }
    };
    Some(Item { mark, ends, label, wrong: false })
}
