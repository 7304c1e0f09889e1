//! All motions of a group over one forcing period, cell by cell: those far from every wall in one pass, the
//! others packed and looked at in rounds.

use fearless_simd::{Simd, prelude::*, u64x8};

use super::{
    super::{
        grid::NOTHING,
        pieces::{LOWER, UPPER},
        unbounded,
    },
    group::{Each, Group},
    search::search,
    strike::bounce,
    tables::{Drives, Freely},
    vector::{LANES, Mask, V, bits, load, splat},
};
use crate::motion::minimum::ROUNDING;

/// What of a cell is looked at next.
#[derive(Debug, Clone, Copy)]
pub(super) struct Span {
    pub cell: usize,
    pub from: f64,
    pub end: f64,
    /// Whether the motions come from the cell before.
    turn: bool,
    /// Whether no motion has been looked at on the cell, and all are to be to its end.
    pub whole: bool,
    /// How many periods after the last point of the section.
    pub later: i64,
}

impl Group<'_> {
    /// The next period of those who keep step.
    #[inline(always)]
    pub fn sweep<S: Simd>(&mut self, s: S, each: &mut Each) {
        let (cells, at) = (self.kind.cells, self.cell);
        self.told = each.is_some();
        let whole_cell =
            |cell: usize, later| Span { cell, from: -1.0, end: 1.0, turn: true, whole: true, later };
        let first = Span { cell: at, from: self.from, end: 1.0, turn: false, whole: false, later: 0 };
        let last = Span { end: self.from, whole: false, ..whole_cell(at, 1) };
        let before = (at + 1..cells).map(|cell| whole_cell(cell, 0));
        let after = (0..at).map(|cell| whole_cell(cell, 1));
        for span in std::iter::once(first).chain(before).chain(after).chain([last]) {
            s.vectorize(
                #[inline(always)]
                || self.pass(s, span),
            );
            let mut span = span;
            while self.work.looks.iter().any(|looks| looks.len > 0) {
                self.round(s, span, each);
                span.whole = false;
            }
        }
    }

    /// Every motion into a cell; those that may meet a wall there are listed.
    #[inline(always)]
    fn pass<S: Simd>(&mut self, s: S, span: Span) {
        let Group { kind, blocks, y: [first, second], open, aloft, work, .. } = self;
        let driven = kind.driven;
        let row = if driven { span.cell } else { 0 };
        let depth = splat(s, kind.depth);
        let (most, from, end) = (splat(s, 1e100), splat(s, span.from), splat(s, span.end));
        let steps = span.turn && (!driven || span.cell == 0);
        let mut lanes: u64x8<S> = u64x8::from_fn(s, |i| i as u64);
        let (mut counted, mut lost) = (0, 0);
        let [lower, upper] = open;
        let eights = first.iter_mut().zip(second).zip(blocks.of.iter().zip(aloft.iter()));
        for (((a, b), (block, aloft)), (lower, upper)) in eights.zip(lower.iter_mut().zip(upper)) {
            let here = lanes;
            lanes += LANES as u64;
            if *aloft == 0 {
                continue;
            }
            let (freely, drives) = blocks.at(*block);
            let (mut q, mut u) = (load(s, a), load(s, b));
            if span.turn {
                (q, u) = turn(s, freely, q, u);
                if steps {
                    (q, u) = (q + load(s, &freely.step[0]), u + load(s, &freely.step[1]));
                }
                // Subnormal numbers are slow: a motion that has died out is set to rest.
                if span.cell == 0 {
                    let nothing = (q.abs() + u.abs()).simd_lt(splat(s, NOTHING));
                    (q, u) = (nothing.select(splat(s, 0.0), q), nothing.select(splat(s, 0.0), u));
                }
                q.store_array(a);
                u.store_array(b);
            }
            // No gap of a motion that left every bound is looked at: its test would be of infinities.
            let there: Mask<S> = Mask::from_bitmask(s, (*aloft).into());
            let bounded = (q.abs() + u.abs()).simd_le(most);
            lost |= (there & !bounded).to_bitmask();
            let there = there & bounded;
            counted += i64::from(aloft.count_ones());
            for (wall, open) in [(LOWER, &mut *lower), (UPPER, &mut *upper)] {
                if !kind.walls[wall] {
                    continue;
                }
                let far = far(s, (freely, drives), wall, row, [q, u], depth);
                *open |= (far & there).to_bitmask() as u8;
                let near = there & !far;
                if near.to_bitmask() != 0 {
                    work.looks[wall].push(near, here, [q, u, from, end]);
                }
            }
        }
        self.looks += counted;
        if lost != 0 {
            self.lose(span);
        }
    }

    /// Motions that left every bound, not looked at.
    #[cold]
    fn lose(&mut self, span: Span) {
        for eight in 0..self.aloft.len() {
            for bit in bits(self.aloft[eight].into()) {
                let y = [self.y[0][eight][bit], self.y[1][eight][bit]];
                if unbounded(y[0].abs() + y[1].abs()) {
                    let lane = eight * LANES + bit;
                    self.hand_over(lane, self.periods[lane] + span.later, span.cell, y, span.from);
                    self.looks -= 1;
                }
            }
        }
    }

    /// Looks at those listed; the impacts happen, and who bounced may be listed again.
    #[inline(always)]
    fn round<S: Simd>(&mut self, s: S, span: Span, each: &mut Each) {
        for wall in [LOWER, UPPER] {
            self.was_open[wall].copy_from_slice(&self.open[wall]);
        }
        for wall in [LOWER, UPPER] {
            if self.kind.walls[wall] {
                search(s, self, span, wall);
            }
        }
        // The upper wall first: it is looked for no further than where the lower one is met.
        for wall in [UPPER, LOWER] {
            if self.kind.walls[wall] {
                bounce(s, self, span, wall);
            }
        }
        // Nothing has happened yet to those the scalar engine looks at again.
        let mut strange = std::mem::take(&mut self.work.strange);
        for (lane, y, from) in strange.drain(..) {
            if self.aloft[lane / LANES] >> (lane % LANES) & 1 == 1 {
                self.hand_back(lane, span, y, from);
            }
        }
        self.work.strange = strange;
        let mut bounces = std::mem::take(&mut self.work.bounces);
        for bounce in bounces.drain(..) {
            if self.aloft[bounce.lane / LANES] >> (bounce.lane % LANES) & 1 == 1 {
                bounce.happen(self, span, each);
            }
        }
        self.work.bounces = bounces;
        std::mem::swap(&mut self.work.looks, &mut self.work.next);
    }
}

