//! What a view shows: areas, from the outermost in, each over the ones that it lies in.
//!
//! For eµ > 0 and complex eigenvalues the areas are those of Conjecture 1, nested like the Stern–Brocot tree:
//! a point's word (`grazing_scenes::word`) is the path down to the innermost area that it lies in. So the
//! areas of all n ≤ N, painted in the order of n, colour every point by its word as far as its periods are ≤
//! N; and where the next area down has n > N, it is painted as "more": there, and only there, the word goes
//! on. What is neither an area nor "more" is decided. Areas smaller than a pixel are left out and counted.

use std::{cmp::Reverse, collections::BinaryHeap};

use grazing_scenes::{
    Error, Result,
    existence::{Boundary, Case, MAX_PERIOD, intervals},
    local::{Ladder, Plane, Point, Polar},
    num_rational::BigRational,
    word::{Entropy, Letter, Word},
};
use serde_json::{Value as Json, json};

use super::{
    chart::{Chart, View, float, integer, ratio},
    shape::{Edge, Shape, above, big, in_region4, interval, outside, pixels, real_eigenvalues},
};

/// Areas below this size are left out.
const PIXELS: f64 = 0.7;
/// Entropies are found for words of at most so many letters.
const LETTERS: usize = 40;
/// Bits of an entropy.
const BITS: u32 = 40;

/// What is to be seen.
struct Wanted {
    view: View,
    /// N.
    last: u64,
    positive: bool,
    gamma: bool,
    /// Whether words and entropies are asked for.
    words: bool,
    /// At most so many areas.
    limit: usize,
    ladder: Ladder,
}

/// What is painted, in order.
#[derive(Default)]
struct Painted {
    areas: Vec<Json>,
    finer: u64,
    cut: u64,
    open: u64,
}

/// The answer to a request: see `web/page/plane.ts`, which draws it.
///
/// # Errors
/// An input error for a request that is not understood.
pub fn view(request: &Json) -> Result<Json> {
    let view = View::new(request)?;
    let number = |key: &str, most: u64| match &request[key] {
        Json::Null => Ok(None),
        value => value
            .as_u64()
            .filter(|n| (1..=most).contains(n))
            .map(Some)
            .ok_or_else(|| Error::input(format!("{key}: a whole number from 1 to {most}"))),
    };
    let wanted = Wanted {
        view,
        last: number("max_n", MAX_PERIOD)?.unwrap_or(24),
        positive: request["sign"] != "-",
        gamma: request["gamma"] != "-",
        words: request["words"] == true,
        limit: number("limit", 20_000)?.unwrap_or(400) as usize,
        ladder: Ladder::new(1024),
    };
    let mut painted = Painted::default();
    match (number("only", 10_000)?, wanted.positive) {
        (Some(n), _) => one_period(&wanted, n, &mut painted)?,
        (None, true) => tree(&wanted, &mut painted)?,
        (None, false) => sectors(&wanted, &mut painted)?,
    }
    Ok(json!({
        "origin": { "x": wanted.view.x.to_string(), "y": wanted.view.y.to_string() },
        "areas": painted.areas,
        "finer": painted.finer,
        "cut": painted.cut,
        "open": painted.open,
    }))
}

fn flat(points: &[[f64; 2]]) -> Vec<f64> {
    points.iter().flatten().copied().collect()
}

