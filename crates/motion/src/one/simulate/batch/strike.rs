//! Impacts: what the wall gives back, eight motions at a time, and who is looked at again on the cell.

use fearless_simd::{Simd, prelude::*};

use super::{
    super::{
        Event,
        grid::TERMS,
        pieces::{LOWER, UPPER},
    },
    group::{Each, Group, set},
    queue::Queue,
    sweep::{self, Span},
    tables::{Shared, far},
    vector::{LANES, load, splat, turned},
};
use crate::motion::{Time, event::Impact};

/// An impact found, its motion not changed yet.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounce {
    pub lane: usize,
    wall: usize,
    /// Where on the cell.
    x: f64,
    /// y after it.
    y: [f64; 2],
    /// z′ on arrival, per unit of time.
    velocity: f64,
    /// z, z′, z″ at x, and the rounding error of z.
    gap: [f64; 4],
    /// Whether it is far from each wall after that, where that is known already.
    apart: [Option<bool>; 2],
}

/// Lists what the wall makes of the hits on it. Bounces that may be too low to count, and impacts that may be
/// the last ones, are left to the scalar code.
#[inline(always)]
pub(super) fn bounce<S: Simd>(s: S, group: &mut Group, span: Span, wall: usize) {
    let mut hits = std::mem::take(&mut group.work.hits[wall]);
    for at in (0..hits.len).step_by(LANES) {
        s.vectorize(
            #[inline(always)]
            || bounces(s, group, span.cell, wall, &hits, at),
        );
    }
    hits.len = 0;
    group.work.hits[wall] = hits;
}

#[inline(always)]
fn bounces<S: Simd>(s: S, group: &mut Group, cell: usize, wall: usize, hits: &Queue<8>, at: usize) {
    let lanes = hits.lanes(s, at);
    let [a, b, x, z, slope, bend, rounding, from] = hits.numbers(s, at);
    let stops = group.stops[wall].as_ref().expect("only walls that are there are met");
    let last = stops.restitution.len() - 1;
    let places: [usize; LANES] = std::array::from_fn(|lane| (lanes[lane] as usize).min(last));
    let one = group.shared.as_ref().is_some_and(|shared| shared.drive.is_some());
    let restitution = match one {
        true => splat(s, stops.restitution[0]),
        false => load(s, &places.map(|lane| stops.restitution[lane])),
    };
    let half = splat(s, group.kind.half);
    let velocity = (slope / half).min(splat(s, 0.0));
    let back = -restitution * velocity;
    let du = splat(s, -stops.sign) * (splat(s, 1.0) + restitution) * velocity;
    // The motion (0, du) at x, seen from the middle.
    let basis = match &group.shared {
        Some(Shared { basis, .. }) => {
            let mut wide = [x; TERMS];
            for (out, c) in wide.iter_mut().zip(&basis[1]) {
                *out = load(s, c);
            }
            wide
        }
        None => turned(s, places.map(|lane| &group.tables[lane].basis[1])),
    };
    let (mut q, mut u) = (splat(s, 0.0), splat(s, 0.0));
    let there = -x;
    for c in basis.iter().rev() {
        u = u * there + q;
        q = q * there + *c;
    }
    let (c, d) = (a + du * q, b + du * u / half);
    let energy = back * back;
    // Who is far from the walls on the rest of the cell.
    let mut apart = [None; 2];
    if one {
        let (row, depth) = (if group.kind.driven { cell } else { 0 }, splat(s, group.kind.depth));
        for wall in [LOWER, UPPER] {
            if group.kind.walls[wall] {
                apart[wall] =
                    Some(sweep::far(s, group.blocks.at([0, 0]), wall, row, [c, d], depth).to_bitmask());
            }
        }
    }
    for i in 0..(hits.len - at).min(LANES) {
        let lane = lanes[i] as usize;
        let enough = energy[i] >= stops.least[lane];
        let both = group.kind.walls == [true; 2];
        if both {
            let met = &mut group.work.met[lane];
            let upper_first = met.is_nan();
            // No number where both are met: the upper wall comes first.
            *met = if wall == UPPER && *met < f64::INFINITY { f64::NAN } else { f64::INFINITY };
            if wall == LOWER && upper_first {
                continue;
            }
        }
        if !enough || group.impacts[lane] + 1 >= group.kind.impact_limit {
            group.work.strange.push((lane, [a[i], b[i]], from[i]));
            continue;
        }
        group.work.bounces.push(Bounce {
            lane,
            wall,
            x: x[i],
            y: [c[i], d[i]],
            velocity: velocity[i],
            gap: [z[i], slope[i], bend[i], rounding[i]],
            apart: apart.map(|mask| mask.map(|mask| mask >> i & 1 == 1)),
        });
    }
}

impl Bounce {
    /// The impact happens.
    pub fn happen(&self, group: &mut Group, span: Span, each: &mut Each) {
        let &Bounce { lane, wall, x, y, velocity, gap: [z, slope, bend, rounding], apart } = self;
        let (eight, bit) = (lane / LANES, lane % LANES);
        if let Some(each) = each {
            // As the scalar engine says it.
            let half = group.kind.half;
            let period = group.periods[lane] + span.later;
            let time = Time::new(period, (2 * span.cell + 1) as f64 * half + x * half);
            let radius = (2.0 * (z.abs() + rounding) / slope.abs())
                .min((2.0 * (z.abs() + rounding) / bend.abs()).sqrt());
            let side = group.simulators[lane].walls.side(wall);
            let radius = radius * half + 1e-15;
            each(group.names[lane], Event::Impact(Impact { time, radius, place: side, velocity, shock: () }));
        }
        group.impacts[lane] += 1;
        set(&mut group.open[wall][eight], bit, false);
        group.put(lane, y);
        group.looks += 1;
        let row = if group.kind.driven { span.cell } else { 0 };
        for wall in [LOWER, UPPER] {
            if !group.kind.walls[wall] {
                continue;
            }
            let near = || !far(&group.tables[lane], wall, row, y, group.kind.depth);
            if !apart[wall].map_or_else(near, |apart| !apart) {
                set(&mut group.open[wall][eight], bit, true);
            } else {
                group.work.next[wall].push_one(lane, [y[0], y[1], x, span.end]);
            }
        }
    }
}
