//! The search for the first hit on a wall, eight motions at a time: the cases of
//! [`Gap::first`](super::super::search::Gap::first) in its order, each case packed anew. What is neither an
//! impact nor nothing is left to the scalar code.

use fearless_simd::{Simd, prelude::*, u64x8};

use super::{
    super::{grid::TERMS, pieces::LOWER},
    group::Group,
    queue::Queue,
    sweep::Span,
    tables::Shared,
    vector::{Gaps, LANES, Mask, V, bits, first, load, load_from, splat, turned},
};

/// Most steps for a minimum or a maximum, and for a root: those of the scalar code.
const STEPS: usize = 100;
const ROOT_STEPS: usize = 200;

/// Looks at those listed for the wall; who hits it is listed there.
#[inline(always)]
pub(super) fn search<S: Simd>(s: S, group: &mut Group, span: Span, wall: usize) {
    let whole = span.whole && !(wall != LOWER && group.kind.walls == [true; 2]);
    // The lists are taken out, for each stage reads its own while it writes the next one's; they keep their
    // room.
    let mut work = std::mem::take(&mut group.work.looks[wall]);
    let looks = &mut work;
    if looks.len > 0 {
        group.searches += looks.len as i64;
        for at in (0..looks.len).step_by(LANES) {
            s.vectorize(
                #[inline(always)]
                || survey(s, group, span, wall, whole, looks, at),
            );
        }
        looks.len = 0;
    }
    group.work.looks[wall] = work;
    let mut valleys = std::mem::take(&mut group.work.valleys);
    for at in (0..valleys.len).step_by(LANES) {
        s.vectorize(
            #[inline(always)]
            || valley(s, group, span, wall, &valleys, at),
        );
    }
    valleys.len = 0;
    group.work.valleys = valleys;
    let mut tops = std::mem::take(&mut group.work.tops);
    for at in (0..tops.len).step_by(LANES) {
        s.vectorize(
            #[inline(always)]
            || top(s, group, span, wall, &tops, at),
        );
    }
    tops.len = 0;
    group.work.tops = tops;
    let mut roots = std::mem::take(&mut group.work.roots);
    for at in (0..roots.len).step_by(LANES) {
        s.vectorize(
            #[inline(always)]
            || root(s, group, span, wall, &roots, at),
        );
    }
    roots.len = 0;
    group.work.roots = roots;
}

/// The gaps of eight motions to a wall, as [`Pieces::gap`](super::super::pieces::Pieces::gap).
#[inline(always)]
fn gaps<S: Simd>(s: S, group: &Group, span: Span, wall: usize, lanes: u64x8<S>, y: [V<S>; 2]) -> Gaps<S> {
    let row = if group.kind.driven { span.cell } else { 0 };
    let sign = splat(s, if wall == LOWER { 1.0 } else { -1.0 });
    let [a, b] = [sign * y[0], sign * y[1]];
    let mut gaps = [a; TERMS];
    match &group.shared {
        Some(Shared { basis: [one, other], drive: Some(drive) }) => {
            let drive = &drive[wall][row];
            for (i, gap) in gaps.iter_mut().enumerate() {
                *gap = load(s, &drive[i]) + (a * load(s, &one[i]) + b * load(s, &other[i]));
            }
        }
        Some(Shared { basis: [one, other], drive: None }) => {
            let last = group.tables.len() - 1;
            let rows = |lane: usize| &group.tables[(lanes[lane] as usize).min(last)].drive[wall][row].1;
            gaps = turned(s, [rows(0), rows(1), rows(2), rows(3), rows(4), rows(5), rows(6), rows(7)]);
            for (i, gap) in gaps.iter_mut().enumerate() {
                *gap += a * load(s, &one[i]) + b * load(s, &other[i]);
            }
        }
        None => {
            let mut rows = [[0.0; TERMS]; LANES];
            let last = group.tables.len() - 1;
            for (lane, out) in rows.iter_mut().enumerate() {
                let tables = &group.tables[(lanes[lane] as usize).min(last)];
                let ([one, other], drive) = (tables.basis, &tables.drive[wall][row].1);
                let (a, b) = (splat(s, a[lane]), splat(s, b[lane]));
                for at in [0, LANES] {
                    let sum = a * load_from(s, one, at) + b * load_from(s, other, at);
                    (load_from(s, drive, at) + sum).store_slice(&mut out[at..at + LANES]);
                }
            }
            let [r0, r1, r2, r3, r4, r5, r6, r7] = &rows;
            gaps = turned(s, [r0, r1, r2, r3, r4, r5, r6, r7]);
        }
    }
    Gaps(gaps)
}

