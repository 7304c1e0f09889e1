//! Shapes of areas in a view: their edges are traced from certified points.
//!
//! Every vertex of an edge is the middle of an enclosure of R(s) no wider than a tenth of a pixel. Between
//! two vertices a straight line is drawn; a piece is halved, a limited number of times, as long as the edge's
//! certified middle lies more than a third of a pixel from it. Nothing is said about a curve between two
//! vertices but that.

use grazing_scenes::{
    Result,
    existence::{Boundary, Case, Interval},
    local::{Answer, Ladder, Plane, Point, Quantity},
    num_bigint::BigInt,
    num_rational::{BigRational, Ratio},
    number::Sign,
};

use super::chart::{Chart, View, float, integer, ratio, short};

/// A closed line around what is filled, and the parts of it that bound the area.
#[derive(Debug, Clone, Default)]
pub struct Shape {
    pub outline: Vec<[f64; 2]>,
    pub edges: Vec<Vec<[f64; 2]>>,
    /// Whether an edge point could not be certified: then nothing is said of the whole.
    pub open: bool,
    /// Whether some of it lies below the top of what is seen.
    pub reaches: bool,
}

/// A piece is halved at most that often.
const DEPTH: u32 = 9;
/// The same where a curve begins far outside a narrow view.
const DEEP: u32 = 300;
/// In pixels.
const BEND: f64 = 0.3;

/// Points of a curve from one parameter to another, both included; `None` if a point is not known.
pub fn trace(
    view: &View,
    ends: [&BigRational; 2],
    pieces: u32,
    at: &mut dyn FnMut(&BigRational) -> Option<[f64; 2]>,
) -> Option<Vec<[f64; 2]>> {
    trace_to(view, ends, pieces, DEPTH, at)
}

fn trace_to(
    view: &View,
    [from, to]: [&BigRational; 2],
    pieces: u32,
    depth: u32,
    at: &mut dyn FnMut(&BigRational) -> Option<[f64; 2]>,
) -> Option<Vec<[f64; 2]>> {
    let mut points = vec![at(from)?];
    let step = (to - from) / integer(pieces.into());
    let mut a = from.clone();
    for i in 1..=pieces {
        let b = if i == pieces { to.clone() } else { from + &step * integer(i.into()) };
        let end = at(&b)?;
        let start = *points.last().unwrap_or(&end);
        halve(view, (&a, start), (&b, end), (depth, true), at, &mut points)?;
        points.push(end);
        a = b;
    }
    Some(points)
}

fn halve(
    view: &View,
    (a, start): (&BigRational, [f64; 2]),
    (b, end): (&BigRational, [f64; 2]),
    (depth, whole): (u32, bool),
    at: &mut dyn FnMut(&BigRational) -> Option<[f64; 2]>,
    points: &mut Vec<[f64; 2]>,
) -> Option<()> {
    if depth == 0 || view.beside(start, end) {
        return Some(());
    }
    let t = (a + b) / integer(2);
    let middle = at(&t)?;
    if view.bend(start, middle, end) > BEND {
        halve(view, (a, start), (&t, middle), (depth - 1, false), at, points)?;
        points.push(middle);
        halve(view, (&t, middle), (b, end), (depth - 1, false), at, points)?;
    } else if whole {
        // Paid for already, and nearer to the curve.
        points.push(middle);
    }
    Some(())
}

/// Half the width of an enclosure of r: a twentieth of a pixel.
fn within(view: &View) -> BigRational {
    let size = view.pixel[0].min(view.pixel[1]) / 40.0;
    let exponent = (-size.log2()).ceil().clamp(8.0, 1100.0) as u32;
    BigRational::new(BigInt::from(1), BigInt::from(1) << exponent)
}

/// An interval of Theorem 2 between Farey fractions: above m/n's parents, on one side of it.
pub fn interval(n: u64, m: u64, above: bool, left: (u64, u64), right: (u64, u64)) -> Interval {
    let at = Ratio::new_raw(m, n);
    let fraction = |(m, n): (u64, u64)| Ratio::new_raw(m, n);
    if above {
        let left = if m == 1 { Ratio::new_raw(1, 2 * n) } else { fraction(left) };
        Interval { n, m, case: Case::PlusPlus, left, right: at, deciding: Some(right.1) }
    } else {
        Interval { n, m, case: Case::PlusMinus, left: at, right: fraction(right), deciding: Some(left.1) }
    }
}