/// To the next cell.
#[inline(always)]
fn turn<S: Simd>(s: S, freely: &Freely, a: V<S>, b: V<S>) -> (V<S>, V<S>) {
    let m = |i: usize| load(s, &freely.matrix[i]);
    (m(0) * a + m(1) * b, m(2) * a + m(3) * b)
}

/// Whether the gap surely stays above the depth on the cell: [`clear`](super::super::search::clear), but that
/// the division is left out where a bound without it tells. With z′ = s, z″/2 = b, the dip is s²/4b < s/2
/// where s < 2b.
#[inline(always)]
pub(super) fn far<S: Simd>(
    s: S,
    (freely, drives): (&Freely, &Drives),
    wall: usize,
    row: usize,
    [a, b]: [V<S>; 2],
    depth: V<S>,
) -> Mask<S> {
    let ([one, other], drive) = (&freely.heads, &drives[wall][row]);
    let term = |i: usize| {
        let sum = a * load(s, &one[i]) + b * load(s, &other[i]);
        // Times −1 is exact.
        if wall == LOWER { sum + load(s, &drive[i]) } else { load(s, &drive[i]) - sum }
    };
    let (start, slope, bend) = (term(0), term(1).abs(), term(2));
    let tail = a.abs() * load(s, &one[3]) + b.abs() * load(s, &other[3]) + load(s, &drive[3]);
    let goal = depth + splat(s, ROUNDING) * (start + slope + bend.abs() + tail);
    let steep = slope - bend;
    let bent = slope.simd_lt(splat(s, 2.0) * bend);
    let short = bent.select(splat(s, 0.5 * (1.0 + 1e-14)) * slope, steep);
    let surely = (start - short - tail).simd_gt(goal);
    if surely.to_bitmask() == 0xff {
        return surely;
    }
    let dip = bent.select(slope * slope / (splat(s, 4.0) * bend), steep);
    (start - dip - tail).simd_gt(goal)
}
