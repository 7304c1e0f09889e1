//! One point decided exactly: the periods that occur by every b_{n,k} and which may follow which by (64),
//! against the word and its table.
//!
//! The definition takes its signs from the ladder, and p and q from their formulas, in fractions or balls.
//! The word takes the signs of u_n from the ladder and those that decide from `search::apart`: so no sign of
//! a b is shared.

use std::cell::OnceCell;

use num_rational::BigRational;
use num_traits::{One, Zero, pow};

use super::super::weighted;
use crate::{
    existence::{Existence, by_definition},
    local::{Answer, Ladder, Point, Polar, Rung, SignDecision},
    number::{Angle, Ball, Circular, Precision, Real, Sign},
    search::{Instance, apart},
    word::{At, Edge, Extent, Letter, Signs, Word},
};

/// The theorem, or a false statement like it, for tests.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum WordStatement {
    /// The word theorem.
    True,
    /// False: no 1/k is passed over, so that for s < 1/4 period 2 occurs whatever the sign of eµ.
    NothingPassedOver,
    /// False: of two periods that are not neighbours, the earlier one decides.
    EarlierDecides,
    /// False: the last pair of the word has edges both ways.
    LastPairBoth,
}

/// How one point compares.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Comparison {
    Agree,
    Boundary,
    Undecided,
    Differ,
}

/// The signs of the theorem's route, for periods up to a last one: the walk ends where it leaves them.
struct Apart<'a>(At<'a>, u64);

impl Signs for Apart<'_> {
    fn side(&self, n: u64) -> Result<Sign, Rung> {
        // Where s is tiny, the first U is beyond what is compared, and beyond what is soon decided.
        if n > 4 * self.1 { Err(Rung::Interval) } else { self.0.side(n) }
    }

    fn deciding(&self, n: u64, k: u64) -> SignDecision {
        if n > self.1 {
            return SignDecision { answer: Answer::Undecided, rung: Rung::Interval };
        }
        match apart::sign(self.0.ladder, self.0.point, n, k) {
            // An exact zero inside the circle is found by algebra alone.
            Answer::Undecided => self.0.deciding(n, k),
            answer => SignDecision { answer, rung: Rung::Exact },
        }
    }

    fn open(&self, next: u64, rung: Rung) -> Extent {
        self.0.open(next, rung)
    }

    fn on_circle(&self) -> bool {
        self.0.on_circle()
    }

    fn polar(&self) -> Option<&Polar> {
        self.0.polar()
    }
}

/// Compares the two routes at a point for both signs of eµ, over the periods up to `case.n`.
pub(super) fn compare(ladder: &Ladder, case: &Instance, statement: WordStatement) -> Comparison {
    let Instance { n: last, point } = case;
    let mut worst = Comparison::Agree;
    let found: Vec<Existence> = (1..=*last).map(|n| by_definition(ladder, point, n)).collect();
    if found.contains(&Existence::Undecided) {
        return Comparison::Undecided;
    }
    let followers = Followers::new(point, *last);
    for positive in [true, false] {
        let signs = Apart(At { ladder, point }, *last);
        let Ok(word) = Word::by(&signs, point, positive, *last as usize + 2, &()) else {
            return Comparison::Undecided;
        };
        let beyond = matches!(word.extent(), Extent::Undecided { next, .. } if next > *last);
        match word.extent() {
            _ if beyond => {}
            Extent::Line | Extent::Odd => return Comparison::Boundary,
            Extent::Undecided { .. } | Extent::Straddled { .. } => return Comparison::Undecided,
            Extent::Boundary { .. } => worst = Comparison::Boundary,
            Extent::All | Extent::Complete { .. } | Extent::Cut => {}
        }
        let sign = if positive { 1 } else { -1 };
        let defined: Vec<(u64, Letter)> = (1..=*last)
            .zip(&found)
            .filter_map(|(n, existence)| {
                let cases = existence.cases(n);
                let case = cases.iter().find(|case| case.sign_emu() == sign)?;
                // (53): c_n > 0 iff the signs of eµ and γ agree.
                Some((n, if case.sign_emu() == case.sign_gamma() { Letter::U } else { Letter::D }))
            })
            .collect();
        let mut claimed: Vec<(u64, Letter)> =
            word.up_to(*last).iter().map(|vertex| (vertex.period, vertex.letter)).collect();
        if beyond && !positive {
            // u_1, u_2, u_4, … > 0 up to beyond the last period: 2ns < 1 for all of them.
            claimed = (1..=*last).map(|n| (n, Letter::D)).collect();
        }
        claimed.sort_unstable_by_key(|(n, _)| *n);
        if statement == WordStatement::NothingPassedOver
            && positive
            && *last >= 2
            && claimed.len() > 1
            && claimed[1].0 > 2
        {
            claimed.insert(1, (2, Letter::U));
        }
        if defined != claimed {
            return Comparison::Differ;
        }
        for &(i, _) in &defined {
            for &(j, _) in &defined {
                let claim = if positive || !beyond { edge(&word, statement, i, j) } else { Edge::No };
                let agreed = match (claim, followers.sign((ladder, case), i, j)) {
                    (Edge::Yes, Some(sign)) => sign == Sign::Positive,
                    (Edge::No, Some(sign)) => sign == Sign::Negative,
                    // At the limit of the walk nothing is claimed; on a boundary the quantity is zero.
                    (Edge::Open, Some(sign)) => beyond || word.extent() == Extent::Cut || sign == Sign::Zero,
                    (Edge::Open, None) => true,
                    (_, None) => return Comparison::Undecided,
                };
                if !agreed {
                    return Comparison::Differ;
                }
            }
        }
    }
    worst
}

