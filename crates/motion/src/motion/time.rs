//! Time as whole forcing periods and a phase, so that a run of 10⁶ periods is as exact as one of a single
//! period.

use std::f64::consts::TAU;

/// 2π·`period` + `phase`, 0 ≤ phase < 2π; ordered.
#[derive(Debug, Clone, Copy, Default, PartialEq, PartialOrd)]
pub struct Time {
    /// Whole forcing periods.
    pub period: i64,
    /// The rest, in [0, 2π).
    pub phase: f64,
}

impl Time {
    /// A finite time in normal form; each period taken off costs no more than one rounding of the whole.
    pub fn new(period: i64, phase: f64) -> Self {
        let whole = (phase / TAU).floor();
        let (mut period, mut phase) = (period + whole as i64, phase - whole * TAU);
        if phase >= TAU {
            (period, phase) = (period + 1, phase - TAU);
        }
        if phase < 0.0 {
            // The least negative phases round to 2π itself, which is the next period's 0.
            (period, phase) = if phase + TAU < TAU { (period - 1, phase + TAU) } else { (period, 0.0) };
        }
        Time { period, phase: phase + 0.0 }
    }

    /// The time `duration` later.
    #[must_use]
    pub fn after(self, duration: f64) -> Self {
        Time::new(self.period, self.phase + duration)
    }

    /// In forcing periods, as one double.
    pub fn periods(self) -> f64 {
        self.period as f64 + self.phase / TAU
    }

    /// How much later than `other`, as one double.
    pub fn since(self, other: Time) -> f64 {
        (self.period - other.period) as f64 * TAU + (self.phase - other.phase)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_phase_stays_in_one_period() {
        for t in [0.0, TAU, -1e-300, -1e-9, TAU.next_down(), 5.0 * TAU, 7.0, -7.0, 1e6, -TAU] {
            let time = Time::new(3, t);
            assert!((0.0..TAU).contains(&time.phase), "{t}: {time:?}");
            assert!((time.since(Time::new(3, 0.0)) - t).abs() <= 2e-15 * t.abs().max(1.0), "{t}: {time:?}");
        }
        assert!(Time::new(1, 0.0) > Time::new(0, 6.0));
        assert_eq!(Time::new(0, 1.0).after(-2.0), Time::new(-1, TAU - 1.0));
    }
}