/// Notes that the gaps of these motions were open.
#[inline(always)]
fn note<S: Simd>(group: &mut Group, wall: usize, lanes: u64x8<S>, which: Mask<S>) {
    for bit in bits(which.to_bitmask()) {
        let lane = lanes[bit] as usize;
        group.open[wall][lane / LANES] |= 1 << (lane % LANES);
    }
}

/// Those of them whose gap was open before this look.
#[inline(always)]
fn open<S: Simd>(s: S, group: &Group, wall: usize, lanes: u64x8<S>, which: Mask<S>) -> Mask<S> {
    let mut open = 0;
    for bit in bits(which.to_bitmask()) {
        let lane = lanes[bit] as usize;
        open |= u64::from(group.was_open[wall][lane / LANES] >> (lane % LANES) & 1) << bit;
    }
    Mask::from_bitmask(s, open)
}

/// Leaves these motions to the scalar code.
#[inline(always)]
fn leave<S: Simd>(group: &mut Group, lanes: u64x8<S>, which: Mask<S>, y: [V<S>; 2], from: V<S>) {
    for bit in bits(which.to_bitmask()) {
        group.work.strange.push((lanes[bit] as usize, [y[0][bit], y[1][bit]], from[bit]));
    }
}

/// Which case each motion is. On a `whole` cell all gaps are looked at from −1 to 1.
#[inline(always)]
fn survey<S: Simd>(
    s: S,
    group: &mut Group,
    span: Span,
    wall: usize,
    whole: bool,
    looks: &Queue<4>,
    at: usize,
) {
    let there = first(s, looks.len - at);
    let lanes = looks.lanes(s, at);
    let [a, b, l, mut r] = looks.numbers(s, at);
    if group.kind.walls == [true; 2] && wall != LOWER {
        // No further than where the lower wall is met.
        let last = group.work.met.len() - 1;
        let mut met = [0.0; LANES];
        for (lane, met) in met.iter_mut().enumerate() {
            *met = group.work.met[(lanes[lane] as usize).min(last)];
        }
        r = r.min(load(s, &met));
    }
    let gap = gaps(s, group, span, wall, lanes, [a, b]);
    let depth = splat(s, group.kind.depth).max(gap.rounding(s));
    let third = gap.third(s);
    let (two, half_one) = (splat(s, 2.0), splat(s, 0.5));
    let (centre, half) = ((l + r) * half_one, (r - l) * half_one);
    let [z, slope, bend] = if whole { gap.middle(s) } else { gap.at(s, centre) };
    let (turn, tail) = (third * half, third * half * half * half / splat(s, 6.0));
    let steep = slope.abs();
    let low = steep
        .simd_lt(bend * half)
        .select(steep * steep / (two * bend), (steep - bend * half * half_one) * half);
    let clear = (z - low - tail).simd_gt(depth)
        | bend.simd_gt(turn) & (z - steep * steep / (two * (bend - turn))).simd_gt(depth);
    note(group, wall, lanes, clear & there);
    let there = there & !clear;
    if there.to_bitmask() == 0 {
        return;
    }
    let monotone =
        steep.simd_gt((bend.abs() + turn * half_one) * half) | tail.simd_lt(depth * splat(s, 1.0 / 8.0));
    let bent = bend.abs().simd_gt(turn);
    let split = !monotone & bend.abs().simd_le(turn);
    let [left, right] = match whole {
        true => gap.ends(s),
        false => {
            let ([z, slope, _], [end, last, _]) = (gap.at(s, l), gap.at(s, r));
            [[z, slope], [end, last]]
        }
    };
    let zero = splat(s, 0.0);
    let turns = bent & (left[1] * bend).simd_lt(zero) & (right[1] * bend).simd_gt(zero);
    // Neither: where a number is none.
    let whole = there & !split;
    let rises = whole & !turns & (left[1] + right[1]).simd_gt(zero);
    let falls = whole & !turns & !rises;
    let valleys = whole & turns & bend.simd_gt(zero);
    let tops = whole & turns & !bend.simd_gt(zero);
    let low = rises & left[0].simd_le(depth);
    let touches = open(s, group, wall, lanes, low);
    leave(group, lanes, (there & split) | touches, [a, b], l);
    let high = left[0].simd_gt(depth);
    note(group, wall, lanes, (rises & right[0].simd_gt(depth)) | ((falls | valleys) & high));
    let hits = falls & right[0].simd_lt(-depth);
    if hits.to_bitmask() != 0 {
        let guess = l + (r - l) * left[0] / (left[0] - right[0]);
        group.work.roots.push(hits, lanes, [a, b, l, r, guess, left[0], l]);
    }
    let x = centre - slope / bend;
    if valleys.to_bitmask() != 0 {
        let numbers = [a, b, l, left[0], r, right[0], x, bend - turn];
        group.work.valleys.push(valleys, lanes, numbers);
    }
    if tops.to_bitmask() != 0 {
        group.work.tops.push(tops, lanes, [a, b, l, left[0], r, right[0], x]);
    }
}

