//! That the machine is the certificate's oscillator, at its depths: P1 to P4 of the kind's head.

use std::collections::BTreeMap;

use super::{
    super::motion::{
        Interval,
        exponential::{Element, Ring},
        number::{Dual, Number},
        oscillator::Oscillator,
        text::{Side, Wall},
    },
    Certificate, Fraction, Version,
    text::{Begin, Decimal},
};
use crate::{
    rejection::{Fault, GoOn, claim},
    touch::about::About,
};

/// The wall that is looked at, by what the certificate speaks of: of two the lower one, which then are mirror
/// images as seen from the motion without them.
fn side<C: Version>(certificate: &Certificate<C>, mirrored: bool) -> Result<(Side, &Wall<C>), Fault> {
    let system = &certificate.system;
    match (&system.lower, &system.upper) {
        (Some(lower), Some(upper)) if mirrored => {
            let odd = system.forcing.iter().all(|harmonic| harmonic.k % 2 == 1);
            let rests = lower.harmonics.is_empty() && upper.harmonics.is_empty();
            claim(system.force.is_zero() && odd && rests, "the walls are not seen to be mirror images (P1)")?;
            let number = |x: &C| x.bounds().and_then(|[lo, hi]| (lo == hi).then_some(lo));
            let [below, above] =
                [lower, upper].map(|wall| number(&wall.offset).zip(number(&wall.restitution)));
            let opposite = below.zip(above).is_some_and(|((place, law), (other, same))| {
                place.p == -other.p && place.q == other.q && law == same
            });
            claim(opposite, "the walls are not seen to be mirror images (P1)")?;
            Ok((Side::Lower, lower))
        }
        (Some(wall), None) if !mirrored => Ok((Side::Lower, wall)),
        (None, Some(wall)) if !mirrored => Ok((Side::Upper, wall)),
        _ => Err(Fault::False("the walls are not those of the certificate that follows (P1)".into())),
    }
}

/// d as a sum of harmonics: its mean and, by order, the coefficients of cos and sin.
struct Distance<N> {
    mean: N,
    waves: BTreeMap<u64, [N; 2]>,
}

impl<N: Number> Distance<N> {
    fn new<C: Version>(
        certificate: &Certificate<C>,
        oscillator: &Oscillator<N>,
        (side, wall): (Side, &Wall<C>),
    ) -> Distance<N> {
        let (mut mean, terms) = oscillator.free_series(side);
        let orders = certificate.system.forcing.iter().chain(&wall.harmonics).map(|harmonic| harmonic.k);
        let mut waves = BTreeMap::new();
        for (order, [cos, sin]) in orders.zip(terms) {
            if order == 0 {
                mean = mean + cos;
                continue;
            }
            let [a, b] = waves.entry(order).or_insert([N::ZERO; 2]);
            (*a, *b) = (*a + cos, *b + sin);
        }
        Distance { mean, waves }
    }
}

/// How high the wall's top is above its mean: H.
enum Height {
    /// Of one harmonic, of the first order: known by its square.
    One,
    /// pᵐ times this.
    Scaled(Interval, usize),
}

impl Height {
    /// M/H, or its square where that of H is known; nothing is known of it where H may be 0.
    fn ratio<N: Number>(&self, distance: &Distance<N>, parameter: N) -> N {
        match self {
            Height::One => {
                let [a, b] = distance.waves.get(&1).copied().unwrap_or([N::ZERO; 2]);
                distance.mean.squared().over(a.squared() + b.squared())
            }
            Height::Scaled(height, power) => {
                let times = |product: N, _| product * parameter;
                distance.mean.over((0..*power).fold(N::constant(*height), times))
            }
        }
    }

    /// The same at a depth: 1 − σν or its square.
    fn ratio_at(&self, depth: Fraction, behind: bool) -> Interval {
        let depth: Interval = depth.enclosed();
        let ratio = Interval::ONE - if behind { depth } else { -depth };
        if matches!(self, Height::One) { ratio.squared() } else { ratio }
    }
}

/// Whether the first is at most the second; not where that has too many digits.
fn is_up_to(one: Fraction, other: Fraction) -> bool {
    let products = one.p.checked_mul(other.q).zip(other.p.checked_mul(one.q));
    products.is_some_and(|(one, other)| one <= other)
}