/// The edge that the statement gives, for γ > 0 and eµ > 0.
fn edge(word: &Word, statement: WordStatement, i: u64, j: u64) -> Edge {
    if word.extent() == Extent::All {
        return word.edge(0, 0, true);
    }
    let place = |n| word.vertices().iter().position(|vertex| vertex.period == n);
    let (Some(from), Some(to)) = (place(i), place(j)) else { return Edge::Open };
    let edge = word.edge(from, to, true);
    let (a, b) = (&word.vertices()[from], &word.vertices()[to]);
    if a.letter == b.letter {
        return edge;
    }
    let cross = |x: u64, y: u64| u128::from(x) * u128::from(y);
    let (p, q) = (cross(a.numerator, b.period), cross(b.numerator, a.period));
    let neighbours = p.abs_diff(q) == 1;
    let followed = word.vertices().iter().any(|vertex| vertex.period == a.period + b.period);
    match statement {
        WordStatement::EarlierDecides if !neighbours => match edge {
            Edge::Yes => Edge::No,
            Edge::No => Edge::Yes,
            Edge::Open => Edge::Open,
        },
        WordStatement::LastPairBoth if neighbours && !followed && edge != Edge::Open => Edge::Yes,
        _ => edge,
    }
}

/// The signs of p_j − q_i for periods up to a last one, from p_n = (u_{n+1} − 1)/u_n and q_n = (a₂ⁿ +
/// a₂u_{n−1})/u_n.
enum Followers {
    /// u_0, u_1, … and a₂.
    Exact(Vec<BigRational>, BigRational),
    /// u_n times r sin 2πs, and the powers of a₂, on each precision when it is first needed.
    Balls(Vec<OnceCell<(Vec<Ball>, Vec<Ball>)>>),
}

/// The rungs of the ladder that balls take, 128, 256 and 512 bits.
const RUNGS: usize = 3;

impl Followers {
    fn new(point: &Point, last: u64) -> Followers {
        match point {
            Point::Plane(plane) => {
                let mut u = vec![BigRational::zero(), BigRational::one()];
                for k in 1..=last as usize {
                    let next = plane.a1() * &u[k] - plane.a2() * &u[k - 1];
                    u.push(next);
                }
                Followers::Exact(u, plane.a2().clone())
            }
            Point::Polar(_) => Followers::Balls(vec![OnceCell::new(); RUNGS]),
        }
    }

    /// The sign; `None` if it is not certain.
    fn sign(&self, (ladder, case): (&Ladder, &Instance), i: u64, j: u64) -> Option<Sign> {
        let (i, j) = (i as usize, j as usize);
        match self {
            Followers::Exact(u, a2) => {
                let p = (&u[j + 1] - BigRational::one()) / &u[j];
                let q = (pow(a2.clone(), i) + a2 * &u[i - 1]) / &u[i];
                Some(Sign::of(&(p - q)))
            }
            Followers::Balls(rungs) => rungs.iter().zip(ladder.precisions()).find_map(|(rung, precision)| {
                let Point::Polar(polar) = &case.point else { return None };
                let (y, power) = rung.get_or_init(|| balls(polar, case.n, precision));
                let p = (y[j + 1].clone() - &y[1]) / &y[j];
                let q = (power[i].clone() * &y[1] + &(power[1].clone() * &y[i - 1])) / &y[i];
                (p - &q).sign()
            }),
        }
    }
}