/// A fraction of machine integers as one of any size.
pub fn big(x: &Ratio<u64>) -> BigRational {
    ratio(*x.numer(), *x.denom())
}

/// The lower edge of a shape.
pub enum Edge<'a> {
    /// r = 0.
    Zero,
    Area(&'a Boundary),
}

impl Edge<'_> {
    /// R(s) at a point of the closed interval; `None` if it is not certain.
    fn at(&self, s: &BigRational, within: &BigRational) -> Option<BigRational> {
        let Edge::Area(boundary) = self else { return Some(integer(0)) };
        let Interval { left, right, .. } = boundary.interval();
        if self.corner().is_some_and(|corner| *s <= corner) {
            return Some(integer(0));
        }
        if *s <= big(left) || *s >= big(right) {
            return Some(integer(1));
        }
        Some(boundary.near(s, within).ok()??.middle())
    }

    /// The s up to which nothing bounds an area with j = 1 from below: 1/(2(n − 1)).
    fn corner(&self) -> Option<BigRational> {
        let Edge::Area(boundary) = self else { return None };
        let Interval { n, m, case, deciding, .. } = boundary.interval();
        let first = *m == 1 && *case == Case::PlusPlus && *deciding == Some(n - 1);
        first.then(|| ratio(1, 2 * (n - 1)))
    }

    /// Where the edge begins and ends within s from `a` to `b`. Near s = ½ it has a limit that is not
    /// certified here: it ends before that, by less than a pixel in any chart.
    fn span(&self, view: &View, a: &BigRational, b: &BigRational) -> [BigRational; 2] {
        let half = ratio(1, 2);
        let ends_at_half =
            matches!(self, Edge::Area(boundary) if boundary.interval().case == Case::PlusMinus);
        if ends_at_half && *b >= half {
            let bits = view.bits();
            let before = &half - BigRational::new(BigInt::from(1), BigInt::from(1) << bits);
            return [a.clone().min(before.clone()), before];
        }
        [a.clone(), b.clone()]
    }
}

/// The part of region 3 above an edge with s from `a` to `b`, as far as it can be seen; `None` where it
/// cannot. `sides` says which of the two sides bound the area, too.
pub fn above(view: &View, a: &BigRational, b: &BigRational, edge: &Edge, sides: [bool; 2]) -> Option<Shape> {
    let [low, high] = &view.s;
    let (from, to) = (a.max(low), b.min(high));
    if from >= to {
        return None;
    }
    let seen = [sides[0] && from == a, sides[1] && to == b];
    let [from, to] = edge.span(view, from, to);
    // Dyadic, so that what is halved stays short.
    let bits = view.bits() + 20;
    let (from, to) = (
        if from == *a { from } else { short(&from, bits).max(a.clone()) },
        if to == *b { to } else { short(&to, bits).min(b.clone()) },
    );
    let within = within(view);
    let mut shape = Shape::default();
    let mut lowest = integer(1);
    let pieces = if matches!(edge, Edge::Zero) { 1 } else { pieces(view, &from, &to) };
    let mut at = |s: &BigRational| {
        let r = edge.at(s, &within)?;
        if r < lowest {
            lowest = r.clone();
        }
        Some(view.place(s, &r))
    };
    // Where the edge leaves r = 0 it has a corner.
    let curve = match edge.corner().filter(|corner| from < *corner && *corner < to) {
        Some(corner) => trace(view, [&from, &corner], 1, &mut at).and_then(|mut curve| {
            curve.extend(trace(view, [&corner, &to], pieces, &mut at)?);
            Some(curve)
        }),
        None => trace(view, [&from, &to], pieces, &mut at),
    };
    let Some(curve) = curve else {
        // All of the strip is open.
        let all = above(view, a, b, &Edge::Zero, [false; 2])?;
        return Some(Shape { open: true, reaches: true, ..all });
    };
    shape.reaches = &lowest * &lowest <= view.top;
    let ends = [&from, &to].map(|s| edge.at(s, &within).unwrap_or_else(|| integer(0)));
    let left = side(view, &from, &ends[0]);
    let mut right = side(view, &to, &ends[1]);
    right.reverse();
    shape.outline.extend(&left);
    shape.outline.extend(&curve);
    shape.outline.extend(&right);
    if view.chart == Chart::Disc {
        let one = integer(1);
        let arc =
            trace(view, [&to, &from], self::pieces(view, &from, &to), &mut |s| Some(view.place(s, &one)));
        shape.outline.extend(arc.unwrap_or_default());
    }
    if !matches!(edge, Edge::Zero) {
        shape.edges.push(curve);
    }
    for (wanted, line) in seen.into_iter().zip([left, right]) {
        if wanted {
            shape.edges.push(line);
        }
    }
    Some(shape)
}

