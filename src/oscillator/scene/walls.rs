//! Whether two walls stay apart all the period long: a bound, not a sample.

use crate::oscillator::{Harmonic, System, Wall};

/// Walls nearer than this, in units of their size, count as touching.
const CLOSE: f64 = 1e-9;

/// `None` if the walls stay apart by more than 10⁻⁹ times their size, or one is missing; else a time at which they do
/// not, and the gap there.
///
/// On a stretch of half-width h around m the gap is at least g(m) − |g′(m)| h − M h²/2, M = Σ k² (|cos| + |sin|) bounding |g″|;
/// stretches are halved until that is positive or the gap at the middle is not. Rounding is far below the margin.
/// Cost: O(M/g) stretches for least gap g, at worst some 10⁵.
pub(super) fn meet(system: &System<f64>) -> Option<(f64, f64)> {
    let (lower, upper) = (system.lower.as_ref()?, system.upper.as_ref()?);
    let harmonics = || upper.harmonics.iter().chain(&lower.harmonics);
    let amplitude = |power: i32| -> f64 {
        harmonics().map(|h| f64::from(h.k).powi(power) * (h.cos.abs() + h.sin.abs())).sum()
    };
    let curvature = amplitude(2);
    let margin = CLOSE * (upper.offset.abs() + lower.offset.abs() + amplitude(0));
    let pi = std::f64::consts::PI;
    let mut stretches = vec![(pi, pi)];
    while let Some((middle, half)) = stretches.pop() {
        let ((top, rise), (bottom, fall)) = (position(upper, middle), position(lower, middle));
        let gap = top - bottom;
        // Not `gap <= margin`: what is not a number is not a gap.
        if !(gap > margin) {
            return Some((middle, gap));
        }
        if gap - (rise - fall).abs() * half - curvature * half * half / 2.0 <= 0.0 {
            let half = half / 2.0;
            stretches.extend([(middle + half, half), (middle - half, half)]);
        }
    }
    None
}

/// Q(t) and Q′(t).
pub(super) fn position(wall: &Wall<f64>, t: f64) -> (f64, f64) {
    let add = |(q, v): (f64, f64), h: &Harmonic<f64>| {
        let k = f64::from(h.k);
        let (sin, cos) = (k * t).sin_cos();
        (q + h.cos * cos + h.sin * sin, v + k * (h.sin * cos - h.cos * sin))
    };
    wall.harmonics.iter().fold((wall.offset, 0.0), add)
}
