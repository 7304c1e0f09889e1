//! How far each displacement of a motion swings, and a harmonic of it, over whole forcing periods.
//!
//! The motion is followed twice from the same state: first for its events, then between them. Between two
//! events it is smooth, and
//!
//! z_k = 2/(2π n) ∫ q(t) e^{−ikt} dt over n periods
//!
//! is summed by Gauss's rule of eight points on panels that end at the events and at `panels` evenly spaced
//! instants of each period. On a panel of width h the rule is off by less than 10⁻¹⁵ of a term e^{iωt} with
//! ωh ≤ 2. Turning points are those of the cubic through neighbouring looks: off by less than 10⁻⁸ of a swing
//! with ωh ≤ 2. Not here: whether the motion is periodic (`observe`).

use std::f64::consts::{PI, TAU};

use crate::{
    error::Result,
    motion::{RunEnd, Time, flow::GAUSS},
};

/// A motion whose displacements are looked at.
pub trait Swinging {
    /// Where it is in time.
    fn time(&self) -> Time;

    /// On to the next event before `until`, or there: none at an event.
    ///
    /// # Errors
    /// Where a motion cannot go on for another reason than a [`RunEnd`].
    fn go(&mut self, until: Time) -> Result<Option<RunEnd>>;

    /// Each displacement with its velocity per radian of the forcing.
    fn places(&self) -> Vec<[f64; 2]>;
}

/// How a displacement goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swing {
    /// The least and the greatest.
    pub extent: [f64; 2],
    /// The coefficients of cos kt and sin kt.
    pub harmonic: [f64; 2],
}

/// Panels per period for motions with nothing faster than `rate` radians per radian of the forcing, over so
/// many periods: at most 1024, so that of what is faster than 326 the rule is less accurate; and at most 8192
/// in all or 64 per period. So it is less accurate of what goes faster than 20 for 128 periods, as motions
/// that are not periodic are followed: these never go exactly as far again.
pub fn panels(rate: f64, periods: u32) -> u32 {
    let most = (8192 / periods.max(1)).clamp(64, 1024);
    (PI * rate).ceil().clamp(64.0, most.into()) as u32
}

/// A look: the time since the beginning, and the displacements with the velocities where they are known on
/// this side of an event.
pub(crate) struct Look {
    pub at: f64,
    pub places: Vec<[f64; 2]>,
    pub is_event: bool,
}

/// What the displacements do over `periods` periods of the motion that begins so; none where it ends before.
/// Cost: 8 · `panels` looks per period, and 8 more per event.
///
/// # Errors
/// Those of [`Swinging::go`] and of `begin`.
pub fn swings<M: Swinging>(
    begin: impl Fn() -> Result<M>,
    (periods, k, panels): (u32, u32, u32),
) -> Result<Option<Vec<Swing>>> {
    let mut run = begin()?;
    let start = run.time();
    let last = Time::new(start.period + i64::from(periods), start.phase);
    let width = TAU / f64::from(panels);
    let mut ends: Vec<(f64, bool)> = (1..=periods * panels).map(|i| (f64::from(i) * width, false)).collect();
    loop {
        match run.go(last)? {
            None => ends.push((run.time().since(start), true)),
            Some(RunEnd::Reached) => break,
            Some(_) => return Ok(None),
        }
    }
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut run = begin()?;
    let first = run.places();
    let mut sums = vec![[0.0; 2]; first.len()];
    let mut extents: Vec<[f64; 2]> = first.iter().map(|place| [place[0]; 2]).collect();
    let mut before = Look { at: 0.0, places: first, is_event: true };
    let mut from = 0.0;
    for (to, is_event) in ends {
        for (x, weight) in GAUSS.into_iter().filter(|_| to > from) {
            let (at, part) = (from + (to - from) * x, weight * (to - from));
            if !reach(&mut run, start.after(at))? {
                return Ok(None);
            }
            let here = Look { at, places: run.places(), is_event: false };
            let (sin, cos) = (f64::from(k) * (start.phase + at)).sin_cos();
            for (sum, place) in sums.iter_mut().zip(&here.places) {
                sum[0] += part * place[0] * cos;
                sum[1] += part * place[0] * sin;
            }
            widen(&mut extents, &before, &here);
            before = here;
        }
        // Only at an event is a velocity not that of both sides.
        if is_event {
            if !reach(&mut run, start.after(to))? {
                return Ok(None);
            }
            let here = Look { at: to, places: run.places(), is_event };
            widen(&mut extents, &before, &here);
            before = here;
        }
        from = to;
    }
    let part = 1.0 / (PI * f64::from(periods));
    let whole = |(extent, sum): ([f64; 2], [f64; 2])| Swing { extent, harmonic: sum.map(|x| x * part) };
    Ok(Some(extents.into_iter().zip(sums).map(whole).collect()))
}

