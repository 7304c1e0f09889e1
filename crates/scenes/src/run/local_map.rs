//! The local map at a grazing, in the scene's coordinates: what of a report is the same by both engines.

use std::f64::consts::TAU;

use serde::Serialize;

use super::{Complex, Judgement, Lines};
use crate::{continuation::LocalMap, search::touch::InTheory as _};

/// A local map in the scene's coordinates (q, q̇) less those of the orbit that grazes, per unit of time.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MapNumbers {
    /// a_G: the second derivative of the gap there.
    pub acceleration: f64,
    /// A, by rows.
    #[serde(rename = "A")]
    pub a: Vec<Vec<f64>>,
    /// B.
    #[serde(rename = "B")]
    pub b: Vec<f64>,
    /// C.
    #[serde(rename = "C")]
    pub c: Vec<f64>,
    /// e: how fast the least gap opens with the parameter.
    pub e: f64,
    /// The eigenvalues of A, the largest modulus first.
    pub eigenvalues: Vec<Complex>,
    /// a₁ = tr A; only of one degree of freedom.
    pub a1: Option<f64>,
    /// a₂ = det A; only of one degree of freedom.
    pub a2: Option<f64>,
    /// γ; only of one degree of freedom.
    pub gamma: Option<f64>,
    /// The region of the plane of (a₁, a₂), 1 to 5 or `line`; only of one degree of freedom, and for a₂ > 0.
    pub region: Option<String>,
    /// Where the map is in the picture of what is born and seen, if its eigenvalues are complex: across, of
    /// the motion without impacts the frequency of the free vibration over that of the forcing, without its
    /// whole part.
    pub ratio: Option<f64>,
    /// Up: what is left of a free vibration after a period.
    pub remains: Option<f64>,
}

/// A grazing bifurcation with its local map: of an orbit of an oscillator, of the motion without impacts of a
/// machine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GrazingMap {
    /// The parameter.
    pub varied: String,
    /// Its value at grazing.
    pub parameter: f64,
    /// The pattern of the orbit that grazes, where it is one with impacts or may be.
    pub orbit: Option<String>,
    /// The stop that is grazed.
    pub stop: String,
    /// t_G, as a fraction of the period.
    pub phase: f64,
    /// The local map there.
    #[serde(flatten)]
    pub map: MapNumbers,
    /// Whether the orbit is one but for the tangency.
    pub admissible: Judgement,
    /// What is left of the equations, of a machine of the gap.
    pub residual: f64,
    /// Whether the map is of half a period, followed by the mirror: the motion is symmetric and grazes a stop
    /// and its mirror. Patterns count halves then, and the stops alternate with them; A and what follows from
    /// it are that map's.
    pub half: bool,
    /// Why the local theory does not apply, if it does not.
    pub open: Option<String>,
}

/// A matrix of more rows than this is not shown in text.
const SHOWN: usize = 6;

impl MapNumbers {
    /// Those of a map whose velocities are per radian of the forcing, `rate` of which are a unit of time.
    pub(super) fn of(map: &LocalMap, rate: f64) -> MapNumbers {
        let one = map.gamma().is_some();
        let unit = |i: usize| if i < map.b.len() / 2 { 1.0 } else { rate };
        let row = |(i, row): (usize, &Vec<f64>)| {
            row.iter().enumerate().map(|(j, x)| x * unit(i) / unit(j)).collect::<Vec<f64>>()
        };
        let (trace, gamma) = (map.trace(), map.gamma().map(|gamma| gamma / rate));
        let place = gamma.map(|gamma| MapNumbers::in_picture(trace, map.determinant, gamma));
        let [ratio, remains] = place.unwrap_or_default();
        MapNumbers {
            acceleration: map.acceleration * rate * rate,
            a: map.a.iter().enumerate().map(row).collect(),
            b: map.b.iter().enumerate().map(|(i, x)| x * unit(i)).collect(),
            c: map.c.clone(),
            e: map.e,
            eigenvalues: map.eigenvalues.iter().map(|&x| Complex::from(x)).collect(),
            a1: one.then_some(trace),
            a2: one.then_some(map.determinant),
            gamma,
            region: map.region().map(|region| region.to_string()),
            ratio,
            remains,
        }
    }

    /// The place of (a₁, a₂, sign γ) in the picture: a₁ = 2r cos 2πs, a₂ = r², and s or 1 − s across.
    fn in_picture(a1: f64, a2: f64, gamma: f64) -> [Option<f64>; 2] {
        let r = a2.sqrt();
        let cosine = a1 / (2.0 * r);
        if !(cosine.abs() < 1.0 && gamma.abs() > 0.0) {
            return [None, None];
        }
        let s = cosine.acos() / TAU;
        [Some(if gamma > 0.0 { s } else { 1.0 - s }), Some(r)]
    }
}

impl MapNumbers {
    /// The numbers, each with what it is.
    pub(super) fn lines(&self, varied: &str, residual: f64, lines: &mut Lines) {
        lines.say("local_map", "(q, q') less the orbit's at the touch, after a period");
        // Large ones are in JSON.
        if self.b.len() <= SHOWN {
            self.a.iter().for_each(|row| lines.say("A", row.clone()));
            lines.say("B", format!("{}: added by an impact of size 1", lines.set(self.b.clone())));
            lines.say("C", format!("{}: the gap, by (q, q')", lines.set(self.c.clone())));
        }
        lines.say("e", format!("{}: the least gap, per {varied}", lines.set(self.e)));
        lines.say("acceleration", format!("{}: of the gap at the touch", lines.set(self.acceleration)));
        lines.say("eigenvalues", self.eigenvalues.iter().take(SHOWN).copied().collect::<Vec<_>>());
        if self.eigenvalues.len() > SHOWN {
            lines.say("more_eigenvalues", self.eigenvalues.len() - SHOWN);
        }
        if let (Some(a1), Some(a2)) = (self.a1, self.a2) {
            lines.say("a1", format!("{}: trace of A", lines.set(a1)));
            lines.say("a2", format!("{}: determinant of A", lines.set(a2)));
            lines.say("region", self.region.as_deref().unwrap_or("none"));
        }
        if let Some(gamma) = self.gamma {
            lines.say("gamma", format!("{}: A12", lines.set(gamma)));
        }
        if let (Some(ratio), Some(remains)) = (self.ratio, self.remains) {
            let of = "free over forcing frequency, without its whole part";
            lines.say("ratio", format!("{}: {of}", lines.set(ratio)));
            lines.say("remains", format!("{}: of a free vibration after a period", lines.set(remains)));
        }
        lines.say("residual", residual);
    }
}
