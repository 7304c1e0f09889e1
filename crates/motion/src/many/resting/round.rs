//! Once round a periodic motion: its rests, from what happens on the way.

use std::{collections::BTreeSet, f64::consts::TAU};

use super::{RestSpan, turned};
use crate::{attractor::rest::RestEvent, motion::Time};

/// A rest with its times.
#[derive(Clone, Copy)]
pub(super) struct Span {
    stop: usize,
    begin: Time,
    pub release: Time,
}

impl Span {
    /// The same as phases.
    pub fn phases(self) -> RestSpan {
        RestSpan {
            stop: self.stop,
            begin: turned(self.begin.phase),
            release: turned(self.release.phase),
            length: self.release.since(self.begin),
        }
    }
}

/// What happens once round.
pub(super) struct Round {
    /// The stops rested on at first.
    first: Vec<usize>,
    begun: Vec<(usize, Time)>,
    ended: Vec<(usize, Time)>,
    pub impacts: u64,
    /// The greatest speed of an impact, per radian.
    pub fastest: f64,
    pub tangencies: u64,
}

impl Round {
    /// Of a motion that rests on these at first.
    pub fn new(first: Vec<usize>) -> Round {
        Round { first, begun: Vec::new(), ended: Vec::new(), impacts: 0, fastest: 0.0, tangencies: 0 }
    }

    /// What happens next.
    pub fn meet(&mut self, event: RestEvent) {
        match event {
            RestEvent::Impact(_, speed) => {
                (self.impacts, self.fastest) = (self.impacts + 1, self.fastest.max(speed));
            }
            RestEvent::Tangency(_) => self.tangencies += 1,
            RestEvent::Rest(time, stop) => self.begun.push((stop, time)),
            RestEvent::Release(time, stop) => self.ended.push((stop, time)),
        }
    }

    /// Its rests by their releases, and the stops rested on all the time; none if a release has no rest
    /// before it.
    pub fn rests(&self, period: u64) -> Option<(Vec<Span>, Vec<usize>)> {
        let one = |&(stop, release): &(usize, Time)| {
            let own = || self.begun.iter().filter(|begun| begun.0 == stop).map(|begun| begun.1);
            let last = |all: &mut dyn Iterator<Item = Time>| all.max_by(|a, b| a.since(*b).total_cmp(&0.0));
            let before = last(&mut own().filter(|begin| release.since(*begin) >= 0.0));
            // Of the time round before.
            let earlier = || last(&mut own()).map(|t| Time { period: t.period - period as i64, ..t });
            Some(Span { stop, begin: before.or_else(earlier)?, release })
        };
        let rests = self.ended.iter().map(one).collect::<Option<Vec<_>>>()?;
        let lets_go = |stop: &usize| self.ended.iter().any(|(known, _)| known == stop);
        let begun = self.begun.iter().map(|begun| begun.0);
        let held: BTreeSet<usize> =
            self.first.iter().copied().chain(begun).filter(|stop| !lets_go(stop)).collect();
        Some((rests, held.into_iter().collect()))
    }
}

/// The part of the time that the rests cover.
pub(super) fn covered(rests: &[Span], period: u64) -> f64 {
    let whole = TAU * period as f64;
    let zero = Time::new(0, 0.0);
    let mut spans: Vec<[f64; 2]> = Vec::new();
    for rest in rests {
        let (begin, end) = (rest.begin.since(zero), rest.release.since(zero));
        // On a circle, cut where it begins.
        let from = begin.rem_euclid(whole);
        let to = from + (end - begin);
        spans.push([from, to.min(whole)]);
        if to > whole {
            spans.push([0.0, to - whole]);
        }
    }
    spans.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (mut all, mut reached) = (0.0, 0.0);
    for [from, to] in spans {
        all += (to - from.max(reached)).max(0.0);
        reached = f64::max(reached, to);
    }
    all / whole
}

/// The most stops that it rests on at once, of which `held` all the time.
pub(super) fn at_once(rests: &[Span], held: usize, period: u64) -> usize {
    let whole = TAU * period as f64;
    let lasts = |span: &Span, time: Time| {
        let before = span.release.since(time).rem_euclid(whole);
        before < span.release.since(span.begin)
    };
    // Where one begins all that rest at once with it for the most do.
    let most = rests.iter().map(|one| {
        let others = rests.iter().filter(|other| other.stop != one.stop && lasts(other, one.begin));
        1 + others.count()
    });
    held + most.max().unwrap_or(0)
}