/// How many pieces an edge begins with: few if it is short.
fn pieces(view: &View, from: &BigRational, to: &BigRational) -> u32 {
    let one = integer(1);
    let [a, b] = [from, to].map(|s| view.place(s, &one));
    let pixels = ((b[0] - a[0]) / view.pixel[0]).hypot((b[1] - a[1]) / view.pixel[1]);
    if pixels < 8.0 {
        4
    } else if pixels < 40.0 {
        6
    } else {
        12
    }
}

/// The line of constant s from r = 1 down to an edge.
fn side(view: &View, s: &BigRational, r: &BigRational) -> Vec<[f64; 2]> {
    let one = integer(1);
    if view.chart != Chart::Plane {
        return vec![view.place(s, &one), view.place(s, r)];
    }
    // A parabola: traced where it may be seen.
    let [low, high] = view.radii();
    let (top, bottom) = (high.max(r.clone()), low.max(r.clone()));
    let mut points = vec![view.place(s, &one)];
    if bottom < top {
        let bits = view.bits() + 20;
        let [top, bottom] = [short(&top, bits), short(&bottom, bits)];
        points.extend(trace(view, [&top, &bottom], 4, &mut |r| Some(view.place(s, r))).unwrap_or_default());
    }
    points.push(view.place(s, r));
    points
}

/// The rows of a₂ that are seen, in the chart of a₁ and a₂: bounds of r.
fn rows(view: &View) -> Option<[BigRational; 2]> {
    let [low, high] = view.radii().map(|r| short(&r, view.bits() + 20));
    (view.chart == Chart::Plane && low < high).then_some([low, high])
}

/// a₁ on the lines between the regions: ±(a₂ + 1), ±2√a₂, for a₂ = r².
fn straight(r: &BigRational, sign: i64) -> BigRational {
    (r * r + integer(1)) * integer(sign)
}

fn parabola(r: &BigRational, sign: i64) -> BigRational {
    r * integer(2 * sign)
}

/// Region 2 (`sign` 1) or 4 (−1), as far as it can be seen.
pub fn real_eigenvalues(view: &View, sign: i64) -> Option<Shape> {
    let [low, high] = rows(view)?;
    let curve = trace(view, [&low, &high], 12, &mut |r| Some(view.plane(&parabola(r, sign), &(r * r))))
        .unwrap_or_default();
    let line: Vec<[f64; 2]> = [&high, &low].map(|r| view.plane(&straight(r, sign), &(r * r))).to_vec();
    let outline = curve.iter().chain(&line).copied().collect();
    Some(Shape { outline, edges: vec![curve, line], open: false, reaches: true })
}

/// Region 1 (`sign` 1) or 5 (−1), as far as it can be seen.
pub fn outside(view: &View, sign: i64) -> Option<Shape> {
    let [low, high] = rows(view)?;
    let width = BigRational::from_float(view.width)?;
    let far = (straight(&high, sign) * integer(sign)).max(&view.x * integer(sign) + &width) + &width;
    let far = far * integer(sign);
    let mut outline: Vec<[f64; 2]> = [&low, &high].map(|r| view.plane(&straight(r, sign), &(r * r))).to_vec();
    outline.extend([&high, &low].map(|r| view.plane(&far, &(r * r))));
    Some(Shape { outline, edges: Vec::new(), open: false, reaches: true })
}

