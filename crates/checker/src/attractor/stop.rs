//! A1 of the wall: where Q = ν − 1 + g(t) ≥ 0, and between what −g″ is there.
//!
//! Of g = cos t it is where cos t ≥ 1 − ν, and −g″ = cos t, from 1 − ν to 1. Of several harmonics g is
//! concave on the interval of the line `concave` with its top 1 at 0, so that 1 − g there is at least what it
//! is at the nearer end of the window; elsewhere it is shown piece by piece that 1 − g > ν. For smaller ν
//! less is left of the window, and all of it holds as it stands.

use super::{
    Fault, GoOn, Interval, claim,
    text::{Fraction, Setting, Shown},
};
use crate::{
    motion::exponential::Ring,
    touch::{Interval as Coarse, wall::Wall},
};

/// Shows it.
pub(super) fn holds(setting: &Setting, go_on: GoOn) -> Result<(), Fault> {
    match &setting.shown {
        None => cosine(setting),
        Some(shown) => several(setting, shown, go_on),
    }
}

/// Of g = cos t.
fn cosine(setting: &Setting) -> Result<(), Fault> {
    let depth: Interval = setting.depth.enclosed();
    for end in setting.window {
        let end: Interval = end.enclosed();
        // Up to π the cosine falls, and by ν < 1 the window ends before π/2.
        let far =
            end.is_below(Interval::PI) && depth.is_up_to(Interval::ONE - Ring::<Interval>::CIRCLE.exp(end).a);
        claim(far, "the wall may be beyond the place of rest outside the window (A1)")?;
    }
    let [least, greatest] = setting.bends;
    // α ≤ 1 − ν and 1 ≤ α′, exactly: numbers have at most 15 digits.
    let Fraction { p, q } = setting.depth;
    let scale = |places: u32| 10i128.pow(places);
    let holds =
        least.digits * q <= (q - p) * scale(least.places) && greatest.digits >= scale(greatest.places);
    claim(holds, "the wall may bend otherwise in the window (A1)")
}

/// Of several harmonics.
fn several(setting: &Setting, shown: &Shown, go_on: GoOn) -> Result<(), Fault> {
    let harmonics = setting.harmonics.iter();
    let harmonics =
        harmonics.map(|one| (one.order, one.parts.map(|[lo, hi]| lo.enclosed().hull(hi.enclosed()))));
    let wall = Wall::free(harmonics.collect());
    let depth: Coarse = setting.depth.enclosed();
    let ends = |[before, after]: [super::Decimal; 2]| [-before.enclosed::<48>(), after.enclosed()];
    let ([from, to], [first, last]) = (ends(setting.window), ends(shown.concave));
    let all = last - first;
    claim(first.is_up_to(from) && to.is_up_to(last), "the wall may not be concave in the window (A1)")?;
    claim(all.is_below(Coarse::PI + Coarse::PI), "the window is longer than a period (A1)")?;
    let concave = first.hull(last);
    let rest = last.hull(first + Coarse::PI + Coarse::PI);
    let window = from.hull(to);
    let [least, greatest] = setting.bends.map(|bend| bend.enclosed());
    for piece in 0..shown.pieces {
        go_on()?;
        let of = |whole: Coarse| wall.at(whole.part(piece, shown.pieces));
        claim(of(concave).bend.is_positive(), "the wall may not be concave (A1)")?;
        claim(
            depth.is_below(of(rest).drop),
            "the wall may be beyond the place of rest outside the window (A1)",
        )?;
        let bend = of(window).bend;
        let inside = least.is_up_to(bend) && bend.is_up_to(greatest);
        claim(inside, "the wall may bend otherwise in the window (A1)")?;
    }
    let outside = [from, to].into_iter().all(|end| depth.is_up_to(wall.at(end).drop));
    claim(outside, "the wall may be beyond the place of rest outside the window (A1)")
}