/// The minimum of convex gaps: below the depth it hides an impact, surely above nothing.
#[inline(always)]
fn valley<S: Simd>(s: S, group: &mut Group, span: Span, wall: usize, valleys: &Queue<8>, at: usize) {
    let mut there = first(s, valleys.len - at);
    let lanes = valleys.lanes(s, at);
    let [a, b, start, high, mut r, end, mut x, least] = valleys.numbers(s, at);
    let gap = gaps(s, group, span, wall, lanes, [a, b]);
    let depth = splat(s, group.kind.depth).max(gap.rounding(s));
    let (mut l, two) = (start, splat(s, 2.0));
    for _ in 0..STEPS {
        let inside = l.simd_lt(x) & x.simd_lt(r);
        x = inside.select(x, (l + r) * splat(s, 0.5));
        let [z, slope, bend] = gap.at(s, x);
        let below = there & z.simd_lt(-depth);
        if below.to_bitmask() != 0 {
            let guess = x - (slope + (slope * slope - two * bend * z).sqrt()) / bend;
            group.work.roots.push(below, lanes, [a, b, start, x, guess, high, start]);
        }
        let above = there & !below & (z - slope * slope / (two * least)).simd_gt(depth);
        note(group, wall, lanes, above & end.simd_gt(depth));
        there = there & !below & !above;
        if there.to_bitmask() == 0 {
            return;
        }
        let falls = slope.simd_lt(splat(s, 0.0));
        l = falls.select(x, l);
        r = falls.select(r, x);
        let step = slope / bend;
        x -= step;
        let narrow = step.abs().simd_lt(splat(s, 1e-8)) | (r - l).simd_lt(splat(s, 1e-15));
        leave(group, lanes, there & narrow, [a, b], start);
        there &= !narrow;
        if there.to_bitmask() == 0 {
            return;
        }
    }
    leave(group, lanes, there, [a, b], start);
}