/// Whether a number lies in a range: by its exact bounds, if there are such, or by what encloses it.
fn lies(value: Interval, bounds: Option<[Fraction; 2]>, [lo, hi]: [Fraction; 2]) -> bool {
    let exactly = bounds.is_some_and(|[least, greatest]| is_up_to(lo, least) && is_up_to(greatest, hi));
    exactly || lo.enclosed().is_up_to(value) && value.is_up_to(hi.enclosed())
}

/// All that is to be shown, for a certificate that speaks of this.
pub(super) fn run<C: Version>(certificate: &Certificate<C>, about: &About, go_on: GoOn) -> Result<(), Fault> {
    let wall = side(certificate, about.mirrored)?;
    let height = match certificate.top {
        None => one(certificate, wall, about)?,
        Some(top) => several(certificate, wall, about, top.map(|end| end.enclosed()))?,
    };
    let system = &certificate.system;
    let [damping, stiffness, restitution] = about.ranges;
    let at = |parameter: Interval| -> Result<(Dual, bool), Fault> {
        let parameter = Dual { value: parameter, slope: Interval::ONE };
        let oscillator = Oscillator::new(system, parameter).map_err(Fault::False)?;
        let distance = Distance::new(certificate, &oscillator, wall);
        let ratio = height.ratio(&distance, parameter);
        let (side, ring) = (wall.0, &oscillator.ring);
        // H > 0, too, as their quotient is.
        let holds = distance.mean.value.is_positive()
            && ratio.value.is_positive()
            && lies(ring.damping.value, system.damping.bounds(), damping)
            && lies(ring.stiffness.value, system.stiffness.bounds(), stiffness)
            && lies(oscillator.restitution(side).value, wall.1.restitution.bounds(), restitution);
        Ok((ratio, holds))
    };
    let above = certificate.is_above();
    let Some([start, end]) = certificate.ends().map(|ends| ends.map(|end| end.enclosed())) else {
        return Err(unknown());
    };
    // By how much the first is deeper than the second.
    let deeper = |one: Interval, other: Interval| if about.behind { other - one } else { one - other };
    for i in 0..certificate.pieces {
        go_on()?;
        let cut = |i: u64| start + ((end - start) * Interval::integer(i)).divided(certificate.pieces.into());
        // The last piece ends where the range does, whatever rounding makes of the cut.
        let last = if i + 1 == certificate.pieces { end } else { cut(i + 1) };
        let (ratio, holds) = at(cut(i).hull(last))?;
        claim(holds, "c, k or tau may leave the certificate's ranges, or M or H not be positive (P2)")?;
        // nu increases where the ratio decreases beyond the touch, where it increases before it.
        let away = if above == about.behind { -ratio.slope } else { ratio.slope };
        claim(away.is_positive(), "nu is not seen to increase with the distance from the touch (P2)")?;
    }
    if let Begin::Touch(_) = certificate.begin {
        let before = deeper(Interval::ONE, at(start)?.0.value);
        claim(before.is_positive(), "nu is not seen to be below 0 before the touch (P3)")?;
    }
    let inner = deeper(at(certificate.begin.inner(above).enclosed())?.0.value, Interval::ONE);
    claim(inner.is_positive(), "nu is not seen to be above 0 after the touch (P3)")?;
    if let Some(least) = about.least {
        claim(
            matches!(certificate.begin, Begin::From(_)),
            "the certificate is of no depths next to the touch (P3)",
        )?;
        let first = at(certificate.begin.inner(above).enclosed())?.0.value;
        let deep = deeper(first, height.ratio_at(least, about.behind)).is_nonnegative();
        claim(deep, "nu may be less than the certificate's least (P3)")?;
    }
    for depth in &certificate.depths {
        let found =
            deeper(height.ratio_at(depth.depth, about.behind), at(depth.parameter.enclosed())?.0.value);
        claim(found.is_nonnegative(), "nu may be greater than listed (P4)")?;
    }
    let deepest = certificate.depths.last().is_some_and(|last| {
        let (one, other) = (last.depth, about.depth);
        one.p * other.q <= other.p * one.q
    });
    claim(deepest, "the certificate does not go so deep (P4)")
}