/// On to a time, through events; whether it is reached.
fn reach(run: &mut impl Swinging, until: Time) -> Result<bool> {
    loop {
        if let Some(end) = run.go(until)? {
            return Ok(end == RunEnd::Reached);
        }
    }
}

/// The extents widened by two looks and what turns between them.
pub(crate) fn widen(extents: &mut [[f64; 2]], a: &Look, b: &Look) {
    let h = b.at - a.at;
    for (extent, (&[p, v], &[q, w])) in extents.iter_mut().zip(a.places.iter().zip(&b.places)) {
        let mut known = |at: f64| *extent = [extent[0].min(at), extent[1].max(at)];
        known(q);
        if h <= 0.0 {
            continue;
        }
        // A parabola where one of the velocities is that of the other side.
        let mean = (q - p) / h;
        let (v, w) = match (a.is_event, b.is_event) {
            (false, false) => (v, w),
            (true, false) => (2.0 * mean - w, w),
            (false, true) => (v, 2.0 * mean - v),
            (true, true) => (mean, mean),
        };
        // p + h (v x + (3m − 2v − w) x² + (v + w − 2m) x³), m the mean; its slope vanishes at x.
        let (bend, twist) = (3.0 * mean - 2.0 * v - w, v + w - 2.0 * mean);
        for x in roots(v, 2.0 * bend, 3.0 * twist).into_iter().filter(|x| (0.0..=1.0).contains(x)) {
            known(p + h * x * (v + x * (bend + x * twist)));
        }
    }
}

/// The real roots of c + b x + a x², NaN for those that are not there.
fn roots(c: f64, b: f64, a: f64) -> [f64; 2] {
    let root = (b * b - 4.0 * a * c).sqrt();
    let sum = -0.5 * (b + root.copysign(b));
    [c / sum, sum / a]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A displacement cos 3(t − 1) + |sin t|/2, its corners events.
    struct Known(Time);

    impl Swinging for Known {
        fn time(&self) -> Time {
            self.0
        }

        fn go(&mut self, until: Time) -> Result<Option<RunEnd>> {
            let since = self.0.since(Time::new(0, 0.0));
            let corner = Time::new(0, ((since / PI + 1e-9).floor() + 1.0) * PI);
            if corner < until {
                self.0 = corner;
                return Ok(None);
            }
            self.0 = until;
            Ok(Some(RunEnd::Reached))
        }

        fn places(&self) -> Vec<[f64; 2]> {
            let t = self.0.phase;
            let side = if t.sin() < 0.0 { -0.5 } else { 0.5 };
            vec![
                [(3.0 * (t - 1.0)).cos() + side * t.sin(), -3.0 * (3.0 * (t - 1.0)).sin() + side * t.cos()],
                [(t - 0.3).cos(), -(t - 0.3).sin()],
            ]
        }
    }

    /// |sin t| = 2/π − (4/π) Σ cos 2mt/(4m² − 1): of its odd harmonics there is none.
    #[test]
    fn a_kinked_displacement_has_its_harmonics_and_its_extent() {
        for (phase, periods) in [(0.0, 1), (0.7, 2)] {
            let begin = || Ok(Known(Time::new(0, phase)));
            for (k, cos, sin) in [(3, 3f64.cos(), 3f64.sin()), (2, -2.0 / (3.0 * PI), 0.0), (1, 0.0, 0.0)] {
                let found = swings(begin, (periods, k, panels(3.0, periods))).unwrap().unwrap();
                let [a, b] = found[0].harmonic;
                assert!((a - cos).abs().max((b - sin).abs()) < 1e-14, "{k}: {found:?}");
            }
            let found = swings(begin, (periods, 1, panels(3.0, periods))).unwrap().unwrap();
            assert!(found[1].extent.iter().zip([-1.0, 1.0]).all(|(x, y)| (x - y).abs() < 1e-9), "{found:?}");
            // By brute force.
            let all = (0..2_000_000).map(|i| Known(Time::new(0, f64::from(i) * PI * 1e-6)).places()[0][0]);
            let (low, high) = all.fold((0.0f64, 0.0f64), |(low, high), q| (low.min(q), high.max(q)));
            let [least, most] = found[0].extent;
            assert!((least - low).abs() < 1e-7 && (most - high).abs() < 1e-7, "{found:?} {low} {high}");
        }
    }
}