/// The maximum of concave gaps, then the fall from it.
#[inline(always)]
fn top<S: Simd>(s: S, group: &mut Group, span: Span, wall: usize, tops: &Queue<7>, at: usize) {
    let there = first(s, tops.len - at);
    let lanes = tops.lanes(s, at);
    let [a, b, start, low, end, below, mut x] = tops.numbers(s, at);
    let gap = gaps(s, group, span, wall, lanes, [a, b]);
    let depth = splat(s, group.kind.depth).max(gap.rounding(s));
    let (mut l, mut r, mut left) = (start, end, there);
    for _ in 0..STEPS {
        let inside = l.simd_lt(x) & x.simd_lt(r);
        let here = inside.select(x, (l + r) * splat(s, 0.5));
        let [_, slope, bend] = gap.at(s, here);
        let rises = slope.simd_gt(splat(s, 0.0));
        l = (left & rises).select(here, l);
        r = (left & !rises).select(here, r);
        let step = slope / bend;
        x = left.select(here - step, x);
        let done = step.abs().simd_lt(splat(s, 1e-8)) | (r - l).simd_lt(splat(s, 1e-15));
        left &= !done;
        if left.to_bitmask() == 0 {
            break;
        }
    }
    let x = within(x, l, r);
    let [height, _, _] = gap.at(s, x);
    let presses = height.simd_le(splat(s, 0.0));
    let touches = open(s, group, wall, lanes, there & low.simd_le(depth));
    let strange = there & (presses | touches);
    leave(group, lanes, strange, [a, b], start);
    let there = there & !strange;
    note(group, wall, lanes, there & height.simd_gt(depth));
    let hits = there & below.simd_lt(-depth);
    if hits.to_bitmask() != 0 {
        let guess = x + (end - x) * height / (height - below);
        group.work.roots.push(hits, lanes, [a, b, x, end, guess, height, start]);
    }
}

/// Kept between l and r.
#[inline(always)]
fn within<S: Simd>(x: V<S>, l: V<S>, r: V<S>) -> V<S> {
    let x = x.simd_lt(l).select(l, x);
    x.simd_gt(r).select(r, x)
}

/// Newton's method for the roots, kept inside their brackets.
#[inline(always)]
fn root<S: Simd>(s: S, group: &mut Group, span: Span, wall: usize, roots: &Queue<7>, at: usize) {
    let there = first(s, roots.len - at);
    let lanes = roots.lanes(s, at);
    let [a, b, start, end, mut x, high, from] = roots.numbers(s, at);
    let gap = gaps(s, group, span, wall, lanes, [a, b]);
    let (mut l, mut r) = (start, end);
    let zero = splat(s, 0.0);
    // From the wall itself it is hit at once.
    let falls = high.simd_gt(zero);
    let mut left = there & falls;
    for _ in 0..ROOT_STEPS {
        if left.to_bitmask() == 0 {
            break;
        }
        let inside = l.simd_lt(x) & x.simd_lt(r);
        let here = inside.select(x, (l + r) * splat(s, 0.5));
        let [z, slope, bend] = gap.at(s, here);
        let above = z.simd_gt(zero);
        l = (left & above).select(here, l);
        r = (left & !above).select(here, r);
        let step = z / slope;
        x = left.select(here - step, x);
        let done = (step * step * bend.abs()).simd_le(splat(s, 1e-17) * slope.abs())
            | (r - l).simd_le(splat(s, 2e-16));
        left &= !done;
    }
    let x = falls.select(within(x, l, r), start);
    let [z, slope, bend] = gap.at(s, x);
    // What rises from behind the wall is pressed first.
    let strange = there & !falls & slope.simd_gt(zero);
    leave(group, lanes, strange, [a, b], from);
    let there = there & !strange;
    let rounding = if group.told { gap.rounding(s) } else { zero };
    if group.kind.walls == [true; 2] && wall == LOWER {
        for bit in bits(there.to_bitmask()) {
            group.work.met[lanes[bit] as usize] = x[bit];
        }
    }
    group.work.hits[wall].push(there, lanes, [a, b, x, z, slope, bend, rounding, from]);
}