/// Whether d′ < 0 at a time where the parameter is 1.
pub(super) fn falls<C: Version>(certificate: &Certificate<C>, time: Decimal) -> Option<bool> {
    let system = &certificate.system;
    let side = if system.lower.is_some() { Side::Lower } else { Side::Upper };
    let oscillator = Oscillator::new(system, Interval::ONE).ok()?;
    let slope = oscillator.free_gap(side, time.enclosed())[1];
    [slope, -slope].iter().position(|x| x.is_positive()).map(|i| i == 1)
}

fn unknown() -> Fault {
    Fault::False("the wall's motion is not known (P1)".into())
}

/// P1 of one harmonic.
fn one<C: Version>(
    certificate: &Certificate<C>,
    (_, wall): (Side, &Wall<C>),
    about: &About,
) -> Result<Height, Fault> {
    let mut orders = certificate.system.forcing.iter().chain(&wall.harmonics).map(|harmonic| harmonic.k);
    claim(orders.all(|order| order <= 1), "the wall has several harmonics, and no top is listed (P1)")?;
    let cosine = match &about.harmonics[..] {
        [only] if only.order == 1 => {
            let [[a, b], [c, d]] = only.parts;
            let [one, zero] = [Fraction { p: 1, q: 1 }, Fraction::ZERO];
            a == one && b == one && c == zero && d == zero
        }
        _ => false,
    };
    claim(cosine, "the certificate is not of one harmonic (P1)")?;
    Ok(Height::One)
}

/// P1 of several harmonics.
fn several<C: Version>(
    certificate: &Certificate<C>,
    (side, wall): (Side, &Wall<C>),
    about: &About,
    [from, to]: [Interval; 2],
) -> Result<Height, Fault> {
    let system = &certificate.system;
    let is_fixed = |x: &C| x.is_zero() || x.power() == Some(0);
    let fixed = is_fixed(&system.damping) && is_fixed(&system.stiffness);
    let harmonics = system.forcing.iter().chain(&wall.harmonics).filter(|harmonic| harmonic.k > 0);
    let parts = harmonics.flat_map(|harmonic| [&harmonic.cos, &harmonic.sin]).filter(|part| !part.is_zero());
    let powers: Option<Vec<usize>> = parts.map(Version::power).collect();
    let power = match powers.as_deref() {
        Some([first, rest @ ..]) if fixed && rest.iter().all(|power| power == first) => *first,
        _ => {
            return Err(Fault::False(
                "the form of the wall's motion may change with the parameter (P1)".into(),
            ));
        }
    };
    // Where the parameter is 1 its power is.
    let oscillator = Oscillator::new(system, Interval::ONE).map_err(Fault::False)?;
    let rises = |t: Interval| oscillator.free_gap(side, t)[1];
    let lowest = (-rises(from)).is_positive() && rises(to).is_positive();
    let top = from.hull(to);
    let convex = oscillator.free_gap(side, top)[2].is_positive();
    claim(lowest && convex, "there is no top of the wall where one is listed (P1)")?;
    let Distance { waves, .. } = Distance::new(certificate, &oscillator, (side, wall));
    let turned: Vec<(u64, [Interval; 2])> = waves
        .iter()
        .map(|(&order, &[a, b])| {
            let Element { a: cos, b: sin } = Ring::CIRCLE.exp(Interval::integer(order) * top);
            (order, [-(a * cos + b * sin), -(b * cos - a * sin)])
        })
        .collect();
    let height = turned.iter().fold(Interval::ZERO, |sum, (_, [a, _])| sum + *a);
    let own = |order: u64| {
        turned.iter().find(|(own, _)| *own == order).map_or([Interval::ZERO; 2], |found| found.1)
    };
    let listed = |order: u64| about.harmonics.iter().find(|harmonic| harmonic.order == order);
    for order in turned.iter().map(|(order, _)| *order).chain(about.harmonics.iter().map(|one| one.order)) {
        let inside = match listed(order) {
            None => own(order) == [Interval::ZERO; 2],
            Some(listed) => {
                let mut both = own(order).into_iter().zip(listed.parts);
                both.all(|(part, range)| lies(part.over(height), None, range))
            }
        };
        claim(inside, format_args!("harmonic {order} may leave the certificate's ranges (P1)"))?;
    }
    Ok(Height::Scaled(height, power))
}
