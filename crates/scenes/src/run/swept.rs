//! What a diagram that sweeps its parameter comes to: windows in the order of the sweep, jumps, hysteresis.

use serde::Serialize;

use super::{Lines, row};
use crate::{
    attractor::{
        diagram::{Jump, SweepStep},
        portrait::{OnAttractor, Portrait},
    },
    scene::branches::SweepWay,
};

row! {
    /// Neighbouring values at which a sweep is on attractors of one kind.
    pub struct SweptRow {
        /// Which way the parameter goes.
        pub sweep: String,
        /// The first value, in the order of the sweep.
        pub from: f64,
        /// The last.
        pub to: f64,
        /// The period, in forcing periods; absent if it is not periodic or not settled.
        pub period: Option<u32>,
        /// Impacts in a period.
        pub impacts: Option<u64>,
        /// How many values.
        pub values: usize,
    }
}

row! {
    /// Where a sweep jumps from one attractor to another.
    pub struct JumpRow {
        /// Which way the parameter goes.
        pub sweep: String,
        /// What ends the orbit that it was on, which is followed to there: "saddle-node", "flip",
        /// "neimark-sacker", "grazing" or, if it is none of these as far as is seen, "unknown"; of a motion
        /// that is not periodic "seen", as it is followed from value to value.
        pub ends: &'static str,
        /// The last value known at which the motion stays.
        pub stays: f64,
        /// The first value known at which it has left; of an orbit they differ by rounding.
        pub left: f64,
        /// What it was on.
        pub before: String,
        /// Its least and greatest displacement; of a machine, if that is the first number of `plane`.
        pub extent_before: Option<Vec<f64>>,
        /// The least and the greatest gap, if a gap is.
        pub gap_before: Option<Vec<f64>>,
        /// The fastest impact on it.
        pub speed_before: Option<f64>,
        /// What it comes to.
        pub after: String,
        /// Its least and greatest displacement, as before.
        pub extent_after: Option<Vec<f64>>,
        /// The least and the greatest gap, as before.
        pub gap_after: Option<Vec<f64>>,
        /// The fastest impact on it.
        pub speed_after: Option<f64>,
    }
}

row! {
    /// Neighbouring values at which what is seen depends on the way.
    pub struct HysteresisRow {
        /// The least value.
        pub from: f64,
        /// The greatest.
        pub to: f64,
        /// What is seen at the least value as the parameter goes up.
        pub up: String,
        /// What is seen there as it goes down.
        pub down: String,
        /// How many values.
        pub values: usize,
    }
}

/// What a sweep comes to.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SweepFindings {
    /// Windows, in the order of the sweep.
    pub windows: Vec<SweptRow>,
    /// Jumps, in the order of the sweep.
    pub jumps: Vec<JumpRow>,
    /// Where the two ways differ; absent for one way.
    pub hysteresis: Option<Vec<HysteresisRow>>,
    /// Values at which the motion leaves every bound or begins behind a stop; the next begins anew.
    pub lost: Vec<f64>,
}

/// Two attractors whose extents differ by more than this part of their widths are told apart.
const APART: f64 = 0.05;

/// A part of a sweep that goes one way, with its jumps.
pub(super) struct Leg<'a, S> {
    pub up: bool,
    pub steps: &'a [SweepStep<S>],
    pub jumps: Vec<Jump<S>>,
}

impl<S> Leg<'_, S> {
    fn way(&self) -> String {
        way(self.up).to_string()
    }

    fn windows(&self) -> Vec<SweptRow> {
        let mut rows: Vec<SweptRow> = Vec::new();
        for step in self.steps {
            let Some(OnAttractor { portrait, .. }) = &step.settled else { continue };
            let (period, impacts) = (portrait.period, portrait.period.map(|_| portrait.impacts));
            match rows
                .last_mut()
                .filter(|last| !step.anew && (last.period, last.impacts) == (period, impacts))
            {
                Some(last) => (last.to, last.values) = (step.value, last.values + 1),
                None => {
                    let (from, to) = (step.value, step.value);
                    rows.push(SweptRow { sweep: self.way(), from, to, period, impacts, values: 1 });
                }
            }
        }
        rows
    }

    fn jumps(&self, drawn: &str) -> impl Iterator<Item = JumpRow> {
        let of = |begin: &str, portrait: &Portrait| {
            drawn.starts_with(begin).then(|| portrait.range.extent.to_vec())
        };
        self.jumps.iter().map(move |jump| {
            let Jump { stays, left, before, after, .. } = jump;
            let (before, after) = (&before.portrait, &after.portrait);
            JumpRow {
                sweep: self.way(),
                ends: jump.ends_in(),
                stays: *stays,
                left: *left,
                before: before.words(),
                extent_before: of("q", before),
                gap_before: of("gap ", before),
                speed_before: before.range.speed,
                after: after.words(),
                extent_after: of("q", after),
                gap_after: of("gap ", after),
                speed_after: after.range.speed,
            }
        })
    }
}

/// The way's name, as in a scene.
pub(super) fn way(up: bool) -> &'static str {
    if up { SweepWay::Up.word() } else { SweepWay::Down.word() }
}

impl SweepFindings {
    /// Of motions of which `drawn` is told.
    pub(super) fn of<S>(legs: &[Leg<'_, S>], drawn: &str) -> SweepFindings {
        let leg = |up: bool| legs.iter().find(|leg| leg.up == up).map(|leg| leg.steps);
        let lost = |leg: &Leg<'_, S>| -> Vec<f64> {
            leg.steps.iter().filter(|step| step.settled.is_none()).map(|step| step.value).collect()
        };
        SweepFindings {
            windows: legs.iter().flat_map(Leg::windows).collect(),
            jumps: legs.iter().flat_map(|leg| leg.jumps(drawn)).collect(),
            hysteresis: leg(true).zip(leg(false)).map(|(up, down)| hysteresis(up, down)),
            lost: legs.iter().flat_map(lost).collect(),
        }
    }

    pub(super) fn lines(&self, lines: &mut Lines) {
        lines.table("windows", &self.windows);
        lines.table("jumps", &self.jumps);
        if let Some(rows) = &self.hysteresis {
            lines.table("hysteresis", rows);
        }
        if !self.lost.is_empty() {
            lines.say("lost", self.lost.len());
        }
    }
}

/// Where the way up and the way down differ; the steps down are those up in the other order.
fn hysteresis<S>(up: &[SweepStep<S>], down: &[SweepStep<S>]) -> Vec<HysteresisRow> {
    let mut rows: Vec<HysteresisRow> = Vec::new();
    let mut open = false;
    for (up, down) in up.iter().zip(down.iter().rev()) {
        let seen = |step: &SweepStep<S>| step.decided().map(|settled| settled.portrait.clone());
        let pair = seen(up).zip(seen(down)).filter(|(up, down)| differ(up, down));
        match (pair, rows.last_mut().filter(|_| open)) {
            (Some(_), Some(last)) => (last.to, last.values) = (up.value, last.values + 1),
            (Some((on_up, on_down)), None) => {
                let (from, to) = (up.value, up.value);
                rows.push(HysteresisRow { from, to, up: on_up.words(), down: on_down.words(), values: 1 });
                open = true;
            }
            (None, _) => open = false,
        }
    }
    rows
}

fn differ(one: &Portrait, other: &Portrait) -> bool {
    let kind = |portrait: &Portrait| portrait.period.map(|period| (period, portrait.impacts));
    one.apart(other) > APART || (kind(one).is_some() && kind(other).is_some() && kind(one) != kind(other))
}