/// The part of region 4 where b_{n,n−2} > 0, n odd.
///
/// With the eigenvalues −µ and −ρµ, 0 < ρ ≤ 1, that is
///
/// ```text
/// µ² (1 + ρ + … + ρ^{n−1}) + µⁿ ρ^{n−2} (1 + ρ) > 1 + ρ + … + ρ^{n−3},
/// ```
///
/// true at µ = 1, and the left side increases with µ: for each ρ there is one edge, and signs on either side
/// of it enclose it.
pub fn in_region4(view: &View, n: u64, ladder: &Ladder) -> Option<Shape> {
    let [low, high] = rows(view)?;
    let (zero, one) = (integer(0), integer(1));
    let place = |rho: &BigRational, mu: &BigRational| view.plane(&(-(mu * (rho + &one))), &(rho * mu * mu));
    let edge = |rho: &BigRational| edge_in_region4(n, rho, &within(view), ladder);
    let curve = trace_to(view, [&zero, &one], 12, DEEP, &mut |rho| Some(place(rho, &edge(rho)?)));
    let (Some(curve), Some(last)) = (curve, edge(&one)) else {
        let all = real_eigenvalues(view, -1)?;
        return Some(Shape { open: true, ..all });
    };
    let parabola = trace_to(view, [&last, &one], 4, DEEP, &mut |mu| Some(place(&one, mu)))?;
    let line = [&one, &high, &low, &zero].map(|r| view.plane(&straight(r, -1), &(r * r)));
    let outline = curve.iter().chain(&parabola).chain(&line).copied().collect();
    Some(Shape { outline, edges: vec![curve], open: false, reaches: true })
}

/// The µ of the edge for one ρ, within `within`; `None` if a sign is not certain.
fn edge_in_region4(n: u64, rho: &BigRational, within: &BigRational, ladder: &Ladder) -> Option<BigRational> {
    let one = integer(1);
    if *rho <= integer(0) {
        return Some(one);
    }
    let positive = |mu: &BigRational| -> Option<bool> {
        if *mu >= one {
            return Some(true);
        }
        let point = Plane::new(-(mu * (rho + &one)), rho * mu * mu).ok()?;
        match ladder.sign(&Point::Plane(point), Quantity::B { n, k: n - 2 }).answer {
            Answer::Sign(sign) => Some(sign == Sign::Positive),
            _ => None,
        }
    };
    // A guess in plain floats, then wider and wider brackets around it, then halving.
    let r = float(rho);
    let sum = |terms: u64| if r < 1.0 { (1.0 - r.powf(terms as f64)) / (1.0 - r) } else { terms as f64 };
    let (all, fewer, tail) = (sum(n), sum(n - 2), r.powf((n - 2) as f64) * (1.0 + r));
    let (mut a, mut b) = (0f64, 1f64);
    for _ in 0..60 {
        let mu = (a + b) / 2.0;
        *(if mu * mu * all + mu.powf(n as f64) * tail > fewer { &mut b } else { &mut a }) = mu;
    }
    let guess = BigRational::from_float(b)?;
    let mut reach = within.clone();
    let (mut lower, mut upper) = loop {
        let (lower, upper) = ((&guess - &reach).max(integer(0)), (&guess + &reach).min(one.clone()));
        if (lower == integer(0) || !positive(&lower)?) && positive(&upper)? {
            break (lower, upper);
        }
        reach *= integer(64);
    };
    while &upper - &lower > within * integer(2) {
        let middle = (&lower + &upper) / integer(2);
        let end = if positive(&middle)? { &mut upper } else { &mut lower };
        *end = middle;
    }
    Some((lower + upper) / integer(2))
}

/// What is needed of a period's area, before it is traced: how large it is, in pixels.
pub fn pixels(view: &View, interval: &Interval) -> Result<f64> {
    let (left, right) = (big(&interval.left), big(&interval.right));
    let middle = (&left + &right) / integer(2);
    let r = Boundary::new(interval.clone())
        .near(&middle, &within(view))?
        .map_or_else(|| integer(0), |r| r.middle());
    let one = integer(1);
    let distance =
        |a: [f64; 2], b: [f64; 2]| ((a[0] - b[0]) / view.pixel[0]).hypot((a[1] - b[1]) / view.pixel[1]);
    let width = distance(view.place(&left, &one), view.place(&right, &one));
    Ok(width.max(distance(view.place(&middle, &one), view.place(&middle, &r))))
}