/// What is said of a shape.
enum Kind<'a> {
    /// Inside, the word is this as far as its periods are ≤ N.
    Word(&'a Word),
    /// Inside, every period occurs: the word of real eigenvalues does not list them.
    Every(&'a Word),
    /// An area whose word was not asked for, or is too long.
    Plain,
    /// Inside, the word goes on beyond N, or beyond the limit on areas.
    More,
}

impl Painted {
    fn add(
        &mut self,
        wanted: &Wanted,
        (n, m): (u64, u64),
        case: Case,
        kind: &Kind,
        shape: &Shape,
    ) -> Result<()> {
        if shape.outline.len() < 3 {
            return Ok(());
        }
        let name = match kind {
            _ if shape.open => "undecided",
            Kind::More => "more",
            _ => "area",
        };
        self.open += u64::from(shape.open);
        let mut area = json!({
            "kind": name,
            "n": n,
            "m": m,
            "case": case.to_string(),
            "shape": flat(&shape.outline),
            "edges": shape.edges.iter().map(|edge| flat(edge)).collect::<Vec<_>>(),
        });
        if let Kind::Every(_) = kind {
            area["every"] = json!(true);
        }
        if let Kind::Word(word) | Kind::Every(word) = kind {
            area["letters"] = json!(word.letters());
            let periods: Vec<u64> = word.vertices().iter().map(|vertex| vertex.period).collect();
            area["periods"] = json!(periods);
            if word.vertices().len() <= LETTERS {
                let (entropy, _) = Entropy::of(word, wanted.gamma, BITS)?;
                area["entropy"] = match entropy.bounds() {
                    Some((low, high)) => json!(float(&((low + high) / integer(2)))),
                    None => json!("none"),
                };
            }
        }
        self.areas.push(area);
        Ok(())
    }
}

/// A word found at one point, for an area that has one word.
fn word_at(wanted: &Wanted, point: &Point) -> Result<Word> {
    Word::at(&wanted.ladder, point, wanted.positive, 100, &())
}

/// A gap of the tree, by its mediant's n: the least n comes first.
type Gap = Reverse<(u64, (u64, u64), (u64, u64), usize)>;

fn gap(left: (u64, u64), right: (u64, u64), depth: usize) -> Gap {
    Reverse((left.1 + right.1, left, right, depth))
}

/// eµ > 0.
fn tree(wanted: &Wanted, painted: &mut Painted) -> Result<()> {
    let view = &wanted.view;
    let (zero, half) = (integer(0), ratio(1, 2));
    // Period 1 alone, D: region 2. Under all areas: region 3 and 4.
    let alone = word_at(wanted, &Point::Plane(Plane::new(ratio(3, 2), ratio(11, 20))?))?;
    if let Some(shape) = above(view, &zero, &half, &Edge::Zero, [false; 2]) {
        painted.add(wanted, (1, 0), Case::PlusMinus, &Kind::Plain, &Shape { edges: Vec::new(), ..shape })?;
    }
    if let Some(shape) = real_eigenvalues(view, 1) {
        painted.add(wanted, (1, 0), Case::PlusMinus, &Kind::Word(&alone), &shape)?;
    }
    if let Some(shape) = real_eigenvalues(view, -1) {
        let two = word_at(wanted, &Point::Plane(Plane::new(integer(-1), ratio(1, 1000))?))?;
        debug_assert!(two.vertices().len() >= 2);
        // 1, 2, and odd periods inside.
        let word = Word::of_area(2, 1, Letter::U, 2).unwrap_or(two);
        painted.add(wanted, (2, 1), Case::PlusPlus, &Kind::Word(&word), &shape)?;
    }
    far(wanted, painted)?;
    let mut queue = BinaryHeap::new();
    side(wanted, (2, 1), true, (0, 1), (1, 1), 1, painted)?;
    queue.push(gap((0, 1), (1, 2), 2));
    let mut visited = 0usize;
    while let Some(Reverse((n, left, right, depth))) = queue.pop() {
        let m = left.0 + right.0;
        let (low, high) = (ratio(left.0, left.1), ratio(right.0, right.1));
        if low >= view.s[1] || high <= view.s[0] {
            continue;
        }
        let (upper, lower) = (interval(n, m, true, left, right), interval(n, m, false, left, right));
        if m > 1 || n > 3 {
            let size = pixels(view, &upper)?.max(pixels(view, &lower)?);
            let width = |a: &BigRational, b: &BigRational| {
                let one = integer(1);
                let (a, b) = (view.place(a, &one), view.place(b, &one));
                ((a[0] - b[0]) / view.pixel[0]).hypot((a[1] - b[1]) / view.pixel[1])
            };
            if m == 1 && width(&low, &high) < 2.0 {
                // Nothing bounds the first area of each n from below: they are narrow, and high.
                more(wanted, (n, m), left, right, painted)?;
                continue;
            }
            if m > 1 && size < PIXELS {
                painted.finer += 1;
                continue;
            }
        }
        visited += 1;
        if n > wanted.last || visited > wanted.limit {
            painted.cut += u64::from(n <= wanted.last);
            more(wanted, (n, m), left, right, painted)?;
            continue;
        }
        let reaches = side(wanted, (n, m), true, left, right, depth, painted)?;
        if reaches || left.0 == 0 {
            queue.push(gap(left, (m, n), depth + 1));
        }
        if side(wanted, (n, m), false, left, right, depth, painted)? {
            queue.push(gap((m, n), right, depth + 1));
        }
    }
    Ok(())
}

/// One area: above m/n, case (+,+), or below it, (+,−); whether it reaches into the view.
fn side(
    wanted: &Wanted,
    (n, m): (u64, u64),
    upper: bool,
    left: (u64, u64),
    right: (u64, u64),
    depth: usize,
    painted: &mut Painted,
) -> Result<bool> {
    let view = &wanted.view;
    let interval = interval(n, m, upper, left, right);
    let boundary = Boundary::new(interval.clone());
    let (a, b) = (big(&interval.left), big(&interval.right));
    let edge = Edge::Area(&boundary);
    let first = m == 1 && upper;
    let letter = if upper { Letter::U } else { Letter::D };
    let words = wanted.words && depth < LETTERS && n <= 4096;
    let mut reaches = false;
    // The word depends on K, the least k with 2ks > 1, where s is not known well enough from m/n.
    let strips = if words && first { n / 2 + 1..=n } else { 0..=0 };
    for k in strips {
        let (from, to, sides) = match k {
            0 => (a.clone(), b.clone(), [first, false]),
            k => {
                let end = if k > 1 { ratio(1, 2 * (k - 1)) } else { b.clone() };
                (ratio(1, 2 * k), end.min(b.clone()), [k == n, false])
            }
        };
        let from = from.max(a.clone());
        let Some(shape) = above(view, &from, &to, &edge, sides) else { continue };
        reaches |= shape.reaches;
        if !shape.reaches && !shape.open {
            continue;
        }
        let s = (&from + &to) / integer(2);
        let first = if k > 0 { k } else { first_above(&s) };
        let word = if words { Word::of_area(n, m, letter, first) } else { None };
        let kind = word.as_ref().map_or(Kind::Plain, Kind::Word);
        painted.add(wanted, (n, m), interval.case, &kind, &shape)?;
        if !upper && right == (1, 2) && view.s[1] == ratio(1, 2) {
            if let Some(shape) = in_region4(view, n, &wanted.ladder) {
                painted.add(wanted, (n, m), interval.case, &kind, &shape)?;
            }
            reaches = true;
        }
    }
    if !upper && right == (1, 2) && !reaches && view.s[1] == ratio(1, 2) && view.chart == Chart::Plane {
        reaches = true;
    }
    Ok(reaches)
}

/// K = ⌊1/(2s)⌋ + 1.
fn first_above(s: &BigRational) -> u64 {
    let floor = (integer(1) / (s * integer(2))).floor().to_integer();
    u64::try_from(floor).unwrap_or(u64::MAX - 1) + 1
}

/// Both areas of a mediant that is not followed: there the word goes on.
fn more(
    wanted: &Wanted,
    (n, m): (u64, u64),
    left: (u64, u64),
    right: (u64, u64),
    painted: &mut Painted,
) -> Result<()> {
    let view = &wanted.view;
    for upper in [true, false] {
        let interval = interval(n, m, upper, left, right);
        let boundary = Boundary::new(interval.clone());
        let edge = Edge::Area(&boundary);
        let (a, b) = (big(&interval.left), big(&interval.right));
        // Left of 1/(2n) the same holds of all later n.
        if upper
            && m == 1
            && let Some(shape) = above(view, &integer(0), &a, &Edge::Zero, [false; 2])
        {
            painted.add(wanted, (n, m), interval.case, &Kind::More, &shape)?;
        }
        if let Some(shape) = above(view, &a, &b, &edge, [false; 2])
            && (shape.reaches || shape.open)
        {
            painted.add(wanted, (n, m), interval.case, &Kind::More, &shape)?;
        }
        if !upper
            && right == (1, 2)
            && view.s[1] == ratio(1, 2)
            && let Some(shape) = in_region4(view, n, &wanted.ladder)
        {
            painted.add(wanted, (n, m), interval.case, &Kind::More, &shape)?;
        }
    }
    Ok(())
}

/// Regions 1 and 5, where every period occurs for eµ > 0, and 1 alone for eµ < 0.
fn far(wanted: &Wanted, painted: &mut Painted) -> Result<()> {
    for (sign, cases) in [(1, [Case::MinusMinus, Case::PlusPlus]), (-1, [Case::MinusPlus, Case::PlusMinus])] {
        if let Some(shape) = outside(&wanted.view, sign) {
            let word = word_at(wanted, &Point::Plane(Plane::new(integer(3 * sign), ratio(1, 2))?))?;
            let kind = if wanted.positive { Kind::Every(&word) } else { Kind::Word(&word) };
            painted.add(wanted, (1, 0), cases[usize::from(wanted.positive)], &kind, &shape)?;
        }
    }
    Ok(())
}

/// eµ < 0: in the sector 1/(2(k + 1)) ≤ s < 1/(2k) the periods 1, …, k, in region 2 all.
fn sectors(wanted: &Wanted, painted: &mut Painted) -> Result<()> {
    let view = &wanted.view;
    let case = Case::MinusPlus;
    if let Some(shape) = real_eigenvalues(view, 1) {
        let word = word_at(wanted, &Point::Plane(Plane::new(ratio(3, 2), ratio(11, 20))?))?;
        painted.add(wanted, (0, 0), case, &Kind::Every(&word), &shape)?;
    }
    if let Some(shape) = real_eigenvalues(view, -1) {
        let word = word_at(wanted, &Point::Plane(Plane::new(integer(-1), ratio(1, 1000))?))?;
        painted.add(wanted, (1, 0), case, &Kind::Word(&word), &shape)?;
    }
    far(wanted, painted)?;
    for k in 1..=wanted.last {
        let from = if k == 1 { ratio(1, 4) } else { ratio(1, 2 * (k + 1)) };
        let to = if k == 1 { ratio(1, 2) } else { ratio(1, 2 * k) };
        if to <= view.s[0] {
            break;
        }
        let one = integer(1);
        let [a, b] = [view.place(&from, &one), view.place(&to, &one)];
        let narrow = ((a[0] - b[0]) / view.pixel[0]).hypot((a[1] - b[1]) / view.pixel[1]) < 2.0;
        if narrow || k == wanted.last || painted.areas.len() >= wanted.limit {
            painted.cut += u64::from(k < wanted.last);
            let end = if k == wanted.last && !narrow { from.clone() } else { to.clone() };
            if let Some(shape) = above(view, &integer(0), &end, &Edge::Zero, [false, true]) {
                painted.add(wanted, (k + 1, 0), case, &Kind::More, &shape)?;
            }
            if end == to {
                break;
            }
        }
        let Some(shape) = above(view, &from, &to, &Edge::Zero, [true, false]) else { continue };
        let word = word_at(wanted, &Point::Polar(Polar::new(ratio(1, 2), (&from + &to) / integer(2))?))?;
        painted.add(wanted, (k, 0), case, &Kind::Word(&word), &shape)?;
    }
    Ok(())
}

/// The areas of one period, all cases.
fn one_period(wanted: &Wanted, n: u64, painted: &mut Painted) -> Result<()> {
    let view = &wanted.view;
    let mut seen = 0usize;
    for interval in intervals(n)? {
        if n == 1 && interval.case == Case::MinusPlus {
            continue;
        }
        let (a, b) = (big(&interval.left), big(&interval.right));
        if a >= view.s[1] || b <= view.s[0] {
            continue;
        }
        seen += 1;
        let boundary = Boundary::new(interval.clone());
        let edge = if interval.deciding.is_none() { Edge::Zero } else { Edge::Area(&boundary) };
        let around_zero = interval.m == 0 && n > 1;
        let first = interval.m == 1 && interval.case == Case::PlusPlus;
        if seen > wanted.limit {
            painted.cut += 1;
        } else if let Some(shape) = above(view, &a, &b, &edge, [first, around_zero])
            && (shape.reaches || shape.open)
        {
            let kind = Kind::Plain;
            painted.add(wanted, (n, interval.m), interval.case, &kind, &shape)?;
        }
    }
    if let Some(shape) = real_eigenvalues(view, 1) {
        let case = if n == 1 { Case::PlusMinus } else { Case::MinusPlus };
        painted.add(wanted, (n, 0), case, &Kind::Plain, &shape)?;
    }
    let region4 = match n {
        1 => real_eigenvalues(view, -1).map(|shape| (Case::PlusMinus, shape)),
        2 => real_eigenvalues(view, -1).map(|shape| (Case::PlusPlus, shape)),
        n if n % 2 == 1 && view.s[1] == ratio(1, 2) => {
            in_region4(view, n, &wanted.ladder).map(|shape| (Case::PlusMinus, shape))
        }
        _ => None,
    };
    if let Some((case, shape)) = region4 {
        painted.add(wanted, (n, n / 2), case, &Kind::Plain, &shape)?;
    }
    for (sign, case) in [(1, Case::PlusPlus), (-1, Case::PlusMinus)] {
        if let Some(shape) = outside(view, sign) {
            painted.add(wanted, (n, 0), case, &Kind::Plain, &shape)?;
        }
    }
    Ok(())
}