/// Im λⁿ and a₂ⁿ from powers of λ = r e^{2πis}, sine and cosine being those of a rational multiple of π.
fn balls(polar: &Polar, last: u64, precision: &Precision) -> (Vec<Ball>, Vec<Ball>) {
    let angle = Angle::new(&(polar.s() + polar.s()));
    let r = Ball::ratio(polar.r(), precision);
    let square = r.clone() * &r;
    let (a, b) = (r.clone() * &Ball::cos(&angle, precision), r * &Ball::sin(&angle, precision));
    let (mut x, mut y) = (Ball::integer(1, precision), Ball::integer(0, precision));
    let (mut all, mut powers) = (Vec::new(), vec![Ball::integer(1, precision)]);
    for n in 0..=last as usize + 1 {
        all.push(y.clone());
        (x, y) = (x.clone() * &a - &(y.clone() * &b), x * &b + &(y * &a));
        powers.push(powers[n].clone() * &square);
    }
    (all, powers)
}

/// Whether the two routes differ at a point.
pub(super) fn differ(ladder: &Ladder, case: &Instance, statement: WordStatement) -> bool {
    compare(ladder, case, statement) == Comparison::Differ
}

/// A simple case that differs too: the first of the small ones, or else one near this case.
pub(super) fn shrink(ladder: &Ladder, mut case: Instance, statement: WordStatement) -> Instance {
    if let Some(small) = weighted::small_cases().find(|small| differ(ladder, small, statement)) {
        return small;
    }
    let size = |case: &Instance| case.n as usize + case.to_string().len() * 8;
    while let Some(better) = weighted::simpler(&case)
        .into_iter()
        .find(|simpler| size(simpler) < size(&case) && differ(ladder, simpler, statement))
    {
        case = better;
    }
    case
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        local::{Plane, Quantity},
        random::Random,
    };

    fn q(p: i64, d: i64) -> BigRational {
        BigRational::new(p.into(), d.into())
    }

    /// Where quantities are zero the routes agree that they are.
    #[test]
    fn boundaries_are_boundaries() {
        let ladder = Ladder::default();
        for (a1, a2) in [(q(-1, 1), q(1, 2)), (q(1, 1), q(1, 1)), (q(3, 2), q(1, 2))] {
            let case = Instance { n: 12, point: Point::Plane(Plane::new(a1, a2).unwrap()) };
            assert_eq!(compare(&ladder, &case, WordStatement::True), Comparison::Boundary, "{case}");
        }
        let case = Instance { n: 12, point: Point::Polar(Polar::new(q(1, 1), q(3, 10)).unwrap()) };
        assert_eq!(compare(&ladder, &case, WordStatement::True), Comparison::Boundary);
    }

    /// The signs of the followers are those of N_{i+j,i}/(u_i u_j) on the ladder.
    #[test]
    fn followers_agree_with_the_ladder() {
        let (ladder, mut random) = (Ladder::default(), Random::of_unit(8, 0));
        let mut compared = 0;
        for _ in 0..60 {
            let Some(case) = weighted::case(&mut random, &ladder, 3..=12) else { continue };
            let case = Instance { n: 12, ..case };
            let followers = Followers::new(&case.point, 12);
            let u = |n| ladder.u_sign(&case.point, n).answer;
            for (i, j) in (1..=6).flat_map(|i| (1..=6).map(move |j| (i, j))) {
                let (Answer::Sign(a), Answer::Sign(b), Answer::Sign(c)) = (u(i), u(j), u(i + j)) else {
                    continue;
                };
                if [a, b, c].contains(&Sign::Zero) {
                    continue;
                }
                let answer = ladder.sign(&case.point, Quantity::B { n: i + j, k: i }).answer;
                let (Answer::Sign(numerator), Some(sign)) = (answer, followers.sign((&ladder, &case), i, j))
                else {
                    continue;
                };
                assert_eq!(sign, numerator * c * a * b, "{case}: {i} {j}");
                compared += 1;
            }
        }
        assert!(compared > 500, "{compared}");
    }
}
