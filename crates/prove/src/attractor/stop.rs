//! Where a wall is beyond the place of rest, and how it bends there.

use std::f64::consts::TAU;

use crate::chaos::{profile::Profile, span::Span};

/// The wall at a depth, and all depths below.
#[derive(Debug, Clone)]
pub(super) struct Stop {
    /// U and V.
    pub window: [f64; 2],
    /// α and α′.
    pub bends: [f64; 2],
    /// Where it is concave, and in how many pieces it is shown to be as it is; none of a cosine.
    pub shown: Option<([f64; 2], u64)>,
}

/// How far past the window.
const ROOM: f64 = 2e-6;
/// Steps by which concavity is followed from the top.
const STEPS: u32 = 400;
/// Into how many pieces the wall is cut, one after the other.
const PIECES: [u64; 3] = [50, 200, 1000];
/// By such a part bounds are made wider, for other enclosures.
const WIDER: f64 = 1e-4;

impl Stop {
    /// None where the wall is not seen to be so.
    pub fn of(profile: &Profile, depth: f64) -> Option<Stop> {
        if profile.is_cosine() {
            let end = (1.0 - depth).acos() * (1.0 + ROOM);
            return (depth < 1.0).then_some(Stop {
                window: [end; 2],
                bends: [1.0 - depth, 1.0],
                shown: None,
            });
        }
        let concave = [concave(profile, -1.0), concave(profile, 1.0)];
        let window = [edge(profile, -1.0, concave[0], depth)?, edge(profile, 1.0, concave[1], depth)?];
        let found = |pieces: u64| {
            let cut = |lo: f64, hi: f64| (0..pieces).map(move |i| Span::new(lo, hi).part(i, pieces));
            let bowed = cut(-concave[0], concave[1]).all(|t| profile.at(t).bend.lo > WIDER);
            let clear =
                cut(concave[1], TAU - concave[0]).all(|t| profile.at(t).drop.lo > depth * (1.0 + WIDER));
            let bends = cut(-window[0], window[1]).map(|t| profile.at(t).bend);
            let all = bends.reduce(Span::hull)?;
            (bowed && clear && all.lo > WIDER).then_some([all.lo * (1.0 - WIDER), all.hi * (1.0 + WIDER)])
        };
        PIECES.into_iter().find_map(|pieces| {
            found(pieces).map(|bends| Stop { window, bends, shown: Some((concave, pieces)) })
        })
    }
}

/// Where the wall is concave on a side of its top, but for a little.
fn concave(profile: &Profile, side: f64) -> f64 {
    let step = TAU / (2 * STEPS) as f64;
    let bowed = |i: &u32| {
        let ends = [f64::from(*i), f64::from(*i + 1)].map(|i| side * i * step);
        profile.at(Span::new(ends[0].min(ends[1]), ends[0].max(ends[1]))).bend.lo > 0.05
    };
    // Not to the other side, where the window would be as long as a period.
    f64::from((0..STEPS).take_while(bowed).count() as u32) * step
}

/// Where the wall is so far below its top, on a side of it where it is concave.
fn edge(profile: &Profile, side: f64, concave: f64, depth: f64) -> Option<f64> {
    let below = |t: f64| profile.at(Span::point(side * t)).drop.lo > depth * (1.0 + WIDER);
    if !below(concave) {
        return None;
    }
    let (mut lo, mut hi) = (0.0, concave);
    for _ in 0..60 {
        let middle = 0.5 * (lo + hi);
        if below(middle) { hi = middle } else { lo = middle }
    }
    let end = hi * (1.0 + ROOM);
    (end < concave).then_some(end)
}
