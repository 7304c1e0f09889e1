//! Whether an orbit is one of fewer periods, its impacts listed several times.

use num_bigint::BigInt;
use num_rational::BigRational;

use super::{ExpectedImpact, Verdict};
use crate::number::{Ball, Elementary, Precision, Real, Sign};

/// That no smaller number of periods is a period of the orbit enclosed by `found` (t_1, …, t_m, V_1, …, V_m,
/// and what else there may be). It is the only solution in the box of `radius` about `centre`.
///
/// If the orbit had d/m of its periods, d a divisor of the m impacts, every impact would come back d impacts
/// later. The same orbit begun d impacts later solves the same equations, where the walls agree. If that
/// solution certainly differs from this one, the orbit does not come back so; if it lies in the box, the two
/// are one, and it does.
pub(super) fn least_period(
    impacts: &[ExpectedImpact],
    found: &[Ball],
    centre: &[BigRational],
    radius: &BigRational,
    precision: &Precision,
) -> Verdict<()> {
    let m = impacts.len();
    let periods =
        |range: std::ops::Range<usize>| -> i64 { range.map(|i| i64::from(impacts[i % m].periods)).sum() };
    let total = periods(0..m);
    let mut open = Verdict::Proved(());
    for d in (1..m).filter(|&d| m.is_multiple_of(d) && (total * d as i64) % m as i64 == 0) {
        if (0..m).any(|i| impacts[i].side != impacts[(i + d) % m].side) {
            continue;
        }
        let shift = total * d as i64 / m as i64;
        let later = |i: usize| {
            let turns = 2 * (periods(i..i + d) - shift);
            let turns = Ball::ratio(&BigRational::from_integer(BigInt::from(turns)), precision);
            [found[(i + d) % m].clone() + &(Ball::pi(precision) * &turns), found[m + (i + d) % m].clone()]
        };
        let apart =
            |a: &Ball, b: &Ball| matches!((a.clone() - b).sign(), Some(Sign::Positive | Sign::Negative));
        let inside = |x: &Ball, y: &BigRational| {
            x.exact_bounds().is_some_and(|(lo, hi)| y - radius < lo && hi < y + radius)
        };
        let pairs = (0..m).map(|i| (i, later(i))).flat_map(|(i, [t, v])| [(i, t), (m + i, v)]);
        let pairs: Vec<(usize, Ball)> = pairs.collect();
        if pairs.iter().any(|(i, x)| apart(x, &found[*i])) {
            continue;
        }
        if pairs.iter().all(|(i, x)| inside(x, &centre[*i])) {
            return Verdict::Refuted(format!(
                "the orbit repeats itself after {d} of its {m} impacts, that is after {shift} of its {total} periods"
            ));
        }
        open = Verdict::Undecided(format!("the orbit may repeat itself after {d} of its {m} impacts"));
    }
    open
}
