//! What can be claimed of one box.

use std::f64::consts::TAU;

use super::{
    chart::{Axis, Cell, Chart, Frame},
    expansion::{Expander, Expansion},
};
use crate::certificate::cover::Leaf;

/// What the search makes of a box.
pub(super) enum Verdict {
    /// A leaf.
    Leaf(Leaf),
    /// Too large: to be split along this axis.
    Split(Axis),
    /// Left open: splitting does not help against rounding.
    Noise,
}

/// Decides boxes of one chart. `finest` bounds the size of Edge leaves in the (a₁, a₂) plane.
pub(super) struct Judge<'a> {
    pub chart: &'a Chart,
    pub n: u64,
    pub finest: Option<f64>,
    expander: Expander,
}

impl<'a> Judge<'a> {
    pub fn new(chart: &'a Chart, n: u64, finest: Option<f64>) -> Self {
        Judge { chart, n, finest, expander: Expander::new(n, chart.strip.is_outermost()) }
    }

    /// Decides a box, and says whether what was found contradicts the claim for the strip. `latest` is the
    /// None leaf found last in the strip. O(n).
    pub fn judge(&mut self, cell: &Cell, latest: Option<Leaf>) -> (Verdict, bool) {
        let frame = self.chart.frame(cell);
        self.expander.expand(&frame);
        let all = &self.expander.all;
        // A None leaf repeated is one byte of a certificate.
        if let Some(leaf @ Leaf::None { positive, negative }) = latest
            && all[positive as usize].low(1.0) > 0.0
            && all[negative as usize].low(-1.0) > 0.0
        {
            return (Verdict::Leaf(leaf), self.claims_orbit(all));
        }
        // How many have the sign t for certain, and the least: small numbers keep certificates short.
        let certain = |t: f64| {
            let mut found =
                (1..).zip(&all[1..]).filter(|(_, expansion)| expansion.low(t) > 0.0).map(|(k, _)| k);
            let least = found.next();
            (least.map_or(0, |_| 1 + found.count() as u64), least.unwrap_or_default())
        };
        let ((above, positive), (below, negative)) = (certain(1.0), certain(-1.0));
        let claimed = self.chart.strip.sign();
        if above > 0 && below > 0 {
            return (Verdict::Leaf(Leaf::None { positive, negative }), self.claims_orbit(all));
        }
        if above.max(below) + 1 == self.n {
            let t = if above > 0 { 1.0 } else { -1.0 };
            return (Verdict::Leaf(Leaf::Orbit { positive: above > 0 }), claimed != Some(t));
        }
        if above + below > 0
            && let Some(leaf) = self.edge(cell, &frame, if above > 0 { 1.0 } else { -1.0 })
        {
            return (Verdict::Leaf(leaf), false);
        }
        if all[1..]
            .iter()
            .all(|expansion| expansion.low(1.0).max(expansion.low(-1.0)) > 0.0 || expansion.is_noise())
        {
            return (Verdict::Noise, false);
        }
        let [along_r, along_s] =
            all[1..].iter().map(Expansion::shares).fold([0.0, 0.0], |[a, b], [x, y]| [a + x, b + y]);
        (Verdict::Split(if along_r > along_s { Axis::R } else { Axis::S }), false)
    }

    /// Whether an orbit is claimed to exist on the whole box.
    fn claims_orbit(&self, all: &[Expansion]) -> bool {
        let (Some(t), Some(interval)) = (self.chart.strip.sign(), &self.chart.strip.interval) else {
            return false;
        };
        interval.deciding.is_none_or(|d| all[d as usize].low(t) > 0.0)
    }

    /// An Edge leaf, where some sign is certain and it is t.
    fn edge(&self, cell: &Cell, frame: &Frame, t: f64) -> Option<Leaf> {
        let all = &self.expander.all;
        let deciding = self.chart.strip.interval.as_ref()?.deciding?;
        let fine = self.finest.is_none_or(|finest| {
            let r = 1.0 - frame.gap;
            let (width, height) = (4.0 * TAU * (r + frame.h) * frame.half_turns, 4.0 * r * frame.h);
            width < finest && height < finest * (1.0 - r * r).max(0.1)
        });
        if self.chart.strip.sign() != Some(t) || !fine {
            return None;
        }
        let decider = &all[deciding as usize];
        let across = if !self.chart.touches_top(cell) {
            0
        } else if decider.slope_right(t) > 0.0 {
            1
        } else if -decider.slope_right(-t) < 0.0 {
            -1
        } else {
            return None;
        };
        let beyond =
            |expansion: &Expansion| expansion.low(t) > 0.0 || expansion.minus_multiple(decider).low(t) > 0.0;
        let alone = decider.slope_up(t) > 0.0
            && (1..).zip(&all[1..]).all(|(k, expansion)| k == deciding || beyond(expansion));
        alone.then_some(Leaf::Edge { positive: t > 0.0, deciding, across })
    }
}
